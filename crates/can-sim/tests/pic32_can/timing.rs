//! Chapter 34.10: bit timing, Examples 34-16 and 34-17.

use can_sim::{DiagnosticKind, Sim, Time};
use can_wire::{BitTiming, NodeConfig};
use pic32_can_pac::{
    enums::{CfgSam, CfgSeg2phts},
    registers::Cfg,
};

use crate::bench::*;

/// 34-16, 34-17 at 80 MHz: BRP 3 follows from 10 MHz (time_quantum_frequency); the printed register value has a jump width
/// of 3 quanta, that of the comment is 2 (sjw_of_two_quanta).
#[test]
fn examples_34_16_and_34_17() {
    let printed = Cfg::RESET
        .with_seg2phts(CfgSeg2phts::Programmable)
        .with_seg2ph(2)
        .with_seg1ph(2)
        .with_prseg(2)
        .with_sam(CfgSam::ThreeTimes)
        .with_sjw(2)
        .with_brp(3);
    assert_eq!((printed.bits(), CFG.bits()), (0x0002_D283, 0x0002_D243));
    for cfg in [printed, CFG] {
        let timing = timing_of(cfg);
        assert_eq!(timing.bit_rate(80_000_000), 1_000_000);
        assert_eq!((timing.quanta(), timing.sample_point_permille()), (10, 700));
    }
}

/// The timing that the node gets from a register value.
fn timing_of(cfg: Cfg) -> BitTiming {
    let (sim, can) = started(cfg);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.config(node).nominal)
}

fn started(cfg: Cfg) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[Use::Tx(1), Use::Rx(1)]);
    can.regs(&sim).cfg().write(cfg);
    can.start(&sim);
    (sim, can)
}

/// Equation 34-2 at 80 MHz: rate, quanta, BRP.
#[test]
fn equation_34_2() {
    for (rate, quanta, brp) in
        [(500_000, 16, 4), (500_000, 10, 7), (250_000, 16, 9), (125_000, 16, 19), (1_000_000, 8, 4), (1_000_000, 20, 1)]
    {
        let cfg = with_quanta(quanta).with_brp(brp);
        let timing = timing_of(cfg);
        assert_eq!((timing.bit_rate(80_000_000), timing.quanta()), (rate, u64::from(quanta)));
    }
}

fn with_quanta(quanta: u8) -> Cfg {
    let second = (quanta / 4).max(2);
    let first = second.max((quanta - 1 - second) / 2);
    let propagation = quanta - 1 - second - first;
    let cfg = Cfg::RESET.with_seg2phts(CfgSeg2phts::Programmable).with_seg2ph(second - 1);
    cfg.with_seg1ph(first - 1).with_prseg(propagation - 1).with_sjw(0)
}

/// A module and a plain node of another clock understand each other.
#[test]
fn traffic_at_every_rate() {
    for (rate, cfg) in
        [(125_000, with_quanta(16).with_brp(19)), (500_000, with_quanta(16).with_brp(4)), (1_000_000, CFG)]
    {
        let (sim, can) = started(cfg);
        let mut config = NodeConfig::new();
        config.nominal = BitTiming::for_rate(config.clock_hz, rate, 750).unwrap();
        let peer = sim.add_peer(config).unwrap();
        sim.run_for(Time::from_us(200));
        can.send(&sim, 0, &frame("123#1122334455667788"));
        sim.run_for(Time::from_ms(2));
        assert_eq!(heard(&sim, peer), ["123#1122334455667788"], "{rate}");
        assert_eq!(can.regs(&sim).trec().read().bits(), 0);
    }
}

/// segment2_automatic: as long as phase segment 1, at least 2 quanta.
#[test]
fn automatic_phase_segment_2() {
    let cfg = CFG.with_seg2phts(CfgSeg2phts::Automatic).with_seg2ph(0);
    assert_eq!(timing_of(cfg).phase_seg2, 3);
    assert_eq!(timing_of(cfg.with_seg1ph(0).with_prseg(7)).phase_seg2, 2);
}

/// Register 34-2, 34.10.4: each rule, broken.
#[test]
fn rules() {
    let broken = [
        (CFG.with_seg2ph(3), "phase segment 2"),
        (CFG.with_sjw(3), "jump width"),
        (CFG.with_brp(1).with_prseg(7).with_seg1ph(7), "three samples"),
        (CFG.with_prseg(0).with_seg1ph(1).with_seg2ph(1), "quanta"),
        (CFG.with_brp(2), "bit/s"),
    ];
    for (cfg, what) in broken {
        let (sim, _) = started(cfg);
        let found = kinds(&sim);
        let said =
            |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::Contradiction { what: said } if said.contains(what));
        assert!(found.iter().any(said), "{what}: {found:?}");
    }
    let (sim, _) = started(CFG);
    assert_eq!(sim.diagnostics(), []);
    let (sim, _) = started(CFG.with_sjw(2));
    assert_eq!(sim.diagnostics(), [], "a jump width as long as phase segment 2 (jump_width_limit)");
}

/// The reset value of CiCFG makes a bit of 4 quanta: reported when the module goes on the bus.
#[test]
fn forgotten_bit_timing() {
    let (sim, _) = started(Cfg::RESET);
    assert!(kinds(&sim).iter().any(|kind| matches!(kind, DiagnosticKind::Contradiction { .. })));
}
