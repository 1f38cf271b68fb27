//! Bit timing, CAN FD options and transmitter delay compensation (2.3.4, 2.3.8, 2.3.15, 3.1.3, 3.1.4).

use can_wire::{BitTiming, DelayCompensation, DelaySource, FdSupport, NodeConfig, ProtocolException, RequestError};
use m_can_pac::{enums::CccrNiso, registers as pac};

use super::MCanModel;
use crate::{diagnostic::DiagnosticKind, model::Context};

/// 3.1.4.1: the largest position of the secondary sample point in CAN clock periods.
const LONGEST_SECONDARY_SAMPLE_POINT: u16 = 127;

impl MCanModel {
    /// The node as the registers describe it.
    fn node_config(&self, place: NodeConfig) -> NodeConfig {
        let cccr = self.cccr();
        let nbtp = pac::Nbtp::from_bits(self.regs.get(self.r.nbtp));
        let dbtp = pac::Dbtp::from_bits(self.regs.get(self.r.dbtp));
        let tdcr = pac::Tdcr::from_bits(self.regs.get(self.r.tdcr));
        // 2.3.4, 2.3.8: the hardware uses one more than every programmed value, also where 0 is not allowed
        // (bit_timing_zero). The jump width ends at phase segment 2 (jump_width_limit).
        let timing = |prescaler: u16, before: u8, after: u8, jump: u8| BitTiming {
            prescaler: prescaler + 1,
            prop_seg: 0,
            phase_seg1: u16::from(before) + 1,
            phase_seg2: u16::from(after) + 1,
            sjw: u16::from(jump.min(after)) + 1,
        };
        // 3.1.4.2: the filter works only if TDCF is greater than TDCO.
        let filter = if tdcr.tdcf() > tdcr.tdco() { u16::from(tdcr.tdcf()) } else { 0 };
        NodeConfig {
            nominal: timing(nbtp.nbrp(), nbtp.ntseg1(), nbtp.ntseg2(), nbtp.nsjw()),
            data: timing(u16::from(dbtp.dbrp()), dbtp.dtseg1(), dbtp.dtseg2(), dbtp.dsjw()),
            delay_compensation: dbtp.tdc().then(|| DelayCompensation {
                delay: DelaySource::Measured { filter },
                offset: i16::from(tdcr.tdco()),
                limit: LONGEST_SECONDARY_SAMPLE_POINT,
            }),
            // 3.1.3: without FDOE a CAN FD frame is taken for a classic one, which ends in an error frame.
            fd: if cccr.fdoe() { FdSupport::Fd } else { FdSupport::Classic },
            iso_crc: cccr.niso() == CccrNiso::Iso11898_1,
            // 3.1.3: PXHD makes a recessive res bit a form error.
            protocol_exception: if cccr.pxhd() { ProtocolException::FormError } else { ProtocolException::Integrate },
            // 2.3.7: EFBI.
            edge_filter: cccr.efbi(),
            // 2.3.14.
            recovery_sequences: self.config.choices.bus_off_recovery_length,
            ..place
        }
    }

    /// Sets up the node on the bus, which is off. Returns false if the registers describe none.
    pub(super) fn go_on_bus(&mut self, cx: &mut Context<'_>) -> bool {
        let config = self.node_config(*cx.wire.config(cx.node));
        match cx.wire.configure(cx.node, config) {
            Ok(()) => true,
            Err(RequestError::Timing(error)) => {
                cx.report("2.3.4, 2.3.8", DiagnosticKind::BitTiming(error));
                false
            }
            Err(error) => {
                cx.report("3.1.1", DiagnosticKind::Contradiction { what: error.to_string() });
                false
            }
        }
    }

    pub(super) fn check_bit_timing(&mut self, cx: &mut Context<'_>) {
        let dbtp = pac::Dbtp::from_bits(self.regs.get(self.r.dbtp));
        if dbtp.tdc() && dbtp.dbrp() > 1 {
            let (register, field, value) = ("DBTP", "DBRP", u32::from(dbtp.dbrp()));
            cx.report("2.3.4", DiagnosticKind::ValueOutOfRange { register, field, value, min: 0, max: 1 });
        }
        let cccr = self.cccr();
        if cccr.fdoe() && cccr.brse() {
            let config = self.node_config(*cx.wire.config(cx.node));
            let nominal = config.nominal.bit_rate(config.clock_hz);
            let data = config.data.bit_rate(config.clock_hz);
            if data < nominal {
                let what = format!("the data bit rate of {data} bit/s is below the nominal one of {nominal} bit/s");
                cx.report("2.3.4", DiagnosticKind::Contradiction { what });
            }
        }
    }

    /// Values that the description allows for no field.
    pub(super) fn check_field_ranges(&mut self, cx: &mut Context<'_>) {
        for slot in self.regs.slots() {
            let info = self.regs.info(slot);
            let word = self.regs.get(slot);
            for field in info.fields {
                let value = field.get(word, 0);
                if field.lanes == 1 && !(field.min..=field.max).contains(&value) {
                    let (register, field, min, max) = (info.name, field.name, field.min, field.max);
                    cx.report("2.3", DiagnosticKind::ValueOutOfRange { register, field, value, min, max });
                }
            }
        }
    }
}
