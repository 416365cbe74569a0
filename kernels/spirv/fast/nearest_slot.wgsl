@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn nearest_slot(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p29: u32;
  var p30: u32;
  var p28: u32;
  let v44 = global_invocation_id[0u];
  let v45 = global_invocation_id[1u];
  let v49 = r0[0u][0u];
  let v10 = (v44 < v49);
  if v10 {
    let v50 = r0[0u][1u];
    let v13 = (v45 < v50);
    if v13 {
      let v14 = (v49 * v45);
      let v51 = r0[0u][3u];
      let v17 = (v51 == 0u);
      let v18 = (v44 ^ 4294967295u);
      let v19 = (v49 + v18);
      let v20 = select(v19, v44, v17);
      let v21 = (v20 + v14);
      let v52 = r0[1u][2u];
      let v24 = (v52 != 0u);
      if v24 {
        let v25 = (v21 * v52);
        p29 = 0u;
        p30 = 0u;
        var done0 = false;
        loop {
          if done0 { break; }
          let v29 = p29;
          let v30 = p30;
          let v31 = (v30 + v25);
          let v53 = r1[v31];
          let v54 = max(v53, v29);
          let v37 = (v30 + 1u);
          let v38 = (v37 == v52);
          p29 = v54;
          p30 = v37;
          p28 = v54;
          done0 = v38;
        }
      } else {
        p28 = 0u;
      }
      let v28 = p28;
      r2[v21] = v28;
    }
  }
  return;
}
