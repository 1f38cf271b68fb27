//! Protocol status, error counters, high priority messages, counters (2.3.9 to 2.3.14, 2.3.24, 3.4.4).

pub use m_can_pac::enums::{Activity, Rxf1sDms as DebugState};
use m_can_pac::{
    enums::{HpmsFlst, HpmsMsi, LastErrorCode},
    registers as pac,
};
use regbus::Bus;

use super::{Can, RxFifo};
use crate::{
    Counters, ErrorState, LastError, Status,
    mode::{LoopBack, OnBus, Running},
};

/// One look at PSR and ECR.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ProtocolStatus {
    /// What all controllers have.
    pub status: Status,
    /// What the node is doing (PSR.ACT).
    pub activity: Activity,
    /// A protocol exception event has occurred since the last look (PSR.PXE).
    pub protocol_exception: bool,
    /// An FD frame was received since the last look (PSR.RFDF), filtered out or not.
    pub received_fd: bool,
    /// That frame switched the bit rate (PSR.RBRS).
    pub received_bit_rate_switch: bool,
    /// That frame's sender was error passive (PSR.RESI).
    pub received_error_passive: bool,
    /// Position of the secondary sample point in periods of the CAN clock (PSR.TDCV).
    pub secondary_sample_point: u8,
    /// Errors since the last look that have raised a counter, up to 255 (ECR.CEL). Counts on in modes that leave the
    /// counters alone.
    pub errors_logged: u8,
}

/// Where a high priority message was stored (HPMS.MSI).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum HighPriorityStorage {
    /// Nowhere: the filter does not ask for it.
    None,
    /// It found no room and was lost.
    Lost,
    /// In an Rx FIFO, at this index; see [`Can::peek_fifo`].
    Fifo(RxFifo, u8),
}

/// The last high priority message (2.3.24).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HighPriority {
    /// It matched a filter for 29-bit identifiers.
    pub extended: bool,
    /// Index of the filter in its list.
    pub filter: u8,
    /// Where it was stored.
    pub storage: HighPriorityStorage,
}

const fn last_error(code: LastErrorCode) -> Option<LastError> {
    Some(match code {
        LastErrorCode::NoError => LastError::None,
        LastErrorCode::StuffError => LastError::Stuff,
        LastErrorCode::FormError => LastError::Form,
        LastErrorCode::AckError => LastError::Ack,
        LastErrorCode::Bit1Error => LastError::Bit1,
        LastErrorCode::Bit0Error => LastError::Bit0,
        LastErrorCode::CrcError => LastError::Crc,
        LastErrorCode::NoChange => return None,
    })
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Reads PSR and ECR, each once: reading destroys what it shows (2.3.13, 2.3.14).
    pub fn protocol_status(&mut self) -> ProtocolStatus {
        let (psr, ecr) = (self.inner.regs.psr().read(), self.inner.regs.ecr().read());
        let error_state = match (psr.bo(), psr.ep()) {
            (true, _) => ErrorState::BusOff,
            (false, true) => ErrorState::Passive,
            (false, false) => ErrorState::Active,
        };
        // 2.3.13: REC counts to 127; RP says that it has reached 128.
        let receive = if ecr.rp() { 128 } else { u16::from(ecr.rec()) };
        let status = Status {
            error_state,
            warning: psr.ew(),
            counters: Counters { transmit: u16::from(ecr.tec()), receive },
            last_error: last_error(psr.lec()),
            last_data_error: last_error(psr.dlec()),
        };
        ProtocolStatus {
            status,
            activity: psr.act(),
            protocol_exception: psr.pxe(),
            received_fd: psr.rfdf(),
            received_bit_rate_switch: psr.rbrs(),
            received_error_passive: psr.resi(),
            secondary_sample_point: psr.tdcv(),
            errors_logged: ecr.cel(),
        }
    }

    /// The last high priority message; one that no filter has reported reads as filter 0 of the standard list without
    /// storage, so ask only after IR.HPM (2.3.24).
    #[must_use]
    pub fn high_priority(&self) -> HighPriority {
        let hpms = self.inner.regs.hpms().read();
        let storage = match hpms.msi() {
            HpmsMsi::None_ => HighPriorityStorage::None,
            HpmsMsi::MessageLost => HighPriorityStorage::Lost,
            HpmsMsi::Fifo0 => HighPriorityStorage::Fifo(RxFifo::Fifo0, hpms.bidx()),
            HpmsMsi::Fifo1 => HighPriorityStorage::Fifo(RxFifo::Fifo1, hpms.bidx()),
        };
        HighPriority { extended: hpms.flst() == HpmsFlst::Extended, filter: hpms.fidx(), storage }
    }

    /// Which debug messages have been received (3.4.4).
    #[must_use]
    pub fn debug_state(&self) -> DebugState {
        self.inner.regs.rxf1s().read().dms()
    }

    /// The timestamp counter (2.3.10).
    #[must_use]
    pub fn timestamp_counter(&self) -> u16 {
        self.inner.regs.tscv().read().tsc()
    }

    /// Sets the internal timestamp counter to 0. This is no wrap: IR.TSW is not set (2.3.10).
    pub fn reset_timestamp_counter(&mut self) {
        self.inner.regs.tscv().write(pac::Tscv::ZERO);
    }

    /// The timeout counter (2.3.12).
    #[must_use]
    pub fn timeout_counter(&self) -> u16 {
        self.inner.regs.tocv().read().toc()
    }

    /// Sets the timeout counter to its start value, in Continuous Mode only (2.3.12, 3.3).
    pub fn restart_timeout_counter(&mut self) {
        self.inner.regs.tocv().write(pac::Tocv::ZERO);
    }
}

impl<R: Bus, M: Bus> Can<Running, R, M> {
    /// True if hardware has stopped the controller by setting CCCR.INIT: because the node is bus off, or because a word of
    /// the Message RAM could not be read (IR.BEU). Destroys nothing, unlike [`Can::protocol_status`] (2.3.14, 3.1.1).
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.inner.regs.cccr().read().init()
    }
}

impl<R: Bus, M: Bus> Can<LoopBack, R, M> {
    /// What comes in at the receive pin (2.3.5).
    #[must_use]
    pub fn receive_pin(&self) -> bool {
        self.inner.regs.test().read().rx() == m_can_pac::enums::TestRx::Recessive
    }
}
