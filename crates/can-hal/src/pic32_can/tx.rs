//! Transmission (34.6.2, 34.7).

use can_frame::Frame;
use pic32_can_pac::{enums::FifoConTxpri, registers as pac};
use regbus::Bus;

use super::{Can, Inner, element, fifo::Kind};
use crate::{
    SendError,
    controller::Outcome,
    mode::{Configuration, Sends},
};

/// A message in a transmit FIFO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticket {
    fifo: u8,
    number: u16,
}

impl Ticket {
    /// The FIFO.
    #[must_use]
    pub const fn fifo(self) -> u8 {
        self.fifo
    }
}

/// True if a number of a sequence that wraps comes before another.
const fn before(number: u16, other: u16) -> bool {
    (number.wrapping_sub(other) as i16) < 0
}

/// Reads of FRESET within which a FIFO is reset: a number of clocks, about as long as a read takes (34.6.4).
const RESET_POLLS: u32 = 64;

impl<R: Bus, M: Bus> Inner<R, M> {
    /// The number of the first message of a FIFO that has not been sent.
    ///
    /// CiFIFOCIn is read before TXEMPTYIF: if the FIFO is not empty afterwards, it was not when the index was read, and an
    /// index equal to the head means that it is full.
    fn sent(&self, number: u8) -> u16 {
        let fifo = &self.fifos[usize::from(number % 32)];
        let registers = self.regs.fifo(usize::from(number % 32));
        let index = registers.ci().read().fifoci();
        if fifo.base == fifo.queued || registers.int_().read().txemptyif() {
            return fifo.queued;
        }
        let depth = fifo.depth.max(1);
        let waiting = (fifo.head + depth - index % depth) % depth;
        fifo.queued.wrapping_sub(u16::from(if waiting == 0 { depth } else { waiting }))
    }

    /// An abort that was asked for has come to its end: what was not sent is erased, so that the FIFO can be used again
    /// (34.7.4). Returns false while TXREQ is still 1.
    fn settle_abort(&mut self, number: u8) -> bool {
        let bit = 1 << (number % 32);
        if self.aborting & bit == 0 {
            return true;
        }
        if self.control(number).txreq() {
            return false;
        }
        self.aborting &= !bit;
        let sent = self.sent(number);
        self.fifos[usize::from(number % 32)].cancelled_from = sent;
        if sent != self.fifos[usize::from(number % 32)].queued {
            self.reset(number);
        }
        true
    }

    /// 34.6.4, Example 34-5.
    fn reset(&mut self, number: u8) {
        self.regs.fifo(usize::from(number % 32)).con().set_bits(pac::FifoCon::FRESET);
        for _ in 0..RESET_POLLS {
            if !self.control(number).freset() {
                break;
            }
        }
        self.fifos[usize::from(number % 32)].forget();
    }

    /// 34.6.2: the message goes to the buffer that CiFIFOUAn gives; then UINC, and TXREQ if it is requested, in one
    /// store to the SET register.
    #[inline]
    fn put(&mut self, number: u8, frame: &Frame, request: bool) -> Result<Ticket, SendError> {
        if frame.is_fd() {
            return Err(SendError::FdDisabled);
        }
        if self.fifos.get(usize::from(number)).is_none_or(|fifo| fifo.kind != Kind::Transmit) {
            return Err(self.no_such_fifo(number));
        }
        let registers = self.regs.fifo(usize::from(number % 32));
        if !self.settle_abort(number) {
            return Err(SendError::Full);
        }
        let flags = registers.int_().read();
        if !flags.txnfullif() {
            return Err(SendError::Full);
        }
        let bit = 1 << (number % 32);
        if request {
            self.requested |= bit;
        } else if flags.txemptyif() {
            // 34.7.2: what was requested is sent, and TXREQ is 0.
            self.requested &= !bit;
        }
        let fifo = &mut self.fifos[usize::from(number % 32)];
        let address = fifo.checked(registers.ua().read().bits(), self.base);
        element::write(self.ram, (address - self.address) as usize, frame);
        let commands = if request { pac::FifoCon::UINC | pac::FifoCon::TXREQ } else { pac::FifoCon::UINC };
        registers.con().set_bits(commands);
        Ok(Ticket { fifo: number, number: fifo.advance() })
    }

