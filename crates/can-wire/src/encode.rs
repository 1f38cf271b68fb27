//! A frame as the bits that travel, without a bus: for checks, for pictures, and to know how long a frame is.
//!
//! The protocol engine does not use this: it makes and takes every bit on its own. That the two agree is tested.

use can_frame::{Frame, Id};

use crate::{Field, Position, crc::Crc, protocol::stuff_count_field};

/// One bit of an encoded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EncodedBit {
    /// Its place.
    pub position: Position,
    /// Its value, `true` for recessive.
    pub bit: bool,
}

/// The bits of a frame from SOF to the last bit of the CRC sequence, and a stuff bit after that if one is due: all that
/// depends on the frame. CRC delimiter, ACK slot and delimiter, 7 bits of EOF and 3 of intermission follow.
///
/// `iso` selects the FD format of ISO 11898-1:2015 with stuff count; it makes no difference for classic frames.
#[must_use]
pub fn encode(frame: &Frame, iso: bool) -> Vec<EncodedBit> {
    let mut encoder = Encoder::new(frame, iso);
    encoder.arbitration_and_control(frame);
    for (index, byte) in frame.data_bytes().iter().enumerate() {
        for bit in 0..8 {
            encoder.push(Position::new(Field::Data, index as u16 * 8 + bit), byte >> (7 - bit) & 1 == 1);
        }
    }
    if frame.is_fd() {
        encoder.fd_check(frame.len(), iso);
    } else {
        encoder.classic_check();
    }
    encoder.bits
}

struct Encoder {
    bits: Vec<EncodedBit>,
    run: u8,
    last: bool,
    stuff_bits: u8,
    crc15: Crc,
    crc17: Crc,
    crc21: Crc,
}

impl Encoder {
    fn new(frame: &Frame, iso: bool) -> Encoder {
        Encoder {
            bits: Vec::with_capacity(64 + frame.len() * 10),
            run: 0,
            last: true,
            stuff_bits: 0,
            crc15: Crc::crc15(),
            crc17: Crc::crc17(iso),
            crc21: Crc::crc21(iso),
        }
    }

    /// A bit of the dynamically stuffed part, with the stuff bit that may be due before it.
    fn push(&mut self, position: Position, bit: bool) {
        self.stuff(position);
        self.crc15.push(bit);
        self.place(position, bit);
    }

    fn stuff(&mut self, before: Position) {
        if self.run == 5 {
            self.stuff_bits += 1;
            self.run = 0;
            self.place(Position::stuff_before(before.field, before.bit), !self.last);
        }
    }

    fn place(&mut self, position: Position, bit: bool) {
        self.crc17.push(bit);
        self.crc21.push(bit);
        self.bits.push(EncodedBit { position, bit });
        self.run = if bit == self.last && self.run > 0 { self.run + 1 } else { 1 };
        self.last = bit;
    }

    fn number(&mut self, field: Field, value: u32, width: u32) {
        for bit in 0..width {
            self.push(Position::new(field, bit as u16), value >> (width - 1 - bit) & 1 == 1);
        }
    }

    fn arbitration_and_control(&mut self, frame: &Frame) {
        self.number(Field::Sof, 0, 1);
        let remote = u32::from(frame.is_remote() || frame.remote_request_substitution());
        let fd = frame.is_fd();
        match frame.id() {
            Id::Standard(id) => {
                self.number(Field::BaseId, u32::from(id.as_raw()), 11);
                self.number(Field::Rtr, remote, 1);
                self.number(Field::Ide, 0, 1);
                self.number(Field::Fdf, u32::from(fd), 1);
            }
            Id::Extended(id) => {
                self.number(Field::BaseId, id.as_raw() >> 18, 11);
                self.number(Field::Rtr, 1, 1);
                self.number(Field::Ide, 1, 1);
                self.number(Field::ExtendedId, id.as_raw() & 0x3_FFFF, 18);
                self.number(Field::ExtendedRtr, remote, 1);
                self.number(Field::Fdf, u32::from(fd), 1);
                if !fd {
                    self.number(Field::Res, 0, 1);
                }
            }
        }
        if fd {
            self.number(Field::Res, 0, 1);
            self.number(Field::Brs, u32::from(frame.bit_rate_switch()), 1);
            self.number(Field::Esi, u32::from(frame.error_state_indicator()), 1);
        }
        self.number(Field::Dlc, u32::from(frame.dlc().code()), 4);
    }

