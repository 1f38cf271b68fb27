//! The three layers of interrupts (34.12).

use pic32_can_pac::{
    enums::InterruptCode,
    registers::{FifoInt, Int},
};
use regbus::meta::AliasOp;

use super::{Pic32CanModel, memory::SystemError};
use crate::{
    model::Context,
    registers::{Slot, WriteAccess},
};

/// What the layers depend on besides the registers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Interrupts {
    /// FIFOs with an enabled level flag.
    transmit: u32,
    receive: u32,
    /// What CiRXOVF shows with rxovf_latches.
    pub(super) latched_overflows: u32,
    /// Which error set SERRIF.
    pub(super) system_error: Option<SystemError>,
}

/// Level flags of CiFIFOINTn; each has its enable 16 bits higher.
const LEVELS: u32 = FifoInt::TXNFULLIF
    .union(FifoInt::TXHALFIF)
    .union(FifoInt::TXEMPTYIF)
    .union(FifoInt::RXFULLIF)
    .union(FifoInt::RXHALFIF)
    .union(FifoInt::RXNEMPTYIF)
    .bits();
const ENABLES: u32 = FifoInt::TXNFULLIE.bits() / FifoInt::TXNFULLIF.bits();

impl Pic32CanModel {
    fn int(&self) -> Int {
        Int::from_bits(self.regs.get(self.r.int))
    }

    /// 34.12: a flag is set whether it is enabled or not.
    pub(super) fn raise(&mut self, flag: Int) {
        self.regs.set(self.r.int, (self.int() | flag).bits());
        self.show_code();
    }

    /// The module is off: no flag is left (registers_while_off).
    pub(super) fn clear_flags(&mut self) {
        let flags = Int::IVRIF | Int::WAKIF | Int::CERRIF | Int::SERRIF | Int::MODIF | Int::CTMRIF;
        self.regs.set(self.r.int, self.int().bits() & !flags.bits());
        self.interrupts.system_error = None;
        self.show_code();
    }

    /// Layer 3 to layer 2 for one FIFO (34.12.1.7, 34.12.1.10, 34.12.1.11, 34.12.4, 34.12.5).
    pub(super) fn collect(&mut self, fifo: u8) {
        let bit = 1_u32 << fifo;
        let word = self.regs.get(self.r.fifo_interrupt[usize::from(fifo)]);
        let pending = word & LEVELS & (word / ENABLES) != 0;
        let transmits = self.transmits(fifo);
        let put = |mask: u32, holds: bool| if holds { mask | bit } else { mask & !bit };
        self.interrupts.transmit = put(self.interrupts.transmit, pending && transmits);
        self.interrupts.receive = put(self.interrupts.receive, pending && !transmits);
        let fifo_int = FifoInt::from_bits(word);
        let overflowed = match self.config.choices.rxovf_latches {
            false => fifo_int.rxovflif() && fifo_int.rxovflie(),
            true => {
                if !fifo_int.rxovflif() {
                    self.interrupts.latched_overflows &= !bit;
                }
                self.interrupts.latched_overflows & bit != 0
            }
        };
        self.regs.set(self.r.fstat, self.interrupts.transmit | self.interrupts.receive);
        self.regs.set(self.r.rxovf, put(self.regs.get(self.r.rxovf), overflowed));
        self.show_layer_2();
    }

    fn show_layer_2(&mut self) {
        let shown = [
            (Int::TBIF, self.interrupts.transmit != 0),
            (Int::RBIF, self.interrupts.receive != 0),
            (Int::RBOVIF, self.regs.get(self.r.rxovf) != 0),
        ];
        let word =
            shown.into_iter().fold(
                self.int().bits(),
                |word, (flag, holds)| {
                    if holds { word | flag.bits() } else { word & !flag.bits() }
                },
            );
        self.regs.set(self.r.int, word);
        self.show_code();
    }

    /// 34.12.6: the highest pending interrupt that is enabled.
    pub(super) fn show_code(&mut self) {
        let int = self.int();
        let system = match self.interrupts.system_error {
            Some(SystemError::Bandwidth) => InterruptCode::BusBandwidthError,
            _ => InterruptCode::AddressError,
        };
        // From the highest natural priority down.
        let sources = [
            (int.ivrif() && int.ivrie(), InterruptCode::InvalidMessage),
            (int.modif() && int.modie(), InterruptCode::ModeChange),
            (int.ctmrif() && int.ctmrie(), InterruptCode::TimeStampTimer),
            (int.serrif() && int.serrie(), system),
            (int.rbovif() && int.rbovie(), InterruptCode::ReceiveOverflow),
            (int.wakif() && int.wakie(), InterruptCode::WakeUp),
            (int.cerrif() && int.cerrie(), InterruptCode::Error),
        ];
        let gated = self.config.choices.icod_needs_layer_2;
        let gate = |fifos: u32, enabled: bool| if gated && !enabled { 0 } else { fifos };
        let fifos = gate(self.interrupts.transmit, int.tbie()) | gate(self.interrupts.receive, int.rbie());
        let code = match sources.into_iter().find(|(pending, _)| *pending) {
            Some((_, code)) => u32::from(code.bits()),
            // FIFO31 has the highest priority among the FIFOs.
            None if fifos != 0 => fifos.ilog2(),
            None => u32::from(InterruptCode::NoInterrupt.bits()),
        };
        self.regs.set_field(self.f.icod, code);
    }

    pub(super) fn int_written(&mut self, cx: &mut Context<'_>, access: &WriteAccess) {
        self.show_code();
        if access.old & !access.new & Int::WAKIF.bits() != 0 && self.is_sleeping() && self.con().on() {
            self.watch_for_activity(cx);
        }
    }

    /// `status_flag_writes`: a driver that tries to set a flag.
    pub(super) fn write_flags(&self, cx: &mut Context<'_>, flags: u32, access: &mut WriteAccess) {
        let wanted = match access.alias {
            Some(AliasOp::Set) | Some(AliasOp::Invert) => access.ones(),
            // A read-modify-write brings back the flags that were set.
            None => access.ones() & !access.old,
            Some(AliasOp::Clear) => 0,
        };
        let set = wanted & flags & !access.old;
        if set == 0 {
            return;
        }
        if self.config.choices.flags_can_be_set {
            access.new |= set;
        }
        let Some(field) = self.flag_name(access.slot, set) else { return };
        self.ignored(cx, "34.12", access.slot, field, "only the module sets a flag");
    }

    fn flag_name(&self, slot: Slot, bits: u32) -> Option<&'static str> {
        self.regs.info(slot).fields.iter().find(|field| field.all() & bits != 0).map(|field| field.name)
    }
}

/// The flags of CiINT that software clears.
pub(super) const CLEARABLE: u32 =
    Int::IVRIF.union(Int::WAKIF).union(Int::CERRIF).union(Int::MODIF).union(Int::CTMRIF).bits();
