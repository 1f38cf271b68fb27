//! The code examples 6-1, 7-1 and 9-1, printed numbers, and what cannot be configured.

use can_hal::{
    ExtendedId, FdFlags, Frame, Outcome, Polls, StandardId, Transmit,
    dspic33_canfd::{
        Attempts, Can, Config, ConfigError, Filter, FilterError, Matching, PayloadSize, Reference, Reply, Sequence,
        Timestamping, TxOptions,
    },
    memory::DsPic33CanFdPlan,
    timing::{
        BitTiming, Compensation, DataPhase, DelayCompensation, DsPic33CanFdTiming, Request, SamplePoint, Segments,
    },
};

use crate::bench::{BASE, Bench, CONFIG, FRAME, MEMORY, MODE, PLAN, TIMING, frame, rx, tx};

/// 1 Mbit/s and 2 Mbit/s at 40 MHz, sample points at 80 %, as all three examples have it.
const EXAMPLE: Request = Request::new(40_000_000, 1_000_000)
    .sample_point(SamplePoint::percent(80))
    .data(2_000_000)
    .data_sample_point(SamplePoint::percent(80));

/// The registers that the examples write, in order: NBTCFGH, NBTCFGL, DBTCFGH, DBTCFGL, TDCH, TDCL.
fn words(timing: &DsPic33CanFdTiming) -> [u16; 6] {
    [
        timing.nbtcfgh.bits(),
        timing.nbtcfgl.bits(),
        timing.dbtcfgh.bits(),
        timing.dbtcfgl.bits(),
        timing.tdch.bits(),
        timing.tdcl.bits(),
    ]
}

/// 1 Mbit/s and 2 Mbit/s of the examples, solved, with the offset that 5.3.8 recommends.
fn example_timing() -> DsPic33CanFdTiming {
    DsPic33CanFdTiming::solve(&EXAMPLE.compensation(Compensation::On)).unwrap()
}

/// A peer at the examples' bit rates.
fn example_peer(bench: &Bench) -> can_sim::PeerId {
    let config = can_wire::NodeConfig {
        data: can_wire::BitTiming { prescaler: 1, prop_seg: 7, phase_seg1: 8, phase_seg2: 4, sjw: 4 },
        ..can_wire::NodeConfig::new()
    };
    let peer = bench.sim.add_peer(config).unwrap();
    bench.sim.run_for(FRAME);
    peer
}

/// Example 6-1: the queue holds one message of 64 bytes, FIFO 1 two of 16. The statement that sets TXEN, lost in a comment
/// of the print, is made; UINC and TXREQ go in one write, as 6.4 demands and the example does not; the words of the objects
/// that the example leaves as RAM holds them are written; C1DBTCFGH is 0x000E.
#[test]
fn example_6_1_message_transmission() {
    const PLAN: DsPic33CanFdPlan = MEMORY.txq(1, PayloadSize::Bytes64).fifo(1, tx(2, PayloadSize::Bytes16)).fixed();
    let bench = Bench::new();
    bench.sim.with_memory(bench.ram, |memory| memory.words_mut().fill(0xFFFF_FFFF));
    let peer = example_peer(&bench);
    let timing = example_timing();
    assert_eq!(words(&timing), [0x001E, 0x0707, 0x000E, 0x0303, 0x0002, 0x0F00]);
    let mut can = bench.configured(&PLAN, &Config::new(timing).with_fd()).start_normal(MODE).unwrap();
    let regs = can.registers();
    assert_eq!(regs.read_fifoba(), BASE);
    assert_eq!((regs.txqcon_h().read().bits() >> 8, regs.fifo(1).con_h().read().bits() >> 8), (0xE0, 0x41));
    assert!(!regs.con_l().read().brsdis() && !regs.con_h().read().stef() && regs.con_h().read().txqen());
    let flags = FdFlags { brs: true, esi: false };
    let frames = [
        Frame::fd(StandardId::new(0x100).unwrap(), &[0x5A; 64], flags).unwrap(),
        Frame::fd(StandardId::new(0x300).unwrap(), &[0xA5; 16], flags).unwrap(),
        Frame::fd(ExtendedId::new(0x500 << 18 | 0xC000).unwrap(), &[0x55; 12], flags).unwrap(),
    ];
    let first = can.send_queued(&frames[0], TxOptions::default()).unwrap();
    let second = can.send_fifo(1, &frames[1], TxOptions::default()).unwrap();
    let third = can.send_fifo(1, &frames[2], TxOptions::default()).unwrap();
    for ticket in [first, second, third] {
        assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    }
    bench.sim.run_for(FRAME);
    let seen: Vec<Frame> = bench.sim.peer_received(peer).iter().map(|(_, frame)| *frame).collect();
    assert_eq!(seen, frames);
    // What the manual's words make of the three objects.
    let word = |offset: usize| bench.sim.with_memory(bench.ram, |memory| memory.words()[offset / 4]);
    assert_eq!((word(0), word(4)), (0x0000_0100, 0x0000_00CF));
    assert_eq!((word(0x48), word(0x4C)), (0x0000_0300, 0x0000_00CA));
    assert_eq!((word(0x60), word(0x64)), (0x0600_0500, 0x0000_00D9));
    bench.finish();
}

