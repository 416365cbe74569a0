@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn shift_range(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p36: u32;
  var p37: u32;
  var p38: u32;
  var p54: f32;
  var p55: bool;
  var p102: f32;
  var p101: f32;
  var p126: u32;
  var p127: u32;
  var p162: u32;
  var p163: u32;
  let v143 = global_invocation_id[0u];
  let v148 = r0[0u][1u];
  let v12 = (v143 < v148);
  if v12 {
    let v149 = r0[0u][0u];
    let v14 = (v149 != 0u);
    if v14 {
      let v15 = (v149 * v143);
      let v150 = r0[0u][3u];
      let v18 = (v150 == 0u);
      let v19 = (v18 != true);
      let v151 = r0[0u][2u];
      let v152 = bitcast<f32>(v151);
      let v153 = r0[2u][3u];
      let v24 = (v153 != 0u);
      let v26 = (v153 >> (16u & 31u));
      let v27 = (v26 ^ v153);
      let v28 = (v27 * 2146121005u);
      let v29 = (v28 >> (15u & 31u));
      let v30 = (v29 ^ v28);
      let v31 = (v30 * 2221713035u);
      let v32 = (v31 >> (16u & 31u));
      let v33 = (v32 ^ v31);
      p36 = 0u;
      p37 = 4294967295u;
      p38 = 0u;
      var done0 = false;
      loop {
        if done0 { break; }
        let v36 = p36;
        let v37 = p37;
        let v38 = p38;
        let v39 = (v38 ^ 4294967295u);
        let v40 = (v149 + v39);
        let v41 = select(v40, v38, v18);
        let v42 = (v41 + v15);
        let v154 = (v42 * 2u);
        let v155 = r1[v154];
        let v156 = bitcast<f32>(v155);
        let v47 = (v156 == bitcast<f32>(bits_7f800000));
        let v48 = (v156 + -1.0f);
        let v49 = (v48 / v156);
        let v50 = (v152 * v49);
        let v51 = select(v50, v152, v47);
        if v24 {
          let v157 = r0[3u][0u];
          let v53 = (v157 + v143);
          if v19 {
            let v78 = (v53 ^ v33);
            let v79 = (v78 >> (16u & 31u));
            let v80 = (v79 ^ v78);
            let v81 = (v80 * 2146121005u);
            let v82 = (v81 >> (15u & 31u));
            let v83 = (v82 ^ v81);
            let v84 = (v83 * 2221713035u);
            let v85 = (v84 >> (16u & 31u));
            let v86 = (v40 ^ v85);
            let v87 = (v86 ^ v84);
            let v88 = (v87 >> (16u & 31u));
            let v89 = (v88 ^ v87);
            let v90 = (v89 * 2146121005u);
            let v91 = (v90 >> (15u & 31u));
            let v92 = (v91 ^ v90);
            let v93 = (v92 * 2221713035u);
            let v94 = (v93 >> (16u & 31u));
            let v95 = (v93 & 65535u);
            let v96 = (v95 ^ v94);
            let v97 = f32(v96);
            let v98 = (v97 * 1.5258789e-5f);
            let v99 = (v98 + -0.49999237f);
            let v100 = -(v99);
            p54 = v100;
            p55 = false;
          } else {
            p55 = true;
          }
          let v54 = p54;
          let v55 = p55;
          if v55 {
            let v56 = (v53 ^ v33);
            let v57 = (v56 >> (16u & 31u));
            let v58 = (v57 ^ v56);
            let v59 = (v58 * 2146121005u);
            let v60 = (v59 >> (15u & 31u));
            let v61 = (v60 ^ v59);
            let v62 = (v61 * 2221713035u);
            let v63 = (v62 >> (16u & 31u));
            let v64 = (v38 ^ v63);
            let v65 = (v64 ^ v62);
            let v66 = (v65 >> (16u & 31u));
            let v67 = (v66 ^ v65);
            let v68 = (v67 * 2146121005u);
            let v69 = (v68 >> (15u & 31u));
            let v70 = (v69 ^ v68);
            let v71 = (v70 * 2221713035u);
            let v72 = (v71 >> (16u & 31u));
            let v73 = (v71 & 65535u);
            let v74 = (v73 ^ v72);
            let v75 = f32(v74);
            let v76 = (v75 * 1.5258789e-5f);
            let v77 = (v76 + -0.49999237f);
            p102 = v77;
          } else {
            p102 = v54;
          }
          let v102 = p102;
          let v103 = (v51 + v102);
          p101 = v103;
        } else {
          p101 = v51;
        }
        let v101 = p101;
        let v104 = (v101 > -1048576.0f);
        let v105 = select(-1048576.0f, v101, v104);
        let v106 = (v105 < 1048576.0f);
        let v107 = select(1048576.0f, v105, v106);
        let v108 = (v107 + 12582912.0f);
        let v109 = bitcast<u32>(v108);
        let v110 = (v109 + 3032481792u);
        let v111 = f32(bitcast<i32>(v110));
        let v112 = (v107 - v111);
        let v113 = (v112 >= 0.5f);
        let v114 = select(0u, 1u, v113);
        let v115 = (v110 + v38);
        let v116 = (v115 + v114);
        let v158 = bitcast<u32>(min(bitcast<i32>(v149), bitcast<i32>(v116)));
        let v159 = bitcast<u32>(max(bitcast<i32>(v158), bitcast<i32>(4294967295u)));
        let v119 = (v156 < 0.0f);
        let v120 = select(v159, 4294967294u, v119);
        let v121 = (v120 < v149);
        if v121 {
          let v122 = (v120 - v38);
          let v123 = (bitcast<i32>(v36) <= bitcast<i32>(v37));
          if v123 {
            let v160 = bitcast<u32>(min(bitcast<i32>(v122), bitcast<i32>(v36)));
            let v161 = bitcast<u32>(max(bitcast<i32>(v122), bitcast<i32>(v37)));
            p127 = v160;
            p126 = v161;
          } else {
            p127 = v122;
            p126 = v122;
          }
        } else {
          p126 = v37;
          p127 = v36;
        }
        let v126 = p126;
        let v127 = p127;
        let v128 = (v38 + 1u);
        let v129 = (v128 == v149);
        p36 = v127;
        p37 = v126;
        p38 = v128;
        p163 = v126;
        p162 = v127;
        done0 = v129;
      }
    } else {
      p162 = 0u;
      p163 = 4294967295u;
    }
    let v162 = p162;
    let v163 = p163;
    let v164 = (v143 * 2u);
    r2[v164] = v162;
    let v167 = (v164 + 1u);
    r2[v167] = v163;
  }
  return;
}
