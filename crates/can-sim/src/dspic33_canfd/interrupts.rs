//! The layers of interrupts: FIFO flags, combined registers, main flags and codes (12.0).

use dspic33_canfd_pac::registers as pac;

use super::{CLEARED_BY_APPLICATION, Dspic33CanfdModel};
use crate::registers::Slot;

/// Register 3-13, 3-14: no interrupt pending.
const NONE: u8 = 64;

/// Enables and flags of a FIFO's states stand in the same bits (Registers 3-32 and 3-34, 3-29 and 3-31).
const STATES: u16 = pac::FifoSta::TFERFFIF.union(pac::FifoSta::TFHRFHIF).union(pac::FifoSta::TFNRFNIF).bits();
const OVERFLOW: u16 = pac::FifoSta::RXOVIF.bits();
const ATTEMPTS: u16 = pac::FifoSta::TXATIF.bits();
/// The same of the event FIFO (Registers 3-35 and 3-37).
const EVENTS: u16 =
    pac::Tefsta::TEFOVIF.union(pac::Tefsta::TEFFIF).union(pac::Tefsta::TEFHIF).union(pac::Tefsta::TEFNEIF).bits();

impl Dspic33CanfdModel {
    /// Sets main flags.
    pub(super) fn raise(&mut self, flags: pac::IntL) {
        debug_assert_eq!(flags.bits() & !CLEARED_BY_APPLICATION, 0, "the others mirror what is below them");
        self.set_bits(self.r.int_l, u32::from(flags.bits()));
    }

    /// 12.1, 12.2: the flags of one FIFO, or of the queue for 0, go up to the combined registers.
    pub(super) fn combine(&mut self, number: u8) {
        let (control, status) = self.control_and_status(number);
        let (control, status) = (self.word(control), self.word(status));
        let transmit = self.is_transmit(number);
        let state = control & status & STATES != 0;
        // combined_flag_gating.
        let gate = if self.config.choices.combined_flags_are_gated { control } else { u16::MAX };
        let r = &self.r;
        let bits = [
            (r.rxif_l, r.rxif_h, state && !transmit),
            (r.txif_l, r.txif_h, state && transmit),
            (r.rxovif_l, r.rxovif_h, gate & status & OVERFLOW != 0 && number != 0),
            (r.txatif_l, r.txatif_h, gate & status & ATTEMPTS != 0),
        ];
        for (low, high, on) in bits {
            self.set_numbered(low, high, number, on);
        }
        self.combine_main();
    }

    /// Sets the bit of a FIFO in a pair of registers.
    pub(super) fn set_numbered(&mut self, low: Slot, high: Slot, number: u8, on: bool) {
        let slot = if number < 16 { low } else { high };
        let bit = 1 << (number % 16);
        if on {
            self.set_bits(slot, bit);
        } else {
            self.clear_bits(slot, bit);
        }
    }

    fn pair(&self, low: Slot, high: Slot) -> u32 {
        self.regs.get(low) | self.regs.get(high) << 16
    }

    /// 12.3: the main flags that mirror the combined registers and the event FIFO.
    pub(super) fn combine_main(&mut self) {
        let r = &self.r;
        let events = self.word(r.tefcon_l) & self.word(r.tefsta) & EVENTS != 0;
        let kept = pac::IntL::from_bits(self.word(r.int_l) & CLEARED_BY_APPLICATION);
        let flags = [
            (pac::IntL::RXIF, self.pair(r.rxif_l, r.rxif_h) != 0),
            (pac::IntL::TXIF, self.pair(r.txif_l, r.txif_h) != 0),
            (pac::IntL::RXOVIF, self.pair(r.rxovif_l, r.rxovif_h) != 0),
            (pac::IntL::TXATIF, self.pair(r.txatif_l, r.txatif_h) != 0),
            (pac::IntL::TEFIF, events),
        ];
        let all = flags.into_iter().filter(|(_, on)| *on).fold(kept, |all, (flag, _)| all.union(flag));
        self.regs.set(self.r.int_l, u32::from(all.bits()));
    }

    /// 12.4.1: the codes are combinational; of several the highest number shows.
    pub(super) fn show_codes(&mut self) {
        let r = &self.r;
        let highest = |mask: u32| mask.checked_ilog2().map(|number| number as u8);
        let receive = highest(self.pair(r.rxif_l, r.rxif_h));
        let transmit = highest(self.pair(r.txif_l, r.txif_h));
        let code = self.main_code().or(receive.max(transmit)).unwrap_or(NONE);
        let vec_l = u32::from(self.rx.filter_hit) << 8 | u32::from(code);
        let vec_h = u32::from(receive.unwrap_or(NONE)) << 8 | u32::from(transmit.unwrap_or(NONE));
        let (low, high) = (r.vec_l, r.vec_h);
        self.regs.set(low, vec_l);
        self.regs.set(high, vec_h);
    }

    /// Register 3-13: the highest code of a main interrupt.
    fn main_code(&self) -> Option<u8> {
        use dspic33_canfd_pac::enums::VecLIcode as Code;
        let flags = self.word(self.r.int_l);
        // icode_gating: flags and enables stand in the same bits (Registers 3-15 and 3-16).
        let gate = if self.config.choices.icode_is_gated { self.word(self.r.int_h) } else { u16::MAX };
        let pending = pac::IntL::from_bits(flags & gate);
        let system = pending.contains(pac::IntL::SERRIF);
        let codes = [
            (pending.contains(pac::IntL::TXATIF), Code::TransmitAttempt),
            (pending.contains(pac::IntL::TEFIF), Code::TransmitEvent),
            (pending.contains(pac::IntL::IVMIF), Code::InvalidMessage),
            (pending.contains(pac::IntL::MODIF), Code::ModeChange),
            (pending.contains(pac::IntL::TBCIF), Code::TimerOverflow),
            (system && self.system.message_buffer, Code::MessageBuffer),
            (system && self.system.address, Code::AddressError),
            (pending.contains(pac::IntL::RXOVIF), Code::ReceiveOverflow),
            (pending.contains(pac::IntL::WAKIF), Code::WakeUp),
            (pending.contains(pac::IntL::CERRIF), Code::BusError),
        ];
        codes.into_iter().find(|(on, _)| *on).map(|(_, code)| code.bits())
    }
}
