//! Setting bits of an address moves it as a write does.
use pic32_can_pac::Pic32Can;
use pic32_can_pac::registers::FifoBa;

fn place_fifos(can: &Pic32Can) {
    can.fifo_ba().set_bits(FifoBa::from_bits(0x8000));
}

fn main() {}
