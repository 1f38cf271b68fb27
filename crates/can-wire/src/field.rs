//! The places of a frame, with the names of ISO 11898-1:2015.

use core::fmt;

/// A field of a frame, or the state of a node between frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// The node takes no part in the traffic.
    Off,
    /// Bus off: waits for the request to recover, or recovers.
    BusOff,
    /// Bus integration: waits for 11 consecutive recessive bits.
    Integration,
    /// Bus idle.
    Idle,
    /// Start of frame.
    Sof,
    /// The 11 bits of a base identifier, or the upper 11 of an extended one.
    BaseId,
    /// The bit after the base identifier: RTR, or RRS of an FD frame, or SRR of a frame with extended identifier.
    Rtr,
    /// Identifier extension.
    Ide,
    /// The lower 18 bits of an extended identifier.
    ExtendedId,
    /// RTR, or RRS of an FD frame, after an extended identifier.
    ExtendedRtr,
    /// FD format indicator; the reserved bit of earlier classic frames.
    Fdf,
    /// The reserved bit after FDF: `res` of an FD frame, `r0` of a classic frame with extended identifier.
    Res,
    /// Bit-rate switch.
    Brs,
    /// Error state indicator.
    Esi,
    /// Data length code, 4 bits.
    Dlc,
    /// Data field.
    Data,
    /// Stuff count of an ISO FD frame: three bits of Gray code and a parity bit.
    StuffCount,
    /// CRC sequence: 15, 17 or 21 bits.
    Crc,
    /// CRC delimiter.
    CrcDelimiter,
    /// ACK slot.
    AckSlot,
    /// ACK delimiter.
    AckDelimiter,
    /// End of frame, 7 bits.
    Eof,
    /// Intermission, 3 bits.
    Intermission,
    /// Suspend transmission, 8 bits.
    Suspend,
    /// Error flag, active or passive.
    ErrorFlag,
    /// Error delimiter; its index 0 is the wait for the first recessive bit after the flag.
    ErrorDelimiter,
    /// Overload flag.
    OverloadFlag,
    /// Overload delimiter; its index 0 is the wait for the first recessive bit after the flag.
    OverloadDelimiter,
}

impl Field {
    /// True inside a data or remote frame, SOF to EOF.
    #[must_use]
    pub const fn is_in_frame(self) -> bool {
        (self as u8) >= (Field::Sof as u8) && (self as u8) <= (Field::Eof as u8)
    }

    /// True where a recessive bit may lose against a dominant one: identifier, RTR, SRR, IDE.
    #[must_use]
    pub const fn is_arbitration(self) -> bool {
        (self as u8) >= (Field::BaseId as u8) && (self as u8) <= (Field::ExtendedRtr as u8)
    }

    /// A short name for a column or a picture.
    #[must_use]
    pub const fn short_name(self) -> &'static str {
        match self {
            Field::Off => "off",
            Field::BusOff => "bus-off",
            Field::Integration => "integr",
            Field::Idle => "idle",
            Field::Sof => "SOF",
            Field::BaseId => "ID",
            Field::Rtr => "RTR",
            Field::Ide => "IDE",
            Field::ExtendedId => "ID-ext",
            Field::ExtendedRtr => "RTR",
            Field::Fdf => "FDF",
            Field::Res => "res",
            Field::Brs => "BRS",
            Field::Esi => "ESI",
            Field::Dlc => "DLC",
            Field::Data => "data",
            Field::StuffCount => "stuff cnt",
            Field::Crc => "CRC",
            Field::CrcDelimiter => "CRC del",
            Field::AckSlot => "ACK",
            Field::AckDelimiter => "ACK del",
            Field::Eof => "EOF",
            Field::Intermission => "interm",
            Field::Suspend => "suspend",
            Field::ErrorFlag => "error flag",
            Field::ErrorDelimiter => "error del",
            Field::OverloadFlag => "overload flag",
            Field::OverloadDelimiter => "overload del",
        }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.short_name())
    }
}

/// One bit of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// The field.
    pub field: Field,
    /// Index of the bit within the field, 0 for the first on the bus. For a stuff bit: the index of the bit it comes
    /// before.
    pub bit: u16,
    /// True for a stuff bit, dynamic or fixed.
    pub stuff: bool,
}

impl Position {
    /// A bit of a field that is no stuff bit.
    #[must_use]
    pub const fn new(field: Field, bit: u16) -> Position {
        Position {
            field,
            bit,
            stuff: false,
        }
    }

    /// The stuff bit before a bit of a field.
    #[must_use]
    pub const fn stuff_before(field: Field, bit: u16) -> Position {
        Position {
            field,
            bit,
            stuff: true,
        }
    }
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stuff = if self.stuff { "stuff bit before " } else { "" };
        write!(f, "{stuff}{} bit {}", self.field, self.bit)
    }
}
