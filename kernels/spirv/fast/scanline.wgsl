@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 3>;
struct Push { w0: u32 }
var<immediate> r3: Push;
@group(0) @binding(1) var<storage, read> r4: array<u32>;
@group(0) @binding(2) var<storage, read_write> r5: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r6: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p40: u32;
  var p41: u32;
  var p48: u32;
  var p49: u32;
  var p50: u32;
  var p51: u32;
  var p66: bool;
  var p112: u32;
  var p55: f32;
  var p56: f32;
  var p57: f32;
  var p58: f32;
  var p59: f32;
  var p60: f32;
  var p61: f32;
  var p64: bool;
  var p566: u32;
  var p567: u32;
  var p134: f32;
  var p135: f32;
  var p136: f32;
  var p137: f32;
  var p138: f32;
  var p139: f32;
  var p140: f32;
  var p141: bool;
  var p144: f32;
  var p145: bool;
  var p167: u32;
  var p191: u32;
  var p215: u32;
  var p239: u32;
  var p263: u32;
  var p287: u32;
  var p311: u32;
  var p335: u32;
  var p340: u32;
  var p448: u32;
  var p449: bool;
  var p450: bool;
  var p640: bool;
  var p348: bool;
  var p337: u32;
  var p339: bool;
  var p356: bool;
  var p358: bool;
  var p368: u32;
  var p369: u32;
  var p402: u32;
  var p406: u32;
  var p401: u32;
  var p366: u32;
  var p376: u32;
  var p377: u32;
  var p442: u32;
  var p443: u32;
  var p444: bool;
  let v485 = global_invocation_id[0u];
  let v491 = r3.w0;
  let v19 = (v491 != 0u);
  if v19 {
    let v20 = (v491 * v485);
    p40 = v20;
    p41 = v491;
    var done0 = false;
    loop {
      if done0 { break; }
      let v40 = p40;
      let v41 = p41;
      let v492 = r2[0u][1u];
      let v43 = (v40 < v492);
      if v43 {
        let v493 = r2[0u][0u];
        let v45 = (v493 != 0u);
        if v45 {
          let v494 = min(v493, 8u);
          p48 = 0u;
          p49 = 0u;
          p50 = v494;
          p51 = 4294967295u;
          var done1 = false;
          loop {
            if done1 { break; }
            let v48 = p48;
            let v49 = p49;
            let v50 = p50;
            let v51 = p51;
            r0[0u] = 0u;
            r0[1u] = 0u;
            r0[2u] = 0u;
            r0[3u] = 0u;
            r0[4u] = 0u;
            r0[5u] = 0u;
            r0[6u] = 0u;
            r0[7u] = 0u;
            let v52 = (v50 - v49);
            let v53 = (v52 != 8u);
            if v53 {
              let v54 = (v49 >= v50);
              if v54 {
                p145 = true;
                p66 = false;
              } else {
                p145 = false;
                p66 = true;
              }
              let v66 = p66;
              if v66 {
                let v67 = (v493 * v40);
                let v503 = r2[0u][3u];
                let v69 = (v503 == 0u);
                p112 = v49;
                var done2 = false;
                loop {
                  if done2 { break; }
                  let v112 = p112;
                  let v113 = (v112 - v49);
                  let v114 = (v112 ^ 4294967295u);
                  let v115 = (v493 + v114);
                  let v116 = select(v115, v112, v69);
                  let v117 = (v116 + v67);
                  let v504 = (v117 * 2u);
                  let v505 = r4[v504];
                  r0[v113] = v505;
                  let v124 = (v112 + 1u);
                  let v125 = (v124 == v50);
                  p112 = v124;
                  done2 = v125;
                }
                let v508 = r0[1u];
                let v509 = bitcast<f32>(v508);
                let v510 = r0[2u];
                let v511 = bitcast<f32>(v510);
                let v512 = r0[3u];
                let v513 = bitcast<f32>(v512);
                let v514 = r0[4u];
                let v515 = bitcast<f32>(v514);
                let v516 = r0[5u];
                let v517 = bitcast<f32>(v516);
                let v518 = r0[6u];
                let v519 = bitcast<f32>(v518);
                let v520 = r0[7u];
                let v521 = bitcast<f32>(v520);
                p55 = v509;
                p56 = v511;
                p57 = v513;
                p58 = v515;
                p59 = v517;
                p60 = v519;
                p61 = v521;
                p141 = true;
              } else {
                p55 = 0.0f;
                p56 = 0.0f;
                p57 = 0.0f;
                p58 = 0.0f;
                p59 = 0.0f;
                p60 = 0.0f;
                p61 = 0.0f;
                p141 = false;
              }
              p64 = false;
            } else {
              p145 = false;
              p141 = false;
              p64 = true;
            }
            let v55 = p55;
            let v56 = p56;
            let v57 = p57;
            let v58 = p58;
            let v59 = p59;
            let v60 = p60;
            let v61 = p61;
            let v64 = p64;
            if v64 {
              let v522 = r2[0u][3u];
              let v71 = (v522 == 0u);
              let v72 = (v50 + 4294967295u);
              let v523 = select(7u, 0u, v71);
              let v74 = select(v72, v49, v71);
              let v75 = (v493 * v40);
              let v76 = (v74 ^ 4294967295u);
              let v77 = (v493 + v76);
              let v78 = select(v77, v49, v71);
              let v79 = (v78 + v75);
              let v524 = (v523 ^ 1u);
              let v525 = (v79 * 2u);
              let v526 = (v524 * 2u);
              let v527 = (v525 + v526);
              let v528 = r4[v527];
              let v529 = bitcast<f32>(v528);
              let v530 = (v523 ^ 2u);
              let v532 = (v530 * 2u);
              let v533 = (v525 + v532);
              let v534 = r4[v533];
              let v535 = bitcast<f32>(v534);
              let v536 = (v523 ^ 3u);
              let v538 = (v536 * 2u);
              let v539 = (v525 + v538);
              let v540 = r4[v539];
              let v541 = bitcast<f32>(v540);
              let v542 = (v523 ^ 4u);
              let v544 = (v542 * 2u);
              let v545 = (v525 + v544);
              let v546 = r4[v545];
              let v547 = bitcast<f32>(v546);
              let v548 = (v523 ^ 5u);
              let v550 = (v548 * 2u);
              let v551 = (v525 + v550);
              let v552 = r4[v551];
              let v553 = bitcast<f32>(v552);
              let v554 = (v523 ^ 6u);
              let v556 = (v554 * 2u);
              let v557 = (v525 + v556);
              let v558 = r4[v557];
              let v559 = bitcast<f32>(v558);
              let v560 = (v523 ^ 7u);
              let v562 = (v560 * 2u);
              let v563 = (v525 + v562);
              let v564 = r4[v563];
              let v565 = bitcast<f32>(v564);
              let v637 = (v523 * 2u);
              let v638 = (v525 + v637);
              p566 = v638;
              p567 = 4u;
              p134 = v529;
              p135 = v535;
              p136 = v541;
              p137 = v547;
              p138 = v553;
              p139 = v559;
              p140 = v565;
              p141 = true;
            } else {
              p566 = 0u;
              p567 = 0u;
              p134 = v55;
              p135 = v56;
              p136 = v57;
              p137 = v58;
              p138 = v59;
              p139 = v60;
              p140 = v61;
            }
            let v566 = p566;
            let v567 = p567;
            let v134 = p134;
            let v135 = p135;
            let v136 = p136;
            let v137 = p137;
            let v138 = p138;
            let v139 = p139;
            let v140 = p140;
            let v141 = p141;
            if v141 {
              let v568 = (v566 * 4u);
              let v569 = (v567 == 0u);
              let v570 = select(0u, v568, v569);
              let v571 = (v570 >> (2u & 31u));
              let v572 = r0[v571];
              let v573 = bitcast<f32>(v572);
              let v574 = (v567 == 4u);
              let v575 = select(0u, v568, v574);
              let v576 = (v575 >> (2u & 31u));
              let v577 = r4[v576];
              let v578 = bitcast<f32>(v577);
              let v579 = select(v573, v578, v574);
              let v143 = !(v579 < 0.0f);
              p144 = v579;
              p145 = v143;
            } else {
              p144 = 0.0f;
            }
            let v144 = p144;
            let v145 = p145;
            if v145 {
              let v146 = (v144 == bitcast<f32>(bits_7f800000));
              let v580 = r2[0u][2u];
              let v581 = bitcast<f32>(v580);
              let v148 = (v144 + -1.0f);
              let v149 = (v148 / v144);
              let v150 = (v149 * v581);
              let v151 = select(v150, v581, v146);
              let v152 = (v151 > -1048576.0f);
              let v153 = select(-1048576.0f, v151, v152);
              let v154 = (v153 < 1048576.0f);
              let v155 = select(1048576.0f, v153, v154);
              let v156 = (v155 + 12582912.0f);
              let v157 = bitcast<u32>(v156);
              let v158 = (v157 + 3032481792u);
              let v159 = f32(bitcast<i32>(v158));
              let v160 = (v155 - v159);
              let v161 = (v160 >= 0.5f);
              let v162 = select(0u, 1u, v161);
              let v163 = (v49 + v158);
              let v164 = (v163 + v162);
              let v582 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v164)));
              let v583 = bitcast<u32>(max(bitcast<i32>(v582), bitcast<i32>(4294967295u)));
              p167 = v583;
            } else {
              p167 = 4294967294u;
            }
            let v167 = p167;
            r1[0u] = v167;
            let v168 = !(v134 < 0.0f);
            if v168 {
              let v169 = (v134 == bitcast<f32>(bits_7f800000));
              let v585 = r2[0u][2u];
              let v586 = bitcast<f32>(v585);
              let v171 = (v134 + -1.0f);
              let v172 = (v171 / v134);
              let v173 = (v172 * v586);
              let v174 = select(v173, v586, v169);
              let v175 = (v174 > -1048576.0f);
              let v176 = select(-1048576.0f, v174, v175);
              let v177 = (v176 < 1048576.0f);
              let v178 = select(1048576.0f, v176, v177);
              let v179 = (v178 + 12582912.0f);
              let v180 = bitcast<u32>(v179);
              let v181 = (v180 + 3032481792u);
              let v182 = f32(bitcast<i32>(v181));
              let v183 = (v178 - v182);
              let v184 = (v183 >= 0.5f);
              let v185 = select(0u, 1u, v184);
              let v186 = (v49 + 1u);
              let v187 = (v186 + v181);
              let v188 = (v187 + v185);
              let v587 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v188)));
              let v588 = bitcast<u32>(max(bitcast<i32>(v587), bitcast<i32>(4294967295u)));
              p191 = v588;
            } else {
              p191 = 4294967294u;
            }
            let v191 = p191;
            r1[1u] = v191;
            let v192 = !(v135 < 0.0f);
            if v192 {
              let v193 = (v135 == bitcast<f32>(bits_7f800000));
              let v590 = r2[0u][2u];
              let v591 = bitcast<f32>(v590);
              let v195 = (v135 + -1.0f);
              let v196 = (v195 / v135);
              let v197 = (v196 * v591);
              let v198 = select(v197, v591, v193);
              let v199 = (v198 > -1048576.0f);
              let v200 = select(-1048576.0f, v198, v199);
              let v201 = (v200 < 1048576.0f);
              let v202 = select(1048576.0f, v200, v201);
              let v203 = (v202 + 12582912.0f);
              let v204 = bitcast<u32>(v203);
              let v205 = (v204 + 3032481792u);
              let v206 = f32(bitcast<i32>(v205));
              let v207 = (v202 - v206);
              let v208 = (v207 >= 0.5f);
              let v209 = select(0u, 1u, v208);
              let v210 = (v49 + 2u);
              let v211 = (v210 + v205);
              let v212 = (v211 + v209);
              let v592 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v212)));
              let v593 = bitcast<u32>(max(bitcast<i32>(v592), bitcast<i32>(4294967295u)));
              p215 = v593;
            } else {
              p215 = 4294967294u;
            }
            let v215 = p215;
            r1[2u] = v215;
            let v216 = !(v136 < 0.0f);
            if v216 {
              let v217 = (v136 == bitcast<f32>(bits_7f800000));
              let v595 = r2[0u][2u];
              let v596 = bitcast<f32>(v595);
              let v219 = (v136 + -1.0f);
              let v220 = (v219 / v136);
              let v221 = (v220 * v596);
              let v222 = select(v221, v596, v217);
              let v223 = (v222 > -1048576.0f);
              let v224 = select(-1048576.0f, v222, v223);
              let v225 = (v224 < 1048576.0f);
              let v226 = select(1048576.0f, v224, v225);
              let v227 = (v226 + 12582912.0f);
              let v228 = bitcast<u32>(v227);
              let v229 = (v228 + 3032481792u);
              let v230 = f32(bitcast<i32>(v229));
              let v231 = (v226 - v230);
              let v232 = (v231 >= 0.5f);
              let v233 = select(0u, 1u, v232);
              let v234 = (v49 + 3u);
              let v235 = (v234 + v229);
              let v236 = (v235 + v233);
              let v597 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v236)));
              let v598 = bitcast<u32>(max(bitcast<i32>(v597), bitcast<i32>(4294967295u)));
              p239 = v598;
            } else {
              p239 = 4294967294u;
            }
            let v239 = p239;
            r1[3u] = v239;
            let v240 = !(v137 < 0.0f);
            if v240 {
              let v241 = (v137 == bitcast<f32>(bits_7f800000));
              let v600 = r2[0u][2u];
              let v601 = bitcast<f32>(v600);
              let v243 = (v137 + -1.0f);
              let v244 = (v243 / v137);
              let v245 = (v244 * v601);
              let v246 = select(v245, v601, v241);
              let v247 = (v246 > -1048576.0f);
              let v248 = select(-1048576.0f, v246, v247);
              let v249 = (v248 < 1048576.0f);
              let v250 = select(1048576.0f, v248, v249);
              let v251 = (v250 + 12582912.0f);
              let v252 = bitcast<u32>(v251);
              let v253 = (v252 + 3032481792u);
              let v254 = f32(bitcast<i32>(v253));
              let v255 = (v250 - v254);
              let v256 = (v255 >= 0.5f);
              let v257 = select(0u, 1u, v256);
              let v258 = (v49 + 4u);
              let v259 = (v258 + v253);
              let v260 = (v259 + v257);
              let v602 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v260)));
              let v603 = bitcast<u32>(max(bitcast<i32>(v602), bitcast<i32>(4294967295u)));
              p263 = v603;
            } else {
              p263 = 4294967294u;
            }
            let v263 = p263;
            r1[4u] = v263;
            let v264 = !(v138 < 0.0f);
            if v264 {
              let v265 = (v138 == bitcast<f32>(bits_7f800000));
              let v605 = r2[0u][2u];
              let v606 = bitcast<f32>(v605);
              let v267 = (v138 + -1.0f);
              let v268 = (v267 / v138);
              let v269 = (v268 * v606);
              let v270 = select(v269, v606, v265);
              let v271 = (v270 > -1048576.0f);
              let v272 = select(-1048576.0f, v270, v271);
              let v273 = (v272 < 1048576.0f);
              let v274 = select(1048576.0f, v272, v273);
              let v275 = (v274 + 12582912.0f);
              let v276 = bitcast<u32>(v275);
              let v277 = (v276 + 3032481792u);
              let v278 = f32(bitcast<i32>(v277));
              let v279 = (v274 - v278);
              let v280 = (v279 >= 0.5f);
              let v281 = select(0u, 1u, v280);
              let v282 = (v49 + 5u);
              let v283 = (v282 + v277);
              let v284 = (v283 + v281);
              let v607 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v284)));
              let v608 = bitcast<u32>(max(bitcast<i32>(v607), bitcast<i32>(4294967295u)));
              p287 = v608;
            } else {
              p287 = 4294967294u;
            }
            let v287 = p287;
            r1[5u] = v287;
            let v288 = !(v139 < 0.0f);
            if v288 {
              let v289 = (v139 == bitcast<f32>(bits_7f800000));
              let v610 = r2[0u][2u];
              let v611 = bitcast<f32>(v610);
              let v291 = (v139 + -1.0f);
              let v292 = (v291 / v139);
              let v293 = (v292 * v611);
              let v294 = select(v293, v611, v289);
              let v295 = (v294 > -1048576.0f);
              let v296 = select(-1048576.0f, v294, v295);
              let v297 = (v296 < 1048576.0f);
              let v298 = select(1048576.0f, v296, v297);
              let v299 = (v298 + 12582912.0f);
              let v300 = bitcast<u32>(v299);
              let v301 = (v300 + 3032481792u);
              let v302 = f32(bitcast<i32>(v301));
              let v303 = (v298 - v302);
              let v304 = (v303 >= 0.5f);
              let v305 = select(0u, 1u, v304);
              let v306 = (v49 + 6u);
              let v307 = (v306 + v301);
              let v308 = (v307 + v305);
              let v612 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v308)));
              let v613 = bitcast<u32>(max(bitcast<i32>(v612), bitcast<i32>(4294967295u)));
              p311 = v613;
            } else {
              p311 = 4294967294u;
            }
            let v311 = p311;
            r1[6u] = v311;
            let v312 = !(v140 < 0.0f);
            if v312 {
              let v313 = (v140 == bitcast<f32>(bits_7f800000));
              let v615 = r2[0u][2u];
              let v616 = bitcast<f32>(v615);
              let v315 = (v140 + -1.0f);
              let v316 = (v315 / v140);
              let v317 = (v316 * v616);
              let v318 = select(v317, v616, v313);
              let v319 = (v318 > -1048576.0f);
              let v320 = select(-1048576.0f, v318, v319);
              let v321 = (v320 < 1048576.0f);
              let v322 = select(1048576.0f, v320, v321);
              let v323 = (v322 + 12582912.0f);
              let v324 = bitcast<u32>(v323);
              let v325 = (v324 + 3032481792u);
              let v326 = f32(bitcast<i32>(v325));
              let v327 = (v322 - v326);
              let v328 = (v327 >= 0.5f);
              let v329 = select(0u, 1u, v328);
              let v330 = (v49 + 7u);
              let v331 = (v330 + v325);
              let v332 = (v331 + v329);
              let v617 = bitcast<u32>(min(bitcast<i32>(v493), bitcast<i32>(v332)));
              let v618 = bitcast<u32>(max(bitcast<i32>(v617), bitcast<i32>(4294967295u)));
              p335 = v618;
            } else {
              p335 = 4294967294u;
            }
            let v335 = p335;
            r1[7u] = v335;
            let v336 = (v49 < v50);
            if v336 {
              p340 = v49;
              var done3 = false;
              loop {
                if done3 { break; }
                let v340 = p340;
                let v341 = (v340 - v49);
                let v620 = r1[v341];
                let v346 = (v620 == 4294967294u);
                if v346 {
                  let v353 = (v340 + 1u);
                  let v354 = (v353 == v50);
                  p448 = v353;
                  p449 = false;
                  p450 = v354;
                } else {
                  p449 = true;
                  p450 = true;
                }
                let v448 = p448;
                let v449 = p449;
                let v450 = p450;
                let v451 = (v449 != true);
                p340 = v448;
                p337 = v340;
                p640 = v451;
                done3 = v450;
              }
              let v640 = p640;
              if v640 {
                p356 = true;
                p348 = false;
              } else {
                p356 = false;
                p348 = true;
              }
              let v348 = p348;
              if v348 {
                p339 = true;
              } else {
                p337 = v50;
                p339 = false;
              }
            } else {
              p337 = v49;
              p356 = false;
              p339 = true;
            }
            let v337 = p337;
            let v339 = p339;
            if v339 {
              let v351 = (v337 == v50);
              let v352 = (v351 != true);
              p358 = v352;
              p356 = v351;
            } else {
              p358 = false;
            }
            let v356 = p356;
            if v356 {
              let v357 = (v50 >= v493);
              p358 = v357;
            }
            let v358 = p358;
            if v358 {
              let v359 = (v337 < v50);
              if v359 {
                p368 = v51;
                p369 = v337;
                var done4 = false;
                loop {
                  if done4 { break; }
                  let v368 = p368;
                  let v369 = p369;
                  let v370 = (v369 - v49);
                  let v621 = r1[v370];
                  let v375 = (v621 != 4294967294u);
                  if v375 {
                    let v393 = (v368 + 1u);
                    let v622 = r2[2u][0u];
                    let v395 = (v622 != 0u);
                    let v396 = (bitcast<i32>(v393) < bitcast<i32>(v621));
                    let v397 = (v396 & v395);
                    if v397 {
                      let v399 = (bitcast<i32>(v621) < bitcast<i32>(v493));
                      let v400 = select(0u, 1u, v399);
                      p402 = v400;
                    } else {
                      p402 = 0u;
                    }
                    let v402 = p402;
                    let v403 = (v402 + v621);
                    let v404 = (bitcast<i32>(v393) < bitcast<i32>(v403));
                    if v404 {
                      let v405 = (v369 + 1u);
                      p406 = v393;
                      var done5 = false;
                      loop {
                        if done5 { break; }
                        let v406 = p406;
                        let v408 = (v493 * v40);
                        let v625 = r2[0u][3u];
                        let v410 = (v625 == 0u);
                        let v411 = (v406 ^ 4294967295u);
                        let v412 = (v493 + v411);
                        let v413 = select(v412, v406, v410);
                        let v414 = (v413 + v408);
                        atomicStore(&r6[v414], v405);
                        let v418 = (v406 + 1u);
                        let v419 = (v418 == v403);
                        p406 = v418;
                        done5 = v419;
                      }
                    }
                    let v421 = (v621 < v493);
                    if v421 {
                      let v422 = (v493 * v40);
                      let v628 = r2[0u][3u];
                      let v424 = (v628 == 0u);
                      let v425 = (v621 ^ 4294967295u);
                      let v426 = (v493 + v425);
                      let v427 = select(v426, v621, v424);
                      let v428 = (v427 + v422);
                      let v432 = (v369 + 1u);
                      atomicStore(&r5[v428], v432);
                    }
                    p401 = v621;
                  } else {
                    p401 = v368;
                  }
                  let v401 = p401;
                  let v391 = (v369 + 1u);
                  let v392 = (v391 == v50);
                  p368 = v401;
                  p369 = v391;
                  p366 = v401;
                  done4 = v392;
                }
              } else {
                p366 = v51;
              }
              let v366 = p366;
              let v362 = (v50 == v493);
              if v362 {
                let v363 = (v366 + 1u);
                let v364 = (bitcast<i32>(v363) < bitcast<i32>(v50));
                if v364 {
                  let v365 = (v50 + 1u);
                  p376 = v363;
                  p377 = v366;
                  var done6 = false;
                  loop {
                    if done6 { break; }
                    let v376 = p376;
                    let v377 = p377;
                    let v379 = (v493 * v40);
                    let v632 = r2[0u][3u];
                    let v381 = (v632 == 0u);
                    let v382 = (v493 - v377);
                    let v383 = (v382 + 4294967294u);
                    let v384 = select(v383, v376, v381);
                    let v385 = (v384 + v379);
                    atomicStore(&r6[v385], v365);
                    let v389 = (v376 + 1u);
                    let v390 = (v389 == v50);
                    p376 = v389;
                    p377 = v376;
                    done6 = v390;
                  }
                }
              }
              p51 = v366;
            } else {
              p51 = v51;
            }
            let v433 = (v48 + 1u);
            let v434 = (v433 << (3u & 31u));
            let v635 = min(v434, v493);
            let v437 = (v493 - v635);
            let v438 = (v437 < 8u);
            let v439 = (v635 + 8u);
            let v440 = select(v439, v493, v438);
            let v441 = (v635 == v440);
            p48 = v433;
            p49 = v635;
            p50 = v440;
            done1 = v441;
          }
        }
        let v445 = (v40 + 1u);
        let v446 = (v41 + 4294967295u);
        let v447 = (v446 == 0u);
        p442 = v446;
        p443 = v445;
        p444 = v447;
      } else {
        p444 = true;
      }
      let v442 = p442;
      let v443 = p443;
      let v444 = p444;
      p40 = v443;
      p41 = v442;
      done0 = v444;
    }
  }
  return;
}
