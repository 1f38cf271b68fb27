//! The story is the same every time, and what it says of itself is what happened on the bus.
#![allow(clippy::unwrap_used)]

use std::sync::LazyLock;

use can_demo::{
    Options, Story, files, html,
    play::{LOGGER, MOTOR, PANEL, PAUSE, VICTIM},
    run,
    story::{Deed, Fate},
    terminal,
};
use can_hal::ErrorState as Seen;
use can_wire::{ErrorKind, ErrorState, EventKind, Time};

static STORY: LazyLock<Story> = LazyLock::new(|| run(&Options::default()).unwrap());

fn sent(story: &Story) -> Vec<(usize, String)> {
    let sent = story.attempts().into_iter().filter_map(|attempt| match attempt.fate {
        Fate::Sent(frame) => Some((attempt.node, frame.to_string())),
        _ => None,
    });
    sent.collect()
}

#[test]
fn the_story_is_the_same_every_time() {
    let again = run(&Options::default()).unwrap();
    assert_eq!(files::vcd(&STORY).unwrap(), files::vcd(&again).unwrap());
    assert_eq!(files::pcapng(&STORY).unwrap(), files::pcapng(&again).unwrap());
    assert_eq!(html::report(&STORY).unwrap(), html::report(&again).unwrap());
}

#[test]
fn two_different_controllers_take_part_and_make_no_mistake() {
    assert_ne!(STORY.nodes[MOTOR].title, STORY.nodes[PANEL].title);
    assert_eq!(STORY.diagnostics, [String::new(); 0]);
}

#[test]
fn frames_arrive_in_this_order() {
    let speed = |count| (MOTOR, format!("120#0BB83C00FA01{count:02X}"));
    let button = || (PANEL, String::from("0F0#01"));
    let display = || (PANEL, String::from("3A0##148656C6C6F2C206D6F746F7221000000"));
    let mut expected = vec![speed(1), display(), button(), speed(2), speed(3), button()];
    let meanwhile = sent(&STORY).len() - expected.len() - 3;
    expected.extend((0..meanwhile).map(|_| button()));
    expected.extend([speed(4), speed(5), display()]);
    assert_eq!(sent(&STORY), expected);
    assert!(meanwhile >= 3, "the panel goes on while the motor is bus off");
}

#[test]
fn arbitration_is_lost_where_the_identifiers_first_differ() {
    let attempts = STORY.attempts();
    let lost: Vec<_> = attempts.iter().filter(|attempt| matches!(attempt.fate, Fate::Lost(_))).collect();
    let [lost] = lost[..] else { panic!("{lost:?}") };
    let winner =
        attempts.iter().find(|other| other.node != lost.node && other.from < lost.until && other.until > lost.until);
    let winner = winner.unwrap();
    let Fate::Lost(position) = lost.fate else { unreachable!() };
    let differing = (lost.id ^ winner.id).leading_zeros() - (32 - 11);
    assert_eq!(u32::from(position.bit), differing);
    assert_eq!((lost.id, winner.id), (0x120, 0x0F0));
}

#[test]
fn every_failure_is_the_injected_one_and_costs_eight() {
    let mut tec = 0;
    let mut failures = 0;
    for attempt in STORY.attempts().iter().filter(|attempt| attempt.node == MOTOR) {
        let after = STORY.count_at(MOTOR, attempt.until).tec;
        match attempt.fate {
            Fate::Failed(error) => {
                failures += 1;
                assert_eq!((error.kind, error.position), (ErrorKind::Bit1, VICTIM));
                // The counter stays at 255 when the node goes bus off.
                assert_eq!(after, (tec + 8).min(255));
            }
            Fate::Sent(_) => assert_eq!(after, tec.saturating_sub(1)),
            Fate::Lost(_) => assert_eq!(after, tec),
        }
        tec = if STORY.states(MOTOR).iter().any(|(time, state)| *state == ErrorState::BusOff && *time == attempt.until)
        {
            0
        } else {
            after
        };
    }
    assert_eq!(failures, 33);
    assert_eq!(STORY.faults.iter().map(|fault| STORY.hits(fault).len()).sum::<usize>(), failures);
}

