use m_can_pac::MCan;
use m_can_pac::registers::Ie;

fn disable(can: &MCan) {
    can.ie().clear(Ie::RF0NE);
}

fn main() {}
