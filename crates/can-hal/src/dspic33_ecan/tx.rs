//! Transmission (8.0): queue, dedicated buffers, abort, answers to remote frames.

use can_frame::Frame;
use dspic33_ecan_pac::{enums::TxPriority, registers as pac};
use regbus::Bus;

use super::{Can, Inner, Use, config::control};
use crate::{SendError, controller::Outcome, mode::Sends};

/// Buffers that can transmit (1.2).
pub(super) const TX_BUFFERS: u8 = 8;

/// Priorities that the queue uses, highest first. The highest of all is left to dedicated buffers and answers.
const QUEUE_LEVELS: [TxPriority; 3] = [TxPriority::IntermediateHigh, TxPriority::IntermediateLow, TxPriority::Lowest];

/// A transmit buffer with a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticket(u8);

impl Ticket {
    /// Number of the buffer.
    #[must_use]
    pub const fn buffer(self) -> u8 {
        self.0
    }
}

/// What sending knows besides the registers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tx {
    pub(super) uses: [Use; TX_BUFFERS as usize],
    /// The control registers without requests. Every write starts from them, never from what was read: hardware changes the
    /// requests of both buffers of a pair.
    pub(super) control: [pac::TrCon; TX_BUFFERS as usize / 2],
    /// Bit per buffer: its abort was requested.
    cancelled: u8,
    /// The last message of the queue: index of its priority in [`QUEUE_LEVELS`], and its buffer.
    last: Option<(u8, u8)>,
}

impl Default for Tx {
    fn default() -> Self {
        Self {
            uses: [Use::Receive; TX_BUFFERS as usize],
            control: [pac::TrCon::from_bits(0); TX_BUFFERS as usize / 2],
            cancelled: 0,
            last: None,
        }
    }
}

impl Tx {
    pub(super) fn set_up(&mut self, uses: &[Use; TX_BUFFERS as usize]) {
        *self = Self { uses: *uses, ..Self::default() };
        for (buffer, use_) in uses.iter().enumerate() {
            let register = &mut self.control[buffer / 2];
            *register = control(*register, buffer % 2, *use_);
        }
    }

    fn is_queue(&self, buffer: u8) -> bool {
        self.uses[usize::from(buffer % TX_BUFFERS)] == Use::Queue
    }

    /// 8.1: the place for the next message of the queue: it must come after all that wait, that is, have a lower priority
    /// or, with the same one, a lower number.
    fn next_place(&self, pending: u8, free: u8) -> Option<(u8, u8)> {
        let best = |among: u8| among.checked_ilog2().map(|buffer| buffer as u8);
        let Some((level, last)) = self.last.filter(|_| pending != 0) else { return Some((0, best(free)?)) };
        if let Some(buffer) = best(free & ((1 << last) - 1)) {
            return Some((level, buffer));
        }
        let next = level + 1;
        (usize::from(next) < QUEUE_LEVELS.len()).then_some(())?;
        Some((next, best(free)?))
    }
}

