//! Values that a driver has read and writes back over what hardware has changed since: flags that a 0 clears, and the
//! control bits that two transmit buffers share (9.2.5, 8.1).

use regbus::meta::Access;

use super::{EcanModel, modes::is_off, names::Role};
use crate::{
    diagnostic::DiagnosticKind,
    model::Context,
    registers::{Slot, WriteAccess},
};

/// What the host knows of the registers that hardware changes under its hands: what it read, or wrote, last.
#[derive(Clone, Debug, Default)]
pub(super) struct Known {
    values: Vec<Option<u32>>,
}

impl Known {
    pub(super) fn learn(&mut self, slot: Slot, value: u32) {
        let index = slot.0 as usize;
        if self.values.len() <= index {
            self.values.resize(index + 1, None);
        }
        self.values[index] = Some(value);
    }

    fn get(&self, slot: Slot) -> Option<u32> {
        self.values.get(slot.0 as usize).copied().flatten()
    }
}

impl EcanModel {
    /// A write to such a register, before the host's knowledge of it is brought up to date.
    pub(super) fn watch_stale_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess, role: Role) {
        let Some(known) = self.known.get(access.slot) else { return };
        let bits = match role {
            // Off the bus nothing rises unseen: what is cleared is meant.
            _ if is_off(self.modes.now) => 0,
            Role::Trcon(_) => self.stale_control_bits(access, known),
            _ => self.stale_flags(access, known),
        };
        if bits == 0 {
            return;
        }
        let info = self.regs.info(access.slot);
        let fields = info.fields.iter().filter(|field| field.all() & bits != 0).map(|field| field.name).collect();
        let section = if matches!(role, Role::Trcon(_)) { "8.1" } else { "9.2.5, 12.3" };
        cx.report(section, DiagnosticKind::StaleWrite { register: self.regs.name(access.slot), fields, bits });
    }

    /// Flags that rose unseen and are cleared, by a value in which nothing is 1 that was not read as 1: not the
    /// complement of the flags that were meant.
    fn stale_flags(&self, access: &WriteAccess, known: u32) -> u32 {
        let fields = self.regs.info(access.slot).fields.iter();
        let flags = fields.filter(|field| field.access == Access::W0c).fold(0, |mask, field| mask | field.all());
        let complement = access.ones() & flags & !known != 0;
        if complement { 0 } else { access.old & !access.new & !known }
    }

    /// A write for one of the two buffers in which the other one's half is what it was before hardware changed it.
    fn stale_control_bits(&self, access: &WriteAccess, known: u32) -> u32 {
        let fields = self.regs.info(access.slot).fields.iter();
        let writable = fields.filter(|field| field.access != Access::Ro).fold(0, |mask, field| mask | field.all());
        let request = self.n.tx[0].txreq.bits();
        (0..2).fold(0, |stale, lane| {
            let (mine, other) = (writable & 0xFF << (8 * lane), writable & 0xFF << (8 * (1 - lane)));
            let request = request << (8 * lane);
            let changed = (access.old ^ known) & request;
            let unchanged_here = (access.written ^ known) & mine == 0;
            let meant_other = (access.written ^ known) & other != 0;
            if changed != 0 && unchanged_here && meant_other { stale | changed } else { stale }
        })
    }
}
