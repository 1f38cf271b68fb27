//! The storage of every controller's registers against its description, bit by bit, with random states and writes. The
//! expectation is worked out here, from the fields, in another way than the storage does it.
#![allow(clippy::unwrap_used)]

use can_sim::registers::{Place, RegisterFile, Slot, UnknownReset};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use regbus::meta::{Access, Controller, Field, FieldRef, Index, RegisterInfo};

const CONTROLLERS: [&Controller; 4] = [
    &m_can_pac::meta::CONTROLLER,
    &dspic33_canfd_pac::meta::CONTROLLER,
    &dspic33_ecan_pac::meta::CONTROLLER,
    &pic32_can_pac::meta::CONTROLLER,
];

/// The number that `[n]` stands for at a lane of a register.
fn own_number(info: &RegisterInfo, field: &Field, lane: u8, element: u32, inner: u32) -> u32 {
    if field.lanes > 1 {
        return u32::from(field.first_lane) + u32::from(lane) + inner * u32::from(field.lanes);
    }
    match (info.cluster, info.array) {
        (Some(cluster), _) => cluster.first + element,
        (None, Some(array)) => array.first + inner,
        (None, None) => 0,
    }
}

fn value(file: &RegisterFile, at: FieldRef, index: Index, own: u32) -> u32 {
    let info = &file.meta().registers[at.register as usize];
    let field = &info.fields[at.field as usize];
    let number = match index {
        Index::Single => return field.get(file.get(file.find(info.name, 0, 0).unwrap()), 0),
        Index::Own => own,
        Index::Fixed(number) => number,
    };
    for element in 0..info.cluster.map_or(1, |c| c.count) {
        for inner in 0..info.array.map_or(1, |a| a.count) {
            for lane in 0..field.lanes {
                if own_number(info, field, lane, element, inner) == number {
                    return field.get(file.get(file.find(info.name, element, inner).unwrap()), lane);
                }
            }
        }
    }
    panic!("{}.{} has no number {number}", info.name, field.name);
}

fn holds(file: &RegisterFile, condition: Option<u16>, own: u32) -> bool {
    let Some(condition) = condition else { return true };
    file.meta().conditions[condition as usize].expr.holds(&mut |field, index| value(file, field, index, own))
}

/// One bit of a register after a write.
fn expected_bit(
    file: &RegisterFile,
    slot: Slot,
    (element, inner): (u32, u32),
    bit: u32,
    written: u32,
    lanes: u32,
) -> bool {
    let info = file.info(slot);
    let old = file.get(slot) >> bit & 1 == 1;
    let one = written >> bit & 1 == 1;
    let covers = |field: &&Field, lane: u8| field.mask(lane) >> bit & 1 == 1;
    let found =
        info.fields.iter().find_map(|field| (0..field.lanes).find(|lane| covers(&field, *lane)).map(|l| (field, l)));
    let Some((field, lane)) = found else { return old };
    let own = own_number(info, field, lane, element, inner);
    if !holds(file, field.when, own) {
        return old;
    }
    if field.access == Access::Wclr {
        let from = field.loads.map_or(0, |at| value(file, at, Index::Single, 0));
        return from >> (bit - u32::from(field.lsb)) & 1 == 1;
    }
    if lanes >> bit & 1 == 0 {
        return old;
    }
    let new = match field.access {
        Access::Ro | Access::Wclr => old,
        Access::Rw | Access::Wo | Access::Rwh | Access::Rwhc => one,
        Access::W1c => old && !one,
        Access::W0c => old && one,
        Access::W1s => old || one,
    };
    if holds(file, field.set_when, own) { new } else { new && old }
}

#[test]
fn every_bit_of_every_register_is_written_as_described() {
    for (seed, meta) in CONTROLLERS.into_iter().enumerate() {
        let mut random = ChaCha8Rng::seed_from_u64(seed as u64);
        let mut file = RegisterFile::new(meta, UnknownReset::Zeros);
        let mut refused = 0;
        for _round in 0..12 {
            for slot in file.slots() {
                let word = random.next_u32();
                file.set(slot, word & file.info(slot).implemented());
            }
            for info in meta.registers {
                for element in 0..info.cluster.map_or(1, |c| c.count) {
                    for inner in 0..info.array.map_or(1, |a| a.count) {
                        let slot = file.find(info.name, element, inner).unwrap();
                        let lanes = [u32::MAX, 0xFF, 0xFF00, 0xFFFF][random.next_u32() as usize % 4];
                        let lanes = lanes & regbus::bits::mask(u32::from(info.width));
                        let written = random.next_u32() & lanes;
                        let access = file.plan_write(slot, lanes, written, None);
                        let bits = (0..u32::from(info.width))
                            .filter(|bit| expected_bit(&file, slot, (element, inner), *bit, written, lanes));
                        let expected = bits.fold(0, |word, bit| word | 1 << bit);
                        assert_eq!(
                            access.new, expected,
                            "{} {}: {written:#x} over {:#x}, bytes {lanes:#x}",
                            meta.name, info.name, access.old
                        );
                        refused += u32::from(access.refused.is_some());
                    }
                }
            }
        }
        assert!(refused > 0 || meta.registers.iter().all(|info| info.fields.iter().all(|f| f.when.is_none())));
    }
}

#[test]
fn every_register_holds_its_reset_value() {
    for meta in CONTROLLERS {
        for (unknown, fill) in [(UnknownReset::Zeros, 0), (UnknownReset::Ones, u32::MAX)] {
            let file = RegisterFile::new(meta, unknown);
            for slot in file.slots() {
                let info = file.info(slot);
                let expected = info.reset & !info.reset_unknown | fill & info.reset_unknown & info.implemented();
                // What a state that holds after reset loads or resets differs from the printed value in no register.
                assert_eq!(file.get(slot), expected, "{} {}", meta.name, file.name(slot));
            }
        }
    }
}

#[test]
fn every_register_is_found_at_its_address() {
    for meta in CONTROLLERS {
        let mut file = RegisterFile::new(meta, UnknownReset::Zeros);
        for slot in file.slots() {
            let (info, Some(offset)) = (file.info(slot), file.offset(slot)) else { continue };
            if let Some(window) = info.window {
                let window = &meta.windows[window as usize];
                file.set_field(file.field_at(window.select), window.value);
            }
            for byte in 0..info.width / 8 {
                let place = file.place(offset + u32::from(byte));
                assert_eq!(place, Place::Register { slot, byte, alias: None }, "{} {}", meta.name, file.name(slot));
            }
            for alias in meta.aliases.iter().filter(|_| info.aliased) {
                let place = file.place(offset + alias.offset);
                assert_eq!(place, Place::Register { slot, byte: 0, alias: Some(alias.op) });
                let access = file.plan_write(slot, u32::MAX, 0, Some(alias.op));
                assert_eq!(access.new, access.old, "an alias write of 0 changes nothing in {}", file.name(slot));
            }
        }
    }
}
