//! Sending (8.0).

use can_hal::{
    ErrorState, Events, InterruptSet, Outcome, Polls, Receive, SendError, Transmit,
    dspic33_ecan::{Filter, FilterTarget, Interrupts, Mask, MaskSource, TxPriority, Use},
};
use can_sim::{Sim, Time};
use can_wire::{BitFault, Fault, Field, Frames, Position};

use crate::bench::{Bench, CONFIG, FRAME, MODE, PLAN, frame, sending, standard};

const DONE: Polls = Polls(10_000);

/// 8.1: the tasks: configure a buffer, write the message, request. Example 8-1: a standard frame from buffer 0 with the
/// highest priority. Its comment names buffer 2 and a DLC of 1111; the code has 0 and 8 (`example_8_1_comments`).
#[test]
fn example_8_1_standard_data_frame() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &sending(&[(0, Use::Dedicated(TxPriority::Highest))]));
    assert_eq!(can.registers().tr_con(0).read().bits(), 0x0083);
    let ticket = can.send_buffer(0, &frame("48F#CDABCDABCDABCDAB")).unwrap();
    assert_eq!(bench.words(0), [0x123C, 0x0000, 0x0008, 0xABCD, 0xABCD, 0xABCD, 0xABCD, 0]);
    assert_eq!(can.registers().tr_con(0).read().bits(), 0x008B);
    assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::Sent));
    assert_eq!(bench.seen(other), ["48F#CDABCDABCDABCDAB"]);
    bench.finish();
}

/// Example 8-2: an extended frame from buffer 2. Word 0 is printed as 0x123D, with SRR 0; SRR must be 1: 0x123F
/// (`srr_extended`).
#[test]
fn example_8_2_extended_data_frame() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &sending(&[(2, Use::Dedicated(TxPriority::IntermediateHigh))]));
    let ticket = can.send_buffer(2, &frame("123FC003#CDABCDABCDABCDAB")).unwrap();
    assert_eq!(bench.words(2), [0x123F, 0x0F00, 0x0C08, 0xABCD, 0xABCD, 0xABCD, 0xABCD, 0]);
    assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::Sent));
    assert_eq!(bench.seen(other), ["123FC003#CDABCDABCDABCDAB"]);
    bench.finish();
}

/// Example 8-3: an extended remote frame from buffer 2; it sets TXEN0 of the register of buffers 2 and 3
/// (`example_8_3_names`).
#[test]
fn example_8_3_extended_remote_frame() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &sending(&[(2, Use::Dedicated(TxPriority::IntermediateHigh))]));
    let ticket = can.send_buffer(2, &frame("123FC003#R")).unwrap();
    assert_eq!(bench.words(2)[..3], [0x123F, 0x0F00, 0x0E00]);
    assert_eq!(can.registers().tr_con(1).read().bits(), 0x008A);
    assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::Sent));
    assert_eq!(bench.seen(other), ["123FC003#R"]);
    // `standard_remote_frame`.
    can.send_buffer(2, &frame("48F#R5")).unwrap();
    assert_eq!(bench.words(2)[..3], [0x123E, 0, 5]);
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other)[1], "48F#R5");
    bench.finish();
}

/// 2.1: a message has at most eight bytes; a data length code above 8 is sent as it is (`dlc_above_8`), which the simulation
/// reports.
#[test]
fn section_2_1_data_length_codes_above_8() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(1));
    for code in 9..=15 {
        let (id, dlc) = (can_hal::StandardId::ZERO, can_hal::Dlc::new(code).unwrap());
        let long = can_hal::Frame::data_with_dlc(id, dlc, &[code; 8]).unwrap();
        let ticket = can.send(&long).unwrap();
        assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::Sent));
        assert_eq!(bench.sim.peer_received(other).last().map(|(_, frame)| *frame), Some(long));
    }
    assert_eq!(bench.sim.take_diagnostics().len(), 7);
}

/// 8.1: dedicated buffers go by priority, then by number: buffer 7 before buffer 0.
#[test]
fn section_8_1_priorities() {
    let bench = Bench::new();
    let other = bench.peer();
    let uses = [(0, TxPriority::Highest), (2, TxPriority::Lowest), (4, TxPriority::Lowest), (6, TxPriority::Highest)];
    let uses = uses.map(|(buffer, priority)| (buffer, Use::Dedicated(priority)));
    let mut can = bench.running(&PLAN, &sending(&uses));
    bench.sim.peer_send(other, frame("000#0000000000000000"));
    bench.sim.run_for(Time::from_us(10));
    for buffer in [2, 4, 0, 6] {
        can.send_buffer(buffer, &frame(&format!("10{buffer}#"))).unwrap();
    }
    bench.sim.run_for(FRAME * 5);
    assert_eq!(bench.seen(other), ["106#", "100#", "104#", "102#"]);
    bench.finish();
}

