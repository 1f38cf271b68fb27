//! What a node is: its clock, timing, place on the bus and protocol options.

use core::fmt;

use crate::{BitTiming, DelayCompensation, Time, TimingError};

/// A node of a [`crate::Wire`], numbered in the order of [`crate::Wire::add_node`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub(crate) u16);

impl NodeId {
    /// The number, counted from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for NodeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "node {}", self.0)
    }
}

/// How far a node knows the FD format (ISO 11898-1:2015, 10.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum FdSupport {
    /// Classic frames only. A recessive FDF bit is the reserved bit of earlier editions and accepted at either level;
    /// an FD frame then runs into an error.
    Classic,
    /// Classic frames only, but an FD frame is a protocol exception: the node waits in bus integration until it has
    /// passed.
    Tolerant,
    /// FD frames.
    #[default]
    Fd,
}

/// What a node does with an FD frame whose reserved bit `res` is recessive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum ProtocolException {
    /// The node goes back to bus integration; no error, no counter.
    #[default]
    Integrate,
    /// A form error.
    FormError,
}

/// The operating mode of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Mode {
    /// Takes no part: drives recessive, sees nothing. The initialization, configuration or disable mode of a
    /// controller.
    #[default]
    Off,
    /// Normal operation.
    Normal,
    /// Bus monitoring (ISO 11898-1:2015, 10.14): receives, drives nothing. The dominant bits it would send are looped
    /// back inside the node; its error counters stand still.
    ListenOnly,
    /// Restricted operation: receives and acknowledges, sends no frame and no error or overload flag. After an error it
    /// waits for bus idle. Its error counters stand still.
    Restricted,
    /// The node hears only itself, its output stays recessive, it needs no acknowledgement and receives its own frames.
    InternalLoopback,
    /// The node hears only itself, its output drives the bus, it needs no acknowledgement and receives its own frames.
    ExternalLoopback,
}

impl Mode {
    pub(crate) const fn is_loopback(self) -> bool {
        matches!(self, Mode::InternalLoopback | Mode::ExternalLoopback)
    }

    pub(crate) const fn counts_errors(self) -> bool {
        !matches!(self, Mode::ListenOnly | Mode::Restricted)
    }

    pub(crate) const fn can_transmit(self) -> bool {
        matches!(
            self,
            Mode::Normal | Mode::InternalLoopback | Mode::ExternalLoopback
        )
    }
}

/// Everything about a node that software or its place on the bus sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeConfig {
    /// Frequency of the node's clock, in hertz, as it should be.
    pub clock_hz: u32,
    /// How much faster the clock really is, in parts per million.
    pub clock_ppm: i32,
    /// Bit timing of the arbitration phase and of classic frames.
    pub nominal: BitTiming,
    /// Bit timing of the data phase of FD frames with bit-rate switch.
    pub data: BitTiming,
    /// Transmitter delay compensation, if enabled.
    pub delay_compensation: Option<DelayCompensation>,
    /// Delay from the controller's transmit output to the point where the bus is formed: half of the transceiver and
    /// the stub.
    pub tx_delay: Time,
    /// Delay from that point to the controller's receive input.
    pub rx_delay: Time,
    /// How far the node knows the FD format.
    pub fd: FdSupport,
    /// True for the FD format of ISO 11898-1:2015 with stuff count; false for the earlier non-ISO format.
    pub iso_crc: bool,
    /// What a recessive `res` bit is.
    pub protocol_exception: ProtocolException,
    /// During bus integration an edge counts only if the bus stays dominant for two time quanta.
    pub edge_filter: bool,
    /// Value that the receive error counter takes after a reception while it was above 127; the standard allows 119
    /// to 127.
    pub rec_after_passive: u8,
    /// Occurrences of 11 recessive bits that end bus off: 128 by the standard. Some controllers count one more.
    pub recovery_sequences: u16,
    /// Report the first dominant edge seen while the node is [`Mode::Off`], as a wake-up event.
    pub wake_on_edge: bool,
}

