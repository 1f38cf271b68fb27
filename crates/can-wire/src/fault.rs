//! Faults as inputs: what can be done to the bits of a node and to the bus.

use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

use crate::{Field, NodeId, Position, Time};

/// Which frames a fault meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Frames {
    /// Only frames that this node sends; `None` for every frame that the victim sees start.
    pub sender: Option<NodeId>,
    /// How many of these are let pass first.
    pub skip: u32,
    /// How many are then hit.
    pub count: u32,
}

impl Frames {
    /// The next frame on the bus.
    #[must_use]
    pub const fn next() -> Frames {
        Frames { sender: None, skip: 0, count: 1 }
    }

    /// The next frame that `node` starts to send.
    #[must_use]
    pub const fn next_of(node: NodeId) -> Frames {
        Frames { sender: Some(node), skip: 0, count: 1 }
    }

    /// Every frame from now on.
    #[must_use]
    pub const fn all() -> Frames {
        Frames { sender: None, skip: 0, count: u32::MAX }
    }

    /// Every frame that `node` sends from now on.
    #[must_use]
    pub const fn all_of(node: NodeId) -> Frames {
        Frames { sender: Some(node), skip: 0, count: u32::MAX }
    }

    /// The same, letting `skip` frames pass first.
    #[must_use]
    pub const fn after(mut self, skip: u32) -> Frames {
        self.skip = skip;
        self
    }
}

/// What a fault does to one bit of one node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BitFault {
    /// The node samples the opposite of the level at its input. The edges that synchronize it stay as they are; for a
    /// disturbance that moves edges too, use [`Fault::Disturb`].
    InvertSeen,
    /// The opposite of what the node sends leaves its output, for this bit.
    InvertDriven,
    /// Nothing dominant leaves the node's output in this bit. In the ACK slot: its acknowledgement is lost.
    SilenceDriven,
}

/// A line that a disturbance acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Line {
    /// The bus.
    Bus,
    /// The transmit output of a node.
    Tx(NodeId),
    /// The receive input of a node.
    Rx(NodeId),
}

/// What a disturbance does to a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Disturbance {
    /// Held dominant: a short, or a stuck output.
    Dominant,
    /// Held recessive.
    Recessive,
    /// Inverted.
    Inverted,
}

impl Disturbance {
    fn apply(self, level: bool) -> bool {
        match self {
            Disturbance::Dominant => false,
            Disturbance::Recessive => true,
            Disturbance::Inverted => !level,
        }
    }
}

/// A fault to inject with [`crate::Wire::inject`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// One bit, named by its place in a frame.
    Bit {
        /// The victim.
        node: NodeId,
        /// What happens to the bit.
        fault: BitFault,
        /// The bit, as the victim counts it. Bits of error flags and of the time between frames belong to the frame
        /// before them.
        position: Position,
        /// In which frames.
        frames: Frames,
    },
    /// The victim's acknowledgement does not reach the bus.
    DropAck {
        /// The victim.
        node: NodeId,
        /// In which frames.
        frames: Frames,
    },
    /// A line is held or inverted for a while.
    Disturb {
        /// The line.
        line: Line,
        /// What happens to it.
        how: Disturbance,
        /// Start.
        from: Time,
        /// End.
        until: Time,
    },
    /// A node is cut off from the bus in both directions for a while.
    Cut {
        /// The victim.
        node: NodeId,
        /// Start.
        from: Time,
        /// End.
        until: Time,
    },
}

/// A fault that waits for its bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BitFaultAt {
    pub(crate) node: NodeId,
    pub(crate) fault: BitFault,
    pub(crate) position: Position,
    pub(crate) sender: Option<NodeId>,
    /// Ordinals of the first frame that is hit and of the first that is not any more.
    pub(crate) first: u64,
    pub(crate) end: u64,
}

impl BitFaultAt {
    /// `started` frames have begun so far.
    pub(crate) fn new(node: NodeId, fault: BitFault, position: Position, frames: Frames, started: u64) -> BitFaultAt {
        let first = started + 1 + u64::from(frames.skip);
        BitFaultAt { node, fault, position, sender: frames.sender, first, end: first + u64::from(frames.count) }
    }

    pub(crate) fn drop_ack(node: NodeId, frames: Frames, started: u64) -> BitFaultAt {
        BitFaultAt::new(node, BitFault::SilenceDriven, Position::new(Field::AckSlot, 0), frames, started)
    }
}

/// A change of the lines at a point in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Timed {
    pub(crate) at: u64,
    /// Order of injection; the later fault wins while two overlap.
    pub(crate) id: u32,
    pub(crate) begins: bool,
}

/// The disturbances that act on one line, in the order in which they began.
#[derive(Clone, Debug, Default)]
pub(crate) struct Disturbances(Vec<(u32, Disturbance)>);

impl Disturbances {
    pub(crate) fn set(&mut self, id: u32, how: Option<Disturbance>) {
        self.0.retain(|(other, _)| *other != id);
        if let Some(how) = how {
            self.0.push((id, how));
        }
    }

    #[inline]
    pub(crate) fn apply(&self, level: bool) -> bool {
        match self.0.last() {
            None => level,
            Some((_, how)) => how.apply(level),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }
}

/// What acts on one node now.
#[derive(Clone, Debug, Default)]
pub(crate) struct NodeFaults {
    pub(crate) rx: Disturbances,
    pub(crate) tx: Disturbances,
    pub(crate) noise: Option<Box<Noise>>,
    /// The bit sampled next is inverted.
    invert_seen: bool,
    driven: Option<BitFault>,
    driven_next: Option<BitFault>,
}

impl NodeFaults {
    #[inline]
    pub(crate) fn received(&self, level: bool) -> bool {
        self.rx.apply(level)
    }

