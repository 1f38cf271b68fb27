//! Acceptance filters and masks, their locks, and DeviceNet filtering (34.8).

use can_frame::{Frame, Id};
use pic32_can_pac::{
    enums::{OperationMode, RxfExid, RxmMide},
    registers::{self as pac, FltCon},
};
use regbus::meta::AliasOp;

use super::{Pic32CanModel, config::DeviceNetOrder};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// Filters to a control register.
const LANES: u8 = 4;
/// Bits of EID, which end a DeviceNet comparison (34.8.7.2, case 1).
const EID_BITS: u32 = 18;

/// What a filter's control bits say.
struct Control {
    enabled: bool,
    mask: u8,
    fifo: u8,
}

impl Pic32CanModel {
    fn filter_control(&self, filter: u8) -> Control {
        let (register, lane) = (usize::from(filter / LANES), usize::from(filter % LANES));
        let control = FltCon::from_bits(self.regs.get(self.r.filter_control[register]));
        Control { enabled: control.flten(lane), mask: control.msel(lane).bits(), fifo: control.fsel(lane).bits() }
    }

    /// Mask of the enabled filters that point to a FIFO.
    pub(super) fn filters_pointing_to(&self, fifo: u8) -> u32 {
        self.enabled_filters(|control| control.fifo == fifo)
    }

    fn enabled_filters(&self, which: impl Fn(&Control) -> bool) -> u32 {
        (0..self.config.fifos).fold(0, |found, filter| {
            let control = self.filter_control(filter);
            found | u32::from(control.enabled && which(&control)) << filter
        })
    }

    /// 34.8: the FIFO of a filter if it is enabled and accepts the frame.
    pub(super) fn matches(&self, filter: u8, frame: &Frame) -> Option<u8> {
        let control = self.filter_control(filter);
        if !control.enabled {
            return None;
        }
        let value = pac::Rxf::from_bits(self.regs.get(self.r.filters[usize::from(filter)]));
        let mask = pac::Rxm::from_bits(self.regs.get(self.r.masks[usize::from(control.mask)]));
        self.accepts(value, mask, frame).then_some(control.fifo)
    }

    /// Table 34-3.
    fn accepts(&self, filter: pac::Rxf, mask: pac::Rxm, frame: &Frame) -> bool {
        let typed = mask.mide() == RxmMide::TypeOfFilter;
        if typed && (filter.exid() == RxfExid::Extended) != frame.is_extended() {
            return false;
        }
        // Reserved values have the effect of 18 (dncnt_above_18).
        let bits = self.regs.field(self.f.dncnt);
        match frame.id() {
            Id::Extended(id) => {
                let (sid, eid) = ((id.as_raw() >> EID_BITS) as u16, id.as_raw() & EID);
                // 34.8.7: IDE of a message has to be 0.
                bits == 0 && (sid ^ filter.sid()) & mask.sid() == 0 && (eid ^ filter.eid()) & mask.eid() == 0
            }
            Id::Standard(id) => {
                (id.as_raw() ^ filter.sid()) & mask.sid() == 0 && self.data_matches(filter, mask, frame, bits)
            }
        }
    }

    /// 34.8.7: the first data bits against EID of the filter; the comparison ends with the 18th bit or with the data.
    fn data_matches(&self, filter: pac::Rxf, mask: pac::Rxm, frame: &Frame, bits: u32) -> bool {
        if bits == 0 {
            return true;
        }
        let bits = bits.min(EID_BITS).min(frame.len() as u32 * 8);
        let bytes = frame.data_bytes();
        let byte = |at: usize| u32::from(bytes.get(at).copied().unwrap_or(0));
        // Bit 7 of byte 0 in bit 17.
        let first = (byte(0) << 16 | byte(1) << 8 | byte(2)) >> 6;
        let compared = EID & !(EID >> bits);
        let order = |word: u32| match self.config.choices.devicenet_order {
            DeviceNetOrder::HighestFirst => word,
            DeviceNetOrder::LowestFirst => word.reverse_bits() >> (32 - EID_BITS),
        };
        let masked = if self.config.choices.devicenet_ignores_mask { EID } else { order(mask.eid()) };
        (first ^ order(filter.eid())) & compared & masked == 0
    }

