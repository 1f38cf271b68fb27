//! Chapter 34.7: messages, requests, priorities, aborts, remote requests.

use can_sim::{DiagnosticKind, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use pic32_can_pac::{
    enums::{FifoConTxpri, OperationMode},
    registers::{Con, FifoCon, FltCon},
};
use regbus::Bus;

use crate::bench::*;

/// Example 34-7: SID 0x100, two bytes.
#[test]
fn example_34_7() {
    let (sim, can, peer) = bench(&[Use::Tx(1)]);
    can.queue(&sim, 0, &frame("100#AABB"));
    let words: Vec<u32> = (0..4).map(|n| can.word(&sim, 0x100 + n * 4)).collect();
    assert_eq!(words, [0x0000_0100, 0x0000_0002, 0x0000_BBAA, 0]);
    can.request(&sim, 0);
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), ["100#AABB"]);
}

/// Example 34-8, on FIFO0 of four messages throughout (example_34_8_fifo), with EID and SRR (example_34_8_eid).
#[test]
fn example_34_8() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    let messages: [[u32; 4]; 4] = [
        [0x100, 0x0000_0004, 0x12BC_1245, 0],
        [0x102, 0x0000_0008, 0x12BC_1245, 0x12BC_1245],
        [0x100, 0x3300_0004, 0x12BC_1245, 0],
        [0x102, 0x3300_0008, 0x12BC_1245, 0x12BC_1245],
    ];
    for words in messages {
        let address = can.fifo(&sim, 0).ua().read().bits() as usize;
        for (n, word) in words.into_iter().enumerate() {
            can.memory(&sim).write(address + n * 4, word);
        }
        can.fifo(&sim, 0).con().set_bits(FifoCon::UINC);
        can.fifo(&sim, 0).con().set_bits(FifoCon::TXREQ);
    }
    sim.run_for(FRAME * 4);
    let expected = ["100#4512BC12", "102#4512BC124512BC12", "0400C000#4512BC12", "0408C000#4512BC124512BC12"];
    assert_eq!(heard(&sim, peer), expected);
    assert_eq!(sim.diagnostics(), []);
}

/// Example 34-8 as printed: FIFO0 is set up, FIFO1 used, which is a receive FIFO: nothing is sent.
#[test]
fn example_34_8_as_printed() {
    let (sim, can, peer) = bench(&[Use::Tx(3)]);
    can.load(&sim, 1, &frame("100#4512BC12"));
    can.fifo(&sim, 1).con().set_bits(FifoCon::UINC);
    can.fifo(&sim, 1).con().set_bits(FifoCon::TXREQ);
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    let found = kinds(&sim);
    assert!(found.contains(&DiagnosticKind::FifoLimit { fifo: 1, full: false }), "{found:?}");
    let ignored = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::WriteIgnored { field: "TXREQ", .. });
    assert!(found.iter().any(ignored), "{found:?}");
}

/// Figure 34-12: SRR as printed in Example 34-8, reserved bits, shaded bits.
#[test]
fn malformed_messages() {
    for (word0, word1, what) in [
        (0x100, 0x1300_0004, "SRR is 0"),
        (0x100, 0x0000_0014, "RB0 or RB1"),
        (0x100, 0x0000_0104, "RB0 or RB1"),
        (0x1_0100, 0x0000_0004, "bits without a field"),
        (0x100, 0x4000_0004, "bits without a field"),
    ] {
        let (sim, can, _) = bench(&[Use::Tx(1)]);
        for (n, word) in [word0, word1, 0_u32, 0].into_iter().enumerate() {
            can.memory(&sim).write(0x100 + n * 4, word);
        }
        can.fifo(&sim, 0).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
        let found = kinds(&sim);
        assert!(
            matches!(&found[..], [DiagnosticKind::MessageInvalid { buffer: 0, what: said }] if said.starts_with(what)),
            "{found:?}"
        );
    }
}

/// Figure 34-12: DLC 8 to 15 are eight bytes.
#[test]
fn data_length_codes() {
    let (sim, can, peer) = bench(&[Use::Tx(16)]);
    for dlc in 0..16_u32 {
        let address = can.fifo(&sim, 0).ua().read().bits() as usize;
        for (n, word) in [0x100, dlc, 0x4433_2211, 0x8877_6655].into_iter().enumerate() {
            can.memory(&sim).write(address + n * 4, word);
        }
        can.fifo(&sim, 0).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
    }
    sim.run_for(FRAME * 17);
    let lengths: Vec<usize> = sim.peer_received(peer).iter().map(|(_, frame)| frame.len()).collect();
    assert_eq!(lengths, [0, 1, 2, 3, 4, 5, 6, 7, 8, 8, 8, 8, 8, 8, 8, 8]);
}

