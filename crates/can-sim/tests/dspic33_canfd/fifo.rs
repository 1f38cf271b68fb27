//! FIFO behaviour: memory layout, flags, indices and user addresses (5.4, 10.0).

use crate::bench::{BASE, Can, FRAME, Mode, TX8, TxFifo, add, fd, frame, kinds, pair};
use can_sim::{DiagnosticKind, Memory, Sim, dspic33_canfd::Dspic33CanfdConfig};
use can_wire::NodeConfig;
use dspic33_canfd_pac::{enums::PayloadSize, registers as pac};

/// Table 10-1: the example of chapter 10. The event FIFO at 0x1400, the queue at 0x1490, FIFO 1 at 0x15D0, FIFO 2 at
/// 0x1738.
fn table_10_1() -> (Sim, Can, can_sim::PeerId) {
    let (sim, can, peer) = pair();
    can.set_base(&sim, 0x1400);
    can.events(&sim, 12, true);
    can.queue(&sim, TxFifo { depth: 8, size: PayloadSize::Bytes32, priority: 0 });
    can.tx_fifo(&sim, 1, TxFifo { depth: 5, size: PayloadSize::Bytes64, priority: 0 });
    can.rx_fifo(&sim, 2, 16, PayloadSize::Bytes64);
    can.regs(&sim).fifo(2).con_l().write(pac::FifoConL::from_bits(0).with_rxtsen(true));
    can.accept_all(&sim, 2);
    can.start(&sim);
    (sim, can, peer)
}

fn starts(sim: &Sim, can: Can) -> Vec<(&'static str, u32, u32, u32)> {
    let layout = sim.inspect(can.id, |model| model.layout());
    layout.iter().take(5).map(|placed| (placed.name, placed.start, placed.element, placed.count)).collect()
}

#[test]
fn table_10_1_addresses() {
    let (sim, can, _) = table_10_1();
    let expected = [
        ("tef", 0x1400, 12, 12),
        ("txq", 0x1490, 40, 8),
        ("fifo 1", 0x15D0, 72, 5),
        ("fifo 2", 0x1738, 76, 16),
        ("fifo 3", 0x1BF8, 16, 1),
    ];
    assert_eq!(starts(&sim, can), expected);
    let regs = can.regs(&sim);
    assert_eq!((regs.read_tefua(), can.user_address(&sim, 0)), (0x1400, 0x1490));
    assert_eq!(
        (can.user_address(&sim, 1), can.user_address(&sim, 2), can.user_address(&sim, 3)),
        (0x15D0, 0x1738, 0x1BF8)
    );
    assert_eq!(sim.diagnostics(), []);
}

/// 5.4.5: 32 bytes of events without timestamp, one queue object of 20, a FIFO of three with 8 bytes: 100 bytes.
#[test]
fn section_5_4_5_example_of_100_bytes() {
    let (sim, can, _) = pair();
    can.events(&sim, 4, false);
    can.queue(&sim, TxFifo { depth: 1, size: PayloadSize::Bytes12, priority: 0 });
    can.rx_fifo(&sim, 1, 3, PayloadSize::Bytes8);
    let layout = starts(&sim, can);
    assert_eq!(layout[1], ("txq", BASE + 32, 20, 1));
    assert_eq!(layout[2], ("fifo 1", BASE + 52, 16, 3));
    assert_eq!(layout[3].1, BASE + 100);
}

/// The layouts of examples 6-1, 7-1 and 9-1: 120, 420 and 152 bytes. Example 7-1 reserves only 200 bytes.
#[test]
fn layouts_of_the_code_examples() {
    let (sim, can, _) = pair();
    can.queue(&sim, TxFifo { depth: 1, size: PayloadSize::Bytes64, priority: 0 });
    can.tx_fifo(&sim, 1, TxFifo { depth: 2, size: PayloadSize::Bytes16, priority: 0 });
    assert_eq!(starts(&sim, can)[3].1 - BASE, 120);
    let (sim, can, _) = pair();
    can.events(&sim, 5, true);
    can.tx_fifo(&sim, 1, TxFifo { depth: 5, size: PayloadSize::Bytes64, priority: 0 });
    assert_eq!((starts(&sim, can)[2].1 - BASE, starts(&sim, can)[3].1 - BASE), (0x3C, 420));
    let (sim, can, _) = pair();
    can.rx_fifo(&sim, 1, 2, PayloadSize::Bytes64);
    can.regs(&sim).fifo(1).con_l().write(pac::FifoConL::from_bits(0).with_rxtsen(true));
    assert_eq!(starts(&sim, can)[3].1 - BASE, 152);
}

