//! M_CAN and the dsPIC33 CAN FD module exchange classic and FD frames, filtered by both.

use std::collections::VecDeque;

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_sim::{Sim, Time};
use dspic33_canfd_pac::enums::PayloadSize;
use m_can_pac::registers::{Cccr, Ir};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use regbus::Bus;

use crate::{Inbox, canfd, errors_after_acceptance, m_can, no_exception};

const FRAMES: usize = 10_000;

/// What both let in: standard identifiers below 0x600, and extended ones with bit 0 clear.
fn passes(frame: &Frame) -> bool {
    match frame.id() {
        Id::Standard(id) => id.as_raw() < 0x600,
        Id::Extended(id) => id.as_raw() & 1 == 0,
    }
}

/// Bit 1 of an identifier tells the sender, so that no identifier has two.
fn random_frame(random: &mut ChaCha8Rng, sender: u32) -> Frame {
    let bits = random.next_u32();
    let id = if bits & 1 == 0 {
        Id::Standard(StandardId::new((bits >> 3 & 0x7FD | sender << 1) as u16).unwrap())
    } else {
        Id::Extended(ExtendedId::new(bits >> 3 & 0x1FFF_FFFD | sender << 1).unwrap())
    };
    let mut data = [0; 64];
    random.fill_bytes(&mut data);
    let code = random.next_u32();
    let format = match code >> 8 & 3 {
        0 => Format::Data,
        1 => Format::Remote,
        _ => Format::Fd(FdFlags { brs: code & 0x1000 != 0, esi: false }),
    };
    Frame::from_fields(id, format, Dlc::from_low_bits(code as u8), &data)
}

fn set_up_m_can(sim: &Sim) -> m_can::Can {
    let can = m_can::add(sim, "m_can");
    let setup = m_can::Setup {
        cccr: m_can::FD | Cccr::PXHD,
        sidfc: 1 << 16,
        xidfc: 1 << 16 | 0x020,
        gfc: 0b10_1000,
        txbc: 5 << 24 | 0x14C0,
        ..m_can::SETUP
    };
    can.set_up(sim, &setup);
    let ram = can.memory(sim);
    // Range from 0x000 to 0x5FF into FIFO 0; extended: bit 0 has to be clear, into FIFO 0.
    ram.write(0x00, 1_u32 << 27 | 0x5FF);
    ram.write(0x20, 1_u32 << 29);
    ram.write(0x24, 2_u32 << 30 | 1);
    can.start(sim);
    can
}

/// FIFO 1 sends, FIFO 2 receives.
fn set_up_canfd(sim: &Sim) -> canfd::Can {
    let can = canfd::add(sim, "dspic33_canfd");
    can.configure(sim);
    can.tx_fifo(sim, 1, canfd::TX64);
    can.rx_fifo(sim, 2, 8, PayloadSize::Bytes64);
    // A mask compares bits, so that the range takes two filters: 0xxxxxxxxxx, 10xxxxxxxxx. Bit 30 is EXIDE, MIDE in masks.
    can.filter(sim, 0, 0, 1 << 30 | 0x400, 2);
    can.filter(sim, 1, 0x400, 1 << 30 | 0x600, 2);
    can.filter(sim, 2, 1 << 30, 1 << 30 | 1 << 11, 2);
    no_exception(sim, can);
    can.start(sim);
    can
}

/// How many frames each side rejected, and how many errors M_CAN has told of.
fn exchange(noise: f64) -> ([usize; 2], usize) {
    let sim = Sim::builder().log_limit(1_000_000).build();
    let (a, b) = (set_up_m_can(&sim), set_up_canfd(&sim));
    for (seed, node) in (11..).zip([sim.node(a.id), sim.node(b.id)]) {
        sim.with_wire(|wire| wire.set_noise(node, noise, seed));
    }
    let mut random = [1, 2].map(ChaCha8Rng::seed_from_u64);
    let mut expected = [VecDeque::new(), VecDeque::new()];
    let (mut sent, mut rejected, mut errors) = ([0; 2], [0; 2], 0);
    let mut note = |sender: usize, frame: Frame, expected: &mut [VecDeque<Frame>; 2]| {
        if passes(&frame) {
            expected[1 - sender].push_back(frame);
        } else {
            rejected[1 - sender] += 1;
        }
    };
    let mut inboxes = [Inbox::default(), Inbox::default()];
    let limit = Time::from_ms(20_000);
    while sent != [FRAMES; 2] || expected.iter().any(|frames| !frames.is_empty()) {
        let status = a.regs(&sim).txfqs().read();
        if sent[0] < FRAMES && status.tffl() > 0 {
            let frame = random_frame(&mut random[0], 0);
            a.send(&sim, u32::from(status.tfqpi()), &frame);
            sent[0] += 1;
            note(0, frame, &mut expected);
        }
        if sent[1] < FRAMES && b.status(&sim, 1).tfnrfnif() {
            let frame = random_frame(&mut random[1], 1);
            b.load(&sim, 1, &frame);
            b.request(&sim, 1 << 1);
            sent[1] += 1;
            note(1, frame, &mut expected);
        }
        while let Some(frame) = a.receive(&sim, 0) {
            inboxes[0].take(frame.with_error_state_indicator(false), &mut expected[0]);
        }
        while let Some(frame) = b.receive(&sim, 2) {
            inboxes[1].take(frame.with_error_state_indicator(false), &mut expected[1]);
        }
        let flags = a.ir(&sim);
        assert!(!flags.intersects(Ir::RF0L | Ir::MRAF | Ir::BO), "{flags:?}");
        errors += usize::from(flags.intersects(Ir::PEA | Ir::PED));
        a.regs(&sim).ir().clear(flags);
        assert!(sim.now() < limit, "{}\n{}", sim.describe(a.id), sim.describe(b.id));
        sim.run_for(Time::from_us(40));
    }
    assert!(inboxes[0].twice + inboxes[1].twice <= errors_after_acceptance(&sim));
    assert_eq!(sim.diagnostics(), []);
    (rejected, errors)
}

#[test]
fn nothing_is_lost_duplicated_or_reordered() {
    let (rejected, errors) = exchange(0.0);
    assert!(rejected.iter().all(|count| *count > 2_000), "{rejected:?}");
    assert_eq!(errors, 0);
}

#[test]
fn nothing_is_lost_under_bit_errors() {
    let (_, errors) = exchange(0.000_1);
    assert!(errors > 500, "{errors} errors");
}
