//! Microchip dsPIC33 CAN FD module. Sections in comments are of its reference manual section, revision C.
//!
//! ```
//! use can_hal::{Polls, Region, dspic33_canfd::{Can, Config, Filter, PayloadSize}};
//! use can_hal::{memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan}, timing::{DsPic33CanFdTiming, Request}};
//! # use can_hal::{Configured, Frame, Receive, StandardId, Transmit, Outcome};
//!
//! // Both are checked when this is compiled. FIFO 1 receives, FIFO 2 transmits.
//! const TIMING: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(&Request::new(40_000_000, 1_000_000));
//! const PLAN: DsPic33CanFdPlan = DsPic33CanFdMemory::new(0x1000, 0x1000)
//!     .fifo(1, DsPic33CanFdFifo::Receive { elements: 8, payload: PayloadSize::Bytes8, timestamps: false })
//!     .fifo(2, DsPic33CanFdFifo::Transmit { elements: 4, payload: PayloadSize::Bytes8 })
//!     .fixed();
//! # let sim = can_sim::Sim::new();
//! # let ram = sim.add_memory(can_sim::Memory::new(1024).with_widths(&[8, 16, 32]));
//! # let id = sim.add_dspic33_canfd("can0", can_sim::dspic33_canfd::Dspic33CanfdConfig::new(ram))?;
//! # let (registers, memory) = (sim.registers(id), sim.memory(ram));
//! // On hardware `registers` and `memory` are `Mmio` at the addresses of the chip.
//! // SAFETY: nothing else uses this memory.
//! let region = unsafe { Region::new(memory, 0x1000, 0x1000) };
//! let mut can = Can::new(registers, region, &PLAN, Polls(1_000))?;
//! can.configure(&Config::new(TIMING).with_filters(&[Filter::any(1)]))?;
//! let mut can = can.start_loop_back(Polls(1_000)).map_err(|refused| refused.error)?;
//!
//! let frame = Frame::data(StandardId::new(0x123).ok_or("id")?, b"hello")?;
//! let ticket = can.send(&frame)?;
//! assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
//! let received = can.fetch()?.ok_or("nothing received")?;
//! assert_eq!(received.frame, frame);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A call that needs Configuration mode does not compile while the module runs:
//!
//! ```compile_fail,E0599
//! # use can_hal::{mode::Running, dspic33_canfd::{Can, Config}};
//! # use regbus::Bus;
//! fn reconfigure<B: Bus>(mut can: Can<Running, B, B>, config: &Config<'_>) {
//!     can.configure(config);
//! }
//! ```
//!
//! Nor does sending while it only listens:
//!
//! ```compile_fail,E0599
//! # use can_hal::{Frame, mode::ListenOnly, dspic33_canfd::{Can, TxOptions}};
//! # use regbus::Bus;
//! fn send<B: Bus>(mut can: Can<ListenOnly, B, B>, frame: &Frame) {
//!     can.send_queued(frame, TxOptions::default());
//! }
//! ```

mod common;
mod config;
mod filter;
mod interrupts;
mod layout;
mod modes;
mod object;
mod rx;
mod status;
mod tx;
mod tx_event;

use core::{fmt, marker::PhantomData};

use dspic33_canfd_pac::{Dspic33Canfd, Fifo, Mmio, registers as pac};
use regbus::Bus;

use crate::{Deadline, Region, deadline::wait, error::Refused, memory::DsPic33CanFdPlan, mode::Configuration};
use layout::Layout;

pub use config::{Attempts, Config, ConfigError, FdMode, Reference, Reply, Timestamping};
pub use dspic33_canfd_pac::{
    enums::{ConHTxbws as BandwidthSharing, ConLWft as WakeUpFilter, OperationMode, PayloadSize},
    registers::IntL as MainFlags,
};
pub use filter::{Filter, FilterError, Matching};
pub use interrupts::{Codes, Interrupts};
pub use rx::RxMessage;
pub use status::Diagnostics;
pub use tx::{Sequence, Ticket, TxOptions};
pub use tx_event::TxEvent;

/// A CAN FD module in mode `S`, with registers behind `R` and message memory behind `M`.
pub struct Can<S, R: Bus = Mmio, M: Bus = R> {
    inner: Inner<R, M>,
    mode: PhantomData<S>,
}

/// What does not depend on the mode.
struct Inner<R: Bus, M: Bus> {
    regs: Dspic33Canfd<R>,
    ram: M,
    /// Address of the region as the module sees it.
    base: u32,
    layout: Layout,
    /// The bits of CONH that the configuration sets. Every write of CONH starts from them.
    con_h: pac::ConH,
    fd: FdMode,
    /// FIFOs that answer remote frames.
    replies: u32,
    tracks: [tx::Track; 32],
    /// What BDIAG1H has shown since the last snapshot.
    diagnosis: pac::Bdiag1H,
    blocking_polls: u32,
}

/// How often a register that follows a command within a few clock periods is read.
const SETTLE: u32 = 8;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Takes a module and its message memory, enables it and brings it to Configuration mode (4.2). A node that is on the
    /// bus leaves it when the message there is over.
    ///
    /// # Errors
    /// [`ConfigError::OutsideRegion`] if a section of the plan does not lie in the region, [`ConfigError::TimedOut`] if
    /// the module does not follow.
    pub fn new(
        registers: R,
        region: Region<M>,
        plan: &DsPic33CanFdPlan,
        mut deadline: impl Deadline,
    ) -> Result<Self, ConfigError> {
        let layout = Layout::new(plan, &region)?;
        let regs = Dspic33Canfd::new(registers);
        regs.con_l().modify(|con_l| con_l.with_con(true));
        let con_h = regs.con_h();
        con_h.modify(|con_h| con_h.with_reqop(OperationMode::Configuration));
        wait(&mut deadline, || con_h.read().opmod() == OperationMode::Configuration)?;
        let inner = Inner {
            regs,
            ram: region.bus(),
            base: region.address(),
            layout,
            con_h: pac::ConH::ZERO,
            fd: FdMode::Classic,
            replies: 0,
            tracks: Default::default(),
            diagnosis: pac::Bdiag1H::ZERO,
            blocking_polls: Config::BLOCKING_POLLS,
        };
        Ok(Self { inner, mode: PhantomData })
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// The registers, for what this crate does not do. Do not change what it relies on.
    pub const fn registers(&self) -> &Dspic33Canfd<R> {
        &self.inner.regs
    }

    /// Data bytes that an object of a FIFO holds, or of the queue for 0; 0 if the plan has no such FIFO.
    #[must_use]
    pub fn data_len(&self, fifo: u8) -> usize {
        self.inner.layout.objects.get(usize::from(fifo)).map_or(0, layout::Section::data)
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

impl<R: Bus, M: Bus> Inner<R, M> {
    /// The registers of a FIFO, 1 to 31. The bounds never act; they tell the compiler that there is such a FIFO.
    #[inline]
    fn fifo(&self, number: u8) -> Fifo<R> {
        self.regs.fifo(usize::from(number % 32).max(1))
    }
}

impl<S, R: Bus, M: Bus> fmt::Debug for Can<S, R, M> {
    /// Touches no register.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "dspic33_canfd::Can<{}>", core::any::type_name::<S>())
    }
}
