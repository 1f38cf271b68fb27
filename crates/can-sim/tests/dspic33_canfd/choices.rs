//! The named choices that no chapter's tests take both ways, and determinism.

use crate::bench::{BASE, FRAME, Mode, TX8, choices, fd, frame, ids, kinds, pair_with};
use can_sim::{DiagnosticKind, Time, dspic33_canfd::Choices};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use dspic33_canfd_pac::{
    enums::{ConHRtxat, PayloadSize, RetransmissionAttempts, TdcHTdcmod},
    registers as pac,
};

fn with(change: impl FnOnce(&mut Choices)) -> (can_sim::Sim, crate::bench::Can, can_sim::PeerId) {
    let choices = choices(change);
    pair_with(|config| config.with_choices(choices))
}

#[test]
fn mode_change_moment() {
    for (after_integration, expected) in [(true, Mode::Configuration), (false, Mode::NormalCanFd)] {
        let (sim, can, _) = with(|choices| choices.mode_after_integration = after_integration);
        can.ask(&sim, Mode::NormalCanFd);
        sim.run_for(Time::from_us(1));
        assert_eq!(can.mode(&sim), expected);
    }
}

#[test]
fn illegal_mode_request() {
    for allowed in [false, true] {
        let (sim, can, _) = with(|choices| choices.normal_to_debug = allowed);
        can.start(&sim);
        can.ask(&sim, Mode::ListenOnly);
        sim.run_for(FRAME);
        assert_eq!(can.mode(&sim), if allowed { Mode::ListenOnly } else { Mode::NormalCanFd });
        assert_eq!(kinds(&sim).is_empty(), allowed);
    }
}

/// `uinc_beyond_limits`: a receive FIFO whose tail runs past its head shows messages that never were.
#[test]
fn uinc_beyond_limits() {
    for checked in [true, false] {
        let (sim, can, _) = with(|choices| choices.uinc_is_checked = checked);
        can.tx_fifo(&sim, 1, TX8);
        can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
        can.start(&sim);
        can.increment(&sim, 2, false);
        assert_eq!(can.has_message(&sim, 2), !checked);
        (0..4).for_each(|_| can.load(&sim, 1, &frame("100#")));
        can.increment(&sim, 1, false);
        assert_eq!(can.status(&sim, 1).tfnrfnif(), !checked, "head past tail: the full FIFO holds one message");
        let ignored = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::IncrementIgnored { .. });
        assert_eq!(kinds(&sim).iter().filter(|kind| ignored(kind)).count(), 2);
    }
}

#[test]
fn three_attempts() {
    for total in [3, 4] {
        let (sim, can, _) = with(|choices| choices.three_attempts = total);
        can.tx_fifo(&sim, 1, TX8);
        can.con_h(&sim, |con_h| con_h.with_rtxat(ConHRtxat::Restricted));
        let size = can.regs(&sim).fifo(1).con_h();
        size.write(size.read().with_txat(RetransmissionAttempts::Three));
        can.start(&sim);
        let node = sim.node(can.id);
        let (fault, position) = (BitFault::InvertSeen, Position::new(Field::Crc, 3));
        sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault, position, frames: Frames::all() }));
        can.send(&sim, 1, &frame("100#"));
        sim.run_for(FRAME * 10);
        assert_eq!(can.regs(&sim).bdiag0_l().read().nterrcnt(), total);
    }
}

#[test]
fn one_shot_with_several_messages() {
    for ends in [false, true] {
        let (sim, can, peer) = with(|choices| choices.one_shot_ends_request = ends);
        can.tx_fifo(&sim, 1, TX8);
        can.con_h(&sim, |con_h| con_h.with_rtxat(ConHRtxat::Restricted));
        let size = can.regs(&sim).fifo(1).con_h();
        size.write(size.read().with_txat(RetransmissionAttempts::Disabled));
        can.start(&sim);
        ["100#", "101#"].iter().for_each(|text| can.load(&sim, 1, &frame(text)));
        can.request(&sim, 1 << 1);
        sim.run_for(FRAME * 3);
        assert_eq!(ids(&sim, peer).len(), if ends { 1 } else { 2 });
        assert_eq!(can.pending(&sim), 0);
    }
}

#[test]
fn event_for_dlc_mismatch() {
    for stored in [false, true] {
        let (sim, can, _) = with(|choices| choices.event_for_dlc_mismatch = stored);
        can.events(&sim, 2, false);
        can.tx_fifo(&sim, 1, TX8);
        can.start(&sim);
        can.send(&sim, 1, &fd(0x100, &[0; 64]));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).tefsta().read().tefneif(), stored);
    }
}

#[test]
fn measured_delay() {
    for shown in [false, true] {
        let sim = can_sim::Sim::new();
        let choices = choices(|choices| choices.measured_delay_is_shown = shown);
        let can = crate::bench::add_with(&sim, "can0", |mut config| {
            (config.place.tx_delay, config.place.rx_delay) = (Time::from_ns(100), Time::from_ns(100));
            config.with_choices(choices)
        });
        sim.add_peer(can_wire::NodeConfig::new()).unwrap();
        can.configure(&sim);
        can.tx_fifo(&sim, 1, crate::bench::TX64);
        can.regs(&sim).tdc_h().write(pac::TdcH::from_bits(0).with_tdcmod(TdcHTdcmod::from_bits(2)));
        can.regs(&sim).tdc_l().write(pac::TdcL::from_bits(0).with_tdco(6));
        can.start(&sim);
        can.send(&sim, 1, &fd(0x100, &[1; 8]));
        sim.run_for(FRAME);
        let found = can.regs(&sim).tdc_l().read().tdcv();
        assert!(if shown { (8..=9).contains(&found) } else { found == 0 }, "{found}");
    }
}

#[test]
fn data_filter_with_both_formats() {
    use dspic33_canfd_pac::enums::ConLDncnt;
    for needs in [false, true] {
        let (sim, can, peer) = with(|choices| choices.data_filter_needs_standard = needs);
        can.rx_fifo(&sim, 1, 4, PayloadSize::Bytes8);
        let con = can.regs(&sim).con_l();
        con.write(con.read().with_dncnt(ConLDncnt::from_bits(8).unwrap()));
        can.filter(&sim, 0, 0, 0x1FFF_F800, 1);
        can.start(&sim);
        sim.peer_send(peer, frame("100#FF"));
        sim.run_for(FRAME);
        assert_eq!(can.has_message(&sim, 1), needs);
    }
}

/// The same calls give the same run.
#[test]
fn runs_are_deterministic() {
    let run = || {
        let (sim, can, peer) = with(|_| ());
        can.tx_fifo(&sim, 1, TX8);
        can.rx_fifo(&sim, 2, 8, PayloadSize::Bytes8);
        can.accept_all(&sim, 2);
        can.start(&sim);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_noise(node, 0.001, 5));
        for number in 0..20 {
            can.send(&sim, 1, &frame(&format!("1{number:02}#")));
            sim.peer_send(peer, frame(&format!("2{number:02}#0011")));
            sim.run_for(FRAME);
            while can.receive(&sim, 2).is_some() {}
        }
        (sim.now(), sim.bus_log(), sim.describe(can.id), can.user_address(&sim, 1) - BASE)
    };
    assert_eq!(run(), run());
}
