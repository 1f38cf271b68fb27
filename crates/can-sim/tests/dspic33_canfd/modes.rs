//! Modes of operation, low power and system errors (4.0, 12.3.6).

use crate::bench::{BASE, Can, FRAME, Mode, TX8, TX64, TxFifo, add, fd, frame, ids, kinds, pair, pair_with};
use can_sim::{
    DiagnosticKind, Sim, Time,
    dspic33_canfd::{DeviceMode, SystemFailure},
};
use can_wire::{Disturbance, Fault, Line, NodeConfig};
use dspic33_canfd_pac::{
    enums::{ConHSerrlom, PayloadSize},
    registers as pac,
};

const ALL: [Mode; 8] = [
    Mode::NormalCanFd,
    Mode::Disable,
    Mode::InternalLoopback,
    Mode::ListenOnly,
    Mode::Configuration,
    Mode::ExternalLoopback,
    Mode::NormalCan2_0,
    Mode::RestrictedOperation,
];

fn is_normal(mode: Mode) -> bool {
    matches!(mode, Mode::NormalCanFd | Mode::NormalCan2_0)
}

fn is_debug(mode: Mode) -> bool {
    !is_normal(mode) && !matches!(mode, Mode::Configuration | Mode::Disable)
}

/// 4.1, 4.1.1, 4.1.2: every transition from every mode; MODIF tells of each.
#[test]
fn every_transition() {
    for from in ALL {
        for to in ALL {
            let (sim, can, _) = pair();
            if from != Mode::Configuration {
                can.go(&sim, from);
            }
            can.clear(&sim, pac::IntL::MODIF);
            can.ask(&sim, to);
            sim.run_for(FRAME);
            let on_bus = |mode| is_normal(mode) || is_debug(mode);
            let illegal = from != to && on_bus(from) && on_bus(to);
            let expected = if illegal { from } else { to };
            assert_eq!(can.mode(&sim), expected, "{from:?} to {to:?}");
            assert_eq!(can.flags(&sim).modif(), expected != from, "{from:?} to {to:?}");
            let reported = matches!(kinds(&sim)[..], [DiagnosticKind::IllegalModeChange { .. }]);
            assert_eq!(reported, illegal, "{from:?} to {to:?}");
        }
    }
}

/// 4.1: the mode does not change at once, and on the way to the bus only after eleven recessive bits.
#[test]
fn opmod_follows_bus_integration() {
    let (sim, can, _) = pair();
    let asked = sim.now();
    can.ask(&sim, Mode::NormalCanFd);
    assert_eq!(can.mode(&sim), Mode::Configuration);
    sim.run_for(Time::from_us(10));
    assert_eq!(can.mode(&sim), Mode::Configuration);
    can.wait(&sim, Mode::NormalCanFd);
    let bits = sim.now().since(asked).as_ps() / 1_000_000;
    assert!((11..=13).contains(&bits), "{bits} bits");
}

/// 4.1.3, 4.2, 4.4: leaving waits for the message that is being sent or received.
#[test]
fn leaving_waits_for_the_current_message() {
    for to in [Mode::Configuration, Mode::Disable] {
        for sends in [true, false] {
            let (sim, can, peer) = pair();
            can.tx_fifo(&sim, 1, TX8);
            can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
            can.accept_all(&sim, 2);
            can.start(&sim);
            let message = frame("123#0011223344556677");
            if sends {
                can.send(&sim, 1, &message);
            } else {
                sim.peer_send(peer, message);
            }
            sim.run_for(Time::from_us(30));
            assert!(can.regs(&sim).con_l().read().busy());
            can.ask(&sim, to);
            sim.run_for(Time::from_us(20));
            assert_eq!(can.mode(&sim), Mode::NormalCanFd, "in the middle of the message");
            sim.run_for(FRAME);
            assert_eq!(can.mode(&sim), to);
            assert!(!can.regs(&sim).con_l().read().busy());
            assert_eq!(sim.frames_on_bus().len(), 1);
            // 4.4: in Disable mode FIFOs keep what they hold.
            let held = sim.with_memory(can.ram, |ram| ram.clone());
            let held = sim.inspect(can.id, |model| model.rx_fifo(&held, 2).len());
            assert_eq!(held, usize::from(!sends && to == Mode::Disable));
        }
    }
}

