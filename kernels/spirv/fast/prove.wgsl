@group(0) @binding(0) var<uniform> r11: array<vec4<u32>, 6>;
@group(0) @binding(1) var<uniform> r12: array<vec4<u32>, 5>;
struct Push { w0: u32 }
var<immediate> r13: Push;
@group(0) @binding(2) var<storage, read> r14: array<vec4<u32>>;
@group(0) @binding(3) var<storage, read> r15: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> r16: array<vec4<u32>>;
@group(0) @binding(5) var<storage, read_write> r17: array<u32>;
@id(0) override spec0: u32 = 2047u;
var<private> bits_7f800000: u32 = 2139095040u;
var<private> bits_ff800000: u32 = 4286578688u;
@compute @workgroup_size(8, 8, 1)
fn prove(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 97>;
  var r1: array<u32, 3>;
  var r2: array<u32, 6>;
  var r3: array<u32, 6>;
  var r4: array<u32, 3>;
  var r5: array<u32, 3>;
  var r6: array<u32, 3>;
  var r7: array<u32, 3>;
  var r8: array<u32, 3>;
  var r9: array<u32, 3>;
  var r10: array<u32, 3>;
  var p53: f32;
  var p54: f32;
  var p55: f32;
  var p56: f32;
  var p57: f32;
  var p58: f32;
  var p59: u32;
  var p90: u32;
  var p91: u32;
  var p137: f32;
  var p138: f32;
  var p139: f32;
  var p140: f32;
  var p141: f32;
  var p142: f32;
  var p1184: f32;
  var p1185: f32;
  var p1186: f32;
  var p1187: f32;
  var p1188: f32;
  var p1189: f32;
  var p251: u32;
  var p880: u32;
  var p899: u32;
  var p422: bool;
  var p423: bool;
  var p917: u32;
  var p919: u32;
  var p1190: u32;
  var p305: f32;
  var p306: bool;
  var p378: f32;
  var p379: bool;
  var p308: f32;
  var p320: f32;
  var p321: bool;
  var p323: f32;
  var p324: bool;
  var p327: f32;
  var p339: f32;
  var p340: bool;
  var p342: f32;
  var p343: bool;
  var p346: f32;
  var p437: u32;
  var p438: u32;
  var p534: bool;
  var p1016: u32;
  var p521: bool;
  var p450: u32;
  var p1098: u32;
  var p452: u32;
  var p505: u32;
  var p506: u32;
  var p1192: u32;
  var p448: u32;
  var p449: bool;
  var p651: u32;
  var p642: u32;
  var p645: bool;
  var p1194: u32;
  var p249: bool;
  var p228: u32;
  let v733 = global_invocation_id[0u];
  let v734 = global_invocation_id[1u];
  let v740 = spec0;
  let v741 = r11[0u][3u];
  let v30 = (v733 << (3u & 31u));
  let v31 = (v30 < v741);
  let v32 = (v741 - v30);
  let v742 = min(v32, 8u);
  let v34 = select(0u, v742, v31);
  let v743 = r11[3u][3u];
  let v37 = (v734 << (3u & 31u));
  let v38 = (v37 < v743);
  let v39 = (v743 - v37);
  let v744 = min(v39, 8u);
  let v41 = select(0u, v744, v38);
  let v42 = (v41 * v34);
  let v43 = (v42 != 0u);
  if v43 {
    let v745 = r12[3u][1u];
    let v746 = r13.w0;
    let v747 = bitcast<f32>(v746);
    let v48 = (v740 & 1u);
    let v49 = (v48 == 0u);
    p53 = bitcast<f32>(bits_7f800000);
    p54 = bitcast<f32>(bits_7f800000);
    p55 = bitcast<f32>(bits_7f800000);
    p56 = bitcast<f32>(bits_ff800000);
    p57 = bitcast<f32>(bits_ff800000);
    p58 = bitcast<f32>(bits_ff800000);
    p59 = 0u;
    var done0 = false;
    loop {
      if done0 { break; }
      let v53 = p53;
      let v54 = p54;
      let v55 = p55;
      let v56 = p56;
      let v57 = p57;
      let v58 = p58;
      let v59 = p59;
      let v60 = (v59 >= v34);
      if v60 {
        let v61 = (v59 - v34);
        let v62 = (v61 >= v34);
        if v62 {
          let v63 = (v61 - v34);
          let v64 = (v63 >= v34);
          if v64 {
            let v65 = (v63 - v34);
            let v66 = (v65 >= v34);
            if v66 {
              let v67 = (v65 - v34);
              let v68 = (v67 >= v34);
              if v68 {
                let v69 = (v67 - v34);
                let v70 = (v69 >= v34);
                if v70 {
                  let v71 = (v69 - v34);
                  let v72 = (v71 >= v34);
                  if v72 {
                    let v73 = (v71 - v34);
                    let v74 = (v73 < v34);
                    let v75 = (v73 - v34);
                    let v76 = select(v75, v73, v74);
                    let v77 = select(8u, 7u, v74);
                    p91 = v76;
                    p90 = v77;
                  } else {
                    p91 = v71;
                    p90 = 6u;
                  }
                } else {
                  p91 = v69;
                  p90 = 5u;
                }
              } else {
                p91 = v67;
                p90 = 4u;
              }
            } else {
              p91 = v65;
              p90 = 3u;
            }
          } else {
            p91 = v63;
            p90 = 2u;
          }
        } else {
          p91 = v61;
          p90 = 1u;
        }
      } else {
        p90 = 0u;
        p91 = v59;
      }
      let v90 = p90;
      let v91 = p91;
      let v92 = (v90 + v37);
      let v93 = (v92 * v741);
      let v94 = (v91 + v30);
      let v95 = (v94 + v93);
      let v748 = (v95 * 4u);
      let v749 = r16[v748];
      let v750 = v749[0u];
      let v751 = bitcast<f32>(v750);
      let v754 = v749[1u];
      let v755 = bitcast<f32>(v754);
      let v758 = v749[2u];
      let v759 = bitcast<f32>(v758);
      let v762 = v749[3u];
      let v764 = (v748 + 1u);
      let v765 = r16[v764];
      let v766 = v765[0u];
      let v767 = bitcast<f32>(v766);
      let v771 = v765[1u];
      let v772 = bitcast<f32>(v771);
      let v776 = v765[2u];
      let v777 = bitcast<f32>(v776);
      let v781 = v765[3u];
      let v782 = bitcast<f32>(v781);
      let v114 = (v762 == 4294967295u);
      let v115 = select(v114, true, v49);
      let v116 = (v115 != true);
      if v116 {
        let v784 = (v748 + 2u);
        let v785 = r16[v784];
        let v786 = v785[3u];
        let v787 = r12[4u][1u];
        let v120 = (v786 << (2u & 31u));
        let v121 = (v787 + v120);
        let v789 = (v121 + 2u);
        let v790 = r15[v789];
        let v791 = v790[1u];
        let v792 = bitcast<f32>(v791);
        let v795 = v790[2u];
        let v796 = bitcast<f32>(v795);
        let v128 = (v792 > 0.0f);
        let v129 = (v796 > 0.0f);
        let v130 = select(v129, true, v128);
        if v130 {
          let v145 = (v767 * v782);
          let v146 = (v772 * v782);
          let v147 = (v777 * v782);
          let v148 = (v751 + v145);
          let v149 = (v755 + v146);
          let v150 = (v759 + v147);
          let v151 = (v53 < v148);
          let v152 = select(v148, v53, v151);
          let v153 = (v56 > v148);
          let v154 = select(v148, v56, v153);
          let v155 = (v54 < v149);
          let v156 = select(v149, v54, v155);
          let v157 = (v57 > v149);
          let v158 = select(v149, v57, v157);
          let v159 = (v55 < v150);
          let v160 = select(v150, v55, v159);
          let v161 = (v58 > v150);
          let v162 = select(v150, v58, v161);
          p142 = v162;
          p141 = v158;
          p140 = v154;
          p139 = v160;
          p138 = v156;
          p137 = v152;
        } else {
          p142 = v58;
          p141 = v57;
          p140 = v56;
          p139 = v55;
          p138 = v54;
          p137 = v53;
        }
      } else {
        p137 = v53;
        p138 = v54;
        p139 = v55;
        p140 = v56;
        p141 = v57;
        p142 = v58;
      }
      let v137 = p137;
      let v138 = p138;
      let v139 = p139;
      let v140 = p140;
      let v141 = p141;
      let v142 = p142;
      let v143 = (v59 + 1u);
      let v144 = (v143 == v42);
      p53 = v137;
      p54 = v138;
      p55 = v139;
      p56 = v140;
      p57 = v141;
      p58 = v142;
      p59 = v143;
      p1184 = v137;
      p1185 = v138;
      p1186 = v139;
      p1187 = v140;
      p1188 = v141;
      p1189 = v142;
      done0 = v144;
    }
    let v1184 = p1184;
    let v1185 = p1185;
    let v1186 = p1186;
    let v1187 = p1187;
    let v1188 = p1188;
    let v1189 = p1189;
    let v163 = (v741 + 7u);
    let v164 = (v163 >> (3u & 31u));
    let v165 = (v164 * v734);
    let v166 = (v165 + v733);
    let v167 = (v745 + 6u);
    let v168 = (v167 * v166);
    let v169 = (v1187 - v1184);
    let v170 = (v1188 - v1185);
    let v171 = (v1189 - v1186);
    let v172 = (v747 * v169);
    let v173 = (v747 * v170);
    let v174 = (v747 * v171);
    let v175 = (v1184 - v172);
    let v176 = (v1185 - v173);
    let v177 = (v1186 - v174);
    let v178 = (v1187 + v172);
    let v179 = (v1188 + v173);
    let v180 = (v1189 + v174);
    let v797 = bitcast<u32>(v175);
    r17[v168] = v797;
    let v183 = (v168 + 1u);
    let v799 = bitcast<u32>(v176);
    r17[v183] = v799;
    let v186 = (v168 + 2u);
    let v802 = bitcast<u32>(v177);
    r17[v186] = v802;
    let v189 = (v168 + 3u);
    let v805 = bitcast<u32>(v178);
    r17[v189] = v805;
    let v192 = (v168 + 4u);
    let v808 = bitcast<u32>(v179);
    r17[v192] = v808;
    let v195 = (v168 + 5u);
    let v811 = bitcast<u32>(v180);
    r17[v195] = v811;
    let v199 = (v745 != 0u);
    if v199 {
      let v200 = (v1184 <= v1187);
      let v815 = abs(v175);
      let v816 = abs(v176);
      let v817 = abs(v177);
      let v207 = (v816 > v817);
      let v208 = select(v817, v816, v207);
      let v209 = (v815 > v208);
      let v210 = select(v208, v815, v209);
      let v818 = abs(v178);
      let v819 = abs(v179);
      let v820 = abs(v180);
      let v214 = (v819 > v820);
      let v215 = select(v820, v819, v214);
      let v216 = (v818 > v215);
      let v217 = select(v215, v818, v216);
      let v218 = (v210 > v217);
      let v219 = select(v217, v210, v218);
      let v227 = (v168 + 6u);
      if v200 {
        p899 = 0u;
        p251 = 0u;
        var done1 = false;
        loop {
          if done1 { break; }
          let v251 = p251;
          let v822 = r12[4u][2u];
          let v253 = (v251 << (1u & 31u));
          let v254 = (v822 + v253);
          let v823 = r15[v254];
          let v824 = v823[0u];
          let v825 = bitcast<f32>(v824);
          let v827 = v823[1u];
          let v828 = bitcast<f32>(v827);
          let v830 = v823[2u];
          let v831 = bitcast<f32>(v830);
          let v832 = r12[3u][3u];
          let v833 = bitcast<f32>(v832);
          r10[0u] = v797;
          r10[1u] = v799;
          r10[2u] = v802;
          r9[0u] = v805;
          r9[1u] = v808;
          r9[2u] = v811;
          r8[0u] = v824;
          r8[1u] = v827;
          r8[2u] = v830;
          r6[0u] = 0u;
          r6[1u] = 0u;
          r6[2u] = 0u;
          r7[0u] = 0u;
          r7[1u] = 0u;
          r7[2u] = 0u;
          r4[0u] = 1566444395u;
          r4[1u] = 1566444395u;
          r4[2u] = 1566444395u;
          let v858 = r4[0u];
          let v859 = r4[1u];
          let v860 = r4[2u];
          r5[0u] = v858;
          r5[1u] = v859;
          r5[2u] = v860;
          r2[0u] = 0u;
          r2[1u] = 0u;
          r2[2u] = 0u;
          r2[3u] = 0u;
          r2[4u] = 0u;
          r2[5u] = 0u;
          r3[0u] = 0u;
          r3[1u] = 0u;
          r3[2u] = 0u;
          r3[3u] = 0u;
          r3[4u] = 0u;
          r3[5u] = 0u;
          r1[0u] = 4286578688u;
          r1[1u] = 4286578688u;
          r1[2u] = 4286578688u;
          let v263 = (v219 + v833);
          let v264 = (v263 * 9.536743e-7f);
          let v265 = (v264 * 2.0f);
          p880 = 0u;
          var done2 = false;
          loop {
            if done2 { break; }
            let v880 = p880;
            let v882 = (v880 + 1u);
            let v883 = r10[v880];
            let v884 = bitcast<f32>(v883);
            let v386 = (v884 - v265);
            let v885 = r9[v880];
            let v886 = bitcast<f32>(v885);
            let v389 = (v265 + v886);
            let v887 = r8[v880];
            let v888 = bitcast<f32>(v887);
            let v392 = (v888 - v884);
            let v393 = (v888 - v886);
            let v394 = (v392 < 0.0f);
            let v395 = (v394 != true);
            let v396 = (v393 > 0.0f);
            let v397 = select(v389, v386, v394);
            let v889 = bitcast<u32>(v397);
            r7[v880] = v889;
            let v399 = select(v386, v389, v394);
            let v891 = bitcast<u32>(v399);
            r6[v880] = v891;
            let v401 = (v394 | v396);
            if v401 {
              let v402 = select(v393, v392, v394);
              let v403 = (1.0f / v402);
              let v404 = (v403 < 1e18f);
              let v405 = select(1e18f, v403, v404);
              let v406 = (v405 > -1e18f);
              let v407 = select(-1e18f, v405, v406);
              let v893 = bitcast<u32>(v407);
              r5[v880] = v893;
              let v409 = select(v392, v393, v394);
              let v410 = (1.0f / v409);
              let v411 = (v410 < 1e18f);
              let v412 = select(1e18f, v410, v411);
              let v413 = (v412 > -1e18f);
              let v414 = select(-1e18f, v412, v413);
              let v895 = bitcast<u32>(v414);
              r4[v880] = v895;
              if v395 {
                let v424 = (v884 - v264);
                let v425 = (v424 + -1e-12f);
                let v897 = bitcast<u32>(v425);
                r1[v880] = v897;
                p422 = false;
                p423 = true;
              } else {
                p422 = true;
                p423 = false;
              }
              p899 = v880;
            } else {
              p422 = false;
              p423 = true;
            }
            let v899 = p899;
            let v422 = p422;
            let v423 = p423;
            if v423 {
              let v900 = (v880 << (3u & 31u));
              let v901 = (v880 * 2u);
              r3[v901] = v900;
              let v904 = (v901 + 1u);
              r3[v904] = 0u;
              p919 = v900;
            } else {
              p919 = 0u;
            }
            if v422 {
              let v427 = (v264 + v886);
              let v428 = (v427 + 1e-12f);
              let v908 = bitcast<u32>(v428);
              r1[v899] = v908;
              let v910 = (v880 << (3u & 31u));
              let v911 = (v910 + 24u);
              let v912 = (v880 * 2u);
              r3[v912] = v911;
              let v915 = (v912 + 1u);
              r3[v915] = 0u;
              p917 = 0u;
              p919 = v910;
            } else {
              p917 = 24u;
            }
            let v917 = p917;
            let v919 = p919;
            let v921 = (v919 + v917);
            let v922 = (v880 * 2u);
            r2[v922] = v921;
            let v925 = (v922 + 1u);
            r2[v925] = 0u;
            let v927 = (v882 == 3u);
            p899 = v899;
            p880 = v882;
            p1190 = v899;
            done2 = v927;
          }
          let v1190 = p1190;
          let v266 = (v825 - v175);
          let v267 = (v825 - v178);
          let v1166 = -(v266);
          let v1167 = (v1166 == 0.0f);
          let v1168 = select(v1166, 0.0f, v1167);
          let v269 = (v267 > v1168);
          let v270 = select(v1168, v267, v269);
          let v1169 = -(v267);
          let v1170 = (v1169 == 0.0f);
          let v1171 = select(v1169, 0.0f, v1170);
          let v272 = (v266 > v1171);
          let v273 = select(v1171, v266, v272);
          let v274 = (v273 * 1.001f);
          let v275 = (v828 - v176);
          let v276 = (v828 - v179);
          let v1172 = -(v275);
          let v1173 = (v1172 == 0.0f);
          let v1174 = select(v1172, 0.0f, v1173);
          let v278 = (v276 > v1174);
          let v279 = select(v1174, v276, v278);
          let v1175 = -(v276);
          let v1176 = (v1175 == 0.0f);
          let v1177 = select(v1175, 0.0f, v1176);
          let v281 = (v275 > v1177);
          let v282 = select(v1177, v275, v281);
          let v283 = (v282 * 1.001f);
          let v284 = (v831 - v177);
          let v285 = (v831 - v180);
          let v1178 = -(v284);
          let v1179 = (v1178 == 0.0f);
          let v1180 = select(v1178, 0.0f, v1179);
          let v287 = (v285 > v1180);
          let v288 = select(v1180, v285, v287);
          let v1181 = -(v285);
          let v1182 = (v1181 == 0.0f);
          let v1183 = select(v1181, 0.0f, v1182);
          let v290 = (v284 > v1183);
          let v291 = select(v1183, v284, v290);
          let v292 = (v291 * 1.001f);
          let v293 = (v264 * 0.015625f);
          let v294 = (v825 < v175);
          let v295 = (v294 != true);
          let v296 = (v283 > v292);
          let v297 = select(v292, v283, v296);
          let v298 = (v270 > 0.0f);
          let v299 = (v270 > v297);
          let v300 = (v298 & v299);
          let v301 = (v274 < 100000000.0f);
          let v302 = (v301 & v300);
          let v303 = (v302 != true);
          if v303 {
            let v304 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v294);
            p305 = v304;
            p306 = false;
          } else {
            p306 = true;
          }
          let v305 = p305;
          let v306 = p306;
          if v306 {
            if v295 {
              let v377 = (v175 - v293);
              p378 = v377;
              p379 = false;
            } else {
              p379 = true;
            }
            let v378 = p378;
            let v379 = p379;
            if v379 {
              let v380 = (v293 + v178);
              p308 = v380;
            } else {
              p308 = v378;
            }
          } else {
            p308 = v305;
          }
          let v308 = p308;
          let v309 = (v828 < v176);
          let v310 = (v309 != true);
          let v311 = (v292 > v274);
          let v312 = select(v274, v292, v311);
          let v313 = (v279 > 0.0f);
          let v314 = (v279 > v312);
          let v315 = (v313 & v314);
          let v316 = (v283 < 100000000.0f);
          let v317 = (v316 & v315);
          let v318 = (v317 != true);
          if v318 {
            let v319 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v309);
            p320 = v319;
            p321 = false;
          } else {
            p321 = true;
          }
          let v320 = p320;
          let v321 = p321;
          if v321 {
            if v310 {
              let v322 = (v176 - v293);
              p323 = v322;
              p324 = false;
            } else {
              p324 = true;
            }
            let v323 = p323;
            let v324 = p324;
            if v324 {
              let v325 = (v293 + v179);
              p327 = v325;
            } else {
              p327 = v323;
            }
          } else {
            p327 = v320;
          }
          let v327 = p327;
          let v328 = (v831 < v177);
          let v329 = (v328 != true);
          let v330 = (v274 > v283);
          let v331 = select(v283, v274, v330);
          let v332 = (v288 > 0.0f);
          let v333 = (v288 > v331);
          let v334 = (v332 & v333);
          let v335 = (v292 < 100000000.0f);
          let v336 = (v335 & v334);
          let v337 = (v336 != true);
          if v337 {
            let v338 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v328);
            p339 = v338;
            p340 = false;
          } else {
            p340 = true;
          }
          let v339 = p339;
          let v340 = p340;
          if v340 {
            if v329 {
              let v341 = (v177 - v293);
              p342 = v341;
              p343 = false;
            } else {
              p343 = true;
            }
            let v342 = p342;
            let v343 = p343;
            if v343 {
              let v344 = (v293 + v180);
              p346 = v344;
            } else {
              p346 = v342;
            }
          } else {
            p346 = v339;
          }
          let v346 = p346;
          let v928 = r7[0u];
          let v929 = bitcast<f32>(v928);
          let v930 = r7[1u];
          let v931 = bitcast<f32>(v930);
          let v932 = r7[2u];
          let v933 = bitcast<f32>(v932);
          let v934 = r6[0u];
          let v935 = bitcast<f32>(v934);
          let v936 = r6[1u];
          let v937 = bitcast<f32>(v936);
          let v938 = r6[2u];
          let v939 = bitcast<f32>(v938);
          let v940 = r5[0u];
          let v941 = bitcast<f32>(v940);
          let v942 = r5[1u];
          let v943 = bitcast<f32>(v942);
          let v944 = r5[2u];
          let v945 = bitcast<f32>(v944);
          let v946 = r4[0u];
          let v947 = bitcast<f32>(v946);
          let v948 = r4[1u];
          let v949 = bitcast<f32>(v948);
          let v950 = r4[2u];
          let v951 = bitcast<f32>(v950);
          let v952 = r3[0u];
          let v959 = r3[2u];
          let v966 = r3[4u];
          let v973 = r2[0u];
          let v975 = r2[1u];
          let v980 = r2[2u];
          let v982 = r2[3u];
          let v987 = r2[4u];
          let v989 = r2[5u];
          let v994 = r1[0u];
          let v995 = bitcast<f32>(v994);
          let v996 = r1[1u];
          let v997 = bitcast<f32>(v996);
          let v998 = r1[2u];
          let v999 = bitcast<f32>(v998);
          r0[96u] = 0u;
          let v1001 = (v975 < 0u);
          let v1002 = (v975 == 0u);
          let v1003 = (v973 < 24u);
          let v1004 = (v1002 & v1003);
          let v1005 = (v1001 | v1004);
          let v1006 = (v982 < 0u);
          let v1007 = (v982 == 0u);
          let v1008 = (v980 < 24u);
          let v1009 = (v1007 & v1008);
          let v1010 = (v1006 | v1009);
          let v1011 = (v989 < 0u);
          let v1012 = (v989 == 0u);
          let v1013 = (v987 < 24u);
          let v1014 = (v1012 & v1013);
          let v1015 = (v1011 | v1014);
          p437 = 0u;
          p438 = 0u;
          var done3 = false;
          loop {
            if done3 { break; }
            let v437 = p437;
            let v438 = p438;
            let v439 = (bitcast<i32>(v438) <= bitcast<i32>(4294967295u));
            if v439 {
              let v518 = (v438 & 1610612736u);
              let v519 = (v518 == 0u);
              if v519 {
                let v522 = (v438 & 536870911u);
                p534 = false;
                p1016 = 0u;
                var done4 = false;
                loop {
                  if done4 { break; }
                  let v534 = p534;
                  let v1016 = p1016;
                  let v1018 = (v522 * 8u);
                  let v1019 = (v1018 + v1016);
                  let v1020 = (v1019 >> (2u & 31u));
                  let v1021 = (v1019 & 3u);
                  let v1022 = r14[v1020];
                  let v1023 = v1022[v1021];
                  let v1024 = bitcast<f32>(v1023);
                  let v1027 = (v1019 + 8u);
                  let v1028 = (v1027 >> (2u & 31u));
                  let v1029 = (v1027 & 3u);
                  let v1030 = r14[v1028];
                  let v1031 = v1030[v1029];
                  let v1032 = bitcast<f32>(v1031);
                  let v1035 = (v1019 + 16u);
                  let v1036 = (v1035 >> (2u & 31u));
                  let v1037 = (v1035 & 3u);
                  let v1038 = r14[v1036];
                  let v1039 = v1038[v1037];
                  let v1040 = bitcast<f32>(v1039);
                  let v1043 = (v1019 + 24u);
                  let v1044 = (v1043 >> (2u & 31u));
                  let v1045 = (v1043 & 3u);
                  let v1046 = r14[v1044];
                  let v1047 = v1046[v1045];
                  let v1048 = bitcast<f32>(v1047);
                  let v1051 = (v1019 + 32u);
                  let v1052 = (v1051 >> (2u & 31u));
                  let v1053 = (v1051 & 3u);
                  let v1054 = r14[v1052];
                  let v1055 = v1054[v1053];
                  let v1056 = bitcast<f32>(v1055);
                  let v1059 = (v1019 + 40u);
                  let v1060 = (v1059 >> (2u & 31u));
                  let v1061 = (v1059 & 3u);
                  let v1062 = r14[v1060];
                  let v1063 = v1062[v1061];
                  let v1064 = bitcast<f32>(v1063);
                  let v1067 = (v1019 + 48u);
                  let v1068 = (v1067 >> (2u & 31u));
                  let v1069 = (v1067 & 3u);
                  let v1070 = r14[v1068];
                  let v1071 = v1070[v1069];
                  let v1072 = bitcast<f32>(v1071);
                  let v1075 = (v1019 + 56u);
                  let v1076 = (v1075 >> (2u & 31u));
                  let v1077 = (v1075 & 3u);
                  let v1078 = r14[v1076];
                  let v1079 = v1078[v1077];
                  let v1080 = bitcast<f32>(v1079);
                  let v1083 = (v1019 + 64u);
                  let v1084 = (v1083 >> (2u & 31u));
                  let v1085 = (v1083 & 3u);
                  let v1086 = r14[v1084];
                  let v1087 = v1086[v1085];
                  let v1088 = bitcast<f32>(v1087);
                  let v554 = (v1048 < v1072);
                  let v555 = select(v1072, v1048, v554);
                  let v556 = (v1024 < v555);
                  let v557 = select(v555, v1024, v556);
                  let v558 = (v1048 > v1072);
                  let v559 = select(v1072, v1048, v558);
                  let v560 = (v1024 > v559);
                  let v561 = select(v559, v1024, v560);
                  let v562 = select(v557, v561, v1005);
                  let v563 = select(v561, v557, v1005);
                  let v564 = (v1056 < v1080);
                  let v565 = select(v1080, v1056, v564);
                  let v566 = (v1032 < v565);
                  let v567 = select(v565, v1032, v566);
                  let v568 = (v1056 > v1080);
                  let v569 = select(v1080, v1056, v568);
                  let v570 = (v1032 > v569);
                  let v571 = select(v569, v1032, v570);
                  let v572 = select(v567, v571, v1010);
                  let v573 = select(v571, v567, v1010);
                  let v574 = (v1064 < v1088);
                  let v575 = select(v1088, v1064, v574);
                  let v576 = (v1040 < v575);
                  let v577 = select(v575, v1040, v576);
                  let v578 = (v1064 > v1088);
                  let v579 = select(v1088, v1064, v578);
                  let v580 = (v1040 > v579);
                  let v581 = select(v579, v1040, v580);
                  let v582 = select(v577, v581, v1015);
                  let v583 = select(v581, v577, v1015);
                  let v1089 = (v1016 + 1u);
                  let v1092 = (v1019 + 72u);
                  let v1093 = (v1092 >> (2u & 31u));
                  let v1094 = (v1092 & 3u);
                  let v1095 = r14[v1093];
                  let v1096 = v1095[v1094];
                  let v587 = (v1096 != 4294967295u);
                  let v588 = (v562 - v929);
                  let v589 = (v588 * v941);
                  let v590 = (v572 - v931);
                  let v591 = (v590 * v943);
                  let v592 = (v582 - v933);
                  let v593 = (v592 * v945);
                  let v594 = (v563 - v935);
                  let v595 = (v594 * v947);
                  let v596 = (v573 - v937);
                  let v597 = (v596 * v949);
                  let v598 = (v583 - v939);
                  let v599 = (v598 * v951);
                  let v600 = (v589 > 0.0f);
                  let v601 = select(0.0f, v589, v600);
                  let v602 = (v591 > v601);
                  let v603 = select(v601, v591, v602);
                  let v604 = (v593 > v603);
                  let v605 = select(v603, v593, v604);
                  let v606 = (v595 < 1.0f);
                  let v607 = select(1.0f, v595, v606);
                  let v608 = (v597 < v607);
                  let v609 = select(v607, v597, v608);
                  let v610 = (v599 < v609);
                  let v611 = select(v609, v599, v610);
                  let v612 = (v605 <= v611);
                  let v613 = (v563 - v995);
                  let v614 = (v947 * v613);
                  let v615 = (v573 - v997);
                  let v616 = (v949 * v615);
                  let v617 = (v583 - v999);
                  let v618 = (v951 * v617);
                  let v619 = (v614 >= 0.0f);
                  let v620 = (v616 >= 0.0f);
                  let v621 = (v619 & v620);
                  let v622 = (v618 >= 0.0f);
                  let v623 = (v621 & v622);
                  let v624 = (v612 & v623);
                  let v625 = (v587 & v624);
                  let v626 = (v563 - v308);
                  let v627 = (v947 * v626);
                  let v628 = (v573 - v327);
                  let v629 = (v949 * v628);
                  let v630 = (v583 - v346);
                  let v631 = (v951 * v630);
                  let v632 = (v627 >= 0.0f);
                  let v633 = (v629 >= 0.0f);
                  let v634 = (v632 & v633);
                  let v635 = (v631 >= 0.0f);
                  let v636 = (v634 & v635);
                  let v637 = (v625 & v636);
                  let v638 = (v534 | v637);
                  let v639 = (v638 != true);
                  let v1097 = (v1089 == 8u);
                  p534 = v638;
                  p1016 = v1089;
                  p449 = v639;
                  done4 = v1097;
                }
              } else {
                p449 = false;
              }
              p521 = false;
            } else {
              p449 = false;
              p521 = true;
            }
            let v521 = p521;
            if v521 {
              p450 = 1u;
              p1098 = 0u;
              p452 = v437;
              var done5 = false;
              loop {
                if done5 { break; }
                let v450 = p450;
                let v1098 = p1098;
                let v452 = p452;
                let v1100 = (v1098 + 1u);
                let v1101 = (v438 * 8u);
                let v1102 = (v1101 + v952);
                let v1103 = (v1102 + v1098);
                let v1104 = (v1103 >> (2u & 31u));
                let v1105 = (v1103 & 3u);
                let v1106 = r14[v1104];
                let v1107 = v1106[v1105];
                let v1108 = bitcast<f32>(v1107);
                let v1110 = (v1101 + v959);
                let v1111 = (v1110 + v1098);
                let v1112 = (v1111 >> (2u & 31u));
                let v1113 = (v1111 & 3u);
                let v1114 = r14[v1112];
                let v1115 = v1114[v1113];
                let v1116 = bitcast<f32>(v1115);
                let v1118 = (v1101 + v966);
                let v1119 = (v1118 + v1098);
                let v1120 = (v1119 >> (2u & 31u));
                let v1121 = (v1119 & 3u);
                let v1122 = r14[v1120];
                let v1123 = v1122[v1121];
                let v1124 = bitcast<f32>(v1123);
                let v1126 = (v1101 + v973);
                let v1127 = (v1126 + v1098);
                let v1128 = (v1127 >> (2u & 31u));
                let v1129 = (v1127 & 3u);
                let v1130 = r14[v1128];
                let v1131 = v1130[v1129];
                let v1132 = bitcast<f32>(v1131);
                let v1134 = (v1101 + v980);
                let v1135 = (v1134 + v1098);
                let v1136 = (v1135 >> (2u & 31u));
                let v1137 = (v1135 & 3u);
                let v1138 = r14[v1136];
                let v1139 = v1138[v1137];
                let v1140 = bitcast<f32>(v1139);
                let v1142 = (v1101 + v987);
                let v1143 = (v1142 + v1098);
                let v1144 = (v1143 >> (2u & 31u));
                let v1145 = (v1143 & 3u);
                let v1146 = r14[v1144];
                let v1147 = v1146[v1145];
                let v1148 = bitcast<f32>(v1147);
                let v466 = (v1108 - v929);
                let v467 = (v466 * v941);
                let v468 = (v1116 - v931);
                let v469 = (v468 * v943);
                let v470 = (v1124 - v933);
                let v471 = (v470 * v945);
                let v472 = (v1132 - v935);
                let v473 = (v472 * v947);
                let v474 = (v1140 - v937);
                let v475 = (v474 * v949);
                let v476 = (v1148 - v939);
                let v477 = (v476 * v951);
                let v478 = (v467 > 0.0f);
                let v479 = select(0.0f, v467, v478);
                let v480 = (v469 > v479);
                let v481 = select(v479, v469, v480);
                let v482 = (v471 > v481);
                let v483 = select(v481, v471, v482);
                let v484 = (v473 < 1.0f);
                let v485 = select(1.0f, v473, v484);
                let v486 = (v475 < v485);
                let v487 = select(v485, v475, v486);
                let v488 = (v477 < v487);
                let v489 = select(v487, v477, v488);
                let v490 = (v483 <= v489);
                let v491 = (v1132 - v995);
                let v492 = (v947 * v491);
                let v493 = (v1140 - v997);
                let v494 = (v949 * v493);
                let v495 = (v1148 - v999);
                let v496 = (v951 * v495);
                let v497 = (v492 >= 0.0f);
                let v498 = (v494 >= 0.0f);
                let v499 = (v497 & v498);
                let v500 = (v496 >= 0.0f);
                let v501 = (v499 & v500);
                let v502 = (v490 & v501);
                if v502 {
                  let v504 = (v452 < 96u);
                  if v504 {
                    let v1150 = (v1101 + v1098);
                    let v1151 = (v1150 + 48u);
                    let v1152 = (v1151 >> (2u & 31u));
                    let v1153 = (v1151 & 3u);
                    let v1154 = r14[v1152];
                    let v1155 = v1154[v1153];
                    r0[v452] = v1155;
                    let v516 = (v452 + 1u);
                    p506 = v516;
                  } else {
                    p506 = v452;
                  }
                  let v1164 = (v450 & 1u);
                  let v508 = (v1164 != 0u);
                  let v509 = (v504 & v508);
                  let v510 = select(0u, 1u, v509);
                  p505 = v510;
                } else {
                  p505 = v450;
                  p506 = v452;
                }
                let v505 = p505;
                let v506 = p506;
                let v1157 = (v1100 == 8u);
                p450 = v505;
                p1098 = v1100;
                p452 = v506;
                p1192 = v505;
                p448 = v506;
                done5 = v1157;
              }
              let v1192 = p1192;
              let v1165 = (v1192 & 1u);
              let v517 = (v1165 != 0u);
              p449 = v517;
            } else {
              p448 = v437;
            }
            let v448 = p448;
            let v449 = p449;
            if v449 {
              let v641 = (v448 != 0u);
              if v641 {
                let v646 = (v448 + 4294967295u);
                let v1159 = r0[v646];
                p642 = v1159;
                p651 = v646;
                p645 = false;
              } else {
                p645 = true;
              }
              let v651 = p651;
              p437 = v651;
              p1194 = 1u;
            } else {
              p437 = v448;
              p1194 = 0u;
              p645 = true;
            }
            let v642 = p642;
            let v645 = p645;
            p438 = v642;
            done3 = v645;
          }
          let v1194 = p1194;
          let v653 = (v227 + v251);
          r17[v653] = v1194;
          let v656 = (v251 + 1u);
          let v658 = (v656 >= v745);
          p899 = v1190;
          p251 = v656;
          done1 = v658;
        }
        p249 = false;
      } else {
        p249 = true;
      }
      let v249 = p249;
      if v249 {
        p228 = 0u;
        var done6 = false;
        loop {
          if done6 { break; }
          let v228 = p228;
          let v229 = (v227 + v228);
          r17[v229] = 0u;
          let v232 = (v228 + 1u);
          let v234 = (v232 >= v745);
          p228 = v232;
          done6 = v234;
        }
      }
    }
  }
  return;
}
