//! Where the manual is silent: each choice that can be changed, both ways; and where sections of Message RAM lie.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add_with, choices, frame};
use can_sim::{
    PeerId, Sim, Time,
    m_can::{Choices, MCanConfig},
    registers::UnknownReset,
};
use can_wire::{BitFault, ErrorState, Fault, Field, Frames, NodeConfig, Position};
use m_can_pac::registers::{self as pac, Ir};
use regbus::Bus;

fn bench(setup: &Setup, change: impl FnOnce(&mut Choices)) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |config| config.with_choices(choices(change))).run(&sim, setup);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    (sim, can, peer)
}

#[test]
fn watermark_repetition() {
    for repeats in [false, true] {
        let setup = Setup { rxf0c: 1 << 24 | 3 << 16 | 0x40, ..SETUP };
        let (sim, can, peer) = bench(&setup, |c| c.watermark_repeats = repeats);
        let mut flags = Vec::new();
        for _ in 0..3 {
            sim.peer_send(peer, frame("123#"));
            sim.run_for(FRAME);
            flags.push(can.ir(&sim).contains(Ir::RF0W));
            can.clear(&sim);
        }
        assert_eq!(flags, [true, repeats, repeats]);
    }
}

#[test]
fn bus_off_recovery() {
    for (length, pea) in [(129_u16, true), (128, false)] {
        let (sim, can, _) = bench(&SETUP, |c| {
            c.bus_off_recovery_length = length;
            c.bus_off_recovery_sets_pea = pea;
        });
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_error_counters(node, 255, 0));
        assert_eq!(can.regs(&sim).ecr().read().cel(), 1);
        let position = Position::new(Field::Data, 0);
        let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
        sim.with_wire(|wire| wire.inject(fault));
        can.send(&sim, 0, &frame("123#00"));
        sim.run_until(FRAME, |sim| sim.with_wire(|wire| wire.error_state(node)) == ErrorState::BusOff).unwrap();
        assert!(can.regs(&sim).psr().read().bo());
        let cel = can.regs(&sim).ecr().read().cel();
        assert_eq!(cel, 1, "reaching the Bus_Off limit is logged, although TEC shows no change");
        can.clear(&sim);
        let start = sim.now();
        can.regs(&sim).cccr().write(pac::Cccr::ZERO);
        let end = sim.run_until(Time::from_ms(2), |sim| can.ir(sim).contains(Ir::BO)).unwrap().since(start);
        assert_eq!(end.as_ns() / 11_000, u64::from(length));
        assert_eq!(can.ir(&sim).contains(Ir::PEA), pea);
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).txbto().read().bits(), 1, "the request was still pending, and is served");
    }
}

#[test]
fn protocol_exception_when_disabled() {
    for flag in [true, false] {
        let setup = Setup { cccr: FD | pac::Cccr::PXHD, ..SETUP };
        let (sim, can, peer) = bench(&setup, |c| c.exception_flag_when_disabled = flag);
        let (node, position) = (sim.node(can.id), Position::new(Field::Res, 0));
        let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
        sim.with_wire(|wire| wire.inject(fault));
        sim.peer_send(peer, frame("123##011"));
        sim.run_until(FRAME, |sim| can.ir(sim).contains(Ir::PEA)).unwrap();
        assert_eq!(can.regs(&sim).psr().read().pxe(), flag);
    }
}

#[test]
fn debug_state_transition_t5() {
    for restarts in [true, false] {
        let sim = Sim::new();
        let can = add_with(&sim, "can0", |config| config.with_choices(choices(|c| c.debug_a_restarts = restarts)));
        can.set_up(&sim, &Setup { sidfc: 2 << 16, ..SETUP });
        can.memory(&sim).write(0, 7_u32 << 27 | 0x701 << 16 | 1 << 9);
        can.memory(&sim).write(4, 7_u32 << 27 | 0x702 << 16 | 2 << 9 | 1);
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        for text in ["701#", "702#", "701#"] {
            sim.peer_send(peer, frame(text));
        }
        sim.run_for(FRAME * 5);
        assert_eq!(can.regs(&sim).rxf1s().read().dms().bits(), u8::from(restarts));
    }
}

#[test]
fn received_data_padding() {
    for zero in [true, false] {
        let (sim, can, peer) = bench(&SETUP, |c| c.received_padding_is_zero = zero);
        sim.with_memory(can.ram, |memory| memory.words_mut()[0x12] = 0xEEEE_EEEE);
        sim.peer_send(peer, frame("123#1122"));
        sim.run_for(FRAME);
        let word = sim.with_memory(can.ram, |memory| memory.word(0x12).unwrap());
        assert_eq!(word, if zero { 0x2211 } else { 0xEEEE_2211 });
    }
}