/// Example 7-1: five messages with sequence numbers, and the five events. The plan takes 420 bytes where the example
/// reserves 200; the Time Base Counter, which the example never enables, is switched on.
#[test]
fn example_7_1_transmit_event_fifo() {
    const PLAN: DsPic33CanFdPlan = MEMORY.tef(5, true).fifo(1, tx(5, PayloadSize::Bytes64)).fixed();
    let bench = Bench::new();
    let _peer = example_peer(&bench);
    assert_eq!(PLAN.end() - BASE, 420);
    let mut config = Config::new(example_timing()).with_fd();
    config.timestamps = Timestamping::Counter { clocks: 40, reference: Reference::StartOfFrame };
    let mut can = bench.configured(&PLAN, &config).start_normal(MODE).unwrap();
    let regs = can.registers();
    assert!(regs.con_h().read().stef() && !regs.con_h().read().txqen());
    assert_eq!((regs.tefcon_h().read().fsize(), regs.fifo(1).con_h().read().fsize()), (4, 4));
    let flags = FdFlags { brs: true, esi: false };
    let message = Frame::fd(StandardId::new(0x300).unwrap(), &[0xA5; 64], flags).unwrap();
    for number in 0..5 {
        can.send_fifo(1, &message, TxOptions { sequence: Sequence::new(number).unwrap() }).unwrap();
    }
    bench.sim.run_until(FRAME * 5, |_| can.pending_fifos() == 0).unwrap();
    let mut before = 0;
    for number in 0..5 {
        let event = can.tx_event().unwrap().unwrap();
        assert_eq!((event.sequence, event.id, event.dlc), (number, message.id(), message.dlc()));
        assert_eq!(event.format, message.format());
        let time = event.timestamp.unwrap();
        assert!(time > before, "{time} microseconds");
        before = time;
    }
    assert_eq!(can.tx_event(), Ok(None));
    bench.finish();
}

/// Example 9-1: FIFO 1 holds two messages of 64 bytes with timestamps. The example's mask, whose comment leaves out a bit,
/// lets in the extended identifiers 2 and 3. The user address is read for every message, not once.
#[test]
fn example_9_1_message_reception() {
    const PLAN: DsPic33CanFdPlan = MEMORY.fifo(1, rx(2, PayloadSize::Bytes64, true)).fixed();
    let bench = Bench::new();
    let peer = example_peer(&bench);
    let filters = [Filter::extended_mask(ExtendedId::new(2).unwrap(), 0x1FFF_FFFE, 1)];
    let config = Config::new(example_timing()).with_fd().with_filters(&filters);
    let mut can = bench.configured(&PLAN, &config).start_normal(MODE).unwrap();
    let regs = can.registers();
    assert_eq!((regs.flt_con(0).read().bits(), regs.flt(0).obj_l().read().bits()), (0x0081, 0x1000));
    assert_eq!((regs.flt(0).obj_h().read().bits(), regs.flt(0).mask_l().read().bits()), (0x4000, 0xF7FF));
    // The example writes 0xFFFF: bit 15 does not exist, and MSID11 counts only with SID11EN.
    assert_eq!(regs.flt(0).mask_h().read().bits(), 0x5FFF);
    assert_eq!(regs.fifo(1).read_ua(), BASE);
    for text in ["00000001#", "00000004#", "002#", "00040002#"] {
        bench.sim.peer_send(peer, frame(text));
    }
    bench.sim.run_for(FRAME * 4);
    assert_eq!(can.receive_fifo(1), Ok(None));
    for round in 0..3_u8 {
        let id = ExtendedId::new(2 | u32::from(round) & 1).unwrap();
        let message = Frame::fd(id, &[round; 64], FdFlags { brs: true, esi: false }).unwrap();
        bench.sim.peer_send(peer, message);
        bench.sim.run_for(FRAME);
        let received = can.receive_fifo(1).unwrap().unwrap();
        assert_eq!((received.frame, received.filter), (message, 0));
        assert_eq!(received.timestamp, Some(0), "the counter is not enabled");
    }
    bench.finish();
}

