//! Acceptance filters (8.0).

use crate::bench::{Can, FRAME, TX8, add, fd, frame, kinds, pair, pair_with};
use can_frame::Frame;
use can_sim::{DiagnosticKind, PeerId, Sim};
use dspic33_canfd_pac::{
    enums::{ConLDncnt, PayloadSize},
    registers as pac,
};

fn bench() -> (Sim, Can, PeerId) {
    bench_with(|_, _| ())
}

fn bench_with(set_up: impl FnOnce(&Sim, Can)) -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.rx_fifo(&sim, 1, 32, PayloadSize::Bytes64);
    can.rx_fifo(&sim, 2, 2, PayloadSize::Bytes64);
    can.rx_fifo(&sim, 3, 1, PayloadSize::Bytes64);
    set_up(&sim, can);
    can.start(&sim);
    (sim, can, peer)
}

/// Sends frames and tells which of them arrive in FIFO 1.
fn accepted(sim: &Sim, can: Can, peer: PeerId, frames: &[Frame]) -> Vec<bool> {
    let arrives = |frame: &Frame| {
        sim.peer_send(peer, *frame);
        sim.run_for(FRAME);
        can.receive(sim, 1).is_some()
    };
    frames.iter().map(arrives).collect()
}

fn texts(texts: &[&str]) -> Vec<Frame> {
    texts.iter().map(|text| frame(text)).collect()
}

const EXIDE: u32 = 1 << 30;
const MIDE: u32 = 1 << 30;

/// 8.2.1: MIDE and EXIDE.
#[test]
fn section_8_2_1_frame_types() {
    for (object, mask, expected) in
        [(0, 0, [true, true]), (EXIDE, 0, [true, true]), (0, MIDE, [true, false]), (EXIDE, MIDE, [false, true])]
    {
        let (sim, can, peer) = bench();
        can.filter(&sim, 0, object, mask, 1);
        assert_eq!(accepted(&sim, can, peer, &texts(&["123#", "12345678#"])), expected, "{object:#x} {mask:#x}");
    }
}

/// 8.2.2: all messages with identifiers 0 to 3: the two low mask bits are 0.
#[test]
fn section_8_2_2_mask_bits() {
    let (sim, can, peer) = bench();
    can.filter(&sim, 0, 0, MIDE | 0x7FC, 1);
    let frames = texts(&["000#", "001#", "002#", "003#", "004#", "403#"]);
    assert_eq!(accepted(&sim, can, peer, &frames), [true, true, true, true, false, false]);
}

/// Example 9-1: the words accept the extended identifiers 2 and 3 and nothing else; bit 15 of the mask does not exist.
#[test]
fn example_9_1_filter() {
    let (sim, can, peer) = bench();
    can.filter(&sim, 0, 0x4000_1000, 0xFFFF_F7FF, 1);
    assert_eq!(can.regs(&sim).flt_con(0).read().bits(), 0x0081);
    assert_eq!(can.regs(&sim).flt(0).mask_h().read().bits(), 0x7FFF);
    let frames = texts(&["00000002#", "00000003#", "00000001#", "00000004#", "00040002#", "002#"]);
    assert_eq!(accepted(&sim, can, peer, &frames), [true, true, false, false, false, false]);
}

/// Table 8-1: the first n data bits against EID0 to EIDn-1, the comparison ending with the payload.
#[test]
fn table_8_1_data_bits() {
    for dncnt in 0..=18_u8 {
        let (sim, can, peer) = bench_with(|sim, can| {
            let con = can.regs(sim).con_l();
            let bits = ConLDncnt::from_bits(dncnt).unwrap();
            con.write(con.read().with_dncnt(bits));
        });
        // All 18 bits are to be 1: MEID and EID all ones, in the low and the high word.
        can.filter(&sim, 0, 0x1FFF_F800 | 0x123, 0x1FFF_F800 | MIDE | 0x7FF, 1);
        for len in 0..=3_usize {
            let compared = usize::from(dncnt).min(len * 8);
            let good = Frame::data(crate::bench::StandardId::new(0x123).unwrap(), &[0xFF; 3][..len]).unwrap();
            assert_eq!(accepted(&sim, can, peer, &[good]), [true]);
            for wrong in 0..len * 8 {
                let mut data = [0xFF_u8; 3];
                data[wrong / 8] ^= 0x80 >> (wrong % 8);
                let bad = Frame::data(crate::bench::StandardId::new(0x123).unwrap(), &data[..len]).unwrap();
                assert_eq!(
                    accepted(&sim, can, peer, &[bad]),
                    [wrong >= compared],
                    "DNCNT {dncnt}, bit {wrong} of {len}"
                );
            }
        }
    }
}

/// Register 3-1, table 8-1: a DNCNT above 18 compares 18 bits. 8.2.3: extended frames are not compared.
#[test]
fn dncnt_beyond_its_range() {
    let (sim, can, peer) = bench();
    use regbus::Bus;
    let bus = sim.registers(can.id);
    bus.write(0x000, bus.read::<u16>(0x000) | 31);
    can.filter(&sim, 0, 0x1FFF_F800, 0x1FFF_F800, 1);
    let frames = texts(&["123#FFFFC0", "123#FFFFFF", "123#FFFF80", "0003FFFF#00"]);
    assert_eq!(accepted(&sim, can, peer, &frames), [true, true, false, true]);
}

