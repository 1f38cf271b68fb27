//! Receiving (9.2, 9.3, 9.4), time stamps (14.0).

use can_hal::{
    Overflow, Receive,
    dspic33_ecan::{Filter, FilterTarget, Interrupts, Mask, MaskSource},
};
use can_sim::Time;

use crate::bench::{Bench, CONFIG, Driver, FIFO_5_TO_11, FRAME, PLAN, TO_FIFO, frame, standard};

const TO_THE_FIFO: can_hal::dspic33_ecan::Config<'static> = CONFIG.with_filters([Mask::ANY; 3], TO_FIFO);

/// Fetches everything there is: first data bytes, and how often messages were lost.
fn drain<S: can_hal::mode::OnBus>(can: &mut Driver<'_, S>) -> (Vec<u8>, usize) {
    let (mut bytes, mut lost) = (Vec::new(), 0);
    loop {
        match can.fetch() {
            Ok(Some(message)) => bytes.push(message.frame.data_bytes()[0]),
            Ok(None) => return (bytes, lost),
            Err(overflow) => {
                assert_eq!(overflow, Overflow { fifo: 0 });
                lost += 1;
            }
        }
    }
}

/// Lets a peer send messages with these first data bytes.
fn send(bench: &Bench, other: can_sim::PeerId, bytes: core::ops::Range<u8>) {
    for byte in bytes.clone() {
        bench.sim.peer_send(other, frame(&format!("100#{byte:02X}")));
    }
    bench.sim.run_for(FRAME * bytes.len() as u64);
}

/// 9.2.5: buffers, with the filter of each message; a message for a full one is lost, which is told.
#[test]
fn section_9_2_5_buffers() {
    let bench = Bench::new();
    let other = bench.peer();
    let filters = [
        Filter::new(standard(0x100), MaskSource::Mask0, FilterTarget::Buffer(9)),
        Filter::new(standard(0x200), MaskSource::Mask0, FilterTarget::Buffer(3)),
    ];
    let mut can = bench.running(&PLAN, &CONFIG.with_filters([Mask::STANDARD; 3], &filters));
    bench.send(other, &["100#01", "200#02", "300#03"]);
    assert_eq!(can.full_buffers(), 1 << 9 | 1 << 3);
    let message = can.receive_message().unwrap().unwrap();
    assert_eq!((message.frame, message.filter, message.buffer), (frame("200#02"), 1, 3));
    bench.send(other, &["100#04", "100#05"]);
    assert_eq!(can.receive_message(), Err(Overflow { fifo: 10 }), "buffer 9");
    assert_eq!(
        can.receive_message().unwrap().map(|message| message.frame),
        Some(frame("100#01")),
        "the old one is kept"
    );
    assert_eq!(can.receive_message(), Ok(None));
    assert!(!can.interrupt_flags().contains(Interrupts::RBOVIF));
    bench.finish();
}

/// 9.2.1, note: several filters with the same identifier make a message wait in the next empty buffer.
#[test]
fn section_9_2_1_several_buffers_for_a_message() {
    let bench = Bench::new();
    let other = bench.peer();
    let to = |buffer| Filter::new(standard(0x100), MaskSource::Mask0, FilterTarget::Buffer(buffer));
    let filters = [to(10), to(11), to(12)];
    let mut can = bench.running(&PLAN, &CONFIG.with_filters([Mask::STANDARD; 3], &filters));
    send(&bench, other, 0..3);
    assert_eq!([10, 11, 12].map(|buffer| can.receive_buffer(buffer).unwrap().frame.data_bytes()[0]), [0, 1, 2]);
    assert_eq!(can.receive_buffer(10), None);
    bench.finish();
}

/// 9.4, Figure 9-6: the seven cases, with the driver unloading the FIFO. Case 1 of the text has FNRB at buffer 6; the
/// figure has 5 (`fifo_case_1`).
#[test]
fn figure_9_6_example_of_fifo_operation() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&FIFO_5_TO_11, &TO_THE_FIFO);
    assert_eq!(can.registers().fctrl().read().bits(), 0x6005);
    let pointers = |can: &Driver<'_, can_hal::mode::Running>| {
        let (status, fifo) = (can.fifo_status(), can.registers().fifo().read().bits());
        (fifo, status.write, status.read, status.level)
    };
    assert_eq!(pointers(&can), (0x0505, 5, 5, 0), "case 1");
    send(&bench, other, 0..1);
    assert_eq!(pointers(&can), (0x0605, 6, 5, 1), "case 2");
    send(&bench, other, 1..6);
    assert_eq!(pointers(&can), (0x0B05, 11, 5, 6), "case 3");
    assert!(can.take_interrupts().contains(Interrupts::FIFOIF), "about to fill");
    assert_eq!(can.receive_message().unwrap().map(|message| message.buffer), Some(5));
    assert_eq!(pointers(&can), (0x0B06, 11, 6, 5), "case 4");
    send(&bench, other, 6..7);
    assert_eq!(pointers(&can), (0x0506, 5, 6, 6), "case 5");
    assert!(can.take_interrupts().contains(Interrupts::FIFOIF));
    send(&bench, other, 7..8);
    assert_eq!(pointers(&can), (0x0606, 6, 6, 7), "case 6");
    assert!(!can.take_interrupts().contains(Interrupts::FIFOIF), "full: no interrupt");
    send(&bench, other, 8..9);
    assert_eq!(pointers(&can), (0x0706, 7, 6, 7), "case 7");
    assert!(can.take_interrupts().contains(Interrupts::RBOVIF));
    assert_eq!(drain(&mut can), ((1..8).collect(), 1));
    bench.finish();
}

