//! Error counters and error states (11.0).

use can_wire::{BusError, ErrorState, Role};
use dspic33_ecan_pac::registers::Intf;

use super::EcanModel;
use crate::model::Context;

/// 11.2.4: the error warning limit.
const WARNING: u16 = 96;
/// 11.2.1: the error passive limit (`error_passive_limit`).
const PASSIVE: u16 = 128;
/// A transmit error adds this to its counter (CAN 2.0B).
const TRANSMIT_ERROR: u16 = 8;

/// What stands behind CxEC.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counters {
    tec: u16,
    /// TEC before its latest change.
    tec_before: u16,
    rec: u16,
}

impl EcanModel {
    pub(super) fn count(&mut self, tec: u16, rec: u16) {
        self.counters = Counters { tec, tec_before: self.counters.tec, rec };
        self.show_counters(tec);
        self.show_states();
    }

    fn show_counters(&mut self, tec: u16) {
        let word = u32::from(tec & 0xFF) << 8 | u32::from(self.counters.rec & 0xFF);
        self.regs.set(self.n.ec, word);
    }

    /// 11.2.1 to 11.2.5. Entry into a state sets ERRIF, by the description.
    fn show_states(&mut self) {
        let Counters { tec, rec, .. } = self.counters;
        let mut states = Intf::from_bits(0);
        let warning = WARNING..PASSIVE;
        for (holds, state) in [
            (warning.contains(&tec), Intf::TXWAR),
            (warning.contains(&rec), Intf::RXWAR),
            (tec >= PASSIVE, Intf::TXBP),
            (rec >= PASSIVE, Intf::RXBP),
            (tec >= WARNING || rec >= WARNING, Intf::EWARN),
        ] {
            if holds {
                states |= state;
            }
        }
        let shown = Intf::TXWAR | Intf::RXWAR | Intf::TXBP | Intf::RXBP | Intf::EWARN;
        let held = self.regs.get(self.n.intf) & !u32::from(shown.bits());
        self.regs.set(self.n.intf, held | u32::from(states.bits()));
    }

    /// 11.2.3, Figure 11-1.
    pub(super) fn error_state(&mut self, cx: &mut Context<'_>, from: ErrorState, to: ErrorState) {
        let bus_off = u32::from(Intf::TXBO.bits());
        let held = self.regs.get(self.n.intf) & !bus_off;
        self.regs.set(self.n.intf, if to == ErrorState::BusOff { held | bus_off } else { held });
        if to == ErrorState::BusOff {
            // terrcnt_in_bus_off: the counter has passed what eight bits can show.
            let shown = match self.config.choices.terrcnt_saturates {
                true => 255,
                false => self.counters.tec_before + TRANSMIT_ERROR,
            };
            self.show_counters(shown);
            if self.config.choices.automatic_bus_off_recovery {
                self.start_recovery(cx);
            }
            // A change of mode that waited for the frame waits for the recovery now.
            self.start_change(cx);
        }
        if to == ErrorState::BusOff || from == ErrorState::BusOff {
            self.scan(cx);
        }
    }

    /// invalid_message_condition: an error in a frame.
    pub(super) fn error(&mut self, cx: &mut Context<'_>, error: &BusError) {
        let counts = error.role == Role::Receiver || self.config.choices.invalid_message_includes_transmitted;
        if counts && error.position.field.is_in_frame() {
            self.raise(Intf::IVRIF);
        }
        self.broken_message(cx, error);
    }
}
