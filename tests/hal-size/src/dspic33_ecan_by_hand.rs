//! ECAN by hand: what a careful driver for this one configuration does, with numbers from the manual. Its queue sends from
//! the lowest free rank as the HAL's does, and a FIFO that has lost messages is taken up where the write pointer stands.

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};

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

const TRCON: usize = 0x30;
const BUFFER: usize = 16;
const FIFO_START: u8 = 8;
const FIFO_END: u8 = 15;

/// What the driver keeps.
pub struct State {
    level: u8,
    last: u8,
    next: u8,
}

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_ecan_init(base: usize, state: &mut State) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        put(base, 0x0400);
        if !poll(base, 0xE0, 0x80) {
            return false;
        }
        for (offset, value) in [
            (0x14, 0),
            (0x10, crate::dspic33_ecan::TIMING.cfg1.bits()),
            (0x12, crate::dspic33_ecan::TIMING.cfg2.bits()),
            (0x02, 0),
            (0x30, 0x0080),
            (0x32, 0x0080),
            (0x34, 0x0080),
            (0x36, 0x0080),
            (0x18, 1 << 2),
            (0x1A, 0),
            (0x00, 0x0401),
            (0x30, 0x700 << 5 | 8),
            (0x32, 0),
            (0x34, 0x7FF << 5 | 8),
            (0x36, 0),
            (0x38, 0),
            (0x3A, 0),
            (0x40, 0x100 << 5),
            (0x42, 0),
            (0x44, 0x7DF_u16.wrapping_shl(5)),
            (0x46, 0),
            (0x20, 0xFF),
            (0x00, 0x0400),
            (0x20, 0),
            (0x22, 0),
            (0x28, 0),
            (0x2A, 0),
            (0x06, crate::dspic33_ecan::PLAN.fctrl.bits()),
            (0x14, 3),
            (0x0C, 0x22),
            (0x00, 0),
        ] {
            put(base + offset, value);
        }
        *state = State { level: 0, last: 8, next: FIFO_START };
        poll(base, 0xE0, 0)
    }
}

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_ecan_send(base: usize, ram: usize, state: &mut State, frame: &Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        let mut pending = 0_u8;
        for pair in 0..4 {
            if get(base + TRCON + 2 * pair) & 0x0808 != 0 {
                pending |= 1 << pair;
            }
        }
        let free = !pending & 0xF;
        if pending == 0 {
            (state.level, state.last) = (0, 4);
        }
        let mut below = free & ((1_u8 << state.last) - 1);
        if below == 0 {
            if state.level == 2 || free == 0 {
                return false;
            }
            state.level += 1;
            below = free;
        }
        let pair = 7 - below.leading_zeros() as u8;
        state.last = pair;
        let element = ram + 2 * pair as usize * BUFFER;
        let (word0, word1, word2) = match frame.id() {
            Id::Standard(id) => (id.as_raw() << 2 | u16::from(frame.is_remote()) << 1, 0, 0),
            Id::Extended(id) => {
                let id = id.as_raw();
                let word2 = (id as u16 & 0x3F) << 10 | u16::from(frame.is_remote()) << 9;
                (((id >> 18) as u16) << 2 | 3, (id >> 6) as u16 & 0xFFF, word2)
            }
        };
        if frame.is_fd() {
            return false;
        }
        put(element, word0);
        put(element + 2, word1);
        put(element + 4, word2 | u16::from(frame.dlc().code()));
        let mut at = element + 6;
        for bytes in frame.data_bytes().chunks(2) {
            let mut word = [0; 2];
            for (to, from) in word.iter_mut().zip(bytes) {
                *to = *from;
            }
            put(at, u16::from_le_bytes(word));
            at += 2;
        }
        put(base + TRCON + 2 * pair as usize, 0x0088 | u16::from(2 - state.level));
    }
    true
}

#[unsafe(no_mangle)]
pub unsafe fn hand_dspic33_ecan_receive(base: usize, ram: usize, state: &mut State, out: &mut Frame) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    unsafe {
        let lost = get(base + 0x28) & 0xFF00;
        if lost != 0 {
            put(base + 0x28, !lost);
            put(base + 0x0A, !4);
            return false;
        }
        let write = (get(base + 0x08) >> 8) as u8 & 0x3F;
        let full = get(base + 0x20) & 0xFF00;
        if full == 0 {
            state.next = write;
            return false;
        }
        let from_next = full & u16::MAX << (state.next & 15);
        let buffer = (if from_next != 0 { from_next } else { full }).trailing_zeros() as u8;
        let element = ram + buffer as usize * BUFFER;
        let (word0, word2) = (get(element), get(element + 4));
        let sid = word0 >> 2 & 0x7FF;
        let (id, remote) = if word0 & 1 == 0 {
            (Id::Standard(StandardId::new(sid).unwrap_or(StandardId::ZERO)), word0 & 2 != 0)
        } else {
            let raw = u32::from(sid) << 18 | u32::from(get(element + 2) & 0xFFF) << 6 | u32::from(word2 >> 10);
            (Id::Extended(ExtendedId::new(raw).unwrap_or(ExtendedId::ZERO)), word2 & 1 << 9 != 0)
        };
        let format = if remote { Format::Remote } else { Format::Data };
        *out = Frame::read_with(id, format, Dlc::from_low_bits(word2 as u8), |data| {
            let mut at = element + 6;
            for bytes in data.chunks_mut(2) {
                let word = get(at).to_le_bytes();
                for (to, from) in bytes.iter_mut().zip(word) {
                    *to = from;
                }
                at += 2;
            }
        });
        put(base + 0x20, !(1 << buffer));
        state.next = if buffer == FIFO_END { FIFO_START } else { buffer + 1 };
    }
    true
}
