//! Reception at its limits: sizes beyond the largest, watermarks that are off, errors and failures while storing, filters
//! for Rx Buffers and Sync messages with extended identifiers.

use crate::bench::{Can, FRAME, SETUP, Setup, add, add_with, frame};
use can_sim::{PeerId, Sim, m_can::RamFailure};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use m_can_pac::{
    enums::HpmsMsi,
    registers::{self as pac, Ir},
};
use regbus::Bus;

struct Bench {
    sim: Sim,
    can: Can,
    peer: PeerId,
}

fn bench(setup: &Setup, ram: &[(usize, u32)]) -> Bench {
    bench_of(add, setup, ram, |_| {})
}

fn bench_of(
    add: impl FnOnce(&Sim, &str) -> Can,
    setup: &Setup,
    ram: &[(usize, u32)],
    prepare: impl FnOnce(&m_can_pac::MCan<can_sim::RegisterBus<'_>>),
) -> Bench {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, setup);
    prepare(&can.regs(&sim));
    for (offset, word) in ram {
        can.memory(&sim).write(*offset, *word);
    }
    can.start(&sim);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    Bench { sim, can, peer }
}

impl Bench {
    fn hear(&self, text: &str) {
        self.sim.peer_send(self.peer, frame(text));
        self.sim.run_for(FRAME * 2);
    }

    fn regs(&self) -> m_can_pac::MCan<can_sim::RegisterBus<'_>> {
        self.can.regs(&self.sim)
    }

    fn flags(&self) -> Ir {
        let flags = self.can.ir(&self.sim);
        self.can.clear(&self.sim);
        flags
    }

    /// The CRC delimiter of the next frame is seen dominant: everything has been stored by then.
    fn spoil_next(&self) {
        let (node, position) = (self.sim.node(self.can.id), Position::new(Field::CrcDelimiter, 0));
        let frames = Frames::next();
        self.sim.with_wire(|wire| wire.inject(Fault::Bit { node, fault: BitFault::InvertSeen, position, frames }));
    }

    fn words(&self, from: usize, count: usize) -> Vec<u32> {
        self.sim.with_memory(self.can.ram, |memory| memory.words()[from..from + count].to_vec())
    }
}

const fn standard(sft: u32, sfec: u32, id1: u32, id2: u32) -> u32 {
    sft << 30 | sfec << 27 | id1 << 16 | id2
}

/// 2.3.27: more than 64 elements count as 64; a watermark of 64 works, one of 65 is off.
#[test]
fn section_2_3_27_largest_fifo() {
    for (watermark, expected) in [(64, Ir::RF0W), (65, Ir::ZERO), (0, Ir::ZERO)] {
        let b = bench(&Setup { rxf0c: watermark << 24 | 127 << 16 | 0x280, rxbc: 0x1000, rxesc: 0, ..SETUP }, &[]);
        for _ in 0..64 {
            b.hear("123#");
        }
        let status = b.regs().rxf0s().read();
        assert_eq!((status.f0fl(), status.f0f(), status.f0pi()), (64, true, 0));
        assert_eq!(b.flags() & (Ir::RF0W | Ir::RF0L), expected, "watermark {watermark}");
        b.hear("123#");
        assert_eq!(b.flags() & Ir::RF0L, Ir::RF0L);
    }
}

/// 2.3.21, 2.3.22: more than 128 and 64 filter elements count as 128 and 64.
#[test]
fn section_2_3_21_largest_filter_lists() {
    let setup = Setup {
        sidfc: 255 << 16 | 0x2000,
        xidfc: 127 << 16 | 0x2800,
        gfc: 2 << 4 | 2 << 2,
        rxbc: 0x0280,
        txbc: 3 << 24 | 0x1800,
        ..SETUP
    };
    let b = bench(
        &setup,
        &[
            (0x2000 + 127 * 4, standard(1, 1, 0x111, 0x111)),
            (0x2000 + 128 * 4, standard(1, 1, 0x222, 0x222)),
            (0x2800 + 63 * 8, 1 << 29 | 0x333),
            (0x2804 + 63 * 8, 1 << 30 | 0x333),
            (0x2800 + 64 * 8, 1 << 29 | 0x444),
            (0x2804 + 64 * 8, 1 << 30 | 0x444),
        ],
    );
    for text in ["111#", "222#", "00000333#", "00000444#"] {
        b.hear(text);
    }
    assert_eq!(b.can.receive(&b.sim, 0), Some(frame("111#")));
    assert_eq!(b.words(0x10 + 1, 1)[0] >> 24, 127, "FIDX of the last standard element");
    assert_eq!(b.can.receive(&b.sim, 0), Some(frame("00000333#")));
    assert_eq!(b.words(0x10 + 18 + 1, 1)[0] >> 24, 63, "and of the last extended one");
    assert_eq!(b.can.receive(&b.sim, 0), None);
}

