//! The bit, drawn.

use std::fmt::Write;

use can_hal::timing::Segments;

/// Width of a bit in characters.
const COLUMNS: u32 = 72;

/// A part of a bit: its name, its quanta, its colour.
type Part = (&'static str, u32, &'static str);

fn parts(segments: &Segments) -> [Part; 4] {
    [
        ("SYNC", Segments::SYNC, "#8d99ae"),
        ("PROP", segments.propagation, "#a8dadc"),
        ("PH1", segments.phase1, "#457b9d"),
        ("PH2", segments.phase2, "#e9c46a"),
    ]
}

/// A bit as text: the segments to scale, the sample point below.
pub fn text(segments: &Segments) -> String {
    let quanta = segments.quanta();
    let column = |at: u32| at * COLUMNS / quanta;
    let (mut line, mut at) = (String::new(), 0);
    for (name, length, _) in parts(segments) {
        let width = (column(at + length) - column(at)) as usize;
        if width > 0 {
            let label = [format!("{name} {length}"), name.to_owned(), String::new()];
            let label = label.into_iter().find(|label| label.len() < width).unwrap_or_default();
            line.push('|');
            write!(line, "{label:-^0$}", width - 1).ok();
        }
        at += length;
    }
    line.push('|');
    let sample = column(segments.before_sample()) as usize;
    format!("  {line}\n  {:sample$}^ sample point, {} of {quanta} quanta\n", "", segments.before_sample())
}

/// Bits as an SVG image, one below the other, each with a title.
pub fn svg(bits: &[(String, Segments)]) -> String {
    const WIDTH: u32 = 760;
    const LEFT: u32 = 20;
    const ROW: u32 = 110;
    let height = ROW * bits.len() as u32 + 10;
    let full = WIDTH + 2 * LEFT;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {full} {height}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<rect width=\"{full}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for ((title, segments), row) in bits.iter().zip(0..) {
        let (top, quanta) = (row * ROW + 36, segments.quanta());
        let x = |at: u32| f64::from(LEFT) + f64::from(at * WIDTH) / f64::from(quanta);
        writeln!(out, "<text x=\"{LEFT}\" y=\"{}\">{title}</text>", top - 12).ok();
        let mut at = 0;
        for (name, length, colour) in parts(segments) {
            let width = x(at + length) - x(at);
            if length > 0 {
                writeln!(
                    out,
                    "<rect x=\"{:.2}\" y=\"{top}\" width=\"{width:.2}\" height=\"30\" fill=\"{colour}\" \
                     stroke=\"#333\"><title>{name}: {length} time quanta</title></rect>",
                    x(at)
                )
                .ok();
            }
            if width > 48.0 {
                let middle = x(at) + width / 2.0;
                writeln!(
                    out,
                    "<text x=\"{middle:.2}\" y=\"{}\" text-anchor=\"middle\">{name} {length}</text>",
                    top + 20
                )
                .ok();
            }
            at += length;
        }
        // The quanta, as long as there is room to tell them apart.
        if quanta <= 100 {
            for quantum in 1..quanta {
                let x = x(quantum);
                writeln!(out, "<path d=\"M{x:.2} {}v4\" stroke=\"#333\"/>", top + 26).ok();
            }
        }
        let sample = x(segments.before_sample());
        writeln!(out, "<path d=\"M{sample:.2} {}v42\" stroke=\"#c1121f\" stroke-width=\"2\"/>", top - 4).ok();
        writeln!(
            out,
            "<text x=\"{sample:.2}\" y=\"{}\" text-anchor=\"end\" fill=\"#c1121f\">sample point {}</text>",
            top + 54,
            segments.sample_point()
        )
        .ok();
    }
    out.push_str("</svg>\n");
    out
}
