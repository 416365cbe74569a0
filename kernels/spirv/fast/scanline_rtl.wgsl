@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r4: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline_rtl(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p22: u32;
  var p23: u32;
  var p30: u32;
  var p31: u32;
  var p50: u32;
  var p94: u32;
  var p106: u32;
  var p107: u32;
  var p108: bool;
  let v120 = global_invocation_id[0u];
  let v126 = r1.w0;
  let v17 = (v126 != 0u);
  if v17 {
    let v18 = (v126 * v120);
    p22 = v18;
    p23 = v126;
    var done0 = false;
    loop {
      if done0 { break; }
      let v22 = p22;
      let v23 = p23;
      let v127 = r0[0u][1u];
      let v25 = (v22 < v127);
      if v25 {
        let v128 = r0[0u][0u];
        let v27 = (v128 + 1u);
        let v28 = (v27 != 0u);
        if v28 {
          let v29 = (v128 * v22);
          p30 = v128;
          p31 = v27;
          var done1 = false;
          loop {
            if done1 { break; }
            let v30 = p30;
            let v31 = p31;
            let v32 = (v31 + 4294967295u);
            let v33 = (v30 < v128);
            if v33 {
              let v129 = r0[0u][3u];
              let v35 = (v129 == 0u);
              let v36 = (v30 ^ 4294967295u);
              let v37 = (v128 + v36);
              let v38 = select(v37, v30, v35);
              let v39 = (v38 + v29);
              let v130 = atomicLoad(&r3[v39]);
              let v44 = (v130 == 0u);
              if v44 {
                atomicStore(&r3[v39], v31);
              }
            }
            let v45 = (v32 == 0u);
            let v46 = (v45 != true);
            if v46 {
              let v47 = (v31 + 4294967294u);
              let v48 = (v47 < v128);
              if v48 {
                let v132 = r0[0u][3u];
                let v64 = (v132 == 0u);
                let v65 = (v27 - v31);
                let v66 = select(v65, v47, v64);
                let v67 = (v66 + v29);
                let v133 = (v67 * 2u);
                let v134 = r2[v133];
                let v135 = bitcast<f32>(v134);
                let v136 = r0[0u][2u];
                let v137 = bitcast<f32>(v136);
                let v73 = (v135 == bitcast<f32>(bits_7f800000));
                let v74 = (v135 + -1.0f);
                let v75 = (v74 / v135);
                let v76 = (v137 * v75);
                let v77 = select(v76, v137, v73);
                let v78 = (v77 > -1048576.0f);
                let v79 = select(-1048576.0f, v77, v78);
                let v80 = (v79 < 1048576.0f);
                let v81 = select(1048576.0f, v79, v80);
                let v82 = (v81 + 12582912.0f);
                let v83 = bitcast<u32>(v82);
                let v84 = (v83 + 3032481792u);
                let v85 = f32(bitcast<i32>(v84));
                let v86 = (v81 - v85);
                let v87 = (v86 >= 0.5f);
                let v88 = select(0u, 1u, v87);
                let v89 = (v84 + v47);
                let v90 = (v89 + v88);
                let v139 = bitcast<u32>(min(bitcast<i32>(v128), bitcast<i32>(v90)));
                let v140 = bitcast<u32>(max(bitcast<i32>(v139), bitcast<i32>(4294967295u)));
                p50 = v140;
              } else {
                p50 = v128;
              }
            } else {
              p50 = 4294967295u;
            }
            let v50 = p50;
            let v51 = (v50 + 1u);
            let v141 = r0[2u][0u];
            let v53 = (v141 != 0u);
            let v54 = (bitcast<i32>(v51) < bitcast<i32>(v30));
            let v55 = (v53 & v54);
            let v56 = (bitcast<i32>(v30) < bitcast<i32>(v128));
            let v57 = (v56 & v55);
            let v58 = select(0u, 1u, v57);
            let v59 = (v30 + v58);
            let v60 = (bitcast<i32>(v51) < bitcast<i32>(v59));
            if v60 {
              let v142 = r0[0u][3u];
              let v62 = (v142 == 0u);
              p94 = v51;
              var done2 = false;
              loop {
                if done2 { break; }
                let v94 = p94;
                let v95 = (v94 ^ 4294967295u);
                let v96 = (v128 + v95);
                let v97 = select(v96, v94, v62);
                let v98 = (v97 + v29);
                let v143 = atomicLoad(&r4[v98]);
                let v103 = (v143 == 0u);
                if v103 {
                  atomicStore(&r4[v98], v31);
                }
                let v104 = (v94 + 1u);
                let v105 = (v104 == v59);
                p94 = v104;
                done2 = v105;
              }
            }
            p30 = v50;
            p31 = v32;
            done1 = v45;
          }
        }
        let v109 = (v22 + 1u);
        let v110 = (v23 + 4294967295u);
        let v111 = (v110 == 0u);
        p106 = v110;
        p107 = v109;
        p108 = v111;
      } else {
        p108 = true;
      }
      let v106 = p106;
      let v107 = p107;
      let v108 = p108;
      p22 = v107;
      p23 = v106;
      done0 = v108;
    }
  }
  return;
}
