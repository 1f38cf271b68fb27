//! Error counters, states, bus off and diagnostics (12.3.1, 12.3.3, 13.0).

use crate::bench::{Can, FRAME, Mode, TX8, TX64, fd, frame, ids, pair, pair_with};
use can_sim::{PeerId, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use dspic33_canfd_pac::{
    enums::{ConLPxedis, PayloadSize},
    registers as pac,
};

fn bench() -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.queue(&sim, TX8);
    can.tx_fifo(&sim, 1, TX64);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes64);
    can.accept_all(&sim, 2);
    can.start(&sim);
    (sim, can, peer)
}

fn hit(sim: &Sim, can: Can, field: Field, bit: u16, frames: Frames) {
    let node = sim.node(can.id);
    let position = Position::new(field, bit);
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
}

fn counters(sim: &Sim, can: Can) -> (u8, u8) {
    let trec = can.regs(sim).trec_l().read();
    (trec.terrcnt(), trec.rerrcnt())
}

/// 13.0: the counters follow ISO 11898-1 over the wire.
#[test]
fn counters_count_transmit_and_receive_errors() {
    let (sim, can, peer) = bench();
    let own = Frames { sender: Some(sim.node(can.id)), skip: 0, count: 3 };
    hit(&sim, can, Field::Crc, 4, own);
    can.send(&sim, 1, &frame("100#1122"));
    sim.run_for(FRAME * 6);
    assert_eq!(counters(&sim, can), (3 * 8 - 1, 0));
    assert_eq!(can.regs(&sim).bdiag0_l().read().nterrcnt(), 3);
    hit(&sim, can, Field::Data, 3, Frames::next());
    sim.peer_send(peer, frame("200#00FF"));
    sim.run_for(FRAME * 2);
    assert!(can.regs(&sim).bdiag0_l().read().nrerrcnt() >= 1);
    assert!(can.flags(&sim).ivmif());
    assert_eq!(ids(&sim, peer), [0x100]);
}

/// Registers 3-44, 3-45, 12.3.3: warning from 96, passive from 128, each with CERRIF; warning ends where passive begins.
#[test]
fn section_12_3_3_thresholds() {
    for transmitter in [true, false] {
        let (sim, can, _) = bench();
        let node = sim.node(can.id);
        let set = |count: u16| {
            let (tec, rec) = if transmitter { (count, 0) } else { (0, count) };
            sim.with_wire(|wire| wire.set_error_counters(node, tec, rec));
            sim.run_for(Time::from_us(1));
            let states = can.regs(&sim).trec_h().read();
            let raised = can.flags(&sim).cerrif();
            can.clear(&sim, pac::IntL::CERRIF);
            (states, raised)
        };
        use pac::TrecH as S;
        let (warn, passive) = if transmitter { (S::TXWARN, S::TXBP) } else { (S::RXWARN, S::RXBP) };
        let none = S::from_bits(0);
        for (count, states, raised) in [
            (95, none, false),
            (96, warn | S::EWARN, true),
            (97, warn | S::EWARN, false),
            (127, warn | S::EWARN, false),
            (128, passive, true),
            (200, passive, false),
            (127, warn | S::EWARN, true),
            (95, none, false),
        ] {
            assert_eq!(set(count), (states, raised), "{count}");
        }
    }
}

