//! Operating modes, bit timing, counters and interrupts: sections 2.3.4 to 2.3.19, 3.1, 3.2.1 and 3.3 of the manual.
#![allow(clippy::unwrap_used)]

mod common;

use std::{cell::RefCell, rc::Rc};

use can_sim::{Sim, Time, m_can::RamFailure};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use common::{Can, FD, FRAME, SETUP, Setup, add, add_with, choices, frame};
use m_can_pac::{
    enums::{Activity, LastErrorCode, TestRx, TestTx},
    registers::{self as pac, Ir},
};
use regbus::Bus;

fn running(setup: &Setup) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, setup);
    (sim, can)
}

fn invert(sim: &Sim, can: Can, field: Field, bit: u16, frames: Frames) {
    let (node, position) = (sim.node(can.id), Position::new(field, bit));
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
}

/// 3.1.1, 2.3.7: INIT is read back after a delay; CCE needs INIT and falls with it; ACT is idle after 11 recessive bits.
#[test]
fn section_3_1_1_software_initialization() {
    let sim = Sim::builder().access_cost(Time::from_ns(20)).build();
    let can = add(&sim, "can0");
    let regs = can.regs(&sim);
    regs.cccr().write(pac::Cccr::ZERO);
    assert!(regs.cccr().read().init(), "not taken over yet");
    regs.cccr().write(pac::Cccr::INIT);
    assert_eq!(sim.take_diagnostics().len(), 1, "a new value before the last one was accepted");
    sim.run_for(Time::from_us(1));
    regs.cccr().write(pac::Cccr::ZERO);
    sim.run_for(Time::from_us(1));
    assert!(!regs.cccr().read().init());
    regs.cccr().write(pac::Cccr::INIT | pac::Cccr::CCE);
    sim.run_for(Time::from_us(1));
    assert_eq!(regs.cccr().read().bits(), 1, "CCE is not set together with INIT");
    regs.cccr().write(pac::Cccr::INIT | pac::Cccr::CCE);
    assert_eq!(regs.cccr().read().bits(), 3);
    regs.nbtp().write(common::NBTP);
    regs.cccr().write(pac::Cccr::ZERO);
    sim.run_for(Time::from_us(1));
    assert_eq!(regs.cccr().read().bits(), 0, "CCE falls with INIT");
    assert_eq!(regs.psr().read().act(), Activity::Synchronizing);
    let start = sim.now();
    let idle = sim.run_until(FRAME, |sim| can.regs(sim).psr().read().act() == Activity::Idle).unwrap();
    assert!(
        (Time::from_us(9)..Time::from_us(12)).contains(&idle.since(start)),
        "11 recessive bits: {}",
        idle.since(start)
    );
}

/// 2.3.4, 2.3.8: golden examples: reset values give 500 kbit/s at 8 MHz, the shortest data bit 5 Mbit/s at 20 MHz.
#[test]
fn section_2_3_8_bit_timing_examples() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |config| config.with_clock(8_000_000));
    can.start(&sim);
    let config = sim.with_wire(|wire| *wire.config(sim_node(wire)));
    for timing in [config.nominal, config.data] {
        assert_eq!((timing.bit_rate(8_000_000), timing.quanta(), timing.sample_point_permille()), (500_000, 16, 750));
    }
    assert_eq!((config.nominal.sjw, config.data.sjw, config.nominal.prescaler), (4, 4, 1));
    for (dbtp, nbtp, clock, rate) in
        [(0x0000_0010, 0x0600_0A03, 20_000_000, 5_000_000), (0x0000_1FF0, 0x0600_0A03, 49_000_000, 1_000_000)]
    {
        let sim = Sim::new();
        let can = add_with(&sim, "can0", |config| config.with_clock(clock));
        can.configure(&sim);
        sim.registers(can.id).write(0x00C, dbtp as u32);
        sim.registers(can.id).write(0x01C, nbtp as u32);
        can.start(&sim);
        let config = sim.with_wire(|wire| *wire.config(sim_node(wire)));
        assert_eq!(config.data.bit_rate(clock), rate);
        assert_eq!(sim.diagnostics(), []);
    }
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.configure(&sim);
    sim.registers(can.id).write(0x01C, 0x7F << 25 | 0xFF << 8 | 0x7F_u32);
    can.start(&sim);
    let nominal = sim.with_wire(|wire| wire.config(sim_node(wire)).nominal);
    assert_eq!((nominal.quanta(), nominal.sjw), (385, 128));
}

