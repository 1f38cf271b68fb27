//! What the device around the module decides, and how the model reads the manual where it is silent.

use can_wire::{NodeConfig, Time};

use super::dma::DmaChannel;
use crate::{memory::MemoryId, registers::UnknownReset};

/// When the FIFO pointers take the start of the FIFO (`fifo_pointer_start`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum FifoPointerStart {
    /// When CxFCTRL is written in Configuration mode and when that mode is left.
    #[default]
    Configuration,
    /// Whenever CxFCTRL is written.
    EveryWrite,
    /// When the first message is stored in the FIFO.
    FirstMessage,
}

/// Where a message goes that matches no filter in Listen All Messages mode (`listen_all_destination`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ListenAllDestination {
    /// To the buffer of the lowest-numbered enabled filter, with that filter's number as FILHIT.
    #[default]
    FirstFilter,
    /// To buffer 0, with FILHIT 0.
    Buffer0,
    /// To the FIFO, with FILHIT 0.
    Fifo,
}

/// What stands in the data bytes beyond the DLC of a received message (`bytes_beyond_dlc`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum BytesBeyondDlc {
    /// 0.
    #[default]
    Zero,
    /// What the buffer held before.
    Kept,
    /// What the message before left in the module.
    PreviousMessage,
}

/// Order of priority of the interrupt conditions that ICODE names (`icode_order`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum IcodeOrder {
    /// Error, wake-up, receive overflow, FIFO almost full, then the buffers from 31 down to 0.
    #[default]
    HighestFirst,
    /// The lowest code first.
    LowestCodeFirst,
}

/// Where the manual leaves a question open, the model has a named choice; the names are those of the description's
/// `choices`. These can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choices {
    /// `configuration_on_request` (7.1): true if Configuration mode that is entered by request clears the error
    /// counters and ends bus off.
    pub configuration_clears_counters: bool,
    /// `bus_off_recovery` (Figure 11-1): true if the recovery starts by itself, false if software has to request
    /// Configuration mode and then another one.
    pub automatic_bus_off_recovery: bool,
    /// `terrcnt_in_bus_off` (11.2.3): true if TERRCNT shows 255 in bus off, false if it shows the low eight bits of the
    /// counter.
    pub terrcnt_saturates: bool,
    /// `mode_change_with_pending_messages` (7.0): true if requests that are pending stay so when the mode changes,
    /// false if they are aborted.
    pub requests_survive_mode_change: bool,
    /// `listen_all_destination` (7.4).
    pub listen_all_destination: ListenAllDestination,
    /// `listen_all_broken_message` (7.4): true if what had been received before an error is stored.
    pub listen_all_stores_broken: bool,
    /// `loopback_pins` (7.5): true if CxTX shows the frames in Loopback mode, false if it stays recessive.
    pub loopback_drives_pin: bool,
    /// `txreq_on_receive_buffer` (9.2.2): true if the buffer is sent all the same.
    pub receive_buffer_is_sent: bool,
    /// `data_frame_on_remote_buffer` (9.2.2): true if a data frame for a buffer with TXEN and RTREN sets its RXOVF.
    pub data_frame_on_remote_buffer_overflows: bool,
    /// `frame_on_transmit_buffer` (9.2.2): true if a frame for a buffer with TXEN and without RTREN sets its RXOVF.
    pub frame_on_transmit_buffer_overflows: bool,
    /// `txerr_clearing` (8.1): true if TXERR stays set when the message is sent at last, false if that clears it.
    pub txerr_stays: bool,
    /// `bytes_beyond_dlc` (10.1.1).
    pub bytes_beyond_dlc: BytesBeyondDlc,
    /// `fifo_pointer_start` (9.4).
    pub fifo_pointer_start: FifoPointerStart,
    /// `fnrb_wrap` (9.3.1): true if FNRB becomes the start of the FIFO when its last buffer is released, false if it
    /// becomes the number of that buffer plus one.
    pub fnrb_wraps: bool,
    /// `fnrb_outside_fifo` (9.3.1): true if the release of a buffer outside the FIFO changes FNRB too.
    pub fnrb_follows_every_buffer: bool,
    /// `fsa_beyond_end` (9.3): true if a FIFO that starts behind the last buffer loses its messages, false if its
    /// pointers count up to 31.
    pub fsa_beyond_end_loses: bool,
    /// `pointer_beyond_buffers` (9.2.1): true if a message for a buffer beyond those of DMABS is stored, false if it is
    /// lost.
    pub pointer_beyond_buffers_stores: bool,
    /// `fifo_among_several_filters` (9.2.4): true if the FIFO counts as an empty buffer only while the buffer that FBP
    /// names can take a message, false if it always does.
    pub fifo_counts_when_empty: bool,
    /// `devicenet_mask` (9.5): true if the mask of the extended identifier applies to the data bits.
    pub devicenet_masked: bool,
    /// `invalid_message_condition` (Figure 12-1): true if an error in a frame that the module sends sets IVRIF too.
    pub invalid_message_includes_transmitted: bool,
    /// `icode_invalid_message` (12.3): true if the invalid message interrupt has the code of the error interrupt, false
    /// if it has the code for no interrupt.
    pub invalid_message_is_error_code: bool,
    /// `icode_order` (12.3).
    pub icode_order: IcodeOrder,
    /// `icode_buffer` (12.3.2): true if ICODE names the buffer that was served last, false if it names the
    /// highest-numbered full buffer.
    pub icode_names_last_buffer: bool,
    /// `information_processing_time` (Register 4-2), in time quanta.
    pub information_processing_time: u8,
    /// `segment2_and_jump_width` (6.4): true if a jump width as long as phase segment 2 is reported too.
    pub equal_jump_width_reported: bool,
    /// `dma_in_filter_window` (Table 3-2): true if DMA reaches CxRXD and CxTXD whatever window is selected, false if it
    /// reaches filter 0 instead.
    pub dma_ignores_window: bool,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            configuration_clears_counters: false,
            automatic_bus_off_recovery: true,
            terrcnt_saturates: true,
            requests_survive_mode_change: true,
            listen_all_destination: ListenAllDestination::FirstFilter,
            listen_all_stores_broken: true,
            loopback_drives_pin: false,
            receive_buffer_is_sent: false,
            data_frame_on_remote_buffer_overflows: false,
            frame_on_transmit_buffer_overflows: true,
            txerr_stays: true,
            bytes_beyond_dlc: BytesBeyondDlc::Zero,
            fifo_pointer_start: FifoPointerStart::Configuration,
            fnrb_wraps: true,
            fnrb_follows_every_buffer: false,
            fsa_beyond_end_loses: true,
            pointer_beyond_buffers_stores: true,
            fifo_counts_when_empty: true,
            devicenet_masked: true,
            invalid_message_includes_transmitted: true,
            invalid_message_is_error_code: true,
            icode_order: IcodeOrder::HighestFirst,
            icode_names_last_buffer: true,
            information_processing_time: 2,
            equal_jump_width_reported: false,
            dma_ignores_window: true,
        }
    }
}

