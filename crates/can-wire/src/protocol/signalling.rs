//! Error and overload signalling: flags, superposition, delimiters (ISO 11898-1:2015, 10.4.4, 10.4.5, 10.11).

use super::{
    BusError, Context, ErrorKind, ErrorState, EventKind, Field, Flag, Mode, Position, Protocol,
    Role,
};
use crate::OverloadCause;

/// Bits of an error or overload flag.
const FLAG_BITS: u16 = 6;
/// Bits of an error or overload delimiter.
const DELIMITER_BITS: u16 = 8;
/// Dominant bits in a row after a flag that count as one more error.
const DOMINANT_SEQUENCE: u16 = 8;

impl Protocol {
    /// An error was detected: count it and send an error flag from the next bit on.
    pub(super) fn raise(&mut self, kind: ErrorKind, position: Position, cx: &mut Context<'_>) {
        let error = BusError {
            kind,
            position,
            role: self.role,
            data_phase: self.data_phase,
            data_bytes: self.incoming.bytes,
        };
        let failed = core::mem::take(&mut self.sending);
        self.data_phase = false;
        cx.emit(EventKind::Error(error));
        if failed {
            cx.emit(EventKind::TransmissionFailed(error));
        }
        if self.mode == Mode::Restricted {
            return self.integrate();
        }
        // The state before counting decides about the flag: the error that makes a node passive is still signalled
        // with an active flag.
        let active = self.confinement.state == ErrorState::Active;
        let unacknowledged = kind == ErrorKind::Ack && !active;
        if self.mode.counts_errors() {
            let sending_flag = match position.field {
                Field::ErrorFlag | Field::OverloadFlag => kind == ErrorKind::Bit0,
                _ => false,
            };
            match self.role {
                // Exception 1 waits for a dominant bit in the passive flag. Exception 2: a stuff bit of the arbitration
                // field was sent recessive and seen dominant.
                Role::Transmitter if unacknowledged || kind == ErrorKind::Stuff => {}
                Role::Transmitter => self.confinement.transmit_error(cx),
                Role::Receiver => self
                    .confinement
                    .receive_error(if sending_flag { 8 } else { 1 }, cx),
            }
        }
        if self.went_bus_off(cx) {
            return;
        }
        self.enter(Field::ErrorFlag);
        self.flag = Flag {
            active,
            unacknowledged,
            run: 0,
            level: true,
        };
    }

    pub(super) fn overload(&mut self, cause: OverloadCause, cx: &mut Context<'_>) {
        if self.mode == Mode::Restricted {
            return self.integrate();
        }
        cx.emit(EventKind::Overload(cause));
        self.enter(Field::OverloadFlag);
    }

    pub(super) fn flag_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.field == Field::ErrorFlag && !self.flag.active {
            return self.passive_flag_bit(bit, cx);
        }
        if bit {
            return self.raise(ErrorKind::Bit0, self.position(), cx);
        }
        self.bit += 1;
        if self.bit == FLAG_BITS {
            self.enter_delimiter();
        }
    }

    /// A passive flag is complete after six equal bits, whoever sends them.
    fn passive_flag_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        if !bit && core::mem::take(&mut self.flag.unacknowledged) && self.mode.counts_errors() {
            self.confinement.transmit_error(cx);
            if self.went_bus_off(cx) {
                return;
            }
        }
        self.flag.run = if bit == self.flag.level {
            self.flag.run + 1
        } else {
            1
        };
        self.flag.level = bit;
        self.bit += 1;
        if u16::from(self.flag.run) == FLAG_BITS {
            self.enter_delimiter();
        }
    }

    fn enter_delimiter(&mut self) {
        let after_error = self.field == Field::ErrorFlag;
        self.enter(if after_error {
            Field::ErrorDelimiter
        } else {
            Field::OverloadDelimiter
        });
        self.count = 0;
    }

    pub(super) fn delimiter_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.bit == 0 {
            if bit {
                self.bit = 1;
            } else {
                self.dominant_after_flag(cx);
            }
            return;
        }
        if !bit {
            if self.bit == DELIMITER_BITS - 1 {
                return self.overload(OverloadCause::LastBitOfDelimiter, cx);
            }
            return self.raise(ErrorKind::Form, self.position(), cx);
        }
        self.bit += 1;
        if self.bit == DELIMITER_BITS {
            self.enter_intermission(cx);
        }
    }

    /// The flags of other nodes prolong ours; too long a row of dominant bits counts as errors (rules b and f).
    fn dominant_after_flag(&mut self, cx: &mut Context<'_>) {
        self.count += 1;
        if !self.mode.counts_errors() {
            return;
        }
        if self.count == 1 && self.role == Role::Receiver && self.field == Field::ErrorDelimiter {
            self.confinement.receive_error(8, cx);
        }
        if self.count.is_multiple_of(DOMINANT_SEQUENCE) {
            match self.role {
                Role::Transmitter => self.confinement.transmit_error(cx),
                Role::Receiver => self.confinement.receive_error(8, cx),
            }
            self.went_bus_off(cx);
        }
    }

    fn went_bus_off(&mut self, cx: &mut Context<'_>) -> bool {
        let off = self.confinement.state == ErrorState::BusOff;
        if off {
            self.enter(Field::BusOff);
            self.role = Role::Receiver;
            self.recovering = None;
            if let Some(frame) = self.request.take() {
                cx.emit(EventKind::Aborted { frame });
            }
        }
        off
    }
}
