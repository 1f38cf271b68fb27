//! Examples 34-1 to 34-17, their printed mistakes corrected: the ids in brackets are those of the description's conflicts.

use can_hal::{
    ExtendedId, Frame, Id, Outcome, Polls, StandardId, Transmit,
    memory::Pic32CanFifo::{Receive, Transmit as Tx},
    pic32_can::{Config, Filter, Mask, TxFifo},
    timing::{Pic32CanTiming, Request, SamplePoint},
};
use can_sim::Time;

use crate::bench::{ANY, BIT_TIMING, Bench, FRAME, TIMING, WAIT, everything, frame};

fn standard(id: u16) -> Id {
    Id::Standard(StandardId::new(id).unwrap())
}

fn extended(sid: u32, eid: u32) -> Id {
    Id::Extended(ExtendedId::new(sid << 18 | eid).unwrap())
}

/// Example 34-1: Configuration mode, ON cleared, CANBUSY polled.
#[test]
fn example_34_1_disabling_the_module() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 1 });
    let can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.trace(true);
    let registers = can.into_configuration(WAIT).unwrap().turn_off(WAIT).unwrap();
    let accesses = bench.accesses();
    let writes: Vec<(u32, u32)> = accesses.iter().filter(|a| a.1).map(|a| (a.3, a.2)).collect();
    assert_eq!(writes.len(), 2, "{accesses:x?}");
    assert_eq!(writes[0].1 >> 24 & 7, 4, "REQOP = 4");
    assert_eq!(writes[1].0, 0x004, "CiCONCLR");
    let con = pic32_can_pac::Pic32Can::new(registers).con().read();
    assert!(!con.on() && !con.canbusy());
    bench.finish();
}

/// Example 34-2, Figure 34-10: two transmit FIFOs of 2, two receive FIFOs of 3, from 0x2000 on; 40 words. OPMOD is compared
/// with 4 (decimal_mode_code), and ON is set (on_missing_in_steps).
#[test]
fn example_34_2_setting_up_the_fifos() {
    let bench = Bench::at(0x2000);
    let memory = bench.memory(0x2000);
    let memory = memory.fifo(0, Tx { elements: 2 }).fifo(1, Tx { elements: 2 });
    let memory = memory.fifo(2, Receive { elements: 3 }).fifo(3, Receive { elements: 3 });
    assert_eq!(memory.plan().unwrap().end() - 0x2000, 40 * 4);
    let can = bench.running(&memory, &Config::new(TIMING));
    let regs = can.registers();
    let addresses = [0, 1, 2, 3].map(|n| regs.fifo(n).ua().read().bits());
    assert_eq!(addresses, [0x2000, 0x2020, 0x2040, 0x2070]);
    assert_eq!([0, 1, 2, 3].map(|n| regs.fifo(n).con().read().bits()), [0x1_0080, 0x1_0080, 0x2_0000, 0x2_0000]);
    assert!(regs.con().read().on());
    bench.finish();
}

/// Example 34-3: four messages into FIFO0, each with one write of 0x2008 to C1FIFOCON0SET.
#[test]
fn example_34_3_loading_a_transmit_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.trace(true);
    let texts = ["100#00", "101#01", "102#02", "103#03"];
    for text in texts {
        can.send_through(0, &frame(text)).unwrap();
    }
    let commands: Vec<u32> = bench.accesses().iter().filter(|a| a.1).map(|a| a.3).collect();
    assert_eq!(commands, [0x358; 4], "C1FIFOCON0SET and nothing else");
    bench.sim.run_for(FRAME * 4);
    assert_eq!(bench.seen(peer), texts);
    bench.finish();
}

