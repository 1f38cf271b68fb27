//! A bit timing as register values.

use dspic33_canfd_pac::{enums as canfd, registers as canfd_registers};
use dspic33_ecan_pac::{enums as ecan, registers as ecan_registers};
use m_can_pac::registers as m_can_registers;
use pic32_can_pac::{enums as pic32, registers as pic32_registers};

use super::{
    BitTiming, DelayCompensation, FieldRange, Limits, PhaseLimits, Request, SegmentFault, Segments, TimingError,
};

/// The programmed values of a phase.
struct Codes {
    prescaler: u32,
    propagation: u32,
    segment1: u32,
    segment2: u32,
    jump_width: u32,
}

impl Codes {
    const fn of(limits: &PhaseLimits, segments: &Segments) -> Self {
        let (propagation, segment1) = match limits.propagation {
            Some(range) => (range.encode(segments.propagation), limits.phase1.encode(segments.phase1)),
            None => (0, limits.phase1.encode(segments.propagation.saturating_add(segments.phase1))),
        };
        Self {
            prescaler: limits.prescaler.encode(segments.prescaler),
            propagation,
            segment1,
            segment2: limits.phase2.encode(segments.phase2),
            jump_width: limits.jump_width.encode(segments.jump_width),
        }
    }
}

/// The two ways to a register type that all controllers have.
macro_rules! ways {
    ($type:ident, $limits:ident) => {
        impl $type {
            /// The best timing for a request.
            ///
            /// # Errors
            ///
            /// See [`Limits::solve`].
            pub const fn solve(request: &Request) -> Result<Self, TimingError> {
                match Limits::$limits.solve(request) {
                    Ok(solution) => match Self::of(&solution.timing) {
                        Ok(registers) => Ok(registers),
                        Err(fault) => Err(TimingError::Limit(fault)),
                    },
                    Err(error) => Err(error),
                }
            }

            /// The best timing for a request that is known to have one: for a `const`, where an impossible request does not
            /// compile.
            ///
            /// # Panics
            ///
            /// If [`Self::solve`] finds nothing.
            #[must_use]
            #[track_caller]
            pub const fn fixed(request: &Request) -> Self {
                match Self::solve(request) {
                    Ok(registers) => registers,
                    Err(error) => panic!("{}", error.text()),
                }
            }
        }
    };
}

/// Bit timing of the M_CAN. All three registers take writes only with `CCCR.INIT` and `CCCR.CCE`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MCanTiming {
    /// Nominal bit timing (2.3.8).
    pub nbtp: m_can_registers::Nbtp,
    /// Data bit timing, and the switch of the transmitter delay compensation (2.3.4). The reset value without a data phase.
    pub dbtp: m_can_registers::Dbtp,
    /// Transmitter delay compensation (2.3.15). The reset value without.
    pub tdcr: m_can_registers::Tdcr,
}

ways!(MCanTiming, M_CAN);

impl MCanTiming {
    /// The register values of a timing.
    ///
    /// # Errors
    ///
    /// The limit that the timing does not keep.
    pub const fn of(timing: &BitTiming) -> Result<Self, SegmentFault> {
        use m_can_registers::{Dbtp, Nbtp, Tdcr};
        const LIMITS: Limits = Limits::M_CAN;
        if let Err(fault) = LIMITS.check(timing) {
            return Err(fault);
        }
        let codes = Codes::of(&LIMITS.nominal, &timing.nominal);
        let nbtp = Nbtp::RESET
            .with_nbrp(codes.prescaler as u16)
            .with_ntseg1(codes.segment1 as u8)
            .with_ntseg2(codes.segment2 as u8)
            .with_nsjw(codes.jump_width as u8);
        let (mut dbtp, mut tdcr) = (Dbtp::RESET, Tdcr::RESET);
        if let (Some(data), Some(limits)) = (&timing.data, &LIMITS.data) {
            let codes = Codes::of(limits, &data.segments);
            dbtp = dbtp
                .with_dbrp(codes.prescaler as u8)
                .with_dtseg1(codes.segment1 as u8)
                .with_dtseg2(codes.segment2 as u8)
                .with_dsjw(codes.jump_width as u8)
                .with_tdc(data.compensation.is_some());
            if let (Some(compensation), Some(limits)) = (data.compensation, &LIMITS.delay) {
                tdcr = tdcr.with_tdco(limits.offset.encode(compensation.offset) as u8).with_tdcf(match limits.filter {
                    Some(range) => range.encode(compensation.filter) as u8,
                    None => 0,
                });
            }
        }
        Ok(Self { nbtp, dbtp, tdcr })
    }
}

/// Bit timing of the dsPIC33 CAN FD module. All registers take writes only in Configuration mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33CanFdTiming {
    /// Nominal bit timing, low half (Register 3-3).
    pub nbtcfgl: canfd_registers::NbtcfgL,
    /// Nominal bit timing, high half (Register 3-4).
    pub nbtcfgh: canfd_registers::NbtcfgH,
    /// Data bit timing, low half (Register 3-5). The reset value without a data phase.
    pub dbtcfgl: canfd_registers::DbtcfgL,
    /// Data bit timing, high half (Register 3-6). The reset value without a data phase.
    pub dbtcfgh: canfd_registers::DbtcfgH,
    /// Transmitter delay compensation, low half (Register 3-7).
    pub tdcl: canfd_registers::TdcL,
    /// Transmitter delay compensation, high half (Register 3-8): off or automatic. Its other fields have their reset value.
    pub tdch: canfd_registers::TdcH,
}

