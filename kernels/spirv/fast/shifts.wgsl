@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p90: u32;
  var p89: bool;
  var p33: u32;
  var p28: bool;
  var p102: bool;
  var p104: f32;
  var p142: u32;
  var p166: u32;
  var p191: u32;
  var p216: u32;
  var p241: u32;
  var p266: u32;
  var p291: u32;
  var p316: u32;
  var p320: u32;
  let v371 = global_invocation_id[0u];
  let v372 = global_invocation_id[1u];
  let v376 = r2[0u][1u];
  let v14 = (v372 < v376);
  let v377 = r2[0u][0u];
  let v16 = (v371 << (3u & 31u));
  let v378 = min(v16, v377);
  let v18 = select(v377, v378, v14);
  let v19 = (v377 - v18);
  let v20 = (v19 < 8u);
  let v21 = (v18 + 8u);
  let v22 = select(v21, v377, v20);
  let v23 = (v18 != v22);
  if v23 {
    r0[0u] = 0u;
    r0[1u] = 0u;
    r0[2u] = 0u;
    r0[3u] = 0u;
    r0[4u] = 0u;
    r0[5u] = 0u;
    r0[6u] = 0u;
    r0[7u] = 0u;
    let v24 = (v22 - v18);
    let v25 = (v24 != 8u);
    if v25 {
      let v26 = (v18 < v22);
      if v26 {
        let v29 = (v377 * v372);
        let v387 = r2[0u][3u];
        let v32 = (v387 != 0u);
        if v32 {
          let v44 = (v377 + v29);
          p90 = v18;
          var done0 = false;
          loop {
            if done0 { break; }
            let v90 = p90;
            let v91 = (v90 - v18);
            let v92 = (v90 ^ 4294967295u);
            let v93 = (v44 + v92);
            let v388 = (v93 * 2u);
            let v389 = r3[v388];
            r0[v91] = v389;
            let v100 = (v90 + 1u);
            let v101 = (v100 == v22);
            p90 = v100;
            done0 = v101;
          }
          p89 = false;
        } else {
          p89 = true;
        }
        let v89 = p89;
        if v89 {
          p33 = v18;
          var done1 = false;
          loop {
            if done1 { break; }
            let v33 = p33;
            let v34 = (v33 - v18);
            let v35 = (v33 + v29);
            let v392 = (v35 * 2u);
            let v393 = r3[v392];
            r0[v34] = v393;
            let v42 = (v33 + 1u);
            let v43 = (v42 == v22);
            p33 = v42;
            done1 = v43;
          }
        }
        p102 = true;
      } else {
        p102 = false;
      }
      p28 = false;
    } else {
      p102 = false;
      p28 = true;
    }
    let v28 = p28;
    if v28 {
      let v396 = r2[0u][3u];
      let v48 = (v396 == 0u);
      let v49 = (v22 + 4294967295u);
      let v397 = select(7u, 0u, v48);
      let v51 = select(v49, v18, v48);
      let v52 = (v377 * v372);
      let v53 = (v51 ^ 4294967295u);
      let v54 = (v377 + v53);
      let v55 = select(v54, v18, v48);
      let v56 = (v55 + v52);
      let v398 = (v56 * 2u);
      let v399 = (v397 * 2u);
      let v400 = (v398 + v399);
      let v401 = r3[v400];
      r0[0u] = v401;
      let v404 = (v397 ^ 1u);
      let v406 = (v404 * 2u);
      let v407 = (v398 + v406);
      let v408 = r3[v407];
      r0[1u] = v408;
      let v411 = (v397 ^ 2u);
      let v413 = (v411 * 2u);
      let v414 = (v398 + v413);
      let v415 = r3[v414];
      r0[2u] = v415;
      let v418 = (v397 ^ 3u);
      let v420 = (v418 * 2u);
      let v421 = (v398 + v420);
      let v422 = r3[v421];
      r0[3u] = v422;
      let v425 = (v397 ^ 4u);
      let v427 = (v425 * 2u);
      let v428 = (v398 + v427);
      let v429 = r3[v428];
      r0[4u] = v429;
      let v432 = (v397 ^ 5u);
      let v434 = (v432 * 2u);
      let v435 = (v398 + v434);
      let v436 = r3[v435];
      r0[5u] = v436;
      let v439 = (v397 ^ 6u);
      let v441 = (v439 * 2u);
      let v442 = (v398 + v441);
      let v443 = r3[v442];
      r0[6u] = v443;
      let v446 = (v397 ^ 7u);
      let v448 = (v446 * 2u);
      let v449 = (v398 + v448);
      let v450 = r3[v449];
      r0[7u] = v450;
      p102 = true;
    }
    let v102 = p102;
    if v102 {
      let v453 = r0[0u];
      let v454 = bitcast<f32>(v453);
      p104 = v454;
    } else {
      p104 = 0.0f;
    }
    let v104 = p104;
    let v455 = r0[1u];
    let v456 = bitcast<f32>(v455);
    let v457 = r0[2u];
    let v458 = bitcast<f32>(v457);
    let v459 = r0[3u];
    let v460 = bitcast<f32>(v459);
    let v461 = r0[4u];
    let v462 = bitcast<f32>(v461);
    let v463 = r0[5u];
    let v464 = bitcast<f32>(v463);
    let v465 = r0[6u];
    let v466 = bitcast<f32>(v465);
    let v467 = r0[7u];
    let v468 = bitcast<f32>(v467);
    let v120 = !(v104 < 0.0f);
    if v120 {
      let v121 = (v104 == bitcast<f32>(bits_7f800000));
      let v469 = r2[0u][2u];
      let v470 = bitcast<f32>(v469);
      let v123 = (v104 + -1.0f);
      let v124 = (v123 / v104);
      let v125 = (v124 * v470);
      let v126 = select(v125, v470, v121);
      let v127 = (v126 > -1048576.0f);
      let v128 = select(-1048576.0f, v126, v127);
      let v129 = (v128 < 1048576.0f);
      let v130 = select(1048576.0f, v128, v129);
      let v131 = (v130 + 12582912.0f);
      let v132 = bitcast<u32>(v131);
      let v133 = (v132 + 3032481792u);
      let v134 = f32(bitcast<i32>(v133));
      let v135 = (v130 - v134);
      let v136 = (v135 >= 0.5f);
      let v137 = select(0u, 1u, v136);
      let v138 = (v18 + v133);
      let v139 = (v138 + v137);
      let v471 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v139)));
      let v472 = bitcast<u32>(max(bitcast<i32>(v471), bitcast<i32>(4294967295u)));
      p142 = v472;
    } else {
      p142 = 4294967294u;
    }
    let v142 = p142;
    r1[0u] = v142;
    let v143 = !(v456 < 0.0f);
    if v143 {
      let v144 = (v456 == bitcast<f32>(bits_7f800000));
      let v474 = r2[0u][2u];
      let v475 = bitcast<f32>(v474);
      let v146 = (v456 + -1.0f);
      let v147 = (v146 / v456);
      let v148 = (v147 * v475);
      let v149 = select(v148, v475, v144);
      let v150 = (v149 > -1048576.0f);
      let v151 = select(-1048576.0f, v149, v150);
      let v152 = (v151 < 1048576.0f);
      let v153 = select(1048576.0f, v151, v152);
      let v154 = (v153 + 12582912.0f);
      let v155 = bitcast<u32>(v154);
      let v156 = (v155 + 3032481792u);
      let v157 = f32(bitcast<i32>(v156));
      let v158 = (v153 - v157);
      let v159 = (v158 >= 0.5f);
      let v160 = select(0u, 1u, v159);
      let v161 = (v18 + 1u);
      let v162 = (v161 + v156);
      let v163 = (v162 + v160);
      let v476 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v163)));
      let v477 = bitcast<u32>(max(bitcast<i32>(v476), bitcast<i32>(4294967295u)));
      p166 = v477;
    } else {
      p166 = 4294967294u;
    }
    let v166 = p166;
    r1[1u] = v166;
    let v168 = !(v458 < 0.0f);
    if v168 {
      let v169 = (v458 == bitcast<f32>(bits_7f800000));
      let v479 = r2[0u][2u];
      let v480 = bitcast<f32>(v479);
      let v171 = (v458 + -1.0f);
      let v172 = (v171 / v458);
      let v173 = (v172 * v480);
      let v174 = select(v173, v480, v169);
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
      let v186 = (v18 + 2u);
      let v187 = (v186 + v181);
      let v188 = (v187 + v185);
      let v481 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v188)));
      let v482 = bitcast<u32>(max(bitcast<i32>(v481), bitcast<i32>(4294967295u)));
      p191 = v482;
    } else {
      p191 = 4294967294u;
    }
    let v191 = p191;
    r1[2u] = v191;
    let v193 = !(v460 < 0.0f);
    if v193 {
      let v194 = (v460 == bitcast<f32>(bits_7f800000));
      let v484 = r2[0u][2u];
      let v485 = bitcast<f32>(v484);
      let v196 = (v460 + -1.0f);
      let v197 = (v196 / v460);
      let v198 = (v197 * v485);
      let v199 = select(v198, v485, v194);
      let v200 = (v199 > -1048576.0f);
      let v201 = select(-1048576.0f, v199, v200);
      let v202 = (v201 < 1048576.0f);
      let v203 = select(1048576.0f, v201, v202);
      let v204 = (v203 + 12582912.0f);
      let v205 = bitcast<u32>(v204);
      let v206 = (v205 + 3032481792u);
      let v207 = f32(bitcast<i32>(v206));
      let v208 = (v203 - v207);
      let v209 = (v208 >= 0.5f);
      let v210 = select(0u, 1u, v209);
      let v211 = (v18 + 3u);
      let v212 = (v211 + v206);
      let v213 = (v212 + v210);
      let v486 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v213)));
      let v487 = bitcast<u32>(max(bitcast<i32>(v486), bitcast<i32>(4294967295u)));
      p216 = v487;
    } else {
      p216 = 4294967294u;
    }
    let v216 = p216;
    r1[3u] = v216;
    let v218 = !(v462 < 0.0f);
    if v218 {
      let v219 = (v462 == bitcast<f32>(bits_7f800000));
      let v489 = r2[0u][2u];
      let v490 = bitcast<f32>(v489);
      let v221 = (v462 + -1.0f);
      let v222 = (v221 / v462);
      let v223 = (v222 * v490);
      let v224 = select(v223, v490, v219);
      let v225 = (v224 > -1048576.0f);
      let v226 = select(-1048576.0f, v224, v225);
      let v227 = (v226 < 1048576.0f);
      let v228 = select(1048576.0f, v226, v227);
      let v229 = (v228 + 12582912.0f);
      let v230 = bitcast<u32>(v229);
      let v231 = (v230 + 3032481792u);
      let v232 = f32(bitcast<i32>(v231));
      let v233 = (v228 - v232);
      let v234 = (v233 >= 0.5f);
      let v235 = select(0u, 1u, v234);
      let v236 = (v18 + 4u);
      let v237 = (v236 + v231);
      let v238 = (v237 + v235);
      let v491 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v238)));
      let v492 = bitcast<u32>(max(bitcast<i32>(v491), bitcast<i32>(4294967295u)));
      p241 = v492;
    } else {
      p241 = 4294967294u;
    }
    let v241 = p241;
    r1[4u] = v241;
    let v243 = !(v464 < 0.0f);
    if v243 {
      let v244 = (v464 == bitcast<f32>(bits_7f800000));
      let v494 = r2[0u][2u];
      let v495 = bitcast<f32>(v494);
      let v246 = (v464 + -1.0f);
      let v247 = (v246 / v464);
      let v248 = (v247 * v495);
      let v249 = select(v248, v495, v244);
      let v250 = (v249 > -1048576.0f);
      let v251 = select(-1048576.0f, v249, v250);
      let v252 = (v251 < 1048576.0f);
      let v253 = select(1048576.0f, v251, v252);
      let v254 = (v253 + 12582912.0f);
      let v255 = bitcast<u32>(v254);
      let v256 = (v255 + 3032481792u);
      let v257 = f32(bitcast<i32>(v256));
      let v258 = (v253 - v257);
      let v259 = (v258 >= 0.5f);
      let v260 = select(0u, 1u, v259);
      let v261 = (v18 + 5u);
      let v262 = (v261 + v256);
      let v263 = (v262 + v260);
      let v496 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v263)));
      let v497 = bitcast<u32>(max(bitcast<i32>(v496), bitcast<i32>(4294967295u)));
      p266 = v497;
    } else {
      p266 = 4294967294u;
    }
    let v266 = p266;
    r1[5u] = v266;
    let v268 = !(v466 < 0.0f);
    if v268 {
      let v269 = (v466 == bitcast<f32>(bits_7f800000));
      let v499 = r2[0u][2u];
      let v500 = bitcast<f32>(v499);
      let v271 = (v466 + -1.0f);
      let v272 = (v271 / v466);
      let v273 = (v272 * v500);
      let v274 = select(v273, v500, v269);
      let v275 = (v274 > -1048576.0f);
      let v276 = select(-1048576.0f, v274, v275);
      let v277 = (v276 < 1048576.0f);
      let v278 = select(1048576.0f, v276, v277);
      let v279 = (v278 + 12582912.0f);
      let v280 = bitcast<u32>(v279);
      let v281 = (v280 + 3032481792u);
      let v282 = f32(bitcast<i32>(v281));
      let v283 = (v278 - v282);
      let v284 = (v283 >= 0.5f);
      let v285 = select(0u, 1u, v284);
      let v286 = (v18 + 6u);
      let v287 = (v286 + v281);
      let v288 = (v287 + v285);
      let v501 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v288)));
      let v502 = bitcast<u32>(max(bitcast<i32>(v501), bitcast<i32>(4294967295u)));
      p291 = v502;
    } else {
      p291 = 4294967294u;
    }
    let v291 = p291;
    r1[6u] = v291;
    let v293 = !(v468 < 0.0f);
    if v293 {
      let v294 = (v468 == bitcast<f32>(bits_7f800000));
      let v504 = r2[0u][2u];
      let v505 = bitcast<f32>(v504);
      let v296 = (v468 + -1.0f);
      let v297 = (v296 / v468);
      let v298 = (v297 * v505);
      let v299 = select(v298, v505, v294);
      let v300 = (v299 > -1048576.0f);
      let v301 = select(-1048576.0f, v299, v300);
      let v302 = (v301 < 1048576.0f);
      let v303 = select(1048576.0f, v301, v302);
      let v304 = (v303 + 12582912.0f);
      let v305 = bitcast<u32>(v304);
      let v306 = (v305 + 3032481792u);
      let v307 = f32(bitcast<i32>(v306));
      let v308 = (v303 - v307);
      let v309 = (v308 >= 0.5f);
      let v310 = select(0u, 1u, v309);
      let v311 = (v18 + 7u);
      let v312 = (v311 + v306);
      let v313 = (v312 + v310);
      let v506 = bitcast<u32>(min(bitcast<i32>(v377), bitcast<i32>(v313)));
      let v507 = bitcast<u32>(max(bitcast<i32>(v506), bitcast<i32>(4294967295u)));
      p316 = v507;
    } else {
      p316 = 4294967294u;
    }
    let v316 = p316;
    r1[7u] = v316;
    let v318 = (v18 < v22);
    if v318 {
      p320 = v18;
      var done2 = false;
      loop {
        if done2 { break; }
        let v320 = p320;
        let v322 = (v377 * v372);
        let v510 = r2[0u][3u];
        let v324 = (v510 == 0u);
        let v325 = (v320 ^ 4294967295u);
        let v326 = (v377 + v325);
        let v327 = select(v326, v320, v324);
        let v328 = (v327 + v322);
        let v329 = (v320 - v18);
        let v511 = r1[v329];
        let v334 = (v511 + 1u);
        r4[v328] = v334;
        let v337 = (v320 + 1u);
        let v338 = (v337 == v22);
        p320 = v337;
        done2 = v338;
      }
    }
  }
  return;
}
