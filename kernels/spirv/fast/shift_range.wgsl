@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn shift_range(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p22: u32;
  var p23: u32;
  var p24: u32;
  var p60: u32;
  var p61: u32;
  var p103: u32;
  var p104: u32;
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
      let v85 = r0[0u][2u];
      let v86 = bitcast<f32>(v85);
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
        let v26 = (v83 + v25);
        let v27 = select(v26, v24, v18);
        let v28 = (v27 + v15);
        let v87 = (v28 * 2u);
        let v88 = r1[v87];
        let v89 = bitcast<f32>(v88);
        let v33 = (v89 == bitcast<f32>(bits_7f800000));
        let v34 = (v89 + -1.0f);
        let v35 = (v34 / v89);
        let v36 = (v86 * v35);
        let v37 = select(v36, v86, v33);
        let v38 = (v37 > -1048576.0f);
        let v39 = select(-1048576.0f, v37, v38);
        let v40 = (v39 < 1048576.0f);
        let v41 = select(1048576.0f, v39, v40);
        let v90 = bitcast<u32>(i32(v41));
        let v91 = (v41 > -2147483600.0f);
        let v92 = select(2147483648u, v90, v91);
        let v93 = (v41 >= 2147483600.0f);
        let v94 = select(v92, 2147483647u, v93);
        let v95 = bitcast<u32>(v41);
        let v96 = (v95 & 2147483647u);
        let v97 = (v96 > 2139095040u);
        let v98 = select(v94, 0u, v97);
        let v43 = f32(bitcast<i32>(v98));
        let v44 = (v41 < v43);
        let v45 = select(0u, 4294967295u, v44);
        let v46 = (v98 + v45);
        let v47 = f32(bitcast<i32>(v46));
        let v48 = (v41 - v47);
        let v49 = (v48 >= 0.5f);
        let v50 = select(0u, 1u, v49);
        let v51 = (v46 + v24);
        let v52 = (v51 + v50);
        let v99 = bitcast<u32>(min(bitcast<i32>(v83), bitcast<i32>(v52)));
        let v100 = bitcast<u32>(max(bitcast<i32>(v99), bitcast<i32>(4294967295u)));
        let v55 = (v100 < v83);
        if v55 {
          let v56 = (v100 - v24);
          let v57 = (bitcast<i32>(v22) <= bitcast<i32>(v23));
          if v57 {
            let v101 = bitcast<u32>(min(bitcast<i32>(v56), bitcast<i32>(v22)));
            let v102 = bitcast<u32>(max(bitcast<i32>(v56), bitcast<i32>(v23)));
            p61 = v101;
            p60 = v102;
          } else {
            p61 = v56;
            p60 = v56;
          }
        } else {
          p60 = v23;
          p61 = v22;
        }
        let v60 = p60;
        let v61 = p61;
        let v62 = (v24 + 1u);
        let v63 = (v62 == v83);
        p22 = v61;
        p23 = v60;
        p24 = v62;
        p104 = v60;
        p103 = v61;
        done0 = v63;
      }
    } else {
      p103 = 0u;
      p104 = 4294967295u;
    }
    let v103 = p103;
    let v104 = p104;
    let v105 = (v77 * 2u);
    r2[v105] = v103;
    let v108 = (v105 + 1u);
    r2[v108] = v104;
  }
  return;
}
