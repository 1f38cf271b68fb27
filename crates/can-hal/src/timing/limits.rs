//! What a controller allows, from its description.

use regbus::meta::{self, Controller, FieldRef};

use super::{BitTiming, Bound, DelayCompensation, Phase, SegmentFault, Segments};

/// What a field may be set to, as the number it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FieldRange {
    /// Smallest number.
    pub min: u32,
    /// Largest number.
    pub max: u32,
    /// The number is the programmed value plus this.
    add: i32,
}

impl FieldRange {
    const fn of(controller: &Controller, at: FieldRef) -> Self {
        let field = &controller.registers[at.register as usize].fields[at.field as usize];
        let (min, max) = if field.signed { (0, field.max >> 1) } else { (field.min, field.max) };
        Self { min: min.saturating_add_signed(field.add), max: max.saturating_add_signed(field.add), add: field.add }
    }

    /// A field that is programmed with the number minus 1, as most are: for controllers without a description here.
    #[must_use]
    pub const fn less_one(min: u32, max: u32) -> Self {
        Self { min, max, add: 1 }
    }

    /// Whether the field can be set to a number.
    #[must_use]
    pub const fn contains(&self, number: u32) -> bool {
        self.min <= number && number <= self.max
    }

    /// The value to program for a number; that of the nearest number if it is out of range.
    #[must_use]
    pub const fn encode(&self, number: u32) -> u32 {
        self.clamp(number).saturating_add_signed(-self.add)
    }

    /// The number that a programmed value means.
    #[must_use]
    pub const fn decode(&self, value: u32) -> u32 {
        value.saturating_add_signed(self.add)
    }

    /// The nearest number that is in range.
    #[must_use]
    pub const fn clamp(&self, number: u32) -> u32 {
        if number < self.min {
            self.min
        } else if number > self.max {
            self.max
        } else {
            number
        }
    }
}

/// What one phase allows. All numbers are meanings, not programmed values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PhaseLimits {
    /// Prescaler.
    pub prescaler: FieldRange,
    /// Propagation segment, where it is a field of its own.
    pub propagation: Option<FieldRange>,
    /// Phase segment 1, or propagation segment and phase segment 1 together.
    pub phase1: FieldRange,
    /// Phase segment 2.
    pub phase2: FieldRange,
    /// Jump width.
    pub jump_width: FieldRange,
    /// Fewest time quanta in a bit.
    pub min_quanta: u32,
    /// Most time quanta in a bit.
    pub max_quanta: u32,
    /// Highest bit rate in bit/s.
    pub max_bit_rate: Option<u32>,
    /// What phase segment 2 must not be longer than.
    pub phase2_within: meta::Phase2Within,
    /// The jump width must be shorter than phase segment 2, not only as long.
    pub jump_width_below_phase2: bool,
    /// Smallest prescaler for sampling three times; `None` if the controller samples once.
    pub three_samples_prescaler: Option<u32>,
}

impl PhaseLimits {
    const fn of(controller: &Controller, phase: &meta::TimingPhase) -> Self {
        Self {
            prescaler: FieldRange::of(controller, phase.prescaler),
            propagation: match phase.propagation {
                Some(at) => Some(FieldRange::of(controller, at)),
                None => None,
            },
            phase1: FieldRange::of(controller, phase.segment1),
            phase2: FieldRange::of(controller, phase.segment2),
            jump_width: FieldRange::of(controller, phase.jump_width),
            min_quanta: phase.min_quanta,
            max_quanta: phase.max_quanta,
            max_bit_rate: phase.max_bit_rate,
            phase2_within: phase.phase2_within,
            jump_width_below_phase2: phase.jump_width_below_phase2,
            three_samples_prescaler: match phase.three_samples {
                Some(samples) => Some(samples.min_prescaler),
                None => None,
            },
        }
    }

    /// The longest jump width that goes with phase segments of these lengths.
    #[must_use]
    pub const fn longest_jump_width(&self, phase1: u32, phase2: u32) -> u32 {
        // One quantum is the least there is, so that the stricter rule cannot be kept with a phase segment 2 of 1.
        let after = if self.jump_width_below_phase2 && phase2 > 1 { phase2 - 1 } else { phase2 };
        let shorter = if phase1 < after { phase1 } else { after };
        if shorter < self.jump_width.max { shorter } else { self.jump_width.max }
    }

