//! Bosch M_CAN. Sections in comments are of its User's Manual, revision 3.3.1.
//!
//! ```
//! use can_hal::{Polls, Region, m_can::{Can, Config, DataFieldSize}};
//! use can_hal::{memory::{MCanMemory, MCanPlan}, timing::{MCanTiming, Request}};
//! # use can_hal::{Configured, Frame, Receive, StandardId, Transmit, Outcome};
//!
//! // Both are checked when this is compiled.
//! const TIMING: MCanTiming = MCanTiming::fixed(&Request::new(40_000_000, 1_000_000));
//! const PLAN: MCanPlan = MCanMemory::new(4352 * 4)
//!     .rx_fifo_0(8, DataFieldSize::Bytes8)
//!     .tx_buffers(0, 4, DataFieldSize::Bytes8)
//!     .fixed();
//! # let sim = can_sim::Sim::new();
//! # let ram = sim.add_memory(can_sim::Memory::new(4352));
//! # let id = sim.add_m_can("can0", can_sim::m_can::MCanConfig::new(ram))?;
//! # let (registers, memory) = (sim.registers(id), sim.memory(ram));
//! // On hardware `registers` and `memory` are `Mmio` at the addresses of the chip.
//! // SAFETY: nothing else uses this Message RAM.
//! let region = unsafe { Region::new(memory, 0, 4352 * 4) };
//! let mut can = Can::new(registers, region, &PLAN, Polls(100))?;
//! can.configure(&Config::new(TIMING))?;
//! let mut can = can.start_loop_back(Polls(100)).map_err(|refused| refused.error)?;
//!
//! let frame = Frame::data(StandardId::new(0x123).ok_or("id")?, b"hello")?;
//! let ticket = can.send(&frame)?;
//! assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
//! let received = can.fetch()?.ok_or("nothing received")?;
//! assert_eq!(received.frame, frame);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A call that needs configuration mode does not compile while the controller runs:
//!
//! ```compile_fail,E0599
//! # use can_hal::{mode::Running, m_can::{Can, Config}};
//! # use regbus::Bus;
//! fn reconfigure<B: Bus>(mut can: Can<Running, B, B>, config: &Config<'_>) {
//!     can.configure(config);
//! }
//! ```
//!
//! Nor does sending while it only listens:
//!
//! ```compile_fail,E0599
//! # use can_hal::{Frame, mode::ListenOnly, m_can::{Can, TxOptions}};
//! # use regbus::Bus;
//! fn send<B: Bus>(mut can: Can<ListenOnly, B, B>, frame: &Frame) {
//!     can.send_queued(frame, TxOptions::default());
//! }
//! ```

mod common;
mod config;
mod element;
mod filter;
mod interrupts;
mod layout;
mod modes;
mod rx;
mod status;
mod tx;
mod tx_event;

use core::{fmt, marker::PhantomData};

use m_can_pac::{MCan, Mmio, registers as pac};
use regbus::Bus;

use crate::{Deadline, Region, deadline::wait, error::Refused, memory::MCanPlan, mode::Configuration};
use layout::Layout;

pub use config::{Config, ConfigError, FdMode, Timeout, Timestamping, TxMode};
pub use filter::{Action, DebugMessage, ExtendedFilter, Filter, FilterError, Matching, StandardFilter};
pub use interrupts::Line;
pub use m_can_pac::{
    enums::{DataFieldSize, FifoMode, NonMatching, ToccTos as TimeoutSource},
    registers::Ir as Interrupts,
};
pub use rx::{FifoStatus, RxFifo, RxMessage, RxTimestamp};
pub use status::{Activity, DebugState, HighPriority, HighPriorityStorage, ProtocolStatus};
pub use tx::{Ticket, TxOptions, TxQueueStatus};
pub use tx_event::{TxEvent, TxEventKind};

/// An M_CAN in mode `S`, with registers behind `R` and Message RAM behind `M`.
pub struct Can<S, R: Bus = Mmio, M: Bus = R> {
    inner: Inner<R, M>,
    mode: PhantomData<S>,
}

/// What does not depend on the mode.
struct Inner<R: Bus, M: Bus> {
    regs: MCan<R>,
    ram: M,
    layout: Layout,
    /// The bits of CCCR that the configuration sets. Every write of CCCR starts from them, never from what was read:
    /// hardware changes CSR, ASM and INIT (2.3.7).
    cccr: pac::Cccr,
    /// Buffers whose cancellation was requested and not asked for yet.
    cancelled: u32,
    /// Buffers whose request was made and not yet seen.
    unseen: u32,
    /// The put index of the last request, and the get indices last acknowledged: until the other clock domain has taken
    /// them over, the status still shows them (2.2).
    put: Option<u8>,
    acknowledged: [Option<u8>; 2],
    blocking_polls: u32,
}

/// How often a status that a command must have changed is read again. Clock domain crossing takes a few periods of the
/// CAN clock (2.2), a read of a register about as long.
const SETTLE: u32 = 16;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Takes an M_CAN and its part of the Message RAM, and brings it to configuration mode (3.1.1). A node that is on the
    /// bus leaves it at once.
    ///
    /// # Errors
    /// [`ConfigError::OutsideRegion`] if a section of the plan does not lie in the region, [`ConfigError::TimedOut`] if the controller does not follow.
    pub fn new(
        registers: R,
        region: Region<M>,
        plan: &MCanPlan,
        mut deadline: impl Deadline,
    ) -> Result<Self, ConfigError> {
        let layout = Layout::new(plan, &region)?;
        let regs = MCan::new(registers);
        // What else is set there can be changed only in configuration mode.
        let stopped = regs.cccr().read().with_init(true).with_csr(false);
        regs.cccr().write(stopped);
        wait(&mut deadline, || regs.cccr().read().init())?;
        // 3.1.1: CCE can be set only while INIT is 1, so not in the same write.
        regs.cccr().write(stopped.with_cce(true));
        let inner = Inner {
            regs,
            ram: region.bus(),
            layout,
            cccr: pac::Cccr::ZERO,
            cancelled: 0,
            unseen: 0,
            put: None,
            acknowledged: [None; 2],
            blocking_polls: Config::BLOCKING_POLLS,
        };
        Ok(Self { inner, mode: PhantomData })
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// The registers, for what this crate does not do. Do not change what it relies on.
    pub const fn registers(&self) -> &MCan<R> {
        &self.inner.regs
    }

    /// Data bytes that an element of an Rx FIFO holds.
    #[must_use]
    pub const fn fifo_data_len(&self, fifo: RxFifo) -> usize {
        self.inner.layout.rx_fifos[fifo.index()].data()
    }

    /// Data bytes that a Tx Buffer holds.
    #[must_use]
    pub const fn tx_data_len(&self) -> usize {
        self.inner.layout.tx_buffers.data()
    }

    fn into_mode<T>(self) -> Can<T, R, M> {
        Can { inner: self.inner, mode: PhantomData }
    }

    fn refuse<E>(self, error: E) -> Refused<Self, E> {
        Refused { can: self, error }
    }

    pub(crate) const fn blocking_polls(&self) -> u32 {
        self.inner.blocking_polls
    }
}

impl<S, R: Bus, M: Bus> fmt::Debug for Can<S, R, M> {
    /// Touches no register.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "m_can::Can<{}>", core::any::type_name::<S>())
    }
}