    fn no_such_fifo(&self, number: u8) -> SendError {
        let count = self.fifos.iter().filter(|fifo| fifo.kind == Kind::Transmit).count() as u8;
        SendError::NoSuchBuffer { buffer: number, count }
    }

    /// What was preloaded is put in, now that the FIFOs are out of their reset (34.6.4).
    pub(super) fn put_preloaded(&mut self) {
        for (number, fifo) in self.fifos.iter_mut().enumerate() {
            for _ in 0..core::mem::take(&mut fifo.preloaded) {
                self.regs.fifo(number).con().set_bits(pac::FifoCon::UINC);
            }
        }
    }

    /// Through the first transmit FIFO that does not answer remote frames.
    #[inline]
    pub(super) fn send(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        let free = |number: u8| self.replies >> number & 1 == 0;
        let mut numbers = (0..).zip(&self.fifos);
        let found = numbers.find(|(number, fifo)| fifo.kind == Kind::Transmit && free(*number));
        let number = found.map_or(u8::MAX, |(number, _)| number);
        self.put(number, frame, true)
    }

    pub(super) fn outcome(&mut self, ticket: Ticket) -> Outcome {
        let settled = self.settle_abort(ticket.fifo);
        let sent = self.sent(ticket.fifo);
        let fifo = &self.fifos[usize::from(ticket.fifo % 32)];
        let (from, to) = fifo.asked;
        let asked = from != to && !before(ticket.number, from) && before(ticket.number, to);
        if asked && settled && !before(ticket.number, fifo.cancelled_from) {
            return Outcome::Cancelled;
        }
        match (before(ticket.number, sent), asked) {
            (true, false) => Outcome::Sent,
            (true, true) => Outcome::SentAnyway,
            (false, _) => Outcome::Pending,
        }
    }

    /// 34.7.4: clears TXREQ.
    pub(super) fn cancel(&mut self, number: u8) {
        if self.fifos.get(usize::from(number)).is_none_or(|fifo| fifo.kind != Kind::Transmit) {
            return;
        }
        let sent = self.sent(number);
        let fifo = &mut self.fifos[usize::from(number % 32)];
        if sent == fifo.queued || self.aborting >> number & 1 == 1 {
            return;
        }
        fifo.asked = (sent, fifo.queued);
        self.regs.fifo(usize::from(number % 32)).con().clear_bits(pac::FifoCon::TXREQ);
        self.aborting |= 1 << number;
    }

    /// FIFOs with messages that were requested and are not sent: what is requested is sent until the FIFO is empty (34.7.2).
    /// Destroys nothing, unlike a read of TXREQ.
    pub(super) fn waiting(&self) -> u32 {
        let mut waiting = 0;
        for number in (0..32).filter(|number| self.requested >> number & 1 == 1) {
            let empty = self.regs.fifo(number).int_().read().txemptyif();
            waiting |= u32::from(!empty) << number;
        }
        waiting
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    /// Puts a frame into a transmit FIFO for when Configuration mode ends, without requesting it: the first answer to a
    /// remote frame (34.7.5). Called after [`Can::configure`].
    ///
    /// # Errors
    /// [`SendError::Full`] if the FIFO holds no more, or another [`SendError`].
    pub fn preload(&mut self, fifo: u8, frame: &Frame) -> Result<Ticket, SendError> {
        let inner = &mut self.inner;
        if frame.is_fd() {
            return Err(SendError::FdDisabled);
        }
        let missing = inner.no_such_fifo(fifo);
        let place = inner.fifos.get_mut(usize::from(fifo)).filter(|place| place.kind == Kind::Transmit);
        let place = place.ok_or(missing)?;
        if place.preloaded == place.depth {
            return Err(SendError::Full);
        }
        element::write(inner.ram, (place.head_address(inner.base) - inner.address) as usize, frame);
        place.preloaded += 1;
        Ok(Ticket { fifo, number: place.advance() })
    }
}

impl<S: Sends, R: Bus, M: Bus> Can<S, R, M> {
    /// Sends a frame through a transmit FIFO (34.6.2, 34.7.2).
    ///
    /// # Errors
    /// [`SendError::Full`] if the FIFO is full, or if an abort of it is not over yet; or another [`SendError`].
    pub fn send_through(&mut self, fifo: u8, frame: &Frame) -> Result<Ticket, SendError> {
        self.inner.put(fifo, frame, true)
    }

