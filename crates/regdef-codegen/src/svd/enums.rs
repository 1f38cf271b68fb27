//! Enumerated values: written at the first field that uses them, derived from there elsewhere.

use std::collections::{HashMap, HashSet};

use regdef::model::{Enum, EnumId, Field, Model};
use svd_rs::{EnumeratedValue, EnumeratedValues};

use super::{At, Error, LEVEL, name, plain};

/// A run of values is written out up to this length.
const LONGEST_RUN: u64 = 256;

/// Which enumerations have been written, and where.
#[derive(Default)]
pub(super) struct Shared {
    path: Vec<String>,
    written: HashMap<EnumId, String>,
    /// Enumerations of the register at hand; a second field of one register gets values
    /// of its own, because svd2rust cannot derive from a field of the same register.
    in_register: HashSet<EnumId>,
    in_window: bool,
}

impl Shared {
    /// Starts the peripheral.
    pub(super) fn begin(&mut self, peripheral: &str) {
        self.path = vec![peripheral.to_owned()];
    }

    /// Goes into a cluster or register. Nothing is derived from a register of a window: svd2rust renames it
    /// after its `alternateGroup` and then does not find it.
    pub(super) fn enter(&mut self, name: &str, in_window: bool) {
        self.path.push(name.to_owned());
        self.in_register.clear();
        self.in_window = in_window;
    }

    /// Comes back from it.
    pub(super) fn leave(&mut self) {
        self.path.pop();
    }

    /// The values of a field; `None` if the enumeration names none that fit, or too many to be written out.
    pub(super) fn values(
        &mut self,
        model: &Model,
        id: EnumId,
        field: &Field,
        field_name: &str,
    ) -> Result<Option<EnumeratedValues>, Error> {
        let of = model.enumeration(id);
        let name = name::identifier(&of.name);
        let narrow = field.width < of.width && of.variants.iter().any(|v| v.last > field.capacity());
        let builder = EnumeratedValues::builder();
        // Derived values take over the name, which svd2rust then defines twice in the module of the register.
        let again = !narrow && !self.in_register.insert(id);
        let own = format!("{name}_{}", name::identifier(&field.name));
        if narrow || again {
            let Some(values) = listed(of, field.capacity())? else { return Ok(None) };
            return builder.name(Some(own)).values(values).build(LEVEL).at(&of.name).map(Some);
        }
        if let Some(path) = self.written.get(&id) {
            return builder.derived_from(Some(path.clone())).build(LEVEL).at(&of.name).map(Some);
        }
        let Some(values) = listed(of, field.capacity())? else { return Ok(None) };
        if !self.in_window {
            self.written.insert(id, format!("{}.{field_name}.{name}", self.path.join(".")));
        }
        builder.name(Some(name)).values(values).build(LEVEL).at(&of.name).map(Some)
    }
}

fn listed(of: &Enum, capacity: u64) -> Result<Option<Vec<EnumeratedValue>>, Error> {
    let mut values = Vec::new();
    for variant in of.variants.iter().filter(|v| v.first <= capacity) {
        let last = variant.last.min(capacity);
        if last - variant.first >= LONGEST_RUN {
            return Ok(None);
        }
        for value in variant.first..=last {
            let name =
                if variant.first == variant.last { variant.name.clone() } else { format!("{}_{value}", variant.name) };
            let text = if variant.doc.is_empty() { &variant.name } else { &variant.doc };
            let entry = EnumeratedValue::builder()
                .name(name::identifier(&name))
                .description(Some(plain(text)))
                .value(Some(value))
                .build(LEVEL)
                .at(&of.name)?;
            values.push(entry);
        }
    }
    Ok(Some(values).filter(|values| !values.is_empty()))
}
