//! The configuration (3.0, 5.0). Everything in it is written in Configuration mode.

use core::fmt;

use can_frame::Frame;
use dspic33_canfd_pac::{
    enums::{
        ConHEsigm, ConHRtxat, ConHSerrlom, ConHTxbws, ConLClksel, ConLIsocrcen, ConLPxedis, ConLWft, OperationMode,
        RetransmissionAttempts, TsconHTseof, TsconHTsres,
    },
    registers as pac,
};
use regbus::Bus;

use super::{Can, Filter, FilterError, Inner, layout::numbers, tx::TxOptions};
use crate::{
    SendError, TimedOut,
    fields::{Limits, OutOfRange},
    memory::Placed,
    mode::Configuration,
    timing::DsPic33CanFdTiming,
};

/// Frame formats (4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FdMode {
    /// Classic frames only: Normal CAN 2.0 mode. FD frames of others end in error frames.
    Classic,
    /// Classic and FD frames: Normal CAN FD mode.
    Fd {
        /// Frames may switch to the data bit rate (CONL.BRSDIS).
        bit_rate_switch: bool,
        /// The format before ISO 11898-1:2015 (CONL.ISOCRCEN, 2.1).
        non_iso: bool,
    },
}

/// How often a failed transmission is repeated (6.9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Attempts {
    /// Until it is sent.
    Unlimited,
    /// Three times after errors; lost arbitration uses none up.
    Three,
    /// Not at all; lost arbitration counts as failure.
    None,
}

impl Attempts {
    pub(super) const fn code(self) -> RetransmissionAttempts {
        match self {
            Self::Unlimited => RetransmissionAttempts::Unlimited(3),
            Self::Three => RetransmissionAttempts::Three,
            Self::None => RetransmissionAttempts::Disabled,
        }
    }
}

/// The point of a frame at which the Time Base Counter is captured (table 11-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Reference {
    /// Sample point of the start of frame.
    StartOfFrame,
    /// Sample point of the bit after FDF; classic frames at their start.
    AfterFdf,
    /// When the frame becomes valid.
    Valid,
}

/// Timestamps (11.0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timestamping {
    /// The Time Base Counter stands still: timestamps are 0.
    Off,
    /// It counts.
    Counter {
        /// Periods of the CAN clock in a unit, 1 to 1024.
        clocks: u16,
        /// What is stamped.
        reference: Reference,
    },
}

/// A message that answers remote frames (6.11). Every filter that points to its FIFO asks for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reply {
    /// The FIFO that holds it, set up in the plan to transmit and not used for anything else.
    pub fifo: u8,
    /// The message.
    pub frame: Frame,
}

/// The configuration. The sizes of FIFOs are those of the plan given to [`Can::new`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config<'a> {
    /// Bit timing, with a data phase if frames may switch the bit rate. [`DsPic33CanFdTiming::of`] makes it of any
    /// [`BitTiming`](crate::timing::BitTiming).
    pub timing: DsPic33CanFdTiming,
    /// Frame formats.
    pub fd: FdMode,
    /// Repetition of failed transmissions of the queue and of all FIFOs; see [`Can::set_attempts`] for one of them.
    pub attempts: Attempts,
    /// TXAT of each FIFO counts, although all repeat without limit for now.
    pub restrict_attempts: bool,
    /// Transmit priorities, 0 lowest to 31 highest, of FIFOs by their number, of the queue as number 0 (6.7).
    pub priorities: &'a [(u8, u8)],
    /// Idle bit times after each own message (6.8).
    pub bandwidth_sharing: ConHTxbws,
    /// ESI of the message is sent recessive if it is set in the frame, or if the node is error passive (5.2.5).
    pub gateway_esi: bool,
    /// A system error leads to Listen Only mode instead of Restricted Operation mode (5.2.6).
    pub listen_after_system_error: bool,
    /// A protocol exception is a form error (5.2.2).
    pub no_protocol_exception: bool,
    /// Edge filtering during bus integration (TDCH.EDGFLTEN).
    pub edge_filtering: bool,
    /// RRS of FD frames is the twelfth bit of the identifier (8.2.4).
    pub twelve_bit_ids: bool,
    /// Data bits of standard frames that filters compare, 0 to 18 (8.2.3).
    pub data_filter_bits: u8,
    /// The auxiliary clock instead of the CAN clock generator (5.1).
    pub auxiliary_clock: bool,
    /// The module stops while the device is in Idle mode (4.6.2).
    pub stop_in_idle: bool,
    /// Glitches shorter than this do not wake the module up (5.2.3).
    pub wake_up_filter: Option<ConLWft>,
    /// Timestamps of FIFOs and events that are planned with them.
    pub timestamps: Timestamping,
    /// Messages that answer remote frames.
    pub replies: &'a [Reply],
    /// Filters, in the order in which they are tried; the rest is disabled.
    pub filters: &'a [Filter],
    /// How often the blocking calls of `embedded_can` try before they fail.
    pub blocking_polls: u32,
}

