//! What the descriptions say about sections.

use regbus::meta::{Controller, Section};

use super::{LayoutError, Placed, SectionName};

/// A section of a description.
#[derive(Clone, Copy)]
pub(super) struct Facts {
    controller: &'static Controller,
    section: &'static Section,
}

impl Facts {
    /// The section of a name, for constants of this crate.
    pub(super) const fn of(controller: &'static Controller, name: &str) -> Self {
        let mut i = 0;
        while i < controller.sections.len() {
            if same(controller.sections[i].name, name) {
                return Self { controller, section: &controller.sections[i] };
            }
            i += 1;
        }
        panic!("the description has no such section")
    }

    pub(super) const fn name(&self) -> &'static str {
        self.section.name
    }

    /// Most elements.
    pub(super) const fn max(&self) -> u32 {
        match self.section.max {
            Some(max) => max,
            None => u32::MAX,
        }
    }

    /// What the first field that counts the elements holds for so many of them.
    pub(super) const fn count_code(&self, elements: u32) -> u32 {
        if self.section.count.is_empty() {
            return elements;
        }
        elements.saturating_add_signed(-self.count_field().add)
    }

    /// Fewest elements.
    pub(super) const fn min(&self) -> u32 {
        if self.section.count.is_empty() {
            return 0;
        }
        let field = self.count_field();
        field.min.saturating_add_signed(field.add)
    }

    const fn count_field(&self) -> &'static regbus::meta::Field {
        let at = self.section.count[0];
        &self.controller.registers[at.register as usize].fields[at.field as usize]
    }

    /// How many such sections there are, and the number of the first.
    pub(super) const fn repeated(&self) -> (usize, u8) {
        match self.controller.registers[self.section.count[0].register as usize].cluster {
            Some(array) => (array.count as usize, array.first as u8),
            None => (1, 0),
        }
    }

    /// Bytes in an element of one of the section's layouts, with a payload of so many bytes if it has one. The layouts are
    /// counted in the order of the description.
    pub(super) const fn element_bytes(&self, layout: usize, payload: u32) -> u32 {
        let message = &self.controller.messages[self.section.elements[layout] as usize];
        let mut bytes = match message.payload {
            Some(data) => data.offset + payload,
            None => message.header_bytes,
        };
        // Words behind the payload count too.
        let mut i = 0;
        while i < message.words.len() {
            let end = message.words[i].offset + message.word_width as u32 / 8;
            if end > bytes {
                bytes = end;
            }
            i += 1;
        }
        bytes
    }

    /// The payload of elements whose size cannot be chosen.
    pub(super) const fn only_payload(&self, layout: usize) -> u32 {
        match self.controller.messages[self.section.elements[layout] as usize].payload {
            Some(data) => data.sizes[0],
            None => 0,
        }
    }

    /// What start addresses are multiples of, in bytes.
    pub(super) const fn alignment(&self) -> u32 {
        if self.section.start.is_empty() {
            return 1;
        }
        let part = self.section.start[0];
        let fields = self.controller.registers[part.holder as usize].fields;
        // Bits of the part below the lowest field do not exist and read 0.
        let (mut lowest, mut i) = (part.lsb + part.width - 1, 0);
        while i < fields.len() {
            if fields[i].lsb >= part.lsb && fields[i].lsb < lowest {
                lowest = fields[i].lsb;
            }
            i += 1;
        }
        self.section.start_unit << (lowest - part.lsb)
    }

    /// Bytes that start addresses reach.
    pub(super) const fn window(&self) -> u64 {
        let (mut bits, mut i) = (0, 0);
        while i < self.section.start.len() {
            bits += self.section.start[i].width as u32;
            i += 1;
        }
        (self.section.start_unit as u64) << bits
    }

    /// The start address as the register's fields hold it.
    pub(super) const fn start_code(&self, start: u32) -> u32 {
        start / self.section.start_unit
    }

    /// Checks a number of elements.
    pub(super) const fn check_elements(&self, section: SectionName, requested: u32) -> Result<(), LayoutError> {
        if requested < self.min() || requested > self.max() {
            return Err(LayoutError::Elements { section, requested, min: self.min(), max: self.max() });
        }
        Ok(())
    }

    /// Checks a number of elements that a field selects by a code.
    pub(super) const fn check_count(&self, section: SectionName, requested: u32) -> Result<(), LayoutError> {
        if requested > self.max() {
            return Err(LayoutError::Elements { section, requested, min: 0, max: self.max() });
        }
        Ok(())
    }

    /// Checks the alignment of a start address.
    pub(super) const fn check_start(&self, section: SectionName, start: u32) -> Result<(), LayoutError> {
        let alignment = self.alignment();
        if !start.is_multiple_of(alignment) {
            return Err(LayoutError::Unaligned { section, start, alignment });
        }
        Ok(())
    }
}

/// Checks that a section ends within the RAM, and within what addresses reach.
pub(super) const fn check_end(placed: &Placed, ram_end: u64, window: u64) -> Result<(), LayoutError> {
    if placed.elements == 0 {
        return Ok(());
    }
    if placed.end() > window {
        return Err(LayoutError::Unreachable { section: *placed, end: window });
    }
    if placed.end() > ram_end {
        return Err(LayoutError::TooLarge { section: *placed, end: ram_end });
    }
    Ok(())
}

pub(super) const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() != b.len() {
        return false;
    }
    let mut i = 0;
    while i < a.len() {
        if a[i] != b[i] {
            return false;
        }
        i += 1;
    }
    true
}
