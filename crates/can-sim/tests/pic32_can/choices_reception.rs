//! Where the manual is silent: each choice about reception, interrupts, errors and timing, both ways.

use can_sim::{
    Sim, Time,
    pic32_can::{DeviceNetOrder, ErrorStateChanges, OverflowFlag, RemoteFlag},
};
use can_wire::{BitFault, Fault, Field, Frames, Position};
use pic32_can_pac::{
    enums::{CfgSeg2phts, ConDncnt, FltConFsel, OperationMode},
    meta::CONTROLLER,
    registers::{Con, FifoCon, FifoInt, FltCon, Int, Rxf},
};
use regbus::Bus;

use crate::{
    bench::*,
    choices::{fresh, with},
};

#[test]
fn overflow_flag_of_several_fifos() {
    for (choice, passed_over, lost) in [
        (OverflowFlag::LowestFilter, vec![], vec![0]),
        (OverflowFlag::AllFull, vec![], vec![0, 1]),
        (OverflowFlag::PassedOver, vec![0], vec![0, 1]),
    ] {
        let (sim, can) = fresh(|choices| choices.overflow_flag = choice);
        can.set_up(&sim, 0x100, &[Use::Rx(1), Use::Rx(1)]);
        can.accept_all(&sim, 0);
        can.select(&sim, 1, 0, 1, Rxf::RESET);
        can.start(&sim);
        let peer = add_peer(&sim);
        let overflowed =
            |sim: &Sim| -> Vec<usize> { (0..2).filter(|fifo| can.fifo(sim, *fifo).int_().read().rxovflif()).collect() };
        sim.peer_send(peer, frame("100#"));
        sim.peer_send(peer, frame("101#"));
        sim.run_for(FRAME * 2);
        assert_eq!(overflowed(&sim), passed_over, "{choice:?}");
        sim.peer_send(peer, frame("102#"));
        sim.run_for(FRAME);
        assert_eq!(overflowed(&sim), lost, "{choice:?}");
    }
}

#[test]
fn filhit_on_overflow() {
    for shown in [false, true] {
        let (sim, can) = fresh(|choices| choices.filhit_shows_lost = shown);
        can.set_up(&sim, 0x100, &[Use::Rx(1), Use::Rx(1)]);
        can.filter(&sim, 3, 0, 0, standard(0x100), EXACT);
        can.select(&sim, 5, 0, 1, standard(0x101));
        can.start(&sim);
        let peer = add_peer(&sim);
        for text in ["100#", "101#", "100#"] {
            sim.peer_send(peer, frame(text));
        }
        sim.run_for(FRAME * 3);
        assert_eq!(can.filhit(&sim), if shown { 3 } else { 5 });
    }
}

#[test]
fn data_frame_to_transmit_fifo() {
    for passes in [false, true] {
        let (sim, can) = fresh(|choices| choices.search_passes_transmit_fifo = passes);
        can.set_up(&sim, 0x100, &[Use::Tx(1), Use::Rx(1)]);
        can.accept_all(&sim, 0);
        can.select(&sim, 1, 0, 1, Rxf::RESET);
        can.start(&sim);
        let peer = add_peer(&sim);
        sim.peer_send(peer, frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 1).is_some(), passes);
    }
}

#[test]
fn remote_frame_to_receive_fifo() {
    for dropped in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(1)], |choices| choices.remote_frames_dropped = dropped);
        sim.peer_send(peer, frame("100#R"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 0).is_some(), !dropped);
    }
}

#[test]
fn remote_flag_of_standard_frames() {
    for (choice, bits) in [(RemoteFlag::Both, 1 << 29 | 1 << 9), (RemoteFlag::Rtr, 1 << 9), (RemoteFlag::Srr, 1 << 29)]
    {
        let (sim, can, peer) = with(&[Use::Rx(1)], |choices| choices.remote_flag = choice);
        sim.peer_send(peer, frame("100#R"));
        sim.run_for(FRAME);
        assert_eq!(can.word(&sim, 0x104), bits, "{choice:?}");
    }
}

#[test]
fn filter_enable_and_select_in_one_write() {
    for by_new_state in [false, true] {
        let (sim, can) = fresh(|choices| choices.filter_lock_by_new_state = by_new_state);
        can.set_up(&sim, 0x100, &[]);
        let control = can.regs(&sim).flt_con(0);
        let five = FltCon::RESET.with_fsel(0, FltConFsel::Fifo(5));
        control.write(five.with_flten(0, true));
        let taken = if by_new_state { FltConFsel::Fifo(0) } else { FltConFsel::Fifo(5) };
        assert_eq!((control.read().flten(0), control.read().fsel(0)), (true, taken));
        control.write(FltCon::RESET.with_fsel(0, FltConFsel::Fifo(7)));
        let taken = if by_new_state { FltConFsel::Fifo(7) } else { FltConFsel::Fifo(5) };
        assert_eq!((control.read().flten(0), control.read().fsel(0)), (false, taken));
    }
}

