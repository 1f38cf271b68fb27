//! Chapter 34.9: received messages in memory.

use can_sim::{Time, pic32_can::Element};
use pic32_can_pac::registers::{Con, Int};

use crate::bench::*;

/// Table 34-5, Example 34-13: the words of full messages.
#[test]
fn full_messages() {
    let (sim, can, peer) = bench(&[Use::Rx(4)]);
    for text in ["123#1122334455667788", "0408C000#AABB", "7FF#", "18DAF110#R3"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 5);
    let words = |n: u32| [0, 4, 8, 12].map(|at| can.word(&sim, 0x100 + n * 16 + at));
    assert_eq!(words(0), [0x0000_0123, 0x0000_0008, 0x4433_2211, 0x8877_6655]);
    assert_eq!(words(1), [0x0000_0102, 0x3300_0002, 0x0000_BBAA, 0]);
    assert_eq!(words(2), [0x0000_07FF, 0, 0, 0]);
    // 0x18DAF110: SID 0x636, EID 0x2F110.
    assert_eq!(words(3), [0x0000_0636, 1 << 29 | 1 << 28 | 0x2_F110 << 10 | 1 << 9 | 3, 0, 0]);
}

/// remote_frame_to_receive_fifo, remote_flag_of_standard_frames: stored with its length, marked in both bits.
#[test]
fn remote_frames() {
    let (sim, can, peer) = bench(&[Use::Rx(4)]);
    sim.peer_send(peer, frame("123#R5"));
    sim.run_for(FRAME);
    assert_eq!(can.word(&sim, 0x104), 1 << 29 | 1 << 9 | 5);
    assert_eq!(can.receive(&sim, 0).unwrap().to_string(), "123#R5");
}

/// 34.9.1, Table 34-6: eight bytes a message, the unused ones 0, whatever CANCAP is.
#[test]
fn data_only_messages() {
    let (sim, can, peer) = bench(&[Use::DataOnly(3)]);
    can.regs(&sim).con().set_bits(Con::CANCAP);
    sim.with_memory(can.ram, |memory| memory.words_mut()[0x40..0x48].fill(0xFFFF_FFFF));
    for text in ["123#112233", "124#1122334455667788", "125#"] {
        sim.peer_send(peer, frame(text));
    }
    sim.run_for(FRAME * 4);
    assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x100);
    assert_eq!(can.look_at_data(&sim, 0x100), [0x11, 0x22, 0x33, 0, 0, 0, 0, 0]);
    can.advance(&sim, 0);
    assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x108, "UINC moves by 8");
    assert_eq!(can.look_at_data(&sim, 0x108), [0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88]);
    can.advance(&sim, 0);
    assert_eq!(can.look_at_data(&sim, 0x110), [0; 8]);
    can.advance(&sim, 0);
    assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x100, "wraps");
    assert_eq!(can.word(&sim, 0x118), 0xFFFF_FFFF, "nothing behind it");
}

/// 34.9.2: the memory behind a message stays as it was.
#[test]
fn messages_stay_in_their_buffers() {
    let (sim, can, peer) = bench(&[Use::Rx(2)]);
    sim.with_memory(can.ram, |memory| memory.words_mut().fill(0xDEAD_BEEF));
    for _ in 0..3 {
        sim.peer_send(peer, frame("123#1122334455667788"));
    }
    sim.run_for(FRAME * 4);
    let changed: Vec<usize> = sim.with_memory(can.ram, |memory| {
        memory.words().iter().enumerate().filter(|(_, word)| **word != 0xDEAD_BEEF).map(|(n, _)| n * 4).collect()
    });
    assert_eq!(changed, (0x100..0x120).step_by(4).collect::<Vec<_>>());
    assert!(can.fifo(&sim, 0).int_().read().rxovflif());
}

/// 34.2: a message is acknowledged whether a filter accepts it or not.
#[test]
fn acknowledged_but_not_accepted() {
    let sim = can_sim::Sim::new();
    let can = add(&sim, "can1").run(&sim, 0x100, &[Use::Rx(2)]);
    let peer = add_peer(&sim);
    sim.peer_send(peer, frame("123#"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(peer).len(), 1);
    assert_eq!(can.receive(&sim, 0), None);
}

/// What a FIFO holds, decoded by the model.
#[test]
fn looking_into_fifos() {
    let (sim, can, peer) = bench(&[Use::Rx(2), Use::Tx(2), Use::DataOnly(2)]);
    sim.peer_send(peer, frame("123#1122"));
    can.queue(&sim, 1, &frame("00000400#33"));
    sim.run_for(FRAME);
    let memory = sim.with_memory(can.ram, |memory| memory.clone());
    let look = |fifo| sim.inspect(can.id, |model| model.fifo(&memory, fifo));
    let received = Element::Message { address: 0x100, frame: frame("123#1122"), filter: Some(0), timestamp: Some(0) };
    assert_eq!(look(0), [received]);
    let queued = Element::Message { address: 0x120, frame: frame("00000400#33"), filter: None, timestamp: None };
    assert_eq!(look(1), [queued]);
    assert_eq!(look(2), []);
    let text = sim.describe(can.id);
    assert!(text.contains("FIFO 0: receive, 1 of 2 messages, from 0x100, software at 0, module at 1"), "{text}");
    assert!(text.contains("FIFO 1: transmit, 1 of 2 messages, from 0x120"), "{text}");
    assert!(text.contains("Normal mode"), "{text}");
}

/// 34.12.1.6: a message that cannot be stored before the next one arrives.
#[test]
fn bus_bandwidth_error() {
    let (sim, can, peer) = bench(&[Use::Rx(4)]);
    can.regs(&sim).int_().set_bits(Int::SERRIE | Int::RBOVIE);
    can.fifo(&sim, 0).int_().set_bits(pic32_can_pac::registers::FifoInt::RXOVFLIE);
    sim.act(can.id, |model, cx| model.block_system_bus(cx, Time::from_us(80)));
    sim.peer_send(peer, frame("100#"));
    sim.run_for(Time::from_us(70));
    assert!(!can.fifo(&sim, 0).int_().read().rxnemptyif(), "it waits for the bus");
    sim.run_for(FRAME);
    assert_eq!(can.receive(&sim, 0), Some(frame("100#")));
    sim.act(can.id, |model, cx| model.block_system_bus(cx, Time::from_ms(1)));
    sim.peer_send(peer, frame("101#"));
    sim.peer_send(peer, frame("102#"));
    sim.run_for(FRAME * 2);
    assert_eq!(can.icod(&sim), 0x45);
    assert!(can.fifo(&sim, 0).int_().read().rxovflif(), "the overflow bit is set too");
    assert!(can.flags(&sim).rbovif());
    let mut polls = 0;
    while can.regs(&sim).con().read().canbusy() {
        polls += 1;
        assert!(polls < 100);
    }
    can.regs(&sim).con().clear_bits(Con::ON);
    assert_eq!(can.flags(&sim) & Int::SERRIF, Int::ZERO);
    assert_eq!(can.icod(&sim), 0x40);
}
