//! The bench of the dsPIC33 CAN FD module.

use can_hal::{
    Capabilities, Configured, Id, Polls, Region,
    dspic33_canfd::{Attempts, Can, Config, Filter, MainFlags, PayloadSize, Reference, Reply, Timestamping},
    memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan},
    mode::Configuration,
    timing::{DsPic33CanFdTiming, Request, SamplePoint},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim, Time,
    dspic33_canfd::{DeviceMode, Dspic33CanfdConfig, Dspic33CanfdModel},
};
use can_wire::NodeId;

use crate::bench::{Bench, Setup};

/// System RAM: where the module sees it, and its bytes.
const BASE: u32 = 0x1000;
const BYTES: u32 = 0x1000;

/// The sample points of `NodeConfig::new`.
const TIMING: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(
    &Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000),
);

const PAYLOAD: PayloadSize = PayloadSize::Bytes64;
const DEPTH: u32 = CanFd::TX_DEPTH as u32;

/// FIFO 1 receives, FIFO 3 answers remote frames.
const COMMON: DsPic33CanFdMemory = DsPic33CanFdMemory::new(BASE, BYTES)
    .fifo(1, DsPic33CanFdFifo::Receive { elements: CanFd::RX_DEPTH as u32, payload: PAYLOAD, timestamps: true })
    .fifo(3, DsPic33CanFdFifo::Transmit { elements: 1, payload: PAYLOAD });

/// FIFO 2 transmits, or the queue does.
const IN_ORDER: DsPic33CanFdPlan =
    COMMON.fifo(2, DsPic33CanFdFifo::Transmit { elements: DEPTH, payload: PAYLOAD }).fixed();
const BY_ID: DsPic33CanFdPlan = COMMON.txq(DEPTH, PAYLOAD).fixed();

#[derive(Clone, Copy)]
pub struct CanFd {
    id: Handle<Dspic33CanfdModel>,
    ram: MemoryId,
}

impl Bench for CanFd {
    type Can<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;

    const EXPECTED: Capabilities = Capabilities {
        fd: true,
        // 6.9.1.
        one_shot: true,
        // 6.11.
        remote_reply: true,
        tx_events: true,
        timestamp_bits: 32,
        // 9.2: a message that finds its FIFO full is lost.
        overwrite: false,
        priority_by_id: true,
        last_error: true,
        restricted: true,
        // 4.6.3: while the device sleeps.
        wake_on_traffic: true,
        loses_silently: false,
        // 13.1.
        recovers_by_itself: true,
    };
    const RX_DEPTH: usize = 4;
    const TX_DEPTH: usize = 3;
    const TELLS_SENT_ANYWAY: bool = true;
    const TIMESTAMP_UNIT: Time = Time::from_us(1);
    // 4.1.5: eleven bits of bus integration, and a message that is not to be broken off, at 100 ns for each poll.
    const MODE_POLLS: u32 = 5_000;

    fn add(sim: &Sim, name: &str) -> Self {
        let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16, 32]));
        let id = sim.add_dspic33_canfd(name, Dspic33CanfdConfig::new(ram)).unwrap();
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
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(sim.memory(self.ram), BASE, BYTES) };
        let plan = if setup.by_id { &BY_ID } else { &IN_ORDER };
        let mut can = Can::new(sim.registers(self.id), region, plan, Polls(Self::MODE_POLLS)).unwrap();
        let single = |id: Id, fifo| match id {
            Id::Standard(id) => Filter::standard(id, fifo),
            Id::Extended(id) => Filter::extended(id, fifo),
        };
        let replies: Vec<Reply> = setup.reply.into_iter().map(|frame| Reply { fifo: 3, frame }).collect();
        let mut filters: Vec<Filter> = setup.reply.into_iter().map(|frame| single(frame.id(), 3)).collect();
        filters.extend(setup.accept.iter().map(|id| single(*id, 1)));
        if setup.accept.is_empty() {
            filters.push(Filter::any(1));
        }
        let mut config = Config::new(TIMING).with_filters(&filters);
        if setup.fd {
            config = config.with_fd();
        }
        config.attempts = if setup.one_shot { Attempts::None } else { Attempts::Unlimited };
        config.replies = &replies;
        config.timestamps = Timestamping::Counter { clocks: 40, reference: Reference::StartOfFrame };
        config.blocking_polls = 1_000;
        assert!(!setup.overwrite, "FIFOs do not overwrite");
        can.configure(&config).unwrap();
        can
    }

    fn enable_receive_interrupt(can: &mut <Self::Can<'_> as Configured>::Running) {
        can.enable_interrupts(MainFlags::RXIF);
    }

    /// 4.6.1: the third step.
    fn device_sleeps(self, sim: &Sim) {
        sim.act(self.id, |model, cx| model.set_device_mode(cx, DeviceMode::Sleep));
    }
}
