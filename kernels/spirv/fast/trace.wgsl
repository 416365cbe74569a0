@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 6>;
@group(0) @binding(1) var<storage, read_write> r1: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn trace(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v24 = global_invocation_id[0u];
  let v25 = global_invocation_id[1u];
  let v28 = r0[0u][3u];
  let v8 = (v24 < v28);
  if v8 {
    let v29 = r0[3u][3u];
    let v11 = (v25 < v29);
    if v11 {
      let v12 = (v28 * v25);
      let v13 = (v12 + v24);
      let v14 = f32(v24);
      let v30 = r0[4u][3u];
      let v31 = bitcast<f32>(v30);
      let v17 = (v31 * v14);
      let v32 = bitcast<u32>(v17);
      let v33 = (v13 * 2u);
      r1[v33] = v32;
      let v36 = (v33 + 1u);
      r1[v36] = 4294967295u;
    }
  }
  return;
}