/// 4.1: a request for the mode the module is in takes a pending one back.
#[test]
fn a_later_request_replaces_a_pending_one() {
    let (sim, can, peer) = pair();
    can.start(&sim);
    sim.peer_send(peer, frame("123#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.ask(&sim, Mode::Configuration);
    can.ask(&sim, Mode::Disable);
    sim.run_for(FRAME);
    assert_eq!(can.mode(&sim), Mode::Disable);
    can.start(&sim);
    sim.peer_send(peer, frame("123#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.ask(&sim, Mode::Configuration);
    can.ask(&sim, Mode::NormalCanFd);
    sim.run_for(FRAME * 2);
    assert_eq!(can.mode(&sim), Mode::NormalCanFd);
}

/// 4.2, 4.4: leaving Configuration mode resets counters and diagnostics; Disable mode does not.
#[test]
fn configuration_resets_the_counters_and_disable_does_not() {
    let (sim, can, _) = pair();
    can.start(&sim);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 40, 20));
    sim.run_for(FRAME);
    let counters = || {
        let trec = can.regs(&sim).trec_l().read();
        (trec.terrcnt(), trec.rerrcnt())
    };
    assert_eq!(counters(), (40, 20));
    can.go(&sim, Mode::Disable);
    can.start(&sim);
    assert_eq!(counters(), (40, 20));
    can.go(&sim, Mode::Configuration);
    assert_eq!(counters(), (40, 20), "they are reset on the way out");
    assert!(can.regs(&sim).trec_h().read().txbo(), "Register 3-45: off the bus");
    can.start(&sim);
    assert_eq!(counters(), (0, 0));
    assert!(!can.regs(&sim).trec_h().read().txbo());
    assert_eq!(sim.with_wire(|wire| wire.error_counters(node)), (0, 0));
}

/// 4.2: the protected fields take no write outside Configuration mode, whatever the mode; the others do.
#[test]
fn protected_fields() {
    for mode in ALL.into_iter().filter(|mode| *mode != Mode::Configuration) {
        let (sim, can, _) = pair();
        can.go(&sim, mode);
        let regs = can.regs(&sim);
        let before = (regs.read_nbtcfg(), regs.read_dbtcfg(), regs.read_tdc(), regs.read_fifoba());
        use regbus::Bus;
        let bus = sim.registers(can.id);
        for offset in [0x004, 0x006, 0x008, 0x00A, 0x00C, 0x00E, 0x04C, 0x04E] {
            bus.write(offset, 0x1357_u16);
        }
        assert_eq!((regs.read_nbtcfg(), regs.read_dbtcfg(), regs.read_tdc(), regs.read_fifoba()), before);
        assert_eq!(kinds(&sim).len(), 8);
        let fifo = regs.fifo(9);
        fifo.con_h().write(fifo.con_h().read().with_fsize(7).with_txpri(9));
        assert_eq!((fifo.con_h().read().fsize(), fifo.con_h().read().txpri()), (0, 9));
        assert_eq!(kinds(&sim).len(), 1);
    }
}

/// `module_disabled`: with CON = 0 the module takes no part and changes no mode.
#[test]
fn a_disabled_module_stays_off_the_bus() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.ask(&sim, Mode::NormalCanFd);
    sim.run_for(FRAME);
    assert_eq!(can.mode(&sim), Mode::Configuration);
    can.regs(&sim).con_l().write(pac::ConL::RESET.with_con(true));
    can.wait(&sim, Mode::NormalCanFd);
    can.regs(&sim).con_l().write(pac::ConL::RESET.with_con(false));
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(peer).len(), 0, "nobody acknowledges");
}

