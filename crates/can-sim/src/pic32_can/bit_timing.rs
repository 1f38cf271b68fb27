//! Bit timing (34.10, Register 34-2).

use can_wire::{BitTiming, FdSupport, NodeConfig, RequestError};
use pic32_can_pac::{
    enums::{CfgSam, CfgSeg2phts},
    meta::CONTROLLER,
    registers as pac,
};

use super::Pic32CanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// `segment2_automatic`: the information processing time in quanta.
const INFORMATION_PROCESSING: u16 = 2;

impl Pic32CanModel {
    fn cfg(&self) -> pac::Cfg {
        pac::Cfg::from_bits(self.regs.get(self.r.cfg))
    }

    /// Register 34-2: every field is one less than its quanta, and a quantum is 2 * (BRP + 1) system clocks.
    fn bit_timing(&self) -> BitTiming {
        let cfg = self.cfg();
        let phase_seg1 = u16::from(cfg.seg1ph()) + 1;
        BitTiming {
            prescaler: 2 * (u16::from(cfg.brp()) + 1),
            prop_seg: u16::from(cfg.prseg()) + 1,
            phase_seg1,
            phase_seg2: match cfg.seg2phts() {
                CfgSeg2phts::Automatic => phase_seg1.max(INFORMATION_PROCESSING),
                CfgSeg2phts::Programmable => u16::from(cfg.seg2ph()) + 1,
            },
            sjw: u16::from(cfg.sjw()) + 1,
        }
    }

    /// Sets up the node, which is off. Returns false if the registers describe none.
    pub(super) fn go_on_bus(&mut self, cx: &mut Context<'_>) -> bool {
        let nominal = self.bit_timing();
        self.check_bit_timing(cx, nominal);
        if self.config.choices.segment2_reads_length && self.cfg().seg2phts() == CfgSeg2phts::Automatic {
            self.regs.set_field(self.f.seg2ph, u32::from(nominal.phase_seg2) - 1);
        }
        // 34.1: CAN 2.0B, no CAN FD.
        let config = NodeConfig {
            nominal,
            fd: FdSupport::Classic,
            delay_compensation: None,
            wake_on_edge: false,
            ..*cx.wire.config(cx.node)
        };
        match cx.wire.configure(cx.node, config) {
            Ok(()) => true,
            Err(RequestError::Timing(error)) => {
                cx.report("34.10", DiagnosticKind::BitTiming(error));
                false
            }
            Err(error) => {
                cx.report("34.10", DiagnosticKind::Contradiction { what: error.to_string() });
                false
            }
        }
    }

    fn check_bit_timing(&self, cx: &mut Context<'_>, timing: BitTiming) {
        let cfg = self.cfg();
        let mut report = |what: String| cx.report("34.10, Register 34-2", DiagnosticKind::Contradiction { what });
        if let Some(limits) = CONTROLLER.bit_timing.map(|timing| timing.nominal) {
            let (quanta, min, max) = (timing.quanta() as u32, limits.min_quanta, limits.max_quanta);
            if !(min..=max).contains(&quanta) {
                report(format!("a bit of {quanta} quanta, legal are {min} to {max}"));
            }
            let rate = timing.bit_rate(self.config.place.clock_hz);
            if limits.max_bit_rate.is_some_and(|max| rate > max) {
                report(format!("{rate} bit/s are more than the module reaches"));
            }
        }
        if timing.phase_seg2 > timing.phase_seg1 && cfg.seg2phts() == CfgSeg2phts::Programmable {
            let (second, first) = (timing.phase_seg2, timing.phase_seg1);
            report(format!("phase segment 2 of {second} quanta is longer than phase segment 1 of {first}"));
        }
        if timing.sjw > timing.phase_seg2 {
            let (jump, second) = (timing.sjw, timing.phase_seg2);
            report(format!("a jump width of {jump} quanta is longer than phase segment 2 of {second}"));
        }
        if cfg.sam() == CfgSam::ThreeTimes && cfg.brp() < 2 {
            report(format!("three samples with BRP = {}, which has to be 2 or more", cfg.brp()));
        }
    }
}
