//! Where the manual is silent: each choice about modes, registers and transmission, both ways.

use can_sim::{
    PeerId, Sim, Time,
    pic32_can::{Choices, DeviceState, RegistersWhileOff, UserAddress},
};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use pic32_can_pac::{
    enums::{FltConFsel, OperationMode},
    registers::{Con, FifoCon, FifoInt, Int, Tmr},
};
use regbus::Bus;

use crate::bench::*;

pub fn with(fifos: &[Use], change: impl FnOnce(&mut Choices)) -> (Sim, Can, PeerId) {
    bench_with(fifos, |config| config.with_choices(choices(change)))
}

/// A module after its reset.
pub fn fresh(change: impl FnOnce(&mut Choices)) -> (Sim, Can) {
    let sim = Sim::new();
    let can = add_with(&sim, "can1", |config| config.with_choices(choices(change)));
    (sim, can)
}

#[test]
fn mode_request_while_off() {
    for at_once in [false, true] {
        let (sim, can) = fresh(|choices| choices.request_acts_while_off = at_once);
        can.regs(&sim).con().modify(|con| con.with_reqop(OperationMode::Normal));
        let expected = if at_once { OperationMode::Normal } else { OperationMode::Configuration };
        assert_eq!(can.opmod(&sim), expected);
    }
}

#[test]
fn registers_while_off() {
    for (choice, kept, writable) in [
        (RegistersWhileOff::Kept, true, true),
        (RegistersWhileOff::Reset, false, true),
        (RegistersWhileOff::Locked, true, false),
    ] {
        let (sim, can) = fresh(|choices| choices.registers_while_off = choice);
        can.set_up(&sim, 0x100, &[Use::Rx(2)]);
        can.regs(&sim).con().clear_bits(Con::ON);
        let held = can.regs(&sim).cfg().read();
        assert_eq!(held == CFG, kept, "{choice:?}");
        can.regs(&sim).cfg().write(CFG.with_brp(9));
        assert_eq!(can.regs(&sim).cfg().read() == CFG.with_brp(9), writable, "{choice:?}");
    }
}

#[test]
fn reserved_mode_request() {
    for taken in [false, true] {
        let (sim, can, _) = with(&[Use::Rx(1)], |choices| choices.reserved_mode_taken = taken);
        let con = can.regs(&sim).con();
        con.write(Con::from_bits(con.read().bits() & !(7 << 24) | 5 << 24));
        sim.run_for(FRAME);
        assert_eq!(con.read().opmod(), if taken { Err(5) } else { Ok(OperationMode::Normal) });
    }
}

#[test]
fn configuration_entry_wait() {
    for waits in [true, false] {
        let (sim, can, peer) = with(&[Use::Tx(2)], |choices| choices.configuration_waits = waits);
        can.send(&sim, 0, &frame("100#1122334455667788"));
        sim.run_for(Time::from_us(40));
        can.mode(&sim, OperationMode::Configuration);
        sim.run_for(FRAME * 2);
        assert_eq!(heard(&sim, peer).len(), usize::from(waits));
    }
}

#[test]
fn mode_entry() {
    for at_once in [false, true] {
        let (sim, can) = fresh(|choices| choices.mode_shown_at_once = at_once);
        can.set_up(&sim, 0x100, &[]);
        can.regs(&sim).con().modify(|con| con.with_reqop(OperationMode::Normal));
        sim.run_for(Time::from_us(2));
        assert_eq!(can.opmod(&sim) == OperationMode::Normal, at_once);
    }
}

#[test]
fn canbusy_while_idle() {
    for only in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(2)], |choices| choices.busy_only_with_message = only);
        assert_eq!(can.regs(&sim).con().read().canbusy(), !only);
        sim.peer_send(peer, frame("100#1122334455667788"));
        sim.run_for(Time::from_us(40));
        assert!(can.regs(&sim).con().read().canbusy());
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).con().read().canbusy(), !only);
    }
}

#[test]
fn own_frames() {
    for received in [false, true] {
        let (sim, can, _) = with(&[Use::Tx(2), Use::Rx(2)], |choices| choices.own_frames_received = received);
        can.send(&sim, 0, &frame("100#11"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 1).is_some(), received);
    }
}

#[test]
fn wakeup_flag_in_disable() {
    for flagged in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(2)], |choices| choices.wake_in_disable = flagged);
        let _other = add_peer(&sim);
        can.mode(&sim, OperationMode::Disable);
        sim.peer_send(peer, frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(can.flags(&sim).wakif(), flagged);
        assert_eq!(sim.inspect(can.id, |model| model.device_state()), DeviceState::Run);
    }
}

#[test]
fn error_counters_on_configuration() {
    for clears in [true, false] {
        let (sim, can, _) = with(&[], |choices| choices.configuration_clears_counters = clears);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_error_counters(node, 33, 0));
        sim.run_for(Time::from_us(1));
        can.mode(&sim, OperationMode::Configuration);
        assert_eq!(can.regs(&sim).trec().read().tec(), if clears { 0 } else { 33 });
    }
}

/// As a driver in use does it: the control byte of one filter by itself.
#[test]
fn narrow_access() {
    for allowed in [false, true] {
        let (sim, can) = fresh(|choices| choices.narrow_accesses = allowed);
        can.set_up(&sim, 0x100, &[]);
        sim.registers(can.id).write(0x0C2, 0x85_u8);
        let control = can.regs(&sim).flt_con(0).read();
        assert_eq!((control.flten(2), control.fsel(2) == FltConFsel::Fifo(5)), (allowed, allowed));
        assert_eq!(control.bits() & 0xFF00_FFFF, 0);
        assert_eq!(sim.diagnostics().is_empty(), allowed);
    }
}