impl Config<'_> {
    /// What [`Config::new`] sets for [`Config::blocking_polls`].
    pub const BLOCKING_POLLS: u32 = 1_000_000;
}

impl<'a> Config<'a> {
    /// Classic frames with this bit timing, no filters, so that nothing is received, no timestamps.
    #[must_use]
    pub const fn new(timing: DsPic33CanFdTiming) -> Self {
        Self {
            timing,
            fd: FdMode::Classic,
            attempts: Attempts::Unlimited,
            restrict_attempts: false,
            priorities: &[],
            bandwidth_sharing: ConHTxbws::NoDelay,
            gateway_esi: false,
            listen_after_system_error: false,
            no_protocol_exception: false,
            edge_filtering: false,
            twelve_bit_ids: false,
            data_filter_bits: 0,
            auxiliary_clock: false,
            stop_in_idle: false,
            wake_up_filter: None,
            timestamps: Timestamping::Off,
            replies: &[],
            filters: &[],
            blocking_polls: Self::BLOCKING_POLLS,
        }
    }

    /// The same with FD frames in the ISO format, with bit-rate switch.
    #[must_use]
    pub const fn with_fd(mut self) -> Self {
        self.fd = FdMode::Fd { bit_rate_switch: true, non_iso: false };
        self
    }

    /// The same with these filters.
    #[must_use]
    pub const fn with_filters(mut self, filters: &'a [Filter]) -> Self {
        self.filters = filters;
        self
    }

    /// Register 3-1.
    fn con_l(&self) -> Result<pac::ConL, OutOfRange> {
        const DNCNT: Limits = Limits::of::<pac::ConL>("CONL.DNCNT");
        let bits = DNCNT.encode(u32::from(self.data_filter_bits))? as u16;
        let non_iso = matches!(self.fd, FdMode::Fd { non_iso: true, .. });
        let brs = matches!(self.fd, FdMode::Fd { bit_rate_switch: true, .. });
        let con_l = pac::ConL::from_bits(bits)
            .with_con(true)
            .with_sidl(self.stop_in_idle)
            .with_brsdis(!brs)
            .with_wakfil(self.wake_up_filter.is_some())
            .with_clksel(if self.auxiliary_clock { ConLClksel::AuxiliaryClock } else { ConLClksel::CanClockGenerator })
            .with_pxedis(if self.no_protocol_exception { ConLPxedis::FormError } else { ConLPxedis::BusIntegration })
            .with_isocrcen(if non_iso { ConLIsocrcen::NonIso } else { ConLIsocrcen::Iso11898_1 });
        Ok(con_l.with_wft(self.wake_up_filter.unwrap_or(ConLWft::T11Filter)))
    }
}

