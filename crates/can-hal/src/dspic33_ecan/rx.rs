//! Receiving (9.2, 9.3): buffers and FIFO.

use can_frame::Frame;
use dspic33_ecan_pac::{
    enums::{FifoBuffer, FilterTarget},
    registers as pac,
};
use regbus::Bus;

use super::{Can, Inner};
use crate::{error::Overflow, mode::OnBus};

/// A received message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RxMessage {
    /// The frame.
    pub frame: Frame,
    /// The filter that let it in.
    pub filter: u8,
    /// The buffer it was in.
    pub buffer: u8,
}

/// CxFIFO and the full flags of the FIFO (9.3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FifoStatus {
    /// The buffer that the next message goes to (FBP).
    pub write: u8,
    /// The buffer that this driver reads next. FNRB, which the module keeps, is the same until messages were lost: then FBP
    /// goes on without it.
    pub read: u8,
    /// Number of messages.
    pub level: u8,
}

/// What receiving knows besides the registers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rx {
    /// First and last buffer of the FIFO.
    pub(super) fifo: (u8, u8),
    /// A filter points to the FIFO.
    fifo_used: bool,
    /// Bit per buffer that a filter points to directly.
    direct: u32,
    /// Where the oldest message of the FIFO is, or will be.
    pub(super) next: u8,
}

impl Rx {
    pub(super) const fn receives(&mut self, target: FilterTarget) {
        match target {
            FilterTarget::Buffer(buffer) => self.direct |= 1 << (buffer & 31),
            FilterTarget::Fifo => self.fifo_used = true,
        }
    }

    /// Bit per buffer of the FIFO.
    const fn fifo_mask(&self) -> u32 {
        if !self.fifo_used {
            return 0;
        }
        let (start, end) = (self.fifo.0 & 31, self.fifo.1 & 31);
        u32::MAX << start & u32::MAX >> (31 - end)
    }

    const fn used(&self) -> u32 {
        self.fifo_mask() | self.direct
    }

    /// The buffer behind another one in the FIFO.
    const fn behind(&self, buffer: u8) -> u8 {
        if buffer >= self.fifo.1 { self.fifo.0 } else { buffer + 1 }
    }

    /// The first full buffer of the FIFO from the next one on.
    const fn oldest(&self, full: u32) -> u8 {
        let from_next = full & u32::MAX << (self.next & 31);
        (if from_next != 0 { from_next } else { full }).trailing_zeros() as u8 & 31
    }
}

/// Joins the two registers of 32 flags, of which only those that hold used buffers are read.
#[inline]
fn halves(used: u32, low: impl Fn() -> u16, high: impl Fn() -> u16) -> u32 {
    let low = if used & 0xFFFF != 0 { u32::from(low()) } else { 0 };
    let high = if used >> 16 != 0 { u32::from(high()) } else { 0 };
    (low | high << 16) & used
}

impl<R: Bus, M: Bus> Inner<R, M> {
    #[inline]
    fn full(&self) -> u32 {
        let regs = &self.regs;
        halves(self.rx.used(), || regs.rxful(1).read().bits(), || regs.rxful(2).read().bits())
    }

    fn overflown(&self) -> u32 {
        let regs = &self.regs;
        halves(self.rx.used(), || regs.rxovf(1).read().bits(), || regs.rxovf(2).read().bits())
    }

    /// 9.2.5: releases a buffer with one store and no read.
    #[inline]
    fn release(&self, buffer: u8) {
        let flag = pac::Rxful::rxful_bit(usize::from(buffer & 15));
        if buffer & 16 == 0 {
            self.regs.rxful(1).clear(flag);
        } else {
            self.regs.rxful(2).clear(flag);
        }
    }

    fn clear_overflow(&self, buffers: u32) {
        let (low, high) = (buffers as u16, (buffers >> 16) as u16);
        if low != 0 {
            self.regs.rxovf(1).clear(pac::Rxovf::from_bits(low));
        }
        if high != 0 {
            self.regs.rxovf(2).clear(pac::Rxovf::from_bits(high));
        }
        self.regs.intf().clear(pac::Intf::RBOVIF);
    }

    /// Tells of lost messages, of the FIFO first.
    fn check_overflow(&self) -> Result<(), Overflow> {
        let lost = self.overflown();
        if lost == 0 {
            return Ok(());
        }
        let fifo = lost & self.rx.fifo_mask();
        if fifo != 0 {
            self.clear_overflow(fifo);
            return Err(Overflow { fifo: 0 });
        }
        let buffer = lost.trailing_zeros() as u8;
        self.clear_overflow(1 << buffer);
        Err(Overflow { fifo: buffer + 1 })
    }