    fn classic_check(&mut self) {
        let sequence = self.crc15.value();
        self.number(Field::Crc, sequence, 15);
        self.stuff(Position::new(Field::CrcDelimiter, 0));
    }

    /// Stuff count and CRC with a fixed stuff bit before every four bits.
    fn fd_check(&mut self, len: usize, iso: bool) {
        let mut crc = if len <= 16 { self.crc17 } else { self.crc21 };
        let count = stuff_count_field(self.stuff_bits);
        if iso {
            self.fixed(Field::StuffCount, 0);
            for bit in 0..4 {
                let value = count >> (3 - bit) & 1 == 1;
                crc.push(value);
                self.plain(Position::new(Field::StuffCount, bit), value);
            }
        }
        let width = crc.width();
        for bit in 0..width {
            if bit.is_multiple_of(4) {
                self.fixed(Field::Crc, bit as u16);
            }
            self.plain(Position::new(Field::Crc, bit as u16), crc.value() >> (width - 1 - bit) & 1 == 1);
        }
    }

    fn fixed(&mut self, field: Field, before: u16) {
        self.plain(Position::stuff_before(field, before), !self.last);
    }

    fn plain(&mut self, position: Position, bit: bool) {
        self.bits.push(EncodedBit { position, bit });
        self.last = bit;
    }
}

/// Where the bits lie that timing depends on: indices of bits on the bus, SOF being 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// The bit after FDF, for FD frames.
    pub(crate) res: Option<u64>,
    /// BRS, for FD frames that switch the bit rate.
    pub(crate) brs: Option<u64>,
    /// The CRC delimiter.
    pub(crate) crc_delimiter: u64,
}

/// What a byte does to the state of the stuffing: how many stuff bits it gets, and the state after it.
#[derive(Clone, Copy)]
struct Stuffed {
    bits: u8,
    state: u8,
}

/// The state is the run of equal bits, 1 to 5, times two, plus the level of the run.
const STATES: usize = 12;

const fn stuff_bit(state: u8, bit: bool) -> Stuffed {
    let (mut run, mut level) = (state >> 1, state & 1 == 1);
    let mut bits = 0;
    if run == 5 {
        bits = 1;
        run = 1;
        level = !level;
    }
    if run > 0 && bit == level {
        run += 1;
    } else {
        run = 1;
        level = bit;
    }
    Stuffed { bits, state: run << 1 | level as u8 }
}

static STUFFING: [[Stuffed; 256]; STATES] = {
    let mut table = [[Stuffed { bits: 0, state: 0 }; 256]; STATES];
    let mut state = 0;
    while state < STATES {
        let mut byte = 0;
        while byte < 256 {
            let mut entry = Stuffed { bits: 0, state: state as u8 };
            let mut bit = 0;
            while bit < 8 {
                let next = stuff_bit(entry.state, byte >> (7 - bit) & 1 == 1);
                entry = Stuffed { bits: entry.bits + next.bits, state: next.state };
                bit += 1;
            }
            table[state][byte] = entry;
            byte += 1;
        }
        state += 1;
    }
    table
};

static CRC15: [u16; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut crc = Crc::crc15();
        let mut bit = 0;
        while bit < 8 {
            crc.push(byte >> (7 - bit) & 1 == 1);
            bit += 1;
        }
        table[byte] = crc.value() as u16;
        byte += 1;
    }
    table
};

/// Counts stuff bits without making them.
struct Counter {
    state: u8,
    bits: u64,
}

impl Counter {
    fn byte(&mut self, byte: u8) {
        let entry = STUFFING[usize::from(self.state)][usize::from(byte)];
        self.bits += 8 + u64::from(entry.bits);
        self.state = entry.state;
    }

    fn number(&mut self, value: u64, width: u32) {
        let mut left = width;
        while left >= 8 {
            left -= 8;
            self.byte((value >> left) as u8);
        }
        while left > 0 {
            left -= 1;
            let next = stuff_bit(self.state, value >> left & 1 == 1);
            self.bits += 1 + u64::from(next.bits);
            self.state = next.state;
        }
    }
}

