//! Every register of the M_CAN model over the bus, as the description says: reset values, write masks, write conditions,
//! clearing rules, read effects, reserved addresses.

use crate::bench::{Can, add_with};
use can_sim::{DiagnosticKind, Model, Sim, registers::Slot};
use m_can_pac::{meta::CONTROLLER, registers as pac};
use regbus::{
    Bus,
    meta::{Access, Field, ReadEffect, RegisterInfo},
};

/// A model in which nothing is fixed by synthesis.
fn bench() -> (Sim, Can) {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |mut config| {
        config.customer_register = Some(0x1234_5678);
        config.tsu_registers = Some(4);
        config.choices.command_delay = 0;
        config
    });
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

fn registers() -> impl Iterator<Item = (&'static RegisterInfo, u32)> {
    CONTROLLER.registers.iter().map(|info| (info, info.offset.unwrap()))
}

/// Fields that follow a pin or another register whatever is written.
const FOLLOW: [(&str, &str); 2] = [("TEST", "RX"), ("RWD", "WDV")];

fn steady(info: &RegisterInfo) -> u32 {
    let follows = info.fields.iter().filter(|field| FOLLOW.contains(&(info.name, field.name)));
    !follows.fold(0, |mask, field| mask | field.all())
}

#[test]
fn reset_values() {
    let (sim, can) = bench();
    for (info, offset) in registers() {
        // Read effects make no difference at reset values; a read does not change what the next one sees.
        for _ in 0..2 {
            let value = read(&sim, can, offset);
            assert_eq!(value & !info.reset_unknown, info.reset & !info.reset_unknown, "{}", info.name);
        }
    }
    assert_eq!(sim.diagnostics(), []);
    assert_eq!((read(&sim, can, 0x00), read(&sim, can, 0x08)), (0x3313_0311, 0x1234_5678));
}

#[test]
fn write_masks_in_configuration_mode() {
    for (info, offset) in registers() {
        // CCCR is what makes configuration mode; TXBAR and TXBCR take no writes in it. They have tests of their own.
        if ["CCCR", "TXBAR", "TXBCR"].contains(&info.name) {
            continue;
        }
        for value in [u32::MAX, 0, 0xA5A5_A5A5, 0x5A5A_5A5A] {
            let (sim, can) = bench();
            can.configure(&sim);
            write(&sim, can, 0x018, pac::Cccr::INIT.union(pac::Cccr::CCE).union(pac::Cccr::TEST).bits());
            let before = read(&sim, can, offset);
            write(&sim, can, offset, value);
            let stores = |field: &&Field| matches!(field.access, Access::Rw | Access::Rwh);
            let mask = info.fields.iter().filter(stores).fold(0, |mask, field| mask | field.all());
            let loads = info.fields.iter().filter(|field| field.access == Access::Wclr);
            let presets = loads.fold(0, |word, field| word | if field.loads.is_some() { 0xFFFF } else { 0 });
            let expected = if info.name == "TOCV" { presets } else { before & !mask | value & mask };
            let steady = steady(info);
            assert_eq!(read(&sim, can, offset) & steady, expected & steady, "{} after {value:#x}", info.name);
            // An acknowledge of a FIFO that has no elements is reported, and stored.
            let acknowledges = ["RXF0A", "RXF1A", "TXEFA"].contains(&info.name);
            assert_eq!(sim.diagnostics().len(), usize::from(acknowledges), "{}", info.name);
        }
    }
}

/// Brings a condition of the description about, or the contrary, by writes that its section names.
fn bring_about(sim: &Sim, can: Can, condition: &str, holds: bool) {
    let config = |sim: &Sim| can.configure(sim);
    match (condition, holds) {
        ("config" | "test_access", false) | ("handlers_active", true) | ("init", true) => {}
        ("config", true) | ("handlers_active", false) => config(sim),
        ("test_access", true) => {
            config(sim);
            write(sim, can, 0x018, 0x83);
        }
        ("init", false) => write(sim, can, 0x018, 0),
        (other, _) => panic!("no way known to bring about {other}"),
    }
}

