//! Microchip dsPIC33F/PIC24H Enhanced CAN (ECAN). Sections in comments are of the Family Reference Manual DS70000185D.
//!
//! # DMA
//!
//! The DMA controller belongs to the device, and the caller sets it up before the module leaves configuration mode
//! (10.0, Example 10-1). Two channels are needed, one for each direction; none of them may serve both. For each:
//!
//! 1. word transfers (SIZE 0), peripheral indirect addressing (AMODE 2), continuous without ping-pong (MODE 0);
//! 2. direction from DMA RAM to the peripheral for transmission (DIR 1), the other way for reception (DIR 0);
//! 3. DMAxREQ with the number of the module's request (Table 10-1), DMAxCNT 7 for eight words in a message;
//! 4. DMAxPAD with the address of CxTXD or of CxRXD;
//! 5. DMAxSTA with [`DsPic33EcanPlan::start`], the same for both; then the channel is enabled.
//!
//! Without them nothing is sent or received, and the module does not tell.
//!
//! # Registers that are shared
//!
//! A control register serves two transmit buffers, and hardware changes the requests of both. Between the read and the
//! write of one for the sake of the other, a message could be sent twice or aborted. So this driver never has requests of
//! both buffers of a pair pending: with a request in one, the other counts as occupied.
//!
//! The window of the filter registers lies over the control and status registers. [`Can::set_filter`] and
//! [`Can::set_mask`] open it; keep interrupt handlers that use the module masked meanwhile.
//!
//! # Example
//!
//! ```
//! use can_hal::{Polls, Region, dspic33_ecan::*, memory::DsPic33EcanMemory, timing::*};
//! # use can_hal::{Configured, Frame, Receive, StandardId, Transmit, Outcome};
//! # let sim = can_sim::Sim::new();
//! # let ram = sim.add_memory(can_sim::Memory::new(256).with_widths(&[8, 16]));
//! # let id = sim.add_dspic33_ecan("can1", can_sim::dspic33_ecan::EcanConfig::new(ram))?;
//! # let (registers, memory) = (sim.registers(id), sim.memory(ram));
//! // On hardware `registers` and `memory` are `Mmio` at the addresses of the chip.
//! // SAFETY: nothing else uses this part of DMA RAM.
//! let region = unsafe { Region::new(memory, 0, 512) };
//! let plan = DsPic33EcanMemory::new(0, 1024, BufferCount::Buffers32, 8).plan()?;
//! let mut can = Can::new(registers, region, &plan, Polls(2_000))?;
//!
//! const TIMING: DsPic33EcanTiming = DsPic33EcanTiming::fixed(&Request::new(40_000_000, 1_000_000));
//! let everything = [Filter::any(FilterTarget::Fifo, MaskSource::Mask0)];
//! let config = Config::new(TIMING).with_queue(2).with_filters([Mask::ANY; 3], &everything);
//! can.configure(&config)?;
//! let mut can = can.start_loop_back(Polls(2_000)).map_err(|refused| refused.error)?;
//!
//! let frame = Frame::data(StandardId::new(0x123).ok_or("id")?, b"hello")?;
//! let ticket = can.send(&frame)?;
//! assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
//! let received = can.fetch()?.ok_or("nothing received")?;
//! assert_eq!(received.frame, frame);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A call that needs configuration mode does not compile while the module runs:
//!
//! ```compile_fail,E0599
//! # use can_hal::{mode::Running, dspic33_ecan::{Can, Config}};
//! # use regbus::Bus;
//! fn reconfigure<B: Bus>(mut can: Can<Running, B, B>, config: &Config<'_>) {
//!     can.configure(config);
//! }
//! ```
//!
//! Nor does sending while it only listens:
//!
//! ```compile_fail,E0599
//! # use can_hal::{Frame, mode::ListenOnly, dspic33_ecan::Can};
//! # use regbus::Bus;
//! fn send<B: Bus>(mut can: Can<ListenOnly, B, B>, frame: &Frame) {
//!     can.send_buffer(0, frame);
//! }
//! ```
//!
//! [`DsPic33EcanPlan::start`]: crate::memory::DsPic33EcanPlan::start

