//! Register-accurate models of CAN controllers on a simulated bus.
//!
//! A driver written on a generated register crate runs on a model unchanged: [`Sim::registers`] gives the bus that its
//! peripheral is built on, [`Sim::memory`] the one for message elements. What registers hold, what a write and a read of
//! them do and under which condition comes from the generated metadata; what the controller does is written by hand,
//! chapter by chapter of its manual; the bus is [`can_wire`], bit by bit.
//!
//! ```
//! use can_sim::{Memory, Sim, m_can::{MCanConfig, MCanModel}};
//! use m_can_pac::{MCan, registers::Cccr};
//!
//! let sim = Sim::new();
//! let ram = sim.add_memory(Memory::new(4352));
//! let id = sim.add_m_can("can0", MCanConfig::new(ram))?;
//! let can = MCan::new(sim.registers(id));
//! assert_eq!(can.endn().read().etv(), 0x8765_4321);
//! can.cccr().write(Cccr::RESET.with_cce(true));
//! assert!(can.cccr().read().contains(Cccr::CCE));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Mistakes of a driver are collected as [`Diagnostic`]s, or panic.
#![deny(unsafe_code)]

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod access;
mod bus;
mod bus_log;
mod buses;
mod diagnostic;
pub mod dspic33_canfd;
pub mod dspic33_ecan;
mod handlers;
pub mod layout;
pub mod m_can;
mod memory;
mod model;
mod peer;
pub mod pic32_can;
pub mod registers;
mod scheduler;
mod sim;
mod trace;

pub use bus::{MemoryBus, RegisterBus};
pub use bus_log::BusEntry;
pub use buses::BusId;
pub use can_wire::Time;
pub use diagnostic::{Bits, Diagnostic, DiagnosticKind, OnDiagnostic};
pub use memory::{Memory, MemoryId};
pub use model::{Context, Model, Rule};
pub use peer::PeerId;
pub use sim::{Handle, Sim, SimBuilder};
pub use trace::{AccessRecord, RegisterTouched};
