//! The scheduler: joins the models, the buses and the host in one order of events.

use std::collections::VecDeque;

use can_wire::{Mode, NodeConfig, NodeId, Time, TimingError, Wire};

use crate::{
    access::AccessWidth,
    buses::{BusId, Buses, Owner},
    diagnostic::{Diagnostic, DiagnosticKind, Diagnostics},
    memory::{Memory, MemoryId},
    model::{Context, Model},
    peer::Peer,
    trace::AccessRecord,
};

/// A controller in the simulation.
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) model: Box<dyn Model>,
    pub(crate) bus: BusId,
    pub(crate) node: NodeId,
    pub(crate) lines: u32,
    timer: Option<Time>,
}

/// A line has changed its level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LineChange {
    pub(crate) controller: usize,
    pub(crate) line: usize,
    pub(crate) active: bool,
}

/// How far [`Core::advance`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Advanced {
    /// To the limit.
    Done,
    /// To an event before it.
    Event,
}

pub(crate) struct Core {
    pub(crate) buses: Buses,
    pub(crate) entries: Vec<Entry>,
    pub(crate) memories: Vec<Memory>,
    pub(crate) peers: Vec<Peer>,
    pub(crate) diagnostics: Diagnostics,
    pub(crate) trace: Option<Vec<AccessRecord>>,
    pub(crate) changes: VecDeque<LineChange>,
    pub(crate) handler: Option<u64>,
}

impl Core {
    pub(crate) fn new(diagnostics: Diagnostics, log_limit: usize) -> Self {
        Self {
            buses: Buses::new(log_limit),
            entries: Vec::new(),
            memories: Vec::new(),
            peers: Vec::new(),
            diagnostics,
            trace: None,
            changes: VecDeque::new(),
            handler: None,
        }
    }

    pub(crate) fn add_controller(
        &mut self,
        bus: BusId,
        name: &str,
        place: NodeConfig,
        model: Box<dyn Model>,
    ) -> Result<usize, TimingError> {
        let index = self.entries.len();
        let node = self.buses.get_mut(bus).add_node(place, Owner::Controller(index))?;
        self.entries.push(Entry { name: name.to_owned(), model, bus, node, lines: 0, timer: None });
        self.with_model(index, |model, cx| model.attached(cx));
        Ok(index)
    }

    pub(crate) fn add_peer(&mut self, bus: BusId, config: NodeConfig) -> Result<usize, TimingError> {
        let index = self.peers.len();
        let bus_of_peer = self.buses.get_mut(bus);
        let node = bus_of_peer.add_node(config, Owner::Peer(index))?;
        bus_of_peer.wire.set_mode(node, Mode::Normal);
        self.peers.push(Peer::new(bus, node));
        Ok(index)
    }

    /// A peer, and its wire.
    pub(crate) fn peer(&mut self, index: usize) -> (&mut Peer, &mut Wire) {
        let peer = &mut self.peers[index];
        let wire = &mut self.buses.get_mut(peer.bus).wire;
        (peer, wire)
    }

    #[inline]
    pub(crate) fn now(&self) -> Time {
        self.buses.now()
    }

    /// Lets a model act, and takes notice of what that changed.
    #[inline]
    pub(crate) fn with_model<R>(&mut self, index: usize, act: impl FnOnce(&mut dyn Model, &mut Context<'_>) -> R) -> R {
        let (model, mut cx) = self.model(index);
        let result = act(model, &mut cx);
        self.notice(index);
        result
    }

    #[inline]
    fn model(&mut self, index: usize) -> (&mut dyn Model, Context<'_>) {
        let Self { entries, buses, memories, diagnostics, handler, .. } = self;
        let Entry { name, model, bus, node, .. } = &mut entries[index];
        let wire = &mut buses.get_mut(*bus).wire;
        let (now, node, controller, handler) = (wire.now(), *node, name.as_str(), *handler);
        (&mut **model, Context { now, node, wire, handler, controller, memories, diagnostics })
    }

    fn notice(&mut self, index: usize) {
        let entry = &mut self.entries[index];
        entry.timer = entry.model.next_timer();
        let lines = entry.model.active_lines();
        let changed = core::mem::replace(&mut entry.lines, lines) ^ lines;
        for line in (0..32).filter(|line| changed >> line & 1 == 1) {
            self.changes.push_back(LineChange { controller: index, line, active: lines >> line & 1 == 1 });
        }
    }

    /// Lets everything happen that is due by `limit`. With `once` it stops after one event, with `pause` when an
    /// interrupt line has changed.
    pub(crate) fn advance(&mut self, limit: Time, pause: bool, once: bool) -> Advanced {
        loop {
            if pause && !self.changes.is_empty() {
                return Advanced::Event;
            }
            let timers = self.entries.iter().enumerate().filter_map(|(index, entry)| Some((entry.timer?, index)));
            let timer = timers.min().filter(|(at, _)| *at <= limit);
            let until = timer.map_or(limit, |(at, _)| at);
            if let Some((bus, owner, event)) = self.buses.next_event(until) {
                match owner {
                    Owner::Controller(index) => self.with_model(index, |model, cx| model.on_event(cx, &event)),
                    Owner::Peer(index) => self.peers[index].on_event(&mut self.buses.get_mut(bus).wire, &event),
                }
            } else if let Some((_, index)) = timer {
                self.with_model(index, |model, cx| model.on_timer(cx));
            } else {
                return Advanced::Done;
            }
            if once {
                return Advanced::Event;
            }
        }
    }

    pub(crate) fn report(&mut self, controller: &str, section: &'static str, kind: DiagnosticKind) {
        let (time, controller) = (self.now(), controller.to_owned());
        self.diagnostics.report(Diagnostic { time, controller, kind, section });
    }

    pub(crate) fn read_memory(&mut self, id: MemoryId, offset: usize, width: AccessWidth) -> u32 {
        if self.refuse_memory(id, offset, width, false) {
            return 0;
        }
        self.memories[id.0].read(offset, width).unwrap_or_else(|| {
            self.report("", "", DiagnosticKind::UnknownAddress { offset: offset as u32, write: false });
            0
        })
    }

    pub(crate) fn write_memory(&mut self, id: MemoryId, offset: usize, width: AccessWidth, value: u32) {
        if self.refuse_memory(id, offset, width, true) {
            return;
        }
        if !self.memories[id.0].write(offset, width, value) {
            self.report("", "", DiagnosticKind::UnknownAddress { offset: offset as u32, write: true });
            return;
        }
        for index in 0..self.entries.len() {
            let (model, mut cx) = self.model(index);
            model.memory_written(&mut cx, id, offset / 4);
        }
    }

    fn refuse_memory(&mut self, id: MemoryId, offset: usize, width: AccessWidth, write: bool) -> bool {
        let legal = self.memories[id.0].widths().contains(&width.0) && offset.is_multiple_of(width.bytes() as usize);
        if !legal {
            let kind = DiagnosticKind::IllegalAccess { offset: offset as u32, width: width.0, write };
            self.report("", "", kind);
        }
        !legal
    }
}
