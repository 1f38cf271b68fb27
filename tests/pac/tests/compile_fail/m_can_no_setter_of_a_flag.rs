//! A setter would suggest that a flag takes what is written.
use m_can_pac::registers::Ir;

fn main() {
    let _ = Ir::RESET.with_rf0n(true);
}
