use dspic33_canfd_pac::Dspic33Canfd;
use dspic33_canfd_pac::registers::FifobaL;

fn place_fifos(can: &Dspic33Canfd) {
    can.fifoba_l().write(FifobaL::RESET);
    can.write_fifoba(0x4000);
}

fn main() {}
