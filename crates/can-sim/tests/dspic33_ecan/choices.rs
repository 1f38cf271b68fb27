//! The named choices both ways.

use crate::bench::{
    Can, FIFO_5_TO_11, FRAME, add_choosing, everything, exactly, frame, kinds, peer, received, standard,
};
use can_sim::{
    PeerId, Sim, Time,
    dspic33_ecan::{BytesBeyondDlc, Choices, FifoPointerStart, IcodeOrder, ListenAllDestination},
};
use can_wire::{BitFault, Fault, Field, Frames, Level, Position};
use dspic33_ecan_pac::{
    enums::{Ctrl1Win, FilterTarget, InterruptCode, MaskSource, OperationMode, TxPriority},
    registers::{self as pac, Inte, Intf},
};

/// As `pair`, with a choice.
fn bench(change: impl FnOnce(&mut Choices)) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_choosing(&sim, "can1", change).set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(8)));
    let other = peer(&sim);
    can.transmit_buffer(&sim, 0, TxPriority::Lowest).enter(&sim, OperationMode::Normal);
    (sim, can, other)
}

/// Everything into the FIFO 5 to 11.
fn fifo(change: impl FnOnce(&mut Choices)) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_choosing(&sim, "can1", change).set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo));
    can.write_fctrl(&sim, FIFO_5_TO_11);
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    (sim, can, other)
}

fn receive(sim: &Sim, other: PeerId, text: &str) {
    sim.peer_send(other, frame(text));
    sim.run_for(FRAME);
}

fn set_counters(sim: &Sim, can: Can, tec: u16, rec: u16) {
    let node = sim.node(can.id);
    sim.with_wire(|wire| wire.set_error_counters(node, tec, rec));
    sim.run_for(Time::from_us(1));
}

/// The module's next frames meet an error in their first data bit.
fn fail(sim: &Sim, can: Can, count: u32) {
    let (node, position) = (sim.node(can.id), Position::new(Field::Data, 0));
    let frames = Frames { count, ..Frames::next_of(node) };
    sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertDriven, position, frames }));
}

#[test]
fn configuration_on_request() {
    for clears in [false, true] {
        let (sim, can, _) = bench(|c| c.configuration_clears_counters = clears);
        set_counters(&sim, can, 130, 20);
        can.enter(&sim, OperationMode::Configuration);
        assert_eq!(can.regs(&sim).ec().read().bits(), if clears { 0 } else { 0x8214 });
        assert_eq!(can.intf(&sim).txbp(), !clears);
    }
}

#[test]
fn bus_off_recovery() {
    for automatic in [true, false] {
        let (sim, can, _) = bench(|c| c.automatic_bus_off_recovery = automatic);
        set_counters(&sim, can, 250, 0);
        fail(&sim, can, 1);
        can.send(&sim, 0, &frame("100#00"));
        sim.run_until(FRAME * 2, |sim| can.intf(sim).txbo()).unwrap();
        sim.run_for(Time::from_us(129 * 11));
        assert_eq!(can.intf(&sim).txbo(), !automatic);
        if !automatic {
            can.enter(&sim, OperationMode::Configuration).enter(&sim, OperationMode::Normal);
            assert!(can.intf(&sim).txbo());
            sim.run_for(Time::from_us(129 * 11));
            assert!(!can.intf(&sim).txbo());
        }
    }
}

#[test]
fn terrcnt_in_bus_off() {
    // 250 + 8 are 258.
    for (saturates, shown) in [(true, 255), (false, 2)] {
        let (sim, can, _) = bench(|c| {
            c.terrcnt_saturates = saturates;
            c.automatic_bus_off_recovery = false;
        });
        set_counters(&sim, can, 250, 0);
        fail(&sim, can, 1);
        can.send(&sim, 0, &frame("100#00"));
        sim.run_until(FRAME * 2, |sim| can.intf(sim).txbo()).unwrap();
        assert_eq!(can.regs(&sim).ec().read().terrcnt(), shown);
    }
}

#[test]
fn mode_change_with_pending_messages() {
    for survive in [true, false] {
        let (sim, can, other) = bench(|c| c.requests_survive_mode_change = survive);
        sim.peer_send(other, frame("010#0011223344556677"));
        sim.run_for(Time::from_us(20));
        can.send(&sim, 0, &frame("100#"));
        can.enter(&sim, OperationMode::Disable).enter(&sim, OperationMode::Normal);
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other).len(), usize::from(survive));
        assert_eq!(can.outcome(&sim, 0), (false, !survive, false, false));
    }
}

