//! The same work twice: through the HAL, and by hand with volatile accesses.
//!
//! `.ci/hal-size` builds this for targets without an operating system, adds up the code that each function `hal_NAME` and
//! `hand_NAME` reaches, and looks for panics in what `quiet` lines name.
#![no_std]
#![allow(missing_docs, unsafe_code, clippy::missing_safety_doc)]

mod dspic33_canfd;
mod dspic33_canfd_by_hand;
mod dspic33_ecan;
mod dspic33_ecan_by_hand;
mod m_can;
mod m_can_by_hand;
mod pic32_can;
mod pic32_can_by_hand;
