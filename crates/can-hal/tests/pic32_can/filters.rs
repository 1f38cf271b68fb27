//! Filters beyond the examples: several hits, DeviceNet data bits, changes in a message, what is refused.

use can_hal::{
    ExtendedId, Polls, Receive as _, StandardId, TimedOut,
    memory::Pic32CanFifo::{Receive, Transmit as Tx},
    pic32_can::{Config, ConfigError, Filter, Mask, TxFifo},
};
use can_sim::Time;

use crate::bench::{ANY, Bench, FRAME, TIMING, WAIT, everything, frame};

/// Figure 34-23: the lowest bit of a 29-bit identifier is ignored.
#[test]
fn figure_34_23() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(2, Receive { elements: 4 });
    let filters = [Filter::new(frame("01234566#").id(), 2).with_mask(2)];
    let mut masks = [Mask::EXACT; 4];
    masks[2] = Mask::extended(ExtendedId::new(0x1FFF_FFFE).unwrap());
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(masks, &filters));
    bench.send(peer, &["01234567#", "01234565#", "01234566#"]);
    let mut seen = Vec::new();
    while let Some(message) = can.fetch().unwrap() {
        seen.push(message.frame.to_string());
    }
    assert_eq!(seen, ["01234567#", "01234566#"]);
    bench.finish();
}

/// Figure 34-24: a message that several filters accept goes to the first FIFO with room.
#[test]
fn figure_34_24() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100);
    let memory =
        memory.fifo(1, Receive { elements: 1 }).fifo(2, Receive { elements: 1 }).fifo(4, Receive { elements: 1 });
    let filters = [Filter::new(frame("001#").id(), 1), Filter::any(1).with_mask(1), Filter::any(2).with_mask(1)];
    let filters = [filters[0], filters[1], filters[2], Filter::new(frame("002#").id(), 1), Filter::any(4).with_mask(1)];
    let masks = [Mask::EXACT, Mask::ANY, Mask::ANY, Mask::ANY];
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(masks, &filters));
    bench.send(peer, &["123#01", "123#02", "123#03"]);
    let stored = [1, 2, 4].map(|fifo| can.receive_fifo(fifo).unwrap().unwrap());
    assert_eq!(stored.map(|message| (message.frame.data_bytes()[0], message.filter)), [(1, 1), (2, 2), (3, 4)]);
    bench.finish();
}

/// Table 34-3: with a mask of any type the upper bits of an identifier are compared with either type.
#[test]
fn table_34_3_any_type() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = [Filter::new(frame("123#").id(), 0)];
    let mask = Mask::standard(StandardId::MAX).of_any_type();
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters([mask; 4], &filters));
    bench.send(peer, &["123#", "048C1234#", "124#"]);
    let mut seen = 0;
    while let Some(message) = can.fetch().unwrap() {
        assert!(["123#", "048C1234#"].contains(&message.frame.to_string().as_str()));
        seen += 1;
    }
    assert_eq!(seen, 2);
    bench.finish();
}

/// 34.8.7: the first 9 data bits too, by the order of Table 34-4 (devicenet_bit_order).
#[test]
fn section_34_8_7_devicenet() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = [Filter::new(frame("123#").id(), 0).with_data(0b1_0100_1011 << 9)];
    let mask = Mask::EXACT.with_data(0x3_FFFF);
    let mut config = Config::new(TIMING).with_filters([mask; 4], &filters);
    config.data_bits = 9;
    let mut can = bench.running(&memory, &config);
    bench.send(peer, &["123#A580", "123#A57F", "123#A480", "124#A580", "123#A5", "123#A5FF"]);
    let mut seen = Vec::new();
    while let Some(message) = can.fetch().unwrap() {
        seen.push(message.frame.to_string());
    }
    assert_eq!(seen, ["123#A580", "123#A5", "123#A5FF"]);
    bench.finish();
}

/// 34.8.1: a filter is not switched off while a message is received: the wait is bounded, and the change can be repeated.
#[test]
fn section_34_8_1_changing_a_filter_in_a_message() {
    let bench = Bench::new();
    let peer = bench.peer();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 4 });
    let filters = everything(0);
    let mut can = bench.running(&memory, &Config::new(TIMING).with_filters(ANY, &filters));
    bench.sim.peer_send(peer, frame("123#1122334455667788"));
    bench.sim.run_for(Time::from_us(40));
    let filter = Filter::new(frame("200#").id(), 0).with_mask(1);
    assert_eq!(can.set_filter(0, &filter, Polls(10)), Err(ConfigError::TimedOut));
    can.set_filter(0, &filter, WAIT).unwrap();
    bench.sim.run_for(FRAME);
    assert_eq!(can.fetch().unwrap().unwrap().frame, frame("123#1122334455667788"), "the message at hand is taken");
    bench.finish();
}

/// What does not exist is refused before anything is written.
#[test]
fn refused() {
    let bench = Bench::new();
    let memory = bench.memory(0x100).fifo(0, Receive { elements: 1 }).fifo(1, Tx { elements: 1 });
    let mut can = bench.driver(&memory);
    let id = frame("123#").id();
    let too_many = [Filter::any(0); 33];
    let (no_mask, no_fifo) = ([Filter { id, mask: 4, fifo: 0, data: 0 }], [Filter { id, mask: 0, fifo: 32, data: 0 }]);
    let receives = [TxFifo::new(0)];
    let config = Config::new(TIMING);
    let cases = [
        (config.with_filters(ANY, &too_many), ConfigError::NoSuchFilter(33)),
        (config.with_filters(ANY, &no_mask), ConfigError::NoSuchMask(4)),
        (config.with_filters(ANY, &no_fifo), ConfigError::NoSuchFifo(32)),
        (config.with_tx_fifos(&receives), ConfigError::NoSuchFifo(0)),
        (Config { data_bits: 19, ..config }, ConfigError::TooManyDataBits(19)),
    ];
    bench.sim.trace(true);
    for (config, error) in cases {
        assert_eq!(can.configure(&config), Err(error));
    }
    assert_eq!(can.set_filter(32, &Filter::any(0), WAIT), Err(ConfigError::NoSuchFilter(32)));
    assert_eq!(can.clear_filter(99, WAIT), Err(ConfigError::NoSuchFilter(99)));
    assert_eq!(bench.accesses(), []);
    assert_eq!(ConfigError::from(TimedOut), ConfigError::TimedOut);
}
