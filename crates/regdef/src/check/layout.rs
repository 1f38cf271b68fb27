//! Registers are aligned, inside the block, apart from each other, and leave no unexplained gap.

mod reserved;

use std::collections::HashSet;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::{Dim, Model, Placed, RegisterId, WindowId};
use crate::path::Path;

pub(super) fn registers(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let mut fine = true;
    for (index, register) in model.registers.iter().enumerate() {
        let path = &lowered.registers[index].path;
        let bytes = u64::from(register.width / 8);
        let reach = if register.aliased {
            bytes + model.aliases.iter().map(|alias| alias.offset).max().unwrap_or(0)
        } else {
            bytes
        };
        if let Some(dim) = &register.dim
            && dim.count > 1
            && dim.stride < reach
        {
            let with = if reach > bytes { " with its aliases" } else { "" };
            fine = false;
            findings.push(
                Diagnostic::new(
                    Code::StrideTooSmall,
                    Spot::Value(path.key("array").key("stride")),
                    format!(
                        "the stride of `{}` is {}, but an element takes {reach} bytes{with}",
                        register.name, dim.stride
                    ),
                )
                .label(format!("has to be at least {reach}")),
            );
        }
        let Some(offset) = register.offset else { continue };
        let cluster = register.cluster.map(|id| &model.clusters[id.0]);
        let misaligned = [
            Some((offset, Spot::Value(path.key("offset")), "offset")),
            register.dim.as_ref().map(|dim| (dim.stride, Spot::Value(path.key("array").key("stride")), "stride")),
        ];
        for (value, at, what) in misaligned.into_iter().flatten().filter(|(value, ..)| value % bytes != 0) {
            fine = false;
            findings.push(
                Diagnostic::new(
                    Code::Misaligned,
                    at,
                    format!("the {what} {value:#x} of `{}` is not a multiple of its {bytes} bytes", register.name),
                )
                .help(format!(
                    "the nearest aligned values are {:#x} and {:#x}",
                    value - value % bytes,
                    value - value % bytes + bytes
                )),
            );
        }
        if let Some(cluster) = cluster {
            let end = offset + reach + span(register.dim.as_ref());
            if cluster.dim.count > 1 && end > cluster.dim.stride {
                fine = false;
                findings.push(
                    Diagnostic::new(
                        Code::StrideTooSmall,
                        Spot::Value(Path::root().key("clusters").key(&cluster.name).key("array").key("stride")),
                        format!(
                            "`{}` ends at byte {end:#x} of `{}`, past the stride {:#x}",
                            register.name, cluster.name, cluster.dim.stride
                        ),
                    )
                    .also(Spot::Value(path.key("offset")), "this register"),
                );
            }
        }
    }
    // What follows would repeat the same mistakes in other words, or cannot be counted.
    if fine && countable(lowered, findings) && lowered.windows_known {
        let all = taken(model);
        overlaps(lowered, &all, findings);
        reserved::ranges(lowered, &all, findings);
    }
}

fn span(dim: Option<&Dim>) -> u64 {
    dim.map_or(0, |dim| dim.stride * u64::from(dim.count - 1))
}

/// A run of bytes that one register or alias occupies.
struct Taken {
    from: u64,
    to: u64,
    placed: Placed,
    window: Option<WindowId>,
    alias: Option<usize>,
}

impl Taken {
    fn name(&self, model: &Model) -> String {
        let label = self.placed.label(model);
        self.alias.map_or(label.clone(), |alias| format!("{label}{}", model.aliases[alias].name))
    }
}

fn taken(model: &Model) -> Vec<Taken> {
    let mut all = Vec::new();
    for placed in model.instances_of_registers() {
        let register = model.register(placed.register);
        let bytes = u64::from(register.width / 8);
        let mut add = |from: u64, alias| {
            all.push(Taken { from, to: from + bytes - 1, placed, window: register.window, alias });
        };
        add(placed.offset, None);
        if register.aliased {
            for (index, alias) in model.aliases.iter().enumerate() {
                add(placed.offset + alias.offset, Some(index));
            }
        }
    }
    all.sort_by_key(|t| t.from);
    all
}

