use dspic33_canfd_pac::Dspic33Canfd;

fn acknowledge(can: &Dspic33Canfd) {
    can.int_l().modify(|flags| flags);
}

fn main() {}
