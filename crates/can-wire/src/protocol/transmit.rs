//! What a node drives.

use can_frame::{Format, Id};

use super::{ErrorKind, Field, Protocol};

/// What the comparison of a driven with a sampled bit tells a node that sends a frame.
pub(super) enum Monitored {
    Fine,
    ArbitrationLost,
    Error(ErrorKind),
}

impl Protocol {
    /// The level to drive in the bit that is sampled next.
    #[inline]
    pub(super) fn next_drive(&self) -> bool {
        if self.sending {
            return if self.stuff_next { !self.last } else { self.frame_bit_to_send() };
        }
        match self.field {
            Field::ErrorFlag => !self.flag.active,
            Field::OverloadFlag => false,
            Field::AckSlot => !(self.crc_ok && self.role == super::Role::Receiver),
            _ => true,
        }
    }

    fn frame_bit_to_send(&self) -> bool {
        let frame = &self.outgoing;
        let bit = u32::from(self.bit);
        match self.field {
            Field::Sof | Field::Res => false,
            Field::BaseId => {
                let base = if frame.is_extended() { frame.raw_id() >> 18 } else { frame.raw_id() };
                base >> (10 - bit) & 1 == 1
            }
            Field::Rtr => frame.is_extended() || frame.is_remote() || frame.remote_request_substitution(),
            Field::Ide => matches!(frame.id(), Id::Extended(_)),
            Field::ExtendedId => frame.raw_id() >> (17 - bit) & 1 == 1,
            Field::ExtendedRtr => frame.is_remote() || frame.remote_request_substitution(),
            Field::Fdf => frame.is_fd(),
            Field::Brs => frame.bit_rate_switch(),
            Field::Esi => matches!(frame.format(), Format::Fd(flags) if flags.esi),
            Field::Dlc => frame.dlc().code() >> (3 - bit) & 1 == 1,
            Field::Data => self.data_bit_to_send(),
            Field::StuffCount => super::stuff_count_field(self.checks.stuff_bits) >> (3 - bit) & 1 == 1,
            Field::Crc => self.crc_expected >> (self.checks.crc().width() - 1 - bit) & 1 == 1,
            _ => true,
        }
    }

    #[inline]
    pub(super) fn data_bit_to_send(&self) -> bool {
        self.outgoing_data.get(usize::from(self.bit / 8)).is_none_or(|byte| byte >> (7 - self.bit % 8) & 1 == 1)
    }

    /// Compares what was sent with what was seen (ISO 11898-1:2015, 10.10 "bit error").
    #[inline]
    pub(super) fn monitor(&self, seen: bool) -> Monitored {
        if seen == self.drive {
            return Monitored::Fine;
        }
        if seen {
            return Monitored::Error(ErrorKind::Bit0);
        }
        match self.field {
            Field::AckSlot => Monitored::Fine,
            // FD: an acknowledgement may be two bits long, and arrive a bit late.
            Field::AckDelimiter if self.incoming.fd && self.bit == 0 => Monitored::Fine,
            // A recessive stuff bit of the arbitration field that turns dominant is the sixth equal bit.
            field if self.stuff_next && self.stuff_bit_is_in_arbitration(field) => Monitored::Error(ErrorKind::Stuff),
            field if field.is_arbitration() && !self.stuff_next => Monitored::ArbitrationLost,
            _ => Monitored::Error(ErrorKind::Bit1),
        }
    }

    fn stuff_bit_is_in_arbitration(&self, before: Field) -> bool {
        match before {
            Field::BaseId | Field::Rtr => true,
            Field::Ide | Field::ExtendedId | Field::ExtendedRtr => self.outgoing.is_extended(),
            _ => false,
        }
    }
}
