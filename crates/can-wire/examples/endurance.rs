//! A long run: frames back to back between nodes that take turns, with the speed and the memory of the process.
//!
//! `cargo run --release -p can-wire --example endurance -- --frames 10000000`
use std::{error::Error, fs, time::Instant};

use can_frame::Frame;
use can_wire::{EventKind, Mode, NodeConfig, NodeId, Time, Wire};
use clap::Parser;

/// Sends frames back to back and reports speed and memory.
#[derive(Parser)]
struct Arguments {
    /// Number of nodes.
    #[arg(long, default_value_t = 2)]
    nodes: usize,
    /// Number of frames.
    #[arg(long, default_value_t = 10_000_000)]
    frames: u64,
    /// The frame, in candump's notation.
    #[arg(long, default_value = "123#0123456789ABCDEF")]
    frame: Frame,
    /// Work out every bit.
    #[arg(long)]
    bit_path: bool,
    /// Delay from each node to the bus, and back, in nanoseconds each.
    #[arg(long, default_value_t = 0)]
    delay_ns: u64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let delay = Time::from_ns(arguments.delay_ns);
    let config = NodeConfig {
        tx_delay: delay,
        rx_delay: delay,
        ..NodeConfig::new()
    };
    let mut wire = Wire::new();
    wire.set_fast_path(!arguments.bit_path);
    let mut nodes: Vec<NodeId> = Vec::new();
    for _ in 0..arguments.nodes {
        let node = wire.add_node(config)?;
        wire.set_mode(node, Mode::Normal);
        nodes.push(node);
    }
    wire.run_until(Time::from_us(50), |_, _| {});
    println!(
        "{:>12} {:>14} {:>12} {:>12} {:>10}",
        "frames", "simulated", "real time", "frames/s", "memory"
    );
    let (start, began) = (wire.now(), Instant::now());
    let mut sent = 0;
    wire.send(nodes[0], arguments.frame)?;
    while let Some(event) = wire.next_event(Time::MAX) {
        if !matches!(event.kind, EventKind::Transmitted { .. }) {
            continue;
        }
        sent += 1;
        if sent % (arguments.frames / 10).max(1) == 0 {
            let real = began.elapsed().as_secs_f64();
            let simulated = wire.now().since(start).as_secs_f64();
            println!(
                "{sent:>12} {simulated:>12.3} s {:>10.1} x {:>12.0} {:>10}",
                simulated / real,
                sent as f64 / real,
                memory().unwrap_or_else(|| String::from("unknown")),
            );
        }
        if sent >= arguments.frames {
            break;
        }
        let next = (event.node.index() + 1) % nodes.len();
        wire.send(nodes[next], arguments.frame)?;
    }
    let statistics = wire.statistics();
    println!(
        "{} frames stepped over, {} steps of nodes",
        statistics.frames_skipped, statistics.steps
    );
    Ok(())
}

/// Resident memory of this process, where the system tells.
fn memory() -> Option<String> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(line.trim().to_owned())
}
