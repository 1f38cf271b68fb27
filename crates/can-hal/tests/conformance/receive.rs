//! Receiving.

use can_hal::{Configured, Dlc, Frame, Receive, StandardId};
use can_sim::Sim;

use crate::bench::{Bench, FRAME, Setup, drain, peer, start};

pub fn capabilities_are_as_stated<B: Bench>() {
    assert_eq!(<B::Can<'static> as Configured>::CAPABILITIES, B::EXPECTED);
}

fn numbered(number: usize) -> Frame {
    Frame::data(StandardId::new(0x100).unwrap(), &[number as u8]).unwrap()
}

pub fn a_full_fifo_loses_the_newest_and_says_so<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup::CLASSIC);
    for round in 0..2 {
        for number in 0..B::RX_DEPTH + 2 {
            sim.peer_send(other, numbered(number));
        }
        sim.run_for(FRAME * (B::RX_DEPTH as u64 + 2));
        let (mut frames, mut overflows) = (Vec::new(), 0);
        loop {
            match can.fetch() {
                Ok(Some(message)) => frames.push(message.frame),
                Ok(None) => break,
                Err(_) => overflows += 1,
            }
        }
        let kept: Vec<Frame> = (0..B::RX_DEPTH).map(numbered).collect();
        assert_eq!(frames, kept, "round {round}");
        assert_eq!(overflows, usize::from(!B::EXPECTED.loses_silently), "round {round}");
    }
    assert_eq!(sim.diagnostics(), []);
}

pub fn a_fifo_can_overwrite_the_oldest<B: Bench>() {
    if !B::EXPECTED.overwrite {
        return capabilities_are_as_stated::<B>();
    }
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let mut can = start(bench, &sim, &Setup { overwrite: true, ..Setup::CLASSIC });
    let count = B::RX_DEPTH + 2;
    for number in 0..count {
        sim.peer_send(other, numbered(number));
    }
    sim.run_for(FRAME * count as u64);
    let frames: Vec<Frame> = drain(&mut can).iter().map(|message| message.frame).collect();
    let newest: Vec<Frame> = (0..count).map(numbered).collect();
    // The oldest one of a full FIFO may be left out, as it could be overwritten while it is read.
    assert!(frames.len() + 1 >= B::RX_DEPTH, "{frames:?}");
    assert_eq!(frames, newest[count - frames.len()..]);
}

pub fn every_length<B: Bench>() {
    let sim = Sim::new();
    let bench = B::add(&sim, "can0");
    let other = peer(&sim);
    let fd = B::EXPECTED.fd;
    let mut can = start(bench, &sim, &Setup { fd, ..Setup::CLASSIC });
    let id = StandardId::new(0x55).unwrap();
    let bytes: Vec<u8> = (1..=64).collect();
    let mut frames: Vec<Frame> = (0..=8).map(|len| Frame::data(id, &bytes[..len]).unwrap()).collect();
    // A classic frame may carry a data length code above 8.
    frames.extend((9..=15).map(|code| Frame::data_with_dlc(id, Dlc::new(code).unwrap(), &bytes[..8]).unwrap()));
    if fd {
        let flags = can_hal::FdFlags { brs: true, esi: false };
        frames.extend(can_frame::FD_LENGTHS.map(|len| Frame::fd(id, &bytes[..usize::from(len)], flags).unwrap()));
    }
    for frame in frames {
        sim.peer_send(other, frame);
        sim.run_for(FRAME);
        let message = can.fetch().unwrap().unwrap();
        assert_eq!(message.frame, frame);
    }
    assert_eq!(sim.diagnostics(), []);
}
