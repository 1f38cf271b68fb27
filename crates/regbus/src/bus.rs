//! Buses and the words they move.

/// A word that a bus moves in one transaction: `u8`, `u16` or `u32`.
pub trait Word: Copy + Eq + core::fmt::LowerHex + sealed::Sealed + 'static {
    /// Its width in bits.
    const BITS: u32;
    /// The word in the low bits of a `u32`.
    fn to_u32(self) -> u32;
    /// The low bits of a `u32`; the others are dropped.
    fn from_u32(value: u32) -> Self;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! words {
    ($($word:ty)*) => {$(
        impl sealed::Sealed for $word {}
        impl Word for $word {
            const BITS: u32 = <$word>::BITS;
            #[inline(always)]
            #[allow(clippy::unnecessary_cast, clippy::cast_lossless, reason = "one body for three widths")]
            fn to_u32(self) -> u32 {
                self as u32
            }
            #[inline(always)]
            #[allow(clippy::unnecessary_cast, clippy::cast_possible_truncation, reason = "documented to drop bits")]
            fn from_u32(value: u32) -> Self {
                value as Self
            }
        }
    )*};
}

words!(u8 u16 u32);

/// Something that registers or message memory can be reached through.
///
/// One call is one bus transaction of exactly the width of `W`, and calls happen in program order. `offset` is in
/// bytes from the base of the block and a multiple of the word's size. The value is the same type on hardware, where
/// it is a pointer, and in a simulation, where it is a reference to a model.
pub trait Bus: Copy {
    /// Reads one word.
    fn read<W: Word>(self, offset: usize) -> W;
    /// Writes one word.
    fn write<W: Word>(self, offset: usize, value: W);
}

/// Registers in the address space of the processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mmio(*mut u8);

#[allow(unsafe_code, reason = "this is where registers are touched")]
// SAFETY: an address says nothing about a thread; that only one owner uses a peripheral is what the caller of
// `Mmio::new` promised.
unsafe impl Send for Mmio {}

impl Mmio {
    /// The block of registers or memory at an address.
    ///
    /// # Safety
    ///
    /// The address is the base of the block that the peripheral built on it describes, aligned to 4 bytes, mapped as
    /// device memory (or, for message memory, as memory that only volatile accesses of this bus and the controller
    /// touch) for as long as any copy of this value is used; and no other code uses the block meanwhile, unless it
    /// keeps to the same discipline.
    #[inline]
    #[must_use]
    #[allow(unsafe_code, reason = "the address cannot be checked")]
    pub const unsafe fn new(base: usize) -> Self {
        Self(core::ptr::with_exposed_provenance_mut(base))
    }

    /// The address.
    #[inline]
    #[must_use]
    pub fn address(self) -> usize {
        self.0.expose_provenance()
    }
}

#[allow(unsafe_code, reason = "this is where registers are touched")]
impl Bus for Mmio {
    #[inline(always)]
    fn read<W: Word>(self, offset: usize) -> W {
        // SAFETY: the caller of `Mmio::new` promised the block; generated offsets lie inside and are aligned.
        unsafe { self.0.add(offset).cast::<W>().read_volatile() }
    }

    #[inline(always)]
    fn write<W: Word>(self, offset: usize, value: W) {
        // SAFETY: as in `read`.
        unsafe { self.0.add(offset).cast::<W>().write_volatile(value) }
    }
}
