//! The hardware reads and writes message memory where SIDFC points.
use m_can_pac::MCan;
use m_can_pac::registers::Sidfc;

fn place_filters(can: &MCan) {
    can.sidfc().write(Sidfc::RESET.with_flssa(0x40));
}

fn main() {}
