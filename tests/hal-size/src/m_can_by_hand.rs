//! M_CAN by hand: what a careful driver for this one configuration does, with numbers from the manual.

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};

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

const CCCR: usize = 0x18;
const FDOE_BRSE: u32 = 1 << 8 | 1 << 9;
/// Two filters, then eight Rx and eight Tx elements of 72 bytes.
const RX: usize = 8;
const TX: usize = RX + 8 * 72;

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_init(base: usize, ram: usize) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        put(base + CCCR, 1);
        if !poll(base + CCCR, 1, 1) {
            return false;
        }
        put(base + CCCR, 3 | FDOE_BRSE);
        for (offset, value) in [
            (0x1C, crate::m_can::TIMING.nbtp.bits()),
            (0x0C, crate::m_can::TIMING.dbtp.bits()),
            (0x48, crate::m_can::TIMING.tdcr.bits()),
            (0x14, 0),
            (0x20, 0),
            (0x28, 0xFFFF_0000),
            (0x80, 0b10_1000),
            (0x84, 2 << 16),
            (0x88, 0),
            (0x90, 0x1FFF_FFFF),
            (0xA0, 8 << 16 | RX as u32),
            (0xB0, 0),
            (0xAC, 0),
            (0xBC, 7),
            (0xC0, 8 << 24 | TX as u32),
            (0xC8, 7),
            (0xF0, 0),
            (0x58, 0),
            (0x54, 1 << 25 | 1),
            (0x5C, 1),
        ] {
            put(base + offset, value);
        }
        put(ram, 1 << 27 | 0x100 << 16 | 0x1FF);
        put(ram + 4, 1 << 30 | 5 << 27 | 0x7DF << 16 | 0x7DF);
        put(base + CCCR, FDOE_BRSE);
        poll(base + CCCR, 1, 0)
    }
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_send(base: usize, ram: usize, frame: &Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        let status = get(base + 0xC4);
        if status & 1 << 21 != 0 {
            return false;
        }
        let put_index = status >> 16 & 0x1F;
        let element = ram + TX + put_index as usize * 72;
        let id = match frame.id() {
            Id::Standard(id) => u32::from(id.as_raw()) << 18,
            Id::Extended(id) => id.as_raw() | 1 << 30,
        };
        let (rtr, esi, fdf, brs) = match frame.format() {
            Format::Data => (0, 0, 0, 0),
            Format::Remote => (1 << 29, 0, 0, 0),
            Format::Fd(FdFlags { brs, esi }) => (0, u32::from(esi) << 31, 1 << 21, u32::from(brs) << 20),
        };
        put(element, id | rtr | esi);
        put(element + 4, fdf | brs | u32::from(frame.dlc().code()) << 16);
        let mut at = element + 8;
        for bytes in frame.data_bytes().chunks(4) {
            let mut word = [0; 4];
            for (to, from) in word.iter_mut().zip(bytes) {
                *to = *from;
            }
            put(at, u32::from_le_bytes(word));
            at += 4;
        }
        put(base + 0xD0, 1 << put_index);
    }
    true
}

#[unsafe(no_mangle)]
pub unsafe fn hand_m_can_receive(base: usize, ram: usize, out: &mut Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        let status = get(base + 0xA4);
        if status & 0x7F == 0 {
            return false;
        }
        let index = status >> 8 & 0x3F;
        let element = ram + RX + index as usize * 72;
        let (r0, r1) = (get(element), get(element + 4));
        let id = if r0 & 1 << 30 != 0 {
            Id::Extended(ExtendedId::new(r0 & 0x1FFF_FFFF).unwrap_or(ExtendedId::ZERO))
        } else {
            Id::Standard(StandardId::new((r0 >> 18) as u16 & 0x7FF).unwrap_or(StandardId::ZERO))
        };
        let format = if r1 & 1 << 21 != 0 {
            Format::Fd(FdFlags { brs: r1 & 1 << 20 != 0, esi: r0 >> 31 != 0 })
        } else if r0 & 1 << 29 != 0 {
            Format::Remote
        } else {
            Format::Data
        };
        *out = Frame::read_with(id, format, Dlc::from_low_bits((r1 >> 16) as u8), |data| {
            let mut at = element + 8;
            for bytes in data.chunks_mut(4) {
                let word = get(at).to_le_bytes();
                for (to, from) in bytes.iter_mut().zip(word) {
                    *to = from;
                }
                at += 4;
            }
        });
        put(base + 0xA8, index);
    }
    true
}
