//! Error counters and error states (11.2).

use regbus::Bus;

use super::{Can, Interrupts};
use crate::{Counters, ErrorState, Status, mode::OnBus};

/// 11.2.4: the error warning limit.
const WARNING: u16 = 96;
/// 11.2.1: the error passive limit (`error_passive_limit`).
const PASSIVE: u16 = 128;

/// One look at CxINTF and CxEC.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModuleStatus {
    /// What all controllers have.
    pub status: Status,
    /// The flags and states of CxINTF.
    pub flags: Interrupts,
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Reads CxINTF and CxEC, each once. Error passive and warning are told by the counters, so that they fit them; TERRCNT
    /// cannot show bus off, which TXBO does.
    pub fn module_status(&mut self) -> ModuleStatus {
        let (flags, counters) = (self.inner.regs.intf().read(), self.inner.regs.ec().read());
        let counters = Counters { transmit: u16::from(counters.terrcnt()), receive: u16::from(counters.rerrcnt()) };
        let highest = counters.transmit.max(counters.receive);
        let error_state = match (flags.txbo(), highest >= PASSIVE) {
            (true, _) => ErrorState::BusOff,
            (false, true) => ErrorState::Passive,
            (false, false) => ErrorState::Active,
        };
        let warning = highest >= WARNING;
        ModuleStatus {
            status: Status { error_state, warning, counters, last_error: None, last_data_error: None },
            flags,
        }
    }
}
