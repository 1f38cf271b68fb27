//! Microchip dsPIC33F/PIC24H Enhanced CAN (ECAN) as the Family Reference Manual DS70000185D describes it. Sections in
//! comments are of that manual.
//!
//! One module per concern of the manual's chapters. What registers hold, and what writes and reads of them do, is not
//! here: it comes from the metadata of [`dspic33_ecan_pac`].

mod bit_timing;
mod capture;
mod check;
mod config;
mod dma;
mod errors;
mod fifo;
mod filters;
mod inspect;
mod interrupts;
mod message;
mod modes;
mod names;
mod power;
mod rx;
mod stale;
mod tx;
mod tx_abort;
mod window;

use can_wire::{Event, EventKind, Role as NodeRole, Time, TimingError};
use dspic33_ecan_pac::{enums::InterruptCode, meta::CONTROLLER};

use crate::{
    diagnostic::DiagnosticKind,
    memory::MemoryId,
    model::{Context, Model, Rule},
    registers::{ReadAccess, RegisterFile, Slot, WriteAccess},
    sim::{Handle, Sim},
};

pub use capture::Captures;
pub use config::{BytesBeyondDlc, Choices, EcanConfig, FifoPointerStart, IcodeOrder, ListenAllDestination};
pub use dma::{DmaAddressing, DmaChannel, DmaStatistics};
pub use inspect::{BufferContents, FifoState};
pub use power::Power;

use names::{Names, Role};

/// A model of one ECAN module. Made by [`Sim::add_dspic33_ecan`].
#[derive(Clone, Debug)]
pub struct EcanModel {
    regs: RegisterFile,
    n: Names,
    config: EcanConfig,
    modes: modes::Modes,
    power: Power,
    wake_up: power::WakeUp,
    window: window::WindowUse,
    known: stale::Known,
    counters: errors::Counters,
    served: interrupts::Served,
    captures: Captures,
    dma: dma::Dma,
    tx: tx::Tx,
    rx: rx::Rx,
}

impl Sim {
    /// Adds an ECAN module of a dsPIC33F or PIC24H.
    ///
    /// # Errors
    /// A [`TimingError`] if clock or delays in the configuration describe no node.
    pub fn add_dspic33_ecan(&self, name: &str, config: EcanConfig) -> Result<Handle<EcanModel>, TimingError> {
        self.add(name, config.place, EcanModel::new(config))
    }
}

impl EcanModel {
    /// A module after its hardware reset.
    #[must_use]
    pub fn new(config: EcanConfig) -> Self {
        let regs = RegisterFile::new(&CONTROLLER, config.unknown_reset);
        let n = Names::look_up(&regs);
        let mut model = Self {
            regs,
            n,
            config,
            modes: modes::Modes::default(),
            power: Power::default(),
            wake_up: power::WakeUp::default(),
            window: window::WindowUse::default(),
            known: stale::Known::default(),
            counters: errors::Counters::default(),
            served: interrupts::Served::default(),
            captures: Captures::default(),
            dma: dma::Dma::new(config.transmit_dma, config.receive_dma),
            tx: tx::Tx::default(),
            rx: rx::Rx::default(),
        };
        model.reset_lost_registers();
        model
    }

    /// reset_of_lost_registers: registers whose page is missing reset to 0, CxVEC to the code for no interrupt.
    fn reset_lost_registers(&mut self) {
        for slot in [self.n.fctrl, self.n.intf, self.n.cfg1].into_iter().chain(self.n.trcon) {
            self.regs.set(slot, 0);
        }
        self.regs.set(self.n.vec, u32::from(InterruptCode::NoInterrupt.bits()));
    }

    /// A hardware reset of the device (7.1). DMA channels stay as they were set up, DMA RAM keeps its content.
    pub fn reset(&mut self, cx: &mut Context<'_>) {
        cx.wire.set_mode(cx.node, can_wire::Mode::Off);
        cx.wire.set_error_counters(cx.node, 0, 0);
        let [transmit, receive] = self.dma_channels();
        *self = Self::new(EcanConfig { transmit_dma: transmit, receive_dma: receive, ..self.config });
    }
}

impl Model for EcanModel {
    fn registers(&self) -> &RegisterFile {
        &self.regs
    }

    fn registers_mut(&mut self) -> &mut RegisterFile {
        &mut self.regs
    }

