//! Chapters 6 and 7: sending, priorities, attempts, aborts, replies, events.

use can_hal::{
    FdCan, Outcome, Overflow, Polls, SendError, StandardId, Transmit,
    dspic33_canfd::{Attempts, BandwidthSharing, Config, FdMode, Filter, Reply, Sequence, TxOptions},
};
use can_sim::Time;
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use dspic33_canfd_pac::registers::FifoConL;

use crate::bench::{Bench, CONFIG, FRAME, MODE, PLAN, frame};

const PLAIN: TxOptions = TxOptions { sequence: Sequence::MAX };

/// 6.2, 6.4: room is checked, the object written where the user address points, UINC and TXREQ set in one write; nothing
/// else of the control register changes.
#[test]
fn section_6_4_loading_and_requesting() {
    let bench = Bench::new();
    let _peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    bench.sim.trace(true);
    can.send_fifo(3, &frame("123#01"), PLAIN).unwrap();
    let written = bench.written("FIFOCONL[3]");
    let expected = FifoConL::TXEN | FifoConL::TXATIE | FifoConL::UINC | FifoConL::TXREQ;
    assert_eq!(written, [u32::from(expected.bits())]);
    bench.finish();
}

/// 6.4: messages are appended while the FIFO transmits, for as long as one likes; none is left behind.
#[test]
fn section_6_4_appending_while_transmitting() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let mut expected = Vec::new();
    let mut tickets = Vec::new();
    while expected.len() < 300 {
        let text = format!("{:03X}#{:02X}", 0x100 + expected.len(), expected.len() % 256);
        match can.send_fifo(3, &frame(&text), PLAIN) {
            Ok(ticket) => {
                tickets.push(ticket);
                expected.push(text);
            }
            Err(error) => assert_eq!(error, SendError::Full),
        }
        if tickets.len() > 4 {
            assert_eq!(can.outcome(tickets.remove(0)), Outcome::Sent);
        }
    }
    for ticket in tickets {
        assert_eq!(can.wait_for(ticket, MODE), Ok(Outcome::Sent));
    }
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), expected);
    bench.finish();
}

/// 6.7: by priority, then the queue, then the highest FIFO; in the queue by identifier.
#[test]
fn section_6_7_priorities() {
    for (priorities, expected) in [
        (&[][..], ["101#", "102#", "401#", "301#"]),
        (&[(3, 1)][..], ["301#", "101#", "102#", "401#"]),
        (&[(4, 9), (3, 8)][..], ["401#", "301#", "101#", "102#"]),
    ] {
        let bench = Bench::new();
        let peer = bench.peer();
        let mut can = bench.running(&Config { priorities, ..CONFIG });
        bench.busy(peer);
        can.send_fifo(3, &frame("301#"), PLAIN).unwrap();
        can.send_fifo(4, &frame("401#"), PLAIN).unwrap();
        can.send_queued(&frame("102#"), PLAIN).unwrap();
        can.send_queued(&frame("101#"), PLAIN).unwrap();
        bench.sim.run_for(FRAME * 5);
        assert_eq!(bench.seen(peer), expected);
        bench.finish();
    }
}

/// 6.8: others get their turn between own messages.
#[test]
fn section_6_8_bandwidth_sharing() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&Config { bandwidth_sharing: BandwidthSharing::BitTimes1024, ..CONFIG });
    let first = can.send_fifo(3, &frame("101#"), PLAIN).unwrap();
    let second = can.send_fifo(3, &frame("102#"), PLAIN).unwrap();
    can.wait_for(first, MODE).unwrap();
    bench.sim.run_for(Time::from_us(1_000));
    assert_eq!(can.outcome(second), Outcome::Pending);
    bench.sim.run_for(FRAME);
    assert_eq!(can.outcome(second), Outcome::Sent);
    assert_eq!(bench.seen(peer), ["101#", "102#"]);
    bench.finish();
}

fn spoil(bench: &Bench, count: u32) {
    let node = bench.sim.node(bench.id);
    let (fault, position) = (BitFault::InvertSeen, Position::new(Field::Crc, 3));
    let frames = Frames { sender: Some(node), skip: 0, count };
    bench.sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault, position, frames }));
}

