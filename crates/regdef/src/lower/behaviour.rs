//! Effects, interrupts, bit timing, instances, conflicts and choices.

use std::collections::HashMap;

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot, suggestion};
use crate::model::{
    BitTiming, Choice, Clock, Conflict, Effect, FieldRef, Instance, InterruptId, InterruptLine, InterruptSource,
    Interrupts, LineId, Reading, Target, TimingPhase, TransmitterDelay,
};
use crate::path::Path;
use crate::syntax;

impl Lowering<'_> {
    pub(super) fn behaviour(&mut self) {
        self.effects();
        self.interrupts();
        self.bit_timing();
        self.instances();
        self.conflicts();
        self.choices();
    }

    fn effects(&mut self) {
        let text = self.text;
        for (index, effect) in text.effects.iter().enumerate() {
            let at = Path::root().key("effects").index(index);
            let cites = self.cite(effect.cite.as_ref(), &at);
            let Some(on) = self.condition_ref(&effect.on, &at.key("on")) else { continue };
            let (mut resets, mut resets_fields) = (Vec::new(), Vec::new());
            for (index, name) in effect.resets.iter().enumerate() {
                let at = at.key("resets").index(index);
                if name.contains('.') {
                    resets_fields.extend(self.field_ref(name, &at));
                } else {
                    resets.extend(self.register_ref(name, &at));
                }
            }
            let loads = effect
                .loads
                .iter()
                .filter_map(|(target, origin)| {
                    let at = at.key("loads").key(target);
                    Some((self.field_ref(target, &at)?, self.field_ref(origin, &at)?))
                })
                .collect();
            let mut sets = Vec::new();
            for (target, value) in &effect.sets {
                let at = at.key("sets").key(target);
                let Some(field) = self.field_ref(target, &at) else { continue };
                if value.0 > self.out.model.field(field).capacity() {
                    self.find(Diagnostic::new(Code::OutOfRange, Spot::Value(at), format!("`{target}` cannot hold {}", value.0)));
                }
                sets.push((field, value.0));
            }
            let doc = effect.doc.clone();
            self.out.model.effects.push(Effect { on, doc, resets, resets_fields, loads, sets, holds: effect.holds, cites });
        }
    }

    fn interrupts(&mut self) {
        let text = self.text;
        let Some(interrupts) = &text.interrupts else { return };
        let at = Path::root().key("interrupts");
        let cites = self.cite(interrupts.cite.as_ref(), &at);
        let mut line_names = HashMap::new();
        let mut lines = Vec::new();
        for (index, (name, line)) in interrupts.lines.iter().enumerate() {
            let at = at.key("lines").key(name);
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
        for (index, group) in interrupts.groups.iter().enumerate() {
            let at = at.key("groups").index(index);
            self.interrupt_group(group, &at, &line_names, &mut sources);
        }
        let mut feeds = Vec::new();
        for (name, source) in &interrupts.sources {
            let at = at.key("sources").key(name);
            if sources.iter().any(|s| s.name == *name) {
                let title = format!("there are two interrupt sources named `{name}`");
                self.find(
                    Diagnostic::new(Code::DuplicateName, Spot::Key(at), title)
                        .help("a group above already makes a source of this name; list it under the group's `except`"),
                );
                continue;
            }
            let Some(flag) = self.field_ref(&source.flag, &at.key("flag")) else { continue };
            let cites = self.cite(source.cite.as_ref(), &at);
            let optional = |this: &mut Self, field: &Option<String>, key: &str| {
                field.as_ref().and_then(|f| this.field_ref(f, &at.key(key)))
            };
            let (enable, select) = (optional(self, &source.enable, "enable"), optional(self, &source.select, "select"));
            for (index, target) in source.feeds.iter().enumerate() {
                feeds.push((sources.len(), target.clone(), at.key("feeds").index(index)));
            }
            let field = self.out.model.field(flag);
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
            match sources.iter().position(|s| s.name == target) {
                Some(to) => sources[from].feeds.push(InterruptId(to)),
                None => {
                    let hint = suggestion(&target, sources.iter().map(|s| s.name.as_str()));
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at),
                            format!("there is no interrupt source `{target}`"),
                        )
                        .label(hint.unwrap_or_default()),
                    );
                }
            }
        }
        self.out.model.interrupts = Interrupts { doc: interrupts.doc.clone(), cites, lines, sources };
    }

    fn line_refs(&mut self, names: &[String], at: &Path, known: &HashMap<String, LineId>) -> Vec<LineId> {
        let mut lines = Vec::new();
        for (index, name) in names.iter().enumerate() {
            match known.get(name) {
                Some(id) => lines.push(*id),
                None => {
                    let hint = suggestion(name, known.keys().map(String::as_str));
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.index(index)),
                            format!("there is no interrupt line `{name}`"),
                        )
                        .label(hint.unwrap_or_default())
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
            self.find(Diagnostic::new(Code::UnknownReference, Spot::Value(at.key("except")), title));
        }
        for (index, name) in names.iter().enumerate().filter(|(_, n)| !group.except.contains(n)) {
            let stem = group.strip.as_ref().and_then(|strip| name.strip_suffix(strip.as_str())).unwrap_or(name).to_owned();
            let mut partner = |register: Option<crate::model::RegisterId>, pattern: &Option<String>, key: &str| {
                let wanted = pattern.as_deref().unwrap_or("{}").replace("{}", &stem);
                register.and_then(|register| self.field_of(register, &wanted, &at.key(key)))
            };
            let enable = partner(enables, &group.enable_name, "enables");
            let select = partner(selects, &group.select_name, "selects");
            let flag = FieldRef { register: flags, field: index };
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

    fn bit_timing(&mut self) {
        let text = self.text;
        let Some(timing) = &text.bit_timing else { return };
        let at = Path::root().key("bit_timing");
        let clock_at = at.key("clock");
        let cites = self.cite(timing.clock.cite.as_ref(), &clock_at);
        let clock = Clock {
            name: timing.clock.name.clone(),
            divider: timing.clock.divider.unwrap_or(1),
            max_hz: timing.clock.max_hz.map(|v| v.0),
            doc: timing.clock.doc.clone().unwrap_or_default(),
            cites,
        };
        let nominal = self.timing_phase(&timing.nominal, &at.key("nominal"));
        let data = timing.data.as_ref().and_then(|phase| self.timing_phase(phase, &at.key("data")));
        let transmitter_delay = timing.transmitter_delay.as_ref().and_then(|tdc| {
            let at = at.key("transmitter_delay");
            let cites = self.cite(tdc.cite.as_ref(), &at);
            Some(TransmitterDelay {
                enable: self.field_ref(&tdc.enable, &at.key("enable"))?,
                offset: self.field_ref(&tdc.offset, &at.key("offset"))?,
                filter: tdc.filter.as_ref().and_then(|f| self.field_ref(f, &at.key("filter"))),
                value: tdc.value.as_ref().and_then(|f| self.field_ref(f, &at.key("value"))),
                rules: tdc.rules.clone(),
                cites,
            })
        });
        self.out.model.bit_timing = nominal.map(|nominal| BitTiming { clock, nominal, data, transmitter_delay });
    }

    fn timing_phase(&mut self, phase: &syntax::TimingPhase, at: &Path) -> Option<TimingPhase> {
        let cites = self.cite(phase.cite.as_ref(), at);
        let mut field = |name: &str, key: &str| self.field_ref(name, &at.key(key));
        let prescaler = field(&phase.prescaler, "prescaler");
        let propagation = phase.propagation.as_ref().map(|f| field(f, "propagation"));
        let segment1 = field(&phase.segment1, "segment1");
        let segment2 = field(&phase.segment2, "segment2");
        let jump_width = field(&phase.jump_width, "jump_width");
        let (Some(min), Some(max)) = (phase.quanta.min, phase.quanta.max) else {
            self.find(
                Diagnostic::new(Code::MissingKey, Spot::Key(at.key("quanta")), "the time quanta of a bit need `min` and `max`")
                    .help("write `quanta: {min: 4, max: 385}`"),
            );
            return None;
        };
        Some(TimingPhase {
            prescaler: prescaler?,
            propagation: match propagation {
                Some(field) => Some(field?),
                None => None,
            },
            segment1: segment1?,
            segment2: segment2?,
            jump_width: jump_width?,
            min_quanta: min.0,
            max_quanta: max.0,
            rules: phase.rules.clone(),
            max_bit_rate: phase.max_bit_rate.map(|v| v.0),
            cites,
        })
    }

    fn instances(&mut self) {
        let text = self.text;
        for (name, instance) in &text.instances {
            let at = Path::root().key("instances").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(instance.cite.as_ref(), &at);
            if !cites.iter().any(|c| c.source.is_some()) {
                self.find(
                    Diagnostic::new(
                        Code::NoCitation,
                        Spot::Key(at.clone()),
                        format!("the instance `{name}` has no external source"),
                    )
                    .help("base addresses are facts of a chip, not of this manual: cite a `source`"),
                );
            }
            self.out.model.instances.push(Instance {
                name: name.clone(),
                chips: instance.chips.clone(),
                base: instance.base.0,
                memory: instance.memory.map(|v| v.0),
                interrupts: instance.interrupts.iter().map(|(name, n)| (name.clone(), n.0)).collect(),
                doc: instance.doc.clone().unwrap_or_default(),
                cites,
            });
        }
    }

    fn conflicts(&mut self) {
        let text = self.text;
        let mut seen = HashMap::new();
        for (index, conflict) in text.conflicts.iter().enumerate() {
            let at = Path::root().key("conflicts").index(index);
            self.unique_id(&mut seen, &conflict.id, "conflict", &at);
            let says = conflict
                .says
                .iter()
                .enumerate()
                .map(|(index, says)| {
                    self.one_cite(&says.cite, &at.key("says").index(index).key("cite"));
                    Reading { cite: says.cite.clone(), says: says.says.clone() }
                })
                .collect();
            let targets = self.targets(&conflict.at, &at.key("at"));
            self.out.model.conflicts.push(Conflict {
                id: conflict.id.clone(),
                at: targets,
                what: conflict.what.clone(),
                says,
                taken: conflict.taken.clone(),
                because: conflict.because.clone(),
            });
        }
    }

    fn choices(&mut self) {
        let text = self.text;
        let mut seen = HashMap::new();
        for (index, choice) in text.choices.iter().enumerate() {
            let at = Path::root().key("choices").index(index);
            self.unique_id(&mut seen, &choice.id, "choice", &at);
            let cites = self.cite(choice.cite.as_ref(), &at);
            let targets = self.targets(&choice.at, &at.key("at"));
            self.out.model.choices.push(Choice {
                id: choice.id.clone(),
                at: targets,
                question: choice.question.clone(),
                nearest: choice.nearest.clone().unwrap_or_default(),
                choice: choice.choice.clone(),
                alternatives: choice.alternatives.clone(),
                because: choice.because.clone().unwrap_or_default(),
                cites,
            });
        }
    }

    fn unique_id(&mut self, seen: &mut HashMap<String, Path>, id: &str, what: &str, at: &Path) {
        if let Some(first) = seen.insert(id.to_owned(), at.clone()) {
            self.find(
                Diagnostic::new(Code::DuplicateName, Spot::Value(at.key("id")), format!("there are two {what}s `{id}`"))
                    .also(Spot::Value(first.key("id")), "first here"),
            );
        }
    }

    fn targets(&mut self, names: &[String], at: &Path) -> Vec<Target> {
        let mut targets = Vec::new();
        for (index, name) in names.iter().enumerate() {
            match self.target(name) {
                Some(target) => targets.push(target),
                None => {
                    let known = self.register_names.keys().chain(self.enum_names.keys()).chain(self.message_names.keys());
                    let hint = suggestion(name, known.map(String::as_str));
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.index(index)),
                            format!("`{name}` is nothing that this file describes"),
                        )
                        .label(hint.unwrap_or_default())
                        .help(
                            "name a register, `REG.FIELD`, a cluster, a joined value, an enumeration, a message, \
                             `MESSAGE.WORD` or `MESSAGE.WORD.FIELD`; leave `at` empty if it is about none of them",
                        ),
                    );
                }
            }
        }
        targets
    }

    fn target(&self, name: &str) -> Option<Target> {
        let model = &self.out.model;
        let mut keys = name.split('.');
        let first = keys.next()?;
        match (keys.next(), keys.next()) {
            (None, _) => {
                let cluster = || model.clusters.iter().position(|c| c.name == first);
                let joined = || model.joined.iter().position(|j| j.name == first);
                self.register_names
                    .get(first)
                    .map(|id| Target::Register(*id))
                    .or_else(|| cluster().map(|index| Target::Cluster(crate::model::ClusterId(index))))
                    .or_else(|| joined().map(Target::Joined))
                    .or_else(|| self.enum_names.get(first).map(|id| Target::Enum(*id)))
                    .or_else(|| self.message_names.get(first).map(|id| Target::Message(*id)))
            }
            (Some(second), None) => {
                if let Some(id) = self.register_names.get(first) {
                    let field = model.register(*id).fields.iter().position(|f| f.name == second)?;
                    return Some(Target::Field(FieldRef { register: *id, field }));
                }
                let id = *self.message_names.get(first)?;
                model.messages[id.0].words.iter().position(|w| w.name == second).map(|word| Target::Word(id, word))
            }
            (Some(second), Some(third)) => {
                let id = *self.message_names.get(first)?;
                let word = model.messages[id.0].words.iter().position(|w| w.name == second)?;
                let field = model.messages[id.0].words[word].fields.iter().position(|f| f.name == third)?;
                Some(Target::WordField(id, word, field))
            }
        }
    }
}
