//! What was on the bus, in which order and when.

use core::fmt;
use std::collections::VecDeque;

use can_frame::Frame;
use can_wire::{BusError, Event, EventKind, NodeId, Time};

/// Something on the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusEntry {
    /// A frame that its sender saw through to its end.
    Frame {
        /// The sender.
        node: NodeId,
        /// Sample point of its start of frame.
        start: Time,
        /// Sample point of its last bit of EOF.
        end: Time,
        /// The frame, with the error state indicator that was sent.
        frame: Frame,
    },
    /// An error that a node detected.
    Error {
        /// The node.
        node: NodeId,
        /// When.
        time: Time,
        /// What.
        error: BusError,
    },
    /// A node lost arbitration.
    ArbitrationLost {
        /// The node.
        node: NodeId,
        /// When.
        time: Time,
    },
}

impl fmt::Display for BusEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Frame { node, start, end, frame } => write!(f, "{start} to {end} {node} sent {frame}"),
            Self::Error { node, time, error } => write!(f, "{time} {node}: {} at {}", error.kind, error.position),
            Self::ArbitrationLost { node, time } => write!(f, "{time} {node} lost arbitration"),
        }
    }
}

/// The latest entries, up to a limit.
#[derive(Clone, Debug)]
pub(crate) struct BusLog {
    pub(crate) entries: VecDeque<BusEntry>,
    pub(crate) limit: usize,
}

impl BusLog {
    pub(crate) fn note(&mut self, event: &Event) {
        let (node, time) = (event.node, event.time);
        let entry = match event.kind {
            EventKind::Transmitted { frame, sof, .. } => BusEntry::Frame { node, start: sof, end: time, frame },
            EventKind::Error(error) => BusEntry::Error { node, time, error },
            EventKind::ArbitrationLost { .. } => BusEntry::ArbitrationLost { node, time },
            _ => return,
        };
        if self.limit == 0 {
            return;
        }
        if self.entries.len() == self.limit {
            self.entries.pop_front();
        }
        self.entries.push_back(entry);
    }
}
