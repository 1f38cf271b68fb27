//! Replays a candump log over simulated nodes and writes what other tools read.
//!
//! `cargo run --release -p can-wire --example bus -- crates/can-wire/examples/short.log --vcd out.vcd --timeline -`
//!
//! Every interface of the log becomes a sender, dealt out over the nodes; a frame is requested at its time in the log
//! and sent again until it has arrived. One more node only listens and acknowledges.
use std::{
    collections::{BTreeMap, VecDeque},
    error::Error,
    fs::File,
    io::{self, BufRead, BufReader, BufWriter, Write},
    path::{Path, PathBuf},
    process::ExitCode,
    sync::{Arc, Mutex, PoisonError},
};

use can_frame::{Frame, LogLine};
use can_wire::{
    DelayCompensation, ErrorState, Event, EventKind, Mode, NodeConfig, NodeId, Time, TraceSink,
    Wire,
    output::{CandumpLog, FrameCapture, PcapNg, Tap, Vcd},
};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};

/// Replays a candump log over a simulated CAN bus.
#[derive(Parser)]
struct Arguments {
    /// The log, in the format of `candump -l` or of candump's screen output; `-` for standard input.
    log: PathBuf,
    /// Number of sending nodes.
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=1000))]
    nodes: u16,
    /// Nominal bit rate in bit/s.
    #[arg(long, default_value_t = 500_000)]
    bitrate: u32,
    /// Bit rate of the data phase of FD frames, in bit/s.
    #[arg(long, default_value_t = 2_000_000)]
    data_bitrate: u32,
    /// Clock of the nodes in hertz.
    #[arg(long, default_value_t = 80_000_000)]
    clock: u32,
    /// Delay between every node and the bus, in nanoseconds, each way.
    #[arg(long, default_value_t = 0)]
    delay_ns: u64,
    /// Request the frames one after the other, whatever their times.
    #[arg(long)]
    back_to_back: bool,
    /// Probability that a node takes a bit for its opposite.
    #[arg(long, default_value_t = 0.0)]
    bit_error_rate: f64,
    /// Seed of the bit errors.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Write a value change dump of the bus and all pins.
    #[arg(long)]
    vcd: Option<PathBuf>,
    /// Write the frames as a candump log.
    #[arg(long)]
    candump: Option<PathBuf>,
    /// Write the frames as a pcapng capture.
    #[arg(long)]
    pcapng: Option<PathBuf>,
    /// Log every node as an interface of its own, not the bus.
    #[arg(long)]
    each_node: bool,
    /// Write one frame bit by bit as text; `-` for standard output.
    #[arg(long)]
    timeline: Option<PathBuf>,
    /// Write one frame bit by bit as a picture.
    #[arg(long)]
    svg: Option<PathBuf>,
    /// Which frame that is, counted from 0.
    #[arg(long, default_value_t = 0)]
    frame: u64,
}

struct Scheduled {
    at: Time,
    sender: usize,
    frame: Frame,
}

#[derive(Default)]
struct Totals {
    sent: u64,
    lost_arbitration: u64,
    failed: u64,
    bus_off: u64,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let frames = read_log(arguments)?;
    let (mut wire, nodes) = build_wire(arguments)?;
    let outputs = Outputs::open(arguments, nodes.len(), nodes[0])?;
    wire.set_trace(Some(Box::new(outputs.sinks())));

    let bar = ProgressBar::new(frames.len() as u64);
    bar.set_style(ProgressStyle::with_template(
        "{wide_bar} {pos}/{len} frames, {eta} left",
    )?);
    let totals = replay(arguments, &mut wire, &nodes, frames, &bar)?;
    bar.finish_and_clear();

    outputs.finish(arguments, wire.now())?;
    report(&wire, &nodes, &totals, arguments);
    Ok(())
}

fn read_log(arguments: &Arguments) -> Result<Vec<Scheduled>, Box<dyn Error>> {
    let reader: Box<dyn BufRead> = if arguments.log == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(BufReader::new(
            File::open(&arguments.log).map_err(|e| format!("{}: {e}", arguments.log.display()))?,
        ))
    };
    let mut frames: Vec<Scheduled> = Vec::new();
    let mut interfaces = BTreeMap::new();
    let mut start = None;
    for (number, line) in reader.lines().enumerate() {
        let line = line?;
        if line.trim().is_empty() {
            continue;
        }
        let parsed = LogLine::parse(&line).map_err(|error| {
            format!(
                "{}:{}: {error}\n{line}",
                arguments.log.display(),
                number + 1
            )
        })?;
        let next = interfaces.len();
        let sender = *interfaces
            .entry(parsed.interface.to_owned())
            .or_insert(next)
            % usize::from(arguments.nodes);
        let start = *start.get_or_insert(parsed.nanoseconds);
        let at = if arguments.back_to_back {
            0
        } else {
            parsed.nanoseconds.saturating_sub(start)
        };
        frames.push(Scheduled {
            at: Time::from_ns(at),
            sender,
            frame: parsed.frame,
        });
    }
    frames.sort_by_key(|scheduled| scheduled.at);
    Ok(frames)
}

