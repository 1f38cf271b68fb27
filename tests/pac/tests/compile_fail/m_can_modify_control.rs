//! CCCR.INIT, CSR and ASM change under software's hands.
use m_can_pac::MCan;

fn go(can: &MCan) {
    can.cccr().modify(|control| control.with_init(false));
}

fn main() {}
