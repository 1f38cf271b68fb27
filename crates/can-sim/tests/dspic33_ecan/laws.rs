//! Every register of the ECAN model over the bus, as the description says.

use can_sim::{Handle, Sim, dspic33_ecan::EcanModel};
use dspic33_ecan_pac::meta::CONTROLLER;
use regbus::meta::Controller;

use crate::{
    bench::add,
    laws_of::{self, Subject},
};

struct Ecan;

impl Subject for Ecan {
    type Model = EcanModel;

    const META: &'static Controller = &CONTROLLER;

    fn add(sim: &Sim) -> Handle<EcanModel> {
        add(sim, "can1").id
    }

    /// 7.1: Configuration mode is the mode after reset.
    fn configure(_: &Sim, _: Handle<EcanModel>) {}

    /// CxVEC is worked out from what is pending.
    fn follows(register: &str, _: &str) -> bool {
        register == "VEC"
    }

    /// CxCTRL1 changes the mode and the window, CxTRmnCON requests and aborts.
    fn acts(register: &str) -> bool {
        matches!(register, "CTRL1" | "TRCON")
    }

    /// The data registers are the DMA channels' (`rxd_txd_by_cpu`).
    fn reads_are_reported(register: &str) -> bool {
        matches!(register, "RXD" | "TXD")
    }
}

#[test]
fn reset_values() {
    assert_eq!(laws_of::reset_values::<Ecan>(), 65, "every register of one module");
}

#[test]
fn writes() {
    assert_eq!(laws_of::writes::<Ecan>(), (65 - 1 - 4) * 4);
}

/// 7.1: CxCFG1 and CxCFG2.
#[test]
fn write_conditions() {
    assert_eq!(laws_of::write_conditions::<Ecan>(), 8 * 2, "each field held and not");
}

/// RXFUL, RXOVF and the seven flags of CxINTF.
#[test]
fn flags() {
    assert_eq!(laws_of::flags::<Ecan>(), 32 + 32 + 7);
}

#[test]
fn no_read_has_an_effect() {
    assert_eq!(laws_of::read_effects::<Ecan>(), 0);
}

#[test]
fn reserved_addresses() {
    let words = |from: u32, to: u32| (to + 1 - from) / 2;
    let ranges = CONTROLLER.reserved.iter().map(|range| words(range.from, range.to)).sum::<u32>();
    assert_eq!(laws_of::reserved::<Ecan>(), ranges * 2);
    assert_eq!(ranges, 43);
}

/// Only 16-bit accesses are legal (`byte_access`).
#[test]
fn illegal_accesses() {
    assert_eq!(laws_of::illegal_accesses::<Ecan>(), 65 * (2 + 1 + 2));
}
