//! Acceptance filters (8.0). They may change in any mode, each while it is disabled.

use core::fmt;

use can_frame::{ExtendedId, StandardId};
use dspic33_canfd_pac::{
    Dspic33Canfd,
    enums::{FltConFbp, FltObjHExide, MaskHMide},
    registers::{FltObjH, FltObjL, MaskH, MaskL},
};
use regbus::Bus;

use super::{Can, Inner};

/// All bits of an 11-bit and of a 29-bit identifier.
const ALL_STANDARD: u16 = 0x7FF;
const ALL_EXTENDED: u32 = 0x1FFF_FFFF;

/// Which messages match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matching {
    /// All, with 11-bit or 29-bit identifier.
    Any,
    /// 11-bit identifiers that equal the first where the mask is 1.
    Standard(StandardId, u16),
    /// 29-bit identifiers that equal the first where the mask is 1.
    Extended(ExtendedId, u32),
    /// 11-bit identifiers, and data bits behind them: the most significant bit of data byte 0 is compared with bit 0 of
    /// `data` and so on, as far as [`Config::data_filter_bits`](super::Config::data_filter_bits) and the message reach
    /// (8.2.3).
    StandardData {
        /// The identifier.
        id: StandardId,
        /// Its mask.
        mask: u16,
        /// Up to 18 data bits.
        data: u32,
        /// Their mask.
        data_mask: u32,
    },
    /// 12-bit identifiers of FD frames (8.2.4), which [`Config::twelve_bit_ids`](super::Config::twelve_bit_ids) enables.
    /// Bit 0 is the RRS bit.
    TwelveBit(u16, u16),
}

/// An acceptance filter: which messages match, and the FIFO they go to. A FIFO that transmits answers remote frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// Which messages match.
    pub matching: Matching,
    /// The FIFO, 1 to 31.
    pub fifo: u8,
}

impl Filter {
    /// Matches all messages.
    #[must_use]
    pub const fn any(fifo: u8) -> Self {
        Self { matching: Matching::Any, fifo }
    }

    /// Matches one 11-bit identifier.
    #[must_use]
    pub const fn standard(id: StandardId, fifo: u8) -> Self {
        Self { matching: Matching::Standard(id, ALL_STANDARD), fifo }
    }

    /// Matches one 29-bit identifier.
    #[must_use]
    pub const fn extended(id: ExtendedId, fifo: u8) -> Self {
        Self { matching: Matching::Extended(id, ALL_EXTENDED), fifo }
    }

    /// Matches what equals `id` where `mask` is 1.
    #[must_use]
    pub const fn standard_mask(id: StandardId, mask: u16, fifo: u8) -> Self {
        Self { matching: Matching::Standard(id, mask), fifo }
    }

    /// Matches what equals `id` where `mask` is 1.
    #[must_use]
    pub const fn extended_mask(id: ExtendedId, mask: u32, fifo: u8) -> Self {
        Self { matching: Matching::Extended(id, mask), fifo }
    }
}

/// Why a filter cannot be set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FilterError {
    /// There are 32 filters.
    NoSuchFilter {
        /// The filter asked for.
        index: usize,
    },
    /// The plan has no such FIFO.
    NoSuchFifo {
        /// The FIFO asked for.
        fifo: u8,
    },
    /// Identifier, data or mask have bits that are not compared.
    TooWide {
        /// The value.
        value: u32,
    },
}

impl fmt::Display for FilterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchFilter { index } => write!(f, "there are 32 filters, but no filter {index}"),
            Self::NoSuchFifo { fifo } => write!(f, "the plan has no FIFO {fifo}"),
            Self::TooWide { value } => write!(f, "{value:#x} has more bits than are compared"),
        }
    }
}

impl core::error::Error for FilterError {}

/// Object and mask in registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Words {
    object: (FltObjL, FltObjH),
    mask: (MaskL, MaskH),
}

impl Words {
    const NOTHING: Self = Self { object: (FltObjL::ZERO, FltObjH::ZERO), mask: (MaskL::ZERO, MaskH::ZERO) };

