//! One frame as text: fields, stuff bits, what every node drove and saw.

use core::fmt::{self, Write as _};

use super::FrameCapture;
use crate::{BitRecord, Event, EventKind, Field, Level, NodeId, Time};

/// Columns of the text.
const WIDTH: usize = 118;
/// Columns of the row names.
const NAMES: usize = 14;

/// Bits of one field, or of one data byte, as the reference node counts them.
pub(super) struct Group {
    pub(super) field: Field,
    /// Data byte, for the data field.
    pub(super) byte: Option<u16>,
    /// Indices into the reference node's bits.
    pub(super) first: usize,
    pub(super) end: usize,
}

impl FrameCapture {
    /// The frame as text, one column per bit of the reference node: the fields with their values, the start of each
    /// field in microseconds after the start of frame, and for every node what it drove and what it saw.
    ///
    /// `0` is dominant, `1` recessive; stuff bits are the letters `o` and `i`. A bit with an injected fault is marked
    /// in a row of its own, and so are the things that happened, below.
    #[must_use]
    pub fn timeline(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write_timeline(&mut text);
        text
    }

    fn write_timeline(&self, text: &mut String) -> fmt::Result {
        let reference: Vec<&BitRecord> = self.of(self.reference).collect();
        let Some(first) = reference.first() else {
            return writeln!(text, "no frame");
        };
        writeln!(text, "{} start of frame at {}, seen by {}", self.title(), first.start, self.reference)?;
        let nodes = self.nodes();
        let columns: Vec<Vec<Option<&BitRecord>>> = nodes.iter().map(|node| self.align(*node, &reference)).collect();
        let groups = groups(&reference);
        let mut rest = &groups[..];
        while !rest.is_empty() {
            let mut used = NAMES;
            let mut count = 0;
            while let Some(group) = rest.get(count) {
                used += self.width(group, &reference) + 1;
                if used > WIDTH && count > 0 {
                    break;
                }
                count += 1;
            }
            let (line, after) = rest.split_at(count);
            rest = after;
            writeln!(text)?;
            self.write_line(text, line, &reference, &nodes, &columns)?;
        }
        writeln!(text, "\n0 dominant, 1 recessive, o and i the same as stuff bits, ! injected fault")?;
        for event in self.events.iter().filter(|event| is_worth_telling(event)) {
            writeln!(text, "{event}")?;
        }
        Ok(())
    }

    pub(super) fn title(&self) -> String {
        let frame = self.events.iter().find_map(|event| match event.kind {
            EventKind::Transmitted { frame, .. } | EventKind::Received { frame, .. } => Some(frame),
            _ => None,
        });
        frame.map_or_else(|| String::from("an incomplete frame,"), |frame| format!("{frame},"))
    }

    fn write_line(
        &self,
        text: &mut String,
        line: &[Group],
        reference: &[&BitRecord],
        nodes: &[NodeId],
        columns: &[Vec<Option<&BitRecord>>],
    ) -> fmt::Result {
        let start = reference[0].start;
        let row = |text: &mut String, name: &str, cell: &dyn Fn(&Group) -> String| {
            let mut out = format!("{name:NAMES$}");
            for group in line {
                let _ = write!(out, "|{:<width$}", cell(group), width = self.width(group, reference));
            }
            writeln!(text, "{out}|")
        };
        row(text, "", &|group| label(group, reference))?;
        row(text, "us", &|group| microseconds(reference[group.first].start.since(start)))?;
        for (node, bits) in nodes.iter().zip(columns) {
            row(text, &format!("{node} drives"), &|group| letters(&bits[group.first..group.end], |bit| bit.driven))?;
            row(text, &format!("{node} sees"), &|group| letters(&bits[group.first..group.end], |bit| bit.seen))?;
            let in_line = line.iter().flat_map(|group| &bits[group.first..group.end]);
            if in_line.flatten().any(|bit| bit.faulty) {
                let mark = |bit: &Option<&BitRecord>| {
                    if bit.is_some_and(|bit| bit.faulty) { '!' } else { ' ' }
                };
                row(text, "", &|group| bits[group.first..group.end].iter().map(mark).collect())?;
            }
        }
        Ok(())
    }

