//! A driver that does anything at any time, on a bus where anything happens: nothing panics, time goes on, a run can be
//! repeated, and working out every bit shows the host the same as the wire's fast path.
//!
//! `CAN_SIM_FUZZ_RUNS` (16) and `CAN_SIM_FUZZ_SEED` (1) steer it.

use std::{cell::RefCell, rc::Rc};

use crate::bench::{Can, ExtendedId, FD, FdFlags, Format, Id, SETUP, StandardId, add, add_with, choices};
use can_frame::{Dlc, Frame};
use can_sim::{AccessRecord, BusEntry, Diagnostic, Model, PeerId, Sim, Time, m_can::RamFailure};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Line, NodeConfig, Position};
use m_can_pac::registers as pac;
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use regbus::Bus;

/// What the host and an observer of the bus see of a run.
#[derive(PartialEq)]
struct Seen {
    accesses: Vec<AccessRecord>,
    bus: Vec<BusEntry>,
    lines: Vec<(Time, usize, bool)>,
    diagnostics: Vec<Diagnostic>,
    registers: Vec<u32>,
    memory: Vec<u32>,
    end: Time,
}

/// Acts of one run.
const ACTS: usize = 400;

struct Hostile {
    sim: Sim,
    random: RefCell<ChaCha8Rng>,
    victim: Can,
    partner: Can,
    peer: PeerId,
}

