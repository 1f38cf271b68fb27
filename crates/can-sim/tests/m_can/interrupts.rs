//! Each of the 30 interrupt flags from its cause to either line: sections 2.3.16 to 2.3.19 of the manual.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, frame};
use can_sim::{PeerId, Sim, Time, m_can::RamFailure};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use m_can_pac::registers::{self as pac, Ir};
use regbus::Bus;

struct Bench {
    sim: Sim,
    can: Can,
    peer: PeerId,
}

/// One standard filter: dual identifier 0x123, with this action.
const fn filter(sfec: u32) -> u32 {
    1 << 30 | sfec << 27 | 0x123 << 16 | 0x123
}

impl Bench {
    /// `prepare` acts in configuration mode.
    fn new(setup: &Setup, prepare: impl FnOnce(&Sim, Can)) -> Self {
        let sim = Sim::new();
        let can = add(&sim, "can0");
        can.set_up(&sim, setup);
        prepare(&sim, can);
        can.start(&sim);
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        sim.run_for(FRAME);
        Self { sim, can, peer }
    }

    fn hear(&self, text: &str) {
        self.sim.peer_send(self.peer, frame(text));
        self.sim.run_for(FRAME * 3);
    }

    fn send(&self, buffer: u32) {
        self.can.write_with(&self.sim, buffer, &frame("123#11"), |t1| t1.with_efc(true));
        self.can.request(&self.sim, 1 << buffer);
        self.sim.run_for(FRAME * 3);
    }

    fn fail(&self, failure: RamFailure) {
        self.sim.act(self.can.id, |model, cx| model.fail_ram(cx, failure));
    }

    fn count(&self, tec: u16, rec: u16) {
        let node = self.sim.node(self.can.id);
        self.sim.with_wire(|wire| wire.set_error_counters(node, tec, rec));
        self.sim.run_for(Time::from_ns(1));
    }

    fn spoil_next(&self, field: Field) {
        let (node, position) = (self.sim.node(self.can.id), Position::new(field, 0));
        let frames = Frames::next();
        self.sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
    }
}

/// A bench in which the flag with this number is not set yet, and what sets it.
fn cause(bit: u32) -> (Bench, fn(&Bench)) {
    let plain = |setup: &Setup| Bench::new(setup, |_, _| {});
    let with = |offset: usize, word: u32| Bench::new(&SETUP, move |sim, can| sim.registers(can.id).write(offset, word));
    let filtered = |sfec: u32| {
        Bench::new(&Setup { sidfc: 1 << 16, ..SETUP }, move |sim, can| can.memory(sim).write(0, filter(sfec)))
    };
    let fifo0 = |word: u32| plain(&Setup { rxf0c: word | 0x040, ..SETUP });
    let fifo1 = |word: u32| plain(&Setup { rxf1c: word | 0x140, gfc: 1 << 4, ..SETUP });
    let events = |word: u32| plain(&Setup { txefc: word | 0x1480, ..SETUP });
    let hear = |b: &Bench| b.hear("123#11");
    let send = |b: &Bench| b.send(2);
    match Ir::from_bits(1 << bit) {
        Ir::RF0N => (fifo0(3 << 16), hear),
        Ir::RF0W => (fifo0(1 << 24 | 3 << 16), hear),
        Ir::RF0F => (fifo0(1 << 16), hear),
        Ir::RF0L => (fifo0(0), hear),
        Ir::RF1N => (fifo1(3 << 16), hear),
        Ir::RF1W => (fifo1(1 << 24 | 3 << 16), hear),
        Ir::RF1F => (fifo1(1 << 16), hear),
        Ir::RF1L => (fifo1(0), hear),
        Ir::HPM => (filtered(4), hear),
        Ir::TC => (with(0x0E0, 1 << 2), send),
        Ir::TCF => (with(0x0E4, 1 << 2), |b| b.can.cancel(&b.sim, 1 << 2)),
        Ir::TFE => (plain(&SETUP), send),
        Ir::TEFN => (events(8 << 16), send),
        Ir::TEFW => (events(1 << 24 | 8 << 16), send),
        Ir::TEFF => (events(1 << 16), send),
        Ir::TEFL => (events(0), send),
        Ir::TSW => (with(0x020, 1), |b| b.sim.run_for(Time::from_ms(66))),
        Ir::MRAF => (plain(&SETUP), |b| {
            b.fail(RamFailure::RxTooLate);
            b.hear("123#11");
        }),
        Ir::TOO => (with(0x028, 2_000 << 16 | 1), |b| b.sim.run_for(Time::from_us(2_000))),
        Ir::DRX => (filtered(7), |b| {
            b.sim.with_memory(b.can.ram, |memory| memory.words_mut()[0] &= !0x7FF);
            b.hear("123#11");
        }),
        Ir::BEC => (plain(&SETUP), |b| b.fail(RamFailure::Corrected)),
        Ir::BEU => (plain(&SETUP), |b| b.fail(RamFailure::Uncorrected)),
        Ir::ELO => (plain(&SETUP), |b| (1..=511).for_each(|step| b.count(step % 2 * 50, 0))),
        Ir::EP => (plain(&SETUP), |b| b.count(128, 0)),
        Ir::EW => (plain(&SETUP), |b| b.count(0, 96)),
        Ir::BO => (plain(&SETUP), |b| {
            b.count(250, 0);
            b.spoil_next(Field::Data);
            b.send(0);
        }),
        Ir::WDI => (with(0x014, 1), |b| b.fail(RamFailure::NoAnswer)),
        Ir::PEA => (plain(&SETUP), |b| {
            b.spoil_next(Field::Data);
            b.hear("123#11");
        }),
        Ir::PED => (plain(&Setup { cccr: FD, ..SETUP }), |b| {
            b.spoil_next(Field::Data);
            b.hear("123##111");
        }),
        Ir::ARA => (plain(&SETUP), |b| {
            let _zero: u8 = b.sim.registers(b.can.id).read(0x0E9);
        }),
        other => panic!("no cause known for {other:?}"),
    }
}

