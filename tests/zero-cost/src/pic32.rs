//! PIC32: alias registers.

use pic32_can_pac::registers::FifoCon;
use pic32_can_pac::{Mmio, Pic32Can};

use crate::byhand::put32;

// claims pic32_set_bits store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_pic32_set_bits(base: usize) {
    let can = Pic32Can::new(unsafe { Mmio::new(base) });
    can.fifo(2).con().set_bits(FifoCon::TXREQ | FifoCon::UINC);
}

#[unsafe(no_mangle)]
pub unsafe fn hand_pic32_set_bits(base: usize) {
    // FIFO blocks start at 0x350 and are 0x40 apart; the SET register of CiFIFOCON is 8 bytes behind it.
    unsafe { put32(base, 0x350 + 2 * 0x40 + 8, 0x2008) }
}

// claims pic32_clear_bits store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_pic32_clear_bits(base: usize) {
    let can = Pic32Can::new(unsafe { Mmio::new(base) });
    can.fifo(2).con().clear_bits(FifoCon::TXREQ);
}

#[unsafe(no_mangle)]
pub unsafe fn hand_pic32_clear_bits(base: usize) {
    unsafe { put32(base, 0x350 + 2 * 0x40 + 4, 8) }
}