impl Hostile {
    fn new(seed: u64, fast: bool) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let sim = Sim::new();
        sim.with_wire(|wire| wire.set_fast_path(fast));
        let kind = random.next_u32();
        let victim = add_with(&sim, "victim", |mut config| {
            config.tsu_registers = (kind & 1 == 0).then_some((kind >> 1 & 7) as u8 + 1);
            config.iso_only = kind & 0x10 != 0;
            config.customer_register = (kind & 0x20 != 0).then_some(kind);
            config.with_choices(choices(|c| {
                c.command_delay = kind >> 8 & 7;
                c.tx_scan = Time::from_ns(u64::from(kind >> 12 & 3) * 1_700);
                c.watermark_repeats = kind & 0x40 != 0;
                c.per_buffer_enable_gates_flag = kind & 0x80 != 0;
                c.request_survives_ram_failure = kind & 0x1_0000 != 0;
                c.received_padding_is_zero = kind & 0x2_0000 != 0;
            }))
        });
        let partner = add(&sim, "partner").run(&sim, &crate::bench::Setup { cccr: FD, ..SETUP });
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        Self { sim, random: RefCell::new(random), victim, partner, peer }
    }

    fn next(&self) -> u32 {
        self.random.borrow_mut().next_u32()
    }

    fn below(&self, limit: u32) -> u32 {
        self.next() % limit
    }

    /// Values that drivers write by mistake, and any.
    fn value(&self) -> u32 {
        let any = self.next();
        match self.below(5) {
            0 => 0,
            1 => u32::MAX,
            2 => 1 << (any % 32),
            3 => any & 0xFF,
            _ => any,
        }
    }

    /// Mostly the controller's own addresses, sometimes behind them.
    fn offset(&self) -> usize {
        let limit = if self.below(20) == 0 { 0x300 } else { 0x100 };
        let offset = self.below(limit) as usize;
        if self.below(8) == 0 { offset } else { offset & !3 }
    }

    fn frame(&self) -> Frame {
        let bits = self.next();
        let id = match bits & 1 {
            0 => Id::Standard(StandardId::new((bits >> 3 & 0x7FF) as u16).unwrap()),
            _ => Id::Extended(ExtendedId::new(bits >> 3).unwrap()),
        };
        let format = match self.below(4) {
            0 => Format::Data,
            1 => Format::Remote,
            flags => Format::Fd(FdFlags { brs: flags == 2, esi: bits & 2 != 0 }),
        };
        let mut data = [0; 64];
        self.random.borrow_mut().fill_bytes(&mut data);
        let code = self.next() as u8;
        Frame::from_fields(id, format, Dlc::from_low_bits(code), &data)
    }

    fn write(&self) {
        let (offset, value) = (self.offset(), self.value());
        let bus = self.sim.registers(self.victim.id);
        match self.below(6) {
            0 => bus.write(offset, value as u8),
            1 => bus.write(offset, value as u16),
            _ => bus.write(offset, value),
        }
    }

    fn read(&self) {
        let (offset, width) = (self.offset(), self.below(6));
        let bus = self.sim.registers(self.victim.id);
        let _any: u32 = match width {
            0 => bus.read::<u8>(offset).into(),
            1 => bus.read::<u16>(offset).into(),
            _ => bus.read(offset),
        };
    }

    /// Words into the Message RAM, also behind its end and of the wrong width.
    fn scribble(&self) {
        let ram = self.sim.memory(self.victim.ram);
        let start = self.below(4352 + 8) as usize * 4;
        for word in 0..self.below(24) as usize {
            ram.write(start + word * 4, self.next());
        }
        if self.below(10) == 0 {
            ram.write(start + 1, 0x55_u8);
        }
    }

    /// Puts the victim to work, with a configuration that makes sense but for some words in it.
    fn employ(&self) {
        let bus = self.sim.registers(self.victim.id);
        bus.write(0x018, 1_u32);
        self.sim.run_for(Time::from_us(1));
        bus.write(0x018, 3_u32);
        let mode = match self.below(3) {
            0 => FD,
            1 => pac::Cccr::from_bits(self.next() & !0x13),
            _ => FD | pac::Cccr::DAR,
        };
        bus.write(0x018, 3 | mode.bits());
        let words = [
            (0x00C, crate::bench::DBTP.bits()),
            (0x01C, crate::bench::NBTP.bits()),
            (0x020, 1 | self.below(16) << 16),
            (0x028, self.below(300) << 16 | self.below(8)),
            (0x080, self.below(64)),
            (0x084, 8 << 16),
            (0x088, 4 << 16 | 0x20),
            (0x090, 0x1FFF_FFFF),
            (0x0A0, SETUP.rxf0c | self.below(2) << 31 | self.below(4) << 24),
            (0x0B0, SETUP.rxf1c | self.below(2) << 31 | self.below(4) << 24),
            (0x0AC, SETUP.rxbc),
            (0x0BC, SETUP.rxesc),
            (0x0C0, SETUP.txbc | self.below(2) << 30),
            (0x0C8, SETUP.txesc),
            (0x0F0, SETUP.txefc | self.below(9) << 24),
        ];
        for (offset, word) in words {
            let word = if self.below(60) == 0 { self.next() } else { word };
            bus.write(offset, word);
        }
        if self.below(6) == 0 {
            bus.write(0x010, self.next() & if self.below(4) == 0 { 0x70 } else { 0x10 });
        }
        // The filters, as random as anything: three of four go on to a FIFO.
        for word in 0..16_usize {
            self.sim.memory(self.victim.ram).write(word * 4, self.next());
        }
        bus.write(0x054, self.next());
        bus.write(0x058, self.next());
        bus.write(0x05C, 3_u32);
        bus.write(0x0E0, u32::MAX);
        bus.write(0x018, mode.bits() & !0x13);
        self.sim.run_for(Time::from_us(15));
    }

    /// Writes messages where the controller expects them, and requests some.
    fn transmit(&self) {
        for buffer in 0..5 {
            let frame = self.frame();
            let marker = self.next();
            self.victim.write_with(&self.sim, buffer, &frame, |t1| {
                t1.with_efc(marker & 1 == 0).with_tsce(marker & 2 == 0).with_mm(marker as u8)
            });
        }
        self.victim.request(&self.sim, self.next() & 0x3F);
    }

    /// Reads and acknowledges like a driver, or acknowledges nonsense.
    fn drain(&self) {
        let fifo = self.below(2) as usize;
        if self.below(8) == 0 {
            self.sim.registers(self.victim.id).write([0x0A8, 0x0B8][fifo], self.below(70));
        } else {
            let _frame = self.victim.receive(&self.sim, fifo);
        }
    }

    fn pull_pins(&self) {
        let active = self.below(3) == 0;
        let failure = [
            RamFailure::Corrected,
            RamFailure::Uncorrected,
            RamFailure::NoAnswer,
            RamFailure::RxTooLate,
            RamFailure::TxTooLate,
        ][self.below(5) as usize];
        let pin = self.below(5);
        self.sim.act(self.victim.id, |model, cx| match pin {
            0 => model.set_clock_stop_request(cx, active),
            1 => model.set_clock_ok(cx, !active),
            2 => model.acknowledge_dma(cx),
            _ => model.fail_ram(cx, failure),
        });
    }

    fn disturb(&self) {
        let node = if self.below(2) == 0 { self.sim.node(self.victim.id) } else { self.sim.peer_node(self.peer) };
        let now = self.sim.now();
        let until = now + Time::from_ns(u64::from(self.below(20_000)));
        let fields = [Field::Sof, Field::BaseId, Field::Res, Field::Data, Field::Crc, Field::AckSlot, Field::Eof];
        let position = Position::new(fields[self.below(7) as usize], self.below(4) as u16);
        let (kind, seed, tec, rec) = (self.below(6), u64::from(self.next()), self.below(256), self.below(140));
        self.sim.with_wire(|wire| match kind {
            0 => wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() }),
            1 => wire.inject(Fault::DropAck { node, frames: Frames::next() }),
            2 => wire.inject(Fault::Disturb { line: Line::Bus, how: Disturbance::Dominant, from: now, until }),
            3 => wire.inject(Fault::Cut { node, from: now, until }),
            4 => wire.set_error_counters(node, tec as u16, rec as u16),
            _ => wire.set_noise(node, if seed & 3 == 0 { 0.01 } else { 0.0 }, seed),
        });
    }

    fn act(&self) {
        match self.below(24) {
            0..4 => self.write(),
            4..7 => self.read(),
            7 => self.scribble(),
            8..10 => self.transmit(),
            10 => self.employ(),
            11 => self.pull_pins(),
            12 => self.disturb(),
            13..15 => self.drain(),
            15..18 => {
                let frame = self.frame();
                self.sim.peer_send(self.peer, frame);
            }
            18 => {
                let frame = self.frame();
                self.partner.send(&self.sim, self.sim.accesses() as u32 % 2, &frame);
            }
            19 => {
                // Waiting for what never comes ends at its limit.
                let (before, limit) = (self.sim.now(), Time::from_us(u64::from(self.below(100))));
                assert_eq!(self.sim.run_until(limit, |_| false), None);
                assert!(self.sim.now() >= before + limit);
            }
            _ => {
                let (before, span) = (self.sim.now(), Time::from_us(u64::from(self.below(200))));
                self.sim.run_for(span);
                assert!(self.sim.now() >= before + span, "time stands still");
            }
        }
    }

    fn run(self) -> Seen {
        self.sim.trace(true);
        let lines = Rc::new(RefCell::new(Vec::new()));
        for line in 0..2 {
            let (victim, lines) = (self.victim, Rc::clone(&lines));
            self.sim.on_line(victim.id, line, move |sim, level| lines.borrow_mut().push((sim.now(), line, level)));
            self.sim.on_interrupt(victim.id, line, move |sim| {
                let flags = victim.ir(sim);
                victim.regs(sim).ir().clear(flags);
            });
        }
        for _ in 0..ACTS {
            let (before, accesses) = (self.sim.now(), self.sim.accesses());
            self.act();
            // An interrupt handler's time may overlap with that of the access it interrupts.
            let spent = if self.sim.accesses() > accesses { Time::from_ns(100) } else { Time::ZERO };
            assert!(self.sim.now() >= before + spent, "accesses cost time");
        }
        assert!(!self.sim.describe(self.victim.id).is_empty());
        let memory = self.sim.with_memory(self.victim.ram, |memory| memory.clone());
        let registers = self.sim.inspect(self.victim.id, |model| {
            let _held =
                (model.rx_fifo(&memory, 0), model.rx_fifo(&memory, 1), model.tx_events(&memory), model.layout());
            model.registers().slots().map(|slot| model.registers().get(slot)).collect()
        });
        Seen {
            accesses: self.sim.trace(false),
            bus: self.sim.bus_log(),
            lines: lines.take(),
            diagnostics: self.sim.take_diagnostics(),
            registers,
            memory: memory.words().to_vec(),
            end: self.sim.now(),
        }
    }
}

