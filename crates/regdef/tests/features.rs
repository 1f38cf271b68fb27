//! What the model says of valid descriptions, one for each part of the language, in `tests/features`.

#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

use annotate_snippets::Renderer;
use regdef::diagnostic::report;
use regdef::load_file;
use regdef::model::*;

fn load(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features").join(name).with_extension("yaml");
    let loaded = load_file(&path);
    assert!(loaded.findings.is_empty(), "{}", report(&loaded.findings, &loaded.source, &Renderer::plain()));
    loaded.model.unwrap()
}

fn register<'a>(model: &'a Model, name: &str) -> &'a Register {
    model.registers.iter().find(|r| r.name == name).unwrap()
}

fn field<'a>(model: &'a Model, path: &str) -> &'a Field {
    let (holder, name) = path.split_once('.').unwrap();
    register(model, holder).field(name).unwrap()
}

fn place(model: &Model, path: &str) -> FieldRef {
    let (holder, name) = path.split_once('.').unwrap();
    let register = model.registers.iter().position(|r| r.name == holder).unwrap();
    FieldRef {
        register: RegisterId(register),
        field: model.registers[register].fields.iter().position(|f| f.name == name).unwrap(),
    }
}

fn notation(model: &Model, path: &str) -> String {
    field(model, path).access.notation(|id| model.condition(id).name.clone())
}

fn shown(model: &Model, condition: Option<ConditionId>) -> String {
    model.condition(condition.unwrap()).expr.display(model)
}

#[test]
fn every_feature_loads_without_a_finding() {
    let mut count = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let model = load(&name);
        assert_eq!(format!("{}.yaml", model.names.id), name);
        count += 1;
    }
    assert!(count >= 10, "only {count} descriptions");
}

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

#[test]
fn conditions_of_every_form() {
    let model = load("conditions");
    let when = |path: &str| shown(&model, field(&model, path).access.when);
    assert_eq!(when("CTRL.TEST"), "CTRL.INIT && CTRL.CCE");
    assert_eq!(when("CTRL.MODE"), "(CTRL.INIT && CTRL.CCE) && CTRL.TEST");
    assert_eq!(
        when("CTRL.LEVEL"),
        "(CTRL.INIT && CTRL.CCE) || (!(CTRL.MODE == loopback || CTRL.MODE != normal) && CTRL.LEVEL < 16)"
    );
    assert_eq!(when("CTRL.A"), "CTRL.LEVEL > 3 && CTRL.LEVEL <= 5 && CTRL.LEVEL >= 4");
    assert_eq!(field(&model, "CTRL.A").access.when, field(&model, "CTRL.B").access.when, "said twice, kept once");
    assert_eq!(when("CTRL.C"), "!!CTRL.INIT");
    assert_eq!(when("CTRL.D"), "CTRL.LEVEL != 0");
    assert_eq!(when("CTRL.E"), "!CTRL.INIT");
    assert_eq!(when("CTRL.F"), "CTRL.LANE[2]");
    assert_eq!(when("CTRL.LANE"), "!CTRL.LANE[n] || CTRL.INIT");
    assert_eq!(shown(&model, field(&model, "CTRL.CCE").access.set_when), "CTRL.INIT");
    let config = &model.conditions[0];
    assert_eq!((config.name.as_str(), config.named, config.doc.as_str()), ("config", true, "Configuration."));
    assert_eq!(config.expr.fields(), [place(&model, "CTRL.INIT"), place(&model, "CTRL.CCE")]);
    assert_eq!(Expr::Always.display(&model), "always");
    let index = |path: &str| match &model.condition(field(&model, path).access.when.unwrap()).expr {
        Expr::Compare { index, comparison, value, .. } => (*index, *comparison, *value),
        other => panic!("{other:?}"),
    };
    assert_eq!(index("CTRL.F"), (LaneIndex::Fixed(2), Comparison::Equal, 1));
    assert_eq!(index("CTRL.D"), (LaneIndex::Single, Comparison::NotEqual, 0));
    let arrays = load("arrays_and_lanes");
    assert_eq!(shown(&arrays, field(&arrays, "FIFOCON.FRESET").access.when), "FIFOSTA.EMPTY[n]");
    assert_eq!(shown(&arrays, field(&arrays, "FLTCON.FBP").access.when), "!FLTCON.FLTEN[n]");
    assert_eq!(
        shown(&arrays, field(&arrays, "MASK.BITS_LOW").access.when),
        "!FLTCON.FLTEN[11]",
        "of the third register"
    );
}

#[test]
fn effects_name_registers_and_fields() {
    let model = load("conditions");
    let effect = &model.effects[0];
    assert_eq!(model.condition(effect.on).name, "config");
    assert_eq!(effect.resets.iter().map(|id| model.register(*id).name.as_str()).collect::<Vec<_>>(), ["STAT"]);
    assert_eq!(effect.resets_fields, [place(&model, "CTRL.LEVEL")]);
    assert_eq!(effect.loads, [(place(&model, "STAT.COPY"), place(&model, "CTRL.LEVEL"))]);
    assert_eq!((effect.sets.as_slice(), effect.holds), (&[(place(&model, "CTRL.MODE"), 1)][..], true));
    assert!(!model.effects[1].holds);
}

