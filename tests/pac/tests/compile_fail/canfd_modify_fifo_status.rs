use dspic33_canfd_pac::Dspic33Canfd;

fn acknowledge(can: &Dspic33Canfd) {
    can.fifo(1).sta().modify(|status| status);
}

fn main() {}
