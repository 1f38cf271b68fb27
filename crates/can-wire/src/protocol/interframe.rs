//! Between frames: intermission, suspend transmission, idle, integration, bus off (ISO 11898-1:2015, 10.4.6, 10.9).

use super::{Context, ErrorState, EventKind, Field, Protocol, Role};
use crate::OverloadCause;

/// Recessive bits in a row that mean nobody is sending a frame.
const IDLE_CONDITION: u16 = 11;
const INTERMISSION_BITS: u16 = 3;
const SUSPEND_BITS: u16 = 8;

impl Protocol {
    /// Every bit outside a frame.
    pub(super) fn other_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        match self.field {
            Field::Idle => {
                if !bit {
                    self.start_of_frame(Role::Receiver, cx);
                } else if !self.is_sleeping() {
                    self.become_idle(false, cx);
                }
            }
            Field::Intermission => self.intermission_bit(bit, cx),
            Field::Suspend => {
                if !bit {
                    return self.start_of_frame(Role::Receiver, cx);
                }
                self.bit += 1;
                if self.bit == SUSPEND_BITS {
                    self.become_idle(true, cx);
                }
            }
            Field::ErrorFlag | Field::OverloadFlag => self.flag_bit(bit, cx),
            Field::ErrorDelimiter | Field::OverloadDelimiter => self.delimiter_bit(bit, cx),
            Field::Integration => {
                self.count = if bit { self.count + 1 } else { 0 };
                if self.count == IDLE_CONDITION {
                    cx.emit(EventKind::Integrated);
                    self.become_idle(true, cx);
                }
            }
            Field::BusOff => self.bus_off_bit(bit, cx),
            _ => {}
        }
    }

    /// An edge during bus integration means that someone is sending, however it is sampled.
    pub(crate) fn edge_while_integrating(&mut self) {
        if self.field == Field::Integration {
            self.count = 0;
        }
    }

    pub(super) fn integrate(&mut self) {
        self.enter(Field::Integration);
        self.role = Role::Receiver;
        self.sending = false;
        self.data_phase = false;
        self.count = 0;
    }

    pub(super) fn enter_intermission(&mut self, cx: &mut Context<'_>) {
        self.enter(Field::Intermission);
        // A requested overload frame starts in the first bit of the expected intermission.
        if self.overload_requests > 0 && self.mode.can_transmit() {
            self.overload_requests -= 1;
            self.overload(OverloadCause::Requested, cx);
        }
    }

    fn intermission_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        let index = self.bit;
        self.bit += 1;
        if index + 1 < INTERMISSION_BITS {
            if !bit {
                self.overload(OverloadCause::Intermission, cx);
            }
            return;
        }
        let suspended = self.role == Role::Transmitter && self.confinement.state == ErrorState::Passive;
        if bit {
            if suspended {
                self.enter(Field::Suspend);
            } else {
                self.become_idle(true, cx);
            }
            return;
        }
        // A dominant third bit is another node's start of frame. A node that was about to send joins it with its
        // identifier; one that has to suspend transmission receives.
        if !suspended && self.can_start() && self.mode_at_idle.is_none() {
            self.load_request();
            self.start_of_frame(Role::Transmitter, cx);
        } else {
            self.start_of_frame(Role::Receiver, cx);
        }
    }

    fn can_start(&self) -> bool {
        self.request.is_some() && self.mode.can_transmit()
    }

    fn load_request(&mut self) {
        if let Some(frame) = self.request.take() {
            // The error state at the start of the transmission goes out with the frame.
            let esi = frame.error_state_indicator() || self.confinement.state == ErrorState::Passive;
            self.outgoing = frame.with_error_state_indicator(esi);
            self.outgoing_data = [0xFF; 64];
            self.outgoing_data[..frame.len()].copy_from_slice(frame.data_bytes());
            self.sending = true;
            self.frames_sent += 1;
        }
    }

    /// The bus is idle at this sample point: change the mode, start a frame, or rest.
    fn become_idle(&mut self, entered: bool, cx: &mut Context<'_>) {
        self.role = Role::Receiver;
        self.enter(Field::Idle);
        if let Some(mode) = self.mode_at_idle.take() {
            self.set_mode(mode, cx);
            if self.field != Field::Idle {
                return;
            }
        }
        if self.can_start() {
            self.load_request();
            self.role = Role::Transmitter;
            self.enter(Field::Sof);
        } else if entered {
            cx.emit(EventKind::BusIdle);
        }
    }

    /// Bus off ends after the set number of occurrences of 11 recessive bits, once it was asked to (rule l).
    fn bus_off_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        let Some(done) = self.recovering else { return };
        self.count = if bit { self.count + 1 } else { 0 };
        if self.count < IDLE_CONDITION {
            return;
        }
        self.count = 0;
        let done = done + 1;
        self.recovering = Some(done);
        cx.emit(EventKind::RecoverySequence { count: done });
        if done >= self.options.recovery_sequences {
            self.recovering = None;
            self.confinement.reset(0, 0, cx);
            self.become_idle(true, cx);
        }
    }
}
