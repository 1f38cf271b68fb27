//! The register window that CxCTRL1.WIN selects, and who has selected it (3.0).

use dspic33_ecan_pac::enums::Ctrl1Win;

use super::EcanModel;
use crate::{diagnostic::DiagnosticKind, model::Context, registers::Slot};

/// Which part of the program has changed WIN, and what it expects to find.
#[derive(Clone, Copy, Debug)]
pub(super) struct WindowUse {
    /// The handler that changed it last, or the main program; `None` before the first change.
    changed_by: Option<Option<u64>>,
    /// What the main program selected last.
    main: Ctrl1Win,
    /// The latest change has been reported.
    reported: bool,
}

impl Default for WindowUse {
    fn default() -> Self {
        Self { changed_by: None, main: Ctrl1Win::Buffer, reported: false }
    }
}

impl WindowUse {
    /// The host has written CxCTRL1.
    pub(super) const fn written(&mut self, cx: &Context<'_>, old: Ctrl1Win, new: Ctrl1Win) {
        if cx.handler.is_none() {
            self.main = new;
        }
        if old as u8 != new as u8 {
            self.changed_by = Some(cx.handler);
            self.reported = false;
        }
    }
}

impl EcanModel {
    /// An access to a register that only one window shows. The main program expects the window that it has selected, a
    /// handler the buffer window unless it has selected the other one itself.
    pub(super) fn watch_window(&mut self, cx: &mut Context<'_>, slot: Slot) {
        let Some(window) = self.regs.info(slot).window else { return };
        if self.window.reported || self.window.changed_by.is_none_or(|by| by == cx.handler) {
            return;
        }
        let expected = if cx.handler.is_some() { Ctrl1Win::Buffer } else { self.window.main };
        if self.regs.field(self.n.win) == u32::from(expected.bits()) {
            return;
        }
        self.window.reported = true;
        let (register, window) = (self.regs.name(slot), self.regs.meta().windows[window as usize].name);
        cx.report("3.0", DiagnosticKind::WindowOfAnother { register, window, handler: cx.handler.is_some() });
    }
}
