//! Transmission and abort (8.0, 8.1, 8.2), message buffers (5.0).

use crate::bench::{Can, FRAME, add, everything, frame, kinds, pair, peer, received};
use can_sim::{DiagnosticKind, PeerId, Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use dspic33_ecan_pac::{
    enums::{FilterTarget, OperationMode, TrConTxen, TxPriority},
    registers as pac,
};
use regbus::Bus;

/// Example 8-1: a standard data frame from buffer 0 with the highest priority. The comment names buffer 2 and a DLC of
/// 1111; the code uses buffer 0 and 8 (`example_8_1_comments`).
#[test]
fn example_8_1_standard_data_frame() {
    let (sim, can, other) = pair();
    can.transmit_buffer(&sim, 0, TxPriority::Highest);
    can.set_words(&sim, 0, &[0x123C, 0x0000, 0x0008, 0xABCD, 0xABCD, 0xABCD, 0xABCD]);
    can.request(&sim, 0);
    assert_eq!(can.regs(&sim).tr_con_of(0).0.read().bits(), 0x008B);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["48F#CDABCDABCDABCDAB"]);
    assert_eq!(can.regs(&sim).tr_con_of(0).0.read().bits(), 0x0083, "TXREQ is cleared");
    assert_eq!(can.take_flags(&sim), pac::Intf::TBIF);
    assert_eq!(sim.diagnostics(), []);
}

/// Example 8-2: an extended data frame from buffer 2. The printed word 0 of 0x123D has SRR 0, which CAN does not allow:
/// it must be 0x123F (`srr_extended`).
#[test]
fn example_8_2_extended_data_frame() {
    for (word0, reported) in [(0x123F, false), (0x123D, true)] {
        let (sim, can, other) = pair();
        can.transmit_buffer(&sim, 2, TxPriority::IntermediateHigh);
        can.set_words(&sim, 2, &[word0, 0x0F00, 0x0C08, 0xABCD, 0xABCD, 0xABCD, 0xABCD]);
        can.request(&sim, 2);
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other), ["123FC003#CDABCDABCDABCDAB"]);
        let what = "SRR is 0 in an extended message; it is sent as 1";
        let expected = DiagnosticKind::MessageInvalid { buffer: 2, what };
        assert_eq!(kinds(&sim), if reported { vec![expected] } else { vec![] });
    }
}

/// Example 8-3: an extended remote frame from buffer 2. It sets TXEN0 and TX0PRI of C1TR23CON, which has TXEN2 and
/// TX2PRI (`example_8_3_names`).
#[test]
fn example_8_3_extended_remote_frame() {
    let (sim, can, other) = pair();
    can.transmit_buffer(&sim, 2, TxPriority::IntermediateHigh);
    can.set_words(&sim, 2, &[0x123F, 0x0F00, 0x0E00]);
    can.request(&sim, 2);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["123FC003#R"]);
    assert_eq!(sim.diagnostics(), []);
}

/// 5.0: further encodings: a standard remote frame by SRR (`standard_remote_frame`), the largest identifier, every DLC.
#[test]
fn section_5_0_message_buffers() {
    for (words, text) in [
        ([0x123E, 0, 0x0000, 0, 0, 0, 0], "48F#R"),
        ([0x123E, 0, 0x0005, 0, 0, 0, 0], "48F#R5"),
        ([0x1FFF, 0x0FFF, 0xFC08, 0x0201, 0x0403, 0x0605, 0x0807], "1FFFFFFF#0102030405060708"),
        ([0x1FFC, 0, 0x0003, 0x0201, 0x0403, 0, 0], "7FF#010203"),
        ([0x0000, 0, 0x0000, 0xFFFF, 0, 0, 0], "000#"),
        // Bits 15 to 13 of word 0 and 15 to 12 of word 1 do not matter.
        ([0xE004, 0xF000, 0x0001, 0x00AA, 0, 0, 0], "001#AA"),
    ] {
        let (sim, can, other) = pair();
        can.set_words(&sim, 0, &words);
        can.request(&sim, 0);
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other), [text]);
        assert_eq!(sim.diagnostics(), []);
    }
}

