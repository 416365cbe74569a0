@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<atomic<u32>>;
@compute @workgroup_size(64, 1, 1)
fn splat_shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p44: u32;
  var p55: u32;
  var p57: bool;
  var p43: bool;
  var p32: u32;
  var p52: u32;
  var p54: bool;
  var p58: u32;
  var p67: u32;
  var p81: u32;
  var p83: bool;
  var p214: u32;
  var p96: u32;
  var p97: u32;
  var p142: u32;
  var p158: u32;
  var p94: u32;
  var p112: u32;
  var p113: u32;
  let v184 = global_invocation_id[0u];
  let v185 = global_invocation_id[1u];
  let v190 = r0[0u][1u];
  let v15 = (v185 < v190);
  let v191 = r0[0u][0u];
  let v17 = (v184 << (3u & 31u));
  let v192 = min(v17, v191);
  let v19 = select(v191, v192, v15);
  let v20 = (v191 - v19);
  let v21 = (v20 < 8u);
  let v22 = (v19 + 8u);
  let v23 = select(v22, v191, v21);
  let v24 = (v19 != v23);
  if v24 {
    let v26 = (v19 < v23);
    if v26 {
      let v193 = r0[0u][3u];
      let v29 = (v193 != 0u);
      let v30 = (v191 * v185);
      if v29 {
        let v41 = (v191 + v30);
        p44 = v19;
        var done0 = false;
        loop {
          if done0 { break; }
          let v44 = p44;
          let v45 = (v44 ^ 4294967295u);
          let v46 = (v41 + v45);
          let v194 = r1[v46];
          let v51 = (v194 == 4294967295u);
          if v51 {
            let v63 = (v44 + 1u);
            let v64 = (v63 == v23);
            p55 = v63;
            p58 = v23;
            p57 = v64;
          } else {
            p58 = v44;
            p57 = true;
          }
          let v55 = p55;
          let v57 = p57;
          p44 = v55;
          done0 = v57;
        }
        p43 = false;
      } else {
        p43 = true;
      }
      let v43 = p43;
      if v43 {
        p32 = v19;
        var done1 = false;
        loop {
          if done1 { break; }
          let v32 = p32;
          let v33 = (v32 + v30);
          let v195 = r1[v33];
          let v38 = (v195 == 4294967295u);
          if v38 {
            let v39 = (v32 + 1u);
            let v40 = (v39 == v23);
            p52 = v39;
            p58 = v23;
            p54 = v40;
          } else {
            p58 = v32;
            p54 = true;
          }
          let v52 = p52;
          let v54 = p54;
          p32 = v52;
          done1 = v54;
        }
      }
    } else {
      p58 = v19;
    }
    let v58 = p58;
    let v59 = (v58 == v23);
    let v60 = (v23 < v191);
    let v61 = (v60 & v59);
    let v62 = (v61 != true);
    if v62 {
      let v65 = (v191 * v185);
      p67 = v19;
      var done2 = false;
      loop {
        if done2 { break; }
        let v67 = p67;
        let v68 = (v67 != 0u);
        if v68 {
          let v69 = (v67 + 4294967295u);
          let v196 = r0[0u][3u];
          let v71 = (v196 == 0u);
          let v72 = (v191 - v67);
          let v73 = select(v72, v69, v71);
          let v74 = (v73 + v65);
          let v197 = r1[v74];
          let v79 = (v197 + 4294967295u);
          let v80 = (v79 != 4294967294u);
          p81 = v69;
          p214 = v79;
          p83 = v80;
        } else {
          p214 = 4294967295u;
          p83 = true;
        }
        let v81 = p81;
        let v83 = p83;
        p67 = v81;
        done2 = v83;
      }
      let v214 = p214;
      let v84 = (v58 < v23);
      if v84 {
        p96 = v214;
        p97 = v58;
        var done3 = false;
        loop {
          if done3 { break; }
          let v96 = p96;
          let v97 = p97;
          let v199 = r0[0u][3u];
          let v100 = (v199 == 0u);
          let v101 = (v97 ^ 4294967295u);
          let v102 = (v191 + v101);
          let v103 = select(v102, v97, v100);
          let v105 = (v103 + v65);
          let v200 = r1[v105];
          let v110 = (v200 + 4294967295u);
          let v111 = (v110 != 4294967294u);
          if v111 {
            let v130 = (v96 + 1u);
            let v201 = r0[2u][0u];
            let v132 = (v201 != 0u);
            let v133 = (bitcast<i32>(v130) < bitcast<i32>(v110));
            let v134 = (v133 & v132);
            let v135 = (bitcast<i32>(v110) < bitcast<i32>(v191));
            let v136 = (v135 & v134);
            let v137 = select(0u, 1u, v136);
            let v138 = (v110 + v137);
            let v139 = (bitcast<i32>(v130) < bitcast<i32>(v138));
            if v139 {
              let v140 = (v97 + 1u);
              p142 = v130;
              var done4 = false;
              loop {
                if done4 { break; }
                let v142 = p142;
                let v147 = (v142 ^ 4294967295u);
                let v148 = (v191 + v147);
                let v149 = select(v148, v142, v100);
                let v150 = (v149 + v65);
                let v204 = atomicMax(&r3[v150], v140);
                let v155 = (v142 + 1u);
                let v156 = (v155 == v138);
                p142 = v155;
                done4 = v156;
              }
            }
            let v159 = (v110 < v191);
            if v159 {
              let v163 = (v191 - v200);
              let v164 = select(v163, v110, v100);
              let v165 = (v164 + v65);
              let v169 = (v97 + 1u);
              let v207 = atomicMax(&r2[v165], v169);
            }
            p158 = v110;
          } else {
            p158 = v96;
          }
          let v158 = p158;
          let v128 = (v97 + 1u);
          let v129 = (v128 >= v23);
          p96 = v158;
          p97 = v128;
          p94 = v158;
          done3 = v129;
        }
      } else {
        p94 = v214;
      }
      let v94 = p94;
      let v89 = (v23 == v191);
      if v89 {
        let v90 = (v94 + 1u);
        let v91 = (bitcast<i32>(v90) < bitcast<i32>(v23));
        if v91 {
          let v93 = (v23 + 1u);
          p112 = v90;
          p113 = v94;
          var done5 = false;
          loop {
            if done5 { break; }
            let v112 = p112;
            let v113 = p113;
            let v210 = r0[0u][3u];
            let v117 = (v210 == 0u);
            let v118 = (v191 - v113);
            let v119 = (v118 + 4294967294u);
            let v120 = select(v119, v112, v117);
            let v121 = (v120 + v65);
            let v211 = atomicMax(&r3[v121], v93);
            let v126 = (v112 + 1u);
            let v127 = (v126 == v23);
            p112 = v126;
            p113 = v112;
            done5 = v127;
          }
        }
      }
    }
  }
  return;
}
