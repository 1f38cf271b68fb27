//! Laws that hold for every field of every register and message word of the controllers.

use proptest::prelude::*;
use regbus::meta::{Controller, Field, RegisterInfo};

const CONTROLLERS: [&Controller; 5] = [
    &m_can_pac::meta::CONTROLLER,
    &dspic33_canfd_pac::meta::CONTROLLER,
    &dspic33_ecan_pac::meta::CONTROLLER,
    &pic32_can_pac::meta::CONTROLLER,
    &fixture_pac::meta::CONTROLLER,
];

/// Every holder of fields: name, width, fields.
fn holders() -> Vec<(String, u32, &'static [Field])> {
    let mut all = Vec::new();
    for controller in CONTROLLERS {
        for register in controller.registers {
            all.push((format!("{}.{}", controller.name, register.name), u32::from(register.width), register.fields));
        }
        for message in controller.messages {
            for word in message.words {
                let name = format!("{}.{}.{}", controller.name, message.name, word.name);
                all.push((name, u32::from(message.word_width), word.fields));
            }
        }
    }
    all
}

fn registers() -> impl Iterator<Item = (&'static Controller, &'static RegisterInfo)> {
    CONTROLLERS
        .into_iter()
        .flat_map(|controller| controller.registers.iter().map(move |register| (controller, register)))
}

fn word_mask(width: u32) -> u32 {
    regbus::bits::mask(width)
}

#[test]
fn the_descriptions_are_complete() {
    let of = |name: &str| CONTROLLERS.into_iter().find(|c| c.name == name).expect("a controller of this name");
    // The manual's own counts: M_CAN Table 1 has 47 registers, ECAN Tables 3-1 to 3-8 have 65, PIC32 has 181.
    let physical =
        |name: &str| of(name).registers.iter().filter(|r| r.offset.is_some()).map(RegisterInfo::count).sum::<u32>();
    assert_eq!(physical("m_can"), 47);
    assert_eq!(physical("dspic33_ecan"), 65);
    assert_eq!(physical("pic32_can"), 181);
}

#[test]
fn fields_lie_in_their_word_and_do_not_overlap() {
    for (name, width, fields) in holders() {
        let mut taken = 0u32;
        for field in fields {
            for lane in 0..field.lanes {
                let mask = field.mask(lane);
                assert_eq!(mask.count_ones(), u32::from(field.width), "{name}.{} runs out of 32 bits", field.name);
                assert_eq!(mask & !word_mask(width), 0, "{name}.{} leaves the register", field.name);
                assert_eq!(mask & taken, 0, "{name}.{} overlaps another field", field.name);
                taken |= mask;
            }
            assert_eq!(field.all() & taken, field.all());
        }
    }
}

#[test]
fn limits_and_resets_fit_the_fields() {
    for (name, _, fields) in holders() {
        for field in fields {
            let most = regbus::bits::mask(u32::from(field.width));
            assert!(
                field.min <= field.max && field.max <= most,
                "{name}.{}: {}..={}",
                field.name,
                field.min,
                field.max
            );
            assert!(field.reset.is_none_or(|reset| reset <= most), "{name}.{}", field.name);
            for (first, last, value) in field.values.iter().flat_map(|values| values.values) {
                assert!(first <= last && *last <= most, "{name}.{}.{value} does not fit", field.name);
            }
        }
    }
}

#[test]
fn registers_do_not_share_addresses_unless_a_window_tells_them_apart() {
    for controller in CONTROLLERS {
        let mut bytes: Vec<(u32, Option<u8>, &str)> = Vec::new();
        for register in controller.registers {
            for element in 0..register.cluster.map_or(1, |c| c.count) {
                for inner in 0..register.array.map_or(1, |a| a.count) {
                    let Some(offset) = register.offset_of(element, inner) else { continue };
                    assert_eq!(offset % (u32::from(register.width) / 8), 0, "{} is not aligned", register.name);
                    assert!(offset < controller.span, "{} lies outside the block", register.name);
                    bytes.extend(
                        (0..u32::from(register.width) / 8).map(|byte| (offset + byte, register.window, register.name)),
                    );
                }
            }
        }
        bytes.sort_by_key(|(at, _, _)| *at);
        for pair in bytes.windows(2) {
            let [(at, window, name), (next, other_window, other)] = pair else { continue };
            let apart = window.is_some() && other_window.is_some() && window != other_window;
            assert!(at != next || apart, "{} and {} share {at:#x}", name, other);
        }
    }
}

#[test]
fn the_reset_of_a_register_is_made_of_its_fields() {
    for (controller, register) in registers() {
        for field in register.fields {
            for lane in 0..field.lanes {
                let known = register.reset_unknown & field.mask(lane) == 0;
                if known && field.lanes == 1 {
                    let name = format!("{}.{}.{}", controller.name, register.name, field.name);
                    assert_eq!(field.reset, Some(field.get(register.reset, lane)), "{name}");
                }
            }
        }
        assert_eq!(register.reset & !register.implemented() & !register.reset_unknown, 0, "{}", register.name);
    }
}

proptest! {
    /// What the getters take apart, put together again, is the word.
    #[test]
    fn taking_apart_and_putting_together(word: u32) {
        for (name, width, fields) in holders() {
            let word = word & word_mask(width);
            let mut again = 0;
            let mut implemented = 0;
            for field in fields {
                implemented |= field.all();
                for lane in 0..field.lanes {
                    again = regbus::bits::put(again, field.lsb_of(lane), u32::from(field.width), field.get(word, lane));
                }
            }
            prop_assert_eq!(again, word & implemented, "{}", name);
        }
    }

    /// A setter changes its own bits and no others, and the getter returns what was set.
    #[test]
    fn putting_a_field_leaves_the_others(word: u32, value: u32) {
        for (name, _, fields) in holders() {
            for field in fields {
                for lane in 0..field.lanes {
                    let changed = regbus::bits::put(word, field.lsb_of(lane), u32::from(field.width), value);
                    prop_assert_eq!((changed ^ word) & !field.mask(lane), 0, "{}.{}", &name, field.name);
                    prop_assert_eq!(field.get(changed, lane), value & regbus::bits::mask(u32::from(field.width)));
                }
            }
        }
    }
}
