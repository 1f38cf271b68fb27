//! The story in lines: what is worth telling, in the order of time.

use can_frame::Frame;
use can_hal::Events;
use can_wire::{ErrorKind, ErrorState, Event, EventKind, Field, Position, Time};

use crate::{
    Story,
    play::MOTOR,
    story::{Attempt, Deed, Fate},
};

/// What kind of thing a line tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A frame was sent.
    Sent,
    /// Arbitration was lost.
    Lost,
    /// Attempts have failed.
    Failed,
    /// A fault was injected or taken away.
    Fault,
    /// The error state has changed, or the warning limit was crossed.
    State,
    /// A driver did something about it.
    Driver,
}

/// One line.
#[derive(Clone, Debug)]
pub struct Moment {
    /// When.
    pub time: Time,
    /// Who: an index into [`Story::nodes`].
    pub node: usize,
    /// What kind of thing.
    pub kind: Kind,
    /// What, in words.
    pub text: String,
    /// The error state that begins, for [`Kind::State`].
    pub state: Option<ErrorState>,
    /// Transmit error counter of the disturbed node afterwards.
    pub tec: u16,
}

/// Error counter from which a node is warned of (ISO 11898-1:2015, 12.1.4.4).
pub const WARNING: u16 = 96;
/// Error counter from which a node is error passive.
pub const PASSIVE: u16 = 128;
/// Transmit error counter from which a node is bus off.
pub const BUS_OFF: u16 = 256;

/// A bit of a frame in words: `data bit 20`.
#[must_use]
pub fn place(position: Position) -> String {
    let field = match position.field {
        Field::BaseId => "identifier",
        Field::Data => "data",
        field => field.short_name(),
    };
    let stuff = if position.stuff { "the stuff bit before " } else { "" };
    format!("{stuff}{field} bit {}", position.bit)
}

/// Kind of an error in words.
#[must_use]
pub const fn error(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::Bit0 | ErrorKind::Bit1 => "bit error",
        ErrorKind::Stuff => "stuff error",
        ErrorKind::Form => "form error",
        ErrorKind::Ack => "acknowledgement error",
        ErrorKind::Crc => "CRC error",
    }
}

/// Identifier and data of a frame.
#[must_use]
pub fn frame(frame: &Frame) -> String {
    let id = if frame.is_extended() { format!("{:08X}", frame.raw_id()) } else { format!("{:03X}", frame.raw_id()) };
    let bytes: Vec<String> = frame.data_bytes().iter().map(|byte| format!("{byte:02X}")).collect();
    match (frame.is_fd(), frame.is_remote()) {
        (_, true) => format!("{id}  remote"),
        (true, _) if frame.bit_rate_switch() => format!("{id}  FD, {} bytes at the faster rate", bytes.len()),
        (true, _) => format!("{id}  FD, {} bytes", bytes.len()),
        _ => format!("{id}  {}", bytes.join(" ")),
    }
}

/// Everything worth telling.
#[must_use]
pub fn moments(story: &Story) -> Vec<Moment> {
    let mut all = Vec::new();
    let attempts = story.attempts();
    sent(story, &attempts, &mut all);
    failed(story, &attempts, &mut all);
    for fault in &story.faults {
        let name = story.nodes[fault.node].name;
        let place = place(fault.position);
        let text = match fault.frames {
            1 => format!("fault: {place} of {name}'s next frame is inverted"),
            _ => format!("fault: {place} of every frame of {name} is inverted"),
        };
        all.push(moment(story, fault.time, fault.node, Kind::Fault, text));
        if let Some(until) = fault.until.filter(|_| fault.frames > 1) {
            all.push(moment(story, until, fault.node, Kind::Fault, String::from("the fault is repaired")));
        }
    }
    for node in 0..story.nodes.len() {
        states(story, node, &mut all);
    }
    drivers(story, &mut all);
    all.sort_by_key(|moment| moment.time);
    let all = merged(all);
    all.into_iter().map(|(moment, count)| said(story, moment, count)).collect()
}

fn moment(story: &Story, time: Time, node: usize, kind: Kind, text: String) -> Moment {
    Moment { time, node, kind, text, state: None, tec: story.count_at(MOTOR, time).tec }
}

fn sent(story: &Story, attempts: &[Attempt], all: &mut Vec<Moment>) {
    for attempt in attempts {
        match attempt.fate {
            Fate::Sent(sent) => {
                let mut line = moment(story, attempt.from, attempt.node, Kind::Sent, frame(&sent));
                line.tec = story.count_at(MOTOR, attempt.until).tec;
                all.push(line);
            }
            Fate::Lost(position) => {
                let winner = attempts.iter().find(|other| {
                    matches!(other.fate, Fate::Sent(_)) && other.from < attempt.until && other.until > attempt.until
                });
                let to = winner.map_or_else(String::new, |other| {
                    format!(" to {}'s {:03X}", story.nodes[other.node].name, other.id)
                });
                let text = format!("loses arbitration{to} at {}", place(position));
                all.push(moment(story, attempt.until, attempt.node, Kind::Lost, text));
            }
            Fate::Failed(_) => {}
        }
    }
}

