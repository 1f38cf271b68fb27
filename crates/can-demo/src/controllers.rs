//! What the story needs to know of a controller: one small module for each.

mod dspic33_canfd;
mod m_can;

use can_frame::Frame;
use can_hal::{Events, InterruptSet as _, Outcome, Polls, Status, Transmit, timing::BitTiming};
use can_sim::Sim;
use can_wire::NodeId;
use regbus::meta;

use crate::Error;

pub use dspic33_canfd::DsPic33CanFd;
pub use m_can::MCan;

/// Polls that a change of mode may take.
pub const MODE_POLLS: u32 = 1_000;

/// A controller of the simulation, and how its driver is set up.
pub trait Station: Copy {
    /// Its driver before it is on the bus.
    type Configured<'a>;
    /// Its driver.
    type Driver<'a>: Driver;
    /// The description of its registers.
    const META: &'static meta::Controller;
    /// Its clock in hertz.
    const CLOCK: u32;
    /// It knows FD frames.
    const FD: bool;

    /// Adds it to a simulation, with a clock that is `ppm` parts per million fast.
    ///
    /// # Errors
    /// [`Error::Place`] if that makes no node.
    fn add(sim: &Sim, name: &str, ppm: i32) -> Result<Self, Error>;

    /// Its bit timing for the rates of the story.
    ///
    /// # Errors
    /// [`Error::Timing`] if its clock cannot make the rates.
    fn timing() -> Result<BitTiming, Error>;

    /// Its node on the bus.
    fn node(self, sim: &Sim) -> NodeId;

    /// One of its interrupt lines is active.
    fn line(self, sim: &Sim) -> bool;

    /// Configures it.
    ///
    /// # Errors
    /// [`Error::Setup`] with the driver's words.
    fn configure<'a>(self, sim: &'a Sim, timing: &BitTiming) -> Result<Self::Configured<'a>, Error>;

    /// Brings it on the bus, and enables the interrupts for received and sent messages, errors and error states.
    ///
    /// # Errors
    /// [`Error::TimedOut`] if it does not follow.
    fn start<'a>(can: Self::Configured<'a>) -> Result<Self::Driver<'a>, Error>;

    /// Enables or disables the interrupt for single errors, which a node that recovers from bus off may raise all the time.
    fn report_errors(can: &mut Self::Driver<'_>, on: bool);
}

/// What the story asks of a driver.
pub trait Driver {
    /// Stands for a frame that is to be sent.
    type Ticket: Copy;

    /// Reads the interrupt flags and clears them.
    fn take_events(&mut self) -> Events;

    /// The oldest message.
    ///
    /// # Errors
    /// [`Error::Setup`] if messages were lost.
    fn fetch(&mut self) -> Result<Option<Frame>, Error>;

    /// One look at the status registers.
    fn status(&mut self) -> Status;

    /// Gives the controller a frame.
    ///
    /// # Errors
    /// [`Error::Send`] if it takes none now.
    fn send(&mut self, frame: &Frame) -> Result<Self::Ticket, Error>;

    /// The frame is still to be sent.
    fn is_pending(&mut self, ticket: Self::Ticket) -> bool;

    /// Begins to come back from bus off.
    ///
    /// # Errors
    /// [`Error::TimedOut`] if the controller does not follow.
    fn restart(&mut self) -> Result<(), Error>;
}

/// Every driver of the HAL will do.
impl<C: Transmit> Driver for C {
    type Ticket = C::Ticket;

    fn take_events(&mut self) -> Events {
        let flags = self.interrupts();
        self.clear(flags);
        flags.events()
    }

    fn fetch(&mut self) -> Result<Option<Frame>, Error> {
        Ok(can_hal::Receive::fetch(self).map_err(Error::setup)?.map(|message| message.frame))
    }

    fn status(&mut self) -> Status {
        can_hal::Receive::status(self)
    }

    fn send(&mut self, frame: &Frame) -> Result<Self::Ticket, Error> {
        Transmit::send(self, frame).map_err(Error::Send)
    }

    fn is_pending(&mut self, ticket: Self::Ticket) -> bool {
        self.outcome(ticket) == Outcome::Pending
    }

    fn restart(&mut self) -> Result<(), Error> {
        Transmit::restart(self, Polls(MODE_POLLS)).map_err(|_| Error::TimedOut("to recover from bus off"))
    }
}
