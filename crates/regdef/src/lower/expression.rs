//! The grammar of conditions.
//!
//! ```text
//! any     = all ("||" all)*
//! all     = not ("&&" not)*
//! not     = "!" not | "(" any ")" | compare
//! compare = operand (("==" | "!=" | "<=" | ">=" | "<" | ">") (number | name))?
//! operand = NAME ("." NAME)? ("[" (number | "n") "]")?
//! ```

use std::ops::Range;

use crate::model::{Comparison, LaneIndex};
use crate::syntax::Int;

/// An expression before its names are resolved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Parsed {
    Not(Box<Parsed>),
    All(Vec<Parsed>),
    Any(Vec<Parsed>),
    /// A name alone: another condition.
    Name(String),
    Compare {
        register: String,
        field: String,
        index: LaneIndex,
        comparison: Comparison,
        value: Literal,
    },
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Literal {
    Number(u64),
    Name(String),
}

/// What is wrong, and where in the expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Problem {
    pub at: Range<usize>,
    pub what: String,
}

/// Deepest nesting of parentheses and negations.
const MAX_DEPTH: usize = 32;

#[derive(Debug, Clone, PartialEq, Eq)]
enum Token {
    Word(String),
    Number(u64),
    Operator(&'static str),
}

struct Parser {
    tokens: Vec<(Token, Range<usize>)>,
    at: usize,
    end: usize,
}

/// Longest expression in bytes.
const MAX_LENGTH: usize = 2000;

pub(super) fn parse(text: &str) -> Result<Parsed, Problem> {
    if text.len() > MAX_LENGTH {
        return Err(Problem { at: 0..0, what: format!("it is longer than {MAX_LENGTH} bytes") });
    }
    let mut parser = Parser { tokens: tokenize(text)?, at: 0, end: text.len() };
    let parsed = parser.any(0)?;
    match parser.tokens.get(parser.at) {
        None => Ok(parsed),
        Some((_, range)) => Err(Problem { at: range.clone(), what: "the expression should end here".to_owned() }),
    }
}

fn tokenize(text: &str) -> Result<Vec<(Token, Range<usize>)>, Problem> {
    const OPERATORS: [&str; 15] = ["&&", "||", "==", "!=", "<=", ">=", "<", ">", "!", "(", ")", "[", "]", ".", "-"];
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        if letter.is_whitespace() {
            at += letter.len_utf8();
        } else if letter.is_ascii_alphanumeric() || letter == '_' {
            let length = text[at..].find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len() - at);
            let word = &text[at..at + length];
            let token = match Int::parse(word) {
                Some(number) => Token::Number(number),
                None => Token::Word(word.to_owned()),
            };
            tokens.push((token, at..at + length));
            at += length;
        } else if let Some(operator) = OPERATORS.iter().find(|o| text[at..].starts_with(**o)) {
            tokens.push((Token::Operator(operator), at..at + operator.len()));
            at += operator.len();
        } else {
            let range = at..at + letter.len_utf8();
            return Err(Problem { at: range, what: format!("`{letter}` means nothing in a condition") });
        }
    }
    Ok(tokens)
}

impl Parser {
    fn take(&mut self, operator: &str) -> bool {
        let found = matches!(self.tokens.get(self.at), Some((Token::Operator(o), _)) if *o == operator);
        self.at += usize::from(found);
        found
    }

    fn problem<T>(&self, what: &str) -> Result<T, Problem> {
        let at = self.tokens.get(self.at).map_or(self.end..self.end, |(_, range)| range.clone());
        Err(Problem { at, what: what.to_owned() })
    }

    fn any(&mut self, depth: usize) -> Result<Parsed, Problem> {
        self.list("||", depth, Self::all, Parsed::Any)
    }

    fn all(&mut self, depth: usize) -> Result<Parsed, Problem> {
        self.list("&&", depth, Self::not, Parsed::All)
    }

