//! Messages, conditions, effects, interrupts and the like.

use super::{Change, Line, Pair, add, compare, fields, matched, none};
use crate::model::{
    Effect, FieldRef, InterruptSource, Joined, Message, Model, RegisterId, ReservedRange, SectionStart, Word,
};

pub(super) fn messages(old: &Model, new: &Model, changes: &mut Vec<Change>) {
    for pair in matched(&old.messages, &new.messages, |m| m.name.clone(), |_, _| false) {
        match pair {
            Pair::Both(a, b) => {
                add(changes, format!("message `{}`", b.name), message(a, b));
                words(old, a, new, b, changes);
            }
            Pair::Old(a) => {
                add(changes, format!("message `{}`", a.name), vec![Line::Removed("the message".to_owned())])
            }
            Pair::New(b) => add(changes, format!("message `{}`", b.name), vec![Line::Added("the message".to_owned())]),
        }
    }
}

fn message(a: &Message, b: &Message) -> Vec<Line> {
    let mut lines = Vec::new();
    compare(&mut lines, "width of a word", &format!("{} bits", a.word_width), &format!("{} bits", b.word_width));
    let payload = |m: &Message| {
        m.payload.as_ref().map_or("none".to_owned(), |p| format!("at byte {:#x}, sizes {:?}", p.offset, p.sizes))
    };
    compare(&mut lines, "payload", &payload(a), &payload(b));
    let joined = |m: &Message| listed(&m.joined, |j| format!("{} ({} bits)", j.name, j.width));
    compare(&mut lines, "joined values", &joined(a), &joined(b));
    lines
}

fn words(old: &Model, a: &Message, new: &Model, b: &Message, changes: &mut Vec<Change>) {
    let present = |model: &Model, w: &Word| {
        w.present_when.map_or("always".to_owned(), |id| model.condition(id).expr.display(model))
    };
    for pair in matched(&a.words, &b.words, |w| w.name.clone(), |x, y| x.offset == y.offset) {
        let (name, lines) = match pair {
            Pair::Both(x, y) => {
                let mut lines = Vec::new();
                compare(&mut lines, "renamed", &format!("`{}`", x.name), &format!("`{}`", y.name));
                compare(&mut lines, "moved", &format!("byte {:#x}", x.offset), &format!("byte {:#x}", y.offset));
                compare(&mut lines, "has this layout if", &present(old, x), &present(new, y));
                lines.extend(fields(old, &x.fields, new, &y.fields));
                (&y.name, lines)
            }
            Pair::Old(x) => (&x.name, vec![Line::Removed(format!("the word at byte {:#x}", x.offset))]),
            Pair::New(y) => (&y.name, vec![Line::Added(format!("the word at byte {:#x}", y.offset))]),
        };
        add(changes, format!("word `{}.{name}`", b.name), lines);
    }
}

/// What has a name and can be said in one line.
pub(super) fn rest(old: &Model, new: &Model, changes: &mut Vec<Change>) {
    let conditions = |m: &Model| -> Vec<_> {
        m.conditions.iter().filter(|c| c.named).map(|c| (c.name.clone(), c.expr.display(m))).collect()
    };
    named(changes, "condition", conditions(old), conditions(new));
    let windows = |m: &Model| -> Vec<_> {
        m.windows.iter().map(|w| (w.name.clone(), format!("{} == {}", m.field_path(w.select), w.value))).collect()
    };
    named(changes, "window", windows(old), windows(new));
    let joined = |m: &Model| -> Vec<_> { m.joined.iter().map(|j| (j.name.clone(), joined_text(m, j))).collect() };
    named(changes, "joined value", joined(old), joined(new));
    let reserved = |m: &Model| -> Vec<_> {
        m.reserved.iter().map(|r| (format!("{:#05x}..={:#05x}", r.from, r.to), range(m, r))).collect()
    };
    named(changes, "reserved range", reserved(old), reserved(new));
    let effects = |m: &Model| -> Vec<_> { m.effects.iter().map(|e| effect(m, e)).collect() };
    named(changes, "effect of", effects(old), effects(new));
    let lines = |m: &Model| -> Vec<_> {
        let text =
            |l: &crate::model::InterruptLine| format!("enabled by {}, selected by {:?}", field(m, l.enable), l.select);
        m.interrupts.lines.iter().map(|l| (l.name.clone(), text(l))).collect()
    };
    named(changes, "interrupt line", lines(old), lines(new));
    let sources =
        |m: &Model| -> Vec<_> { m.interrupts.sources.iter().map(|s| (s.name.clone(), source(m, s))).collect() };
    named(changes, "interrupt source", sources(old), sources(new));
    let sections =
        |m: &Model| -> Vec<_> { m.memory.sections.iter().map(|s| (s.name.clone(), section(m, s))).collect() };
    named(changes, "memory section", sections(old), sections(new));
    let timing = |m: &Model| -> Vec<_> {
        m.bit_timing
            .iter()
            .flat_map(|t| [("nominal", Some(&t.nominal)), ("data", t.data.as_ref())])
            .filter_map(|(name, phase)| Some((name.to_owned(), phase?)))
            .map(|(name, p)| {
                let f = |at| m.field_path(at);
                let text = format!(
                    "prescaler {}, propagation {}, segments {} and {}, jump width {}, {} to {} quanta, phase segment 2 \
                     within {:?}, jump width below it {}, three samples {:?}",
                    f(p.prescaler),
                    field(m, p.propagation),
                    f(p.segment1),
                    f(p.segment2),
                    f(p.jump_width),
                    p.min_quanta,
                    p.max_quanta,
                    p.phase2_within,
                    p.jump_width_below_phase2,
                    p.three_samples.map(|(at, least)| (f(at), least)),
                );
                (name, text)
            })
            .collect()
    };
    named(changes, "bit timing", timing(old), timing(new));
    let delay = |m: &Model| -> Vec<_> {
        let text = |d: &crate::model::TransmitterDelay| {
            format!(
                "enabled by {}, offset {} counted as {:?}, filter {}, value {}, prescaler up to {:?}, position up to {:?}, \
                 fewer than {:?} data bits",
                m.field_path(d.enable),
                m.field_path(d.offset),
                d.reference,
                field(m, d.filter),
                field(m, d.value),
                d.max_prescaler,
                d.max_position,
                d.max_bits,
            )
        };
        let delay = m.bit_timing.iter().filter_map(|t| t.transmitter_delay.as_ref());
        delay.map(|d| ("compensation".to_owned(), text(d))).collect()
    };
    named(changes, "transmitter delay", delay(old), delay(new));
    let instances = |m: &Model| -> Vec<_> {
        let text = |i: &crate::model::Instance| {
            let interrupts = listed(&i.interrupts, |(name, n)| format!("{name} {n}"));
            format!("{} at {:#x}, interrupts {interrupts}", i.chips.join(", "), i.base)
        };
        m.instances.iter().map(|i| (i.name.clone(), text(i))).collect()
    };
    named(changes, "instance", instances(old), instances(new));
}

