//! Controllers of different kinds on one bus.
#![allow(
    clippy::unwrap_used,
    dead_code,
    reason = "the benches of the controllers' own tests, of which this uses a part"
)]

mod classic;
mod fd;

#[path = "../dspic33_canfd/bench.rs"]
mod canfd;
#[path = "../dspic33_ecan/bench.rs"]
mod ecan;
#[path = "../m_can/bench.rs"]
mod m_can;
#[path = "../pic32_can/bench.rs"]
mod pic32;

use std::collections::VecDeque;

use can_frame::Frame;
use can_sim::{BusEntry, Sim};
use can_wire::{Field, Role};

/// What a receiver has had of one sender.
#[derive(Default)]
struct Inbox {
    last: Option<Frame>,
    /// Messages that came again at once.
    twice: usize,
}

impl Inbox {
    /// Takes the next message: the one that is expected, or the one before once more.
    fn take(&mut self, frame: Frame, expected: &mut VecDeque<Frame>) -> bool {
        let next = expected.front() == Some(&frame);
        if next {
            expected.pop_front();
            self.last = Some(frame);
        } else {
            assert_eq!(Some(frame), self.last, "expected is {:?}", expected.front());
            self.twice += 1;
        }
        next
    }
}

/// ISO 11898-1:2015, 10.7: receivers take a message at the last but one bit of EOF. A transmitter that sees an error in this
/// bit or in the last one sends again. Only then does a message come twice.
fn errors_after_acceptance(sim: &Sim) -> usize {
    let late = |entry: &BusEntry| match entry {
        BusEntry::Error { error, .. } => {
            error.position.field == Field::Eof && error.position.bit >= 5 && error.role == Role::Transmitter
        }
        _ => false,
    };
    sim.bus_log().iter().filter(|entry| late(entry)).count()
}

/// Where a bit error turns FDF and the bit behind it recessive, a node that knows the protocol exception waits for the bus to
/// become idle without a sign, and misses the message. Without it the node signals an error and the message comes again.
fn no_exception(sim: &Sim, can: canfd::Can) {
    let con = can.regs(sim).con_l();
    con.write(con.read().with_pxedis(dspic33_canfd_pac::enums::ConLPxedis::FormError));
}