fn sim_node(wire: &can_wire::Wire) -> can_wire::NodeId {
    wire.nodes().next().unwrap()
}

/// 2.3.4: values that are reserved: DBRP with TDC, zero segments.
#[test]
fn section_2_3_4_illegal_bit_timing_is_reported() {
    let (sim, can) = (Sim::new(), ());
    let () = can;
    let can = add(&sim, "can0");
    can.configure(&sim);
    sim.registers(can.id).write(0x00C, 1 << 23 | 2 << 16 | 0xA33_u32);
    sim.registers(can.id).write(0x01C, 0x0600_0003_u32);
    can.start(&sim);
    let text: Vec<String> = sim.diagnostics().iter().map(|d| d.kind.to_string()).collect();
    assert_eq!(text, ["NBTP.NTSEG1 is 0, legal are 1 to 255", "DBTP.DBRP is 2, legal are 0 to 1"]);
}

/// 3.1.4: TDCV is the measured delay plus TDCO, at most 127, cleared when INIT is set.
#[test]
fn section_3_1_4_transmitter_delay_compensation() {
    for (delay_ns, tdco, tdcf, expected) in [(250, 10, 0, 20), (2_750, 20, 0, 127), (250, 10, 30, 30)] {
        let sim = Sim::new();
        let can = add_with(&sim, "can0", |mut config| {
            config.place.tx_delay = Time::from_ns(delay_ns / 2);
            config.place.rx_delay = Time::from_ns(delay_ns / 2);
            config
        });
        can.set_up(&sim, &Setup { cccr: FD, ..SETUP });
        let regs = can.regs(&sim);
        regs.nbtp().write(pac::Nbtp::from_bits(0x1F << 25 | 3 << 16 | 0x3E << 8 | 0x0F));
        regs.dbtp().write(pac::Dbtp::from_bits(1 << 23 | 0x1E << 8 | 7 << 4 | 7));
        regs.tdcr().write(pac::Tdcr::RESET.with_tdco(tdco).with_tdcf(tdcf));
        let nominal = sim.with_wire(|wire| *wire.config(sim_node(wire)));
        let _ = nominal;
        regs.cccr().write(regs.cccr().read().with_init(false));
        sim.run_for(Time::from_us(200));
        can.send(&sim, 0, &frame("123##111"));
        sim.run_for(Time::from_us(600));
        assert_eq!(u32::from(regs.psr().read().tdcv()), expected, "delay {delay_ns} ns, TDCO {tdco}, TDCF {tdcf}");
        can.configure(&sim);
        assert_eq!(regs.psr().read().tdcv(), 0);
    }
}

/// 3.1.6: Bus Monitoring: receives, sends nothing, no acknowledgement; TXBRP is held in reset.
#[test]
fn section_3_1_6_bus_monitoring_mode() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &Setup { cccr: pac::Cccr::MON, ..SETUP });
    let other = add(&sim, "can1").run(&sim, &SETUP);
    let third = add(&sim, "can2").run(&sim, &SETUP);
    other.send(&sim, 0, &frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), Some(frame("123#11")));
    can.send(&sim, 0, &frame("100#"));
    assert_eq!(can.regs(&sim).txbrp().read().bits(), 0);
    third.configure(&sim);
    other.send(&sim, 0, &frame("124#11"));
    sim.run_for(FRAME * 4);
    assert_eq!(other.regs(&sim).psr().read().lec(), LastErrorCode::AckError, "nobody acknowledges");
    can.regs(&sim).cccr().write(pac::Cccr::ZERO);
    sim.run_for(FRAME * 30);
    assert_eq!(can.receive(&sim, 0), Some(frame("124#11")), "MON is reset at any time, and acknowledges again");
}

