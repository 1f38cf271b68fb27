//! The receive FIFO: its area, its two pointers, their interrupt (9.3, 9.4).

use dspic33_ecan_pac::registers as pac;

use super::{EcanModel, config::FifoPointerStart, tx::TX_BUFFERS};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::WriteAccess};

/// The most buffers there are (1.2).
pub(super) const MAX_BUFFERS: u32 = 32;

impl EcanModel {
    fn fctrl(&self) -> pac::Fctrl {
        pac::Fctrl::from_bits(self.regs.get(self.n.fctrl) as u16)
    }

    /// 9.2: the number of message buffers. dmabs_code_7: 32.
    pub(super) fn buffer_count(&self) -> u32 {
        self.fctrl().dmabs().map_or(MAX_BUFFERS, |count| count.number().unwrap_or(MAX_BUFFERS))
    }

    /// First and last buffer of the FIFO (9.3).
    pub(super) fn fifo_area(&self) -> (u8, u8) {
        let (start, end) = (self.fctrl().fsa(), (self.buffer_count() - 1) as u8);
        if start > end && !self.config.choices.fsa_beyond_end_loses {
            return (start, (MAX_BUFFERS - 1) as u8);
        }
        (start, end)
    }

    /// Write and read pointer (Register 4-19).
    pub(super) fn fifo_pointers(&self) -> (u8, u8) {
        (self.regs.field(self.n.fbp) as u8, self.regs.field(self.n.fnrb) as u8)
    }

    fn load_fifo_pointers(&mut self) {
        let start = self.regs.field(self.n.fsa);
        self.regs.set_field(self.n.fbp, start);
        self.regs.set_field(self.n.fnrb, start);
        self.rx.fifo_started = true;
    }

    /// fifo_pointer_start.
    pub(super) fn fctrl_written(&mut self, cx: &mut Context<'_>) {
        let configuring = self.modes.now == dspic33_ecan_pac::enums::OperationMode::Configuration;
        match self.config.choices.fifo_pointer_start {
            FifoPointerStart::Configuration if configuring => self.load_fifo_pointers(),
            FifoPointerStart::EveryWrite => self.load_fifo_pointers(),
            FifoPointerStart::Configuration | FifoPointerStart::FirstMessage => {}
        }
        if let Err(code) = self.fctrl().dmabs() {
            let value = u32::from(code);
            cx.report("9.2", DiagnosticKind::ReservedValue { register: "FCTRL", field: "DMABS", value });
        }
        if !configuring {
            self.check_fifo(cx);
        }
    }

    /// Configuration mode is left.
    pub(super) fn configuration_left(&mut self) {
        match self.config.choices.fifo_pointer_start {
            FifoPointerStart::Configuration => self.load_fifo_pointers(),
            FifoPointerStart::FirstMessage => self.rx.fifo_started = false,
            FifoPointerStart::EveryWrite => {}
        }
    }

    /// The first message for the FIFO is at hand.
    pub(super) fn start_fifo(&mut self) {
        if !self.rx.fifo_started {
            self.load_fifo_pointers();
        }
    }

    /// 9.3: what a FIFO must not be, if a filter uses it.
    pub(super) fn check_fifo(&mut self, cx: &mut Context<'_>) {
        let (start, end) = (self.fctrl().fsa(), (self.buffer_count() - 1) as u8);
        let fifo = dspic33_ecan_pac::enums::FilterTarget::Fifo;
        let enabled = self.enabled_filters();
        if !(0..16).any(|filter| enabled >> filter & 1 == 1 && self.target(filter) == fifo) {
            return;
        }
        if start > end {
            let what = format!("the FIFO starts at buffer {start}, behind the last buffer {end}");
            cx.report("9.3", DiagnosticKind::Contradiction { what });
        }
        for buffer in (start..=end).filter(|buffer| *buffer < TX_BUFFERS && self.is_transmit_buffer(*buffer)) {
            let what = format!("the FIFO from buffer {start} to {end} contains transmit buffer {buffer}");
            cx.report("9.3", DiagnosticKind::Contradiction { what });
        }
    }

    /// The buffer behind another one in the FIFO (9.3.1).
    fn next_in_fifo(&self, buffer: u8) -> u8 {
        let (start, end) = self.fifo_area();
        if buffer == end { start } else { (buffer + 1) % MAX_BUFFERS as u8 }
    }

    /// 9.3.1: FBP advances, after a message was stored or lost.
    pub(super) fn advance_fifo(&mut self) {
        let (write, _) = self.fifo_pointers();
        self.regs.set_field(self.n.fbp, u32::from(self.next_in_fifo(write)));
    }

    /// Equation 9-4, with FBP advanced.
    pub(super) fn fifo_almost_full(&self) -> bool {
        let (start, end) = self.fifo_area();
        let (write, read) = self.fifo_pointers();
        i16::from(read) - i16::from(write) == 1 || (read == start && write == end)
    }

    /// 9.3.1: RXFUL bits were cleared. `register` counts from 0.
    pub(super) fn buffers_released(&mut self, cx: &mut Context<'_>, register: usize, access: &WriteAccess) {
        let released = (access.old & !access.new) << (16 * register);
        self.check_release_order(cx, released, access.old << (16 * register) | self.full());
        let (start, end) = self.fifo_area();
        let in_fifo = |buffer: &u8| (start..=end).contains(buffer);
        let follows = |buffer: &u8| in_fifo(buffer) || self.config.choices.fnrb_follows_every_buffer;
        let buffers = (0..MAX_BUFFERS as u8).filter(|buffer| released >> buffer & 1 == 1);
        // fnrb_several_released: the highest number counts.
        if let Some(last) = buffers.filter(follows).max() {
            let next = match in_fifo(&last) && last == end {
                // fnrb_wrap.
                true if self.config.choices.fnrb_wraps => start,
                _ => last + 1,
            };
            self.regs.set_field(self.n.fnrb, u32::from(next));
        }
    }

    /// 9.3.1: buffers that the FIFO has filled are to be released one after the other, the oldest first.
    fn check_release_order(&mut self, cx: &mut Context<'_>, released: u32, full: u32) {
        let is_released = |buffer: &u8| released >> buffer & 1 == 1;
        let count = self.rx.filled.iter().filter(|buffer| is_released(buffer)).count();
        let wrong = self.rx.filled.iter().take(count).any(|buffer| !is_released(buffer));
        if let (true, Some(oldest)) = (wrong, self.rx.filled.front().copied()) {
            let (start, end) = self.fifo_area();
            let fill = (start..=end).filter(|buffer| full >> buffer & 1 == 1).count() as u32;
            let index = self.rx.filled.iter().find(|buffer| is_released(buffer)).map_or(0, |buffer| u32::from(*buffer));
            let get = u32::from(oldest);
            cx.report("9.3.1", DiagnosticKind::AcknowledgeInvalid { register: "RXFUL", index, get, fill });
        }
        self.rx.filled.retain(|buffer| !is_released(buffer));
    }
}
