//! Message layouts of the model.

use super::{Cite, ConditionId, Dim, Field, FieldRef, Ident, Joined, MessageId, Part, RegisterId};

/// A message element.
#[derive(Debug, Clone)]
pub struct Message {
    /// The key in the description.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// Title.
    pub title: String,
    /// What it holds; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// Width in bits of its words.
    pub word_width: u32,
    /// The words in order of offset.
    pub words: Vec<Word>,
    /// The data bytes.
    pub payload: Option<Payload>,
    /// Values split over fields; a part's holder is an index into `words`.
    pub joined: Vec<Joined<usize>>,
    /// Bytes in front of the payload, or of the whole element if there is none.
    pub header_bytes: u64,
}

impl Message {
    /// Bytes of a whole element with a payload of `data` bytes.
    #[must_use]
    pub fn element_bytes(&self, data: u32) -> u64 {
        let with_payload = self.header_bytes + self.payload.as_ref().map_or(0, |_| u64::from(data));
        let last_word = self.words.iter().map(|w| w.offset + u64::from(self.word_width / 8)).max().unwrap_or(0);
        with_payload.max(last_word)
    }
}

/// One word of a message element.
#[derive(Debug, Clone)]
pub struct Word {
    /// The manual's name.
    pub name: String,
    /// Identifier of its type in generated code, unique in the model.
    pub ident: Ident,
    /// The word it shares its type with: the first one of that layout in the model.
    pub same_as: Option<(MessageId, usize)>,
    /// Byte offset in the element.
    pub offset: u64,
    /// What it holds; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// The configuration in which it has this layout.
    pub present_when: Option<ConditionId>,
    /// The fields.
    pub fields: Vec<Field>,
}

/// The data bytes of an element.
#[derive(Debug, Clone)]
pub struct Payload {
    /// Byte offset of the first data byte.
    pub offset: u64,
    /// Sizes in bytes, in the order of the codes of the size field.
    pub sizes: Vec<u32>,
    /// Name of the words, with `{n}`.
    pub word_label: String,
    /// Number of the first word.
    pub first_word: u32,
    /// Name of the bytes, with `{n}`.
    pub byte_label: String,
    /// What else is to be known; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// Placement of messages.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    /// Whose memory it is; may be empty.
    pub doc: String,
    /// Largest number of bytes one controller uses.
    pub limit: Option<u64>,
    /// Where it stands.
    pub cites: Vec<Cite>,
    /// The sections in order.
    pub sections: Vec<Section>,
}

/// A run of equal elements.
#[derive(Debug, Clone)]
pub struct Section {
    /// The key in the description.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// The message elements it can be made of.
    pub elements: Vec<MessageId>,
    /// What it is for; may be empty.
    pub doc: String,
    /// Where it starts.
    pub start: SectionStart,
    /// The fields that add up to the number of elements.
    pub count: Vec<FieldRef>,
    /// Largest number of elements.
    pub max: Option<u32>,
    /// The field that selects the payload size.
    pub payload_size: Option<FieldRef>,
    /// Condition under which the section exists.
    pub exists_when: Option<ConditionId>,
    /// The repetition, for a section per element of a cluster.
    pub dim: Option<Dim>,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// Where a section starts.
#[derive(Debug, Clone)]
pub enum SectionStart {
    /// Behind the section before it.
    Follows,
    /// At the value of these parts, times `unit` bytes.
    At {
        /// The parts of the address, least significant first.
        parts: Vec<Part<RegisterId>>,
        /// Bytes for one unit.
        unit: u32,
    },
}