/// 3.1.5, 2.3.13: Restricted Operation: acknowledges, sends no frames, counters frozen, CEL counts.
#[test]
fn section_3_1_5_restricted_operation_mode() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &Setup { cccr: pac::Cccr::ASM, ..SETUP });
    let other = add(&sim, "can1").run(&sim, &SETUP);
    other.send(&sim, 0, &frame("123#11"));
    sim.run_for(FRAME);
    assert_eq!(other.regs(&sim).txbto().read().bits(), 1, "acknowledged");
    invert(&sim, can, Field::Data, 0, Frames::next());
    other.send(&sim, 0, &frame("124#FF"));
    sim.run_for(FRAME * 2);
    assert_eq!(
        other.regs(&sim).ecr().read().tec(),
        7,
        "the frame was not disturbed, but missed its only acknowledgement"
    );
    let ecr = can.regs(&sim).ecr().read();
    assert_eq!((ecr.tec(), ecr.rec(), ecr.cel()), (0, 0, 1));
    assert_eq!(can.regs(&sim).ecr().read().cel(), 0, "cleared by the read");
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).txbrp().read().bits(), 1, "waits");
    can.regs(&sim).cccr().write(pac::Cccr::ZERO);
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).txbto().read().bits(), 1);
}

/// 3.1.5: input `m_can_cok` of a Clock Calibration unit.
#[test]
fn section_3_1_5_clock_calibration() {
    let (sim, can) = running(&SETUP);
    sim.act(can.id, |model, cx| model.set_clock_ok(cx, false));
    assert!(can.regs(&sim).cccr().read().asm_());
    can.regs(&sim).cccr().write(pac::Cccr::ZERO);
    assert!(can.regs(&sim).cccr().read().asm_(), "held");
    sim.act(can.id, |model, cx| model.set_clock_ok(cx, true));
    assert!(!can.regs(&sim).cccr().read().asm_(), "as written");
}

/// 3.1.8: power down: pending transmissions, bus idle, INIT, CSA; and back.
#[test]
fn section_3_1_8_power_down() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    for buffer in 2..5 {
        can.write(&sim, buffer, &frame("123#1122334455667788"));
    }
    can.request(&sim, 0b1_1100);
    regs.cccr().write(pac::Cccr::CSR);
    sim.run_for(FRAME);
    assert_eq!(regs.cccr().read().bits(), pac::Cccr::CSR.bits(), "still sending");
    sim.run_for(FRAME * 3);
    assert_eq!(sim.peer_received(peer).len(), 3);
    assert_eq!(regs.cccr().read(), pac::Cccr::CSR | pac::Cccr::CSA | pac::Cccr::INIT);
    assert!(sim.inspect(can.id, |model| model.clock_stop_acknowledged()));
    regs.cccr().write(pac::Cccr::CSR);
    sim.run_for(Time::from_us(1));
    assert!(regs.cccr().read().init(), "held at one");
    regs.ie().write(pac::Ie::from_bits(1));
    assert_eq!(regs.ie().read().bits(), 1, "other registers are accessible");
    regs.cccr().write(pac::Cccr::INIT);
    assert_eq!(regs.cccr().read(), pac::Cccr::INIT);
    can.start(&sim);
    // By the pin: CSR reads one as long as it is active.
    sim.act(can.id, |model, cx| model.set_clock_stop_request(cx, true));
    sim.run_for(FRAME);
    assert_eq!(regs.cccr().read(), pac::Cccr::CSR | pac::Cccr::CSA | pac::Cccr::INIT);
    sim.act(can.id, |model, cx| model.set_clock_stop_request(cx, false));
    assert_eq!(regs.cccr().read(), pac::Cccr::INIT);
}

/// 3.1.9: loop back, internal and external.
#[test]
fn section_3_1_9_loop_back_modes() {
    for internal in [false, true] {
        let sim = Sim::new();
        let mode = if internal { pac::Cccr::TEST | pac::Cccr::MON } else { pac::Cccr::TEST };
        let can = add(&sim, "can0").run(&sim, &Setup { cccr: mode, test: pac::Test::LBCK, ..SETUP });
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        can.send(&sim, 0, &frame("123#11"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 0), Some(frame("123#11")));
        assert_eq!(can.regs(&sim).txbto().read().bits(), 1, "no acknowledgement is needed");
        assert_eq!(sim.peer_received(peer).len(), usize::from(!internal));
        let test = can.regs(&sim).test().read();
        assert!(test.sval() && test.txbns() == 0);
        can.regs(&sim).cccr().write(pac::Cccr::from_bits(mode.bits() & !pac::Cccr::TEST.bits()));
        assert_eq!(can.regs(&sim).test().read().bits() & !0x80, 0, "all test functions end with CCCR.TEST");
    }
}

