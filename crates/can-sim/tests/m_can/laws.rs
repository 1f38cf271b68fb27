//! Every register of the M_CAN model over the bus, as the description says, and what configuration mode does to them.

use can_sim::{Handle, Model, Sim, m_can::MCanModel, registers::Slot};
use m_can_pac::{meta::CONTROLLER, registers as pac};
use regbus::{
    Bus,
    meta::{Controller, Field},
};

use crate::{
    bench::{Can, add_with},
    laws_of::{self, Subject},
};

/// M_CAN, nothing fixed by synthesis.
struct MCan;

impl Subject for MCan {
    type Model = MCanModel;

    const META: &'static Controller = &CONTROLLER;

    fn add(sim: &Sim) -> Handle<MCanModel> {
        bench_on(sim).id
    }

    fn configure(sim: &Sim, id: Handle<MCanModel>) {
        sim.registers(id).write(0x018, 3_u32);
        sim.registers(id).write(0x018, 0x83_u32);
    }

    /// A pin and the watchdog's counter; CREL and CUST are the device's.
    fn follows(register: &str, field: &str) -> bool {
        matches!((register, field), ("TEST", "RX") | ("RWD", "WDV") | ("CUST", _))
    }

    /// CCCR makes configuration mode, TXBAR and TXBCR take no writes in it.
    fn acts(register: &str) -> bool {
        matches!(register, "CCCR" | "TXBAR" | "TXBCR")
    }

    fn bring_about(sim: &Sim, id: Handle<MCanModel>, condition: &str, holds: bool) -> bool {
        match (condition, holds) {
            ("config" | "test_access", false) | ("handlers_active", true) | ("init", true) => {}
            ("config", true) | ("handlers_active", false) => sim.registers(id).write(0x018, 3_u32),
            ("test_access", true) => Self::configure(sim, id),
            ("init", false) => sim.registers(id).write(0x018, 0_u32),
            (other, _) => panic!("no way known to bring about {other}"),
        }
        true
    }
}

#[test]
fn reset_values() {
    assert_eq!(laws_of::reset_values::<MCan>(), 47);
    let (sim, can) = bench();
    assert_eq!((read(&sim, can, 0x00), read(&sim, can, 0x08)), (0x3313_0311, 0x1234_5678));
}

#[test]
fn writes() {
    assert_eq!(laws_of::writes::<MCan>(), 44 * 4 * 7);
}

#[test]
fn write_conditions() {
    assert_eq!(laws_of::write_conditions::<MCan>(), 250, "each held and not");
}

#[test]
fn flags() {
    assert_eq!(laws_of::flags::<MCan>(), (30 + 64) * 3);
}

/// 2.3.13, 2.3.14: CEL; PXE, RFDF, RBRS, RESI, DLEC, LEC.
#[test]
fn read_effects() {
    assert_eq!(laws_of::read_effects::<MCan>(), 7 * 7);
}

/// 2.2.1: reserved bytes of registers do not count.
#[test]
fn reserved_addresses() {
    assert_eq!(laws_of::reserved::<MCan>(), 81 * 7 * 2);
    let (sim, can) = bench();
    for offset in CONTROLLER.registers.iter().filter_map(|info| info.offset) {
        for byte in 0..4 {
            let _ = sim.registers(can.id).read::<u8>((offset + byte) as usize);
        }
    }
    assert!(!can.ir(&sim).contains(pac::Ir::ARA), "no byte of an implemented register counts");
}

#[test]
fn illegal_accesses() {
    assert_eq!(laws_of::illegal_accesses::<MCan>(), 47 * (2 + 3));
}

fn bench_on(sim: &Sim) -> Can {
    add_with(sim, "can0", |mut config| {
        config.customer_register = Some(0x1234_5678);
        config.tsu_registers = Some(4);
        config.choices.command_delay = 0;
        config
    })
}

fn bench() -> (Sim, Can) {
    let sim = Sim::new();
    let can = bench_on(&sim);
    (sim, can)
}

