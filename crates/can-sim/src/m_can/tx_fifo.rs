//! Tx FIFO and Tx Queue indices (2.3.36, 3.5.3 to 3.5.6).

use m_can_pac::registers::Ir;

use super::{
    MCanModel,
    tx::{Division, bits},
};
use crate::{diagnostic::DiagnosticKind, model::Context};

impl MCanModel {
    /// The buffer of the FIFO behind another, cyclically.
    fn next_in_fifo(&self, buffer: u32) -> u32 {
        let Division { dedicated, rest, .. } = self.division();
        if buffer + 1 == dedicated + rest { dedicated } else { buffer + 1 }
    }

    /// tx_status_after_configuration: when CCE returns to 0 the indices point to the first buffer behind the dedicated
    /// ones.
    pub(super) fn start_tx(&mut self) {
        let Division { dedicated, queue, .. } = self.division();
        self.tx.used = 0;
        self.regs.set_field(self.f.tfqpi, dedicated);
        self.regs.set_field(self.f.tfgi, if queue { 0 } else { dedicated });
        self.show_fifo();
    }

    /// 3.5.3: an Add Request moves the Put Index to the next free element, by n for n consecutive ones.
    pub(super) fn fifo_requested(&mut self, cx: &mut Context<'_>, added: u32) {
        let Division { dedicated, rest, queue } = self.division();
        let in_fifo = added & regbus::bits::mask(dedicated + rest) & !regbus::bits::mask(dedicated);
        if queue || in_fifo == 0 {
            return self.show_fifo();
        }
        let first = self.regs.field(self.f.tfqpi);
        let mut taken = 0;
        let mut put = first;
        while self.tx.used < rest && self.pending() >> put & 1 == 1 {
            taken |= 1 << put;
            put = self.next_in_fifo(put);
            self.tx.used += 1;
        }
        self.regs.set_field(self.f.tfqpi, put);
        self.show_fifo();
        for buffer in bits(in_fifo & !taken & self.pending()) {
            cx.report("3.5.3", DiagnosticKind::NotHandedOut { register: "TXBAR", buffer, put: first });
        }
    }

    /// 3.5.3: the Get Index moves on over buffers that were sent or cancelled. A cancellation behind it changes neither
    /// the Get Index nor the free level.
    pub(super) fn fifo_released(&mut self, cx: &mut Context<'_>) {
        if self.division().queue {
            return self.show_fifo();
        }
        let before = self.tx.used;
        self.fifo_skip();
        if before > 0 && self.tx.used == 0 {
            // tx_fifo_empty_flag.
            self.raise(cx, Ir::TFE);
        }
        self.show_fifo();
    }

    fn fifo_skip(&mut self) {
        let mut get = self.regs.field(self.f.tfgi);
        while self.tx.used > 0 && self.pending() >> get & 1 == 0 {
            get = self.next_in_fifo(get);
            self.tx.used -= 1;
        }
        self.regs.set_field(self.f.tfgi, get);
    }

    /// Bus Monitoring Mode has reset all requests (3.1.6).
    pub(super) fn fifo_emptied(&mut self) {
        if !self.cccr().cce() && !self.division().queue {
            self.fifo_skip();
            self.show_fifo();
        }
    }

    /// 2.3.36: full flag, free level, and the Put Index of a queue: its free buffer with the lowest number.
    pub(super) fn show_fifo(&mut self) {
        if self.cccr().cce() {
            return;
        }
        let Division { dedicated, rest, queue } = self.division();
        if queue {
            let free = !self.pending() & regbus::bits::mask(dedicated + rest) & !regbus::bits::mask(dedicated);
            self.regs.set_field(self.f.tfqf, u32::from(free == 0 && rest > 0));
            if free != 0 {
                self.regs.set_field(self.f.tfqpi, free.trailing_zeros());
            }
            return;
        }
        self.regs.set_field(self.f.tffl, rest - self.tx.used);
        self.regs.set_field(self.f.tfqf, u32::from(self.tx.used == rest && rest > 0));
    }
}
