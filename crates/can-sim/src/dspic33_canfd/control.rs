//! Writes to the registers of the module, the queue and the event FIFO: which concern each belongs to.

use dspic33_canfd_pac::registers as pac;

use super::Dspic33CanfdModel;
use crate::{model::Context, registers::WriteAccess};

impl Dspic33CanfdModel {
    pub(super) fn module_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let slot = access.slot;
        if slot == self.r.con_l {
            self.enable_written(cx, access);
        } else if slot == self.r.con_h {
            self.mode_written(cx, access);
            self.follow_abort_all(cx);
        } else if slot == self.r.txqcon_l {
            self.control_written(cx, access, 0);
        } else if slot == self.r.txqcon_h {
            self.scan(cx);
        } else if slot == self.r.txqsta {
            self.combine(0);
        } else if slot == self.r.txreq_l {
            self.requests_written(cx, access, 0);
        } else if slot == self.r.txreq_h {
            self.requests_written(cx, access, 16);
        } else if slot == self.r.tefcon_l {
            self.event_control_written(cx, access);
        } else if slot == self.r.tefsta {
            self.combine_main();
        } else if slot == self.r.int_l {
            self.flags_written(access);
        } else if slot == self.r.tscon_l || slot == self.r.tscon_h {
            self.time_control_written(cx, access);
        } else if slot == self.r.tbc_l || slot == self.r.tbc_h {
            self.time_written(cx);
        }
    }

    /// 12.3.6: clearing SERRIF also ends the condition behind its code.
    fn flags_written(&mut self, access: &WriteAccess) {
        let cleared = pac::IntL::from_bits((access.old & !access.new) as u16);
        if cleared.contains(pac::IntL::SERRIF) {
            self.system.acknowledge();
        }
    }
}