#[test]
fn filter_disable_delay() {
    for sticks in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(2)], |choices| choices.filter_disable_sticks = sticks);
        sim.peer_send(peer, frame("100#1122334455667788"));
        sim.run_for(Time::from_us(40));
        let control = can.regs(&sim).flt_con(0);
        control.clear_bits(FltCon::flten_bit(0));
        control.set_bits(FltCon::flten_bit(0));
        sim.run_for(FRAME);
        assert_eq!(control.read().flten(0), !sticks);
    }
}

#[test]
fn filter_change_in_other_modes() {
    for locked in [false, true] {
        let (sim, can, _) = with(&[Use::Rx(2)], |choices| choices.filters_locked_in_other_modes = locked);
        can.mode(&sim, OperationMode::ListenOnly);
        can.regs(&sim).rxf(5).write(standard(0x123));
        can.regs(&sim).flt_con(1).set_bits(FltCon::flten_bit(1));
        assert_eq!(can.regs(&sim).rxf(5).read() == standard(0x123), !locked);
        assert_eq!(can.regs(&sim).flt_con(1).read().flten(1), !locked);
    }
}

#[test]
fn devicenet_eid_order() {
    for (order, eid) in [(DeviceNetOrder::HighestFirst, 0b101 << 15), (DeviceNetOrder::LowestFirst, 0b101)] {
        let (sim, can) = fresh(|choices| choices.devicenet_order = order);
        can.set_up(&sim, 0x100, &[Use::Rx(1)]);
        can.regs(&sim).con().modify(|con| con.with_dncnt(ConDncnt::from_bits(3).unwrap()));
        can.filter(&sim, 0, 0, 0, standard(0x123).with_eid(eid), EXACT);
        can.start(&sim);
        let peer = add_peer(&sim);
        let accepts = |text: &str| {
            sim.peer_send(peer, frame(text));
            sim.run_for(FRAME);
            can.receive(&sim, 0).is_some()
        };
        assert_eq!(
            [accepts("123#A0"), accepts("123#BF"), accepts("123#80"), accepts("123#20")],
            [true, true, false, false]
        );
    }
}

#[test]
fn devicenet_mask() {
    for ignores in [false, true] {
        let (sim, can) = fresh(|choices| choices.devicenet_ignores_mask = ignores);
        can.set_up(&sim, 0x100, &[Use::Rx(1)]);
        can.regs(&sim).con().modify(|con| con.with_dncnt(ConDncnt::from_bits(8).unwrap()));
        can.filter(&sim, 0, 0, 0, standard(0x123).with_eid(0xA5 << 10), EXACT.with_eid(0));
        can.start(&sim);
        let peer = add_peer(&sim);
        sim.peer_send(peer, frame("123#11"));
        sim.run_for(FRAME);
        assert_eq!(can.receive(&sim, 0).is_some(), !ignores);
    }
}

#[test]
fn time_stamp_without_capture() {
    for keeps in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(1)], |choices| choices.unused_keeps_memory = keeps);
        sim.with_memory(can.ram, |memory| memory.words_mut()[0x40..0x44].fill(0xFFFF_FFFF));
        sim.peer_send(peer, frame("100#1122"));
        sim.run_for(FRAME);
        let expected = if keeps { (0xFFFF_0100, 0xFFFF_2211, 0xFFFF_FFFF) } else { (0x100, 0x2211, 0) };
        assert_eq!((can.word(&sim, 0x100), can.word(&sim, 0x108), can.word(&sim, 0x10C)), expected);
    }
}

#[test]
fn icod_gating() {
    for gated in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(1)], |choices| choices.icod_needs_layer_2 = gated);
        can.fifo(&sim, 0).int_().set_bits(FifoInt::RXNEMPTYIE);
        sim.peer_send(peer, frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(can.icod(&sim), if gated { 0x40 } else { 0 });
        can.regs(&sim).int_().set_bits(Int::RBIE);
        assert_eq!(can.icod(&sim), 0);
    }
}

#[test]
fn rxovf_level() {
    for latches in [false, true] {
        let (sim, can, peer) = with(&[Use::Rx(1)], |choices| choices.rxovf_latches = latches);
        sim.peer_send(peer, frame("100#"));
        sim.peer_send(peer, frame("101#"));
        sim.run_for(FRAME * 2);
        can.fifo(&sim, 0).int_().set_bits(FifoInt::RXOVFLIE);
        assert_eq!(can.regs(&sim).rxovf().read().bits(), u32::from(!latches));
        sim.peer_send(peer, frame("102#"));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).rxovf().read().bits(), 1);
        can.fifo(&sim, 0).int_().clear_bits(FifoInt::RXOVFLIF);
        assert_eq!(can.regs(&sim).rxovf().read().bits(), 0);
    }
}

