//! What a device decides about the module, and how the model reads the manual where it is silent.

use can_wire::{NodeConfig, Time};

use crate::{memory::MemoryId, registers::UnknownReset};

/// Where the manual leaves a question open, the model has a named choice; the names are those of the description's
/// `choices` and `conflicts`. These can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choices {
    /// `mode_change_moment` (4.1, 4.1.5): true if OPMOD shows a mode on the bus only after bus integration, false if it
    /// does a few clock periods after the request.
    pub mode_after_integration: bool,
    /// CAN clock periods from a mode request until the module acts on it (4.1).
    pub mode_delay: u32,
    /// `illegal_mode_request` (4.1.1, 4.1.2): true if changes between a Normal and a Debug mode are made.
    pub normal_to_debug: bool,
    /// `combined_flag_gating` (12.2): true if RXOVIE and TXATIE of a FIFO gate its bits in RXOVIF and TXATIF.
    pub combined_flags_are_gated: bool,
    /// `icode_gating` (12.4.1): true if only main interrupts that INTH enables show in ICODE.
    pub icode_is_gated: bool,
    /// `overflow_with_several_filters` (8.2): true if every full FIFO that a matching filter points to sets RXOVIF, also
    /// if another takes the message.
    pub every_full_fifo_overflows: bool,
    /// `uinc_beyond_limits` (6.2, 7.1, 9.1.1): true if UINC on a full or empty FIFO is ignored, false if head or tail
    /// moves on and the contents are lost.
    pub uinc_is_checked: bool,
    /// `three_attempts` (6.9.2): attempts in all with TXAT = three.
    pub three_attempts: u8,
    /// `one_shot_with_several_messages` (6.9.1, 6.13): true if a success with attempts disabled ends the request of the
    /// whole FIFO.
    pub one_shot_ends_request: bool,
    /// `bus_off_queue_reset` (13.1): true if bus off resets the queue like the transmit FIFOs.
    pub bus_off_resets_queue: bool,
    /// `event_for_dlc_mismatch` (6.12): true if a message that is not sent because of its DLC gets an event.
    pub event_for_dlc_mismatch: bool,
    /// `bytes_behind_the_message` (9.4): true if the last data word is written whole, with a zero byte.
    pub last_word_is_whole: bool,
    /// `measured_delay` (5.3.3): true if TDCV shows the measured delay in automatic mode.
    pub measured_delay_is_shown: bool,
    /// `error_counter_in_bus_off` (13.0): true if TERRCNT reads 255 in bus off, false if it reads the lower eight bits of
    /// the counter.
    pub bus_off_reads_255: bool,
    /// `data_filter_with_both_formats` (8.2.3): true if only filters with MIDE = 1 and EXIDE = 0 compare data bits.
    pub data_filter_needs_standard: bool,
    /// `diagnostic_counter_overflow` (13.0): true if the diagnostic counters roll over.
    pub diagnostic_counters_wrap: bool,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            mode_after_integration: true,
            mode_delay: 4,
            normal_to_debug: false,
            combined_flags_are_gated: true,
            icode_is_gated: true,
            every_full_fifo_overflows: false,
            uinc_is_checked: true,
            three_attempts: 4,
            one_shot_ends_request: false,
            bus_off_resets_queue: true,
            event_for_dlc_mismatch: false,
            last_word_is_whole: false,
            measured_delay_is_shown: false,
            bus_off_reads_255: false,
            data_filter_needs_standard: false,
            diagnostic_counters_wrap: false,
        }
    }
}

/// What the device around the module decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Dspic33CanfdConfig {
    /// System RAM, in which the message objects lie. Several modules may share it.
    pub memory: MemoryId,
    /// Bus address of the RAM's first byte; addresses in registers are bus addresses.
    pub memory_base: u32,
    /// CAN clock FCAN, tolerance and place on the bus. Bit timing and protocol options in it are replaced by those of the
    /// registers when the module goes on the bus.
    pub place: NodeConfig,
    /// T00FILTER to T11FILTER: how long the bus has to stay dominant to wake the module up, with WAKFIL set (5.2.3,
    /// `wake_up_filter_times`).
    pub wake_up_filter: [Time; 4],
    /// What bits without a defined reset value hold.
    pub unknown_reset: UnknownReset,
    /// How the manual's silences are read.
    pub choices: Choices,
}

impl Dspic33CanfdConfig {
    /// A module with a CAN clock of 40 MHz whose RAM begins at bus address 0x1000, as on a dsPIC33.
    #[must_use]
    pub fn new(memory: MemoryId) -> Self {
        Self {
            memory,
            memory_base: 0x1000,
            place: NodeConfig::new(),
            wake_up_filter: [Time::ZERO; 4],
            unknown_reset: UnknownReset::Zeros,
            choices: Choices::default(),
        }
    }

    /// The same with another CAN clock in hertz.
    #[must_use]
    pub const fn with_clock(mut self, hz: u32) -> Self {
        self.place.clock_hz = hz;
        self
    }

    /// The same with the RAM at another bus address.
    #[must_use]
    pub const fn with_memory_base(mut self, address: u32) -> Self {
        self.memory_base = address;
        self
    }

    /// The same with other choices.
    #[must_use]
    pub const fn with_choices(mut self, choices: Choices) -> Self {
        self.choices = choices;
        self
    }
}
