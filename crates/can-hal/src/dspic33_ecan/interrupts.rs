//! Interrupts (12.0).

use dspic33_ecan_pac::{
    enums::{FilterNumber, InterruptCode},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Interrupts};
use crate::{Events, controller::InterruptSet};

type I = Interrupts;

/// The flags that software clears; the rest of CxINTF are states.
const FLAGS: I =
    I::TBIF.union(I::RBIF).union(I::RBOVIF).union(I::FIFOIF).union(I::ERRIF).union(I::WAKIF).union(I::IVRIF);

const fn only_flags(flags: I) -> I {
    I::from_bits(flags.bits() & FLAGS.bits())
}

impl InterruptSet for Interrupts {
    fn is_empty(self) -> bool {
        !self.intersects(FLAGS)
    }

    /// The states that stand beside the flags tell what an error interrupt means.
    fn events(self) -> Events {
        let error = self.contains(I::ERRIF);
        let cases = [
            (Events::RECEIVED, self.contains(I::RBIF)),
            (Events::TRANSMITTED, self.contains(I::TBIF)),
            (Events::LOST, self.contains(I::RBOVIF)),
            (Events::WARNING, error && self.contains(I::EWARN)),
            (Events::PASSIVE, error && self.intersects(I::TXBP | I::RXBP)),
            (Events::BUS_OFF, error && self.contains(I::TXBO)),
            (Events::PROTOCOL_ERROR, self.contains(I::IVRIF)),
            (Events::WAKE_UP, self.contains(I::WAKIF)),
            (Events::OTHER, self.contains(I::FIFOIF)),
        ];
        cases.iter().fold(Events::NONE, |events, (event, present)| events.with(*event, *present))
    }
}

/// Interrupts can be set up in any mode: none of their registers is protected.
impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Enables interrupts (12.3). Others stay as they are. The device's own flag and enable, CxIF and CxIE, are the
    /// caller's.
    pub fn enable_interrupts(&mut self, flags: Interrupts) {
        // The enables stand where the flags do (Register 4-21).
        let bits = only_flags(flags).bits();
        self.inner.regs.inte().modify(|inte| pac::Inte::from_bits(inte.bits() | bits));
    }

    /// Disables interrupts; their flags are still set.
    pub fn disable_interrupts(&mut self, flags: Interrupts) {
        self.inner.regs.inte().modify(|inte| pac::Inte::from_bits(inte.bits() & !flags.bits()));
    }

    /// The flags that are set, enabled or not, with the error states beside them.
    #[must_use]
    pub fn interrupt_flags(&self) -> Interrupts {
        self.inner.regs.intf().read()
    }

    /// Clears these flags with one store and no read: a flag that has risen since stays, unless it is among them. Error
    /// states stay as they are.
    pub fn clear_interrupts(&mut self, flags: Interrupts) {
        self.inner.regs.intf().clear(only_flags(flags));
    }

    /// Reads the flags and clears exactly those that were read. Serve what they stand for afterwards: what happens from now
    /// on raises them again.
    pub fn take_interrupts(&mut self) -> Interrupts {
        let flags = self.interrupt_flags();
        self.clear_interrupts(flags);
        flags
    }

    /// The code of the condition with the highest priority that is active and enabled, for a jump table (12.3); reserved
    /// codes as they are. The buffer it names is the one that was served last; do not unload the FIFO by it.
    ///
    /// # Errors
    /// A code that has no meaning.
    pub fn interrupt_code(&self) -> Result<InterruptCode, u8> {
        self.inner.regs.vec().read().icode()
    }

    /// The filter that the last message hit (CxVEC.FILHIT, `vec_filhit`).
    #[must_use]
    pub fn last_filter(&self) -> u8 {
        let (Ok(FilterNumber::Filter(filter)) | Err(filter)) = self.inner.regs.vec().read().filhit();
        filter
    }
}

#[cfg(test)]
mod tests {
    use dspic33_ecan_pac::meta::CONTROLLER;

    /// What `enable_interrupts` relies on.
    #[test]
    fn enables_stand_where_the_flags_do() {
        let lsb = |at: regbus::meta::FieldRef| {
            CONTROLLER.registers[usize::from(at.register)].fields[usize::from(at.field)].lsb
        };
        let sources = CONTROLLER.interrupts.iter().filter(|source| source.enable.is_some());
        let mut flags = 0;
        for source in sources {
            assert_eq!(source.enable.map(lsb), Some(lsb(source.flag)), "{}", source.name);
            flags |= 1 << lsb(source.flag);
        }
        assert_eq!(flags, super::FLAGS.bits());
    }
}
