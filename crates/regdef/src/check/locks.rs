//! No two fields wait for each other to become writable.

use std::collections::{HashMap, HashSet};

use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::lower::Lowered;
use crate::model::FieldRef;
use crate::model::RegisterId;

pub(super) fn conditions(lowered: &Lowered, findings: &mut Vec<Diagnostic>) {
    let model = &lowered.model;
    let mut waits: HashMap<FieldRef, Vec<FieldRef>> = HashMap::new();
    let mut order = Vec::new();
    for (index, register) in model.registers.iter().enumerate() {
        for (field_index, field) in register.fields.iter().enumerate() {
            let Some(id) = field.access.when else { continue };
            let at = FieldRef { register: RegisterId(index), field: field_index };
            let needs = model.condition(id).expr.fields();
            waits.insert(at, needs.into_iter().filter(|need| *need != at).collect());
            order.push(at);
        }
    }
    let mut reported = HashSet::new();
    for start in order {
        if reported.contains(&start) {
            continue;
        }
        let Some(circle) = circle(start, &waits) else { continue };
        reported.extend(circle.iter().copied());
        let origin = &lowered.registers[start.register.0];
        let names: Vec<_> = circle.iter().chain([&start]).map(|f| model.field_path(*f)).collect();
        findings.push(
            Diagnostic::new(
                Code::ConditionLock,
                Spot::Key(origin.fields[start.field].clone()),
                format!("`{}` is writable only when fields allow it that wait for it themselves", model.field_path(start)),
            )
            .label(names.join(" → "))
            .help("if the reset state does not fulfil the conditions, none of these fields can ever be written"),
        );
    }
}

/// The shortest way from a field back to itself.
fn circle(start: FieldRef, waits: &HashMap<FieldRef, Vec<FieldRef>>) -> Option<Vec<FieldRef>> {
    let mut seen = HashSet::new();
    let mut trails = vec![vec![start]];
    while !trails.is_empty() {
        let mut next = Vec::new();
        for trail in trails {
            for need in waits.get(&trail[trail.len() - 1]).into_iter().flatten() {
                if *need == start {
                    return Some(trail);
                }
                if seen.insert(*need) {
                    let mut longer = trail.clone();
                    longer.push(*need);
                    next.push(longer);
                }
            }
        }
        trails = next;
    }
    None
}
