//! The examples do what they say.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(dead_code, clippy::duplicate_mod, reason = "each example has a `main` and its board")]

use can_hal::{ErrorState, Outcome};

macro_rules! examples {
    ($($name:ident = $path:literal;)*) => {$(
        #[path = $path]
        mod $name;
    )*};
}

examples! {
    bit_rate_detection = "../examples/bit_rate_detection.rs";
    bus_off_recovery = "../examples/bus_off_recovery.rs";
    echo = "../examples/echo.rs";
    fd_throughput = "../examples/fd_throughput.rs";
    filters = "../examples/filters.rs";
    gateway = "../examples/gateway.rs";
    priority_and_cancel = "../examples/priority_and_cancel.rs";
    sleep_wake = "../examples/sleep_wake.rs";
    timestamps = "../examples/timestamps.rs";
}

#[test]
fn echo_on_every_controller() {
    for (controller, frames) in echo::run().unwrap() {
        let texts: Vec<String> = frames.iter().map(ToString::to_string).collect();
        assert_eq!(texts, ["101#00", "111#01", "121#02"], "{controller}");
    }
}

#[test]
fn fd_is_several_times_faster() {
    let (classic, fd) = fd_throughput::run().unwrap();
    // A classic frame of 8 bytes takes 111 bit times without stuff bits, so at most 72 kB/s at 1 Mbit/s; an FD frame of
    // 64 bytes takes about 28 bit times at 1 Mbit/s and 560 at 5 Mbit/s.
    assert!((50e3..72e3).contains(&classic), "{classic}");
    assert!((300e3..470e3).contains(&fd), "{fd}");
}

#[test]
fn filters_sort_the_traffic() {
    let found = filters::run().unwrap();
    assert_eq!(found.fifo_0, ["7E8#01", "7EF#02", "010#FF"]);
    assert_eq!(found.fifo_1, ["30F#04", "18FEEE00#06", "0CFEEE21#08"]);
    assert_eq!(found.latest.as_deref(), Some("201#AA"));
    assert_eq!(found.alarm_filter, 2);
}

#[test]
fn both_policies_bring_the_node_back() {
    use ErrorState::{Active, BusOff, Passive};
    let [at_once, after_pause] = bus_off_recovery::run().unwrap();
    // At once means again and again while the line is broken; then 129 times 11 bit times are 1.4 ms.
    assert!((2..5).contains(&at_once.restarts), "{at_once:?}");
    assert!(at_once.microseconds < 7_000, "{at_once:?}");
    assert!(at_once.states.starts_with(&[Active, Passive, BusOff]), "{at_once:?}");
    assert_eq!(after_pause.restarts, 1);
    assert_eq!(after_pause.states, [Active, Passive, BusOff, Active]);
    assert!((21_400..23_000).contains(&after_pause.microseconds), "{after_pause:?}");
}

#[test]
fn timestamps_follow_the_clock() {
    let times = timestamps::run().unwrap();
    assert_eq!(times.len(), 4);
    for (number, time) in times.iter().enumerate() {
        assert!(time.abs_diff(100_000 * number as u64) <= 10, "{times:?}");
    }
}

#[test]
fn the_urgent_frame_overtakes_and_the_stale_one_is_replaced() {
    let (seen, cancelled, too_late) = priority_and_cancel::run().unwrap();
    assert_eq!((cancelled, too_late), (Outcome::Cancelled, Outcome::SentAnyway));
    assert_eq!(seen, ["010#73746F70", "020#0101010101010101", "300#6E6577", "400#00", "401#01", "402#02"]);
}

#[test]
fn sleep_and_wake_on_every_controller() {
    for (controller, received) in sleep_wake::run().unwrap() {
        assert_eq!(received, ["101#68656C6C6F"], "{controller}");
    }
}

#[test]
fn every_rate_is_found_and_no_other() {
    for (actual, found) in bit_rate_detection::run().unwrap() {
        assert_eq!(found, (actual != 800_000).then_some(actual));
    }
}

#[test]
fn the_gateway_moves_everything() {
    let moved = gateway::run().unwrap();
    assert_eq!(moved.sent, moved.arrived);
    assert_eq!(moved.back, ["300#0102030405060708"]);
}