/// Tables 5-3 to 5-5: 500 kbit/s and 2 Mbit/s at 80 MHz with sample points at 80 %.
#[test]
fn tables_5_3_to_5_5_bit_timing() {
    let segments =
        |before, after| Segments { prescaler: 1, propagation: 0, phase1: before, phase2: after, jump_width: after };
    let compensation = Some(DelayCompensation { offset: 31, filter: 0 });
    let timing = BitTiming {
        nominal: segments(127, 32),
        data: Some(DataPhase { segments: segments(31, 8), compensation }),
        three_samples: false,
    };
    let expected = [0x007E, 0x1F1F, 0x001E, 0x0707, 0x0002, 0x1F00];
    assert_eq!(words(&DsPic33CanFdTiming::of(&timing).unwrap()), expected);
    let bench = Bench::with(|config| config.with_clock(80_000_000));
    let can = bench.configured(&PLAN, &Config::new(DsPic33CanFdTiming::of(&timing).unwrap()).with_fd());
    let regs = can.registers();
    assert_eq!((regs.read_nbtcfg(), regs.read_dbtcfg(), regs.read_tdc()), (0x007E_1F1F, 0x001E_0707, 0x0002_1F00));
    let _ = can.start_normal(MODE).unwrap();
    let node = bench.sim.node(bench.id);
    let (nominal, data) = bench.sim.with_wire(|wire| {
        let config = wire.config(node);
        (config.nominal.bit_rate(config.clock_hz), config.data.bit_rate(config.clock_hz))
    });
    assert_eq!((nominal, data), (500_000, 2_000_000));
    bench.finish();
}

/// Table 10-1: the plan of the example in chapter 10.
#[test]
fn table_10_1_memory_layout() {
    let plan = can_hal::memory::DsPic33CanFdMemory::new(0x1400, 0x1000)
        .tef(12, true)
        .txq(8, PayloadSize::Bytes32)
        .fifo(1, tx(5, PayloadSize::Bytes64))
        .fifo(2, rx(16, PayloadSize::Bytes64, true))
        .plan()
        .unwrap();
    let bench = Bench::new();
    let can = bench.configured(&plan, &CONFIG.with_filters(&[Filter::any(2)])).start_normal(MODE).unwrap();
    let regs = can.registers();
    assert_eq!((regs.read_tefua(), regs.read_txqua()), (0x1400, 0x1490));
    assert_eq!((regs.fifo(1).read_ua(), regs.fifo(2).read_ua()), (0x15D0, 0x1738));
    bench.finish();
}

/// Equation 5-24: a second plan leaves nothing of the first, also not in the FIFOs that it does not set up.
#[test]
fn a_second_plan() {
    let bench = Bench::new();
    let _ = bench.running(&CONFIG);
    let plan = MEMORY.fifo(6, rx(2, PayloadSize::Bytes8, false)).plan().unwrap();
    let can = bench.configured(&plan, &CONFIG.with_filters(&[Filter::any(6)])).start_normal(MODE).unwrap();
    let regs = can.registers();
    assert_eq!(u64::from(regs.fifo(6).read_ua()), plan.fifo(6).unwrap().placed.start.into());
    assert_eq!(plan.fifo(6).unwrap().placed.start, BASE + 5 * 16);
    assert_eq!(regs.fifo(3).con_l().read().bits(), 0);
    bench.finish();
}

