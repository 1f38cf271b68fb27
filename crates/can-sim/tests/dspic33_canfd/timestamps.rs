//! The Time Base Counter and timestamps (11.0).

use crate::bench::{Can, FRAME, TX64, add_with, fd, frame, pair};
use can_frame::Frame;
use can_sim::{BusEntry, PeerId, Sim, Time};
use dspic33_canfd_pac::{
    enums::{PayloadSize, TsconHTseof, TsconHTsres},
    messages::TefObjectTs,
    registers as pac,
};

fn bench(control: pac::TsconH) -> (Sim, Can, PeerId, Time) {
    let (sim, can, peer) = pair();
    can.events(&sim, 4, true);
    can.tx_fifo(&sim, 1, TX64);
    can.rx_fifo(&sim, 2, 4, PayloadSize::Bytes64);
    let con = can.regs(&sim).fifo(2).con_l();
    con.write(pac::FifoConL::from_bits(0).with_rxtsen(true));
    can.accept_all(&sim, 2);
    can.start(&sim);
    can.regs(&sim).tscon_h().write(control);
    let started = sim.now();
    (sim, can, peer, started)
}

/// Start and end of the only frame on the bus, in counts of 25 ns since `started`.
fn counts(sim: &Sim, started: Time) -> (u32, u32) {
    let BusEntry::Frame { start, end, .. } = *sim.bus_log().last().unwrap() else { panic!("no frame") };
    let count = |at: Time| (at.since(started).as_ps() / 25_000) as u32;
    (count(start), count(end))
}

fn stamp(sim: &Sim, can: Can, peer: PeerId, own: bool, message: &Frame) -> u32 {
    if own {
        can.send(sim, 1, message);
        sim.run_for(FRAME);
        let at = (can.regs(sim).read_tefua() - crate::bench::BASE) as usize;
        TefObjectTs::new(can.memory(sim), at).read_txmsgts()
    } else {
        sim.peer_send(peer, *message);
        sim.run_for(FRAME);
        can.receive_object(sim, 2).unwrap().2
    }
}

/// Table 11-1: all reference points.
#[test]
fn table_11_1_reference_points() {
    let on = pac::TsconH::TBCEN;
    let end = on.with_tseof(TsconHTseof::Valid);
    let res = on.with_tsres(TsconHTsres::AfterFdf);
    let (classic, long) = (frame("155#0011"), fd(0x155, &[0x5A; 12]));
    for own in [true, false] {
        for message in [classic, long] {
            let (sim, can, peer, started) = bench(on);
            let at = stamp(&sim, can, peer, own, &message);
            assert_eq!(at, counts(&sim, started).0, "start of frame");
            let (sim, can, peer, started) = bench(end);
            let at = stamp(&sim, can, peer, own, &message);
            // A received frame is valid one bit before a transmitted one.
            assert_eq!(at, counts(&sim, started).1 - if own { 0 } else { 40 }, "frame valid");
            let (sim, can, peer, started) = bench(res);
            let at = stamp(&sim, can, peer, own, &message);
            // SOF, 11 identifier bits, RRS, IDE, FDF, and then the bit after it; 0x155 needs no stuff bit.
            let bits = if message.is_fd() { 15 } else { 0 };
            assert_eq!(at, counts(&sim, started).0 + bits * 40, "after FDF");
        }
    }
}

/// Register 3-11, `tbc_prescaler`: one count every TBCPRE + 1 clock periods.
#[test]
fn prescaler() {
    for (pre, expected) in [(0, 40_000), (1, 20_000), (39, 1_000), (1023, 39)] {
        let (sim, can, _, _) = bench(pac::TsconH::from_bits(0));
        let regs = can.regs(&sim);
        regs.tscon_l().write(pac::TsconL::from_bits(pre));
        regs.tscon_h().write(pac::TsconH::TBCEN);
        sim.run_for(Time::from_ms(1));
        let found = regs.read_tbc();
        assert!((expected..=expected + 8).contains(&found), "{pre}: {found}");
    }
}

/// 11.0, `tbc_write_while_stopped`, `tbc_write_while_running`.
#[test]
fn presetting_and_stopping() {
    let (sim, can, _, _) = bench(pac::TsconH::from_bits(0));
    let regs = can.regs(&sim);
    regs.write_tbc(0x0012_3456);
    sim.run_for(Time::from_us(10));
    assert_eq!(regs.read_tbc(), 0x0012_3456, "stopped");
    regs.tscon_h().write(pac::TsconH::TBCEN);
    sim.run_for(Time::from_us(10));
    assert!((0x0012_3456 + 400..0x0012_3456 + 420).contains(&regs.read_tbc()), "it counts on from there");
    assert_eq!(sim.diagnostics(), []);
    regs.tbc_l().write(pac::TbcL::from_bits(0));
    assert!(regs.read_tbc() > 0x0012_3456, "ignored while it runs");
    assert_eq!(sim.take_diagnostics().len(), 1);
    regs.tscon_h().write(pac::TsconH::from_bits(0));
    assert_eq!(regs.read_tbc(), 0, "clearing TBCEN resets it");
}

/// `timestamp_without_counter`: RXTSEN and TEFTSEN do not start the counter; examples 7-1 and 9-1 never enable it.
#[test]
fn timestamps_without_the_counter() {
    let (sim, can, peer, _) = bench(pac::TsconH::from_bits(0));
    assert_eq!(stamp(&sim, can, peer, true, &frame("100#")), 0);
    assert_eq!(stamp(&sim, can, peer, false, &frame("101#")), 0);
}

/// 11.0: the counter runs with the module's own clock, its tolerance included.
#[test]
fn the_counter_has_the_clocks_tolerance() {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", |mut config| {
        config.place.clock_ppm = 1_000;
        config
    });
    can.regs(&sim).tscon_h().write(pac::TsconH::TBCEN);
    sim.run_for(Time::from_ms(10));
    let found = can.regs(&sim).read_tbc();
    assert!((400_400..400_410).contains(&found), "{found}");
}
