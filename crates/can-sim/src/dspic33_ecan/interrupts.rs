//! Interrupt flags, their code and the three interrupt lines (12.0).

use dspic33_ecan_pac::{
    enums::{FilterNumber, InterruptCode},
    registers::Intf,
};

use super::{EcanModel, config::IcodeOrder};

/// What CxVEC tells of.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Served {
    /// The buffer that was sent last.
    pub(super) transmitted: u8,
    /// The buffer that a message was stored in last, and the filter that it hit (`vec_filhit`).
    pub(super) received: u8,
    pub(super) filter: u8,
}

impl EcanModel {
    /// flags_without_enable: an event sets its flag, whether the interrupt is enabled or not.
    pub(super) fn raise(&mut self, flags: Intf) {
        self.regs.set(self.n.intf, self.regs.get(self.n.intf) | u32::from(flags.bits()));
    }

    /// 12.3.2, note: the code of the condition with the highest priority that is enabled and active.
    pub(super) fn interrupt_code(&self) -> u8 {
        // Registers 4-20 and 4-21 have flags and enables at the same bits.
        let active = Intf::from_bits((self.regs.get(self.n.intf) & self.regs.get(self.n.inte)) as u16);
        let choices = &self.config.choices;
        // icode_invalid_message.
        let invalid = active.contains(Intf::IVRIF) && choices.invalid_message_is_error_code;
        let conditions = [
            (active.contains(Intf::ERRIF) || invalid, InterruptCode::Error),
            (active.contains(Intf::WAKIF), InterruptCode::WakeUp),
            (active.contains(Intf::RBOVIF), InterruptCode::ReceiverOverflow),
            (active.contains(Intf::FIFOIF), InterruptCode::FifoAlmostFull),
        ];
        let other = conditions.iter().find(|(holds, _)| *holds).map(|(_, code)| code.bits());
        let transmitted = active.contains(Intf::TBIF).then_some(self.served.transmitted);
        let received = active.contains(Intf::RBIF).then(|| self.received_code());
        let buffers = [transmitted, received].into_iter().flatten();
        let code = match choices.icode_order {
            IcodeOrder::HighestFirst => other.or(buffers.max()),
            IcodeOrder::LowestCodeFirst => buffers.min().or(other),
        };
        code.unwrap_or(InterruptCode::NoInterrupt.bits())
    }

    /// icode_buffer.
    fn received_code(&self) -> u8 {
        let highest = self.full().checked_ilog2();
        match self.config.choices.icode_names_last_buffer {
            true => self.served.received,
            false => highest.map_or(self.served.received, |buffer| buffer as u8),
        }
    }

    /// CxVEC is worked out when it is read.
    pub(super) fn show_code(&mut self) {
        let filter = FilterNumber::from_bits(self.served.filter).map_or(0, FilterNumber::bits);
        self.regs.set(self.n.vec, u32::from(filter) << 8 | u32::from(self.interrupt_code()));
    }

    /// 12.0: the event interrupt by the description; the two data requests while a word waits.
    pub(super) fn lines(&self) -> u32 {
        let (transmit, receive) = self.data_requests();
        self.regs.active_lines() | u32::from(receive) << 1 | u32::from(transmit) << 2
    }
}
