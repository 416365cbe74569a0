@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<atomic<u32>>;
@compute @workgroup_size(64, 1, 1)
fn splat_shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p59: u32;
  var p49: u32;
  var p51: bool;
  var p58: bool;
  var p36: u32;
  var p46: u32;
  var p48: bool;
  var p52: u32;
  var p71: u32;
  var p85: u32;
  var p87: bool;
  var p221: u32;
  var p100: u32;
  var p101: u32;
  var p146: u32;
  var p162: u32;
  var p98: u32;
  var p118: u32;
  var p119: u32;
  let v190 = global_invocation_id[0u];
  let v191 = global_invocation_id[1u];
  let v196 = r0[0u][1u];
  let v15 = (v191 < v196);
  let v197 = r0[0u][0u];
  let v17 = (v190 << (3u & 31u));
  let v198 = min(v17, v197);
  let v19 = select(v197, v198, v15);
  let v20 = (v197 - v19);
  let v21 = (v20 < 8u);
  let v22 = (v19 + 8u);
  let v23 = select(v22, v197, v21);
  let v24 = (v19 != v23);
  if v24 {
    let v199 = r0[2u][3u];
    let v27 = (v199 != 0u);
    let v29 = (v19 < v23);
    let v30 = (v27 & v29);
    if v30 {
      let v200 = r0[0u][3u];
      let v33 = (v200 != 0u);
      let v34 = (v197 * v191);
      if v33 {
        let v45 = (v197 + v34);
        p59 = v19;
        var done0 = false;
        loop {
          if done0 { break; }
          let v59 = p59;
          let v60 = (v59 ^ 4294967295u);
          let v61 = (v45 + v60);
          let v201 = r1[v61];
          let v66 = (v201 == 4294967295u);
          if v66 {
            let v67 = (v59 + 1u);
            let v68 = (v67 == v23);
            p49 = v67;
            p52 = v23;
            p51 = v68;
          } else {
            p52 = v59;
            p51 = true;
          }
          let v49 = p49;
          let v51 = p51;
          p59 = v49;
          done0 = v51;
        }
        p58 = false;
      } else {
        p58 = true;
      }
      let v58 = p58;
      if v58 {
        p36 = v19;
        var done1 = false;
        loop {
          if done1 { break; }
          let v36 = p36;
          let v37 = (v36 + v34);
          let v202 = r1[v37];
          let v42 = (v202 == 4294967295u);
          if v42 {
            let v43 = (v36 + 1u);
            let v44 = (v43 == v23);
            p46 = v43;
            p52 = v23;
            p48 = v44;
          } else {
            p52 = v36;
            p48 = true;
          }
          let v46 = p46;
          let v48 = p48;
          p36 = v46;
          done1 = v48;
        }
      }
    } else {
      p52 = v19;
    }
    let v52 = p52;
    let v53 = (v52 == v23);
    let v54 = (v23 < v197);
    let v55 = (v54 & v53);
    let v56 = (v55 != true);
    if v56 {
      let v69 = (v197 * v191);
      p71 = v19;
      var done2 = false;
      loop {
        if done2 { break; }
        let v71 = p71;
        let v72 = (v71 != 0u);
        if v72 {
          let v73 = (v71 + 4294967295u);
          let v203 = r0[0u][3u];
          let v75 = (v203 == 0u);
          let v76 = (v197 - v71);
          let v77 = select(v76, v73, v75);
          let v78 = (v77 + v69);
          let v204 = r1[v78];
          let v83 = (v204 + 4294967295u);
          let v84 = (v83 != 4294967294u);
          p85 = v73;
          p221 = v83;
          p87 = v84;
        } else {
          p221 = 4294967295u;
          p87 = true;
        }
        let v85 = p85;
        let v87 = p87;
        p71 = v85;
        done2 = v87;
      }
      let v221 = p221;
      let v88 = (v52 < v23);
      if v88 {
        p100 = v221;
        p101 = v52;
        var done3 = false;
        loop {
          if done3 { break; }
          let v100 = p100;
          let v101 = p101;
          let v206 = r0[0u][3u];
          let v104 = (v206 == 0u);
          let v105 = (v101 ^ 4294967295u);
          let v106 = (v197 + v105);
          let v107 = select(v106, v101, v104);
          let v109 = (v107 + v69);
          let v207 = r1[v109];
          let v114 = (v207 + 4294967295u);
          let v115 = (v114 == 4294967294u);
          let v116 = (v27 & v115);
          let v117 = (v116 != true);
          if v117 {
            let v134 = (v100 + 1u);
            let v208 = r0[2u][0u];
            let v136 = (v208 != 0u);
            let v137 = (bitcast<i32>(v134) < bitcast<i32>(v114));
            let v138 = (v137 & v136);
            let v139 = (bitcast<i32>(v114) < bitcast<i32>(v197));
            let v140 = (v139 & v138);
            let v141 = select(0u, 1u, v140);
            let v142 = (v114 + v141);
            let v143 = (bitcast<i32>(v134) < bitcast<i32>(v142));
            if v143 {
              let v144 = (v101 + 1u);
              p146 = v134;
              var done4 = false;
              loop {
                if done4 { break; }
                let v146 = p146;
                let v151 = (v146 ^ 4294967295u);
                let v152 = (v197 + v151);
                let v153 = select(v152, v146, v104);
                let v154 = (v153 + v69);
                let v211 = atomicMax(&r3[v154], v144);
                let v159 = (v146 + 1u);
                let v160 = (v159 == v142);
                p146 = v159;
                done4 = v160;
              }
            }
            let v163 = (v114 < v197);
            if v163 {
              let v169 = (v197 - v207);
              let v170 = select(v169, v114, v104);
              let v171 = (v170 + v69);
              let v175 = (v101 + 1u);
              let v214 = atomicMax(&r2[v171], v175);
            }
            p162 = v114;
          } else {
            p162 = v100;
          }
          let v162 = p162;
          let v164 = (v101 + 1u);
          let v165 = (v164 >= v23);
          p100 = v162;
          p101 = v164;
          p98 = v162;
          done3 = v165;
        }
      } else {
        p98 = v221;
      }
      let v98 = p98;
      let v93 = (v23 == v197);
      if v93 {
        let v94 = (v98 + 1u);
        let v95 = (bitcast<i32>(v94) < bitcast<i32>(v23));
        if v95 {
          let v97 = (v23 + 1u);
          p118 = v94;
          p119 = v98;
          var done5 = false;
          loop {
            if done5 { break; }
            let v118 = p118;
            let v119 = p119;
            let v217 = r0[0u][3u];
            let v123 = (v217 == 0u);
            let v124 = (v197 - v119);
            let v125 = (v124 + 4294967294u);
            let v126 = select(v125, v118, v123);
            let v127 = (v126 + v69);
            let v218 = atomicMax(&r3[v127], v97);
            let v132 = (v118 + 1u);
            let v133 = (v132 == v23);
            p118 = v132;
            p119 = v118;
            done5 = v133;
          }
        }
      }
    }
  }
  return;
}
