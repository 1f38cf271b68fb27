//! Filters: a diagnostic tester that also follows J1939 and one fast signal.
//!
//! The first matching element of a list decides, so the order matters. What matches nothing is rejected.

mod board;

use board::{A_WHILE, MODE, Result, TIMING, extended, or_error, standard};
use can_hal::{
    Frame,
    m_can::{Action, Config, ExtendedFilter, Filter, RxFifo, StandardFilter},
};
use can_sim::Sim;
use can_wire::NodeConfig;

const STANDARD: [StandardFilter; 4] = [
    // The answers of eight control units lie side by side: a range.
    Filter::range(standard(0x7E8), standard(0x7EF), Action::Fifo0),
    // A signal of which only the latest value counts gets a buffer of its own and never fills a FIFO.
    Filter::buffer(standard(0x201), 0),
    // An alarm is stored and reported as a high priority message, wherever it stands in the FIFO.
    Filter::exact(standard(0x010), Action::PriorityFifo0),
    // A block of sixteen identifiers, by mask: the lower four bits do not count.
    Filter::mask(standard(0x300), 0x7F0, Action::Fifo1),
];

const EXTENDED: [ExtendedFilter; 2] = [
    // J1939: one chatty source address (0x55) is rejected before its parameter group would match.
    Filter::mask(extended(0x0000_0055), 0x0000_00FF, Action::Reject),
    // Parameter group 0xFEEE from any source, at any priority.
    Filter::mask(extended(0x00FE_EE00), 0x03FF_FF00, Action::Fifo1),
];

/// What was found where.
#[derive(Debug, PartialEq)]
pub struct Found {
    /// In Rx FIFO 0.
    pub fifo_0: Vec<String>,
    /// In Rx FIFO 1.
    pub fifo_1: Vec<String>,
    /// In the dedicated Rx Buffer.
    pub latest: Option<String>,
    /// The filter that has reported a high priority message.
    pub alarm_filter: u8,
}

/// What the tester has sorted out of the traffic.
pub fn run() -> Result<Found> {
    let sim = Sim::new();
    let traffic = sim.add_peer(NodeConfig::new())?;
    let can = board::configured(&sim, "can0", &Config::new(TIMING).with_filters(&STANDARD, &EXTENDED))?;
    let mut can = or_error(can.start_normal(MODE))?;
    sim.run_for(A_WHILE);

    let texts = [
        "7E7#00",
        "7E8#01",
        "7EF#02",
        "7F0#03",
        "201#AA",
        "201#BB",
        "010#FF",
        "30F#04",
        "310#05",
        "18FEEE00#06",
        "18FEEE55#07",
        "0CFEEE21#08",
        "18FEEF00#09",
    ];
    for text in texts {
        sim.peer_send(traffic, text.parse::<Frame>()?);
        sim.run_for(A_WHILE);
    }

    let text = |message: can_hal::m_can::RxMessage| message.frame.to_string();
    let alarm_filter = can.high_priority().filter;
    let mut fifos = [RxFifo::Fifo0, RxFifo::Fifo1].map(|fifo| {
        let messages = std::iter::from_fn(|| can.receive_fifo(fifo).ok().flatten());
        messages.map(text).collect::<Vec<_>>()
    });
    // The buffer is locked while its New Data flag is set: it holds the first value since it was read last. Reading it
    // at the rate at which values are used is what makes it the latest.
    let latest = can.receive_buffer(0).map(text);

    // Filter elements may change while the controller runs; here the range is no longer wanted.
    can.set_standard_filter(0, &Filter::DISABLED)?;
    sim.peer_send(traffic, "7E8#01".parse()?);
    sim.run_for(A_WHILE);
    assert_eq!(can.receive_fifo(RxFifo::Fifo0)?, None);
    let [fifo_0, fifo_1] = fifos.each_mut().map(core::mem::take);
    Ok(Found { fifo_0, fifo_1, latest, alarm_filter })
}

fn main() -> Result<()> {
    println!("{:#?}", run()?);
    Ok(())
}
