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
  var p49: f32;
  var p50: f32;
  var p51: f32;
  var p52: f32;
  var p53: f32;
  var p54: f32;
  var p55: u32;
  var p86: u32;
  var p87: u32;
  var p133: f32;
  var p134: f32;
  var p135: f32;
  var p136: f32;
  var p137: f32;
  var p138: f32;
  var p1186: f32;
  var p1187: f32;
  var p1188: f32;
  var p1189: f32;
  var p1190: f32;
  var p1191: f32;
  var p247: u32;
  var p882: u32;
  var p901: u32;
  var p418: bool;
  var p419: bool;
  var p919: u32;
  var p921: u32;
  var p1192: u32;
  var p301: f32;
  var p302: bool;
  var p374: f32;
  var p375: bool;
  var p304: f32;
  var p316: f32;
  var p317: bool;
  var p319: f32;
  var p320: bool;
  var p323: f32;
  var p335: f32;
  var p336: bool;
  var p338: f32;
  var p339: bool;
  var p342: f32;
  var p433: u32;
  var p434: u32;
  var p530: bool;
  var p1018: u32;
  var p517: bool;
  var p446: u32;
  var p1100: u32;
  var p448: u32;
  var p501: u32;
  var p502: u32;
  var p1194: u32;
  var p444: u32;
  var p445: bool;
  var p647: u32;
  var p638: u32;
  var p641: bool;
  var p1196: u32;
  var p245: bool;
  var p224: u32;
  let v729 = global_invocation_id[0u];
  let v730 = global_invocation_id[1u];
  let v736 = spec0;
  let v737 = r11[0u][3u];
  let v30 = (v729 << (3u & 31u));
  let v738 = (v737 < v30);
  let v739 = (v737 - v30);
  let v740 = select(v739, 0u, v738);
  let v741 = min(v740, 8u);
  let v742 = r11[3u][3u];
  let v35 = (v730 << (3u & 31u));
  let v743 = (v742 < v35);
  let v744 = (v742 - v35);
  let v745 = select(v744, 0u, v743);
  let v746 = min(v745, 8u);
  let v38 = (v746 * v741);
  let v39 = (v38 != 0u);
  if v39 {
    let v747 = r12[3u][1u];
    let v748 = r13.w0;
    let v749 = bitcast<f32>(v748);
    let v44 = (v736 & 1u);
    let v45 = (v44 == 0u);
    p49 = bitcast<f32>(bits_7f800000);
    p50 = bitcast<f32>(bits_7f800000);
    p51 = bitcast<f32>(bits_7f800000);
    p52 = bitcast<f32>(bits_ff800000);
    p53 = bitcast<f32>(bits_ff800000);
    p54 = bitcast<f32>(bits_ff800000);
    p55 = 0u;
    var done0 = false;
    loop {
      if done0 { break; }
      let v49 = p49;
      let v50 = p50;
      let v51 = p51;
      let v52 = p52;
      let v53 = p53;
      let v54 = p54;
      let v55 = p55;
      let v56 = (v55 >= v741);
      if v56 {
        let v57 = (v55 - v741);
        let v58 = (v57 >= v741);
        if v58 {
          let v59 = (v57 - v741);
          let v60 = (v59 >= v741);
          if v60 {
            let v61 = (v59 - v741);
            let v62 = (v61 >= v741);
            if v62 {
              let v63 = (v61 - v741);
              let v64 = (v63 >= v741);
              if v64 {
                let v65 = (v63 - v741);
                let v66 = (v65 >= v741);
                if v66 {
                  let v67 = (v65 - v741);
                  let v68 = (v67 >= v741);
                  if v68 {
                    let v69 = (v67 - v741);
                    let v70 = (v69 < v741);
                    let v71 = (v69 - v741);
                    let v72 = select(v71, v69, v70);
                    let v73 = select(8u, 7u, v70);
                    p87 = v72;
                    p86 = v73;
                  } else {
                    p87 = v67;
                    p86 = 6u;
                  }
                } else {
                  p87 = v65;
                  p86 = 5u;
                }
              } else {
                p87 = v63;
                p86 = 4u;
              }
            } else {
              p87 = v61;
              p86 = 3u;
            }
          } else {
            p87 = v59;
            p86 = 2u;
          }
        } else {
          p87 = v57;
          p86 = 1u;
        }
      } else {
        p86 = 0u;
        p87 = v55;
      }
      let v86 = p86;
      let v87 = p87;
      let v88 = (v86 + v35);
      let v89 = (v88 * v737);
      let v90 = (v87 + v30);
      let v91 = (v90 + v89);
      let v750 = (v91 * 4u);
      let v751 = r16[v750];
      let v752 = v751[0u];
      let v753 = bitcast<f32>(v752);
      let v756 = v751[1u];
      let v757 = bitcast<f32>(v756);
      let v760 = v751[2u];
      let v761 = bitcast<f32>(v760);
      let v764 = v751[3u];
      let v766 = (v750 + 1u);
      let v767 = r16[v766];
      let v768 = v767[0u];
      let v769 = bitcast<f32>(v768);
      let v773 = v767[1u];
      let v774 = bitcast<f32>(v773);
      let v778 = v767[2u];
      let v779 = bitcast<f32>(v778);
      let v783 = v767[3u];
      let v784 = bitcast<f32>(v783);
      let v110 = (v764 == 4294967295u);
      let v111 = select(v110, true, v45);
      let v112 = (v111 != true);
      if v112 {
        let v786 = (v750 + 2u);
        let v787 = r16[v786];
        let v788 = v787[3u];
        let v789 = r12[4u][1u];
        let v116 = (v788 << (2u & 31u));
        let v117 = (v789 + v116);
        let v791 = (v117 + 2u);
        let v792 = r15[v791];
        let v793 = v792[1u];
        let v794 = bitcast<f32>(v793);
        let v797 = v792[2u];
        let v798 = bitcast<f32>(v797);
        let v124 = (v794 > 0.0f);
        let v125 = (v798 > 0.0f);
        let v126 = select(v125, true, v124);
        if v126 {
          let v141 = (v769 * v784);
          let v142 = (v774 * v784);
          let v143 = (v779 * v784);
          let v144 = (v753 + v141);
          let v145 = (v757 + v142);
          let v146 = (v761 + v143);
          let v147 = (v49 < v144);
          let v148 = select(v144, v49, v147);
          let v149 = (v52 > v144);
          let v150 = select(v144, v52, v149);
          let v151 = (v50 < v145);
          let v152 = select(v145, v50, v151);
          let v153 = (v53 > v145);
          let v154 = select(v145, v53, v153);
          let v155 = (v51 < v146);
          let v156 = select(v146, v51, v155);
          let v157 = (v54 > v146);
          let v158 = select(v146, v54, v157);
          p138 = v158;
          p137 = v154;
          p136 = v150;
          p135 = v156;
          p134 = v152;
          p133 = v148;
        } else {
          p138 = v54;
          p137 = v53;
          p136 = v52;
          p135 = v51;
          p134 = v50;
          p133 = v49;
        }
      } else {
        p133 = v49;
        p134 = v50;
        p135 = v51;
        p136 = v52;
        p137 = v53;
        p138 = v54;
      }
      let v133 = p133;
      let v134 = p134;
      let v135 = p135;
      let v136 = p136;
      let v137 = p137;
      let v138 = p138;
      let v139 = (v55 + 1u);
      let v140 = (v139 == v38);
      p49 = v133;
      p50 = v134;
      p51 = v135;
      p52 = v136;
      p53 = v137;
      p54 = v138;
      p55 = v139;
      p1186 = v133;
      p1187 = v134;
      p1188 = v135;
      p1189 = v136;
      p1190 = v137;
      p1191 = v138;
      done0 = v140;
    }
    let v1186 = p1186;
    let v1187 = p1187;
    let v1188 = p1188;
    let v1189 = p1189;
    let v1190 = p1190;
    let v1191 = p1191;
    let v159 = (v737 + 7u);
    let v160 = (v159 >> (3u & 31u));
    let v161 = (v160 * v730);
    let v162 = (v161 + v729);
    let v163 = (v747 + 6u);
    let v164 = (v163 * v162);
    let v165 = (v1189 - v1186);
    let v166 = (v1190 - v1187);
    let v167 = (v1191 - v1188);
    let v168 = (v749 * v165);
    let v169 = (v749 * v166);
    let v170 = (v749 * v167);
    let v171 = (v1186 - v168);
    let v172 = (v1187 - v169);
    let v173 = (v1188 - v170);
    let v174 = (v1189 + v168);
    let v175 = (v1190 + v169);
    let v176 = (v1191 + v170);
    let v799 = bitcast<u32>(v171);
    r17[v164] = v799;
    let v179 = (v164 + 1u);
    let v801 = bitcast<u32>(v172);
    r17[v179] = v801;
    let v182 = (v164 + 2u);
    let v804 = bitcast<u32>(v173);
    r17[v182] = v804;
    let v185 = (v164 + 3u);
    let v807 = bitcast<u32>(v174);
    r17[v185] = v807;
    let v188 = (v164 + 4u);
    let v810 = bitcast<u32>(v175);
    r17[v188] = v810;
    let v191 = (v164 + 5u);
    let v813 = bitcast<u32>(v176);
    r17[v191] = v813;
    let v195 = (v747 != 0u);
    if v195 {
      let v196 = (v1186 <= v1189);
      let v817 = abs(v171);
      let v818 = abs(v172);
      let v819 = abs(v173);
      let v203 = (v818 > v819);
      let v204 = select(v819, v818, v203);
      let v205 = (v817 > v204);
      let v206 = select(v204, v817, v205);
      let v820 = abs(v174);
      let v821 = abs(v175);
      let v822 = abs(v176);
      let v210 = (v821 > v822);
      let v211 = select(v822, v821, v210);
      let v212 = (v820 > v211);
      let v213 = select(v211, v820, v212);
      let v214 = (v206 > v213);
      let v215 = select(v213, v206, v214);
      let v223 = (v164 + 6u);
      if v196 {
        p901 = 0u;
        p247 = 0u;
        var done1 = false;
        loop {
          if done1 { break; }
          let v247 = p247;
          let v824 = r12[4u][2u];
          let v249 = (v247 << (1u & 31u));
          let v250 = (v824 + v249);
          let v825 = r15[v250];
          let v826 = v825[0u];
          let v827 = bitcast<f32>(v826);
          let v829 = v825[1u];
          let v830 = bitcast<f32>(v829);
          let v832 = v825[2u];
          let v833 = bitcast<f32>(v832);
          let v834 = r12[3u][3u];
          let v835 = bitcast<f32>(v834);
          r10[0u] = v799;
          r10[1u] = v801;
          r10[2u] = v804;
          r9[0u] = v807;
          r9[1u] = v810;
          r9[2u] = v813;
          r8[0u] = v826;
          r8[1u] = v829;
          r8[2u] = v832;
          r6[0u] = 0u;
          r6[1u] = 0u;
          r6[2u] = 0u;
          r7[0u] = 0u;
          r7[1u] = 0u;
          r7[2u] = 0u;
          r4[0u] = 1566444395u;
          r4[1u] = 1566444395u;
          r4[2u] = 1566444395u;
          let v860 = r4[0u];
          let v861 = r4[1u];
          let v862 = r4[2u];
          r5[0u] = v860;
          r5[1u] = v861;
          r5[2u] = v862;
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
          let v259 = (v215 + v835);
          let v260 = (v259 * 9.536743e-7f);
          let v261 = (v260 * 2.0f);
          p882 = 0u;
          var done2 = false;
          loop {
            if done2 { break; }
            let v882 = p882;
            let v884 = (v882 + 1u);
            let v885 = r10[v882];
            let v886 = bitcast<f32>(v885);
            let v382 = (v886 - v261);
            let v887 = r9[v882];
            let v888 = bitcast<f32>(v887);
            let v385 = (v261 + v888);
            let v889 = r8[v882];
            let v890 = bitcast<f32>(v889);
            let v388 = (v890 - v886);
            let v389 = (v890 - v888);
            let v390 = (v388 < 0.0f);
            let v391 = (v390 != true);
            let v392 = (v389 > 0.0f);
            let v393 = select(v385, v382, v390);
            let v891 = bitcast<u32>(v393);
            r7[v882] = v891;
            let v395 = select(v382, v385, v390);
            let v893 = bitcast<u32>(v395);
            r6[v882] = v893;
            let v397 = (v390 | v392);
            if v397 {
              let v398 = select(v389, v388, v390);
              let v399 = (1.0f / v398);
              let v400 = (v399 < 1e18f);
              let v401 = select(1e18f, v399, v400);
              let v402 = (v401 > -1e18f);
              let v403 = select(-1e18f, v401, v402);
              let v895 = bitcast<u32>(v403);
              r5[v882] = v895;
              let v405 = select(v388, v389, v390);
              let v406 = (1.0f / v405);
              let v407 = (v406 < 1e18f);
              let v408 = select(1e18f, v406, v407);
              let v409 = (v408 > -1e18f);
              let v410 = select(-1e18f, v408, v409);
              let v897 = bitcast<u32>(v410);
              r4[v882] = v897;
              if v391 {
                let v420 = (v886 - v260);
                let v421 = (v420 + -1e-12f);
                let v899 = bitcast<u32>(v421);
                r1[v882] = v899;
                p418 = false;
                p419 = true;
              } else {
                p418 = true;
                p419 = false;
              }
              p901 = v882;
            } else {
              p418 = false;
              p419 = true;
            }
            let v901 = p901;
            let v418 = p418;
            let v419 = p419;
            if v419 {
              let v902 = (v882 << (3u & 31u));
              let v903 = (v882 * 2u);
              r3[v903] = v902;
              let v906 = (v903 + 1u);
              r3[v906] = 0u;
              p921 = v902;
            } else {
              p921 = 0u;
            }
            if v418 {
              let v423 = (v260 + v888);
              let v424 = (v423 + 1e-12f);
              let v910 = bitcast<u32>(v424);
              r1[v901] = v910;
              let v912 = (v882 << (3u & 31u));
              let v913 = (v912 + 24u);
              let v914 = (v882 * 2u);
              r3[v914] = v913;
              let v917 = (v914 + 1u);
              r3[v917] = 0u;
              p919 = 0u;
              p921 = v912;
            } else {
              p919 = 24u;
            }
            let v919 = p919;
            let v921 = p921;
            let v923 = (v921 + v919);
            let v924 = (v882 * 2u);
            r2[v924] = v923;
            let v927 = (v924 + 1u);
            r2[v927] = 0u;
            let v929 = (v884 == 3u);
            p901 = v901;
            p882 = v884;
            p1192 = v901;
            done2 = v929;
          }
          let v1192 = p1192;
          let v262 = (v827 - v171);
          let v263 = (v827 - v174);
          let v1168 = -(v262);
          let v1169 = (v1168 == 0.0f);
          let v1170 = select(v1168, 0.0f, v1169);
          let v265 = (v263 > v1170);
          let v266 = select(v1170, v263, v265);
          let v1171 = -(v263);
          let v1172 = (v1171 == 0.0f);
          let v1173 = select(v1171, 0.0f, v1172);
          let v268 = (v262 > v1173);
          let v269 = select(v1173, v262, v268);
          let v270 = (v269 * 1.001f);
          let v271 = (v830 - v172);
          let v272 = (v830 - v175);
          let v1174 = -(v271);
          let v1175 = (v1174 == 0.0f);
          let v1176 = select(v1174, 0.0f, v1175);
          let v274 = (v272 > v1176);
          let v275 = select(v1176, v272, v274);
          let v1177 = -(v272);
          let v1178 = (v1177 == 0.0f);
          let v1179 = select(v1177, 0.0f, v1178);
          let v277 = (v271 > v1179);
          let v278 = select(v1179, v271, v277);
          let v279 = (v278 * 1.001f);
          let v280 = (v833 - v173);
          let v281 = (v833 - v176);
          let v1180 = -(v280);
          let v1181 = (v1180 == 0.0f);
          let v1182 = select(v1180, 0.0f, v1181);
          let v283 = (v281 > v1182);
          let v284 = select(v1182, v281, v283);
          let v1183 = -(v281);
          let v1184 = (v1183 == 0.0f);
          let v1185 = select(v1183, 0.0f, v1184);
          let v286 = (v280 > v1185);
          let v287 = select(v1185, v280, v286);
          let v288 = (v287 * 1.001f);
          let v289 = (v260 * 0.015625f);
          let v290 = (v827 < v171);
          let v291 = (v290 != true);
          let v292 = (v279 > v288);
          let v293 = select(v288, v279, v292);
          let v294 = (v266 > 0.0f);
          let v295 = (v266 > v293);
          let v296 = (v294 & v295);
          let v297 = (v270 < 100000000.0f);
          let v298 = (v297 & v296);
          let v299 = (v298 != true);
          if v299 {
            let v300 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v290);
            p301 = v300;
            p302 = false;
          } else {
            p302 = true;
          }
          let v301 = p301;
          let v302 = p302;
          if v302 {
            if v291 {
              let v373 = (v171 - v289);
              p374 = v373;
              p375 = false;
            } else {
              p375 = true;
            }
            let v374 = p374;
            let v375 = p375;
            if v375 {
              let v376 = (v289 + v174);
              p304 = v376;
            } else {
              p304 = v374;
            }
          } else {
            p304 = v301;
          }
          let v304 = p304;
          let v305 = (v830 < v172);
          let v306 = (v305 != true);
          let v307 = (v288 > v270);
          let v308 = select(v270, v288, v307);
          let v309 = (v275 > 0.0f);
          let v310 = (v275 > v308);
          let v311 = (v309 & v310);
          let v312 = (v279 < 100000000.0f);
          let v313 = (v312 & v311);
          let v314 = (v313 != true);
          if v314 {
            let v315 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v305);
            p316 = v315;
            p317 = false;
          } else {
            p317 = true;
          }
          let v316 = p316;
          let v317 = p317;
          if v317 {
            if v306 {
              let v318 = (v172 - v289);
              p319 = v318;
              p320 = false;
            } else {
              p320 = true;
            }
            let v319 = p319;
            let v320 = p320;
            if v320 {
              let v321 = (v289 + v175);
              p323 = v321;
            } else {
              p323 = v319;
            }
          } else {
            p323 = v316;
          }
          let v323 = p323;
          let v324 = (v833 < v173);
          let v325 = (v324 != true);
          let v326 = (v270 > v279);
          let v327 = select(v279, v270, v326);
          let v328 = (v284 > 0.0f);
          let v329 = (v284 > v327);
          let v330 = (v328 & v329);
          let v331 = (v288 < 100000000.0f);
          let v332 = (v331 & v330);
          let v333 = (v332 != true);
          if v333 {
            let v334 = select(bitcast<f32>(bits_ff800000), bitcast<f32>(bits_7f800000), v324);
            p335 = v334;
            p336 = false;
          } else {
            p336 = true;
          }
          let v335 = p335;
          let v336 = p336;
          if v336 {
            if v325 {
              let v337 = (v173 - v289);
              p338 = v337;
              p339 = false;
            } else {
              p339 = true;
            }
            let v338 = p338;
            let v339 = p339;
            if v339 {
              let v340 = (v289 + v176);
              p342 = v340;
            } else {
              p342 = v338;
            }
          } else {
            p342 = v335;
          }
          let v342 = p342;
          let v930 = r7[0u];
          let v931 = bitcast<f32>(v930);
          let v932 = r7[1u];
          let v933 = bitcast<f32>(v932);
          let v934 = r7[2u];
          let v935 = bitcast<f32>(v934);
          let v936 = r6[0u];
          let v937 = bitcast<f32>(v936);
          let v938 = r6[1u];
          let v939 = bitcast<f32>(v938);
          let v940 = r6[2u];
          let v941 = bitcast<f32>(v940);
          let v942 = r5[0u];
          let v943 = bitcast<f32>(v942);
          let v944 = r5[1u];
          let v945 = bitcast<f32>(v944);
          let v946 = r5[2u];
          let v947 = bitcast<f32>(v946);
          let v948 = r4[0u];
          let v949 = bitcast<f32>(v948);
          let v950 = r4[1u];
          let v951 = bitcast<f32>(v950);
          let v952 = r4[2u];
          let v953 = bitcast<f32>(v952);
          let v954 = r3[0u];
          let v961 = r3[2u];
          let v968 = r3[4u];
          let v975 = r2[0u];
          let v977 = r2[1u];
          let v982 = r2[2u];
          let v984 = r2[3u];
          let v989 = r2[4u];
          let v991 = r2[5u];
          let v996 = r1[0u];
          let v997 = bitcast<f32>(v996);
          let v998 = r1[1u];
          let v999 = bitcast<f32>(v998);
          let v1000 = r1[2u];
          let v1001 = bitcast<f32>(v1000);
          r0[96u] = 0u;
          let v1003 = (v977 < 0u);
          let v1004 = (v977 == 0u);
          let v1005 = (v975 < 24u);
          let v1006 = (v1004 & v1005);
          let v1007 = (v1003 | v1006);
          let v1008 = (v984 < 0u);
          let v1009 = (v984 == 0u);
          let v1010 = (v982 < 24u);
          let v1011 = (v1009 & v1010);
          let v1012 = (v1008 | v1011);
          let v1013 = (v991 < 0u);
          let v1014 = (v991 == 0u);
          let v1015 = (v989 < 24u);
          let v1016 = (v1014 & v1015);
          let v1017 = (v1013 | v1016);
          p433 = 0u;
          p434 = 0u;
          var done3 = false;
          loop {
            if done3 { break; }
            let v433 = p433;
            let v434 = p434;
            let v435 = (bitcast<i32>(v434) <= bitcast<i32>(4294967295u));
            if v435 {
              let v514 = (v434 & 1610612736u);
              let v515 = (v514 == 0u);
              if v515 {
                let v518 = (v434 & 536870911u);
                p530 = false;
                p1018 = 0u;
                var done4 = false;
                loop {
                  if done4 { break; }
                  let v530 = p530;
                  let v1018 = p1018;
                  let v1020 = (v518 * 8u);
                  let v1021 = (v1020 + v1018);
                  let v1022 = (v1021 >> (2u & 31u));
                  let v1023 = (v1021 & 3u);
                  let v1024 = r14[v1022];
                  let v1025 = v1024[v1023];
                  let v1026 = bitcast<f32>(v1025);
                  let v1029 = (v1021 + 8u);
                  let v1030 = (v1029 >> (2u & 31u));
                  let v1031 = (v1029 & 3u);
                  let v1032 = r14[v1030];
                  let v1033 = v1032[v1031];
                  let v1034 = bitcast<f32>(v1033);
                  let v1037 = (v1021 + 16u);
                  let v1038 = (v1037 >> (2u & 31u));
                  let v1039 = (v1037 & 3u);
                  let v1040 = r14[v1038];
                  let v1041 = v1040[v1039];
                  let v1042 = bitcast<f32>(v1041);
                  let v1045 = (v1021 + 24u);
                  let v1046 = (v1045 >> (2u & 31u));
                  let v1047 = (v1045 & 3u);
                  let v1048 = r14[v1046];
                  let v1049 = v1048[v1047];
                  let v1050 = bitcast<f32>(v1049);
                  let v1053 = (v1021 + 32u);
                  let v1054 = (v1053 >> (2u & 31u));
                  let v1055 = (v1053 & 3u);
                  let v1056 = r14[v1054];
                  let v1057 = v1056[v1055];
                  let v1058 = bitcast<f32>(v1057);
                  let v1061 = (v1021 + 40u);
                  let v1062 = (v1061 >> (2u & 31u));
                  let v1063 = (v1061 & 3u);
                  let v1064 = r14[v1062];
                  let v1065 = v1064[v1063];
                  let v1066 = bitcast<f32>(v1065);
                  let v1069 = (v1021 + 48u);
                  let v1070 = (v1069 >> (2u & 31u));
                  let v1071 = (v1069 & 3u);
                  let v1072 = r14[v1070];
                  let v1073 = v1072[v1071];
                  let v1074 = bitcast<f32>(v1073);
                  let v1077 = (v1021 + 56u);
                  let v1078 = (v1077 >> (2u & 31u));
                  let v1079 = (v1077 & 3u);
                  let v1080 = r14[v1078];
                  let v1081 = v1080[v1079];
                  let v1082 = bitcast<f32>(v1081);
                  let v1085 = (v1021 + 64u);
                  let v1086 = (v1085 >> (2u & 31u));
                  let v1087 = (v1085 & 3u);
                  let v1088 = r14[v1086];
                  let v1089 = v1088[v1087];
                  let v1090 = bitcast<f32>(v1089);
                  let v550 = (v1050 < v1074);
                  let v551 = select(v1074, v1050, v550);
                  let v552 = (v1026 < v551);
                  let v553 = select(v551, v1026, v552);
                  let v554 = (v1050 > v1074);
                  let v555 = select(v1074, v1050, v554);
                  let v556 = (v1026 > v555);
                  let v557 = select(v555, v1026, v556);
                  let v558 = select(v553, v557, v1007);
                  let v559 = select(v557, v553, v1007);
                  let v560 = (v1058 < v1082);
                  let v561 = select(v1082, v1058, v560);
                  let v562 = (v1034 < v561);
                  let v563 = select(v561, v1034, v562);
                  let v564 = (v1058 > v1082);
                  let v565 = select(v1082, v1058, v564);
                  let v566 = (v1034 > v565);
                  let v567 = select(v565, v1034, v566);
                  let v568 = select(v563, v567, v1012);
                  let v569 = select(v567, v563, v1012);
                  let v570 = (v1066 < v1090);
                  let v571 = select(v1090, v1066, v570);
                  let v572 = (v1042 < v571);
                  let v573 = select(v571, v1042, v572);
                  let v574 = (v1066 > v1090);
                  let v575 = select(v1090, v1066, v574);
                  let v576 = (v1042 > v575);
                  let v577 = select(v575, v1042, v576);
                  let v578 = select(v573, v577, v1017);
                  let v579 = select(v577, v573, v1017);
                  let v1091 = (v1018 + 1u);
                  let v1094 = (v1021 + 72u);
                  let v1095 = (v1094 >> (2u & 31u));
                  let v1096 = (v1094 & 3u);
                  let v1097 = r14[v1095];
                  let v1098 = v1097[v1096];
                  let v583 = (v1098 != 4294967295u);
                  let v584 = (v558 - v931);
                  let v585 = (v584 * v943);
                  let v586 = (v568 - v933);
                  let v587 = (v586 * v945);
                  let v588 = (v578 - v935);
                  let v589 = (v588 * v947);
                  let v590 = (v559 - v937);
                  let v591 = (v590 * v949);
                  let v592 = (v569 - v939);
                  let v593 = (v592 * v951);
                  let v594 = (v579 - v941);
                  let v595 = (v594 * v953);
                  let v596 = (v585 > 0.0f);
                  let v597 = select(0.0f, v585, v596);
                  let v598 = (v587 > v597);
                  let v599 = select(v597, v587, v598);
                  let v600 = (v589 > v599);
                  let v601 = select(v599, v589, v600);
                  let v602 = (v591 < 1.0f);
                  let v603 = select(1.0f, v591, v602);
                  let v604 = (v593 < v603);
                  let v605 = select(v603, v593, v604);
                  let v606 = (v595 < v605);
                  let v607 = select(v605, v595, v606);
                  let v608 = (v601 <= v607);
                  let v609 = (v559 - v997);
                  let v610 = (v949 * v609);
                  let v611 = (v569 - v999);
                  let v612 = (v951 * v611);
                  let v613 = (v579 - v1001);
                  let v614 = (v953 * v613);
                  let v615 = (v610 >= 0.0f);
                  let v616 = (v612 >= 0.0f);
                  let v617 = (v615 & v616);
                  let v618 = (v614 >= 0.0f);
                  let v619 = (v617 & v618);
                  let v620 = (v608 & v619);
                  let v621 = (v583 & v620);
                  let v622 = (v559 - v304);
                  let v623 = (v949 * v622);
                  let v624 = (v569 - v323);
                  let v625 = (v951 * v624);
                  let v626 = (v579 - v342);
                  let v627 = (v953 * v626);
                  let v628 = (v623 >= 0.0f);
                  let v629 = (v625 >= 0.0f);
                  let v630 = (v628 & v629);
                  let v631 = (v627 >= 0.0f);
                  let v632 = (v630 & v631);
                  let v633 = (v621 & v632);
                  let v634 = (v530 | v633);
                  let v635 = (v634 != true);
                  let v1099 = (v1091 == 8u);
                  p530 = v634;
                  p1018 = v1091;
                  p445 = v635;
                  done4 = v1099;
                }
              } else {
                p445 = false;
              }
              p517 = false;
            } else {
              p445 = false;
              p517 = true;
            }
            let v517 = p517;
            if v517 {
              p446 = 1u;
              p1100 = 0u;
              p448 = v433;
              var done5 = false;
              loop {
                if done5 { break; }
                let v446 = p446;
                let v1100 = p1100;
                let v448 = p448;
                let v1102 = (v1100 + 1u);
                let v1103 = (v434 * 8u);
                let v1104 = (v1103 + v954);
                let v1105 = (v1104 + v1100);
                let v1106 = (v1105 >> (2u & 31u));
                let v1107 = (v1105 & 3u);
                let v1108 = r14[v1106];
                let v1109 = v1108[v1107];
                let v1110 = bitcast<f32>(v1109);
                let v1112 = (v1103 + v961);
                let v1113 = (v1112 + v1100);
                let v1114 = (v1113 >> (2u & 31u));
                let v1115 = (v1113 & 3u);
                let v1116 = r14[v1114];
                let v1117 = v1116[v1115];
                let v1118 = bitcast<f32>(v1117);
                let v1120 = (v1103 + v968);
                let v1121 = (v1120 + v1100);
                let v1122 = (v1121 >> (2u & 31u));
                let v1123 = (v1121 & 3u);
                let v1124 = r14[v1122];
                let v1125 = v1124[v1123];
                let v1126 = bitcast<f32>(v1125);
                let v1128 = (v1103 + v975);
                let v1129 = (v1128 + v1100);
                let v1130 = (v1129 >> (2u & 31u));
                let v1131 = (v1129 & 3u);
                let v1132 = r14[v1130];
                let v1133 = v1132[v1131];
                let v1134 = bitcast<f32>(v1133);
                let v1136 = (v1103 + v982);
                let v1137 = (v1136 + v1100);
                let v1138 = (v1137 >> (2u & 31u));
                let v1139 = (v1137 & 3u);
                let v1140 = r14[v1138];
                let v1141 = v1140[v1139];
                let v1142 = bitcast<f32>(v1141);
                let v1144 = (v1103 + v989);
                let v1145 = (v1144 + v1100);
                let v1146 = (v1145 >> (2u & 31u));
                let v1147 = (v1145 & 3u);
                let v1148 = r14[v1146];
                let v1149 = v1148[v1147];
                let v1150 = bitcast<f32>(v1149);
                let v462 = (v1110 - v931);
                let v463 = (v462 * v943);
                let v464 = (v1118 - v933);
                let v465 = (v464 * v945);
                let v466 = (v1126 - v935);
                let v467 = (v466 * v947);
                let v468 = (v1134 - v937);
                let v469 = (v468 * v949);
                let v470 = (v1142 - v939);
                let v471 = (v470 * v951);
                let v472 = (v1150 - v941);
                let v473 = (v472 * v953);
                let v474 = (v463 > 0.0f);
                let v475 = select(0.0f, v463, v474);
                let v476 = (v465 > v475);
                let v477 = select(v475, v465, v476);
                let v478 = (v467 > v477);
                let v479 = select(v477, v467, v478);
                let v480 = (v469 < 1.0f);
                let v481 = select(1.0f, v469, v480);
                let v482 = (v471 < v481);
                let v483 = select(v481, v471, v482);
                let v484 = (v473 < v483);
                let v485 = select(v483, v473, v484);
                let v486 = (v479 <= v485);
                let v487 = (v1134 - v997);
                let v488 = (v949 * v487);
                let v489 = (v1142 - v999);
                let v490 = (v951 * v489);
                let v491 = (v1150 - v1001);
                let v492 = (v953 * v491);
                let v493 = (v488 >= 0.0f);
                let v494 = (v490 >= 0.0f);
                let v495 = (v493 & v494);
                let v496 = (v492 >= 0.0f);
                let v497 = (v495 & v496);
                let v498 = (v486 & v497);
                if v498 {
                  let v500 = (v448 < 96u);
                  if v500 {
                    let v1152 = (v1103 + v1100);
                    let v1153 = (v1152 + 48u);
                    let v1154 = (v1153 >> (2u & 31u));
                    let v1155 = (v1153 & 3u);
                    let v1156 = r14[v1154];
                    let v1157 = v1156[v1155];
                    r0[v448] = v1157;
                    let v512 = (v448 + 1u);
                    p502 = v512;
                  } else {
                    p502 = v448;
                  }
                  let v1166 = (v446 & 1u);
                  let v504 = (v1166 != 0u);
                  let v505 = (v500 & v504);
                  let v506 = select(0u, 1u, v505);
                  p501 = v506;
                } else {
                  p501 = v446;
                  p502 = v448;
                }
                let v501 = p501;
                let v502 = p502;
                let v1159 = (v1102 == 8u);
                p446 = v501;
                p1100 = v1102;
                p448 = v502;
                p1194 = v501;
                p444 = v502;
                done5 = v1159;
              }
              let v1194 = p1194;
              let v1167 = (v1194 & 1u);
              let v513 = (v1167 != 0u);
              p445 = v513;
            } else {
              p444 = v433;
            }
            let v444 = p444;
            let v445 = p445;
            if v445 {
              let v637 = (v444 != 0u);
              if v637 {
                let v642 = (v444 + 4294967295u);
                let v1161 = r0[v642];
                p638 = v1161;
                p647 = v642;
                p641 = false;
              } else {
                p641 = true;
              }
              let v647 = p647;
              p433 = v647;
              p1196 = 1u;
            } else {
              p433 = v444;
              p1196 = 0u;
              p641 = true;
            }
            let v638 = p638;
            let v641 = p641;
            p434 = v638;
            done3 = v641;
          }
          let v1196 = p1196;
          let v649 = (v223 + v247);
          r17[v649] = v1196;
          let v652 = (v247 + 1u);
          let v654 = (v652 >= v747);
          p901 = v1192;
          p247 = v652;
          done1 = v654;
        }
        p245 = false;
      } else {
        p245 = true;
      }
      let v245 = p245;
      if v245 {
        p224 = 0u;
        var done6 = false;
        loop {
          if done6 { break; }
          let v224 = p224;
          let v225 = (v223 + v224);
          r17[v225] = 0u;
          let v228 = (v224 + 1u);
          let v230 = (v228 >= v747);
          p224 = v228;
          done6 = v230;
        }
      }
    }
  }
  return;
}
