//! Bit timing, CAN FD options and transmitter delay compensation (5.2, 5.3).

use can_wire::{BitTiming, DelayCompensation, DelaySource, FdSupport, NodeConfig, ProtocolException, RequestError};
use dspic33_canfd_pac::{
    enums::{ConLIsocrcen, ConLPxedis, OperationMode, TdcHTdcmod},
    registers as pac,
};

use super::Dspic33CanfdModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// Table 5-4, Register 3-7: the largest transceiver delay that TDCV can hold, in CAN clock periods.
const LONGEST_DELAY: i16 = 63;

impl Dspic33CanfdModel {
    /// The node as the registers describe it.
    fn node_config(&self, place: NodeConfig, mode: OperationMode) -> NodeConfig {
        let con = self.con_l();
        let (nominal_l, nominal_h) =
            (pac::NbtcfgL::from_bits(self.word(self.r.nbtcfg_l)), pac::NbtcfgH::from_bits(self.word(self.r.nbtcfg_h)));
        let (data_l, data_h) =
            (pac::DbtcfgL::from_bits(self.word(self.r.dbtcfg_l)), pac::DbtcfgH::from_bits(self.word(self.r.dbtcfg_h)));
        let tdc_h = pac::TdcH::from_bits(self.word(self.r.tdc_h));
        // Registers 3-3 to 3-6: one more than every programmed value.
        let timing = |prescaler: u8, before: u8, after: u8, jump: u8| BitTiming {
            prescaler: u16::from(prescaler) + 1,
            prop_seg: 0,
            phase_seg1: u16::from(before) + 1,
            phase_seg2: u16::from(after) + 1,
            sjw: u16::from(jump) + 1,
        };
        NodeConfig {
            nominal: timing(nominal_h.brp(), nominal_h.tseg1(), nominal_l.tseg2(), nominal_l.sjw()),
            data: timing(data_h.brp(), data_h.tseg1(), data_l.tseg2(), data_l.sjw()),
            delay_compensation: self.delay_compensation(tdc_h.tdcmod()),
            // 4.3.2: in Normal CAN 2.0 mode an FD frame ends in an error frame.
            fd: if mode == OperationMode::NormalCan2_0 { FdSupport::Classic } else { FdSupport::Fd },
            iso_crc: con.isocrcen() == ConLIsocrcen::Iso11898_1,
            protocol_exception: match con.pxedis() {
                ConLPxedis::BusIntegration => ProtocolException::Integrate,
                ConLPxedis::FormError => ProtocolException::FormError,
            },
            edge_filter: tdc_h.edgflten(),
            // 13.1.
            recovery_sequences: 128,
            wake_on_edge: false,
            ..place
        }
    }

    /// 5.3.3, Registers 3-7 and 3-8.
    fn delay_compensation(&self, mode: TdcHTdcmod) -> Option<DelayCompensation> {
        let tdc = pac::TdcL::from_bits(self.word(self.r.tdc_l));
        let offset = i16::from(tdc.tdco());
        let delay = match mode {
            TdcHTdcmod::Disabled => return None,
            TdcHTdcmod::Manual => DelaySource::Fixed(u16::from(tdc.tdcv())),
            TdcHTdcmod::Automatic(_) => DelaySource::Measured { filter: 0 },
        };
        let limit = (LONGEST_DELAY + offset).max(0).unsigned_abs();
        Some(DelayCompensation { delay, offset, limit })
    }

    /// `measured_delay`.
    pub(super) fn show_measured_delay(&mut self, delay: u16) {
        if self.config.choices.measured_delay_is_shown {
            self.regs.set_field(self.f.tdcv, u32::from(delay.min(LONGEST_DELAY.unsigned_abs())));
        }
    }

    /// Sets up the node on the bus, which is off. Returns false if the registers describe none.
    pub(super) fn configure_node(&mut self, cx: &mut Context<'_>, mode: OperationMode) -> bool {
        let config = self.node_config(*cx.wire.config(cx.node), mode);
        match cx.wire.configure(cx.node, config) {
            Ok(()) => true,
            Err(RequestError::Timing(error)) => {
                cx.report("5.3", DiagnosticKind::BitTiming(error));
                false
            }
            Err(error) => {
                cx.report("4.1", DiagnosticKind::Contradiction { what: error.to_string() });
                false
            }
        }
    }

    /// Tables 5-1 to 5-4.
    pub(super) fn check_bit_timing(&mut self, cx: &mut Context<'_>) {
        let con_h = self.con_h();
        let config = self.node_config(*cx.wire.config(cx.node), con_h.reqop());
        let nominal_h = pac::NbtcfgH::from_bits(self.word(self.r.nbtcfg_h));
        if nominal_h.tseg1() == 0 {
            // ntseg1_minimum.
            let (register, field) = ("NBTCFGH", "TSEG1");
            cx.report(
                "5.3, Table 5-1",
                DiagnosticKind::ValueOutOfRange { register, field, value: 0, min: 1, max: 255 },
            );
        }
        let jumps = [("NBTCFGL", config.nominal), ("DBTCFGL", config.data)];
        for (register, timing) in jumps.into_iter().filter(|(_, timing)| timing.sjw > timing.phase_seg2) {
            let (field, value, max) = ("SJW", u32::from(timing.sjw) - 1, u32::from(timing.phase_seg2) - 1);
            cx.report("5.3.8", DiagnosticKind::ValueOutOfRange { register, field, value, min: 0, max });
        }
        let rates = [("nominal", config.nominal, 1_000_000), ("data", config.data, 8_000_000)];
        for (phase, timing, max) in rates {
            let rate = timing.bit_rate(config.clock_hz);
            if rate > max {
                let what = format!("the {phase} bit rate of {rate} bit/s is above {max} bit/s");
                cx.report("1.1", DiagnosticKind::Contradiction { what });
            }
        }
    }
}