    /// Checks the segments of a bit.
    pub(super) const fn check(&self, phase: Phase, segments: &Segments) -> Result<(), SegmentFault> {
        let before = segments.propagation.saturating_add(segments.phase1);
        let (propagation, phase1) = match self.propagation {
            Some(range) => (range.contains(segments.propagation), segments.phase1),
            None => (true, before),
        };
        let quanta = segments.quanta();
        let bound = if !self.prescaler.contains(segments.prescaler) {
            Bound::Prescaler
        } else if !propagation {
            Bound::Propagation
        } else if !self.phase1.contains(phase1) || segments.phase1 == 0 {
            Bound::Phase1
        } else if !self.phase2.contains(segments.phase2) {
            Bound::Phase2
        } else if !self.phase2_fits(segments.phase1, before, segments.phase2) {
            Bound::Phase2WithinPhase1
        } else if quanta < self.min_quanta || quanta > self.max_quanta {
            Bound::Quanta
        } else if !self.jump_width.contains(segments.jump_width)
            || segments.jump_width > segments.phase1
            || segments.jump_width > segments.phase2
        {
            Bound::JumpWidth
        } else {
            return Ok(());
        };
        Err(SegmentFault { phase, bound })
    }

    const fn phase2_fits(&self, phase1: u32, before: u32, phase2: u32) -> bool {
        match self.phase2_within {
            meta::Phase2Within::Anything => true,
            meta::Phase2Within::Phase1 => phase2 <= phase1,
            meta::Phase2Within::PropagationAndPhase1 => phase2 <= before,
        }
    }
}

/// What the offset of the transmitter delay compensation has to be for a secondary sample point that lies where the data
/// sample point lies.
pub use regbus::meta::OffsetReference;

/// What transmitter delay compensation allows, in periods of the CAN clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DelayLimits {
    /// Offset; negative ones are not used.
    pub offset: FieldRange,
    /// Filter window, where there is one.
    pub filter: Option<FieldRange>,
    /// Where the offset counts from.
    pub reference: OffsetReference,
    /// Largest prescaler of the data phase.
    pub max_prescaler: u32,
    /// Largest position of the secondary sample point; a longer delay is taken as this.
    pub max_position: Option<u32>,
    /// The secondary sample point lies before the end of this many data bits.
    pub max_bits: Option<u32>,
}

impl DelayLimits {
    /// ISO 11898-1:2015, 11.3.3: compensation only with a data prescaler of 1 or 2. For manuals that do not say it themselves.
    const ISO_MAX_PRESCALER: u32 = 2;

    const fn of(controller: &Controller, delay: &meta::TransmitterDelay) -> Self {
        Self {
            offset: FieldRange::of(controller, delay.offset),
            filter: match delay.filter {
                Some(at) => Some(FieldRange::of(controller, at)),
                None => None,
            },
            reference: delay.reference,
            max_prescaler: match delay.max_prescaler {
                Some(max) => max,
                None => Self::ISO_MAX_PRESCALER,
            },
            max_position: delay.max_position,
            max_bits: delay.max_bits,
        }
    }

    /// The offset that puts the secondary sample point where the sample point of the data phase is, in clock periods.
    #[must_use]
    pub const fn offset_for(&self, data: &Segments) -> u32 {
        let quanta = match self.reference {
            OffsetReference::SamplePoint => data.before_sample(),
            OffsetReference::Segment1 => data.before_sample() - Segments::SYNC,
        };
        self.offset.clamp(quanta.saturating_mul(data.prescaler))
    }

    const fn check(&self, data: &Segments, compensation: DelayCompensation) -> Result<(), SegmentFault> {
        let filter = match self.filter {
            Some(range) => range.contains(compensation.filter),
            None => compensation.filter == 0,
        };
        let bound = if data.prescaler > self.max_prescaler {
            Bound::CompensatedPrescaler
        } else if !self.offset.contains(compensation.offset) {
            Bound::CompensationOffset
        } else if !filter {
            Bound::CompensationFilter
        } else {
            return Ok(());
        };
        Err(SegmentFault { phase: Phase::Data, bound })
    }
}

