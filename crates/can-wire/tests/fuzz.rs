//! Random bit streams and random configurations into nodes: never a panic, never a hang.
//!
//! First every file of `tests/corpus`, then random inputs for `CAN_WIRE_FUZZ_SECONDS` seconds (5 unless set), seeded with
//! `CAN_WIRE_FUZZ_SEED` (1 unless set). An input that fails is printed in hexadecimal; put it into the corpus.
#![allow(clippy::unwrap_used)]

mod common;

use std::{
    env, fs,
    time::{Duration, Instant},
};

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_wire::{
    BitFault, BitTiming, DelayCompensation, DelaySource, Disturbance, ErrorState, EventKind, Fault,
    FdSupport, Field, Frames, Line, Mode, NodeConfig, NodeId, Position, ProtocolException, Time,
    Wire,
};
use common::Random;

/// Bytes as decisions; zeros when they run out.
struct Input<'a>(&'a [u8]);

impl Input<'_> {
    fn byte(&mut self) -> u8 {
        match self.0.split_first() {
            Some((first, rest)) => {
                self.0 = rest;
                *first
            }
            None => 0,
        }
    }

    fn below(&mut self, end: u8) -> u8 {
        self.byte() % end
    }

    fn word(&mut self) -> u32 {
        u32::from_le_bytes([self.byte(), self.byte(), self.byte(), self.byte()])
    }
}

const MODES: [Mode; 6] = [
    Mode::Normal,
    Mode::ListenOnly,
    Mode::Restricted,
    Mode::InternalLoopback,
    Mode::ExternalLoopback,
    Mode::Off,
];

fn timing(input: &mut Input<'_>) -> BitTiming {
    BitTiming {
        prescaler: 1 + u16::from(input.below(4)),
        prop_seg: u16::from(input.below(40)),
        phase_seg1: 1 + u16::from(input.below(40)),
        phase_seg2: 1 + u16::from(input.below(30)),
        // Also beyond the phase segments, as software may set it.
        sjw: 1 + u16::from(input.below(50)),
    }
}

fn config(input: &mut Input<'_>) -> NodeConfig {
    let plain = input.byte() & 1 == 0;
    let standard = NodeConfig::new();
    let nominal = if plain {
        standard.nominal
    } else {
        timing(input)
    };
    let data = if plain { standard.data } else { timing(input) };
    let delay = match input.below(3) {
        0 => DelaySource::Fixed(u16::from(input.byte())),
        _ => DelaySource::Measured {
            filter: u16::from(input.byte()),
        },
    };
    let compensation = DelayCompensation {
        delay,
        offset: i16::from(input.byte() as i8),
        limit: u16::from(input.byte()),
    };
    NodeConfig {
        clock_hz: [40_000_000, 80_000_000, 20_000_000, 8_333_333][usize::from(input.below(4))],
        clock_ppm: i32::from(input.byte() as i8) * 100,
        nominal,
        data,
        delay_compensation: (input.below(2) == 1).then_some(compensation),
        tx_delay: Time::from_ps(u64::from(input.word() % 1_000_000)),
        rx_delay: Time::from_ps(u64::from(input.word() % 1_000_000)),
        fd: [FdSupport::Fd, FdSupport::Tolerant, FdSupport::Classic][usize::from(input.below(3))],
        iso_crc: input.below(4) != 0,
        protocol_exception: [ProtocolException::Integrate, ProtocolException::FormError]
            [usize::from(input.below(2))],
        edge_filter: input.below(2) == 1,
        rec_after_passive: 119 + input.below(9),
        recovery_sequences: 1 + u16::from(input.byte()),
        wake_on_edge: input.below(2) == 1,
    }
}

fn any_frame(input: &mut Input<'_>) -> Frame {
    let raw = input.word() & 0x1FFF_FFFF;
    let id = match input.below(2) {
        0 => Id::Standard(StandardId::new((raw & 0x7FF) as u16).unwrap()),
        _ => Id::Extended(ExtendedId::new(raw).unwrap()),
    };
    let format = match input.below(3) {
        0 => Format::Data,
        1 => Format::Remote,
        _ => Format::Fd(FdFlags {
            brs: input.below(2) == 1,
            esi: input.below(2) == 1,
        }),
    };
    let byte = input.byte();
    Frame::from_fields(id, format, Dlc::from_low_bits(input.byte()), &[byte; 64])
}

fn fault(input: &mut Input<'_>, node: NodeId, now: Time) -> Fault {
    let from = now + Time::from_ns(u64::from(input.word() % 20_000));
    let until = from + Time::from_ps(u64::from(input.word() % 20_000_000));
    let frames = Frames {
        sender: (input.below(2) == 1).then_some(node),
        skip: 0,
        count: 1 + u32::from(input.below(3)),
    };
    let fields = [
        Field::Sof,
        Field::BaseId,
        Field::Res,
        Field::Brs,
        Field::Dlc,
        Field::Data,
        Field::Crc,
        Field::CrcDelimiter,
        Field::AckSlot,
        Field::Eof,
        Field::Intermission,
        Field::ErrorFlag,
        Field::ErrorDelimiter,
    ];
    match input.below(4) {
        0 => Fault::DropAck { node, frames },
        1 => Fault::Cut { node, from, until },
        2 => {
            let line = [Line::Bus, Line::Tx(node), Line::Rx(node)][usize::from(input.below(3))];
            let how = [
                Disturbance::Dominant,
                Disturbance::Recessive,
                Disturbance::Inverted,
            ][usize::from(input.below(3))];
            Fault::Disturb {
                line,
                how,
                from,
                until,
            }
        }
        _ => Fault::Bit {
            node,
            fault: [
                BitFault::InvertSeen,
                BitFault::InvertDriven,
                BitFault::SilenceDriven,
            ][usize::from(input.below(3))],
            position: Position {
                field: fields[usize::from(input.below(13))],
                bit: u16::from(input.below(20)),
                stuff: input.below(6) == 0,
            },
            frames,
        },
    }
}

