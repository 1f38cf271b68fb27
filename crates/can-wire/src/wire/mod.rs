//! The bus with its nodes, and the order in which things happen on it.

mod fast;
mod faults;
mod observe;
mod plan;
mod requests;

use std::collections::VecDeque;

use crate::{
    Event, EventKind, NodeConfig, NodeId, Signal, Time, TimingError,
    bus::Bus,
    fault::{BitFaultAt, Fault, Timed},
    node::{Node, Output},
    protocol::Context,
    schedule::Schedule,
    trace::Tracer,
};

pub use requests::{Abort, RequestError};

/// A CAN bus with its nodes.
///
/// Time advances in [`Wire::next_event`] only. Between two calls the caller may place requests; they take effect at
/// [`Wire::now`].
///
/// ```
/// use can_frame::Frame;
/// use can_wire::{EventKind, Mode, NodeConfig, Time, Wire};
///
/// let mut wire = Wire::new();
/// let a = wire.add_node(NodeConfig::new())?;
/// let b = wire.add_node(NodeConfig::new())?;
/// wire.set_mode(a, Mode::Normal);
/// wire.set_mode(b, Mode::Normal);
/// let frame: Frame = "123#DEADBEEF".parse()?;
/// wire.send(a, frame)?;
///
/// let mut received = None;
/// while let Some(event) = wire.next_event(Time::from_ms(1)) {
///     if let EventKind::Received { frame, .. } = event.kind {
///         received = Some((event.node, frame));
///     }
/// }
/// assert_eq!(received, Some((b, frame)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Wire {
    now: u64,
    nodes: Vec<Node>,
    bus: Bus,
    schedule: Schedule,
    events: VecDeque<Event>,
    tracer: Tracer,
    bit_faults: Vec<BitFaultAt>,
    timed: Vec<Timed>,
    /// When the next thing happens that is no step of a node.
    other_at: u64,
    injected: Vec<Fault>,
    fast: fast::FastPath,
}

/// What the engine has done, to tell how much of a run took the short cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Statistics {
    /// Steps of single nodes: outputs changed, edges taken in, bits sampled.
    pub steps: u64,
    /// Frames that were stepped over as a whole.
    pub frames_skipped: u64,
    /// Short cuts that were begun and then taken back, because a request came in between.
    pub skips_undone: u64,
}

/// Half of the range, so that it can be doubled.
const NEVER: u64 = u64::MAX >> 1;

impl Default for Wire {
    fn default() -> Wire {
        Wire::new()
    }
}

impl Wire {
    /// An empty bus at time zero.
    #[must_use]
    pub fn new() -> Wire {
        Wire {
            now: 0,
            nodes: Vec::new(),
            bus: Bus::new(),
            schedule: Schedule::default(),
            events: VecDeque::new(),
            tracer: Tracer::default(),
            bit_faults: Vec::new(),
            timed: Vec::new(),
            other_at: NEVER,
            injected: Vec::new(),
            fast: fast::FastPath::default(),
        }
    }

    /// Adds a node. It is [`crate::Mode::Off`] until [`Wire::set_mode`].
    ///
    /// # Errors
    /// A [`TimingError`] if the configuration describes no node.
    ///
    /// # Panics
    /// Beyond 65,535 nodes.
    pub fn add_node(&mut self, config: NodeConfig) -> Result<NodeId, TimingError> {
        config.check()?;
        self.settle();
        let index = u16::try_from(self.nodes.len()).expect("a bus has fewer than 65,536 nodes");
        assert!(index < u16::MAX, "a bus has fewer than 65,536 nodes");
        let mut node = Node::new(config);
        node.eager = self.tracer.levels;
        if !self.bus.level() {
            node.bus_changed(self.now, false, self.now);
        }
        self.nodes.push(node);
        self.bus.add_node();
        self.schedule.push();
        Ok(NodeId(index))
    }

