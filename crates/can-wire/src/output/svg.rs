//! One frame as a picture: the levels that every node drove and saw over time, with the fields above them.

use core::fmt::Write as _;

use super::{
    FrameCapture,
    timeline::{groups, label},
};
use crate::{BitRecord, Field, NodeId, Role, Time};

/// Width of the shortest bit of the picture, in pixels.
const BIT: f64 = 9.0;
const LEFT: f64 = 96.0;
const RIGHT: f64 = 16.0;
/// Room for the explanation below the picture.
const NARROWEST: f64 = 760.0;
const HEADER: f64 = 76.0;
/// The part of it that the title takes.
const HEADER_TEXT: f64 = 24.0;
/// Height of one waveform and of the space below it.
const WAVE: f64 = 22.0;
const ROW: f64 = 34.0;
const NODE_GAP: f64 = 12.0;

const STYLE: &str = "text{font:12px sans-serif;fill:#1b1f24}.small{font-size:10px;fill:#57606a}\
.wave{fill:none;stroke-width:1.5}.tx{stroke:#0550ae}.rx{stroke:#1a7f37}.field{fill:#eef1f5;stroke:#c4ccd6}\
.fast{fill:#fff1d6}.bad{fill:#ffdcd7}.stuff{fill:#8250df;fill-opacity:.22}.fault{fill:#cf222e;fill-opacity:.35}\
.sample{stroke:#8c959f;stroke-width:.7}.page{fill:#fff}";

/// How a frame is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// Names of the nodes, by their numbers; those without have their number.
    pub names: &'a [&'a str],
    /// For a page that has a style of its own: neither background, title, style nor explanation. The page gives the classes
    /// `field`, `fast`, `bad`, `wave`, `tx`, `rx`, `sample`, `stuff`, `fault` and `small` inside `svg.frame` their looks.
    pub bare: bool,
    /// Width of the shortest bit in pixels.
    pub bit: f64,
}

impl Default for Picture<'_> {
    /// Nodes by their numbers, a picture that stands alone, 9 pixels for the shortest bit.
    fn default() -> Self {
        Picture { names: &[], bare: false, bit: BIT }
    }
}

impl FrameCapture {
    /// The frame as an SVG picture: fields on top, below it for every node what it drove (blue) and saw (green), the
    /// sample points as ticks, stuff bits shaded violet, injected faults red.
    #[must_use]
    pub fn svg(&self) -> String {
        self.draw(&Picture::default())
    }

