//! Sending.

use can_hal::{Capabilities, Configured, FdFlags, Frame, Id, Outcome, Polls, Receive, SendError, StandardId, Transmit};
use can_sim::Sim;

use crate::bench::{Bench, FRAME, Setup, drain, frame, kinds, peer, send_and_wait, start};

const fn capabilities<B: Bench>() -> Capabilities {
    <B::Can<'static> as Configured>::CAPABILITIES
}

pub fn every_kind_comes_back_in_loop_back<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let fd = capabilities::<B>().fd;
    let can = bench.set_up(&sim, &Setup { fd, ..Setup::CLASSIC });
    let mut can = can.start_loop_back(Polls(B::MODE_POLLS)).unwrap_or_else(|_| panic!("{:?}", sim.diagnostics()));
    sim.run_for(FRAME);
    for frame in kinds(fd) {
        assert_eq!(send_and_wait(&mut can, &frame), Outcome::Sent, "{frame}");
        sim.run_for(FRAME);
        let received: Vec<Frame> = drain(&mut can).iter().map(|message| message.frame).collect();
        assert_eq!(received, [frame]);
    }
    assert_eq!(sim.peer_received(other), [], "nothing reaches the bus");
    assert_eq!(sim.diagnostics(), []);
}

pub fn every_kind_is_exchanged<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let fd = capabilities::<B>().fd;
    let mut can = start(bench, &sim, &Setup { fd, ..Setup::CLASSIC });
    for frame in kinds(fd) {
        assert_eq!(send_and_wait(&mut can, &frame), Outcome::Sent, "{frame}");
        sim.peer_send(other, frame);
        sim.run_for(FRAME);
        let received: Vec<Frame> = drain(&mut can).iter().map(|message| message.frame).collect();
        assert_eq!(received, [frame]);
    }
    let seen: Vec<Frame> = sim.peer_received(other).iter().map(|(_, frame)| *frame).collect();
    assert_eq!(seen, kinds(fd));
    assert_eq!(sim.diagnostics(), []);
}

pub fn fd_frames_are_refused_where_they_cannot_be_sent<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let flags = FdFlags { brs: false, esi: false };
    let short = Frame::fd(StandardId::ZERO, &[1, 2, 3], flags).unwrap();
    assert_eq!(can.send(&short), Err(SendError::FdDisabled));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(other), []);
}

pub fn the_order_is_that_of_the_calls_or_of_the_identifiers<B: Bench>() {
    for by_id in [false, true] {
        if by_id && !capabilities::<B>().priority_by_id {
            continue;
        }
        let sim = Sim::new();
        let bench = B::add(&sim, "can0");
        let other = peer(&sim);
        let mut can = start(bench, &sim, &Setup { by_id, ..Setup::CLASSIC });
        let keep_busy = frame("000#0000000000000000");
        sim.peer_send(other, keep_busy);
        sim.run_for(can_sim::Time::from_us(20));
        let mut texts = vec!["300#00", "100#01", "200#02"];
        assert!(B::TX_DEPTH >= texts.len(), "the bench has too short a queue");
        for text in &texts {
            can.send(&frame(text)).unwrap();
        }
        sim.run_for(FRAME);
        if by_id {
            texts.sort_unstable();
        }
        let seen: Vec<String> = sim.peer_received(other).iter().map(|(_, frame)| frame.to_string()).collect();
        assert_eq!(seen, texts, "by identifier: {by_id}");
        assert_eq!(sim.diagnostics(), []);
    }
}

pub fn a_full_queue_says_so<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    // Nobody acknowledges: nothing leaves the queue.
    let mut sent = Vec::new();
    let error = loop {
        let id = StandardId::new(sent.len() as u16).unwrap();
        match can.send(&Frame::data(id, &[]).unwrap()) {
            Ok(ticket) => sent.push(ticket),
            Err(error) => break error,
        }
    };
    assert_eq!((sent.len(), error), (B::TX_DEPTH, SendError::Full));
    assert_eq!(can.outcome(sent[0]), Outcome::Pending);
    let other = peer(&sim);
    sim.run_for(FRAME * 4);
    assert_eq!(sim.peer_received(other).len(), B::TX_DEPTH);
    assert!(can.send(&frame("7FF#")).is_ok(), "there is room again");
    assert_eq!(sim.diagnostics(), []);
}

