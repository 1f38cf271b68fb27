//! Random frames of every kind.
#![allow(dead_code, clippy::unwrap_used)]

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};

use super::Random;

pub fn any_id(random: &mut Random) -> Id {
    // Identifiers with long runs of equal bits matter most for stuffing.
    let raw = match random.below(6) {
        0 => 0,
        1 => 0x1FFF_FFFF,
        2 => 0x0F83_E0F8,
        _ => random.next() as u32 & 0x1FFF_FFFF,
    };
    if random.coin() {
        Id::Standard(StandardId::new((raw & 0x7FF) as u16).unwrap())
    } else {
        Id::Extended(ExtendedId::new(raw).unwrap())
    }
}

/// Data that is random, constant or made of runs of five.
pub fn any_data(random: &mut Random) -> [u8; 64] {
    let mut bytes = random.bytes();
    match random.below(5) {
        0 => bytes = [0x00; 64],
        1 => bytes = [0xFF; 64],
        2 => {
            let start = random.below(10);
            for (index, byte) in bytes.iter_mut().enumerate() {
                let bits = (0..8).map(|bit| (index as u64 * 8 + bit + start) / 5 % 2);
                *byte = bits.fold(0, |byte, bit| byte << 1 | bit as u8);
            }
        }
        _ => {}
    }
    bytes
}

pub fn any_classic(random: &mut Random) -> Frame {
    let format = if random.below(4) == 0 {
        Format::Remote
    } else {
        Format::Data
    };
    let dlc = Dlc::new(random.below(16) as u8).unwrap();
    Frame::from_fields(any_id(random), format, dlc, &any_data(random))
}

pub fn any_fd(random: &mut Random) -> Frame {
    let format = Format::Fd(FdFlags {
        brs: random.coin(),
        esi: random.below(4) == 0,
    });
    let dlc = Dlc::new(random.below(16) as u8).unwrap();
    Frame::from_fields(any_id(random), format, dlc, &any_data(random))
}

pub fn any_frame(random: &mut Random) -> Frame {
    if random.coin() {
        any_classic(random)
    } else {
        any_fd(random)
    }
}
