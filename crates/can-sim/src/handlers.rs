//! Interrupt lines as the host sees them.

use std::cell::{Cell, RefCell};

use crate::Sim;

/// What a test attaches to a line; it gets the level.
pub(crate) type Act = Box<dyn FnMut(&Sim, bool)>;

/// When a handler is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Call {
    /// At every change, with the new level.
    Changes,
    /// As long as the line is active: a level-sensitive interrupt controller.
    Active,
}

struct Handler {
    controller: usize,
    line: usize,
    call: Call,
    /// It has been given up on until the line falls.
    stormed: bool,
    act: Option<Act>,
}

/// The handlers of a simulation.
#[derive(Default)]
pub(crate) struct Handlers {
    list: RefCell<Vec<Handler>>,
    running: Cell<bool>,
    calls: Cell<u64>,
}

/// Entries of a handler in a row after which it is called a storm.
const STORM: u32 = 1_000;

impl Handlers {
    pub(crate) fn add(&self, controller: usize, line: usize, only_active: bool, act: Act) {
        let call = if only_active { Call::Active } else { Call::Changes };
        self.list.borrow_mut().push(Handler { controller, line, call, stormed: false, act: Some(act) });
    }

    /// A handler runs: interrupts are masked.
    pub(crate) fn is_running(&self) -> bool {
        self.running.get()
    }

    /// Calls the handlers of every line that has changed.
    pub(crate) fn serve(&self, sim: &Sim) {
        if self.running.replace(true) {
            return;
        }
        while let Some(change) = sim.next_line_change() {
            let handlers = self.list.borrow().len();
            for index in 0..handlers {
                let mut list = self.list.borrow_mut();
                let handler = &mut list[index];
                if (handler.controller, handler.line) != (change.controller, change.line) {
                    continue;
                }
                if handler.call == Call::Active && !change.active {
                    handler.stormed = false;
                    continue;
                }
                let (call, stormed) = (handler.call, handler.stormed);
                let Some(mut act) = handler.act.take() else { continue };
                drop(list);
                let storm = match call {
                    Call::Changes => {
                        self.call(sim, change.active, &mut act);
                        false
                    }
                    Call::Active => stormed || self.hold(sim, change.controller, change.line, &mut act),
                };
                let handler = &mut self.list.borrow_mut()[index];
                handler.act = Some(act);
                handler.stormed = storm;
            }
        }
        self.running.set(false);
    }

    fn call(&self, sim: &Sim, active: bool, act: &mut Act) {
        self.calls.set(self.calls.get() + 1);
        sim.set_handler(Some(self.calls.get()));
        act(sim, active);
        sim.set_handler(None);
    }

    /// Calls a handler as long as its line is active; returns true if that does not end.
    fn hold(&self, sim: &Sim, controller: usize, line: usize, act: &mut Act) -> bool {
        for _ in 0..STORM {
            if !sim.line_level(controller, line) {
                return false;
            }
            self.call(sim, true, act);
        }
        if sim.line_level(controller, line) {
            sim.report_storm(controller, line, STORM);
            return true;
        }
        false
    }
}
