//! Bus off, and two ways back.
//!
//! A node whose frames fail again and again is taken off the bus by the fault confinement. M_CAN stays there until
//! software decides: at once, which is right for a node that the others need, or after a pause, which keeps a defective
//! node from disturbing them without end.

mod board;

use board::{MODE, Result, TIMING, or_error, standard};
use can_hal::{ErrorState, Outcome, Receive, RestartAfter, Transmit, m_can::Config};
use can_sim::{Sim, Time};
use can_wire::{Disturbance, NodeConfig};

/// How a recovery went.
#[derive(Debug, PartialEq)]
pub struct Recovery {
    /// Error states in the order in which they were seen.
    pub states: Vec<ErrorState>,
    /// How often the node was restarted.
    pub restarts: usize,
    /// From the first time bus off until the frame was sent, in microseconds.
    pub microseconds: u64,
}

/// The line is broken for 5 ms while a frame is to be sent.
fn recover(mut policy: RestartAfter) -> Result<Recovery> {
    let sim = Sim::new();
    sim.add_peer(NodeConfig::new())?;
    let can = board::configured(&sim, "can0", &Config::new(TIMING))?;
    let mut can = or_error(can.start_normal(MODE))?;
    sim.run_for(Time::from_us(100));

    // Nothing dominant of what the node sends reaches the bus: every attempt is a bit error.
    let node = sim.with_wire(|wire| wire.nodes().last()).ok_or("no node")?;
    sim.with_wire(|wire| wire.override_output(node, Some(Disturbance::Recessive)));
    let ticket = can.send(&board::data(standard(0x123), &[1, 2, 3])?)?;
    let repaired = sim.now() + Time::from_ms(5);

    let mut states = vec![ErrorState::Active];
    let (mut off_since, mut restarts) = (None, 0);
    loop {
        if sim.now() >= repaired {
            sim.with_wire(|wire| wire.override_output(node, None));
        }
        // One snapshot per round: reading the status registers destroys what they say.
        let status = can.status();
        if states.last() != Some(&status.error_state) {
            states.push(status.error_state);
        }
        if status.is_bus_off() {
            off_since = off_since.or(Some(sim.now()));
        }
        // The request has outlived all of it: what is pending stays pending.
        if can.outcome(ticket) == Outcome::Sent {
            let since = off_since.ok_or("it was never bus off")?;
            return Ok(Recovery { states, restarts, microseconds: sim.now().since(since).as_ns() / 1_000 });
        }
        // The policy only says when; the restart is the driver's. From then on the controller waits for 129 times 11
        // recessive bits, and `restart` does not wait for that.
        if policy.due(status.is_bus_off(), sim.now().as_ns() / 1_000) {
            can.restart(MODE)?;
            restarts += 1;
        }
        sim.run_for(Time::from_us(50));
    }
}

/// At once, and after 20 ms.
pub fn run() -> Result<[Recovery; 2]> {
    Ok([recover(RestartAfter::immediately())?, recover(RestartAfter::new(20_000))?])
}

fn main() -> Result<()> {
    let [at_once, after_pause] = run()?;
    println!("at once:     {at_once:?}");
    println!("after 20 ms: {after_pause:?}");
    Ok(())
}
