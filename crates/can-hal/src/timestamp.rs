//! Timestamps longer than the counter.

/// Extends the timestamps of a counter of `BITS` bits past its wrap.
///
/// It has to see the counter or a timestamp at least once in half a period; for that the interrupt at the counter's wrap
/// is enough. Timestamps may come up to half a period late and in any order: each is placed at the time nearest to the
/// latest one seen.
///
/// ```
/// # use can_hal::TimestampExtender;
/// let mut clock = TimestampExtender::<16>::new();
/// assert_eq!(clock.extend(0xFFF0), 0xFFF0);
/// assert_eq!(clock.extend(0x0010), 0x1_0010); // the counter has wrapped
/// assert_eq!(clock.extend(0xFFFE), 0xFFFE); // a message from before the wrap, read late
/// assert_eq!(clock.extend(0x0011), 0x1_0011);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimestampExtender<const BITS: u32> {
    latest: Option<u64>,
}

impl<const BITS: u32> TimestampExtender<BITS> {
    /// Has seen nothing yet: the first timestamp stands for itself.
    #[must_use]
    pub const fn new() -> Self {
        const { assert!(BITS >= 2 && BITS <= 32, "counters have 2 to 32 bits") };
        Self { latest: None }
    }

    /// The full time of a timestamp or of the counter itself. Bits above `BITS` are ignored.
    pub const fn extend(&mut self, stamp: u32) -> u64 {
        let period = 1_u64 << BITS;
        let stamp = stamp as u64 & (period - 1);
        let Some(latest) = self.latest else {
            self.latest = Some(stamp);
            return stamp;
        };
        let ahead = stamp.wrapping_sub(latest) & (period - 1);
        if ahead < period / 2 {
            let time = latest + ahead;
            self.latest = Some(time);
            time
        } else {
            // Before the latest one. Nothing lies before the counter's first period.
            (latest + ahead).saturating_sub(period)
        }
    }
}
