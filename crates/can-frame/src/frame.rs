//! The frame itself.

use core::{fmt, hash};

use embedded_can::Id;

use crate::{CLASSIC_MAX_LEN, Dlc, FD_MAX_LEN, FrameError};

/// The two flags of an FD frame's control field (ISO 11898-1:2015, 10.4.2.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct FdFlags {
    /// Bit-rate switch: the data phase runs at the data bit rate.
    pub brs: bool,
    /// Error state indicator: the transmitter was error passive.
    pub esi: bool,
}

/// What kind of frame it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Classic data frame.
    Data,
    /// Classic remote frame: a data length code, no data.
    Remote,
    /// FD data frame.
    Fd(FdFlags),
}

/// A CAN or CAN FD frame as the data link layer hands it over: identifier, format, data length code, data.
#[derive(Clone, Copy)]
pub struct Frame {
    id: Id,
    format: Format,
    dlc: Dlc,
    /// Only ever set in an FD frame.
    rrs: bool,
    // Bytes past the length stay zero, so that comparing and hashing could read them all.
    bytes: [u8; FD_MAX_LEN],
}

impl Frame {
    /// A classic data frame.
    ///
    /// # Errors
    /// [`FrameError::TooLong`] above 8 bytes.
    pub fn data(id: impl Into<Id>, data: &[u8]) -> Result<Frame, FrameError> {
        let dlc = match Dlc::exact(data.len()) {
            Some(dlc) if data.len() <= CLASSIC_MAX_LEN => dlc,
            _ => {
                return Err(FrameError::TooLong { len: data.len(), max: CLASSIC_MAX_LEN });
            }
        };
        Ok(Frame::filled(id.into(), Format::Data, dlc, data))
    }

    /// A classic data frame with a data length code of the caller's choice: with 8 bytes the codes 8 to 15 are legal.
    ///
    /// # Errors
    /// [`FrameError::DlcMismatch`] if the code does not stand for the number of bytes.
    pub fn data_with_dlc(id: impl Into<Id>, dlc: Dlc, data: &[u8]) -> Result<Frame, FrameError> {
        if dlc.classic_len() != data.len() {
            return Err(FrameError::DlcMismatch { code: dlc.code(), len: data.len(), expected: dlc.classic_len() });
        }
        Ok(Frame::filled(id.into(), Format::Data, dlc, data))
    }

    /// A classic remote frame. The data length code is that of the requested data frame; the codes 9 to 15 are legal.
    #[must_use]
    pub fn remote(id: impl Into<Id>, dlc: Dlc) -> Frame {
        Frame::filled(id.into(), Format::Remote, dlc, &[])
    }

    /// An FD frame whose data has exactly a length that a code stands for.
    ///
    /// # Errors
    /// [`FrameError::TooLong`] above 64 bytes, [`FrameError::NotAnFdLength`] for a length without a code.
    pub fn fd(id: impl Into<Id>, data: &[u8], flags: FdFlags) -> Result<Frame, FrameError> {
        let dlc = fd_dlc(data.len())?;
        if dlc.fd_len() != data.len() {
            return Err(FrameError::NotAnFdLength { len: data.len(), next: dlc.fd_len() });
        }
        Ok(Frame::filled(id.into(), Format::Fd(flags), dlc, data))
    }

    /// An FD frame whose data is padded with `pad` up to the next length that a code stands for.
    ///
    /// # Errors
    /// [`FrameError::TooLong`] above 64 bytes.
    pub fn fd_padded(id: impl Into<Id>, data: &[u8], pad: u8, flags: FdFlags) -> Result<Frame, FrameError> {
        let dlc = fd_dlc(data.len())?;
        let mut frame = Frame::filled(id.into(), Format::Fd(flags), dlc, data);
        frame.bytes[data.len()..dlc.fd_len()].fill(pad);
        Ok(frame)
    }

    /// A frame from the fields a receiver has decoded. Bytes beyond the length of the code are ignored, missing ones
    /// are zero; this is what a bus analyser or a message memory holds.
    #[must_use]
    pub fn from_fields(id: Id, format: Format, dlc: Dlc, data: &[u8]) -> Frame {
        let len = match format {
            Format::Data => dlc.classic_len(),
            Format::Remote => 0,
            Format::Fd(_) => dlc.fd_len(),
        };
        Frame::filled(id, format, dlc, &data[..data.len().min(len)])
    }

    /// A frame whose data bytes `read` fetches: it gets exactly as many as format and data length code stand for, all
    /// zero. This is how a driver takes a frame out of message memory without copying it twice.
    #[inline]
    #[must_use]
    pub fn read_with(id: Id, format: Format, dlc: Dlc, read: impl FnOnce(&mut [u8])) -> Frame {
        let mut frame = Frame { id, format, dlc, rrs: false, bytes: [0; FD_MAX_LEN] };
        let len = frame.len();
        // Always there; asked for in a way that cannot panic.
        if let Some(data) = frame.bytes.get_mut(..len) {
            read(data);
        }
        frame
    }

    fn filled(id: Id, format: Format, dlc: Dlc, data: &[u8]) -> Frame {
        let mut bytes = [0; FD_MAX_LEN];
        bytes[..data.len()].copy_from_slice(data);
        Frame { id, format, dlc, rrs: false, bytes }
    }

