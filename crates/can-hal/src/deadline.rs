//! Bounds of waits.

/// When a wait ends without its event. Asked once after every poll.
///
/// [`Polls`] counts, [`Until`] asks a clock of the caller. A `&mut` to a deadline is one too, so that several waits can
/// share it.
pub trait Deadline {
    /// True if the wait is over.
    fn expired(&mut self) -> bool;
}

impl<D: Deadline + ?Sized> Deadline for &mut D {
    fn expired(&mut self) -> bool {
        (**self).expired()
    }
}

/// A number of polls: of accesses of the register that is waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polls(pub u32);

impl Deadline for Polls {
    fn expired(&mut self) -> bool {
        let left = self.0.checked_sub(1);
        self.0 = left.unwrap_or(0);
        left.is_none()
    }
}

/// A question to a clock: true when the time is over.
///
/// ```
/// # use can_hal::{Deadline, Until};
/// # let now = || 7_u32;
/// let mut deadline = Until(|| now() >= 100);
/// assert!(!deadline.expired());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Until<F>(pub F);

impl<F: FnMut() -> bool> Deadline for Until<F> {
    fn expired(&mut self) -> bool {
        (self.0)()
    }
}

/// What was waited for has not happened within the bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TimedOut;

impl core::fmt::Display for TimedOut {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("what was waited for has not happened within the bound")
    }
}

impl core::error::Error for TimedOut {}

/// Polls until `done`, at least once.
#[inline]
pub(crate) fn wait(deadline: &mut impl Deadline, mut done: impl FnMut() -> bool) -> Result<(), TimedOut> {
    loop {
        if done() {
            return Ok(());
        }
        if deadline.expired() {
            return Err(TimedOut);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wait_polls_once_more_than_the_bound_and_then_ends() {
        let mut polled = 0;
        let mut never = || {
            polled += 1;
            false
        };
        assert_eq!(wait(&mut Polls(3), &mut never), Err(TimedOut));
        assert_eq!(wait(&mut Polls(0), &mut never), Err(TimedOut));
        assert_eq!(polled, 5);
        assert_eq!(wait(&mut Polls(0), || true), Ok(()));
    }

    #[test]
    fn waits_can_share_a_deadline() {
        let mut shared = Polls(2);
        assert_eq!(wait(&mut &mut shared, || false), Err(TimedOut));
        assert_eq!(shared, Polls(0));
    }
}