/// A raw bit stream on the bus: runs of dominant level of any length, at any distance.
fn bit_stream(input: &mut Input<'_>, wire: &mut Wire) {
    let unit = [25_000, 200_000, 1_000_000, 1_013_000][usize::from(input.below(4))];
    let mut at = wire.now();
    for _ in 0..input.below(60) {
        let lengths = input.byte();
        let from = at + Time::from_ps(unit * u64::from(lengths & 0xF));
        let until = from + Time::from_ps(unit * u64::from(lengths >> 4));
        wire.inject(Fault::Disturb {
            line: Line::Bus,
            how: Disturbance::Dominant,
            from,
            until,
        });
        at = until;
    }
}

/// One input: nodes, then actions with time in between. Checks what must hold whatever happens.
fn run_input(bytes: &[u8]) {
    let mut input = Input(bytes);
    let mut wire = Wire::new();
    wire.set_fast_path(input.below(2) == 1);
    for _ in 0..1 + input.below(4) {
        let config = config(&mut input);
        let node = wire.add_node(config).unwrap();
        wire.set_mode(node, MODES[usize::from(input.below(6))]);
        if input.below(8) == 7 {
            wire.set_noise(node, f64::from(input.byte()) / 255.0, 1);
        }
    }
    let nodes: Vec<NodeId> = wire.nodes().collect();
    while !input.0.is_empty() {
        let node = nodes[usize::from(input.byte()) % nodes.len()];
        match input.below(10) {
            0..=3 => drop(wire.send(node, any_frame(&mut input)).ok()),
            4 => bit_stream(&mut input, &mut wire),
            5 => {
                let fault = fault(&mut input, node, wire.now());
                wire.inject(fault);
            }
            6 => wire.set_mode(node, MODES[usize::from(input.below(6))]),
            7 => wire.set_mode_at_idle(node, MODES[usize::from(input.below(6))]),
            8 => wire.set_error_counters(node, u16::from(input.byte()), u16::from(input.byte())),
            _ => {
                wire.request_overload(node);
                let _ = wire.abort(node);
            }
        }
        let (start, steps) = (wire.now(), wire.statistics().steps);
        let limit = start + Time::from_us(u64::from(input.byte()) * 4);
        let mut last = start;
        while let Some(event) = wire.next_event(limit) {
            assert!(
                event.time >= last || matches!(event.kind, EventKind::WakeUp),
                "time goes back: {event}"
            );
            last = last.max(event.time);
            if let EventKind::Counters { tec, rec } = event.kind {
                assert!(tec <= 255 && rec <= 255);
            }
            if matches!(
                event.kind,
                EventKind::ErrorState {
                    to: ErrorState::BusOff,
                    ..
                }
            ) && wire.mode(event.node) != Mode::Off
            {
                wire.start_recovery(event.node).unwrap();
            }
        }
        assert_eq!(wire.now(), limit);
        // No hang: so many steps of a node per data bit time of the fastest node are too many.
        let shortest = nodes
            .iter()
            .map(|node| wire.config(*node))
            .map(|c| c.data_bit().min(c.nominal_bit()))
            .min()
            .unwrap();
        let bits = wire.now().since(start).as_ps() / shortest.as_ps() + 100;
        let steps = wire.statistics().steps - steps;
        // Edges of the bus and of the raw bit stream are steps too.
        assert!(
            steps < bits * 8 * (nodes.len() as u64 + 1) + 5_000,
            "{steps} steps in {bits} bits"
        );
    }
    for node in nodes {
        let _ = (
            wire.partial_frame(node),
            wire.position(node),
            wire.rx_level(node),
            wire.error_state(node),
        );
    }
}

fn checked(name: &str, bytes: &[u8]) {
    let outcome = std::panic::catch_unwind(|| run_input(bytes));
    if outcome.is_err() {
        let hex: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        panic!("{name} failed with the input {hex}");
    }
}

#[test]
fn the_corpus_runs() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/corpus");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    assert!(paths.len() >= 10, "the corpus is committed");
    for path in paths {
        checked(&path.display().to_string(), &fs::read(&path).unwrap());
    }
}

#[test]
fn random_inputs_run_for_a_bounded_time() {
    let setting = |name, default| env::var(name).map_or(default, |value| value.parse().unwrap());
    let (seconds, seed) = (
        setting("CAN_WIRE_FUZZ_SECONDS", 5),
        setting("CAN_WIRE_FUZZ_SEED", 1),
    );
    let end = Instant::now() + Duration::from_secs(seconds);
    let mut random = Random::new(seed);
    let mut inputs = 0u64;
    while Instant::now() < end {
        let len = 1 + random.below(400) as usize;
        let mut bytes: Vec<u8> = (0..len).map(|_| random.next() as u8).collect();
        // Small numbers choose the plain variants.
        if random.coin() {
            bytes.iter_mut().take(40).for_each(|byte| *byte &= 0x0E);
        }
        checked(&format!("input {inputs} of seed {seed}"), &bytes);
        inputs += 1;
    }
    println!("{inputs} inputs, seed {seed}");
    assert!(inputs > 0);
}
