//! What M_CAN has in common with the other controllers.

use can_frame::Frame;
use regbus::Bus;

use super::{Can, Interrupts, RxFifo, RxMessage, RxTimestamp, Ticket, TxOptions};
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
        remote_reply: false,
        tx_events: true,
        timestamp_bits: 16,
        overwrite: true,
        priority_by_id: true,
        last_error: true,
        restricted: true,
        wake_on_traffic: false,
        loses_silently: false,
        recovers_by_itself: false,
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
        let timestamp = match message.timestamp {
            RxTimestamp::Counter(value) => Some(u32::from(value)),
            RxTimestamp::Unit(_) => None,
        };
        Self { frame: message.frame, timestamp, filter: message.filter }
    }
}

impl<S: OnBus, R: Bus, M: Bus> Receive for Can<S, R, M> {
    type Configured = Can<Configuration, R, M>;
    type Interrupts = Interrupts;

    /// Rx FIFO 0, Rx FIFO 1, then the dedicated Rx Buffers from the first on.
    #[inline]
    fn fetch(&mut self) -> Result<Option<Received>, Overflow> {
        for fifo in [RxFifo::Fifo0, RxFifo::Fifo1] {
            if self.inner.layout.rx_fifos[fifo.index()].count > 0
                && let Some(message) = self.inner.receive(fifo)?
            {
                return Ok(Some(message.into()));
            }
        }
        if self.inner.layout.rx_buffers.count == 0 {
            return Ok(None);
        }
        let buffer = self.new_data().trailing_zeros() as u8;
        Ok(self.receive_buffer(buffer).map(Into::into))
    }

    fn status(&mut self) -> Status {
        self.protocol_status().status
    }

    fn timestamp(&mut self) -> Option<u32> {
        Some(u32::from(self.timestamp_counter()))
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

    /// Through the Tx FIFO or Tx Queue, or where there is none through the first free dedicated Tx Buffer.
    #[inline]
    fn send(&mut self, frame: &Frame) -> Result<Ticket, SendError> {
        if self.inner.layout.queue() > 0 {
            return self.inner.send_queued(frame, TxOptions::default());
        }
        let buffer = self.inner.free_dedicated().ok_or(SendError::Full)?;
        self.inner.send_dedicated(buffer, frame, TxOptions::default())
    }

    fn outcome(&mut self, ticket: Ticket) -> Outcome {
        self.inner.outcome(ticket)
    }

    fn cancel(&mut self, ticket: Ticket) {
        self.inner.cancel(1 << (ticket.buffer() % 32));
    }

    fn restart(&mut self, deadline: impl Deadline) -> Result<(), TimedOut> {
        self.inner.leave_init_in_mode(deadline)
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
        if self.inner.cccr.fdoe() { self.tx_data_len() } else { can_frame::CLASSIC_MAX_LEN.min(self.tx_data_len()) }
    }
}
