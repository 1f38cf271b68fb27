//! Working out the whole course of a frame before it happens.
//!
//! When one node starts a frame, nobody else wants to, no fault is near and all nodes share one clock rate and bit
//! timing, then every sample point up to the intermission is certain: each receiver keeps the phase that the hard
//! synchronization on SOF gave it, because every later edge falls into its synchronization segment. Only the transmitter
//! may still move, once, by the edge of the acknowledgement. The conditions are checked one by one below; if one does
//! not hold, the frame is worked out bit by bit as always.

use can_frame::Frame;

use super::Wire;
use crate::{
    DelaySource, Event, EventKind, FdSupport, Field, Mode, NodeConfig, NodeId, Role, Time,
    bit_clock::{Effect, Segments},
    encode::{Layout, layout},
    node::Node,
    protocol::Sync,
    time::{Fine, Tick},
};

/// Bits between the CRC delimiter and the second bit of intermission, counted from the former.
const ACK_SLOT: u64 = 1;
const ACK_DELIMITER: u64 = 2;
const EOF_VALID_FOR_RECEIVER: u64 = 8;
const EOF_VALID_FOR_TRANSMITTER: u64 = 9;
const INTERMISSION_LAST: u64 = 12;

/// Positions of the bits of a frame in time, relative to the start of frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    nominal: Segments,
    data: Segments,
    pub(super) layout: Layout,
}

impl Course {
    /// Nominal and data quanta from the start of SOF to the start of a bit.
    fn quanta(&self, bit: u64) -> (u64, u64) {
        let (nominal, data) = (&self.nominal, &self.data);
        let delimiter = self.layout.crc_delimiter;
        match self.layout.brs {
            Some(brs) if bit > brs => {
                // The bit rate switches at the sample points of BRS and of the CRC delimiter.
                let until_switch = brs * nominal.bit() + nominal.before;
                if bit <= delimiter {
                    return (until_switch, data.after + (bit - brs - 1) * data.bit());
                }
                let in_data = data.after + (delimiter - brs - 1) * data.bit() + data.before;
                (until_switch + nominal.after + (bit - delimiter - 1) * nominal.bit(), in_data)
            }
            _ => (bit * nominal.bit(), 0),
        }
    }

    pub(super) fn start(&self, sof: Fine, bit: u64) -> Fine {
        let (nominal, data) = self.quanta(bit);
        sof.plus(nominal, self.nominal.quantum).plus(data, self.data.quantum)
    }

    pub(super) fn sample(&self, sof: Fine, bit: u64) -> Fine {
        let fast = self.layout.brs.is_some_and(|brs| bit > brs && bit <= self.layout.crc_delimiter);
        let segments = if fast { &self.data } else { &self.nominal };
        self.start(sof, bit).plus(segments.before, segments.quantum)
    }

    fn has_data_phase(&self) -> bool {
        self.layout.brs.is_some()
    }
}

/// The part of one receiver.
#[derive(Clone, Copy, Debug)]
pub(super) struct Receiver {
    pub(super) index: usize,
    /// Start of the bit that it takes for SOF.
    pub(super) sof: Fine,
    /// It drives the acknowledgement onto the bus.
    pub(super) acknowledges: bool,
}

/// The course of a frame.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub(super) frame: Frame,
    pub(super) course: Course,
    pub(super) sender: usize,
    /// Start of the transmitter's SOF.
    pub(super) sof: Fine,
    /// Quanta by which the edge of the acknowledgement moves the transmitter.
    pub(super) shift: u64,
    pub(super) receivers: Vec<Receiver>,
    /// Transmitter delay in clock periods, if it is compensated.
    pub(super) delay: Option<u64>,
    /// When everyone has sampled the second bit of intermission, and nobody the third.
    pub(super) end: u64,
    /// In the order in which they happen; `delivered` of them have.
    pub(super) events: Vec<Event>,
    pub(super) delivered: usize,
    /// Requests that came in since: when, where, what.
    pub(super) requests: Vec<(u64, NodeId, Frame)>,
}

impl Plan {
    pub(super) fn empty() -> Plan {
        let segments = crate::bit_clock::BitClock::new(&NodeConfig::new()).nominal;
        let layout = Layout { res: None, brs: None, crc_delimiter: 0 };
        Plan {
            frame: Frame::remote(can_frame::StandardId::ZERO, can_frame::Dlc::ZERO),
            course: Course { nominal: segments, data: segments, layout },
            sender: 0,
            sof: Fine::default(),
            shift: 0,
            receivers: Vec::new(),
            delay: None,
            end: 0,
            events: Vec::new(),
            delivered: 0,
            requests: Vec::new(),
        }
    }