#[test]
fn interrupts_of_groups_and_trees() {
    let model = load("interrupts");
    let interrupts = &model.interrupts;
    let names: Vec<_> = interrupts.sources.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["RF0N", "TC", "RB", "reserved_access", "fifo", "overflow"]);
    let path = |at: Option<FieldRef>| at.map(|at| model.field_path(at));
    let sent = &interrupts.sources[1];
    assert_eq!(path(sent.enable).as_deref(), Some("IE.TCE"));
    assert_eq!(path(sent.select).as_deref(), Some("ILS.TCL"));
    assert_eq!((sent.lines.as_slice(), sent.doc.as_str()), (&[LineId(0), LineId(1)][..], "Sent."));
    let any = &interrupts.sources[2];
    assert_eq!((path(Some(any.flag)).as_deref(), any.enable, any.lines.len()), (Some("INTF.RBIF"), None, 1));
    let access = &interrupts.sources[3];
    assert_eq!((access.cleared_by.as_str(), access.cites[0].section.as_deref()), ("Writing 1.", Some("7.9")));
    let fifo = &interrupts.sources[4];
    assert_eq!((fifo.feeds.as_slice(), fifo.code), (&[InterruptId(2), InterruptId(5)][..], Some((64, 64))));
    assert_eq!(interrupts.sources[5].code, Some((0x41, 0x4f)), "a run of codes");
    let line = &interrupts.lines[1];
    assert_eq!((line.name.as_str(), path(line.enable).as_deref(), line.select), ("int1", Some("ILS.EINT1"), Some(1)));
}

#[test]
fn messages_share_and_override_words() {
    let model = load("messages");
    let [tx, rx, event] = &model.messages[..] else { panic!("three messages") };
    let words =
        |message: &Message| message.words.iter().map(|w| (w.name.clone(), w.offset, w.same_as)).collect::<Vec<_>>();
    assert_eq!(words(tx), [("T0".to_owned(), 0, None), ("T1".to_owned(), 4, None)]);
    assert_eq!(words(rx)[0], ("T0".to_owned(), 0, Some((MessageId(0), 0))));
    assert_eq!(words(rx)[1], ("T1".to_owned(), 4, None), "has a field of its own");
    assert_eq!(words(rx).len(), 5);
    let fields: Vec<_> = rx.words[1].fields.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(fields, ["MM", "TS", "DLC"]);
    let marker = &rx.words[1].fields[0];
    assert_eq!((marker.label.as_str(), shown(&model, marker.access.when)), ("MM[7:0]", "RXF0C.EN".to_owned()));
    assert_eq!(rx.words[1].fields[2].access.when, None, "the rule of one field is not another's");
    assert_eq!(rx.words[1].fields[2].kind, Kind::Int);
    assert_eq!(tx.words[1].fields[0].access.must_write, Some(8));
    let either = &rx.words[2];
    assert_eq!((shown(&model, either.present_when), either.doc.as_str()), ("T0.XTD".to_owned(), "Either."));
    assert_eq!(shown(&model, rx.words[3].present_when), "!T0.XTD");
    assert_eq!(shown(&model, either.fields[0].access.when), "RXF0C.EN");
    assert_eq!((tx.header_bytes, tx.element_bytes(8), tx.element_bytes(64)), (8, 16, 72));
    assert_eq!((rx.header_bytes, rx.element_bytes(8)), (12, 24), "a word follows the payload");
    assert_eq!((event.word_width, event.element_bytes(64)), (16, 4), "no payload");
    let payload = tx.payload.as_ref().unwrap();
    assert_eq!((payload.offset, payload.sizes.as_slice(), payload.byte_label.as_str()), (8, &[8, 12, 64][..], "DB{n}"));
    assert_eq!(rx.payload.as_ref().unwrap().byte_label, "byte {n}");
}

#[test]
fn joined_values_of_messages_follow_the_words() {
    let model = load("messages");
    let parts = |message: &Message| {
        let part = |p: &Part<usize>| (message.words[p.holder].fields[p.field.unwrap()].name.clone(), p.width, p.shift);
        message.joined[0].parts.iter().map(part).collect::<Vec<_>>()
    };
    let expected = [("DLC".to_owned(), 4, 0), ("ID".to_owned(), 29, 4)];
    assert_eq!(parts(&model.messages[0]), expected);
    assert_eq!(parts(&model.messages[1]), expected, "although `DLC` is the third field here");
    let all = &model.messages[2].joined[0];
    assert_eq!((all.ident.snake.as_str(), all.width, all.parts[1].field), ("everything", 32, None));
}

