//! Chapter 3.4: receiving.

use can_hal::{
    ExtendedId, Overflow, Receive, StandardId,
    m_can::{
        Action, Config, DebugMessage, DebugState, FifoMode, Filter, HighPriorityStorage, Interrupts, Matching, RxFifo,
        RxMessage,
    },
};
use regbus::Bus;

use crate::bench::{Bench, Driver, FRAME, TIMING, texts};

fn sid(id: u16) -> StandardId {
    StandardId::new(id).unwrap()
}

fn eid(id: u32) -> ExtendedId {
    ExtendedId::new(id).unwrap()
}

fn drain<S: can_hal::mode::OnBus>(can: &mut Driver<'_, S>, fifo: RxFifo) -> Vec<RxMessage> {
    std::iter::from_fn(|| can.receive_fifo(fifo).unwrap()).collect()
}

/// 3.4.2: read RXFnS, read the element at the get index, write the index to RXFnA.
#[test]
fn section_3_4_2_rx_fifo() {
    let bench = Bench::new();
    let sender = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    bench.send(sender, &["100#01", "101#02", "102#03"]);
    let status = can.fifo_status(RxFifo::Fifo0);
    assert_eq!((status.level, status.get, status.put, status.full), (3, 0, 3, false));
    bench.sim.trace(true);
    let message = can.receive_fifo(RxFifo::Fifo0).unwrap().unwrap();
    assert_eq!(texts(&[message]), ["100#01"]);
    let accesses = bench.accesses();
    let names: Vec<&str> = accesses.iter().map(|(name, _, _)| name.as_str()).collect();
    assert_eq!(names, ["RXF0S", "RXF0A"]);
    assert_eq!(texts(&drain(&mut can, RxFifo::Fifo0)), ["101#02", "102#03"]);
    // The indices wrap.
    bench.send(sender, &["103#", "104#", "105#", "106#", "107#"]);
    assert_eq!(texts(&drain(&mut can, RxFifo::Fifo0)), ["103#", "104#", "105#", "106#", "107#"]);
    bench.finish();
}

/// 2.2: the get index follows an acknowledge after a delay; a fast host does not read a message twice.
#[test]
fn section_2_2_no_message_is_read_twice() {
    let bench = Bench::with_fast_host(|config| config);
    let sender = bench.peer();
    let can = bench.configured(&Config::new(TIMING));
    let mut can = can.start_normal(can_hal::Polls(200)).unwrap();
    bench.sim.run_for(FRAME);
    for _ in 0..3 {
        bench.send(sender, &["100#01", "101#02", "102#03", "103#", "104#"]);
        let messages = drain(&mut can, RxFifo::Fifo0);
        assert_eq!(texts(&messages), ["100#01", "101#02", "102#03", "103#", "104#"]);
    }
    bench.finish();
}

/// 3.4.2.1: a full FIFO discards, sets RF0L, and goes on after an acknowledge.
#[test]
fn section_3_4_2_1_blocking_mode() {
    let bench = Bench::new();
    let sender = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    bench.send(sender, &["100#", "101#", "102#", "103#", "104#", "105#", "106#"]);
    let status = can.fifo_status(RxFifo::Fifo0);
    assert!(status.full && status.lost && status.level == 6);
    assert_eq!(can.receive_fifo(RxFifo::Fifo0), Err(Overflow { fifo: 0 }));
    assert!(!can.interrupt_flags().contains(Interrupts::RF0L));
    assert!(can.interrupt_flags().contains(Interrupts::RF0F), "only the flag of the loss was cleared");
    assert_eq!(drain(&mut can, RxFifo::Fifo0).len(), 6);
    bench.finish();
}

