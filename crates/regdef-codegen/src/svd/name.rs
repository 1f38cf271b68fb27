//! Names as SVD allows them, and the indices of `dim` elements.

use regdef::model::{Dim, Lanes};
use svd_rs::DimElement;

use super::{At, Error, LEVEL, offset32};
use crate::text;

/// A name of letters, digits and underscores that does not begin with a digit.
pub(super) fn identifier(name: &str) -> String {
    let mut text: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    while text.ends_with('_') && text.len() > 1 {
        text.pop();
    }
    if text.starts_with(|c: char| c.is_ascii_digit()) { format!("_{text}") } else { text }
}

/// A label whose `{n}`, or whose end, is the place of the index.
pub(super) fn indexed(label: &str) -> String {
    let (before, after) = text::split_label(label);
    let clean = |part: &str| part.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect::<String>();
    let before = clean(before);
    let before = if before.starts_with(|c: char| c.is_ascii_digit()) { format!("_{before}") } else { before };
    format!("{before}%s{}", clean(after))
}

/// The name of an array and its `dim` element.
pub(super) fn array(label: &str, dim: &Dim) -> Result<(String, DimElement), Error> {
    let (name, indices) = if dim.labels.is_empty() {
        (indexed(label), numbers(dim.first, dim.count))
    } else {
        let labels: Vec<String> = dim.labels.iter().map(|label| identifier(label)).collect();
        let (before, after) = frame(&labels);
        let index = labels.iter().map(|label| label[before..label.len() - after].to_owned()).collect();
        (format!("{}%s{}", &labels[0][..before], &labels[0][labels[0].len() - after..]), index)
    };
    let element = element(label, dim.count, offset32(label, dim.stride)?, indices)?;
    Ok((name, element))
}

/// The `dim` element of lanes in the register at `position` of its array.
pub(super) fn lanes(label: &str, lanes: Lanes, position: u32) -> Result<DimElement, Error> {
    element(label, lanes.count, lanes.stride, numbers(lanes.first + position * lanes.count, lanes.count))
}

fn element(at: &str, count: u32, increment: u32, indices: Vec<String>) -> Result<DimElement, Error> {
    DimElement::builder().dim(count).dim_increment(increment).dim_index(Some(indices)).build(LEVEL).at(at)
}

fn numbers(first: u32, count: u32) -> Vec<String> {
    (first..first + count).map(|n| n.to_string()).collect()
}

/// Lengths of what all names begin and end with, so that something is left of each between the two.
fn frame(names: &[String]) -> (usize, usize) {
    let shortest = names.iter().map(String::len).min().unwrap_or(0);
    let same = |pick: &dyn Fn(&String) -> Option<u8>| names.iter().all(|name| pick(name) == pick(&names[0]));
    let before = (0..shortest.saturating_sub(1)).take_while(|&i| same(&|name| name.as_bytes().get(i).copied())).count();
    let room = shortest.saturating_sub(before + 1);
    let after = (0..room).take_while(|&i| same(&|name| name.bytes().nth_back(i))).count();
    (before, after)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_identifiers() {
        assert_eq!(identifier("MM[7:0]"), "MM_7_0");
        assert_eq!(identifier("12 bytes"), "_12_bytes");
        assert_eq!(indexed("F{n}BP"), "F%sBP");
        assert_eq!(indexed("TXREQ"), "TXREQ%s");
    }

    #[test]
    fn own_labels_are_split_around_what_differs() {
        let of = |names: &[&str]| frame(&names.iter().map(|&n| n.to_owned()).collect::<Vec<_>>());
        assert_eq!(of(&["TR01CON", "TR23CON"]), (2, 3));
        assert_eq!(of(&["RXF", "RXF1"]), (2, 0));
        assert_eq!(of(&["AL", "BH"]), (0, 0));
    }
}
