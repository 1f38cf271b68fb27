//! Parts of values that are split over several registers.

use crate::bits;
use crate::bus::{Bus, Word};

/// One part of a joined value: a field of a register or a whole register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Half {
    /// Byte offset of the register.
    pub offset: usize,
    /// Least significant bit in the register.
    pub lsb: u32,
    /// Number of bits.
    pub width: u32,
    /// Position in the joined value.
    pub shift: u32,
}

impl Half {
    /// Reads the register and takes the part to its place in the joined value.
    #[inline(always)]
    #[must_use]
    pub fn read<W: Word, B: Bus>(self, bus: B) -> u64 {
        self.of(bus.read::<W>(self.offset).to_u32())
    }

    /// The part of a register's word at its place in the joined value.
    #[inline(always)]
    #[must_use]
    pub const fn of(self, word: u32) -> u64 {
        (bits::get(word, self.lsb, self.width) as u64) << self.shift
    }

    /// A register's word with its part replaced by that of a joined value.
    #[inline(always)]
    #[must_use]
    pub const fn into(self, word: u32, joined: u64) -> u32 {
        bits::put(word, self.lsb, self.width, (joined >> self.shift) as u32)
    }

    /// Writes a register that holds nothing but the part: one store.
    #[inline(always)]
    pub fn write<W: Word, B: Bus>(self, bus: B, joined: u64) {
        bus.write(self.offset, W::from_u32(self.into(0, joined)));
    }

    /// Replaces the part in a register that holds other fields too: one load and one store. `keep` and `ones` are those of
    /// [`Modify`](crate::Modify).
    #[inline(always)]
    pub fn modify<W: Word, B: Bus>(self, bus: B, joined: u64, keep: u32, ones: u32) {
        let word = bus.read::<W>(self.offset).to_u32() & keep;
        bus.write(self.offset, W::from_u32(self.into(word, joined) | ones));
    }
}
