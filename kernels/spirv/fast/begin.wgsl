@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 6>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<u32>;
@group(0) @binding(3) var<storage, read_write> r4: array<u32>;
@compute @workgroup_size(8, 8, 1)
fn begin(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p28: bool;
  var p39: u32;
  var p48: u32;
  var p49: bool;
  var p62: u32;
  var p63: bool;
  var p53: u32;
  var p55: bool;
  var p104: u32;
  var p70: u32;
  let v89 = global_invocation_id[0u];
  let v90 = global_invocation_id[1u];
  let v95 = r0[0u][3u];
  let v14 = (v89 < v95);
  if v14 {
    let v96 = r0[3u][3u];
    let v17 = (v90 < v96);
    if v17 {
      let v18 = (v95 * v90);
      let v19 = (v18 + v89);
      let v97 = r0[5u][2u];
      let v22 = (v97 & 31u);
      let v23 = (1u << (v22 & 31u));
      let v98 = r1.w0;
      let v25 = (v98 != 1u);
      if v25 {
        p104 = v19;
        p28 = false;
      } else {
        p104 = 0u;
        p28 = true;
      }
      let v28 = p28;
      if v28 {
        let v29 = (v23 >> (1u & 31u));
        let v101 = r2[v19];
        let v34 = (v101 < 131072u);
        let v35 = (v29 == 0u);
        let v36 = (v34 | v35);
        let v37 = (v36 != true);
        if v37 {
          p39 = 1u;
          var done0 = false;
          loop {
            if done0 { break; }
            let v39 = p39;
            let v40 = (v89 < v39);
            let v41 = (v40 != true);
            if v41 {
              let v42 = (v19 - v39);
              let v102 = r2[v42];
              let v47 = (v102 >= 131072u);
              p48 = v102;
              p49 = v47;
            } else {
              p49 = v40;
            }
            let v48 = p48;
            let v49 = p49;
            if v49 {
              let v50 = (v39 + v89);
              let v51 = (v50 < v95);
              let v52 = (v51 != true);
              if v51 {
                let v56 = (v39 + v19);
                let v103 = r2[v56];
                let v61 = (v103 >= 131072u);
                p62 = v103;
                p63 = v61;
              } else {
                p63 = v52;
              }
              let v62 = p62;
              let v63 = p63;
              if v63 {
                let v64 = (v39 + 1u);
                let v65 = (v39 == v29);
                p53 = v64;
                p70 = v101;
                p55 = v65;
              } else {
                p70 = v62;
                p55 = true;
              }
            } else {
              p70 = v48;
              p55 = true;
            }
            let v53 = p53;
            let v55 = p55;
            p39 = v53;
            done0 = v55;
          }
        } else {
          p70 = v101;
        }
        p104 = v19;
      } else {
        p70 = 196607u;
      }
      let v104 = p104;
      let v70 = p70;
      let v71 = (v23 + 4294967295u);
      let v72 = (v90 | v89);
      let v73 = (v71 & v72);
      let v74 = (v73 == 0u);
      let v75 = select(524287u, v70, v74);
      r3[v104] = v75;
      let v107 = (v104 * 2u);
      r4[v107] = 3212836864u;
      let v110 = (v107 + 1u);
      r4[v110] = 4294967295u;
    }
  }
  return;
}
