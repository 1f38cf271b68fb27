//! Microchip PIC32MX CAN. Sections in comments are of the PIC32MX Family Reference Manual, Section 34, revision A.
//!
//! ```
//! use can_hal::{Polls, Region, pic32_can::{Can, Config, Filter, Mask}, memory::{Pic32CanFifo, Pic32CanMemory}};
//! # use can_hal::{Configured, Frame, Receive, StandardId, Transmit, Outcome, timing::*};
//! # let sim = can_sim::Sim::new();
//! # let ram = sim.add_memory(can_sim::Memory::new(1024).with_widths(&[8, 16, 32]));
//! # let id = sim.add_pic32_can("can1", can_sim::pic32_can::Pic32CanConfig::new(ram))?;
//! # let (registers, memory) = (sim.registers(id), sim.memory(ram));
//! # let timing = Pic32CanTiming::solve(&Request::new(80_000_000, 1_000_000)).map_err(|error| error.text())?;
//! let plan = Pic32CanMemory::new(0, 4096)
//!     .fifo(0, Pic32CanFifo::Transmit { elements: 4 })
//!     .fifo(1, Pic32CanFifo::Receive { elements: 8 })
//!     .plan()?;
//! // On hardware `registers` and `memory` are `Mmio` at virtual addresses; 0 is the physical address of the memory.
//! // SAFETY: nothing else uses this memory.
//! let region = unsafe { Region::new(memory, 0, 4096) };
//! let mut can = Can::new(registers, region, &plan, Polls(1_000))?;
//! let filters = [Filter::any(1)];
//! can.configure(&Config::new(timing).with_filters([Mask::ANY; 4], &filters))?;
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
//! # use can_hal::{mode::Running, pic32_can::{Can, Config}};
//! # use regbus::Bus;
//! fn reconfigure<B: Bus>(mut can: Can<Running, B, B>, config: &Config<'_>) {
//!     can.configure(config);
//! }
//! ```
//!
//! Nor does sending while it only listens:
//!
//! ```compile_fail,E0599
//! # use can_hal::{Frame, mode::ListenOnly, pic32_can::Can};
//! # use regbus::Bus;
//! fn send<B: Bus>(mut can: Can<ListenOnly, B, B>, frame: &Frame) {
//!     can.send_through(0, frame);
//! }
//! ```

#![allow(
    clippy::result_large_err,
    reason = "an error gives the controller back, with the state of its 32 FIFOs; there is no allocation"
)]

mod common;
mod config;
mod element;
mod fifo;
mod filter;
mod interrupts;
mod modes;
mod rx;
mod status;
mod tx;

use core::{fmt, marker::PhantomData};

use pic32_can_pac::{
    Mmio, Pic32Can,
    enums::OperationMode,
    registers::{self as pac, FifoCon},
};
use regbus::Bus;

use crate::{Deadline, Region, deadline::wait, error::Refused, memory::Pic32CanPlan, mode::Configuration};

pub use config::{Config, ConfigError, TxFifo};
pub use filter::{Filter, Mask};
pub use interrupts::Interrupts;
pub use pic32_can_pac::{
    enums::{FifoConTxpri as Priority, InterruptCode},
    registers::FifoInt as FifoFlags,
};
pub use rx::RxMessage;
pub use status::TxStatus;
pub use tx::Ticket;

/// A PIC32MX CAN module in mode `S`, with registers behind `R` and system RAM behind `M`.
///
/// Reading CiFIFOCONn destroys TXERR and TXLARB; this driver keeps what its reads destroy for [`Can::tx_status`].
pub struct Can<S, R: Bus = Mmio, M: Bus = R> {
    inner: Inner<R, M>,
    mode: PhantomData<S>,
}

/// What does not depend on the mode.
struct Inner<R: Bus, M: Bus> {
    regs: Pic32Can<R>,
    ram: M,
    /// Physical address at which the memory begins.
    address: u32,
    fifos: [fifo::Fifo; FIFOS],
    /// Where FIFO 0 begins, for CiFIFOBA.
    base: u32,
    /// Transmit FIFOs that answer remote frames; the others are for [`Transmit::send`](crate::Transmit::send).
    replies: u32,
    /// FIFOs whose messages were requested; a FIFO that is empty has no request.
    requested: u32,
    /// FIFOs whose TXREQ was cleared and not seen to be 0 yet.
    aborting: u32,
    /// TXERR and TXLARB that reads have destroyed, per FIFO.
    errors: u32,
    lost_arbitration: u32,
    timestamps: bool,
    blocking_polls: u32,
}

/// FIFOs of the module.
const FIFOS: usize = Pic32Can::<Mmio>::FIFO_LEN;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Takes a module and its part of the system RAM, switches it on and brings it to Configuration mode (34.4, 34.5.1). A
    /// message on the bus is finished first. A module that a system error has stopped is switched off and on
    /// (34.12.1.4).
    ///
    /// # Errors
    /// [`ConfigError::OutsideRegion`] if the plan does not lie in the region, [`ConfigError::TimedOut`] if the module does
    /// not follow.
    pub fn new(
        registers: R,
        region: Region<M>,
        plan: &Pic32CanPlan,
        mut deadline: impl Deadline,
    ) -> Result<Self, ConfigError> {
        let fifos = fifo::place(plan, &region)?;
        let regs = Pic32Can::new(registers);
        if regs.int_().read().serrif() {
            wait(&mut deadline, || !regs.con().read().canbusy())?;
            regs.con().clear_bits(pac::Con::ON);
        }
        // No list of steps of the manual sets ON; without it nothing works.
        let configuration = pac::Con::RESET.with_on(true).with_reqop(OperationMode::Configuration);
        regs.con().write(configuration);
        wait(&mut deadline, || regs.con().read().opmod() == Ok(OperationMode::Configuration))?;
        let inner = Inner {
            regs,
            ram: region.bus(),
            address: region.address(),
            fifos,
            base: plan.fifoba,
            replies: 0,
            requested: 0,
            aborting: 0,
            errors: 0,
            lost_arbitration: 0,
            timestamps: false,
            blocking_polls: Config::BLOCKING_POLLS,
        };
        Ok(Self { inner, mode: PhantomData })
    }

    /// Switches the module off and gives its registers back (34.4, Example 34-1). Its pins are released.
    ///
    /// # Errors
    /// [`TimedOut`](crate::TimedOut) if CANBUSY stays 1; the module is off all the same.
    pub fn turn_off(self, mut deadline: impl Deadline) -> Result<R, Refused<Self>> {
        self.inner.regs.con().clear_bits(pac::Con::ON);
        match wait(&mut deadline, || !self.inner.regs.con().read().canbusy()) {
            Ok(()) => Ok(self.inner.regs.bus()),
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// The registers, for what this crate does not do. Do not change what it relies on, and do not read CiFIFOCONn: that
    /// destroys TXERR and TXLARB.
    pub const fn registers(&self) -> &Pic32Can<R> {
        &self.inner.regs
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
    /// Reads CiFIFOCONn and keeps what the read destroys (Register 34-20).
    fn control(&mut self, fifo: u8) -> FifoCon {
        let con = self.regs.fifo(usize::from(fifo % 32)).con().read();
        let bit = |set: bool| u32::from(set) << (fifo % 32);
        self.errors |= bit(con.txerr());
        self.lost_arbitration |= bit(con.txlarb());
        con
    }
}

impl<S, R: Bus, M: Bus> fmt::Debug for Can<S, R, M> {
    /// Touches no register.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "pic32_can::Can<{}>", core::any::type_name::<S>())
    }
}
