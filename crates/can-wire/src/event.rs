//! What happens on the bus, as a controller sees it.

use core::fmt;

use can_frame::Frame;

use crate::{Level, Mode, NodeId, Position, Time};

/// Something that happened at a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// When: a sample point of that node unless the kind says otherwise.
    pub time: Time,
    /// Where.
    pub node: NodeId,
    /// What.
    pub kind: EventKind,
}

/// The part a node plays in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// It sends the frame. A node stays transmitter until the bus is idle or it loses arbitration.
    Transmitter,
    /// It does not.
    Receiver,
}

/// Fault confinement (ISO 11898-1:2015, 10.11). The order is that of severity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum ErrorState {
    /// Both counters are below 128: errors are signalled with a dominant flag.
    #[default]
    Active,
    /// A counter is above 127: errors are signalled with a recessive flag, transmissions wait 8 bits longer.
    Passive,
    /// The transmit error counter has exceeded 255: the node is silent until it is told to recover.
    BusOff,
}

/// The kinds of errors (ISO 11898-1:2015, 10.10), bit errors told apart by what was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ErrorKind {
    /// Sent dominant, seen recessive.
    Bit0,
    /// Sent recessive, seen dominant.
    Bit1,
    /// Six equal bits in a stuffed part of a frame.
    Stuff,
    /// A bit of fixed form at the wrong level; also a wrong fixed stuff bit of an FD frame.
    Form,
    /// No dominant bit in the ACK slot.
    Ack,
    /// The CRC sequence or the stuff count does not match what was received.
    Crc,
}

/// An error as one node detected it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BusError {
    /// The kind.
    pub kind: ErrorKind,
    /// The bit. With transmitter delay compensation this is the bit whose secondary sample point failed, the event
    /// comes at the next sample point.
    pub position: Position,
    /// The part the node played.
    pub role: Role,
    /// True between the sample points of a recessive BRS and of the CRC delimiter.
    pub data_phase: bool,
    /// Identifier, length and data known at this point are available from [`crate::Wire::partial_frame`]; this is the
    /// number of complete data bytes in it.
    pub data_bytes: u8,
}

/// Why an overload flag was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OverloadCause {
    /// The caller asked for a delay.
    Requested,
    /// A dominant bit in the first two bits of intermission.
    Intermission,
    /// A receiver saw a dominant bit in the last bit of EOF.
    LastBitOfEof,
    /// A dominant bit in the last bit of an error or overload delimiter.
    LastBitOfDelimiter,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
    /// The sample point of a start of frame. For a transmitter that joined another node's start of frame this is that
    /// one.
    StartOfFrame {
        /// Transmitter if the node's own frame starts here.
        role: Role,
    },
    /// A frame was received and is valid for receivers: the last but one bit of EOF. In loop back the node's own frame,
    /// valid as for a transmitter.
    Received {
        /// The frame.
        frame: Frame,
        /// Sample point of its start of frame.
        sof: Time,
        /// Sample point of the bit after FDF, for FD frames.
        res: Option<Time>,
    },
    /// The node's frame was sent and acknowledged and is valid for the transmitter: the last bit of EOF.
    Transmitted {
        /// The frame as it was on the bus, with the error state indicator that was sent.
        frame: Frame,
        /// Sample point of its start of frame.
        sof: Time,
        /// Sample point of the bit after FDF, for FD frames.
        res: Option<Time>,
    },
    /// Another node's frame has priority; this node goes on as a receiver. Its frame is no longer requested.
    ArbitrationLost {
        /// The bit that was sent recessive and seen dominant.
        position: Position,
    },
    /// An error was detected.
    Error(BusError),
    /// The frame that the node was sending is lost through this error. Its frame is no longer requested.
    TransmissionFailed(BusError),
    /// The error counters have changed.
    Counters {
        /// Transmit error counter, 0 to 255; it stays at its last value in bus off.
        tec: u16,
        /// Receive error counter, 0 to 255.
        rec: u16,
    },
    /// The error state has changed.
    ErrorState {
        /// The state before.
        from: ErrorState,
        /// The state from now on.
        to: ErrorState,
    },
    /// One more occurrence of 11 recessive bits during the recovery from bus off.
    RecoverySequence {
        /// How many there have been.
        count: u16,
    },
    /// The node has seen 11 recessive bits and takes part in the traffic.
    Integrated,
    /// The bus is idle: intermission, or suspend transmission, is over and the node starts no frame of its own.
    BusIdle,
    /// An overload flag follows.
    Overload(OverloadCause),
    /// An FD frame that the node does not understand; it waits for the bus to become idle.
    ProtocolException,
    /// The transmitter delay of this frame, in clock periods, at the end of its measurement; the second value is the
    /// secondary sample point.
    TransmitterDelay {
        /// Clock periods from output to input.
        delay: u16,
        /// Clock periods from the start of a bit to its secondary sample point.
        secondary_sample_point: u16,
    },
    /// The operating mode has changed.
    ModeChanged {
        /// The mode from now on.
        mode: Mode,
    },
    /// A frame that was requested, or being sent, was dropped: aborted, or the mode or error state no longer allows it.
    Aborted {
        /// The frame.
        frame: Frame,
    },
    /// The bus became dominant while the node was off; see [`crate::NodeConfig::wake_on_edge`]. The time is that of the
    /// edge at the node's input.
    WakeUp,
}

