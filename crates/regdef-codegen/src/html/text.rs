//! Text of the description made into HTML: escaping, links in prose, citations, numbers.

use minijinja::Value;
use regdef::model::{Cite, ConditionId, FieldRef, RegisterId, Reset, Target, bit_mask};

use super::book::{Book, label};

/// Words of the trade that are also names of registers; in prose they are meant as words.
const WORDS: &[&str] = &["CAN", "CPU", "DMA", "FIFO", "ID", "INT", "RAM"];

/// Text with the characters escaped that mean something in HTML, in content and in quoted attributes.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 8);
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // Neither may stand in an HTML document.
            c if c.is_control() && !matches!(c, '\n' | '\t') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Escaped text with what stands in backticks in the type of code.
pub(super) fn code(text: &str) -> String {
    let piece = |(index, piece): (usize, &str)| {
        let piece = escape(piece);
        if index % 2 == 1 { format!("<code>{piece}</code>") } else { piece }
    };
    text.split('`').enumerate().map(piece).collect()
}

/// HTML that a template puts out as it is.
pub(super) fn safe(html: impl Into<String>) -> Value {
    Value::from_safe_string(html.into())
}

/// A link; `text` is plain.
pub(super) fn link(to: &str, text: &str) -> String {
    format!("<a href=\"{}\">{}</a>", escape(to), escape(text))
}

/// A link in the type of names of code.
pub(super) fn code_link(to: &str, text: &str) -> String {
    format!("<a class=\"n\" href=\"{}\">{}</a>", escape(to), escape(text))
}

impl Book<'_> {
    /// `REG.FIELD` as a link.
    pub fn field_link(&self, at: FieldRef) -> String {
        code_link(&self.field(at), &self.model.field_path(at))
    }

    /// A register as a link.
    pub fn register_link(&self, id: RegisterId) -> String {
        code_link(&self.register(id), &label(self.model, self.model.register(id)))
    }

    /// A condition as a link, named ones by name.
    pub fn condition_link(&self, id: ConditionId) -> String {
        code_link(&self.condition(id), &self.model.condition(id).name)
    }

    /// What a conflict or choice is about, as a link.
    pub fn target_link(&self, target: Target) -> String {
        let (to, name) = self.target(target);
        code_link(&to, &name)
    }

    /// Prose in one piece: escaped, `code` in backticks, names of registers and fields as links.
    pub fn inline(&self, text: &str, here: Option<RegisterId>) -> String {
        let mut out = String::new();
        for (index, piece) in text.trim().split('`').enumerate() {
            let code = index % 2 == 1;
            if code {
                out.push_str("<code>");
            }
            self.words(&mut out, piece, here);
            if code {
                out.push_str("</code>");
            }
        }
        // An odd number of backticks leaves the last piece open; the last piece is then code to its end, which
        // is closed above.
        out
    }

    /// Prose as paragraphs.
    pub fn paragraphs(&self, text: &str, here: Option<RegisterId>) -> String {
        let parts = text.split("\n\n").map(str::trim).filter(|p| !p.is_empty());
        parts.map(|p| format!("<p>{}</p>", self.inline(p, here))).collect()
    }

    fn words(&self, out: &mut String, text: &str, here: Option<RegisterId>) {
        let part_of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut rest = text;
        while !rest.is_empty() {
            let start = rest.find(part_of_name).unwrap_or(rest.len());
            out.push_str(&escape(&rest[..start]));
            rest = &rest[start..];
            let mut end = rest.find(|c| !part_of_name(c)).unwrap_or(rest.len());
            if rest[end..].starts_with('.') {
                let field = &rest[end + 1..];
                let length = field.find(|c| !part_of_name(c)).unwrap_or(field.len());
                if length > 0 && self.named(&rest[..end + 1 + length], here).is_some() {
                    end += 1 + length;
                }
            }
            let (name, behind) = rest.split_at(end);
            rest = behind;
            let is_name =
                name.len() > 1 && name.starts_with(|c: char| c.is_ascii_uppercase()) && !WORDS.contains(&name);
            match self.named(name, here).filter(|_| is_name) {
                Some(Target::Register(id)) if Some(id) == here => out.push_str(&escape(name)),
                Some(target) => out.push_str(&code_link(&self.target(target).0, name)),
                None => out.push_str(&escape(name)),
            }
        }
    }

    /// Citations in one line; those of sources outside the manual carry a mark in words.
    pub fn cites(&self, cites: &[Cite]) -> String {
        cites.iter().map(|c| self.cite(c)).collect::<Vec<_>>().join("; ")
    }

    fn cite(&self, cite: &Cite) -> String {
        let mut parts = Vec::new();
        if let Some(section) = &cite.section {
            parts.push(format!("§\u{202f}{}", escape(section)));
        }
        for (word, value) in [
            ("Register", &cite.register),
            ("Table", &cite.table),
            ("Figure", &cite.figure),
            ("Example", &cite.example),
            ("Equation", &cite.equation),
        ] {
            if let Some(value) = value {
                parts.push(format!("{word}\u{a0}{}", escape(value)));
            }
        }
        if let Some(page) = cite.page {
            parts.push(format!("p.\u{a0}{page}"));
        }
        let mut text = parts.join(", ");
        if let Some(key) = &cite.source {
            let title = self.model.sources.get(key).map_or(key.as_str(), |s| s.title.as_str());
            let source = format!("<span class=\"ext\">outside the manual</span> {}", link(&Book::source(key), title));
            text = if text.is_empty() { source } else { format!("{source}, {text}") };
        }
        if let Some(subject) = &cite.subject {
            text = format!("for the {}: {text}", escape(subject));
        }
        if let Some(note) = &cite.note {
            text = if text.is_empty() { escape(note) } else { format!("{text} ({})", escape(note)) };
        }
        format!("<span class=\"cite\">{text}</span>")
    }
}

