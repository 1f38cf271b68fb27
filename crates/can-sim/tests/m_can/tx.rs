//! Transmission: sections 2.3.35 to 2.3.47, 2.4.3, 2.4.4, 3.1.3, 3.1.7 and 3.5 of the manual.

use crate::bench::{Can, FD, FRAME, SETUP, Setup, add, add_with, choices, frame};
use can_frame::Frame;
use can_sim::{BusEntry, DiagnosticKind, PeerId, Sim, Time, m_can::RamFailure};
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, Position};
use m_can_pac::registers::{self as pac, Ir};

struct Bench {
    sim: Sim,
    can: Can,
    peer: PeerId,
}

fn bench(setup: &Setup) -> Bench {
    bench_of(add, setup)
}

fn bench_of(add: impl FnOnce(&Sim, &str) -> Can, setup: &Setup) -> Bench {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, setup);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    Bench { sim, can, peer }
}

/// Put index, get index, free level, full.
type FifoState = (u8, u8, u8, bool);

impl Bench {
    fn regs(&self) -> m_can_pac::MCan<can_sim::RegisterBus<'_>> {
        self.can.regs(&self.sim)
    }

    fn sent(&self) -> Vec<String> {
        self.sim.run_for(FRAME * 8);
        self.sim.peer_received(self.peer).iter().map(|(_, frame)| frame.to_string()).collect()
    }

    fn fifo(&self) -> FifoState {
        let status = self.regs().txfqs().read();
        (status.tfqpi(), status.tfgi(), status.tffl(), status.tfqf())
    }

    /// TXBRP, TXBTO, TXBCF, TXBCR.
    fn requests(&self) -> [u32; 4] {
        let r = self.regs();
        [r.txbrp().read().bits(), r.txbto().read().bits(), r.txbcf().read().bits(), r.txbcr().read().bits()]
    }

    /// Runs until the model's frame has started.
    fn started(&self) {
        let acting = |sim: &Sim| self.can.regs(sim).psr().read().act() == m_can_pac::enums::Activity::Transmitter;
        self.sim.run_until(FRAME, acting).unwrap();
    }

    fn spoil_next(&self, field: Field) {
        let fault = Fault::Bit {
            node: self.sim.node(self.can.id),
            fault: BitFault::InvertSeen,
            position: Position::new(field, 0),
            frames: Frames::next(),
        };
        self.sim.with_wire(|wire| wire.inject(fault));
    }
}

/// 2.3.36, 3.5.3: the worked walk: two dedicated buffers and a FIFO of three.
#[test]
fn section_3_5_3_tx_fifo() {
    let b = bench(&SETUP);
    assert_eq!(b.fifo(), (2, 2, 3, false));
    for (buffer, text) in [(2, "300#"), (3, "200#"), (4, "100#")] {
        b.can.write(&b.sim, buffer, &frame(text));
    }
    b.can.request(&b.sim, 0x04);
    assert_eq!(b.fifo(), (3, 2, 2, false));
    b.can.request(&b.sim, 0x18);
    assert_eq!(b.fifo(), (2, 2, 0, true), "by two for two consecutive buffers");
    assert_eq!(b.can.ir(&b.sim) & Ir::TFE, Ir::ZERO);
    b.sim.run_until(FRAME, |_| b.regs().txbto().read().bits() == 4).unwrap();
    assert_eq!(b.fifo(), (2, 3, 1, false));
    assert_eq!(b.sent(), ["300#", "200#", "100#"], "in the order of writing, whatever the identifiers");
    assert_eq!(b.fifo(), (2, 2, 3, false));
    assert_eq!(b.can.ir(&b.sim) & Ir::TFE, Ir::TFE);
    assert_eq!(b.sim.diagnostics(), []);
}

/// 2.3.36: 12 dedicated buffers and a FIFO of 20: put index 15 is the fourth buffer of the FIFO.
#[test]
fn section_2_3_36_put_index_example() {
    let b = bench(&Setup { txbc: 20 << 24 | 12 << 16 | 0x14C0, txesc: 0, ..SETUP });
    for buffer in 12..15 {
        b.can.send(&b.sim, buffer, &frame("123#"));
    }
    assert_eq!(b.fifo().0, 15);
}