/// The layout after reset: STEF and TXQEN are set, so one event of 8 bytes and one queue object of 16 take room; a FIFO
/// that is not used takes 16 (equation 5-24).
#[test]
fn layout_after_reset() {
    let sim = Sim::new();
    let can = add(&sim, "can0");
    let layout = sim.inspect(can.id, |model| model.layout());
    assert_eq!((layout[0].start, layout[1].start), (0, 8));
    for number in 1..32 {
        assert_eq!(layout[number + 1].start, 0x18 + 0x10 * (number as u32 - 1));
    }
}

/// 5.4.5: RXTSEN does not enlarge a transmit FIFO.
#[test]
fn timestamps_take_no_room_in_a_transmit_fifo() {
    let (sim, can, _) = pair();
    can.tx_fifo(&sim, 1, TX8);
    let con = can.regs(&sim).fifo(1).con_l();
    con.write(con.read().with_freset(false).with_rxtsen(true));
    assert_eq!(starts(&sim, can)[2].2, 16);
}

/// TXREQ, FIFOCI, user address and CxFIFOSTA1 of a step.
fn fifo_1(sim: &Sim, can: Can) -> (bool, u8, u32, u16) {
    let status = can.status(sim, 1);
    (can.regs(sim).fifo(1).con_l().read().txreq(), status.fifoci(), can.user_address(sim, 1), status.bits())
}

/// 10.2, figures 10-1 to 10-6; the address of figure 10-3 corrected from 0x218 to 0x1618.
#[test]
fn section_10_2_transmit_fifo() {
    let (sim, can, _) = table_10_1();
    assert_eq!(fifo_1(&sim, can), (false, 0, 0x15D0, 0x0007), "figure 10-1");
    let message = |number: u16| fd(0x100 + number, &[number as u8; 64]);
    can.load(&sim, 1, &message(0));
    can.request(&sim, 1 << 1);
    assert_eq!(fifo_1(&sim, can), (true, 0, 0x1618, 0x0003), "figure 10-2");
    sim.run_for(FRAME);
    assert_eq!(fifo_1(&sim, can), (false, 1, 0x1618, 0x0107), "figure 10-3");
    (1..=3).for_each(|number| can.load(&sim, 1, &message(number)));
    assert_eq!(fifo_1(&sim, can), (false, 1, 0x16F0, 0x0101), "figure 10-4");
    (4..=5).for_each(|number| can.load(&sim, 1, &message(number)));
    can.request(&sim, 1 << 1);
    assert_eq!(fifo_1(&sim, can), (true, 1, 0x1618, 0x0100), "figure 10-5");
    sim.run_for(FRAME * 5);
    assert_eq!(fifo_1(&sim, can), (false, 1, 0x1618, 0x0107), "figure 10-6");
    assert_eq!(sim.diagnostics(), []);
}

/// FIFOCI, user address and CxFIFOSTA2 of a step.
fn fifo_2(sim: &Sim, can: Can) -> (u8, u32, u16) {
    let status = can.status(sim, 2);
    (status.fifoci(), can.user_address(sim, 2), status.bits())
}

/// 10.3, figures 10-7 to 10-14; figure 10-11 receives MSG9 to MSG15, not ten more messages.
#[test]
fn section_10_3_receive_fifo() {
    let (sim, can, peer) = table_10_1();
    let receive = |numbers: core::ops::RangeInclusive<u16>| {
        for number in numbers {
            sim.peer_send(peer, fd(0x200 + number, &[number as u8; 8]));
            sim.run_for(FRAME);
        }
    };
    assert_eq!(fifo_2(&sim, can), (0, 0x1738, 0x0000), "figure 10-7");
    receive(0..=0);
    assert_eq!(fifo_2(&sim, can), (1, 0x1738, 0x0101), "figure 10-8");
    assert_eq!(can.receive(&sim, 2).unwrap().raw_id(), 0x200);
    assert_eq!(fifo_2(&sim, can), (1, 0x1784, 0x0100), "figure 10-9");
    receive(1..=8);
    assert_eq!(fifo_2(&sim, can), (9, 0x1784, 0x0903), "figure 10-10");
    receive(9..=15);
    assert_eq!(fifo_2(&sim, can), (0, 0x1784, 0x0003), "figure 10-11");
    receive(16..=16);
    assert_eq!(fifo_2(&sim, can), (1, 0x1784, 0x0107), "figure 10-12");
    receive(17..=17);
    assert_eq!(fifo_2(&sim, can), (1, 0x1784, 0x010F), "figure 10-13");
    can.regs(&sim).fifo(2).sta().clear(pac::FifoSta::RXOVIF);
    let ids: Vec<u32> = (0..2).map(|_| can.receive(&sim, 2).unwrap().raw_id()).collect();
    assert_eq!(ids, [0x201, 0x202]);
    assert_eq!(fifo_2(&sim, can), (1, 0x181C, 0x0103), "figure 10-14");
    let held = sim.with_memory(can.ram, |ram| ram.clone());
    let indices: Vec<u32> =
        sim.inspect(can.id, |model| model.rx_fifo(&held, 2)).iter().map(|object| object.index).collect();
    assert_eq!(indices, [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0]);
}