    /// Advances to the next event and returns it, or to `limit` and returns `None`. Events that are due at the same
    /// time come one by one; [`Wire::now`] is then that time.
    ///
    /// A limit before [`Wire::now`] changes nothing but may return events of the present.
    pub fn next_event(&mut self, limit: Time) -> Option<Event> {
        loop {
            if let Some(event) = self.events.pop_front() {
                if let Some(sink) = &mut self.tracer.sink {
                    sink.event(&event);
                }
                return Some(event);
            }
            while self.events.is_empty() {
                if !self.advance(limit.as_ps()) {
                    self.now = self.now.max(limit.as_ps().min(Time::MAX.as_ps()));
                    self.fast.all_done_by(limit.as_ps());
                    self.tracer.flush_before(self.now);
                    return None;
                }
            }
        }
    }

    /// No event comes before this time unless a request makes one; [`Time::MAX`] if none will come at all. At this time
    /// something happens, though perhaps nothing that is an event.
    #[must_use]
    pub fn next_due(&self) -> Time {
        if !self.events.is_empty() {
            return self.now();
        }
        Time::from_ps(self.fast.next_due().or_else(|| self.next_time()).unwrap_or(Time::MAX.as_ps()))
    }

    /// Lets time pass to `until`, but not beyond [`Wire::next_due`]: for several buses that share one time.
    pub fn wait_until(&mut self, until: Time) {
        let due = self.next_due();
        let until = until.min(due);
        self.now = self.now.max(until.as_ps());
        if until < due {
            self.fast.all_done_by(until.as_ps());
        }
    }

    /// Runs until `limit` and hands every event to `handler`, which may place requests.
    pub fn run_until(&mut self, limit: Time, mut handler: impl FnMut(&mut Wire, Event)) {
        while let Some(event) = self.next_event(limit) {
            handler(self, event);
        }
    }

    /// Does the next thing if it is due by `limit`.
    #[inline(never)]
    fn advance_once(&mut self, limit: u64) -> bool {
        self.advance(limit)
    }

    #[inline(always)]
    fn advance(&mut self, limit: u64) -> bool {
        if self.fast.is_planned() {
            return self.advance_plan(limit);
        }
        let (key, index) = self.schedule.first().unwrap_or((u64::MAX, 0));
        if self.other_at << 1 <= key {
            return self.advance_other(limit);
        }
        if key >> 1 > limit || key == u64::MAX {
            return false;
        }
        self.go_to(key >> 1);
        if key & 1 == 0 {
            self.step_output(index);
        } else {
            self.step_sample(index);
        }
        true
    }

    /// At equal times a change that reaches the bus comes before a node's step, and the start or end of a fault before
    /// both.
    #[cold]
    #[inline(never)]
    fn advance_fault(&mut self) {
        self.apply_timed_fault();
    }

    #[inline(never)]
    fn advance_other(&mut self, limit: u64) -> bool {
        let at = self.other_at;
        if at > limit || at == NEVER {
            return false;
        }
        self.go_to(at);
        if self.next_timed_fault() == Some(at) {
            self.advance_fault();
        } else if let Some((index, level)) = self.bus.take_arrival() {
            self.refresh_other();
            self.contribute(index, level);
        }
        true
    }

    /// Recomputes when the next thing happens that is no step of a node.
    fn refresh_other(&mut self) {
        let arrival = self.bus.next_arrival().unwrap_or(NEVER);
        self.other_at = self.next_timed_fault().unwrap_or(NEVER).min(arrival);
    }

    /// When the next thing happens, whatever it is.
    fn next_time(&self) -> Option<u64> {
        let step = self.schedule.first().map(|(key, _)| key >> 1);
        let other = (self.other_at != NEVER).then_some(self.other_at);
        [step, other].into_iter().flatten().min()
    }

    #[inline]
    fn go_to(&mut self, at: u64) {
        self.now = at.max(self.now);
        if self.tracer.levels {
            self.tracer.flush_before(self.now);
        }
    }

    /// Edges and output changes of one node that are due now.
    #[inline(never)]
    fn step_output(&mut self, index: usize) {
        self.fast.statistics.steps += 1;
        let now = self.now;
        self.nodes[index].take_arrivals(now);
        if self.fast.is_enabled() && self.plan_frame(index) {
            return;
        }
        let output = self.nodes[index].drive(now);
        self.put_out(index, output);
        self.after_step(index);
    }