/// 2.3.5: the transmit pin under software control, the receive pin.
#[test]
fn section_2_3_5_pin_control() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    let regs = can.regs(&sim);
    assert_eq!(regs.test().read().rx(), TestRx::Recessive);
    can.configure(&sim);
    regs.cccr().write(regs.cccr().read() | pac::Cccr::TEST);
    regs.test().write(pac::Test::RESET.with_tx(TestTx::Dominant));
    assert_eq!(regs.test().read().rx(), TestRx::Dominant, "the pin drives the bus");
    regs.test().write(pac::Test::RESET.with_tx(TestTx::Recessive));
    assert_eq!(regs.test().read().rx(), TestRx::Recessive);
    regs.test().write(pac::Test::RESET.with_tx(TestTx::Dominant));
    regs.cccr().write(pac::Cccr::INIT | pac::Cccr::CCE);
    assert_eq!(regs.test().read().bits(), 0x80, "CCCR.TEST = 0 gives the pin back");
}

/// 2.3.13, 2.3.14, 2.3.16: warning, error passive, Bus_Off, and the recovery in 129 sequences.
#[test]
fn section_2_3_14_bus_off_and_recovery() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    invert(&sim, can, Field::Data, 0, Frames::all());
    can.send(&sim, 0, &frame("123#00"));
    let seen = |flag: Ir| sim.run_until(FRAME * 100, |sim| can.ir(sim).contains(flag)).unwrap();
    seen(Ir::EW);
    let ecr = regs.ecr().read();
    assert_eq!((ecr.tec(), ecr.cel()), (96, 12));
    assert!(regs.psr().read().ew());
    seen(Ir::EP);
    let psr = regs.psr().read();
    assert!(psr.ep() && regs.ecr().read().tec() == 128, "{psr:?}");
    assert_eq!(psr.lec(), LastErrorCode::Bit0Error, "the first data bit was sent dominant");
    seen(Ir::BO);
    assert!(regs.psr().read().bo() && regs.cccr().read().init(), "INIT is set by hardware");
    sim.with_wire(|wire| wire.clear_faults());
    can.clear(&sim);
    let start = sim.now();
    regs.cccr().write(pac::Cccr::ZERO);
    sim.run_for(Time::from_us(11 * 64));
    // Toggling INIT starts the count again.
    can.configure(&sim);
    let restart = sim.now();
    can.start(&sim);
    sim.run_for(Time::from_us(11 * 10));
    let ecr = regs.ecr().read();
    assert!((10..=12).contains(&ecr.rec()), "REC counts the sequences: {ecr:?}");
    assert_eq!(regs.psr().read().lec(), LastErrorCode::Bit0Error);
    assert!(can.ir(&sim).contains(Ir::PEA));
    let end = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::BO)).unwrap();
    let length = end.since(restart);
    assert!((Time::from_us(11 * 129)..Time::from_us(11 * 129 + 5)).contains(&length), "{length}, {start}");
    let (ecr, psr) = (regs.ecr().read(), regs.psr().read());
    assert_eq!((ecr.tec(), ecr.rec(), ecr.rp(), psr.bo(), psr.ep(), psr.ew()), (0, 0, false, false, false, false));
    assert_eq!(regs.txbrp().read().bits(), 0, "configuration mode reset the request");
    can.send(&sim, 0, &frame("123#00"));
    sim.run_for(FRAME);
    assert_eq!(regs.txbto().read().bits(), 1);
}

/// 2.3.13: REC, RP, and CEL that sticks at 0xFF and then sets ELO.
#[test]
fn section_2_3_13_error_counters() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, 0, 127));
    sim.run_for(Time::from_us(1));
    assert_eq!((regs.ecr().read().rec(), regs.ecr().read().rp()), (127, false));
    invert(&sim, can, Field::Data, 0, Frames::next());
    sim.peer_send(peer, frame("123#00"));
    let found = sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::EP));
    assert!(found.is_some(), "{:#?} {}", sim.bus_log(), sim.describe(can.id));
    let ecr = regs.ecr().read();
    assert_eq!((ecr.rec(), ecr.rp(), ecr.cel()), (127, true, 0), "CEL does not count when only RP is set");
    sim.run_for(FRAME * 2);
    assert!(!regs.ecr().read().rp());
    let one_error = || {
        for node in [node, sim.peer_node(peer)] {
            sim.with_wire(|wire| wire.set_error_counters(node, 0, 0));
        }
        invert(&sim, can, Field::Data, 0, Frames::next());
        sim.peer_send(peer, frame("123#00"));
        sim.run_for(FRAME * 2);
    };
    for _ in 0..255 {
        one_error();
    }
    assert_eq!(sim.registers(can.id).read::<u8>(0x041), 0, "byte 1 leaves CEL alone");
    assert_eq!(can.ir(&sim) & Ir::ELO, Ir::ZERO);
    one_error();
    assert!(can.ir(&sim).contains(Ir::ELO), "CEL has stuck at 0xFF");
    assert_eq!((regs.ecr().read().cel(), regs.ecr().read().cel()), (0xFF, 0));
}

