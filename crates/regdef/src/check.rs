//! Checks over the lowered model.

use crate::diagnostic::Diagnostic;
use crate::lower::Lowered;

pub(crate) fn check(_lowered: &Lowered, _findings: &mut Vec<Diagnostic>) {}
