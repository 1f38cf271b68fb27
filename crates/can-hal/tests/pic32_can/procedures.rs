//! The numbered procedures of the manual.

use can_hal::{
    Events, Id, InterruptSet, Outcome, Polls, Receive as _, Sleep, StandardId, Transmit, Wake,
    memory::Pic32CanFifo::{Receive, ReceiveData, Transmit as Tx},
    pic32_can::{Config, FifoFlags, Filter, InterruptCode, Interrupts, Mask, Priority, TxFifo},
};
use can_sim::{Time, pic32_can::DeviceState};

use crate::bench::{ANY, Bench, FRAME, TIMING, WAIT, everything, frame};

/// 34.6.1, steps 1 to 6: memory, Configuration mode, CiFIFOBA, FSIZE, TXEN, Normal mode; and ON, which no step has
/// (on_missing_in_steps).
#[test]
fn section_34_6_1_fifo_configuration() {
    let bench = Bench::at(0x1000);
    // Figure 34-9, what it calls FIFO3 being FIFO2 (figure_34_9_fifo3): 36 words.
    let memory = bench.memory(0x1000);
    let memory =
        memory.fifo(0, Tx { elements: 4 }).fifo(1, ReceiveData { elements: 2 }).fifo(2, Receive { elements: 4 });
    assert_eq!(memory.plan().unwrap().end() - 0x1000, 36 * 4);
    bench.sim.trace(true);
    let can = bench.running(&memory, &Config::new(TIMING));
    let writes: Vec<String> = bench.accesses().iter().filter(|a| a.1).map(|a| a.0.clone()).collect();
    let first = |name: &str| writes.iter().position(|write| write == name).unwrap();
    assert!(first("CON") < first("FIFOBA") && first("FIFOBA") < first("FIFOCON[0]"));
    assert_eq!(writes.last().unwrap(), "CON", "Normal mode is the last step");
    let addresses = [0, 1, 2].map(|n| can.registers().fifo(n).ua().read().bits());
    assert_eq!(addresses, [0x1000, 0x1040, 0x1050]);
    bench.finish();
}

/// 34.6.1: FIFOs that are not set up take room where a higher one is used.
#[test]
fn section_34_6_1_unused_fifos() {
    let bench = Bench::at(0x1000);
    let memory = bench.memory(0x1000).fifo(0, Tx { elements: 4 }).fifo(1, ReceiveData { elements: 2 });
    let memory = memory.fifo(3, Receive { elements: 4 });
    let can = bench.running(&memory, &Config::new(TIMING));
    assert_eq!(can.registers().fifo(3).ua().read().bits(), 0x1060);
    assert_eq!(memory.plan().unwrap().fifo(3).unwrap().placed.start, 0x1060);
    bench.finish();
}

/// 34.6.2, steps 1 to 4, each message with address, message and UINC (step_lists).
#[test]
fn section_34_6_2_loading_messages() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 3 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    for (text, next) in [("100#", 0x110), ("101#", 0x120), ("102#", 0x100)] {
        can.load(0, &frame(text)).unwrap();
        assert_eq!(can.registers().fifo(0).ua().read().bits(), next);
    }
    assert_eq!(can.load(0, &frame("103#")), Err(can_hal::SendError::Full));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), Vec::<String>::new());
    can.request(0);
    bench.sim.run_for(FRAME * 3);
    assert_eq!(bench.seen(peer), ["100#", "101#", "102#"]);
    bench.finish();
}

/// 34.6.3, steps 1 to 4: an interrupt tells of messages, and ends when the FIFO is empty.
#[test]
fn section_34_6_3_processing_messages() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 4 });
    let filters = everything(1);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    can.enable_interrupts(Interrupts::RECEIVE);
    bench.send(peer, &["100#", "101#"]);
    let mut texts = Vec::new();
    while bench.sim.line(bench.id, 0) {
        assert_eq!(can.interrupt_code(), Some(InterruptCode::Fifo(1)));
        texts.push(can.receive_fifo(1).unwrap().unwrap().frame.to_string());
    }
    assert_eq!(texts, ["100#", "101#"]);
    assert_eq!(can.interrupt_code(), Some(InterruptCode::NoInterrupt));
    bench.finish();
}

