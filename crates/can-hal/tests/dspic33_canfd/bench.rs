//! A dsPIC33 CAN FD module driven through the HAL.

use can_hal::{
    Frame, Polls, Region,
    dspic33_canfd::{Can, Config, Filter, PayloadSize},
    memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan},
    mode::{Configuration, Running},
    timing::{DsPic33CanFdTiming, Request, SamplePoint},
};
use can_sim::{
    AccessRecord, Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    dspic33_canfd::{Dspic33CanfdConfig, Dspic33CanfdModel},
};
use can_wire::NodeConfig;

pub type Driver<'a, S> = Can<S, RegisterBus<'a>, MemoryBus<'a>>;

/// System RAM: its address, and its bytes.
pub const BASE: u32 = 0x1000;
pub const BYTES: u32 = 0x2000;

/// 1 Mbit/s and 5 Mbit/s at 40 MHz, with the sample points of [`NodeConfig::new`].
pub const REQUEST: Request = Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000);
pub const TIMING: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(&REQUEST);

pub const MEMORY: DsPic33CanFdMemory = DsPic33CanFdMemory::new(BASE, BYTES);

pub const fn tx(elements: u32, payload: PayloadSize) -> DsPic33CanFdFifo {
    DsPic33CanFdFifo::Transmit { elements, payload }
}

pub const fn rx(elements: u32, payload: PayloadSize, timestamps: bool) -> DsPic33CanFdFifo {
    DsPic33CanFdFifo::Receive { elements, payload, timestamps }
}

/// A bit of everything: events, queue, FIFO 1 and 2 receive, FIFO 3 to 5 transmit.
pub const PLAN: DsPic33CanFdPlan = MEMORY
    .tef(4, true)
    .txq(4, PayloadSize::Bytes64)
    .fifo(1, rx(4, PayloadSize::Bytes64, true))
    .fifo(2, rx(2, PayloadSize::Bytes8, false))
    .fifo(3, tx(4, PayloadSize::Bytes64))
    .fifo(4, tx(2, PayloadSize::Bytes8))
    .fifo(5, tx(1, PayloadSize::Bytes8))
    .fixed();

pub const ALL: [Filter; 1] = [Filter::any(1)];

/// A configuration that receives everything in FIFO 1.
pub const CONFIG: Config<'static> = Config::new(TIMING).with_fd().with_filters(&ALL);

/// Bounds: eleven bits of bus integration, and a frame that is not to be broken off.
pub const MODE: Polls = Polls(10_000);

/// Longer than any frame.
pub const FRAME: Time = Time::from_us(700);

pub struct Bench {
    pub sim: Sim,
    pub id: Handle<Dspic33CanfdModel>,
    pub ram: MemoryId,
}

impl Bench {
    pub fn new() -> Self {
        Self::with(|config| config)
    }

    pub fn with(change: impl FnOnce(Dspic33CanfdConfig) -> Dspic33CanfdConfig) -> Self {
        let sim = Sim::new();
        let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16, 32]));
        let id = sim.add_dspic33_canfd("can0", change(Dspic33CanfdConfig::new(ram))).unwrap();
        Self { sim, id, ram }
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    pub fn region(&self) -> Region<MemoryBus<'_>> {
        // SAFETY: nothing else uses this memory.
        unsafe { Region::new(self.sim.memory(self.ram), BASE, BYTES) }
    }

    pub fn driver(&self, plan: &DsPic33CanFdPlan) -> Driver<'_, Configuration> {
        Can::new(self.sim.registers(self.id), self.region(), plan, MODE).unwrap()
    }

    pub fn configured(&self, plan: &DsPic33CanFdPlan, config: &Config<'_>) -> Driver<'_, Configuration> {
        let mut can = self.driver(plan);
        can.configure(config).unwrap();
        can
    }

    pub fn running(&self, config: &Config<'_>) -> Driver<'_, Running> {
        self.running_on(&PLAN, config)
    }

    pub fn running_on(&self, plan: &DsPic33CanFdPlan, config: &Config<'_>) -> Driver<'_, Running> {
        self.configured(plan, config).start_normal(MODE).unwrap()
    }

    pub fn peer(&self) -> PeerId {
        let peer = self.sim.add_peer(NodeConfig::new()).unwrap();
        self.sim.run_for(FRAME);
        peer
    }

    /// What a peer has seen, as text.
    pub fn seen(&self, peer: PeerId) -> Vec<String> {
        self.sim.peer_received(peer).iter().map(|(_, frame)| frame.to_string()).collect()
    }

    /// Lets a peer send, one frame after the other, until all have arrived.
    pub fn send(&self, peer: PeerId, texts: &[&str]) {
        for text in texts {
            self.sim.peer_send(peer, frame(text));
        }
        self.sim.run_for(FRAME * texts.len() as u64);
    }

    /// Keeps the bus busy with a frame of a peer, so that what is sent has to wait.
    pub fn busy(&self, peer: PeerId) {
        self.sim.peer_send(peer, frame("000#0000000000000000"));
        self.sim.run_for(Time::from_us(20));
    }

    /// The registers accessed since the trace was begun: name, true for a write, what was moved.
    pub fn accesses(&self) -> Vec<(String, bool, u32)> {
        let touched = |record: AccessRecord| Some((record.register?.name, record.write, record.value));
        self.sim.trace(false).into_iter().filter_map(touched).collect()
    }

    /// The values written to a register since the trace was begun.
    pub fn written(&self, register: &str) -> Vec<u32> {
        let accesses = self.accesses().into_iter();
        accesses.filter(|(name, write, _)| *write && name == register).map(|(.., value)| value).collect()
    }

    pub fn finish(&self) {
        assert_eq!(self.sim.diagnostics(), []);
    }
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}