/// 3.5.2, 3.5.5: dedicated buffers by identifier, equal ones by number, mixed with the oldest message of the FIFO.
#[test]
fn section_3_5_5_mixed_dedicated_and_fifo() {
    let b = bench(&Setup { txbc: 3 << 24 | 4 << 16 | 0x14C0, ..SETUP });
    let texts = ["222#00", "111#01", "111#02", "7FF#03", "500#04", "001#05", "600#06"];
    for (buffer, text) in texts.iter().enumerate() {
        b.can.write(&b.sim, buffer as u32, &frame(text));
    }
    b.can.request(&b.sim, 0x7F);
    // 001# stands behind 500# in the FIFO and has to wait for it.
    assert_eq!(b.sent(), ["111#01", "111#02", "222#00", "500#04", "001#05", "600#06", "7FF#03"]);
    assert_eq!(b.requests()[..2], [0, 0x7F]);
}

/// 3.5.4, 3.5.6: a queue by identifier; the put index is its lowest free buffer; level and get index read 0.
#[test]
fn section_3_5_4_tx_queue() {
    let b = bench(&Setup { txbc: 1 << 30 | 3 << 24 | 2 << 16 | 0x14C0, ..SETUP });
    assert_eq!(b.fifo(), (2, 0, 0, false));
    for (buffer, text) in [(1, "150#"), (2, "300#"), (3, "200#"), (4, "100#")] {
        b.can.write(&b.sim, buffer, &frame(text));
    }
    b.can.request(&b.sim, 0b1_0110);
    assert_eq!(b.fifo(), (3, 0, 0, false));
    b.can.request(&b.sim, 0b0_1000);
    assert!(b.fifo().3, "full");
    assert_eq!(b.sent(), ["100#", "150#", "200#", "300#"]);
    assert_eq!(b.can.ir(&b.sim) & Ir::TFE, Ir::ZERO, "not with a queue");
}

/// `transmit_priority_order`: as the messages would win arbitration on the bus.
#[test]
fn section_3_5_priority_as_in_arbitration() {
    let b = bench(&Setup { txbc: 6 << 16 | 0x14C0, ..SETUP });
    // Base identifiers 0x100: standard data, standard remote, extended data and remote; then a lower and a higher one.
    let texts = ["04000001#R", "04000001#00", "100#R", "100#00", "04000000#00", "0FF#00"];
    for (buffer, text) in texts.iter().enumerate() {
        b.can.write(&b.sim, buffer as u32, &frame(text));
    }
    b.can.request(&b.sim, 0x3F);
    assert_eq!(b.sent(), ["0FF#00", "100#00", "100#R", "04000000#00", "04000001#00", "04000001#R"]);
}

/// 2.3.39: requests for buffers that are pending or not configured are ignored; a new one clears what the last left.
#[test]
fn section_2_3_39_add_requests() {
    let b = bench(&SETUP);
    b.can.send(&b.sim, 0, &frame("100#"));
    b.can.request(&b.sim, 0b10_0001);
    assert_eq!(b.requests()[0], 1);
    let ignored = b.sim.take_diagnostics();
    assert_eq!(ignored.len(), 2, "{ignored:?}");
    b.sim.run_for(FRAME);
    assert_eq!(b.requests(), [0, 1, 0, 0]);
    b.can.cancel(&b.sim, 1);
    assert_eq!(b.requests(), [0, 1, 1, 0], "2.3.42: without a pending request it is finished at once");
    b.can.request(&b.sim, 1);
    assert_eq!(b.requests(), [1, 0, 0, 0]);
    b.can.configure(&b.sim);
    b.can.request(&b.sim, 1);
    assert_eq!(b.regs().txbar().read().bits(), 0);
    assert!(matches!(b.sim.take_diagnostics()[..], [ref d] if matches!(d.kind, DiagnosticKind::ProtectedWrite { .. })));
}

