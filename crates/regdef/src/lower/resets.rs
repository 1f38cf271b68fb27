//! Resets of registers and fields.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{Field, FieldReset, Reset, ResetKind, bit_mask};
use crate::path::Path;
use crate::syntax;

impl Lowering<'_> {
    /// The reset that a register gives as a whole.
    pub(super) fn whole_reset(
        &mut self,
        text: Option<&syntax::Reset>,
        name: &str,
        width: u32,
        at: &Path,
    ) -> Option<Reset> {
        let (reset, at) = match text? {
            syntax::Reset::Value(value) => (Reset { value: value.0, unknown: 0 }, at.key("reset")),
            syntax::Reset::Parts(parts) => {
                (Reset { value: parts.value.0, unknown: parts.unknown.0 }, at.key("reset").key("value"))
            }
        };
        let capacity = bit_mask(0, width);
        for (value, at) in [(reset.value, at.clone()), (reset.unknown, at.parent().key("unknown"))] {
            if value > capacity {
                self.find(
                    Diagnostic::new(
                        Code::ResetTooWide,
                        Spot::Value(at),
                        format!("the reset {value:#x} does not fit the {width} bits of `{name}`"),
                    )
                    .label(format!("has to be at most {capacity:#x}")),
                );
            }
        }
        if reset.value & reset.unknown != 0 {
            self.find(
                Diagnostic::new(
                    Code::Contradiction,
                    Spot::Value(at),
                    format!(
                        "the reset of `{name}` gives {} a value, but they are unknown",
                        bit_list(reset.value & reset.unknown)
                    ),
                )
                .label("has to be 0 in the unknown bits"),
            );
        }
        Some(Reset { value: reset.value & capacity, unknown: reset.unknown & capacity })
    }

    /// One reset from the register's and the fields'; where both say something they have to agree.
    pub(super) fn combine_resets(
        &mut self,
        name: &str,
        whole: Option<Reset>,
        fields: &mut [Field],
        paths: &[Path],
        given: impl Fn(&str) -> bool,
        at: &Path,
    ) -> Reset {
        let mut reset = whole.unwrap_or_default();
        for (field, path) in fields.iter_mut().zip(paths) {
            let mask = field.mask();
            let lanes = 0..field.lane_count();
            let spread = |value: u64| lanes.clone().map(|l| value << field.lane_lsb(l)).fold(0, |a, b| a | b);
            let given = given(&field.name);
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
                                format!(
                                    "`{name}.{}` resets to {value:#x} here, but the register's reset has {said:#x}",
                                    field.name
                                ),
                            )
                            .also(Spot::Value(at.key("reset")), "the register's reset")
                            .help("correct the wrong one, or keep only the one that the manual prints"),
                        );
                    }
                }
                (Some(_), FieldReset::Value(_), false) => {
                    field.reset = match field.reset_of_lane(reset, 0) {
                        Some(value) => FieldReset::Value(value),
                        None => FieldReset::None(ResetKind::Unknown),
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
