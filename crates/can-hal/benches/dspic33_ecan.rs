//! Frames per second from one ECAN driver to another: HAL, model with DMA, wire, model, HAL.
//!
//! `cargo bench -p can-hal --bench dspic33_ecan`; one item is one frame of 8 bytes at 1 Mbit/s. The sender keeps its queue
//! filled, the receiver sleeps until its interrupt line tells of a message and then fetches all there are.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

use can_hal::{
    Frame, Polls, Receive, Region, SendError, Transmit,
    dspic33_ecan::{BufferCount, Can, Config, Filter, FilterTarget, Interrupts, Mask, MaskSource},
    memory::{DsPic33EcanMemory, DsPic33EcanPlan},
    mode::Running,
    timing::{DsPic33EcanTiming, Request},
};
use can_sim::{
    Handle, Memory, MemoryBus, RegisterBus, Sim, Time,
    dspic33_ecan::{EcanConfig, EcanModel},
};
use divan::{Bencher, counter::ItemsCount};

fn main() {
    divan::main();
}

const FRAMES: u32 = 1_000;
const BYTES: u32 = 512;

const TIMING: DsPic33EcanTiming = DsPic33EcanTiming::fixed(&Request::new(40_000_000, 1_000_000));
const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers16, 8).fixed();
const FILTERS: [Filter; 1] = [Filter::any(FilterTarget::Fifo, MaskSource::Mask0)];

type Driver<'a> = Can<Running, RegisterBus<'a>, MemoryBus<'a>>;

/// Which way the wire takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Path {
    Fast,
    BitByBit,
}

#[allow(unsafe_code, reason = "a memory of its own")]
fn node<'a>(sim: &'a Sim, name: &str) -> (Handle<EcanModel>, Driver<'a>) {
    let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[16]));
    let id = sim.add_dspic33_ecan(name, EcanConfig::new(ram)).unwrap();
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(sim.memory(ram), 0, BYTES) };
    let mut can = Can::new(sim.registers(id), region, &PLAN, Polls(1_000)).unwrap();
    can.configure(&Config::new(TIMING).with_queue(2).with_filters([Mask::ANY; 3], &FILTERS)).unwrap();
    can.enable_interrupts(Interrupts::RBIF);
    (id, can.start_normal(Polls(1_000)).unwrap())
}

fn exchange(sim: &Sim, from: &mut Driver<'_>, (id, to): &mut (Handle<EcanModel>, Driver<'_>), frame: &Frame) {
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
        to.clear_interrupts(Interrupts::RBIF);
        while let Some(message) = to.fetch().unwrap() {
            assert_eq!(message.frame, *frame);
            received += 1;
        }
    }
}

#[divan::bench(args = [Path::Fast, Path::BitByBit])]
fn classic_8_bytes(bencher: Bencher<'_, '_>, path: Path) {
    let sim = Sim::new();
    sim.with_wire(|wire| wire.set_fast_path(path == Path::Fast));
    let frame: Frame = "123#0123456789ABCDEF".parse().unwrap();
    let (_, mut from) = node(&sim, "can1");
    let mut to = node(&sim, "can2");
    bencher.counter(ItemsCount::new(FRAMES)).bench_local(|| exchange(&sim, &mut from, &mut to, &frame));
    assert_eq!(sim.diagnostics(), []);
}