/// 34.7.2: TXREQ sends everything in the FIFO, also what is added meanwhile, and clears at the end.
#[test]
fn a_request_sends_everything() {
    let (sim, can, peer) = bench(&[Use::Tx(8)]);
    for text in ["103#", "102#", "101#"] {
        can.queue(&sim, 0, &frame(text));
    }
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new(), "without TXREQ nothing is sent");
    can.request(&sim, 0);
    sim.run_for(Time::from_us(60));
    assert!(can.fifo(&sim, 0).con().read().txreq());
    can.queue(&sim, 0, &frame("100#"));
    sim.run_for(FRAME * 4);
    assert_eq!(heard(&sim, peer), ["103#", "102#", "101#", "100#"], "in the order of the FIFO");
    assert!(!can.fifo(&sim, 0).con().read().txreq());
}

/// txreq_on_empty_fifo.
#[test]
fn request_of_an_empty_fifo() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    can.request(&sim, 0);
    assert!(!can.fifo(&sim, 0).con().read().txreq());
    can.queue(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
}

/// 34.7.3: the highest TXPRI first, and of equal ones the highest FIFO number.
#[test]
fn priorities() {
    let (sim, can, peer) = bench(&[Use::Tx(2); 5]);
    for (fifo, priority) in [
        (0, FifoConTxpri::HighIntermediate),
        (1, FifoConTxpri::Lowest),
        (2, FifoConTxpri::Highest),
        (3, FifoConTxpri::Lowest),
        (4, FifoConTxpri::LowIntermediate),
    ] {
        can.priority(&sim, fifo, priority);
        can.queue(&sim, fifo, &frame(&format!("10{fifo}#0A")));
        can.queue(&sim, fifo, &frame(&format!("10{fifo}#0B")));
    }
    // All become ready within one message.
    sim.peer_send(peer, frame("7FF#1122334455667788"));
    sim.run_for(Time::from_us(20));
    for fifo in 0..5 {
        can.request(&sim, fifo);
    }
    sim.run_for(FRAME * 12);
    let expected: Vec<String> =
        [2, 0, 4, 3, 1].iter().flat_map(|n| [format!("10{n}#0A"), format!("10{n}#0B")]).collect();
    assert_eq!(heard(&sim, peer), expected);
}

/// 34.7.3: the natural order: FIFO31 is the highest, FIFO0 the lowest.
#[test]
fn natural_order() {
    let (sim, can, peer) = bench(&[Use::Tx(1); 32]);
    sim.peer_send(peer, frame("7FF#1122334455667788"));
    sim.run_for(Time::from_us(15));
    for fifo in 0..32 {
        can.load(&sim, fifo, &frame(&format!("1{fifo:02X}#")));
    }
    for fifo in 0..32 {
        can.fifo(&sim, fifo).con().set_bits(FifoCon::UINC | FifoCon::TXREQ);
    }
    sim.run_for(FRAME * 34);
    let expected: Vec<String> = (0..32).rev().map(|fifo| format!("1{fifo:02X}#")).collect();
    assert_eq!(heard(&sim, peer), expected);
}

/// 34.7.3: a change of priority takes effect after the message being sent.
#[test]
fn changing_a_priority() {
    let (sim, can, peer) = bench(&[Use::Tx(4), Use::Tx(4)]);
    for n in 0..3 {
        can.queue(&sim, 0, &frame(&format!("10{n}#")));
        can.queue(&sim, 1, &frame(&format!("20{n}#")));
    }
    can.request(&sim, 1);
    can.request(&sim, 0);
    sim.run_for(Time::from_us(20));
    can.priority(&sim, 0, FifoConTxpri::Highest);
    sim.run_for(FRAME * 7);
    assert_eq!(heard(&sim, peer), ["200#", "100#", "101#", "102#", "201#", "202#"]);
}

