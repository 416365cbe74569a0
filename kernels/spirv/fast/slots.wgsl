@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r4: array<u32>;
@group(0) @binding(2) var<storage, read_write> r5: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r6: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn slots(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var r2: array<u32, 8>;
  var p100: u32;
  var p99: bool;
  var p43: u32;
  var p55: bool;
  var p565: u32;
  var p139: f32;
  var p140: bool;
  var p193: f32;
  var p192: f32;
  var p216: u32;
  var p223: u32;
  var p225: bool;
  var p215: u32;
  var p235: u32;
  var p271: f32;
  var p272: bool;
  var p301: f32;
  var p305: u32;
  var p306: bool;
  var p239: u32;
  var p244: bool;
  var p600: bool;
  var p602: u32;
  var p603: f32;
  var p324: u32;
  var p325: bool;
  var p326: u32;
  var p339: u32;
  var p340: u32;
  var p374: u32;
  var p378: u32;
  var p409: bool;
  var p373: u32;
  var p337: u32;
  var p347: u32;
  var p348: u32;
  let v453 = global_invocation_id[0u];
  let v454 = global_invocation_id[1u];
  let v459 = r3[0u][1u];
  let v19 = (v454 < v459);
  let v460 = r3[0u][0u];
  let v21 = (v453 << (3u & 31u));
  let v461 = min(v21, v460);
  let v23 = select(v460, v461, v19);
  let v24 = (v460 - v23);
  let v25 = (v24 < 8u);
  let v26 = (v23 + 8u);
  let v27 = select(v26, v460, v25);
  let v462 = r3[1u][2u];
  let v463 = r3[1u][3u];
  let v32 = (v463 != 0u);
  let v33 = (v23 != v27);
  let v34 = (v462 != 0u);
  let v35 = (v34 & v33);
  if v35 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v36 = (v27 - v23);
    let v37 = (v36 != 8u);
    if v37 {
      let v38 = (v23 < v27);
      if v38 {
        let v39 = (v460 * v454);
        let v472 = r3[0u][3u];
        let v42 = (v472 != 0u);
        if v42 {
          let v54 = (v460 + v39);
          p100 = v23;
          var done0 = false;
          loop {
            if done0 { break; }
            let v100 = p100;
            let v101 = (v100 - v23);
            let v102 = (v100 ^ 4294967295u);
            let v103 = (v54 + v102);
            let v473 = (v103 * 2u);
            let v474 = r4[v473];
            r0[v101] = v474;
            let v110 = (v100 + 1u);
            let v111 = (v110 == v27);
            p100 = v110;
            done0 = v111;
          }
          p99 = false;
        } else {
          p99 = true;
        }
        let v99 = p99;
        if v99 {
          p43 = v23;
          var done1 = false;
          loop {
            if done1 { break; }
            let v43 = p43;
            let v44 = (v43 - v23);
            let v45 = (v43 + v39);
            let v477 = (v45 * 2u);
            let v478 = r4[v477];
            r0[v44] = v478;
            let v52 = (v43 + 1u);
            let v53 = (v52 == v27);
            p43 = v52;
            done1 = v53;
          }
        }
      }
      p55 = false;
    } else {
      p55 = true;
    }
    let v55 = p55;
    if v55 {
      let v481 = r3[0u][3u];
      let v58 = (v481 == 0u);
      let v59 = (v27 + 4294967295u);
      let v482 = select(7u, 0u, v58);
      let v61 = select(v59, v23, v58);
      let v62 = (v460 * v454);
      let v63 = (v61 ^ 4294967295u);
      let v64 = (v460 + v63);
      let v65 = select(v64, v23, v58);
      let v66 = (v65 + v62);
      let v483 = (v66 * 2u);
      let v484 = (v482 * 2u);
      let v485 = (v483 + v484);
      let v486 = r4[v485];
      r0[0u] = v486;
      let v489 = (v482 ^ 1u);
      let v491 = (v489 * 2u);
      let v492 = (v483 + v491);
      let v493 = r4[v492];
      r0[1u] = v493;
      let v496 = (v482 ^ 2u);
      let v498 = (v496 * 2u);
      let v499 = (v483 + v498);
      let v500 = r4[v499];
      r0[2u] = v500;
      let v503 = (v482 ^ 3u);
      let v505 = (v503 * 2u);
      let v506 = (v483 + v505);
      let v507 = r4[v506];
      r0[3u] = v507;
      let v510 = (v482 ^ 4u);
      let v512 = (v510 * 2u);
      let v513 = (v483 + v512);
      let v514 = r4[v513];
      r0[4u] = v514;
      let v517 = (v482 ^ 5u);
      let v519 = (v517 * 2u);
      let v520 = (v483 + v519);
      let v521 = r4[v520];
      r0[5u] = v521;
      let v524 = (v482 ^ 6u);
      let v526 = (v524 * 2u);
      let v527 = (v483 + v526);
      let v528 = r4[v527];
      r0[6u] = v528;
      let v531 = (v482 ^ 7u);
      let v533 = (v531 * 2u);
      let v534 = (v483 + v533);
      let v535 = r4[v534];
      r0[7u] = v535;
    }
    let v538 = r0[0u];
    let v539 = r0[1u];
    let v540 = r0[2u];
    let v541 = r0[3u];
    let v542 = r0[4u];
    let v543 = r0[5u];
    let v544 = r0[6u];
    let v545 = r0[7u];
    r1[0u] = v538;
    r1[1u] = v539;
    r1[2u] = v540;
    r1[3u] = v541;
    r1[4u] = v542;
    r1[5u] = v543;
    r1[6u] = v544;
    r1[7u] = v545;
    r2[0u] = 0u;
    r2[1u] = 0u;
    r2[2u] = 0u;
    r2[3u] = 0u;
    r2[4u] = 0u;
    r2[5u] = 0u;
    r2[6u] = 0u;
    r2[7u] = 0u;
    let v562 = r3[0u][2u];
    let v563 = bitcast<f32>(v562);
    let v564 = r3[2u][3u];
    let v116 = (v564 != 0u);
    let v119 = (v564 >> (16u & 31u));
    let v120 = (v119 ^ v564);
    let v121 = (v120 * 2146121005u);
    let v122 = (v121 >> (15u & 31u));
    let v123 = (v122 ^ v121);
    let v124 = (v123 * 2221713035u);
    let v125 = (v124 >> (16u & 31u));
    p565 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v565 = p565;
      let v567 = (v565 + 1u);
      let v568 = r1[v565];
      let v569 = bitcast<f32>(v568);
      let v131 = (v23 + v565);
      let v132 = (v569 == bitcast<f32>(bits_7f800000));
      let v133 = (v569 + -1.0f);
      let v134 = (v133 / v569);
      let v135 = (v563 * v134);
      let v136 = select(v135, v563, v132);
      if v116 {
        let v570 = r3[0u][3u];
        let v138 = (v570 != 0u);
        if v138 {
          let v165 = (v131 ^ 4294967295u);
          let v166 = (v460 + v165);
          let v571 = r3[3u][0u];
          let v168 = (v571 + v454);
          let v169 = (v168 >> (16u & 31u));
          let v170 = (v168 ^ v169);
          let v171 = (v170 ^ v124);
          let v172 = (v171 * 2146121005u);
          let v173 = (v172 >> (15u & 31u));
          let v174 = (v173 ^ v172);
          let v175 = (v174 * 2221713035u);
          let v176 = (v175 >> (16u & 31u));
          let v177 = (v166 ^ v176);
          let v178 = (v177 ^ v175);
          let v179 = (v178 >> (16u & 31u));
          let v180 = (v179 ^ v178);
          let v181 = (v180 * 2146121005u);
          let v182 = (v181 >> (15u & 31u));
          let v183 = (v182 ^ v181);
          let v184 = (v183 * 2221713035u);
          let v185 = (v184 >> (16u & 31u));
          let v186 = (v184 & 65535u);
          let v187 = (v186 ^ v185);
          let v188 = f32(v187);
          let v189 = (v188 * 1.5258789e-5f);
          let v190 = (v189 + -0.49999237f);
          let v191 = -(v190);
          p139 = v191;
          p140 = false;
        } else {
          p140 = true;
        }
        let v139 = p139;
        let v140 = p140;
        if v140 {
          let v572 = r3[3u][0u];
          let v142 = (v572 + v454);
          let v143 = (v142 >> (16u & 31u));
          let v144 = (v142 ^ v143);
          let v145 = (v144 ^ v124);
          let v146 = (v145 * 2146121005u);
          let v147 = (v146 >> (15u & 31u));
          let v148 = (v147 ^ v146);
          let v149 = (v148 * 2221713035u);
          let v150 = (v149 >> (16u & 31u));
          let v151 = (v131 ^ v150);
          let v152 = (v151 ^ v149);
          let v153 = (v152 >> (16u & 31u));
          let v154 = (v153 ^ v152);
          let v155 = (v154 * 2146121005u);
          let v156 = (v155 >> (15u & 31u));
          let v157 = (v156 ^ v155);
          let v158 = (v157 * 2221713035u);
          let v159 = (v158 >> (16u & 31u));
          let v160 = (v158 & 65535u);
          let v161 = (v160 ^ v159);
          let v162 = f32(v161);
          let v163 = (v162 * 1.5258789e-5f);
          let v164 = (v163 + -0.49999237f);
          p193 = v164;
        } else {
          p193 = v139;
        }
        let v193 = p193;
        let v194 = (v136 + v193);
        p192 = v194;
      } else {
        p192 = v136;
      }
      let v192 = p192;
      let v195 = (v192 > -1048576.0f);
      let v196 = select(-1048576.0f, v192, v195);
      let v197 = (v196 < 1048576.0f);
      let v198 = select(1048576.0f, v196, v197);
      let v199 = (v198 + 12582912.0f);
      let v200 = bitcast<u32>(v199);
      let v201 = (v200 + 3032481792u);
      let v202 = f32(bitcast<i32>(v201));
      let v203 = (v198 - v202);
      let v204 = (v203 >= 0.5f);
      let v205 = select(0u, 1u, v204);
      let v206 = (v201 + v131);
      let v207 = (v206 + v205);
      let v573 = bitcast<u32>(min(bitcast<i32>(v460), bitcast<i32>(v207)));
      let v574 = bitcast<u32>(max(bitcast<i32>(v573), bitcast<i32>(4294967295u)));
      let v210 = (v569 < 0.0f);
      let v211 = select(v574, 4294967294u, v210);
      r2[v565] = v211;
      let v576 = (v567 == 8u);
      p565 = v567;
      done2 = v576;
    }
    let v214 = (v23 < v27);
    if v214 {
      p216 = v23;
      var done3 = false;
      loop {
        if done3 { break; }
        let v216 = p216;
        let v217 = (v216 - v23);
        let v577 = r2[v217];
        let v222 = (v577 == 4294967294u);
        if v222 {
          let v230 = (v216 + 1u);
          let v231 = (v230 == v27);
          p223 = v230;
          p215 = v27;
          p225 = v231;
        } else {
          p215 = v216;
          p225 = true;
        }
        let v223 = p223;
        let v225 = p225;
        p216 = v223;
        done3 = v225;
      }
    } else {
      p215 = v23;
    }
    let v215 = p215;
    let v226 = (v215 == v27);
    let v227 = (v27 < v460);
    let v228 = (v227 & v226);
    let v229 = (v228 != true);
    if v229 {
      let v233 = (v460 * v454);
      let v234 = (v125 ^ v124);
      p235 = v23;
      var done4 = false;
      loop {
        if done4 { break; }
        let v235 = p235;
        let v236 = (v235 != 0u);
        if v236 {
          let v237 = (v235 + 4294967295u);
          let v238 = (v237 < v460);
          if v238 {
            let v578 = r3[0u][3u];
            let v246 = (v578 == 0u);
            let v247 = (v246 != true);
            let v248 = (v460 - v235);
            let v249 = select(v248, v237, v246);
            let v250 = (v249 + v233);
            let v579 = (v250 * 2u);
            let v580 = r4[v579];
            let v581 = bitcast<f32>(v580);
            let v255 = (v581 == bitcast<f32>(bits_7f800000));
            let v256 = (v581 + -1.0f);
            let v257 = (v256 / v581);
            let v258 = (v563 * v257);
            let v259 = select(v258, v563, v255);
            if v116 {
              let v582 = r3[3u][0u];
              let v261 = (v582 + v454);
              let v262 = (v261 ^ v234);
              let v263 = (v262 >> (16u & 31u));
              let v264 = (v263 ^ v262);
              let v265 = (v264 * 2146121005u);
              let v266 = (v265 >> (15u & 31u));
              let v267 = (v266 ^ v265);
              let v268 = (v267 * 2221713035u);
              let v269 = (v268 >> (16u & 31u));
              let v270 = (v269 ^ v268);
              if v247 {
                let v286 = (v270 ^ v248);
                let v287 = (v286 >> (16u & 31u));
                let v288 = (v287 ^ v286);
                let v289 = (v288 * 2146121005u);
                let v290 = (v289 >> (15u & 31u));
                let v291 = (v290 ^ v289);
                let v292 = (v291 * 2221713035u);
                let v293 = (v292 >> (16u & 31u));
                let v294 = (v292 & 65535u);
                let v295 = (v294 ^ v293);
                let v296 = f32(v295);
                let v297 = (v296 * 1.5258789e-5f);
                let v298 = (v297 + -0.49999237f);
                let v299 = -(v298);
                p271 = v299;
                p272 = false;
              } else {
                p272 = true;
              }
              let v271 = p271;
              let v272 = p272;
              if v272 {
                let v273 = (v270 ^ v237);
                let v274 = (v273 >> (16u & 31u));
                let v275 = (v274 ^ v273);
                let v276 = (v275 * 2146121005u);
                let v277 = (v276 >> (15u & 31u));
                let v278 = (v277 ^ v276);
                let v279 = (v278 * 2221713035u);
                let v280 = (v279 >> (16u & 31u));
                let v281 = (v279 & 65535u);
                let v282 = (v281 ^ v280);
                let v283 = f32(v282);
                let v284 = (v283 * 1.5258789e-5f);
                let v285 = (v284 + -0.49999237f);
                p301 = v285;
              } else {
                p301 = v271;
              }
              let v301 = p301;
              let v302 = (v259 + v301);
              p603 = v302;
            } else {
              p603 = v259;
            }
            let v307 = (v581 < 0.0f);
            p600 = false;
            p305 = 4294967294u;
            p306 = v307;
          } else {
            p600 = true;
            p305 = v460;
            p306 = true;
          }
          let v305 = p305;
          let v306 = p306;
          if v306 {
            let v308 = (v305 != 4294967294u);
            p600 = true;
            p326 = v305;
            p244 = v308;
          } else {
            p326 = 4294967295u;
            p244 = true;
          }
          p239 = v237;
          p602 = v237;
        } else {
          p600 = true;
          p326 = 4294967295u;
          p244 = true;
        }
        let v239 = p239;
        let v244 = p244;
        p235 = v239;
        done4 = v244;
      }
      let v600 = p600;
      let v602 = p602;
      let v603 = p603;
      let v414 = (v600 != true);
      if v414 {
        let v309 = (v603 > -1048576.0f);
        let v310 = select(-1048576.0f, v603, v309);
        let v311 = (v310 < 1048576.0f);
        let v312 = select(1048576.0f, v310, v311);
        let v313 = (v312 + 12582912.0f);
        let v314 = bitcast<u32>(v313);
        let v315 = (v314 + 3032481792u);
        let v316 = f32(bitcast<i32>(v315));
        let v317 = (v312 - v316);
        let v318 = (v317 >= 0.5f);
        let v319 = select(0u, 1u, v318);
        let v320 = (v315 + v602);
        let v321 = (v320 + v319);
        let v583 = bitcast<u32>(min(bitcast<i32>(v460), bitcast<i32>(v321)));
        let v584 = bitcast<u32>(max(bitcast<i32>(v583), bitcast<i32>(4294967295u)));
        p324 = v584;
        p325 = false;
      } else {
        p325 = true;
      }
      let v324 = p324;
      let v325 = p325;
      if !v325 {
        p326 = v324;
      }
      let v326 = p326;
      let v327 = (v215 < v27);
      if v327 {
        p339 = v326;
        p340 = v215;
        var done5 = false;
        loop {
          if done5 { break; }
          let v339 = p339;
          let v340 = p340;
          let v341 = (v340 - v23);
          let v585 = r2[v341];
          let v346 = (v585 != 4294967294u);
          if v346 {
            let v365 = (v339 + 1u);
            let v586 = r3[2u][0u];
            let v367 = (v586 != 0u);
            let v368 = (bitcast<i32>(v365) < bitcast<i32>(v585));
            let v369 = (v368 & v367);
            if v369 {
              let v371 = (bitcast<i32>(v585) < bitcast<i32>(v460));
              let v372 = select(0u, 1u, v371);
              p374 = v372;
            } else {
              p374 = 0u;
            }
            let v374 = p374;
            let v375 = (v374 + v585);
            let v376 = (bitcast<i32>(v365) < bitcast<i32>(v375));
            if v376 {
              let v377 = (v340 + 1u);
              p378 = v365;
              var done6 = false;
              loop {
                if done6 { break; }
                let v378 = p378;
                let v589 = r3[0u][3u];
                let v382 = (v589 == 0u);
                let v383 = (v378 ^ 4294967295u);
                let v384 = (v460 + v383);
                let v385 = select(v384, v378, v382);
                let v386 = (v385 + v233);
                let v590 = atomicMax(&r6[v386], v377);
                let v391 = (v378 + 1u);
                let v392 = (v391 == v375);
                p378 = v391;
                done6 = v392;
              }
            }
            let v394 = (v585 < v460);
            if v394 {
              let v592 = r3[0u][3u];
              let v397 = (v592 == 0u);
              let v398 = (v585 ^ 4294967295u);
              let v399 = (v460 + v398);
              let v400 = select(v399, v585, v397);
              let v401 = (v400 + v233);
              let v402 = (v401 * v462);
              let v403 = (v340 % v462);
              let v404 = (v402 + v403);
              let v408 = (v340 + 1u);
              if v32 {
                atomicStore(&r5[v404], v408);
                p409 = false;
              } else {
                p409 = true;
              }
              let v409 = p409;
              if v409 {
                let v594 = atomicMax(&r5[v404], v408);
              }
            }
            p373 = v585;
          } else {
            p373 = v339;
          }
          let v373 = p373;
          let v363 = (v340 + 1u);
          let v364 = (v363 == v27);
          p339 = v373;
          p340 = v363;
          p337 = v373;
          done5 = v364;
        }
      } else {
        p337 = v326;
      }
      let v337 = p337;
      let v332 = (v27 == v460);
      if v332 {
        let v333 = (v337 + 1u);
        let v334 = (bitcast<i32>(v333) < bitcast<i32>(v27));
        if v334 {
          let v336 = (v27 + 1u);
          p347 = v333;
          p348 = v337;
          var done7 = false;
          loop {
            if done7 { break; }
            let v347 = p347;
            let v348 = p348;
            let v597 = r3[0u][3u];
            let v352 = (v597 == 0u);
            let v353 = (v460 - v348);
            let v354 = (v353 + 4294967294u);
            let v355 = select(v354, v347, v352);
            let v356 = (v355 + v233);
            let v598 = atomicMax(&r6[v356], v336);
            let v361 = (v347 + 1u);
            let v362 = (v361 == v27);
            p347 = v361;
            p348 = v347;
            done7 = v362;
          }
        }
      }
    }
  }
  return;
}
