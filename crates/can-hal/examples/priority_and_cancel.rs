//! Priority and cancellation: a queue in which urgent frames overtake, and a value that is replaced before it is sent.
//!
//! In a Tx Queue the pending frame with the lowest identifier is sent first. A frame that has become stale while it waits
//! is cancelled; whether that was in time is the outcome.

mod board;

use board::{A_WHILE, MODE, Result, TIMING, data, or_error, standard};
use can_hal::{
    Outcome, Polls, Transmit,
    m_can::{Config, TxMode, TxOptions},
};
use can_sim::{Sim, Time};
use can_wire::NodeConfig;

/// What was on the bus, and what became of the two frames that were cancelled.
pub fn run() -> Result<(Vec<String>, Outcome, Outcome)> {
    let sim = Sim::new();
    let other = sim.add_peer(NodeConfig::new())?;
    let config = Config { tx_mode: TxMode::Queue, ..Config::new(TIMING) };
    let mut can = or_error(board::configured(&sim, "can0", &config)?.start_normal(MODE))?;
    sim.run_for(A_WHILE);

    // The bus is busy with another node's frame, so all of these wait.
    sim.peer_send(other, data(standard(0x001), &[0; 8])?);
    sim.run_for(Time::from_us(20));
    for number in 0..3 {
        can.send(&data(standard(0x400 + number), &[number as u8])?)?;
    }
    let stale = can.send(&data(standard(0x300), b"old")?)?;
    let urgent = can.send(&data(standard(0x010), b"stop")?)?;

    // The value has changed: the frame that has not been sent is cancelled, and a new one takes its place.
    can.cancel(stale);
    let cancelled = can.wait_for(stale, Polls(1_000))?;
    if cancelled == Outcome::Cancelled {
        can.send(&data(standard(0x300), b"new")?)?;
    }

    // The same attempt with a frame that is on the bus already: it comes too late, and says so. The queue's buffers are
    // handed out again, so this one is sent from a dedicated buffer.
    can.wait_for(urgent, Polls(10_000))?;
    let running = can.send_buffer(0, &data(standard(0x020), &[1; 8])?, TxOptions::default())?;
    sim.run_for(Time::from_us(150));
    can.cancel(running);
    let too_late = can.wait_for(running, Polls(10_000))?;

    sim.run_for(A_WHILE);
    let seen = sim.peer_received(other).into_iter().map(|(_, frame)| frame.to_string()).collect();
    Ok((seen, cancelled, too_late))
}

fn main() -> Result<()> {
    let (seen, cancelled, too_late) = run()?;
    seen.iter().for_each(|frame| println!("{frame}"));
    println!("the stale frame: {cancelled:?}, the running one: {too_late:?}");
    Ok(())
}
