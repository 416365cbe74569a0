@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 6>;
@group(0) @binding(1) var<storage, read_write> r1: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn trace(@builtin(global_invocation_id) bi0: vec3<u32>) {
  let v0 = bi0[0];
  let v1 = bi0[1];
  let v24 = r0[0][3];
  let v8 = (v0 < v24);
  if v8 {
    let v26 = r0[3][3];
    let v11 = (v1 < v26);
    if v11 {
      let v12 = (v24 * v1);
      let v13 = (v12 + v0);
      let v14 = f32(v0);
      let v28 = r0[4][3];
      let v29 = bitcast<f32>(v28);
      let v17 = (v29 * v14);
      let v31 = bitcast<u32>(v17);
      let v32 = (v13 * 2u);
      r1[v32] = v31;
      let v35 = (v32 + 1u);
      r1[v35] = 4294967295u;
    }
  }
  return;
}
