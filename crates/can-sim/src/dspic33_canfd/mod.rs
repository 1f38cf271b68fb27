//! Microchip dsPIC33 CAN FD Protocol Module as its reference manual section, revision C, describes it. Sections in
//! comments are of that manual.
//!
//! One module per concern of the manual's chapters. What registers hold, and what writes and reads of them do, is not
//! here: it comes from the metadata of [`dspic33_canfd_pac`].

mod abort;
mod bit_timing;
mod config;
mod control;
mod errors;
mod fifo;
mod filters;
mod inspect;
mod interrupts;
mod low_power;
mod memory;
mod modes;
mod names;
mod queue;
mod rx;
mod system_error;
mod tef;
mod timestamp;
mod tx;
mod tx_object;

use can_wire::{Event, EventKind, Time, TimingError};
use dspic33_canfd_pac::{meta::CONTROLLER, registers as pac};

use crate::{
    memory::MemoryId,
    model::{Context, Model, Rule},
    registers::{ReadAccess, RegisterFile, Slot, WriteAccess},
    sim::{Handle, Sim},
};

pub use config::{Choices, Dspic33CanfdConfig};
pub use inspect::{EventObject, RxObjectHeld, TxObjectHeld};
pub use low_power::DeviceMode;
pub use system_error::SystemFailure;

use names::{Arrays, Fields, Owner, Slots};

/// Bits of INTL that the application clears by writing 0 (table 12-1).
const CLEARED_BY_APPLICATION: u16 = pac::IntL::IVMIF
    .union(pac::IntL::WAKIF)
    .union(pac::IntL::CERRIF)
    .union(pac::IntL::SERRIF)
    .union(pac::IntL::MODIF)
    .union(pac::IntL::TBCIF)
    .bits();

/// A model of one dsPIC33 CAN FD module. Made by [`Sim::add_dspic33_canfd`].
#[derive(Clone, Debug)]
pub struct Dspic33CanfdModel {
    regs: RegisterFile,
    r: Slots,
    f: Fields,
    arrays: Arrays,
    config: Dspic33CanfdConfig,
    modes: modes::Modes,
    low_power: low_power::LowPower,
    layout: memory::Layout,
    fifos: fifo::Fifos,
    tx: tx::Tx,
    rx: rx::Rx,
    errors: errors::Errors,
    system: system_error::SystemErrors,
    time_base: timestamp::TimeBase,
}

impl Sim {
    /// Adds a dsPIC33 CAN FD module.
    ///
    /// # Errors
    /// A [`TimingError`] if clock or delays in the configuration describe no node.
    pub fn add_dspic33_canfd(
        &self,
        name: &str,
        config: Dspic33CanfdConfig,
    ) -> Result<Handle<Dspic33CanfdModel>, TimingError> {
        self.add(name, config.place, Dspic33CanfdModel::new(config))
    }
}

impl Dspic33CanfdModel {
    /// A module after its reset.
    #[must_use]
    pub fn new(config: Dspic33CanfdConfig) -> Self {
        let regs = RegisterFile::new(&CONTROLLER, config.unknown_reset);
        let (r, f) = names::look_up(&regs);
        let arrays = Arrays::look_up(&regs);
        Self {
            regs,
            r,
            f,
            arrays,
            config,
            modes: modes::Modes::default(),
            low_power: low_power::LowPower::default(),
            layout: memory::Layout::empty(),
            fifos: fifo::Fifos::default(),
            tx: tx::Tx::default(),
            rx: rx::Rx::default(),
            errors: errors::Errors::default(),
            system: system_error::SystemErrors::default(),
            time_base: timestamp::TimeBase::default(),
        }
    }

    #[inline]
    fn word(&self, slot: Slot) -> u16 {
        self.regs.get(slot) as u16
    }

    fn con_l(&self) -> pac::ConL {
        pac::ConL::from_bits(self.word(self.r.con_l))
    }

    #[inline]
    fn con_h(&self) -> pac::ConH {
        pac::ConH::from_bits(self.word(self.r.con_h))
    }
}

impl Model for Dspic33CanfdModel {
    fn registers(&self) -> &RegisterFile {
        &self.regs
    }

    fn registers_mut(&mut self) -> &mut RegisterFile {
        &mut self.regs
    }