/// Example 34-4: FIFO1, of four messages, is read until it is empty, with UINC of FIFO1 (example_34_4_fifo).
#[test]
fn example_34_4_reading_a_receive_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 4 });
    let filters = everything(1);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    let texts = ["100#00", "101#01", "102#02", "103#03"];
    bench.send(peer, &texts);
    let mut read = Vec::new();
    while let Some(message) = can.receive_fifo(1).unwrap() {
        read.push(message.frame.to_string());
    }
    assert_eq!(read, texts);
    assert_eq!(can.registers().fifo(1).ua().read().bits(), 0x110, "back at the first buffer of FIFO1");
    bench.finish();
}

/// Example 34-5: FRESET and the poll for it, as they follow an abort (34.7.4).
#[test]
fn example_34_5_resetting_a_fifo() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.peer_send(peer, frame("000#1122334455667788"));
    bench.sim.run_for(Time::from_us(20));
    let tickets = [frame("100#"), frame("101#")].map(|frame| can.send_through(0, &frame).unwrap());
    can.abort(0);
    bench.sim.trace(true);
    assert_eq!(tickets.map(|ticket| can.outcome(ticket)), [Outcome::Cancelled; 2]);
    let writes: Vec<(u32, u32)> = bench.accesses().iter().filter(|a| a.1).map(|a| (a.3, a.2)).collect();
    assert_eq!(writes.len(), 1);
    assert_eq!(writes[0].0, 0x358, "C1FIFOCON0SET with FRESET");
    assert!(!can.registers().fifo(0).con().read().freset());
    assert_eq!(can.registers().fifo(0).ua().read().bits(), 0x100);
    let ticket = can.send_through(0, &frame("102#")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    assert_eq!(bench.seen(peer), ["102#"]);
    bench.finish();
}

/// Examples 34-6 and 34-7: SID 0x100, two bytes 0xAA 0xBB, word by word.
#[test]
fn examples_34_6_and_34_7_transmit_message_buffer() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(1, Tx { elements: 1 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    bench.sim.with_memory(bench.ram, |memory| memory.words_mut().fill(u32::MAX));
    can.load(1, &frame("100#AABB")).unwrap();
    assert_eq!(bench.words(0x110), [0x0000_0100, 0x0000_0002, 0x0000_BBAA, 0x0000_0000]);
    bench.finish();
}

/// Example 34-8: two standard and two extended messages through FIFO0 of four buffers (example_34_8_fifo), EID and SRR as the
/// layout has them (example_34_8_eid).
#[test]
fn example_34_8_standard_and_extended_messages() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 4 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    let four = 0x12BC_1245_u32.to_le_bytes();
    let eight = [four, four].concat();
    let messages = [
        Frame::data(standard(0x100), &four).unwrap(),
        Frame::data(standard(0x102), &eight).unwrap(),
        Frame::data(extended(0x100, 0xC000), &four).unwrap(),
        Frame::data(extended(0x102, 0xC000), &eight).unwrap(),
    ];
    for message in &messages {
        can.send_through(0, message).unwrap();
    }
    assert_eq!(bench.words(0x100), [0x100, 0x0000_0004, 0x12BC_1245, 0]);
    assert_eq!(bench.words(0x110), [0x102, 0x0000_0008, 0x12BC_1245, 0x12BC_1245]);
    assert_eq!(bench.words(0x120), [0x100, 0x3300_0004, 0x12BC_1245, 0]);
    assert_eq!(bench.words(0x130), [0x102, 0x3300_0008, 0x12BC_1245, 0x12BC_1245]);
    bench.sim.run_for(FRAME * 4);
    let seen: Vec<Frame> = bench.sim.peer_received(peer).iter().map(|(_, frame)| *frame).collect();
    assert_eq!(seen, messages);
    bench.finish();
}

/// Example 34-9: a remote request for SID 0x100, which needs TXREQ too (example_34_9_request).
#[test]
fn example_34_9_remote_request() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Tx { elements: 1 });
    let mut can = bench.running(&memory, &Config::new(TIMING));
    can.send_through(1, &frame("100#R")).unwrap();
    assert_eq!(bench.words(0x110), [0x100, 0x200, 0, 0]);
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(peer), ["100#R"]);
    bench.finish();
}

