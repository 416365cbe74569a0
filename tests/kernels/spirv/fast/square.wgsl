@group(0) @binding(0) var<storage, read> r0: array<u32>;
@group(0) @binding(1) var<storage, read_write> r1: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn square(@builtin(global_invocation_id) bi0: vec3<u32>) {
  let v0 = bi0[0];
  let v6 = (arrayLength(&r1) * 1u);
  let v7 = (v6 & 1073741823u);
  let v8 = (v0 < v7);
  if v8 {
    let v19 = r0[v0];
    let v20 = bitcast<f32>(v19);
    let v14 = (v20 * v20);
    let v22 = bitcast<u32>(v14);
    r1[v0] = v22;
  }
  return;
}