/// 3.4.2.2, Figure 9: a full FIFO that overwrites is read from get index + 1 on.
#[test]
fn section_3_4_2_2_overwrite_mode() {
    let bench = Bench::new();
    let sender = bench.peer();
    let mut can = bench.running(&Config { rx_mode: [FifoMode::Overwrite; 2], ..Config::new(TIMING) });
    bench.send(sender, &["100#", "101#", "102#", "103#", "104#", "105#", "106#", "107#"]);
    let status = can.fifo_status(RxFifo::Fifo0);
    assert!(status.full && !status.lost);
    assert_eq!((status.get, status.put), (2, 2));
    assert_eq!(texts(&drain(&mut can, RxFifo::Fifo0)), ["103#", "104#", "105#", "106#", "107#"]);
    // 2.3.28: the get index is the acknowledged index plus one, so the element left out is gone.
    assert_eq!(can.fifo_status(RxFifo::Fifo0).level, 0);
    bench.finish();
}

/// 3.4.2, 2.3.24: a high priority message is read from the middle without an acknowledge.
#[test]
fn section_3_4_2_high_priority_message_out_of_order() {
    let bench = Bench::new();
    let sender = bench.peer();
    let standard = [
        Filter::exact(sid(0x080), Action::PriorityFifo0),
        Filter::exact(sid(0x081), Action::Priority),
        Filter::mask(sid(0), 0, Action::Fifo0),
    ];
    let extended = [Filter::exact(eid(0x1_2345), Action::PriorityFifo1)];
    let mut can = bench.running(&Config::new(TIMING).with_filters(&standard, &extended));
    bench.send(sender, &["100#", "101#", "080#AA", "102#"]);
    assert!(can.take_interrupts().contains(Interrupts::HPM));
    let urgent = can.high_priority();
    assert_eq!((urgent.extended, urgent.filter), (false, 0));
    let HighPriorityStorage::Fifo(fifo, index) = urgent.storage else { panic!("{urgent:?}") };
    assert_eq!((fifo, index), (RxFifo::Fifo0, 2));
    assert_eq!(texts(&[can.peek_fifo(fifo, index).unwrap()]), ["080#AA"]);
    assert_eq!(texts(&drain(&mut can, RxFifo::Fifo0)), ["100#", "101#", "080#AA", "102#"]);
    assert_eq!(can.peek_fifo(RxFifo::Fifo0, 6), None);
    bench.send(sender, &["081#"]);
    assert_eq!((can.high_priority().filter, can.high_priority().storage), (1, HighPriorityStorage::None));
    bench.send(sender, &["00012345#", "00012345#", "00012345#", "00012345#", "00012345#"]);
    assert!(can.high_priority().extended);
    assert_eq!(can.high_priority().storage, HighPriorityStorage::Lost);
    bench.finish();
}

/// 3.4.3, Table 56, and 3.4.3.1: reset IR.DRX, read NDAT1/2, read messages, reset the New Data flags.
#[test]
fn section_3_4_3_1_rx_buffer_handling() {
    let bench = Bench::new();
    let sender = bench.peer();
    let filters = [Filter::buffer(sid(0x111), 0), Filter::buffer(sid(0x222), 1), Filter::buffer(sid(0x333), 2)];
    let mut can = bench.running(&Config::new(TIMING).with_filters(&filters, &[]));
    // Table 56: SFEC 7, SFID2[10:9] = 00, SFID2[5:0] = 0, 1, 2.
    let words: Vec<u32> = (0..3).map(|n| bench.sim.memory(bench.ram).read::<u32>(n * 4)).collect();
    assert_eq!(words.iter().map(|word| word & 0x7FF).collect::<Vec<_>>(), [0, 1, 2]);
    assert!(words.iter().all(|word| word >> 27 & 7 == 7));
    bench.send(sender, &["222#02", "333#03"]);
    assert!(can.interrupt_flags().contains(Interrupts::DRX));
    bench.sim.trace(true);
    assert_eq!(can.new_data(), 0b110);
    let message = can.receive_buffer(1).unwrap();
    let order: Vec<(String, bool)> = bench.accesses().into_iter().map(|(name, write, _)| (name, write)).collect();
    let at = |name: &str, write| order.iter().position(|(n, w)| n == name && *w == write).unwrap();
    assert!(at("IR", true) < at("NDAT1", false) && at("NDAT1", false) < at("NDAT1", true), "{order:?}");
    assert_eq!(texts(&[message]), ["222#02"]);
    assert_eq!(message.filter, Some(1));
    assert_eq!(can.new_data(), 0b100);
    assert_eq!(can.receive_buffer(1), None);
    // 3.4.3: while its flag is set a buffer is locked; nothing else matches here.
    bench.send(sender, &["333#FF"]);
    assert_eq!(texts(&[can.receive_buffer(2).unwrap()]), ["333#03"]);
    assert_eq!(can.receive_buffer(64), None);
    bench.finish();
}

