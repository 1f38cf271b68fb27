//! Injecting faults and carrying them out.

use super::Wire;
use crate::{
    Disturbance, Field, NodeId, Time,
    fault::{BitFaultAt, Fault, Frames, Line, Noise, Timed},
};

impl Wire {
    /// Injects a fault. Faults by place wait for their frame; faults by time begin at their start, or now if that has
    /// passed.
    pub fn inject(&mut self, fault: Fault) {
        self.settle();
        let id = self.injected.len() as u32;
        match fault {
            Fault::Bit { node, fault, position, frames } => {
                let started = self.frames_started(node, frames);
                self.bit_faults.push(BitFaultAt::new(node, fault, position, frames, started));
                self.match_bit_faults(node.index());
                self.nodes[node.index()].schedule_drive();
                self.after_step(node.index());
            }
            Fault::DropAck { node, frames } => {
                let started = self.frames_started(node, frames);
                self.bit_faults.push(BitFaultAt::drop_ack(node, frames, started));
            }
            Fault::Disturb { from, until, .. } | Fault::Cut { from, until, .. } => {
                let (from, until) = (from.as_ps().max(self.now), until.as_ps());
                if until > from {
                    self.injected.push(fault);
                    self.timed.push(Timed { at: from, id, begins: true });
                    self.timed.push(Timed { at: until, id, begins: false });
                    // The earliest is taken from the end.
                    self.timed.sort_unstable_by(|a, b| b.cmp(a));
                    self.refresh_other();
                }
            }
        }
    }

    /// Ends every fault, also those under way, but not the noise.
    pub fn clear_faults(&mut self) {
        self.settle();
        self.bit_faults.clear();
        self.timed.clear();
        self.refresh_other();
        self.injected.clear();
        self.bus.disturbances.clear();
        for index in 0..self.nodes.len() {
            self.nodes[index].faults.clear();
            self.set_cut(index, false);
            self.refresh_lines(index);
        }
        if let Some(level) = self.bus.settle() {
            self.spread(level);
        }
    }

    /// Holds or inverts a node's transmit output until told otherwise, whatever its mode: what a controller does whose
    /// software takes the pin over. `None` gives the output back. [`Wire::clear_faults`] does so too.
    pub fn override_output(&mut self, node: NodeId, how: Option<Disturbance>) {
        self.settle();
        self.nodes[node.index()].faults.tx.set(u32::MAX, how);
        self.refresh_lines(node.index());
    }

    /// From now on every bit that the node samples while the bus is not idle is inverted with this probability; 0 ends
    /// it. The same seed gives the same errors.
    ///
    /// # Panics
    /// If the probability is not between 0 and 1.
    pub fn set_noise(&mut self, node: NodeId, probability: f64, seed: u64) {
        assert!((0.0..=1.0).contains(&probability), "a probability lies between 0 and 1, not {probability}");
        self.settle();
        let noise = (probability > 0.0).then(|| Box::new(Noise::new(probability, seed, node)));
        self.nodes[node.index()].faults.noise = noise;
    }

    /// How many of the frames that count for a fault have started.
    fn frames_started(&self, victim: NodeId, frames: Frames) -> u64 {
        match frames.sender {
            Some(sender) => self.nodes[sender.index()].protocol.frames_sent,
            None => self.nodes[victim.index()].protocol.frames_seen,
        }
    }

    /// Arms the faults that wait for the bit that a node samples next.
    pub(super) fn match_bit_faults(&mut self, index: usize) {
        let position = self.nodes[index].protocol.position();
        if matches!(position.field, Field::Off | Field::Idle) {
            return;
        }
        let (nodes, faults) = (&mut self.nodes, &mut self.bit_faults);
        let mut armed = false;
        faults.retain(|fault| {
            let started = match fault.sender {
                Some(sender) => nodes[sender.index()].protocol.frames_sent,
                // A node's own start of frame is seen only when it is sampled.
                None if position.field == Field::Sof => nodes[index].protocol.frames_seen + 1,
                None => nodes[index].protocol.frames_seen,
            };
            if started >= fault.end {
                return false;
            }
            let here = fault.node.index() == index && fault.position == position && started >= fault.first;
            let sent = fault.sender.is_none_or(|sender| {
                let sender = &nodes[sender.index()].protocol;
                sender.sending || !position.field.is_in_frame()
            });
            if here && sent {
                nodes[index].faults.arm(fault.fault);
                armed = true;
                return started + 1 < fault.end;
            }
            true
        });
        if armed {
            self.nodes[index].schedule_drive();
        }
    }

    pub(super) fn next_timed_fault(&self) -> Option<u64> {
        self.timed.last().map(|timed| timed.at)
    }

    pub(super) fn apply_timed_fault(&mut self) {
        let Some(timed) = self.timed.pop() else {
            return;
        };
        self.refresh_other();
        match self.injected[timed.id as usize] {
            Fault::Disturb { line, how, .. } => {
                let how = timed.begins.then_some(how);
                match line {
                    Line::Bus => {
                        self.bus.disturbances.set(timed.id, how);
                        if let Some(level) = self.bus.settle() {
                            self.spread(level);
                        }
                    }
                    Line::Tx(node) => {
                        self.nodes[node.index()].faults.tx.set(timed.id, how);
                        self.refresh_lines(node.index());
                    }
                    Line::Rx(node) => {
                        self.nodes[node.index()].faults.rx.set(timed.id, how);
                        self.refresh_lines(node.index());
                    }
                }
            }
            Fault::Cut { node, .. } => self.set_cut(node.index(), timed.begins),
            Fault::Bit { .. } | Fault::DropAck { .. } => {}
        }
        if self.timed.is_empty() {
            self.injected.clear();
        }
    }

    fn set_cut(&mut self, index: usize, cut: bool) {
        let node = &mut self.nodes[index];
        node.take_arrivals(self.now);
        if node.cut == cut {
            return;
        }
        node.cut = cut;
        let level = cut || node.pin;
        node.apply_input(Time::from_ps(self.now));
        self.contribute(index, level);
        self.after_step(index);
    }

    /// Recomputes output and input of a node whose faults have changed.
    fn refresh_lines(&mut self, index: usize) {
        let now = self.now;
        let node = &mut self.nodes[index];
        node.take_arrivals(now);
        node.apply_input(Time::from_ps(now));
        let output = node.pin_output();
        self.put_out(index, output);
        self.after_step(index);
    }
}
