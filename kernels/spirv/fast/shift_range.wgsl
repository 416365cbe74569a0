@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn shift_range(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p24: u32;
  var p25: u32;
  var p26: u32;
  var p58: u32;
  var p62: u32;
  var p63: u32;
  var p101: u32;
  var p102: u32;
  let v83 = global_invocation_id[0u];
  let v88 = r0[0u][1u];
  let v12 = (v83 < v88);
  if v12 {
    let v89 = r0[0u][0u];
    let v14 = (v89 != 0u);
    if v14 {
      let v15 = (v89 * v83);
      let v90 = r0[0u][3u];
      let v18 = (v90 == 0u);
      let v91 = r0[2u][3u];
      let v21 = (v91 == 0u);
      p24 = 0u;
      p25 = 4294967295u;
      p26 = 0u;
      var done0 = false;
      loop {
        if done0 { break; }
        let v24 = p24;
        let v25 = p25;
        let v26 = p26;
        let v27 = (v26 ^ 4294967295u);
        let v28 = (v89 + v27);
        let v29 = select(v28, v26, v18);
        let v30 = (v29 + v15);
        let v92 = (v30 * 2u);
        let v93 = r1[v92];
        let v94 = bitcast<f32>(v93);
        let v35 = (v94 >= 0.0f);
        let v36 = (v35 | v21);
        if v36 {
          let v95 = r0[0u][2u];
          let v96 = bitcast<f32>(v95);
          let v38 = (v94 == bitcast<f32>(bits_7f800000));
          let v39 = (v94 + -1.0f);
          let v40 = (v39 / v94);
          let v41 = (v40 * v96);
          let v42 = select(v41, v96, v38);
          let v43 = (v42 > -1048576.0f);
          let v44 = select(-1048576.0f, v42, v43);
          let v45 = (v44 < 1048576.0f);
          let v46 = select(1048576.0f, v44, v45);
          let v47 = (v46 + 12582912.0f);
          let v48 = bitcast<u32>(v47);
          let v49 = (v48 + 3032481792u);
          let v50 = f32(bitcast<i32>(v49));
          let v51 = (v46 - v50);
          let v52 = (v51 >= 0.5f);
          let v53 = select(0u, 1u, v52);
          let v54 = (v49 + v26);
          let v55 = (v54 + v53);
          let v97 = bitcast<u32>(min(bitcast<i32>(v89), bitcast<i32>(v55)));
          let v98 = bitcast<u32>(max(bitcast<i32>(v97), bitcast<i32>(4294967295u)));
          p58 = v98;
        } else {
          p58 = 4294967294u;
        }
        let v58 = p58;
        let v59 = (v58 < v89);
        if v59 {
          let v66 = (v58 - v26);
          let v67 = (bitcast<i32>(v24) <= bitcast<i32>(v25));
          if v67 {
            let v99 = bitcast<u32>(min(bitcast<i32>(v66), bitcast<i32>(v24)));
            let v100 = bitcast<u32>(max(bitcast<i32>(v66), bitcast<i32>(v25)));
            p63 = v99;
            p62 = v100;
          } else {
            p63 = v66;
            p62 = v66;
          }
        } else {
          p62 = v25;
          p63 = v24;
        }
        let v62 = p62;
        let v63 = p63;
        let v64 = (v26 + 1u);
        let v65 = (v64 == v89);
        p24 = v63;
        p25 = v62;
        p26 = v64;
        p102 = v62;
        p101 = v63;
        done0 = v65;
      }
    } else {
      p101 = 0u;
      p102 = 4294967295u;
    }
    let v101 = p101;
    let v102 = p102;
    let v103 = (v83 * 2u);
    r2[v103] = v101;
    let v106 = (v103 + 1u);
    r2[v106] = v102;
  }
  return;
}
