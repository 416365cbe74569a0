@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r4: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p22: u32;
  var p23: u32;
  var p33: u32;
  var p34: u32;
  var p69: u32;
  var p85: u32;
  var p95: u32;
  var p96: bool;
  var p107: u32;
  var p30: u32;
  var p31: u32;
  var p32: bool;
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
        let v27 = (v128 * v22);
        p33 = 4294967295u;
        p34 = 0u;
        var done1 = false;
        loop {
          if done1 { break; }
          let v33 = p33;
          let v34 = p34;
          let v35 = (v34 < v128);
          if v35 {
            let v129 = r0[0u][3u];
            let v37 = (v129 == 0u);
            let v38 = (v34 ^ 4294967295u);
            let v39 = (v128 + v38);
            let v40 = select(v39, v34, v37);
            let v41 = (v40 + v27);
            let v130 = (v41 * 2u);
            let v131 = r2[v130];
            let v132 = bitcast<f32>(v131);
            let v133 = r0[0u][2u];
            let v134 = bitcast<f32>(v133);
            let v47 = (v132 == bitcast<f32>(bits_7f800000));
            let v48 = (v132 + -1.0f);
            let v49 = (v48 / v132);
            let v50 = (v134 * v49);
            let v51 = select(v50, v134, v47);
            let v52 = (v51 > -1048576.0f);
            let v53 = select(-1048576.0f, v51, v52);
            let v54 = (v53 < 1048576.0f);
            let v55 = select(1048576.0f, v53, v54);
            let v135 = bitcast<u32>(i32(v55));
            let v136 = (v55 > -2147483600.0f);
            let v137 = select(2147483648u, v135, v136);
            let v138 = (v55 >= 2147483600.0f);
            let v139 = select(v137, 2147483647u, v138);
            let v140 = bitcast<u32>(v55);
            let v141 = (v140 & 2147483647u);
            let v142 = (v141 > 2139095040u);
            let v143 = select(v139, 0u, v142);
            let v57 = f32(bitcast<i32>(v143));
            let v58 = (v55 < v57);
            let v59 = select(0u, 4294967295u, v58);
            let v60 = (v143 + v59);
            let v61 = f32(bitcast<i32>(v60));
            let v62 = (v55 - v61);
            let v63 = (v62 >= 0.5f);
            let v64 = select(0u, 1u, v63);
            let v65 = (v60 + v34);
            let v66 = (v65 + v64);
            let v144 = bitcast<u32>(min(bitcast<i32>(v128), bitcast<i32>(v66)));
            let v145 = bitcast<u32>(max(bitcast<i32>(v144), bitcast<i32>(4294967295u)));
            p69 = v145;
          } else {
            p69 = v128;
          }
          let v69 = p69;
          let v70 = (v33 + 1u);
          let v146 = r0[2u][0u];
          let v72 = (v146 != 0u);
          let v73 = (bitcast<i32>(v70) < bitcast<i32>(v69));
          let v74 = (v73 & v72);
          let v75 = (bitcast<i32>(v69) < bitcast<i32>(v128));
          let v76 = (v75 & v74);
          let v77 = select(0u, 1u, v76);
          let v78 = (v69 + v77);
          let v79 = (bitcast<i32>(v70) < bitcast<i32>(v78));
          if v79 {
            let v80 = (v34 + 1u);
            let v147 = r0[0u][3u];
            let v82 = (v147 == 0u);
            p85 = v70;
            var done2 = false;
            loop {
              if done2 { break; }
              let v85 = p85;
              let v86 = (v85 ^ 4294967295u);
              let v87 = (v128 + v86);
              let v88 = select(v87, v85, v82);
              let v89 = (v88 + v27);
              atomicStore(&r4[v89], v80);
              let v93 = (v85 + 1u);
              let v94 = (v93 == v78);
              p85 = v93;
              done2 = v94;
            }
          }
          let v83 = (v69 >= v128);
          if v83 {
            let v84 = (v34 + 1u);
            p95 = v84;
            p96 = false;
          } else {
            p96 = true;
          }
          let v95 = p95;
          let v96 = p96;
          if v96 {
            let v149 = r0[0u][3u];
            let v98 = (v149 == 0u);
            let v99 = (v69 ^ 4294967295u);
            let v100 = (v128 + v99);
            let v101 = select(v100, v69, v98);
            let v102 = (v101 + v27);
            let v106 = (v34 + 1u);
            atomicStore(&r3[v102], v106);
            p107 = v106;
          } else {
            p107 = v95;
          }
          let v107 = p107;
          let v108 = (v107 > v128);
          p33 = v69;
          p34 = v107;
          done1 = v108;
        }
        let v109 = (v22 + 1u);
        let v110 = (v23 + 4294967295u);
        let v111 = (v110 == 0u);
        p30 = v110;
        p31 = v109;
        p32 = v111;
      } else {
        p32 = true;
      }
      let v30 = p30;
      let v31 = p31;
      let v32 = p32;
      p22 = v31;
      p23 = v30;
      done0 = v32;
    }
  }
  return;
}