    /// 34.8.3: a mask cannot be changed while an enabled filter selects it, not even in Configuration mode.
    pub(super) fn write_mask(&self, cx: &mut Context<'_>, mask: u8, access: &mut WriteAccess) {
        let changed = access.new ^ access.old;
        if changed == 0 || self.enabled_filters(|control| control.mask == mask) == 0 {
            return;
        }
        access.new = access.old;
        let fields = self.regs.info(access.slot).fields.iter();
        let kind = DiagnosticKind::ProtectedWrite {
            register: self.regs.name(access.slot),
            fields: fields.filter(|field| field.all() & changed != 0).map(|field| field.name).collect(),
            value: access.written,
            condition: "no enabled filter selects the mask",
        };
        cx.report("34.8.3", kind);
    }

    fn filters_can_change(&self) -> bool {
        let named =
            matches!(self.mode(), OperationMode::Configuration | OperationMode::Normal | OperationMode::Disable);
        named || !self.config.choices.filters_locked_in_other_modes
    }

    pub(super) fn write_filter(&self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        if access.new != access.old && !self.filters_can_change() {
            access.new = access.old;
            let because = "filters can be changed in Configuration, Normal and Disable mode";
            self.ignored(cx, "34.8.1", access.slot, "SID", because);
        }
    }

    /// 34.8.1: a filter is not switched off while a message is being received; FLTEN reads 1 until then.
    pub(super) fn write_filter_control(&mut self, cx: &mut Context<'_>, register: u8, access: &mut WriteAccess) {
        if access.new != access.old && !self.filters_can_change() {
            access.new = access.old;
            let because = "filters can be changed in Configuration, Normal and Disable mode";
            return self.ignored(cx, "34.8.1", access.slot, "FLTEN", because);
        }
        if self.config.choices.filter_lock_by_new_state {
            access.new = by_new_state(access);
        }
        let (old, new) = (FltCon::from_bits(access.old), FltCon::from_bits(access.new));
        for lane in 0..LANES {
            let flag = FltCon::flten_bit(usize::from(lane)).bits();
            let filter = 1 << (register * LANES + lane);
            if old.bits() & flag != 0 && new.bits() & flag == 0 && self.rx.processing {
                access.new |= flag;
                self.rx.disabling |= filter;
            } else if self.rx.disabling & filter != 0
                && access.ones() & flag != 0
                && matches!(access.alias, None | Some(AliasOp::Set))
                && !self.config.choices.filter_disable_sticks
            {
                self.rx.disabling &= !filter;
            }
        }
    }

    /// The message at hand has been filtered: filters that were to be switched off are.
    pub(super) fn finish_disabling(&mut self) {
        for filter in super::bits(core::mem::take(&mut self.rx.disabling)) {
            let slot = self.r.filter_control[usize::from(filter / LANES)];
            let flag = FltCon::flten_bit(usize::from(filter % LANES)).bits();
            self.regs.set(slot, self.regs.get(slot) & !flag);
        }
    }

    /// A filter that is enabled has to point to a FIFO that exists.
    pub(super) fn check_destinations(&self, cx: &mut Context<'_>, register: u8) {
        for filter in register * LANES..(register + 1) * LANES {
            let control = self.filter_control(filter);
            if control.enabled && control.fifo >= self.config.fifos {
                let what = format!("filter {filter} points to FIFO {}, which this device does not have", control.fifo);
                cx.report("34.8.4", DiagnosticKind::Contradiction { what });
            }
        }
    }
}

/// `filter_enable_and_select_in_one_write`: MSEL and FSEL are taken where FLTEN is 0 after the write.
fn by_new_state(access: &WriteAccess) -> u32 {
    let data = match access.alias {
        None => access.written,
        Some(AliasOp::Clear) => access.old & !access.written,
        Some(AliasOp::Set) => access.old | access.written,
        Some(AliasOp::Invert) => access.old ^ access.written,
    };
    (0..LANES).map(usize::from).fold(0, |word, lane| {
        let (flag, bits) = (FltCon::flten_bit(lane).bits(), 0xFF << (lane * 8));
        let from = if data & flag == 0 { data } else { access.old & !flag | flag };
        word | from & bits
    })
}

/// The bits of EID.
const EID: u32 = (1 << EID_BITS) - 1;
