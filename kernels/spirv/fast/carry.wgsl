@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 6>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read> r2: array<vec4<u32>>;
@group(0) @binding(3) var<storage, read_write> r3: array<vec4<u32>>;
@compute @workgroup_size(8, 8, 1)
fn carry(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p25: bool;
  let v67 = global_invocation_id[0u];
  let v68 = global_invocation_id[1u];
  let v73 = r0[5u][2u];
  let v15 = (v73 & 31u);
  let v16 = (v67 << (v15 & 31u));
  let v17 = (v68 << (v15 & 31u));
  let v74 = r0[5u][3u];
  let v20 = (v74 == 0u);
  let v21 = (v20 != true);
  if v21 {
    let v22 = (v68 | v67);
    let v23 = (v22 & 1u);
    let v24 = (v23 != 0u);
    p25 = v24;
  } else {
    p25 = v20;
  }
  let v25 = p25;
  if v25 {
    let v75 = r0[0u][3u];
    let v28 = (v16 < v75);
    let v76 = r0[3u][3u];
    let v31 = (v17 < v76);
    let v32 = select(false, v31, v28);
    if v32 {
      let v33 = (v75 * v17);
      let v34 = (v33 + v16);
      let v77 = r1[v34];
      let v39 = (v77 < 131072u);
      if v39 {
        let v40 = (v77 > 65535u);
        let v41 = select(0u, 1u, v40);
        let v42 = (v77 & 65535u);
        let v43 = (v42 + v33);
        let v78 = (v43 * 2u);
        let v79 = r2[v78];
        let v80 = v79[3u];
        let v83 = v79[0u];
        let v86 = v79[1u];
        let v89 = v79[2u];
        let v90 = (v34 * 2u);
        r3[v90] = vec4<u32>(v83, v86, v89, v80);
        let v99 = (v90 + 1u);
        r3[v99] = vec4<u32>(v41, 0u, 0u, 0u);
      }
    }
  }
  return;
}
