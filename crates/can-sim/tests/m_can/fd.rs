//! CAN FD: non-ISO frames, bus integration with edge filtering, transmitter delay compensation, test modes among other
//! nodes: sections 2.3.7, 3.1.3, 3.1.4, 3.1.6 and 3.1.9 of the manual.

use crate::bench::{Can, DBTP, FD, FRAME, SETUP, Setup, add, add_with, frame};
use can_sim::{DiagnosticKind, Sim, Time};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Line, NodeConfig, Position};
use m_can_pac::{
    enums::Activity,
    registers::{self as pac, Ir},
};

const NISO: pac::Cccr = FD.union(pac::Cccr::from_bits(1 << 15));

/// 2.3.7: NISO selects the Bosch format: understood by nodes of that format, an error for the others; classic frames are
/// the same in both.
#[test]
fn section_2_3_7_non_iso_operation() {
    for (cccr, peer_iso) in [(FD, true), (FD, false), (NISO, true), (NISO, false)] {
        let sim = Sim::new();
        let can = add(&sim, "can0").run(&sim, &Setup { cccr, ..SETUP });
        let peer = sim.add_peer(NodeConfig { iso_crc: peer_iso, ..NodeConfig::new() }).unwrap();
        sim.run_for(FRAME);
        let same = (cccr == FD) == peer_iso;
        can.send(&sim, 0, &frame("123#11"));
        sim.run_for(FRAME);
        assert_eq!(sim.peer_received(peer).len(), 1, "a classic frame");
        can.send(&sim, 0, &frame("123##1112233445566778899AABBCC"));
        sim.run_for(FRAME);
        assert_eq!(sim.peer_received(peer).len(), 1 + usize::from(same), "{cccr:?} and {peer_iso}");
        assert_eq!(can.ir(&sim).intersects(Ir::PEA | Ir::PED), !same);
        can.configure(&sim);
        can.start(&sim);
        sim.peer_send(peer, frame("124##1112233445566778899AABBCC"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 0).is_some(), same);
    }
}

/// 2.3.7: with `iso_only_g` NISO is reserved.
#[test]
fn section_2_3_7_iso_only() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |mut config| {
        config.iso_only = true;
        config
    });
    can.run(&sim, &Setup { cccr: NISO, ..SETUP });
    assert_eq!(can.regs(&sim).cccr().read(), FD);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    can.send(&sim, 0, &frame("123##1112233445566778899AABBCC"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(peer).len(), 1);
}

/// 2.3.7: while the node waits for 11 recessive bits, a dominant pulse starts the count again: with EFBI only one of two
/// time quanta or more.
#[test]
fn section_2_3_7_edge_filtering_during_bus_integration() {
    for (efbi, quanta, restarts) in [(false, 1, true), (true, 1, false), (true, 3, true)] {
        let cccr = if efbi { FD | pac::Cccr::EFBI } else { FD };
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, &Setup { cccr, ..SETUP });
        let regs = can.regs(&sim);
        regs.cccr().write(cccr);
        let start = sim.now();
        // Between two sample points; a quantum is 25 ns.
        let from = start + Time::from_ns(8_300);
        let until = from + Time::from_ns(25 * quanta);
        let how = Disturbance::Dominant;
        sim.with_wire(|wire| wire.inject(Fault::Disturb { line: Line::Bus, how, from, until }));
        let idle = sim.run_until(FRAME, |sim| can.regs(sim).psr().read().act() == Activity::Idle).unwrap();
        assert_eq!(idle.since(start) > Time::from_us(15), restarts, "EFBI {efbi}, {quanta} quanta: {idle}");
    }
}

fn compensating(tdc: bool, delay: Time, tdco: u8, tdcf: u8) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |mut config| {
        config.place.tx_delay = delay;
        config
    });
    can.set_up(&sim, &Setup { cccr: FD, ..SETUP });
    let regs = can.regs(&sim);
    regs.dbtp().write(DBTP.with_tdc(tdc));
    regs.tdcr().write(pac::Tdcr::RESET.with_tdco(tdco).with_tdcf(tdcf));
    can.start(&sim);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    (sim, can)
}

/// 3.1.4.1: TDCV is updated by every transmitted FD frame while TDC is set: not by classic ones, not by reading.
#[test]
fn section_3_1_4_1_when_tdcv_is_updated() {
    let (sim, can) = compensating(true, Time::from_ns(100), 5, 0);
    let tdcv = || can.regs(&sim).psr().read().tdcv();
    let send = |text: &str| {
        can.send(&sim, 0, &frame(text));
        sim.run_for(FRAME);
        tdcv()
    };
    assert_eq!([send("123#11"), send("123##111"), tdcv(), send("123#11")], [0, 9, 9, 9]);
    can.regs(&sim).cccr().write(FD | pac::Cccr::INIT);
    sim.run_for(Time::from_us(1));
    assert_eq!(tdcv(), 0, "INIT clears it");
    can.start(&sim);
    assert_eq!(send("123##011"), 9, "a frame without bit rate switch is measured too");
    let (sim, can) = compensating(false, Time::from_ns(100), 5, 0);
    can.send(&sim, 0, &frame("123##111"));
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).psr().read().tdcv(), 0, "TDC = 0");
}

