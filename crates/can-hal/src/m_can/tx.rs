//! Transmission (3.5): dedicated Tx Buffers, Tx FIFO, Tx Queue, cancellation.

use can_frame::Frame;
use m_can_pac::{
    enums::{CccrUtsu, CccrWmm, DataLengthCode, FrameFormat, FrameKind, TxBufferT0Esi, TxbcTfqm},
    messages::{TxBuffer, TxBufferT0, TxBufferT1},
    registers as pac,
};
use regbus::{Bus, Payload};

use super::{Can, Inner, SETTLE, element::encode_id};
use crate::{SendError, controller::Outcome, mode::Sends};

/// What is sent, or recorded, beside the frame (2.4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct TxOptions {
    /// A Tx event with this message marker is stored when the frame is sent. More than 8 bits need
    /// [`wide_markers`](super::Config::wide_markers) or a Timestamping Unit.
    pub marker: Option<u16>,
    /// A Timestamping Unit takes the time of the frame.
    pub sync: bool,
}

impl TxOptions {
    /// With a Tx event.
    #[must_use]
    pub const fn marked(marker: u16) -> Self {
        Self { marker: Some(marker), sync: false }
    }
}

/// A Tx Buffer with a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticket(u8);

impl Ticket {
    /// Number of the Tx Buffer, from the first dedicated one.
    #[must_use]
    pub const fn buffer(self) -> u8 {
        self.0
    }

    const fn bit(self) -> u32 {
        1 << (self.0 % 32)
    }
}