#[test]
fn the_motor_goes_passive_and_bus_off_and_comes_back_while_the_others_stay_active() {
    let states: Vec<ErrorState> = STORY.states(MOTOR).iter().map(|(_, state)| *state).collect();
    assert_eq!(states, [ErrorState::Active, ErrorState::Passive, ErrorState::BusOff, ErrorState::Active]);
    for node in [PANEL, LOGGER] {
        assert_eq!(STORY.states(node).len(), 1, "{}", STORY.nodes[node].name);
    }
    let [(off, back)] = STORY.bus_off(MOTOR)[..] else { panic!("bus off once") };
    // The driver waits as long as its policy says, and the recovery takes 129 sequences of 11 bits at least.
    let restart = STORY.steps.iter().find(|step| matches!(step.deed, Deed::Restarted)).unwrap().time;
    assert!(restart.since(off) >= PAUSE && restart.since(off) < PAUSE + Time::from_us(250));
    assert!(back.since(restart) >= Time::from_us(129 * 11 * 2 - 2));
    let silent = STORY.events(MOTOR).filter(|event| event.time > off && event.time < back);
    assert!(
        silent
            .into_iter()
            .all(|event| !matches!(event.kind, EventKind::Transmitted { .. } | EventKind::Received { .. }))
    );
    assert_eq!(STORY.count_at(MOTOR, STORY.end).tec, 0);
}

/// What a driver reads in the registers of its controller is what the node on the bus counts.
#[test]
fn the_drivers_read_the_counters_of_the_bus() {
    let mut looked = 0;
    for step in &STORY.steps {
        let (Deed::Served { status: Some(status), .. } | Deed::Looked(status)) = &step.deed else { continue };
        looked += 1;
        let last = step.records.last().unwrap().time;
        let count = STORY.count_at(step.node, last);
        if status.error_state != Seen::BusOff {
            assert_eq!((status.counters.transmit, status.counters.receive), (count.tec, count.rec), "{step:?}");
        }
        let states = STORY.states(step.node);
        let state = states[states.partition_point(|(time, _)| *time <= last) - 1].1;
        let seen = match status.error_state {
            Seen::Active => ErrorState::Active,
            Seen::Passive => ErrorState::Passive,
            Seen::BusOff => ErrorState::BusOff,
        };
        assert_eq!(seen, state, "{step:?}");
    }
    assert!(looked > 60, "{looked}");
}

#[test]
fn the_drivers_send_and_receive_what_is_on_the_bus() {
    for (node, other) in [(MOTOR, PANEL), (PANEL, MOTOR)] {
        let (mut received, mut done) = (Vec::new(), Vec::new());
        for step in STORY.steps.iter().filter(|step| step.node == node) {
            if let Deed::Served { received: new, sent, .. } = &step.deed {
                received.extend(new.iter().map(ToString::to_string));
                done.extend(sent.iter().map(|frame| (node, frame.to_string())));
            }
        }
        let all = sent(&STORY);
        let own: Vec<_> = all.iter().filter(|(sender, _)| *sender == node).cloned().collect();
        assert_eq!(done, own);
        let heard = STORY.events(node).filter_map(|event| match event.kind {
            EventKind::Received { frame, .. } => Some(frame.to_string()),
            _ => None,
        });
        assert_eq!(received, heard.collect::<Vec<_>>());
        let of_other = all.iter().filter(|(sender, _)| *sender == other).count();
        assert!(received.len() <= of_other && received.len() >= 4);
    }
}

#[test]
fn the_timeline() {
    insta::assert_snapshot!(anstream::adapter::strip_str(&terminal::timeline(&STORY)).to_string());
}