/// 5.0: what does not fit a frame is reported: RTR in a standard message, reserved bits, a DLC above 8.
#[test]
fn section_5_0_messages_that_do_not_fit() {
    for (word2, text, what) in [
        (0x0201, "48F#AA", "RTR of a standard message is ignored; SRR requests a remote frame"),
        (0x0101, "48F#AA", "RB1 or RB0 is 1; they are sent as 0"),
        (0x0011, "48F#AA", "RB1 or RB0 is 1; they are sent as 0"),
        (0x000F, "48F#AA00000000000000_F", "the DLC is above 8; eight bytes are sent"),
    ] {
        let (sim, can, other) = pair();
        can.set_words(&sim, 0, &[0x123C, 0, word2, 0x00AA, 0, 0, 0]);
        can.request(&sim, 0);
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other), [text]);
        assert_eq!(kinds(&sim), [DiagnosticKind::MessageInvalid { buffer: 0, what }]);
    }
}

/// 8.1: user-defined priority first, then the natural order: buffer 7 before buffer 0. The identifier plays no part.
#[test]
fn section_8_1_priority() {
    let priorities = [
        TxPriority::Highest,
        TxPriority::Lowest,
        TxPriority::Highest,
        TxPriority::IntermediateLow,
        TxPriority::IntermediateHigh,
        TxPriority::Lowest,
        TxPriority::IntermediateLow,
        TxPriority::IntermediateHigh,
    ];
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim);
    let other = peer(&sim);
    for (buffer, priority) in priorities.into_iter().enumerate() {
        can.transmit_buffer(&sim, buffer, priority);
        can.send(&sim, buffer, &frame(&format!("{:03X}#", 0x100 * (7 - buffer) + buffer)));
    }
    can.enter(&sim, OperationMode::Normal);
    sim.run_for(FRAME * 8);
    let order: Vec<u32> = sim.peer_received(other).iter().map(|(_, frame)| frame.raw_id() & 0xF).collect();
    assert_eq!(order, [2, 0, 7, 4, 6, 3, 5, 1]);
}

/// 8.1: the buffers are looked at before each start of frame: a request that comes while another one waits overtakes it.
#[test]
fn section_8_1_a_later_request_overtakes() {
    let (sim, can, other) = pair();
    can.transmit_buffer(&sim, 5, TxPriority::IntermediateLow);
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#"));
    assert_eq!(sim.inspect(can.id, |model| model.transmitting()), (None, Some(0)));
    can.send(&sim, 5, &frame("500#"));
    assert_eq!(sim.inspect(can.id, |model| model.transmitting()), (None, Some(5)));
    sim.run_for(FRAME * 3);
    assert_eq!(received(&sim, other), ["500#", "100#"]);
}

/// Makes the module lose arbitration with its message in buffer 0: requested while the bus is busy, it starts together
/// with a message of higher priority.
fn lose_arbitration(sim: &Sim, can: Can, other: PeerId) {
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.peer_send(other, frame("020#0011223344556677"));
    sim.run_for(Time::from_us(40));
    can.send(sim, 0, &frame("100#11"));
    sim.run_until(FRAME * 2, |sim| can.outcome(sim, 0).2).unwrap();
}

/// Table 8-1: TXLARB and TXREQ.
#[test]
fn table_8_1_lost_arbitration() {
    let (sim, can, other) = pair();
    can.write(&sim, 0, &frame("100#11"));
    can.request(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, false), "pending");
    sim.run_for(FRAME);
    assert_eq!(can.outcome(&sim, 0), (false, false, false, false), "sent without loss of arbitration");
    lose_arbitration(&sim, can, other);
    // lost_arbitration_unfinished.
    assert_eq!(can.outcome(&sim, 0), (true, false, true, false), "not sent again yet");
    sim.run_for(FRAME * 2);
    assert_eq!(can.outcome(&sim, 0), (false, false, true, false), "sent after loss of arbitration");
    assert_eq!(received(&sim, other), ["100#11", "100#11"]);
    can.request(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, false), "TXLARB is cleared when TXREQ is set again");
}

