//! Registers, fields, arrays, windows, enumerations.

use regdef::model::*;

use crate::{field, load, notation, place, register};

#[test]
fn access_codes_have_notations() {
    let model = load("access_codes");
    for (path, text) in [
        ("CTRL.RUN", "rw"),
        ("CTRL.PHASE", "rw:config+s:CTRL.RUN && STAT.LEVEL >= 3"),
        ("CTRL.LOW", "rw:config"),
        ("CTRL.PIN", "ro"),
        ("FLAGS.DONE", "w1c"),
        ("FLAGS.FULL", "w0c"),
        ("FLAGS.KICK", "w1s"),
        ("STAT.LEVEL", "ro"),
        ("STAT.LEC", "ro+rs"),
        ("STAT.CEL", "ro+rc@2"),
        ("MIXED.REQ", "rwhc"),
        ("MIXED.STATE", "rwh"),
        ("MIXED.COUNT", "wclr"),
        ("COMMAND.CODE", "wo"),
    ] {
        assert_eq!(notation(&model, path), text, "{path}");
    }
    assert_eq!(field(&model, "MIXED.COUNT").access.loads, Some(place(&model, "MIXED.TOP")));
    assert_eq!(field(&model, "MIXED.TOP").access.must_write, Some(0));
}

#[test]
fn access_codes_are_one_table() {
    use AccessCode::*;
    let table = [
        (Rw, true, true, WriteEffect::Stores, Neutral::AsRead, false),
        (Ro, true, false, WriteEffect::Ignored, Neutral::Zero, true),
        (Wo, false, true, WriteEffect::Stores, Neutral::Zero, false),
        (W1c, true, true, WriteEffect::OneClears, Neutral::Zero, true),
        (W0c, true, true, WriteEffect::ZeroClears, Neutral::Ones, true),
        (W1s, true, true, WriteEffect::OneSets, Neutral::Zero, true),
        (Rwhc, true, true, WriteEffect::Requests, Neutral::None, true),
        (Rwh, true, true, WriteEffect::Stores, Neutral::None, true),
        (Wclr, true, true, WriteEffect::Resets, Neutral::None, true),
    ];
    assert_eq!(table.map(|row| row.0), AccessCode::ALL);
    for (code, readable, writable, effect, neutral, hardware) in table {
        let name = code.as_str();
        assert_eq!((code.readable(), code.writable()), (readable, writable), "{name}");
        assert_eq!((code.write_effect(), code.neutral()), (effect, neutral), "{name}");
        assert_eq!(code.hardware_changes(), hardware, "{name}");
        let read: AccessCode = serde_json::from_str(&format!("\"{name}\"")).unwrap();
        assert_eq!(read, code, "{name} is written as it is read");
    }
}

#[test]
fn capabilities_follow_from_the_fields() {
    let model = load("access_codes");
    let of = |name: &str| register(&model, name).capabilities.clone();
    let plain = Capabilities {
        readable: true,
        writable: true,
        pure: true,
        modify: Ok(()),
        one_clears: 0,
        zero_clears: 0,
        one_sets: 0,
        neutral_zeros: 1 << 31,
        neutral_ones: 0,
    };
    assert_eq!(of("CTRL"), plain);
    let flags = ["DONE", "FULL", "KICK"].map(str::to_owned).to_vec();
    assert_eq!(
        of("FLAGS"),
        Capabilities {
            modify: Err(NoModify::OnlyFlags(flags)),
            one_clears: 1,
            zero_clears: 2,
            one_sets: 4,
            neutral_zeros: 5,
            neutral_ones: 2,
            ..plain.clone()
        }
    );
    let none = Capabilities { neutral_zeros: 0, ..plain.clone() };
    let status = Capabilities { writable: false, pure: false, modify: Err(NoModify::NotReadWrite), ..plain.clone() };
    assert_eq!(of("STAT"), Capabilities { neutral_zeros: 0x00ff_007f, ..status });
    let stuck = ["REQ", "STATE", "COUNT"].map(str::to_owned).to_vec();
    assert_eq!(of("MIXED"), Capabilities { modify: Err(NoModify::NoNeutral(stuck)), ..none });
    let command = Capabilities { readable: false, modify: Err(NoModify::NotReadWrite), ..plain.clone() };
    assert_eq!(of("COMMAND"), Capabilities { neutral_zeros: 0xff, ..command });
    assert_eq!(of("ADDRESS"), Capabilities { one_sets: 1, neutral_zeros: 3, ..plain });
    // A writable register whose read has an effect cannot be modified either.
    let mut fields = register(&model, "STAT").fields.clone();
    fields[0].access.code = AccessCode::Rw;
    let effects = ["LEC", "CEL"].map(str::to_owned).to_vec();
    assert_eq!(Capabilities::of(&fields).modify, Err(NoModify::ReadHasEffects(effects)));
    assert_eq!(Capabilities::of(&[]).modify, Err(NoModify::NotReadWrite));
    assert_eq!(field(&model, "MIXED.SAFE").access.neutral(), Neutral::AsRead, "said to be safe");
}

