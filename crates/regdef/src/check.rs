//! Checks over the lowered model. Each module establishes one thing.

mod citations;
mod identifiers;
mod layout;
mod locks;
mod overlap;
mod usage;
mod values;

use crate::diagnostic::Findings;
use crate::lower::Lowered;

pub(crate) fn check(lowered: &Lowered, findings: &mut Findings) {
    overlap::fields(lowered, findings);
    layout::registers(lowered, findings);
    identifiers::clashes(lowered, findings);
    values::resets(lowered, findings);
    values::enumerations(lowered, findings);
    citations::present(lowered, findings);
    locks::conditions(lowered, findings);
    usage::unused(lowered, findings);
}
