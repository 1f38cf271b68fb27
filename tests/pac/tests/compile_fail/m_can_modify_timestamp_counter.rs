use m_can_pac::MCan;

fn restart(can: &MCan) {
    can.tscv().modify(|counter| counter);
}

fn main() {}
