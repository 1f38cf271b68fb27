//! Acceptance filters (9.1).

use can_hal::{
    Events, InterruptSet,
    dspic33_ecan::{Filter, FilterError, FilterTarget, Interrupts, Mask, MaskSource},
};

use crate::bench::{Bench, CONFIG, Driver, MODE, PLAN, extended, frame, standard};

fn accepts<S: can_hal::mode::OnBus>(
    bench: &Bench,
    can: &mut Driver<'_, S>,
    other: can_sim::PeerId,
    buffer: u8,
    text: &str,
) -> bool {
    bench.send(other, &[text]);
    let message = can.receive_buffer(buffer);
    assert!(message.is_none_or(|message| message.frame == frame(text)));
    message.is_some()
}

/// Example 9-1: standard identifiers 0x1D0 to 0x1D7 to buffer 10, with filter 0 and mask 0. The printed mask of 0x007 is
/// inverted (`example_masks`): 0x7F8.
#[test]
fn example_9_1_standard_filter() {
    let bench = Bench::new();
    let other = bench.peer();
    let filters = [Filter::new(standard(0x1D0), MaskSource::Mask0, FilterTarget::Buffer(10))];
    let masks = [Mask::standard(0x7F8), Mask::ANY, Mask::ANY];
    let mut can = bench.running(&PLAN, &CONFIG.with_filters(masks, &filters));
    for id in 0x1D0..=0x1D7 {
        assert!(accepts(&bench, &mut can, other, 10, &format!("{id:03X}#01")));
    }
    for text in ["1CF#", "1D8#", "007#", "07400000#"] {
        assert!(!accepts(&bench, &mut can, other, 10, text), "{text}");
    }
    bench.finish();
}

/// Example 9-2: extended identifiers that equal 0x1E03F580 but for the last six bits, with filter 2 and mask 1. Printed:
/// an inverted mask, RXM2EID instead of RXF2EID, 0xF680 instead of 0xF580, FLTEN1 instead of FLTEN2, WIN left at 1
/// (`example_masks`, `example_9_2_slips`).
#[test]
fn example_9_2_extended_filter() {
    let bench = Bench::new();
    let other = bench.peer();
    let masks = [Mask::ANY, Mask::extended(0x1FFF_FFC0), Mask::ANY];
    let mut can = bench.configured(&PLAN, &CONFIG.with_filters(masks, &[]));
    can.set_filter(2, &Filter::new(extended(0x1E03_F580), MaskSource::Mask1, FilterTarget::Buffer(5))).unwrap();
    assert_eq!(can.registers().fen1().read().bits(), 0x0004);
    let mut can = can.start_normal(MODE).unwrap();
    assert!(accepts(&bench, &mut can, other, 5, "1E03F580#01") && accepts(&bench, &mut can, other, 5, "1E03F5BF#02"));
    assert!(!accepts(&bench, &mut can, other, 5, "1E03F5C0#") && !accepts(&bench, &mut can, other, 5, "780#"));
    bench.send(other, &["1E03F5A5#"]);
    assert_eq!(can.receive_buffer(5).unwrap().filter, 2);
    bench.finish();
}

/// 9.1: filters and masks change while the module runs.
#[test]
fn filters_change_while_the_module_runs() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_filters([Mask::STANDARD, Mask::EXTENDED, Mask::ANY], &[]));
    assert!(!accepts(&bench, &mut can, other, 9, "100#"));
    let filter = Filter::new(standard(0x100), MaskSource::Mask0, FilterTarget::Buffer(9));
    can.set_filter(15, &filter).unwrap();
    assert!(accepts(&bench, &mut can, other, 9, "100#") && !accepts(&bench, &mut can, other, 9, "101#"));
    can.set_mask(MaskSource::Mask0, &Mask::standard(0x7FE));
    assert!(accepts(&bench, &mut can, other, 9, "101#") && !accepts(&bench, &mut can, other, 9, "102#"));
    can.set_filter(14, &Filter::any(FilterTarget::Fifo, MaskSource::Mask2)).unwrap();
    bench.send(other, &["1ABCDEF0#01"]);
    assert_eq!(can.receive_message().unwrap().map(|message| (message.filter, message.buffer)), Some((14, 16)));
    can.disable_filter(14).unwrap();
    can.disable_filter(15).unwrap();
    assert!(!accepts(&bench, &mut can, other, 9, "100#"));
    assert_eq!(can.set_filter(16, &filter), Err(FilterError::NoSuchFilter { filter: 16 }));
    assert_eq!(can.disable_filter(16), Err(FilterError::NoSuchFilter { filter: 16 }));
    bench.finish();
}

/// The window is closed again: an interrupt after a change of filters finds the status registers.
#[test]
fn section_3_0_the_window_is_closed() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG);
    can.set_mask(MaskSource::Mask1, &Mask::ANY);
    assert_eq!(can.registers().ctrl1().read().bits() & 1, 0);
    bench.send(other, &["100#01"]);
    let flags: Interrupts = can.take_interrupts();
    assert!(flags.events().contains(Events::RECEIVED));
    assert!(can.receive_buffer(8).is_some());
    bench.finish();
}
