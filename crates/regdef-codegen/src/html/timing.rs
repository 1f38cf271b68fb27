//! The page of the bit timing.

use minijinja::{Value, context};
use regdef::model::{BitTiming, FieldRef, TimingPhase, TransmitterDelay};

use super::book::Book;
use super::field;
use super::text::safe;

/// The fields of a phase with what they are, in words.
pub(super) fn roles(phase: &TimingPhase) -> Vec<(FieldRef, &'static str)> {
    let all = [
        (Some(phase.prescaler), "prescaler"),
        (phase.propagation, "propagation segment"),
        (
            Some(phase.segment1),
            if phase.propagation.is_some() { "phase segment 1" } else { "propagation and phase segment 1" },
        ),
        (Some(phase.segment2), "phase segment 2"),
        (Some(phase.jump_width), "synchronization jump width"),
        (phase.three_samples.map(|(at, _)| at), "sampling three times"),
    ];
    all.into_iter().filter_map(|(at, role)| Some((at?, role))).collect()
}

/// The fields of the transmitter delay compensation with what they are, in words.
pub(super) fn delay_roles(delay: &TransmitterDelay) -> Vec<(FieldRef, &'static str)> {
    let all = [
        (Some(delay.enable), "enable"),
        (Some(delay.offset), "offset"),
        (delay.filter, "filter window"),
        (delay.value, "value"),
    ];
    all.into_iter().filter_map(|(at, role)| Some((at?, role))).collect()
}

/// What the page of the bit timing shows.
pub(super) fn view(book: &Book<'_>, timing: &BitTiming) -> Value {
    let rows = |roles: Vec<(FieldRef, &'static str)>| -> Vec<Value> {
        roles
            .into_iter()
            .map(|(at, role)| {
                let field = book.model.field(at);
                context! {
                    role, link => safe(book.field_link(at)), bits => field.width,
                    programmed => format!("{} to {}", field.min, field.max),
                    means => field::meaning_of_limits(field), doc => safe(book.inline(&field.doc, Some(at.register))),
                }
            })
            .collect()
    };
    let rules = |rules: &[String]| -> Vec<Value> { rules.iter().map(|r| safe(book.inline(r, None))).collect() };
    let phase = |phase: &TimingPhase, id: &str, title: &str| {
        context! {
            id, title, rows => rows(roles(phase)), rules => rules(&phase.rules),
            quanta => format!("{} to {}", phase.min_quanta, phase.max_quanta),
            rate => phase.max_bit_rate.map(frequency).map(|r| r.replace("Hz", "bit/s")),
            cites => safe(book.cites(&phase.cites)),
        }
    };
    let mut phases = vec![phase(&timing.nominal, "nominal", "Nominal phase")];
    phases.extend(timing.data.as_ref().map(|data| phase(data, "data", "Data phase")));
    let clock = &timing.clock;
    context! {
        clock => context! {
            name => clock.name.clone(), divider => clock.divider, max => clock.max_hz.map(frequency),
            doc => safe(book.paragraphs(&clock.doc, None)), cites => safe(book.cites(&clock.cites)),
        },
        phases,
        delay => timing.transmitter_delay.as_ref().map(|delay| context! {
            rows => rows(delay_roles(delay)), rules => rules(&delay.rules), cites => safe(book.cites(&delay.cites)),
        }),
    }
}

/// `80 MHz`, `500 kHz`, `1 Hz`.
pub(super) fn frequency(hz: u64) -> String {
    let (unit, per) = match hz {
        1_000_000.. => ("MHz", 1_000_000),
        1_000.. => ("kHz", 1_000),
        _ => ("Hz", 1),
    };
    let whole = hz / per;
    let rest = format!("{:06}", (hz % per) * 1_000_000 / per);
    let rest = rest.trim_end_matches('0');
    let point = if rest.is_empty() { "" } else { "." };
    format!("{whole}{point}{rest} {unit}")
}

#[cfg(test)]
mod tests {
    use super::frequency;

    #[test]
    fn frequencies_are_readable() {
        assert_eq!(frequency(80_000_000), "80 MHz");
        assert_eq!(frequency(12_500_000), "12.5 MHz");
        assert_eq!(frequency(500_000), "500 kHz");
    }
}