fn read(sim: &Sim, can: Can, offset: u32) -> u32 {
    sim.registers(can.id).read(offset as usize)
}

fn write(sim: &Sim, can: Can, offset: u32, value: u32) {
    sim.registers(can.id).write(offset as usize, value);
}

/// Sets a register from inside.
fn force(sim: &Sim, can: Can, slot: Slot, value: u32) {
    sim.act(can.id, |model, _| model.registers_mut().set(slot, value));
}

/// `set_when`: set in configuration mode only, cleared at any time.
#[test]
fn protected_set() {
    let protected = pac::Cccr::TEST.union(pac::Cccr::MON).union(pac::Cccr::ASM);
    let info = CONTROLLER.registers.iter().find(|info| info.name == "CCCR").unwrap();
    let fields: Vec<&Field> = info.fields.iter().filter(|field| field.set_when.is_some()).collect();
    assert_eq!(fields.iter().fold(0, |mask, field| mask | field.all()), protected.bits());
    for field in fields {
        let (sim, can) = bench();
        write(&sim, can, 0x018, 1 | field.all());
        assert_eq!(read(&sim, can, 0x018), 1, "{} is not set with INIT alone", field.name);
        assert_eq!(sim.take_diagnostics().len(), 1);
        can.configure(&sim);
        write(&sim, can, 0x018, 3 | field.all());
        assert_eq!(read(&sim, can, 0x018), 3 | field.all());
        write(&sim, can, 0x018, 1 | field.all());
        assert_eq!(read(&sim, can, 0x018), 1 | field.all(), "{} stays with CCE 0", field.name);
        write(&sim, can, 0x018, 1);
        assert_eq!(read(&sim, can, 0x018), 1, "{} is cleared any time", field.name);
        assert_eq!(sim.diagnostics(), []);
    }
}

/// 3.1.1: what setting CCE resets, and what it leaves alone.
#[test]
fn configuration_mode_resets_the_status() {
    let reset = ["HPMS", "RXF0S", "RXF1S", "TXFQS", "TXBRP", "TXBTO", "TXBCF", "TXEFS"];
    let kept = ["IR", "NDAT1", "NDAT2", "ECR", "RXF0A", "TXEFA", "IE", "TXBTIE"];
    let (sim, can) = bench();
    let slot = |name: &str| sim.inspect(can.id, |model| model.registers().find(name, 0, 0).unwrap());
    let get = |name: &str| sim.inspect(can.id, |model| model.registers().get(slot_of(&sim, can, name)));
    let flags = pac::Ir::RF0L.union(pac::Ir::RF1L).union(pac::Ir::TEFL).bits();
    for name in reset.iter().chain(&kept) {
        let implemented = sim.inspect(can.id, |model| model.registers().info(slot(name)).implemented());
        force(&sim, can, slot(name), if *name == "IR" { 0x0100 | flags } else { implemented });
    }
    write(&sim, can, 0x028, 0);
    let before: Vec<u32> = kept.iter().map(|name| get(name)).collect();
    write(&sim, can, 0x018, 3);
    for name in reset {
        // The lost flags in three of them are copies of IR, which is not reset.
        let copies = if ["RXF0S", "RXF1S", "TXEFS"].contains(&name) { 1 << 25 } else { 0 };
        assert_eq!(get(name), copies, "{name}");
    }
    assert_eq!(kept.iter().map(|name| get(name)).collect::<Vec<_>>(), before);
    write(&sim, can, 0x050, flags);
    assert_eq!((get("RXF0S"), get("RXF1S"), get("TXEFS")), (0, 0, 0), "the copies clear with the flags");
    write(&sim, can, 0x028, 0xABCD_0000);
    assert_eq!(read(&sim, can, 0x02C), 0xABCD, "TOCV is preset to TOP");
}

fn slot_of(sim: &Sim, can: Can, name: &str) -> Slot {
    sim.inspect(can.id, |model| model.registers().find(name, 0, 0).unwrap())
}
