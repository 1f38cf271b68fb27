//! Register handles.

use core::fmt;
use core::marker::PhantomData;

use crate::bus::{Bus, Word};
use crate::capability::{
    AliasClear, AliasInvert, AliasSet, Clear, Modify, Pure, Readable, Register, Request, UnsafeWritable, Writable,
};

/// One register: where it is and what it holds.
pub struct Reg<R, B> {
    bus: B,
    offset: usize,
    value: PhantomData<fn() -> R>,
}

impl<R, B: Copy> Clone for Reg<R, B> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<R, B: Copy> Copy for Reg<R, B> {}

impl<R: Register, B: Bus> Reg<R, B> {
    /// The register at a byte offset of a bus. Generated code calls this with offsets from the description.
    #[inline(always)]
    #[must_use]
    pub const fn new(bus: B, offset: usize) -> Self {
        Self { bus, offset, value: PhantomData }
    }

    /// Byte offset from the base of the block.
    #[inline]
    #[must_use]
    pub const fn offset(self) -> usize {
        self.offset
    }

    #[inline(always)]
    fn load(self) -> R {
        R::from_word(self.bus.read(self.offset))
    }

    #[inline(always)]
    fn store(self, word: u32) {
        self.bus.write(self.offset, R::Word::from_u32(word));
    }

    /// Reads the register: one access of its full width, with the side effects that the register's page names.
    #[inline(always)]
    #[must_use = "a read may have side effects, but is done for its value"]
    pub fn read(self) -> R
    where
        R: Readable,
    {
        self.load()
    }

    /// Reads one byte of the register, on a controller whose bus allows it: only the side effects of this byte happen.
    ///
    /// # Panics
    ///
    /// If the register has no such byte.
    #[inline]
    #[must_use = "a read may have side effects, but is done for its value"]
    pub fn read_byte(self, index: usize) -> u8
    where
        R: Readable,
    {
        assert!(index < R::Word::BITS as usize / 8, "the register has no such byte");
        self.bus.read(self.offset + index)
    }

    /// Writes the whole register: one store, never a read.
    #[inline(always)]
    pub fn write(self, value: R)
    where
        R: Writable,
    {
        self.store(value.to_word().to_u32());
    }

    /// Writes a register that makes the hardware access memory.
    ///
    /// # Safety
    ///
    /// What the documentation of the register's type asks: the memory that the value points the hardware at belongs to
    /// the hardware for as long as it may access it.
    #[inline(always)]
    #[allow(unsafe_code, reason = "what the hardware does with the value cannot be checked here")]
    pub unsafe fn write_unsafe(self, value: R)
    where
        R: UnsafeWritable,
    {
        self.store(value.to_word().to_u32());
    }

    /// Reads the register, changes the value and writes it back: one load and one store. Flags and requests are written
    /// with their neutral value, so that nothing happens to them, unless `change` sets a request.
    #[inline(always)]
    pub fn modify(self, change: impl FnOnce(R) -> R)
    where
        R: Modify<B> + Readable + Writable,
    {
        let read = self.load().to_word().to_u32() & <R as Modify<B>>::KEEP;
        let changed = change(R::from_word(R::Word::from_u32(read)));
        self.store(changed.to_word().to_u32() | <R as Modify<B>>::ONES);
    }

    /// The same as [`Reg::modify`] for a register that makes the hardware access memory.
    ///
    /// # Safety
    ///
    /// As for [`Reg::write_unsafe`].
    #[inline(always)]
    #[allow(unsafe_code, reason = "what the hardware does with the value cannot be checked here")]
    pub unsafe fn modify_unsafe(self, change: impl FnOnce(R) -> R)
    where
        R: Modify<B> + Readable + UnsafeWritable,
    {
        let read = self.load().to_word().to_u32() & <R as Modify<B>>::KEEP;
        let changed = change(R::from_word(R::Word::from_u32(read)));
        self.store(changed.to_word().to_u32() | <R as Modify<B>>::ONES);
    }

    /// Clears flags: one store, never a read, so that a flag which rises meanwhile is not lost. Bits of `flags` that are
    /// no flags are ignored.
    #[inline(always)]
    pub fn clear(self, flags: R)
    where
        R: Clear,
    {
        let flags = flags.to_word().to_u32() & R::FLAGS;
        let by_one = flags & !R::BY_ZERO;
        let by_zero = R::BY_ZERO & !flags;
        self.store(by_one | by_zero | R::ONES);
    }

    /// Makes requests: one store, never a read. Bits of `requests` that are no requests are ignored.
    #[inline(always)]
    pub fn request(self, requests: R)
    where
        R: Request,
    {
        self.store((requests.to_word().to_u32() & R::REQUESTS) | R::ONES);
    }

    /// Sets bits through the alias register: one store, never a read.
    #[inline(always)]
    pub fn set_bits(self, bits: R)
    where
        R: AliasSet,
    {
        self.bus.write(self.offset + <R as AliasSet>::OFFSET, bits.to_word());
    }

    /// Clears bits through the alias register: one store, never a read.
    #[inline(always)]
    pub fn clear_bits(self, bits: R)
    where
        R: AliasClear,
    {
        self.bus.write(self.offset + <R as AliasClear>::OFFSET, bits.to_word());
    }

    /// Inverts bits through the alias register: one store, never a read.
    #[inline(always)]
    pub fn invert_bits(self, bits: R)
    where
        R: AliasInvert,
    {
        self.bus.write(self.offset + <R as AliasInvert>::OFFSET, bits.to_word());
    }
}

/// Reads the register and shows its fields. Only for registers whose reading changes nothing.
impl<R: Pure, B: Bus> fmt::Debug for Reg<R, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.load().fmt(f)
    }
}
