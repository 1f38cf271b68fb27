//! Message layouts.

use indexmap::IndexMap;

use super::fields::{Holder, Outer};
use super::joined::field_bits;
use super::like::MAX_STEPS;
use super::references::weight;
use super::{Lowering, Origin};
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{AccessCode, Cite, Ident, Joined, Message, MessageId, Part, Payload, Word};
use crate::path::Path;
use crate::syntax;

impl<'a> Lowering<'a> {
    pub(super) fn messages(&mut self) {
        let text = self.text;
        for (index, name) in text.messages.keys().enumerate() {
            self.message_names.insert(name.clone(), MessageId(index));
        }
        for (index, (name, message)) in text.messages.iter().enumerate() {
            self.message(MessageId(index), name, message);
            // Messages further down copy this one with its rules.
            self.rules();
        }
    }

    fn message(&mut self, id: MessageId, name: &str, text: &syntax::Message) {
        let at = Path::root().key("messages").key(name);
        self.check_identifier(name, &at);
        if !matches!(text.word, 8 | 16 | 32) {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.key("word")),
                    format!("a word cannot have {} bits", text.word),
                )
                .label("has to be 8, 16 or 32"),
            );
        }
        let word_width = u32::from(text.word.clamp(8, 32));
        let cites = self.cite(text.cite.as_ref(), &at);
        let mut message = Message {
            name: name.to_owned(),
            ident: Ident::new(name),
            title: text.title.clone(),
            doc: text.doc.clone().unwrap_or_default().trim().to_owned(),
            cites: cites.clone(),
            word_width,
            words: Vec::new(),
            payload: None,
            joined: Vec::new(),
            header_bytes: 0,
        };
        let mut origins: Vec<Origin> = Vec::new();
        if let Some(base) = &text.extends
            && let Some(base_id) = self.message_ref(base, &at.key("extends"))
        {
            if base_id >= id {
                self.find(
                    Diagnostic::new(
                        Code::UnknownReference,
                        Spot::Value(at.key("extends")),
                        format!("`{base}` is described further down"),
                    )
                    .help("put the message that others extend first"),
                );
            } else {
                self.extends_depth(name, &at.key("extends"));
                let base = self.out.model.messages[base_id.0].clone();
                let bytes =
                    base.words.iter().flat_map(|w| &w.fields).map(|f| 256 + f.doc.len() + weight(&f.cites)).sum();
                if base.word_width != word_width && matches!(text.word, 8 | 16 | 32) {
                    self.find(
                        Diagnostic::new(
                            Code::Contradiction,
                            Spot::Value(at.key("word")),
                            format!(
                                "`{name}` has words of {word_width} bits, but extends a message of {}",
                                base.word_width
                            ),
                        )
                        .also(Spot::Value(at.key("extends")), "the message it extends")
                        .help("a message shares words only with one whose words are as wide"),
                    );
                } else if self.repeat(bytes, &at) {
                    for (word, own) in base.words.iter().enumerate() {
                        let mut own = own.clone();
                        own.same_as = Some(own.same_as.unwrap_or((base_id, word)));
                        message.words.push(own);
                        origins.push(self.out.words[base_id.0][word].clone());
                    }
                    message.payload = base.payload.clone();
                }
            }
        }
        // The message has to exist while its words are read: their rules refer to it.
        self.out.model.messages.push(message.clone());
        for (word_name, word) in &text.words {
            let word_at = at.key("words").key(word_name);
            let existing = message.words.iter().position(|w| w.name == *word_name);
            let position = existing.unwrap_or(message.words.len());
            let (lowered, origin) = self.word((id, position), &message, word_name, word, &word_at, &cites);
            if existing.is_some() {
                message.words[position] = lowered;
                origins[position] = origin;
            } else {
                message.words.push(lowered);
                origins.push(origin);
            }
        }
        self.out.model.messages[id.0].words.clone_from(&message.words);
        for (word_name, word) in &text.words {
            let at = at.key("words").key(word_name).key("present_when");
            let condition = word.present_when.as_ref().and_then(|c| self.condition_in(Some(id), c, &at));
            if let Some(word) = message.words.iter_mut().find(|w| w.name == *word_name) {
                word.present_when = condition;
            }
        }
        message.payload =
            text.payload.as_ref().map(|p| self.payload(p, &at.key("payload"), &cites)).or(message.payload);
        let last = message.words.iter().map(|w| w.offset + u64::from(word_width / 8)).max().unwrap_or(0);
        message.header_bytes = message.payload.as_ref().map_or(last, |p| p.offset);
        // What a base that is missing would hold is not to be reported once more.
        let whole = text.extends.is_none() || message.words.iter().any(|word| !text.words.contains_key(&word.name));
        for (joined_name, (joined, at)) in self.all_joined(name).into_iter().filter(|_| whole) {
            if let Some(joined) = self.message_joined(&message, joined_name, joined, &at) {
                message.joined.push(joined);
            }
        }
        self.check_words(&message, &origins, &at);
        self.out.model.messages[id.0] = message;
        self.out.words.push(origins);
    }

    /// A message and those it extends, one above the other.
    fn chain(&self, name: &str) -> Vec<&'a str> {
        let messages = &self.text.messages;
        let mut chain: Vec<&str> = Vec::new();
        let mut next = messages.get_key_value(name);
        while let Some((name, message)) = next
            && chain.len() <= MAX_STEPS
        {
            chain.push(name);
            let above = |base: &String| messages.get_index_of(base) < messages.get_index_of(name.as_str());
            next = message.extends.as_ref().filter(|base| above(base)).and_then(|base| messages.get_key_value(base));
        }
        chain
    }

    fn extends_depth(&mut self, name: &str, at: &Path) {
        if self.chain(name).len() > MAX_STEPS {
            let title = format!("`extends` leads through more than {MAX_STEPS} messages");
            self.find(
                Diagnostic::new(Code::LikeCycle, Spot::Value(at.clone()), title)
                    .help("extend the message that lists the words itself"),
            );
        }
    }

    /// The joined values of a message and of those it extends. They are resolved anew for each, because a word that
    /// is overridden can have other fields.
    fn all_joined(&self, name: &str) -> IndexMap<&'a str, (&'a syntax::Joined, Path)> {
        let text = self.text;
        let chain = self.chain(name);
        let mut all = IndexMap::new();
        for name in chain.into_iter().rev() {
            let at = Path::root().key("messages").key(name).key("joined");
            for (key, joined) in text.messages.get(name).into_iter().flat_map(|message| &message.joined) {
                all.insert(key.as_str(), (joined, at.key(key)));
            }
        }
        all
    }

    fn word(
        &mut self,
        (id, position): (MessageId, usize),
        message: &Message,
        name: &str,
        text: &syntax::MessageWord,
        at: &Path,
        outer_cites: &[Cite],
    ) -> (Word, Origin) {
        self.check_identifier(name, at);
        let own_cites = self.cite(text.cite.as_ref(), at);
        let cites = if own_cites.is_empty() { outer_cites.to_vec() } else { own_cites };
        let base = text.like.as_ref().and_then(|like| self.word_ref(like, id, &at.key("like")));
        let enum_prefix = format!("{}_{name}", message.name);
        let outer = Outer {
            name,
            enum_prefix: &enum_prefix,
            at,
            width: message.word_width,
            access: Some(AccessCode::Rw),
            when: None,
            cites: &cites,
            has_reset: true,
            holder: Holder::Word(id, position),
        };
        let (own, own_paths) = self.fields(&text.fields, &IndexMap::new(), &outer);
        let (mut fields, mut paths) = (Vec::new(), Vec::new());
        let mut same_as = None;
        let mut doc = text.doc.clone().unwrap_or_default().trim().to_owned();
        if let Some((base_id, base_word)) = base {
            let source = &self.out.model.messages[base_id.0].words[base_word];
            if own.is_empty() {
                same_as = Some(source.same_as.unwrap_or((base_id, base_word)));
            }
            if doc.is_empty() {
                doc.clone_from(&source.doc);
            }
            for (field, path) in source.fields.iter().zip(&self.out.words[base_id.0][base_word].fields) {
                if !own.iter().any(|f| f.name == field.name) {
                    fields.push(field.clone());
                    paths.push(path.clone());
                }
            }
        }
        fields.extend(own);
        paths.extend(own_paths);
        let ident = Ident::new(&format!("{}_{name}", message.name));
        let offset = self.address(text.offset, &at.key("offset"));
        let word = Word { name: name.to_owned(), ident, same_as, offset, doc, cites, present_when: None, fields };
        // Rules of the fields look the word up in the model.
        let known = &mut self.out.model.messages[id.0];
        if position < known.words.len() {
            known.words[position] = word.clone();
        } else {
            known.words.push(word.clone());
        }
        (word, Origin { path: at.clone(), fields: paths })
    }

    pub(super) fn message_ref(&mut self, name: &str, at: &Path) -> Option<MessageId> {
        if let Some(id) = self.message_names.get(name) {
            return Some(*id);
        }
        let hint = self.hint(name, self.message_names.keys().map(String::as_str), "unknown message");
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no message `{name}`"))
                .label(hint)
                .help("references use the keys of `messages`"),
        );
        None
    }

    /// `MESSAGE.WORD` of a message described before `limit`.
    fn word_ref(&mut self, reference: &str, limit: MessageId, at: &Path) -> Option<(MessageId, usize)> {
        let (message, word) = reference.split_once('.').unwrap_or((reference, ""));
        let id = self.message_ref(message, at)?;
        let found =
            (id < limit).then(|| self.out.model.messages[id.0].words.iter().position(|w| w.name == word)).flatten();
        if found.is_none() {
            self.find(
                Diagnostic::new(
                    Code::UnknownReference,
                    Spot::Value(at.clone()),
                    format!("the messages above have no word `{reference}`"),
                )
                .help("write `MESSAGE.WORD` of a message that is described further up"),
            );
        }
        found.map(|word| (id, word))
    }

    fn payload(&mut self, text: &syntax::Payload, at: &Path, outer_cites: &[Cite]) -> Payload {
        let own = self.cite(text.cite.as_ref(), at);
        if text.sizes.is_empty() {
            self.find(Diagnostic::new(
                Code::OutOfRange,
                Spot::Value(at.key("sizes")),
                "a payload has at least one size",
            ));
        }
        Payload {
            offset: self.address(text.offset, &at.key("offset")),
            sizes: text.sizes.clone(),
            word_label: text.word_label.clone(),
            first_word: text.first_word,
            byte_label: text.byte_label.clone().unwrap_or_else(|| "byte {n}".to_owned()),
            doc: text.doc.clone().unwrap_or_default(),
            cites: if own.is_empty() { outer_cites.to_vec() } else { own },
        }
    }

    fn message_joined(
        &mut self,
        message: &Message,
        name: &str,
        text: &syntax::Joined,
        at: &Path,
    ) -> Option<Joined<usize>> {
        let mut parts = Vec::new();
        let mut shift = 0;
        for (index, reference) in text.parts.iter().enumerate() {
            let place = at.key("parts").index(index);
            let (word, field) = reference.split_once('.').map_or((reference.as_str(), None), |(w, f)| (w, Some(f)));
            let holder = message.words.iter().position(|w| w.name == word);
            let found = holder.and_then(|holder| match field {
                None => Some(Part { holder, field: None, lsb: 0, width: message.word_width, shift }),
                Some(field) => {
                    let index = message.words[holder].fields.iter().position(|f| f.name == field)?;
                    let (lsb, width) = field_bits(&message.words[holder].fields[index]);
                    Some(Part { holder, field: Some(index), lsb, width, shift })
                }
            });
            let Some(part) = found else {
                self.find(
                    Diagnostic::new(
                        Code::UnknownReference,
                        Spot::Value(place),
                        format!("the message `{}` has no `{reference}`", message.name),
                    )
                    .help("write `WORD.FIELD` of this message"),
                );
                return None;
            };
            shift += part.width;
            parts.push(part);
        }
        if !self.check_parts(parts.len(), shift, at) {
            return None;
        }
        let cites = self.cite(text.cite.as_ref(), at);
        Some(Joined {
            name: name.to_owned(),
            ident: Ident::new(text.name.as_deref().unwrap_or(name)),
            doc: text.doc.trim().to_owned(),
            width: shift,
            parts,
            order: text.order,
            cluster: None,
            cites,
        })
    }

    fn check_words(&mut self, message: &Message, origins: &[Origin], at: &Path) {
        let bytes = u64::from(message.word_width / 8);
        for (index, word) in message.words.iter().enumerate() {
            let place = Spot::Value(origins[index].path.key("offset"));
            if word.offset % bytes != 0 {
                let title = format!("`{}` is not aligned to its {bytes} bytes", word.name);
                self.find(Diagnostic::new(Code::Misaligned, place.clone(), title));
            }
            let overlap = message.words[..index].iter().position(|other| {
                other.offset < word.offset + bytes
                    && word.offset < other.offset + bytes
                    && (other.present_when.is_none() || other.present_when == word.present_when)
            });
            if let Some(other) = overlap {
                self.find(
                    Diagnostic::new(
                        Code::RegisterOverlap,
                        place.clone(),
                        format!("`{}` lies where `{}` is", word.name, message.words[other].name),
                    )
                    .also(Spot::Value(origins[other].path.key("offset")), "here")
                    .help("words may share an offset if each says `present_when` it has this layout"),
                );
            }
            if let Some(payload) = &message.payload {
                let end = payload.offset + u64::from(payload.sizes.iter().copied().max().unwrap_or(0));
                let behind = word.offset >= end && payload.sizes.len() == 1;
                if word.offset + bytes > payload.offset && !behind {
                    self.find(
                        Diagnostic::new(
                            Code::RegisterOverlap,
                            place,
                            format!("`{}` reaches into the payload", word.name),
                        )
                        .also(Spot::Value(at.key("payload").key("offset")), "the payload starts here")
                        .help("a word can follow the payload only if the payload has one size"),
                    );
                }
            }
        }
    }
}
