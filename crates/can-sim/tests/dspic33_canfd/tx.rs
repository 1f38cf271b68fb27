//! Transmission: objects, requests, priorities, repetition, aborts, events (6.0, 7.0).

use crate::bench::{BASE, Can, FRAME, FdFlags, Mode, StandardId, TX8, TX64, TxFifo, fd, frame, ids, kinds, pair};
use can_frame::Frame;
use can_sim::{DiagnosticKind, PeerId, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use dspic33_canfd_pac::{
    enums::{ConHEsigm, ConHRtxat, ConHTxbws, ErrorState, PayloadSize, RetransmissionAttempts},
    messages::{TefObject, TefObjectTs, TxObject},
    registers as pac,
};

fn bench(set_up: impl FnOnce(&Sim, Can)) -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    set_up(&sim, can);
    can.start(&sim);
    (sim, can, peer)
}

/// Table 6-1: the words of the objects of example 6-1 and the frames they become.
#[test]
fn table_6_1_transmit_objects() {
    let (sim, can, peer) = bench(|sim, can| {
        can.queue(sim, TxFifo { depth: 1, size: PayloadSize::Bytes64, priority: 0 });
        can.tx_fifo(sim, 1, TxFifo { depth: 2, size: PayloadSize::Bytes16, priority: 0 });
    });
    use regbus::Bus;
    let ram = can.memory(&sim);
    let words = |at: usize, words: [u16; 3]| {
        (0..3).for_each(|word| ram.write(at + word * 2, words[word]));
        ram.write(at + 6, 0_u16);
    };
    words(0, [0x0100, 0x0000, 0x00CF]);
    (0..32).for_each(|word| ram.write(8 + word * 2, 0x5A5A_u16));
    can.increment(&sim, 0, true);
    words(0x48, [0x0300, 0x0000, 0x00CA]);
    (0..8).for_each(|word| ram.write(0x50 + word * 2, 0xA5A5_u16));
    can.increment(&sim, 1, false);
    words(0x60, [0x0500, 0x0600, 0x00D9]);
    (0..6).for_each(|word| ram.write(0x68 + word * 2, 0x5555_u16));
    can.increment(&sim, 1, true);
    sim.run_for(FRAME * 3);
    let flags = FdFlags { brs: true, esi: false };
    let extended = crate::bench::ExtendedId::new(0x1400_C000).unwrap();
    let expected = [fd(0x100, &[0x5A; 64]), fd(0x300, &[0xA5; 16]), Frame::fd(extended, &[0x55; 12], flags).unwrap()];
    let received: Vec<Frame> = sim.peer_received(peer).into_iter().map(|(_, frame)| frame).collect();
    assert_eq!(received, expected);
}

/// 6.1: byte 0 goes first; every length of classic and FD frames.
#[test]
fn every_length() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX64));
    let data: Vec<u8> = (1..=64).collect();
    let mut expected = Vec::new();
    for len in 0..=8 {
        expected.push(Frame::data(StandardId::new(len as u16).unwrap(), &data[..len]).unwrap());
    }
    for len in can_frame::FD_LENGTHS {
        expected.push(fd(0x100 + u16::from(len), &data[..usize::from(len)]));
    }
    expected.push(frame("7FF#R5"));
    for message in &expected {
        can.send(&sim, 1, message);
        sim.run_for(FRAME);
    }
    let received: Vec<Frame> = sim.peer_received(peer).into_iter().map(|(_, frame)| frame).collect();
    assert_eq!(received, expected);
}

