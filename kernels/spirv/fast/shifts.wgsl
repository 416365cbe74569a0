@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p88: u32;
  var p87: bool;
  var p31: u32;
  var p43: bool;
  var p267: u32;
  var p132: u32;
  let v175 = global_invocation_id[0u];
  let v176 = global_invocation_id[1u];
  let v180 = r2[0u][1u];
  let v14 = (v176 < v180);
  let v181 = r2[0u][0u];
  let v16 = (v175 << (3u & 31u));
  let v182 = min(v16, v181);
  let v18 = select(v181, v182, v14);
  let v19 = (v181 - v18);
  let v20 = (v19 < 8u);
  let v21 = (v18 + 8u);
  let v22 = select(v21, v181, v20);
  let v23 = (v18 != v22);
  if v23 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v24 = (v22 - v18);
    let v25 = (v24 != 8u);
    if v25 {
      let v26 = (v18 < v22);
      if v26 {
        let v27 = (v181 * v176);
        let v191 = r2[0u][3u];
        let v30 = (v191 != 0u);
        if v30 {
          let v42 = (v181 + v27);
          p88 = v18;
          var done0 = false;
          loop {
            if done0 { break; }
            let v88 = p88;
            let v89 = (v88 - v18);
            let v90 = (v88 ^ 4294967295u);
            let v91 = (v42 + v90);
            let v192 = (v91 * 2u);
            let v193 = r3[v192];
            r0[v89] = v193;
            let v98 = (v88 + 1u);
            let v99 = (v98 == v22);
            p88 = v98;
            done0 = v99;
          }
          p87 = false;
        } else {
          p87 = true;
        }
        let v87 = p87;
        if v87 {
          p31 = v18;
          var done1 = false;
          loop {
            if done1 { break; }
            let v31 = p31;
            let v32 = (v31 - v18);
            let v33 = (v31 + v27);
            let v196 = (v33 * 2u);
            let v197 = r3[v196];
            r0[v32] = v197;
            let v40 = (v31 + 1u);
            let v41 = (v40 == v22);
            p31 = v40;
            done1 = v41;
          }
        }
      }
      p43 = false;
    } else {
      p43 = true;
    }
    let v43 = p43;
    if v43 {
      let v200 = r2[0u][3u];
      let v46 = (v200 == 0u);
      let v47 = (v22 + 4294967295u);
      let v201 = select(7u, 0u, v46);
      let v49 = select(v47, v18, v46);
      let v50 = (v181 * v176);
      let v51 = (v49 ^ 4294967295u);
      let v52 = (v181 + v51);
      let v53 = select(v52, v18, v46);
      let v54 = (v53 + v50);
      let v202 = (v54 * 2u);
      let v203 = (v201 * 2u);
      let v204 = (v202 + v203);
      let v205 = r3[v204];
      r0[0u] = v205;
      let v208 = (v201 ^ 1u);
      let v210 = (v208 * 2u);
      let v211 = (v202 + v210);
      let v212 = r3[v211];
      r0[1u] = v212;
      let v215 = (v201 ^ 2u);
      let v217 = (v215 * 2u);
      let v218 = (v202 + v217);
      let v219 = r3[v218];
      r0[2u] = v219;
      let v222 = (v201 ^ 3u);
      let v224 = (v222 * 2u);
      let v225 = (v202 + v224);
      let v226 = r3[v225];
      r0[3u] = v226;
      let v229 = (v201 ^ 4u);
      let v231 = (v229 * 2u);
      let v232 = (v202 + v231);
      let v233 = r3[v232];
      r0[4u] = v233;
      let v236 = (v201 ^ 5u);
      let v238 = (v236 * 2u);
      let v239 = (v202 + v238);
      let v240 = r3[v239];
      r0[5u] = v240;
      let v243 = (v201 ^ 6u);
      let v245 = (v243 * 2u);
      let v246 = (v202 + v245);
      let v247 = r3[v246];
      r0[6u] = v247;
      let v250 = (v201 ^ 7u);
      let v252 = (v250 * 2u);
      let v253 = (v202 + v252);
      let v254 = r3[v253];
      r0[7u] = v254;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v265 = r2[0u][2u];
    let v266 = bitcast<f32>(v265);
    p267 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v267 = p267;
      let v269 = (v267 + 1u);
      let v270 = r0[v267];
      let v271 = bitcast<f32>(v270);
      let v107 = (v271 == bitcast<f32>(bits_7f800000));
      let v108 = (v271 + -1.0f);
      let v109 = (v108 / v271);
      let v110 = (v266 * v109);
      let v111 = select(v110, v266, v107);
      let v112 = (v111 > -1048576.0f);
      let v113 = select(-1048576.0f, v111, v112);
      let v114 = (v113 < 1048576.0f);
      let v115 = select(1048576.0f, v113, v114);
      let v116 = (v115 + 12582912.0f);
      let v117 = bitcast<u32>(v116);
      let v118 = (v117 + 3032481792u);
      let v119 = f32(bitcast<i32>(v118));
      let v120 = (v115 - v119);
      let v121 = (v120 >= 0.5f);
      let v122 = select(0u, 1u, v121);
      let v123 = (v18 + v267);
      let v124 = (v123 + v118);
      let v125 = (v124 + v122);
      let v272 = bitcast<u32>(min(bitcast<i32>(v181), bitcast<i32>(v125)));
      let v273 = bitcast<u32>(max(bitcast<i32>(v272), bitcast<i32>(4294967295u)));
      r1[v267] = v273;
      let v275 = (v269 == 8u);
      p267 = v269;
      done2 = v275;
    }
    let v130 = (v18 < v22);
    if v130 {
      p132 = v18;
      var done3 = false;
      loop {
        if done3 { break; }
        let v132 = p132;
        let v134 = (v181 * v176);
        let v277 = r2[0u][3u];
        let v136 = (v277 == 0u);
        let v137 = (v132 ^ 4294967295u);
        let v138 = (v181 + v137);
        let v139 = select(v138, v132, v136);
        let v140 = (v139 + v134);
        let v141 = (v132 - v18);
        let v278 = r1[v141];
        let v146 = (v278 + 1u);
        r4[v140] = v146;
        let v149 = (v132 + 1u);
        let v150 = (v149 == v22);
        p132 = v149;
        done3 = v150;
      }
    }
  }
  return;
}
