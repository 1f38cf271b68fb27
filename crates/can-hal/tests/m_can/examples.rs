//! Printed numbers: bit timing, Message RAM, what cannot be configured.

use can_hal::{
    OutOfRange, Polls, Region,
    m_can::{Can, Config, ConfigError, DataFieldSize, Layout, LayoutError, Sizes},
    timing::{BitTiming, DataPhase, DelayCompensation, Segments},
};
use can_sim::{MemoryBus, RegisterBus};

use crate::bench::{Bench, TIMING};

fn quanta(prescaler: u32, before: u32, phase2: u32, jump_width: u32) -> Segments {
    Segments { prescaler, propagation: 0, phase1: before, phase2, jump_width }
}

/// 2.3.8, 2.3.4: at 8 MHz the reset values stand for 500 kbit/s: 16 time quanta. The appendix prints another reset value
/// of NBTP; section 2.3.8 and Table 1 are right.
#[test]
fn sections_2_3_4_and_2_3_8_reset_values_are_500_kbit_s_at_8_mhz() {
    let bench = Bench::new();
    let segments = quanta(1, 11, 4, 4);
    let data = Some(DataPhase { segments, compensation: None });
    let can = bench.configured(&Config::new(BitTiming { nominal: segments, data }));
    assert_eq!(can.registers().nbtp().read().bits(), 0x0600_0A03);
    assert_eq!(can.registers().dbtp().read().bits(), 0x0000_0A33);
    assert_eq!(8_000_000 / (1 + 11 + 4), 500_000);
}

/// 3.1.4: at 20 MHz the shortest data bit of 4 time quanta is 5 Mbit/s; 2.3.4: the longest has 49.
#[test]
fn section_3_1_4_shortest_and_longest_bits() {
    let bench = Bench::new();
    let cases = [
        (quanta(1, 2, 2, 2), quanta(1, 1, 2, 1), (0x0000_0101 | 1 << 25, 0x0000_0010)),
        (quanta(512, 256, 128, 128), quanta(32, 32, 16, 16), (0xFFFF_FF7F, 0x001F_1FFF)),
    ];
    for (nominal, segments, (nbtp, dbtp)) in cases {
        let data = Some(DataPhase { segments, compensation: None });
        let mut can = bench.driver(&Sizes::NONE);
        can.configure(&Config::new(BitTiming { nominal, data })).unwrap();
        assert_eq!((can.registers().nbtp().read().bits(), can.registers().dbtp().read().bits()), (nbtp, dbtp));
    }
    assert_eq!(20_000_000 / (1 + 1 + 2), 5_000_000);
}

/// 2.3.4, 2.3.8, 2.3.15: the ranges of the fields, named when they are left.
#[test]
fn section_2_3_8_values_out_of_range() {
    let bench = Bench::new();
    let mut can = bench.driver(&Sizes::NONE);
    let timing =
        |nominal, segments, compensation| BitTiming { nominal, data: Some(DataPhase { segments, compensation }) };
    let (good, data) = (TIMING.nominal, quanta(1, 3, 4, 2));
    let tdc = |offset, filter| Some(DelayCompensation { offset, filter });
    let out = |field, value, min, max| OutOfRange { field, value, min, max };
    let cases = [
        (timing(quanta(513, 10, 4, 1), data, None), out("NBTP.NBRP", 513, 1, 512)),
        (timing(quanta(1, 1, 4, 1), data, None), out("NBTP.NTSEG1", 1, 2, 256)),
        (timing(quanta(1, 10, 129, 1), data, None), out("NBTP.NTSEG2", 129, 2, 128)),
        (timing(quanta(1, 10, 4, 0), data, None), out("NBTP.NSJW", 0, 1, 128)),
        (timing(good, quanta(33, 3, 4, 2), None), out("DBTP.DBRP", 33, 1, 32)),
        (timing(good, quanta(1, 33, 4, 2), None), out("DBTP.DTSEG1", 33, 1, 32)),
        (timing(good, quanta(3, 3, 4, 2), tdc(1, 0)), out("DBTP.DBRP", 3, 1, 2)),
        (timing(good, data, tdc(128, 0)), out("TDCR.TDCO", 128, 0, 127)),
        (timing(good, data, tdc(1, 128)), out("TDCR.TDCF", 128, 0, 127)),
    ];
    for (timing, expected) in cases {
        assert_eq!(can.set_bit_timing(&timing), Err(expected));
        assert_eq!(can.configure(&Config::new(timing)), Err(ConfigError::OutOfRange(expected)));
    }
    let config = Config::new(BitTiming { nominal: good, data: None }).with_fd();
    assert_eq!(can.configure(&config), Err(ConfigError::NoDataPhase));
}

