//! ECAN through the HAL: 500 kbit/s at FCY 40 MHz, two filters, the receive FIFO, a queue of four buffers.

use core::mem::MaybeUninit;

use can_frame::{Frame, Id, StandardId};
use can_hal::{
    Outcome, Polls, Receive, Region, Transmit,
    dspic33_ecan::{
        BufferCount, Can, Config, Filter, FilterTarget, Interrupts, Mask, MaskSource, Ticket, TxPriority, Use,
    },
    memory::{DsPic33EcanMemory, DsPic33EcanPlan},
    mode,
    timing::{DsPic33EcanTiming, Request},
};
use dspic33_ecan_pac::Mmio;

pub const RAM_BYTES: u32 = 0x200;
pub const TIMING: DsPic33EcanTiming = DsPic33EcanTiming::fixed(&Request::new(40_000_000, 500_000));
pub const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0, RAM_BYTES, BufferCount::Buffers16, 8).fixed();

const fn id(raw: u16) -> Id {
    match StandardId::new(raw) {
        Some(id) => Id::Standard(id),
        None => panic!("11 bits"),
    }
}

const FILTERS: [Filter; 2] = [
    Filter::new(id(0x100), MaskSource::Mask0, FilterTarget::Fifo),
    Filter::new(id(0x7DF), MaskSource::Mask1, FilterTarget::Fifo),
];
const CONFIG: Config<'static> =
    Config::new(TIMING).with_queue(4).with_filters([Mask::standard(0x700), Mask::STANDARD, Mask::ANY], &FILTERS);

type Running = Can<mode::Running, Mmio>;

#[unsafe(no_mangle)]
pub unsafe fn hal_dspic33_ecan_init(registers: usize, ram: usize, out: &mut MaybeUninit<Running>) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    let (registers, region) = unsafe { (Mmio::new(registers), Region::new(Mmio::new(ram), 0, RAM_BYTES)) };
    let Ok(mut can) = Can::new(registers, region, &PLAN, Polls(1_000)) else { return false };
    if can.configure(&CONFIG).is_err() {
        return false;
    }
    can.enable_interrupts(Interrupts::RBIF | Interrupts::ERRIF);
    let Ok(can) = can.start_normal(Polls(1_000)) else { return false };
    out.write(can);
    true
}

// quiet hal_dspic33_ecan_send
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_send(can: &mut Running, frame: &Frame) -> bool {
    Transmit::send(can, frame).is_ok()
}

// quiet hal_dspic33_ecan_receive
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_receive(can: &mut Running, out: &mut Frame) -> bool {
    match can.receive_message() {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// What has no equivalent by hand, but must not panic either.

// quiet hal_dspic33_ecan_dedicated
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_dedicated(can: &mut Running, buffer: u8, frame: &Frame) -> Option<Ticket> {
    can.send_buffer(buffer, frame).ok()
}

// quiet hal_dspic33_ecan_reply
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_reply(can: &mut Running, buffer: u8, frame: &Frame) -> bool {
    can.set_reply(buffer, frame).is_ok()
}

// quiet hal_dspic33_ecan_trait_fetch
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_trait_fetch(can: &mut Running, out: &mut Frame) -> bool {
    match Receive::fetch(can) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_dspic33_ecan_buffer
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_buffer(can: &mut Running, buffer: u8, out: &mut Frame) -> bool {
    can.receive_buffer(buffer).map(|message| *out = message.frame).is_some()
}

// quiet hal_dspic33_ecan_outcome
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_outcome(can: &mut Running, ticket: Ticket) -> Outcome {
    can.cancel(ticket);
    can.cancel_all();
    Transmit::outcome(can, ticket)
}

// quiet hal_dspic33_ecan_embedded
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_embedded(can: &mut Running, frame: &Frame) -> bool {
    embedded_can::nb::Can::transmit(can, frame).is_ok() && embedded_can::blocking::Can::receive(can).is_ok()
}

// quiet hal_dspic33_ecan_status
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_status(can: &mut Running) -> u32 {
    let status = can.module_status().status;
    let flags = can.take_interrupts();
    u32::from(status.counters.transmit) | u32::from(status.is_bus_off()) << 16 | u32::from(flags.bits())
}

/// A configuration that is not known when this is compiled.
#[unsafe(no_mangle)]
pub fn hal_dspic33_ecan_configure(can: &mut Can<mode::Configuration, Mmio>, priority: u8) -> bool {
    let config = CONFIG.with_use(7, Use::Dedicated(TxPriority::from_bits(priority)));
    can.configure(&config).is_ok()
}
