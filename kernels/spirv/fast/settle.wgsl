@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read> r2: array<u32>;
@group(0) @binding(3) var<storage, read> r3: array<u32>;
@group(0) @binding(4) var<storage, read> r4: array<u32>;
@group(0) @binding(5) var<storage, read_write> r5: array<u32>;
@group(0) @binding(6) var<storage, read_write> r6: array<u32>;
@group(0) @binding(7) var<storage, read_write> r7: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn settle(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p45: u32;
  var p84: bool;
  var p132: bool;
  var p74: u32;
  var p75: u32;
  var p77: bool;
  var p79: bool;
  var p109: bool;
  var p87: bool;
  var p141: u32;
  var p142: bool;
  var p146: bool;
  var p68: u32;
  var p69: u32;
  var p70: u32;
  var p73: bool;
  var p155: bool;
  var p158: u32;
  var p159: bool;
  var p160: bool;
  let v201 = global_invocation_id[0u];
  let v202 = global_invocation_id[1u];
  let v211 = r0[0u][1u];
  let v26 = (v202 < v211);
  let v212 = r0[0u][0u];
  let v28 = (v201 << (3u & 31u));
  let v213 = min(v28, v212);
  let v30 = select(v212, v213, v26);
  let v31 = (v212 - v30);
  let v32 = (v31 < 8u);
  let v33 = (v30 + 8u);
  let v34 = select(v33, v212, v32);
  let v35 = (v30 < v34);
  if v35 {
    let v36 = (v212 * v202);
    let v214 = r0[0u][3u];
    let v39 = (v214 == 0u);
    let v40 = (v39 != true);
    p45 = v30;
    var done0 = false;
    loop {
      if done0 { break; }
      let v45 = p45;
      let v46 = (v45 ^ 4294967295u);
      let v47 = (v212 + v46);
      let v48 = select(v47, v45, v39);
      let v49 = (v48 + v36);
      let v215 = r1[v49];
      let v54 = (v215 != 0u);
      if v54 {
        let v55 = (v215 + 4294967295u);
        let v216 = r2[v49];
        let v59 = (v216 >= v215);
        let v217 = r0[1u][0u];
        if v59 {
          let v80 = (bitcast<i32>(v217) >= bitcast<i32>(2u));
          if v80 {
            let v81 = (v217 != 2u);
            p87 = true;
            p132 = v81;
            p84 = false;
          } else {
            p87 = false;
            p132 = false;
            p84 = true;
          }
          let v84 = p84;
          if v84 {
            let v85 = (v217 != 0u);
            p74 = 262143u;
            p75 = v55;
            p73 = true;
            p132 = v85;
          } else {
            p74 = 196607u;
            p75 = 0u;
            p73 = false;
          }
          let v132 = p132;
          if v132 {
            let v218 = r0[1u][1u];
            let v134 = (v45 >= v218);
            let v135 = (v217 == 1u);
            let v136 = (v135 | v134);
            let v137 = (v136 != true);
            p73 = false;
            p77 = v137;
            p87 = v136;
          } else {
            p77 = false;
          }
          p79 = false;
        } else {
          p74 = 196607u;
          p75 = 0u;
          p73 = false;
          p77 = false;
          p87 = false;
          p79 = true;
        }
        let v74 = p74;
        let v75 = p75;
        let v77 = p77;
        let v79 = p79;
        if v79 {
          let v64 = (v217 != 2u);
          let v219 = r0[1u][1u];
          let v66 = (v45 < v219);
          let v67 = select(false, v66, v64);
          if v67 {
            let v88 = (v217 == 1u);
            if v88 {
              let v91 = (v45 == 0u);
              let v92 = (v91 != true);
              if v92 {
                let v95 = (v45 + 4294967295u);
                let v96 = (v212 - v45);
                let v97 = select(v96, v95, v39);
                let v98 = (v97 + v36);
                let v220 = r1[v98];
                let v103 = (v220 == 0u);
                let v104 = (v215 - v220);
                let v105 = (v104 > 2u);
                let v106 = (v103 | v105);
                let v107 = (v106 != true);
                p87 = true;
                p109 = v107;
              } else {
                p87 = false;
                p109 = v91;
              }
              let v109 = p109;
              if v109 {
                let v110 = (v45 + 1u);
                let v111 = (v110 < v212);
                let v112 = (v111 != true);
                if v111 {
                  let v115 = (v212 - v45);
                  let v116 = (v115 + 4294967294u);
                  let v117 = select(v116, v110, v39);
                  let v118 = (v117 + v36);
                  let v221 = r1[v118];
                  let v123 = (v221 == 0u);
                  let v124 = (v221 - v215);
                  let v125 = (v124 > 2u);
                  let v126 = (v123 | v125);
                  p142 = true;
                  p87 = v126;
                } else {
                  p142 = v112;
                  p87 = false;
                }
              } else {
                p142 = false;
              }
            } else {
              p142 = true;
              p87 = false;
            }
          } else {
            p142 = v77;
            p87 = true;
          }
        } else {
          p142 = v77;
        }
        let v87 = p87;
        if v87 {
          p141 = 65536u;
          p142 = true;
        } else {
          p141 = 0u;
        }
        let v141 = p141;
        let v142 = p142;
        if v142 {
          if v40 {
            let v152 = (v212 - v215);
            let v153 = (v141 | v152);
            p69 = v153;
            p70 = v55;
            p155 = true;
            p146 = false;
          } else {
            p69 = v74;
            p70 = v75;
            p155 = false;
            p146 = true;
          }
          let v146 = p146;
          if v146 {
            let v147 = (v141 | v55);
            p69 = v147;
            p160 = true;
          } else {
            p160 = false;
          }
        } else {
          p69 = v74;
          p70 = v75;
          p160 = false;
          p155 = false;
        }
        p68 = v55;
      } else {
        p69 = 196607u;
        p70 = 0u;
        p160 = false;
        p155 = false;
        p73 = true;
      }
      let v68 = p68;
      let v69 = p69;
      let v70 = p70;
      let v73 = p73;
      if v73 {
        p159 = true;
        p155 = v40;
      } else {
        p159 = false;
      }
      let v155 = p155;
      if v155 {
        let v156 = (v70 ^ 4294967295u);
        let v157 = (v212 + v156);
        p158 = v157;
        p159 = false;
        p160 = true;
      } else {
        p158 = v68;
      }
      let v158 = p158;
      let v159 = p159;
      let v160 = p160;
      if v160 {
        let v161 = (v158 + v36);
        r5[v49] = v69;
        let v163 = (v69 < 131072u);
        if v163 {
          let v223 = r0[2u][2u];
          let v165 = (v223 != 0u);
          if v165 {
            let v224 = (v161 * 4u);
            let v225 = r4[v224];
            let v227 = (v224 + 1u);
            let v228 = r4[v227];
            let v230 = (v224 + 2u);
            let v231 = r4[v230];
            let v233 = (v224 + 3u);
            let v234 = r4[v233];
            let v235 = (v49 * 4u);
            r7[v235] = v225;
            let v238 = (v235 + 1u);
            r7[v238] = v228;
            let v241 = (v235 + 2u);
            r7[v241] = v231;
            let v244 = (v235 + 3u);
            r7[v244] = v234;
          }
          let v246 = r0[2u][1u];
          let v173 = (v246 != 0u);
          if v173 {
            let v247 = (v161 * 2u);
            let v248 = r3[v247];
            let v251 = (v247 + 1u);
            let v252 = r3[v251];
            let v253 = (v49 * 2u);
            r6[v253] = v248;
            let v256 = (v253 + 1u);
            r6[v256] = v252;
          }
        }
      }
      if v159 {
        r5[v49] = v69;
      }
      let v166 = (v45 + 1u);
      let v167 = (v166 == v34);
      p45 = v166;
      done0 = v167;
    }
  }
  return;
}
