//! A description far larger than any CAN controller: 2,000 registers of 10 fields, as text.

use std::fmt::Write as _;

/// Registers of the description.
pub const REGISTERS: usize = 2000;

/// Fields of each register: stored bits, numbers, shared enumerations, a flag that is cleared by 1.
const FIELDS: [&str; 10] = [
    "ENABLE: {bits: 0, access: rw, doc: Enables the function.}",
    "MODE: {bits: \"3:1\", access: rw, enum: mode, doc: Mode of operation.}",
    "LEVEL: {bits: \"7:4\", access: rw, range: {min: 1, max: 14}, doc: Level of the threshold.}",
    "COUNT: {bits: \"15:8\", access: rw, encoding: {add: 1, unit: cycles}, doc: Number of cycles.}",
    "SPEED: {bits: \"17:16\", access: rw, enum: speed, doc: Speed of the clock.}",
    "INVERT: {bits: 18, access: rw, doc: Inverts the output.}",
    "BUSY: {bits: 19, access: ro, doc: The function is at work.}",
    "DONE: {bits: 20, access: w1c, doc: The function is done.}",
    "INDEX: {bits: \"25:21\", access: ro, doc: Where it stands.}",
    "TAG: {bits: \"31:26\", access: rw, doc: Comes back in the answer.}",
];

/// The text.
pub fn yaml() -> String {
    let mut out = format!(
        "controller: synthetic\ntitle: Synthetic block of registers\n\
         manual: {{title: Synthetic Manual, publisher: canpac, revision: \"1\", date: \"2026-01-01\"}}\n\
         register_width: 32\naccess_widths: [32]\nspan: {span:#x}\n\
         enums:\n\
         \x20 mode:\n    doc: Modes.\n    cite: {{section: \"1\", page: 1}}\n    values: {{0: off, 1: listen, 2: talk, 3: both, 7: test}}\n\
         \x20 speed:\n    doc: Speeds.\n    cite: {{section: \"1\", page: 1}}\n    values: {{0: slow, 1: medium, 2: fast, 3: fastest}}\n\
         registers:\n",
        span = REGISTERS * 4
    );
    for number in 0..REGISTERS {
        let offset = number * 4;
        let page = number / 4 + 1;
        let _ = write!(
            out,
            "  REG{number}:\n    title: Register {number}\n    offset: {offset:#x}\n    doc: Controls function {number}.\n    \
             cite: {{section: \"2.{number}\", page: {page}}}\n    reset: 0x10\n    fields:\n"
        );
        for field in FIELDS {
            let _ = writeln!(out, "      {field}");
        }
    }
    out
}
