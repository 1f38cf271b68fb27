//! Readings published from M_CAN 3.2.1 silicon.

use crate::bench::{Can, FRAME, SETUP, Setup, add, frame};
use can_sim::Sim;
use can_wire::NodeConfig;
use m_can_pac::registers::Ir;

const THREE_BUFFER_FIFO: Setup = Setup { txbc: 3 << 24 | 0x14C0, ..SETUP };

fn bench() -> (Sim, Can, can_sim::PeerId) {
    let sim = Sim::new();
    let can = add(&sim, "can0").run(&sim, &THREE_BUFFER_FIFO);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    sim.run_for(FRAME);
    (sim, can, peer)
}

/// A Tx FIFO of three buffers, TXBTIE = 0, one frame sent from buffer 0.
#[test]
fn one_frame_sent() {
    let (sim, can, _) = bench();
    let regs = can.regs(&sim);
    can.send(&sim, 0, &frame("123#0102030405060708"));
    sim.run_for(FRAME);
    assert_eq!(regs.txfqs().read().bits(), 0x0001_0103);
    let ir = regs.ir().read();
    assert!(!ir.contains(Ir::TC) && ir.contains(Ir::TFE), "{ir:?}");
    assert_eq!(regs.psr().read().bits(), 0x0000_0708);
    assert_eq!(regs.psr().read().bits(), 0x0000_070F);
    assert_eq!(sim.diagnostics(), []);
}

/// One frame received into Rx FIFO 0, then acknowledged.
#[test]
fn one_frame_received() {
    let (sim, can, peer) = bench();
    let regs = can.regs(&sim);
    sim.peer_send(peer, frame("123#0102030405060708"));
    sim.run_for(FRAME);
    assert_eq!(regs.rxf0s().read().bits(), 0x0001_0001);
    assert_eq!(can.receive(&sim, 0), Some(frame("123#0102030405060708")));
    assert_eq!(regs.rxf0s().read().bits(), 0x0000_0100 | 0x0001_0000);
    assert_eq!(sim.diagnostics(), []);
}
