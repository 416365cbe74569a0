@group(0) @binding(0) var<storage, read> r1: array<u32>;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<u32>;
@compute @workgroup_size(64, 1, 1)
fn copy(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 3>;
  var p27: f32;
  let v41 = global_invocation_id[0u];
  let v46 = (arrayLength(&r3) * 1u);
  let v12 = (v46 >> (2u & 31u));
  let v13 = (v12 & 268435455u);
  let v14 = (v41 < v13);
  if v14 {
    let v47 = (v41 * 4u);
    let v48 = r1[v47];
    let v50 = (v47 + 1u);
    let v51 = r1[v50];
    let v53 = (v47 + 2u);
    let v54 = r1[v53];
    r0[0u] = v48;
    r0[1u] = v51;
    r0[2u] = v54;
    let v59 = (v47 + 3u);
    let v60 = r1[v59];
    let v61 = bitcast<f32>(v60);
    let v22 = (v61 == 0.0f);
    if v22 {
      let v63 = r2[v47];
      let v66 = r2[v50];
      let v69 = r2[v53];
      r0[0u] = v63;
      r0[1u] = v66;
      r0[2u] = v69;
      let v75 = r2[v59];
      let v76 = bitcast<f32>(v75);
      p27 = v76;
    } else {
      p27 = v61;
    }
    let v27 = p27;
    let v77 = r0[0u];
    let v78 = r0[1u];
    let v79 = r0[2u];
    r3[v47] = v77;
    r3[v50] = v78;
    r3[v53] = v79;
    let v88 = bitcast<u32>(v27);
    r3[v59] = v88;
  }
  return;
}
