@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 3>;
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
  var p523: u32;
  var p211: u32;
  var p202: u32;
  var p204: bool;
  var p119: bool;
  var p205: u32;
  var p223: u32;
  var p268: u32;
  var p269: bool;
  var p228: u32;
  var p233: bool;
  var p587: bool;
  var p589: u32;
  var p590: f32;
  var p271: u32;
  var p272: bool;
  var p273: u32;
  var p286: u32;
  var p287: u32;
  var p320: u32;
  var p324: u32;
  var p357: bool;
  var p319: u32;
  var p284: u32;
  var p295: u32;
  var p296: u32;
  let v412 = global_invocation_id[0u];
  let v413 = global_invocation_id[1u];
  let v418 = r3[0u][1u];
  let v19 = (v413 < v418);
  let v419 = r3[0u][0u];
  let v21 = (v412 << (3u & 31u));
  let v420 = min(v21, v419);
  let v23 = select(v419, v420, v19);
  let v24 = (v419 - v23);
  let v25 = (v24 < 8u);
  let v26 = (v23 + 8u);
  let v27 = select(v26, v419, v25);
  let v421 = r3[1u][2u];
  let v422 = r3[1u][3u];
  let v32 = (v422 != 0u);
  let v33 = (v23 != v27);
  let v34 = (v421 != 0u);
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
        let v39 = (v419 * v413);
        let v431 = r3[0u][3u];
        let v42 = (v431 != 0u);
        if v42 {
          let v54 = (v419 + v39);
          p100 = v23;
          var done0 = false;
          loop {
            if done0 { break; }
            let v100 = p100;
            let v101 = (v100 - v23);
            let v102 = (v100 ^ 4294967295u);
            let v103 = (v54 + v102);
            let v432 = (v103 * 2u);
            let v433 = r4[v432];
            r0[v101] = v433;
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
            let v436 = (v45 * 2u);
            let v437 = r4[v436];
            r0[v44] = v437;
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
      let v440 = r3[0u][3u];
      let v58 = (v440 == 0u);
      let v59 = (v27 + 4294967295u);
      let v441 = select(7u, 0u, v58);
      let v61 = select(v59, v23, v58);
      let v62 = (v419 * v413);
      let v63 = (v61 ^ 4294967295u);
      let v64 = (v419 + v63);
      let v65 = select(v64, v23, v58);
      let v66 = (v65 + v62);
      let v442 = (v66 * 2u);
      let v443 = (v441 * 2u);
      let v444 = (v442 + v443);
      let v445 = r4[v444];
      r0[0u] = v445;
      let v448 = (v441 ^ 1u);
      let v450 = (v448 * 2u);
      let v451 = (v442 + v450);
      let v452 = r4[v451];
      r0[1u] = v452;
      let v455 = (v441 ^ 2u);
      let v457 = (v455 * 2u);
      let v458 = (v442 + v457);
      let v459 = r4[v458];
      r0[2u] = v459;
      let v462 = (v441 ^ 3u);
      let v464 = (v462 * 2u);
      let v465 = (v442 + v464);
      let v466 = r4[v465];
      r0[3u] = v466;
      let v469 = (v441 ^ 4u);
      let v471 = (v469 * 2u);
      let v472 = (v442 + v471);
      let v473 = r4[v472];
      r0[4u] = v473;
      let v476 = (v441 ^ 5u);
      let v478 = (v476 * 2u);
      let v479 = (v442 + v478);
      let v480 = r4[v479];
      r0[5u] = v480;
      let v483 = (v441 ^ 6u);
      let v485 = (v483 * 2u);
      let v486 = (v442 + v485);
      let v487 = r4[v486];
      r0[6u] = v487;
      let v490 = (v441 ^ 7u);
      let v492 = (v490 * 2u);
      let v493 = (v442 + v492);
      let v494 = r4[v493];
      r0[7u] = v494;
    }
    let v497 = r0[0u];
    let v498 = r0[1u];
    let v499 = r0[2u];
    let v500 = r0[3u];
    let v501 = r0[4u];
    let v502 = r0[5u];
    let v503 = r0[6u];
    let v504 = r0[7u];
    r1[0u] = v497;
    r1[1u] = v498;
    r1[2u] = v499;
    r1[3u] = v500;
    r1[4u] = v501;
    r1[5u] = v502;
    r1[6u] = v503;
    r1[7u] = v504;
    r2[0u] = 0u;
    r2[1u] = 0u;
    r2[2u] = 0u;
    r2[3u] = 0u;
    r2[4u] = 0u;
    r2[5u] = 0u;
    r2[6u] = 0u;
    r2[7u] = 0u;
    let v521 = r3[0u][2u];
    let v522 = bitcast<f32>(v521);
    p523 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v523 = p523;
      let v525 = (v523 + 1u);
      let v526 = r1[v523];
      let v527 = bitcast<f32>(v526);
      let v179 = (v527 == bitcast<f32>(bits_7f800000));
      let v180 = (v527 + -1.0f);
      let v181 = (v180 / v527);
      let v182 = (v522 * v181);
      let v183 = select(v182, v522, v179);
      let v184 = (v183 > -1048576.0f);
      let v185 = select(-1048576.0f, v183, v184);
      let v186 = (v185 < 1048576.0f);
      let v187 = select(1048576.0f, v185, v186);
      let v188 = (v187 + 12582912.0f);
      let v189 = bitcast<u32>(v188);
      let v190 = (v189 + 3032481792u);
      let v191 = f32(bitcast<i32>(v190));
      let v192 = (v187 - v191);
      let v193 = (v192 >= 0.5f);
      let v194 = select(0u, 1u, v193);
      let v195 = (v23 + v523);
      let v196 = (v195 + v190);
      let v197 = (v196 + v194);
      let v528 = bitcast<u32>(min(bitcast<i32>(v419), bitcast<i32>(v197)));
      let v529 = bitcast<u32>(max(bitcast<i32>(v528), bitcast<i32>(4294967295u)));
      r2[v523] = v529;
      let v531 = (v525 == 8u);
      p523 = v525;
      done2 = v531;
    }
    let v532 = r3[2u][3u];
    let v116 = (v532 == 0u);
    let v117 = (v116 != true);
    if v117 {
      let v533 = r1[0u];
      let v534 = bitcast<f32>(v533);
      let v121 = !(v534 >= 0.0f);
      let v535 = r2[0u];
      let v123 = select(v535, 4294967294u, v121);
      r2[0u] = v123;
      let v537 = r1[1u];
      let v538 = bitcast<f32>(v537);
      let v126 = !(v538 >= 0.0f);
      let v539 = r2[1u];
      let v129 = select(v539, 4294967294u, v126);
      r2[1u] = v129;
      let v541 = r1[2u];
      let v542 = bitcast<f32>(v541);
      let v133 = !(v542 >= 0.0f);
      let v543 = r2[2u];
      let v136 = select(v543, 4294967294u, v133);
      r2[2u] = v136;
      let v545 = r1[3u];
      let v546 = bitcast<f32>(v545);
      let v140 = !(v546 >= 0.0f);
      let v547 = r2[3u];
      let v143 = select(v547, 4294967294u, v140);
      r2[3u] = v143;
      let v549 = r1[4u];
      let v550 = bitcast<f32>(v549);
      let v147 = !(v550 >= 0.0f);
      let v551 = r2[4u];
      let v150 = select(v551, 4294967294u, v147);
      r2[4u] = v150;
      let v553 = r1[5u];
      let v554 = bitcast<f32>(v553);
      let v154 = !(v554 >= 0.0f);
      let v555 = r2[5u];
      let v157 = select(v555, 4294967294u, v154);
      r2[5u] = v157;
      let v557 = r1[6u];
      let v558 = bitcast<f32>(v557);
      let v161 = !(v558 >= 0.0f);
      let v559 = r2[6u];
      let v164 = select(v559, 4294967294u, v161);
      r2[6u] = v164;
      let v561 = r1[7u];
      let v562 = bitcast<f32>(v561);
      let v168 = !(v562 >= 0.0f);
      let v563 = r2[7u];
      let v171 = select(v563, 4294967294u, v168);
      r2[7u] = v171;
      let v173 = (v23 < v27);
      if v173 {
        p211 = v23;
        var done3 = false;
        loop {
          if done3 { break; }
          let v211 = p211;
          let v212 = (v211 - v23);
          let v565 = r2[v212];
          let v217 = (v565 == 4294967294u);
          if v217 {
            let v218 = (v211 + 1u);
            let v219 = (v218 == v27);
            p202 = v218;
            p205 = v27;
            p204 = v219;
          } else {
            p205 = v211;
            p204 = true;
          }
          let v202 = p202;
          let v204 = p204;
          p211 = v202;
          done3 = v204;
        }
      } else {
        p205 = v23;
      }
      p119 = false;
    } else {
      p119 = true;
    }
    let v119 = p119;
    if v119 {
      p205 = v23;
    }
    let v205 = p205;
    let v206 = (v205 == v27);
    let v207 = (v27 < v419);
    let v208 = (v207 & v206);
    let v209 = (v208 != true);
    if v209 {
      let v221 = (v419 * v413);
      p223 = v23;
      var done4 = false;
      loop {
        if done4 { break; }
        let v223 = p223;
        let v224 = (v223 != 0u);
        if v224 {
          let v225 = (v223 + 4294967295u);
          let v226 = (v225 < v419);
          let v227 = (v226 != true);
          if v226 {
            let v566 = r3[0u][3u];
            let v235 = (v566 == 0u);
            let v236 = (v419 - v223);
            let v237 = select(v236, v225, v235);
            let v238 = (v237 + v221);
            let v567 = (v238 * 2u);
            let v568 = r4[v567];
            let v569 = bitcast<f32>(v568);
            let v243 = (v569 >= 0.0f);
            let v244 = (v116 | v243);
            let v245 = (v244 != true);
            p587 = false;
            p590 = v569;
            p268 = 4294967294u;
            p269 = v245;
          } else {
            p587 = true;
            p268 = v419;
            p269 = v227;
          }
          let v268 = p268;
          let v269 = p269;
          if v269 {
            let v270 = (v268 != 4294967294u);
            p587 = true;
            p273 = v268;
            p233 = v270;
          } else {
            p273 = 4294967295u;
            p233 = true;
          }
          p228 = v225;
          p589 = v225;
        } else {
          p587 = true;
          p273 = 4294967295u;
          p233 = true;
        }
        let v228 = p228;
        let v233 = p233;
        p223 = v228;
        done4 = v233;
      }
      let v587 = p587;
      let v589 = p589;
      let v590 = p590;
      let v362 = (v587 != true);
      if v362 {
        let v246 = (v590 == bitcast<f32>(bits_7f800000));
        let v247 = (v590 + -1.0f);
        let v248 = (v247 / v590);
        let v249 = (v248 * v522);
        let v250 = select(v249, v522, v246);
        let v251 = (v250 > -1048576.0f);
        let v252 = select(-1048576.0f, v250, v251);
        let v253 = (v252 < 1048576.0f);
        let v254 = select(1048576.0f, v252, v253);
        let v255 = (v254 + 12582912.0f);
        let v256 = bitcast<u32>(v255);
        let v257 = (v256 + 3032481792u);
        let v258 = f32(bitcast<i32>(v257));
        let v259 = (v254 - v258);
        let v260 = (v259 >= 0.5f);
        let v261 = select(0u, 1u, v260);
        let v262 = (v257 + v589);
        let v263 = (v262 + v261);
        let v570 = bitcast<u32>(min(bitcast<i32>(v419), bitcast<i32>(v263)));
        let v571 = bitcast<u32>(max(bitcast<i32>(v570), bitcast<i32>(4294967295u)));
        p271 = v571;
        p272 = false;
      } else {
        p272 = true;
      }
      let v271 = p271;
      let v272 = p272;
      if !v272 {
        p273 = v271;
      }
      let v273 = p273;
      let v274 = (v205 < v27);
      if v274 {
        p286 = v273;
        p287 = v205;
        var done5 = false;
        loop {
          if done5 { break; }
          let v286 = p286;
          let v287 = p287;
          let v288 = (v287 - v23);
          let v572 = r2[v288];
          let v293 = (v572 != 4294967294u);
          let v294 = (v293 | v116);
          if v294 {
            let v311 = (v286 + 1u);
            let v573 = r3[2u][0u];
            let v313 = (v573 != 0u);
            let v314 = (bitcast<i32>(v311) < bitcast<i32>(v572));
            let v315 = (v314 & v313);
            if v315 {
              let v317 = (bitcast<i32>(v572) < bitcast<i32>(v419));
              let v318 = select(0u, 1u, v317);
              p320 = v318;
            } else {
              p320 = 0u;
            }
            let v320 = p320;
            let v321 = (v320 + v572);
            let v322 = (bitcast<i32>(v311) < bitcast<i32>(v321));
            if v322 {
              let v323 = (v287 + 1u);
              p324 = v311;
              var done6 = false;
              loop {
                if done6 { break; }
                let v324 = p324;
                let v576 = r3[0u][3u];
                let v328 = (v576 == 0u);
                let v329 = (v324 ^ 4294967295u);
                let v330 = (v419 + v329);
                let v331 = select(v330, v324, v328);
                let v332 = (v331 + v221);
                let v577 = atomicMax(&r6[v332], v323);
                let v337 = (v324 + 1u);
                let v338 = (v337 == v321);
                p324 = v337;
                done6 = v338;
              }
            }
            let v340 = (v572 < v419);
            if v340 {
              let v579 = r3[0u][3u];
              let v345 = (v579 == 0u);
              let v346 = (v572 ^ 4294967295u);
              let v347 = (v419 + v346);
              let v348 = select(v347, v572, v345);
              let v349 = (v348 + v221);
              let v350 = (v349 * v421);
              let v351 = (v287 % v421);
              let v352 = (v350 + v351);
              let v356 = (v287 + 1u);
              if v32 {
                atomicStore(&r5[v352], v356);
                p357 = false;
              } else {
                p357 = true;
              }
              let v357 = p357;
              if v357 {
                let v581 = atomicMax(&r5[v352], v356);
              }
            }
            p319 = v572;
          } else {
            p319 = v286;
          }
          let v319 = p319;
          let v341 = (v287 + 1u);
          let v342 = (v341 == v27);
          p286 = v319;
          p287 = v341;
          p284 = v319;
          done5 = v342;
        }
      } else {
        p284 = v273;
      }
      let v284 = p284;
      let v279 = (v27 == v419);
      if v279 {
        let v280 = (v284 + 1u);
        let v281 = (bitcast<i32>(v280) < bitcast<i32>(v27));
        if v281 {
          let v283 = (v27 + 1u);
          p295 = v280;
          p296 = v284;
          var done7 = false;
          loop {
            if done7 { break; }
            let v295 = p295;
            let v296 = p296;
            let v584 = r3[0u][3u];
            let v300 = (v584 == 0u);
            let v301 = (v419 - v296);
            let v302 = (v301 + 4294967294u);
            let v303 = select(v302, v295, v300);
            let v304 = (v303 + v221);
            let v585 = atomicMax(&r6[v304], v283);
            let v309 = (v295 + 1u);
            let v310 = (v309 == v27);
            p295 = v309;
            p296 = v295;
            done7 = v310;
          }
        }
      }
    }
  }
  return;
}
