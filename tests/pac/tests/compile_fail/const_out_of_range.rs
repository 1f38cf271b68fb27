//! A jump width that NBTP cannot hold.
use m_can_pac::registers::Nbtp;

const T: Nbtp = Nbtp::RESET.with_nsjw(200);

fn main() {}
