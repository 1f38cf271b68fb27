//! Other people's decoders give back exactly the frames that were sent: sigrok's `can` decoder from the value change
//! dump, tshark from the capture.
//!
//! Both are Debian packages and have to be installed; a test without its tool fails and names the package.
#![allow(clippy::unwrap_used)]

mod common;

use std::{fs::File, io::BufWriter, path::Path, process::Command, sync::Arc, sync::Mutex};

use can_frame::{CLASSIC_MAX_LEN, Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_wire::{
    NodeConfig, NodeId, Time, TraceSink, Wire,
    output::{PcapNg, Tap, Vcd},
};
use common::{Random, bench_of, frames, transmitted};

/// Runs a tool and returns what it prints.
fn output_of(tool: &str, package: &str, arguments: &[&str]) -> String {
    let output = Command::new(tool).args(arguments).output();
    let output = output.unwrap_or_else(|error| {
        panic!("cannot run {tool} ({error}): install the Debian package {package}: apt-get install -y {package}")
    });
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "{tool} {arguments:?} failed: {errors}"
    );
    String::from_utf8(output.stdout).unwrap()
}

/// Sends every frame from alternating nodes, one after the other.
fn send_all(wire: &mut Wire, nodes: &[NodeId], frames: &[Frame]) {
    for (index, frame) in frames.iter().enumerate() {
        let sender = nodes[index % nodes.len()];
        wire.send(sender, *frame).unwrap();
        let events = common::run(wire, Time::from_us(800));
        assert_eq!(transmitted(&events, sender), [*frame], "frame {index}");
    }
}

fn dlc(code: u64) -> Dlc {
    Dlc::new(code as u8).unwrap()
}

/// What sigrok's decoder knows how to read. It takes a remote frame to have data if its length code is not 0, a classic
/// length code above 8 to be an FD length, the CRC of 16 data bytes to be the long one, and it finds the first bit of
/// the data phase only by the edge that a dominant ESI makes.
fn sigrok_frame(random: &mut Random, index: usize) -> Frame {
    let id = frames::any_id(random);
    let data = frames::any_data(random);
    match index % 8 {
        0 => Frame::remote(id, Dlc::ZERO),
        1..=5 => Frame::from_fields(id, Format::Data, dlc(random.below(9)), &data),
        _ => {
            let brs = random.coin();
            let esi = !brs && random.coin();
            let code =
                [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 14, 15][random.below(15) as usize];
            Frame::from_fields(id, Format::Fd(FdFlags { brs, esi }), dlc(code), &data)
        }
    }
}

/// Rebuilds the frames from the annotations of sigrok's decoder, and whether it saw them acknowledged.
fn frames_of_sigrok(text: &str) -> Vec<(Frame, bool)> {
    #[derive(Default)]
    struct Read {
        base: u32,
        full: Option<u32>,
        remote: bool,
        fd: bool,
        brs: bool,
        esi: bool,
        dlc: u8,
        data: Vec<u8>,
        acknowledged: bool,
    }
    let mut frames = Vec::new();
    let mut read = Read::default();
    let number = |text: &str| {
        text.split_whitespace()
            .next()
            .unwrap()
            .parse::<u32>()
            .unwrap()
    };
    for line in text.lines() {
        let line = line.split_once(": ").unwrap().1;
        if line == "Start of frame" {
            read = Read::default();
        } else if let Some(id) = line.strip_prefix("Identifier: ") {
            read.base = number(id);
        } else if let Some(id) = line.strip_prefix("Full Identifier: ") {
            read.full = Some(number(id));
        } else if line == "Remote transmission request: remote frame" {
            read.remote = true;
        } else if line == "Flexible data format: 1" {
            read.fd = true;
        } else if line == "Bit rate switch: 1" {
            read.brs = true;
        } else if line == "Error state indicator: 1" {
            read.esi = true;
        } else if let Some(code) = line.strip_prefix("Data length code: ") {
            read.dlc = number(code) as u8;
        } else if let Some(byte) = line.strip_prefix("Data byte ") {
            let digits = byte.split_once("0x").unwrap().1;
            read.data.push(u8::from_str_radix(digits, 16).unwrap());
        } else if line == "ACK slot: ACK" {
            read.acknowledged = true;
        } else if line == "End of frame" {
            let id = match read.full {
                Some(id) => Id::Extended(ExtendedId::new(id).unwrap()),
                None => Id::Standard(StandardId::new(read.base as u16).unwrap()),
            };
            let format = match (read.fd, read.remote) {
                (true, _) => Format::Fd(FdFlags {
                    brs: read.brs,
                    esi: read.esi,
                }),
                (false, true) => Format::Remote,
                (false, false) => Format::Data,
            };
            let frame = Frame::from_fields(id, format, Dlc::new(read.dlc).unwrap(), &read.data);
            frames.push((frame, read.acknowledged));
        }
    }
    frames
}

