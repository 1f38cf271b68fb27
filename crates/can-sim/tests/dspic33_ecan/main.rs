//! The model of Microchip dsPIC33F/PIC24H ECAN, chapter by chapter of its manual.
#![allow(clippy::unwrap_used, reason = "a test that fails here fails where it should")]
