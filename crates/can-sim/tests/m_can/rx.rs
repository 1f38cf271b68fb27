//! Reception: sections 2.3.20 to 2.3.34, 2.4.2, 2.4.5, 2.4.6, 3.4 and 3.6 of the manual.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, add_with, frame};
use can_frame::Frame;
use can_sim::{DiagnosticKind, PeerId, Sim};
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

/// An M_CAN with a configuration and filter words, and a node that sends.
fn bench(setup: &Setup, ram: &[(usize, u32)]) -> Bench {
    bench_of(add, setup, ram)
}

fn bench_of(add: impl FnOnce(&Sim, &str) -> Can, setup: &Setup, ram: &[(usize, u32)]) -> Bench {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    can.set_up(&sim, setup);
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
        self.hear_frame(frame(text));
    }

    fn hear_frame(&self, frame: Frame) {
        self.sim.peer_send(self.peer, frame);
        self.sim.run_for(FRAME * 5);
    }

    fn regs(&self) -> m_can_pac::MCan<can_sim::RegisterBus<'_>> {
        self.can.regs(&self.sim)
    }

    /// Where a frame went: FIFO 0, FIFO 1, Rx Buffer, nowhere. Empties it.
    fn goes_to(&self, text: &str) -> String {
        self.hear(text);
        let flags = self.can.ir(&self.sim);
        self.can.clear(&self.sim);
        let mut place = String::new();
        for fifo in 0..2 {
            if let Some(received) = self.can.receive(&self.sim, fifo) {
                assert_eq!(received, frame(text));
                place += ["F0", "F1"][fifo];
            }
        }
        let new = u64::from(self.regs().ndat1().read().bits()) | u64::from(self.regs().ndat2().read().bits()) << 32;
        if flags.contains(Ir::DRX) {
            place += &format!("B{}", 63 - new.leading_zeros());
        }
        if flags.contains(Ir::HPM) {
            place += "!";
        }
        place
    }
}

const fn standard(sft: u32, sfec: u32, id1: u32, id2: u32) -> u32 {
    sft << 30 | sfec << 27 | id1 << 16 | id2
}

/// 2.3.20: after reset everything that matches nothing goes to Rx FIFO 0, remote frames too; with size 0 it is lost.
#[test]
fn section_2_3_20_global_filter_configuration() {
    let b = bench(&SETUP, &[]);
    assert_eq!([b.goes_to("123#11"), b.goes_to("123#R"), b.goes_to("12345678#11")], ["F0", "F0", "F0"]);
    let b = bench(&Setup { rxf0c: 0, ..SETUP }, &[]);
    b.hear("123#11");
    assert_eq!(b.can.ir(&b.sim) & Ir::RF0L, Ir::RF0L);
    assert!(b.regs().rxf0s().read().rf0l());
    // ANFS = 1, ANFE = 2, RRFS = 1: standard to FIFO 1, extended rejected, remote standard rejected.
    let b = bench(&Setup { gfc: 1 << 4 | 2 << 2 | 2, ..SETUP }, &[]);
    assert_eq!([b.goes_to("123#11"), b.goes_to("123#R"), b.goes_to("12345678#11")], ["F1", "", ""]);
    // ANFS = 3, ANFE = 1, RRFE = 1.
    let b = bench(&Setup { gfc: 3 << 4 | 1 << 2 | 1, ..SETUP }, &[]);
    assert_eq!([b.goes_to("123#11"), b.goes_to("12345678#R"), b.goes_to("12345678#11")], ["", "", "F1"]);
}

/// 2.4.5, 3.4.1: every filter type and action for standard identifiers; the first match ends the list.
#[test]
fn section_2_4_5_standard_filters() {
    let reject = 2 << 4 | 2 << 2;
    let b = bench(
        &Setup { sidfc: 8 << 16, gfc: reject, ..SETUP },
        &[
            (0x00, standard(3, 1, 0, 0x7FF)),     // SFT = 3: disabled
            (0x04, standard(0, 0, 0, 0x7FF)),     // SFEC = 0: disabled
            (0x08, standard(0, 1, 0x100, 0x10F)), // range
            (0x0C, standard(1, 2, 0x200, 0x2FF)), // dual
            (0x10, standard(2, 1, 0x300, 0x7F0)), // classic: 0x300..0x30F
            (0x14, standard(0, 3, 0x100, 0x4FF)), // reject
            (0x18, standard(0, 2, 0x400, 0x5FF)), // range behind the rejection
            (0x1C, standard(0, 1, 0x6FF, 0x600)), // inverted range matches nothing
        ],
    );
    for (text, place) in [
        ("100#", "F0"),
        ("10F#", "F0"),
        ("110#", ""),
        ("200#", "F1"),
        ("2FF#", "F1"),
        ("201#", ""),
        ("30A#", "F0"),
        ("310#", ""),
        ("4FF#", ""),
        ("500#", "F1"),
        ("5FF#", "F1"),
        ("600#", ""),
        ("650#", ""),
        ("0FF#", ""),
        ("100#R", "F0"),
    ] {
        assert_eq!(b.goes_to(text), place, "{text}");
    }
}

