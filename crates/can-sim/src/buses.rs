//! The buses of a simulation, which share one time.

use std::collections::VecDeque;

use can_wire::{Event, NodeConfig, NodeId, Time, TimingError, Wire};

use crate::bus_log::BusLog;

/// A bus of a [`crate::Sim`]. The default is the one that every simulation has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct BusId(pub(crate) usize);

/// Who has a node.
#[derive(Clone, Copy)]
pub(crate) enum Owner {
    Controller(usize),
    Peer(usize),
}

/// One bus.
pub(crate) struct Bus {
    pub(crate) wire: Wire,
    owners: Vec<Owner>,
    pub(crate) log: BusLog,
}

impl Bus {
    /// Gives a node to a controller or a peer.
    pub(crate) fn add_node(&mut self, config: NodeConfig, owner: Owner) -> Result<NodeId, TimingError> {
        let node = self.wire.add_node(config)?;
        self.owners.push(owner);
        Ok(node)
    }
}

/// All buses of a simulation.
pub(crate) struct Buses {
    list: Vec<Bus>,
    log_limit: usize,
}

impl Buses {
    /// The first bus.
    pub(crate) fn new(log_limit: usize) -> Self {
        let mut buses = Self { list: Vec::new(), log_limit };
        buses.add();
        buses
    }

    pub(crate) fn add(&mut self) -> BusId {
        let mut wire = Wire::new();
        if let Some(first) = self.list.first() {
            wire.wait_until(first.wire.now());
        }
        let log = BusLog { entries: VecDeque::new(), limit: self.log_limit };
        self.list.push(Bus { wire, owners: Vec::new(), log });
        BusId(self.list.len() - 1)
    }

    pub(crate) fn get(&self, id: BusId) -> &Bus {
        &self.list[id.0]
    }

    #[inline]
    pub(crate) fn get_mut(&mut self, id: BusId) -> &mut Bus {
        &mut self.list[id.0]
    }

    #[inline]
    pub(crate) fn now(&self) -> Time {
        self.list[0].wire.now()
    }

    /// The next event of any bus, with its bus and the owner of its node; or time passes to `limit`. At an event the time
    /// of every bus is that of the event.
    #[inline]
    pub(crate) fn next_event(&mut self, limit: Time) -> Option<(BusId, Owner, Event)> {
        let (bus, event) = match &mut self.list[..] {
            [bus] => (0, bus.wire.next_event(limit)?),
            _ => self.next_of_several(limit)?,
        };
        let Bus { owners, log, .. } = &mut self.list[bus];
        log.note(&event);
        Some((BusId(bus), owners[event.node.index()], event))
    }

    fn next_of_several(&mut self, limit: Time) -> Option<(usize, Event)> {
        loop {
            let dues = self.list.iter().enumerate().map(|(index, bus)| (bus.wire.next_due(), index));
            let (due, first) = dues.min()?;
            let until = due.min(limit);
            self.list.iter_mut().for_each(|bus| bus.wire.wait_until(until));
            if due > limit {
                return None;
            }
            if let Some(event) = self.list[first].wire.next_event(due) {
                return Some((first, event));
            }
        }
    }
}
