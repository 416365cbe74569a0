@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<uniform> r1: array<vec4<u32>, 6>;
@group(0) @binding(2) var<storage, read> r2: array<u32>;
@group(0) @binding(3) var<storage, read_write> r3: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn aim(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v42 = global_invocation_id[0u];
  let v43 = global_invocation_id[1u];
  let v47 = r0[0u][0u];
  let v12 = (v42 < v47);
  if v12 {
    let v48 = r0[0u][1u];
    let v15 = (v43 < v48);
    if v15 {
      let v16 = (v47 * v43);
      let v17 = (v16 + v42);
      let v49 = r1[0u][3u];
      let v20 = (v43 << (1u & 31u));
      let v21 = (v20 | 1u);
      let v22 = (v49 * v21);
      let v23 = (v42 << (1u & 31u));
      let v24 = (v23 | 1u);
      let v25 = (v24 + v22);
      let v50 = (v25 * 2u);
      let v51 = r2[v50];
      let v54 = (v50 + 1u);
      let v55 = r2[v54];
      let v56 = (v17 * 2u);
      r3[v56] = v51;
      let v59 = (v56 + 1u);
      r3[v59] = v55;
    }
  }
  return;
}
