//! The rows of the field table.

use regdef::model::{Dim, Enum, Field, FieldReset, Kind, Message, Model, Payload, Register, Reset, ResetKind};

use crate::text;

/// One field, or one lane of a field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// The register's name without the controller's prefix; `MSG:` in front of the words of messages.
    pub register: String,
    /// Repetition of the register.
    pub array: Option<Repeat>,
    /// Byte offset of the first element; none for a register of the device.
    pub offset: Option<u64>,
    /// Width of the register in bits.
    pub width: u32,
    /// The field's name in the manual's spelling.
    pub field: String,
    /// Most significant bit.
    pub msb: u32,
    /// Least significant bit.
    pub lsb: u32,
    /// Access code with modifiers and conditions.
    pub access: String,
    /// Value after reset.
    pub reset: RowReset,
    /// Named and reserved values in ascending order.
    pub values: Vec<RowValue>,
    /// Where it stands.
    pub source: String,
}

/// Repetition of a register.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Repeat {
    /// Number of elements.
    pub count: u32,
    /// Distance in bytes.
    pub stride: u64,
    /// The manual's number of the first element.
    pub first: u32,
}

/// Value of a field after reset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowReset {
    /// A number.
    Value(u64),
    /// None to be relied on.
    None(ResetKind),
}

/// A named value or run of values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowValue {
    /// First value.
    pub first: u64,
    /// Last value.
    pub last: u64,
    /// Its name, or `reserved`.
    pub name: String,
}

impl From<&Dim> for Repeat {
    fn from(dim: &Dim) -> Self {
        Self { count: dim.count, stride: dim.stride, first: dim.first }
    }
}

/// Where the rows of one register or one element of an array stand.
struct Place {
    register: String,
    array: Option<Repeat>,
    offset: Option<u64>,
    width: u32,
    /// Position in the array whose lanes run on.
    position: u32,
    reset: Reset,
}

/// All rows: the registers in the order of the description, then the words of the messages.
#[must_use]
pub fn rows(model: &Model) -> Vec<Row> {
    let mut rows = Vec::new();
    for register in &model.registers {
        for place in places(model, register) {
            for field in &register.fields {
                push(model, &mut rows, &place, field);
            }
        }
    }
    for message in &model.messages {
        message_rows(model, &mut rows, message);
    }
    rows
}

/// One place for the whole array, or one for each element where names change from element to element.
fn places(model: &Model, register: &Register) -> Vec<Place> {
    let cluster = register.cluster.map(|id| &model.clusters[id.0]);
    let offset = register.offset.map(|offset| offset + cluster.map_or(0, |cluster| cluster.offset));
    let place = |register_name: String, array: Option<Repeat>, offset: Option<u64>, position: u32| Place {
        register: register_name,
        array,
        offset,
        width: register.width,
        position,
        reset: register.reset,
    };
    let elements = |dim: &Dim, array: Option<&Dim>| -> Vec<Place> {
        (0..dim.count)
            .map(|n| {
                let at = offset.map(|offset| offset + dim.stride * u64::from(n));
                place(register.label_of(dim, n), array.map(Repeat::from), at, n)
            })
            .collect()
    };
    match (&register.dim, cluster) {
        (Some(dim), Some(cluster)) => elements(dim, Some(&cluster.dim)),
        (Some(dim), None) | (None, Some(regdef::model::Cluster { dim, .. })) if register.lanes_run_on() => {
            elements(dim, None)
        }
        (Some(dim), None) | (None, Some(regdef::model::Cluster { dim, .. })) => {
            vec![place(register.name.clone(), Some(dim.into()), offset, 0)]
        }
        (None, None) => vec![place(register.name.clone(), None, offset, 0)],
    }
}

fn push(model: &Model, rows: &mut Vec<Row>, place: &Place, field: &Field) {
    for lane in 0..field.lane_count() {
        let lsb = field.lane_lsb(lane);
        let reset = match field.reset {
            FieldReset::None(kind) => RowReset::None(kind),
            FieldReset::Value(_) => {
                field.reset_of_lane(place.reset, lane).map_or(RowReset::None(ResetKind::Unknown), RowReset::Value)
            }
        };
        rows.push(Row {
            register: place.register.clone(),
            array: place.array,
            offset: place.offset,
            width: place.width,
            field: field.label_of(place.position, lane),
            msb: lsb + field.width - 1,
            lsb,
            access: text::notation(model, field),
            reset,
            values: values(model, field),
            source: text::cites(&field.cites),
        });
    }
}

fn values(model: &Model, field: &Field) -> Vec<RowValue> {
    let Kind::Enum(id) = field.kind else { return Vec::new() };
    values_of(model.enumeration(id), field.capacity())
}

/// The values of an enumeration that fit into a field whose largest value is `capacity`.
fn values_of(of: &Enum, capacity: u64) -> Vec<RowValue> {
    let named = of.variants.iter().map(|v| (v.first, v.last, v.name.as_str()));
    let reserved = of.reserved.iter().map(|&(first, last)| (first, last, "reserved"));
    let mut values: Vec<RowValue> = named
        .chain(reserved)
        .filter(|&(first, ..)| first <= capacity)
        .map(|(first, last, name)| RowValue { first, last: last.min(capacity), name: name.to_owned() })
        .collect();
    values.sort_by_key(|value| value.first);
    values
}

fn message_rows(model: &Model, rows: &mut Vec<Row>, message: &Message) {
    let unknown = Reset { value: 0, unknown: u64::MAX };
    for word in &message.words {
        let place = Place {
            register: format!("MSG:{}.{}", message.name, word.name),
            array: None,
            offset: Some(word.offset),
            width: message.word_width,
            position: 0,
            reset: unknown,
        };
        for field in &word.fields {
            push(model, rows, &place, field);
        }
    }
    if let Some(payload) = &message.payload {
        payload_rows(rows, message, payload);
    }
}

/// The words of the largest payload, each with its bytes; byte 0 is the least significant one.
fn payload_rows(rows: &mut Vec<Row>, message: &Message, payload: &Payload) {
    let bytes_per_word = message.word_width / 8;
    let largest = payload.sizes.iter().copied().max().unwrap_or(0);
    for word in 0..largest.div_ceil(bytes_per_word) {
        for byte in (0..bytes_per_word).filter(|byte| word * bytes_per_word + byte < largest) {
            let number = |label: &str, n: u32| match label.contains("{n}") {
                true => label.replace("{n}", &n.to_string()),
                false => format!("{label}{n}"),
            };
            rows.push(Row {
                register: format!("MSG:{}.{}", message.name, number(&payload.word_label, payload.first_word + word)),
                array: None,
                offset: Some(payload.offset + u64::from(word * bytes_per_word)),
                width: message.word_width,
                field: number(&payload.byte_label, word * bytes_per_word + byte),
                msb: byte * 8 + 7,
                lsb: byte * 8,
                access: "rw".to_owned(),
                reset: RowReset::None(ResetKind::Unknown),
                values: Vec::new(),
                source: text::cites(&payload.cites),
            });
        }
    }
}
