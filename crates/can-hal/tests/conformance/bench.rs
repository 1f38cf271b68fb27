//! What the suite needs to know of a controller.

use can_hal::{Capabilities, Configured, Frame, Id, Polls, Receive, Received, Transmit};
use can_sim::{PeerId, Sim, Time};
use can_wire::{NodeConfig, NodeId};

/// How a test wants the controller to be configured.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// FD frames with bit-rate switch; classic frames only otherwise. Asked for only where the controller can.
    pub fd: bool,
    /// Identifiers that are let in; empty for all.
    pub accept: &'a [Id],
    /// Only one attempt; asked for only where the controller can.
    pub one_shot: bool,
    /// Pending frames go by their identifiers; asked for only where the controller can.
    pub by_id: bool,
    /// A full Rx FIFO overwrites; asked for only where the controller can.
    pub overwrite: bool,
    /// Answers remote requests for this frame's identifier; asked for only where the controller can.
    pub reply: Option<Frame>,
}

impl Setup<'_> {
    /// Classic frames, everything accepted.
    pub const CLASSIC: Self =
        Self { fd: false, accept: &[], one_shot: false, by_id: false, overwrite: false, reply: None };
}

/// A controller on a simulation.
pub trait Bench: Copy {
    /// The HAL's type, configured.
    type Can<'a>: Configured;
    /// What the controller can do, by its manual.
    const EXPECTED: Capabilities;
    /// Messages that its Rx FIFO holds in the bench's configuration.
    const RX_DEPTH: usize;
    /// Frames that wait to be sent in the bench's configuration.
    const TX_DEPTH: usize;
    /// A frame whose cancellation came too late is told from one that was simply sent.
    const TELLS_SENT_ANYWAY: bool;
    /// The unit of timestamps; not looked at without them.
    const TIMESTAMP_UNIT: Time;
    /// Accesses that the host may need for one change of mode.
    const MODE_POLLS: u32;

    /// Adds the controller to a simulation. Its clock is 40 MHz, its bit rate 1 Mbit/s, in the data phase 5 Mbit/s.
    fn add(sim: &Sim, name: &str) -> Self;
    /// Its node.
    fn node(self, sim: &Sim) -> NodeId;
    /// Its first interrupt line is active.
    fn line(self, sim: &Sim) -> bool;
    /// Configures it.
    fn set_up<'a>(self, sim: &'a Sim, setup: &Setup<'_>) -> Self::Can<'a>;
    /// Enables the interrupts of received messages, on line 0.
    fn enable_receive_interrupt(can: &mut <Self::Can<'_> as Configured>::Running);

    /// The device around the controller goes to sleep after it, where that matters.
    fn device_sleeps(self, _sim: &Sim) {}
    /// The device around the controller runs again.
    fn device_wakes(self, _sim: &Sim) {}
}

pub type Running<'a, B> = <<B as Bench>::Can<'a> as Configured>::Running;

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

/// Longer than any frame.
pub const FRAME: Time = Time::from_us(700);

/// A peer that acknowledges what the controller sends, and sends itself.
pub fn peer(sim: &Sim) -> PeerId {
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    peer
}

/// Brings a controller on the bus.
pub fn start<'a, B: Bench>(bench: B, sim: &'a Sim, setup: &Setup<'_>) -> Running<'a, B> {
    let can = bench.set_up(sim, setup).start(Polls(B::MODE_POLLS));
    let can = can.unwrap_or_else(|_| panic!("the controller does not start: {:?}", sim.diagnostics()));
    sim.run_for(FRAME);
    can
}

/// Fetches everything there is; panics if messages were lost.
pub fn drain(can: &mut impl Receive) -> Vec<Received> {
    let mut messages = Vec::new();
    while let Some(message) = can.fetch().unwrap() {
        messages.push(message);
    }
    messages
}

/// Sends and waits until it is done.
pub fn send_and_wait<C: Transmit>(can: &mut C, frame: &Frame) -> can_hal::Outcome {
    let ticket = can.send(frame).unwrap();
    can.wait_for(ticket, Polls(10_000)).unwrap()
}

/// Frames of every kind that the controller has.
pub fn kinds(fd: bool) -> Vec<Frame> {
    let classic = ["123#", "7FF#0102030405060708", "000#AA", "1FFFFFFF#1122", "00000000#", "123#R", "0ABCDEF0#R8"];
    let flexible = ["123##0", "123##1112233", "18DAF110##1001122334455667788AABBCC", "7FF##000112233445566778899AABB"];
    let count = if fd { flexible.len() } else { 0 };
    classic.iter().chain(&flexible[..count]).map(|text| frame(text)).collect()
}
