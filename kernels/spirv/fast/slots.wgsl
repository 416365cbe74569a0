@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn slots(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p41: bool;
  var p482: u32;
  var p239: u32;
  var p248: u32;
  var p249: u32;
  var p304: u32;
  var p305: bool;
  var p320: bool;
  var p277: u32;
  var p286: u32;
  var p289: u32;
  var p246: u32;
  var p261: u32;
  var p262: u32;
  let v372 = global_invocation_id[0u];
  let v373 = global_invocation_id[1u];
  let v378 = r2[0u][1u];
  let v18 = (v373 < v378);
  let v379 = r2[0u][0u];
  let v20 = (v372 << (3u & 31u));
  let v380 = min(v20, v379);
  let v22 = select(v379, v380, v18);
  let v23 = (v379 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v379, v24);
  let v381 = r2[1u][2u];
  let v382 = r2[1u][3u];
  let v31 = (v382 != 0u);
  let v32 = (v22 != v26);
  let v33 = (v381 != 0u);
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
    let v35 = (v26 + 4294967295u);
    let v36 = (v379 * v373);
    let v391 = r2[0u][3u];
    let v39 = (v391 == 0u);
    let v40 = (v39 != true);
    if v40 {
      let v104 = (v379 + v36);
      let v392 = min(v22, v35);
      let v106 = (v392 ^ 4294967295u);
      let v107 = (v104 + v106);
      let v393 = (v107 * 2u);
      let v394 = r3[v393];
      r0[0u] = v394;
      let v113 = (v22 + 1u);
      let v397 = min(v113, v35);
      let v115 = (v397 ^ 4294967295u);
      let v116 = (v104 + v115);
      let v398 = (v116 * 2u);
      let v399 = r3[v398];
      r0[1u] = v399;
      let v122 = (v22 + 2u);
      let v402 = min(v122, v35);
      let v124 = (v402 ^ 4294967295u);
      let v125 = (v104 + v124);
      let v403 = (v125 * 2u);
      let v404 = r3[v403];
      r0[2u] = v404;
      let v131 = (v22 + 3u);
      let v407 = min(v131, v35);
      let v133 = (v407 ^ 4294967295u);
      let v134 = (v104 + v133);
      let v408 = (v134 * 2u);
      let v409 = r3[v408];
      r0[3u] = v409;
      let v140 = (v22 + 4u);
      let v412 = min(v140, v35);
      let v142 = (v412 ^ 4294967295u);
      let v143 = (v104 + v142);
      let v413 = (v143 * 2u);
      let v414 = r3[v413];
      r0[4u] = v414;
      let v149 = (v22 + 5u);
      let v417 = min(v149, v35);
      let v151 = (v417 ^ 4294967295u);
      let v152 = (v104 + v151);
      let v418 = (v152 * 2u);
      let v419 = r3[v418];
      r0[5u] = v419;
      let v158 = (v22 + 6u);
      let v422 = min(v158, v35);
      let v160 = (v422 ^ 4294967295u);
      let v161 = (v104 + v160);
      let v423 = (v161 * 2u);
      let v424 = r3[v423];
      r0[6u] = v424;
      let v167 = (v22 + 7u);
      let v427 = min(v167, v35);
      let v169 = (v427 ^ 4294967295u);
      let v170 = (v104 + v169);
      let v428 = (v170 * 2u);
      let v429 = r3[v428];
      r0[7u] = v429;
      p41 = false;
    } else {
      p41 = true;
    }
    let v41 = p41;
    if v41 {
      let v432 = min(v22, v35);
      let v43 = (v432 + v36);
      let v433 = (v43 * 2u);
      let v434 = r3[v433];
      r0[0u] = v434;
      let v49 = (v22 + 1u);
      let v437 = min(v49, v35);
      let v51 = (v437 + v36);
      let v438 = (v51 * 2u);
      let v439 = r3[v438];
      r0[1u] = v439;
      let v57 = (v22 + 2u);
      let v442 = min(v57, v35);
      let v59 = (v442 + v36);
      let v443 = (v59 * 2u);
      let v444 = r3[v443];
      r0[2u] = v444;
      let v65 = (v22 + 3u);
      let v447 = min(v65, v35);
      let v67 = (v447 + v36);
      let v448 = (v67 * 2u);
      let v449 = r3[v448];
      r0[3u] = v449;
      let v73 = (v22 + 4u);
      let v452 = min(v73, v35);
      let v75 = (v452 + v36);
      let v453 = (v75 * 2u);
      let v454 = r3[v453];
      r0[4u] = v454;
      let v81 = (v22 + 5u);
      let v457 = min(v81, v35);
      let v83 = (v457 + v36);
      let v458 = (v83 * 2u);
      let v459 = r3[v458];
      r0[5u] = v459;
      let v89 = (v22 + 6u);
      let v462 = min(v89, v35);
      let v91 = (v462 + v36);
      let v463 = (v91 * 2u);
      let v464 = r3[v463];
      r0[6u] = v464;
      let v97 = (v22 + 7u);
      let v467 = min(v97, v35);
      let v99 = (v467 + v36);
      let v468 = (v99 * 2u);
      let v469 = r3[v468];
      r0[7u] = v469;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v480 = r2[0u][2u];
    let v481 = bitcast<f32>(v480);
    p482 = 0u;
    var done0 = false;
    loop {
      if done0 { break; }
      let v482 = p482;
      let v484 = (v482 + 1u);
      let v485 = r0[v482];
      let v486 = bitcast<f32>(v485);
      let v182 = (v486 == bitcast<f32>(bits_7f800000));
      let v183 = (v486 + -1.0f);
      let v184 = (v183 / v486);
      let v185 = (v481 * v184);
      let v186 = select(v185, v481, v182);
      let v187 = (v186 > -1048576.0f);
      let v188 = select(-1048576.0f, v186, v187);
      let v189 = (v188 < 1048576.0f);
      let v190 = select(1048576.0f, v188, v189);
      let v487 = bitcast<u32>(i32(v190));
      let v488 = (v190 > -2147483600.0f);
      let v489 = select(2147483648u, v487, v488);
      let v490 = (v190 >= 2147483600.0f);
      let v491 = select(v489, 2147483647u, v490);
      let v492 = bitcast<u32>(v190);
      let v493 = (v492 & 2147483647u);
      let v494 = (v493 > 2139095040u);
      let v495 = select(v491, 0u, v494);
      let v192 = f32(bitcast<i32>(v495));
      let v193 = (v190 < v192);
      let v194 = select(0u, 4294967295u, v193);
      let v195 = (v495 + v194);
      let v196 = f32(bitcast<i32>(v195));
      let v197 = (v190 - v196);
      let v198 = (v197 >= 0.5f);
      let v199 = select(0u, 1u, v198);
      let v200 = (v22 + v482);
      let v201 = (v200 + v195);
      let v202 = (v201 + v199);
      let v496 = bitcast<u32>(min(bitcast<i32>(v379), bitcast<i32>(v202)));
      let v497 = bitcast<u32>(max(bitcast<i32>(v496), bitcast<i32>(4294967295u)));
      r1[v482] = v497;
      let v499 = (v484 == 8u);
      p482 = v484;
      done0 = v499;
    }
    let v207 = (v22 != 0u);
    if v207 {
      let v208 = (v22 + 4294967295u);
      let v209 = (v208 < v379);
      if v209 {
        let v210 = select(v23, v208, v39);
        let v211 = (v210 + v36);
        let v500 = (v211 * 2u);
        let v501 = r3[v500];
        let v502 = bitcast<f32>(v501);
        let v216 = (v502 == bitcast<f32>(bits_7f800000));
        let v217 = (v502 + -1.0f);
        let v218 = (v217 / v502);
        let v219 = (v481 * v218);
        let v220 = select(v219, v481, v216);
        let v221 = (v220 > -1048576.0f);
        let v222 = select(-1048576.0f, v220, v221);
        let v223 = (v222 < 1048576.0f);
        let v224 = select(1048576.0f, v222, v223);
        let v503 = bitcast<u32>(i32(v224));
        let v504 = (v224 > -2147483600.0f);
        let v505 = select(2147483648u, v503, v504);
        let v506 = (v224 >= 2147483600.0f);
        let v507 = select(v505, 2147483647u, v506);
        let v508 = bitcast<u32>(v224);
        let v509 = (v508 & 2147483647u);
        let v510 = (v509 > 2139095040u);
        let v511 = select(v507, 0u, v510);
        let v226 = f32(bitcast<i32>(v511));
        let v227 = (v224 < v226);
        let v228 = select(0u, 4294967295u, v227);
        let v229 = (v511 + v228);
        let v230 = f32(bitcast<i32>(v229));
        let v231 = (v224 - v230);
        let v232 = (v231 >= 0.5f);
        let v233 = select(0u, 1u, v232);
        let v234 = (v229 + v208);
        let v235 = (v234 + v233);
        let v512 = bitcast<u32>(min(bitcast<i32>(v379), bitcast<i32>(v235)));
        let v513 = bitcast<u32>(max(bitcast<i32>(v512), bitcast<i32>(4294967295u)));
        p239 = v513;
      } else {
        p239 = v379;
      }
    } else {
      p239 = 4294967295u;
    }
    let v239 = p239;
    let v240 = (v22 < v26);
    if v240 {
      p248 = v239;
      p249 = v22;
      var done1 = false;
      loop {
        if done1 { break; }
        let v248 = p248;
        let v249 = p249;
        let v250 = (v249 - v22);
        let v514 = r1[v250];
        let v256 = (v514 >= v379);
        if v256 {
          let v257 = (v249 + 1u);
          p304 = v257;
          p305 = false;
        } else {
          p305 = true;
        }
        let v304 = p304;
        let v305 = p305;
        if v305 {
          let v309 = (v514 ^ 4294967295u);
          let v310 = (v379 + v309);
          let v311 = select(v310, v514, v39);
          let v312 = (v311 + v36);
          let v313 = (v312 * v381);
          let v314 = (v249 % v381);
          let v315 = (v313 + v314);
          let v319 = (v249 + 1u);
          if v31 {
            atomicStore(&r4[v315], v319);
            p320 = false;
          } else {
            p320 = true;
          }
          let v320 = p320;
          if v320 {
            let v518 = atomicMax(&r4[v315], v319);
          }
          p277 = v319;
        } else {
          p277 = v304;
        }
        let v277 = p277;
        let v278 = (v248 + 1u);
        let v519 = r2[2u][0u];
        let v280 = (v519 != 0u);
        let v281 = (bitcast<i32>(v278) < bitcast<i32>(v514));
        let v282 = (v281 & v280);
        if v282 {
          let v284 = (bitcast<i32>(v514) < bitcast<i32>(v379));
          let v285 = select(0u, 1u, v284);
          p286 = v285;
        } else {
          p286 = 0u;
        }
        let v286 = p286;
        let v287 = (v286 + v514);
        let v288 = (bitcast<i32>(v278) < bitcast<i32>(v287));
        if v288 {
          p289 = v278;
          var done2 = false;
          loop {
            if done2 { break; }
            let v289 = p289;
            let v294 = (v289 ^ 4294967295u);
            let v295 = (v379 + v294);
            let v296 = select(v295, v289, v39);
            let v297 = (v296 + v36);
            let v523 = atomicMax(&r5[v297], v277);
            let v302 = (v289 + 1u);
            let v303 = (v302 == v287);
            p289 = v302;
            done2 = v303;
          }
        }
        let v243 = (v277 == v26);
        p248 = v514;
        p249 = v277;
        p246 = v514;
        done1 = v243;
      }
    } else {
      p246 = v239;
    }
    let v246 = p246;
    let v245 = (v26 == v379);
    if v245 {
      let v258 = (v26 + 1u);
      let v259 = (v246 + 1u);
      let v260 = (bitcast<i32>(v259) < bitcast<i32>(v26));
      if v260 {
        p261 = v259;
        p262 = v246;
        var done3 = false;
        loop {
          if done3 { break; }
          let v261 = p261;
          let v262 = p262;
          let v267 = (v379 - v262);
          let v268 = (v267 + 4294967294u);
          let v269 = select(v268, v261, v39);
          let v270 = (v269 + v36);
          let v527 = atomicMax(&r5[v270], v258);
          let v275 = (v261 + 1u);
          let v276 = (v275 == v26);
          p261 = v275;
          p262 = v261;
          done3 = v276;
        }
      }
    }
  }
  return;
}
