//! What happened, as data: the recording of the bus, what the drivers did, and what can be asked of both.

use std::{ops::Range, path::PathBuf};

use can_frame::Frame;
use can_hal::{Events, Status, timing::BitTiming};
use can_sim::AccessRecord;
use can_wire::{
    BitRecord, BusError, ErrorState, Event, EventKind, Field, NodeId, Position, Role, Time, output::Recording,
};

/// Bits of a base identifier.
const BASE_ID_BITS: u32 = 11;

/// A node of the bus.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name in the story.
    pub name: &'static str,
    /// What it is: the title of its controller's description.
    pub title: &'static str,
    /// Its place among the nodes of the bus.
    pub id: NodeId,
    /// Its clock in hertz.
    pub clock: u32,
    /// How much faster the clock really is, in parts per million.
    pub ppm: i32,
    /// Bit timing, for a node with registers.
    pub timing: Option<BitTiming>,
}

/// A part of the story.
#[derive(Clone, Debug)]
pub struct Act {
    /// Its title.
    pub title: &'static str,
    /// When it begins.
    pub from: Time,
    /// When the next one begins.
    pub until: Time,
}

/// What was injected.
#[derive(Clone, Debug)]
pub struct Injected {
    /// When it was given to the bus; it waits for its bit from then on.
    pub time: Time,
    /// The victim: an index into [`Story::nodes`].
    pub node: usize,
    /// The bit.
    pub position: Position,
    /// For how many of the victim's frames.
    pub frames: u32,
    /// When it was taken away.
    pub until: Option<Time>,
}

/// What a driver did.
#[derive(Clone, Debug)]
pub enum Deed {
    /// It has configured its controller.
    Configured,
    /// It has started it and enabled its interrupts.
    Started,
    /// It has given the controller a frame.
    Sent(Frame),
    /// It has served an interrupt.
    Served {
        /// What the flags stand for.
        events: Events,
        /// What it has fetched.
        received: Vec<Frame>,
        /// Which of its frames are sent.
        sent: Vec<Frame>,
        /// What it has read, if it had a reason to.
        status: Option<Status>,
    },
    /// It has looked at the state while bus off.
    Looked(Status),
    /// It has begun the recovery from bus off.
    Restarted,
    /// It has enabled or disabled the interrupt for single errors.
    ReportsErrors(bool),
}

/// One step of a driver with its accesses to registers.
#[derive(Clone, Debug)]
pub struct Step {
    /// When it began.
    pub time: Time,
    /// Whose driver: an index into [`Story::nodes`].
    pub node: usize,
    /// What it did.
    pub deed: Deed,
    /// The accesses.
    pub records: Vec<AccessRecord>,
}

/// One attempt of a node to send a frame.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// Who: an index into [`Story::nodes`].
    pub node: usize,
    /// Start of its start of frame.
    pub from: Time,
    /// When its fate was known.
    pub until: Time,
    /// The identifier that it drove; where it has lost arbitration, that of its next attempt.
    pub id: u32,
    /// What came of it.
    pub fate: Fate,
}

/// What came of an attempt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It was sent.
    Sent(Frame),
    /// It lost arbitration at this bit.
    Lost(Position),
    /// An error has ended it.
    Failed(BusError),
}

/// What a node does for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// It sends, from start to end of frame.
    Sends,
    /// It receives.
    Receives,
    /// It sends an active error flag, or an overload flag.
    ActiveFlag,
    /// It sends a passive error flag.
    PassiveFlag,
    /// It sends the delimiter after a flag.
    Delimiter,
    /// It waits for 8 bits because it is error passive and has sent the frame before.
    Suspends,
    /// It waits for 11 recessive bits.
    Integrates,
    /// It is off the bus for its errors, or on its way back.
    BusOff,
    /// Intermission and idle.
    Rests,
    /// It takes no part.
    Off,
}

/// A time in which a node does one thing.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// What.
    pub doing: Doing,
    /// Start of its first bit.
    pub from: Time,
    /// Start of the bit after it.
    pub until: Time,
    /// It sends or receives in the data phase, at the faster rate, during this range.
    pub fast: Option<(Time, Time)>,
}

/// Error counters from a time on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// From when.
    pub time: Time,
    /// Transmit error counter.
    pub tec: u16,
    /// Receive error counter.
    pub rec: u16,
}