    /// What leaves the output when the node sends `level`.
    #[inline]
    pub(crate) fn driven(&self, level: bool) -> bool {
        let level = match self.driven {
            Some(BitFault::InvertDriven) => !level,
            Some(BitFault::SilenceDriven) => true,
            _ => level,
        };
        self.tx.apply(level)
    }

    pub(crate) fn arm(&mut self, fault: BitFault) {
        match fault {
            BitFault::InvertSeen => self.invert_seen = !self.invert_seen,
            BitFault::InvertDriven | BitFault::SilenceDriven => self.driven_next = Some(fault),
        }
    }

    /// True if the fault on the output begins or ends at the next bit boundary.
    #[inline]
    pub(crate) fn drive_changes(&self) -> bool {
        self.driven != self.driven_next
    }

    /// A bit boundary at which the output is set anew.
    pub(crate) fn next_bit(&mut self) {
        self.driven = self.driven_next.take();
    }

    /// The bit has ended before its time: the mode has changed. A fault on the output is over with its bit.
    pub(crate) fn break_off_bit(&mut self) {
        self.driven = None;
    }

    pub(crate) fn drives_wrong(&self) -> bool {
        self.driven.is_some()
    }

    /// Whether the bit sampled now is inverted. Noise does not act on an idle bus.
    #[inline]
    pub(crate) fn hits_sample(&mut self, noisy: bool) -> bool {
        let inverted = core::mem::take(&mut self.invert_seen);
        match &mut self.noise {
            Some(noise) if noisy => inverted ^ noise.hits(),
            _ => inverted,
        }
    }

    /// True if nothing acts on the bits that are sampled and driven now: neither noise nor a fault by place.
    #[inline]
    pub(crate) fn leaves_bits_alone(&self) -> bool {
        !self.invert_seen && self.driven.is_none() && self.driven_next.is_none() && self.noise.is_none()
    }

    pub(crate) fn is_quiet(&self) -> bool {
        !self.invert_seen
            && self.driven.is_none()
            && self.driven_next.is_none()
            && self.rx.is_empty()
            && self.tx.is_empty()
    }

    /// Ends everything but noise.
    pub(crate) fn clear(&mut self) {
        *self = NodeFaults { noise: self.noise.take(), ..NodeFaults::default() };
    }
}

/// Random bit errors at one node: every bit it samples while the bus is not idle is inverted with the same
/// probability. Seeded per node, so that nodes do not disturb each other's sequences.
#[derive(Clone, Debug)]
pub(crate) struct Noise {
    rng: ChaCha8Rng,
    /// Natural logarithm of the probability that a bit survives.
    log_survival: f64,
    /// Bits until the next error.
    left: u64,
}

impl Noise {
    pub(crate) fn new(probability: f64, seed: u64, node: NodeId) -> Noise {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(node.index() as u64);
        let mut noise = Noise { rng, log_survival: (1.0 - probability).ln(), left: 0 };
        noise.left = noise.draw();
        noise
    }

    /// The number of bits that survive before the next error has a geometric distribution.
    fn draw(&mut self) -> u64 {
        // 53 bits, never zero.
        let uniform = ((self.rng.next_u64() >> 11) + 1) as f64 / (1u64 << 53) as f64;
        let bits = uniform.ln() / self.log_survival;
        if bits.is_finite() { bits as u64 } else { u64::MAX }
    }

    #[inline]
    fn hits(&mut self) -> bool {
        if self.left == 0 {
            self.left = self.draw();
            return true;
        }
        self.left -= 1;
        false
    }

    pub(crate) fn quiet_bits(&self) -> u64 {
        self.left
    }

    /// `bits` have been stepped over; they were known to be quiet.
    pub(crate) fn skip(&mut self, bits: u64) {
        self.left -= bits;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_has_the_rate_that_was_asked_for() {
        for rate in [0.5, 0.01, 0.0005] {
            let mut noise = Noise::new(rate, 7, NodeId(3));
            let bits = 2_000_000;
            let hits = (0..bits).filter(|_| noise.hits()).count() as f64;
            let expected = rate * f64::from(bits);
            assert!((hits - expected).abs() < 6.0 * expected.sqrt(), "{hits} errors, expected {expected}");
        }
    }

    #[test]
    fn noise_never_or_always() {
        let mut never = Noise::new(0.0, 1, NodeId(0));
        assert!((0..10_000).all(|_| !never.hits()));
        let mut always = Noise::new(1.0, 1, NodeId(0));
        assert!((0..100).all(|_| always.hits()));
    }

    #[test]
    fn every_node_has_errors_of_its_own() {
        let first = |node| Noise::new(0.01, 4, NodeId(node)).left;
        let mut distances: Vec<u64> = (0..20).map(first).collect();
        distances.sort_unstable();
        distances.dedup();
        assert!(distances.len() > 10, "{distances:?}");
    }

    #[test]
    fn the_later_disturbance_wins_while_two_overlap() {
        let mut line = Disturbances::default();
        line.set(0, Some(Disturbance::Dominant));
        line.set(1, Some(Disturbance::Recessive));
        assert!(line.apply(false));
        line.set(1, None);
        assert!(!line.apply(true));
        line.set(0, None);
        assert!(line.apply(true) && line.is_empty());
    }
}
