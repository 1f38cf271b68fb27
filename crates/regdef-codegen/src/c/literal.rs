//! Types and constants of fixed width.
//!
//! Up to 16 bits an `unsigned int` constant is right on every compiler, also where `int` has 16 bits; what is
//! wider goes through `UINT32_C`.

/// The unsigned type of a width in bits.
pub(super) const fn ctype(width: u32) -> &'static str {
    match width {
        0..=8 => "uint8_t",
        9..=16 => "uint16_t",
        17..=32 => "uint32_t",
        _ => "uint64_t",
    }
}

/// A constant in hexadecimal with all digits of the width.
pub(super) fn hex(value: u64, width: u32) -> String {
    match width {
        0..=8 => format!("0x{value:02X}U"),
        9..=16 => format!("0x{value:04X}U"),
        17..=32 => format!("UINT32_C(0x{value:08X})"),
        _ => format!("UINT64_C(0x{value:016X})"),
    }
}

/// A constant in decimal.
pub(super) fn decimal(value: u64, width: u32) -> String {
    match (width, value) {
        (..=16, _) | (_, ..=0xFFFF) => format!("{value}U"),
        (17..=32, _) => format!("UINT32_C({value})"),
        _ => format!("UINT64_C({value})"),
    }
}

/// A byte offset.
pub(super) fn offset(value: u64) -> String {
    if value <= 0xFFFF { format!("0x{value:03X}U") } else { format!("UINT32_C(0x{value:X})") }
}
