//! Mistakes of a driver, reported where they happen.

use core::fmt;

use can_wire::{Time, TimingError};

/// Width of an access in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bits(pub u8);

impl Bits {
    /// The bits of a word of this width.
    #[must_use]
    pub const fn mask(self) -> u32 {
        regbus::bits::mask(self.0 as u32)
    }

    /// The width in bytes.
    #[must_use]
    pub const fn bytes(self) -> u32 {
        self.0 as u32 / 8
    }
}

/// Something the driver should not have done, or that it cannot have meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// When, in simulated time.
    pub time: Time,
    /// The controller, by the name it was added with; empty for a memory.
    pub controller: String,
    /// What.
    pub kind: DiagnosticKind,
    /// The section of the controller's manual that says so.
    pub section: &'static str,
}

/// What went wrong, with the facts.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DiagnosticKind {
    /// A write that changes bits whose write condition does not hold; they keep their value.
    ProtectedWrite {
        /// The register.
        register: String,
        /// Names of the fields that would have changed.
        fields: Vec<&'static str>,
        /// The value written.
        value: u32,
        /// The condition that does not hold.
        condition: &'static str,
    },
    /// An access to an address that the description reserves.
    ReservedAddress {
        /// Byte offset.
        offset: u32,
        /// True for a write.
        write: bool,
    },
    /// An access outside everything that the description knows.
    UnknownAddress {
        /// Byte offset.
        offset: u32,
        /// True for a write.
        write: bool,
    },
    /// An access of a width that is not legal here, or not aligned to its width. It has no effect and reads 0.
    IllegalAccess {
        /// Byte offset.
        offset: u32,
        /// Width in bits.
        width: u8,
        /// True for a write.
        write: bool,
    },
    /// A register was read twice within a few accesses although the first read destroyed what it showed.
    StatusReadTwice {
        /// The register.
        register: String,
        /// What the first read saw.
        lost: u32,
        /// What the second read saw.
        seen: u32,
    },
    /// A field holds a value outside its legal range.
    ValueOutOfRange {
        /// The register.
        register: &'static str,
        /// The field.
        field: &'static str,
        /// The value.
        value: u32,
        /// The smallest legal value.
        min: u32,
        /// The largest legal value.
        max: u32,
    },
    /// A field was given a value that is reserved.
    ReservedValue {
        /// The register.
        register: &'static str,
        /// The field.
        field: &'static str,
        /// The value.
        value: u32,
    },
    /// Bits that are reserved were written as 1.
    ReservedBits {
        /// The register.
        register: &'static str,
        /// The bits.
        bits: u32,
    },
    /// A register was accessed through a window that another part of the program has selected: an interrupt handler came
    /// while the window was open, or has left it open.
    WindowOfAnother {
        /// The register that was reached.
        register: String,
        /// The window that is selected.
        window: &'static str,
        /// True if an interrupt handler made the access, false for the main program.
        handler: bool,
    },
    /// A value that was read earlier was written back over what hardware has changed since.
    StaleWrite {
        /// The register.
        register: String,
        /// The fields that hardware had changed.
        fields: Vec<&'static str>,
        /// Their bits that were written over.
        bits: u32,
    },
    /// No DMA channel has moved the words of a message.
    TransferNotServed {
        /// The request of the controller.
        request: &'static str,
        /// The message buffer.
        buffer: u32,
        /// Why.
        because: &'static str,
    },
    /// Two fields contradict each other.
    Contradiction {
        /// What is wrong, with the values.
        what: String,
    },
    /// The bit timing in the registers makes no node of the bus; the controller stays off it.
    BitTiming(TimingError),
    /// Two sections of message memory share words.
    SectionsOverlap {
        /// The section that begins first.
        first: &'static str,
        /// The other one.
        second: &'static str,
        /// Byte address of the first shared word.
        address: u32,
    },
    /// A section reaches behind the addresses that the controller can form, or behind the end of the memory.
    SectionBeyondMemory {
        /// The section.
        section: &'static str,
        /// First byte address behind the section.
        end: u32,
        /// First byte address that does not exist.
        limit: u32,
    },
    /// The controller used a word that does not exist; it reads 0 and takes no write.
    MemoryOverrun {
        /// Byte address.
        address: u32,
    },
    /// An acknowledge index that names no element waiting to be read. Elements are lost or read again.
    AcknowledgeInvalid {
        /// The register written.
        register: &'static str,
        /// The index written.
        index: u32,
        /// The get index before.
        get: u32,
        /// The fill level before.
        fill: u32,
    },
    /// A transmission was requested for a buffer that is not the one the put index has handed out.
    NotHandedOut {
        /// The register written.
        register: &'static str,
        /// The buffer.
        buffer: u32,
        /// The put index.
        put: u32,
    },
    /// A FIFO or queue was told to move on although it had no element to move over: full, or empty.
    IncrementIgnored {
        /// The register written.
        register: String,
        /// The fill level.
        fill: u32,
        /// The number of elements.
        depth: u32,
    },
    /// A write meant for something else took a pending request back, because it carried 0 for the request.
    RequestDropped {
        /// The register written.
        register: String,
        /// The value written.
        value: u32,
    },
    /// A FIFO or queue was reset while it was in use.
    ResetInUse {
        /// The register written.
        register: String,
        /// What uses it.
        because: &'static str,
    },
    /// A register was read while its value means nothing.
    ReadUnreliable {
        /// The register.
        register: String,
        /// Why it means nothing.
        because: &'static str,
    },
    /// A mode was requested that cannot be reached from the present one; the request is ignored.
    IllegalModeChange {
        /// The mode the controller is in.
        from: String,
        /// The mode requested.
        to: String,
    },
    /// A request that the controller ignores.
    RequestIgnored {
        /// The register written.
        register: &'static str,
        /// The buffer.
        buffer: u32,
        /// Why it is ignored.
        because: &'static str,
    },
    /// Message memory of a pending request was changed.
    PendingBufferModified {
        /// The buffer.
        buffer: u32,
        /// Byte address of the word.
        address: u32,
    },
    /// A message does not fit the format it is sent in.
    MessageInvalid {
        /// The buffer.
        buffer: u32,
        /// What is wrong.
        what: &'static str,
    },
    /// A new value was written to a field before the one before was taken over.
    NotTakenOver {
        /// The register.
        register: &'static str,
        /// The field.
        field: &'static str,
    },
    /// An enabled interrupt flag was set, but it is routed to lines that are not enabled.
    InterruptUnheard {
        /// The register.
        register: String,
        /// The flags.
        fields: Vec<&'static str>,
    },
    /// A register that this device does not have.
    NotImplemented {
        /// The register.
        register: String,
        /// True for a write.
        write: bool,
    },
    /// A write that the controller ignores.
    WriteIgnored {
        /// The register.
        register: String,
        /// The field.
        field: &'static str,
        /// Why it is ignored.
        because: &'static str,
    },
    /// A read whose value means nothing.
    InvalidRead {
        /// The register.
        register: String,
        /// Why.
        because: &'static str,
    },
    /// The software's side of a FIFO was advanced although there is nothing to advance over.
    FifoLimit {
        /// The FIFO.
        fifo: u32,
        /// True for a full transmit FIFO, false for an empty receive FIFO.
        full: bool,
    },
    /// An address that is not physical was given to a controller that needs a physical one.
    AddressNotPhysical {
        /// The register.
        register: &'static str,
        /// The address.
        address: u32,
    },
    /// A message was put into a transmit FIFO, but nothing was ever written to its buffer.
    BufferNotWritten {
        /// The FIFO.
        fifo: u32,
        /// Address of the buffer.
        address: u32,
    },
    /// Software has written to a received message that it has not taken from its FIFO yet.
    ReceivedMessageModified {
        /// The FIFO.
        fifo: u32,
        /// Address of the word.
        address: u32,
    },
    /// An interrupt handler was entered again and again because the line stayed active.
    InterruptStorm {
        /// The line, counted from 0.
        line: usize,
        /// How often the handler ran.
        entries: u32,
    },
}

