//! An ECAN module driven through the HAL.

use can_hal::{
    ExtendedId, Frame, Id, Polls, Region, StandardId,
    dspic33_ecan::{BufferCount, Can, Config, Filter, FilterTarget, Mask, MaskSource, Use},
    memory::{DsPic33EcanMemory, DsPic33EcanPlan},
    mode::{Configuration, Running},
    timing::{BitTiming, DsPic33EcanTiming, Segments},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    dspic33_ecan::{EcanConfig, EcanModel},
};
use can_wire::{FdSupport, NodeConfig};

pub type Driver<'a, S> = Can<S, RegisterBus<'a>, MemoryBus<'a>>;

/// Example 6-1: 20 time quanta, 1 Mbit/s with FCY 40 MHz, sample point at 70 %.
pub const SEGMENTS: Segments = Segments { prescaler: 1, propagation: 5, phase1: 8, phase2: 6, jump_width: 4 };

pub const TIMING: DsPic33EcanTiming =
    match DsPic33EcanTiming::of(&BitTiming { nominal: SEGMENTS, data: None, three_samples: true }) {
        Ok(timing) => timing,
        Err(_) => panic!("the manual's example keeps the limits"),
    };

/// Bytes of DMA RAM.
pub const BYTES: u32 = 1024;

/// Example 8-1: 32 buffers, `CAN1MsgBuf[32][8]`. The FIFO is the upper half.
pub const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers32, 16).fixed();

/// Figure 9-6: twelve buffers, the FIFO from buffer 5 to 11.
pub const FIFO_5_TO_11: DsPic33EcanPlan = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers12, 5).fixed();

/// Changes of mode wait for a frame and 11 recessive bits.
pub const MODE: Polls = Polls(3_000);

/// Longer than any frame.
pub const FRAME: Time = Time::from_us(170);

/// Everything into buffer 8.
pub const TO_BUFFER_8: &[Filter] = &[Filter::any(FilterTarget::Buffer(8), MaskSource::Mask0)];

/// Everything into the FIFO.
pub const TO_FIFO: &[Filter] = &[Filter::any(FilterTarget::Fifo, MaskSource::Mask0)];

/// Everything into buffer 8, one buffer sends.
pub const CONFIG: Config<'static> = Config::new(TIMING).with_filters([Mask::ANY; 3], TO_BUFFER_8);

pub struct Bench {
    pub sim: Sim,
    pub id: Handle<EcanModel>,
    pub ram: MemoryId,
}

impl Bench {
    pub fn new() -> Self {
        Self::with(|config| config)
    }

    pub fn with(change: impl FnOnce(EcanConfig) -> EcanConfig) -> Self {
        let sim = Sim::new();
        let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16]));
        let id = sim.add_dspic33_ecan("can1", change(EcanConfig::new(ram))).unwrap();
        Self { sim, id, ram }
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    pub fn driver(&self, plan: &DsPic33EcanPlan) -> Driver<'_, Configuration> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(self.sim.memory(self.ram), 0, BYTES) };
        Can::new(self.sim.registers(self.id), region, plan, MODE).unwrap()
    }

    pub fn configured(&self, plan: &DsPic33EcanPlan, config: &Config<'_>) -> Driver<'_, Configuration> {
        let mut can = self.driver(plan);
        can.configure(config).unwrap();
        can
    }

    pub fn running(&self, plan: &DsPic33EcanPlan, config: &Config<'_>) -> Driver<'_, Running> {
        self.configured(plan, config).start_normal(MODE).unwrap()
    }

    /// A node of the same bit timing.
    pub fn peer(&self) -> PeerId {
        let nominal = can_wire::BitTiming { prescaler: 2, prop_seg: 5, phase_seg1: 8, phase_seg2: 6, sjw: 4 };
        let config = NodeConfig { nominal, data: nominal, fd: FdSupport::Classic, ..NodeConfig::new() };
        let peer = self.sim.add_peer(config).unwrap();
        self.sim.run_for(Time::from_us(15));
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

    /// The words of a buffer in DMA RAM.
    pub fn words(&self, buffer: u8) -> [u16; 8] {
        let memory = self.sim.with_memory(self.ram, |memory| memory.clone());
        self.sim.inspect(self.id, |model| model.buffer(&memory, buffer).words)
    }

    pub fn finish(&self) {
        assert_eq!(self.sim.diagnostics(), []);
    }
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

pub fn standard(id: u16) -> Id {
    Id::Standard(StandardId::new(id).unwrap())
}

pub fn extended(id: u32) -> Id {
    Id::Extended(ExtendedId::new(id).unwrap())
}

/// The configuration with uses of some buffers.
pub fn sending(uses: &[(usize, Use)]) -> Config<'static> {
    uses.iter().fold(CONFIG, |config, (buffer, use_)| config.with_use(*buffer, *use_))
}
