//! The description of a controller against its model: every register over the bus. Each law goes through everything that
//! the description has of its kind; a controller says only where its registers are more than storage.

pub mod expected;

use can_sim::{DiagnosticKind, Handle, Model, Sim};
use expected::At;
use regbus::{
    Bus,
    meta::{Access, AliasOp, Controller, Expr, ReadEffect},
};

/// A controller under the laws.
pub trait Subject {
    type Model: Model;

    const META: &'static Controller;

    /// A controller after its reset, nothing in it fixed by synthesis.
    fn add(sim: &Sim) -> Handle<Self::Model>;

    /// Brings it into the mode in which registers take what is written.
    fn configure(sim: &Sim, id: Handle<Self::Model>);

    /// Bits that show something else than what was written: a pin, a counter, a state of the model.
    fn follows(register: &str, field: &str) -> bool;

    /// Registers whose writes make the model do more than store; each has tests of its own.
    fn acts(register: &str) -> bool;

    /// Registers that the host should not read: the model reports it.
    fn reads_are_reported(_register: &str) -> bool {
        false
    }

    /// Takes it out of a reset in which flags are held cleared.
    fn release(_sim: &Sim, _id: Handle<Self::Model>) {}

    /// Brings a named condition about, or the contrary, where forcing its fields is not enough. Returns false to leave it
    /// to the fields.
    fn bring_about(_sim: &Sim, _id: Handle<Self::Model>, _condition: &str, _holds: bool) -> bool {
        false
    }
}

type Id<S> = Handle<<S as Subject>::Model>;

/// A simulation with the subject alone.
fn bench<S: Subject>(configured: bool) -> (Sim, Id<S>) {
    let sim = Sim::new();
    let id = S::add(&sim);
    if configured {
        S::configure(&sim, id);
        assert_eq!(sim.diagnostics(), []);
    }
    (sim, id)
}

fn get<S: Subject>(sim: &Sim, id: Id<S>, at: At) -> u32 {
    sim.inspect(id, |model| model.registers().get(at.slot(model.registers())))
}

/// Sets a register from inside.
fn force<S: Subject>(sim: &Sim, id: Id<S>, at: At, value: u32) {
    sim.act(id, |model, _| {
        let slot = at.slot(model.registers());
        model.registers_mut().set(slot, value);
    });
}

/// Selects the window of a register. False for one that belongs to the device.
fn select<S: Subject>(sim: &Sim, id: Id<S>, window: Option<u8>) {
    let Some(window) = window else { return };
    sim.act(id, |model, _| {
        let window = &S::META.windows[window as usize];
        let field = model.registers().field_at(window.select);
        model.registers_mut().set_field(field, window.value);
    });
}

/// The registers of the block, with their offsets.
fn registers<S: Subject>() -> impl Iterator<Item = (At, u32)> {
    expected::registers(S::META).filter_map(|at| at.info.offset_of(at.element, at.inner).map(|offset| (at, offset)))
}

fn read(bus: impl Bus, offset: u32, width: u8) -> u32 {
    match width {
        8 => bus.read::<u8>(offset as usize).into(),
        16 => bus.read::<u16>(offset as usize).into(),
        _ => bus.read::<u32>(offset as usize),
    }
}

fn write(bus: impl Bus, offset: u32, width: u8, value: u32) {
    match width {
        8 => bus.write(offset as usize, value as u8),
        16 => bus.write(offset as usize, value as u16),
        _ => bus.write(offset as usize, value),
    }
}

/// Aligned accesses of every legal width that lie in `bytes`: distance and width.
fn accesses<S: Subject>(bytes: u32) -> impl Iterator<Item = (u32, u8)> {
    S::META.access_widths.iter().flat_map(move |width| {
        let step = u32::from(width / 8);
        (0..bytes / step).map(move |n| (n * step, *width))
    })
}

/// Mask of an access in a register that begins at its distance 0.
fn lanes(distance: u32, width: u8) -> u32 {
    regbus::bits::mask(u32::from(width)) << (distance * 8)
}

