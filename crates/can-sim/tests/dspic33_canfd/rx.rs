//! Reception: objects, DLC mismatch, automatic replies (6.11, 9.0).

use crate::bench::{Can, FRAME, FdFlags, StandardId, TX8, fd, frame, ids, pair, pair_with};
use can_frame::Frame;
use can_sim::{PeerId, Sim};
use dspic33_canfd_pac::{enums::PayloadSize, registers as pac};

fn bench(size: PayloadSize, stamped: bool) -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.rx_fifo(&sim, 1, 4, size);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(pac::FifoConL::from_bits(0).with_rxtsen(stamped));
    can.accept_all(&sim, 1);
    can.start(&sim);
    (sim, can, peer)
}

/// Table 9-1: the words of receive objects, with and without timestamp.
#[test]
fn table_9_1_receive_objects() {
    for stamped in [false, true] {
        let (sim, can, peer) = bench(PayloadSize::Bytes64, stamped);
        let data: Vec<u8> = (0x10..0x1C).collect();
        let id = crate::bench::ExtendedId::new(0x1400_C01D).unwrap();
        sim.peer_send(peer, Frame::fd(id, &data, FdFlags { brs: true, esi: false }).unwrap());
        sim.run_for(FRAME);
        let words = sim.with_memory(can.ram, |ram| ram.words()[..6].to_vec());
        // R0: EID[4:0] and SID; R1: EID[17:5]; R2: FDF, BRS, IDE, DLC 9.
        assert_eq!(words[0], 0x0600 << 16 | 0x1D << 11 | 0x500);
        assert_eq!(words[1], 0x00D9);
        let first = if stamped { 3 } else { 2 };
        assert_eq!(words[first], 0x1312_1110);
        let held = sim.with_memory(can.ram, |ram| ram.clone());
        let held = sim.inspect(can.id, |model| model.rx_fifo(&held, 1));
        assert_eq!((held.len(), held[0].frame.data_bytes(), held[0].timestamp.is_some()), (1, &data[..], stamped));
    }
}

#[test]
fn every_format_arrives() {
    let (sim, can, peer) = bench(PayloadSize::Bytes64, false);
    let data: Vec<u8> = (0..64).collect();
    let mut frames = vec![frame("123#"), frame("12345678#0102030405060708"), frame("7FF#R3"), frame("1FFFFFFF#R")];
    frames.extend(can_frame::FD_LENGTHS.map(|len| fd(0x400, &data[..usize::from(len)])));
    let id = StandardId::new(0x55).unwrap();
    frames.push(Frame::fd(id, &[1], FdFlags { brs: false, esi: true }).unwrap());
    for sent in frames {
        sim.peer_send(peer, sent);
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 1), Some(sent));
    }
    // Register 3-49: the ESI flag of a received frame; 12.3.1: it sets no IVMIF.
    assert!(can.diagnosis(&sim).esi() && !can.flags(&sim).ivmif());
    assert_eq!(sim.diagnostics(), []);
}

/// 9.4: what does not fit is discarded, the next object stays untouched, IVMIF and DLCMM are set.
#[test]
fn section_9_4_dlc_above_the_payload_size() {
    let (sim, can, peer) = bench(PayloadSize::Bytes12, false);
    sim.with_memory(can.ram, |ram| ram.words_mut()[5..10].fill(0xEEEE_EEEE));
    sim.peer_send(peer, fd(0x100, &[0x77; 16]));
    sim.run_for(FRAME);
    let words = sim.with_memory(can.ram, |ram| ram.words()[2..7].to_vec());
    assert_eq!(words, [0x7777_7777, 0x7777_7777, 0x7777_7777, 0xEEEE_EEEE, 0xEEEE_EEEE]);
    assert!(can.flags(&sim).ivmif() && can.diagnosis(&sim).dlcmm());
    let (received, control, _) = can.receive_object(&sim, 1).unwrap();
    assert_eq!((control.dlc().bits(), received.dlc().code()), (10, 10), "the DLC is stored as received");
}

