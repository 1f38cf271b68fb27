//! Stepping over frames whose course is certain: delivering what was worked out, and setting the nodes to the end.
//!
//! Nothing of a node changes while a plan is being carried out. If a request comes that the plan has not foreseen, it
//! is dropped and the bits up to the present are worked out one by one.

use super::{Statistics, Wire, plan::Plan};
use crate::{Field, NodeId, Signal, Time, encode::encode, protocol::Incoming};

pub(super) struct FastPath {
    allowed: bool,
    planned: bool,
    /// The caller has been told that nothing more happens up to this time.
    done_by: u64,
    /// Kept between frames for its allocations; absent while it is being worked on.
    plan: Option<Box<Plan>>,
    pub(super) statistics: Statistics,
}

impl Default for FastPath {
    fn default() -> FastPath {
        FastPath { allowed: true, planned: false, done_by: 0, plan: None, statistics: Statistics::default() }
    }
}

impl FastPath {
    #[inline]
    pub(super) fn is_enabled(&self) -> bool {
        self.allowed
    }

    pub(super) fn set_allowed(&mut self, allowed: bool) {
        self.allowed = allowed;
    }

    #[inline]
    pub(super) fn is_planned(&self) -> bool {
        self.planned
    }

    /// Everything that is due by this time has been told to the caller.
    #[inline]
    pub(super) fn all_done_by(&mut self, limit: u64) {
        self.done_by = self.done_by.max(limit);
    }

    /// When the plan delivers its next event or ends, if there is one.
    pub(super) fn next_due(&self) -> Option<u64> {
        let plan = self.plan.as_ref().filter(|_| self.planned)?;
        Some(plan.events.get(plan.delivered).map_or(plan.end, |event| event.time.as_ps()))
    }

    /// True once every receiver of the planned frame has sampled its start. Before, a request could still put another
    /// node into the arbitration.
    pub(super) fn has_started(&self) -> bool {
        self.plan.as_ref().is_none_or(|plan| plan.delivered > plan.receivers.len())
    }

    /// A frame that is requested while another is on the bus only matters when the bus is idle again.
    pub(super) fn note_request(&mut self, now: u64, node: NodeId, frame: can_frame::Frame) {
        if let Some(plan) = &mut self.plan {
            plan.requests.push((now, node, frame));
        }
    }
}

impl Wire {
    /// Tries to work out the frame that node `index` starts now. Returns true if a plan is in force.
    #[inline]
    pub(super) fn plan_frame(&mut self, index: usize) -> bool {
        let protocol = &self.nodes[index].protocol;
        protocol.sending && protocol.field == Field::Sof && self.make_plan(index)
    }

    #[inline(never)]
    fn make_plan(&mut self, index: usize) -> bool {
        let mut plan = self.fast.plan.take().unwrap_or_else(|| Box::new(Plan::empty()));
        self.fast.planned = self.work_out(index, &mut plan).is_some();
        self.fast.plan = Some(plan);
        self.fast.planned
    }

    /// Delivers the next event of the plan, or ends it.
    #[inline(never)]
    pub(super) fn advance_plan(&mut self, limit: u64) -> bool {
        let Some(plan) = &mut self.fast.plan else {
            return false;
        };
        if let Some(event) = plan.events.get(plan.delivered) {
            if event.time.as_ps() > limit {
                return false;
            }
            self.now = self.now.max(event.time.as_ps());
            self.events.push_back(*event);
            plan.delivered += 1;
            return true;
        }
        if plan.end > limit {
            return false;
        }
        self.finish_plan();
        true
    }

    fn finish_plan(&mut self) {
        let Some(plan) = self.fast.plan.take() else {
            return;
        };
        if self.tracer.levels {
            self.trace_plan(&plan);
        }
        self.now = self.now.max(plan.end);
        let last = plan.last_intermission_bit();
        let incoming = Incoming::of(&plan.frame);
        let time = |sof, bit| Time::from_ps(plan.course.sample(sof, bit).ceil());
        let res_time = |sof| plan.course.layout.res.map(|bit| time(sof, bit));
        let sender = &mut self.nodes[plan.sender];
        sender.protocol.finish_frame(true, &incoming, time(plan.sof, 0), res_time(plan.sof));
        sender.finish_frame(plan.sender_start(last), last, plan.delay);
        self.after_step(plan.sender);
        for receiver in &plan.receivers {
            let sof = receiver.sof;
            let node = &mut self.nodes[receiver.index];
            node.protocol.finish_frame(false, &incoming, time(sof, 0), res_time(sof));
            // Noise has not met SOF, which a receiver samples while it is idle.
            node.finish_frame(plan.course.start(sof, last), last - 1, None);
            self.after_step(receiver.index);
        }
        self.fast.statistics.frames_skipped += 1;
        self.fast.planned = false;
        self.fast.plan = Some(plan);
    }

