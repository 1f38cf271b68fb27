//! The model of Bosch M_CAN, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]

mod bench;
mod choices;
mod counters;
mod details;
mod exchange;
mod fd;
mod fuzz;
mod interruption;
mod interrupts;
mod known_bugs;
mod laws;
#[path = "../laws_of/mod.rs"]
mod laws_of;
mod modes;
mod rx;
mod rx_limits;
mod silicon;
mod status;
mod tx;
mod tx_limits;
