//! Bit timing.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{BitTiming, Clock, TimingPhase, TransmitterDelay};
use crate::path::Path;
use crate::syntax;

impl Lowering<'_> {
    pub(super) fn bit_timing(&mut self) {
        let text = self.text;
        let Some(timing) = &text.bit_timing else { return };
        let at = Path::root().key("bit_timing");
        let clock_at = at.key("clock");
        let cites = self.cite(timing.clock.cite.as_ref(), &clock_at);
        let clock = Clock {
            name: timing.clock.name.clone(),
            divider: timing.clock.divider.unwrap_or(1),
            max_hz: timing.clock.max_hz.map(|v| v.0),
            doc: timing.clock.doc.clone().unwrap_or_default(),
            cites,
        };
        let nominal = self.timing_phase(&timing.nominal, &at.key("nominal"));
        let data = timing.data.as_ref().and_then(|phase| self.timing_phase(phase, &at.key("data")));
        let transmitter_delay = timing.transmitter_delay.as_ref().and_then(|tdc| {
            let at = at.key("transmitter_delay");
            let cites = self.cite(tdc.cite.as_ref(), &at);
            Some(TransmitterDelay {
                enable: self.field_ref(&tdc.enable, &at.key("enable"))?,
                offset: self.field_ref(&tdc.offset, &at.key("offset"))?,
                filter: tdc.filter.as_ref().and_then(|f| self.field_ref(f, &at.key("filter"))),
                value: tdc.value.as_ref().and_then(|f| self.field_ref(f, &at.key("value"))),
                reference: tdc.reference,
                max_prescaler: tdc.max_prescaler.map(|v| v.0),
                max_position: tdc.max_position.map(|v| v.0),
                max_bits: tdc.max_bits.map(|v| v.0),
                rules: tdc.rules.clone(),
                cites,
            })
        });
        self.out.model.bit_timing = nominal.map(|nominal| BitTiming { clock, nominal, data, transmitter_delay });
    }

    fn timing_phase(&mut self, phase: &syntax::TimingPhase, at: &Path) -> Option<TimingPhase> {
        let cites = self.cite(phase.cite.as_ref(), at);
        let mut field = |name: &str, key: &str| self.field_ref(name, &at.key(key));
        let prescaler = field(&phase.prescaler, "prescaler");
        let propagation = phase.propagation.as_ref().map(|f| field(f, "propagation"));
        let segment1 = field(&phase.segment1, "segment1");
        let segment2 = field(&phase.segment2, "segment2");
        let jump_width = field(&phase.jump_width, "jump_width");
        let three_samples = phase.three_samples.as_ref().map(|samples| {
            let field = self.field_ref(&samples.field, &at.key("three_samples").key("field"))?;
            Some((field, samples.min_prescaler.map_or(1, |v| v.0)))
        });
        let (Some(min), Some(max)) = (phase.quanta.min, phase.quanta.max) else {
            self.find(
                Diagnostic::new(
                    Code::MissingKey,
                    Spot::Key(at.key("quanta")),
                    "the time quanta of a bit need `min` and `max`",
                )
                .help("write `quanta: {min: 4, max: 385}`"),
            );
            return None;
        };
        if min > max {
            let title = format!("no bit has between {} and {} time quanta", min.0, max.0);
            self.find(
                Diagnostic::new(Code::BadRange, Spot::Value(at.key("quanta")), title)
                    .help("`min` is the smaller number"),
            );
        }
        Some(TimingPhase {
            prescaler: prescaler?,
            propagation: match propagation {
                Some(field) => Some(field?),
                None => None,
            },
            segment1: segment1?,
            segment2: segment2?,
            jump_width: jump_width?,
            min_quanta: min.0,
            max_quanta: max.0,
            rules: phase.rules.clone(),
            max_bit_rate: phase.max_bit_rate.map(|v| v.0),
            phase2_within: phase.phase2_within,
            jump_width_below_phase2: phase.jump_width_below_phase2,
            three_samples: match three_samples {
                Some(samples) => Some(samples?),
                None => None,
            },
            cites,
        })
    }
}
