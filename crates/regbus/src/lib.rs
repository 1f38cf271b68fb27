//! The runtime of canpac's generated register crates.
//!
//! A [`Bus`] moves words of 8, 16 or 32 bits; one call is one transaction of exactly that width. [`Mmio`] is the
//! bus of real hardware; a simulator implements the trait for a pointer to a model. A generated peripheral hands
//! out [`Reg`]s: a bus, an offset, and the type of the register's value, which carries what the manual says may be
//! done with it, as the traits of [`capability`]. What a register does not allow does not compile.
//!
//! ```
//! use regbus::Bus;
//!
//! // A bus over an array, as a test might use it.
//! #[derive(Clone, Copy)]
//! struct Words<'a>(&'a [core::cell::Cell<u32>]);
//!
//! impl Bus for Words<'_> {
//!     fn read<W: regbus::Word>(self, offset: usize) -> W {
//!         W::from_u32(self.0[offset / 4].get() >> (offset % 4 * 8))
//!     }
//!     fn write<W: regbus::Word>(self, offset: usize, value: W) {
//!         assert_eq!((W::BITS, offset % 4), (32, 0), "this array takes words only");
//!         self.0[offset / 4].set(value.to_u32());
//!     }
//! }
//!
//! let cells = [const { core::cell::Cell::new(0) }; 4];
//! Words(&cells).write(8, 0x1234_5678_u32);
//! assert_eq!(Words(&cells).read::<u8>(9), 0x56);
//! ```
#![no_std]

pub mod bits;
mod bus;
pub mod capability;
mod joined;
mod macros;
pub mod meta;
mod payload;
mod reg;
mod window;

pub use bus::{Bus, Mmio, Word};
pub use capability::{
    AliasClear, AliasInvert, AliasSet, Clear, Modify, Pure, Readable, Register, Request, UnsafeWritable, Writable,
};
pub use joined::Half;
pub use payload::Payload;
pub use reg::Reg;
pub use window::Bracket;

#[cfg(feature = "critical-section")]
pub use critical_section::CriticalSection;

#[doc(hidden)]
#[cfg(feature = "defmt")]
pub use defmt;
