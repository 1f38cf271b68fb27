//! Interrupts (12.0).

use can_hal::{
    Events, InterruptSet, Transmit,
    dspic33_ecan::{InterruptCode, Interrupts, Mask},
};

use crate::bench::{Bench, CONFIG, FIFO_5_TO_11, FRAME, PLAN, frame};

const EVENT: usize = 0;

/// 12.3: a jump table by ICODE serves one condition at a time until none is left.
#[test]
fn section_12_3_jump_table() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(1));
    can.enable_interrupts(Interrupts::TBIF | Interrupts::RBIF | Interrupts::RBOVIF);
    assert_eq!(can.interrupt_code(), Ok(InterruptCode::NoInterrupt));
    can.send(&frame("101#")).unwrap();
    bench.sim.run_for(FRAME);
    bench.send(other, &["100#01", "100#02"]);
    let mut served = Vec::new();
    while bench.sim.line(bench.id, EVENT) {
        let code = can.interrupt_code().unwrap();
        served.push(code);
        match code {
            InterruptCode::Trb(_) => can.clear_interrupts(Interrupts::TBIF),
            InterruptCode::Rb(buffer) => {
                can.clear_interrupts(Interrupts::RBIF);
                assert_eq!(can.receive_buffer(buffer).map(|message| message.frame), Some(frame("100#01")));
            }
            InterruptCode::ReceiverOverflow => can.clear_interrupts(Interrupts::RBOVIF),
            other => panic!("{other:?}"),
        }
    }
    assert_eq!(served, [InterruptCode::ReceiverOverflow, InterruptCode::Rb(8), InterruptCode::Trb(0)]);
    assert_eq!(can.last_filter(), 0);
    bench.finish();
}

/// 12.3: flags rise without their enables, and the line follows both.
#[test]
fn section_12_3_enables() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG);
    bench.send(other, &["100#01"]);
    assert!(can.interrupt_flags().contains(Interrupts::RBIF) && !bench.sim.line(bench.id, EVENT));
    can.enable_interrupts(Interrupts::RBIF | Interrupts::TBIF);
    assert!(bench.sim.line(bench.id, EVENT));
    can.disable_interrupts(Interrupts::RBIF);
    assert!(!bench.sim.line(bench.id, EVENT));
    can.enable_interrupts(Interrupts::RBIF);
    assert_eq!(can.take_interrupts().events(), Events::RECEIVED);
    assert!(!bench.sim.line(bench.id, EVENT));
    bench.finish();
}

/// 9.3.1, Equation 9-4: the FIFO tells before it is full, so that nothing is lost.
#[test]
fn equation_9_4_fifo_interrupt() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&FIFO_5_TO_11, &CONFIG.with_filters([Mask::ANY; 3], crate::bench::TO_FIFO));
    can.enable_interrupts(Interrupts::FIFOIF);
    let mut received = 0;
    for number in 0..50_u8 {
        bench.send(other, &[&format!("100#{number:02X}")]);
        if bench.sim.line(bench.id, EVENT) {
            can.clear_interrupts(Interrupts::FIFOIF);
            while let Some(message) = can.receive_message().unwrap() {
                assert_eq!(message.frame.data_bytes()[0], received);
                received += 1;
            }
        }
    }
    assert!(received >= 42, "{received}");
    bench.finish();
}
