//! M_CAN through the HAL: 500 kbit/s and 2 Mbit/s at 40 MHz, two filters, an Rx FIFO, a Tx FIFO.

use core::mem::MaybeUninit;

use can_frame::{Frame, StandardId};
use can_hal::{
    Outcome, Polls, Receive, Region, Transmit,
    m_can::{Action, Can, Config, DataFieldSize, Filter, Interrupts, Line, RxFifo, StandardFilter, Ticket, TxOptions},
    memory::{MCanMemory, MCanPlan},
    mode,
    timing::{MCanTiming, Request},
};
use m_can_pac::Mmio;

pub const RAM_BYTES: u32 = 0x800;
pub const TIMING: MCanTiming = MCanTiming::fixed(&Request::new(40_000_000, 500_000).data(2_000_000));
pub const PLAN: MCanPlan = MCanMemory::new(RAM_BYTES)
    .standard_filters(2)
    .rx_fifo_0(8, DataFieldSize::Bytes64)
    .tx_buffers(0, 8, DataFieldSize::Bytes64)
    .fixed();

const fn id(raw: u16) -> StandardId {
    match StandardId::new(raw) {
        Some(id) => id,
        None => panic!("11 bits"),
    }
}

const FILTERS: [StandardFilter; 2] =
    [Filter::range(id(0x100), id(0x1FF), Action::Fifo0), Filter::exact(id(0x7DF), Action::PriorityFifo0)];
const CONFIG: Config<'static> = Config::new(TIMING).with_fd().with_filters(&FILTERS, &[]);

type Running = Can<mode::Running, Mmio>;

#[unsafe(no_mangle)]
pub unsafe fn hal_m_can_init(registers: usize, ram: usize, out: &mut MaybeUninit<Running>) -> bool {
    // SAFETY: the caller gives the addresses of the chip.
    let (registers, region) = unsafe { (Mmio::new(registers), Region::new(Mmio::new(ram), 0, RAM_BYTES)) };
    let Ok(mut can) = Can::new(registers, region, &PLAN, Polls(1_000)) else { return false };
    if can.configure(&CONFIG).is_err() {
        return false;
    }
    can.enable_interrupts(Interrupts::RF0N | Interrupts::BO, Line::Int0);
    let Ok(can) = can.start_normal(Polls(1_000)) else { return false };
    out.write(can);
    true
}

// quiet hal_m_can_send
#[unsafe(no_mangle)]
pub fn hal_m_can_send(can: &mut Running, frame: &Frame) -> bool {
    can.send_queued(frame, TxOptions::default()).is_ok()
}

// quiet hal_m_can_receive
#[unsafe(no_mangle)]
pub fn hal_m_can_receive(can: &mut Running, out: &mut Frame) -> bool {
    match can.receive_fifo(RxFifo::Fifo0) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// What has no equivalent by hand, but must not panic either.

// quiet hal_m_can_trait_send
#[unsafe(no_mangle)]
pub fn hal_m_can_trait_send(can: &mut Running, frame: &Frame) -> Option<Ticket> {
    Transmit::send(can, frame).ok()
}

// quiet hal_m_can_trait_fetch
#[unsafe(no_mangle)]
pub fn hal_m_can_trait_fetch(can: &mut Running, out: &mut Frame) -> bool {
    match Receive::fetch(can) {
        Ok(Some(message)) => {
            *out = message.frame;
            true
        }
        _ => false,
    }
}

// quiet hal_m_can_outcome
#[unsafe(no_mangle)]
pub fn hal_m_can_outcome(can: &mut Running, ticket: Ticket) -> Outcome {
    can.cancel(ticket);
    Transmit::outcome(can, ticket)
}

// quiet hal_m_can_embedded
#[unsafe(no_mangle)]
pub fn hal_m_can_embedded(can: &mut Running, frame: &Frame) -> bool {
    embedded_can::nb::Can::transmit(can, frame).is_ok() && embedded_can::blocking::Can::receive(can).is_ok()
}

// quiet hal_m_can_status
#[unsafe(no_mangle)]
pub fn hal_m_can_status(can: &mut Running) -> u32 {
    let status = can.protocol_status().status;
    let flags = can.take_interrupts();
    u32::from(status.counters.transmit) | u32::from(status.is_bus_off()) << 16 | flags.bits()
}
