//! System errors (12.3.6).

use dspic33_canfd_pac::registers as pac;

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// A failure that a test can bring about with [`Dspic33CanfdModel::fail`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SystemFailure {
    /// A received message cannot be written to RAM before the next one arrives: the next message received is discarded.
    RxOverflow,
    /// Data cannot be fetched fast enough: the next transmission stops after its start of frame.
    TxUnderflow,
    /// A FIFO has presented an illegal address.
    Address,
}

/// What is behind SERRIF.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SystemErrors {
    pub(super) address: bool,
    pub(super) message_buffer: bool,
    soft_traps: u64,
    pub(super) rx_overflow: bool,
    pub(super) tx_underflow: bool,
}

impl SystemErrors {
    pub(super) const fn acknowledge(&mut self) {
        self.address = false;
        self.message_buffer = false;
    }
}

impl Dspic33CanfdModel {
    /// Brings about a system error.
    pub fn fail(&mut self, _cx: &mut Context<'_>, failure: SystemFailure) {
        match failure {
            SystemFailure::RxOverflow => self.system.rx_overflow = true,
            SystemFailure::TxUnderflow => self.system.tx_underflow = true,
            SystemFailure::Address => self.raise_address_error(),
        }
    }

    /// Soft traps so far: how often the module has set bit CAN of INTCON3.
    #[must_use]
    pub const fn soft_traps(&self) -> u64 {
        self.system.soft_traps
    }

    fn raise_address_error(&mut self) {
        self.system.address = true;
        self.system.soft_traps += 1;
        self.raise(pac::IntL::SERRIF);
    }

    pub(super) fn raise_buffer_error(&mut self) {
        self.system.message_buffer = true;
        self.raise(pac::IntL::SERRIF);
    }

    /// A message object lies where no RAM is.
    pub(super) fn address_error(&mut self, cx: &mut Context<'_>, address: u32) {
        cx.report("12.3.6", DiagnosticKind::MemoryOverrun { address });
        self.raise_address_error();
    }

    /// The transmission that has just started lacks its data.
    pub(super) fn transmission_underflows(&mut self, cx: &mut Context<'_>) {
        self.raise_buffer_error();
        self.fall_back(cx);
    }
}
