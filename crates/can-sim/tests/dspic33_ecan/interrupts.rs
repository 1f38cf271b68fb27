//! Interrupts (12.0).

use std::{cell::RefCell, rc::Rc};

use crate::bench::{ALL_FLAGS, FIFO_5_TO_11, FRAME, frame, kinds, pair, without};
use can_sim::{DiagnosticKind, Sim};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use dspic33_ecan_pac::{
    enums::{FilterNumber, InterruptCode, TxPriority},
    registers::{Inte, Intf},
};

/// Lines in the order of the description.
pub const EVENT: usize = 0;

fn enable(flags: Intf) -> Inte {
    Inte::from_bits(flags.bits())
}

/// 12.3, Figure 12-1: the event interrupt is active while a flag and its enable are set (`event_line`); flags rise
/// without their enables too (`flags_without_enable`).
#[test]
fn section_12_3_flags_and_enables() {
    let all = [Intf::TBIF, Intf::RBIF, Intf::RBOVIF, Intf::FIFOIF, Intf::ERRIF, Intf::WAKIF, Intf::IVRIF];
    for flag in all {
        let (sim, can, _) = pair();
        let intf = can.regs(&sim).intf();
        let raise = |bits: u16| {
            sim.act(can.id, |model, _| {
                use can_sim::Model;
                let slot = model.registers().find("INTF", 0, 0).unwrap();
                model.registers_mut().set(slot, u32::from(bits));
            });
        };
        raise(flag.bits());
        assert!(!sim.line(can.id, EVENT), "{flag:?} is not enabled");
        can.regs(&sim).inte().write(enable(flag));
        assert!(sim.line(can.id, EVENT));
        raise(0);
        assert!(!sim.line(can.id, EVENT));
        raise((ALL_FLAGS).bits() & !flag.bits());
        assert!(!sim.line(can.id, EVENT), "only {flag:?} is enabled");
        raise(flag.bits());
        intf.clear(flag);
        assert!(!sim.line(can.id, EVENT), "cleared by a 0");
        assert_eq!(sim.diagnostics(), []);
    }
}

/// 12.3.1: TBIF after a transmission, ICODE names the buffer.
#[test]
fn section_12_3_1_transmit_buffer_interrupt() {
    let (sim, can, _) = pair();
    can.regs(&sim).inte().write(Inte::TBIE);
    for buffer in 0..8 {
        can.transmit_buffer(&sim, buffer, TxPriority::Lowest);
        can.send(&sim, buffer, &frame("100#"));
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::NoInterrupt));
        sim.run_for(FRAME);
        assert!(sim.line(can.id, EVENT));
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::Trb(buffer as u8)));
        can.regs(&sim).intf().clear(Intf::TBIF);
        assert!(!sim.line(can.id, EVENT));
    }
}

/// 12.3.2: RBIF after RXFUL, ICODE names the buffer, FILHIT the filter; also for buffers 16 to 31.
#[test]
fn section_12_3_2_receive_buffer_interrupt() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::RBIE);
    sim.peer_send(other, frame("100#"));
    sim.run_for(FRAME);
    let vec = can.regs(&sim).vec().read();
    assert_eq!((vec.icode(), vec.filhit()), (Ok(InterruptCode::Rb(8)), Ok(FilterNumber::Filter(0))));
    can.regs(&sim).intf().clear(Intf::RBIF);
    assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::NoInterrupt));
    assert!(can.is_full(&sim, 8), "RXFUL is cleared apart from RBIF");
    let (sim, can, other) = crate::fifo::bench(6 << 13 | 30);
    can.regs(&sim).inte().write(Inte::RBIE);
    for expected in [30, 31, 30] {
        crate::fifo::receive(&sim, other, 1);
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::Rb(expected)));
        can.take_from_fifo(&sim).unwrap();
        can.take_flags(&sim);
    }
}

