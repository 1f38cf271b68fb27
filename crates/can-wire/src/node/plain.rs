//! The common cases of a node, without what only the others need: bits and edges inside a frame, no fault near.

use super::{NEVER, Node};
use crate::{
    Field,
    protocol::{Context, Sync},
};

impl Node {
    /// Takes in the commonest changes of the bus: inside a frame, a rising edge, or a falling one that moves no sample
    /// point. Returns false, with nothing done, for every other.
    #[inline]
    pub(super) fn takes_quietly(&mut self, at: u64, level: bool) -> bool {
        let ordinary = self.protocol.field > Field::Idle
            && !self.hears_itself()
            && !self.cut
            && self.faults.rx.is_empty()
            && self.filtered_edge.is_none()
            && self.measuring.is_none();
        if !ordinary || self.rx == level {
            return false;
        }
        if !level && self.clock.may_sync {
            if !self.clock.expects_edge(at) {
                return false;
            }
            self.clock.may_sync = self.protocol.sync(true) == Sync::None;
        }
        self.raw_rx = level;
        self.rx = level;
        true
    }

    /// True if the bit sampled next is an ordinary one, for [`Node::sample_plain`].
    #[inline]
    pub(crate) fn is_plain(&self) -> bool {
        self.config.delay_compensation.is_none()
            && self.filtered_edge.is_none()
            && self.arrivals.is_empty()
            && self.faults.leaves_bits_alone()
    }

    /// [`Node::sample`] for a node that compensates no delay and has no fault near, without what only those need.
    /// Returns the key of the node's next event.
    #[inline(always)]
    pub(crate) fn sample_plain(&mut self, now: u64, cx: &mut Context<'_>) -> u64 {
        if !self.is_active() || self.clock.next_sample_at > now {
            return self.next_key();
        }
        let level = self.seen();
        self.awake = false;
        self.protocol.sample_plain(level, cx);
        self.clock.sampled(level, self.protocol.data_phase);
        if self.protocol.drive == self.driven {
            self.drive_key = NEVER;
        } else {
            self.set_drive(self.clock.start);
        }
        self.next_key()
    }
}