/// 3.1.4: a data bit of 200 ns is shorter than the delay: only with compensation the frame gets through.
#[test]
fn section_3_1_4_delay_beyond_a_data_bit() {
    for tdc in [true, false] {
        let (sim, can) = compensating(tdc, Time::from_ns(240), 6, 0);
        can.send(&sim, 0, &frame("123##1112233445566778899AABBCC"));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).txbto().read().bits(), u32::from(tdc));
        assert_eq!(can.ir(&sim).contains(Ir::PED), !tdc);
    }
}

/// 3.1.4.2: TDCF has to be greater than TDCO to act.
#[test]
fn section_3_1_4_2_filter_window() {
    for (delay, tdco, tdcf, expected) in [
        (Time::from_ns(100), 6, 0, 10),
        (Time::from_ns(100), 6, 6, 10),
        (Time::from_ns(100), 6, 7, 10),
        (Time::from_ns(100), 6, 12, 12),
    ] {
        let (sim, can) = compensating(true, delay, tdco, tdcf);
        can.send(&sim, 0, &frame("123##111"));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).psr().read().tdcv(), expected, "{delay}, TDCO {tdco}, TDCF {tdcf}");
    }
}

/// 3.1.9: in loop back the node hears nothing of the others; internally it does not disturb them either.
#[test]
fn section_3_1_9_loop_back_among_other_nodes() {
    for internal in [false, true] {
        let sim = Sim::new();
        let mode = if internal { pac::Cccr::TEST | pac::Cccr::MON } else { pac::Cccr::TEST };
        let can = add(&sim, "can0").run(&sim, &Setup { cccr: mode, test: pac::Test::LBCK, ..SETUP });
        let peers = [0, 1].map(|_| sim.add_peer(NodeConfig::new()).unwrap());
        sim.run_for(FRAME);
        sim.peer_send(peers[0], frame("7FF#1122"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 0), None, "the receive pin is disregarded");
        assert_eq!(can.regs(&sim).psr().read().act(), Activity::Idle);
        // The node's own frame begins in the middle of another.
        sim.peer_send(peers[0], frame("7FE#1122334455667788"));
        sim.run_for(Time::from_us(40));
        can.send(&sim, 0, &frame("123#11"));
        sim.run_for(FRAME * 3);
        assert_eq!(can.receive(&sim, 0), Some(frame("123#11")));
        let errors = sim.bus_log().iter().any(|entry| matches!(entry, can_sim::BusEntry::Error { .. }));
        assert_eq!(errors, !internal, "the pin stays recessive in internal loop back only");
    }
}

/// 3.1.5: Restricted Operation Mode and loop back must not be combined.
#[test]
fn section_3_1_5_not_with_loop_back() {
    let sim = Sim::new();
    let cccr = pac::Cccr::TEST | pac::Cccr::ASM;
    add(&sim, "can0").run(&sim, &Setup { cccr, test: pac::Test::LBCK, ..SETUP });
    assert!(matches!(sim.diagnostics()[..], [ref d] if matches!(d.kind, DiagnosticKind::Contradiction { .. })));
}

/// 3.1.5, 3.1.6: neither a restricted nor a monitoring node answers an error with a dominant bit.
#[test]
fn section_3_1_6_no_error_flags() {
    for mode in [pac::Cccr::MON, pac::Cccr::ASM, pac::Cccr::ZERO] {
        let sim = Sim::new();
        let can = add(&sim, "can0").run(&sim, &Setup { cccr: mode, ..SETUP });
        let peers = [0, 1].map(|_| sim.add_peer(NodeConfig::new()).unwrap());
        sim.run_for(FRAME);
        let (node, position) = (sim.node(can.id), Position::new(Field::Data, 3));
        let (fault, frames) = (BitFault::InvertSeen, Frames::next());
        sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault, position, frames }));
        sim.peer_send(peers[0], frame("123#0055"));
        sim.run_for(FRAME * 3);
        assert_eq!(sim.peer_received(peers[1]).len(), 1);
        assert!(can.ir(&sim).contains(Ir::PEA));
        let sender = sim.peer_node(peers[0]);
        let disturbed =
            sim.bus_log().iter().any(|e| matches!(e, can_sim::BusEntry::Error { node, .. } if *node == sender));
        assert_eq!(disturbed, mode == pac::Cccr::ZERO, "{mode:?}");
        assert_eq!(can.receive(&sim, 0).is_some(), mode == pac::Cccr::ZERO, "only the repetition arrives");
        assert_eq!(can.regs(&sim).psr().read().act(), Activity::Idle, "it has waited for bus idle");
    }
}
