//! Data bytes of message elements.

use core::marker::PhantomData;

use crate::bus::{Bus, Word};

/// The data bytes of a message element in memory.
///
/// Every access is one volatile access of a whole word `W`, never of a byte: memories of CAN controllers are written
/// word by word, and a byte write can corrupt the rest of the word. Byte 0 is in the low byte of the first word.
#[derive(Clone, Copy, Debug)]
pub struct Payload<W, B> {
    bus: B,
    offset: usize,
    capacity: usize,
    word: PhantomData<fn() -> W>,
}

impl<W: Word, B: Bus> Payload<W, B> {
    /// The payload at a byte offset of a memory, with room for `capacity` bytes.
    #[inline]
    #[must_use]
    pub const fn new(bus: B, offset: usize, capacity: usize) -> Self {
        Self { bus, offset, capacity, word: PhantomData }
    }

    /// Number of bytes there is room for.
    #[inline]
    #[must_use]
    pub const fn capacity(self) -> usize {
        self.capacity
    }

    /// Copies the first bytes to `data`, as many as it has room for and the element holds; returns their number.
    #[inline]
    pub fn read(self, data: &mut [u8]) -> usize {
        let length = data.len().min(self.capacity);
        let mut at = self.offset;
        let mut chunks = data[..length].chunks_exact_mut(Self::SIZE);
        for chunk in &mut chunks {
            split(self.bus.read::<W>(at).to_u32(), chunk);
            at += Self::SIZE;
        }
        let rest = chunks.into_remainder();
        if !rest.is_empty() {
            split(self.bus.read::<W>(at).to_u32(), rest);
        }
        length
    }

    /// Stores `data` as the first bytes, as many as there is room for; returns their number. The rest of the last word
    /// is filled with `fill`; words behind it are left alone.
    #[inline]
    pub fn write(self, data: &[u8], fill: u8) -> usize {
        let length = data.len().min(self.capacity);
        let mut at = self.offset;
        let chunks = data[..length].chunks_exact(Self::SIZE);
        let rest = chunks.remainder();
        for chunk in chunks {
            self.bus.write(at, W::from_u32(join(chunk, fill)));
            at += Self::SIZE;
        }
        if !rest.is_empty() {
            self.bus.write(at, W::from_u32(join(rest, fill)));
        }
        length
    }

    /// Bytes of a word.
    const SIZE: usize = W::BITS as usize / 8;
}

/// At most four bytes as a word, the first in its low byte, filled up with `fill`. Whole words are matched first: that is
/// one load where the processor allows it.
#[inline(always)]
fn join(bytes: &[u8], fill: u8) -> u32 {
    u32::from_le_bytes(match *bytes {
        [a, b, c, d] => [a, b, c, d],
        [a, b, c] => [a, b, c, fill],
        [a, b] => [a, b, fill, fill],
        [a] => [a, fill, fill, fill],
        _ => [fill; 4],
    })
}

/// The low bytes of a word.
#[inline(always)]
fn split(word: u32, bytes: &mut [u8]) {
    let [a, b, c, d] = word.to_le_bytes();
    match bytes {
        [w, x, y, z] => (*w, *x, *y, *z) = (a, b, c, d),
        [w, x, y] => (*w, *x, *y) = (a, b, c),
        [w, x] => (*w, *x) = (a, b),
        [w] => *w = a,
        _ => {}
    }
}
