//! Frames per second from one driver to another: HAL, model, wire, model, HAL.
//!
//! `cargo bench -p can-hal`; one item is one frame. The sender keeps its Tx FIFO filled, the receiver sleeps until its
//! interrupt line tells of a message and then fetches all there are. The bus runs at 1 Mbit/s, in the data phase at 5 Mbit/s.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

use can_hal::{
    Frame, Polls, Receive, Region, SendError, Transmit,
    m_can::{Can, Config, DataFieldSize, Interrupts, Line},
    memory::{MCanMemory, MCanPlan},
    mode::Running,
    timing::{MCanTiming, Request, SamplePoint},
};
use can_sim::{
    Handle, Memory, MemoryBus, RegisterBus, Sim, Time,
    m_can::{MCanConfig, MCanModel},
};
use divan::{Bencher, counter::ItemsCount};

fn main() {
    divan::main();
}

const FRAMES: u32 = 1_000;
const WORDS: u32 = 4352;

const TIMING: MCanTiming =
    MCanTiming::fixed(&Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(80)).data(5_000_000));
const PLAN: MCanPlan =
    MCanMemory::new(WORDS * 4).rx_fifo_0(16, DataFieldSize::Bytes64).tx_buffers(0, 16, DataFieldSize::Bytes64).fixed();

type Driver<'a> = Can<Running, RegisterBus<'a>, MemoryBus<'a>>;

/// Which way the wire takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Path {
    Fast,
    BitByBit,
}

#[allow(unsafe_code, reason = "a memory of its own")]
fn node<'a>(sim: &'a Sim, name: &str) -> (Handle<MCanModel>, Driver<'a>) {
    let ram = sim.add_memory(Memory::new(WORDS as usize));
    let id = sim.add_m_can(name, MCanConfig::new(ram)).unwrap();
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), 0, WORDS * 4) };
    let mut can = Can::new(sim.registers(id), region, &PLAN, Polls(100)).unwrap();
    can.configure(&Config::new(TIMING).with_fd()).unwrap();
    can.enable_interrupts(Interrupts::RF0N, Line::Int0);
    (id, can.start_normal(Polls(100)).unwrap())
}

fn exchange(sim: &Sim, from: &mut Driver<'_>, (id, to): &mut (Handle<MCanModel>, Driver<'_>), frame: &Frame) {
    let (mut sent, mut received) = (0, 0);
    while received < FRAMES {
        while sent < FRAMES {
            match from.send(frame) {
                Ok(_) => sent += 1,
                Err(SendError::Full) => break,
                Err(error) => panic!("{error}"),
            }
        }
        sim.run_until(Time::from_ms(1), |sim| sim.line(*id, 0)).unwrap();
        to.clear_interrupts(Interrupts::RF0N);
        while let Some(message) = to.fetch().unwrap() {
            assert_eq!(message.frame, *frame);
            received += 1;
        }
    }
}

fn run(bencher: Bencher<'_, '_>, path: Path, text: &str) {
    let sim = Sim::new();
    sim.with_wire(|wire| wire.set_fast_path(path == Path::Fast));
    let frame: Frame = text.parse().unwrap();
    let (_, mut from) = node(&sim, "can0");
    let mut to = node(&sim, "can1");
    sim.run_for(Time::from_us(20));
    bencher.counter(ItemsCount::new(FRAMES)).bench_local(|| exchange(&sim, &mut from, &mut to, &frame));
    assert_eq!(sim.diagnostics(), []);
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn classic_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    run(bencher, path, "123#0123456789ABCDEF");
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn fd_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    run(bencher, path, "123##10123456789ABCDEF");
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn fd_64_bytes(bencher: Bencher<'_, '_>, path: Path) {
    run(bencher, path, &format!("123##1{}", "5A".repeat(64)));
}