/// 2.3.14: LEC for the arbitration phase, DLEC once the data phase is reached; RFDF, RBRS, RESI whatever the filters say.
#[test]
fn section_2_3_14_error_codes_of_both_phases() {
    let (sim, can) = running(&Setup { cccr: FD, gfc: 2 << 4, ..SETUP });
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let codes = |text: &str| {
        sim.peer_send(peer, frame(text));
        sim.run_for(FRAME * 2);
        let psr = regs.psr().read();
        (psr.lec().bits(), psr.dlec().bits(), psr.rfdf(), psr.rbrs(), psr.resi())
    };
    assert_eq!(codes("123#11"), (0, 7, false, false, false));
    assert_eq!(codes("123##011"), (0, 7, true, false, false));
    assert_eq!(codes("123##311"), (7, 0, true, true, true), "the next event of such a frame is shown in DLEC");
    assert_eq!(regs.psr().read().bits() & 0x7F07, 0x0707, "the read has cleared all of it");
    for (field, flag, lec) in
        [(Field::Dlc, Ir::PED, false), (Field::CrcDelimiter, Ir::PED, false), (Field::Fdf, Ir::PEA, true)]
    {
        can.clear(&sim);
        invert(&sim, can, field, 0, Frames::next());
        sim.peer_send(peer, frame("123##111"));
        sim.run_until(FRAME * 2, |sim| can.ir(sim).intersects(Ir::PEA | Ir::PED)).unwrap();
        assert_eq!(can.ir(&sim) & (Ir::PEA | Ir::PED), flag, "{field}");
        let psr = regs.psr().read();
        assert_eq!((psr.lec().bits() != 7, psr.dlec().bits() != 7), (lec, !lec), "{field}");
        sim.run_for(FRAME * 2);
        let _ = regs.psr().read();
    }
}

/// 3.1.3: protocol exception: PXE, integrating; with PXHD a form error; FDOE = 0 answers FD frames with error frames.
#[test]
fn section_3_1_3_protocol_exception() {
    for pxhd in [false, true] {
        let extra = if pxhd { pac::Cccr::PXHD } else { pac::Cccr::ZERO };
        let (sim, can) = running(&Setup { cccr: FD | extra, ..SETUP });
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        invert(&sim, can, Field::Res, 0, Frames::next());
        sim.peer_send(peer, frame("123##011"));
        sim.run_until(FRAME, |sim| sim.registers(can.id).read::<u8>(0x045) & 0x40 != 0).unwrap();
        let psr = can.regs(&sim).psr().read();
        assert!(psr.pxe());
        assert_eq!(psr.act() == Activity::Synchronizing, !pxhd);
        assert_eq!(psr.lec() == LastErrorCode::FormError, pxhd);
        assert!(!can.regs(&sim).psr().read().pxe());
    }
    let (sim, can) = running(&SETUP);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    sim.peer_send(peer, frame("123##011"));
    sim.run_for(FRAME);
    assert!(can.ir(&sim).contains(Ir::PEA));
    assert!(sim.peer_sent(peer).is_empty());
}

