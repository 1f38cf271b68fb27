//! Reading IR and writing it back clears every flag that was set.
use m_can_pac::MCan;

fn acknowledge(can: &MCan) {
    can.ir().modify(|flags| flags);
}

fn main() {}
