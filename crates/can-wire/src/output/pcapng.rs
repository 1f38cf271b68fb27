//! pcapng with the SocketCAN link type, for Wireshark and tshark.

use std::{borrow::Cow, io, time::Duration};

use can_frame::{CLASSIC_MAX_LEN, Direction, FD_MAX_LEN, Frame};
use pcap_file::{
    DataLink, Endianness, PcapError,
    pcapng::{
        PcapNgWriter,
        blocks::{
            enhanced_packet::{EnhancedPacketBlock, EnhancedPacketOption},
            interface_description::{InterfaceDescriptionBlock, InterfaceDescriptionOption},
        },
    },
};

use super::Tap;
use crate::{Event, Time, TraceSink};

/// Flags of the SocketCAN identifier word, which is big-endian in captures.
const EXTENDED: u32 = 1 << 31;
const REMOTE: u32 = 1 << 30;
/// Flags of an FD frame.
const BRS: u8 = 1;
const ESI: u8 = 2;
const FDF: u8 = 4;
/// Length of the words before the data.
const HEADER: usize = 8;
/// `if_tsresol`: nanoseconds.
const NANOSECONDS: u8 = 9;
/// Direction bits of the packet flags.
const INBOUND: u32 = 1;
const OUTBOUND: u32 = 2;

/// Writes frames as a pcapng capture, their time in nanoseconds counted from the start of the simulation.
pub struct PcapNg<W: io::Write> {
    writer: PcapNgWriter<W>,
    tap: Tap,
    interfaces: usize,
    error: Option<io::Error>,
}

impl<W: io::Write> PcapNg<W> {
    /// Writes the header for what `tap` shows of a wire of `nodes` nodes.
    ///
    /// # Errors
    /// If `output` cannot be written.
    pub fn new(output: W, tap: Tap, nodes: usize) -> io::Result<PcapNg<W>> {
        // The same bytes on every machine.
        let mut writer =
            PcapNgWriter::with_endianness(output, Endianness::Little).map_err(io_error)?;
        let names = tap.interfaces(nodes);
        for name in &names {
            let interface = InterfaceDescriptionBlock {
                linktype: DataLink::CAN_SOCKETCAN,
                snaplen: 0,
                options: vec![
                    InterfaceDescriptionOption::IfName(Cow::Borrowed(name)),
                    InterfaceDescriptionOption::IfTsResol(NANOSECONDS),
                ],
            };
            writer
                .write_pcapng_block(interface.into_owned())
                .map_err(io_error)?;
        }
        Ok(PcapNg {
            writer,
            tap,
            interfaces: names.len(),
            error: None,
        })
    }

    /// Flushes; reports the first error met on the way.
    ///
    /// # Errors
    /// If the output could not be written, now or earlier.
    pub fn finish(&mut self) -> io::Result<()> {
        match self.error.take() {
            Some(error) => Err(error),
            None => self.writer.get_mut().flush(),
        }
    }

    fn packet(
        &mut self,
        time: Time,
        interface: usize,
        frame: &Frame,
        direction: Option<Direction>,
    ) -> io::Result<()> {
        let (bytes, len) = socketcan(frame);
        let flags = direction.map(|direction| match direction {
            Direction::Received => EnhancedPacketOption::Flags(INBOUND),
            Direction::Transmitted => EnhancedPacketOption::Flags(OUTBOUND),
        });
        let block = EnhancedPacketBlock {
            interface_id: interface as u32,
            timestamp: Duration::from_nanos(time.as_ns()),
            original_len: len as u32,
            data: Cow::Borrowed(&bytes[..len]),
            options: flags.into_iter().collect(),
        };
        self.writer.write_pcapng_block(block).map_err(io_error)?;
        Ok(())
    }
}

impl<W: io::Write> TraceSink for PcapNg<W> {
    fn event(&mut self, event: &Event) {
        let Some((interface, frame, direction)) = self.tap.record(event) else {
            return;
        };
        if self.error.is_none() && interface < self.interfaces {
            self.error = self.packet(event.time, interface, &frame, direction).err();
        }
    }

    fn wants_levels(&self) -> bool {
        false
    }
}

/// `struct can_frame` or `struct canfd_frame` as link type 227 has it.
fn socketcan(frame: &Frame) -> ([u8; HEADER + FD_MAX_LEN], usize) {
    let mut bytes = [0; HEADER + FD_MAX_LEN];
    let id = frame.raw_id()
        | if frame.is_extended() { EXTENDED } else { 0 }
        | if frame.is_remote() { REMOTE } else { 0 };
    bytes[..4].copy_from_slice(&id.to_be_bytes());
    bytes[HEADER..HEADER + frame.len()].copy_from_slice(frame.data_bytes());
    if frame.is_fd() {
        bytes[4] = frame.len() as u8;
        bytes[5] = FDF
            | if frame.bit_rate_switch() { BRS } else { 0 }
            | if frame.error_state_indicator() {
                ESI
            } else {
                0
            };
        return (bytes, HEADER + FD_MAX_LEN);
    }
    bytes[4] = frame.dlc().classic_len() as u8;
    if usize::from(frame.dlc().code()) > CLASSIC_MAX_LEN {
        // len8_dlc: the code on the bus.
        bytes[7] = frame.dlc().code();
    }
    (bytes, HEADER + CLASSIC_MAX_LEN)
}

fn io_error(error: PcapError) -> io::Error {
    match error {
        PcapError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
