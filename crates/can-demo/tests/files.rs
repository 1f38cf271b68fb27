//! What the demo writes is read back by other people's readers: pcap-file, tshark, the vcd crate, sigrok.
//!
//! tshark and sigrok are Debian packages and have to be installed; a test without its tool fails and names the package.
#![allow(clippy::unwrap_used)]

use std::{fs, path::Path, process::Command};

use can_demo::{Error, Options, Story, files, run, story::Fate};
use can_frame::{Frame, LogLine};
use can_wire::{Level, Signal};
use pcap_file::pcapng::{Block, PcapNgReader};
use tempfile::TempDir;

fn written() -> (TempDir, Story) {
    let folder = TempDir::new().unwrap();
    let story = run(&Options { out: Some(folder.path().join("new/demo")) }).unwrap();
    (folder, story)
}

fn path(story: &Story, name: &str) -> String {
    let path = story.files.iter().find(|path| path.ends_with(name)).unwrap();
    path.to_str().unwrap().to_owned()
}

fn sent(story: &Story) -> Vec<Frame> {
    let sent = story.attempts().into_iter().filter_map(|attempt| match attempt.fate {
        Fate::Sent(frame) => Some(frame),
        _ => None,
    });
    sent.collect()
}

fn output_of(tool: &str, package: &str, arguments: &[&str]) -> String {
    let output = Command::new(tool).args(arguments).output();
    let output = output.unwrap_or_else(|error| {
        panic!("cannot run {tool} ({error}): install the Debian package {package}: apt-get install -y {package}")
    });
    assert!(output.status.success(), "{tool} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Identifier and data as SocketCAN has them.
fn socketcan(packet: &[u8]) -> (u32, Vec<u8>) {
    let id = u32::from_be_bytes(packet[..4].try_into().unwrap()) & 0x1FFF_FFFF;
    (id, packet[8..8 + usize::from(packet[4])].to_vec())
}

#[test]
fn the_capture_holds_every_frame() {
    let (_folder, story) = written();
    let bytes = fs::read(path(&story, files::PCAPNG)).unwrap();
    let mut reader = PcapNgReader::new(&bytes[..]).unwrap();
    let mut packets = Vec::new();
    while let Some(block) = reader.next_block() {
        if let Block::EnhancedPacket(packet) = block.unwrap() {
            packets.push(socketcan(&packet.data));
        }
    }
    let expected: Vec<_> = sent(&story).iter().map(|frame| (frame.raw_id(), frame.data_bytes().to_vec())).collect();
    assert_eq!(packets, expected);
    assert!(expected.len() > 10);
}

#[test]
fn tshark_reads_the_capture() {
    let (_folder, story) = written();
    let path = path(&story, files::PCAPNG);
    let text = output_of("tshark", "tshark", &["-r", &path, "-T", "fields", "-e", "can.id", "-e", "can.len"]);
    let expected: Vec<String> =
        sent(&story).iter().map(|frame| format!("{}\t{}", frame.raw_id(), frame.data_bytes().len())).collect();
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn the_log_holds_every_frame() {
    let (_folder, story) = written();
    let text = fs::read_to_string(path(&story, files::CANDUMP)).unwrap();
    let frames: Vec<Frame> = text.lines().map(|line| LogLine::parse(line).unwrap().frame).collect();
    assert_eq!(frames, sent(&story));
}

#[test]
fn the_value_change_dump_has_every_change_of_every_pin() {
    let (_folder, story) = written();
    let bytes = fs::read(path(&story, files::VCD)).unwrap();
    let mut parser = vcd::Parser::new(&bytes[..]);
    let header = parser.parse_header().unwrap();
    let mut signals = vec![(header.find_var(&["wire", "bus"]).unwrap().code, Signal::Bus)];
    for node in &story.nodes {
        let pin = |pin: &str| header.find_var(&["wire", node.name, &format!("{}_{pin}", node.name)]).unwrap().code;
        signals.extend([(pin("tx"), Signal::Tx(node.id)), (pin("rx"), Signal::Rx(node.id))]);
    }
    let (mut time, mut changes) = (0, Vec::new());
    for command in parser {
        match command.unwrap() {
            vcd::Command::Timestamp(at) => time = at,
            vcd::Command::ChangeScalar(code, value) if time > 0 => {
                let signal = signals.iter().find(|(known, _)| *known == code).unwrap().1;
                let level = if value == vcd::Value::V1 { Level::Recessive } else { Level::Dominant };
                changes.push((time, signal, level));
            }
            _ => {}
        }
    }
    let expected: Vec<_> =
        story.recording.levels().iter().map(|(time, signal, level)| (time.as_ps(), *signal, *level)).collect();
    assert_eq!(changes, expected);
    assert_eq!(time, story.end.as_ps());
}

/// The decoder knows no error frames and may miss the end of an FD frame, so only what comes before is compared: its
/// identifiers and data.
#[test]
fn sigrok_decodes_the_first_frames() {
    let (_folder, story) = written();
    let path = path(&story, files::VCD);
    let decoder = "can:can_rx=bus:nominal_bitrate=500000:fast_bitrate=2000000:sample_point=70";
    let arguments = ["-i", &path, "-I", "vcd:downsample=25000", "-P", decoder, "-A", "can=fields"];
    let text = output_of("sigrok-cli", "sigrok-cli", &arguments);
    let mut frames: Vec<(u32, Vec<u8>)> = Vec::new();
    for line in text.lines() {
        if let Some((_, id)) = line.split_once(" Identifier: ") {
            frames.push((id.split_whitespace().next().unwrap().parse().unwrap(), Vec::new()));
        } else if let Some((_, byte)) = line.split_once("Data byte ") {
            let digits = byte.split_once("0x").unwrap().1;
            frames.last_mut().unwrap().1.push(u8::from_str_radix(digits, 16).unwrap());
        }
    }
    let sent = sent(&story);
    assert!(!sent[0].is_fd() && sent[1].is_fd());
    let expected: Vec<_> = sent[..2].iter().map(|frame| (frame.raw_id(), frame.data_bytes().to_vec())).collect();
    assert_eq!(frames[..2], expected);
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let error = run(&Options { out: Some(file.join("demo")) }).unwrap_err();
    assert!(matches!(&error, Error::File { path, .. } if path == &file.join("demo")));
    assert!(error.to_string().contains("file/demo"), "{error}");
}

#[test]
fn nothing_is_left_beside_the_files() {
    let (_folder, story) = written();
    let folder = story.files[0].parent().unwrap_or(Path::new(""));
    assert_eq!(fs::read_dir(folder).unwrap().count(), story.files.len());
}
