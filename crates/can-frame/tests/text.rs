//! candump text: the notation of the can-utils, in both directions.
#![allow(clippy::unwrap_used)]

use can_frame::{
    Direction, Dlc, ExtendedId, FdFlags, Format, Frame, FrameError, Id, LogLine, ParseErrorKind,
    StandardId,
};
use proptest::prelude::*;

fn std_id(raw: u16) -> Id {
    Id::Standard(StandardId::new(raw).expect("11 bits"))
}

fn ext_id(raw: u32) -> Id {
    Id::Extended(ExtendedId::new(raw).expect("29 bits"))
}

fn dlc(code: u8) -> Dlc {
    Dlc::new(code).expect("four bits")
}

#[test]
fn frames_print_as_candump_prints_them() {
    let cases: [(Frame, &str); 9] = [
        (Frame::data(std_id(0x123), &[]).unwrap(), "123#"),
        (Frame::data(std_id(0x7), &[0xDE, 0xAD]).unwrap(), "007#DEAD"),
        (Frame::data(ext_id(0x7), &[1]).unwrap(), "00000007#01"),
        (Frame::remote(std_id(0x123), Dlc::ZERO), "123#R"),
        (Frame::remote(ext_id(0x1FFF_FFFF), dlc(5)), "1FFFFFFF#R5"),
        (
            Frame::fd(std_id(0x123), &[], FdFlags::default()).unwrap(),
            "123##0",
        ),
        (
            Frame::fd(
                std_id(0x123),
                &[0xAB],
                FdFlags {
                    brs: true,
                    esi: false,
                },
            )
            .unwrap(),
            "123##1AB",
        ),
        (
            Frame::fd(
                std_id(0x123),
                &[0xAB],
                FdFlags {
                    brs: true,
                    esi: true,
                },
            )
            .unwrap(),
            "123##3AB",
        ),
        (
            Frame::data_with_dlc(std_id(0x123), dlc(14), &[1, 2, 3, 4, 5, 6, 7, 8]).unwrap(),
            "123#0102030405060708_E",
        ),
    ];
    for (frame, text) in cases {
        assert_eq!(frame.to_string(), text);
        assert_eq!(text.parse::<Frame>().unwrap(), frame);
        assert_eq!(format!("{frame:?}"), format!("Frame({text})"));
    }
}

#[test]
fn cansend_spellings_are_understood() {
    let plain: Frame = "123#11223344".parse().unwrap();
    assert_eq!("123#11.22.33.44".parse::<Frame>().unwrap(), plain);
    assert_eq!(
        "123#R0".parse::<Frame>().unwrap(),
        Frame::remote(std_id(0x123), Dlc::ZERO)
    );
    assert_eq!(
        "123#r8_A".parse::<Frame>().unwrap(),
        Frame::remote(std_id(0x123), dlc(10))
    );
    assert_eq!(
        "123##5aa".parse::<Frame>().unwrap(),
        "123##1AA".parse::<Frame>().unwrap()
    );
}

#[test]
fn broken_frames_say_where_and_why() {
    let cases = [
        ("", 0, ParseErrorKind::IdDigits { found: 0 }),
        ("12#", 0, ParseErrorKind::IdDigits { found: 2 }),
        ("123456789#", 0, ParseErrorKind::IdDigits { found: 9 }),
        ("800#", 0, ParseErrorKind::IdRange { id: 0x800 }),
        ("20000088#0000000000000000", 0, ParseErrorKind::ErrorMessage),
        ("40000000#", 0, ParseErrorKind::IdRange { id: 0x4000_0000 }),
        ("123", 3, ParseErrorKind::MissingSeparator),
        ("123#1", 4, ParseErrorKind::HalfByte),
        ("123#1122x3", 8, ParseErrorKind::NotHex),
        ("123#R9", 5, ParseErrorKind::BadDlc),
        ("123#R4_9", 6, ParseErrorKind::BadDlc),
        ("123#11_9", 6, ParseErrorKind::BadDlc),
        ("123##", 5, ParseErrorKind::MissingFdFlags),
        ("123##8", 5, ParseErrorKind::MissingFdFlags),
        ("123#R5 x", 6, ParseErrorKind::TrailingText),
        (
            "123#112233445566778899",
            20,
            ParseErrorKind::Frame(FrameError::TooLong { len: 9, max: 8 }),
        ),
        (
            "123##0112233445566778899",
            6,
            ParseErrorKind::Frame(FrameError::NotAnFdLength { len: 9, next: 12 }),
        ),
    ];
    for (text, at, kind) in cases {
        let error = text.parse::<Frame>().expect_err(text);
        assert_eq!((error.at, error.kind), (at, kind), "{text}: {error}");
    }
}

