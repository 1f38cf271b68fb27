//! A simulation: controllers, memories and plain nodes on one bus or several, and the host's clock.

use std::{
    any::Any,
    cell::{Cell, RefCell},
    marker::PhantomData,
};

use can_frame::Frame;
use can_wire::{NodeConfig, NodeId, Time, TimingError, Wire};

use crate::{
    bus::{MemoryBus, RegisterBus},
    bus_log::BusEntry,
    buses::BusId,
    diagnostic::{Bits, Diagnostic, DiagnosticKind, Diagnostics, OnDiagnostic},
    handlers::Handlers,
    memory::{Memory, MemoryId},
    model::{Context, Model, Rule},
    peer::PeerId,
    scheduler::{Advanced, Core, LineChange},
    trace::AccessRecord,
};

/// A controller of a [`Sim`], with the type of its model.
#[derive(Debug)]
pub struct Handle<M> {
    pub(crate) index: usize,
    model: PhantomData<fn() -> M>,
}

impl<M> Clone for Handle<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Handle<M> {}

/// What a simulation is built with.
#[derive(Clone, Copy, Debug)]
pub struct SimBuilder {
    access_cost: Time,
    on_diagnostic: OnDiagnostic,
    log_limit: usize,
}

impl SimBuilder {
    /// What one access of the host to a register or a memory costs; 100 ns unless set. It must not be zero for a driver
    /// that polls: its loop would never see time pass.
    #[must_use]
    pub const fn access_cost(mut self, cost: Time) -> Self {
        self.access_cost = cost;
        self
    }

    /// Makes the first mistake of a driver panic.
    #[must_use]
    pub const fn panic_on_diagnostic(mut self) -> Self {
        self.on_diagnostic = OnDiagnostic::Panic;
        self
    }

    /// How many entries of [`Sim::bus_log`] are kept; 4096 unless set.
    #[must_use]
    pub const fn log_limit(mut self, entries: usize) -> Self {
        self.log_limit = entries;
        self
    }

    /// An empty simulation at time zero.
    #[must_use]
    pub fn build(self) -> Sim {
        let diagnostics = Diagnostics { policy: self.on_diagnostic, list: Vec::new() };
        let core = Core::new(diagnostics, self.log_limit);
        Sim {
            core: RefCell::new(core),
            handlers: Handlers::default(),
            cost: self.access_cost,
            accesses: Cell::new(0),
            interruption: RefCell::new(None),
            interrupt_at: Cell::new(u64::MAX),
        }
    }
}

/// Controllers, memories and plain nodes on one bus or several.
///
/// Time moves with every access of the host, and with [`Sim::run_for`] and [`Sim::run_until`]. A run is deterministic.
pub struct Sim {
    core: RefCell<Core>,
    handlers: Handlers,
    cost: Time,
    /// Accesses of the host so far, and what is to happen before one of them.
    accesses: Cell<u64>,
    interrupt_at: Cell<u64>,
    interruption: RefCell<Option<Interruption>>,
}

/// What happens between two accesses of the host.
type Interruption = Box<dyn FnOnce(&Sim)>;

impl Default for Sim {
    fn default() -> Self {
        Self::new()
    }
}

impl Sim {
    /// An empty simulation at time zero with the builder's usual values.
    #[must_use]
    pub fn new() -> Self {
        Self::builder().build()
    }

    /// Settings before the start.
    #[must_use]
    pub const fn builder() -> SimBuilder {
        SimBuilder { access_cost: Time::from_ns(100), on_diagnostic: OnDiagnostic::Collect, log_limit: 4096 }
    }

    /// Adds a memory.
    pub fn add_memory(&self, memory: Memory) -> MemoryId {
        let mut core = self.core.borrow_mut();
        core.memories.push(memory);
        MemoryId(core.memories.len() - 1)
    }

    /// Adds a bus beside the one that every simulation has; all share one time.
    pub fn add_bus(&self) -> BusId {
        self.core.borrow_mut().buses.add()
    }

    /// Adds a controller with a node on the first bus. `place` is the node's clock and place on the bus; what the
    /// controller's registers set is overwritten when it goes on the bus.
    ///
    /// # Errors
    /// A [`TimingError`] if `place` describes no node.
    pub fn add<M: Model>(&self, name: &str, place: NodeConfig, model: M) -> Result<Handle<M>, TimingError> {
        self.add_on(BusId::default(), name, place, model)
    }

    /// The same on a bus of choice.
    ///
    /// # Errors
    /// A [`TimingError`] if `place` describes no node.
    pub fn add_on<M: Model>(
        &self,
        bus: BusId,
        name: &str,
        place: NodeConfig,
        model: M,
    ) -> Result<Handle<M>, TimingError> {
        let index = self.core.borrow_mut().add_controller(bus, name, place, Box::new(model))?;
        Ok(Handle { index, model: PhantomData })
    }

    /// Adds a node without controller in normal mode to the first bus.
    ///
    /// # Errors
    /// A [`TimingError`] if `config` describes no node.
    pub fn add_peer(&self, config: NodeConfig) -> Result<PeerId, TimingError> {
        self.add_peer_on(BusId::default(), config)
    }

