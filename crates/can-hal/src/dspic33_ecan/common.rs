//! What ECAN has in common with the other controllers.

use can_frame::Frame;
use regbus::Bus;

use super::{Can, Interrupts, RxMessage, Ticket};
use crate::{
    Deadline, Overflow, Refused, SendError, Status, TimedOut,
    controller::{Capabilities, Configured, Outcome, Receive, Received, Sleep, Transmit, Wake},
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Running, Sends},
    traits::embedded_can_traits,
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
        timestamp_bits: 0,
        overwrite: false,
        priority_by_id: false,
        last_error: false,
        restricted: false,
        // 13.3: while the device sleeps.
        wake_on_traffic: true,
        loses_silently: false,
        // Figure 11-1.
        recovers_by_itself: true,
    };

    fn start(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>> {
        self.start_normal(deadline)
    }

    fn start_loop_back(self, deadline: impl Deadline) -> Result<Self::LoopBack, Refused<Self>> {
        self.start_loopback(deadline)
    }

    fn start_listen_only(self, deadline: impl Deadline) -> Result<Self::ListenOnly, Refused<Self>> {
        self.start_listening(deadline)
    }
}

impl From<RxMessage> for Received {
    #[inline]
    fn from(message: RxMessage) -> Self {
        Self { frame: message.frame, timestamp: None, filter: Some(message.filter) }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Receive for Can<S, R, M> {
    type Configured = Can<Configuration, R, M>;
    type Interrupts = Interrupts;

    /// The FIFO, then the buffers that filters point to from the lowest-numbered on.
    #[inline]
    fn fetch(&mut self) -> Result<Option<Received>, Overflow> {
        Ok(self.inner.receive()?.map(Into::into))
    }

    fn status(&mut self) -> Status {
        self.module_status().status
    }

    /// The module has no counter; an input capture of the device takes the time (14.0).
    fn timestamp(&mut self) -> Option<u32> {
        None
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

    /// Through the buffers that are a queue. The module knows no order of requests; the queue gives each frame a lower rank
    /// than those that wait. When ranks have run out, it is full until all of them are sent.
    #[inline]
    fn send(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        self.inner.send_queued(frame)
    }

    fn outcome(&mut self, ticket: Ticket) -> Outcome {
        self.inner.outcome(ticket)
    }

    fn cancel(&mut self, ticket: Ticket) {
        self.inner.cancel(ticket.buffer());
    }

    /// Recovery begins by itself (Figure 11-1, `bus_off_recovery`): does nothing.
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
