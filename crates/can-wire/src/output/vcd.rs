//! Value change dump: the bus and every node's pins, for GTKWave, PulseView and sigrok.

use std::io;

use vcd::{IdCode, SimulationCommand, TimescaleUnit, Value, Writer};

use crate::{Level, Signal, Time, TraceSink};

/// Writes a value change dump in picoseconds: `wire.bus` and a scope `node0`, `node1`, ... with `node0_tx`, `node0_rx` and
/// so on; the names are unique because some viewers show no scopes.
/// Recessive is 1.
pub struct Vcd<W: io::Write> {
    writer: Writer<W>,
    bus: IdCode,
    pins: Vec<[IdCode; 2]>,
    at: Option<Time>,
    error: Option<io::Error>,
}

impl<W: io::Write> Vcd<W> {
    /// Writes the header for a wire of `nodes` nodes.
    ///
    /// # Errors
    /// If `output` cannot be written.
    pub fn new(output: W, nodes: usize) -> io::Result<Vcd<W>> {
        let names: Vec<String> = (0..nodes).map(|node| format!("node{node}")).collect();
        Vcd::with_names(output, &names.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// The same with names for the nodes, which take the place of `node0`, `node1` and so on.
    ///
    /// # Errors
    /// If `output` cannot be written.
    pub fn with_names(output: W, nodes: &[&str]) -> io::Result<Vcd<W>> {
        let mut writer = Writer::new(output);
        writer.timescale(1, TimescaleUnit::PS)?;
        writer.add_module("wire")?;
        let bus = writer.add_wire(1, "bus")?;
        let mut pins = Vec::with_capacity(nodes.len());
        for node in nodes {
            writer.add_module(node)?;
            pins.push([writer.add_wire(1, &format!("{node}_tx"))?, writer.add_wire(1, &format!("{node}_rx"))?]);
            writer.upscope()?;
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        writer.timestamp(0)?;
        writer.begin(SimulationCommand::Dumpvars)?;
        for id in core::iter::once(bus).chain(pins.iter().flatten().copied()) {
            writer.change_scalar(id, Value::V1)?;
        }
        writer.end()?;
        Ok(Vcd { writer, bus, pins, at: Some(Time::ZERO), error: None })
    }

    /// Writes the time of the end and flushes; reports the first error met on the way. Nothing is written after it.
    ///
    /// # Errors
    /// If the output could not be written, now or earlier.
    pub fn finish(&mut self, end: Time) -> io::Result<()> {
        if let Some(error) = self.error.take() {
            return Err(error);
        }
        if self.at.is_none_or(|at| at < end) {
            self.at = Some(end);
            self.writer.timestamp(end.as_ps())?;
        }
        self.writer.flush()
    }

    fn change(&mut self, time: Time, signal: Signal, level: Level) -> io::Result<()> {
        let id = match signal {
            Signal::Bus => Some(self.bus),
            Signal::Tx(node) => self.pins.get(node.index()).map(|pins| pins[0]),
            Signal::Rx(node) => self.pins.get(node.index()).map(|pins| pins[1]),
        };
        // A node that was added after the header cannot be shown.
        let Some(id) = id else { return Ok(()) };
        if self.at != Some(time) {
            self.at = Some(time);
            self.writer.timestamp(time.as_ps())?;
        }
        self.writer.change_scalar(id, if level.bit() { Value::V1 } else { Value::V0 })
    }
}

impl<W: io::Write> TraceSink for Vcd<W> {
    fn level(&mut self, time: Time, signal: Signal, level: Level) {
        if self.error.is_none() {
            self.error = self.change(time, signal, level).err();
        }
    }
}