#[test]
fn alias_write_as_read() {
    for reads in [false, true] {
        let (sim, can, _) = with(&[Use::Tx(2)], |choices| choices.alias_write_reads = reads);
        let node = sim.node(can.id);
        let position = Position::new(Field::Data, 3);
        sim.with_wire(|wire| {
            wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() });
        });
        can.send(&sim, 0, &frame("100#55"));
        sim.run_for(FRAME * 2);
        can.fifo(&sim, 0).con().set_bits(FifoCon::RTREN);
        assert_eq!(can.fifo(&sim, 0).con().read().txerr(), !reads);
    }
}

#[test]
fn timer_alias_write() {
    for restarts in [true, false] {
        let (sim, can, _) = with(&[], |choices| choices.alias_write_restarts_timer = restarts);
        can.regs(&sim).con().set_bits(Con::CANCAP);
        can.regs(&sim).tmr().write(Tmr::RESET.with_cantspre(8_000));
        for _ in 0..20 {
            sim.run_for(Time::from_us(90));
            can.regs(&sim).tmr().clear_bits(Tmr::ZERO);
        }
        assert_eq!(can.regs(&sim).tmr().read().cants() == 0, restarts);
    }
}

#[test]
fn status_flag_writes() {
    for settable in [false, true] {
        let (sim, can, _) = with(&[Use::Rx(1)], |choices| choices.flags_can_be_set = settable);
        can.regs(&sim).int_().set_bits(Int::from_bits(1 << 14));
        can.fifo(&sim, 0).int_().set_bits(FifoInt::from_bits(8));
        assert_eq!(can.flags(&sim).wakif(), settable);
        assert_eq!(can.fifo(&sim, 0).int_().read().rxovflif(), settable);
        assert_eq!(sim.diagnostics().len(), 2, "reported either way");
    }
}

#[test]
fn user_address_in_configuration() {
    for (choice, expected) in [(UserAddress::Present, 0x200), (UserAddress::Before, 0x110), (UserAddress::Zero, 0)] {
        let (sim, can, _) = with(&[Use::Tx(2)], |choices| choices.user_address = choice);
        can.queue(&sim, 0, &frame("100#"));
        can.mode(&sim, OperationMode::Configuration);
        can.base(&sim, 0x200);
        assert_eq!(can.fifo(&sim, 0).ua().read().bits(), expected, "{choice:?}");
        can.start(&sim);
        assert_eq!(can.fifo(&sim, 0).ua().read().bits(), 0x200);
    }
}

#[test]
fn uinc_at_limit() {
    for passes in [false, true] {
        let (sim, can, _) = with(&[Use::Rx(4)], |choices| choices.uinc_passes_limit = passes);
        can.advance(&sim, 0);
        assert_eq!(can.fifo(&sim, 0).ua().read().bits(), if passes { 0x110 } else { 0x100 });
    }
}

#[test]
fn txen_change() {
    for locked in [false, true] {
        let (sim, can, _) = with(&[Use::Rx(1)], |choices| choices.txen_locked = locked);
        can.fifo(&sim, 0).con().set_bits(FifoCon::TXEN);
        assert_eq!(can.fifo(&sim, 0).int_().read().txemptyif(), !locked);
        assert_eq!(sim.diagnostics().len(), 1);
    }
}

#[test]
fn txreq_on_empty_fifo() {
    for waits in [false, true] {
        let (sim, can, peer) = with(&[Use::Tx(2)], |choices| choices.txreq_waits_for_message = waits);
        can.request(&sim, 0);
        assert_eq!(can.fifo(&sim, 0).con().read().txreq(), waits);
        can.queue(&sim, 0, &frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(heard(&sim, peer).len(), usize::from(waits));
    }
}

#[test]
fn txreq_in_passive_modes() {
    for withdrawn in [false, true] {
        let (sim, can, peer) = with(&[Use::Tx(2)], |choices| choices.txreq_withdrawn_in_passive_modes = withdrawn);
        sim.peer_send(peer, frame("000#1122334455667788"));
        sim.run_for(Time::from_us(20));
        can.send(&sim, 0, &frame("100#"));
        can.mode(&sim, OperationMode::Disable);
        assert_eq!(can.fifo(&sim, 0).con().read().txreq(), !withdrawn);
        can.start(&sim);
        sim.run_for(FRAME);
        assert_eq!(heard(&sim, peer).len(), usize::from(!withdrawn));
    }
}

#[test]
fn txreq_after_fifo_reset() {
    for survives in [false, true] {
        let (sim, can, peer) = with(&[Use::Tx(2)], |choices| {
            choices.txreq_survives_reset = survives;
            choices.txreq_waits_for_message = survives;
        });
        sim.peer_send(peer, frame("000#1122334455667788"));
        sim.run_for(Time::from_us(20));
        can.send(&sim, 0, &frame("100#"));
        can.fifo(&sim, 0).con().set_bits(FifoCon::FRESET);
        sim.run_for(Time::from_us(1));
        assert_eq!(can.fifo(&sim, 0).con().read().txreq(), survives);
        sim.run_for(FRAME * 2);
        assert_eq!(heard(&sim, peer), Vec::<String>::new());
    }
}

#[test]
fn partial_abort() {
    for flagged in [false, true] {
        let (sim, can, _) = with(&[Use::Tx(2)], |choices| choices.partial_abort_sets_flag = flagged);
        can.send(&sim, 0, &frame("100#1122334455667788"));
        can.send(&sim, 0, &frame("101#"));
        sim.run_for(Time::from_us(40));
        can.fifo(&sim, 0).con().clear_bits(FifoCon::TXREQ);
        sim.run_for(FRAME * 2);
        let con = can.fifo(&sim, 0).con().read();
        assert_eq!((con.txreq(), con.txabat()), (false, flagged));
    }
}
