//! Gateway: from a fast FD bus to a slow classic one, and back.
//!
//! An FD frame of up to 64 bytes does not fit a classic frame, so it is cut into parts: a byte with the number of the part
//! and, in its top bit, whether it is the last, then up to seven data bytes. The other direction goes through unchanged.
//!
//! [`Gateway`] is written against the common traits: any two controllers will do.

mod board;

use board::{MODE, Result, TIMING, or_error};
use can_hal::{Configured, Frame, Id, SendError, Transmit, m_can::Config};
use can_sim::{Sim, Time};
use can_wire::NodeConfig;

/// Data bytes in a part.
const PART: usize = 7;
const LAST: u8 = 0x80;

/// Two controllers, and what waits for the slow side.
struct Gateway<F, C> {
    fast: F,
    classic: C,
    /// The frame that is being cut, and how many of its parts are sent.
    cutting: Option<(Frame, usize)>,
    /// A classic frame that the fast side had no room for.
    back: Option<Frame>,
    /// Frames that a side has lost because the gateway came too late.
    lost: usize,
}

impl<F: Transmit, C: Transmit> Gateway<F, C> {
    const fn new(fast: F, classic: C) -> Self {
        Self { fast, classic, cutting: None, back: None, lost: 0 }
    }

    /// Part `number` of a frame as a classic frame; `None` behind the last one.
    fn part(frame: &Frame, number: usize) -> Result<Option<Frame>> {
        let data = frame.data_bytes();
        let count = data.len().div_ceil(PART).max(1);
        if number >= count {
            return Ok(None);
        }
        let last = if number + 1 == count { LAST } else { 0 };
        let mut bytes = vec![number as u8 | last];
        bytes.extend(data.iter().skip(number * PART).take(PART));
        Ok(Some(Frame::data(frame.id(), &bytes)?))
    }

    /// Moves what can be moved now; never waits. Back pressure is kept where it arises: while the slow side is full
    /// nothing more is fetched from the fast one, whose FIFO then fills.
    fn poll(&mut self) -> Result<()> {
        loop {
            if self.cutting.is_none() {
                match self.fast.fetch() {
                    Ok(message) => self.cutting = message.map(|message| (message.frame, 0)),
                    Err(_overflow) => self.lost += 1,
                }
            }
            let Some((frame, done)) = self.cutting else { break };
            let Some(part) = Self::part(&frame, done)? else {
                self.cutting = None;
                continue;
            };
            match self.classic.send(&part) {
                Ok(_) => self.cutting = Some((frame, done + 1)),
                Err(SendError::Full) => break,
                Err(error) => return Err(error.into()),
            }
        }
        loop {
            if self.back.is_none() {
                match self.classic.fetch() {
                    Ok(message) => self.back = message.map(|message| message.frame),
                    Err(_overflow) => self.lost += 1,
                }
            }
            let Some(frame) = self.back else { return Ok(()) };
            match self.fast.send(&frame) {
                Ok(_) => self.back = None,
                Err(SendError::Full) => return Ok(()),
                Err(error) => return Err(error.into()),
            }
        }
    }
}

/// The other end: puts parts together.
fn join(parts: &[Frame]) -> Vec<(Id, Vec<u8>)> {
    let (mut whole, mut data) = (Vec::new(), Vec::new());
    for part in parts {
        let [head, bytes @ ..] = part.data_bytes() else { continue };
        data.extend_from_slice(bytes);
        if head & LAST != 0 {
            whole.push((part.id(), core::mem::take(&mut data)));
        }
    }
    whole
}

/// What was sent on the fast bus, what has arrived on the classic one, and what came back.
pub struct Moved {
    /// Identifiers and data of the FD frames.
    pub sent: Vec<(Id, Vec<u8>)>,
    /// The same, put together from the parts on the classic bus.
    pub arrived: Vec<(Id, Vec<u8>)>,
    /// Frames of the classic bus, seen on the fast one.
    pub back: Vec<String>,
}

/// Runs a gateway between two buses.
fn run_with<F: Transmit, C: Transmit>(sim: &Sim, fast: can_sim::BusId, mut gateway: Gateway<F, C>) -> Result<Moved> {
    let fast_node = sim.add_peer_on(fast, NodeConfig::new())?;
    let slow_node = sim.add_peer(NodeConfig::new())?;
    sim.run_for(Time::from_us(200));

    let texts = [
        "100##1",
        "101##1AA",
        "102##111223344556677",
        "103##1112233445566778899AABBCC",
        "104#R0",
        "18DAF110##1010203040506070809101112",
    ];
    let mut frames: Vec<Frame> = texts.iter().map(|text| text.parse()).collect::<core::result::Result<_, _>>()?;
    frames.push(Frame::fd(
        board::standard(0x200),
        &core::array::from_fn::<u8, 64, _>(|n| n as u8),
        Default::default(),
    )?);
    for frame in &frames {
        sim.peer_send(fast_node, *frame);
    }
    sim.peer_send(slow_node, "300#0102030405060708".parse()?);
    for _ in 0..600 {
        gateway.poll()?;
        sim.run_for(Time::from_us(10));
    }
    assert_eq!(gateway.lost, 0, "the gateway keeps up");

    let on_slow: Vec<Frame> = sim.peer_received(slow_node).into_iter().map(|(_, frame)| frame).collect();
    Ok(Moved {
        sent: frames.iter().map(|frame| (frame.id(), frame.data_bytes().to_vec())).collect(),
        arrived: join(&on_slow),
        back: sim.peer_received(fast_node).into_iter().map(|(_, frame)| frame.to_string()).collect(),
    })
}

/// M_CAN with FD frames on one bus, PIC32MX CAN with classic frames on the other.
pub fn run() -> Result<Moved> {
    let sim = Sim::new();
    let fast_bus = sim.add_bus();
    let mut fast = board::m_can_on(&sim, fast_bus, "fast")?;
    fast.configure(&Config::new(TIMING).with_fd())?;
    let classic = board::pic32_can(&sim, "classic")?;
    let gateway = Gateway::new(or_error(fast.start_normal(MODE))?, or_error(classic.start(MODE))?);
    run_with(&sim, fast_bus, gateway)
}

fn main() -> Result<()> {
    let moved = run()?;
    for (id, data) in &moved.arrived {
        println!("{id:?}: {data:02X?}");
    }
    println!("back: {:?}", moved.back);
    Ok(())
}
