@group(0) @binding(0) var<uniform> r1: array<vec4<u32>, 4>;
@group(0) @binding(1) var<uniform> r2: array<vec4<u32>, 6>;
@group(0) @binding(2) var<uniform> r3: array<vec4<u32>, 5>;
@group(0) @binding(3) var<storage, read> r4: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> r5: array<u32>;
@group(0) @binding(5) var<storage, read> r6: array<u32>;
@group(0) @binding(6) var<storage, read> r7: array<u32>;
@group(0) @binding(7) var<storage, read> r8: array<u32>;
@group(0) @binding(8) var<storage, read_write> r9: array<u32>;
@group(0) @binding(9) var<storage, read_write> r10: array<u32>;
@group(0) @binding(10) var<storage, read_write> r11: array<u32>;
var<private> bits_7f800000: u32 = 2139095040u;
var<private> bits_7fc00000: u32 = 2143289344u;
@compute @workgroup_size(8, 8, 1)
fn settle(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var r0: array<u32, 193>;
  var p79: bool;
  var p126: bool;
  var p73: bool;
  var p74: bool;
  var p104: bool;
  var p82: bool;
  var p136: bool;
  var p63: f32;
  var p64: u32;
  var p65: u32;
  var p66: bool;
  var p67: bool;
  var p68: bool;
  var p267: bool;
  var p289: f32;
  var p290: f32;
  var p291: f32;
  var p1455: u32;
  var p1457: u32;
  var p1459: u32;
  var p295: f32;
  var p296: f32;
  var p297: f32;
  var p307: bool;
  var p360: f32;
  var p361: u32;
  var p363: f32;
  var p365: u32;
  var p366: u32;
  var p380: u32;
  var p381: u32;
  var p1463: u32;
  var p383: u32;
  var p423: u32;
  var p425: u32;
  var p1952: u32;
  var p376: u32;
  var p378: u32;
  var p379: bool;
  var p1954: u32;
  var p1955: bool;
  var p1956: u32;
  var p444: bool;
  var p1529: u32;
  var p658: u32;
  var p659: f32;
  var p897: f32;
  var p895: u32;
  var p896: f32;
  var p654: f32;
  var p655: u32;
  var p656: bool;
  var p1661: u32;
  var p465: u32;
  var p466: f32;
  var p631: f32;
  var p629: u32;
  var p630: f32;
  var p909: u32;
  var p910: f32;
  var p905: u32;
  var p906: f32;
  var p908: bool;
  var p938: bool;
  var p1705: u32;
  var p940: u32;
  var p941: f32;
  var p1103: f32;
  var p1149: f32;
  var p1192: f32;
  var p1235: f32;
  var p1254: bool;
  var p1100: bool;
  var p1101: u32;
  var p1102: f32;
  var p1962: u32;
  var p934: u32;
  var p936: f32;
  var p937: bool;
  var p449: f32;
  var p450: u32;
  var p452: f32;
  var p1257: u32;
  var p1334: bool;
  var p1335: u32;
  var p1337: bool;
  var p1965: u32;
  var p1966: bool;
  var p1265: u32;
  var p1266: bool;
  var p1967: f32;
  var p1968: u32;
  var p354: u32;
  var p356: u32;
  var p357: f32;
  var p359: bool;
  var p1275: bool;
  var p1277: u32;
  var p1279: f32;
  var p1281: bool;
  var p1286: bool;
  var p1291: u32;
  var p1292: u32;
  var p1294: bool;
  var p287: u32;
  var p288: bool;
  let v1372 = global_invocation_id[0u];
  let v1373 = global_invocation_id[1u];
  let v1383 = r1[0u][0u];
  let v30 = (v1372 < v1383);
  if v30 {
    let v1384 = r1[0u][1u];
    let v33 = (v1373 < v1384);
    if v33 {
      let v34 = (v1383 * v1373);
      let v1385 = r1[0u][3u];
      let v37 = (v1385 == 0u);
      let v38 = (v37 != true);
      let v39 = (v1372 ^ 4294967295u);
      let v40 = (v1383 + v39);
      let v41 = select(v40, v1372, v37);
      let v42 = (v41 + v34);
      let v1386 = r5[v42];
      let v47 = (v1386 != 0u);
      if v47 {
        let v48 = (v1386 + 4294967295u);
        let v1387 = r6[v42];
        let v52 = (v1387 >= v1386);
        let v1388 = r1[1u][0u];
        if v52 {
          let v75 = (bitcast<i32>(v1388) >= bitcast<i32>(2u));
          if v75 {
            let v76 = (v1388 != 2u);
            p136 = true;
            p126 = v76;
            p79 = false;
          } else {
            p136 = false;
            p126 = false;
            p79 = true;
          }
          let v79 = p79;
          if v79 {
            let v80 = (v1388 != 0u);
            p64 = v48;
            p65 = 3u;
            p68 = true;
            p126 = v80;
          } else {
            p64 = 0u;
            p65 = 2u;
            p68 = false;
          }
          let v126 = p126;
          if v126 {
            let v1389 = r1[1u][1u];
            let v129 = (v1372 >= v1389);
            let v130 = (v1388 == 1u);
            let v131 = (v130 | v129);
            let v132 = (v131 != true);
            p68 = false;
            p136 = v131;
            p73 = v132;
          } else {
            p73 = false;
          }
          p74 = false;
        } else {
          p64 = 0u;
          p65 = 2u;
          p68 = false;
          p136 = false;
          p73 = false;
          p74 = true;
        }
        let v73 = p73;
        let v74 = p74;
        if v74 {
          let v58 = (v1388 != 2u);
          let v1390 = r1[1u][1u];
          let v61 = (v1372 < v1390);
          let v62 = select(false, v61, v58);
          if v62 {
            let v83 = (v1388 == 1u);
            if v83 {
              let v86 = (v1372 == 0u);
              let v87 = (v86 != true);
              if v87 {
                let v90 = (v1372 + 4294967295u);
                let v91 = (v1383 - v1372);
                let v92 = select(v91, v90, v37);
                let v93 = (v92 + v34);
                let v1391 = r5[v93];
                let v98 = (v1391 == 0u);
                let v99 = (v1386 - v1391);
                let v100 = (v99 > 2u);
                let v101 = (v98 | v100);
                let v102 = (v101 != true);
                p136 = true;
                p104 = v102;
              } else {
                p136 = false;
                p104 = v86;
              }
              let v104 = p104;
              if v104 {
                let v105 = (v1372 + 1u);
                let v106 = (v105 < v1383);
                let v107 = (v106 != true);
                if v106 {
                  let v110 = (v1383 - v1372);
                  let v111 = (v110 + 4294967294u);
                  let v112 = select(v111, v105, v37);
                  let v113 = (v112 + v34);
                  let v1392 = r5[v113];
                  let v118 = (v1392 == 0u);
                  let v119 = (v1392 - v1386);
                  let v120 = (v119 > 2u);
                  let v121 = (v118 | v120);
                  let v122 = (v121 != true);
                  p136 = true;
                  p82 = v122;
                } else {
                  p136 = false;
                  p82 = v107;
                }
              } else {
                p82 = false;
              }
            } else {
              p136 = false;
              p82 = true;
            }
          } else {
            p136 = true;
            p82 = v73;
          }
        } else {
          p82 = v73;
        }
        let v82 = p82;
        if v82 {
          let v1308 = (v1383 - v1386);
          let v1309 = select(v1308, v48, v37);
          p64 = v1309;
          p65 = 0u;
          p67 = true;
          p136 = false;
        } else {
          p67 = false;
        }
        let v136 = p136;
        if v136 {
          let v1393 = r1[0u][2u];
          let v1394 = bitcast<f32>(v1393);
          let v139 = (v1383 - v1386);
          let v140 = select(v139, v48, v37);
          let v141 = (v140 + v34);
          let v1395 = (v141 * 2u);
          let v1396 = r7[v1395];
          let v1397 = bitcast<f32>(v1396);
          let v146 = !(v1394 == 0.0f);
          if v146 {
            let v147 = !(v1397 == bitcast<f32>(bits_7f800000));
            if v147 {
              let v148 = (v1394 * v1397);
              let v149 = (v1394 + v1397);
              let v150 = (v148 / v149);
              p63 = v150;
            } else {
              p63 = bitcast<f32>(bits_7f800000);
            }
          } else {
            p63 = 0.0f;
          }
          p64 = v48;
          p65 = 1u;
          p66 = true;
          p68 = true;
        } else {
          p63 = bitcast<f32>(bits_7f800000);
          p66 = false;
        }
      } else {
        p63 = bitcast<f32>(bits_7f800000);
        p64 = 0u;
        p65 = 2u;
        p66 = false;
        p67 = false;
        p68 = true;
      }
      let v63 = p63;
      let v64 = p64;
      let v65 = p65;
      let v66 = p66;
      let v67 = p67;
      let v68 = p68;
      if v68 {
        let v158 = (v66 != true);
        let v1398 = r2[2u][3u];
        let v161 = (v1398 + v1373);
        let v1399 = r2[2u][0u];
        let v1400 = bitcast<f32>(v1399);
        let v1401 = r2[2u][1u];
        let v1402 = bitcast<f32>(v1401);
        let v1403 = r2[2u][2u];
        let v1404 = bitcast<f32>(v1403);
        let v168 = f32(v41);
        let v169 = (v1400 * v168);
        let v170 = (v1402 * v168);
        let v171 = (v1404 * v168);
        let v1405 = r2[3u][0u];
        let v1406 = bitcast<f32>(v1405);
        let v1407 = r2[3u][1u];
        let v1408 = bitcast<f32>(v1407);
        let v1409 = r2[3u][2u];
        let v1410 = bitcast<f32>(v1409);
        let v178 = f32(v161);
        let v179 = (v1406 * v178);
        let v180 = (v1408 * v178);
        let v181 = (v1410 * v178);
        let v1411 = r2[1u][0u];
        let v1412 = bitcast<f32>(v1411);
        let v1413 = r2[1u][1u];
        let v1414 = bitcast<f32>(v1413);
        let v1415 = r2[1u][2u];
        let v1416 = bitcast<f32>(v1415);
        let v188 = (v169 + v1412);
        let v189 = (v170 + v1414);
        let v190 = (v171 + v1416);
        let v191 = (v179 + v188);
        let v192 = (v180 + v189);
        let v193 = (v181 + v190);
        let v1417 = r2[0u][0u];
        let v1418 = bitcast<f32>(v1417);
        let v1419 = r2[0u][1u];
        let v1420 = bitcast<f32>(v1419);
        let v1421 = r2[0u][2u];
        let v1422 = bitcast<f32>(v1421);
        let v1423 = r3[3u][3u];
        let v1424 = bitcast<f32>(v1423);
        let v201 = bitcast<u32>(v191);
        let v202 = bitcast<u32>(v192);
        let v203 = bitcast<u32>(v193);
        let v204 = (1.0f / v191);
        let v205 = (v204 < 1e18f);
        let v206 = select(1e18f, v204, v205);
        let v207 = (v206 > -1e18f);
        let v208 = select(-1e18f, v206, v207);
        let v209 = (1.0f / v192);
        let v210 = (v209 < 1e18f);
        let v211 = select(1e18f, v209, v210);
        let v212 = (v211 > -1e18f);
        let v213 = select(-1e18f, v211, v212);
        let v214 = (1.0f / v193);
        let v215 = (v214 < 1e18f);
        let v216 = select(1e18f, v214, v215);
        let v217 = (v216 > -1e18f);
        let v218 = select(-1e18f, v216, v217);
        let v1425 = abs(v1418);
        let v1426 = abs(v1420);
        let v1427 = abs(v1422);
        let v222 = (v1426 > v1427);
        let v223 = select(v1427, v1426, v222);
        let v224 = (v1425 > v223);
        let v225 = select(v223, v1425, v224);
        let v226 = (v1424 + v225);
        let v227 = (v226 * 9.536743e-7f);
        let v228 = bitcast<u32>(v227);
        let v229 = (v201 & 2147483648u);
        let v230 = (bitcast<i32>(v201) < bitcast<i32>(0u));
        let v1428 = select(0u, 24u, v230);
        let v1429 = select(24u, 0u, v230);
        let v233 = (v229 | v228);
        let v234 = bitcast<f32>(v233);
        let v235 = (v1418 + v234);
        let v236 = (v1418 - v234);
        let v237 = (v202 & 2147483648u);
        let v238 = (bitcast<i32>(v202) < bitcast<i32>(0u));
        let v1430 = select(8u, 32u, v238);
        let v1431 = select(32u, 8u, v238);
        let v241 = (v237 | v228);
        let v242 = bitcast<f32>(v241);
        let v243 = (v1420 + v242);
        let v244 = (v1420 - v242);
        let v245 = (v203 & 2147483648u);
        let v246 = (bitcast<i32>(v203) < bitcast<i32>(0u));
        let v1432 = select(16u, 40u, v246);
        let v1433 = select(40u, 16u, v246);
        let v249 = (v245 | v228);
        let v250 = bitcast<f32>(v249);
        let v251 = (v1422 + v250);
        let v252 = (v1422 - v250);
        let v1434 = abs(v191);
        let v1435 = abs(v192);
        let v1436 = abs(v193);
        let v256 = !(v1434 > v1435);
        if v256 {
          let v257 = (v1435 > v1436);
          if v257 {
            p297 = v213;
            p296 = v191;
            p295 = v193;
            p1459 = 16u;
            p1457 = 0u;
            p1455 = 8u;
            p291 = v1422;
            p290 = v1418;
            p289 = v1420;
          } else {
            p297 = v218;
            p296 = v192;
            p295 = v191;
            p1459 = 0u;
            p1457 = 8u;
            p1455 = 16u;
            p291 = v1418;
            p290 = v1420;
            p289 = v1422;
          }
          p267 = false;
        } else {
          p1459 = 0u;
          p1457 = 0u;
          p1455 = 0u;
          p267 = true;
        }
        let v267 = p267;
        if v267 {
          let v268 = (v1434 > v1436);
          if v268 {
            p297 = v208;
            p296 = v193;
            p295 = v192;
            p1459 = 8u;
            p1457 = 16u;
            p1455 = 0u;
            p291 = v1420;
            p290 = v1422;
            p289 = v1418;
          } else {
            p297 = v218;
            p296 = v192;
            p295 = v191;
            p1459 = 0u;
            p1457 = 8u;
            p1455 = 16u;
            p291 = v1418;
            p290 = v1420;
            p289 = v1422;
          }
        }
        let v289 = p289;
        let v290 = p290;
        let v291 = p291;
        let v1455 = p1455;
        let v1457 = p1457;
        let v1459 = p1459;
        let v295 = p295;
        let v296 = p296;
        let v297 = p297;
        let v1461 = abs(v297);
        let v299 = ((v227 < bitcast<f32>(bits_7f800000)) || (v227 > bitcast<f32>(bits_7f800000)));
        let v300 = (v1461 < 1e18f);
        let v301 = (v299 & v300);
        let v302 = ((v297 < 0.0f) || (v297 > 0.0f));
        let v303 = (v302 & v301);
        let v304 = (v303 != true);
        if v304 {
          p1281 = true;
          p359 = v158;
          p307 = false;
        } else {
          p1281 = false;
          p359 = false;
          p307 = true;
        }
        let v307 = p307;
        if v307 {
          r0[192u] = 0u;
          let v1916 = (v201 & 2147483647u);
          let v1917 = (v1916 < 2139095040u);
          let v1919 = select(2143289344u, v229, v1917);
          let v1920 = bitcast<f32>(v1919);
          let v1922 = (v202 & 2147483647u);
          let v1923 = (v1922 < 2139095040u);
          let v1925 = select(2143289344u, v237, v1923);
          let v1926 = bitcast<f32>(v1925);
          let v311 = (v1920 + v1926);
          let v1928 = (v203 & 2147483647u);
          let v1929 = (v1928 < 2139095040u);
          let v1931 = select(2143289344u, v245, v1929);
          let v1932 = bitcast<f32>(v1931);
          let v313 = (v311 + v1932);
          let v314 = (v191 * 4097.0f);
          let v315 = (v314 - v191);
          let v316 = (v314 - v315);
          let v317 = (v191 - v316);
          let v318 = (v192 * 4097.0f);
          let v319 = (v318 - v192);
          let v320 = (v318 - v319);
          let v321 = (v192 - v320);
          let v322 = (v193 * 4097.0f);
          let v323 = (v322 - v193);
          let v324 = (v322 - v323);
          let v325 = (v193 - v324);
          let v326 = (v191 * v191);
          let v327 = (v192 * v192);
          let v328 = (v326 + v327);
          let v329 = (v193 * v193);
          let v330 = (v328 + v329);
          let v331 = (1.0f / v330);
          let v332 = -(v331);
          let v333 = (v235 > v236);
          let v334 = select(v236, v235, v333);
          let v335 = (v235 < v236);
          let v336 = select(v236, v235, v335);
          let v337 = (v243 > v244);
          let v338 = select(v244, v243, v337);
          let v339 = (v243 < v244);
          let v340 = select(v244, v243, v339);
          let v341 = (v251 > v252);
          let v342 = select(v252, v251, v341);
          let v343 = (v251 < v252);
          let v344 = select(v252, v251, v343);
          let v1933 = (v1417 & 2147483647u);
          let v1934 = (v1933 < 2139095040u);
          let v1935 = (v1417 & 2147483648u);
          let v1936 = select(2143289344u, v1935, v1934);
          let v1937 = bitcast<f32>(v1936);
          let v1938 = (v1419 & 2147483647u);
          let v1939 = (v1938 < 2139095040u);
          let v1940 = (v1419 & 2147483648u);
          let v1941 = select(2143289344u, v1940, v1939);
          let v1942 = bitcast<f32>(v1941);
          let v347 = (v1937 + v1942);
          let v1943 = (v1421 & 2147483647u);
          let v1944 = (v1943 < 2139095040u);
          let v1945 = (v1421 & 2147483648u);
          let v1946 = select(2143289344u, v1945, v1944);
          let v1947 = bitcast<f32>(v1946);
          let v349 = (v347 + v1947);
          let v350 = (v313 + v349);
          let v351 = (v350 == 0.0f);
          p360 = v63;
          p361 = 0u;
          p365 = 0u;
          p363 = v63;
          p366 = 0u;
          var done0 = false;
          loop {
            if done0 { break; }
            let v360 = p360;
            let v361 = p361;
            let v363 = p363;
            var done1 = false;
            loop {
              if done1 { break; }
              let v365 = p365;
              let v366 = p366;
              let v367 = (bitcast<i32>(v366) > bitcast<i32>(4294967295u));
              if v367 {
                p380 = 4294967295u;
                p381 = 4294967295u;
                p1463 = 0u;
                p383 = v365;
                var done2 = false;
                loop {
                  if done2 { break; }
                  let v380 = p380;
                  let v381 = p381;
                  let v1463 = p1463;
                  let v383 = p383;
                  let v1465 = (v1463 + 1u);
                  let v1466 = (v366 * 8u);
                  let v1467 = (v1466 + v1428);
                  let v1468 = (v1467 + v1463);
                  let v1469 = (v1468 >> (2u & 31u));
                  let v1470 = (v1468 & 3u);
                  let v1471 = r4[v1469];
                  let v1472 = v1471[v1470];
                  let v1473 = bitcast<f32>(v1472);
                  let v1475 = (v1466 + v1430);
                  let v1476 = (v1475 + v1463);
                  let v1477 = (v1476 >> (2u & 31u));
                  let v1478 = (v1476 & 3u);
                  let v1479 = r4[v1477];
                  let v1480 = v1479[v1478];
                  let v1481 = bitcast<f32>(v1480);
                  let v1483 = (v1466 + v1432);
                  let v1484 = (v1483 + v1463);
                  let v1485 = (v1484 >> (2u & 31u));
                  let v1486 = (v1484 & 3u);
                  let v1487 = r4[v1485];
                  let v1488 = v1487[v1486];
                  let v1489 = bitcast<f32>(v1488);
                  let v1491 = (v1466 + v1429);
                  let v1492 = (v1491 + v1463);
                  let v1493 = (v1492 >> (2u & 31u));
                  let v1494 = (v1492 & 3u);
                  let v1495 = r4[v1493];
                  let v1496 = v1495[v1494];
                  let v1497 = bitcast<f32>(v1496);
                  let v1499 = (v1466 + v1431);
                  let v1500 = (v1499 + v1463);
                  let v1501 = (v1500 >> (2u & 31u));
                  let v1502 = (v1500 & 3u);
                  let v1503 = r4[v1501];
                  let v1504 = v1503[v1502];
                  let v1505 = bitcast<f32>(v1504);
                  let v1507 = (v1466 + v1433);
                  let v1508 = (v1507 + v1463);
                  let v1509 = (v1508 >> (2u & 31u));
                  let v1510 = (v1508 & 3u);
                  let v1511 = r4[v1509];
                  let v1512 = v1511[v1510];
                  let v1513 = bitcast<f32>(v1512);
                  let v397 = (v1473 - v235);
                  let v398 = (v208 * v397);
                  let v399 = (v1481 - v243);
                  let v400 = (v213 * v399);
                  let v401 = (v1489 - v251);
                  let v402 = (v218 * v401);
                  let v403 = (v1497 - v236);
                  let v404 = (v208 * v403);
                  let v405 = (v1505 - v244);
                  let v406 = (v213 * v405);
                  let v407 = (v1513 - v252);
                  let v408 = (v218 * v407);
                  let v409 = (v398 > 0.0f);
                  let v410 = select(0.0f, v398, v409);
                  let v411 = (v400 > v410);
                  let v412 = select(v410, v400, v411);
                  let v413 = (v402 > v412);
                  let v414 = select(v412, v402, v413);
                  let v415 = (v404 < v363);
                  let v416 = select(v363, v404, v415);
                  let v417 = (v406 < v416);
                  let v418 = select(v416, v406, v417);
                  let v419 = (v408 < v418);
                  let v420 = select(v418, v408, v419);
                  let v421 = (v414 <= v420);
                  if v421 {
                    let v1515 = (v1466 + v1463);
                    let v1516 = (v1515 + 48u);
                    let v1517 = (v1516 >> (2u & 31u));
                    let v1518 = (v1516 & 3u);
                    let v1519 = r4[v1517];
                    let v1520 = v1519[v1518];
                    let v430 = bitcast<u32>(v414);
                    let v431 = (v381 > v430);
                    let v432 = select(v1520, v380, v431);
                    let v1521 = min(v381, v430);
                    let v434 = select(v380, v1520, v431);
                    let v435 = (v432 != 4294967295u);
                    let v436 = (v383 < 96u);
                    let v437 = select(false, v436, v435);
                    if v437 {
                      let v1522 = max(v381, v430);
                      let v1523 = (v383 * 2u);
                      r0[v1523] = v432;
                      let v1526 = (v1523 + 1u);
                      r0[v1526] = v1522;
                      let v442 = (v383 + 1u);
                      p423 = v442;
                    } else {
                      p423 = v383;
                    }
                    p381 = v1521;
                    p425 = v434;
                  } else {
                    p423 = v383;
                    p381 = v381;
                    p425 = v380;
                  }
                  let v423 = p423;
                  let v425 = p425;
                  let v1528 = (v1465 == 8u);
                  p380 = v425;
                  p1463 = v1465;
                  p383 = v423;
                  p378 = v423;
                  p1952 = v425;
                  done2 = v1528;
                }
                let v1952 = p1952;
                let v443 = (v1952 == 4294967295u);
                p376 = v1952;
                p1955 = false;
                p379 = v443;
              } else {
                p1955 = true;
                p379 = true;
              }
              let v376 = p376;
              let v378 = p378;
              let v379 = p379;
              p365 = v378;
              p366 = v376;
              p1257 = v365;
              p1954 = v366;
              p1956 = v378;
              done1 = v379;
            }
            let v1954 = p1954;
            let v1955 = p1955;
            let v1956 = p1956;
            let v1333 = (v1955 != true);
            if v1333 {
              p444 = false;
            } else {
              p444 = true;
            }
            let v444 = p444;
            if v444 {
              let v445 = (v1954 & 1610612736u);
              let v446 = (v445 != 0u);
              if v446 {
                if v351 {
                  let v454 = (v445 != 536870912u);
                  let v455 = (v1954 & 536870911u);
                  if v454 {
                    p1529 = 0u;
                    p658 = v361;
                    p659 = v360;
                    var done3 = false;
                    loop {
                      if done3 { break; }
                      let v1529 = p1529;
                      let v658 = p658;
                      let v659 = p659;
                      let v1531 = (v1529 + 1u);
                      let v1532 = (v455 * 8u);
                      let v1533 = (v1532 + v1529);
                      let v1534 = (v1533 + 120u);
                      let v1535 = (v1534 >> (2u & 31u));
                      let v1536 = (v1534 & 3u);
                      let v1537 = r4[v1535];
                      let v1538 = v1537[v1536];
                      let v663 = (v1538 != 4294967295u);
                      if v663 {
                        let v1541 = (v1533 + 24u);
                        let v1542 = (v1541 >> (2u & 31u));
                        let v1543 = (v1541 & 3u);
                        let v1544 = r4[v1542];
                        let v1545 = v1544[v1543];
                        let v1546 = bitcast<f32>(v1545);
                        let v1549 = (v1533 + 32u);
                        let v1550 = (v1549 >> (2u & 31u));
                        let v1551 = (v1549 & 3u);
                        let v1552 = r4[v1550];
                        let v1553 = v1552[v1551];
                        let v1554 = bitcast<f32>(v1553);
                        let v1557 = (v1533 + 40u);
                        let v1558 = (v1557 >> (2u & 31u));
                        let v1559 = (v1557 & 3u);
                        let v1560 = r4[v1558];
                        let v1561 = v1560[v1559];
                        let v1562 = bitcast<f32>(v1561);
                        let v1565 = (v1533 + 48u);
                        let v1566 = (v1565 >> (2u & 31u));
                        let v1567 = (v1565 & 3u);
                        let v1568 = r4[v1566];
                        let v1569 = v1568[v1567];
                        let v1570 = bitcast<f32>(v1569);
                        let v1573 = (v1533 + 56u);
                        let v1574 = (v1573 >> (2u & 31u));
                        let v1575 = (v1573 & 3u);
                        let v1576 = r4[v1574];
                        let v1577 = v1576[v1575];
                        let v1578 = bitcast<f32>(v1577);
                        let v1581 = (v1533 + 64u);
                        let v1582 = (v1581 >> (2u & 31u));
                        let v1583 = (v1581 & 3u);
                        let v1584 = r4[v1582];
                        let v1585 = v1584[v1583];
                        let v1586 = bitcast<f32>(v1585);
                        let v1589 = (v1533 + 72u);
                        let v1590 = (v1589 >> (2u & 31u));
                        let v1591 = (v1589 & 3u);
                        let v1592 = r4[v1590];
                        let v1593 = v1592[v1591];
                        let v1594 = bitcast<f32>(v1593);
                        let v1597 = (v1533 + 80u);
                        let v1598 = (v1597 >> (2u & 31u));
                        let v1599 = (v1597 & 3u);
                        let v1600 = r4[v1598];
                        let v1601 = v1600[v1599];
                        let v1602 = bitcast<f32>(v1601);
                        let v1605 = (v1533 + 88u);
                        let v1606 = (v1605 >> (2u & 31u));
                        let v1607 = (v1605 & 3u);
                        let v1608 = r4[v1606];
                        let v1609 = v1608[v1607];
                        let v1610 = bitcast<f32>(v1609);
                        let v1613 = (v1533 + 96u);
                        let v1614 = (v1613 >> (2u & 31u));
                        let v1615 = (v1613 & 3u);
                        let v1616 = r4[v1614];
                        let v1617 = v1616[v1615];
                        let v1618 = bitcast<f32>(v1617);
                        let v1621 = (v1533 + 104u);
                        let v1622 = (v1621 >> (2u & 31u));
                        let v1623 = (v1621 & 3u);
                        let v1624 = r4[v1622];
                        let v1625 = v1624[v1623];
                        let v1626 = bitcast<f32>(v1625);
                        let v1629 = (v1533 + 112u);
                        let v1630 = (v1629 >> (2u & 31u));
                        let v1631 = (v1629 & 3u);
                        let v1632 = r4[v1630];
                        let v1633 = v1632[v1631];
                        let v1634 = bitcast<f32>(v1633);
                        let v1637 = (v1533 >> (2u & 31u));
                        let v1638 = (v1533 & 3u);
                        let v1639 = r4[v1637];
                        let v1640 = v1639[v1638];
                        let v1641 = bitcast<f32>(v1640);
                        let v1644 = (v1533 + 8u);
                        let v1645 = (v1644 >> (2u & 31u));
                        let v1646 = (v1644 & 3u);
                        let v1647 = r4[v1645];
                        let v1648 = v1647[v1646];
                        let v1649 = bitcast<f32>(v1648);
                        let v1652 = (v1533 + 16u);
                        let v1653 = (v1652 >> (2u & 31u));
                        let v1654 = (v1652 & 3u);
                        let v1655 = r4[v1653];
                        let v1656 = v1655[v1654];
                        let v1657 = bitcast<f32>(v1656);
                        let v697 = (v1641 - v1570);
                        let v698 = (v1649 - v1602);
                        let v699 = (v1657 - v1634);
                        let v700 = (v1570 + v1641);
                        let v701 = (v1602 + v1649);
                        let v702 = (v1634 + v1657);
                        let v703 = (v697 - v334);
                        let v704 = (v208 * v703);
                        let v705 = (v700 - v336);
                        let v706 = (v208 * v705);
                        let v707 = (v704 < v706);
                        let v708 = select(v706, v704, v707);
                        let v709 = (v704 > v706);
                        let v710 = select(v706, v704, v709);
                        let v711 = (v698 - v338);
                        let v712 = (v213 * v711);
                        let v713 = (v701 - v340);
                        let v714 = (v213 * v713);
                        let v715 = (v712 < v714);
                        let v716 = select(v714, v712, v715);
                        let v717 = (v712 > v714);
                        let v718 = select(v714, v712, v717);
                        let v719 = (v699 - v342);
                        let v720 = (v218 * v719);
                        let v721 = (v702 - v344);
                        let v722 = (v218 * v721);
                        let v723 = (v720 < v722);
                        let v724 = select(v722, v720, v723);
                        let v725 = (v720 > v722);
                        let v726 = select(v722, v720, v725);
                        let v727 = (v716 > v724);
                        let v728 = select(v724, v716, v727);
                        let v729 = (v708 > v728);
                        let v730 = select(v728, v708, v729);
                        let v731 = (v718 < v726);
                        let v732 = select(v726, v718, v731);
                        let v733 = (v710 < v732);
                        let v734 = select(v732, v710, v733);
                        let v735 = (v1418 - v1641);
                        let v736 = (v1420 - v1649);
                        let v737 = (v1422 - v1657);
                        let v738 = (v735 - v1418);
                        let v739 = (v736 - v1420);
                        let v740 = (v737 - v1422);
                        let v741 = (v735 - v738);
                        let v742 = (v736 - v739);
                        let v743 = (v737 - v740);
                        let v744 = (v1418 - v741);
                        let v745 = (v1420 - v742);
                        let v746 = (v1422 - v743);
                        let v747 = (v1641 + v738);
                        let v748 = (v1649 + v739);
                        let v749 = (v1657 + v740);
                        let v750 = (v744 - v747);
                        let v751 = (v745 - v748);
                        let v752 = (v746 - v749);
                        let v753 = (v191 * v1546);
                        let v754 = (v192 * v1554);
                        let v755 = (v753 + v754);
                        let v756 = (v193 * v1562);
                        let v757 = (v755 + v756);
                        let v758 = (v191 * v1578);
                        let v759 = (v192 * v1586);
                        let v760 = (v758 + v759);
                        let v761 = (v193 * v1594);
                        let v762 = (v760 + v761);
                        let v763 = (v191 * v1610);
                        let v764 = (v192 * v1618);
                        let v765 = (v763 + v764);
                        let v766 = (v193 * v1626);
                        let v767 = (v765 + v766);
                        let v768 = (v757 * v757);
                        let v769 = (v762 * v762);
                        let v770 = (v768 + v769);
                        let v771 = (v767 * v767);
                        let v772 = (v770 + v771);
                        let v773 = (1.0f / v772);
                        let v774 = (v1546 * v735);
                        let v775 = (v1554 * v736);
                        let v776 = (v774 + v775);
                        let v777 = (v1562 * v737);
                        let v778 = (v776 + v777);
                        let v779 = (v1578 * v735);
                        let v780 = (v1586 * v736);
                        let v781 = (v779 + v780);
                        let v782 = (v1594 * v737);
                        let v783 = (v781 + v782);
                        let v784 = (v1610 * v735);
                        let v785 = (v1618 * v736);
                        let v786 = (v784 + v785);
                        let v787 = (v1626 * v737);
                        let v788 = (v786 + v787);
                        let v789 = (v757 * v778);
                        let v790 = (v762 * v783);
                        let v791 = (v789 + v790);
                        let v792 = (v767 * v788);
                        let v793 = (v792 + v791);
                        let v794 = -(v773);
                        let v795 = (v793 * v794);
                        let v796 = (v191 * v795);
                        let v797 = (v192 * v795);
                        let v798 = (v193 * v795);
                        let v799 = (v795 * 4097.0f);
                        let v800 = (v799 - v795);
                        let v801 = (v799 - v800);
                        let v802 = (v795 - v801);
                        let v803 = (v316 * v801);
                        let v804 = (v803 - v796);
                        let v805 = (v316 * v802);
                        let v806 = (v804 + v805);
                        let v807 = (v317 * v801);
                        let v808 = (v807 + v806);
                        let v809 = (v317 * v802);
                        let v810 = (v809 + v808);
                        let v811 = (v320 * v801);
                        let v812 = (v811 - v797);
                        let v813 = (v320 * v802);
                        let v814 = (v812 + v813);
                        let v815 = (v321 * v801);
                        let v816 = (v815 + v814);
                        let v817 = (v321 * v802);
                        let v818 = (v817 + v816);
                        let v819 = (v324 * v801);
                        let v820 = (v819 - v798);
                        let v821 = (v324 * v802);
                        let v822 = (v820 + v821);
                        let v823 = (v325 * v801);
                        let v824 = (v823 + v822);
                        let v825 = (v325 * v802);
                        let v826 = (v825 + v824);
                        let v827 = (v735 + v796);
                        let v828 = (v736 + v797);
                        let v829 = (v737 + v798);
                        let v830 = (v750 + v810);
                        let v831 = (v751 + v818);
                        let v832 = (v752 + v826);
                        let v833 = (v827 + v830);
                        let v834 = (v828 + v831);
                        let v835 = (v829 + v832);
                        let v836 = (v1546 * v833);
                        let v837 = (v1554 * v834);
                        let v838 = (v836 + v837);
                        let v839 = (v1562 * v835);
                        let v840 = (v839 + v838);
                        let v841 = (v1578 * v833);
                        let v842 = (v1586 * v834);
                        let v843 = (v841 + v842);
                        let v844 = (v1594 * v835);
                        let v845 = (v844 + v843);
                        let v846 = (v1610 * v833);
                        let v847 = (v1618 * v834);
                        let v848 = (v846 + v847);
                        let v849 = (v1626 * v835);
                        let v850 = (v849 + v848);
                        let v851 = (v757 * v840);
                        let v852 = (v762 * v845);
                        let v853 = (v851 + v852);
                        let v854 = (v767 * v850);
                        let v855 = (v854 + v853);
                        let v856 = (v855 * v794);
                        let v857 = (v757 * v856);
                        let v858 = (v762 * v856);
                        let v859 = (v767 * v856);
                        let v860 = (v840 + v857);
                        let v861 = (v845 + v858);
                        let v862 = (v850 + v859);
                        let v863 = (v860 * v860);
                        let v864 = (v861 * v861);
                        let v865 = (v863 + v864);
                        let v866 = (v862 * v862);
                        let v867 = (v866 + v865);
                        let v868 = (1.0f - v867);
                        let v869 = !(v868 >= 0.0f);
                        let v870 = (v773 * v868);
                        let v1658 = sqrt(v870);
                        let v872 = select(v1658, bitcast<f32>(bits_7fc00000), v869);
                        let v1659 = abs(v872);
                        let v874 = bitcast<u32>(v1659);
                        let v875 = (v874 > 2139095040u);
                        let v876 = (v730 > v734);
                        let v877 = (v876 | v875);
                        let v878 = (v877 != true);
                        if v878 {
                          let v879 = (v856 - v872);
                          let v880 = (v795 + v879);
                          let v881 = (v880 > v730);
                          let v882 = select(v730, v880, v881);
                          let v883 = (v882 < v734);
                          let v884 = select(v734, v882, v883);
                          let v885 = !(v884 >= 0.0f);
                          if v885 {
                            let v886 = (v856 + v872);
                            let v887 = (v795 + v886);
                            let v888 = (v887 > v730);
                            let v889 = select(v730, v887, v888);
                            let v890 = (v889 < v734);
                            let v891 = select(v734, v889, v890);
                            let v892 = !(v891 >= 0.0f);
                            let v893 = select(v891, bitcast<f32>(bits_7fc00000), v892);
                            p897 = v893;
                          } else {
                            p897 = v884;
                          }
                        } else {
                          p897 = bitcast<f32>(bits_7fc00000);
                        }
                        let v897 = p897;
                        let v898 = (v897 >= 0.0f);
                        let v899 = (v897 < v659);
                        let v900 = (v897 == v659);
                        let v901 = (v1538 < v658);
                        let v902 = (v901 & v900);
                        let v903 = (v899 | v902);
                        let v904 = (v898 & v903);
                        if v904 {
                          p895 = v1538;
                          p896 = v897;
                        } else {
                          p895 = v658;
                          p896 = v659;
                        }
                      } else {
                        p895 = v658;
                        p896 = v659;
                      }
                      let v895 = p895;
                      let v896 = p896;
                      let v1660 = (v1531 == 8u);
                      p1529 = v1531;
                      p658 = v895;
                      p659 = v896;
                      p655 = v895;
                      p654 = v896;
                      done3 = v1660;
                    }
                    p656 = false;
                  } else {
                    p656 = true;
                  }
                  let v654 = p654;
                  let v655 = p655;
                  let v656 = p656;
                  if v656 {
                    p1661 = 0u;
                    p465 = v361;
                    p466 = v360;
                    var done4 = false;
                    loop {
                      if done4 { break; }
                      let v1661 = p1661;
                      let v465 = p465;
                      let v466 = p466;
                      let v1663 = (v1661 + 1u);
                      let v1664 = (v455 * 8u);
                      let v1665 = (v1664 + v1661);
                      let v1666 = (v1665 + 40u);
                      let v1667 = (v1666 >> (2u & 31u));
                      let v1668 = (v1666 & 3u);
                      let v1669 = r4[v1667];
                      let v1670 = v1669[v1668];
                      let v470 = (v1670 != 4294967295u);
                      if v470 {
                        let v1673 = (v1665 >> (2u & 31u));
                        let v1674 = (v1665 & 3u);
                        let v1675 = r4[v1673];
                        let v1676 = v1675[v1674];
                        let v1677 = bitcast<f32>(v1676);
                        let v1680 = (v1665 + 8u);
                        let v1681 = (v1680 >> (2u & 31u));
                        let v1682 = (v1680 & 3u);
                        let v1683 = r4[v1681];
                        let v1684 = v1683[v1682];
                        let v1685 = bitcast<f32>(v1684);
                        let v1688 = (v1665 + 16u);
                        let v1689 = (v1688 >> (2u & 31u));
                        let v1690 = (v1688 & 3u);
                        let v1691 = r4[v1689];
                        let v1692 = v1691[v1690];
                        let v1693 = bitcast<f32>(v1692);
                        let v1696 = (v1665 + 24u);
                        let v1697 = (v1696 >> (2u & 31u));
                        let v1698 = (v1696 & 3u);
                        let v1699 = r4[v1697];
                        let v1700 = v1699[v1698];
                        let v1701 = bitcast<f32>(v1700);
                        let v482 = (v1677 - v1701);
                        let v483 = (v1685 - v1701);
                        let v484 = (v1693 - v1701);
                        let v485 = (v1677 + v1701);
                        let v486 = (v1685 + v1701);
                        let v487 = (v1693 + v1701);
                        let v488 = (v482 - v334);
                        let v489 = (v208 * v488);
                        let v490 = (v485 - v336);
                        let v491 = (v208 * v490);
                        let v492 = (v489 < v491);
                        let v493 = select(v491, v489, v492);
                        let v494 = (v489 > v491);
                        let v495 = select(v491, v489, v494);
                        let v496 = (v483 - v338);
                        let v497 = (v213 * v496);
                        let v498 = (v486 - v340);
                        let v499 = (v213 * v498);
                        let v500 = (v497 < v499);
                        let v501 = select(v499, v497, v500);
                        let v502 = (v497 > v499);
                        let v503 = select(v499, v497, v502);
                        let v504 = (v484 - v342);
                        let v505 = (v218 * v504);
                        let v506 = (v487 - v344);
                        let v507 = (v218 * v506);
                        let v508 = (v505 < v507);
                        let v509 = select(v507, v505, v508);
                        let v510 = (v505 > v507);
                        let v511 = select(v507, v505, v510);
                        let v512 = (v501 > v509);
                        let v513 = select(v509, v501, v512);
                        let v514 = (v493 > v513);
                        let v515 = select(v513, v493, v514);
                        let v516 = (v503 < v511);
                        let v517 = select(v511, v503, v516);
                        let v518 = (v495 < v517);
                        let v519 = select(v517, v495, v518);
                        let v520 = (v1418 - v1677);
                        let v521 = (v1420 - v1685);
                        let v522 = (v1422 - v1693);
                        let v523 = (v520 - v1418);
                        let v524 = (v521 - v1420);
                        let v525 = (v522 - v1422);
                        let v526 = (v520 - v523);
                        let v527 = (v521 - v524);
                        let v528 = (v522 - v525);
                        let v529 = (v1418 - v526);
                        let v530 = (v1420 - v527);
                        let v531 = (v1422 - v528);
                        let v532 = (v1677 + v523);
                        let v533 = (v1685 + v524);
                        let v534 = (v1693 + v525);
                        let v535 = (v529 - v532);
                        let v536 = (v530 - v533);
                        let v537 = (v531 - v534);
                        let v538 = (v191 * v520);
                        let v539 = (v192 * v521);
                        let v540 = (v538 + v539);
                        let v541 = (v193 * v522);
                        let v542 = (v540 + v541);
                        let v543 = (v542 * v332);
                        let v544 = (v191 * v543);
                        let v545 = (v192 * v543);
                        let v546 = (v193 * v543);
                        let v547 = (v543 * 4097.0f);
                        let v548 = (v547 - v543);
                        let v549 = (v547 - v548);
                        let v550 = (v543 - v549);
                        let v551 = (v316 * v549);
                        let v552 = (v551 - v544);
                        let v553 = (v316 * v550);
                        let v554 = (v552 + v553);
                        let v555 = (v317 * v549);
                        let v556 = (v555 + v554);
                        let v557 = (v317 * v550);
                        let v558 = (v557 + v556);
                        let v559 = (v320 * v549);
                        let v560 = (v559 - v545);
                        let v561 = (v320 * v550);
                        let v562 = (v560 + v561);
                        let v563 = (v321 * v549);
                        let v564 = (v563 + v562);
                        let v565 = (v321 * v550);
                        let v566 = (v565 + v564);
                        let v567 = (v324 * v549);
                        let v568 = (v567 - v546);
                        let v569 = (v324 * v550);
                        let v570 = (v568 + v569);
                        let v571 = (v325 * v549);
                        let v572 = (v571 + v570);
                        let v573 = (v325 * v550);
                        let v574 = (v573 + v572);
                        let v575 = (v520 + v544);
                        let v576 = (v521 + v545);
                        let v577 = (v522 + v546);
                        let v578 = (v535 + v558);
                        let v579 = (v536 + v566);
                        let v580 = (v537 + v574);
                        let v581 = (v575 + v578);
                        let v582 = (v576 + v579);
                        let v583 = (v577 + v580);
                        let v584 = (v1701 * v1701);
                        let v585 = (v191 * v581);
                        let v586 = (v192 * v582);
                        let v587 = (v585 + v586);
                        let v588 = (v193 * v583);
                        let v589 = (v588 + v587);
                        let v590 = (v589 * v332);
                        let v591 = (v191 * v590);
                        let v592 = (v192 * v590);
                        let v593 = (v193 * v590);
                        let v594 = (v581 + v591);
                        let v595 = (v582 + v592);
                        let v596 = (v583 + v593);
                        let v597 = (v594 * v594);
                        let v598 = (v595 * v595);
                        let v599 = (v597 + v598);
                        let v600 = (v596 * v596);
                        let v601 = (v600 + v599);
                        let v602 = (v584 - v601);
                        let v603 = !(v602 >= 0.0f);
                        let v604 = (v331 * v602);
                        let v1702 = sqrt(v604);
                        let v606 = select(v1702, bitcast<f32>(bits_7fc00000), v603);
                        let v1703 = abs(v606);
                        let v608 = bitcast<u32>(v1703);
                        let v609 = (v608 > 2139095040u);
                        let v610 = (v515 > v519);
                        let v611 = (v610 | v609);
                        let v612 = (v611 != true);
                        if v612 {
                          let v613 = (v590 - v606);
                          let v614 = (v543 + v613);
                          let v615 = (v614 > v515);
                          let v616 = select(v515, v614, v615);
                          let v617 = (v616 < v519);
                          let v618 = select(v519, v616, v617);
                          let v619 = !(v618 >= 0.0f);
                          if v619 {
                            let v620 = (v590 + v606);
                            let v621 = (v543 + v620);
                            let v622 = (v621 > v515);
                            let v623 = select(v515, v621, v622);
                            let v624 = (v623 < v519);
                            let v625 = select(v519, v623, v624);
                            let v626 = !(v625 >= 0.0f);
                            let v627 = select(v625, bitcast<f32>(bits_7fc00000), v626);
                            p631 = v627;
                          } else {
                            p631 = v618;
                          }
                        } else {
                          p631 = bitcast<f32>(bits_7fc00000);
                        }
                        let v631 = p631;
                        let v632 = (v631 >= 0.0f);
                        let v633 = (v631 < v466);
                        let v634 = (v631 == v466);
                        let v635 = (v1670 < v465);
                        let v636 = (v635 & v634);
                        let v637 = (v633 | v636);
                        let v638 = (v632 & v637);
                        if v638 {
                          p629 = v1670;
                          p630 = v631;
                        } else {
                          p629 = v465;
                          p630 = v466;
                        }
                      } else {
                        p629 = v465;
                        p630 = v466;
                      }
                      let v629 = p629;
                      let v630 = p630;
                      let v1704 = (v1663 == 8u);
                      p1661 = v1663;
                      p465 = v629;
                      p466 = v630;
                      p909 = v629;
                      p910 = v630;
                      done4 = v1704;
                    }
                  } else {
                    p910 = v654;
                    p909 = v655;
                  }
                } else {
                  p909 = v361;
                  p910 = v360;
                }
                let v909 = p909;
                let v910 = p910;
                let v911 = !(v910 == v360);
                let v912 = (v909 != v361);
                let v913 = select(v912, true, v911);
                p905 = v909;
                p906 = v910;
                p937 = v913;
                p908 = false;
              } else {
                p937 = false;
                p908 = true;
              }
              let v905 = p905;
              let v906 = p906;
              let v908 = p908;
              if v908 {
                let v914 = (v1954 & 536870911u);
                p938 = false;
                p1705 = 0u;
                p940 = v361;
                p941 = v360;
                var done5 = false;
                loop {
                  if done5 { break; }
                  let v938 = p938;
                  let v1705 = p1705;
                  let v940 = p940;
                  let v941 = p941;
                  let v1707 = (v1705 + 1u);
                  let v1708 = (v914 * 8u);
                  let v1709 = (v1708 + v1459);
                  let v1710 = (v1709 + v1705);
                  let v1711 = (v1710 >> (2u & 31u));
                  let v1712 = (v1710 & 3u);
                  let v1713 = r4[v1711];
                  let v1714 = v1713[v1712];
                  let v1715 = bitcast<f32>(v1714);
                  let v1717 = (v1708 + v1457);
                  let v1718 = (v1717 + v1705);
                  let v1719 = (v1718 >> (2u & 31u));
                  let v1720 = (v1718 & 3u);
                  let v1721 = r4[v1719];
                  let v1722 = v1721[v1720];
                  let v1723 = bitcast<f32>(v1722);
                  let v1725 = (v1708 + v1455);
                  let v1726 = (v1725 + v1705);
                  let v1727 = (v1726 >> (2u & 31u));
                  let v1728 = (v1726 & 3u);
                  let v1729 = r4[v1727];
                  let v1730 = v1729[v1728];
                  let v1731 = bitcast<f32>(v1730);
                  let v1735 = (v1710 + 24u);
                  let v1736 = (v1735 >> (2u & 31u));
                  let v1737 = (v1735 & 3u);
                  let v1738 = r4[v1736];
                  let v1739 = v1738[v1737];
                  let v1740 = bitcast<f32>(v1739);
                  let v1744 = (v1718 + 24u);
                  let v1745 = (v1744 >> (2u & 31u));
                  let v1746 = (v1744 & 3u);
                  let v1747 = r4[v1745];
                  let v1748 = v1747[v1746];
                  let v1749 = bitcast<f32>(v1748);
                  let v1753 = (v1726 + 24u);
                  let v1754 = (v1753 >> (2u & 31u));
                  let v1755 = (v1753 & 3u);
                  let v1756 = r4[v1754];
                  let v1757 = v1756[v1755];
                  let v1758 = bitcast<f32>(v1757);
                  let v1762 = (v1710 + 48u);
                  let v1763 = (v1762 >> (2u & 31u));
                  let v1764 = (v1762 & 3u);
                  let v1765 = r4[v1763];
                  let v1766 = v1765[v1764];
                  let v1767 = bitcast<f32>(v1766);
                  let v1771 = (v1718 + 48u);
                  let v1772 = (v1771 >> (2u & 31u));
                  let v1773 = (v1771 & 3u);
                  let v1774 = r4[v1772];
                  let v1775 = v1774[v1773];
                  let v1776 = bitcast<f32>(v1775);
                  let v1780 = (v1726 + 48u);
                  let v1781 = (v1780 >> (2u & 31u));
                  let v1782 = (v1780 & 3u);
                  let v1783 = r4[v1781];
                  let v1784 = v1783[v1782];
                  let v1785 = bitcast<f32>(v1784);
                  let v961 = (v1731 - v289);
                  let v962 = (v297 * v961);
                  let v963 = (v1715 - v291);
                  let v964 = (v295 * v962);
                  let v965 = (v963 - v964);
                  let v966 = (v1723 - v290);
                  let v967 = (v296 * v962);
                  let v968 = (v966 - v967);
                  let v969 = (v1758 - v289);
                  let v970 = (v297 * v969);
                  let v971 = (v1740 - v291);
                  let v972 = (v295 * v970);
                  let v973 = (v971 - v972);
                  let v974 = (v1749 - v290);
                  let v975 = (v296 * v970);
                  let v976 = (v974 - v975);
                  let v977 = (v1785 - v289);
                  let v978 = (v297 * v977);
                  let v979 = (v1767 - v291);
                  let v980 = (v295 * v978);
                  let v981 = (v979 - v980);
                  let v982 = (v1776 - v290);
                  let v983 = (v296 * v978);
                  let v984 = (v982 - v983);
                  let v985 = (v976 * v981);
                  let v986 = (v973 * v984);
                  let v987 = (v985 - v986);
                  let v988 = (v965 * v984);
                  let v989 = (v968 * v981);
                  let v990 = (v988 - v989);
                  let v991 = (v968 * v973);
                  let v992 = (v965 * v976);
                  let v993 = (v991 - v992);
                  let v994 = (v987 < v990);
                  let v995 = select(v990, v987, v994);
                  let v996 = (v995 < v993);
                  let v997 = select(v993, v995, v996);
                  let v998 = (v987 > v990);
                  let v999 = select(v990, v987, v998);
                  let v1000 = (v999 > v993);
                  let v1001 = select(v993, v999, v1000);
                  let v1948 = -(v1001);
                  let v1949 = (v1948 == 0.0f);
                  let v1950 = select(v1948, 0.0f, v1949);
                  let v1003 = (v997 > v1950);
                  let v1004 = select(v1950, v997, v1003);
                  let v1005 = (v1004 >= 0.0f);
                  if v1005 {
                    let v1006 = (v962 * v987);
                    let v1007 = (v970 * v990);
                    let v1008 = (v1006 + v1007);
                    let v1009 = (v978 * v993);
                    let v1010 = (v1009 + v1008);
                    let v1011 = (v987 + v990);
                    let v1012 = (v993 + v1011);
                    let v1013 = (v1010 / v1012);
                    let v1787 = (v1708 + v1705);
                    let v1788 = (v1787 + 72u);
                    let v1789 = (v1788 >> (2u & 31u));
                    let v1790 = (v1788 & 3u);
                    let v1791 = r4[v1789];
                    let v1792 = v1791[v1790];
                    let v1795 = (v1787 >> (2u & 31u));
                    let v1796 = (v1787 & 3u);
                    let v1797 = r4[v1795];
                    let v1798 = v1797[v1796];
                    let v1799 = bitcast<f32>(v1798);
                    let v1802 = (v1787 + 8u);
                    let v1803 = (v1802 >> (2u & 31u));
                    let v1804 = (v1802 & 3u);
                    let v1805 = r4[v1803];
                    let v1806 = v1805[v1804];
                    let v1807 = bitcast<f32>(v1806);
                    let v1810 = (v1787 + 16u);
                    let v1811 = (v1810 >> (2u & 31u));
                    let v1812 = (v1810 & 3u);
                    let v1813 = r4[v1811];
                    let v1814 = v1813[v1812];
                    let v1815 = bitcast<f32>(v1814);
                    let v1818 = (v1787 + 24u);
                    let v1819 = (v1818 >> (2u & 31u));
                    let v1820 = (v1818 & 3u);
                    let v1821 = r4[v1819];
                    let v1822 = v1821[v1820];
                    let v1823 = bitcast<f32>(v1822);
                    let v1826 = (v1787 + 32u);
                    let v1827 = (v1826 >> (2u & 31u));
                    let v1828 = (v1826 & 3u);
                    let v1829 = r4[v1827];
                    let v1830 = v1829[v1828];
                    let v1831 = bitcast<f32>(v1830);
                    let v1834 = (v1787 + 40u);
                    let v1835 = (v1834 >> (2u & 31u));
                    let v1836 = (v1834 & 3u);
                    let v1837 = r4[v1835];
                    let v1838 = v1837[v1836];
                    let v1839 = bitcast<f32>(v1838);
                    let v1842 = (v1787 + 48u);
                    let v1843 = (v1842 >> (2u & 31u));
                    let v1844 = (v1842 & 3u);
                    let v1845 = r4[v1843];
                    let v1846 = v1845[v1844];
                    let v1847 = bitcast<f32>(v1846);
                    let v1850 = (v1787 + 56u);
                    let v1851 = (v1850 >> (2u & 31u));
                    let v1852 = (v1850 & 3u);
                    let v1853 = r4[v1851];
                    let v1854 = v1853[v1852];
                    let v1855 = bitcast<f32>(v1854);
                    let v1858 = (v1787 + 64u);
                    let v1859 = (v1858 >> (2u & 31u));
                    let v1860 = (v1858 & 3u);
                    let v1861 = r4[v1859];
                    let v1862 = v1861[v1860];
                    let v1863 = bitcast<f32>(v1862);
                    let v1034 = (v1823 < v1847);
                    let v1035 = select(v1847, v1823, v1034);
                    let v1036 = (v1799 < v1035);
                    let v1037 = select(v1035, v1799, v1036);
                    let v1038 = (v1831 < v1855);
                    let v1039 = select(v1855, v1831, v1038);
                    let v1040 = (v1807 < v1039);
                    let v1041 = select(v1039, v1807, v1040);
                    let v1042 = (v1839 < v1863);
                    let v1043 = select(v1863, v1839, v1042);
                    let v1044 = (v1815 < v1043);
                    let v1045 = select(v1043, v1815, v1044);
                    let v1046 = (v1823 > v1847);
                    let v1047 = select(v1847, v1823, v1046);
                    let v1048 = (v1799 > v1047);
                    let v1049 = select(v1047, v1799, v1048);
                    let v1050 = (v1831 > v1855);
                    let v1051 = select(v1855, v1831, v1050);
                    let v1052 = (v1807 > v1051);
                    let v1053 = select(v1051, v1807, v1052);
                    let v1054 = (v1839 > v1863);
                    let v1055 = select(v1863, v1839, v1054);
                    let v1056 = (v1815 > v1055);
                    let v1057 = select(v1055, v1815, v1056);
                    let v1058 = (v1037 - v334);
                    let v1059 = (v208 * v1058);
                    let v1060 = (v1049 - v336);
                    let v1061 = (v208 * v1060);
                    let v1062 = (v1059 < v1061);
                    let v1063 = select(v1061, v1059, v1062);
                    let v1064 = (v1059 > v1061);
                    let v1065 = select(v1061, v1059, v1064);
                    let v1066 = (v1041 - v338);
                    let v1067 = (v213 * v1066);
                    let v1068 = (v1053 - v340);
                    let v1069 = (v213 * v1068);
                    let v1070 = (v1067 < v1069);
                    let v1071 = select(v1069, v1067, v1070);
                    let v1072 = (v1067 > v1069);
                    let v1073 = select(v1069, v1067, v1072);
                    let v1074 = (v1045 - v342);
                    let v1075 = (v218 * v1074);
                    let v1076 = (v1057 - v344);
                    let v1077 = (v218 * v1076);
                    let v1078 = (v1075 < v1077);
                    let v1079 = select(v1077, v1075, v1078);
                    let v1080 = (v1075 > v1077);
                    let v1081 = select(v1077, v1075, v1080);
                    let v1082 = (v1071 > v1079);
                    let v1083 = select(v1079, v1071, v1082);
                    let v1084 = (v1063 > v1083);
                    let v1085 = select(v1083, v1063, v1084);
                    let v1086 = (v1073 < v1081);
                    let v1087 = select(v1081, v1073, v1086);
                    let v1088 = (v1065 < v1087);
                    let v1089 = select(v1087, v1065, v1088);
                    let v1090 = (v1085 <= v1013);
                    let v1091 = (v1013 <= v1089);
                    let v1092 = (v1090 & v1091);
                    let v1093 = (v1092 != true);
                    if v1093 {
                      let v1094 = (v1085 <= v1089);
                      if v1094 {
                        let v1095 = (v1013 > v1085);
                        let v1096 = select(v1085, v1013, v1095);
                        let v1097 = !(v1096 < v1089);
                        if v1097 {
                          p1103 = v1089;
                        } else {
                          p1103 = v1096;
                        }
                      } else {
                        p1103 = bitcast<f32>(bits_7fc00000);
                      }
                    } else {
                      p1103 = v1013;
                    }
                    let v1103 = p1103;
                    let v1104 = (v1103 >= 0.0f);
                    let v1105 = (v1103 < v941);
                    let v1106 = (v1103 == v941);
                    let v1107 = (v1792 < v940);
                    let v1108 = (v1107 & v1106);
                    let v1109 = (v1105 | v1108);
                    let v1110 = (v1104 & v1109);
                    if v1110 {
                      let v1111 = (v1004 <= 0.0f);
                      if v1111 {
                        let v1112 = (v987 == 0.0f);
                        if v1112 {
                          let v1113 = (v981 * 4097.0f);
                          let v1114 = (v1113 - v981);
                          let v1115 = (v1113 - v1114);
                          let v1116 = (v981 - v1115);
                          let v1117 = (v976 * 4097.0f);
                          let v1118 = (v1117 - v976);
                          let v1119 = (v1117 - v1118);
                          let v1120 = (v976 - v1119);
                          let v1121 = (v1119 * v1115);
                          let v1122 = (v1121 - v985);
                          let v1123 = (v1120 * v1115);
                          let v1124 = (v1123 + v1122);
                          let v1125 = (v1119 * v1116);
                          let v1126 = (v1125 + v1124);
                          let v1127 = (v1120 * v1116);
                          let v1128 = (v1127 + v1126);
                          let v1129 = (v984 * 4097.0f);
                          let v1130 = (v1129 - v984);
                          let v1131 = (v1129 - v1130);
                          let v1132 = (v984 - v1131);
                          let v1133 = (v973 * 4097.0f);
                          let v1134 = (v1133 - v973);
                          let v1135 = (v1133 - v1134);
                          let v1136 = (v973 - v1135);
                          let v1137 = (v1135 * v1131);
                          let v1138 = (v1137 - v986);
                          let v1139 = (v1136 * v1131);
                          let v1140 = (v1139 + v1138);
                          let v1141 = (v1135 * v1132);
                          let v1142 = (v1141 + v1140);
                          let v1143 = (v1136 * v1132);
                          let v1144 = (v1143 + v1142);
                          let v1145 = (v1128 - v1144);
                          p1149 = v1145;
                        } else {
                          p1149 = v987;
                        }
                        let v1149 = p1149;
                        let v1150 = !(v1149 == 0.0f);
                        let v1151 = (v984 - v976);
                        let v1152 = select(v1151, v1149, v1150);
                        let v1153 = !(v1152 == 0.0f);
                        let v1154 = (v973 - v981);
                        let v1155 = select(v1154, v1152, v1153);
                        let v1156 = (v1155 > 0.0f);
                        let v1157 = (v1155 < 0.0f);
                        let v1158 = (v990 == 0.0f);
                        if v1158 {
                          let v1159 = (v965 * 4097.0f);
                          let v1160 = (v1159 - v965);
                          let v1161 = (v1159 - v1160);
                          let v1162 = (v965 - v1161);
                          let v1163 = (v984 * 4097.0f);
                          let v1164 = (v1163 - v984);
                          let v1165 = (v1163 - v1164);
                          let v1166 = (v984 - v1165);
                          let v1167 = (v1161 * v1165);
                          let v1168 = (v1167 - v988);
                          let v1169 = (v1161 * v1166);
                          let v1170 = (v1168 + v1169);
                          let v1171 = (v1162 * v1165);
                          let v1172 = (v1171 + v1170);
                          let v1173 = (v1162 * v1166);
                          let v1174 = (v1173 + v1172);
                          let v1175 = (v968 * 4097.0f);
                          let v1176 = (v1175 - v968);
                          let v1177 = (v1175 - v1176);
                          let v1178 = (v968 - v1177);
                          let v1179 = (v981 * 4097.0f);
                          let v1180 = (v1179 - v981);
                          let v1181 = (v1179 - v1180);
                          let v1182 = (v981 - v1181);
                          let v1183 = (v1177 * v1181);
                          let v1184 = (v1183 - v989);
                          let v1185 = (v1177 * v1182);
                          let v1186 = (v1184 + v1185);
                          let v1187 = (v1178 * v1181);
                          let v1188 = (v1187 + v1186);
                          let v1189 = (v1178 * v1182);
                          let v1190 = (v1189 + v1188);
                          let v1191 = (v1174 - v1190);
                          p1192 = v1191;
                        } else {
                          p1192 = v990;
                        }
                        let v1192 = p1192;
                        let v1193 = !(v1192 == 0.0f);
                        let v1194 = (v968 - v984);
                        let v1195 = select(v1194, v1192, v1193);
                        let v1196 = !(v1195 == 0.0f);
                        let v1197 = (v981 - v965);
                        let v1198 = select(v1197, v1195, v1196);
                        let v1199 = (v1198 > 0.0f);
                        let v1200 = (v1198 < 0.0f);
                        let v1201 = (v993 == 0.0f);
                        if v1201 {
                          let v1202 = (v973 * 4097.0f);
                          let v1203 = (v1202 - v973);
                          let v1204 = (v1202 - v1203);
                          let v1205 = (v973 - v1204);
                          let v1206 = (v968 * 4097.0f);
                          let v1207 = (v1206 - v968);
                          let v1208 = (v1206 - v1207);
                          let v1209 = (v968 - v1208);
                          let v1210 = (v1208 * v1204);
                          let v1211 = (v1210 - v991);
                          let v1212 = (v1209 * v1204);
                          let v1213 = (v1212 + v1211);
                          let v1214 = (v1208 * v1205);
                          let v1215 = (v1214 + v1213);
                          let v1216 = (v1209 * v1205);
                          let v1217 = (v1216 + v1215);
                          let v1218 = (v976 * 4097.0f);
                          let v1219 = (v1218 - v976);
                          let v1220 = (v1218 - v1219);
                          let v1221 = (v976 - v1220);
                          let v1222 = (v965 * 4097.0f);
                          let v1223 = (v1222 - v965);
                          let v1224 = (v1222 - v1223);
                          let v1225 = (v965 - v1224);
                          let v1226 = (v1224 * v1220);
                          let v1227 = (v1226 - v992);
                          let v1228 = (v1225 * v1220);
                          let v1229 = (v1228 + v1227);
                          let v1230 = (v1224 * v1221);
                          let v1231 = (v1230 + v1229);
                          let v1232 = (v1225 * v1221);
                          let v1233 = (v1232 + v1231);
                          let v1234 = (v1217 - v1233);
                          p1235 = v1234;
                        } else {
                          p1235 = v993;
                        }
                        let v1235 = p1235;
                        let v1236 = !(v1235 == 0.0f);
                        let v1237 = (v976 - v968);
                        let v1238 = select(v1237, v1235, v1236);
                        let v1239 = !(v1238 == 0.0f);
                        let v1240 = (v965 - v973);
                        let v1241 = select(v1240, v1238, v1239);
                        let v1242 = (v1241 > 0.0f);
                        let v1243 = (v1241 < 0.0f);
                        let v1244 = (v1156 & v1199);
                        let v1245 = (v1244 & v1242);
                        let v1246 = (v1157 & v1200);
                        let v1247 = (v1246 & v1243);
                        let v1248 = (v1245 | v1247);
                        if v1248 {
                          p1254 = true;
                          p1101 = v1792;
                          p1102 = v1103;
                        } else {
                          p1254 = false;
                          p1101 = v940;
                          p1102 = v941;
                        }
                      } else {
                        p1254 = true;
                        p1101 = v1792;
                        p1102 = v1103;
                      }
                    } else {
                      p1102 = v941;
                      p1101 = v940;
                      p1254 = false;
                    }
                    let v1254 = p1254;
                    let v1255 = (v938 | v1254);
                    p1100 = v1255;
                  } else {
                    p1100 = v938;
                    p1101 = v940;
                    p1102 = v941;
                  }
                  let v1100 = p1100;
                  let v1101 = p1101;
                  let v1102 = p1102;
                  let v1864 = (v1707 == 8u);
                  p938 = v1100;
                  p1705 = v1707;
                  p940 = v1101;
                  p941 = v1102;
                  p937 = v1100;
                  p1962 = v1101;
                  p936 = v1102;
                  done5 = v1864;
                }
                let v1962 = p1962;
                p934 = v1962;
                p450 = v1962;
              } else {
                p934 = v361;
                p450 = v905;
                p936 = v906;
              }
              let v934 = p934;
              let v936 = p936;
              let v937 = p937;
              if v937 {
                p452 = v936;
              } else {
                p452 = v363;
                p450 = v934;
              }
              p449 = v936;
            } else {
              p449 = v360;
              p450 = v361;
              p1257 = v1956;
              p452 = v363;
            }
            let v449 = p449;
            let v450 = p450;
            let v452 = p452;
            let v453 = bitcast<u32>(v452);
            var done6 = false;
            loop {
              if done6 { break; }
              let v1257 = p1257;
              let v1258 = (v1257 != 0u);
              if v1258 {
                let v1259 = (v1257 + 4294967295u);
                let v1865 = (v1257 * 2u);
                let v1866 = (v1865 + 4294967295u);
                let v1867 = r0[v1866];
                let v1264 = (v1867 <= v453);
                let v1914 = (v1865 + 4294967294u);
                p1334 = false;
                p1335 = v1259;
                p1965 = v1914;
                p1337 = v1264;
              } else {
                p1334 = true;
                p1965 = 0u;
                p1337 = true;
              }
              let v1334 = p1334;
              let v1335 = p1335;
              let v1337 = p1337;
              let v1338 = (v1334 != true);
              p1257 = v1335;
              p365 = v1335;
              p1966 = v1338;
              done6 = v1337;
            }
            let v1965 = p1965;
            let v1966 = p1966;
            if v1966 {
              let v1869 = r0[v1965];
              p1265 = v1869;
              p1266 = false;
            } else {
              p1266 = true;
            }
            let v1265 = p1265;
            let v1266 = p1266;
            p360 = v449;
            p361 = v450;
            p363 = v452;
            p366 = v1265;
            p1967 = v449;
            p1968 = v450;
            done0 = v1266;
          }
          let v1967 = p1967;
          let v1968 = p1968;
          let v1267 = (v1967 < v63);
          let v1268 = select(4294967295u, v1968, v1267);
          let v1269 = select(bitcast<f32>(bits_7f800000), v1967, v1267);
          p1279 = v1269;
          p354 = v1268;
          p1292 = v1968;
          p356 = v1268;
          p357 = v1269;
          p1275 = true;
          p359 = v158;
        } else {
          p356 = 4294967295u;
          p357 = bitcast<f32>(bits_7f800000);
          p1275 = false;
        }
        let v354 = p354;
        let v356 = p356;
        let v357 = p357;
        let v359 = p359;
        if v359 {
          let v1270 = (v65 << (16u & 31u));
          let v1271 = (v1270 | 65535u);
          p1277 = v1271;
          p1294 = true;
          p1281 = false;
          p1275 = false;
        } else {
          p1294 = false;
        }
        let v1275 = p1275;
        if v1275 {
          let v1276 = (v354 == 4294967295u);
          p1277 = 327679u;
          p1294 = true;
          p1281 = v1276;
        } else {
          p1292 = v356;
          p1279 = v357;
        }
        let v1277 = p1277;
        let v1279 = p1279;
        let v1281 = p1281;
        if v1281 {
          if v38 {
            let v1295 = (v64 ^ 4294967295u);
            let v1296 = (v1383 + v1295);
            let v1297 = (v1296 | 65536u);
            let v1298 = (v1296 >= 131072u);
            p287 = v1296;
            p1291 = v1297;
            p288 = true;
            p1294 = v1298;
            p1286 = false;
          } else {
            p287 = v64;
            p288 = v67;
            p1294 = false;
            p1286 = true;
          }
          let v1286 = p1286;
          if v1286 {
            let v1287 = (v64 | 65536u);
            let v1288 = (v64 < 131072u);
            let v1289 = (v1288 != true);
            p287 = v64;
            p1291 = v1287;
            p288 = v1288;
            p1294 = v1289;
          }
          p1292 = 4294967295u;
        } else {
          p287 = v64;
          p1291 = v1277;
          p288 = v67;
        }
        let v1291 = p1291;
        let v1292 = p1292;
        let v1294 = p1294;
        if v1294 {
          r9[v42] = v1291;
          let v1871 = bitcast<u32>(v1279);
          let v1872 = (v42 * 2u);
          r10[v1872] = v1871;
          let v1875 = (v1872 + 1u);
          r10[v1875] = v1292;
          p288 = false;
        }
      } else {
        p287 = v64;
        p288 = v67;
      }
      let v287 = p287;
      let v288 = p288;
      if v288 {
        let v1311 = (v287 + v34);
        let v1312 = (v65 << (16u & 31u));
        let v1313 = (v1312 | v287);
        r9[v42] = v1313;
        let v1878 = r1[2u][1u];
        let v1317 = (v1878 != 0u);
        if v1317 {
          let v1879 = (v1311 * 2u);
          let v1880 = r7[v1879];
          let v1883 = (v1879 + 1u);
          let v1884 = r7[v1883];
          let v1885 = (v42 * 2u);
          r10[v1885] = v1880;
          let v1888 = (v1885 + 1u);
          r10[v1888] = v1884;
        }
        let v1890 = r1[2u][2u];
        let v1328 = (v1890 != 0u);
        if v1328 {
          let v1891 = (v1311 * 4u);
          let v1892 = r8[v1891];
          let v1894 = (v1891 + 1u);
          let v1895 = r8[v1894];
          let v1897 = (v1891 + 2u);
          let v1898 = r8[v1897];
          let v1900 = (v1891 + 3u);
          let v1901 = r8[v1900];
          let v1902 = (v42 * 4u);
          r11[v1902] = v1892;
          let v1905 = (v1902 + 1u);
          r11[v1905] = v1895;
          let v1908 = (v1902 + 2u);
          r11[v1908] = v1898;
          let v1911 = (v1902 + 3u);
          r11[v1911] = v1901;
        }
      }
    }
  }
  return;
}