    fn take(&self, buffer: u8) -> RxMessage {
        let message = self.read_element(buffer);
        self.release(buffer);
        message
    }

    /// FBP (Register 4-19).
    #[inline]
    fn write_pointer(&self) -> u8 {
        match self.regs.fifo().read().fbp() {
            Ok(FifoBuffer::Trb(buffer) | FifoBuffer::Rb(buffer)) => buffer,
            Err(_) => self.rx.next,
        }
    }

    /// 9.3.1: the oldest message of the FIFO.
    ///
    /// The manual reads the buffer that FNRB names. Once messages were lost, FBP has gone on without FNRB, and the next
    /// message is somewhere else; so an empty FIFO is taken up again where FBP stands. FBP is read before the full flags: a
    /// message that arrives between is not passed over.
    #[inline]
    fn receive_fifo(&mut self) -> Option<RxMessage> {
        let mask = self.rx.fifo_mask();
        if mask == 0 {
            return None;
        }
        let write = self.write_pointer();
        let full = self.full() & mask;
        if full == 0 {
            self.rx.next = write;
            return None;
        }
        let buffer = self.rx.oldest(full);
        let message = self.take(buffer);
        self.rx.next = self.rx.behind(buffer);
        Some(message)
    }

    /// The message in the lowest-numbered full buffer that a filter points to.
    #[inline]
    fn receive_direct(&self) -> Option<RxMessage> {
        // A buffer of the FIFO belongs to the FIFO.
        let direct = self.rx.direct & !self.rx.fifo_mask();
        if direct == 0 {
            return None;
        }
        let full = self.full() & direct;
        (full != 0).then(|| self.take(full.trailing_zeros() as u8))
    }

    #[inline]
    pub(super) fn receive(&mut self) -> Result<Option<RxMessage>, Overflow> {
        self.check_overflow()?;
        Ok(self.receive_fifo().or_else(|| self.receive_direct()))
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// The oldest message of the FIFO, or else the one in the lowest-numbered full buffer; `None` if there is none. The
    /// buffer is free for the next one afterwards (9.2.5, 9.3.1).
    ///
    /// # Errors
    /// [`Overflow`], once for the FIFO, which is number 0, and for each buffer `n`, which is number `n + 1`, that has lost
    /// messages since the last time. CxRXOVF and INTF.RBOVIF are cleared by that.
    pub fn receive_message(&mut self) -> Result<Option<RxMessage>, Overflow> {
        self.inner.receive()
    }

    /// The message in a buffer, if it is full, outside the FIFO; the buffer is free for the next one afterwards (9.2.5).
    pub fn receive_buffer(&mut self, buffer: u8) -> Option<RxMessage> {
        let inner = &self.inner;
        if buffer >= inner.layout.count() || inner.rx.fifo_mask() >> buffer & 1 == 1 {
            return None;
        }
        let full = if buffer & 16 == 0 { inner.regs.rxful(1).read() } else { inner.regs.rxful(2).read() };
        full.rxful(usize::from(buffer & 15)).then(|| inner.take(buffer))
    }

    /// Buffers that hold a message, one bit each, of those that filters point to.
    #[must_use]
    pub fn full_buffers(&self) -> u32 {
        self.inner.full()
    }

    /// The FIFO.
    #[must_use]
    pub fn fifo_status(&self) -> FifoStatus {
        let inner = &self.inner;
        let write = inner.write_pointer();
        let full = inner.full() & inner.rx.fifo_mask();
        let read = if full == 0 { write } else { inner.rx.oldest(full) };
        FifoStatus { write, read, level: full.count_ones() as u8 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_message_is_the_first_full_buffer_from_the_next_on() {
        let rx = |next| Rx { fifo: (5, 11), fifo_used: true, direct: 0, next };
        assert_eq!(rx(0).fifo_mask(), 0x0FE0);
        assert_eq!((rx(6).oldest(0x0FE0), rx(6).oldest(0x0020), rx(6).oldest(0x0880)), (6, 5, 7));
        assert_eq!((rx(0).behind(11), rx(0).behind(7)), (5, 8));
        assert_eq!(Rx { fifo: (0, 31), fifo_used: true, ..Rx::default() }.fifo_mask(), u32::MAX);
        assert_eq!(Rx { fifo: (0, 31), ..Rx::default() }.used(), 0);
    }
}
