//! The receive FIFO (9.3, 9.4).

use crate::bench::{Can, FIFO_5_TO_11, FRAME, add, everything, frame, kinds, peer};
use can_sim::{DiagnosticKind, PeerId, Sim};
use dspic33_ecan_pac::{
    enums::{FilterTarget, OperationMode, TxPriority},
    registers::{self as pac, Intf},
};

/// A module that takes everything into the FIFO that `fctrl` describes.
pub fn bench(fctrl: u16) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo));
    can.write_fctrl(&sim, fctrl);
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    (sim, can, other)
}

pub fn receive(sim: &Sim, other: PeerId, number: u8) {
    sim.peer_send(other, frame(&format!("100#{number:02X}")));
    sim.run_for(FRAME);
}

/// CxFIFO, RXFUL1, RXOVF1, and the flags that rose.
fn state(sim: &Sim, can: Can) -> (u16, u16, u16, Intf) {
    let regs = can.regs(sim);
    let (fifo, full, lost) = (regs.fifo().read().bits(), regs.rxful(1).read().bits(), regs.rxovf(1).read().bits());
    (fifo, full, lost, can.take_flags(sim))
}

/// Figure 9-6: the seven cases with the printed pointers, and the writes between cases 2 and 3. Case 1 of the text says
/// FNRB points to buffer 6 with the value 5; the figure has 5 (`fifo_case_1`).
#[test]
fn figure_9_6_example_of_fifo_operation() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    let none = Intf::from_bits(0);
    assert_eq!(state(&sim, can), (0x0505, 0x0000, 0, none), "case 1");
    receive(&sim, other, 1);
    assert_eq!(state(&sim, can), (0x0605, 0x0020, 0, Intf::RBIF), "case 2");
    for (number, (fifo, full)) in (2..).zip([(0x0705, 0x0060), (0x0805, 0x00E0), (0x0905, 0x01E0), (0x0A05, 0x03E0)]) {
        receive(&sim, other, number);
        assert_eq!(state(&sim, can), (fifo, full, 0, Intf::RBIF), "write {number}");
    }
    receive(&sim, other, 6);
    assert_eq!(state(&sim, can), (0x0B05, 0x07E0, 0, Intf::RBIF | Intf::FIFOIF), "case 3");
    assert_eq!(can.take(&sim, 5), Some(frame("100#01")));
    assert_eq!(state(&sim, can), (0x0B06, 0x07C0, 0, none), "case 4");
    receive(&sim, other, 7);
    assert_eq!(state(&sim, can), (0x0506, 0x0FC0, 0, Intf::RBIF | Intf::FIFOIF), "case 5");
    receive(&sim, other, 8);
    assert_eq!(state(&sim, can), (0x0606, 0x0FE0, 0, Intf::RBIF), "case 6");
    receive(&sim, other, 9);
    assert_eq!(state(&sim, can), (0x0706, 0x0FE0, 0x0040, Intf::RBOVIF), "case 7");
    // Behind the example: buffer 6 is released, but FBP has passed it, so that the next message is lost too.
    assert_eq!(can.take_from_fifo(&sim), Some(frame("100#02")));
    assert_eq!(state(&sim, can), (0x0707, 0x0FA0, 0x0040, none));
    receive(&sim, other, 10);
    assert_eq!(state(&sim, can), (0x0807, 0x0FA0, 0x00C0, Intf::RBOVIF));
    assert_eq!(sim.diagnostics(), []);
}

/// 9.3.1: messages come out in order, and both pointers wrap (`fnrb_wrap`).
#[test]
fn section_9_3_1_unloading_in_order() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    for number in 0..40 {
        receive(&sim, other, number);
        if number >= 3 {
            assert_eq!(can.take_from_fifo(&sim), Some(frame(&format!("100#{:02X}", number - 3))));
        }
    }
    let state = sim.inspect(can.id, |model| model.fifo());
    assert_eq!((state.start, state.end, state.full.len()), (5, 11, 3));
    assert_eq!(can.regs(&sim).rxovf(1).read().bits(), 0);
    assert_eq!(sim.diagnostics(), []);
}

/// 9.3: the end of the FIFO for every DMABS.
#[test]
fn section_9_3_end_by_dmabs() {
    for (code, count) in [(0, 4), (1, 6), (2, 8), (3, 12), (4, 16), (5, 24), (6, 32)] {
        let (sim, can, other) = bench(code << 13 | 2);
        for number in 0..count - 2 {
            receive(&sim, other, number);
        }
        let fifo = can.regs(&sim).fifo().read().bits();
        assert_eq!(fifo, 0x0202, "{count} buffers: wrapped, and full");
        let full =
            u32::from(can.regs(&sim).rxful(1).read().bits()) | u32::from(can.regs(&sim).rxful(2).read().bits()) << 16;
        assert_eq!(full, (u64::MAX >> (64 - count)) as u32 & !3);
        for number in 0..count - 2 {
            assert_eq!(can.take_from_fifo(&sim), Some(frame(&format!("100#{number:02X}"))));
        }
        assert_eq!(can.take_from_fifo(&sim), None);
        assert_eq!(sim.diagnostics(), []);
    }
}

