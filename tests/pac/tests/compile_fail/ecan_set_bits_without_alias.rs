use dspic33_ecan_pac::Dspic33Ecan;
use dspic33_ecan_pac::registers::Inte;

fn enable(can: &Dspic33Ecan) {
    can.inte().set_bits(Inte::RBIE);
}

fn main() {}