    /// Start of a bit at the transmitter, from the ACK delimiter on with its shift.
    pub(super) fn sender_start(&self, bit: u64) -> Fine {
        let start = self.course.start(self.sof, bit);
        self.shifted(start, bit)
    }

    pub(super) fn sender_sample(&self, bit: u64) -> Fine {
        let sample = self.course.sample(self.sof, bit);
        if bit == self.course.layout.crc_delimiter + ACK_SLOT {
            return sample.plus(self.shift, self.course.nominal.quantum);
        }
        self.shifted(sample, bit)
    }

    fn shifted(&self, at: Fine, bit: u64) -> Fine {
        if bit >= self.course.layout.crc_delimiter + ACK_DELIMITER {
            at.plus(self.shift, self.course.nominal.quantum)
        } else {
            at
        }
    }

    pub(super) fn ack_slot(&self) -> u64 {
        self.course.layout.crc_delimiter + ACK_SLOT
    }

    pub(super) fn last_intermission_bit(&self) -> u64 {
        self.course.layout.crc_delimiter + INTERMISSION_LAST
    }
}

fn ps(time: Time) -> u64 {
    time.as_ps()
}

fn same_segments(a: &Segments, b: &Segments) -> bool {
    (a.quantum, a.before, a.after) == (b.quantum, b.before, b.after)
}

impl Wire {
    /// Works out the frame that `sender` is about to start now, into `plan`. `None` if it is not certain.
    pub(super) fn work_out(&mut self, sender: usize, plan: &mut Plan) -> Option<()> {
        let now = self.now;
        let node = &self.nodes[sender];
        let protocol = &node.protocol;
        let starts = protocol.field == Field::Sof && protocol.sending && node.drive_at() == Some(node.clock.start);
        let clean = protocol.mode == Mode::Normal
            && protocol.confinement.tec == 0
            && protocol.confinement.rec == 0
            && protocol.overload_requests == 0;
        let undisturbed = self.bit_faults.is_empty() && !self.tracer.bits && self.bus.is_quiet() && !node.cut;
        if !(starts && clean && undisturbed && is_quiet(node)) {
            return None;
        }
        let frame = protocol.outgoing;
        plan.frame = frame;
        plan.sender = sender;
        plan.sof = node.clock.start;
        plan.course = Course {
            nominal: node.clock.nominal,
            data: node.clock.data,
            layout: layout(&frame, protocol.options.iso_crc),
        };
        let config = node.config;
        self.find_receivers(sender, plan, now)?;
        check_own_bits(&config, plan)?;
        plan.delay = transmitter_delay(&self.nodes[sender], plan)?;
        self.acknowledgement(&config, plan)?;
        self.find_end(plan)?;
        self.list_events(plan);
        Some(())
    }

    /// Everyone else: idle receivers of the same timing, or nodes that take no part.
    fn find_receivers(&mut self, sender: usize, plan: &mut Plan, now: u64) -> Option<()> {
        let frame = plan.frame;
        let iso = self.nodes[sender].protocol.options.iso_crc;
        let clock = self.nodes[sender].clock.clock;
        let tx_delay = ps(self.nodes[sender].config.tx_delay);
        // Outputs are rounded up to a picosecond, so an edge may come that much later than it should.
        let shortest = if plan.course.has_data_phase() {
            plan.course.nominal.quantum.0.min(plan.course.data.quantum.0)
        } else {
            plan.course.nominal.quantum.0
        };
        plan.receivers.clear();
        for index in 0..self.nodes.len() {
            if index == sender {
                continue;
            }
            let node = &mut self.nodes[index];
            node.take_arrivals(now);
            if node.cut || !node.is_asleep() || node.drive_at().is_some() || node.has_arrivals() || node.wake_armed {
                return None;
            }
            if !is_quiet(node) {
                return None;
            }
            let protocol = &node.protocol;
            if protocol.field != Field::Idle || protocol.mode.is_loopback() {
                continue;
            }
            let counters_rest = protocol.confinement.rec == 0 || !protocol.mode.counts_errors();
            let understands =
                !frame.is_fd() || (protocol.options.fd == FdSupport::Fd && protocol.options.iso_crc == iso);
            let same_timing = node.clock.clock == clock
                && same_segments(&node.clock.nominal, &plan.course.nominal)
                && (!plan.course.has_data_phase() || same_segments(&node.clock.data, &plan.course.data));
            let ready = node.clock.may_sync && node.rx && protocol.overload_requests == 0;
            if !(counters_rest && understands && same_timing && ready) {
                return None;
            }
            let delay = tx_delay + ps(node.config.rx_delay);
            let sof = hard_sync(node, plan.sof.ceil() + delay);
            let phase = plan.sof.plus(delay, Tick(Tick::PICOSECOND)).checked_since(sof)?;
            if phase + u128::from(Tick::PICOSECOND) > u128::from(shortest) {
                return None;
            }
            let acknowledges = matches!(protocol.mode, Mode::Normal | Mode::Restricted);
            plan.receivers.push(Receiver { index, sof, acknowledges });
        }
        Some(())
    }