/// 6.7: the highest TXPRI, then the queue, then the highest number; all of a FIFO before the next.
#[test]
fn section_6_7_priorities() {
    for (one, three, expected) in [(5, 4, [0x101, 0x102, 0x301, 0x302]), (4, 4, [0x301, 0x302, 0x101, 0x102])] {
        let (sim, can, peer) = bench(|sim, can| {
            can.tx_fifo(sim, 1, TxFifo { priority: one, ..TX8 });
            can.tx_fifo(sim, 3, TxFifo { priority: three, ..TX8 });
        });
        ["101#", "102#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
        ["301#", "302#"].iter().for_each(|text| can.load(&sim, 3, &frame(text)));
        can.request(&sim, 1 << 1 | 1 << 3);
        sim.run_for(FRAME * 4);
        assert_eq!(ids(&sim, peer), expected);
    }
    // At equal priority all of the queue is sent first.
    let (sim, can, peer) = bench(|sim, can| {
        can.queue(sim, TX8);
        can.tx_fifo(sim, 31, TX8);
    });
    ["301#", "302#"].iter().for_each(|text| can.load(&sim, 31, &frame(text)));
    ["702#", "701#"].iter().for_each(|text| can.load(&sim, 0, &frame(text)));
    can.request(&sim, 1 << 31 | 1);
    sim.run_for(FRAME * 4);
    assert_eq!(ids(&sim, peer), [0x701, 0x702, 0x301, 0x302]);
}

/// 6.7: priorities are compared anew after every message, and TXPRI may change at any time.
#[test]
fn priorities_are_compared_after_every_message() {
    let (sim, can, peer) = bench(|sim, can| {
        can.tx_fifo(sim, 1, TxFifo { priority: 1, ..TX8 });
        can.tx_fifo(sim, 2, TxFifo { priority: 0, ..TX8 });
    });
    ["101#", "102#", "103#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
    can.load(&sim, 2, &frame("201#"));
    can.request(&sim, 0b110);
    sim.run_for(Time::from_us(20));
    let size = can.regs(&sim).fifo(2).con_h();
    size.write(size.read().with_txpri(9));
    sim.run_for(FRAME * 4);
    assert_eq!(ids(&sim, peer), [0x101, 0x201, 0x102, 0x103]);
}

/// 6.7.2, `queue_order`: the order of arbitration, and the lowest object of equal identifiers.
#[test]
fn the_queue_sends_by_identifier() {
    let (sim, can, peer) = bench(|sim, can| can.queue(sim, TxFifo { depth: 8, ..TX8 }));
    let texts = ["300#00", "100#01", "7FF#02", "00000100#03", "0FF#R", "300#06", "04000000#04", "100#R"];
    texts.iter().for_each(|text| can.load(&sim, 0, &frame(text)));
    can.request(&sim, 1);
    sim.run_for(FRAME * 8);
    let order: Vec<String> = sim.peer_received(peer).iter().map(|(_, frame)| frame.to_string()).collect();
    let expected = ["00000100#03", "0FF#R", "100#01", "100#R", "04000000#04", "300#00", "300#06", "7FF#02"];
    assert_eq!(order, expected);
}

/// 6.5: TXQCI names the message that is sent next.
#[test]
fn txqci_names_the_next_message() {
    let (sim, can, _) = bench(|sim, can| can.queue(sim, TX8));
    can.go(&sim, Mode::Disable);
    ["300#", "100#", "200#"].iter().for_each(|text| can.load(&sim, 0, &frame(text)));
    can.request(&sim, 1);
    can.start(&sim);
    let order: Vec<u8> = (0..3)
        .map(|_| {
            let index = can.regs(&sim).txqsta().read().txqci();
            let sent = sim.frames_on_bus().len();
            sim.run_until(FRAME, |sim| sim.frames_on_bus().len() > sent).unwrap();
            index
        })
        .collect();
    assert_eq!(order, [1, 2, 0]);
}

/// 6.4, 6.6: TXREQ shows in both places, and falls when the FIFO is empty.
#[test]
fn txreq_shows_in_both_registers() {
    let (sim, can, _) = bench(|sim, can| {
        can.tx_fifo(sim, 1, TX8);
        can.tx_fifo(sim, 20, TX8);
        can.rx_fifo(sim, 2, 4, PayloadSize::Bytes8);
    });
    can.load(&sim, 1, &frame("101#"));
    can.load(&sim, 20, &frame("201#"));
    can.request(&sim, 1 << 1 | 1 << 20 | 1 << 2 | 1 << 5);
    assert_eq!(can.pending(&sim), 1 << 1 | 1 << 20, "receive FIFOs take no request");
    assert!(can.regs(&sim).fifo(1).con_l().read().txreq() && can.regs(&sim).fifo(20).con_l().read().txreq());
    can.regs(&sim).txreq_l().write(pac::TxreqL::from_bits(0));
    assert_eq!(can.pending(&sim), 1 << 1 | 1 << 20, "zeros are ignored");
    sim.run_for(FRAME * 2);
    assert_eq!(can.pending(&sim), 0);
    assert!(!can.regs(&sim).fifo(20).con_l().read().txreq());
    // stale_transmit_request.
    can.request(&sim, 1 << 1);
    assert_eq!(can.pending(&sim), 0);
    assert_eq!(sim.diagnostics(), []);
}

/// 6.4: UINC and TXREQ in one write append to a FIFO that is transmitting.
#[test]
fn appending_while_transmitting() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX8));
    can.send(&sim, 1, &frame("101#"));
    sim.run_for(Time::from_us(15));
    let at = (can.user_address(&sim, 1) - BASE) as usize;
    can.write_object(&sim, at, &frame("102#"), |t2| t2);
    can.increment(&sim, 1, true);
    sim.run_for(FRAME * 2);
    assert_eq!(ids(&sim, peer), [0x101, 0x102]);
}

