//! Operating modes, bit timing and test modes: sections 2.3.4 to 2.3.8, 3.1 of the manual.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, add_with, frame};
use can_sim::{Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
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
    regs.nbtp().write(crate::bench::NBTP);
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
    let sim = Sim::new();
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