/// What is wrong is said before the module is started.
#[test]
fn what_cannot_be_configured() {
    let bench = Bench::new();
    let outside = can_hal::memory::DsPic33CanFdMemory::new(0x3000, 0x1000).txq(1, PayloadSize::Bytes8).plan().unwrap();
    let made = Can::new(bench.sim.registers(bench.id), bench.region(), &outside, MODE);
    assert!(matches!(made, Err(ConfigError::OutsideRegion(_))));
    let mut can = bench.driver(&PLAN);
    let mut refused = |change: &dyn Fn(&mut Config<'_>)| {
        let mut config = CONFIG;
        change(&mut config);
        can.configure(&config).unwrap_err()
    };
    let out_of_range = |error| matches!(error, ConfigError::OutOfRange(_));
    assert!(out_of_range(refused(&|config| config.data_filter_bits = 19)));
    let clocks = |clocks| Timestamping::Counter { clocks, reference: Reference::Valid };
    assert!(out_of_range(refused(&|config| config.timestamps = clocks(0))));
    assert!(out_of_range(refused(&|config| config.timestamps = clocks(1025))));
    assert!(out_of_range(refused(&|config| config.priorities = &[(3, 32)])));
    assert_eq!(refused(&|config| config.priorities = &[(1, 1)]), ConfigError::NotTransmitting { fifo: 1 });
    assert_eq!(refused(&|config| config.priorities = &[(77, 1)]), ConfigError::NotTransmitting { fifo: 77 });
    const TO_NOWHERE: [Filter; 1] = [Filter::any(9)];
    let no_fifo = ConfigError::Filter(FilterError::NoSuchFifo { fifo: 9 });
    assert_eq!(refused(&|config| config.filters = &TO_NOWHERE), no_fifo);
    const TO_QUEUE: [Filter; 1] = [Filter::any(0)];
    let queue = ConfigError::Filter(FilterError::NoSuchFifo { fifo: 0 });
    assert_eq!(refused(&|config| config.filters = &TO_QUEUE), queue);
    const WIDE: [Filter; 1] = [Filter { matching: Matching::TwelveBit(0x1000, 0), fifo: 1 }];
    assert!(matches!(refused(&|config| config.filters = &WIDE), ConfigError::Filter(FilterError::TooWide { .. })));
    const MANY: [Filter; 33] = [Filter::any(1); 33];
    let many = ConfigError::Filter(FilterError::NoSuchFilter { index: 32 });
    assert_eq!(refused(&|config| config.filters = &MANY), many);
    let long = Reply { fifo: 4, frame: frame("123##0000102030405060708090A0B") };
    assert!(matches!(can.configure(&Config { replies: &[long], ..CONFIG }), Err(ConfigError::Reply(_))));
    let wrong = Reply { fifo: 1, frame: frame("123#") };
    let error = can.configure(&Config { replies: &[wrong], ..CONFIG });
    assert_eq!(error, Err(ConfigError::NotTransmitting { fifo: 1 }));
    assert_eq!(Sequence::new(0x80_0000), None);
}

/// Every bit of the configuration arrives in its register, and a second configuration leaves nothing of the first.
#[test]
fn the_configuration_in_registers() {
    let bench = Bench::new();
    let mut can = bench.driver(&PLAN);
    let mut config = CONFIG;
    config.fd = can_hal::dspic33_canfd::FdMode::Fd { bit_rate_switch: false, non_iso: true };
    config.attempts = Attempts::Three;
    config.priorities = &[(0, 7), (3, 31), (5, 1)];
    config.bandwidth_sharing = can_hal::dspic33_canfd::BandwidthSharing::BitTimes256;
    (config.gateway_esi, config.listen_after_system_error, config.no_protocol_exception) = (true, true, true);
    (config.edge_filtering, config.twelve_bit_ids, config.stop_in_idle, config.auxiliary_clock) =
        (true, true, true, true);
    config.data_filter_bits = 18;
    config.wake_up_filter = Some(can_hal::dspic33_canfd::WakeUpFilter::T01Filter);
    config.timestamps = Timestamping::Counter { clocks: 1024, reference: Reference::AfterFdf };
    can.configure(&config).unwrap();
    let regs = can.registers();
    assert_eq!(regs.con_l().read().bits(), 0x8000 | 0x2000 | 0x1000 | 0x0200 | 0x0100 | 0x0080 | 0x0040 | 18);
    assert_eq!(regs.con_h().read().bits(), 0x8000 | 0x0400 | 0x0080 | 0x001F);
    assert_eq!(regs.tdc_h().read().bits() & 0x0300, 0x0300);
    assert_eq!((regs.tscon_l().read().bits(), regs.tscon_h().read().bits()), (1023, 0x0005));
    let size = |number: usize| regs.fifo(number).con_h().read();
    assert_eq!((regs.txqcon_h().read().txpri(), size(3).txpri(), size(4).txpri(), size(5).txpri()), (7, 31, 0, 1));
    assert_eq!(size(3).txat().bits(), 1);
    can.configure(&Config::new(TIMING)).unwrap();
    let regs = can.registers();
    assert_eq!(regs.con_l().read().bits(), 0x8000 | 0x1000 | 0x0600 | 0x0020);
    assert_eq!(regs.con_h().read().bits(), 0x0400 | 0x0080 | 0x0018);
    assert_eq!((regs.tscon_h().read().bits(), regs.flt_con(0).read().bits() & 0x80), (0, 0));
    assert_eq!(regs.fifo(3).con_h().read().txpri(), 0);
    bench.finish();
}