#[test]
fn sigrok_decodes_the_value_change_dump() {
    let mut random = Random::new(0x5167);
    let (mut wire, nodes) = bench_of(3, NodeConfig::new().with_data_rate(4_000_000).unwrap());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wire.vcd");
    let vcd = Vcd::new(BufWriter::new(File::create(&path).unwrap()), nodes.len()).unwrap();
    let vcd = Arc::new(Mutex::new(vcd));
    wire.set_trace(Some(Box::new(Arc::clone(&vcd))));
    let sent: Vec<Frame> = (0..2_400)
        .map(|index| sigrok_frame(&mut random, index))
        .collect();
    send_all(&mut wire, &nodes, &sent);
    vcd.lock().unwrap().finish(wire.now()).unwrap();

    // 40 MHz: a sample of sigrok is one clock period of the nodes.
    let decoder = "can:can_rx=bus:nominal_bitrate=1000000:fast_bitrate=4000000:sample_point=70";
    let path = path.to_str().unwrap();
    let arguments = [
        "-i",
        path,
        "-I",
        "vcd:downsample=25000",
        "-P",
        decoder,
        "-A",
        "can=fields",
    ];
    let text = output_of("sigrok-cli", "sigrok-cli", &arguments);
    let decoded = frames_of_sigrok(&text);
    for (index, ((decoded, acknowledged), sent)) in decoded.iter().zip(&sent).enumerate() {
        assert_eq!(decoded, sent, "frame {index}");
        // In an FD frame the decoder may take a fixed stuff bit for a dynamic one and be a bit late from then on.
        assert!(
            *acknowledged || sent.is_fd(),
            "frame {index} is acknowledged"
        );
    }
    assert_eq!(decoded.len(), sent.len());
}

/// Reads back one line of tshark's fields.
fn frame_of_tshark(line: &str) -> Frame {
    let columns: Vec<&str> = line.split('\t').collect();
    let [id, extended, remote, len, brs, esi, reserved, data] = columns[..] else {
        panic!("eight columns expected: {line}")
    };
    let id: u32 = id.parse().unwrap();
    let id = match extended {
        "1" => Id::Extended(ExtendedId::new(id).unwrap()),
        _ => Id::Standard(StandardId::new(id as u16).unwrap()),
    };
    let format = match (brs, remote) {
        ("", "1") => Format::Remote,
        ("", _) => Format::Data,
        _ => Format::Fd(FdFlags {
            brs: brs == "1",
            esi: esi == "1",
        }),
    };
    let hex = data.replace(':', "");
    let bytes: Vec<u8> = (0..hex.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(&hex[at..at + 2], 16).unwrap())
        .collect();
    let len: usize = len.parse().unwrap();
    let code = match format {
        // The last of the reserved bytes is len8_dlc.
        Format::Data | Format::Remote if len == CLASSIC_MAX_LEN => {
            let hex = reserved.replace(':', "");
            match u8::from_str_radix(&hex[hex.len() - 2..], 16).unwrap() {
                0 => Dlc::exact(len),
                raw => Dlc::new(raw),
            }
        }
        _ => Dlc::exact(len),
    };
    Frame::from_fields(id, format, code.unwrap(), &bytes)
}

fn tshark(path: &Path) -> Vec<Frame> {
    let fields = [
        "can.id",
        "can.flags.xtd",
        "can.flags.rtr",
        "can.len",
        "canfd.flags.brs",
        "canfd.flags.esi",
        "can.reserved",
        "data.data",
    ];
    // Guesses at higher layers would take the data away from the field `data.data`.
    let mut arguments = vec![
        "-r",
        path.to_str().unwrap(),
        "--disable-protocol",
        "autosar-nm",
        "--disable-protocol",
        "signal_pdu",
        "--disable-protocol",
        "ipdum",
        "-T",
        "fields",
    ];
    arguments.extend(fields.iter().flat_map(|field| ["-e", field]));
    let text = output_of("tshark", "tshark", &arguments);
    text.lines().map(frame_of_tshark).collect()
}

#[test]
fn tshark_reads_the_capture() {
    let mut random = Random::new(0x7541);
    let (mut wire, nodes) = bench_of(2, NodeConfig::new());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wire.pcapng");
    let capture = BufWriter::new(File::create(&path).unwrap());
    let capture = Arc::new(Mutex::new(
        PcapNg::new(capture, Tap::Bus, nodes.len()).unwrap(),
    ));
    wire.set_trace(Some(Box::new(Arc::clone(&capture))));
    let sent: Vec<Frame> = (0..3_000).map(|_| frames::any_frame(&mut random)).collect();
    send_all(&mut wire, &nodes, &sent);
    capture.lock().unwrap().finish().unwrap();
    let decoded = tshark(&path);
    for (index, (decoded, sent)) in decoded.iter().zip(&sent).enumerate() {
        assert_eq!(decoded, sent, "frame {index}");
    }
    assert_eq!(decoded.len(), sent.len());
}

/// As a host sees it: one interface per node, packets inbound or outbound.
#[test]
fn tshark_sees_every_node_as_an_interface() {
    let (mut wire, nodes) = bench_of(3, NodeConfig::new());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nodes.pcapng");
    let sinks: Vec<Box<dyn TraceSink + Send>> = vec![Box::new(
        PcapNg::new(File::create(&path).unwrap(), Tap::EachNode, nodes.len()).unwrap(),
    )];
    wire.set_trace(Some(Box::new(sinks)));
    send_all(&mut wire, &nodes, &[common::frame("123#11")]);
    wire.set_trace(None);
    let arguments = [
        "-r",
        path.to_str().unwrap(),
        "-T",
        "fields",
        "-e",
        "frame.interface_name",
        "-e",
        "frame.packet_flags_direction",
    ];
    let text = output_of("tshark", "tshark", &arguments);
    let mut lines: Vec<(&str, u32)> = text
        .lines()
        .map(|line| line.split_once('\t').unwrap())
        .map(|(name, direction)| {
            (
                name,
                u32::from_str_radix(direction.trim_start_matches("0x"), 16).unwrap(),
            )
        })
        .collect();
    lines.sort_unstable();
    assert_eq!(lines, [("can0", 2), ("can1", 1), ("can2", 1)]);
}