    /// The edge of the acknowledgement at the transmitter, and that everyone samples the acknowledgement right.
    fn acknowledgement(&self, sender: &NodeConfig, plan: &mut Plan) -> Option<()> {
        let slot = plan.ack_slot();
        let (mut falls, mut rises) = (u64::MAX, 0);
        for receiver in plan.receivers.iter().filter(|receiver| receiver.acknowledges) {
            let delay = ps(self.nodes[receiver.index].config.tx_delay);
            falls = falls.min(plan.course.start(receiver.sof, slot).ceil() + delay);
            rises = rises.max(plan.course.start(receiver.sof, slot + 1).ceil() + delay);
        }
        if falls == u64::MAX {
            return None;
        }
        for receiver in &plan.receivers {
            let delay = ps(self.nodes[receiver.index].config.rx_delay);
            let start = plan.course.start(receiver.sof, slot);
            let in_time = falls + delay >= start.ceil()
                && falls + delay <= plan.course.sample(receiver.sof, slot).ceil()
                && rises + delay <= plan.course.sample(receiver.sof, slot + 1).ceil();
            if !in_time {
                return None;
            }
        }
        let at = falls + ps(sender.rx_delay);
        let start = plan.course.start(plan.sof, slot);
        if at < start.ceil() || at > plan.course.sample(plan.sof, slot).ceil() {
            return None;
        }
        let nominal = &plan.course.nominal;
        let late = Fine::from_time(Time::from_ps(at)).ticks_since(start, nominal.quantum);
        plan.shift = late.min(nominal.sjw);
        let ends = rises + ps(sender.rx_delay);
        (ends <= plan.sender_sample(slot + 1).ceil()).then_some(())
    }

    /// The moment at which the nodes are set to the end of the frame: all of them between the same two sample points.
    fn find_end(&self, plan: &mut Plan) -> Option<()> {
        let last = plan.last_intermission_bit();
        let mut end = plan.sender_sample(last - 1).ceil();
        let mut limit = plan.sender_sample(last).ceil();
        for receiver in &plan.receivers {
            end = end.max(plan.course.sample(receiver.sof, last - 1).ceil());
            limit = limit.min(plan.course.sample(receiver.sof, last).ceil());
        }
        let fault = self.next_timed_fault().unwrap_or(u64::MAX);
        if end >= limit || fault <= end {
            return None;
        }
        // Noise must stay away from every bit: the transmitter's and, without SOF which they meet idle, the receivers'.
        let quiet = |index: usize, bits| {
            let noise = self.nodes[index].faults.noise.as_ref();
            noise.is_none_or(|noise| noise.quiet_bits() >= bits)
        };
        if !quiet(plan.sender, last) || !plan.receivers.iter().all(|receiver| quiet(receiver.index, last - 1)) {
            return None;
        }
        plan.end = end;
        Some(())
    }

