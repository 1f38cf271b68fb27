//! Configuration (2.3, 3.1.1): everything that is protected by CCCR.INIT and CCCR.CCE.

use core::fmt;

use can_frame::ExtendedId;
use m_can_pac::{
    enums::{CccrNiso, CccrUtsu, CccrWmm, FifoMode, NonMatching, RemoteFrames, ToccTos, TsccTss, TxbcTfqm},
    registers as pac,
};
use regbus::Bus;

use super::{Can, ExtendedFilter, Filter, FilterError, Inner, StandardFilter};
use crate::{OutOfRange, TimedOut, fields::Limits, memory::Placed, mode::Configuration, timing::MCanTiming};

/// Which frame formats the controller sends and receives (3.1.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FdMode {
    /// Classic frames only; a received FD frame is answered with an error frame.
    Classic,
    /// FD frames too.
    Fd {
        /// Frames may switch to the data bit rate (CCCR.BRSE).
        bit_rate_switch: bool,
        /// The format before ISO 11898-1:2015 (CCCR.NISO). Not every M_CAN has it.
        non_iso: bool,
    },
}

/// How the Tx Buffers that are not dedicated are used (3.5.3, 3.5.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TxMode {
    /// Sent in the order in which they were requested.
    Fifo,
    /// Sent in the order of their identifiers.
    Queue,
}

/// Where timestamps come from (3.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timestamping {
    /// Nowhere: they are 0.
    Off,
    /// From the internal counter, which counts periods of 1 to 16 nominal bit times. With rate switching its unit
    /// changes during a frame; the manual wants an external counter for CAN FD (2.3.9).
    Counter {
        /// Bit times in a unit.
        bit_times: u8,
    },
    /// From the external timebase.
    External,
    /// From a Timestamping Unit, for filters with `sync` and messages sent with `sync`. Not every M_CAN has one.
    Unit,
}

/// The timeout counter (3.3). It counts down in the unit of the timestamp counter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timeout {
    /// What starts it: leaving configuration mode, or a FIFO that is no longer empty.
    pub source: ToccTos,
    /// What it counts down from.
    pub period: u16,
}

/// The configuration. The sizes of FIFOs and buffers are those of the plan given to [`Can::new`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config<'a> {
    /// Bit timing, with a data phase if frames may switch the bit rate. [`MCanTiming::of`] makes it of any
    /// [`BitTiming`](crate::timing::BitTiming).
    pub timing: MCanTiming,
    /// Frame formats.
    pub fd: FdMode,
    /// No retransmission (CCCR.DAR, 3.1.7).
    pub one_shot: bool,
    /// A pause of two bit times after each own frame (CCCR.TXP, 3.5.1).
    pub transmit_pause: bool,
    /// Two dominant time quanta make an edge during bus integration (CCCR.EFBI).
    pub edge_filtering: bool,
    /// The controller answers what looks like a future format with an error frame (CCCR.PXHD).
    pub no_protocol_exception: bool,
    /// Message markers of 16 bits, for which Tx events lose their timestamp (CCCR.WMM).
    pub wide_markers: bool,
    /// What happens to 11-bit messages that match no filter.
    pub other_standard: NonMatching,
    /// What happens to 29-bit messages that match no filter.
    pub other_extended: NonMatching,
    /// All remote frames with 11-bit identifiers are rejected.
    pub reject_remote_standard: bool,
    /// All remote frames with 29-bit identifiers are rejected.
    pub reject_remote_extended: bool,
    /// Extended ID AND Mask: these bits of received identifiers take part in filtering (3.4.1.1).
    pub extended_mask: ExtendedId,
    /// What Rx FIFO 0 and 1 do when they are full.
    pub rx_mode: [FifoMode; 2],
    /// Levels at which Rx FIFO 0 and 1 raise their watermark interrupt; 0 for never.
    pub rx_watermark: [u8; 2],
    /// How the Tx Buffers that are not dedicated are used.
    pub tx_mode: TxMode,
    /// The level at which the Tx Event FIFO raises its watermark interrupt; 0 for never.
    pub tx_event_watermark: u8,
    /// Where timestamps come from.
    pub timestamps: Timestamping,
    /// Timeout counter.
    pub timeout: Option<Timeout>,
    /// Host clock periods that an access to the Message RAM may take; 0 for any time (2.3.6).
    pub ram_watchdog: u8,
    /// Filters for 11-bit identifiers, in the order in which they are tried; the rest of the list is disabled.
    pub standard_filters: &'a [StandardFilter],
    /// Filters for 29-bit identifiers.
    pub extended_filters: &'a [ExtendedFilter],
    /// How often the blocking calls of `embedded_can` try before they fail.
    pub blocking_polls: u32,
}

impl Config<'_> {
    /// What [`Config::new`] sets for [`Config::blocking_polls`].
    pub const BLOCKING_POLLS: u32 = 1_000_000;
}

