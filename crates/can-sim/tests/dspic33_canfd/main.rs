//! The model of Microchip dsPIC33 CAN FD, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]

mod bench;
mod choices;
mod errors;
mod exchange;
mod fifo;
mod filters;
mod interrupts;
mod known_bugs;
mod laws;
#[path = "../laws_of/mod.rs"]
mod laws_of;
mod modes;
mod rx;
mod timestamps;
mod tx;
