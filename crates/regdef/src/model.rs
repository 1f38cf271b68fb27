//! The checked model: what every emitter, the simulator's metadata and the tests are made from.
//!
//! Nothing in it is still to be resolved: references are indices, defaults are filled in, arrays and lanes are
//! explicit, conditions are trees over fields. A model exists only if its description had no errors.

mod access;
mod behaviour;
mod expr;
mod memory;
mod names;
mod register;

pub use access::{Access, Neutral, WriteEffect};
pub use behaviour::{
    BitTiming, Choice, Clock, Conflict, Effect, Instance, InterruptLine, InterruptSource, Interrupts, Reading, Target,
    TimingPhase, TransmitterDelay,
};
pub use expr::{Comparison, Condition, Expr, LaneIndex};
pub use memory::{Memory, Message, Payload, Section, SectionStart, Word};
pub use names::{Ident, Names};
pub use register::{
    Capabilities, Cluster, Dim, Enum, EnumVariant, Field, FieldReset, Kind, Lanes, NoModify, Register, ReservedRange,
    Reset, Window, bit_mask,
};

pub use crate::syntax::{
    AccessCode, AliasOp, Cite, Encoding, HalfOrder, Manual, OffsetReference, OnRead, Phase2Within, ReadEffect,
    ResetKind, Source,
};

use indexmap::IndexMap;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub usize);
    )*};
}

ids! {
    /// Index into [`Model::registers`].
    RegisterId
    /// Index into [`Model::clusters`].
    ClusterId
    /// Index into [`Model::enums`].
    EnumId
    /// Index into [`Model::conditions`].
    ConditionId
    /// Index into [`Model::windows`].
    WindowId
    /// Index into [`Model::messages`].
    MessageId
    /// Index into [`Interrupts::lines`].
    LineId
    /// Index into [`Interrupts::sources`].
    InterruptId
}

/// A field of a register.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FieldRef {
    /// The register.
    pub register: RegisterId,
    /// Index into [`Register::fields`].
    pub field: usize,
}

/// A whole controller.
#[derive(Debug, Clone)]
pub struct Model {
    /// Identifiers of the controller in the generated code.
    pub names: Names,
    /// The controller's name as a person would say it.
    pub title: String,
    /// What it is; may be empty.
    pub doc: String,
    /// The manual.
    pub manual: Manual,
    /// Sources outside the manual, by key.
    pub sources: IndexMap<String, Source>,
    /// The manual's placeholder in front of register names, such as `Cx`; may be empty.
    pub prefix: String,
    /// Widths in bits of legal bus accesses, ascending.
    pub access_widths: Vec<u8>,
    /// Bytes the register block occupies.
    pub span: u64,
    /// Alias registers beside every register that has [`Register::aliased`].
    pub aliases: Vec<Alias>,
    /// Register windows.
    pub windows: Vec<Window>,
    /// Conditions: the named ones in the order of the file, then those written at a field.
    pub conditions: Vec<Condition>,
    /// Enumerations: the shared ones in the order of the file, then those written at a field.
    pub enums: Vec<Enum>,
    /// All registers: those of the block in the order of the file, then those of each cluster.
    pub registers: Vec<Register>,
    /// Clusters.
    pub clusters: Vec<Cluster>,
    /// Values split over several registers.
    pub joined: Vec<Joined>,
    /// Address ranges without a register.
    pub reserved: Vec<ReservedRange>,
    /// What states of the registers do to other registers.
    pub effects: Vec<Effect>,
    /// Interrupt lines and sources; both empty if the description has none.
    pub interrupts: Interrupts,
    /// Message layouts.
    pub messages: Vec<Message>,
    /// Placement of messages; no sections if the description has none.
    pub memory: Memory,
    /// Bit timing, for a controller that has one.
    pub bit_timing: Option<BitTiming>,
    /// Known chips.
    pub instances: Vec<Instance>,
    /// Contradictions of the manual.
    pub conflicts: Vec<Conflict>,
    /// Silences of the manual.
    pub choices: Vec<Choice>,
}

/// An alias register beside every register.
#[derive(Debug, Clone)]
pub struct Alias {
    /// Suffix to the register's name: `CLR`, `SET`, `INV`.
    pub name: String,
    /// Byte offset from the register.
    pub offset: u64,
    /// What writing 1 does.
    pub op: AliasOp,
    /// What else is to be known; may be empty.
    pub doc: String,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

/// A part of a joined value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part<R> {
    /// The register or word that holds the part.
    pub holder: R,
    /// The field, or `None` for the whole register.
    pub field: Option<usize>,
    /// Least significant bit in the holder.
    pub lsb: u32,
    /// Number of bits.
    pub width: u32,
    /// Position of the part's least significant bit in the joined value.
    pub shift: u32,
}