/// What a controller's bit timing allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Limits {
    /// The controller's identifier.
    pub controller: &'static str,
    /// The manual's name of the clock.
    pub clock: &'static str,
    /// Fixed divider in front of the prescaler.
    pub divider: u32,
    /// Highest clock frequency in hertz.
    pub max_clock: Option<u32>,
    /// Arbitration phase.
    pub nominal: PhaseLimits,
    /// Data phase.
    pub data: Option<PhaseLimits>,
    /// Transmitter delay compensation.
    pub delay: Option<DelayLimits>,
}

/// The limits of a controller whose description is known to have a bit timing.
macro_rules! known {
    ($controller:expr) => {
        match Limits::of($controller) {
            Some(limits) => limits,
            None => panic!("the description has no bit timing"),
        }
    };
}

impl Limits {
    /// Bosch M_CAN (2.3.4, 2.3.8, 2.3.15).
    pub const M_CAN: Self = known!(&m_can_pac::meta::CONTROLLER);
    /// Microchip dsPIC33 CAN FD (5.3).
    pub const DSPIC33_CANFD: Self = known!(&dspic33_canfd_pac::meta::CONTROLLER);
    /// Microchip dsPIC33F/PIC24H ECAN (6.0).
    pub const DSPIC33_ECAN: Self = known!(&dspic33_ecan_pac::meta::CONTROLLER);
    /// Microchip PIC32 CAN (34.10).
    pub const PIC32_CAN: Self = known!(&pic32_can_pac::meta::CONTROLLER);
    /// All of them.
    pub const ALL: [Self; 4] = [Self::M_CAN, Self::DSPIC33_CANFD, Self::DSPIC33_ECAN, Self::PIC32_CAN];

    /// The limits that a description states; `None` if it has no bit timing.
    #[must_use]
    pub const fn of(controller: &Controller) -> Option<Self> {
        let Some(timing) = &controller.bit_timing else { return None };
        Some(Self {
            controller: controller.name,
            clock: timing.clock,
            divider: timing.divider,
            max_clock: timing.max_clock,
            nominal: PhaseLimits::of(controller, &timing.nominal),
            data: match &timing.data {
                Some(phase) => Some(PhaseLimits::of(controller, phase)),
                None => None,
            },
            delay: match &timing.transmitter_delay {
                Some(delay) => Some(DelayLimits::of(controller, delay)),
                None => None,
            },
        })
    }

    /// Checks a bit timing, however it was made.
    ///
    /// # Errors
    ///
    /// The phase and the limit that is not kept. Rules that a manual only recommends, such as a jump width below phase
    /// segment 2, are not checked.
    pub const fn check(&self, timing: &BitTiming) -> Result<(), SegmentFault> {
        if let Err(fault) = self.nominal.check(Phase::Nominal, &timing.nominal) {
            return Err(fault);
        }
        if timing.three_samples {
            let fits = match self.nominal.three_samples_prescaler {
                Some(min) => timing.nominal.prescaler >= min,
                None => false,
            };
            if !fits {
                return Err(SegmentFault { phase: Phase::Nominal, bound: Bound::ThreeSamples });
            }
        }
        let Some(data) = &timing.data else { return Ok(()) };
        let Some(limits) = &self.data else {
            return Err(SegmentFault { phase: Phase::Data, bound: Bound::NoDataPhase });
        };
        if let Err(fault) = limits.check(Phase::Data, &data.segments) {
            return Err(fault);
        }
        let nominal = timing.nominal.prescaler as u64 * timing.nominal.quanta() as u64;
        if data.segments.prescaler as u64 * data.segments.quanta() as u64 > nominal {
            return Err(SegmentFault { phase: Phase::Data, bound: Bound::DataBelowNominal });
        }
        match (data.compensation, &self.delay) {
            (None, _) => Ok(()),
            (Some(compensation), Some(limits)) => limits.check(&data.segments, compensation),
            (Some(_), None) => Err(SegmentFault { phase: Phase::Data, bound: Bound::NoCompensation }),
        }
    }
}
