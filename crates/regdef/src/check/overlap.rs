//! No two fields of a register or word share bits.

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::{Lowered, Origin, bit_list};
use crate::model::Field;

pub(super) fn fields(lowered: &Lowered, findings: &mut Findings) {
    for (register, origin) in lowered.model.registers.iter().zip(&lowered.registers) {
        holder(&register.name, &register.fields, origin, findings);
    }
    for (message, origins) in lowered.model.messages.iter().zip(&lowered.words) {
        for (word, origin) in message.words.iter().zip(origins) {
            holder(&format!("{}.{}", message.name, word.name), &word.fields, origin, findings);
        }
    }
}

fn holder(name: &str, fields: &[Field], origin: &Origin, findings: &mut Findings) {
    for (index, field) in fields.iter().enumerate() {
        for (other_index, other) in fields[..index].iter().enumerate() {
            let shared = field.mask() & other.mask();
            if shared == 0 {
                continue;
            }
            findings.push(
                Diagnostic::new(
                    Code::FieldOverlap,
                    Spot::Value(origin.fields[index].key("bits")),
                    format!("`{}` and `{}` of `{name}` share {}", other.name, field.name, bit_list(shared)),
                )
                .label(format!("`{}` takes {}", field.name, bit_list(field.mask())))
                .also(
                    Spot::Value(origin.fields[other_index].key("bits")),
                    format!("`{}` takes {}", other.name, bit_list(other.mask())),
                )
                .help("every bit belongs to one field; check both against the register's page"),
            );
        }
    }
}
