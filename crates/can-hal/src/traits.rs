//! Traits for drivers that know no controller.

use can_frame::{FdFlags, Frame, Id};

use crate::{Error, SendError};

/// CAN FD for drivers that know no controller, until `embedded-can` has a trait for it.
///
/// [`embedded_can::nb::Can`] with [`Frame`] carries FD frames already; this says what the controller takes, and builds the
/// frame.
pub trait FdCan: embedded_can::nb::Can<Frame = Frame, Error = Error> {
    /// Data bytes of the longest frame that the controller is configured for; 8 for classic frames only.
    fn max_data_len(&self) -> usize;

    /// Sends `data` in an FD frame, filled up with zeros to the next length that a data length code stands for.
    ///
    /// # Errors
    /// `WouldBlock` if there is no room now, else a [`SendError`].
    fn transmit_fd(&mut self, id: Id, data: &[u8], bit_rate_switch: bool) -> nb::Result<(), Error> {
        let flags = FdFlags { brs: bit_rate_switch, esi: false };
        match Frame::fd_padded(id, data, 0, flags) {
            Ok(frame) => self.transmit(&frame).map(|_| ()),
            Err(_) => {
                let (len, room) = (data.len().min(255) as u8, self.max_data_len() as u8);
                Err(nb::Error::Other(Error::Send(SendError::TooLong { len, room })))
            }
        }
    }
}

/// Implements `embedded_can`'s traits for a type that is [`Transmit`](crate::Transmit) and has a method
/// `blocking_polls(&self) -> u32`.
macro_rules! embedded_can_traits {
    ([$($generics:tt)*] $can:ty) => {
        /// Never replaces a frame that waits already: `transmit` returns `None` or would block.
        impl<$($generics)*> embedded_can::nb::Can for $can {
            type Frame = can_frame::Frame;
            type Error = $crate::Error;

            fn transmit(&mut self, frame: &Self::Frame) -> nb::Result<Option<Self::Frame>, Self::Error> {
                match $crate::Transmit::send(self, frame) {
                    Ok(_) => Ok(None),
                    Err($crate::SendError::Full) => Err(nb::Error::WouldBlock),
                    Err(error) => Err(nb::Error::Other($crate::Error::Send(error))),
                }
            }

            fn receive(&mut self) -> nb::Result<Self::Frame, Self::Error> {
                match $crate::Receive::fetch(self) {
                    Ok(Some(received)) => Ok(received.frame),
                    Ok(None) => Err(nb::Error::WouldBlock),
                    Err(overflow) => Err(nb::Error::Other($crate::Error::Overflow(overflow))),
                }
            }
        }

        /// Tries as often as the configuration allows, then fails with `TimedOut`.
        impl<$($generics)*> embedded_can::blocking::Can for $can {
            type Frame = can_frame::Frame;
            type Error = $crate::Error;

            fn transmit(&mut self, frame: &Self::Frame) -> Result<(), Self::Error> {
                let polls = self.blocking_polls();
                $crate::traits::block(polls, || embedded_can::nb::Can::transmit(self, frame)).map(|_| ())
            }

            fn receive(&mut self) -> Result<Self::Frame, Self::Error> {
                let polls = self.blocking_polls();
                $crate::traits::block(polls, || embedded_can::nb::Can::receive(self))
            }
        }
    };
}

/// Tries until it does not block, `polls` times more than once.
pub(crate) fn block<T>(polls: u32, mut attempt: impl FnMut() -> nb::Result<T, Error>) -> Result<T, Error> {
    let mut left = polls;
    loop {
        match attempt() {
            Ok(value) => return Ok(value),
            Err(nb::Error::Other(error)) => return Err(error),
            Err(nb::Error::WouldBlock) => left = left.checked_sub(1).ok_or(Error::TimedOut)?,
        }
    }
}

pub(crate) use embedded_can_traits;
