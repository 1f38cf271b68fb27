//! Chapter 3.5: transmission.

use can_hal::{
    Outcome, Polls, SendError, Transmit,
    m_can::{Config, DataFieldSize, Interrupts, TxEventKind, TxMode, TxOptions},
    memory::MCanMemory,
};
use can_sim::Time;

use crate::bench::{Bench, FRAME, TIMING, frame, frames};

const PLAIN: TxOptions = TxOptions { marker: None, sync: false };

/// 3.5.2: dedicated Tx Buffers; equal identifiers go by buffer number, others by priority.
#[test]
fn section_3_5_2_dedicated_tx_buffers() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    for (buffer, text) in [(0, "200#00"), (1, "100#01"), (2, "200#02")] {
        can.write_buffer(buffer, &frame(text), PLAIN).unwrap();
    }
    can.request(0b111);
    assert_eq!(can.send_buffer(1, &frame("300#"), PLAIN), Err(SendError::Pending { buffer: 1 }));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other), ["100#01", "200#00", "200#02"]);
    assert_eq!(can.send_buffer(3, &frame("300#"), PLAIN), Err(SendError::NoSuchBuffer { buffer: 3, count: 3 }));
    let ticket = can.send_buffer(1, &frame("300#"), PLAIN).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}

/// 3.5.3: one message at the put index, with a check for room before.
#[test]
fn section_3_5_3_tx_fifo_single() {
    let bench = Bench::new();
    let mut can = bench.running(&Config::new(TIMING));
    assert_eq!(can.tx_queue_status().free, 4);
    for expected in 3..7 {
        let ticket = can.send_queued(&frame("123#"), PLAIN).unwrap();
        assert_eq!(ticket.buffer(), expected, "the FIFO is behind the dedicated buffers");
    }
    assert!(can.tx_queue_status().full);
    assert_eq!(can.send_queued(&frame("123#"), PLAIN), Err(SendError::Full));
    let other = bench.peer();
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other).len(), 4);
    assert_eq!(can.send_queued(&frame("124#"), PLAIN).unwrap().buffer(), 3, "the put index wraps");
    bench.finish();
}

/// 3.5.3: n messages with one request.
#[test]
fn section_3_5_3_tx_fifo_many() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    for round in 0..3 {
        let ticket = can.send_all(&frames(&["300#01", "200#02", "100#03"])).unwrap();
        assert_eq!(can.send_all(&frames(&["300#01", "200#02"])), Err(SendError::Full), "round {round}");
        assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    }
    assert_eq!(bench.seen(other).len(), 9);
    assert_eq!(bench.seen(other)[6..], ["300#01", "200#02", "100#03"]);
    bench.finish();
}

/// 3.5.4: a queue sends by identifier, and hands out the lowest free buffer.
#[test]
fn section_3_5_4_tx_queue() {
    let bench = Bench::new();
    let mut can = bench.running(&Config { tx_mode: TxMode::Queue, ..Config::new(TIMING) });
    assert!(can.is_tx_queue());
    // Nobody listens yet, so everything stays pending.
    for text in ["400#", "300#", "200#", "100#"] {
        can.send_queued(&frame(text), PLAIN).unwrap();
    }
    assert_eq!(can.send_queued(&frame("000#"), PLAIN), Err(SendError::Full));
    let other = bench.sim.add_peer(can_wire::NodeConfig::new()).unwrap();
    bench.sim.run_for(FRAME * 2);
    // After each attempt without acknowledge the next one is chosen anew (3.5).
    assert_eq!(bench.seen(other), ["100#", "200#", "300#", "400#"]);
    // The same buffer is handed out again and again.
    for _ in 0..5 {
        let ticket = can.send_queued(&frame("123#"), PLAIN).unwrap();
        assert_eq!(ticket.buffer(), 3);
        assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    }
    bench.finish();
}

/// 2.3.36: NDTB 12, TFQS 20, put index 15 is the fourth FIFO buffer.
#[test]
fn section_2_3_36_put_index() {
    let bench = Bench::new();
    let memory = MCanMemory::new(4352 * 4).tx_buffers(12, 20, DataFieldSize::Bytes8);
    let mut can = bench.driver(&memory);
    can.configure(&Config::new(TIMING)).unwrap();
    let mut can = can.start_normal(Polls(20)).unwrap();
    bench.sim.run_for(FRAME);
    let tickets = [0; 4].map(|_| can.send_queued(&frame("123#"), PLAIN).unwrap().buffer());
    assert_eq!(tickets, [12, 13, 14, 15]);
    bench.finish();
}