/// User address, TXQEIF and TXQNIF of a step.
fn queue(sim: &Sim, can: Can) -> (u32, bool, bool) {
    let status = can.regs(sim).txqsta().read();
    (can.user_address(sim, 0), status.txqeif(), status.txqnif())
}

/// 10.4, figures 10-15 to 10-20.
#[test]
fn section_10_4_transmit_queue() {
    let (sim, can, peer) = table_10_1();
    let message = |number: u16| fd(0x300 - number, &[number as u8; 32]);
    assert_eq!(queue(&sim, can), (0x1490, true, true), "figure 10-15");
    can.send(&sim, 0, &message(0));
    assert_eq!(queue(&sim, can), (0x14B8, false, true), "figure 10-16");
    sim.run_for(FRAME);
    assert_eq!(can.pending(&sim), 0);
    assert_eq!(queue(&sim, can), (0x14B8, true, true), "figure 10-17");
    can.load(&sim, 0, &message(1));
    assert_eq!(queue(&sim, can), (0x1490, false, true), "figure 10-18");
    (2..=7).for_each(|number| can.load(&sim, 0, &message(number)));
    assert_eq!(queue(&sim, can), (0x15A8, false, true), "figure 10-19");
    can.load(&sim, 0, &message(8));
    can.request(&sim, 1);
    assert_eq!(queue(&sim, can), (0x1490, false, false), "figure 10-20");
    // The lowest identifier is sent first.
    sim.run_for(FRAME * 10);
    let ids: Vec<u32> = sim.peer_received(peer).iter().map(|(_, frame)| frame.raw_id()).collect();
    assert_eq!(ids, [0x300, 0x2F8, 0x2F9, 0x2FA, 0x2FB, 0x2FC, 0x2FD, 0x2FE, 0x2FF]);
    assert!(queue(&sim, can).1);
    assert_eq!(sim.diagnostics(), []);
}

/// 10.5, figures 10-21 to 10-28.
#[test]
fn section_10_5_event_fifo() {
    let (sim, can, _) = table_10_1();
    let send = |numbers: core::ops::RangeInclusive<u16>| {
        for number in numbers {
            can.send(&sim, 1, &fd(0x100 + number, &[]));
            sim.run_for(FRAME);
        }
    };
    let state = || (can.regs(&sim).read_tefua(), can.regs(&sim).tefsta().read().bits());
    let release = || can.release_event(&sim);
    assert_eq!(state(), (0x1400, 0x0), "figure 10-21");
    send(0..=0);
    assert_eq!(state(), (0x1400, 0x1), "figure 10-22");
    release();
    assert_eq!(state(), (0x140C, 0x0), "figure 10-23");
    send(1..=6);
    assert_eq!(state(), (0x140C, 0x3), "figure 10-24");
    send(7..=11);
    assert_eq!(state(), (0x140C, 0x3), "figure 10-25");
    send(12..=12);
    assert_eq!(state(), (0x140C, 0x7), "figure 10-26");
    send(13..=13);
    assert_eq!(state(), (0x140C, 0xF), "figure 10-27");
    can.regs(&sim).tefsta().clear(pac::Tefsta::TEFOVIF);
    release();
    assert_eq!(state(), (0x1418, 0x3), "figure 10-28");
    let ids = sim.inspect(can.id, |model| model.clone());
    let held: Vec<_> = sim.with_memory(can.ram, |ram| ids.events(ram)).into_iter().map(|event| event.index).collect();
    assert_eq!(held, [2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0]);
}

