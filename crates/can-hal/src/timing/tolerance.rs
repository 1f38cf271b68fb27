//! Oscillator tolerance.

use super::{BitTiming, Segments};

/// What the clock of a node may deviate from its nominal frequency, in ppm (rounded down), condition by condition.
///
/// The conditions are those of ISO 11898-1 as dsPIC33 CAN FD 5.3.6 prints them (Equations 5-12 to 5-16). All hold for two
/// nodes whose clocks deviate in opposite directions; the smallest counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tolerance {
    /// Condition 1: resynchronization across the longest run of equal bits, 10 bit times.
    pub resynchronization: u32,
    /// Condition 2: sampling of the bit after an error flag, up to 13 bit times after the last edge.
    pub after_error_flag: u32,
    /// Condition 3: resynchronization in the data phase.
    pub data_resynchronization: Option<u32>,
    /// Condition 4: sampling of the bit after an error flag that begins in the data phase.
    pub after_data_error_flag: Option<u32>,
    /// Condition 5: switch of the bit rate. 0 if the quanta of the two phases differ by more than the jump width can make up
    /// for.
    pub rate_switch: Option<u32>,
}

/// `numerator / denominator` in ppm, 0 if that is negative.
const fn ppm(numerator: i64, denominator: i64) -> u32 {
    if numerator <= 0 || denominator <= 0 {
        return 0;
    }
    let value = numerator as i128 * 1_000_000 / denominator as i128;
    if value > u32::MAX as i128 { u32::MAX } else { value as u32 }
}

const fn shorter_phase(segments: &Segments) -> i64 {
    (if segments.phase1 < segments.phase2 { segments.phase1 } else { segments.phase2 }) as i64
}

impl Tolerance {
    /// The tolerance of a bit timing.
    #[must_use]
    pub const fn of(timing: &BitTiming) -> Self {
        let nominal = &timing.nominal;
        let bit = nominal.quanta() as i64;
        let shorter = shorter_phase(nominal);
        let phase2 = nominal.phase2 as i64;
        let classic = Self {
            // Equation 5-12.
            resynchronization: ppm(nominal.jump_width as i64, 2 * 10 * bit),
            // Equation 5-13.
            after_error_flag: ppm(shorter, 2 * (13 * bit - phase2)),
            data_resynchronization: None,
            after_data_error_flag: None,
            rate_switch: None,
        };
        let Some(data) = &timing.data else { return classic };
        let data = &data.segments;
        let (data_bit, data_phase2) = (data.quanta() as i64, data.phase2 as i64);
        // Both sides of Equations 5-15 and 5-16 are multiplied by the prescaler they divide by.
        let (n, d) = (nominal.prescaler as i64, data.prescaler as i64);
        let lost = if n > d { n - d } else { 0 };
        Self {
            // Equation 5-14.
            data_resynchronization: Some(ppm(data.jump_width as i64, 2 * 10 * data_bit)),
            // Equation 5-15.
            after_data_error_flag: Some(ppm(shorter * n, 2 * ((6 * data_bit - data_phase2) * d + 7 * bit * n))),
            // Equation 5-16, with the minus sign that the print has lost: only so the result of Table 5-4 comes out.
            rate_switch: Some(ppm(
                data.jump_width as i64 * d - lost,
                2 * ((2 * bit - phase2) * n + (data_phase2 + 4 * data_bit) * d),
            )),
            ..classic
        }
    }

    /// The smallest of the conditions, in ppm.
    #[must_use]
    pub const fn min(&self) -> u32 {
        let conditions = [
            Some(self.resynchronization),
            Some(self.after_error_flag),
            self.data_resynchronization,
            self.after_data_error_flag,
            self.rate_switch,
        ];
        let (mut least, mut i) = (u32::MAX, 0);
        while i < conditions.len() {
            if let Some(value) = conditions[i]
                && value < least
            {
                least = value;
            }
            i += 1;
        }
        least
    }
}