/// Compares two lists of names with their meaning in one line.
fn named(changes: &mut Vec<Change>, what: &str, old: Vec<(String, String)>, new: Vec<(String, String)>) {
    for pair in matched(&old, &new, |(name, _)| name.clone(), |a, b| a.1 == b.1) {
        let (name, line) = match pair {
            Pair::Both(a, b) if a == b => continue,
            Pair::Both(a, b) if a.0 != b.0 => (&b.0, Line::Changed(format!("renamed: `{}` → `{}`", a.0, b.0))),
            Pair::Both(a, b) => (&b.0, Line::Changed(format!("{} → {}", a.1, b.1))),
            Pair::Old(a) => (&a.0, Line::Removed(a.1.clone())),
            Pair::New(b) => (&b.0, Line::Added(b.1.clone())),
        };
        add(changes, format!("{what} `{name}`"), vec![line]);
    }
}

fn listed<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    none(items.iter().map(text).collect::<Vec<_>>().join(", "))
}

fn field(model: &Model, at: Option<FieldRef>) -> String {
    at.map_or("nothing".to_owned(), |at| model.field_path(at))
}

fn joined_text(model: &Model, joined: &Joined<RegisterId>) -> String {
    let part = |p: &crate::model::Part<RegisterId>| {
        let register = model.register(p.holder);
        p.field.map_or(register.name.clone(), |f| format!("{}.{}", register.name, register.fields[f].name))
    };
    format!("{}, {:?}", listed(&joined.parts, part), joined.order)
}

fn range(model: &Model, range: &ReservedRange) -> String {
    let reads = range.reads.map_or("not said".to_owned(), |v| format!("{v:#x}"));
    let window = range.window.map_or("all windows".to_owned(), |id| format!("window `{}`", model.windows[id.0].name));
    format!("in {window}, reads {reads}, sets {}", field(model, range.sets))
}

fn effect(model: &Model, effect: &Effect) -> (String, String) {
    let registers = listed(&effect.resets, |id| model.register(*id).name.clone());
    let resets = listed(&effect.resets_fields, |at| model.field_path(*at));
    let loads =
        listed(&effect.loads, |(to, from)| format!("{} from {}", model.field_path(*to), model.field_path(*from)));
    let sets = listed(&effect.sets, |(to, value)| format!("{} to {value}", model.field_path(*to)));
    let held = if effect.holds { ", held" } else { "" };
    let name = model.condition(effect.on).expr.display(model);
    (name, format!("resets {registers}; resets fields {resets}; loads {loads}; sets {sets}{held}"))
}

fn source(model: &Model, source: &InterruptSource) -> String {
    let lines = listed(&source.lines, |id| model.interrupts.lines[id.0].name.clone());
    let feeds = listed(&source.feeds, |id| model.interrupts.sources[id.0].name.clone());
    format!(
        "flag {}, enable {}, select {}, lines {lines}, feeds {feeds}, code {}",
        model.field_path(source.flag),
        field(model, source.enable),
        field(model, source.select),
        source.code.map_or("none".to_owned(), |(a, b)| if a == b { a.to_string() } else { format!("{a}..{b}") })
    )
}

fn section(model: &Model, section: &crate::model::Section) -> String {
    let elements = listed(&section.elements, |id| model.messages[id.0].name.clone());
    let start = match &section.start {
        SectionStart::Follows => "behind the one before".to_owned(),
        SectionStart::At { parts, unit } => {
            let names = listed(parts, |p| model.register(p.holder).name.clone());
            format!("at {names} × {unit}")
        }
    };
    let count = listed(&section.count, |at| model.field_path(*at));
    let max = section.max.map_or("no limit".to_owned(), |m| m.to_string());
    format!("{elements}, {start}, count {count}, at most {max}, payload size {}", field(model, section.payload_size))
}
