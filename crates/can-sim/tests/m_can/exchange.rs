//! Two M_CANs on one bus, 10,000 random frames each way, filtered, and drained through the register crate.

use std::collections::VecDeque;

use crate::bench::{Can, ExtendedId, FD, FdFlags, Format, Id, SETUP, Setup, StandardId, add, frame};
use can_frame::{Dlc, Frame};
use can_sim::Sim;
use m_can_pac::registers::Ir;
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use regbus::Bus;

const FRAMES: usize = 10_000;

/// FIFO 0 takes standard identifiers up to 0x3FF, FIFO 1 the others up to 0x5FF and extended ones with bit 0 clear; the
/// rest is rejected.
const FILTERED: Setup =
    Setup { cccr: FD, sidfc: 3 << 16, xidfc: 1 << 16 | 0x020, gfc: 0b10_1000, txbc: 5 << 24 | 0x14C0, ..SETUP };

fn set_filters(sim: &Sim, can: Can) {
    let ram = can.memory(sim);
    ram.write(0x00, 1_u32 << 27 | 0x3FF);
    ram.write(0x04, 2_u32 << 27 | 0x400 << 16 | 0x5FF);
    ram.write(0x08, 3_u32 << 27 | 0x600 << 16 | 0x7FF);
    ram.write(0x20, 2_u32 << 29);
    ram.write(0x24, 2_u32 << 30 | 1);
}

/// Which FIFO takes a frame.
fn destination(frame: &Frame) -> Option<usize> {
    match frame.id() {
        Id::Standard(id) => match id.as_raw() {
            0..=0x3FF => Some(0),
            0x400..=0x5FF => Some(1),
            _ => None,
        },
        Id::Extended(id) => (id.as_raw() & 1 == 0).then_some(1),
    }
}

/// The two sides never use the same identifier, as the protocol asks: bit 1 tells the sender.
fn random_frame(random: &mut ChaCha8Rng, sender: u32) -> Frame {
    let bits = random.next_u32();
    let id = if bits & 1 == 0 {
        Id::Standard(StandardId::new((bits >> 3 & 0x7FD | sender << 1) as u16).unwrap())
    } else {
        Id::Extended(ExtendedId::new(bits >> 3 & 0x1FFF_FFFD | sender << 1).unwrap())
    };
    let mut data = [0; 64];
    random.fill_bytes(&mut data);
    let code = random.next_u32();
    let format = match code >> 8 & 3 {
        0 => Format::Data,
        1 => Format::Remote,
        _ => Format::Fd(FdFlags { brs: code & 0x1000 != 0, esi: false }),
    };
    Frame::from_fields(id, format, Dlc::from_low_bits(code as u8), &data)
}

struct Side {
    can: Can,
    sent: usize,
    number: u32,
    random: ChaCha8Rng,
    expected: [VecDeque<Frame>; 2],
    rejected: usize,
}

impl Side {
    fn new(can: Can, number: u32) -> Self {
        let random = ChaCha8Rng::seed_from_u64(u64::from(number));
        Self { can, sent: 0, number, random, expected: [VecDeque::new(), VecDeque::new()], rejected: 0 }
    }

    /// Fills the Tx FIFO; returns what the other side has to receive.
    fn fill(&mut self, sim: &Sim, other: &mut Self) {
        let status = self.can.regs(sim).txfqs().read();
        if self.sent == FRAMES || status.tffl() == 0 {
            return;
        }
        let frame = random_frame(&mut self.random, self.number);
        self.can.send(sim, u32::from(status.tfqpi()), &frame);
        self.sent += 1;
        match destination(&frame) {
            Some(fifo) => other.expected[fifo].push_back(frame),
            None => other.rejected += 1,
        }
    }

    fn drain(&mut self, sim: &Sim) {
        for fifo in 0..2 {
            while let Some(frame) = self.can.receive(sim, fifo) {
                // The sender may have been error passive, which only the recessive ESI of an FD frame tells.
                let frame = frame.with_error_state_indicator(false);
                assert_eq!(Some(frame), self.expected[fifo].pop_front(), "FIFO {fifo} of side {}", self.number);
            }
        }
    }

    fn is_done(&self, sim: &Sim) -> bool {
        let idle = self.can.regs(sim).txbrp().read().bits() == 0;
        self.sent == FRAMES && idle && self.expected.iter().all(VecDeque::is_empty)
    }
}

/// Returns how many errors the bus has seen.
fn exchange(noise: f64) -> usize {
    let sim = Sim::new();
    let cans = ["can0", "can1"].map(|name| add(&sim, name));
    for can in cans {
        can.set_up(&sim, &FILTERED);
        set_filters(&sim, can);
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
            let flags = can.ir(&sim);
            assert!(!flags.intersects(Ir::RF0L | Ir::RF1L | Ir::MRAF), "{flags:?}");
            assert!(!flags.contains(Ir::BO), "noise of this strength takes no node off the bus");
            errors += usize::from(flags.intersects(Ir::PEA | Ir::PED));
            can.regs(&sim).ir().clear(flags);
        }
    }
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
    assert!(errors > 500, "{errors} errors");
}

/// The same frames arrive when their order is not that of a FIFO but that of their priorities: a queue with more frames
/// than it needs to be full all the time.
#[test]
fn a_queue_sends_by_priority() {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &Setup { txbc: 1 << 30 | 5 << 24 | 0x14C0, ..SETUP });
    let peer = sim.add_peer(can_wire::NodeConfig::new()).unwrap();
    sim.run_for(crate::bench::FRAME);
    for (buffer, text) in ["300#00", "100#01", "7FF#02", "00000100#03", "0FF#R"].iter().enumerate() {
        can.write(&sim, buffer as u32, &frame(text));
    }
    can.request(&sim, 0x1F);
    sim.run_for(crate::bench::FRAME * 6);
    let order: Vec<String> = sim.peer_received(peer).iter().map(|(_, frame)| frame.to_string()).collect();
    assert_eq!(order, ["00000100#03", "0FF#R", "100#01", "300#00", "7FF#02"]);
}
