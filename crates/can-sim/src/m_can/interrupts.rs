//! Interrupt flags and lines (2.3.16 to 2.3.19, 2.3.43, 2.3.44).

use m_can_pac::registers::Ir;

use super::MCanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// What the lines depend on besides the registers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LineState {
    /// Accesses to reserved addresses so far: pulses of `m_can_aei_ara`.
    pub(super) reserved_accesses: u64,
    /// Flags of which it was reported that nobody hears them.
    unheard: u32,
    /// With the alternative of `per_buffer_enable_gates`: IR.TC and IR.TCF were set by buffers that are enabled.
    signalled: u32,
}

impl MCanModel {
    /// 2.3.16: an event sets a flag, whether it is enabled or not.
    pub(super) fn raise(&mut self, cx: &mut Context<'_>, flags: Ir) {
        let held = self.regs.get(self.r.ir);
        self.regs.set(self.r.ir, held | flags.bits());
        self.hear(cx, flags);
    }

    /// Reports enabled flags that are routed to a line which is not enabled.
    pub(super) fn hear(&mut self, cx: &mut Context<'_>, flags: Ir) {
        let unheard = self.regs.unrouted(self.r.ir) & flags.bits() & !self.lines.unheard;
        if unheard != 0 {
            self.lines.unheard |= unheard;
            let info = self.regs.info(self.r.ir);
            let fields = info.fields.iter().filter(|field| field.all() & unheard != 0);
            let fields = fields.map(|field| field.name).collect();
            cx.report("2.3.18", DiagnosticKind::InterruptUnheard { register: info.name.to_owned(), fields });
        }
    }

    /// 2.3.43, 2.3.44: an event of one Tx Buffer, with the buffer's own enable.
    pub(super) fn raise_for_buffer(&mut self, cx: &mut Context<'_>, flag: Ir, enabled: bool) {
        if enabled {
            self.lines.signalled |= flag.bits();
        }
        if enabled || !self.config.choices.per_buffer_enable_gates_flag {
            self.raise(cx, flag);
        }
    }

    pub(super) fn flags_cleared(&mut self, flags: u32) {
        self.lines.signalled &= !flags;
    }

    pub(super) fn interrupt_lines(&self) -> u32 {
        let per_buffer = Ir::TC.union(Ir::TCF).bits();
        let flags = self.regs.get(self.r.ir);
        if self.config.choices.per_buffer_enable_gates_flag || flags & per_buffer == 0 {
            return self.regs.active_lines();
        }
        // The flags of buffers that are not enabled do not reach the lines.
        let mut shown = self.regs.clone();
        shown.set(self.r.ir, flags & (!per_buffer | self.lines.signalled));
        shown.active_lines()
    }

    /// Pulses of `m_can_aei_ara` so far (2.2.1).
    #[must_use]
    pub const fn reserved_accesses(&self) -> u64 {
        self.lines.reserved_accesses
    }
}
