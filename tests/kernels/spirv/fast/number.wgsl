@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 1>;
struct Pc1 { w0: u32 }
var<immediate> r1: Pc1;
@group(0) @binding(1) var<storage, read_write> r2: array<u32>;
@group(1) @binding(0) var<storage, read_write> r3: array<atomic<u32>>;
@id(1) override spec1: u32 = 1u;
@compute @workgroup_size(4, 2, 2)
fn number(@builtin(global_invocation_id) bi0: vec3<u32>, @builtin(workgroup_id) bi2: vec3<u32>, @builtin(num_workgroups) bi3: vec3<u32>, @builtin(local_invocation_index) bi4: u32) {
  let v0 = bi0[0];
  let v1 = bi0[1];
  let v2 = bi0[2];
  let v3 = bi4;
  let v4 = bi2[0];
  let v5 = bi2[1];
  let v6 = bi2[2];
  let v7 = bi3[0];
  let v8 = bi3[1];
  let v16 = spec1;
  let v17 = atomicAdd(&r3[0u], v16);
  let v44 = r0[0][0];
  let v19 = (v0 < v44);
  if v19 {
    let v46 = r0[0][1];
    let v22 = (v1 < v46);
    if v22 {
      let v48 = r0[0][2];
      let v25 = (v2 < v48);
      if v25 {
        let v26 = (v8 * v6);
        let v27 = (v26 + v5);
        let v28 = (v27 * v7);
        let v29 = (v28 + v4);
        let v30 = (v46 * v2);
        let v31 = (v30 + v1);
        let v32 = (v31 * v44);
        let v33 = (v32 + v0);
        let v50 = r1.w0;
        let v35 = (v29 << 4u);
        let v36 = (v35 + v3);
        let v37 = (v36 + v50);
        r2[v33] = v37;
      }
    }
  }
  return;
}
