//! From the typed text to the model: names become references, defaults are filled in.
//!
//! The passes run in the order of their dependencies; each reports all it finds and goes on with what is usable.

mod behaviour;
mod conditions;
mod enums;
mod expression;
mod fields;
mod header;
mod interrupts;
mod joined;
mod like;
mod memory;
mod messages;
mod references;
mod registers;
mod resets;
mod timing;
mod windows;

pub(crate) use resets::bit_list;

use std::collections::{HashMap, HashSet};

use crate::diagnostic::Findings;
use crate::model::{ConditionId, EnumId, Interrupts, Memory, MessageId, Model, Names, RegisterId, WindowId};
use crate::path::Path;
use crate::syntax::Description;

/// Where a register and its fields stand in the file.
#[derive(Debug, Clone)]
pub(crate) struct Origin {
    pub path: Path,
    pub fields: Vec<Path>,
}

/// The model with the places its parts come from.
#[derive(Debug)]
pub(crate) struct Lowered {
    pub model: Model,
    /// Every window of the file is in the model.
    pub windows_known: bool,
    /// Parallel to [`Model::registers`].
    pub registers: Vec<Origin>,
    /// Parallel to [`Model::enums`].
    pub enums: Vec<Path>,
    /// Parallel to [`Model::conditions`].
    pub conditions: Vec<Path>,
    /// Parallel to [`Model::reserved`], with the first offset again.
    pub reserved: Vec<(u64, Path)>,
    /// Parallel to [`Model::messages`], then to their words.
    pub words: Vec<Vec<Origin>>,
}

/// The state that the passes share.
pub(crate) struct Lowering<'a> {
    pub text: &'a Description,
    pub findings: &'a mut Findings,
    pub out: Lowered,
    /// Names of registers and members of clusters.
    pub register_names: HashMap<String, RegisterId>,
    pub enum_names: HashMap<String, EnumId>,
    pub condition_names: HashMap<String, ConditionId>,
    pub window_names: HashMap<String, WindowId>,
    pub message_names: HashMap<String, MessageId>,
    /// Conditions written at a field, by their text.
    pub inline_conditions: HashMap<String, Vec<ConditionId>>,
    /// Registers and fields that are in the file but not in the model, because they are reported already.
    pub lost_registers: HashSet<String>,
    pub lost_fields: HashSet<(fields::Holder, String)>,
    /// Write conditions of fields, to be resolved once all fields are known.
    pub pending: Vec<fields::PendingRules>,
    /// Bytes of text that the model repeats.
    pub copied: usize,
}

pub(crate) fn lower(text: &Description, findings: &mut Findings) -> Lowered {
    let model = Model {
        names: Names::new(&text.controller),
        title: text.title.clone(),
        doc: text.doc.clone().unwrap_or_default(),
        manual: text.manual.clone(),
        sources: text.sources.clone(),
        prefix: text.prefix.clone().unwrap_or_default(),
        access_widths: {
            let mut widths = text.access_widths.clone();
            widths.sort_unstable();
            widths.dedup();
            widths
        },
        span: text.span.0.min(header::MAX_ADDRESS),
        aliases: Vec::new(),
        windows: Vec::new(),
        conditions: Vec::new(),
        enums: Vec::new(),
        registers: Vec::new(),
        clusters: Vec::new(),
        joined: Vec::new(),
        reserved: Vec::new(),
        effects: Vec::new(),
        interrupts: Interrupts::default(),
        messages: Vec::new(),
        memory: Memory::default(),
        bit_timing: None,
        instances: Vec::new(),
        conflicts: Vec::new(),
        choices: Vec::new(),
    };
    let out = Lowered {
        model,
        windows_known: true,
        registers: Vec::new(),
        enums: Vec::new(),
        conditions: Vec::new(),
        reserved: Vec::new(),
        words: Vec::new(),
    };
    let mut lowering = Lowering {
        text,
        findings,
        out,
        register_names: HashMap::new(),
        enum_names: HashMap::new(),
        condition_names: HashMap::new(),
        window_names: HashMap::new(),
        message_names: HashMap::new(),
        inline_conditions: HashMap::new(),
        lost_registers: HashSet::new(),
        lost_fields: HashSet::new(),
        pending: Vec::new(),
        copied: 0,
    };
    lowering.header();
    lowering.enums();
    lowering.window_names();
    lowering.registers();
    lowering.windows();
    lowering.conditions();
    lowering.rules();
    lowering.joined();
    lowering.reserved();
    lowering.messages();
    lowering.memory();
    lowering.behaviour();
    lowering.capabilities();
    lowering.out
}
