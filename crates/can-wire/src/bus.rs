//! The bus: a wired AND of what the nodes drive, each delayed by its way to the bus.

use std::{cmp::Reverse, collections::BinaryHeap};

use crate::fault::Disturbances;

/// A change of a node's output that has not reached the bus yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct InFlight {
    at: u64,
    /// Order of departure, so that two changes of one node keep theirs.
    order: u64,
    node: usize,
    level: bool,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Bus {
    contributions: Vec<bool>,
    dominant: usize,
    level: bool,
    in_flight: BinaryHeap<Reverse<InFlight>>,
    order: u64,
    pub(crate) disturbances: Disturbances,
}

impl Bus {
    pub(crate) fn new() -> Bus {
        Bus {
            level: true,
            ..Bus::default()
        }
    }

    pub(crate) fn add_node(&mut self) {
        self.contributions.push(true);
    }

    pub(crate) fn level(&self) -> bool {
        self.level
    }

    /// A node's output changes and arrives at the bus at `at`, later than now.
    pub(crate) fn send(&mut self, node: usize, level: bool, at: u64) {
        self.order += 1;
        self.in_flight.push(Reverse(InFlight {
            at,
            order: self.order,
            node,
            level,
        }));
    }

    #[inline]
    pub(crate) fn next_arrival(&self) -> Option<u64> {
        self.in_flight.peek().map(|Reverse(change)| change.at)
    }

    pub(crate) fn take_arrival(&mut self) -> Option<(usize, bool)> {
        self.in_flight
            .pop()
            .map(|Reverse(change)| (change.node, change.level))
    }

    /// Sets what a node contributes; returns the new level of the bus if it changes.
    #[inline]
    pub(crate) fn contribute(&mut self, node: usize, level: bool) -> Option<bool> {
        if self.contributions[node] == level {
            return None;
        }
        self.contributions[node] = level;
        if level {
            self.dominant -= 1;
        } else {
            self.dominant += 1;
        }
        self.settle()
    }

    /// Recomputes the level, after a disturbance has begun or ended.
    pub(crate) fn settle(&mut self) -> Option<bool> {
        let level = self.disturbances.apply(self.dominant == 0);
        (core::mem::replace(&mut self.level, level) != level).then_some(level)
    }

    pub(crate) fn is_quiet(&self) -> bool {
        self.level
            && self.dominant == 0
            && self.in_flight.is_empty()
            && self.disturbances.is_empty()
    }
}
