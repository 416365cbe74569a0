@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 1>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read> r2: array<vec4<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<u32>;
@group(0) @binding(4) var<storage, read_write> r4: array<vec4<u32>>;
@compute @workgroup_size(8, 8, 1)
fn average(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p143: f32;
  var p144: u32;
  var p145: f32;
  var p146: f32;
  var p147: f32;
  var p235: u32;
  var p154: u32;
  var p155: f32;
  var p156: f32;
  var p157: f32;
  var p226: f32;
  var p227: f32;
  var p228: f32;
  var p800: f32;
  var p801: f32;
  var p802: f32;
  var p231: f32;
  var p232: f32;
  var p233: f32;
  var p234: bool;
  var p253: u32;
  var p264: u32;
  var p265: f32;
  var p266: f32;
  var p267: f32;
  var p326: f32;
  var p327: f32;
  var p328: f32;
  var p806: f32;
  var p807: f32;
  var p808: f32;
  var p350: f32;
  var p351: f32;
  var p352: f32;
  var p353: bool;
  var p388: f32;
  var p389: f32;
  var p390: f32;
  var p391: bool;
  var p339: f32;
  var p340: f32;
  var p341: f32;
  var p31: bool;
  var p41: u32;
  var p51: u32;
  var p52: f32;
  var p53: f32;
  var p54: f32;
  var p815: f32;
  var p816: f32;
  var p817: f32;
  var p38: f32;
  var p39: f32;
  var p40: f32;
  var p69: f32;
  var p70: f32;
  var p71: f32;
  var p72: u32;
  var p442: u32;
  var p449: u32;
  var p450: u32;
  var p451: u32;
  var p452: u32;
  var p453: u32;
  var p475: u32;
  var p476: u32;
  var p477: u32;
  var p478: u32;
  var p821: u32;
  var p822: u32;
  var p823: u32;
  var p824: u32;
  var p483: u32;
  var p484: u32;
  var p485: u32;
  var p486: u32;
  let v534 = global_invocation_id[0u];
  let v535 = global_invocation_id[1u];
  let v541 = r0[0u][0u];
  let v16 = (v534 < v541);
  if v16 {
    let v542 = r0[0u][1u];
    let v19 = (v535 < v542);
    if v19 {
      let v20 = (v541 * v535);
      let v21 = (v20 + v534);
      let v543 = r0[0u][3u];
      let v24 = (v543 != 0u);
      let v544 = r0[0u][2u];
      if v24 {
        let v76 = (v544 != 0u);
        if v76 {
          let v77 = (v544 * v541);
          let v78 = (v77 + v543);
          let v79 = (v544 * v534);
          let v80 = (v544 * v535);
          let v83 = (v80 + v544);
          let v84 = (v83 * v78);
          let v85 = (v80 * v78);
          let v86 = (v79 + v85);
          let v87 = (v79 + v544);
          let v88 = (v87 + v85);
          let v89 = (v79 + v84);
          let v90 = (v87 + v84);
          p143 = 0.25f;
          p144 = v544;
          p145 = 0.0f;
          p146 = 0.0f;
          p147 = 0.0f;
          var done0 = false;
          loop {
            if done0 { break; }
            let v143 = p143;
            let v144 = p144;
            let v145 = p145;
            let v146 = p146;
            let v147 = p147;
            let v148 = (v144 != v544);
            let v149 = (v144 * 4294967294u);
            let v150 = (v144 != 1u);
            let v151 = (v144 >> (1u & 31u));
            if v148 {
              if v150 {
                p235 = 0u;
                p155 = 0.0f;
                p156 = 0.0f;
                p157 = 0.0f;
                var done1 = false;
                loop {
                  if done1 { break; }
                  let v235 = p235;
                  let v239 = (v235 + v80);
                  let v240 = (v239 & v149);
                  let v241 = (v240 + v144);
                  let v242 = (v241 * v78);
                  let v243 = (v242 + v144);
                  let v244 = (v239 + v151);
                  let v245 = (v244 * v78);
                  let v246 = (v245 + v151);
                  let v247 = (v239 * v78);
                  let v248 = (v239 + v144);
                  let v249 = (v248 * v78);
                  p154 = 0u;
                  var done2 = false;
                  loop {
                    if done2 { break; }
                    let v154 = p154;
                    let v155 = p155;
                    let v156 = p156;
                    let v157 = p157;
                    let v158 = (v154 + v79);
                    let v159 = (v158 & v149);
                    let v160 = (v243 + v159);
                    let v545 = r1[v160];
                    let v165 = (v545 & 4294901760u);
                    let v166 = (v165 != 458752u);
                    if v166 {
                      let v167 = (v246 + v158);
                      let v546 = r1[v167];
                      let v172 = (v546 & 4294901760u);
                      let v173 = (v172 == 458752u);
                      if v173 {
                        let v174 = (v158 + v247);
                        let v175 = (v158 + v144);
                        let v176 = (v175 + v247);
                        let v177 = (v158 + v249);
                        let v178 = (v175 + v249);
                        let v547 = (v174 * 2u);
                        let v548 = r2[v547];
                        let v549 = v548[0u];
                        let v550 = bitcast<f32>(v549);
                        let v553 = v548[1u];
                        let v554 = bitcast<f32>(v553);
                        let v557 = v548[2u];
                        let v558 = bitcast<f32>(v557);
                        let v559 = (v176 * 2u);
                        let v560 = r2[v559];
                        let v561 = v560[0u];
                        let v562 = bitcast<f32>(v561);
                        let v565 = v560[1u];
                        let v566 = bitcast<f32>(v565);
                        let v569 = v560[2u];
                        let v570 = bitcast<f32>(v569);
                        let v571 = (v177 * 2u);
                        let v572 = r2[v571];
                        let v573 = v572[0u];
                        let v574 = bitcast<f32>(v573);
                        let v577 = v572[1u];
                        let v578 = bitcast<f32>(v577);
                        let v581 = v572[2u];
                        let v582 = bitcast<f32>(v581);
                        let v583 = (v178 * 2u);
                        let v584 = r2[v583];
                        let v585 = v584[0u];
                        let v586 = bitcast<f32>(v585);
                        let v589 = v584[1u];
                        let v590 = bitcast<f32>(v589);
                        let v593 = v584[2u];
                        let v594 = bitcast<f32>(v593);
                        let v211 = (v550 + v562);
                        let v212 = (v554 + v566);
                        let v213 = (v558 + v570);
                        let v214 = (v574 + v586);
                        let v215 = (v578 + v590);
                        let v216 = (v582 + v594);
                        let v217 = (v211 + v214);
                        let v218 = (v212 + v215);
                        let v219 = (v213 + v216);
                        let v220 = (v157 + v217);
                        let v221 = (v156 + v218);
                        let v222 = (v155 + v219);
                        p228 = v222;
                        p227 = v221;
                        p226 = v220;
                      } else {
                        p228 = v155;
                        p227 = v156;
                        p226 = v157;
                      }
                    } else {
                      p226 = v157;
                      p227 = v156;
                      p228 = v155;
                    }
                    let v226 = p226;
                    let v227 = p227;
                    let v228 = p228;
                    let v229 = (v154 + v144);
                    let v230 = (v229 >= v544);
                    p154 = v229;
                    p155 = v228;
                    p156 = v227;
                    p157 = v226;
                    p800 = v226;
                    p801 = v227;
                    p802 = v228;
                    done2 = v230;
                  }
                  let v800 = p800;
                  let v801 = p801;
                  let v802 = p802;
                  let v152 = (v235 + v144);
                  let v153 = (v152 >= v544);
                  p235 = v152;
                  p155 = v802;
                  p156 = v801;
                  p157 = v800;
                  p233 = v800;
                  p232 = v801;
                  p231 = v802;
                  done1 = v153;
                }
                p234 = false;
              } else {
                p234 = true;
              }
              let v231 = p231;
              let v232 = p232;
              let v233 = p233;
              let v234 = p234;
              if v234 {
                p253 = 0u;
                p265 = 0.0f;
                p266 = 0.0f;
                p267 = 0.0f;
                var done3 = false;
                loop {
                  if done3 { break; }
                  let v253 = p253;
                  let v257 = (v253 + v80);
                  let v258 = (v257 | 1u);
                  let v259 = (v258 * v78);
                  let v260 = (v259 + 1u);
                  let v261 = (v257 * v78);
                  let v262 = (v257 + 1u);
                  let v263 = (v262 * v78);
                  p264 = 0u;
                  var done4 = false;
                  loop {
                    if done4 { break; }
                    let v264 = p264;
                    let v265 = p265;
                    let v266 = p266;
                    let v267 = p267;
                    let v268 = (v264 + v79);
                    let v269 = (v268 & 4294967294u);
                    let v270 = (v260 + v269);
                    let v595 = r1[v270];
                    let v275 = (v595 & 4294901760u);
                    let v276 = (v275 != 458752u);
                    if v276 {
                      let v277 = (v268 + v261);
                      let v278 = (v268 + 1u);
                      let v279 = (v278 + v261);
                      let v280 = (v268 + v263);
                      let v281 = (v278 + v263);
                      let v596 = (v277 * 2u);
                      let v597 = r2[v596];
                      let v598 = v597[0u];
                      let v599 = bitcast<f32>(v598);
                      let v602 = v597[1u];
                      let v603 = bitcast<f32>(v602);
                      let v606 = v597[2u];
                      let v607 = bitcast<f32>(v606);
                      let v608 = (v279 * 2u);
                      let v609 = r2[v608];
                      let v610 = v609[0u];
                      let v611 = bitcast<f32>(v610);
                      let v614 = v609[1u];
                      let v615 = bitcast<f32>(v614);
                      let v618 = v609[2u];
                      let v619 = bitcast<f32>(v618);
                      let v620 = (v280 * 2u);
                      let v621 = r2[v620];
                      let v622 = v621[0u];
                      let v623 = bitcast<f32>(v622);
                      let v626 = v621[1u];
                      let v627 = bitcast<f32>(v626);
                      let v630 = v621[2u];
                      let v631 = bitcast<f32>(v630);
                      let v632 = (v281 * 2u);
                      let v633 = r2[v632];
                      let v634 = v633[0u];
                      let v635 = bitcast<f32>(v634);
                      let v638 = v633[1u];
                      let v639 = bitcast<f32>(v638);
                      let v642 = v633[2u];
                      let v643 = bitcast<f32>(v642);
                      let v314 = (v599 + v611);
                      let v315 = (v603 + v615);
                      let v316 = (v607 + v619);
                      let v317 = (v623 + v635);
                      let v318 = (v627 + v639);
                      let v319 = (v631 + v643);
                      let v320 = (v314 + v317);
                      let v321 = (v315 + v318);
                      let v322 = (v316 + v319);
                      let v323 = (v267 + v320);
                      let v324 = (v266 + v321);
                      let v325 = (v265 + v322);
                      p326 = v323;
                      p327 = v324;
                      p328 = v325;
                    } else {
                      p326 = v267;
                      p327 = v266;
                      p328 = v265;
                    }
                    let v326 = p326;
                    let v327 = p327;
                    let v328 = p328;
                    let v329 = (v264 + 1u);
                    let v330 = (v329 >= v544);
                    p264 = v329;
                    p265 = v328;
                    p266 = v327;
                    p267 = v326;
                    p806 = v326;
                    p807 = v327;
                    p808 = v328;
                    done4 = v330;
                  }
                  let v806 = p806;
                  let v807 = p807;
                  let v808 = p808;
                  let v331 = (v253 + 1u);
                  let v332 = (v331 >= v544);
                  p253 = v331;
                  p265 = v808;
                  p266 = v807;
                  p267 = v806;
                  p352 = v806;
                  p351 = v807;
                  p350 = v808;
                  done3 = v332;
                }
              } else {
                p350 = v231;
                p351 = v232;
                p352 = v233;
              }
              p353 = false;
            } else {
              p353 = true;
            }
            let v350 = p350;
            let v351 = p351;
            let v352 = p352;
            let v353 = p353;
            if v353 {
              if v150 {
                let v378 = (v80 + v151);
                let v379 = (v378 * v78);
                let v380 = (v379 + v151);
                let v381 = (v380 + v79);
                let v644 = r1[v381];
                let v386 = (v644 & 4294901760u);
                let v387 = (v386 == 458752u);
                if v387 {
                  let v645 = (v86 * 2u);
                  let v646 = r2[v645];
                  let v647 = v646[0u];
                  let v648 = bitcast<f32>(v647);
                  let v651 = v646[1u];
                  let v652 = bitcast<f32>(v651);
                  let v655 = v646[2u];
                  let v656 = bitcast<f32>(v655);
                  let v657 = (v88 * 2u);
                  let v658 = r2[v657];
                  let v659 = v658[0u];
                  let v660 = bitcast<f32>(v659);
                  let v663 = v658[1u];
                  let v664 = bitcast<f32>(v663);
                  let v667 = v658[2u];
                  let v668 = bitcast<f32>(v667);
                  let v669 = (v89 * 2u);
                  let v670 = r2[v669];
                  let v671 = v670[0u];
                  let v672 = bitcast<f32>(v671);
                  let v675 = v670[1u];
                  let v676 = bitcast<f32>(v675);
                  let v679 = v670[2u];
                  let v680 = bitcast<f32>(v679);
                  let v681 = (v90 * 2u);
                  let v682 = r2[v681];
                  let v683 = v682[0u];
                  let v684 = bitcast<f32>(v683);
                  let v687 = v682[1u];
                  let v688 = bitcast<f32>(v687);
                  let v691 = v682[2u];
                  let v692 = bitcast<f32>(v691);
                  let v366 = (v648 + v660);
                  let v367 = (v652 + v664);
                  let v368 = (v656 + v668);
                  let v369 = (v672 + v684);
                  let v370 = (v676 + v688);
                  let v371 = (v680 + v692);
                  let v372 = (v366 + v369);
                  let v373 = (v367 + v370);
                  let v374 = (v368 + v371);
                  let v788 = (v372 == 0.0f);
                  let v789 = select(v372, 0.0f, v788);
                  let v790 = (v373 == 0.0f);
                  let v791 = select(v373, 0.0f, v790);
                  let v792 = (v374 == 0.0f);
                  let v793 = select(v374, 0.0f, v792);
                  p388 = v793;
                  p389 = v791;
                  p390 = v789;
                } else {
                  p388 = 0.0f;
                  p389 = 0.0f;
                  p390 = 0.0f;
                }
                p391 = false;
              } else {
                p391 = true;
              }
              let v388 = p388;
              let v389 = p389;
              let v390 = p390;
              let v391 = p391;
              if v391 {
                let v693 = (v86 * 2u);
                let v694 = r2[v693];
                let v695 = v694[0u];
                let v696 = bitcast<f32>(v695);
                let v699 = v694[1u];
                let v700 = bitcast<f32>(v699);
                let v703 = v694[2u];
                let v704 = bitcast<f32>(v703);
                let v705 = (v88 * 2u);
                let v706 = r2[v705];
                let v707 = v706[0u];
                let v708 = bitcast<f32>(v707);
                let v711 = v706[1u];
                let v712 = bitcast<f32>(v711);
                let v715 = v706[2u];
                let v716 = bitcast<f32>(v715);
                let v717 = (v89 * 2u);
                let v718 = r2[v717];
                let v719 = v718[0u];
                let v720 = bitcast<f32>(v719);
                let v723 = v718[1u];
                let v724 = bitcast<f32>(v723);
                let v727 = v718[2u];
                let v728 = bitcast<f32>(v727);
                let v401 = (v704 + v716);
                let v729 = (v90 * 2u);
                let v730 = r2[v729];
                let v731 = v730[2u];
                let v732 = bitcast<f32>(v731);
                let v403 = (v728 + v732);
                let v404 = (v401 + v403);
                let v794 = (v404 == 0.0f);
                let v795 = select(v404, 0.0f, v794);
                let v406 = (v700 + v712);
                let v735 = v730[1u];
                let v736 = bitcast<f32>(v735);
                let v408 = (v724 + v736);
                let v409 = (v406 + v408);
                let v796 = (v409 == 0.0f);
                let v797 = select(v409, 0.0f, v796);
                let v411 = (v696 + v708);
                let v739 = v730[0u];
                let v740 = bitcast<f32>(v739);
                let v413 = (v720 + v740);
                let v414 = (v411 + v413);
                let v798 = (v414 == 0.0f);
                let v799 = select(v414, 0.0f, v798);
                p341 = v795;
                p340 = v797;
                p339 = v799;
              } else {
                p341 = v388;
                p340 = v389;
                p339 = v390;
              }
            } else {
              p339 = v352;
              p340 = v351;
              p341 = v350;
            }
            let v339 = p339;
            let v340 = p340;
            let v341 = p341;
            let v342 = (v143 * v339);
            let v343 = (v143 * v340);
            let v344 = (v143 * v341);
            let v345 = (v145 + v342);
            let v346 = (v146 + v343);
            let v347 = (v147 + v344);
            let v348 = (v143 * 0.25f);
            let v349 = (v151 == 0u);
            p143 = v348;
            p144 = v151;
            p145 = v345;
            p146 = v346;
            p147 = v347;
            p69 = v345;
            p70 = v346;
            p71 = v347;
            done0 = v349;
          }
          p72 = v544;
        } else {
          p69 = 0.0f;
          p70 = 0.0f;
          p71 = 0.0f;
          p72 = 0u;
        }
        p31 = false;
      } else {
        p31 = true;
      }
      let v31 = p31;
      if v31 {
        let v32 = (v544 * v544);
        let v33 = f32(v32);
        let v34 = (1.0f / v33);
        let v35 = (v544 != 0u);
        if v35 {
          let v36 = (v544 * v535);
          p41 = 0u;
          p52 = 0.0f;
          p53 = 0.0f;
          p54 = 0.0f;
          var done5 = false;
          loop {
            if done5 { break; }
            let v41 = p41;
            let v45 = (v41 + v36);
            let v46 = (v45 * v541);
            let v47 = (v46 + v534);
            let v48 = (v47 * v544);
            p51 = 0u;
            var done6 = false;
            loop {
              if done6 { break; }
              let v51 = p51;
              let v52 = p52;
              let v53 = p53;
              let v54 = p54;
              let v55 = (v51 + v48);
              let v741 = (v55 * 2u);
              let v742 = r2[v741];
              let v743 = v742[0u];
              let v744 = bitcast<f32>(v743);
              let v747 = v742[1u];
              let v748 = bitcast<f32>(v747);
              let v751 = v742[2u];
              let v752 = bitcast<f32>(v751);
              let v64 = (v54 + v744);
              let v65 = (v53 + v748);
              let v66 = (v52 + v752);
              let v67 = (v51 + 1u);
              let v68 = (v67 == v544);
              p51 = v67;
              p52 = v66;
              p53 = v65;
              p54 = v64;
              p815 = v64;
              p816 = v65;
              p817 = v66;
              done6 = v68;
            }
            let v815 = p815;
            let v816 = p816;
            let v817 = p817;
            let v49 = (v41 + 1u);
            let v50 = (v49 == v544);
            p41 = v49;
            p52 = v817;
            p53 = v816;
            p54 = v815;
            p40 = v815;
            p39 = v816;
            p38 = v817;
            done5 = v50;
          }
        } else {
          p38 = 0.0f;
          p39 = 0.0f;
          p40 = 0.0f;
        }
        let v38 = p38;
        let v39 = p39;
        let v40 = p40;
        let v73 = (v34 * v40);
        let v74 = (v34 * v39);
        let v75 = (v34 * v38);
        p69 = v73;
        p70 = v74;
        p71 = v75;
        p72 = v544;
      }
      let v69 = p69;
      let v70 = p70;
      let v71 = p71;
      let v72 = p72;
      let v753 = bitcast<u32>(v69);
      let v754 = (v21 * 4u);
      r3[v754] = v753;
      let v756 = bitcast<u32>(v70);
      let v758 = (v754 + 1u);
      r3[v758] = v756;
      let v760 = bitcast<u32>(v71);
      let v762 = (v754 + 2u);
      r3[v762] = v760;
      let v765 = (v754 + 3u);
      r3[v765] = 1065353216u;
      let v421 = (v534 + 1u);
      let v422 = (v421 == v541);
      let v423 = select(0u, v543, v422);
      let v424 = (v72 + v423);
      let v425 = (v535 + 1u);
      let v426 = (v425 == v542);
      let v427 = select(0u, v543, v426);
      let v428 = (v72 + v427);
      let v429 = (v72 * v541);
      let v430 = (v429 + v543);
      let v431 = (v430 * v535);
      let v432 = (v431 + v534);
      let v433 = (v432 * v72);
      let v434 = (v428 != 0u);
      if v434 {
        let v435 = (v424 != 0u);
        if v435 {
          p442 = 0u;
          p450 = 0u;
          p451 = 0u;
          p452 = 0u;
          p453 = 0u;
          var done7 = false;
          loop {
            if done7 { break; }
            let v442 = p442;
            let v447 = (v442 * v430);
            let v448 = (v447 + v433);
            p449 = 0u;
            var done8 = false;
            loop {
              if done8 { break; }
              let v449 = p449;
              let v450 = p450;
              let v451 = p451;
              let v452 = p452;
              let v453 = p453;
              let v454 = (v448 + v449);
              let v767 = r1[v454];
              let v459 = (v767 & 4294901760u);
              let v460 = (v459 != 458752u);
              if v460 {
                let v768 = (v454 * 2u);
                let v769 = (v768 + 1u);
                let v770 = r2[v769];
                let v771 = v770[0u];
                let v775 = v770[1u];
                let v779 = v770[2u];
                let v783 = v770[3u];
                let v471 = (v771 + v450);
                let v472 = (v775 + v451);
                let v473 = (v779 + v452);
                let v474 = (v783 + v453);
                p475 = v474;
                p476 = v473;
                p477 = v472;
                p478 = v471;
              } else {
                p475 = v453;
                p476 = v452;
                p477 = v451;
                p478 = v450;
              }
              let v475 = p475;
              let v476 = p476;
              let v477 = p477;
              let v478 = p478;
              let v479 = (v449 + 1u);
              let v480 = (v479 == v424);
              p449 = v479;
              p450 = v478;
              p451 = v477;
              p452 = v476;
              p453 = v475;
              p821 = v475;
              p822 = v476;
              p823 = v477;
              p824 = v478;
              done8 = v480;
            }
            let v821 = p821;
            let v822 = p822;
            let v823 = p823;
            let v824 = p824;
            let v481 = (v442 + 1u);
            let v482 = (v481 == v428);
            p442 = v481;
            p450 = v824;
            p451 = v823;
            p452 = v822;
            p453 = v821;
            p483 = v821;
            p484 = v822;
            p485 = v823;
            p486 = v824;
            done7 = v482;
          }
        } else {
          p486 = 0u;
          p485 = 0u;
          p484 = 0u;
          p483 = 0u;
        }
      } else {
        p483 = 0u;
        p484 = 0u;
        p485 = 0u;
        p486 = 0u;
      }
      let v483 = p483;
      let v484 = p484;
      let v485 = p485;
      let v486 = p486;
      r4[v21] = vec4<u32>(v486, v485, v484, v483);
    }
  }
  return;
}
