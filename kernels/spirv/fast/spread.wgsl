@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 3>;
@group(0) @binding(1) var<uniform> r1: array<vec4<u32>, 6>;
@group(0) @binding(2) var<storage, read> r2: array<u32>;
@group(0) @binding(3) var<storage, read_write> r3: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn spread(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p41: u32;
  let v50 = global_invocation_id[0u];
  let v51 = global_invocation_id[1u];
  let v55 = r1[0u][3u];
  let v12 = (v50 < v55);
  if v12 {
    let v56 = r1[3u][3u];
    let v15 = (v51 < v56);
    if v15 {
      let v16 = (v50 >> (1u & 31u));
      let v57 = r0[0u][0u];
      let v18 = (v16 < v57);
      let v19 = (v57 + 4294967295u);
      let v20 = select(v19, v16, v18);
      let v21 = (v51 >> (1u & 31u));
      let v58 = r0[0u][1u];
      let v24 = (v21 < v58);
      let v25 = (v58 + 4294967295u);
      let v26 = select(v25, v21, v24);
      let v27 = (v55 * v51);
      let v28 = (v27 + v50);
      let v29 = (v26 * v57);
      let v30 = (v29 + v20);
      let v59 = r2[v30];
      let v35 = (v59 < 131072u);
      if v35 {
        let v36 = (v59 << (1u & 31u));
        let v37 = (v36 & 131070u);
        let v38 = (v20 << (1u & 31u));
        let v39 = (v50 - v38);
        let v40 = (v39 + v37);
        p41 = v40;
      } else {
        p41 = v59;
      }
      let v41 = p41;
      r3[v28] = v41;
    }
  }
  return;
}