/// 4.3.2: FDF, BRS and ESI of the object are ignored, and CAN FD frames of others end in error frames.
#[test]
fn normal_can_2_0_mode() {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes64);
    can.accept_all(&sim, 2);
    can.go(&sim, Mode::NormalCan2_0);
    can.send(&sim, 1, &fd(0x123, &[1, 2, 3]));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(peer)[0].1, frame("123#010203"));
    sim.peer_send(peer, frame("456#01"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 2), Some(frame("456#01")));
    sim.peer_send(peer, fd(0x222, &[1; 8]));
    sim.run_for(FRAME);
    assert!(!can.has_message(&sim, 2));
    assert!(can.regs(&sim).trec_l().read().rerrcnt() > 0);
    assert!(sim.peer_sent(peer).iter().all(|(_, sent)| !sent.is_fd()), "it never gets through");
}

/// 4.5.1: listens without a single dominant bit, counts nothing and ignores requests.
#[test]
fn listen_only_mode() {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.go(&sim, Mode::ListenOnly);
    can.send(&sim, 1, &frame("100#"));
    sim.peer_send(peer, frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(peer).len(), 0, "no acknowledgement");
    let other = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    assert!(!sim.peer_received(other).is_empty());
    assert_eq!(can.receive(&sim, 2), Some(frame("123#11")));
    assert_eq!(can.pending(&sim), 1 << 1, "the request waits");
    assert_eq!(can.regs(&sim).trec_l().read().bits(), 0);
    assert!(!can.flags(&sim).ivmif(), "no error frame, no invalid message");
}

/// 4.5.2: acknowledges, but sends neither frames nor error flags.
#[test]
fn restricted_operation_mode() {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.go(&sim, Mode::RestrictedOperation);
    can.send(&sim, 1, &frame("100#"));
    sim.peer_send(peer, frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(peer).len(), 1, "acknowledged");
    assert_eq!(can.receive(&sim, 2), Some(frame("123#11")));
    assert_eq!(ids(&sim, peer), []);
    assert_eq!(can.pending(&sim), 1 << 1);
    let node = sim.node(can.id);
    let now = sim.now();
    sim.peer_send(peer, frame("456#0011223344556677"));
    let (from, until) = (now + Time::from_us(30), now + Time::from_us(38));
    sim.with_wire(|wire| wire.inject(Fault::Disturb { line: Line::Rx(node), how: Disturbance::Dominant, from, until }));
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).trec_l().read().rerrcnt(), 0, "the counters stand still");
    assert!(can.regs(&sim).bdiag0_l().read().nrerrcnt() > 0, "the diagnostics do not");
}

/// 4.5.3: both loopbacks receive what they send, without another node; only the external one shows on CxTX.
#[test]
fn loopback_modes() {
    for (mode, visible) in [(Mode::InternalLoopback, false), (Mode::ExternalLoopback, true)] {
        let (sim, can, peer) = pair();
        can.tx_fifo(&sim, 1, TX64);
        can.queue(&sim, TX8);
        can.events(&sim, 4, false);
        can.rx_fifo(&sim, 2, 8, PayloadSize::Bytes64);
        can.accept_all(&sim, 2);
        can.go(&sim, mode);
        let messages = [fd(0x123, &[7; 64]), frame("00000456#0102")];
        can.load(&sim, 1, &messages[0]);
        can.load(&sim, 0, &messages[1]);
        can.request(&sim, 0b11);
        sim.run_for(FRAME * 3);
        // The queue goes first.
        assert_eq!(can.receive(&sim, 2), Some(messages[1]));
        assert_eq!(can.receive(&sim, 2), Some(messages[0]));
        assert_eq!(can.pending(&sim), 0);
        assert!(can.regs(&sim).tefsta().read().tefneif());
        assert_eq!(sim.peer_received(peer).len(), if visible { 2 } else { 0 }, "{mode:?}");
        sim.peer_send(peer, frame("700#"));
        sim.run_for(FRAME);
        assert!(!can.has_message(&sim, 2), "CxRX is disconnected");
        assert_eq!(can.regs(&sim).trec_l().read().bits(), 0);
    }
}

