//! Remote transmit request and response (8.3).

use crate::bench::{Can, FRAME, add, everything, exactly, frame, kinds, peer, received, standard};
use can_sim::Sim;
use dspic33_ecan_pac::{
    enums::{FilterTarget, MaskSource, OperationMode, TxPriority},
    registers as pac,
};

/// A module that answers 0x123 from buffer 7.
fn answering(sim: &Sim, name: &str, rtren: bool) -> Can {
    let can = add(sim, name).set_up(sim).add_filter(sim, exactly(0, MaskSource::Mask0, standard(0x123), 7));
    can.transmit_buffer(sim, 7, TxPriority::Lowest);
    let (control, lane) = can.regs(sim).tr_con_of(7);
    control.write(control.read().with_rtren(lane, rtren));
    can.write(sim, 7, &frame("123#CAFE"));
    can.enter(sim, OperationMode::Normal)
}

/// Figure 8-2: node 1 sends a remote frame from buffer 1, node 2 answers from buffer 7, node 1 stores the answer in
/// buffer 14. The steps are numbered 4 to 7 in the text and 1 to 4 in the figure.
#[test]
fn figure_8_2_request_and_response() {
    let sim = Sim::new();
    let node1 = add(&sim, "node1").set_up(&sim).add_filter(&sim, exactly(0, MaskSource::Mask0, standard(0x123), 14));
    node1.transmit_buffer(&sim, 1, TxPriority::Lowest).enter(&sim, OperationMode::Normal);
    let node2 = answering(&sim, "node2", true);
    node1.send(&sim, 1, &frame("123#R8"));
    sim.run_for(FRAME * 2);
    assert_eq!(node1.take(&sim, 14), Some(frame("123#CAFE")), "the buffer's own DLC, not that of the request");
    assert_eq!(node1.take_flags(&sim), pac::Intf::TBIF | pac::Intf::RBIF);
    // remote_answer_flags: nothing but TBIF, and the request is not stored.
    assert_eq!(node2.take_flags(&sim), pac::Intf::TBIF);
    assert_eq!((node2.regs(&sim).rxful(1).read().bits(), node2.regs(&sim).rxovf(1).read().bits()), (0, 0));
    assert_eq!(node2.outcome(&sim, 7), (false, false, false, false));
    assert_eq!(sim.diagnostics(), []);
}

/// 8.3.2: hardware sets TXREQ.
#[test]
fn section_8_3_2_hardware_sets_txreq() {
    let sim = Sim::new();
    let can = answering(&sim, "can1", true);
    let other = peer(&sim);
    sim.run_for(FRAME);
    sim.peer_send(other, frame("123#R2"));
    let requested = |sim: &Sim| sim.inspect(can.id, |model| model.transmitting() != (None, None));
    sim.run_until(FRAME, requested).unwrap();
    assert!(can.outcome(&sim, 7).0);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["123#CAFE"]);
}

/// 9.2.2: a data frame for a buffer that answers (`data_frame_on_remote_buffer`), and without RTREN any frame
/// (`frame_on_transmit_buffer`).
#[test]
fn section_9_2_2_other_frames_for_a_transmit_buffer() {
    for (rtren, text, overflows) in [(true, "123#01", false), (false, "123#01", true), (false, "123#R2", true)] {
        let sim = Sim::new();
        let can = answering(&sim, "can1", rtren);
        let other = peer(&sim);
        sim.run_for(FRAME);
        sim.peer_send(other, frame(text));
        sim.run_for(FRAME * 2);
        assert_eq!(received(&sim, other), Vec::<String>::new());
        assert_eq!((can.has_overflown(&sim, 7), can.intf(&sim).rbovif()), (overflows, overflows), "{rtren} {text}");
        assert!(!can.is_full(&sim, 7));
    }
}

/// 8.3.2, note: software answers with the DLC of the request: the remote frame goes to a receive buffer.
#[test]
fn section_8_3_2_answer_by_software() {
    let sim = Sim::new();
    let can = add(&sim, "can1").run(&sim, everything(FilterTarget::Buffer(10)));
    can.transmit_buffer(&sim, 0, TxPriority::Lowest);
    let other = peer(&sim);
    sim.run_for(FRAME);
    sim.peer_send(other, frame("00000077#R3"));
    sim.run_for(FRAME);
    let request = can.take(&sim, 10).unwrap();
    assert!(request.is_remote());
    let answer = can_frame::Frame::data(request.id(), &[9; 8][..usize::from(request.dlc().code())]).unwrap();
    can.send(&sim, 0, &answer);
    sim.run_for(FRAME);
    assert_eq!(received(&sim, other), ["00000077#090909"]);
    assert_eq!(kinds(&sim), []);
}
