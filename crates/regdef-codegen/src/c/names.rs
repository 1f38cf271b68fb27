//! Names of macros and functions, each given out once.

use std::collections::{HashMap, HashSet};

use regdef::model::{EnumId, FieldRef, Ident, MessageId, Model, RegisterId};

/// What the macros of each thing begin with.
///
/// Two registers and fields can spell the same name together, as `A_B` with `C` and `A` with `B_C`; the later one
/// then gets an underscore at its end.
#[derive(Debug, Clone)]
pub struct Names {
    registers: Vec<String>,
    fields: HashMap<FieldRef, String>,
    joined: Vec<String>,
    words: HashMap<(MessageId, usize), String>,
    word_fields: HashMap<(MessageId, usize, usize), String>,
    messages: Vec<String>,
    variants: HashMap<(EnumId, usize), String>,
}

#[derive(Default)]
struct Taken(HashSet<String>);

impl Taken {
    /// The stem, made longer until none of its uses is taken.
    fn claim(&mut self, stem: String, uses: &[&str]) -> String {
        let mut stem = stem;
        while uses.iter().any(|suffix| self.0.contains(&format!("{stem}{suffix}"))) {
            stem.push('_');
        }
        self.0.extend(uses.iter().map(|suffix| format!("{stem}{suffix}")));
        stem
    }
}

/// What stands behind the name of a register; functions have the same in lower case.
const REGISTER_USES: &[&str] = &[
    "",
    "_OFFSET",
    "_RESET",
    "_RESET_MASK",
    "_COUNT",
    "_STRIDE",
    "_FIRST",
    "_CLEAR",
    "_REQUEST",
    "_MODIFY",
    "_RESTART",
];
const FIELD_USES: &[&str] = &["_Msk", "_GET", "_SET"];
const JOINED_USES: &[&str] = &["_READ", "_WRITE", "_CLEAR", "_REQUEST"];
const MESSAGE_USES: &[&str] =
    &["_T", "_READ_PAYLOAD", "_WRITE_PAYLOAD", "_PAYLOAD_BYTES", "_HEADER_BYTES", "_BYTES", "_PAYLOAD_MAX"];
const VARIANT_USES: &[&str] = &["", "_FIRST", "_LAST"];

impl Names {
    /// The names for one controller.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let upper = &model.names.ident.upper;
        let mut taken = Taken::default();
        for own in ["_H", "_ASSERT", "_STATIC_ASSERT", "_READ_ONLY", "_MICROCHIP_NAMES"] {
            taken.0.insert(format!("{upper}{own}"));
        }
        let mut names = Self {
            registers: Vec::new(),
            fields: HashMap::new(),
            joined: Vec::new(),
            words: HashMap::new(),
            word_fields: HashMap::new(),
            messages: Vec::new(),
            variants: HashMap::new(),
        };
        let aliases: Vec<String> =
            model.aliases.iter().map(|alias| format!("_{}", alias.name.to_ascii_uppercase())).collect();
        let register_uses: Vec<&str> =
            REGISTER_USES.iter().copied().chain(aliases.iter().map(String::as_str)).collect();
        for (index, register) in model.registers.iter().enumerate() {
            let stem = taken.claim(format!("{upper}_{}", register.ident.upper), &register_uses);
            for (field, of) in register.fields.iter().enumerate() {
                let name = taken.claim(format!("{stem}_{}", of.ident.upper), FIELD_USES);
                names.fields.insert(FieldRef { register: RegisterId(index), field }, name);
            }
            names.registers.push(stem);
        }
        for joined in &model.joined {
            names.joined.push(taken.claim(format!("{upper}_{}", joined.ident.upper), JOINED_USES));
        }
        for (index, message) in model.messages.iter().enumerate() {
            let id = MessageId(index);
            let stem = taken.claim(format!("{upper}_{}", message.ident.upper), MESSAGE_USES);
            for (word, of) in message.words.iter().enumerate() {
                let word_stem = format!("{stem}_{}", Ident::new(&of.name).upper);
                for (field, of) in of.fields.iter().enumerate() {
                    let name = taken.claim(format!("{word_stem}_{}", of.ident.upper), FIELD_USES);
                    names.word_fields.insert((id, word, field), name);
                }
                names.words.insert((id, word), word_stem);
            }
            names.messages.push(stem);
        }
        for (index, of) in model.enums.iter().enumerate() {
            for (variant, value) in of.variants.iter().enumerate() {
                let stem = format!("{upper}_{}_{}", of.ident.upper, value.ident.upper.trim_start_matches('_'));
                names.variants.insert((EnumId(index), variant), taken.claim(stem, VARIANT_USES));
            }
        }
        names
    }

    /// `M_CAN_CCCR`.
    #[must_use]
    pub fn register(&self, id: RegisterId) -> &str {
        &self.registers[id.0]
    }

    /// `M_CAN_CCCR_INIT`, the stem of `_Pos`, `_Msk`, `_Width`, `_Access`.
    #[must_use]
    pub fn field(&self, at: FieldRef) -> &str {
        &self.fields[&at]
    }

    /// `DSPIC33_CANFD_TBC`: a value joined from registers.
    #[must_use]
    pub fn joined(&self, index: usize) -> &str {
        &self.joined[index]
    }

    /// `M_CAN_RX_BUFFER`.
    #[must_use]
    pub fn message(&self, id: MessageId) -> &str {
        &self.messages[id.0]
    }

    /// `M_CAN_RX_BUFFER_R0`.
    #[must_use]
    pub fn word(&self, message: MessageId, word: usize) -> &str {
        &self.words[&(message, word)]
    }

    /// `M_CAN_RX_BUFFER_R0_ESI`.
    #[must_use]
    pub fn word_field(&self, message: MessageId, word: usize, field: usize) -> &str {
        &self.word_fields[&(message, word, field)]
    }

    /// `M_CAN_LAST_ERROR_CODE_STUFF_ERROR`.
    #[must_use]
    pub fn variant(&self, of: EnumId, variant: usize) -> &str {
        &self.variants[&(of, variant)]
    }
}
