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
  var p48: bool;
  var p433: u32;
  var p435: u32;
  var p270: u32;
  var p280: u32;
  var p290: u32;
  var p300: u32;
  var p310: u32;
  let v360 = global_invocation_id[0u];
  let v361 = global_invocation_id[1u];
  let v366 = r2[5u][2u];
  let v19 = (v366 & 31u);
  let v20 = (1u << (v19 & 31u));
  let v21 = (v360 << (v19 & 31u));
  let v22 = (v361 << (v19 & 31u));
  let v23 = (v21 + v20);
  let v367 = r2[0u][3u];
  let v26 = (v23 < v367);
  if v26 {
    let v27 = (v22 + v20);
    let v368 = r2[3u][3u];
    let v30 = (v27 < v368);
    if v30 {
      let v369 = r2[5u][3u];
      let v33 = (v369 == 0u);
      let v34 = (v33 != true);
      if v34 {
        let v35 = (4294967294u << (v19 & 31u));
        let v36 = (v22 & v35);
        let v37 = (v36 + v20);
        let v38 = (v37 * v367);
        let v39 = (v21 & v35);
        let v40 = (v39 + v20);
        let v41 = (v40 + v38);
        let v370 = atomicLoad(&r6[v41]);
        let v46 = (v370 & 4294901760u);
        let v47 = (v46 != 458752u);
        p48 = v47;
      } else {
        p48 = v33;
      }
      let v48 = p48;
      if v48 {
        let v49 = (v22 * v367);
        let v50 = (v49 + v21);
        let v51 = (v23 + v49);
        let v52 = (v27 * v367);
        let v53 = (v52 + v21);
        let v54 = (v52 + v23);
        let v371 = (v50 * 2u);
        let v372 = r4[v371];
        let v373 = v372[0u];
        let v377 = v372[1u];
        let v381 = v372[2u];
        let v383 = (v51 * 2u);
        let v384 = r4[v383];
        let v385 = v384[0u];
        let v389 = v384[1u];
        let v393 = v384[2u];
        let v395 = (v53 * 2u);
        let v396 = r4[v395];
        let v397 = v396[0u];
        let v401 = v396[1u];
        let v405 = v396[2u];
        let v407 = (v54 * 2u);
        let v408 = r4[v407];
        let v409 = v408[0u];
        let v413 = v408[1u];
        let v417 = v408[2u];
        r1[0u] = v373;
        r1[1u] = v377;
        r1[2u] = v381;
        r1[3u] = v385;
        r1[4u] = v389;
        r1[5u] = v393;
        r1[6u] = v397;
        r1[7u] = v401;
        r1[8u] = v405;
        r1[9u] = v409;
        r1[10u] = v413;
        r1[11u] = v417;
        let v431 = r3.w0;
        let v432 = bitcast<f32>(v431);
        p433 = 0u;
        p435 = 0u;
        var done0 = false;
        loop {
          if done0 { break; }
          let v433 = p433;
          let v435 = p435;
          let v436 = r1[v435];
          let v437 = bitcast<f32>(v436);
          let v438 = (v435 + 1u);
          let v439 = r1[v438];
          let v440 = bitcast<f32>(v439);
          let v441 = (v435 + 2u);
          let v442 = r1[v441];
          let v443 = bitcast<f32>(v442);
          let v107 = (v437 > 0.0f);
          let v108 = select(0.0f, v437, v107);
          let v109 = (v108 < 1.0f);
          let v110 = select(1.0f, v108, v109);
          let v111 = (v440 > 0.0f);
          let v112 = select(0.0f, v440, v111);
          let v113 = (v112 < 1.0f);
          let v114 = select(1.0f, v112, v113);
          let v115 = (v443 > 0.0f);
          let v116 = select(0.0f, v443, v115);
          let v117 = (v116 < 1.0f);
          let v118 = select(1.0f, v116, v117);
          let v444 = bitcast<u32>(v110);
          let v445 = (v433 * 3u);
          r0[v445] = v444;
          let v447 = bitcast<u32>(v114);
          let v449 = (v445 + 1u);
          r0[v449] = v447;
          let v451 = bitcast<u32>(v118);
          let v453 = (v445 + 2u);
          r0[v453] = v451;
          let v455 = (v433 + 1u);
          let v456 = (v455 == 4u);
          let v497 = (v435 + 3u);
          p433 = v455;
          p435 = v497;
          done0 = v456;
        }
        let v457 = r0[0u];
        let v458 = bitcast<f32>(v457);
        let v459 = r0[1u];
        let v460 = bitcast<f32>(v459);
        let v461 = r0[2u];
        let v462 = bitcast<f32>(v461);
        let v463 = r0[3u];
        let v464 = bitcast<f32>(v463);
        let v465 = r0[4u];
        let v466 = bitcast<f32>(v465);
        let v467 = r0[5u];
        let v468 = bitcast<f32>(v467);
        let v469 = r0[6u];
        let v470 = bitcast<f32>(v469);
        let v471 = r0[7u];
        let v472 = bitcast<f32>(v471);
        let v473 = r0[8u];
        let v474 = bitcast<f32>(v473);
        let v475 = r0[9u];
        let v476 = bitcast<f32>(v475);
        let v477 = r0[10u];
        let v478 = bitcast<f32>(v477);
        let v479 = r0[11u];
        let v480 = bitcast<f32>(v479);
        let v147 = (v458 - v464);
        let v148 = (v460 - v466);
        let v149 = (v462 - v468);
        let v150 = (v147 > v432);
        let v151 = (v148 > v432);
        let v152 = (v150 | v151);
        let v153 = (v149 > v432);
        let v154 = (v152 | v153);
        let v155 = -(v147);
        let v156 = (v432 < v155);
        let v157 = (v156 | v154);
        let v158 = -(v148);
        let v159 = (v432 < v158);
        let v160 = (v159 | v157);
        let v161 = -(v149);
        let v162 = (v432 < v161);
        let v163 = (v162 | v160);
        let v164 = (v458 - v470);
        let v165 = (v460 - v472);
        let v166 = (v462 - v474);
        let v167 = (v164 > v432);
        let v168 = (v165 > v432);
        let v169 = (v167 | v168);
        let v170 = (v166 > v432);
        let v171 = (v169 | v170);
        let v172 = -(v164);
        let v173 = (v432 < v172);
        let v174 = (v173 | v171);
        let v175 = -(v165);
        let v176 = (v432 < v175);
        let v177 = (v176 | v174);
        let v178 = -(v166);
        let v179 = (v432 < v178);
        let v180 = (v179 | v177);
        let v181 = (v163 | v180);
        let v182 = (v458 - v476);
        let v183 = (v460 - v478);
        let v184 = (v462 - v480);
        let v185 = (v182 > v432);
        let v186 = (v183 > v432);
        let v187 = (v185 | v186);
        let v188 = (v184 > v432);
        let v189 = (v187 | v188);
        let v190 = -(v182);
        let v191 = (v432 < v190);
        let v192 = (v191 | v189);
        let v193 = -(v183);
        let v194 = (v432 < v193);
        let v195 = (v194 | v192);
        let v196 = -(v184);
        let v197 = (v432 < v196);
        let v198 = (v197 | v195);
        let v199 = (v181 | v198);
        let v200 = (v464 - v470);
        let v201 = (v466 - v472);
        let v202 = (v468 - v474);
        let v203 = (v200 > v432);
        let v204 = (v201 > v432);
        let v205 = (v203 | v204);
        let v206 = (v202 > v432);
        let v207 = (v205 | v206);
        let v208 = -(v200);
        let v209 = (v432 < v208);
        let v210 = (v209 | v207);
        let v211 = -(v201);
        let v212 = (v432 < v211);
        let v213 = (v212 | v210);
        let v214 = -(v202);
        let v215 = (v432 < v214);
        let v216 = (v215 | v213);
        let v217 = (v216 | v199);
        let v218 = (v464 - v476);
        let v219 = (v466 - v478);
        let v220 = (v468 - v480);
        let v221 = (v218 > v432);
        let v222 = (v219 > v432);
        let v223 = (v221 | v222);
        let v224 = (v220 > v432);
        let v225 = (v223 | v224);
        let v226 = -(v218);
        let v227 = (v432 < v226);
        let v228 = (v227 | v225);
        let v229 = -(v219);
        let v230 = (v432 < v229);
        let v231 = (v230 | v228);
        let v232 = -(v220);
        let v233 = (v432 < v232);
        let v234 = (v233 | v231);
        let v235 = (v234 | v217);
        let v236 = (v470 - v476);
        let v237 = (v472 - v478);
        let v238 = (v474 - v480);
        let v239 = (v236 > v432);
        let v240 = (v237 > v432);
        let v241 = (v239 | v240);
        let v242 = (v238 > v432);
        let v243 = (v241 | v242);
        let v244 = -(v236);
        let v245 = (v432 < v244);
        let v246 = (v245 | v243);
        let v247 = -(v237);
        let v248 = (v432 < v247);
        let v249 = (v248 | v246);
        let v250 = -(v238);
        let v251 = (v432 < v250);
        let v252 = (v251 | v249);
        let v253 = (v252 | v235);
        if v253 {
          let v254 = (v20 >> (1u & 31u));
          let v255 = (v254 + v21);
          let v256 = (v255 + v49);
          let v257 = (v254 + v22);
          let v258 = (v257 * v367);
          let v259 = (v258 + v21);
          let v260 = (v258 + v255);
          let v261 = (v258 + v23);
          let v262 = (v255 + v52);
          let v481 = r3.w1;
          let v265 = (v481 == 1u);
          if v265 {
            let v482 = r5[v256];
            p270 = v482;
          } else {
            p270 = 196607u;
          }
          let v270 = p270;
          let v483 = atomicLoad(&r6[v256]);
          let v274 = (v483 & 4294901760u);
          let v275 = (v274 == 458752u);
          if v275 {
            atomicStore(&r6[v256], v270);
          }
          if v265 {
            let v485 = r5[v259];
            p280 = v485;
          } else {
            p280 = 196607u;
          }
          let v280 = p280;
          let v486 = atomicLoad(&r6[v259]);
          let v284 = (v486 & 4294901760u);
          let v285 = (v284 == 458752u);
          if v285 {
            atomicStore(&r6[v259], v280);
          }
          if v265 {
            let v488 = r5[v260];
            p290 = v488;
          } else {
            p290 = 196607u;
          }
          let v290 = p290;
          let v489 = atomicLoad(&r6[v260]);
          let v294 = (v489 & 4294901760u);
          let v295 = (v294 == 458752u);
          if v295 {
            atomicStore(&r6[v260], v290);
          }
          if v265 {
            let v491 = r5[v261];
            p300 = v491;
          } else {
            p300 = 196607u;
          }
          let v300 = p300;
          let v492 = atomicLoad(&r6[v261]);
          let v304 = (v492 & 4294901760u);
          let v305 = (v304 == 458752u);
          if v305 {
            atomicStore(&r6[v261], v300);
          }
          if v265 {
            let v494 = r5[v262];
            p310 = v494;
          } else {
            p310 = 196607u;
          }
          let v310 = p310;
          let v495 = atomicLoad(&r6[v262]);
          let v314 = (v495 & 4294901760u);
          let v315 = (v314 == 458752u);
          if v315 {
            atomicStore(&r6[v262], v310);
          }
        }
      }
    }
  }
  return;
}
