//! Frames as words of the Message RAM (2.4.2 to 2.4.4).

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Id, StandardId};
use m_can_pac::enums::{DataLengthCode, ErrorState, FrameFormat, FrameKind, IdFormat};

/// 2.4.2: a standard identifier stands in bits 28:18 of the field.
const STANDARD_SHIFT: u32 = 18;

/// The bits of the fields XTD and ID. The bound never acts; it tells the compiler that the value fits the field.
#[inline]
pub(super) fn encode_id(id: Id) -> (IdFormat, u32) {
    match id {
        Id::Standard(id) => (IdFormat::Standard, u32::from(id.as_raw() & StandardId::MAX.as_raw()) << STANDARD_SHIFT),
        Id::Extended(id) => (IdFormat::Extended, id.as_raw() & ExtendedId::MAX.as_raw()),
    }
}

/// The identifier in the fields XTD and ID.
#[inline]
pub(super) fn decode_id(format: IdFormat, bits: u32) -> Id {
    match format {
        IdFormat::Standard => {
            let raw = (bits >> STANDARD_SHIFT) as u16 & StandardId::MAX.as_raw();
            Id::Standard(StandardId::new(raw).unwrap_or(StandardId::ZERO))
        }
        IdFormat::Extended => {
            let raw = bits & ExtendedId::MAX.as_raw();
            Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO))
        }
    }
}

/// The format in the fields FDF, RTR, BRS and ESI. 2.4.2: an FD frame has no RTR bit.
#[inline]
pub(super) const fn decode_format(fdf: FrameFormat, rtr: FrameKind, brs: bool, esi: ErrorState) -> Format {
    match (fdf, rtr) {
        (FrameFormat::Fd, _) => Format::Fd(FdFlags { brs, esi: matches!(esi, ErrorState::ErrorPassive) }),
        (FrameFormat::Classic, FrameKind::Remote) => Format::Remote,
        (FrameFormat::Classic, FrameKind::Data) => Format::Data,
    }
}

/// The data length code in a field.
#[inline]
pub(super) const fn decode_dlc(code: DataLengthCode) -> Dlc {
    Dlc::from_low_bits(code.bits())
}
