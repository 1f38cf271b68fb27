//! `memory`.

use std::fmt::Write;

use can_hal::memory::{
    DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33EcanMemory, MCanMemory, Pic32CanFifo, Pic32CanMemory, Placed, Start,
};
use clap::Args;
use dspic33_canfd_pac::enums::PayloadSize;
use dspic33_ecan_pac::enums::BufferCount;
use m_can_pac::enums::DataFieldSize;

use crate::Controller;
use crate::quantity::whole;

/// What is asked for. Which sections there are depends on the controller.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The controller.
    #[arg(long, value_enum)]
    controller: Controller,
    /// Bytes of RAM, from the base on.
    #[arg(long, value_name = "BYTES", value_parser = whole)]
    ram: u32,
    /// Where the memory begins: an offset in the RAM (m_can, dspic33_ecan), or an address (dspic33_canfd, pic32_can).
    #[arg(long, value_name = "ADDRESS", value_parser = whole, default_value = "0")]
    base: u32,
    /// m_can: standard filter elements, COUNT[@START].
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    standard_filters: Option<Elements>,
    /// m_can: extended filter elements, COUNT[@START].
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    extended_filters: Option<Elements>,
    /// m_can: Rx FIFO 0, COUNTxBYTES[@START].
    #[arg(long = "rx-fifo-0", value_name = "SECTION", value_parser = elements)]
    rx_fifo_0: Option<Elements>,
    /// m_can: Rx FIFO 1, COUNTxBYTES[@START].
    #[arg(long = "rx-fifo-1", value_name = "SECTION", value_parser = elements)]
    rx_fifo_1: Option<Elements>,
    /// m_can: dedicated Rx Buffers, COUNTxBYTES[@START].
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    rx_buffers: Option<Elements>,
    /// m_can: Tx Event FIFO, COUNT[@START].
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    tx_events: Option<Elements>,
    /// m_can: Tx Buffers, dedicated ones and those of the FIFO or queue, DEDICATED[+FIFO]xBYTES[@START].
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    tx_buffers: Option<Elements>,
    /// dspic33_canfd: transmit event FIFO, COUNT[t]; t for timestamps.
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    tef: Option<Elements>,
    /// dspic33_canfd: transmit queue, COUNTxBYTES.
    #[arg(long, value_name = "SECTION", value_parser = elements)]
    txq: Option<Elements>,
    /// dspic33_canfd: NUMBER:tx:COUNTxBYTES or NUMBER:rx:COUNTxBYTES[t]; pic32_can: NUMBER:tx:COUNT, NUMBER:rx:COUNT or
    /// NUMBER:data:COUNT. May be given many times.
    #[arg(long, value_name = "FIFO", value_parser = fifo)]
    fifo: Vec<Fifo>,
    /// dspic33_ecan: number of buffers: 4, 6, 8, 12, 16, 24 or 32.
    #[arg(long, value_name = "COUNT", value_parser = whole)]
    buffers: Option<u32>,
    /// dspic33_ecan: first buffer of the FIFO.
    #[arg(long, value_name = "BUFFER")]
    fifo_start: Option<u8>,
}

/// A number of elements, with what belongs to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Elements {
    count: u32,
    more: Option<u32>,
    payload: Option<u32>,
    start: Option<u32>,
    timestamps: bool,
}

/// COUNT[+MORE][xBYTES][t][@START]
fn elements(text: &str) -> Result<Elements, String> {
    let (rest, start) = match text.split_once('@') {
        Some((rest, start)) => (rest, Some(whole(start).map_err(|error| format!("behind the @: {error}"))?)),
        None => (text, None),
    };
    let (rest, timestamps) = rest.strip_suffix('t').map_or((rest, false), |rest| (rest, true));
    let (rest, payload) = match rest.split_once('x') {
        Some((rest, bytes)) => (rest, Some(whole(bytes).map_err(|error| format!("behind the x: {error}"))?)),
        None => (rest, None),
    };
    let (count, more) = match rest.split_once('+') {
        Some((count, more)) => (count, Some(whole(more).map_err(|error| format!("behind the +: {error}"))?)),
        None => (rest, None),
    };
    let count = whole(count).map_err(|_| "expected a number of elements, such as 32 or 32x64".to_owned())?;
    Ok(Elements { count, more, payload, start, timestamps })
}

/// A FIFO with its number and kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Fifo {
    number: u8,
    kind: Kind,
    elements: Elements,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Transmit,
    Receive,
    Data,
}

