//! Bit timing, DMA, what cannot be configured (6.0, 9.3, 10.0).

use can_hal::{
    OutOfRange, Polls, Region,
    dspic33_ecan::{
        BufferCount, Can, Config, ConfigError, Filter, FilterError, FilterTarget, Mask, MaskSource, TxPriority, Use,
    },
    memory::{DsPic33EcanMemory, LayoutError},
    timing::{DsPic33EcanTiming, Request, SamplePoint},
};
use can_sim::{DiagnosticKind, MemoryBus, RegisterBus, dspic33_ecan::DmaChannel};

use crate::bench::{BYTES, Bench, CONFIG, FRAME, MODE, PLAN, SEGMENTS, TIMING, TO_FIFO, frame, sending, standard};

/// Example 6-1: FCY 40 MHz, 1 Mbit/s, 20 time quanta, propagation 5, sample point at 70 %.
#[test]
fn example_6_1_bit_timing_calculation() {
    let quanta = SEGMENTS.quanta();
    assert_eq!(quanta, 20);
    let quantum_rate = quanta * 1_000_000;
    assert_eq!(40_000_000 / (2 * quantum_rate) - 1, 0, "Equation 6-2: BRP");
    assert_eq!(SEGMENTS.sample_point(), SamplePoint::percent(70));
    let request = Request::new(40_000_000, 1_000_000).sample_point(SamplePoint::percent(70));
    let solved = DsPic33EcanTiming::solve(&request).unwrap();
    assert_eq!((solved.cfg1.brp(), solved.cfg2.seg2ph()), (0, 5));
}

/// Example 6-2: the module in configuration mode, bit timing, normal mode; the registers as printed. Its comment names a
/// clock FCAN, which is FCY (`example_6_2_clock`).
#[test]
fn example_6_2_configuring_bit_timing() {
    let bench = Bench::new();
    let can = bench.configured(&PLAN, &CONFIG);
    assert_eq!(can.registers().cfg1().read().bits(), 0x00C0, "SJW 3, BRP 0");
    assert_eq!(can.registers().cfg2().read().bits(), 0x05FC, "SEG2PH 5, SEG2PHTS 1, SAM 1, SEG1PH 7, PRSEG 4");
    let other = bench.peer();
    let mut can = can.start_normal(MODE).unwrap();
    bench.send(other, &["123#01"]);
    assert_eq!(can.receive_buffer(8).map(|message| message.frame), Some(frame("123#01")));
    bench.finish();
}

/// 6.4, notes: what the formulas forbid has no solution.
#[test]
fn section_6_4_impossible_bit_rates() {
    for (clock, rate) in [(40_000_000, 1_300_000), (40_000_000, 2_000_000), (12_000_000, 1_000_000)] {
        assert!(DsPic33EcanTiming::solve(&Request::new(clock, rate)).is_err(), "{rate} bit/s at {clock} Hz");
    }
    // The slowest one: 25 time quanta, prescaler 64.
    let slowest = Request::new(40_000_000, 12_500).sample_point(SamplePoint::percent(68));
    assert_eq!(DsPic33EcanTiming::solve(&slowest).map(|timing| timing.cfg1.brp()), Ok(63));
}

/// Example 10-1, both: a channel for transmission and one for reception, eight words for each message. Its second part
/// starts at a constant 0 (`dma_channels`); both channels have the plan's start.
#[test]
#[allow(unsafe_code, reason = "simulated memory")]
fn example_10_1_dma_channels() {
    let plan = DsPic33EcanMemory::new(0x200, BYTES, BufferCount::Buffers16, 8).fixed();
    let bench = Bench::with(|mut config| {
        config.transmit_dma = Some(DmaChannel::new(plan.start));
        config.receive_dma = Some(DmaChannel::new(plan.start));
        config
    });
    let other = bench.peer();
    // The driver has only the part of DMA RAM that the buffers are in.
    struct Part<'a>(MemoryBus<'a>);
    impl Clone for Part<'_> {
        fn clone(&self) -> Self {
            *self
        }
    }
    impl Copy for Part<'_> {}
    impl regbus::Bus for Part<'_> {
        fn read<W: regbus::Word>(self, offset: usize) -> W {
            self.0.read(0x200 + offset)
        }
        fn write<W: regbus::Word>(self, offset: usize, value: W) {
            self.0.write(0x200 + offset, value);
        }
    }
    // SAFETY: nothing else uses this memory.
    let region = unsafe { Region::new(Part(bench.sim.memory(bench.ram)), plan.start, 256) };
    let mut can = Can::new(bench.sim.registers(bench.id), region, &plan, MODE).unwrap();
    can.configure(&sending(&[(0, Use::Dedicated(TxPriority::Highest))])).unwrap();
    let mut can = can.start_normal(MODE).unwrap();
    can.send_buffer(0, &frame("100#01")).unwrap();
    bench.sim.run_for(FRAME);
    bench.send(other, &["200#02"]);
    assert_eq!(bench.seen(other), ["100#01"]);
    assert_eq!(can.receive_buffer(8).map(|message| message.frame), Some(frame("200#02")));
    let statistics = bench.sim.inspect(bench.id, |model| model.dma_statistics());
    assert_eq!(statistics.map(|channel| (channel.words, channel.interrupts)), [(8, 1), (8, 1)]);
    bench.finish();
}

