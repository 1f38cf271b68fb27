//! Microchip PIC32MX CAN as Section 34 of the PIC32MX Family Reference Manual, revision A, describes it. Sections in
//! comments are of that manual.
//!
//! One module per concern of the manual's chapters. What registers hold, and what writes and reads of them do, is not
//! here: it comes from the metadata of [`pic32_can_pac`].

mod bit_timing;
mod config;
mod errors;
mod fifo;
mod filters;
mod inspect;
mod interrupts;
mod low_power;
mod memory;
mod modes;
mod names;
mod rx;
mod timestamp;
mod tx;
mod tx_abort;
mod tx_message;

use can_wire::{Event, EventKind, Time, TimingError};
use pic32_can_pac::{
    meta::CONTROLLER,
    registers::{FifoCon, FifoInt, Int},
};

use crate::{
    diagnostic::DiagnosticKind,
    memory::MemoryId,
    model::{Context, Model, Rule},
    registers::{ReadAccess, RegisterFile, Slot, WriteAccess},
    sim::{Handle, Sim},
};

pub use config::{
    Choices, DeviceNetOrder, ErrorStateChanges, OverflowFlag, Pic32CanConfig, RegistersWhileOff, RemoteFlag,
    UserAddress,
};
pub use inspect::Element;
pub use low_power::DeviceState;
pub use memory::SystemError;

use names::{Fields, Named, Slots};

/// A model of one PIC32MX CAN module. Made by [`Sim::add_pic32_can`].
#[derive(Clone, Debug)]
pub struct Pic32CanModel {
    regs: RegisterFile,
    r: Slots,
    f: Fields,
    config: Pic32CanConfig,
    modes: modes::Modes,
    fifos: fifo::Fifos,
    tx: tx::Tx,
    tx_fields: [u32; 4],
    rx: rx::Rx,
    errors: errors::Errors,
    interrupts: interrupts::Interrupts,
    timer: timestamp::Timer,
}

impl Sim {
    /// Adds a PIC32MX CAN module.
    ///
    /// # Errors
    /// A [`TimingError`] if clock or delays in the configuration describe no node.
    ///
    /// # Panics
    /// If the configuration has more than 32 FIFOs, or none.
    pub fn add_pic32_can(&self, name: &str, config: Pic32CanConfig) -> Result<Handle<Pic32CanModel>, TimingError> {
        self.add(name, config.place, Pic32CanModel::new(config))
    }
}

impl Pic32CanModel {
    /// A module after the reset of its device.
    ///
    /// # Panics
    /// If the configuration has more than 32 FIFOs, or none.
    #[must_use]
    pub fn new(config: Pic32CanConfig) -> Self {
        assert!((1..=32).contains(&config.fifos), "a module has 1 to 32 FIFOs, not {}", config.fifos);
        let mut regs = RegisterFile::new(&CONTROLLER, config.unknown_reset);
        if config.choices.narrow_accesses {
            regs.set_access_widths(&[8, 16, 32]);
        }
        let (r, f) = names::look_up(&regs);
        let [sid, eid] = tx_message::implemented();
        let mut model = Self {
            regs,
            r,
            f,
            config,
            modes: modes::Modes::default(),
            fifos: fifo::Fifos::default(),
            tx: tx::Tx::default(),
            tx_fields: [sid, eid, u32::MAX, u32::MAX],
            rx: rx::Rx::default(),
            errors: errors::Errors::default(),
            interrupts: interrupts::Interrupts::default(),
            timer: timestamp::Timer::default(),
        };
        model.lay_out();
        model
    }

    /// False for a register of a FIFO or filter that the device does not have.
    fn is_implemented(&self, named: Named) -> bool {
        match named {
            Named::FilterControl(n) => n * 4 < self.config.fifos,
            Named::Filter(n)
            | Named::FifoControl(n)
            | Named::FifoInterrupt(n)
            | Named::FifoUser(n)
            | Named::FifoIndex(n) => n < self.config.fifos,
            _ => true,
        }
    }

    fn not_implemented(&self, cx: &mut Context<'_>, slot: Slot, write: bool) {
        cx.report("34.3", DiagnosticKind::NotImplemented { register: self.regs.name(slot), write });
    }

    /// `registers_while_off`.
    fn is_locked(&self, slot: Slot) -> bool {
        let locks = self.config.choices.registers_while_off == RegistersWhileOff::Locked;
        locks && slot != self.r.con && !self.con().on()
    }
}

impl Model for Pic32CanModel {
    fn registers(&self) -> &RegisterFile {
        &self.regs
    }

    fn registers_mut(&mut self) -> &mut RegisterFile {
        &mut self.regs
    }