/// 6.8: after a message of its own the module stays idle for TXBWS bit times; after a received one it does not.
#[test]
fn section_6_8_bandwidth_sharing() {
    for code in 0..=15_u8 {
        let (sim, can, _) = bench(|sim, can| {
            can.tx_fifo(sim, 1, TX8);
            can.con_h(sim, |con_h| con_h.with_txbws(ConHTxbws::from_bits(code)));
        });
        ["101#", "102#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
        can.request(&sim, 1 << 1);
        sim.run_for(Time::from_ms(5));
        let log = sim.bus_log();
        let times: Vec<(Time, Time)> = log
            .iter()
            .filter_map(|entry| match entry {
                can_sim::BusEntry::Frame { start, end, .. } => Some((*start, *end)),
                _ => None,
            })
            .collect();
        let idle = times[1].0.since(times[0].1).as_ps() / 1_000_000 - 4;
        let expected = if code == 0 { 0 } else { 1 << code.min(12) };
        assert_eq!(idle, expected, "TXBWS {code}");
    }
    let (sim, can, peer) = bench(|sim, can| {
        can.tx_fifo(sim, 1, TX8);
        can.con_h(sim, |con_h| con_h.with_txbws(ConHTxbws::from_bits(12)));
    });
    ["701#", "702#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
    can.request(&sim, 1 << 1);
    sim.run_for(Time::from_us(20));
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(ids(&sim, peer), [0x701, 0x702], "the peer's frame ends the pause");
}

/// Hits frames of the module with a bit error each.
fn spoil(sim: &Sim, can: Can, count: u32) {
    let node = sim.node(can.id);
    let frames = Frames { sender: Some(node), skip: 0, count };
    let position = Position::new(Field::Crc, 3);
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
}

fn attempts(txat: RetransmissionAttempts, rtxat: ConHRtxat) -> (Sim, Can, PeerId) {
    bench(|sim, can| {
        can.tx_fifo(sim, 1, TX8);
        can.con_h(sim, |con_h| con_h.with_rtxat(rtxat));
        let size = can.regs(sim).fifo(1).con_h();
        size.write(size.read().with_txat(txat));
    })
}

fn errors_on_bus(sim: &Sim, can: Can) -> usize {
    let node = sim.node(can.id);
    let of = |entry: &&can_sim::BusEntry| matches!(entry, can_sim::BusEntry::Error { node: at, .. } if *at == node);
    sim.bus_log().iter().filter(of).count()
}

/// 6.9.1: disabled: one attempt.
#[test]
fn section_6_9_1_attempts_disabled() {
    let (sim, can, peer) = attempts(RetransmissionAttempts::Disabled, ConHRtxat::Restricted);
    spoil(&sim, can, 1);
    can.send(&sim, 1, &frame("101#11"));
    sim.run_for(FRAME * 3);
    assert_eq!((can.pending(&sim), ids(&sim, peer).len()), (0, 0));
    let status = can.status(&sim, 1);
    assert!(status.contains(pac::FifoSta::TXATIF | pac::FifoSta::TXERR) && !status.txlarb());
    assert!(!status.tferffif(), "the message stays in the FIFO");
    // Asked again it goes out.
    can.regs(&sim).fifo(1).sta().clear(pac::FifoSta::TXATIF);
    can.request(&sim, 1 << 1);
    sim.run_for(FRAME);
    assert_eq!(ids(&sim, peer), [0x101]);
    assert!(!can.status(&sim, 1).txatif());
}

/// 6.9.1: lost arbitration counts as failure too.
#[test]
fn section_6_9_1_lost_arbitration() {
    let (sim, can, peer) = attempts(RetransmissionAttempts::Disabled, ConHRtxat::Restricted);
    let other = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    sim.peer_send(other, frame("050#"));
    sim.run_for(Time::from_us(20));
    // Both wait for the end of this frame.
    sim.peer_send(peer, frame("051#"));
    can.send(&sim, 1, &frame("101#11"));
    sim.run_for(FRAME * 3);
    assert_eq!(can.pending(&sim), 0);
    assert!(can.status(&sim, 1).contains(pac::FifoSta::TXATIF | pac::FifoSta::TXLARB));
    assert!(!ids(&sim, other).contains(&0x101));
}

/// 6.9.2: three retransmissions after errors; lost arbitration uses none up.
#[test]
fn section_6_9_2_three_attempts() {
    for (spoilt, sent) in [(3, true), (4, false)] {
        let (sim, can, peer) = attempts(RetransmissionAttempts::Three, ConHRtxat::Restricted);
        spoil(&sim, can, spoilt);
        can.send(&sim, 1, &frame("101#11"));
        sim.run_for(FRAME * 8);
        assert_eq!(errors_on_bus(&sim, can), spoilt as usize);
        assert_eq!(ids(&sim, peer).len(), usize::from(sent));
        assert_eq!(can.pending(&sim), 0);
        assert_eq!(can.status(&sim, 1).txatif(), !sent);
    }
}

/// 6.9.2: a message received in between gives all attempts back; so does another FIFO.
#[test]
fn section_6_9_2_attempts_start_anew() {
    let (sim, can, peer) = attempts(RetransmissionAttempts::Three, ConHRtxat::Restricted);
    // One of the seven is the attempt that loses arbitration to the peer.
    spoil(&sim, can, 7);
    can.send(&sim, 1, &frame("101#11"));
    let errors = |count: usize| sim.run_until(FRAME * 9, |sim| errors_on_bus(sim, can) >= count);
    errors(3).unwrap();
    sim.peer_send(peer, frame("010#"));
    sim.run_for(FRAME * 9);
    assert_eq!(ids(&sim, peer), [0x101], "three and three failures, the seventh attempt succeeds");
    assert_eq!(errors_on_bus(&sim, can), 6);
}

/// 6.9, 6.9.3: with RTXAT = 0 TXAT is ignored, and unlimited is unlimited.
#[test]
fn section_6_9_3_unlimited_attempts() {
    for (txat, rtxat) in [
        (RetransmissionAttempts::Disabled, ConHRtxat::Unlimited),
        (RetransmissionAttempts::Unlimited(2), ConHRtxat::Restricted),
        (RetransmissionAttempts::Unlimited(3), ConHRtxat::Restricted),
    ] {
        let (sim, can, peer) = attempts(txat, rtxat);
        spoil(&sim, can, 10);
        can.send(&sim, 1, &frame("101#11"));
        sim.run_for(FRAME * 20);
        assert_eq!(ids(&sim, peer), [0x101]);
        assert!(!can.status(&sim, 1).txatif());
        assert!(can.status(&sim, 1).txerr(), "transmit_status_flags: it met errors while it was sent");
        can.send(&sim, 1, &frame("102#"));
        sim.run_for(FRAME);
        assert!(!can.status(&sim, 1).txerr(), "the next one did not");
    }
}

/// 6.10: before its start of frame a message is aborted; the index stays. FIFOSTA shows TXABT once.
#[test]
fn section_6_10_abort_of_a_waiting_fifo() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX8));
    sim.peer_send(peer, frame("050#0011223344556677"));
    sim.run_for(Time::from_us(20));
    ["101#", "102#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
    can.request(&sim, 1 << 1);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_txreq(false));
    assert_eq!(can.pending(&sim), 0);
    let status = can.status(&sim, 1);
    assert!(status.txabt());
    assert_eq!(status.fifoci(), 0);
    assert!(!can.status(&sim, 1).txabt(), "Register 3-34: any read clears it");
    sim.run_for(FRAME * 3);
    assert_eq!(ids(&sim, peer), []);
    can.request(&sim, 1 << 1);
    sim.run_for(FRAME * 3);
    assert_eq!(ids(&sim, peer), [0x101, 0x102], "the messages are still there");
    assert_eq!(sim.diagnostics(), []);
}

