//! The model of Bosch M_CAN, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]

mod bench;
mod choices;
mod exchange;
mod known_bugs;
mod laws;
mod modes;
mod rx;
mod silicon;
mod status;
mod tx;
