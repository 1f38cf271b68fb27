//! A whole run in memory.

use crate::{BitRecord, Event, Level, Signal, Time, TraceSink};

/// Keeps everything that can be watched of a run, to be looked at and written afterwards.
///
/// While it watches, the engine works out every bit, and memory grows with every one of them: about 100 bytes per bit and
/// node. For long runs attach the writers themselves.
#[derive(Clone, Debug, Default)]
pub struct Recording {
    levels: Vec<(Time, Signal, Level)>,
    bits: Vec<BitRecord>,
    events: Vec<Event>,
}

impl Recording {
    /// An empty recording.
    #[must_use]
    pub fn new() -> Recording {
        Recording::default()
    }

    /// Changes of levels, in the order of time.
    #[must_use]
    pub fn levels(&self) -> &[(Time, Signal, Level)] {
        &self.levels
    }

    /// The bits of all nodes, in the order of their sample points.
    #[must_use]
    pub fn bits(&self) -> &[BitRecord] {
        &self.bits
    }

    /// What happened, in the order of time.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Shows a sink what was recorded from a time on, as if it had watched then: a level, a bit and an event of one
    /// instant in this order.
    pub fn replay(&self, from: Time, sink: &mut dyn TraceSink) {
        let mut levels = self.levels.iter().filter(|(time, ..)| *time >= from).peekable();
        let mut bits = self.bits.iter().filter(|bit| bit.sample >= from).peekable();
        let mut events = self.events.iter().filter(|event| event.time >= from).peekable();
        loop {
            let level = levels.peek().map(|(time, ..)| *time);
            let bit = bits.peek().map(|bit| bit.sample);
            let event = events.peek().map(|event| event.time);
            let Some(next) = [level, bit, event].into_iter().flatten().min() else { return };
            if level == Some(next) {
                levels.next().inspect(|(time, signal, level)| sink.level(*time, *signal, *level));
            } else if bit == Some(next) {
                bits.next().inspect(|bit| sink.bit(bit));
            } else {
                events.next().inspect(|event| sink.event(event));
            }
        }
    }
}

impl TraceSink for Recording {
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        self.levels.push((time, signal, level));
    }

    fn bit(&mut self, bit: &BitRecord) {
        self.bits.push(*bit);
    }

    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }

    fn wants_bits(&self) -> bool {
        true
    }
}
