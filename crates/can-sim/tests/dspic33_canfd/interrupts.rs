//! The layers of interrupts and their codes (12.0).

use crate::bench::{Can, FRAME, Mode, TX8, TxFifo, add, frame, pair, pair_with};
use can_sim::{PeerId, Sim, Time};
use can_wire::NodeConfig;
use dspic33_canfd_pac::{
    enums::{ConHRtxat, PayloadSize, RetransmissionAttempts},
    registers as pac,
};

const RECEIVE: usize = 0;
const TRANSMIT: usize = 1;
const INFORMATION: usize = 2;

fn bench() -> (Sim, Can, PeerId) {
    let (sim, can, peer) = pair();
    can.events(&sim, 2, false);
    can.queue(&sim, TxFifo { depth: 2, ..TX8 });
    can.tx_fifo(&sim, 1, TxFifo { depth: 2, ..TX8 });
    can.rx_fifo(&sim, 20, 2, PayloadSize::Bytes8);
    can.accept_all(&sim, 20);
    can.start(&sim);
    can.clear(&sim, pac::IntL::MODIF);
    (sim, can, peer)
}

fn receive(sim: &Sim, peer: PeerId, count: usize) {
    for _ in 0..count {
        sim.peer_send(peer, frame("123#"));
        sim.run_for(FRAME);
    }
}

fn codes(sim: &Sim, can: Can) -> (u8, u8, u8) {
    let regs = can.regs(sim);
    let (low, high) = (regs.vec_l().read().bits(), regs.vec_h().read().bits());
    ((low & 0x7F) as u8, (high >> 8) as u8, (high & 0x7F) as u8)
}

/// 12.1.2: each state of a receive FIFO with its own enable; 12.2, 12.3: up to RXIF and the receive line.
#[test]
fn section_12_1_2_receive_fifo() {
    for (enable, from) in [(pac::FifoConL::TFNRFNIE, 1), (pac::FifoConL::TFHRFHIE, 1), (pac::FifoConL::TFERFFIE, 2)] {
        let (sim, can, peer) = bench();
        let regs = can.regs(&sim);
        regs.int_h().write(pac::IntH::RXIE);
        regs.fifo(20).con_l().write(enable);
        for count in 1..=2 {
            receive(&sim, peer, 1);
            let expected = count >= from;
            assert_eq!(regs.read_rxif(), u32::from(expected) << 20, "{enable:?} with {count}");
            assert_eq!(can.flags(&sim).rxif(), expected);
            assert_eq!(sim.line(can.id, RECEIVE), expected);
            assert_eq!(codes(&sim, can), if expected { (20, 20, 64) } else { (64, 64, 64) });
        }
        assert!(!sim.line(can.id, TRANSMIT) && !sim.line(can.id, INFORMATION));
        // The flag ends with the state, not by a write.
        can.clear(&sim, pac::IntL::RXIF);
        assert!(can.flags(&sim).rxif());
        (0..2).for_each(|_| assert!(can.receive(&sim, 20).is_some()));
        assert!(!sim.line(can.id, RECEIVE));
    }
}

/// 12.1.1, 12.1.3: a transmit FIFO and the queue.
#[test]
fn section_12_1_3_transmit_fifo_and_queue() {
    let (sim, can, _) = bench();
    let regs = can.regs(&sim);
    regs.int_h().write(pac::IntH::TXIE);
    can.go(&sim, Mode::Disable);
    let enable = |flag: pac::FifoConL| {
        regs.fifo(1).con_l().write(pac::FifoConL::TXEN.union(flag));
        regs.read_txif()
    };
    for (flag, at) in [
        (pac::FifoConL::TFERFFIE, [true, false, false]),
        (pac::FifoConL::TFHRFHIE, [true, true, false]),
        (pac::FifoConL::TFNRFNIE, [true, true, false]),
    ] {
        for (count, expected) in at.into_iter().enumerate() {
            assert_eq!(enable(flag), u32::from(expected) << 1, "{flag:?} with {count}");
            assert_eq!(sim.line(can.id, TRANSMIT), expected);
            if count < 2 {
                can.load(&sim, 1, &frame("100#"));
            }
        }
        regs.fifo(1).con_l().write(pac::FifoConL::TXEN.union(pac::FifoConL::FRESET));
    }
    for (flag, at) in [(pac::TxqconL::TXQEIE, [true, false, false]), (pac::TxqconL::TXQNIE, [true, true, false])] {
        for (count, expected) in at.into_iter().enumerate() {
            regs.txqcon_l().write(flag);
            assert_eq!(regs.read_txif(), u32::from(expected), "{flag:?} with {count}");
            assert_eq!(codes(&sim, can).2, if expected { 0 } else { 64 });
            if count < 2 {
                can.load(&sim, 0, &frame("100#"));
            }
        }
        regs.txqcon_l().write(pac::TxqconL::FRESET);
    }
}

