//! The state of a node on the bus.

/// Error state of a node (ISO 11898-1:2015, 12.1.4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ErrorState {
    /// Takes part, and destroys what it finds wrong with an active error flag.
    Active,
    /// Takes part with passive error flags.
    Passive,
    /// Does not take part.
    BusOff,
}

/// Error counters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counters {
    /// Transmit error counter (TEC).
    pub transmit: u16,
    /// Receive error counter (REC). At 128 a controller that counts to 127 only says 128.
    pub receive: u16,
}

/// What the last frame on the bus has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LastError {
    /// It was transferred without error.
    None,
    /// More than five equal bits in a row.
    Stuff,
    /// A fixed bit had the wrong value.
    Form,
    /// Nobody has acknowledged the frame.
    Ack,
    /// Sent recessive, saw dominant.
    Bit1,
    /// Sent dominant, saw recessive.
    Bit0,
    /// The checksum was wrong.
    Crc,
}

/// One look at the status registers.
///
/// Reading them destroys information on most controllers, so all of it is here, and the next snapshot has what has
/// happened since.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Status {
    /// Error state.
    pub error_state: ErrorState,
    /// A counter has reached the warning limit of 96.
    pub warning: bool,
    /// Error counters.
    pub counters: Counters,
    /// What the last frame has come to, or the arbitration phase of one with bit-rate switch. `None` if there was none
    /// since the last snapshot, or if the controller keeps no record.
    pub last_error: Option<LastError>,
    /// The same for the data phase of frames with bit-rate switch.
    pub last_data_error: Option<LastError>,
}

impl Status {
    /// True if the node is off the bus for its errors.
    #[must_use]
    pub const fn is_bus_off(&self) -> bool {
        matches!(self.error_state, ErrorState::BusOff)
    }
}
