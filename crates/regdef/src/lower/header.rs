//! The head of a description, and the limits that hold everywhere in it.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::Alias;
use crate::path::Path;
use crate::source::MAX_BYTES;
use crate::syntax::Int;

/// Largest address, offset or size in bytes: controllers stand in an address space of 32 bits.
pub(super) const MAX_ADDRESS: u64 = 1 << 32;

/// Largest number that a manual gives to the first element of an array or the first lane.
const MAX_FIRST: u32 = 1 << 16;

impl Lowering<'_> {
    pub(super) fn header(&mut self) {
        let text = self.text;
        let id = &text.controller;
        let fine = id.starts_with(|c: char| c.is_ascii_lowercase())
            && id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        if !fine {
            self.find(
                Diagnostic::new(
                    Code::BadIdentifier,
                    Spot::Value(Path::root().key("controller")),
                    format!("`{id}` cannot name a crate and a C header"),
                )
                .help("use lower case letters, digits and underscores, starting with a letter: `m_can`"),
            );
        }
        let widths_at = Path::root().key("access_widths");
        if text.access_widths.is_empty() {
            self.find(
                Diagnostic::new(Code::OutOfRange, Spot::Value(widths_at.clone()), "no access is legal")
                    .help("list the widths of the bus accesses that the manual allows: `access_widths: [8, 16, 32]`"),
            );
        }
        for (index, width) in text.access_widths.iter().enumerate() {
            if !matches!(width, 8 | 16 | 32) {
                let at = widths_at.index(index);
                self.find(
                    Diagnostic::new(
                        Code::OutOfRange,
                        Spot::Value(at),
                        format!("an access cannot be {width} bits wide"),
                    )
                    .label("has to be 8, 16 or 32"),
                );
            }
        }
        self.check_width(text.register_width, &Path::root().key("register_width"));
        self.address(text.span, &Path::root().key("span"));
        for (name, alias) in &text.aliases {
            let at = Path::root().key("aliases").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(alias.cite.as_ref(), &at);
            let offset = self.address(alias.offset, &at.key("offset"));
            self.out.model.aliases.push(Alias {
                name: name.clone(),
                offset,
                op: alias.op,
                doc: alias.doc.clone().unwrap_or_default(),
                cites,
            });
        }
    }

    pub(super) fn check_width(&mut self, width: u8, at: &Path) -> bool {
        let fine = matches!(width, 8 | 16 | 32);
        if !fine {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.clone()),
                    format!("a register cannot be {width} bits wide"),
                )
                .label("has to be 8, 16 or 32"),
            );
        }
        fine
    }

    /// An address, offset or distance in bytes, cut to what can be calculated with.
    pub(super) fn address(&mut self, value: Int, at: &Path) -> u64 {
        if value.0 > MAX_ADDRESS {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.clone()),
                    format!("{:#x} bytes are more than an address space of 32 bits holds", value.0),
                )
                .label(format!("has to be at most {MAX_ADDRESS:#x}")),
            );
        }
        value.0.min(MAX_ADDRESS)
    }

    /// The manual's number of a first element, cut likewise.
    pub(super) fn first(&mut self, value: u32, at: &Path) -> u32 {
        if value > MAX_FIRST {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.clone()),
                    format!("counting does not start at {value}"),
                )
                .label(format!("has to be at most {MAX_FIRST}")),
            );
        }
        value.min(MAX_FIRST)
    }

    /// Counts text that the model repeats; `false` if it is too much already.
    pub(super) fn repeat(&mut self, bytes: usize, at: &Path) -> bool {
        let limit = usize::try_from(4 * MAX_BYTES).unwrap_or(usize::MAX);
        let before = self.copied <= limit;
        self.copied = self.copied.saturating_add(bytes);
        let fine = self.copied <= limit;
        if before && !fine {
            self.find(
                Diagnostic::new(
                    Code::TooLarge,
                    Spot::Key(at.clone()),
                    format!("the copies of texts exceed {limit} bytes"),
                )
                .label("here")
                .help("a description that is copied often has to be short"),
            );
        }
        fine
    }

    /// Reports a name that cannot be an identifier and cannot be referred to.
    pub(super) fn check_identifier(&mut self, name: &str, at: &Path) {
        self.identifier(name, Spot::Key(at.clone()));
    }

    /// The same for a name that is a value.
    pub(super) fn check_identifier_value(&mut self, name: &str, at: &Path) {
        self.identifier(name, Spot::Value(at.clone()));
    }

    /// The same for a `name` that is given to code alone.
    pub(super) fn check_name(&mut self, name: Option<&String>, at: &Path) {
        if let Some(name) = name {
            self.check_identifier_value(name, &at.key("name"));
        }
    }

    fn identifier(&mut self, name: &str, at: Spot) {
        let fine = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && name.contains(|c: char| c.is_ascii_alphanumeric());
        if !fine {
            self.find(
                Diagnostic::new(Code::BadIdentifier, at, format!("`{name}` cannot be an identifier"))
                    .label("use ASCII letters, digits and underscores")
                    .help("where the manual spells it differently, give its spelling in `label`"),
            );
        }
    }
}
