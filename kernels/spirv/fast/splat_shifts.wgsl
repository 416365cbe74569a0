@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<atomic<u32>>;
@compute @workgroup_size(64, 1, 1)
fn splat_shifts(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p37: u32;
  var p48: u32;
  var p49: u32;
  var p109: u32;
  var p110: bool;
  var p83: u32;
  var p91: u32;
  var p94: u32;
  var p46: u32;
  var p68: u32;
  let v128 = global_invocation_id[0u];
  let v129 = global_invocation_id[1u];
  let v134 = r0[0u][1u];
  let v15 = (v129 < v134);
  let v135 = r0[0u][0u];
  let v17 = (v128 << (3u & 31u));
  let v136 = min(v17, v135);
  let v19 = select(v135, v136, v15);
  let v20 = (v135 - v19);
  let v21 = (v20 < 8u);
  let v22 = (v19 + 8u);
  let v23 = select(v22, v135, v21);
  let v24 = (v19 != v23);
  if v24 {
    let v25 = (v19 != 0u);
    if v25 {
      let v26 = (v135 * v129);
      let v137 = r0[0u][3u];
      let v29 = (v137 == 0u);
      let v30 = (v19 + 4294967295u);
      let v31 = select(v20, v30, v29);
      let v32 = (v31 + v26);
      let v138 = r1[v32];
      p37 = v138;
    } else {
      p37 = 0u;
    }
    let v37 = p37;
    let v38 = (v19 < v23);
    if v38 {
      p48 = v37;
      p49 = v19;
      var done0 = false;
      loop {
        if done0 { break; }
        let v48 = p48;
        let v49 = p49;
        let v140 = r0[0u][3u];
        let v52 = (v140 == 0u);
        let v53 = (v49 ^ 4294967295u);
        let v54 = (v135 + v53);
        let v55 = select(v54, v49, v52);
        let v56 = (v135 * v129);
        let v57 = (v55 + v56);
        let v141 = r1[v57];
        let v62 = (v141 + 4294967295u);
        let v63 = (v62 >= v135);
        if v63 {
          let v64 = (v49 + 1u);
          p109 = v64;
          p110 = false;
        } else {
          p110 = true;
        }
        let v109 = p109;
        let v110 = p110;
        if v110 {
          let v111 = (v135 - v141);
          let v112 = select(v111, v62, v52);
          let v113 = (v112 + v56);
          let v117 = (v49 + 1u);
          let v142 = atomicMax(&r2[v113], v117);
          p83 = v117;
        } else {
          p83 = v109;
        }
        let v83 = p83;
        let v143 = r0[2u][0u];
        let v85 = (v143 != 0u);
        let v86 = (bitcast<i32>(v48) < bitcast<i32>(v62));
        let v87 = (v86 & v85);
        if v87 {
          let v89 = (bitcast<i32>(v62) < bitcast<i32>(v135));
          let v90 = select(0u, 1u, v89);
          p91 = v90;
        } else {
          p91 = 0u;
        }
        let v91 = p91;
        let v92 = (v91 + v62);
        let v93 = (bitcast<i32>(v48) < bitcast<i32>(v92));
        if v93 {
          p94 = v48;
          var done1 = false;
          loop {
            if done1 { break; }
            let v94 = p94;
            let v99 = (v94 ^ 4294967295u);
            let v100 = (v135 + v99);
            let v101 = select(v100, v94, v52);
            let v102 = (v101 + v56);
            let v147 = atomicMax(&r3[v102], v83);
            let v107 = (v94 + 1u);
            let v108 = (v107 == v92);
            p94 = v107;
            done1 = v108;
          }
        }
        let v43 = (v83 == v23);
        p48 = v141;
        p49 = v83;
        p46 = v141;
        done0 = v43;
      }
    } else {
      p46 = v37;
    }
    let v46 = p46;
    let v45 = (v23 == v135);
    if v45 {
      let v65 = (v23 + 1u);
      let v66 = (bitcast<i32>(v46) < bitcast<i32>(v23));
      if v66 {
        p68 = v46;
        var done2 = false;
        loop {
          if done2 { break; }
          let v68 = p68;
          let v70 = (v135 * v129);
          let v150 = r0[0u][3u];
          let v72 = (v150 == 0u);
          let v73 = (v68 ^ 4294967295u);
          let v74 = (v135 + v73);
          let v75 = select(v74, v68, v72);
          let v76 = (v75 + v70);
          let v151 = atomicMax(&r3[v76], v65);
          let v81 = (v68 + 1u);
          let v82 = (v81 == v23);
          p68 = v81;
          done2 = v82;
        }
      }
    }
  }
  return;
}
