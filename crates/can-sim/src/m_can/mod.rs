//! Bosch M_CAN as its User's Manual 3.3.1 describes it. Sections in comments are of that manual.
//!
//! One module per concern of the manual's chapters 2 and 3. What registers hold, and what writes and reads of them do,
//! is not here: it comes from the metadata of [`m_can_pac`].

mod bit_timing;
mod config;
mod debug_messages;
mod filters;
mod inspect;
mod interrupts;
mod modes;
mod names;
mod protocol_status;
mod ram;
mod rx;
mod rx_fifo;
mod test_modes;
mod timeout;
mod timestamp;
mod tx;
mod tx_cancel;
mod tx_element;
mod tx_event;
mod tx_fifo;

use std::collections::VecDeque;

use can_wire::{Event, EventKind, Mode, Time, TimingError};
use m_can_pac::{meta::CONTROLLER, registers as pac};

use crate::{
    memory::MemoryId,
    model::{Context, Model, Rule},
    registers::{ReadAccess, RegisterFile, Slot, WriteAccess},
    sim::{Handle, Sim},
};

pub use config::{Choices, MCanConfig};
pub use inspect::{RxElement, TxEventElement};
pub use ram::RamFailure;

use names::{Fields, Slots};

/// A write to a command register on its way to the CAN clock domain (2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Command {
    Init(bool),
    AddRequests(u32),
    CancelRequests(u32),
    AcknowledgeRx { fifo: usize, index: u32 },
    AcknowledgeEvents { index: u32 },
}

/// A model of one M_CAN. Made by [`Sim::add_m_can`].
#[derive(Clone, Debug)]
pub struct MCanModel {
    regs: RegisterFile,
    r: Slots,
    f: Fields,
    config: MCanConfig,
    commands: VecDeque<(Time, Command)>,
    modes: modes::Modes,
    status: protocol_status::ProtocolStatus,
    clock: timestamp::BitCounter,
    timestamps: timestamp::Timestamps,
    timeout: timeout::Timeout,
    tx: tx::Tx,
    rx: rx::Rx,
    lines: interrupts::LineState,
}

impl Sim {
    /// Adds an M_CAN.
    ///
    /// # Errors
    /// A [`TimingError`] if clock or delays in the configuration describe no node.
    pub fn add_m_can(&self, name: &str, config: MCanConfig) -> Result<Handle<MCanModel>, TimingError> {
        self.add(name, config.place, MCanModel::new(config))
    }
}

impl MCanModel {
    /// An M_CAN after its hardware reset.
    #[must_use]
    pub fn new(config: MCanConfig) -> Self {
        let mut regs = RegisterFile::new(&CONTROLLER, config.unknown_reset);
        let (r, f) = names::look_up(&regs);
        regs.set(r.crel, config.core_release);
        regs.set(r.cust, config.customer_register.unwrap_or(0));
        let timeout = timeout::Timeout::new(regs.field(f.toc));
        Self {
            regs,
            r,
            f,
            config,
            commands: VecDeque::new(),
            modes: modes::Modes::default(),
            status: protocol_status::ProtocolStatus::default(),
            clock: timestamp::BitCounter::default(),
            timestamps: timestamp::Timestamps::new(config.tsu_registers),
            timeout,
            tx: tx::Tx::default(),
            rx: rx::Rx::default(),
            lines: interrupts::LineState::default(),
        }
    }

    fn cccr(&self) -> pac::Cccr {
        pac::Cccr::from_bits(self.regs.get(self.r.cccr))
    }

    /// 2.2: a command reaches the CAN clock domain after a few clock periods.
    fn command(&mut self, cx: &mut Context<'_>, command: Command) {
        let delay = u64::from(self.config.choices.command_delay);
        if delay == 0 && self.commands.is_empty() {
            return self.execute(cx, command);
        }
        let ps = delay * 1_000_000_000_000 / u64::from(self.config.place.clock_hz.max(1));
        self.commands.push_back((cx.now + Time::from_ps(ps), command));
    }

    fn execute(&mut self, cx: &mut Context<'_>, command: Command) {
        match command {
            Command::Init(init) => self.regs.set_field(self.f.init, u32::from(init)),
            Command::AddRequests(buffers) => self.add_requests(cx, buffers),
            Command::CancelRequests(buffers) => self.cancel_requests(cx, buffers),
            Command::AcknowledgeRx { fifo, index } => self.acknowledge_rx(cx, fifo, index),
            Command::AcknowledgeEvents { index } => self.acknowledge_events(cx, index),
        }
        self.follow(cx);
    }

    /// Whatever has changed in the registers: the modes, the clock stop and the counters follow.
    fn follow(&mut self, cx: &mut Context<'_>) {
        self.follow_configuration_mode(cx);
        self.follow_modes(cx);
        self.follow_clock_stop(cx);
        self.follow_timeout(cx);
    }
}

