//! Effects, instances, conflicts and choices.

use std::collections::HashMap;

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{Choice, ClusterId, Conflict, Effect, FieldRef, Instance, Reading, Target};
use crate::path::Path;

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
            let on = self.condition_ref(&effect.on, &at.key("on"));
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
                    let capacity = self.out.model.field(field).capacity();
                    self.find(
                        Diagnostic::new(
                            Code::OutOfRange,
                            Spot::Value(at),
                            format!("`{target}` cannot hold {}", value.0),
                        )
                        .label(format!("has to be at most {capacity}")),
                    );
                }
                sets.push((field, value.0));
            }
            let Some(on) = on else { continue };
            let doc = effect.doc.clone();
            self.out.model.effects.push(Effect {
                on,
                doc,
                resets,
                resets_fields,
                loads,
                sets,
                holds: effect.holds,
                cites,
            });
        }
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
            let base = self.address(instance.base, &at.key("base"));
            let memory = instance.memory.map(|memory| self.address(memory, &at.key("memory")));
            self.out.model.instances.push(Instance {
                name: name.clone(),
                chips: instance.chips.clone(),
                base,
                memory,
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
        self.check_identifier_value(id, &at.key("id"));
        if let Some(first) = seen.insert(id.to_owned(), at.clone()) {
            self.find(
                Diagnostic::new(
                    Code::DuplicateName,
                    Spot::Value(at.key("id")),
                    format!("there are two {what}s `{id}`"),
                )
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
                    let known =
                        self.register_names.keys().chain(self.enum_names.keys()).chain(self.message_names.keys());
                    let hint = self.hint(name, known.map(String::as_str), "unknown name");
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.index(index)),
                            format!("`{name}` is nothing that this file describes"),
                        )
                        .label(hint)
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
                    .or_else(|| cluster().map(|index| Target::Cluster(ClusterId(index))))
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
