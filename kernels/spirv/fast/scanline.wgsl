@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 4>;
struct Push { w0: u32 }
var<immediate> r4: Push;
@group(0) @binding(1) var<storage, read> r5: array<u32>;
@group(0) @binding(2) var<storage, read_write> r6: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r7: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var r2: array<u32, 8>;
  var p36: u32;
  var p37: u32;
  var p44: u32;
  var p45: u32;
  var p46: u32;
  var p47: u32;
  var p90: u32;
  var p54: bool;
  var p463: u32;
  var p128: f32;
  var p129: bool;
  var p182: f32;
  var p181: f32;
  var p207: u32;
  var p315: u32;
  var p316: bool;
  var p317: bool;
  var p492: bool;
  var p215: bool;
  var p204: u32;
  var p206: bool;
  var p223: bool;
  var p225: bool;
  var p235: u32;
  var p236: u32;
  var p269: u32;
  var p273: u32;
  var p268: u32;
  var p233: u32;
  var p243: u32;
  var p244: u32;
  var p309: u32;
  var p310: u32;
  var p311: bool;
  let v356 = global_invocation_id[0u];
  let v362 = r4.w0;
  let v20 = (v362 != 0u);
  if v20 {
    let v21 = (v362 * v356);
    p36 = v21;
    p37 = v362;
    var done0 = false;
    loop {
      if done0 { break; }
      let v36 = p36;
      let v37 = p37;
      let v363 = r3[0u][1u];
      let v39 = (v36 < v363);
      if v39 {
        let v364 = r3[0u][0u];
        let v41 = (v364 != 0u);
        if v41 {
          let v365 = min(v364, 8u);
          p44 = 0u;
          p45 = 0u;
          p46 = v365;
          p47 = 4294967295u;
          var done1 = false;
          loop {
            if done1 { break; }
            let v44 = p44;
            let v45 = p45;
            let v46 = p46;
            let v47 = p47;
            r0[0u] = 0u;
            r0[1u] = 0u;
            r0[2u] = 0u;
            r0[3u] = 0u;
            r0[4u] = 0u;
            r0[5u] = 0u;
            r0[6u] = 0u;
            r0[7u] = 0u;
            let v48 = (v46 - v45);
            let v49 = (v48 != 8u);
            if v49 {
              let v50 = (v45 < v46);
              if v50 {
                let v51 = (v364 * v36);
                let v374 = r3[0u][3u];
                let v53 = (v374 == 0u);
                p90 = v45;
                var done2 = false;
                loop {
                  if done2 { break; }
                  let v90 = p90;
                  let v91 = (v90 - v45);
                  let v92 = (v90 ^ 4294967295u);
                  let v93 = (v364 + v92);
                  let v94 = select(v93, v90, v53);
                  let v95 = (v94 + v51);
                  let v375 = (v95 * 2u);
                  let v376 = r5[v375];
                  r0[v91] = v376;
                  let v102 = (v90 + 1u);
                  let v103 = (v102 == v46);
                  p90 = v102;
                  done2 = v103;
                }
              }
              p54 = false;
            } else {
              p54 = true;
            }
            let v54 = p54;
            if v54 {
              let v379 = r3[0u][3u];
              let v56 = (v379 == 0u);
              let v57 = (v46 + 4294967295u);
              let v380 = select(7u, 0u, v56);
              let v59 = select(v57, v45, v56);
              let v60 = (v364 * v36);
              let v61 = (v59 ^ 4294967295u);
              let v62 = (v364 + v61);
              let v63 = select(v62, v45, v56);
              let v64 = (v63 + v60);
              let v381 = (v64 * 2u);
              let v382 = (v380 * 2u);
              let v383 = (v381 + v382);
              let v384 = r5[v383];
              r0[0u] = v384;
              let v387 = (v380 ^ 1u);
              let v389 = (v387 * 2u);
              let v390 = (v381 + v389);
              let v391 = r5[v390];
              r0[1u] = v391;
              let v394 = (v380 ^ 2u);
              let v396 = (v394 * 2u);
              let v397 = (v381 + v396);
              let v398 = r5[v397];
              r0[2u] = v398;
              let v401 = (v380 ^ 3u);
              let v403 = (v401 * 2u);
              let v404 = (v381 + v403);
              let v405 = r5[v404];
              r0[3u] = v405;
              let v408 = (v380 ^ 4u);
              let v410 = (v408 * 2u);
              let v411 = (v381 + v410);
              let v412 = r5[v411];
              r0[4u] = v412;
              let v415 = (v380 ^ 5u);
              let v417 = (v415 * 2u);
              let v418 = (v381 + v417);
              let v419 = r5[v418];
              r0[5u] = v419;
              let v422 = (v380 ^ 6u);
              let v424 = (v422 * 2u);
              let v425 = (v381 + v424);
              let v426 = r5[v425];
              r0[6u] = v426;
              let v429 = (v380 ^ 7u);
              let v431 = (v429 * 2u);
              let v432 = (v381 + v431);
              let v433 = r5[v432];
              r0[7u] = v433;
            }
            let v436 = r0[0u];
            let v437 = r0[1u];
            let v438 = r0[2u];
            let v439 = r0[3u];
            let v440 = r0[4u];
            let v441 = r0[5u];
            let v442 = r0[6u];
            let v443 = r0[7u];
            r1[0u] = v436;
            r1[1u] = v437;
            r1[2u] = v438;
            r1[3u] = v439;
            r1[4u] = v440;
            r1[5u] = v441;
            r1[6u] = v442;
            r1[7u] = v443;
            r2[0u] = 0u;
            r2[1u] = 0u;
            r2[2u] = 0u;
            r2[3u] = 0u;
            r2[4u] = 0u;
            r2[5u] = 0u;
            r2[6u] = 0u;
            r2[7u] = 0u;
            let v460 = r3[0u][2u];
            let v461 = bitcast<f32>(v460);
            let v462 = r3[2u][3u];
            let v106 = (v462 != 0u);
            let v107 = (v462 >> (16u & 31u));
            let v108 = (v107 ^ v462);
            let v109 = (v108 * 2146121005u);
            let v110 = (v109 >> (15u & 31u));
            let v111 = (v110 ^ v109);
            let v112 = (v111 * 2221713035u);
            let v113 = (v112 >> (16u & 31u));
            let v114 = (v113 ^ v112);
            p463 = 0u;
            var done3 = false;
            loop {
              if done3 { break; }
              let v463 = p463;
              let v465 = (v463 + 1u);
              let v466 = r1[v463];
              let v467 = bitcast<f32>(v466);
              let v120 = (v45 + v463);
              let v121 = (v467 == bitcast<f32>(bits_7f800000));
              let v122 = (v467 + -1.0f);
              let v123 = (v122 / v467);
              let v124 = (v461 * v123);
              let v125 = select(v124, v461, v121);
              if v106 {
                let v468 = r3[0u][3u];
                let v127 = (v468 != 0u);
                if v127 {
                  let v154 = (v120 ^ 4294967295u);
                  let v155 = (v364 + v154);
                  let v469 = r3[3u][0u];
                  let v157 = (v469 + v36);
                  let v158 = (v157 >> (16u & 31u));
                  let v159 = (v157 ^ v158);
                  let v160 = (v159 ^ v112);
                  let v161 = (v160 * 2146121005u);
                  let v162 = (v161 >> (15u & 31u));
                  let v163 = (v162 ^ v161);
                  let v164 = (v163 * 2221713035u);
                  let v165 = (v164 >> (16u & 31u));
                  let v166 = (v155 ^ v165);
                  let v167 = (v166 ^ v164);
                  let v168 = (v167 >> (16u & 31u));
                  let v169 = (v168 ^ v167);
                  let v170 = (v169 * 2146121005u);
                  let v171 = (v170 >> (15u & 31u));
                  let v172 = (v171 ^ v170);
                  let v173 = (v172 * 2221713035u);
                  let v174 = (v173 >> (16u & 31u));
                  let v175 = (v173 & 65535u);
                  let v176 = (v175 ^ v174);
                  let v177 = f32(v176);
                  let v178 = (v177 * 1.5258789e-5f);
                  let v179 = (v178 + -0.49999237f);
                  let v180 = -(v179);
                  p128 = v180;
                  p129 = false;
                } else {
                  p129 = true;
                }
                let v128 = p128;
                let v129 = p129;
                if v129 {
                  let v470 = r3[3u][0u];
                  let v131 = (v470 + v36);
                  let v132 = (v131 ^ v114);
                  let v133 = (v132 >> (16u & 31u));
                  let v134 = (v133 ^ v132);
                  let v135 = (v134 * 2146121005u);
                  let v136 = (v135 >> (15u & 31u));
                  let v137 = (v136 ^ v135);
                  let v138 = (v137 * 2221713035u);
                  let v139 = (v138 >> (16u & 31u));
                  let v140 = (v120 ^ v139);
                  let v141 = (v140 ^ v138);
                  let v142 = (v141 >> (16u & 31u));
                  let v143 = (v142 ^ v141);
                  let v144 = (v143 * 2146121005u);
                  let v145 = (v144 >> (15u & 31u));
                  let v146 = (v145 ^ v144);
                  let v147 = (v146 * 2221713035u);
                  let v148 = (v147 >> (16u & 31u));
                  let v149 = (v147 & 65535u);
                  let v150 = (v149 ^ v148);
                  let v151 = f32(v150);
                  let v152 = (v151 * 1.5258789e-5f);
                  let v153 = (v152 + -0.49999237f);
                  p182 = v153;
                } else {
                  p182 = v128;
                }
                let v182 = p182;
                let v183 = (v125 + v182);
                p181 = v183;
              } else {
                p181 = v125;
              }
              let v181 = p181;
              let v184 = (v181 > -1048576.0f);
              let v185 = select(-1048576.0f, v181, v184);
              let v186 = (v185 < 1048576.0f);
              let v187 = select(1048576.0f, v185, v186);
              let v188 = (v187 + 12582912.0f);
              let v189 = bitcast<u32>(v188);
              let v190 = (v189 + 3032481792u);
              let v191 = f32(bitcast<i32>(v190));
              let v192 = (v187 - v191);
              let v193 = (v192 >= 0.5f);
              let v194 = select(0u, 1u, v193);
              let v195 = (v190 + v120);
              let v196 = (v195 + v194);
              let v471 = bitcast<u32>(min(bitcast<i32>(v364), bitcast<i32>(v196)));
              let v472 = bitcast<u32>(max(bitcast<i32>(v471), bitcast<i32>(4294967295u)));
              let v199 = (v467 < 0.0f);
              let v200 = select(v472, 4294967294u, v199);
              r2[v463] = v200;
              let v474 = (v465 == 8u);
              p463 = v465;
              done3 = v474;
            }
            let v203 = (v45 < v46);
            if v203 {
              p207 = v45;
              var done4 = false;
              loop {
                if done4 { break; }
                let v207 = p207;
                let v208 = (v207 - v45);
                let v475 = r2[v208];
                let v213 = (v475 == 4294967294u);
                if v213 {
                  let v220 = (v207 + 1u);
                  let v221 = (v220 == v46);
                  p315 = v220;
                  p316 = false;
                  p317 = v221;
                } else {
                  p316 = true;
                  p317 = true;
                }
                let v315 = p315;
                let v316 = p316;
                let v317 = p317;
                let v318 = (v316 != true);
                p207 = v315;
                p204 = v207;
                p492 = v318;
                done4 = v317;
              }
              let v492 = p492;
              if v492 {
                p223 = true;
                p215 = false;
              } else {
                p223 = false;
                p215 = true;
              }
              let v215 = p215;
              if v215 {
                p206 = true;
              } else {
                p204 = v46;
                p206 = false;
              }
            } else {
              p204 = v45;
              p223 = false;
              p206 = true;
            }
            let v204 = p204;
            let v206 = p206;
            if v206 {
              let v218 = (v204 == v46);
              let v219 = (v218 != true);
              p225 = v219;
              p223 = v218;
            } else {
              p225 = false;
            }
            let v223 = p223;
            if v223 {
              let v224 = (v46 >= v364);
              p225 = v224;
            }
            let v225 = p225;
            if v225 {
              let v226 = (v204 < v46);
              if v226 {
                p235 = v47;
                p236 = v204;
                var done5 = false;
                loop {
                  if done5 { break; }
                  let v235 = p235;
                  let v236 = p236;
                  let v237 = (v236 - v45);
                  let v476 = r2[v237];
                  let v242 = (v476 != 4294967294u);
                  if v242 {
                    let v260 = (v235 + 1u);
                    let v477 = r3[2u][0u];
                    let v262 = (v477 != 0u);
                    let v263 = (bitcast<i32>(v260) < bitcast<i32>(v476));
                    let v264 = (v263 & v262);
                    if v264 {
                      let v266 = (bitcast<i32>(v476) < bitcast<i32>(v364));
                      let v267 = select(0u, 1u, v266);
                      p269 = v267;
                    } else {
                      p269 = 0u;
                    }
                    let v269 = p269;
                    let v270 = (v269 + v476);
                    let v271 = (bitcast<i32>(v260) < bitcast<i32>(v270));
                    if v271 {
                      let v272 = (v236 + 1u);
                      p273 = v260;
                      var done6 = false;
                      loop {
                        if done6 { break; }
                        let v273 = p273;
                        let v275 = (v364 * v36);
                        let v480 = r3[0u][3u];
                        let v277 = (v480 == 0u);
                        let v278 = (v273 ^ 4294967295u);
                        let v279 = (v364 + v278);
                        let v280 = select(v279, v273, v277);
                        let v281 = (v280 + v275);
                        atomicStore(&r7[v281], v272);
                        let v285 = (v273 + 1u);
                        let v286 = (v285 == v270);
                        p273 = v285;
                        done6 = v286;
                      }
                    }
                    let v288 = (v476 < v364);
                    if v288 {
                      let v289 = (v364 * v36);
                      let v483 = r3[0u][3u];
                      let v291 = (v483 == 0u);
                      let v292 = (v476 ^ 4294967295u);
                      let v293 = (v364 + v292);
                      let v294 = select(v293, v476, v291);
                      let v295 = (v294 + v289);
                      let v299 = (v236 + 1u);
                      atomicStore(&r6[v295], v299);
                    }
                    p268 = v476;
                  } else {
                    p268 = v235;
                  }
                  let v268 = p268;
                  let v258 = (v236 + 1u);
                  let v259 = (v258 == v46);
                  p235 = v268;
                  p236 = v258;
                  p233 = v268;
                  done5 = v259;
                }
              } else {
                p233 = v47;
              }
              let v233 = p233;
              let v229 = (v46 == v364);
              if v229 {
                let v230 = (v233 + 1u);
                let v231 = (bitcast<i32>(v230) < bitcast<i32>(v46));
                if v231 {
                  let v232 = (v46 + 1u);
                  p243 = v230;
                  p244 = v233;
                  var done7 = false;
                  loop {
                    if done7 { break; }
                    let v243 = p243;
                    let v244 = p244;
                    let v246 = (v364 * v36);
                    let v487 = r3[0u][3u];
                    let v248 = (v487 == 0u);
                    let v249 = (v364 - v244);
                    let v250 = (v249 + 4294967294u);
                    let v251 = select(v250, v243, v248);
                    let v252 = (v251 + v246);
                    atomicStore(&r7[v252], v232);
                    let v256 = (v243 + 1u);
                    let v257 = (v256 == v46);
                    p243 = v256;
                    p244 = v243;
                    done7 = v257;
                  }
                }
              }
              p47 = v233;
            } else {
              p47 = v47;
            }
            let v300 = (v44 + 1u);
            let v301 = (v300 << (3u & 31u));
            let v490 = min(v301, v364);
            let v304 = (v364 - v490);
            let v305 = (v304 < 8u);
            let v306 = (v490 + 8u);
            let v307 = select(v306, v364, v305);
            let v308 = (v490 == v307);
            p44 = v300;
            p45 = v490;
            p46 = v307;
            done1 = v308;
          }
        }
        let v312 = (v36 + 1u);
        let v313 = (v37 + 4294967295u);
        let v314 = (v313 == 0u);
        p309 = v313;
        p310 = v312;
        p311 = v314;
      } else {
        p311 = true;
      }
      let v309 = p309;
      let v310 = p310;
      let v311 = p311;
      p36 = v310;
      p37 = v309;
      done0 = v311;
    }
  }
  return;
}
