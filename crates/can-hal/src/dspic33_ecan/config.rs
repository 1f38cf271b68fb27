//! Configuration (4.0, 6.4, 8.1, 9.1.4, 9.3).

use core::fmt;

use dspic33_ecan_pac::{
    enums::{Ctrl2Dncnt, TrConTxen, TxPriority},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Filter, FilterError, Inner, Mask, tx::TX_BUFFERS};
use crate::{OutOfRange, TimedOut, memory::Placed, mode::Configuration, timing::DsPic33EcanTiming};

/// What one of the buffers 0 to 7 is used for (8.0, 9.2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Use {
    /// It receives, if a filter points to it.
    #[default]
    Receive,
    /// It sends what is given to [`Transmit::send`](crate::Transmit::send), in the order of the calls.
    Queue,
    /// It sends what is given to [`Can::send_buffer`] with its number, with this priority.
    Dedicated(TxPriority),
    /// It answers remote frames for which a filter points to it, with what [`Can::set_reply`] has put into it and with this
    /// priority (8.3.2). The other buffer of its pair can only receive: hardware requests the answer at any time.
    Reply(TxPriority),
}

/// The configuration. Number of buffers and FIFO are those of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config<'a> {
    /// Bit timing.
    pub timing: DsPic33EcanTiming,
    /// Glitches on the bus do not wake the device from Sleep (CxCFG2.WAKFIL, 13.3).
    pub wake_up_filter: bool,
    /// The module stops while the CPU is in Idle mode (CxCTRL1.CSIDL, 13.2). Put it to sleep before.
    pub stop_in_idle: bool,
    /// Each accepted message pulses input capture IC2 (CxCTRL1.CANCAP, 14.0).
    pub capture: bool,
    /// Data bits of standard messages, 0 to 18, that filters compare (CxCTRL2.DNCNT, 9.5).
    pub data_bits: u8,
    /// Use of buffers 0 to 7.
    pub uses: [Use; TX_BUFFERS as usize],
    /// The three masks.
    pub masks: [Mask; 3],
    /// Filters, numbered from 0 in their order, at most 16. The others are disabled: after reset they would be enabled, and
    /// unknown (Register 4-3).
    pub filters: &'a [Filter],
    /// How often the blocking calls of `embedded_can` try before they fail.
    pub blocking_polls: u32,
}

impl Config<'_> {
    /// What [`Config::new`] sets for [`Config::blocking_polls`].
    pub const BLOCKING_POLLS: u32 = 1_000_000;
}

impl<'a> Config<'a> {
    /// With this bit timing, no filter and nothing to send with.
    #[must_use]
    pub const fn new(timing: DsPic33EcanTiming) -> Self {
        Self {
            timing,
            wake_up_filter: false,
            stop_in_idle: false,
            capture: false,
            data_bits: 0,
            uses: [Use::Receive; TX_BUFFERS as usize],
            masks: [Mask::ANY; 3],
            filters: &[],
            blocking_polls: Self::BLOCKING_POLLS,
        }
    }

    /// The same with a queue of so many buffers, at most four: one of each pair, from buffers 0 and 1 on, the one with the
    /// even number.
    ///
    /// # Panics
    /// With more than four.
    #[must_use]
    pub const fn with_queue(mut self, buffers: usize) -> Self {
        assert!(buffers <= TX_BUFFERS as usize / 2, "a queue has one buffer of each of four pairs");
        let mut pair = 0;
        while pair < buffers {
            self.uses[2 * pair] = Use::Queue;
            pair += 1;
        }
        self
    }

    /// The same with one of the buffers 0 to 7 used otherwise.
    ///
    /// # Panics
    /// If there is no such buffer.
    #[must_use]
    pub const fn with_use(mut self, buffer: usize, use_: Use) -> Self {
        self.uses[buffer] = use_;
        self
    }

    /// The same with these masks and filters.
    #[must_use]
    pub const fn with_filters(mut self, masks: [Mask; 3], filters: &'a [Filter]) -> Self {
        self.masks = masks;
        self.filters = filters;
        self
    }
}

/// Why a configuration was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConfigError {
    /// The module does not follow.
    TimedOut,
    /// The buffers do not lie in the region.
    OutsideRegion(Placed),
    /// A field does not take a value.
    OutOfRange(OutOfRange),
    /// A filter cannot be stored.
    Filter(FilterError),
    /// A buffer is to send, but the plan has no such buffer.
    NoSuchBuffer {
        /// The buffer.
        buffer: u8,
        /// Number of buffers.
        count: u8,
    },
    /// A buffer is to send although it lies in the FIFO, which a filter uses: messages for it would be lost (9.3).
    SendsFromFifo {
        /// The buffer.
        buffer: u8,
    },
    /// A buffer is to send although the other one of its pair answers remote frames.
    PairAnswers {
        /// The buffer.
        buffer: u8,
    },
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimedOut => TimedOut.fmt(f),
            Self::OutsideRegion(section) => {
                write!(f, "{} from {:#x} to {:#x} is not in the region", section.name, section.start, section.end())
            }
            Self::OutOfRange(error) => error.fmt(f),
            Self::Filter(error) => error.fmt(f),
            Self::NoSuchBuffer { buffer, count } => write!(f, "there are {count} buffers, but no buffer {buffer}"),
            Self::SendsFromFifo { buffer } => write!(f, "buffer {buffer} is to send, but lies in the FIFO"),
            Self::PairAnswers { buffer } => {
                write!(f, "buffer {buffer} is to send, but shares its register with one that answers remote frames")
            }
        }
    }
}