#[test]
fn resets_come_from_the_register_or_its_fields() {
    let model = load("access_codes");
    assert_eq!(register(&model, "CTRL").reset, Reset { value: 0x0001_0000, unknown: 0x8000_0000 });
    assert_eq!(field(&model, "CTRL.LOW").reset, FieldReset::Value(1));
    assert_eq!(field(&model, "CTRL.PIN").reset, FieldReset::None(ResetKind::Unknown));
    assert_eq!(register(&model, "STAT").reset, Reset { value: 7 << 4, unknown: 0x00ff_0000 });
    assert_eq!(register(&model, "ADDRESS").reset, Reset { value: 0, unknown: 0xffff_fffe });
    assert_eq!(field(&model, "ADDRESS.BASE").reset, FieldReset::None(ResetKind::Product));
    assert_eq!(field(&model, "ADDRESS.LEVELS").reset, FieldReset::None(ResetKind::Pin));
    let base = field(&model, "ADDRESS.BASE");
    assert_eq!(base.reset_of_lane(register(&model, "ADDRESS").reset, 0), None);
}

#[test]
fn fields_have_masks_limits_and_encodings() {
    let model = load("access_codes");
    let low = field(&model, "CTRL.LOW");
    assert_eq!((low.lsb, low.width, low.mask(), low.capacity()), (16, 8, 0x00ff_0000, 255));
    assert_eq!((low.min, low.max), (1, 200));
    let encoding = low.encoding.clone().unwrap();
    assert_eq!(
        (encoding.add, encoding.times, encoding.signed, encoding.unit.as_deref()),
        (1, Some(4), false, Some("tq"))
    );
    assert_eq!((field(&model, "CTRL.RUN").kind, low.kind), (Kind::Enum(EnumId(0)), Kind::Int));
    assert_eq!(field(&model, "CTRL.PIN").kind, Kind::Bool);
    assert_eq!(low.enumeration(), None);
    assert_eq!(low.cites[0].section.as_deref(), Some("1.1"), "the register's");
    let register = register(&model, "CTRL");
    assert_eq!((register.implemented(), register.writable_bits()), (0x80ff_00f1, 0x00ff_00f1));
    assert_eq!(bit_mask(0, 64), u64::MAX);
    assert_eq!((bit_mask(31, 1), bit_mask(4, 0)), (1 << 31, 0));
    let address = model.registers.iter().find(|r| r.unsafe_write.is_some()).unwrap();
    assert_eq!((address.name.as_str(), address.hazards.len()), ("ADDRESS", 1));
}

