//! The pages that list one kind of thing: enumerations, conditions, joined values, effects, chips, conflicts, choices.

use minijinja::{Value, context};
use regdef::model::{ConditionId, EnumId, FieldRef, HalfOrder, Target};

use super::book::Book;
use super::field::{grouped, values};
use super::overview::anchor;
use super::text::{bit_range, hex, safe};
use super::xref::Xref;

/// Enumerations with their values and users.
pub(super) fn enums(book: &Book<'_>, xref: &Xref) -> Value {
    let one = |(index, one): (usize, &regdef::model::Enum)| {
        let id = EnumId(index);
        context! {
            id => anchor(&book.enumeration(id)), name => one.name.clone(), shared => one.shared, width => one.width,
            total => one.is_total(),
            doc => safe(book.paragraphs(&one.doc, None)), cites => safe(book.cites(&one.cites)),
            rows => values(book, one),
            mentions => grouped(xref.of_enum(id)),
        }
    };
    book.model.enums.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

/// Conditions with what they look at and what waits for them.
pub(super) fn conditions(book: &Book<'_>, xref: &Xref) -> Value {
    let one = |(index, condition): (usize, &regdef::model::Condition)| {
        let id = ConditionId(index);
        let mut fields: Vec<FieldRef> = Vec::new();
        for at in condition.expr.fields() {
            if !fields.contains(&at) {
                fields.push(at);
            }
        }
        let tree = condition.expr.display(book.model);
        let text = condition.text.as_str();
        context! {
            id => anchor(&book.condition(id)), name => condition.name.clone(), named => condition.named, text,
            tree => (tree != text).then_some(tree),
            doc => if condition.doc == text { Value::from(()) } else { safe(book.paragraphs(&condition.doc, None)) },
            cites => safe(book.cites(&condition.cites)),
            fields => fields.into_iter().map(|at| safe(book.field_link(at))).collect::<Vec<_>>(),
            mentions => grouped(xref.of_condition(id)),
        }
    };
    book.model.conditions.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

/// Values split over registers.
pub(super) fn joined(book: &Book<'_>, xref: &Xref) -> Value {
    let one = |(index, joined): (usize, &regdef::model::Joined)| {
        let parts = joined.parts.iter().map(|part| {
            let holder = match part.field {
                Some(field) => book.field_link(FieldRef { register: part.holder, field }),
                None => book.register_link(part.holder),
            };
            let holder_bits = bit_range(part.lsb, part.width);
            context! { bits => bit_range(part.shift, part.width), holder => safe(holder), holder_bits }
        });
        context! {
            id => anchor(&book.joined(index)), name => joined.name.clone(), width => joined.width,
            parts => parts.collect::<Vec<_>>(),
            doc => safe(book.paragraphs(&joined.doc, None)), cites => safe(book.cites(&joined.cites)),
            order => match joined.order {
                HalfOrder::LowFirst => "the part with the least significant bits first",
                HalfOrder::HighFirst => "the part with the most significant bits first",
            },
            cluster => joined.cluster.map(|c| context! { link => book.cluster(c), name => book.model.clusters[c.0].title.clone() }),
            mentions => grouped(xref.of_joined(index)),
        }
    };
    book.model.joined.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

/// What states do to registers.
pub(super) fn effects(book: &Book<'_>) -> Value {
    let one = |(index, effect): (usize, &regdef::model::Effect)| {
        let mut changes = Vec::new();
        for &id in &effect.resets {
            changes.push(format!("{} returns to its reset value", book.register_link(id)));
        }
        for &at in &effect.resets_fields {
            changes.push(format!("{} returns to its reset value", book.field_link(at)));
        }
        for &(target, origin) in &effect.loads {
            changes.push(format!("{} takes the value of {}", book.field_link(target), book.field_link(origin)));
        }
        for &(at, value) in &effect.sets {
            changes.push(format!("{} becomes <code>{value}</code>", book.field_link(at)));
        }
        context! {
            id => anchor(&book.effect(index)), on => safe(book.condition_link(effect.on)), holds => effect.holds,
            doc => safe(book.paragraphs(&effect.doc, None)), cites => safe(book.cites(&effect.cites)),
            changes => changes.into_iter().map(safe).collect::<Vec<_>>(),
        }
    };
    book.model.effects.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

/// Known chips.
pub(super) fn chips(book: &Book<'_>) -> Value {
    let one = |(index, chip): (usize, &regdef::model::Instance)| {
        context! {
            id => anchor(&book.instance(index)), name => chip.name.clone(), chips => chip.chips.clone(),
            base => hex(chip.base, 32),
            memory => chip.memory.map(|m| hex(m, 32)),
            interrupts => chip.interrupts.iter().map(|(name, number)| context! { name, number }).collect::<Vec<_>>(),
            doc => safe(book.inline(&chip.doc, None)), cites => safe(book.cites(&chip.cites)),
        }
    };
    book.model.instances.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

fn targets(book: &Book<'_>, at: &[Target]) -> Vec<Value> {
    at.iter().map(|&t| safe(book.target_link(t))).collect()
}

/// Contradictions of the manual.
pub(super) fn conflicts(book: &Book<'_>) -> Value {
    let one = |(index, conflict): (usize, &regdef::model::Conflict)| {
        let says = conflict.says.iter().map(|r| {
            context! { cite => safe(book.cites(std::slice::from_ref(&r.cite))), says => safe(book.inline(&r.says, None)) }
        });
        context! {
            id => anchor(&book.conflict(index)), what => safe(book.inline(&conflict.what, None)),
            at => targets(book, &conflict.at),
            says => says.collect::<Vec<_>>(), taken => safe(book.inline(&conflict.taken, None)),
            because => safe(book.inline(&conflict.because, None)),
        }
    };
    book.model.conflicts.iter().enumerate().map(one).collect::<Vec<_>>().into()
}

/// Silences of the manual.
pub(super) fn choices(book: &Book<'_>) -> Value {
    let one = |(index, choice): (usize, &regdef::model::Choice)| {
        context! {
            id => anchor(&book.choice(index)), name => choice.id.clone(),
            question => safe(book.inline(&choice.question, None)), at => targets(book, &choice.at),
            nearest => safe(book.inline(&choice.nearest, None)), choice => safe(book.inline(&choice.choice, None)),
            alternatives => choice.alternatives.iter().map(|a| safe(book.inline(a, None))).collect::<Vec<_>>(),
            because => safe(book.inline(&choice.because, None)), cites => safe(book.cites(&choice.cites)),
        }
    };
    book.model.choices.iter().enumerate().map(one).collect::<Vec<_>>().into()
}
