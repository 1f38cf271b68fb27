//! Acceptance filtering (9.1, 9.5).

use crate::bench::{Can, FRAME, Filter, add, everything, exactly, extended, frame, kinds, peer, standard};
use can_frame::Id;
use can_sim::{DiagnosticKind, PeerId, Sim};
use dspic33_ecan_pac::{
    enums::{Ctrl2Dncnt, FilterTarget, IdentifierFormat, MaskSource, OperationMode, RxmSidMide},
    registers as pac,
};
use regbus::Bus;

/// A module in Normal mode with these filters only.
fn bench(filters: &[Filter]) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim);
    for filter in filters {
        can.add_filter(&sim, *filter);
    }
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    (sim, can, other)
}

/// Whether a message is stored in a buffer.
fn accepts(sim: &Sim, can: Can, other: PeerId, buffer: usize, text: &str) -> bool {
    sim.peer_send(other, frame(text));
    sim.run_for(FRAME);
    let stored = can.take(sim, buffer);
    if let Some(stored) = stored {
        assert_eq!(stored, frame(text));
    }
    stored.is_some()
}

/// Table 9-2, bit by bit over both identifiers: mask 0 accepts, mask 1 compares.
#[test]
fn table_9_2_mask_and_filter_bits() {
    for bit in 0..11 {
        for (mask, filter, message, accepted) in [
            (0, 0, 0, true),
            (0, 0, 1, true),
            (0, 1, 0, true),
            (1, 0, 0, true),
            (1, 0, 1, false),
            (1, 1, 0, false),
            (1, 1, 1, true),
        ] {
            let filter = Filter {
                mask_bits: mask << bit,
                id: standard(filter << bit),
                ..exactly(4, MaskSource::Mask2, standard(0), 11)
            };
            let (sim, can, other) = bench(&[filter]);
            let text = format!("{:03X}#", message << bit);
            assert_eq!(accepts(&sim, can, other, 11, &text), accepted, "bit {bit} mask {mask} message {message}");
        }
    }
    for bit in 0..29 {
        for (mask, filter, message, accepted) in
            [(0, 1, 0, true), (1, 0, 0, true), (1, 0, 1, false), (1, 1, 0, false), (1, 1, 1, true)]
        {
            let filter = Filter {
                mask_bits: mask << bit,
                id: extended(filter << bit),
                ..exactly(15, MaskSource::Mask0, extended(0), 11)
            };
            let (sim, can, other) = bench(&[filter]);
            let text = format!("{:08X}#", message << bit);
            assert_eq!(accepts(&sim, can, other, 11, &text), accepted, "bit {bit} mask {mask} message {message}");
        }
    }
}

/// Table 9-3: MIDE and EXIDE.
#[test]
fn table_9_3_message_types() {
    for (mide, exide, takes_standard, takes_extended) in [
        (RxmSidMide::ByExide, IdentifierFormat::Standard, true, false),
        (RxmSidMide::ByExide, IdentifierFormat::Extended, false, true),
        (RxmSidMide::BothFormats, IdentifierFormat::Standard, true, true),
        (RxmSidMide::BothFormats, IdentifierFormat::Extended, true, true),
    ] {
        let sim = Sim::new();
        // 0x123 and 0x048C0005 have the same standard identifier.
        let id = match exide {
            IdentifierFormat::Standard => standard(0x123),
            IdentifierFormat::Extended => extended(0x048C_0000),
        };
        let mask_bits = if exide == IdentifierFormat::Standard { 0x7FF } else { 0x7FF << 18 };
        let filter =
            Filter { number: 0, mask: MaskSource::Mask0, id, mask_bits, mide, target: FilterTarget::Buffer(9) };
        let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, filter);
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        assert_eq!(accepts(&sim, can, other, 9, "123#"), takes_standard, "{mide:?} {exide:?}");
        assert_eq!(accepts(&sim, can, other, 9, "048C0005#"), takes_extended, "{mide:?} {exide:?}");
        assert!(!accepts(&sim, can, other, 9, "124#") && !accepts(&sim, can, other, 9, "04900000#"));
    }
}