/// The whole story.
#[derive(Clone, Debug)]
pub struct Story {
    /// The nodes; the first is the one that is disturbed.
    pub nodes: Vec<Node>,
    /// Nominal bit rate in bit/s.
    pub rate: u32,
    /// Bit rate of the data phase in bit/s, if FD frames are used.
    pub data_rate: Option<u32>,
    /// How long the driver waits before it restarts a node that is bus off.
    pub pause: Time,
    /// The parts.
    pub acts: Vec<Act>,
    /// What was injected.
    pub faults: Vec<Injected>,
    /// What the drivers did.
    pub steps: Vec<Step>,
    /// What happened on the bus.
    pub recording: Recording,
    /// What the drivers did wrong.
    pub diagnostics: Vec<String>,
    /// The end.
    pub end: Time,
    /// What was written.
    pub files: Vec<PathBuf>,
}

impl Story {
    /// The events of a node.
    pub fn events(&self, node: usize) -> impl Iterator<Item = &Event> {
        let id = self.nodes[node].id;
        self.recording.events().iter().filter(move |event| event.node == id)
    }

    /// The bits of a node.
    pub fn bits(&self, node: usize) -> impl Iterator<Item = &BitRecord> {
        let id = self.nodes[node].id;
        self.recording.bits().iter().filter(move |bit| bit.node == id)
    }

    /// The error counters of a node over time, beginning with 0 and 0 at the start.
    #[must_use]
    pub fn counts(&self, node: usize) -> Vec<Count> {
        let mut counts = vec![Count { time: Time::ZERO, tec: 0, rec: 0 }];
        counts.extend(self.events(node).filter_map(|event| match event.kind {
            EventKind::Counters { tec, rec } => Some(Count { time: event.time, tec, rec }),
            _ => None,
        }));
        counts
    }

    /// The error counters of a node at a time, after what happens at it.
    #[must_use]
    pub fn count_at(&self, node: usize, time: Time) -> Count {
        let counts = self.counts(node);
        let after = counts.partition_point(|count| count.time <= time);
        counts[after.saturating_sub(1)]
    }

    /// The error states of a node, each with the time it begins.
    #[must_use]
    pub fn states(&self, node: usize) -> Vec<(Time, ErrorState)> {
        let mut states = vec![(Time::ZERO, ErrorState::Active)];
        states.extend(self.events(node).filter_map(|event| match event.kind {
            EventKind::ErrorState { to, .. } => Some((event.time, to)),
            _ => None,
        }));
        states
    }

    /// Every attempt to send a frame, in the order of its start.
    #[must_use]
    pub fn attempts(&self) -> Vec<Attempt> {
        let mut attempts = Vec::new();
        for node in 0..self.nodes.len() {
            let mut sof = None;
            for event in self.events(node) {
                let fate = match event.kind {
                    EventKind::StartOfFrame { role: Role::Transmitter } => {
                        sof = Some(event.time);
                        continue;
                    }
                    EventKind::Transmitted { frame, .. } => Fate::Sent(frame),
                    EventKind::ArbitrationLost { position } => Fate::Lost(position),
                    EventKind::TransmissionFailed(error) => Fate::Failed(error),
                    _ => continue,
                };
                let Some(sampled) = sof.take() else { continue };
                attempts.push(self.attempt(node, sampled, event.time, fate));
            }
        }
        attempts.sort_by_key(|attempt| attempt.from);
        for index in 0..attempts.len() {
            let Fate::Lost(position) = attempts[index].fate else { continue };
            let (node, seen) = (attempts[index].node, attempts[index].id);
            // Where it lost only the first bits were sent; the rest is in its next attempt, if that begins alike.
            let next = attempts[index + 1..].iter().find(|attempt| attempt.node == node).map(|attempt| attempt.id);
            let rest = BASE_ID_BITS.saturating_sub(u32::from(position.bit) + 1);
            if let Some(id) = next.filter(|id| position.field == Field::BaseId && id >> rest == seen) {
                attempts[index].id = id;
            }
        }
        attempts
    }