fn failed(story: &Story, attempts: &[Attempt], all: &mut Vec<Moment>) {
    for attempt in attempts {
        let Fate::Failed(failure) = attempt.fate else { continue };
        let text = format!("{:03X}  {} at {}", attempt.id, error(failure.kind), place(failure.position));
        all.push(moment(story, attempt.until, attempt.node, Kind::Failed, text));
    }
}

fn states(story: &Story, node: usize, all: &mut Vec<Moment>) {
    let mut before = 0;
    for count in story.counts(node) {
        let highest = count.tec.max(count.rec);
        if before < WARNING && (WARNING..PASSIVE).contains(&highest) {
            let text = format!("crosses the warning limit of {WARNING}");
            all.push(moment(story, count.time, node, Kind::State, text));
        }
        before = highest;
    }
    for (time, state) in story.states(node).into_iter().skip(1) {
        let sequences = story.events(node).filter(|event| event.time <= time).filter_map(|event: &Event| {
            if let EventKind::RecoverySequence { count } = event.kind { Some(count) } else { None }
        });
        let text = match (state, sequences.last()) {
            (ErrorState::Active, Some(count)) => format!("has seen {count} times 11 recessive bits: error active"),
            _ => format!("is {state}"),
        };
        all.push(Moment { state: Some(state), ..moment(story, time, node, Kind::State, text) });
    }
}

fn drivers(story: &Story, all: &mut Vec<Moment>) {
    let mut off = None;
    for step in &story.steps {
        match &step.deed {
            Deed::Served { events, status: Some(status), .. } if events.contains(Events::BUS_OFF) => {
                off = status.is_bus_off().then_some(step.time);
            }
            Deed::Restarted => {
                let waited = off.map_or(Time::ZERO, |off| step.time.since(off));
                let text = format!("its driver restarts it, {} after bus off", milliseconds(waited));
                all.push(moment(story, step.time, step.node, Kind::Driver, text));
            }
            _ => {}
        }
    }
}

/// Failures and equal frames that follow each other become one line, with how many there were.
fn merged(all: Vec<Moment>) -> Vec<(Moment, usize)> {
    let mut lines: Vec<(Moment, usize)> = Vec::new();
    for moment in all {
        if let Some((last, count)) = lines.last_mut() {
            let mergeable = matches!(moment.kind, Kind::Failed | Kind::Sent);
            if mergeable && (last.node, last.kind, &last.text) == (moment.node, moment.kind, &moment.text) {
                *count += 1;
                last.tec = moment.tec;
                continue;
            }
        }
        lines.push((moment, 1));
    }
    lines
}

fn said(story: &Story, mut moment: Moment, count: usize) -> Moment {
    let others = || {
        let others = story.nodes.iter().enumerate().filter(|(index, _)| *index != moment.node);
        let heard = others.filter(|(index, _)| {
            story.events(*index).any(|event| {
                matches!(event.kind, EventKind::Received { sof, .. } if sof >= moment.time
                    && sof.since(moment.time) <= Time::from_us(1_000_000 / u64::from(story.rate).max(1)))
            })
        });
        heard.map(|(_, node)| node.name).collect::<Vec<_>>().join(", ")
    };
    match moment.kind {
        Kind::Sent => {
            let times = if count > 1 { format!(" ({count} times)") } else { String::new() };
            let text = format!("{}{times} → {}", moment.text, others());
            moment.text = text;
        }
        Kind::Failed if count > 1 => moment.text += &format!(", {count} times in a row"),
        _ => {}
    }
    moment
}

/// A time in milliseconds with two digits after the point.
#[must_use]
pub fn milliseconds(time: Time) -> String {
    let hundredths = (time.as_ns() + 5_000) / 10_000;
    format!("{}.{:02} ms", hundredths / 100, hundredths % 100)
}

/// A bit rate in its usual unit.
#[must_use]
pub fn bit_rate(rate: u32) -> String {
    match rate {
        1_000_000.. if rate.is_multiple_of(1_000_000) => format!("{} Mbit/s", rate / 1_000_000),
        1_000.. if rate.is_multiple_of(1_000) => format!("{} kbit/s", rate / 1_000),
        _ => format!("{rate} bit/s"),
    }
}
