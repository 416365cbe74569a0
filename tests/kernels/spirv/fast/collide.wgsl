@group(0) @binding(0) var<storage, read_write> r0: array<u32>;
@compute @workgroup_size(8, 1, 1)
fn collide(@builtin(global_invocation_id) bi0: vec3<u32>) {
  let v0 = bi0[0];
  let v5 = (v0 >> 3u);
  r0[v5] = v0;
  return;
}
