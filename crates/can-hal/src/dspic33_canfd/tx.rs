//! Sending (6.0): the queue, transmit FIFOs, automatic replies, what has become of a frame.
//!
//! The module aborts, and gives up, a FIFO as a whole, and never takes a single message out of it (6.9, 6.10). So does the
//! driver: a cancellation, and a failure with limited attempts, concerns all frames of that FIFO or queue that are not
//! sent yet; they are removed by FRESET.

use can_frame::Frame;
use dspic33_canfd_pac::{
    messages::{TxObject, TxObjectT3},
    registers as pac,
};
use regbus::{Bus, Payload};

use super::{
    Attempts, Can, FdMode, Inner, SETTLE,
    config::transmits,
    layout::numbers,
    object::{encode_control, encode_id},
};
use crate::{
    Deadline, SendError, TimedOut,
    controller::Outcome,
    deadline::{Polls, wait},
    mode::Sends,
};

/// A number that software chooses to recognize a frame in the event FIFO; 23 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sequence(u32);

impl Sequence {
    /// The largest.
    pub const MAX: Self = Self(0x7F_FFFF);

    /// `None` if the number has more than 23 bits.
    #[must_use]
    pub const fn new(number: u32) -> Option<Self> {
        if number <= Self::MAX.0 { Some(Self(number)) } else { None }
    }
}

/// What is recorded beside the frame (6.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct TxOptions {
    /// The sequence number that the frame's event will show.
    pub sequence: Sequence,
}

/// A frame on its way. It is known until as many frames as the FIFO holds were given to it afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticket {
    source: u8,
    number: u8,
}

impl Ticket {
    /// The FIFO, 0 for the queue.
    #[must_use]
    pub const fn fifo(self) -> u8 {
        self.source
    }
}

/// How a frame has ended, in two bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Sent = 0,
    SentAnyway = 1,
    Cancelled = 2,
    Failed = 3,
}

/// The frames given to one FIFO or the queue, by running numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct Track {
    /// The next frame's number.
    next: u8,
    /// Frames that are not known to be done.
    waiting: u8,
    /// The object that the module fills next.
    head: u8,
    cancelling: bool,
    /// Ends of the last 32 frames, two bits each.
    ends: [u8; 8],
}

impl Track {
    /// The oldest waiting frames have ended.
    fn end(&mut self, count: u8, how: End) {
        for _ in 0..count.min(self.waiting) {
            let (byte, shift) = place(self.next.wrapping_sub(self.waiting));
            self.ends[byte] = self.ends[byte] & !(3 << shift) | (how as u8) << shift;
            self.waiting -= 1;
        }
    }

    fn outcome(&self, number: u8) -> Outcome {
        let age = self.next.wrapping_sub(number);
        if age <= self.waiting {
            return Outcome::Pending;
        }
        let (byte, shift) = place(number);
        match self.ends[byte] >> shift & 3 {
            0 => Outcome::Sent,
            1 => Outcome::SentAnyway,
            2 => Outcome::Cancelled,
            _ => Outcome::Failed,
        }
    }
}

/// Byte and bit at which the end of a frame stands.
const fn place(number: u8) -> (usize, u8) {
    (number as usize / 4 % 8, number % 4 * 2)
}