    /// The same on a bus of choice.
    ///
    /// # Errors
    /// A [`TimingError`] if `config` describes no node.
    pub fn add_peer_on(&self, bus: BusId, config: NodeConfig) -> Result<PeerId, TimingError> {
        self.core.borrow_mut().add_peer(bus, config).map(PeerId)
    }

    /// Queues a frame at a node without controller. It is sent again until it has arrived.
    pub fn peer_send(&self, peer: PeerId, frame: Frame) {
        let mut core = self.core.borrow_mut();
        let (peer, wire) = core.peer(peer.0);
        peer.queue.push_back(frame);
        if peer.queue.len() == 1 {
            peer.send(wire);
        }
    }

    /// What a node without controller has received, with the time of each.
    #[must_use]
    pub fn peer_received(&self, peer: PeerId) -> Vec<(Time, Frame)> {
        self.core.borrow().peers[peer.0].received.clone()
    }

    /// What a node without controller has received since it was asked last.
    pub fn take_peer_received(&self, peer: PeerId) -> Vec<(Time, Frame)> {
        core::mem::take(&mut self.core.borrow_mut().peers[peer.0].received)
    }

    /// What a node without controller has sent, with the time of each.
    #[must_use]
    pub fn peer_sent(&self, peer: PeerId) -> Vec<(Time, Frame)> {
        self.core.borrow().peers[peer.0].sent.clone()
    }

    /// The node of a node without controller.
    #[must_use]
    pub fn peer_node(&self, peer: PeerId) -> NodeId {
        self.core.borrow().peers[peer.0].node
    }

    /// The node of a controller.
    #[must_use]
    pub fn node<M>(&self, controller: Handle<M>) -> NodeId {
        self.core.borrow().entries[controller.index].node
    }

