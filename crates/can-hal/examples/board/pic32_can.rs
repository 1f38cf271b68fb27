//! A PIC32MX CAN.

use can_hal::{
    Region,
    memory::{Pic32CanFifo, Pic32CanMemory, Pic32CanPlan},
    mode::Configuration,
    pic32_can::{Can, Config, Filter, Mask},
    timing::{Pic32CanTiming, Request, SamplePoint},
};
use can_sim::{Memory, MemoryBus, RegisterBus, Sim, pic32_can::Pic32CanConfig};

use super::{MODE, Result};

/// System RAM for messages, and the physical address at which it begins.
const WORDS: usize = 1024;
const ADDRESS: u32 = 0x1000;

const TIMING: Pic32CanTiming =
    Pic32CanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)));

/// FIFO 0 sends, FIFO 1 receives.
const PLAN: Pic32CanPlan = Pic32CanMemory::new(ADDRESS, WORDS as u32 * 4)
    .fifo(0, Pic32CanFifo::Transmit { elements: 16 })
    .fifo(1, Pic32CanFifo::Receive { elements: 16 })
    .fixed();

/// Adds a PIC32MX CAN that receives everything.
#[allow(unsafe_code, reason = "a memory of its own")]
pub fn pic32_can<'a>(sim: &'a Sim, name: &str) -> Result<Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>> {
    let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
    let config = Pic32CanConfig::new(ram).with_clock(40_000_000).with_memory_base(ADDRESS);
    let id = sim.add_pic32_can(name, config)?;
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), ADDRESS, WORDS as u32 * 4) };
    let mut can = Can::new(sim.registers(id), region, &PLAN, MODE)?;
    can.configure(&Config::new(TIMING).with_filters([Mask::ANY; 4], &[Filter::any(1)]))?;
    Ok(can)
}
