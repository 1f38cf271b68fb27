//! What is asked of the solver.

/// A sample point, in hundredths of a percent of the bit time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SamplePoint(u16);

impl SamplePoint {
    /// The end of the bit.
    const WHOLE: u32 = 10_000;

    /// From hundredths of a percent; more than 100 % is taken as 100 %.
    #[must_use]
    pub const fn hundredths(value: u16) -> Self {
        Self(if value as u32 > Self::WHOLE { Self::WHOLE as u16 } else { value })
    }

    /// From tenths of a percent, the unit of Linux; more than 100 % is taken as 100 %.
    #[must_use]
    pub const fn permille(value: u16) -> Self {
        Self::hundredths(value.saturating_mul(10))
    }

    /// From percent; more than 100 % is taken as 100 %.
    #[must_use]
    pub const fn percent(value: u8) -> Self {
        Self::hundredths(value as u16 * 100)
    }

    /// The nearest to `before` of `quanta` time quanta; 0 if there are none.
    #[must_use]
    pub const fn of(before: u32, quanta: u32) -> Self {
        match (before as u64 * Self::WHOLE as u64 + quanta as u64 / 2).checked_div(quanta as u64) {
            Some(value) if value <= Self::WHOLE as u64 => Self(value as u16),
            Some(_) => Self(Self::WHOLE as u16),
            None => Self(0),
        }
    }

    /// In hundredths of a percent.
    #[must_use]
    pub const fn get(self) -> u16 {
        self.0
    }

    /// The sample point that CAN in Automation recommends for a bit rate: 87.5 % up to 500 kbit/s, 80 % up to 800 kbit/s,
    /// 75 % above.
    ///
    /// The values come from outside the manuals: CiA 301 recommends 87.5 %, and Linux (`can_calc_bittiming`, "CiA
    /// recommended sample points") uses this table for nominal and for data bit rates; the same holds here.
    #[must_use]
    pub const fn recommended(bit_rate: u32) -> Self {
        match bit_rate {
            0..=500_000 => Self::permille(875),
            500_001..=800_000 => Self::permille(800),
            _ => Self::permille(750),
        }
    }
}

impl core::fmt::Display for SamplePoint {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let (whole, rest) = (self.0 / 100, self.0 % 100);
        match (rest, rest % 10) {
            (0, _) => write!(f, "{whole} %"),
            (_, 0) => write!(f, "{whole}.{} %", rest / 10),
            _ => write!(f, "{whole}.{rest:02} %"),
        }
    }
}

/// How long the synchronization jump width is made. It is never longer than either phase segment (ISO 11898-1), and
/// shorter than phase segment 2 where the manual asks for that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum JumpWidth {
    /// As long as possible, which tolerates the worst clocks (dsPIC33 CAN FD 5.3.7).
    #[default]
    Largest,
    /// Half of phase segment 2, as Linux does since 6.3.
    HalfPhase2,
    /// This many time quanta.
    Quanta(u32),
}

/// How the time before the sample point is divided into propagation segment and phase segment 1.
///
/// Controllers without a field for the propagation segment do not see the difference, but the oscillator tolerance and the
/// jump width depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Propagation {
    /// As long as possible while phase segment 1 is as long as phase segment 2, which costs no tolerance.
    #[default]
    Longest,
    /// At least this many nanoseconds: twice the sum of the delays of transceiver and bus (dsPIC33 CAN FD Equation 5-9).
    AtLeast(u32),
    /// This many time quanta; phase segment 1 takes the rest.
    Quanta(u32),
}

impl Propagation {
    /// For a bus of this length in metres, with the transceiver's delay from TXD to RXD in nanoseconds (at most 255 by
    /// ISO 11898-2): dsPIC33 CAN FD Equation 5-9, with 5 ns per metre of bus.
    #[must_use]
    pub const fn of_bus(metres: u32, transceiver: u32) -> Self {
        Self::AtLeast(metres.saturating_mul(5).saturating_add(transceiver).saturating_mul(2))
    }
}

/// Whether the transmitter delay is compensated in the data phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Compensation {
    /// From 1 Mbit/s on (dsPIC33 CAN FD 5.3.7; the M_CAN manual names no rate), and whenever the sample point lies before
    /// the loop delay of the transceiver. Left out where it is not needed and the prescaler it asks for (1 or 2,
    /// ISO 11898-1) would cost accuracy.
    #[default]
    Automatic,
    /// Always; a prescaler that forbids it is an error.
    On,
    /// Never.
    Off,
}

/// How the prescalers of both phases are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Prescalers {
    /// Equal where this costs neither accuracy of the bit rates nor of the sample points, otherwise each on its own.
    #[default]
    PreferEqual,
    /// Equal, also at the cost of accuracy: no quantization error at the switch of the bit rate.
    Equal,
    /// Each on its own.
    Independent,
}

/// What is asked of one phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PhaseRequest {
    /// Bit rate in bit/s.
    pub bit_rate: u32,
    /// Sample point; [`SamplePoint::recommended`] if left out.
    pub sample_point: Option<SamplePoint>,
    /// Time quanta in a bit, if that is to be fixed.
    pub quanta: Option<u32>,
    /// Jump width.
    pub jump_width: JumpWidth,
}

