//! What stands for a board in these examples: a simulation with controllers on it.
//!
//! On hardware the two buses are `Mmio` at the addresses of the chip, and that is all that changes.
#![allow(dead_code, unused_imports, reason = "each example uses what it needs")]

mod dspic33_canfd;
mod ecan;
mod pic32_can;

use can_hal::{
    ExtendedId, Frame, Id, Polls, Region, StandardId,
    m_can::{Can, Config, DataFieldSize},
    memory::{MCanMemory, MCanPlan},
    mode::Configuration,
    timing::{MCanTiming, Request, SamplePoint},
};
use can_sim::{
    BusId, Memory, MemoryBus, RegisterBus, Sim, Time,
    m_can::{MCanConfig, MCanModel},
};

#[allow(unused_imports, reason = "each example uses what it needs")]
pub use dspic33_canfd::dspic33_canfd;
pub use ecan::ecan;
#[allow(unused_imports, reason = "each example uses what it needs")]
pub use pic32_can::pic32_can;

pub type Result<T> = core::result::Result<T, Box<dyn std::error::Error>>;

/// An M_CAN on the simulation.
pub type MCan<'a, S> = Can<S, RegisterBus<'a>, MemoryBus<'a>>;

/// The bit rates, at a clock of 40 MHz: 1 Mbit/s, in the data phase of FD frames 5 Mbit/s. The sample point is that of
/// the other nodes: frames that switch the bit rate do so there.
pub const RATES: Request = Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000);

/// Register values for them, worked out when this is compiled.
pub const TIMING: MCanTiming = MCanTiming::fixed(&RATES);

const RAM_WORDS: usize = 4352;

/// Where everything lies in the Message RAM, checked when this is compiled.
pub const PLAN: MCanPlan = MCanMemory::new(RAM_WORDS as u32 * 4)
    .standard_filters(8)
    .extended_filters(8)
    .rx_fifo_0(32, DataFieldSize::Bytes64)
    .rx_fifo_1(8, DataFieldSize::Bytes64)
    .rx_buffers(4, DataFieldSize::Bytes64)
    .tx_event_fifo(8)
    .tx_buffers(2, 16, DataFieldSize::Bytes64)
    .fixed();

/// How often a register is read while a mode changes. Some controllers wait for the bus meanwhile.
pub const MODE: Polls = Polls(5_000);

/// Adds an M_CAN to the simulation and brings it to configuration mode.
pub fn m_can<'a>(sim: &'a Sim, name: &str) -> Result<MCan<'a, Configuration>> {
    m_can_on(sim, BusId::default(), name)
}

/// The same on another bus.
#[allow(unsafe_code, reason = "a memory of its own")]
pub fn m_can_on<'a>(sim: &'a Sim, bus: BusId, name: &str) -> Result<MCan<'a, Configuration>> {
    let ram = sim.add_memory(Memory::new(RAM_WORDS));
    let config = MCanConfig::new(ram);
    let id = sim.add_on(bus, name, config.place, MCanModel::new(config))?;
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), 0, RAM_WORDS as u32 * 4) };
    Ok(Can::new(sim.registers(id), region, &PLAN, MODE)?)
}

/// The same, with the usual bit timing and whatever else `config` says.
pub fn configured<'a>(sim: &'a Sim, name: &str, config: &Config<'_>) -> Result<MCan<'a, Configuration>> {
    let mut can = m_can(sim, name)?;
    can.configure(config)?;
    Ok(can)
}

/// A refused change of mode as an error; the controller it gives back is not needed here.
pub fn or_error<T, C, E: std::error::Error + 'static>(
    result: core::result::Result<T, can_hal::Refused<C, E>>,
) -> Result<T> {
    result.map_err(|refused| refused.error.into())
}

/// An 11-bit identifier known when this is compiled.
pub const fn standard(id: u16) -> StandardId {
    match StandardId::new(id) {
        Some(id) => id,
        None => panic!("11 bits"),
    }
}

/// A 29-bit identifier known when this is compiled.
pub const fn extended(id: u32) -> ExtendedId {
    match ExtendedId::new(id) {
        Some(id) => id,
        None => panic!("29 bits"),
    }
}

/// A classic frame.
pub fn data(id: impl Into<Id>, bytes: &[u8]) -> Result<Frame> {
    Ok(Frame::data(id, bytes)?)
}

/// Time for a few frames.
pub const A_WHILE: Time = Time::from_us(1_000);
