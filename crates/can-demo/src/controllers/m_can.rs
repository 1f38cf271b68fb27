//! Bosch M_CAN.

use can_hal::{
    Configured, Polls, Region,
    m_can::{Can, Config, DataFieldSize, Interrupts, Line},
    memory::{MCanMemory, MCanPlan},
    mode::{Configuration, Running},
    timing::{BitTiming, Limits, MCanTiming},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim,
    m_can::{MCanConfig, MCanModel},
};
use can_wire::NodeId;
use regbus::meta;

use super::{MODE_POLLS, Station};
use crate::{Error, play};

/// Words of its Message RAM: the largest there is.
const WORDS: usize = 4352;

const PLAN: MCanPlan = MCanMemory::new(WORDS as u32 * 4)
    .rx_fifo_0(8, DataFieldSize::Bytes64)
    .tx_buffers(0, 4, DataFieldSize::Bytes64)
    .fixed();

/// An M_CAN with a Message RAM of its own.
#[derive(Clone, Copy, Debug)]
pub struct MCan {
    id: Handle<MCanModel>,
    ram: MemoryId,
}

impl Station for MCan {
    type Configured<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;
    type Driver<'a> = Can<Running, RegisterBus<'a>, MemoryBus<'a>>;
    const META: &'static meta::Controller = &m_can_pac::meta::CONTROLLER;
    const CLOCK: u32 = 40_000_000;
    const FD: bool = <Self::Configured<'static> as Configured>::CAPABILITIES.fd;

    fn add(sim: &Sim, name: &str, ppm: i32) -> Result<Self, Error> {
        let ram = sim.add_memory(Memory::new(WORDS));
        let mut config = MCanConfig::new(ram);
        config.place = play::place(Self::CLOCK, ppm);
        let id = sim.add_m_can(name, config).map_err(Error::Place)?;
        Ok(Self { id, ram })
    }

    fn timing() -> Result<BitTiming, Error> {
        let solution = Limits::M_CAN.solve(&play::request(Self::CLOCK)).map_err(Error::Timing)?;
        Ok(solution.timing)
    }

    fn node(self, sim: &Sim) -> NodeId {
        sim.node(self.id)
    }

    fn line(self, sim: &Sim) -> bool {
        sim.line(self.id, 0)
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    fn configure<'a>(self, sim: &'a Sim, timing: &BitTiming) -> Result<Self::Configured<'a>, Error> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(sim.memory(self.ram), 0, WORDS as u32 * 4) };
        let timing = MCanTiming::of(timing).map_err(Error::setup)?;
        let mut can = Can::new(sim.registers(self.id), region, &PLAN, Polls(MODE_POLLS)).map_err(Error::setup)?;
        can.configure(&Config::new(timing).with_fd()).map_err(Error::setup)?;
        Ok(can)
    }

    fn start<'a>(can: Self::Configured<'a>) -> Result<Self::Driver<'a>, Error> {
        type I = Interrupts;
        let mut can = can.start(Polls(MODE_POLLS)).map_err(|_| Error::TimedOut("normal operation was requested"))?;
        can.enable_buffer_interrupts(u32::MAX, 0);
        can.enable_interrupts(I::RF0N | I::TC | I::EW | I::EP | I::BO | I::PEA | I::PED, Line::Int0);
        Ok(can)
    }

    fn report_errors(can: &mut Self::Driver<'_>, on: bool) {
        // 2.3.14: during the recovery every sequence of 11 recessive bits is a protocol error to IR.PEA.
        let errors = Interrupts::PEA | Interrupts::PED;
        if on {
            can.clear_interrupts(errors);
            can.enable_interrupts(errors, Line::Int0);
        } else {
            can.disable_interrupts(errors);
        }
    }
}