#[test]
fn lanes_run_on_over_arrays() {
    let model = load("arrays_and_lanes");
    let con = register(&model, "FLTCON");
    let dim = con.dim.as_ref().unwrap();
    assert_eq!((0..3).map(|n| con.label_of(dim, n)).collect::<Vec<_>>(), ["FLTCON0", "FLTCON1", "FLTCON2"]);
    assert_eq!((con.ident.snake.as_str(), con.ident.pascal.as_str()), ("filter_con", "FilterCon"));
    assert!(con.lanes_run_on());
    let enable = con.field("FLTEN").unwrap();
    assert_eq!((enable.mask(), enable.lane_count()), (0x8080_8080, 4));
    assert_eq!((enable.lane_lsb(2), enable.lane_mask(3)), (23, 1 << 31));
    assert_eq!(enable.label_of(0, 0), "FLTEN0");
    assert_eq!(enable.label_of(2, 3), "FLTEN11");
    assert_eq!(con.field("FBP").unwrap().label_of(1, 2), "F6BP");
    let buffers = register(&model, "TRCON");
    assert_eq!(buffers.width, 16);
    assert_eq!(buffers.label_of(buffers.dim.as_ref().unwrap(), 1), "TR23CON");
    assert_eq!(buffers.field("TXREQ").unwrap().mask(), 0x0808);
    let mask = register(&model, "MASK");
    assert_eq!(mask.label_of(mask.dim.as_ref().unwrap(), 1), "MASK2");
    assert_eq!(mask.field("REQ").unwrap().label_of(1, 0), "REQ21", "the second register starts at 5 + 16");
    assert_eq!(mask.field("BITS_LOW").unwrap().label_of(1, 0), "BITS_LOW", "not repeated");
    assert_eq!(model.prefix, "Cx");
}

#[test]
fn every_register_has_its_place() {
    let model = load("arrays_and_lanes");
    let all: Vec<_> =
        model.instances_of_registers().iter().map(|p| (p.offset, p.label(&model), p.position(&model))).collect();
    let expected = [
        (0x00, "FLTCON0", 0),
        (0x04, "FLTCON1", 1),
        (0x08, "FLTCON2", 2),
        (0x0c, "TR01CON", 0),
        (0x0e, "TR23CON", 1),
        (0x10, "MASK1", 0),
        (0x14, "MASK2", 1),
        (0x20, "FIFOCON1", 0),
        (0x24, "FIFOSTA1", 0),
        (0x28, "FIFOCON2", 1),
        (0x2c, "FIFOSTA2", 1),
        (0x30, "FIFOCON3", 2),
        (0x34, "FIFOSTA3", 2),
    ];
    assert_eq!(all, expected.map(|(offset, label, position)| (offset, label.to_owned(), position)));
    assert_eq!(model.block_registers().count(), 3);
    let members: Vec<_> = model.cluster_registers(ClusterId(0)).map(|(_, r)| r.name.as_str()).collect();
    assert_eq!(members, ["FIFOCON", "FIFOSTA"]);
    let cluster = &model.clusters[0];
    assert_eq!((cluster.offset, cluster.dim.count, cluster.dim.stride, cluster.dim.first), (0x20, 3, 8, 1));
    assert_eq!(register(&model, "FIFOCON").ident.within(&cluster.ident).snake, "con");
    let both = &model.joined[0];
    assert_eq!((both.cluster, both.width, both.order), (Some(ClusterId(0)), 64, HalfOrder::HighFirst));
    let hole = &model.reserved[0];
    assert_eq!((hole.from, hole.to, hole.reads, hole.window), (0x18, 0x1f, Some(0), None));
    assert_eq!(hole.sets, Some(place(&model, "MASK.REQ")));
}

#[test]
fn windows_halves_and_device_registers() {
    let model = load("windows_and_halves");
    let windows: Vec<_> =
        model.windows.iter().map(|w| (w.name.as_str(), model.field_path(w.select), w.value)).collect();
    assert_eq!(windows, [("buffers", "CTRL1.WIN".to_owned(), 0), ("filters", "CTRL1.WIN".to_owned(), 1)]);
    assert_eq!(register(&model, "TREC").window, Some(WindowId(0)));
    assert_eq!(register(&model, "SID").window, Some(WindowId(1)));
    assert_eq!(model.registers.iter().map(|r| r.width).max(), Some(16));
    let clock = register(&model, "CANCKCON");
    assert_eq!((clock.offset, clock.aliased), (None, false));
    let placed = model.instances_of_registers();
    assert!(placed.iter().all(|p| model.register(p.register).name != "CANCKCON"));
    assert_eq!(placed.iter().map(|p| p.offset).collect::<Vec<_>>(), [0, 2, 2, 4, 6, 8]);
    let time = &model.joined[0];
    assert_eq!((time.width, time.order, time.cluster), (32, HalfOrder::LowFirst, None));
    let parts: Vec<_> =
        time.parts.iter().map(|p| (model.register(p.holder).name.as_str(), p.field, p.width, p.shift)).collect();
    assert_eq!(parts, [("TSL", None, 16, 0), ("TSH", None, 16, 16)]);
    let identifier = &model.joined[1];
    assert_eq!(identifier.ident.snake, "full_identifier");
    let parts: Vec<_> = identifier.parts.iter().map(|p| (p.lsb, p.width, p.shift)).collect();
    assert_eq!((parts, identifier.width), (vec![(0, 16, 0), (0, 2, 16), (5, 11, 18)], 29));
    assert_eq!(model.reserved[0].window, Some(WindowId(0)));
}

