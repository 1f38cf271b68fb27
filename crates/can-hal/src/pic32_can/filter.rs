//! Acceptance filters and masks (34.8).

use can_frame::{ExtendedId, Id, StandardId};
use pic32_can_pac::{
    enums::{FltConFsel, FltConMsel, RxfExid, RxmMide},
    registers::{FltCon, Rxf, Rxm},
};
use regbus::Bus;

use super::{Can, ConfigError, Inner};
use crate::{Deadline, TimedOut, deadline::wait};

/// One of the four masks that the filters share (34.8.3): a 1 has the bit compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mask(Rxm);

impl Mask {
    /// Nothing is compared: a filter with it accepts every message.
    pub const ANY: Self = Self(Rxm::ZERO);
    /// The whole identifier and its type are compared.
    pub const EXACT: Self = Self(Rxm::ZERO.with_sid(0x7FF).with_eid(0x3_FFFF).with_mide(RxmMide::TypeOfFilter));

    /// These bits of 11-bit identifiers, and the type.
    #[must_use]
    pub fn standard(bits: StandardId) -> Self {
        Self(Rxm::ZERO.with_sid(bits.as_raw() & 0x7FF).with_mide(RxmMide::TypeOfFilter))
    }

    /// These bits of 29-bit identifiers, and the type.
    #[must_use]
    pub fn extended(bits: ExtendedId) -> Self {
        let (sid, eid) = split(bits);
        Self(Rxm::ZERO.with_sid(sid).with_eid(eid).with_mide(RxmMide::TypeOfFilter))
    }

    /// The same whatever the type of a message: a filter then compares an 11-bit identifier with the upper bits of its own
    /// (Table 34-3).
    #[must_use]
    pub const fn of_any_type(self) -> Self {
        Self(self.0.with_mide(RxmMide::AnyType))
    }

    /// The same with these of the 18 data bits that DeviceNet filtering compares; bit 17 is the first one (34.8.7).
    #[must_use]
    pub const fn with_data(self, bits: u32) -> Self {
        Self(self.0.with_eid(bits & 0x3_FFFF))
    }

    pub(super) const fn bits(self) -> Rxm {
        self.0
    }
}

/// One of the 32 filters (34.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// The identifier.
    pub id: Id,
    /// The mask that it is compared with, 0 to 3.
    pub mask: u8,
    /// The FIFO that accepted messages go to, 0 to 31. A transmit FIFO answers remote frames, if it is set up so.
    pub fifo: u8,
    /// For a filter for 11-bit identifiers with DeviceNet filtering: the data bits, bit 17 the first one (34.8.7).
    pub data: u32,
}

impl Filter {
    /// Compares an identifier through mask 0.
    #[must_use]
    pub const fn new(id: Id, fifo: u8) -> Self {
        Self { id, mask: 0, fifo, data: 0 }
    }

    /// Accepts what mask 0 lets pass; with [`Mask::ANY`] that is everything.
    #[must_use]
    pub const fn any(fifo: u8) -> Self {
        Self::new(Id::Standard(StandardId::ZERO), fifo)
    }

    /// The same with another mask.
    #[must_use]
    pub const fn with_mask(mut self, mask: u8) -> Self {
        self.mask = mask;
        self
    }

    /// The same with data bits, bit 17 the first one.
    #[must_use]
    pub const fn with_data(mut self, bits: u32) -> Self {
        self.data = bits;
        self
    }

    /// CiRXFn. The bounds never act; they tell the compiler that the values fit their fields.
    fn value(&self) -> Rxf {
        match self.id {
            Id::Standard(id) => Rxf::RESET.with_sid(id.as_raw() & 0x7FF).with_eid(self.data & 0x3_FFFF),
            Id::Extended(id) => {
                let (sid, eid) = split(id);
                Rxf::RESET.with_sid(sid).with_eid(eid).with_exid(RxfExid::Extended)
            }
        }
    }

    pub(super) const fn check(&self) -> Result<(), ConfigError> {
        if self.mask > 3 {
            return Err(ConfigError::NoSuchMask(self.mask));
        }
        if self.fifo > 31 {
            return Err(ConfigError::NoSuchFifo(self.fifo));
        }
        Ok(())
    }
}

/// SID and EID of a 29-bit identifier: its upper 11 and its lower 18 bits.
#[inline]
pub(super) fn split(id: ExtendedId) -> (u16, u32) {
    ((id.as_raw() >> 18) as u16 & 0x7FF, id.as_raw() & 0x3_FFFF)
}

/// MSEL and FSEL of a lane, all bits.
const fn select(lane: usize) -> FltCon {
    FltCon::ZERO.with_msel(lane, FltConMsel::from_bits(3)).with_fsel(lane, FltConFsel::from_bits(31))
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// 34.8.6: a filter that is switched off. Through the SET and CLR registers, so that its neighbours in the register
    /// stay as they are even while hardware changes them (34.8.1).
    pub(super) fn write_filter(&self, number: u8, filter: &Filter) {
        let (register, lane) = self.regs.flt_con_of(usize::from(number % 32));
        self.regs.rxf(usize::from(number % 32)).write(filter.value());
        register.clear_bits(select(lane));
        let wanted = FltCon::ZERO
            .with_msel(lane, FltConMsel::from_bits(filter.mask & 3))
            .with_fsel(lane, FltConFsel::from_bits(filter.fifo & 31));
        register.set_bits(wanted);
        register.set_bits(FltCon::flten_bit(lane));
    }

    /// 34.8.1: FLTEN stays 1 until the message at hand has been filtered.
    fn disable_filter(&self, number: u8, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        let (register, lane) = self.regs.flt_con_of(usize::from(number % 32));
        register.clear_bits(FltCon::flten_bit(lane));
        wait(deadline, || !register.read().flten(lane))
    }
}

/// Filters can be changed while the module runs, one at a time; masks cannot (34.8.1, 34.8.3).
impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Replaces a filter, 0 to 31; the lowest that matches takes a message. Waits until the filter is off first.
    ///
    /// # Errors
    /// [`ConfigError::TimedOut`] if the filter is not switched off in time: it will be, once the message at hand is over;
    /// or a filter, mask or FIFO that does not exist.
    pub fn set_filter(&mut self, number: u8, filter: &Filter, mut deadline: impl Deadline) -> Result<(), ConfigError> {
        if number > 31 {
            return Err(ConfigError::NoSuchFilter(number));
        }
        filter.check()?;
        self.inner.disable_filter(number, &mut deadline)?;
        self.inner.write_filter(number, filter);
        Ok(())
    }

    /// Switches a filter off. The message at hand may still be taken by it.
    ///
    /// # Errors
    /// [`ConfigError::TimedOut`] if that is not over in time, or a filter that does not exist.
    pub fn clear_filter(&mut self, number: u8, mut deadline: impl Deadline) -> Result<(), ConfigError> {
        if number > 31 {
            return Err(ConfigError::NoSuchFilter(number));
        }
        Ok(self.inner.disable_filter(number, &mut deadline)?)
    }
}