/// Sends 20 frames as fast as they are taken, and checks that each is sent once.
fn send_twenty(bench: &Bench, memory: &MCanMemory, tx_mode: TxMode) {
    let other = bench.peer();
    let mut can = bench.driver(memory);
    can.configure(&Config { tx_mode, ..Config::new(TIMING) }).unwrap();
    let mut can = can.start_normal(Polls(200)).unwrap();
    bench.sim.run_for(FRAME);
    let (mut sent, mut last) = (0, None);
    while sent < 20 {
        match can.send(&frame(&format!("1{sent:02}#{sent:02}"))) {
            Ok(ticket) => {
                // What was there before is forgotten, however early one asks.
                assert_eq!(can.outcome(ticket), Outcome::Pending);
                sent += 1;
                last = Some(ticket);
            }
            Err(error) => assert_eq!(error, SendError::Full),
        }
    }
    assert_eq!(can.wait_for(last.unwrap(), Polls(100_000)), Ok(Outcome::Sent));
    bench.sim.run_for(FRAME * 4);
    let mut seen = bench.seen(other);
    seen.sort();
    let all: Vec<String> = (0..20).map(|n| format!("1{n:02}#{n:02}")).collect();
    assert_eq!(seen, all);
    bench.finish();
}

const fn tx_buffers(dedicated: u32, queue: u32) -> MCanMemory {
    MCanMemory::new(4352 * 4).tx_buffers(dedicated, queue, DataFieldSize::Bytes8)
}

/// 2.3.36: a Tx scan that is still running hides a request; no element is written twice.
#[test]
fn section_2_3_36_a_running_scan_delays_the_status() {
    for (dedicated, queue) in [(0, 4), (0, 1), (2, 0), (1, 0)] {
        for tx_mode in [TxMode::Fifo, TxMode::Queue] {
            let mut choices = can_sim::m_can::Choices::default();
            choices.tx_scan = Time::from_us(3);
            let bench = Bench::with(|config| config.with_choices(choices));
            send_twenty(&bench, &tx_buffers(dedicated, queue), tx_mode);
        }
    }
}

/// 2.2: the status follows a command after a delay, which a fast host does not outrun.
#[test]
fn section_2_2_the_status_follows_a_command() {
    for (dedicated, queue) in [(0, 4), (0, 1), (2, 0), (1, 0)] {
        for tx_mode in [TxMode::Fifo, TxMode::Queue] {
            let bench = Bench::with_fast_host(|config| config);
            send_twenty(&bench, &tx_buffers(dedicated, queue), tx_mode);
        }
    }
}