/// 6.9: none, three, unlimited; for all, or for one FIFO.
#[test]
fn section_6_9_retransmission_attempts() {
    for (attempts, spoilt, outcome) in [
        (Attempts::None, 1, Outcome::Failed),
        (Attempts::Three, 3, Outcome::Sent),
        (Attempts::Three, 4, Outcome::Failed),
        (Attempts::Unlimited, 8, Outcome::Sent),
    ] {
        let bench = Bench::new();
        let peer = bench.peer();
        let mut can = bench.running(&Config { attempts, ..CONFIG });
        spoil(&bench, spoilt);
        let ticket = can.send_fifo(3, &frame("101#11"), PLAIN).unwrap();
        assert_eq!(can.wait_for(ticket, MODE), Ok(outcome), "{attempts:?}, {spoilt}");
        // The failed message is out of the way.
        let next = can.send_fifo(3, &frame("102#"), PLAIN).unwrap();
        assert_eq!(can.wait_for(next, MODE), Ok(Outcome::Sent));
        assert_eq!(can.outcome(ticket), outcome);
        assert_eq!(bench.seen(peer).len(), if outcome == Outcome::Sent { 2 } else { 1 });
        bench.finish();
    }
    let bench = Bench::new();
    let _peer = bench.peer();
    let mut can = bench.running(&Config { restrict_attempts: true, ..CONFIG });
    assert!(can.set_attempts(4, Attempts::None) && !can.set_attempts(1, Attempts::None));
    assert!(can.set_attempts(0, Attempts::Three));
    spoil(&bench, 2);
    let one = can.send_fifo(4, &frame("101#11"), PLAIN).unwrap();
    assert_eq!(can.wait_for(one, MODE), Ok(Outcome::Failed));
    let many = can.send_fifo(3, &frame("102#11"), PLAIN).unwrap();
    assert_eq!(can.wait_for(many, MODE), Ok(Outcome::Sent));
    bench.finish();
}

/// 6.10: aborting a FIFO concerns all that is in it; what is on the bus is sent.
#[test]
fn section_6_10_aborting_a_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let tickets = ["101#0011223344556677", "102#", "103#"].map(|text| can.send_fifo(3, &frame(text), PLAIN).unwrap());
    let other = can.send_fifo(4, &frame("401#"), PLAIN).unwrap();
    bench.sim.run_for(Time::from_us(20));
    can.cancel(tickets[2]);
    assert_eq!(can.send_fifo(3, &frame("104#"), PLAIN), Err(SendError::Full), "not while it is being cancelled");
    assert_eq!(can.wait_for(tickets[2], MODE), Ok(Outcome::Cancelled));
    assert_eq!((can.outcome(tickets[0]), can.outcome(tickets[1])), (Outcome::SentAnyway, Outcome::Cancelled));
    assert_eq!(can.wait_for(other, MODE), Ok(Outcome::Sent));
    let next = can.send_fifo(3, &frame("105#"), PLAIN).unwrap();
    assert_eq!(can.wait_for(next, MODE), Ok(Outcome::Sent));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), ["101#0011223344556677", "401#", "105#"]);
    bench.finish();
}

/// 6.10: ABAT, wait for the requests to end, clear ABAT; then new messages can be sent.
#[test]
fn section_6_10_abort_all() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    bench.busy(peer);
    let tickets = [
        can.send_queued(&frame("101#"), PLAIN).unwrap(),
        can.send_fifo(3, &frame("301#"), PLAIN).unwrap(),
        can.send_fifo(4, &frame("401#"), PLAIN).unwrap(),
    ];
    can.abort_all(Polls(1_000)).unwrap();
    assert_eq!(tickets.map(|ticket| can.outcome(ticket)), [Outcome::Cancelled; 3]);
    let next = can.send_queued(&frame("102#"), PLAIN).unwrap();
    assert_eq!(can.wait_for(next, MODE), Ok(Outcome::Sent));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), ["102#"]);
    bench.finish();
}