    fn attempt(&self, node: usize, sampled: Time, until: Time, fate: Fate) -> Attempt {
        let bits = self.bits(node).filter(|bit| bit.sample >= sampled && bit.sample <= until);
        let (mut from, mut id) = (sampled, 0);
        for bit in bits {
            if bit.sample == sampled {
                from = bit.start;
            }
            let in_id = matches!(bit.position.field, Field::BaseId | Field::ExtendedId) && !bit.position.stuff;
            if in_id {
                id = id << 1 | u32::from(bit.driven.bit());
            }
        }
        Attempt { node, from, until, id, fate }
    }

    /// What a node does, from beginning to end.
    #[must_use]
    pub fn spans(&self, node: usize) -> Vec<Span> {
        let mut spans: Vec<Span> = Vec::new();
        let mut fast_from = None;
        for bit in self.bits(node) {
            let flag = if bit.driven.is_dominant() { Doing::ActiveFlag } else { Doing::PassiveFlag };
            let before = spans.last().map(|span| span.doing);
            let doing = match (bit.position.field, bit.role) {
                (Field::Off, _) => Doing::Off,
                (Field::BusOff, _) => Doing::BusOff,
                (Field::Integration, _) => Doing::Integrates,
                (Field::Idle | Field::Intermission, _) => Doing::Rests,
                (Field::Suspend, _) => Doing::Suspends,
                // The rest of a flag is what its first bit is.
                (Field::ErrorFlag | Field::OverloadFlag, _) if bit.position.bit > 0 => before.unwrap_or(flag),
                (Field::ErrorFlag | Field::OverloadFlag, _) => flag,
                (Field::ErrorDelimiter | Field::OverloadDelimiter, _) => Doing::Delimiter,
                // A node that suspends its transmission stays transmitter until another one begins.
                (Field::Sof, Role::Transmitter) if !bit.driven.is_dominant() => Doing::Receives,
                (_, Role::Transmitter) => Doing::Sends,
                (_, Role::Receiver) => Doing::Receives,
            };
            if let Some(last) = spans.last_mut() {
                last.until = bit.start;
            }
            let sof = bit.position.field == Field::Sof;
            if before != Some(doing) || sof {
                spans.push(Span { doing, from: bit.start, until: bit.start, fast: None });
            }
            match bit.position.field {
                // The rate changes at the sample point of BRS and back at that of the CRC delimiter.
                Field::Brs if !bit.position.stuff && bit.seen.bit() => fast_from = Some(bit.sample),
                Field::CrcDelimiter => {
                    if let (Some(from), Some(span)) = (fast_from.take(), spans.last_mut()) {
                        span.fast = Some((from, bit.sample));
                    }
                }
                field if !field.is_in_frame() => fast_from = None,
                _ => {}
            }
        }
        if let Some(last) = spans.last_mut() {
            last.until = self.end;
        }
        for (from, until) in self.bus_off(node) {
            spans.retain(|span| span.from < from || span.from >= until);
            let before = spans.partition_point(|span| span.from < from);
            if let Some(last) = before.checked_sub(1).and_then(|last| spans.get_mut(last)) {
                last.until = last.until.min(from);
            }
            spans.insert(before, Span { doing: Doing::BusOff, from, until, fast: None });
        }
        spans
    }

    /// When a node is bus off: from, until.
    #[must_use]
    pub fn bus_off(&self, node: usize) -> Vec<(Time, Time)> {
        let states = self.states(node);
        let ends = states.iter().skip(1).map(|(time, _)| *time).chain([self.end]);
        let periods = states.iter().zip(ends);
        periods
            .filter(|((_, state), _)| *state == ErrorState::BusOff)
            .map(|((from, _), until)| (*from, until))
            .collect()
    }

    /// The bits that a fault has hit, from its injection to its end.
    #[must_use]
    pub fn hits(&self, fault: &Injected) -> Vec<&BitRecord> {
        let until = fault.until.unwrap_or(self.end);
        self.bits(fault.node).filter(|bit| bit.faulty && bit.start >= fault.time && bit.start < until).collect()
    }

    /// The act in which something happens.
    #[must_use]
    pub fn act_at(&self, time: Time) -> usize {
        self.acts.partition_point(|act| act.from <= time).saturating_sub(1)
    }

    /// Time of an act.
    #[must_use]
    pub fn range(&self, act: usize) -> Range<Time> {
        self.acts[act].from..self.acts[act].until
    }
}
