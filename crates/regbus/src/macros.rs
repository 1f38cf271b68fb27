//! What every generated value type has in common.

/// Implements the common part of a register's value type.
///
/// ```
/// #[derive(Clone, Copy, PartialEq, Eq, Hash)]
/// #[repr(transparent)]
/// pub struct Ctrl(u32);
/// const FIELDS: &[regbus::meta::Field] = &[];
/// regbus::register!(Ctrl, u32, "CTRL", 0x0000_0001, FIELDS);
/// assert_eq!(Ctrl::RESET.bits(), 1);
/// assert!(Ctrl::from_bits(3).contains(Ctrl::RESET));
/// ```
#[macro_export]
macro_rules! register {
    ($type:ident, $word:ty, $name:literal, $reset:literal, $fields:expr) => {
        impl $type {
            /// Value after reset; bits without a defined value are 0.
            pub const RESET: Self = Self($reset);
            /// All bits 0.
            pub const ZERO: Self = Self(0);

            /// The value of a word.
            #[inline(always)]
            #[must_use]
            pub const fn from_bits(bits: $word) -> Self {
                Self(bits)
            }

            /// The word of this value.
            #[inline(always)]
            #[must_use]
            pub const fn bits(self) -> $word {
                self.0
            }

            /// Every bit that is 1 in `other` is 1 here.
            #[inline(always)]
            #[must_use]
            pub const fn contains(self, other: Self) -> bool {
                self.0 & other.0 == other.0
            }

            /// Some bit that is 1 in `other` is 1 here.
            #[inline(always)]
            #[must_use]
            pub const fn intersects(self, other: Self) -> bool {
                self.0 & other.0 != 0
            }

            /// The bits of both, for constants; elsewhere `|` does the same.
            #[inline(always)]
            #[must_use]
            pub const fn union(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }

            /// No bit is 1.
            #[inline(always)]
            #[must_use]
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }
        }

        impl $crate::Register for $type {
            type Word = $word;
            const NAME: &'static str = $name;
            const FIELDS: &'static [$crate::meta::Field] = $fields;
            const RESET: Self = Self::RESET;
            #[inline(always)]
            fn from_word(word: $word) -> Self {
                Self(word)
            }
            #[inline(always)]
            fn to_word(self) -> $word {
                self.0
            }
        }

        impl ::core::ops::BitOr for $type {
            type Output = Self;
            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl ::core::ops::BitAnd for $type {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl ::core::ops::BitOrAssign for $type {
            #[inline(always)]
            fn bitor_assign(&mut self, other: Self) {
                self.0 |= other.0;
            }
        }

        impl ::core::fmt::Debug for $type {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::meta::debug(f, $name, self.0 as u32, $fields)
            }
        }

        #[cfg(feature = "defmt")]
        impl $crate::defmt::Format for $type {
            fn format(&self, f: $crate::defmt::Formatter<'_>) {
                $crate::meta::format(f, $name, self.0 as u32, $fields);
            }
        }
    };
}

/// Implements the common part of an enumeration.
#[macro_export]
macro_rules! enumeration {
    ($type:ident, $values:expr) => {
        #[cfg(feature = "defmt")]
        impl $crate::defmt::Format for $type {
            fn format(&self, f: $crate::defmt::Formatter<'_>) {
                $crate::meta::format_name(f, $values.name_of(self.bits() as u32));
            }
        }
    };
}
