//! The buses that drivers hold.

use regbus::{Bus, Word};

use crate::{Sim, diagnostic::Bits, memory::MemoryId};

/// The bus to the registers of one controller of a simulation.
#[derive(Clone, Copy)]
pub struct RegisterBus<'a> {
    sim: &'a Sim,
    controller: usize,
}

impl<'a> RegisterBus<'a> {
    pub(crate) const fn new(sim: &'a Sim, controller: usize) -> Self {
        Self { sim, controller }
    }
}

impl core::fmt::Debug for RegisterBus<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "RegisterBus({})", self.controller)
    }
}

impl Bus for RegisterBus<'_> {
    fn read<W: Word>(self, offset: usize) -> W {
        W::from_u32(self.sim.read_register(self.controller, offset, Bits(W::BITS as u8)))
    }

    fn write<W: Word>(self, offset: usize, value: W) {
        self.sim.write_register(self.controller, offset, Bits(W::BITS as u8), value.to_u32());
    }
}

/// The bus to a memory of a simulation.
#[derive(Clone, Copy)]
pub struct MemoryBus<'a> {
    sim: &'a Sim,
    memory: MemoryId,
}

impl<'a> MemoryBus<'a> {
    pub(crate) const fn new(sim: &'a Sim, memory: MemoryId) -> Self {
        Self { sim, memory }
    }
}

impl core::fmt::Debug for MemoryBus<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "MemoryBus({})", self.memory.0)
    }
}

impl Bus for MemoryBus<'_> {
    fn read<W: Word>(self, offset: usize) -> W {
        W::from_u32(self.sim.read_memory(self.memory, offset, Bits(W::BITS as u8)))
    }

    fn write<W: Word>(self, offset: usize, value: W) {
        self.sim.write_memory(self.memory, offset, Bits(W::BITS as u8), value.to_u32());
    }
}
