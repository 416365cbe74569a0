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
  var p34: u32;
  var p35: u32;
  var p41: u32;
  var p42: u32;
  var p43: u32;
  var p44: u32;
  var p45: u32;
  var p88: u32;
  var p52: bool;
  var p364: u32;
  var p139: u32;
  var p140: u32;
  var p154: u32;
  var p158: u32;
  var p193: u32;
  var p194: bool;
  var p191: u32;
  var p137: u32;
  var p138: u32;
  var p176: u32;
  var p177: u32;
  var p207: u32;
  var p216: u32;
  var p217: u32;
  var p218: bool;
  let v258 = global_invocation_id[0u];
  let v264 = r4.w0;
  let v20 = (v264 != 0u);
  if v20 {
    let v21 = (v264 * v258);
    p34 = v21;
    p35 = v264;
    var done0 = false;
    loop {
      if done0 { break; }
      let v34 = p34;
      let v35 = p35;
      let v265 = r3[0u][1u];
      let v37 = (v34 < v265);
      if v37 {
        let v266 = r3[0u][0u];
        let v39 = (v266 != 0u);
        if v39 {
          let v267 = min(v266, 8u);
          p41 = v266;
          p42 = 4294967295u;
          p43 = 0u;
          p44 = v267;
          p45 = 0u;
          var done1 = false;
          loop {
            if done1 { break; }
            let v41 = p41;
            let v42 = p42;
            let v43 = p43;
            let v44 = p44;
            let v45 = p45;
            r0[0u] = 0u;
            r0[1u] = 0u;
            r0[2u] = 0u;
            r0[3u] = 0u;
            r0[4u] = 0u;
            r0[5u] = 0u;
            r0[6u] = 0u;
            r0[7u] = 0u;
            let v46 = (v44 - v45);
            let v47 = (v46 != 8u);
            if v47 {
              let v48 = (v45 < v44);
              if v48 {
                let v49 = (v41 * v34);
                let v276 = r3[0u][3u];
                let v51 = (v276 == 0u);
                p88 = v45;
                var done2 = false;
                loop {
                  if done2 { break; }
                  let v88 = p88;
                  let v89 = (v88 - v45);
                  let v90 = (v88 ^ 4294967295u);
                  let v91 = (v41 + v90);
                  let v92 = select(v91, v88, v51);
                  let v93 = (v92 + v49);
                  let v277 = (v93 * 2u);
                  let v278 = r5[v277];
                  r0[v89] = v278;
                  let v100 = (v88 + 1u);
                  let v101 = (v100 == v44);
                  p88 = v100;
                  done2 = v101;
                }
              }
              p52 = false;
            } else {
              p52 = true;
            }
            let v52 = p52;
            if v52 {
              let v281 = r3[0u][3u];
              let v54 = (v281 == 0u);
              let v55 = (v44 + 4294967295u);
              let v282 = select(7u, 0u, v54);
              let v57 = select(v55, v45, v54);
              let v58 = (v41 * v34);
              let v59 = (v57 ^ 4294967295u);
              let v60 = (v41 + v59);
              let v61 = select(v60, v45, v54);
              let v62 = (v61 + v58);
              let v283 = (v62 * 2u);
              let v284 = (v282 * 2u);
              let v285 = (v283 + v284);
              let v286 = r5[v285];
              r0[0u] = v286;
              let v289 = (v282 ^ 1u);
              let v291 = (v289 * 2u);
              let v292 = (v283 + v291);
              let v293 = r5[v292];
              r0[1u] = v293;
              let v296 = (v282 ^ 2u);
              let v298 = (v296 * 2u);
              let v299 = (v283 + v298);
              let v300 = r5[v299];
              r0[2u] = v300;
              let v303 = (v282 ^ 3u);
              let v305 = (v303 * 2u);
              let v306 = (v283 + v305);
              let v307 = r5[v306];
              r0[3u] = v307;
              let v310 = (v282 ^ 4u);
              let v312 = (v310 * 2u);
              let v313 = (v283 + v312);
              let v314 = r5[v313];
              r0[4u] = v314;
              let v317 = (v282 ^ 5u);
              let v319 = (v317 * 2u);
              let v320 = (v283 + v319);
              let v321 = r5[v320];
              r0[5u] = v321;
              let v324 = (v282 ^ 6u);
              let v326 = (v324 * 2u);
              let v327 = (v283 + v326);
              let v328 = r5[v327];
              r0[6u] = v328;
              let v331 = (v282 ^ 7u);
              let v333 = (v331 * 2u);
              let v334 = (v283 + v333);
              let v335 = r5[v334];
              r0[7u] = v335;
            }
            let v338 = r0[0u];
            let v339 = r0[1u];
            let v340 = r0[2u];
            let v341 = r0[3u];
            let v342 = r0[4u];
            let v343 = r0[5u];
            let v344 = r0[6u];
            let v345 = r0[7u];
            r1[0u] = v338;
            r1[1u] = v339;
            r1[2u] = v340;
            r1[3u] = v341;
            r1[4u] = v342;
            r1[5u] = v343;
            r1[6u] = v344;
            r1[7u] = v345;
            r2[0u] = 0u;
            r2[1u] = 0u;
            r2[2u] = 0u;
            r2[3u] = 0u;
            r2[4u] = 0u;
            r2[5u] = 0u;
            r2[6u] = 0u;
            r2[7u] = 0u;
            let v362 = r3[0u][2u];
            let v363 = bitcast<f32>(v362);
            p364 = 0u;
            var done3 = false;
            loop {
              if done3 { break; }
              let v364 = p364;
              let v366 = (v364 + 1u);
              let v367 = r1[v364];
              let v368 = bitcast<f32>(v367);
              let v108 = (v368 == bitcast<f32>(bits_7f800000));
              let v109 = (v368 + -1.0f);
              let v110 = (v109 / v368);
              let v111 = (v363 * v110);
              let v112 = select(v111, v363, v108);
              let v113 = (v112 > -1048576.0f);
              let v114 = select(-1048576.0f, v112, v113);
              let v115 = (v114 < 1048576.0f);
              let v116 = select(1048576.0f, v114, v115);
              let v117 = (v116 + 12582912.0f);
              let v118 = bitcast<u32>(v117);
              let v119 = (v118 + 3032481792u);
              let v120 = f32(bitcast<i32>(v119));
              let v121 = (v116 - v120);
              let v122 = (v121 >= 0.5f);
              let v123 = select(0u, 1u, v122);
              let v124 = (v45 + v364);
              let v125 = (v124 + v119);
              let v126 = (v125 + v123);
              let v369 = bitcast<u32>(min(bitcast<i32>(v41), bitcast<i32>(v126)));
              let v370 = bitcast<u32>(max(bitcast<i32>(v369), bitcast<i32>(4294967295u)));
              r2[v364] = v370;
              let v372 = (v366 == 8u);
              p364 = v366;
              done3 = v372;
            }
            let v131 = (v45 < v44);
            if v131 {
              p139 = v42;
              p140 = v45;
              var done4 = false;
              loop {
                if done4 { break; }
                let v139 = p139;
                let v140 = p140;
                let v141 = (v140 - v45);
                let v373 = r2[v141];
                let v146 = (v139 + 1u);
                let v374 = r3[2u][0u];
                let v148 = (v374 != 0u);
                let v149 = (bitcast<i32>(v146) < bitcast<i32>(v373));
                let v150 = (v149 & v148);
                if v150 {
                  let v152 = (bitcast<i32>(v373) < bitcast<i32>(v266));
                  let v153 = select(0u, 1u, v152);
                  p154 = v153;
                } else {
                  p154 = 0u;
                }
                let v154 = p154;
                let v155 = (v154 + v373);
                let v156 = (bitcast<i32>(v146) < bitcast<i32>(v155));
                if v156 {
                  let v157 = (v140 + 1u);
                  p158 = v146;
                  var done5 = false;
                  loop {
                    if done5 { break; }
                    let v158 = p158;
                    let v160 = (v266 * v34);
                    let v377 = r3[0u][3u];
                    let v162 = (v377 == 0u);
                    let v163 = (v158 ^ 4294967295u);
                    let v164 = (v266 + v163);
                    let v165 = select(v164, v158, v162);
                    let v166 = (v165 + v160);
                    atomicStore(&r7[v166], v157);
                    let v170 = (v158 + 1u);
                    let v171 = (v170 == v155);
                    p158 = v170;
                    done5 = v171;
                  }
                }
                let v173 = (v373 >= v266);
                if v173 {
                  let v174 = (v140 + 1u);
                  p193 = v174;
                  p194 = false;
                } else {
                  p194 = true;
                }
                let v193 = p193;
                let v194 = p194;
                if v194 {
                  let v195 = (v266 * v34);
                  let v380 = r3[0u][3u];
                  let v197 = (v380 == 0u);
                  let v198 = (v373 ^ 4294967295u);
                  let v199 = (v266 + v198);
                  let v200 = select(v199, v373, v197);
                  let v201 = (v200 + v195);
                  let v205 = (v140 + 1u);
                  atomicStore(&r6[v201], v205);
                  p191 = v205;
                } else {
                  p191 = v193;
                }
                let v191 = p191;
                let v192 = (v191 == v44);
                p139 = v373;
                p140 = v191;
                p137 = v373;
                done4 = v192;
              }
              p138 = v266;
            } else {
              p137 = v42;
              p138 = v41;
            }
            let v137 = p137;
            let v138 = p138;
            let v133 = (v44 == v138);
            if v133 {
              let v134 = (v137 + 1u);
              let v135 = (bitcast<i32>(v134) < bitcast<i32>(v44));
              if v135 {
                let v136 = (v44 + 1u);
                p176 = v134;
                p177 = v137;
                var done6 = false;
                loop {
                  if done6 { break; }
                  let v176 = p176;
                  let v177 = p177;
                  let v179 = (v266 * v34);
                  let v384 = r3[0u][3u];
                  let v181 = (v384 == 0u);
                  let v182 = (v266 - v177);
                  let v183 = (v182 + 4294967294u);
                  let v184 = select(v183, v176, v181);
                  let v185 = (v184 + v179);
                  atomicStore(&r7[v185], v136);
                  let v189 = (v176 + 1u);
                  let v190 = (v189 == v44);
                  p176 = v189;
                  p177 = v176;
                  done6 = v190;
                }
                p207 = v266;
              } else {
                p207 = v44;
              }
            } else {
              p207 = v138;
            }
            let v207 = p207;
            let v208 = (v43 + 1u);
            let v209 = (v208 << (3u & 31u));
            let v387 = min(v209, v207);
            let v211 = (v207 - v387);
            let v212 = (v211 < 8u);
            let v213 = (v387 + 8u);
            let v214 = select(v213, v207, v212);
            let v215 = (v387 == v214);
            p41 = v207;
            p42 = v137;
            p43 = v208;
            p44 = v214;
            p45 = v387;
            done1 = v215;
          }
        }
        let v219 = (v34 + 1u);
        let v220 = (v35 + 4294967295u);
        let v221 = (v220 == 0u);
        p216 = v220;
        p217 = v219;
        p218 = v221;
      } else {
        p218 = true;
      }
      let v216 = p216;
      let v217 = p217;
      let v218 = p218;
      p34 = v217;
      p35 = v216;
      done0 = v218;
    }
  }
  return;
}
