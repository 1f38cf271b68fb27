//! PIC32MX CAN by hand: what a careful driver for this one configuration does, with numbers from the manual (PIC32MX
//! Family Reference Manual, Section 34). FIFO 0 sends, FIFO 1 receives; the memory begins at physical address 0.

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};

unsafe fn get(address: usize) -> u32 {
    // SAFETY: the caller gives an address of the chip.
    unsafe { core::ptr::with_exposed_provenance::<u32>(address).read_volatile() }
}

unsafe fn put(address: usize, value: u32) {
    // SAFETY: as above.
    unsafe { core::ptr::with_exposed_provenance_mut::<u32>(address).write_volatile(value) }
}

unsafe fn poll(address: usize, mask: u32, value: u32) -> bool {
    for _ in 0..1_000 {
        // SAFETY: as above.
        if unsafe { get(address) } & mask == value {
            return true;
        }
    }
    false
}

/// CiCON (Register 34-1).
const ON: u32 = 1 << 15;
const REQOP_CONFIGURATION: u32 = 4 << 24;
const OPMOD: u32 = 7 << 21;
/// CiFLTCON0 to CiFLTCON7 (Registers 34-10 to 34-17).
const FLTCON: usize = 0xC0;
/// CiFIFOCONn, CiFIFOINTn and CiFIFOUAn (Registers 34-20 to 34-22) of FIFO 0 and FIFO 1, with CLR at 4 and SET at 8.
const TX_CON: usize = 0x350;
const TX_INT: usize = 0x360;
const TX_UA: usize = 0x370;
const RX_CON: usize = 0x390;
const RX_INT: usize = 0x3A0;
const RX_UA: usize = 0x3B0;
const CLR: usize = 4;
const SET: usize = 8;
const UINC: u32 = 1 << 13;
const TXREQ: u32 = 1 << 3;

#[unsafe(no_mangle)]
pub unsafe fn hand_pic32_can_init(base: usize) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // 34.5.1: Configuration mode.
        put(base, REQOP_CONFIGURATION | ON);
        if !poll(base, OPMOD, 4 << 21) {
            return false;
        }
        // 34.8.1: all filters off.
        for register in 0..8 {
            put(base + FLTCON + 0x10 * register, 0);
        }
        for (offset, value) in [
            // CiTMR, CiCFG, CiFIFOBA (34.6.1).
            (0x070, 0),
            (0x010, crate::pic32_can::TIMING.cfg.bits()),
            (0x340, 0),
            // TXEN with four messages; eight messages, RXNEMPTYIE and RXOVFLIE.
            (TX_CON, 3 << 16 | 1 << 7),
            (TX_INT, 0),
            (RX_CON, 7 << 16),
            (RX_INT, 1 << 19 | 1 << 16),
            // Masks 0 and 1, filters 0 and 1 (34.8.3, 34.8.6): everything, and one identifier, to FIFO 1.
            (0x080, 0),
            (0x090, 0x7FF << 21 | 1 << 19 | 0x3_FFFF),
            (0x140, 0x100 << 21),
            (0x150, 0x7DF << 21),
            (FLTCON, 1 << 13 | 1 << 8 | 1),
            (FLTCON + SET, 1 << 15 | 1 << 7),
            // CERRIE and RBIE (Register 34-3).
            (0x020, 1 << 29 | 1 << 17),
            // 34.5.2: Normal Operation mode.
            (0x000, ON),
        ] {
            put(base + offset, value);
        }
        poll(base, OPMOD, 0)
    }
}

#[unsafe(no_mangle)]
pub unsafe fn hand_pic32_can_send(base: usize, ram: usize, frame: &Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // TXNFULLIF (Register 34-21).
        if get(base + TX_INT) & 1 << 10 == 0 || frame.is_fd() {
            return false;
        }
        let element = ram + get(base + TX_UA) as usize;
        // Table 34-2, Figure 34-12: SRR is 1 in an extended message.
        let (sid, eid) = match frame.id() {
            Id::Standard(id) => (u32::from(id.as_raw()), 0),
            Id::Extended(id) => (id.as_raw() >> 18, 3 << 28 | (id.as_raw() & 0x3_FFFF) << 10),
        };
        put(element, sid);
        put(element + 4, eid | u32::from(frame.is_remote()) << 9 | u32::from(frame.dlc().code()));
        let mut at = element + 8;
        for bytes in frame.data_bytes().chunks(4) {
            let mut word = [0; 4];
            for (to, from) in word.iter_mut().zip(bytes) {
                *to = *from;
            }
            put(at, u32::from_le_bytes(word));
            at += 4;
        }
        // 34.6.2, 34.7.2
        put(base + TX_CON + SET, UINC | TXREQ);
    }
    true
}

#[unsafe(no_mangle)]
pub unsafe fn hand_pic32_can_receive(base: usize, ram: usize, out: &mut Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        // RXOVFLIF and RXNEMPTYIF (Register 34-21).
        let flags = get(base + RX_INT);
        if flags & 1 << 3 != 0 {
            put(base + RX_INT + CLR, 1 << 3);
            return false;
        }
        if flags & 1 == 0 {
            return false;
        }
        let element = ram + get(base + RX_UA) as usize;
        // Table 34-5: a standard remote frame may show in RTR or in SRR.
        let (word0, word1) = (get(element), get(element + 4));
        let sid = word0 & 0x7FF;
        let (id, remote) = if word1 & 1 << 28 == 0 {
            (Id::Standard(StandardId::new(sid as u16).unwrap_or(StandardId::ZERO)), 1 << 29 | 1 << 9)
        } else {
            let raw = sid << 18 | word1 >> 10 & 0x3_FFFF;
            (Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO)), 1 << 9)
        };
        let format = if word1 & remote != 0 { Format::Remote } else { Format::Data };
        *out = Frame::read_with(id, format, Dlc::from_low_bits(word1 as u8), |data| {
            let mut at = element + 8;
            for bytes in data.chunks_mut(4) {
                let word = get(at).to_le_bytes();
                for (to, from) in bytes.iter_mut().zip(word) {
                    *to = from;
                }
                at += 4;
            }
        });
        // 34.6.3
        put(base + RX_CON + SET, UINC);
    }
    true
}