impl core::error::Error for ConfigError {}

impl From<FilterError> for ConfigError {
    fn from(error: FilterError) -> Self {
        Self::Filter(error)
    }
}

impl From<TimedOut> for ConfigError {
    fn from(_: TimedOut) -> Self {
        Self::TimedOut
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Writes the whole configuration. Nothing of an earlier one stays, and messages in buffers are lost.
    ///
    /// # Errors
    /// A [`ConfigError`]; nothing is changed then.
    pub fn configure(&mut self, config: &Config<'_>) -> Result<(), ConfigError> {
        let inner = &mut self.inner;
        let data_bits = data_bits(config.data_bits)?;
        inner.check_uses(config)?;
        inner.check_filters(config)?;
        inner.blocking_polls = config.blocking_polls;
        inner.regs.cfg1().write(config.timing.cfg1);
        inner.regs.cfg2().write(config.timing.cfg2.with_wakfil(config.wake_up_filter));
        let switches = |ctrl1: pac::Ctrl1| ctrl1.with_csidl(config.stop_in_idle).with_cancap(config.capture);
        inner.regs.ctrl1().modify(switches);
        inner.regs.ctrl2().write(pac::Ctrl2::RESET.with_dncnt(data_bits));
        inner.tx.set_up(&config.uses);
        inner.write_controls();
        inner.write_all_filters(config);
        inner.clear_messages();
        inner.write_fifo_control();
        Ok(())
    }

    /// Changes the bit timing alone (6.4), for example while the bit rate of a bus is searched for. The wake-up filter
    /// stays as it is.
    pub fn set_bit_timing(&mut self, timing: &DsPic33EcanTiming) {
        let regs = &self.inner.regs;
        regs.cfg1().write(timing.cfg1);
        let filter = regs.cfg2().read().wakfil();
        regs.cfg2().write(timing.cfg2.with_wakfil(filter));
    }
}

/// Register 4-24.
fn data_bits(count: u8) -> Result<Ctrl2Dncnt, ConfigError> {
    Ctrl2Dncnt::from_bits(count).map_err(|_| {
        ConfigError::OutOfRange(OutOfRange { field: "CTRL2.DNCNT", value: u32::from(count), min: 0, max: 18 })
    })
}

impl<R: Bus, M: Bus> Inner<R, M> {
    fn check_uses(&self, config: &Config<'_>) -> Result<(), ConfigError> {
        let (count, (start, _)) = (self.layout.count(), self.layout.fifo());
        let fifo_used = config.filters.iter().any(|filter| filter.target == super::FilterTarget::Fifo);
        for (buffer, use_) in (0..TX_BUFFERS).zip(config.uses) {
            if use_ == Use::Receive {
                continue;
            }
            if buffer >= count {
                return Err(ConfigError::NoSuchBuffer { buffer, count });
            }
            if fifo_used && buffer >= start {
                return Err(ConfigError::SendsFromFifo { buffer });
            }
            if matches!(config.uses[usize::from(buffer ^ 1)], Use::Reply(_)) {
                return Err(ConfigError::PairAnswers { buffer });
            }
        }
        Ok(())
    }

    /// The control registers without any request (8.1). In configuration mode no frame is on the bus, so that pending
    /// requests are aborted by it.
    pub(super) fn write_controls(&self) {
        for (pair, control) in self.tx.control.iter().enumerate() {
            self.regs.tr_con(pair).write(*control);
        }
    }

    /// RXFUL and RXOVF of all buffers (9.2.5), and the flags.
    pub(super) fn clear_messages(&mut self) {
        for half in 1..=2 {
            self.regs.rxful(half).clear(pac::Rxful::from_bits(u16::MAX));
            self.regs.rxovf(half).clear(pac::Rxovf::from_bits(u16::MAX));
        }
        self.rx.next = self.layout.fifo().0;
    }

    /// 9.3: number of buffers and start of the FIFO. Written after the full flags, whose release moves the FIFO's pointer.
    #[allow(unsafe_code, reason = "tells the DMA controller how many buffers there are")]
    fn write_fifo_control(&self) {
        // SAFETY: `Layout::new` has checked that all buffers lie in the region, which is the module's by the promise made
        // to `Region::new`.
        unsafe { self.regs.fctrl().write_unsafe(self.layout.plan.fctrl) }
    }
}

/// The control bits of a buffer in its register.
pub(super) const fn control(register: pac::TrCon, lane: usize, use_: Use) -> pac::TrCon {
    let register = register.with_txreq(lane, false).with_rtren(lane, false);
    match use_ {
        Use::Receive => register.with_txen(lane, TrConTxen::Receive).with_txpri(lane, TxPriority::Lowest),
        Use::Queue => register.with_txen(lane, TrConTxen::Transmit).with_txpri(lane, TxPriority::Lowest),
        Use::Dedicated(priority) | Use::Reply(priority) => {
            register.with_txen(lane, TrConTxen::Transmit).with_txpri(lane, priority)
        }
    }
}
