//! Frames per second from one register crate to another through two PIC32MX CAN modules and the wire.
//!
//! `cargo bench -p can-sim --bench pic32_can`; one item is one frame: written to the buffer that CiFIFOUA gives, requested,
//! sent, filtered, stored, read and taken from its FIFO. The bus runs at 1 Mbit/s.
#![allow(clippy::unwrap_used, dead_code, reason = "the bench of the tests, of which this uses a part")]

#[path = "../tests/pic32_can/bench.rs"]
mod bench;

use bench::{Can, Frame, Use, add, frame};
use can_sim::{Sim, Time};
use divan::{Bencher, counter::ItemsCount};
use pic32_can_pac::registers::{FifoInt, Int};

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

fn bench(path: Path) -> (Sim, Can, Can) {
    let sim = Sim::new();
    sim.with_wire(|wire| wire.set_fast_path(path == Path::Fast));
    let cans = ["can1", "can2"].map(|name| add(&sim, name));
    for can in cans {
        can.set_up(&sim, 0x100, &[Use::Tx(4), Use::Rx(4)]);
        can.accept_all(&sim, 1);
    }
    for can in cans {
        can.start(&sim);
    }
    (sim, cans[0], cans[1])
}

/// The sender keeps its FIFO filled, the receiver sleeps until its interrupt line tells of a message.
fn exchange(sim: &Sim, from: Can, to: Can, frame: &Frame) {
    let (mut sent, mut received) = (0, 0);
    while received < FRAMES {
        while sent < FRAMES && from.fifo(sim, 0).int_().read().txnfullif() {
            from.send(sim, 0, frame);
            sent += 1;
        }
        sim.run_until(Time::from_ms(1), |sim| sim.line(to.id, 0)).unwrap();
        while let Some(got) = to.receive(sim, 1) {
            assert_eq!(got, *frame);
            received += 1;
        }
    }
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn classic_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    let (sim, from, to) = bench(path);
    to.regs(&sim).int_().set_bits(Int::RBIE);
    to.fifo(&sim, 1).int_().set_bits(FifoInt::RXNEMPTYIE);
    let frame = frame("123#0123456789ABCDEF");
    bencher.counter(ItemsCount::new(FRAMES)).bench_local(|| exchange(&sim, from, to, &frame));
    assert_eq!(sim.diagnostics().len(), 0);
}

/// Register accesses alone: a status register of a module that is idle.
#[divan::bench]
fn register_read(bencher: Bencher<'_, '_>) {
    let (sim, can, _) = bench(Path::Fast);
    let regs = can.regs(&sim);
    bencher.counter(ItemsCount::new(1_000_u32)).bench_local(|| {
        for _ in 0..1_000 {
            divan::black_box(regs.fifo(1).int_().read());
        }
    });
}