/// 10.0: without a channel nothing arrives; the module does not tell, the simulation does.
#[test]
fn section_10_0_without_a_dma_channel() {
    let bench = Bench::with(|mut config| {
        config.receive_dma = None;
        config
    });
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG);
    bench.send(other, &["200#02"]);
    assert_eq!(can.receive_message(), Ok(None));
    let kinds: Vec<_> = bench.sim.diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect();
    assert!(matches!(kinds[..], [DiagnosticKind::TransferNotServed { request: "CxRX", buffer: 8, .. }]), "{kinds:?}");
}

/// The buffers must lie in the region.
#[test]
#[allow(unsafe_code, reason = "simulated memory")]
fn section_9_2_buffers_outside_the_region() {
    let bench = Bench::new();
    let take = |address, bytes| {
        // SAFETY: nothing else uses this memory.
        let region = unsafe { Region::new(bench.sim.memory(bench.ram), address, bytes) };
        Can::<_, RegisterBus<'_>, MemoryBus<'_>>::new(bench.sim.registers(bench.id), region, &PLAN, Polls(20))
    };
    assert!(take(0, 512).is_ok());
    for (address, bytes) in [(0, 511), (16, 512)] {
        assert_eq!(take(address, bytes).err(), Some(ConfigError::OutsideRegion(PLAN.buffers())));
    }
    // 9.3: the FIFO must not start behind the last buffer.
    let memory = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers12, 12);
    assert_eq!(memory.plan().err(), Some(LayoutError::FifoStart { start: 12, buffers: 12 }));
}

/// What the manual forbids is refused, and nothing is changed.
#[test]
fn configurations_that_are_refused() {
    let bench = Bench::new();
    let few = DsPic33EcanMemory::new(0, BYTES, BufferCount::Buffers6, 2).fixed();
    let mut can = bench.driver(&few);
    let before = can.registers().cfg1().read();
    let dedicated = Use::Dedicated(TxPriority::Lowest);
    let base = Config::new(TIMING);
    let to = |target| [Filter::new(standard(1), MaskSource::Mask0, target)];
    let (to_5, to_6, to_15) = (to(FilterTarget::Buffer(5)), to(FilterTarget::Buffer(6)), to(FilterTarget::Buffer(15)));
    let too_many = [to_5[0]; 17];
    let with = |filters| base.with_filters([Mask::ANY; 3], filters);
    let cases = [
        // Register 4-24, dncnt_above_18.
        (
            Config { data_bits: 19, ..base },
            ConfigError::OutOfRange(OutOfRange { field: "CTRL2.DNCNT", value: 19, min: 0, max: 18 }),
        ),
        (base.with_use(6, dedicated), ConfigError::NoSuchBuffer { buffer: 6, count: 6 }),
        // 9.3: no transmit buffer in the FIFO.
        (base.with_filters([Mask::ANY; 3], TO_FIFO).with_use(2, dedicated), ConfigError::SendsFromFifo { buffer: 2 }),
        (
            base.with_use(0, Use::Queue).with_use(1, Use::Reply(TxPriority::Lowest)),
            ConfigError::PairAnswers { buffer: 0 },
        ),
        (with(&too_many), ConfigError::Filter(FilterError::NoSuchFilter { filter: 16 })),
        // pointer_beyond_buffers.
        (with(&to_6), ConfigError::Filter(FilterError::NoSuchBuffer { filter: 0, buffer: 6 })),
        // 9.2.4: 15 is the FIFO.
        (with(&to_15), ConfigError::Filter(FilterError::NoSuchBuffer { filter: 0, buffer: 15 })),
        // 9.2.2.
        (with(&to_5).with_use(5, dedicated), ConfigError::Filter(FilterError::BufferSends { filter: 0, buffer: 5 })),
    ];
    for (config, expected) in cases {
        assert_eq!(can.configure(&config), Err(expected), "{expected}");
        assert_eq!(can.registers().cfg1().read(), before);
    }
    bench.finish();
}

/// Register 4-3: filters that are not configured are disabled; a second configuration leaves nothing of the first.
#[test]
fn register_4_3_nothing_of_an_earlier_configuration_stays() {
    let bench = Bench::with(|mut config| {
        config.unknown_reset = can_sim::registers::UnknownReset::Pattern(1);
        config
    });
    let other = bench.peer();
    let mut can = bench.configured(&PLAN, &CONFIG.with_use(0, Use::Queue));
    assert_eq!(can.registers().fen1().read().bits(), 1);
    let mut wide = Config::new(TIMING);
    (wide.capture, wide.stop_in_idle, wide.data_bits, wide.wake_up_filter) = (true, true, 18, true);
    can.configure(&wide).unwrap();
    let regs = can.registers();
    assert!(regs.ctrl1().read().cancap() && regs.ctrl1().read().csidl() && regs.cfg2().read().wakfil());
    can.configure(&Config::new(TIMING)).unwrap();
    let regs = can.registers();
    assert_eq!((regs.fen1().read().bits(), regs.ctrl2().read().bits()), (0, 0));
    assert_eq!((regs.ctrl1().read().bits(), regs.cfg2().read().bits()), (0x0480, 0x05FC));
    assert_eq!(regs.tr_con(0).read().bits(), 0);
    let mut can = can.start_normal(MODE).unwrap();
    bench.send(other, &["123#01"]);
    assert_eq!(can.receive_message(), Ok(None));
    bench.finish();
}