/// 8.1: a message that meets an error stays pending with TXERR set.
#[test]
fn section_8_1_bus_error() {
    let (sim, can, other) = pair();
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next_of(node) };
    sim.with_wire(|wire| wire.inject(fault));
    can.send(&sim, 0, &frame("100#11"));
    sim.run_until(FRAME, |sim| can.outcome(sim, 0).3).unwrap();
    assert_eq!(can.outcome(&sim, 0), (true, false, false, true));
    sim.run_for(FRAME);
    // txerr_clearing: cleared when TXREQ is set again.
    assert_eq!(can.outcome(&sim, 0), (false, false, false, true));
    assert_eq!(received(&sim, other), ["100#11"]);
    can.request(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, false));
    // The records of the other buffer of the register are its own.
    can.transmit_buffer(&sim, 1, TxPriority::Lowest);
    sim.run_for(FRAME);
    sim.with_wire(|wire| wire.inject(fault));
    can.send(&sim, 1, &frame("101#11"));
    sim.run_for(FRAME * 2);
    assert_eq!(can.outcome(&sim, 1), (false, false, false, true));
    can.request(&sim, 0);
    assert!(can.outcome(&sim, 1).3, "a request of buffer 0 clears nothing of buffer 1");
}

/// 11.1.2: without another node the message is repeated for want of an acknowledge.
#[test]
fn section_11_1_2_no_acknowledge() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, everything(FilterTarget::Buffer(8)));
    can.transmit_buffer(&sim, 0, TxPriority::Lowest);
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME * 40);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, true));
    let flags = can.intf(&sim);
    assert!(flags.txbp() && flags.ewarn() && flags.errif() && !flags.txbo());
    assert_eq!(
        can.regs(&sim).ec().read().terrcnt(),
        128,
        "an error passive transmitter does not count missing acknowledges"
    );
    let other = peer(&sim);
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), ["100#"]);
    assert_eq!(can.regs(&sim).ec().read().terrcnt(), 127);
}

/// 8.2: a message that is not on the bus is aborted at once.
#[test]
fn section_8_2_abort_before_the_start() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#"));
    can.abort(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (false, true, false, false));
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    assert!(!can.intf(&sim).tbif(), "abort_outcome: no interrupt");
    can.request(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, false), "TXABT is cleared when TXREQ is set again");
}

/// 8.2: a frame on the bus that succeeds is not aborted.
#[test]
fn section_8_2_abort_on_the_bus() {
    let (sim, can, other) = pair();
    can.send(&sim, 0, &frame("100#0011223344556677"));
    sim.run_for(Time::from_us(40));
    can.abort(&sim, 0);
    assert_eq!(can.outcome(&sim, 0), (true, false, false, false), "until it is known what becomes of the frame");
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["100#0011223344556677"]);
    assert_eq!(can.outcome(&sim, 0), (false, false, false, false));
    assert!(can.intf(&sim).tbif());
}

/// 8.2: a frame on the bus that is interrupted by an error or by loss of arbitration is aborted.
#[test]
fn section_8_2_abort_of_an_interrupted_frame() {
    let (sim, can, other) = pair();
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 40));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next_of(node) };
    sim.with_wire(|wire| wire.inject(fault));
    can.send(&sim, 0, &frame("100#0011223344556677"));
    sim.run_for(Time::from_us(40));
    can.abort(&sim, 0);
    sim.run_for(FRAME * 2);
    assert_eq!(can.outcome(&sim, 0), (false, true, false, true));
    assert_eq!(received(&sim, other), Vec::<String>::new());
    assert!(!can.intf(&sim).tbif());

    let (sim, can, other) = pair();
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.peer_send(other, frame("0F0#0011223344556677"));
    sim.run_for(Time::from_us(40));
    can.send(&sim, 0, &frame("100#11"));
    let started = |sim: &Sim| sim.inspect(can.id, |model| model.transmitting().0 == Some(0));
    sim.run_until(FRAME, started).unwrap();
    can.abort(&sim, 0);
    sim.run_for(FRAME * 2);
    assert_eq!(can.outcome(&sim, 0), (false, true, true, false));
    assert_eq!(received(&sim, other), Vec::<String>::new());
}

