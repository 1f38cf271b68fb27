//! Access semantics: the one table that Rust, C, SVD, HTML and the simulator read.

use crate::syntax::{AccessCode, OnRead, ReadEffect};

use super::{ConditionId, FieldRef};

/// What a write does to a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WriteEffect {
    /// Nothing: the field is read only.
    Ignored,
    /// The written value is stored.
    Stores,
    /// Bits written 1 are cleared.
    OneClears,
    /// Bits written 0 are cleared.
    ZeroClears,
    /// Bits written 1 are set; hardware clears them.
    OneSets,
    /// 1 requests, 0 withdraws the request; hardware clears it.
    Requests,
    /// The field is cleared or preset, whatever is written.
    Resets,
}

/// What a read-modify-write has to put into a field so that nothing happens to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Neutral {
    /// What was read.
    AsRead,
    /// All bits 0.
    Zero,
    /// All bits 1.
    Ones,
    /// There is no such value.
    None,
}

impl AccessCode {
    /// Software can read the field.
    #[must_use]
    pub const fn readable(self) -> bool {
        !matches!(self, Self::Wo)
    }

    /// Software can write the field.
    #[must_use]
    pub const fn writable(self) -> bool {
        !matches!(self, Self::Ro)
    }

    /// What a write does.
    #[must_use]
    pub const fn write_effect(self) -> WriteEffect {
        match self {
            Self::Ro => WriteEffect::Ignored,
            Self::Rw | Self::Wo | Self::Rwh => WriteEffect::Stores,
            Self::W1c => WriteEffect::OneClears,
            Self::W0c => WriteEffect::ZeroClears,
            Self::W1s => WriteEffect::OneSets,
            Self::Rwhc => WriteEffect::Requests,
            Self::Wclr => WriteEffect::Resets,
        }
    }

    /// The neutral write value.
    #[must_use]
    pub const fn neutral(self) -> Neutral {
        match self {
            Self::Rw => Neutral::AsRead,
            Self::Ro | Self::Wo | Self::W1c | Self::W1s => Neutral::Zero,
            Self::W0c => Neutral::Ones,
            Self::Rwhc | Self::Rwh | Self::Wclr => Neutral::None,
        }
    }

    /// Hardware changes the field on its own.
    #[must_use]
    pub const fn hardware_changes(self) -> bool {
        !matches!(self, Self::Rw | Self::Wo)
    }

    /// The code as it is written.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Rw => "rw",
            Self::Ro => "ro",
            Self::Wo => "wo",
            Self::W1c => "w1c",
            Self::W0c => "w0c",
            Self::W1s => "w1s",
            Self::Rwhc => "rwhc",
            Self::Rwh => "rwh",
            Self::Wclr => "wclr",
        }
    }

    /// All codes, in the order of the documentation.
    pub const ALL: [Self; 9] =
        [Self::Rw, Self::Ro, Self::Wo, Self::W1c, Self::W0c, Self::W1s, Self::Rwhc, Self::Rwh, Self::Wclr];

    /// What the code means, in one sentence.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Rw => "Read and write; a write stores.",
            Self::Ro => "Read only; a write does nothing.",
            Self::Wo => "Write only; what a read returns means nothing.",
            Self::W1c => "A flag: writing 1 clears it, writing 0 does nothing.",
            Self::W0c => "A flag: writing 0 clears it, writing 1 does nothing.",
            Self::W1s => "A request: writing 1 makes it, writing 0 does nothing, hardware clears it.",
            Self::Rwhc => "A request that can be withdrawn: 1 requests, 0 aborts, hardware clears it.",
            Self::Rwh => "Read and write, but hardware changes it too: writing back a stale value undoes the hardware.",
            Self::Wclr => "Any write clears or presets it; the written value is ignored.",
        }
    }
}

/// The access rules of one field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Access {
    /// The code.
    pub code: AccessCode,
    /// What a read does to the field.
    pub on_read: Option<OnRead>,
    /// A write has an effect only under this condition.
    pub when: Option<ConditionId>,
    /// The field can be set only under this condition, and cleared at any time.
    pub set_when: Option<ConditionId>,
    /// For [`WriteEffect::Resets`]: the field whose value is loaded; otherwise the field is cleared.
    pub loads: Option<FieldRef>,
    /// Why writing back what was read is harmless although the code has no neutral value.
    pub safe_to_write_back: Option<String>,
    /// The value that software has to write.
    pub must_write: Option<u64>,
}

impl Access {
    /// The neutral write value, taking [`Access::safe_to_write_back`] into account.
    #[must_use]
    pub fn neutral(&self) -> Neutral {
        if self.safe_to_write_back.is_some() { Neutral::AsRead } else { self.code.neutral() }
    }

    /// The code with its modifiers and conditions, as the field tables print it: `rw:config`, `ro+rc@2`,
    /// `rw+s:config` (may be set only under the condition). `condition` gives a condition's name.
    #[must_use]
    pub fn notation(&self, condition: impl Fn(ConditionId) -> String) -> String {
        let mut text = self.code.as_str().to_owned();
        if let Some(OnRead { effect, byte }) = self.on_read {
            text += match effect {
                ReadEffect::Clear => "+rc",
                ReadEffect::Set => "+rs",
            };
            if let Some(byte) = byte {
                text += &format!("@{byte}");
            }
        }
        if let Some(id) = self.when {
            text += &format!(":{}", condition(id));
        }
        if let Some(id) = self.set_when {
            text += &format!("+s:{}", condition(id));
        }
        text
    }
}