    fn list(
        &mut self,
        operator: &str,
        depth: usize,
        item: fn(&mut Self, usize) -> Result<Parsed, Problem>,
        join: fn(Vec<Parsed>) -> Parsed,
    ) -> Result<Parsed, Problem> {
        let first = item(self, depth)?;
        let mut items = vec![first];
        while self.take(operator) {
            items.push(item(self, depth)?);
        }
        Ok(if items.len() == 1 { items.remove(0) } else { join(items) })
    }

    fn not(&mut self, depth: usize) -> Result<Parsed, Problem> {
        if depth > MAX_DEPTH {
            return self.problem("the expression is nested too deeply");
        }
        if self.take("!") {
            return Ok(Parsed::Not(Box::new(self.not(depth + 1)?)));
        }
        if self.take("(") {
            let inner = self.any(depth + 1)?;
            return if self.take(")") { Ok(inner) } else { self.problem("a `)` is missing here") };
        }
        self.compare()
    }

    fn word(&mut self, what: &str) -> Result<String, Problem> {
        match self.tokens.get(self.at) {
            Some((Token::Word(word), _)) => {
                self.at += 1;
                Ok(word.clone())
            }
            _ => self.problem(what),
        }
    }

    fn compare(&mut self) -> Result<Parsed, Problem> {
        let register = self.word("a field (`REG.FIELD`) or the name of a condition is expected here")?;
        if !self.take(".") {
            return Ok(Parsed::Name(register));
        }
        let field = self.word("the name of a field is expected here")?;
        let index = if self.take("[") {
            let index = match self.tokens.get(self.at) {
                Some((Token::Number(number), _)) => match u32::try_from(*number) {
                    Ok(number) => LaneIndex::Fixed(number),
                    Err(_) => return self.problem("this number of a lane is too large"),
                },
                Some((Token::Word(word), _)) if word == "n" => LaneIndex::Own,
                _ => return self.problem("the number of a lane, or `n` for the own one, is expected here"),
            };
            self.at += 1;
            if !self.take("]") {
                return self.problem("a `]` is missing here");
            }
            index
        } else {
            LaneIndex::Single
        };
        const COMPARISONS: [Comparison; 6] = [
            Comparison::Equal,
            Comparison::NotEqual,
            Comparison::LessOrEqual,
            Comparison::GreaterOrEqual,
            Comparison::Less,
            Comparison::Greater,
        ];
        let (comparison, value) = match COMPARISONS.into_iter().find(|c| self.take(c.as_str())) {
            None => (Comparison::NotEqual, Literal::Number(0)),
            Some(comparison) => {
                let value = match self.tokens.get(self.at) {
                    Some((Token::Number(number), _)) => Literal::Number(*number),
                    Some((Token::Word(word), _)) => Literal::Name(word.clone()),
                    _ => return self.problem("a number or the name of a value is expected here"),
                };
                self.at += 1;
                (comparison, value)
            }
        };
        Ok(Parsed::Compare { register, field, index, comparison, value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn precedence_and_shorthand() {
        let Parsed::Any(any) = parse("A.B && !(C.D == on || E) || F.G[n] != 0x1_0").expect("well formed") else {
            panic!("`||` binds weakest");
        };
        assert!(matches!(&any[0], Parsed::All(all) if all.len() == 2));
        assert!(matches!(&any[1], Parsed::Compare { index: LaneIndex::Own, value: Literal::Number(16), .. }));
        assert!(matches!(
            parse("A.B").expect("well formed"),
            Parsed::Compare { comparison: Comparison::NotEqual, value: Literal::Number(0), .. }
        ));
    }

    #[test]
    fn problems_have_places() {
        for (text, at) in
            [("A.B &&", 6), ("A.B = 1", 4), ("(A.B", 4), ("A.", 2), ("A.B C.D", 4), ("A.B[x]", 4), ("", 0)]
        {
            assert_eq!(parse(text).expect_err(text).at.start, at, "{text}");
        }
        let deep = "!".repeat(100_000) + "A.B";
        assert!(parse(&deep).is_err());
        let deep = "(".repeat(100_000);
        assert!(parse(&deep).is_err());
    }
}
