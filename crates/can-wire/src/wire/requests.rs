//! What a controller asks of its node.

use core::fmt;

use can_frame::Frame;

use super::Wire;
use crate::{
    ErrorState, Event, EventKind, FdSupport, Field, Mode, NodeConfig, NodeId, Time, TimingError,
    node::{Node, Output},
    protocol::{Context, Options},
};

/// Why a request was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RequestError {
    /// The node's mode does not allow it to send.
    CannotSend {
        /// The mode it is in.
        mode: Mode,
    },
    /// The node is bus off.
    BusOff,
    /// The node is not bus off, so it cannot recover.
    NotBusOff {
        /// The state it is in.
        state: ErrorState,
    },
    /// An FD frame for a node that knows only classic frames.
    NoFd,
    /// The configuration can only be changed while the node is [`Mode::Off`].
    NotOff {
        /// The mode it is in.
        mode: Mode,
    },
    /// The new configuration describes no node.
    Timing(TimingError),
}

impl fmt::Display for RequestError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RequestError::CannotSend { mode } => {
                write!(f, "a node in mode {mode:?} sends no frames")
            }
            RequestError::BusOff => f.write_str("the node is bus off"),
            RequestError::NotBusOff { state } => {
                write!(f, "the node is {state}, there is nothing to recover from")
            }
            RequestError::NoFd => f.write_str("an FD frame for a node that knows only classic frames"),
            RequestError::NotOff { mode } => write!(f, "the node is in mode {mode:?}, not off"),
            RequestError::Timing(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for RequestError {}

impl From<TimingError> for RequestError {
    fn from(error: TimingError) -> RequestError {
        RequestError::Timing(error)
    }
}

/// What became of a frame that should not be sent any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Abort {
    /// It had not started and is dropped.
    Dropped(Frame),
    /// It is on the bus. It ends with [`EventKind::Transmitted`], [`EventKind::ArbitrationLost`] or
    /// [`EventKind::TransmissionFailed`] like any other; nothing is sent again unless it is requested again.
    OnTheBus(Frame),
    /// There was nothing to abort.
    Nothing,
}