#[test]
fn log_lines_in_both_directions() {
    let text = "(1436509052.249713) vcan0 044#2A366C2BBA";
    let line = LogLine::parse(text).unwrap();
    assert_eq!(line.nanoseconds, 1_436_509_052_249_713_000);
    assert_eq!((line.interface, line.direction), ("vcan0", None));
    assert_eq!(line.frame.data_bytes(), [0x2A, 0x36, 0x6C, 0x2B, 0xBA]);
    assert_eq!(line.to_string(), text);

    let line = LogLine::parse("  (0000000001.5) can1 12345678##2AA T\n").unwrap();
    assert_eq!(
        (line.nanoseconds, line.direction),
        (1_500_000_000, Some(Direction::Transmitted))
    );
    assert_eq!(line.to_string(), "(0000000001.500000) can1 12345678##2AA T");
    assert_eq!(
        LogLine::parse("(1.0) can1 123#R R").unwrap().direction,
        Some(Direction::Received)
    );
}

#[test]
fn screen_lines_of_candump() {
    let line = LogLine::parse("  can0  123   [4]  DE AD BE EF").unwrap();
    assert_eq!(line.frame, "123#DEADBEEF".parse().unwrap());
    let line = LogLine::parse(
        " (12.000001)  can0  RX B E  12345678  [12]  00 01 02 03 04 05 06 07 08 09 0A 0B",
    )
    .unwrap();
    assert_eq!(
        line.frame,
        "12345678##3000102030405060708090A0B".parse().unwrap()
    );
    assert_eq!(
        (line.nanoseconds, line.direction),
        (12_000_001_000, Some(Direction::Received))
    );
    let line = LogLine::parse("  can0  TX - -  7FF   [0]  remote request").unwrap();
    assert_eq!(
        (line.frame, line.direction),
        ("7FF#R".parse().unwrap(), Some(Direction::Transmitted))
    );
}

#[test]
fn broken_log_lines_say_where_and_why() {
    let cases = [
        ("(1.0 can0 123#", 0, ParseErrorKind::BadTimestamp),
        ("(.5) can0 123#", 0, ParseErrorKind::BadTimestamp),
        (
            "(99999999999999999999.0) can0 123#",
            0,
            ParseErrorKind::BadTimestamp,
        ),
        ("(1.0)", 5, ParseErrorKind::MissingColumn),
        ("(1.0) can0", 10, ParseErrorKind::MissingColumn),
        ("(1.0) can0 123#1", 15, ParseErrorKind::HalfByte),
        ("(1.0) can0 123#11 R x", 20, ParseErrorKind::TrailingText),
        ("can0 123 [3] 11 22", 18, ParseErrorKind::BadLength),
        ("can0 123 [9] 11 22", 9, ParseErrorKind::BadLength),
        ("can0 123 [2] 11 2", 16, ParseErrorKind::HalfByte),
        ("can0 123 [2] 11 2g", 16, ParseErrorKind::NotHex),
        ("can0 123 [1] 11 22", 16, ParseErrorKind::TrailingText),
        ("can0 1234 [1] 11", 5, ParseErrorKind::IdDigits { found: 4 }),
    ];
    for (text, at, kind) in cases {
        let error = LogLine::parse(text).expect_err(text);
        assert_eq!((error.at, error.kind), (at, kind), "{text}: {error}");
    }
}

