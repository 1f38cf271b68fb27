//! Acceptance filters and masks, message types, data bits (9.1.2, 9.1.3, 9.5).

use can_frame::{Frame, Id};
use dspic33_ecan_pac::{
    enums::{FilterTarget, IdentifierFormat, MaskSource, RxmSidMide},
    registers as pac,
};

use super::EcanModel;

/// Bits of the identifier below the standard identifier.
const EID_BITS: u32 = 18;

/// An acceptance filter or mask as one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Pattern {
    sid: u16,
    /// EID[17:0].
    eid: u32,
}

impl Pattern {
    /// True if nothing differs where the mask compares (Table 9-2).
    const fn accepts(self, mask: Self, sid: u16, eid: u32) -> bool {
        (self.sid ^ sid) & mask.sid == 0 && (self.eid ^ eid) & mask.eid == 0
    }
}

impl EcanModel {
    /// Bit per filter: FLTEN.
    pub(super) fn enabled_filters(&self) -> u16 {
        self.regs.get(self.n.fen1) as u16
    }

    /// 9.2.1: where a filter points.
    pub(super) fn target(&self, filter: u8) -> FilterTarget {
        let pointers = pac::BufPnt::from_bits(self.regs.get(self.n.bufpnt[usize::from(filter / 4)]) as u16);
        pointers.fbp(usize::from(filter % 4))
    }

    /// Table 9-1.
    pub(super) fn mask_source(&self, filter: u8) -> Result<MaskSource, u8> {
        let sources = pac::FmskSel::from_bits(self.regs.get(self.n.fmsksel[usize::from(filter / 8)]) as u16);
        sources.fmsk(usize::from(filter % 8))
    }

    /// Whether a message matches a filter. remote_frame_acceptance: its type plays no part.
    pub(super) fn matches(&self, filter: u8, frame: &Frame) -> bool {
        let n = usize::from(filter);
        let sid = pac::RxfSid::from_bits(self.regs.get(self.n.rxfsid[n]) as u16);
        let eid = pac::RxfEid::from_bits(self.regs.get(self.n.rxfeid[n]) as u16);
        let pattern = Pattern { sid: sid.sid(), eid: u32::from(sid.eid()) << 16 | u32::from(eid.eid()) };
        let Ok(source) = self.mask_source(filter) else {
            // mask_code_3: all bits count, and only standard messages match.
            return matches!(frame.id(), Id::Standard(id) if id.as_raw() == pattern.sid);
        };
        let m = usize::from(source.bits());
        let mask_sid = pac::RxmSid::from_bits(self.regs.get(self.n.rxmsid[m]) as u16);
        let mask_eid = pac::RxmEid::from_bits(self.regs.get(self.n.rxmeid[m]) as u16);
        let mask = Pattern { sid: mask_sid.sid(), eid: u32::from(mask_sid.eid()) << 16 | u32::from(mask_eid.eid()) };
        let by_format = mask_sid.mide() == RxmSidMide::ByExide;
        match frame.id() {
            Id::Standard(id) => {
                if by_format && sid.exide() == IdentifierFormat::Extended {
                    return false;
                }
                // Table 9-3: a standard message is compared in SID only.
                let bits = if by_format { self.data_bits(frame) } else { 0 };
                let compared =
                    mask_of_data(bits) & if self.config.choices.devicenet_masked { mask.eid } else { u32::MAX };
                let mask = Pattern { sid: mask.sid, eid: compared };
                pattern.accepts(mask, id.as_raw(), first_data_bits(frame))
            }
            Id::Extended(id) => {
                if by_format && sid.exide() == IdentifierFormat::Standard {
                    return false;
                }
                let id = id.as_raw();
                pattern.accepts(mask, (id >> EID_BITS) as u16, id & ((1 << EID_BITS) - 1))
            }
        }
    }

    /// 9.5.1, 9.5.2: how many data bits are compared. Values above 18 compare 18 (`dncnt_above_18`); a message with
    /// fewer data bits is compared as far as they go.
    fn data_bits(&self, frame: &Frame) -> u32 {
        let wanted = match pac::Ctrl2::from_bits(self.regs.get(self.n.ctrl2) as u16).dncnt() {
            Ok(count) => u32::from(count.bits()),
            Err(_) => EID_BITS,
        };
        wanted.min(EID_BITS).min(8 * frame.data_bytes().len() as u32)
    }
}

/// Table 9-5: bit 7 of byte 0 stands against EID[17].
fn first_data_bits(frame: &Frame) -> u32 {
    let byte = |n: usize| u32::from(frame.data_bytes().get(n).copied().unwrap_or(0));
    (byte(0) << 16 | byte(1) << 8 | byte(2)) >> (24 - EID_BITS)
}

/// Mask of so many data bits.
const fn mask_of_data(bits: u32) -> u32 {
    ((1 << bits) - 1) << (EID_BITS - bits)
}