    /// Puts a frame into a transmit FIFO without requesting it: it is sent with [`Can::request`], or with the next frame
    /// that is sent through this FIFO.
    ///
    /// # Errors
    /// As for [`Can::send_through`].
    pub fn load(&mut self, fifo: u8, frame: &Frame) -> Result<Ticket, SendError> {
        self.inner.put(fifo, frame, false)
    }

    /// The same for a FIFO that answers remote frames (34.7.5): each answer takes its messages, so that it has to be
    /// loaded again afterwards. [`Can::missed_request`] tells of requests that found it empty.
    ///
    /// # Errors
    /// As for [`Can::send_through`].
    pub fn load_reply(&mut self, fifo: u8, frame: &Frame) -> Result<Ticket, SendError> {
        self.inner.put(fifo, frame, false)
    }

    /// Requests what is in a transmit FIFO.
    pub fn request(&mut self, fifo: u8) {
        if self.inner.fifos.get(usize::from(fifo)).is_none_or(|fifo| fifo.kind != Kind::Transmit) {
            return;
        }
        self.inner.requested |= 1 << (fifo % 32);
        self.inner.regs.fifo(usize::from(fifo % 32)).con().set_bits(pac::FifoCon::TXREQ);
    }

    /// True once if a remote frame found a FIFO that answers such frames empty (34.7.5).
    pub fn missed_request(&mut self, fifo: u8) -> bool {
        let flags = self.inner.regs.fifo(usize::from(fifo % 32)).int_();
        let missed = flags.read().rxovflif();
        if missed {
            flags.clear_bits(pac::FifoInt::RXOVFLIF);
        }
        missed
    }

    /// Aborts everything in a transmit FIFO (34.7.4); [`Transmit::outcome`](crate::Transmit::outcome) of its tickets tells
    /// what was sent. A message on the bus is finished.
    pub fn abort(&mut self, fifo: u8) {
        self.inner.cancel(fifo);
    }

    /// Aborts everything in all transmit FIFOs (ABAT of Register 34-1).
    pub fn abort_all(&mut self) {
        let inner = &mut self.inner;
        let waiting = inner.waiting() & !inner.aborting;
        for number in (0..32).filter(|number| waiting >> number & 1 == 1) {
            let sent = inner.sent(number);
            let fifo = &mut inner.fifos[usize::from(number)];
            fifo.asked = (sent, fifo.queued);
        }
        inner.aborting |= waiting;
        inner.regs.con().set_bits(pac::Con::ABAT);
    }

    /// Aborts a FIFO if an attempt to send has failed since its status was asked for last: as near to sending only once as
    /// the module comes. A second attempt may be on the bus by then. Returns true if it did.
    pub fn abort_if_failed(&mut self, fifo: u8) -> bool {
        let status = self.tx_status(fifo);
        let failed = status.error || status.lost_arbitration;
        if failed {
            self.inner.cancel(fifo);
        }
        failed
    }

    /// Changes the priority of a transmit FIFO; it counts from the next message on (34.7.3).
    pub fn set_priority(&mut self, fifo: u8, priority: FifoConTxpri) {
        let con = self.inner.regs.fifo(usize::from(fifo % 32)).con();
        // Through the CLR and SET registers: a read-modify-write could repeat or abort a request.
        con.clear_bits(pac::FifoCon::ZERO.with_txpri(FifoConTxpri::Highest));
        con.set_bits(pac::FifoCon::ZERO.with_txpri(priority));
    }
}
