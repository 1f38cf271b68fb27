//! Operating modes and low power (7.0, 13.0).

use can_hal::{
    Events, InterruptSet, Outcome, Polls, Receive, Sleep, TimedOut, Transmit, Wake,
    dspic33_ecan::{Filter, FilterTarget, InterruptCode, Interrupts, Mask, MaskSource},
    timing::{BitTiming, DsPic33EcanTiming, Segments},
};
use can_sim::{Time, dspic33_ecan::Power};
use can_wire::{BitFault, Disturbance, Fault, Field, Frames, Line, Position};

use crate::bench::{Bench, CONFIG, FRAME, MODE, PLAN, SEGMENTS, TIMING, frame, standard};

/// 7.0: a mode is reached when OPMODE shows it, after 11 recessive bits; on a busy bus the bound ends the wait, and the
/// module goes on in its mode.
#[test]
fn section_7_0_waiting_for_a_mode() {
    let bench = Bench::new();
    let can = bench.configured(&PLAN, &CONFIG);
    let refused = can.start_normal(Polls(20)).unwrap_err();
    assert_eq!(refused.error, TimedOut);
    let can = refused.can.start_normal(Polls(200)).unwrap();
    let (from, until) = (bench.sim.now(), bench.sim.now() + Time::from_ms(20));
    let stuck = Fault::Disturb { line: Line::Bus, how: Disturbance::Dominant, from, until };
    bench.sim.with_wire(|wire| wire.inject(stuck));
    bench.sim.run_for(FRAME);
    let refused = can.stop(Polls(500)).unwrap_err();
    bench.sim.run_for(Time::from_ms(25));
    let mut can = refused.can;
    assert!(can.registers().ctrl1().read().opmode() == Ok(dspic33_ecan_pac::enums::OperationMode::Normal));
    let other = bench.peer();
    bench.send(other, &["100#01"]);
    assert!(can.receive_buffer(8).is_some());
    bench.finish();
}

/// 7.1: what waits is aborted by configuration mode, what was received is gone.
#[test]
fn section_7_1_back_to_configuration_mode() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG.with_queue(2));
    bench.send(other, &["100#01"]);
    bench.sim.peer_send(other, frame("000#0000000000000000"));
    bench.sim.run_for(Time::from_us(20));
    can.send(&frame("200#")).unwrap();
    let can = can.into_configuration(MODE).unwrap();
    assert_eq!(can.registers().tr_con(0).read().bits() & 0x0808, 0);
    let mut can = can.start_normal(MODE).unwrap();
    bench.sim.run_for(FRAME * 2);
    assert_eq!((can.receive_message(), bench.seen(other)), (Ok(None), vec![]));
    assert!(can.send(&frame("201#")).is_ok());
    bench.sim.run_for(FRAME);
    assert_eq!(bench.seen(other), ["201#"]);
    bench.finish();
}

/// 7.3: the bit rate of a bus is found by listening: with a wrong one there are errors, with the right one messages.
#[test]
fn section_7_3_bit_rate_detection() {
    let bench = Bench::new();
    let (sender, listener) = (bench.peer(), bench.peer());
    let mut can = bench.configured(&PLAN, &CONFIG);
    let mut found = None;
    for prescaler in [4, 2, 1] {
        let nominal = Segments { prescaler, ..SEGMENTS };
        can.set_bit_timing(&DsPic33EcanTiming::of(&BitTiming { nominal, data: None, three_samples: true }).unwrap());
        let mut listening = can.start_listening(Polls(20_000)).unwrap();
        for number in 0..20 {
            bench.sim.peer_send(sender, frame(&format!("{number:03X}#5500AA")));
        }
        bench.sim.run_for(FRAME * 22);
        let events = listening.take_interrupts().events();
        if events.contains(Events::RECEIVED) {
            found = Some(prescaler);
            // 7.0: it joins without leaving the bus.
            let mut running = listening.join(MODE).unwrap();
            bench.send(sender, &["7AA#"]);
            assert!(running.receive_buffer(8).is_some());
            break;
        }
        assert!(events.contains(Events::PROTOCOL_ERROR), "{events:?}");
        can = listening.into_configuration(Polls(20_000)).unwrap();
    }
    assert_eq!(found, Some(1));
    assert_eq!(bench.sim.peer_received(listener).len(), 61, "nobody was disturbed");
    bench.finish();
}

