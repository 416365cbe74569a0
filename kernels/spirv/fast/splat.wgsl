@group(0) @binding(0) var<uniform> r3: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r4: array<u32>;
@group(0) @binding(2) var<storage, read_write> r5: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r6: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn splat(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var r2: array<u32, 8>;
  var p93: u32;
  var p92: bool;
  var p36: u32;
  var p48: bool;
  var p510: u32;
  var p204: u32;
  var p195: u32;
  var p197: bool;
  var p112: bool;
  var p198: u32;
  var p216: u32;
  var p261: u32;
  var p262: bool;
  var p221: u32;
  var p226: bool;
  var p573: bool;
  var p575: u32;
  var p576: f32;
  var p264: u32;
  var p265: bool;
  var p266: u32;
  var p279: u32;
  var p280: u32;
  var p313: u32;
  var p317: u32;
  var p312: u32;
  var p277: u32;
  var p288: u32;
  var p289: u32;
  let v401 = global_invocation_id[0u];
  let v402 = global_invocation_id[1u];
  let v407 = r3[0u][1u];
  let v19 = (v402 < v407);
  let v408 = r3[0u][0u];
  let v21 = (v401 << (3u & 31u));
  let v409 = min(v21, v408);
  let v23 = select(v408, v409, v19);
  let v24 = (v408 - v23);
  let v25 = (v24 < 8u);
  let v26 = (v23 + 8u);
  let v27 = select(v26, v408, v25);
  let v28 = (v23 != v27);
  if v28 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v29 = (v27 - v23);
    let v30 = (v29 != 8u);
    if v30 {
      let v31 = (v23 < v27);
      if v31 {
        let v32 = (v408 * v402);
        let v418 = r3[0u][3u];
        let v35 = (v418 != 0u);
        if v35 {
          let v47 = (v408 + v32);
          p93 = v23;
          var done0 = false;
          loop {
            if done0 { break; }
            let v93 = p93;
            let v94 = (v93 - v23);
            let v95 = (v93 ^ 4294967295u);
            let v96 = (v47 + v95);
            let v419 = (v96 * 2u);
            let v420 = r4[v419];
            r0[v94] = v420;
            let v103 = (v93 + 1u);
            let v104 = (v103 == v27);
            p93 = v103;
            done0 = v104;
          }
          p92 = false;
        } else {
          p92 = true;
        }
        let v92 = p92;
        if v92 {
          p36 = v23;
          var done1 = false;
          loop {
            if done1 { break; }
            let v36 = p36;
            let v37 = (v36 - v23);
            let v38 = (v36 + v32);
            let v423 = (v38 * 2u);
            let v424 = r4[v423];
            r0[v37] = v424;
            let v45 = (v36 + 1u);
            let v46 = (v45 == v27);
            p36 = v45;
            done1 = v46;
          }
        }
      }
      p48 = false;
    } else {
      p48 = true;
    }
    let v48 = p48;
    if v48 {
      let v427 = r3[0u][3u];
      let v51 = (v427 == 0u);
      let v52 = (v27 + 4294967295u);
      let v428 = select(7u, 0u, v51);
      let v54 = select(v52, v23, v51);
      let v55 = (v408 * v402);
      let v56 = (v54 ^ 4294967295u);
      let v57 = (v408 + v56);
      let v58 = select(v57, v23, v51);
      let v59 = (v58 + v55);
      let v429 = (v59 * 2u);
      let v430 = (v428 * 2u);
      let v431 = (v429 + v430);
      let v432 = r4[v431];
      r0[0u] = v432;
      let v435 = (v428 ^ 1u);
      let v437 = (v435 * 2u);
      let v438 = (v429 + v437);
      let v439 = r4[v438];
      r0[1u] = v439;
      let v442 = (v428 ^ 2u);
      let v444 = (v442 * 2u);
      let v445 = (v429 + v444);
      let v446 = r4[v445];
      r0[2u] = v446;
      let v449 = (v428 ^ 3u);
      let v451 = (v449 * 2u);
      let v452 = (v429 + v451);
      let v453 = r4[v452];
      r0[3u] = v453;
      let v456 = (v428 ^ 4u);
      let v458 = (v456 * 2u);
      let v459 = (v429 + v458);
      let v460 = r4[v459];
      r0[4u] = v460;
      let v463 = (v428 ^ 5u);
      let v465 = (v463 * 2u);
      let v466 = (v429 + v465);
      let v467 = r4[v466];
      r0[5u] = v467;
      let v470 = (v428 ^ 6u);
      let v472 = (v470 * 2u);
      let v473 = (v429 + v472);
      let v474 = r4[v473];
      r0[6u] = v474;
      let v477 = (v428 ^ 7u);
      let v479 = (v477 * 2u);
      let v480 = (v429 + v479);
      let v481 = r4[v480];
      r0[7u] = v481;
    }
    let v484 = r0[0u];
    let v485 = r0[1u];
    let v486 = r0[2u];
    let v487 = r0[3u];
    let v488 = r0[4u];
    let v489 = r0[5u];
    let v490 = r0[6u];
    let v491 = r0[7u];
    r1[0u] = v484;
    r1[1u] = v485;
    r1[2u] = v486;
    r1[3u] = v487;
    r1[4u] = v488;
    r1[5u] = v489;
    r1[6u] = v490;
    r1[7u] = v491;
    r2[0u] = 0u;
    r2[1u] = 0u;
    r2[2u] = 0u;
    r2[3u] = 0u;
    r2[4u] = 0u;
    r2[5u] = 0u;
    r2[6u] = 0u;
    r2[7u] = 0u;
    let v508 = r3[0u][2u];
    let v509 = bitcast<f32>(v508);
    p510 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v510 = p510;
      let v512 = (v510 + 1u);
      let v513 = r1[v510];
      let v514 = bitcast<f32>(v513);
      let v172 = (v514 == bitcast<f32>(bits_7f800000));
      let v173 = (v514 + -1.0f);
      let v174 = (v173 / v514);
      let v175 = (v509 * v174);
      let v176 = select(v175, v509, v172);
      let v177 = (v176 > -1048576.0f);
      let v178 = select(-1048576.0f, v176, v177);
      let v179 = (v178 < 1048576.0f);
      let v180 = select(1048576.0f, v178, v179);
      let v181 = (v180 + 12582912.0f);
      let v182 = bitcast<u32>(v181);
      let v183 = (v182 + 3032481792u);
      let v184 = f32(bitcast<i32>(v183));
      let v185 = (v180 - v184);
      let v186 = (v185 >= 0.5f);
      let v187 = select(0u, 1u, v186);
      let v188 = (v23 + v510);
      let v189 = (v188 + v183);
      let v190 = (v189 + v187);
      let v515 = bitcast<u32>(min(bitcast<i32>(v408), bitcast<i32>(v190)));
      let v516 = bitcast<u32>(max(bitcast<i32>(v515), bitcast<i32>(4294967295u)));
      r2[v510] = v516;
      let v518 = (v512 == 8u);
      p510 = v512;
      done2 = v518;
    }
    let v519 = r3[2u][3u];
    let v109 = (v519 == 0u);
    let v110 = (v109 != true);
    if v110 {
      let v520 = r1[0u];
      let v521 = bitcast<f32>(v520);
      let v114 = !(v521 >= 0.0f);
      let v522 = r2[0u];
      let v116 = select(v522, 4294967294u, v114);
      r2[0u] = v116;
      let v524 = r1[1u];
      let v525 = bitcast<f32>(v524);
      let v119 = !(v525 >= 0.0f);
      let v526 = r2[1u];
      let v122 = select(v526, 4294967294u, v119);
      r2[1u] = v122;
      let v528 = r1[2u];
      let v529 = bitcast<f32>(v528);
      let v126 = !(v529 >= 0.0f);
      let v530 = r2[2u];
      let v129 = select(v530, 4294967294u, v126);
      r2[2u] = v129;
      let v532 = r1[3u];
      let v533 = bitcast<f32>(v532);
      let v133 = !(v533 >= 0.0f);
      let v534 = r2[3u];
      let v136 = select(v534, 4294967294u, v133);
      r2[3u] = v136;
      let v536 = r1[4u];
      let v537 = bitcast<f32>(v536);
      let v140 = !(v537 >= 0.0f);
      let v538 = r2[4u];
      let v143 = select(v538, 4294967294u, v140);
      r2[4u] = v143;
      let v540 = r1[5u];
      let v541 = bitcast<f32>(v540);
      let v147 = !(v541 >= 0.0f);
      let v542 = r2[5u];
      let v150 = select(v542, 4294967294u, v147);
      r2[5u] = v150;
      let v544 = r1[6u];
      let v545 = bitcast<f32>(v544);
      let v154 = !(v545 >= 0.0f);
      let v546 = r2[6u];
      let v157 = select(v546, 4294967294u, v154);
      r2[6u] = v157;
      let v548 = r1[7u];
      let v549 = bitcast<f32>(v548);
      let v161 = !(v549 >= 0.0f);
      let v550 = r2[7u];
      let v164 = select(v550, 4294967294u, v161);
      r2[7u] = v164;
      let v166 = (v23 < v27);
      if v166 {
        p204 = v23;
        var done3 = false;
        loop {
          if done3 { break; }
          let v204 = p204;
          let v205 = (v204 - v23);
          let v552 = r2[v205];
          let v210 = (v552 == 4294967294u);
          if v210 {
            let v211 = (v204 + 1u);
            let v212 = (v211 == v27);
            p195 = v211;
            p198 = v27;
            p197 = v212;
          } else {
            p198 = v204;
            p197 = true;
          }
          let v195 = p195;
          let v197 = p197;
          p204 = v195;
          done3 = v197;
        }
      } else {
        p198 = v23;
      }
      p112 = false;
    } else {
      p112 = true;
    }
    let v112 = p112;
    if v112 {
      p198 = v23;
    }
    let v198 = p198;
    let v199 = (v198 == v27);
    let v200 = (v27 < v408);
    let v201 = (v200 & v199);
    let v202 = (v201 != true);
    if v202 {
      let v214 = (v408 * v402);
      p216 = v23;
      var done4 = false;
      loop {
        if done4 { break; }
        let v216 = p216;
        let v217 = (v216 != 0u);
        if v217 {
          let v218 = (v216 + 4294967295u);
          let v219 = (v218 < v408);
          let v220 = (v219 != true);
          if v219 {
            let v553 = r3[0u][3u];
            let v228 = (v553 == 0u);
            let v229 = (v408 - v216);
            let v230 = select(v229, v218, v228);
            let v231 = (v230 + v214);
            let v554 = (v231 * 2u);
            let v555 = r4[v554];
            let v556 = bitcast<f32>(v555);
            let v236 = (v556 >= 0.0f);
            let v237 = (v109 | v236);
            let v238 = (v237 != true);
            p573 = false;
            p576 = v556;
            p261 = 4294967294u;
            p262 = v238;
          } else {
            p573 = true;
            p261 = v408;
            p262 = v220;
          }
          let v261 = p261;
          let v262 = p262;
          if v262 {
            let v263 = (v261 != 4294967294u);
            p573 = true;
            p266 = v261;
            p226 = v263;
          } else {
            p266 = 4294967295u;
            p226 = true;
          }
          p221 = v218;
          p575 = v218;
        } else {
          p573 = true;
          p266 = 4294967295u;
          p226 = true;
        }
        let v221 = p221;
        let v226 = p226;
        p216 = v221;
        done4 = v226;
      }
      let v573 = p573;
      let v575 = p575;
      let v576 = p576;
      let v351 = (v573 != true);
      if v351 {
        let v239 = (v576 == bitcast<f32>(bits_7f800000));
        let v240 = (v576 + -1.0f);
        let v241 = (v240 / v576);
        let v242 = (v241 * v509);
        let v243 = select(v242, v509, v239);
        let v244 = (v243 > -1048576.0f);
        let v245 = select(-1048576.0f, v243, v244);
        let v246 = (v245 < 1048576.0f);
        let v247 = select(1048576.0f, v245, v246);
        let v248 = (v247 + 12582912.0f);
        let v249 = bitcast<u32>(v248);
        let v250 = (v249 + 3032481792u);
        let v251 = f32(bitcast<i32>(v250));
        let v252 = (v247 - v251);
        let v253 = (v252 >= 0.5f);
        let v254 = select(0u, 1u, v253);
        let v255 = (v250 + v575);
        let v256 = (v255 + v254);
        let v557 = bitcast<u32>(min(bitcast<i32>(v408), bitcast<i32>(v256)));
        let v558 = bitcast<u32>(max(bitcast<i32>(v557), bitcast<i32>(4294967295u)));
        p264 = v558;
        p265 = false;
      } else {
        p265 = true;
      }
      let v264 = p264;
      let v265 = p265;
      if !v265 {
        p266 = v264;
      }
      let v266 = p266;
      let v267 = (v198 < v27);
      if v267 {
        p279 = v266;
        p280 = v198;
        var done5 = false;
        loop {
          if done5 { break; }
          let v279 = p279;
          let v280 = p280;
          let v281 = (v280 - v23);
          let v559 = r2[v281];
          let v286 = (v559 != 4294967294u);
          let v287 = (v286 | v109);
          if v287 {
            let v304 = (v279 + 1u);
            let v560 = r3[2u][0u];
            let v306 = (v560 != 0u);
            let v307 = (bitcast<i32>(v304) < bitcast<i32>(v559));
            let v308 = (v307 & v306);
            if v308 {
              let v310 = (bitcast<i32>(v559) < bitcast<i32>(v408));
              let v311 = select(0u, 1u, v310);
              p313 = v311;
            } else {
              p313 = 0u;
            }
            let v313 = p313;
            let v314 = (v313 + v559);
            let v315 = (bitcast<i32>(v304) < bitcast<i32>(v314));
            if v315 {
              let v316 = (v280 + 1u);
              p317 = v304;
              var done6 = false;
              loop {
                if done6 { break; }
                let v317 = p317;
                let v563 = r3[0u][3u];
                let v321 = (v563 == 0u);
                let v322 = (v317 ^ 4294967295u);
                let v323 = (v408 + v322);
                let v324 = select(v323, v317, v321);
                let v325 = (v324 + v214);
                let v564 = atomicMax(&r6[v325], v316);
                let v330 = (v317 + 1u);
                let v331 = (v330 == v314);
                p317 = v330;
                done6 = v331;
              }
            }
            let v333 = (v559 < v408);
            if v333 {
              let v566 = r3[0u][3u];
              let v338 = (v566 == 0u);
              let v339 = (v559 ^ 4294967295u);
              let v340 = (v408 + v339);
              let v341 = select(v340, v559, v338);
              let v342 = (v341 + v214);
              let v346 = (v280 + 1u);
              let v567 = atomicMax(&r5[v342], v346);
            }
            p312 = v559;
          } else {
            p312 = v279;
          }
          let v312 = p312;
          let v334 = (v280 + 1u);
          let v335 = (v334 == v27);
          p279 = v312;
          p280 = v334;
          p277 = v312;
          done5 = v335;
        }
      } else {
        p277 = v266;
      }
      let v277 = p277;
      let v272 = (v27 == v408);
      if v272 {
        let v273 = (v277 + 1u);
        let v274 = (bitcast<i32>(v273) < bitcast<i32>(v27));
        if v274 {
          let v276 = (v27 + 1u);
          p288 = v273;
          p289 = v277;
          var done7 = false;
          loop {
            if done7 { break; }
            let v288 = p288;
            let v289 = p289;
            let v570 = r3[0u][3u];
            let v293 = (v570 == 0u);
            let v294 = (v408 - v289);
            let v295 = (v294 + 4294967294u);
            let v296 = select(v295, v288, v293);
            let v297 = (v296 + v214);
            let v571 = atomicMax(&r6[v297], v276);
            let v302 = (v288 + 1u);
            let v303 = (v302 == v27);
            p288 = v302;
            p289 = v288;
            done7 = v303;
          }
        }
      }
    }
  }
  return;
}