    /// The bus to a controller's registers, for a peripheral of its register crate.
    #[must_use]
    pub const fn registers<M>(&self, controller: Handle<M>) -> RegisterBus<'_> {
        RegisterBus::new(self, controller.index)
    }

    /// The bus to a memory, for message elements of a register crate.
    #[must_use]
    pub const fn memory(&self, id: MemoryId) -> MemoryBus<'_> {
        MemoryBus::new(self, id)
    }

    /// Looks at, or fills, the words of a memory; costs no time and tells no controller.
    pub fn with_memory<R>(&self, id: MemoryId, look: impl FnOnce(&mut Memory) -> R) -> R {
        look(&mut self.core.borrow_mut().memories[id.0])
    }

    /// Lets the first bus be looked at, disturbed or traced.
    pub fn with_wire<R>(&self, act: impl FnOnce(&mut Wire) -> R) -> R {
        self.with_wire_of(BusId::default(), act)
    }

    /// Lets a bus be looked at, disturbed or traced.
    pub fn with_wire_of<R>(&self, bus: BusId, act: impl FnOnce(&mut Wire) -> R) -> R {
        act(&mut self.core.borrow_mut().buses.get_mut(bus).wire)
    }

    /// Looks at a model.
    ///
    /// # Panics
    /// If the handle is of another simulation.
    pub fn inspect<M: Model, R>(&self, controller: Handle<M>, look: impl FnOnce(&M) -> R) -> R {
        let core = self.core.borrow();
        let model: &dyn Any = &*core.entries[controller.index].model;
        look(model.downcast_ref().expect("a handle is used with the simulation that gave it"))
    }

    /// Acts on a model: pins, injected events.
    ///
    /// # Panics
    /// If the handle is of another simulation.
    pub fn act<M: Model, R>(&self, controller: Handle<M>, act: impl FnOnce(&mut M, &mut Context<'_>) -> R) -> R {
        let result = self.core.borrow_mut().with_model(controller.index, |model, cx| {
            let model: &mut dyn Any = model;
            act(model.downcast_mut().expect("a handle is used with the simulation that gave it"), cx)
        });
        self.handlers.serve(self);
        result
    }

    /// The whole state of a controller in words.
    #[must_use]
    pub fn describe<M>(&self, controller: Handle<M>) -> String {
        let core = self.core.borrow();
        core.entries[controller.index].model.describe(core.now())
    }

    /// The present.
    #[must_use]
    pub fn now(&self) -> Time {
        self.core.borrow().now()
    }

    /// Lets time pass.
    pub fn run_for(&self, span: Time) {
        self.run_to(self.now() + span);
    }

    /// Lets time pass until a point in time; does nothing if it is past.
    pub fn run_to(&self, until: Time) {
        let pause = !self.handlers.is_running();
        while self.core.borrow_mut().advance(until, pause, false) == Advanced::Event {
            self.handlers.serve(self);
        }
    }

    /// Lets time pass until a condition holds, looked at after every event, for `limit` at most. Returns when it held.
    pub fn run_until(&self, limit: Time, mut condition: impl FnMut(&Self) -> bool) -> Option<Time> {
        let end = self.now() + limit;
        let pause = !self.handlers.is_running();
        loop {
            if condition(self) {
                return Some(self.now());
            }
            let advanced = self.core.borrow_mut().advance(end, pause, true);
            self.handlers.serve(self);
            if advanced == Advanced::Done {
                return condition(self).then(|| self.now());
            }
        }
    }

    /// True while an interrupt line of a controller is active; lines count from 0 in the order of its description.
    #[must_use]
    pub fn line<M>(&self, controller: Handle<M>, line: usize) -> bool {
        self.line_level(controller.index, line)
    }

    /// Calls `act` with the new level at every change of an interrupt line.
    pub fn on_line<M>(&self, controller: Handle<M>, line: usize, act: impl FnMut(&Self, bool) + 'static) {
        self.handlers.add(controller.index, line, false, Box::new(act));
    }

    /// Attaches an interrupt handler as a level-sensitive interrupt controller does: it is called when the line becomes
    /// active and again for as long as it is. It may access registers; other handlers wait meanwhile.
    pub fn on_interrupt<M>(&self, controller: Handle<M>, line: usize, mut act: impl FnMut(&Self) + 'static) {
        self.handlers.add(controller.index, line, true, Box::new(move |sim, _| act(sim)));
    }

    /// What a driver has done wrong so far.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.core.borrow().diagnostics.list.clone()
    }

    /// The same, and forgets it.
    pub fn take_diagnostics(&self) -> Vec<Diagnostic> {
        core::mem::take(&mut self.core.borrow_mut().diagnostics.list)
    }

    /// What was on the first bus: the latest entries, oldest first.
    #[must_use]
    pub fn bus_log(&self) -> Vec<BusEntry> {
        self.bus_log_of(BusId::default())
    }

    /// What was on a bus: the latest entries, oldest first.
    #[must_use]
    pub fn bus_log_of(&self, bus: BusId) -> Vec<BusEntry> {
        self.core.borrow().buses.get(bus).log.entries.iter().copied().collect()
    }

    /// The frames on the first bus, oldest first, with the node that sent each.
    #[must_use]
    pub fn frames_on_bus(&self) -> Vec<(NodeId, Frame)> {
        let frame = |entry: BusEntry| match entry {
            BusEntry::Frame { node, frame, .. } => Some((node, frame)),
            _ => None,
        };
        self.bus_log().into_iter().filter_map(frame).collect()
    }

    /// Begins to record register accesses, or ends it; returns what was recorded.
    pub fn trace(&self, on: bool) -> Vec<AccessRecord> {
        let next = on.then(Vec::new);
        core::mem::replace(&mut self.core.borrow_mut().trace, next).unwrap_or_default()
    }

    /// Accesses of the host to registers and memories so far.
    #[must_use]
    pub fn accesses(&self) -> u64 {
        self.accesses.get()
    }

    /// Lets `act` run between two accesses of the host: `skip` accesses happen first. This is how a test puts an event
    /// between the read and the write of a driver. A second call replaces an interruption that has not happened yet.
    pub fn interrupt_host(&self, skip: u64, act: impl FnOnce(&Self) + 'static) {
        self.interrupt_at.set(self.accesses.get() + skip);
        *self.interruption.borrow_mut() = Some(Box::new(act));
    }

    /// One access of the host costs time, in which things happen.
    fn elapse(&self) {
        let number = self.accesses.get();
        self.accesses.set(number + 1);
        if number == self.interrupt_at.get() {
            self.interrupt_at.set(u64::MAX);
            let act = self.interruption.borrow_mut().take();
            if let Some(act) = act {
                act(self);
            }
        }
        self.run_to(self.now() + self.cost);
    }

    pub(crate) fn read_register(&self, index: usize, offset: usize, width: Bits) -> u32 {
        self.elapse();
        let value = self.core.borrow_mut().read_register(index, offset as u32, width);
        self.handlers.serve(self);
        value
    }

    pub(crate) fn write_register(&self, index: usize, offset: usize, width: Bits, value: u32) {
        self.elapse();
        self.core.borrow_mut().write_register(index, offset as u32, width, value);
        self.handlers.serve(self);
    }

    pub(crate) fn read_memory(&self, id: MemoryId, offset: usize, width: Bits) -> u32 {
        self.elapse();
        self.core.borrow_mut().read_memory(id, offset, width)
    }

    pub(crate) fn write_memory(&self, id: MemoryId, offset: usize, width: Bits, value: u32) {
        self.elapse();
        self.core.borrow_mut().write_memory(id, offset, width, value);
    }

    pub(crate) fn set_handler(&self, handler: Option<u64>) {
        self.core.borrow_mut().handler = handler;
    }

    pub(crate) fn next_line_change(&self) -> Option<LineChange> {
        self.core.borrow_mut().changes.pop_front()
    }

    pub(crate) fn line_level(&self, controller: usize, line: usize) -> bool {
        self.core.borrow().entries[controller].lines >> line & 1 == 1
    }

    pub(crate) fn report_storm(&self, controller: usize, line: usize, entries: u32) {
        let mut core = self.core.borrow_mut();
        let entry = &core.entries[controller];
        let (name, section) = (entry.name.clone(), entry.model.section(Rule::Interrupts));
        core.report(&name, section, DiagnosticKind::InterruptStorm { line, entries });
    }
}
