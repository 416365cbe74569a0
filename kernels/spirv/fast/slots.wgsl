@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn slots(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p99: u32;
  var p98: bool;
  var p42: u32;
  var p54: bool;
  var p390: u32;
  var p175: u32;
  var p190: u32;
  var p191: u32;
  var p205: u32;
  var p209: u32;
  var p245: u32;
  var p246: bool;
  var p261: bool;
  var p243: u32;
  var p188: u32;
  var p227: u32;
  var p228: u32;
  let v295 = global_invocation_id[0u];
  let v296 = global_invocation_id[1u];
  let v301 = r2[0u][1u];
  let v18 = (v296 < v301);
  let v302 = r2[0u][0u];
  let v20 = (v295 << (3u & 31u));
  let v303 = min(v20, v302);
  let v22 = select(v302, v303, v18);
  let v23 = (v302 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v302, v24);
  let v304 = r2[1u][2u];
  let v305 = r2[1u][3u];
  let v31 = (v305 != 0u);
  let v32 = (v22 != v26);
  let v33 = (v304 != 0u);
  let v34 = (v33 & v32);
  if v34 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v35 = (v26 - v22);
    let v36 = (v35 != 8u);
    if v36 {
      let v37 = (v22 < v26);
      if v37 {
        let v38 = (v302 * v296);
        let v314 = r2[0u][3u];
        let v41 = (v314 != 0u);
        if v41 {
          let v53 = (v302 + v38);
          p99 = v22;
          var done0 = false;
          loop {
            if done0 { break; }
            let v99 = p99;
            let v100 = (v99 - v22);
            let v101 = (v99 ^ 4294967295u);
            let v102 = (v53 + v101);
            let v315 = (v102 * 2u);
            let v316 = r3[v315];
            r0[v100] = v316;
            let v109 = (v99 + 1u);
            let v110 = (v109 == v26);
            p99 = v109;
            done0 = v110;
          }
          p98 = false;
        } else {
          p98 = true;
        }
        let v98 = p98;
        if v98 {
          p42 = v22;
          var done1 = false;
          loop {
            if done1 { break; }
            let v42 = p42;
            let v43 = (v42 - v22);
            let v44 = (v42 + v38);
            let v319 = (v44 * 2u);
            let v320 = r3[v319];
            r0[v43] = v320;
            let v51 = (v42 + 1u);
            let v52 = (v51 == v26);
            p42 = v51;
            done1 = v52;
          }
        }
      }
      p54 = false;
    } else {
      p54 = true;
    }
    let v54 = p54;
    if v54 {
      let v323 = r2[0u][3u];
      let v57 = (v323 == 0u);
      let v58 = (v26 + 4294967295u);
      let v324 = select(7u, 0u, v57);
      let v60 = select(v58, v22, v57);
      let v61 = (v302 * v296);
      let v62 = (v60 ^ 4294967295u);
      let v63 = (v302 + v62);
      let v64 = select(v63, v22, v57);
      let v65 = (v64 + v61);
      let v325 = (v65 * 2u);
      let v326 = (v324 * 2u);
      let v327 = (v325 + v326);
      let v328 = r3[v327];
      r0[0u] = v328;
      let v331 = (v324 ^ 1u);
      let v333 = (v331 * 2u);
      let v334 = (v325 + v333);
      let v335 = r3[v334];
      r0[1u] = v335;
      let v338 = (v324 ^ 2u);
      let v340 = (v338 * 2u);
      let v341 = (v325 + v340);
      let v342 = r3[v341];
      r0[2u] = v342;
      let v345 = (v324 ^ 3u);
      let v347 = (v345 * 2u);
      let v348 = (v325 + v347);
      let v349 = r3[v348];
      r0[3u] = v349;
      let v352 = (v324 ^ 4u);
      let v354 = (v352 * 2u);
      let v355 = (v325 + v354);
      let v356 = r3[v355];
      r0[4u] = v356;
      let v359 = (v324 ^ 5u);
      let v361 = (v359 * 2u);
      let v362 = (v325 + v361);
      let v363 = r3[v362];
      r0[5u] = v363;
      let v366 = (v324 ^ 6u);
      let v368 = (v366 * 2u);
      let v369 = (v325 + v368);
      let v370 = r3[v369];
      r0[6u] = v370;
      let v373 = (v324 ^ 7u);
      let v375 = (v373 * 2u);
      let v376 = (v325 + v375);
      let v377 = r3[v376];
      r0[7u] = v377;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v388 = r2[0u][2u];
    let v389 = bitcast<f32>(v388);
    p390 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v390 = p390;
      let v392 = (v390 + 1u);
      let v393 = r0[v390];
      let v394 = bitcast<f32>(v393);
      let v118 = (v394 == bitcast<f32>(bits_7f800000));
      let v119 = (v394 + -1.0f);
      let v120 = (v119 / v394);
      let v121 = (v389 * v120);
      let v122 = select(v121, v389, v118);
      let v123 = (v122 > -1048576.0f);
      let v124 = select(-1048576.0f, v122, v123);
      let v125 = (v124 < 1048576.0f);
      let v126 = select(1048576.0f, v124, v125);
      let v127 = (v126 + 12582912.0f);
      let v128 = bitcast<u32>(v127);
      let v129 = (v128 + 3032481792u);
      let v130 = f32(bitcast<i32>(v129));
      let v131 = (v126 - v130);
      let v132 = (v131 >= 0.5f);
      let v133 = select(0u, 1u, v132);
      let v134 = (v22 + v390);
      let v135 = (v134 + v129);
      let v136 = (v135 + v133);
      let v395 = bitcast<u32>(min(bitcast<i32>(v302), bitcast<i32>(v136)));
      let v396 = bitcast<u32>(max(bitcast<i32>(v395), bitcast<i32>(4294967295u)));
      r1[v390] = v396;
      let v398 = (v392 == 8u);
      p390 = v392;
      done2 = v398;
    }
    let v141 = (v22 != 0u);
    if v141 {
      let v142 = (v22 + 4294967295u);
      let v143 = (v142 < v302);
      if v143 {
        let v144 = (v302 * v296);
        let v399 = r2[0u][3u];
        let v147 = (v399 == 0u);
        let v148 = select(v23, v142, v147);
        let v149 = (v148 + v144);
        let v400 = (v149 * 2u);
        let v401 = r3[v400];
        let v402 = bitcast<f32>(v401);
        let v154 = (v402 == bitcast<f32>(bits_7f800000));
        let v155 = (v402 + -1.0f);
        let v156 = (v155 / v402);
        let v157 = (v389 * v156);
        let v158 = select(v157, v389, v154);
        let v159 = (v158 > -1048576.0f);
        let v160 = select(-1048576.0f, v158, v159);
        let v161 = (v160 < 1048576.0f);
        let v162 = select(1048576.0f, v160, v161);
        let v163 = (v162 + 12582912.0f);
        let v164 = bitcast<u32>(v163);
        let v165 = (v164 + 3032481792u);
        let v166 = f32(bitcast<i32>(v165));
        let v167 = (v162 - v166);
        let v168 = (v167 >= 0.5f);
        let v169 = select(0u, 1u, v168);
        let v170 = (v165 + v142);
        let v171 = (v170 + v169);
        let v403 = bitcast<u32>(min(bitcast<i32>(v302), bitcast<i32>(v171)));
        let v404 = bitcast<u32>(max(bitcast<i32>(v403), bitcast<i32>(4294967295u)));
        p175 = v404;
      } else {
        p175 = v302;
      }
    } else {
      p175 = 4294967295u;
    }
    let v175 = p175;
    let v176 = (v22 < v26);
    if v176 {
      p190 = v175;
      p191 = v22;
      var done3 = false;
      loop {
        if done3 { break; }
        let v190 = p190;
        let v191 = p191;
        let v192 = (v191 - v22);
        let v405 = r1[v192];
        let v197 = (v190 + 1u);
        let v406 = r2[2u][0u];
        let v199 = (v406 != 0u);
        let v200 = (bitcast<i32>(v197) < bitcast<i32>(v405));
        let v201 = (v200 & v199);
        if v201 {
          let v203 = (bitcast<i32>(v405) < bitcast<i32>(v302));
          let v204 = select(0u, 1u, v203);
          p205 = v204;
        } else {
          p205 = 0u;
        }
        let v205 = p205;
        let v206 = (v205 + v405);
        let v207 = (bitcast<i32>(v197) < bitcast<i32>(v206));
        if v207 {
          let v208 = (v191 + 1u);
          p209 = v197;
          var done4 = false;
          loop {
            if done4 { break; }
            let v209 = p209;
            let v211 = (v302 * v296);
            let v409 = r2[0u][3u];
            let v213 = (v409 == 0u);
            let v214 = (v209 ^ 4294967295u);
            let v215 = (v302 + v214);
            let v216 = select(v215, v209, v213);
            let v217 = (v216 + v211);
            let v410 = atomicMax(&r5[v217], v208);
            let v222 = (v209 + 1u);
            let v223 = (v222 == v206);
            p209 = v222;
            done4 = v223;
          }
        }
        let v225 = (v405 >= v302);
        if v225 {
          let v226 = (v191 + 1u);
          p245 = v226;
          p246 = false;
        } else {
          p246 = true;
        }
        let v245 = p245;
        let v246 = p246;
        if v246 {
          let v247 = (v302 * v296);
          let v412 = r2[0u][3u];
          let v249 = (v412 == 0u);
          let v250 = (v405 ^ 4294967295u);
          let v251 = (v302 + v250);
          let v252 = select(v251, v405, v249);
          let v253 = (v252 + v247);
          let v254 = (v253 * v304);
          let v255 = (v191 % v304);
          let v256 = (v254 + v255);
          let v260 = (v191 + 1u);
          if v31 {
            atomicStore(&r4[v256], v260);
            p261 = false;
          } else {
            p261 = true;
          }
          let v261 = p261;
          if v261 {
            let v414 = atomicMax(&r4[v256], v260);
          }
          p243 = v260;
        } else {
          p243 = v245;
        }
        let v243 = p243;
        let v244 = (v243 == v26);
        p190 = v405;
        p191 = v243;
        p188 = v405;
        done3 = v244;
      }
    } else {
      p188 = v175;
    }
    let v188 = p188;
    let v182 = (v26 == v302);
    if v182 {
      let v183 = (v188 + 1u);
      let v184 = (bitcast<i32>(v183) < bitcast<i32>(v26));
      if v184 {
        let v187 = (v26 + 1u);
        p227 = v183;
        p228 = v188;
        var done5 = false;
        loop {
          if done5 { break; }
          let v227 = p227;
          let v228 = p228;
          let v230 = (v302 * v296);
          let v417 = r2[0u][3u];
          let v232 = (v417 == 0u);
          let v233 = (v302 - v228);
          let v234 = (v233 + 4294967294u);
          let v235 = select(v234, v227, v232);
          let v236 = (v235 + v230);
          let v418 = atomicMax(&r5[v236], v187);
          let v241 = (v227 + 1u);
          let v242 = (v241 == v26);
          p227 = v241;
          p228 = v227;
          done5 = v242;
        }
      }
    }
  }
  return;
}
