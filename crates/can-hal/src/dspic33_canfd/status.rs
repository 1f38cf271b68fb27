//! Error counters, error states, diagnostics, the Time Base Counter (11.0, 13.0).

use dspic33_canfd_pac::registers as pac;
use regbus::Bus;

use super::{Can, Inner};
use crate::{Counters, ErrorState, LastError, Status};

/// Errors counted one by one, never down (13.0). Each counter ends at 255.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Diagnostics {
    /// Errors while sending at the nominal bit rate.
    pub nominal_transmit: u8,
    /// Errors while receiving at the nominal bit rate.
    pub nominal_receive: u8,
    /// Errors while sending at the data bit rate.
    pub data_transmit: u8,
    /// Errors while receiving at the data bit rate.
    pub data_receive: u8,
    /// Messages without error, either way.
    pub error_free: u16,
}

/// 13.0: the warning limit and the error passive limit.
const WARNING: u16 = 96;
const PASSIVE_ABOVE: u16 = 127;
/// What TEC is at least in bus off.
const BUS_OFF: u16 = 256;

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Takes note of what BDIAG1H shows and clears it. An error between the two accesses is not told; BDIAG0 counts it.
    pub(super) fn diagnose(&mut self) -> pac::Bdiag1H {
        let seen = self.regs.bdiag1_h().read();
        if !seen.is_empty() {
            self.regs.bdiag1_h().write(pac::Bdiag1H::ZERO);
            self.diagnosis |= seen;
        }
        seen
    }

    pub(super) fn status(&mut self) -> Status {
        let counts = self.regs.trec_l().read();
        // The states that follow from the counters are taken from them: the two registers are read one after the other.
        let bus_off = self.regs.trec_h().read().txbo();
        self.diagnose();
        let diagnosis = core::mem::replace(&mut self.diagnosis, pac::Bdiag1H::ZERO);
        let transmit = if bus_off { BUS_OFF } else { u16::from(counts.terrcnt()) };
        let receive = u16::from(counts.rerrcnt());
        let highest = transmit.max(receive);
        let error_state = match (bus_off, highest > PASSIVE_ABOVE) {
            (true, _) => ErrorState::BusOff,
            (false, true) => ErrorState::Passive,
            (false, false) => ErrorState::Active,
        };
        Status {
            error_state,
            warning: highest >= WARNING,
            counters: Counters { transmit, receive },
            last_error: last_error(diagnosis),
            last_data_error: last_data_error(diagnosis),
        }
    }

    pub(super) fn diagnostics(&self) -> Diagnostics {
        let (nominal, data) = (self.regs.bdiag0_l().read(), self.regs.bdiag0_h().read());
        Diagnostics {
            nominal_transmit: nominal.nterrcnt(),
            nominal_receive: nominal.nrerrcnt(),
            data_transmit: data.dterrcnt(),
            data_receive: data.drerrcnt(),
            error_free: self.regs.bdiag1_l().read().efmsgcnt(),
        }
    }
}

/// Register 3-49. BDIAG1H tells the kinds of errors, not their order; of several this is the one that says most.
fn last_error(flags: pac::Bdiag1H) -> Option<LastError> {
    use pac::Bdiag1H as D;
    let kinds = [
        (D::NACKERR, LastError::Ack),
        (D::NCRCERR, LastError::Crc),
        (D::NSTUFERR, LastError::Stuff),
        (D::NFORMERR, LastError::Form),
        (D::NBIT0ERR, LastError::Bit0),
        (D::NBIT1ERR, LastError::Bit1),
    ];
    kinds.into_iter().find(|(flag, _)| flags.contains(*flag)).map(|(_, error)| error)
}

fn last_data_error(flags: pac::Bdiag1H) -> Option<LastError> {
    use pac::Bdiag1H as D;
    let kinds = [
        (D::DCRCERR, LastError::Crc),
        (D::DSTUFERR, LastError::Stuff),
        (D::DFORMERR, LastError::Form),
        (D::DBIT0ERR, LastError::Bit0),
        (D::DBIT1ERR, LastError::Bit1),
    ];
    kinds.into_iter().find(|(flag, _)| flags.contains(*flag)).map(|(_, error)| error)
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// The counters of the bus diagnostics (13.0).
    #[must_use]
    pub fn diagnostics(&self) -> Diagnostics {
        self.inner.diagnostics()
    }

    /// Sets the counters of the bus diagnostics to 0.
    pub fn clear_diagnostics(&mut self) {
        self.inner.regs.write_bdiag0(0);
        self.inner.regs.bdiag1_l().write(pac::Bdiag1L::ZERO);
    }

    /// The Time Base Counter (11.0). Its halves are read until the upper one has not changed in between.
    #[must_use]
    pub fn time_base(&self) -> u32 {
        let regs = &self.inner.regs;
        let mut high = regs.tbc_h().read().tbc();
        let mut low = regs.tbc_l().read().tbc();
        let again = regs.tbc_h().read().tbc();
        if again != high {
            (high, low) = (again, regs.tbc_l().read().tbc());
        }
        u32::from(high) << 16 | u32::from(low)
    }
}
