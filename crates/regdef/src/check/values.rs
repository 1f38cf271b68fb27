//! Resets and enumerations make sense together.

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;

/// Most runs of values that one finding lists.
const MAX_LISTED: usize = 8;

/// A known reset is not a reserved or unnamed value.
pub(super) fn resets(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        for (field, path) in register.fields.iter().zip(&origin.fields) {
            let Some(id) = field.enumeration() else { continue };
            let entry = model.enumeration(id);
            let odd = (0..field.lane_count())
                .filter_map(|lane| field.reset_of_lane(register.reset, lane))
                .find(|value| entry.variant(*value).is_none());
            if let Some(value) = odd {
                let reserved = entry.reserved.iter().any(|(first, last)| (*first..=*last).contains(&value));
                let what = if reserved { "reserves" } else { "does not name" };
                findings.push(
                    Diagnostic::new(
                        Code::ResetReserved,
                        Spot::Key(path.clone()),
                        format!("`{}.{}` resets to {value}, which its enumeration {what}", register.name, field.name),
                    )
                    .help("if the manual says so, name the value for what it means at reset"),
                );
            }
        }
    }
}

/// Every value of a field is named or reserved.
pub(super) fn enumerations(lowered: &Lowered, findings: &mut Findings) {
    for (entry, path) in lowered.model.enums.iter().zip(&lowered.enums) {
        if entry.width == 0 || entry.width > 16 {
            continue;
        }
        let mut runs: Vec<(u64, u64)> = entry.variants.iter().map(|v| (v.first, v.last)).collect();
        runs.extend(&entry.reserved);
        runs.sort_unstable();
        let mut next = 0;
        let mut holes = Vec::new();
        let end = 1 << entry.width;
        let mut listed = 0;
        for (first, last) in runs.into_iter().chain([(end, end)]) {
            if first > next && listed == MAX_LISTED {
                holes.push("more".to_owned());
                break;
            }
            if first > next {
                listed += 1;
                holes.push(if first - 1 == next { next.to_string() } else { format!("{next}..{}", first - 1) });
            }
            next = next.max(last.saturating_add(1));
        }
        if holes.is_empty() {
            continue;
        }
        let list = holes.join(", ");
        findings.push(
            Diagnostic::new(
                Code::UnnamedValues,
                Spot::Key(path.clone()),
                format!("the enumeration `{}` says nothing about {list}", entry.name),
            )
            .help(format!("add `\"{}\": reserved` if these values must not be used", holes[0])),
        );
    }
}