/// 3.4.1, 3.4.2.2: a spoilt message in overwrite mode has damaged the oldest element, which is still there to be read.
#[test]
fn section_3_4_2_2_a_spoilt_message_damages_the_oldest() {
    let b = bench(&Setup { rxf0c: 1 << 31 | 2 << 16 | 0x40, rxesc: 0, ..SETUP }, &[]);
    b.hear("001#1111111111111111");
    b.hear("002#2222222222222222");
    b.spoil_next();
    b.sim.peer_send(b.peer, frame("003#3333333333333333"));
    b.sim.run_until(FRAME, |_| b.can.ir(&b.sim).contains(Ir::PEA)).unwrap();
    let status = b.regs().rxf0s().read();
    assert_eq!((status.f0gi(), status.f0pi(), status.f0fl(), status.f0f()), (0, 0, 2, true));
    assert_eq!(b.words(0x10, 1)[0] >> 18, 0x003, "the oldest message is no longer there");
    assert_eq!(b.words(0x12, 2), [0x3333_3333; 2]);
    assert_eq!(b.words(0x14, 1)[0] >> 18, 0x002);
    // A full blocking FIFO takes nothing.
    let b = bench(&Setup { rxf0c: 1 << 16 | 0x40, rxesc: 0, ..SETUP }, &[]);
    b.hear("001#1111111111111111");
    b.spoil_next();
    b.hear("003#3333333333333333");
    assert_eq!(b.words(0x10, 1)[0] >> 18, 0x001);
}

/// 3.4.1, 2.3.16: an error and a failure of the Message RAM both leave New Data flag and IR.DRX alone; the error has
/// overwritten the Rx Buffer.
#[test]
fn section_3_4_1_rx_buffer_that_could_not_be_stored() {
    let b = bench(&Setup { sidfc: 1 << 16, gfc: 2 << 4, ..SETUP }, &[(0, standard(0, 7, 0x101, 0))]);
    b.spoil_next();
    b.sim.peer_send(b.peer, frame("101#55667788"));
    b.sim.run_until(FRAME, |_| b.can.ir(&b.sim).contains(Ir::PEA)).unwrap();
    assert_eq!((b.regs().ndat1().read().bits(), b.flags() & Ir::DRX), (0, Ir::ZERO));
    assert_eq!(b.words(0x280 / 4 + 2, 1), [0x8877_6655]);
    b.sim.run_for(FRAME * 2);
    assert_eq!((b.regs().ndat1().read().bits(), b.flags() & Ir::DRX), (1, Ir::DRX), "the repetition");
    b.regs().ndat1().write(pac::Ndat1::from_bits(1));
    b.sim.act(b.can.id, |model, cx| model.fail_ram(cx, RamFailure::RxTooLate));
    b.hear("101#99");
    assert_eq!((b.regs().ndat1().read().bits(), b.flags() & (Ir::DRX | Ir::MRAF)), (0, Ir::MRAF));
}

/// 2.3.16: MRAF leaves the indices of a FIFO.
#[test]
fn section_2_3_16_failure_leaves_the_fifo() {
    let b = bench(&SETUP, &[]);
    b.sim.act(b.can.id, |model, cx| model.fail_ram(cx, RamFailure::RxTooLate));
    b.hear("123#");
    assert_eq!(b.regs().rxf0s().read().bits(), 0);
    assert_eq!(b.flags() & (Ir::MRAF | Ir::RF0N | Ir::RF0L), Ir::MRAF);
}

/// 2.3.24, 2.4.5, 2.4.6: EFEC = 4 stores nothing; a message without priority leaves HPMS; overwrite mode loses nothing.
#[test]
fn section_2_3_24_what_hpms_keeps() {
    let b = bench(
        &Setup {
            sidfc: 2 << 16,
            xidfc: 2 << 16 | 0x20,
            rxf0c: 1 << 31 | 1 << 16 | 0x40,
            rxf1c: 1 << 16 | 0x140,
            gfc: 2 << 4 | 2 << 2,
            ..SETUP
        },
        &[
            (0x00, standard(1, 5, 0x100, 0x100)),
            (0x04, standard(1, 6, 0x200, 0x200)),
            (0x20, 3 << 29 | 0x3FF),
            (0x24, 1 << 30 | 0x3FF),
            (0x28, 4 << 29 | 0x400),
            (0x2C, 1 << 30 | 0x400),
        ],
    );
    let hpms = |text: &str| {
        b.hear(text);
        let hpms = b.regs().hpms().read();
        (b.flags().contains(Ir::HPM), hpms.flst() as u8, hpms.fidx(), hpms.msi(), hpms.bidx())
    };
    assert_eq!(hpms("00000400#"), (true, 1, 1, HpmsMsi::None_, 0));
    assert_eq!(hpms("000003FF#"), (false, 1, 1, HpmsMsi::None_, 0), "rejected: no change");
    assert_eq!(hpms("100#"), (true, 0, 0, HpmsMsi::Fifo0, 0));
    assert_eq!(hpms("100#"), (true, 0, 0, HpmsMsi::Fifo0, 0), "overwritten, not lost");
    assert_eq!(hpms("200#"), (true, 0, 1, HpmsMsi::Fifo1, 0));
    assert_eq!(hpms("200#"), (true, 0, 1, HpmsMsi::MessageLost, 0));
    assert_eq!(hpms("7FF#"), (false, 0, 1, HpmsMsi::MessageLost, 0), "no match: no change");
}

