//! FIFOs beyond the examples: figures of 34.7.6 and 34.9.3, tickets over many wraps, overflow, what is refused.

use can_hal::{
    Outcome, Overflow, Polls, Receive as _, SendError, Transmit,
    memory::Pic32CanFifo::{Receive, ReceiveData, Transmit as Tx},
    pic32_can::{Config, ConfigError, FifoFlags},
};

use crate::bench::{ANY, Bench, FRAME, TIMING, WAIT, everything, frame};

/// Figures 34-17 to 34-22: UA, CI, TXNFULLIF, TXHALFIF, TXEMPTYIF of FIFO1 with seven messages from 0x140 on.
#[test]
fn figures_34_17_to_34_22() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 }).fifo(1, Tx { elements: 7 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    let shown = |can: &crate::bench::Driver<'_, can_hal::mode::Running>| {
        let fifo = can.registers().fifo(1);
        let flags = can.fifo_flags(1);
        let address = fifo.ua().read().bits();
        (address, fifo.ci().read().fifoci(), flags.txnfullif(), flags.txhalfif(), flags.txemptyif())
    };
    assert_eq!(shown(&can), (0x140, 0, true, true, true));
    let first = can.send_through(1, &frame("100#00")).unwrap();
    assert_eq!(shown(&can), (0x150, 0, true, true, false));
    assert_eq!(can.outcome(first), Outcome::Pending);
    bench.sim.run_for(FRAME);
    assert_eq!(shown(&can), (0x150, 1, true, true, true));
    assert_eq!(can.outcome(first), Outcome::Sent);
    let mut tickets = Vec::new();
    for n in 1..7 {
        tickets.push(can.load(1, &frame(&format!("100#0{n}"))).unwrap());
    }
    assert_eq!(shown(&can), (0x140, 1, true, false, false));
    tickets.push(can.send_through(1, &frame("100#07")).unwrap());
    assert_eq!(shown(&can), (0x150, 1, false, false, false));
    assert_eq!(can.send_through(1, &frame("100#08")), Err(SendError::Full));
    assert!(
        tickets.iter().all(|ticket| can.outcome(*ticket) == Outcome::Pending),
        "a full FIFO has the head at the index"
    );
    bench.sim.run_for(FRAME * 8);
    assert_eq!(shown(&can), (0x150, 1, true, true, true));
    assert!(tickets.iter().all(|ticket| can.outcome(*ticket) == Outcome::Sent));
    assert_eq!(bench.seen(peer).len(), 8);
    bench.finish();
}

/// Figures 34-30 to 34-36: seven messages at 0x100; the ninth is lost, which is told once.
#[test]
fn figures_34_30_to_34_36() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 7 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    bench.send(peer, &["100#", "101#", "102#", "103#", "104#", "105#"]);
    assert_eq!(can.receive_fifo(0).unwrap().unwrap().frame, frame("100#"));
    assert_eq!(can.registers().fifo(0).ua().read().bits(), 0x110);
    bench.send(peer, &["106#", "107#", "108#"]);
    assert!(can.fifo_flags(0).contains(FifoFlags::RXOVFLIF | FifoFlags::RXFULLIF));
    assert_eq!(can.receive_fifo(0), Err(Overflow { fifo: 0 }));
    let mut rest = Vec::new();
    while let Some(message) = can.receive_fifo(0).unwrap() {
        rest.push(message.frame.to_string());
    }
    assert_eq!(rest, ["101#", "102#", "103#", "104#", "105#", "106#", "107#"]);
    bench.finish();
}

/// An overflow of a data-only FIFO is told as well.
#[test]
fn overflow_of_a_data_only_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, ReceiveData { elements: 1 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    bench.send(peer, &["100#01", "101#02"]);
    assert_eq!(can.receive_data(0), Err(Overflow { fifo: 0 }));
    assert_eq!(can.receive_data(0), Ok(Some([1, 0, 0, 0, 0, 0, 0, 0])));
    assert_eq!(can.receive_data(0), Ok(None));
    bench.finish();
}

