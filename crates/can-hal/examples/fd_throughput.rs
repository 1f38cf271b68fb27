//! FD throughput: what 64 data bytes at 5 Mbit/s bring over 8 at 1 Mbit/s.
//!
//! Two M_CANs; one sends as fast as its Tx FIFO takes frames, the other empties its Rx FIFO. The time is that of the bus.

mod board;

use board::{MODE, Result, TIMING, or_error, standard};
use can_hal::{FdCan, Frame, Id, Receive, SendError, m_can::Config};
use can_sim::{Sim, Time};

/// Bytes to be moved.
const BYTES: usize = 64 * 100;

/// Moves [`BYTES`] bytes in frames as long as the configuration allows; returns bytes per second.
fn throughput(config: &Config<'_>) -> Result<f64> {
    let sim = Sim::new();
    let sender = board::configured(&sim, "sender", config)?;
    let receiver = board::configured(&sim, "receiver", config)?;
    // `FdCan` tells what the configuration allows: 8 bytes, or as many as the elements of the Message RAM hold.
    let mut sender = or_error(sender.start_normal(MODE))?;
    let mut receiver = or_error(receiver.start_normal(MODE))?;
    let length = sender.max_data_len();
    let source: Vec<u8> = (0..BYTES).map(|n| n as u8).collect();
    let (mut waiting, mut received) = (source.chunks(length).peekable(), Vec::new());
    let id = Id::Standard(standard(0x100));
    // Both have to see 11 recessive bits before they take part.
    sim.run_for(Time::from_us(15));
    let start = sim.now();
    while received.len() < BYTES {
        // Fill the Tx FIFO. "Full" is no failure: it is tried again in the next round.
        while let Some(chunk) = waiting.peek() {
            let taken = if length > 8 {
                sender.transmit_fd(id, chunk, true)
            } else {
                embedded_can::nb::Can::transmit(&mut sender, &Frame::data(id, chunk)?).map(|_| ())
            };
            match taken {
                Ok(()) => waiting.next(),
                Err(nb::Error::WouldBlock | nb::Error::Other(can_hal::Error::Send(SendError::Full))) => break,
                Err(nb::Error::Other(error)) => return Err(error.into()),
            };
        }
        // Empty the Rx FIFO. An overflow would be an error here: the receiver has to keep up.
        while let Some(message) = receiver.fetch()? {
            received.extend_from_slice(message.frame.data_bytes());
        }
    }
    assert_eq!(received, source, "nothing is lost or out of order");
    Ok(BYTES as f64 / sim.now().since(start).as_secs_f64())
}

/// Bytes per second: classic, FD.
pub fn run() -> Result<(f64, f64)> {
    let classic = Config::new(TIMING);
    Ok((throughput(&classic)?, throughput(&classic.with_fd())?))
}

fn main() -> Result<()> {
    let (classic, fd) = run()?;
    println!("classic, 1 Mbit/s:          {:6.1} kB/s", classic / 1e3);
    println!("FD, 1 Mbit/s and 5 Mbit/s:  {:6.1} kB/s", fd / 1e3);
    Ok(())
}