fn steady<S: Subject>(at: At) -> u32 {
    !at.bits(|field| S::follows(at.info.name, field.name))
}

/// The bits that a read shows.
fn readable(at: At) -> u32 {
    at.bits(|field| field.access != Access::Wo)
}

/// Every register reads its reset value; reading does not change what the next read sees.
pub fn reset_values<S: Subject>() -> u32 {
    let (sim, id) = bench::<S>(false);
    let mut count = 0;
    for (at, offset) in registers::<S>() {
        select::<S>(&sim, id, at.info.window);
        // What selects the window is not at its reset value here.
        let selects = |field: &regbus::meta::Field| {
            let select = S::META.windows.iter().map(|window| {
                let info = &S::META.registers[window.select.register as usize];
                (info.name, info.fields[window.select.field as usize].name)
            });
            at.info.window.is_some() && select.into_iter().any(|name| name == (at.info.name, field.name))
        };
        let known = readable(at) & !at.info.reset_unknown & !at.bits(selects);
        for _ in 0..2 {
            let value = read(sim.registers(id), offset, at.info.width);
            let name = sim.inspect(id, |model| model.registers().name(at.slot(model.registers())));
            assert_eq!(value & known, at.info.reset & known, "{name}");
            assert_eq!(value & !readable(at), 0, "{name}: bits that do not exist or are not readable");
        }
        if S::reads_are_reported(at.info.name) {
            assert_eq!(sim.take_diagnostics().len(), 2, "{}", at.info.name);
        }
        count += 1;
    }
    // Values that mean nothing after a reset may be looked at all the same.
    let unreliable = |kind: &DiagnosticKind| matches!(kind, DiagnosticKind::ReadUnreliable { .. });
    let others: Vec<_> = sim.diagnostics().into_iter().filter(|diagnostic| !unreliable(&diagnostic.kind)).collect();
    assert_eq!(others, []);
    count
}

/// In configuration mode every bit of every register takes a write as its access says, in every legal width, and through
/// every alias register.
pub fn writes<S: Subject>() -> u32 {
    let mut count = 0;
    let plain = (0, None);
    let operations: Vec<(u32, Option<AliasOp>)> =
        core::iter::once(plain).chain(S::META.aliases.iter().map(|alias| (alias.offset, Some(alias.op)))).collect();
    for (at, offset) in registers::<S>() {
        if S::acts(at.info.name) {
            continue;
        }
        for &(distance, operation) in operations.iter().filter(|(_, operation)| operation.is_none() || at.info.aliased)
        {
            for value in [u32::MAX, 0, 0xA5A5_A5A5, 0x5A5A_5A5A] {
                for (byte, width) in accesses::<S>(u32::from(at.info.width / 8)) {
                    let (sim, id) = bench::<S>(true);
                    select::<S>(&sim, id, at.info.window);
                    let mask = lanes(byte, width);
                    let written = value & mask;
                    let (expected, name) = sim.inspect(id, |model| {
                        let file = model.registers();
                        let old = file.get(at.slot(file));
                        let data = match operation {
                            None => written,
                            Some(AliasOp::Clear) => old & !written,
                            Some(AliasOp::Set) => old | written,
                            Some(AliasOp::Invert) => old ^ written,
                        };
                        (expected::after_write(file, at, data, mask), file.name(at.slot(file)))
                    });
                    write(sim.registers(id), offset + distance + byte, width, written >> (byte * 8));
                    let steady = steady::<S>(at);
                    let stored = get::<S>(&sim, id, at);
                    assert_eq!(
                        stored & steady,
                        expected & steady,
                        "{name} after {written:#x} {operation:?}, {width} bits"
                    );
                    count += 1;
                }
            }
        }
    }
    count
}

fn arrange<S: Subject>(sim: &Sim, id: Id<S>, condition: u16, own: u32, holds: bool) {
    let condition = &S::META.conditions[condition as usize];
    if S::bring_about(sim, id, condition.name, holds) {
        return;
    }
    for (field, index, compared) in expected::way(&condition.expr, holds) {
        let (at, field, lane) = expected::find(S::META, field, index, own);
        let old = get::<S>(sim, id, at);
        let value = compared.value(field) << field.lsb_of(lane);
        force::<S>(sim, id, at, old & !field.mask(lane) | value);
    }
}