/// Register 4-6: with MIDE 0 a standard message is compared in SID only, an extended one in SID and EID.
#[test]
fn register_4_6_both_formats() {
    let filter = Filter {
        number: 0,
        mask: MaskSource::Mask0,
        id: extended(0x048C_0005),
        mask_bits: 0x1FFF_FFFF,
        mide: RxmSidMide::BothFormats,
        target: FilterTarget::Buffer(9),
    };
    let (sim, can, other) = bench(&[filter]);
    assert!(accepts(&sim, can, other, 9, "123#55"));
    assert!(accepts(&sim, can, other, 9, "048C0005#55"));
    assert!(!accepts(&sim, can, other, 9, "048C0004#55"));
}

/// Example 9-1: standard identifiers 0x1D0 to 0x1D7 go to buffer 10. The printed mask of 0x007 is inverted
/// (`example_masks`): 1 compares, so it must be 0x7F8.
#[test]
fn example_9_1_standard_filter() {
    for (mask_bits, inside, outside) in [(0x7F8, true, false), (0x007, true, true)] {
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim);
        let other = peer(&sim);
        // Register by register, as printed.
        let regs = can.regs(&sim);
        regs.ctrl1().modify(|value| value.with_win(dspic33_ecan_pac::enums::Ctrl1Win::Filter));
        let bus = sim.registers(can.id);
        regs.fmsk_sel(1).modify(|value| value.with_fmsk(0, MaskSource::Mask0));
        bus.write(0x30, mask_bits << 5 | 1_u16 << 3);
        bus.write(0x40, 0x1D0_u16 << 5);
        bus.write(0x20, 0x000A_u16);
        regs.fen1().write(pac::Fen1::flten_bit(0));
        regs.ctrl1().modify(|value| value.with_win(dspic33_ecan_pac::enums::Ctrl1Win::Buffer));
        can.enter(&sim, OperationMode::Normal);
        assert!(accepts(&sim, can, other, 10, "1D0#"));
        assert_eq!(accepts(&sim, can, other, 10, "1D7#"), inside && !outside);
        assert!(!accepts(&sim, can, other, 10, "1CF#"));
        assert_eq!(accepts(&sim, can, other, 10, "7F8#"), outside, "the inverted mask lets a stranger through");
        assert!(!accepts(&sim, can, other, 10, "07400000#"), "no extended message");
        assert_eq!(sim.diagnostics(), []);
    }
}

/// Example 9-2: extended identifiers 0x1E03F580 to 0x1E03F5BF by filter 2 and mask 1. Corrected (`example_9_2_slips`,
/// `example_masks`): mask 0x7FF, 3, 0xFFC0; the identifier's low part 0xF580 goes to RXF2EID; FLTEN2; WIN back to 0.
#[test]
fn example_9_2_extended_filter() {
    let id = 0x780 << 18 | 3 << 16 | 0xF580;
    let mask_bits = 0x7FF << 18 | 3 << 16 | 0xFFC0;
    let filter = Filter {
        number: 2,
        mask: MaskSource::Mask1,
        id: extended(id),
        mask_bits,
        mide: RxmSidMide::ByExide,
        target: FilterTarget::Buffer(5),
    };
    let (sim, can, other) = bench(&[filter]);
    assert_eq!(can.regs(&sim).fmsk_sel(1).read().bits(), 0x0010);
    assert_eq!(can.regs(&sim).fen1().read().bits(), 0x0004);
    assert_eq!(id, 0x1E03_F580);
    assert!(accepts(&sim, can, other, 5, "1E03F580#01"));
    assert!(accepts(&sim, can, other, 5, "1E03F5BF#02"));
    assert!(!accepts(&sim, can, other, 5, "1E03F5C0#"));
    assert!(!accepts(&sim, can, other, 5, "1E03F57F#"));
    assert!(!accepts(&sim, can, other, 5, "780#"));
    sim.peer_send(other, frame("1E03F585#"));
    sim.run_for(FRAME);
    assert_eq!(can.words(&sim, 5)[7], 2 << 8, "FILHIT");
}