/// A message that arrives while the New Data flags are served raises IR.DRX again.
#[test]
fn section_3_4_3_1_a_message_that_arrives_meanwhile_is_not_missed() {
    for skip in 0..6 {
        let bench = Bench::new();
        let sender = bench.peer();
        let filters = [Filter::buffer(sid(0x111), 0), Filter::buffer(sid(0x222), 40)];
        let mut can = bench.running(&Config::new(TIMING).with_filters(&filters, &[]));
        bench.send(sender, &["111#01"]);
        bench.sim.interrupt_host(skip, move |sim| {
            sim.peer_send(sender, crate::bench::frame("222#02"));
            sim.run_for(FRAME);
        });
        let mut received = Vec::new();
        while can.interrupt_flags().contains(Interrupts::DRX) {
            let flags = can.new_data();
            let buffers = (0..64).filter(|buffer| flags >> buffer & 1 == 1);
            received.extend(buffers.filter_map(|buffer| can.receive_buffer(buffer)));
        }
        assert_eq!(texts(&received), ["111#01", "222#02"], "before access {skip}");
    }
}

/// 3.4.4, Table 57: debug messages A, B, C in Rx Buffers 61, 62, 63.
#[test]
fn section_3_4_4_debug_messages() {
    let bench = Bench::new();
    let sender = bench.peer();
    let filters = [
        Filter::debug(sid(0x111), DebugMessage::A, 61),
        Filter::debug(sid(0x222), DebugMessage::B, 62),
        Filter::debug(sid(0x333), DebugMessage::C, 63),
    ];
    let mut can = bench.running(&Config::new(TIMING).with_filters(&filters, &[]));
    let word = |n: usize| bench.sim.memory(bench.ram).read::<u32>(n * 4) & 0x7FF;
    // SFID2[10:9] and SFID2[5:0].
    let table_57 = [(0b01, 0x3D), (0b10, 0x3E), (0b11, 0x3F)];
    assert_eq!([word(0), word(1), word(2)], table_57.map(|(destination, buffer)| destination << 9 | buffer));
    for (text, state) in [("111#0A", DebugState::A), ("222#0B", DebugState::AB), ("333#0C", DebugState::ABC)] {
        bench.send(sender, &[text]);
        assert_eq!(can.debug_state(), state);
    }
    // 3.4.4: neither DRX nor New Data flags.
    assert!(!can.interrupt_flags().contains(Interrupts::DRX));
    assert_eq!(can.new_data(), 0);
    let messages = [61, 62, 63].map(|buffer| can.read_buffer(buffer).unwrap());
    assert_eq!(texts(&messages), ["111#0A", "222#0B", "333#0C"]);
    bench.finish();
}

