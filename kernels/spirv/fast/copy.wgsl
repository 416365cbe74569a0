@group(0) @binding(0) var<storage, read> r0: array<u32>;
@group(0) @binding(1) var<storage, read_write> r1: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn copy(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v19 = global_invocation_id[0u];
  let v23 = (arrayLength(&r1) * 1u);
  let v7 = (v23 >> (2u & 31u));
  let v8 = (v7 & 268435455u);
  let v9 = (v19 < v8);
  if v9 {
    let v24 = (v19 * 4u);
    let v25 = r0[v24];
    let v27 = (v24 + 1u);
    let v28 = r0[v27];
    let v30 = (v24 + 2u);
    let v31 = r0[v30];
    let v33 = (v24 + 3u);
    let v34 = r0[v33];
    r1[v24] = v25;
    r1[v27] = v28;
    r1[v30] = v31;
    r1[v33] = v34;
  }
  return;
}