/// 8.1: the queue keeps the order of the calls although the module knows only ranks, however long it goes on.
#[test]
fn the_queue_keeps_the_order() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(4));
    let (mut sent, mut expected) = (0_u32, Vec::new());
    while sent < 300 {
        let text = format!("{:03X}#{:02X}", sent.wrapping_mul(0x9E37) & 0x7FF, sent & 0xFF);
        match can.send(&frame(&text)) {
            Ok(_) => {
                expected.push(text);
                sent += 1;
            }
            Err(SendError::Full) => bench.sim.run_for(Time::from_us(u64::from(sent % 7) * 30 + 10)),
            Err(error) => panic!("{error}"),
        }
    }
    bench.sim.run_for(FRAME * 5);
    assert_eq!(bench.seen(other), expected);
    bench.finish();
}

/// The requests of a pair are never pending together, so that no write for one meets a change of the other.
#[test]
fn a_pair_of_buffers_has_one_request() {
    let bench = Bench::new();
    let other = bench.peer();
    let dedicated = Use::Dedicated(TxPriority::Lowest);
    let mut can = bench.running(&PLAN, &sending(&[(2, dedicated), (3, dedicated)]));
    bench.sim.peer_send(other, frame("000#0000000000000000"));
    bench.sim.run_for(Time::from_us(10));
    let first = can.send_buffer(2, &frame("102#")).unwrap();
    assert_eq!(can.send_buffer(2, &frame("102#")), Err(SendError::Pending { buffer: 2 }));
    assert_eq!(can.send_buffer(3, &frame("103#")), Err(SendError::Pending { buffer: 2 }));
    assert_eq!(can.wait_for(first, DONE), Ok(Outcome::Sent));
    assert!(can.send_buffer(3, &frame("103#")).is_ok());
    assert_eq!(can.send_buffer(4, &frame("104#")), Err(SendError::NoSuchBuffer { buffer: 4, count: 8 }));
    assert_eq!(can.send_buffer(9, &frame("104#")), Err(SendError::NoSuchBuffer { buffer: 9, count: 8 }));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other), ["102#", "103#"]);
    bench.finish();
}

/// Whatever the module finishes between two accesses of the driver, nothing is sent twice or lost.
#[test]
fn a_completion_between_any_two_accesses() {
    let dedicated = Use::Dedicated(TxPriority::Lowest);
    for skip in 0..40 {
        let bench = Bench::new();
        let other = bench.peer();
        let mut can =
            bench.running(&PLAN, &sending(&[(0, dedicated), (1, dedicated), (2, dedicated), (4, Use::Queue)]));
        bench.sim.peer_send(other, frame("000#0000000000000000"));
        bench.sim.run_for(Time::from_us(10));
        let first = can.send_buffer(0, &frame("100#")).unwrap();
        bench.sim.interrupt_host(skip, |sim: &Sim| sim.run_for(FRAME * 3));
        let second = can.send_buffer(1, &frame("101#"));
        can.cancel(first);
        let third = can.send_buffer(2, &frame("102#")).unwrap();
        let fourth = can.send(&frame("104#")).unwrap();
        bench.sim.run_for(FRAME * 5);
        let mut expected: Vec<&str> = match can.outcome(first) {
            Outcome::Sent | Outcome::SentAnyway => vec!["100#"],
            Outcome::Cancelled => vec![],
            outcome => panic!("{outcome:?}"),
        };
        if let Ok(second) = second {
            assert_eq!(can.outcome(second), Outcome::Sent);
            expected.push("101#");
        }
        assert_eq!([can.outcome(third), can.outcome(fourth)], [Outcome::Sent; 2]);
        expected.extend(["102#", "104#"]);
        let mut seen = bench.seen(other);
        seen.sort_unstable();
        assert_eq!(seen, expected, "before access {skip}");
        bench.finish();
    }
}