/// 7.4: Listen All Messages mode: also what matches no filter, also what is broken.
#[test]
fn section_7_4_listen_all_messages() {
    let bench = Bench::new();
    let other = bench.peer();
    let filters = [Filter::new(standard(0x123), MaskSource::Mask0, FilterTarget::Buffer(9))];
    let config = CONFIG.with_filters([Mask::STANDARD; 3], &filters).with_queue(1);
    let mut can = bench.configured(&PLAN, &config).start_listen_all(MODE).unwrap();
    bench.send(other, &["456#01"]);
    assert_eq!(can.receive_message().unwrap().map(|message| message.frame), Some(frame("456#01")));
    let (node, position) = (bench.sim.node(bench.id), Position::new(Field::Crc, 2));
    let fault = Fault::Bit { node, fault: BitFault::InvertSeen, position, frames: Frames::next() };
    bench.sim.with_wire(|wire| wire.inject(fault));
    bench.sim.peer_send(other, frame("457#02"));
    bench.sim.run_for(Time::from_us(70));
    assert_eq!(can.receive_message().unwrap().map(|message| message.frame), Some(frame("457#02")));
    assert!(can.interrupts().events().contains(Events::PROTOCOL_ERROR));
    bench.sim.run_for(FRAME);
    assert_eq!(
        can.receive_message().unwrap().map(|message| message.frame),
        Some(frame("457#02")),
        "and once more, whole"
    );
    let ticket = can.send(&frame("100#")).unwrap();
    assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
    bench.finish();
}

/// 7.5: self-test without another node.
#[test]
fn section_7_5_loopback_self_test() {
    let bench = Bench::new();
    let mut can = bench.configured(&PLAN, &CONFIG.with_queue(1)).start_loopback(MODE).unwrap();
    for text in ["123#0102", "1ABCDEF0#", "7FF#R3"] {
        let ticket = can.send(&frame(text)).unwrap();
        assert_eq!(can.wait_for(ticket, Polls(10_000)), Ok(Outcome::Sent));
        assert_eq!(can.receive_buffer(8).map(|message| message.frame), Some(frame(text)));
    }
    bench.finish();
}

/// 13.1, 13.3: everything sent, Disable mode, the CPU to Sleep; bus activity wakes the device, the message is lost, and
/// the module is still disabled until software enables it.
#[test]
fn section_13_3_sleep_and_wake_up() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut config = CONFIG.with_queue(1);
    config.wake_up_filter = true;
    let mut can = bench.running(&PLAN, &config);
    can.enable_interrupts(Interrupts::WAKIF);
    let ticket = can.send(&frame("100#")).unwrap();
    let asleep = can.sleep(Polls(10_000)).unwrap();
    assert_eq!(bench.seen(other), ["100#"]);
    // PWRSAV #1.
    bench.sim.act(bench.id, |model, cx| model.sleep(cx));
    bench.sim.run_for(FRAME);
    assert_eq!(bench.sim.inspect(bench.id, |model| model.power()), Power::Sleep);
    bench.sim.peer_send(other, frame("200#01"));
    bench.sim.run_until(FRAME, |sim| sim.line(bench.id, 0)).unwrap();
    assert_eq!(asleep.interrupt_code(), Ok(InterruptCode::WakeUp));
    let mut can = asleep.wake(MODE).unwrap();
    assert!(can.take_interrupts().events().contains(Events::WAKE_UP));
    assert_eq!(can.outcome(ticket), Outcome::Sent);
    bench.sim.run_for(FRAME * 2);
    let messages = can.receive_buffer(8).map(|message| message.frame);
    assert_eq!(messages, Some(frame("200#01")), "sent again for want of an acknowledge");
    bench.finish();
}

/// 13.2: the CPU in Idle: the module goes on, or with CSIDL it is put to sleep before.
#[test]
fn section_13_2_idle() {
    let bench = Bench::new();
    let other = bench.peer();
    let mut can = bench.running(&PLAN, &CONFIG);
    bench.sim.act(bench.id, |model, cx| model.idle(cx));
    bench.send(other, &["100#01"]);
    bench.sim.act(bench.id, |model, cx| model.run(cx));
    assert!(can.receive_buffer(8).is_some());
    let mut config = CONFIG;
    config.stop_in_idle = true;
    let mut stopped = can.stop(MODE).unwrap();
    stopped.configure(&config).unwrap();
    let asleep = stopped.start_normal(MODE).unwrap().sleep(MODE).unwrap();
    bench.sim.act(bench.id, |model, cx| model.idle(cx));
    bench.sim.peer_send(other, frame("100#02"));
    bench.sim.run_for(FRAME);
    bench.sim.act(bench.id, |model, cx| model.run(cx));
    let mut can = asleep.wake(MODE).unwrap();
    bench.sim.run_for(FRAME * 2);
    assert!(can.receive_buffer(8).is_some());
    bench.finish();
}

/// The driver takes a module over in any mode, also with the filter window left open.
#[test]
fn the_driver_takes_over() {
    let bench = Bench::new();
    let other = bench.peer();
    let can = bench.running(&PLAN, &CONFIG);
    let regs = can.registers().ctrl1();
    regs.modify(|value| value.with_win(dspic33_ecan_pac::enums::Ctrl1Win::Filter));
    let mut can = bench.running(&PLAN, &CONFIG);
    bench.send(other, &["100#01"]);
    assert!(can.receive_buffer(8).is_some());
    assert_eq!(can.registers().cfg1().read(), TIMING.cfg1);
    bench.finish();
}