/// 8.2.4: twelve-bit identifiers of CAN FD base frames, received in R1 too.
#[test]
fn section_8_2_4_twelve_bit_identifiers() {
    let (sim, can, peer) = bench_with(|sim, can| {
        can.regs(sim).tdc_h().write(pac::TdcH::from_bits(0).with_sid11en(true));
    });
    let sid11 = 1 << 29;
    can.filter(&sim, 0, sid11 | 0x123, sid11 | MIDE | 0x7FF, 1);
    let plain = fd(0x123, &[1]);
    let with = plain.with_remote_request_substitution(true);
    assert_eq!(accepted(&sim, can, peer, &[plain]), [false]);
    sim.peer_send(peer, with);
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 1), Some(with));
    // Classic frames have no RRS.
    assert_eq!(accepted(&sim, can, peer, &[frame("123#")]), [true]);
}

/// 8.2: filter 0 first, filtering stops at the first that takes the message; FILHIT names it.
#[test]
fn the_first_filter_wins() {
    let (sim, can, peer) = bench();
    can.filter(&sim, 7, 0x100, MIDE | 0x700, 1);
    can.filter(&sim, 31, 0, 0, 2);
    for text in ["123#", "223#"] {
        sim.peer_send(peer, frame(text));
        sim.run_for(FRAME);
    }
    let (first, control, _) = can.receive_object(&sim, 1).unwrap();
    assert_eq!((first, control.filhit().bits()), (frame("123#"), 7));
    let (second, control, _) = can.receive_object(&sim, 2).unwrap();
    assert_eq!((second, control.filhit().bits()), (frame("223#"), 31));
    assert_eq!(can.regs(&sim).vec_l().read().bits() >> 8, 31);
}

/// 8.2: a full FIFO is passed over; RXOVIF only if none takes the message, in the FIFO of the first filter.
#[test]
fn overflow_with_several_filters() {
    let (sim, can, peer) = bench();
    can.filter(&sim, 0, 0, 0, 3);
    can.filter(&sim, 1, 0, 0, 2);
    let receive = |count: usize| {
        for _ in 0..count {
            sim.peer_send(peer, frame("123#"));
            sim.run_for(FRAME);
        }
        (can.status(&sim, 3).rxovif(), can.status(&sim, 2).rxovif())
    };
    assert_eq!(receive(1), (false, false), "FIFO 3 takes one");
    assert_eq!(receive(2), (false, false), "FIFO 2 takes two");
    assert_eq!(receive(1), (true, false));
    let (sim, can, peer) = pair_with(|config| {
        config.with_choices(crate::bench::choices(|choices| choices.every_full_fifo_overflows = true))
    });
    can.rx_fifo(&sim, 2, 2, PayloadSize::Bytes8);
    can.rx_fifo(&sim, 3, 1, PayloadSize::Bytes8);
    can.filter(&sim, 0, 0, 0, 3);
    can.filter(&sim, 1, 0, 0, 2);
    can.start(&sim);
    for _ in 0..2 {
        sim.peer_send(peer, frame("123#"));
        sim.run_for(FRAME);
    }
    assert!(can.status(&sim, 3).rxovif() && !can.status(&sim, 2).rxovif());
}

/// 8.2, 6.11: what is for a transmit FIFO without RTREN is discarded.
#[test]
fn messages_for_a_transmit_fifo_are_discarded() {
    let (sim, can, peer) = bench_with(|sim, can| can.tx_fifo(sim, 4, TX8));
    can.filter(&sim, 0, 0, 0, 4);
    can.filter(&sim, 1, 0, 0, 1);
    for text in ["123#11", "123#R"] {
        sim.peer_send(peer, frame(text));
        sim.run_for(FRAME);
    }
    assert!(!can.has_message(&sim, 1), "filtering stops");
    assert_eq!(can.pending(&sim), 0);
    assert!(!can.status(&sim, 4).rxovif());
}

/// 8.1: object and mask take no write while the filter is enabled; FnBP 0 is reserved.
#[test]
fn section_8_1_order() {
    let (sim, can, _) = bench();
    can.filter(&sim, 5, 0x123, 0x7FF, 1);
    assert_eq!(kinds(&sim), []);
    let flt = can.regs(&sim).flt(5);
    flt.obj_l().write(pac::FltObjL::from_bits(0x456));
    flt.mask_h().write(pac::MaskH::from_bits(0x1));
    assert_eq!((flt.obj_l().read().sid(), flt.mask_h().read().bits()), (0x123, 0));
    let protected = |kind: &DiagnosticKind, register: &str| matches!(kind, DiagnosticKind::ProtectedWrite { register: at, condition: "filter_disabled", .. } if at == register);
    let found = kinds(&sim);
    assert!(found.len() == 2 && protected(&found[0], "FLTOBJL[5]") && protected(&found[1], "MASKH[5]"), "{found:?}");
    // The neighbours are free.
    can.regs(&sim).flt(4).obj_l().write(pac::FltObjL::from_bits(0x456));
    assert_eq!(kinds(&sim), []);
    let (con, lane) = can.regs(&sim).flt_con_of(9);
    con.write(con.read().with_flten(lane, true));
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::Contradiction { .. }]));
}

/// 8.0: 32 filters, each to its own FIFO.
#[test]
fn every_filter_and_every_fifo() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    let peer = sim.add_peer(can_wire::NodeConfig::new()).unwrap();
    can.configure(&sim);
    for number in 1..32 {
        can.rx_fifo(&sim, number, 1, PayloadSize::Bytes8);
    }
    for filter in 0..32_u32 {
        can.filter(&sim, filter as usize, 0x100 + filter, MIDE | 0x7FF, 31 - (filter as u8 % 31));
    }
    can.start(&sim);
    for filter in 0..31_u32 {
        sim.peer_send(peer, frame(&format!("{:03X}#{filter:02X}", 0x100 + filter)));
        sim.run_for(FRAME);
        let (_, control, _) = can.receive_object(&sim, 31 - filter as usize % 31).unwrap();
        assert_eq!(u32::from(control.filhit().bits()), filter);
    }
}
