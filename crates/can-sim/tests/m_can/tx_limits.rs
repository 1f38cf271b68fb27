//! Transmission at its limits: too many buffers, equal identifiers, cancellation and requests while a Tx scan runs, Tx
//! events with a timestamping unit, the transmit pause.

use crate::bench::{Can, FRAME, SETUP, Setup, add, add_with, choices, frame};
use can_sim::{BusEntry, DiagnosticKind, PeerId, Sim, Time};
use can_wire::NodeConfig;
use m_can_pac::registers::{self as pac, Ir};
use regbus::Bus;

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

impl Bench {
    fn regs(&self) -> m_can_pac::MCan<can_sim::RegisterBus<'_>> {
        self.can.regs(&self.sim)
    }

    fn sent(&self) -> Vec<String> {
        self.sim.run_for(FRAME * 8);
        self.sim.peer_received(self.peer).iter().map(|(_, frame)| frame.to_string()).collect()
    }

    /// TXBRP, TXBTO, TXBCF, TXBCR.
    fn requests(&self) -> [u32; 4] {
        let r = self.regs();
        [r.txbrp().read().bits(), r.txbto().read().bits(), r.txbcf().read().bits(), r.txbcr().read().bits()]
    }

    /// The peer's frame keeps the bus busy.
    fn busy(&self) {
        self.sim.peer_send(self.peer, frame("001#1122334455667788"));
        self.sim.run_for(Time::from_us(20));
    }
}

/// `queue_equal_identifiers`: of equal identifiers in a queue the one in the lowest buffer is sent first, whenever it was
/// written.
#[test]
fn section_3_5_4_equal_identifiers_in_a_queue() {
    let b = bench(&Setup { txbc: 1 << 30 | 4 << 24 | 0x14C0, ..SETUP });
    b.busy();
    for (buffer, text) in [(3, "100#03"), (1, "100#01"), (2, "100#02"), (0, "200#00")] {
        b.can.send(&b.sim, buffer, &frame(text));
    }
    assert_eq!(b.sent(), ["100#01", "100#02", "100#03", "200#00"]);
}

/// 3.5.6: dedicated buffers and a queue compete alike, on equal identifiers by number.
#[test]
fn section_3_5_6_mixed_dedicated_and_queue() {
    let b = bench(&Setup { txbc: 1 << 30 | 3 << 24 | 2 << 16 | 0x14C0, ..SETUP });
    for (buffer, text) in ["300#00", "200#01", "400#02", "200#03", "100#04"].iter().enumerate() {
        b.can.write(&b.sim, buffer as u32, &frame(text));
    }
    b.can.request(&b.sim, 0x1F);
    assert_eq!(b.sent(), ["100#04", "200#01", "200#03", "300#00", "400#02"]);
}

/// 3.5: a message with a better identifier overtakes one that waits for the bus.
#[test]
fn section_3_5_a_later_request_overtakes() {
    let b = bench(&SETUP);
    b.busy();
    b.can.send(&b.sim, 0, &frame("300#"));
    b.can.send(&b.sim, 1, &frame("200#"));
    b.can.send(&b.sim, 2, &frame("100#"));
    assert_eq!(b.sent(), ["100#", "200#", "300#"]);
}

/// 2.3.39, 2.3.40: requests and cancellations of buffers that TXBC does not configure leave no trace.
#[test]
fn section_2_3_40_buffers_that_do_not_exist() {
    let b = bench(&SETUP);
    b.can.cancel(&b.sim, !0b1_1111);
    b.can.request(&b.sim, !0b1_1111);
    assert_eq!(b.sent(), [""; 0]);
    assert_eq!((b.requests(), b.regs().txbar().read().bits()), ([0; 4], 0));
    assert_eq!(b.sim.diagnostics().len(), 2 * 27);
}

/// 2.3.35: more than 32 count as 32; `too_many_tx_buffers`: what is beyond buffer 31 does not exist.
#[test]
fn section_2_3_35_too_many_buffers() {
    for (ndtb, tfqs, put, free) in [(0, 63, 0, 32), (63, 0, 0, 0), (20, 20, 20, 12), (40, 40, 0, 0)] {
        let b = bench(&Setup { txbc: tfqs << 24 | ndtb << 16 | 0x14C0, txesc: 0, ..SETUP });
        let status = b.regs().txfqs().read();
        assert_eq!((status.tfqpi(), status.tffl()), (put, free), "NDTB {ndtb}, TFQS {tfqs}");
        let contradicts = |d: &can_sim::Diagnostic| matches!(d.kind, DiagnosticKind::Contradiction { .. });
        let reported = b.sim.diagnostics().iter().any(contradicts);
        assert_eq!(reported, ndtb.min(32) + tfqs.min(32) > 32, "NDTB {ndtb}, TFQS {tfqs}");
    }
}

