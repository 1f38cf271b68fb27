//! Operating modes and bit timing (6.0, 7.0).

use crate::bench::{CFG1, CFG2, Can, FRAME, TIMING, add, everything, frame, kinds, pair, peer, received, standard};
use can_frame::Frame;
use can_sim::{DiagnosticKind, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Level, Position};
use dspic33_ecan_pac::{
    enums::{FilterTarget, OperationMode, TxPriority},
    registers as pac,
};
use regbus::Bus;

/// 7.1: after a reset the module is in Configuration mode, with error counters 0 and all registers reset.
#[test]
fn section_7_1_configuration_mode_after_reset() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let regs = can.regs(&sim);
    assert_eq!(regs.ctrl1().read().bits(), 0x0480);
    assert_eq!(regs.ctrl1().read().opmode(), Ok(OperationMode::Configuration));
    assert_eq!(regs.ec().read().bits(), 0);
    assert_eq!(regs.fen1().read().bits(), 0xFFFF);
    // reset_of_lost_registers: the code for no interrupt.
    assert_eq!(regs.vec().read().bits(), 0x0040);
    can.set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo)).enter(&sim, OperationMode::Normal);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 100, 50));
    sim.run_for(Time::from_us(1));
    assert_eq!(regs.ec().read().bits(), 0x6432);
    sim.act(can.id, |model, cx| model.reset(cx));
    assert_eq!((regs.ec().read().bits(), regs.ctrl1().read().bits()), (0, 0x0480));
    assert_eq!((regs.cfg1().read().bits(), regs.fen1().read().bits()), (0, 0xFFFF));
    assert_eq!(sim.diagnostics(), []);
}

/// 7.1: CxCFG1 and CxCFG2 can be written in Configuration mode only.
#[test]
fn section_7_1_bit_timing_is_protected() {
    let (sim, can, _) = pair();
    let regs = can.regs(&sim);
    regs.cfg1().write(pac::Cfg1::RESET.with_brp(5));
    regs.cfg2().write(pac::Cfg2::RESET.with_wakfil(true));
    assert_eq!((regs.cfg1().read(), regs.cfg2().read()), (CFG1, CFG2));
    let found = kinds(&sim);
    assert_eq!(found.len(), 2);
    for kind in found {
        assert!(matches!(kind, DiagnosticKind::ProtectedWrite { condition: "configuration", .. }), "{kind}");
    }
}

/// 7.0: the module waits for 11 recessive bits before it changes the mode.
#[test]
fn section_7_0_mode_change_waits_for_an_idle_bus() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim);
    let ctrl1 = can.regs(&sim).ctrl1();
    ctrl1.modify(|value| value.with_reqop(OperationMode::Normal));
    let asked = sim.now();
    let value = ctrl1.read();
    assert_eq!((value.reqop(), value.opmode()), (Ok(OperationMode::Normal), Ok(OperationMode::Configuration)));
    let reached = sim.run_until(FRAME, |_| can.mode(&sim) == OperationMode::Normal).unwrap();
    let waited = reached.since(asked);
    assert!((Time::from_us(10)..Time::from_us(12)).contains(&waited), "{waited}");
    assert_eq!(ctrl1.read().opmode(), Ok(OperationMode::Normal));
}

/// 7.0, mode_change_with_pending_messages: a frame on the bus is finished before the mode changes.
#[test]
fn section_7_0_a_frame_on_the_bus_is_finished() {
    for target in
        [OperationMode::Configuration, OperationMode::Disable, OperationMode::ListenOnly, OperationMode::ListenAll]
    {
        let (sim, can, other) = pair();
        can.transmit_buffer(&sim, 1, TxPriority::Lowest);
        can.send(&sim, 0, &frame("123#0011223344556677"));
        can.write(&sim, 1, &frame("124#"));
        sim.run_for(Time::from_us(30));
        can.request(&sim, 1);
        let ctrl1 = can.regs(&sim).ctrl1();
        ctrl1.modify(|value| value.with_reqop(target));
        let reached = sim.run_until(FRAME, |_| can.mode(&sim) == target).unwrap();
        let (sent, _) = sim.peer_received(other)[0];
        assert!(reached > sent && reached.since(sent) < Time::from_us(6), "{target:?}: {reached} after {sent}");
        if target != OperationMode::ListenAll {
            sim.run_for(FRAME);
            assert_eq!(
                received(&sim, other),
                ["123#0011223344556677"],
                "the second request stays pending in {target:?}"
            );
            assert!(can.outcome(&sim, 1).0);
            can.enter(&sim, OperationMode::Normal);
        }
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other), ["123#0011223344556677", "124#"]);
        assert_eq!(sim.diagnostics(), []);
    }
}