/// Most registers with all elements of arrays and clusters, aliases included.
const MAX_REGISTERS: u64 = 1 << 16;

/// The registers are few enough to be looked at one by one.
fn countable(lowered: &Lowered, findings: &mut Findings) -> bool {
    let model = &lowered.model;
    let mut total = 0;
    for (register, origin) in model.registers.iter().zip(&lowered.registers) {
        let outer = register.cluster.map_or(1, |id| u64::from(model.clusters[id.0].dim.count));
        let inner = register.dim.as_ref().map_or(1, |dim| u64::from(dim.count));
        let aliases = if register.aliased { model.aliases.len() as u64 } else { 0 };
        total += outer * inner * (1 + aliases);
        if total > MAX_REGISTERS {
            findings.push(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Key(origin.path.clone()),
                    format!("the arrays and clusters make more than {MAX_REGISTERS} registers"),
                )
                .label("counted up to here")
                .help("check the numbers of elements; no controller has so many registers"),
            );
            return false;
        }
    }
    true
}

fn overlaps(lowered: &Lowered, all: &[Taken], findings: &mut Findings) {
    let model = &lowered.model;
    let mut reported = HashSet::<(RegisterId, RegisterId)>::new();
    let mut outside = HashSet::<RegisterId>::new();
    // Registers that reach up to the one that is looked at.
    let mut active: Vec<&Taken> = Vec::new();
    for next in all {
        let path = &lowered.registers[next.placed.register.0].path;
        if next.to >= model.span && outside.insert(next.placed.register) {
            findings.push(
                Diagnostic::new(
                    Code::OutsideBlock,
                    Spot::Value(path.key("offset")),
                    format!(
                        "`{}` ends at {:#x}, outside the block of {:#x} bytes",
                        next.name(model),
                        next.to,
                        model.span
                    ),
                )
                .also(Spot::Value(Path::root().key("span")), "the size of the block")
                .help("correct the offset or the repetition, or enlarge `span`"),
            );
        }
        active.retain(|one| one.to >= next.from);
        let meets = |one: &&&Taken| one.window.is_none() || next.window.is_none() || one.window == next.window;
        let Some(one) = active.iter().find(meets) else {
            active.push(next);
            continue;
        };
        if reported.insert((one.placed.register, next.placed.register)) {
            findings.push(overlap(lowered, one, next));
        }
        if next.to > one.to {
            active.push(next);
        }
    }
}

fn overlap(lowered: &Lowered, one: &Taken, next: &Taken) -> Diagnostic {
    let model = &lowered.model;
    let path = |taken: &Taken| lowered.registers[taken.placed.register.0].path.key("offset");
    // The one that stands further down in the file is the one to look at first.
    let (first, second) = if one.placed.register <= next.placed.register { (one, next) } else { (next, one) };
    let is_array = |taken: &Taken| {
        let register = model.register(taken.placed.register);
        register.dim.is_some() || register.cluster.is_some()
    };
    let code = if is_array(one) || is_array(next) { Code::ArrayOverlap } else { Code::RegisterOverlap };
    let shared = if one.from == next.from && one.to == next.to {
        format!("are both at {:#x}", one.from)
    } else {
        format!("share the bytes {:#x} to {:#x}", next.from, one.to.min(next.to))
    };
    let place = |taken: &Taken| format!("`{}` is at {:#x} to {:#x}", taken.name(model), taken.from, taken.to);
    let finding = Diagnostic::new(
        code,
        Spot::Value(path(second)),
        format!("`{}` and `{}` {shared}", first.name(model), second.name(model)),
    )
    .label(place(second));
    let finding =
        if path(first) == path(second) { finding } else { finding.also(Spot::Value(path(first)), place(first)) };
    match (first.alias.is_some() || second.alias.is_some(), code) {
        (true, _) => {
            finding.help("an alias register stands beside each; `no_aliases: true` takes them from a register")
        }
        (_, Code::ArrayOverlap) => finding.help("check the number of elements and the stride of the array or cluster"),
        _ => finding.help("correct one offset; registers share an address only in different windows"),
    }
}
