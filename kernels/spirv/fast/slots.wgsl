@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn slots(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p101: u32;
  var p100: bool;
  var p44: u32;
  var p39: bool;
  var p113: bool;
  var p115: f32;
  var p153: u32;
  var p177: u32;
  var p202: u32;
  var p227: u32;
  var p252: u32;
  var p277: u32;
  var p302: u32;
  var p327: u32;
  var p331: u32;
  var p338: u32;
  var p340: bool;
  var p330: u32;
  var p350: u32;
  var p394: u32;
  var p395: bool;
  var p355: u32;
  var p360: bool;
  var p694: bool;
  var p696: u32;
  var p697: f32;
  var p397: u32;
  var p398: bool;
  var p399: u32;
  var p412: u32;
  var p413: u32;
  var p447: u32;
  var p451: u32;
  var p482: bool;
  var p446: u32;
  var p410: u32;
  var p420: u32;
  var p421: u32;
  let v529 = global_invocation_id[0u];
  let v530 = global_invocation_id[1u];
  let v535 = r2[0u][1u];
  let v18 = (v530 < v535);
  let v536 = r2[0u][0u];
  let v20 = (v529 << (3u & 31u));
  let v537 = min(v20, v536);
  let v22 = select(v536, v537, v18);
  let v23 = (v536 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v536, v24);
  let v538 = r2[1u][2u];
  let v539 = r2[1u][3u];
  let v31 = (v539 != 0u);
  let v32 = (v22 != v26);
  let v33 = (v538 != 0u);
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
        let v40 = (v536 * v530);
        let v548 = r2[0u][3u];
        let v43 = (v548 != 0u);
        if v43 {
          let v55 = (v536 + v40);
          p101 = v22;
          var done0 = false;
          loop {
            if done0 { break; }
            let v101 = p101;
            let v102 = (v101 - v22);
            let v103 = (v101 ^ 4294967295u);
            let v104 = (v55 + v103);
            let v549 = (v104 * 2u);
            let v550 = r3[v549];
            r0[v102] = v550;
            let v111 = (v101 + 1u);
            let v112 = (v111 == v26);
            p101 = v111;
            done0 = v112;
          }
          p100 = false;
        } else {
          p100 = true;
        }
        let v100 = p100;
        if v100 {
          p44 = v22;
          var done1 = false;
          loop {
            if done1 { break; }
            let v44 = p44;
            let v45 = (v44 - v22);
            let v46 = (v44 + v40);
            let v553 = (v46 * 2u);
            let v554 = r3[v553];
            r0[v45] = v554;
            let v53 = (v44 + 1u);
            let v54 = (v53 == v26);
            p44 = v53;
            done1 = v54;
          }
        }
        p113 = true;
      } else {
        p113 = false;
      }
      p39 = false;
    } else {
      p113 = false;
      p39 = true;
    }
    let v39 = p39;
    if v39 {
      let v557 = r2[0u][3u];
      let v59 = (v557 == 0u);
      let v60 = (v26 + 4294967295u);
      let v558 = select(7u, 0u, v59);
      let v62 = select(v60, v22, v59);
      let v63 = (v536 * v530);
      let v64 = (v62 ^ 4294967295u);
      let v65 = (v536 + v64);
      let v66 = select(v65, v22, v59);
      let v67 = (v66 + v63);
      let v559 = (v67 * 2u);
      let v560 = (v558 * 2u);
      let v561 = (v559 + v560);
      let v562 = r3[v561];
      r0[0u] = v562;
      let v565 = (v558 ^ 1u);
      let v567 = (v565 * 2u);
      let v568 = (v559 + v567);
      let v569 = r3[v568];
      r0[1u] = v569;
      let v572 = (v558 ^ 2u);
      let v574 = (v572 * 2u);
      let v575 = (v559 + v574);
      let v576 = r3[v575];
      r0[2u] = v576;
      let v579 = (v558 ^ 3u);
      let v581 = (v579 * 2u);
      let v582 = (v559 + v581);
      let v583 = r3[v582];
      r0[3u] = v583;
      let v586 = (v558 ^ 4u);
      let v588 = (v586 * 2u);
      let v589 = (v559 + v588);
      let v590 = r3[v589];
      r0[4u] = v590;
      let v593 = (v558 ^ 5u);
      let v595 = (v593 * 2u);
      let v596 = (v559 + v595);
      let v597 = r3[v596];
      r0[5u] = v597;
      let v600 = (v558 ^ 6u);
      let v602 = (v600 * 2u);
      let v603 = (v559 + v602);
      let v604 = r3[v603];
      r0[6u] = v604;
      let v607 = (v558 ^ 7u);
      let v609 = (v607 * 2u);
      let v610 = (v559 + v609);
      let v611 = r3[v610];
      r0[7u] = v611;
      p113 = true;
    }
    let v113 = p113;
    if v113 {
      let v614 = r0[0u];
      let v615 = bitcast<f32>(v614);
      p115 = v615;
    } else {
      p115 = 0.0f;
    }
    let v115 = p115;
    let v616 = r0[1u];
    let v617 = bitcast<f32>(v616);
    let v618 = r0[2u];
    let v619 = bitcast<f32>(v618);
    let v620 = r0[3u];
    let v621 = bitcast<f32>(v620);
    let v622 = r0[4u];
    let v623 = bitcast<f32>(v622);
    let v624 = r0[5u];
    let v625 = bitcast<f32>(v624);
    let v626 = r0[6u];
    let v627 = bitcast<f32>(v626);
    let v628 = r0[7u];
    let v629 = bitcast<f32>(v628);
    let v131 = !(v115 < 0.0f);
    if v131 {
      let v132 = (v115 == bitcast<f32>(bits_7f800000));
      let v630 = r2[0u][2u];
      let v631 = bitcast<f32>(v630);
      let v134 = (v115 + -1.0f);
      let v135 = (v134 / v115);
      let v136 = (v135 * v631);
      let v137 = select(v136, v631, v132);
      let v138 = (v137 > -1048576.0f);
      let v139 = select(-1048576.0f, v137, v138);
      let v140 = (v139 < 1048576.0f);
      let v141 = select(1048576.0f, v139, v140);
      let v142 = (v141 + 12582912.0f);
      let v143 = bitcast<u32>(v142);
      let v144 = (v143 + 3032481792u);
      let v145 = f32(bitcast<i32>(v144));
      let v146 = (v141 - v145);
      let v147 = (v146 >= 0.5f);
      let v148 = select(0u, 1u, v147);
      let v149 = (v22 + v144);
      let v150 = (v149 + v148);
      let v632 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v150)));
      let v633 = bitcast<u32>(max(bitcast<i32>(v632), bitcast<i32>(4294967295u)));
      p153 = v633;
    } else {
      p153 = 4294967294u;
    }
    let v153 = p153;
    r1[0u] = v153;
    let v154 = !(v617 < 0.0f);
    if v154 {
      let v155 = (v617 == bitcast<f32>(bits_7f800000));
      let v635 = r2[0u][2u];
      let v636 = bitcast<f32>(v635);
      let v157 = (v617 + -1.0f);
      let v158 = (v157 / v617);
      let v159 = (v158 * v636);
      let v160 = select(v159, v636, v155);
      let v161 = (v160 > -1048576.0f);
      let v162 = select(-1048576.0f, v160, v161);
      let v163 = (v162 < 1048576.0f);
      let v164 = select(1048576.0f, v162, v163);
      let v165 = (v164 + 12582912.0f);
      let v166 = bitcast<u32>(v165);
      let v167 = (v166 + 3032481792u);
      let v168 = f32(bitcast<i32>(v167));
      let v169 = (v164 - v168);
      let v170 = (v169 >= 0.5f);
      let v171 = select(0u, 1u, v170);
      let v172 = (v22 + 1u);
      let v173 = (v172 + v167);
      let v174 = (v173 + v171);
      let v637 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v174)));
      let v638 = bitcast<u32>(max(bitcast<i32>(v637), bitcast<i32>(4294967295u)));
      p177 = v638;
    } else {
      p177 = 4294967294u;
    }
    let v177 = p177;
    r1[1u] = v177;
    let v179 = !(v619 < 0.0f);
    if v179 {
      let v180 = (v619 == bitcast<f32>(bits_7f800000));
      let v640 = r2[0u][2u];
      let v641 = bitcast<f32>(v640);
      let v182 = (v619 + -1.0f);
      let v183 = (v182 / v619);
      let v184 = (v183 * v641);
      let v185 = select(v184, v641, v180);
      let v186 = (v185 > -1048576.0f);
      let v187 = select(-1048576.0f, v185, v186);
      let v188 = (v187 < 1048576.0f);
      let v189 = select(1048576.0f, v187, v188);
      let v190 = (v189 + 12582912.0f);
      let v191 = bitcast<u32>(v190);
      let v192 = (v191 + 3032481792u);
      let v193 = f32(bitcast<i32>(v192));
      let v194 = (v189 - v193);
      let v195 = (v194 >= 0.5f);
      let v196 = select(0u, 1u, v195);
      let v197 = (v22 + 2u);
      let v198 = (v197 + v192);
      let v199 = (v198 + v196);
      let v642 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v199)));
      let v643 = bitcast<u32>(max(bitcast<i32>(v642), bitcast<i32>(4294967295u)));
      p202 = v643;
    } else {
      p202 = 4294967294u;
    }
    let v202 = p202;
    r1[2u] = v202;
    let v204 = !(v621 < 0.0f);
    if v204 {
      let v205 = (v621 == bitcast<f32>(bits_7f800000));
      let v645 = r2[0u][2u];
      let v646 = bitcast<f32>(v645);
      let v207 = (v621 + -1.0f);
      let v208 = (v207 / v621);
      let v209 = (v208 * v646);
      let v210 = select(v209, v646, v205);
      let v211 = (v210 > -1048576.0f);
      let v212 = select(-1048576.0f, v210, v211);
      let v213 = (v212 < 1048576.0f);
      let v214 = select(1048576.0f, v212, v213);
      let v215 = (v214 + 12582912.0f);
      let v216 = bitcast<u32>(v215);
      let v217 = (v216 + 3032481792u);
      let v218 = f32(bitcast<i32>(v217));
      let v219 = (v214 - v218);
      let v220 = (v219 >= 0.5f);
      let v221 = select(0u, 1u, v220);
      let v222 = (v22 + 3u);
      let v223 = (v222 + v217);
      let v224 = (v223 + v221);
      let v647 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v224)));
      let v648 = bitcast<u32>(max(bitcast<i32>(v647), bitcast<i32>(4294967295u)));
      p227 = v648;
    } else {
      p227 = 4294967294u;
    }
    let v227 = p227;
    r1[3u] = v227;
    let v229 = !(v623 < 0.0f);
    if v229 {
      let v230 = (v623 == bitcast<f32>(bits_7f800000));
      let v650 = r2[0u][2u];
      let v651 = bitcast<f32>(v650);
      let v232 = (v623 + -1.0f);
      let v233 = (v232 / v623);
      let v234 = (v233 * v651);
      let v235 = select(v234, v651, v230);
      let v236 = (v235 > -1048576.0f);
      let v237 = select(-1048576.0f, v235, v236);
      let v238 = (v237 < 1048576.0f);
      let v239 = select(1048576.0f, v237, v238);
      let v240 = (v239 + 12582912.0f);
      let v241 = bitcast<u32>(v240);
      let v242 = (v241 + 3032481792u);
      let v243 = f32(bitcast<i32>(v242));
      let v244 = (v239 - v243);
      let v245 = (v244 >= 0.5f);
      let v246 = select(0u, 1u, v245);
      let v247 = (v22 + 4u);
      let v248 = (v247 + v242);
      let v249 = (v248 + v246);
      let v652 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v249)));
      let v653 = bitcast<u32>(max(bitcast<i32>(v652), bitcast<i32>(4294967295u)));
      p252 = v653;
    } else {
      p252 = 4294967294u;
    }
    let v252 = p252;
    r1[4u] = v252;
    let v254 = !(v625 < 0.0f);
    if v254 {
      let v255 = (v625 == bitcast<f32>(bits_7f800000));
      let v655 = r2[0u][2u];
      let v656 = bitcast<f32>(v655);
      let v257 = (v625 + -1.0f);
      let v258 = (v257 / v625);
      let v259 = (v258 * v656);
      let v260 = select(v259, v656, v255);
      let v261 = (v260 > -1048576.0f);
      let v262 = select(-1048576.0f, v260, v261);
      let v263 = (v262 < 1048576.0f);
      let v264 = select(1048576.0f, v262, v263);
      let v265 = (v264 + 12582912.0f);
      let v266 = bitcast<u32>(v265);
      let v267 = (v266 + 3032481792u);
      let v268 = f32(bitcast<i32>(v267));
      let v269 = (v264 - v268);
      let v270 = (v269 >= 0.5f);
      let v271 = select(0u, 1u, v270);
      let v272 = (v22 + 5u);
      let v273 = (v272 + v267);
      let v274 = (v273 + v271);
      let v657 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v274)));
      let v658 = bitcast<u32>(max(bitcast<i32>(v657), bitcast<i32>(4294967295u)));
      p277 = v658;
    } else {
      p277 = 4294967294u;
    }
    let v277 = p277;
    r1[5u] = v277;
    let v279 = !(v627 < 0.0f);
    if v279 {
      let v280 = (v627 == bitcast<f32>(bits_7f800000));
      let v660 = r2[0u][2u];
      let v661 = bitcast<f32>(v660);
      let v282 = (v627 + -1.0f);
      let v283 = (v282 / v627);
      let v284 = (v283 * v661);
      let v285 = select(v284, v661, v280);
      let v286 = (v285 > -1048576.0f);
      let v287 = select(-1048576.0f, v285, v286);
      let v288 = (v287 < 1048576.0f);
      let v289 = select(1048576.0f, v287, v288);
      let v290 = (v289 + 12582912.0f);
      let v291 = bitcast<u32>(v290);
      let v292 = (v291 + 3032481792u);
      let v293 = f32(bitcast<i32>(v292));
      let v294 = (v289 - v293);
      let v295 = (v294 >= 0.5f);
      let v296 = select(0u, 1u, v295);
      let v297 = (v22 + 6u);
      let v298 = (v297 + v292);
      let v299 = (v298 + v296);
      let v662 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v299)));
      let v663 = bitcast<u32>(max(bitcast<i32>(v662), bitcast<i32>(4294967295u)));
      p302 = v663;
    } else {
      p302 = 4294967294u;
    }
    let v302 = p302;
    r1[6u] = v302;
    let v304 = !(v629 < 0.0f);
    if v304 {
      let v305 = (v629 == bitcast<f32>(bits_7f800000));
      let v665 = r2[0u][2u];
      let v666 = bitcast<f32>(v665);
      let v307 = (v629 + -1.0f);
      let v308 = (v307 / v629);
      let v309 = (v308 * v666);
      let v310 = select(v309, v666, v305);
      let v311 = (v310 > -1048576.0f);
      let v312 = select(-1048576.0f, v310, v311);
      let v313 = (v312 < 1048576.0f);
      let v314 = select(1048576.0f, v312, v313);
      let v315 = (v314 + 12582912.0f);
      let v316 = bitcast<u32>(v315);
      let v317 = (v316 + 3032481792u);
      let v318 = f32(bitcast<i32>(v317));
      let v319 = (v314 - v318);
      let v320 = (v319 >= 0.5f);
      let v321 = select(0u, 1u, v320);
      let v322 = (v22 + 7u);
      let v323 = (v322 + v317);
      let v324 = (v323 + v321);
      let v667 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v324)));
      let v668 = bitcast<u32>(max(bitcast<i32>(v667), bitcast<i32>(4294967295u)));
      p327 = v668;
    } else {
      p327 = 4294967294u;
    }
    let v327 = p327;
    r1[7u] = v327;
    let v329 = (v22 < v26);
    if v329 {
      p331 = v22;
      var done2 = false;
      loop {
        if done2 { break; }
        let v331 = p331;
        let v332 = (v331 - v22);
        let v670 = r1[v332];
        let v337 = (v670 == 4294967294u);
        if v337 {
          let v345 = (v331 + 1u);
          let v346 = (v345 == v26);
          p338 = v345;
          p330 = v26;
          p340 = v346;
        } else {
          p330 = v331;
          p340 = true;
        }
        let v338 = p338;
        let v340 = p340;
        p331 = v338;
        done2 = v340;
      }
    } else {
      p330 = v22;
    }
    let v330 = p330;
    let v341 = (v330 == v26);
    let v342 = (v26 < v536);
    let v343 = (v342 & v341);
    let v344 = (v343 != true);
    if v344 {
      let v348 = (v536 * v530);
      p350 = v22;
      var done3 = false;
      loop {
        if done3 { break; }
        let v350 = p350;
        let v351 = (v350 != 0u);
        if v351 {
          let v352 = (v350 + 4294967295u);
          let v353 = (v352 < v536);
          let v354 = (v353 != true);
          if v353 {
            let v671 = r2[0u][3u];
            let v362 = (v671 == 0u);
            let v363 = (v536 - v350);
            let v364 = select(v363, v352, v362);
            let v365 = (v364 + v348);
            let v672 = (v365 * 2u);
            let v673 = r3[v672];
            let v674 = bitcast<f32>(v673);
            let v370 = (v674 < 0.0f);
            p694 = false;
            p697 = v674;
            p394 = 4294967294u;
            p395 = v370;
          } else {
            p694 = true;
            p394 = v536;
            p395 = v354;
          }
          let v394 = p394;
          let v395 = p395;
          if v395 {
            let v396 = (v394 != 4294967294u);
            p694 = true;
            p399 = v394;
            p360 = v396;
          } else {
            p399 = 4294967295u;
            p360 = true;
          }
          p355 = v352;
          p696 = v352;
        } else {
          p694 = true;
          p399 = 4294967295u;
          p360 = true;
        }
        let v355 = p355;
        let v360 = p360;
        p350 = v355;
        done3 = v360;
      }
      let v694 = p694;
      let v696 = p696;
      let v697 = p697;
      let v487 = (v694 != true);
      if v487 {
        let v371 = (v697 == bitcast<f32>(bits_7f800000));
        let v675 = r2[0u][2u];
        let v676 = bitcast<f32>(v675);
        let v373 = (v697 + -1.0f);
        let v374 = (v373 / v697);
        let v375 = (v374 * v676);
        let v376 = select(v375, v676, v371);
        let v377 = (v376 > -1048576.0f);
        let v378 = select(-1048576.0f, v376, v377);
        let v379 = (v378 < 1048576.0f);
        let v380 = select(1048576.0f, v378, v379);
        let v381 = (v380 + 12582912.0f);
        let v382 = bitcast<u32>(v381);
        let v383 = (v382 + 3032481792u);
        let v384 = f32(bitcast<i32>(v383));
        let v385 = (v380 - v384);
        let v386 = (v385 >= 0.5f);
        let v387 = select(0u, 1u, v386);
        let v388 = (v383 + v696);
        let v389 = (v388 + v387);
        let v677 = bitcast<u32>(min(bitcast<i32>(v536), bitcast<i32>(v389)));
        let v678 = bitcast<u32>(max(bitcast<i32>(v677), bitcast<i32>(4294967295u)));
        p397 = v678;
        p398 = false;
      } else {
        p398 = true;
      }
      let v397 = p397;
      let v398 = p398;
      if !v398 {
        p399 = v397;
      }
      let v399 = p399;
      let v400 = (v330 < v26);
      if v400 {
        p412 = v399;
        p413 = v330;
        var done4 = false;
        loop {
          if done4 { break; }
          let v412 = p412;
          let v413 = p413;
          let v414 = (v413 - v22);
          let v679 = r1[v414];
          let v419 = (v679 != 4294967294u);
          if v419 {
            let v438 = (v412 + 1u);
            let v680 = r2[2u][0u];
            let v440 = (v680 != 0u);
            let v441 = (bitcast<i32>(v438) < bitcast<i32>(v679));
            let v442 = (v441 & v440);
            if v442 {
              let v444 = (bitcast<i32>(v679) < bitcast<i32>(v536));
              let v445 = select(0u, 1u, v444);
              p447 = v445;
            } else {
              p447 = 0u;
            }
            let v447 = p447;
            let v448 = (v447 + v679);
            let v449 = (bitcast<i32>(v438) < bitcast<i32>(v448));
            if v449 {
              let v450 = (v413 + 1u);
              p451 = v438;
              var done5 = false;
              loop {
                if done5 { break; }
                let v451 = p451;
                let v683 = r2[0u][3u];
                let v455 = (v683 == 0u);
                let v456 = (v451 ^ 4294967295u);
                let v457 = (v536 + v456);
                let v458 = select(v457, v451, v455);
                let v459 = (v458 + v348);
                let v684 = atomicMax(&r5[v459], v450);
                let v464 = (v451 + 1u);
                let v465 = (v464 == v448);
                p451 = v464;
                done5 = v465;
              }
            }
            let v467 = (v679 < v536);
            if v467 {
              let v686 = r2[0u][3u];
              let v470 = (v686 == 0u);
              let v471 = (v679 ^ 4294967295u);
              let v472 = (v536 + v471);
              let v473 = select(v472, v679, v470);
              let v474 = (v473 + v348);
              let v475 = (v474 * v538);
              let v476 = (v413 % v538);
              let v477 = (v475 + v476);
              let v481 = (v413 + 1u);
              if v31 {
                atomicStore(&r4[v477], v481);
                p482 = false;
              } else {
                p482 = true;
              }
              let v482 = p482;
              if v482 {
                let v688 = atomicMax(&r4[v477], v481);
              }
            }
            p446 = v679;
          } else {
            p446 = v412;
          }
          let v446 = p446;
          let v436 = (v413 + 1u);
          let v437 = (v436 == v26);
          p412 = v446;
          p413 = v436;
          p410 = v446;
          done4 = v437;
        }
      } else {
        p410 = v399;
      }
      let v410 = p410;
      let v405 = (v26 == v536);
      if v405 {
        let v406 = (v410 + 1u);
        let v407 = (bitcast<i32>(v406) < bitcast<i32>(v26));
        if v407 {
          let v409 = (v26 + 1u);
          p420 = v406;
          p421 = v410;
          var done6 = false;
          loop {
            if done6 { break; }
            let v420 = p420;
            let v421 = p421;
            let v691 = r2[0u][3u];
            let v425 = (v691 == 0u);
            let v426 = (v536 - v421);
            let v427 = (v426 + 4294967294u);
            let v428 = select(v427, v420, v425);
            let v429 = (v428 + v348);
            let v692 = atomicMax(&r5[v429], v409);
            let v434 = (v420 + 1u);
            let v435 = (v434 == v26);
            p420 = v434;
            p421 = v420;
            done6 = v435;
          }
        }
      }
    }
  }
  return;
}
