//! An M_CAN driven through the HAL.

use can_hal::{
    Frame, Polls, Region,
    m_can::{Can, Config, DataFieldSize},
    memory::MCanMemory,
    mode::{Configuration, Running},
    timing::{MCanTiming, Request, SamplePoint},
};
use can_sim::{
    AccessRecord, Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    m_can::{MCanConfig, MCanModel},
};
use can_wire::NodeConfig;

pub type Driver<'a, S> = Can<S, RegisterBus<'a>, MemoryBus<'a>>;

/// 1 Mbit/s and 5 Mbit/s at 40 MHz, with the sample points of [`NodeConfig::new`]: nodes that switch the bit rate do so at
/// their sample point, so all have to have the same.
pub const REQUEST: Request = Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000);
pub const TIMING: MCanTiming = MCanTiming::fixed(&REQUEST);

/// Some of everything, with room for 64 data bytes.
pub const MEMORY: MCanMemory = MCanMemory::new(4352 * 4)
    .standard_filters(8)
    .extended_filters(4)
    .rx_fifo_0(6, DataFieldSize::Bytes64)
    .rx_fifo_1(4, DataFieldSize::Bytes64)
    .rx_buffers(64, DataFieldSize::Bytes64)
    .tx_event_fifo(4)
    .tx_buffers(3, 4, DataFieldSize::Bytes64);

/// Longer than any frame.
pub const FRAME: Time = Time::from_us(700);

pub struct Bench {
    pub sim: Sim,
    pub id: Handle<MCanModel>,
    pub ram: MemoryId,
}

impl Bench {
    pub fn new() -> Self {
        Self::with(|config| config)
    }

    pub fn with(change: impl FnOnce(MCanConfig) -> MCanConfig) -> Self {
        Self::on(Sim::new(), change)
    }

    /// A host whose accesses are faster than the clock domain crossing of the controller (2.2).
    pub fn with_fast_host(change: impl FnOnce(MCanConfig) -> MCanConfig) -> Self {
        Self::on(Sim::builder().access_cost(Time::from_ns(10)).build(), change)
    }

    fn on(sim: Sim, change: impl FnOnce(MCanConfig) -> MCanConfig) -> Self {
        let ram = sim.add_memory(Memory::new(4352));
        let id = sim.add_m_can("can0", change(MCanConfig::new(ram))).unwrap();
        Self { sim, id, ram }
    }

    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    pub fn driver(&self, memory: &MCanMemory) -> Driver<'_, Configuration> {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(self.sim.memory(self.ram), 0, 4352 * 4) };
        Can::new(self.sim.registers(self.id), region, &memory.plan().unwrap(), Polls(200)).unwrap()
    }

    pub fn configured(&self, config: &Config<'_>) -> Driver<'_, Configuration> {
        let mut can = self.driver(&MEMORY);
        can.configure(config).unwrap();
        can
    }

    pub fn running(&self, config: &Config<'_>) -> Driver<'_, Running> {
        let can = self.configured(config).start_normal(Polls(20)).unwrap();
        self.sim.run_for(FRAME);
        can
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

    /// The registers accessed since the trace was begun: name, and true for a write.
    pub fn accesses(&self) -> Vec<(String, bool, u32)> {
        let touched = |record: AccessRecord| {
            let register = record.register?;
            Some((register.name, record.write, record.value))
        };
        self.sim.trace(false).into_iter().filter_map(touched).collect()
    }

    pub fn finish(&self) {
        assert_eq!(self.sim.diagnostics(), []);
    }
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

pub fn frames(texts: &[&str]) -> Vec<Frame> {
    texts.iter().map(|text| frame(text)).collect()
}

/// The frames of received messages, as text.
pub fn texts(messages: &[can_hal::m_can::RxMessage]) -> Vec<String> {
    messages.iter().map(|message| message.frame.to_string()).collect()
}
