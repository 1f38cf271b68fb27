//! Printed numbers: bit timing, Message RAM, what cannot be configured.

use can_hal::{
    OutOfRange, Polls, Region,
    m_can::{Can, Config, ConfigError, DataFieldSize, Timestamping},
    memory::MCanMemory,
    timing::{BitTiming, Compensation, DataPhase, MCanTiming, Segments},
};
use can_sim::{MemoryBus, RegisterBus};

use crate::bench::{Bench, MEMORY, REQUEST, TIMING};

fn quanta(prescaler: u32, before: u32, phase2: u32, jump_width: u32) -> Segments {
    Segments { prescaler, propagation: 0, phase1: before, phase2, jump_width }
}

fn timing(nominal: Segments, segments: Segments) -> MCanTiming {
    let data = Some(DataPhase { segments, compensation: None });
    MCanTiming::of(&BitTiming { nominal, data, three_samples: false }).unwrap()
}

/// 2.3.8, 2.3.4: at 8 MHz the reset values stand for 500 kbit/s: 16 time quanta. The appendix prints another reset value
/// of NBTP; section 2.3.8 and Table 1 are right.
#[test]
fn sections_2_3_4_and_2_3_8_reset_values_are_500_kbit_s_at_8_mhz() {
    let bench = Bench::new();
    let segments = quanta(1, 11, 4, 4);
    let can = bench.configured(&Config::new(timing(segments, segments)));
    assert_eq!(can.registers().nbtp().read().bits(), 0x0600_0A03);
    assert_eq!(can.registers().dbtp().read().bits(), 0x0000_0A33);
    assert_eq!(segments.bit_rate(8_000_000, 1).get(), 500_000);
}

/// 3.1.4: at 20 MHz the shortest data bit of 4 time quanta is 5 Mbit/s; 2.3.4: the longest has 49.
#[test]
fn section_3_1_4_shortest_and_longest_bits() {
    let bench = Bench::new();
    let cases = [
        (quanta(1, 2, 2, 2), quanta(1, 1, 2, 1), (0x0000_0101 | 1 << 25, 0x0000_0010)),
        (quanta(512, 256, 128, 128), quanta(32, 32, 16, 16), (0xFFFF_FF7F, 0x001F_1FFF)),
    ];
    for (nominal, data, (nbtp, dbtp)) in cases {
        let can = bench.configured(&Config::new(timing(nominal, data)));
        assert_eq!((can.registers().nbtp().read().bits(), can.registers().dbtp().read().bits()), (nbtp, dbtp));
    }
    assert_eq!(quanta(1, 1, 2, 1).bit_rate(20_000_000, 1).get(), 5_000_000);
}

/// 3.1.4.1: offset and filter window of the transmitter delay compensation.
#[test]
fn section_3_1_4_transmitter_delay_compensation() {
    let bench = Bench::new();
    let other = bench.peer();
    let compensated = MCanTiming::solve(&REQUEST.compensation(Compensation::On)).unwrap();
    let mut can = bench.running(&Config::new(compensated).with_fd());
    assert!(can.registers().dbtp().read().tdc());
    let offset = can.registers().tdcr().read().tdco();
    assert_eq!(offset, compensated.tdcr.tdco());
    can.send_queued(&crate::bench::frame("123##1AABB"), can_hal::m_can::TxOptions::default()).unwrap();
    bench.sim.run_for(crate::bench::FRAME);
    assert_eq!(bench.seen(other), ["123##1AABB"]);
    assert!(can.protocol_status().secondary_sample_point >= offset);
    bench.finish();
}

/// 2.3.9: what a field does not take is refused with its limits.
#[test]
fn section_2_3_9_values_out_of_range() {
    let bench = Bench::new();
    let mut can = bench.driver(&MEMORY);
    let out = |field, value, min, max| Err(ConfigError::OutOfRange(OutOfRange { field, value, min, max }));
    for bit_times in [0, 17] {
        let timestamps = Timestamping::Counter { bit_times };
        let expected = out("TSCC.TCP", u32::from(bit_times), 1, 16);
        assert_eq!(can.configure(&Config { timestamps, ..Config::new(TIMING) }), expected);
    }
    let config = Config { rx_watermark: [128, 0], ..Config::new(TIMING) };
    assert_eq!(can.configure(&config), out("RXF0C.F0WM", 128, 0, 127));
    let config = Config { tx_event_watermark: 64, ..Config::new(TIMING) };
    assert_eq!(can.configure(&config), out("TXEFC.EFWM", 64, 0, 63));
}