/// TXFQS (2.3.36).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TxQueueStatus {
    /// No element is free.
    pub full: bool,
    /// The buffer to be written next; not valid if full.
    pub put: u8,
    /// The oldest pending buffer of a Tx FIFO; 0 for a Tx Queue.
    pub get: u8,
    /// Free elements of a Tx FIFO; 0 for a Tx Queue.
    pub free: u8,
}

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Whether the configuration and the elements can carry a frame.
    #[inline]
    fn carries(&self, frame: &Frame, options: TxOptions) -> Result<(), SendError> {
        let room = self.layout.tx_buffers.data();
        if frame.len() > room {
            return Err(SendError::TooLong { len: frame.len() as u8, room: room as u8 });
        }
        if frame.is_fd() && !self.cccr.fdoe() {
            return Err(SendError::FdDisabled);
        }
        if frame.bit_rate_switch() && !self.cccr.brse() {
            return Err(SendError::BitRateSwitchDisabled);
        }
        // 2.4.3
        let wide = self.cccr.wmm() == CccrWmm::Bits16 || self.cccr.utsu() == CccrUtsu::External;
        match options.marker {
            Some(marker) if marker > 0xFF && !wide => Err(SendError::MarkerTooWide { marker }),
            _ => Ok(()),
        }
    }

    /// 2.4.3: writes the element of a Tx Buffer whose request is not pending.
    #[inline]
    fn write_element(&self, buffer: u8, frame: &Frame, options: TxOptions) {
        let element = TxBuffer::new(self.ram, self.layout.tx_buffers.at(buffer));
        let (xtd, id) = encode_id(frame.id());
        let kind = if frame.is_remote() { FrameKind::Remote } else { FrameKind::Data };
        let esi = if frame.error_state_indicator() { TxBufferT0Esi::Recessive } else { TxBufferT0Esi::ByErrorState };
        element.t0().write(TxBufferT0::ZERO.with_esi(esi).with_xtd(xtd).with_rtr(kind).with_id(id));
        let format = if frame.is_fd() { FrameFormat::Fd } else { FrameFormat::Classic };
        let [low, high] = options.marker.unwrap_or(0).to_le_bytes();
        let t1 = TxBufferT1::ZERO
            .with_mm(low)
            .with_mm_high(high)
            .with_efc(options.marker.is_some())
            .with_tsce(options.sync)
            .with_fdf(format)
            .with_brs(frame.bit_rate_switch())
            .with_dlc(DataLengthCode::from_bits(frame.dlc().code()));
        element.t1().write(t1);
        let offset = element.offset() + TxBuffer::<M>::HEADER_BYTES;
        let payload = Payload::<u32, M>::new(self.ram, offset, self.layout.tx_buffers.data());
        payload.write(frame.data_bytes(), 0);
    }

    #[inline]
    fn request(&mut self, buffers: u32) {
        self.cancelled &= !buffers;
        self.unseen |= buffers;
        self.regs.txbar().request(pac::Txbar::from_bits(buffers));
    }

    #[inline]
    fn queue_status(&self) -> TxQueueStatus {
        let s = self.regs.txfqs().read();
        TxQueueStatus { full: s.tfqf(), put: s.tfqpi(), get: s.tfgi(), free: s.tffl() }
    }

    /// 2.3.36: TXFQS follows the pending requests, which follow TXBAR after a delay or at the end of a Tx scan. While the
    /// put index is that of the last request and that request is pending, the element is not free.
    #[inline]
    fn settled_queue_status(&mut self) -> TxQueueStatus {
        let mut status = self.queue_status();
        if let Some(last) = self.put
            && status.put == last
            && !status.full
        {
            let pending = self.is_pending(Ticket(last));
            status = self.queue_status();
            // A queue gives out the lowest free buffer, which can be the same again once it is done.
            status.full |= pending && status.put == last;
        }
        status
    }

    /// 2.3.38, 2.3.39: the request is pending, or waits for the end of a Tx scan. A request that was never seen pending may
    /// not have arrived in the other clock domain (2.2): it is looked for a few times more.
    fn is_pending(&mut self, ticket: Ticket) -> bool {
        let bit = ticket.bit();
        let mut left = if self.unseen & bit != 0 { SETTLE } else { 0 };
        self.unseen &= !bit;
        loop {
            if (self.regs.txbar().read().bits() | self.regs.txbrp().read().bits()) & bit != 0 {
                return true;
            }
            if left == 0 {
                return false;
            }
            left -= 1;
        }
    }

    /// 3.5.3, 3.5.4
    #[inline]
    pub(super) fn send_queued(&mut self, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        self.carries(frame, options)?;
        let status = self.settled_queue_status();
        if status.full {
            return Err(SendError::Full);
        }
        self.write_element(status.put, frame, options);
        let ticket = Ticket(status.put);
        self.request(ticket.bit());
        self.put = Some(status.put);
        Ok(ticket)
    }

    /// 3.5.2
    #[inline]
    pub(super) fn send_dedicated(
        &mut self,
        buffer: u8,
        frame: &Frame,
        options: TxOptions,
    ) -> Result<Ticket, SendError> {
        let count = self.layout.dedicated;
        if buffer >= count {
            return Err(SendError::NoSuchBuffer { buffer, count });
        }
        self.carries(frame, options)?;
        let ticket = Ticket(buffer);
        if self.is_pending(ticket) {
            return Err(SendError::Pending { buffer });
        }
        self.write_element(buffer, frame, options);
        self.request(ticket.bit());
        Ok(ticket)
    }

    /// The first dedicated buffer without request.
    pub(super) fn free_dedicated(&mut self) -> Option<u8> {
        (0..self.layout.dedicated).find(|buffer| !self.is_pending(Ticket(*buffer)))
    }

    /// 2.3.38, 2.3.41, 2.3.42, 3.1.7
    pub(super) fn outcome(&mut self, ticket: Ticket) -> Outcome {
        let bit = ticket.bit();
        if self.is_pending(ticket) {
            return Outcome::Pending;
        }
        let sent = self.regs.txbto().read().bits() & bit != 0;
        let given_up = self.regs.txbcf().read().bits() & bit != 0;
        match (sent, given_up) {
            (true, false) => Outcome::Sent,
            (true, true) => Outcome::SentAnyway,
            (false, true) if self.cancelled & bit != 0 => Outcome::Cancelled,
            (false, true) => Outcome::Failed,
            // Nothing was requested since the start.
            (false, false) => Outcome::Pending,
        }
    }

    /// 3.5.6
    pub(super) fn cancel(&mut self, buffers: u32) {
        self.cancelled |= buffers;
        self.regs.txbcr().request(pac::Txbcr::from_bits(buffers));
    }
}

