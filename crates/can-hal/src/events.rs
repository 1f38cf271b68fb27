//! What interrupt flags stand for, in terms all controllers share.

/// A set of causes of interrupts. Each controller decodes its own flags into it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Events(u16);

macro_rules! events {
    ($($(#[$doc:meta])* $name:ident = $bit:literal;)*) => {
        impl Events {
            $($(#[$doc])* pub const $name: Self = Self(1 << $bit);)*
        }

        impl core::fmt::Debug for Events {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let mut set = f.debug_set();
                $(if self.contains(Self::$name) { set.entry(&format_args!(stringify!($name))); })*
                set.finish()
            }
        }
    };
}

events! {
    /// A message was received.
    RECEIVED = 0;
    /// A message was sent.
    TRANSMITTED = 1;
    /// A transmission has ended without success: cancelled, or the only attempt has failed.
    CANCELLED = 2;
    /// Messages or events were lost because there was no room.
    LOST = 3;
    /// A record about a sent message was stored.
    TX_EVENT = 4;
    /// The warning limit was crossed, in either direction.
    WARNING = 5;
    /// The node became error passive or error active again.
    PASSIVE = 6;
    /// The node went bus off or came back.
    BUS_OFF = 7;
    /// A frame was disturbed.
    PROTOCOL_ERROR = 8;
    /// The timestamp counter has wrapped.
    TIMESTAMP_WRAP = 9;
    /// Activity on the bus while the controller slept.
    WAKE_UP = 10;
    /// Message memory was not accessible in time, or has failed.
    MEMORY = 11;
    /// The mode has changed.
    MODE = 12;
    /// Something that only this controller has.
    OTHER = 13;
}

impl Events {
    /// No event.
    pub const NONE: Self = Self(0);

    /// All of `other` are in the set.
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Some of `other` are in the set.
    #[must_use]
    pub const fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Nothing is in the set.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The set with `other` if `present`.
    #[must_use]
    pub const fn with(self, other: Self, present: bool) -> Self {
        if present { Self(self.0 | other.0) } else { self }
    }
}

impl core::ops::BitOr for Events {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Events {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Events({=u16:b})", self.0);
    }
}