fn slow_scan(sim: &Sim, name: &str) -> Can {
    add_with(sim, name, |config| config.with_choices(choices(|c| c.tx_scan = Time::from_us(20))))
}

/// 2.3.38: a request that comes while a Tx scan is running is not considered by it; its cancellation is done at once.
#[test]
fn section_2_3_38_requests_while_a_scan_runs() {
    let b = bench_of(slow_scan, &SETUP);
    b.can.write(&b.sim, 0, &frame("300#"));
    b.can.write(&b.sim, 1, &frame("100#"));
    b.can.request(&b.sim, 1);
    b.sim.run_for(Time::from_us(5));
    b.can.request(&b.sim, 2);
    assert_eq!(b.sent(), ["300#", "100#"], "although 100# would win");
    let b = bench_of(slow_scan, &SETUP);
    b.can.write(&b.sim, 0, &frame("300#"));
    b.can.request(&b.sim, 1);
    b.sim.run_for(Time::from_us(5));
    b.can.request(&b.sim, 2);
    b.sim.run_for(Time::from_us(1));
    b.can.cancel(&b.sim, 2);
    b.sim.run_for(Time::from_us(1));
    assert_eq!(b.requests(), [1, 0, 2, 0], "cancelled at once");
    assert_eq!(b.sent(), ["300#"]);
}

/// 3.1.7.1: DAR, cancelled before the transmission has started: TXBCF alone, no event.
#[test]
fn section_3_1_7_1_cancelled_before_the_start() {
    let b = bench(&Setup { cccr: pac::Cccr::DAR, ..SETUP });
    b.busy();
    b.can.write_with(&b.sim, 0, &frame("100#"), |t1| t1.with_efc(true));
    b.can.request(&b.sim, 1);
    b.can.cancel(&b.sim, 1);
    assert_eq!((b.sent(), b.requests()), (vec![], [0, 0, 1, 0]));
    assert_eq!(b.regs().txefs().read().bits(), 0);
}

/// 2.4.4: ET tells a transmission in spite of cancellation from one that nobody cancelled.
#[test]
fn section_2_4_4_event_types() {
    let b = bench(&SETUP);
    for (element, cancelled) in [false, true].into_iter().enumerate() {
        b.can.write_with(&b.sim, 0, &frame("100#"), |t1| t1.with_efc(true));
        b.can.request(&b.sim, 1);
        b.sim.run_for(Time::from_us(20));
        if cancelled {
            b.can.cancel(&b.sim, 1);
        }
        b.sim.run_for(FRAME);
        let e1 = b.sim.with_memory(b.can.ram, |memory| memory.words()[0x1484 / 4 + element * 2]);
        assert_eq!(e1 >> 22 & 3, 1 + u32::from(cancelled));
        assert_eq!(b.requests(), [0, 1, u32::from(cancelled), 0]);
    }
}

/// 2.4.4, 3.2.2: with UTSU an event of a message with TSCE refers to a TSU register; markers are wide without WMM; the
/// capture needs no event.
#[test]
fn section_2_4_4_events_with_a_timestamping_unit() {
    let add = |sim: &Sim, name: &str| {
        add_with(sim, name, |mut config| {
            config.tsu_registers = Some(2);
            config
        })
    };
    let b = bench_of(add, &Setup { cccr: pac::Cccr::UTSU, ..SETUP });
    for (tsce, efc) in [(true, true), (false, true), (true, false), (true, true)] {
        b.can.write_with(&b.sim, 0, &frame("100#"), |t1| {
            t1.with_efc(efc).with_tsce(tsce).with_mm(0x34).with_mm_high(0x12)
        });
        b.can.request(&b.sim, 1);
        b.sim.run_for(FRAME);
    }
    let e1 = |index: usize| b.sim.with_memory(b.can.ram, |memory| memory.words()[0x1484 / 4 + index * 2]);
    let word = 0x34 << 24 | 1 << 22 | 0x12 << 8;
    assert_eq!([e1(0), e1(1), e1(2)], [word | 1 << 4, word, word | 1 << 4]);
    assert_eq!(b.regs().txefs().read().effl(), 3);
    assert_eq!(b.sim.inspect(b.can.id, |model| model.tsu_pulses()), (0, 3), "the third capture used register 0 again");
}