mod common;
mod config;
mod element;
mod filter;
mod interrupts;
mod modes;
mod rx;
mod status;
mod tx;

use core::{fmt, marker::PhantomData};

use dspic33_ecan_pac::{Dspic33Ecan, Mmio};
use regbus::Bus;

use crate::{
    Deadline, Region,
    error::Refused,
    memory::{DsPic33EcanPlan, Placed},
    mode::Configuration,
};

pub use config::{Config, ConfigError, Use};
pub use dspic33_ecan_pac::{
    enums::{BufferCount, FilterTarget, InterruptCode, MaskSource, TxPriority},
    registers::Intf as Interrupts,
};
pub use filter::{FILTERS, Filter, FilterError, Mask};
pub use rx::{FifoStatus, RxMessage};
pub use status::ModuleStatus;
pub use tx::Ticket;

/// An ECAN module in mode `S`, with registers behind `R` and DMA RAM behind `M`.
pub struct Can<S, R: Bus = Mmio, M: Bus = R> {
    inner: Inner<R, M>,
    mode: PhantomData<S>,
}

/// What does not depend on the mode.
struct Inner<R: Bus, M: Bus> {
    regs: Dspic33Ecan<R>,
    ram: M,
    layout: Layout,
    tx: tx::Tx,
    rx: rx::Rx,
    blocking_polls: u32,
}

/// Where the buffers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Layout {
    /// Bytes from the start of the region to buffer 0.
    offset: usize,
    plan: DsPic33EcanPlan,
}

impl Layout {
    fn new<M: Bus>(plan: &DsPic33EcanPlan, region: &Region<M>) -> Result<Self, ConfigError> {
        let placed = plan.buffers();
        let end = u64::from(region.address()) + u64::from(region.bytes());
        match placed.start.checked_sub(region.address()) {
            Some(offset) if placed.end() <= end => Ok(Self { offset: offset as usize, plan: *plan }),
            _ => Err(ConfigError::OutsideRegion(placed)),
        }
    }

    const fn buffers(&self) -> Placed {
        self.plan.buffers()
    }

    /// Number of buffers.
    const fn count(&self) -> u8 {
        self.buffers().elements as u8
    }

    /// First and last buffer of the FIFO (9.3).
    const fn fifo(&self) -> (u8, u8) {
        (self.plan.fctrl.fsa(), self.count() - 1)
    }

    /// Offset of a buffer in the region (9.2).
    #[inline]
    const fn at(&self, buffer: u8) -> usize {
        self.offset + self.buffers().element_bytes as usize * buffer as usize
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Takes an ECAN module and its buffers in DMA RAM, and brings it to configuration mode (7.1). All filters are
    /// disabled. The region's address counts from the start of DMA RAM, as DMAxSTA does.
    ///
    /// # Errors
    /// [`ConfigError::OutsideRegion`] if the buffers of the plan do not lie in the region, [`ConfigError::TimedOut`] if the
    /// module does not follow: it waits for 11 recessive bits.
    pub fn new(
        registers: R,
        region: Region<M>,
        plan: &DsPic33EcanPlan,
        mut deadline: impl Deadline,
    ) -> Result<Self, ConfigError> {
        let layout = Layout::new(plan, &region)?;
        let inner = Inner {
            regs: Dspic33Ecan::new(registers),
            ram: region.bus(),
            layout,
            tx: tx::Tx::default(),
            rx: rx::Rx::default(),
            blocking_polls: Config::BLOCKING_POLLS,
        };
        inner.take_over(&mut deadline)?;
        Ok(Self { inner, mode: PhantomData })
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// The registers, for what this crate does not do. Do not change what it relies on.
    pub const fn registers(&self) -> &Dspic33Ecan<R> {
        &self.inner.regs
    }

    /// Where the buffers lie.
    pub const fn plan(&self) -> &DsPic33EcanPlan {
        &self.inner.layout.plan
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
        write!(f, "dspic33_ecan::Can<{}>", core::any::type_name::<S>())
    }
}
