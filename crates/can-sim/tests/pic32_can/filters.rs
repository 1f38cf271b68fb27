//! Chapter 34.8: filters, masks, several hits, DeviceNet filtering.

use can_sim::{DiagnosticKind, PeerId, Sim, Time};
use pic32_can_pac::{
    enums::{ConDncnt, FltConFsel, FltConMsel, OperationMode, RxmMide},
    registers::{Con, FltCon, Rxf, Rxm},
};

use crate::bench::*;

/// A module in Configuration mode with receive FIFOs of one message each, and a function that asks what it accepts.
fn configured(fifos: usize) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &vec![Use::Rx(1); fifos]);
    (sim, can)
}

fn started(sim: &Sim, can: Can) -> PeerId {
    can.start(sim);
    add_peer(sim)
}

/// The FIFO that a frame goes to.
fn destination(sim: &Sim, can: Can, peer: PeerId, text: &str) -> Option<usize> {
    sim.peer_send(peer, frame(text));
    sim.run_for(FRAME);
    let found: Vec<usize> = (0..8).filter(|fifo| can.receive(sim, *fifo).is_some()).collect();
    assert!(found.len() < 2, "{text} is in {found:?}");
    found.first().copied()
}

/// Example 34-11: filter 3 takes the SIDs 0x100 to 0x103 into FIFO5 with mask 1.
#[test]
fn example_34_11() {
    let (sim, can) = configured(6);
    let regs = can.regs(&sim);
    let select = FltCon::RESET.with_fsel(3, FltConFsel::Fifo(5)).with_msel(3, FltConMsel::Mask(1));
    regs.flt_con(0).set_bits(select);
    regs.rxf(3).write(Rxf::RESET.with_sid(0x100));
    regs.rxm(1).write(Rxm::RESET.with_sid(0x7FC).with_mide(RxmMide::TypeOfFilter));
    regs.flt_con(0).set_bits(FltCon::flten_bit(3));
    assert_eq!(regs.flt_con(0).read().bits(), 0xA500_0000);
    assert_eq!((regs.rxf(3).read().bits(), regs.rxm(1).read().bits()), (0x2000_0000, 0xFF88_0000));
    let peer = started(&sim, can);
    for (text, fifo) in
        [("100#", Some(5)), ("101#", Some(5)), ("103#", Some(5)), ("104#", None), ("0FF#", None), ("04000000#", None)]
    {
        assert_eq!(destination(&sim, can, peer, text), fifo, "{text}");
    }
    assert_eq!(can.filhit(&sim), 3);
}

/// Example 34-12 as coded (example_34_12_identifier): an extended identifier for filter 3.
#[test]
fn example_34_12() {
    let (sim, can) = configured(6);
    let id = 0x100 << 18 | 0x1_C498;
    can.filter(&sim, 3, 1, 5, extended(id), EXACT);
    let regs = can.regs(&sim);
    assert_eq!((regs.rxf(3).read().bits(), regs.rxm(1).read().bits()), (0x2009_C498, 0xFFEB_FFFF));
    let peer = started(&sim, can);
    assert_eq!(destination(&sim, can, peer, &format!("{id:08X}#")), Some(5));
    assert_eq!(destination(&sim, can, peer, &format!("{:08X}#", id ^ 1)), None);
    assert_eq!(destination(&sim, can, peer, "100#"), None);
}

