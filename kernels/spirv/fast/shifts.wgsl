@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 3>;
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
  var p331: u32;
  var p188: u32;
  let v239 = global_invocation_id[0u];
  let v240 = global_invocation_id[1u];
  let v244 = r2[0u][1u];
  let v14 = (v240 < v244);
  let v245 = r2[0u][0u];
  let v16 = (v239 << (3u & 31u));
  let v246 = min(v16, v245);
  let v18 = select(v245, v246, v14);
  let v19 = (v245 - v18);
  let v20 = (v19 < 8u);
  let v21 = (v18 + 8u);
  let v22 = select(v21, v245, v20);
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
        let v27 = (v245 * v240);
        let v255 = r2[0u][3u];
        let v30 = (v255 != 0u);
        if v30 {
          let v42 = (v245 + v27);
          p88 = v18;
          var done0 = false;
          loop {
            if done0 { break; }
            let v88 = p88;
            let v89 = (v88 - v18);
            let v90 = (v88 ^ 4294967295u);
            let v91 = (v42 + v90);
            let v256 = (v91 * 2u);
            let v257 = r3[v256];
            r0[v89] = v257;
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
            let v260 = (v33 * 2u);
            let v261 = r3[v260];
            r0[v32] = v261;
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
      let v264 = r2[0u][3u];
      let v46 = (v264 == 0u);
      let v47 = (v22 + 4294967295u);
      let v265 = select(7u, 0u, v46);
      let v49 = select(v47, v18, v46);
      let v50 = (v245 * v240);
      let v51 = (v49 ^ 4294967295u);
      let v52 = (v245 + v51);
      let v53 = select(v52, v18, v46);
      let v54 = (v53 + v50);
      let v266 = (v54 * 2u);
      let v267 = (v265 * 2u);
      let v268 = (v266 + v267);
      let v269 = r3[v268];
      r0[0u] = v269;
      let v272 = (v265 ^ 1u);
      let v274 = (v272 * 2u);
      let v275 = (v266 + v274);
      let v276 = r3[v275];
      r0[1u] = v276;
      let v279 = (v265 ^ 2u);
      let v281 = (v279 * 2u);
      let v282 = (v266 + v281);
      let v283 = r3[v282];
      r0[2u] = v283;
      let v286 = (v265 ^ 3u);
      let v288 = (v286 * 2u);
      let v289 = (v266 + v288);
      let v290 = r3[v289];
      r0[3u] = v290;
      let v293 = (v265 ^ 4u);
      let v295 = (v293 * 2u);
      let v296 = (v266 + v295);
      let v297 = r3[v296];
      r0[4u] = v297;
      let v300 = (v265 ^ 5u);
      let v302 = (v300 * 2u);
      let v303 = (v266 + v302);
      let v304 = r3[v303];
      r0[5u] = v304;
      let v307 = (v265 ^ 6u);
      let v309 = (v307 * 2u);
      let v310 = (v266 + v309);
      let v311 = r3[v310];
      r0[6u] = v311;
      let v314 = (v265 ^ 7u);
      let v316 = (v314 * 2u);
      let v317 = (v266 + v316);
      let v318 = r3[v317];
      r0[7u] = v318;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v329 = r2[0u][2u];
    let v330 = bitcast<f32>(v329);
    p331 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v331 = p331;
      let v333 = (v331 + 1u);
      let v334 = r0[v331];
      let v335 = bitcast<f32>(v334);
      let v163 = (v335 == bitcast<f32>(bits_7f800000));
      let v164 = (v335 + -1.0f);
      let v165 = (v164 / v335);
      let v166 = (v330 * v165);
      let v167 = select(v166, v330, v163);
      let v168 = (v167 > -1048576.0f);
      let v169 = select(-1048576.0f, v167, v168);
      let v170 = (v169 < 1048576.0f);
      let v171 = select(1048576.0f, v169, v170);
      let v172 = (v171 + 12582912.0f);
      let v173 = bitcast<u32>(v172);
      let v174 = (v173 + 3032481792u);
      let v175 = f32(bitcast<i32>(v174));
      let v176 = (v171 - v175);
      let v177 = (v176 >= 0.5f);
      let v178 = select(0u, 1u, v177);
      let v179 = (v18 + v331);
      let v180 = (v179 + v174);
      let v181 = (v180 + v178);
      let v336 = bitcast<u32>(min(bitcast<i32>(v245), bitcast<i32>(v181)));
      let v337 = bitcast<u32>(max(bitcast<i32>(v336), bitcast<i32>(4294967295u)));
      r1[v331] = v337;
      let v339 = (v333 == 8u);
      p331 = v333;
      done2 = v339;
    }
    let v340 = r2[2u][3u];
    let v104 = (v340 != 0u);
    if v104 {
      let v341 = r0[0u];
      let v342 = bitcast<f32>(v341);
      let v106 = !(v342 >= 0.0f);
      let v343 = r1[0u];
      let v108 = select(v343, 4294967294u, v106);
      r1[0u] = v108;
      let v345 = r0[1u];
      let v346 = bitcast<f32>(v345);
      let v111 = !(v346 >= 0.0f);
      let v347 = r1[1u];
      let v114 = select(v347, 4294967294u, v111);
      r1[1u] = v114;
      let v349 = r0[2u];
      let v350 = bitcast<f32>(v349);
      let v118 = !(v350 >= 0.0f);
      let v351 = r1[2u];
      let v121 = select(v351, 4294967294u, v118);
      r1[2u] = v121;
      let v353 = r0[3u];
      let v354 = bitcast<f32>(v353);
      let v125 = !(v354 >= 0.0f);
      let v355 = r1[3u];
      let v128 = select(v355, 4294967294u, v125);
      r1[3u] = v128;
      let v357 = r0[4u];
      let v358 = bitcast<f32>(v357);
      let v132 = !(v358 >= 0.0f);
      let v359 = r1[4u];
      let v135 = select(v359, 4294967294u, v132);
      r1[4u] = v135;
      let v361 = r0[5u];
      let v362 = bitcast<f32>(v361);
      let v139 = !(v362 >= 0.0f);
      let v363 = r1[5u];
      let v142 = select(v363, 4294967294u, v139);
      r1[5u] = v142;
      let v365 = r0[6u];
      let v366 = bitcast<f32>(v365);
      let v146 = !(v366 >= 0.0f);
      let v367 = r1[6u];
      let v149 = select(v367, 4294967294u, v146);
      r1[6u] = v149;
      let v369 = r0[7u];
      let v370 = bitcast<f32>(v369);
      let v153 = !(v370 >= 0.0f);
      let v371 = r1[7u];
      let v156 = select(v371, 4294967294u, v153);
      r1[7u] = v156;
    }
    let v186 = (v18 < v22);
    if v186 {
      p188 = v18;
      var done3 = false;
      loop {
        if done3 { break; }
        let v188 = p188;
        let v190 = (v245 * v240);
        let v374 = r2[0u][3u];
        let v192 = (v374 == 0u);
        let v193 = (v188 ^ 4294967295u);
        let v194 = (v245 + v193);
        let v195 = select(v194, v188, v192);
        let v196 = (v195 + v190);
        let v197 = (v188 - v18);
        let v375 = r1[v197];
        let v202 = (v375 + 1u);
        r4[v196] = v202;
        let v205 = (v188 + 1u);
        let v206 = (v205 == v22);
        p188 = v205;
        done3 = v206;
      }
    }
  }
  return;
}