pub fn a_frame_that_waits_can_be_cancelled<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    sim.peer_send(other, frame("000#0000000000000000"));
    sim.run_for(can_sim::Time::from_us(20));
    let ticket = can.send(&frame("123#01")).unwrap();
    assert_eq!(can.outcome(ticket), Outcome::Pending);
    can.cancel(ticket);
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Cancelled));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_received(other), []);
    // The place can be used again.
    assert_eq!(send_and_wait(&mut can, &frame("124#02")), Outcome::Sent);
    assert_eq!(sim.diagnostics(), []);
}

pub fn a_cancellation_can_come_too_late<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    let ticket = can.send(&frame("123#0102030405060708")).unwrap();
    sim.run_for(can_sim::Time::from_us(30));
    can.cancel(ticket);
    let outcome = can.wait_for(ticket, Polls(10_000)).unwrap();
    assert_eq!(outcome, if B::TELLS_SENT_ANYWAY { Outcome::SentAnyway } else { Outcome::Sent });
    assert_eq!(sim.peer_received(other).len(), 1);
    assert_eq!(sim.diagnostics(), []);
}

pub fn one_shot<B: Bench>() {
    let supported = capabilities::<B>().one_shot;
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let mut can = start(bench, &sim, &Setup { one_shot: supported, ..Setup::CLASSIC });
    // Nobody acknowledges.
    let ticket = can.send(&frame("123#01")).unwrap();
    sim.run_for(FRAME);
    let expected = if supported { Outcome::Failed } else { Outcome::Pending };
    assert_eq!(can.outcome(ticket), expected);
    let node = bench.node(&sim);
    let (transmit, _) = sim.with_wire(|wire| wire.error_counters(node));
    assert_eq!(transmit == 8, supported, "one attempt without acknowledge adds 8 to TEC: {transmit}");
}

pub fn a_remote_request_is_answered_or_received<B: Bench>() {
    let supported = capabilities::<B>().remote_reply;
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let (asking, other) = (peer(&sim), peer(&sim));
    let reply = frame("321#0102");
    let mut can = start(bench, &sim, &Setup { reply: supported.then_some(reply), ..Setup::CLASSIC });
    sim.peer_send(asking, frame("321#R2"));
    sim.run_for(FRAME);
    let answers = sim.peer_received(other).iter().filter(|(_, frame)| *frame == reply).count();
    let received = drain(&mut can).len();
    assert_eq!((answers, received), if supported { (1, 0) } else { (0, 1) });
    assert_eq!(sim.diagnostics(), []);
}

/// A driver that knows no controller.
fn ask<C>(can: &mut C, request: &Frame) -> Result<Option<Frame>, <C as embedded_can::nb::Can>::Error>
where
    C: embedded_can::nb::Can<Frame = can_hal::Frame> + embedded_can::blocking::Can<Frame = can_hal::Frame>,
{
    if embedded_can::nb::Can::transmit(can, request).is_err() {
        return Ok(None);
    }
    for _ in 0..10_000 {
        match embedded_can::nb::Can::receive(can) {
            Ok(frame) => return Ok(Some(frame)),
            Err(nb::Error::WouldBlock) => {}
            Err(nb::Error::Other(error)) => return Err(error),
        }
    }
    Ok(None)
}

pub fn the_embedded_can_traits<B: Bench>()
where
    for<'a> crate::bench::Running<'a, B>: embedded_can::nb::Can<Frame = Frame, Error = can_hal::Error>
        + embedded_can::blocking::Can<Frame = Frame, Error = can_hal::Error>,
{
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    sim.peer_send(other, frame("456#AA"));
    assert_eq!(ask(&mut can, &frame("123#01")), Ok(Some(frame("456#AA"))));
    let id = Id::Standard(StandardId::new(0x7F0).unwrap());
    let second = Frame::data(id, &[1, 2]).unwrap();
    embedded_can::blocking::Can::transmit(&mut can, &second).unwrap();
    sim.run_for(FRAME);
    let seen: Vec<Frame> = sim.peer_received(other).iter().map(|(_, frame)| *frame).collect();
    assert_eq!(seen, [frame("123#01"), second]);
    // The bound of blocking calls.
    assert_eq!(embedded_can::blocking::Can::receive(&mut can), Err(can_hal::Error::TimedOut));
    assert_eq!(can.fetch(), Ok(None));
}
