//! DMA (10.0, 12.1, 12.2).

use crate::bench::{FRAME, frame, kinds, pair, pair_with, received};
use can_sim::{
    DiagnosticKind, Time,
    dspic33_ecan::{DmaAddressing, DmaChannel},
};
use dspic33_ecan_pac::enums::TxPriority;

/// Lines of the two data requests in the order of the description.
const RX_DATA: usize = 1;
const TX_DATA: usize = 2;

/// 10.1, 10.1.1: eight words for each message, whatever its DLC; the channel's interrupt after each eight.
#[test]
fn section_10_1_eight_words() {
    let (sim, can, other) = pair();
    can.send(&sim, 0, &frame("100#"));
    sim.peer_send(other, frame("101#01"));
    sim.run_for(FRAME * 2);
    let [transmit, receive] = sim.inspect(can.id, |model| model.dma_statistics());
    assert_eq!((transmit.words, transmit.interrupts), (8, 1));
    assert_eq!((receive.words, receive.interrupts), (8, 1));
}

/// Figure 10-1: the start of the buffers is DMAxSTA from the start of DMA RAM.
#[test]
fn figure_10_1_start_of_the_buffers() {
    let (sim, can, other) = pair_with(|config| config.with_buffers_at(0x100));
    use regbus::Bus;
    for (n, word) in [0x0400_u16, 0, 2, 0xBBAA].into_iter().enumerate() {
        can.memory(&sim).write(0x100 + 2 * n, word);
    }
    can.request(&sim, 0);
    sim.peer_send(other, frame("101#CC"));
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other), ["100#AABB"]);
    assert_eq!(can.memory(&sim).read::<u16>(0x100 + 16 * 8 + 6), 0xCC);
    assert_eq!(sim.diagnostics(), []);
}

/// 12.1, 12.2: one request for each word; RXFUL is set after the last one.
#[test]
fn section_12_2_requests_word_by_word() {
    let latency = Time::from_us(1);
    let (sim, can, other) = pair_with(|mut config| {
        config.transmit_dma = Some(DmaChannel::new(0).with_latency(latency));
        config.receive_dma = config.transmit_dma;
        config
    });
    can.send(&sim, 0, &frame("100#"));
    assert!(sim.line(can.id, TX_DATA));
    sim.run_for(Time::from_us(4));
    assert_eq!(sim.inspect(can.id, |model| model.dma_statistics())[0].words, 4);
    sim.run_for(Time::from_us(5));
    assert!(!sim.line(can.id, TX_DATA));
    sim.run_for(FRAME);
    sim.peer_send(other, frame("101#01"));
    let began = sim.run_until(FRAME, |sim| sim.line(can.id, RX_DATA)).unwrap();
    assert!(!can.is_full(&sim, 8));
    let stored = sim.run_until(FRAME, |sim| !sim.line(can.id, RX_DATA)).unwrap();
    assert!(stored.since(began) >= Time::from_us(7), "{}", stored.since(began));
    assert_eq!(can.take(&sim, 8), Some(frame("101#01")));
    assert_eq!(received(&sim, other), ["100#"]);
}

/// `dma_late`: a channel that is slower than the bus loses messages, and it is reported.
#[test]
fn a_late_receive_channel() {
    let (sim, can, other) = pair_with(|mut config| {
        config.receive_dma = Some(DmaChannel::new(0).with_latency(Time::from_us(20)));
        config
    });
    can.regs(&sim).fen1().modify(|value| value.with_flten(0, true));
    for text in ["100#01", "101#02", "102#03"] {
        sim.peer_send(other, frame(text));
    }
    sim.run_for(FRAME * 3);
    assert_eq!(can.take(&sim, 8), Some(frame("100#01")));
    let late =
        |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::TransferNotServed { request: "CxRX", buffer: 8, .. });
    let found = kinds(&sim);
    assert!(found.iter().all(late) && found.len() == 2, "{found:?}");
}