/// 3.1.4.1: offset and filter window of the transmitter delay compensation.
#[test]
fn section_3_1_4_transmitter_delay_compensation() {
    let bench = Bench::new();
    let other = bench.peer();
    let compensation = Some(DelayCompensation { offset: 6, filter: 0 });
    let data = TIMING.data.map(|phase| DataPhase { compensation, ..phase });
    let mut can = bench.running(&Config::new(BitTiming { data, ..TIMING }).with_fd());
    assert!(can.registers().dbtp().read().tdc());
    assert_eq!(can.registers().tdcr().read().tdco(), 6);
    can.send_queued(&crate::bench::frame("123##1AABB"), can_hal::m_can::TxOptions::default()).unwrap();
    bench.sim.run_for(crate::bench::FRAME);
    assert_eq!(bench.seen(other), ["123##1AABB"]);
    assert!(can.protocol_status().secondary_sample_point >= 6);
    bench.finish();
}

/// 2.4.1: all sections at their largest are 4352 words.
#[test]
fn section_2_4_1_message_ram() {
    let largest = Sizes {
        standard_filters: 128,
        extended_filters: 64,
        rx_fifo_0: 64,
        rx_fifo_1: 64,
        rx_buffers: 64,
        tx_events: 32,
        tx_dedicated: 12,
        tx_queue: 20,
        ..Sizes::NONE
    }
    .with_data(DataFieldSize::Bytes64);
    const { assert!(Layout::packed(&Sizes::NONE).is_ok()) };
    assert_eq!(Layout::packed(&largest).unwrap().bytes(), 4352 * 4);
    let too_many = |section, count, max| Err(LayoutError::TooMany { section, count, max });
    let layout = |sizes: Sizes| Layout::packed(&sizes).map(|_| ());
    assert_eq!(layout(Sizes { tx_queue: 21, ..largest }), too_many("tx_buffers", 33, 32));
    assert_eq!(layout(Sizes { rx_fifo_1: 65, ..largest }), too_many("rx_fifo_1", 65, 64));
    assert_eq!(layout(Sizes { standard_filters: 129, ..largest }), too_many("standard_filters", 129, 128));
}

/// 2.4.1: start addresses are word addresses within 64 KiB; a part of a shared Message RAM is used as its own.
#[test]
#[allow(unsafe_code, reason = "simulated memory")]
fn section_2_4_1_a_part_of_the_message_ram() {
    let bench = Bench::new();
    let layout = Layout::packed(&Sizes { standard_filters: 4, rx_fifo_0: 2, tx_queue: 2, ..Sizes::NONE }).unwrap();
    let take = |address, bytes| {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(bench.sim.memory(bench.ram), address, bytes) };
        Can::<_, RegisterBus<'_>, MemoryBus<'_>>::new(bench.sim.registers(bench.id), region, layout, Polls(20))
    };
    assert_eq!(layout.bytes(), 16 + 2 * 16 + 2 * 16);
    let mut can = take(0x1000, 80).unwrap();
    can.configure(&Config::new(TIMING)).unwrap();
    assert_eq!(can.registers().sidfc().read().flssa(), 0x1000 / 4);
    assert_eq!(can.registers().rxf0c().read().f0sa(), 0x1010 / 4);
    assert_eq!(can.registers().txbc().read().tbsa(), 0x1030 / 4);
    let refused = |error| Some(ConfigError::Layout(error));
    assert_eq!(take(0, 79).err(), refused(LayoutError::TooLong { bytes: 80, room: 79 }));
    assert_eq!(take(0xFFF0, 80).err(), refused(LayoutError::Address { address: 0xFFF0 }));
    assert_eq!(take(2, 80).err(), refused(LayoutError::Address { address: 2 }));
}
