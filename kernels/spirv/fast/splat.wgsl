@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn splat(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p34: bool;
  var p468: u32;
  var p232: u32;
  var p241: u32;
  var p242: u32;
  var p297: u32;
  var p298: bool;
  var p270: u32;
  var p279: u32;
  var p282: u32;
  var p239: u32;
  var p254: u32;
  var p255: u32;
  let v360 = global_invocation_id[0u];
  let v361 = global_invocation_id[1u];
  let v366 = r2[0u][1u];
  let v18 = (v361 < v366);
  let v367 = r2[0u][0u];
  let v20 = (v360 << (3u & 31u));
  let v368 = min(v20, v367);
  let v22 = select(v367, v368, v18);
  let v23 = (v367 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v367, v24);
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
    let v28 = (v26 + 4294967295u);
    let v29 = (v367 * v361);
    let v377 = r2[0u][3u];
    let v32 = (v377 == 0u);
    let v33 = (v32 != true);
    if v33 {
      let v97 = (v367 + v29);
      let v378 = min(v22, v28);
      let v99 = (v378 ^ 4294967295u);
      let v100 = (v97 + v99);
      let v379 = (v100 * 2u);
      let v380 = r3[v379];
      r0[0u] = v380;
      let v106 = (v22 + 1u);
      let v383 = min(v106, v28);
      let v108 = (v383 ^ 4294967295u);
      let v109 = (v97 + v108);
      let v384 = (v109 * 2u);
      let v385 = r3[v384];
      r0[1u] = v385;
      let v115 = (v22 + 2u);
      let v388 = min(v115, v28);
      let v117 = (v388 ^ 4294967295u);
      let v118 = (v97 + v117);
      let v389 = (v118 * 2u);
      let v390 = r3[v389];
      r0[2u] = v390;
      let v124 = (v22 + 3u);
      let v393 = min(v124, v28);
      let v126 = (v393 ^ 4294967295u);
      let v127 = (v97 + v126);
      let v394 = (v127 * 2u);
      let v395 = r3[v394];
      r0[3u] = v395;
      let v133 = (v22 + 4u);
      let v398 = min(v133, v28);
      let v135 = (v398 ^ 4294967295u);
      let v136 = (v97 + v135);
      let v399 = (v136 * 2u);
      let v400 = r3[v399];
      r0[4u] = v400;
      let v142 = (v22 + 5u);
      let v403 = min(v142, v28);
      let v144 = (v403 ^ 4294967295u);
      let v145 = (v97 + v144);
      let v404 = (v145 * 2u);
      let v405 = r3[v404];
      r0[5u] = v405;
      let v151 = (v22 + 6u);
      let v408 = min(v151, v28);
      let v153 = (v408 ^ 4294967295u);
      let v154 = (v97 + v153);
      let v409 = (v154 * 2u);
      let v410 = r3[v409];
      r0[6u] = v410;
      let v160 = (v22 + 7u);
      let v413 = min(v160, v28);
      let v162 = (v413 ^ 4294967295u);
      let v163 = (v97 + v162);
      let v414 = (v163 * 2u);
      let v415 = r3[v414];
      r0[7u] = v415;
      p34 = false;
    } else {
      p34 = true;
    }
    let v34 = p34;
    if v34 {
      let v418 = min(v22, v28);
      let v36 = (v418 + v29);
      let v419 = (v36 * 2u);
      let v420 = r3[v419];
      r0[0u] = v420;
      let v42 = (v22 + 1u);
      let v423 = min(v42, v28);
      let v44 = (v423 + v29);
      let v424 = (v44 * 2u);
      let v425 = r3[v424];
      r0[1u] = v425;
      let v50 = (v22 + 2u);
      let v428 = min(v50, v28);
      let v52 = (v428 + v29);
      let v429 = (v52 * 2u);
      let v430 = r3[v429];
      r0[2u] = v430;
      let v58 = (v22 + 3u);
      let v433 = min(v58, v28);
      let v60 = (v433 + v29);
      let v434 = (v60 * 2u);
      let v435 = r3[v434];
      r0[3u] = v435;
      let v66 = (v22 + 4u);
      let v438 = min(v66, v28);
      let v68 = (v438 + v29);
      let v439 = (v68 * 2u);
      let v440 = r3[v439];
      r0[4u] = v440;
      let v74 = (v22 + 5u);
      let v443 = min(v74, v28);
      let v76 = (v443 + v29);
      let v444 = (v76 * 2u);
      let v445 = r3[v444];
      r0[5u] = v445;
      let v82 = (v22 + 6u);
      let v448 = min(v82, v28);
      let v84 = (v448 + v29);
      let v449 = (v84 * 2u);
      let v450 = r3[v449];
      r0[6u] = v450;
      let v90 = (v22 + 7u);
      let v453 = min(v90, v28);
      let v92 = (v453 + v29);
      let v454 = (v92 * 2u);
      let v455 = r3[v454];
      r0[7u] = v455;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v466 = r2[0u][2u];
    let v467 = bitcast<f32>(v466);
    p468 = 0u;
    var done0 = false;
    loop {
      if done0 { break; }
      let v468 = p468;
      let v470 = (v468 + 1u);
      let v471 = r0[v468];
      let v472 = bitcast<f32>(v471);
      let v175 = (v472 == bitcast<f32>(bits_7f800000));
      let v176 = (v472 + -1.0f);
      let v177 = (v176 / v472);
      let v178 = (v467 * v177);
      let v179 = select(v178, v467, v175);
      let v180 = (v179 > -1048576.0f);
      let v181 = select(-1048576.0f, v179, v180);
      let v182 = (v181 < 1048576.0f);
      let v183 = select(1048576.0f, v181, v182);
      let v473 = bitcast<u32>(i32(v183));
      let v474 = (v183 > -2147483600.0f);
      let v475 = select(2147483648u, v473, v474);
      let v476 = (v183 >= 2147483600.0f);
      let v477 = select(v475, 2147483647u, v476);
      let v478 = bitcast<u32>(v183);
      let v479 = (v478 & 2147483647u);
      let v480 = (v479 > 2139095040u);
      let v481 = select(v477, 0u, v480);
      let v185 = f32(bitcast<i32>(v481));
      let v186 = (v183 < v185);
      let v187 = select(0u, 4294967295u, v186);
      let v188 = (v481 + v187);
      let v189 = f32(bitcast<i32>(v188));
      let v190 = (v183 - v189);
      let v191 = (v190 >= 0.5f);
      let v192 = select(0u, 1u, v191);
      let v193 = (v22 + v468);
      let v194 = (v193 + v188);
      let v195 = (v194 + v192);
      let v482 = bitcast<u32>(min(bitcast<i32>(v367), bitcast<i32>(v195)));
      let v483 = bitcast<u32>(max(bitcast<i32>(v482), bitcast<i32>(4294967295u)));
      r1[v468] = v483;
      let v485 = (v470 == 8u);
      p468 = v470;
      done0 = v485;
    }
    let v200 = (v22 != 0u);
    if v200 {
      let v201 = (v22 + 4294967295u);
      let v202 = (v201 < v367);
      if v202 {
        let v203 = select(v23, v201, v32);
        let v204 = (v203 + v29);
        let v486 = (v204 * 2u);
        let v487 = r3[v486];
        let v488 = bitcast<f32>(v487);
        let v209 = (v488 == bitcast<f32>(bits_7f800000));
        let v210 = (v488 + -1.0f);
        let v211 = (v210 / v488);
        let v212 = (v467 * v211);
        let v213 = select(v212, v467, v209);
        let v214 = (v213 > -1048576.0f);
        let v215 = select(-1048576.0f, v213, v214);
        let v216 = (v215 < 1048576.0f);
        let v217 = select(1048576.0f, v215, v216);
        let v489 = bitcast<u32>(i32(v217));
        let v490 = (v217 > -2147483600.0f);
        let v491 = select(2147483648u, v489, v490);
        let v492 = (v217 >= 2147483600.0f);
        let v493 = select(v491, 2147483647u, v492);
        let v494 = bitcast<u32>(v217);
        let v495 = (v494 & 2147483647u);
        let v496 = (v495 > 2139095040u);
        let v497 = select(v493, 0u, v496);
        let v219 = f32(bitcast<i32>(v497));
        let v220 = (v217 < v219);
        let v221 = select(0u, 4294967295u, v220);
        let v222 = (v497 + v221);
        let v223 = f32(bitcast<i32>(v222));
        let v224 = (v217 - v223);
        let v225 = (v224 >= 0.5f);
        let v226 = select(0u, 1u, v225);
        let v227 = (v222 + v201);
        let v228 = (v227 + v226);
        let v498 = bitcast<u32>(min(bitcast<i32>(v367), bitcast<i32>(v228)));
        let v499 = bitcast<u32>(max(bitcast<i32>(v498), bitcast<i32>(4294967295u)));
        p232 = v499;
      } else {
        p232 = v367;
      }
    } else {
      p232 = 4294967295u;
    }
    let v232 = p232;
    let v233 = (v22 < v26);
    if v233 {
      p241 = v232;
      p242 = v22;
      var done1 = false;
      loop {
        if done1 { break; }
        let v241 = p241;
        let v242 = p242;
        let v243 = (v242 - v22);
        let v500 = r1[v243];
        let v249 = (v500 >= v367);
        if v249 {
          let v250 = (v242 + 1u);
          p297 = v250;
          p298 = false;
        } else {
          p298 = true;
        }
        let v297 = p297;
        let v298 = p298;
        if v298 {
          let v302 = (v500 ^ 4294967295u);
          let v303 = (v367 + v302);
          let v304 = select(v303, v500, v32);
          let v305 = (v304 + v29);
          let v309 = (v242 + 1u);
          let v503 = atomicMax(&r4[v305], v309);
          p270 = v309;
        } else {
          p270 = v297;
        }
        let v270 = p270;
        let v271 = (v241 + 1u);
        let v504 = r2[2u][0u];
        let v273 = (v504 != 0u);
        let v274 = (bitcast<i32>(v271) < bitcast<i32>(v500));
        let v275 = (v274 & v273);
        if v275 {
          let v277 = (bitcast<i32>(v500) < bitcast<i32>(v367));
          let v278 = select(0u, 1u, v277);
          p279 = v278;
        } else {
          p279 = 0u;
        }
        let v279 = p279;
        let v280 = (v279 + v500);
        let v281 = (bitcast<i32>(v271) < bitcast<i32>(v280));
        if v281 {
          p282 = v271;
          var done2 = false;
          loop {
            if done2 { break; }
            let v282 = p282;
            let v287 = (v282 ^ 4294967295u);
            let v288 = (v367 + v287);
            let v289 = select(v288, v282, v32);
            let v290 = (v289 + v29);
            let v508 = atomicMax(&r5[v290], v270);
            let v295 = (v282 + 1u);
            let v296 = (v295 == v280);
            p282 = v295;
            done2 = v296;
          }
        }
        let v236 = (v270 == v26);
        p241 = v500;
        p242 = v270;
        p239 = v500;
        done1 = v236;
      }
    } else {
      p239 = v232;
    }
    let v239 = p239;
    let v238 = (v26 == v367);
    if v238 {
      let v251 = (v26 + 1u);
      let v252 = (v239 + 1u);
      let v253 = (bitcast<i32>(v252) < bitcast<i32>(v26));
      if v253 {
        p254 = v252;
        p255 = v239;
        var done3 = false;
        loop {
          if done3 { break; }
          let v254 = p254;
          let v255 = p255;
          let v260 = (v367 - v255);
          let v261 = (v260 + 4294967294u);
          let v262 = select(v261, v254, v32);
          let v263 = (v262 + v29);
          let v512 = atomicMax(&r5[v263], v251);
          let v268 = (v254 + 1u);
          let v269 = (v268 == v26);
          p254 = v268;
          p255 = v254;
          done3 = v269;
        }
      }
    }
  }
  return;
}
