//! Where every register lies in the C struct.
//!
//! Arrays whose elements touch become C arrays. Arrays with gaps become arrays of a struct; arrays of equal count
//! and distance that lie in each other's gaps, such as identifier and mask registers in turn, share it. An array
//! that something else reaches into is unrolled and reached by address.

use std::collections::HashMap;

use regdef::model::{Alias, ClusterId, Model, Register, RegisterId, WindowId};

/// A member of a struct.
#[derive(Debug, Clone)]
pub(super) struct Slot {
    /// Byte offset in the struct.
    pub(super) offset: u64,
    /// Bytes it takes.
    pub(super) bytes: u64,
    /// Name of the member.
    pub(super) name: String,
    /// What it is.
    pub(super) kind: SlotKind,
}

/// What a member is.
#[derive(Debug, Clone)]
pub(super) enum SlotKind {
    /// A register, or an array of registers without gaps.
    Register { width: u32, read_only: bool, count: Option<u32>, title: String },
    /// An array of structs.
    Group { count: u32, stride: u64, title: String, type_name: String, members: Vec<Slot> },
    /// One struct for each window, at the same place.
    Windows(Vec<(WindowId, Vec<Slot>)>),
}

/// How a register is reached from the pointer `regs` and the manual's number `n`.
#[derive(Debug, Clone)]
pub(super) struct Reach {
    /// The lvalue of the register; of an alias with the alias's name behind it.
    pub(super) lvalue: String,
    /// The first number and the count, for an array.
    pub(super) index: Option<(u32, u32)>,
    /// By address instead of by member: byte offset and distance.
    pub(super) address: Option<(u64, u64)>,
}

/// The whole block.
pub(super) struct Layout {
    pub(super) slots: Vec<Slot>,
    pub(super) reach: HashMap<RegisterId, Reach>,
}

/// A candidate for a member, with the window it is visible in.
struct Item {
    window: Option<WindowId>,
    slot: Slot,
}

impl Layout {
    pub(super) fn new(model: &Model) -> Self {
        let mut build = Build { model, reach: HashMap::new(), in_cluster: false, unions: union_starts(model) };
        let registers: Vec<RegisterId> = model.block_registers().map(|(id, _)| id).collect();
        let clusters: Vec<ClusterId> = (0..model.clusters.len()).map(ClusterId).collect();
        let items = build.items(&registers, &clusters, "regs->");
        let slots = build.windows(items);
        Self { slots, reach: build.reach }
    }
}

struct Build<'m> {
    model: &'m Model,
    reach: HashMap<RegisterId, Reach>,
    /// The members of a cluster are in its element, whatever the window.
    in_cluster: bool,
    /// Offsets at which a union of windows begins.
    unions: Vec<u64>,
}

/// Offsets at which registers of windows begin after registers that are in no window.
fn union_starts(model: &Model) -> Vec<u64> {
    let registers = model.block_registers().filter_map(|(_, r)| r.offset.map(|offset| (offset, r.window.is_some())));
    let clusters = model.clusters.iter().enumerate().map(|(index, cluster)| {
        let windowed = model.cluster_registers(ClusterId(index)).any(|(_, r)| r.window.is_some());
        (cluster.offset, windowed)
    });
    let mut places: Vec<(u64, bool)> = registers.chain(clusters).collect();
    places.sort_unstable();
    let before = std::iter::once(false).chain(places.iter().map(|(_, windowed)| *windowed));
    places.iter().zip(before).filter(|((_, windowed), before)| *windowed && !before).map(|((at, _), _)| *at).collect()
}

/// Name of the union that begins as the `number`th.
fn union_name(number: usize) -> String {
    if number == 0 { "WINDOW".to_owned() } else { format!("WINDOW{number}") }
}

