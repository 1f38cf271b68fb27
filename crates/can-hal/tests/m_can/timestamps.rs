//! Chapters 3.2 and 3.3: timestamp and timeout counter.

use can_hal::{
    Receive,
    m_can::{Config, Interrupts, RxFifo, RxTimestamp, Timeout, TimeoutSource, Timestamping},
};
use can_sim::Time;

use crate::bench::{Bench, FRAME, TIMING};

fn stamp(message: &can_hal::m_can::RxMessage) -> u16 {
    match message.timestamp {
        RxTimestamp::Counter(value) => value,
        RxTimestamp::Unit(_) => panic!("no Timestamping Unit is configured"),
    }
}

/// 3.2: the internal counter counts periods of 1 to 16 bit times; the time is that of the start of the frame.
#[test]
fn section_3_2_timestamp_generation() {
    for bit_times in [1, 16] {
        let bench = Bench::new();
        let sender = bench.peer();
        let timestamps = Timestamping::Counter { bit_times };
        let mut can = bench.running(&Config { timestamps, ..Config::new(TIMING) });
        can.reset_timestamp_counter();
        bench.send(sender, &["123#"]);
        bench.sim.run_for(Time::from_us(10_000));
        bench.send(sender, &["123#"]);
        let first = stamp(&can.receive_fifo(RxFifo::Fifo0).unwrap().unwrap());
        let second = stamp(&can.receive_fifo(RxFifo::Fifo0).unwrap().unwrap());
        let elapsed = f64::from(second - first) * f64::from(bit_times);
        assert!((elapsed - 10_700.0).abs() <= 40.0, "{elapsed} bit times");
        assert!(!can.interrupt_flags().contains(Interrupts::TSW), "a write is no wrap");
    }
}

/// 3.2: the external timebase.
#[test]
fn section_3_2_external_timebase() {
    let bench = Bench::new();
    let sender = bench.peer();
    let mut can = bench.running(&Config { timestamps: Timestamping::External, ..Config::new(TIMING) });
    bench.send(sender, &["123#"]);
    let now = bench.sim.now().as_ns() / 1_000;
    let at = u64::from(stamp(&can.receive_fifo(RxFifo::Fifo0).unwrap().unwrap()));
    assert!(now - at >= 600 && now - at <= 760, "{at}, now {now}");
    bench.finish();
}

/// 2.3.10: IR.TSW says when the counter wraps.
#[test]
fn section_2_3_10_wrap() {
    let bench = Bench::new();
    let can = bench.running(&Config { timestamps: Timestamping::Counter { bit_times: 1 }, ..Config::new(TIMING) });
    bench.sim.run_for(Time::from_us(60_000));
    assert!(!can.interrupt_flags().contains(Interrupts::TSW));
    bench.sim.run_for(Time::from_us(6_000));
    assert!(can.interrupt_flags().contains(Interrupts::TSW));
    assert!(can.timestamp_counter() < 2_000);
}

/// 3.3: the timeout counter runs from the start, or from the first message in a FIFO.
#[test]
fn section_3_3_timeout_counter() {
    let bench = Bench::new();
    let sender = bench.peer();
    let timeout = |source| Some(Timeout { source, period: 2_000 });
    let config = Config { timeout: timeout(TimeoutSource::RxFifo0), ..Config::new(TIMING) };
    let mut can = bench.running(&config);
    bench.sim.run_for(Time::from_us(5_000));
    assert!(!can.interrupt_flags().contains(Interrupts::TOO), "nothing has been received");
    bench.send(sender, &["123#"]);
    bench.sim.run_for(Time::from_us(2_000));
    assert!(can.interrupt_flags().contains(Interrupts::TOO), "the message waits too long");
    can.fetch().unwrap();
    let config = Config { timeout: timeout(TimeoutSource::Continuous), ..Config::new(TIMING) };
    let mut can = bench.running(&config);
    can.clear_interrupts(Interrupts::TOO);
    for _ in 0..4 {
        bench.sim.run_for(Time::from_us(1_000));
        can.restart_timeout_counter();
    }
    assert!(!can.interrupt_flags().contains(Interrupts::TOO));
    assert!(can.timeout_counter() > 1_900);
    bench.sim.run_for(FRAME * 4);
    assert!(can.interrupt_flags().contains(Interrupts::TOO));
    bench.finish();
}

/// 2.4.2: with a Timestamping Unit the element names one of its registers.
#[test]
fn section_2_4_2_timestamping_unit() {
    use can_hal::{
        StandardId,
        m_can::{Action, Filter},
    };
    let bench = Bench::with(|mut config| {
        config.tsu_registers = Some(4);
        config
    });
    let sender = bench.peer();
    let id = |id| StandardId::new(id).unwrap();
    let filters = [Filter::exact(id(0x100), Action::Fifo0).with_sync(), Filter::exact(id(0x200), Action::Fifo0)];
    let config = Config { timestamps: Timestamping::Unit, ..Config::new(TIMING).with_filters(&filters, &[]) };
    let mut can = bench.running(&config);
    bench.send(sender, &["100#", "200#"]);
    let stamps = [0; 2].map(|_| can.receive_fifo(RxFifo::Fifo0).unwrap().unwrap().timestamp);
    assert!(matches!(stamps, [RxTimestamp::Unit(Some(_)), RxTimestamp::Unit(None)]), "{stamps:?}");
    bench.finish();
}

/// 2.3.7: without a Timestamping Unit CCCR.UTSU cannot be set; neither can NISO in a core that has only the ISO format.
#[test]
fn section_2_3_7_what_was_not_synthesized_is_told() {
    use can_hal::m_can::{ConfigError, FdMode};
    let bench = Bench::with(|mut config| {
        config.iso_only = true;
        config
    });
    let mut can = bench.driver(&crate::bench::MEMORY);
    let config = Config { timestamps: Timestamping::Unit, ..Config::new(TIMING) };
    assert_eq!(can.configure(&config), Err(ConfigError::NotAvailable("UTSU")));
    let fd = FdMode::Fd { bit_rate_switch: true, non_iso: true };
    assert_eq!(can.configure(&Config { fd, ..Config::new(TIMING) }), Err(ConfigError::NotAvailable("NISO")));
}
