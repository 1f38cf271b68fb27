//! What the device around the module decides, and how the model reads the manual where it is silent.

use can_wire::{BitTiming, FdSupport, NodeConfig, Time};

use crate::{memory::MemoryId, registers::UnknownReset};

/// `registers_while_off` (34.4): what the registers do while CiCON.ON is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum RegistersWhileOff {
    /// They keep their values and can be configured.
    #[default]
    Kept,
    /// All but CiCON.ON return to their reset values when ON is cleared.
    Reset,
    /// They keep their values; writes to all but CiCON are ignored.
    Locked,
}

/// `overflow_flag_of_several_fifos` (34.8.5, 34.12.1.7): which FIFOs get RXOVFLIF.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum OverflowFlag {
    /// The FIFO of the matching filter with the lowest number, if no FIFO took the message.
    #[default]
    LowestFilter,
    /// All FIFOs of matching filters, if no FIFO took the message.
    AllFull,
    /// Every full FIFO that was passed over, also if another one took the message.
    PassedOver,
}

/// `remote_flag_of_standard_frames` (Table 34-5): which bit of a stored standard remote frame is 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum RemoteFlag {
    /// RTR and SRR.
    #[default]
    Both,
    /// RTR only.
    Rtr,
    /// SRR only.
    Srr,
}

/// `error_state_downward` (34.12.1.3): which changes of the error state set CERRIF.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ErrorStateChanges {
    /// All but leaving the warning state.
    #[default]
    AllButLeavingWarning,
    /// Only to a worse state.
    Upward,
    /// All.
    All,
}

/// `user_address_in_configuration` (Register 34-22): what CiFIFOUAn reads in Configuration mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum UserAddress {
    /// The address by the present configuration.
    #[default]
    Present,
    /// The value it had before.
    Before,
    /// 0.
    Zero,
}

/// `devicenet_eid_order` (34.8.7, Register 34-1): which EID bit is compared with bit 7 of data byte 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum DeviceNetOrder {
    /// EID17, then the lower ones (Table 34-4).
    #[default]
    HighestFirst,
    /// EID0, then the higher ones (Register 34-1).
    LowestFirst,
}

