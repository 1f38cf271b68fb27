//! One suite for all controllers: what [`can_hal`]'s common traits promise, on each controller's model.
//!
//! A controller takes part with a [`bench::Bench`] and a line of `conformance!`. What it cannot do it states there, and
//! the suite asserts that as well.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bench;
mod dspic33_canfd;
mod dspic33_ecan;
mod errors;
mod filters;
mod interrupts;
mod m_can;
mod modes;
mod pic32_can;
mod receive;
mod timestamps;
mod transmit;

macro_rules! conformance {
    ($($controller:ident = $bench:ty;)*) => {$(
        mod $controller {
            conformance!(@tests $bench:
                transmit: every_kind_comes_back_in_loop_back
                    every_kind_is_exchanged
                    fd_frames_are_refused_where_they_cannot_be_sent
                    the_order_is_that_of_the_calls_or_of_the_identifiers
                    a_full_queue_says_so
                    a_frame_that_waits_can_be_cancelled
                    a_cancellation_can_come_too_late
                    one_shot
                    a_remote_request_is_answered_or_received
                    the_embedded_can_traits;
                receive: capabilities_are_as_stated
                    a_full_fifo_loses_the_newest_and_says_so
                    a_fifo_can_overwrite_the_oldest
                    every_length;
                filters: only_what_is_asked_for_comes_in
                    without_filters_everything_comes_in;
                errors: warning_passive_bus_off_and_back
                    restart_after_a_pause
                    a_missing_acknowledge_is_told;
                modes: listen_only_sends_nothing
                    sleep_waits_and_wake_resumes
                    what_does_not_happen_in_time_is_refused
                    stop_and_start_again;
                timestamps: they_grow_across_the_wrap;
                interrupts: a_flag_that_rises_between_read_and_clear_stays
                    no_message_is_forgotten_wherever_it_arrives
                    events_say_what_happened;
            );
        }
    )*};
    (@tests $bench:ty: $($topic:ident: $($test:ident)*;)*) => {$($(
        #[test]
        fn $test() {
            crate::$topic::$test::<$bench>();
        }
    )*)*};
}

mod on {
    conformance! {
        m_can = crate::m_can::MCan;
        dspic33_canfd = crate::dspic33_canfd::CanFd;
        dspic33_ecan = crate::dspic33_ecan::Ecan;
        pic32_can = crate::pic32_can::Pic32;
    }
}
