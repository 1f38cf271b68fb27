//! Bit fields: what every generated getter and setter calls.

/// The bits of a field, shifted down.
#[inline(always)]
#[must_use]
pub const fn get(word: u32, lsb: u32, width: u32) -> u32 {
    (word >> lsb) & mask(width)
}

/// A word with a field replaced; bits of `value` that do not fit are dropped.
#[inline(always)]
#[must_use]
pub const fn put(word: u32, lsb: u32, width: u32, value: u32) -> u32 {
    let mask = mask(width) << lsb;
    (word & !mask) | ((value << lsb) & mask)
}

/// `width` ones.
#[inline(always)]
#[must_use]
pub const fn mask(width: u32) -> u32 {
    if width >= 32 { u32::MAX } else { (1 << width) - 1 }
}

/// The bits of a two's complement field as a signed number.
#[inline(always)]
#[must_use]
pub const fn get_signed(word: u32, lsb: u32, width: u32) -> i32 {
    let unused = 32 - width;
    ((get(word, lsb, width) << unused) as i32) >> unused
}

/// The value, if it may be programmed. In a `const` a value out of range does not compile.
///
/// # Panics
///
/// If the value is out of range.
#[inline(always)]
#[must_use]
#[track_caller]
pub const fn within(value: u32, min: u32, max: u32, what: &'static str) -> u32 {
    if value < min || value > max {
        out_of_range(what);
    }
    value
}

/// The number, if it fits the field's two's complement, as the field's bits.
///
/// # Panics
///
/// If the number does not fit.
#[inline(always)]
#[must_use]
#[track_caller]
pub const fn within_signed(value: i32, width: u32, what: &'static str) -> u32 {
    let limit = 1i32 << (width - 1);
    if value < -limit || value >= limit {
        out_of_range(what);
    }
    value as u32 & mask(width)
}

/// The lane of a repeated field or the element of an array, counted from 0.
///
/// # Panics
///
/// If `number` is not one of the `count` numbers from `first` on.
#[inline(always)]
#[must_use]
#[track_caller]
pub const fn position(number: usize, first: usize, count: usize, what: &'static str) -> usize {
    if number < first || number - first >= count {
        out_of_range(what);
    }
    number - first
}

/// Apart, so that the check costs one compare and one branch.
#[cold]
#[inline(never)]
#[track_caller]
const fn out_of_range(what: &'static str) -> ! {
    panic!("{}", what)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_do_not_touch_their_neighbours() {
        assert_eq!(get(0x1234_5678, 8, 8), 0x56);
        assert_eq!(put(0xFFFF_FFFF, 4, 4, 0x1A5), 0xFFFF_FF5F);
        assert_eq!(put(0, 0, 32, 0xDEAD_BEEF), 0xDEAD_BEEF);
        assert_eq!(get(0xDEAD_BEEF, 0, 32), 0xDEAD_BEEF);
    }

    #[test]
    fn signed_fields() {
        for value in -64..64 {
            let bits = within_signed(value, 7, "7 bits");
            assert!(bits < 128);
            assert_eq!(get_signed(put(u32::MAX, 8, 7, bits), 8, 7), value);
        }
    }

    #[test]
    #[should_panic(expected = "NBTP.NSJW takes 0..=127")]
    fn out_of_range_says_what_is_allowed() {
        let _ = within(128, 0, 127, "NBTP.NSJW takes 0..=127");
    }

    #[test]
    #[should_panic(expected = "fifo takes 1..=31")]
    fn index_before_the_first() {
        let _ = position(0, 1, 31, "fifo takes 1..=31");
    }
}
