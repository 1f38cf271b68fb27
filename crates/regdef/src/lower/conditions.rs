//! Conditions: names and fields of expressions are resolved.

use super::Lowering;
use super::expression::{Literal, Parsed, parse};
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{Comparison, Condition, ConditionId, Expr, Field, FieldRef, LaneIndex, MessageId, Word};
use crate::path::Path;
use crate::syntax;

/// Most comparisons of a condition once the names of others are written out.
const MAX_COMPARISONS: usize = 200;

/// Longest way from one condition through the names of others.
const MAX_NAMES: usize = 32;

/// How far a named condition has been resolved.
#[derive(Debug, Clone, PartialEq)]
enum State {
    Open,
    Busy,
    Done(Option<Expr>),
}

impl Lowering<'_> {
    /// Resolves the named conditions in the order of the file.
    pub(super) fn conditions(&mut self) {
        let text = self.text;
        for (index, name) in text.conditions.keys().enumerate() {
            let at = Path::root().key("conditions").key(name);
            self.check_identifier(name, &at);
            if name == "always" {
                self.find(
                    Diagnostic::new(
                        Code::DuplicateName,
                        Spot::Key(at),
                        "`always` lifts a condition and cannot name one",
                    )
                    .help("choose another name"),
                );
            }
            self.condition_names.insert(name.clone(), ConditionId(index));
        }
        let mut states = vec![State::Open; text.conditions.len()];
        for index in 0..text.conditions.len() {
            self.resolve_named(index, &mut states, &mut Vec::new());
        }
        for (index, (name, condition)) in text.conditions.iter().enumerate() {
            let at = Path::root().key("conditions").key(name);
            let (expression, doc, cite) = match condition {
                syntax::Condition::Expression(text) => (text.clone(), text.clone(), None),
                syntax::Condition::Full(full) => (full.expression.clone(), full.doc.clone(), full.cite.as_ref()),
            };
            let cites = self.cite(cite, &at);
            let expr = match &states[index] {
                State::Done(Some(expr)) => expr.clone(),
                _ => Expr::Always,
            };
            let condition = Condition { name: name.clone(), named: true, text: expression, doc, expr, cites };
            self.out.model.conditions.push(condition);
            self.out.conditions.push(at);
        }
    }

    fn resolve_named(&mut self, index: usize, states: &mut [State], trail: &mut Vec<usize>) -> Option<Expr> {
        match &states[index] {
            State::Done(expr) => return expr.clone(),
            State::Busy => {
                let name = |index: &usize| self.text.conditions.get_index(*index).map_or("", |(name, _)| name.as_str());
                let start = trail.iter().position(|i| *i == index).unwrap_or(0);
                let circle: Vec<_> = trail[start..].iter().chain([&index]).map(name).collect();
                let at = Path::root().key("conditions").key(name(&index));
                let title = format!("the condition `{}` depends on itself", name(&index));
                self.find(
                    Diagnostic::new(Code::ConditionCycle, Spot::Key(at), title)
                        .label(circle.join(" → "))
                        .help("state one of them over fields only"),
                );
                return None;
            }
            State::Open => {}
        }
        states[index] = State::Busy;
        trail.push(index);
        let (name, condition) = self.text.conditions.get_index(index)?;
        let at = Path::root().key("conditions").key(name);
        let (text, at) = match condition {
            syntax::Condition::Expression(text) => (text, at),
            syntax::Condition::Full(full) => (&full.expression, at.key("expression")),
        };
        let expr = if trail.len() > MAX_NAMES {
            let title = format!("the names in this condition lead through more than {MAX_NAMES} others");
            self.find(
                Diagnostic::new(Code::BadExpression, Spot::Value(at.clone()), title)
                    .help("state it over fields: `CCCR.INIT && CCCR.CCE`"),
            );
            None
        } else {
            self.parse_condition(text, &at).and_then(|parsed| {
                self.resolve(&parsed, None, &at, &mut |this, name| match this.condition_names.get(name).copied() {
                    Some(id) => this.resolve_named(id.0, states, trail),
                    None => this.unknown_condition(name, &at),
                })
            })
        };
        let expr = expr.filter(|expr| self.short_enough(expr, &at));
        trail.pop();
        states[index] = State::Done(expr.clone());
        expr
    }

    fn short_enough(&mut self, expr: &Expr, at: &Path) -> bool {
        let count = comparisons(expr);
        if count > MAX_COMPARISONS {
            let title = format!("this condition is too long: it has {count} comparisons");
            self.find(
                Diagnostic::new(Code::BadExpression, Spot::Value(at.clone()), title)
                    .help(format!("{MAX_COMPARISONS} is the most, the names of other conditions written out")),
            );
        }
        count <= MAX_COMPARISONS
    }

    /// Reports `[n]` in the condition of a field that has no number.
    pub(super) fn check_own_number(&mut self, id: ConditionId, own: Option<FieldRef>, at: &Path) {
        if !uses_own_number(&self.out.model.condition(id).expr) {
            return;
        }
        let numbered = own.is_some_and(|own| {
            let register = self.out.model.register(own.register);
            register.dim.is_some() || register.cluster.is_some() || self.out.model.field(own).lanes.is_some()
        });
        if !numbered {
            let title = "`[n]` stands for the number of the register or lane that is written, but there is none here";
            self.find(
                Diagnostic::new(Code::BadExpression, Spot::Value(at.clone()), title)
                    .help("write the number of the lane or element: `FLTCON.FLTEN[3]`"),
            );
        }
    }

    fn unknown_condition<T>(&mut self, name: &str, at: &Path) -> Option<T> {
        let hint = self.hint(name, self.text.conditions.keys().map(String::as_str), "unknown condition");
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no condition `{name}`"))
                .label(hint)
                .help("declare it under `conditions`, or write an expression over fields: `CCCR.INIT && CCCR.CCE`"),
        );
        None
    }

    fn parse_condition(&mut self, text: &str, at: &Path) -> Option<Parsed> {
        match parse(text) {
            Ok(parsed) => Some(parsed),
            Err(problem) => {
                let before = text.get(..problem.at.start).unwrap_or(text);
                self.find(
                    Diagnostic::new(
                        Code::BadExpression,
                        Spot::Value(at.clone()),
                        format!("this is no condition: {}", problem.what),
                    )
                    .label(match before.trim_end() {
                        "" => "at its start".to_owned(),
                        before => format!("after `{before}`"),
                    })
                    .help("a condition compares fields: `CON.OPMOD == configuration && !FLTCON.FLTEN[n]`"),
                );
                None
            }
        }
    }

    /// The condition that a field names or writes out.
    pub(crate) fn condition_ref(&mut self, text: &str, at: &Path) -> Option<ConditionId> {
        self.condition_in(None, text, at)
    }

    /// The same inside a message, where `WORD.FIELD` names a field of the message's own words.
    pub(super) fn condition_in(&mut self, message: Option<MessageId>, text: &str, at: &Path) -> Option<ConditionId> {
        if let Some(id) = self.condition_names.get(text) {
            return Some(*id);
        }
        let parsed = self.parse_condition(text, at)?;
        let expr =
            self.resolve(&parsed, message, at, &mut |this, name| match this.condition_names.get(name).copied() {
                Some(id) => Some(this.out.model.conditions[id.0].expr.clone()),
                None => this.unknown_condition(name, at),
            })?;
        if !self.short_enough(&expr, at) {
            return None;
        }
        let same_text = self.inline_conditions.get(text).into_iter().flatten();
        if let Some(known) = same_text.copied().find(|id| self.out.model.condition(*id).expr == expr) {
            return Some(known);
        }
        let id = ConditionId(self.out.model.conditions.len());
        self.out.model.conditions.push(Condition {
            name: text.to_owned(),
            named: false,
            text: text.to_owned(),
            doc: text.to_owned(),
            expr,
            cites: Vec::new(),
        });
        self.out.conditions.push(at.clone());
        self.inline_conditions.entry(text.to_owned()).or_default().push(id);
        Some(id)
    }

    fn resolve(
        &mut self,
        parsed: &Parsed,
        message: Option<MessageId>,
        at: &Path,
        named: &mut dyn FnMut(&mut Self, &str) -> Option<Expr>,
    ) -> Option<Expr> {
        let mut list = |this: &mut Self, of: &[Parsed]| -> Option<Vec<Expr>> {
            let resolved: Vec<_> = of.iter().map(|p| this.resolve(p, message, at, named)).collect();
            resolved.into_iter().collect()
        };
        match parsed {
            Parsed::Not(inner) => Some(Expr::Not(Box::new(self.resolve(inner, message, at, named)?))),
            Parsed::All(of) => Some(Expr::All(list(self, of)?)),
            Parsed::Any(of) => Some(Expr::Any(list(self, of)?)),
            Parsed::Name(name) => named(self, name),
            Parsed::Compare { register, field, index, comparison, value } => {
                if let Some(found) = self.word_field(message, register, field) {
                    let (message, word, field) = found;
                    let target = self.out.model.messages[message.0].words[word].fields[field].clone();
                    let value = self.literal(&target, &format!("{register}.{}", target.name), value, at)?;
                    let (comparison, value) = plain(*comparison, value, target.width);
                    return Some(Expr::Word { message, word, field, comparison, value });
                }
                if !self.register_names.contains_key(register)
                    && let Some(word) = self.word_of(message, register)
                {
                    let known = word.fields.iter().map(|f| f.name.as_str());
                    let hint = self.hint(field, known, "unknown field");
                    let title = format!("the word `{register}` has no field `{field}`");
                    self.find(Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), title).label(hint));
                    return None;
                }
                let id = self.register_ref(register, at)?;
                let field = self.field_of(id, field, at)?;
                let target = self.out.model.field(field).clone();
                let value = self.literal(&target, &self.out.model.field_path(field), value, at)?;
                let (comparison, value) = plain(*comparison, value, target.width);
                if !self.check_lane(field, *index, at) {
                    return None;
                }
                Some(Expr::Compare { field, index: *index, comparison, value })
            }
        }
    }

    fn word_of(&self, message: Option<MessageId>, name: &str) -> Option<&Word> {
        self.out.model.messages[message?.0].words.iter().find(|word| word.name == name)
    }

    /// The place of `WORD.FIELD` in a message.
    fn word_field(&self, message: Option<MessageId>, word: &str, field: &str) -> Option<(MessageId, usize, usize)> {
        let id = message?;
        let words = &self.out.model.messages[id.0].words;
        let word = words.iter().position(|w| w.name == word)?;
        Some((id, word, words[word].fields.iter().position(|f| f.name == field)?))
    }

    fn literal(&mut self, target: &Field, path: &str, value: &Literal, at: &Path) -> Option<u64> {
        let capacity = target.capacity();
        match value {
            Literal::Number(number) if *number <= capacity => Some(*number),
            Literal::Number(number) => {
                self.find(
                    Diagnostic::new(
                        Code::OutOfRange,
                        Spot::Value(at.clone()),
                        format!("`{path}` is compared with {number}, which it cannot hold"),
                    )
                    .label(format!("the largest value is {capacity}")),
                );
                None
            }
            Literal::Name(name) => {
                let Some(id) = target.enumeration() else {
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.clone()),
                            format!("`{path}` has no enumeration, so `{name}` is no value of it"),
                        )
                        .help("compare it with a number"),
                    );
                    return None;
                };
                let entry = self.out.model.enumeration(id);
                if let Some(variant) = entry.variants.iter().find(|v| v.name == *name) {
                    return Some(variant.first);
                }
                let hint = self.hint(name, entry.variants.iter().map(|v| v.name.as_str()), "unknown value");
                self.find(
                    Diagnostic::new(
                        Code::UnknownReference,
                        Spot::Value(at.clone()),
                        format!("`{path}` has no value named `{name}`"),
                    )
                    .label(hint),
                );
                None
            }
        }
    }

    fn check_lane(&mut self, field: FieldRef, index: LaneIndex, at: &Path) -> bool {
        let register = self.out.model.register(field.register);
        let target = self.out.model.field(field);
        let elements = match (&register.dim, register.cluster) {
            (Some(dim), _) => Some((dim.first, dim.count)),
            (None, Some(id)) => self.out.model.clusters.get(id.0).map(|c| (c.dim.first, c.dim.count)),
            (None, None) => None,
        };
        let numbers = match (target.lanes, elements) {
            (Some(lanes), elements) => Some((lanes.first, lanes.count * elements.map_or(1, |(_, count)| count))),
            (None, elements) => elements,
        };
        let path = self.out.model.field_path(field);
        let title = match (index, numbers) {
            (LaneIndex::Fixed(number), Some((first, count))) if number < first || number - first >= count => {
                Some(format!("`{path}` has no number {number}; the numbers are {first} to {}", first + count - 1))
            }
            (LaneIndex::Fixed(_) | LaneIndex::Own, None) => {
                Some(format!("`{path}` is not repeated, so it takes no index"))
            }
            (LaneIndex::Single, _) if target.lanes.is_some() => {
                Some(format!("`{path}` has lanes; say which one: `{path}[n]` is the own one"))
            }
            _ => None,
        };
        let fine = title.is_none();
        if let Some(title) = title {
            self.find(Diagnostic::new(Code::BadExpression, Spot::Value(at.clone()), title));
        }
        fine
    }
}

/// "Is not 0" of a single bit is "is 1".
fn plain(comparison: Comparison, value: u64, width: u32) -> (Comparison, u64) {
    match (comparison, value, width) {
        (Comparison::NotEqual, 0, 1) => (Comparison::Equal, 1),
        other => (other.0, other.1),
    }
}

fn comparisons(expr: &Expr) -> usize {
    match expr {
        Expr::Always | Expr::Compare { .. } | Expr::Word { .. } => 1,
        Expr::Not(inner) => comparisons(inner),
        Expr::All(of) | Expr::Any(of) => of.iter().map(comparisons).sum(),
    }
}

fn uses_own_number(expr: &Expr) -> bool {
    match expr {
        Expr::Always | Expr::Word { .. } => false,
        Expr::Compare { index, .. } => *index == LaneIndex::Own,
        Expr::Not(inner) => uses_own_number(inner),
        Expr::All(of) | Expr::Any(of) => of.iter().any(uses_own_number),
    }
}