/// A request that is taken back in time changes nothing.
#[test]
fn section_7_0_a_request_taken_back() {
    let (sim, can, other) = pair();
    let ctrl1 = can.regs(&sim).ctrl1();
    sim.peer_send(other, frame("100#0011223344556677"));
    sim.run_for(Time::from_us(30));
    ctrl1.modify(|value| value.with_reqop(OperationMode::Disable));
    ctrl1.modify(|value| value.with_reqop(OperationMode::Normal));
    sim.run_for(FRAME);
    assert_eq!(sim.inspect(can.id, |model| model.mode()), (OperationMode::Normal, None));
    assert!(can.is_full(&sim, 8));
    can.enter(&sim, OperationMode::Configuration);
    ctrl1.modify(|value| value.with_reqop(OperationMode::Normal));
    ctrl1.modify(|value| value.with_reqop(OperationMode::Configuration));
    sim.run_for(FRAME);
    assert_eq!(sim.inspect(can.id, |model| model.mode()), (OperationMode::Configuration, None));
    can.enter(&sim, OperationMode::Normal);
    can.send(&sim, 0, &frame("101#"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["101#"]);
}

/// Register 4-23: REQOP 101 and 110 are reserved (`reserved_mode_request`), bit 11 must not be used.
#[test]
fn register_4_23_reserved_values() {
    let (sim, can, _) = pair();
    let ctrl1 = can.regs(&sim).ctrl1();
    for code in [5_u16, 6] {
        sim.registers(can.id).write(ctrl1.offset(), code << 8);
        sim.run_for(FRAME);
        assert_eq!(can.mode(&sim), OperationMode::Normal);
        let value = u32::from(code);
        assert_eq!(kinds(&sim), [DiagnosticKind::ReservedValue { register: "CTRL1", field: "REQOP", value }]);
    }
    sim.registers(can.id).write(ctrl1.offset(), 1_u16 << 11);
    assert_eq!(ctrl1.read().bits() & 1 << 11, 0);
    assert_eq!(kinds(&sim), [DiagnosticKind::ReservedBits { register: "CTRL1", bits: 1 << 11 }]);
}

/// 7.1, 7.6: in Configuration and Disable mode the module neither receives, acknowledges nor sends.
#[test]
fn section_7_6_disable_mode_is_off_the_bus() {
    for mode in [OperationMode::Disable, OperationMode::Configuration] {
        let (sim, can, other) = pair();
        can.enter(&sim, mode);
        can.send(&sim, 0, &frame("123#"));
        sim.peer_send(other, frame("055#"));
        sim.run_for(FRAME * 3);
        assert_eq!(sim.peer_sent(other), [], "nobody acknowledges");
        assert!(!can.is_full(&sim, 8));
        assert_eq!(can.on_wire(&sim, |wire, node| wire.tx_level(node)), Level::Recessive);
        // disable_mode_wake_up: bus activity changes no mode and sets no flag while the device does not sleep.
        assert_eq!(can.mode(&sim), mode);
        assert!(!can.intf(&sim).wakif());
        can.enter(&sim, OperationMode::Normal);
        sim.run_for(FRAME * 4);
        assert_eq!(received(&sim, other), ["123#"]);
        assert_eq!(sim.peer_sent(other).len(), 1);
    }
}

/// 7.3: no acknowledge, no error frame, no transmission; `listen_only_request`.
#[test]
fn section_7_3_listen_only() {
    let (sim, can, other) = pair();
    can.enter(&sim, OperationMode::ListenOnly);
    can.send(&sim, 0, &frame("123#"));
    sim.peer_send(other, frame("055#11"));
    sim.run_for(FRAME * 2);
    assert_eq!(sim.peer_sent(other), [], "the peer gets no acknowledge");
    assert!(can.outcome(&sim, 0).0, "the request stays pending");
    let third = peer(&sim);
    sim.run_for(FRAME * 3);
    assert_eq!(sim.peer_sent(other).len(), 1, "another node acknowledges");
    assert_eq!(received(&sim, third), ["055#11"]);
    assert_eq!(can.take(&sim, 8), Some(frame("055#11")));
    // An error that only this node sees: it sends no error frame, and the others do not notice.
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 3));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
    can.take_flags(&sim);
    sim.with_wire(|wire| wire.inject(fault));
    sim.peer_send(other, frame("056#00"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, third), ["055#11", "056#00"]);
    assert!(can.intf(&sim).ivrif() && !can.is_full(&sim, 8));
    assert_eq!(can.regs(&sim).ec().read().bits(), 0, "error counters stand still");
    can.enter(&sim, OperationMode::Normal);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, third), ["055#11", "056#00", "123#"]);
}