impl Model for MCanModel {
    fn registers(&self) -> &RegisterFile {
        &self.regs
    }

    fn registers_mut(&mut self) -> &mut RegisterFile {
        &mut self.regs
    }

    fn attached(&mut self, cx: &mut Context<'_>) {
        self.follow(cx);
    }

    fn before_read(&mut self, cx: &mut Context<'_>, slot: Slot) {
        if slot == self.r.tscv || slot == self.r.tocv {
            self.show_counters(cx);
        } else if slot == self.r.test {
            self.show_pin(cx);
        }
    }

    fn after_read(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        self.watch_status_reads(cx, access);
    }

    fn on_write(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        if access.slot == self.r.cccr {
            self.write_cccr(cx, access);
        } else if access.slot == self.r.txbar || access.slot == self.r.txbcr {
            self.write_requests(cx, access);
        } else if access.slot == self.r.cust && self.config.customer_register.is_none() {
            access.new = 0;
        } else if access.slot == self.r.tscv || access.slot == self.r.tocv {
            self.show_counters(cx);
        } else if access.slot == self.r.tscc && access.new != access.old {
            self.keep_counts(cx);
        }
    }

    fn after_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let slot = access.slot;
        if slot == self.r.txbar {
            self.command(cx, Command::AddRequests(access.ones() & self.configured_buffers()));
        } else if slot == self.r.txbcr {
            self.command(cx, Command::CancelRequests(access.ones() & self.configured_buffers()));
        } else if slot == self.r.rxf0a || slot == self.r.rxf1a {
            let fifo = usize::from(slot == self.r.rxf1a);
            self.command(cx, Command::AcknowledgeRx { fifo, index: access.new });
        } else if slot == self.r.txefa {
            self.command(cx, Command::AcknowledgeEvents { index: access.new });
        } else if slot == self.r.tscv {
            self.reset_timestamp(cx);
        } else if slot == self.r.tocv {
            self.preset_timeout(cx);
        } else if slot == self.r.rwd {
            self.show_watchdog();
        } else if slot == self.r.ir {
            self.flags_cleared(access.old & !access.new);
        }
        self.follow(cx);
    }

    fn after_reserved(&mut self, cx: &mut Context<'_>, _offset: u32) {
        // 2.2.1: the access sets IR.ARA, by the description, and pulses m_can_aei_ara.
        self.lines.reserved_accesses += 1;
        self.hear(cx, pac::Ir::ARA);
    }

    fn memory_written(&mut self, cx: &mut Context<'_>, memory: MemoryId, word: usize) {
        if memory == self.config.memory {
            self.watch_pending_buffers(cx, word);
        }
    }

    fn on_event(&mut self, cx: &mut Context<'_>, event: &Event) {
        self.status_event(cx, event);
        match event.kind {
            EventKind::StartOfFrame { role } => self.start_of_frame(cx, role),
            EventKind::Received { frame, .. } => self.received(cx, &frame),
            EventKind::Transmitted { frame, .. } => self.transmitted(cx, &frame),
            EventKind::ArbitrationLost { .. } => self.transmission_ended(cx),
            EventKind::TransmissionFailed(_) => self.transmission_ended(cx),
            EventKind::Aborted { .. } => self.request_dropped(cx),
            EventKind::ErrorState { .. } => self.scan(cx),
            EventKind::Error(error) => self.reception_failed(cx, &error),
            _ => {}
        }
        self.follow(cx);
    }

    fn next_timer(&self) -> Option<Time> {
        let command = self.commands.front().map(|(at, _)| *at);
        let others = [self.tx_timer(), self.timestamp_timer(), self.timeout_timer()];
        others.into_iter().chain([command]).flatten().min()
    }

    fn on_timer(&mut self, cx: &mut Context<'_>) {
        while let Some((_, command)) = self.commands.pop_front_if(|(at, _)| *at <= cx.now) {
            self.execute(cx, command);
        }
        self.show_counters(cx);
        self.tx_time_passed(cx);
        self.follow(cx);
    }

    fn active_lines(&self) -> u32 {
        self.interrupt_lines()
    }

    fn section(&self, rule: Rule) -> &'static str {
        match rule {
            Rule::Addresses => "2.2",
            Rule::Protection => "2.2, 3.1.1",
            Rule::ReadEffects => "2.3.13, 2.3.14",
            Rule::Interrupts => "2.3.16",
        }
    }

    fn describe(&self, now: Time) -> String {
        self.dump(now)
    }
}

/// Modes in which the node sends frames.
const fn sends(mode: Mode) -> bool {
    matches!(mode, Mode::Normal | Mode::InternalLoopback | Mode::ExternalLoopback)
}