/// 9.3.1: after messages were lost FBP has gone on without FNRB; the driver still finds everything, in order.
#[test]
fn section_9_3_1_unloading_after_a_loss() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&FIFO_5_TO_11, &TO_THE_FIFO);
    let mut next = 0;
    for lost in 0..7 {
        let kept = next..next + 7;
        send(&bench, other, next..next + 7 + lost);
        assert_eq!(drain(&mut can), (kept.collect(), usize::from(lost > 0)), "{lost} lost");
        next += 7 + lost;
        // A few at a time, across the end of the FIFO.
        for count in 1..4 {
            send(&bench, other, next..next + count);
            assert_eq!(drain(&mut can), ((next..next + count).collect(), 0));
            next += count;
        }
    }
    bench.finish();
}

/// 9.3.1: a message that arrives before any access of the driver is neither lost nor passed over.
#[test]
fn section_9_3_1_messages_arrive_while_the_fifo_is_unloaded() {
    for skip in 0..60 {
        let bench = Bench::new();
        let other = bench.peer();
        let mut can = bench.running(&FIFO_5_TO_11, &TO_THE_FIFO);
        send(&bench, other, 0..9);
        assert_eq!(drain(&mut can).0, [0, 1, 2, 3, 4, 5, 6]);
        send(&bench, other, 9..11);
        bench.sim.interrupt_host(skip, move |sim| {
            for byte in 11..14 {
                sim.peer_send(other, frame(&format!("100#{byte:02X}")));
            }
            sim.run_for(FRAME * 3);
        });
        let (mut bytes, _) = drain(&mut can);
        // Accesses that cost time only, in case the driver has made fewer than `skip`.
        for _ in 0..skip {
            let _ = can.registers().ctrl1().read();
        }
        bytes.extend(drain(&mut can).0);
        assert_eq!(bytes, [9, 10, 11, 12, 13], "before access {skip}");
        bench.finish();
    }
}

/// 9.2.4: a FIFO that reaches into buffers 16 to 31.
#[test]
fn section_9_2_4_buffers_16_to_31() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &TO_THE_FIFO);
    for turn in 0..4 {
        send(&bench, other, turn * 10..turn * 10 + 10);
        assert_eq!(drain(&mut can), ((turn * 10..turn * 10 + 10).collect(), 0));
    }
    assert_eq!(can.registers().rxful(2).read().bits(), 0);
    bench.finish();
}

/// 9.5: DNCNT 3 compares bits 7 to 5 of byte 0 with EID[17:15]; the text calls them EID[0:2] (`devicenet_notation`).
#[test]
fn section_9_5_1_devicenet_filter() {
    let bench = Bench::new();
    let other = bench.peer();
    let filter = Filter::new(standard(0x100), MaskSource::Mask0, FilterTarget::Buffer(9)).with_data([0xA0, 0, 0]);
    let filters = [filter];
    let mut config = CONFIG.with_filters([Mask::STANDARD.with_data_bits(3); 3], &filters);
    config.data_bits = 3;
    let mut can = bench.running(&PLAN, &config);
    for (text, accepted) in
        [("100#A0", true), ("100#BF55", true), ("100#80", false), ("100#C0", false), ("101#A0", false)]
    {
        bench.send(other, &[text]);
        assert_eq!(can.receive_buffer(9).is_some(), accepted, "{text}");
    }
    // 9.5.2, case 4: no data, the identifier decides.
    bench.send(other, &["100#"]);
    assert!(can.receive_buffer(9).is_some());
    bench.finish();
}

/// Figure 9-7: 18 data bits against EID[17:0].
#[test]
fn figure_9_7_eighteen_data_bits() {
    let bench = Bench::new();
    let other = bench.peer();
    let filter = Filter::new(standard(0x100), MaskSource::Mask0, FilterTarget::Buffer(9)).with_data([0xA5, 0x3C, 0x80]);
    assert_eq!(filter.data, 0x294F2);
    let filters = [filter];
    let mut config = CONFIG.with_filters([Mask::STANDARD.with_data_bits(18); 3], &filters);
    config.data_bits = 18;
    let mut can = bench.running(&PLAN, &config);
    for (text, accepted) in [("100#A53C80", true), ("100#A53CBFFF", true), ("100#A53CC0", false), ("100#A53C", true)] {
        bench.send(other, &[text]);
        assert_eq!(can.receive_buffer(9).is_some(), accepted, "{text}");
    }
    bench.finish();
}

/// 14.0: each accepted message makes a pulse of one bit time for input capture IC2; there is no counter in the module.
#[test]
fn section_14_0_time_stamping() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut config = CONFIG;
    config.capture = true;
    let mut can = bench.running(&PLAN, &config);
    bench.send(other, &["100#01"]);
    let pulse = bench.sim.inspect(bench.id, |model| model.captures());
    assert_eq!((pulse.count, pulse.end.since(pulse.start)), (1, Time::from_us(1)));
    assert_eq!(can.fetch().unwrap().unwrap().timestamp, None);
    assert_eq!(can.timestamp(), None);
    bench.finish();
}