    fn width(&self, group: &Group, reference: &[&BitRecord]) -> usize {
        let start = reference[0].start;
        let time = microseconds(reference[group.first].start.since(start)).len();
        (group.end - group.first).max(label(group, reference).len()).max(time)
    }

    /// The bits of a node, each in the column of the reference bit that begins nearest to it.
    fn align<'a>(&'a self, node: NodeId, reference: &[&BitRecord]) -> Vec<Option<&'a BitRecord>> {
        let mut columns = vec![None; reference.len()];
        for bit in self.of(node) {
            let after = reference.partition_point(|other| other.start < bit.start);
            let nearest = match after {
                0 => 0,
                _ if after == reference.len() => after - 1,
                _ => {
                    let (before, next) = (reference[after - 1].start, reference[after].start);
                    if bit.start.since(before) <= next.since(bit.start) { after - 1 } else { after }
                }
            };
            if columns[nearest].is_none() {
                columns[nearest] = Some(bit);
            }
        }
        columns
    }
}

/// Splits the bits of the reference node into fields and data bytes.
pub(super) fn groups(reference: &[&BitRecord]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (index, bit) in reference.iter().enumerate() {
        let byte = (bit.position.field == Field::Data).then_some(bit.position.bit / 8);
        match groups.last_mut() {
            Some(group) if group.field == bit.position.field && group.byte == byte && !restarts(bit) => {
                group.end = index + 1;
            }
            _ => groups.push(Group { field: bit.position.field, byte, first: index, end: index + 1 }),
        }
    }
    groups
}

/// A second error flag right after the first is a field of its own.
fn restarts(bit: &BitRecord) -> bool {
    bit.position.bit == 0 && matches!(bit.position.field, Field::ErrorFlag | Field::OverloadFlag)
}

/// Name and, where the field is a number, its value.
pub(super) fn label(group: &Group, reference: &[&BitRecord]) -> String {
    let value = || {
        let bits = reference[group.first..group.end].iter().filter(|bit| !bit.position.stuff);
        bits.fold(0u64, |value, bit| value << 1 | u64::from(bit.seen.bit()))
    };
    let whole = || reference[group.first..group.end].iter().filter(|bit| !bit.position.stuff).count() == 8;
    match (group.field, group.byte) {
        // A byte that an error has cut short has no value.
        (Field::Data, Some(byte)) if !whole() => format!("D{byte}"),
        (Field::Data, Some(byte)) => format!("D{byte}={:02X}", value()),
        (Field::BaseId, _) => format!("ID={:03X}", value()),
        (Field::ExtendedId, _) => format!("ID-ext={:05X}", value()),
        (Field::Dlc | Field::Crc, _) => format!("{}={:X}", group.field, value()),
        _ => group.field.to_string(),
    }
}

fn microseconds(time: Time) -> String {
    let ns = time.as_ns();
    format!("{}.{:03}", ns / 1_000, ns % 1_000).trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn letters(bits: &[Option<&BitRecord>], level: impl Fn(&BitRecord) -> Level) -> String {
    let letter = |bit: &Option<&BitRecord>| match bit {
        None => ' ',
        Some(bit) => match (level(bit), bit.position.stuff) {
            (Level::Dominant, false) => '0',
            (Level::Recessive, false) => '1',
            (Level::Dominant, true) => 'o',
            (Level::Recessive, true) => 'i',
        },
    };
    bits.iter().map(letter).collect()
}

fn is_worth_telling(event: &Event) -> bool {
    !matches!(event.kind, EventKind::StartOfFrame { .. } | EventKind::BusIdle)
}
