//! CAN and CAN FD frames: the vocabulary that drivers, simulators and tools share.
//!
//! A [`Frame`] is a classic data frame, a classic remote frame or an FD frame with its bit-rate switch (BRS) and error
//! state indicator (ESI). Lengths follow the data length code: see [`Dlc`]. Text is the notation of `candump` and
//! `cansend`, in both directions: [`Frame`] implements `Display` and `FromStr`, and [`LogLine`] does so for a line of a
//! log.
//!
//! ```
//! use can_frame::{Dlc, Frame};
//! use embedded_can::{Id, StandardId};
//!
//! let id = Id::from(StandardId::new(0x123).ok_or("out of range")?);
//! let classic = Frame::data(id, &[0xDE, 0xAD, 0xBE, 0xEF])?;
//! assert_eq!(classic.to_string(), "123#DEADBEEF");
//!
//! let fd: Frame = "18DAF110##1001122334455667788AABBCC".parse()?;
//! assert!(fd.is_fd() && fd.bit_rate_switch() && fd.is_extended());
//! assert_eq!(fd.dlc(), Dlc::fitting(12).ok_or("no such length")?);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! The crate is `no_std` and allocates nothing.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

mod dlc;
mod error;
mod frame;
mod hex;
mod log;
mod text;

pub use dlc::{CLASSIC_MAX_LEN, Dlc, FD_LENGTHS, FD_MAX_LEN};
pub use embedded_can::{ExtendedId, Id, StandardId};
pub use error::{FrameError, ParseError, ParseErrorKind};
pub use frame::{FdFlags, Format, Frame};
pub use log::{Direction, LogLine};
