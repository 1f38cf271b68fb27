//! What can go wrong while a controller runs, with the facts.

use core::fmt;

use embedded_can::ErrorKind;

use crate::TimedOut;

/// A change of mode has failed. The controller is given back in the mode it was in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused<C, E = TimedOut> {
    /// The controller.
    pub can: C,
    /// Why.
    pub error: E,
}

impl<C, E: fmt::Display> fmt::Display for Refused<C, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.fmt(f)
    }
}

impl<C: fmt::Debug, E: fmt::Debug + fmt::Display> core::error::Error for Refused<C, E> {}

/// Why a frame was not taken for sending.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SendError {
    /// There is no room now.
    Full,
    /// The buffer's last request is still pending.
    Pending {
        /// The buffer.
        buffer: u8,
    },
    /// There is no such buffer.
    NoSuchBuffer {
        /// The buffer asked for.
        buffer: u8,
        /// How many there are.
        count: u8,
    },
    /// The frame has more data bytes than an element of message memory holds.
    TooLong {
        /// Data bytes of the frame.
        len: u8,
        /// Data bytes there is room for.
        room: u8,
    },
    /// An FD frame, but the controller is configured for classic frames only, or knows no others.
    FdDisabled,
    /// An FD frame with bit-rate switch, but the controller is configured without.
    BitRateSwitchDisabled,
    /// A message marker of more bits than the controller is configured for.
    MarkerTooWide {
        /// The marker.
        marker: u16,
    },
}

impl fmt::Display for SendError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full => f.write_str("there is no room for another frame"),
            Self::Pending { buffer } => write!(f, "the request of buffer {buffer} is still pending"),
            Self::NoSuchBuffer { buffer, count } => write!(f, "there are {count} buffers, but no buffer {buffer}"),
            Self::TooLong { len, room } => write!(f, "{len} data bytes, but the element holds {room}"),
            Self::FdDisabled => f.write_str("an FD frame, but FD operation is not enabled"),
            Self::BitRateSwitchDisabled => f.write_str("a frame with bit-rate switch, but switching is not enabled"),
            Self::MarkerTooWide { marker } => write!(f, "message marker {marker:#x} needs wide message markers"),
        }
    }
}

impl core::error::Error for SendError {}

/// Received messages were lost because a FIFO was full. Told once; what was received before can still be fetched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Overflow {
    /// The FIFO.
    pub fifo: u8,
}

impl fmt::Display for Overflow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "FIFO {} was full and has lost messages", self.fifo)
    }
}

impl core::error::Error for Overflow {}

/// The error of the `embedded_can` traits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// Messages were lost.
    Overflow(Overflow),
    /// A frame was not taken for sending.
    Send(SendError),
    /// A blocking call has come to its bound.
    TimedOut,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow(overflow) => overflow.fmt(f),
            Self::Send(error) => error.fmt(f),
            Self::TimedOut => TimedOut.fmt(f),
        }
    }
}

impl core::error::Error for Error {}

impl embedded_can::Error for Error {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Overflow(_) => ErrorKind::Overrun,
            Self::Send(_) | Self::TimedOut => ErrorKind::Other,
        }
    }
}