/// Table 9-1: each filter with each mask; code 11 is reserved (`mask_code_3`): all bits, standard messages only.
#[test]
fn table_9_1_mask_sources() {
    for number in [0, 7, 8, 15] {
        for mask in [MaskSource::Mask0, MaskSource::Mask1, MaskSource::Mask2] {
            let (sim, can, other) = bench(&[exactly(number, mask, standard(0x321), 12)]);
            assert!(accepts(&sim, can, other, 12, "321#"));
            assert!(!accepts(&sim, can, other, 12, "320#"));
            assert_eq!(sim.diagnostics(), []);
        }
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim);
        can.add_filter(&sim, Filter { mask_bits: 0, ..exactly(number, MaskSource::Mask0, standard(0x321), 12) });
        let (sources, lane) = can.regs(&sim).fmsk_sel_of(number);
        sim.registers(can.id).write(sources.offset(), 3_u16 << (2 * lane));
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        assert!(accepts(&sim, can, other, 12, "321#"));
        assert!(!accepts(&sim, can, other, 12, "322#") && !accepts(&sim, can, other, 12, "0C840000#"));
        assert_eq!(kinds(&sim), [DiagnosticKind::ReservedValue { register: "FMSKSEL", field: "FMSK", value: 3 }]);
    }
}

/// `remote_frame_acceptance`: data and remote frames match alike.
#[test]
fn section_8_3_2_remote_frames_match_like_data_frames() {
    let (sim, can, other) = bench(&[exactly(1, MaskSource::Mask0, standard(0x321), 12)]);
    assert!(accepts(&sim, can, other, 12, "321#R4"));
    assert!(!accepts(&sim, can, other, 12, "322#R4"));
    sim.peer_send(other, frame("321#R4"));
    sim.run_for(FRAME);
    // extended_words_of_standard_message, standard_remote_frame.
    assert_eq!(can.words(&sim, 12), [0x321 << 2 | 2, 0, 4, 0, 0, 0, 0, 1 << 8]);
}

/// A filter for standard identifier 0x100 whose EID is compared with data bits.
fn data_filter() -> Filter {
    Filter {
        number: 0,
        mask: MaskSource::Mask0,
        id: Id::Standard(can_frame::StandardId::new(0x100).unwrap()),
        mask_bits: 0x7FF,
        mide: RxmSidMide::ByExide,
        target: FilterTarget::Buffer(9),
    }
}

/// Sets EID of filter 0 and of mask 0, and DNCNT.
fn set_data_bits(sim: &Sim, can: Can, eid: u32, mask: u32, count: u8) {
    let mut regs = can.regs(sim);
    regs.filter_window(|window| {
        let (sid, mask_sid) = (window.rxf_sid(0).read(), window.rxm_sid(0).read());
        window.rxf_sid(0).write(sid.with_eid((eid >> 16) as u8));
        window.rxf_eid(0).write(pac::RxfEid::RESET.with_eid(eid as u16));
        window.rxm_sid(0).write(mask_sid.with_eid((mask >> 16) as u8));
        window.rxm_eid(0).write(pac::RxmEid::RESET.with_eid(mask as u16));
    });
    let count = if count == 0 { Ctrl2Dncnt::Off } else { Ctrl2Dncnt::DataBits(count) };
    regs.ctrl2().write(pac::Ctrl2::RESET.with_dncnt(count));
}

/// Table 9-5: with DNCNT n the first n data bits decide, the others do not. EID 0x294F2 is data A5 3C 80.
#[test]
fn table_9_5_data_bits() {
    let (sim, can, other) = bench(&[data_filter()]);
    let data = 0xA5_3C_80_u32;
    for count in 0..=18_u8 {
        set_data_bits(&sim, can, 0x294F2, 0x3_FFFF, count);
        assert!(accepts(&sim, can, other, 9, &format!("100#{data:06X}")), "{count}");
        assert!(!accepts(&sim, can, other, 9, &format!("101#{data:06X}")), "{count}: the identifier has to match");
        for bit in 0..18 {
            let changed = data ^ 0x80_0000 >> bit;
            let accepted = bit >= u32::from(count);
            assert_eq!(
                accepts(&sim, can, other, 9, &format!("100#{changed:06X}")),
                accepted,
                "{count} bits, bit {bit}"
            );
        }
    }
    assert_eq!(sim.diagnostics(), []);
}

