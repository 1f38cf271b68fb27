//! Decoding a frame bit by bit: destuffing, fields, checks, from SOF to EOF (ISO 11898-1:2015, 10.4 to 10.6).

use super::{
    Checks, Context, ErrorKind, EventKind, FdSupport, Field, Position, Protocol, ProtocolException, Role,
    stuff_count_field, transmit::Monitored,
};

/// Equal bits in a row after which a stuff bit follows.
const STUFF_AFTER: u8 = 5;

impl Protocol {
    pub(super) fn frame_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.sending {
            match self.monitor(bit) {
                Monitored::Fine => {}
                Monitored::Error(kind) => return self.raise(kind, self.position(), cx),
                Monitored::ArbitrationLost => {
                    self.sending = false;
                    self.role = Role::Receiver;
                    cx.emit(EventKind::ArbitrationLost { position: self.position() });
                }
            }
        } else if bit && !self.drive {
            // The acknowledgement of a receiver did not reach the bus.
            return self.raise(ErrorKind::Bit0, self.position(), cx);
        }
        if self.stuff_next {
            return self.stuff_bit(bit, cx);
        }
        match self.field {
            Field::CrcDelimiter => self.crc_delimiter(bit, cx),
            Field::AckSlot => self.ack_slot(bit, cx),
            Field::AckDelimiter => self.ack_delimiter(bit, cx),
            Field::Eof => self.eof_bit(bit, cx),
            Field::StuffCount | Field::Crc => self.check_bit(bit),
            _ => self.stuffed_bit(bit, cx),
        }
    }

    /// [`Protocol::frame_bit`] for most bits of a frame: a bit of the data field, neither a stuff bit nor the last one,
    /// seen as it was sent. Returns false, with nothing done, if it is another.
    #[inline]
    pub(super) fn data_bit(&mut self, bit: bool) -> bool {
        let index = self.bit;
        let ends_byte = index % 8 == 7;
        let unexpected = bit != self.drive && (self.sending || bit);
        let last = ends_byte && self.incoming.bytes + 1 == self.incoming.len;
        if self.stuff_next || unexpected || last {
            return false;
        }
        self.count_run(bit);
        self.checks.push(bit);
        self.bit = index + 1;
        self.incoming.push_data(bit, index);
        self.stuff_next = self.run == STUFF_AFTER;
        self.drive = !self.sending || if self.stuff_next { !bit } else { self.data_bit_to_send() };
        true
    }

    /// The start of frame was sampled, by whichever node sent it.
    pub(super) fn start_of_frame(&mut self, role: Role, cx: &mut Context<'_>) {
        self.role = role;
        self.frames_seen += 1;
        self.sof_time = cx.now;
        self.incoming.restart();
        self.checks = Checks::new(self.options.fd == FdSupport::Fd, self.options.iso_crc);
        self.checks.push(false);
        self.crc_ok = true;
        self.acknowledged = false;
        self.last = false;
        self.run = 1;
        self.enter(Field::BaseId);
        cx.emit(EventKind::StartOfFrame { role });
    }

    fn stuff_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        let fixed = self.incoming.fd && matches!(self.field, Field::StuffCount | Field::Crc);
        if bit == self.last {
            let kind = if fixed { ErrorKind::Form } else { ErrorKind::Stuff };
            return self.raise(kind, self.position(), cx);
        }
        self.last = bit;
        self.run = 1;
        self.stuff_next = false;
        // A stuff bit after the CRC sequence of a classic frame changes nothing here: that register is closed.
        if !fixed && self.field < Field::StuffCount {
            self.checks.push_stuff(bit);
        }
    }

    /// SOF to the end of the data field: dynamic stuffing, covered by the CRC.
    fn stuffed_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        if self.field == Field::Sof {
            // Only the own start of frame comes here; that of others is seen in idle.
            return self.start_of_frame(Role::Transmitter, cx);
        }
        self.count_run(bit);
        self.checks.push(bit);
        let index = self.bit;
        self.bit += 1;
        match self.field {
            Field::BaseId => {
                self.incoming.base_id = self.incoming.base_id << 1 | u16::from(bit);
                self.advance_at(11, Field::Rtr);
            }
            Field::Rtr => {
                self.incoming.remote = bit;
                self.move_to(Field::Ide);
            }
            Field::Ide => {
                self.incoming.extended = bit;
                self.move_to(if bit { Field::ExtendedId } else { Field::Fdf });
            }
            Field::ExtendedId => {
                self.incoming.extension = self.incoming.extension << 1 | u32::from(bit);
                self.advance_at(18, Field::ExtendedRtr);
            }
            Field::ExtendedRtr => {
                self.incoming.remote = bit;
                self.move_to(Field::Fdf);
            }
            Field::Fdf => {
                if bit && self.options.fd == FdSupport::Tolerant {
                    return self.protocol_exception(cx);
                }
                let fd = bit && self.options.fd == FdSupport::Fd;
                self.incoming.fd = fd;
                self.incoming.rrs = fd && self.incoming.remote;
                self.incoming.remote &= !fd;
                self.checks.choose_format(fd);
                self.move_to(if fd || self.incoming.extended { Field::Res } else { Field::Dlc });
            }
            Field::Res => {
                self.res_time = cx.now;
                if bit && self.incoming.fd {
                    return match self.options.exception {
                        ProtocolException::Integrate => self.protocol_exception(cx),
                        ProtocolException::FormError => {
                            self.raise(ErrorKind::Form, Position::new(Field::Res, 0), cx);
                        }
                    };
                }
                self.move_to(if self.incoming.fd { Field::Brs } else { Field::Dlc });
            }
            Field::Brs => {
                self.incoming.brs = bit;
                self.data_phase = bit;
                self.move_to(Field::Esi);
            }
            Field::Esi => {
                self.incoming.esi = bit;
                self.move_to(Field::Dlc);
            }
            Field::Dlc => {
                self.incoming.dlc = self.incoming.dlc << 1 | u8::from(bit);
                if self.bit == 4 {
                    self.incoming.close_dlc();
                    self.checks.choose_length(self.incoming.len);
                    self.move_to(Field::Data);
                    if self.incoming.len == 0 {
                        self.end_of_data();
                    }
                }
            }
            // Field::Data; the other fields have their own functions.
            _ => {
                self.incoming.push_data(bit, index);
                if self.incoming.bytes == self.incoming.len {
                    self.end_of_data();
                }
            }
        }
        self.stuff_next |= self.run == STUFF_AFTER && self.field < Field::StuffCount;
        if self.field == Field::Crc && !self.incoming.fd {
            self.stuff_next = self.run == STUFF_AFTER;
        }
    }

    #[inline]
    fn count_run(&mut self, bit: bool) {
        self.run = if bit == self.last { self.run + 1 } else { 1 };
        self.last = bit;
    }

    fn move_to(&mut self, field: Field) {
        self.field = field;
        self.bit = 0;
    }

    fn advance_at(&mut self, len: u16, field: Field) {
        if self.bit == len {
            self.move_to(field);
        }
    }

    /// What follows the data field: the stuff count of an ISO FD frame, or the CRC. In FD frames a fixed stuff bit
    /// comes first, and replaces a dynamic one that might be due.
    fn end_of_data(&mut self) {
        if self.incoming.fd && self.options.iso_crc {
            self.move_to(Field::StuffCount);
        } else {
            self.crc_expected = self.checks.crc().value();
            self.move_to(Field::Crc);
        }
        self.stuff_next = self.incoming.fd;
    }

    /// A bit of the stuff count or of the CRC sequence. A mismatch is only reported after the ACK delimiter.
    fn check_bit(&mut self, bit: bool) {
        let index = u32::from(self.bit);
        self.bit += 1;
        if self.field == Field::StuffCount {
            self.crc_ok &= bit == (stuff_count_field(self.checks.stuff_bits) >> (3 - index) & 1 == 1);
            self.checks.push(bit);
            self.last = bit;
            if self.bit == 4 {
                self.crc_expected = self.checks.crc().value();
                self.move_to(Field::Crc);
                self.stuff_next = true;
            }
            return;
        }
        let width = self.checks.crc().width();
        self.crc_ok &= bit == (self.crc_expected >> (width - 1 - index) & 1 == 1);
        self.count_run(bit);
        let at_end = u32::from(self.bit) == width;
        if self.incoming.fd {
            // A fixed stuff bit before every fourth bit, counted from the stuff count if there is one.
            self.stuff_next = self.bit.is_multiple_of(4) && !at_end;
        } else {
            self.stuff_next = self.run == STUFF_AFTER;
        }
        if at_end {
            self.move_to(Field::CrcDelimiter);
        }
    }

    fn crc_delimiter(&mut self, bit: bool, cx: &mut Context<'_>) {
        if !bit {
            return self.raise(ErrorKind::Form, self.position(), cx);
        }
        // The nominal bit rate returns at this sample point.
        self.data_phase = false;
        self.enter(Field::AckSlot);
    }

    fn ack_slot(&mut self, bit: bool, cx: &mut Context<'_>) {
        self.acknowledged = !bit || self.mode.is_loopback();
        if self.sending {
            if !self.acknowledged && !self.incoming.fd {
                return self.raise(ErrorKind::Ack, self.position(), cx);
            }
        } else if !self.drive && self.mode.counts_errors() {
            self.confinement.received(self.options.rec_after_passive, cx);
        }
        self.enter(Field::AckDelimiter);
    }

    fn ack_delimiter(&mut self, bit: bool, cx: &mut Context<'_>) {
        if !bit {
            if self.incoming.fd && self.bit == 0 {
                // The ACK slot of an FD frame may be seen two bits long, or one bit late by the transmitter.
                self.acknowledged = true;
                self.bit = 1;
                return;
            }
            return self.raise(ErrorKind::Form, self.position(), cx);
        }
        if self.sending && !self.acknowledged {
            return self.raise(ErrorKind::Ack, Position::new(Field::AckSlot, 0), cx);
        }
        if !self.crc_ok {
            return self.raise(ErrorKind::Crc, self.position(), cx);
        }
        self.enter(Field::Eof);
    }

    fn eof_bit(&mut self, bit: bool, cx: &mut Context<'_>) {
        let index = self.bit;
        if !bit {
            // A transmitter has been caught by its bit monitoring already.
            if index == 6 {
                return self.overload(crate::OverloadCause::LastBitOfEof, cx);
            }
            return self.raise(ErrorKind::Form, self.position(), cx);
        }
        self.bit += 1;
        let (sof, res) = (self.sof_time, self.incoming.fd.then_some(self.res_time));
        if index == 5 && !self.sending {
            cx.emit(EventKind::Received { frame: self.incoming.frame(), sof, res });
        }
        if index == 6 {
            if self.sending {
                self.sending = false;
                let frame = self.outgoing;
                if self.mode.counts_errors() {
                    self.confinement.transmitted(cx);
                }
                if self.mode.is_loopback() {
                    cx.emit(EventKind::Received { frame, sof, res });
                }
                cx.emit(EventKind::Transmitted { frame, sof, res });
            }
            self.enter_intermission(cx);
        }
    }

    fn protocol_exception(&mut self, cx: &mut Context<'_>) {
        cx.emit(EventKind::ProtocolException);
        self.integrate();
    }
}