impl<'a> Config<'a> {
    /// Classic frames with this bit timing; all that the reset values of the registers stand for: no filters, all
    /// messages to Rx FIFO 0, no timestamps.
    #[must_use]
    pub const fn new(timing: MCanTiming) -> Self {
        Self {
            timing,
            fd: FdMode::Classic,
            one_shot: false,
            transmit_pause: false,
            edge_filtering: false,
            no_protocol_exception: false,
            wide_markers: false,
            other_standard: NonMatching::RxFifo0,
            other_extended: NonMatching::RxFifo0,
            reject_remote_standard: false,
            reject_remote_extended: false,
            extended_mask: ExtendedId::MAX,
            rx_mode: [FifoMode::Blocking; 2],
            rx_watermark: [0; 2],
            tx_mode: TxMode::Fifo,
            tx_event_watermark: 0,
            timestamps: Timestamping::Off,
            timeout: None,
            ram_watchdog: 0,
            standard_filters: &[],
            extended_filters: &[],
            blocking_polls: Self::BLOCKING_POLLS,
        }
    }

    /// The same with FD frames in the ISO format, with bit-rate switch.
    #[must_use]
    pub const fn with_fd(mut self) -> Self {
        self.fd = FdMode::Fd { bit_rate_switch: true, non_iso: false };
        self
    }

    /// The same with these filters, and everything else rejected.
    #[must_use]
    pub const fn with_filters(mut self, standard: &'a [StandardFilter], extended: &'a [ExtendedFilter]) -> Self {
        self.standard_filters = standard;
        self.extended_filters = extended;
        self.other_standard = NonMatching::Reject;
        self.other_extended = NonMatching::Reject;
        self
    }

