//! No two fields wait for each other to become writable.

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::{FieldRef, RegisterId};

/// Most steps of the search for circles, which a description that is made to be hard could draw out.
const MAX_STEPS: usize = 1_000_000;

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
    let mut steps = MAX_STEPS;
    for start in order {
        let Some(circle) = circle(start, &waits, &mut steps) else { continue };
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

/// Leaves only what is in a circle or on a way from one circle to another.
fn reduce(waits: &mut Waits) {
    waits.values_mut().for_each(|needs| {
        needs.sort_unstable_by_key(|at| (at.register.0, at.field));
        needs.dedup();
    });
    take_ends(waits);
    let mut waited_for = reversed(waits);
    take_ends(&mut waited_for);
    waits.retain(|field, _| waited_for.contains_key(field));
}

fn reversed(edges: &Waits) -> Waits {
    let mut other = Waits::new();
    for (from, list) in edges {
        for to in list.iter().filter(|to| edges.contains_key(to)) {
            other.entry(*to).or_default().push(*from);
        }
    }
    other
}

/// Takes away, again and again, the fields that lead to no other.
fn take_ends(edges: &mut Waits) {
    let back = reversed(edges);
    let inside = |list: &Vec<FieldRef>| list.iter().filter(|to| edges.contains_key(to)).count();
    let mut open: HashMap<FieldRef, usize> = edges.iter().map(|(from, list)| (*from, inside(list))).collect();
    let mut ends: Vec<_> = open.iter().filter(|(_, count)| **count == 0).map(|(field, _)| *field).collect();
    while let Some(field) = ends.pop() {
        edges.remove(&field);
        for from in back.get(&field).into_iter().flatten() {
            if let Some(count) = open.get_mut(from) {
                *count -= 1;
                if *count == 0 {
                    ends.push(*from);
                }
            }
        }
    }
}

/// A shortest way from a field back to itself.
fn circle(start: FieldRef, waits: &Waits, steps: &mut usize) -> Option<Vec<FieldRef>> {
    let mut reached_from: HashMap<FieldRef, FieldRef> = HashMap::new();
    let mut next = std::collections::VecDeque::from([start]);
    while let Some(field) = next.pop_front() {
        for need in waits.get(&field).into_iter().flatten() {
            *steps = steps.checked_sub(1)?;
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