/// 6.10: a frame on the bus is not stopped; TXREQ stays until it is sent, what is behind it is aborted.
#[test]
fn section_6_10_abort_on_the_bus() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX8));
    ["101#", "102#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
    can.request(&sim, 1 << 1);
    sim.run_for(Time::from_us(20));
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_txreq(false));
    assert!(con.read().txreq(), "still being sent");
    sim.run_for(FRAME * 3);
    assert_eq!(can.pending(&sim), 0);
    assert_eq!(ids(&sim, peer), [0x101]);
    let status = can.status(&sim, 1);
    assert!(!status.txabt() && status.fifoci() == 1);
    // An error during the frame ends it for good.
    spoil(&sim, can, 1);
    can.request(&sim, 1 << 1);
    sim.run_for(Time::from_us(20));
    con.write(con.read().with_txreq(false));
    sim.run_for(FRAME * 2);
    assert_eq!(ids(&sim, peer), [0x101]);
    let status = can.status(&sim, 1);
    assert!(status.txabt() && status.txerr() && status.fifoci() == 1);
}

/// 6.10: ABAT aborts everything and falls by itself; TXABT of the queue survives a read.
#[test]
fn section_6_10_abort_all() {
    let (sim, can, peer) = bench(|sim, can| {
        can.queue(sim, TX8);
        can.tx_fifo(sim, 1, TX8);
        can.tx_fifo(sim, 2, TX8);
    });
    can.send(&sim, 2, &frame("200#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 1, &frame("100#"));
    can.send(&sim, 0, &frame("300#"));
    can.con_h(&sim, |con_h| con_h.with_abat(true));
    assert!(can.regs(&sim).con_h().read().abat(), "a frame is on the bus");
    assert_eq!(can.pending(&sim), 1 << 2);
    can.request(&sim, 1 << 1);
    assert_eq!(can.pending(&sim), 1 << 2, "no new request while ABAT is set");
    sim.run_for(FRAME * 3);
    assert!(!can.regs(&sim).con_h().read().abat());
    assert_eq!(ids(&sim, peer), [0x200]);
    assert!(can.status(&sim, 1).txabt() && !can.status(&sim, 2).txabt());
    assert!(can.regs(&sim).txqsta().read().txabt() && can.regs(&sim).txqsta().read().txabt());
    // The write of 0 that 6.10 asks for does no harm.
    can.con_h(&sim, |con_h| con_h.with_abat(false));
    can.request(&sim, 0b011);
    sim.run_for(FRAME * 3);
    assert_eq!(ids(&sim, peer), [0x200, 0x300, 0x100]);
    assert!(!can.regs(&sim).txqsta().read().txabt(), "renewed by the message that was sent");
}

/// 6.12: a DLC above the payload size is not sent; a smaller one is sent as it is. A classic DLC above 8 means 8.
#[test]
fn section_6_12_dlc_mismatch() {
    let (sim, can, peer) = bench(|sim, can| {
        can.events(sim, 4, false);
        can.tx_fifo(sim, 1, TX8);
    });
    can.send(&sim, 1, &fd(0x101, &[0; 12]));
    sim.run_for(FRAME);
    assert_eq!(can.pending(&sim), 0);
    assert!(can.flags(&sim).ivmif() && can.diagnosis(&sim).dlcmm());
    assert_eq!(ids(&sim, peer), []);
    assert!(!can.regs(&sim).tefsta().read().tefneif(), "event_for_dlc_mismatch");
    can.reset(&sim, 1);
    let long =
        Frame::data_with_dlc(StandardId::new(0x102).unwrap(), can_frame::Dlc::new(15).unwrap(), &[1; 8]).unwrap();
    can.send(&sim, 1, &long);
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(peer)[0].1, long);
}

/// 5.2.5, table 6-1: ESI of the object counts in gateway mode only.
#[test]
fn gateway_mode() {
    for (esigm, expected) in [(ConHEsigm::ErrorState, false), (ConHEsigm::Gateway, true)] {
        let (sim, can, peer) = bench(|sim, can| {
            can.tx_fifo(sim, 1, TX64);
            can.con_h(sim, |con_h| con_h.with_esigm(esigm));
        });
        can.load_with(&sim, 1, &fd(0x100, &[1]), |t2| t2.with_esi(ErrorState::ErrorPassive));
        can.request(&sim, 1 << 1);
        sim.run_for(FRAME);
        assert_eq!(sim.peer_received(peer)[0].1.error_state_indicator(), expected);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_error_counters(node, 130, 0));
        can.send(&sim, 1, &fd(0x101, &[1]));
        sim.run_for(FRAME);
        assert!(sim.peer_received(peer)[1].1.error_state_indicator(), "error passive shows in both modes");
    }
}

