@group(0) @binding(0) var<storage, read> r0: array<u32>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
@id(0) override spec0: u32 = 0u;
var<private> bits_7f800000: u32 = 2139095040u;
var<private> bits_7fc00000: u32 = 2143289344u;
var<private> bits_ff800000: u32 = 4286578688u;
@compute @workgroup_size(64, 1, 1)
fn arithmetic(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p732: u32;
  var p733: u32;
  var p729: bool;
  var p47: bool;
  var p37: f32;
  var p38: u32;
  var p39: bool;
  var p41: bool;
  var p709: bool;
  var p716: bool;
  var p31: f32;
  var p35: bool;
  var p643: bool;
  var p640: bool;
  var p63: f32;
  var p64: bool;
  var p635: bool;
  var p25: f32;
  var p27: bool;
  var p28: bool;
  var p29: bool;
  var p622: bool;
  var p572: bool;
  var p615: bool;
  var p619: u32;
  var p76: f32;
  var p77: bool;
  var p454: bool;
  var p461: bool;
  var p471: u32;
  var p472: u32;
  var p473: bool;
  var p499: bool;
  var p505: f32;
  var p504: bool;
  var p553: f32;
  var p554: u32;
  var p555: f32;
  var p565: f32;
  var p400: f32;
  var p401: bool;
  var p408: bool;
  var p418: u32;
  var p419: u32;
  var p420: bool;
  var p446: bool;
  var p79: f32;
  var p80: bool;
  var p81: bool;
  var p248: bool;
  var p258: bool;
  var p255: bool;
  var p262: bool;
  var p271: bool;
  var p277: u32;
  var p278: u32;
  var p307: bool;
  var p316: u32;
  var p317: u32;
  var p318: bool;
  var p341: bool;
  var p357: u32;
  var p358: u32;
  var p359: u32;
  var p111: bool;
  var p134: bool;
  var p135: bool;
  var p130: bool;
  var p150: bool;
  var p156: u32;
  var p157: u32;
  var p165: bool;
  var p170: u32;
  var p171: u32;
  var p198: bool;
  var p206: u32;
  var p207: u32;
  var p240: u32;
  var p212: bool;
  var p242: u32;
  var p245: u32;
  var p89: f32;
  var p90: bool;
  var p91: bool;
  var p95: bool;
  var p72: bool;
  var p103: bool;
  var p759: f32;
  var p760: bool;
  var p762: u32;
  let v768 = global_invocation_id[0u];
  let v773 = (arrayLength(&r2) * 1u);
  let v9 = (v773 & 1073741823u);
  let v774 = spec0;
  let v11 = (v768 < v9);
  if v11 {
    let v775 = r0[v768];
    let v776 = r1[v768];
    let v21 = bitcast<f32>(v775);
    let v22 = bitcast<f32>(v776);
    let v23 = (bitcast<i32>(v774) >= bitcast<i32>(10u));
    if v23 {
      let v24 = (bitcast<i32>(v774) >= bitcast<i32>(15u));
      if v24 {
        let v30 = (bitcast<i32>(v774) >= bitcast<i32>(18u));
        if v30 {
          let v36 = (bitcast<i32>(v774) >= bitcast<i32>(19u));
          if v36 {
            let v42 = (bitcast<i32>(v774) >= bitcast<i32>(21u));
            if v42 {
              let v48 = (v774 == 21u);
              if v48 {
                let v730 = (v775 != 0u);
                if v730 {
                  p732 = v776;
                  p733 = 0u;
                  var done0 = false;
                  loop {
                    if done0 { break; }
                    let v732 = p732;
                    let v733 = p733;
                    let v734 = (v733 + 1u);
                    let v735 = (v732 * 1664525u);
                    let v736 = (v735 + 1013904223u);
                    let v737 = (v734 == v775);
                    p732 = v736;
                    p733 = v734;
                    p38 = v736;
                    done0 = v737;
                  }
                } else {
                  p38 = v776;
                }
                p28 = false;
              } else {
                p28 = true;
              }
              p729 = false;
            } else {
              p28 = false;
              p729 = true;
            }
            let v729 = p729;
            if v729 {
              let v51 = (v774 == 19u);
              if v51 {
                let v725 = (v21 * v21);
                let v726 = (v725 - v22);
                p37 = v726;
                p39 = true;
                p28 = false;
              } else {
                p39 = false;
                p28 = true;
              }
            } else {
              p39 = false;
            }
            p47 = false;
          } else {
            p39 = false;
            p28 = false;
            p47 = true;
          }
          let v47 = p47;
          if v47 {
            let v777 = sqrt(v21);
            p37 = v777;
            p39 = true;
          }
          p41 = false;
        } else {
          p39 = false;
          p28 = false;
          p41 = true;
        }
        let v37 = p37;
        let v38 = p38;
        let v39 = p39;
        let v41 = p41;
        if v41 {
          let v54 = (bitcast<i32>(v774) >= bitcast<i32>(16u));
          if v54 {
            let v58 = (bitcast<i32>(v774) >= bitcast<i32>(17u));
            if v58 {
              let v717 = (v21 / v22);
              p31 = v717;
              p27 = true;
              p709 = false;
            } else {
              p27 = v39;
              p709 = true;
            }
            let v709 = p709;
            if v709 {
              let v710 = (v776 << (14u & 31u));
              let v711 = (v710 - v775);
              let v712 = (v711 + 16383u);
              p762 = v712;
            }
            p716 = false;
          } else {
            p27 = v39;
            p716 = true;
          }
          let v716 = p716;
          if v716 {
            let v690 = (v22 == bitcast<f32>(bits_7f800000));
            let v691 = (v22 + -1.0f);
            let v692 = (v691 / v22);
            let v693 = (v692 * v21);
            let v694 = select(v693, v21, v690);
            let v695 = (v694 > -1048576.0f);
            let v696 = select(-1048576.0f, v694, v695);
            let v697 = (v696 < 1048576.0f);
            let v698 = select(1048576.0f, v696, v697);
            let v699 = (v698 + 12582912.0f);
            let v700 = bitcast<u32>(v699);
            let v701 = (v700 + 3032481792u);
            let v702 = f32(bitcast<i32>(v701));
            let v703 = (v698 - v702);
            let v704 = (v703 >= 0.5f);
            let v705 = select(0u, 1u, v704);
            let v706 = (v701 + v705);
            p762 = v706;
          }
        } else {
          p31 = v37;
          p762 = v38;
          p27 = v39;
        }
        p35 = false;
      } else {
        p27 = false;
        p28 = false;
        p35 = true;
      }
      let v31 = p31;
      let v35 = p35;
      if v35 {
        let v60 = (bitcast<i32>(v774) >= bitcast<i32>(12u));
        if v60 {
          let v61 = (bitcast<i32>(v774) >= bitcast<i32>(13u));
          if v61 {
            let v62 = (bitcast<i32>(v774) >= bitcast<i32>(14u));
            if v62 {
              let v661 = (v21 * v21);
              let v662 = (1.0f - v661);
              let v663 = (v662 > 0.0f);
              let v664 = select(0.0f, v662, v663);
              let v665 = (v22 * v22);
              let v666 = (v664 / v665);
              let v667 = (1.0f - v666);
              let v668 = (v667 > 0.0f);
              if v668 {
                let v778 = sqrt(v667);
                let v670 = (v21 * v22);
                let v671 = (v670 + v778);
                let v672 = (v778 * v22);
                let v673 = (v672 + v21);
                let v674 = (v671 <= 0.0f);
                let v675 = (v673 <= 0.0f);
                let v676 = (v674 | v675);
                let v677 = (v676 != true);
                if v677 {
                  let v678 = (v670 - v778);
                  let v679 = (v678 / v671);
                  let v680 = (v21 - v672);
                  let v681 = (v680 / v673);
                  let v682 = (v679 * v679);
                  let v683 = (v681 * v681);
                  let v684 = (v682 + v683);
                  let v685 = (v684 * 0.5f);
                  let v686 = (v685 > 0.0f);
                  let v687 = select(0.0f, v685, v686);
                  let v688 = !(v687 < 1.0f);
                  if v688 {
                    p63 = 1.0f;
                  } else {
                    p63 = v687;
                  }
                } else {
                  p63 = 1.0f;
                }
              } else {
                p63 = 1.0f;
              }
              p643 = false;
            } else {
              p643 = true;
            }
            let v643 = p643;
            if v643 {
              let v644 = (v21 * v22);
              let v645 = (v21 * 4097.0f);
              let v646 = (v645 - v21);
              let v647 = (v645 - v646);
              let v648 = (v21 - v647);
              let v649 = (v22 * 4097.0f);
              let v650 = (v649 - v22);
              let v651 = (v649 - v650);
              let v652 = (v22 - v651);
              let v653 = (v647 * v651);
              let v654 = (v653 - v644);
              let v655 = (v647 * v652);
              let v656 = (v654 + v655);
              let v657 = (v648 * v651);
              let v658 = (v657 + v656);
              let v659 = (v648 * v652);
              let v660 = (v659 + v658);
              p63 = v660;
            }
            p640 = false;
          } else {
            p640 = true;
          }
          let v640 = p640;
          if v640 {
            let v641 = (v21 * v22);
            p63 = v641;
          }
          p64 = false;
        } else {
          p64 = true;
        }
        let v63 = p63;
        let v64 = p64;
        if v64 {
          let v65 = (bitcast<i32>(v774) >= bitcast<i32>(11u));
          if v65 {
            let v638 = (v21 + v22);
            p25 = v638;
            p635 = false;
          } else {
            p635 = true;
          }
          let v635 = p635;
          if v635 {
            let v636 = (v21 > v22);
            let v637 = select(v22, v21, v636);
            p25 = v637;
          }
        } else {
          p25 = v63;
        }
        p27 = true;
      } else {
        p25 = v31;
      }
      p29 = false;
    } else {
      p27 = false;
      p28 = false;
      p29 = true;
    }
    let v25 = p25;
    let v27 = p27;
    let v28 = p28;
    let v29 = p29;
    if v29 {
      let v68 = (bitcast<i32>(v774) >= bitcast<i32>(5u));
      if v68 {
        let v73 = (bitcast<i32>(v774) >= bitcast<i32>(7u));
        if v73 {
          let v74 = (bitcast<i32>(v774) >= bitcast<i32>(8u));
          if v74 {
            let v75 = (bitcast<i32>(v774) >= bitcast<i32>(9u));
            if v75 {
              let v632 = (v21 < v22);
              let v633 = select(v22, v21, v632);
              p76 = v633;
              p622 = false;
            } else {
              p622 = true;
            }
            let v622 = p622;
            if v622 {
              let v779 = bitcast<u32>(i32(v21));
              let v780 = (v21 > -2147483600.0f);
              let v781 = select(2147483648u, v779, v780);
              let v782 = (v21 >= 2147483600.0f);
              let v783 = select(v781, 2147483647u, v782);
              let v784 = (v775 & 2147483647u);
              let v785 = (v784 > 2139095040u);
              let v786 = select(v783, 0u, v785);
              let v624 = f32(bitcast<i32>(v786));
              let v625 = (v624 > v21);
              let v626 = select(0u, 4294967295u, v625);
              let v627 = (v786 + v626);
              let v628 = f32(bitcast<i32>(v627));
              let v630 = bitcast<f32>(v784);
              let v631 = !(v630 < 8388608.0f);
              if v631 {
                p76 = v21;
              } else {
                p76 = v628;
              }
            }
            p572 = false;
          } else {
            p572 = true;
          }
          let v572 = p572;
          if v572 {
            let v573 = (v21 + v22);
            let v787 = abs(v573);
            let v575 = bitcast<u32>(v787);
            let v576 = (v575 <= 2139095040u);
            if v576 {
              let v788 = abs(v22);
              let v789 = abs(v21);
              let v579 = (v788 > v789);
              let v580 = select(v789, v788, v579);
              let v581 = !(v580 == 0.0f);
              if v581 {
                let v582 = (v788 < v789);
                let v583 = select(v789, v788, v582);
                let v584 = (v583 / v580);
                let v585 = (v584 < 7.888609e-31f);
                let v586 = select(v584, 0.0f, v585);
                let v587 = (v586 * v586);
                let v588 = (v587 * 0.0028498895f);
                let v589 = (v588 + -0.016068604f);
                let v590 = (v587 * v589);
                let v591 = (v590 + 0.04269143f);
                let v592 = (v587 * v591);
                let v593 = (v592 + -0.07504282f);
                let v594 = (v587 * v593);
                let v595 = (v594 + 0.10640925f);
                let v596 = (v587 * v595);
                let v597 = (v596 + -0.14203641f);
                let v598 = (v587 * v597);
                let v599 = (v598 + 0.19992618f);
                let v600 = (v587 * v599);
                let v601 = (v600 + -0.33333072f);
                let v602 = (v587 * v601);
                let v603 = (v602 + 1.0f);
                let v604 = (v586 * v603);
                let v605 = (1.5707964f - v604);
                let v606 = select(v604, v605, v582);
                let v607 = (v22 < 0.0f);
                let v608 = (3.1415927f - v606);
                let v609 = select(v606, v608, v607);
                let v790 = abs(v609);
                let v611 = bitcast<u32>(v790);
                let v612 = (v775 & 2147483648u);
                let v613 = (v612 | v611);
                p619 = v613;
                p615 = false;
              } else {
                p615 = true;
              }
              let v615 = p615;
              if v615 {
                let v616 = (v775 & 2147483648u);
                p619 = v616;
              }
            } else {
              p619 = 2143289344u;
            }
            let v619 = p619;
            let v620 = bitcast<f32>(v619);
            p76 = v620;
          }
          p77 = false;
        } else {
          p77 = true;
        }
        let v76 = p76;
        let v77 = p77;
        if v77 {
          let v78 = (bitcast<i32>(v774) >= bitcast<i32>(6u));
          if v78 {
            let v449 = (v22 >= 0.0f);
            let v450 = (v22 <= 65536.0f);
            let v451 = (v449 & v450);
            let v452 = (v451 != true);
            if v451 {
              let v791 = bitcast<u32>(i32(v22));
              let v792 = (v22 > -2147483600.0f);
              let v793 = select(2147483648u, v791, v792);
              let v794 = (v22 >= 2147483600.0f);
              let v795 = select(v793, 2147483647u, v794);
              let v796 = (v776 & 2147483647u);
              let v797 = (v796 > 2139095040u);
              let v798 = select(v795, 0u, v797);
              let v541 = f32(bitcast<i32>(v798));
              let v542 = (v22 < v541);
              let v543 = select(0u, 4294967295u, v542);
              let v544 = (v798 + v543);
              let v545 = f32(bitcast<i32>(v544));
              let v799 = abs(v22);
              let v547 = (v799 < 8388608.0f);
              let v548 = select(v22, v545, v547);
              let v549 = !(v548 == v22);
              p504 = true;
              p454 = v549;
            } else {
              p504 = false;
              p454 = v452;
            }
            let v454 = p454;
            if v454 {
              let v800 = abs(v21);
              let v456 = bitcast<u32>(v800);
              let v457 = (v456 <= 8388607u);
              if v457 {
                let v801 = countLeadingZeros(v456);
                let v467 = (v801 + 4294967288u);
                let v468 = (v456 << (v467 & 31u));
                let v469 = (4294967155u - v801);
                let v470 = (v468 != 0u);
                p471 = v469;
                p472 = v468;
                p473 = v470;
                p461 = false;
              } else {
                p473 = false;
                p461 = true;
              }
              let v461 = p461;
              if v461 {
                let v462 = (v456 & 8388607u);
                let v463 = (v462 | 8388608u);
                let v464 = (v456 >> (23u & 31u));
                let v465 = (v464 + 4294967146u);
                p471 = v465;
                p472 = v463;
                p473 = true;
              }
              let v471 = p471;
              let v472 = p472;
              let v473 = p473;
              if v473 {
                let v474 = (v775 <= 2139095039u);
                if v474 {
                  let v475 = (v472 > 11863283u);
                  let v476 = select(0u, 4294967295u, v475);
                  let v477 = select(0u, 1u, v475);
                  let v478 = (v472 & 8388607u);
                  let v479 = (v478 | 1065353216u);
                  let v480 = (v476 << (23u & 31u));
                  let v481 = (v479 + v480);
                  let v482 = bitcast<f32>(v481);
                  let v483 = (v482 + -1.0f);
                  let v484 = (v482 + 1.0f);
                  let v485 = (v483 / v484);
                  let v486 = (v485 * v485);
                  let v487 = (v471 + 23u);
                  let v488 = (v487 + v477);
                  let v489 = f32(bitcast<i32>(v488));
                  let v490 = (v486 * 0.4317447f);
                  let v491 = (v490 + 0.57671404f);
                  let v492 = (v486 * v491);
                  let v493 = (v492 + 0.96179885f);
                  let v494 = (v486 * v493);
                  let v495 = (v494 + 2.88539f);
                  let v496 = (v485 * v495);
                  let v497 = (v496 + v489);
                  p505 = v497;
                  p499 = false;
                } else {
                  p499 = true;
                }
                let v499 = p499;
                if v499 {
                  let v500 = (v775 == 2139095040u);
                  let v501 = select(bitcast<f32>(bits_7fc00000), bitcast<f32>(bits_7f800000), v500);
                  p505 = v501;
                }
              } else {
                p505 = bitcast<f32>(bits_ff800000);
              }
              let v505 = p505;
              let v506 = (v505 * v22);
              let v802 = abs(v506);
              let v508 = bitcast<u32>(v802);
              let v509 = (v508 <= 2139095040u);
              if v509 {
                let v510 = !(v506 >= 128.0f);
                if v510 {
                  let v511 = !(v506 < -126.0f);
                  if v511 {
                    let v512 = (v506 + 0.5f);
                    let v803 = bitcast<u32>(i32(v512));
                    let v804 = (v512 > -2147483600.0f);
                    let v805 = select(2147483648u, v803, v804);
                    let v806 = (v512 >= 2147483600.0f);
                    let v807 = select(v805, 2147483647u, v806);
                    let v808 = bitcast<u32>(v512);
                    let v809 = (v808 & 2147483647u);
                    let v810 = (v809 > 2139095040u);
                    let v811 = select(v807, 0u, v810);
                    let v514 = f32(bitcast<i32>(v811));
                    let v515 = (v512 < v514);
                    let v516 = select(0u, 4294967295u, v515);
                    let v517 = (v811 + v516);
                    let v518 = f32(bitcast<i32>(v517));
                    let v812 = abs(v512);
                    let v520 = (v812 < 8388608.0f);
                    let v521 = select(v512, v518, v520);
                    let v522 = (v506 - v521);
                    let v523 = (v522 * 0.00015469735f);
                    let v524 = (v523 + 0.0013390867f);
                    let v525 = (v522 * v524);
                    let v526 = (v525 + 0.009618031f);
                    let v527 = (v522 * v526);
                    let v528 = (v527 + 0.05550357f);
                    let v529 = (v522 * v528);
                    let v530 = (v529 + 0.2402265f);
                    let v531 = (v522 * v530);
                    let v532 = (v531 + 0.6931472f);
                    let v533 = (v522 * v532);
                    let v534 = (v533 + 1.0f);
                    let v813 = bitcast<u32>(i32(v521));
                    let v814 = (v521 > -2147483600.0f);
                    let v815 = select(2147483648u, v813, v814);
                    let v816 = (v521 >= 2147483600.0f);
                    let v817 = select(v815, 2147483647u, v816);
                    let v818 = bitcast<u32>(v521);
                    let v819 = (v818 & 2147483647u);
                    let v820 = (v819 > 2139095040u);
                    let v821 = select(v817, 0u, v820);
                    let v536 = bitcast<u32>(v534);
                    let v537 = (v821 << (23u & 31u));
                    let v538 = (v537 + v536);
                    let v539 = bitcast<f32>(v538);
                    p400 = v539;
                  } else {
                    p400 = 0.0f;
                  }
                } else {
                  p400 = bitcast<f32>(bits_7f800000);
                }
              } else {
                p400 = v506;
              }
              p504 = false;
            }
            let v504 = p504;
            if v504 {
              let v822 = u32(v22);
              let v823 = (v22 > 0.0f);
              let v824 = select(0u, v822, v823);
              let v825 = (v22 >= 4294967300.0f);
              let v826 = select(v824, 4294967295u, v825);
              let v551 = (v826 != 0u);
              if v551 {
                p553 = v21;
                p554 = v826;
                p555 = 1.0f;
                var done1 = false;
                loop {
                  if done1 { break; }
                  let v553 = p553;
                  let v554 = p554;
                  let v555 = p555;
                  let v556 = (v554 & 1u);
                  let v557 = (v556 != 0u);
                  let v827 = abs(v553);
                  if v557 {
                    let v559 = (v827 < 1.0842022e-19f);
                    let v560 = select(v553, 0.0f, v559);
                    let v561 = (v555 * v560);
                    let v828 = abs(v561);
                    let v563 = (v828 < 1.0842022e-19f);
                    let v564 = select(v561, 0.0f, v563);
                    p565 = v564;
                  } else {
                    p565 = v555;
                  }
                  let v565 = p565;
                  let v566 = (v554 >> (1u & 31u));
                  let v567 = (v827 < 1.0842022e-19f);
                  let v568 = select(v553, 0.0f, v567);
                  let v569 = (v568 * v568);
                  let v570 = (v566 == 0u);
                  p553 = v569;
                  p554 = v566;
                  p555 = v565;
                  p400 = v565;
                  done1 = v570;
                }
              } else {
                p400 = 1.0f;
              }
            }
            p401 = false;
          } else {
            p401 = true;
          }
          let v400 = p400;
          let v401 = p401;
          if v401 {
            let v829 = abs(v21);
            let v403 = bitcast<u32>(v829);
            let v404 = (v403 <= 8388607u);
            if v404 {
              let v830 = countLeadingZeros(v403);
              let v414 = (v830 + 4294967288u);
              let v415 = (v403 << (v414 & 31u));
              let v416 = (4294967155u - v830);
              let v417 = (v415 != 0u);
              p418 = v416;
              p419 = v415;
              p420 = v417;
              p408 = false;
            } else {
              p420 = false;
              p408 = true;
            }
            let v408 = p408;
            if v408 {
              let v409 = (v403 & 8388607u);
              let v410 = (v409 | 8388608u);
              let v411 = (v403 >> (23u & 31u));
              let v412 = (v411 + 4294967146u);
              p418 = v412;
              p419 = v410;
              p420 = true;
            }
            let v418 = p418;
            let v419 = p419;
            let v420 = p420;
            if v420 {
              let v421 = (v775 <= 2139095039u);
              if v421 {
                let v422 = (v419 > 11863283u);
                let v423 = select(0u, 4294967295u, v422);
                let v424 = select(0u, 1u, v422);
                let v425 = (v419 & 8388607u);
                let v426 = (v425 | 1065353216u);
                let v427 = (v423 << (23u & 31u));
                let v428 = (v426 + v427);
                let v429 = bitcast<f32>(v428);
                let v430 = (v429 + -1.0f);
                let v431 = (v429 + 1.0f);
                let v432 = (v430 / v431);
                let v433 = (v432 * v432);
                let v434 = (v418 + 23u);
                let v435 = (v434 + v424);
                let v436 = f32(bitcast<i32>(v435));
                let v437 = (v433 * 0.4317447f);
                let v438 = (v437 + 0.57671404f);
                let v439 = (v433 * v438);
                let v440 = (v439 + 0.96179885f);
                let v441 = (v433 * v440);
                let v442 = (v441 + 2.88539f);
                let v443 = (v432 * v442);
                let v444 = (v443 + v436);
                p79 = v444;
                p446 = false;
              } else {
                p446 = true;
              }
              let v446 = p446;
              if v446 {
                let v447 = (v775 == 2139095040u);
                let v448 = select(bitcast<f32>(bits_7fc00000), bitcast<f32>(bits_7f800000), v447);
                p79 = v448;
              }
            } else {
              p79 = bitcast<f32>(bits_ff800000);
            }
          } else {
            p79 = v400;
          }
        } else {
          p79 = v76;
        }
        p80 = true;
        p81 = false;
      } else {
        p80 = v27;
        p81 = true;
      }
      let v79 = p79;
      let v80 = p80;
      let v81 = p81;
      if v81 {
        let v82 = (bitcast<i32>(v774) >= bitcast<i32>(2u));
        if v82 {
          let v87 = (bitcast<i32>(v774) >= bitcast<i32>(3u));
          if v87 {
            let v88 = (bitcast<i32>(v774) >= bitcast<i32>(4u));
            if v88 {
              let v831 = abs(v21);
              let v368 = bitcast<u32>(v831);
              let v369 = (v368 <= 2139095040u);
              if v369 {
                let v370 = !(v21 >= 128.0f);
                if v370 {
                  let v371 = !(v21 < -126.0f);
                  if v371 {
                    let v372 = (v21 + 0.5f);
                    let v832 = bitcast<u32>(i32(v372));
                    let v833 = (v372 > -2147483600.0f);
                    let v834 = select(2147483648u, v832, v833);
                    let v835 = (v372 >= 2147483600.0f);
                    let v836 = select(v834, 2147483647u, v835);
                    let v837 = bitcast<u32>(v372);
                    let v838 = (v837 & 2147483647u);
                    let v839 = (v838 > 2139095040u);
                    let v840 = select(v836, 0u, v839);
                    let v374 = f32(bitcast<i32>(v840));
                    let v375 = (v372 < v374);
                    let v376 = select(0u, 4294967295u, v375);
                    let v377 = (v840 + v376);
                    let v378 = f32(bitcast<i32>(v377));
                    let v841 = abs(v372);
                    let v380 = (v841 < 8388608.0f);
                    let v381 = select(v372, v378, v380);
                    let v382 = (v21 - v381);
                    let v383 = (v382 * 0.00015469735f);
                    let v384 = (v383 + 0.0013390867f);
                    let v385 = (v382 * v384);
                    let v386 = (v385 + 0.009618031f);
                    let v387 = (v382 * v386);
                    let v388 = (v387 + 0.05550357f);
                    let v389 = (v382 * v388);
                    let v390 = (v389 + 0.2402265f);
                    let v391 = (v382 * v390);
                    let v392 = (v391 + 0.6931472f);
                    let v393 = (v382 * v392);
                    let v394 = (v393 + 1.0f);
                    let v842 = bitcast<u32>(i32(v381));
                    let v843 = (v381 > -2147483600.0f);
                    let v844 = select(2147483648u, v842, v843);
                    let v845 = (v381 >= 2147483600.0f);
                    let v846 = select(v844, 2147483647u, v845);
                    let v847 = bitcast<u32>(v381);
                    let v848 = (v847 & 2147483647u);
                    let v849 = (v848 > 2139095040u);
                    let v850 = select(v846, 0u, v849);
                    let v396 = bitcast<u32>(v394);
                    let v397 = (v850 << (23u & 31u));
                    let v398 = (v397 + v396);
                    let v399 = bitcast<f32>(v398);
                    p89 = v399;
                  } else {
                    p89 = 0.0f;
                  }
                } else {
                  p89 = bitcast<f32>(bits_7f800000);
                }
              } else {
                p89 = v21;
              }
              p248 = false;
            } else {
              p248 = true;
            }
            let v248 = p248;
            if v248 {
              let v851 = abs(v21);
              let v250 = bitcast<u32>(v851);
              let v252 = (bitcast<i32>(v775) >= bitcast<i32>(0u));
              if v252 {
                let v253 = (bitcast<i32>(v775) >= bitcast<i32>(2139095040u));
                if v253 {
                  let v256 = (v775 != 2139095040u);
                  p262 = v256;
                  p258 = false;
                } else {
                  p262 = false;
                  p258 = true;
                }
                let v258 = p258;
                if v258 {
                  let v259 = (v775 != 0u);
                  p262 = v259;
                }
                p255 = false;
              } else {
                p262 = false;
                p255 = true;
              }
              let v255 = p255;
              if v255 {
                let v261 = (v775 != 2147483648u);
                p262 = v261;
              }
              let v262 = p262;
              if v262 {
                let v263 = (v775 <= 2139095040u);
                if v263 {
                  let v264 = (v250 <= 8388607u);
                  if v264 {
                    let v852 = countLeadingZeros(v250);
                    let v266 = (v852 + 4294967288u);
                    let v267 = (v250 << (v266 & 31u));
                    let v268 = (4294967155u - v852);
                    p278 = v267;
                    p277 = v268;
                    p271 = false;
                  } else {
                    p271 = true;
                  }
                  let v271 = p271;
                  if v271 {
                    let v272 = (v250 & 8388607u);
                    let v273 = (v272 | 8388608u);
                    let v274 = (v250 >> (23u & 31u));
                    let v275 = (v274 + 4294967146u);
                    p277 = v275;
                    p278 = v273;
                  }
                  let v277 = p277;
                  let v278 = p278;
                  let v279 = (v277 & 1u);
                  let v280 = (v278 << (v279 & 31u));
                  let v281 = (v280 >= 16777216u);
                  let v282 = bitcast<u32>(bitcast<i32>(v277) >> (1u & 31u));
                  let v283 = f32(v280);
                  let v853 = sqrt(v283);
                  if v281 {
                    let v285 = (v282 + 139u);
                    let v286 = (v853 * 2048.0f);
                    let v854 = u32(v286);
                    let v855 = (v286 > 0.0f);
                    let v856 = select(0u, v854, v855);
                    let v857 = (v286 >= 4294967300.0f);
                    let v858 = select(v856, 4294967295u, v857);
                    let v288 = (v858 + 4294967272u);
                    let v289 = (v280 << (22u & 31u));
                    let v290 = (v288 * v288);
                    let v291 = (v289 - v290);
                    let v292 = f32(v291);
                    let v293 = f32(v288);
                    let v294 = (0.5f / v293);
                    let v295 = (v294 * v292);
                    let v859 = u32(v295);
                    let v860 = (v295 > 0.0f);
                    let v861 = select(0u, v859, v860);
                    let v862 = (v295 >= 4294967300.0f);
                    let v863 = select(v861, 4294967295u, v862);
                    let v297 = (v288 << (1u & 31u));
                    let v298 = (v863 + v297);
                    let v299 = (v298 * v863);
                    let v300 = (v291 - v299);
                    let v301 = (v863 + v288);
                    let v302 = (bitcast<i32>(v300) >= bitcast<i32>(0u));
                    if v302 {
                      let v303 = (v301 << (1u & 31u));
                      let v304 = (v300 > v303);
                      if v304 {
                        let v312 = (v301 + 1u);
                        let v313 = (v303 ^ 4294967295u);
                        let v314 = (v300 + v313);
                        p316 = v314;
                        p317 = v312;
                      } else {
                        p316 = v300;
                        p317 = v301;
                      }
                      p307 = false;
                    } else {
                      p307 = true;
                    }
                    let v307 = p307;
                    if v307 {
                      let v308 = (v301 + 4294967295u);
                      let v309 = (v301 << (1u & 31u));
                      let v310 = (v309 + 4294967295u);
                      let v311 = (v310 + v300);
                      p316 = v311;
                      p317 = v308;
                    }
                    p359 = v285;
                    p318 = false;
                  } else {
                    p318 = true;
                  }
                  let v316 = p316;
                  let v317 = p317;
                  let v318 = p318;
                  if v318 {
                    let v319 = (v282 + 138u);
                    let v320 = (v853 * 4096.0f);
                    let v864 = u32(v320);
                    let v865 = (v320 > 0.0f);
                    let v866 = select(0u, v864, v865);
                    let v867 = (v320 >= 4294967300.0f);
                    let v868 = select(v866, 4294967295u, v867);
                    let v322 = (v868 + 4294967272u);
                    let v323 = (v280 << (24u & 31u));
                    let v324 = (v322 * v322);
                    let v325 = (v323 - v324);
                    let v326 = f32(v325);
                    let v327 = f32(v322);
                    let v328 = (0.5f / v327);
                    let v329 = (v328 * v326);
                    let v869 = u32(v329);
                    let v870 = (v329 > 0.0f);
                    let v871 = select(0u, v869, v870);
                    let v872 = (v329 >= 4294967300.0f);
                    let v873 = select(v871, 4294967295u, v872);
                    let v331 = (v322 << (1u & 31u));
                    let v332 = (v873 + v331);
                    let v333 = (v332 * v873);
                    let v334 = (v325 - v333);
                    let v335 = (v873 + v322);
                    let v336 = (bitcast<i32>(v334) >= bitcast<i32>(0u));
                    if v336 {
                      let v337 = (v335 << (1u & 31u));
                      let v338 = (v334 > v337);
                      if v338 {
                        let v346 = (v335 + 1u);
                        let v347 = (v337 ^ 4294967295u);
                        let v348 = (v334 + v347);
                        p358 = v348;
                        p357 = v346;
                      } else {
                        p358 = v334;
                        p357 = v335;
                      }
                      p341 = false;
                    } else {
                      p341 = true;
                    }
                    let v341 = p341;
                    if v341 {
                      let v342 = (v335 + 4294967295u);
                      let v343 = (v335 << (1u & 31u));
                      let v344 = (v343 + 4294967295u);
                      let v345 = (v344 + v334);
                      p358 = v345;
                      p357 = v342;
                    }
                    p359 = v319;
                  } else {
                    p357 = v317;
                    p358 = v316;
                  }
                  let v357 = p357;
                  let v358 = p358;
                  let v359 = p359;
                  let v360 = (v358 > v357);
                  let v361 = select(0u, 1u, v360);
                  let v362 = (v359 << (23u & 31u));
                  let v363 = (v357 + 4286578688u);
                  let v364 = (v363 + v362);
                  let v365 = (v364 + v361);
                  let v366 = bitcast<f32>(v365);
                  p89 = v366;
                } else {
                  p89 = bitcast<f32>(bits_7fc00000);
                }
              } else {
                p89 = v21;
              }
            }
            p111 = false;
          } else {
            p111 = true;
          }
          let v111 = p111;
          if v111 {
            let v112 = (v776 ^ v775);
            let v113 = (v112 & 2147483648u);
            let v874 = abs(v21);
            let v115 = bitcast<u32>(v874);
            let v875 = abs(v22);
            let v117 = bitcast<u32>(v875);
            let v118 = (v115 > 2139095040u);
            let v119 = (v117 > 2139095040u);
            let v120 = (v118 | v119);
            let v121 = (v120 != true);
            if v121 {
              let v122 = (v115 != v117);
              if v122 {
                let v123 = (v115 == 0u);
                let v124 = (v117 == 2139095040u);
                let v125 = (v123 | v124);
                let v126 = (v125 != true);
                if v126 {
                  let v136 = (v117 == 0u);
                  let v137 = (v115 == 2139095040u);
                  let v138 = (v137 | v136);
                  if v138 {
                    let v141 = (v113 | 2139095040u);
                    p245 = v141;
                    p134 = false;
                  } else {
                    p134 = true;
                  }
                } else {
                  p245 = v113;
                  p134 = false;
                }
                p135 = false;
              } else {
                p134 = false;
                p135 = true;
              }
              let v134 = p134;
              let v135 = p135;
              if v135 {
                let v131 = (bitcast<i32>(v115) < bitcast<i32>(2139095040u));
                if v131 {
                  let v132 = (v115 != 0u);
                  p130 = v132;
                } else {
                  p130 = v134;
                }
                p245 = 2143289344u;
              } else {
                p130 = v134;
              }
              let v130 = p130;
              if v130 {
                let v143 = (v115 <= 8388607u);
                if v143 {
                  let v876 = countLeadingZeros(v115);
                  let v145 = (v876 + 4294967288u);
                  let v146 = (v115 << (v145 & 31u));
                  let v147 = (4294967155u - v876);
                  p157 = v146;
                  p156 = v147;
                  p150 = false;
                } else {
                  p150 = true;
                }
                let v150 = p150;
                if v150 {
                  let v151 = (v115 & 8388607u);
                  let v152 = (v151 | 8388608u);
                  let v153 = (v115 >> (23u & 31u));
                  let v154 = (v153 + 4294967146u);
                  p156 = v154;
                  p157 = v152;
                }
                let v156 = p156;
                let v157 = p157;
                let v158 = (v117 <= 8388607u);
                if v158 {
                  let v877 = countLeadingZeros(v117);
                  let v160 = (v877 + 4294967288u);
                  let v161 = (v117 << (v160 & 31u));
                  let v162 = (v877 + 141u);
                  p171 = v161;
                  p170 = v162;
                  p165 = false;
                } else {
                  p165 = true;
                }
                let v165 = p165;
                if v165 {
                  let v166 = (v117 & 8388607u);
                  let v167 = (v166 | 8388608u);
                  let v168 = (v117 >> (23u & 31u));
                  let v169 = (150u - v168);
                  p170 = v169;
                  p171 = v167;
                }
                let v170 = p170;
                let v171 = p171;
                let v172 = (v157 < v171);
                let v173 = select(0u, 4294967295u, v172);
                let v174 = select(0u, 1u, v172);
                let v175 = (v156 + 4294967273u);
                let v176 = (v175 + v170);
                let v177 = (v176 + v173);
                let v178 = (v157 << (v174 & 31u));
                let v179 = f32(v171);
                let v180 = (1.0f / v179);
                let v181 = f32(v178);
                let v182 = (v180 * v181);
                let v183 = (v182 * 8388608.0f);
                let v878 = u32(v183);
                let v879 = (v183 > 0.0f);
                let v880 = select(0u, v878, v879);
                let v881 = (v183 >= 4294967300.0f);
                let v882 = select(v880, 4294967295u, v881);
                let v185 = (v882 + 4294967264u);
                let v186 = (v178 << (23u & 31u));
                let v187 = (v185 * v171);
                let v188 = (v186 - v187);
                let v189 = f32(v188);
                let v190 = (v180 * v189);
                let v883 = u32(v190);
                let v884 = (v190 > 0.0f);
                let v885 = select(0u, v883, v884);
                let v886 = (v190 >= 4294967300.0f);
                let v887 = select(v885, 4294967295u, v886);
                let v192 = (v887 + v185);
                let v193 = (v887 * v171);
                let v194 = (v188 - v193);
                let v195 = (bitcast<i32>(v194) >= bitcast<i32>(v171));
                if v195 {
                  let v200 = (v192 + 1u);
                  let v201 = (v194 - v171);
                  p207 = v200;
                  p206 = v201;
                  p198 = false;
                } else {
                  p198 = true;
                }
                let v198 = p198;
                if v198 {
                  let v199 = (bitcast<i32>(v194) < bitcast<i32>(0u));
                  if v199 {
                    let v202 = (v192 + 4294967295u);
                    let v203 = (v194 + v171);
                    p207 = v202;
                    p206 = v203;
                  } else {
                    p207 = v192;
                    p206 = v194;
                  }
                }
                let v206 = p206;
                let v207 = p207;
                let v208 = (v206 << (1u & 31u));
                let v209 = (bitcast<i32>(v177) <= bitcast<i32>(4294967146u));
                if v209 {
                  let v210 = (v177 >= 4294967122u);
                  if v210 {
                    let v226 = (4294967147u - v177);
                    let v227 = (v207 >> (v226 & 31u));
                    let v228 = (4294967295u << (v226 & 31u));
                    let v229 = (v228 ^ 4294967295u);
                    let v230 = (v207 & v229);
                    let v231 = (4294967146u - v177);
                    let v232 = (1u << (v231 & 31u));
                    let v233 = (v230 <= v232);
                    if v233 {
                      let v234 = (v230 == v232);
                      if v234 {
                        let v235 = (v208 == 0u);
                        let v236 = (v227 & 1u);
                        let v237 = select(1u, v236, v235);
                        p240 = v237;
                      } else {
                        p240 = 0u;
                      }
                    } else {
                      p240 = 1u;
                    }
                    let v240 = p240;
                    let v241 = (v240 + v227);
                    p242 = v241;
                  } else {
                    p242 = 0u;
                  }
                  p212 = false;
                } else {
                  p212 = true;
                }
                let v212 = p212;
                if v212 {
                  let v213 = (v208 > v171);
                  let v214 = (v208 == v171);
                  let v215 = (v207 & 1u);
                  let v216 = select(0u, v215, v214);
                  let v217 = select(v216, 1u, v213);
                  let v218 = (v177 << (23u & 31u));
                  let v219 = (v218 + 1249902592u);
                  let v220 = (v219 + v207);
                  let v221 = (v220 + v217);
                  let v222 = (bitcast<i32>(v177) > bitcast<i32>(104u));
                  let v223 = (v221 > 2139095039u);
                  let v224 = (v222 | v223);
                  let v225 = select(v221, 2139095040u, v224);
                  p242 = v225;
                }
                let v242 = p242;
                let v243 = (v242 | v113);
                p245 = v243;
              }
            } else {
              p245 = 2143289344u;
            }
            let v245 = p245;
            let v246 = bitcast<f32>(v245);
            p89 = v246;
          }
          p90 = true;
          p91 = false;
        } else {
          p90 = v80;
          p91 = true;
        }
        let v89 = p89;
        let v90 = p90;
        let v91 = p91;
        if v91 {
          let v92 = (bitcast<i32>(v774) >= bitcast<i32>(1u));
          if v92 {
            let v888 = sqrt(v21);
            p759 = v888;
            p760 = true;
            p95 = false;
          } else {
            p760 = v90;
            p95 = true;
          }
          let v95 = p95;
          if v95 {
            let v96 = (v774 != 0u);
            p103 = true;
            p72 = v96;
          } else {
            p103 = false;
            p72 = v28;
          }
        } else {
          p759 = v89;
          p760 = v90;
          p103 = false;
          p72 = v28;
        }
      } else {
        p759 = v79;
        p760 = v80;
        p103 = false;
        p72 = v28;
      }
    } else {
      p759 = v25;
      p760 = v27;
      p103 = false;
      p72 = v28;
    }
    let v72 = p72;
    if v72 {
      let v99 = -(v22);
      let v889 = fma(v21, v21, v99);
      p759 = v889;
      p760 = true;
      p103 = false;
    }
    let v103 = p103;
    if v103 {
      let v104 = (v21 / v22);
      p759 = v104;
      p760 = true;
    }
    let v759 = p759;
    let v760 = p760;
    if v760 {
      let v761 = bitcast<u32>(v759);
      p762 = v761;
    }
    let v762 = p762;
    r2[v768] = v762;
  }
  return;
}