/// 4.6.1, 4.6.3: the recommended way to Sleep and back; the first message is lost.
#[test]
fn sleep_and_wake_up_by_bus_activity() {
    let (sim, can, peer) = pair();
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.start(&sim);
    can.regs(&sim).int_h().write(pac::IntH::WAKIE);
    can.go(&sim, Mode::Disable);
    sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Sleep));
    assert!(!sim.line(can.id, 2));
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    sim.peer_send(peer, frame("123#11"));
    let woken = sim.run_until(FRAME, |sim| sim.line(can.id, 2)).unwrap();
    assert!(sim.inspect(can.id, |model| model.device_mode()) == DeviceMode::Run && woken > Time::ZERO);
    assert_eq!(can.mode(&sim), Mode::Disable, "4.6.1: as before Sleep");
    assert!(can.flags(&sim).wakif());
    assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 66);
    can.clear(&sim, pac::IntL::WAKIF);
    assert!(!sim.line(can.id, 2));
    can.start(&sim);
    sim.run_for(FRAME);
    assert!(!can.has_message(&sim, 2), "the message that woke it is lost");
    sim.peer_send(peer, frame("124#22"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 2), Some(frame("124#22")));
    assert_eq!(sim.diagnostics(), []);
}

/// 5.2.3: with WAKFIL a short glitch does not wake the module.
#[test]
fn the_wake_up_filter_ignores_glitches() {
    for filtered in [false, true] {
        let (sim, can, _) = pair_with(|mut config| {
            config.wake_up_filter = [Time::from_us(2); 4];
            config
        });
        can.regs(&sim).con_l().write(can.regs(&sim).con_l().read().with_wakfil(filtered));
        can.start(&sim);
        can.go(&sim, Mode::Disable);
        sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Sleep));
        let node = sim.node(can.id);
        let disturb = |length: Time| {
            let (from, until) = (sim.now(), sim.now() + length);
            let fault = Fault::Disturb { line: Line::Rx(node), how: Disturbance::Dominant, from, until };
            sim.with_wire(|wire| wire.inject(fault));
            sim.run_for(Time::from_us(20));
        };
        disturb(Time::from_ns(500));
        assert_eq!(can.flags(&sim).wakif(), !filtered);
        disturb(Time::from_us(5));
        assert!(can.flags(&sim).wakif());
    }
}

/// 4.6.2: Idle mode stops the module only with SIDL; stopping it in the middle of traffic is a mistake.
#[test]
fn idle_mode() {
    let (sim, can, peer) = pair();
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.start(&sim);
    sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Idle));
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert!(can.has_message(&sim, 2));
    sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Run));
    let con = can.regs(&sim).con_l();
    con.write(con.read().with_sidl(true));
    assert_eq!(kinds(&sim), []);
    sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Idle));
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::Contradiction { .. }]));
    sim.act(can.id, |model, cx| model.set_device_mode(cx, DeviceMode::Run));
    sim.run_for(FRAME);
    sim.peer_send(peer, frame("124#"));
    sim.run_for(FRAME);
    assert_eq!(can.status(&sim, 2).fifoci(), 2, "it goes on in its mode");
}

fn sender(serrlom: ConHSerrlom) -> (Sim, Can, can_sim::PeerId) {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.con_h(&sim, |con_h| con_h.with_serrlom(serrlom));
    can.start(&sim);
    can.regs(&sim).int_h().write(pac::IntH::SERRIE);
    (sim, can, peer)
}

/// 12.3.6: an underflow of the transmit assembly buffer stops the transmission and changes the mode; reception goes on;
/// the way back leads through Configuration mode.
#[test]
fn transmit_underflow_changes_the_mode() {
    for (serrlom, mode) in
        [(ConHSerrlom::RestrictedOperation, Mode::RestrictedOperation), (ConHSerrlom::ListenOnly, Mode::ListenOnly)]
    {
        let (sim, can, peer) = sender(serrlom);
        can.clear(&sim, pac::IntL::MODIF);
        sim.act(can.id, |model, cx| model.fail(cx, SystemFailure::TxUnderflow));
        can.send(&sim, 1, &frame("100#11"));
        sim.run_for(FRAME);
        assert_eq!(can.mode(&sim), mode);
        assert_eq!(can.regs(&sim).con_h().read().reqop(), Mode::NormalCanFd, "REQOP keeps its value");
        assert!(can.flags(&sim).contains(pac::IntL::SERRIF | pac::IntL::MODIF));
        assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 0b100_0101);
        assert_eq!(ids(&sim, peer), [], "nothing was sent");
        assert_eq!(can.pending(&sim), 1 << 1, "the request is ignored");
        let other = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        sim.peer_send(other, frame("300#33"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 2), Some(frame("300#33")));
        can.clear(&sim, pac::IntL::SERRIF);
        assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 64);
        can.go(&sim, Mode::Configuration);
        can.start(&sim);
        can.send(&sim, 1, &frame("101#11"));
        sim.run_for(FRAME);
        assert_eq!(ids(&sim, peer).last(), Some(&0x101));
    }
}

