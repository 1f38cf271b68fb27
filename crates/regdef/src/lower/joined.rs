//! Values split over several registers.

use indexmap::IndexMap;

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{ClusterId, Field, Ident, Joined, Part, RegisterId};
use crate::path::Path;
use crate::syntax;

/// Widest joined value.
const MAX_WIDTH: u32 = 64;

impl Lowering<'_> {
    pub(super) fn joined(&mut self) {
        let text = self.text;
        self.joined_list(&text.joined, &Path::root().key("joined"));
        for (name, cluster) in &text.clusters {
            self.joined_list(&cluster.joined, &Path::root().key("clusters").key(name).key("joined"));
        }
    }

    fn joined_list(&mut self, list: &IndexMap<String, syntax::Joined>, base: &Path) {
        for (name, joined) in list {
            let at = base.key(name);
            self.check_identifier(name, &at);
            self.check_name(joined.name.as_ref(), &at);
            let parts = self.joined_parts(joined, &at);
            let Some(parts) = parts else { continue };
            let repetition = |id: RegisterId| {
                let register = self.out.model.register(id);
                (register.cluster, register.dim.as_ref().map(|d| (d.count, d.first)))
            };
            let first = repetition(parts[0].holder);
            if let Some(odd) = parts.iter().position(|p| repetition(p.holder) != first) {
                self.find(
                    Diagnostic::new(
                        Code::Contradiction,
                        Spot::Value(at.key("parts").index(odd)),
                        format!("the parts of `{name}` are not repeated alike"),
                    )
                    .help("all parts have to be single registers, arrays of one length, or members of one cluster"),
                );
                continue;
            }
            let cluster: Option<ClusterId> = first.0;
            let cites = self.cite(joined.cite.as_ref(), &at);
            self.out.model.joined.push(Joined {
                name: name.clone(),
                ident: Ident::new(joined.name.as_deref().unwrap_or(name)),
                doc: joined.doc.trim().to_owned(),
                width: parts.iter().map(|p| p.width).sum(),
                parts,
                order: joined.order,
                cluster,
                cites,
            });
        }
    }

    fn joined_parts(&mut self, joined: &syntax::Joined, at: &Path) -> Option<Vec<Part<RegisterId>>> {
        let mut parts = Vec::new();
        let mut shift = 0;
        for (index, reference) in joined.parts.iter().enumerate() {
            let at = at.key("parts").index(index);
            if index >= MAX_WIDTH as usize {
                break;
            }
            let part = self.part(reference, shift, &at)?;
            shift += part.width;
            parts.push(part);
        }
        self.check_parts(parts.len(), shift, at).then_some(parts)
    }

    /// Reports joined values with too few or too wide parts; `true` if they are fine.
    pub(super) fn check_parts(&mut self, count: usize, width: u32, at: &Path) -> bool {
        if count < 2 {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.key("parts")),
                    "a joined value has at least two parts",
                )
                .help("list the parts with the least significant one first"),
            );
            return false;
        }
        if width > MAX_WIDTH {
            self.find(Diagnostic::new(
                Code::OutOfRange,
                Spot::Value(at.key("parts")),
                format!("the parts have {width} bits together; {MAX_WIDTH} is the most"),
            ));
            return false;
        }
        true
    }

    /// `REG` or `REG.FIELD` as a part that starts at bit `shift` of the whole.
    pub(super) fn part(&mut self, reference: &str, shift: u32, at: &Path) -> Option<Part<RegisterId>> {
        if reference.contains('.') {
            let field = self.field_ref(reference, at)?;
            let (lsb, width) = field_bits(self.out.model.field(field));
            return Some(Part { holder: field.register, field: Some(field.field), lsb, width, shift });
        }
        let holder = self.register_ref(reference, at)?;
        let width = self.out.model.register(holder).width;
        Some(Part { holder, field: None, lsb: 0, width, shift })
    }
}

/// Lowest bit and width of a field, with lanes that lie side by side taken as one.
pub(super) fn field_bits(field: &Field) -> (u32, u32) {
    match field.lanes {
        Some(lanes) if lanes.stride == field.width => (field.lsb, field.width * lanes.count),
        _ => (field.lsb, field.width),
    }
}