/// 3.5.7, 2.3.38: cancellation before the start, during success, during failure.
#[test]
fn section_3_5_7_cancellation() {
    let b = bench(&SETUP);
    b.regs().txbcie().write(pac::Txbcie::from_bits(3));
    b.regs().txbtie().write(pac::Txbtie::from_bits(3));
    let flags = |b: &Bench| {
        let flags = b.can.ir(&b.sim) & (Ir::TC | Ir::TCF);
        b.can.clear(&b.sim);
        (flags.contains(Ir::TC), flags.contains(Ir::TCF))
    };
    // Not started: the peer's frame keeps the bus busy.
    b.sim.peer_send(b.peer, frame("001#1122334455667788"));
    b.sim.run_for(Time::from_us(20));
    b.can.send(&b.sim, 0, &frame("100#"));
    b.can.cancel(&b.sim, 1);
    assert_eq!(b.requests(), [0, 0, 1, 0]);
    assert_eq!(flags(&b), (false, true));
    assert_eq!(b.sent(), [""; 0]);
    // On the bus, success: TXBRP and TXBCR stay until the end.
    b.can.send(&b.sim, 0, &frame("100#"));
    b.started();
    b.can.cancel(&b.sim, 1);
    assert_eq!(b.requests(), [1, 0, 0, 1]);
    b.sim.run_for(FRAME);
    assert_eq!(b.requests(), [0, 1, 1, 0]);
    assert_eq!(flags(&b), (true, true));
    // On the bus, failure: not repeated.
    b.spoil_next(Field::Data);
    b.can.send(&b.sim, 1, &frame("200#11"));
    b.started();
    b.can.cancel(&b.sim, 2);
    assert_eq!(b.sent(), ["100#"]);
    assert_eq!(b.requests(), [0, 1, 0b11, 0]);
    assert_eq!(flags(&b), (false, true));
    // Without cancellation a failure is repeated, and success sets TXBTO only.
    b.spoil_next(Field::Data);
    b.can.send(&b.sim, 1, &frame("200#22"));
    assert_eq!(b.sent(), ["100#", "200#22"]);
    assert_eq!(b.requests(), [0, 0b11, 1, 0]);
    assert_eq!(flags(&b), (true, false));
}

/// 3.5.3: cancelling the message at the get index moves it on, cancelling another one does not.
#[test]
fn section_3_5_3_cancelling_in_the_fifo() {
    let b = bench(&SETUP);
    b.sim.peer_send(b.peer, frame("001#1122334455667788"));
    b.sim.run_for(Time::from_us(20));
    for buffer in 2..5 {
        b.can.send(&b.sim, buffer, &frame("100#"));
    }
    b.can.cancel(&b.sim, 1 << 3);
    assert_eq!(b.fifo(), (2, 2, 0, true));
    b.can.cancel(&b.sim, 1 << 2);
    assert_eq!(b.fifo(), (2, 4, 2, false), "over the cancelled one to the next pending one");
    b.can.cancel(&b.sim, 1 << 4);
    assert_eq!(b.fifo(), (2, 2, 3, false));
    assert_eq!(b.can.ir(&b.sim) & Ir::TFE, Ir::TFE);
}

/// 3.1.7.1: DAR: success, success in spite of cancellation, arbitration lost, error; events always with ET = 2.
#[test]
fn section_3_1_7_1_disabled_automatic_retransmission() {
    let b = bench(&Setup { cccr: pac::Cccr::DAR, ..SETUP });
    let event = |b: &Bench| {
        let memory = b.sim.with_memory(b.can.ram, |memory| memory.clone());
        b.sim.inspect(b.can.id, |model| model.tx_events(&memory)).last().map(|event| event.e1.et())
    };
    let send = |buffer: u32, text: &str| {
        b.can.write_with(&b.sim, buffer, &frame(text), |t1| t1.with_efc(true));
        b.can.request(&b.sim, 1 << buffer);
    };
    send(0, "100#");
    b.sim.run_for(FRAME);
    assert_eq!(b.requests(), [0, 1, 0, 0]);
    assert_eq!(event(&b), Some(Ok(m_can_pac::enums::TxEventType::InSpiteOfCancellation)));
    send(0, "101#");
    b.started();
    b.can.cancel(&b.sim, 1);
    b.sim.run_for(FRAME);
    assert_eq!(b.requests(), [0, 1, 1, 0]);
    b.spoil_next(Field::Data);
    send(0, "102#11");
    b.sim.run_for(FRAME * 3);
    assert_eq!(b.requests(), [0, 0, 1, 0], "an error");
    // Both start together when the peer's first frame has ended.
    b.sim.peer_send(b.peer, frame("010#11"));
    b.sim.peer_send(b.peer, frame("011#11"));
    b.sim.run_for(Time::from_us(30));
    send(1, "103#11");
    b.sim.run_for(FRAME * 3);
    assert_eq!(b.requests(), [0, 0, 0b11, 0], "arbitration lost");
    assert!(b.sim.bus_log().iter().any(|entry| matches!(entry, BusEntry::ArbitrationLost { .. })));
    assert_eq!(b.sent(), ["100#", "101#"]);
}