/// 3.4.1, 2.4.5, 2.4.6: every kind of filter, each tried on both sides of its border.
#[test]
fn section_3_4_1_acceptance_filtering() {
    let bench = Bench::new();
    let sender = bench.peer();
    let standard = [
        Filter::range(sid(0x100), sid(0x10F), Action::Fifo0),
        Filter::dual(sid(0x200), sid(0x202), Action::Fifo1),
        Filter::mask(sid(0x300), 0x7F0, Action::Fifo1),
        Filter::exact(sid(0x400), Action::Reject),
        Filter::range(sid(0x400), sid(0x401), Action::Fifo0),
    ];
    let extended = [
        Filter::range(eid(0x100), eid(0x1FF), Action::Fifo0),
        Filter::new(Matching::RangeUnmasked(eid(0x1000_0200), eid(0x1000_02FF), Action::Fifo1)),
        Filter::mask(eid(0x300), 0x700, Action::Fifo1),
    ];
    // XIDAM: the upper bits do not count, but for ranges that say so.
    let config = Config { extended_mask: eid(0x00FF_FFFF), ..Config::new(TIMING).with_filters(&standard, &extended) };
    let mut can = bench.running(&config);
    let cases = [
        ("0FF#", None),
        ("100#", Some((RxFifo::Fifo0, 0))),
        ("10F#", Some((RxFifo::Fifo0, 0))),
        ("110#", None),
        ("200#", Some((RxFifo::Fifo1, 1))),
        ("201#", None),
        ("202#", Some((RxFifo::Fifo1, 1))),
        ("30F#", Some((RxFifo::Fifo1, 2))),
        ("310#", None),
        ("400#", None),
        ("401#", Some((RxFifo::Fifo0, 4))),
        ("1F000150#", Some((RxFifo::Fifo0, 0))),
        ("10000250#", Some((RxFifo::Fifo1, 1))),
        ("1F000250#", None),
        ("00000250#", None),
        ("1F000301#", Some((RxFifo::Fifo1, 2))),
        ("00000401#", None),
    ];
    for (text, expected) in cases {
        bench.send(sender, &[text]);
        let found = [RxFifo::Fifo0, RxFifo::Fifo1]
            .into_iter()
            .find_map(|fifo| Some((fifo, can.receive_fifo(fifo).unwrap()?.filter?)));
        assert_eq!(found, expected, "{text}");
    }
    bench.finish();
}

/// 2.4.5: filter elements are in the Message RAM and may change while the controller runs.
#[test]
fn section_2_4_5_filters_change_at_run_time() {
    let bench = Bench::new();
    let sender = bench.peer();
    let mut can = bench.running(&Config::new(TIMING).with_filters(&[], &[]));
    bench.send(sender, &["123#", "00000123#"]);
    assert_eq!(can.fetch(), Ok(None));
    can.set_standard_filter(7, &Filter::exact(sid(0x123), Action::Fifo0)).unwrap();
    can.set_extended_filter(3, &Filter::exact(eid(0x123), Action::Fifo0)).unwrap();
    bench.send(sender, &["123#", "00000123#"]);
    assert_eq!(texts(&drain(&mut can, RxFifo::Fifo0)), ["123#", "00000123#"]);
    can.set_standard_filter(7, &Filter::DISABLED).unwrap();
    bench.send(sender, &["123#"]);
    assert_eq!(can.fetch(), Ok(None));
    bench.finish();
}

/// What cannot be a filter is refused, with the facts.
#[test]
fn section_2_4_5_impossible_filters() {
    use can_hal::m_can::FilterError;
    let bench = Bench::new();
    let mut can = bench.configured(&Config::new(TIMING));
    let range = Filter::range(sid(2), sid(1), Action::Fifo0);
    assert_eq!(can.set_standard_filter(0, &range), Err(FilterError::Reversed { first: 2, last: 1 }));
    let element = FilterError::NoSuchElement { index: 8, count: 8 };
    assert_eq!(can.set_standard_filter(8, &Filter::DISABLED), Err(element));
    let mask = Filter::mask(sid(2), 0x800, Action::Fifo0);
    assert_eq!(can.set_standard_filter(0, &mask), Err(FilterError::MaskTooWide { mask: 0x800 }));
    let buffer = Filter::buffer(eid(2), 64);
    assert_eq!(can.set_extended_filter(0, &buffer), Err(FilterError::NoSuchBuffer { buffer: 64, count: 64 }));
    let pins = Filter::buffer(eid(2), 0).with_event_pins(8);
    assert_eq!(can.set_extended_filter(0, &pins), Err(FilterError::EventPins { pins: 8 }));
}