    fn attached(&mut self, _cx: &mut Context<'_>) {}

    fn before_read(&mut self, _cx: &mut Context<'_>, slot: Slot) {
        if self.n.role(slot) == Role::Vec {
            self.show_code();
        }
    }

    fn after_read(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        self.watch_window(cx, access.slot);
        match self.n.role(access.slot) {
            Role::Rxful(_) | Role::Rxovf(_) | Role::Trcon(_) | Role::Intf => {
                self.known.learn(access.slot, access.value);
            }
            Role::Data => self.data_register_accessed(cx, access.slot),
            _ => {}
        }
    }

    fn on_write(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        self.watch_window(cx, access.slot);
        match self.n.role(access.slot) {
            Role::Ctrl1 => self.write_ctrl1(cx, access),
            Role::Trcon(register) => self.write_trcon(cx, register, access),
            Role::Data => self.data_register_accessed(cx, access.slot),
            _ => {}
        }
    }

    fn after_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let role = self.n.role(access.slot);
        match role {
            Role::Rxful(_) | Role::Rxovf(_) | Role::Trcon(_) | Role::Intf => {
                self.watch_stale_write(cx, access, role);
                self.known.learn(access.slot, access.new);
            }
            _ => {}
        }
        match role {
            Role::Ctrl1 => self.ctrl1_written(cx, access),
            Role::Ctrl2 => self.ctrl2_written(cx),
            Role::Fctrl => self.fctrl_written(cx),
            Role::Fmsksel => self.fmsksel_written(cx),
            Role::Rxful(register) => self.buffers_released(cx, register, access),
            Role::Trcon(register) => self.trcon_written(cx, register, access),
            _ => {}
        }
    }

    fn after_reserved(&mut self, _cx: &mut Context<'_>, _offset: u32) {}

    fn memory_written(&mut self, cx: &mut Context<'_>, memory: MemoryId, word: usize) {
        if memory == self.config.memory {
            self.watch_pending_buffers(cx, word);
        }
    }

    fn on_event(&mut self, cx: &mut Context<'_>, event: &Event) {
        match event.kind {
            EventKind::StartOfFrame { role: NodeRole::Transmitter } => self.own_frame_started(),
            EventKind::Received { frame, .. } => self.received(cx, &frame),
            EventKind::Transmitted { .. } => self.transmitted(cx),
            EventKind::ArbitrationLost { .. } => self.arbitration_lost(cx),
            EventKind::TransmissionFailed(_) => self.transmission_failed(cx),
            EventKind::Error(error) => self.error(cx, &error),
            EventKind::Counters { tec, rec } => self.count(tec, rec),
            EventKind::ErrorState { from, to } => self.error_state(cx, from, to),
            EventKind::RecoverySequence { .. } => self.recovery_sequence(cx),
            EventKind::Integrated => self.integrated(cx),
            EventKind::BusIdle => self.bus_idle(cx),
            EventKind::ModeChanged { mode } => self.node_mode_changed(cx, mode),
            EventKind::Aborted { .. } => self.request_dropped(cx),
            EventKind::WakeUp => self.edge_in_sleep(cx),
            _ => {}
        }
    }

    fn next_timer(&self) -> Option<Time> {
        [self.dma.next_timer(), self.power_timer()].into_iter().flatten().min()
    }

    fn on_timer(&mut self, cx: &mut Context<'_>) {
        self.transmit_words_due(cx);
        self.receive_words_due(cx);
        self.power_time_passed(cx);
    }

    fn active_lines(&self) -> u32 {
        self.lines()
    }

    fn section(&self, rule: Rule) -> &'static str {
        match rule {
            Rule::Addresses => "3.0",
            Rule::Protection => "7.1",
            Rule::ReadEffects => "4.0",
            Rule::Interrupts => "12.3",
        }
    }

    fn describe(&self, now: Time) -> String {
        self.dump(now)
    }
}

impl EcanModel {
    /// rxd_txd_by_cpu: no message moves, and it is reported.
    fn data_register_accessed(&self, cx: &mut Context<'_>, slot: Slot) {
        let what = format!("{} was accessed by the CPU; it is the DMA channel's", self.regs.info(slot).name);
        cx.report("12.1, 12.2", DiagnosticKind::Contradiction { what });
    }
}