/// 3.1.7: by default a lost arbitration is repeated.
#[test]
fn section_3_1_7_automatic_retransmission() {
    let b = bench(&SETUP);
    b.sim.peer_send(b.peer, frame("010#11"));
    b.sim.peer_send(b.peer, frame("011#11"));
    b.sim.run_for(Time::from_us(30));
    b.can.send(&b.sim, 1, &frame("103#11"));
    assert_eq!(b.sent(), ["103#11"]);
    let order: Vec<String> = b.sim.frames_on_bus().iter().map(|(_, frame)| frame.to_string()).collect();
    assert_eq!(order, ["010#11", "011#11", "103#11"]);
}

/// Table 58, 2.4.3: which frame an element becomes.
#[test]
fn table_58_frame_formats() {
    use pac::Cccr;
    let brse_only = bench(&Setup { cccr: Cccr::BRSE, ..SETUP });
    let fdoe_only = bench(&Setup { cccr: Cccr::FDOE, ..SETUP });
    let both = bench(&Setup { cccr: FD, ..SETUP });
    for (b, sent) in [
        (&brse_only, ["100#11", "101#11", "102#11"]),
        (&fdoe_only, ["100#11", "101##011", "102##011"]),
        (&both, ["100#11", "101##011", "102##111"]),
    ] {
        for (buffer, text) in [(2, "100#11"), (3, "101##011"), (4, "102##111")] {
            b.can.send(&b.sim, buffer, &frame(text));
        }
        assert_eq!(b.sent(), sent);
    }
    // RTR always sends a classic remote frame, and ESI of the element makes the bit recessive.
    let b = &both;
    b.can.write_with(&b.sim, 2, &frame("103#R2"), |t1| t1.with_fdf(m_can_pac::enums::FrameFormat::Fd));
    b.can.request(&b.sim, 4);
    b.can.write(&b.sim, 3, &frame("104##122"));
    b.sim.with_memory(b.can.ram, |memory| memory.words_mut()[(0x14C0 + 3 * 72) / 4] |= 1 << 31);
    b.can.request(&b.sim, 8);
    assert_eq!(b.sent()[3..], ["103#R2", "104##322"]);
}

/// 2.3.37: bytes that the element does not hold are sent as 0xCC.
#[test]
fn section_2_3_37_padding() {
    let b = bench(&Setup { cccr: FD, txesc: 1, ..SETUP });
    b.can.write_with(&b.sim, 2, &frame("123##1000102030405060708090A0B"), |t1| {
        t1.with_dlc(m_can_pac::enums::DataLengthCode::from_bits(11))
    });
    b.can.request(&b.sim, 4);
    assert_eq!(b.sent(), ["123##1000102030405060708090A0BCCCCCCCCCCCCCCCC"]);
}