#[test]
fn listen_all_destination() {
    for (choice, buffer, filter) in [
        (ListenAllDestination::FirstFilter, 9, 3),
        (ListenAllDestination::Buffer0, 0, 0),
        (ListenAllDestination::Fifo, 5, 0),
    ] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.listen_all_destination = choice).set_up(&sim);
        can.add_filter(&sim, exactly(3, MaskSource::Mask0, standard(0x123), 9));
        can.write_fctrl(&sim, FIFO_5_TO_11);
        let other = peer(&sim);
        can.enter(&sim, OperationMode::ListenAll);
        receive(&sim, other, "456#01");
        assert_eq!(can.words(&sim, buffer)[7], filter << 8);
        assert_eq!(can.take(&sim, usize::from(buffer)), Some(frame("456#01")), "{choice:?}");
    }
}

#[test]
fn listen_all_broken_message() {
    for stores in [true, false] {
        let (sim, can, other) = bench(|c| c.listen_all_stores_broken = stores);
        can.enter(&sim, OperationMode::ListenAll);
        let (node, position) = (sim.node(can.id), Position::new(Field::Crc, 0));
        let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
        sim.with_wire(|wire| wire.inject(fault));
        sim.peer_send(other, frame("100#0102"));
        sim.run_until(FRAME, |sim| can.intf(sim).ivrif()).unwrap();
        assert_eq!(can.is_full(&sim, 8), stores);
    }
}

#[test]
fn loopback_pins() {
    for drives in [false, true] {
        let (sim, can, _) = bench(|c| c.loopback_drives_pin = drives);
        can.enter(&sim, OperationMode::Loopback);
        can.send(&sim, 0, &frame("100#"));
        let dominant = |sim: &Sim| can.on_wire(sim, |wire, node| wire.tx_level(node)) == Level::Dominant;
        let mut seen = false;
        for _ in 0..60 {
            sim.run_for(Time::from_us(1));
            seen |= dominant(&sim);
        }
        assert_eq!(seen, drives);
        sim.run_for(FRAME);
        assert!(can.is_full(&sim, 8));
    }
}

#[test]
fn txreq_on_receive_buffer() {
    for sends in [false, true] {
        let (sim, can, other) = bench(|c| c.receive_buffer_is_sent = sends);
        can.send(&sim, 3, &frame("100#"));
        sim.run_for(FRAME);
        assert_eq!(received(&sim, other).len(), usize::from(sends));
        assert_eq!(kinds(&sim).len(), 1);
    }
}

#[test]
fn frames_on_transmit_buffers() {
    for overflows in [false, true] {
        for rtren in [false, true] {
            let sim = Sim::new();
            let can = add_choosing(&sim, "can1", |c| {
                c.data_frame_on_remote_buffer_overflows = overflows;
                c.frame_on_transmit_buffer_overflows = overflows;
            });
            can.set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(2)));
            can.transmit_buffer(&sim, 2, TxPriority::Lowest);
            let (control, lane) = can.regs(&sim).tr_con_of(2);
            control.write(control.read().with_rtren(lane, rtren));
            let other = peer(&sim);
            can.enter(&sim, OperationMode::Normal);
            receive(&sim, other, "100#01");
            assert_eq!((can.has_overflown(&sim, 2), can.intf(&sim).rbovif()), (overflows, overflows));
        }
    }
}

#[test]
fn txerr_clearing() {
    for stays in [true, false] {
        let (sim, can, other) = bench(|c| c.txerr_stays = stays);
        fail(&sim, can, 1);
        can.send(&sim, 0, &frame("100#00"));
        sim.run_for(FRAME * 2);
        assert_eq!(received(&sim, other), ["100#00"]);
        assert_eq!(can.outcome(&sim, 0).3, stays);
    }
}

#[test]
fn bytes_beyond_dlc() {
    for (choice, words) in [
        (BytesBeyondDlc::Zero, [0x0201, 0x0003, 0]),
        (BytesBeyondDlc::Kept, [0x0201, 0xEE03, 0xEEEE]),
        (BytesBeyondDlc::PreviousMessage, [0x0201, 0x1103, 0x1111]),
    ] {
        let (sim, can, other) = bench(|c| c.bytes_beyond_dlc = choice);
        receive(&sim, other, "100#1111111111111111");
        can.release(&sim, 8);
        can.set_words(&sim, 8, &[0xEEEE; 8]);
        receive(&sim, other, "100#010203");
        assert_eq!(can.words(&sim, 8)[3..6], words, "{choice:?}");
    }
}

