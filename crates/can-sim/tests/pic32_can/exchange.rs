//! Two modules on one bus, 10,000 random frames each way, filtered, and drained through the register crate.

use std::collections::VecDeque;

use can_sim::{BusEntry, Sim};
use can_wire::{Field, Position, Role};
use pic32_can_pac::registers::{FifoCon, FifoInt, Int};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

use crate::bench::*;

const FRAMES: usize = 10_000;
const TX: usize = 0;

/// Standard identifiers up to 0x3FF go to FIFO1, extended ones with bit 0 clear to FIFO2, the rest is rejected.
fn destination(frame: &Frame) -> Option<usize> {
    match frame.id() {
        Id::Standard(id) => (id.as_raw() < 0x400).then_some(1),
        Id::Extended(id) => (id.as_raw() & 1 == 0).then_some(2),
    }
}

fn set_up(sim: &Sim, can: Can) {
    can.set_up(sim, 0x1000, &[Use::Tx(5), Use::Rx(6), Use::Rx(4)]);
    can.filter(sim, 4, 1, 1, standard(0), EXACT.with_sid(0x400));
    can.filter(sim, 31, 3, 2, extended(0), EXACT.with_sid(0).with_eid(1));
}

/// The two sides never use the same identifier, as the protocol asks: bit 1 tells the sender.
fn random_frame(random: &mut ChaCha8Rng, sender: u32) -> Frame {
    let bits = random.next_u32();
    let id = if bits & 1 == 0 {
        Id::Standard(StandardId::new((bits >> 3 & 0x7FD | sender << 1) as u16).unwrap())
    } else {
        Id::Extended(ExtendedId::new(bits >> 3 & 0x1FFF_FFFD | sender << 1).unwrap())
    };
    let mut data = [0; 8];
    random.fill_bytes(&mut data);
    let code = random.next_u32();
    let format = if code >> 8 & 3 == 0 { Format::Remote } else { Format::Data };
    Frame::from_fields(id, format, Dlc::from_low_bits(code as u8), &data)
}

struct Side {
    can: Can,
    number: u32,
    sent: usize,
    random: ChaCha8Rng,
    expected: [VecDeque<Frame>; 3],
    rejected: usize,
    last: [Option<Frame>; 3],
    repeated: usize,
}

impl Side {
    fn new(can: Can, number: u32) -> Self {
        let random = ChaCha8Rng::seed_from_u64(u64::from(number));
        Self { can, number, sent: 0, random, expected: Default::default(), rejected: 0, last: [None; 3], repeated: 0 }
    }

    fn fill(&mut self, sim: &Sim, other: &mut Self) {
        if self.sent == FRAMES || !self.can.fifo(sim, TX).int_().read().txnfullif() {
            return;
        }
        let frame = random_frame(&mut self.random, self.number);
        self.can.send(sim, TX, &frame);
        self.sent += 1;
        match destination(&frame) {
            Some(fifo) => other.expected[fifo].push_back(frame),
            None => other.rejected += 1,
        }
    }

    fn drain(&mut self, sim: &Sim) {
        for fifo in [1, 2] {
            while let Some(frame) = self.can.receive(sim, fifo) {
                // ISO 11898-1: a receiver takes a frame one bit before its sender does. An error in the last bit of EOF
                // makes the sender repeat what has arrived.
                if self.last[fifo] == Some(frame) && self.expected[fifo].front() != Some(&frame) {
                    self.repeated += 1;
                    continue;
                }
                self.last[fifo] = Some(frame);
                assert_eq!(Some(frame), self.expected[fifo].pop_front(), "FIFO {fifo} of side {}", self.number);
            }
            assert!(!self.can.fifo(sim, fifo).int_().read().contains(FifoInt::RXOVFLIF));
        }
    }

    fn is_done(&self, sim: &Sim) -> bool {
        let idle = self.can.fifo(sim, TX).int_().read().txemptyif();
        self.sent == FRAMES && idle && self.expected.iter().all(VecDeque::is_empty)
    }
}

/// Returns how often an error was seen.
fn exchange(noise: f64) -> usize {
    let sim = Sim::builder().log_limit(1_000_000).build();
    let cans = ["can1", "can2"].map(|name| add(&sim, name));
    for can in cans {
        set_up(&sim, can);
    }
    for can in cans {
        can.start(&sim);
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
            let flags = can.flags(&sim);
            if flags.contains(Int::IVRIF) {
                errors += 1;
                can.clear(&sim, Int::IVRIF);
            }
            assert!(!can.regs(&sim).trec().read().txbo(), "noise of this strength takes no node off the bus");
        }
    }
    assert!(a.rejected + b.rejected > 1_000, "the filters reject some");
    assert_eq!(sim.diagnostics(), []);
    for can in cans {
        assert!(!can.fifo(&sim, TX).con().read().contains(FifoCon::TXREQ));
    }
    let last_bit = Position::new(Field::Eof, 6);
    let in_last_bit = |entry: &&BusEntry| matches!(entry, BusEntry::Error { error, .. } if error.position == last_bit && error.role == Role::Transmitter);
    let explained = sim.bus_log().iter().filter(in_last_bit).count();
    assert!(a.repeated + b.repeated <= explained, "{} frames twice", a.repeated + b.repeated);
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

/// The same calls give the same events at the same times.
#[test]
fn deterministic() {
    let run = || {
        let (sim, can, peer) = bench(&[Use::Rx(4), Use::Tx(4)]);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_noise(node, 0.001, 3));
        for n in 0..40_u32 {
            can.send(&sim, 1, &frame(&format!("{:03X}#{n:02X}", 0x100 + n)));
            sim.peer_send(peer, frame(&format!("{:03X}#{n:02X}", 0x200 + n)));
            sim.run_for(FRAME * 3);
            while can.receive(&sim, 0).is_some() {}
        }
        (sim.now(), sim.bus_log(), sim.describe(can.id))
    };
    assert_eq!(run(), run());
}
