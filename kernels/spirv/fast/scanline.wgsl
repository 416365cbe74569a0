@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 3>;
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
  var p56: u32;
  var p57: u32;
  var p64: u32;
  var p65: u32;
  var p66: u32;
  var p67: u32;
  var p110: u32;
  var p74: bool;
  var p470: u32;
  var p129: bool;
  var p203: u32;
  var p314: u32;
  var p315: bool;
  var p316: bool;
  var p529: bool;
  var p195: bool;
  var p163: u32;
  var p165: bool;
  var p212: bool;
  var p215: bool;
  var p217: bool;
  var p219: bool;
  var p230: u32;
  var p231: u32;
  var p264: u32;
  var p268: u32;
  var p263: u32;
  var p228: u32;
  var p240: u32;
  var p241: u32;
  var p222: u32;
  var p223: bool;
  var p308: u32;
  var p309: u32;
  var p310: bool;
  let v364 = global_invocation_id[0u];
  let v370 = r4.w0;
  let v20 = (v370 != 0u);
  if v20 {
    let v21 = (v370 * v364);
    p56 = v21;
    p57 = v370;
    var done0 = false;
    loop {
      if done0 { break; }
      let v56 = p56;
      let v57 = p57;
      let v371 = r3[0u][1u];
      let v59 = (v56 < v371);
      if v59 {
        let v372 = r3[0u][0u];
        let v61 = (v372 != 0u);
        if v61 {
          let v373 = min(v372, 8u);
          p64 = 0u;
          p65 = 0u;
          p66 = v373;
          p67 = 4294967295u;
          var done1 = false;
          loop {
            if done1 { break; }
            let v64 = p64;
            let v65 = p65;
            let v66 = p66;
            let v67 = p67;
            r0[0u] = 0u;
            r0[1u] = 0u;
            r0[2u] = 0u;
            r0[3u] = 0u;
            r0[4u] = 0u;
            r0[5u] = 0u;
            r0[6u] = 0u;
            r0[7u] = 0u;
            let v68 = (v66 - v65);
            let v69 = (v68 != 8u);
            if v69 {
              let v70 = (v65 < v66);
              if v70 {
                let v71 = (v372 * v56);
                let v382 = r3[0u][3u];
                let v73 = (v382 == 0u);
                p110 = v65;
                var done2 = false;
                loop {
                  if done2 { break; }
                  let v110 = p110;
                  let v111 = (v110 - v65);
                  let v112 = (v110 ^ 4294967295u);
                  let v113 = (v372 + v112);
                  let v114 = select(v113, v110, v73);
                  let v115 = (v114 + v71);
                  let v383 = (v115 * 2u);
                  let v384 = r5[v383];
                  r0[v111] = v384;
                  let v122 = (v110 + 1u);
                  let v123 = (v122 == v66);
                  p110 = v122;
                  done2 = v123;
                }
              }
              p74 = false;
            } else {
              p74 = true;
            }
            let v74 = p74;
            if v74 {
              let v387 = r3[0u][3u];
              let v76 = (v387 == 0u);
              let v77 = (v66 + 4294967295u);
              let v388 = select(7u, 0u, v76);
              let v79 = select(v77, v65, v76);
              let v80 = (v372 * v56);
              let v81 = (v79 ^ 4294967295u);
              let v82 = (v372 + v81);
              let v83 = select(v82, v65, v76);
              let v84 = (v83 + v80);
              let v389 = (v84 * 2u);
              let v390 = (v388 * 2u);
              let v391 = (v389 + v390);
              let v392 = r5[v391];
              r0[0u] = v392;
              let v395 = (v388 ^ 1u);
              let v397 = (v395 * 2u);
              let v398 = (v389 + v397);
              let v399 = r5[v398];
              r0[1u] = v399;
              let v402 = (v388 ^ 2u);
              let v404 = (v402 * 2u);
              let v405 = (v389 + v404);
              let v406 = r5[v405];
              r0[2u] = v406;
              let v409 = (v388 ^ 3u);
              let v411 = (v409 * 2u);
              let v412 = (v389 + v411);
              let v413 = r5[v412];
              r0[3u] = v413;
              let v416 = (v388 ^ 4u);
              let v418 = (v416 * 2u);
              let v419 = (v389 + v418);
              let v420 = r5[v419];
              r0[4u] = v420;
              let v423 = (v388 ^ 5u);
              let v425 = (v423 * 2u);
              let v426 = (v389 + v425);
              let v427 = r5[v426];
              r0[5u] = v427;
              let v430 = (v388 ^ 6u);
              let v432 = (v430 * 2u);
              let v433 = (v389 + v432);
              let v434 = r5[v433];
              r0[6u] = v434;
              let v437 = (v388 ^ 7u);
              let v439 = (v437 * 2u);
              let v440 = (v389 + v439);
              let v441 = r5[v440];
              r0[7u] = v441;
            }
            let v444 = r0[0u];
            let v445 = r0[1u];
            let v446 = r0[2u];
            let v447 = r0[3u];
            let v448 = r0[4u];
            let v449 = r0[5u];
            let v450 = r0[6u];
            let v451 = r0[7u];
            r1[0u] = v444;
            r1[1u] = v445;
            r1[2u] = v446;
            r1[3u] = v447;
            r1[4u] = v448;
            r1[5u] = v449;
            r1[6u] = v450;
            r1[7u] = v451;
            r2[0u] = 0u;
            r2[1u] = 0u;
            r2[2u] = 0u;
            r2[3u] = 0u;
            r2[4u] = 0u;
            r2[5u] = 0u;
            r2[6u] = 0u;
            r2[7u] = 0u;
            let v468 = r3[0u][2u];
            let v469 = bitcast<f32>(v468);
            p470 = 0u;
            var done3 = false;
            loop {
              if done3 { break; }
              let v470 = p470;
              let v472 = (v470 + 1u);
              let v473 = r1[v470];
              let v474 = bitcast<f32>(v473);
              let v171 = (v474 == bitcast<f32>(bits_7f800000));
              let v172 = (v474 + -1.0f);
              let v173 = (v172 / v474);
              let v174 = (v469 * v173);
              let v175 = select(v174, v469, v171);
              let v176 = (v175 > -1048576.0f);
              let v177 = select(-1048576.0f, v175, v176);
              let v178 = (v177 < 1048576.0f);
              let v179 = select(1048576.0f, v177, v178);
              let v180 = (v179 + 12582912.0f);
              let v181 = bitcast<u32>(v180);
              let v182 = (v181 + 3032481792u);
              let v183 = f32(bitcast<i32>(v182));
              let v184 = (v179 - v183);
              let v185 = (v184 >= 0.5f);
              let v186 = select(0u, 1u, v185);
              let v187 = (v65 + v470);
              let v188 = (v187 + v182);
              let v189 = (v188 + v186);
              let v475 = bitcast<u32>(min(bitcast<i32>(v372), bitcast<i32>(v189)));
              let v476 = bitcast<u32>(max(bitcast<i32>(v475), bitcast<i32>(4294967295u)));
              r2[v470] = v476;
              let v478 = (v472 == 8u);
              p470 = v472;
              done3 = v478;
            }
            let v479 = r3[2u][3u];
            let v126 = (v479 != 0u);
            let v127 = (v126 != true);
            if v127 {
              p165 = true;
              p129 = false;
            } else {
              p165 = false;
              p129 = true;
            }
            let v129 = p129;
            if v129 {
              let v480 = r1[0u];
              let v481 = bitcast<f32>(v480);
              let v131 = !(v481 >= 0.0f);
              let v482 = r2[0u];
              let v133 = select(v482, 4294967294u, v131);
              r2[0u] = v133;
              let v484 = r1[1u];
              let v485 = bitcast<f32>(v484);
              let v135 = !(v485 >= 0.0f);
              let v486 = r2[1u];
              let v137 = select(v486, 4294967294u, v135);
              r2[1u] = v137;
              let v488 = r1[2u];
              let v489 = bitcast<f32>(v488);
              let v139 = !(v489 >= 0.0f);
              let v490 = r2[2u];
              let v141 = select(v490, 4294967294u, v139);
              r2[2u] = v141;
              let v492 = r1[3u];
              let v493 = bitcast<f32>(v492);
              let v143 = !(v493 >= 0.0f);
              let v494 = r2[3u];
              let v145 = select(v494, 4294967294u, v143);
              r2[3u] = v145;
              let v496 = r1[4u];
              let v497 = bitcast<f32>(v496);
              let v147 = !(v497 >= 0.0f);
              let v498 = r2[4u];
              let v149 = select(v498, 4294967294u, v147);
              r2[4u] = v149;
              let v500 = r1[5u];
              let v501 = bitcast<f32>(v500);
              let v151 = !(v501 >= 0.0f);
              let v502 = r2[5u];
              let v153 = select(v502, 4294967294u, v151);
              r2[5u] = v153;
              let v504 = r1[6u];
              let v505 = bitcast<f32>(v504);
              let v155 = !(v505 >= 0.0f);
              let v506 = r2[6u];
              let v157 = select(v506, 4294967294u, v155);
              r2[6u] = v157;
              let v508 = r1[7u];
              let v509 = bitcast<f32>(v508);
              let v159 = !(v509 >= 0.0f);
              let v510 = r2[7u];
              let v161 = select(v510, 4294967294u, v159);
              r2[7u] = v161;
              let v162 = (v65 < v66);
              if v162 {
                p203 = v65;
                var done4 = false;
                loop {
                  if done4 { break; }
                  let v203 = p203;
                  let v204 = (v203 - v65);
                  let v512 = r2[v204];
                  let v209 = (v512 == 4294967294u);
                  if v209 {
                    let v210 = (v203 + 1u);
                    let v211 = (v210 == v66);
                    p314 = v210;
                    p315 = false;
                    p316 = v211;
                  } else {
                    p315 = true;
                    p316 = true;
                  }
                  let v314 = p314;
                  let v315 = p315;
                  let v316 = p316;
                  let v317 = (v315 != true);
                  p203 = v314;
                  p163 = v203;
                  p529 = v317;
                  done4 = v316;
                }
                let v529 = p529;
                if v529 {
                  p215 = true;
                  p195 = false;
                } else {
                  p215 = false;
                  p195 = true;
                }
                let v195 = p195;
                if v195 {
                  p165 = true;
                } else {
                  p163 = v66;
                  p165 = false;
                }
              } else {
                p163 = v65;
                p215 = false;
                p165 = true;
              }
            } else {
              p163 = v65;
              p215 = false;
            }
            let v163 = p163;
            let v165 = p165;
            if v165 {
              let v198 = (v163 == v66);
              let v199 = (v198 != true);
              p212 = v126;
              p217 = v126;
              p219 = v199;
              p215 = v198;
            } else {
              p212 = true;
              p217 = true;
              p219 = false;
            }
            let v212 = p212;
            let v215 = p215;
            if v215 {
              let v216 = (v66 >= v372);
              p223 = true;
              p219 = v216;
            } else {
              p217 = v212;
              p223 = false;
            }
            let v217 = p217;
            let v219 = p219;
            if v219 {
              let v220 = (v163 < v66);
              if v220 {
                p230 = v67;
                p231 = v163;
                var done5 = false;
                loop {
                  if done5 { break; }
                  let v230 = p230;
                  let v231 = p231;
                  let v232 = (v231 - v65);
                  let v513 = r2[v232];
                  let v237 = (v513 == 4294967294u);
                  let v238 = (v217 & v237);
                  let v239 = (v238 != true);
                  if v239 {
                    let v255 = (v230 + 1u);
                    let v514 = r3[2u][0u];
                    let v257 = (v514 != 0u);
                    let v258 = (bitcast<i32>(v255) < bitcast<i32>(v513));
                    let v259 = (v258 & v257);
                    if v259 {
                      let v261 = (bitcast<i32>(v513) < bitcast<i32>(v372));
                      let v262 = select(0u, 1u, v261);
                      p264 = v262;
                    } else {
                      p264 = 0u;
                    }
                    let v264 = p264;
                    let v265 = (v264 + v513);
                    let v266 = (bitcast<i32>(v255) < bitcast<i32>(v265));
                    if v266 {
                      let v267 = (v231 + 1u);
                      p268 = v255;
                      var done6 = false;
                      loop {
                        if done6 { break; }
                        let v268 = p268;
                        let v270 = (v372 * v56);
                        let v517 = r3[0u][3u];
                        let v272 = (v517 == 0u);
                        let v273 = (v268 ^ 4294967295u);
                        let v274 = (v372 + v273);
                        let v275 = select(v274, v268, v272);
                        let v276 = (v275 + v270);
                        atomicStore(&r7[v276], v267);
                        let v280 = (v268 + 1u);
                        let v281 = (v280 == v265);
                        p268 = v280;
                        done6 = v281;
                      }
                    }
                    let v283 = (v513 < v372);
                    if v283 {
                      let v286 = (v372 * v56);
                      let v520 = r3[0u][3u];
                      let v288 = (v520 == 0u);
                      let v289 = (v513 ^ 4294967295u);
                      let v290 = (v372 + v289);
                      let v291 = select(v290, v513, v288);
                      let v292 = (v291 + v286);
                      let v296 = (v231 + 1u);
                      atomicStore(&r6[v292], v296);
                    }
                    p263 = v513;
                  } else {
                    p263 = v230;
                  }
                  let v263 = p263;
                  let v284 = (v231 + 1u);
                  let v285 = (v284 == v66);
                  p230 = v263;
                  p231 = v284;
                  p228 = v263;
                  done5 = v285;
                }
              } else {
                p228 = v67;
              }
              let v228 = p228;
              let v224 = (v66 == v372);
              if v224 {
                let v225 = (v228 + 1u);
                let v226 = (bitcast<i32>(v225) < bitcast<i32>(v66));
                if v226 {
                  let v227 = (v66 + 1u);
                  p240 = v225;
                  p241 = v228;
                  var done7 = false;
                  loop {
                    if done7 { break; }
                    let v240 = p240;
                    let v241 = p241;
                    let v243 = (v372 * v56);
                    let v524 = r3[0u][3u];
                    let v245 = (v524 == 0u);
                    let v246 = (v372 - v241);
                    let v247 = (v246 + 4294967294u);
                    let v248 = select(v247, v240, v245);
                    let v249 = (v248 + v243);
                    atomicStore(&r7[v249], v227);
                    let v253 = (v240 + 1u);
                    let v254 = (v253 == v66);
                    p240 = v253;
                    p241 = v240;
                    done7 = v254;
                  }
                }
              }
              let v297 = (v228 == 4294967294u);
              p222 = v228;
              p223 = v297;
            }
            let v222 = p222;
            let v223 = p223;
            if v223 {
              p67 = v67;
            } else {
              p67 = v222;
            }
            let v299 = (v64 + 1u);
            let v300 = (v299 << (3u & 31u));
            let v527 = min(v300, v372);
            let v303 = (v372 - v527);
            let v304 = (v303 < 8u);
            let v305 = (v527 + 8u);
            let v306 = select(v305, v372, v304);
            let v307 = (v527 == v306);
            p64 = v299;
            p65 = v527;
            p66 = v306;
            done1 = v307;
          }
        }
        let v311 = (v56 + 1u);
        let v312 = (v57 + 4294967295u);
        let v313 = (v312 == 0u);
        p308 = v312;
        p309 = v311;
        p310 = v313;
      } else {
        p310 = true;
      }
      let v308 = p308;
      let v309 = p309;
      let v310 = p310;
      p56 = v309;
      p57 = v308;
      done0 = v310;
    }
  }
  return;
}
