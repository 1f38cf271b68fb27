//! What the module has in common with the other controllers.

use can_frame::Frame;
use regbus::Bus;

use super::{Can, Interrupts, RxMessage, Ticket, fifo::Kind};
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
        fd: false,
        one_shot: false,
        remote_reply: true,
        tx_events: false,
        timestamp_bits: 16,
        overwrite: false,
        priority_by_id: false,
        last_error: false,
        restricted: false,
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
        let RxMessage { frame, filter, timestamp } = message;
        Self { frame, timestamp: timestamp.map(u32::from), filter: Some(filter) }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Receive for Can<S, R, M> {
    type Configured = Can<Configuration, R, M>;
    type Interrupts = Interrupts;

    /// The receive FIFOs in the order of their numbers, data-only FIFOs left out: there is no frame in them.
    #[inline]
    fn fetch(&mut self) -> Result<Option<Received>, Overflow> {
        for number in 0..self.inner.fifos.len() as u8 {
            if self.inner.fifos[usize::from(number)].kind == Kind::Receive
                && let Some(message) = self.inner.receive(number)?
            {
                return Ok(Some(message.into()));
            }
        }
        Ok(None)
    }

    fn status(&mut self) -> Status {
        self.error_status()
    }

    fn timestamp(&mut self) -> Option<u32> {
        self.inner.timestamps.then(|| u32::from(self.timestamp_timer()))
    }

    fn interrupts(&mut self) -> Interrupts {
        self.interrupt_flags()
    }

    fn clear(&mut self, flags: Interrupts) {
        self.clear_interrupts(flags);
    }

    fn stop(self, deadline: impl Deadline) -> Result<Self::Configured, Refused<Self>> {
        self.into_configuration(deadline)
    }
}

impl<S: Sends, R: Bus, M: Bus> Transmit for Can<S, R, M> {
    type Ticket = Ticket;

    /// Through the first transmit FIFO that does not answer remote frames.
    #[inline]
    fn send(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        self.inner.send(frame)
    }

    fn outcome(&mut self, ticket: Ticket) -> Outcome {
        self.inner.outcome(ticket)
    }

    /// The module aborts FIFOs, not frames (34.7.4): whatever waits in the frame's FIFO is cancelled with it. Frames that
    /// are to be cancelled apart go through FIFOs of their own, with [`Can::send_through`].
    fn cancel(&mut self, ticket: Ticket) {
        if self.inner.outcome(ticket) == Outcome::Pending {
            self.inner.cancel(ticket.fifo());
        }
    }

    /// Nothing to do: the module recovers by itself after 128 times 11 recessive bits, as CAN asks; the manual does not
    /// say more (34.11.2). Where a device does not, [`Receive::stop`] ends bus off.
    fn restart(&mut self, _deadline: impl Deadline) -> Result<(), TimedOut> {
        Ok(())
    }
}

impl<R: Bus, M: Bus> Sleep for Can<Running, R, M> {
    type Asleep = Can<Asleep, R, M>;

    fn sleep(self, deadline: impl Deadline) -> Result<Self::Asleep, Refused<Self>> {
        self.disable(deadline)
    }
}

impl<R: Bus, M: Bus> Wake for Can<Asleep, R, M> {
    type Running = Can<Running, R, M>;

    fn wake(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>> {
        self.enable(deadline)
    }
}

embedded_can_traits!([S: Sends, R: Bus, M: Bus] Can<S, R, M>);

impl<S: Sends, R: Bus, M: Bus> FdCan for Can<S, R, M> {
    fn max_data_len(&self) -> usize {
        can_frame::CLASSIC_MAX_LEN
    }
}
