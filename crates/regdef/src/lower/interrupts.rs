//! Interrupt lines and sources.

use std::collections::{HashMap, HashSet};

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{FieldRef, InterruptId, InterruptLine, InterruptSource, Interrupts, LineId, RegisterId};
use crate::path::Path;
use crate::syntax;

impl Lowering<'_> {
    pub(super) fn interrupts(&mut self) {
        let text = self.text;
        let Some(interrupts) = &text.interrupts else { return };
        let at = Path::root().key("interrupts");
        let cites = self.cite(interrupts.cite.as_ref(), &at);
        let mut line_names = HashMap::new();
        let mut lines = Vec::new();
        for (index, (name, line)) in interrupts.lines.iter().enumerate() {
            let at = at.key("lines").key(name);
            self.check_identifier(name, &at);
            line_names.insert(name.clone(), LineId(index));
            let cites = self.cite(line.cite.as_ref(), &at);
            lines.push(InterruptLine {
                name: name.clone(),
                doc: line.doc.clone(),
                enable: line.enable.as_ref().and_then(|f| self.field_ref(f, &at.key("enable"))),
                select: line.select.map(|v| v.0),
                cites,
            });
        }
        let mut sources: Vec<InterruptSource> = Vec::new();
        let mut numbers: HashMap<String, InterruptId> = HashMap::new();
        for (index, group) in interrupts.groups.iter().enumerate() {
            let at = at.key("groups").index(index);
            self.interrupt_group(group, &at, &line_names, &mut numbers, &mut sources);
        }
        let mut feeds = Vec::new();
        let mut lost = HashSet::new();
        for (name, source) in &interrupts.sources {
            let at = at.key("sources").key(name);
            if numbers.contains_key(name) {
                let title = format!("there are two interrupt sources named `{name}`");
                self.find(
                    Diagnostic::new(Code::DuplicateName, Spot::Key(at), title)
                        .help("a group above already makes a source of this name; list it under the group's `except`"),
                );
                continue;
            }
            self.check_identifier(name, &at);
            let Some(flag) = self.field_ref(&source.flag, &at.key("flag")) else {
                lost.insert(name.clone());
                continue;
            };
            let cites = self.cite(source.cite.as_ref(), &at);
            let optional = |this: &mut Self, field: &Option<String>, key: &str| {
                field.as_ref().and_then(|f| this.field_ref(f, &at.key(key)))
            };
            let (enable, select) = (optional(self, &source.enable, "enable"), optional(self, &source.select, "select"));
            for (index, target) in source.feeds.iter().enumerate() {
                feeds.push((sources.len(), target.clone(), at.key("feeds").index(index)));
            }
            if let Some(code) = source.code.as_ref().filter(|code| code.first > code.last) {
                let title = format!("the codes of `{name}` end before they start");
                self.find(
                    Diagnostic::new(Code::BadRange, Spot::Value(at.key("code")), title)
                        .label(format!("write \"{}..{}\"", code.last, code.first)),
                );
            }
            let field = self.out.model.field(flag);
            numbers.insert(name.clone(), InterruptId(sources.len()));
            sources.push(InterruptSource {
                name: name.clone(),
                doc: source.doc.clone().unwrap_or_else(|| field.doc.clone()),
                flag,
                enable,
                select,
                lines: self.line_refs(&source.lines, &at.key("lines"), &line_names),
                feeds: Vec::new(),
                code: source.code.as_ref().map(|key| (key.first, key.last)),
                cleared_by: source.cleared_by.clone().unwrap_or_default(),
                cites: if cites.is_empty() { self.out.model.field(flag).cites.clone() } else { cites },
            });
        }
        for (from, target, at) in feeds {
            match numbers.get(&target) {
                Some(to) => sources[from].feeds.push(*to),
                None if lost.contains(&target) => {}
                None => {
                    let hint = self.hint(&target, sources.iter().map(|s| s.name.as_str()), "unknown source");
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at),
                            format!("there is no interrupt source `{target}`"),
                        )
                        .label(hint),
                    );
                }
            }
        }
        self.feed_cycle(&sources, &at.key("sources"));
        self.out.model.interrupts = Interrupts { doc: interrupts.doc.clone(), cites, lines, sources };
    }

    fn line_refs(&mut self, names: &[String], at: &Path, known: &HashMap<String, LineId>) -> Vec<LineId> {
        let mut lines = Vec::new();
        for (index, name) in names.iter().enumerate() {
            match known.get(name) {
                Some(id) => lines.push(*id),
                None => {
                    let hint = self.hint(name, known.keys().map(String::as_str), "unknown line");
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.index(index)),
                            format!("there is no interrupt line `{name}`"),
                        )
                        .label(hint)
                        .help("declare it under `interrupts: {lines: ...}`"),
                    );
                }
            }
        }
        lines
    }

    fn interrupt_group(
        &mut self,
        group: &syntax::InterruptGroup,
        at: &Path,
        line_names: &HashMap<String, LineId>,
        numbers: &mut HashMap<String, InterruptId>,
        sources: &mut Vec<InterruptSource>,
    ) {
        let Some(flags) = self.register_ref(&group.flags, &at.key("flags")) else { return };
        let lines = self.line_refs(&group.lines, &at.key("lines"), line_names);
        let optional = |this: &mut Self, name: &Option<String>, key: &str| {
            name.as_ref().and_then(|name| this.register_ref(name, &at.key(key)))
        };
        let enables = optional(self, &group.enables, "enables");
        let selects = optional(self, &group.selects, "selects");
        let names: Vec<_> = self.out.model.register(flags).fields.iter().map(|f| f.name.clone()).collect();
        for unknown in group.except.iter().filter(|e| !names.contains(e)) {
            let title = format!("`{}` has no field `{unknown}` to leave out", group.flags);
            let place = group.except.iter().position(|e| e == unknown).unwrap_or(0);
            let hint = self.hint(unknown, names.iter().map(String::as_str), "unknown field");
            self.find(
                Diagnostic::new(Code::UnknownReference, Spot::Value(at.key("except").index(place)), title).label(hint),
            );
        }
        for (index, name) in names.iter().enumerate().filter(|(_, n)| !group.except.contains(n)) {
            let stem =
                group.strip.as_ref().and_then(|strip| name.strip_suffix(strip.as_str())).unwrap_or(name).to_owned();
            let mut partner = |register: Option<RegisterId>, pattern: &Option<String>, key: &str| {
                let pattern = pattern.as_deref().unwrap_or("{}");
                let place = at.key(key);
                let found = self.field_of(register?, &pattern.replace("{}", &stem), &place);
                if found.is_none() {
                    let help =
                        format!("the group looks for `{pattern}` of the flag `{name}`; `except` leaves flags out");
                    self.findings.amend(&Spot::Value(place), |finding| finding.help.push(help));
                }
                found
            };
            let enable = partner(enables, &group.enable_name, "enables");
            let select = partner(selects, &group.select_name, "selects");
            let flag = FieldRef { register: flags, field: index };
            if let Some(other) = numbers.insert(stem.clone(), InterruptId(sources.len())) {
                let other = self.out.model.field_path(sources[other.0].flag);
                let title = format!(
                    "`{other}` and `{}` both make an interrupt source `{stem}`",
                    self.out.model.field_path(flag)
                );
                self.find(
                    Diagnostic::new(Code::DuplicateName, Spot::Value(at.key("flags")), title)
                        .help("list the flag under `except`, and name its source under `sources` if it is one"),
                );
                continue;
            }
            let field = self.out.model.field(flag);
            sources.push(InterruptSource {
                name: stem,
                doc: field.doc.clone(),
                flag,
                enable,
                select,
                lines: lines.clone(),
                feeds: Vec::new(),
                code: None,
                cleared_by: String::new(),
                cites: field.cites.clone(),
            });
        }
    }

    /// Reports sources that feed each other in a circle, which would never reach a line.
    fn feed_cycle(&mut self, sources: &[InterruptSource], at: &Path) {
        // Sources that feed nothing more are taken away until only circles, and what leads into them, are left.
        let mut open: Vec<usize> = sources.iter().map(|s| s.feeds.len()).collect();
        let mut fed_by: Vec<Vec<usize>> = vec![Vec::new(); sources.len()];
        for (from, source) in sources.iter().enumerate() {
            source.feeds.iter().for_each(|to| fed_by[to.0].push(from));
        }
        let mut done: Vec<usize> = (0..sources.len()).filter(|index| open[*index] == 0).collect();
        while let Some(index) = done.pop() {
            for from in &fed_by[index] {
                open[*from] -= 1;
                if open[*from] == 0 {
                    done.push(*from);
                }
            }
        }
        let Some(start) = open.iter().position(|left| *left > 0) else { return };
        let mut trail = vec![start];
        let circle = loop {
            let last = trail[trail.len() - 1];
            let Some(next) = sources[last].feeds.iter().map(|to| to.0).find(|to| open[*to] > 0) else { return };
            if let Some(from) = trail.iter().position(|index| *index == next) {
                break &trail[from..];
            }
            trail.push(next);
        };
        let names: Vec<_> = circle.iter().chain(&circle[..1]).map(|index| sources[*index].name.as_str()).collect();
        let first = &sources[circle[0]].name;
        self.find(
            Diagnostic::new(
                Code::FeedCycle,
                Spot::Value(at.key(first).key("feeds")),
                format!("the interrupt source `{first}` feeds itself"),
            )
            .label(names.join(" → "))
            .help("`feeds` leads towards the lines: from a source to the one that collects it"),
        );
    }
}
