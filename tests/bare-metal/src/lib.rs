//! The skeleton of a firmware: an M_CAN on an STM32H743, whose FDCAN1 it is.
//!
//! What is here is all that the HAL needs. What is not here belongs to the chip: its clock tree, pins, interrupt
//! controller and start-up code, which calls [`firmware`] and, on interrupts, [`fdcan1_line_0`].
#![no_std]

use core::{
    panic::PanicInfo,
    sync::atomic::{AtomicBool, Ordering},
};

use can_hal::{
    ExtendedId, Frame, Id, Polls, Receive, Region, RestartAfter, StandardId, Transmit,
    m_can::{Action, Can, Config, DataFieldSize, ExtendedFilter, Filter, Interrupts, Line, StandardFilter},
    memory::{MCanMemory, MCanPlan},
    mode::Running,
    timing::{MCanTiming, Request},
};
use m_can_pac::Mmio;

/// FDCAN1 and the Message RAM that it shares with FDCAN2 (STM32H743 reference manual RM0433, 2.3.2 "Memory map").
const FDCAN1: usize = 0x4000_A000;
const MESSAGE_RAM: usize = 0x4000_AC00;
const MESSAGE_RAM_BYTES: u32 = 10 * 1024;

/// `fdcan_ker_ck`, as the clock tree is set up.
const CLOCK: u32 = 80_000_000;

// A rate that the clock cannot make, or a plan that does not fit, is an error of the compiler.
const TIMING: MCanTiming = MCanTiming::fixed(&Request::new(CLOCK, 500_000).data(2_000_000));
const PLAN: MCanPlan = MCanMemory::new(MESSAGE_RAM_BYTES)
    .standard_filters(1)
    .extended_filters(1)
    .rx_fifo_0(16, DataFieldSize::Bytes64)
    .tx_buffers(0, 16, DataFieldSize::Bytes64)
    .fixed();

const ANSWER: Id = Id::Standard(match StandardId::new(0x7E8) {
    Some(id) => id,
    None => panic!("11 bits"),
});
const STANDARD: [StandardFilter; 1] = [Filter::mask(StandardId::ZERO, 0x400, Action::Fifo0)];
const EXTENDED: [ExtendedFilter; 1] = [Filter::range(ExtendedId::ZERO, ExtendedId::MAX, Action::Fifo0)];
const CONFIG: Config<'static> = Config::new(TIMING).with_fd().with_filters(&STANDARD, &EXTENDED);

/// Reads of a register while a mode changes: far more than a few periods of the CAN clock take.
const MODE: Polls = Polls(10_000);

/// The line of FDCAN1 has become active since the main loop looked.
static WORK: AtomicBool = AtomicBool::new(false);

/// The handler of `fdcan1_intr0_it`. The flags are cleared by the main loop, which owns the controller; until then the
/// interrupt controller has to keep this handler off.
#[unsafe(no_mangle)]
pub extern "C" fn fdcan1_line_0() {
    WORK.store(true, Ordering::Release);
}

/// Brings the controller on the bus.
fn start() -> Option<Can<Running>> {
    // SAFETY: these are the chip's addresses, and this function, called once, is the only one that uses them.
    let (registers, region) = unsafe { (Mmio::new(FDCAN1), Region::new(Mmio::new(MESSAGE_RAM), 0, MESSAGE_RAM_BYTES)) };
    let mut can = Can::new(registers, region, &PLAN, MODE).ok()?;
    // The Message RAM has ECC: every word is written before it is read.
    can.zero_memory();
    can.configure(&CONFIG).ok()?;
    can.enable_interrupts(Interrupts::RF0N | Interrupts::RF0L | Interrupts::BO, Line::Int0);
    can.start_normal(MODE).ok()
}

/// Answers every message with its own data. `milliseconds` is the system's clock.
#[unsafe(no_mangle)]
pub extern "C" fn firmware(milliseconds: extern "C" fn() -> u32) -> i32 {
    let Some(mut can) = start() else { return -1 };
    let mut policy = RestartAfter::new(100);
    let mut lost = 0_u32;
    loop {
        if policy.due(can.is_stopped(), u64::from(milliseconds())) && can.restart(MODE).is_err() {
            return -2;
        }
        if !WORK.swap(false, Ordering::Acquire) {
            continue;
        }
        // Clear first, then serve: what arrives meanwhile raises its flag again.
        can.take_interrupts();
        loop {
            match can.fetch() {
                Ok(Some(message)) => {
                    let format = message.frame.format();
                    let dlc = message.frame.dlc();
                    let answer = Frame::from_fields(ANSWER, format, dlc, message.frame.data_bytes());
                    // A full Tx FIFO loses the answer; the bus is slower than the questions.
                    lost += u32::from(can.send(&answer).is_err());
                }
                Ok(None) => break,
                Err(_overflow) => lost += 1,
            }
        }
        if lost > 1_000 {
            return -3;
        }
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