/// 13.1: bus off over the wire: TXBO, CERRIF, FRESET of the transmit FIFOs and the queue; 128 idle conditions later the
/// module is back by itself.
#[test]
fn section_13_1_bus_off_and_recovery() {
    let (sim, can, peer) = bench();
    let node = sim.node(can.id);
    hit(&sim, can, Field::Crc, 2, Frames { sender: Some(node), skip: 0, count: 1000 });
    can.send(&sim, 0, &frame("300#"));
    can.send(&sim, 1, &frame("100#1122"));
    sim.run_until(FRAME * 100, |sim| can.regs(sim).trec_h().read().txbo()).unwrap();
    sim.with_wire(|wire| wire.clear_faults());
    assert_eq!(can.pending(&sim), 0);
    assert!(can.status(&sim, 1).tferffif() && can.regs(&sim).txqsta().read().txqeif(), "the messages are gone");
    assert!(!can.regs(&sim).fifo(1).con_l().read().freset(), "the resets are done");
    assert!(can.flags(&sim).cerrif());
    // error_counter_in_bus_off: 248 and 8 more are 256.
    assert_eq!(counters(&sim, can).0, 0);
    can.clear(&sim, pac::IntL::CERRIF);
    can.send(&sim, 1, &frame("101#"));
    let began = sim.now();
    sim.run_for(FRAME);
    assert!(can.diagnosis(&sim).nbit0err(), "Register 3-49: every eleven bits");
    assert_eq!(ids(&sim, peer), []);
    sim.run_until(Time::from_ms(5), |sim| !can.regs(sim).trec_h().read().txbo()).unwrap();
    let bits = sim.now().since(began).as_ps() / 1_000_000;
    assert!((128 * 11 - 20..=128 * 11 + 20).contains(&bits), "{bits} bits");
    assert!(can.flags(&sim).cerrif() && can.diagnosis(&sim).txboerr());
    assert_eq!(counters(&sim, can), (0, 0));
    sim.run_for(FRAME);
    assert_eq!(ids(&sim, peer), [0x101], "what was queued meanwhile is sent");
    assert_eq!(sim.diagnostics(), []);
}

/// `bus_off_queue_reset`, `error_counter_in_bus_off`: the other readings.
#[test]
fn bus_off_choices() {
    let (sim, can, _) = pair_with(|config| {
        config.with_choices(crate::bench::choices(|choices| {
            (choices.bus_off_resets_queue, choices.bus_off_reads_255) = (false, true);
        }))
    });
    can.queue(&sim, TX8);
    can.start(&sim);
    let node = sim.node(can.id);
    hit(&sim, can, Field::Crc, 2, Frames { sender: Some(node), skip: 0, count: 1000 });
    can.send(&sim, 0, &frame("300#"));
    sim.run_until(FRAME * 100, |sim| can.regs(sim).trec_h().read().txbo()).unwrap();
    assert_eq!(counters(&sim, can).0, 255);
    assert_eq!(can.pending(&sim), 1);
}

/// 13.1: Configuration mode ends bus off; Disable mode keeps it.
#[test]
fn bus_off_and_modes() {
    let (sim, can, _) = bench();
    let node = sim.node(can.id);
    let go_off = || {
        hit(&sim, can, Field::Crc, 2, Frames { sender: Some(node), skip: 0, count: 1000 });
        can.send(&sim, 1, &frame("100#1122"));
        sim.run_until(FRAME * 100, |sim| can.regs(sim).trec_h().read().txbo()).unwrap();
        sim.with_wire(|wire| wire.clear_faults());
    };
    go_off();
    can.go(&sim, Mode::Disable);
    can.start(&sim);
    assert!(can.regs(&sim).trec_h().read().txbo());
    sim.run_for(Time::from_ms(3));
    assert!(!can.regs(&sim).trec_h().read().txbo(), "it recovers after Disable mode");
    go_off();
    can.go(&sim, Mode::Configuration);
    can.start(&sim);
    assert!(!can.regs(&sim).trec_h().read().txbo());
    assert_eq!(counters(&sim, can), (0, 0));
}