/// 3.4.1.3: all mask bits one is exact, all zero matches everything.
#[test]
fn section_3_4_1_3_classic_masks() {
    let b = bench(&Setup { sidfc: 1 << 16, gfc: 2 << 4, ..SETUP }, &[(0, standard(2, 1, 0x123, 0x7FF))]);
    assert_eq!([b.goes_to("123#"), b.goes_to("122#")], ["F0", ""]);
    let b = bench(&Setup { sidfc: 1 << 16, gfc: 2 << 4, ..SETUP }, &[(0, standard(2, 1, 0x123, 0))]);
    assert_eq!([b.goes_to("123#"), b.goes_to("7FF#")], ["F0", "F0"]);
}

/// 2.4.6, 3.4.1.1, 3.4.1.5: extended filters; XIDAM masks the received identifier but for EFT = 3, never the filter's,
/// and the stored identifier is unmasked.
#[test]
fn section_2_4_6_extended_filters_and_xidam() {
    let list = [
        (0x20, 1 << 29 | 0x0000_1000),
        (0x24, 0x0000_1FFF), // range, masked
        (0x28, 2 << 29 | 0x0000_2000),
        (0x2C, 1 << 30 | 0x1000_2001), // dual; the second can never match with the mask below
        (0x30, 1 << 29 | 0x0000_3000),
        (0x34, 2 << 30 | 0x0000_F000), // classic
        (0x38, 2 << 29 | 0x1111_0000),
        (0x3C, 3 << 30 | 0x1111_FFFF), // range without the mask
    ];
    let b = bench(&Setup { xidfc: 4 << 16 | 0x20, gfc: 2 << 2, ..SETUP }, &list);
    for (text, place) in [
        ("00001800#", "F0"),
        ("18001800#", ""),
        ("00002000#", "F1"),
        ("10002001#", "F1"),
        ("1FFF3FFF#", "F0"),
        ("11118888#", "F1"),
        ("11108888#", ""),
    ] {
        assert_eq!(b.goes_to(text), place, "{text}");
    }
    let b = bench(&Setup { xidfc: 4 << 16 | 0x20, gfc: 2 << 2, ..SETUP }, &list);
    b.can.configure(&b.sim);
    b.regs().xidam().write(pac::Xidam::RESET.with_eidm(0x0000_FFFF));
    b.can.start(&b.sim);
    for (text, place) in
        [("18001800#", "F0"), ("1AAA2000#", "F1"), ("10002001#", ""), ("11118888#", "F1"), ("11108888#", "")]
    {
        assert_eq!(b.goes_to(text), place, "{text} through XIDAM");
    }
}

/// 2.3.24, 2.4.5: priority elements; HPMS tells list, element, destination and FIFO element.
#[test]
fn section_2_3_24_high_priority_messages() {
    let b = bench(
        &Setup { sidfc: 3 << 16, xidfc: 1 << 16 | 0x20, gfc: 2 << 4 | 2 << 2, ..SETUP },
        &[
            (0x00, standard(1, 4, 0x100, 0x100)),
            (0x04, standard(1, 5, 0x200, 0x200)),
            (0x08, standard(1, 1, 0x300, 0x300)),
            (0x20, 6 << 29 | 0x400),
            (0x24, 1 << 30 | 0x400),
        ],
    );
    let hpms = |b: &Bench| {
        let hpms = b.regs().hpms().read();
        assert!(b.can.ir(&b.sim).contains(Ir::HPM));
        b.can.clear(&b.sim);
        (hpms.flst() as u8, hpms.fidx(), hpms.msi(), hpms.bidx())
    };
    b.hear("100#");
    assert_eq!(hpms(&b), (0, 0, HpmsMsi::None_, 0), "SFEC = 4 stores nothing");
    assert_eq!(b.regs().rxf0s().read().f0fl(), 0);
    b.hear("300#");
    assert!(!b.can.ir(&b.sim).contains(Ir::HPM));
    b.hear("200#");
    assert_eq!(hpms(&b), (0, 1, HpmsMsi::Fifo0, 1));
    b.hear("00000400#");
    assert_eq!(hpms(&b), (1, 0, HpmsMsi::Fifo1, 0));
    b.hear("200#");
    b.hear("200#");
    assert_eq!(hpms(&b), (0, 1, HpmsMsi::MessageLost, 0), "FIFO 0 of 3 is full and blocking");
}

