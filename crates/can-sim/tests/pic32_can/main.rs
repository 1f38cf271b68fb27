//! The model of Microchip PIC32MX CAN, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]

mod bench;
mod choices;
mod choices_reception;
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
mod timestamp;
mod timing;
mod tx;