    /// The bits of CCCR.
    const fn cccr(&self) -> pac::Cccr {
        let (fdoe, brse, niso) = match self.fd {
            FdMode::Classic => (false, false, CccrNiso::Iso11898_1),
            FdMode::Fd { bit_rate_switch, non_iso } => {
                let niso = if non_iso { CccrNiso::BoschFdV1 } else { CccrNiso::Iso11898_1 };
                (true, bit_rate_switch, niso)
            }
        };
        let utsu = match self.timestamps {
            Timestamping::Unit => CccrUtsu::External,
            _ => CccrUtsu::Internal,
        };
        pac::Cccr::ZERO
            .with_fdoe(fdoe)
            .with_brse(brse)
            .with_niso(niso)
            .with_dar(self.one_shot)
            .with_txp(self.transmit_pause)
            .with_efbi(self.edge_filtering)
            .with_pxhd(self.no_protocol_exception)
            .with_wmm(if self.wide_markers { CccrWmm::Bits16 } else { CccrWmm::Bits8 })
            .with_utsu(utsu)
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
    /// A filter cannot be stored.
    Filter(FilterError),
    /// This M_CAN was synthesized without the function of this bit of CCCR (2.3.7).
    NotAvailable(&'static str),
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
            Self::NotAvailable(bit) => write!(f, "this M_CAN was synthesized without CCCR.{bit}"),
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

from!(OutOfRange => OutOfRange, FilterError => Filter);

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
        inner.cccr = config.cccr();
        inner.blocking_polls = config.blocking_polls;
        inner.regs.cccr().write(inner.cccr | pac::Cccr::INIT | pac::Cccr::CCE);
        let stored = inner.regs.cccr().read();
        if stored.utsu() != inner.cccr.utsu() {
            return Err(ConfigError::NotAvailable("UTSU"));
        }
        if stored.niso() != inner.cccr.niso() {
            return Err(ConfigError::NotAvailable("NISO"));
        }
        self.set_bit_timing(&config.timing);
        let inner = &self.inner;
        inner.regs.rwd().write(pac::Rwd::ZERO.with_wdc(config.ram_watchdog));
        inner.write_counters(config)?;
        inner.write_sections(config)?;
        inner.write_filters(config)
    }

    /// Changes the bit timing alone (3.1.3, 2.3.4, 2.3.8), for example while the bit rate of a bus is searched for.
    pub fn set_bit_timing(&mut self, timing: &MCanTiming) {
        let regs = &self.inner.regs;
        regs.nbtp().write(timing.nbtp);
        regs.dbtp().write(timing.dbtp);
        regs.tdcr().write(timing.tdcr);
    }

    /// Writes every word of the sections with 0. After reset, a Message RAM with parity or ECC needs it: reading a word
    /// that was never written may be an error that sets CCCR.INIT (2.4, 3.1.1). Filters are disabled by it; call it
    /// before [`Can::configure`].
    pub fn zero_memory(&mut self) {
        let Inner { ram, layout, .. } = &self.inner;
        let [fifo_0, fifo_1] = &layout.rx_fifos;
        let messages = [fifo_0, fifo_1, &layout.rx_buffers, &layout.tx_events, &layout.tx_buffers];
        for section in [&layout.standard_filters, &layout.extended_filters].into_iter().chain(messages) {
            for offset in (section.at(0)..section.at(section.count)).step_by(4) {
                ram.write(offset, 0_u32);
            }
        }
    }
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Timestamp and timeout counter (2.3.9 to 2.3.12).
    fn write_counters(&self, config: &Config<'_>) -> Result<(), OutOfRange> {
        const TCP: Limits = Limits::of::<pac::Tscc>("TSCC.TCP");
        let (source, bit_times) = match config.timestamps {
            Timestamping::Off | Timestamping::Unit => (TsccTss::Zero, 1),
            Timestamping::Counter { bit_times } => (TsccTss::Internal, bit_times),
            Timestamping::External => (TsccTss::External, 1),
        };
        let prescaler = TCP.encode(u32::from(bit_times))? as u8;
        self.regs.tscc().write(pac::Tscc::ZERO.with_tcp(prescaler).with_tss(source));
        let tocc = config.timeout.map_or(pac::Tocc::RESET, |timeout| {
            pac::Tocc::ZERO.with_top(timeout.period).with_tos(timeout.source).with_etoc(true)
        });
        self.regs.tocc().write(tocc);
        Ok(())
    }

    /// Sections of the Message RAM (2.3.19 to 2.3.45).
    #[allow(unsafe_code, reason = "start addresses of the Message RAM")]
    fn write_sections(&self, config: &Config<'_>) -> Result<(), OutOfRange> {
        const F0WM: Limits = Limits::of::<pac::Rxf0c>("RXF0C.F0WM");
        const F1WM: Limits = Limits::of::<pac::Rxf1c>("RXF1C.F1WM");
        const EFWM: Limits = Limits::of::<pac::Txefc>("TXEFC.EFWM");
        let Self { regs, layout, .. } = self;
        let [fifo_0, fifo_1] = &layout.rx_fifos;
        let mode = match config.tx_mode {
            TxMode::Fifo => TxbcTfqm::Fifo,
            TxMode::Queue => TxbcTfqm::Queue,
        };
        let rxf0c = pac::Rxf0c::ZERO
            .with_f0om(config.rx_mode[0])
            .with_f0wm(F0WM.encode(u32::from(config.rx_watermark[0]))? as u8)
            .with_f0s(fifo_0.count)
            .with_f0sa(fifo_0.word);
        let rxf1c = pac::Rxf1c::ZERO
            .with_f1om(config.rx_mode[1])
            .with_f1wm(F1WM.encode(u32::from(config.rx_watermark[1]))? as u8)
            .with_f1s(fifo_1.count)
            .with_f1sa(fifo_1.word);
        let txefc = pac::Txefc::ZERO
            .with_efwm(EFWM.encode(u32::from(config.tx_event_watermark))? as u8)
            .with_efs(layout.tx_events.count)
            .with_efsa(layout.tx_events.word);
        let sidfc = pac::Sidfc::ZERO.with_lss(layout.standard_filters.count);
        let xidfc = pac::Xidfc::ZERO.with_lse(layout.extended_filters.count);
        let txbc = pac::Txbc::ZERO.with_tfqm(mode).with_tfqs(layout.queue()).with_ndtb(layout.dedicated);
        // SAFETY: `Layout::new` has checked that all sections lie in the region, which is the controller's by the
        // promise made to `Region::new`.
        unsafe {
            regs.sidfc().write_unsafe(sidfc.with_flssa(layout.standard_filters.word));
            regs.xidfc().write_unsafe(xidfc.with_flesa(layout.extended_filters.word));
            regs.rxf0c().write_unsafe(rxf0c);
            regs.rxf1c().write_unsafe(rxf1c);
            regs.rxbc().write_unsafe(pac::Rxbc::ZERO.with_rbsa(layout.rx_buffers.word));
            regs.rxesc().write_unsafe(layout.rxesc());
            regs.txbc().write_unsafe(txbc.with_tbsa(layout.tx_buffers.word));
            regs.txesc().write_unsafe(layout.txesc());
            regs.txefc().write_unsafe(txefc);
        }
        Ok(())
    }

    /// Global and single filters (2.3.20 to 2.3.23, 2.4.5, 2.4.6).
    fn write_filters(&self, config: &Config<'_>) -> Result<(), ConfigError> {
        let remote = |reject| if reject { RemoteFrames::Reject } else { RemoteFrames::Filter };
        let gfc = pac::Gfc::ZERO.with_anfs(config.other_standard).with_anfe(config.other_extended);
        let gfc = gfc.with_rrfs(remote(config.reject_remote_standard)).with_rrfe(remote(config.reject_remote_extended));
        self.regs.gfc().write(gfc);
        self.regs.xidam().write(pac::Xidam::ZERO.with_eidm(config.extended_mask.as_raw()));
        for (index, filter) in filled(config.standard_filters, self.layout.standard_filters.count) {
            self.write_standard_filter(index, &filter)?;
        }
        for (index, filter) in filled(config.extended_filters, self.layout.extended_filters.count) {
            self.write_extended_filter(index, &filter)?;
        }
        Ok(())
    }
}

/// The filters, and disabled ones for the rest of the list.
fn filled<I: Copy>(filters: &[Filter<I>], count: u8) -> impl Iterator<Item = (usize, Filter<I>)> {
    let rest = usize::from(count).saturating_sub(filters.len());
    filters.iter().copied().chain(core::iter::repeat_n(Filter::DISABLED, rest)).enumerate()
}