/// Where the manual leaves a question open, the model has a named choice; the names are those of the description's
/// `choices`. These can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choices {
    /// `mode_request_while_off` (34.4): true if OPMOD follows REQOP at once while ON is 0.
    pub request_acts_while_off: bool,
    /// `registers_while_off`.
    pub registers_while_off: RegistersWhileOff,
    /// `reserved_mode_request` (Register 34-1): true if OPMOD takes a reserved code, the module then being off the bus.
    pub reserved_mode_taken: bool,
    /// `configuration_entry_wait` (34.5): true if Configuration mode waits for the end of the message in progress, false
    /// if the module leaves the bus at once.
    pub configuration_waits: bool,
    /// `mode_entry` (34.5): true if OPMOD shows a mode before the module has seen 11 recessive bits.
    pub mode_shown_at_once: bool,
    /// `canbusy_while_idle` (Register 34-1): true if CANBUSY is 1 only while a message is in progress.
    pub busy_only_with_message: bool,
    /// `own_frames` (34.13): true if the module receives its own messages in every mode that transmits.
    pub own_frames_received: bool,
    /// `wakeup_flag_in_disable` (34.14.3): true if bus activity sets WAKIF in Disable mode too.
    pub wake_in_disable: bool,
    /// `error_counters_on_configuration` (34.5.1): true if entering Configuration mode clears the error counters.
    pub configuration_clears_counters: bool,
    /// `narrow_access` (34.3): true if bytes and halfwords of the registers can be accessed.
    pub narrow_accesses: bool,
    /// `alias_write_as_read` (Register 34-20): true if a write to CiFIFOCONnCLR, SET or INV clears TXLARB and TXERR.
    pub alias_write_reads: bool,
    /// `timer_alias_write` (Register 34-8): true if a write to CiTMRCLR, SET or INV restarts the prescaler.
    pub alias_write_restarts_timer: bool,
    /// `status_flag_writes` (Register 34-3): true if software can set an interrupt flag.
    pub flags_can_be_set: bool,
    /// `user_address_in_configuration`.
    pub user_address: UserAddress,
    /// `uinc_at_limit` (Register 34-20): true if UINC moves the pointer of a full transmit or empty receive FIFO too.
    pub uinc_passes_limit: bool,
    /// `txen_change` (34.5.1): true if TXEN cannot be changed outside Configuration mode.
    pub txen_locked: bool,
    /// `txreq_on_empty_fifo` (Register 34-20): true if TXREQ of an empty FIFO stays set.
    pub txreq_waits_for_message: bool,
    /// `txreq_in_passive_modes` (34.5.3): true if a request is withdrawn in Listen Only and Disable mode.
    pub txreq_withdrawn_in_passive_modes: bool,
    /// `txreq_after_fifo_reset` (34.6.4): true if TXREQ survives a reset of its FIFO.
    pub txreq_survives_reset: bool,
    /// `partial_abort` (34.7.4): true if TXABAT is set when the message in progress was sent and others stay behind.
    pub partial_abort_sets_flag: bool,
    /// `overflow_flag_of_several_fifos`.
    pub overflow_flag: OverflowFlag,
    /// `filhit_on_overflow` (34.12.7): true if FILHIT shows the filter of a lost message.
    pub filhit_shows_lost: bool,
    /// `data_frame_to_transmit_fifo` (34.7.5): true if the search goes on with the next filter.
    pub search_passes_transmit_fifo: bool,
    /// `remote_frame_to_receive_fifo` (34.2.3): true if such frames are dropped.
    pub remote_frames_dropped: bool,
    /// `remote_flag_of_standard_frames`.
    pub remote_flag: RemoteFlag,
    /// `filter_enable_and_select_in_one_write` (Register 34-10): true if the state of FLTEN after the write decides
    /// whether MSEL and FSEL are taken.
    pub filter_lock_by_new_state: bool,
    /// `filter_disable_delay` (34.8.1): true if a filter that is being disabled stays so when FLTEN is written 1 again.
    pub filter_disable_sticks: bool,
    /// `filter_change_in_other_modes` (34.8.1): true if filters cannot be changed in Listen Only, Listen All Messages and
    /// Loopback mode.
    pub filters_locked_in_other_modes: bool,
    /// `devicenet_eid_order`.
    pub devicenet_order: DeviceNetOrder,
    /// `devicenet_mask` (34.8.7): true if all compared data bits count whatever the mask says.
    pub devicenet_ignores_mask: bool,
    /// `time_stamp_without_capture` (Table 34-5), `message_with_error` (34.5.4): true if what has no value keeps what the
    /// memory held, false if it is 0.
    pub unused_keeps_memory: bool,
    /// `icod_gating` (Register 34-4): true if the codes of FIFOs depend on TBIE and RBIE too.
    pub icod_needs_layer_2: bool,
    /// `rxovf_level` (34.12.5): true if CiRXOVF records only overflows that happen while RXOVFLIE is 1.
    pub rxovf_latches: bool,
    /// `bus_off_recovery` (34.11.2): true if the module stays bus off until it has been in Configuration mode.
    pub bus_off_needs_configuration: bool,
    /// `error_state_downward`.
    pub error_state_changes: ErrorStateChanges,
    /// `warning_above_128` (Register 34-5): true if TXWARN and RXWARN stay 1 at 128 and more.
    pub warning_above_128: bool,
    /// `segment2_automatic` (Register 34-2): true if SEG2PH reads the length in force with SEG2PHTS = 0.
    pub segment2_reads_length: bool,
    /// `reset_duration` (34.4, 34.6.4): system clocks until FRESET or CANBUSY shows the end of a reset.
    pub reset_clocks: u32,
    /// `timer_in_disable_mode` (34.5.6, 34.13): true if the time stamp timer runs on in Disable mode.
    pub timer_runs_in_disable: bool,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            request_acts_while_off: false,
            registers_while_off: RegistersWhileOff::Kept,
            reserved_mode_taken: false,
            configuration_waits: true,
            mode_shown_at_once: false,
            busy_only_with_message: false,
            own_frames_received: false,
            wake_in_disable: false,
            configuration_clears_counters: true,
            narrow_accesses: false,
            alias_write_reads: false,
            alias_write_restarts_timer: true,
            flags_can_be_set: false,
            user_address: UserAddress::Present,
            uinc_passes_limit: false,
            txen_locked: false,
            txreq_waits_for_message: false,
            txreq_withdrawn_in_passive_modes: false,
            txreq_survives_reset: false,
            partial_abort_sets_flag: false,
            overflow_flag: OverflowFlag::LowestFilter,
            filhit_shows_lost: false,
            search_passes_transmit_fifo: false,
            remote_frames_dropped: false,
            remote_flag: RemoteFlag::Both,
            filter_lock_by_new_state: false,
            filter_disable_sticks: false,
            filters_locked_in_other_modes: false,
            devicenet_order: DeviceNetOrder::HighestFirst,
            devicenet_ignores_mask: false,
            unused_keeps_memory: false,
            icod_needs_layer_2: false,
            rxovf_latches: false,
            bus_off_needs_configuration: false,
            error_state_changes: ErrorStateChanges::AllButLeavingWarning,
            warning_above_128: false,
            segment2_reads_length: false,
            reset_clocks: 10,
            timer_runs_in_disable: false,
        }
    }
}

