//! The bench of PIC32MX CAN.

use can_hal::{
    Capabilities, Configured, Id, Polls, Region,
    memory::{Pic32CanFifo, Pic32CanMemory, Pic32CanPlan},
    mode::Configuration,
    pic32_can::{Can, Config, Filter, Interrupts, Mask, TxFifo},
    timing::{Pic32CanTiming, Request, SamplePoint},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim, Time,
    pic32_can::{Pic32CanConfig, Pic32CanModel},
};
use can_wire::NodeId;

use crate::bench::{Bench, Setup};

/// Words of system RAM.
const WORDS: usize = 1024;

/// The physical address at which it begins.
const ADDRESS: u32 = 0x1000;

/// FSYS is 40 MHz, half of which the prescaler gets: 20 quanta, as near to 80 % as segments of 8 come.
const TIMING: Pic32CanTiming =
    Pic32CanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)));

/// FIFO0 sends, FIFO1 receives, FIFO2 answers.
const PLAN: Pic32CanPlan = Pic32CanMemory::new(ADDRESS, WORDS as u32 * 4)
    .fifo(0, Pic32CanFifo::Transmit { elements: Pic32::TX_DEPTH as u32 })
    .fifo(1, Pic32CanFifo::Receive { elements: Pic32::RX_DEPTH as u32 })
    .fifo(2, Pic32CanFifo::Transmit { elements: 2 })
    .fixed();

#[derive(Clone, Copy)]
pub struct Pic32 {
    id: Handle<Pic32CanModel>,
    ram: MemoryId,
}

impl Bench for Pic32 {
    type Can<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;

    const EXPECTED: Capabilities = Capabilities {
        fd: false,
        // 34.7: messages are repeated until they are sent or aborted.
        one_shot: false,
        // 34.7.5
        remote_reply: true,
        tx_events: false,
        // 34.13
        timestamp_bits: 16,
        // 34.9.3: the newest message is lost.
        overwrite: false,
        // 34.7.3: in the order of the FIFO.
        priority_by_id: false,
        // 34.12.1.1: which error it was is not told.
        last_error: false,
        restricted: false,
        // 34.14.3
        wake_on_traffic: true,
        loses_silently: false,
        // 34.11.2: as CAN 2.0B says.
        recovers_by_itself: true,
    };
    const RX_DEPTH: usize = 4;
    const TX_DEPTH: usize = 3;
    const TELLS_SENT_ANYWAY: bool = true;
    const TIMESTAMP_UNIT: Time = Time::from_us(1);
    // 34.5: normal operation begins after 11 recessive bits, and ends with the message on the bus.
    const MODE_POLLS: u32 = 3_000;

    fn add(sim: &Sim, name: &str) -> Self {
        let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
        let mut config = Pic32CanConfig::new(ram).with_clock(40_000_000).with_memory_base(ADDRESS);
        // The host of the suite does not go to sleep with the module.
        config.choices.wake_in_disable = true;
        Self { id: sim.add_pic32_can(name, config).unwrap(), ram }
    }

    fn node(self, sim: &Sim) -> NodeId {
        sim.node(self.id)
    }

    fn line(self, sim: &Sim) -> bool {
        sim.line(self.id, 0)
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    fn set_up<'a>(self, sim: &'a Sim, setup: &Setup<'_>) -> Self::Can<'a> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(sim.memory(self.ram), ADDRESS, WORDS as u32 * 4) };
        let mut can = Can::new(sim.registers(self.id), region, &PLAN, Polls(Self::MODE_POLLS)).unwrap();
        assert!(!(setup.fd || setup.one_shot || setup.by_id || setup.overwrite), "the module cannot: {setup:?}");
        let mut filters: Vec<Filter> = setup.accept.iter().map(|id: &Id| Filter::new(*id, 1)).collect();
        if let Some(reply) = setup.reply {
            filters.push(Filter::new(reply.id(), 2));
        }
        if setup.accept.is_empty() {
            filters.push(Filter::any(1).with_mask(1));
        }
        let tx_fifos = [TxFifo::new(2).replying()];
        let masks = [Mask::EXACT, Mask::ANY, Mask::ANY, Mask::ANY];
        let mut config = Config::new(TIMING).with_filters(masks, &filters);
        if setup.reply.is_some() {
            config = config.with_tx_fifos(&tx_fifos);
        }
        config.timestamps = Some(40);
        config.blocking_polls = 1_000;
        can.configure(&config).unwrap();
        if let Some(reply) = setup.reply {
            can.preload(2, &reply).unwrap();
        }
        can
    }

    fn enable_receive_interrupt(can: &mut <Self::Can<'_> as Configured>::Running) {
        can.enable_interrupts(Interrupts::RECEIVE);
    }
}
