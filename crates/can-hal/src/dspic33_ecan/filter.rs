//! Acceptance filters and masks (9.1, 9.5).
//!
//! None of their registers is protected: they may change while the module runs, and a change holds from the next message
//! on (`unprotected_registers`).

use core::fmt;

use can_frame::{Id, StandardId};
use dspic33_ecan_pac::{
    enums::{FilterTarget, IdentifierFormat, MaskSource, RxmSidMide},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Config, Inner, Use, tx::TX_BUFFERS};

/// Number of acceptance filters (1.0).
pub const FILTERS: u8 = 16;

/// Bits of SID.
const SID: u16 = (1 << 11) - 1;
/// Bits of EID: of an extended identifier below the standard one, or of data.
const EID_BITS: u32 = 18;
const EID: u32 = (1 << EID_BITS) - 1;

/// Which bits filters compare, and whether they look at the length of identifiers (9.1.2, 9.1.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mask {
    /// SID\[10:0\]: 1 compares. More bits are ignored.
    pub sid: u16,
    /// EID\[17:0\]: 1 compares a bit of an extended identifier, or a data bit of a standard message. More bits are ignored.
    pub eid: u32,
    /// MIDE: only messages with the length of the filter's identifier match. Without, a standard message is compared in
    /// SID alone, and an extended one in SID and EID (Register 4-6).
    pub by_length: bool,
}

impl Mask {
    /// Compares nothing: every message matches.
    pub const ANY: Self = Self { sid: 0, eid: 0, by_length: false };
    /// Compares all 11 bits; matches standard messages only.
    pub const STANDARD: Self = Self::standard(SID);
    /// Compares all 29 bits; matches extended messages only.
    pub const EXTENDED: Self = Self::extended((SID as u32) << EID_BITS | EID);

    /// Compares these of 11 bits; matches standard messages only.
    #[must_use]
    pub const fn standard(bits: u16) -> Self {
        Self { sid: bits, eid: 0, by_length: true }
    }

    /// Compares these of 29 bits; matches extended messages only.
    #[must_use]
    pub const fn extended(bits: u32) -> Self {
        Self { sid: (bits >> EID_BITS) as u16, eid: bits & EID, by_length: true }
    }

    /// The same with the first `count` data bits compared too (9.5). [`Config::data_bits`] must be as high.
    #[must_use]
    pub const fn with_data_bits(mut self, count: u8) -> Self {
        let count = if count as u32 > EID_BITS { EID_BITS } else { count as u32 };
        self.eid |= EID & !(EID >> count);
        self
    }
}

/// An acceptance filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// The identifier, where the mask compares it.
    pub id: Id,
    /// The first 18 data bits of standard messages, the first one on the bus highest (9.5). Not used with an extended
    /// identifier.
    pub data: u32,
    /// The mask.
    pub mask: MaskSource,
    /// Where messages go: to a buffer, or to the FIFO.
    pub target: FilterTarget,
}

impl Filter {
    /// Messages whose identifier is this one where the mask compares it.
    #[must_use]
    pub const fn new(id: Id, mask: MaskSource, target: FilterTarget) -> Self {
        Self { id, data: 0, mask, target }
    }

    /// Every message, with a mask that is [`Mask::ANY`].
    #[must_use]
    pub const fn any(target: FilterTarget, mask: MaskSource) -> Self {
        Self::new(Id::Standard(StandardId::ZERO), mask, target)
    }

    /// The same for messages whose data begins with these bytes, of which the mask compares up to 18 bits.
    #[must_use]
    pub const fn with_data(mut self, data: [u8; 3]) -> Self {
        self.data = (data[0] as u32) << 10 | (data[1] as u32) << 2 | data[2] as u32 >> 6;
        self
    }

    fn registers(&self) -> (pac::RxfSid, pac::RxfEid) {
        let (format, sid, eid) = match self.id {
            Id::Standard(id) => (IdentifierFormat::Standard, id.as_raw(), self.data & EID),
            Id::Extended(id) => {
                let raw = id.as_raw();
                (IdentifierFormat::Extended, (raw >> EID_BITS) as u16, raw & EID)
            }
        };
        let high = pac::RxfSid::RESET.with_sid(sid & SID).with_exide(format);
        (high.with_eid((eid >> 16) as u8), pac::RxfEid::RESET.with_eid(eid as u16))
    }
}

/// Why a filter was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FilterError {
    /// There are not so many filters.
    NoSuchFilter {
        /// The filter.
        filter: u8,
    },
    /// It points to a buffer that the plan does not have, or to none that a filter can reach directly (9.2.4).
    NoSuchBuffer {
        /// The filter.
        filter: u8,
        /// The buffer.
        buffer: u8,
    },
    /// It points to a buffer that sends and does not answer remote frames (9.2.2).
    BufferSends {
        /// The filter.
        filter: u8,
        /// The buffer.
        buffer: u8,
    },
}

