//! TXREQ is cleared by hardware: written back as 1 it sends the message again, as 0 it aborts.
use dspic33_ecan_pac::Dspic33Ecan;

fn raise_priority(can: &Dspic33Ecan) {
    can.tr_con(0).modify(|control| control);
}

fn main() {}
