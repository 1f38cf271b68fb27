//! What the caller asks of the engine.

use can_frame::Frame;

use super::{Context, ErrorState, EventKind, Field, Incoming, Mode, Protocol, Role, Time};

impl Protocol {
    /// Takes on a mode at once.
    pub(crate) fn set_mode(&mut self, mode: Mode, cx: &mut Context<'_>) {
        let before = self.mode;
        self.mode_at_idle = None;
        if mode == before {
            return;
        }
        if !mode.can_transmit() {
            if self.sending {
                cx.emit(EventKind::Aborted {
                    frame: self.outgoing,
                });
            }
            if let Some(frame) = self.request.take() {
                cx.emit(EventKind::Aborted { frame });
            }
        }
        self.mode = mode;
        let bus_off = self.confinement.state == ErrorState::BusOff;
        let rejoins = before == Mode::Off
            || before.is_loopback() != mode.is_loopback()
            || (self.sending && !mode.can_transmit());
        if mode == Mode::Off {
            self.integrate();
            self.overload_requests = 0;
            self.recovering = None;
            self.enter(Field::Off);
        } else if bus_off {
            self.enter(Field::BusOff);
        } else if rejoins {
            self.integrate();
        }
        self.drive = self.next_drive();
        cx.emit(EventKind::ModeChanged { mode });
    }

    /// Asks for a mode as soon as the bus is idle; at once if the node is off, or bus off.
    pub(crate) fn set_mode_at_idle(&mut self, mode: Mode, cx: &mut Context<'_>) {
        match self.field {
            Field::Off | Field::BusOff => self.set_mode(mode, cx),
            _ => self.mode_at_idle = Some(mode),
        }
    }

    /// Places a frame to be sent, in place of an earlier request that has not started.
    pub(crate) fn replace_request(&mut self, frame: Frame) -> Option<Frame> {
        self.request.replace(frame)
    }

    /// Sets the counters. Returns true if that ended bus off, so that the node has to integrate.
    pub(crate) fn set_error_counters(&mut self, tec: u16, rec: u16, cx: &mut Context<'_>) -> bool {
        self.confinement.reset(tec, rec, cx);
        let was_off = self.field == Field::BusOff;
        if was_off {
            self.recovering = None;
            self.integrate();
            self.drive = self.next_drive();
        }
        was_off
    }

    pub(crate) fn start_recovery(&mut self) {
        self.recovering = Some(0);
        self.count = 0;
    }

    /// The state after a frame that was stepped over, before the last bit of the intermission.
    pub(crate) fn finish_frame(
        &mut self,
        sent: bool,
        frame: &Incoming,
        sof: Time,
        res: Option<Time>,
    ) {
        self.role = if sent {
            Role::Transmitter
        } else {
            Role::Receiver
        };
        self.sending = false;
        self.frames_seen += 1;
        self.incoming = *frame;
        self.sof_time = sof;
        self.res_time = res.unwrap_or(self.res_time);
        self.enter(Field::Intermission);
        self.bit = 2;
        self.drive = true;
    }
}