/// 2.4.1: a worked configuration; every start address and size reaches its register.
#[test]
fn section_2_4_1_message_ram() {
    let bench = Bench::new();
    let memory = MCanMemory::new(4352 * 4)
        .standard_filters(28)
        .extended_filters(8)
        .rx_fifo_0(32, DataFieldSize::Bytes64)
        .rx_fifo_1(4, DataFieldSize::Bytes12)
        .rx_buffers(2, DataFieldSize::Bytes48)
        .tx_event_fifo(8)
        .tx_buffers(12, 20, DataFieldSize::Bytes20);
    let mut can = bench.driver(&memory);
    can.configure(&Config { rx_watermark: [16, 0], tx_event_watermark: 4, ..Config::new(TIMING) }).unwrap();
    let plan = memory.plan().unwrap();
    let regs = can.registers();
    assert_eq!(regs.sidfc().read(), plan.sidfc);
    assert_eq!(regs.xidfc().read(), plan.xidfc);
    assert_eq!(regs.rxf0c().read(), plan.rxf0c.with_f0wm(16));
    assert_eq!(regs.rxf1c().read(), plan.rxf1c);
    assert_eq!(regs.rxbc().read(), plan.rxbc);
    assert_eq!(regs.rxesc().read(), plan.rxesc);
    assert_eq!(regs.txefc().read(), plan.txefc.with_efwm(4));
    assert_eq!(regs.txbc().read(), plan.txbc);
    assert_eq!(regs.txesc().read(), plan.txesc);
    assert_eq!((can.fifo_data_len(can_hal::m_can::RxFifo::Fifo1), plan.rxf1c.f1s()), (12, 4));
}

/// 2.4.1: a part of a shared Message RAM is used as its own, and nothing outside.
#[test]
#[allow(unsafe_code, reason = "simulated memory")]
fn section_2_4_1_a_part_of_the_message_ram() {
    let bench = Bench::new();
    let memory = MCanMemory::new(0x2000).standard_filters(4).rx_fifo_0(2, DataFieldSize::Bytes8).tx_buffers(
        0,
        2,
        DataFieldSize::Bytes8,
    );
    let take = |origin, address, bytes| {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(bench.sim.memory(bench.ram), address, bytes) };
        let plan = memory.origin(origin).plan().unwrap();
        Can::<_, RegisterBus<'_>, MemoryBus<'_>>::new(bench.sim.registers(bench.id), region, &plan, Polls(20))
    };
    let mut can = take(0x1000, 0, 0x1050).unwrap();
    can.configure(&Config::new(TIMING)).unwrap();
    assert_eq!(can.registers().sidfc().read().flssa(), 0x1000 / 4);
    assert_eq!(can.registers().rxf0c().read().f0sa(), 0x1010 / 4);
    assert_eq!(can.registers().txbc().read().tbsa(), 0x1030 / 4);
    for (origin, address, bytes) in [(0x1000, 0, 0x104F), (0x1000, 0x1004, 0x1000), (0, 0x10, 0x1000)] {
        let refused = take(origin, address, bytes).err();
        assert!(matches!(refused, Some(ConfigError::OutsideRegion(_))), "{refused:?}");
    }
}

/// 2.3.2: release 0.2.0 of 2009-03-26; 2.3.3: the endianness test value.
#[test]
fn sections_2_3_2_and_2_3_3_core_release_and_endianness() {
    let bench = Bench::with(|mut config| {
        config.core_release = 0x0209_0326;
        config
    });
    let can = bench.driver(&MEMORY);
    let release = can.registers().crel().read();
    assert_eq!((release.rel(), release.step(), release.substep()), (0, 2, 0));
    // Two decimal digits in four bits each; the year has one.
    assert_eq!((release.year(), release.mon(), release.day()), (0x9, 0x03, 0x26));
    assert_eq!(can.registers().endn().read().etv(), 0x8765_4321);
}
