//! Policies for a node that is bus off.

/// Says when a node that is bus off is restarted: at once, or after a time off the bus.
///
/// It only decides; the caller carries it out with [`Transmit::restart`](crate::Transmit::restart). Times are in any unit
/// that the caller's clock has.
///
/// ```
/// # use can_hal::RestartAfter;
/// let mut policy = RestartAfter::new(100);
/// assert!(!policy.due(true, 1_000)); // bus off noticed
/// assert!(!policy.due(true, 1_099));
/// assert!(policy.due(true, 1_100)); // restart now
/// assert!(!policy.due(true, 1_150)); // recovery is under way
/// assert!(!policy.due(false, 1_200)); // back on the bus: the next time counts anew
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RestartAfter {
    pause: u64,
    state: State,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum State {
    OnBus,
    Waiting { since: u64 },
    Recovering,
}

impl RestartAfter {
    /// Restarts after `pause` off the bus.
    #[must_use]
    pub const fn new(pause: u64) -> Self {
        Self { pause, state: State::OnBus }
    }

    /// Restarts at once.
    #[must_use]
    pub const fn immediately() -> Self {
        Self::new(0)
    }

    /// True once for every time the node goes bus off: when it is to be restarted.
    pub const fn due(&mut self, bus_off: bool, now: u64) -> bool {
        if !bus_off {
            self.state = State::OnBus;
            return false;
        }
        let since = match self.state {
            State::OnBus => now,
            State::Waiting { since } => since,
            State::Recovering => return false,
        };
        let due = now.wrapping_sub(since) >= self.pause;
        self.state = if due { State::Recovering } else { State::Waiting { since } };
        due
    }
}