/// The state of a FIFO or the queue, from one read of its registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct State {
    requested: bool,
    empty: bool,
    room: bool,
    /// The object that is sent next.
    index: u8,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Offset in the region of an address of the module.
    #[inline]
    pub(super) fn offset(&self, address: u32) -> usize {
        address.wrapping_sub(self.base) as usize
    }

    /// 6.6: the FIFOs with a request. The upper register is read only where the plan has such FIFOs.
    pub(super) fn pending(&self) -> u32 {
        let low = u32::from(self.regs.txreq_l().read().bits());
        if self.layout.transmit >> 16 == 0 { low } else { low | u32::from(self.regs.txreq_h().read().bits()) << 16 }
    }

    /// Whether the configuration and the objects can carry a frame.
    #[inline]
    pub(super) fn carries(&self, number: u8, frame: &Frame) -> Result<(), SendError> {
        let room = self.layout.objects[usize::from(number) % 32].data();
        match self.fd {
            FdMode::Classic if frame.is_fd() => return Err(SendError::FdDisabled),
            FdMode::Fd { bit_rate_switch: false, .. } if frame.bit_rate_switch() => {
                return Err(SendError::BitRateSwitchDisabled);
            }
            _ => {}
        }
        // 6.12: the module would not send it.
        if frame.len() > room {
            return Err(SendError::TooLong { len: frame.len() as u8, room: room as u8 });
        }
        Ok(())
    }

    /// Table 6-1. All words of the header are written: RAM holds anything.
    #[inline]
    pub(super) fn write_object(&self, number: u8, index: u8, frame: &Frame, options: TxOptions) {
        let section = self.layout.objects[usize::from(number) % 32];
        let object = TxObject::new(self.ram, section.at(index));
        let (t0, t1) = encode_id(frame);
        let sequence = options.sequence.0;
        object.t0().write(t0);
        object.t1().write(t1);
        object.t2().write(encode_control(frame).with_seq((sequence & 0x7F) as u8));
        object.t3().write(TxObjectT3::ZERO.with_seq((sequence >> 7) as u16));
        Payload::<u16, M>::new(self.ram, section.at(index) + section.header(), section.data())
            .write(frame.data_bytes(), 0);
    }

    /// TXREQ is read before the status: a frame that is sent in between is then told by the next look, and not taken for
    /// given up.
    #[inline]
    fn state(&self, number: u8) -> State {
        if number == 0 {
            let requested = self.regs.txqcon_l().read().txreq();
            let status = self.regs.txqsta().read();
            State { requested, empty: status.txqeif(), room: status.txqnif(), index: status.txqci() }
        } else {
            let fifo = self.fifo(number);
            let requested = fifo.con_l().read().txreq();
            let status = fifo.sta().read();
            State { requested, empty: status.tferffif(), room: status.tfnrfnif(), index: status.fifoci() }
        }
    }

    /// The object to be filled next.
    #[inline]
    fn head(&self, number: u8) -> u8 {
        let address = if number == 0 { self.regs.read_txqua() } else { self.fifo(number).read_ua() };
        self.layout.objects[usize::from(number) % 32].index(self.offset(address))
    }

    /// Writes the control register with requests.
    #[inline]
    fn command(&self, number: u8, uinc: bool, txreq: bool, freset: bool) {
        if number == 0 {
            let control = pac::TxqconL::TXATIE;
            self.regs.txqcon_l().write(control.with_uinc(uinc).with_txreq(txreq).with_freset(freset));
        } else {
            let control = self.fifo_control(number);
            let control = control.with_uinc(uinc).with_txreq(txreq).with_freset(freset);
            self.fifo(number).con_l().write(control);
        }
    }

    /// 13.1: bus off has reset the transmit FIFOs.
    fn was_bus_off(&mut self) -> bool {
        self.regs.trec_h().read().txbo() || self.diagnose().txboerr()
    }

    /// Finds out what has become of the frames of a FIFO or the queue.
    #[inline]
    fn settle(&mut self, number: u8) -> State {
        let state = self.state(number);
        let track = self.tracks[usize::from(number) % 32];
        if track.waiting == 0 {
            return state;
        }
        if state.empty {
            return self.settle_empty(number, state, track);
        }
        let mut track = track;
        if number != 0 {
            // 10.2: as many wait as lie between the index and the head.
            let depth = self.layout.objects[usize::from(number) % 32].count.max(1);
            let left = (track.head + depth - state.index % depth) % depth;
            let left = if left == 0 { depth } else { left };
            let how = if track.cancelling { End::SentAnyway } else { End::Sent };
            track.end(track.waiting.saturating_sub(left), how);
        }
        if !state.requested {
            // 6.9, 6.10: aborted, or given up. What is left is taken out.
            let how = if track.cancelling { End::Cancelled } else { End::Failed };
            track.end(track.waiting, how);
            track.head = 0;
            track.cancelling = false;
            self.tracks[usize::from(number) % 32] = track;
            self.reset(number);
            return self.state(number);
        }
        self.tracks[usize::from(number) % 32] = track;
        state
    }

    #[cold]
    fn settle_dropped(&mut self, number: u8, mut track: Track) {
        track.end(track.waiting, End::Failed);
        (track.head, track.cancelling) = (0, false);
        self.tracks[usize::from(number) % 32] = track;
    }

    /// An empty FIFO has sent everything, unless bus off has emptied it.
    #[inline]
    fn settle_empty(&mut self, number: u8, state: State, mut track: Track) -> State {
        let dropped = if number == 0 || track.head == 0 {
            self.was_bus_off()
        } else {
            // A reset has moved the head to the first object.
            self.head(number) != track.head
        };
        if dropped {
            self.settle_dropped(number, track);
            return state;
        }
        let how = if track.cancelling { End::SentAnyway } else { End::Sent };
        track.end(track.waiting, how);
        track.cancelling = false;
        self.tracks[usize::from(number) % 32] = track;
        state
    }

    /// 6.14, 6.15: FRESET, when no transmission is pending.
    fn reset(&self, number: u8) {
        self.command(number, false, false, true);
        let _done = wait(&mut Polls(SETTLE), || match number {
            0 => !self.regs.txqcon_l().read().freset(),
            _ => !self.fifo(number).con_l().read().freset(),
        });
        if number == 0 {
            self.regs.txqsta().clear(pac::Txqsta::TXATIF);
        } else {
            self.fifo(number).sta().clear(pac::FifoSta::TXATIF);
        }
    }

    /// 6.2 to 6.5: loads a message where the user address points; UINC and TXREQ in one write.
    #[inline]
    pub(super) fn send(&mut self, number: u8, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        self.carries(number, frame)?;
        let state = self.settle(number);
        let track = self.tracks[usize::from(number) % 32];
        // While it is being cancelled nothing is added: that would be a new request.
        if !state.room || track.cancelling {
            return Err(SendError::Full);
        }
        let depth = self.layout.objects[usize::from(number) % 32].count.max(1);
        let index = self.head(number);
        if number == 0 || (index + 1).is_multiple_of(depth) {
            // From now on a reset by bus off is told by TXBOERR alone; one from before must not be taken for it.
            self.diagnose();
        }
        self.write_object(number, index, frame, options);
        self.command(number, true, true, false);
        let track = &mut self.tracks[usize::from(number) % 32];
        let ticket = Ticket { source: number, number: track.next };
        track.next = track.next.wrapping_add(1);
        track.waiting += 1;
        track.head = (index + 1) % depth;
        Ok(ticket)
    }

    pub(super) fn outcome(&mut self, ticket: Ticket) -> Outcome {
        self.settle(ticket.source);
        self.tracks[usize::from(ticket.source) % 32].outcome(ticket.number)
    }

    /// 6.10: TXREQ is cleared; it stays set until the frame on the bus is sent.
    pub(super) fn cancel(&mut self, number: u8) {
        let state = self.settle(number);
        let track = &mut self.tracks[usize::from(number) % 32];
        if track.waiting > 0 && state.requested {
            track.cancelling = true;
            self.command(number, false, false, false);
        }
    }

    /// 6.11: one message in the FIFO, which no request sends but a remote frame.
    pub(super) fn arm(&mut self, number: u8) -> bool {
        let empty = self.state(number).empty;
        if empty {
            self.command(number, true, false, false);
        }
        empty
    }
}

