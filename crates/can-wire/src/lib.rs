//! A CAN and CAN FD bus, simulated bit by bit.
//!
//! Every node owns a protocol engine (ISO 11898-1:2015), a clock with its own frequency, a bit-timing unit and
//! propagation delays. The bus is the wired AND of what the nodes drive. Nobody hands frames over: a receiver has a
//! frame because it has decoded its bits. Lost arbitration, a missing acknowledgement, mismatched bit rates, error
//! frames and bus off are consequences.
//!
//! Time is integer picoseconds and a run is deterministic: the same calls give the same events at the same times.
//!
//! See [`Wire`] for the way to use it.
#![forbid(unsafe_code)]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

mod bit_clock;
mod bus;
mod config;
pub mod crc;
mod encode;
mod event;
mod fault;
mod field;
mod level;
mod node;
pub mod output;
mod protocol;
mod schedule;
mod time;
mod timing;
mod trace;
mod wire;

pub use config::{FdSupport, Mode, NodeConfig, NodeId, ProtocolException};
pub use encode::{EncodedBit, encode};
pub use event::{
    BitRecord, BusError, ErrorKind, ErrorState, Event, EventKind, OverloadCause, PartialFrame, Role,
};
pub use fault::{BitFault, Disturbance, Fault, Frames, Line};
pub use field::{Field, Position};
pub use level::Level;
pub use time::Time;
pub use timing::{BitTiming, DelayCompensation, DelaySource, TimingError};
pub use trace::{Signal, TraceSink};
pub use wire::{Abort, RequestError, Statistics, Wire};