/// 2.3.16: the flag is set by its cause, enabled or not, and stays until a 1 is written to it; IE, ILS and ILE take it
/// to one line.
#[test]
fn section_2_3_16_every_flag_on_both_lines() {
    for bit in 0..30 {
        for line in 0..2 {
            let flag = Ir::from_bits(1 << bit);
            let (b, act) = cause(bit);
            b.can.clear(&b.sim);
            let regs = b.can.regs(&b.sim);
            assert!(!b.can.ir(&b.sim).contains(flag), "{flag:?} is not there before");
            act(&b);
            assert!(b.can.ir(&b.sim).contains(flag), "{flag:?} needs no enable");
            let lines = || [b.sim.line(b.can.id, 0), b.sim.line(b.can.id, 1)];
            regs.ile().write(pac::Ile::EINT0 | pac::Ile::EINT1);
            regs.ils().write(pac::Ils::from_bits(if line == 1 { flag.bits() } else { !flag.bits() }));
            regs.ie().write(pac::Ie::from_bits(!flag.bits()));
            regs.ir().clear(Ir::from_bits(!flag.bits()));
            assert_eq!(lines(), [false; 2], "{flag:?} is not enabled");
            regs.ie().write(pac::Ie::from_bits(flag.bits()));
            assert_eq!(lines(), [line == 0, line == 1], "{flag:?}");
            regs.ile().write(if line == 0 { pac::Ile::EINT1 } else { pac::Ile::EINT0 });
            assert_eq!(lines(), [false; 2], "{flag:?} with the other line enabled");
            regs.ile().write(pac::Ile::EINT0 | pac::Ile::EINT1);
            b.sim.registers(b.can.id).write(0x050, !flag.bits());
            assert_eq!(b.can.ir(&b.sim).bits() & flag.bits(), flag.bits(), "a written 0 has no effect");
            regs.ir().clear(flag);
            assert_eq!((b.can.ir(&b.sim) & flag, lines()), (Ir::ZERO, [false; 2]), "{flag:?}");
        }
    }
}

/// 2.3.16: EW and EP tell every change of their status, also back.
#[test]
fn section_2_3_16_status_changes_in_both_directions() {
    let (b, _) = cause(24);
    for (tec, rec, expected) in [
        (95, 95, Ir::ZERO),
        (96, 0, Ir::EW),
        (96, 96, Ir::ZERO),
        (95, 127, Ir::ZERO),
        (95, 128, Ir::EP),
        (128, 127, Ir::ZERO),
        (127, 95, Ir::EP),
        (95, 95, Ir::EW),
        (0, 128, Ir::EP | Ir::EW),
        (0, 0, Ir::EP | Ir::EW),
    ] {
        b.can.clear(&b.sim);
        b.count(tec, rec);
        assert_eq!(b.can.ir(&b.sim) & (Ir::EP | Ir::EW | Ir::BO), expected, "TEC {tec}, REC {rec}");
        let psr = b.can.regs(&b.sim).psr().read();
        assert_eq!((psr.ew(), psr.ep()), (tec.max(rec) >= 96, tec.max(rec) >= 128));
    }
}

/// 2.3.13: at 0xFF CEL sticks, and only the next increment after that sets ELO.
#[test]
fn section_2_3_13_error_logging_overflow() {
    let (b, _) = cause(22);
    (1..=509).for_each(|step| b.count(step % 2 * 50, 0));
    assert_eq!(b.can.ir(&b.sim) & Ir::ELO, Ir::ZERO, "255 increments");
    b.count(0, 0);
    b.count(50, 0);
    assert_eq!(b.can.ir(&b.sim) & Ir::ELO, Ir::ELO, "256");
    assert_eq!(b.sim.registers(b.can.id).read::<u8>(0x042), 0xFF);
    assert_eq!(b.sim.registers(b.can.id).read::<u8>(0x042), 0, "read by its own byte");
}
