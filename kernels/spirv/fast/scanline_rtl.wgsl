@group(0) @binding(0) var<uniform> r0: array<vec4<u32>, 4>;
struct Push { w0: u32 }
var<immediate> r1: Push;
@group(0) @binding(1) var<storage, read> r2: array<u32>;
@group(0) @binding(2) var<storage, read_write> r3: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> r4: array<atomic<u32>>;
var<private> bits_7f800000: u32 = 2139095040u;
@compute @workgroup_size(8, 1, 1)
fn scanline_rtl(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p25: u32;
  var p26: u32;
  var p34: u32;
  var p35: u32;
  var p49: u32;
  var p99: f32;
  var p100: bool;
  var p129: f32;
  var p133: u32;
  var p134: bool;
  var p54: u32;
  var p60: bool;
  var p223: u32;
  var p224: bool;
  var p226: u32;
  var p227: u32;
  var p228: f32;
  var p152: u32;
  var p153: bool;
  var p154: u32;
  var p168: u32;
  var p31: u32;
  var p32: u32;
  var p33: bool;
  let v196 = global_invocation_id[0u];
  let v202 = r1.w0;
  let v17 = (v202 != 0u);
  if v17 {
    let v18 = (v202 * v196);
    p25 = v18;
    p26 = v202;
    var done0 = false;
    loop {
      if done0 { break; }
      let v25 = p25;
      let v26 = p26;
      let v203 = r0[0u][1u];
      let v28 = (v25 < v203);
      if v28 {
        let v204 = r0[0u][0u];
        let v30 = (v204 * v25);
        p34 = v204;
        p35 = v204;
        var done1 = false;
        loop {
          if done1 { break; }
          let v34 = p34;
          let v35 = p35;
          let v36 = (v34 < v204);
          if v36 {
            let v205 = r0[0u][3u];
            let v38 = (v205 == 0u);
            let v39 = (v34 ^ 4294967295u);
            let v40 = (v204 + v39);
            let v41 = select(v40, v34, v38);
            let v42 = (v41 + v30);
            let v206 = atomicLoad(&r3[v42]);
            let v47 = (v206 == 0u);
            if v47 {
              let v48 = (v35 + 1u);
              atomicStore(&r3[v42], v48);
            }
          }
          p49 = v35;
          var done2 = false;
          loop {
            if done2 { break; }
            let v49 = p49;
            let v50 = (v49 != 0u);
            if v50 {
              let v51 = (v49 + 4294967295u);
              let v53 = (v51 < v204);
              if v53 {
                let v209 = r0[0u][3u];
                let v63 = (v209 == 0u);
                let v64 = (v63 != true);
                let v65 = (v204 - v49);
                let v66 = select(v65, v51, v63);
                let v67 = (v66 + v30);
                let v210 = (v67 * 2u);
                let v211 = r2[v210];
                let v212 = bitcast<f32>(v211);
                let v213 = r0[0u][2u];
                let v214 = bitcast<f32>(v213);
                let v73 = (v212 == bitcast<f32>(bits_7f800000));
                let v74 = (v212 + -1.0f);
                let v75 = (v74 / v212);
                let v76 = (v214 * v75);
                let v77 = select(v76, v214, v73);
                let v215 = r0[2u][3u];
                let v79 = (v215 != 0u);
                if v79 {
                  let v216 = r0[3u][0u];
                  let v81 = (v216 + v25);
                  let v82 = (v215 >> (16u & 31u));
                  let v83 = (v82 ^ v215);
                  let v84 = (v83 * 2146121005u);
                  let v85 = (v84 >> (15u & 31u));
                  let v86 = (v85 ^ v84);
                  let v87 = (v86 * 2221713035u);
                  let v88 = (v87 >> (16u & 31u));
                  let v89 = (v88 ^ v81);
                  let v90 = (v89 ^ v87);
                  let v91 = (v90 >> (16u & 31u));
                  let v92 = (v91 ^ v90);
                  let v93 = (v92 * 2146121005u);
                  let v94 = (v93 >> (15u & 31u));
                  let v95 = (v94 ^ v93);
                  let v96 = (v95 * 2221713035u);
                  let v97 = (v96 >> (16u & 31u));
                  let v98 = (v97 ^ v96);
                  if v64 {
                    let v114 = (v98 ^ v65);
                    let v115 = (v114 >> (16u & 31u));
                    let v116 = (v115 ^ v114);
                    let v117 = (v116 * 2146121005u);
                    let v118 = (v117 >> (15u & 31u));
                    let v119 = (v118 ^ v117);
                    let v120 = (v119 * 2221713035u);
                    let v121 = (v120 >> (16u & 31u));
                    let v122 = (v120 & 65535u);
                    let v123 = (v122 ^ v121);
                    let v124 = f32(v123);
                    let v125 = (v124 * 1.5258789e-5f);
                    let v126 = (v125 + -0.49999237f);
                    let v127 = -(v126);
                    p99 = v127;
                    p100 = false;
                  } else {
                    p100 = true;
                  }
                  let v99 = p99;
                  let v100 = p100;
                  if v100 {
                    let v101 = (v98 ^ v51);
                    let v102 = (v101 >> (16u & 31u));
                    let v103 = (v102 ^ v101);
                    let v104 = (v103 * 2146121005u);
                    let v105 = (v104 >> (15u & 31u));
                    let v106 = (v105 ^ v104);
                    let v107 = (v106 * 2221713035u);
                    let v108 = (v107 >> (16u & 31u));
                    let v109 = (v107 & 65535u);
                    let v110 = (v109 ^ v108);
                    let v111 = f32(v110);
                    let v112 = (v111 * 1.5258789e-5f);
                    let v113 = (v112 + -0.49999237f);
                    p129 = v113;
                  } else {
                    p129 = v99;
                  }
                  let v129 = p129;
                  let v130 = (v77 + v129);
                  p228 = v130;
                } else {
                  p228 = v77;
                }
                let v135 = (v212 < 0.0f);
                p224 = false;
                p133 = 4294967294u;
                p134 = v135;
              } else {
                p224 = true;
                p133 = v204;
                p134 = true;
              }
              let v133 = p133;
              let v134 = p134;
              if v134 {
                let v136 = (v133 != 4294967294u);
                p224 = true;
                p154 = v133;
                p60 = v136;
              } else {
                p154 = 4294967295u;
                p60 = true;
              }
              p54 = v51;
              p226 = v51;
              p227 = v204;
            } else {
              p224 = true;
              p154 = 4294967295u;
              p60 = true;
            }
            let v54 = p54;
            let v60 = p60;
            p49 = v54;
            p223 = v49;
            done2 = v60;
          }
          let v223 = p223;
          let v224 = p224;
          let v226 = p226;
          let v227 = p227;
          let v228 = p228;
          let v188 = (v224 != true);
          if v188 {
            let v137 = (v228 > -1048576.0f);
            let v138 = select(-1048576.0f, v228, v137);
            let v139 = (v138 < 1048576.0f);
            let v140 = select(1048576.0f, v138, v139);
            let v141 = (v140 + 12582912.0f);
            let v142 = bitcast<u32>(v141);
            let v143 = (v142 + 3032481792u);
            let v144 = f32(bitcast<i32>(v143));
            let v145 = (v140 - v144);
            let v146 = (v145 >= 0.5f);
            let v147 = select(0u, 1u, v146);
            let v148 = (v143 + v226);
            let v149 = (v148 + v147);
            let v217 = bitcast<u32>(min(bitcast<i32>(v227), bitcast<i32>(v149)));
            let v218 = bitcast<u32>(max(bitcast<i32>(v217), bitcast<i32>(4294967295u)));
            p152 = v218;
            p153 = false;
          } else {
            p153 = true;
          }
          let v152 = p152;
          let v153 = p153;
          if !v153 {
            p154 = v152;
          }
          let v154 = p154;
          let v155 = (v154 + 1u);
          let v219 = r0[2u][0u];
          let v157 = (v219 != 0u);
          let v158 = (bitcast<i32>(v155) < bitcast<i32>(v34));
          let v159 = (v157 & v158);
          let v160 = (bitcast<i32>(v34) < bitcast<i32>(v204));
          let v161 = (v160 & v159);
          let v162 = select(0u, 1u, v161);
          let v163 = (v34 + v162);
          let v164 = (bitcast<i32>(v155) < bitcast<i32>(v163));
          if v164 {
            let v165 = (v35 + 1u);
            p168 = v155;
            var done3 = false;
            loop {
              if done3 { break; }
              let v168 = p168;
              let v220 = r0[0u][3u];
              let v170 = (v220 == 0u);
              let v171 = (v168 ^ 4294967295u);
              let v172 = (v204 + v171);
              let v173 = select(v172, v168, v170);
              let v174 = (v173 + v30);
              let v221 = atomicLoad(&r4[v174]);
              let v179 = (v221 == 0u);
              if v179 {
                atomicStore(&r4[v174], v165);
              }
              let v180 = (v168 + 1u);
              let v181 = (v180 == v163);
              p168 = v180;
              done3 = v181;
            }
          }
          let v166 = (v223 == 0u);
          let v167 = (v223 + 4294967295u);
          p34 = v154;
          p35 = v167;
          done1 = v166;
        }
        let v182 = (v25 + 1u);
        let v183 = (v26 + 4294967295u);
        let v184 = (v183 == 0u);
        p31 = v183;
        p32 = v182;
        p33 = v184;
      } else {
        p33 = true;
      }
      let v31 = p31;
      let v32 = p32;
      let v33 = p33;
      p25 = v32;
      p26 = v31;
      done0 = v33;
    }
  }
  return;
}