ways!(DsPic33CanFdTiming, DSPIC33_CANFD);

impl DsPic33CanFdTiming {
    /// The register values of a timing.
    ///
    /// # Errors
    ///
    /// The limit that the timing does not keep.
    pub const fn of(timing: &BitTiming) -> Result<Self, SegmentFault> {
        use canfd_registers::{DbtcfgH, DbtcfgL, NbtcfgH, NbtcfgL, TdcH, TdcL};
        const LIMITS: Limits = Limits::DSPIC33_CANFD;
        if let Err(fault) = LIMITS.check(timing) {
            return Err(fault);
        }
        let codes = Codes::of(&LIMITS.nominal, &timing.nominal);
        let nbtcfgl = NbtcfgL::RESET.with_tseg2(codes.segment2 as u8).with_sjw(codes.jump_width as u8);
        let nbtcfgh = NbtcfgH::RESET.with_brp(codes.prescaler as u8).with_tseg1(codes.segment1 as u8);
        let (mut dbtcfgl, mut dbtcfgh) = (DbtcfgL::RESET, DbtcfgH::RESET);
        let (mut tdcl, mut tdch) = (TdcL::RESET, TdcH::RESET.with_tdcmod(canfd::TdcHTdcmod::Disabled));
        if let (Some(data), Some(limits)) = (&timing.data, &LIMITS.data) {
            let codes = Codes::of(limits, &data.segments);
            dbtcfgl = dbtcfgl.with_tseg2(codes.segment2 as u8).with_sjw(codes.jump_width as u8);
            dbtcfgh = dbtcfgh.with_brp(codes.prescaler as u8).with_tseg1(codes.segment1 as u8);
            if let (Some(DelayCompensation { offset, .. }), Some(limits)) = (data.compensation, &LIMITS.delay) {
                // 5.3.8: the module measures TDCV.
                tdcl = tdcl.with_tdco(limits.offset.encode(offset) as i8).with_tdcv(0);
                tdch = tdch.with_tdcmod(canfd::TdcHTdcmod::Automatic(2));
            }
        }
        Ok(Self { nbtcfgl, nbtcfgh, dbtcfgl, dbtcfgh, tdcl, tdch })
    }
}

const fn propagation(range: Option<FieldRange>, code: u32) -> u8 {
    if range.is_some() { code as u8 } else { 0 }
}

/// Bit timing of the ECAN module. Both registers take writes only in Configuration mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DsPic33EcanTiming {
    /// Prescaler and jump width (Register 4-1).
    pub cfg1: ecan_registers::Cfg1,
    /// Segments (Register 4-2), phase segment 2 freely programmed. `WAKFIL` is 0.
    pub cfg2: ecan_registers::Cfg2,
}

ways!(DsPic33EcanTiming, DSPIC33_ECAN);

impl DsPic33EcanTiming {
    /// The register values of a timing.
    ///
    /// # Errors
    ///
    /// The limit that the timing does not keep.
    pub const fn of(timing: &BitTiming) -> Result<Self, SegmentFault> {
        const LIMITS: Limits = Limits::DSPIC33_ECAN;
        if let Err(fault) = LIMITS.check(timing) {
            return Err(fault);
        }
        let codes = Codes::of(&LIMITS.nominal, &timing.nominal);
        let samples = if timing.three_samples { ecan::Cfg2Sam::ThreeTimes } else { ecan::Cfg2Sam::Once };
        Ok(Self {
            cfg1: ecan_registers::Cfg1::RESET.with_brp(codes.prescaler as u8).with_sjw(codes.jump_width as u8),
            cfg2: ecan_registers::Cfg2::RESET
                .with_wakfil(false)
                .with_prseg(propagation(LIMITS.nominal.propagation, codes.propagation))
                .with_seg1ph(codes.segment1 as u8)
                .with_seg2ph(codes.segment2 as u8)
                .with_seg2phts(ecan::Cfg2Seg2phts::Programmable)
                .with_sam(samples),
        })
    }
}

/// Bit timing of the PIC32 CAN module. The register takes writes only in Configuration mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pic32CanTiming {
    /// The whole of it (Register 34-2), phase segment 2 freely programmed. `WAKFIL` is 0.
    pub cfg: pic32_registers::Cfg,
}

ways!(Pic32CanTiming, PIC32_CAN);

impl Pic32CanTiming {
    /// The register value of a timing.
    ///
    /// # Errors
    ///
    /// The limit that the timing does not keep.
    pub const fn of(timing: &BitTiming) -> Result<Self, SegmentFault> {
        const LIMITS: Limits = Limits::PIC32_CAN;
        if let Err(fault) = LIMITS.check(timing) {
            return Err(fault);
        }
        let codes = Codes::of(&LIMITS.nominal, &timing.nominal);
        let samples = if timing.three_samples { pic32::CfgSam::ThreeTimes } else { pic32::CfgSam::Once };
        Ok(Self {
            cfg: pic32_registers::Cfg::RESET
                .with_brp(codes.prescaler as u8)
                .with_sjw(codes.jump_width as u8)
                .with_prseg(propagation(LIMITS.nominal.propagation, codes.propagation))
                .with_seg1ph(codes.segment1 as u8)
                .with_seg2ph(codes.segment2 as u8)
                .with_seg2phts(pic32::CfgSeg2phts::Programmable)
                .with_sam(samples),
        })
    }
}
