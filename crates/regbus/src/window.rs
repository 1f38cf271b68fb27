//! Register windows.

use core::marker::PhantomData;

use crate::bus::{Bus, Word};

/// A window that is open for as long as this value lives.
///
/// Opening it is one read-modify-write of the register that selects the window, closing it is another. Generated code
/// keeps it on the stack around a closure, so that it closes when the closure returns or unwinds.
#[derive(Debug)]
pub struct Bracket<W: Word, B: Bus> {
    bus: B,
    offset: usize,
    keep: u32,
    ones: u32,
    resting: u32,
    word: PhantomData<fn() -> W>,
}

impl<W: Word, B: Bus> Bracket<W, B> {
    /// Opens a window.
    ///
    /// `keep` are the bits of the selecting register that are written back as read, without the selecting field;
    /// `ones` are flags that have to be written as 1; `open` and `resting` are the selecting field's values in place.
    #[inline(always)]
    #[must_use = "the window closes when this value is dropped"]
    pub fn open(bus: B, offset: usize, keep: u32, ones: u32, open: u32, resting: u32) -> Self {
        let bracket = Self { bus, offset, keep, ones, resting, word: PhantomData };
        bracket.select(open);
        bracket
    }

    #[inline(always)]
    fn select(&self, value: u32) {
        let word = self.bus.read::<W>(self.offset).to_u32();
        self.bus.write(self.offset, W::from_u32((word & self.keep) | self.ones | value));
    }
}

impl<W: Word, B: Bus> Drop for Bracket<W, B> {
    #[inline(always)]
    fn drop(&mut self) {
        self.select(self.resting);
    }
}
