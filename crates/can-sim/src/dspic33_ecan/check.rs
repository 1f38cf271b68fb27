//! What is written in the registers cannot all be meant: looked at when Configuration mode is left.

use dspic33_ecan_pac::{enums::Ctrl1Win, registers as pac};

use super::EcanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

impl EcanModel {
    pub(super) fn check_configuration(&mut self, cx: &mut Context<'_>) {
        self.check_bit_timing(cx);
        self.check_fifo(cx);
        self.check_mask_sources(cx);
        self.check_data_bit_count(cx);
        if pac::Ctrl1::from_bits(self.regs.get(self.n.ctrl1) as u16).win() == Ctrl1Win::Filter {
            let what = "Configuration mode is left with the filter window selected: no buffer can be served".to_owned();
            cx.report("9.1.4", DiagnosticKind::Contradiction { what });
        }
    }

    /// mask_code_3.
    fn check_mask_sources(&self, cx: &mut Context<'_>) {
        let enabled = self.enabled_filters();
        for filter in (0..16).filter(|filter| enabled >> filter & 1 == 1) {
            if let Err(code) = self.mask_source(filter) {
                let value = u32::from(code);
                cx.report("9.1.2", DiagnosticKind::ReservedValue { register: "FMSKSEL", field: "FMSK", value });
            }
        }
    }

    /// Register 4-24 (`dncnt_above_18`).
    fn check_data_bit_count(&self, cx: &mut Context<'_>) {
        if let Err(code) = pac::Ctrl2::from_bits(self.regs.get(self.n.ctrl2) as u16).dncnt() {
            let (register, field, value) = ("CTRL2", "DNCNT", u32::from(code));
            cx.report("Register 4-24", DiagnosticKind::ValueOutOfRange { register, field, value, min: 0, max: 18 });
        }
    }

    /// CxFMSKSEL was written while the module is on the bus.
    pub(super) fn fmsksel_written(&mut self, cx: &mut Context<'_>) {
        if !super::modes::is_off(self.modes.now) {
            self.check_mask_sources(cx);
        }
    }

    /// CxCTRL2 was written while the module is on the bus.
    pub(super) fn ctrl2_written(&mut self, cx: &mut Context<'_>) {
        if !super::modes::is_off(self.modes.now) {
            self.check_data_bit_count(cx);
        }
    }
}