/// NUMBER:KIND:ELEMENTS
fn fifo(text: &str) -> Result<Fifo, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [number, kind, rest] = parts[..] else {
        return Err("expected NUMBER:KIND:COUNT, such as 1:tx:5x64".to_owned());
    };
    let kind = match kind {
        "tx" => Kind::Transmit,
        "rx" => Kind::Receive,
        "data" => Kind::Data,
        other => return Err(format!("{other:?} is no kind of FIFO: tx, rx or data")),
    };
    let number = number.parse().map_err(|_| format!("{number:?} is no number of a FIFO"))?;
    Ok(Fifo { number, kind, elements: elements(rest)? })
}

impl Elements {
    /// Refuses what a section does not have.
    fn only(self, name: &str, allowed: &str) -> Result<Self, String> {
        let parts = [
            ('+', self.more.is_some(), "a second number"),
            ('x', self.payload.is_some(), "a size"),
            ('t', self.timestamps, "timestamps"),
            ('@', self.start.is_some(), "a start of its own"),
        ];
        match parts.into_iter().find(|(sign, given, _)| *given && !allowed.contains(*sign)) {
            Some((_, _, what)) => Err(format!("{name} does not have {what}")),
            None if allowed.contains('x') && self.payload.is_none() => {
                Err(format!("{name} needs a size: {}x8 for elements with 8 data bytes", self.count))
            }
            None => Ok(self),
        }
    }

    fn start(self) -> Start {
        self.start.map_or(Start::Packed, Start::At)
    }

    /// The code of the payload size.
    fn size<T>(self, name: &str, codes: impl Iterator<Item = (T, Option<u32>)>) -> Result<T, String> {
        let wanted = self.payload.unwrap_or(8);
        let mut known = Vec::new();
        for (code, bytes) in codes.filter_map(|(code, bytes)| Some((code, bytes?))) {
            if bytes == wanted {
                return Ok(code);
            }
            known.push(bytes.to_string());
        }
        Err(format!("{name}: no element has {wanted} data bytes; the sizes are {}", known.join(", ")))
    }
}

impl Arguments {
    /// Refuses options that belong to another controller.
    fn only(&self, allowed: &[&str]) -> Result<(), String> {
        let given = [
            ("--standard-filters", self.standard_filters.is_some()),
            ("--extended-filters", self.extended_filters.is_some()),
            ("--rx-fifo-0", self.rx_fifo_0.is_some()),
            ("--rx-fifo-1", self.rx_fifo_1.is_some()),
            ("--rx-buffers", self.rx_buffers.is_some()),
            ("--tx-events", self.tx_events.is_some()),
            ("--tx-buffers", self.tx_buffers.is_some()),
            ("--tef", self.tef.is_some()),
            ("--txq", self.txq.is_some()),
            ("--fifo", !self.fifo.is_empty()),
            ("--buffers", self.buffers.is_some()),
            ("--fifo-start", self.fifo_start.is_some()),
        ];
        match given.into_iter().find(|(name, given)| *given && !allowed.contains(name)) {
            Some((name, _)) => Err(format!("{name} is for another controller; this one has {}", allowed.join(", "))),
            None => Ok(()),
        }
    }
}

/// A register or another setting: name, value, fields.
type Setting = (String, String, String);

fn setting(name: &str, word: String, value: &dyn std::fmt::Debug) -> Setting {
    let text = format!("{value:?}");
    let inner = text.split_once('{').map_or(text.as_str(), |(_, rest)| rest);
    (name.to_owned(), word, inner.trim_end_matches('}').trim().replace(": ", " "))
}

macro_rules! settings {
    ($width:literal: $($name:literal $value:expr),* $(,)?) => {
        vec![$(setting($name, format!(concat!("{:#0", $width, "x}"), $value.bits()), &$value)),*]
    };
}

/// Plans and draws.
pub fn run(arguments: &Arguments) -> Result<String, String> {
    let (name, sections, settings) = match arguments.controller {
        Controller::MCan => m_can(arguments)?,
        Controller::DsPic33CanFd => canfd(arguments)?,
        Controller::DsPic33Ecan => ecan(arguments)?,
        Controller::Pic32Can => pic32(arguments)?,
    };
    // The offset of a shared RAM's first section is no end of it: the RAM of these two begins at 0.
    let (from, to) = match arguments.controller {
        Controller::MCan | Controller::DsPic33Ecan => (0, u64::from(arguments.ram)),
        Controller::DsPic33CanFd | Controller::Pic32Can => {
            (u64::from(arguments.base), u64::from(arguments.base) + u64::from(arguments.ram))
        }
    };
    let mut text = map(name, sections, from, to);
    text.push_str("\nRegisters\n");
    for (name, word, fields) in settings {
        writeln!(text, "{}", format!("  {name:<12} {word:<10}  {fields}").trim_end()).ok();
    }
    Ok(text)
}