/// 8.2: to abort one message its request is cleared; it is aborted unless it is on the bus and succeeds.
#[test]
fn section_8_2_abort_one() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &sending(&[(0, Use::Dedicated(TxPriority::Lowest))]));
    bench.sim.peer_send(other, frame("000#0000000000000000"));
    bench.sim.run_for(Time::from_us(10));
    let ticket = can.send_buffer(0, &frame("100#")).unwrap();
    can.cancel(ticket);
    assert_eq!(can.outcome(ticket), Outcome::Cancelled);
    bench.sim.run_for(FRAME * 2);
    assert_eq!(bench.seen(other), Vec::<String>::new());
    let ticket = can.send_buffer(0, &frame("101#0000000000000000")).unwrap();
    bench.sim.run_for(Time::from_us(30));
    can.cancel(ticket);
    assert_eq!(can.outcome(ticket), Outcome::Pending);
    assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::SentAnyway));
    // On the bus, and interrupted by an error.
    let (node, position) = (bench.sim.node(bench.id), Position::new(Field::Data, 60));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next_of(node) };
    bench.sim.with_wire(|wire| wire.inject(fault));
    let ticket = can.send_buffer(0, &frame("102#0000000000000000")).unwrap();
    bench.sim.run_for(Time::from_us(30));
    can.cancel(ticket);
    assert_eq!(can.wait_for(ticket, DONE), Ok(Outcome::Cancelled));
    assert_eq!(can.attempts(ticket), (false, true));
    assert_eq!(bench.seen(other), ["101#0000000000000000"]);
    bench.finish();
}

/// 8.2, Register 4-23: all are aborted but the one on the bus; the module says when it is done.
#[test]
fn section_8_2_abort_all() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(3));
    let tickets = ["100#0000000000000000", "101#", "102#"].map(|text| can.send(&frame(text)).unwrap());
    bench.sim.run_for(Time::from_us(30));
    can.cancel_all();
    assert!(can.is_cancelling());
    let outcomes = tickets.map(|ticket| can.wait_for(ticket, DONE).unwrap());
    assert_eq!(outcomes, [Outcome::SentAnyway, Outcome::Cancelled, Outcome::Cancelled]);
    assert!(!can.is_cancelling());
    assert_eq!(bench.seen(other).len(), 1);
    assert!(can.send(&frame("103#")).is_ok());
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other)[1], "103#");
    bench.finish();
}

/// Table 8-1: loss of arbitration is told, during the attempts and afterwards.
#[test]
fn table_8_1_lost_arbitration() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(1));
    for text in ["000#0000000000000000", "010#0000000000000000"] {
        bench.sim.peer_send(other, frame(text));
    }
    bench.sim.run_for(Time::from_us(30));
    let ticket = can.send(&frame("100#")).unwrap();
    assert_eq!((can.outcome(ticket), can.attempts(ticket)), (Outcome::Pending, (false, false)));
    bench.sim.run_for(FRAME);
    assert_eq!((can.outcome(ticket), can.attempts(ticket)), (Outcome::Pending, (true, false)));
    bench.sim.run_for(FRAME * 2);
    assert_eq!((can.outcome(ticket), can.attempts(ticket)), (Outcome::Sent, (true, false)));
    let ticket = can.send(&frame("101#")).unwrap();
    bench.sim.run_for(FRAME);
    assert_eq!(can.attempts(ticket), (false, false));
    bench.finish();
}

/// Figure 8-2: node 1 asks from buffer 1 and stores the answer in buffer 14; node 2 answers from buffer 7.
#[test]
#[allow(unsafe_code, reason = "simulated memory")]
fn figure_8_2_remote_request_and_response() {
    let bench = Bench::new();
    let ram = bench.sim.add_memory(can_sim::Memory::new(256).with_widths(&[8, 16]));
    let id = bench.sim.add_dspic33_ecan("can2", can_sim::dspic33_ecan::EcanConfig::new(ram)).unwrap();
    let filter = |buffer| [Filter::new(standard(0x123), MaskSource::Mask0, FilterTarget::Buffer(buffer))];
    let masks = [Mask::STANDARD; 3];
    let (to_14, to_7) = (filter(14), filter(7));
    let asking = CONFIG.with_filters(masks, &to_14).with_use(1, Use::Dedicated(TxPriority::Lowest));
    let mut node1 = bench.running(&PLAN, &asking);
    // SAFETY: nothing else uses this memory.
    let region = unsafe { can_hal::Region::new(bench.sim.memory(ram), 0, 1024) };
    let mut node2 = can_hal::dspic33_ecan::Can::new(bench.sim.registers(id), region, &PLAN, MODE).unwrap();
    node2.configure(&CONFIG.with_filters(masks, &to_7).with_use(7, Use::Reply(TxPriority::Lowest))).unwrap();
    node2.set_reply(7, &frame("123#CAFE")).unwrap();
    let mut node2 = node2.start_normal(MODE).unwrap();
    node1.send_buffer(1, &frame("123#R8")).unwrap();
    bench.sim.run_for(FRAME * 2);
    assert_eq!(node1.receive_buffer(14).map(|message| message.frame), Some(frame("123#CAFE")));
    assert_eq!(node2.receive_message(), Ok(None), "the request is not stored");
    assert_eq!(node2.take_interrupts(), Interrupts::TBIF);
    // The answer can be changed while the node runs.
    node2.set_reply(7, &frame("123#BEEF01")).unwrap();
    node1.send_buffer(1, &frame("123#R8")).unwrap();
    bench.sim.run_for(FRAME * 2);
    assert_eq!(node1.receive_buffer(14).map(|message| message.frame), Some(frame("123#BEEF01")));
    assert_eq!(node2.set_reply(6, &frame("123#")), Err(SendError::NoSuchBuffer { buffer: 6, count: 8 }));
    bench.finish();
}