/// The ESI bit on request is no error state; an error passive node sends it recessive anyway (2.4.3).
#[test]
fn tx_event_esi() {
    for as_transmitted in [true, false] {
        let setup = Setup { cccr: FD, ..SETUP };
        let (sim, can, peer) = bench(&setup, |c| c.event_esi_as_transmitted = as_transmitted);
        can.write_with(&sim, 0, &frame("123##011"), |t1| t1.with_efc(true));
        sim.with_memory(can.ram, |memory| memory.words_mut()[0x14C0 / 4] |= 1 << 31);
        can.request(&sim, 1);
        sim.run_for(FRAME);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_error_counters(node, 128, 0));
        can.write_with(&sim, 0, &frame("124##011"), |t1| t1.with_efc(true));
        can.request(&sim, 1);
        sim.run_for(FRAME);
        let memory = sim.with_memory(can.ram, |memory| memory.clone());
        let events = sim.inspect(can.id, |model| model.tx_events(&memory));
        let esi: Vec<u8> = events.iter().map(|event| event.e0.esi().bits()).collect();
        assert_eq!(esi, [u8::from(as_transmitted), 1]);
        let sent: Vec<bool> = sim.peer_received(peer).iter().map(|(_, f)| f.error_state_indicator()).collect();
        assert_eq!(sent, [true, true]);
    }
}

/// 2.4.1, d.8: the worked configuration: all sections with 64-byte elements.
#[test]
fn section_2_4_1_message_ram_layout() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |config| config);
    can.set_up(
        &sim,
        &Setup {
            sidfc: 0x001C_0000,
            xidfc: 0x0008_0070,
            rxf0c: 0x1020_00B0,
            rxf1c: 0x0004_09B0,
            rxbc: 0x0AD0,
            txefc: 0x0408_0B60,
            txbc: 0x140C_0BA0,
            rxesc: 0x777,
            txesc: 7,
            ..SETUP
        },
    );
    let layout = sim.inspect(can.id, |model| model.layout());
    let of = |name: &str| *layout.iter().find(|section| section.name == name).unwrap();
    assert_eq!(of("rx_fifo_0").address(5), 0x218);
    assert_eq!(of("extended_filters").address(3), 0x088);
    assert_eq!(of("rx_buffers").address(1), 0xB18);
    assert_eq!(of("tx_event_fifo").address(7), 0xB98);
    assert_eq!(of("tx_buffers").address(15), 0xFD8);
    assert_eq!(of("tx_buffers").end(), 0x14A0);
    assert_eq!(layout.iter().map(|s| s.count).collect::<Vec<_>>(), [28, 8, 32, 4, 1, 8, 32]);
    can.start(&sim);
    assert_eq!(sim.diagnostics(), [], "nothing overlaps");
}

/// 1.2: several M_CANs share one Message RAM, here back to back.
#[test]
fn section_1_2_shared_message_ram() {
    let sim = Sim::new();
    let ram = sim.add_memory(can_sim::Memory::new(2_000));
    let cans = ["can0", "can1"].map(|name| Can { id: sim.add_m_can(name, MCanConfig::new(ram)).unwrap(), ram });
    let second = Setup { rxf0c: 3 << 16 | 0x1000, txbc: 3 << 24 | 0x1200, rxf1c: 0, txefc: 0, rxbc: 0, ..SETUP };
    let first = Setup { txbc: 3 << 24 | 0x200, rxf1c: 0, txefc: 0, rxbc: 0, ..SETUP };
    cans[0].run(&sim, &first);
    cans[1].run(&sim, &second);
    cans[0].send(&sim, 0, &frame("123#11"));
    cans[1].send(&sim, 0, &frame("124#22"));
    sim.run_for(FRAME * 3);
    assert_eq!(cans[0].receive(&sim, 0), Some(frame("124#22")));
    assert_eq!(cans[1].receive(&sim, 0), Some(frame("123#11")));
    assert_eq!(sim.diagnostics(), []);
}

/// Bits without a defined value differ from seed to seed, and are the same for the same seed.
#[test]
fn unknown_reset_values() {
    let crel = |seed| {
        let file = can_sim::registers::RegisterFile::new(&m_can_pac::meta::CONTROLLER, UnknownReset::Pattern(seed));
        file.get(file.find("CUST", 0, 0).unwrap())
    };
    assert_eq!(crel(1), crel(1));
    assert_ne!(crel(1), crel(2));
}