/// 2.4.6, 3.4.3, 3.4.4: Rx Buffers and debug messages with extended identifiers: exact but for XIDAM, whatever EFT says;
/// filter event pins of debug messages; a locked buffer pulses none.
#[test]
fn section_2_4_6_extended_rx_buffers_and_debug_messages() {
    let b = bench_of(
        add,
        &Setup { xidfc: 4 << 16 | 0x20, gfc: 2 << 2, ..SETUP },
        &[
            (0x20, 7 << 29 | 0x0000_1000),
            (0x24, 2 << 30 | 0b001 << 6 | 5), // EFT = 2 is ignored
            (0x28, 7 << 29 | 0x0000_2001),
            (0x2C, 1 << 9 | 0b010 << 6 | 61),
            (0x30, 7 << 29 | 0x0000_2002),
            (0x34, 2 << 9 | 0b100 << 6 | 62),
            (0x38, 7 << 29 | 0x0000_2003),
            (0x3C, 3 << 9 | 0b111 << 6 | 63),
        ],
        |regs| regs.xidam().write(pac::Xidam::RESET.with_eidm(0x00FF_FFFF)),
    );
    let pulses = || b.sim.inspect(b.can.id, |model| model.filter_events());
    b.hear("1F001000#01");
    assert_eq!((b.regs().ndat1().read().bits(), pulses()), (1 << 5, [1, 0, 0]));
    assert_eq!(b.can.read_element(&b.sim, 0x280, 5, 7), frame("1F001000#01"), "stored as received");
    b.hear("00001000#02");
    assert_eq!(pulses(), [1, 0, 0], "locked: it does not match");
    b.hear("00001001#");
    assert_eq!((b.regs().ndat1().read().bits(), pulses()), (1 << 5, [1, 0, 0]), "EFID2 is no mask");
    for text in ["00002001#01", "00002002#02", "01002003#03"] {
        b.hear(text);
    }
    assert_eq!(pulses(), [2, 2, 2]);
    assert_eq!(b.regs().rxf1s().read().dms().bits(), 3);
    assert_eq!(b.can.read_element(&b.sim, 0x280, 63, 7), frame("01002003#03"));
}

/// 2.4.5, 2.4.6: the pulse for a Sync message comes whether the message is stored or not, and only with CCCR.UTSU.
#[test]
fn section_2_4_5_sync_messages() {
    for utsu in [true, false] {
        let add = |sim: &Sim, name: &str| {
            add_with(sim, name, |mut config| {
                config.tsu_registers = Some(8);
                config
            })
        };
        let cccr = if utsu { pac::Cccr::UTSU } else { pac::Cccr::ZERO };
        let setup = Setup { cccr, sidfc: 1 << 16, xidfc: 1 << 16 | 0x20, rxf0c: 1 << 16 | 0x40, ..SETUP };
        let filters =
            [(0x00, standard(1, 1, 0x100, 0x100) | 1 << 15), (0x20, 1 << 29 | 0x200), (0x24, 3 << 29 | 0x200)];
        let b = bench_of(add, &setup, &filters, |_| {});
        for text in ["100#", "00000200#", "100#", "101#"] {
            b.hear(text);
        }
        assert!(b.flags().contains(Ir::RF0L), "the FIFO of one element is full");
        let pulses = b.sim.inspect(b.can.id, |model| model.tsu_pulses());
        assert_eq!(pulses, (if utsu { 3 } else { 0 }, 0));
    }
}

/// 2.3.7: without a TSU UTSU is fixed to 0.
#[test]
fn section_2_3_7_no_timestamping_unit() {
    let b = bench(&Setup { cccr: pac::Cccr::UTSU, ..SETUP }, &[]);
    assert_eq!(b.regs().cccr().read().bits(), 0);
    b.hear("123#");
    assert_eq!(b.words(0x11, 1)[0] & 1 << 4, 0);
}
