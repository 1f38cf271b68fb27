//! Reading PSR sets LEC and DLEC, so that printing the register would destroy what it prints.
use m_can_pac::MCan;

fn log(can: &MCan) {
    println!("{:?}", can.psr());
}

fn main() {}