impl Build<'_> {
    fn items(&mut self, registers: &[RegisterId], clusters: &[ClusterId], prefix: &str) -> Vec<Item> {
        let mut items: Vec<Item> = clusters.iter().map(|&id| self.cluster(id)).collect();
        let mut arrays: Vec<RegisterId> = Vec::new();
        for &id in registers {
            let register = self.model.register(id);
            let Some(offset) = register.offset else { continue };
            match &register.dim {
                None => {
                    let name = member(register);
                    self.put(id, &format!("{prefix}{}{name}", self.view(register)), None);
                    items.extend(self.with_aliases(register, &name, offset));
                }
                Some(dim) if dim.stride == u64::from(register.width / 8) && !self.aliased(register) => {
                    let name = member(register);
                    let index = index_expression(dim.first);
                    self.put(
                        id,
                        &format!("{prefix}{}{name}[{index}]", self.view(register)),
                        Some((dim.first, dim.count)),
                    );
                    items.push(Item { window: register.window, slot: slot(register, &name, offset, Some(dim.count)) });
                }
                Some(_) => arrays.push(id),
            }
        }
        while let Some(&lead) = arrays.first() {
            let group = self.interleaved(lead, &arrays);
            arrays.retain(|id| !group.contains(id));
            match self.group(&group, &items, &arrays, prefix) {
                Some(item) => items.push(item),
                None => group.iter().for_each(|&id| self.unroll(id, &mut items)),
            }
        }
        items
    }

    /// The arrays that repeat together with `lead`.
    fn interleaved(&self, lead: RegisterId, arrays: &[RegisterId]) -> Vec<RegisterId> {
        let of = |id: RegisterId| {
            let register = self.model.register(id);
            let dim = register.dim.as_ref();
            (register.window, dim.map(|d| (d.count, d.stride, d.first)))
        };
        let base = self.model.register(lead).offset.unwrap_or(0);
        let stride = self.model.register(lead).dim.as_ref().map_or(0, |d| d.stride);
        let near = |id: &RegisterId| self.model.register(*id).offset.unwrap_or(0).abs_diff(base) < stride;
        arrays.iter().copied().filter(|id| of(*id) == of(lead) && near(id)).collect()
    }

    /// An array of structs for arrays that repeat together, unless something else reaches into it.
    fn group(&mut self, ids: &[RegisterId], items: &[Item], others: &[RegisterId], prefix: &str) -> Option<Item> {
        let lead = self.model.register(*ids.first()?);
        let dim = lead.dim.as_ref()?;
        let base = ids.iter().filter_map(|&id| self.model.register(id).offset).min()?;
        let end = base + dim.stride * u64::from(dim.count);
        let inside = |window: Option<WindowId>, start: u64, bytes: u64| {
            let same = window.is_none() || lead.window.is_none() || window == lead.window;
            same && start < end && base < start + bytes
        };
        let names: Vec<String> = ids.iter().map(|&id| member(self.model.register(id))).collect();
        let mut members = Vec::new();
        for (&id, name) in ids.iter().zip(&names) {
            let register = self.model.register(id);
            members
                .extend(self.with_aliases(register, name, register.offset? - base).into_iter().map(|item| item.slot));
        }
        members.sort_by_key(|member| member.offset);
        let overlap = members.windows(2).any(|pair| pair[0].offset + pair[0].bytes > pair[1].offset);
        let too_long = members.last().is_some_and(|last| last.offset + last.bytes > dim.stride);
        let disturbed = items.iter().any(|item| inside(item.window, item.slot.offset, item.slot.bytes))
            || others.iter().any(|&id| {
                let register = self.model.register(id);
                let bytes = register.dim.as_ref().map_or(0, |d| d.stride * u64::from(d.count));
                register.offset.is_some_and(|offset| inside(register.window, offset, bytes))
            });
        if overlap || too_long || disturbed {
            return None;
        }
        let name = common_start(&names);
        let index = index_expression(dim.first);
        for (&id, member) in ids.iter().zip(&names) {
            let view = self.view(self.model.register(id));
            self.put(id, &format!("{prefix}{view}{name}[{index}].{member}"), Some((dim.first, dim.count)));
        }
        let kind = SlotKind::Group {
            count: dim.count,
            stride: dim.stride,
            title: lead.title.clone(),
            type_name: String::new(),
            members,
        };
        let slot = Slot { offset: base, bytes: end - base, name, kind };
        Some(Item { window: lead.window, slot })
    }

    /// One member for each element; functions reach them by address.
    fn unroll(&mut self, id: RegisterId, items: &mut Vec<Item>) {
        let register = self.model.register(id);
        let (Some(offset), Some(dim)) = (register.offset, &register.dim) else { return };
        for element in 0..dim.count {
            let name = identifier(&register.label_of(dim, element));
            items.extend(self.with_aliases(register, &name, offset + dim.stride * u64::from(element)));
        }
        let reach =
            Reach { lvalue: String::new(), index: Some((dim.first, dim.count)), address: Some((offset, dim.stride)) };
        self.reach.insert(id, reach);
    }

    fn cluster(&mut self, id: ClusterId) -> Item {
        let cluster = &self.model.clusters[id.0];
        let registers: Vec<RegisterId> = self.model.cluster_registers(id).map(|(id, _)| id).collect();
        let window = registers.first().and_then(|&id| self.model.register(id).window);
        let name = cluster.ident.upper.clone();
        let view = window.map_or_else(String::new, |window| self.view_of(window, cluster.offset));
        let prefix = format!("regs->{view}{name}[{}].", index_expression(cluster.dim.first));
        let mut build = Build { model: self.model, reach: HashMap::new(), in_cluster: true, unions: Vec::new() };
        let members = build.items(&registers, &[], &prefix);
        let index = Some((cluster.dim.first, cluster.dim.count));
        // An array inside the element would need a second number; only its element as a member reaches it.
        let whole = build.reach.into_iter().filter(|(id, _)| self.model.register(*id).dim.is_none());
        self.reach.extend(whole.map(|(id, reach)| (id, Reach { index, ..reach })));
        let mut members: Vec<Slot> = members.into_iter().map(|item| item.slot).collect();
        members.sort_by_key(|member| member.offset);
        let type_name = format!("{}_{}_t", self.model.names.ident.upper, cluster.ident.upper).to_ascii_lowercase();
        let kind = SlotKind::Group {
            count: cluster.dim.count,
            stride: cluster.dim.stride,
            title: cluster.title.clone(),
            type_name,
            members,
        };
        let bytes = cluster.dim.stride * u64::from(cluster.dim.count);
        Item { window, slot: Slot { offset: cluster.offset, bytes, name, kind } }
    }

    /// Puts windows that share addresses over each other; the result is in order of address.
    fn windows(&self, mut items: Vec<Item>) -> Vec<Slot> {
        items.sort_by_key(|item| (item.slot.offset, item.window));
        let mut slots: Vec<Slot> = Vec::new();
        let mut run: Vec<Item> = Vec::new();
        let mut unions = 0;
        let flush = |run: &mut Vec<Item>, slots: &mut Vec<Slot>, unions: &mut usize| {
            let Some(base) = run.first().map(|item| item.slot.offset) else { return };
            let end = run.iter().map(|item| item.slot.offset + item.slot.bytes).max().unwrap_or(base);
            let mut views: Vec<(WindowId, Vec<Slot>)> = Vec::new();
            for mut item in run.drain(..) {
                item.slot.offset -= base;
                let Some(window) = item.window else { continue };
                match views.iter_mut().find(|(id, _)| *id == window) {
                    Some((_, view)) => view.push(item.slot),
                    None => views.push((window, vec![item.slot])),
                }
            }
            views.sort_by_key(|(window, _)| *window);
            let name = union_name(*unions);
            *unions += 1;
            slots.push(Slot { offset: base, bytes: end - base, name, kind: SlotKind::Windows(views) });
        };
        for item in items {
            if item.window.is_some() {
                run.push(item);
            } else {
                flush(&mut run, &mut slots, &mut unions);
                slots.push(item.slot);
            }
        }
        flush(&mut run, &mut slots, &mut unions);
        slots
    }

    fn aliased(&self, register: &Register) -> bool {
        register.aliased && !self.model.aliases.is_empty()
    }

    fn with_aliases(&self, register: &Register, name: &str, offset: u64) -> Vec<Item> {
        let mut items = vec![Item { window: register.window, slot: slot(register, name, offset, None) }];
        let aliases: &[Alias] = if register.aliased { &self.model.aliases } else { &[] };
        for alias in aliases {
            let mut slot = slot(register, &format!("{name}{}", alias.name), offset + alias.offset, None);
            if let SlotKind::Register { read_only, title, .. } = &mut slot.kind {
                *read_only = false;
                title.clear();
            }
            items.push(Item { window: register.window, slot });
        }
        items
    }

    fn put(&mut self, id: RegisterId, lvalue: &str, index: Option<(u32, u32)>) {
        self.reach.insert(id, Reach { lvalue: lvalue.to_owned(), index, address: None });
    }

    /// The part of the path that leads into the register's window.
    fn view(&self, register: &Register) -> String {
        match (register.window, register.offset) {
            (Some(window), Some(offset)) if !self.in_cluster => self.view_of(window, offset),
            _ => String::new(),
        }
    }

    fn view_of(&self, window: WindowId, offset: u64) -> String {
        let number = self.unions.iter().filter(|start| **start <= offset).count().saturating_sub(1);
        format!("{}.{}.", union_name(number), self.model.windows[window.0].ident.upper)
    }
}

