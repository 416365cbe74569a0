@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 1>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read_write> r2: array<u32>;
@group(1) @binding(0) var<storage, read_write> r3: array<atomic<u32>>;
@id(1) override spec1: u32 = 1u;
@compute @workgroup_size(4, 2, 2)
fn number(@builtin(global_invocation_id) global_invocation_id: vec3<u32>, @builtin(workgroup_id) workgroup_id: vec3<u32>, @builtin(num_workgroups) num_workgroups: vec3<u32>, @builtin(local_invocation_index) local_invocation_index: u32) {
  let v44 = global_invocation_id[0u];
  let v45 = global_invocation_id[1u];
  let v46 = global_invocation_id[2u];
  let v47 = local_invocation_index;
  let v48 = workgroup_id[0u];
  let v49 = workgroup_id[1u];
  let v50 = workgroup_id[2u];
  let v51 = num_workgroups[0u];
  let v52 = num_workgroups[1u];
  let v56 = spec1;
  let v57 = atomicAdd(&r3[0u], v56);
  let v58 = r0[0u][0u];
  let v19 = (v44 < v58);
  if v19 {
    let v59 = r0[0u][1u];
    let v22 = (v45 < v59);
    if v22 {
      let v60 = r0[0u][2u];
      let v25 = (v46 < v60);
      if v25 {
        let v26 = (v52 * v50);
        let v27 = (v26 + v49);
        let v28 = (v27 * v51);
        let v29 = (v28 + v48);
        let v30 = (v59 * v46);
        let v31 = (v30 + v45);
        let v32 = (v31 * v58);
        let v33 = (v32 + v44);
        let v61 = r1.w0;
        let v35 = (v29 << (4u & 31u));
        let v36 = (v35 + v47);
        let v37 = (v36 + v61);
        r2[v33] = v37;
      }
    }
  }
  return;
}
