//! `bit-timing`.

use std::fmt::Write;
use std::path::PathBuf;

use can_hal::timing::{
    Compensation, DsPic33CanFdTiming, DsPic33EcanTiming, JumpWidth, Limits, MCanTiming, PhaseReport, PhaseRequest,
    Pic32CanTiming, Prescalers, Propagation, Request, SamplePoint, SegmentFault, Segments, Solution,
};
use clap::{Args, ValueEnum};

use crate::quantity::{percent, shown, whole};
use crate::{Controller, Output, picture};

/// What is asked for.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The controller.
    #[arg(long, value_enum)]
    controller: Controller,
    /// Its clock in hertz: m_can_cclk, FCAN, FCY, FSYS.
    #[arg(long, value_name = "HZ", value_parser = whole)]
    clock: u32,
    /// Nominal bit rate in bit/s.
    #[arg(long, value_name = "RATE", value_parser = whole)]
    nominal: u32,
    /// Data bit rate in bit/s; without it there is no data phase.
    #[arg(long, value_name = "RATE", value_parser = whole)]
    data: Option<u32>,
    /// Nominal sample point; the recommended one if left out.
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    sample_point: Option<u16>,
    /// Sample point of the data phase; the recommended one if left out.
    #[arg(long, value_name = "PERCENT", value_parser = percent, requires = "data")]
    data_sample_point: Option<u16>,
    /// Largest deviation of the bit rates in ppm; 0 if left out.
    #[arg(long, value_name = "PPM", value_parser = whole, default_value = "0", hide_default_value = true)]
    within_ppm: u32,
    /// Take the nearest sample point, however far off. Without it, 5 % of the bit time are the most.
    #[arg(long)]
    any_sample_point: bool,
    /// Time quanta in a nominal bit.
    #[arg(long, value_name = "NUMBER", value_parser = whole)]
    quanta: Option<u32>,
    /// Jump width in time quanta; the largest if left out.
    #[arg(long, value_name = "QUANTA", value_parser = whole)]
    jump_width: Option<u32>,
    /// Length of the bus in metres, for the propagation segment.
    #[arg(long, value_name = "METRES", value_parser = whole)]
    bus_length: Option<u32>,
    /// Loop delay of the transceiver in nanoseconds.
    #[arg(long, value_name = "NS", value_parser = whole, default_value_t = Request::LONGEST_LOOP_DELAY)]
    loop_delay: u32,
    /// Transmitter delay compensation.
    #[arg(long, value_enum, default_value_t = Switch::Auto, requires = "data")]
    compensation: Switch,
    /// Only equal prescalers in both phases.
    #[arg(long, requires = "data")]
    equal_prescalers: bool,
    /// Sample every bit three times.
    #[arg(long)]
    three_samples: bool,
    /// Draw the bit into this file.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Switch {
    Auto,
    On,
    Off,
}

impl Arguments {
    fn request(&self) -> Request {
        let mut request =
            Request::new(self.clock, self.nominal).within_ppm(self.within_ppm).loop_delay(self.loop_delay);
        request.nominal.sample_point = self.sample_point.map(SamplePoint::hundredths);
        request.nominal.quanta = self.quanta;
        request.data = self.data.map(|rate| PhaseRequest {
            sample_point: self.data_sample_point.map(SamplePoint::hundredths),
            ..PhaseRequest::new(rate)
        });
        if let Some(quanta) = self.jump_width {
            request = request.jump_width(JumpWidth::Quanta(quanta));
        }
        if let Some(metres) = self.bus_length {
            request = request.propagation(Propagation::of_bus(metres, self.loop_delay));
        }
        if self.any_sample_point {
            request = request.any_sample_point();
        }
        if self.equal_prescalers {
            request = request.prescalers(Prescalers::Equal);
        }
        request.three_samples = self.three_samples;
        request.compensation(match self.compensation {
            Switch::Auto => Compensation::Automatic,
            Switch::On => Compensation::On,
            Switch::Off => Compensation::Off,
        })
    }
}