/// Names the first difference.
fn assert_same(seed: u64, what: &str, a: &Seen, b: &Seen) {
    fn first<T: PartialEq + core::fmt::Debug>(name: &str, a: &[T], b: &[T]) -> Option<String> {
        let at = (0..a.len().max(b.len())).find(|at| a.get(*at) != b.get(*at))?;
        Some(format!("{name} {at}:\n{:?}\n{:?}", a.get(at), b.get(at)))
    }
    let difference = first("access", &a.accesses, &b.accesses)
        .or_else(|| first("line change", &a.lines, &b.lines))
        .or_else(|| first("bus entry", &a.bus, &b.bus))
        .or_else(|| first("diagnostic", &a.diagnostics, &b.diagnostics))
        .or_else(|| first("register", &a.registers, &b.registers))
        .or_else(|| first("memory word", &a.memory, &b.memory));
    assert_eq!(difference, None, "seed {seed}: {what}");
    assert_eq!(a.end, b.end, "seed {seed}: {what}");
}

fn setting(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

#[test]
fn a_hostile_driver_breaks_nothing() {
    let first = setting("CAN_SIM_FUZZ_SEED", 1);
    let mut frames = 0;
    for seed in first..first + setting("CAN_SIM_FUZZ_RUNS", 16) {
        let caught = std::panic::catch_unwind(|| {
            let fast = Hostile::new(seed, true).run();
            assert_same(seed, "the same run again", &fast, &Hostile::new(seed, true).run());
            assert_same(seed, "bit by bit", &fast, &Hostile::new(seed, false).run());
            fast.bus.iter().filter(|entry| matches!(entry, BusEntry::Frame { .. })).count()
        });
        frames += caught.unwrap_or_else(|_| panic!("the run with CAN_SIM_FUZZ_SEED={seed} failed"));
    }
    assert!(frames > 100, "only {frames} frames on the bus: this tries nothing");
}