fn crc15(mut crc: u16, byte: u8) -> u16 {
    let index = (crc >> 7) as u8 ^ byte;
    crc = crc << 8 & 0x7FFF;
    crc ^ CRC15[usize::from(index)]
}

/// The layout of a frame, several times faster than encoding it.
pub(crate) fn layout(frame: &Frame, iso: bool) -> Layout {
    let mut counter = Counter { state: 0, bits: 0 };
    let raw = u64::from(frame.raw_id());
    let remote = u64::from(frame.is_remote() || frame.remote_request_substitution());
    let fd = frame.is_fd();
    // SOF to FDF, then the control field, as numbers.
    let (arbitration, width) = if frame.is_extended() {
        let (base, extension) = (raw >> 18, raw & 0x3_FFFF);
        ((base << 20 | 0b11 << 18 | extension) << 2 | remote << 1 | u64::from(fd), 34)
    } else {
        (raw << 3 | remote << 2 | u64::from(fd), 15)
    };
    let code = u64::from(frame.dlc().code());
    if fd {
        counter.number(arbitration << 1, width + 1);
        let res = counter.bits - 1;
        counter.number(u64::from(frame.bit_rate_switch()), 1);
        let brs = counter.bits - 1;
        counter.number(u64::from(frame.error_state_indicator()) << 4 | code, 5);
        for byte in frame.data_bytes() {
            counter.byte(*byte);
        }
        let crc = if frame.len() <= 16 { 17 } else { 21 };
        let checked = if iso { crc + 4 } else { crc };
        return Layout {
            res: Some(res),
            brs: frame.bit_rate_switch().then_some(brs),
            crc_delimiter: counter.bits + checked + checked.div_ceil(4),
        };
    }
    // A frame with extended identifier has one more reserved bit.
    let control_width = if frame.is_extended() { 5 } else { 4 };
    let (header, header_width) = (arbitration << control_width | code, width + control_width);
    counter.number(header, header_width);
    // The register starts at zero, so leading zeros that fill up the first byte change nothing.
    let mut crc = 0;
    let bytes = header.to_be_bytes();
    for byte in &bytes[8 - (header_width as usize).div_ceil(8)..] {
        crc = crc15(crc, *byte);
    }
    for byte in frame.data_bytes() {
        counter.byte(*byte);
        crc = crc15(crc, *byte);
    }
    counter.number(u64::from(crc), 15);
    let after = u64::from(counter.state >> 1 == 5);
    Layout { res: None, brs: None, crc_delimiter: counter.bits + after }
}

#[cfg(test)]
mod tests {
    use super::*;
    use can_frame::{Dlc, ExtendedId, FdFlags, Format, StandardId};

    #[test]
    fn the_layout_agrees_with_the_bits() {
        let mut state = 1u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 32
        };
        for round in 0..20_000 {
            let raw = if next() % 4 == 0 { 0 } else { next() as u32 & 0x1FFF_FFFF };
            let id = if next() % 2 == 0 {
                Id::Standard(StandardId::new((raw & 0x7FF) as u16).expect("11 bits"))
            } else {
                Id::Extended(ExtendedId::new(raw).expect("29 bits"))
            };
            let format = match next() % 4 {
                0 => Format::Remote,
                1 => Format::Data,
                _ => Format::Fd(FdFlags { brs: next() % 2 == 0, esi: next() % 2 == 0 }),
            };
            let constant = next() as u8;
            let bytes: [u8; 64] = core::array::from_fn(|_| match round % 3 {
                0 => constant,
                1 => 0,
                _ => next() as u8,
            });
            let frame = Frame::from_fields(id, format, Dlc::from_low_bits(next() as u8), &bytes);
            let iso = next() % 2 == 0;
            let bits = encode(&frame, iso);
            let place = |field| bits.iter().position(|bit| bit.position == Position::new(field, 0)).map(|at| at as u64);
            let expected = Layout {
                res: frame.is_fd().then(|| place(Field::Res)).flatten(),
                brs: frame.bit_rate_switch().then(|| place(Field::Brs)).flatten(),
                crc_delimiter: bits.len() as u64,
            };
            assert_eq!(layout(&frame, iso), expected, "{frame}");
        }
    }
}