/// Solves and reports.
pub fn run(arguments: &Arguments) -> Result<Output, String> {
    let limits = match arguments.controller {
        Controller::MCan => Limits::M_CAN,
        Controller::DsPic33CanFd => Limits::DSPIC33_CANFD,
        Controller::DsPic33Ecan => Limits::DSPIC33_ECAN,
        Controller::Pic32Can => Limits::PIC32_CAN,
    };
    let request = arguments.request();
    let solution = limits.solve(&request).map_err(|error| format!("{}: {error}", limits.controller))?;
    let registers = registers(arguments.controller, &solution).map_err(|fault| fault.to_string())?;
    let mut text = format!("{}, {} {}\n\n", limits.controller, limits.clock, shown(arguments.clock.into(), "Hz"));
    phases(&mut text, &limits, &request, &solution);
    text.push_str("\nRegisters\n");
    for (name, word, fields) in &registers {
        writeln!(text, "  {name:<10} {word:<10}  {fields}").ok();
    }
    delay(&mut text, &request, &solution);
    tolerance(&mut text, &solution);
    alternatives(&mut text, &limits, &request, &solution);
    text.push_str("\nNominal bit\n");
    text.push_str(&picture::text(&solution.timing.nominal));
    if let Some(data) = &solution.timing.data {
        text.push_str("\nData bit\n");
        text.push_str(&picture::text(&data.segments));
    }
    let file = arguments.svg.as_ref().map(|path| (path.clone(), picture::svg(&bits(&request, &solution))));
    Ok(Output { text, file })
}

/// The bits with their titles.
fn bits(request: &Request, solution: &Solution) -> Vec<(String, Segments)> {
    let title = |name: &str, rate: u32, segments: &Segments| {
        (format!("{name} bit, {}, {} time quanta", shown(rate.into(), "bit/s"), segments.quanta()), *segments)
    };
    let mut bits = vec![title("Nominal", request.nominal.bit_rate, &solution.timing.nominal)];
    if let (Some(wanted), Some(data)) = (&request.data, &solution.timing.data) {
        bits.push(title("Data", wanted.bit_rate, &data.segments));
    }
    bits
}

fn deviation(ppm: i32) -> String {
    if ppm == 0 { "exact".to_owned() } else { format!("{ppm:+} ppm") }
}

/// The table of both phases.
fn phases(text: &mut String, limits: &Limits, request: &Request, solution: &Solution) {
    let mut columns: Vec<(&str, Segments, PhaseReport)> = vec![("nominal", solution.timing.nominal, solution.nominal)];
    if let (Some(data), Some(report)) = (&solution.timing.data, solution.data) {
        columns.push(("data", data.segments, report));
    }
    let mut row = |name: &str, cell: &dyn Fn(&(&str, Segments, PhaseReport)) -> String| {
        let cells: String = columns.iter().map(|column| format!("{:<20}", cell(column))).collect();
        writeln!(text, "  {}", format!("{name:<20}{cells}").trim_end()).ok();
    };
    row("", &|(name, ..)| (*name).to_owned());
    row("bit rate", &|(_, _, report)| report.bit_rate.to_string());
    row("  deviation", &|(_, _, report)| deviation(report.error_ppm));
    row("sample point", &|(_, _, report)| report.sample_point.to_string());
    row("  deviation", &|(_, _, report)| match report.sample_point_error {
        0 => "exact".to_owned(),
        error => format!("{:+.2} %", f64::from(error) / 100.0),
    });
    row("prescaler", &|(_, s, _)| s.prescaler.to_string());
    row("time quantum", &|(_, s, _)| {
        format!("{:.6}", f64::from(limits.divider * s.prescaler) / f64::from(request.clock) * 1e9)
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
            + " ns"
    });
    row("quanta in a bit", &|(_, s, _)| s.quanta().to_string());
    row("propagation", &|(_, s, _)| s.propagation.to_string());
    row("phase segment 1", &|(_, s, _)| s.phase1.to_string());
    row("phase segment 2", &|(_, s, _)| s.phase2.to_string());
    row("jump width", &|(_, s, _)| s.jump_width.to_string());
}

