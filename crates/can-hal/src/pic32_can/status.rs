//! Error counters and states, transmit status, time stamp timer (34.11, 34.13, Register 34-20).

use pic32_can_pac::registers as pac;
use regbus::Bus;

use super::Can;
use crate::{
    Counters, ErrorState, Status,
    mode::{OnBus, Sends},
};

/// What has become of the attempts to send from a FIFO since the last look (Register 34-20).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TxStatus {
    /// Messages are requested (TXREQ).
    pub requested: bool,
    /// The last message was aborted (TXABAT).
    pub aborted: bool,
    /// Arbitration was lost (TXLARB).
    pub lost_arbitration: bool,
    /// An error on the bus has disturbed a message (TXERR).
    pub error: bool,
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Reads CiTREC once.
    pub(super) fn error_status(&self) -> Status {
        let trec = self.inner.regs.trec().read();
        let error_state = match (trec.txbo(), trec.txbp() || trec.rxbp()) {
            (true, _) => ErrorState::BusOff,
            (false, true) => ErrorState::Passive,
            (false, false) => ErrorState::Active,
        };
        Status {
            error_state,
            warning: trec.ewarn(),
            counters: Counters { transmit: u16::from(trec.tec()), receive: u16::from(trec.rec()) },
            last_error: None,
            last_data_error: None,
        }
    }

    /// The time stamp timer (Register 34-8); it stands still without time stamps.
    #[must_use]
    pub fn timestamp_timer(&self) -> u16 {
        self.inner.regs.tmr().read().cants()
    }

    /// Sets the time stamp timer. Its prescaler begins anew (Register 34-8).
    pub fn set_timestamp_timer(&mut self, value: u16) {
        let tmr = self.inner.regs.tmr();
        let prescaler = tmr.read().cantspre();
        tmr.write(pac::Tmr::ZERO.with_cantspre(prescaler).with_cants(value));
    }

    /// A system error has stopped the module: memory that it cannot reach, or could not reach in time (34.12.1.4).
    /// [`Can::new`] takes it into operation again.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.inner.regs.int_().read().serrif()
    }
}

impl<S: Sends, R: Bus, M: Bus> Can<S, R, M> {
    /// The transmit status of a FIFO. Reading CiFIFOCONn destroys TXLARB and TXERR; what other calls of this driver have
    /// destroyed is in here too.
    pub fn tx_status(&mut self, fifo: u8) -> TxStatus {
        let inner = &mut self.inner;
        let con = inner.control(fifo);
        let bit = 1 << (fifo % 32);
        let status = TxStatus {
            requested: con.txreq(),
            aborted: con.txabat(),
            lost_arbitration: inner.lost_arbitration & bit != 0,
            error: inner.errors & bit != 0,
        };
        inner.lost_arbitration &= !bit;
        inner.errors &= !bit;
        status
    }
}
