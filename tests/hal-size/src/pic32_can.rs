//! PIC32MX CAN through the common traits.

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

// quiet hal_pic32_can_send
#[unsafe(no_mangle)]
pub fn hal_pic32_can_send(can: &mut pic32_can::Can<Running, Mmio>, frame: &Frame) -> bool {
    can.send(frame).is_ok()
}

// quiet hal_pic32_can_fetch
#[unsafe(no_mangle)]
pub fn hal_pic32_can_fetch(can: &mut pic32_can::Can<Running, Mmio>, out: &mut Frame) -> bool {
    fetch(can, out)
}