/// Table 34-3, row by row: IDE, EXID, MIDE, and whether SID and EID match.
#[test]
fn table_34_3() {
    let sid = 0x123;
    let eid = 0x2_A5A5;
    for (ide, exid, mide, sid_matches, eid_matches, accepted) in [
        (false, false, true, true, true, true),
        (false, false, true, false, true, false),
        (true, true, true, true, true, true),
        (true, true, true, false, true, false),
        (true, true, true, true, false, false),
        (true, false, true, true, true, false),
        (false, true, true, true, true, false),
        (false, false, false, true, false, true),
        (false, true, false, true, false, true),
        (false, false, false, false, true, false),
        (true, false, false, true, true, true),
        (true, true, false, true, true, true),
        (true, false, false, false, true, false),
        (true, true, false, true, false, false),
    ] {
        let (sim, can) = configured(1);
        let value = if exid { extended(u32::from(sid) << 18 | eid) } else { standard(sid).with_eid(eid) };
        let mide = if mide { RxmMide::TypeOfFilter } else { RxmMide::AnyType };
        can.filter(&sim, 0, 0, 0, value, EXACT.with_mide(mide));
        let peer = started(&sim, can);
        let sid = if sid_matches { u32::from(sid) } else { u32::from(sid) ^ 0x400 };
        let eid = if eid_matches { eid } else { eid ^ 0x2_0000 };
        let text = if ide { format!("{:08X}#", sid << 18 | eid) } else { format!("{sid:03X}#") };
        let found = destination(&sim, can, peer, &text).is_some();
        assert_eq!(found, accepted, "IDE {ide}, EXID {exid}, MIDE {mide:?}, {text}");
    }
}

/// Figure 34-23: identifier 0x01234567 against filter 0x01234566 with a mask (mask 2) that ignores the lowest bit; the
/// filter that matched, filter 1, points to FIFO2 (figure_34_23).
#[test]
fn figure_34_23() {
    let (sim, can) = configured(4);
    can.filter(&sim, 1, 2, 2, extended(0x0123_4566), EXACT.with_eid(0x3_FFFE));
    can.filter(&sim, 2, 1, 3, extended(0x0123_4560), EXACT);
    let peer = started(&sim, can);
    assert_eq!(destination(&sim, can, peer, "01234567#"), Some(2));
    assert_eq!(destination(&sim, can, peer, "01234565#"), None);
}

/// Figure 34-24: filters 1, 2, 4 and 7 match; the FIFOs of 1 and 2 are full; filter 4 stores the message in FIFO4.
#[test]
fn figure_34_24() {
    let (sim, can) = configured(8);
    can.regs(&sim).rxm(0).write(EXACT);
    for filter in [1, 2, 4, 7] {
        can.select(&sim, filter, 0, filter as u8, standard(0x123));
    }
    let peer = started(&sim, can);
    for _ in 0..3 {
        sim.peer_send(peer, frame("123#"));
    }
    sim.run_for(FRAME * 4);
    let filled: Vec<usize> = (0..8).filter(|fifo| can.fifo(&sim, *fifo).int_().read().rxnemptyif()).collect();
    assert_eq!(filled, [1, 2, 4]);
    assert_eq!(can.filhit(&sim), 4);
    assert_eq!(can.word(&sim, 0x140) >> 11 & 0x1F, 4, "FILHIT in the message");
    assert!((0..8).all(|fifo| !can.fifo(&sim, fifo).int_().read().rxovflif()));
    sim.peer_send(peer, frame("123#"));
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME * 3);
    let overflowed: Vec<usize> = (0..8).filter(|fifo| can.fifo(&sim, *fifo).int_().read().rxovflif()).collect();
    assert_eq!(overflowed, [1], "the FIFO of the lowest matching filter (overflow_flag_of_several_fifos)");
    assert_eq!(can.filhit(&sim), 7, "filhit_on_overflow");
}

/// 34.8.4: several filters may point to one FIFO, and each filter to any.
#[test]
fn any_filter_to_any_fifo() {
    let (sim, can) = configured(32);
    can.regs(&sim).rxm(0).write(EXACT);
    for filter in 0..32 {
        can.select(&sim, filter, 0, (31 - filter) as u8 / 2, standard(0x100 + filter as u16));
    }
    let peer = started(&sim, can);
    for filter in (0..32).step_by(2) {
        sim.peer_send(peer, frame(&format!("{:03X}#", 0x100 + filter)));
        sim.run_for(FRAME);
        assert_eq!(can.filhit(&sim), filter as u8);
        let fifo = (31 - filter) / 2;
        assert_eq!(can.receive(&sim, fifo).unwrap().raw_id(), 0x100 + filter as u32);
    }
}