/// 2.3.9, 2.3.10, 3.2.1: timestamps: internal with prescaler, external, zero; wrap-around; reset by a write.
#[test]
fn section_3_2_1_timestamps() {
    for tcp in [0, 3] {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, &SETUP);
        can.regs(&sim).tscc().write(pac::Tscc::from_bits(tcp << 16 | 1));
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        sim.registers(can.id).write(0x027, 0x55_u8);
        let reset = sim.now();
        sim.run_for(Time::from_us(1_000));
        let tsc = u64::from(can.regs(&sim).tscv().read().tsc());
        let bits = sim.now().since(reset).as_ns() / 1_000;
        assert!(tsc.abs_diff(bits / u64::from(tcp + 1)) <= 1, "{tsc} after {bits} bits");
        sim.peer_send(peer, frame("123#11"));
        sim.run_for(FRAME);
        let rxts = u64::from(sim.with_memory(can.ram, |memory| memory.word(0x11).unwrap()) & 0xFFFF);
        assert!((tsc..=tsc + 3).contains(&rxts), "captured at SOF: {rxts}, {tsc}");
        assert!(!can.ir(&sim).contains(Ir::TSW), "a write is no wrap-around");
        let wrap = sim.run_until(Time::from_ms(70 * 4), |sim| can.ir(sim).contains(Ir::TSW)).unwrap();
        let bits = wrap.since(reset).as_ns() / 1_000;
        assert!(bits.abs_diff(65_536 * u64::from(tcp + 1)) <= 20, "{bits}");
    }
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, &SETUP);
    can.regs(&sim).tscc().write(pac::Tscc::from_bits(2));
    can.start(&sim);
    sim.registers(can.id).write(0x024, 0_u32);
    assert_eq!(u64::from(can.regs(&sim).tscv().read().tsc()), sim.now().as_ns() / 1_000, "a write does nothing");
    assert!(!sim.diagnostics().is_empty());
}

/// 2.3.11, 2.3.12, 3.3: the timeout counter in Continuous Mode and under FIFO control.
#[test]
fn section_3_3_timeout_counter() {
    let bench = |tocc: u32| {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, &SETUP);
        can.regs(&sim).tocc().write(pac::Tocc::from_bits(tocc));
        assert_eq!(can.regs(&sim).tocv().read().bits(), 500);
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        (sim, can, peer)
    };
    let toc = |sim: &Sim, can: Can| u64::from(can.regs(sim).tocv().read().toc());
    let (sim, can, _) = bench(500 << 16 | 1);
    let left = toc(&sim, can);
    assert!((250..300).contains(&left), "runs since INIT was reset: {left}");
    sim.registers(can.id).write(0x02F, 0_u8);
    let preset = sim.now();
    assert!((499..=500).contains(&toc(&sim, can)));
    for expiry in 1..4_u64 {
        let at = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::TOO)).unwrap();
        assert!(at.since(preset).as_ns().abs_diff(500_000 * expiry) < 2_000, "restarts at TOP at once");
        can.clear(&sim);
    }
    can.configure(&sim);
    assert_eq!(toc(&sim, can), 500);
    for (tos, filter) in [(2, 0), (3, 1 << 4)] {
        let (sim, can, peer) = bench(500 << 16 | tos << 1 | 1);
        can.configure(&sim);
        can.regs(&sim).gfc().write(pac::Gfc::from_bits(filter));
        can.start(&sim);
        sim.run_for(FRAME * 5);
        assert_eq!(toc(&sim, can), 500, "an empty FIFO presets the counter");
        sim.peer_send(peer, frame("123#"));
        sim.run_until(FRAME, |sim| toc(sim, can) < 500).unwrap();
        let stored = sim.now();
        sim.registers(can.id).write(0x02C, 0_u32);
        assert!(toc(&sim, can) < 500, "a write does nothing");
        let at = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::TOO)).unwrap();
        assert!(at.since(stored).as_ns().abs_diff(500_000) < 3_000, "{}", at.since(stored));
        can.clear(&sim);
        sim.run_for(Time::from_ms(2));
        assert_eq!((toc(&sim, can), can.ir(&sim) & Ir::TOO), (0, Ir::ZERO), "stopped");
        assert!(can.receive(&sim, tos as usize - 2).is_some());
        assert_eq!(toc(&sim, can), 500);
    }
}

