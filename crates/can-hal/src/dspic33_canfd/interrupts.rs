//! Interrupts (12.0).
//!
//! The flags of FIFOs are levels: they end when what they tell of is served. Which of them reach INTL is set by the
//! configuration: messages to fetch and overflows of receive FIFOs, exhausted attempts, events and lost events. INTH
//! enables them there.

use dspic33_canfd_pac::{
    enums::{FifoConLTxen, VecHRxcode, VecHTxcode, VecLIcode},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Inner, config::transmits};
use crate::{Events, controller::InterruptSet};

/// The main interrupt flags, with the error states that CERRIF is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupts {
    /// INTL.
    pub flags: pac::IntL,
    /// TRECH at the same time.
    pub states: pac::TrecH,
}

impl Interrupts {
    /// Flags alone.
    #[must_use]
    pub const fn of(flags: pac::IntL) -> Self {
        Self { flags, states: pac::TrecH::from_bits(0) }
    }
}

impl core::ops::BitOr for Interrupts {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self {
            flags: self.flags | other.flags,
            states: pac::TrecH::from_bits(self.states.bits() | other.states.bits()),
        }
    }
}

impl InterruptSet for Interrupts {
    fn is_empty(self) -> bool {
        self.flags.is_empty()
    }

    fn events(self) -> Events {
        use pac::{IntL as I, TrecH as S};
        // 12.3.3: CERRIF tells of every threshold.
        let crossed = self.flags.contains(I::CERRIF);
        let passive = self.states.contains(S::TXBP) || self.states.contains(S::RXBP);
        let cases = [
            (Events::RECEIVED, self.flags.contains(I::RXIF)),
            (Events::TRANSMITTED, self.flags.contains(I::TXIF)),
            (Events::CANCELLED, self.flags.contains(I::TXATIF)),
            (Events::LOST, self.flags.contains(I::RXOVIF)),
            (Events::TX_EVENT, self.flags.contains(I::TEFIF)),
            (Events::WARNING, crossed),
            (Events::PASSIVE, crossed && passive),
            (Events::BUS_OFF, crossed && self.states.contains(S::TXBO)),
            (Events::PROTOCOL_ERROR, self.flags.contains(I::IVMIF)),
            (Events::TIMESTAMP_WRAP, self.flags.contains(I::TBCIF)),
            (Events::WAKE_UP, self.flags.contains(I::WAKIF)),
            (Events::MEMORY, self.flags.contains(I::SERRIF)),
            (Events::MODE, self.flags.contains(I::MODIF)),
        ];
        cases.iter().fold(Events::NONE, |events, (event, present)| events.with(*event, *present))
    }
}

/// CxVEC: the interrupts and FIFOs with the highest numbers (12.4.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Codes {
    /// The interrupt; the number if it is reserved.
    pub interrupt: Result<VecLIcode, u8>,
    /// The filter of the last message stored.
    pub filter: u8,
    /// The FIFO with a receive interrupt.
    pub receive: Result<VecHRxcode, u8>,
    /// The FIFO or queue with a transmit interrupt.
    pub transmit: Result<VecHTxcode, u8>,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// FIFOCONnL without requests: direction, automatic reply, timestamps, enables.
    #[inline]
    pub(super) fn fifo_control(&self, number: u8) -> pac::FifoConL {
        if transmits(self.layout.transmit, number) {
            let replies = transmits(self.replies, number);
            let base = pac::FifoConL::ZERO.with_txen(FifoConLTxen::Transmit);
            return base.with_txatie(true).with_rtren(replies).with_rxovie(replies);
        }
        if !transmits(self.layout.receive, number) {
            return pac::FifoConL::ZERO;
        }
        let stamped = self.layout.objects[usize::from(number) % 32].stamped();
        pac::FifoConL::ZERO.with_rxtsen(stamped).with_tfnrfnie(true).with_rxovie(true)
    }

    pub(super) fn interrupts(&self) -> Interrupts {
        Interrupts { flags: self.regs.int_l().read(), states: self.regs.trec_h().read() }
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Enables main interrupts, in any mode. Others stay as they are. RXIF goes to the receive line, TXIF to the transmit
    /// line, the others to the information line (12.0).
    pub fn enable_interrupts(&mut self, flags: pac::IntL) {
        // Enables and flags stand in the same bits (Registers 3-15 and 3-16).
        self.inner.regs.int_h().modify(|enables| pac::IntH::from_bits(enables.bits() | flags.bits()));
    }

    /// Disables main interrupts; their flags are still set.
    pub fn disable_interrupts(&mut self, flags: pac::IntL) {
        self.inner.regs.int_h().modify(|enables| pac::IntH::from_bits(enables.bits() & !flags.bits()));
    }

    /// Which interrupt, and which FIFO, to serve first (12.4.1).
    #[must_use]
    pub fn interrupt_codes(&self) -> Codes {
        let (low, high) = (self.inner.regs.vec_l().read(), self.inner.regs.vec_h().read());
        Codes { interrupt: low.icode(), filter: low.filhit().bits(), receive: high.rxcode(), transmit: high.txcode() }
    }
}

#[cfg(test)]
mod tests {
    use dspic33_canfd_pac::{meta::CONTROLLER, registers as pac};

    /// What `enable_interrupts` relies on.
    #[test]
    fn enables_stand_where_the_flags_do() {
        let lsb = |at: regbus::meta::FieldRef| {
            let register = &CONTROLLER.registers[usize::from(at.register)];
            (register.name, register.fields[usize::from(at.field)].lsb)
        };
        let mut seen = 0;
        for source in CONTROLLER.interrupts.iter().filter(|source| lsb(source.flag).0 == "INTL") {
            assert_eq!(source.enable.map(|enable| lsb(enable).1), Some(lsb(source.flag).1), "{}", source.name);
            seen |= 1 << lsb(source.flag).1;
        }
        assert_eq!(seen, pac::IntL::from_bits(0xFC1F).bits());
    }
}
