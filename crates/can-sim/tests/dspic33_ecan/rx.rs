//! Reception into buffers (9.2), message buffers as the module writes them (5.0).

use crate::bench::{FRAME, add, everything, exactly, frame, kinds, pair, peer, standard};
use can_sim::{DiagnosticKind, Sim, Time};
use dspic33_ecan_pac::{
    enums::{FilterTarget, MaskSource, OperationMode, TxPriority},
    registers as pac,
};

/// 9.0, 5.0: eight words: identifier, DLC, data with byte 0 low, the filter in word 7.
#[test]
fn section_5_0_received_words() {
    for (text, words) in [
        ("48F#CDABCDABCDABCDAB", [0x123C, 0x0000, 0x0008, 0xABCD, 0xABCD, 0xABCD, 0xABCD, 0]),
        ("123FC003#CDABCDABCDABCDAB", [0x123F, 0x0F00, 0x0C08, 0xABCD, 0xABCD, 0xABCD, 0xABCD, 0]),
        ("123FC003#R", [0x123F, 0x0F00, 0x0E00, 0, 0, 0, 0, 0]),
        ("48F#R", [0x123E, 0, 0, 0, 0, 0, 0, 0]),
        ("1FFFFFFF#0102030405060708", [0x1FFF, 0x0FFF, 0xFC08, 0x0201, 0x0403, 0x0605, 0x0807, 0]),
        // bytes_beyond_dlc: 0.
        ("7FF#010203", [0x1FFC, 0, 3, 0x0201, 0x0003, 0, 0, 0]),
    ] {
        let (sim, can, other) = pair();
        can.set_words(&sim, 8, &[0xFFFF; 8]);
        sim.peer_send(other, frame(text));
        sim.run_for(FRAME);
        assert_eq!(can.words(&sim, 8), words, "{text}");
        assert_eq!(can.read(&sim, 8), frame(text));
    }
}

/// 5.0, Buffer 5-8: FILHIT tells the filter, for every filter and every direct buffer.
#[test]
fn section_9_2_1_buffer_pointers() {
    for number in 0..16 {
        let buffer = (14 - number % 15) as u8;
        let sim = Sim::new();
        let can = add(&sim, "can1")
            .set_up(&sim)
            .add_filter(&sim, exactly(number, MaskSource::Mask1, standard(0x100), buffer));
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        sim.peer_send(other, frame("100#42"));
        sim.run_for(FRAME);
        assert_eq!(can.words(&sim, buffer), [0x400, 0, 1, 0x42, 0, 0, 0, (number as u16) << 8]);
        assert_eq!(can.regs(&sim).rxful(1).read().bits(), 1 << buffer);
        let contents = sim.with_memory(can.ram, |memory| memory.clone());
        let contents = sim.inspect(can.id, |model| model.buffer(&contents, buffer));
        assert_eq!((contents.filter, contents.frame), (number as u8, frame("100#42")));
    }
}

/// 9.2.5: RXFUL and RBIF; a message for a full buffer is lost with RXOVF and RBOVIF, and the old one is kept.
#[test]
fn section_9_2_5_full_and_overflow() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(can.take_flags(&sim), pac::Intf::RBIF);
    assert!(can.is_full(&sim, 8));
    sim.peer_send(other, frame("100#02"));
    sim.run_for(FRAME);
    assert_eq!(can.take_flags(&sim), pac::Intf::RBOVIF);
    assert_eq!(can.regs(&sim).rxovf(1).read().bits(), 1 << 8);
    // Each lost message raises the interrupt, also while RXOVF is still set.
    sim.peer_send(other, frame("100#03"));
    sim.run_for(FRAME);
    assert_eq!(can.take_flags(&sim), pac::Intf::RBOVIF);
    can.regs(&sim).rxovf(1).clear(pac::Rxovf::rxovf_bit(8));
    assert!(!can.has_overflown(&sim, 8));
    assert_eq!(can.take(&sim, 8), Some(frame("100#01")));
    sim.peer_send(other, frame("100#04"));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 8), Some(frame("100#04")));
    assert_eq!(can.take_flags(&sim), pac::Intf::RBIF);
    assert_eq!(sim.diagnostics(), []);
}

/// 9.2.5, Registers 4-14 to 4-17: writing 1 does nothing, writing 0 clears.
#[test]
fn register_4_14_full_flags_clear_by_zero() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("100#"));
    sim.run_for(FRAME);
    use regbus::Bus;
    let (bus, offset) = (sim.registers(can.id), can.regs(&sim).rxful(1).offset());
    bus.write(offset, 0xFFFF_u16);
    assert_eq!(bus.read::<u16>(offset), 1 << 8, "ones leave it, and set nothing");
    bus.write(offset, !(1_u16 << 8));
    assert_eq!(bus.read::<u16>(offset), 0);
}

