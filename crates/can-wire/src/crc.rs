//! The three cyclic redundancy checks (ISO 11898-1:2015, 10.4.2.6 "CRC field").

/// A CRC register that takes the frame bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crc {
    /// Aligned to the top of the word, as is the register: a step then needs no mask and no shift by the width.
    polynomial: u32,
    width: u32,
    register: u32,
}

/// Generator polynomial of CRC-15, without the leading term.
pub const CRC15_POLYNOMIAL: u32 = 0x4599;
/// Generator polynomial of CRC-17, without the leading term.
pub const CRC17_POLYNOMIAL: u32 = 0x1_685B;
/// Generator polynomial of CRC-21, without the leading term.
pub const CRC21_POLYNOMIAL: u32 = 0x10_2899;

impl Crc {
    /// CRC-15, for classic frames; starts at zero.
    #[must_use]
    pub const fn crc15() -> Crc {
        Crc { polynomial: CRC15_POLYNOMIAL << (32 - 15), width: 15, register: 0 }
    }

    /// CRC-17, for FD frames of up to 16 data bytes. The ISO format starts with the top bit set, the earlier non-ISO
    /// format at zero.
    #[must_use]
    pub const fn crc17(iso: bool) -> Crc {
        Crc { polynomial: CRC17_POLYNOMIAL << (32 - 17), width: 17, register: if iso { 1 << 31 } else { 0 } }
    }

    /// CRC-21, for FD frames of more than 16 data bytes. The ISO format starts with the top bit set, the earlier
    /// non-ISO format at zero.
    #[must_use]
    pub const fn crc21(iso: bool) -> Crc {
        Crc { polynomial: CRC21_POLYNOMIAL << (32 - 21), width: 21, register: if iso { 1 << 31 } else { 0 } }
    }

    /// Takes the next bit of the frame, `true` for recessive.
    #[inline]
    pub const fn push(&mut self, bit: bool) {
        let feedback = self.register >> 31 ^ bit as u32;
        self.register = self.register << 1 ^ (self.polynomial & feedback.wrapping_neg());
    }

    /// The CRC sequence, most significant bit first on the bus.
    #[must_use]
    pub const fn value(self) -> u32 {
        self.register >> (32 - self.width)
    }

    /// Bits of the sequence: 15, 17 or 21.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.width
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_text(mut crc: Crc) -> u32 {
        for byte in b"123456789" {
            for bit in (0..8).rev() {
                crc.push(byte >> bit & 1 == 1);
            }
        }
        crc.value()
    }

    /// The check values of the catalogue of parametrised CRC algorithms, which lists them with an initial value of 0.
    #[test]
    fn check_values_of_the_crc_catalogue() {
        assert_eq!(of_text(Crc::crc15()), 0x059E);
        assert_eq!(of_text(Crc::crc17(false)), 0x04F03);
        assert_eq!(of_text(Crc::crc21(false)), 0x0E_D841);
    }

    #[test]
    fn the_iso_start_value_makes_leading_zeros_count() {
        for (iso, old) in [(Crc::crc17(true), Crc::crc17(false)), (Crc::crc21(true), Crc::crc21(false))] {
            let (mut iso, mut old) = (iso, old);
            for _ in 0..40 {
                iso.push(false);
                old.push(false);
            }
            assert_ne!(iso.value(), 0);
            assert_eq!(old.value(), 0);
        }
    }

    #[test]
    fn appending_the_sequence_leaves_zero() {
        for mut crc in [Crc::crc15(), Crc::crc17(true), Crc::crc21(true)] {
            for bit in 0..100u32 {
                crc.push(bit.is_multiple_of(3) || bit.is_multiple_of(7));
            }
            let sequence = crc.value();
            for bit in (0..crc.width()).rev() {
                crc.push(sequence >> bit & 1 == 1);
            }
            assert_eq!(crc.value(), 0);
        }
    }
}
