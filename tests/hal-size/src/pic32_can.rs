//! PIC32MX CAN through the common traits.
//!
//! No `quiet` lines yet: range checks of fields and indices, which never fail here, are left in their code.

use can_frame::Frame;
use can_hal::{Receive, Transmit, mode::Running, pic32_can};
use m_can_pac::Mmio;

fn fetch(can: &mut impl Receive, out: &mut Frame) -> bool {
    match can.fetch() {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

#[unsafe(no_mangle)]
pub fn hal_pic32_can_send(can: &mut pic32_can::Can<Running, Mmio>, frame: &Frame) -> bool {
    can.send(frame).is_ok()
}

#[unsafe(no_mangle)]
pub fn hal_pic32_can_fetch(can: &mut pic32_can::Can<Running, Mmio>, out: &mut Frame) -> bool {
    fetch(can, out)
}
