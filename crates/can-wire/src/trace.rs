//! What a run can be watched by.

use std::sync::{Arc, Mutex, PoisonError};

use crate::{BitRecord, Event, Level, NodeId, Time};

/// A line whose level a trace shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Signal {
    /// The bus.
    Bus,
    /// The transmit output of a node.
    Tx(NodeId),
    /// The receive input of a node.
    Rx(NodeId),
}

impl Signal {
    fn index(self) -> usize {
        match self {
            Signal::Bus => 0,
            Signal::Tx(node) => 1 + 2 * node.index(),
            Signal::Rx(node) => 2 + 2 * node.index(),
        }
    }
}

/// Something that watches a run: a file writer, a recorder, a checker.
///
/// Levels come in the order of time and, at equal times, of [`Signal`]; events likewise in the order of time. A signal
/// is recessive until its first change.
pub trait TraceSink {
    /// A signal has changed.
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        let _ = (time, signal, level);
    }

    /// A node has sampled a bit. Asked for with [`TraceSink::wants_bits`].
    fn bit(&mut self, bit: &BitRecord) {
        let _ = bit;
    }

    /// Something happened at a node. Comes when the caller of the wire gets it.
    fn event(&mut self, event: &Event) {
        let _ = event;
    }

    /// True to get every bit. The engine then takes no short cuts.
    fn wants_bits(&self) -> bool {
        false
    }

    /// True to get the levels of the signals.
    fn wants_levels(&self) -> bool {
        true
    }
}

/// A sink that is shared with the code that reads it.
impl<T: TraceSink> TraceSink for Arc<Mutex<T>> {
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        self.lock()
            .unwrap_or_else(PoisonError::into_inner)
            .level(time, signal, level);
    }

    fn bit(&mut self, bit: &BitRecord) {
        self.lock().unwrap_or_else(PoisonError::into_inner).bit(bit);
    }

    fn event(&mut self, event: &Event) {
        self.lock()
            .unwrap_or_else(PoisonError::into_inner)
            .event(event);
    }

    fn wants_bits(&self) -> bool {
        self.lock()
            .unwrap_or_else(PoisonError::into_inner)
            .wants_bits()
    }

    fn wants_levels(&self) -> bool {
        self.lock()
            .unwrap_or_else(PoisonError::into_inner)
            .wants_levels()
    }
}

/// Several sinks at once.
impl TraceSink for Vec<Box<dyn TraceSink + Send>> {
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        for sink in self.iter_mut().filter(|sink| sink.wants_levels()) {
            sink.level(time, signal, level);
        }
    }

    fn bit(&mut self, bit: &BitRecord) {
        for sink in self.iter_mut().filter(|sink| sink.wants_bits()) {
            sink.bit(bit);
        }
    }

    fn event(&mut self, event: &Event) {
        for sink in self {
            sink.event(event);
        }
    }

    fn wants_bits(&self) -> bool {
        self.iter().any(|sink| sink.wants_bits())
    }

    fn wants_levels(&self) -> bool {
        self.iter().any(|sink| sink.wants_levels())
    }
}

/// Hands level changes on in a defined order: those of one instant are sorted by signal, and only what has changed
/// over the instant is told.
#[derive(Default)]
pub(crate) struct Tracer {
    pub(crate) sink: Option<Box<dyn TraceSink + Send>>,
    pub(crate) levels: bool,
    pub(crate) bits: bool,
    at: u64,
    changes: Vec<(Signal, bool)>,
    /// Level told last, by [`Signal::index`].
    shown: Vec<bool>,
}

impl Tracer {
    pub(crate) fn set(
        &mut self,
        sink: Option<Box<dyn TraceSink + Send>>,
    ) -> Option<Box<dyn TraceSink + Send>> {
        self.flush();
        self.levels = sink.as_ref().is_some_and(|sink| sink.wants_levels());
        self.bits = sink.as_ref().is_some_and(|sink| sink.wants_bits());
        self.shown.clear();
        core::mem::replace(&mut self.sink, sink)
    }

    pub(crate) fn level(&mut self, at: u64, signal: Signal, level: bool) {
        if at != self.at {
            self.flush();
            self.at = at;
        }
        self.changes.push((signal, level));
    }

    /// Everything up to `now` has been told.
    pub(crate) fn flush_before(&mut self, now: u64) {
        if self.at < now {
            self.flush();
        }
    }

    fn flush(&mut self) {
        // Stable: of several changes of one signal the last one stays.
        self.changes.sort_by_key(|(signal, _)| *signal);
        let mut index = 0;
        while index < self.changes.len() {
            let (signal, level) = self.changes[index];
            index += 1;
            if self
                .changes
                .get(index)
                .is_some_and(|(next, _)| *next == signal)
            {
                continue;
            }
            let place = signal.index();
            if self.shown.len() <= place {
                self.shown.resize(place + 1, true);
            }
            let before = core::mem::replace(&mut self.shown[place], level);
            if let Some(sink) = self.sink.as_mut().filter(|_| before != level) {
                sink.level(Time::from_ps(self.at), signal, Level::from_bit(level));
            }
        }
        self.changes.clear();
    }
}