/// 12.3.2, note: the highest-priority condition that is active and enabled (`icode_order`).
#[test]
fn section_12_3_interrupt_code() {
    let (sim, can, other) = crate::fifo::bench(FIFO_5_TO_11);
    can.transmit_buffer(&sim, 3, TxPriority::Lowest);
    for number in 0..9 {
        crate::fifo::receive(&sim, other, number);
    }
    can.send(&sim, 3, &frame("100#"));
    sim.run_for(FRAME);
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    sim.with_wire(|wire| {
        wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
        wire.set_error_counters(node, 100, 0);
    });
    sim.peer_send(other, frame("100#00"));
    sim.run_for(FRAME);
    let regs = can.regs(&sim);
    assert_eq!(can.intf(&sim) & ALL_FLAGS, without(ALL_FLAGS, Intf::WAKIF));
    let code = |enabled: Intf| {
        regs.inte().write(enable(enabled));
        regs.vec().read().icode().unwrap()
    };
    assert_eq!(code(ALL_FLAGS), InterruptCode::Error);
    assert_eq!(code(without(ALL_FLAGS, Intf::ERRIF)), InterruptCode::Error, "icode_invalid_message");
    let rest = without(ALL_FLAGS, Intf::ERRIF | Intf::IVRIF);
    assert_eq!(code(rest), InterruptCode::ReceiverOverflow);
    assert_eq!(code(without(rest, Intf::RBOVIF)), InterruptCode::FifoAlmostFull);
    assert_eq!(code(Intf::TBIF | Intf::RBIF), InterruptCode::Rb(11), "the higher buffer");
    assert_eq!(code(Intf::TBIF), InterruptCode::Trb(3));
    assert_eq!(code(Intf::from_bits(0)), InterruptCode::NoInterrupt);
}

/// 12.3: a handler with a jump table serves everything, one code at a time.
#[test]
fn section_12_3_jump_table() {
    let (sim, can, other) = pair();
    can.regs(&sim).inte().write(Inte::TBIE | Inte::RBIE | Inte::RBOVIE);
    let served = Rc::new(RefCell::new(Vec::new()));
    let log = Rc::clone(&served);
    sim.on_interrupt(can.id, EVENT, move |sim| {
        let regs = can.regs(sim);
        let code = regs.vec().read().icode().unwrap();
        log.borrow_mut().push(code);
        match code {
            InterruptCode::Trb(_) => regs.intf().clear(Intf::TBIF),
            InterruptCode::Rb(buffer) => {
                regs.intf().clear(Intf::RBIF);
                can.take(sim, usize::from(buffer)).unwrap();
            }
            InterruptCode::ReceiverOverflow => regs.intf().clear(Intf::RBOVIF),
            other => panic!("{other:?}"),
        }
    });
    sim.peer_send(other, frame("100#"));
    sim.run_for(FRAME);
    can.send(&sim, 0, &frame("101#"));
    sim.run_for(FRAME);
    sim.peer_send(other, frame("102#"));
    sim.run_for(FRAME);
    assert_eq!(*served.borrow(), [InterruptCode::Rb(8), InterruptCode::Trb(0), InterruptCode::Rb(8)]);
    assert_eq!(sim.diagnostics(), []);
}

/// `icode_buffer`: the buffer that was served last.
#[test]
fn section_12_3_2_several_buffers_served() {
    let sim = Sim::new();
    let can = crate::bench::add(&sim, "can1").set_up(&sim);
    for (number, id, buffer) in [(0, 0x100, 12), (1, 0x200, 9)] {
        let mask = dspic33_ecan_pac::enums::MaskSource::Mask0;
        can.add_filter(&sim, crate::bench::exactly(number, mask, crate::bench::standard(id), buffer));
    }
    let other = crate::bench::peer(&sim);
    can.enter(&sim, dspic33_ecan_pac::enums::OperationMode::Normal);
    can.regs(&sim).inte().write(Inte::RBIE);
    sim.peer_send(other, frame("100#"));
    sim.peer_send(other, frame("200#"));
    sim.run_for(FRAME * 2);
    let vec = can.regs(&sim).vec().read();
    assert_eq!((vec.icode(), vec.filhit()), (Ok(InterruptCode::Rb(9)), Ok(FilterNumber::Filter(1))));
}

/// Figure 12-1: IVRIF by an error in a frame that is received, and by one in a frame that is sent
/// (`invalid_message_condition`).
#[test]
fn figure_12_1_invalid_message() {
    for sends in [false, true] {
        let (sim, can, other) = pair();
        let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
        let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
        sim.with_wire(|wire| wire.inject(fault));
        if sends {
            can.send(&sim, 0, &frame("100#00"));
        } else {
            sim.peer_send(other, frame("100#00"));
        }
        sim.run_for(FRAME);
        assert!(can.intf(&sim).ivrif());
        assert_eq!(kinds(&sim), Vec::<DiagnosticKind>::new());
    }
}

/// Clearing by the complement leaves a flag that has risen meanwhile.
#[test]
fn section_12_3_clearing_one_flag() {
    let (sim, can, other) = pair();
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(FRAME);
    assert_eq!(can.intf(&sim), Intf::TBIF);
    sim.peer_send(other, frame("101#"));
    sim.run_for(FRAME);
    can.regs(&sim).intf().clear(Intf::TBIF);
    assert_eq!(can.intf(&sim), Intf::RBIF);
    assert_eq!(sim.diagnostics(), []);
}
