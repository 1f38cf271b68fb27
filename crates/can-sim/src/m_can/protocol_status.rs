//! Error counters and protocol status (2.3.13, 2.3.14).

use can_wire::{BusError, ErrorKind, ErrorState, Event, EventKind, Field, Mode, Position, Role};
use m_can_pac::{
    enums::{Activity, LastErrorCode},
    registers::Ir,
};

use super::MCanModel;
use crate::{diagnostic::DiagnosticKind, model::Context, registers::ReadAccess};

/// 2.3.14: the error warning limit.
const WARNING: u16 = 96;
/// 2.3.13: REC has 7 bits; RP says that the error passive level is reached.
const REC_MAX: u16 = 127;

/// What is behind ECR and PSR.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ProtocolStatus {
    tec: u16,
    /// As ECR shows it.
    rec: u16,
    passive: bool,
    /// The last change of the counters was logged in CEL.
    logged: bool,
    recovering: bool,
    /// What the last read of PSR or ECR destroyed, if nothing has happened since.
    destroyed: Option<(bool, u32)>,
    reads: u8,
}

/// Host accesses within which a second read of a status that the first one destroyed counts as a mistake.
const READ_TWICE_WITHIN: u8 = 2;

fn code(kind: ErrorKind) -> LastErrorCode {
    match kind {
        ErrorKind::Stuff => LastErrorCode::StuffError,
        ErrorKind::Form => LastErrorCode::FormError,
        ErrorKind::Ack => LastErrorCode::AckError,
        ErrorKind::Bit1 => LastErrorCode::Bit1Error,
        ErrorKind::Bit0 => LastErrorCode::Bit0Error,
        ErrorKind::Crc => LastErrorCode::CrcError,
    }
}

impl MCanModel {
    pub(super) fn status_event(&mut self, cx: &mut Context<'_>, event: &Event) {
        match event.kind {
            EventKind::StartOfFrame { role: Role::Receiver } => self.set_activity(Activity::Receiver),
            EventKind::StartOfFrame { role: Role::Transmitter } => self.set_activity(Activity::Transmitter),
            EventKind::ArbitrationLost { .. } => self.set_activity(Activity::Receiver),
            EventKind::Integrated | EventKind::BusIdle => self.set_activity(Activity::Idle),
            // 2.3.14: also "00" after a protocol exception event.
            EventKind::ProtocolException => {
                self.regs.set_field(self.f.pxe, 1);
                self.synchronizing();
            }
            EventKind::Received { frame, .. } => {
                // 2.3.14: independent of acceptance filtering.
                if frame.is_fd() {
                    self.regs.set_field(self.f.rfdf, 1);
                    self.regs.set_field(self.f.rbrs, u32::from(frame.bit_rate_switch()));
                    self.regs.set_field(self.f.resi, u32::from(frame.error_state_indicator()));
                }
                self.log_code(cx, LastErrorCode::NoError, frame.bit_rate_switch());
            }
            EventKind::Transmitted { frame, .. } => {
                self.log_code(cx, LastErrorCode::NoError, frame.bit_rate_switch());
            }
            EventKind::Error(error) => self.error(cx, &error),
            EventKind::Counters { tec, rec } => self.count(cx, tec, rec),
            EventKind::ErrorState { to, .. } => self.error_state(cx, to),
            EventKind::RecoverySequence { count } => self.recovery_sequence(cx, count),
            // 2.3.14: TDCV is the position of the secondary sample point.
            EventKind::TransmitterDelay { secondary_sample_point, .. } => {
                self.regs.set_field(self.f.tdcv, u32::from(secondary_sample_point));
            }
            _ => {}
        }
    }

    fn set_activity(&mut self, activity: Activity) {
        self.regs.set_field(self.f.act, u32::from(activity.bits()));
    }

    pub(super) fn synchronizing(&mut self) {
        self.set_activity(Activity::Synchronizing);
    }

    pub(super) fn is_idle(&self) -> bool {
        self.regs.field(self.f.act) == u32::from(Activity::Idle.bits())
    }

    fn error(&mut self, cx: &mut Context<'_>, error: &BusError) {
        let in_data_phase = error.data_phase || self.reached_data_phase(cx, error);
        self.log_code(cx, code(error.kind), in_data_phase);
        // 3.1.3: with PXHD a recessive res bit is a form error; PXE is set all the same
        // (protocol_exception_when_disabled).
        let exception = error.kind == ErrorKind::Form && error.position == Position::new(Field::Res, 0);
        if exception && self.cccr().pxhd() && self.config.choices.exception_flag_when_disabled {
            self.regs.set_field(self.f.pxe, 1);
        }
        if self.modes.mode == Mode::Restricted {
            // 2.3.13: with ASM the counters are frozen, the error logging counts on. 3.1.5: the node waits for bus idle.
            self.log_error(cx);
            self.synchronizing();
        }
    }

    /// 2.3.14, `valid_frame_code`: once a frame has reached its data phase, the next event is reported in DLEC, also one
    /// in its end.
    fn reached_data_phase(&self, cx: &mut Context<'_>, error: &BusError) -> bool {
        let behind = (Field::CrcDelimiter..=Field::Eof).contains(&error.position.field);
        behind && cx.wire.partial_frame(cx.node).frame.is_some_and(|frame| frame.bit_rate_switch())
    }