    /// Base identifiers, their extensions or data bits, and the type of frame if it matters.
    fn new(base: [u16; 2], extension: [u32; 2], extended: bool) -> Result<Self, FilterError> {
        let fits = |value: u32, max: u32| if value > max { Err(FilterError::TooWide { value }) } else { Ok(()) };
        for base in base {
            fits(u32::from(base), u32::from(ALL_STANDARD))?;
        }
        for extension in extension {
            fits(extension, 0x3_FFFF)?;
        }
        let low = |value: u32| (value & 0x1F) as u8;
        let high = |value: u32| (value >> 5) as u16;
        let exide = if extended { FltObjHExide::Extended } else { FltObjHExide::Standard };
        Ok(Self {
            object: (
                FltObjL::ZERO.with_sid(base[0]).with_eid(low(extension[0])),
                FltObjH::ZERO.with_eid(high(extension[0])).with_exide(exide),
            ),
            mask: (
                MaskL::ZERO.with_msid(base[1]).with_meid(low(extension[1])),
                MaskH::ZERO.with_meid(high(extension[1])).with_mide(MaskHMide::AsExide),
            ),
        })
    }

    fn of(matching: Matching) -> Result<Self, FilterError> {
        match matching {
            // 8.2.1: MIDE = 0 accepts both types of frames.
            Matching::Any => Ok(Self::NOTHING),
            Matching::Standard(id, mask) => Self::new([id.as_raw(), mask], [0; 2], false),
            Matching::Extended(id, mask) => {
                if mask > ALL_EXTENDED {
                    return Err(FilterError::TooWide { value: mask });
                }
                let split = |raw: u32| ((raw >> 18) as u16, raw & 0x3_FFFF);
                let ((base, extension), (base_mask, extension_mask)) = (split(id.as_raw()), split(mask));
                Self::new([base, base_mask], [extension, extension_mask], true)
            }
            Matching::StandardData { id, mask, data, data_mask } => {
                Self::new([id.as_raw(), mask], [data, data_mask], false)
            }
            Matching::TwelveBit(id, mask) => {
                let mut words = Self::new([id >> 1, mask >> 1], [0; 2], false)?;
                words.object.1 = words.object.1.with_sid11(id & 1 == 1);
                words.mask.1 = words.mask.1.with_msid11(mask & 1 == 1);
                Ok(words)
            }
        }
    }
}

/// 8.1: disabled, object and mask, then the FIFO, then enabled.
fn write<R: Bus>(regs: &Dspic33Canfd<R>, index: usize, words: &Words, fifo: Option<u8>) {
    let (control, lane) = regs.flt_con_of(index);
    let disabled = control.read().with_flten(lane, false);
    control.write(disabled);
    let filter = regs.flt(index);
    filter.obj_l().write(words.object.0);
    filter.obj_h().write(words.object.1);
    filter.mask_l().write(words.mask.0);
    filter.mask_h().write(words.mask.1);
    if let Some(fifo) = fifo {
        let pointed = disabled.with_fbp(lane, FltConFbp::from_bits(fifo));
        control.write(pointed);
        control.write(pointed.with_flten(lane, true));
    }
}

impl<R: Bus, M: Bus> Inner<R, M> {
    pub(super) fn write_filter(&self, index: usize, filter: Option<&Filter>) -> Result<(), FilterError> {
        if index >= Dspic33Canfd::<R>::FLT_LEN {
            return Err(FilterError::NoSuchFilter { index });
        }
        let Some(filter) = filter else {
            write(&self.regs, index, &Words::NOTHING, None);
            return Ok(());
        };
        let fifo = filter.fifo;
        let fifos = (self.layout.receive | self.layout.transmit) & !1;
        if fifo > 31 || fifos >> fifo & 1 == 0 {
            return Err(FilterError::NoSuchFifo { fifo });
        }
        write(&self.regs, index, &Words::of(filter.matching)?, Some(fifo));
        Ok(())
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Replaces a filter, 0 to 31, in any mode; `None` disables it (8.1). Filters are tried from 0 on. While it changes it
    /// is disabled.
    ///
    /// # Errors
    /// A [`FilterError`]; the filter is unchanged then.
    pub fn set_filter(&mut self, index: usize, filter: Option<&Filter>) -> Result<(), FilterError> {
        self.inner.write_filter(index, filter)
    }
}