    fn list_events(&self, plan: &mut Plan) {
        let mut events = core::mem::take(&mut plan.events);
        events.clear();
        plan.delivered = 0;
        plan.requests.clear();
        let (course, frame) = (&plan.course, plan.frame);
        let delimiter = course.layout.crc_delimiter;
        let mut push = |at: Fine, index: usize, kind| {
            events.push(Event { time: Time::from_ps(at.ceil()), node: NodeId(index as u16), kind });
        };
        let sof = course.sample(plan.sof, 0);
        let res = course.layout.res.map(|bit| Time::from_ps(course.sample(plan.sof, bit).ceil()));
        // In the order of time, and of the nodes where times are equal.
        let mut sender = Some((sof.ceil(), plan.sender));
        for receiver in &plan.receivers {
            let at = course.sample(receiver.sof, 0);
            if sender.is_some_and(|sender| sender < (at.ceil(), receiver.index)) {
                sender = None;
                let role = Role::Transmitter;
                push(sof, plan.sender, EventKind::StartOfFrame { role });
            }
            let role = Role::Receiver;
            push(at, receiver.index, EventKind::StartOfFrame { role });
        }
        if sender.is_some() {
            let role = Role::Transmitter;
            push(sof, plan.sender, EventKind::StartOfFrame { role });
        }
        if let (Some(delay), Some(res)) = (plan.delay, course.layout.res)
            && let Some(compensation) = self.nodes[plan.sender].config.delay_compensation
        {
            let kind = EventKind::TransmitterDelay {
                delay: delay.min(u64::from(u16::MAX)) as u16,
                secondary_sample_point: compensation.secondary_sample_point(delay) as u16,
            };
            // BRS comes next, no stuff bit can be between: FDF and res differ.
            push(course.sample(plan.sof, res + 1), plan.sender, kind);
        }
        for receiver in &plan.receivers {
            let sof = Time::from_ps(course.sample(receiver.sof, 0).ceil());
            let res = course.layout.res.map(|bit| Time::from_ps(course.sample(receiver.sof, bit).ceil()));
            let valid = course.sample(receiver.sof, delimiter + EOF_VALID_FOR_RECEIVER);
            push(valid, receiver.index, EventKind::Received { frame, sof, res });
        }
        let sof = Time::from_ps(sof.ceil());
        push(
            plan.sender_sample(delimiter + EOF_VALID_FOR_TRANSMITTER),
            plan.sender,
            EventKind::Transmitted { frame, sof, res },
        );
        // Mostly they are in order already.
        let key = |event: &Event| (event.time, event.node);
        if !events.is_sorted_by_key(key) {
            events.sort_by_key(key);
        }
        plan.events = events;
    }
}

/// No fault acts on the node or waits for its next bit.
fn is_quiet(node: &Node) -> bool {
    node.faults.is_quiet()
}

/// Where the edge of SOF puts the start of the bit.
fn hard_sync(node: &Node, at: u64) -> Fine {
    let mut clock = node.clock.clone();
    let at = Time::from_ps(at);
    clock.catch_up(at);
    match clock.edge(at, Sync::Hard, false) {
        Effect::Nothing | Effect::Moved { .. } => clock.start,
    }
}

/// The transmitter sees its own bits in time.
fn check_own_bits(config: &NodeConfig, plan: &Plan) -> Option<()> {
    let margin = u128::from(Tick::PICOSECOND);
    let loop_delay = u128::from(ps(config.tx_delay) + ps(config.rx_delay)) * margin + margin;
    let span = |segments: &Segments, quanta: u64| u128::from(segments.quantum.0) * u128::from(quanta);
    let (nominal, data) = (&plan.course.nominal, &plan.course.data);
    if loop_delay > span(nominal, nominal.before) {
        return None;
    }
    if plan.course.has_data_phase() {
        // Its last edge must have come back before the ACK slot begins; without compensation every bit before its own
        // sample point.
        let delimiter = span(data, data.before) + span(nominal, nominal.after);
        let limit = if config.delay_compensation.is_some() { delimiter } else { span(data, data.before) };
        if loop_delay > limit {
            return None;
        }
    }
    Some(())
}

/// The compensated delay in clock periods, `Some(None)` without compensation; `None` if a secondary sample point would
/// miss its bit.
fn transmitter_delay(node: &Node, plan: &Plan) -> Option<Option<u64>> {
    let (Some(compensation), Some(res)) = (node.config.delay_compensation, plan.course.layout.res) else {
        return Some(None);
    };
    let loop_delay = ps(node.config.tx_delay) + ps(node.config.rx_delay);
    let delay = match compensation.delay {
        DelaySource::Fixed(delay) => u64::from(delay),
        DelaySource::Measured { filter } => {
            let fell = plan.course.start(plan.sof, res);
            let back = Fine::from_time(Time::from_ps(fell.ceil() + loop_delay));
            let clock = node.clock.clock;
            let delay = back.ticks_since(fell, clock);
            if compensation.secondary_sample_point(delay) < u64::from(filter) {
                return None;
            }
            delay
        }
    };
    if plan.course.has_data_phase() {
        let margin = u128::from(Tick::PICOSECOND);
        let point = u128::from(compensation.secondary_sample_point(delay)) * u128::from(node.clock.clock.0);
        let earliest = u128::from(loop_delay) * margin + margin;
        let data = &plan.course.data;
        let latest = u128::from(data.quantum.0) * u128::from(data.bit()) + u128::from(loop_delay) * margin;
        if point < earliest || point + margin >= latest {
            return None;
        }
    }
    Some(Some(delay))
}