#[test]
fn sections_say_where_messages_lie() {
    let model = load("messages");
    let [fifo, events, rest] = &model.memory.sections[..] else { panic!("three sections") };
    assert_eq!((model.memory.limit, fifo.max, fifo.elements.as_slice()), (Some(4352), Some(64), &[MessageId(1)][..]));
    assert_eq!((fifo.count[0], fifo.payload_size.unwrap()), (place(&model, "RXF0C.F0S"), place(&model, "RXF0C.SIZE")));
    assert_eq!(shown(&model, fifo.exists_when), "RXF0C.EN");
    match &fifo.start {
        SectionStart::At { parts, unit } => assert_eq!((parts[0].lsb, parts[0].width, *unit), (2, 14, 4)),
        SectionStart::Follows => panic!("it has a start"),
    }
    match &events.start {
        SectionStart::At { parts, unit } => assert_eq!((parts.len(), *unit), (2, 1)),
        SectionStart::Follows => panic!("it has a start"),
    }
    assert!(matches!(rest.start, SectionStart::Follows));
    assert_eq!(events.elements, [MessageId(2), MessageId(0)]);
}

#[test]
fn bit_timing_chips_conflicts_and_choices() {
    let model = load("bit_timing_and_chips");
    let timing = model.bit_timing.as_ref().unwrap();
    assert_eq!((timing.clock.name.as_str(), timing.clock.divider, timing.clock.max_hz), ("cclk", 2, Some(80_000_000)));
    let nominal = &timing.nominal;
    assert_eq!((nominal.prescaler, nominal.propagation), (place(&model, "NBTP.NBRP"), None));
    assert_eq!((nominal.min_quanta, nominal.max_quanta, nominal.max_bit_rate), (4, 385, Some(1_000_000)));
    assert_eq!(timing.data.as_ref().unwrap().propagation, Some(place(&model, "NBTP.NTSEG1")));
    let delay = timing.transmitter_delay.as_ref().unwrap();
    assert_eq!((delay.enable, delay.value), (place(&model, "TDCR.TDC"), Some(place(&model, "TDCR.TDCV"))));
    let offset = field(&model, "TDCR.TDCO").encoding.clone().unwrap();
    assert_eq!((offset.signed, offset.add, offset.times), (true, -1, None));
    let chip = &model.instances[0];
    assert_eq!(
        (chip.base, chip.memory, chip.interrupts[1].clone()),
        (0x4000_a400, Some(0x4000_ac00), ("int1".to_owned(), 22))
    );
    assert_eq!(chip.cites[0].source.as_deref(), Some("header"));
    let conflict = &model.conflicts[0];
    assert_eq!(conflict.at, [Target::Register(RegisterId(0)), Target::Field(place(&model, "NBTP.NTSEG1"))]);
    assert_eq!((conflict.says.len(), conflict.says[1].cite.table.as_deref()), (2, Some("60")));
    assert_eq!((model.choices[0].alternatives.len(), model.choices[1].at.len()), (1, 0));
    let cites = &register(&model, "NBTP").cites;
    assert_eq!((cites[0].page, cites[1].subject.as_deref()), (Some(20), Some("offset")));
}

#[test]
fn yaml_may_be_written_in_any_style() {
    let model = load("unusual_yaml");
    assert_eq!(model.title, "Unusual YAML, folded over lines");
    assert_eq!(model.doc, "A literal block: with \"quotes\", # no comment,\n  and indentation.\n");
    assert_eq!((model.span, model.access_widths.as_slice()), (4, &[32][..]));
    assert_eq!(model.manual.publisher, "It's nobody");
    assert_eq!(register(&model, "CTRL").title, "Title");
    assert_eq!(register(&model, "CTRL").doc, "plain text that goes on");
    assert_eq!(field(&model, "CTRL.RUN").doc, "宽字符 and 🙂 are text.");
}

#[test]
fn targets_are_of_every_kind() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features/messages.yaml")).unwrap();
    let targets = "RXF0C, RXF0C.EN, address, length, TX, TX.T1, TX.T1.MM";
    let conflict = format!(
        "conflicts:\n  - {{id: all, at: [{targets}], what: w, says: [{{cite: {{section: '1'}}, says: a}}], taken: a, because: b}}\n"
    );
    let loaded = regdef::load_str("messages.yaml", &(text + &conflict));
    let model = loaded.model.unwrap();
    let (tx, first) = (MessageId(0), RegisterId(0));
    let expected = [
        Target::Register(first),
        Target::Field(FieldRef { register: first, field: 3 }),
        Target::Joined(0),
        Target::Enum(EnumId(0)),
        Target::Message(tx),
        Target::Word(tx, 1),
        Target::WordField(tx, 1, 1),
    ];
    assert_eq!(model.conflicts[0].at, expected);
}

#[test]
fn the_schema_accepts_what_loads() {
    let schema = regdef::schema();
    let validator = jsonschema::validator_for(&schema).unwrap();
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/features")).unwrap() {
        let path = entry.unwrap().path();
        let tree: serde_json::Value = serde_yaml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        assert!(validator.is_valid(&tree), "{}", path.display());
    }
}
