//! Messages about changes of mode, to whichever logger is compiled in.

/// A line for the `log` crate; nothing without the feature.
macro_rules! report {
    ($($arg:tt)*) => {{
        #[cfg(feature = "log")]
        log::debug!($($arg)*);
        #[cfg(not(feature = "log"))]
        if false {
            let _ = core::format_args!($($arg)*);
        }
    }};
}
