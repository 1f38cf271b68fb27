//! The protocol engine of one node: a state machine that is fed one sampled bit at a time and says what to drive next.
//!
//! It knows nothing of time quanta and delays; [`crate::node`] feeds it at the node's sample points. Everything a node
//! does follows from the bits it has seen: a transmitter decodes its own frame like any receiver and additionally
//! compares.

mod confinement;
mod frame_bits;
mod incoming;
mod interframe;
mod requests;
mod signalling;
mod transmit;

use std::collections::VecDeque;

use can_frame::Frame;

use crate::{
    BusError, ErrorKind, ErrorState, Event, EventKind, FdSupport, Field, Level, Mode, NodeConfig, NodeId, PartialFrame,
    Position, ProtocolException, Role, Time,
};

pub(crate) use confinement::Confinement;
pub(crate) use incoming::{Checks, Incoming, stuff_count_field};

/// Where and when the engine is fed, and where its events go.
pub(crate) struct Context<'a> {
    pub(crate) now: Time,
    pub(crate) node: NodeId,
    pub(crate) events: &'a mut VecDeque<Event>,
}

impl Context<'_> {
    pub(crate) fn emit(&mut self, kind: EventKind) {
        self.events.push_back(Event { time: self.now, node: self.node, kind });
    }
}

/// The part of [`NodeConfig`] that the engine needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Options {
    pub(crate) fd: FdSupport,
    pub(crate) iso_crc: bool,
    pub(crate) exception: ProtocolException,
    pub(crate) rec_after_passive: u8,
    pub(crate) recovery_sequences: u16,
}

impl From<&NodeConfig> for Options {
    fn from(config: &NodeConfig) -> Options {
        Options {
            fd: config.fd,
            iso_crc: config.iso_crc,
            exception: config.protocol_exception,
            rec_after_passive: config.rec_after_passive,
            recovery_sequences: config.recovery_sequences,
        }
    }
}

/// How the next recessive to dominant edge acts on the bit timing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sync {
    None,
    Resync,
    Hard,
}

/// The state machine. Bits are `true` for recessive.
#[derive(Clone, Debug)]
pub(crate) struct Protocol {
    pub(crate) options: Options,
    pub(crate) mode: Mode,
    /// A mode to take on as soon as the bus is idle.
    pub(crate) mode_at_idle: Option<Mode>,
    pub(crate) confinement: Confinement,
    /// Field and index of the bit that is sampled next.
    pub(crate) field: Field,
    pub(crate) bit: u16,
    /// The bit that is sampled next is a stuff bit.
    pub(crate) stuff_next: bool,
    /// What the node drives in the bit that is sampled next.
    pub(crate) drive: bool,
    pub(crate) role: Role,
    /// The node sends a frame and has neither lost it nor finished it.
    pub(crate) sending: bool,
    /// The bits from now on are at the data bit rate.
    pub(crate) data_phase: bool,
    pub(crate) request: Option<Frame>,
    pub(crate) overload_requests: u8,
    pub(crate) outgoing: Frame,
    /// Its data bytes, recessive beyond them.
    outgoing_data: [u8; 64],
    /// Frames this node has started to send, and starts of frame it has seen; faults count them.
    pub(crate) frames_sent: u64,
    pub(crate) frames_seen: u64,
    pub(crate) incoming: Incoming,
    checks: Checks,
    last: bool,
    run: u8,
    crc_expected: u32,
    crc_ok: bool,
    acknowledged: bool,
    pub(crate) sof_time: Time,
    pub(crate) res_time: Time,
    /// Recessive bits in a row while integrating or recovering; dominant ones after an error flag.
    count: u16,
    pub(crate) recovering: Option<u16>,
    flag: Flag,
}

/// The error or overload flag being sent.
#[derive(Clone, Copy, Debug, Default)]
struct Flag {
    /// Six dominant bits; a passive error flag otherwise.
    active: bool,
    /// An error-passive transmitter missed its acknowledgement and has seen no dominant bit since.
    unacknowledged: bool,
    /// Equal bits in a row in a passive flag, and their level.
    run: u8,
    level: bool,
}

