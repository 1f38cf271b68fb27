//! Measuring the transmitter delay.

use super::Node;
use crate::{DelayCompensation, DelaySource, Field, Time, time::Fine};

impl Node {
    /// ISO 11898-1:2015, 11.3.3: from the falling edge at the output to that at the input, in whole clock periods.
    pub(super) fn measure(&mut self, fell: Fine, at: Time) {
        let Some(compensation) = self.config.delay_compensation else {
            return;
        };
        let at = Fine::from_time(at);
        let mut delay = at.ticks_since(fell, self.clock.clock);
        delay += u64::from(at.rest_since(fell, self.clock.clock) > 0);
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
}
