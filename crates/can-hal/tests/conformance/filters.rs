//! Acceptance filters.

use can_hal::{ExtendedId, Frame, Id, StandardId};
use can_sim::Sim;

use crate::bench::{Bench, FRAME, Setup, drain, peer, start};

fn standard(id: u16) -> Id {
    Id::Standard(StandardId::new(id).unwrap())
}

fn extended(id: u32) -> Id {
    Id::Extended(ExtendedId::new(id).unwrap())
}

/// Identifiers that differ from each other in single bits, in length, and in what is left of them when cut off.
fn candidates() -> Vec<Id> {
    let mut ids =
        vec![standard(0x123), standard(0x7FF), standard(0), extended(0x123), extended(0x1234_5678 & 0x1FFF_FFFF)];
    ids.extend((0..11).map(|bit| standard(0x123 ^ 1 << bit)));
    ids.extend((0..29).map(|bit| extended(0x1234_5678 & 0x1FFF_FFFF ^ 1 << bit)));
    // The same upper 11 bits as a standard identifier of the list.
    ids.push(extended(0x123 << 18));
    ids
}

fn received<B: Bench>(accept: &[Id]) -> Vec<Id> {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup { accept, ..Setup::CLASSIC });
    let mut seen = Vec::new();
    for id in candidates() {
        sim.peer_send(other, Frame::data(id, &[1]).unwrap());
        sim.run_for(FRAME);
        seen.extend(drain(&mut can).iter().map(|message| message.frame.id()));
    }
    assert_eq!(sim.diagnostics(), []);
    seen
}

pub fn only_what_is_asked_for_comes_in<B: Bench>() {
    let accept = [standard(0x123), extended(0x1234_5678)];
    let expected: Vec<Id> = candidates().into_iter().filter(|id| accept.contains(id)).collect();
    assert_eq!(received::<B>(&accept), expected);
}

pub fn without_filters_everything_comes_in<B: Bench>() {
    assert_eq!(received::<B>(&[]), candidates());
}