/// 6.11: a remote frame is answered without software; the reply can be armed again and changed.
#[test]
fn section_6_11_remote_transmit_request() {
    let bench = Bench::new();
    let (asking, other) = (bench.peer(), bench.peer());
    let filters = [Filter::standard(StandardId::new(0x321).unwrap(), 5), Filter::any(1)];
    let replies = [Reply { fifo: 5, frame: frame("321#0102") }];
    let mut can = bench.running(&Config { replies: &replies, ..CONFIG.with_filters(&filters) });
    let answers = || bench.seen(other).into_iter().filter(|text| !text.contains('R')).collect::<Vec<_>>();
    assert_eq!(can.arm_replies(), 0, "it is armed by the start");
    bench.send(asking, &["321#R2", "321#R2"]);
    assert_eq!(answers(), ["321#0102"], "armed once");
    assert_eq!(can.arm_replies(), 1 << 5);
    bench.send(asking, &["321#R2"]);
    can.set_reply(5, &frame("321#AABB")).unwrap();
    bench.send(asking, &["321#R2"]);
    assert_eq!(answers(), ["321#0102", "321#0102", "321#AABB"]);
    assert!(can.set_reply(3, &frame("321#")).is_err() && can.send_fifo(5, &frame("100#"), PLAIN).is_err());
    bench.finish();
}

/// 6.12: what the module would not send is refused before.
#[test]
fn section_6_12_dlc_above_the_payload_size() {
    let bench = Bench::new();
    let _peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let long = frame("101##1000102030405060708090A0B");
    assert_eq!(can.send_fifo(4, &long, PLAIN), Err(SendError::TooLong { len: 12, room: 8 }));
    assert!(can.send_fifo(3, &long, PLAIN).is_ok());
    assert_eq!(can.send_fifo(1, &long, PLAIN), Err(SendError::NoSuchBuffer { buffer: 1, count: 4 }));
    assert_eq!((can.max_data_len(), can.data_len(4), can.data_len(200)), (64, 8, 0));
    bench.finish();
}

/// 4.3.1, Register 3-1: frames that the configuration does not allow.
#[test]
fn section_4_3_frame_formats() {
    let bench = Bench::new();
    let mut can = bench.configured(&PLAN, &CONFIG);
    can.configure(&Config { fd: FdMode::Fd { bit_rate_switch: false, non_iso: false }, ..CONFIG }).unwrap();
    let mut can = can.start_normal(MODE).unwrap();
    assert_eq!(can.send(&frame("101##100")), Err(SendError::BitRateSwitchDisabled));
    assert!(can.send(&frame("101##000")).is_ok());
    bench.finish();
}

/// 7.1, 12.1.6: events are read at the user address; lost ones are told once.
#[test]
fn section_7_1_events_and_their_overrun() {
    let bench = Bench::new();
    let _peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    for number in 0..6 {
        let options = TxOptions { sequence: Sequence::new(0x1_0000 + number).unwrap() };
        let ticket = can.send_queued(&frame("12345678#R"), options).unwrap();
        can.wait_for(ticket, MODE).unwrap();
    }
    bench.sim.run_for(FRAME);
    assert_eq!(can.tx_event(), Err(Overflow { fifo: 0 }));
    let events: Vec<_> = core::iter::from_fn(|| can.tx_event().unwrap()).collect();
    let sequences: Vec<u32> = events.iter().map(|event| event.sequence).collect();
    assert_eq!(sequences, [0x1_0000, 0x1_0001, 0x1_0002, 0x1_0003]);
    assert_eq!((events[0].id, events[0].format), (frame("12345678#R").id(), frame("12345678#R").format()));
    bench.finish();
}

/// 5.2.5: a gateway passes the error state of the sender on.
#[test]
fn section_5_2_5_gateway() {
    for gateway in [false, true] {
        let bench = Bench::new();
        let peer = bench.sim.add_peer(NodeConfig::new()).unwrap();
        bench.sim.run_for(FRAME);
        let mut can = bench.running(&Config { gateway_esi: gateway, ..CONFIG });
        can.send(&frame("101##200").with_error_state_indicator(true)).unwrap();
        bench.sim.run_for(FRAME);
        assert_eq!(bench.sim.peer_received(peer)[0].1.error_state_indicator(), gateway);
        bench.finish();
    }
}

/// The trait for FD frames.
#[test]
fn the_trait_for_fd_frames() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG);
    let id = StandardId::new(0x123).unwrap().into();
    can.transmit_fd(id, &[1, 2, 3, 4, 5, 6, 7, 8, 9], true).unwrap();
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), ["123##1010203040506070809000000"]);
    bench.finish();
}
