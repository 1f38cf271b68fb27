//! A node without a controller: sends what it is told, keeps what it sees. The other side of a test.

use std::collections::VecDeque;

use can_frame::Frame;
use can_wire::{Event, EventKind, NodeId, Time, Wire};

use crate::buses::BusId;

/// A node without a controller in a [`crate::Sim`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PeerId(pub(crate) usize);

#[derive(Clone, Debug)]
pub(crate) struct Peer {
    pub(crate) bus: BusId,
    pub(crate) node: NodeId,
    pub(crate) queue: VecDeque<Frame>,
    pub(crate) received: Vec<(Time, Frame)>,
    pub(crate) sent: Vec<(Time, Frame)>,
}

impl Peer {
    pub(crate) fn new(bus: BusId, node: NodeId) -> Self {
        Self { bus, node, queue: VecDeque::new(), received: Vec::new(), sent: Vec::new() }
    }

    /// Requests the first waiting frame; in a state that does not allow it the frame keeps waiting.
    pub(crate) fn send(&mut self, wire: &mut Wire) {
        if let Some(frame) = self.queue.front() {
            let _refused = wire.send(self.node, *frame);
        }
    }

    pub(crate) fn on_event(&mut self, wire: &mut Wire, event: &Event) {
        match event.kind {
            EventKind::Received { frame, .. } => self.received.push((event.time, frame)),
            EventKind::Transmitted { frame, .. } => {
                self.queue.pop_front();
                self.sent.push((event.time, frame));
                self.send(wire);
            }
            EventKind::ArbitrationLost { .. }
            | EventKind::TransmissionFailed(_)
            | EventKind::ModeChanged { .. }
            | EventKind::ErrorState { .. } => self.send(wire),
            _ => {}
        }
    }
}
