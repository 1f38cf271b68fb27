//! CAN FD through the HAL: 500 kbit/s and 2 Mbit/s at 40 MHz, two filters, a receive FIFO, a transmit FIFO.

use core::mem::MaybeUninit;

use can_frame::{Frame, StandardId};
use can_hal::{
    Outcome, Polls, Receive, Region, Transmit,
    dspic33_canfd::{Can, Config, Filter, MainFlags, PayloadSize, Ticket, TxOptions},
    memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan},
    mode,
    timing::{DsPic33CanFdTiming, Request},
};
use dspic33_canfd_pac::Mmio;

pub const RAM: u32 = 0x1000;
const RAM_BYTES: u32 = 0x1000;
pub const TIMING: DsPic33CanFdTiming = DsPic33CanFdTiming::fixed(&Request::new(40_000_000, 500_000).data(2_000_000));
const PLAN: DsPic33CanFdPlan = DsPic33CanFdMemory::new(RAM, RAM_BYTES)
    .fifo(1, DsPic33CanFdFifo::Receive { elements: 8, payload: PayloadSize::Bytes64, timestamps: false })
    .fifo(2, DsPic33CanFdFifo::Transmit { elements: 8, payload: PayloadSize::Bytes64 })
    .fixed();

const fn id(raw: u16) -> StandardId {
    match StandardId::new(raw) {
        Some(id) => id,
        None => panic!("11 bits"),
    }
}

const FILTERS: [Filter; 2] = [Filter::standard_mask(id(0x100), 0x700, 1), Filter::standard(id(0x7DF), 1)];
const CONFIG: Config<'static> = Config::new(TIMING).with_fd().with_filters(&FILTERS);

type Running = Can<mode::Running, Mmio>;

#[unsafe(no_mangle)]
pub unsafe fn hal_dspic33_canfd_init(registers: usize, ram: usize, out: &mut MaybeUninit<Running>) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    let (registers, region) = unsafe { (Mmio::new(registers), Region::new(Mmio::new(ram), RAM, RAM_BYTES)) };
    let Ok(mut can) = Can::new(registers, region, &PLAN, Polls(1_000)) else { return false };
    if can.configure(&CONFIG).is_err() {
        return false;
    }
    can.enable_interrupts(MainFlags::RXIF | MainFlags::CERRIF);
    let Ok(can) = can.start_normal(Polls(1_000)) else { return false };
    out.write(can);
    true
}

// quiet hal_dspic33_canfd_send
#[unsafe(no_mangle)]
pub fn hal_dspic33_canfd_send(can: &mut Running, frame: &Frame) -> bool {
    can.send_fifo(2, frame, TxOptions::default()).is_ok()
}

// quiet hal_dspic33_canfd_receive
#[unsafe(no_mangle)]
pub fn hal_dspic33_canfd_receive(can: &mut Running, out: &mut Frame) -> bool {
    match can.receive_fifo(1) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_dspic33_canfd_trait_send
#[unsafe(no_mangle)]
pub fn hal_dspic33_canfd_trait_send(can: &mut Running, frame: &Frame) -> Option<Ticket> {
    Transmit::send(can, frame).ok()
}

// quiet hal_dspic33_canfd_trait_fetch
#[unsafe(no_mangle)]
pub fn hal_dspic33_canfd_trait_fetch(can: &mut Running, out: &mut Frame) -> bool {
    match Receive::fetch(can) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_dspic33_canfd_outcome
#[unsafe(no_mangle)]
pub fn hal_dspic33_canfd_outcome(can: &mut Running, ticket: Ticket) -> Outcome {
    Transmit::cancel(can, ticket);
    Transmit::outcome(can, ticket)
}
