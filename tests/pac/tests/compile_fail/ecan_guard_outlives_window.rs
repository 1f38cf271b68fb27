//! The guard cannot be kept: behind the closure the window is closed.
use dspic33_ecan_pac::{Dspic33Ecan, FilterWindow};

fn keep(can: &mut Dspic33Ecan) -> &FilterWindow {
    can.filter_window(|window| window)
}

fn main() {}
