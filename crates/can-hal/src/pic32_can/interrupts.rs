//! Interrupts (34.12).

use pic32_can_pac::{
    enums::InterruptCode,
    registers::{self as pac, Int, Trec},
};
use regbus::Bus;

use super::Can;
use crate::{Events, controller::InterruptSet};

/// Flags of layer 2 (34.12.1), with the error states that one of them stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Interrupts {
    flags: Int,
    states: Trec,
}

macro_rules! flags {
    ($($(#[$doc:meta])* $name:ident = $flag:ident;)*) => {
        impl Interrupts {
            $($(#[$doc])* pub const $name: Self = Self::of(Int::$flag);)*
        }

        impl core::fmt::Debug for Interrupts {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let mut set = f.debug_set();
                $(if self.contains(Self::$name) { set.entry(&format_args!(stringify!($name))); })*
                set.finish()
            }
        }
    };
}

flags! {
    /// An enabled flag of a transmit FIFO (TBIF); see [`Can::enable_fifo_flags`]. Goes away with its cause only.
    TRANSMIT = TBIF;
    /// A receive FIFO is not empty, or has another enabled flag (RBIF). Goes away with its cause only.
    RECEIVE = RBIF;
    /// The time stamp timer has wrapped (CTMRIF).
    TIMER = CTMRIF;
    /// The mode has changed, also on request (MODIF).
    MODE = MODIF;
    /// A FIFO has lost a message (RBOVIF). Goes away when [`Receive::fetch`](crate::Receive::fetch) has told.
    OVERFLOW = RBOVIF;
    /// A system error has stopped the module (SERRIF). Ends with the module switched off only.
    SYSTEM_ERROR = SERRIF;
    /// The error state has changed (CERRIF).
    ERROR_STATE = CERRIF;
    /// Traffic while the device slept (WAKIF).
    WAKE_UP = WAKIF;
    /// A message was disturbed (IVRIF).
    INVALID_MESSAGE = IVRIF;
}

/// From a flag of CiINT to its enable.
const ENABLE_SHIFT: u32 = 16;

impl Interrupts {
    /// All of them.
    pub const ALL: Self = Self::of(
        Int::TBIF
            .union(Int::RBIF)
            .union(Int::CTMRIF)
            .union(Int::MODIF)
            .union(Int::RBOVIF)
            .union(Int::SERRIF)
            .union(Int::CERRIF)
            .union(Int::WAKIF)
            .union(Int::IVRIF),
    );

    const fn of(flags: Int) -> Self {
        Self { flags, states: Trec::ZERO }
    }

    /// All of `other` are in the set.
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.flags.contains(other.flags)
    }

    /// Some of `other` are in the set.
    #[must_use]
    pub const fn intersects(self, other: Self) -> bool {
        self.flags.intersects(other.flags)
    }
}

impl core::ops::BitOr for Interrupts {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self { flags: self.flags | other.flags, states: Trec::from_bits(self.states.bits() | other.states.bits()) }
    }
}

impl InterruptSet for Interrupts {
    fn is_empty(self) -> bool {
        self.flags.is_empty()
    }

    /// 34.12.1.3: one flag for every change of the error state; the states are those of when the flags were read. A change
    /// for the better counts as a crossing of the warning limit.
    fn events(self) -> Events {
        let changed = self.contains(Self::ERROR_STATE);
        let cases = [
            (Events::RECEIVED, self.contains(Self::RECEIVE)),
            (Events::TRANSMITTED, self.contains(Self::TRANSMIT)),
            (Events::LOST, self.contains(Self::OVERFLOW)),
            (Events::WARNING, changed),
            (Events::PASSIVE, changed && (self.states.txbp() || self.states.rxbp())),
            (Events::BUS_OFF, changed && self.states.txbo()),
            (Events::PROTOCOL_ERROR, self.contains(Self::INVALID_MESSAGE)),
            (Events::TIMESTAMP_WRAP, self.contains(Self::TIMER)),
            (Events::WAKE_UP, self.contains(Self::WAKE_UP)),
            (Events::MEMORY, self.contains(Self::SYSTEM_ERROR)),
            (Events::MODE, self.contains(Self::MODE)),
        ];
        cases.iter().fold(Events::NONE, |events, (event, holds)| events.with(*event, *holds))
    }
}

/// Interrupts can be set up in any mode.
impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Enables interrupts; others stay as they are. Flags and enables share CiINT: enables change through its SET and CLR
    /// registers, so that no flag is cleared.
    pub fn enable_interrupts(&mut self, interrupts: Interrupts) {
        let enables = Int::from_bits(interrupts.flags.bits() << ENABLE_SHIFT);
        self.inner.regs.int_().set_bits(enables);
    }

    /// Disables interrupts; their flags are still set.
    pub fn disable_interrupts(&mut self, interrupts: Interrupts) {
        let enables = Int::from_bits(interrupts.flags.bits() << ENABLE_SHIFT);
        self.inner.regs.int_().clear_bits(enables);
    }

    /// Which flags of a FIFO count for [`Interrupts::TRANSMIT`], [`Interrupts::RECEIVE`] and [`Interrupts::OVERFLOW`], by
    /// their enables in CiFIFOINTn (34.12.2). The configuration has enabled RXNEMPTYIE and RXOVFLIE of receive FIFOs and
    /// nothing of transmit FIFOs, whose flags are set while they are empty.
    pub fn enable_fifo_flags(&mut self, fifo: u8, enables: pac::FifoInt) {
        let register = self.inner.regs.fifo(usize::from(fifo % 32)).int_();
        register.clear_bits(pac::FifoInt::from_bits(FIFO_ENABLES & !enables.bits()));
        register.set_bits(pac::FifoInt::from_bits(FIFO_ENABLES & enables.bits()));
    }

    /// The flags that are set, enabled or not.
    #[must_use]
    pub fn interrupt_flags(&self) -> Interrupts {
        let flags = Int::from_bits(self.inner.regs.int_().read().bits() & Interrupts::ALL.flags.bits());
        let states = if flags.cerrif() { self.inner.regs.trec().read() } else { Trec::ZERO };
        Interrupts { flags, states }
    }

    /// Clears these flags with one store to CiINTCLR: a flag that has risen since stays, unless it is among them. Those that
    /// follow the FIFOs, and that of system errors, do not clear.
    pub fn clear_interrupts(&mut self, interrupts: Interrupts) {
        self.inner.regs.int_().clear_bits(interrupts.flags);
    }

    /// Reads the flags and clears exactly those that were read. Serve what they stand for afterwards: what happens from
    /// now on raises them again.
    pub fn take_interrupts(&mut self) -> Interrupts {
        let flags = self.interrupt_flags();
        self.clear_interrupts(flags);
        flags
    }

    /// The highest pending interrupt that is enabled, for a jump table (34.12.6); `None` for a reserved code.
    #[must_use]
    pub fn interrupt_code(&self) -> Option<InterruptCode> {
        self.inner.regs.vec().read().icod().ok()
    }
}

