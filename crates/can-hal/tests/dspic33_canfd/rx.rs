//! Chapters 8 and 9: filters and reception.

use can_hal::{
    ExtendedId, FdFlags, Frame, Overflow, Receive, StandardId,
    dspic33_canfd::{Config, Filter, FilterError, Matching},
};

use crate::bench::{Bench, CONFIG, frame};

fn standard(id: u16) -> StandardId {
    StandardId::new(id).unwrap()
}

/// 8.1: a filter is disabled, written, pointed and enabled again, in this order, while the module runs.
#[test]
fn section_8_1_changing_a_filter() {
    let bench = Bench::new();
    let peer = bench.peer();
    let filters = [Filter::standard(standard(0x111), 1), Filter::standard(standard(0x222), 2)];
    let mut can = bench.running(&CONFIG.with_filters(&filters));
    bench.sim.trace(true);
    can.set_filter(0, Some(&Filter::standard(standard(0x333), 1))).unwrap();
    let order: Vec<(String, u32)> =
        bench.accesses().into_iter().filter(|(_, write, _)| *write).map(|(name, _, value)| (name, value)).collect();
    let names: Vec<&str> = order.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["FLTCON[0]", "FLTOBJL[0]", "FLTOBJH[0]", "MASKL[0]", "MASKH[0]", "FLTCON[0]", "FLTCON[0]"]);
    assert_eq!((order[0].1 & 0x80, order[5].1 & 0x80, order[6].1 & 0x80), (0, 0, 0x80));
    bench.send(peer, &["111#01", "222#02", "333#03"]);
    assert_eq!(can.receive_fifo(1).unwrap().unwrap().frame, frame("333#03"));
    assert_eq!(can.receive_fifo(1), Ok(None));
    let second = can.receive_fifo(2).unwrap().unwrap();
    assert_eq!((second.frame, second.filter, second.timestamp), (frame("222#02"), 1, None), "its neighbour stays");
    can.set_filter(0, None).unwrap();
    bench.send(peer, &["333#03"]);
    assert_eq!(can.fetch(), Ok(None));
    assert_eq!(can.set_filter(32, None), Err(FilterError::NoSuchFilter { index: 32 }));
    assert_eq!(can.set_filter(0, Some(&Filter::any(7))), Err(FilterError::NoSuchFifo { fifo: 7 }));
    bench.finish();
}

/// 8.2.2: identifiers 0 to 3 with the two lowest mask bits at 0.
#[test]
fn section_8_2_2_mask_bits() {
    let bench = Bench::new();
    let peer = bench.peer();
    let filters = [
        Filter::standard_mask(standard(0), 0x7FC, 1),
        Filter::extended_mask(ExtendedId::new(0x1000).unwrap(), 0x1FFF_FF00, 1),
    ];
    let mut can = bench.running(&CONFIG.with_filters(&filters));
    let mut received = Vec::new();
    for text in ["000#", "003#", "004#", "000010FF#", "00001100#", "00000000#"] {
        bench.send(peer, &[text]);
        received.extend(can.fetch().unwrap().map(|message| (message.frame.to_string(), message.filter)));
    }
    let expected = [("000#", 0), ("003#", 0), ("000010FF#", 1)].map(|(text, filter)| (text.to_owned(), Some(filter)));
    assert_eq!(received, expected);
    bench.finish();
}

/// 8.2.3: data bytes of standard frames.
#[test]
fn section_8_2_3_filtering_on_data_bytes() {
    let bench = Bench::new();
    let peer = bench.peer();
    // Data byte 0 is 0xA5: its most significant bit is compared with bit 0.
    let data = u32::from(0xA5_u8.reverse_bits());
    let matching = Matching::StandardData { id: standard(0x100), mask: 0x7FF, data, data_mask: 0xFF };
    let filters = [Filter { matching, fifo: 1 }];
    let mut can = bench.running(&Config { data_filter_bits: 8, ..CONFIG.with_filters(&filters) });
    bench.send(peer, &["100#A501", "100#A401"]);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("100#A501"));
    assert_eq!(can.fetch(), Ok(None));
    bench.finish();
}

/// 8.2.4: identifiers of twelve bits, the last of them in RRS.
#[test]
fn section_8_2_4_twelve_bit_identifiers() {
    let bench = Bench::new();
    let peer = bench.peer();
    let filters = [Filter { matching: Matching::TwelveBit(0x247, 0xFFF), fifo: 1 }];
    let mut can = bench.running(&Config { twelve_bit_ids: true, ..CONFIG.with_filters(&filters) });
    let even = Frame::fd(standard(0x123), &[1], FdFlags { brs: true, esi: false }).unwrap();
    let odd = even.with_remote_request_substitution(true);
    for message in [even, odd] {
        bench.sim.peer_send(peer, message);
        bench.sim.run_for(crate::bench::FRAME);
    }
    assert_eq!(can.fetch().unwrap().unwrap().frame, odd);
    assert_eq!(can.fetch(), Ok(None));
    // And sent.
    can.send_fifo(3, &odd, Default::default()).unwrap();
    bench.sim.run_for(crate::bench::FRAME);
    assert_eq!(bench.sim.peer_received(peer)[0].1, odd);
    bench.finish();
}

/// 8.2, 12.1.4: messages that find their FIFO full are told once; those from before are still there.
#[test]
fn section_12_1_4_overrun() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG.with_filters(&[Filter::any(2)]));
    bench.send(peer, &["101#", "102#", "103#", "104#"]);
    assert_eq!(can.receive_fifo(2), Err(Overflow { fifo: 2 }));
    let ids: Vec<String> = core::iter::from_fn(|| can.receive_fifo(2).unwrap()).map(|m| m.frame.to_string()).collect();
    assert_eq!(ids, ["101#", "102#"]);
    assert_eq!((can.receive_fifo(3), can.receive_fifo(99)), (Ok(None), Ok(None)), "no receive FIFO");
    bench.finish();
}

/// 9.4: a message longer than the object is cut, its DLC stays.
#[test]
fn section_9_4_dlc_above_the_payload_size() {
    let bench = Bench::new();
    let peer = bench.peer();
    let mut can = bench.running(&CONFIG.with_filters(&[Filter::any(2)]));
    bench.send(peer, &["101##1000102030405060708090A0B"]);
    let received = can.fetch().unwrap().unwrap().frame;
    assert_eq!((received.dlc().code(), received.len()), (9, 12));
    assert_eq!(received.data_bytes(), [0, 1, 2, 3, 4, 5, 6, 7, 0, 0, 0, 0]);
    assert!(can.interrupts().flags.ivmif());
    bench.finish();
}
