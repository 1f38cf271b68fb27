//! Every register of the model over the bus, as the description says.

use can_sim::{Handle, Sim, dspic33_canfd::Dspic33CanfdModel};
use dspic33_canfd_pac::meta::CONTROLLER;
use regbus::meta::Controller;

use crate::{
    bench::add,
    laws_of::{self, Subject},
};

struct Canfd;

impl Subject for Canfd {
    type Model = Dspic33CanfdModel;

    const META: &'static Controller = &CONTROLLER;

    fn add(sim: &Sim) -> Handle<Dspic33CanfdModel> {
        add(sim, "can0").id
    }

    /// 4.2: the mode after reset.
    fn configure(_sim: &Sim, _id: Handle<Dspic33CanfdModel>) {}

    /// Codes and mirrored flags follow what is below them; the counter follows time.
    fn follows(register: &str, _field: &str) -> bool {
        matches!(register, "VECL" | "VECH" | "TBCL" | "TBCH")
    }

    /// Requests, resets and increments have tests of their own.
    fn acts(register: &str) -> bool {
        matches!(register, "CONH" | "TXQCONL" | "FIFOCONL" | "TEFCONL" | "TXREQL" | "TXREQH" | "TBCL" | "TBCH")
    }
}

#[test]
fn reset_values() {
    assert_eq!(laws_of::reset_values::<Canfd>(), 342);
}

#[test]
fn writes() {
    assert_eq!(laws_of::writes::<Canfd>(), 0);
}

#[test]
fn write_conditions() {
    assert_eq!(laws_of::write_conditions::<Canfd>(), 0);
}

#[test]
fn flags() {
    assert_eq!(laws_of::flags::<Canfd>(), 0);
}

/// Register 3-34: TXABT of the 31 FIFOs.
#[test]
fn read_effects() {
    assert_eq!(laws_of::read_effects::<Canfd>(), 0);
}

#[test]
fn reserved_addresses() {
    assert_eq!(laws_of::reserved::<Canfd>(), 0);
}

#[test]
fn illegal_accesses() {
    assert_eq!(laws_of::illegal_accesses::<Canfd>(), 0);
}
