//! A log in the format of `candump -l`.

use std::io;

use can_frame::LogLine;

use super::Tap;
use crate::{Event, TraceSink};

/// Writes frames as a candump log, their time counted from the start of the simulation.
pub struct CandumpLog<W: io::Write> {
    output: W,
    tap: Tap,
    interfaces: Vec<String>,
    error: Option<io::Error>,
}

impl<W: io::Write> CandumpLog<W> {
    /// A log of what `tap` shows of a wire of `nodes` nodes.
    #[must_use]
    pub fn new(output: W, tap: Tap, nodes: usize) -> CandumpLog<W> {
        CandumpLog {
            output,
            tap,
            interfaces: tap.interfaces(nodes),
            error: None,
        }
    }

    /// Flushes; reports the first error met on the way.
    ///
    /// # Errors
    /// If the output could not be written, now or earlier.
    pub fn finish(&mut self) -> io::Result<()> {
        match self.error.take() {
            Some(error) => Err(error),
            None => self.output.flush(),
        }
    }
}

impl<W: io::Write> TraceSink for CandumpLog<W> {
    fn event(&mut self, event: &Event) {
        let Some((interface, frame, direction)) = self.tap.record(event) else {
            return;
        };
        let Some(interface) = self.interfaces.get(interface) else {
            return;
        };
        let line = LogLine {
            nanoseconds: event.time.as_ns(),
            interface,
            frame,
            direction,
        };
        if self.error.is_none() {
            self.error = writeln!(self.output, "{line}").err();
        }
    }

    fn wants_levels(&self) -> bool {
        false
    }
}
