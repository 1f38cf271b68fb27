//! Whole frames as bit strings: hand-checked ones, and the encoder against the bus for random ones.
#![allow(clippy::unwrap_used)]

mod common;

use can_frame::Frame;
use can_wire::{Field, NodeConfig, NodeId, Time, encode};
use common::{Random, bench_of, frame, frames, record, run, transmitted};

/// The bits of SOF to the CRC sequence, stuff bits as `o` and `i`.
fn text(frame: &Frame, iso: bool) -> String {
    let letter = |bit: &can_wire::EncodedBit| match (bit.bit, bit.position.stuff) {
        (false, false) => '0',
        (true, false) => '1',
        (false, true) => 'o',
        (true, true) => 'i',
    };
    encode(frame, iso).iter().map(letter).collect()
}

/// Worked out apart from this crate, by a small program written from the definitions of ISO 11898-1, field by field:
/// SOF, identifier, RTR, IDE, FDF, DLC, data, CRC.
#[test]
fn hand_checked_frames() {
    let cases = HAND_CHECKED;
    for (frame_text, iso, bits) in cases {
        let expected: String = bits.chars().filter(|c| !c.is_whitespace()).collect();
        assert_eq!(text(&frame(frame_text), *iso), expected, "{frame_text}");
    }
}

include!("vectors/hand_checked.rs");

/// What the transmitter drives and the receiver samples is what the encoder says, bit for bit, and the fixed end after
/// it is CRC delimiter, ACK slot, ACK delimiter, EOF and intermission.
#[test]
fn the_bus_carries_the_encoded_bits() {
    let mut random = Random::new(0xE4C0);
    for iso in [true, false] {
        let (mut wire, nodes) = bench_of(
            2,
            NodeConfig {
                iso_crc: iso,
                ..NodeConfig::new()
            },
        );
        for _ in 0..300 {
            let frame = frames::any_frame(&mut random);
            let trace = record(&mut wire);
            wire.send(nodes[0], frame).unwrap();
            let events = run(&mut wire, Time::from_us(800));
            assert_eq!(transmitted(&events, nodes[0]), [frame]);
            let trace = trace.lock().unwrap();
            let of = |node: NodeId| trace.bits.iter().filter(move |bit| bit.node == node);
            let mut expected: Vec<_> = encode(&frame, iso)
                .iter()
                .map(|bit| (bit.position, bit.bit))
                .collect();
            let mut end = vec![
                (Field::CrcDelimiter, 0, true),
                (Field::AckSlot, 0, false),
                (Field::AckDelimiter, 0, true),
            ];
            end.extend((0..7).map(|bit| (Field::Eof, bit, true)));
            end.extend((0..3).map(|bit| (Field::Intermission, bit, true)));
            expected.extend(
                end.into_iter()
                    .map(|(field, bit, level)| (can_wire::Position::new(field, bit), level)),
            );
            let in_frame = |bit: &&can_wire::BitRecord| bit.position.field != Field::Idle;
            let seen = |node| {
                of(node)
                    .filter(in_frame)
                    .map(|bit| (bit.position, bit.seen.bit()))
                    .collect::<Vec<_>>()
            };
            assert_eq!(seen(nodes[0]), expected, "{frame} at the transmitter");
            assert_eq!(seen(nodes[1]), expected, "{frame} at the receiver");
            // The transmitter drove all of it but the acknowledgement.
            assert!(
                of(nodes[0])
                    .all(|bit| bit.driven == bit.seen || bit.position.field == Field::AckSlot)
            );
        }
    }
}

#[test]
fn iso_and_non_iso_nodes_do_not_understand_each_other() {
    let old = NodeConfig {
        iso_crc: false,
        ..NodeConfig::new()
    };
    let (mut wire, nodes) = common::bench(&[NodeConfig::new(), old]);
    wire.send(nodes[0], frame("123##1AABBCCDD")).unwrap();
    let events = run(&mut wire, Time::from_us(500));
    assert!(transmitted(&events, nodes[0]).is_empty());
    assert!(common::received(&events, nodes[1]).is_empty());
    // Classic frames are the same for both.
    wire.send(nodes[0], frame("123#AABBCCDD")).unwrap();
    let events = run(&mut wire, Time::from_us(500));
    assert_eq!(transmitted(&events, nodes[0]).len(), 1);
}
