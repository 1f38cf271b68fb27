//! Registers, clusters, windows and reserved ranges.

use std::collections::HashMap;

use indexmap::IndexMap;

use super::fields::{Holder, Outer};
use super::like::Expanded;
use super::{Lowering, Origin};
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{Capabilities, Cluster, ClusterId, Dim, Ident, Register, RegisterId};
use crate::path::Path;
use crate::syntax;

/// Most elements of an array: none of the controllers has more than 64.
const MAX_ELEMENTS: u32 = 4096;

impl Lowering<'_> {
    pub(super) fn registers(&mut self) {
        let text = self.text;
        self.register_list(&text.registers, &Path::root().key("registers"), None);
        for (name, cluster) in &text.clusters {
            let at = Path::root().key("clusters").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(cluster.cite.as_ref(), &at);
            self.check_name(cluster.name.as_ref(), &at);
            let dim = self.dim(&cluster.array, &at);
            let offset = self.address(cluster.offset, &at.key("offset"));
            let id = ClusterId(self.out.model.clusters.len());
            self.out.model.clusters.push(Cluster {
                name: name.clone(),
                ident: Ident::new(cluster.name.as_deref().unwrap_or(name)),
                title: cluster.title.clone(),
                doc: cluster.doc.clone().unwrap_or_default(),
                cites,
                offset,
                dim,
            });
            self.register_list(&cluster.registers, &at.key("registers"), Some(id));
        }
    }

    fn register_list(&mut self, list: &IndexMap<String, syntax::Register>, base: &Path, cluster: Option<ClusterId>) {
        for name in list.keys() {
            let at = base.key(name);
            let Some(expanded) = self.expand(name, list, base) else {
                self.lost_registers.insert(name.clone());
                continue;
            };
            let id = RegisterId(self.out.model.registers.len());
            self.check_identifier(name, &at);
            if let Some(first) = self.register_names.get(name) {
                let first = self.out.registers[first.0].path.clone();
                let title = format!("there are two registers named `{name}`");
                self.find(
                    Diagnostic::new(Code::DuplicateName, Spot::Key(at), title)
                        .label("again here")
                        .also(Spot::Key(first), "first here")
                        .help(
                            "references use this name alone, also for members of clusters; `label` keeps the manual's",
                        ),
                );
                continue;
            }
            self.register_names.insert(name.clone(), id);
            let (register, origin) = self.register(id, name, &expanded, &at, cluster);
            for (index, field) in register.fields.iter().enumerate() {
                if let Some(id) = field.enumeration() {
                    let at =
                        crate::model::FieldRef { register: RegisterId(self.out.model.registers.len()), field: index };
                    self.out.model.enums[id.0].used_by.push(at);
                }
            }
            self.out.model.registers.push(register);
            self.out.registers.push(origin);
        }
    }

    fn register(
        &mut self,
        id: RegisterId,
        name: &str,
        expanded: &Expanded,
        at: &Path,
        cluster: Option<ClusterId>,
    ) -> (Register, Origin) {
        let text = &expanded.register;
        let width = match text.width {
            Some(width) if self.check_width(width, &at.key("width")) => u32::from(width),
            Some(_) => 32,
            None => u32::from(self.text.register_width.clamp(8, 32)),
        };
        let widest = self.text.access_widths.iter().copied().max().unwrap_or(32);
        if width > u32::from(widest) && !text.device {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Key(at.clone()),
                    format!("no legal access reaches all {width} bits of `{name}`"),
                )
                .also(Spot::Value(Path::root().key("access_widths")), format!("the widest is {widest} bits"))
                .help("describe halves as registers of their own, joined to one value: `joined`"),
            );
        }
        if text.offset.is_none() && !text.device {
            self.find(
                Diagnostic::new(
                    Code::MissingKey,
                    Spot::Key(at.clone()),
                    format!("the register `{name}` has no `offset`"),
                )
                .label("`offset` is missing here")
                .help("only a register of the device, with `device: true`, has no offset"),
            );
        }
        if text.offset.is_some() && text.device {
            self.find(
                Diagnostic::new(
                    Code::Contradiction,
                    Spot::Key(at.key("offset")),
                    format!("`{name}` belongs to the device, so it has no offset in this block"),
                )
                .also(Spot::Key(at.key("device")), "said here"),
            );
        }
        self.check_name(text.name.as_ref(), at);
        let cites = self.cite(text.cite.as_ref(), at);
        let dim = text.array.as_ref().map(|array| self.dim(array, at));
        let offset = text.offset.map(|offset| self.address(offset, &at.key("offset")));
        let window = text.window.as_ref().and_then(|name| self.window_ref(name, &at.key("window")));
        let reset = self.whole_reset(text.reset.as_ref(), name, width, at);
        let outer = Outer {
            name,
            enum_prefix: text.name.as_deref().unwrap_or(name),
            at,
            width,
            access: text.access,
            when: text.when.as_deref(),
            cites: &cites,
            has_reset: reset.is_some(),
            holder: Holder::Register(id),
        };
        let (mut fields, paths) = self.fields(&text.fields, &expanded.origins, &outer);
        let reset = {
            let given = |field: &str| text.fields.get(field).is_some_and(|f| f.reset.is_some());
            self.combine_resets(name, reset, &mut fields, &paths, given, at)
        };
        let register = Register {
            name: name.to_owned(),
            label: text.label.clone().unwrap_or_else(|| name.to_owned()),
            ident: Ident::new(text.name.as_deref().unwrap_or(name)),
            title: text.title.clone(),
            doc: text.doc.clone().unwrap_or_default().trim().to_owned(),
            cites,
            width,
            offset,
            dim,
            cluster,
            window,
            reset,
            capabilities: Capabilities::of(&fields),
            fields,
            unsafe_write: text.unsafe_write.clone(),
            hazards: text.hazards.clone(),
            aliased: !text.no_aliases && !text.device && !self.text.aliases.is_empty(),
        };
        (register, Origin { path: at.clone(), fields: paths })
    }

    pub(super) fn dim(&mut self, array: &syntax::Array, at: &Path) -> Dim {
        let at = at.key("array");
        if array.count == 0 || array.count > MAX_ELEMENTS {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.key("count")),
                    format!("an array cannot have {} elements", array.count),
                )
                .label(format!("has to be 1 to {MAX_ELEMENTS}")),
            );
        }
        let count = array.count.clamp(1, MAX_ELEMENTS);
        let labels = array.labels.clone().unwrap_or_default();
        if !labels.is_empty() && labels.len() != count as usize {
            self.find(
                Diagnostic::new(
                    Code::BadRange,
                    Spot::Key(at.key("labels")),
                    format!("there are {} labels for {} elements", labels.len(), array.count),
                )
                .also(Spot::Value(at.key("count")), "the number of elements")
                .help("name every element, or none"),
            );
        }
        let mut seen = HashMap::new();
        for (index, label) in labels.iter().enumerate() {
            let here = at.key("labels").index(index);
            if let Some(first) = seen.insert(label, here.clone()) {
                self.find(
                    Diagnostic::new(
                        Code::DuplicateName,
                        Spot::Value(here),
                        format!("two elements are called `{label}`"),
                    )
                    .also(Spot::Value(first), "the other one"),
                );
            }
        }
        let stride = self.address(array.stride, &at.key("stride"));
        Dim { count, stride, first: self.first(array.first, &at.key("first")), labels }
    }

    /// Derives the capabilities once the access rules are complete.
    pub(super) fn capabilities(&mut self) {
        for register in &mut self.out.model.registers {
            register.capabilities = Capabilities::of(&register.fields);
        }
    }
}