/// Every bit with a write condition: changed while it holds, untouched and reported while it does not.
#[test]
fn write_conditions() {
    let mut checked = 0;
    for (info, offset) in registers() {
        for field in info.fields {
            let Some(condition) = field.when else { continue };
            // The counters TSCV and TOCV have tests of their own: their value is not what was written last.
            if field.access == Access::Wclr {
                continue;
            }
            let name = CONTROLLER.conditions[condition as usize].name;
            for holds in [true, false] {
                let (sim, can) = bench();
                bring_about(&sim, can, name, holds);
                let slot = sim.inspect(can.id, |model| model.registers().find(info.name, 0, 0).unwrap());
                let before = sim.inspect(can.id, |model| model.registers().get(slot));
                let value = if info.name == "CCCR" { before ^ field.all() | 1 } else { before ^ field.all() };
                write(&sim, can, offset, value);
                let diagnostics = sim.take_diagnostics();
                let refused = diagnostics.iter().any(|diagnostic| {
                    matches!(&diagnostic.kind, DiagnosticKind::ProtectedWrite { register, fields, .. }
                        if register == info.name && fields.contains(&field.name))
                });
                let after = sim.inspect(can.id, |model| model.registers().get(slot));
                if !holds {
                    assert_eq!(after & field.all(), before & field.all(), "{}.{}", info.name, field.name);
                }
                if field.access != Access::W1s {
                    assert_eq!(after & field.all() != before & field.all(), holds, "{}.{}", info.name, field.name);
                }
                assert_eq!(refused, !holds, "{}.{}: {diagnostics:?}", info.name, field.name);
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 120, "conditions, each held and not");
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

/// Each flag that a 1 clears: it alone, by each access width.
#[test]
fn flags_clear_one_by_one() {
    let mut flags = 0;
    for (info, offset) in registers() {
        let clearing = info.fields.iter().filter(|field| field.access == Access::W1c);
        let mask = clearing.fold(0, |mask, field| mask | field.all());
        for bit in (0..32).filter(|bit| mask >> bit & 1 == 1) {
            let (sim, can) = bench();
            let slot = sim.inspect(can.id, |model| model.registers().find(info.name, 0, 0).unwrap());
            force(&sim, can, slot, mask);
            write(&sim, can, offset, 0);
            assert_eq!(read(&sim, can, offset), mask, "a 0 clears nothing");
            sim.registers(can.id).write(offset as usize + bit / 8, 1_u8 << (bit % 8));
            assert_eq!(read(&sim, can, offset), mask & !(1 << bit), "{} bit {bit}", info.name);
            force(&sim, can, slot, mask);
            write(&sim, can, offset, 1 << bit);
            assert_eq!(read(&sim, can, offset), mask & !(1 << bit), "{} bit {bit}", info.name);
            flags += 1;
        }
    }
    assert_eq!(flags, 30 + 64);
}

/// 2.3.13, 2.3.14: which bytes of a read change what.
#[test]
fn read_effects_per_byte() {
    let mut effects = 0;
    for (info, offset) in registers() {
        for field in info.fields.iter().filter(|field| field.on_read != ReadEffect::None) {
            let (byte, sets) = match field.on_read {
                ReadEffect::Clear(byte) => (byte.unwrap(), false),
                ReadEffect::Set(byte) => (byte.unwrap(), true),
                ReadEffect::None => continue,
            };
            let (sim, can) = bench();
            let slot = sim.inspect(can.id, |model| model.registers().find(info.name, 0, 0).unwrap());
            let full = if sets { 0 } else { field.all() };
            for first in 0..4_u32 {
                for width in [1, 2, 4] {
                    if first % width != 0 {
                        continue;
                    }
                    force(&sim, can, slot, full);
                    let (bus, at) = (sim.registers(can.id), (offset + first) as usize);
                    match width {
                        1 => drop(bus.read::<u8>(at)),
                        2 => drop(bus.read::<u16>(at)),
                        _ => drop(bus.read::<u32>(at)),
                    }
                    let touched = (first..first + width).contains(&u32::from(byte));
                    let expected = if touched { field.all() & !full } else { full };
                    let left = sim.inspect(can.id, |model| model.registers().get(slot)) & field.all();
                    assert_eq!(left, expected, "{}.{} after {width} bytes at {first}", info.name, field.name);
                    effects += 1;
                }
            }
        }
    }
    assert_eq!(effects, 7 * 7, "CEL; PXE, RFDF, RBRS, RESI, DLEC, LEC");
}

/// 2.2.1: every reserved word, in every width, read and written; reserved bytes of registers do not count.
#[test]
fn reserved_addresses() {
    let mut words = 0;
    let (sim, can) = bench();
    let bus = sim.registers(can.id);
    let ara = |sim: &Sim| {
        let set = can.ir(sim).contains(pac::Ir::ARA);
        can.clear(sim);
        set
    };
    for range in CONTROLLER.reserved {
        for offset in (range.from..=range.to).step_by(4) {
            let at = offset as usize;
            assert_eq!(bus.read::<u32>(at), 0);
            assert!(ara(&sim), "read of {offset:#x}");
            bus.write(at, u32::MAX);
            assert!(ara(&sim), "write of {offset:#x}");
            assert_eq!(bus.read::<u8>(at + 3), 0);
            assert!(ara(&sim), "byte of {offset:#x}");
            bus.write(at + 2, 0_u16);
            assert!(ara(&sim), "half-word of {offset:#x}");
            words += 1;
        }
    }
    assert_eq!(words, 81);
    assert_eq!(sim.inspect(can.id, |model| model.reserved_accesses()), 4 * 81);
    assert_eq!(sim.take_diagnostics().len(), 4 * 81);
    for (_, offset) in registers() {
        for byte in 0..4 {
            let _ = bus.read::<u8>((offset + byte) as usize);
        }
    }
    assert!(!ara(&sim), "no byte of an implemented register counts");
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
