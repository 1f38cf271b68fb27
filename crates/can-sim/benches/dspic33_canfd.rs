//! Frames per second from one register crate to another through two dsPIC33 CAN FD modules and the wire.
//!
//! `cargo bench -p can-sim --bench dspic33_canfd`; one item is one frame: written to a transmit FIFO, requested, sent,
//! filtered, stored, read from a receive FIFO and released. The bus runs at 1 Mbit/s, and at 5 Mbit/s in the data phase
//! of the FD frames.
#![allow(clippy::unwrap_used, dead_code, reason = "the bench of the tests, of which this uses a part")]

#[path = "../tests/dspic33_canfd/bench.rs"]
mod bench;

use bench::{BASE, Can, Mode, TX64, TxFifo, add, fd, frame};
use can_frame::Frame;
use can_sim::{Sim, Time};
use divan::{Bencher, counter::ItemsCount};
use dspic33_canfd_pac::{enums::PayloadSize, registers as pac};

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
    let cans = ["can0", "can1"].map(|name| add(&sim, name));
    for can in cans {
        can.configure(&sim);
        can.tx_fifo(&sim, 1, TxFifo { depth: 8, ..TX64 });
        can.rx_fifo(&sim, 2, 8, PayloadSize::Bytes64);
        can.accept_all(&sim, 2);
    }
    for can in cans {
        can.ask(&sim, Mode::NormalCanFd);
    }
    for can in cans {
        can.wait(&sim, Mode::NormalCanFd);
    }
    cans[1].regs(&sim).int_h().write(pac::IntH::RXIE);
    cans[1].regs(&sim).fifo(2).con_l().write(pac::FifoConL::TFNRFNIE);
    (sim, cans[0], cans[1])
}

/// The sender keeps its FIFO filled, the receiver sleeps until its interrupt line tells of a message.
fn exchange(sim: &Sim, from: Can, to: Can, frame: &Frame) {
    let (mut sent, mut received) = (0, 0);
    while received < FRAMES {
        while sent < FRAMES && from.status(sim, 1).tfnrfnif() {
            let at = from.user_address(sim, 1) - BASE;
            from.write_object(sim, at as usize, frame, |t2| t2);
            from.increment(sim, 1, true);
            sent += 1;
        }
        sim.run_until(Time::from_ms(1), |sim| sim.line(to.id, 0)).unwrap();
        while let Some(got) = to.receive(sim, 2) {
            assert_eq!(got, *frame);
            received += 1;
        }
    }
}

fn run(bencher: Bencher<'_, '_>, path: Path, frame: &Frame) {
    let (sim, from, to) = bench(path);
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
    run(bencher, path, &fd(0x123, &data));
}

/// Register accesses alone: a status register of a module that is idle.
#[divan::bench]
fn register_read(bencher: Bencher<'_, '_>) {
    let (sim, can, _) = bench(Path::Fast);
    let status = can.regs(&sim).fifo(1).sta();
    bencher.counter(ItemsCount::new(1_000_u32)).bench_local(|| {
        for _ in 0..1_000 {
            divan::black_box(status.read());
        }
    });
}

#[divan::bench]
fn register_write(bencher: Bencher<'_, '_>) {
    let (sim, can, _) = bench(Path::Fast);
    let enables = can.regs(&sim).int_h();
    bencher.counter(ItemsCount::new(1_000_u32)).bench_local(|| {
        for value in 0..1_000 {
            enables.write(pac::IntH::from_bits(value & 0xFC1F));
        }
    });
}
