//! With WIN = 0 the address of RXF0SID belongs to another register.
use dspic33_ecan_pac::Dspic33Ecan;
use dspic33_ecan_pac::registers::RxfSid;

fn accept(can: &Dspic33Ecan) {
    can.rxf_sid(0).write(RxfSid::RESET.with_sid(0x123));
}

fn main() {}