    /// The identifier, 11 or 29 bits.
    #[must_use]
    pub const fn id(&self) -> Id {
        self.id
    }

    /// Data, remote or FD, with the FD flags.
    #[must_use]
    pub const fn format(&self) -> Format {
        self.format
    }

    /// The data length code as transmitted.
    #[must_use]
    pub const fn dlc(&self) -> Dlc {
        self.dlc
    }

    /// The data bytes; none for a remote frame.
    #[inline]
    #[must_use]
    pub fn data_bytes(&self) -> &[u8] {
        // Always there; asked for in a way that cannot panic.
        self.bytes.get(..self.len()).unwrap_or(&self.bytes)
    }

    /// Number of data bytes: 0 to 8, or 0 to 64 for an FD frame; 0 for a remote frame.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self.format {
            Format::Data => self.dlc.classic_len(),
            Format::Remote => 0,
            Format::Fd(_) => self.dlc.fd_len(),
        }
    }

    /// True if there are no data bytes.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// True for a 29-bit identifier.
    #[must_use]
    pub const fn is_extended(&self) -> bool {
        matches!(self.id, Id::Extended(_))
    }

    /// True for a remote frame.
    #[must_use]
    pub const fn is_remote(&self) -> bool {
        matches!(self.format, Format::Remote)
    }

    /// True for an FD frame.
    #[must_use]
    pub const fn is_fd(&self) -> bool {
        matches!(self.format, Format::Fd(_))
    }

    /// True for an FD frame that switches to the data bit rate.
    #[must_use]
    pub const fn bit_rate_switch(&self) -> bool {
        matches!(self.format, Format::Fd(FdFlags { brs: true, .. }))
    }

    /// True for an FD frame whose error state indicator is recessive: its transmitter was error passive.
    #[must_use]
    pub const fn error_state_indicator(&self) -> bool {
        matches!(self.format, Format::Fd(FdFlags { esi: true, .. }))
    }

    /// The same frame with the error state indicator set or cleared; other than FD frames are returned unchanged.
    #[must_use]
    pub const fn with_error_state_indicator(mut self, esi: bool) -> Frame {
        if let Format::Fd(flags) = self.format {
            self.format = Format::Fd(FdFlags { brs: flags.brs, esi });
        }
        self
    }

    /// True for an FD frame whose remote request substitution bit is recessive. ISO 11898-1 sends it dominant; some
    /// controllers use it as the least significant bit of a 12-bit identifier.
    #[must_use]
    pub const fn remote_request_substitution(&self) -> bool {
        self.rrs
    }

    /// The same frame with the remote request substitution bit set or cleared; other than FD frames are returned
    /// unchanged.
    #[must_use]
    pub const fn with_remote_request_substitution(mut self, rrs: bool) -> Frame {
        self.rrs = rrs && self.is_fd();
        self
    }

    /// The identifier as a number, without the information whether it has 11 or 29 bits.
    #[must_use]
    pub fn raw_id(&self) -> u32 {
        match self.id {
            Id::Standard(id) => u32::from(id.as_raw()),
            Id::Extended(id) => id.as_raw(),
        }
    }
}

fn fd_dlc(len: usize) -> Result<Dlc, FrameError> {
    Dlc::fitting(len).ok_or(FrameError::TooLong { len, max: FD_MAX_LEN })
}

impl PartialEq for Frame {
    fn eq(&self, other: &Frame) -> bool {
        self.id == other.id
            && self.format == other.format
            && self.dlc == other.dlc
            && self.rrs == other.rrs
            && self.data_bytes() == other.data_bytes()
    }
}

impl Eq for Frame {}

impl hash::Hash for Frame {
    fn hash<H: hash::Hasher>(&self, state: &mut H) {
        self.id.hash(state);
        self.format.hash(state);
        self.dlc.hash(state);
        self.rrs.hash(state);
        self.data_bytes().hash(state);
    }
}

impl fmt::Debug for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Frame({self})")
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Frame {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}", defmt::Display2Format(self));
    }
}

/// The classic part of a frame for drivers written against `embedded-can`, which knows no FD frames: `new` and
/// `new_remote` make classic frames, the accessors work for all.
impl embedded_can::Frame for Frame {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Frame::data(id, data).ok()
    }

    fn new_remote(id: impl Into<Id>, dlc: usize) -> Option<Self> {
        Some(Frame::remote(id, Dlc::exact(dlc).filter(|dlc| dlc.fd_len() <= CLASSIC_MAX_LEN)?))
    }

    fn is_extended(&self) -> bool {
        Frame::is_extended(self)
    }

    fn is_remote_frame(&self) -> bool {
        self.is_remote()
    }

    fn id(&self) -> Id {
        self.id
    }

    /// For a remote frame the requested length, else the number of data bytes, as `embedded-can` wants it.
    fn dlc(&self) -> usize {
        match self.format {
            Format::Data | Format::Remote => self.dlc.classic_len(),
            Format::Fd(_) => self.dlc.fd_len(),
        }
    }

    fn data(&self) -> &[u8] {
        self.data_bytes()
    }
}
