//! Registers, clusters, windows and reserved ranges.

use indexmap::IndexMap;

use super::fields::{Holder, Outer};
use super::like::Expanded;
use super::{Lowering, Origin};
use crate::diagnostic::{Code, Diagnostic, Spot, suggestion};
use crate::model::{
    Capabilities, Cluster, ClusterId, Dim, Field, FieldReset, Ident, Register, RegisterId, Reset, ReservedRange, Window,
    WindowId, bit_mask,
};
use crate::path::Path;
use crate::syntax;

/// Most elements of an array: none of the controllers has more than 64.
const MAX_ELEMENTS: u32 = 4096;

impl Lowering<'_> {
    pub(super) fn registers(&mut self) {
        let text = self.text;
        self.register_list(&text.registers, &Path::root().key("registers"), None);
        for (index, (name, cluster)) in text.clusters.iter().enumerate() {
            let at = Path::root().key("clusters").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(cluster.cite.as_ref(), &at);
            let Some(dim) = self.dim(&cluster.array, &at) else { continue };
            let id = ClusterId(self.out.model.clusters.len());
            debug_assert!(id.0 <= index);
            self.out.model.clusters.push(Cluster {
                name: name.clone(),
                ident: Ident::new(cluster.name.as_deref().unwrap_or(name)),
                title: cluster.title.clone(),
                doc: cluster.doc.clone().unwrap_or_default(),
                cites,
                offset: cluster.offset.0,
                dim,
            });
            self.register_list(&cluster.registers, &at.key("registers"), Some(id));
        }
    }

    fn register_list(&mut self, list: &IndexMap<String, syntax::Register>, base: &Path, cluster: Option<ClusterId>) {
        for name in list.keys() {
            let at = base.key(name);
            let Some(expanded) = self.expand(name, list, base) else { continue };
            let id = RegisterId(self.out.model.registers.len());
            self.check_identifier(name, &at);
            if !self.declare(|l| &mut l.register_names, name, id, "register", &at) {
                continue;
            }
            let (register, origin) = self.register(id, name, &expanded, &at, cluster);
            for (index, field) in register.fields.iter().enumerate() {
                if let Some(id) = field.enumeration() {
                    let at = crate::model::FieldRef { register: RegisterId(self.out.model.registers.len()), field: index };
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
        if text.offset.is_none() && !text.device {
            self.find(
                Diagnostic::new(Code::MissingKey, Spot::Key(at.clone()), format!("the register `{name}` has no `offset`"))
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
        let cites = self.cite(text.cite.as_ref(), at);
        let dim = text.array.as_ref().and_then(|array| self.dim(array, at));
        let window = text.window.as_ref().and_then(|name| self.window_ref(name, &at.key("window")));
        let reset = text.reset.as_ref().map(|reset| match reset {
            syntax::Reset::Value(value) => Reset { value: value.0, unknown: 0 },
            syntax::Reset::Parts(parts) => Reset { value: parts.value.0, unknown: parts.unknown.0 },
        });
        let capacity = bit_mask(0, width);
        if let Some(reset) = reset
            && (reset.value > capacity || reset.unknown > capacity)
        {
            let wide = reset.value.max(reset.unknown);
            self.find(
                Diagnostic::new(
                    Code::ResetTooWide,
                    Spot::Value(at.key("reset")),
                    format!("the reset {wide:#x} does not fit the {width} bits of `{name}`"),
                )
                .label(format!("the largest value is {capacity:#x}")),
            );
        }
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
        let reset = self.combine_resets(name, reset, &mut fields, &paths, at);
        let register = Register {
            name: name.to_owned(),
            label: text.label.clone().unwrap_or_else(|| name.to_owned()),
            ident: Ident::new(text.name.as_deref().unwrap_or(name)),
            title: text.title.clone(),
            doc: text.doc.clone().unwrap_or_default().trim().to_owned(),
            cites,
            width,
            offset: text.offset.map(|o| o.0),
            dim,
            cluster,
            window,
            reset,
            capabilities: Capabilities::of(&fields),
            fields,
            unsafe_write: text.unsafe_write.clone(),
            hazards: text.hazards.clone(),
            aliased: !text.no_aliases && !text.device,
        };
        (register, Origin { path: at.clone(), fields: paths })
    }

    /// One reset from the register's and the fields'; where both say something they have to agree.
    fn combine_resets(
        &mut self,
        name: &str,
        whole: Option<Reset>,
        fields: &mut [Field],
        paths: &[Path],
        at: &Path,
    ) -> Reset {
        let mut reset = whole.unwrap_or_default();
        for (field, path) in fields.iter_mut().zip(paths) {
            let mask = field.mask();
            let lanes = 0..field.lane_count();
            let spread = |value: u64| lanes.clone().map(|l| value << field.lane_lsb(l)).fold(0, |a, b| a | b);
            let given = self.given_reset(path);
            match (whole, field.reset, given) {
                (None, FieldReset::Value(value), _) => reset.value |= spread(value),
                (None, FieldReset::None(_), _) => reset.unknown |= mask,
                (Some(whole), FieldReset::Value(value), true) => {
                    let said = whole.value & mask;
                    if whole.unknown & mask != 0 || said != spread(value) {
                        let said = (said >> field.lsb) & bit_mask(0, field.width);
                        self.find(
                            Diagnostic::new(
                                Code::ResetContradicts,
                                Spot::Value(path.key("reset")),
                                format!("`{name}.{}` resets to {value:#x} here, but the register's reset has {said:#x}", field.name),
                            )
                            .also(Spot::Value(at.key("reset")), "the register's reset")
                            .help("correct the wrong one, or keep only the one that the manual prints"),
                        );
                    }
                }
                (Some(_), FieldReset::Value(_), false) => {
                    field.reset = match field.reset_of_lane(reset, 0) {
                        Some(value) => FieldReset::Value(value),
                        None => FieldReset::None(crate::model::ResetKind::Unknown),
                    };
                }
                (Some(_), FieldReset::None(_), _) => {
                    reset.unknown |= mask;
                    reset.value &= !mask;
                }
            }
        }
        reset.value &= !reset.unknown;
        let covered = fields.iter().fold(0, |m, f| m | f.mask());
        let stray = (reset.value | whole.map_or(0, |w| w.unknown)) & !covered;
        if stray != 0 && whole.is_some() {
            self.find(
                Diagnostic::new(
                    Code::ResetOutsideFields,
                    Spot::Value(at.key("reset")),
                    format!("the reset of `{name}` sets {}, which no field covers", bit_list(stray)),
                )
                .help("transcribe the field that these bits belong to, or correct the reset"),
            );
        }
        reset
    }

    /// A field at a path gives its own reset.
    fn given_reset(&self, path: &Path) -> bool {
        let keys: Vec<_> = path.to_string().split('/').map(ToOwned::to_owned).collect();
        let find = |list: &IndexMap<String, syntax::Register>, register: &str, field: &str| {
            list.get(register).and_then(|r| r.fields.get(field)).is_some_and(|f| f.reset.is_some())
        };
        match keys.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["registers", register, "fields", field] => find(&self.text.registers, register, field),
            ["clusters", cluster, "registers", register, "fields", field] => {
                self.text.clusters.get(cluster).is_some_and(|c| find(&c.registers, register, field))
            }
            _ => false,
        }
    }

    pub(super) fn dim(&mut self, array: &syntax::Array, at: &Path) -> Option<Dim> {
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
            return None;
        }
        let labels = array.labels.clone().unwrap_or_default();
        if !labels.is_empty() && labels.len() != array.count as usize {
            self.find(
                Diagnostic::new(
                    Code::BadRange,
                    Spot::Value(at.key("labels")),
                    format!("there are {} labels for {} elements", labels.len(), array.count),
                )
                .help("name every element, or none"),
            );
        }
        Some(Dim { count: array.count, stride: array.stride.0, first: array.first, labels })
    }

    pub(super) fn window_names(&mut self) {
        let text = self.text;
        for (index, name) in text.windows.keys().enumerate() {
            self.window_names.insert(name.clone(), WindowId(index));
        }
    }

    fn window_ref(&mut self, name: &str, at: &Path) -> Option<WindowId> {
        if let Some(id) = self.window_names.get(name) {
            return Some(*id);
        }
        let hint = suggestion(name, self.text.windows.keys().map(String::as_str));
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no window `{name}`"))
                .label(hint.unwrap_or_else(|| "unknown window".to_owned()))
                .help("declare it under `windows` with the field that selects it"),
        );
        None
    }

    pub(super) fn windows(&mut self) {
        let text = self.text;
        for (name, window) in &text.windows {
            let at = Path::root().key("windows").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(window.cite.as_ref(), &at);
            let before = self.findings.len();
            let Some(select) = self.field_ref(&window.select, &at.key("select")) else {
                for finding in &mut self.findings[before..] {
                    finding.code = Code::WindowWithoutSelector;
                    finding.title = format!("the window `{name}` has no field that selects it: {}", finding.title);
                }
                continue;
            };
            let field = self.out.model.field(select);
            if window.value.0 > field.capacity() {
                let title = format!("`{}` cannot hold {}", window.select, window.value.0);
                self.find(Diagnostic::new(Code::OutOfRange, Spot::Value(at.key("value")), title));
            }
            self.out.model.windows.push(Window {
                name: name.clone(),
                ident: Ident::new(name),
                select,
                value: window.value.0,
                doc: window.doc.clone(),
                cites,
            });
        }
    }

    pub(super) fn reserved(&mut self) {
        let text = self.text;
        for (index, range) in text.reserved.iter().enumerate() {
            let at = Path::root().key("reserved").index(index);
            let cites = self.cite(range.cite.as_ref(), &at);
            if range.from > range.to {
                self.find(Diagnostic::new(Code::BadRange, Spot::Value(at.key("from")), "the range ends before it starts"));
                continue;
            }
            let window = range.window.as_ref().and_then(|name| self.window_ref(name, &at.key("window")));
            let sets = range.sets.as_ref().and_then(|field| self.field_ref(field, &at.key("sets")));
            self.out.model.reserved.push(ReservedRange {
                from: range.from.0,
                to: range.to.0,
                window,
                reads: range.reads.map(|v| v.0),
                sets,
                doc: range.doc.clone().unwrap_or_default(),
                cites,
            });
        }
        self.out.model.reserved.sort_by_key(|r| r.from);
    }

    /// Derives the capabilities once the access rules are complete.
    pub(super) fn capabilities(&mut self) {
        for register in &mut self.out.model.registers {
            register.capabilities = Capabilities::of(&register.fields);
        }
    }
}

/// "bit 3" or "bits 31:30, 4".
pub(crate) fn bit_list(mask: u64) -> String {
    let mut runs = Vec::new();
    let mut bit = 64;
    while bit > 0 {
        bit -= 1;
        if mask >> bit & 1 == 0 {
            continue;
        }
        let msb = bit;
        while bit > 0 && mask >> (bit - 1) & 1 == 1 {
            bit -= 1;
        }
        runs.push(if msb == bit { msb.to_string() } else { format!("{msb}:{bit}") });
    }
    let word = if mask.count_ones() == 1 { "bit" } else { "bits" };
    format!("{word} {}", runs.join(", "))
}