/// 3.4.2.1: the worked walk of a blocking FIFO of 3: indices, level, flags.
#[test]
fn section_3_4_2_1_blocking_fifo() {
    let b = bench(&Setup { rxf0c: 2 << 24 | 3 << 16 | 0x40, ..SETUP }, &[]);
    let state = |b: &Bench| {
        let s = b.regs().rxf0s().read();
        let flags = b.can.ir(&b.sim) & (Ir::RF0N | Ir::RF0W | Ir::RF0F | Ir::RF0L);
        b.can.clear(&b.sim);
        (s.f0pi(), s.f0gi(), s.f0fl(), s.f0f(), s.rf0l(), flags.bits())
    };
    assert_eq!(state(&b), (0, 0, 0, false, false, 0));
    b.hear("001#");
    assert_eq!(state(&b), (1, 0, 1, false, false, 0b0001));
    b.hear("002#");
    assert_eq!(state(&b), (2, 0, 2, false, false, 0b0011), "the watermark of 2 is reached");
    b.hear("003#");
    assert_eq!(state(&b), (0, 0, 3, true, false, 0b0101), "full: PI = GI; the watermark is not reached again");
    b.hear("004#");
    assert_eq!(state(&b), (0, 0, 3, true, true, 0b1000), "lost; the status bit is a copy of the flag");
    assert!(!b.regs().rxf0s().read().rf0l(), "and clears with it");
    let ack = |index| b.regs().rxf0a().write(pac::Rxf0a::RESET.with_f0ai(index));
    ack(0);
    assert_eq!(state(&b), (0, 1, 2, false, false, 0));
    b.hear("005#");
    assert_eq!(state(&b), (1, 1, 3, true, false, 0b0101), "the level was at the watermark, not below it");
    ack(2);
    assert_eq!(state(&b), (1, 0, 1, false, false, 0), "acknowledging the last element wraps; one write releases two");
    assert_eq!(b.can.receive(&b.sim, 0), Some(frame("005#")));
    assert_eq!(b.sim.diagnostics(), []);
}

/// 3.4.2.2: overwrite mode: both indices move on, RFnL stays clear, the FIFO stays full.
#[test]
fn section_3_4_2_2_overwriting_fifo() {
    let b = bench(&Setup { rxf1c: 1 << 31 | 4 << 16 | 0x140, gfc: 1 << 4, ..SETUP }, &[]);
    let state = |b: &Bench| {
        let s = b.regs().rxf1s().read();
        (s.f1pi(), s.f1gi(), s.f1fl(), s.f1f(), s.rf1l())
    };
    for text in ["001#", "002#", "003#", "004#"] {
        b.hear(text);
    }
    assert_eq!(state(&b), (0, 0, 4, true, false));
    b.hear("005#");
    assert_eq!(state(&b), (1, 1, 4, true, false));
    assert!(!b.can.ir(&b.sim).contains(Ir::RF1L));
    let memory = b.sim.with_memory(b.can.ram, |memory| memory.clone());
    let held = b.sim.inspect(b.can.id, |model| model.rx_fifo(&memory, 1));
    let held: Vec<Frame> = held.iter().map(|element| element.frame).collect();
    assert_eq!(held, ["002#", "003#", "004#", "005#"].map(frame));
    // Reading starts behind the Get Index, and the last element read is acknowledged.
    b.regs().rxf1a().write(pac::Rxf1a::RESET.with_f1ai(3));
    assert_eq!(state(&b), (1, 0, 1, false, false));
    assert_eq!(b.can.receive(&b.sim, 1), Some(frame("005#")));
}

