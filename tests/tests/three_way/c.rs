//! What the C header says about each field, read out of an object file.

use std::collections::HashMap;
use std::fmt::Write as _;

use object::{Object, ObjectSection, ObjectSymbol};
use regdef::model::{Field, FieldRef, MessageId, Model, RegisterId, bit_mask};
use regdef_codegen::c::{BitField, Names, bit_fields, header};

use super::compiler::Compiler;

/// What both sides say about one lane of a field.
struct Expected {
    /// `REG.FIELD`, for messages.
    what: String,
    /// What its macros begin with, and the argument of a lane.
    stem: String,
    lane: String,
    /// Macros of the place and the reset; empty without them.
    offset: String,
    reset: Option<String>,
    numbers: [u32; 6],
    access: String,
}

/// Compares every field of every register and message, and gives their number.
pub fn compare(model: &Model, compiler: &Compiler) -> usize {
    let expected = expected(model);
    let views = if compiler.is_cpp() { Vec::new() } else { bit_fields(model) };
    let name = format!("{}.h", model.names.id);
    let source = source(model, &name, &expected, &views);
    let dir = tempfile::tempdir().expect("a folder for objects");
    let dialect = compiler.dialects[0];
    let object = compiler.compile(dir.path(), &[(&name, &header(model))], &source, dialect, &name);
    let data = constants(&object);
    for (index, field) in expected.iter().enumerate() {
        let says = format!("{} on {}", field.what, compiler.program);
        let bytes = data.get(&format!("field_{index}")).unwrap_or_else(|| panic!("{says}: no object"));
        let numbers: Vec<u32> = bytes
            .chunks_exact(4)
            .take(6)
            .map(|four| u32::from_le_bytes([four[0], four[1], four[2], four[3]]))
            .collect();
        assert_eq!(numbers, field.numbers, "{says}: offset, position, mask, width, reset, known bits of the reset");
        let bytes = data.get(&format!("access_{index}")).unwrap_or_else(|| panic!("{says}: no access"));
        let text: Vec<u8> = bytes.iter().copied().take_while(|byte| *byte != 0).collect();
        assert_eq!(String::from_utf8_lossy(&text), field.access, "{says}: access");
    }
    for (index, view) in views.iter().enumerate() {
        let bytes = data.get(&format!("view_{index}")).unwrap_or_else(|| panic!("{}: no object", view.member));
        let size = view.width as usize / 8;
        let value = bytes.iter().take(size).rev().fold(0, |value, byte| value << 8 | u64::from(*byte));
        assert_eq!(value, view.mask, "{}.{} on {}", view.view, view.member, compiler.program);
    }
    expected.len()
}

fn expected(model: &Model) -> Vec<Expected> {
    let names = Names::new(model);
    let mut all = Vec::new();
    for (index, register) in model.registers.iter().enumerate() {
        let id = RegisterId(index);
        let base = register.cluster.map_or(0, |cluster| model.clusters[cluster.0].offset);
        for (number, field) in register.fields.iter().enumerate() {
            let at = FieldRef { register: id, field: number };
            let stem = names.register(id);
            for lane in 0..field.lane_count() {
                let known = field.lane_mask(lane) & !register.reset.unknown;
                let one = Expected {
                    offset: register.offset.map_or_else(String::new, |_| format!("{stem}_OFFSET")),
                    reset: Some(stem.to_owned()),
                    ..lane_of(model, field, lane, names.field(at), &model.field_path(at))
                };
                let offset = register.offset.map_or(u32::MAX, |offset| narrow(base + offset));
                let reset = (register.reset.value & known) >> field.lane_lsb(lane);
                all.push(numbered(one, field, lane, [offset, narrow(reset), narrow(known)]));
            }
        }
    }
    for (index, message) in model.messages.iter().enumerate() {
        let id = MessageId(index);
        for (number, word) in message.words.iter().enumerate() {
            for (position, field) in word.fields.iter().enumerate() {
                for lane in 0..field.lane_count() {
                    let what = format!("{}.{}.{}", message.name, word.name, field.name);
                    let stem = names.word_field(id, number, position);
                    let offset = format!("{}_OFFSET", names.word(id, number));
                    let one = Expected { offset, ..lane_of(model, field, lane, stem, &what) };
                    all.push(numbered(one, field, lane, [narrow(word.offset), 0, 0]));
                }
            }
        }
    }
    all
}

