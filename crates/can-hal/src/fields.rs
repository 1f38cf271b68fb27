//! Limits of fields, taken from the generated tables.

use core::fmt;

use regbus::{Register, meta::Field};

/// A value that a register field does not take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutOfRange {
    /// Register and field, by the manual's names.
    pub field: &'static str,
    /// The value asked for, as the quantity it stands for.
    pub value: u32,
    /// The smallest quantity.
    pub min: u32,
    /// The largest quantity.
    pub max: u32,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} takes {} to {}, not {}", self.field, self.min, self.max, self.value)
    }
}

impl core::error::Error for OutOfRange {}

/// The limits of a field, worked out when the crate is compiled.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    name: &'static str,
    min: u32,
    max: u32,
    add: u32,
}

impl Limits {
    /// The field `REGISTER.FIELD` of a register.
    pub(crate) const fn of<R: Register>(name: &'static str) -> Self {
        let field = find(R::FIELDS, name);
        assert!(field.add >= 0 && field.times == 1, "only fields that hold a quantity less a number");
        Self { name, min: field.min, max: field.max, add: field.add as u32 }
    }

    /// The bits that stand for a quantity, such as 0 for one time quantum.
    pub(crate) const fn encode(self, quantity: u32) -> Result<u32, OutOfRange> {
        let (min, max) = (self.min + self.add, self.max + self.add);
        if quantity < min || quantity > max {
            return Err(OutOfRange { field: self.name, value: quantity, min, max });
        }
        Ok(quantity - self.add)
    }
}

/// The field whose name stands behind the dot.
const fn find(fields: &'static [Field], name: &'static str) -> Field {
    let name = name.as_bytes();
    let mut dot = 0;
    while name[dot] != b'.' {
        dot += 1;
    }
    let mut index = 0;
    while index < fields.len() {
        let candidate = fields[index].name.as_bytes();
        let mut at = 0;
        while at < candidate.len() && dot + 1 + at < name.len() && candidate[at] == name[dot + 1 + at] {
            at += 1;
        }
        if at == candidate.len() && dot + 1 + at == name.len() {
            return fields[index];
        }
        index += 1;
    }
    panic!("the description has no such field")
}