    /// Drops a plan that is in force and works out the present bit by bit.
    #[inline]
    pub(super) fn settle(&mut self) {
        if self.fast.planned {
            self.undo_plan();
        }
    }

    #[cold]
    fn undo_plan(&mut self) {
        self.fast.planned = false;
        self.fast.statistics.skips_undone += 1;
        let present = self.now;
        let Some(mut plan) = self.fast.plan.take() else {
            return;
        };
        let delivered = plan.delivered;
        let requests = core::mem::take(&mut plan.requests);
        for (_, node, _) in &requests {
            self.nodes[node.index()].protocol.request = None;
            self.after_step(node.index());
        }
        // The plan began where the transmitter was about to drive its SOF.
        self.now = self.nodes[plan.sender].clock.start.ceil();
        let allowed = core::mem::replace(&mut self.fast.allowed, false);
        let waiting = core::mem::take(&mut self.events);
        let mut requests = requests.into_iter().peekable();
        // At the present itself there may be more to come after the event that the caller was given last.
        let between_events = self.fast.done_by < present;
        while let Some(time) = self.next_time() {
            if time > present || (time == present && between_events && self.events.len() >= delivered) {
                break;
            }
            while let Some((_, node, frame)) = requests.next_if(|(at, _, _)| *at < time) {
                self.place_request(node, frame);
            }
            self.advance_once(present);
        }
        for (_, node, frame) in requests {
            self.place_request(node, frame);
        }
        // What the caller has had, or is about to get from the queue, is not told again.
        let told = delivered.min(self.events.len());
        self.events.drain(..told);
        let fresh = core::mem::replace(&mut self.events, waiting);
        self.events.extend(fresh);
        self.fast.allowed = allowed;
        self.fast.plan = Some(plan);
        self.now = present;
        self.tracer.flush_before(present);
    }

    /// The level changes of a frame that is stepped over.
    fn trace_plan(&mut self, plan: &Plan) {
        let mut changes: Vec<(u64, Signal, bool)> = Vec::new();
        let tx_delay = self.nodes[plan.sender].config.tx_delay.as_ps();
        let mut bus: Vec<(u64, bool)> = Vec::new();
        let iso = self.nodes[plan.sender].protocol.options.iso_crc;
        let mut level = true;
        for (index, bit) in encode(&plan.frame, iso).iter().enumerate() {
            if bit.bit != level {
                level = bit.bit;
                let at = plan.course.start(plan.sof, index as u64).ceil();
                changes.push((at, Signal::Tx(NodeId(plan.sender as u16)), level));
                bus.push((at + tx_delay, level));
            }
        }
        if !level {
            let at = plan.course.start(plan.sof, plan.course.layout.crc_delimiter).ceil();
            changes.push((at, Signal::Tx(NodeId(plan.sender as u16)), true));
            bus.push((at + tx_delay, true));
        }
        let slot = plan.ack_slot();
        let (mut falls, mut rises) = (u64::MAX, 0);
        for receiver in plan.receivers.iter().filter(|receiver| receiver.acknowledges) {
            let start = plan.course.start(receiver.sof, slot).ceil();
            let end = plan.course.start(receiver.sof, slot + 1).ceil();
            let signal = Signal::Tx(NodeId(receiver.index as u16));
            changes.extend([(start, signal, false), (end, signal, true)]);
            let delay = self.nodes[receiver.index].config.tx_delay.as_ps();
            falls = falls.min(start + delay);
            rises = rises.max(end + delay);
        }
        bus.extend([(falls, false), (rises, true)]);
        for (at, level) in bus {
            changes.push((at, Signal::Bus, level));
            for (index, node) in self.nodes.iter().enumerate().filter(|(_, node)| !node.hears_itself()) {
                let delay = node.config.rx_delay.as_ps();
                changes.push((at + delay, Signal::Rx(NodeId(index as u16)), level));
            }
        }
        changes.sort_by_key(|(at, _, _)| *at);
        for (at, signal, level) in changes {
            self.tracer.level(at, signal, level);
        }
    }
}