impl Protocol {
    pub(crate) fn new(options: Options) -> Protocol {
        let nothing = Frame::remote(can_frame::StandardId::ZERO, can_frame::Dlc::ZERO);
        Protocol {
            options,
            mode: Mode::Off,
            mode_at_idle: None,
            confinement: Confinement::default(),
            field: Field::Off,
            bit: 0,
            stuff_next: false,
            drive: true,
            role: Role::Receiver,
            sending: false,
            data_phase: false,
            request: None,
            overload_requests: 0,
            outgoing: nothing,
            outgoing_data: [0xFF; 64],
            frames_sent: 0,
            frames_seen: 0,
            incoming: Incoming::new(),
            checks: Checks::new(false, true),
            last: true,
            run: 0,
            crc_expected: 0,
            crc_ok: true,
            acknowledged: false,
            sof_time: Time::ZERO,
            res_time: Time::ZERO,
            count: 0,
            recovering: None,
            flag: Flag::default(),
        }
    }

    /// Takes the bit sampled at `cx.now` and decides what to drive in the next one.
    ///
    /// `late` is a bit whose secondary sample point has failed since the last sample point, with the level it had.
    #[inline]
    pub(crate) fn sample(&mut self, bit: bool, late: Option<(Position, Level)>, cx: &mut Context<'_>) {
        match late {
            Some((position, level)) if self.sending && self.field.is_in_frame() => {
                let kind = if level.is_dominant() { ErrorKind::Bit0 } else { ErrorKind::Bit1 };
                self.raise(kind, position, cx);
            }
            _ => return self.sample_plain(bit, cx),
        }
        self.drive = self.next_drive();
    }

    /// [`Protocol::sample`] without a secondary sample point.
    #[inline]
    pub(crate) fn sample_plain(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.field == Field::Data && self.data_bit(bit) {
            return;
        }
        self.other_than_data(bit, cx);
    }

    #[inline(never)]
    fn other_than_data(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.field.is_in_frame() {
            self.frame_bit(bit, cx);
        } else {
            self.other_bit(bit, cx);
        }
        self.drive = self.next_drive();
    }

    pub(crate) fn position(&self) -> Position {
        Position { field: self.field, bit: self.bit, stuff: self.stuff_next }
    }

    /// The transmitter compares at secondary sample points and takes its own bits for granted until then. The CRC
    /// delimiter belongs to it: its ordinary sample point may still see the last bit of the CRC.
    pub(crate) fn relies_on_own_bits(&self) -> bool {
        self.sending && self.data_phase
    }

    /// What an edge does now. `before_sample` tells whether it falls before the sample point of the bit that is
    /// sampled next, or already into the phase segment 2 of the bit before.
    #[inline]
    pub(crate) fn sync(&self, before_sample: bool) -> Sync {
        match self.field {
            Field::Off => Sync::None,
            Field::BusOff | Field::Integration | Field::Idle | Field::Suspend => Sync::Hard,
            Field::Intermission if self.bit >= 1 => Sync::Hard,
            Field::Sof => {
                if before_sample {
                    Sync::None
                } else {
                    Sync::Hard
                }
            }
            Field::Res if !self.sending && self.incoming.fd && !self.stuff_next => Sync::Hard,
            // A transmitter of an FD frame with bit-rate switch leaves its timing alone until the CRC delimiter is
            // over: late echoes of its own bits arrive until then.
            Field::AckSlot if self.sending && self.incoming.brs && !before_sample => Sync::None,
            _ if self.sending && self.data_phase => Sync::None,
            _ => Sync::Resync,
        }
    }

    #[inline]
    pub(crate) fn is_sleeping(&self) -> bool {
        self.field <= Field::Idle && self.is_resting()
    }

    fn is_resting(&self) -> bool {
        match self.field {
            Field::Off => true,
            Field::Idle => (self.request.is_none() || !self.mode.can_transmit()) && self.mode_at_idle.is_none(),
            Field::BusOff => self.recovering.is_none(),
            _ => false,
        }
    }

    pub(crate) fn partial_frame(&self) -> PartialFrame {
        PartialFrame {
            frame: self.incoming.dlc_known.then(|| self.incoming.frame()),
            data_bytes: self.incoming.bytes,
            position: self.position(),
        }
    }

    #[inline]
    fn enter(&mut self, field: Field) {
        self.field = field;
        self.bit = 0;
        self.stuff_next = false;
    }
}
