//! Lines of candump: the log format of `candump -l` and the columns it prints on a screen.

use core::{fmt, str::FromStr};

use crate::{
    CLASSIC_MAX_LEN, Dlc, FD_MAX_LEN, FdFlags, Frame, ParseError, ParseErrorKind,
    hex::{Cursor, digit},
    text::identifier,
};

/// Whether the interface received the frame or sent it itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Received; `R` at the end of a log line, `RX` on the screen.
    Received,
    /// Sent by this host; `T` or `TX`.
    Transmitted,
}

/// One line of a candump log: `(1700000000.123456) can0 123#1122 R`.
///
/// Parsing also takes what `candump` prints on a screen: `can0  123   [2]  11 22`, with or without a timestamp in
/// front. The time is then zero if there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LogLine<'a> {
    /// Time since the epoch of the log, in nanoseconds. Printed in microseconds, rounded down, as candump does.
    pub nanoseconds: u64,
    /// Name of the interface.
    pub interface: &'a str,
    /// The frame.
    pub frame: Frame,
    /// Direction, if the line tells.
    pub direction: Option<Direction>,
}

impl fmt::Display for LogLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let micros = self.nanoseconds / 1_000;
        write!(
            f,
            "({:010}.{:06}) {} {}",
            micros / 1_000_000,
            micros % 1_000_000,
            self.interface,
            self.frame
        )?;
        match self.direction {
            None => Ok(()),
            Some(Direction::Received) => f.write_str(" R"),
            Some(Direction::Transmitted) => f.write_str(" T"),
        }
    }
}

impl<'a> LogLine<'a> {
    /// Reads a line of a log or of candump's screen output.
    ///
    /// # Errors
    /// A [`ParseError`] with the byte offset of what does not fit.
    pub fn parse(line: &'a str) -> Result<LogLine<'a>, ParseError> {
        let line_cursor = &mut Cursor::new(line);
        line_cursor.skip_spaces();
        let nanoseconds = if line_cursor.peek() == Some(b'(') {
            timestamp(line_cursor)?
        } else {
            0
        };
        let interface = line_cursor.word();
        if interface.is_empty() {
            return Err(line_cursor.error(ParseErrorKind::MissingColumn));
        }
        line_cursor.skip_spaces();
        let at = line_cursor.at();
        let word = line_cursor.word();
        let (frame, mut direction) = if word.contains('#') {
            let frame = Frame::from_str(word).map_err(|e| ParseError {
                at: at + e.at,
                kind: e.kind,
            })?;
            (frame, None)
        } else {
            screen_columns(word, at, line_cursor)?
        };
        line_cursor.skip_spaces();
        if direction.is_none() {
            direction = match line_cursor.peek() {
                Some(b'R') => Some(Direction::Received),
                Some(b'T') => Some(Direction::Transmitted),
                _ => None,
            };
            if direction.is_some() {
                line_cursor.word();
                line_cursor.skip_spaces();
            }
        }
        if line_cursor.is_at_end() {
            Ok(LogLine {
                nanoseconds,
                interface,
                frame,
                direction,
            })
        } else {
            Err(line_cursor.error(ParseErrorKind::TrailingText))
        }
    }
}

/// `(seconds.fraction)` with up to nine digits of fraction.
fn timestamp(cursor: &mut Cursor<'_>) -> Result<u64, ParseError> {
    let at = cursor.at();
    let bad = ParseError {
        at,
        kind: ParseErrorKind::BadTimestamp,
    };
    cursor.eat(b'(');
    let decimal = |cursor: &mut Cursor<'_>| match cursor.peek() {
        Some(b'0'..=b'9') => cursor.eat_digit().map(u64::from),
        _ => None,
    };
    let (mut seconds, mut any) = (0u64, false);
    while let Some(value) = decimal(cursor) {
        any = true;
        seconds = seconds
            .checked_mul(10)
            .and_then(|s| s.checked_add(value))
            .ok_or(bad)?;
    }
    let (mut fraction, mut scale) = (0, 1_000_000_000);
    if cursor.eat(b'.') {
        while let Some(value) = decimal(cursor) {
            scale /= 10;
            fraction += value * scale;
        }
    }
    if !any || !cursor.eat(b')') {
        return Err(bad);
    }
    seconds
        .checked_mul(1_000_000_000)
        .and_then(|ns| ns.checked_add(fraction))
        .ok_or(bad)
}

