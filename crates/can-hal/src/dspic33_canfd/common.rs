//! What the module has in common with the other controllers.

use can_frame::Frame;
use regbus::Bus;

use super::{Can, FdMode, Interrupts, RxMessage, Ticket, layout::numbers, tx::TxOptions};
use crate::{
    Deadline, Overflow, Refused, SendError, Status, TimedOut,
    controller::{Capabilities, Configured, Outcome, Receive, Received, Sleep, Transmit, Wake},
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Running, Sends},
    traits::{FdCan, embedded_can_traits},
};

impl<R: Bus, M: Bus> Configured for Can<Configuration, R, M> {
    type Running = Can<Running, R, M>;
    type LoopBack = Can<LoopBack, R, M>;
    type ListenOnly = Can<ListenOnly, R, M>;

    const CAPABILITIES: Capabilities = Capabilities {
        fd: true,
        one_shot: true,
        remote_reply: true,
        tx_events: true,
        timestamp_bits: 32,
        overwrite: false,
        priority_by_id: true,
        last_error: true,
        restricted: true,
        wake_on_traffic: true,
        loses_silently: false,
        recovers_by_itself: true,
    };

    fn start(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>> {
        self.start_normal(deadline)
    }

    fn start_loop_back(self, deadline: impl Deadline) -> Result<Self::LoopBack, Refused<Self>> {
        self.start_internal_loop_back(deadline)
    }

    fn start_listen_only(self, deadline: impl Deadline) -> Result<Self::ListenOnly, Refused<Self>> {
        self.start_monitoring(deadline)
    }
}

impl From<RxMessage> for Received {
    #[inline]
    fn from(message: RxMessage) -> Self {
        Self { frame: message.frame, timestamp: message.timestamp, filter: Some(message.filter) }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Receive for Can<S, R, M> {
    type Configured = Can<Configuration, R, M>;
    type Interrupts = Interrupts;

    /// The receive FIFOs from the lowest number on.
    #[inline]
    fn fetch(&mut self) -> Result<Option<Received>, Overflow> {
        for number in numbers(self.inner.layout.receive) {
            if let Some(message) = self.inner.receive(number)? {
                return Ok(Some(message.into()));
            }
        }
        Ok(None)
    }

    fn status(&mut self) -> Status {
        self.inner.status()
    }

    fn timestamp(&mut self) -> Option<u32> {
        Some(self.time_base())
    }

    fn interrupts(&mut self) -> Interrupts {
        self.inner.interrupts()
    }

    /// The flags that INTL itself holds. Those of FIFOs end with what they tell of.
    fn clear(&mut self, flags: Interrupts) {
        self.inner.regs.int_l().clear(flags.flags);
    }

    fn stop(self, deadline: impl Deadline) -> Result<Self::Configured, Refused<Self>> {
        self.into_configuration(deadline)
    }
}

impl<S: Sends, R: Bus, M: Bus> Transmit for Can<S, R, M> {
    type Ticket = Ticket;

    /// Through the queue, or where there is none through the transmit FIFO with the lowest number.
    #[inline]
    fn send(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        let number = self.inner.layout.first_transmit(self.inner.replies).ok_or(SendError::Full)?;
        self.inner.send(number, frame, TxOptions::default())
    }

    fn outcome(&mut self, ticket: Ticket) -> Outcome {
        self.inner.outcome(ticket)
    }

    /// Cancels everything in the frame's FIFO, or the queue, that is not on the bus (6.10).
    fn cancel(&mut self, ticket: Ticket) {
        self.inner.cancel(ticket.fifo());
    }

    /// 13.1: the module recovers by itself; there is nothing to start.
    fn restart(&mut self, _deadline: impl Deadline) -> Result<(), TimedOut> {
        Ok(())
    }
}

impl<R: Bus, M: Bus> Sleep for Can<Running, R, M> {
    type Asleep = Can<Asleep, R, M>;

    fn sleep(self, deadline: impl Deadline) -> Result<Self::Asleep, Refused<Self>> {
        self.power_down(deadline)
    }
}

impl<R: Bus, M: Bus> Wake for Can<Asleep, R, M> {
    type Running = Can<Running, R, M>;

    fn wake(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>> {
        self.power_up(deadline)
    }
}

embedded_can_traits!([S: Sends, R: Bus, M: Bus] Can<S, R, M>);

impl<S: Sends, R: Bus, M: Bus> FdCan for Can<S, R, M> {
    fn max_data_len(&self) -> usize {
        let number = self.inner.layout.first_transmit(self.inner.replies).unwrap_or(0);
        let room = self.inner.layout.objects[usize::from(number) % 32].data();
        match self.inner.fd {
            FdMode::Classic => can_frame::CLASSIC_MAX_LEN.min(room),
            FdMode::Fd { .. } => room,
        }
    }
}
