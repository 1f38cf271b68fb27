//! Timestamps: the period of a message, measured over several wraps of a 16-bit counter.
//!
//! The counter counts bit times: at 1 Mbit/s it wraps every 65.536 ms. `TimestampExtender` follows it, as long as it sees
//! the counter or a timestamp at least once in half a period; the interrupt at the wrap is the place for that.

mod board;

use board::{MODE, Result, TIMING, or_error, standard};
use can_hal::{
    Events, InterruptSet, Receive, TimestampExtender,
    m_can::{Config, Timestamping},
};
use can_sim::{Sim, Time};
use can_wire::NodeConfig;

/// Times of messages in microseconds, from the first.
pub fn run() -> Result<Vec<u64>> {
    let sim = Sim::new();
    let sensor = sim.add_peer(NodeConfig::new())?;
    let config = Config { timestamps: Timestamping::Counter { bit_times: 1 }, ..Config::new(TIMING) };
    let mut can = or_error(board::configured(&sim, "can0", &config)?.start_normal(MODE))?;
    let mut clock = TimestampExtender::<16>::new();
    let mut times = Vec::new();
    let mut wraps = 0;

    // A message every 100 ms: more than one wrap apart.
    let start = sim.now();
    for tick in 0..4_000_u64 {
        if tick % 1_000 == 10 {
            sim.peer_send(sensor, board::data(standard(0x100), &tick.to_le_bytes())?);
        }
        sim.run_to(start + Time::from_us(100) * (tick + 1));
        // The main loop of the firmware: clear first, then serve.
        let flags = can.take_interrupts();
        if flags.events().contains(Events::TIMESTAMP_WRAP) {
            wraps += 1;
        }
        // A message may be older than the counter that was seen last; the extender places it where it belongs.
        while let Some(message) = can.fetch()? {
            times.push(clock.extend(message.timestamp.ok_or("no timestamp")?));
        }
        if tick % 100 == 0 {
            clock.extend(u32::from(can.timestamp_counter()));
        }
    }
    assert_eq!(wraps, 6, "400 ms are six periods of 65.536 ms");
    let first = times[0];
    Ok(times.into_iter().map(|time| time - first).collect())
}

fn main() -> Result<()> {
    println!("received after {:?} us", run()?);
    Ok(())
}