/// 3.2.1: without TSU and wide markers the event holds the counter at its start of frame, as the receiver's element does.
#[test]
fn section_3_2_1_timestamps_of_both_sides() {
    let sim = Sim::new();
    let cans = ["can0", "can1"].map(|name| {
        let can = add(&sim, name);
        can.set_up(&sim, &SETUP);
        // One count in a microsecond, from time zero.
        can.regs(&sim).tscc().write(pac::Tscc::from_bits(2));
        can.start(&sim);
        can
    });
    sim.run_for(Time::from_us(1_000));
    cans[0].write_with(&sim, 0, &frame("123#11"), |t1| t1.with_efc(true));
    cans[0].request(&sim, 1);
    sim.run_for(FRAME);
    let start = sim.bus_log().iter().find_map(|entry| match entry {
        BusEntry::Frame { start, .. } => Some(*start),
        _ => None,
    });
    let expected = (start.unwrap().as_ns() / 1_000) as u32;
    let low = |can: Can, word: usize| sim.with_memory(can.ram, |memory| memory.words()[word] & 0xFFFF);
    assert_eq!([low(cans[0], 0x1484 / 4), low(cans[1], 0x11)], [expected; 2]);
}

/// 2.3.45: more than 32 events count as 32; a watermark beyond 32 is off.
#[test]
fn section_2_3_45_largest_event_fifo() {
    for (watermark, expected) in [(32, Ir::TEFW), (33, Ir::ZERO), (0, Ir::ZERO)] {
        let b = bench(&Setup { txefc: watermark << 24 | 63 << 16 | 0x2000, ..SETUP });
        b.can.write_with(&b.sim, 0, &frame("100#"), |t1| t1.with_efc(true));
        for _ in 0..32 {
            b.can.request(&b.sim, 1);
            b.sim.run_for(FRAME);
        }
        let status = b.regs().txefs().read();
        assert_eq!((status.effl(), status.eff(), status.tefl()), (32, true, false));
        assert_eq!(b.can.ir(&b.sim) & (Ir::TEFW | Ir::TEFF | Ir::TEFL), expected | Ir::TEFF, "watermark {watermark}");
        b.can.request(&b.sim, 1);
        b.sim.run_for(FRAME);
        assert!(b.regs().txefs().read().tefl(), "a copy of the flag");
        b.can.clear(&b.sim);
        assert!(!b.regs().txefs().read().tefl());
    }
}

/// 3.5.1: no pause after a message of another node, and none before a first message.
#[test]
fn section_3_5_1_no_pause_after_reception() {
    let b = bench(&Setup { cccr: pac::Cccr::TXP, ..SETUP });
    b.busy();
    b.can.send(&b.sim, 0, &frame("100#"));
    b.sim.run_for(FRAME * 2);
    let times: Vec<(Time, Time)> = b
        .sim
        .bus_log()
        .iter()
        .filter_map(|entry| match entry {
            BusEntry::Frame { start, end, .. } => Some((*start, *end)),
            _ => None,
        })
        .collect();
    assert_eq!(times[1].0.since(times[0].1), Time::from_us(4), "three bits of intermission, then SOF");
}

/// 2.4.3: T1 bits that no field has are sent nowhere, and the standard identifier stands in bits 28:18 alone.
#[test]
fn section_2_4_3_unused_bits() {
    let b = bench(&SETUP);
    b.can.write(&b.sim, 0, &frame("123#11"));
    let ram = b.can.memory(&b.sim);
    let (t0, t1): (u32, u32) = (ram.read(0x14C0), ram.read(0x14C4));
    ram.write(0x14C0, t0 | 0x3_FFFF);
    ram.write(0x14C4, t1 | 0xFF);
    b.can.request(&b.sim, 1);
    assert_eq!(b.sent(), ["123#11"]);
}

/// `tx_fifo_empty_flag`: only the Tx FIFO's own last message sets TFE; dedicated buffers, cancellations of what is not
/// pending, and configuration do not.
#[test]
fn section_2_3_16_tx_fifo_empty() {
    let b = bench(&SETUP);
    let empty = || {
        let flag = b.can.ir(&b.sim).contains(Ir::TFE);
        b.can.clear(&b.sim);
        flag
    };
    assert!(!empty(), "by configuration");
    b.can.send(&b.sim, 0, &frame("100#"));
    assert_eq!((b.sent().len(), empty()), (1, false), "a dedicated buffer");
    b.can.cancel(&b.sim, 0b1_1111);
    assert!(!empty(), "nothing was pending");
    for buffer in 2..4 {
        b.can.write(&b.sim, buffer, &frame("100#1122334455667788"));
    }
    b.can.request(&b.sim, 0b1100);
    b.sim.run_until(FRAME, |_| b.regs().txbto().read().bits() & 4 != 0).unwrap();
    assert!(!empty(), "one is left");
    assert_eq!((b.sent().len(), empty()), (3, true));
}
