//! CAN FD by hand: what a careful driver for this one configuration does, with numbers from the manual (dsPIC33 CAN FD
//! module). FIFO 1 receives, FIFO 2 transmits; the memory lies below address 0x1_0000, so that the lower half of a user
//! address is all of it.

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};

use crate::dspic33_canfd::{RAM, TIMING};

unsafe fn get(address: usize) -> u16 {
    // SAFETY: the caller gives an address of the chip.
    unsafe { core::ptr::with_exposed_provenance::<u16>(address).read_volatile() }
}

unsafe fn put(address: usize, value: u16) {
    // SAFETY: as above.
    unsafe { core::ptr::with_exposed_provenance_mut::<u16>(address).write_volatile(value) }
}

unsafe fn poll(address: usize, mask: u16, value: u16) -> bool {
    for _ in 0..1_000 {
        // SAFETY: as above.
        if unsafe { get(address) } & mask == value {
            return true;
        }
    }
    false
}

/// CxCONH (Register 3-2).
const CONH: usize = 0x02;
const OPMOD: u16 = 7 << 5;
/// CxFLTCON0L and the registers after it, two filters each (Registers 3-50 and 3-51).
const FLTCON: usize = 0x1D0;
/// CxFIFOCONxL, CxFIFOCONxH, CxFIFOSTAx and CxFIFOUAxL (Registers 3-32 to 3-34, 3-38) of FIFO 1 and FIFO 2.
const RX_CON: usize = 0x5C;
const RX_SIZE: usize = 0x5E;
const RX_STA: usize = 0x60;
const RX_UA: usize = 0x64;
const TX_CON: usize = 0x68;
const TX_SIZE: usize = 0x6A;
const TX_STA: usize = 0x6C;
const TX_UA: usize = 0x70;
/// 64 data bytes, eight messages, unlimited attempts.
const SIZE: u16 = 7 << 13 | 7 << 8 | 3 << 5;
/// RXOVIE and TFNRFNIE; TXEN.
const RX_CONTROL: u16 = 1 << 3 | 1;
const TX_CONTROL: u16 = 1 << 7;
const TXREQ: u16 = 1 << 9;
const UINC: u16 = 1 << 8;

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_canfd_init(base: usize) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // 4.2: CON, Configuration mode without queue and event FIFO.
        put(base, 1 << 15);
        put(base + CONH, 4 << 8);
        if !poll(base + CONH, OPMOD, 4 << 5) {
            return false;
        }
        // 8.1: all filters off.
        for register in 0..16 {
            put(base + FLTCON + 2 * register, 0);
        }
        for (offset, value) in [
            // CON, WFT and ISOCRCEN (Register 3-1).
            (0x00, 1 << 15 | 3 << 9 | 1 << 5),
            // 5.3: nominal and data bit timing, delay compensation.
            (0x06, TIMING.nbtcfgh.bits()),
            (0x04, TIMING.nbtcfgl.bits()),
            (0x0A, TIMING.dbtcfgh.bits()),
            (0x08, TIMING.dbtcfgl.bits()),
            (0x0E, TIMING.tdch.bits()),
            (0x0C, TIMING.tdcl.bits()),
            // 11.0: no timestamps.
            (0x16, 0),
            // 5.4: where the memory begins, and the two FIFOs.
            (0x4C, RAM as u16),
            (0x4E, (RAM >> 16) as u16),
            (RX_CON, RX_CONTROL),
            (RX_SIZE, SIZE),
            (TX_CON, TX_CONTROL),
            (TX_SIZE, SIZE),
            // 8.1, 8.2.1: objects and masks, with MIDE, of filters 0 and 1; then both to FIFO 1; then enabled.
            (0x1F0, 0x100),
            (0x1F2, 0),
            (0x1F4, 0x700),
            (0x1F6, 1 << 14),
            (0x1F8, 0x7DF),
            (0x1FA, 0),
            (0x1FC, 0x7FF),
            (0x1FE, 1 << 14),
            (FLTCON, 1 << 8 | 1),
            (FLTCON, 1 << 15 | 1 << 8 | 1 << 7 | 1),
            // CERRIE and RXIE (Register 3-16).
            (0x1E, 1 << 13 | 1 << 1),
            // 4.3: Normal CAN FD mode.
            (CONH, 0),
        ] {
            put(base + offset, value);
        }
        poll(base + CONH, OPMOD, 0)
    }
}

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_canfd_send(base: usize, ram: usize, frame: &Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // TFNRFNIF (Register 3-34).
        if get(base + TX_STA) & 1 == 0 {
            return false;
        }
        let element = ram + (usize::from(get(base + TX_UA)) - RAM as usize);
        // Table 6-1
        let (word0, word1, ide) = match frame.id() {
            Id::Standard(id) => (id.as_raw(), 0, 0),
            Id::Extended(id) => {
                let id = id.as_raw();
                ((id as u16 & 0x1F) << 11 | (id >> 18) as u16, (id >> 5) as u16 & 0x1FFF, 1 << 4)
            }
        };
        let format = match frame.format() {
            Format::Data => 0,
            Format::Remote => 1 << 5,
            Format::Fd(FdFlags { brs, esi }) => u16::from(esi) << 8 | 1 << 7 | u16::from(brs) << 6,
        };
        put(element, word0);
        put(element + 2, word1);
        put(element + 4, ide | format | u16::from(frame.dlc().code()));
        put(element + 6, 0);
        let mut at = element + 8;
        for bytes in frame.data_bytes().chunks(2) {
            let mut word = [0; 2];
            for (to, from) in word.iter_mut().zip(bytes) {
                *to = *from;
            }
            put(at, u16::from_le_bytes(word));
            at += 2;
        }
        // 6.2, 6.4
        put(base + TX_CON, TX_CONTROL | UINC | TXREQ);
    }
    true
}

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_canfd_receive(base: usize, ram: usize, out: &mut Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // RXOVIF and TFNRFNIF (Register 3-34, 12.1.4).
        let status = get(base + RX_STA);
        if status & 1 << 3 != 0 {
            put(base + RX_STA, !(1 << 3));
            return false;
        }
        if status & 1 == 0 {
            return false;
        }
        let element = ram + (usize::from(get(base + RX_UA)) - RAM as usize);
        // Table 9-1
        let (word0, word1, word2) = (get(element), get(element + 2), get(element + 4));
        let sid = word0 & 0x7FF;
        let id = if word2 & 1 << 4 == 0 {
            Id::Standard(StandardId::new(sid).unwrap_or(StandardId::ZERO))
        } else {
            let raw = u32::from(sid) << 18 | u32::from(word1 & 0x1FFF) << 5 | u32::from(word0 >> 11);
            Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO))
        };
        let format = if word2 & 1 << 7 != 0 {
            Format::Fd(FdFlags { brs: word2 & 1 << 6 != 0, esi: word2 & 1 << 8 != 0 })
        } else if word2 & 1 << 5 != 0 {
            Format::Remote
        } else {
            Format::Data
        };
        *out = Frame::read_with(id, format, Dlc::from_low_bits(word2 as u8), |data| {
            let mut at = element + 8;
            for bytes in data.chunks_mut(2) {
                let word = get(at).to_le_bytes();
                for (to, from) in bytes.iter_mut().zip(word) {
                    *to = from;
                }
                at += 2;
            }
        });
        // 9.1.1
        put(base + RX_CON, RX_CONTROL | UINC);
    }
    true
}