/// 3.5.8, 2.4.4: Tx events: words, watermark, full, lost, acknowledge.
#[test]
fn section_3_5_8_tx_events() {
    let b = bench(&Setup { cccr: FD, txefc: 2 << 24 | 3 << 16 | 0x1480, ..SETUP });
    let send = |text: &str, marker: u8| {
        b.can.write_with(&b.sim, 0, &frame(text), |t1| t1.with_efc(true).with_mm(marker).with_mm_high(0x77));
        b.can.request(&b.sim, 1);
        b.sim.run_for(FRAME);
        let flags = b.can.ir(&b.sim) & (Ir::TEFN | Ir::TEFW | Ir::TEFF | Ir::TEFL);
        b.can.clear(&b.sim);
        let status = b.regs().txefs().read();
        (flags.bits() >> 12, status.efpi(), status.efgi(), status.effl(), status.eff())
    };
    assert_eq!(send("123#11", 0xA0), (0b0001, 1, 0, 1, false));
    assert_eq!(send("12345678##122", 0xA1), (0b0011, 2, 0, 2, false), "watermark");
    assert_eq!(send("124#R5", 0xA2), (0b0101, 0, 0, 3, true), "full");
    assert_eq!(send("125#", 0xA3), (0b1000, 0, 0, 3, true), "lost");
    let words = b.sim.with_memory(b.can.ram, |memory| memory.words()[0x520..0x526].to_vec());
    assert_eq!(words[0], 0x123 << 18);
    assert_eq!(words[1], 0xA0 << 24 | 1 << 22 | 1 << 16);
    assert_eq!(words[2], 1 << 30 | 0x1234_5678);
    assert_eq!(words[3], 0xA1 << 24 | 1 << 22 | 1 << 21 | 1 << 20 | 1 << 16);
    assert_eq!(words[4], 1 << 29 | 0x124 << 18);
    b.regs().txefa().write(pac::Txefa::RESET.with_efai(1));
    let status = b.regs().txefs().read();
    assert_eq!((status.efgi(), status.effl(), status.eff()), (2, 1, false));
    let none = bench(&Setup { txefc: 0, ..SETUP });
    none.can.write_with(&none.sim, 0, &frame("123#"), |t1| t1.with_efc(true));
    none.can.request(&none.sim, 1);
    none.sim.run_for(FRAME);
    assert_eq!(none.can.ir(&none.sim) & Ir::TEFL, Ir::TEFL, "lost with size zero too");
}

/// 2.4.4: wide message markers take the place of the timestamp.
#[test]
fn section_2_4_4_wide_message_markers() {
    let b = bench(&Setup { cccr: pac::Cccr::WMM, ..SETUP });
    b.can.write_with(&b.sim, 0, &frame("123#"), |t1| t1.with_efc(true).with_mm(0x34).with_mm_high(0x12));
    b.can.request(&b.sim, 1);
    b.sim.run_for(FRAME);
    let e1 = b.sim.with_memory(b.can.ram, |memory| memory.word(0x521).unwrap());
    assert_eq!(e1, 0x34 << 24 | 1 << 22 | 0x12 << 8);
}

/// 3.5.1: transmit pause: two bit times between the own frames, in which another node gets the bus.
#[test]
fn section_3_5_1_transmit_pause() {
    let gap = |cccr: pac::Cccr| {
        let b = bench(&Setup { cccr, ..SETUP });
        b.can.write(&b.sim, 2, &frame("100#"));
        b.can.write(&b.sim, 3, &frame("101#"));
        b.can.request(&b.sim, 0b1100);
        b.sim.run_for(FRAME * 3);
        let times: Vec<(Time, Time)> = b
            .sim
            .bus_log()
            .iter()
            .filter_map(|entry| match entry {
                BusEntry::Frame { start, end, .. } => Some((*start, *end)),
                _ => None,
            })
            .collect();
        times[1].0.since(times[0].1)
    };
    assert_eq!(gap(pac::Cccr::ZERO), Time::from_us(4), "three bits of intermission, then SOF");
    assert_eq!(gap(pac::Cccr::TXP), Time::from_us(6));
    // A message with lower priority gets through.
    let b = bench(&Setup { cccr: pac::Cccr::TXP, ..SETUP });
    b.can.write(&b.sim, 2, &frame("100#"));
    b.can.write(&b.sim, 3, &frame("101#"));
    b.can.request(&b.sim, 0b1100);
    b.sim.run_for(Time::from_us(20));
    b.sim.peer_send(b.peer, frame("7FF#"));
    b.sim.run_for(FRAME * 3);
    let order: Vec<String> = b.sim.frames_on_bus().iter().map(|(_, frame)| frame.to_string()).collect();
    assert_eq!(order, ["100#", "7FF#", "101#"]);
}