    /// 2.3.14, 2.3.16: LEC or DLEC takes a value; other than 0 and 7 it is a protocol error.
    fn log_code(&mut self, cx: &mut Context<'_>, code: LastErrorCode, data_phase: bool) {
        self.status.destroyed = None;
        let (field, flag) = if data_phase { (self.f.dlec, Ir::PED) } else { (self.f.lec, Ir::PEA) };
        self.regs.set_field(field, u32::from(code.bits()));
        if !matches!(code, LastErrorCode::NoError | LastErrorCode::NoChange) {
            self.raise(cx, flag);
        }
    }

    /// 2.3.13.
    fn count(&mut self, cx: &mut Context<'_>, tec: u16, rec: u16) {
        let shown = rec.min(REC_MAX);
        // CEL does not count when only RP is set.
        self.status.logged = tec > self.status.tec || shown > self.status.rec;
        if self.status.logged {
            self.log_error(cx);
        }
        (self.status.tec, self.status.rec) = (tec, shown);
        self.status.recovering = false;
        self.regs.set_field(self.f.tec, u32::from(tec));
        self.show_rec(rec);
        let warning = tec >= WARNING || rec >= WARNING;
        if warning != self.regs.is_set(self.f.ew) {
            self.regs.set_field(self.f.ew, u32::from(warning));
            self.raise(cx, Ir::EW);
        }
    }

    fn show_rec(&mut self, rec: u16) {
        self.regs.set_field(self.f.rec, u32::from(rec.min(REC_MAX)));
        self.regs.set_field(self.f.rp, u32::from(rec > REC_MAX));
    }

    /// 2.3.13: CEL sticks at 0xFF; the next increment of a counter sets ELO.
    fn log_error(&mut self, cx: &mut Context<'_>) {
        let logged = self.regs.field(self.f.cel);
        if logged == 0xFF {
            self.raise(cx, Ir::ELO);
        } else {
            self.regs.set_field(self.f.cel, logged + 1);
        }
    }

    /// 2.3.14, 2.3.16: error passive and Bus_Off; their flags are set by every change.
    fn error_state(&mut self, cx: &mut Context<'_>, to: ErrorState) {
        let bus_off = to == ErrorState::BusOff;
        // 2.3.13: reaching the Bus_Off limit is logged, also where TEC cannot show it.
        if bus_off && !self.status.logged {
            self.log_error(cx);
        }
        let passive = to != ErrorState::Active;
        if passive != core::mem::replace(&mut self.status.passive, passive) {
            self.regs.set_field(self.f.ep, u32::from(passive));
            self.raise(cx, Ir::EP);
        }
        if bus_off != self.regs.is_set(self.f.bo) {
            self.raise(cx, Ir::BO);
            // Sets CCCR.INIT, by the description.
            self.regs.set_field(self.f.bo, u32::from(bus_off));
            self.synchronizing();
        }
        if !bus_off && self.modes.mode != Mode::Off && core::mem::take(&mut self.status.recovering) {
            self.set_activity(Activity::Idle);
        }
    }

    /// 2.3.14: every sequence of the recovery leaves a Bit0Error in LEC and is counted in REC, which stays at 127 with RP
    /// set (receive_counter_in_recovery).
    fn recovery_sequence(&mut self, cx: &mut Context<'_>, count: u16) {
        self.status.recovering = true;
        self.status.rec = count.min(REC_MAX);
        self.show_rec(count);
        if self.config.choices.bus_off_recovery_sets_pea {
            self.log_code(cx, LastErrorCode::Bit0Error, false);
        } else {
            self.regs.set_field(self.f.lec, u32::from(LastErrorCode::Bit0Error.bits()));
        }
    }

    /// True while the node is error passive.
    pub(super) const fn is_error_passive(&self) -> bool {
        self.status.passive
    }

    /// A read of PSR or ECR destroys what it shows; a driver that reads again at once has lost it.
    pub(super) fn watch_status_reads(&mut self, cx: &mut Context<'_>, access: &ReadAccess) {
        self.status.reads = self.status.reads.saturating_add(1);
        let (is_psr, is_ecr) = (access.slot == self.r.psr, access.slot == self.r.ecr);
        if !(is_psr || is_ecr) {
            return;
        }
        if let Some((psr, lost)) = self.status.destroyed.take()
            && psr == is_psr
            && self.status.reads <= READ_TWICE_WITHIN
            && access.value & !access.left | access.left & !access.value == 0
        {
            let register = self.regs.name(access.slot);
            cx.report("2.3.13, 2.3.14", DiagnosticKind::StatusReadTwice { register, lost, seen: access.value });
        }
        if access.value != access.left && self.tells_an_error(is_psr, access.value) {
            self.status.destroyed = Some((is_psr, access.value));
            self.status.reads = 0;
        }
    }

    fn tells_an_error(&self, psr: bool, value: u32) -> bool {
        let field = |at: crate::registers::FieldAt| (value & at.bits()) >> at.bits().trailing_zeros();
        if psr {
            let quiet = |code: u32| code == 0 || code == 7;
            return !quiet(field(self.f.lec)) || !quiet(field(self.f.dlec)) || field(self.f.pxe) != 0;
        }
        field(self.f.cel) != 0
    }
}
