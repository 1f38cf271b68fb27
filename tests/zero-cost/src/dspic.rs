//! dsPIC33 CAN FD and ECAN: 16-bit registers, flags cleared by 0, halves, a window.

use dspic33_canfd_pac::Dspic33Canfd;
use dspic33_canfd_pac::registers::{FltCon, IntL};
use dspic33_ecan_pac::registers::{RxfSid, Rxful};
use dspic33_ecan_pac::{Dspic33Ecan, Mmio};

use crate::byhand::{check, get16, put16};

// claims canfd_clear_flag store16=1
#[unsafe(no_mangle)]
pub unsafe fn pac_canfd_clear_flag(base: usize) {
    let can = Dspic33Canfd::new(unsafe { Mmio::new(base) });
    can.int_l().clear(IntL::WAKIF);
}

#[unsafe(no_mangle)]
pub unsafe fn hand_canfd_clear_flag(base: usize) {
    unsafe { put16(base, 0x1C, 0xF00C & !0x4000) }
}

// claims ecan_release_buffer store16=1
#[unsafe(no_mangle)]
pub unsafe fn pac_ecan_release_buffer(base: usize) {
    let can = Dspic33Ecan::new(unsafe { Mmio::new(base) });
    can.rxful(1).clear(Rxful::rxful_bit(3));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_ecan_release_buffer(base: usize) {
    unsafe { put16(base, 0x20, !(1 << 3)) }
}

// claims ecan_filter_window load16=2 store16=3
#[unsafe(no_mangle)]
pub unsafe fn pac_ecan_filter_window(base: usize) {
    let mut can = Dspic33Ecan::new(unsafe { Mmio::new(base) });
    can.filter_window(|window| window.rxf_sid(0).write(RxfSid::RESET.with_sid(0x123)));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_ecan_filter_window(base: usize) {
    // CSIDL, REQOP and CANCAP are kept, ABAT is not requested again, OPMODE is read-only.
    const KEPT: u16 = 0x2000 | 0x0700 | 0x0008;
    unsafe {
        put16(base, 0x00, (get16(base, 0x00) & KEPT) | 1);
        put16(base, 0x40, 0x123 << 5);
        put16(base, 0x00, get16(base, 0x00) & KEPT);
    }
}

// claims canfd_read_joined load16=2
#[unsafe(no_mangle)]
pub unsafe fn pac_canfd_read_joined(base: usize) -> u32 {
    Dspic33Canfd::new(unsafe { Mmio::new(base) }).read_tbc()
}

#[unsafe(no_mangle)]
pub unsafe fn hand_canfd_read_joined(base: usize) -> u32 {
    unsafe {
        let low = get16(base, 0x10);
        let high = get16(base, 0x12);
        u32::from(low) | (u32::from(high) << 16)
    }
}

// claims canfd_write_joined store16=2
#[unsafe(no_mangle)]
pub unsafe fn pac_canfd_write_joined(base: usize, value: u32) {
    Dspic33Canfd::new(unsafe { Mmio::new(base) }).write_nbtcfg(value);
}

#[unsafe(no_mangle)]
pub unsafe fn hand_canfd_write_joined(base: usize, value: u32) {
    unsafe {
        put16(base, 0x04, value as u16);
        put16(base, 0x06, (value >> 16) as u16);
    }
}

#[unsafe(no_mangle)]
pub unsafe fn pac_canfd_element_by_index(base: usize, n: usize) {
    let can = Dspic33Canfd::new(unsafe { Mmio::new(base) });
    can.flt_con(n).write(FltCon::ZERO.with_flten(0, true));
}

#[unsafe(no_mangle)]
pub unsafe fn hand_canfd_element_by_index(base: usize, n: usize) {
    let offset = 0x1D0 + 2 * check(n, 0, 16, "flt_con takes 0..=15");
    unsafe { put16(base, offset, 0x80) }
}
