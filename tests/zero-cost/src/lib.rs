//! The same work twice: through the register crates, and by hand with volatile accesses.
//!
//! `.ci/zero-cost` compares the machine code of each pair. A line `claims NAME load16=2 store16=2` says in addition how
//! many loads and stores of which width the function consists of; a width that is not named does not occur.
#![no_std]
#![allow(missing_docs, unsafe_code, clippy::missing_safety_doc)]

mod byhand;
mod dspic;
mod mcan;
mod pic32;