/// Every field with a write condition, while it holds and while it does not: then the field stays, and the write is
/// reported.
pub fn write_conditions<S: Subject>() -> u32 {
    let mut count = 0;
    for (at, offset) in registers::<S>() {
        for (field, lane) in at.lanes() {
            let conditions = [(field.when, false), (field.set_when, true)];
            for (condition, only_set) in conditions.into_iter().filter_map(|(condition, set)| Some((condition?, set))) {
                if matches!(S::META.conditions[condition as usize].expr, Expr::Always) || field.access == Access::Wclr {
                    continue;
                }
                for holds in [true, false] {
                    let (sim, id) = bench::<S>(false);
                    arrange::<S>(&sim, id, condition, at.own_number(field, lane), holds);
                    select::<S>(&sim, id, at.info.window);
                    let mask = field.mask(lane);
                    if only_set || field.access == Access::W1s {
                        force::<S>(&sim, id, at, get::<S>(&sim, id, at) & !mask);
                    } else if matches!(field.access, Access::W1c | Access::W0c) {
                        force::<S>(&sim, id, at, get::<S>(&sim, id, at) | mask);
                    }
                    arrange::<S>(&sim, id, condition, at.own_number(field, lane), holds);
                    let _ = sim.take_diagnostics();
                    let before = get::<S>(&sim, id, at);
                    let value = match field.access {
                        Access::W1c => before | mask,
                        _ => before ^ mask,
                    };
                    write(sim.registers(id), offset, at.info.width, value);
                    let (after, name) = (get::<S>(&sim, id, at), format!("{}.{}", at.info.name, field.name));
                    let refused = sim.take_diagnostics().iter().any(|diagnostic| {
                        matches!(&diagnostic.kind, DiagnosticKind::ProtectedWrite { fields, .. } if fields.contains(&field.name))
                    });
                    let condition = S::META.conditions[condition as usize].name;
                    assert_eq!(refused, !holds, "{name}, {condition} {holds}: {before:#x} to {value:#x}");
                    if S::follows(at.info.name, field.name) {
                        continue;
                    }
                    if !holds {
                        assert_eq!(after & mask, before & mask, "{name} is protected by {condition}");
                    } else if field.access != Access::W1s {
                        assert_ne!(after & mask, before & mask, "{name} is free while {condition}");
                    }
                    count += 1;
                }
            }
        }
    }
    count
}

/// Each flag that a written 1 or 0 clears: it alone, by every legal access that reaches it.
pub fn flags<S: Subject>() -> u32 {
    let mut count = 0;
    for (at, offset) in registers::<S>() {
        let clearing = |access| at.bits(move |field| field.access == access && !S::follows(at.info.name, field.name));
        let (by_one, by_zero) = (clearing(Access::W1c), clearing(Access::W0c));
        for bit in (0..u32::from(at.info.width)).filter(|bit| (by_one | by_zero) >> bit & 1 == 1) {
            for (byte, width) in accesses::<S>(u32::from(at.info.width / 8)) {
                let reached = lanes(byte, width);
                if reached >> bit & 1 == 0 {
                    continue;
                }
                let (sim, id) = bench::<S>(false);
                S::release(&sim, id);
                select::<S>(&sim, id, at.info.window);
                let others = get::<S>(&sim, id, at) & !(by_one | by_zero);
                force::<S>(&sim, id, at, others | by_one | by_zero);
                let flags = by_one | by_zero;
                let keep = others & !by_one | by_zero;
                write(sim.registers(id), offset + byte, width, (keep & reached) >> (byte * 8));
                assert_eq!(get::<S>(&sim, id, at) & flags, flags, "{}: nothing is cleared", at.info.name);
                let clear = keep ^ 1 << bit;
                write(sim.registers(id), offset + byte, width, (clear & reached) >> (byte * 8));
                let left = get::<S>(&sim, id, at) & flags;
                assert_eq!(left, flags & !(1 << bit), "{} bit {bit} in {width} bits", at.info.name);
                count += 1;
            }
        }
    }
    count
}

