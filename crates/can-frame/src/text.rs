//! The notation of `candump -L` and `cansend`: `123#DEADBEEF`, `123#R4`, `12345678##3...`.

use core::{fmt, str::FromStr};

use embedded_can::{ExtendedId, Id, StandardId};

use crate::{
    CLASSIC_MAX_LEN, Dlc, FD_MAX_LEN, FdFlags, Format, Frame, ParseError, ParseErrorKind,
    hex::Cursor,
};

const FLAG_BRS: u8 = 0b01;
const FLAG_ESI: u8 = 0b10;
/// Bit 2 only repeats that the frame is an FD frame; newer tools print it.
const FLAG_FDF: u8 = 0b100;
const ERROR_MESSAGE: u32 = 1 << 29;

impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.id() {
            Id::Standard(id) => write!(f, "{:03X}#", id.as_raw())?,
            Id::Extended(id) => write!(f, "{:08X}#", id.as_raw())?,
        }
        match self.format() {
            Format::Remote => {
                f.write_str("R")?;
                if self.dlc() != Dlc::ZERO {
                    write!(f, "{:X}", self.dlc().classic_len())?;
                }
            }
            Format::Data => {}
            Format::Fd(flags) => {
                let bits =
                    if flags.brs { FLAG_BRS } else { 0 } | if flags.esi { FLAG_ESI } else { 0 };
                write!(f, "#{bits:X}")?;
            }
        }
        for byte in self.data_bytes() {
            write!(f, "{byte:02X}")?;
        }
        // A classic frame of eight bytes may carry the codes 9 to 15; the suffix keeps them.
        if !self.is_fd() && usize::from(self.dlc().code()) > CLASSIC_MAX_LEN {
            write!(f, "_{:X}", self.dlc().code())?;
        }
        Ok(())
    }
}

impl FromStr for Frame {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Frame, ParseError> {
        let mut cursor = Cursor::new(text);
        let frame = frame(&mut cursor)?;
        if cursor.is_at_end() {
            Ok(frame)
        } else {
            Err(cursor.error(ParseErrorKind::TrailingText))
        }
    }
}

/// Reads the identifier digits up to the first other character.
pub(crate) fn identifier(cursor: &mut Cursor<'_>) -> Result<Id, ParseError> {
    let start = cursor.at();
    let mut value = 0u32;
    let mut digits = 0;
    while let Some(digit) = cursor.eat_digit() {
        digits += 1;
        if digits > 8 {
            break;
        }
        value = value << 4 | u32::from(digit);
    }
    let error = |kind| ParseError { at: start, kind };
    match digits {
        3 => u16::try_from(value)
            .ok()
            .and_then(StandardId::new)
            .map(Id::Standard)
            .ok_or_else(|| error(ParseErrorKind::IdRange { id: value })),
        8 if value & ERROR_MESSAGE != 0 => Err(error(ParseErrorKind::ErrorMessage)),
        8 => ExtendedId::new(value)
            .map(Id::Extended)
            .ok_or_else(|| error(ParseErrorKind::IdRange { id: value })),
        found => Err(error(ParseErrorKind::IdDigits { found })),
    }
}

fn frame(cursor: &mut Cursor<'_>) -> Result<Frame, ParseError> {
    let id = identifier(cursor)?;
    if !cursor.eat(b'#') {
        return Err(cursor.error(ParseErrorKind::MissingSeparator));
    }
    if cursor.eat(b'#') {
        let flags = cursor
            .eat_digit()
            .ok_or_else(|| cursor.error(ParseErrorKind::MissingFdFlags))?;
        if flags & !(FLAG_BRS | FLAG_ESI | FLAG_FDF) != 0 {
            return Err(ParseError {
                at: cursor.at() - 1,
                kind: ParseErrorKind::MissingFdFlags,
            });
        }
        let start = cursor.at();
        let mut bytes = [0; FD_MAX_LEN];
        let len = data(cursor, &mut bytes)?;
        let flags = FdFlags {
            brs: flags & FLAG_BRS != 0,
            esi: flags & FLAG_ESI != 0,
        };
        return Frame::fd(id, &bytes[..len], flags).map_err(|e| ParseError {
            at: start,
            kind: ParseErrorKind::Frame(e),
        });
    }
    if cursor.eat(b'R') || cursor.eat(b'r') {
        let code = match cursor.peek() {
            Some(b'0'..=b'8') => cursor.eat_digit().unwrap_or(0),
            Some(b'_') | None => 0,
            Some(byte) if byte.is_ascii_whitespace() => 0,
            Some(_) => return Err(cursor.error(ParseErrorKind::BadDlc)),
        };
        let code = raw_dlc(cursor, code)?;
        return Ok(Frame::remote(id, code));
    }
    let start = cursor.at();
    let mut bytes = [0; CLASSIC_MAX_LEN];
    let len = data(cursor, &mut bytes)?;
    let dlc = raw_dlc(cursor, len as u8)?;
    Frame::data_with_dlc(id, dlc, &bytes[..len]).map_err(|e| ParseError {
        at: start,
        kind: ParseErrorKind::Frame(e),
    })
}

/// The suffix `_9` to `_F`: the code on the bus when the length is eight.
fn raw_dlc(cursor: &mut Cursor<'_>, len: u8) -> Result<Dlc, ParseError> {
    let mut code = len;
    if cursor.peek() == Some(b'_') {
        let at = cursor.at();
        cursor.eat(b'_');
        code = match cursor.eat_digit() {
            Some(digit)
                if usize::from(digit) > CLASSIC_MAX_LEN && usize::from(len) == CLASSIC_MAX_LEN =>
            {
                digit
            }
            _ => {
                return Err(ParseError {
                    at,
                    kind: ParseErrorKind::BadDlc,
                });
            }
        };
    }
    Ok(Dlc::from_low_bits(code))
}

/// Data bytes, two digits each, optionally separated by dots as `cansend` allows.
fn data(cursor: &mut Cursor<'_>, bytes: &mut [u8]) -> Result<usize, ParseError> {
    let mut len = 0;
    loop {
        match cursor.peek() {
            None | Some(b'_') => return Ok(len),
            Some(byte) if byte.is_ascii_whitespace() => return Ok(len),
            Some(b'.') if len > 0 => {
                cursor.eat(b'.');
            }
            Some(_) => {}
        }
        let at = cursor.at();
        let high = cursor
            .eat_digit()
            .ok_or_else(|| cursor.error(ParseErrorKind::NotHex))?;
        let low = cursor.eat_digit().ok_or(ParseError {
            at,
            kind: ParseErrorKind::HalfByte,
        })?;
        let Some(slot) = bytes.get_mut(len) else {
            let error = crate::FrameError::TooLong {
                len: len + 1,
                max: bytes.len(),
            };
            return Err(ParseError {
                at,
                kind: ParseErrorKind::Frame(error),
            });
        };
        *slot = high << 4 | low;
        len += 1;
    }
}
