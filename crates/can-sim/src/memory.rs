//! Message memory: words that the test owns, that controllers read and write, and that the host reaches over a bus.

use crate::diagnostic::Bits;

/// A memory of a [`crate::Sim`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MemoryId(pub(crate) usize);

/// Word-organized memory.
#[derive(Clone, Debug)]
pub struct Memory {
    words: Vec<u32>,
    widths: &'static [u8],
}

impl Memory {
    /// Memory of `words` 32-bit words, all 0, that takes word accesses only: what every M_CAN can be connected to.
    #[must_use]
    pub fn new(words: usize) -> Self {
        Self { words: vec![0; words], widths: &[32] }
    }

    /// The same memory with other legal access widths in bits, as system RAM has them.
    #[must_use]
    pub const fn with_widths(mut self, widths: &'static [u8]) -> Self {
        self.widths = widths;
        self
    }

    /// Legal access widths in bits.
    #[must_use]
    pub const fn widths(&self) -> &'static [u8] {
        self.widths
    }

    /// Number of 32-bit words.
    #[must_use]
    pub fn len(&self) -> usize {
        self.words.len()
    }

    /// True if there are no words.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// The words.
    #[must_use]
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// The words, to be filled by a test.
    pub fn words_mut(&mut self) -> &mut [u32] {
        &mut self.words
    }

    /// A word by its number; `None` behind the end.
    #[inline]
    #[must_use]
    pub fn word(&self, index: usize) -> Option<u32> {
        self.words.get(index).copied()
    }

    /// Sets a word by its number. Returns false behind the end.
    #[inline]
    pub fn set_word(&mut self, index: usize, value: u32) -> bool {
        let word = self.words.get_mut(index);
        word.map(|word| *word = value).is_some()
    }

    /// Reads `width` bits at a byte offset that is a multiple of the width.
    pub(crate) fn read(&self, offset: usize, width: Bits) -> Option<u32> {
        let word = self.word(offset / 4)?;
        Some(word >> (offset % 4 * 8) & width.mask())
    }

    /// Writes `width` bits at a byte offset that is a multiple of the width.
    pub(crate) fn write(&mut self, offset: usize, width: Bits, value: u32) -> bool {
        let Some(word) = self.words.get_mut(offset / 4) else { return false };
        let shift = offset % 4 * 8;
        *word = *word & !(width.mask() << shift) | (value & width.mask()) << shift;
        true
    }
}