fn build_wire(arguments: &Arguments) -> Result<(Wire, Vec<NodeId>), Box<dyn Error>> {
    let delay = Time::from_ns(arguments.delay_ns);
    let mut config = NodeConfig {
        clock_hz: arguments.clock,
        tx_delay: delay,
        rx_delay: delay,
        ..NodeConfig::new()
    }
    .with_rate(arguments.bitrate)?
    .with_data_rate(arguments.data_bitrate)?;
    let offset = config.data.sample_quanta() * u64::from(config.data.prescaler);
    config.delay_compensation = Some(DelayCompensation::measured(i16::try_from(offset)?));
    let mut wire = Wire::new();
    let mut nodes = Vec::new();
    // The last one only listens and acknowledges.
    for _ in 0..=arguments.nodes {
        let node = wire.add_node(config)?;
        wire.set_mode(node, Mode::Normal);
        if !(0.0..=1.0).contains(&arguments.bit_error_rate) {
            return Err("a bit error rate lies between 0 and 1".into());
        }
        wire.set_noise(node, arguments.bit_error_rate, arguments.seed);
        nodes.push(node);
    }
    let integrated = config.nominal_bit() * 14;
    wire.run_until(integrated, |_, _| {});
    Ok((wire, nodes))
}

fn replay(
    arguments: &Arguments,
    wire: &mut Wire,
    nodes: &[NodeId],
    frames: Vec<Scheduled>,
    bar: &ProgressBar,
) -> Result<Totals, Box<dyn Error>> {
    let start = wire.now();
    let mut queues: Vec<VecDeque<Frame>> = vec![VecDeque::new(); nodes.len()];
    let mut totals = Totals::default();
    let mut frames = frames.into_iter().peekable();
    let mut idle_until = wire.now();
    // A frame of 64 bytes and its retransmissions fit many times into this; a bus on which nothing arrives for so long
    // is dead.
    let patience = wire.config(nodes[0]).nominal_bit() * 100_000;
    loop {
        // Everything that is due now; back to back a few at a time, so that the order of the log is kept.
        let due = |scheduled: &Scheduled, now: Time| start + scheduled.at <= now;
        while let Some(scheduled) = frames.next_if(|scheduled| {
            due(scheduled, wire.now())
                && (!arguments.back_to_back || queues.iter().all(VecDeque::is_empty))
        }) {
            let queue = &mut queues[scheduled.sender];
            queue.push_back(scheduled.frame);
            if queue.len() == 1 {
                send(wire, nodes[scheduled.sender], scheduled.frame)?;
            }
            idle_until = wire.now() + patience;
        }
        let busy = queues.iter().any(|queue| !queue.is_empty());
        let limit = match frames.peek() {
            Some(scheduled) if !busy || !arguments.back_to_back => start + scheduled.at,
            _ if busy => idle_until,
            _ => break,
        };
        let limit = if busy { limit.min(idle_until) } else { limit };
        match wire.next_event(limit) {
            Some(event) => {
                let arrived = handle(wire, nodes, &mut queues, &mut totals, event)?;
                if arrived {
                    bar.inc(1);
                    idle_until = wire.now() + patience;
                }
            }
            None if busy && wire.now() >= idle_until => {
                return Err("no frame gets through any more".into());
            }
            None => {}
        }
    }
    let end = wire.now() + wire.config(nodes[0]).nominal_bit() * 20;
    wire.run_until(end, |_, _| {});
    Ok(totals)
}

/// Requests a frame unless the node is bus off; it is requested again after the recovery.
fn send(wire: &mut Wire, node: NodeId, frame: Frame) -> Result<(), Box<dyn Error>> {
    if wire.error_state(node) != ErrorState::BusOff {
        wire.send(node, frame)?;
    }
    Ok(())
}

/// Returns true if a frame has got through.
fn handle(
    wire: &mut Wire,
    nodes: &[NodeId],
    queues: &mut [VecDeque<Frame>],
    totals: &mut Totals,
    event: Event,
) -> Result<bool, Box<dyn Error>> {
    let node = nodes[event.node.index()];
    let queue = &mut queues[event.node.index()];
    let sent = match event.kind {
        EventKind::Transmitted { .. } => {
            queue.pop_front();
            totals.sent += 1;
            true
        }
        EventKind::ArbitrationLost { .. } => {
            totals.lost_arbitration += 1;
            false
        }
        EventKind::TransmissionFailed(_) => {
            totals.failed += 1;
            false
        }
        EventKind::ErrorState {
            to: ErrorState::BusOff,
            ..
        } => {
            totals.bus_off += 1;
            wire.start_recovery(node)?;
            return Ok(false);
        }
        EventKind::ErrorState {
            from: ErrorState::BusOff,
            ..
        } => false,
        _ => return Ok(false),
    };
    if let Some(frame) = queue.front() {
        send(wire, node, *frame)?;
    }
    Ok(sent)
}

