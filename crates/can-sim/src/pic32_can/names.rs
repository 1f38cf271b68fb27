//! The registers and fields that the model works with, by their names in the description.

use crate::registers::{FieldAt, RegisterFile, Slot};

/// A register by what it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    Con,
    Int,
    Tmr,
    Mask(u8),
    FilterControl(u8),
    Filter(u8),
    FifoBase,
    FifoControl(u8),
    FifoInterrupt(u8),
    FifoUser(u8),
    FifoIndex(u8),
    /// One that needs nothing beyond what the description says.
    Plain,
}

/// Registers.
#[derive(Clone, Debug)]
pub(super) struct Slots {
    pub(super) con: Slot,
    pub(super) cfg: Slot,
    pub(super) int: Slot,
    pub(super) vec: Slot,
    pub(super) trec: Slot,
    pub(super) fstat: Slot,
    pub(super) rxovf: Slot,
    pub(super) tmr: Slot,
    pub(super) masks: [Slot; 4],
    pub(super) filter_control: [Slot; 8],
    pub(super) filters: [Slot; 32],
    pub(super) fifo_base: Slot,
    pub(super) fifo_control: [Slot; 32],
    pub(super) fifo_interrupt: [Slot; 32],
    pub(super) fifo_user: [Slot; 32],
    pub(super) fifo_index: [Slot; 32],
    named: Vec<Named>,
}

impl Slots {
    pub(super) fn named(&self, slot: Slot) -> Named {
        self.named[slot.0 as usize]
    }
}

/// Fields that hardware changes.
#[derive(Clone, Debug)]
pub(super) struct Fields {
    pub(super) reqop: FieldAt,
    pub(super) opmod: FieldAt,
    pub(super) dncnt: FieldAt,
    pub(super) canbusy: FieldAt,
    pub(super) abat: FieldAt,
    pub(super) filhit: FieldAt,
    pub(super) icod: FieldAt,
    pub(super) tec: FieldAt,
    pub(super) rec: FieldAt,
    pub(super) cants: FieldAt,
    pub(super) seg2ph: FieldAt,
}

/// Looks the names up once.
pub(super) fn look_up(file: &RegisterFile) -> (Slots, Fields) {
    let missing = |name: &str| -> ! { panic!("the description has no {name}") };
    let one = |name: &str| file.find(name, 0, 0).unwrap_or_else(|| missing(name));
    let element = |name: &str, n: usize| file.find(name, n as u32, 0).unwrap_or_else(|| missing(name));
    let inner = |name: &str, n: usize| file.find(name, 0, n as u32).unwrap_or_else(|| missing(name));
    let mut slots = Slots {
        con: one("CON"),
        cfg: one("CFG"),
        int: one("INT"),
        vec: one("VEC"),
        trec: one("TREC"),
        fstat: one("FSTAT"),
        rxovf: one("RXOVF"),
        tmr: one("TMR"),
        masks: core::array::from_fn(|n| inner("RXM", n)),
        filter_control: core::array::from_fn(|n| inner("FLTCON", n)),
        filters: core::array::from_fn(|n| inner("RXF", n)),
        fifo_base: one("FIFOBA"),
        fifo_control: core::array::from_fn(|n| element("FIFOCON", n)),
        fifo_interrupt: core::array::from_fn(|n| element("FIFOINT", n)),
        fifo_user: core::array::from_fn(|n| element("FIFOUA", n)),
        fifo_index: core::array::from_fn(|n| element("FIFOCI", n)),
        named: Vec::new(),
    };
    slots.named = file.slots().map(|slot| name(&slots, slot)).collect();
    let field = |slot, name: &str| file.find_field(slot, name, 0).unwrap_or_else(|| missing(name));
    let fields = Fields {
        reqop: field(slots.con, "REQOP"),
        opmod: field(slots.con, "OPMOD"),
        dncnt: field(slots.con, "DNCNT"),
        canbusy: field(slots.con, "CANBUSY"),
        abat: field(slots.con, "ABAT"),
        filhit: field(slots.vec, "FILHIT"),
        icod: field(slots.vec, "ICOD"),
        tec: field(slots.trec, "TEC"),
        rec: field(slots.trec, "REC"),
        cants: field(slots.tmr, "CANTS"),
        seg2ph: field(slots.cfg, "SEG2PH"),
    };
    (slots, fields)
}

/// The registers of an array, and what each is by its number.
type Numbered<'a> = (&'a [Slot], fn(u8) -> Named);

fn name(slots: &Slots, slot: Slot) -> Named {
    let number = |array: &[Slot]| array.iter().position(|at| *at == slot).map(|n| n as u8);
    let single = [(slots.con, Named::Con), (slots.int, Named::Int), (slots.tmr, Named::Tmr)];
    if let Some((_, named)) = single.into_iter().find(|(at, _)| *at == slot) {
        return named;
    }
    let arrays: [Numbered<'_>; 7] = [
        (&slots.masks, Named::Mask),
        (&slots.filter_control, Named::FilterControl),
        (&slots.filters, Named::Filter),
        (&slots.fifo_control, Named::FifoControl),
        (&slots.fifo_interrupt, Named::FifoInterrupt),
        (&slots.fifo_user, Named::FifoUser),
        (&slots.fifo_index, Named::FifoIndex),
    ];
    let found = arrays.iter().find_map(|(array, named)| number(array).map(named));
    found.unwrap_or(if slot == slots.fifo_base { Named::FifoBase } else { Named::Plain })
}