/// An address: at least three hexadecimal digits.
pub(super) fn offset(value: u64) -> String {
    format!("0x{value:03X}")
}

/// A value with as many hexadecimal digits as its width needs.
pub(super) fn hex(value: u64, width: u32) -> String {
    format!("0x{value:0digits$X}", digits = width.div_ceil(4) as usize)
}

/// A reset value: hexadecimal if every digit is known or, as `?`, unknown as a whole; otherwise binary.
pub(super) fn reset(reset: Reset, width: u32) -> String {
    if reset.unknown == bit_mask(0, width) {
        return "unknown".to_owned();
    }
    let nibbles = (0..width.div_ceil(4)).rev();
    let unknown_of = |n: u32| reset.unknown >> (4 * n) & 0xF;
    if nibbles.clone().all(|n| matches!(unknown_of(n), 0 | 0xF)) {
        let digit = |n| if unknown_of(n) == 0 { format!("{:X}", reset.value >> (4 * n) & 0xF) } else { "?".to_owned() };
        return format!("0x{}", nibbles.map(digit).collect::<String>());
    }
    format!("0b{}", bits(reset, width).chunks(4).map(|c| c.iter().collect::<String>()).collect::<Vec<_>>().join("_"))
}

/// The bits of a reset value, most significant first: `0`, `1`, `x`.
pub(super) fn bits(reset: Reset, width: u32) -> Vec<char> {
    let bit = |n: u32| match (reset.unknown >> n & 1, reset.value >> n & 1) {
        (1, _) => 'x',
        (_, 1) => '1',
        _ => '0',
    };
    (0..width).rev().map(bit).collect()
}

/// `7:0`, or `5` for one bit.
pub(super) fn bit_range(lsb: u32, width: u32) -> String {
    if width == 1 { lsb.to_string() } else { format!("{}:{lsb}", lsb + width - 1) }
}

#[cfg(test)]
mod tests {
    use super::{Reset, escape, reset};

    #[test]
    fn escaping_covers_content_and_attributes() {
        assert_eq!(escape("<a href=\"x\" o='y'>&\u{0}"), "&lt;a href=&quot;x&quot; o=&#39;y&#39;&gt;&amp;\u{fffd}");
    }

    #[test]
    fn unknown_bits_show() {
        assert_eq!(reset(Reset { value: 0x12, unknown: 0xF00 }, 16), "0x0?12");
        assert_eq!(reset(Reset { value: 0x2, unknown: 0x1 }, 8), "0b0000_001x");
        assert_eq!(reset(Reset { value: 0xA33, unknown: 0 }, 32), "0x00000A33");
    }
}