impl Wire {
    fn context<'a>(now: u64, node: NodeId, events: &'a mut std::collections::VecDeque<Event>) -> Context<'a> {
        Context { now: Time::from_ps(now), node, events }
    }

    /// Requests that `frame` is sent at the next opportunity. Until its start of frame it may be replaced by another
    /// request, so that a controller can decide at the last moment; the replaced frame is returned. There is no
    /// retransmission: after [`EventKind::ArbitrationLost`] or [`EventKind::TransmissionFailed`] the caller requests
    /// the frame again, or another one, or none.
    ///
    /// # Errors
    /// If the mode, bus off or the format forbids it.
    ///
    /// # Panics
    /// If the node is not of this wire, as do all methods that take one.
    pub fn send(&mut self, node: NodeId, frame: Frame) -> Result<Option<Frame>, RequestError> {
        let state = &self.nodes[node.index()];
        let mode = state.protocol.mode;
        if !mode.can_transmit() {
            return Err(RequestError::CannotSend { mode });
        }
        if state.protocol.confinement.state == ErrorState::BusOff {
            return Err(RequestError::BusOff);
        }
        if frame.is_fd() && state.config.fd != FdSupport::Fd {
            return Err(RequestError::NoFd);
        }
        // A node in loop back does not wait for the frame on the bus.
        if self.fast.is_planned() && (!self.fast.has_started() || mode.is_loopback()) {
            self.settle();
        }
        if self.fast.is_planned() {
            // It waits until the bus is idle again; where it does not concern the frame on the bus, nothing changes.
            let state = &mut self.nodes[node.index()].protocol;
            let replaced = state.replace_request(frame);
            self.fast.note_request(self.now, node, frame);
            return Ok(replaced);
        }
        Ok(self.place_request(node, frame))
    }

    pub(super) fn place_request(&mut self, node: NodeId, frame: Frame) -> Option<Frame> {
        let state = &mut self.nodes[node.index()];
        state.take_arrivals(self.now);
        state.prepare_request(Time::from_ps(self.now));
        let replaced = state.protocol.replace_request(frame);
        self.after_step(node.index());
        replaced
    }

    /// Takes back a request.
    pub fn abort(&mut self, node: NodeId) -> Abort {
        self.settle();
        let protocol = &mut self.nodes[node.index()].protocol;
        if let Some(frame) = protocol.request.take() {
            self.events.push_back(Event { time: Time::from_ps(self.now), node, kind: EventKind::Aborted { frame } });
            self.after_step(node.index());
            return Abort::Dropped(frame);
        }
        if protocol.sending { Abort::OnTheBus(protocol.outgoing) } else { Abort::Nothing }
    }

    /// The frame that is requested and has not started.
    #[must_use]
    pub fn requested(&self, node: NodeId) -> Option<Frame> {
        self.nodes[node.index()].protocol.request
    }

    /// Changes the operating mode at once, whatever is on the bus. A node that was off integrates first: it waits for
    /// 11 recessive bits. A frame that the new mode forbids is aborted in the middle.
    pub fn set_mode(&mut self, node: NodeId, mode: Mode) {
        self.settle();
        let at = Time::from_ps(self.now);
        let state = &mut self.nodes[node.index()];
        state.take_arrivals(self.now);
        let was_off = state.protocol.mode == Mode::Off;
        state.prepare_request(at);
        state.protocol.set_mode(mode, &mut Self::context(self.now, node, &mut self.events));
        if was_off {
            state.restart(at);
        }
        state.wake_armed = mode == Mode::Off && state.config.wake_on_edge;
        self.follow_engine(node);
    }

    /// Changes the operating mode as soon as the bus is idle: after the frame, its error frame and the intermission. A
    /// node that is off or bus off changes at once.
    pub fn set_mode_at_idle(&mut self, node: NodeId, mode: Mode) {
        if matches!(self.nodes[node.index()].protocol.field, Field::Off | Field::BusOff) {
            return self.set_mode(node, mode);
        }
        self.settle();
        let at = Time::from_ps(self.now);
        let state = &mut self.nodes[node.index()];
        state.take_arrivals(self.now);
        state.prepare_request(at);
        state.protocol.set_mode_at_idle(mode, &mut Self::context(self.now, node, &mut self.events));
        self.after_step(node.index());
    }

    /// Starts the recovery from bus off: after the configured number of occurrences of 11 recessive bits the node is
    /// error active with both counters at zero.
    ///
    /// # Errors
    /// [`RequestError::NotBusOff`], or [`RequestError::CannotSend`] while the node is off.
    pub fn start_recovery(&mut self, node: NodeId) -> Result<(), RequestError> {
        self.settle();
        let at = Time::from_ps(self.now);
        let state = &mut self.nodes[node.index()];
        if state.protocol.confinement.state != ErrorState::BusOff {
            return Err(RequestError::NotBusOff { state: state.protocol.confinement.state });
        }
        if state.protocol.mode == Mode::Off {
            return Err(RequestError::CannotSend { mode: Mode::Off });
        }
        state.take_arrivals(self.now);
        state.protocol.start_recovery();
        state.restart(at);
        self.after_step(node.index());
        Ok(())
    }

    /// Asks for one more overload frame before the next frame on the bus. At most two in a row are sent; more requests
    /// are ignored.
    pub fn request_overload(&mut self, node: NodeId) {
        self.settle();
        let requests = &mut self.nodes[node.index()].protocol.overload_requests;
        *requests = (*requests + 1).min(2);
    }

    /// Sets the error counters, as the reset of a controller does, or a test. A value above 127 makes the node error
    /// passive; the largest is 255. Ends bus off.
    pub fn set_error_counters(&mut self, node: NodeId, tec: u16, rec: u16) {
        self.settle();
        let at = Time::from_ps(self.now);
        let state = &mut self.nodes[node.index()];
        let cx = &mut Self::context(self.now, node, &mut self.events);
        let restarts = state.protocol.set_error_counters(tec, rec, cx);
        if restarts {
            state.restart(at);
            self.follow_engine(node);
        }
    }

    /// Replaces the configuration of a node that is off.
    ///
    /// # Errors
    /// [`RequestError::NotOff`], or the [`TimingError`] of the configuration.
    pub fn configure(&mut self, node: NodeId, config: NodeConfig) -> Result<(), RequestError> {
        self.settle();
        config.check()?;
        let state = &mut self.nodes[node.index()];
        if state.protocol.mode != Mode::Off {
            return Err(RequestError::NotOff { mode: state.protocol.mode });
        }
        state.take_arrivals(self.now);
        state.protocol.options = Options::from(&config);
        state.clock = crate::bit_clock::BitClock::new(&config);
        state.wake_armed = config.wake_on_edge;
        state.config = config;
        self.after_step(node.index());
        Ok(())
    }

    /// The engine of a node has changed its mind outside a bit boundary.
    pub(super) fn follow_engine(&mut self, node: NodeId) {
        let output = Node::follow_engine(&mut self.nodes[node.index()], Time::from_ps(self.now));
        if output != Output::None {
            self.put_out(node.index(), output);
        }
        self.after_step(node.index());
    }
}
