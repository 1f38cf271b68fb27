//! The model of Microchip dsPIC33 CAN FD, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]
