//! Conditions as trees over fields.

use super::{Cite, Field, FieldRef, MessageId, Model};

/// A condition on the state of the registers.
#[derive(Debug, Clone)]
pub struct Condition {
    /// Its name; for a condition written at a field, the expression itself.
    pub name: String,
    /// Whether it stands under `conditions`, so that other places can link to it.
    pub named: bool,
    /// The expression as written.
    pub text: String,
    /// What it means; for a condition without a description, the expression.
    pub doc: String,
    /// The tree, with names of other conditions resolved.
    pub expr: Expr,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// A truth value over the fields of the controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Expr {
    /// Always true.
    Always,
    /// A field compared with a number.
    Compare {
        /// The field.
        field: FieldRef,
        /// Which element or lane, for a field that has several.
        index: LaneIndex,
        /// How.
        comparison: Comparison,
        /// With what.
        value: u64,
    },
    /// A field of a word of the message that the condition stands in, compared with a number.
    Word {
        /// The message.
        message: MessageId,
        /// Index into the message's words.
        word: usize,
        /// Index into the word's fields.
        field: usize,
        /// How.
        comparison: Comparison,
        /// With what.
        value: u64,
    },
    /// Not true.
    Not(Box<Expr>),
    /// All are true.
    All(Vec<Expr>),
    /// At least one is true.
    Any(Vec<Expr>),
}

/// Which element or lane of a repeated field a condition looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LaneIndex {
    /// The field is not repeated, or the register is the one being written.
    Single,
    /// The one with the number of the register element or lane being written: `[n]`.
    Own,
    /// A fixed number, as the manual counts: `[3]`.
    Fixed(u32),
}

/// A comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

impl Comparison {
    /// The operator as it is written.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
        }
    }
}

impl Expr {
    /// Every field of a register the expression looks at.
    pub fn fields(&self) -> Vec<FieldRef> {
        match self {
            Self::Always | Self::Word { .. } => Vec::new(),
            Self::Compare { field, .. } => vec![*field],
            Self::Not(inner) => inner.fields(),
            Self::All(of) | Self::Any(of) => of.iter().flat_map(Self::fields).collect(),
        }
    }

    /// The expression in the notation of the description, with names of enumerations where there are some.
    #[must_use]
    pub fn display(&self, model: &Model) -> String {
        self.render(model, false)
    }

    fn render(&self, model: &Model, nested: bool) -> String {
        let join = |of: &[Self], operator: &str| {
            let text = of.iter().map(|e| e.render(model, true)).collect::<Vec<_>>().join(operator);
            if nested { format!("({text})") } else { text }
        };
        match self {
            Self::Always => "always".to_owned(),
            Self::Not(inner) => format!("!{}", inner.render(model, true)),
            Self::All(of) => join(of, " && "),
            Self::Any(of) => join(of, " || "),
            Self::Compare { field, index, comparison, value } => {
                let path = model.field_path(*field);
                let path = match index {
                    LaneIndex::Single => path,
                    LaneIndex::Own => format!("{path}[n]"),
                    LaneIndex::Fixed(n) => format!("{path}[{n}]"),
                };
                compared(model, path, model.field(*field), *comparison, *value)
            }
            Self::Word { message, word, field, comparison, value } => {
                let word = &model.messages[message.0].words[*word];
                let field = &word.fields[*field];
                compared(model, format!("{}.{}", word.name, field.name), field, *comparison, *value)
            }
        }
    }
}

fn compared(model: &Model, path: String, field: &Field, comparison: Comparison, value: u64) -> String {
    if field.width == 1 && field.enumeration().is_none() && comparison == Comparison::Equal {
        return if value == 1 { path } else { format!("!{path}") };
    }
    let name = field.enumeration().and_then(|id| model.enumeration(id).variant(value)).map(|v| v.name.clone());
    format!("{path} {} {}", comparison.as_str(), name.unwrap_or_else(|| value.to_string()))
}
