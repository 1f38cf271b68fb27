//! Reserved ranges are inside the block and hold no register, and what is neither is a gap.

use super::Taken;
use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::WindowId;
use crate::path::Path;

/// Most gaps that one finding lists.
const MAX_LISTED: usize = 8;

/// A register has at most this many bytes, so that one that starts earlier does not reach a range.
const WIDEST: u64 = 4;

pub(super) fn ranges(lowered: &Lowered, all: &[Taken], findings: &mut Findings) {
    let model = &lowered.model;
    let meet = |a: Option<WindowId>, b: Option<WindowId>| a.is_none() || b.is_none() || a == b;
    for (index, (range, (_, at))) in model.reserved.iter().zip(&lowered.reserved).enumerate() {
        let named = format!("{:#05x} to {:#05x}", range.from, range.to);
        if range.to >= model.span {
            findings.push(
                Diagnostic::new(
                    Code::OutsideBlock,
                    Spot::Value(at.key("to")),
                    format!("the reserved range {named} ends outside the block of {:#x} bytes", model.span),
                )
                .also(Spot::Value(Path::root().key("span")), "the size of the block")
                .help("shorten the range, or enlarge `span`"),
            );
        }
        let earlier =
            model.reserved[..index].iter().position(|other| other.to >= range.from && meet(other.window, range.window));
        if let Some(other) = earlier {
            findings.push(
                Diagnostic::new(
                    Code::RegisterOverlap,
                    Spot::Value(at.key("from")),
                    format!("the reserved range {named} starts inside another one"),
                )
                .also(Spot::Value(lowered.reserved[other].1.key("to")), "the other one ends here")
                .help("make one range of them, or correct the bounds"),
            );
        }
        let start = all.partition_point(|taken| taken.from + WIDEST <= range.from);
        let end = all.partition_point(|taken| taken.from <= range.to);
        let clash = all[start..end].iter().find(|taken| taken.to >= range.from && meet(taken.window, range.window));
        if let Some(taken) = clash {
            let path = &lowered.registers[taken.placed.register.0].path;
            findings.push(
                Diagnostic::new(
                    Code::RegisterOverlap,
                    Spot::Value(path.key("offset")),
                    format!("`{}` lies in the reserved range {named}", taken.name(model)),
                )
                .label(format!("`{}` is at {:#x} to {:#x}", taken.name(model), taken.from, taken.to))
                .also(Spot::Value(at.key("from")), "the reserved range")
                .help("correct the offset, or shorten the range"),
            );
        }
    }
    gaps(lowered, all, findings);
}

/// Every byte of the block is a register's or reserved, in every window.
fn gaps(lowered: &Lowered, all: &[Taken], findings: &mut Findings) {
    let model = &lowered.model;
    let views: Vec<Option<WindowId>> = if model.windows.is_empty() {
        vec![None]
    } else {
        (0..model.windows.len()).map(|i| Some(WindowId(i))).collect()
    };
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
        let more = holes.len().saturating_sub(MAX_LISTED);
        let list = holes
            .iter()
            .take(MAX_LISTED)
            .map(|(from, to)| format!("{from:#05x} to {to:#05x}"))
            .collect::<Vec<_>>()
            .join(", ");
        let place = view.map_or(String::new(), |id| format!(" in the window `{}`", model.windows[id.0].name));
        findings.push(
            Diagnostic::new(
                Code::Gap,
                Spot::Value(Path::root().key("span")),
                format!(
                    "nothing is said about the bytes {list}{}{place}",
                    if more > 0 { format!(" and {more} more ranges") } else { String::new() }
                ),
            )
            .help("list them under `reserved`, with what an access does, or transcribe the missing registers"),
        );
    }
}
