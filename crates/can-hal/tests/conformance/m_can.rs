//! The bench of M_CAN.

use can_hal::{
    Capabilities, Configured, Id, Polls, Region,
    m_can::{Can, Config, DataFieldSize, FifoMode, Filter, Interrupts, Line, Timestamping, TxMode},
    memory::{MCanMemory, MCanPlan},
    mode::Configuration,
    timing::{MCanTiming, Request, SamplePoint},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim, Time,
    m_can::{MCanConfig, MCanModel},
};
use can_wire::NodeId;

use crate::bench::{Bench, Setup};

/// Words of a Message RAM.
const WORDS: usize = 4352;

/// The sample points of `NodeConfig::new`.
const TIMING: MCanTiming =
    MCanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000));

const PLAN: MCanPlan = MCanMemory::new(WORDS as u32 * 4)
    .standard_filters(4)
    .extended_filters(4)
    .rx_fifo_0(MCan::RX_DEPTH as u32, DataFieldSize::Bytes64)
    .tx_buffers(0, MCan::TX_DEPTH as u32, DataFieldSize::Bytes64)
    .fixed();

#[derive(Clone, Copy)]
pub struct MCan {
    id: Handle<MCanModel>,
    ram: MemoryId,
}

impl Bench for MCan {
    type Can<'a> = Can<Configuration, RegisterBus<'a>, MemoryBus<'a>>;

    const EXPECTED: Capabilities = Capabilities {
        fd: true,
        one_shot: true,
        // 3.1.2: a remote frame gets no automatic response.
        remote_reply: false,
        tx_events: true,
        timestamp_bits: 16,
        overwrite: true,
        priority_by_id: true,
        last_error: true,
        restricted: true,
        // 3.1.8: only the Host ends a clock stop.
        wake_on_traffic: false,
        loses_silently: false,
        // 2.3.14: Bus_Off sets CCCR.INIT.
        recovers_by_itself: false,
    };
    const RX_DEPTH: usize = 4;
    const TX_DEPTH: usize = 3;
    const TELLS_SENT_ANYWAY: bool = true;
    const TIMESTAMP_UNIT: Time = Time::from_us(1);
    const MODE_POLLS: u32 = 20;

    fn add(sim: &Sim, name: &str) -> Self {
        let ram = sim.add_memory(Memory::new(WORDS));
        let id = sim.add_m_can(name, MCanConfig::new(ram)).unwrap();
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
        let region = unsafe { Region::new(sim.memory(self.ram), 0, WORDS as u32 * 4) };
        let mut can = Can::new(sim.registers(self.id), region, &PLAN, Polls(Self::MODE_POLLS)).unwrap();
        let action = can_hal::m_can::Action::Fifo0;
        let (mut standard, mut extended) = (Vec::new(), Vec::new());
        for id in setup.accept {
            match *id {
                Id::Standard(id) => standard.push(Filter::exact(id, action)),
                Id::Extended(id) => extended.push(Filter::exact(id, action)),
            }
        }
        let mut config = Config::new(TIMING);
        if setup.fd {
            config = config.with_fd();
        }
        if !setup.accept.is_empty() {
            config = config.with_filters(&standard, &extended);
        }
        config.one_shot = setup.one_shot;
        config.tx_mode = if setup.by_id { TxMode::Queue } else { TxMode::Fifo };
        config.rx_mode = [if setup.overwrite { FifoMode::Overwrite } else { FifoMode::Blocking }; 2];
        config.timestamps = Timestamping::Counter { bit_times: 1 };
        config.blocking_polls = 1_000;
        assert_eq!(setup.reply, None, "M_CAN does not answer");
        can.configure(&config).unwrap();
        can
    }

    fn enable_receive_interrupt(can: &mut <Self::Can<'_> as Configured>::Running) {
        can.enable_interrupts(Interrupts::RF0N, Line::Int0);
    }
}