/// 12.1.4, 12.1.5: overflow and exhausted attempts are cleared by the application, in the FIFO.
#[test]
fn section_12_1_4_overflow_and_attempts() {
    let (sim, can, peer) = bench();
    let regs = can.regs(&sim);
    regs.int_h().write(pac::IntH::RXOVIE | pac::IntH::TXATIE);
    regs.fifo(20).con_l().write(pac::FifoConL::RXOVIE);
    receive(&sim, peer, 2);
    assert!(!sim.line(can.id, INFORMATION));
    receive(&sim, peer, 1);
    assert!(sim.line(can.id, INFORMATION));
    assert_eq!((regs.read_rxovif(), codes(&sim, can).0), (1 << 20, 67));
    can.clear(&sim, pac::IntL::RXOVIF);
    assert!(can.flags(&sim).rxovif(), "read-only in INTL");
    regs.fifo(20).sta().clear(pac::FifoSta::RXOVIF);
    assert!(!can.flags(&sim).rxovif() && !sim.line(can.id, INFORMATION));
    // Attempts of the queue and of FIFO 1.
    can.go(&sim, Mode::Configuration);
    can.con_h(&sim, |con_h| con_h.with_rtxat(ConHRtxat::Restricted));
    let size = regs.txqcon_h();
    size.write(size.read().with_txat(RetransmissionAttempts::Disabled));
    can.start(&sim);
    regs.txqcon_l().write(pac::TxqconL::TXATIE);
    let node = sim.peer_node(peer);
    sim.with_wire(|wire| wire.inject(can_wire::Fault::DropAck { node, frames: can_wire::Frames::all() }));
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!((regs.read_txatif(), codes(&sim, can).0), (1, 74));
    assert!(sim.line(can.id, INFORMATION));
    regs.txqsta().clear(pac::Txqsta::TXATIF);
    assert!(!sim.line(can.id, INFORMATION));
}

/// 12.1.6: the four states of the event FIFO.
#[test]
fn section_12_1_6_event_fifo() {
    for (enable, from) in
        [(pac::TefconL::TEFNEIE, 1), (pac::TefconL::TEFHIE, 1), (pac::TefconL::TEFFIE, 2), (pac::TefconL::TEFOVIE, 3)]
    {
        let (sim, can, _) = bench();
        let regs = can.regs(&sim);
        regs.int_h().write(pac::IntH::TEFIE);
        regs.tefcon_l().write(enable);
        for count in 1..=3 {
            can.send(&sim, 1, &frame("100#"));
            sim.run_for(FRAME);
            assert_eq!(sim.line(can.id, INFORMATION), count >= from, "{enable:?} with {count}");
            assert_eq!(codes(&sim, can).0, if count >= from { 73 } else { 64 });
        }
        regs.tefsta().clear(pac::Tefsta::TEFOVIF);
        (0..2).for_each(|_| can.release_event(&sim));
        assert!(!sim.line(can.id, INFORMATION));
    }
}

/// 12.3.4, Register 3-15: MODIF.
#[test]
fn section_12_3_4_mode_change() {
    let (sim, can, _) = bench();
    can.regs(&sim).int_h().write(pac::IntH::MODIE);
    assert!(!sim.line(can.id, INFORMATION));
    can.go(&sim, Mode::Disable);
    assert!(sim.line(can.id, INFORMATION));
    assert_eq!(codes(&sim, can).0, 71);
    can.clear(&sim, pac::IntL::MODIF);
    assert!(!sim.line(can.id, INFORMATION));
}

/// 12.4.1: of several pending interrupts the highest number shows.
#[test]
fn section_12_4_1_highest_number_shows() {
    let (sim, can, peer) = bench();
    let regs = can.regs(&sim);
    regs.int_h().write(pac::IntH::from_bits(0xFC1F));
    regs.fifo(20).con_l().write(pac::FifoConL::TFNRFNIE | pac::FifoConL::RXOVIE);
    regs.fifo(1).con_l().write(pac::FifoConL::TXEN | pac::FifoConL::TFNRFNIE);
    regs.txqcon_l().write(pac::TxqconL::TXQNIE);
    assert_eq!(codes(&sim, can), (1, 64, 1));
    receive(&sim, peer, 1);
    assert_eq!(codes(&sim, can), (20, 20, 1));
    receive(&sim, peer, 2);
    assert_eq!(codes(&sim, can), (67, 20, 1), "overflow");
    can.go(&sim, Mode::Disable);
    assert_eq!(codes(&sim, can).0, 71, "mode change");
    can.clear(&sim, pac::IntL::MODIF);
    regs.fifo(20).sta().clear(pac::FifoSta::RXOVIF);
    (0..2).for_each(|_| assert!(can.receive(&sim, 20).is_some()));
    assert_eq!(codes(&sim, can), (1, 64, 1));
}

/// `icode_gating`, `combined_flag_gating`: both readings.
#[test]
fn gating_of_codes_and_combined_flags() {
    for gated in [true, false] {
        let (sim, can, peer) = pair_with(|config| {
            config.with_choices(crate::bench::choices(|choices| {
                (choices.icode_is_gated, choices.combined_flags_are_gated) = (gated, gated);
            }))
        });
        can.rx_fifo(&sim, 20, 1, PayloadSize::Bytes8);
        can.accept_all(&sim, 20);
        can.start(&sim);
        assert_eq!(codes(&sim, can).0, if gated { 64 } else { 71 });
        can.clear(&sim, pac::IntL::MODIF);
        receive(&sim, peer, 2);
        assert_eq!(can.regs(&sim).read_rxovif(), if gated { 0 } else { 1 << 20 });
        assert_eq!(can.flags(&sim).rxovif(), !gated);
    }
}

/// Register 3-10, 12.3.5: the rollover of the Time Base Counter.
#[test]
fn section_12_3_5_timer() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    sim.add_peer(NodeConfig::new()).unwrap();
    let regs = can.regs(&sim);
    regs.tbc_l().write(pac::TbcL::from_bits(0xFF00));
    regs.tbc_h().write(pac::TbcH::from_bits(0xFFFF));
    regs.int_h().write(pac::IntH::TBCIE);
    regs.tscon_h().write(pac::TsconH::TBCEN);
    let started = sim.now();
    let rolled = sim.run_until(Time::from_us(20), |sim| sim.line(can.id, INFORMATION)).unwrap();
    assert_eq!(rolled.since(started), Time::from_ns(6_400), "256 periods of 25 ns");
    assert_eq!(codes(&sim, can).0, 70);
    can.clear(&sim, pac::IntL::TBCIF);
    assert!(!sim.line(can.id, INFORMATION));
}