/// 3.4.3, Table 56: filter elements 0, 1, 2 store in Rx Buffers 0, 1, 2; a buffer with New Data does not match.
#[test]
fn section_3_4_3_dedicated_rx_buffers() {
    let b = bench(
        &Setup { sidfc: 4 << 16, gfc: 2 << 4, ..SETUP },
        &[
            (0x00, standard(3, 7, 0x101, 0)), // SFT is ignored, even 3
            (0x04, standard(0, 7, 0x102, 1)),
            (0x08, standard(0, 7, 0x103, 63)),
            (0x0C, standard(1, 2, 0x101, 0x102)),
        ],
    );
    assert_eq!([b.goes_to("101#AA"), b.goes_to("102#BB"), b.goes_to("103#CC")], ["B0", "B1", "B63"]);
    assert_eq!((b.regs().ndat1().read().bits(), b.regs().ndat2().read().bits()), (3, 1 << 31));
    assert_eq!(b.can.read_element(&b.sim, 0x280, 63, 7), frame("103#CC"));
    // Locked: filtering goes on, to FIFO 1 for 0x101, to nothing for 0x103.
    assert_eq!([b.goes_to("101#DD"), b.goes_to("103#DD")], ["F1", ""]);
    assert_eq!(b.can.read_element(&b.sim, 0x280, 0, 7), frame("101#AA"));
    b.regs().ndat1().write(pac::Ndat1::from_bits(1));
    assert_eq!(b.goes_to("101#EE"), "B63", "63 is the highest with new data");
    assert_eq!(b.can.read_element(&b.sim, 0x280, 0, 7), frame("101#EE"));
}

/// 3.4.4, Table 57, Figure 10: debug messages into buffers 61, 62, 63.
#[test]
fn section_3_4_4_debug_messages() {
    let b = bench(
        &Setup { sidfc: 3 << 16, gfc: 2 << 4, ..SETUP },
        &[
            (0x00, standard(0, 7, 0x701, 1 << 9 | 0x3D)),
            (0x04, standard(0, 7, 0x702, 2 << 9 | 0x3E)),
            (0x08, standard(0, 7, 0x703, 3 << 9 | 0x3F)),
        ],
    );
    let dms = |text: &str| {
        b.hear(text);
        u32::from(b.regs().rxf1s().read().dms().bits())
    };
    assert_eq!([dms("702#"), dms("703#"), dms("701#01")], [0, 0, 1], "T1");
    assert_eq!([dms("701#02"), dms("703#"), dms("701#03")], [1, 0, 1], "T2, T3");
    assert_eq!([dms("702#03"), dms("702#04")], [2, 0], "T4, then T5 with B");
    assert_eq!([dms("701#05"), dms("702#05"), dms("701#06")], [1, 2, 1], "T5 with A");
    assert!(!b.sim.inspect(b.can.id, |model| model.dma_request()));
    assert_eq!([dms("702#06"), dms("703#06")], [2, 3], "T6");
    assert!(b.sim.inspect(b.can.id, |model| model.dma_request()));
    assert_eq!([dms("701#07"), dms("702#07"), dms("703#07")], [3, 3, 3], "T8");
    let held: Vec<Frame> = (61..64).map(|index| b.can.read_element(&b.sim, 0x280, index, 7)).collect();
    assert_eq!(held, ["701#06", "702#06", "703#06"].map(frame));
    b.sim.act(b.can.id, |model, cx| model.acknowledge_dma(cx));
    assert_eq!(dms("701#08"), 1, "T7, T1");
    let flags = b.can.ir(&b.sim);
    let new = (b.regs().ndat1().read().bits(), b.regs().ndat2().read().bits());
    assert_eq!((flags & Ir::DRX, new), (Ir::ZERO, (0, 0)), "no DRX and no New Data for debug messages");
}

/// 2.4.2, 2.3.34: element words, and what of a longer message is stored.
#[test]
fn section_2_4_2_rx_elements() {
    let b = bench(&Setup { cccr: FD, sidfc: 2 << 16, rxesc: 0x700, ..SETUP }, &[(4, standard(1, 1, 0x456, 0x456))]);
    b.sim.with_memory(b.can.ram, |memory| memory.words_mut()[0x10..0x20].fill(0xEEEE_EEEE));
    b.hear("12345678#R3");
    b.hear("456##3000102030405060708090A0B");
    b.hear("7FF#0102030405");
    let words = b.sim.with_memory(b.can.ram, |memory| memory.words()[0x10..0x1C].to_vec());
    assert_eq!(words[0], 1 << 30 | 1 << 29 | 0x1234_5678, "XTD, RTR");
    assert_eq!(words[1], 1 << 31 | 3 << 16, "ANMF, DLC; RXTS 0");
    assert_eq!(words[2..4], [0xEEEE_EEEE, 0xEEEE_EEEE]);
    assert_eq!(words[4], 1 << 31 | 0x456 << 18, "ESI");
    assert_eq!(words[5], 1 << 24 | 1 << 21 | 1 << 20 | 9 << 16, "FIDX, FDF, BRS, DLC as received");
    assert_eq!(words[6..8], [0x0302_0100, 0x0706_0504], "8 of 12 bytes");
    assert_eq!(words[8..12], [0x7FF << 18, 1 << 31 | 5 << 16, 0x0403_0201, 0x0000_0005]);
}