/// What the device around the module decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Pic32CanConfig {
    /// System RAM.
    pub memory: MemoryId,
    /// Physical address at which the RAM begins.
    pub memory_base: u32,
    /// System clock FSYS, tolerance and place on the bus. The bit timing in it is replaced by that of CiCFG.
    pub place: NodeConfig,
    /// FIFOs and filters that the device has: 32, or 16 on some. The registers of the others read 0.
    pub fifos: u8,
    /// The shortest dominant pulse that the filter of WAKFIL lets pass (34.14.3); the device's data sheet has it.
    pub wake_filter: Time,
    /// What bits without a defined reset value hold.
    pub unknown_reset: UnknownReset,
    /// How the manual's silences are read.
    pub choices: Choices,
}

impl Pic32CanConfig {
    /// A module with a system clock of 80 MHz, as in the manual's examples, 32 FIFOs, and RAM from physical address 0.
    #[must_use]
    pub fn new(memory: MemoryId) -> Self {
        let mut place = NodeConfig::new();
        place.clock_hz = 80_000_000;
        place.fd = FdSupport::Classic;
        place.nominal = BitTiming { prescaler: 8, prop_seg: 3, phase_seg1: 3, phase_seg2: 3, sjw: 2 };
        Self {
            memory,
            memory_base: 0,
            place,
            fifos: 32,
            wake_filter: Time::from_ns(700),
            unknown_reset: UnknownReset::Zeros,
            choices: Choices::default(),
        }
    }

    /// The same with another system clock in hertz.
    #[must_use]
    pub const fn with_clock(mut self, hz: u32) -> Self {
        self.place.clock_hz = hz;
        self
    }

    /// The same with the RAM at another physical address.
    #[must_use]
    pub const fn with_memory_base(mut self, address: u32) -> Self {
        self.memory_base = address;
        self
    }

    /// The same with another number of FIFOs and filters.
    #[must_use]
    pub const fn with_fifos(mut self, fifos: u8) -> Self {
        self.fifos = fifos;
        self
    }

    /// The same with other choices.
    #[must_use]
    pub const fn with_choices(mut self, choices: Choices) -> Self {
        self.choices = choices;
        self
    }
}