/// 7.3: the bit rate of a bus is found by listening: a wrong one brings errors, the right one messages.
#[test]
fn section_7_3_bit_rate_detection() {
    let sim = Sim::new();
    let (a, b) = (peer(&sim), peer(&sim));
    let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(8)));
    let mut found = Vec::new();
    for brp in [3, 1, 0] {
        can.regs(&sim).cfg1().write(CFG1.with_brp(brp));
        can.enter(&sim, OperationMode::ListenOnly);
        for n in 0..20 {
            sim.peer_send(a, frame(&format!("{n:03X}#5500AA")));
        }
        sim.run_for(FRAME * 25);
        let flags = can.take_flags(&sim);
        found.push((brp, flags.rbif(), flags.ivrif()));
        can.release(&sim, 8);
        can.enter(&sim, OperationMode::Configuration);
    }
    assert_eq!(found, [(3, false, true), (1, false, true), (0, true, false)]);
    assert_eq!(sim.peer_received(b).len(), 60, "nobody was disturbed");
}

/// 7.4: every message, whatever its identifier, and one with an error as far as it had arrived; otherwise as in normal
/// operation.
#[test]
fn section_7_4_listen_all() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim);
    let only = crate::bench::exactly(3, dspic33_ecan_pac::enums::MaskSource::Mask1, standard(0x123), 9);
    can.add_filter(&sim, only).transmit_buffer(&sim, 0, TxPriority::Lowest);
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    sim.peer_send(other, frame("055#11"));
    sim.run_for(FRAME);
    assert!(!can.is_full(&sim, 9));
    can.enter(&sim, OperationMode::ListenAll);
    sim.peer_send(other, frame("055#11"));
    sim.run_for(FRAME);
    // listen_all_destination: the buffer of the lowest-numbered enabled filter.
    assert_eq!(can.words(&sim, 9)[7], 3 << 8);
    assert_eq!(can.take(&sim, 9), Some(frame("055#11")));
    can.send(&sim, 0, &frame("321#"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["321#"], "it sends");
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 20));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
    sim.with_wire(|wire| wire.inject(fault));
    sim.peer_send(other, frame("056#0000000000"));
    sim.run_until(FRAME, |sim| can.is_full(sim, 9)).unwrap();
    let broken = can.take(&sim, 9).unwrap();
    assert_eq!((broken.id(), broken.len()), (standard(0x056), 5));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 9), Some(frame("056#0000000000")), "sent again");
}

/// 7.5: the module receives its own message without another node, through filters and buffers (`loopback_reception`);
/// CxTX stays recessive and CxRX is ignored (`loopback_pins`).
#[test]
fn section_7_5_loopback() {
    let (sim, can, other) = pair();
    can.enter(&sim, OperationMode::Loopback);
    can.send(&sim, 0, &frame("12345678#0102"));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 8), Some(frame("12345678#0102")));
    assert_eq!(can.outcome(&sim, 0), (false, false, false, false));
    let flags = can.take_flags(&sim);
    assert!(flags.tbif() && flags.rbif() && !flags.ivrif());
    assert_eq!(sim.peer_received(other), []);
    sim.peer_send(other, frame("055#"));
    sim.run_for(FRAME * 2);
    assert!(!can.is_full(&sim, 8));
    can.enter(&sim, OperationMode::Normal);
    sim.run_for(FRAME * 2);
    assert_eq!(can.take(&sim, 8), Some(frame("055#")));
}

/// Examples 6-1 and 6-2: FCY 40 MHz, 1 Mbit/s, 20 time quanta, sample point at 70 %.
#[test]
fn example_6_2_bit_timing() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let regs = can.regs(&sim);
    can.enter(&sim, OperationMode::Configuration).set_up(&sim);
    assert_eq!((regs.cfg1().read().bits(), regs.cfg2().read().bits()), (0x00C0, 0x05FC));
    can.enter(&sim, OperationMode::Normal);
    let timing = can.on_wire(&sim, |wire, node| wire.config(node).nominal);
    assert_eq!(timing, TIMING);
    assert_eq!((timing.bit_rate(40_000_000), timing.sample_point_permille(), timing.quanta()), (1_000_000, 700, 20));
    assert_eq!(sim.diagnostics(), []);
}