/// Register 3-49: every kind of error in its phase.
#[test]
fn kinds_of_errors() {
    use pac::Bdiag1H as D;
    let long = fd(0x155, &[0x00, 0xFF, 0xAA, 0x55, 0, 0, 0, 0]);
    for (own, message, field, bit, flag) in [
        (false, frame("100#00FF"), Field::Crc, 7, D::NCRCERR),
        (false, frame("100#AA55"), Field::CrcDelimiter, 0, D::NFORMERR),
        (false, frame("100#AA55"), Field::Eof, 2, D::NFORMERR),
        (true, frame("100#AA55"), Field::AckSlot, 0, D::NACKERR),
        (true, frame("100#AA55"), Field::Data, 0, D::NBIT1ERR),
        (true, frame("100#AA55"), Field::Data, 1, D::NBIT0ERR),
        (true, long, Field::Data, 8, D::DBIT1ERR),
        (true, long, Field::Data, 17, D::DBIT0ERR),
    ] {
        let (sim, can, peer) = bench();
        // A third node acknowledges what this one finds wrong.
        sim.add_peer(can_wire::NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        hit(&sim, can, field, bit, Frames::next());
        if own {
            can.send(&sim, 1, &message);
        } else {
            sim.peer_send(peer, message);
        }
        sim.run_for(FRAME * 3);
        let found = can.diagnosis(&sim);
        assert!(found.contains(flag), "{flag:?} at {field:?} {bit}: {found:?}\n{:?}", sim.bus_log());
        assert!(can.flags(&sim).ivmif());
        // 13.0: cleared by writing 0.
        can.regs(&sim).bdiag1_h().write(pac::Bdiag1H::from_bits(0));
        assert_eq!(can.diagnosis(&sim).bits(), 0);
    }
}

/// Register 3-48: messages without error, both ways.
#[test]
fn error_free_messages_are_counted() {
    let (sim, can, peer) = bench();
    for _ in 0..3 {
        can.send(&sim, 1, &frame("100#"));
        sim.peer_send(peer, frame("200#"));
        sim.run_for(FRAME);
    }
    assert_eq!(can.regs(&sim).bdiag1_l().read().efmsgcnt(), 6);
    can.regs(&sim).bdiag1_l().write(pac::Bdiag1L::from_bits(0));
    assert_eq!(can.regs(&sim).bdiag1_l().read().efmsgcnt(), 0);
}

/// `diagnostic_counter_overflow`: at the largest value they stay, or roll over.
#[test]
fn diagnostic_counters_at_their_end() {
    for wraps in [false, true] {
        let (sim, can, peer) = pair_with(|config| {
            config.with_choices(crate::bench::choices(|choices| choices.diagnostic_counters_wrap = wraps))
        });
        can.start(&sim);
        can.regs(&sim).bdiag1_l().write(pac::Bdiag1L::from_bits(0xFFFF));
        sim.peer_send(peer, frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).bdiag1_l().read().bits(), if wraps { 0 } else { 0xFFFF });
    }
}

/// 5.2.2, `protocol_exception_wording`: a recessive res bit is a form error or sends the module to bus integration.
#[test]
fn protocol_exception() {
    for (pxedis, is_error) in [(ConLPxedis::FormError, true), (ConLPxedis::BusIntegration, false)] {
        let (sim, can, peer) = pair();
        let con = can.regs(&sim).con_l();
        con.write(con.read().with_pxedis(pxedis));
        can.start(&sim);
        hit(&sim, can, Field::Res, 0, Frames::next());
        sim.peer_send(peer, fd(0x100, &[1; 8]));
        sim.run_for(FRAME);
        assert_eq!(can.diagnosis(&sim).nformerr(), is_error);
        assert_eq!(can.flags(&sim).ivmif(), is_error);
    }
}

/// Register 3-8: with EDGFLTEN a dominant glitch shorter than two time quanta does not disturb bus integration.
#[test]
fn edge_filtering_during_bus_integration() {
    let integration = |filtered: bool| {
        let (sim, can, _) = pair();
        can.regs(&sim).tdc_h().write(pac::TdcH::from_bits(0).with_edgflten(filtered));
        let node = sim.node(can.id);
        let asked = sim.now();
        // A glitch of one clock period between the sample points, every five bits.
        for number in 1..=4_u64 {
            let from = asked + Time::from_us(5) * number;
            let (until, how) = (from + Time::from_ns(25), can_wire::Disturbance::Dominant);
            sim.with_wire(|wire| wire.inject(Fault::Disturb { line: can_wire::Line::Rx(node), how, from, until }));
        }
        can.ask(&sim, Mode::NormalCanFd);
        can.wait(&sim, Mode::NormalCanFd);
        sim.now().since(asked).as_ps() / 1_000_000
    };
    let (with, without) = (integration(true), integration(false));
    assert!(with <= 13 && without >= 30, "{with} and {without} bits");
}
