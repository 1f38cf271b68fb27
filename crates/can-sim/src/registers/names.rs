//! The registers and fields that a model works with, looked up by their names once.

/// Declares `Slots`, `Fields` and `look_up` for the names of a description.
macro_rules! names {
    (
        registers { $($register:ident = $name:literal),* $(,)? }
        fields { $($field:ident = $of:ident $field_name:literal),* $(,)? }
    ) => {
        /// Registers.
        #[derive(Clone, Debug)]
        pub(super) struct Slots {
            $(pub(super) $register: $crate::registers::Slot,)*
        }

        /// Fields that hardware changes.
        #[derive(Clone, Debug)]
        pub(super) struct Fields {
            $(pub(super) $field: $crate::registers::FieldAt,)*
        }

        /// Looks the names up once.
        pub(super) fn look_up(file: &$crate::registers::RegisterFile) -> (Slots, Fields) {
            let slot = |name| file.find(name, 0, 0).unwrap_or_else(|| panic!("the description has no {name}"));
            let slots = Slots { $($register: slot($name),)* };
            let fields = Fields {
                $($field: file
                    .find_field(slots.$of, $field_name, 0)
                    .unwrap_or_else(|| panic!("the description has no {}.{}", stringify!($of), $field_name)),)*
            };
            (slots, fields)
        }
    };
}

pub(crate) use names;
