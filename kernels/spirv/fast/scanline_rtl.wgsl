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
  var p97: u32;
  var p98: bool;
  var p52: u32;
  var p58: bool;
  var p171: u32;
  var p172: bool;
  var p174: u32;
  var p175: u32;
  var p176: f32;
  var p100: u32;
  var p101: bool;
  var p102: u32;
  var p116: u32;
  var p29: u32;
  var p30: u32;
  var p31: bool;
  let v145 = global_invocation_id[0u];
  let v151 = r1.w0;
  let v17 = (v151 != 0u);
  if v17 {
    let v18 = (v151 * v145);
    p23 = v18;
    p24 = v151;
    var done0 = false;
    loop {
      if done0 { break; }
      let v23 = p23;
      let v24 = p24;
      let v152 = r0[0u][1u];
      let v26 = (v23 < v152);
      if v26 {
        let v153 = r0[0u][0u];
        let v28 = (v153 * v23);
        p32 = v153;
        p33 = v153;
        var done1 = false;
        loop {
          if done1 { break; }
          let v32 = p32;
          let v33 = p33;
          let v34 = (v32 < v153);
          if v34 {
            let v154 = r0[0u][3u];
            let v36 = (v154 == 0u);
            let v37 = (v32 ^ 4294967295u);
            let v38 = (v153 + v37);
            let v39 = select(v38, v32, v36);
            let v40 = (v39 + v28);
            let v155 = atomicLoad(&r3[v40]);
            let v45 = (v155 == 0u);
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
              let v51 = (v49 < v153);
              if v51 {
                let v158 = r0[0u][3u];
                let v61 = (v158 == 0u);
                let v62 = (v153 - v47);
                let v63 = select(v62, v49, v61);
                let v64 = (v63 + v28);
                let v159 = (v64 * 2u);
                let v160 = r2[v159];
                let v161 = bitcast<f32>(v160);
                let v162 = r0[2u][3u];
                let v70 = (v162 == 0u);
                let v71 = (v161 >= 0.0f);
                let v72 = (v71 | v70);
                let v73 = (v72 != true);
                p172 = false;
                p176 = v161;
                p97 = 4294967294u;
                p98 = v73;
              } else {
                p172 = true;
                p97 = v153;
                p98 = true;
              }
              let v97 = p97;
              let v98 = p98;
              if v98 {
                let v99 = (v97 != 4294967294u);
                p172 = true;
                p102 = v97;
                p58 = v99;
              } else {
                p102 = 4294967295u;
                p58 = true;
              }
              p52 = v49;
              p174 = v49;
              p175 = v153;
            } else {
              p172 = true;
              p102 = 4294967295u;
              p58 = true;
            }
            let v52 = p52;
            let v58 = p58;
            p47 = v52;
            p171 = v47;
            done2 = v58;
          }
          let v171 = p171;
          let v172 = p172;
          let v174 = p174;
          let v175 = p175;
          let v176 = p176;
          let v136 = (v172 != true);
          if v136 {
            let v163 = r0[0u][2u];
            let v164 = bitcast<f32>(v163);
            let v75 = (v176 == bitcast<f32>(bits_7f800000));
            let v76 = (v176 + -1.0f);
            let v77 = (v76 / v176);
            let v78 = (v77 * v164);
            let v79 = select(v78, v164, v75);
            let v80 = (v79 > -1048576.0f);
            let v81 = select(-1048576.0f, v79, v80);
            let v82 = (v81 < 1048576.0f);
            let v83 = select(1048576.0f, v81, v82);
            let v84 = (v83 + 12582912.0f);
            let v85 = bitcast<u32>(v84);
            let v86 = (v85 + 3032481792u);
            let v87 = f32(bitcast<i32>(v86));
            let v88 = (v83 - v87);
            let v89 = (v88 >= 0.5f);
            let v90 = select(0u, 1u, v89);
            let v91 = (v86 + v174);
            let v92 = (v91 + v90);
            let v165 = bitcast<u32>(min(bitcast<i32>(v175), bitcast<i32>(v92)));
            let v166 = bitcast<u32>(max(bitcast<i32>(v165), bitcast<i32>(4294967295u)));
            p100 = v166;
            p101 = false;
          } else {
            p101 = true;
          }
          let v100 = p100;
          let v101 = p101;
          if !v101 {
            p102 = v100;
          }
          let v102 = p102;
          let v103 = (v102 + 1u);
          let v167 = r0[2u][0u];
          let v105 = (v167 != 0u);
          let v106 = (bitcast<i32>(v103) < bitcast<i32>(v32));
          let v107 = (v105 & v106);
          let v108 = (bitcast<i32>(v32) < bitcast<i32>(v153));
          let v109 = (v108 & v107);
          let v110 = select(0u, 1u, v109);
          let v111 = (v32 + v110);
          let v112 = (bitcast<i32>(v103) < bitcast<i32>(v111));
          if v112 {
            let v113 = (v33 + 1u);
            p116 = v103;
            var done3 = false;
            loop {
              if done3 { break; }
              let v116 = p116;
              let v168 = r0[0u][3u];
              let v118 = (v168 == 0u);
              let v119 = (v116 ^ 4294967295u);
              let v120 = (v153 + v119);
              let v121 = select(v120, v116, v118);
              let v122 = (v121 + v28);
              let v169 = atomicLoad(&r4[v122]);
              let v127 = (v169 == 0u);
              if v127 {
                atomicStore(&r4[v122], v113);
              }
              let v128 = (v116 + 1u);
              let v129 = (v128 == v111);
              p116 = v128;
              done3 = v129;
            }
          }
          let v114 = (v171 == 0u);
          let v115 = (v171 + 4294967295u);
          p32 = v102;
          p33 = v115;
          done1 = v114;
        }
        let v130 = (v23 + 1u);
        let v131 = (v24 + 4294967295u);
        let v132 = (v131 == 0u);
        p29 = v131;
        p30 = v130;
        p31 = v132;
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
