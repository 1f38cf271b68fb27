//! PIC32MX CAN through the HAL: 500 kbit/s at 80 MHz, two filters, a transmit FIFO, a receive FIFO.

use core::mem::MaybeUninit;

use can_frame::{Frame, Id, StandardId};
use can_hal::{
    Outcome, Polls, Receive, Region, Transmit,
    memory::{Pic32CanFifo, Pic32CanMemory, Pic32CanPlan},
    mode,
    pic32_can::{Can, Config, Filter, Interrupts, Mask, Ticket},
    timing::{Pic32CanTiming, Request},
};
use m_can_pac::Mmio;

const RAM_BYTES: u32 = 0x400;
pub const TIMING: Pic32CanTiming = Pic32CanTiming::fixed(&Request::new(80_000_000, 500_000));
const PLAN: Pic32CanPlan = Pic32CanMemory::new(0, RAM_BYTES)
    .fifo(0, Pic32CanFifo::Transmit { elements: 4 })
    .fifo(1, Pic32CanFifo::Receive { elements: 8 })
    .fixed();

const fn id(raw: u16) -> Id {
    match StandardId::new(raw) {
        Some(id) => Id::Standard(id),
        None => panic!("11 bits"),
    }
}

const FILTERS: [Filter; 2] = [Filter::new(id(0x100), 1), Filter::new(id(0x7DF), 1).with_mask(1)];
const CONFIG: Config<'static> =
    Config::new(TIMING).with_filters([Mask::ANY, Mask::EXACT, Mask::ANY, Mask::ANY], &FILTERS);

type Running = Can<mode::Running, Mmio>;

#[unsafe(no_mangle)]
pub unsafe fn hal_pic32_can_init(registers: usize, ram: usize, out: &mut MaybeUninit<Running>) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    let (registers, region) = unsafe { (Mmio::new(registers), Region::new(Mmio::new(ram), 0, RAM_BYTES)) };
    let Ok(mut can) = Can::new(registers, region, &PLAN, Polls(1_000)) else { return false };
    if can.configure(&CONFIG).is_err() {
        return false;
    }
    can.enable_interrupts(Interrupts::RECEIVE | Interrupts::ERROR_STATE);
    let Ok(can) = can.start_normal(Polls(1_000)) else { return false };
    out.write(can);
    true
}

// quiet hal_pic32_can_send
#[unsafe(no_mangle)]
pub fn hal_pic32_can_send(can: &mut Running, frame: &Frame) -> bool {
    can.send_through(0, frame).is_ok()
}

// quiet hal_pic32_can_receive
#[unsafe(no_mangle)]
pub fn hal_pic32_can_receive(can: &mut Running, out: &mut Frame) -> bool {
    match can.receive_fifo(1) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_pic32_can_trait_send
#[unsafe(no_mangle)]
pub fn hal_pic32_can_trait_send(can: &mut Running, frame: &Frame) -> Option<Ticket> {
    Transmit::send(can, frame).ok()
}

// quiet hal_pic32_can_trait_fetch
#[unsafe(no_mangle)]
pub fn hal_pic32_can_trait_fetch(can: &mut Running, out: &mut Frame) -> bool {
    match Receive::fetch(can) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_pic32_can_outcome
#[unsafe(no_mangle)]
pub fn hal_pic32_can_outcome(can: &mut Running, ticket: Ticket) -> Outcome {
    Transmit::cancel(can, ticket);
    Transmit::outcome(can, ticket)
}
