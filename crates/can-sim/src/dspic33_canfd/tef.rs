//! The transmit event FIFO (7.0, 10.1.4, 10.5).

use dspic33_canfd_pac::registers as pac;

use super::{Dspic33CanfdModel, fifo::Ring};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

impl Dspic33CanfdModel {
    pub(super) fn event_control_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let written = pac::TefconL::from_bits(access.ones() as u16);
        self.clear_bits(access.slot, u32::from(pac::TefconL::UINC.bits()));
        if self.is_configuration() {
            return self.combine_main();
        }
        if written.contains(pac::TefconL::FRESET) {
            self.reset_events();
            self.clear_bits(access.slot, u32::from(pac::TefconL::FRESET.bits()));
            self.show_events();
        } else if written.contains(pac::TefconL::UINC) {
            self.release_event(cx);
        }
        self.combine_main();
    }

    /// 7.1: UINC after an event was read.
    fn release_event(&mut self, cx: &mut Context<'_>) {
        let (depth, fill) = (self.layout.tef.count, u32::from(self.fifos.rings[0].count));
        if fill == 0 {
            let register = self.regs.name(self.r.tefcon_l);
            cx.report("7.1", DiagnosticKind::IncrementIgnored { register, fill, depth });
            if self.config.choices.uinc_is_checked {
                return;
            }
        }
        self.fifos.rings[0].pop(depth);
        self.show_events();
    }

    /// 7.1.1.
    pub(super) fn reset_events(&mut self) {
        self.fifos.rings[0] = Ring::default();
        self.regs.set(self.r.tefsta, 0);
        self.combine_main();
    }

    /// 6.13, 7.0: the header of a message that was sent, with the time.
    pub(super) fn store_event(&mut self, cx: &mut Context<'_>, header: [u16; 4], time: u32) {
        let placed = self.layout.tef;
        if placed.count == 0 {
            return;
        }
        let ring = self.fifos.rings[0];
        if ring.is_full(placed.count) {
            // 10.5: the event is discarded.
            self.set_bits(self.r.tefsta, u32::from(pac::Tefsta::TEFOVIF.bits()));
            return self.combine_main();
        }
        let address = placed.address(ring.head(placed.count));
        let words = [header[0], header[1], header[2], header[3], time as u16, (time >> 16) as u16];
        let stored = self.ram_store(cx, address, &words[..placed.element as usize / 2]);
        if stored.is_err() {
            return self.address_error(cx, address);
        }
        self.fifos.rings[0].push(placed.count);
        self.show_events();
    }

    pub(super) fn show_events(&mut self) {
        let placed = self.layout.tef;
        let ring = self.fifos.rings[0];
        let (count, depth) = (u32::from(ring.count), placed.count);
        let exists = depth > 0;
        use pac::Tefsta as F;
        let flags =
            [(F::TEFFIF, exists && count == depth), (F::TEFHIF, exists && count * 2 >= depth), (F::TEFNEIF, count > 0)];
        self.set_flags(self.r.tefsta, flags.map(|(flag, on)| (flag.bits(), on)));
        self.show_address(self.r.tefua_l, self.r.tefua_h, placed.address(u32::from(ring.tail)));
        self.combine_main();
    }
}