/// 2.3.16, 3.1.5: the Tx Handler fails to read the Message RAM: aborted, MRAF, Restricted Operation Mode.
#[test]
fn section_3_1_5_tx_handler_too_late() {
    for survives in [true, false] {
        let add = |sim: &Sim, name: &str| {
            add_with(sim, name, |config| config.with_choices(choices(|c| c.request_survives_ram_failure = survives)))
        };
        let b = bench_of(add, &SETUP);
        b.sim.act(b.can.id, |model, cx| model.fail_ram(cx, RamFailure::TxTooLate));
        b.can.send(&b.sim, 0, &frame("100#11"));
        assert_eq!(b.sent(), [""; 0]);
        assert!(b.can.ir(&b.sim).contains(Ir::MRAF));
        assert!(b.regs().cccr().read().asm_());
        assert_eq!(b.requests()[0], u32::from(survives));
        b.regs().cccr().write(b.regs().cccr().read().with_asm(false));
        let sent: &[&str] = if survives { &["100#11"] } else { &[] };
        assert_eq!(b.sent(), sent);
    }
}

/// 3.5, `pending_buffer_modified`: the first four words are loaded ahead, the rest is read when it is sent.
#[test]
fn section_3_5_changing_a_pending_buffer() {
    let b = bench(&Setup { cccr: FD, ..SETUP });
    b.sim.peer_send(b.peer, frame("001#1122334455667788"));
    b.sim.run_for(Time::from_us(20));
    b.can.send(&b.sim, 0, &frame("123##1000000000000000000000000"));
    b.can.write(&b.sim, 0, &frame("123##1111111111111111111111111"));
    assert_eq!(b.sent(), ["123##1000000000000000011111111"]);
    let kinds: Vec<_> = b.sim.diagnostics().into_iter().map(|d| d.kind).collect();
    assert_eq!(kinds.len(), 5, "{kinds:?}");
    assert_eq!(kinds[0], DiagnosticKind::PendingBufferModified { buffer: 0, address: 0x14C0 });
}

/// `tx_scan_duration`: with a scan that takes time TXBAR shows the requests until it ends.
#[test]
fn section_2_3_39_requests_during_a_scan() {
    let add = |sim: &Sim, name: &str| {
        add_with(sim, name, |config| config.with_choices(choices(|c| c.tx_scan = Time::from_us(2))))
    };
    let b = bench_of(add, &SETUP);
    b.can.write(&b.sim, 0, &frame("200#"));
    b.can.write(&b.sim, 1, &frame("100#"));
    b.can.request(&b.sim, 1);
    b.sim.run_for(Time::from_us(1));
    b.can.request(&b.sim, 2);
    assert_eq!(b.regs().txbar().read().bits(), 2);
    b.sim.run_for(Time::from_us(2));
    assert_eq!(b.regs().txbar().read().bits(), 0);
    assert_eq!(b.sent().len(), 2);
}

/// Tables 54 and 59: every data length code in both formats.
#[test]
fn table_54_and_59_all_lengths() {
    let b = bench(&Setup { cccr: FD, ..SETUP });
    let mut expected = Vec::new();
    for code in 0..16 {
        let dlc = can_frame::Dlc::new(code).unwrap();
        let data: Vec<u8> = (1..=64).collect();
        for format in
            [crate::bench::Format::Data, crate::bench::Format::Fd(crate::bench::FdFlags { brs: true, esi: false })]
        {
            let id = crate::bench::StandardId::new(u16::from(code)).unwrap();
            let frame = Frame::from_fields(id.into(), format, dlc, &data);
            b.can.send(&b.sim, 0, &frame);
            b.sim.run_for(FRAME);
            expected.push(frame);
        }
    }
    let received: Vec<Frame> = b.sim.peer_received(b.peer).into_iter().map(|(_, frame)| frame).collect();
    assert_eq!(received, expected);
}
