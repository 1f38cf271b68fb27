//! Microchip dsPIC33 CAN FD. Sections are of the manual.

use can_hal::{
    Configured, Events, Polls, Receive as _, Region,
    dspic33_canfd::{Can, Config, Filter, Interrupts, MainFlags, PayloadSize},
    memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan},
    mode::{Configuration, Running},
    timing::{BitTiming, DsPic33CanFdTiming, Limits},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim,
    dspic33_canfd::{Dspic33CanfdConfig, Dspic33CanfdModel},
};
use can_wire::NodeId;
use regbus::meta;

use super::{MODE_POLLS, Station, take_events};
use crate::{Error, play};

/// Bus address of the RAM's first byte, and its words.
const BASE: u32 = 0x1000;
const WORDS: usize = 4096;
/// The FIFOs that send and receive, and the messages in them.
const TX: u8 = 1;
const RX: u8 = 2;
const DEPTH: u32 = 8;
/// Reads of CiCONH.OPMOD until a mode is reached: on the bus the module waits for 11 recessive bits first (4.1.5).
const POLLS: u32 = 10 * MODE_POLLS;

const PLAN: DsPic33CanFdPlan = DsPic33CanFdMemory::new(BASE, WORDS as u32 * 4)
    .tef(DEPTH, false)
    .fifo(TX, DsPic33CanFdFifo::Transmit { elements: DEPTH, payload: PayloadSize::Bytes64 })
    .fifo(RX, DsPic33CanFdFifo::Receive { elements: DEPTH, payload: PayloadSize::Bytes64, timestamps: false })
    .fixed();

/// A dsPIC33 CAN FD module with a RAM of its own.
#[derive(Clone, Copy, Debug)]
pub struct DsPic33CanFd {
    id: Handle<Dspic33CanfdModel>,
    ram: MemoryId,
}

impl Station for DsPic33CanFd {
    type Configured<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;
    type Driver<'a> = Can<Running, RegisterBus<'a>, MemoryBus<'a>>;
    const META: &'static meta::Controller = &dspic33_canfd_pac::meta::CONTROLLER;
    const CLOCK: u32 = 40_000_000;
    const FD: bool = <Self::Configured<'static> as Configured>::CAPABILITIES.fd;

    fn add(sim: &Sim, name: &str, ppm: i32) -> Result<Self, Error> {
        let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
        let mut config = Dspic33CanfdConfig::new(ram).with_memory_base(BASE);
        config.place = play::place(Self::CLOCK, ppm);
        let id = sim.add_dspic33_canfd(name, config).map_err(Error::Place)?;
        Ok(Self { id, ram })
    }

    fn timing() -> Result<BitTiming, Error> {
        let solution = Limits::DSPIC33_CANFD.solve(&play::request(Self::CLOCK)).map_err(Error::Timing)?;
        Ok(solution.timing)
    }

    fn node(self, sim: &Sim) -> NodeId {
        sim.node(self.id)
    }

    fn line(self, sim: &Sim) -> bool {
        (0..Self::META.lines.len()).any(|line| sim.line(self.id, line))
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    fn configure<'a>(self, sim: &'a Sim, timing: &BitTiming) -> Result<Self::Configured<'a>, Error> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(sim.memory(self.ram), BASE, WORDS as u32 * 4) };
        let timing = DsPic33CanFdTiming::of(timing).map_err(Error::setup)?;
        let mut can = Can::new(sim.registers(self.id), region, &PLAN, Polls(POLLS)).map_err(Error::setup)?;
        can.configure(&Config::new(timing).with_fd().with_filters(&[Filter::any(RX)])).map_err(Error::setup)?;
        Ok(can)
    }

    fn start<'a>(can: Self::Configured<'a>) -> Result<Self::Driver<'a>, Error> {
        type I = MainFlags;
        let mut can = can.start(Polls(POLLS)).map_err(|_| Error::TimedOut("normal operation was requested"))?;
        can.clear(Interrupts::of(I::MODIF | I::CERRIF | I::IVMIF));
        can.enable_interrupts(I::RXIF | I::TEFIF | I::CERRIF | I::IVMIF);
        Ok(can)
    }

    /// 12.1.6: that a message is sent is told by its event, and TEFIF ends when the events are fetched.
    fn take_events(can: &mut Self::Driver<'_>) -> Result<Events, Error> {
        let events = take_events(can);
        let mut sent = false;
        if events.contains(Events::TX_EVENT) {
            while can.tx_event().map_err(Error::setup)?.is_some() {
                sent = true;
            }
        }
        Ok(events.with(Events::TRANSMITTED, sent))
    }

    fn report_errors(can: &mut Self::Driver<'_>, on: bool) {
        if on {
            can.clear(Interrupts::of(MainFlags::IVMIF));
            can.enable_interrupts(MainFlags::IVMIF);
        } else {
            can.disable_interrupts(MainFlags::IVMIF);
        }
    }
}