/// Example 34-10: FIFO1 of four messages (fsize_of_four_buffers) answers SID 0x100, compared exactly (example_34_10_mask).
/// All FIFOs fit into the 140 words.
#[test]
fn example_34_10_responding_to_a_remote_request() {
    let bench = Bench::new();
    let (asking, other) = (bench.peer(), bench.peer());
    let memory = bench.memory(0).fifo(1, Tx { elements: 4 }).fifo(31, Receive { elements: 1 });
    assert_eq!(memory.plan().unwrap().end(), 140 * 4);
    let (filters, fifos) = ([Filter::new(standard(0x100), 1)], [TxFifo::new(1).replying()]);
    let config = Config::new(TIMING).with_filters([Mask::EXACT; 4], &filters).with_tx_fifos(&fifos);
    let mut can = bench.running(&memory, &config);
    let regs = can.registers();
    assert_eq!(regs.fifo(1).con().read().bits(), 0x0003_0084);
    assert_eq!((regs.flt_con(0).read().bits(), regs.rxf(0).read().bits()), (0x81, 0x2000_0000));
    let reply = frame("100#4512BC12");
    can.load_reply(1, &reply).unwrap();
    bench.send(asking, &["300#R", "100#R4"]);
    bench.sim.run_for(FRAME);
    let answers = bench.seen(other);
    assert_eq!(answers, ["300#R0", "100#R4", "100#4512BC12"].map(|text| frame(text).to_string()));
    assert!(!can.missed_request(1));
    bench.send(asking, &["100#R4"]);
    assert!(can.missed_request(1), "the FIFO has to be loaded again");
    assert!(!can.missed_request(1));
    bench.finish();
}

/// Example 34-11: filter 3 with mask 1 takes SIDs 0x100 to 0x103 into FIFO5.
#[test]
fn example_34_11_standard_filter() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(5, Receive { elements: 8 });
    let mut config = Config::new(TIMING);
    config.masks[1] = Mask::standard(StandardId::new(0x7FC).unwrap());
    let mut can = bench.configured(&memory, &config);
    can.set_filter(3, &Filter::new(standard(0x100), 5).with_mask(1), WAIT).unwrap();
    let regs = can.registers();
    assert_eq!(regs.flt_con(0).read().bits(), 0xA500_0000);
    assert_eq!((regs.rxf(3).read().bits(), regs.rxm(1).read().bits()), (0x2000_0000, 0xFF88_0000));
    let mut can = can.start_normal(WAIT).unwrap();
    bench.send(peer, &["0FF#", "100#", "101#", "102#", "103#", "104#", "04000000#"]);
    let mut accepted = Vec::new();
    while let Some(message) = can.receive_fifo(5).unwrap() {
        assert_eq!(message.filter, 3);
        accepted.push(message.frame.to_string());
    }
    assert_eq!(accepted, ["100#", "101#", "102#", "103#"]);
    assert_eq!(can.last_filter(), 3);
    bench.finish();
}

/// Example 34-12: filter 3 for one extended identifier: SID 0x100 as coded, or 0x53 as commented, and EID 0x1C498
/// (example_34_12_identifier).
#[test]
fn example_34_12_extended_filter() {
    for (sid, rxf) in [(0x100, 0x2009_C498), (0x53, 0x0A69_C498)] {
        let bench = Bench::new();
        let peer = bench.peer();
        let memory = bench.memory(0x100).fifo(5, Receive { elements: 4 });
        let mut can = bench.configured(&memory, &Config::new(TIMING));
        let id = extended(sid, 0x1_C498);
        can.set_filter(3, &Filter::new(id, 5).with_mask(1), WAIT).unwrap();
        let regs = can.registers();
        assert_eq!((regs.rxf(3).read().bits(), regs.rxm(1).read().bits()), (rxf, 0xFFEB_FFFF));
        let mut can = can.start_normal(WAIT).unwrap();
        let wanted = Frame::data(id, &[1]).unwrap();
        bench.sim.peer_send(peer, Frame::data(extended(sid, 0x1_C499), &[2]).unwrap());
        bench.sim.peer_send(peer, wanted);
        bench.sim.peer_send(peer, Frame::data(standard(sid as u16), &[3]).unwrap());
        bench.sim.run_for(FRAME * 3);
        assert_eq!(can.receive_fifo(5).unwrap().unwrap().frame, wanted);
        assert_eq!(can.receive_fifo(5), Ok(None));
        bench.finish();
    }
}

