//! Scalars with more than one spelling: integers with underscores, bit ranges, value keys.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};

/// An unsigned integer: decimal, `0x` or `0b`, with underscores where they help reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Int(pub u64);

impl Int {
    /// Reads the spelling of an integer; `None` if it is not one or exceeds 64 bits.
    #[must_use]
    pub fn parse(text: &str) -> Option<u64> {
        if !text.starts_with(|c: char| c.is_ascii_digit()) || text.contains(['+', '-']) {
            return None;
        }
        let digits = text.replace('_', "");
        match digits.get(..2) {
            Some("0x" | "0X") => u64::from_str_radix(&digits[2..], 16).ok(),
            Some("0b" | "0B") => u64::from_str_radix(&digits[2..], 2).ok(),
            _ => digits.parse().ok(),
        }
    }
}

struct TextOrInt<T>(fn(&str) -> Option<T>, &'static str);

impl<T> Visitor<'_> for TextOrInt<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.1)
    }

    fn visit_u64<E: de::Error>(self, v: u64) -> Result<T, E> {
        (self.0)(&v.to_string()).ok_or_else(|| E::invalid_value(de::Unexpected::Unsigned(v), &self))
    }

    fn visit_i64<E: de::Error>(self, v: i64) -> Result<T, E> {
        (self.0)(&v.to_string()).ok_or_else(|| E::invalid_value(de::Unexpected::Signed(v), &self))
    }

    fn visit_str<E: de::Error>(self, v: &str) -> Result<T, E> {
        (self.0)(v).ok_or_else(|| E::invalid_value(de::Unexpected::Str(v), &self))
    }
}

impl<'de> Deserialize<'de> for Int {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        d.deserialize_any(TextOrInt(|s| Int::parse(s).map(Int), "an unsigned integer such as 12, 0x0C or 0b1100"))
    }
}

/// The digits are counted so that a number that fits the pattern fits 64 bits.
const INT_PATTERN: &str = "^(0[xX]_*([0-9a-fA-F]_*){1,16}|0[bB]_*([01]_*){1,64}|([0-9]_*){1,19})$";

impl JsonSchema for Int {
    fn schema_name() -> Cow<'static, str> {
        "Int".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An unsigned integer of at most 64 bits: decimal, 0x or 0b, underscores allowed.",
            "anyOf": [{"type": "integer", "minimum": 0}, {"type": "string", "pattern": INT_PATTERN}],
        })
    }
}

/// The bits of a field, most significant first: `15` or `"7:0"`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BitRange {
    /// Most significant bit.
    pub msb: u32,
    /// Least significant bit.
    pub lsb: u32,
}

impl BitRange {
    /// Reads `15` or `7:0`; the order of the two numbers is kept, not repaired.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let bit = |s: &str| s.trim().parse::<u32>().ok();
        match text.split_once(':') {
            Some((msb, lsb)) => Some(Self { msb: bit(msb)?, lsb: bit(lsb)? }),
            None => bit(text).map(|bit| Self { msb: bit, lsb: bit }),
        }
    }
}

impl<'de> Deserialize<'de> for BitRange {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        d.deserialize_any(TextOrInt(BitRange::parse, "a bit such as 5 or a range such as \"7:0\""))
    }
}

impl JsonSchema for BitRange {
    fn schema_name() -> Cow<'static, str> {
        "BitRange".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A bit such as 5, or a range with the most significant bit first such as \"7:0\".",
            "anyOf": [
                {"type": "integer", "minimum": 0, "maximum": 63},
                {"type": "string", "pattern": "^[0-9]{1,2}(:[0-9]{1,2})?$"},
            ],
        })
    }
}

const VALUE_PATTERN: &str = "^(0[xX]_*([0-9a-fA-F]_*){1,16}|0[bB]_*([01]_*){1,64}|([0-9]_*){1,19})( *\\.\\. *(0[xX]_*([0-9a-fA-F]_*){1,16}|0[bB]_*([01]_*){1,64}|([0-9]_*){1,19}))?$";

/// The value or the range of values that one entry of an enumeration names: `3` or `"0..31"` (both ends included).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ValueKey {
    /// First value.
    pub first: u64,
    /// Last value; equal to `first` for a single value.
    pub last: u64,
    /// The key as positions are filed under it.
    pub spelling: String,
}

impl ValueKey {
    /// Reads `3`, `0x40`, `0b101` or `0..31`.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (first, last) = match text.split_once("..") {
            Some((first, last)) => (Int::parse(first.trim())?, Int::parse(last.trim())?),
            None => Int::parse(text).map(|v| (v, v))?,
        };
        Some(Self { first, last, spelling: text.to_owned() })
    }
}

impl<'de> Deserialize<'de> for ValueKey {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        d.deserialize_any(TextOrInt(ValueKey::parse, "a value such as 3 or a range such as \"0..31\""))
    }
}

impl JsonSchema for ValueKey {
    fn schema_name() -> Cow<'static, str> {
        "ValueKey".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A value such as 3, 0x40 or 0b101, or a range such as \"0..31\" with both ends included.",
            "anyOf": [
                {"type": "integer", "minimum": 0},
                {"type": "string", "pattern": VALUE_PATTERN},
            ],
        })
    }
}

/// One item, or a list of them.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OneOrMany<T> {
    /// A single item.
    One(T),
    /// A list.
    Many(Vec<T>),
}

impl<T> OneOrMany<T> {
    /// The items as a slice.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        match self {
            Self::One(one) => std::slice::from_ref(one),
            Self::Many(many) => many,
        }
    }
}
