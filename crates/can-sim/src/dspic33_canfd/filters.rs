//! Acceptance filters (8.0).

use can_frame::Frame;
use dspic33_canfd_pac::{
    enums::{FltObjHExide, MaskHMide},
    registers as pac,
};

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// 8.2.3: data bits that a filter can compare.
const DATA_BITS: u32 = 18;

impl Dspic33CanfdModel {
    pub(super) fn filter_target(&self, filter: u8) -> Option<u8> {
        let slots = &self.arrays.filters[usize::from(filter)];
        self.regs.is_set(slots.enable).then(|| self.regs.field(slots.target) as u8)
    }

    /// An enabled filter points to this FIFO.
    pub(super) fn is_filter_target(&self, number: u8) -> bool {
        (0..32).any(|filter| self.filter_target(filter) == Some(number))
    }

    /// 8.1: a filter was enabled. Its target has to be a FIFO that can take what it accepts.
    pub(super) fn filters_enabled(&mut self, cx: &mut Context<'_>, access: &WriteAccess, first: u8) {
        for filter in [first, first + 1] {
            let enable = self.arrays.filters[usize::from(filter)].enable.bits();
            let changed = access.old != access.new && access.new & enable != 0;
            let Some(number) = self.filter_target(filter).filter(|_| changed) else { continue };
            if number == 0 {
                let what = format!("filter {filter} is enabled and points to FIFO 0, which cannot receive");
                cx.report("8.1", DiagnosticKind::Contradiction { what });
            } else if !self.is_configuration() {
                self.check_section(cx, self.layout.objects[usize::from(number)]);
            }
        }
    }

    /// Figure 8-2: whether a filter matches a frame.
    pub(super) fn filter_matches(&self, filter: u8, frame: &Frame) -> bool {
        let slots = &self.arrays.filters[usize::from(filter)];
        let object = (pac::FltObjL::from_bits(self.word(slots.obj_l)), pac::FltObjH::from_bits(self.word(slots.obj_h)));
        let mask = (pac::MaskL::from_bits(self.word(slots.mask_l)), pac::MaskH::from_bits(self.word(slots.mask_h)));
        let extended = frame.is_extended();
        // 8.2.1.
        let type_matters = mask.1.mide() == MaskHMide::AsExide;
        let wants_extended = object.1.exide() == FltObjHExide::Extended;
        if type_matters && wants_extended != extended {
            return false;
        }
        let object_extension = u32::from(object.0.eid()) | u32::from(object.1.eid()) << 5;
        let mask_extension = u32::from(mask.0.meid()) | u32::from(mask.1.meid()) << 5;
        let raw = frame.raw_id();
        let base = if extended { (raw >> 18) as u16 } else { raw as u16 };
        // 8.2.2: a mask bit of 0 does not matter.
        if (base ^ object.0.sid()) & mask.0.msid() != 0 {
            return false;
        }
        if extended {
            return (raw & 0x3_FFFF ^ object_extension) & mask_extension == 0;
        }
        // 8.2.4.
        let twelve_bits = pac::TdcH::from_bits(self.word(self.r.tdc_h)).sid11en() && frame.is_fd();
        if twelve_bits && mask.1.msid11() && frame.remote_request_substitution() != object.1.sid11() {
            return false;
        }
        // data_filter_with_both_formats.
        let compares = !self.config.choices.data_filter_needs_standard || type_matters;
        !compares || self.data_matches(frame, object_extension, mask_extension)
    }

    /// 8.2.3, table 8-1: the first data bits of a standard frame against EID0, EID1, ...
    fn data_matches(&self, frame: &Frame, object: u32, mask: u32) -> bool {
        let dncnt = match self.con_l().dncnt() {
            Ok(bits) => u32::from(bits.bits()),
            Err(raw) => u32::from(raw),
        };
        let count = dncnt.min(DATA_BITS).min(frame.len() as u32 * 8);
        (0..count).all(|bit| {
            let byte = frame.data_bytes()[bit as usize / 8];
            let data = u32::from(byte >> (7 - bit % 8) & 1);
            (object >> bit ^ data) & mask >> bit & 1 == 0
        })
    }
}
