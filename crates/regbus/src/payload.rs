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
        let size = W::BITS as usize / 8;
        let length = data.len().min(self.capacity);
        for (index, chunk) in data[..length].chunks_mut(size).enumerate() {
            let word = self.bus.read::<W>(self.offset + index * size).to_u32();
            for (byte, from) in chunk.iter_mut().zip(word.to_le_bytes()) {
                *byte = from;
            }
        }
        length
    }

    /// Stores `data` as the first bytes, as many as there is room for; returns their number. The rest of the last word
    /// is filled with `fill`; words behind it are left alone.
    #[inline]
    pub fn write(self, data: &[u8], fill: u8) -> usize {
        let size = W::BITS as usize / 8;
        let length = data.len().min(self.capacity);
        for (index, chunk) in data[..length].chunks(size).enumerate() {
            let mut bytes = [fill; 4];
            for (to, byte) in bytes.iter_mut().zip(chunk) {
                *to = *byte;
            }
            self.bus.write(self.offset + index * size, W::from_u32(u32::from_le_bytes(bytes)));
        }
        length
    }
}