/// A value split over several holders: registers ([`Model::joined`]) or words of a message ([`Message::joined`]).
#[derive(Debug, Clone)]
pub struct Joined<R = RegisterId> {
    /// The key in the description.
    pub name: String,
    /// Identifier in generated code.
    pub ident: Ident,
    /// What the value means.
    pub doc: String,
    /// Number of bits.
    pub width: u32,
    /// The parts, least significant first.
    pub parts: Vec<Part<R>>,
    /// Order of access to separate registers.
    pub order: HalfOrder,
    /// The cluster whose element holds all parts, if they are in one.
    pub cluster: Option<ClusterId>,
    /// Where it stands.
    pub cites: Vec<Cite>,
}

impl Model {
    /// The register behind an index.
    #[must_use]
    pub fn register(&self, id: RegisterId) -> &Register {
        &self.registers[id.0]
    }

    /// The field behind a reference.
    #[must_use]
    pub fn field(&self, at: FieldRef) -> &Field {
        &self.registers[at.register.0].fields[at.field]
    }

    /// `REG.FIELD` as the description writes it.
    #[must_use]
    pub fn field_path(&self, at: FieldRef) -> String {
        format!("{}.{}", self.register(at.register).name, self.field(at).name)
    }

    /// The enumeration behind an index.
    #[must_use]
    pub fn enumeration(&self, id: EnumId) -> &Enum {
        &self.enums[id.0]
    }

    /// The condition behind an index.
    #[must_use]
    pub fn condition(&self, id: ConditionId) -> &Condition {
        &self.conditions[id.0]
    }

    /// Registers of the block itself, without those of clusters, in the order of the file.
    pub fn block_registers(&self) -> impl Iterator<Item = (RegisterId, &Register)> {
        self.registers.iter().enumerate().filter(|(_, r)| r.cluster.is_none()).map(|(i, r)| (RegisterId(i), r))
    }

    /// Registers of one cluster in the order of the file.
    pub fn cluster_registers(&self, cluster: ClusterId) -> impl Iterator<Item = (RegisterId, &Register)> {
        let of = move |r: &Register| r.cluster == Some(cluster);
        self.registers.iter().enumerate().filter(move |(_, r)| of(r)).map(|(i, r)| (RegisterId(i), r))
    }

    /// Every physical register with its address: arrays and clusters unrolled, in order of address; registers
    /// of the device, which have no address, are left out.
    #[must_use]
    pub fn instances_of_registers(&self) -> Vec<Placed> {
        let mut all = Vec::new();
        for (index, register) in self.registers.iter().enumerate() {
            let Some(offset) = register.offset else { continue };
            let (base, outer) = match register.cluster {
                Some(id) => (self.clusters[id.0].offset, Some(&self.clusters[id.0].dim)),
                None => (0, None),
            };
            for element in 0..outer.map_or(1, |dim| dim.count) {
                for inner in 0..register.dim.as_ref().map_or(1, |dim| dim.count) {
                    let step = |dim: Option<&Dim>, n: u32| dim.map_or(0, |dim| dim.stride * u64::from(n));
                    all.push(Placed {
                        register: RegisterId(index),
                        offset: base + offset + step(outer, element) + step(register.dim.as_ref(), inner),
                        element,
                        inner,
                    });
                }
            }
        }
        all.sort_by_key(|placed| placed.offset);
        all
    }
}

/// One physical register.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placed {
    /// The register it is an instance of.
    pub register: RegisterId,
    /// Byte offset from the base of the block.
    pub offset: u64,
    /// Position in the cluster, from 0.
    pub element: u32,
    /// Position in the register's own array, from 0.
    pub inner: u32,
}

impl Placed {
    /// The manual's name of the register, number included, without the prefix.
    #[must_use]
    pub fn label(&self, model: &Model) -> String {
        let register = model.register(self.register);
        match (&register.dim, register.cluster) {
            (Some(dim), _) => register.label_of(dim, self.inner),
            (None, Some(cluster)) => register.label_of(&model.clusters[cluster.0].dim, self.element),
            (None, None) => register.label.clone(),
        }
    }

    /// Number that lane 0 of the register's fields has in this instance, before the field's own `first`.
    #[must_use]
    pub fn position(&self, model: &Model) -> u32 {
        if model.register(self.register).dim.is_some() { self.inner } else { self.element }
    }
}
