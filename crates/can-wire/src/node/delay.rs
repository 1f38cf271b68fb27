//! Transmitter delay compensation of a node: the measurement, and the secondary sample points.

use super::{Late, Node};
use crate::{DelayCompensation, DelaySource, EventKind, Field, Level, Position, Time, protocol::Context, time::Fine};

impl Node {
    /// ISO 11898-1:2015, 11.3.3: from the falling edge at the output to that at the input, rounded down to whole
    /// clock periods.
    pub(super) fn measure(&mut self, fell: Fine, at: Time) {
        let Some(compensation) = self.config.delay_compensation else {
            return;
        };
        let at = Fine::from_time(at);
        let delay = at.ticks_since(fell, self.clock.clock);
        if let DelaySource::Measured { filter } = compensation.delay
            && compensation.secondary_sample_point(delay) < u64::from(filter)
        {
            self.early_edge = true;
            return;
        }
        self.measuring = None;
        self.delay = Some(delay);
    }

    /// An edge came before the filter window was over. Where the input is still dominant when it is, the measurement
    /// ends there; a shorter dominant time was a glitch.
    pub(super) fn end_filter_window(&mut self, now: Time) {
        let (Some(fell), Some(compensation)) = (self.measuring, self.config.delay_compensation) else {
            return;
        };
        let DelaySource::Measured { filter } = compensation.delay else {
            return;
        };
        let passed = Fine::from_time(now).ticks_since(fell, self.clock.clock);
        if core::mem::take(&mut self.early_edge) && compensation.secondary_sample_point(passed) >= u64::from(filter) {
            self.measuring = None;
            let delay = i64::from(filter) - i64::from(compensation.offset);
            self.delay = Some(delay.max(0) as u64);
        }
    }

    pub(super) fn starts_measurement(&self) -> bool {
        self.protocol.sending
            && self.protocol.field == Field::Res
            && self.protocol.incoming.fd
            && matches!(
                self.config.delay_compensation,
                Some(DelayCompensation { delay: DelaySource::Measured { .. }, .. })
            )
    }

    /// The secondary sample points that are due.
    pub(super) fn compare_late(&mut self, now: u64) {
        while let Some(late) = self.late.front().copied().filter(|late| late.at.ceil() <= now) {
            self.late.pop_front();
            if self.rx != late.level && self.late_error.is_none() {
                self.late_error = Some((late.position, Level::from_bit(late.level)));
            }
        }
    }

    /// Bits of the data phase are compared at their secondary sample points.
    pub(super) fn prepare_late_sample(&mut self, sampled: Position, cx: &mut Context<'_>) {
        let Some(compensation) = self.config.delay_compensation else {
            return;
        };
        let brs = sampled.field == Field::Brs && !sampled.stuff && self.protocol.sending;
        if brs && self.early_edge {
            self.end_filter_window(cx.now);
        }
        let delay = match compensation.delay {
            DelaySource::Fixed(delay) => u64::from(delay),
            // An edge that has not come back yet is beyond every limit.
            DelaySource::Measured { .. } => self.delay.unwrap_or(u64::from(u16::MAX)),
        };
        let secondary = compensation.secondary_sample_point(delay);
        if brs {
            self.measuring = None;
            self.early_edge = false;
            cx.emit(EventKind::TransmitterDelay {
                delay: delay.min(u64::from(u16::MAX)) as u16,
                secondary_sample_point: secondary as u16,
            });
        }
        if !self.protocol.relies_on_own_bits() {
            self.late.clear();
        } else if self.protocol.field != Field::CrcDelimiter || self.protocol.stuff_next {
            self.late.push_back(Late {
                at: self.clock.start.plus(secondary, self.clock.clock),
                level: self.protocol.drive,
                position: self.protocol.position(),
            });
        }
    }
}
