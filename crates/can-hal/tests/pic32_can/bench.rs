//! A PIC32MX CAN module driven through the HAL.

use can_hal::{
    Frame, Polls, Region,
    memory::Pic32CanMemory,
    mode::{Configuration, Running},
    pic32_can::{Can, Config, Filter, Mask},
    timing::{BitTiming, Pic32CanTiming, Segments},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    pic32_can::{Pic32CanConfig, Pic32CanModel},
};
use can_wire::NodeConfig;

pub type Driver<'a, S> = Can<S, RegisterBus<'a>, MemoryBus<'a>>;

/// Words of system RAM.
pub const WORDS: usize = 2048;

/// 1 Mbit/s at 80 MHz: Example 34-17, with the jump width of 2 quanta that its comment says.
pub const TIMING: Pic32CanTiming = match Pic32CanTiming::of(&BIT_TIMING) {
    Ok(timing) => timing,
    Err(_) => panic!("the timing of the example keeps the limits"),
};

pub const BIT_TIMING: BitTiming = BitTiming {
    nominal: Segments { prescaler: 4, propagation: 3, phase1: 3, phase2: 3, jump_width: 2 },
    data: None,
    three_samples: true,
};

/// Longer than any frame.
pub const FRAME: Time = Time::from_us(200);

/// Bound of waits: a frame may be on the bus.
pub const WAIT: Polls = Polls(3_000);

pub struct Bench {
    pub sim: Sim,
    pub id: Handle<Pic32CanModel>,
    pub ram: MemoryId,
    address: u32,
}

impl Bench {
    /// RAM from physical address 0 on.
    pub fn new() -> Self {
        Self::at(0)
    }

    pub fn at(address: u32) -> Self {
        let sim = Sim::new();
        let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
        let id = sim.add_pic32_can("can1", Pic32CanConfig::new(ram).with_memory_base(address)).unwrap();
        Self { sim, id, ram, address }
    }

    /// An empty plan whose FIFO 0 begins at `base`.
    pub fn memory(&self, base: u32) -> Pic32CanMemory {
        Pic32CanMemory::new(base, self.address + WORDS as u32 * 4 - base)
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    pub fn driver(&self, memory: &Pic32CanMemory) -> Driver<'_, Configuration> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(self.sim.memory(self.ram), self.address, WORDS as u32 * 4) };
        Can::new(self.sim.registers(self.id), region, &memory.plan().unwrap(), WAIT).unwrap()
    }

    pub fn configured(&self, memory: &Pic32CanMemory, config: &Config<'_>) -> Driver<'_, Configuration> {
        let mut can = self.driver(memory);
        can.configure(config).unwrap();
        can
    }

    pub fn running(&self, memory: &Pic32CanMemory, config: &Config<'_>) -> Driver<'_, Running> {
        self.configured(memory, config).start_normal(WAIT).unwrap()
    }

    pub fn peer(&self) -> PeerId {
        let mut config = NodeConfig::new().with_rate(1_000_000).unwrap();
        config.clock_hz = 80_000_000;
        config.nominal = can_wire::BitTiming { prescaler: 8, prop_seg: 3, phase_seg1: 3, phase_seg2: 3, sjw: 2 };
        let peer = self.sim.add_peer(config).unwrap();
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

    /// Words of the RAM at a physical address.
    pub fn words<const N: usize>(&self, address: u32) -> [u32; N] {
        let first = ((address - self.address) / 4) as usize;
        self.sim.with_memory(self.ram, |memory| core::array::from_fn(|n| memory.words()[first + n]))
    }

    /// The registers accessed since the trace was begun: name, true for a write, value, offset.
    pub fn accesses(&self) -> Vec<(String, bool, u32, u32)> {
        let touched = |record: can_sim::AccessRecord| {
            let register = record.register?;
            Some((register.name, record.write, record.value, record.offset))
        };
        self.sim.trace(false).into_iter().filter_map(touched).collect()
    }

    pub fn finish(&self) {
        assert_eq!(self.sim.diagnostics(), []);
    }
}

/// A filter that lets everything into a FIFO.
pub fn everything(fifo: u8) -> [Filter; 1] {
    [Filter::any(fifo)]
}

pub const ANY: [Mask; 4] = [Mask::ANY; 4];

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}
