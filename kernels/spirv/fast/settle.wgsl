@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read> r2: array<u32>;
@group(0) @binding(3) var<storage, read> r3: array<u32>;
@group(0) @binding(4) var<storage, read> r4: array<u32>;
@group(0) @binding(5) var<storage, read_write> r5: array<u32>;
@group(0) @binding(6) var<storage, read_write> r6: array<u32>;
@group(0) @binding(7) var<storage, read_write> r7: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn settle(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p46: u32;
  var p85: bool;
  var p145: bool;
  var p75: u32;
  var p76: u32;
  var p78: bool;
  var p80: bool;
  var p106: bool;
  var p110: bool;
  var p131: bool;
  var p88: bool;
  var p154: u32;
  var p155: bool;
  var p159: bool;
  var p69: u32;
  var p70: u32;
  var p71: u32;
  var p74: bool;
  var p168: bool;
  var p171: u32;
  var p172: bool;
  var p173: bool;
  let v218 = global_invocation_id[0u];
  let v219 = global_invocation_id[1u];
  let v228 = r0[0u][1u];
  let v26 = (v219 < v228);
  let v229 = r0[0u][0u];
  let v28 = (v218 << (3u & 31u));
  let v230 = min(v28, v229);
  let v30 = select(v229, v230, v26);
  let v31 = (v229 - v30);
  let v32 = (v31 < 8u);
  let v33 = (v30 + 8u);
  let v34 = select(v33, v229, v32);
  let v35 = (v30 < v34);
  if v35 {
    let v36 = (v229 * v219);
    let v231 = r0[0u][3u];
    let v39 = (v231 == 0u);
    let v40 = (v39 != true);
    p46 = v30;
    var done0 = false;
    loop {
      if done0 { break; }
      let v46 = p46;
      let v47 = (v46 ^ 4294967295u);
      let v48 = (v229 + v47);
      let v49 = select(v48, v46, v39);
      let v50 = (v49 + v36);
      let v232 = r1[v50];
      let v55 = (v232 != 0u);
      if v55 {
        let v56 = (v232 + 4294967295u);
        let v233 = r2[v50];
        let v60 = (v233 >= v232);
        let v234 = r0[1u][0u];
        if v60 {
          let v81 = (bitcast<i32>(v234) >= bitcast<i32>(2u));
          if v81 {
            let v82 = (v234 != 2u);
            p88 = true;
            p145 = v82;
            p85 = false;
          } else {
            p88 = false;
            p145 = false;
            p85 = true;
          }
          let v85 = p85;
          if v85 {
            let v86 = (v234 != 0u);
            p75 = 262143u;
            p76 = v56;
            p74 = true;
            p145 = v86;
          } else {
            p75 = 196607u;
            p76 = 0u;
            p74 = false;
          }
          let v145 = p145;
          if v145 {
            let v235 = r0[1u][1u];
            let v147 = (v46 >= v235);
            let v148 = (v234 == 1u);
            let v149 = (v148 | v147);
            let v150 = (v149 != true);
            p74 = false;
            p78 = v150;
            p88 = v149;
          } else {
            p78 = false;
          }
          p80 = false;
        } else {
          p75 = 196607u;
          p76 = 0u;
          p74 = false;
          p78 = false;
          p88 = false;
          p80 = true;
        }
        let v75 = p75;
        let v76 = p76;
        let v78 = p78;
        let v80 = p80;
        if v80 {
          let v65 = (v234 != 2u);
          let v236 = r0[1u][1u];
          let v67 = (v46 < v236);
          let v68 = select(false, v67, v65);
          if v68 {
            let v89 = (v234 == 1u);
            if v89 {
              let v92 = (v46 != 0u);
              if v92 {
                let v95 = (v46 + 4294967295u);
                let v96 = (v229 - v46);
                let v97 = select(v96, v95, v39);
                let v98 = (v97 + v36);
                let v237 = r1[v98];
                let v103 = (v237 != 0u);
                if v103 {
                  let v111 = (v232 - v237);
                  let v112 = (v111 > 2u);
                  let v113 = (v112 != true);
                  p88 = v112;
                  p110 = v113;
                  p106 = false;
                } else {
                  p88 = false;
                  p110 = false;
                  p106 = true;
                }
                let v106 = p106;
                if v106 {
                  let v238 = r0[2u][3u];
                  let v108 = (v238 != 0u);
                  p88 = true;
                  p110 = v108;
                }
              } else {
                p88 = false;
                p110 = true;
              }
              let v110 = p110;
              if v110 {
                let v116 = (v46 + 1u);
                let v117 = (v116 < v229);
                if v117 {
                  let v120 = (v229 - v46);
                  let v121 = (v120 + 4294967294u);
                  let v122 = select(v121, v116, v39);
                  let v123 = (v122 + v36);
                  let v239 = r1[v123];
                  let v128 = (v239 != 0u);
                  if v128 {
                    let v137 = (v239 - v232);
                    let v138 = (v137 > 2u);
                    let v139 = (v138 != true);
                    p155 = v139;
                    p88 = v138;
                    p131 = false;
                  } else {
                    p155 = false;
                    p88 = false;
                    p131 = true;
                  }
                  let v131 = p131;
                  if v131 {
                    let v240 = r0[2u][3u];
                    let v133 = (v240 == 0u);
                    let v134 = (v133 != true);
                    p155 = v134;
                    p88 = v133;
                  }
                } else {
                  p155 = true;
                  p88 = false;
                }
              } else {
                p155 = false;
              }
            } else {
              p155 = true;
              p88 = false;
            }
          } else {
            p155 = v78;
            p88 = true;
          }
        } else {
          p155 = v78;
        }
        let v88 = p88;
        if v88 {
          p154 = 65536u;
          p155 = true;
        } else {
          p154 = 0u;
        }
        let v154 = p154;
        let v155 = p155;
        if v155 {
          if v40 {
            let v165 = (v229 - v232);
            let v166 = (v154 | v165);
            p70 = v166;
            p71 = v56;
            p168 = true;
            p159 = false;
          } else {
            p70 = v75;
            p71 = v76;
            p168 = false;
            p159 = true;
          }
          let v159 = p159;
          if v159 {
            let v160 = (v154 | v56);
            p70 = v160;
            p173 = true;
          } else {
            p173 = false;
          }
        } else {
          p70 = v75;
          p71 = v76;
          p173 = false;
          p168 = false;
        }
        p69 = v56;
      } else {
        p70 = 196607u;
        p71 = 0u;
        p173 = false;
        p168 = false;
        p74 = true;
      }
      let v69 = p69;
      let v70 = p70;
      let v71 = p71;
      let v74 = p74;
      if v74 {
        p172 = true;
        p168 = v40;
      } else {
        p172 = false;
      }
      let v168 = p168;
      if v168 {
        let v169 = (v71 ^ 4294967295u);
        let v170 = (v229 + v169);
        p171 = v170;
        p172 = false;
        p173 = true;
      } else {
        p171 = v69;
      }
      let v171 = p171;
      let v172 = p172;
      let v173 = p173;
      if v173 {
        let v174 = (v171 + v36);
        r5[v50] = v70;
        let v176 = (v70 < 131072u);
        if v176 {
          let v242 = r0[2u][2u];
          let v178 = (v242 != 0u);
          if v178 {
            let v243 = (v174 * 4u);
            let v244 = r4[v243];
            let v246 = (v243 + 1u);
            let v247 = r4[v246];
            let v249 = (v243 + 2u);
            let v250 = r4[v249];
            let v252 = (v243 + 3u);
            let v253 = r4[v252];
            let v254 = (v50 * 4u);
            r7[v254] = v244;
            let v257 = (v254 + 1u);
            r7[v257] = v247;
            let v260 = (v254 + 2u);
            r7[v260] = v250;
            let v263 = (v254 + 3u);
            r7[v263] = v253;
          }
          let v265 = r0[2u][1u];
          let v186 = (v265 != 0u);
          if v186 {
            let v266 = (v174 * 2u);
            let v267 = r3[v266];
            let v270 = (v266 + 1u);
            let v271 = r3[v270];
            let v272 = (v50 * 2u);
            r6[v272] = v267;
            let v275 = (v272 + 1u);
            r6[v275] = v271;
          }
        }
      }
      if v172 {
        r5[v50] = v70;
      }
      let v179 = (v46 + 1u);
      let v180 = (v179 == v34);
      p46 = v179;
      done0 = v180;
    }
  }
  return;
}
