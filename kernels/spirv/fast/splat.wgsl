@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn splat(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p94: u32;
  var p93: bool;
  var p37: u32;
  var p32: bool;
  var p106: bool;
  var p108: f32;
  var p146: u32;
  var p170: u32;
  var p195: u32;
  var p220: u32;
  var p245: u32;
  var p270: u32;
  var p295: u32;
  var p320: u32;
  var p324: u32;
  var p331: u32;
  var p333: bool;
  var p323: u32;
  var p343: u32;
  var p387: u32;
  var p388: bool;
  var p348: u32;
  var p353: bool;
  var p680: bool;
  var p682: u32;
  var p683: f32;
  var p390: u32;
  var p391: bool;
  var p392: u32;
  var p405: u32;
  var p406: u32;
  var p440: u32;
  var p444: u32;
  var p439: u32;
  var p403: u32;
  var p413: u32;
  var p414: u32;
  let v518 = global_invocation_id[0u];
  let v519 = global_invocation_id[1u];
  let v524 = r2[0u][1u];
  let v18 = (v519 < v524);
  let v525 = r2[0u][0u];
  let v20 = (v518 << (3u & 31u));
  let v526 = min(v20, v525);
  let v22 = select(v525, v526, v18);
  let v23 = (v525 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v525, v24);
  let v27 = (v22 != v26);
  if v27 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v28 = (v26 - v22);
    let v29 = (v28 != 8u);
    if v29 {
      let v30 = (v22 < v26);
      if v30 {
        let v33 = (v525 * v519);
        let v535 = r2[0u][3u];
        let v36 = (v535 != 0u);
        if v36 {
          let v48 = (v525 + v33);
          p94 = v22;
          var done0 = false;
          loop {
            if done0 { break; }
            let v94 = p94;
            let v95 = (v94 - v22);
            let v96 = (v94 ^ 4294967295u);
            let v97 = (v48 + v96);
            let v536 = (v97 * 2u);
            let v537 = r3[v536];
            r0[v95] = v537;
            let v104 = (v94 + 1u);
            let v105 = (v104 == v26);
            p94 = v104;
            done0 = v105;
          }
          p93 = false;
        } else {
          p93 = true;
        }
        let v93 = p93;
        if v93 {
          p37 = v22;
          var done1 = false;
          loop {
            if done1 { break; }
            let v37 = p37;
            let v38 = (v37 - v22);
            let v39 = (v37 + v33);
            let v540 = (v39 * 2u);
            let v541 = r3[v540];
            r0[v38] = v541;
            let v46 = (v37 + 1u);
            let v47 = (v46 == v26);
            p37 = v46;
            done1 = v47;
          }
        }
        p106 = true;
      } else {
        p106 = false;
      }
      p32 = false;
    } else {
      p106 = false;
      p32 = true;
    }
    let v32 = p32;
    if v32 {
      let v544 = r2[0u][3u];
      let v52 = (v544 == 0u);
      let v53 = (v26 + 4294967295u);
      let v545 = select(7u, 0u, v52);
      let v55 = select(v53, v22, v52);
      let v56 = (v525 * v519);
      let v57 = (v55 ^ 4294967295u);
      let v58 = (v525 + v57);
      let v59 = select(v58, v22, v52);
      let v60 = (v59 + v56);
      let v546 = (v60 * 2u);
      let v547 = (v545 * 2u);
      let v548 = (v546 + v547);
      let v549 = r3[v548];
      r0[0u] = v549;
      let v552 = (v545 ^ 1u);
      let v554 = (v552 * 2u);
      let v555 = (v546 + v554);
      let v556 = r3[v555];
      r0[1u] = v556;
      let v559 = (v545 ^ 2u);
      let v561 = (v559 * 2u);
      let v562 = (v546 + v561);
      let v563 = r3[v562];
      r0[2u] = v563;
      let v566 = (v545 ^ 3u);
      let v568 = (v566 * 2u);
      let v569 = (v546 + v568);
      let v570 = r3[v569];
      r0[3u] = v570;
      let v573 = (v545 ^ 4u);
      let v575 = (v573 * 2u);
      let v576 = (v546 + v575);
      let v577 = r3[v576];
      r0[4u] = v577;
      let v580 = (v545 ^ 5u);
      let v582 = (v580 * 2u);
      let v583 = (v546 + v582);
      let v584 = r3[v583];
      r0[5u] = v584;
      let v587 = (v545 ^ 6u);
      let v589 = (v587 * 2u);
      let v590 = (v546 + v589);
      let v591 = r3[v590];
      r0[6u] = v591;
      let v594 = (v545 ^ 7u);
      let v596 = (v594 * 2u);
      let v597 = (v546 + v596);
      let v598 = r3[v597];
      r0[7u] = v598;
      p106 = true;
    }
    let v106 = p106;
    if v106 {
      let v601 = r0[0u];
      let v602 = bitcast<f32>(v601);
      p108 = v602;
    } else {
      p108 = 0.0f;
    }
    let v108 = p108;
    let v603 = r0[1u];
    let v604 = bitcast<f32>(v603);
    let v605 = r0[2u];
    let v606 = bitcast<f32>(v605);
    let v607 = r0[3u];
    let v608 = bitcast<f32>(v607);
    let v609 = r0[4u];
    let v610 = bitcast<f32>(v609);
    let v611 = r0[5u];
    let v612 = bitcast<f32>(v611);
    let v613 = r0[6u];
    let v614 = bitcast<f32>(v613);
    let v615 = r0[7u];
    let v616 = bitcast<f32>(v615);
    let v124 = !(v108 < 0.0f);
    if v124 {
      let v125 = (v108 == bitcast<f32>(bits_7f800000));
      let v617 = r2[0u][2u];
      let v618 = bitcast<f32>(v617);
      let v127 = (v108 + -1.0f);
      let v128 = (v127 / v108);
      let v129 = (v128 * v618);
      let v130 = select(v129, v618, v125);
      let v131 = (v130 > -1048576.0f);
      let v132 = select(-1048576.0f, v130, v131);
      let v133 = (v132 < 1048576.0f);
      let v134 = select(1048576.0f, v132, v133);
      let v135 = (v134 + 12582912.0f);
      let v136 = bitcast<u32>(v135);
      let v137 = (v136 + 3032481792u);
      let v138 = f32(bitcast<i32>(v137));
      let v139 = (v134 - v138);
      let v140 = (v139 >= 0.5f);
      let v141 = select(0u, 1u, v140);
      let v142 = (v22 + v137);
      let v143 = (v142 + v141);
      let v619 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v143)));
      let v620 = bitcast<u32>(max(bitcast<i32>(v619), bitcast<i32>(4294967295u)));
      p146 = v620;
    } else {
      p146 = 4294967294u;
    }
    let v146 = p146;
    r1[0u] = v146;
    let v147 = !(v604 < 0.0f);
    if v147 {
      let v148 = (v604 == bitcast<f32>(bits_7f800000));
      let v622 = r2[0u][2u];
      let v623 = bitcast<f32>(v622);
      let v150 = (v604 + -1.0f);
      let v151 = (v150 / v604);
      let v152 = (v151 * v623);
      let v153 = select(v152, v623, v148);
      let v154 = (v153 > -1048576.0f);
      let v155 = select(-1048576.0f, v153, v154);
      let v156 = (v155 < 1048576.0f);
      let v157 = select(1048576.0f, v155, v156);
      let v158 = (v157 + 12582912.0f);
      let v159 = bitcast<u32>(v158);
      let v160 = (v159 + 3032481792u);
      let v161 = f32(bitcast<i32>(v160));
      let v162 = (v157 - v161);
      let v163 = (v162 >= 0.5f);
      let v164 = select(0u, 1u, v163);
      let v165 = (v22 + 1u);
      let v166 = (v165 + v160);
      let v167 = (v166 + v164);
      let v624 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v167)));
      let v625 = bitcast<u32>(max(bitcast<i32>(v624), bitcast<i32>(4294967295u)));
      p170 = v625;
    } else {
      p170 = 4294967294u;
    }
    let v170 = p170;
    r1[1u] = v170;
    let v172 = !(v606 < 0.0f);
    if v172 {
      let v173 = (v606 == bitcast<f32>(bits_7f800000));
      let v627 = r2[0u][2u];
      let v628 = bitcast<f32>(v627);
      let v175 = (v606 + -1.0f);
      let v176 = (v175 / v606);
      let v177 = (v176 * v628);
      let v178 = select(v177, v628, v173);
      let v179 = (v178 > -1048576.0f);
      let v180 = select(-1048576.0f, v178, v179);
      let v181 = (v180 < 1048576.0f);
      let v182 = select(1048576.0f, v180, v181);
      let v183 = (v182 + 12582912.0f);
      let v184 = bitcast<u32>(v183);
      let v185 = (v184 + 3032481792u);
      let v186 = f32(bitcast<i32>(v185));
      let v187 = (v182 - v186);
      let v188 = (v187 >= 0.5f);
      let v189 = select(0u, 1u, v188);
      let v190 = (v22 + 2u);
      let v191 = (v190 + v185);
      let v192 = (v191 + v189);
      let v629 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v192)));
      let v630 = bitcast<u32>(max(bitcast<i32>(v629), bitcast<i32>(4294967295u)));
      p195 = v630;
    } else {
      p195 = 4294967294u;
    }
    let v195 = p195;
    r1[2u] = v195;
    let v197 = !(v608 < 0.0f);
    if v197 {
      let v198 = (v608 == bitcast<f32>(bits_7f800000));
      let v632 = r2[0u][2u];
      let v633 = bitcast<f32>(v632);
      let v200 = (v608 + -1.0f);
      let v201 = (v200 / v608);
      let v202 = (v201 * v633);
      let v203 = select(v202, v633, v198);
      let v204 = (v203 > -1048576.0f);
      let v205 = select(-1048576.0f, v203, v204);
      let v206 = (v205 < 1048576.0f);
      let v207 = select(1048576.0f, v205, v206);
      let v208 = (v207 + 12582912.0f);
      let v209 = bitcast<u32>(v208);
      let v210 = (v209 + 3032481792u);
      let v211 = f32(bitcast<i32>(v210));
      let v212 = (v207 - v211);
      let v213 = (v212 >= 0.5f);
      let v214 = select(0u, 1u, v213);
      let v215 = (v22 + 3u);
      let v216 = (v215 + v210);
      let v217 = (v216 + v214);
      let v634 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v217)));
      let v635 = bitcast<u32>(max(bitcast<i32>(v634), bitcast<i32>(4294967295u)));
      p220 = v635;
    } else {
      p220 = 4294967294u;
    }
    let v220 = p220;
    r1[3u] = v220;
    let v222 = !(v610 < 0.0f);
    if v222 {
      let v223 = (v610 == bitcast<f32>(bits_7f800000));
      let v637 = r2[0u][2u];
      let v638 = bitcast<f32>(v637);
      let v225 = (v610 + -1.0f);
      let v226 = (v225 / v610);
      let v227 = (v226 * v638);
      let v228 = select(v227, v638, v223);
      let v229 = (v228 > -1048576.0f);
      let v230 = select(-1048576.0f, v228, v229);
      let v231 = (v230 < 1048576.0f);
      let v232 = select(1048576.0f, v230, v231);
      let v233 = (v232 + 12582912.0f);
      let v234 = bitcast<u32>(v233);
      let v235 = (v234 + 3032481792u);
      let v236 = f32(bitcast<i32>(v235));
      let v237 = (v232 - v236);
      let v238 = (v237 >= 0.5f);
      let v239 = select(0u, 1u, v238);
      let v240 = (v22 + 4u);
      let v241 = (v240 + v235);
      let v242 = (v241 + v239);
      let v639 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v242)));
      let v640 = bitcast<u32>(max(bitcast<i32>(v639), bitcast<i32>(4294967295u)));
      p245 = v640;
    } else {
      p245 = 4294967294u;
    }
    let v245 = p245;
    r1[4u] = v245;
    let v247 = !(v612 < 0.0f);
    if v247 {
      let v248 = (v612 == bitcast<f32>(bits_7f800000));
      let v642 = r2[0u][2u];
      let v643 = bitcast<f32>(v642);
      let v250 = (v612 + -1.0f);
      let v251 = (v250 / v612);
      let v252 = (v251 * v643);
      let v253 = select(v252, v643, v248);
      let v254 = (v253 > -1048576.0f);
      let v255 = select(-1048576.0f, v253, v254);
      let v256 = (v255 < 1048576.0f);
      let v257 = select(1048576.0f, v255, v256);
      let v258 = (v257 + 12582912.0f);
      let v259 = bitcast<u32>(v258);
      let v260 = (v259 + 3032481792u);
      let v261 = f32(bitcast<i32>(v260));
      let v262 = (v257 - v261);
      let v263 = (v262 >= 0.5f);
      let v264 = select(0u, 1u, v263);
      let v265 = (v22 + 5u);
      let v266 = (v265 + v260);
      let v267 = (v266 + v264);
      let v644 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v267)));
      let v645 = bitcast<u32>(max(bitcast<i32>(v644), bitcast<i32>(4294967295u)));
      p270 = v645;
    } else {
      p270 = 4294967294u;
    }
    let v270 = p270;
    r1[5u] = v270;
    let v272 = !(v614 < 0.0f);
    if v272 {
      let v273 = (v614 == bitcast<f32>(bits_7f800000));
      let v647 = r2[0u][2u];
      let v648 = bitcast<f32>(v647);
      let v275 = (v614 + -1.0f);
      let v276 = (v275 / v614);
      let v277 = (v276 * v648);
      let v278 = select(v277, v648, v273);
      let v279 = (v278 > -1048576.0f);
      let v280 = select(-1048576.0f, v278, v279);
      let v281 = (v280 < 1048576.0f);
      let v282 = select(1048576.0f, v280, v281);
      let v283 = (v282 + 12582912.0f);
      let v284 = bitcast<u32>(v283);
      let v285 = (v284 + 3032481792u);
      let v286 = f32(bitcast<i32>(v285));
      let v287 = (v282 - v286);
      let v288 = (v287 >= 0.5f);
      let v289 = select(0u, 1u, v288);
      let v290 = (v22 + 6u);
      let v291 = (v290 + v285);
      let v292 = (v291 + v289);
      let v649 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v292)));
      let v650 = bitcast<u32>(max(bitcast<i32>(v649), bitcast<i32>(4294967295u)));
      p295 = v650;
    } else {
      p295 = 4294967294u;
    }
    let v295 = p295;
    r1[6u] = v295;
    let v297 = !(v616 < 0.0f);
    if v297 {
      let v298 = (v616 == bitcast<f32>(bits_7f800000));
      let v652 = r2[0u][2u];
      let v653 = bitcast<f32>(v652);
      let v300 = (v616 + -1.0f);
      let v301 = (v300 / v616);
      let v302 = (v301 * v653);
      let v303 = select(v302, v653, v298);
      let v304 = (v303 > -1048576.0f);
      let v305 = select(-1048576.0f, v303, v304);
      let v306 = (v305 < 1048576.0f);
      let v307 = select(1048576.0f, v305, v306);
      let v308 = (v307 + 12582912.0f);
      let v309 = bitcast<u32>(v308);
      let v310 = (v309 + 3032481792u);
      let v311 = f32(bitcast<i32>(v310));
      let v312 = (v307 - v311);
      let v313 = (v312 >= 0.5f);
      let v314 = select(0u, 1u, v313);
      let v315 = (v22 + 7u);
      let v316 = (v315 + v310);
      let v317 = (v316 + v314);
      let v654 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v317)));
      let v655 = bitcast<u32>(max(bitcast<i32>(v654), bitcast<i32>(4294967295u)));
      p320 = v655;
    } else {
      p320 = 4294967294u;
    }
    let v320 = p320;
    r1[7u] = v320;
    let v322 = (v22 < v26);
    if v322 {
      p324 = v22;
      var done2 = false;
      loop {
        if done2 { break; }
        let v324 = p324;
        let v325 = (v324 - v22);
        let v657 = r1[v325];
        let v330 = (v657 == 4294967294u);
        if v330 {
          let v338 = (v324 + 1u);
          let v339 = (v338 == v26);
          p331 = v338;
          p323 = v26;
          p333 = v339;
        } else {
          p323 = v324;
          p333 = true;
        }
        let v331 = p331;
        let v333 = p333;
        p324 = v331;
        done2 = v333;
      }
    } else {
      p323 = v22;
    }
    let v323 = p323;
    let v334 = (v323 == v26);
    let v335 = (v26 < v525);
    let v336 = (v335 & v334);
    let v337 = (v336 != true);
    if v337 {
      let v341 = (v525 * v519);
      p343 = v22;
      var done3 = false;
      loop {
        if done3 { break; }
        let v343 = p343;
        let v344 = (v343 != 0u);
        if v344 {
          let v345 = (v343 + 4294967295u);
          let v346 = (v345 < v525);
          let v347 = (v346 != true);
          if v346 {
            let v658 = r2[0u][3u];
            let v355 = (v658 == 0u);
            let v356 = (v525 - v343);
            let v357 = select(v356, v345, v355);
            let v358 = (v357 + v341);
            let v659 = (v358 * 2u);
            let v660 = r3[v659];
            let v661 = bitcast<f32>(v660);
            let v363 = (v661 < 0.0f);
            p680 = false;
            p683 = v661;
            p387 = 4294967294u;
            p388 = v363;
          } else {
            p680 = true;
            p387 = v525;
            p388 = v347;
          }
          let v387 = p387;
          let v388 = p388;
          if v388 {
            let v389 = (v387 != 4294967294u);
            p680 = true;
            p392 = v387;
            p353 = v389;
          } else {
            p392 = 4294967295u;
            p353 = true;
          }
          p348 = v345;
          p682 = v345;
        } else {
          p680 = true;
          p392 = 4294967295u;
          p353 = true;
        }
        let v348 = p348;
        let v353 = p353;
        p343 = v348;
        done3 = v353;
      }
      let v680 = p680;
      let v682 = p682;
      let v683 = p683;
      let v476 = (v680 != true);
      if v476 {
        let v364 = (v683 == bitcast<f32>(bits_7f800000));
        let v662 = r2[0u][2u];
        let v663 = bitcast<f32>(v662);
        let v366 = (v683 + -1.0f);
        let v367 = (v366 / v683);
        let v368 = (v367 * v663);
        let v369 = select(v368, v663, v364);
        let v370 = (v369 > -1048576.0f);
        let v371 = select(-1048576.0f, v369, v370);
        let v372 = (v371 < 1048576.0f);
        let v373 = select(1048576.0f, v371, v372);
        let v374 = (v373 + 12582912.0f);
        let v375 = bitcast<u32>(v374);
        let v376 = (v375 + 3032481792u);
        let v377 = f32(bitcast<i32>(v376));
        let v378 = (v373 - v377);
        let v379 = (v378 >= 0.5f);
        let v380 = select(0u, 1u, v379);
        let v381 = (v376 + v682);
        let v382 = (v381 + v380);
        let v664 = bitcast<u32>(min(bitcast<i32>(v525), bitcast<i32>(v382)));
        let v665 = bitcast<u32>(max(bitcast<i32>(v664), bitcast<i32>(4294967295u)));
        p390 = v665;
        p391 = false;
      } else {
        p391 = true;
      }
      let v390 = p390;
      let v391 = p391;
      if !v391 {
        p392 = v390;
      }
      let v392 = p392;
      let v393 = (v323 < v26);
      if v393 {
        p405 = v392;
        p406 = v323;
        var done4 = false;
        loop {
          if done4 { break; }
          let v405 = p405;
          let v406 = p406;
          let v407 = (v406 - v22);
          let v666 = r1[v407];
          let v412 = (v666 != 4294967294u);
          if v412 {
            let v431 = (v405 + 1u);
            let v667 = r2[2u][0u];
            let v433 = (v667 != 0u);
            let v434 = (bitcast<i32>(v431) < bitcast<i32>(v666));
            let v435 = (v434 & v433);
            if v435 {
              let v437 = (bitcast<i32>(v666) < bitcast<i32>(v525));
              let v438 = select(0u, 1u, v437);
              p440 = v438;
            } else {
              p440 = 0u;
            }
            let v440 = p440;
            let v441 = (v440 + v666);
            let v442 = (bitcast<i32>(v431) < bitcast<i32>(v441));
            if v442 {
              let v443 = (v406 + 1u);
              p444 = v431;
              var done5 = false;
              loop {
                if done5 { break; }
                let v444 = p444;
                let v670 = r2[0u][3u];
                let v448 = (v670 == 0u);
                let v449 = (v444 ^ 4294967295u);
                let v450 = (v525 + v449);
                let v451 = select(v450, v444, v448);
                let v452 = (v451 + v341);
                let v671 = atomicMax(&r5[v452], v443);
                let v457 = (v444 + 1u);
                let v458 = (v457 == v441);
                p444 = v457;
                done5 = v458;
              }
            }
            let v460 = (v666 < v525);
            if v460 {
              let v673 = r2[0u][3u];
              let v463 = (v673 == 0u);
              let v464 = (v666 ^ 4294967295u);
              let v465 = (v525 + v464);
              let v466 = select(v465, v666, v463);
              let v467 = (v466 + v341);
              let v471 = (v406 + 1u);
              let v674 = atomicMax(&r4[v467], v471);
            }
            p439 = v666;
          } else {
            p439 = v405;
          }
          let v439 = p439;
          let v429 = (v406 + 1u);
          let v430 = (v429 == v26);
          p405 = v439;
          p406 = v429;
          p403 = v439;
          done4 = v430;
        }
      } else {
        p403 = v392;
      }
      let v403 = p403;
      let v398 = (v26 == v525);
      if v398 {
        let v399 = (v403 + 1u);
        let v400 = (bitcast<i32>(v399) < bitcast<i32>(v26));
        if v400 {
          let v402 = (v26 + 1u);
          p413 = v399;
          p414 = v403;
          var done6 = false;
          loop {
            if done6 { break; }
            let v413 = p413;
            let v414 = p414;
            let v677 = r2[0u][3u];
            let v418 = (v677 == 0u);
            let v419 = (v525 - v414);
            let v420 = (v419 + 4294967294u);
            let v421 = select(v420, v413, v418);
            let v422 = (v421 + v341);
            let v678 = atomicMax(&r5[v422], v402);
            let v427 = (v413 + 1u);
            let v428 = (v427 == v26);
            p413 = v427;
            p414 = v413;
            done6 = v428;
          }
        }
      }
    }
  }
  return;
}
