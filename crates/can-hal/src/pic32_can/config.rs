//! Configuration (34.5.1): everything that can be changed in Configuration mode only, and what belongs to it.

use core::fmt;

use pic32_can_pac::{
    Mmio, Pic32Can,
    enums::{ConDncnt, FifoConTxpri, OperationMode},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Filter, Inner, Mask, fifo::Kind};
use crate::{TimedOut, memory::Placed, mode::Configuration, timing::Pic32CanTiming};

/// What a transmit FIFO has beside its place in memory (Register 34-20).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TxFifo {
    /// Its number.
    pub fifo: u8,
    /// Its priority; of FIFOs of the same priority the one with the highest number goes first (34.7.3).
    pub priority: FifoConTxpri,
    /// A remote frame that a filter lets in for this FIFO has its messages sent (34.7.5). The FIFO is loaded with
    /// [`Can::load_reply`].
    pub remote_reply: bool,
}

impl TxFifo {
    /// A FIFO of the lowest priority.
    #[must_use]
    pub const fn new(fifo: u8) -> Self {
        Self { fifo, priority: FifoConTxpri::Lowest, remote_reply: false }
    }

    /// The same with another priority.
    #[must_use]
    pub const fn with_priority(mut self, priority: FifoConTxpri) -> Self {
        self.priority = priority;
        self
    }

    /// The same, answering remote frames.
    #[must_use]
    pub const fn replying(mut self) -> Self {
        self.remote_reply = true;
        self
    }
}

/// The configuration. Which FIFOs there are, and how many messages they hold, is in the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config<'a> {
    /// Bit timing.
    pub timing: Pic32CanTiming,
    /// The masks.
    pub masks: [Mask; 4],
    /// The filters, in the order in which they are tried; at most 32. Without filters nothing is received.
    pub filters: &'a [Filter],
    /// Transmit FIFOs that are not of the lowest priority, or answer remote frames.
    pub tx_fifos: &'a [TxFifo],
    /// Leading data bits of messages with 11-bit identifiers that take part in filtering, 0 to 18; 0 for none (34.8.7).
    pub data_bits: u8,
    /// System clocks in a unit of the time stamps, 0 counting as 1; `None` for no time stamps (34.13).
    pub timestamps: Option<u16>,
    /// The module stops while the device is in Idle mode (34.14.2).
    pub stop_in_idle: bool,
    /// Short pulses on the bus do not wake the module (34.14.3).
    pub wake_up_filter: bool,
    /// How often the blocking calls of `embedded_can` try before they fail.
    pub blocking_polls: u32,
}

impl Config<'_> {
    /// What [`Config::new`] sets for [`Config::blocking_polls`].
    pub const BLOCKING_POLLS: u32 = 1_000_000;
}

impl<'a> Config<'a> {
    /// This bit timing, no filters, no time stamps.
    #[must_use]
    pub const fn new(timing: Pic32CanTiming) -> Self {
        Self {
            timing,
            masks: [Mask::EXACT; 4],
            filters: &[],
            tx_fifos: &[],
            data_bits: 0,
            timestamps: None,
            stop_in_idle: false,
            wake_up_filter: false,
            blocking_polls: Self::BLOCKING_POLLS,
        }
    }

    /// The same with these masks and filters.
    #[must_use]
    pub const fn with_filters(mut self, masks: [Mask; 4], filters: &'a [Filter]) -> Self {
        self.masks = masks;
        self.filters = filters;
        self
    }

    /// The same with these transmit FIFOs.
    #[must_use]
    pub const fn with_tx_fifos(mut self, fifos: &'a [TxFifo]) -> Self {
        self.tx_fifos = fifos;
        self
    }
}

/// Why a configuration was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConfigError {
    /// The module does not follow.
    TimedOut,
    /// A FIFO of the plan does not lie in the region.
    OutsideRegion(Placed),
    /// There is no filter of this number, or a list of more than 32.
    NoSuchFilter(u8),
    /// There is no mask of this number.
    NoSuchMask(u8),
    /// There is no FIFO of this number, or the plan has no transmit FIFO of this number.
    NoSuchFifo(u8),
    /// DeviceNet filtering compares 18 data bits at most.
    TooManyDataBits(u8),
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimedOut => TimedOut.fmt(f),
            Self::OutsideRegion(section) => {
                write!(f, "{} from {:#x} to {:#x} is not in the region", section.name, section.start, section.end())
            }
            Self::NoSuchFilter(number) => write!(f, "there are filters 0 to 31, not {number}"),
            Self::NoSuchMask(number) => write!(f, "there are masks 0 to 3, not {number}"),
            Self::NoSuchFifo(number) => write!(f, "there is no such FIFO {number}"),
            Self::TooManyDataBits(bits) => write!(f, "18 data bits can be compared, not {bits}"),
        }
    }
}

