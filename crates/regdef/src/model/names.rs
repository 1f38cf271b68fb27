//! Identifiers: the one place that turns a manual's name into names of code.

/// An identifier in the spellings that generated code needs.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Ident {
    /// `rxf_sid`: Rust functions and modules, C functions. Never a keyword.
    pub snake: String,
    /// `RxfSid`: Rust types.
    pub pascal: String,
    /// `RXF_SID`: constants and macros.
    pub upper: String,
}

/// Words that no generated Rust or C identifier may be.
const KEYWORDS: &[&str] = &[
    "abstract",
    "alignas",
    "alignof",
    "and",
    "as",
    "asm",
    "async",
    "auto",
    "await",
    "become",
    "bool",
    "box",
    "break",
    "case",
    "catch",
    "char",
    "class",
    "const",
    "continue",
    "crate",
    "default",
    "delete",
    "do",
    "double",
    "dyn",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "final",
    "float",
    "fn",
    "for",
    "friend",
    "gen",
    "goto",
    "if",
    "impl",
    "in",
    "inline",
    "int",
    "let",
    "long",
    "loop",
    "macro",
    "match",
    "mod",
    "move",
    "mut",
    "mutable",
    "namespace",
    "new",
    "not",
    "operator",
    "or",
    "override",
    "priv",
    "private",
    "protected",
    "pub",
    "public",
    "ref",
    "register",
    "restrict",
    "return",
    "self",
    "short",
    "signed",
    "sizeof",
    "static",
    "struct",
    "super",
    "switch",
    "template",
    "this",
    "throw",
    "trait",
    "true",
    "try",
    "type",
    "typedef",
    "typename",
    "typeof",
    "union",
    "unsafe",
    "unsigned",
    "unsized",
    "use",
    "using",
    "virtual",
    "void",
    "volatile",
    "where",
    "while",
    "xor",
    "yield",
];

impl Ident {
    /// Makes an identifier from a name of the manual or from a `name` of the description.
    ///
    /// Letters and digits are kept, everything else separates words. A name in lower case keeps its words;
    /// a name in upper case is one word up to each separator.
    #[must_use]
    pub fn new(name: &str) -> Self {
        let words: Vec<String> = name
            .split(|c: char| !c.is_ascii_alphanumeric())
            .filter(|word| !word.is_empty())
            .map(str::to_ascii_lowercase)
            .collect();
        let mut snake = words.join("_");
        let mut pascal = String::new();
        for word in &words {
            let mut letters = word.chars();
            if pascal.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(|c: char| c.is_ascii_digit()) {
                pascal.push('_');
            }
            pascal.extend(letters.next().map(|c| c.to_ascii_uppercase()));
            pascal.push_str(letters.as_str());
        }
        let upper = snake.to_ascii_uppercase();
        if KEYWORDS.contains(&snake.as_str()) {
            snake.push('_');
        }
        if snake.starts_with(|c: char| c.is_ascii_digit()) {
            snake.insert(0, '_');
        }
        if pascal.starts_with(|c: char| c.is_ascii_digit()) {
            pascal.insert(0, '_');
        }
        if matches!(pascal.as_str(), "Self" | "Result" | "Option" | "Some" | "None" | "Ok" | "Err") {
            pascal.push('_');
        }
        let upper = if upper.starts_with(|c: char| c.is_ascii_digit()) { format!("_{upper}") } else { upper };
        Self { snake, pascal, upper }
    }

    /// The identifier of a cluster's member as seen from the cluster: `fifo_con` in `fifo` is `con`.
    #[must_use]
    pub fn within(&self, outer: &Self) -> Self {
        match self.snake.strip_prefix(&outer.snake).and_then(|rest| rest.strip_prefix('_')) {
            Some(rest) if !rest.is_empty() => Self::new(rest),
            _ => self.clone(),
        }
    }
}

/// Names of the controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// `m_can`: the key in the description and the stem of files.
    pub id: String,
    /// `m-can-pac`: the generated crate.
    pub krate: String,
    /// Spellings in code: `m_can`, `MCan`, `M_CAN`.
    pub ident: Ident,
}

impl Names {
    /// Names from the controller's identifier.
    #[must_use]
    pub fn new(id: &str) -> Self {
        Self { id: id.to_owned(), krate: format!("{}-pac", id.replace('_', "-")), ident: Ident::new(id) }
    }
}

#[cfg(test)]
mod tests {
    use super::Ident;

    #[test]
    fn spellings() {
        for (name, snake, pascal, upper) in [
            ("CCCR", "cccr", "Cccr", "CCCR"),
            ("fifo_con", "fifo_con", "FifoCon", "FIFO_CON"),
            ("MM[7:0]", "mm_7_0", "Mm7_0", "MM_7_0"),
            ("iso_11898_1", "iso_11898_1", "Iso11898_1", "ISO_11898_1"),
            ("TYPE", "type_", "Type", "TYPE"),
            ("in", "in_", "In", "IN"),
            ("12 bytes", "_12_bytes", "_12Bytes", "_12_BYTES"),
            ("self", "self_", "Self_", "SELF"),
            ("none", "none", "None_", "NONE"),
            ("int", "int_", "Int", "INT"),
            ("R1A", "r1a", "R1a", "R1A"),
        ] {
            let ident = Ident::new(name);
            assert_eq!(
                (ident.snake.as_str(), ident.pascal.as_str(), ident.upper.as_str()),
                (snake, pascal, upper),
                "{name}"
            );
        }
    }

    #[test]
    fn members_lose_the_name_of_their_cluster() {
        let fifo = Ident::new("fifo");
        assert_eq!(Ident::new("fifo_con").within(&fifo).snake, "con");
        assert_eq!(Ident::new("fifocon").within(&fifo).snake, "fifocon");
        assert_eq!(Ident::new("fifo").within(&fifo).snake, "fifo");
    }
}
