//! Register values in words.

use core::fmt;

use super::Field;

/// One value of a field: its name if it has one, otherwise the number.
struct Shown<'a>(&'a Field, u32);

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(field, value) = *self;
        match field.values.and_then(|values| values.name_of(value)) {
            Some(name) => write!(f, "{name}"),
            None if field.signed => write!(f, "{}", crate::bits::get_signed(value, 0, u32::from(field.width))),
            None if field.width > 8 => write!(f, "{value:#x}"),
            None => write!(f, "{value}"),
        }
    }
}

/// The lanes of a field: as a mask if each is one bit, otherwise as a list.
struct Lanes<'a>(&'a Field, u32);

impl fmt::Debug for Lanes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(field, word) = *self;
        if field.width == 1 {
            let bits = (0..field.lanes).fold(0u32, |bits, lane| bits | field.get(word, lane) << lane);
            return write!(f, "{bits:#x}");
        }
        f.debug_list().entries((0..field.lanes).map(|lane| Shown(field, field.get(word, lane)))).finish()
    }
}

/// Shows a value field by field.
pub fn debug(f: &mut fmt::Formatter<'_>, name: &str, word: u32, fields: &[Field]) -> fmt::Result {
    let mut out = f.debug_struct(name);
    for field in fields {
        if field.lanes > 1 {
            out.field(field.name, &Lanes(field, word));
        } else {
            out.field(field.name, &Shown(field, field.get(word, 0)));
        }
    }
    out.finish()
}

/// Sends a value field by field.
#[cfg(feature = "defmt")]
pub fn format(f: defmt::Formatter<'_>, name: &str, word: u32, fields: &[Field]) {
    defmt::write!(f, "{=str} {{ ", name);
    for field in fields {
        for lane in 0..field.lanes {
            let value = field.get(word, lane);
            defmt::write!(f, "{=str}", field.name);
            if field.lanes > 1 {
                defmt::write!(f, "[{=u8}]", field.first_lane + lane);
            }
            match field.values.and_then(|values| values.name_of(value)) {
                Some(name) => defmt::write!(f, ": {=str} ", name),
                None => defmt::write!(f, ": {=u32} ", value),
            }
        }
    }
    defmt::write!(f, "}}");
}

/// Sends the name of an enumeration's value.
#[cfg(feature = "defmt")]
pub fn format_name(f: defmt::Formatter<'_>, name: Option<&'static str>) {
    defmt::write!(f, "{=str}", name.unwrap_or("?"));
}
