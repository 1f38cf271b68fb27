//! Every register of the model over the bus, as the description says.

use can_sim::{Handle, Sim, pic32_can::Pic32CanModel};
use pic32_can_pac::{
    meta::CONTROLLER,
    registers::{Con, FifoCon, Int},
};
use regbus::{Bus, meta::Controller};

use crate::{
    bench::{Use, add, bench},
    laws_of::{self, Subject},
};

struct Pic32;

impl Subject for Pic32 {
    type Model = Pic32CanModel;

    const META: &'static Controller = &CONTROLLER;

    fn add(sim: &Sim) -> Handle<Pic32CanModel> {
        add(sim, "can1").id
    }

    fn configure(sim: &Sim, id: Handle<Pic32CanModel>) {
        sim.registers(id).write(0x000, Con::RESET.with_on(true).bits());
    }

    /// While ON is 0 the FIFOs are held in reset.
    fn release(sim: &Sim, id: Handle<Pic32CanModel>) {
        Self::configure(sim, id);
    }

    /// What follows the state of the module: status, pointers and level flags. TXREQ of a receive FIFO, and UINC, are
    /// never seen as 1.
    fn follows(register: &str, field: &str) -> bool {
        match register {
            "CON" => matches!(field, "OPMOD" | "CANBUSY" | "ABAT"),
            "FIFOCON" => matches!(field, "TXREQ" | "UINC"),
            "FIFOINT" => field.ends_with("IF") && field != "RXOVFLIF",
            "VEC" | "TREC" | "FSTAT" | "RXOVF" | "FIFOUA" | "FIFOCI" => true,
            "INT" => matches!(field, "TBIF" | "RBIF" | "RBOVIF" | "SERRIF"),
            _ => false,
        }
    }

    /// CON switches the module on and off; a flag is never written 1 from 0 without a report.
    fn acts(register: &str) -> bool {
        register == "CON"
    }
}

#[test]
fn reset_values() {
    assert_eq!(laws_of::reset_values::<Pic32>(), 181);
}

#[test]
fn writes() {
    assert_eq!(laws_of::writes::<Pic32>(), 180 * 4 * 4);
}

/// CFG 8 fields, RXM 3 of 4, FLTCON 8 lanes of 8, RXF 3 of 32, FIFOBA, FSIZE and DONLY of 32; each held and not.
#[test]
fn write_conditions() {
    assert_eq!(laws_of::write_conditions::<Pic32>(), 2 * (8 + 3 * 4 + 8 * 8 + 3 * 32 + 1 + 2 * 32));
}

/// Five flags of CiINT and the overflow flag of each FIFO.
#[test]
fn flags() {
    assert_eq!(laws_of::flags::<Pic32>(), 5 + 32);
}

/// Register 34-20: TXLARB and TXERR of each FIFO.
#[test]
fn read_effects() {
    assert_eq!(laws_of::read_effects::<Pic32>(), 2 * 32);
}

/// narrow_access: bytes at every address, halfwords at the even ones and those that are not aligned, words that are not.
#[test]
fn illegal_accesses() {
    assert_eq!(laws_of::illegal_accesses::<Pic32>(), 181 * (4 + 4 + 3));
}

/// Table 34-1 reserves no range of addresses.
#[test]
fn reserved_addresses() {
    assert_eq!(laws_of::reserved::<Pic32>(), 0);
}

/// Table 34-1, notes 1 to 3: alias registers clear, set and invert; alias_read_value: a read gives the base register and
/// has no effect.
#[test]
fn alias_registers() {
    let (sim, can, _) = bench(&[Use::Tx(2)]);
    let bus = sim.registers(can.id);
    let enables = (Int::IVRIE | Int::MODIE).bits();
    bus.write(0x028, enables);
    assert_eq!(bus.read::<u32>(0x020) & 0xFFFF_0000, enables);
    bus.write(0x02C, (Int::MODIE | Int::TBIE).bits());
    assert_eq!(bus.read::<u32>(0x020) & 0xFFFF_0000, (Int::IVRIE | Int::TBIE).bits());
    bus.write(0x024, Int::IVRIE.bits());
    assert_eq!(bus.read::<u32>(0x020) & 0xFFFF_0000, Int::TBIE.bits());
    sim.act(can.id, |model, _| {
        use can_sim::Model;
        let slot = model.registers().find("FIFOCON", 0, 0).unwrap();
        let value = model.registers().get(slot);
        model.registers_mut().set(slot, value | FifoCon::TXERR.bits());
    });
    assert_eq!(sim.diagnostics(), []);
    for distance in [4, 8, 12] {
        assert!(FifoCon::from_bits(bus.read(0x350 + distance)).txerr());
    }
    assert_eq!(sim.take_diagnostics().len(), 3);
    assert!(FifoCon::from_bits(bus.read(0x350)).txerr(), "the base register reads it, and clears it");
    assert!(!FifoCon::from_bits(bus.read(0x350)).txerr());
}

/// Table 34-1: the offsets of the figures that are printed, and those that the packing gives.
#[test]
fn register_map() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    let regs = can.regs(&sim);
    let offsets = [
        (regs.con().offset(), 0x000),
        (regs.cfg().offset(), 0x010),
        (regs.vec().offset(), 0x030),
        (regs.tmr().offset(), 0x070),
        (regs.rxm(3).offset(), 0x0B0),
        (regs.flt_con(7).offset(), 0x130),
        (regs.rxf(31).offset(), 0x330),
        (regs.fifo_ba().offset(), 0x340),
        (regs.fifo(0).con().offset(), 0x350),
        (regs.fifo(1).con().offset(), 0x390),
        (regs.fifo(1).ua().offset(), 0x3B0),
        (regs.fifo(31).ci().offset(), 0xB40),
    ];
    for (found, expected) in offsets {
        assert_eq!(found, expected);
    }
}