/// 34.8.1, Register 34-18: an enabled filter cannot be changed; in Normal mode it can once it is off.
#[test]
fn filters_are_locked_while_enabled() {
    let (sim, can) = configured(2);
    can.filter(&sim, 5, 0, 0, standard(0x100), EXACT);
    let peer = started(&sim, can);
    let regs = can.regs(&sim);
    regs.rxf(5).write(standard(0x200));
    regs.flt_con(1).set_bits(FltCon::RESET.with_fsel(1, FltConFsel::Fifo(1)));
    assert_eq!(regs.rxf(5).read(), standard(0x100));
    assert_eq!(regs.flt_con(1).read().fsel(1), FltConFsel::Fifo(0));
    let locked = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ProtectedWrite { condition: "filter_off", .. });
    let found = kinds(&sim);
    assert!(found.len() == 2 && found.iter().all(locked), "{found:?}");
    regs.rxf(4).write(standard(0x300));
    assert_eq!(regs.rxf(4).read(), standard(0x300), "the neighbour is free");
    regs.flt_con(1).clear_bits(FltCon::flten_bit(1));
    while regs.flt_con(1).read().flten(1) {}
    regs.rxf(5).write(standard(0x200));
    regs.flt_con(1).set_bits(FltCon::flten_bit(1).with_fsel(1, FltConFsel::Fifo(1)));
    assert_eq!(destination(&sim, can, peer, "200#"), Some(1), "filter_enable_and_select_in_one_write");
    assert_eq!(destination(&sim, can, peer, "100#"), None);
    assert_eq!(sim.diagnostics(), []);
}

/// 34.8.1: FLTEN stays 1 until the message at hand has been filtered, and that message is still taken.
#[test]
fn switching_a_filter_off_in_a_message() {
    let (sim, can) = configured(1);
    can.filter(&sim, 0, 0, 0, standard(0x100), EXACT);
    let peer = started(&sim, can);
    sim.peer_send(peer, frame("100#1122334455667788"));
    sim.peer_send(peer, frame("100#"));
    sim.run_for(Time::from_us(40));
    let control = can.regs(&sim).flt_con(0);
    control.clear_bits(FltCon::flten_bit(0));
    assert!(control.read().flten(0));
    sim.run_for(FRAME);
    assert!(!control.read().flten(0));
    assert_eq!(can.receive(&sim, 0), Some(frame("100#1122334455667788")));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), None);
}

/// filter_disable_delay: a read-modify-write for another filter writes the 1 back.
#[test]
fn a_filter_comes_back() {
    let (sim, can) = configured(1);
    can.filter(&sim, 0, 0, 0, standard(0x100), EXACT);
    let peer = started(&sim, can);
    sim.peer_send(peer, frame("100#1122334455667788"));
    sim.run_for(Time::from_us(40));
    let control = can.regs(&sim).flt_con(0);
    control.clear_bits(FltCon::flten_bit(0));
    control.modify(|value| value.with_fsel(2, FltConFsel::Fifo(7)));
    sim.run_for(FRAME);
    assert!(control.read().flten(0));
    sim.peer_send(peer, frame("101#1122334455667788"));
    sim.run_for(Time::from_us(40));
    control.clear_bits(FltCon::flten_bit(0));
    control.set_bits(FltCon::RESET.with_fsel(3, FltConFsel::Fifo(7)));
    sim.run_for(FRAME);
    assert!(!control.read().flten(0), "the SET register leaves it alone");
}