#[test]
fn fifo_pointer_start() {
    for (choice, after_write, on_bus, stored) in [
        (FifoPointerStart::Configuration, 0x0505, 0x0505, 0x0605),
        (FifoPointerStart::EveryWrite, 0x0505, 0x0808, 0x0908),
        (FifoPointerStart::FirstMessage, 0, 0, 0x0908),
    ] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.fifo_pointer_start = choice).set_up(&sim);
        can.add_filter(&sim, everything(FilterTarget::Fifo)).write_fctrl(&sim, FIFO_5_TO_11);
        let pointers = |sim: &Sim| can.regs(sim).fifo().read().bits();
        assert_eq!(pointers(&sim), after_write, "{choice:?}");
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        can.write_fctrl(&sim, 0x6008);
        assert_eq!(pointers(&sim), on_bus, "{choice:?}");
        receive(&sim, other, "100#");
        assert_eq!(pointers(&sim), stored, "{choice:?}");
    }
}

#[test]
fn fnrb_wrap() {
    for (wraps, fnrb) in [(true, 5), (false, 12)] {
        let (sim, can, other) = fifo(|c| c.fnrb_wraps = wraps);
        for _ in 0..7 {
            receive(&sim, other, "100#");
        }
        for buffer in 5..12 {
            can.release(&sim, buffer);
        }
        assert_eq!(can.regs(&sim).fifo().read().bits(), 0x0500 | fnrb);
    }
}

#[test]
fn fnrb_outside_fifo() {
    for follows in [false, true] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.fnrb_follows_every_buffer = follows).set_up(&sim);
        can.add_filter(&sim, everything(FilterTarget::Buffer(2))).write_fctrl(&sim, FIFO_5_TO_11);
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        receive(&sim, other, "100#");
        can.release(&sim, 2);
        assert_eq!(can.regs(&sim).fifo().read().bits(), if follows { 0x0503 } else { 0x0505 });
    }
}

#[test]
fn fsa_beyond_end() {
    for loses in [true, false] {
        let (sim, can, other) = fifo(|c| c.fsa_beyond_end_loses = loses);
        can.enter(&sim, OperationMode::Configuration).write_fctrl(&sim, 3 << 13 | 30);
        can.enter(&sim, OperationMode::Normal);
        for _ in 0..2 {
            receive(&sim, other, "100#");
        }
        assert_eq!(can.regs(&sim).rxful(2).read().bits(), if loses { 0 } else { 0xC000 });
        assert_eq!(can.regs(&sim).fifo().read().bits(), 0x1E1E, "31 is followed by FSA");
        assert_eq!(can.has_overflown(&sim, 30), loses);
    }
}

#[test]
fn pointer_beyond_buffers() {
    for stores in [true, false] {
        let (sim, can, other) = bench(|c| c.pointer_beyond_buffers_stores = stores);
        can.write_fctrl(&sim, 0);
        receive(&sim, other, "100#");
        assert_eq!((can.is_full(&sim, 8), can.has_overflown(&sim, 8)), (stores, !stores));
    }
}

/// Filter 0 points to a FIFO that is full, filter 1 to an empty buffer.
#[test]
fn fifo_among_several_filters() {
    for when_empty in [true, false] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.fifo_counts_when_empty = when_empty).set_up(&sim);
        let first =
            crate::bench::Filter { target: FilterTarget::Fifo, ..exactly(0, MaskSource::Mask0, standard(0x100), 0) };
        can.add_filter(&sim, first).add_filter(&sim, exactly(1, MaskSource::Mask0, standard(0x100), 2));
        can.write_fctrl(&sim, 3 << 13 | 11);
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        receive(&sim, other, "100#01");
        receive(&sim, other, "100#02");
        assert_eq!((can.is_full(&sim, 2), can.has_overflown(&sim, 11)), (when_empty, !when_empty));
    }
}

#[test]
fn devicenet_mask() {
    for masked in [true, false] {
        let (sim, can, other) = bench(|c| c.devicenet_masked = masked);
        can.add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x100), 8));
        can.regs(&sim).ctrl2().write(pac::Ctrl2::RESET.with_dncnt(dspic33_ecan_pac::enums::Ctrl2Dncnt::DataBits(8)));
        receive(&sim, other, "100#55");
        assert_eq!(can.is_full(&sim, 8), masked, "the mask's EID is 0, the filter's too");
    }
}