/// Examples 34-13 and 34-14: the fields of a received message, its length among them.
#[test]
fn examples_34_13_and_34_14_full_receive_buffer() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 2 });
    let filters = [Filter::any(1)];
    let mut config = Config::new(TIMING).with_filters(ANY, &filters);
    config.timestamps = Some(80);
    let mut can = bench.running(&memory, &config);
    bench.send(peer, &["0408C000#11223344"]);
    let words: [u32; 4] = bench.words(0x110);
    assert_eq!((words[0] & 0xFFFF, words[1], words[2]), (0x102, 0x3300_0004, 0x4433_2211));
    let message = can.receive_fifo(1).unwrap().unwrap();
    assert_eq!(message.frame.dlc().code(), 4);
    assert_eq!((message.filter, message.timestamp), (0, Some((words[0] >> 16) as u16)));
    bench.finish();
}

/// Example 34-15: a message is copied out of its buffer, not into it (example_34_15_direction).
#[test]
fn example_34_15_copying_a_message() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(1, Receive { elements: 2 });
    let filters = everything(1);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    assert_eq!(can.receive_fifo(1), Ok(None));
    bench.send(peer, &["123#0102030405060708"]);
    let before: [u32; 4] = bench.words(0x110);
    assert_eq!(can.receive_fifo(1).unwrap().unwrap().frame, frame("123#0102030405060708"));
    assert_eq!(bench.words(0x110), before);
    assert_eq!(can.registers().fifo(1).ua().read().bits(), 0x120);
    bench.finish();
}

/// Examples 34-16 and 34-17: 10 MHz of time quanta (time_quantum_frequency), BRP 3, 70 %; a jump width of 2 quanta is SJW = 1
/// (sjw_of_two_quanta), that of the printed code 3 quanta.
#[test]
fn examples_34_16_and_34_17_bit_timing() {
    let bench = Bench::new();
    let peer = bench.peer();
    assert_eq!(TIMING.cfg.bits(), 0x0002_D243);
    let mut printed = BIT_TIMING;
    printed.nominal.jump_width = 3;
    assert_eq!(Pic32CanTiming::of(&printed).unwrap().cfg.bits(), 0x0002_D283);
    assert_eq!(BIT_TIMING.nominal.quanta(), 10);
    assert_eq!(BIT_TIMING.nominal.bit_rate(80_000_000, 2).get(), 1_000_000);
    assert_eq!(BIT_TIMING.nominal.sample_point(), SamplePoint::percent(70));
    let solved = Pic32CanTiming::solve(&Request::new(80_000_000, 1_000_000).sample_point(SamplePoint::percent(70)));
    let memory = bench.memory(0x100).fifo(0, Tx { elements: 1 });
    let can = bench.configured(&memory, &Config::new(TIMING));
    assert_eq!(can.registers().cfg().read(), TIMING.cfg);
    let mut can = can.start_normal(WAIT).unwrap();
    let ticket = can.send(&frame("123#01")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    assert_eq!(bench.seen(peer), ["123#01"]);
    // What the solver finds by itself has the same rate and sample point, if not the same quanta.
    let mut can = can.into_configuration(WAIT).unwrap();
    can.set_bit_timing(&solved.unwrap());
    let mut can = can.start_normal(WAIT).unwrap();
    let ticket = can.send(&frame("124#02")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}
