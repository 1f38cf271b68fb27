//! Frames per second from one register crate to another through two M_CANs and the wire.
//!
//! `cargo bench -p can-sim`; one item is one frame: written to a Tx FIFO, requested, sent, filtered, stored, read from an
//! Rx FIFO and acknowledged. The bus runs at 1 Mbit/s, and at 5 Mbit/s in the data phase of the FD frames.
#![allow(clippy::unwrap_used, dead_code, reason = "the bench of the tests, of which this uses a part")]

#[path = "../tests/m_can/bench.rs"]
mod bench;

use bench::{Can, FD, SETUP, Setup, add, frame};
use can_frame::Frame;
use can_sim::{Sim, Time};
use divan::{Bencher, counter::ItemsCount};
use m_can_pac::registers::Ir;

fn main() {
    divan::main();
}

const FRAMES: u32 = 1_000;

/// Which way the wire takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Path {
    Fast,
    BitByBit,
}

const CONFIG: Setup = Setup { cccr: FD, ..SETUP };

fn bench(path: Path) -> (Sim, Can, Can) {
    let sim = Sim::new();
    sim.with_wire(|wire| wire.set_fast_path(path == Path::Fast));
    let cans = ["can0", "can1"].map(|name| add(&sim, name));
    for can in cans {
        can.set_up(&sim, &CONFIG);
    }
    for can in cans {
        can.start(&sim);
    }
    (sim, cans[0], cans[1])
}

/// The sender keeps its FIFO filled, the receiver sleeps until its interrupt line tells of a message.
fn exchange(sim: &Sim, from: Can, to: Can, frame: &Frame) {
    let regs = from.regs(sim);
    let (mut sent, mut received) = (0, 0);
    while received < FRAMES {
        while sent < FRAMES {
            let status = regs.txfqs().read();
            if status.tffl() == 0 {
                break;
            }
            from.send(sim, u32::from(status.tfqpi()), frame);
            sent += 1;
        }
        sim.run_until(Time::from_ms(1), |sim| sim.line(to.id, 0)).unwrap();
        to.regs(sim).ir().clear(Ir::RF0N);
        while let Some(got) = to.receive(sim, 0) {
            assert_eq!(got, *frame);
            received += 1;
        }
    }
}

fn run(bencher: Bencher<'_, '_>, path: Path, frame: &Frame) {
    let (sim, from, to) = bench(path);
    let regs = to.regs(&sim);
    regs.ie().write(m_can_pac::registers::Ie::from_bits(Ir::RF0N.bits()));
    regs.ile().write(m_can_pac::registers::Ile::EINT0);
    bencher.counter(ItemsCount::new(FRAMES)).bench_local(|| exchange(&sim, from, to, frame));
    assert_eq!(sim.diagnostics().len(), 0);
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn classic_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    run(bencher, path, &frame("123#0123456789ABCDEF"));
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn fd_64_bytes(bencher: Bencher<'_, '_>, path: Path) {
    let data: Vec<u8> = (0..64).collect();
    let id = bench::StandardId::new(0x123).unwrap();
    run(bencher, path, &Frame::fd(id, &data, bench::FdFlags { brs: true, esi: false }).unwrap());
}

/// Register accesses alone: a status register of a controller that is idle.
#[divan::bench]
fn register_read(bencher: Bencher<'_, '_>) {
    let (sim, can, _) = bench(Path::Fast);
    let regs = can.regs(&sim);
    bencher.counter(ItemsCount::new(1_000_u32)).bench_local(|| {
        for _ in 0..1_000 {
            divan::black_box(regs.rxf0s().read());
        }
    });
}

#[divan::bench]
fn register_write(bencher: Bencher<'_, '_>) {
    let (sim, can, _) = bench(Path::Fast);
    let regs = can.regs(&sim);
    bencher.counter(ItemsCount::new(1_000_u32)).bench_local(|| {
        for value in 0..1_000 {
            regs.ie().write(m_can_pac::registers::Ie::from_bits(value));
        }
    });
}