/// Which half of its register is a buffer's (Tables 3-2, 3-5).
#[inline]
const fn half(buffer: u8) -> usize {
    (buffer & 1) as usize
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// The control bits of a buffer's pair, and which half is the buffer's.
    #[inline]
    fn read_control(&self, buffer: u8) -> (pac::TrCon, usize) {
        (self.regs.tr_con(usize::from(buffer % TX_BUFFERS / 2)).read(), half(buffer))
    }

    /// Writes the control register of a buffer with or without its request. That of the other one of the pair is not
    /// pending, which the caller knows.
    fn write_request(&self, buffer: u8, request: bool) {
        let pair = usize::from(buffer % TX_BUFFERS / 2);
        self.regs.tr_con(pair).write(self.tx.control[pair].with_txreq(half(buffer), request));
    }

    /// The buffer of the pair, if any, whose request is pending.
    fn pending_in_pair(&self, buffer: u8) -> Option<u8> {
        let (value, lane) = self.read_control(buffer);
        if value.txreq(lane) {
            Some(buffer)
        } else if value.txreq(half(buffer ^ 1)) {
            Some(buffer ^ 1)
        } else {
            None
        }
    }

    fn carries(frame: &Frame) -> Result<(), SendError> {
        if frame.is_fd() { Err(SendError::FdDisabled) } else { Ok(()) }
    }

    /// 8.1: configured before; the message first, then the request.
    fn send_from(&mut self, buffer: u8, frame: &Frame) -> Ticket {
        self.tx.cancelled &= !(1 << buffer);
        self.write_element(buffer, frame);
        self.write_request(buffer, true);
        Ticket(buffer)
    }

    /// Bits of the queue's buffers: those with a request, and those that are free.
    fn queue_state(&self) -> (u8, u8) {
        let (mut pending, mut free) = (0, 0);
        for pair in 0..TX_BUFFERS / 2 {
            let buffers = [2 * pair, 2 * pair + 1];
            if !buffers.iter().any(|buffer| self.tx.is_queue(*buffer)) {
                continue;
            }
            let (value, _) = self.read_control(buffers[0]);
            let requests = [value.txreq(0), value.txreq(1)];
            for (buffer, request) in buffers.into_iter().zip(requests) {
                if self.tx.is_queue(buffer) {
                    pending |= u8::from(request) << buffer;
                    free |= u8::from(requests == [false, false]) << buffer;
                }
            }
        }
        (pending, free)
    }

    pub(super) fn send_queued(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        Self::carries(frame)?;
        let (pending, free) = self.queue_state();
        let (level, buffer) = self.tx.next_place(pending, free).ok_or(SendError::Full)?;
        self.tx.last = Some((level, buffer));
        // The bounds never act; they tell the compiler that the indices fit.
        let register = &mut self.tx.control[usize::from(buffer % TX_BUFFERS / 2)];
        let priority = QUEUE_LEVELS[usize::from(level) % QUEUE_LEVELS.len()];
        *register = register.with_txpri(half(buffer), priority);
        Ok(self.send_from(buffer, frame))
    }

    /// 8.1, 8.2
    pub(super) fn outcome(&self, ticket: Ticket) -> Outcome {
        let (value, lane) = self.read_control(ticket.0);
        if value.txreq(lane) {
            Outcome::Pending
        } else if value.txabt(lane) {
            Outcome::Cancelled
        } else if self.tx.cancelled >> ticket.0 & 1 == 1 {
            Outcome::SentAnyway
        } else {
            Outcome::Sent
        }
    }

    /// 8.2: clears TXREQ. The frame is aborted unless it is on the bus and succeeds.
    pub(super) fn cancel(&mut self, buffer: u8) {
        if self.pending_in_pair(buffer) == Some(buffer) {
            self.tx.cancelled |= 1 << buffer;
            self.write_request(buffer, false);
        }
    }

    /// True if a transmit buffer has a request. `pair` counts the control registers.
    pub(super) fn pair_is_pending(&self, pair: u8) -> bool {
        let (value, _) = self.read_control(2 * pair);
        value.txreq(0) || value.txreq(1)
    }

    pub(super) fn pair_sends(&self, pair: u8) -> bool {
        let uses =
            [self.tx.uses[usize::from(2 * pair % TX_BUFFERS)], self.tx.uses[usize::from((2 * pair + 1) % TX_BUFFERS)]];
        uses.iter().any(|use_| *use_ != Use::Receive)
    }

    /// The requests of all buffers are gone.
    pub(super) const fn forget_requests(&mut self) {
        self.tx.cancelled = 0;
        self.tx.last = None;
    }
}

impl<S: Sends, R: Bus, M: Bus> Can<S, R, M> {
    /// Sends a frame from a dedicated buffer, with the buffer's priority (8.1).
    ///
    /// # Errors
    /// [`SendError::Pending`] if its last frame, or that of the other buffer of its pair, is not sent yet;
    /// [`SendError::NoSuchBuffer`] if the buffer is not dedicated; or another [`SendError`].
    pub fn send_buffer(&mut self, buffer: u8, frame: &Frame) -> Result<Ticket, SendError> {
        let inner = &mut self.inner;
        if buffer >= TX_BUFFERS || !matches!(inner.tx.uses[usize::from(buffer)], Use::Dedicated(_)) {
            return Err(SendError::NoSuchBuffer { buffer, count: TX_BUFFERS });
        }
        Inner::<R, M>::carries(frame)?;
        match inner.pending_in_pair(buffer) {
            Some(buffer) => Err(SendError::Pending { buffer }),
            None => Ok(inner.send_from(buffer, frame)),
        }
    }