fn slot(register: &Register, name: &str, offset: u64, count: Option<u32>) -> Slot {
    let kind = SlotKind::Register {
        width: register.width,
        read_only: !register.capabilities.writable,
        count,
        title: register.title.clone(),
    };
    Slot { offset, bytes: u64::from(register.width / 8) * u64::from(count.unwrap_or(1)), name: name.to_owned(), kind }
}

fn member(register: &Register) -> String {
    identifier(&register.name)
}

/// A name in the manual's spelling as far as C allows it.
pub(super) fn identifier(name: &str) -> String {
    let text: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let text = text.trim_end_matches('_');
    if text.starts_with(|c: char| c.is_ascii_digit()) { format!("_{text}") } else { text.to_owned() }
}

fn index_expression(first: u32) -> String {
    if first == 0 { "n".to_owned() } else { format!("n - {first}U") }
}

/// What all names begin with, or the first name if that is nothing.
fn common_start(names: &[String]) -> String {
    let Some(first) = names.first() else { return String::new() };
    if names.len() == 1 {
        return first.clone();
    }
    let same = |at: usize| names.iter().all(|name| name.as_bytes().get(at) == first.as_bytes().get(at));
    let length = (0..first.len()).take_while(|&at| same(at)).count();
    let start = first[..length].trim_end_matches('_');
    if start.is_empty() { first.clone() } else { start.to_owned() }
}