/// Tickets stay right while a FIFO wraps again and again, for every depth.
#[test]
fn tickets_over_many_wraps() {
    for depth in [1, 2, 3, 32] {
        let bench = Bench::new();
        let peer = bench.peer();
        let memory = bench.memory(0x100).fifo(0, Tx { elements: depth });
        let mut can = bench.running(&memory, &Config::new(TIMING));
        let mut sent = Vec::new();
        for n in 0..100_u8 {
            let text = format!("{:03X}#{n:02X}", 0x100 + u16::from(n));
            let ticket = loop {
                match can.send(&frame(&text)) {
                    Ok(ticket) => break ticket,
                    Err(error) => assert_eq!(error, SendError::Full),
                }
            };
            sent.push((text, ticket));
            if n % 7 == 0 {
                let before = bench.sim.peer_received(peer).len();
                let done = sent.iter().filter(|(_, ticket)| can.outcome(*ticket) == Outcome::Sent).count();
                let after = bench.sim.peer_received(peer).len();
                assert!((before..=after).contains(&done), "{done} of {before} to {after}, depth {depth}");
            }
        }
        let last = sent.last().unwrap().1;
        assert_eq!(can.wait_for(last, Polls(100_000)), Ok(Outcome::Sent));
        let texts: Vec<String> = sent.into_iter().map(|(text, _)| text).collect();
        assert_eq!(bench.seen(peer), texts);
        bench.finish();
    }
}

/// A cancelled frame leaves the tickets of other FIFOs, and of later frames, alone.
#[test]
fn cancelling_in_one_of_two_fifos() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 3 }).fifo(1, Tx { elements: 3 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.peer_send(peer, frame("000#1122334455667788"));
    bench.sim.run_for(can_sim::Time::from_us(20));
    let kept = can.send_through(0, &frame("200#")).unwrap();
    let dropped = can.send_through(1, &frame("100#")).unwrap();
    can.cancel(dropped);
    assert_eq!(can.wait_for(dropped, Polls(100)), Ok(Outcome::Cancelled));
    let later = can.send_through(1, &frame("300#")).unwrap();
    assert_eq!(can.wait_for(kept, Polls(10_000)), Ok(Outcome::Sent));
    assert_eq!(can.wait_for(later, Polls(10_000)), Ok(Outcome::Sent));
    assert_eq!(can.outcome(dropped), Outcome::Cancelled);
    can.cancel(later);
    assert_eq!(can.outcome(later), Outcome::Sent, "there was nothing to cancel");
    assert_eq!(bench.seen(peer), ["300#", "200#"]);
    bench.finish();
}

/// FIFOs that the plan does not have, and frames that the module does not know.
#[test]
fn refused() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 1 }).fifo(2, Tx { elements: 1 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    for fifo in [0, 1, 31, 32, 255] {
        assert_eq!(can.send_through(fifo, &frame("100#")), Err(SendError::NoSuchBuffer { buffer: fifo, count: 1 }));
        can.abort(fifo);
        can.request(fifo);
    }
    assert_eq!(can.send_through(2, &frame("100##0")), Err(SendError::FdDisabled));
    assert_eq!((can.receive_fifo(2), can.receive_data(0), can.receive_fifo(77)), (Ok(None), Ok(None), Ok(None)));
    assert_eq!(can.fetch(), Ok(None));
    bench.finish();
}

/// A plan that does not lie in the memory that the driver was given.
#[test]
#[allow(unsafe_code, reason = "a simulated memory of its own")]
fn plan_outside_the_region() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    // SAFETY: nothing else uses this memory.
    let region = unsafe { can_hal::Region::new(bench.sim.memory(bench.ram), 0x100, 0x30) };
    let refused = can_hal::pic32_can::Can::new(bench.sim.registers(bench.id), region, &memory.plan().unwrap(), WAIT);
    let Err(ConfigError::OutsideRegion(placed)) = refused else { panic!("a FIFO reaches behind the region") };
    assert_eq!((placed.start, placed.end()), (0x100, 0x140));
    let text = ConfigError::OutsideRegion(placed).to_string();
    assert!(text.contains("fifo 0 from 0x100 to 0x140"), "{text}");
}