/// Name, word and fields of each register.
fn registers(controller: Controller, solution: &Solution) -> Result<Vec<(&'static str, String, String)>, SegmentFault> {
    /// The fields of a value as its Debug shows them, without the type's name.
    fn fields(value: &dyn std::fmt::Debug) -> String {
        let text = format!("{value:?}");
        let inner = text.split_once('{').map_or(text.as_str(), |(_, rest)| rest);
        inner.trim_end_matches('}').trim().replace(": ", " ")
    }
    macro_rules! rows {
        ($width:literal: $($name:literal $value:expr),* $(,)?) => {
            vec![$(($name, format!(concat!("{:#0", $width, "x}"), $value.bits()), fields(&$value))),*]
        };
    }
    let timing = &solution.timing;
    Ok(match controller {
        Controller::MCan => {
            let r = MCanTiming::of(timing)?;
            let mut rows = rows![10: "NBTP" r.nbtp, "DBTP" r.dbtp, "TDCR" r.tdcr];
            rows.truncate(if timing.data.is_some() { 3 } else { 1 });
            rows
        }
        Controller::DsPic33CanFd => {
            let r = DsPic33CanFdTiming::of(timing)?;
            let mut rows = rows![
                6: "CxNBTCFGL" r.nbtcfgl, "CxNBTCFGH" r.nbtcfgh, "CxDBTCFGL" r.dbtcfgl, "CxDBTCFGH" r.dbtcfgh,
                "CxTDCL" r.tdcl, "CxTDCH" r.tdch,
            ];
            rows.truncate(if timing.data.is_some() { 6 } else { 2 });
            rows
        }
        Controller::DsPic33Ecan => {
            let r = DsPic33EcanTiming::of(timing)?;
            rows![6: "CxCFG1" r.cfg1, "CxCFG2" r.cfg2]
        }
        Controller::Pic32Can => {
            let r = Pic32CanTiming::of(timing)?;
            rows![10: "CiCFG" r.cfg]
        }
    })
}

fn delay(text: &mut String, request: &Request, solution: &Solution) {
    let Some(data) = &solution.timing.data else { return };
    text.push_str("\nTransmitter delay compensation\n");
    match data.compensation {
        Some(compensation) => writeln!(
            text,
            "  on: {} clock periods ({:.1} ns) from the measured delay to the secondary sample point",
            compensation.offset,
            f64::from(compensation.offset) / f64::from(request.clock) * 1e9
        ),
        None => writeln!(text, "  off"),
    }
    .ok();
}

fn tolerance(text: &mut String, solution: &Solution) {
    let tolerance = &solution.tolerance;
    writeln!(text, "\nOscillator tolerance: {} ppm", tolerance.min()).ok();
    let conditions = [
        ("1 resynchronization", Some(tolerance.resynchronization)),
        ("2 after an error flag", Some(tolerance.after_error_flag)),
        ("3 data resynchronization", tolerance.data_resynchronization),
        ("4 after an error flag in the data phase", tolerance.after_data_error_flag),
        ("5 bit rate switch", tolerance.rate_switch),
    ];
    for (name, ppm) in conditions.into_iter().filter_map(|(name, ppm)| Some((name, ppm?))) {
        let mark = if ppm == tolerance.min() { "  <- decides" } else { "" };
        writeln!(text, "  {name:<40} {ppm:>6} ppm{mark}").ok();
    }
}

/// The best solutions with other numbers of quanta.
fn alternatives(text: &mut String, limits: &Limits, request: &Request, solution: &Solution) {
    const MOST: usize = 5;
    let mut phase = |name: &str, limits: &Limits, wanted: &PhaseRequest, chosen: &Segments, alone: &Request| {
        let mut found: Vec<(Segments, PhaseReport)> = (limits.nominal.min_quanta..=limits.nominal.max_quanta)
            .filter(|quanta| *quanta != chosen.quanta())
            .filter_map(|quanta| {
                let nominal = PhaseRequest { quanta: Some(quanta), ..*wanted };
                let solution = limits.solve(&Request { nominal, data: None, ..*alone }).ok()?;
                Some((solution.timing.nominal, solution.nominal))
            })
            .collect();
        found.sort_by_key(|(s, report)| {
            (report.error_ppm.unsigned_abs(), report.sample_point_error.unsigned_abs(), s.prescaler)
        });
        if found.is_empty() {
            return;
        }
        writeln!(text, "\nOther {name} bits").ok();
        for (s, report) in found.iter().take(MOST) {
            writeln!(
                text,
                "  prescaler {:>3}, {:>3} quanta, {:>3} + {:<3} sample point {:<8} jump width {:>3}, {}",
                s.prescaler,
                s.quanta(),
                s.before_sample(),
                s.phase2,
                format!("{},", report.sample_point),
                s.jump_width,
                deviation(report.error_ppm)
            )
            .ok();
        }
    };
    phase("nominal", limits, &request.nominal, &solution.timing.nominal, request);
    if let (Some(wanted), Some(data), Some(data_limits)) = (&request.data, &solution.timing.data, limits.data) {
        // The data phase on its own, as if it were the only one.
        let alone = Limits { nominal: data_limits, data: None, delay: None, ..*limits };
        let request = Request { propagation: Propagation::Longest, three_samples: false, ..*request };
        phase("data", &alone, wanted, &data.segments, &request);
    }
}
