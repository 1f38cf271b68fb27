//! Details that a wrong model could get away with otherwise: each of these tests was written after breaking a rule that
//! no other test noticed.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, add_with, choices, frame};
use can_sim::{
    DiagnosticKind, Memory, PeerId, Sim, Time,
    m_can::{MCanConfig, RamFailure},
};
use can_wire::{Disturbance, Fault, Line, NodeConfig};
use m_can_pac::{
    enums::Activity,
    registers::{self as pac, Ir},
};
use regbus::Bus;

fn bench_of(add: impl FnOnce(&Sim, &str) -> Can, setup: &Setup) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, setup);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    (sim, can, peer)
}

/// `partly_stored_message`: an error in the sixth data byte: the word with bytes 4 to 7 was not complete and stays.
#[test]
fn section_3_4_1_only_complete_words_are_stored() {
    let (sim, can, peer) = bench_of(add, &SETUP);
    sim.with_memory(can.ram, |memory| memory.words_mut()[0x10..0x14].fill(0xEEEE_EEEE));
    sim.peer_send(peer, frame("123#5555555555555555"));
    sim.run_until(FRAME, |sim| can.regs(sim).psr().read().act() == Activity::Receiver).unwrap();
    let (from, until) = (sim.now() + Time::from_us(62), sim.now() + Time::from_us(70));
    sim.with_wire(|wire| wire.inject(Fault::Disturb { line: Line::Bus, how: Disturbance::Dominant, from, until }));
    sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::PEA)).unwrap();
    let words = sim.with_memory(can.ram, |memory| memory.words()[0x10..0x14].to_vec());
    assert_eq!((words[0], words[2..].to_vec()), (0x123 << 18, vec![0x5555_5555, 0xEEEE_EEEE]));
}

/// 2.4.2: FIDX and ANMF stand in R1B as in R1A.
#[test]
fn section_2_4_2_filter_index_with_a_timestamping_unit() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |mut config| {
        config.tsu_registers = Some(1);
        config
    });
    can.set_up(&sim, &Setup { cccr: pac::Cccr::UTSU, sidfc: 2 << 16, ..SETUP });
    can.memory(&sim).write(4, 1_u32 << 30 | 1 << 27 | 0x100 << 16 | 0x100);
    can.start(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.peer_send(peer, frame("100#1122"));
    sim.run_for(FRAME);
    assert_eq!(sim.with_memory(can.ram, |memory| memory.words()[0x11]), 1 << 24 | 2 << 16);
}

/// 2.3.47, `acknowledge_wrap`: the get index of the Tx Event FIFO wraps at its size.
#[test]
fn section_2_3_47_the_event_get_index_wraps() {
    let (sim, can, _) = bench_of(add, &Setup { txefc: 2 << 16 | 0x1480, ..SETUP });
    for expected in [(1, 0, 1), (0, 0, 2)] {
        can.write_with(&sim, 0, &frame("100#"), |t1| t1.with_efc(true));
        can.request(&sim, 1);
        sim.run_for(FRAME);
        let status = can.regs(&sim).txefs().read();
        assert_eq!((status.efpi(), status.efgi(), status.effl()), expected);
    }
    can.regs(&sim).txefa().write(pac::Txefa::RESET.with_efai(1));
    sim.run_for(Time::from_us(1));
    let status = can.regs(&sim).txefs().read();
    assert_eq!((status.efpi(), status.efgi(), status.effl(), status.eff()), (0, 0, 0, false));
    can.request(&sim, 1);
    sim.run_for(FRAME);
    let status = can.regs(&sim).txefs().read();
    assert_eq!((status.efpi(), status.efgi(), status.effl()), (1, 0, 1));
}

/// 3.1.8: CSR reads 1 as long as the pin is active, whatever is written, and falls with the pin.
#[test]
fn section_3_1_8_the_pin_holds_csr() {
    let (sim, can, _) = bench_of(add, &SETUP);
    sim.act(can.id, |model, cx| model.set_clock_stop_request(cx, true));
    sim.run_for(FRAME);
    can.regs(&sim).cccr().write(pac::Cccr::INIT);
    assert!(can.regs(&sim).cccr().read().csr());
    sim.act(can.id, |model, cx| model.set_clock_stop_request(cx, false));
    assert!(!can.regs(&sim).cccr().read().csr());
}

/// `restricted_mode_sources`: what a failure of the Tx Handler has set, `m_can_cok` does not clear.
#[test]
fn section_3_1_5_the_clock_does_not_end_a_failure() {
    let (sim, can, _) = bench_of(add, &SETUP);
    sim.act(can.id, |model, cx| model.fail_ram(cx, RamFailure::TxTooLate));
    can.send(&sim, 0, &frame("100#11"));
    sim.run_for(FRAME);
    for ok in [false, true] {
        sim.act(can.id, |model, cx| model.set_clock_ok(cx, ok));
        assert!(can.regs(&sim).cccr().read().asm_());
    }
}