/// 2.3.16 to 2.3.19: flags, enables, line selection, line enables; handlers see the lines.
#[test]
fn section_2_3_16_interrupt_lines() {
    let (sim, can) = running(&SETUP);
    let regs = can.regs(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    let changes = Rc::new(RefCell::new(Vec::new()));
    for line in 0..2 {
        let changes = Rc::clone(&changes);
        sim.on_line(can.id, line, move |_, level| changes.borrow_mut().push((line, level)));
    }
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert!(can.ir(&sim).contains(Ir::RF0N), "set without being enabled");
    regs.ie().write(pac::Ie::from_bits(Ir::RF0N.bits()));
    assert!(!sim.line(can.id, 0), "both lines are disabled after reset");
    regs.ile().write(pac::Ile::from_bits(3));
    assert!(sim.line(can.id, 0) && !sim.line(can.id, 1));
    regs.ils().write(pac::Ils::from_bits(Ir::RF0N.bits()));
    assert!(!sim.line(can.id, 0) && sim.line(can.id, 1));
    regs.ir().clear(Ir::RF0N);
    assert!(!sim.line(can.id, 1));
    assert_eq!(*changes.borrow(), [(0, true), (0, false), (1, true), (1, false)]);
    // A level-sensitive handler that receives.
    let received = Rc::new(RefCell::new(Vec::new()));
    let sink = Rc::clone(&received);
    sim.on_interrupt(can.id, 1, move |sim| {
        can.regs(sim).ir().clear(Ir::RF0N);
        while let Some(frame) = can.receive(sim, 0) {
            sink.borrow_mut().push(frame);
        }
    });
    for text in ["200#", "201#", "202#", "203#"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 5);
    let texts: Vec<String> = received.borrow().iter().map(ToString::to_string).collect();
    assert_eq!(texts, ["123#", "200#", "201#", "202#", "203#"]);
}

/// `per_buffer_enable_gates`: whether TXBTIE keeps IR.TC from being set, or only from reaching the line.
#[test]
fn section_2_3_43_per_buffer_enables() {
    for gates in [true, false] {
        let sim = Sim::new();
        let can =
            add_with(&sim, "can0", |config| config.with_choices(choices(|c| c.per_buffer_enable_gates_flag = gates)));
        can.run(&sim, &SETUP);
        sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        let regs = can.regs(&sim);
        regs.ie().write(pac::Ie::from_bits(Ir::TC.bits()));
        regs.ile().write(pac::Ile::EINT0);
        regs.txbtie().write(pac::Txbtie::from_bits(2));
        can.send(&sim, 0, &frame("123#"));
        sim.run_for(FRAME);
        assert_eq!((can.ir(&sim).contains(Ir::TC), sim.line(can.id, 0)), (!gates, false));
        can.clear(&sim);
        can.send(&sim, 1, &frame("123#"));
        sim.run_for(FRAME);
        assert_eq!((can.ir(&sim).contains(Ir::TC), sim.line(can.id, 0)), (true, true));
    }
}

/// 2.3.6, 2.3.16: watchdog and bit errors of the Message RAM.
#[test]
fn section_2_3_16_message_ram_failures() {
    let (sim, can) = running(&SETUP);
    let fail = |failure| sim.act(can.id, |model, cx| model.fail_ram(cx, failure));
    fail(RamFailure::NoAnswer);
    assert_eq!(can.ir(&sim) & Ir::WDI, Ir::ZERO, "WDC = 0 disables the watchdog");
    fail(RamFailure::Corrected);
    assert_eq!(can.ir(&sim) & (Ir::BEC | Ir::BEU), Ir::BEC);
    assert!(!can.regs(&sim).cccr().read().init());
    for _ in 0..2 {
        fail(RamFailure::Uncorrected);
        assert!(can.ir(&sim).contains(Ir::BEU) && can.regs(&sim).cccr().read().init());
        can.start(&sim);
        assert_eq!(can.regs(&sim).psr().read().act(), Activity::Idle, "clearing INIT suffices");
    }
    can.configure(&sim);
    can.regs(&sim).rwd().write(pac::Rwd::RESET.with_wdc(0x40));
    assert_eq!(can.regs(&sim).rwd().read().wdv(), 0x40);
    can.start(&sim);
    fail(RamFailure::NoAnswer);
    assert!(can.ir(&sim).contains(Ir::WDI));
}

/// 2.3.8: a write inside a frame: INIT stops the transfer at once, and the request is served afterwards (3.1.1, 3.1.8).
#[test]
fn section_3_1_8_init_stops_within_a_frame() {
    let (sim, can) = running(&SETUP);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    can.send(&sim, 0, &frame("123#1122334455667788"));
    sim.run_for(Time::from_us(40));
    can.regs(&sim).cccr().write(pac::Cccr::INIT);
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(peer).len(), 0);
    assert_eq!(can.regs(&sim).txbrp().read().bits(), 1, "INIT alone resets nothing");
    can.start(&sim);
    sim.run_for(FRAME * 2);
    assert_eq!(sim.peer_received(peer).len(), 1);
}