/// Register 3-34: the half flag of a transmit FIFO means at most half full, also of an odd depth; of a receive FIFO at
/// least half full.
#[test]
fn half_flags_at_every_fill_level() {
    for depth in 1..=32_u8 {
        let sim = Sim::new();
        let ram = sim.add_memory(Memory::new(4096).with_widths(&[8, 16, 32]));
        let id = sim.add_dspic33_canfd("can0", Dspic33CanfdConfig::new(ram)).unwrap();
        let can = Can { id, ram };
        let peer = sim.add_peer(NodeConfig::new()).unwrap();
        can.configure(&sim);
        can.tx_fifo(&sim, 1, TxFifo { depth, ..TX8 });
        can.rx_fifo(&sim, 2, depth, PayloadSize::Bytes8);
        can.accept_all(&sim, 2);
        can.start(&sim);
        for count in 0..=depth {
            let (tx, rx) = (can.status(&sim, 1), can.status(&sim, 2));
            assert_eq!(tx.tferffif(), count == 0);
            assert_eq!(tx.tfhrfhif(), u16::from(count) * 2 <= u16::from(depth), "{count} of {depth}");
            assert_eq!(tx.tfnrfnif(), count < depth);
            assert_eq!(rx.tferffif(), count == depth);
            assert_eq!(rx.tfhrfhif(), u16::from(count) * 2 >= u16::from(depth), "{count} of {depth}");
            assert_eq!(rx.tfnrfnif(), count > 0);
            if count < depth {
                can.load(&sim, 1, &frame("123#"));
                sim.peer_send(peer, frame("456#"));
                sim.run_for(FRAME);
            }
        }
    }
}

/// 6.14, 9.3: FRESET empties a FIFO, keeps its settings, and clears itself.
#[test]
fn freset_of_a_fifo_empties_it_and_only_it() {
    let (sim, can, peer) = pair();
    can.tx_fifo(&sim, 1, TX8);
    can.tx_fifo(&sim, 2, TX8);
    can.rx_fifo(&sim, 3, 4, PayloadSize::Bytes8);
    can.accept_all(&sim, 3);
    can.start(&sim);
    can.load(&sim, 1, &frame("100#11"));
    can.load(&sim, 2, &frame("200#22"));
    sim.peer_send(peer, frame("300#33"));
    sim.run_for(FRAME);
    let settings = can.regs(&sim).fifo(1).con_h().read();
    can.reset(&sim, 1);
    assert!(!can.regs(&sim).fifo(1).con_l().read().freset());
    assert_eq!(can.regs(&sim).fifo(1).con_h().read(), settings);
    assert_eq!(can.status(&sim, 1).bits(), 0x0007);
    assert!(!can.status(&sim, 2).tferffif(), "FIFO 2 keeps its message");
    assert!(can.has_message(&sim, 3), "so does FIFO 3");
    assert_eq!(kinds(&sim), []);
    // 9.3: a receive FIFO that a filter points to, 6.14: a transmit FIFO with a request.
    can.reset(&sim, 3);
    can.go(&sim, Mode::Disable);
    can.request(&sim, 1 << 2);
    let con = can.regs(&sim).fifo(2).con_l();
    con.write(con.read().with_freset(true));
    let because = |kind: &DiagnosticKind| match kind {
        DiagnosticKind::ResetInUse { because, .. } => *because,
        other => panic!("{other}"),
    };
    let found: Vec<_> = kinds(&sim).iter().map(because).collect();
    assert_eq!(found, ["an enabled filter points to it", "a transmission is pending"]);
    assert_eq!(can.pending(&sim), 0, "the reset drops the request too");
}

/// 4.2: in Configuration mode FRESET reads 1 everywhere and stays.
#[test]
fn freset_lasts_in_configuration_mode() {
    let (sim, can, _) = pair();
    let regs = can.regs(&sim);
    for (number, fifo) in regs.fifo_iter() {
        fifo.con_l().write(pac::FifoConL::from_bits(0));
        assert!(fifo.con_l().read().freset(), "FIFO {number}");
    }
    regs.txqcon_l().write(pac::TxqconL::from_bits(0));
    regs.tefcon_l().write(pac::TefconL::from_bits(0));
    assert!(regs.txqcon_l().read().freset() && regs.tefcon_l().read().freset());
    can.start(&sim);
    for (number, fifo) in regs.fifo_iter() {
        assert!(!fifo.con_l().read().freset(), "FIFO {number}");
    }
    assert!(!regs.txqcon_l().read().freset() && !regs.tefcon_l().read().freset());
}