#[test]
fn constructors_refuse_what_does_not_exist() {
    let id = std_id(1);
    assert_eq!(
        Frame::data(id, &[0; 9]),
        Err(FrameError::TooLong { len: 9, max: 8 })
    );
    assert_eq!(
        Frame::fd(id, &[0; 65], FdFlags::default()),
        Err(FrameError::TooLong { len: 65, max: 64 })
    );
    assert_eq!(
        Frame::data_with_dlc(id, dlc(9), &[0; 7]),
        Err(FrameError::DlcMismatch {
            code: 9,
            len: 7,
            expected: 8
        })
    );
    let padded = Frame::fd_padded(id, &[1; 9], 0xCC, FdFlags::default()).unwrap();
    assert_eq!(
        padded.data_bytes(),
        [1, 1, 1, 1, 1, 1, 1, 1, 1, 0xCC, 0xCC, 0xCC]
    );
    assert_eq!(padded.dlc(), dlc(9));
}

#[test]
fn embedded_can_drivers_see_the_classic_part() {
    use embedded_can::Frame as _;
    let frame = <Frame as embedded_can::Frame>::new(std_id(0x10), &[1, 2]).unwrap();
    assert!(frame.is_data_frame() && frame.is_standard());
    assert_eq!(
        (
            embedded_can::Frame::dlc(&frame),
            embedded_can::Frame::data(&frame)
        ),
        (2, &[1u8, 2][..])
    );
    assert!(<Frame as embedded_can::Frame>::new(std_id(0x10), &[0; 12]).is_none());
    let remote = <Frame as embedded_can::Frame>::new_remote(ext_id(0x10), 3).unwrap();
    assert!(remote.is_remote_frame());
    assert_eq!(
        (
            embedded_can::Frame::dlc(&remote),
            embedded_can::Frame::data(&remote)
        ),
        (3, &[][..])
    );
    assert!(<Frame as embedded_can::Frame>::new_remote(ext_id(0x10), 12).is_none());
}

fn any_frame() -> impl Strategy<Value = Frame> {
    let id = prop_oneof![
        (0u16..0x800).prop_map(std_id),
        (0u32..0x2000_0000).prop_map(ext_id)
    ];
    let format = prop_oneof![
        Just(Format::Data),
        Just(Format::Remote),
        (any::<bool>(), any::<bool>()).prop_map(|(brs, esi)| Format::Fd(FdFlags { brs, esi }))
    ];
    (id, format, 0u8..16, any::<[u8; 64]>())
        .prop_map(|(id, format, code, bytes)| Frame::from_fields(id, format, dlc(code), &bytes))
}

proptest! {
    #[test]
    fn text_round_trips(frame in any_frame(), ns in 0u64..u64::MAX / 2, sent in any::<Option<bool>>()) {
        prop_assert_eq!(frame.to_string().parse::<Frame>().unwrap(), frame);
        let direction = sent.map(|sent| if sent { Direction::Transmitted } else { Direction::Received });
        let line = LogLine { nanoseconds: ns / 1000 * 1000, interface: "can0", frame, direction };
        let text = line.to_string();
        prop_assert_eq!(LogLine::parse(&text).unwrap(), line);
    }

    #[test]
    fn parsing_never_panics(text in "\\PC{0,40}") {
        let _ = text.parse::<Frame>();
        let _ = LogLine::parse(&text);
    }

    #[test]
    fn parsing_near_misses_never_panics(text in "[0-9A-Fa-f#R_. ()\\[\\]canTX-]{0,60}") {
        let _ = text.parse::<Frame>();
        let _ = LogLine::parse(&text);
    }
}
