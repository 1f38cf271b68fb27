//! The Message RAM as the controller reaches it, and its failures (2.3.6, 2.3.16, 2.4.1).

use m_can_pac::{
    messages::RxBuffer,
    registers::{self as pac, Ir},
};

use super::MCanModel;
use crate::{diagnostic::DiagnosticKind, layout::Placed, model::Context};

/// message_ram_overrun: start addresses have 14 bits, so word addresses wrap here.
pub(super) const WORDS: u32 = 1 << 14;

/// A failure of the Message RAM that a test can bring about with [`MCanModel::fail_ram`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RamFailure {
    /// A bit error that the RAM has corrected (`m_can_aeim_berr[0]`): IR.BEC.
    Corrected,
    /// A bit error that it has not (`m_can_aeim_berr[1]`): IR.BEU and CCCR.INIT.
    Uncorrected,
    /// The RAM does not answer: the watchdog expires, if RWD.WDC has started one (2.3.6).
    NoAnswer,
    /// The Rx Handler is too late with the next message: it is dropped, IR.MRAF.
    RxTooLate,
    /// The Tx Handler is too late with the next transmission: it is aborted, IR.MRAF, Restricted Operation Mode.
    TxTooLate,
}

impl MCanModel {
    pub(super) fn ram_read(&mut self, cx: &mut Context<'_>, word: u32) -> u32 {
        let word = word % WORDS;
        let value = cx.memory(self.config.memory).word(word as usize);
        if value.is_none() {
            cx.report("2.4.1", DiagnosticKind::MemoryOverrun { address: word * 4 });
        }
        value.unwrap_or(0)
    }

    pub(super) fn ram_write(&mut self, cx: &mut Context<'_>, word: u32, value: u32) {
        let word = word % WORDS;
        if !cx.memory(self.config.memory).set_word(word as usize, value) {
            cx.report("2.4.1", DiagnosticKind::MemoryOverrun { address: word * 4 });
        }
    }

    /// Brings about a failure of the Message RAM.
    pub fn fail_ram(&mut self, cx: &mut Context<'_>, failure: RamFailure) {
        match failure {
            RamFailure::Corrected => self.raise(cx, Ir::BEC),
            RamFailure::Uncorrected => {
                self.raise(cx, Ir::BEU);
                // The event sets INIT, also while IR.BEU is still set from the one before.
                self.regs.set_field(self.f.init, 1);
            }
            RamFailure::NoAnswer => {
                // 2.3.6: a start value of 0 disables the watchdog. ram_watchdog_expiry: it is only reported.
                if pac::Rwd::from_bits(self.regs.get(self.r.rwd)).wdc() != 0 {
                    self.regs.set_field(self.f.wdv, 0);
                    self.raise(cx, Ir::WDI);
                }
            }
            RamFailure::RxTooLate => self.rx.ram_failure = true,
            RamFailure::TxTooLate => self.tx.ram_failure = true,
        }
        self.follow(cx);
    }

    /// 2.3.6, ram_watchdog_expiry: between accesses the counter shows its start value.
    pub(super) fn show_watchdog(&mut self) {
        let start = pac::Rwd::from_bits(self.regs.get(self.r.rwd)).wdc();
        self.regs.set_field(self.f.wdv, u32::from(start));
    }

    /// 2.3.16: the Tx Handler could not read a message in time: the transmission is aborted.
    pub(super) fn tx_ram_failed(&mut self, cx: &mut Context<'_>) {
        self.raise(cx, Ir::MRAF);
        if let Some(sending) = self.tx.sending.take()
            && !self.config.choices.request_survives_ram_failure
        {
            self.request_done(cx, 1 << sending.buffer, true);
        }
        self.enter_restricted_operation();
        self.follow(cx);
    }

    /// 2.4.1: nothing in hardware checks where the sections lie.
    pub(super) fn check_sections(&self, cx: &mut Context<'_>, mut sections: Vec<Placed>) {
        sections.retain(|section| section.count > 0);
        sections.sort_by_key(|section| (section.start, section.end()));
        let limit = (cx.memory(self.config.memory).len() as u32).min(WORDS) * 4;
        for section in sections.iter().filter(|section| section.end() > limit) {
            let (section, end) = (section.name, section.end());
            cx.report("2.4.1", DiagnosticKind::SectionBeyondMemory { section, end, limit });
        }
        for (index, first) in sections.iter().enumerate() {
            for second in sections[index + 1..].iter().filter(|second| second.start < first.end()) {
                let (first, second, address) = (first.name, second.name, second.start);
                cx.report("2.4.1", DiagnosticKind::SectionsOverlap { first, second, address });
            }
        }
    }

    /// Words of an Rx element with a data field of this code (Table 55).
    pub(super) fn rx_element_words(code: u8) -> u32 {
        RxBuffer::<regbus::Mmio>::bytes(usize::from(code)) as u32 / 4
    }
}
