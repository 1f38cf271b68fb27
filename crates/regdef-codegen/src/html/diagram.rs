//! Bit-field diagrams as inline SVG.

use std::fmt::Write as _;

use regdef::model::{Field, Reset};

use super::access;
use super::text::{bit_range, bits, escape};

/// One run of bits with a name.
struct Cell {
    lsb: u32,
    width: u32,
    label: String,
    code: String,
    class: &'static str,
    link: String,
    title: String,
}

/// How a diagram is laid out.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    /// Bits in one row.
    pub columns: u32,
    /// Width of a bit in units of the drawing; a letter of the names takes 0.6 of the type size.
    pub cell: u32,
    /// Class of the drawing: which screens show it.
    pub class: &'static str,
}

/// The layouts of a register's own page: 16 bits in a row, and 8 for narrow screens.
pub(super) const PAGE: [Layout; 2] =
    [Layout { columns: 16, cell: 62, class: "wide" }, Layout { columns: 8, cell: 44, class: "narrow" }];

/// The layout of a message word as one row of a picture of the whole element, equally wide for words of any width.
pub(super) const fn row(word_width: u32) -> Layout {
    Layout { columns: word_width, cell: 32 * 36 / word_width, class: "row" }
}

const HEAD: u32 = 18;
const BOX: u32 = 44;
const FOOT: u32 = 20;

/// Draws the fields of a register or word. `name` is what a screen reader says, `link` gives a field's address.
pub(super) fn draw(
    layout: Layout,
    name: &str,
    width: u32,
    fields: &[Field],
    reset: Option<Reset>,
    link: impl Fn(usize) -> String,
) -> String {
    let cells = cells(fields, link);
    let columns = layout.columns.min(width);
    let rows = width.div_ceil(columns);
    let foot = if reset.is_some() { FOOT } else { 4 };
    let pitch = HEAD + BOX + foot + if rows > 1 { 6 } else { 0 };
    let (total_width, total_height) = (columns * layout.cell + 2, rows * pitch);
    let mut svg = format!(
        "<svg class=\"bits {}\" viewBox=\"0 0 {total_width} {total_height}\" role=\"img\" aria-label=\"{}\">",
        layout.class,
        escape(&format!(
            "Bit fields of {name}, most significant bit first; the table of fields says the same in words"
        )),
    );
    let reset_bits = reset.map(|r| bits(r, width));
    for row in 0..rows {
        let top = row * pitch;
        let high = width - 1 - row * columns;
        let low = (high + 1).saturating_sub(columns);
        let x = |bit: u32| 1 + (high - bit) * layout.cell;
        for bit in (low..=high).rev() {
            let centre = x(bit) + layout.cell / 2;
            let _ = write!(svg, "<text class=\"no\" x=\"{centre}\" y=\"{}\">{bit}</text>", top + 13);
            if let Some(reset_bits) = &reset_bits {
                let value = reset_bits[(width - 1 - bit) as usize];
                let class = if value == 'x' { "rs un" } else { "rs" };
                let y = top + HEAD + BOX + 15;
                let _ = write!(svg, "<text class=\"{class}\" x=\"{centre}\" y=\"{y}\">{value}</text>");
            }
        }
        let mut next = high + 1;
        let mut in_row: Vec<_> = cells.iter().filter(|c| c.lsb <= high && c.lsb + c.width > low).collect();
        in_row.sort_by_key(|c| std::cmp::Reverse(c.lsb));
        for cell in in_row {
            let (first, last) = ((cell.lsb + cell.width - 1).min(high), cell.lsb.max(low));
            if first + 1 < next {
                gap(&mut svg, x(next - 1), top + HEAD, (next - first - 1) * layout.cell);
            }
            piece(&mut svg, layout, cell, (first, last), x(first), top + HEAD);
            next = last;
        }
        if next > low {
            gap(&mut svg, x(next - 1), top + HEAD, (next - low) * layout.cell);
        }
    }
    svg.push_str("</svg>");
    svg
}

fn cells(fields: &[Field], link: impl Fn(usize) -> String) -> Vec<Cell> {
    let mut all = Vec::new();
    for (index, field) in fields.iter().enumerate() {
        for lane in 0..field.lane_count() {
            let (lsb, label) = (field.lane_lsb(lane), field.label_of(0, lane));
            all.push(Cell {
                lsb,
                width: field.width,
                title: format!("{label}, bits {}, {}", bit_range(lsb, field.width), access::words(field.access.code)),
                label,
                code: access::cell(&field.access),
                class: field.access.code.as_str(),
                link: link(index),
            });
        }
    }
    all
}

fn gap(svg: &mut String, x: u32, y: u32, width: u32) {
    let middle = x + width / 2;
    let _ = write!(
        svg,
        "<rect class=\"f-none\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{BOX}\"/>\
         <text class=\"none\" x=\"{middle}\" y=\"{}\">–</text>",
        y + BOX / 2 + 4
    );
}

/// The bits `first` to `last` of a cell, as one row shows them.
fn piece(svg: &mut String, layout: Layout, cell: &Cell, (first, last): (u32, u32), x: u32, y: u32) {
    let width = (first - last + 1) * layout.cell;
    let whole = first - last + 1 == cell.width;
    let range = bit_range(last - cell.lsb, first - last + 1);
    let label = match (whole, cell.width) {
        (true, 1) => cell.label.clone(),
        (true, wide) => format!("{}[{}:0]", cell.label, wide - 1),
        (false, _) => format!("{}[{range}]", cell.label),
    };
    // A label with brackets of its own (`MM[7:0]`) needs no second pair.
    let label = if whole && cell.label.contains('[') { cell.label.clone() } else { label };
    let short = if fits(&label, width).is_some() { label } else { cell.label.clone() };
    let (text, size) = match fits(&short, width) {
        Some(size) => (short, size),
        None => {
            let letters = (width.saturating_sub(4) * 10 / 51).max(2) as usize;
            (short.chars().take(letters - 1).chain(['…']).collect(), 85)
        }
    };
    let middle = x + width / 2;
    let _ = write!(
        svg,
        "<a href=\"{}\" tabindex=\"-1\"><title>{}</title>\
         <rect class=\"f-{}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{BOX}\"/>\
         <text class=\"fn\" style=\"font-size:{}.{}px\" x=\"{middle}\" y=\"{}\">{}</text>",
        escape(&cell.link),
        escape(&cell.title),
        cell.class,
        size / 10,
        size % 10,
        y + 19,
        escape(&text),
    );
    let code = if fits_at(&cell.code, width, 100) { cell.code.as_str() } else { cell.class };
    let _ = write!(svg, "<text class=\"ac\" x=\"{middle}\" y=\"{}\">{}</text></a>", y + 35, escape(code));
}

/// The type size, in tenths of a unit, at which a label fits.
fn fits(label: &str, width: u32) -> Option<u32> {
    [135, 125, 115, 105, 95, 85].into_iter().find(|&size| fits_at(label, width, size))
}

fn fits_at(label: &str, width: u32, size: u32) -> bool {
    u32::try_from(label.chars().count()).is_ok_and(|letters| letters * size * 6 / 100 + 4 <= width)
}

#[cfg(test)]
mod tests {
    use super::fits;

    #[test]
    fn long_names_get_smaller_type() {
        assert_eq!(fits("INIT", 62), Some(135));
        assert_eq!(fits("RXOVIE31", 62), Some(115));
        assert_eq!(fits("A_NAME_THAT_IS_LONG", 62), None);
    }
}
