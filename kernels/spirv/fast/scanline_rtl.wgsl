@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r4: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline_rtl(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p23: u32;
  var p24: u32;
  var p32: u32;
  var p33: u32;
  var p47: u32;
  var p93: u32;
  var p94: bool;
  var p52: u32;
  var p58: bool;
  var p165: u32;
  var p166: bool;
  var p168: u32;
  var p169: u32;
  var p170: f32;
  var p96: u32;
  var p97: bool;
  var p98: u32;
  var p112: u32;
  var p29: u32;
  var p30: u32;
  var p31: bool;
  let v140 = global_invocation_id[0u];
  let v146 = r1.w0;
  let v17 = (v146 != 0u);
  if v17 {
    let v18 = (v146 * v140);
    p23 = v18;
    p24 = v146;
    var done0 = false;
    loop {
      if done0 { break; }
      let v23 = p23;
      let v24 = p24;
      let v147 = r0[0u][1u];
      let v26 = (v23 < v147);
      if v26 {
        let v148 = r0[0u][0u];
        let v28 = (v148 * v23);
        p32 = v148;
        p33 = v148;
        var done1 = false;
        loop {
          if done1 { break; }
          let v32 = p32;
          let v33 = p33;
          let v34 = (v32 < v148);
          if v34 {
            let v149 = r0[0u][3u];
            let v36 = (v149 == 0u);
            let v37 = (v32 ^ 4294967295u);
            let v38 = (v148 + v37);
            let v39 = select(v38, v32, v36);
            let v40 = (v39 + v28);
            let v150 = atomicLoad(&r3[v40]);
            let v45 = (v150 == 0u);
            if v45 {
              let v46 = (v33 + 1u);
              atomicStore(&r3[v40], v46);
            }
          }
          p47 = v33;
          var done2 = false;
          loop {
            if done2 { break; }
            let v47 = p47;
            let v48 = (v47 != 0u);
            if v48 {
              let v49 = (v47 + 4294967295u);
              let v51 = (v49 < v148);
              if v51 {
                let v153 = r0[0u][3u];
                let v61 = (v153 == 0u);
                let v62 = (v148 - v47);
                let v63 = select(v62, v49, v61);
                let v64 = (v63 + v28);
                let v154 = (v64 * 2u);
                let v155 = r2[v154];
                let v156 = bitcast<f32>(v155);
                let v69 = (v156 < 0.0f);
                p166 = false;
                p170 = v156;
                p93 = 4294967294u;
                p94 = v69;
              } else {
                p166 = true;
                p93 = v148;
                p94 = true;
              }
              let v93 = p93;
              let v94 = p94;
              if v94 {
                let v95 = (v93 != 4294967294u);
                p166 = true;
                p98 = v93;
                p58 = v95;
              } else {
                p98 = 4294967295u;
                p58 = true;
              }
              p52 = v49;
              p168 = v49;
              p169 = v148;
            } else {
              p166 = true;
              p98 = 4294967295u;
              p58 = true;
            }
            let v52 = p52;
            let v58 = p58;
            p47 = v52;
            p165 = v47;
            done2 = v58;
          }
          let v165 = p165;
          let v166 = p166;
          let v168 = p168;
          let v169 = p169;
          let v170 = p170;
          let v132 = (v166 != true);
          if v132 {
            let v70 = (v170 == bitcast<f32>(bits_7f800000));
            let v157 = r0[0u][2u];
            let v158 = bitcast<f32>(v157);
            let v72 = (v170 + -1.0f);
            let v73 = (v72 / v170);
            let v74 = (v73 * v158);
            let v75 = select(v74, v158, v70);
            let v76 = (v75 > -1048576.0f);
            let v77 = select(-1048576.0f, v75, v76);
            let v78 = (v77 < 1048576.0f);
            let v79 = select(1048576.0f, v77, v78);
            let v80 = (v79 + 12582912.0f);
            let v81 = bitcast<u32>(v80);
            let v82 = (v81 + 3032481792u);
            let v83 = f32(bitcast<i32>(v82));
            let v84 = (v79 - v83);
            let v85 = (v84 >= 0.5f);
            let v86 = select(0u, 1u, v85);
            let v87 = (v82 + v168);
            let v88 = (v87 + v86);
            let v159 = bitcast<u32>(min(bitcast<i32>(v169), bitcast<i32>(v88)));
            let v160 = bitcast<u32>(max(bitcast<i32>(v159), bitcast<i32>(4294967295u)));
            p96 = v160;
            p97 = false;
          } else {
            p97 = true;
          }
          let v96 = p96;
          let v97 = p97;
          if !v97 {
            p98 = v96;
          }
          let v98 = p98;
          let v99 = (v98 + 1u);
          let v161 = r0[2u][0u];
          let v101 = (v161 != 0u);
          let v102 = (bitcast<i32>(v99) < bitcast<i32>(v32));
          let v103 = (v101 & v102);
          let v104 = (bitcast<i32>(v32) < bitcast<i32>(v148));
          let v105 = (v104 & v103);
          let v106 = select(0u, 1u, v105);
          let v107 = (v32 + v106);
          let v108 = (bitcast<i32>(v99) < bitcast<i32>(v107));
          if v108 {
            let v109 = (v33 + 1u);
            p112 = v99;
            var done3 = false;
            loop {
              if done3 { break; }
              let v112 = p112;
              let v162 = r0[0u][3u];
              let v114 = (v162 == 0u);
              let v115 = (v112 ^ 4294967295u);
              let v116 = (v148 + v115);
              let v117 = select(v116, v112, v114);
              let v118 = (v117 + v28);
              let v163 = atomicLoad(&r4[v118]);
              let v123 = (v163 == 0u);
              if v123 {
                atomicStore(&r4[v118], v109);
              }
              let v124 = (v112 + 1u);
              let v125 = (v124 == v107);
              p112 = v124;
              done3 = v125;
            }
          }
          let v110 = (v165 == 0u);
          let v111 = (v165 + 4294967295u);
          p32 = v98;
          p33 = v111;
          done1 = v110;
        }
        let v126 = (v23 + 1u);
        let v127 = (v24 + 4294967295u);
        let v128 = (v127 == 0u);
        p29 = v127;
        p30 = v126;
        p31 = v128;
      } else {
        p31 = true;
      }
      let v29 = p29;
      let v30 = p30;
      let v31 = p31;
      p23 = v30;
      p24 = v29;
      done0 = v31;
    }
  }
  return;
}