/// Register 3-1: BRSDIS.
#[test]
fn brsdis_keeps_the_nominal_rate() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX64));
    let con = can.regs(&sim).con_l();
    con.write(con.read().with_brsdis(true));
    can.send(&sim, 1, &fd(0x100, &[1; 8]));
    sim.run_for(FRAME);
    let (_, received) = sim.peer_received(peer)[0];
    assert!(received.is_fd() && !received.bit_rate_switch());
}

/// 2.1: a non-ISO frame is an error for an ISO node, and the other way round.
#[test]
fn non_iso_crc() {
    for iso in [true, false] {
        let (sim, can, peer) = bench(|sim, can| {
            can.tx_fifo(sim, 1, TX64);
            let con = can.regs(sim).con_l();
            let crc = dspic33_canfd_pac::enums::ConLIsocrcen::from_bits(u8::from(iso));
            con.write(con.read().with_isocrcen(crc));
        });
        can.send(&sim, 1, &fd(0x100, &[1; 8]));
        sim.run_for(FRAME);
        assert_eq!(ids(&sim, peer).len(), usize::from(iso), "the peer is an ISO node");
    }
}

/// Register 3-8, 8.2.4: the twelfth identifier bit is the RRS bit of CAN FD base frames.
#[test]
fn twelve_bit_identifiers_are_sent_in_rrs() {
    for enabled in [false, true] {
        let (sim, can, peer) = bench(|sim, can| {
            can.tx_fifo(sim, 1, TX64);
            can.regs(sim).tdc_h().write(pac::TdcH::from_bits(0).with_sid11en(enabled));
        });
        let message = fd(0x100, &[1; 8]).with_remote_request_substitution(true);
        can.send(&sim, 1, &message);
        sim.run_for(FRAME);
        assert_eq!(sim.peer_received(peer)[0].1.remote_request_substitution(), enabled);
    }
}

