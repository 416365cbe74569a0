@group(0) @binding(0) var<storage, read> r0: array<u32>;
@group(0) @binding(1) var<storage, read_write> r1: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn square(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v19 = global_invocation_id[0u];
  let v23 = (arrayLength(&r1) * 1u);
  let v7 = (v23 & 1073741823u);
  let v8 = (v19 < v7);
  if v8 {
    let v24 = r0[v19];
    let v25 = bitcast<f32>(v24);
    let v14 = (v25 * v25);
    let v26 = bitcast<u32>(v14);
    r1[v19] = v26;
  }
  return;
}
