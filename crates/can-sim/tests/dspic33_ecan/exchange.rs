//! Two modules on one bus, 10,000 random frames each way, filtered, and drained through the register crate.

use std::collections::VecDeque;

use crate::bench::{Can, Filter, add, exactly, extended, frame, peer, received, standard};
use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use can_sim::Sim;
use dspic33_ecan_pac::{
    enums::{FilterTarget, MaskSource, OperationMode, TxPriority},
    registers::Intf,
};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

const FRAMES: usize = 10_000;

/// One buffer of each control register, so that no write for one can meet a change of another. The order of equal
/// priorities is that of the buffers, so a stream uses one buffer: standard messages buffer 0, extended ones buffer 2.
const STREAMS: [usize; 2] = [0, 2];

/// The FIFO for standard identifiers below 0x400 and for extended ones with bit 0 clear; buffers 8 and 9, by two filters,
/// for standard ones from 0x400 to 0x5FF. The rest is rejected.
fn set_filters(sim: &Sim, can: Can) {
    let fifo = FilterTarget::Fifo;
    let low = Filter { mask_bits: 0x400, target: fifo, ..exactly(0, MaskSource::Mask0, standard(0), 0) };
    let even = Filter { mask_bits: 1, target: fifo, ..exactly(1, MaskSource::Mask1, extended(0), 0) };
    let middle = Filter { mask_bits: 0x600, ..exactly(2, MaskSource::Mask2, standard(0x400), 8) };
    let spare = Filter { number: 3, target: FilterTarget::Buffer(9), ..middle };
    for filter in [low, even, middle, spare] {
        can.add_filter(sim, filter);
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Place {
    Fifo,
    Buffers,
    Nowhere,
}

fn destination(frame: &Frame) -> Place {
    match frame.id() {
        Id::Standard(id) => match id.as_raw() {
            0..=0x3FF => Place::Fifo,
            0x400..=0x5FF => Place::Buffers,
            _ => Place::Nowhere,
        },
        Id::Extended(id) if id.as_raw() & 1 == 0 => Place::Fifo,
        Id::Extended(_) => Place::Nowhere,
    }
}

/// The two sides never use the same identifier, as the protocol asks: bit 1 tells the sender.
fn random_frame(random: &mut ChaCha8Rng, sender: u32, extended: bool) -> Frame {
    let bits = random.next_u32();
    let id = if extended {
        Id::Extended(ExtendedId::new(bits >> 3 & 0x1FFF_FFFD | sender << 1).unwrap())
    } else {
        Id::Standard(StandardId::new((bits >> 3 & 0x7FD | sender << 1) as u16).unwrap())
    };
    let mut data = [0; 8];
    random.fill_bytes(&mut data);
    let code = random.next_u32();
    let format = if code >> 8 & 3 == 0 { Format::Remote } else { Format::Data };
    Frame::from_fields(id, format, Dlc::from_low_bits((code % 9) as u8), &data)
}

struct Side {
    can: Can,
    number: u32,
    sent: usize,
    random: ChaCha8Rng,
    rejected: usize,
    /// What has to arrive, by the stream of the other side.
    order: [VecDeque<Frame>; 2],
    last: [Option<Frame>; 2],
    /// Messages that arrived twice.
    twice: usize,
}

impl Side {
    fn new(can: Can, number: u32) -> Self {
        let random = ChaCha8Rng::seed_from_u64(u64::from(number));
        let order = [VecDeque::new(), VecDeque::new()];
        Self { can, number, sent: 0, random, rejected: 0, order, last: [None; 2], twice: 0 }
    }

    /// Fills each stream's buffer when it is free.
    fn fill(&mut self, sim: &Sim, other: &mut Self) {
        for (stream, buffer) in STREAMS.into_iter().enumerate() {
            let (pending, aborted, ..) = self.can.outcome(sim, buffer);
            assert!(!aborted);
            if pending || self.sent == FRAMES {
                continue;
            }
            let frame = random_frame(&mut self.random, self.number, stream == 1);
            self.can.send(sim, buffer, &frame);
            self.sent += 1;
            match destination(&frame) {
                Place::Nowhere => other.rejected += 1,
                _ => other.order[stream].push_back(frame),
            }
        }
    }

    /// Every message has to be the next one of its stream in its place. A sender that meets an error in the last bit of
    /// EOF sends again what the others have received already (CAN 2.0B): then it may be the one before.
    fn arrived(&mut self, frame: Frame, place: Place) {
        let stream = usize::from(frame.is_extended());
        let at = self.order[stream].iter().position(|expected| destination(expected) == place);
        if at.is_none_or(|at| self.order[stream][at] != frame) && self.last[stream] == Some(frame) {
            self.twice += 1;
            return;
        }
        let expected = at.and_then(|at| self.order[stream].remove(at));
        assert_eq!(Some(frame), expected, "side {}", self.number);
        self.last[stream] = Some(frame);
    }

    fn drain(&mut self, sim: &Sim) {
        while let Some(frame) = self.can.take_from_fifo(sim) {
            self.arrived(frame, Place::Fifo);
        }
        // The spare buffer fills while the first one is full, so the first one is older.
        for buffer in [8, 9] {
            if let Some(frame) = self.can.take(sim, buffer) {
                self.arrived(frame, Place::Buffers);
            }
        }
    }

    fn is_done(&self, sim: &Sim) -> bool {
        let idle = STREAMS.iter().all(|buffer| !self.can.outcome(sim, *buffer).0);
        self.sent == FRAMES && idle && self.order.iter().all(VecDeque::is_empty)
    }
}

/// Returns how many errors the modules have seen.
fn exchange(noise: f64) -> usize {
    let sim = Sim::new();
    let cans = ["can1", "can2"].map(|name| add(&sim, name));
    for can in cans {
        can.set_up(&sim);
        can.write_fctrl(&sim, 6 << 13 | 10);
        set_filters(&sim, can);
        for (buffer, priority) in STREAMS.into_iter().zip([TxPriority::Highest, TxPriority::Highest]) {
            can.transmit_buffer(&sim, buffer, priority);
        }
        can.enter(&sim, OperationMode::Normal);
    }
    for (seed, can) in (7..).zip(cans) {
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_noise(node, noise, seed));
    }
    let [mut a, mut b] = [Side::new(cans[0], 0), Side::new(cans[1], 1)];
    let mut errors = 0;
    while !(a.is_done(&sim) && b.is_done(&sim)) {
        a.fill(&sim, &mut b);
        b.fill(&sim, &mut a);
        a.drain(&sim);
        b.drain(&sim);
        for can in cans {
            let flags = can.take_flags(&sim);
            assert!(!flags.intersects(Intf::RBOVIF | Intf::TXBO), "{flags:?}");
            errors += usize::from(flags.ivrif());
        }
        sim.run_for(can_sim::Time::from_us(20));
    }
    assert!(a.twice + b.twice < 20 && (noise > 0.0 || a.twice + b.twice == 0));
    assert!(a.rejected + b.rejected > 1_000, "the filters reject some");
    assert_eq!(sim.diagnostics(), []);
    errors
}

#[test]
fn nothing_is_lost_or_reordered() {
    assert_eq!(exchange(0.0), 0);
}

#[test]
fn nothing_is_lost_under_bit_errors() {
    let errors = exchange(0.000_1);
    assert!(errors > 300, "{errors} errors");
}

/// The same run twice: the same bus log, the same state.
#[test]
fn a_run_is_deterministic() {
    let run = || {
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, crate::bench::everything(FilterTarget::Fifo));
        let other = peer(&sim);
        can.transmit_buffer(&sim, 0, TxPriority::Lowest).enter(&sim, OperationMode::Normal);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_noise(node, 0.002, 3));
        for n in 0..50 {
            sim.peer_send(other, frame(&format!("{n:03X}#0102")));
            can.send(&sim, 0, &frame("400#55"));
            sim.run_for(crate::bench::FRAME * 2);
            can.take_from_fifo(&sim);
        }
        (sim.bus_log(), sim.describe(can.id), received(&sim, other))
    };
    assert_eq!(run(), run());
}