/// Register 34-20: TXLARB, and the message is sent again (retransmission).
#[test]
fn lost_arbitration() {
    let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
    sim.peer_send(peer, frame("7FF#"));
    sim.run_for(Time::from_us(20));
    sim.peer_send(peer, frame("0FF#"));
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(Time::from_us(90));
    let con = can.fifo(&sim, 0).con().read();
    assert!(con.txlarb() && con.txreq() && !con.txerr());
    assert!(!can.fifo(&sim, 0).con().read().txlarb(), "cleared by the read");
    let _ = sim.take_diagnostics();
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), ["100#"]);
}

/// Register 34-20: TXERR, without acknowledgement and with an error in the frame; the message is repeated.
#[test]
fn transmission_errors() {
    let (sim, can, peer) = bench(&[Use::Tx(2)]);
    let node = sim.node(can.id);
    let position = Position::new(Field::Data, 3);
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    can.send(&sim, 0, &frame("100#55"));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#55"]);
    let con = can.fifo(&sim, 0).con().read();
    assert!(con.txerr() && !con.txreq() && !con.txabat());
    assert!(!can.fifo(&sim, 0).con().read().txerr());
    assert_eq!(can.regs(&sim).trec().read().tec(), 7, "8 for the error, 1 less for the success");
}

/// 34.7.4: a message that has not started is aborted at once: TXABAT, pointers as they were.
#[test]
fn abort_before_the_start() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    sim.peer_send(peer, frame("7FF#1122334455667788"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#"));
    can.send(&sim, 0, &frame("101#"));
    can.fifo(&sim, 0).con().clear_bits(FifoCon::TXREQ);
    let con = can.fifo(&sim, 0).con().read();
    assert!(con.txabat() && !con.txreq());
    sim.run_for(FRAME * 3);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    assert_eq!((can.fifo(&sim, 0).ci().read().fifoci(), can.fifo(&sim, 0).ua().read().bits()), (0, 0x120));
    can.request(&sim, 0);
    sim.run_for(FRAME * 3);
    assert_eq!(heard(&sim, peer), ["100#", "101#"], "the messages are still there");
    assert!(!can.fifo(&sim, 0).con().read().txabat());
}

/// 34.7.4: a message on the bus is finished: TXREQ stays 1 until then, TXABAT is 0, the others stay (partial_abort).
#[test]
fn abort_of_a_message_on_the_bus() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    can.send(&sim, 0, &frame("100#1122334455667788"));
    can.send(&sim, 0, &frame("101#"));
    sim.run_for(Time::from_us(40));
    can.fifo(&sim, 0).con().clear_bits(FifoCon::TXREQ);
    assert!(can.fifo(&sim, 0).con().read().txreq());
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#1122334455667788"]);
    let con = can.fifo(&sim, 0).con().read();
    assert!(!con.txreq() && !con.txabat());
    assert_eq!(can.fifo(&sim, 0).ci().read().fifoci(), 1);
    assert!(!can.fifo(&sim, 0).int_().read().txemptyif());
}

/// 34.7.4: an error in the message that is being aborted ends it: TXABAT.
#[test]
fn abort_meets_an_error() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    let node = sim.node(can.id);
    let position = Position::new(Field::Data, 40);
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
    });
    can.send(&sim, 0, &frame("100#1122334455667788"));
    sim.run_for(Time::from_us(40));
    can.fifo(&sim, 0).con().clear_bits(FifoCon::TXREQ);
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    let con = can.fifo(&sim, 0).con().read();
    assert!(con.txabat() && con.txerr() && !con.txreq());
    assert_eq!(can.fifo(&sim, 0).ci().read().fifoci(), 0);
}

