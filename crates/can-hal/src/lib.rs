//! A thin HAL for four CAN controllers: bit timing, message memory, filters, sending and receiving, errors, interrupts.
//!
//! It adds what the manuals' procedures require and nothing else, and is generic over [`regbus::Bus`], so that the same
//! source runs on hardware and on the simulator.
#![no_std]
#![deny(unsafe_code)]

pub mod memory;
pub mod timing;