impl<S: Sends, R: Bus, M: Bus> Can<S, R, M> {
    /// Sends a frame through the queue (6.3, 6.5): pending frames go by their identifiers. The module does not tell which
    /// of several frames in the queue it has sent, unless in events: they are all [`Outcome::Pending`] until the queue is
    /// empty.
    ///
    /// # Errors
    /// [`SendError::Full`] if no object is free, [`SendError::NoSuchBuffer`] if the plan has no queue, or another
    /// [`SendError`].
    pub fn send_queued(&mut self, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        self.send_fifo(0, frame, options)
    }

    /// Sends a frame through a transmit FIFO (6.2, 6.4), in the order of the calls.
    ///
    /// # Errors
    /// [`SendError::Full`] if no object is free, [`SendError::NoSuchBuffer`] if the FIFO does not transmit or is for
    /// replies, or another [`SendError`].
    pub fn send_fifo(&mut self, fifo: u8, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        let usable = self.inner.layout.transmit & !self.inner.replies;
        if !transmits(usable, fifo) {
            return Err(SendError::NoSuchBuffer { buffer: fifo, count: usable.count_ones() as u8 });
        }
        self.inner.send(fifo, frame, options)
    }

    /// FIFOs with a request, bit 0 for the queue (6.6).
    #[must_use]
    pub fn pending_fifos(&self) -> u32 {
        self.inner.pending()
    }

