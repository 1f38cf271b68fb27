//! From byte offsets to registers: windows, alias registers, reserved ranges.

use regbus::meta::{AliasOp, Controller};

use super::{Physical, RegisterFile, Slot};

/// What stands at a byte offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A byte of a register.
    Register {
        /// The register.
        slot: Slot,
        /// Which of its bytes, 0 for the least significant.
        byte: u8,
        /// The operation, if this is an alias register.
        alias: Option<AliasOp>,
    },
    /// A range that the description reserves: index into [`Controller::reserved`].
    Reserved(u16),
    /// Nothing that the description knows.
    Nothing,
}

#[derive(Clone, Copy, Debug)]
struct Candidate {
    window: Option<u8>,
    place: Place,
}

/// For every byte the registers that may be seen there.
#[derive(Clone, Debug)]
pub(super) struct Map {
    bytes: Vec<Vec<Candidate>>,
}

impl Map {
    pub(super) fn new(meta: &Controller, first: &[u16], physical: &[Physical]) -> Self {
        let mut bytes: Vec<Vec<Candidate>> = vec![Vec::new(); meta.span as usize];
        let mut add = |offset: u32, candidate: Candidate| {
            if bytes.len() <= offset as usize {
                bytes.resize(offset as usize + 1, Vec::new());
            }
            bytes[offset as usize].push(candidate);
        };
        debug_assert_eq!(first.len(), meta.registers.len());
        for (index, at) in physical.iter().enumerate() {
            let info = &meta.registers[at.register as usize];
            let Some(offset) = at.offset else { continue };
            let aliases = meta.aliases.iter().filter(|_| info.aliased).map(|alias| (alias.offset, Some(alias.op)));
            for (distance, alias) in core::iter::once((0, None)).chain(aliases) {
                for byte in 0..info.width / 8 {
                    let place = Place::Register { slot: Slot(index as u16), byte, alias };
                    add(offset + distance + u32::from(byte), Candidate { window: info.window, place });
                }
            }
        }
        for (index, range) in meta.reserved.iter().enumerate() {
            for offset in range.from..=range.to {
                add(offset, Candidate { window: range.window, place: Place::Reserved(index as u16) });
            }
        }
        Self { bytes }
    }

    #[inline]
    pub(super) fn place(&self, offset: u32, file: &RegisterFile) -> Place {
        let Some(candidates) = self.bytes.get(offset as usize) else { return Place::Nothing };
        let visible = |candidate: &&Candidate| {
            candidate.window.is_none_or(|window| {
                let window = &file.meta.windows[window as usize];
                file.field(file.field_at(window.select)) == window.value
            })
        };
        candidates.iter().find(visible).map_or(Place::Nothing, |candidate| candidate.place)
    }
}