/// Equations 6-1 and 6-2: FTQ = N * FBAUD, BRP = FCY / (2 * FTQ) - 1.
#[test]
fn equation_6_2_prescaler() {
    for (fcy, rate, quanta, brp) in [
        (40_000_000, 1_000_000, 10, 1),
        (40_000_000, 500_000, 20, 1),
        (40_000_000, 250_000, 20, 3),
        (40_000_000, 125_000, 20, 7),
        (40_000_000, 125_000, 16, 9),
        (40_000_000, 100_000, 25, 7),
        (40_000_000, 50_000, 20, 19),
        (40_000_000, 20_000, 25, 39),
        (40_000_000, 12_500, 25, 63),
        (16_000_000, 1_000_000, 8, 0),
        (20_000_000, 500_000, 10, 1),
    ] {
        let sim = Sim::new();
        let can = crate::bench::add_with(&sim, "can1", |config| config.with_clock(fcy)).set_up(&sim);
        assert_eq!(fcy / (2 * quanta * rate) - 1, brp);
        let rest = quanta - 1;
        let seg2 = (rest / 3).min(8);
        let seg1 = ((rest - seg2) / 2).min(8);
        let propagation = rest - seg2 - seg1;
        let regs = can.regs(&sim);
        regs.cfg1().write(pac::Cfg1::RESET.with_brp(brp as u8));
        let segments = CFG2.with_prseg(propagation as u8 - 1).with_seg1ph(seg1 as u8 - 1).with_seg2ph(seg2 as u8 - 1);
        regs.cfg2().write(segments);
        can.enter(&sim, OperationMode::Normal);
        let timing = can.on_wire(&sim, |wire, node| wire.config(node).nominal);
        assert_eq!((timing.bit_rate(fcy), timing.quanta()), (rate, u64::from(quanta)), "{rate}");
        assert_eq!(sim.diagnostics(), []);
    }
}

/// Register 4-2: with SEG2PHTS 0 phase segment 2 is the longer of phase segment 1 and the information processing time.
#[test]
fn register_4_2_automatic_phase_segment_2() {
    for (seg1ph, expected) in [(7, 8), (3, 4), (0, 2)] {
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim);
        let cfg2 = pac::Cfg2::RESET.with_prseg(7).with_seg1ph(seg1ph).with_seg2ph(4);
        can.regs(&sim).cfg2().write(cfg2);
        can.regs(&sim).cfg1().write(pac::Cfg1::RESET);
        can.enter(&sim, OperationMode::Normal);
        assert_eq!(can.on_wire(&sim, |wire, node| wire.config(node).nominal.phase_seg2), expected);
    }
}

/// 6.0, 6.4: what a bit time must not be is reported, and used as programmed (`bit_timing_limits`).
#[test]
fn section_6_4_rules_of_the_bit_time() {
    let wrong = |cfg1: pac::Cfg1, cfg2: pac::Cfg2| -> Vec<String> {
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim);
        can.regs(&sim).cfg1().write(cfg1);
        can.regs(&sim).cfg2().write(cfg2);
        can.enter(&sim, OperationMode::Normal);
        kinds(&sim).iter().map(ToString::to_string).collect()
    };
    assert_eq!(wrong(CFG1, CFG2), Vec::<String>::new());
    let short = wrong(CFG1.with_sjw(0).with_brp(9), CFG2.with_prseg(0).with_seg1ph(1).with_seg2ph(1));
    assert_eq!(short, ["a bit time has 6 time quanta, legal are 8 to 25"]);
    let late = wrong(CFG1.with_brp(1), CFG2.with_prseg(0).with_seg1ph(4).with_seg2ph(7));
    assert_eq!(late, ["propagation segment and phase segment 1 have 6 quanta, phase segment 2 8"]);
    let jump = wrong(CFG1.with_sjw(3), CFG2.with_seg2ph(1));
    assert_eq!(jump[0], "the jump width of 4 quanta is not below phase segment 2 of 2");
    let fast = wrong(CFG1.with_sjw(0), CFG2.with_prseg(1).with_seg1ph(2).with_seg2ph(1));
    assert_eq!(fast, ["the bit rate is 2500000 bit/s, at most 1000000 bit/s are possible"]);
}

/// 1.0: CAN 2.0B. A frame of CAN FD ends in an error.
#[test]
fn section_1_0_no_can_fd() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, everything(FilterTarget::Buffer(8)));
    let fd = can_wire::NodeConfig { nominal: TIMING, data: TIMING, ..can_wire::NodeConfig::new() };
    let other = sim.add_peer(fd).unwrap();
    sim.run_for(FRAME);
    let id = can_frame::StandardId::new(0x123).unwrap();
    let flags = can_frame::FdFlags { brs: false, esi: false };
    sim.peer_send(other, Frame::fd(id, &[1, 2, 3], flags).unwrap());
    sim.run_for(FRAME);
    assert!(can.intf(&sim).ivrif() && !can.is_full(&sim, 8));
}

/// Every module starts, exchanges and describes itself.
#[test]
fn the_state_is_described() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("123#55"));
    sim.run_for(FRAME);
    let text = sim.describe(can.id);
    for part in ["mode Normal", "CTRL1", "full buffers [8]", "filter 0 to Buffer(8)", "DMA for CxTX"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let _: Can = can;
}
