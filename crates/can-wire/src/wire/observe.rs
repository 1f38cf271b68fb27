//! Looking at the wire and its nodes.

use super::{Statistics, Wire};
use crate::{
    ErrorState, Level, Mode, NodeConfig, NodeId, PartialFrame, Position, Role, Time, TraceSink,
};

impl Wire {
    /// The present.
    #[must_use]
    pub fn now(&self) -> Time {
        Time::from_ps(self.now)
    }

    /// The nodes, in the order in which they were added.
    pub fn nodes(&self) -> impl ExactSizeIterator<Item = NodeId> + use<> {
        (0..self.nodes.len() as u16).map(NodeId)
    }

    /// The configuration of a node.
    #[must_use]
    pub fn config(&self, node: NodeId) -> &NodeConfig {
        &self.nodes[node.index()].config
    }

    /// The operating mode of a node.
    #[must_use]
    pub fn mode(&self, node: NodeId) -> Mode {
        self.nodes[node.index()].protocol.mode
    }

    /// Transmit and receive error counter of a node, 0 to 255 each.
    #[must_use]
    pub fn error_counters(&self, node: NodeId) -> (u16, u16) {
        let confinement = &self.nodes[node.index()].protocol.confinement;
        (confinement.tec.min(255), confinement.rec)
    }

    /// The error state of a node.
    #[must_use]
    pub fn error_state(&self, node: NodeId) -> ErrorState {
        self.nodes[node.index()].protocol.confinement.state
    }

    /// The bit that a node samples next. While the engine steps over a frame the answer is worked out bit by bit.
    #[must_use]
    pub fn position(&mut self, node: NodeId) -> Position {
        self.settle();
        self.nodes[node.index()].protocol.position()
    }

    /// The part that a node plays in the frame on the bus.
    #[must_use]
    pub fn role(&mut self, node: NodeId) -> Role {
        self.settle();
        self.nodes[node.index()].protocol.role
    }

    /// What a node has decoded of the frame on the bus, or of the one before if no other has started: after an error,
    /// everything up to it.
    #[must_use]
    pub fn partial_frame(&mut self, node: NodeId) -> PartialFrame {
        self.settle();
        self.nodes[node.index()].protocol.partial_frame()
    }

    /// The level of the bus.
    #[must_use]
    pub fn bus_level(&mut self) -> Level {
        self.settle();
        Level::from_bit(self.bus.level())
    }

    /// The level at a node's receive input.
    #[must_use]
    pub fn rx_level(&mut self, node: NodeId) -> Level {
        self.settle();
        let now = self.now;
        self.nodes[node.index()].take_arrivals(now);
        self.after_step(node.index());
        Level::from_bit(self.nodes[node.index()].rx)
    }

    /// The level at a node's transmit output.
    #[must_use]
    pub fn tx_level(&mut self, node: NodeId) -> Level {
        self.settle();
        Level::from_bit(self.nodes[node.index()].pin)
    }

    /// Has the run watched from now on; returns the sink that watched it before. `None` ends it.
    pub fn set_trace(
        &mut self,
        sink: Option<Box<dyn TraceSink + Send>>,
    ) -> Option<Box<dyn TraceSink + Send>> {
        self.settle();
        let before = self.tracer.set(sink);
        let now = self.now;
        for index in 0..self.nodes.len() {
            self.nodes[index].take_arrivals(now);
            self.nodes[index].eager = self.tracer.levels;
            self.nodes[index].traced_rx = true;
            self.after_step(index);
        }
        if self.tracer.levels {
            for index in 0..self.nodes.len() {
                let pin = self.nodes[index].pin;
                self.tracer
                    .level(now, crate::Signal::Tx(NodeId(index as u16)), pin);
            }
            self.tracer.level(now, crate::Signal::Bus, self.bus.level());
        }
        before
    }

    /// Allows or forbids stepping over frames whose course is certain. Allowed from the start; it changes nothing but
    /// the speed.
    pub fn set_fast_path(&mut self, allowed: bool) {
        self.settle();
        self.fast.set_allowed(allowed);
    }

    /// What the engine has done so far.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.fast.statistics
    }
}