/// A message that is still being fetched is overtaken by one of higher priority.
#[test]
fn a_late_transmit_channel() {
    let (sim, can, other) = pair_with(|mut config| {
        config.transmit_dma = Some(DmaChannel::new(0).with_latency(Time::from_us(10)));
        config
    });
    can.transmit_buffer(&sim, 5, TxPriority::Highest);
    can.write(&sim, 5, &frame("500#"));
    can.send(&sim, 0, &frame("100#"));
    sim.run_for(Time::from_us(30));
    can.request(&sim, 5);
    sim.run_for(FRAME * 4);
    assert_eq!(received(&sim, other), ["500#", "100#"]);
    can.send(&sim, 0, &frame("101#"));
    sim.run_for(Time::from_us(30));
    can.abort(&sim, 0);
    sim.run_for(FRAME * 2);
    assert_eq!(received(&sim, other).len(), 2, "aborted while it was being fetched");
}

/// 9.2.1: the channel must work in peripheral indirect mode; in the others every message lands at the start.
#[test]
fn section_9_2_1_addressing_modes() {
    for (addressing, expected) in [
        (DmaAddressing::PeripheralIndirect, [0, 0]),
        (DmaAddressing::PostIncrement, [0x0400, 0]),
        // All eight words to one place: the last one stays.
        (DmaAddressing::Fixed, [0x0000, 0]),
    ] {
        let (sim, can, other) = pair_with(|mut config| {
            let mut channel = DmaChannel::new(0);
            channel.addressing = addressing;
            config.receive_dma = Some(channel);
            config
        });
        sim.peer_send(other, frame("100#55"));
        sim.run_for(FRAME);
        let word = can.words(&sim, 0);
        assert_eq!([word[0], word[1]], expected, "{addressing:?}");
        assert_eq!(can.words(&sim, 8)[0] == 0x0400, addressing == DmaAddressing::PeripheralIndirect);
    }
}

/// A one-shot channel serves one message and then is disabled.
#[test]
fn a_one_shot_channel() {
    let (sim, can, other) = pair_with(|mut config| {
        let mut channel = DmaChannel::new(0);
        channel.one_shot = true;
        config.receive_dma = Some(channel);
        config
    });
    for text in ["100#01", "101#02"] {
        sim.peer_send(other, frame(text));
        sim.run_for(FRAME);
        can.take(&sim, 8);
    }
    let because = "no enabled DMA channel has the request";
    assert_eq!(kinds(&sim), [DiagnosticKind::TransferNotServed { request: "CxRX", buffer: 8, because }]);
    assert_eq!(sim.inspect(can.id, |model| model.dma_channels())[1], None);
    sim.act(can.id, |model, cx| model.set_dma(cx, Some(DmaChannel::new(0)), Some(DmaChannel::new(0))));
    sim.peer_send(other, frame("102#03"));
    sim.run_for(FRAME);
    assert_eq!(can.take(&sim, 8), Some(frame("102#03")));
}

/// Buffers behind the end of the DMA RAM.
#[test]
fn buffers_behind_the_memory() {
    let (sim, _, other) = pair_with(|config| config.with_buffers_at(1024 - 8 * 16 - 8));
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    let overrun = |n: u32| DiagnosticKind::MemoryOverrun { address: 1024 + 2 * n };
    assert_eq!(kinds(&sim), [overrun(0), overrun(1), overrun(2), overrun(3)]);
}

/// PIC24HJ errata DS80000441J, item 17: data in the wrong buffer.
#[test]
fn a_message_in_the_wrong_buffer() {
    let (sim, can, other) = pair();
    sim.act(can.id, |model, _| model.misplace_next_message(3));
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!((can.words(&sim, 3)[0], can.words(&sim, 8)[0]), (0x0400, 0));
    assert!(can.is_full(&sim, 8) && !can.is_full(&sim, 3));
}

/// Registers 4-27 and 4-28: the data registers are the DMA channels' (`rxd_txd_by_cpu`).
#[test]
fn register_4_27_data_registers() {
    let (sim, can, other) = pair();
    sim.peer_send(other, frame("100#01"));
    sim.run_for(FRAME);
    assert_eq!(can.regs(&sim).rxd().read().bits(), 0, "word 7, the last one: filter 0");
    can.regs(&sim).txd().write(dspic33_ecan_pac::registers::Txd::from_bits(0x1234));
    assert_eq!(can.regs(&sim).txd().read().bits(), 0x1234);
    assert_eq!(kinds(&sim).len(), 3);
    assert_eq!(sim.inspect(can.id, |model| model.dma_statistics())[0].words, 0);
}
