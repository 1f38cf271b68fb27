//! What `diff` says about every kind of change.

use regdef::diff::diff;

const BASE: &str = r#"
controller: demo
title: Demonstration
manual: {title: Demo Manual, publisher: Nobody, revision: "1", date: "2026-01-01"}
register_width: 32
access_widths: [32]
span: 0x40
conditions:
  config: {expression: CTRL.INIT, doc: Initialization.}
enums:
  mode: {0: normal, 1: silent, "2..3": reserved}
registers:
  CTRL:
    title: Control
    offset: 0x00
    cite: {section: "1"}
    doc: Control.
    reset: 0x0000_0001
    fields:
      INIT: {bits: 0, access: rw, doc: Initialization.}
      MODE: {bits: "5:4", access: rw, when: config, enum: mode, doc: Mode.}
      LIMIT: {bits: "15:8", access: rw, range: {min: 1, max: 200}, encoding: {add: 1, unit: tq}, doc: Limit.}
  FLAGS:
    title: Flags
    offset: 0x04
    cite: {section: "2"}
    doc: Flags.
    reset: 0
    fields:
      RX: {bits: 0, access: w1c, doc: Received.}
  LIST:
    title: List
    offset: 0x10
    array: {count: 4, stride: 4}
    cite: {section: "3"}
    doc: List.
    access: rw
    fields:
      ITEM: {bits: "7:0", reset: unknown, doc: Item.}
reserved:
  - {from: 0x08, to: 0x0F, reads: 0, cite: {section: "4"}}
  - {from: 0x20, to: 0x3F, reads: 0, cite: {section: "4"}}
messages:
  FRAME:
    title: Frame
    word: 32
    cite: {section: "5"}
    words:
      W0:
        offset: 0
        fields:
          ID: {bits: "10:0", doc: Identifier.}
    payload: {offset: 4, sizes: [8], word_label: "W{n}", first_word: 1}
interrupts:
  doc: One line.
  lines: {int: {doc: The line.}}
  sources:
    RX: {flag: FLAGS.RX, lines: [int], code: 3}
"#;

/// The changes after replacing text in the base.
fn changes(edits: &[(&str, &str)]) -> String {
    let mut text = BASE.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "the base has no `{from}`");
        text = text.replace(from, to);
    }
    let load = |name: &str, text: &str| {
        let loaded = regdef::load_str(name, text);
        loaded.model.unwrap_or_else(|| panic!("{:#?}", loaded.findings))
    };
    diff(&load("old.yaml", BASE), &load("new.yaml", &text)).iter().map(ToString::to_string).collect()
}

#[test]
fn nothing() {
    assert_eq!(changes(&[]), "");
    assert_eq!(changes(&[("doc: Control.", "doc: Controls."), ("section: \"1\"", "section: \"9\"")]), "");
}

#[test]
fn fields() {
    assert_eq!(
        changes(&[("MODE: {bits: \"5:4\"", "MODE: {bits: \"7:6\"")]),
        "register `CTRL`\n  ~ field `MODE`, moved: bits 5:4 → bits 7:6\n"
    );
    assert_eq!(
        changes(&[("INIT: {bits: 0, access: rw", "INIT: {bits: 0, access: rwh")]),
        "register `CTRL`\n  ~ field `INIT`, access: `rw` → `rwh`\n"
    );
    assert_eq!(
        changes(&[("access: rw, when: config,", "access: rw, set_when: config,")]),
        "register `CTRL`\n  ~ field `MODE`, access: `rw:config` → `rw+s:config`\n"
    );
    assert_eq!(
        changes(&[("RX: {bits: 0, access: w1c", "RXF: {bits: 0, access: w1c"), ("FLAGS.RX", "FLAGS.RXF")]),
        "register `FLAGS`\n  ~ field `RXF`, renamed: `RX` → `RXF`\ninterrupt source `RX`\n  \
         ~ flag FLAGS.RX, enable nothing, select nothing, lines int, feeds none, code 3 → \
         flag FLAGS.RXF, enable nothing, select nothing, lines int, feeds none, code 3\n"
    );
    assert_eq!(
        changes(&[("      RX: {bits: 0,", "      TX: {bits: 1, access: w1c, doc: Sent.}\n      RX: {bits: 0,")]),
        "register `FLAGS`\n  + field `TX`, bit 1, `w1c`, reset 0x0\n"
    );
    assert_eq!(
        changes(&[("max: 200", "max: 100"), ("add: 1", "add: 2")]),
        "register `CTRL`\n  ~ field `LIMIT`, limits: 1..=200 → 1..=100\n  \
         ~ field `LIMIT`, meaning: (value + 1) × 1 tq → (value + 2) × 1 tq\n"
    );
}

#[test]
fn registers() {
    assert_eq!(
        changes(&[("reset: 0x0000_0001", "reset: 0x0000_0011")]),
        "register `CTRL`\n  ~ reset: 0x00000001 → 0x00000011\n  ~ field `MODE`, reset: 0x0 → 0x1\n"
    );
    assert_eq!(
        changes(&[("count: 4, stride: 4", "count: 3, stride: 4"), ("from: 0x20", "from: 0x1C")]),
        "register `LIST`\n  ~ array: 4 elements 0x4 apart, numbered from 0 → 3 elements 0x4 apart, numbered from 0\n\
         reserved range `0x01c..=0x03f`\n  ~ renamed: `0x020..=0x03f` → `0x01c..=0x03f`\n"
    );
    assert_eq!(changes(&[("  LIST:\n", "  TABLE:\n")]), "register `TABLE`\n  ~ renamed: `LIST` → `TABLE`\n");
    assert_eq!(
        changes(&[("offset: 0x04", "offset: 0x08"), ("from: 0x08, to: 0x0F", "from: 0x0C, to: 0x0F")]).lines().nth(1),
        Some("  ~ moved: at 0x004 → at 0x008")
    );
    assert_eq!(
        changes(&[("reset: unknown", "reset: 5")]),
        "register `LIST`\n  ~ reset: 0x00000000 (unknown 0x000000ff) → 0x00000005\n  ~ field `ITEM`, reset: unknown → 0x5\n"
    );
}

#[test]
fn values_messages_and_conditions() {
    assert_eq!(
        changes(&[("1: silent, \"2..3\": reserved", "1: quiet, 2: loop_back, 3: reserved")]),
        "enumeration `mode`\n  ~ value 1: `silent` → `quiet`\n  + value 2: `loop_back`\n  + value 3: reserved\n  \
         - value 2..3: reserved\n"
    );
    assert_eq!(
        changes(&[("sizes: [8]", "sizes: [8, 12]"), ("bits: \"10:0\"", "bits: \"28:0\"")]),
        "message `FRAME`\n  ~ payload: at byte 0x4, sizes [8] → at byte 0x4, sizes [8, 12]\nword `FRAME.W0`\n  \
         ~ field `ID`, moved: bits 10:0 → bits 28:0\n  ~ field `ID`, limits: 0..=2047 → 0..=536870911\n"
    );
    assert_eq!(
        changes(&[("expression: CTRL.INIT", "expression: \"!CTRL.INIT\"")]),
        "condition `config`\n  ~ CTRL.INIT → !CTRL.INIT\n"
    );
}
