//! What a test can do between two accesses of the host.

use std::{cell::RefCell, rc::Rc};

use can_sim::Sim;

use crate::bench::add;

/// The interruption happens once, before the access that was named, and may let time pass.
#[test]
fn an_interruption_happens_between_two_accesses() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    let regs = can.regs(&sim);
    let happened = Rc::new(RefCell::new(Vec::new()));
    let note = Rc::clone(&happened);
    let start = sim.accesses();
    sim.interrupt_host(2, move |sim| {
        note.borrow_mut().push(sim.accesses());
        sim.run_for(can_sim::Time::from_us(5));
    });
    let mut times = Vec::new();
    for _ in 0..4 {
        let _release = regs.crel().read();
        times.push(sim.now().as_ns());
    }
    // The third access has begun when the interruption happens.
    assert_eq!(*happened.borrow(), [start + 3]);
    let spans: Vec<u64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert_eq!(spans, [100, 5_100, 100]);
}

/// Accesses of the interruption itself do not set off another, and the last one asked for counts.
#[test]
fn a_later_interruption_replaces_one_that_waits() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    let happened = Rc::new(RefCell::new(Vec::new()));
    for name in ["first", "second"] {
        let note = Rc::clone(&happened);
        sim.interrupt_host(1, move |sim| {
            note.borrow_mut().push(name);
            let _release = can.regs(sim).crel().read();
        });
    }
    for _ in 0..5 {
        let _release = can.regs(&sim).crel().read();
    }
    assert_eq!(*happened.borrow(), ["second"]);
}
