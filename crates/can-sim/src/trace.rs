//! The record of register accesses, decoded through the metadata when it is shown.

use core::fmt;

use can_wire::Time;
use regbus::meta::Field;

use crate::diagnostic::Bits;

/// One access of the host.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AccessRecord {
    /// When.
    pub time: Time,
    /// The controller, by the name it was added with.
    pub controller: String,
    /// True for a write.
    pub write: bool,
    /// Byte offset.
    pub offset: u32,
    /// Width.
    pub width: Bits,
    /// The value moved.
    pub value: u32,
    /// The register, `None` where there is none.
    pub register: Option<RegisterTouched>,
}

/// The register that an access touched first.
#[derive(Clone)]
pub struct RegisterTouched {
    /// Its name.
    pub name: String,
    /// Its fields.
    pub fields: &'static [Field],
    /// Its value: after a write what it holds, for a read what was seen, all bytes.
    pub value: u32,
}

impl PartialEq for RegisterTouched {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.value == other.value
    }
}

impl Eq for RegisterTouched {}

impl fmt::Debug for RegisterTouched {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        regbus::meta::debug(f, &self.name, self.value, self.fields)
    }
}

impl fmt::Display for AccessRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (verb, digits) = (if self.write { "write" } else { "read" }, usize::from(self.width.0) / 4);
        write!(
            f,
            "{} {}: {verb} {:#05x} = {:#0w$x}",
            self.time,
            self.controller,
            self.offset,
            self.value,
            w = digits + 2
        )?;
        match &self.register {
            Some(register) => write!(f, " {register:?}"),
            None => Ok(()),
        }
    }
}
