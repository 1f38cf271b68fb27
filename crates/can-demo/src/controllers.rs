//! What the story needs to know of a controller: one small module for each.

mod dspic33_canfd;
mod m_can;

use can_hal::{Events, InterruptSet as _, Transmit, timing::BitTiming};
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
    /// Its driver on the bus: any of the HAL will do.
    type Driver<'a>: Transmit;
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

    /// Takes note of the interrupt flags and clears them.
    ///
    /// # Errors
    /// [`Error::Setup`] if the controller has lost some of what it should tell.
    fn take_events(can: &mut Self::Driver<'_>) -> Result<Events, Error> {
        Ok(take_events(can))
    }

    /// Enables or disables the interrupt for single errors, which a node that recovers from bus off may raise all the time.
    fn report_errors(can: &mut Self::Driver<'_>, on: bool);
}

/// Reads the interrupt flags and clears them.
fn take_events(can: &mut impl Transmit) -> Events {
    let flags = can.interrupts();
    can.clear(flags);
    flags.events()
}
