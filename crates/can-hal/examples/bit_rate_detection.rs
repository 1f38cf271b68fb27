//! Bit rate detection: finding out how fast a bus is, without disturbing it.
//!
//! In Restricted Operation Mode M_CAN sends no error flags, so a wrong guess does no harm; a right one even acknowledges
//! what it hears, so that a single other node is enough (manual, section 3.1.5). Controllers without that mode listen only,
//! and then need two other nodes.

mod board;

use board::{MODE, Result, or_error, standard};
use can_hal::{
    Polls, Receive, Transmit,
    m_can::Config,
    timing::{MCanTiming, Request},
};
use can_sim::{Sim, Time};
use can_wire::NodeConfig;

const CLOCK: u32 = 40_000_000;
/// The usual rates, the fastest first: a wrong guess that is too fast is noticed soonest.
const RATES: [u32; 5] = [1_000_000, 500_000, 250_000, 125_000, 50_000];

/// Finds the rate of a bus on which a node sends every few milliseconds.
fn detect(actual: u32) -> Result<Option<u32>> {
    let sim = Sim::new();
    let talker = sim.add_peer(NodeConfig::new().with_rate(actual)?)?;

    let mut can = board::m_can(&sim, "can0")?;
    can.configure(&Config::new(MCanTiming::solve(&Request::new(CLOCK, RATES[0])).map_err(|error| error.text())?))?;
    for rate in RATES {
        let timing = MCanTiming::solve(&Request::new(CLOCK, rate)).map_err(|error| error.text())?;
        can.set_bit_timing(&timing);
        let mut listening = or_error(can.start_restricted(MODE))?;
        for _ in 0..3 {
            sim.peer_send(talker, board::data(standard(0x123), &[0x55, 0xAA])?);
            sim.run_for(Time::from_ms(5));
        }
        if listening.fetch()?.is_some() {
            // Found: take part, without leaving the bus.
            let mut can = listening.leave_restricted();
            let ticket = can.send(&board::data(standard(0x700), b"here")?)?;
            can.wait_for(ticket, Polls(1_000_000))?;
            assert_eq!(sim.peer_received(talker).len(), 1);
            return Ok(Some(rate));
        }
        can = or_error(listening.into_configuration(MODE))?;
    }
    Ok(None)
}

/// What was found for each of the rates, and for one that is none of them.
pub fn run() -> Result<Vec<(u32, Option<u32>)>> {
    RATES.into_iter().chain([800_000]).map(|rate| Ok((rate, detect(rate)?))).collect()
}

fn main() -> Result<()> {
    for (actual, found) in run()? {
        println!("{actual} bit/s: found {found:?}");
    }
    Ok(())
}