    fn attached(&mut self, _cx: &mut Context<'_>) {}

    fn before_read(&mut self, cx: &mut Context<'_>, slot: Slot) {
        if slot == self.r.vec_l || slot == self.r.vec_h {
            self.show_codes();
        } else if slot == self.r.tbc_l || slot == self.r.tbc_h {
            self.show_time(cx);
        } else {
            self.watch_address_reads(cx, slot);
        }
    }

    fn after_read(&mut self, _cx: &mut Context<'_>, access: &ReadAccess) {
        if let Owner::Status(number) = self.arrays.owner(access.slot) {
            self.combine(number);
        }
    }

    fn on_write(&mut self, cx: &mut Context<'_>, access: &mut WriteAccess) {
        match self.arrays.owner(access.slot) {
            Owner::Control(number) => self.write_control(cx, access, number),
            Owner::Module if access.slot == self.r.txqcon_l => self.write_control(cx, access, 0),
            Owner::Module if access.slot == self.r.txreq_l => self.write_requests(access, 0),
            Owner::Module if access.slot == self.r.txreq_h => self.write_requests(access, 16),
            Owner::Module if access.slot == self.r.tscon_l || access.slot == self.r.tscon_h => self.keep_time(cx),
            _ => {}
        }
    }

    fn after_write(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        let slot = access.slot;
        match self.arrays.owner(slot) {
            Owner::Control(number) => self.control_written(cx, access, number),
            Owner::Size(_) => self.scan(cx),
            Owner::Status(number) => self.combine(number),
            Owner::Address(_) => {}
            Owner::FilterControl(first) => self.filters_enabled(cx, access, first),
            Owner::Module => self.module_written(cx, access),
        }
    }

    fn after_reserved(&mut self, _cx: &mut Context<'_>, _offset: u32) {}

    fn memory_written(&mut self, cx: &mut Context<'_>, memory: MemoryId, word: usize) {
        if memory == self.config.memory {
            self.watch_pending_objects(cx, word);
        }
    }

    fn on_event(&mut self, cx: &mut Context<'_>, event: &Event) {
        match event.kind {
            EventKind::StartOfFrame { role } => self.start_of_frame(cx, role),
            EventKind::Received { frame, sof, res } => self.received(cx, &frame, sof, res),
            EventKind::Transmitted { frame, sof, res } => self.transmitted(cx, &frame, sof, res),
            EventKind::ArbitrationLost { .. } => self.transmission_ended(cx, tx::Ended::ArbitrationLost),
            EventKind::TransmissionFailed(_) => self.transmission_ended(cx, tx::Ended::Error),
            EventKind::Error(error) => self.error(cx, &error),
            EventKind::Counters { tec, rec } => self.count(tec, rec),
            EventKind::ErrorState { to, .. } => self.error_state(cx, to),
            EventKind::RecoverySequence { .. } => self.recovery_sequence(),
            EventKind::Integrated => self.integrated(cx),
            EventKind::BusIdle => self.regs.set_field(self.f.busy, 0),
            EventKind::ModeChanged { mode } => self.node_changed(cx, mode),
            EventKind::Aborted { .. } => self.request_dropped(cx),
            EventKind::TransmitterDelay { delay, .. } => self.show_measured_delay(delay),
            EventKind::WakeUp => self.bus_activity(cx),
            _ => {}
        }
    }

    fn next_timer(&self) -> Option<Time> {
        let timers = [self.mode_timer(), self.tx_timer(), self.time_base_timer(), self.wake_up_timer()];
        timers.into_iter().flatten().min()
    }

    fn on_timer(&mut self, cx: &mut Context<'_>) {
        self.mode_time_passed(cx);
        self.tx_time_passed(cx);
        self.time_base_passed(cx);
        self.wake_up_time_passed(cx);
    }

    fn section(&self, rule: Rule) -> &'static str {
        match rule {
            Rule::Addresses => "3.0",
            Rule::Protection => "4.2, 8.1, 11.0",
            Rule::ReadEffects => "3.0, Register 3-34",
            Rule::Interrupts => "12.0",
        }
    }

    fn describe(&self, now: Time) -> String {
        self.dump(now)
    }
}
