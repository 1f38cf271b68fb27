//! Timestamps.

use can_hal::{Receive, TimestampExtender};
use can_sim::{Sim, Time};

use crate::bench::{Bench, FRAME, Setup, frame, peer, start};

pub fn they_grow_across_the_wrap<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let sender = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    if B::EXPECTED.timestamp_bits == 0 {
        sim.peer_send(sender, frame("123#"));
        sim.run_for(FRAME);
        assert_eq!(can.fetch().unwrap().unwrap().timestamp, None);
        return assert_eq!(can.timestamp(), None);
    }
    assert!([16, 32].contains(&B::EXPECTED.timestamp_bits));
    // Two wraps of a 16-bit counter; a 32-bit one is followed for as long.
    let steps = 150;
    let step = Time::from_ps(B::TIMESTAMP_UNIT.as_ps() * 1_000);
    let (mut short, mut long) = (TimestampExtender::<16>::new(), TimestampExtender::<32>::new());
    let mut stamps = Vec::new();
    for _ in 0..steps {
        sim.peer_send(sender, frame("123#0102"));
        let sent = sim.now();
        sim.run_for(step);
        let message = can.fetch().unwrap().unwrap();
        let stamp = message.timestamp.unwrap();
        let time = if B::EXPECTED.timestamp_bits == 16 {
            assert!(stamp < 1 << 16);
            short.extend(stamp)
        } else {
            long.extend(stamp)
        };
        stamps.push((sent, time));
    }
    let (first_sent, first) = stamps[0];
    for (sent, time) in stamps {
        let expected = sent.since(first_sent).as_ps() / B::TIMESTAMP_UNIT.as_ps();
        assert!((time - first).abs_diff(expected) <= 50, "{time} after {first}, sent {expected} units later");
    }
    assert_eq!(sim.diagnostics(), []);
}
