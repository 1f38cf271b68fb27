//! The registers and fields that the model works with, by their names in the description.

use core::array::from_fn;

use crate::registers::{FieldAt, RegisterFile, Slot};

/// The control bits of one transmit buffer.
#[derive(Clone, Copy, Debug)]
pub(super) struct TxNames {
    pub(super) txen: FieldAt,
    pub(super) txabt: FieldAt,
    pub(super) txlarb: FieldAt,
    pub(super) txerr: FieldAt,
    pub(super) txreq: FieldAt,
    pub(super) rtren: FieldAt,
    pub(super) txpri: FieldAt,
}

/// Which register an access of the host has reached, as far as the model acts on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Ctrl1,
    Ctrl2,
    Vec,
    Fctrl,
    Fmsksel,
    Intf,
    Inte,
    /// RXFUL1 and RXFUL2, counted from 0.
    Rxful(usize),
    Rxovf(usize),
    Trcon(usize),
    /// CxRXD and CxTXD.
    Data,
    /// Whatever is storage.
    Storage,
}

/// Registers and fields.
#[derive(Clone, Debug)]
pub(super) struct Names {
    pub(super) ctrl1: Slot,
    pub(super) ctrl2: Slot,
    pub(super) vec: Slot,
    pub(super) fctrl: Slot,
    pub(super) intf: Slot,
    pub(super) inte: Slot,
    pub(super) ec: Slot,
    pub(super) cfg1: Slot,
    pub(super) cfg2: Slot,
    pub(super) fen1: Slot,
    pub(super) rxd: Slot,
    pub(super) txd: Slot,
    pub(super) fmsksel: [Slot; 2],
    pub(super) rxful: [Slot; 2],
    pub(super) rxovf: [Slot; 2],
    pub(super) trcon: [Slot; 4],
    pub(super) bufpnt: [Slot; 4],
    pub(super) rxmsid: [Slot; 3],
    pub(super) rxmeid: [Slot; 3],
    pub(super) rxfsid: [Slot; 16],
    pub(super) rxfeid: [Slot; 16],
    pub(super) abat: FieldAt,
    pub(super) opmode: FieldAt,
    pub(super) win: FieldAt,
    pub(super) fbp: FieldAt,
    pub(super) fnrb: FieldAt,
    pub(super) fsa: FieldAt,
    pub(super) tx: [TxNames; 8],
    roles: Vec<Role>,
}

impl Names {
    /// Looks the names up once.
    pub(super) fn look_up(file: &RegisterFile) -> Self {
        let slot = |name: &str, n: usize| {
            let found = file.find(name, 0, n as u32);
            found.unwrap_or_else(|| panic!("the description has no {name} {n}"))
        };
        let field = |slot: Slot, name: &str, lane: usize| {
            let found = file.find_field(slot, name, lane as u8);
            found.unwrap_or_else(|| panic!("the description has no {}.{name} {lane}", file.name(slot)))
        };
        let (ctrl1, fifo, fctrl) = (slot("CTRL1", 0), slot("FIFO", 0), slot("FCTRL", 0));
        let tx = |buffer: usize| {
            let at = |name| field(slot("TRCON", buffer / 2), name, buffer % 2);
            TxNames {
                txen: at("TXEN"),
                txabt: at("TXABT"),
                txlarb: at("TXLARB"),
                txerr: at("TXERR"),
                txreq: at("TXREQ"),
                rtren: at("RTREN"),
                txpri: at("TXPRI"),
            }
        };
        let mut names = Self {
            ctrl1,
            ctrl2: slot("CTRL2", 0),
            vec: slot("VEC", 0),
            fctrl,
            intf: slot("INTF", 0),
            inte: slot("INTE", 0),
            ec: slot("EC", 0),
            cfg1: slot("CFG1", 0),
            cfg2: slot("CFG2", 0),
            fen1: slot("FEN1", 0),
            rxd: slot("RXD", 0),
            txd: slot("TXD", 0),
            fmsksel: from_fn(|n| slot("FMSKSEL", n)),
            rxful: from_fn(|n| slot("RXFUL", n)),
            rxovf: from_fn(|n| slot("RXOVF", n)),
            trcon: from_fn(|n| slot("TRCON", n)),
            bufpnt: from_fn(|n| slot("BUFPNT", n)),
            rxmsid: from_fn(|n| slot("RXMSID", n)),
            rxmeid: from_fn(|n| slot("RXMEID", n)),
            rxfsid: from_fn(|n| slot("RXFSID", n)),
            rxfeid: from_fn(|n| slot("RXFEID", n)),
            abat: field(ctrl1, "ABAT", 0),
            opmode: field(ctrl1, "OPMODE", 0),
            win: field(ctrl1, "WIN", 0),
            fbp: field(fifo, "FBP", 0),
            fnrb: field(fifo, "FNRB", 0),
            fsa: field(fctrl, "FSA", 0),
            tx: from_fn(tx),
            roles: Vec::new(),
        };
        names.roles = file.slots().map(|slot| names.find_role(slot)).collect();
        names
    }

    fn find_role(&self, slot: Slot) -> Role {
        let among = |slots: &[Slot]| slots.iter().position(|other| *other == slot);
        if let Some(n) = among(&self.rxful) {
            return Role::Rxful(n);
        }
        if let Some(n) = among(&self.rxovf) {
            return Role::Rxovf(n);
        }
        if let Some(n) = among(&self.trcon) {
            return Role::Trcon(n);
        }
        let single = [
            (self.ctrl1, Role::Ctrl1),
            (self.ctrl2, Role::Ctrl2),
            (self.vec, Role::Vec),
            (self.fctrl, Role::Fctrl),
            (self.intf, Role::Intf),
            (self.inte, Role::Inte),
            (self.fmsksel[0], Role::Fmsksel),
            (self.fmsksel[1], Role::Fmsksel),
            (self.rxd, Role::Data),
            (self.txd, Role::Data),
        ];
        single.iter().find(|(other, _)| *other == slot).map_or(Role::Storage, |(_, role)| *role)
    }

    /// What the model does about a register.
    #[inline]
    pub(super) fn role(&self, slot: Slot) -> Role {
        self.roles[slot.0 as usize]
    }
}
