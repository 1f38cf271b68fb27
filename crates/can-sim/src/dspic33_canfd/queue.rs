//! The transmit queue (6.3, 6.7.2, 10.4).

use dspic33_canfd_pac::registers as pac;

use super::Dspic33CanfdModel;
use crate::model::Context;

/// Which objects of the queue hold messages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Queue {
    /// Bit n: object n holds a message.
    pub(super) used: u32,
    /// The object that the user address points to.
    user: u8,
    /// The object that is sent next.
    next: u8,
}

impl Queue {
    fn lowest_free(self, depth: u32) -> Option<u8> {
        let free = (!self.used).trailing_zeros();
        (free < depth).then_some(free as u8)
    }
}

impl Dspic33CanfdModel {
    /// 10.4: UINC moves the user address to the lowest free object; a full queue shows object 0.
    pub(super) fn queue_loaded(&mut self, depth: u32) {
        let queue = &mut self.fifos.queue;
        queue.used |= 1 << queue.user;
        queue.user = queue.lowest_free(depth).unwrap_or(0);
    }

    /// An object's message was sent. `queue_address_after_full`.
    pub(super) fn queue_sent(&mut self, object: u8) {
        let depth = self.depth(0);
        let queue = &mut self.fifos.queue;
        let was_full = queue.lowest_free(depth).is_none();
        queue.used &= !(1 << object);
        if was_full {
            queue.user = object;
        }
    }

    /// `queue_order`: the message that would win the arbitration; of equal ones the lowest object.
    pub(super) fn next_in_queue(&mut self, cx: &mut Context<'_>) -> u8 {
        let placed = self.layout.objects[0];
        let used = self.fifos.queue.used;
        let best = (0..32_u8).filter(|object| used >> object & 1 == 1).min_by_key(|object| {
            let header = self.read_header(cx, placed.address(u32::from(*object)));
            header.map_or(u64::MAX, |header| self.priority(header))
        });
        let best = best.unwrap_or(0);
        self.fifos.queue.next = best;
        self.show_queue();
        best
    }

    pub(super) fn show_queue(&mut self) {
        let placed = self.layout.objects[0];
        let count = self.fifos.queue.used.count_ones();
        let flags = [(pac::Txqsta::TXQEIF, count == 0), (pac::Txqsta::TXQNIF, count < placed.count)];
        self.set_flags(self.r.txqsta, flags.map(|(flag, on)| (flag.bits(), on)));
        self.regs.set_field(self.f.txqci, u32::from(self.fifos.queue.next));
        let address = placed.address(u32::from(self.fifos.queue.user));
        self.show_address(self.r.txqua_l, self.r.txqua_h, address);
        self.combine(0);
    }
}
