@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn shift_range(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p22: u32;
  var p23: u32;
  var p24: u32;
  var p58: u32;
  var p59: u32;
  var p92: u32;
  var p93: u32;
  let v75 = global_invocation_id[0u];
  let v80 = r0[0u][1u];
  let v12 = (v75 < v80);
  if v12 {
    let v81 = r0[0u][0u];
    let v14 = (v81 != 0u);
    if v14 {
      let v15 = (v81 * v75);
      let v82 = r0[0u][3u];
      let v18 = (v82 == 0u);
      let v83 = r0[0u][2u];
      let v84 = bitcast<f32>(v83);
      p22 = 0u;
      p23 = 4294967295u;
      p24 = 0u;
      var done0 = false;
      loop {
        if done0 { break; }
        let v22 = p22;
        let v23 = p23;
        let v24 = p24;
        let v25 = (v24 ^ 4294967295u);
        let v26 = (v81 + v25);
        let v27 = select(v26, v24, v18);
        let v28 = (v27 + v15);
        let v85 = (v28 * 2u);
        let v86 = r1[v85];
        let v87 = bitcast<f32>(v86);
        let v33 = (v87 == bitcast<f32>(bits_7f800000));
        let v34 = (v87 + -1.0f);
        let v35 = (v34 / v87);
        let v36 = (v84 * v35);
        let v37 = select(v36, v84, v33);
        let v38 = (v37 > -1048576.0f);
        let v39 = select(-1048576.0f, v37, v38);
        let v40 = (v39 < 1048576.0f);
        let v41 = select(1048576.0f, v39, v40);
        let v42 = (v41 + 12582912.0f);
        let v43 = bitcast<u32>(v42);
        let v44 = (v43 + 3032481792u);
        let v45 = f32(bitcast<i32>(v44));
        let v46 = (v41 - v45);
        let v47 = (v46 >= 0.5f);
        let v48 = select(0u, 1u, v47);
        let v49 = (v44 + v24);
        let v50 = (v49 + v48);
        let v88 = bitcast<u32>(min(bitcast<i32>(v81), bitcast<i32>(v50)));
        let v89 = bitcast<u32>(max(bitcast<i32>(v88), bitcast<i32>(4294967295u)));
        let v53 = (v89 < v81);
        if v53 {
          let v54 = (v89 - v24);
          let v55 = (bitcast<i32>(v22) <= bitcast<i32>(v23));
          if v55 {
            let v90 = bitcast<u32>(min(bitcast<i32>(v54), bitcast<i32>(v22)));
            let v91 = bitcast<u32>(max(bitcast<i32>(v54), bitcast<i32>(v23)));
            p59 = v90;
            p58 = v91;
          } else {
            p59 = v54;
            p58 = v54;
          }
        } else {
          p58 = v23;
          p59 = v22;
        }
        let v58 = p58;
        let v59 = p59;
        let v60 = (v24 + 1u);
        let v61 = (v60 == v81);
        p22 = v59;
        p23 = v58;
        p24 = v60;
        p93 = v58;
        p92 = v59;
        done0 = v61;
      }
    } else {
      p92 = 0u;
      p93 = 4294967295u;
    }
    let v92 = p92;
    let v93 = p93;
    let v94 = (v75 * 2u);
    r2[v94] = v92;
    let v97 = (v94 + 1u);
    r2[v97] = v93;
  }
  return;
}
