@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r4: array<u32>;
@group(0) @binding(2) var<storage, read_write> r5: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r6: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn splat(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var r2: array<u32, 8>;
  var p93: u32;
  var p92: bool;
  var p36: u32;
  var p48: bool;
  var p561: u32;
  var p132: f32;
  var p133: bool;
  var p186: f32;
  var p185: f32;
  var p211: u32;
  var p405: u32;
  var p406: bool;
  var p407: bool;
  var p595: bool;
  var p219: bool;
  var p208: u32;
  var p210: bool;
  var p227: bool;
  var p229: bool;
  var p233: u32;
  var p269: f32;
  var p270: bool;
  var p299: f32;
  var p303: u32;
  var p304: bool;
  var p237: u32;
  var p242: bool;
  var p596: bool;
  var p598: u32;
  var p599: f32;
  var p322: u32;
  var p323: bool;
  var p324: u32;
  var p337: u32;
  var p338: u32;
  var p372: u32;
  var p376: u32;
  var p371: u32;
  var p335: u32;
  var p345: u32;
  var p346: u32;
  let v451 = global_invocation_id[0u];
  let v452 = global_invocation_id[1u];
  let v457 = r3[0u][1u];
  let v19 = (v452 < v457);
  let v458 = r3[0u][0u];
  let v21 = (v451 << (3u & 31u));
  let v459 = min(v21, v458);
  let v23 = select(v458, v459, v19);
  let v24 = (v458 - v23);
  let v25 = (v24 < 8u);
  let v26 = (v23 + 8u);
  let v27 = select(v26, v458, v25);
  let v28 = (v23 != v27);
  if v28 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v29 = (v27 - v23);
    let v30 = (v29 != 8u);
    if v30 {
      let v31 = (v23 < v27);
      if v31 {
        let v32 = (v458 * v452);
        let v468 = r3[0u][3u];
        let v35 = (v468 != 0u);
        if v35 {
          let v47 = (v458 + v32);
          p93 = v23;
          var done0 = false;
          loop {
            if done0 { break; }
            let v93 = p93;
            let v94 = (v93 - v23);
            let v95 = (v93 ^ 4294967295u);
            let v96 = (v47 + v95);
            let v469 = (v96 * 2u);
            let v470 = r4[v469];
            r0[v94] = v470;
            let v103 = (v93 + 1u);
            let v104 = (v103 == v27);
            p93 = v103;
            done0 = v104;
          }
          p92 = false;
        } else {
          p92 = true;
        }
        let v92 = p92;
        if v92 {
          p36 = v23;
          var done1 = false;
          loop {
            if done1 { break; }
            let v36 = p36;
            let v37 = (v36 - v23);
            let v38 = (v36 + v32);
            let v473 = (v38 * 2u);
            let v474 = r4[v473];
            r0[v37] = v474;
            let v45 = (v36 + 1u);
            let v46 = (v45 == v27);
            p36 = v45;
            done1 = v46;
          }
        }
      }
      p48 = false;
    } else {
      p48 = true;
    }
    let v48 = p48;
    if v48 {
      let v477 = r3[0u][3u];
      let v51 = (v477 == 0u);
      let v52 = (v27 + 4294967295u);
      let v478 = select(7u, 0u, v51);
      let v54 = select(v52, v23, v51);
      let v55 = (v458 * v452);
      let v56 = (v54 ^ 4294967295u);
      let v57 = (v458 + v56);
      let v58 = select(v57, v23, v51);
      let v59 = (v58 + v55);
      let v479 = (v59 * 2u);
      let v480 = (v478 * 2u);
      let v481 = (v479 + v480);
      let v482 = r4[v481];
      r0[0u] = v482;
      let v485 = (v478 ^ 1u);
      let v487 = (v485 * 2u);
      let v488 = (v479 + v487);
      let v489 = r4[v488];
      r0[1u] = v489;
      let v492 = (v478 ^ 2u);
      let v494 = (v492 * 2u);
      let v495 = (v479 + v494);
      let v496 = r4[v495];
      r0[2u] = v496;
      let v499 = (v478 ^ 3u);
      let v501 = (v499 * 2u);
      let v502 = (v479 + v501);
      let v503 = r4[v502];
      r0[3u] = v503;
      let v506 = (v478 ^ 4u);
      let v508 = (v506 * 2u);
      let v509 = (v479 + v508);
      let v510 = r4[v509];
      r0[4u] = v510;
      let v513 = (v478 ^ 5u);
      let v515 = (v513 * 2u);
      let v516 = (v479 + v515);
      let v517 = r4[v516];
      r0[5u] = v517;
      let v520 = (v478 ^ 6u);
      let v522 = (v520 * 2u);
      let v523 = (v479 + v522);
      let v524 = r4[v523];
      r0[6u] = v524;
      let v527 = (v478 ^ 7u);
      let v529 = (v527 * 2u);
      let v530 = (v479 + v529);
      let v531 = r4[v530];
      r0[7u] = v531;
    }
    let v534 = r0[0u];
    let v535 = r0[1u];
    let v536 = r0[2u];
    let v537 = r0[3u];
    let v538 = r0[4u];
    let v539 = r0[5u];
    let v540 = r0[6u];
    let v541 = r0[7u];
    r1[0u] = v534;
    r1[1u] = v535;
    r1[2u] = v536;
    r1[3u] = v537;
    r1[4u] = v538;
    r1[5u] = v539;
    r1[6u] = v540;
    r1[7u] = v541;
    r2[0u] = 0u;
    r2[1u] = 0u;
    r2[2u] = 0u;
    r2[3u] = 0u;
    r2[4u] = 0u;
    r2[5u] = 0u;
    r2[6u] = 0u;
    r2[7u] = 0u;
    let v558 = r3[0u][2u];
    let v559 = bitcast<f32>(v558);
    let v560 = r3[2u][3u];
    let v109 = (v560 != 0u);
    let v112 = (v560 >> (16u & 31u));
    let v113 = (v112 ^ v560);
    let v114 = (v113 * 2146121005u);
    let v115 = (v114 >> (15u & 31u));
    let v116 = (v115 ^ v114);
    let v117 = (v116 * 2221713035u);
    let v118 = (v117 >> (16u & 31u));
    p561 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v561 = p561;
      let v563 = (v561 + 1u);
      let v564 = r1[v561];
      let v565 = bitcast<f32>(v564);
      let v124 = (v23 + v561);
      let v125 = (v565 == bitcast<f32>(bits_7f800000));
      let v126 = (v565 + -1.0f);
      let v127 = (v126 / v565);
      let v128 = (v559 * v127);
      let v129 = select(v128, v559, v125);
      if v109 {
        let v566 = r3[0u][3u];
        let v131 = (v566 != 0u);
        if v131 {
          let v158 = (v124 ^ 4294967295u);
          let v159 = (v458 + v158);
          let v567 = r3[3u][0u];
          let v161 = (v567 + v452);
          let v162 = (v161 >> (16u & 31u));
          let v163 = (v161 ^ v162);
          let v164 = (v163 ^ v117);
          let v165 = (v164 * 2146121005u);
          let v166 = (v165 >> (15u & 31u));
          let v167 = (v166 ^ v165);
          let v168 = (v167 * 2221713035u);
          let v169 = (v168 >> (16u & 31u));
          let v170 = (v159 ^ v169);
          let v171 = (v170 ^ v168);
          let v172 = (v171 >> (16u & 31u));
          let v173 = (v172 ^ v171);
          let v174 = (v173 * 2146121005u);
          let v175 = (v174 >> (15u & 31u));
          let v176 = (v175 ^ v174);
          let v177 = (v176 * 2221713035u);
          let v178 = (v177 >> (16u & 31u));
          let v179 = (v177 & 65535u);
          let v180 = (v179 ^ v178);
          let v181 = f32(v180);
          let v182 = (v181 * 1.5258789e-5f);
          let v183 = (v182 + -0.49999237f);
          let v184 = -(v183);
          p132 = v184;
          p133 = false;
        } else {
          p133 = true;
        }
        let v132 = p132;
        let v133 = p133;
        if v133 {
          let v568 = r3[3u][0u];
          let v135 = (v568 + v452);
          let v136 = (v135 >> (16u & 31u));
          let v137 = (v135 ^ v136);
          let v138 = (v137 ^ v117);
          let v139 = (v138 * 2146121005u);
          let v140 = (v139 >> (15u & 31u));
          let v141 = (v140 ^ v139);
          let v142 = (v141 * 2221713035u);
          let v143 = (v142 >> (16u & 31u));
          let v144 = (v124 ^ v143);
          let v145 = (v144 ^ v142);
          let v146 = (v145 >> (16u & 31u));
          let v147 = (v146 ^ v145);
          let v148 = (v147 * 2146121005u);
          let v149 = (v148 >> (15u & 31u));
          let v150 = (v149 ^ v148);
          let v151 = (v150 * 2221713035u);
          let v152 = (v151 >> (16u & 31u));
          let v153 = (v151 & 65535u);
          let v154 = (v153 ^ v152);
          let v155 = f32(v154);
          let v156 = (v155 * 1.5258789e-5f);
          let v157 = (v156 + -0.49999237f);
          p186 = v157;
        } else {
          p186 = v132;
        }
        let v186 = p186;
        let v187 = (v129 + v186);
        p185 = v187;
      } else {
        p185 = v129;
      }
      let v185 = p185;
      let v188 = (v185 > -1048576.0f);
      let v189 = select(-1048576.0f, v185, v188);
      let v190 = (v189 < 1048576.0f);
      let v191 = select(1048576.0f, v189, v190);
      let v192 = (v191 + 12582912.0f);
      let v193 = bitcast<u32>(v192);
      let v194 = (v193 + 3032481792u);
      let v195 = f32(bitcast<i32>(v194));
      let v196 = (v191 - v195);
      let v197 = (v196 >= 0.5f);
      let v198 = select(0u, 1u, v197);
      let v199 = (v194 + v124);
      let v200 = (v199 + v198);
      let v569 = bitcast<u32>(min(bitcast<i32>(v458), bitcast<i32>(v200)));
      let v570 = bitcast<u32>(max(bitcast<i32>(v569), bitcast<i32>(4294967295u)));
      let v203 = (v565 < 0.0f);
      let v204 = select(v570, 4294967294u, v203);
      r2[v561] = v204;
      let v572 = (v563 == 8u);
      p561 = v563;
      done2 = v572;
    }
    let v207 = (v23 < v27);
    if v207 {
      p211 = v23;
      var done3 = false;
      loop {
        if done3 { break; }
        let v211 = p211;
        let v212 = (v211 - v23);
        let v573 = r2[v212];
        let v217 = (v573 == 4294967294u);
        if v217 {
          let v224 = (v211 + 1u);
          let v225 = (v224 == v27);
          p405 = v224;
          p406 = false;
          p407 = v225;
        } else {
          p406 = true;
          p407 = true;
        }
        let v405 = p405;
        let v406 = p406;
        let v407 = p407;
        let v408 = (v406 != true);
        p211 = v405;
        p208 = v211;
        p595 = v408;
        done3 = v407;
      }
      let v595 = p595;
      if v595 {
        p227 = true;
        p219 = false;
      } else {
        p227 = false;
        p219 = true;
      }
      let v219 = p219;
      if v219 {
        p210 = true;
      } else {
        p208 = v27;
        p210 = false;
      }
    } else {
      p208 = v23;
      p227 = false;
      p210 = true;
    }
    let v208 = p208;
    let v210 = p210;
    if v210 {
      let v222 = (v208 == v27);
      let v223 = (v222 != true);
      p229 = v223;
      p227 = v222;
    } else {
      p229 = false;
    }
    let v227 = p227;
    if v227 {
      let v228 = (v27 >= v458);
      p229 = v228;
    }
    let v229 = p229;
    if v229 {
      let v231 = (v458 * v452);
      let v232 = (v118 ^ v117);
      p233 = v23;
      var done4 = false;
      loop {
        if done4 { break; }
        let v233 = p233;
        let v234 = (v233 != 0u);
        if v234 {
          let v235 = (v233 + 4294967295u);
          let v236 = (v235 < v458);
          if v236 {
            let v574 = r3[0u][3u];
            let v244 = (v574 == 0u);
            let v245 = (v244 != true);
            let v246 = (v458 - v233);
            let v247 = select(v246, v235, v244);
            let v248 = (v247 + v231);
            let v575 = (v248 * 2u);
            let v576 = r4[v575];
            let v577 = bitcast<f32>(v576);
            let v253 = (v577 == bitcast<f32>(bits_7f800000));
            let v254 = (v577 + -1.0f);
            let v255 = (v254 / v577);
            let v256 = (v559 * v255);
            let v257 = select(v256, v559, v253);
            if v109 {
              let v578 = r3[3u][0u];
              let v259 = (v578 + v452);
              let v260 = (v259 ^ v232);
              let v261 = (v260 >> (16u & 31u));
              let v262 = (v261 ^ v260);
              let v263 = (v262 * 2146121005u);
              let v264 = (v263 >> (15u & 31u));
              let v265 = (v264 ^ v263);
              let v266 = (v265 * 2221713035u);
              let v267 = (v266 >> (16u & 31u));
              let v268 = (v267 ^ v266);
              if v245 {
                let v284 = (v268 ^ v246);
                let v285 = (v284 >> (16u & 31u));
                let v286 = (v285 ^ v284);
                let v287 = (v286 * 2146121005u);
                let v288 = (v287 >> (15u & 31u));
                let v289 = (v288 ^ v287);
                let v290 = (v289 * 2221713035u);
                let v291 = (v290 >> (16u & 31u));
                let v292 = (v290 & 65535u);
                let v293 = (v292 ^ v291);
                let v294 = f32(v293);
                let v295 = (v294 * 1.5258789e-5f);
                let v296 = (v295 + -0.49999237f);
                let v297 = -(v296);
                p269 = v297;
                p270 = false;
              } else {
                p270 = true;
              }
              let v269 = p269;
              let v270 = p270;
              if v270 {
                let v271 = (v268 ^ v235);
                let v272 = (v271 >> (16u & 31u));
                let v273 = (v272 ^ v271);
                let v274 = (v273 * 2146121005u);
                let v275 = (v274 >> (15u & 31u));
                let v276 = (v275 ^ v274);
                let v277 = (v276 * 2221713035u);
                let v278 = (v277 >> (16u & 31u));
                let v279 = (v277 & 65535u);
                let v280 = (v279 ^ v278);
                let v281 = f32(v280);
                let v282 = (v281 * 1.5258789e-5f);
                let v283 = (v282 + -0.49999237f);
                p299 = v283;
              } else {
                p299 = v269;
              }
              let v299 = p299;
              let v300 = (v257 + v299);
              p599 = v300;
            } else {
              p599 = v257;
            }
            let v305 = (v577 < 0.0f);
            p596 = false;
            p303 = 4294967294u;
            p304 = v305;
          } else {
            p596 = true;
            p303 = v458;
            p304 = true;
          }
          let v303 = p303;
          let v304 = p304;
          if v304 {
            let v306 = (v303 != 4294967294u);
            p596 = true;
            p324 = v303;
            p242 = v306;
          } else {
            p324 = 4294967295u;
            p242 = true;
          }
          p237 = v235;
          p598 = v235;
        } else {
          p596 = true;
          p324 = 4294967295u;
          p242 = true;
        }
        let v237 = p237;
        let v242 = p242;
        p233 = v237;
        done4 = v242;
      }
      let v596 = p596;
      let v598 = p598;
      let v599 = p599;
      let v412 = (v596 != true);
      if v412 {
        let v307 = (v599 > -1048576.0f);
        let v308 = select(-1048576.0f, v599, v307);
        let v309 = (v308 < 1048576.0f);
        let v310 = select(1048576.0f, v308, v309);
        let v311 = (v310 + 12582912.0f);
        let v312 = bitcast<u32>(v311);
        let v313 = (v312 + 3032481792u);
        let v314 = f32(bitcast<i32>(v313));
        let v315 = (v310 - v314);
        let v316 = (v315 >= 0.5f);
        let v317 = select(0u, 1u, v316);
        let v318 = (v313 + v598);
        let v319 = (v318 + v317);
        let v579 = bitcast<u32>(min(bitcast<i32>(v458), bitcast<i32>(v319)));
        let v580 = bitcast<u32>(max(bitcast<i32>(v579), bitcast<i32>(4294967295u)));
        p322 = v580;
        p323 = false;
      } else {
        p323 = true;
      }
      let v322 = p322;
      let v323 = p323;
      if !v323 {
        p324 = v322;
      }
      let v324 = p324;
      let v325 = (v208 < v27);
      if v325 {
        p337 = v324;
        p338 = v208;
        var done5 = false;
        loop {
          if done5 { break; }
          let v337 = p337;
          let v338 = p338;
          let v339 = (v338 - v23);
          let v581 = r2[v339];
          let v344 = (v581 != 4294967294u);
          if v344 {
            let v363 = (v337 + 1u);
            let v582 = r3[2u][0u];
            let v365 = (v582 != 0u);
            let v366 = (bitcast<i32>(v363) < bitcast<i32>(v581));
            let v367 = (v366 & v365);
            if v367 {
              let v369 = (bitcast<i32>(v581) < bitcast<i32>(v458));
              let v370 = select(0u, 1u, v369);
              p372 = v370;
            } else {
              p372 = 0u;
            }
            let v372 = p372;
            let v373 = (v372 + v581);
            let v374 = (bitcast<i32>(v363) < bitcast<i32>(v373));
            if v374 {
              let v375 = (v338 + 1u);
              p376 = v363;
              var done6 = false;
              loop {
                if done6 { break; }
                let v376 = p376;
                let v585 = r3[0u][3u];
                let v380 = (v585 == 0u);
                let v381 = (v376 ^ 4294967295u);
                let v382 = (v458 + v381);
                let v383 = select(v382, v376, v380);
                let v384 = (v383 + v231);
                let v586 = atomicMax(&r6[v384], v375);
                let v389 = (v376 + 1u);
                let v390 = (v389 == v373);
                p376 = v389;
                done6 = v390;
              }
            }
            let v392 = (v581 < v458);
            if v392 {
              let v588 = r3[0u][3u];
              let v395 = (v588 == 0u);
              let v396 = (v581 ^ 4294967295u);
              let v397 = (v458 + v396);
              let v398 = select(v397, v581, v395);
              let v399 = (v398 + v231);
              let v403 = (v338 + 1u);
              let v589 = atomicMax(&r5[v399], v403);
            }
            p371 = v581;
          } else {
            p371 = v337;
          }
          let v371 = p371;
          let v361 = (v338 + 1u);
          let v362 = (v361 == v27);
          p337 = v371;
          p338 = v361;
          p335 = v371;
          done5 = v362;
        }
      } else {
        p335 = v324;
      }
      let v335 = p335;
      let v330 = (v27 == v458);
      if v330 {
        let v331 = (v335 + 1u);
        let v332 = (bitcast<i32>(v331) < bitcast<i32>(v27));
        if v332 {
          let v334 = (v27 + 1u);
          p345 = v331;
          p346 = v335;
          var done7 = false;
          loop {
            if done7 { break; }
            let v345 = p345;
            let v346 = p346;
            let v592 = r3[0u][3u];
            let v350 = (v592 == 0u);
            let v351 = (v458 - v346);
            let v352 = (v351 + 4294967294u);
            let v353 = select(v352, v345, v350);
            let v354 = (v353 + v231);
            let v593 = atomicMax(&r6[v354], v334);
            let v359 = (v345 + 1u);
            let v360 = (v359 == v27);
            p345 = v359;
            p346 = v345;
            done7 = v360;
          }
        }
      }
    }
  }
  return;
}
