//! Every register of the model over the bus, as the description says.

use can_sim::{Handle, Sim, Time, dspic33_canfd::Dspic33CanfdModel};
use dspic33_canfd_pac::{Dspic33Canfd, enums::OperationMode as Mode, meta::CONTROLLER, registers::ConL};
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

    /// Configuration mode holds the flags of FIFOs in reset.
    fn release(sim: &Sim, id: Handle<Dspic33CanfdModel>) {
        let can = Dspic33Canfd::new(sim.registers(id));
        can.con_l().write(ConL::RESET.with_con(true));
        can.con_h().write(can.con_h().read().with_reqop(Mode::InternalLoopback));
        sim.run_for(Time::from_us(100));
        assert_eq!(can.con_h().read().opmod(), Mode::InternalLoopback);
    }

    /// Codes follow the flags, the counter follows time, and Configuration mode holds the flags of FIFOs in reset.
    fn follows(register: &str, field: &str) -> bool {
        matches!(register, "VECL" | "VECH" | "TBCL" | "TBCH") || matches!(field, "TXATIF" | "RXOVIF" | "TEFOVIF")
    }

    /// Requests, resets and increments have tests of their own.
    fn acts(register: &str) -> bool {
        matches!(register, "CONH" | "TXQCONL" | "FIFOCONL" | "TEFCONL" | "TXREQL" | "TXREQH" | "TBCL" | "TBCH")
    }
}

#[test]
fn reset_values() {
    assert_eq!(laws_of::reset_values::<Canfd>(), 44 + 5 * 31 + 16 + 4 * 32);
}

#[test]
fn writes() {
    assert_eq!(laws_of::writes::<Canfd>(), (343 - 7 - 31) * 4);
}

#[test]
fn write_conditions() {
    assert_eq!(laws_of::write_conditions::<Canfd>(), 944, "each held and not");
}

#[test]
fn flags() {
    assert_eq!(laws_of::flags::<Canfd>(), 6);
}

/// Registers 3-31, 3-34, 3-37: the flags that Configuration mode holds in reset, outside of it: writing 0 clears, 1 does
/// nothing.
#[test]
fn flags_of_fifos() {
    use crate::bench::pair;
    use regbus::Bus;
    let (sim, can, _) = pair();
    can.start(&sim);
    let find = |name: &str, element: u32| {
        sim.inspect(can.id, |model| {
            use can_sim::Model;
            let slot = model.registers().find(name, element, 0).unwrap();
            (slot, model.registers().offset(slot).unwrap() as usize)
        })
    };
    let fifos = (0..31).map(|element| (find("FIFOSTA", element), 0x0018_u16));
    for ((slot, offset), flags) in fifos.chain([(find("TXQSTA", 0), 0x0010), (find("TEFSTA", 0), 0x0008)]) {
        for bit in (0..16).filter(|bit| flags >> bit & 1 == 1) {
            sim.act(can.id, |model, _| {
                use can_sim::Model;
                let old = model.registers().get(slot);
                model.registers_mut().set(slot, old | u32::from(flags));
            });
            let bus = sim.registers(can.id);
            bus.write(offset, u16::MAX);
            assert_eq!(bus.read::<u16>(offset) & flags, flags, "ones do nothing");
            bus.write(offset, !(1_u16 << bit));
            assert_eq!(bus.read::<u16>(offset) & flags, flags & !(1 << bit));
        }
    }
}

/// Register 3-34: TXABT of the 31 FIFOs.
#[test]
fn read_effects() {
    assert_eq!(laws_of::read_effects::<Canfd>(), 31);
}

#[test]
fn reserved_addresses() {
    assert_eq!(laws_of::reserved::<Canfd>(), 33 * 2);
}

#[test]
fn illegal_accesses() {
    assert_eq!(laws_of::illegal_accesses::<Canfd>(), 343 * 5);
}
