//! Conditions, effects, interrupts, messages, bit timing.

use regdef::model::*;

use crate::{field, load, place, register, shown};

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
