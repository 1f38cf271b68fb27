//! Everything that is declared is used.

use std::collections::HashSet;

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};
use crate::lower::Lowered;
use crate::model::{ConditionId, EnumId, Field, WindowId};
use crate::path::Path;

pub(super) fn unused(lowered: &Lowered, findings: &mut Findings) {
    let model = &lowered.model;
    let words = model.messages.iter().flat_map(|m| &m.words);
    let all_fields = || {
        let of_words = words.clone().flat_map(|w| &w.fields);
        model.registers.iter().flat_map(|r| &r.fields).chain(of_words)
    };
    let used_enums: HashSet<EnumId> = all_fields().filter_map(Field::enumeration).collect();
    let mut used_conditions: HashSet<ConditionId> =
        all_fields().flat_map(|f| [f.access.when, f.access.set_when]).flatten().collect();
    used_conditions.extend(words.clone().filter_map(|w| w.present_when));
    used_conditions.extend(model.effects.iter().map(|e| e.on));
    used_conditions.extend(model.memory.sections.iter().filter_map(|s| s.exists_when));
    let used_windows: HashSet<WindowId> =
        model.registers.iter().filter_map(|r| r.window).chain(model.reserved.iter().filter_map(|r| r.window)).collect();
    let mentions: HashSet<&str> =
        model.conditions.iter().flat_map(|c| words_of(&c.text).filter(|word| *word != c.name)).collect();
    let mut report = |what: &str, name: &str, at: &Path| {
        findings.push(
            Diagnostic::new(Code::Unused, Spot::Key(at.clone()), format!("the {what} `{name}` is used nowhere"))
                .help("remove it, or refer to it where it belongs"),
        );
    };
    for (index, entry) in model.enums.iter().enumerate().filter(|(_, e)| e.shared) {
        if !used_enums.contains(&EnumId(index)) {
            report("enumeration", &entry.name, &lowered.enums[index]);
        }
    }
    for (index, condition) in model.conditions.iter().enumerate().filter(|(_, c)| c.named) {
        if !used_conditions.contains(&ConditionId(index)) && !mentions.contains(condition.name.as_str()) {
            report("condition", &condition.name, &lowered.conditions[index]);
        }
    }
    for (index, window) in model.windows.iter().enumerate() {
        if !used_windows.contains(&WindowId(index)) {
            report("window", &window.name, &Path::root().key("windows").key(&window.name));
        }
    }
}

fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}
