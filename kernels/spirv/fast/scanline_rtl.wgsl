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
  var p96: u32;
  var p108: u32;
  var p109: u32;
  var p110: bool;
  let v122 = global_invocation_id[0u];
  let v128 = r1.w0;
  let v17 = (v128 != 0u);
  if v17 {
    let v18 = (v128 * v122);
    p22 = v18;
    p23 = v128;
    var done0 = false;
    loop {
      if done0 { break; }
      let v22 = p22;
      let v23 = p23;
      let v129 = r0[0u][1u];
      let v25 = (v22 < v129);
      if v25 {
        let v130 = r0[0u][0u];
        let v27 = (v130 + 1u);
        let v28 = (v27 != 0u);
        if v28 {
          let v29 = (v130 * v22);
          p30 = v130;
          p31 = v27;
          var done1 = false;
          loop {
            if done1 { break; }
            let v30 = p30;
            let v31 = p31;
            let v32 = (v31 + 4294967295u);
            let v33 = (v30 < v130);
            if v33 {
              let v131 = r0[0u][3u];
              let v35 = (v131 == 0u);
              let v36 = (v30 ^ 4294967295u);
              let v37 = (v130 + v36);
              let v38 = select(v37, v30, v35);
              let v39 = (v38 + v29);
              let v132 = atomicLoad(&r3[v39]);
              let v44 = (v132 == 0u);
              if v44 {
                atomicStore(&r3[v39], v31);
              }
            }
            let v45 = (v32 == 0u);
            let v46 = (v45 != true);
            if v46 {
              let v47 = (v31 + 4294967294u);
              let v48 = (v47 < v130);
              if v48 {
                let v134 = r0[0u][3u];
                let v64 = (v134 == 0u);
                let v65 = (v27 - v31);
                let v66 = select(v65, v47, v64);
                let v67 = (v66 + v29);
                let v135 = (v67 * 2u);
                let v136 = r2[v135];
                let v137 = bitcast<f32>(v136);
                let v138 = r0[0u][2u];
                let v139 = bitcast<f32>(v138);
                let v73 = (v137 == bitcast<f32>(bits_7f800000));
                let v74 = (v137 + -1.0f);
                let v75 = (v74 / v137);
                let v76 = (v139 * v75);
                let v77 = select(v76, v139, v73);
                let v78 = (v77 > -1048576.0f);
                let v79 = select(-1048576.0f, v77, v78);
                let v80 = (v79 < 1048576.0f);
                let v81 = select(1048576.0f, v79, v80);
                let v140 = bitcast<u32>(i32(v81));
                let v141 = (v81 > -2147483600.0f);
                let v142 = select(2147483648u, v140, v141);
                let v143 = (v81 >= 2147483600.0f);
                let v144 = select(v142, 2147483647u, v143);
                let v145 = bitcast<u32>(v81);
                let v146 = (v145 & 2147483647u);
                let v147 = (v146 > 2139095040u);
                let v148 = select(v144, 0u, v147);
                let v83 = f32(bitcast<i32>(v148));
                let v84 = (v81 < v83);
                let v85 = select(0u, 4294967295u, v84);
                let v86 = (v148 + v85);
                let v87 = f32(bitcast<i32>(v86));
                let v88 = (v81 - v87);
                let v89 = (v88 >= 0.5f);
                let v90 = select(0u, 1u, v89);
                let v91 = (v86 + v47);
                let v92 = (v91 + v90);
                let v150 = bitcast<u32>(min(bitcast<i32>(v130), bitcast<i32>(v92)));
                let v151 = bitcast<u32>(max(bitcast<i32>(v150), bitcast<i32>(4294967295u)));
                p50 = v151;
              } else {
                p50 = v130;
              }
            } else {
              p50 = 4294967295u;
            }
            let v50 = p50;
            let v51 = (v50 + 1u);
            let v152 = r0[2u][0u];
            let v53 = (v152 != 0u);
            let v54 = (bitcast<i32>(v51) < bitcast<i32>(v30));
            let v55 = (v53 & v54);
            let v56 = (bitcast<i32>(v30) < bitcast<i32>(v130));
            let v57 = (v56 & v55);
            let v58 = select(0u, 1u, v57);
            let v59 = (v30 + v58);
            let v60 = (bitcast<i32>(v51) < bitcast<i32>(v59));
            if v60 {
              let v153 = r0[0u][3u];
              let v62 = (v153 == 0u);
              p96 = v51;
              var done2 = false;
              loop {
                if done2 { break; }
                let v96 = p96;
                let v97 = (v96 ^ 4294967295u);
                let v98 = (v130 + v97);
                let v99 = select(v98, v96, v62);
                let v100 = (v99 + v29);
                let v154 = atomicLoad(&r4[v100]);
                let v105 = (v154 == 0u);
                if v105 {
                  atomicStore(&r4[v100], v31);
                }
                let v106 = (v96 + 1u);
                let v107 = (v106 == v59);
                p96 = v106;
                done2 = v107;
              }
            }
            p30 = v50;
            p31 = v32;
            done1 = v45;
          }
        }
        let v111 = (v22 + 1u);
        let v112 = (v23 + 4294967295u);
        let v113 = (v112 == 0u);
        p108 = v112;
        p109 = v111;
        p110 = v113;
      } else {
        p110 = true;
      }
      let v108 = p108;
      let v109 = p109;
      let v110 = p110;
      p22 = v109;
      p23 = v108;
      done0 = v110;
    }
  }
  return;
}