/// Table 7-1: events hold the header and the sequence number, in the order of transmission; timestamps if asked.
#[test]
fn table_7_1_events() {
    for stamped in [false, true] {
        let (sim, can, _) = bench(|sim, can| {
            can.events(sim, 5, stamped);
            can.tx_fifo(sim, 1, TxFifo { depth: 5, size: PayloadSize::Bytes64, priority: 0 });
        });
        can.regs(&sim).tscon_h().write(pac::TsconH::from_bits(0).with_tbcen(true));
        for number in 0..5 {
            let at = (can.user_address(&sim, 1) - BASE) as usize;
            can.load(&sim, 1, &fd(0x300, &[number; 64]));
            TxObject::new(can.memory(&sim), at).write_seq(0x12_3450 + u32::from(number));
        }
        can.request(&sim, 1 << 1);
        sim.run_for(FRAME * 6);
        let mut before = 0;
        for number in 0..5 {
            let at = (can.regs(&sim).read_tefua() - BASE) as usize;
            let event = TefObject::new(can.memory(&sim), at);
            assert_eq!(event.read_seq(), 0x12_3450 + number);
            assert_eq!((event.te0().read().bits(), event.te2().read().bits() & 0x1FF), (0x300, 0x0CF));
            if stamped {
                let time = TefObjectTs::new(can.memory(&sim), at).read_txmsgts();
                assert!(time > before);
                before = time;
            }
            can.release_event(&sim);
        }
        assert!(!can.regs(&sim).tefsta().read().tefneif());
        assert_eq!(sim.diagnostics(), []);
    }
}