/// What a node knows of the frame on the bus before it is complete.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartialFrame {
    /// Identifier, format, length code and as many data bytes as have arrived, the rest zero; `None` while the length
    /// code is not complete.
    pub frame: Option<Frame>,
    /// Complete data bytes.
    pub data_bytes: u8,
    /// The bit that comes next.
    pub position: Position,
}

/// One bit as one node lived it, for a [`crate::TraceSink`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitRecord {
    /// The node.
    pub node: NodeId,
    /// Start of the bit by the node's clock.
    pub start: Time,
    /// Its sample point.
    pub sample: Time,
    /// Which bit it was.
    pub position: Position,
    /// The part the node played before this bit was sampled.
    pub role: Role,
    /// What the node wanted to send.
    pub driven: Level,
    /// What the node saw.
    pub seen: Level,
    /// True if an injected fault inverted what it saw or what left it.
    pub faulty: bool,
}

impl fmt::Display for ErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ErrorKind::Bit0 => "bit error (sent dominant, saw recessive)",
            ErrorKind::Bit1 => "bit error (sent recessive, saw dominant)",
            ErrorKind::Stuff => "stuff error",
            ErrorKind::Form => "form error",
            ErrorKind::Ack => "acknowledgement error",
            ErrorKind::Crc => "CRC error",
        })
    }
}

impl fmt::Display for ErrorState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ErrorState::Active => "error active",
            ErrorState::Passive => "error passive",
            ErrorState::BusOff => "bus off",
        })
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: ", self.time, self.node)?;
        match self.kind {
            EventKind::StartOfFrame {
                role: Role::Transmitter,
            } => f.write_str("starts a frame"),
            EventKind::StartOfFrame {
                role: Role::Receiver,
            } => f.write_str("sees a start of frame"),
            EventKind::Received { frame, .. } => write!(f, "received {frame}"),
            EventKind::Transmitted { frame, .. } => write!(f, "transmitted {frame}"),
            EventKind::ArbitrationLost { position } => write!(f, "lost arbitration at {position}"),
            EventKind::Error(error) => write!(f, "{} at {}", error.kind, error.position),
            EventKind::TransmissionFailed(error) => {
                write!(f, "transmission failed: {}", error.kind)
            }
            EventKind::Counters { tec, rec } => write!(f, "TEC {tec}, REC {rec}"),
            EventKind::ErrorState { from, to } => write!(f, "{from} -> {to}"),
            EventKind::RecoverySequence { count } => write!(f, "recovery sequence {count}"),
            EventKind::Integrated => f.write_str("integrated"),
            EventKind::BusIdle => f.write_str("bus idle"),
            EventKind::Overload(cause) => write!(f, "overload flag: {cause:?}"),
            EventKind::ProtocolException => f.write_str("protocol exception"),
            EventKind::TransmitterDelay {
                delay,
                secondary_sample_point,
            } => {
                write!(
                    f,
                    "transmitter delay {delay}, secondary sample point {secondary_sample_point} clock periods"
                )
            }
            EventKind::ModeChanged { mode } => write!(f, "mode {mode:?}"),
            EventKind::Aborted { frame } => write!(f, "aborted {frame}"),
            EventKind::WakeUp => f.write_str("woken by an edge"),
        }
    }
}