impl<S: Sends, R: Bus, M: Bus> Can<S, R, M> {
    /// Sends a frame from a dedicated Tx Buffer (3.5.2). Frames with equal identifiers are sent in the order of their
    /// buffers, not of the calls.
    ///
    /// # Errors
    /// [`SendError::Pending`] if the buffer's last frame is not sent yet, or another [`SendError`].
    pub fn send_buffer(&mut self, buffer: u8, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        self.inner.send_dedicated(buffer, frame, options)
    }

    /// Sends a frame through the Tx FIFO or Tx Queue (3.5.3, 3.5.4).
    ///
    /// # Errors
    /// [`SendError::Full`] if no element is free, or if the controller has not yet taken notice of the last request; or
    /// another [`SendError`].
    pub fn send_queued(&mut self, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        self.inner.send_queued(frame, options)
    }

    /// Sends several frames through the Tx FIFO with one request (3.5.3), so that none of them is delayed by a scan for
    /// the one before. All or none are taken. Returns the ticket of the last.
    ///
    /// # Errors
    /// [`SendError::Full`] if fewer elements are free than there are frames or there are no frames, or if it is no FIFO
    /// but a queue; or another [`SendError`].
    pub fn send_all(&mut self, frames: &[Frame]) -> Result<Ticket, SendError> {
        let inner = &mut self.inner;
        for frame in frames {
            inner.carries(frame, TxOptions::default())?;
        }
        let status = inner.settled_queue_status();
        if status.full || usize::from(status.free) < frames.len() {
            return Err(SendError::Full);
        }
        let (first, count) = (inner.layout.dedicated, inner.layout.queue());
        let (mut buffer, mut requests, mut last) = (status.put, 0, None);
        for frame in frames {
            inner.write_element(buffer, frame, TxOptions::default());
            requests |= Ticket(buffer).bit();
            last = Some(buffer);
            // 3.5.3: the elements are used cyclically.
            buffer = if buffer + 1 < first + count { buffer + 1 } else { first };
        }
        let last = last.ok_or(SendError::Full)?;
        inner.request(requests);
        inner.put = Some(last);
        Ok(Ticket(last))
    }

    /// Requests the transmission of several dedicated Tx Buffers at once (3.5.2): they were written with
    /// [`Can::write_buffer`].
    pub fn request(&mut self, buffers: u32) {
        self.inner.request(buffers);
    }

    /// Writes a dedicated Tx Buffer without a request.
    ///
    /// # Errors
    /// As for [`Can::send_buffer`].
    pub fn write_buffer(&mut self, buffer: u8, frame: &Frame, options: TxOptions) -> Result<Ticket, SendError> {
        let inner = &mut self.inner;
        let count = inner.layout.dedicated;
        if buffer >= count {
            return Err(SendError::NoSuchBuffer { buffer, count });
        }
        inner.carries(frame, options)?;
        let ticket = Ticket(buffer);
        if inner.is_pending(ticket) {
            return Err(SendError::Pending { buffer });
        }
        inner.write_element(buffer, frame, options);
        Ok(ticket)
    }

    /// Requests the cancellation of pending frames, one bit for each Tx Buffer (3.5.6). Frames of a Tx FIFO are not meant
    /// to be cancelled; if it is done, the FIFO goes on with the next pending one (3.5.3).
    pub fn cancel_buffers(&mut self, buffers: u32) {
        self.inner.cancel(buffers);
    }

    /// Tx Buffers whose request is pending, one bit each (2.3.38).
    #[must_use]
    pub fn pending_buffers(&self) -> u32 {
        self.inner.regs.txbrp().read().bits()
    }

    /// The status of Tx FIFO or Tx Queue.
    #[must_use]
    pub fn tx_queue_status(&self) -> TxQueueStatus {
        self.inner.queue_status()
    }

    /// True if the Tx Buffers that are not dedicated are a Tx Queue.
    #[must_use]
    pub fn is_tx_queue(&self) -> bool {
        self.inner.regs.txbc().read().tfqm() == TxbcTfqm::Queue
    }
}
