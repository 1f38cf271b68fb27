//! The bench of ECAN.

use can_hal::{
    Capabilities, Configured, Id, Polls, Region,
    dspic33_ecan::{BufferCount, Can, Config, Filter, FilterTarget, Interrupts, Mask, MaskSource, TxPriority, Use},
    memory::{DsPic33EcanMemory, DsPic33EcanPlan},
    mode::Configuration,
    timing::{DsPic33EcanTiming, Request, SamplePoint},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim, Time,
    dspic33_ecan::{EcanConfig, EcanModel},
};
use can_wire::NodeId;

use crate::bench::{Bench, Setup};

/// Bytes of DMA RAM.
const BYTES: u32 = 1024;

/// The sample point of `NodeConfig::new`.
const TIMING: DsPic33EcanTiming =
    DsPic33EcanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)));

/// Twelve buffers, of which the last four are the FIFO.
const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers12, 8).fixed();

/// The buffer that answers remote requests.
const REPLY: u8 = 7;

#[derive(Clone, Copy)]
pub struct Ecan {
    id: Handle<EcanModel>,
    ram: MemoryId,
}

impl Bench for Ecan {
    type Can<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;

    const EXPECTED: Capabilities = Capabilities {
        fd: false,
        // 8.1: a message that fails stays pending; there is no other way.
        one_shot: false,
        remote_reply: true,
        tx_events: false,
        // 14.0: the time is taken by an input capture.
        timestamp_bits: 0,
        overwrite: false,
        // 8.1: the identifier plays no part.
        priority_by_id: false,
        last_error: false,
        restricted: false,
        wake_on_traffic: true,
        loses_silently: false,
        // Figure 11-1.
        recovers_by_itself: true,
    };
    const RX_DEPTH: usize = 4;
    const TX_DEPTH: usize = 3;
    const TELLS_SENT_ANYWAY: bool = true;
    const TIMESTAMP_UNIT: Time = Time::ZERO;
    // 7.0: a frame on the bus and 11 recessive bits, at 100 ns for an access.
    const MODE_POLLS: u32 = 3_000;

    fn add(sim: &Sim, name: &str) -> Self {
        let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16]));
        let id = sim.add_dspic33_ecan(name, EcanConfig::new(ram)).unwrap();
        Self { id, ram }
    }

    fn node(self, sim: &Sim) -> NodeId {
        sim.node(self.id)
    }

    fn line(self, sim: &Sim) -> bool {
        sim.line(self.id, 0)
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    fn set_up<'a>(self, sim: &'a Sim, setup: &Setup<'_>) -> Self::Can<'a> {
        assert!(!setup.fd && !setup.one_shot && !setup.by_id && !setup.overwrite, "ECAN has none of these");
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(sim.memory(self.ram), 0, BYTES) };
        let mut can = Can::new(sim.registers(self.id), region, &PLAN, Polls(Self::MODE_POLLS)).unwrap();
        let exact = |id: Id, target| {
            let mask = if matches!(id, Id::Standard(_)) { MaskSource::Mask0 } else { MaskSource::Mask1 };
            Filter::new(id, mask, target)
        };
        let mut filters: Vec<Filter> =
            setup.reply.iter().map(|frame| exact(frame.id(), FilterTarget::Buffer(REPLY))).collect();
        filters.extend(setup.accept.iter().map(|id| exact(*id, FilterTarget::Fifo)));
        if setup.accept.is_empty() {
            filters.push(Filter::any(FilterTarget::Fifo, MaskSource::Mask2));
        }
        let masks = [Mask::STANDARD, Mask::EXTENDED, Mask::ANY];
        let mut config = Config::new(TIMING).with_queue(Self::TX_DEPTH).with_filters(masks, &filters);
        config.blocking_polls = 1_000;
        if setup.reply.is_some() {
            config = config.with_use(usize::from(REPLY), Use::Reply(TxPriority::Highest));
        }
        can.configure(&config).unwrap();
        if let Some(frame) = &setup.reply {
            can.set_reply(REPLY, frame).unwrap();
        }
        can
    }

    fn enable_receive_interrupt(can: &mut <Self::Can<'_> as Configured>::Running) {
        can.enable_interrupts(Interrupts::RBIF);
    }

    fn device_sleeps(self, sim: &Sim) {
        sim.act(self.id, |model, cx| model.sleep(cx));
    }

    fn device_wakes(self, sim: &Sim) {
        sim.act(self.id, |model, cx| model.run(cx));
    }
}