/// The enables of CiFIFOINTn.
const FIFO_ENABLES: u32 = pac::FifoInt::TXNFULLIE
    .union(pac::FifoInt::TXHALFIE)
    .union(pac::FifoInt::TXEMPTYIE)
    .union(pac::FifoInt::RXOVFLIE)
    .union(pac::FifoInt::RXFULLIE)
    .union(pac::FifoInt::RXHALFIE)
    .union(pac::FifoInt::RXNEMPTYIE)
    .bits();

#[cfg(test)]
mod tests {
    use pic32_can_pac::meta::CONTROLLER;

    use super::*;

    /// What `enable_interrupts` relies on.
    #[test]
    fn enables_of_layer_2_stand_16_bits_above_their_flags() {
        let lsb = |at: regbus::meta::FieldRef| {
            u32::from(CONTROLLER.registers[usize::from(at.register)].fields[usize::from(at.field)].lsb)
        };
        let layer_2 = CONTROLLER.interrupts.iter().filter(|source| !source.lines.is_empty());
        let mut seen = 0;
        for source in layer_2 {
            assert_eq!(source.enable.map(lsb), Some(lsb(source.flag) + ENABLE_SHIFT), "{}", source.name);
            seen |= 1 << lsb(source.flag);
        }
        assert_eq!(seen, Interrupts::ALL.flags.bits());
    }
}