#[test]
fn invalid_message_condition() {
    for includes in [true, false] {
        let (sim, can, _) = bench(|c| c.invalid_message_includes_transmitted = includes);
        fail(&sim, can, 1);
        can.send(&sim, 0, &frame("100#00"));
        sim.run_for(FRAME * 2);
        assert_eq!(can.intf(&sim).ivrif(), includes);
    }
}

#[test]
fn icode_invalid_message() {
    for (is_error, code) in [(true, InterruptCode::Error), (false, InterruptCode::NoInterrupt)] {
        let (sim, can, _) = bench(|c| c.invalid_message_is_error_code = is_error);
        can.regs(&sim).inte().write(Inte::IVRIE);
        fail(&sim, can, 1);
        can.send(&sim, 0, &frame("100#00"));
        sim.run_for(FRAME * 2);
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(code));
        assert!(sim.line(can.id, 0));
    }
}

#[test]
fn icode_order() {
    for (order, code) in [
        (IcodeOrder::HighestFirst, InterruptCode::ReceiverOverflow),
        (IcodeOrder::LowestCodeFirst, InterruptCode::Trb(0)),
    ] {
        let (sim, can, other) = bench(|c| c.icode_order = order);
        can.regs(&sim).inte().write(Inte::from_bits((Intf::TBIF | Intf::RBIF | Intf::RBOVIF).bits()));
        receive(&sim, other, "100#");
        receive(&sim, other, "100#");
        can.send(&sim, 0, &frame("101#"));
        sim.run_for(FRAME);
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(code), "{order:?}");
    }
}

#[test]
fn icode_buffer() {
    for (last, code) in [(true, 9), (false, 12)] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.icode_names_last_buffer = last).set_up(&sim);
        can.add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x100), 12));
        can.add_filter(&sim, exactly(1, MaskSource::Mask0, standard(0x200), 9));
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        can.regs(&sim).inte().write(Inte::RBIE);
        receive(&sim, other, "100#");
        receive(&sim, other, "200#");
        assert_eq!(can.regs(&sim).vec().read().icode(), Ok(InterruptCode::Rb(code)));
    }
}

#[test]
fn information_processing_time() {
    for quanta in [1, 2] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.information_processing_time = quanta).set_up(&sim);
        can.regs(&sim).cfg2().write(pac::Cfg2::RESET.with_prseg(7).with_seg1ph(0));
        can.enter(&sim, OperationMode::Normal);
        let timing = can.on_wire(&sim, |wire, node| wire.config(node).nominal);
        assert_eq!(timing.phase_seg2, u16::from(quanta));
    }
}

#[test]
fn segment2_and_jump_width() {
    for reported in [false, true] {
        let sim = Sim::new();
        let can = add_choosing(&sim, "can1", |c| c.equal_jump_width_reported = reported).set_up(&sim);
        can.regs(&sim).cfg1().write(crate::bench::CFG1.with_brp(1));
        can.regs(&sim).cfg2().write(crate::bench::CFG2.with_seg2ph(3));
        can.enter(&sim, OperationMode::Normal);
        assert_eq!(kinds(&sim).len(), usize::from(reported));
    }
}

/// A message arrives, and one is sent, while the filter window is open.
#[test]
fn dma_in_filter_window() {
    for ignores in [true, false] {
        let (sim, can, other) = bench(|c| c.dma_ignores_window = ignores);
        can.add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x100), 8));
        can.write(&sim, 0, &frame("200#55"));
        sim.peer_send(other, frame("010#0011223344556677"));
        sim.peer_send(other, frame("100#AA"));
        can.request(&sim, 0);
        let ctrl1 = can.regs(&sim).ctrl1();
        ctrl1.modify(|value| value.with_win(Ctrl1Win::Filter));
        sim.run_for(FRAME * 3);
        ctrl1.modify(|value| value.with_win(Ctrl1Win::Buffer));
        let filter = 0x100 << 5;
        assert_eq!(can.words(&sim, 8)[0], if ignores { 0x0400 } else { filter }, "what RXF0SID holds");
        let mut regs = can.regs(&sim);
        let eid = regs.filter_window(|window| window.rxf_eid(0).read().bits());
        assert_eq!(eid, 0, "word 7 is the last one that DMA moves");
    }
}
