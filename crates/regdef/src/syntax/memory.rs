//! Message memory as it is written.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{Cite, Field, Int, Joined, OneOrMany};

/// A message element in memory: a received message, a message to send, an event, a filter.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Message {
    /// Title.
    pub title: String,
    /// Width in bits of the words it is made of: 16 or 32.
    pub word: u8,
    /// What it holds.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands. Also holds for its words and fields.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// Another message whose words this one shares; words given here add or override.
    #[serde(default)]
    pub extends: Option<String>,
    /// The words by the manual's names, in order.
    #[serde(default)]
    pub words: IndexMap<String, MessageWord>,
    /// The data bytes behind the words.
    #[serde(default)]
    pub payload: Option<Payload>,
    /// Values split over words or fields.
    #[serde(default)]
    pub joined: IndexMap<String, Joined>,
}

/// One word of a message element.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MessageWord {
    /// Byte offset from the start of the element. Two words may share an offset if each says `present_when`.
    pub offset: Int,
    /// What the word holds.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// The configuration in which the word has this layout: an expression over register fields.
    #[serde(default)]
    pub present_when: Option<String>,
    /// The word of another message that this one equals: `MESSAGE.WORD`. `fields` here add or override.
    #[serde(default)]
    pub like: Option<String>,
    /// The fields.
    #[serde(default)]
    pub fields: IndexMap<String, Field>,
}

/// The data bytes of a message element.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Payload {
    /// Byte offset of the first data byte.
    pub offset: Int,
    /// Sizes in bytes an element can be configured for, in the order of the codes of the size field.
    pub sizes: Vec<u32>,
    /// Name of the payload words with `{n}` for the number of the word: `"R{n}"`.
    pub word_label: String,
    /// The manual's number of the first payload word.
    pub first_word: u32,
    /// Name of the data bytes with `{n}` for the number of the byte: `"DB{n}"`.
    #[serde(default)]
    pub byte_label: Option<String>,
    /// What else is to be known, such as what stands behind the last received byte.
    #[serde(default)]
    pub doc: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}

/// Where message elements lie in memory.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Memory {
    /// Whose memory it is, and how addresses are formed.
    pub doc: String,
    /// Largest number of bytes one controller uses.
    #[serde(default)]
    pub limit: Option<Int>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
    /// The sections: each a run of equal elements.
    #[serde(default)]
    pub sections: IndexMap<String, Section>,
}

/// A run of equal elements in memory.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// The message elements it is made of.
    pub elements: OneOrMany<String>,
    /// What it is for.
    #[serde(default)]
    pub doc: Option<String>,
    /// The field or joined value that holds its start: `RXF0C.F0SA`. Left out, it follows the section before it.
    #[serde(default)]
    pub start: Option<String>,
    /// Bytes for one unit of the start field; 1 if left out.
    #[serde(default)]
    pub start_unit: Option<u32>,
    /// The fields that add up to the number of elements. An `encoding` of the field applies.
    #[serde(default)]
    pub count: Vec<String>,
    /// Largest number of elements.
    #[serde(default)]
    pub max: Option<u32>,
    /// The field that selects the payload size: an index into the `sizes` of the element.
    #[serde(default)]
    pub payload_size: Option<String>,
    /// Condition under which the section exists: an expression over register fields.
    #[serde(default)]
    pub exists_when: Option<String>,
    /// Where it stands.
    #[serde(default)]
    pub cite: Option<OneOrMany<Cite>>,
}
