//! What only the fixture's registers have.

use canpac_pac_tests::{Recorder, read, write};
use fixture_pac::Fixture;
use fixture_pac::registers::{Bytes, Command, Flags, Mixed};

#[test]
fn a_write_only_register_is_written() {
    let bus = Recorder::new();
    Fixture::new(&bus).command().write(Command::RESET.with_code(0x5A));
    assert_eq!(bus.take(), [write(32, 0x00, 0x5A)]);
}

#[test]
fn modify_writes_every_flag_with_its_neutral_value() {
    // All flags are up: ONE (cleared by 1), ZERO (cleared by 0), GO (requested by 1), BUSY (read-only).
    let bus = Recorder::holding(32, 0x04, 0x10F);
    Fixture::new(&bus).mixed().modify(|r| r.with_mode(2));
    assert_eq!(bus.take(), [read(32, 0x04, 0x10F), write(32, 0x04, 0x202)]);
    // A request that is asked for is made.
    Fixture::new(&bus).mixed().modify(|r| r | Mixed::GO);
    assert_eq!(bus.take(), [read(32, 0x04, 0x202), write(32, 0x04, 0x206)]);
}

#[test]
fn the_closure_of_modify_sees_no_flags() {
    // A setter of a stored field must not depend on a flag that the write would clear.
    let bus = Recorder::holding(32, 0x04, 0x10F);
    Fixture::new(&bus).mixed().modify(|r| {
        assert_eq!(r.bits(), 0x100);
        r
    });
}

#[test]
fn one_store_clears_flags_of_both_kinds() {
    let bus = Recorder::holding(32, 0x08, 0x3F);
    // ONE 1:0 is cleared by 1, ZERO 3:2 by 0, GO 5:4 is requested by 1.
    Fixture::new(&bus).flags().clear(Flags::from_bits(0b00_0101));
    assert_eq!(bus.take(), [write(32, 0x08, 0b00_1001)]);
    Fixture::new(&bus).flags().request(Flags::from_bits(0b01_0000));
    assert_eq!(bus.take(), [write(32, 0x08, 0b01_1100)]);
}

#[test]
fn halves_in_the_order_of_the_description() {
    let bus = Recorder::holding(16, 0x0C, 0x1234);
    bus.put(16, 0x0E, 0x5678);
    assert_eq!(Fixture::new(&bus).read_count(), 0x1234_5678);
    assert_eq!(bus.take(), [read(16, 0x0C, 0x1234), read(16, 0x0E, 0x5678)]);
    Fixture::new(&bus).write_count(0xAAAA_5555);
    assert_eq!(bus.take(), [write(16, 0x0C, 0xAAAA), write(16, 0x0E, 0x5555)]);
}

#[test]
fn bytes_and_signed_numbers() {
    let bus = Recorder::new();
    let block = Fixture::new(&bus);
    for (number, register) in block.bytes_iter() {
        register.write(Bytes::RESET.with_offset(-(number as i8)));
    }
    assert_eq!(bus.take(), [write(8, 0x10, 0x7F), write(8, 0x12, 0x7E), write(8, 0x14, 0x7D)]);
    assert_eq!(block.bytes(3).read().offset(), -3);
    assert_eq!(Bytes::from_bits(0x40).offset(), -64);
}

#[test]
#[should_panic(expected = "bytes takes 1..=3")]
fn an_array_starts_at_the_manuals_number() {
    let _ = Fixture::new(&Recorder::new()).bytes(0);
}
