@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<atomic<u32>>;
@compute @workgroup_size(64, 1, 1)
fn splat_shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p37: u32;
  var p53: u32;
  var p54: u32;
  var p79: u32;
  var p114: u32;
  var p115: bool;
  var p112: u32;
  var p51: u32;
  var p97: u32;
  let v137 = global_invocation_id[0u];
  let v138 = global_invocation_id[1u];
  let v143 = r0[0u][1u];
  let v15 = (v138 < v143);
  let v144 = r0[0u][0u];
  let v17 = (v137 << (3u & 31u));
  let v145 = min(v17, v144);
  let v19 = select(v144, v145, v15);
  let v20 = (v144 - v19);
  let v21 = (v20 < 8u);
  let v22 = (v19 + 8u);
  let v23 = select(v22, v144, v21);
  let v24 = (v19 != v23);
  if v24 {
    let v25 = (v19 != 0u);
    if v25 {
      let v26 = (v144 * v138);
      let v146 = r0[0u][3u];
      let v29 = (v146 == 0u);
      let v30 = (v19 + 4294967295u);
      let v31 = select(v20, v30, v29);
      let v32 = (v31 + v26);
      let v147 = r1[v32];
      p37 = v147;
    } else {
      p37 = 0u;
    }
    let v37 = p37;
    let v38 = (v19 < v23);
    if v38 {
      p53 = v37;
      p54 = v19;
      var done0 = false;
      loop {
        if done0 { break; }
        let v53 = p53;
        let v54 = p54;
        let v149 = r0[0u][3u];
        let v57 = (v149 == 0u);
        let v58 = (v54 ^ 4294967295u);
        let v59 = (v144 + v58);
        let v60 = select(v59, v54, v57);
        let v61 = (v144 * v138);
        let v62 = (v60 + v61);
        let v150 = r1[v62];
        let v67 = (v150 + 4294967295u);
        let v151 = r0[2u][0u];
        let v69 = (v151 != 0u);
        let v70 = (bitcast<i32>(v53) < bitcast<i32>(v67));
        let v71 = (v69 & v70);
        let v72 = (bitcast<i32>(v67) < bitcast<i32>(v144));
        let v73 = (v72 & v71);
        let v74 = select(0u, 1u, v73);
        let v75 = (v67 + v74);
        let v76 = (bitcast<i32>(v53) < bitcast<i32>(v75));
        if v76 {
          let v77 = (v54 + 1u);
          p79 = v53;
          var done1 = false;
          loop {
            if done1 { break; }
            let v79 = p79;
            let v84 = (v79 ^ 4294967295u);
            let v85 = (v144 + v84);
            let v86 = select(v85, v79, v57);
            let v87 = (v86 + v61);
            let v154 = atomicMax(&r3[v87], v77);
            let v92 = (v79 + 1u);
            let v93 = (v92 == v75);
            p79 = v92;
            done1 = v93;
          }
        }
        let v95 = (v67 >= v144);
        if v95 {
          let v96 = (v54 + 1u);
          p114 = v96;
          p115 = false;
        } else {
          p115 = true;
        }
        let v114 = p114;
        let v115 = p115;
        if v115 {
          let v119 = (v144 - v150);
          let v120 = select(v119, v67, v57);
          let v121 = (v120 + v61);
          let v125 = (v54 + 1u);
          let v157 = atomicMax(&r2[v121], v125);
          p112 = v125;
        } else {
          p112 = v114;
        }
        let v112 = p112;
        let v113 = (v112 == v23);
        p53 = v150;
        p54 = v112;
        p51 = v150;
        done0 = v113;
      }
    } else {
      p51 = v37;
    }
    let v51 = p51;
    let v45 = (v23 == v144);
    let v46 = (bitcast<i32>(v51) < bitcast<i32>(v144));
    let v47 = (v45 & v46);
    if v47 {
      let v50 = (v23 + 1u);
      p97 = v51;
      var done2 = false;
      loop {
        if done2 { break; }
        let v97 = p97;
        let v99 = (v144 * v138);
        let v160 = r0[0u][3u];
        let v101 = (v160 == 0u);
        let v102 = (v97 ^ 4294967295u);
        let v103 = (v144 + v102);
        let v104 = select(v103, v97, v101);
        let v105 = (v104 + v99);
        let v161 = atomicMax(&r3[v105], v50);
        let v110 = (v97 + 1u);
        let v111 = (v110 == v23);
        p97 = v110;
        done2 = v111;
      }
    }
  }
  return;
}