fn lane_of(model: &Model, field: &Field, lane: u32, stem: &str, what: &str) -> Expected {
    Expected {
        what: what.to_owned(),
        stem: stem.to_owned(),
        lane: if field.lanes.is_some() { format!("({lane}U)") } else { String::new() },
        offset: String::new(),
        reset: None,
        numbers: [0; 6],
        access: field.access.notation(|id| model.condition(id).name.clone()),
    }
}

fn numbered(one: Expected, field: &Field, lane: u32, [offset, reset, known]: [u32; 3]) -> Expected {
    // The bits are computed here from the position and the width, and not by the model's own mask.
    let lsb = field.lsb + lane * field.lanes.map_or(0, |lanes| lanes.stride);
    let mask = narrow(bit_mask(0, field.width) << lsb);
    Expected { numbers: [offset, lsb, mask, field.width, reset, known], ..one }
}

fn narrow(value: u64) -> u32 {
    u32::try_from(value).expect("registers and offsets of these controllers fit 32 bits")
}

fn source(model: &Model, header: &str, expected: &[Expected], views: &[BitField]) -> String {
    let mut text = String::new();
    let mut line = |one: String| writeln!(text, "{one}").expect("a string takes any text");
    line(format!("#define {}_MICROCHIP_NAMES", model.names.ident.upper));
    line(format!("#include \"{header}\""));
    line("#ifdef __cplusplus\nextern \"C\" {\n#endif".to_owned());
    for (index, Expected { stem, lane, offset, reset, .. }) in expected.iter().enumerate() {
        let offset = if offset.is_empty() { "UINT32_C(0xFFFFFFFF)" } else { offset };
        let (mask, position) = (format!("{stem}_Msk{lane}"), format!("{stem}_Pos{lane}"));
        let (reset, known) = match reset {
            Some(of) => (format!("({of}_RESET & {mask}) >> {position}"), format!("{of}_RESET_MASK & {mask}")),
            None => ("0U".to_owned(), "0U".to_owned()),
        };
        line(format!("extern const uint32_t field_{index}[6];"));
        line(format!(
            "const uint32_t field_{index}[6] = {{{offset}, {position}, {mask}, {stem}_Width, {reset}, {known}}};"
        ));
        line(format!("extern const char access_{index}[];"));
        line(format!("const char access_{index}[] = {stem}_Access;"));
    }
    for (index, view) in views.iter().enumerate() {
        let BitField { view, member, mask, .. } = view;
        let ones = mask >> mask.trailing_zeros();
        line(format!("extern const {view} view_{index};"));
        line(format!("const {view} view_{index} = {{.{member} = UINT32_C({ones})}};"));
    }
    line("#ifdef __cplusplus\n}\n#endif".to_owned());
    text
}

/// The bytes behind every symbol, to the end of its section.
fn constants(object: &[u8]) -> HashMap<String, Vec<u8>> {
    let file = object::File::parse(object).expect("an object file");
    let mut found = HashMap::new();
    for symbol in file.symbols() {
        let (Ok(name), Some(section)) = (symbol.name(), symbol.section_index()) else { continue };
        let Ok(section) = file.section_by_index(section) else { continue };
        // What is all zeros may stand in a section without bytes.
        let data = match section.data() {
            Ok(data) if !data.is_empty() => data.to_vec(),
            _ => vec![0; usize::try_from(section.size()).unwrap_or(0)],
        };
        let start = usize::try_from(symbol.address()).unwrap_or(usize::MAX);
        if let Some(bytes) = data.get(start..) {
            let length = usize::try_from(symbol.size()).unwrap_or(0).min(bytes.len());
            found.insert(name.to_owned(), bytes[..length].to_vec());
        }
    }
    found
}
