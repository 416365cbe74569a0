@group(0) @binding(0) var<storage, read_write> r0: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn clear(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  let v47 = global_invocation_id[0u];
  let v50 = (arrayLength(&r0) * 1u);
  let v5 = (v50 & 1073741823u);
  let v6 = (v47 << (3u & 31u));
  let v7 = (v6 < v5);
  if v7 {
    r0[v6] = 0u;
  }
  let v10 = (v6 | 1u);
  let v11 = (v10 < v5);
  if v11 {
    let v52 = (v6 + 1u);
    r0[v52] = 0u;
  }
  let v14 = (v6 | 2u);
  let v15 = (v14 < v5);
  if v15 {
    let v54 = (v6 + 2u);
    r0[v54] = 0u;
  }
  let v18 = (v6 | 3u);
  let v19 = (v18 < v5);
  if v19 {
    let v56 = (v6 + 3u);
    r0[v56] = 0u;
  }
  let v22 = (v6 | 4u);
  let v23 = (v22 < v5);
  if v23 {
    let v58 = (v6 + 4u);
    r0[v58] = 0u;
  }
  let v26 = (v6 | 5u);
  let v27 = (v26 < v5);
  if v27 {
    let v60 = (v6 + 5u);
    r0[v60] = 0u;
  }
  let v30 = (v6 | 6u);
  let v31 = (v30 < v5);
  if v31 {
    let v62 = (v6 + 6u);
    r0[v62] = 0u;
  }
  let v34 = (v6 | 7u);
  let v35 = (v34 < v5);
  if v35 {
    let v64 = (v6 + 7u);
    r0[v64] = 0u;
  }
  return;
}
