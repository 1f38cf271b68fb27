//! Placement of messages in memory.

use super::Lowering;
use crate::model::{Ident, Memory, Section, SectionStart};
use crate::path::Path;
use crate::syntax::{self, OneOrMany};

impl Lowering<'_> {
    pub(super) fn memory(&mut self) {
        let text = self.text;
        let Some(memory) = &text.memory else { return };
        let at = Path::root().key("memory");
        let cites = self.cite(memory.cite.as_ref(), &at);
        let mut sections = Vec::new();
        for (name, section) in &memory.sections {
            let at = at.key("sections").key(name);
            sections.extend(self.section(name, section, &at));
        }
        self.out.model.memory = Memory { doc: memory.doc.clone(), limit: memory.limit.map(|v| v.0), cites, sections };
    }

    fn section(&mut self, name: &str, text: &syntax::Section, at: &Path) -> Option<Section> {
        let cites = self.cite(text.cite.as_ref(), at);
        self.check_identifier(name, at);
        let element_at = |index: usize| match text.elements {
            OneOrMany::One(_) => at.key("elements"),
            OneOrMany::Many(_) => at.key("elements").index(index),
        };
        let elements: Vec<_> = text
            .elements
            .as_slice()
            .iter()
            .enumerate()
            .filter_map(|(i, e)| self.message_ref(e, &element_at(i)))
            .collect();
        let start = match &text.start {
            None => SectionStart::Follows,
            Some(start) => {
                let place = at.key("start");
                let joined = self.out.model.joined.iter().find(|j| j.name == *start);
                let parts = match joined {
                    Some(joined) => joined.parts.clone(),
                    None => vec![self.part(start, 0, &place)?],
                };
                SectionStart::At { parts, unit: text.start_unit.unwrap_or(1) }
            }
        };
        let count: Vec<_> = text
            .count
            .iter()
            .enumerate()
            .filter_map(|(index, field)| self.field_ref(field, &at.key("count").index(index)))
            .collect();
        let payload_size = text.payload_size.as_ref().and_then(|f| self.field_ref(f, &at.key("payload_size")));
        let exists_when = text.exists_when.as_ref().and_then(|c| self.condition_ref(c, &at.key("exists_when")));
        let dim = count
            .iter()
            .chain(&payload_size)
            .find_map(|f| self.out.model.register(f.register).cluster)
            .map(|id| self.out.model.clusters[id.0].dim.clone());
        Some(Section {
            name: name.to_owned(),
            ident: Ident::new(name),
            elements,
            doc: text.doc.clone().unwrap_or_default(),
            start,
            count,
            max: text.max,
            payload_size,
            exists_when,
            dim,
            cites,
        })
    }
}