/// 9.5.2: fewer data bits than DNCNT asks for.
#[test]
fn section_9_5_2_special_cases() {
    let (sim, can, other) = bench(&[data_filter()]);
    set_data_bits(&sim, can, 0x294F2, 0x3_FFFF, 18);
    // Case 2: 16 bits; case 3: 8 bits; case 4: the identifier alone.
    for (text, accepted) in
        [("100#A53C", true), ("100#A53D", false), ("100#A5", true), ("100#A4", false), ("100#", true), ("101#", false)]
    {
        assert_eq!(accepts(&sim, can, other, 9, text), accepted, "{text}");
    }
    // A remote frame has no data.
    assert!(accepts(&sim, can, other, 9, "100#R3"));
    // Case 1: more than 18 is invalid (Register 4-24) and compares 18 bits (dncnt_above_18).
    sim.registers(can.id).write(0x02, 31_u16);
    assert!(accepts(&sim, can, other, 9, "100#A53CBF"));
    assert!(!accepts(&sim, can, other, 9, "100#A53CC0"));
    let out_of_range =
        DiagnosticKind::ValueOutOfRange { register: "CTRL2", field: "DNCNT", value: 31, min: 0, max: 18 };
    assert_eq!(kinds(&sim), [out_of_range]);
}

/// 9.5, note: only for standard messages, with EXIDE 0 and MIDE 1.
#[test]
fn section_9_5_conditions() {
    // MIDE 0: data bits play no part.
    let (sim, can, other) = bench(&[Filter { mide: RxmSidMide::BothFormats, ..data_filter() }]);
    set_data_bits(&sim, can, 0x294F2, 0x3_FFFF, 18);
    assert!(accepts(&sim, can, other, 9, "100#000000"));
    // An extended message is compared by its identifier, data or not.
    assert!(accepts(&sim, can, other, 9, "040294F2#000000"));
    assert!(!accepts(&sim, can, other, 9, "040294F3#A53C80"));
}

/// Register 4-3: after a reset all 16 filters are enabled, with mask 0 and buffer 0, their content unknown.
#[test]
fn register_4_3_filters_after_reset() {
    let sim = Sim::new();
    let can = crate::bench::add_with(&sim, "can1", |mut config| {
        config.unknown_reset = can_sim::registers::UnknownReset::Pattern(7);
        config
    });
    let mut regs = can.regs(&sim);
    assert_eq!(regs.fen1().read().bits(), 0xFFFF);
    let known =
        regs.filter_window(|window| (0..16).map(|n| window.rxf_sid(n).read().bits()).filter(|bits| *bits == 0).count());
    assert_eq!(known, 0, "nothing to rely on");
    assert_eq!(regs.cfg1().read().bits(), 0, "lost pages reset to 0");
}

/// 9.1: filters may change while the module is on the bus (`unprotected_registers`); a change holds from the next
/// message on.
#[test]
fn filters_change_on_the_bus() {
    let (sim, can, other) = bench(&[exactly(0, MaskSource::Mask0, standard(0x100), 8)]);
    assert!(accepts(&sim, can, other, 8, "100#"));
    can.add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x200), 9));
    assert!(!accepts(&sim, can, other, 8, "100#"));
    assert!(accepts(&sim, can, other, 9, "200#"));
    can.regs(&sim).fen1().write(pac::Fen1::from_bits(0));
    assert!(!accepts(&sim, can, other, 9, "200#"));
    assert_eq!(sim.inspect(can.id, |model| model.filter_target(0)), None);
    can.add_filter(&sim, everything(FilterTarget::Buffer(9)));
    assert_eq!(sim.inspect(can.id, |model| model.filter_target(0)), Some(FilterTarget::Buffer(9)));
    assert!(sim.inspect(can.id, |model| model.filter_matches(0, &frame("7FF#"))));
    assert_eq!(sim.diagnostics(), []);
}