impl fmt::Display for FilterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchFilter { filter } => write!(f, "there are {FILTERS} filters, but no filter {filter}"),
            Self::NoSuchBuffer { filter, buffer } => {
                write!(
                    f,
                    "filter {filter} points to buffer {buffer}, which does not exist or is reached by the FIFO only"
                )
            }
            Self::BufferSends { filter, buffer } => write!(f, "filter {filter} points to buffer {buffer}, which sends"),
        }
    }
}

impl core::error::Error for FilterError {}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Sets a filter and enables it, in any mode. It is disabled while it changes.
    ///
    /// # Errors
    /// A [`FilterError`]; nothing is changed then.
    pub fn set_filter(&mut self, number: u8, filter: &Filter) -> Result<(), FilterError> {
        if number >= FILTERS {
            return Err(FilterError::NoSuchFilter { filter: number });
        }
        let inner = &mut self.inner;
        inner.check_target(number, filter, |buffer| inner.tx.uses[usize::from(buffer)])?;
        inner.set_enabled(number, false);
        inner.write_filter(number, filter);
        inner.rx.receives(filter.target);
        inner.set_enabled(number, true);
        Ok(())
    }

    /// Disables a filter, in any mode. What its buffer holds can still be fetched.
    ///
    /// # Errors
    /// [`FilterError::NoSuchFilter`].
    pub fn disable_filter(&mut self, number: u8) -> Result<(), FilterError> {
        if number >= FILTERS {
            return Err(FilterError::NoSuchFilter { filter: number });
        }
        self.inner.set_enabled(number, false);
        Ok(())
    }

    /// Sets a mask, in any mode. Filters that use it see parts of the old and of the new one while it changes; disable them
    /// before where that matters.
    pub fn set_mask(&mut self, number: MaskSource, mask: &Mask) {
        self.inner.write_mask(number, mask);
    }
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// 9.2.1, 9.2.2
    fn check_target(&self, filter: u8, of: &Filter, use_of: impl Fn(u8) -> Use) -> Result<(), FilterError> {
        let FilterTarget::Buffer(buffer) = of.target else { return Ok(()) };
        if buffer >= self.layout.count() || FilterTarget::from_bits(buffer) == FilterTarget::Fifo {
            return Err(FilterError::NoSuchBuffer { filter, buffer });
        }
        let sends = buffer < TX_BUFFERS && matches!(use_of(buffer), Use::Queue | Use::Dedicated(_));
        if sends { Err(FilterError::BufferSends { filter, buffer }) } else { Ok(()) }
    }

    pub(super) fn check_filters(&self, config: &Config<'_>) -> Result<(), FilterError> {
        for (number, filter) in (0..=u8::MAX).zip(config.filters) {
            if number >= FILTERS {
                return Err(FilterError::NoSuchFilter { filter: number });
            }
            self.check_target(number, filter, |buffer| config.uses[usize::from(buffer)])?;
        }
        Ok(())
    }

    fn set_enabled(&self, number: u8, enabled: bool) {
        self.regs.fen1().modify(|enables| enables.with_flten(usize::from(number), enabled));
    }

    /// 9.1.4: masks and filters before their enables.
    pub(super) fn write_all_filters(&mut self, config: &Config<'_>) {
        self.disable_filters();
        self.rx = super::rx::Rx::default();
        for (number, mask) in [MaskSource::Mask0, MaskSource::Mask1, MaskSource::Mask2].into_iter().zip(&config.masks) {
            self.write_mask(number, mask);
        }
        let mut enabled = pac::Fen1::from_bits(0);
        for (number, filter) in (0..FILTERS).zip(config.filters) {
            self.write_filter(number, filter);
            self.rx.receives(filter.target);
            enabled = enabled.with_flten(usize::from(number), true);
        }
        self.rx.fifo = self.layout.fifo();
        self.regs.fen1().write(enabled);
    }

    pub(super) fn disable_filters(&self) {
        self.regs.fen1().write(pac::Fen1::from_bits(0));
    }

    fn write_mask(&mut self, number: MaskSource, mask: &Mask) {
        let n = usize::from(number.bits());
        let mide = if mask.by_length { RxmSidMide::ByExide } else { RxmSidMide::BothFormats };
        let sid = pac::RxmSid::RESET.with_sid(mask.sid & SID).with_mide(mide);
        let eid = mask.eid & EID;
        self.regs.filter_window(|window| {
            window.rxm_sid(n).write(sid.with_eid((eid >> 16) as u8));
            window.rxm_eid(n).write(pac::RxmEid::RESET.with_eid(eid as u16));
        });
    }

    fn write_filter(&mut self, number: u8, filter: &Filter) {
        let n = usize::from(number);
        let (sid, eid) = filter.registers();
        let (sources, lane) = self.regs.fmsk_sel_of(n);
        sources.modify(|sources| sources.with_fmsk(lane, filter.mask));
        self.regs.filter_window(|window| {
            window.rxf_sid(n).write(sid);
            window.rxf_eid(n).write(eid);
            let (pointers, lane) = window.buf_pnt_of(n);
            pointers.modify(|pointers| pointers.with_fbp(lane, filter.target));
        });
    }
}