/// Equation 9-4 over a whole turn: the interrupt comes with the message that leaves room for one more.
#[test]
fn equation_9_4_fifo_interrupt() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    for turn in 0..7 {
        for number in 0..7 {
            receive(&sim, other, number);
            assert_eq!(can.take_flags(&sim).fifoif(), number == 5, "turn {turn}, message {number}");
        }
        for _ in 0..7 {
            can.take_from_fifo(&sim).unwrap();
        }
        // Begin the next turn one buffer further.
        receive(&sim, other, 0xFF);
        can.take_from_fifo(&sim).unwrap();
        can.take_flags(&sim);
    }
}

/// Equation 9-4 for a FIFO of one buffer is true for every message (`one_buffer_fifo`).
#[test]
fn a_fifo_of_one_buffer() {
    let (sim, can, other) = bench(3 << 13 | 11);
    for number in 0..3 {
        receive(&sim, other, number);
        assert!(can.take_flags(&sim).fifoif());
        assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0B0B);
        assert_eq!(can.take_from_fifo(&sim), Some(frame(&format!("100#{number:02X}"))));
    }
    receive(&sim, other, 4);
    can.take_flags(&sim);
    receive(&sim, other, 5);
    // fifo_almost_full_on_loss.
    assert_eq!(can.take_flags(&sim), Intf::RBOVIF);
}

/// 9.3, 9.3.1: a transmit buffer in the FIFO area loses the message that is meant for it.
#[test]
fn section_9_3_a_transmit_buffer_in_the_fifo() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo));
    can.write_fctrl(&sim, FIFO_5_TO_11);
    can.transmit_buffer(&sim, 6, TxPriority::Lowest);
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    assert_eq!(kinds(&sim)[0].to_string(), "the FIFO from buffer 5 to 11 contains transmit buffer 6");
    receive(&sim, other, 1);
    receive(&sim, other, 2);
    assert_eq!(state(&sim, can), (0x0705, 0x0020, 0x0040, Intf::RBIF | Intf::RBOVIF));
    receive(&sim, other, 3);
    assert_eq!(state(&sim, can), (0x0805, 0x00A0, 0x0040, Intf::RBIF));
}

/// 9.3.1: buffers that are not released one after the other: FBP goes on, FNRB does not, and it is reported.
#[test]
fn section_9_3_1_released_out_of_order() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    for number in 0..3 {
        receive(&sim, other, number);
    }
    can.release(&sim, 7);
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0808);
    assert_eq!(kinds(&sim), [DiagnosticKind::AcknowledgeInvalid { register: "RXFUL", index: 7, get: 5, fill: 3 }]);
    for number in 3..7 {
        receive(&sim, other, number);
    }
    can.take_flags(&sim);
    receive(&sim, other, 7);
    assert_eq!(state(&sim, can), (0x0608, 0x0F60, 0x0020, Intf::RBOVIF), "buffer 5 was never released");
}

/// `fnrb_several_released`, `fnrb_outside_fifo`: the highest-numbered released buffer of the FIFO counts.
#[test]
fn several_buffers_released_at_once() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    for number in 0..4 {
        receive(&sim, other, number);
    }
    can.regs(&sim).rxful(1).clear(pac::Rxful::from_bits(0x00E0));
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0908);
    assert_eq!(kinds(&sim), [], "5, 6 and 7 in order");
    // A bit that was 0 counts for nothing; a buffer outside the FIFO neither.
    can.regs(&sim).rxful(1).clear(pac::Rxful::from_bits(0x0C01));
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0908);
    assert_eq!(kinds(&sim), []);
}

/// `fsa_beyond_end`: reported; messages are lost with RXOVF of the buffer FSA.
#[test]
fn the_fifo_starts_behind_the_last_buffer() {
    let (sim, can, other) = bench(3 << 13 | 20);
    assert_eq!(kinds(&sim)[0].to_string(), "the FIFO starts at buffer 20, behind the last buffer 11");
    receive(&sim, other, 1);
    assert_eq!(can.regs(&sim).rxovf(2).read().bits(), 1 << 4);
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x1414);
    assert_eq!(can.take_flags(&sim), Intf::RBOVIF);
}

/// 9.3: FNRB equal to FBP means empty or full; RXFUL tells which.
#[test]
fn section_9_3_empty_or_full() {
    let (sim, can, other) = bench(FIFO_5_TO_11);
    assert_eq!(can.take_from_fifo(&sim), None);
    for number in 0..7 {
        receive(&sim, other, number);
    }
    let fifo = can.regs(&sim).fifo().read();
    assert_eq!(fifo.fbp(), fifo.fnrb());
    assert_eq!(can.take_from_fifo(&sim), Some(frame("100#00")));
}

/// `fifo_pointer_start`: CxFIFO resets to 0 (Register 4-19) and takes FSA with CxFCTRL in Configuration mode.
#[test]
fn register_4_19_pointers() {
    let sim = Sim::new();
    let can = add(&sim, "can1");
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0);
    can.write_fctrl(&sim, FIFO_5_TO_11);
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0505);
    can.set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo)).enter(&sim, OperationMode::Normal);
    can.write_fctrl(&sim, FIFO_5_TO_11);
    assert_eq!(can.regs(&sim).fifo().read().bits(), 0, "FSA was 0 when Configuration mode was left");
}
