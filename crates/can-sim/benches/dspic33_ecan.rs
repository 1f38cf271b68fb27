//! Frames per second from one register crate to another through two ECAN modules and the wire.
//!
//! `cargo bench -p can-sim --bench dspic33_ecan`; one item is one frame of 8 bytes: written to DMA RAM, requested, fetched
//! by DMA, sent, filtered, stored by DMA in the FIFO, read from it and released. The bus runs at 1 Mbit/s.
#![allow(clippy::unwrap_used, dead_code, reason = "the bench of the tests, of which this uses a part")]

#[path = "../tests/dspic33_ecan/bench.rs"]
mod bench;

use bench::{Can, add, everything, frame};
use can_frame::Frame;
use can_sim::{Sim, Time};
use divan::{Bencher, counter::ItemsCount};
use dspic33_ecan_pac::{
    enums::{FilterTarget, OperationMode, TxPriority},
    registers::{Inte, Intf},
};

fn main() {
    divan::main();
}

const FRAMES: u32 = 1_000;

/// One buffer of each control register.
const BUFFERS: [usize; 2] = [0, 2];

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
        can.set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo));
        can.write_fctrl(&sim, 6 << 13 | 8);
        for buffer in BUFFERS {
            can.transmit_buffer(&sim, buffer, TxPriority::Lowest);
        }
        can.enter(&sim, OperationMode::Normal);
    }
    (sim, cans[0], cans[1])
}

/// The sender keeps its buffers filled, the receiver sleeps until its interrupt line tells of a message.
fn exchange(sim: &Sim, from: Can, to: Can, frame: &Frame) {
    let (mut sent, mut received) = (0, 0);
    while received < FRAMES {
        for buffer in BUFFERS {
            if sent < FRAMES && !from.outcome(sim, buffer).0 {
                from.send(sim, buffer, frame);
                sent += 1;
            }
        }
        sim.run_until(Time::from_ms(1), |sim| sim.line(to.id, 0)).unwrap();
        to.regs(sim).intf().clear(Intf::RBIF);
        while let Some(got) = to.take_from_fifo(sim) {
            assert_eq!(got, *frame);
            received += 1;
        }
    }
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn classic_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    let (sim, from, to) = bench(path);
    to.regs(&sim).inte().write(Inte::RBIE);
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
            divan::black_box(regs.fifo().read());
        }
    });
}
