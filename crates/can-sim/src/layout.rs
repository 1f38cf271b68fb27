//! Where the sections of message memory lie, worked out from the registers by the description.

use regbus::meta::Section;

use crate::registers::RegisterFile;

/// A section of message memory as the registers place it. Addresses in bytes from the start of the memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Name in the description.
    pub name: &'static str,
    /// Address of the first element.
    pub start: u32,
    /// Bytes of one element.
    pub element: u32,
    /// Number of elements.
    pub count: u32,
}

impl Placed {
    /// First address behind the section.
    #[must_use]
    pub const fn end(&self) -> u32 {
        self.start + self.element * self.count
    }

    /// Address of an element.
    #[must_use]
    pub const fn address(&self, index: u32) -> u32 {
        self.start + self.element * index
    }
}

/// The sections in the order of the description. A section whose number of elements no register tells has as many as
/// `uncounted` says for its name.
#[must_use]
pub fn sections(registers: &RegisterFile, uncounted: impl Fn(&str) -> u32) -> Vec<Placed> {
    let meta = registers.meta();
    let exists = |section: &&Section| section.exists_when.is_none_or(|condition| registers.holds(condition, None));
    let mut end = 0;
    let mut placed = Vec::new();
    for section in meta.sections.iter().filter(exists) {
        let max = section.max.unwrap_or(u32::MAX);
        let count = match section.count {
            [] => uncounted(section.name),
            // A field beyond the largest number counts as the largest number.
            fields => fields.iter().map(|field| registers.field(registers.field_at(*field)).min(max)).sum(),
        };
        let start = if section.start.is_empty() { end } else { start(registers, section) };
        let message = section.elements.first().map(|index| &meta.messages[*index as usize]);
        let code = section.payload_size.map_or(0, |field| registers.field(registers.field_at(field)) as usize);
        let payload = message.and_then(|message| message.payload).and_then(|payload| payload.sizes.get(code).copied());
        let element = message.map_or(0, |message| message.header_bytes) + payload.unwrap_or(0);
        let section = Placed { name: section.name, start, element, count: count.min(max) };
        end = section.end();
        placed.push(section);
    }
    placed
}

fn start(registers: &RegisterFile, section: &Section) -> u32 {
    let part = |part: &regbus::meta::Part| {
        let field = regbus::meta::FieldRef { register: part.holder, field: 0 };
        let word = registers.get(registers.field_at(field).slot());
        regbus::bits::get(word, u32::from(part.lsb), u32::from(part.width)) << part.shift
    };
    section.start.iter().map(part).sum::<u32>() * section.start_unit
}
