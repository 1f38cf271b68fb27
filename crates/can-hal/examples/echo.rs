//! Echo: every frame comes back with its identifier raised by one.
//!
//! [`echo`] is written against the trait of the `embedded-can` crate, so it knows no controller: [`run`] lets it work on
//! each that there is.

mod board;

use board::{A_WHILE, MODE, Result, or_error, standard};
use can_hal::{Configured, Frame, Id, StandardId};
use can_sim::Sim;
use can_wire::NodeConfig;
use embedded_can::{Frame as _, nb};

/// Answers what has been received. Returns how many frames that were; never waits.
///
/// `nb::Error::WouldBlock` means "not now": nothing has arrived, or there is no room to send. Any other error is one of
/// the controller; here it ends the echo.
fn echo<C: nb::Can>(can: &mut C) -> core::result::Result<usize, C::Error> {
    let mut echoed = 0;
    loop {
        let frame = match can.receive() {
            Ok(frame) => frame,
            Err(::nb::Error::WouldBlock) => return Ok(echoed),
            Err(::nb::Error::Other(error)) => return Err(error),
        };
        let Id::Standard(id) = frame.id() else { continue };
        let Some(next) = StandardId::new(id.as_raw() + 1) else { continue };
        let Some(answer) = C::Frame::new(next, frame.data()) else { continue };
        match can.transmit(&answer) {
            // A controller may give back a frame of lower priority that had to make room; those of this HAL never do.
            Ok(_replaced) => echoed += 1,
            Err(::nb::Error::WouldBlock) => return Ok(echoed),
            Err(::nb::Error::Other(error)) => return Err(error),
        }
    }
}

/// Brings a controller on the bus, lets it echo three frames, and returns what the other node has received.
fn echo_on<C: Configured>(sim: &Sim, can: C) -> Result<Vec<Frame>>
where
    C::Running: nb::Can<Frame = Frame, Error = can_hal::Error>,
{
    let tester = sim.add_peer(NodeConfig::new())?;
    let mut can = or_error(can.start(MODE))?;
    for number in 0..3 {
        sim.peer_send(tester, board::data(standard(0x100 + 0x10 * number), &[number as u8])?);
    }
    for _ in 0..5 {
        echo(&mut can)?;
        sim.run_for(A_WHILE);
    }
    Ok(sim.peer_received(tester).into_iter().map(|(_, frame)| frame).collect())
}

/// What came back, for each controller.
pub fn run() -> Result<Vec<(&'static str, Vec<Frame>)>> {
    let mut echoed = Vec::new();
    {
        let sim = Sim::new();
        let can = board::configured(&sim, "can0", &can_hal::m_can::Config::new(board::TIMING))?;
        echoed.push(("M_CAN", echo_on(&sim, can)?));
    }
    {
        let sim = Sim::new();
        let can = board::dspic33_canfd(&sim, "can0")?;
        echoed.push(("dsPIC33 CAN FD", echo_on(&sim, can)?));
    }
    {
        let sim = Sim::new();
        let can = board::ecan(&sim, "can0")?;
        echoed.push(("ECAN", echo_on(&sim, can)?));
    }
    {
        let sim = Sim::new();
        let can = board::pic32_can(&sim, "can0")?;
        echoed.push(("PIC32MX CAN", echo_on(&sim, can)?));
    }
    Ok(echoed)
}

fn main() -> Result<()> {
    for (controller, frames) in run()? {
        println!("{controller}:");
        frames.iter().for_each(|frame| println!("  {frame}"));
    }
    Ok(())
}