    /// The same as the caller wants it.
    #[must_use]
    pub fn draw(&self, picture: &Picture<'_>) -> String {
        let reference: Vec<&BitRecord> = self.of(self.reference).collect();
        let nodes = self.nodes();
        let (Some(first), Some(last)) = (reference.first(), reference.last()) else {
            return String::from("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>");
        };
        let shortest = reference.windows(2).map(|pair| pair[1].start.since(pair[0].start).as_ps()).min();
        let shortest = shortest.unwrap_or(1).max(1);
        let end = last.sample + last.sample.since(last.start);
        let scale = Scale { origin: first.start, per_ps: picture.bit / shortest as f64 };
        let (narrowest, below) = if picture.bare { (0.0, 0.0) } else { (NARROWEST, 26.0) };
        let width = (scale.x(end) + RIGHT).max(narrowest);
        let height = HEADER + nodes.len() as f64 * (2.0 * ROW + NODE_GAP) + below;
        let mut svg = String::new();
        let out = &mut svg;
        // Writing to a string cannot fail.
        let above = if picture.bare { HEADER_TEXT } else { 0.0 };
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"frame\" width=\"{width:.0}\" height=\"{0:.0}\" \
             viewBox=\"0 {above:.0} {width:.0} {0:.0}\">",
            height - above
        );
        if !picture.bare {
            let _ = write!(
                out,
                "<style>{STYLE}</style>\n<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n\
                 <text x=\"8\" y=\"18\">{} start of frame at {}</text>\n",
                self.title(),
                first.start
            );
        }
        fields(out, &reference, end, &scale);
        for (index, node) in nodes.iter().enumerate() {
            let top = HEADER + index as f64 * (2.0 * ROW + NODE_GAP);
            let name = picture.names.get(node.index()).map_or_else(|| node.to_string(), |name| escaped(name));
            self.node(out, *node, &name, top, end, &scale);
        }
        if !picture.bare {
            let _ = writeln!(
                out,
                "<text class=\"small\" x=\"8\" y=\"{:.0}\">high is recessive; blue: driven, green: seen; ticks: sample \
                 points; violet: stuff bits; red: injected faults; yellow fields: data bit rate</text>",
                height - 8.0
            );
        }
        svg += "</svg>\n";
        svg
    }

    fn node(&self, out: &mut String, node: NodeId, name: &str, top: f64, end: Time, scale: &Scale) {
        let bits: Vec<&BitRecord> = self.of(node).collect();
        let role = if bits.iter().any(|bit| bit.role == Role::Transmitter) { "transmitter" } else { "receiver" };
        let _ = writeln!(
            out,
            "<text x=\"8\" y=\"{:.0}\">{name}</text><text class=\"small\" x=\"8\" y=\"{:.0}\">{role}</text>",
            top + 16.0,
            top + 30.0
        );
        for (row, class) in [(0.0, "tx"), (1.0, "rx")] {
            let high = top + row * ROW;
            let low = high + WAVE;
            let mut path = String::new();
            for (index, bit) in bits.iter().enumerate() {
                let until = bits.get(index + 1).map_or(end, |next| next.start);
                let (x0, x1) = (scale.x(bit.start), scale.x(until));
                let level = if class == "tx" { bit.driven } else { bit.seen };
                let y = if level.bit() { high } else { low };
                let _ = write!(path, "{}{x0:.1},{y:.1}L{x1:.1},{y:.1}", if index == 0 { "M" } else { "L" });
                let mark = if bit.faulty {
                    "fault"
                } else if bit.position.stuff {
                    "stuff"
                } else {
                    continue;
                };
                let _ = write!(
                    out,
                    "<rect class=\"{mark}\" x=\"{x0:.1}\" y=\"{high:.1}\" width=\"{:.1}\" height=\"{WAVE}\"/>",
                    x1 - x0
                );
            }
            let _ = writeln!(out, "<path class=\"wave {class}\" d=\"{path}\"/>");
            if class == "rx" {
                for bit in &bits {
                    let x = scale.x(bit.sample);
                    let _ = write!(out, "<path class=\"sample\" d=\"M{x:.1},{:.1}V{:.1}\"/>", low + 1.0, low + 5.0);
                }
                out.push('\n');
            }
        }
    }
}

/// A name as text of a picture.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Names of the fields, those with too little room for it written upright.
fn fields(out: &mut String, reference: &[&BitRecord], end: Time, scale: &Scale) {
    let mut data_phase = false;
    for group in groups(reference) {
        let from = scale.x(reference[group.first].start);
        let until = scale.x(reference.get(group.end).map_or(end, |bit| bit.start));
        let signalling = matches!(
            group.field,
            Field::ErrorFlag | Field::ErrorDelimiter | Field::OverloadFlag | Field::OverloadDelimiter
        );
        let class = match () {
            () if signalling => "field bad",
            () if data_phase && group.field < Field::CrcDelimiter => "field fast",
            () => "field",
        };
        if group.field == Field::Brs {
            data_phase = reference[group.first..group.end].iter().any(|bit| !bit.position.stuff && bit.seen.bit());
        }
        let text = label(&group, reference);
        let (x, y) = ((from + until) / 2.0, 48.0);
        let fits = text.len() as f64 * 6.2 < until - from;
        let upright = if fits { String::new() } else { format!(" transform=\"rotate(-90 {x:.1} {y})\"") };
        let dy = if fits { 4 } else { 3 };
        let _ = writeln!(
            out,
            "<rect class=\"{class}\" x=\"{from:.1}\" y=\"26\" width=\"{:.1}\" height=\"44\"/>\
             <text class=\"small\" text-anchor=\"middle\" x=\"{x:.1}\" y=\"{y}\" dy=\"{dy}\"{upright}>{text}</text>",
            until - from
        );
    }
}

struct Scale {
    origin: Time,
    per_ps: f64,
}

impl Scale {
    fn x(&self, time: Time) -> f64 {
        LEFT + (time.as_ps() as f64 - self.origin.as_ps() as f64) * self.per_ps
    }
}
