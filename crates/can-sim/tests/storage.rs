//! The storage of every controller's registers against its description, bit by bit, with random states and writes. The
//! expectation is worked out here, from the fields, in another way than the storage does it.
#![allow(clippy::unwrap_used, dead_code, reason = "the laws' expectations, of which this uses a part")]

#[path = "laws_of/expected.rs"]
mod expected;

use can_sim::registers::{Place, RegisterFile, UnknownReset};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use regbus::meta::Controller;

const CONTROLLERS: [&Controller; 4] = [
    &m_can_pac::meta::CONTROLLER,
    &dspic33_canfd_pac::meta::CONTROLLER,
    &dspic33_ecan_pac::meta::CONTROLLER,
    &pic32_can_pac::meta::CONTROLLER,
];

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
            for at in expected::registers(meta) {
                let slot = at.slot(&file);
                let lanes = [u32::MAX, 0xFF, 0xFF00, 0xFFFF][random.next_u32() as usize % 4];
                let lanes = lanes & regbus::bits::mask(u32::from(at.info.width));
                let written = random.next_u32() & lanes;
                let access = file.plan_write(slot, lanes, written, None);
                let expected = expected::after_write(&file, at, written, lanes);
                let name = file.name(slot);
                assert_eq!(access.new, expected, "{} {name}: {written:#x}, bytes {lanes:#x}", meta.name);
                refused += u32::from(access.refused.is_some());
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
