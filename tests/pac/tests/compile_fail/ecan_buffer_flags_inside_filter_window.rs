//! The flags of the buffers are not there while the filter window is open.
use dspic33_ecan_pac::Dspic33Ecan;

fn poll(can: &mut Dspic33Ecan) -> bool {
    can.filter_window(|window| window.rxful(1).read().is_empty())
}

fn main() {}
