//! M_CAN: 32-bit registers, flags cleared by 1, Message RAM.

use m_can_pac::messages::{TxBuffer, TxBufferT0, TxBufferT1};
use m_can_pac::registers::{Cccr, Dbtp, Ie, Ile, Ir, Nbtp, Rxf0a, Txbar};
use m_can_pac::{MCan, Mmio};

use crate::byhand::{get32, put32};

const NOMINAL: Nbtp = Nbtp::RESET.with_nsjw(7).with_nbrp(3).with_ntseg1(62).with_ntseg2(15);
const DATA: Dbtp = Dbtp::RESET.with_dbrp(1).with_dtseg1(14).with_dtseg2(3).with_dsjw(3);

// claims m_can_init store32=6
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_init(base: usize) {
    let can = MCan::new(unsafe { Mmio::new(base) });
    can.cccr().write(Cccr::RESET.with_init(true));
    can.cccr().write(Cccr::RESET.with_init(true).with_cce(true));
    can.nbtp().write(NOMINAL);
    can.dbtp().write(DATA);
    can.ie().write(Ie::RF0NE | Ie::BOE);
    can.ile().write(Ile::RESET.with_eint0(true));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_init(base: usize) {
    unsafe {
        put32(base, 0x18, 1);
        put32(base, 0x18, 3);
        put32(base, 0x1C, (7 << 25) | (3 << 16) | (62 << 8) | 15);
        put32(base, 0x0C, (1 << 16) | (14 << 8) | (3 << 4) | 3);
        put32(base, 0x54, 1 | (1 << 25));
        put32(base, 0x5C, 1);
    }
}

// claims m_can_test_and_clear load32=1 store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_test_and_clear(base: usize) -> bool {
    let can = MCan::new(unsafe { Mmio::new(base) });
    if can.ir().read().contains(Ir::RF0N) {
        can.ir().clear(Ir::RF0N);
        return true;
    }
    false
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_test_and_clear(base: usize) -> bool {
    unsafe {
        if get32(base, 0x50) & 1 == 1 {
            put32(base, 0x50, 1);
            return true;
        }
        false
    }
}

// claims m_can_fifo_acknowledge load32=1 store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_fifo_acknowledge(base: usize) -> u8 {
    let can = MCan::new(unsafe { Mmio::new(base) });
    let index = can.rxf0s().read().f0gi();
    can.rxf0a().write(Rxf0a::RESET.with_f0ai(index));
    index
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_fifo_acknowledge(base: usize) -> u8 {
    unsafe {
        let index = (get32(base, 0xA4) >> 8) & 0x3F;
        put32(base, 0xA8, index);
        index as u8
    }
}

// claims m_can_modify load32=1 store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_modify(base: usize) {
    let can = MCan::new(unsafe { Mmio::new(base) });
    can.ile().modify(|r| r.with_eint1(true));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_modify(base: usize) {
    unsafe {
        let value = get32(base, 0x5C) & 3;
        put32(base, 0x5C, value | 2);
    }
}

// claims m_can_request store32=1
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_request(base: usize) {
    let can = MCan::new(unsafe { Mmio::new(base) });
    can.txbar().request(Txbar::ar_bit(3));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_request(base: usize) {
    unsafe { put32(base, 0xD0, 1 << 3) }
}

// Words only: a byte access can corrupt the rest of the word in Message RAM.
// never m_can_message_words store8 store16 store?
#[unsafe(no_mangle)]
pub unsafe fn pac_m_can_message_words(memory: usize, id: u16, data: &[u8; 8]) {
    let element = TxBuffer::new(unsafe { Mmio::new(memory) }, 0x80);
    element.t0().write(TxBufferT0::ZERO.with_id(u32::from(id & 0x7FF) << 18));
    element.t1().write(TxBufferT1::from_bits(8 << 16));
    element.payload(0).write(data, 0);
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_message_words(memory: usize, id: u16, data: &[u8; 8]) {
    unsafe {
        put32(memory, 0x80, u32::from(id & 0x7FF) << 18);
        put32(memory, 0x84, 8 << 16);
        let mut at = 0x88;
        for word in data.chunks_exact(4) {
            put32(memory, at, u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
            at += 4;
        }
    }
}
