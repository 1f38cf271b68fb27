//! What a register's value type says may be done with the register.
//!
//! The generator implements these traits from the access rules of the fields. A missing implementation is a
//! compile error that says what to do instead.

use core::fmt;

use crate::bus::{Bus, Word};
use crate::meta;

/// The value of a register: a transparent copy of its word.
pub trait Register: Copy + Eq + fmt::Debug + 'static {
    /// The word one access moves.
    type Word: Word;
    /// The register's name in the manual.
    const NAME: &'static str;
    /// Its fields.
    const FIELDS: &'static [meta::Field];
    /// Value after reset; bits without a defined value are 0.
    const RESET: Self;
    /// The value of a word.
    fn from_word(word: Self::Word) -> Self;
    /// The word of a value.
    fn to_word(self) -> Self::Word;
}

/// The register can be read.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be read: it is write-only",
    label = "no `read` for this register",
    note = "keep the last written value if you need it"
)]
pub trait Readable: Register {}

/// Reading the register changes nothing, so that it can be read for its own sake: by `Debug`, by a poll loop.
#[diagnostic::on_unimplemented(
    message = "reading `{Self}` changes it, so it is not read for display",
    label = "this register has read side effects",
    note = "read it once with `read()` where the driver needs it, and pass the value on: the value implements `Debug`"
)]
pub trait Pure: Readable {}

/// The register can be written with any value.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot simply be written: it is read-only, or it hands the hardware an address",
    label = "no safe `write` for this register",
    note = "if it hands the hardware an address, write it with `unsafe {{ reg.write_unsafe(value) }}`; its documentation says \
            what has to hold",
    note = "if it is read-only, there is nothing to write: what clears or changes it stands in its documentation"
)]
pub trait Writable: Register {}

/// The register can be written, but the value can make the hardware access memory that it must not.
#[diagnostic::on_unimplemented(
    message = "`{Self}` needs no unsafe write, or cannot be written at all",
    label = "use `write` if the register is writable"
)]
pub trait UnsafeWritable: Register {}

/// The register can be read, changed and written back without losing anything.
pub trait Modify<B: Bus>: Register {
    /// Bits kept from what was read; the others are flags and requests, written with their neutral value.
    const KEEP: u32;
    /// Flags whose neutral value is 1.
    const ONES: u32;
}

/// The register's flags can be cleared by one store.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no flags that one store can clear",
    label = "no `clear` for this register",
    note = "use `modify` or `write` for stored fields; a flag beside stored fields is cleared through an alias register, or \
            by a `write` of the whole value"
)]
pub trait Clear: Register {
    /// The flags.
    const FLAGS: u32;
    /// Flags that writing 0 clears; the others are cleared by writing 1.
    const BY_ZERO: u32;
    /// Bits of the other fields that have to be written as 1 so that nothing happens to them.
    const ONES: u32;
}

/// The register's requests can be made by one store that leaves everything else alone.
#[diagnostic::on_unimplemented(
    message = "`{Self}` holds no requests that one store can make",
    label = "no `request` for this register",
    note = "use `modify` or `write` with the request's setter"
)]
pub trait Request: Register {
    /// The requests.
    const REQUESTS: u32;
    /// Bits of the other fields that have to be written as 1 so that nothing happens to them.
    const ONES: u32;
}

/// An alias register sets bits of this register.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no alias register that sets bits",
    label = "no `set_bits` for this register",
    note = "use `modify` or `write`; a register that hands the hardware an address has `write_unsafe`"
)]
pub trait AliasSet: Register {
    /// Byte offset of the alias from the register.
    const OFFSET: usize;
}

/// An alias register clears bits of this register.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no alias register that clears bits",
    label = "no `clear_bits` for this register",
    note = "use `modify`, `write`, or `clear` for flags; a register that hands the hardware an address has `write_unsafe`"
)]
pub trait AliasClear: Register {
    /// Byte offset of the alias from the register.
    const OFFSET: usize;
}

/// An alias register inverts bits of this register.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no alias register that inverts bits",
    label = "no `invert_bits` for this register",
    note = "use `modify` or `write`; a register that hands the hardware an address has `write_unsafe`"
)]
pub trait AliasInvert: Register {
    /// Byte offset of the alias from the register.
    const OFFSET: usize;
}