type Planned = (&'static str, Vec<Placed>, Vec<Setting>);

fn m_can(arguments: &Arguments) -> Result<Planned, String> {
    const OPTIONS: [&str; 7] = [
        "--standard-filters",
        "--extended-filters",
        "--rx-fifo-0",
        "--rx-fifo-1",
        "--rx-buffers",
        "--tx-events",
        "--tx-buffers",
    ];
    arguments.only(&OPTIONS)?;
    let sizes = || (0..8).map(DataFieldSize::from_bits).map(|size| (size, size.number()));
    let mut memory = MCanMemory::new(arguments.ram).origin(arguments.base);
    if let Some(e) = arguments.standard_filters {
        let e = e.only("--standard-filters", "@")?;
        memory = memory.standard_filters(e.count).standard_filters_at(e.start());
    }
    if let Some(e) = arguments.extended_filters {
        let e = e.only("--extended-filters", "@")?;
        memory = memory.extended_filters(e.count).extended_filters_at(e.start());
    }
    if let Some(e) = arguments.rx_fifo_0 {
        let e = e.only("--rx-fifo-0", "x@")?;
        memory = memory.rx_fifo_0(e.count, e.size("--rx-fifo-0", sizes())?).rx_fifo_0_at(e.start());
    }
    if let Some(e) = arguments.rx_fifo_1 {
        let e = e.only("--rx-fifo-1", "x@")?;
        memory = memory.rx_fifo_1(e.count, e.size("--rx-fifo-1", sizes())?).rx_fifo_1_at(e.start());
    }
    if let Some(e) = arguments.rx_buffers {
        let e = e.only("--rx-buffers", "x@")?;
        memory = memory.rx_buffers(e.count, e.size("--rx-buffers", sizes())?).rx_buffers_at(e.start());
    }
    if let Some(e) = arguments.tx_events {
        let e = e.only("--tx-events", "@")?;
        memory = memory.tx_event_fifo(e.count).tx_event_fifo_at(e.start());
    }
    if let Some(e) = arguments.tx_buffers {
        let e = e.only("--tx-buffers", "+x@")?;
        let size = e.size("--tx-buffers", sizes())?;
        memory = memory.tx_buffers(e.count, e.more.unwrap_or(0), size).tx_buffers_at(e.start());
    }
    let plan = memory.plan().map_err(|error| format!("m_can: {error}"))?;
    let settings = settings![
        10: "SIDFC" plan.sidfc, "XIDFC" plan.xidfc, "RXF0C" plan.rxf0c, "RXF1C" plan.rxf1c, "RXBC" plan.rxbc,
        "RXESC" plan.rxesc, "TXEFC" plan.txefc, "TXBC" plan.txbc, "TXESC" plan.txesc,
    ];
    Ok(("m_can", plan.sections().collect(), settings))
}

fn canfd(arguments: &Arguments) -> Result<Planned, String> {
    arguments.only(&["--tef", "--txq", "--fifo"])?;
    let sizes = || (0..8).map(PayloadSize::from_bits).map(|size| (size, size.number()));
    let mut memory = DsPic33CanFdMemory::new(arguments.base, arguments.ram);
    if let Some(e) = arguments.tef {
        let e = e.only("--tef", "t")?;
        memory = memory.tef(e.count, e.timestamps);
    }
    if let Some(e) = arguments.txq {
        let e = e.only("--txq", "x")?;
        memory = memory.txq(e.count, e.size("--txq", sizes())?);
    }
    for Fifo { number, kind, elements } in &arguments.fifo {
        let name = format!("--fifo {number}");
        let (elements, timestamps) = match kind {
            Kind::Transmit => (elements.only(&name, "x")?, false),
            Kind::Receive => (elements.only(&name, "xt")?, elements.timestamps),
            Kind::Data => return Err(format!("{name}: this controller has no FIFO for data only")),
        };
        let (payload, elements) = (elements.size(&name, sizes())?, elements.count);
        let fifo = match kind {
            Kind::Transmit => DsPic33CanFdFifo::Transmit { elements, payload },
            _ => DsPic33CanFdFifo::Receive { elements, payload, timestamps },
        };
        memory = memory.fifo(*number, fifo);
    }
    let plan = memory.plan().map_err(|error| format!("dspic33_canfd: {error}"))?;
    let yes = |set: bool| u8::from(set).to_string();
    let mut settings = vec![
        ("CxFIFOBA".to_owned(), format!("{:#010x}", plan.fifoba), String::new()),
        ("STEF".to_owned(), yes(plan.stef), String::new()),
        ("TXQEN".to_owned(), yes(plan.txqen), String::new()),
    ];
    if plan.stef {
        settings.extend(settings![6: "CxTEFCONL" plan.tefconl, "CxTEFCONH" plan.tefconh]);
    }
    if plan.txqen {
        settings.extend(settings![6: "CxTXQCONH" plan.txqconh]);
    }
    for (number, fifo) in plan.fifos().filter(|(_, fifo)| fifo.placed.used) {
        for (half, word, value) in
            [("L", fifo.conl.bits(), &fifo.conl as &dyn std::fmt::Debug), ("H", fifo.conh.bits(), &fifo.conh)]
        {
            settings.push(setting(&format!("CxFIFOCON{number}{half}"), format!("{word:#06x}"), value));
        }
    }
    Ok(("dspic33_canfd", plan.sections().collect(), settings))
}

fn pic32(arguments: &Arguments) -> Result<Planned, String> {
    arguments.only(&["--fifo"])?;
    let mut memory = Pic32CanMemory::new(arguments.base, arguments.ram);
    for Fifo { number, kind, elements } in &arguments.fifo {
        let elements = elements.only(&format!("--fifo {number}"), "")?.count;
        let fifo = match kind {
            Kind::Transmit => Pic32CanFifo::Transmit { elements },
            Kind::Receive => Pic32CanFifo::Receive { elements },
            Kind::Data => Pic32CanFifo::ReceiveData { elements },
        };
        memory = memory.fifo(*number, fifo);
    }
    let plan = memory.plan().map_err(|error| format!("pic32_can: {error}"))?;
    let mut settings = vec![("CiFIFOBA".to_owned(), format!("{:#010x}", plan.fifoba), String::new())];
    for (number, fifo) in plan.fifos().filter(|(_, fifo)| fifo.placed.used) {
        settings.push(setting(&format!("CiFIFOCON{number}"), format!("{:#010x}", fifo.con.bits()), &fifo.con));
    }
    Ok(("pic32_can", plan.sections().collect(), settings))
}

fn ecan(arguments: &Arguments) -> Result<Planned, String> {
    arguments.only(&["--buffers", "--fifo-start"])?;
    let wanted = arguments.buffers.ok_or("dspic33_ecan needs --buffers")?;
    let codes: Vec<_> = (0..8).filter_map(|code| BufferCount::from_bits(code).ok()).collect();
    let count = codes.iter().find(|code| code.number() == Some(wanted)).ok_or_else(|| {
        let known: Vec<_> = codes.iter().filter_map(|code| Some(code.number()?.to_string())).collect();
        format!("--buffers {wanted}: the numbers are {}", known.join(", "))
    })?;
    let memory = DsPic33EcanMemory::new(arguments.base, arguments.ram, *count, arguments.fifo_start.unwrap_or(0));
    let plan = memory.plan().map_err(|error| format!("dspic33_ecan: {error}"))?;
    let mut settings = settings![6: "CxFCTRL" plan.fctrl];
    settings.push(("DMAxSTA".to_owned(), format!("{:#06x}", plan.start), String::new()));
    Ok(("dspic33_ecan", plan.sections().collect(), settings))
}

/// The map: every section and every gap, by address.
fn map(name: &str, mut sections: Vec<Placed>, from: u64, to: u64) -> String {
    const COLUMNS: u64 = 24;
    sections.sort_by_key(|section| section.start);
    let used: u64 = sections.iter().map(|section| u64::from(section.bytes())).sum();
    let mut text = format!("{name}: {used} of {} bytes, {} free\n\n", to - from, to - from - used);
    let mut row = |start: u64, end: u64, what: &str, elements: &str, fill: char| {
        let bytes = end - start;
        let bar = (bytes * COLUMNS).div_ceil((to - from).max(1)) as usize;
        let bar: String = std::iter::repeat_n(fill, bar).collect();
        let line = format!("  {start:#07x} to {:#07x}  {bytes:>6}  {what:<22} {elements:<10} {bar}", end - 1);
        writeln!(text, "{}", line.trim_end()).ok();
    };
    let mut at = from;
    for section in &sections {
        let start = u64::from(section.start);
        if start > at {
            row(at, start, "free", "", '.');
        }
        let elements = format!("{} x {}", section.elements, section.element_bytes);
        let unused = if section.used { "" } else { " (not set up)" };
        row(start, section.end(), &format!("{}{unused}", section.name), &elements, '#');
        at = section.end();
    }
    if at < to {
        row(at, to, "free", "", '.');
    }
    text
}