#[test]
fn enumerations_name_every_value() {
    let model = load("windows_and_halves");
    let mode = &model.enums[0];
    assert_eq!((mode.name.as_str(), mode.shared, mode.width, mode.is_total()), ("mode", true, 3, false));
    let names: Vec<_> = mode.variants.iter().map(|v| (v.name.as_str(), v.first, v.last)).collect();
    assert_eq!(names, [("normal", 0, 0), ("disable", 1, 1), ("loopback", 2, 3), ("configuration", 4, 4)]);
    assert_eq!(mode.reserved, [(5, 7)]);
    let numbers: Vec<_> = mode.variants.iter().map(|v| v.number).collect();
    assert_eq!(numbers, [None, None, Some(23), None]);
    assert_eq!(mode.variant(3).map(|v| v.name.as_str()), Some("loopback"));
    assert_eq!((mode.variant(5), mode.variant(1).unwrap().doc.as_str()), (None, "No part in the traffic."));
    assert_eq!(mode.used_by, [place(&model, "CTRL1.OPMODE"), place(&model, "CTRL1.REQOP")]);
    let run = &load("access_codes").enums[0];
    assert_eq!((run.name.as_str(), run.shared, run.is_total()), ("CTRL_RUN", false, true));
    let length = &load("messages").enums[0];
    assert_eq!((length.width, length.is_total()), (4, true), "two runs name all 16 values");
}

#[test]
fn totality_is_counted_without_overflow() {
    let mut entry = load("access_codes").enums[0].clone();
    entry.variants.truncate(1);
    assert!(!entry.is_total());
    (entry.variants[0].first, entry.variants[0].last, entry.width) = (0, u64::MAX, 64);
    assert!(entry.is_total());
    entry.variants[0].first = 1;
    assert!(!entry.is_total());
}

#[test]
fn aliases_stand_beside_registers() {
    let model = load("aliases");
    let aliases: Vec<_> = model.aliases.iter().map(|a| (a.name.as_str(), a.offset, a.op)).collect();
    assert_eq!(aliases, [("CLR", 4, AliasOp::Clear), ("SET", 8, AliasOp::Set), ("INV", 12, AliasOp::Invert)]);
    assert_eq!(model.registers.iter().map(|r| r.aliased).collect::<Vec<_>>(), [true, false]);
}

#[test]
fn like_copies_with_changed_names() {
    let model = load("like_and_replace");
    let copy = register(&model, "RXF1C");
    assert_eq!(copy.doc, "Configures Rx FIFO 1.");
    assert_eq!((copy.offset, copy.hazards.as_slice()), (Some(4), &["F1SA is a word address.".to_owned()][..]));
    assert_eq!(copy.unsafe_write.as_deref(), Some("F1SA leads the hardware into memory."));
    assert_eq!(copy.fields.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), ["F1SA", "F1OM"]);
    assert_eq!(field(&model, "RXF1C.F1SA").label, "F1SA[15:2]");
    assert_eq!(field(&model, "RXF1C.F1SA").doc, "Start of FIFO 1.");
    assert_eq!(notation(&model, "RXF1C.F1SA"), "rw:f1_empty");
    assert_eq!(field(&model, "RXF1C.F1OM").lsb, 30, "described anew");
    assert_eq!(field(&model, "RXF1C.F1OM").kind, Kind::Bool, "nothing is left of the field it replaces");
    let again = register(&model, "RXF2C");
    assert_eq!(again.doc, "Configures Rx FIFO 2.");
    assert_eq!(again.fields.len(), 3);
    assert_eq!((again.reset.value, register(&model, "RXF1S").reset.value), (0x8000_0000, 1));
    assert_eq!(field(&model, "RXF0C.F0OM").ident.snake, "f0_mode");
}
