//! Files that other people's tools read, and pictures of single frames.

mod candump;
mod capture;
mod pcapng;
mod recording;
mod svg;
mod timeline;
mod vcd;

pub use candump::CandumpLog;
pub use capture::FrameCapture;
pub use pcapng::PcapNg;
pub use recording::Recording;
pub use svg::Picture;
pub use vcd::Vcd;

use can_frame::{Direction, Frame};

use crate::{Event, EventKind};

/// What a frame log writes down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tap {
    /// Every frame once, as one interface on the bus would show it: when its transmitter has succeeded.
    Bus,
    /// Every node as an interface of its own, with the frames it has received and transmitted.
    EachNode,
}

impl Tap {
    /// The interface, frame and direction that an event adds to the log.
    fn record(self, event: &Event) -> Option<(usize, Frame, Option<Direction>)> {
        match (self, event.kind) {
            (Tap::Bus, EventKind::Transmitted { frame, .. }) => Some((0, frame, None)),
            (Tap::EachNode, EventKind::Transmitted { frame, .. }) => {
                Some((event.node.index(), frame, Some(Direction::Transmitted)))
            }
            (Tap::EachNode, EventKind::Received { frame, .. }) => {
                Some((event.node.index(), frame, Some(Direction::Received)))
            }
            _ => None,
        }
    }

    /// Names of the interfaces for a wire of `nodes` nodes.
    fn interfaces(self, nodes: usize) -> Vec<String> {
        match self {
            Tap::Bus => vec![String::from("can0")],
            Tap::EachNode => (0..nodes).map(|node| format!("can{node}")).collect(),
        }
    }
}
