@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn shift_range(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p21: u32;
  var p22: u32;
  var p23: u32;
  var p54: u32;
  var p60: u32;
  var p61: u32;
  var p94: u32;
  var p95: u32;
  let v77 = global_invocation_id[0u];
  let v82 = r0[0u][1u];
  let v12 = (v77 < v82);
  if v12 {
    let v83 = r0[0u][0u];
    let v14 = (v83 != 0u);
    if v14 {
      let v15 = (v83 * v77);
      let v84 = r0[0u][3u];
      let v18 = (v84 == 0u);
      p21 = 0u;
      p22 = 4294967295u;
      p23 = 0u;
      var done0 = false;
      loop {
        if done0 { break; }
        let v21 = p21;
        let v22 = p22;
        let v23 = p23;
        let v24 = (v23 ^ 4294967295u);
        let v25 = (v83 + v24);
        let v26 = select(v25, v23, v18);
        let v27 = (v26 + v15);
        let v85 = (v27 * 2u);
        let v86 = r1[v85];
        let v87 = bitcast<f32>(v86);
        let v32 = !(v87 < 0.0f);
        if v32 {
          let v33 = (v87 == bitcast<f32>(bits_7f800000));
          let v88 = r0[0u][2u];
          let v89 = bitcast<f32>(v88);
          let v35 = (v87 + -1.0f);
          let v36 = (v35 / v87);
          let v37 = (v36 * v89);
          let v38 = select(v37, v89, v33);
          let v39 = (v38 > -1048576.0f);
          let v40 = select(-1048576.0f, v38, v39);
          let v41 = (v40 < 1048576.0f);
          let v42 = select(1048576.0f, v40, v41);
          let v43 = (v42 + 12582912.0f);
          let v44 = bitcast<u32>(v43);
          let v45 = (v44 + 3032481792u);
          let v46 = f32(bitcast<i32>(v45));
          let v47 = (v42 - v46);
          let v48 = (v47 >= 0.5f);
          let v49 = select(0u, 1u, v48);
          let v50 = (v45 + v23);
          let v51 = (v50 + v49);
          let v90 = bitcast<u32>(min(bitcast<i32>(v83), bitcast<i32>(v51)));
          let v91 = bitcast<u32>(max(bitcast<i32>(v90), bitcast<i32>(4294967295u)));
          p54 = v91;
        } else {
          p54 = 4294967294u;
        }
        let v54 = p54;
        let v55 = (v54 < v83);
        if v55 {
          let v56 = (v54 - v23);
          let v57 = (bitcast<i32>(v21) <= bitcast<i32>(v22));
          if v57 {
            let v92 = bitcast<u32>(min(bitcast<i32>(v56), bitcast<i32>(v21)));
            let v93 = bitcast<u32>(max(bitcast<i32>(v56), bitcast<i32>(v22)));
            p61 = v92;
            p60 = v93;
          } else {
            p61 = v56;
            p60 = v56;
          }
        } else {
          p60 = v22;
          p61 = v21;
        }
        let v60 = p60;
        let v61 = p61;
        let v62 = (v23 + 1u);
        let v63 = (v62 == v83);
        p21 = v61;
        p22 = v60;
        p23 = v62;
        p95 = v60;
        p94 = v61;
        done0 = v63;
      }
    } else {
      p94 = 0u;
      p95 = 4294967295u;
    }
    let v94 = p94;
    let v95 = p95;
    let v96 = (v77 * 2u);
    r2[v96] = v94;
    let v99 = (v96 + 1u);
    r2[v99] = v95;
  }
  return;
}