/// `timestamp_counter_with_fd`: bits of a data phase count as what they are, once, also in loop back.
#[test]
fn section_3_2_1_counting_in_a_data_phase() {
    for loops in [false, true] {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        let (cccr, test) = if loops { (FD | pac::Cccr::TEST, pac::Test::LBCK) } else { (FD, pac::Test::ZERO) };
        can.set_up(&sim, &Setup { cccr, test, ..SETUP });
        can.regs(&sim).tscc().write(pac::Tscc::from_bits(1));
        can.start(&sim);
        let _peer = (!loops).then(|| sim.add_peer(NodeConfig::new()).unwrap());
        sim.run_for(FRAME);
        sim.registers(can.id).write(0x024, 0_u32);
        let reset = sim.now();
        can.send(&sim, 0, &frame(&format!("123##1{}", "55".repeat(64))));
        sim.run_for(FRAME * 2);
        let bits = sim.now().since(reset).as_ns() / 1_000;
        let gained = u64::from(can.regs(&sim).tscv().read().tsc()) - bits;
        // Some 560 bits of 0.2 us.
        assert!((400..500).contains(&gained), "{gained}");
    }
}

/// 2.3.5: TEST shows which buffer is prepared, and which was started last.
#[test]
fn section_2_3_5_prepared_and_started_buffer() {
    let (sim, can, peer) = bench_of(add, &Setup { cccr: pac::Cccr::TEST, ..SETUP });
    let test = || {
        let test = can.regs(&sim).test().read();
        (test.pval(), test.txbnp(), test.sval(), test.txbns())
    };
    assert_eq!(test(), (false, 0, false, 0));
    sim.peer_send(peer, frame("001#1122334455667788"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 1, &frame("200#"));
    sim.run_for(Time::from_us(1));
    assert_eq!(test(), (true, 1, false, 0));
    can.send(&sim, 2, &frame("100#"));
    sim.run_for(Time::from_us(1));
    assert_eq!(test(), (true, 2, false, 0), "the better one is prepared");
    sim.run_until(FRAME, |sim| can.regs(sim).psr().read().act() == Activity::Transmitter).unwrap();
    let (_, _, started, buffer) = test();
    assert_eq!((started, buffer), (true, 2));
    sim.run_for(FRAME);
    assert_eq!((test().0, test().2, test().3), (false, true, 1));
}

/// The alternative of `per_buffer_enable_gates`: clearing the flag also ends what an enabled buffer has signalled.
#[test]
fn section_2_3_43_a_cleared_flag_signals_no_more() {
    let add = |sim: &Sim, name: &str| {
        add_with(sim, name, |config| config.with_choices(choices(|c| c.per_buffer_enable_gates_flag = false)))
    };
    let (sim, can, _) = bench_of(add, &SETUP);
    can.regs(&sim).ie().write(pac::Ie::from_bits(Ir::TC.bits()));
    can.regs(&sim).ile().write(pac::Ile::EINT0);
    can.regs(&sim).txbtie().write(pac::Txbtie::from_bits(2));
    for (buffer, line) in [(1, true), (0, false)] {
        can.clear(&sim);
        can.send(&sim, buffer, &frame("123#"));
        sim.run_for(FRAME);
        assert_eq!((can.ir(&sim).contains(Ir::TC), sim.line(can.id, 0)), (true, line));
    }
}

/// `requests_during_configuration`: a request that has not been taken over when CCE is set is forgotten.
#[test]
fn section_3_1_1_requests_under_way_are_forgotten() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |config| config.with_choices(choices(|c| c.command_delay = 400)));
    can.configure(&sim);
    sim.registers(can.id).write(0x0C0, SETUP.txbc);
    can.regs(&sim).cccr().write(pac::Cccr::INIT);
    can.request(&sim, 1);
    can.regs(&sim).cccr().write(pac::Cccr::INIT | pac::Cccr::CCE);
    can.regs(&sim).cccr().write(pac::Cccr::INIT);
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).txbrp().read().bits(), 0);
    can.request(&sim, 1);
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).txbrp().read().bits(), 1, "without CCE it is taken over");
}

/// `message_ram_overrun`: word addresses have 14 bits and wrap.
#[test]
fn section_2_4_1_addresses_wrap() {
    let sim = Sim::new();
    let ram = sim.add_memory(Memory::new(16_384));
    let can = Can { id: sim.add_m_can("can0", MCanConfig::new(ram)).unwrap(), ram };
    can.run(&sim, &Setup { rxf0c: 3 << 16 | 0xFFF8, ..SETUP });
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.peer_send(peer, frame("123#11223344"));
    sim.run_for(FRAME);
    let words = sim.with_memory(ram, |memory| [memory.words()[0x3FFE], memory.words()[0]]);
    assert_eq!(words, [0x123 << 18, 0x4433_2211]);
    assert!(matches!(sim.diagnostics()[..], [ref d] if matches!(d.kind, DiagnosticKind::SectionBeyondMemory { .. })));
}
