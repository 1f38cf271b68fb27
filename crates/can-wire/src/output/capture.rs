//! Catching one frame with all its bits at all nodes.

use crate::{BitRecord, Event, Field, NodeId, TraceSink};

/// Catches one frame with all its bits: from its start of frame to the end of the intermission, including error and
/// overload frames.
///
/// [`FrameCapture::timeline`] prints it, [`FrameCapture::svg`] draws it. While it watches, the engine works out every
/// bit, so a long run before the frame is slower than without it.
#[derive(Clone, Debug)]
pub struct FrameCapture {
    pub(super) reference: NodeId,
    skip: u64,
    state: State,
    pub(super) bits: Vec<BitRecord>,
    pub(super) events: Vec<Event>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Waiting,
    Catching,
    /// The reference node is through; the others sample their last bit.
    Closing,
    Done,
}

/// A frame with a 29-bit identifier, 64 data bytes and all its stuff bits has fewer bits than this; what follows after
/// it, such as an error passive node that waits for ever, is cut off.
const MAX_BITS_PER_NODE: usize = 2_000;

impl FrameCapture {
    /// Catches a frame as seen by `reference`, after letting `skip` frames pass.
    #[must_use]
    pub fn new(reference: NodeId, skip: u64) -> FrameCapture {
        FrameCapture {
            reference,
            skip,
            state: State::Waiting,
            bits: Vec::new(),
            events: Vec::new(),
        }
    }

    /// True once the frame and its intermission are over.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        matches!(self.state, State::Closing | State::Done)
    }

    /// The bits of all nodes, in the order of their sample points.
    #[must_use]
    pub fn bits(&self) -> &[BitRecord] {
        &self.bits
    }

    /// What happened meanwhile.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The bits of one node.
    pub(super) fn of(&self, node: NodeId) -> impl Iterator<Item = &BitRecord> {
        self.bits.iter().filter(move |bit| bit.node == node)
    }

    /// The nodes that have sampled anything.
    pub(super) fn nodes(&self) -> Vec<NodeId> {
        let mut nodes: Vec<NodeId> = self.bits.iter().map(|bit| bit.node).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }
}

impl TraceSink for FrameCapture {
    fn bit(&mut self, bit: &BitRecord) {
        let starts = bit.position.field == Field::Sof && bit.seen.is_dominant();
        let is_reference = bit.node == self.reference;
        if self.state == State::Waiting && starts {
            // Another node may sample the start of frame first.
            if self.skip > 0 {
                self.skip -= u64::from(is_reference);
                return;
            }
            self.state = State::Catching;
        } else if self.state == State::Catching && is_reference {
            let again = starts && self.of(self.reference).next().is_some();
            let over = matches!(
                bit.position.field,
                Field::Idle | Field::Off | Field::BusOff | Field::Suspend
            );
            if again || over || self.bits.len() > MAX_BITS_PER_NODE * self.nodes().len() {
                self.state = State::Done;
            }
        }
        if self.state == State::Closing {
            let last = self.of(self.reference).last().copied();
            let late =
                last.is_none_or(|last| bit.sample > last.sample + last.sample.since(last.start));
            if late || is_reference {
                self.state = State::Done;
            } else if !starts {
                self.bits.push(*bit);
            }
        }
        if self.state == State::Catching {
            self.bits.push(*bit);
            if is_reference && bit.position.field == Field::Intermission && bit.position.bit == 2 {
                self.state = State::Closing;
            }
        }
    }

    fn event(&mut self, event: &Event) {
        if self.state == State::Catching || (self.is_complete() && event.time <= self.end()) {
            self.events.push(*event);
        }
    }

    fn wants_bits(&self) -> bool {
        self.state != State::Done
    }

    fn wants_levels(&self) -> bool {
        false
    }
}

impl FrameCapture {
    fn end(&self) -> crate::Time {
        self.bits.last().map(|bit| bit.sample).unwrap_or_default()
    }
}
