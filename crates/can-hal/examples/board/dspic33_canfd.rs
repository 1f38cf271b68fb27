//! A dsPIC33 CAN FD module on the simulation.

use can_hal::{
    Region,
    dspic33_canfd::{Can, Config, Filter, PayloadSize},
    memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan},
    mode::Configuration,
    timing::DsPic33CanFdTiming,
};
use can_sim::{Memory, MemoryBus, RegisterBus, Sim, dspic33_canfd::Dspic33CanfdConfig};

use super::{MODE, RATES, Result};

const TIMING: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(&RATES);

/// System RAM of the device.
const BASE: u32 = 0x1000;
const BYTES: u32 = 0x1000;

/// FIFO 1 receives, FIFO 2 sends.
const PLAN: DsPic33CanFdPlan = DsPic33CanFdMemory::new(BASE, BYTES)
    .fifo(1, DsPic33CanFdFifo::Receive { elements: 16, payload: PayloadSize::Bytes64, timestamps: true })
    .fifo(2, DsPic33CanFdFifo::Transmit { elements: 8, payload: PayloadSize::Bytes64 })
    .fixed();

/// Adds a module that receives everything.
#[allow(unsafe_code, reason = "a memory of its own")]
pub fn dspic33_canfd<'a>(sim: &'a Sim, name: &str) -> Result<Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>> {
    let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16, 32]));
    let id = sim.add_dspic33_canfd(name, Dspic33CanfdConfig::new(ram))?;
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), BASE, BYTES) };
    let mut can = Can::new(sim.registers(id), region, &PLAN, MODE)?;
    can.configure(&Config::new(TIMING).with_fd().with_filters(&[Filter::any(1)]))?;
    Ok(can)
}
