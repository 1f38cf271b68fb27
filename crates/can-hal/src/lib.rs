//! A thin HAL for four CAN controllers: bit timing, message memory, filters, sending and receiving, errors, interrupts.
//!
//! It adds what the manuals' procedures require and nothing else, and is generic over [`regbus::Bus`], so that the same
//! source runs on hardware and on the simulator. No allocation, no hidden waiting, no panic in sending and receiving.
//!
//! - A controller's mode is part of its type ([`mode`]): what needs configuration mode does not compile while it runs.
//! - Every wait takes a [`Deadline`] and ends with [`TimedOut`].
//! - What reading destroys is read once, into a [`Status`].
//! - [`Configured`], [`Receive`], [`Transmit`], [`Sleep`] and [`Wake`] are what all controllers have in common; what one
//!   has beyond that are its own methods, in its module.
//! - [`embedded_can`]'s traits and [`FdCan`] are for drivers that know no controller.
#![no_std]
#![deny(unsafe_code)]
#![allow(clippy::result_large_err, reason = "a refused change of mode gives the controller back")]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[macro_use]
mod report;
mod controller;
mod deadline;
pub mod dspic33_canfd;
pub mod dspic33_ecan;
mod error;
mod events;
mod fields;
pub mod m_can;
pub mod memory;
pub mod mode;
pub mod pic32_can;
mod recovery;
mod region;
mod status;
mod timestamp;
pub mod timing;
mod traits;

pub use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
pub use controller::{Capabilities, Configured, InterruptSet, Outcome, Receive, Received, Sleep, Transmit, Wake};
pub use deadline::{Deadline, Polls, TimedOut, Until};
pub use error::{Error, Overflow, Refused, SendError};
pub use events::Events;
pub use fields::OutOfRange;
pub use recovery::RestartAfter;
pub use region::Region;
pub use status::{Counters, ErrorState, LastError, Status};
pub use timestamp::TimestampExtender;
pub use traits::FdCan;
