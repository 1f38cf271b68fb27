//! What can be wrong with a frame or with its text.

use core::fmt;

/// Why a frame cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FrameError {
    /// More data bytes than the frame format carries.
    TooLong {
        /// Bytes given.
        len: usize,
        /// Bytes the format carries: 8 for a classic frame, 64 for an FD frame.
        max: usize,
    },
    /// No data length code stands for this number of bytes; an FD frame must be padded to `next`.
    NotAnFdLength {
        /// Bytes given.
        len: usize,
        /// The next length that has a code.
        next: usize,
    },
    /// A data length code that contradicts the number of data bytes.
    DlcMismatch {
        /// The code given.
        code: u8,
        /// Bytes given.
        len: usize,
        /// Bytes the code stands for.
        expected: usize,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            FrameError::TooLong { len, max } => write!(
                f,
                "{len} data bytes, but this frame format carries at most {max}"
            ),
            FrameError::NotAnFdLength { len, next } => {
                write!(
                    f,
                    "no data length code stands for {len} bytes; pad the data to {next}"
                )
            }
            FrameError::DlcMismatch {
                code,
                len,
                expected,
            } => {
                write!(
                    f,
                    "data length code {code} stands for {expected} bytes, but {len} were given"
                )
            }
        }
    }
}

impl core::error::Error for FrameError {}

/// Why a text is not a frame, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Byte offset into the text that was given.
    pub at: usize,
    /// What is wrong there.
    pub kind: ParseErrorKind,
}

/// What is wrong with a text that should be a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseErrorKind {
    /// The `#` between identifier and data is missing.
    MissingSeparator,
    /// An identifier is three hexadecimal digits (11 bits) or eight (29 bits).
    IdDigits {
        /// Digits found.
        found: usize,
    },
    /// The identifier does not fit its 11 or 29 bits.
    IdRange {
        /// The value found.
        id: u32,
    },
    /// The identifier carries candump's error-message flag (bit 29); such a line is not a frame of the bus.
    ErrorMessage,
    /// Something that is not a hexadecimal digit.
    NotHex,
    /// A data byte has only one digit.
    HalfByte,
    /// The data length code after `R` or `_` is not a digit that is allowed there.
    BadDlc,
    /// The FD flags digit after `##` is missing.
    MissingFdFlags,
    /// The timestamp is not `(seconds.fraction)`.
    BadTimestamp,
    /// A column of a log line is missing.
    MissingColumn,
    /// The number in square brackets is no length, or not the number of bytes that follow.
    BadLength,
    /// Text is left over after the frame.
    TrailingText,
    /// The parts are well formed, but such a frame does not exist.
    Frame(FrameError),
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at byte {}: ", self.at)?;
        match self.kind {
            ParseErrorKind::MissingSeparator => {
                f.write_str("expected '#' between identifier and data")
            }
            ParseErrorKind::IdDigits { found } => {
                write!(
                    f,
                    "expected an identifier of 3 or 8 hexadecimal digits, found {found}"
                )
            }
            ParseErrorKind::IdRange { id } => {
                write!(f, "identifier {id:#x} does not fit its 11 or 29 bits")
            }
            ParseErrorKind::ErrorMessage => {
                f.write_str("an error message of the interface, not a frame of the bus")
            }
            ParseErrorKind::NotHex => f.write_str("expected a hexadecimal digit"),
            ParseErrorKind::HalfByte => f.write_str("a data byte has two hexadecimal digits"),
            ParseErrorKind::BadDlc => {
                f.write_str("expected a data length code: 0 to 8 after 'R', 9 to F after '_'")
            }
            ParseErrorKind::MissingFdFlags => {
                f.write_str("expected the flags digit of an FD frame after '##'")
            }
            ParseErrorKind::BadTimestamp => {
                f.write_str("expected a timestamp such as (1700000000.123456)")
            }
            ParseErrorKind::MissingColumn => f.write_str("expected another column"),
            ParseErrorKind::BadLength => {
                f.write_str("the length in brackets does not match the data")
            }
            ParseErrorKind::TrailingText => f.write_str("unexpected text after the frame"),
            ParseErrorKind::Frame(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ParseError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match &self.kind {
            ParseErrorKind::Frame(error) => Some(error),
            _ => None,
        }
    }
}
