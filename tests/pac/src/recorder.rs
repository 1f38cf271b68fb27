//! A bus that writes down what happens on it.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use regbus::{Bus, Word};

/// One bus transaction.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Access {
    /// A write, not a read.
    pub is_write: bool,
    /// Width in bits.
    pub bits: u32,
    /// Byte offset.
    pub offset: usize,
    /// The word that was moved.
    pub value: u32,
}

impl std::fmt::Debug for Access {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let kind = if self.is_write { "write" } else { "read" };
        write!(f, "{kind}{}({:#x}, {:#x})", self.bits, self.offset, self.value)
    }
}

/// A write of `bits` bits.
#[must_use]
pub const fn write(bits: u32, offset: usize, value: u32) -> Access {
    Access { is_write: true, bits, offset, value }
}

/// A read of `bits` bits.
#[must_use]
pub const fn read(bits: u32, offset: usize, value: u32) -> Access {
    Access { is_write: false, bits, offset, value }
}

/// Memory that starts as zeros and records every access to it. Nothing has side effects: what a register does is the
/// business of a simulator; here only the transactions count.
#[derive(Debug, Default)]
pub struct Recorder {
    memory: RefCell<BTreeMap<usize, u8>>,
    log: RefCell<Vec<Access>>,
    rises: Cell<Option<(usize, u32)>>,
}

impl Recorder {
    /// Empty memory.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Memory that holds a word at an offset.
    #[must_use]
    pub fn holding(bits: u32, offset: usize, value: u32) -> Self {
        let recorder = Self::new();
        recorder.put(bits, offset, value);
        recorder
    }

    /// Changes memory without an access.
    pub fn put(&self, bits: u32, offset: usize, value: u32) {
        let mut memory = self.memory.borrow_mut();
        for index in 0..bits as usize / 8 {
            memory.insert(offset + index, (value >> (8 * index)) as u8);
        }
    }

    /// What memory holds, without an access.
    #[must_use]
    pub fn peek(&self, bits: u32, offset: usize) -> u32 {
        let memory = self.memory.borrow();
        (0..bits as usize / 8)
            .fold(0, |word, index| word | u32::from(memory.get(&(offset + index)).copied().unwrap_or(0)) << (8 * index))
    }

    /// Sets bits right after the next read of an offset, as hardware does between the read and the write of a
    /// read-modify-write.
    pub fn raise_after_read(&self, offset: usize, bits: u32) {
        self.rises.set(Some((offset, bits)));
    }

    /// The accesses since the last call.
    pub fn take(&self) -> Vec<Access> {
        self.log.take()
    }
}

impl Bus for &Recorder {
    fn read<W: Word>(self, offset: usize) -> W {
        assert_eq!(offset % (W::BITS as usize / 8), 0, "a read of {} bits at {offset:#x} is not aligned", W::BITS);
        let value = self.peek(W::BITS, offset);
        self.log.borrow_mut().push(read(W::BITS, offset, value));
        if let Some((at, bits)) = self.rises.get()
            && at == offset
        {
            self.rises.set(None);
            self.put(W::BITS, offset, value | bits);
        }
        W::from_u32(value)
    }

    fn write<W: Word>(self, offset: usize, value: W) {
        assert_eq!(offset % (W::BITS as usize / 8), 0, "a write of {} bits at {offset:#x} is not aligned", W::BITS);
        self.log.borrow_mut().push(write(W::BITS, offset, value.to_u32()));
        self.put(W::BITS, offset, value.to_u32());
    }
}
