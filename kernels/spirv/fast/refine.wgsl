@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 6>;
struct Push { w0: u32, w1: u32 }
var<immediate> r3: Push;
@group(0) @binding(1) var<storage, read> r4: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> r5: array<u32>;
@group(0) @binding(3) var<storage, read_write> r6: array<atomic<u32>>;
@compute @workgroup_size(8, 8, 1)
fn refine(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 12>;
  var r1: array<u32, 12>;
  var p50: bool;
  var p553: u32;
  var p555: u32;
  var p360: u32;
  var p365: u32;
  var p378: bool;
  var p385: u32;
  var p394: u32;
  var p395: bool;
  var p408: u32;
  var p409: bool;
  var p399: u32;
  var p401: bool;
  var p608: u32;
  var p416: u32;
  var p359: bool;
  var p271: bool;
  var p275: u32;
  var p290: bool;
  var p294: u32;
  var p309: bool;
  var p313: u32;
  var p329: bool;
  var p333: u32;
  var p349: bool;
  var p353: u32;
  let v480 = global_invocation_id[0u];
  let v481 = global_invocation_id[1u];
  let v486 = r2[5u][2u];
  let v20 = (v486 & 31u);
  let v21 = (1u << (v20 & 31u));
  let v23 = (v480 << (v20 & 31u));
  let v24 = (v481 << (v20 & 31u));
  let v25 = (v23 + v21);
  let v487 = r2[0u][3u];
  let v28 = (v25 < v487);
  if v28 {
    let v29 = (v24 + v21);
    let v488 = r2[3u][3u];
    let v32 = (v29 < v488);
    if v32 {
      let v489 = r2[5u][3u];
      let v35 = (v489 == 0u);
      let v36 = (v35 != true);
      if v36 {
        let v37 = (4294967294u << (v20 & 31u));
        let v38 = (v24 & v37);
        let v39 = (v38 + v21);
        let v40 = (v39 * v487);
        let v41 = (v23 & v37);
        let v42 = (v41 + v21);
        let v43 = (v42 + v40);
        let v490 = atomicLoad(&r6[v43]);
        let v48 = (v490 & 4294901760u);
        let v49 = (v48 != 458752u);
        p50 = v49;
      } else {
        p50 = v35;
      }
      let v50 = p50;
      if v50 {
        let v51 = (v24 * v487);
        let v52 = (v51 + v23);
        let v53 = (v25 + v51);
        let v54 = (v29 * v487);
        let v55 = (v54 + v23);
        let v56 = (v54 + v25);
        let v491 = (v52 * 2u);
        let v492 = r4[v491];
        let v493 = v492[0u];
        let v497 = v492[1u];
        let v501 = v492[2u];
        let v503 = (v53 * 2u);
        let v504 = r4[v503];
        let v505 = v504[0u];
        let v509 = v504[1u];
        let v513 = v504[2u];
        let v515 = (v55 * 2u);
        let v516 = r4[v515];
        let v517 = v516[0u];
        let v521 = v516[1u];
        let v525 = v516[2u];
        let v527 = (v56 * 2u);
        let v528 = r4[v527];
        let v529 = v528[0u];
        let v533 = v528[1u];
        let v537 = v528[2u];
        r1[0u] = v493;
        r1[1u] = v497;
        r1[2u] = v501;
        r1[3u] = v505;
        r1[4u] = v509;
        r1[5u] = v513;
        r1[6u] = v517;
        r1[7u] = v521;
        r1[8u] = v525;
        r1[9u] = v529;
        r1[10u] = v533;
        r1[11u] = v537;
        let v551 = r3.w0;
        let v552 = bitcast<f32>(v551);
        p553 = 0u;
        p555 = 0u;
        var done0 = false;
        loop {
          if done0 { break; }
          let v553 = p553;
          let v555 = p555;
          let v556 = r1[v555];
          let v557 = bitcast<f32>(v556);
          let v558 = (v555 + 1u);
          let v559 = r1[v558];
          let v560 = bitcast<f32>(v559);
          let v561 = (v555 + 2u);
          let v562 = r1[v561];
          let v563 = bitcast<f32>(v562);
          let v109 = (v557 > 0.0f);
          let v110 = select(0.0f, v557, v109);
          let v111 = (v110 < 1.0f);
          let v112 = select(1.0f, v110, v111);
          let v113 = (v560 > 0.0f);
          let v114 = select(0.0f, v560, v113);
          let v115 = (v114 < 1.0f);
          let v116 = select(1.0f, v114, v115);
          let v117 = (v563 > 0.0f);
          let v118 = select(0.0f, v563, v117);
          let v119 = (v118 < 1.0f);
          let v120 = select(1.0f, v118, v119);
          let v564 = bitcast<u32>(v112);
          let v565 = (v553 * 3u);
          r0[v565] = v564;
          let v567 = bitcast<u32>(v116);
          let v569 = (v565 + 1u);
          r0[v569] = v567;
          let v571 = bitcast<u32>(v120);
          let v573 = (v565 + 2u);
          r0[v573] = v571;
          let v575 = (v553 + 1u);
          let v576 = (v575 == 4u);
          let v653 = (v555 + 3u);
          p553 = v575;
          p555 = v653;
          done0 = v576;
        }
        let v577 = r0[0u];
        let v578 = bitcast<f32>(v577);
        let v579 = r0[1u];
        let v580 = bitcast<f32>(v579);
        let v581 = r0[2u];
        let v582 = bitcast<f32>(v581);
        let v583 = r0[3u];
        let v584 = bitcast<f32>(v583);
        let v585 = r0[4u];
        let v586 = bitcast<f32>(v585);
        let v587 = r0[5u];
        let v588 = bitcast<f32>(v587);
        let v589 = r0[6u];
        let v590 = bitcast<f32>(v589);
        let v591 = r0[7u];
        let v592 = bitcast<f32>(v591);
        let v593 = r0[8u];
        let v594 = bitcast<f32>(v593);
        let v595 = r0[9u];
        let v596 = bitcast<f32>(v595);
        let v597 = r0[10u];
        let v598 = bitcast<f32>(v597);
        let v599 = r0[11u];
        let v600 = bitcast<f32>(v599);
        let v149 = (v578 - v584);
        let v150 = (v580 - v586);
        let v151 = (v582 - v588);
        let v152 = (v149 > v552);
        let v153 = (v150 > v552);
        let v154 = (v152 | v153);
        let v155 = (v151 > v552);
        let v156 = (v154 | v155);
        let v157 = -(v149);
        let v158 = (v552 < v157);
        let v159 = (v158 | v156);
        let v160 = -(v150);
        let v161 = (v552 < v160);
        let v162 = (v161 | v159);
        let v163 = -(v151);
        let v164 = (v552 < v163);
        let v165 = (v164 | v162);
        let v166 = (v578 - v590);
        let v167 = (v580 - v592);
        let v168 = (v582 - v594);
        let v169 = (v166 > v552);
        let v170 = (v167 > v552);
        let v171 = (v169 | v170);
        let v172 = (v168 > v552);
        let v173 = (v171 | v172);
        let v174 = -(v166);
        let v175 = (v552 < v174);
        let v176 = (v175 | v173);
        let v177 = -(v167);
        let v178 = (v552 < v177);
        let v179 = (v178 | v176);
        let v180 = -(v168);
        let v181 = (v552 < v180);
        let v182 = (v181 | v179);
        let v183 = (v165 | v182);
        let v184 = (v578 - v596);
        let v185 = (v580 - v598);
        let v186 = (v582 - v600);
        let v187 = (v184 > v552);
        let v188 = (v185 > v552);
        let v189 = (v187 | v188);
        let v190 = (v186 > v552);
        let v191 = (v189 | v190);
        let v192 = -(v184);
        let v193 = (v552 < v192);
        let v194 = (v193 | v191);
        let v195 = -(v185);
        let v196 = (v552 < v195);
        let v197 = (v196 | v194);
        let v198 = -(v186);
        let v199 = (v552 < v198);
        let v200 = (v199 | v197);
        let v201 = (v183 | v200);
        let v202 = (v584 - v590);
        let v203 = (v586 - v592);
        let v204 = (v588 - v594);
        let v205 = (v202 > v552);
        let v206 = (v203 > v552);
        let v207 = (v205 | v206);
        let v208 = (v204 > v552);
        let v209 = (v207 | v208);
        let v210 = -(v202);
        let v211 = (v552 < v210);
        let v212 = (v211 | v209);
        let v213 = -(v203);
        let v214 = (v552 < v213);
        let v215 = (v214 | v212);
        let v216 = -(v204);
        let v217 = (v552 < v216);
        let v218 = (v217 | v215);
        let v219 = (v218 | v201);
        let v220 = (v584 - v596);
        let v221 = (v586 - v598);
        let v222 = (v588 - v600);
        let v223 = (v220 > v552);
        let v224 = (v221 > v552);
        let v225 = (v223 | v224);
        let v226 = (v222 > v552);
        let v227 = (v225 | v226);
        let v228 = -(v220);
        let v229 = (v552 < v228);
        let v230 = (v229 | v227);
        let v231 = -(v221);
        let v232 = (v552 < v231);
        let v233 = (v232 | v230);
        let v234 = -(v222);
        let v235 = (v552 < v234);
        let v236 = (v235 | v233);
        let v237 = (v236 | v219);
        let v238 = (v590 - v596);
        let v239 = (v592 - v598);
        let v240 = (v594 - v600);
        let v241 = (v238 > v552);
        let v242 = (v239 > v552);
        let v243 = (v241 | v242);
        let v244 = (v240 > v552);
        let v245 = (v243 | v244);
        let v246 = -(v238);
        let v247 = (v552 < v246);
        let v248 = (v247 | v245);
        let v249 = -(v239);
        let v250 = (v552 < v249);
        let v251 = (v250 | v248);
        let v252 = -(v240);
        let v253 = (v552 < v252);
        let v254 = (v253 | v251);
        let v255 = (v254 | v237);
        if v255 {
          let v256 = (v21 >> (1u & 31u));
          let v258 = (v21 >> (2u & 31u));
          let v260 = (v258 != 0u);
          if v260 {
            p360 = 0u;
            var done1 = false;
            loop {
              if done1 { break; }
              let v360 = p360;
              let v361 = (v360 * v256);
              let v362 = (v361 + v24);
              p365 = 0u;
              var done2 = false;
              loop {
                if done2 { break; }
                let v365 = p365;
                let v366 = (v365 | v360);
                let v367 = (v366 & 1u);
                let v368 = (v367 != 0u);
                if v368 {
                  let v369 = (v365 * v256);
                  let v370 = (v369 + v23);
                  let v372 = (v487 * v362);
                  let v373 = (v372 + v370);
                  let v602 = r3.w1;
                  let v375 = (v602 != 1u);
                  if v375 {
                    p608 = v373;
                    p378 = false;
                  } else {
                    p608 = 0u;
                    p378 = true;
                  }
                  let v378 = p378;
                  if v378 {
                    let v605 = r5[v373];
                    let v383 = (v605 >= 131072u);
                    if v383 {
                      p385 = 1u;
                      var done3 = false;
                      loop {
                        if done3 { break; }
                        let v385 = p385;
                        let v386 = (v370 < v385);
                        let v387 = (v386 != true);
                        if v387 {
                          let v388 = (v373 - v385);
                          let v606 = r5[v388];
                          let v393 = (v606 >= 131072u);
                          p394 = v606;
                          p395 = v393;
                        } else {
                          p395 = v386;
                        }
                        let v394 = p394;
                        let v395 = p395;
                        if v395 {
                          let v396 = (v385 + v370);
                          let v397 = (v396 < v487);
                          let v398 = (v397 != true);
                          if v397 {
                            let v402 = (v385 + v373);
                            let v607 = r5[v402];
                            let v407 = (v607 >= 131072u);
                            p408 = v607;
                            p409 = v407;
                          } else {
                            p409 = v398;
                          }
                          let v408 = p408;
                          let v409 = p409;
                          if v409 {
                            let v410 = (v385 + 1u);
                            let v411 = (v385 == v258);
                            p399 = v410;
                            p416 = v605;
                            p401 = v411;
                          } else {
                            p416 = v408;
                            p401 = true;
                          }
                        } else {
                          p416 = v394;
                          p401 = true;
                        }
                        let v399 = p399;
                        let v401 = p401;
                        p385 = v399;
                        done3 = v401;
                      }
                    } else {
                      p416 = v605;
                    }
                    p608 = v373;
                  } else {
                    p416 = 196607u;
                  }
                  let v608 = p608;
                  let v416 = p416;
                  let v611 = atomicLoad(&r6[v608]);
                  let v420 = (v611 & 4294901760u);
                  let v421 = (v420 == 458752u);
                  if v421 {
                    atomicStore(&r6[v608], v416);
                  }
                }
                let v422 = (v365 + 1u);
                let v423 = (v422 == 3u);
                p365 = v422;
                done2 = v423;
              }
              let v363 = (v360 + 1u);
              let v364 = (v363 == 3u);
              p360 = v363;
              done1 = v364;
            }
            p359 = false;
          } else {
            p359 = true;
          }
          let v359 = p359;
          if v359 {
            let v262 = (v256 + v23);
            let v265 = (v51 + v262);
            let v614 = r3.w1;
            let v267 = (v614 != 1u);
            if v267 {
              p271 = false;
            } else {
              p271 = true;
            }
            let v271 = p271;
            if v271 {
              let v617 = r5[v265];
              p275 = v617;
            } else {
              p275 = 196607u;
            }
            let v275 = p275;
            let v619 = atomicLoad(&r6[v265]);
            let v279 = (v619 & 4294901760u);
            let v280 = (v279 == 458752u);
            if v280 {
              atomicStore(&r6[v265], v275);
            }
            let v281 = (v256 + v24);
            let v283 = (v487 * v281);
            let v284 = (v283 + v23);
            if v267 {
              p290 = false;
            } else {
              p290 = true;
            }
            let v290 = p290;
            if v290 {
              let v625 = r5[v284];
              p294 = v625;
            } else {
              p294 = 196607u;
            }
            let v294 = p294;
            let v627 = atomicLoad(&r6[v284]);
            let v298 = (v627 & 4294901760u);
            let v299 = (v298 == 458752u);
            if v299 {
              atomicStore(&r6[v284], v294);
            }
            let v303 = (v283 + v262);
            if v267 {
              p309 = false;
            } else {
              p309 = true;
            }
            let v309 = p309;
            if v309 {
              let v633 = r5[v303];
              p313 = v633;
            } else {
              p313 = 196607u;
            }
            let v313 = p313;
            let v635 = atomicLoad(&r6[v303]);
            let v317 = (v635 & 4294901760u);
            let v318 = (v317 == 458752u);
            if v318 {
              atomicStore(&r6[v303], v313);
            }
            let v319 = (v21 & 2u);
            let v320 = (v319 + v23);
            let v323 = (v283 + v320);
            if v267 {
              p329 = false;
            } else {
              p329 = true;
            }
            let v329 = p329;
            if v329 {
              let v641 = r5[v323];
              p333 = v641;
            } else {
              p333 = 196607u;
            }
            let v333 = p333;
            let v643 = atomicLoad(&r6[v323]);
            let v337 = (v643 & 4294901760u);
            let v338 = (v337 == 458752u);
            if v338 {
              atomicStore(&r6[v323], v333);
            }
            let v339 = (v319 + v24);
            let v342 = (v487 * v339);
            let v343 = (v342 + v262);
            if v267 {
              p349 = false;
            } else {
              p349 = true;
            }
            let v349 = p349;
            if v349 {
              let v649 = r5[v343];
              p353 = v649;
            } else {
              p353 = 196607u;
            }
            let v353 = p353;
            let v651 = atomicLoad(&r6[v343]);
            let v357 = (v651 & 4294901760u);
            let v358 = (v357 == 458752u);
            if v358 {
              atomicStore(&r6[v343], v353);
            }
          }
        }
      }
    }
  }
  return;
}