/// 34.8.3: a mask cannot be changed while an enabled filter selects it, not even in Configuration mode.
#[test]
fn masks_are_locked_by_enabled_filters() {
    let (sim, can) = configured(1);
    can.filter(&sim, 9, 2, 0, standard(0x100), EXACT);
    let regs = can.regs(&sim);
    regs.rxm(2).write(Rxm::RESET);
    assert_eq!(regs.rxm(2).read(), EXACT);
    let found = kinds(&sim);
    assert!(
        matches!(&found[..], [DiagnosticKind::ProtectedWrite { register, fields, .. }] if register == "RXM[2]" && fields == &["SID", "MIDE", "EID"]),
        "{found:?}"
    );
    regs.rxm(1).write(EXACT);
    regs.flt_con(2).clear_bits(FltCon::flten_bit(1));
    regs.rxm(2).write(Rxm::RESET);
    assert_eq!((regs.rxm(1).read(), regs.rxm(2).read()), (EXACT, Rxm::RESET));
    assert_eq!(sim.diagnostics(), []);
    assert_eq!(can.opmod(&sim), OperationMode::Configuration);
}

/// Table 34-4: for every DNCNT the data bits that are compared, with the order of the table (devicenet_eid_order).
#[test]
fn table_34_4() {
    let data = [0xA5_u8, 0x3C, 0xC0];
    let bits = u32::from(data[0]) << 10 | u32::from(data[1]) << 2 | u32::from(data[2]) >> 6;
    for dncnt in 1..=18_u8 {
        let (sim, can) = configured(1);
        can.regs(&sim).con().modify(|con| con.with_dncnt(ConDncnt::from_bits(dncnt).unwrap()));
        can.filter(&sim, 0, 0, 0, standard(0x123).with_eid(bits), EXACT);
        let peer = started(&sim, can);
        let accepted = |data: [u8; 3]| {
            let [a, b, c] = data;
            destination(&sim, can, peer, &format!("123#{a:02X}{b:02X}{c:02X}")).is_some()
        };
        assert!(accepted(data), "DNCNT {dncnt}");
        for bit in [0, u32::from(dncnt) - 1, u32::from(dncnt), 18, 23] {
            if bit > 23 {
                continue;
            }
            let mut changed = data;
            changed[bit as usize / 8] ^= 0x80 >> (bit % 8);
            assert_eq!(accepted(changed), bit >= u32::from(dncnt), "DNCNT {dncnt}, bit {bit}");
        }
        assert_eq!(destination(&sim, can, peer, "124#A53CC0"), None, "SID has to match too");
    }
}

/// 34.8.7.2, cases 1 to 4.
#[test]
fn devicenet_special_cases() {
    let cases = [
        (31_u32, "A53CC0", Some(0)),
        (31, "A53CFF", Some(0)),
        (31, "A53C40", None),
        (17, "A53C", Some(0)),
        (17, "A53D", None),
        (9, "A5", Some(0)),
        (9, "A4", None),
        (1, "", Some(0)),
        (18, "", Some(0)),
    ];
    for (dncnt, data, expected) in cases {
        let (sim, can) = configured(1);
        let con = can.regs(&sim).con();
        con.write(Con::from_bits(con.read().bits() | dncnt));
        let eid = 0xA5 << 10 | 0x3C << 2 | 3;
        can.filter(&sim, 0, 0, 0, standard(0x123).with_eid(eid), EXACT);
        let peer = started(&sim, can);
        // 34.8.7: bits 18 and up are never compared; 0xC0 and 0xFF agree in the two that are.
        assert_eq!(destination(&sim, can, peer, &format!("123#{data}")), expected, "DNCNT {dncnt}, {data}");
        assert_eq!(destination(&sim, can, peer, "124#A53CC0"), None);
        assert_eq!(destination(&sim, can, peer, "048EA53C#"), None, "IDE has to be 0");
    }
}

/// 34.8: to receive identifiers 0 to 3, the mask leaves out the two lowest bits.
#[test]
fn identifiers_0_to_3() {
    let (sim, can) = configured(1);
    can.filter(&sim, 0, 0, 0, standard(0), EXACT.with_sid(0x7FC));
    let peer = started(&sim, can);
    let accepted: Vec<u32> =
        (0..6).filter(|id| destination(&sim, can, peer, &format!("{id:03X}#")).is_some()).collect();
    assert_eq!(accepted, [0, 1, 2, 3]);
}
