@group(0) @binding(0) var<storage, read_write> r0: array<u32>;
@compute @workgroup_size(8, 1, 1)
fn collide(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v10 = global_invocation_id[0u];
  let v5 = (v10 >> (3u & 31u));
  r0[v5] = v10;
  return;
}