#[test]
fn bus_off_recovery() {
    for stays in [false, true] {
        let (sim, can, _) = with(&[Use::Tx(1)], |choices| choices.bus_off_needs_configuration = stays);
        let node = sim.node(can.id);
        let (frames, position) = (Frames::all_of(node), Position::new(Field::Crc, 2));
        sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
        can.send(&sim, 0, &frame("100#"));
        sim.run_until(Time::from_ms(20), |sim| can_trec(sim, can) == 0xFF).unwrap();
        sim.with_wire(|wire| wire.clear_faults());
        sim.run_for(Time::from_ms(3));
        assert_eq!(can.regs(&sim).trec().read().txbo(), stays);
        can.mode(&sim, OperationMode::Configuration);
        assert!(!can.regs(&sim).trec().read().txbo());
    }
}

/// TEC and TXBO, without the time of an access.
fn can_trec(sim: &Sim, can: Can) -> u32 {
    use can_sim::Model;
    sim.inspect(can.id, |model| {
        let trec = pic32_can_pac::registers::Trec::from_bits(
            model.registers().get(model.registers().find("TREC", 0, 0).unwrap()),
        );
        if trec.txbo() { u32::from(trec.tec()) } else { 0 }
    })
}

#[test]
fn error_state_downward() {
    let told = |choice, from, to| {
        let (sim, can, _) = with(&[], |choices| choices.error_state_changes = choice);
        let node = sim.node(can.id);
        let go = |tec| {
            sim.with_wire(|wire| wire.set_error_counters(node, tec, 0));
            sim.run_for(Time::from_us(1));
        };
        go(from);
        can.clear(&sim, Int::CERRIF);
        go(to);
        can.flags(&sim).cerrif()
    };
    use ErrorStateChanges::{All, AllButLeavingWarning, Upward};
    for (choice, up, leaving_passive, leaving_warning) in
        [(AllButLeavingWarning, true, true, false), (Upward, true, false, false), (All, true, true, true)]
    {
        assert_eq!(told(choice, 95, 96), up, "{choice:?}");
        assert_eq!(told(choice, 128, 127), leaving_passive, "{choice:?}");
        assert_eq!(told(choice, 96, 95), leaving_warning, "{choice:?}");
    }
}

#[test]
fn warning_above_128() {
    for stays in [false, true] {
        let (sim, can, _) = with(&[], |choices| choices.warning_above_128 = stays);
        let node = sim.node(can.id);
        sim.with_wire(|wire| wire.set_error_counters(node, 130, 130));
        sim.run_for(Time::from_us(1));
        let trec = can.regs(&sim).trec().read();
        assert_eq!((trec.txwarn(), trec.rxwarn(), trec.ewarn()), (stays, stays, true));
    }
}

#[test]
fn segment2_automatic() {
    for reads in [false, true] {
        let (sim, can) = fresh(|choices| choices.segment2_reads_length = reads);
        can.set_up(&sim, 0x100, &[]);
        can.regs(&sim).cfg().write(CFG.with_seg2phts(CfgSeg2phts::Automatic).with_seg2ph(0));
        can.start(&sim);
        assert_eq!(can.regs(&sim).cfg().read().seg2ph(), if reads { 2 } else { 0 });
    }
}

#[test]
fn reset_duration() {
    for (clocks, polls) in [(0, 0), (10, 1), (80, 9)] {
        let (sim, can, _) = with(&[Use::Tx(1)], |choices| choices.reset_clocks = clocks);
        can.fifo(&sim, 0).con().set_bits(FifoCon::FRESET);
        let mut seen = 0;
        while can.fifo(&sim, 0).con().read().freset() {
            seen += 1;
        }
        assert_eq!(seen, polls, "{clocks} clocks of 12.5 ns at 100 ns an access");
    }
}

#[test]
fn timer_in_disable_mode() {
    for runs in [false, true] {
        let (sim, can, _) = with(&[], |choices| choices.timer_runs_in_disable = runs);
        can.regs(&sim).con().set_bits(Con::CANCAP);
        can.mode(&sim, OperationMode::Disable);
        let count = can.regs(&sim).tmr().read().cants();
        sim.run_for(Time::from_us(10));
        assert_eq!(can.regs(&sim).tmr().read().cants() != count, runs);
    }
}

/// unknown_reset_bits: 0, or a pattern, in the bits without a reset value only.
#[test]
fn unknown_reset_bits() {
    use can_sim::registers::UnknownReset;
    for unknown in [UnknownReset::Zeros, UnknownReset::Ones, UnknownReset::Pattern(7)] {
        let sim = Sim::new();
        let can = add_with(&sim, "can1", |mut config| {
            config.unknown_reset = unknown;
            config
        });
        let filter = can.regs(&sim).rxf(3).read();
        assert_eq!(filter.bits() != 0, unknown != UnknownReset::Zeros);
        assert_eq!(filter.exid(), pic32_can_pac::enums::RxfExid::Standard, "EXID is 0 after reset");
        let info = CONTROLLER.registers.iter().find(|info| info.name == "FIFOUA").unwrap();
        assert_eq!(info.reset_unknown & 3, 0);
        assert_eq!(sim.registers(can.id).read::<u32>(0x370) & 3, 0);
    }
}
