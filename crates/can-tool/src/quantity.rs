//! Numbers with units, as people type and read them.

/// The suffixes, with what they multiply by.
const SUFFIXES: [(&str, u64); 6] =
    [("Ki", 1 << 10), ("Mi", 1 << 20), ("k", 1_000), ("K", 1_000), ("M", 1_000_000), ("G", 1_000_000_000)];

/// `40M`, `500k`, `83.333k`, `500_000`, `16Ki`, `0x1400`: a whole number that fits 32 bits.
pub fn whole(text: &str) -> Result<u32, String> {
    let plain = text.replace('_', "");
    if let Some(digits) = plain.strip_prefix("0x").or_else(|| plain.strip_prefix("0X")) {
        return u32::from_str_radix(digits, 16).map_err(|_| "not a hexadecimal number of 32 bits".to_owned());
    }
    let (digits, times) =
        SUFFIXES.iter().find_map(|(suffix, times)| Some((plain.strip_suffix(suffix)?, *times))).unwrap_or((&plain, 1));
    let value = scaled(digits, times).ok_or("expected a number such as 40M, 500k, 83.333k, 16Ki or 0x1400")?;
    u32::try_from(value).map_err(|_| format!("{value} is too large: the largest is {}", u32::MAX))
}

/// A decimal number times something; `None` unless the result is whole.
fn scaled(digits: &str, times: u64) -> Option<u64> {
    let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
    let number = |text: &str| -> Option<u64> {
        if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) { None } else { text.parse().ok() }
    };
    let value = number(whole)?.checked_mul(times)?;
    if rest.is_empty() {
        return if digits.contains('.') { None } else { Some(value) };
    }
    let unit = 10u64.checked_pow(u32::try_from(rest.len()).ok()?)?;
    let part = number(rest)?.checked_mul(times)?;
    if part % unit == 0 { value.checked_add(part / unit) } else { None }
}

/// `87.5%` or `87.5`: hundredths of a percent.
pub fn percent(text: &str) -> Result<u16, String> {
    let digits = text.strip_suffix('%').unwrap_or(text).trim_end();
    match scaled(digits, 100) {
        Some(value @ 1..=9_999) => Ok(value as u16),
        Some(_) => Err("a sample point lies between 0 % and 100 %".to_owned()),
        None => Err("expected a percentage such as 87.5% with at most two decimals".to_owned()),
    }
}

/// `40 MHz`, `500 kbit/s`.
pub fn shown(value: u64, unit: &str) -> String {
    let (prefix, per) = match value {
        1_000_000.. => ("M", 1_000_000),
        1_000.. => ("k", 1_000),
        _ => ("", 1),
    };
    let rest = format!("{:06}", value % per * (1_000_000 / per));
    let rest = rest.trim_end_matches('0');
    let point = if rest.is_empty() { "" } else { "." };
    format!("{}{point}{rest} {unit_prefix}{unit}", value / per, unit_prefix = prefix)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers() {
        let cases =
            [("40M", 40_000_000), ("500k", 500_000), ("83.333k", 83_333), ("1.5M", 1_500_000), ("16Ki", 16_384)];
        let plain = [("0x1400", 0x1400), ("500_000", 500_000), ("0", 0), ("4.294967295G", u32::MAX)];
        for (text, value) in cases.into_iter().chain(plain) {
            assert_eq!(whole(text), Ok(value), "{text}");
        }
        for text in ["", "M", "40X", "-1", "1.2345k", "1.", ".5k", "0x", "1e6", "5G", "40 M", "4.5"] {
            assert!(whole(text).is_err(), "{text}");
        }
    }

    #[test]
    fn percentages() {
        for (text, value) in [("80%", 8000), ("87.5 %", 8750), ("66.67", 6667)] {
            assert_eq!(percent(text), Ok(value), "{text}");
        }
        for text in ["0%", "100%", "87.555%", "%", "eighty"] {
            assert!(percent(text).is_err(), "{text}");
        }
    }

    #[test]
    fn quantities_are_readable() {
        assert_eq!(shown(40_000_000, "Hz"), "40 MHz");
        assert_eq!(shown(83_333, "bit/s"), "83.333 kbit/s");
        assert_eq!(shown(1, "Hz"), "1 Hz");
    }
}
