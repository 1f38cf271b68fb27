//! What the story needs to know of a controller: one small module for each.

mod m_can;

use can_hal::{Configured, timing::BitTiming};
use can_sim::Sim;
use can_wire::NodeId;
use regbus::meta;

use crate::Error;

pub use m_can::MCan;

/// Polls that a change of mode may take.
pub const MODE_POLLS: u32 = 1_000;

/// A controller of the simulation, and how its driver is set up.
pub trait Station: Copy {
    /// The HAL's type, configured.
    type Can<'a>: Configured;
    /// The description of its registers.
    const META: &'static meta::Controller;
    /// Its clock in hertz.
    const CLOCK: u32;

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
    fn configure<'a>(self, sim: &'a Sim, timing: &BitTiming) -> Result<Self::Can<'a>, Error>;

    /// Enables the interrupts for received and sent messages, errors and error states.
    fn enable_interrupts(can: &mut Running<'_, Self>);

    /// Enables or disables the interrupt for single errors, which a node that recovers from bus off may raise all the time.
    fn report_errors(can: &mut Running<'_, Self>, on: bool);
}

/// A controller in normal operation.
pub type Running<'a, S> = <<S as Station>::Can<'a> as Configured>::Running;

/// True if the controller knows FD frames.
pub fn knows_fd<'a, S: Station>() -> bool
where
    S::Can<'a>: Configured,
{
    <S::Can<'a> as Configured>::CAPABILITIES.fd
}
