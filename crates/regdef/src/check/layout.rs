//! Registers are aligned, inside the block, apart from each other, and leave no unexplained gap.

use std::collections::HashSet;

use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::lower::Lowered;
use crate::model::{Dim, Model, Placed, RegisterId, WindowId};
use crate::path::Path;

pub(super) fn registers(lowered: &Lowered, findings: &mut Vec<Diagnostic>) {
    let model = &lowered.model;
    let before = findings.len();
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
            findings.push(
                Diagnostic::new(
                    Code::StrideTooSmall,
                    Spot::Value(path.key("array").key("stride")),
                    format!("the stride of `{}` is {}, but an element takes {reach} bytes{with}", register.name, dim.stride),
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
            findings.push(
                Diagnostic::new(
                    Code::Misaligned,
                    at,
                    format!("the {what} {value:#x} of `{}` is not a multiple of its {bytes} bytes", register.name),
                )
                .help(format!("the nearest aligned values are {:#x} and {:#x}", value - value % bytes, value - value % bytes + bytes)),
            );
        }
        if let Some(cluster) = cluster {
            let end = offset + reach + span(register.dim.as_ref());
            if cluster.dim.count > 1 && end > cluster.dim.stride {
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
    if findings.len() > before {
        return;
    }
    overlaps(lowered, findings);
    gaps(lowered, findings);
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

fn overlaps(lowered: &Lowered, findings: &mut Vec<Diagnostic>) {
    let model = &lowered.model;
    let all = taken(model);
    let mut reported = HashSet::<(RegisterId, RegisterId)>::new();
    for (index, one) in all.iter().enumerate() {
        let path = &lowered.registers[one.placed.register.0].path;
        if one.to >= model.span {
            if reported.insert((one.placed.register, one.placed.register)) {
                findings.push(
                    Diagnostic::new(
                        Code::OutsideBlock,
                        Spot::Value(path.key("offset")),
                        format!("`{}` ends at {:#x}, outside the block of {:#x} bytes", one.name(model), one.to, model.span),
                    )
                    .also(Spot::Value(Path::root().key("span")), "the block's size"),
                );
            }
            continue;
        }
        for other in all[index + 1..].iter().take_while(|other| other.from <= one.to) {
            let apart = matches!((one.window, other.window), (Some(a), Some(b)) if a != b);
            if apart || !reported.insert((one.placed.register, other.placed.register)) {
                continue;
            }
            let second = &lowered.registers[other.placed.register.0].path;
            let is_array = |t: &Taken| {
                let register = model.register(t.placed.register);
                register.dim.is_some() || register.cluster.is_some()
            };
            let code = if is_array(one) || is_array(other) { Code::ArrayOverlap } else { Code::RegisterOverlap };
            let shared = if one.from == other.from && one.to == other.to {
                format!("are both at {:#x}", one.from)
            } else {
                format!("share the bytes {:#x} to {:#x}", other.from, one.to.min(other.to))
            };
            findings.push(
                Diagnostic::new(
                    code,
                    Spot::Value(second.key("offset")),
                    format!("`{}` and `{}` {shared}", one.name(model), other.name(model)),
                )
                .label(format!("`{}` is at {:#x}", other.name(model), other.from))
                .also(Spot::Value(path.key("offset")), format!("`{}` is at {:#x}", one.name(model), one.from))
                .help("registers share an address only in different windows"),
            );
        }
    }
}

/// Every byte of the block is a register's or reserved, in every window.
fn gaps(lowered: &Lowered, findings: &mut Vec<Diagnostic>) {
    let model = &lowered.model;
    let views: Vec<Option<WindowId>> =
        if model.windows.is_empty() { vec![None] } else { (0..model.windows.len()).map(|i| Some(WindowId(i))).collect() };
    let all = taken(model);
    for view in views {
        let visible = |window: Option<WindowId>| window.is_none() || window == view;
        let mut runs: Vec<(u64, u64)> = all.iter().filter(|t| visible(t.window)).map(|t| (t.from, t.to)).collect();
        runs.extend(model.reserved.iter().filter(|r| visible(r.window)).map(|r| (r.from, r.to)));
        runs.sort_unstable();
        let mut next = 0;
        let mut holes = Vec::new();
        for (from, to) in runs {
            if from > next {
                holes.push((next, from - 1));
            }
            next = next.max(to + 1);
        }
        if next < model.span {
            holes.push((next, model.span - 1));
        }
        if holes.is_empty() {
            continue;
        }
        let list = holes.iter().map(|(from, to)| format!("{from:#05x} to {to:#05x}")).collect::<Vec<_>>().join(", ");
        let place = view.map_or(String::new(), |id| format!(" in the window `{}`", model.windows[id.0].name));
        findings.push(
            Diagnostic::new(
                Code::Gap,
                Spot::Value(Path::root().key("span")),
                format!("nothing is said about the bytes {list}{place}"),
            )
            .help("list them under `reserved`, with what an access does, or transcribe the missing registers"),
        );
    }
    for range in &model.reserved {
        let clash = all.iter().find(|t| {
            let windows_meet = t.window.is_none() || range.window.is_none() || t.window == range.window;
            windows_meet && t.from <= range.to && range.from <= t.to
        });
        if let Some(taken) = clash {
            let path = &lowered.registers[taken.placed.register.0].path;
            findings.push(
                Diagnostic::new(
                    Code::RegisterOverlap,
                    Spot::Value(path.key("offset")),
                    format!("`{}` lies in the reserved range {:#05x} to {:#05x}", taken.name(model), range.from, range.to),
                )
                .help("correct the offset, or shorten the range"),
            );
        }
    }
}
