use m_can_pac::MCan;
use m_can_pac::registers::Ecr;

fn forget_errors(can: &MCan) {
    can.ecr().write(Ecr::ZERO);
}

fn main() {}