/// 8.3.2: a request that arrives before any access of a change of the answer gets the old one, the new one or none, and no
/// mixture.
#[test]
fn section_8_3_2_the_answer_changes_while_requests_arrive() {
    let (old, new) = ("123#1111111111111111", "123#2222222222222222");
    let filters = [Filter::new(standard(0x123), MaskSource::Mask0, FilterTarget::Buffer(7))];
    let config = CONFIG.with_filters([Mask::STANDARD; 3], &filters).with_use(7, Use::Reply(TxPriority::Lowest));
    for (skip, run) in (0..16).flat_map(|skip| [65, 120, 400].map(|run| (skip, Time::from_us(run)))) {
        let bench = Bench::new();
        let other = bench.peer();
        let mut can = bench.configured(&PLAN, &config);
        can.set_reply(7, &frame(old)).unwrap();
        let mut can = can.start_normal(MODE).unwrap();
        bench.sim.interrupt_host(skip, move |sim: &Sim| {
            sim.peer_send(other, frame("123#R8"));
            sim.run_for(run);
        });
        let changed = can.set_reply(7, &frame(new));
        for _ in 0..skip {
            let _ = can.status();
        }
        bench.sim.run_for(FRAME * 3);
        let mut seen = bench.seen(other);
        assert!(seen.len() <= 1 && seen.iter().all(|text| text == old || text == new), "{skip}: {seen:?}");
        bench.send(other, &["123#R8"]);
        bench.sim.run_for(FRAME);
        seen = bench.seen(other);
        let expected = match changed {
            Ok(()) => new,
            Err(SendError::Pending { buffer: 7 }) => old,
            Err(error) => panic!("{error}"),
        };
        assert_eq!(seen.last().map(String::as_str), Some(expected), "before access {skip}, for {run}");
        bench.finish();
    }
}

/// 8.3.2, note: an answer whose length depends on the request is software's: the request is received like any message.
#[test]
fn section_8_3_2_answer_by_software() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(1));
    bench.send(other, &["00000077#R3"]);
    let request = can.receive_buffer(8).unwrap().frame;
    assert!(request.is_remote());
    let data = &[9; 8][..usize::from(request.dlc().code())];
    can.send(&can_hal::Frame::data(request.id(), data).unwrap()).unwrap();
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other), ["00000077#090909"]);
    bench.finish();
}

/// 11.2, Figure 11-1: warning, error passive, bus off, and back by itself after 128 times 11 recessive bits.
#[test]
fn figure_11_1_error_states() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(1));
    let (node, position) = (bench.sim.node(bench.id), Position::new(Field::Data, 0));
    let frames = Frames { count: 32, ..Frames::next_of(node) };
    let fault = Fault::Bit { node, fault: BitFault::InvertDriven, position, frames };
    bench.sim.with_wire(|wire| wire.inject(fault));
    can.send(&frame("100#00")).unwrap();
    let mut seen = Vec::new();
    for _ in 0..2_000 {
        let status = can.status();
        if seen.last() != Some(&(status.error_state, status.warning)) {
            seen.push((status.error_state, status.warning));
        }
        if status.is_bus_off() {
            break;
        }
        bench.sim.run_for(Time::from_us(5));
    }
    let active = ErrorState::Active;
    assert_eq!(seen, [(active, false), (active, true), (ErrorState::Passive, true), (ErrorState::BusOff, true)]);
    let events = can.interrupts().events();
    assert!(
        events.contains(Events::WARNING | Events::PASSIVE | Events::BUS_OFF | Events::PROTOCOL_ERROR),
        "{events:?}"
    );
    bench.sim.run_for(Time::from_us(129 * 11) + FRAME);
    let status = can.status();
    assert_eq!((status.error_state, status.counters.transmit), (active, 0));
    assert_eq!(bench.seen(other), ["100#00"]);
    bench.finish();
}
