@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r5: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn splat(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p92: u32;
  var p91: bool;
  var p35: u32;
  var p47: bool;
  var p376: u32;
  var p168: u32;
  var p183: u32;
  var p184: u32;
  var p198: u32;
  var p202: u32;
  var p238: u32;
  var p239: bool;
  var p236: u32;
  var p181: u32;
  var p220: u32;
  var p221: u32;
  let v283 = global_invocation_id[0u];
  let v284 = global_invocation_id[1u];
  let v289 = r2[0u][1u];
  let v18 = (v284 < v289);
  let v290 = r2[0u][0u];
  let v20 = (v283 << (3u & 31u));
  let v291 = min(v20, v290);
  let v22 = select(v290, v291, v18);
  let v23 = (v290 - v22);
  let v24 = (v23 < 8u);
  let v25 = (v22 + 8u);
  let v26 = select(v25, v290, v24);
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
    let v28 = (v26 - v22);
    let v29 = (v28 != 8u);
    if v29 {
      let v30 = (v22 < v26);
      if v30 {
        let v31 = (v290 * v284);
        let v300 = r2[0u][3u];
        let v34 = (v300 != 0u);
        if v34 {
          let v46 = (v290 + v31);
          p92 = v22;
          var done0 = false;
          loop {
            if done0 { break; }
            let v92 = p92;
            let v93 = (v92 - v22);
            let v94 = (v92 ^ 4294967295u);
            let v95 = (v46 + v94);
            let v301 = (v95 * 2u);
            let v302 = r3[v301];
            r0[v93] = v302;
            let v102 = (v92 + 1u);
            let v103 = (v102 == v26);
            p92 = v102;
            done0 = v103;
          }
          p91 = false;
        } else {
          p91 = true;
        }
        let v91 = p91;
        if v91 {
          p35 = v22;
          var done1 = false;
          loop {
            if done1 { break; }
            let v35 = p35;
            let v36 = (v35 - v22);
            let v37 = (v35 + v31);
            let v305 = (v37 * 2u);
            let v306 = r3[v305];
            r0[v36] = v306;
            let v44 = (v35 + 1u);
            let v45 = (v44 == v26);
            p35 = v44;
            done1 = v45;
          }
        }
      }
      p47 = false;
    } else {
      p47 = true;
    }
    let v47 = p47;
    if v47 {
      let v309 = r2[0u][3u];
      let v50 = (v309 == 0u);
      let v51 = (v26 + 4294967295u);
      let v310 = select(7u, 0u, v50);
      let v53 = select(v51, v22, v50);
      let v54 = (v290 * v284);
      let v55 = (v53 ^ 4294967295u);
      let v56 = (v290 + v55);
      let v57 = select(v56, v22, v50);
      let v58 = (v57 + v54);
      let v311 = (v58 * 2u);
      let v312 = (v310 * 2u);
      let v313 = (v311 + v312);
      let v314 = r3[v313];
      r0[0u] = v314;
      let v317 = (v310 ^ 1u);
      let v319 = (v317 * 2u);
      let v320 = (v311 + v319);
      let v321 = r3[v320];
      r0[1u] = v321;
      let v324 = (v310 ^ 2u);
      let v326 = (v324 * 2u);
      let v327 = (v311 + v326);
      let v328 = r3[v327];
      r0[2u] = v328;
      let v331 = (v310 ^ 3u);
      let v333 = (v331 * 2u);
      let v334 = (v311 + v333);
      let v335 = r3[v334];
      r0[3u] = v335;
      let v338 = (v310 ^ 4u);
      let v340 = (v338 * 2u);
      let v341 = (v311 + v340);
      let v342 = r3[v341];
      r0[4u] = v342;
      let v345 = (v310 ^ 5u);
      let v347 = (v345 * 2u);
      let v348 = (v311 + v347);
      let v349 = r3[v348];
      r0[5u] = v349;
      let v352 = (v310 ^ 6u);
      let v354 = (v352 * 2u);
      let v355 = (v311 + v354);
      let v356 = r3[v355];
      r0[6u] = v356;
      let v359 = (v310 ^ 7u);
      let v361 = (v359 * 2u);
      let v362 = (v311 + v361);
      let v363 = r3[v362];
      r0[7u] = v363;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v374 = r2[0u][2u];
    let v375 = bitcast<f32>(v374);
    p376 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v376 = p376;
      let v378 = (v376 + 1u);
      let v379 = r0[v376];
      let v380 = bitcast<f32>(v379);
      let v111 = (v380 == bitcast<f32>(bits_7f800000));
      let v112 = (v380 + -1.0f);
      let v113 = (v112 / v380);
      let v114 = (v375 * v113);
      let v115 = select(v114, v375, v111);
      let v116 = (v115 > -1048576.0f);
      let v117 = select(-1048576.0f, v115, v116);
      let v118 = (v117 < 1048576.0f);
      let v119 = select(1048576.0f, v117, v118);
      let v120 = (v119 + 12582912.0f);
      let v121 = bitcast<u32>(v120);
      let v122 = (v121 + 3032481792u);
      let v123 = f32(bitcast<i32>(v122));
      let v124 = (v119 - v123);
      let v125 = (v124 >= 0.5f);
      let v126 = select(0u, 1u, v125);
      let v127 = (v22 + v376);
      let v128 = (v127 + v122);
      let v129 = (v128 + v126);
      let v381 = bitcast<u32>(min(bitcast<i32>(v290), bitcast<i32>(v129)));
      let v382 = bitcast<u32>(max(bitcast<i32>(v381), bitcast<i32>(4294967295u)));
      r1[v376] = v382;
      let v384 = (v378 == 8u);
      p376 = v378;
      done2 = v384;
    }
    let v134 = (v22 != 0u);
    if v134 {
      let v135 = (v22 + 4294967295u);
      let v136 = (v135 < v290);
      if v136 {
        let v137 = (v290 * v284);
        let v385 = r2[0u][3u];
        let v140 = (v385 == 0u);
        let v141 = select(v23, v135, v140);
        let v142 = (v141 + v137);
        let v386 = (v142 * 2u);
        let v387 = r3[v386];
        let v388 = bitcast<f32>(v387);
        let v147 = (v388 == bitcast<f32>(bits_7f800000));
        let v148 = (v388 + -1.0f);
        let v149 = (v148 / v388);
        let v150 = (v375 * v149);
        let v151 = select(v150, v375, v147);
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
        let v163 = (v158 + v135);
        let v164 = (v163 + v162);
        let v389 = bitcast<u32>(min(bitcast<i32>(v290), bitcast<i32>(v164)));
        let v390 = bitcast<u32>(max(bitcast<i32>(v389), bitcast<i32>(4294967295u)));
        p168 = v390;
      } else {
        p168 = v290;
      }
    } else {
      p168 = 4294967295u;
    }
    let v168 = p168;
    let v169 = (v22 < v26);
    if v169 {
      p183 = v168;
      p184 = v22;
      var done3 = false;
      loop {
        if done3 { break; }
        let v183 = p183;
        let v184 = p184;
        let v185 = (v184 - v22);
        let v391 = r1[v185];
        let v190 = (v183 + 1u);
        let v392 = r2[2u][0u];
        let v192 = (v392 != 0u);
        let v193 = (bitcast<i32>(v190) < bitcast<i32>(v391));
        let v194 = (v193 & v192);
        if v194 {
          let v196 = (bitcast<i32>(v391) < bitcast<i32>(v290));
          let v197 = select(0u, 1u, v196);
          p198 = v197;
        } else {
          p198 = 0u;
        }
        let v198 = p198;
        let v199 = (v198 + v391);
        let v200 = (bitcast<i32>(v190) < bitcast<i32>(v199));
        if v200 {
          let v201 = (v184 + 1u);
          p202 = v190;
          var done4 = false;
          loop {
            if done4 { break; }
            let v202 = p202;
            let v204 = (v290 * v284);
            let v395 = r2[0u][3u];
            let v206 = (v395 == 0u);
            let v207 = (v202 ^ 4294967295u);
            let v208 = (v290 + v207);
            let v209 = select(v208, v202, v206);
            let v210 = (v209 + v204);
            let v396 = atomicMax(&r5[v210], v201);
            let v215 = (v202 + 1u);
            let v216 = (v215 == v199);
            p202 = v215;
            done4 = v216;
          }
        }
        let v218 = (v391 >= v290);
        if v218 {
          let v219 = (v184 + 1u);
          p238 = v219;
          p239 = false;
        } else {
          p239 = true;
        }
        let v238 = p238;
        let v239 = p239;
        if v239 {
          let v240 = (v290 * v284);
          let v398 = r2[0u][3u];
          let v242 = (v398 == 0u);
          let v243 = (v391 ^ 4294967295u);
          let v244 = (v290 + v243);
          let v245 = select(v244, v391, v242);
          let v246 = (v245 + v240);
          let v250 = (v184 + 1u);
          let v399 = atomicMax(&r4[v246], v250);
          p236 = v250;
        } else {
          p236 = v238;
        }
        let v236 = p236;
        let v237 = (v236 == v26);
        p183 = v391;
        p184 = v236;
        p181 = v391;
        done3 = v237;
      }
    } else {
      p181 = v168;
    }
    let v181 = p181;
    let v175 = (v26 == v290);
    if v175 {
      let v176 = (v181 + 1u);
      let v177 = (bitcast<i32>(v176) < bitcast<i32>(v26));
      if v177 {
        let v180 = (v26 + 1u);
        p220 = v176;
        p221 = v181;
        var done5 = false;
        loop {
          if done5 { break; }
          let v220 = p220;
          let v221 = p221;
          let v223 = (v290 * v284);
          let v402 = r2[0u][3u];
          let v225 = (v402 == 0u);
          let v226 = (v290 - v221);
          let v227 = (v226 + 4294967294u);
          let v228 = select(v227, v220, v225);
          let v229 = (v228 + v223);
          let v403 = atomicMax(&r5[v229], v180);
          let v234 = (v220 + 1u);
          let v235 = (v234 == v26);
          p220 = v234;
          p221 = v220;
          done5 = v235;
        }
      }
    }
  }
  return;
}
