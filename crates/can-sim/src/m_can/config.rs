//! What a device maker decides about an M_CAN, and how the model reads the manual where it is silent.

use can_wire::{NodeConfig, Time};

use crate::{memory::MemoryId, registers::UnknownReset};

/// Where the manual leaves a question open, the model has a named choice; the names are those of the description's
/// `choices`. These can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choices {
    /// `per_buffer_enable_gates` (2.3.43, 2.3.44): true if TXBTIE and TXBCIE keep IR.TC and IR.TCF from being set,
    /// false if they act on the interrupt line only.
    pub per_buffer_enable_gates_flag: bool,
    /// `watermark_repetition` (3.4.2, 3.5.8): true if every message stored at or above the watermark sets its flag
    /// again.
    pub watermark_repeats: bool,
    /// `bus_off_recovery_sets_pea` (2.3.14): true if the Bit0Error codes of Bus_Off recovery set IR.PEA.
    pub bus_off_recovery_sets_pea: bool,
    /// `bus_off_recovery_length` (2.3.14): sequences of 11 recessive bits that end Bus_Off.
    pub bus_off_recovery_length: u16,
    /// `protocol_exception_when_disabled` (3.1.3): true if PSR.PXE is set although CCCR.PXHD is 1.
    pub exception_flag_when_disabled: bool,
    /// `debug_state_transition_t5` (3.4.4.2): true if a debug message A after A and B starts a new set, false if it
    /// leads to idle like B.
    pub debug_a_restarts: bool,
    /// `tx_event_esi` (2.4.4): true if ESI of a Tx event is the bit that was transmitted, false if it is the node's
    /// error state when the transmission started.
    pub event_esi_as_transmitted: bool,
    /// `received_data_padding` (3.4.1): true if bytes behind a message in its last word are written as 0, false if they
    /// keep their content.
    pub received_padding_is_zero: bool,
    /// `request_after_ram_failure` (2.3.16): true if the request of a transmission that a Message RAM failure aborted
    /// stays pending, false if it is cancelled.
    pub request_survives_ram_failure: bool,
    /// `command_to_status_delay` (2.2, 2.3.7): CAN clock periods from a write to a command register until the status
    /// follows.
    pub command_delay: u32,
    /// `tx_scan_duration` (3.5): how long a Tx scan takes.
    pub tx_scan: Time,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            per_buffer_enable_gates_flag: true,
            watermark_repeats: false,
            bus_off_recovery_sets_pea: true,
            bus_off_recovery_length: 129,
            exception_flag_when_disabled: true,
            debug_a_restarts: true,
            event_esi_as_transmitted: true,
            received_padding_is_zero: true,
            request_survives_ram_failure: true,
            command_delay: 3,
            tx_scan: Time::ZERO,
        }
    }
}

/// What the device around the M_CAN decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MCanConfig {
    /// The Message RAM. Several M_CANs may share one.
    pub memory: MemoryId,
    /// Clock (`m_can_cclk`), tolerance and place on the bus. Bit timing and protocol options in it are replaced by those
    /// of the registers when CCCR.INIT is cleared.
    pub place: NodeConfig,
    /// CREL (2.3.2).
    pub core_release: u32,
    /// Reset value of the customer register at 0x008, which then holds what is written; `None` if there is none, so that
    /// it reads 0 and ignores writes (`customer_register`).
    pub customer_register: Option<u32>,
    /// `iso_only_g` (2.3.7): CCCR.NISO is reserved.
    pub iso_only: bool,
    /// Timestamp registers of a connected TSU, 1 to 8; `None` if there is none, which fixes CCCR.UTSU to 0 (2.3.7).
    pub tsu_registers: Option<u8>,
    /// Frequency in hertz of the external timebase `m_can_ext_ts`, which counts from time zero (2.3.9).
    pub external_timebase_hz: u32,
    /// What bits without a defined reset value hold.
    pub unknown_reset: UnknownReset,
    /// How the manual's silences are read.
    pub choices: Choices,
}

impl MCanConfig {
    /// Core release 3.3.1 with a CAN clock of 40 MHz, no customer register, no TSU, a timebase of 1 MHz.
    #[must_use]
    pub fn new(memory: MemoryId) -> Self {
        Self {
            memory,
            place: NodeConfig::new(),
            core_release: 0x3313_0311,
            customer_register: None,
            iso_only: false,
            tsu_registers: None,
            external_timebase_hz: 1_000_000,
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

    /// The same with other choices.
    #[must_use]
    pub const fn with_choices(mut self, choices: Choices) -> Self {
        self.choices = choices;
        self
    }
}