/// What the device around the module decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct EcanConfig {
    /// The DMA RAM with the message buffers; its first byte is `_DMA_BASE` (Figure 10-1). Both modules of a device may
    /// share it.
    pub memory: MemoryId,
    /// The instruction clock FCY as the node's clock, its tolerance, and the place on the bus. Bit timing and protocol
    /// options in it are replaced by those of the registers when Configuration mode is left.
    pub place: NodeConfig,
    /// The DMA channel for the CxTX request, `None` if no channel has it (10.1).
    pub transmit_dma: Option<DmaChannel>,
    /// The DMA channel for the CxRX request, `None` if no channel has it (10.1.1).
    pub receive_dma: Option<DmaChannel>,
    /// How long the bus has to stay dominant to wake the device while CxCFG2.WAKFIL is 1 (13.3); a figure of the
    /// device's data sheet.
    pub wake_up_filter: Time,
    /// From the wake-up interrupt until oscillator and CPU run again (13.3).
    pub start_up: Time,
    /// What bits hold whose reset value the register pages print as unknown. Registers whose page is missing reset as
    /// the choice `reset_of_lost_registers` says.
    pub unknown_reset: UnknownReset,
    /// How the manual's silences are read.
    pub choices: Choices,
}

impl EcanConfig {
    /// FCY of 40 MHz, both DMA channels set up for buffers at the start of the DMA RAM.
    #[must_use]
    pub fn new(memory: MemoryId) -> Self {
        Self {
            memory,
            place: NodeConfig::new(),
            transmit_dma: Some(DmaChannel::new(0)),
            receive_dma: Some(DmaChannel::new(0)),
            wake_up_filter: Time::from_ns(120),
            start_up: Time::ZERO,
            unknown_reset: UnknownReset::Zeros,
            choices: Choices::default(),
        }
    }

    /// The same with another FCY in hertz.
    #[must_use]
    pub const fn with_clock(mut self, hz: u32) -> Self {
        self.place.clock_hz = hz;
        self
    }

    /// The same with both DMA channels at another start, DMAxSTA, in bytes from the start of the DMA RAM.
    #[must_use]
    pub const fn with_buffers_at(mut self, start: u32) -> Self {
        self.transmit_dma = Some(DmaChannel::new(start));
        self.receive_dma = Some(DmaChannel::new(start));
        self
    }

    /// The same with other choices.
    #[must_use]
    pub const fn with_choices(mut self, choices: Choices) -> Self {
        self.choices = choices;
        self
    }
}