    #[inline(always)]
    fn step_sample(&mut self, index: usize) {
        self.fast.statistics.steps += 1;
        let now = self.now;
        let node = &mut self.nodes[index];
        if self.bit_faults.is_empty() && !self.tracer.bits && !self.tracer.levels && node.is_plain() {
            let mut cx = Context { now: Time::from_ps(now), node: NodeId(index as u16), events: &mut self.events };
            let key = node.sample_plain(now, &mut cx);
            self.schedule.set(index, key);
        } else {
            self.step_sample_with_care(index);
        }
    }

    /// The sample point of a node that is traced, has a fault near, or compensates its delay.
    #[inline(never)]
    fn step_sample_with_care(&mut self, index: usize) {
        let sampled = if self.tracer.bits {
            self.step_sample_recorded(index)
        } else {
            let now = self.now;
            let node = &mut self.nodes[index];
            node.take_arrivals(now);
            let mut cx = Context { now: Time::from_ps(now), node: NodeId(index as u16), events: &mut self.events };
            node.sample::<false>(now, &mut cx).0
        };
        if sampled && !self.bit_faults.is_empty() {
            self.match_bit_faults(index);
        }
        self.after_step(index);
    }

    #[inline(never)]
    fn step_sample_recorded(&mut self, index: usize) -> bool {
        let now = self.now;
        let node = &mut self.nodes[index];
        node.take_arrivals(now);
        let mut cx = Context { now: Time::from_ps(now), node: NodeId(index as u16), events: &mut self.events };
        let (sampled, record) = node.sample::<true>(now, &mut cx);
        if let (Some(record), Some(sink)) = (record, &mut self.tracer.sink) {
            sink.bit(&record);
        }
        sampled
    }

    /// A node's output has changed; it reaches the bus after the node's transmit delay.
    #[inline]
    fn put_out(&mut self, index: usize, output: Output) {
        let Output::Pin(level) = output else { return };
        if self.tracer.levels {
            self.tracer.level(self.now, Signal::Tx(NodeId(index as u16)), level);
        }
        let node = &self.nodes[index];
        if node.cut {
            return;
        }
        let delay = node.config.tx_delay.as_ps();
        if delay == 0 {
            self.contribute(index, level);
        } else {
            self.bus.send(index, level, self.now + delay);
            self.refresh_other();
        }
    }

    #[inline]
    fn contribute(&mut self, index: usize, level: bool) {
        // What was under way when the node was cut off does not arrive.
        let level = level || self.nodes[index].cut;
        if let Some(level) = self.bus.contribute(index, level) {
            self.spread(level);
        }
    }

    /// The bus has changed; every node gets to see it after its receive delay.
    fn spread(&mut self, level: bool) {
        if self.tracer.levels {
            self.tracer.level(self.now, Signal::Bus, level);
        }
        let now = self.now;
        for index in 0..self.nodes.len() {
            let node = &mut self.nodes[index];
            let at = now + node.config.rx_delay.as_ps();
            if node.bus_changed(at, level, now) || self.tracer.levels {
                self.after_step(index);
            }
        }
    }

    /// Whatever has happened to a node: its next event, its input in the trace, a wake-up.
    #[inline(always)]
    fn after_step(&mut self, index: usize) {
        let node = &mut self.nodes[index];
        self.schedule.set(index, node.next_key());
        if node.woken.is_some() {
            self.report_wake_up(index);
        }
        if self.tracer.levels {
            let level = self.nodes[index].rx;
            self.trace_input(index, level);
        }
    }

    #[cold]
    fn report_wake_up(&mut self, index: usize) {
        if let Some(at) = self.nodes[index].woken.take() {
            self.events.push_back(Event { time: at, node: NodeId(index as u16), kind: EventKind::WakeUp });
        }
    }

    fn trace_input(&mut self, index: usize, level: bool) {
        if self.nodes[index].traced_rx != level {
            self.nodes[index].traced_rx = level;
            self.tracer.level(self.now, Signal::Rx(NodeId(index as u16)), level);
        }
    }
}
