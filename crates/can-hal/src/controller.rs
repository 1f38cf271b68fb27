//! What all controllers have in common.

use core::fmt::Debug;

use can_frame::Frame;

use crate::{Deadline, Events, Overflow, Refused, SendError, Status, TimedOut};

/// What a controller can do. What it cannot do is said here and not left to be found out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Capabilities {
    /// Sends and receives FD frames.
    pub fd: bool,
    /// Gives up after one attempt, if told so.
    pub one_shot: bool,
    /// Answers remote frames by itself.
    pub remote_reply: bool,
    /// Keeps a record about each sent message.
    pub tx_events: bool,
    /// Bits of its timestamps; 0 if received messages carry none.
    pub timestamp_bits: u8,
    /// Can let new messages overwrite the oldest.
    pub overwrite: bool,
    /// Sends pending messages in the order of their identifiers, if told so.
    pub priority_by_id: bool,
    /// [`Status::last_error`] tells what was wrong with a frame.
    pub last_error: bool,
    /// Has a restricted operation mode.
    pub restricted: bool,
    /// Traffic on the bus wakes it up, or tells that it should be.
    pub wake_on_traffic: bool,
    /// Loses received messages that find no room without a trace; else [`Receive::fetch`] tells.
    pub loses_silently: bool,
    /// Comes back from bus off without being restarted.
    pub recovers_by_itself: bool,
}

/// A message from a FIFO or buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Received {
    /// The frame.
    pub frame: Frame,
    /// When it was received, by the controller's timestamp counter.
    pub timestamp: Option<u32>,
    /// The acceptance filter that let it in; `None` if it matched none.
    pub filter: Option<u8>,
}

/// What has become of a frame that was given to [`Transmit::send`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// It is still to be sent.
    Pending,
    /// It was sent.
    Sent,
    /// Its cancellation came too late: it was sent.
    SentAnyway,
    /// It was cancelled and not sent.
    Cancelled,
    /// Its only attempt has failed: arbitration was lost, or an error has disturbed it.
    Failed,
}

/// A set of interrupt flags of one controller.
pub trait InterruptSet: Copy + Debug + PartialEq + core::ops::BitOr<Output = Self> {
    /// No flag is set.
    fn is_empty(self) -> bool;
    /// What the flags stand for.
    fn events(self) -> Events;
}

/// A controller that is in configuration mode and configured.
///
/// Every failure gives the controller back in the mode it was in.
pub trait Configured: Sized {
    /// The controller in normal operation.
    type Running: Transmit<Configured = Self> + Sleep;
    /// The controller in loop back mode.
    type LoopBack: Transmit<Configured = Self>;
    /// The controller in listen-only mode.
    type ListenOnly: Receive<Configured = Self>;
    /// What the controller can do.
    const CAPABILITIES: Capabilities;

    /// Leaves configuration mode for normal operation.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn start(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>>;

    /// Leaves configuration mode for internal loop back: nothing reaches the bus, nothing comes from it.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn start_loop_back(self, deadline: impl Deadline) -> Result<Self::LoopBack, Refused<Self>>;

    /// Leaves configuration mode for listening: receives and sends nothing, not even an acknowledgement.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn start_listen_only(self, deadline: impl Deadline) -> Result<Self::ListenOnly, Refused<Self>>;
}

/// A controller that receives.
pub trait Receive: Sized {
    /// The same controller in configuration mode.
    type Configured: Configured;
    /// Its interrupt flags.
    type Interrupts: InterruptSet;

    /// The oldest message of the first FIFO or buffer that has one; `None` if there is none.
    ///
    /// # Errors
    /// [`Overflow`], once for every time that messages were lost; its flag is cleared by that. Messages from before can
    /// be fetched afterwards.
    fn fetch(&mut self) -> Result<Option<Received>, Overflow>;

    /// One snapshot of the status registers; each of them is read once.
    fn status(&mut self) -> Status;

    /// The timestamp counter now; `None` if there is none.
    fn timestamp(&mut self) -> Option<u32>;

    /// The interrupt flags that are set, enabled or not.
    fn interrupts(&mut self) -> Self::Interrupts;

    /// Clears exactly these interrupt flags. A flag that has risen since they were read stays set, unless it is named.
    fn clear(&mut self, flags: Self::Interrupts);

    /// Goes back to configuration mode. Pending transmissions are lost, and so are received messages that were not
    /// fetched.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn stop(self, deadline: impl Deadline) -> Result<Self::Configured, Refused<Self>>;
}

/// A controller that sends and receives.
pub trait Transmit: Receive {
    /// Stands for one frame that is to be sent, until its place is used again.
    type Ticket: Copy + Debug + PartialEq;

    /// Gives a frame to the controller, to be sent after those that were given before, or by its identifier where the
    /// controller is configured so.
    ///
    /// # Errors
    /// A [`SendError`]; [`SendError::Full`] if there is no room now.
    fn send(&mut self, frame: &Frame) -> Result<Self::Ticket, SendError>;

    /// What has become of a frame.
    fn outcome(&mut self, ticket: Self::Ticket) -> Outcome;

    /// Requests that a frame is not sent. [`Transmit::outcome`] tells what came of it.
    fn cancel(&mut self, ticket: Self::Ticket);

    /// Begins to come back from bus off; needed where the controller does not by itself. Returns when the recovery has
    /// begun; [`Receive::status`] tells when it is over.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn restart(&mut self, deadline: impl Deadline) -> Result<(), TimedOut>;

    /// Waits until a frame is no longer pending.
    ///
    /// # Errors
    /// [`TimedOut`] if it is at the bound.
    fn wait_for(&mut self, ticket: Self::Ticket, mut deadline: impl Deadline) -> Result<Outcome, TimedOut> {
        let mut outcome = Outcome::Pending;
        crate::deadline::wait(&mut deadline, || {
            outcome = self.outcome(ticket);
            outcome != Outcome::Pending
        })?;
        Ok(outcome)
    }
}

/// A controller that can be stopped to save power.
pub trait Sleep: Sized {
    /// The same controller asleep.
    type Asleep: Wake<Running = Self>;

    /// Stops the controller when what it is sending is sent and the bus is idle.
    ///
    /// # Errors
    /// [`TimedOut`] if that does not happen; the controller then goes on.
    fn sleep(self, deadline: impl Deadline) -> Result<Self::Asleep, Refused<Self>>;
}

/// A controller that sleeps.
pub trait Wake: Sized {
    /// The same controller awake.
    type Running;

    /// Goes back to normal operation.
    ///
    /// # Errors
    /// [`TimedOut`] if the controller does not follow.
    fn wake(self, deadline: impl Deadline) -> Result<Self::Running, Refused<Self>>;
}