/// 3.5.6: TXBCR, then TXBCF; TXBTO says whether it was sent anyway.
#[test]
fn section_3_5_6_cancellation() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&Config::new(TIMING));
    can.enable_buffer_interrupts(0b111, 0b111);
    let running = can.send_buffer(0, &frame("100#0102030405060708"), PLAIN).unwrap();
    let waiting = can.send_buffer(1, &frame("200#"), PLAIN).unwrap();
    bench.sim.run_for(Time::from_us(30));
    can.cancel_buffers(0b11);
    assert_eq!(can.wait_for(waiting, Polls(10)), Ok(Outcome::Cancelled));
    assert_eq!(can.outcome(running), Outcome::Pending);
    assert_eq!(can.wait_for(running, Polls(10_000)), Ok(Outcome::SentAnyway));
    assert_eq!(bench.seen(other), ["100#0102030405060708"]);
    assert!(can.take_interrupts().contains(Interrupts::TC | Interrupts::TCF));
    // The place is free, and its past forgotten.
    let again = can.send_buffer(1, &frame("201#"), PLAIN).unwrap();
    assert_eq!(can.wait_for(again, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}

/// 3.1.7: without retransmission a frame is sent or has failed; its Tx event always has the second code.
#[test]
fn section_3_1_7_disabled_automatic_retransmission() {
    let bench = Bench::new();
    let mut can = bench.running(&Config { one_shot: true, ..Config::new(TIMING) });
    let failed = can.send_queued(&frame("123#"), TxOptions::marked(1)).unwrap();
    assert_eq!(can.wait_for(failed, Polls(10_000)), Ok(Outcome::Failed));
    bench.sim.run_for(FRAME);
    let _other = bench.peer();
    let sent = can.send_queued(&frame("124#"), TxOptions::marked(2)).unwrap();
    assert_eq!(can.wait_for(sent, Polls(10_000)), Ok(Outcome::Sent));
    let event = can.tx_event().unwrap().unwrap();
    assert_eq!((event.marker, event.kind), (2, TxEventKind::SentAnyway));
    assert_eq!(can.tx_event(), Ok(None));
    bench.finish();
}

/// 3.5.7: Tx events tell which frame was sent when; one that finds the FIFO full is lost.
#[test]
fn section_3_5_7_tx_event_fifo() {
    let bench = Bench::new();
    let _other = bench.peer();
    let mut can = bench
        .running(&Config { timestamps: can_hal::m_can::Timestamping::Counter { bit_times: 1 }, ..Config::new(TIMING) });
    for marker in 0..4 {
        let text = format!("12{marker}#R{marker}");
        let ticket = can.send_queued(&frame(&text), TxOptions::marked(marker)).unwrap();
        can.wait_for(ticket, Polls(10_000)).unwrap();
    }
    assert!(can.take_interrupts().contains(Interrupts::TEFN | Interrupts::TEFF));
    let ticket = can.send_queued(&frame("12F#"), TxOptions::marked(9)).unwrap();
    can.wait_for(ticket, Polls(10_000)).unwrap();
    assert!(can.tx_event().is_err(), "an event was lost");
    let mut last = None;
    for marker in 0..4 {
        let event = can.tx_event().unwrap().unwrap();
        let sent = frame(&format!("12{marker}#R{marker}"));
        assert_eq!((event.id, event.format, event.dlc), (sent.id(), sent.format(), sent.dlc()));
        assert_eq!((event.marker, event.kind), (marker, TxEventKind::Sent));
        assert!(event.timestamp.is_some());
        assert_ne!(event.timestamp, last);
        last = event.timestamp;
    }
    assert_eq!(can.tx_event(), Ok(None));
    bench.finish();
}

/// 2.3.7, 2.4.3: message markers of 16 bits cost the timestamp of the event.
#[test]
fn section_2_3_7_wide_message_markers() {
    let bench = Bench::new();
    let _other = bench.peer();
    for wide_markers in [false, true] {
        let mut can = bench.running(&Config { wide_markers, ..Config::new(TIMING) });
        let sent = can.send_queued(&frame("123#"), TxOptions::marked(0xABCD));
        if wide_markers {
            can.wait_for(sent.unwrap(), Polls(10_000)).unwrap();
            let event = can.tx_event().unwrap().unwrap();
            assert_eq!((event.marker, event.timestamp), (0xABCD, None));
        } else {
            assert_eq!(sent, Err(SendError::MarkerTooWide { marker: 0xABCD }));
        }
    }
    bench.finish();
}

/// Table 58: what the configuration cannot send is refused instead of sent as something else.
#[test]
fn table_58_possible_frame_formats() {
    use can_hal::m_can::FdMode;
    let bench = Bench::new();
    let other = bench.peer();
    let fd = |bit_rate_switch| FdMode::Fd { bit_rate_switch, non_iso: false };
    let (classic, plain, switched) = ("123#01", "123##001", "123##101");
    let disabled = Err(SendError::FdDisabled);
    let no_switch = Err(SendError::BitRateSwitchDisabled);
    let cases = [
        (FdMode::Classic, [(classic, Ok(())), (plain, disabled), (switched, disabled)]),
        (fd(false), [(classic, Ok(())), (plain, Ok(())), (switched, no_switch)]),
        (fd(true), [(classic, Ok(())), (plain, Ok(())), (switched, Ok(()))]),
    ];
    for (mode, formats) in cases {
        let mut can = bench.running(&Config { fd: mode, ..Config::new(TIMING) });
        for (text, expected) in formats {
            assert_eq!(can.send_queued(&frame(text), PLAIN).map(|_| ()), expected, "{mode:?} {text}");
        }
        bench.sim.run_for(FRAME);
    }
    assert_eq!(bench.seen(other), [classic, classic, plain, classic, plain, switched]);
    bench.finish();
}

/// 2.3.37: a frame that has no room in the element is refused; its missing bytes would be sent as 0xCC.
#[test]
fn section_2_3_37_data_field_size() {
    let bench = Bench::new();
    let mut can = bench.driver(&MCanMemory::new(4352 * 4).tx_buffers(0, 1, DataFieldSize::Bytes8));
    can.configure(&Config::new(TIMING).with_fd()).unwrap();
    let mut can = can.start_normal(Polls(20)).unwrap();
    let long = frame("123##1000102030405060708090A0B");
    assert_eq!(can.send_queued(&long, PLAIN), Err(SendError::TooLong { len: 12, room: 8 }));
    assert!(can.send_queued(&frame("123##10001020304050607"), PLAIN).is_ok());
}
