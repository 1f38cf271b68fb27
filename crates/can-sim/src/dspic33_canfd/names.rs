//! The registers and fields that the model works with, by their names in the description.

use crate::registers::{FieldAt, RegisterFile, Slot, names::names};

names! {
    registers {
        con_l = "CONL", con_h = "CONH", nbtcfg_l = "NBTCFGL", nbtcfg_h = "NBTCFGH", dbtcfg_l = "DBTCFGL",
        dbtcfg_h = "DBTCFGH", tdc_l = "TDCL", tdc_h = "TDCH", tbc_l = "TBCL", tbc_h = "TBCH", tscon_l = "TSCONL",
        tscon_h = "TSCONH", vec_l = "VECL", vec_h = "VECH", int_l = "INTL", int_h = "INTH", rxif_l = "RXIFL",
        rxif_h = "RXIFH", rxovif_l = "RXOVIFL", rxovif_h = "RXOVIFH", txif_l = "TXIFL", txif_h = "TXIFH",
        txatif_l = "TXATIFL", txatif_h = "TXATIFH", txreq_l = "TXREQL", txreq_h = "TXREQH", fifoba_l = "FIFOBAL",
        fifoba_h = "FIFOBAH", txqcon_l = "TXQCONL", txqcon_h = "TXQCONH", txqsta = "TXQSTA", tefcon_l = "TEFCONL",
        tefcon_h = "TEFCONH", tefsta = "TEFSTA", tefua_l = "TEFUAL", tefua_h = "TEFUAH", txqua_l = "TXQUAL",
        txqua_h = "TXQUAH", trec_l = "TRECL", trec_h = "TRECH", bdiag0_l = "BDIAG0L", bdiag0_h = "BDIAG0H",
        bdiag1_l = "BDIAG1L", bdiag1_h = "BDIAG1H",
    }
    fields {
        busy = con_l "BUSY", abat = con_h "ABAT", opmod = con_h "OPMOD", tdcv = tdc_l "TDCV", txbo = trec_h "TXBO",
        terrcnt = trec_l "TERRCNT", rerrcnt = trec_l "RERRCNT", txqci = txqsta "TXQCI",
    }
}

/// The registers of one FIFO.
#[derive(Clone, Copy, Debug)]
pub(super) struct FifoSlots {
    pub(super) con_l: Slot,
    pub(super) con_h: Slot,
    pub(super) sta: Slot,
    pub(super) index: FieldAt,
    pub(super) ua_l: Slot,
    pub(super) ua_h: Slot,
}

/// The registers of one filter.
#[derive(Clone, Copy, Debug)]
pub(super) struct FilterSlots {
    pub(super) enable: FieldAt,
    pub(super) target: FieldAt,
    pub(super) obj_l: Slot,
    pub(super) obj_h: Slot,
    pub(super) mask_l: Slot,
    pub(super) mask_h: Slot,
}

/// What a register belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    Module,
    /// FIFOCONnL.
    Control(u8),
    /// FIFOCONnH.
    Size(u8),
    /// FIFOSTAn.
    Status(u8),
    /// FIFOUAnL or FIFOUAnH.
    Address(u8),
    /// FLTCON of two filters, the first of them given.
    FilterControl(u8),
}

/// Registers that there are several of.
#[derive(Clone, Debug)]
pub(super) struct Arrays {
    /// Index 0 is FIFO 1.
    pub(super) fifos: Vec<FifoSlots>,
    pub(super) filters: Vec<FilterSlots>,
    owners: Vec<Owner>,
}

impl Arrays {
    pub(super) fn look_up(file: &RegisterFile) -> Self {
        let slot = |name: &str, element: u32, inner: u32| {
            file.find(name, element, inner).unwrap_or_else(|| panic!("the description has no {name}"))
        };
        let mut owners = vec![Owner::Module; file.slots().count()];
        let mut own = |slot: Slot, owner: Owner| owners[usize::from(slot.0)] = owner;
        let mut fifos = Vec::new();
        for element in 0..31 {
            let of = |name| slot(name, element, 0);
            let fifo = FifoSlots {
                con_l: of("FIFOCONL"),
                con_h: of("FIFOCONH"),
                sta: of("FIFOSTA"),
                index: file.find_field(of("FIFOSTA"), "FIFOCI", 0).expect("a FIFO has an index"),
                ua_l: of("FIFOUAL"),
                ua_h: of("FIFOUAH"),
            };
            let number = element as u8 + 1;
            own(fifo.con_l, Owner::Control(number));
            own(fifo.con_h, Owner::Size(number));
            own(fifo.sta, Owner::Status(number));
            own(fifo.ua_l, Owner::Address(number));
            own(fifo.ua_h, Owner::Address(number));
            fifos.push(fifo);
        }
        let mut filters = Vec::new();
        for filter in 0..32_u8 {
            let con = slot("FLTCON", 0, u32::from(filter) / 2);
            own(con, Owner::FilterControl(filter & !1));
            let field = |name| {
                file.find_field(con, name, filter % 2).unwrap_or_else(|| panic!("the description has no FLTCON.{name}"))
            };
            let of = |name| slot(name, u32::from(filter), 0);
            filters.push(FilterSlots {
                enable: field("FLTEN"),
                target: field("FBP"),
                obj_l: of("FLTOBJL"),
                obj_h: of("FLTOBJH"),
                mask_l: of("MASKL"),
                mask_h: of("MASKH"),
            });
        }
        Self { fifos, filters, owners }
    }

    #[inline]
    pub(super) fn owner(&self, slot: Slot) -> Owner {
        self.owners[usize::from(slot.0)]
    }
}
