@group(0) @binding(0) var<uniform> r2: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r3: array<u32>;
@group(0) @binding(2) var<storage, read_write> r4: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(64, 1, 1)
fn shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 8>;
  var r1: array<u32, 8>;
  var p88: u32;
  var p87: bool;
  var p31: u32;
  var p43: bool;
  var p340: u32;
  var p128: f32;
  var p129: bool;
  var p182: f32;
  var p181: f32;
  var p204: u32;
  let v247 = global_invocation_id[0u];
  let v248 = global_invocation_id[1u];
  let v252 = r2[0u][1u];
  let v14 = (v248 < v252);
  let v253 = r2[0u][0u];
  let v16 = (v247 << (3u & 31u));
  let v254 = min(v16, v253);
  let v18 = select(v253, v254, v14);
  let v19 = (v253 - v18);
  let v20 = (v19 < 8u);
  let v21 = (v18 + 8u);
  let v22 = select(v21, v253, v20);
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
        let v27 = (v253 * v248);
        let v263 = r2[0u][3u];
        let v30 = (v263 != 0u);
        if v30 {
          let v42 = (v253 + v27);
          p88 = v18;
          var done0 = false;
          loop {
            if done0 { break; }
            let v88 = p88;
            let v89 = (v88 - v18);
            let v90 = (v88 ^ 4294967295u);
            let v91 = (v42 + v90);
            let v264 = (v91 * 2u);
            let v265 = r3[v264];
            r0[v89] = v265;
            let v98 = (v88 + 1u);
            let v99 = (v98 == v22);
            p88 = v98;
            done0 = v99;
          }
          p87 = false;
        } else {
          p87 = true;
        }
        let v87 = p87;
        if v87 {
          p31 = v18;
          var done1 = false;
          loop {
            if done1 { break; }
            let v31 = p31;
            let v32 = (v31 - v18);
            let v33 = (v31 + v27);
            let v268 = (v33 * 2u);
            let v269 = r3[v268];
            r0[v32] = v269;
            let v40 = (v31 + 1u);
            let v41 = (v40 == v22);
            p31 = v40;
            done1 = v41;
          }
        }
      }
      p43 = false;
    } else {
      p43 = true;
    }
    let v43 = p43;
    if v43 {
      let v272 = r2[0u][3u];
      let v46 = (v272 == 0u);
      let v47 = (v22 + 4294967295u);
      let v273 = select(7u, 0u, v46);
      let v49 = select(v47, v18, v46);
      let v50 = (v253 * v248);
      let v51 = (v49 ^ 4294967295u);
      let v52 = (v253 + v51);
      let v53 = select(v52, v18, v46);
      let v54 = (v53 + v50);
      let v274 = (v54 * 2u);
      let v275 = (v273 * 2u);
      let v276 = (v274 + v275);
      let v277 = r3[v276];
      r0[0u] = v277;
      let v280 = (v273 ^ 1u);
      let v282 = (v280 * 2u);
      let v283 = (v274 + v282);
      let v284 = r3[v283];
      r0[1u] = v284;
      let v287 = (v273 ^ 2u);
      let v289 = (v287 * 2u);
      let v290 = (v274 + v289);
      let v291 = r3[v290];
      r0[2u] = v291;
      let v294 = (v273 ^ 3u);
      let v296 = (v294 * 2u);
      let v297 = (v274 + v296);
      let v298 = r3[v297];
      r0[3u] = v298;
      let v301 = (v273 ^ 4u);
      let v303 = (v301 * 2u);
      let v304 = (v274 + v303);
      let v305 = r3[v304];
      r0[4u] = v305;
      let v308 = (v273 ^ 5u);
      let v310 = (v308 * 2u);
      let v311 = (v274 + v310);
      let v312 = r3[v311];
      r0[5u] = v312;
      let v315 = (v273 ^ 6u);
      let v317 = (v315 * 2u);
      let v318 = (v274 + v317);
      let v319 = r3[v318];
      r0[6u] = v319;
      let v322 = (v273 ^ 7u);
      let v324 = (v322 * 2u);
      let v325 = (v274 + v324);
      let v326 = r3[v325];
      r0[7u] = v326;
    }
    r1[0u] = 0u;
    r1[1u] = 0u;
    r1[2u] = 0u;
    r1[3u] = 0u;
    r1[4u] = 0u;
    r1[5u] = 0u;
    r1[6u] = 0u;
    r1[7u] = 0u;
    let v337 = r2[0u][2u];
    let v338 = bitcast<f32>(v337);
    let v339 = r2[2u][3u];
    let v104 = (v339 != 0u);
    let v107 = (v339 >> (16u & 31u));
    let v108 = (v107 ^ v339);
    let v109 = (v108 * 2146121005u);
    let v110 = (v109 >> (15u & 31u));
    let v111 = (v110 ^ v109);
    let v112 = (v111 * 2221713035u);
    let v113 = (v112 >> (16u & 31u));
    let v114 = (v113 ^ v112);
    p340 = 0u;
    var done2 = false;
    loop {
      if done2 { break; }
      let v340 = p340;
      let v342 = (v340 + 1u);
      let v343 = r0[v340];
      let v344 = bitcast<f32>(v343);
      let v120 = (v18 + v340);
      let v121 = (v344 == bitcast<f32>(bits_7f800000));
      let v122 = (v344 + -1.0f);
      let v123 = (v122 / v344);
      let v124 = (v338 * v123);
      let v125 = select(v124, v338, v121);
      if v104 {
        let v345 = r2[0u][3u];
        let v127 = (v345 != 0u);
        if v127 {
          let v154 = (v120 ^ 4294967295u);
          let v155 = (v253 + v154);
          let v346 = r2[3u][0u];
          let v157 = (v346 + v248);
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
          let v347 = r2[3u][0u];
          let v131 = (v347 + v248);
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
      let v348 = bitcast<u32>(min(bitcast<i32>(v253), bitcast<i32>(v196)));
      let v349 = bitcast<u32>(max(bitcast<i32>(v348), bitcast<i32>(4294967295u)));
      let v199 = (v344 < 0.0f);
      let v200 = select(v349, 4294967294u, v199);
      r1[v340] = v200;
      let v351 = (v342 == 8u);
      p340 = v342;
      done2 = v351;
    }
    let v203 = (v18 < v22);
    if v203 {
      p204 = v18;
      var done3 = false;
      loop {
        if done3 { break; }
        let v204 = p204;
        let v206 = (v253 * v248);
        let v353 = r2[0u][3u];
        let v208 = (v353 == 0u);
        let v209 = (v204 ^ 4294967295u);
        let v210 = (v253 + v209);
        let v211 = select(v210, v204, v208);
        let v212 = (v211 + v206);
        let v213 = (v204 - v18);
        let v354 = r1[v213];
        let v218 = (v354 + 1u);
        r4[v212] = v218;
        let v221 = (v204 + 1u);
        let v222 = (v221 == v22);
        p204 = v221;
        done3 = v222;
      }
    }
  }
  return;
}