/// 9.2.1, note: several filters for one message: the lowest-numbered one that points to an empty buffer; 9.2.5, note:
/// if all are full, RXOVF of the lowest-numbered one.
#[test]
fn section_9_2_1_several_filters() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim);
    for (number, buffer) in [(2, 12), (5, 9), (9, 14)] {
        can.add_filter(&sim, exactly(number, MaskSource::Mask0, standard(0x100), buffer));
    }
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    let mut stored = Vec::new();
    for n in 0..4 {
        sim.peer_send(other, frame(&format!("100#0{n}")));
        sim.run_for(FRAME);
        stored.push((can.regs(&sim).rxful(1).read().bits(), can.regs(&sim).rxovf(1).read().bits()));
    }
    assert_eq!(stored, [(0x1000, 0), (0x1200, 0), (0x5200, 0), (0x5200, 0x1000)]);
    can.release(&sim, 9);
    sim.peer_send(other, frame("100#05"));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 9), Some(frame("100#05")));
    assert_eq!(can.words(&sim, 9)[7], 5 << 8);
}

/// 9.2.2: buffers 0 to 7 receive while TXEN is 0.
#[test]
fn section_9_2_2_buffers_0_to_7() {
    for buffer in 0..8 {
        let sim = Sim::new();
        let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(buffer)));
        let other = peer(&sim);
        can.enter(&sim, OperationMode::Normal);
        sim.peer_send(other, frame("100#01"));
        sim.run_for(FRAME);
        assert_eq!(can.take(&sim, usize::from(buffer)), Some(frame("100#01")));
        // frame_on_transmit_buffer: lost with RXOVF, as in the FIFO.
        can.transmit_buffer(&sim, usize::from(buffer), TxPriority::Lowest);
        sim.peer_send(other, frame("100#02"));
        sim.run_for(FRAME);
        assert!(!can.is_full(&sim, usize::from(buffer)) && can.has_overflown(&sim, usize::from(buffer)));
        assert!(can.intf(&sim).rbovif());
    }
}

/// 9.2.4: buffers 15 to 31 are reached through the FIFO only; pointer 1111 is not buffer 15.
#[test]
fn section_9_2_4_pointer_15_is_the_fifo() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, everything(FilterTarget::Fifo));
    can.write_fctrl(&sim, 0xC000 | 20);
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!((can.regs(&sim).rxful(1).read().bits(), can.regs(&sim).rxful(2).read().bits()), (0, 1 << 4));
    assert_eq!(can.take_from_fifo(&sim), Some(frame("100#01")));
}

/// 9.2: the number of buffers that DMABS selects; a pointer beyond it is reported (`pointer_beyond_buffers`).
#[test]
fn section_9_2_pointer_beyond_dmabs() {
    let (sim, can, other) = pair();
    can.write_fctrl(&sim, 0x2000);
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 8), Some(frame("100#01")));
    assert_eq!(kinds(&sim)[0].to_string(), "filter 0 points to buffer 8, but DMABS gives 6 buffers");
    // dmabs_code_7.
    can.write_fctrl(&sim, 0xE000);
    assert_eq!(kinds(&sim), [DiagnosticKind::ReservedValue { register: "FCTRL", field: "DMABS", value: 7 }]);
    sim.peer_send(other, frame("100#02"));
    sim.run_for(FRAME);
    assert_eq!((can.take(&sim, 8), kinds(&sim)), (Some(frame("100#02")), vec![]));
}

/// 2.1: every receiver acknowledges a correct frame, whatever its filters say.
#[test]
fn section_2_1_acknowledge_is_independent_of_filters() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim).enter(&sim, OperationMode::Normal);
    let other = peer(&sim);
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(sim.peer_sent(other).len(), 1);
    assert_eq!(can.intf(&sim).bits(), 0);
}

/// 14.0: a pulse of one bit time right after the end of frame of each accepted message, while CANCAP is 1.
#[test]
fn section_14_0_capture() {
    let sim = Sim::new();
    let can = add(&sim, "can1").set_up(&sim).add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x100), 8));
    let other = peer(&sim);
    can.enter(&sim, OperationMode::Normal);
    let captures = || sim.inspect(can.id, |model| model.captures());
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(captures().count, 0);
    can.regs(&sim).ctrl1().modify(|value| value.with_cancap(true));
    sim.peer_send(other, frame("100#02"));
    sim.peer_send(other, frame("101#02"));
    sim.run_for(FRAME);
    let pulse = captures();
    let (sent, _) = sim.peer_sent(other)[1];
    assert_eq!(pulse.count, 1, "a message that no filter accepts makes no pulse; a full buffer does not matter");
    assert_eq!(pulse.end.since(pulse.start), Time::from_us(1));
    // The transmitter's event is the sample point of the last bit of EOF, which ends 6 time quanta of 50 ns later.
    assert_eq!(pulse.start, sent + Time::from_ns(300));
}