/// 5.2.7: without TXQEN and STEF neither exists.
#[test]
fn queue_and_events_can_be_left_out() {
    let (sim, can, peer) = bench(|sim, can| can.tx_fifo(sim, 1, TX8));
    can.send(&sim, 1, &frame("100#"));
    can.increment(&sim, 0, true);
    sim.run_for(FRAME);
    assert_eq!(ids(&sim, peer), [0x100]);
    assert_eq!(can.regs(&sim).tefsta().read().bits(), 0);
    let ignored = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::IncrementIgnored { depth: 0, .. });
    assert!(kinds(&sim).iter().all(ignored));
}

/// 5.3.3: transmitter delay compensation lets a data phase pass whose bits come back late.
#[test]
fn transmitter_delay_compensation() {
    for (mode, expected) in [(0, false), (1, true), (2, true), (3, true)] {
        let sim = Sim::new();
        let can = crate::bench::add_with(&sim, "can0", |mut config| {
            (config.place.tx_delay, config.place.rx_delay) = (Time::from_ns(120), Time::from_ns(120));
            config
        });
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        can.configure(&sim);
        can.tx_fifo(&sim, 1, TX64);
        let tdc = dspic33_canfd_pac::enums::TdcHTdcmod::from_bits(mode);
        can.regs(&sim).tdc_h().write(pac::TdcH::from_bits(0).with_tdcmod(tdc));
        // Data sample point after 6 of 8 clock periods; 240 ns are 10 periods.
        can.regs(&sim).tdc_l().write(pac::TdcL::from_bits(0).with_tdco(6).with_tdcv(10));
        can.start(&sim);
        can.send(&sim, 1, &fd(0x100, &[0x5A; 16]));
        sim.run_for(FRAME);
        assert_eq!(!ids(&sim, peer).is_empty(), expected, "TDCMOD {mode}");
        assert_eq!(can.diagnosis(&sim).bits() & 0x0300 != 0, !expected, "bit errors in the data phase");
    }
}