/// 3.4.1: an error after storing had begun leaves index and flags alone, the element partly overwritten.
#[test]
fn section_3_4_1_errors_while_storing() {
    let b = bench(&SETUP, &[]);
    let node = b.sim.node(b.can.id);
    let fault = Fault::Bit {
        node,
        fault: BitFault::InvertSeen,
        position: Position::new(Field::CrcDelimiter, 0),
        frames: Frames::next(),
    };
    b.sim.with_wire(|wire| wire.inject(fault));
    b.sim.peer_send(b.peer, frame("123#1122334455667788"));
    b.sim.run_until(FRAME, |_| b.can.ir(&b.sim).contains(Ir::PEA)).unwrap();
    assert_eq!(b.regs().rxf0s().read().bits(), 0);
    assert!(!b.can.ir(&b.sim).contains(Ir::RF0N));
    let words = b.sim.with_memory(b.can.ram, |memory| memory.words()[0x10..0x14].to_vec());
    assert_eq!(words[0], 0x123 << 18);
    assert_eq!(words[2..], [0x4433_2211, 0x8877_6655]);
    assert_eq!(b.regs().psr().read().lec().bits(), 2, "form error");
    b.sim.run_for(FRAME);
    assert_eq!(b.can.receive(&b.sim, 0), Some(frame("123#1122334455667788")), "the repetition arrives");
}

/// 2.3.16, 3.6: an acknowledge that names no waiting element moves the Get Index all the same, and is reported.
#[test]
fn section_3_6_invalid_acknowledge() {
    let b = bench(&SETUP, &[]);
    b.hear("001#");
    b.hear("002#");
    b.regs().rxf0a().write(pac::Rxf0a::RESET.with_f0ai(2));
    let status = b.regs().rxf0s().read();
    assert_eq!((status.f0gi(), status.f0fl()), (0, 2));
    let kinds: Vec<DiagnosticKind> = b.sim.take_diagnostics().into_iter().map(|d| d.kind).collect();
    assert_eq!(kinds, [DiagnosticKind::AcknowledgeInvalid { register: "RXF0A", index: 2, get: 0, fill: 2 }]);
}

/// 2.3.16: MRAF for a message that could not be stored in time.
#[test]
fn section_2_3_16_rx_handler_too_late() {
    let b = bench(&SETUP, &[]);
    b.sim.act(b.can.id, |model, cx| model.fail_ram(cx, can_sim::m_can::RamFailure::RxTooLate));
    assert_eq!(b.goes_to("123#"), "");
    assert_eq!(b.goes_to("124#"), "F0", "only the one message is dropped");
}

/// 2.4.2, 3.2.2: with UTSU the element refers to a TSU register; filter event pins and capture pulses.
#[test]
fn section_3_2_2_timestamping_unit() {
    let add = |sim: &Sim, name: &str| {
        add_with(sim, name, |mut config| {
            config.tsu_registers = Some(4);
            config
        })
    };
    let sync = 1 << 15;
    let b = bench_of(
        add,
        &Setup { cccr: pac::Cccr::UTSU, sidfc: 2 << 16, ..SETUP },
        &[(0x00, standard(1, 1, 0x100, 0x100) | sync), (0x04, standard(0, 7, 0x200, 0b101 << 6 | 2))],
    );
    b.hear("300#");
    b.hear("100#");
    b.hear("100#");
    b.hear("200#");
    let r1 = b.sim.with_memory(b.can.ram, |memory| [0x11, 0x23, 0x35].map(|word| memory.word(word).unwrap()));
    assert_eq!(r1, [1 << 31, 1 << 4, 1 << 4 | 1], "no TSC without SSYNC; then TSU registers 0 and 1");
    b.sim.inspect(b.can.id, |model| {
        assert_eq!(model.filter_events(), [1, 0, 1]);
        assert_eq!(model.tsu_pulses(), (2, 0));
        assert_eq!(model.tsu_registers().iter().filter(|captured| captured.is_some()).count(), 2);
    });
}
