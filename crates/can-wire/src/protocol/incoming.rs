//! The frame as it is being decoded, and the checks that run along.

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};

use crate::crc::Crc;

/// What has been decoded of a frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Incoming {
    pub(crate) base_id: u16,
    pub(crate) extension: u32,
    pub(crate) extended: bool,
    pub(crate) remote: bool,
    /// Of an FD frame.
    pub(crate) rrs: bool,
    pub(crate) fd: bool,
    pub(crate) brs: bool,
    pub(crate) esi: bool,
    pub(crate) dlc: u8,
    pub(crate) dlc_known: bool,
    /// Data bytes according to the length code.
    pub(crate) len: u8,
    /// Complete data bytes so far.
    pub(crate) bytes: u8,
    pub(crate) data: [u8; 64],
    byte: u8,
}

impl Incoming {
    pub(crate) const fn new() -> Incoming {
        Incoming {
            base_id: 0,
            extension: 0,
            extended: false,
            remote: false,
            rrs: false,
            fd: false,
            brs: false,
            esi: false,
            dlc: 0,
            dlc_known: false,
            len: 0,
            bytes: 0,
            data: [0; 64],
            byte: 0,
        }
    }

    /// The state after a whole frame has been decoded.
    pub(crate) fn of(frame: &Frame) -> Incoming {
        let raw = frame.raw_id();
        let mut incoming = Incoming {
            base_id: if frame.is_extended() { raw >> 18 } else { raw } as u16,
            extension: if frame.is_extended() { raw & 0x3_FFFF } else { 0 },
            extended: frame.is_extended(),
            remote: frame.is_remote(),
            rrs: frame.remote_request_substitution(),
            fd: frame.is_fd(),
            brs: frame.bit_rate_switch(),
            esi: frame.error_state_indicator(),
            dlc: frame.dlc().code(),
            dlc_known: true,
            len: frame.len() as u8,
            bytes: frame.len() as u8,
            ..Incoming::new()
        };
        incoming.data[..frame.len()].copy_from_slice(frame.data_bytes());
        incoming
    }

    /// Ready for the next frame; old data bytes need no clearing, `bytes` says which are valid.
    pub(crate) fn restart(&mut self) {
        let data = self.data;
        *self = Incoming { data, ..Incoming::new() };
    }

    /// The length code is complete: how many data bytes follow.
    pub(crate) fn close_dlc(&mut self) {
        let dlc = Dlc::from_low_bits(self.dlc);
        self.dlc_known = true;
        self.len = match (self.fd, self.remote) {
            (true, _) => dlc.fd_len(),
            (false, true) => 0,
            (false, false) => dlc.classic_len(),
        } as u8;
    }

    /// The next bit of the data field, most significant first.
    #[inline]
    pub(crate) fn push_data(&mut self, bit: bool, index: u16) {
        self.byte = self.byte << 1 | u8::from(bit);
        if index % 8 == 7 {
            self.data[usize::from(self.bytes)] = self.byte;
            self.bytes += 1;
        }
    }

    pub(crate) fn frame(&self) -> Frame {
        let base = self.base_id & 0x7FF;
        let id = if self.extended {
            let raw = u32::from(base) << 18 | self.extension & 0x3_FFFF;
            ExtendedId::new(raw).map_or(Id::Extended(ExtendedId::ZERO), Id::Extended)
        } else {
            StandardId::new(base).map_or(Id::Standard(StandardId::ZERO), Id::Standard)
        };
        let format = match (self.fd, self.remote) {
            (true, _) => Format::Fd(FdFlags { brs: self.brs, esi: self.esi }),
            (false, true) => Format::Remote,
            (false, false) => Format::Data,
        };
        Frame::from_fields(id, format, Dlc::from_low_bits(self.dlc), &self.data[..usize::from(self.bytes)])
            .with_remote_request_substitution(self.rrs)
    }
}

/// The CRC registers and the stuff counter. Until FDF is known all three polynomials have to run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Checks {
    crc15: Crc,
    crc17: Crc,
    crc21: Crc,
    classic: bool,
    short_fd: bool,
    long_fd: bool,
    /// Dynamic stuff bits so far, modulo 8 when sent.
    pub(crate) stuff_bits: u8,
}

impl Checks {
    pub(crate) const fn new(fd: bool, iso: bool) -> Checks {
        Checks {
            crc15: Crc::crc15(),
            crc17: Crc::crc17(iso),
            crc21: Crc::crc21(iso),
            classic: true,
            short_fd: fd,
            long_fd: fd,
            stuff_bits: 0,
        }
    }

    /// FDF is known.
    pub(crate) fn choose_format(&mut self, fd: bool) {
        self.classic = !fd;
        self.short_fd &= fd;
        self.long_fd &= fd;
    }

    /// The length is known.
    pub(crate) fn choose_length(&mut self, len: u8) {
        self.short_fd &= len <= 16;
        self.long_fd &= len > 16;
    }

    /// A bit of the frame that is no stuff bit.
    #[inline]
    pub(crate) fn push(&mut self, bit: bool) {
        if self.classic {
            self.crc15.push(bit);
        }
        self.push_fd(bit);
    }

    /// A dynamic stuff bit, which only the FD polynomials cover.
    #[inline]
    pub(crate) fn push_stuff(&mut self, bit: bool) {
        self.stuff_bits = self.stuff_bits.wrapping_add(1);
        self.push_fd(bit);
    }

    #[inline]
    fn push_fd(&mut self, bit: bool) {
        if self.short_fd {
            self.crc17.push(bit);
        }
        if self.long_fd {
            self.crc21.push(bit);
        }
    }

    /// The register that this frame ends with.
    pub(crate) fn crc(&self) -> Crc {
        if self.short_fd {
            self.crc17
        } else if self.long_fd {
            self.crc21
        } else {
            self.crc15
        }
    }
}

/// The stuff count field of an ISO FD frame, four bits: Gray code of the count modulo 8 and an even parity bit.
pub(crate) fn stuff_count_field(stuff_bits: u8) -> u8 {
    let count = stuff_bits & 7;
    let gray = count ^ count >> 1;
    gray << 1 | (gray.count_ones() & 1) as u8
}

#[cfg(test)]
mod tests {
    use super::stuff_count_field;

    /// The table of ISO 11898-1:2015 as printed in several manuals.
    #[test]
    fn stuff_count_is_gray_code_with_even_parity() {
        let table = [0b0000, 0b0011, 0b0110, 0b0101, 0b1100, 0b1111, 0b1010, 0b1001];
        for (count, field) in table.into_iter().enumerate() {
            assert_eq!(stuff_count_field(count as u8), field, "{count} stuff bits");
            assert_eq!(stuff_count_field(count as u8 + 8), field, "the count is taken modulo 8");
        }
    }
}