/// 8.2, Register 4-23: ABAT aborts every pending message, the one on the bus only if it fails, and falls when none is
/// left (`abat_completion`).
#[test]
fn section_8_2_abort_all() {
    for fails in [false, true] {
        let (sim, can, other) = pair();
        let node = sim.node(can.id);
        if fails {
            let position = Position::new(Field::Data, 40);
            let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next_of(node) };
            sim.with_wire(|wire| wire.inject(fault));
        }
        can.transmit_buffer(&sim, 3, TxPriority::Lowest).transmit_buffer(&sim, 6, TxPriority::Lowest);
        can.send(&sim, 0, &frame("100#0011223344556677"));
        sim.run_for(Time::from_us(40));
        can.send(&sim, 3, &frame("103#"));
        can.send(&sim, 6, &frame("106#"));
        let ctrl1 = can.regs(&sim).ctrl1();
        ctrl1.modify(|value| value.with_abat(true));
        assert!(ctrl1.read().abat(), "a frame is on the bus");
        assert_eq!(can.outcome(&sim, 3), (false, true, false, false));
        assert_eq!(can.outcome(&sim, 6), (false, true, false, false));
        assert!(can.outcome(&sim, 0).0);
        // abat_write_zero: writing 0 does nothing.
        sim.registers(can.id).write(ctrl1.offset(), 0_u16);
        assert!(ctrl1.read().abat());
        // A request made meanwhile is aborted too.
        can.request(&sim, 3);
        assert_eq!(can.outcome(&sim, 3), (false, true, false, false));
        sim.run_for(FRAME);
        assert!(!ctrl1.read().abat());
        assert_eq!(can.outcome(&sim, 0), (false, fails, false, fails));
        assert_eq!(received(&sim, other).len(), usize::from(!fails));
        assert_eq!(sim.diagnostics(), []);
    }
    let (sim, can, _) = pair();
    can.regs(&sim).ctrl1().modify(|value| value.with_abat(true));
    assert!(!can.regs(&sim).ctrl1().read().abat(), "nothing is pending");
}

/// 9.2.2, note: TXREQ of a receive buffer (`txreq_on_receive_buffer`).
#[test]
fn section_9_2_2_txreq_of_a_receive_buffer() {
    let (sim, can, other) = pair();
    can.send(&sim, 4, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    assert!(can.outcome(&sim, 4).0);
    let because = "TXEN is 0: it is a receive buffer";
    assert_eq!(kinds(&sim), [DiagnosticKind::RequestIgnored { register: "TRCON", buffer: 4, because }]);
}

/// `txen_change_while_pending`: reported, and the message is aborted.
#[test]
fn txen_cleared_while_txreq_is_set() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#"));
    let (control, lane) = can.regs(&sim).tr_con_of(0);
    control.write(control.read().with_txen(lane, TrConTxen::Receive));
    assert_eq!(can.outcome(&sim, 0), (false, true, false, false));
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), Vec::<String>::new());
    assert!(matches!(kinds(&sim)[..], [DiagnosticKind::RequestIgnored { buffer: 0, .. }]));
}

/// `transmit_buffer_beyond_buffers`: four buffers, and buffer 5 is sent.
#[test]
fn section_10_0_transmit_buffer_beyond_dmabs() {
    let (sim, can, other) = pair();
    can.write_fctrl(&sim, 0);
    can.transmit_buffer(&sim, 5, TxPriority::Lowest);
    can.send(&sim, 5, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["100#"]);
    let found = kinds(&sim);
    assert_eq!(found[0].to_string(), "buffer 5 is to be sent, but DMABS gives 4 buffers");
}

/// 8.1: the message is written before TXREQ is set; a change afterwards is reported.
#[test]
fn section_8_1_a_pending_buffer_is_modified() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("010#0011223344556677"));
    sim.run_for(Time::from_us(20));
    can.send(&sim, 0, &frame("100#11"));
    can.set_words(&sim, 0, &[0x0804]);
    assert_eq!(kinds(&sim), [DiagnosticKind::PendingBufferModified { buffer: 0, address: 0 }]);
    can.set_words(&sim, 1, &[0x0804]);
    assert_eq!(kinds(&sim), [], "buffer 1 is not pending");
}