/// 12.3.6: an overflow of the receive assembly buffer discards the new message; the next one is received.
#[test]
fn receive_overflow_discards_the_new_message() {
    let (sim, can, peer) = sender(ConHSerrlom::RestrictedOperation);
    sim.peer_send(peer, frame("300#"));
    sim.run_for(FRAME);
    sim.act(can.id, |model, cx| model.fail(cx, SystemFailure::RxOverflow));
    sim.peer_send(peer, frame("301#"));
    sim.run_for(FRAME);
    sim.peer_send(peer, frame("302#"));
    sim.run_for(FRAME);
    assert!(sim.line(can.id, 2));
    assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 69);
    assert_eq!((can.receive(&sim, 2), can.receive(&sim, 2)), (Some(frame("300#")), Some(frame("302#"))));
    assert_eq!(can.mode(&sim), Mode::NormalCanFd);
}

/// 12.3.6: an address without RAM: SERRIF with its own code and a soft trap; a transmission does not start.
#[test]
fn address_errors() {
    let (sim, can, peer) = pair();
    can.set_base(&sim, BASE + 4096 * 4 - 16);
    can.tx_fifo(&sim, 1, TxFifo { depth: 1, ..TX8 });
    can.rx_fifo(&sim, 2, 1, PayloadSize::Bytes8);
    can.accept_all(&sim, 2);
    can.start(&sim);
    let end = BASE + 4096 * 4;
    let beyond = |section, end| DiagnosticKind::SectionBeyondMemory { section, end, limit: BASE + 4096 * 4 };
    assert_eq!(kinds(&sim), [beyond("fifo 2", end + 16)]);
    can.regs(&sim).int_h().write(pac::IntH::SERRIE);
    sim.peer_send(peer, frame("300#"));
    sim.run_for(FRAME);
    assert!(!can.has_message(&sim, 2));
    assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 68);
    assert_eq!(sim.inspect(can.id, |model| model.soft_traps()), 1);
    assert_eq!(kinds(&sim), [DiagnosticKind::MemoryOverrun { address: end }]);
    // transmit_address_error.
    can.go(&sim, Mode::Configuration);
    can.set_base(&sim, 0x100);
    can.start(&sim);
    sim.take_diagnostics();
    can.clear(&sim, pac::IntL::SERRIF);
    can.increment(&sim, 1, true);
    sim.run_for(FRAME);
    assert_eq!(kinds(&sim), [DiagnosticKind::MemoryOverrun { address: 0x100 }]);
    assert_eq!(can.mode(&sim), Mode::RestrictedOperation);
    assert_eq!(sim.inspect(can.id, |model| model.soft_traps()), 2);
}

/// 12.3.6: an address error that the device reports by itself.
#[test]
fn an_injected_address_error() {
    let (sim, can, _) = sender(ConHSerrlom::RestrictedOperation);
    sim.act(can.id, |model, cx| model.fail(cx, SystemFailure::Address));
    assert!(sim.line(can.id, 2));
    assert_eq!(can.regs(&sim).vec_l().read().bits() & 0x7F, 68);
    can.clear(&sim, pac::IntL::SERRIF);
    assert!(!sim.line(can.id, 2));
}

/// The dump names modes, FIFOs, filters and what is pending.
#[test]
fn describe_tells_the_state() {
    let (sim, can, _) = sender(ConHSerrlom::RestrictedOperation);
    can.go(&sim, Mode::Disable);
    can.send(&sim, 1, &frame("123#11"));
    let text = sim.describe(can.id);
    for part in ["OPMOD: disable", "fifo 1: 1 of 4 in use", "filter 0: to FIFO 2", "fifo 2: bytes 0x1040 to 0x1080"] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
}