type Shared<T> = Option<Arc<Mutex<T>>>;

fn shared<T>(sink: T) -> Shared<T> {
    Some(Arc::new(Mutex::new(sink)))
}

fn lock<T>(shared: &Arc<Mutex<T>>) -> std::sync::MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Outputs {
    vcd: Shared<Vcd<BufWriter<File>>>,
    candump: Shared<CandumpLog<BufWriter<File>>>,
    pcapng: Shared<PcapNg<BufWriter<File>>>,
    capture: Shared<FrameCapture>,
}

impl Outputs {
    fn open(
        arguments: &Arguments,
        nodes: usize,
        reference: NodeId,
    ) -> Result<Outputs, Box<dyn Error>> {
        let create = |path: &PathBuf| -> Result<BufWriter<File>, Box<dyn Error>> {
            Ok(BufWriter::new(
                File::create(path).map_err(|e| format!("{}: {e}", path.display()))?,
            ))
        };
        let tap = if arguments.each_node {
            Tap::EachNode
        } else {
            Tap::Bus
        };
        let mut outputs = Outputs {
            vcd: None,
            candump: None,
            pcapng: None,
            capture: None,
        };
        if let Some(path) = &arguments.vcd {
            outputs.vcd = shared(Vcd::new(create(path)?, nodes)?);
        }
        if let Some(path) = &arguments.candump {
            outputs.candump = shared(CandumpLog::new(create(path)?, tap, nodes));
        }
        if let Some(path) = &arguments.pcapng {
            outputs.pcapng = shared(PcapNg::new(create(path)?, tap, nodes)?);
        }
        if arguments.timeline.is_some() || arguments.svg.is_some() {
            outputs.capture = shared(FrameCapture::new(reference, arguments.frame));
        }
        Ok(outputs)
    }

    fn sinks(&self) -> Vec<Box<dyn TraceSink + Send>> {
        fn add<T: TraceSink + Send + 'static>(
            sinks: &mut Vec<Box<dyn TraceSink + Send>>,
            sink: &Shared<T>,
        ) {
            sinks.extend(
                sink.iter()
                    .map(|sink| Box::new(Arc::clone(sink)) as Box<dyn TraceSink + Send>),
            );
        }
        let mut sinks = Vec::new();
        add(&mut sinks, &self.vcd);
        add(&mut sinks, &self.candump);
        add(&mut sinks, &self.pcapng);
        add(&mut sinks, &self.capture);
        sinks
    }

    fn finish(&self, arguments: &Arguments, end: Time) -> Result<(), Box<dyn Error>> {
        if let Some(vcd) = &self.vcd {
            lock(vcd).finish(end)?;
        }
        if let Some(candump) = &self.candump {
            lock(candump).finish()?;
        }
        if let Some(pcapng) = &self.pcapng {
            lock(pcapng).finish()?;
        }
        let Some(capture) = &self.capture else {
            return Ok(());
        };
        let capture = lock(capture);
        if capture.bits().is_empty() {
            return Err(format!("there is no frame number {}", arguments.frame).into());
        }
        match &arguments.timeline {
            Some(path) if path == Path::new("-") => {
                io::stdout().write_all(capture.timeline().as_bytes())?
            }
            Some(path) => std::fs::write(path, capture.timeline())?,
            None => {}
        }
        if let Some(path) = &arguments.svg {
            std::fs::write(path, capture.svg())?;
        }
        Ok(())
    }
}

fn report(wire: &Wire, nodes: &[NodeId], totals: &Totals, arguments: &Arguments) {
    let mut out = String::new();
    out += &format!("{} frames in {}", totals.sent, wire.now());
    out += &format!(
        ", {} times arbitration lost, {} failed",
        totals.lost_arbitration, totals.failed
    );
    if totals.bus_off > 0 {
        out += &format!(", {} times bus off", totals.bus_off);
    }
    if arguments.bit_error_rate > 0.0 {
        out += &format!(", bit errors with seed {}", arguments.seed);
    }
    eprintln!("{out}");
    for node in nodes {
        let (tec, rec) = wire.error_counters(*node);
        if tec > 0 || rec > 0 {
            eprintln!("{node}: {}, TEC {tec}, REC {rec}", wire.error_state(*node));
        }
    }
}