/// The columns after the interface on a screen: `[RX|TX] [B|-] [E|-] ID [n] bytes`.
fn screen_columns(
    first: &str,
    first_at: usize,
    cursor: &mut Cursor<'_>,
) -> Result<(Frame, Option<Direction>), ParseError> {
    let (mut word, mut at) = (first, first_at);
    let (mut direction, mut flags) = (None, FdFlags::default());
    loop {
        match word {
            "RX" => direction = Some(Direction::Received),
            "TX" => direction = Some(Direction::Transmitted),
            "B" => flags.brs = true,
            "E" => flags.esi = true,
            "-" => {}
            "" => return Err(cursor.error(ParseErrorKind::MissingColumn)),
            _ => break,
        }
        cursor.skip_spaces();
        at = cursor.at();
        word = cursor.word();
    }
    let mut id_cursor = Cursor::new(word);
    let id = identifier(&mut id_cursor).map_err(|e| ParseError {
        at: at + e.at,
        kind: e.kind,
    })?;
    if !id_cursor.is_at_end() {
        return Err(ParseError {
            at: at + id_cursor.at(),
            kind: ParseErrorKind::NotHex,
        });
    }
    cursor.skip_spaces();
    let at = cursor.at();
    let (len, is_fd) = bracketed_length(cursor.word()).ok_or(ParseError {
        at,
        kind: ParseErrorKind::BadLength,
    })?;
    cursor.skip_spaces();
    if cursor.peek() == Some(b'r') {
        let remote = cursor.word() == "remote" && cursor.word() == "request";
        let dlc = Dlc::exact(len).filter(|_| remote && !is_fd);
        return match dlc {
            Some(dlc) => Ok((Frame::remote(id, dlc), direction)),
            None => Err(ParseError {
                at,
                kind: ParseErrorKind::BadLength,
            }),
        };
    }
    let mut bytes = [0; FD_MAX_LEN];
    for slot in bytes.iter_mut().take(len) {
        cursor.skip_spaces();
        let at = cursor.at();
        let byte = match cursor.word().as_bytes() {
            [] => {
                return Err(ParseError {
                    at,
                    kind: ParseErrorKind::BadLength,
                });
            }
            &[high, low] => digit(high)
                .zip(digit(low))
                .map(|(high, low)| high << 4 | low),
            &[one] if digit(one).is_some() => {
                return Err(ParseError {
                    at,
                    kind: ParseErrorKind::HalfByte,
                });
            }
            _ => None,
        };
        *slot = byte.ok_or(ParseError {
            at,
            kind: ParseErrorKind::NotHex,
        })?;
    }
    let frame = if is_fd {
        Frame::fd(id, &bytes[..len], flags)
    } else {
        Frame::data(id, &bytes[..len])
    };
    let frame = frame.map_err(|e| ParseError {
        at,
        kind: ParseErrorKind::Frame(e),
    })?;
    Ok((frame, direction))
}

/// `[8]` is a classic length, `[08]` that of an FD frame: candump prints one digit or two.
fn bracketed_length(word: &str) -> Option<(usize, bool)> {
    let inner = word.strip_prefix('[')?.strip_suffix(']')?;
    if !inner.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let (is_fd, max) = match inner.len() {
        1 => (false, CLASSIC_MAX_LEN),
        2 => (true, FD_MAX_LEN),
        _ => return None,
    };
    let len = inner.parse().ok().filter(|len| *len <= max)?;
    Some((len, is_fd))
}
