//! The story in the terminal.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Color, Style};
use can_wire::{ErrorState, Time};

use crate::{
    Story,
    moments::{BUS_OFF, Kind, Moment, PASSIVE, bit_rate, milliseconds, moments},
    play::MOTOR,
};

const BOLD: Style = Style::new().bold();
const DIM: Style = Style::new().dimmed();
const NODES: [AnsiColor; 3] = [AnsiColor::Blue, AnsiColor::Green, AnsiColor::Magenta];

/// Columns of the text of a line.
const TEXT: usize = 54;
/// Cells of the bar that shows the transmit error counter.
const CELLS: u16 = 16;

/// The timeline: one line for everything worth telling, with the transmit error counter of the disturbed node beside it.
/// Colours are escape sequences; print it with `anstream`.
#[must_use]
pub fn timeline(story: &Story) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = write(story, &mut out);
    out
}

fn write(story: &Story, out: &mut String) -> std::fmt::Result {
    let data = story.data_rate.map_or_else(String::new, |rate| format!(", FD data {}", bit_rate(rate)));
    writeln!(out, "{BOLD}One CAN bus, two controllers, one fault{BOLD:#}   {}{data}", bit_rate(story.rate))?;
    for (index, node) in story.nodes.iter().enumerate() {
        let style = colour(NODES[index % NODES.len()]);
        writeln!(out, "  {style}{:<7}{style:#} {}", node.name, node.title)?;
    }
    let moments = moments(story);
    for (number, act) in story.acts.iter().enumerate() {
        let title = format!("{}  {}", number + 1, act.title);
        let tec = if number == 0 { format!("TEC of {}", story.nodes[MOTOR].name) } else { String::new() };
        let width = if tec.is_empty() { 0 } else { TEXT + 22 };
        writeln!(out, "\n{BOLD}{title:<width$}{BOLD:#}{DIM}{tec}{DIM:#}")?;
        let in_act = moments.iter().filter(|moment| story.act_at(moment.time) == number);
        for moment in in_act {
            line(story, moment, out)?;
        }
    }
    Ok(())
}

fn line(story: &Story, moment: &Moment, out: &mut String) -> std::fmt::Result {
    let node = colour(NODES[moment.node % NODES.len()]);
    let (mark, style) = match moment.kind {
        Kind::Sent => ("▶", Style::new()),
        Kind::Lost => ("◁", DIM),
        Kind::Failed => ("✗", colour(AnsiColor::Red)),
        Kind::Fault => ("↯", colour(AnsiColor::Red).bold()),
        Kind::State => ("●", state_style(moment.state).bold()),
        Kind::Driver => ("↻", colour(AnsiColor::Cyan).bold()),
    };
    let tec = moment.tec;
    let bar = if tec > 0 { format!("{:>3} {}", tec, bar(tec)) } else { String::from("  0") };
    let level = match tec {
        0 => DIM,
        _ if state_at(story, moment.time) == ErrorState::BusOff => colour(AnsiColor::Red),
        PASSIVE.. => colour(AnsiColor::Yellow),
        _ => colour(AnsiColor::Green),
    };
    let time = milliseconds(moment.time);
    let name = story.nodes[moment.node].name;
    writeln!(
        out,
        "  {DIM}{time:>9}{DIM:#}  {node}{name:<7}{node:#}{style}{mark} {:<TEXT$}{style:#} {level}{bar}{level:#}",
        moment.text
    )
}

fn colour(colour: AnsiColor) -> Style {
    Style::new().fg_color(Some(Color::Ansi(colour)))
}

fn state_style(state: Option<ErrorState>) -> Style {
    colour(match state {
        None | Some(ErrorState::Passive) => AnsiColor::Yellow,
        Some(ErrorState::Active) => AnsiColor::Green,
        Some(ErrorState::BusOff) => AnsiColor::Red,
    })
}

fn state_at(story: &Story, time: Time) -> ErrorState {
    let states = story.states(MOTOR);
    states[states.partition_point(|(from, _)| *from <= time).saturating_sub(1)].1
}

/// A bar whose full length is bus off, in eighths of a cell.
fn bar(value: u16) -> String {
    let eighths = (u32::from(value) * u32::from(CELLS) * 8 / u32::from(BUS_OFF)).max(1);
    let mut bar = "█".repeat(eighths as usize / 8);
    let rest = ["", "▏", "▎", "▍", "▌", "▋", "▊", "▉"];
    bar += rest[eighths as usize % 8];
    bar
}

/// What was written and what opens it.
#[must_use]
pub fn files(story: &Story) -> String {
    let mut out = String::from("\n");
    let width = story.files.iter().map(|path| path.display().to_string().len()).max().unwrap_or(0);
    for path in &story.files {
        let opens = match path.extension().and_then(|extension| extension.to_str()) {
            Some("html") => "the whole story with pictures and every register access: any browser",
            Some("vcd") => "the bus and every node's pins: GTKWave, PulseView",
            Some("pcapng") => "the frames: Wireshark, tshark",
            _ => "the frames: canplayer and other can-utils",
        };
        let _ = writeln!(out, "{BOLD}{:<width$}{BOLD:#}  {opens}", path.display().to_string());
    }
    out
}
