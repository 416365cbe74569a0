@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 6>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<u32>;
@group(0) @binding(3) var<storage, read_write> r4: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn begin(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p26: u32;
  let v47 = global_invocation_id[0u];
  let v48 = global_invocation_id[1u];
  let v53 = r0[0u][3u];
  let v14 = (v47 < v53);
  if v14 {
    let v54 = r0[3u][3u];
    let v17 = (v48 < v54);
    if v17 {
      let v18 = (v53 * v48);
      let v19 = (v18 + v47);
      let v55 = r1.w0;
      let v21 = (v55 == 1u);
      if v21 {
        let v56 = r2[v19];
        p26 = v56;
      } else {
        p26 = 196607u;
      }
      let v26 = p26;
      let v57 = r0[5u][2u];
      let v29 = (v57 & 31u);
      let v30 = (4294967295u << (v29 & 31u));
      let v31 = (v30 ^ 4294967295u);
      let v32 = (v48 | v47);
      let v33 = (v32 & v31);
      let v34 = (v33 == 0u);
      let v35 = select(524287u, v26, v34);
      r3[v19] = v35;
      let v59 = (v19 * 2u);
      r4[v59] = 3212836864u;
      let v62 = (v59 + 1u);
      r4[v62] = 4294967295u;
    }
  }
  return;
}