    /// Aborts everything that is not on the bus (6.10): sets ABAT, waits until no request is left, and clears ABAT, which
    /// the module may have done by itself.
    ///
    /// # Errors
    /// [`TimedOut`] if requests are left at the bound; ABAT stays set then, and no request is taken.
    pub fn abort_all(&mut self, mut deadline: impl Deadline) -> Result<(), TimedOut> {
        let inner = &mut self.inner;
        for number in numbers(inner.layout.transmit & !inner.replies) {
            inner.settle(number);
            let track = &mut inner.tracks[usize::from(number)];
            track.cancelling = track.waiting > 0;
        }
        let mode = inner.regs.con_h().read().reqop();
        let control = inner.con_h.with_reqop(mode);
        inner.regs.con_h().write(control.with_abat(true));
        wait(&mut deadline, || inner.pending() == 0)?;
        inner.regs.con_h().write(control);
        wait(&mut deadline, || !inner.regs.con_h().read().abat())?;
        for number in numbers(inner.layout.transmit & !inner.replies) {
            inner.settle(number);
        }
        Ok(())
    }

    /// Changes how often the FIFO, or the queue for 0, repeats failed transmissions (6.9); it counts if the configuration
    /// restricts attempts. False if there is no such FIFO.
    pub fn set_attempts(&mut self, fifo: u8, attempts: Attempts) -> bool {
        let exists = transmits(self.inner.layout.transmit, fifo);
        let regs = &self.inner.regs;
        match fifo {
            _ if !exists => {}
            0 => regs.txqcon_h().modify(|size| size.with_txat(attempts.code())),
            _ => regs.fifo(usize::from(fifo)).con_h().modify(|size| size.with_txat(attempts.code())),
        }
        exists
    }

    /// Puts another message, or the same again, into a FIFO that answers remote frames (6.11).
    ///
    /// # Errors
    /// [`SendError::NoSuchBuffer`] if the FIFO is not for replies, [`SendError::Pending`] if it is being sent, or another
    /// [`SendError`].
    pub fn set_reply(&mut self, fifo: u8, frame: &Frame) -> Result<(), SendError> {
        let inner = &mut self.inner;
        if !transmits(inner.replies, fifo) {
            return Err(SendError::NoSuchBuffer { buffer: fifo, count: inner.replies.count_ones() as u8 });
        }
        inner.carries(fifo, frame)?;
        if inner.state(fifo).requested {
            return Err(SendError::Pending { buffer: fifo });
        }
        inner.reset(fifo);
        for index in 0..inner.layout.objects[usize::from(fifo) % 32].count {
            inner.write_object(fifo, index, frame, TxOptions::default());
        }
        inner.arm(fifo);
        Ok(())
    }

    /// Arms the replies that have been sent once more (6.11); returns which, by FIFO number. A remote frame that finds its
    /// FIFO empty is an overflow of that FIFO.
    pub fn arm_replies(&mut self) -> u32 {
        let inner = &mut self.inner;
        numbers(inner.replies).filter(|number| inner.arm(*number)).fold(0, |mask, number| mask | 1 << number)
    }
}
