//! The pulse on input capture IC2 (14.0).

use can_wire::Time;
use dspic33_ecan_pac::registers as pac;

use super::EcanModel;
use crate::model::Context;

/// Pulses so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Captures {
    /// How many there have been.
    pub count: u64,
    /// Start of the latest one: the end of the last bit of EOF.
    pub start: Time,
    /// Its end, one bit time later.
    pub end: Time,
}

impl EcanModel {
    /// A valid message was accepted. The event comes at the sample point of the last but one bit of EOF, at which the
    /// message is valid for a receiver.
    pub(super) fn capture(&mut self, cx: &Context<'_>) {
        if !pac::Ctrl1::from_bits(self.regs.get(self.n.ctrl1) as u16).cancap() {
            return;
        }
        let config = cx.wire.config(cx.node);
        let bit = config.nominal_bit();
        let quanta = config.nominal.quanta();
        let rest = Time::from_ps(bit.as_ps() * u64::from(config.nominal.phase_seg2) / quanta);
        let start = cx.now + rest + bit;
        self.captures = Captures { count: self.captures.count + 1, start, end: start + bit };
    }

    /// The pulses that CANCAP has made. The module ends when the signal is made; the input capture belongs to the device.
    #[must_use]
    pub const fn captures(&self) -> Captures {
        self.captures
    }
}
