//! Data length codes (ISO 11898-1:2015, 10.4.2.4 "DLC").

use core::fmt;

/// The number of data bytes of a classic frame is at most this.
pub const CLASSIC_MAX_LEN: usize = 8;

/// The number of data bytes of an FD frame is at most this.
pub const FD_MAX_LEN: usize = 64;

/// Data bytes of an FD frame, indexed by data length code.
pub const FD_LENGTHS: [u8; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64];

/// A data length code: the four bits of the DLC field, 0 to 15.
///
/// The codes 9 to 15 mean 8 bytes in a classic frame and 12 to 64 bytes in an FD frame; the code itself travels
/// unchanged, so a receiver can tell them apart.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Dlc(u8);

impl Dlc {
    /// The code 0: no data bytes.
    pub const ZERO: Dlc = Dlc(0);

    /// A data length code from its four bits; `None` above 15.
    #[must_use]
    pub const fn new(code: u8) -> Option<Dlc> {
        if code <= 15 { Some(Dlc(code)) } else { None }
    }

    /// A data length code from the lower four bits of `bits`; the others are ignored, as a register field would.
    #[must_use]
    pub const fn from_low_bits(bits: u8) -> Dlc {
        Dlc(bits & 0xF)
    }

    /// The code for exactly `len` data bytes; `None` if no code stands for that length.
    #[must_use]
    pub const fn exact(len: usize) -> Option<Dlc> {
        match Dlc::fitting(len) {
            Some(dlc) if dlc.fd_len() == len => Some(dlc),
            _ => None,
        }
    }

    /// The smallest code whose FD length is at least `len` bytes; `None` above 64.
    #[must_use]
    pub const fn fitting(len: usize) -> Option<Dlc> {
        let mut code = 0;
        while code < 16 {
            if FD_LENGTHS[code as usize] as usize >= len {
                return Some(Dlc(code));
            }
            code += 1;
        }
        None
    }

    /// The four bits.
    #[must_use]
    pub const fn code(self) -> u8 {
        self.0
    }

    /// Data bytes of a classic data frame with this code: 0 to 8.
    #[must_use]
    pub const fn classic_len(self) -> usize {
        if self.0 as usize > CLASSIC_MAX_LEN { CLASSIC_MAX_LEN } else { self.0 as usize }
    }

    /// Data bytes of an FD frame with this code: 0 to 64.
    #[must_use]
    #[inline]
    pub const fn fd_len(self) -> usize {
        // The mask never acts; it tells the compiler what it cannot know, so that no check is left.
        FD_LENGTHS[(self.0 & 0xF) as usize] as usize
    }
}

impl fmt::Debug for Dlc {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Dlc({})", self.0)
    }
}

impl fmt::Display for Dlc {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl From<Dlc> for u8 {
    fn from(dlc: Dlc) -> u8 {
        dlc.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_gives_its_own_fd_length_back() {
        for code in 0..16 {
            let dlc = Dlc::new(code).expect("codes up to 15 exist");
            assert_eq!(Dlc::exact(dlc.fd_len()), Some(dlc));
            assert_eq!(dlc.classic_len(), usize::from(code).min(8));
        }
        assert_eq!(Dlc::new(16), None);
    }

    #[test]
    fn lengths_between_codes_round_up_and_have_no_exact_code() {
        for len in 0..=64 {
            let dlc = Dlc::fitting(len).expect("64 bytes fit");
            assert!(dlc.fd_len() >= len);
            if let Some(below) = dlc.code().checked_sub(1).and_then(Dlc::new) {
                assert!(below.fd_len() < len || len == 0);
            }
            assert_eq!(Dlc::exact(len).is_some(), FD_LENGTHS.contains(&(len as u8)));
        }
        assert_eq!(Dlc::fitting(65), None);
        assert_eq!(Dlc::exact(9), None);
    }

    #[test]
    fn low_bits_wrap_like_a_register_field() {
        assert_eq!(Dlc::from_low_bits(0xF7), Dlc::new(7).expect("7 is a code"));
    }
}
