//! No two fields wait for each other to become writable.

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::{FieldRef, RegisterId};

/// Most fields whose circles are searched for: each search can lead through all others.
const MAX_SEARCHES: usize = 1000;

/// Which fields a field waits for.
type Waits = HashMap<FieldRef, Vec<FieldRef>>;

pub(super) fn conditions(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let mut waits = Waits::new();
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
    reduce(&mut waits);
    let left: Vec<_> = order.into_iter().filter(|field| waits.contains_key(field)).take(MAX_SEARCHES).collect();
    for start in left {
        let Some(circle) = circle(start, &waits) else { continue };
        // One finding for each circle: its fields need not be looked at again.
        for field in &circle {
            waits.remove(field);
        }
        let origin = &lowered.registers[start.register.0];
        let names: Vec<_> = circle.iter().chain([&start]).map(|f| model.field_path(*f)).collect();
        findings.push(
            Diagnostic::new(
                Code::ConditionLock,
                Spot::Key(origin.fields[start.field].clone()),
                format!(
                    "`{}` is writable only when fields allow it that wait for it themselves",
                    model.field_path(start)
                ),
            )
            .label(names.join(" → "))
            .help("if the reset state does not fulfil the conditions, none of these fields can ever be written"),
        );
    }
}

/// Takes away, again and again, the fields that wait for nothing that waits: what is left is circles and the ways
/// into them.
fn reduce(waits: &mut Waits) {
    let mut waiting_for: Waits = HashMap::new();
    let mut open: HashMap<FieldRef, usize> = HashMap::new();
    for (field, needs) in waits.iter() {
        let needs: Vec<_> = needs.iter().filter(|need| waits.contains_key(need)).collect();
        open.insert(*field, needs.len());
        for need in needs {
            waiting_for.entry(*need).or_default().push(*field);
        }
    }
    let mut free: Vec<_> = open.iter().filter(|(_, count)| **count == 0).map(|(field, _)| *field).collect();
    while let Some(field) = free.pop() {
        waits.remove(&field);
        for waiting in waiting_for.get(&field).into_iter().flatten() {
            if let Some(count) = open.get_mut(waiting) {
                *count -= 1;
                if *count == 0 {
                    free.push(*waiting);
                }
            }
        }
    }
}

/// A shortest way from a field back to itself.
fn circle(start: FieldRef, waits: &Waits) -> Option<Vec<FieldRef>> {
    let mut reached_from: HashMap<FieldRef, FieldRef> = HashMap::new();
    let mut next = std::collections::VecDeque::from([start]);
    while let Some(field) = next.pop_front() {
        for need in waits.get(&field).into_iter().flatten() {
            if *need == start {
                let mut trail = vec![field];
                while trail[trail.len() - 1] != start {
                    trail.push(reached_from[&trail[trail.len() - 1]]);
                }
                trail.reverse();
                return Some(trail);
            }
            if waits.contains_key(need) && !reached_from.contains_key(need) {
                reached_from.insert(*need, field);
                next.push_back(*need);
            }
        }
    }
    None
}