/// 34.7.4: after an abort FRESET erases what is left.
#[test]
fn freset_after_an_abort() {
    let (sim, can, peer) = bench(&[Use::Tx(4)]);
    sim.peer_send(peer, frame("7FF#1122334455667788"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#"));
    can.fifo(&sim, 0).con().clear_bits(FifoCon::TXREQ);
    can.fifo(&sim, 0).con().set_bits(FifoCon::FRESET);
    while can.fifo(&sim, 0).con().read().freset() {}
    can.send(&sim, 0, &frame("102#"));
    sim.run_for(FRAME * 3);
    assert_eq!(heard(&sim, peer), ["102#"]);
    assert_eq!(sim.diagnostics(), []);
}

/// Register 34-1: ABAT aborts all FIFOs, and is cleared when that is done.
#[test]
fn abort_all() {
    let (sim, can, peer) = bench(&[Use::Tx(2); 3]);
    can.send(&sim, 2, &frame("102#1122334455667788"));
    can.send(&sim, 0, &frame("100#"));
    can.send(&sim, 1, &frame("101#"));
    sim.run_for(Time::from_us(40));
    can.regs(&sim).con().set_bits(Con::ABAT);
    let state = |fifo| {
        let con = can.fifo(&sim, fifo).con().read();
        (con.txreq(), con.txabat())
    };
    assert_eq!([state(0), state(1), state(2)], [(false, true), (false, true), (true, false)]);
    assert!(can.regs(&sim).con().read().abat(), "one is on the bus");
    sim.run_for(FRAME * 2);
    assert!(!can.regs(&sim).con().read().abat());
    assert_eq!(state(2), (false, false));
    assert_eq!(heard(&sim, peer), ["102#1122334455667788"]);
    can.regs(&sim).con().set_bits(Con::ABAT);
    assert!(!can.regs(&sim).con().read().abat(), "with nothing pending it is done at once");
}

/// Example 34-9, with TXREQ (example_34_9_request): a remote request with SID 0x100.
#[test]
fn example_34_9() {
    let (sim, can, peer) = bench(&[Use::Rx(1), Use::Tx(1)]);
    can.send(&sim, 1, &frame("100#R"));
    assert_eq!((can.word(&sim, 0x110), can.word(&sim, 0x114)), (0x100, 0x200));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), ["100#R"]);
}

/// Example 34-10 with four buffers as FSIZE = 3 (fsize_of_four_buffers) and the mask 0x7FF (example_34_10_mask).
#[test]
fn example_34_10() {
    let sim = can_sim::Sim::new();
    let can = add(&sim, "can1");
    can.set_up(&sim, 0x100, &[]);
    let fifo = can.fifo(&sim, 1);
    fifo.con().set_bits(FifoCon::from_bits(0x80));
    fifo.con().set_bits(FifoCon::from_bits(0x04));
    fifo.con().set_bits(FifoCon::RESET.with_fsize(3));
    let regs = can.regs(&sim);
    regs.flt_con(0).write(FltCon::from_bits(0x01));
    regs.rxf(0).write(standard(0x100));
    regs.rxm(0).write(EXACT.with_eid(0));
    regs.flt_con(0).set_bits(FltCon::from_bits(0x80));
    assert_eq!(regs.flt_con(0).read().bits(), 0x81);
    assert_eq!(regs.rxf(0).read().bits(), 0x2000_0000);
    assert_eq!(fifo.con().read().bits(), 0x0003_0084);
    can.start(&sim);
    let peer = add_peer(&sim);
    can.queue(&sim, 1, &frame("100#4512BC12"));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new(), "it waits for the request");
    sim.peer_send(peer, frame("300#R"));
    sim.run_for(FRAME);
    assert!(!can.fifo(&sim, 1).con().read().txreq(), "the mask of 0x1FF would have answered it");
    sim.peer_send(peer, frame("100#R4"));
    sim.run_for(FRAME * 2);
    assert_eq!(heard(&sim, peer), ["100#4512BC12"]);
    assert_eq!(can.filhit(&sim), 0);
    sim.peer_send(peer, frame("100#R"));
    sim.run_for(FRAME);
    assert!(fifo.int_().read().rxovflif(), "empty: an overflow of the transmit FIFO (remote_request_overflow)");
    assert_eq!(sim.diagnostics(), []);
}

/// Register 34-20: without RTREN the request is left alone; a data frame for a transmit FIFO is dropped.
#[test]
fn frames_that_ask_for_nothing() {
    let (sim, can, peer) = bench(&[Use::Tx(2), Use::Rx(2)]);
    can.mode(&sim, OperationMode::Configuration);
    can.regs(&sim).flt_con(0).clear_bits(FltCon::flten_bit(0));
    can.accept_all(&sim, 0);
    can.start(&sim);
    can.queue(&sim, 0, &frame("100#11"));
    sim.peer_send(peer, frame("100#R"));
    sim.run_for(FRAME);
    can.fifo(&sim, 0).con().set_bits(FifoCon::RTREN);
    sim.peer_send(peer, frame("100#22"));
    sim.run_for(FRAME);
    assert_eq!(heard(&sim, peer), Vec::<String>::new());
    assert!(!can.fifo(&sim, 0).int_().read().rxovflif());
}
