//! Sleep and wake: the controller stops when it has nothing to do, and is woken by the processor.
//!
//! M_CAN finishes what it was told to send, waits until the bus is idle, and acknowledges; then its clocks may be
//! stopped. It does not watch the bus meanwhile: that is the task of the transceiver, whose wake-up output the processor
//! sees. The frame that wakes everybody up is lost, as the network has to know.

mod board;

use board::{A_WHILE, MODE, Result, TIMING, data, or_error, standard};
use can_hal::{Configured, Polls, Receive, Sleep, Transmit, Wake, m_can::Config};
use can_sim::Sim;
use can_wire::NodeConfig;

/// A node that sleeps between two wake-ups, on any controller. Returns what it has received.
fn live<C: Configured>(sim: &Sim, can: C) -> Result<Vec<String>> {
    let (other, third) = (sim.add_peer(NodeConfig::new())?, sim.add_peer(NodeConfig::new())?);
    let mut can = or_error(can.start(MODE))?;
    sim.run_for(A_WHILE);

    // "I am going to sleep" is still sent: sleeping waits for it. The wait has a bound, as on a disturbed bus it might
    // never end; the controller then comes back and goes on.
    can.send(&data(standard(0x6FF), b"bye")?)?;
    let asleep = or_error(can.sleep(Polls(100_000)))?;
    assert_eq!(sim.peer_received(third).len(), 1, "it was sent before");

    // Traffic while it sleeps. The first frame would be what the transceiver notices.
    sim.peer_send(other, data(standard(0x100), b"wake up")?);
    sim.run_for(A_WHILE);

    let mut can = or_error(asleep.wake(MODE))?;
    sim.run_for(A_WHILE);
    sim.peer_send(other, data(standard(0x101), b"hello")?);
    sim.run_for(A_WHILE);
    let mut received = Vec::new();
    while let Some(message) = can.fetch()? {
        received.push(message.frame.to_string());
    }
    Ok(received)
}

/// What each controller has received.
pub fn run() -> Result<Vec<(&'static str, Vec<String>)>> {
    let mut lives = Vec::new();
    {
        let sim = Sim::new();
        let can = board::configured(&sim, "can0", &Config::new(TIMING))?;
        lives.push(("M_CAN", live(&sim, can)?));
    }
    {
        let sim = Sim::new();
        let can = board::ecan(&sim, "can0")?;
        lives.push(("ECAN", live(&sim, can)?));
    }
    {
        let sim = Sim::new();
        let can = board::pic32_can(&sim, "can0")?;
        lives.push(("PIC32MX CAN", live(&sim, can)?));
    }
    Ok(lives)
}

fn main() -> Result<()> {
    for (controller, received) in run()? {
        println!("{controller}: {received:?}");
    }
    Ok(())
}
