//! Frames as message objects (6.1, 7.0, 9.1).

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use dspic33_canfd_pac::{
    enums::{DataLengthCode, DataPhaseRate, ErrorState, FrameFormat, IdentifierFormat},
    messages::{RxObjectR2, TxObjectT0, TxObjectT1, TxObjectT2},
};

/// Bits of the extension of an identifier that stand in the first word.
const LOW_BITS: u32 = 5;
/// The extension of an identifier.
const EXTENSION: u32 = 0x3_FFFF;

/// The first two words of an object. Bits that an identifier does not have are 0; the bounds never act.
#[inline]
pub(super) fn encode_id(frame: &Frame) -> (TxObjectT0, TxObjectT1) {
    let (base, extension) = match frame.id() {
        Id::Standard(id) => (id.as_raw() & StandardId::MAX.as_raw(), 0),
        Id::Extended(id) => {
            let raw = id.as_raw() & ExtendedId::MAX.as_raw();
            ((raw >> 18) as u16, raw & EXTENSION)
        }
    };
    let low = (extension & ((1 << LOW_BITS) - 1)) as u8;
    let t0 = TxObjectT0::ZERO.with_sid(base).with_eid(low);
    let t1 = TxObjectT1::ZERO.with_eid((extension >> LOW_BITS) as u16).with_sid11(frame.remote_request_substitution());
    (t0, t1)
}

/// The control bits of an object, without a sequence number.
#[inline]
pub(super) fn encode_control(frame: &Frame) -> TxObjectT2 {
    let (fd, brs, esi) = (frame.is_fd(), frame.bit_rate_switch(), frame.error_state_indicator());
    TxObjectT2::ZERO
        .with_ide(if frame.is_extended() { IdentifierFormat::Extended } else { IdentifierFormat::Base })
        .with_rtr(frame.is_remote())
        .with_fdf(if fd { FrameFormat::CanFd } else { FrameFormat::Can2_0 })
        .with_brs(if brs { DataPhaseRate::Data } else { DataPhaseRate::Nominal })
        .with_esi(if esi { ErrorState::ErrorPassive } else { ErrorState::ErrorActive })
        .with_dlc(DataLengthCode::from_bits(frame.dlc().code()))
}

/// The identifier in the first two words.
#[inline]
pub(super) fn decode_id(t0: TxObjectT0, t1: TxObjectT1, format: IdentifierFormat) -> Id {
    match format {
        IdentifierFormat::Base => Id::Standard(StandardId::new(t0.sid()).unwrap_or(StandardId::ZERO)),
        IdentifierFormat::Extended => {
            let extension = u32::from(t0.eid()) | u32::from(t1.eid()) << LOW_BITS;
            let raw = u32::from(t0.sid()) << 18 | extension;
            Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO))
        }
    }
}

/// The format in the control bits, which stand in the same place in all objects. 2.0: an FD frame has no RTR bit.
#[inline]
pub(super) fn decode_format(control: RxObjectR2) -> Format {
    match (control.fdf(), control.rtr()) {
        (FrameFormat::CanFd, _) => Format::Fd(FdFlags {
            brs: control.brs() == DataPhaseRate::Data,
            esi: control.esi() == ErrorState::ErrorPassive,
        }),
        (FrameFormat::Can2_0, true) => Format::Remote,
        (FrameFormat::Can2_0, false) => Format::Data,
    }
}

/// The data length code in the control bits.
#[inline]
pub(super) const fn decode_dlc(control: RxObjectR2) -> Dlc {
    Dlc::from_low_bits(control.dlc().bits())
}