impl NodeConfig {
    /// A node with a 40 MHz clock at 1 Mbit/s and, in the data phase, 5 Mbit/s, both with the sample point at 80 or
    /// 75 %; FD in ISO format, no delays, no compensation.
    #[must_use]
    pub const fn new() -> NodeConfig {
        NodeConfig {
            clock_hz: 40_000_000,
            clock_ppm: 0,
            nominal: BitTiming {
                prescaler: 1,
                prop_seg: 15,
                phase_seg1: 16,
                phase_seg2: 8,
                sjw: 8,
            },
            data: BitTiming {
                prescaler: 1,
                prop_seg: 2,
                phase_seg1: 3,
                phase_seg2: 2,
                sjw: 2,
            },
            delay_compensation: None,
            tx_delay: Time::ZERO,
            rx_delay: Time::ZERO,
            fd: FdSupport::Fd,
            iso_crc: true,
            protocol_exception: ProtocolException::Integrate,
            edge_filter: false,
            rec_after_passive: 127,
            recovery_sequences: 128,
            wake_on_edge: false,
        }
    }

    /// The same node at another nominal bit rate, sample point at 80 %.
    ///
    /// # Errors
    /// [`TimingError::NoTiming`] if the clock cannot make the rate exactly.
    pub fn with_rate(mut self, rate: u32) -> Result<NodeConfig, TimingError> {
        self.nominal = BitTiming::for_rate(self.clock_hz, rate, 800)?;
        Ok(self)
    }

    /// The same node at another data bit rate, sample point at 75 %.
    ///
    /// # Errors
    /// [`TimingError::NoTiming`] if the clock cannot make the rate exactly.
    pub fn with_data_rate(mut self, rate: u32) -> Result<NodeConfig, TimingError> {
        self.data = BitTiming::for_rate(self.clock_hz, rate, 750)?;
        Ok(self)
    }

    /// The time of one nominal bit by the node's own clock, rounded up to a picosecond.
    #[must_use]
    pub fn nominal_bit(&self) -> Time {
        self.bit_time(&self.nominal)
    }

    /// The time of one data-phase bit by the node's own clock, rounded up to a picosecond.
    #[must_use]
    pub fn data_bit(&self) -> Time {
        self.bit_time(&self.data)
    }

    fn bit_time(&self, timing: &BitTiming) -> Time {
        let tick = crate::time::Tick::of_clock(self.clock_hz.max(1), self.clock_ppm)
            .times(timing.prescaler);
        Time::from_ps(
            crate::time::Fine::default()
                .plus(timing.quanta(), tick)
                .ceil(),
        )
    }

    /// Checks that the values describe a node.
    ///
    /// # Errors
    /// The first [`TimingError`] found.
    pub fn check(&self) -> Result<(), TimingError> {
        let clock_ok = (1_000..=1_000_000_000).contains(&self.clock_hz)
            && self.clock_ppm.unsigned_abs() < 100_000;
        if !clock_ok {
            return Err(TimingError::Clock {
                hz: self.clock_hz,
                ppm: self.clock_ppm,
            });
        }
        for timing in [&self.nominal, &self.data] {
            timing.check()?;
            let bit = self.bit_time(timing);
            if bit > Time::from_ms(2) {
                return Err(TimingError::TooSlow { bit });
            }
        }
        let range = |name, value: u64, min: u16, max: u16| {
            if (u64::from(min)..=u64::from(max)).contains(&value) {
                Ok(())
            } else {
                Err(TimingError::Segment {
                    name,
                    value: value.min(u64::from(u16::MAX)) as u16,
                    min,
                    max,
                })
            }
        };
        range(
            "rec_after_passive",
            u64::from(self.rec_after_passive),
            119,
            127,
        )?;
        range(
            "recovery_sequences",
            u64::from(self.recovery_sequences),
            1,
            1024,
        )?;
        range(
            "tx_delay in microseconds",
            self.tx_delay.as_ps() / 1_000_000,
            0,
            1_000,
        )?;
        range(
            "rx_delay in microseconds",
            self.rx_delay.as_ps() / 1_000_000,
            0,
            1_000,
        )
    }
}

impl Default for NodeConfig {
    fn default() -> NodeConfig {
        NodeConfig::new()
    }
}
