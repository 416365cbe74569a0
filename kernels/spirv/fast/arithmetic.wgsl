@group(0) @binding(0) var<storage, read> r0: array<u32>;
@group(0) @binding(1) var<storage, read> r1: array<u32>;
@group(0) @binding(2) var<storage, read_write> r2: array<u32>;
@id(0) override spec0: u32 = 0u;
var<private> bits_7f800000: u32 = 2139095040u;
var<private> bits_7fc00000: u32 = 2143289344u;
var<private> bits_ff800000: u32 = 4286578688u;
@compute @workgroup_size(64, 1, 1)
fn arithmetic(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
  var p712: bool;
  var p45: bool;
  var p40: bool;
  var p681: bool;
  var p31: f32;
  var p35: bool;
  var p634: bool;
  var p631: bool;
  var p54: f32;
  var p55: bool;
  var p626: bool;
  var p25: f32;
  var p27: bool;
  var p28: bool;
  var p29: bool;
  var p613: bool;
  var p563: bool;
  var p606: bool;
  var p610: u32;
  var p67: f32;
  var p68: bool;
  var p445: bool;
  var p452: bool;
  var p462: u32;
  var p463: u32;
  var p464: bool;
  var p490: bool;
  var p496: f32;
  var p495: bool;
  var p544: f32;
  var p545: u32;
  var p546: f32;
  var p556: f32;
  var p391: f32;
  var p392: bool;
  var p399: bool;
  var p409: u32;
  var p410: u32;
  var p411: bool;
  var p437: bool;
  var p70: f32;
  var p71: bool;
  var p72: bool;
  var p239: bool;
  var p249: bool;
  var p246: bool;
  var p253: bool;
  var p262: bool;
  var p268: u32;
  var p269: u32;
  var p298: bool;
  var p307: u32;
  var p308: u32;
  var p309: bool;
  var p332: bool;
  var p348: u32;
  var p349: u32;
  var p350: u32;
  var p102: bool;
  var p125: bool;
  var p126: bool;
  var p121: bool;
  var p141: bool;
  var p147: u32;
  var p148: u32;
  var p156: bool;
  var p161: u32;
  var p162: u32;
  var p189: bool;
  var p197: u32;
  var p198: u32;
  var p231: u32;
  var p203: bool;
  var p233: u32;
  var p236: u32;
  var p80: f32;
  var p81: bool;
  var p82: bool;
  var p86: bool;
  var p63: bool;
  var p94: bool;
  var p736: f32;
  var p737: bool;
  var p740: u32;
  let v746 = global_invocation_id[0u];
  let v751 = (arrayLength(&r2) * 1u);
  let v9 = (v751 & 1073741823u);
  let v752 = spec0;
  let v11 = (v746 < v9);
  if v11 {
    let v753 = r0[v746];
    let v754 = r1[v746];
    let v21 = bitcast<f32>(v753);
    let v22 = bitcast<f32>(v754);
    let v23 = (bitcast<i32>(v752) >= bitcast<i32>(10u));
    if v23 {
      let v24 = (bitcast<i32>(v752) >= bitcast<i32>(15u));
      if v24 {
        let v30 = (bitcast<i32>(v752) >= bitcast<i32>(17u));
        if v30 {
          let v36 = (bitcast<i32>(v752) >= bitcast<i32>(18u));
          if v36 {
            let v41 = (bitcast<i32>(v752) >= bitcast<i32>(19u));
            if v41 {
              let v46 = (v752 == 19u);
              if v46 {
                let v713 = (v21 * v21);
                let v714 = (v713 - v22);
                p31 = v714;
                p27 = true;
                p28 = false;
              } else {
                p27 = false;
                p28 = true;
              }
              p712 = false;
            } else {
              p27 = false;
              p28 = false;
              p712 = true;
            }
            let v712 = p712;
            if v712 {
              let v755 = sqrt(v21);
              p31 = v755;
              p27 = true;
            }
            p45 = false;
          } else {
            p27 = false;
            p28 = false;
            p45 = true;
          }
          let v45 = p45;
          if v45 {
            let v704 = (v21 / v22);
            p31 = v704;
            p27 = true;
          }
          p40 = false;
        } else {
          p27 = false;
          p28 = false;
          p40 = true;
        }
        let v40 = p40;
        if v40 {
          let v49 = (bitcast<i32>(v752) >= bitcast<i32>(16u));
          if v49 {
            let v699 = (v754 << (14u & 31u));
            let v700 = (v699 - v753);
            let v701 = (v700 + 16383u);
            p740 = v701;
            p681 = false;
          } else {
            p681 = true;
          }
          let v681 = p681;
          if v681 {
            let v682 = (v22 == bitcast<f32>(bits_7f800000));
            let v683 = (v22 + -1.0f);
            let v684 = (v683 / v22);
            let v685 = (v684 * v21);
            let v686 = select(v685, v21, v682);
            let v687 = (v686 > -1048576.0f);
            let v688 = select(-1048576.0f, v686, v687);
            let v689 = (v688 < 1048576.0f);
            let v690 = select(1048576.0f, v688, v689);
            let v691 = (v690 + 12582912.0f);
            let v692 = bitcast<u32>(v691);
            let v693 = (v692 + 3032481792u);
            let v694 = f32(bitcast<i32>(v693));
            let v695 = (v690 - v694);
            let v696 = (v695 >= 0.5f);
            let v697 = select(0u, 1u, v696);
            let v698 = (v693 + v697);
            p740 = v698;
          }
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
        let v51 = (bitcast<i32>(v752) >= bitcast<i32>(12u));
        if v51 {
          let v52 = (bitcast<i32>(v752) >= bitcast<i32>(13u));
          if v52 {
            let v53 = (bitcast<i32>(v752) >= bitcast<i32>(14u));
            if v53 {
              let v652 = (v21 * v21);
              let v653 = (1.0f - v652);
              let v654 = (v653 > 0.0f);
              let v655 = select(0.0f, v653, v654);
              let v656 = (v22 * v22);
              let v657 = (v655 / v656);
              let v658 = (1.0f - v657);
              let v659 = (v658 > 0.0f);
              if v659 {
                let v756 = sqrt(v658);
                let v661 = (v21 * v22);
                let v662 = (v661 + v756);
                let v663 = (v756 * v22);
                let v664 = (v663 + v21);
                let v665 = (v662 <= 0.0f);
                let v666 = (v664 <= 0.0f);
                let v667 = (v665 | v666);
                let v668 = (v667 != true);
                if v668 {
                  let v669 = (v661 - v756);
                  let v670 = (v669 / v662);
                  let v671 = (v21 - v663);
                  let v672 = (v671 / v664);
                  let v673 = (v670 * v670);
                  let v674 = (v672 * v672);
                  let v675 = (v673 + v674);
                  let v676 = (v675 * 0.5f);
                  let v677 = (v676 > 0.0f);
                  let v678 = select(0.0f, v676, v677);
                  let v679 = !(v678 < 1.0f);
                  if v679 {
                    p54 = 1.0f;
                  } else {
                    p54 = v678;
                  }
                } else {
                  p54 = 1.0f;
                }
              } else {
                p54 = 1.0f;
              }
              p634 = false;
            } else {
              p634 = true;
            }
            let v634 = p634;
            if v634 {
              let v635 = (v21 * v22);
              let v636 = (v21 * 4097.0f);
              let v637 = (v636 - v21);
              let v638 = (v636 - v637);
              let v639 = (v21 - v638);
              let v640 = (v22 * 4097.0f);
              let v641 = (v640 - v22);
              let v642 = (v640 - v641);
              let v643 = (v22 - v642);
              let v644 = (v638 * v642);
              let v645 = (v644 - v635);
              let v646 = (v638 * v643);
              let v647 = (v645 + v646);
              let v648 = (v639 * v642);
              let v649 = (v648 + v647);
              let v650 = (v639 * v643);
              let v651 = (v650 + v649);
              p54 = v651;
            }
            p631 = false;
          } else {
            p631 = true;
          }
          let v631 = p631;
          if v631 {
            let v632 = (v21 * v22);
            p54 = v632;
          }
          p55 = false;
        } else {
          p55 = true;
        }
        let v54 = p54;
        let v55 = p55;
        if v55 {
          let v56 = (bitcast<i32>(v752) >= bitcast<i32>(11u));
          if v56 {
            let v629 = (v21 + v22);
            p25 = v629;
            p626 = false;
          } else {
            p626 = true;
          }
          let v626 = p626;
          if v626 {
            let v627 = (v21 > v22);
            let v628 = select(v22, v21, v627);
            p25 = v628;
          }
        } else {
          p25 = v54;
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
      let v59 = (bitcast<i32>(v752) >= bitcast<i32>(5u));
      if v59 {
        let v64 = (bitcast<i32>(v752) >= bitcast<i32>(7u));
        if v64 {
          let v65 = (bitcast<i32>(v752) >= bitcast<i32>(8u));
          if v65 {
            let v66 = (bitcast<i32>(v752) >= bitcast<i32>(9u));
            if v66 {
              let v623 = (v21 < v22);
              let v624 = select(v22, v21, v623);
              p67 = v624;
              p613 = false;
            } else {
              p613 = true;
            }
            let v613 = p613;
            if v613 {
              let v757 = bitcast<u32>(i32(v21));
              let v758 = (v21 > -2147483600.0f);
              let v759 = select(2147483648u, v757, v758);
              let v760 = (v21 >= 2147483600.0f);
              let v761 = select(v759, 2147483647u, v760);
              let v762 = (v753 & 2147483647u);
              let v763 = (v762 > 2139095040u);
              let v764 = select(v761, 0u, v763);
              let v615 = f32(bitcast<i32>(v764));
              let v616 = (v615 > v21);
              let v617 = select(0u, 4294967295u, v616);
              let v618 = (v764 + v617);
              let v619 = f32(bitcast<i32>(v618));
              let v621 = bitcast<f32>(v762);
              let v622 = !(v621 < 8388608.0f);
              if v622 {
                p67 = v21;
              } else {
                p67 = v619;
              }
            }
            p563 = false;
          } else {
            p563 = true;
          }
          let v563 = p563;
          if v563 {
            let v564 = (v21 + v22);
            let v765 = abs(v564);
            let v566 = bitcast<u32>(v765);
            let v567 = (v566 <= 2139095040u);
            if v567 {
              let v766 = abs(v22);
              let v767 = abs(v21);
              let v570 = (v766 > v767);
              let v571 = select(v767, v766, v570);
              let v572 = !(v571 == 0.0f);
              if v572 {
                let v573 = (v766 < v767);
                let v574 = select(v767, v766, v573);
                let v575 = (v574 / v571);
                let v576 = (v575 < 7.888609e-31f);
                let v577 = select(v575, 0.0f, v576);
                let v578 = (v577 * v577);
                let v579 = (v578 * 0.0028498895f);
                let v580 = (v579 + -0.016068604f);
                let v581 = (v578 * v580);
                let v582 = (v581 + 0.04269143f);
                let v583 = (v578 * v582);
                let v584 = (v583 + -0.07504282f);
                let v585 = (v578 * v584);
                let v586 = (v585 + 0.10640925f);
                let v587 = (v578 * v586);
                let v588 = (v587 + -0.14203641f);
                let v589 = (v578 * v588);
                let v590 = (v589 + 0.19992618f);
                let v591 = (v578 * v590);
                let v592 = (v591 + -0.33333072f);
                let v593 = (v578 * v592);
                let v594 = (v593 + 1.0f);
                let v595 = (v577 * v594);
                let v596 = (1.5707964f - v595);
                let v597 = select(v595, v596, v573);
                let v598 = (v22 < 0.0f);
                let v599 = (3.1415927f - v597);
                let v600 = select(v597, v599, v598);
                let v768 = abs(v600);
                let v602 = bitcast<u32>(v768);
                let v603 = (v753 & 2147483648u);
                let v604 = (v603 | v602);
                p610 = v604;
                p606 = false;
              } else {
                p606 = true;
              }
              let v606 = p606;
              if v606 {
                let v607 = (v753 & 2147483648u);
                p610 = v607;
              }
            } else {
              p610 = 2143289344u;
            }
            let v610 = p610;
            let v611 = bitcast<f32>(v610);
            p67 = v611;
          }
          p68 = false;
        } else {
          p68 = true;
        }
        let v67 = p67;
        let v68 = p68;
        if v68 {
          let v69 = (bitcast<i32>(v752) >= bitcast<i32>(6u));
          if v69 {
            let v440 = (v22 >= 0.0f);
            let v441 = (v22 <= 65536.0f);
            let v442 = (v440 & v441);
            let v443 = (v442 != true);
            if v442 {
              let v769 = bitcast<u32>(i32(v22));
              let v770 = (v22 > -2147483600.0f);
              let v771 = select(2147483648u, v769, v770);
              let v772 = (v22 >= 2147483600.0f);
              let v773 = select(v771, 2147483647u, v772);
              let v774 = (v754 & 2147483647u);
              let v775 = (v774 > 2139095040u);
              let v776 = select(v773, 0u, v775);
              let v532 = f32(bitcast<i32>(v776));
              let v533 = (v22 < v532);
              let v534 = select(0u, 4294967295u, v533);
              let v535 = (v776 + v534);
              let v536 = f32(bitcast<i32>(v535));
              let v777 = abs(v22);
              let v538 = (v777 < 8388608.0f);
              let v539 = select(v22, v536, v538);
              let v540 = !(v539 == v22);
              p495 = true;
              p445 = v540;
            } else {
              p495 = false;
              p445 = v443;
            }
            let v445 = p445;
            if v445 {
              let v778 = abs(v21);
              let v447 = bitcast<u32>(v778);
              let v448 = (v447 <= 8388607u);
              if v448 {
                let v779 = countLeadingZeros(v447);
                let v458 = (v779 + 4294967288u);
                let v459 = (v447 << (v458 & 31u));
                let v460 = (4294967155u - v779);
                let v461 = (v459 != 0u);
                p462 = v460;
                p463 = v459;
                p464 = v461;
                p452 = false;
              } else {
                p464 = false;
                p452 = true;
              }
              let v452 = p452;
              if v452 {
                let v453 = (v447 & 8388607u);
                let v454 = (v453 | 8388608u);
                let v455 = (v447 >> (23u & 31u));
                let v456 = (v455 + 4294967146u);
                p462 = v456;
                p463 = v454;
                p464 = true;
              }
              let v462 = p462;
              let v463 = p463;
              let v464 = p464;
              if v464 {
                let v465 = (v753 <= 2139095039u);
                if v465 {
                  let v466 = (v463 > 11863283u);
                  let v467 = select(0u, 4294967295u, v466);
                  let v468 = select(0u, 1u, v466);
                  let v469 = (v463 & 8388607u);
                  let v470 = (v469 | 1065353216u);
                  let v471 = (v467 << (23u & 31u));
                  let v472 = (v470 + v471);
                  let v473 = bitcast<f32>(v472);
                  let v474 = (v473 + -1.0f);
                  let v475 = (v473 + 1.0f);
                  let v476 = (v474 / v475);
                  let v477 = (v476 * v476);
                  let v478 = (v462 + 23u);
                  let v479 = (v478 + v468);
                  let v480 = f32(bitcast<i32>(v479));
                  let v481 = (v477 * 0.4317447f);
                  let v482 = (v481 + 0.57671404f);
                  let v483 = (v477 * v482);
                  let v484 = (v483 + 0.96179885f);
                  let v485 = (v477 * v484);
                  let v486 = (v485 + 2.88539f);
                  let v487 = (v476 * v486);
                  let v488 = (v487 + v480);
                  p496 = v488;
                  p490 = false;
                } else {
                  p490 = true;
                }
                let v490 = p490;
                if v490 {
                  let v491 = (v753 == 2139095040u);
                  let v492 = select(bitcast<f32>(bits_7fc00000), bitcast<f32>(bits_7f800000), v491);
                  p496 = v492;
                }
              } else {
                p496 = bitcast<f32>(bits_ff800000);
              }
              let v496 = p496;
              let v497 = (v496 * v22);
              let v780 = abs(v497);
              let v499 = bitcast<u32>(v780);
              let v500 = (v499 <= 2139095040u);
              if v500 {
                let v501 = !(v497 >= 128.0f);
                if v501 {
                  let v502 = !(v497 < -126.0f);
                  if v502 {
                    let v503 = (v497 + 0.5f);
                    let v781 = bitcast<u32>(i32(v503));
                    let v782 = (v503 > -2147483600.0f);
                    let v783 = select(2147483648u, v781, v782);
                    let v784 = (v503 >= 2147483600.0f);
                    let v785 = select(v783, 2147483647u, v784);
                    let v786 = bitcast<u32>(v503);
                    let v787 = (v786 & 2147483647u);
                    let v788 = (v787 > 2139095040u);
                    let v789 = select(v785, 0u, v788);
                    let v505 = f32(bitcast<i32>(v789));
                    let v506 = (v503 < v505);
                    let v507 = select(0u, 4294967295u, v506);
                    let v508 = (v789 + v507);
                    let v509 = f32(bitcast<i32>(v508));
                    let v790 = abs(v503);
                    let v511 = (v790 < 8388608.0f);
                    let v512 = select(v503, v509, v511);
                    let v513 = (v497 - v512);
                    let v514 = (v513 * 0.00015469735f);
                    let v515 = (v514 + 0.0013390867f);
                    let v516 = (v513 * v515);
                    let v517 = (v516 + 0.009618031f);
                    let v518 = (v513 * v517);
                    let v519 = (v518 + 0.05550357f);
                    let v520 = (v513 * v519);
                    let v521 = (v520 + 0.2402265f);
                    let v522 = (v513 * v521);
                    let v523 = (v522 + 0.6931472f);
                    let v524 = (v513 * v523);
                    let v525 = (v524 + 1.0f);
                    let v791 = bitcast<u32>(i32(v512));
                    let v792 = (v512 > -2147483600.0f);
                    let v793 = select(2147483648u, v791, v792);
                    let v794 = (v512 >= 2147483600.0f);
                    let v795 = select(v793, 2147483647u, v794);
                    let v796 = bitcast<u32>(v512);
                    let v797 = (v796 & 2147483647u);
                    let v798 = (v797 > 2139095040u);
                    let v799 = select(v795, 0u, v798);
                    let v527 = bitcast<u32>(v525);
                    let v528 = (v799 << (23u & 31u));
                    let v529 = (v528 + v527);
                    let v530 = bitcast<f32>(v529);
                    p391 = v530;
                  } else {
                    p391 = 0.0f;
                  }
                } else {
                  p391 = bitcast<f32>(bits_7f800000);
                }
              } else {
                p391 = v497;
              }
              p495 = false;
            }
            let v495 = p495;
            if v495 {
              let v800 = u32(v22);
              let v801 = (v22 > 0.0f);
              let v802 = select(0u, v800, v801);
              let v803 = (v22 >= 4294967300.0f);
              let v804 = select(v802, 4294967295u, v803);
              let v542 = (v804 != 0u);
              if v542 {
                p544 = v21;
                p545 = v804;
                p546 = 1.0f;
                var done0 = false;
                loop {
                  if done0 { break; }
                  let v544 = p544;
                  let v545 = p545;
                  let v546 = p546;
                  let v547 = (v545 & 1u);
                  let v548 = (v547 != 0u);
                  let v805 = abs(v544);
                  if v548 {
                    let v550 = (v805 < 1.0842022e-19f);
                    let v551 = select(v544, 0.0f, v550);
                    let v552 = (v546 * v551);
                    let v806 = abs(v552);
                    let v554 = (v806 < 1.0842022e-19f);
                    let v555 = select(v552, 0.0f, v554);
                    p556 = v555;
                  } else {
                    p556 = v546;
                  }
                  let v556 = p556;
                  let v557 = (v545 >> (1u & 31u));
                  let v558 = (v805 < 1.0842022e-19f);
                  let v559 = select(v544, 0.0f, v558);
                  let v560 = (v559 * v559);
                  let v561 = (v557 == 0u);
                  p544 = v560;
                  p545 = v557;
                  p546 = v556;
                  p391 = v556;
                  done0 = v561;
                }
              } else {
                p391 = 1.0f;
              }
            }
            p392 = false;
          } else {
            p392 = true;
          }
          let v391 = p391;
          let v392 = p392;
          if v392 {
            let v807 = abs(v21);
            let v394 = bitcast<u32>(v807);
            let v395 = (v394 <= 8388607u);
            if v395 {
              let v808 = countLeadingZeros(v394);
              let v405 = (v808 + 4294967288u);
              let v406 = (v394 << (v405 & 31u));
              let v407 = (4294967155u - v808);
              let v408 = (v406 != 0u);
              p409 = v407;
              p410 = v406;
              p411 = v408;
              p399 = false;
            } else {
              p411 = false;
              p399 = true;
            }
            let v399 = p399;
            if v399 {
              let v400 = (v394 & 8388607u);
              let v401 = (v400 | 8388608u);
              let v402 = (v394 >> (23u & 31u));
              let v403 = (v402 + 4294967146u);
              p409 = v403;
              p410 = v401;
              p411 = true;
            }
            let v409 = p409;
            let v410 = p410;
            let v411 = p411;
            if v411 {
              let v412 = (v753 <= 2139095039u);
              if v412 {
                let v413 = (v410 > 11863283u);
                let v414 = select(0u, 4294967295u, v413);
                let v415 = select(0u, 1u, v413);
                let v416 = (v410 & 8388607u);
                let v417 = (v416 | 1065353216u);
                let v418 = (v414 << (23u & 31u));
                let v419 = (v417 + v418);
                let v420 = bitcast<f32>(v419);
                let v421 = (v420 + -1.0f);
                let v422 = (v420 + 1.0f);
                let v423 = (v421 / v422);
                let v424 = (v423 * v423);
                let v425 = (v409 + 23u);
                let v426 = (v425 + v415);
                let v427 = f32(bitcast<i32>(v426));
                let v428 = (v424 * 0.4317447f);
                let v429 = (v428 + 0.57671404f);
                let v430 = (v424 * v429);
                let v431 = (v430 + 0.96179885f);
                let v432 = (v424 * v431);
                let v433 = (v432 + 2.88539f);
                let v434 = (v423 * v433);
                let v435 = (v434 + v427);
                p70 = v435;
                p437 = false;
              } else {
                p437 = true;
              }
              let v437 = p437;
              if v437 {
                let v438 = (v753 == 2139095040u);
                let v439 = select(bitcast<f32>(bits_7fc00000), bitcast<f32>(bits_7f800000), v438);
                p70 = v439;
              }
            } else {
              p70 = bitcast<f32>(bits_ff800000);
            }
          } else {
            p70 = v391;
          }
        } else {
          p70 = v67;
        }
        p71 = true;
        p72 = false;
      } else {
        p71 = v27;
        p72 = true;
      }
      let v70 = p70;
      let v71 = p71;
      let v72 = p72;
      if v72 {
        let v73 = (bitcast<i32>(v752) >= bitcast<i32>(2u));
        if v73 {
          let v78 = (bitcast<i32>(v752) >= bitcast<i32>(3u));
          if v78 {
            let v79 = (bitcast<i32>(v752) >= bitcast<i32>(4u));
            if v79 {
              let v809 = abs(v21);
              let v359 = bitcast<u32>(v809);
              let v360 = (v359 <= 2139095040u);
              if v360 {
                let v361 = !(v21 >= 128.0f);
                if v361 {
                  let v362 = !(v21 < -126.0f);
                  if v362 {
                    let v363 = (v21 + 0.5f);
                    let v810 = bitcast<u32>(i32(v363));
                    let v811 = (v363 > -2147483600.0f);
                    let v812 = select(2147483648u, v810, v811);
                    let v813 = (v363 >= 2147483600.0f);
                    let v814 = select(v812, 2147483647u, v813);
                    let v815 = bitcast<u32>(v363);
                    let v816 = (v815 & 2147483647u);
                    let v817 = (v816 > 2139095040u);
                    let v818 = select(v814, 0u, v817);
                    let v365 = f32(bitcast<i32>(v818));
                    let v366 = (v363 < v365);
                    let v367 = select(0u, 4294967295u, v366);
                    let v368 = (v818 + v367);
                    let v369 = f32(bitcast<i32>(v368));
                    let v819 = abs(v363);
                    let v371 = (v819 < 8388608.0f);
                    let v372 = select(v363, v369, v371);
                    let v373 = (v21 - v372);
                    let v374 = (v373 * 0.00015469735f);
                    let v375 = (v374 + 0.0013390867f);
                    let v376 = (v373 * v375);
                    let v377 = (v376 + 0.009618031f);
                    let v378 = (v373 * v377);
                    let v379 = (v378 + 0.05550357f);
                    let v380 = (v373 * v379);
                    let v381 = (v380 + 0.2402265f);
                    let v382 = (v373 * v381);
                    let v383 = (v382 + 0.6931472f);
                    let v384 = (v373 * v383);
                    let v385 = (v384 + 1.0f);
                    let v820 = bitcast<u32>(i32(v372));
                    let v821 = (v372 > -2147483600.0f);
                    let v822 = select(2147483648u, v820, v821);
                    let v823 = (v372 >= 2147483600.0f);
                    let v824 = select(v822, 2147483647u, v823);
                    let v825 = bitcast<u32>(v372);
                    let v826 = (v825 & 2147483647u);
                    let v827 = (v826 > 2139095040u);
                    let v828 = select(v824, 0u, v827);
                    let v387 = bitcast<u32>(v385);
                    let v388 = (v828 << (23u & 31u));
                    let v389 = (v388 + v387);
                    let v390 = bitcast<f32>(v389);
                    p80 = v390;
                  } else {
                    p80 = 0.0f;
                  }
                } else {
                  p80 = bitcast<f32>(bits_7f800000);
                }
              } else {
                p80 = v21;
              }
              p239 = false;
            } else {
              p239 = true;
            }
            let v239 = p239;
            if v239 {
              let v829 = abs(v21);
              let v241 = bitcast<u32>(v829);
              let v243 = (bitcast<i32>(v753) >= bitcast<i32>(0u));
              if v243 {
                let v244 = (bitcast<i32>(v753) >= bitcast<i32>(2139095040u));
                if v244 {
                  let v247 = (v753 != 2139095040u);
                  p253 = v247;
                  p249 = false;
                } else {
                  p253 = false;
                  p249 = true;
                }
                let v249 = p249;
                if v249 {
                  let v250 = (v753 != 0u);
                  p253 = v250;
                }
                p246 = false;
              } else {
                p253 = false;
                p246 = true;
              }
              let v246 = p246;
              if v246 {
                let v252 = (v753 != 2147483648u);
                p253 = v252;
              }
              let v253 = p253;
              if v253 {
                let v254 = (v753 <= 2139095040u);
                if v254 {
                  let v255 = (v241 <= 8388607u);
                  if v255 {
                    let v830 = countLeadingZeros(v241);
                    let v257 = (v830 + 4294967288u);
                    let v258 = (v241 << (v257 & 31u));
                    let v259 = (4294967155u - v830);
                    p269 = v258;
                    p268 = v259;
                    p262 = false;
                  } else {
                    p262 = true;
                  }
                  let v262 = p262;
                  if v262 {
                    let v263 = (v241 & 8388607u);
                    let v264 = (v263 | 8388608u);
                    let v265 = (v241 >> (23u & 31u));
                    let v266 = (v265 + 4294967146u);
                    p268 = v266;
                    p269 = v264;
                  }
                  let v268 = p268;
                  let v269 = p269;
                  let v270 = (v268 & 1u);
                  let v271 = (v269 << (v270 & 31u));
                  let v272 = (v271 >= 16777216u);
                  let v273 = bitcast<u32>(bitcast<i32>(v268) >> (1u & 31u));
                  let v274 = f32(v271);
                  let v831 = sqrt(v274);
                  if v272 {
                    let v276 = (v273 + 139u);
                    let v277 = (v831 * 2048.0f);
                    let v832 = u32(v277);
                    let v833 = (v277 > 0.0f);
                    let v834 = select(0u, v832, v833);
                    let v835 = (v277 >= 4294967300.0f);
                    let v836 = select(v834, 4294967295u, v835);
                    let v279 = (v836 + 4294967272u);
                    let v280 = (v271 << (22u & 31u));
                    let v281 = (v279 * v279);
                    let v282 = (v280 - v281);
                    let v283 = f32(v282);
                    let v284 = f32(v279);
                    let v285 = (0.5f / v284);
                    let v286 = (v285 * v283);
                    let v837 = u32(v286);
                    let v838 = (v286 > 0.0f);
                    let v839 = select(0u, v837, v838);
                    let v840 = (v286 >= 4294967300.0f);
                    let v841 = select(v839, 4294967295u, v840);
                    let v288 = (v279 << (1u & 31u));
                    let v289 = (v841 + v288);
                    let v290 = (v289 * v841);
                    let v291 = (v282 - v290);
                    let v292 = (v841 + v279);
                    let v293 = (bitcast<i32>(v291) >= bitcast<i32>(0u));
                    if v293 {
                      let v294 = (v292 << (1u & 31u));
                      let v295 = (v291 > v294);
                      if v295 {
                        let v303 = (v292 + 1u);
                        let v304 = (v294 ^ 4294967295u);
                        let v305 = (v291 + v304);
                        p307 = v305;
                        p308 = v303;
                      } else {
                        p307 = v291;
                        p308 = v292;
                      }
                      p298 = false;
                    } else {
                      p298 = true;
                    }
                    let v298 = p298;
                    if v298 {
                      let v299 = (v292 + 4294967295u);
                      let v300 = (v292 << (1u & 31u));
                      let v301 = (v300 + 4294967295u);
                      let v302 = (v301 + v291);
                      p307 = v302;
                      p308 = v299;
                    }
                    p350 = v276;
                    p309 = false;
                  } else {
                    p309 = true;
                  }
                  let v307 = p307;
                  let v308 = p308;
                  let v309 = p309;
                  if v309 {
                    let v310 = (v273 + 138u);
                    let v311 = (v831 * 4096.0f);
                    let v842 = u32(v311);
                    let v843 = (v311 > 0.0f);
                    let v844 = select(0u, v842, v843);
                    let v845 = (v311 >= 4294967300.0f);
                    let v846 = select(v844, 4294967295u, v845);
                    let v313 = (v846 + 4294967272u);
                    let v314 = (v271 << (24u & 31u));
                    let v315 = (v313 * v313);
                    let v316 = (v314 - v315);
                    let v317 = f32(v316);
                    let v318 = f32(v313);
                    let v319 = (0.5f / v318);
                    let v320 = (v319 * v317);
                    let v847 = u32(v320);
                    let v848 = (v320 > 0.0f);
                    let v849 = select(0u, v847, v848);
                    let v850 = (v320 >= 4294967300.0f);
                    let v851 = select(v849, 4294967295u, v850);
                    let v322 = (v313 << (1u & 31u));
                    let v323 = (v851 + v322);
                    let v324 = (v323 * v851);
                    let v325 = (v316 - v324);
                    let v326 = (v851 + v313);
                    let v327 = (bitcast<i32>(v325) >= bitcast<i32>(0u));
                    if v327 {
                      let v328 = (v326 << (1u & 31u));
                      let v329 = (v325 > v328);
                      if v329 {
                        let v337 = (v326 + 1u);
                        let v338 = (v328 ^ 4294967295u);
                        let v339 = (v325 + v338);
                        p349 = v339;
                        p348 = v337;
                      } else {
                        p349 = v325;
                        p348 = v326;
                      }
                      p332 = false;
                    } else {
                      p332 = true;
                    }
                    let v332 = p332;
                    if v332 {
                      let v333 = (v326 + 4294967295u);
                      let v334 = (v326 << (1u & 31u));
                      let v335 = (v334 + 4294967295u);
                      let v336 = (v335 + v325);
                      p349 = v336;
                      p348 = v333;
                    }
                    p350 = v310;
                  } else {
                    p348 = v308;
                    p349 = v307;
                  }
                  let v348 = p348;
                  let v349 = p349;
                  let v350 = p350;
                  let v351 = (v349 > v348);
                  let v352 = select(0u, 1u, v351);
                  let v353 = (v350 << (23u & 31u));
                  let v354 = (v348 + 4286578688u);
                  let v355 = (v354 + v353);
                  let v356 = (v355 + v352);
                  let v357 = bitcast<f32>(v356);
                  p80 = v357;
                } else {
                  p80 = bitcast<f32>(bits_7fc00000);
                }
              } else {
                p80 = v21;
              }
            }
            p102 = false;
          } else {
            p102 = true;
          }
          let v102 = p102;
          if v102 {
            let v103 = (v754 ^ v753);
            let v104 = (v103 & 2147483648u);
            let v852 = abs(v21);
            let v106 = bitcast<u32>(v852);
            let v853 = abs(v22);
            let v108 = bitcast<u32>(v853);
            let v109 = (v106 > 2139095040u);
            let v110 = (v108 > 2139095040u);
            let v111 = (v109 | v110);
            let v112 = (v111 != true);
            if v112 {
              let v113 = (v106 != v108);
              if v113 {
                let v114 = (v106 == 0u);
                let v115 = (v108 == 2139095040u);
                let v116 = (v114 | v115);
                let v117 = (v116 != true);
                if v117 {
                  let v127 = (v108 == 0u);
                  let v128 = (v106 == 2139095040u);
                  let v129 = (v128 | v127);
                  if v129 {
                    let v132 = (v104 | 2139095040u);
                    p236 = v132;
                    p125 = false;
                  } else {
                    p125 = true;
                  }
                } else {
                  p236 = v104;
                  p125 = false;
                }
                p126 = false;
              } else {
                p125 = false;
                p126 = true;
              }
              let v125 = p125;
              let v126 = p126;
              if v126 {
                let v122 = (bitcast<i32>(v106) < bitcast<i32>(2139095040u));
                if v122 {
                  let v123 = (v106 != 0u);
                  p121 = v123;
                } else {
                  p121 = v125;
                }
                p236 = 2143289344u;
              } else {
                p121 = v125;
              }
              let v121 = p121;
              if v121 {
                let v134 = (v106 <= 8388607u);
                if v134 {
                  let v854 = countLeadingZeros(v106);
                  let v136 = (v854 + 4294967288u);
                  let v137 = (v106 << (v136 & 31u));
                  let v138 = (4294967155u - v854);
                  p148 = v137;
                  p147 = v138;
                  p141 = false;
                } else {
                  p141 = true;
                }
                let v141 = p141;
                if v141 {
                  let v142 = (v106 & 8388607u);
                  let v143 = (v142 | 8388608u);
                  let v144 = (v106 >> (23u & 31u));
                  let v145 = (v144 + 4294967146u);
                  p147 = v145;
                  p148 = v143;
                }
                let v147 = p147;
                let v148 = p148;
                let v149 = (v108 <= 8388607u);
                if v149 {
                  let v855 = countLeadingZeros(v108);
                  let v151 = (v855 + 4294967288u);
                  let v152 = (v108 << (v151 & 31u));
                  let v153 = (v855 + 141u);
                  p162 = v152;
                  p161 = v153;
                  p156 = false;
                } else {
                  p156 = true;
                }
                let v156 = p156;
                if v156 {
                  let v157 = (v108 & 8388607u);
                  let v158 = (v157 | 8388608u);
                  let v159 = (v108 >> (23u & 31u));
                  let v160 = (150u - v159);
                  p161 = v160;
                  p162 = v158;
                }
                let v161 = p161;
                let v162 = p162;
                let v163 = (v148 < v162);
                let v164 = select(0u, 4294967295u, v163);
                let v165 = select(0u, 1u, v163);
                let v166 = (v147 + 4294967273u);
                let v167 = (v166 + v161);
                let v168 = (v167 + v164);
                let v169 = (v148 << (v165 & 31u));
                let v170 = f32(v162);
                let v171 = (1.0f / v170);
                let v172 = f32(v169);
                let v173 = (v171 * v172);
                let v174 = (v173 * 8388608.0f);
                let v856 = u32(v174);
                let v857 = (v174 > 0.0f);
                let v858 = select(0u, v856, v857);
                let v859 = (v174 >= 4294967300.0f);
                let v860 = select(v858, 4294967295u, v859);
                let v176 = (v860 + 4294967264u);
                let v177 = (v169 << (23u & 31u));
                let v178 = (v176 * v162);
                let v179 = (v177 - v178);
                let v180 = f32(v179);
                let v181 = (v171 * v180);
                let v861 = u32(v181);
                let v862 = (v181 > 0.0f);
                let v863 = select(0u, v861, v862);
                let v864 = (v181 >= 4294967300.0f);
                let v865 = select(v863, 4294967295u, v864);
                let v183 = (v865 + v176);
                let v184 = (v865 * v162);
                let v185 = (v179 - v184);
                let v186 = (bitcast<i32>(v185) >= bitcast<i32>(v162));
                if v186 {
                  let v191 = (v183 + 1u);
                  let v192 = (v185 - v162);
                  p198 = v191;
                  p197 = v192;
                  p189 = false;
                } else {
                  p189 = true;
                }
                let v189 = p189;
                if v189 {
                  let v190 = (bitcast<i32>(v185) < bitcast<i32>(0u));
                  if v190 {
                    let v193 = (v183 + 4294967295u);
                    let v194 = (v185 + v162);
                    p198 = v193;
                    p197 = v194;
                  } else {
                    p198 = v183;
                    p197 = v185;
                  }
                }
                let v197 = p197;
                let v198 = p198;
                let v199 = (v197 << (1u & 31u));
                let v200 = (bitcast<i32>(v168) <= bitcast<i32>(4294967146u));
                if v200 {
                  let v201 = (v168 >= 4294967122u);
                  if v201 {
                    let v217 = (4294967147u - v168);
                    let v218 = (v198 >> (v217 & 31u));
                    let v219 = (4294967295u << (v217 & 31u));
                    let v220 = (v219 ^ 4294967295u);
                    let v221 = (v198 & v220);
                    let v222 = (4294967146u - v168);
                    let v223 = (1u << (v222 & 31u));
                    let v224 = (v221 <= v223);
                    if v224 {
                      let v225 = (v221 == v223);
                      if v225 {
                        let v226 = (v199 == 0u);
                        let v227 = (v218 & 1u);
                        let v228 = select(1u, v227, v226);
                        p231 = v228;
                      } else {
                        p231 = 0u;
                      }
                    } else {
                      p231 = 1u;
                    }
                    let v231 = p231;
                    let v232 = (v231 + v218);
                    p233 = v232;
                  } else {
                    p233 = 0u;
                  }
                  p203 = false;
                } else {
                  p203 = true;
                }
                let v203 = p203;
                if v203 {
                  let v204 = (v199 > v162);
                  let v205 = (v199 == v162);
                  let v206 = (v198 & 1u);
                  let v207 = select(0u, v206, v205);
                  let v208 = select(v207, 1u, v204);
                  let v209 = (v168 << (23u & 31u));
                  let v210 = (v209 + 1249902592u);
                  let v211 = (v210 + v198);
                  let v212 = (v211 + v208);
                  let v213 = (bitcast<i32>(v168) > bitcast<i32>(104u));
                  let v214 = (v212 > 2139095039u);
                  let v215 = (v213 | v214);
                  let v216 = select(v212, 2139095040u, v215);
                  p233 = v216;
                }
                let v233 = p233;
                let v234 = (v233 | v104);
                p236 = v234;
              }
            } else {
              p236 = 2143289344u;
            }
            let v236 = p236;
            let v237 = bitcast<f32>(v236);
            p80 = v237;
          }
          p81 = true;
          p82 = false;
        } else {
          p81 = v71;
          p82 = true;
        }
        let v80 = p80;
        let v81 = p81;
        let v82 = p82;
        if v82 {
          let v83 = (bitcast<i32>(v752) >= bitcast<i32>(1u));
          if v83 {
            let v866 = sqrt(v21);
            p736 = v866;
            p737 = true;
            p86 = false;
          } else {
            p737 = v81;
            p86 = true;
          }
          let v86 = p86;
          if v86 {
            let v87 = (v752 != 0u);
            p94 = true;
            p63 = v87;
          } else {
            p94 = false;
            p63 = v28;
          }
        } else {
          p736 = v80;
          p737 = v81;
          p94 = false;
          p63 = v28;
        }
      } else {
        p736 = v70;
        p737 = v71;
        p94 = false;
        p63 = v28;
      }
    } else {
      p736 = v25;
      p737 = v27;
      p94 = false;
      p63 = v28;
    }
    let v63 = p63;
    if v63 {
      let v90 = -(v22);
      let v867 = fma(v21, v21, v90);
      p736 = v867;
      p737 = true;
      p94 = false;
    }
    let v94 = p94;
    if v94 {
      let v95 = (v21 / v22);
      p736 = v95;
      p737 = true;
    }
    let v736 = p736;
    let v737 = p737;
    if v737 {
      let v738 = bitcast<u32>(v736);
      p740 = v738;
    }
    let v740 = p740;
    r2[v746] = v740;
  }
  return;
}
