//! Lines, comments and macros of C.

/// Width that comments are wrapped to.
const WRAP: usize = 116;

/// A growing text.
#[derive(Default)]
pub(super) struct Writer {
    text: String,
}

impl Writer {
    pub(super) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// One empty line, never two.
    pub(super) fn blank(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    pub(super) fn define(&mut self, name: &str, value: &str) {
        self.line(&format!("#define {name} {value}"));
    }

    /// A function that is inlined: head without the storage class, and the lines of the body.
    pub(super) fn function(&mut self, head: &str, body: &[String]) {
        self.line(&format!("static inline {head}"));
        self.line("{");
        for line in body {
            self.line(&format!("    {line}"));
        }
        self.line("}");
    }

    /// A comment of paragraphs; empty ones are left out.
    pub(super) fn comment(&mut self, paragraphs: &[String]) {
        self.indented_comment("", paragraphs);
    }

    pub(super) fn indented_comment(&mut self, indent: &str, paragraphs: &[String]) {
        let lines: Vec<String> =
            paragraphs.iter().flat_map(|text| wrap(&harmless(text), WRAP - indent.len())).collect();
        match lines.as_slice() {
            [] => {}
            [line] => self.line(&format!("{indent}/* {line} */")),
            [first, rest @ ..] => {
                self.line(&format!("{indent}/* {first}"));
                for line in rest {
                    self.line(&format!("{indent} * {line}"));
                }
                self.line(&format!("{indent} */"));
            }
        }
    }

    pub(super) fn finish(self) -> String {
        self.text
    }
}

/// Text that neither ends a comment nor begins one, continues no line and is no trigraph.
fn harmless(text: &str) -> String {
    let text = crate::text::one_line(text).replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?");
    text.chars().map(|c| if c == '\\' { '/' } else { c }).filter(|c| !c.is_control()).collect()
}

/// A comment behind a line; empty without text.
pub(super) fn remark(text: &str) -> String {
    let text = harmless(text);
    if text.is_empty() { text } else { format!(" /* {text} */") }
}

fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width - 6 {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_breaks_out_of_a_comment() {
        let mut out = Writer::default();
        out.comment(&["end */ int x; /* again \\\n ??/ ".to_owned()]);
        assert_eq!(out.finish(), "/* end * / int x; / * again / ? ?/ */\n");
    }

    #[test]
    fn long_comments_are_wrapped() {
        let mut out = Writer::default();
        out.indented_comment("    ", &["word ".repeat(40)]);
        assert!(out.finish().lines().all(|line| line.len() <= WRAP));
    }
}
