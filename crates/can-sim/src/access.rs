//! Accesses of the host to registers: one bus transaction of a width, split over what stands at its bytes.

use regbus::meta::AliasOp;

use crate::{
    diagnostic::{Bits, DiagnosticKind},
    model::Rule,
    registers::{Place, Slot, WriteAccess},
    scheduler::Core,
    trace::{AccessRecord, RegisterTouched},
};

pub(crate) type AccessWidth = Bits;

/// The bytes of one register that an access touches.
struct Touch {
    slot: Slot,
    alias: Option<AliasOp>,
    /// Mask of the bytes in the register.
    lanes: u32,
    /// Position of the first byte in the register, and in the value that is moved, in bits.
    in_register: u32,
    in_value: u32,
}

impl Core {
    pub(crate) fn read_register(&mut self, index: usize, offset: u32, width: Bits) -> u32 {
        let mut touched = None;
        let value = self.access(index, offset, width, false, |core, touch| {
            if touch.alias.is_some() {
                return core.read_alias(index, touch);
            }
            let access = core.with_model(index, |model, cx| {
                model.before_read(cx, touch.slot);
                let access = model.registers_mut().read(touch.slot, touch.lanes);
                model.after_read(cx, &access);
                access
            });
            touched.get_or_insert((touch.slot, access.value));
            (access.value & touch.lanes) >> touch.in_register << touch.in_value
        });
        self.record(index, offset, width, value, touched, false);
        value
    }

    /// The value of an alias register is not to be used: it is that of the base register, without the effects of a read
    /// (alias_read_value).
    fn read_alias(&mut self, index: usize, touch: &Touch) -> u32 {
        let value = self.with_model(index, |model, cx| {
            model.before_read(cx, touch.slot);
            let register = model.registers().name(touch.slot);
            let because = "an alias register holds no value of its own";
            cx.report(model.section(Rule::Addresses), DiagnosticKind::InvalidRead { register, because });
            model.registers().peek(touch.slot)
        });
        (value & touch.lanes) >> touch.in_register << touch.in_value
    }

    pub(crate) fn write_register(&mut self, index: usize, offset: u32, width: Bits, value: u32) {
        let mut touched = None;
        self.access(index, offset, width, true, |core, touch| {
            let written = value >> touch.in_value << touch.in_register;
            let access = core.with_model(index, |model, cx| {
                let registers = model.registers();
                let mut access = registers.plan_write(touch.slot, touch.lanes, written, touch.alias);
                model.on_write(cx, &mut access);
                model.registers_mut().commit(&access);
                model.after_write(cx, &access);
                access
            });
            core.report_refused(index, &access);
            let stored = core.entries[index].model.registers().get(touch.slot);
            touched.get_or_insert((touch.slot, stored));
            0
        });
        self.record(index, offset, width, value, touched, true);
    }

    /// Splits an access over the registers it touches and joins what they give.
    fn access(
        &mut self,
        index: usize,
        offset: u32,
        width: Bits,
        write: bool,
        mut touch: impl FnMut(&mut Self, &Touch) -> u32,
    ) -> u32 {
        let legal = self.entries[index].model.registers().access_widths().contains(&width.0);
        if !legal || !offset.is_multiple_of(width.bytes()) {
            self.report_address(index, DiagnosticKind::IllegalAccess { offset, width: width.0, write });
            return 0;
        }
        let (mut byte, mut value, mut reserved) = (0, 0, false);
        while byte < width.bytes() {
            let place = self.entries[index].model.registers().place(offset + byte);
            match place {
                Place::Register { slot, byte: first, alias } => {
                    let bytes = u32::from(self.entries[index].model.registers().info(slot).width / 8);
                    let count = (bytes - u32::from(first)).min(width.bytes() - byte);
                    let in_register = u32::from(first) * 8;
                    let lanes = regbus::bits::mask(count * 8) << in_register;
                    value |= touch(self, &Touch { slot, alias, lanes, in_register, in_value: byte * 8 });
                    byte += count;
                }
                Place::Reserved(range) => {
                    value |= self.reserved_byte(index, range, offset + byte) << (byte * 8);
                    if !core::mem::replace(&mut reserved, true) {
                        self.with_model(index, |model, cx| model.after_reserved(cx, offset));
                        self.report_address(index, DiagnosticKind::ReservedAddress { offset, write });
                    }
                    byte += 1;
                }
                Place::Nothing => {
                    if byte == 0 {
                        self.report_address(index, DiagnosticKind::UnknownAddress { offset, write });
                    }
                    byte += 1;
                }
            }
        }
        value
    }

    /// An access to a byte of a reserved range sets its flag, where it has one.
    fn reserved_byte(&mut self, index: usize, range: u16, offset: u32) -> u32 {
        let registers = self.entries[index].model.registers_mut();
        let range = &registers.meta().reserved[range as usize];
        if let Some(flag) = range.sets {
            let flag = registers.field_at(flag);
            registers.set_field(flag, 1);
        }
        range.reads.unwrap_or(0) >> ((offset - range.from) % 4 * 8) & 0xFF
    }

    fn report_address(&mut self, index: usize, kind: DiagnosticKind) {
        let entry = &self.entries[index];
        let (name, section) = (entry.name.clone(), entry.model.section(Rule::Addresses));
        self.report(&name, section, kind);
    }

    fn report_refused(&mut self, index: usize, access: &WriteAccess) {
        let Some(refused) = access.refused else { return };
        let entry = &self.entries[index];
        let registers = entry.model.registers();
        let fields = registers.info(access.slot).fields.iter();
        let kind = DiagnosticKind::ProtectedWrite {
            register: registers.name(access.slot),
            fields: fields.filter(|field| field.all() & refused.bits != 0).map(|field| field.name).collect(),
            value: access.written,
            condition: registers.meta().conditions[refused.condition as usize].name,
        };
        let (name, section) = (entry.name.clone(), entry.model.section(Rule::Protection));
        self.report(&name, section, kind);
    }

    fn record(
        &mut self,
        index: usize,
        offset: u32,
        width: Bits,
        value: u32,
        touched: Option<(Slot, u32)>,
        write: bool,
    ) {
        let Some(trace) = &mut self.trace else { return };
        let entry = &self.entries[index];
        let registers = entry.model.registers();
        let register = touched.map(|(slot, value)| RegisterTouched {
            name: registers.name(slot),
            fields: registers.info(slot).fields,
            value,
        });
        let (time, controller) = (self.buses.now(), entry.name.clone());
        trace.push(AccessRecord { time, controller, write, offset, width, value, register });
    }
}