    fn attached(&mut self, _cx: &mut Context<'_>) {}

    fn before_read(&mut self, cx: &mut Context<'_>, slot: Slot) {
        let named = self.r.named(slot);
        if !self.is_implemented(named) {
            self.not_implemented(cx, slot, false);
            self.regs.set(slot, 0);
            return;
        }
        match named {
            Named::Tmr => self.show_timer(cx),
            Named::Con => self.show_busy(),
            Named::FifoUser(fifo) => self.show_user_address(fifo),
            _ => {}
        }
    }

    fn after_read(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        let named = self.r.named(access.slot);
        match named {
            Named::Con => self.watch_futile_polling(cx, access),
            Named::FifoUser(fifo) if fifo < self.config.fifos => self.watch_user_address(cx, access),
            _ => {}
        }
        let control = if let Named::FifoControl(fifo) = named { Some(fifo) } else { None };
        self.watch_status_reads(cx, control, access);
    }

    fn on_write(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        let named = self.r.named(access.slot);
        if !self.is_implemented(named) {
            access.new = access.old;
            return self.not_implemented(cx, access.slot, true);
        }
        if self.is_locked(access.slot) {
            access.new = access.old;
            let field = self.regs.info(access.slot).fields.first().map_or("", |field| field.name);
            return self.ignored(cx, "34.4", access.slot, field, "the module is off");
        }
        match named {
            Named::Con => self.write_con(cx, access),
            Named::Int => self.write_flags(cx, interrupts::CLEARABLE, access),
            Named::Tmr => self.write_timer(cx, access),
            Named::Mask(mask) => self.write_mask(cx, mask, access),
            Named::FilterControl(register) => self.write_filter_control(cx, register, access),
            Named::Filter(_) => self.write_filter(cx, access),
            Named::FifoControl(fifo) => self.write_control(cx, fifo, access),
            Named::FifoInterrupt(_) => self.write_flags(cx, FifoInt::RXOVFLIF.bits(), access),
            Named::FifoBase | Named::FifoUser(_) | Named::FifoIndex(_) | Named::Plain => {}
        }
    }

    fn after_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let named = self.r.named(access.slot);
        if !self.is_implemented(named) {
            return;
        }
        match named {
            Named::Con => self.con_written(cx, access),
            Named::Int => self.int_written(cx, access),
            Named::Tmr => self.timer_written(cx, access),
            Named::FilterControl(register) => self.check_destinations(cx, register),
            Named::FifoBase => self.base_written(cx),
            Named::FifoControl(fifo) => self.control_written(cx, fifo, access),
            Named::FifoInterrupt(fifo) => self.collect(fifo),
            Named::Mask(_) | Named::Filter(_) | Named::FifoUser(_) | Named::FifoIndex(_) | Named::Plain => {}
        }
    }

    fn after_reserved(&mut self, _cx: &mut Context<'_>, _offset: u32) {}

    fn memory_written(&mut self, cx: &mut Context<'_>, memory: MemoryId, word: usize) {
        if memory == self.config.memory {
            self.word_written(cx, word);
        }
    }

    fn on_event(&mut self, cx: &mut Context<'_>, event: &Event) {
        match event.kind {
            EventKind::StartOfFrame { role } => self.start_of_frame(cx, role),
            EventKind::Received { frame, .. } => self.received(cx, &frame),
            EventKind::Transmitted { frame, .. } => {
                self.message_over();
                self.transmitted(cx, &frame);
            }
            EventKind::ArbitrationLost { .. } => self.transmission_ended(cx, FifoCon::TXLARB),
            EventKind::TransmissionFailed(_) => self.transmission_ended(cx, FifoCon::TXERR),
            EventKind::Aborted { .. } => self.request_dropped(cx),
            EventKind::Error(error) => {
                // 34.12.1.1.
                self.raise(Int::IVRIF);
                self.reception_failed(cx, &error);
            }
            EventKind::Counters { tec, rec } => self.count_errors(tec, rec),
            EventKind::ErrorState { to, .. } => self.error_state(cx, to),
            EventKind::Integrated => self.integrated(cx),
            EventKind::BusIdle => self.message_boundary(cx, false),
            EventKind::ModeChanged { mode } => self.node_mode_changed(cx, mode),
            EventKind::WakeUp => self.activity(cx),
            _ => {}
        }
    }

    fn next_timer(&self) -> Option<Time> {
        let timers = [self.modes_timer(), self.fifo_timer(), self.rx_timer(), self.timestamp_timer()];
        timers.into_iter().flatten().min()
    }

    fn on_timer(&mut self, cx: &mut Context<'_>) {
        self.modes_time_passed(cx);
        self.fifo_time_passed(cx);
        self.rx_time_passed(cx);
        self.timestamp_time_passed(cx);
    }

    fn section(&self, rule: Rule) -> &'static str {
        match rule {
            Rule::Addresses => "34.3, Table 34-1",
            Rule::Protection => "34.5.1, 34.8.1",
            Rule::ReadEffects => "Register 34-20",
            Rule::Interrupts => "34.12",
        }
    }

    fn describe(&self, now: Time) -> String {
        self.dump(now)
    }
}

/// The numbers of the bits that are 1, lowest first.
fn bits(mut mask: u32) -> impl Iterator<Item = u8> {
    core::iter::from_fn(move || {
        let bit = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (bit < 32).then_some(bit as u8)
    })
}