/// 34.7.2, steps 1 to 8: several FIFOs with priorities, messages, and the interrupt that tells that a FIFO is empty.
#[test]
fn section_34_7_2_transmitting_messages() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100);
    let memory = memory.fifo(0, Tx { elements: 2 }).fifo(1, Tx { elements: 2 }).fifo(2, Tx { elements: 2 });
    let fifos =
        [TxFifo::new(0).with_priority(Priority::Highest), TxFifo::new(2).with_priority(Priority::LowIntermediate)];
    let mut can = bench.running(&memory, &Config::new(TIMING).with_tx_fifos(&fifos));
    bench.sim.peer_send(peer, frame("000#1122334455667788"));
    bench.sim.run_for(Time::from_us(20));
    for fifo in [1, 2, 0] {
        for n in 0..2 {
            can.send_through(fifo, &frame(&format!("1{fifo}{n}#"))).unwrap();
        }
    }
    can.enable_fifo_flags(1, FifoFlags::TXEMPTYIE);
    can.enable_interrupts(Interrupts::TRANSMIT);
    assert!(!bench.sim.line(bench.id, 0));
    assert!(bench.sim.run_until(FRAME * 8, |sim| sim.line(bench.id, 0)).is_some());
    assert!(can.interrupts().events().contains(Events::TRANSMITTED));
    assert_eq!(bench.seen(peer), ["100#", "101#", "120#", "121#", "110#", "111#"]);
    bench.finish();
}

/// 34.7.3: a priority is changed while another FIFO is sent.
#[test]
fn section_34_7_3_changing_a_priority() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 2 }).fifo(1, Tx { elements: 2 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    for (fifo, text) in [(1, "200#"), (1, "201#"), (0, "100#"), (0, "101#")] {
        can.send_through(fifo, &frame(text)).unwrap();
    }
    bench.sim.run_for(Time::from_us(10));
    can.set_priority(0, Priority::Highest);
    bench.sim.run_for(FRAME * 4);
    assert_eq!(bench.seen(peer), ["200#", "100#", "101#", "201#"]);
    bench.finish();
}

/// 34.7.4: of two messages the one on the bus is finished, the other aborted and erased; the FIFO can be used again.
#[test]
fn section_34_7_4_aborting() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    let done = can.send_through(0, &frame("0FF#")).unwrap();
    assert_eq!(can.wait_for(done, Polls(10_000)), Ok(Outcome::Sent));
    let first = can.send_through(0, &frame("100#1122334455667788")).unwrap();
    let second = can.send_through(0, &frame("101#")).unwrap();
    bench.sim.run_for(Time::from_us(40));
    can.abort(0);
    assert_eq!(can.outcome(first), Outcome::Pending, "it is on the bus");
    assert_eq!(can.send_through(0, &frame("102#")), Err(can_hal::SendError::Full));
    assert_eq!(can.wait_for(first, Polls(10_000)), Ok(Outcome::SentAnyway));
    assert_eq!(can.outcome(second), Outcome::Cancelled);
    assert_eq!(can.outcome(done), Outcome::Sent);
    let third = can.send_through(0, &frame("102#")).unwrap();
    assert_eq!(can.wait_for(third, Polls(10_000)), Ok(Outcome::Sent));
    assert_eq!(bench.seen(peer), ["0FF#", "100#1122334455667788", "102#"]);
    bench.finish();
}

/// Register 34-1: ABAT for all FIFOs at once.
#[test]
fn register_34_1_abort_all() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 2 }).fifo(3, Tx { elements: 2 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.peer_send(peer, frame("000#1122334455667788"));
    bench.sim.run_for(Time::from_us(20));
    let tickets =
        [(0, "100#"), (3, "101#"), (3, "102#")].map(|(fifo, text)| can.send_through(fifo, &frame(text)).unwrap());
    can.abort_all();
    assert_eq!(tickets.map(|ticket| can.outcome(ticket)), [Outcome::Cancelled; 3]);
    bench.sim.run_for(FRAME * 3);
    assert_eq!(bench.seen(peer), Vec::<String>::new());
    bench.finish();
}

/// 34.7.5, steps 1 to 5: transmit FIFO, filter, FSEL, RTREN, a preloaded message; the reply is there from the first request
/// on.
#[test]
fn section_34_7_5_remote_reply() {
    let bench = Bench::new();
    let (asking, other) = (bench.peer(), bench.peer());
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 1 }).fifo(1, Tx { elements: 2 });
    let id = Id::Standard(StandardId::new(0x321).unwrap());
    let (filters, fifos) = ([Filter::new(id, 1)], [TxFifo::new(1).replying()]);
    let mut can = bench.driver(&memory);
    can.configure(&Config::new(TIMING).with_filters([Mask::EXACT; 4], &filters).with_tx_fifos(&fifos)).unwrap();
    can.preload(1, &frame("321#01")).unwrap();
    can.preload(1, &frame("321#02")).unwrap();
    assert_eq!(can.preload(1, &frame("321#03")), Err(can_hal::SendError::Full));
    let mut can = can.start_normal(WAIT).unwrap();
    bench.send(asking, &["321#R1"]);
    bench.sim.run_for(FRAME * 2);
    assert_eq!(bench.seen(other), ["321#R1", "321#01", "321#02"], "every message in the FIFO");
    // What is sent otherwise does not go through the FIFO that answers.
    assert_eq!(can.send(&frame("100#")).unwrap().fifo(), 0);
    bench.finish();
}