    /// Aborts everything that waits (CxCTRL1.ABAT, 8.2). A frame on the bus is sent if it succeeds. Returns when the
    /// request is made.
    pub fn cancel_all(&mut self) {
        let inner = &self.inner;
        let pairs = (0..TX_BUFFERS / 2).filter(|pair| inner.pair_sends(*pair));
        let pending = pairs.filter_map(|pair| inner.pending_in_pair(2 * pair));
        let cancelled = pending.fold(0, |mask, buffer| mask | 1 << (buffer % TX_BUFFERS));
        self.inner.tx.cancelled |= cancelled;
        self.inner.regs.ctrl1().modify(|ctrl1| ctrl1.with_abat(true));
    }

    /// True while [`Can::cancel_all`] is not done.
    #[must_use]
    pub fn is_cancelling(&self) -> bool {
        self.inner.regs.ctrl1().read().abat()
    }

    /// What has happened to a frame on its way: lost arbitration, and an error; both since it was requested (8.1,
    /// Table 8-1).
    #[must_use]
    pub fn attempts(&self, ticket: Ticket) -> (bool, bool) {
        let (value, lane) = self.inner.read_control(ticket.0);
        (value.txlarb(lane), value.txerr(lane))
    }
}

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    /// Puts the answer to remote frames into a buffer that has [`Use::Reply`], and lets it answer from now on (8.3.2). The
    /// length in a request is ignored.
    ///
    /// A request that arrives while the answer changes stays without one; none gets a mixture of both.
    ///
    /// # Errors
    /// [`SendError::NoSuchBuffer`] if the buffer does not answer, [`SendError::Pending`] if an answer is being sent: the old
    /// one stays; or another [`SendError`].
    pub fn set_reply(&mut self, buffer: u8, frame: &Frame) -> Result<(), SendError> {
        let inner = &mut self.inner;
        if buffer >= TX_BUFFERS || !matches!(inner.tx.uses[usize::from(buffer)], Use::Reply(_)) {
            return Err(SendError::NoSuchBuffer { buffer, count: TX_BUFFERS });
        }
        Inner::<R, M>::carries(frame)?;
        if inner.pending_in_pair(buffer).is_some() {
            return Err(SendError::Pending { buffer });
        }
        let (pair, lane) = (usize::from(buffer / 2), half(buffer));
        // It does not answer while its message changes. An answer that was requested meanwhile is aborted (8.2), unless it
        // is on the bus already.
        inner.tx.control[pair] = inner.tx.control[pair].with_rtren(lane, false);
        inner.write_request(buffer, false);
        let sending = inner.pending_in_pair(buffer);
        if sending.is_none() {
            inner.write_element(buffer, frame);
        }
        inner.tx.control[pair] = inner.tx.control[pair].with_rtren(lane, true);
        inner.write_request(buffer, false);
        sending.map_or(Ok(()), |buffer| Err(SendError::Pending { buffer }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever is free, the next message has a lower rank than every one that waits.
    #[test]
    fn the_queue_keeps_the_order_of_the_calls() {
        let mut tx = Tx::default();
        // The four buffers of the queue, oldest first.
        let (mut waiting, mut count, mut random) = ([(0, 0); 4], 0, 1_u32);
        let (mut placed, mut refused) = (0, 0);
        for _ in 0..10_000 {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            if random >> 16 & 1 == 0 && count > 0 {
                // The module sends the one with the highest rank: the oldest.
                waiting.rotate_left(1);
                count -= 1;
                continue;
            }
            let pending = waiting[..count].iter().fold(0, |mask, (_, buffer)| mask | 1_u8 << buffer);
            let Some((level, buffer)) = tx.next_place(pending, 0b0101_0101 & !pending) else {
                assert_ne!(count, 0);
                refused += 1;
                continue;
            };
            let rank = |(level, buffer): (u8, u8)| (core::cmp::Reverse(level), buffer);
            assert!(waiting[..count].iter().all(|other| rank(*other) > rank((level, buffer))));
            tx.last = Some((level, buffer));
            waiting[count] = (level, buffer);
            count += 1;
            placed += 1;
        }
        assert!(placed > 3_000 && refused > 0, "{placed} placed, {refused} refused");
    }
}
