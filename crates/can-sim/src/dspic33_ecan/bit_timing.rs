//! Bit timing (6.0, Registers 4-1 and 4-2).
//!
//! The wire samples once in a bit: CxCFG2.SAM is kept, and three samples (6.2) are not taken.

use can_wire::{BitTiming, FdSupport, NodeConfig, RequestError};
use dspic33_ecan_pac::{enums::Cfg2Seg2phts, meta::CONTROLLER, registers as pac};

use super::EcanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

impl EcanModel {
    /// The bit time that the registers describe, in periods of FCY.
    fn bit_timing(&self) -> BitTiming {
        let cfg1 = pac::Cfg1::from_bits(self.regs.get(self.n.cfg1) as u16);
        let cfg2 = pac::Cfg2::from_bits(self.regs.get(self.n.cfg2) as u16);
        let divider = CONTROLLER.bit_timing.map_or(1, |timing| timing.divider as u16);
        let phase_seg1 = u16::from(cfg2.seg1ph()) + 1;
        let phase_seg2 = match cfg2.seg2phts() {
            Cfg2Seg2phts::Programmable => u16::from(cfg2.seg2ph()) + 1,
            // segment2_automatic.
            Cfg2Seg2phts::Seg1phOrIpt => phase_seg1.max(u16::from(self.config.choices.information_processing_time)),
        };
        BitTiming {
            // Figure 6-1: the prescaler divides half of FCY.
            prescaler: divider * (u16::from(cfg1.brp()) + 1),
            prop_seg: u16::from(cfg2.prseg()) + 1,
            phase_seg1,
            phase_seg2,
            sjw: u16::from(cfg1.sjw()) + 1,
        }
    }

    /// Sets up the node on the bus. Returns false if the registers describe none.
    pub(super) fn go_on_bus(&mut self, cx: &mut Context<'_>) -> bool {
        cx.wire.set_mode(cx.node, can_wire::Mode::Off);
        let nominal = self.bit_timing();
        // 1.0: CAN 2.0B, which knows no CAN FD: an FD frame ends in an error.
        let config = NodeConfig {
            nominal,
            data: nominal,
            delay_compensation: None,
            fd: FdSupport::Classic,
            wake_on_edge: false,
            ..*cx.wire.config(cx.node)
        };
        match cx.wire.configure(cx.node, config) {
            Ok(()) => true,
            Err(RequestError::Timing(error)) => {
                cx.report("6.0", DiagnosticKind::BitTiming(error));
                false
            }
            Err(error) => {
                cx.report("6.0", DiagnosticKind::Contradiction { what: error.to_string() });
                false
            }
        }
    }

    /// bit_timing_limits: what the manual forbids is reported, and used as programmed.
    pub(super) fn check_bit_timing(&self, cx: &mut Context<'_>) {
        let timing = self.bit_timing();
        let Some(limits) = CONTROLLER.bit_timing.map(|timing| timing.nominal) else { return };
        let mut wrong = |section, what: String| cx.report(section, DiagnosticKind::Contradiction { what });
        let quanta = timing.quanta();
        let (min, max) = (u64::from(limits.min_quanta), u64::from(limits.max_quanta));
        if !(min..=max).contains(&quanta) {
            wrong("6.0", format!("a bit time has {quanta} time quanta, legal are {min} to {max}"));
        }
        let before = timing.prop_seg + timing.phase_seg1;
        if before < timing.phase_seg2 {
            let after = timing.phase_seg2;
            wrong(
                "6.4",
                format!("propagation segment and phase segment 1 have {before} quanta, phase segment 2 {after}"),
            );
        }
        let (jump, after) = (timing.sjw, timing.phase_seg2);
        if jump > after || (jump == after && self.config.choices.equal_jump_width_reported) {
            wrong("6.4", format!("the jump width of {jump} quanta is not below phase segment 2 of {after}"));
        }
        let rate = timing.bit_rate(self.config.place.clock_hz);
        if let Some(limit) = limits.max_bit_rate.filter(|limit| rate > *limit) {
            wrong("1.0", format!("the bit rate is {rate} bit/s, at most {limit} bit/s are possible"));
        }
    }
}