impl PhaseRequest {
    /// A bit rate in bit/s, everything else by default.
    #[must_use]
    pub const fn new(bit_rate: u32) -> Self {
        Self { bit_rate, sample_point: None, quanta: None, jump_width: JumpWidth::Largest }
    }

    /// The sample point that is aimed at.
    #[must_use]
    pub const fn target(&self) -> SamplePoint {
        match self.sample_point {
            Some(point) => point,
            None => SamplePoint::recommended(self.bit_rate),
        }
    }
}

/// A bit timing that is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Request {
    /// The controller's clock in hertz, in front of its fixed divider: m_can_cclk, FCAN, FCY, FSYS.
    pub clock: u32,
    /// Arbitration phase.
    pub nominal: PhaseRequest,
    /// Data phase.
    pub data: Option<PhaseRequest>,
    /// Propagation segment of the arbitration phase.
    pub propagation: Propagation,
    /// Transmitter delay compensation.
    pub compensation: Compensation,
    /// Delay in nanoseconds from the controller's transmit pin through the transceiver to its receive pin.
    pub loop_delay: u32,
    /// Prescalers of both phases.
    pub prescalers: Prescalers,
    /// Sample every bit three times.
    pub three_samples: bool,
    /// Largest deviation of a bit rate in ppm; 0 for exact bit rates only.
    pub max_error_ppm: u32,
    /// Largest deviation of a sample point in hundredths of a percent of the bit time.
    pub max_sample_point_error: u16,
}

impl Request {
    /// The longest loop delay of a transceiver in nanoseconds (ISO 11898-2, as quoted in dsPIC33 CAN FD 5.3.2).
    pub const LONGEST_LOOP_DELAY: u32 = 255;

    /// A clock in hertz and a nominal bit rate in bit/s. Only exact bit rates, sample points within 5 % of the bit time,
    /// everything else by default.
    #[must_use]
    pub const fn new(clock: u32, bit_rate: u32) -> Self {
        Self {
            clock,
            nominal: PhaseRequest::new(bit_rate),
            data: None,
            propagation: Propagation::Longest,
            compensation: Compensation::Automatic,
            loop_delay: Self::LONGEST_LOOP_DELAY,
            prescalers: Prescalers::PreferEqual,
            three_samples: false,
            max_error_ppm: 0,
            max_sample_point_error: 500,
        }
    }

    /// With another nominal sample point than the recommended one.
    #[must_use]
    pub const fn sample_point(mut self, point: SamplePoint) -> Self {
        self.nominal.sample_point = Some(point);
        self
    }

    /// With a data phase of this bit rate in bit/s.
    #[must_use]
    pub const fn data(mut self, bit_rate: u32) -> Self {
        self.data = Some(match self.data {
            Some(data) => PhaseRequest { bit_rate, ..data },
            None => PhaseRequest::new(bit_rate),
        });
        self
    }

    /// With another sample point in the data phase than the recommended one. Does nothing without a data phase.
    #[must_use]
    pub const fn data_sample_point(mut self, point: SamplePoint) -> Self {
        if let Some(data) = self.data {
            self.data = Some(PhaseRequest { sample_point: Some(point), ..data });
        }
        self
    }

    /// With this jump width in both phases.
    #[must_use]
    pub const fn jump_width(mut self, policy: JumpWidth) -> Self {
        self.nominal.jump_width = policy;
        if let Some(data) = self.data {
            self.data = Some(PhaseRequest { jump_width: policy, ..data });
        }
        self
    }

    /// With this many time quanta in a nominal bit.
    #[must_use]
    pub const fn quanta(mut self, quanta: u32) -> Self {
        self.nominal.quanta = Some(quanta);
        self
    }

    /// With this propagation segment.
    #[must_use]
    pub const fn propagation(mut self, propagation: Propagation) -> Self {
        self.propagation = propagation;
        self
    }

    /// With or without transmitter delay compensation.
    #[must_use]
    pub const fn compensation(mut self, compensation: Compensation) -> Self {
        self.compensation = compensation;
        self
    }

    /// With a transceiver of this loop delay in nanoseconds.
    #[must_use]
    pub const fn loop_delay(mut self, nanoseconds: u32) -> Self {
        self.loop_delay = nanoseconds;
        self
    }

    /// With prescalers chosen so.
    #[must_use]
    pub const fn prescalers(mut self, prescalers: Prescalers) -> Self {
        self.prescalers = prescalers;
        self
    }

    /// With every bit sampled three times.
    #[must_use]
    pub const fn three_samples(mut self) -> Self {
        self.three_samples = true;
        self
    }

    /// With bit rates that deviate by so many ppm at most.
    #[must_use]
    pub const fn within_ppm(mut self, ppm: u32) -> Self {
        self.max_error_ppm = ppm;
        self
    }

    /// With any bit rate, however far off: the nearest there is.
    #[must_use]
    pub const fn nearest(self) -> Self {
        self.within_ppm(u32::MAX)
    }

    /// With sample points that deviate by so many hundredths of a percent of the bit time at most.
    #[must_use]
    pub const fn sample_point_within(mut self, hundredths: u16) -> Self {
        self.max_sample_point_error = hundredths;
        self
    }

    /// With any sample point, however far off: the nearest there is.
    #[must_use]
    pub const fn any_sample_point(self) -> Self {
        self.sample_point_within(u16::MAX)
    }
}
