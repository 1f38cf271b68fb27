//! The scheduler: joins the models, the wire and the host in one order of events.

use std::collections::VecDeque;

use can_wire::{Event, NodeId, Time, Wire};

use crate::{
    access::AccessWidth,
    bus_log::BusLog,
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
    pub(crate) node: NodeId,
    pub(crate) lines: u32,
    timer: Option<Time>,
}

#[derive(Clone, Copy)]
enum Owner {
    Controller(usize),
    Peer(usize),
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
    pub(crate) wire: Wire,
    pub(crate) entries: Vec<Entry>,
    pub(crate) memories: Vec<Memory>,
    pub(crate) peers: Vec<Peer>,
    owners: Vec<Owner>,
    pub(crate) diagnostics: Diagnostics,
    pub(crate) log: BusLog,
    pub(crate) trace: Option<Vec<AccessRecord>>,
    pub(crate) changes: VecDeque<LineChange>,
    pub(crate) handler: Option<u64>,
}

impl Core {
    pub(crate) fn new(diagnostics: Diagnostics, log: BusLog) -> Self {
        Self {
            wire: Wire::new(),
            entries: Vec::new(),
            memories: Vec::new(),
            peers: Vec::new(),
            owners: Vec::new(),
            diagnostics,
            log,
            trace: None,
            changes: VecDeque::new(),
            handler: None,
        }
    }

    pub(crate) fn add_controller(&mut self, name: String, node: NodeId, model: Box<dyn Model>) -> usize {
        let index = self.entries.len();
        self.owners.push(Owner::Controller(index));
        self.entries.push(Entry { name, model, node, lines: 0, timer: None });
        self.with_model(index, |model, cx| model.attached(cx));
        index
    }

    pub(crate) fn add_peer(&mut self, node: NodeId) -> usize {
        self.owners.push(Owner::Peer(self.peers.len()));
        self.peers.push(Peer::new(node));
        self.peers.len() - 1
    }

    /// Lets a model act, and takes notice of what that changed.
    #[inline]
    pub(crate) fn with_model<R>(&mut self, index: usize, act: impl FnOnce(&mut dyn Model, &mut Context<'_>) -> R) -> R {
        let Self { entries, wire, memories, diagnostics, handler, .. } = self;
        let entry = &mut entries[index];
        let (now, node, controller, handler) = (wire.now(), entry.node, entry.name.as_str(), *handler);
        let mut cx = Context { now, node, wire, handler, controller, memories, diagnostics };
        let result = act(&mut *entry.model, &mut cx);
        self.notice(index);
        result
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
            if let Some(event) = self.wire.next_event(until) {
                self.dispatch(&event);
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

    fn dispatch(&mut self, event: &Event) {
        self.log.note(event);
        match self.owners.get(event.node.index()) {
            Some(Owner::Controller(index)) => self.with_model(*index, |model, cx| model.on_event(cx, event)),
            Some(Owner::Peer(index)) => self.peers[*index].on_event(&mut self.wire, event),
            None => {}
        }
    }

    pub(crate) fn report(&mut self, controller: &str, section: &'static str, kind: DiagnosticKind) {
        let (time, controller) = (self.wire.now(), controller.to_owned());
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
            let Self { entries, wire, memories, diagnostics, handler, .. } = self;
            let entry = &mut entries[index];
            let (now, node, controller, handler) = (wire.now(), entry.node, entry.name.as_str(), *handler);
            let mut cx = Context { now, node, wire, handler, controller, memories, diagnostics };
            entry.model.memory_written(&mut cx, id, offset / 4);
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
