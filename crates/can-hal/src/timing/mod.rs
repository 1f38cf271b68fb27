//! Bit timing: from clock, bit rate and sample point to the segments of a bit, and to register values.

/// The parts of a bit, as numbers of time quanta, not as register values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segments {
    /// Clock periods in a time quantum, a fixed divider in front of the prescaler not counted.
    pub prescaler: u32,
    /// Propagation segment. Controllers without a field of its own take it together with phase segment 1.
    pub propagation: u32,
    /// Phase segment 1.
    pub phase1: u32,
    /// Phase segment 2.
    pub phase2: u32,
    /// Synchronization jump width.
    pub jump_width: u32,
}

/// Transmitter delay compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DelayCompensation {
    /// From the measured delay to the secondary sample point, in clock periods.
    pub offset: u32,
    /// Smallest position of the secondary sample point, in clock periods; 0 for none.
    pub filter: u32,
}

/// The data phase of CAN FD frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DataPhase {
    /// The parts of a bit.
    pub segments: Segments,
    /// Transmitter delay compensation, where it is needed.
    pub compensation: Option<DelayCompensation>,
}

/// The bit timing of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BitTiming {
    /// Arbitration phase, and all of a classic frame.
    pub nominal: Segments,
    /// Data phase of frames with bit-rate switch.
    pub data: Option<DataPhase>,
}