impl fmt::Display for DiagnosticKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verb = |write: &bool| if *write { "write to" } else { "read of" };
        match self {
            Self::ProtectedWrite { register, fields, value, condition } => {
                write!(f, "write of {value:#x} to {register} cannot change {}: needs `{condition}`", fields.join(", "))
            }
            Self::ReservedAddress { offset, write } => write!(f, "{} reserved address {offset:#x}", verb(write)),
            Self::UnknownAddress { offset, write } => write!(f, "{} {offset:#x}, where nothing is", verb(write)),
            Self::IllegalAccess { offset, width, write } => write!(f, "{width}-bit {} {offset:#x}", verb(write)),
            Self::StatusReadTwice { register, lost, seen } => {
                write!(f, "{register} was read twice: the first read destroyed {lost:#x}, the second saw {seen:#x}")
            }
            Self::ValueOutOfRange { register, field, value, min, max } => {
                write!(f, "{register}.{field} is {value}, legal are {min} to {max}")
            }
            Self::ReservedValue { register, field, value } => {
                write!(f, "{register}.{field} was given the reserved value {value}")
            }
            Self::ReservedBits { register, bits } => write!(f, "{register}: reserved bits {bits:#x} written as 1"),
            Self::WindowOfAnother { register, window, handler } => {
                let who = if *handler { "an interrupt handler" } else { "the main program" };
                write!(f, "{who} reached {register} through the window `{window}`, which it has not selected")
            }
            Self::StaleWrite { register, fields, bits } => {
                let fields = fields.join(", ");
                write!(
                    f,
                    "{register}: an old value was written over {fields} (bits {bits:#x}), which hardware had changed"
                )
            }
            Self::TransferNotServed { request, buffer, because } => {
                write!(f, "the words of buffer {buffer} were not moved on request {request}: {because}")
            }
            Self::Contradiction { what } => f.write_str(what),
            Self::BitTiming(error) => write!(f, "the bit timing makes no node: {error}"),
            Self::SectionsOverlap { first, second, address } => {
                write!(f, "{first} and {second} overlap in message memory from byte {address:#x} on")
            }
            Self::SectionBeyondMemory { section, end, limit } => {
                write!(f, "{section} ends at byte {end:#x}, the memory at {limit:#x}")
            }
            Self::MemoryOverrun { address } => write!(f, "the controller accessed byte {address:#x} of its memory"),
            Self::AcknowledgeInvalid { register, index, get, fill } => {
                write!(f, "{register}: index {index} acknowledged, but {fill} elements from {get} on wait to be read")
            }
            Self::NotHandedOut { register, buffer, put } => {
                write!(f, "{register}: buffer {buffer} requested, but the put index is {put}")
            }
            Self::IncrementIgnored { register, fill, depth } => {
                write!(f, "{register}: nothing to move over, {fill} of {depth} elements are in use")
            }
            Self::RequestDropped { register, value } => {
                write!(f, "write of {value:#x} to {register} takes the pending request back")
            }
            Self::ResetInUse { register, because } => write!(f, "{register}: reset in use: {because}"),
            Self::ReadUnreliable { register, because } => write!(f, "{register} means nothing: {because}"),
            Self::IllegalModeChange { from, to } => write!(f, "mode {to} cannot be reached from {from}"),
            Self::RequestIgnored { register, buffer, because } => {
                write!(f, "{register}: the request for buffer {buffer} is ignored: {because}")
            }
            Self::PendingBufferModified { buffer, address } => {
                write!(f, "byte {address:#x} of buffer {buffer} was written while its request is pending")
            }
            Self::MessageInvalid { buffer, what } => write!(f, "buffer {buffer}: {what}"),
            Self::NotTakenOver { register, field } => {
                write!(f, "{register}.{field} written again before the value before was taken over")
            }
            Self::InterruptUnheard { register, fields } => {
                write!(f, "{register}: {} enabled, but routed to a disabled line", fields.join(", "))
            }
            Self::NotImplemented { register, write } => {
                write!(f, "{} {register}, which this device does not have", verb(write))
            }
            Self::WriteIgnored { register, field, because } => {
                write!(f, "write to {register}.{field} ignored: {because}")
            }
            Self::InvalidRead { register, because } => write!(f, "read of {register}: {because}"),
            Self::FifoLimit { fifo, full: true } => write!(f, "transmit FIFO {fifo} was advanced although it is full"),
            Self::FifoLimit { fifo, full: false } => write!(f, "receive FIFO {fifo} was advanced although it is empty"),
            Self::AddressNotPhysical { register, address } => {
                write!(f, "{register} holds {address:#x}, which is no physical address")
            }
            Self::BufferNotWritten { fifo, address } => {
                write!(f, "the buffer at {address:#x} goes into FIFO {fifo}, but no message was ever written to it")
            }
            Self::ReceivedMessageModified { fifo, address } => {
                write!(f, "byte {address:#x} of a message waiting in receive FIFO {fifo} was written")
            }
            Self::InterruptStorm { line, entries } => {
                write!(f, "the handler of line {line} ran {entries} times and the line is still active")
            }
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: {}", self.time, self.controller, self.kind)?;
        if !self.section.is_empty() {
            write!(f, " [{}]", self.section)?;
        }
        Ok(())
    }
}

/// What happens to diagnostics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum OnDiagnostic {
    /// They are collected.
    #[default]
    Collect,
    /// The first one panics: a test fails where the mistake is made.
    Panic,
}

/// The diagnostics of a run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Diagnostics {
    pub(crate) policy: OnDiagnostic,
    pub(crate) list: Vec<Diagnostic>,
}

impl Diagnostics {
    pub(crate) fn report(&mut self, diagnostic: Diagnostic) {
        if self.policy == OnDiagnostic::Panic {
            panic!("{diagnostic}");
        }
        self.list.push(diagnostic);
    }
}
