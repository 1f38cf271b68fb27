//! Two modules on one bus, 10,000 random frames each way, filtered, and drained through the register crate.

use std::collections::VecDeque;

use crate::bench::{Can, ExtendedId, FdFlags, Format, Id, StandardId, TxFifo, add};
use can_frame::{Dlc, Frame};
use can_sim::Sim;
use dspic33_canfd_pac::{enums::PayloadSize, registers as pac};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

const FRAMES: usize = 10_000;
const MIDE: u32 = 1 << 30;

fn set_up(sim: &Sim, can: Can) {
    can.configure(sim);
    can.tx_fifo(sim, 1, TxFifo { depth: 5, size: PayloadSize::Bytes64, priority: 0 });
    can.rx_fifo(sim, 2, 8, PayloadSize::Bytes64);
    can.rx_fifo(sim, 30, 8, PayloadSize::Bytes64);
    // FIFO 2 takes standard identifiers below 0x400, FIFO 30 those below 0x600 and even extended ones.
    can.filter(sim, 0, 0, MIDE | 0x400, 2);
    can.filter(sim, 9, 0x400, MIDE | 0x600, 30);
    can.filter(sim, 31, MIDE, MIDE | 1 << 11, 30);
}

/// Which FIFO takes a frame.
fn destination(frame: &Frame) -> Option<usize> {
    match frame.id() {
        Id::Standard(id) => match id.as_raw() {
            0..=0x3FF => Some(2),
            0x400..=0x5FF => Some(30),
            _ => None,
        },
        Id::Extended(id) => (id.as_raw() & 1 == 0).then_some(30),
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
    last: [Option<Frame>; 2],
    repeated: usize,
    rejected: usize,
}

impl Side {
    fn new(can: Can, number: u32) -> Self {
        let random = ChaCha8Rng::seed_from_u64(u64::from(number));
        let expected = [VecDeque::new(), VecDeque::new()];
        Self { can, sent: 0, number, random, expected, last: [None; 2], repeated: 0, rejected: 0 }
    }

    /// Fills the FIFO; notes what the other side has to receive.
    fn fill(&mut self, sim: &Sim, other: &mut Self) {
        if self.sent == FRAMES || !self.can.status(sim, 1).tfnrfnif() {
            return;
        }
        let frame = random_frame(&mut self.random, self.number);
        let at = self.can.user_address(sim, 1) - crate::bench::BASE;
        self.can.write_object(sim, at as usize, &frame, |t2| t2);
        self.can.increment(sim, 1, true);
        self.sent += 1;
        match destination(&frame) {
            Some(fifo) => other.expected[usize::from(fifo == 30)].push_back(frame),
            None => other.rejected += 1,
        }
    }

    fn drain(&mut self, sim: &Sim) {
        for ((fifo, expected), last) in [2, 30].into_iter().zip(&mut self.expected).zip(&mut self.last) {
            while let Some(frame) = self.can.receive(sim, fifo) {
                // The sender may have been error passive, which only the recessive ESI of an FD frame tells.
                let frame = frame.with_error_state_indicator(false);
                // ISO 11898-1: an error in the last bit of EOF makes the sender repeat what the receiver has taken.
                if expected.front() != Some(&frame) && *last == Some(frame) {
                    self.repeated += 1;
                    continue;
                }
                assert_eq!(Some(frame), expected.pop_front(), "FIFO {fifo} of side {}", self.number);
                *last = Some(frame);
            }
        }
    }

    fn is_done(&self, sim: &Sim) -> bool {
        self.sent == FRAMES && self.can.pending(sim) == 0 && self.expected.iter().all(VecDeque::is_empty)
    }
}

/// Errors that a sender has seen in the last bit of EOF.
fn late_errors(sim: &Sim) -> usize {
    let late = |entry: &&can_sim::BusEntry| match entry {
        can_sim::BusEntry::Error { error, .. } => {
            error.role == can_wire::Role::Transmitter
                && error.position == can_wire::Position::new(can_wire::Field::Eof, 6)
        }
        _ => false,
    };
    sim.bus_log().iter().filter(late).count()
}

/// Returns how many errors the two modules have counted.
fn exchange(noise: f64) -> u32 {
    let sim = Sim::builder().log_limit(1_000_000).build();
    let cans = ["can0", "can1"].map(|name| add(&sim, name));
    for can in cans {
        set_up(&sim, can);
    }
    for can in cans {
        can.ask(&sim, crate::bench::Mode::NormalCanFd);
    }
    for (seed, can) in (7..).zip(cans) {
        can.wait(&sim, crate::bench::Mode::NormalCanFd);
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
            assert!(!can.flags(&sim).intersects(pac::IntL::RXOVIF | pac::IntL::SERRIF));
            assert!(!can.regs(&sim).trec_h().read().txbo(), "noise of this strength takes no node off the bus");
            let counts = can.regs(&sim).read_bdiag0().to_le_bytes();
            errors += counts.iter().map(|count| u32::from(*count)).sum::<u32>();
            can.regs(&sim).write_bdiag0(0);
        }
    }
    assert!(a.rejected + b.rejected > 1_000, "the filters reject some");
    assert!(a.repeated + b.repeated <= late_errors(&sim), "nothing comes twice without such an error");
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

/// A module and an M_CAN understand each other.
#[test]
fn with_a_controller_of_another_kind() {
    use can_sim::{Memory, m_can::MCanConfig};
    let sim = Sim::new();
    let can = add(&sim, "can0");
    set_up(&sim, can);
    let ram = sim.add_memory(Memory::new(1024));
    let other = sim.add_m_can("can1", MCanConfig::new(ram)).unwrap();
    let regs = m_can_pac::MCan::new(sim.registers(other));
    use m_can_pac::registers as m;
    regs.cccr().write(m::Cccr::INIT);
    regs.cccr().write(m::Cccr::INIT.union(m::Cccr::CCE).union(m::Cccr::FDOE).union(m::Cccr::BRSE));
    regs.nbtp().write(m::Nbtp::RESET.with_nsjw(7).with_nbrp(0).with_ntseg1(30).with_ntseg2(7));
    regs.dbtp().write(m::Dbtp::RESET.with_dsjw(1).with_dbrp(0).with_dtseg1(4).with_dtseg2(1));
    use regbus::Bus;
    let bus = sim.registers(other);
    bus.write(0x0A0, 8_u32 << 16);
    bus.write(0x0BC, 7_u32);
    regs.cccr().write(m::Cccr::FDOE.union(m::Cccr::BRSE));
    can.start(&sim);
    sim.run_for(crate::bench::FRAME);
    let message = crate::bench::fd(0x123, &[0xC3; 64]);
    can.send(&sim, 1, &message);
    sim.run_for(crate::bench::FRAME);
    assert_eq!(regs.rxf0s().read().f0fl(), 1);
    let held = sim.with_memory(ram, |ram| ram.clone());
    assert_eq!(sim.inspect(other, |model| model.rx_fifo(&held, 0))[0].frame, message);
}