/// Reads with side effects: exactly those that reach the byte which triggers them.
pub fn read_effects<S: Subject>() -> u32 {
    let mut count = 0;
    for (at, offset) in registers::<S>() {
        for (field, lane) in at.lanes() {
            let (trigger, sets) = match field.on_read {
                ReadEffect::None => continue,
                ReadEffect::Clear(byte) => (byte, false),
                ReadEffect::Set(byte) => (byte, true),
            };
            for (byte, width) in accesses::<S>(u32::from(at.info.width / 8)) {
                let (sim, id) = bench::<S>(false);
                S::release(&sim, id);
                select::<S>(&sim, id, at.info.window);
                let mask = field.mask(lane);
                let rest = get::<S>(&sim, id, at) & !mask;
                let full = if sets { 0 } else { mask };
                force::<S>(&sim, id, at, rest | full);
                assert_eq!(get::<S>(&sim, id, at) & mask, full, "{}.{} can be set", at.info.name, field.name);
                read(sim.registers(id), offset + byte, width);
                let reached =
                    (byte..byte + u32::from(width / 8)).any(|byte| trigger.is_none_or(|at| u32::from(at) == byte));
                let expected = if reached { mask & !full } else { full };
                let left = get::<S>(&sim, id, at) & mask;
                assert_eq!(left, expected, "{}.{} after {width} bits at {byte}", at.info.name, field.name);
                count += 1;
            }
        }
    }
    count
}

/// Every reserved address, read and written in every legal width: reported, read as described, its flag set.
pub fn reserved<S: Subject>() -> u32 {
    let mut count = 0;
    let (sim, id) = bench::<S>(false);
    for range in S::META.reserved {
        select::<S>(&sim, id, range.window);
        for (distance, width) in accesses::<S>(range.to + 1 - range.from) {
            for writes in [false, true] {
                let offset = range.from + distance;
                let bus = sim.registers(id);
                if writes {
                    write(bus, offset, width, u32::MAX);
                } else {
                    let expected =
                        range.reads.unwrap_or(0) >> (distance % 4 * 8) & regbus::bits::mask(u32::from(width));
                    assert_eq!(read(bus, offset, width), expected, "{offset:#x}");
                }
                let kinds: Vec<_> = sim.take_diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect();
                assert_eq!(kinds, [DiagnosticKind::ReservedAddress { offset, write: writes }]);
                if let Some(flag) = range.sets {
                    sim.act(id, |model, _| {
                        let flag = model.registers().field_at(flag);
                        assert!(model.registers().is_set(flag), "{offset:#x} sets its flag");
                        model.registers_mut().set_field(flag, 0);
                    });
                }
                count += 1;
            }
        }
    }
    count
}

/// Accesses of a width that is not legal, or not aligned, have no effect and are reported.
pub fn illegal_accesses<S: Subject>() -> u32 {
    let mut count = 0;
    for (at, offset) in registers::<S>() {
        let (sim, id) = bench::<S>(true);
        select::<S>(&sim, id, at.info.window);
        for width in [8, 16, 32] {
            for byte in 0..u32::from(at.info.width / 8) {
                let legal =
                    S::META.access_widths.contains(&width) && (offset + byte).is_multiple_of(u32::from(width / 8));
                if legal {
                    continue;
                }
                let before = get::<S>(&sim, id, at);
                write(sim.registers(id), offset + byte, width, !before);
                assert_eq!(read(sim.registers(id), offset + byte, width), 0);
                let steady = steady::<S>(at);
                assert_eq!(get::<S>(&sim, id, at) & steady, before & steady, "{}", at.info.name);
                let illegal = |write| DiagnosticKind::IllegalAccess { offset: offset + byte, width, write };
                let kinds: Vec<_> = sim.take_diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect();
                assert_eq!(kinds, [illegal(true), illegal(false)]);
                count += 1;
            }
        }
    }
    count
}
