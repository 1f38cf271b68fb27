//! What a controller model is to the simulation.

use std::any::Any;

use can_wire::{Event, NodeId, Time, Wire};

use crate::{
    diagnostic::{Diagnostic, DiagnosticKind, Diagnostics},
    memory::{Memory, MemoryId},
    registers::{ReadAccess, RegisterFile, Slot, WriteAccess},
};

/// What a model can reach while it acts.
pub struct Context<'a> {
    /// The present.
    pub now: Time,
    /// The node of the controller on the bus.
    pub node: NodeId,
    /// The bus.
    pub wire: &'a mut Wire,
    /// The interrupt handler that is running, a number of its own for each call; `None` in the main program.
    pub handler: Option<u64>,
    pub(crate) controller: &'a str,
    pub(crate) memories: &'a mut [Memory],
    pub(crate) diagnostics: &'a mut Diagnostics,
}

impl Context<'_> {
    /// A memory.
    #[inline]
    #[must_use]
    pub fn memory(&mut self, id: MemoryId) -> &mut Memory {
        &mut self.memories[id.0]
    }

    /// Reports a mistake of the driver.
    pub fn report(&mut self, section: &'static str, kind: DiagnosticKind) {
        let controller = self.controller.to_owned();
        self.diagnostics.report(Diagnostic { time: self.now, controller, kind, section });
    }
}

/// A controller: registers that behave as described, and the behaviour behind them.
///
/// The simulation carries out accesses by the rules of the [`RegisterFile`] and calls the model around them; it hands
/// over the events of the model's node on the bus, and calls [`Model::on_timer`] at the time the model asks for.
pub trait Model: Any {
    /// The registers.
    fn registers(&self) -> &RegisterFile;

    /// The registers, for the simulation to carry out accesses.
    fn registers_mut(&mut self) -> &mut RegisterFile;

    /// The model has got its node.
    fn attached(&mut self, cx: &mut Context<'_>);

    /// The host is about to read a register: values that are worked out on demand are put into it.
    fn before_read(&mut self, cx: &mut Context<'_>, slot: Slot);

    /// The host has read a register.
    fn after_read(&mut self, cx: &mut Context<'_>, access: &ReadAccess);

    /// The host writes a register; nothing is stored yet. The model may change [`WriteAccess::new`].
    fn on_write(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess);

    /// The host has written a register.
    fn after_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess);

    /// The host has accessed a reserved address, whose flag is set.
    fn after_reserved(&mut self, cx: &mut Context<'_>, offset: u32);

    /// The host has written a word of a memory.
    fn memory_written(&mut self, cx: &mut Context<'_>, memory: MemoryId, word: usize);

    /// Something happened at the model's node.
    fn on_event(&mut self, cx: &mut Context<'_>, event: &Event);

    /// When [`Model::on_timer`] wants to be called.
    fn next_timer(&self) -> Option<Time>;

    /// The time that [`Model::next_timer`] has given has come.
    fn on_timer(&mut self, cx: &mut Context<'_>);

    /// Mask of the interrupt lines that are active.
    fn active_lines(&self) -> u32 {
        self.registers().active_lines()
    }

    /// The section of the manual to name with a diagnostic of the common part.
    fn section(&self, rule: Rule) -> &'static str;

    /// The whole state in words, for a test that has failed.
    fn describe(&self, now: Time) -> String;
}

/// A rule of the common part that a diagnostic can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Which addresses exist, and in which widths they are accessed.
    Addresses,
    /// Write conditions.
    Protection,
    /// Reads with side effects.
    ReadEffects,
    /// Interrupt lines.
    Interrupts,
}