/// 34.8.6, both lists of five steps: filters set up in the module's running state, the masks in Configuration mode.
#[test]
fn section_34_8_6_configuring_a_filter() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 8 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.send(peer, &["100#"]);
    assert_eq!(can.fetch(), Ok(None), "34.9: without filters nothing is received");
    bench.sim.trace(true);
    let standard = Filter::new(frame("100#").id(), 1);
    can.set_filter(4, &standard, WAIT).unwrap();
    let accesses = bench.accesses();
    let writes: Vec<u32> = accesses.iter().filter(|a| a.1).map(|a| a.3).collect();
    let (clear, set) = (0x0D4, 0x0D8);
    assert_eq!(writes, [clear, 0x180, clear, set, set], "off, identifier, selection, on; never the whole register");
    can.set_filter(9, &Filter::new(frame("12345678#").id(), 1).with_mask(3), WAIT).unwrap();
    bench.send(peer, &["100#", "101#", "12345678#", "12345679#"]);
    let mut seen = Vec::new();
    while let Some(message) = can.fetch().unwrap() {
        seen.push((message.frame.to_string(), message.filter));
    }
    assert_eq!(seen, [("100#".to_owned(), Some(4)), ("12345678#".to_owned(), Some(9))]);
    can.clear_filter(4, WAIT).unwrap();
    bench.send(peer, &["100#"]);
    assert_eq!(can.fetch(), Ok(None));
    bench.finish();
}

/// 34.9.2, steps 1 to 4: two words of a data-only message, four of a full one.
#[test]
fn section_34_9_2_processing_a_received_message() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, ReceiveData { elements: 3 }).fifo(1, Receive { elements: 2 });
    let filters = [Filter::new(frame("100#").id(), 0), Filter::any(1).with_mask(1)];
    let masks = [Mask::EXACT, Mask::ANY, Mask::ANY, Mask::ANY];
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(masks, &filters));
    bench.send(peer, &["100#0102", "100#1122334455667788", "200#33"]);
    assert_eq!(can.receive_data(0), Ok(Some([1, 2, 0, 0, 0, 0, 0, 0])));
    assert_eq!(can.registers().fifo(0).ua().read().bits(), 0x108);
    assert_eq!(can.receive_data(0), Ok(Some([0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88])));
    assert_eq!(can.receive_data(0), Ok(None));
    assert_eq!(can.receive_fifo(0), Ok(None), "there is no frame in it");
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("200#33"));
    bench.finish();
}

/// 34.14.3, steps 1 to 5: WAKIE, Disable mode, sleep, the interrupt, Normal mode; the message that woke the device is lost.
#[test]
fn section_34_14_3_sleep_and_wake_up() {
    let bench = Bench::new();
    let (sender, _other) = (bench.peer(), bench.peer());
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 4 });
    let filters = everything(1);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    let all = can.interrupts();
    can.clear(all);
    can.enable_interrupts(Interrupts::WAKE_UP);
    let mut asleep = can.sleep(WAIT).unwrap();
    bench.sim.act(bench.id, |model, cx| model.set_device_state(cx, DeviceState::Sleep));
    assert!(!asleep.was_woken());
    bench.sim.peer_send(sender, frame("100#"));
    assert!(bench.sim.run_until(FRAME, |sim| sim.line(bench.id, 0)).is_some());
    bench.sim.act(bench.id, |model, cx| model.set_device_state(cx, DeviceState::Run));
    assert_eq!(asleep.interrupt_code(), Some(InterruptCode::WakeUp));
    assert!(asleep.was_woken());
    asleep.clear_wake_up();
    let mut can = asleep.wake(WAIT).unwrap();
    bench.sim.run_for(FRAME);
    assert_eq!(can.fetch(), Ok(None));
    bench.send(sender, &["101#"]);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("101#"));
    bench.finish();
}