/// Why a configuration was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConfigError {
    /// The controller does not follow.
    TimedOut,
    /// A section of the plan does not lie in the region.
    OutsideRegion(Placed),
    /// A field does not take a value.
    OutOfRange(OutOfRange),
    /// A filter cannot be set.
    Filter(FilterError),
    /// A reply, or a priority, for a FIFO that the plan does not set up to transmit.
    NotTransmitting {
        /// The FIFO.
        fifo: u8,
    },
    /// A reply that cannot be sent.
    Reply(SendError),
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
            Self::NotTransmitting { fifo } => write!(f, "FIFO {fifo} does not transmit"),
            Self::Reply(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ConfigError {}

macro_rules! from {
    ($($error:ident => $variant:ident),*) => {$(
        impl From<$error> for ConfigError {
            fn from(error: $error) -> Self {
                Self::$variant(error)
            }
        }
    )*};
}

from!(OutOfRange => OutOfRange, FilterError => Filter, SendError => Reply);

impl From<TimedOut> for ConfigError {
    fn from(_: TimedOut) -> Self {
        Self::TimedOut
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Writes the whole configuration. Nothing of an earlier one stays.
    ///
    /// # Errors
    /// A [`ConfigError`]; the configuration is incomplete then.
    pub fn configure(&mut self, config: &Config<'_>) -> Result<(), ConfigError> {
        let inner = &mut self.inner;
        inner.fd = config.fd;
        inner.blocking_polls = config.blocking_polls;
        inner.regs.con_l().write(config.con_l()?);
        inner.con_h = inner.options(config);
        inner.request_mode(OperationMode::Configuration);
        let tdc_h = config.timing.tdch.with_edgflten(config.edge_filtering).with_sid11en(config.twelve_bit_ids);
        inner.set_bit_timing(&config.timing, tdc_h);
        inner.set_time_base(config)?;
        inner.place_fifos();
        inner.set_fifos(config)?;
        inner.set_replies(config)?;
        let filters = config.filters.iter().map(Some).chain(core::iter::repeat(None));
        for (index, filter) in filters.take(config.filters.len().max(FILTERS)).enumerate() {
            inner.write_filter(index, filter)?;
        }
        Ok(())
    }

    /// Changes the bit timing alone, for example while the bit rate of a bus is searched for (4.5.1).
    pub fn set_bit_timing(&mut self, timing: &DsPic33CanFdTiming) {
        let inner = &self.inner;
        let old = inner.regs.tdc_h().read();
        let tdc_h = timing.tdch.with_edgflten(old.edgflten()).with_sid11en(old.sid11en());
        inner.set_bit_timing(timing, tdc_h);
    }
}

/// 8.0
const FILTERS: usize = dspic33_canfd_pac::Dspic33Canfd::<regbus::Mmio>::FLT_LEN;

impl<R: Bus, M: Bus> Inner<R, M> {
    /// The bits of CONH that stay while the mode changes (Register 3-2).
    fn options(&self, config: &Config<'_>) -> pac::ConH {
        let restricted = config.restrict_attempts || config.attempts != Attempts::Unlimited;
        pac::ConH::ZERO
            .with_txbws(config.bandwidth_sharing)
            .with_txqen(self.layout.txqen)
            .with_stef(self.layout.stef)
            .with_serrlom(match config.listen_after_system_error {
                true => ConHSerrlom::ListenOnly,
                false => ConHSerrlom::RestrictedOperation,
            })
            .with_esigm(if config.gateway_esi { ConHEsigm::Gateway } else { ConHEsigm::ErrorState })
            .with_rtxat(if restricted { ConHRtxat::Restricted } else { ConHRtxat::Unlimited })
    }

    /// 5.3
    fn set_bit_timing(&self, timing: &DsPic33CanFdTiming, tdc_h: pac::TdcH) {
        let regs = &self.regs;
        regs.nbtcfg_h().write(timing.nbtcfgh);
        regs.nbtcfg_l().write(timing.nbtcfgl);
        regs.dbtcfg_h().write(timing.dbtcfgh);
        regs.dbtcfg_l().write(timing.dbtcfgl);
        regs.tdc_h().write(tdc_h);
        regs.tdc_l().write(timing.tdcl);
    }

    /// 11.0: disabled, prescaler, enabled.
    fn set_time_base(&self, config: &Config<'_>) -> Result<(), OutOfRange> {
        const TBCPRE: Limits = Limits::of::<pac::TsconL>("TSCONL.TBCPRE");
        self.regs.tscon_h().write(pac::TsconH::ZERO);
        let Timestamping::Counter { clocks, reference } = config.timestamps else { return Ok(()) };
        self.regs.tscon_l().write(pac::TsconL::ZERO.with_tbcpre(TBCPRE.encode(u32::from(clocks))? as u16));
        let (eof, res) = match reference {
            Reference::StartOfFrame => (TsconHTseof::Beginning, TsconHTsres::StartOfFrame),
            Reference::AfterFdf => (TsconHTseof::Beginning, TsconHTsres::AfterFdf),
            Reference::Valid => (TsconHTseof::Valid, TsconHTsres::StartOfFrame),
        };
        self.regs.tscon_h().write(pac::TsconH::ZERO.with_tseof(eof).with_tsres(res).with_tbcen(true));
        Ok(())
    }

    /// 5.4
    #[allow(unsafe_code, reason = "the base address of the message memory")]
    fn place_fifos(&self) {
        // SAFETY: `Layout::new` has checked that all sections lie in the region, which is the controller's by the
        // promise made to `Region::new`.
        unsafe { self.regs.write_fifoba(self.layout.fifoba) };
    }

    fn set_fifos(&mut self, config: &Config<'_>) -> Result<(), ConfigError> {
        const TXPRI: Limits = Limits::of::<pac::FifoConH>("FIFOCONH.TXPRI");
        let Self { regs, layout, .. } = &*self;
        let priority = |number: u8| -> Result<u8, OutOfRange> {
            let set = config.priorities.iter().rev().find(|(fifo, _)| *fifo == number);
            Ok(TXPRI.encode(set.map_or(0, |(_, priority)| u32::from(*priority)))? as u8)
        };
        if let Some((fifo, _)) = config.priorities.iter().find(|(fifo, _)| !transmits(layout.transmit, *fifo)) {
            return Err(ConfigError::NotTransmitting { fifo: *fifo });
        }
        let attempts = config.attempts.code();
        regs.txqcon_h().write(layout.txqcon_h.with_txat(attempts).with_txpri(priority(0)?));
        regs.tefcon_h().write(layout.tefcon_h);
        self.replies = config.replies.iter().fold(0, |mask, reply| mask | 1 << (reply.fifo % 32));
        self.regs.tefcon_l().write(self.event_control());
        if self.layout.txqen {
            self.regs.txqcon_l().write(pac::TxqconL::TXATIE);
        }
        // Equation 5-24: FIFOs that are not set up take room too, of the size that a reset gives them.
        for number in numbers(!1) {
            let high = self.layout.objects[usize::from(number)].size();
            let fifo = self.regs.fifo(usize::from(number));
            fifo.con_l().write(self.fifo_control(number));
            fifo.con_h().write(high.with_txat(attempts).with_txpri(priority(number)?));
        }
        Ok(())
    }

    /// 6.11: the objects of a reply's FIFO all hold the message, so that it is armed again by UINC alone.
    fn set_replies(&self, config: &Config<'_>) -> Result<(), ConfigError> {
        for reply in config.replies {
            let number = reply.fifo;
            if number == 0 || !transmits(self.layout.transmit, number) {
                return Err(ConfigError::NotTransmitting { fifo: number });
            }
            self.carries(number, &reply.frame)?;
            for index in 0..self.layout.objects[usize::from(number)].count {
                self.write_object(number, index, &reply.frame, TxOptions::default());
            }
        }
        Ok(())
    }
}

/// Whether a number is among those of a mask.
pub(super) const fn transmits(mask: u32, number: u8) -> bool {
    number < 32 && mask >> number & 1 == 1
}
