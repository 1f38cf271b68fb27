//! The two levels of the bus.

use core::{fmt, ops};

/// A bus level. Dominant wins over recessive when several nodes drive the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Level {
    /// Logical 0.
    Dominant = 0,
    /// Logical 1; the level of a bus that nobody drives.
    #[default]
    Recessive = 1,
}

impl Level {
    /// Recessive for `true`, the logical 1.
    #[must_use]
    pub const fn from_bit(bit: bool) -> Level {
        if bit {
            Level::Recessive
        } else {
            Level::Dominant
        }
    }

    /// The logical value: 1 for recessive.
    #[must_use]
    pub const fn bit(self) -> bool {
        matches!(self, Level::Recessive)
    }

    /// True for dominant.
    #[must_use]
    pub const fn is_dominant(self) -> bool {
        matches!(self, Level::Dominant)
    }

    /// True for recessive.
    #[must_use]
    pub const fn is_recessive(self) -> bool {
        matches!(self, Level::Recessive)
    }
}

impl ops::Not for Level {
    type Output = Level;

    fn not(self) -> Level {
        Level::from_bit(!self.bit())
    }
}

/// The wired AND.
impl ops::BitAnd for Level {
    type Output = Level;

    fn bitand(self, other: Level) -> Level {
        Level::from_bit(self.bit() && other.bit())
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.bit() { "recessive" } else { "dominant" })
    }
}
