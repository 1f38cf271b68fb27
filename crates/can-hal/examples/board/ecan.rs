//! An ECAN of a dsPIC33F or PIC24H.

use can_hal::{
    Region,
    dspic33_ecan::{BufferCount, Can, Config, Filter, FilterTarget, Mask, MaskSource},
    memory::{DsPic33EcanMemory, DsPic33EcanPlan},
    mode::Configuration,
    timing::{DsPic33EcanTiming, Request, SamplePoint},
};
use can_sim::{Memory, MemoryBus, RegisterBus, Sim, dspic33_ecan::EcanConfig};

use super::{MODE, Result};

/// Bytes of DMA RAM.
const BYTES: u32 = 1024;

const TIMING: DsPic33EcanTiming =
    DsPic33EcanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)));

/// Sixteen buffers; those behind the eight that can send are the receive FIFO.
const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers16, 8).fixed();

/// Adds an ECAN that receives everything.
#[allow(unsafe_code, reason = "a memory of its own")]
pub fn ecan<'a>(sim: &'a Sim, name: &str) -> Result<Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>> {
    let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16]));
    let id = sim.add_dspic33_ecan(name, EcanConfig::new(ram))?;
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), 0, BYTES) };
    let mut can = Can::new(sim.registers(id), region, &PLAN, MODE)?;
    let filters = [Filter::any(FilterTarget::Fifo, MaskSource::Mask2)];
    can.configure(&Config::new(TIMING).with_queue(4).with_filters([Mask::ANY; 3], &filters))?;
    Ok(can)
}
