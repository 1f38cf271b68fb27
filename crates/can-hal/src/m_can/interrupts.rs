//! Interrupts (2.3.16 to 2.3.19, 2.3.43, 2.3.44).

use m_can_pac::registers as pac;
use regbus::Bus;

use super::{Can, Interrupts};
use crate::{Events, controller::InterruptSet};

/// An interrupt line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Line {
    /// `m_can_int0`.
    Int0,
    /// `m_can_int1`.
    Int1,
}

impl InterruptSet for Interrupts {
    fn is_empty(self) -> bool {
        Self::is_empty(self)
    }

    fn events(self) -> Events {
        type I = Interrupts;
        let cases = [
            (Events::RECEIVED, I::RF0N | I::RF1N | I::DRX | I::HPM),
            (Events::TRANSMITTED, I::TC),
            (Events::CANCELLED, I::TCF),
            (Events::LOST, I::RF0L | I::RF1L | I::TEFL),
            (Events::TX_EVENT, I::TEFN),
            (Events::WARNING, I::EW),
            (Events::PASSIVE, I::EP),
            (Events::BUS_OFF, I::BO),
            (Events::PROTOCOL_ERROR, I::PEA | I::PED),
            (Events::TIMESTAMP_WRAP, I::TSW),
            (Events::MEMORY, I::MRAF | I::BEU | I::BEC | I::WDI),
            (Events::OTHER, I::ARA | I::ELO | I::TOO | I::TFE | I::TEFF | I::TEFW),
            (Events::OTHER, I::RF0F | I::RF0W | I::RF1F | I::RF1W),
        ];
        cases.iter().fold(Events::NONE, |events, (event, flags)| events.with(*event, self.intersects(*flags)))
    }
}

/// Interrupts can be set up in any mode: none of their registers is protected.
impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Enables interrupts and routes them to a line, which is enabled too. Others stay as they are.
    pub fn enable_interrupts(&mut self, flags: Interrupts, line: Line) {
        let regs = &self.inner.regs;
        let bits = flags.bits();
        // The enable and line-select bits stand where the flags do (2.3.16 to 2.3.18).
        regs.ils().modify(|ils| {
            pac::Ils::from_bits(match line {
                Line::Int0 => ils.bits() & !bits,
                Line::Int1 => ils.bits() | bits,
            })
        });
        regs.ile().modify(|ile| match line {
            Line::Int0 => ile.with_eint0(true),
            Line::Int1 => ile.with_eint1(true),
        });
        regs.ie().modify(|ie| pac::Ie::from_bits(ie.bits() | bits));
    }

    /// Disables interrupts; their flags are still set.
    pub fn disable_interrupts(&mut self, flags: Interrupts) {
        self.inner.regs.ie().modify(|ie| pac::Ie::from_bits(ie.bits() & !flags.bits()));
    }

    /// Tx Buffers, one bit each, that raise IR.TC when sent and IR.TCF when given up (2.3.43, 2.3.44). After reset there
    /// are none.
    pub fn enable_buffer_interrupts(&mut self, sent: u32, given_up: u32) {
        self.inner.regs.txbtie().write(pac::Txbtie::from_bits(sent));
        self.inner.regs.txbcie().write(pac::Txbcie::from_bits(given_up));
    }

    /// The flags that are set, enabled or not.
    #[must_use]
    pub fn interrupt_flags(&self) -> Interrupts {
        self.inner.regs.ir().read()
    }

    /// Clears these flags with one store and no read: a flag that has risen since stays, unless it is among them.
    pub fn clear_interrupts(&mut self, flags: Interrupts) {
        self.inner.regs.ir().clear(flags);
    }

    /// Reads the flags and clears exactly those that were read. Serve what they stand for afterwards: what happens from
    /// now on raises them again.
    pub fn take_interrupts(&mut self) -> Interrupts {
        let flags = self.interrupt_flags();
        self.clear_interrupts(flags);
        flags
    }
}

#[cfg(test)]
mod tests {
    use m_can_pac::meta::CONTROLLER;

    /// What `enable_interrupts` relies on.
    #[test]
    fn enable_and_line_select_bits_stand_where_the_flags_do() {
        let lsb = |at: regbus::meta::FieldRef| {
            CONTROLLER.registers[usize::from(at.register)].fields[usize::from(at.field)].lsb
        };
        assert_eq!(CONTROLLER.interrupts.len(), 30);
        for source in CONTROLLER.interrupts {
            assert_eq!(source.enable.map(lsb), Some(lsb(source.flag)), "{}", source.name);
            assert_eq!(source.select.map(lsb), Some(lsb(source.flag)), "{}", source.name);
        }
    }
}