impl core::error::Error for ConfigError {}

impl From<TimedOut> for ConfigError {
    fn from(_: TimedOut) -> Self {
        Self::TimedOut
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Writes the whole configuration. Nothing of an earlier one stays.
    ///
    /// # Errors
    /// A [`ConfigError`]; nothing has been written then.
    pub fn configure(&mut self, config: &Config<'_>) -> Result<(), ConfigError> {
        let inner = &mut self.inner;
        if config.filters.len() > Pic32Can::<Mmio>::RXF_LEN {
            return Err(ConfigError::NoSuchFilter(config.filters.len().min(255) as u8));
        }
        config.filters.iter().try_for_each(Filter::check)?;
        let transmits =
            |number: u8| inner.fifos.get(usize::from(number)).is_some_and(|fifo| fifo.kind == Kind::Transmit);
        if let Some(wrong) = config.tx_fifos.iter().find(|tx| !transmits(tx.fifo)) {
            return Err(ConfigError::NoSuchFifo(wrong.fifo));
        }
        let data_bits = ConDncnt::from_bits(config.data_bits);
        let data_bits = data_bits.map_err(|_| ConfigError::TooManyDataBits(config.data_bits))?;
        inner.timestamps = config.timestamps.is_some();
        inner.blocking_polls = config.blocking_polls;
        let con = pac::Con::ZERO
            .with_on(true)
            .with_reqop(OperationMode::Configuration)
            .with_cancap(inner.timestamps)
            .with_sidle(config.stop_in_idle)
            .with_dncnt(data_bits);
        inner.regs.con().write(con);
        inner.regs.tmr().write(pac::Tmr::ZERO.with_cantspre(config.timestamps.unwrap_or(0)));
        inner.set_bit_timing(&config.timing, config.wake_up_filter);
        inner.write_fifos(config);
        inner.write_filters(config);
        Ok(())
    }

    /// Changes the bit timing alone, for example while the bit rate of a bus is searched for in Listen Only mode
    /// (34.5.3).
    pub fn set_bit_timing(&mut self, timing: &Pic32CanTiming) {
        let filtered = self.inner.regs.cfg().read().wakfil();
        self.inner.set_bit_timing(timing, filtered);
    }
}

impl<R: Bus, M: Bus> Inner<R, M> {
    fn set_bit_timing(&self, timing: &Pic32CanTiming, wake_up_filter: bool) {
        self.regs.cfg().write(timing.cfg.with_wakfil(wake_up_filter));
    }

    /// 34.6.1: base address, size, direction and priority of every FIFO. The flags of receive FIFOs are let through to
    /// layer 2 of the interrupts, where they are enabled or not (34.12).
    #[allow(unsafe_code, reason = "the base address of the FIFOs")]
    fn write_fifos(&mut self, config: &Config<'_>) {
        // SAFETY: `fifo::place` has checked that all FIFOs lie in the region, which is the module's by the promise made to
        // `Region::new`.
        unsafe { self.regs.fifo_ba().write_unsafe(pac::FifoBa::from_bits(self.base)) };
        self.replies = 0;
        for (number, fifo) in self.fifos.iter_mut().enumerate() {
            let mut con = fifo.con();
            if let Some(tx) = config.tx_fifos.iter().find(|tx| usize::from(tx.fifo) == number) {
                con = con.with_txpri(tx.priority).with_rtren(tx.remote_reply);
                self.replies |= u32::from(tx.remote_reply) << number;
            }
            let registers = self.regs.fifo(number);
            registers.con().write(con);
            let flags = match fifo.kind {
                Kind::Receive | Kind::ReceiveData => pac::FifoInt::RXNEMPTYIE | pac::FifoInt::RXOVFLIE,
                Kind::Transmit | Kind::Unused => pac::FifoInt::ZERO,
            };
            registers.int_().write(flags);
            fifo.forget();
        }
        self.requested = 0;
        self.aborting = 0;
    }

    /// 34.8: all filters off, then the masks, then the filters.
    fn write_filters(&self, config: &Config<'_>) {
        for (_, register) in self.regs.flt_con_iter() {
            register.write(pac::FltCon::RESET);
        }
        for (number, mask) in config.masks.iter().enumerate() {
            self.regs.rxm(number).write(mask.bits());
        }
        for (number, filter) in (0..).zip(config.filters) {
            self.write_filter(number, filter);
        }
    }
}