/// 9.4, `bytes_behind_the_message`: a shorter message is stored without padding.
#[test]
fn section_9_4_dlc_below_the_payload_size() {
    for whole in [false, true] {
        let (sim, can, peer) = pair_with(|config| {
            config.with_choices(crate::bench::choices(|choices| choices.last_word_is_whole = whole))
        });
        can.rx_fifo(&sim, 1, 4, PayloadSize::Bytes8);
        can.accept_all(&sim, 1);
        can.start(&sim);
        sim.with_memory(can.ram, |ram| ram.words_mut()[2..4].fill(0xEEEE_EEEE));
        sim.peer_send(peer, frame("100#112233"));
        sim.run_for(FRAME);
        let words = sim.with_memory(can.ram, |ram| ram.words()[2..4].to_vec());
        assert_eq!(words, [if whole { 0xEE33_2211 & 0x00FF_FFFF } else { 0xEE33_2211 }, 0xEEEE_EEEE]);
    }
}

/// 9.2: a frame with an error is not stored, and leaves no overflow.
#[test]
fn frames_with_errors_are_not_stored() {
    let (sim, can, peer) = bench(PayloadSize::Bytes8, false);
    let node = sim.node(can.id);
    let position = can_wire::Position::new(can_wire::Field::Data, 5);
    let fault = can_wire::BitFault::InvertSeen;
    sim.with_wire(|wire| wire.inject(can_wire::Fault::Bit { node, fault, position, frames: can_wire::Frames::next() }));
    sim.peer_send(peer, frame("123#AA55"));
    sim.run_for(FRAME * 2);
    assert_eq!(can.status(&sim, 1).fifoci(), 1, "only the repetition is stored");
    assert_eq!(can.receive(&sim, 1), Some(frame("123#AA55")));
}

fn auto_reply(rtren: bool) -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_freset(false).with_rtren(rtren));
    can.filter(&sim, 0, 0x123, 1 << 30 | 0x7FF, 1);
    can.start(&sim);
    (sim, can, peer)
}

/// 6.11: a remote frame requests what the FIFO holds.
#[test]
fn section_6_11_automatic_reply() {
    let (sim, can, peer) = auto_reply(true);
    can.load(&sim, 1, &frame("123#AABB"));
    sim.peer_send(peer, frame("123#CC"));
    sim.run_for(FRAME * 2);
    assert_eq!(ids(&sim, peer), [], "a data frame asks for nothing");
    sim.peer_send(peer, frame("124#R"));
    sim.run_for(FRAME * 2);
    assert_eq!(ids(&sim, peer), []);
    sim.peer_send(peer, frame("123#R"));
    sim.run_for(FRAME * 2);
    assert_eq!(sim.peer_received(peer)[0].1, frame("123#AABB"));
    assert_eq!(can.pending(&sim), 0);
    assert!(!can.status(&sim, 1).rxovif());
}

/// 6.11, 8.2: an empty FIFO overflows.
#[test]
fn section_6_11_empty_fifo() {
    let (sim, can, peer) = auto_reply(true);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_rxovie(true));
    can.regs(&sim).int_h().write(pac::IntH::RXOVIE);
    sim.peer_send(peer, frame("123#R"));
    sim.run_for(FRAME);
    assert!(can.status(&sim, 1).rxovif());
    assert_eq!(can.regs(&sim).read_rxovif(), 1 << 1);
    assert!(sim.line(can.id, 2));
    can.regs(&sim).fifo(1).sta().clear(pac::FifoSta::RXOVIF);
    assert!(!sim.line(can.id, 2));
    let (sim, can, peer) = auto_reply(false);
    can.load(&sim, 1, &frame("123#AABB"));
    sim.peer_send(peer, frame("123#R"));
    sim.run_for(FRAME * 2);
    assert_eq!(ids(&sim, peer), [], "without RTREN the message is discarded");
    assert_eq!(can.pending(&sim), 0);
}
