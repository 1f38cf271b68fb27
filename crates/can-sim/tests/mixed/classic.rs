//! All four controllers and a node without controller exchange classic frames; remote requests are answered by the three
//! controllers that do so by themselves.

use std::{cell::RefCell, collections::VecDeque};

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use can_sim::{BusEntry, PeerId, Sim, Time};
use can_wire::{FdSupport, NodeConfig, ProtocolException};
use dspic33_canfd_pac::enums::PayloadSize;
use dspic33_ecan_pac::enums::{FilterTarget, MaskSource, OperationMode, TxPriority};
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

use crate::{Inbox, canfd, ecan, errors_after_acceptance, m_can, no_exception, pic32};
use m_can_pac::registers::Cccr;

const FRAMES: usize = 10_000;
const NODES: usize = 5;
const NAMES: [&str; NODES] = ["M_CAN", "CAN FD", "ECAN", "PIC32", "plain node"];

/// A node as its driver sees it.
trait Driver {
    /// Sends a frame if there is room.
    fn send(&self, sim: &Sim, frame: &Frame) -> bool;
    /// The next frame received.
    fn receive(&self, sim: &Sim) -> Option<Frame>;
    /// The answer to a remote request has gone out: puts it there again, where it is used up.
    fn answer_again(&self, _sim: &Sim) {}
}

/// Sends from a Tx FIFO of five, receives in Rx FIFO 0 of eight.
struct MCan(m_can::Can);

impl Driver for MCan {
    fn send(&self, sim: &Sim, frame: &Frame) -> bool {
        let status = self.0.regs(sim).txfqs().read();
        let room = status.tffl() > 0;
        if room {
            self.0.send(sim, u32::from(status.tfqpi()), frame);
        }
        room
    }

    fn receive(&self, sim: &Sim) -> Option<Frame> {
        assert!(!self.0.regs(sim).rxf0s().read().rf0l(), "a message is lost at M_CAN");
        self.0.receive(sim, 0)
    }
}

/// Sends from FIFO 1, receives in FIFO 2, answers from FIFO 3.
struct Canfd(canfd::Can);

impl Driver for Canfd {
    fn send(&self, sim: &Sim, frame: &Frame) -> bool {
        let room = self.0.status(sim, 1).tfnrfnif();
        if room {
            self.0.send(sim, 1, frame);
        }
        room
    }

    fn receive(&self, sim: &Sim) -> Option<Frame> {
        assert!(!self.0.status(sim, 2).rxovif(), "a message is lost at the CAN FD module");
        self.0.receive(sim, 2)
    }

    fn answer_again(&self, sim: &Sim) {
        self.0.load(sim, 3, &reply_of(1));
    }
}

/// Sends from buffer 0, one message at a time, receives in the FIFO from buffer 5 to 11, answers from buffer 2.
struct Ecan(ecan::Can);

impl Driver for Ecan {
    fn send(&self, sim: &Sim, frame: &Frame) -> bool {
        let room = !self.0.outcome(sim, 0).0;
        if room {
            self.0.send(sim, 0, frame);
        }
        room
    }

    fn receive(&self, sim: &Sim) -> Option<Frame> {
        self.0.take_from_fifo(sim)
    }
}

/// Sends from FIFO 0, receives in FIFO 1, answers from FIFO 2.
struct Pic32(pic32::Can);

impl Driver for Pic32 {
    fn send(&self, sim: &Sim, frame: &Frame) -> bool {
        let room = self.0.fifo(sim, 0).int_().read().txnfullif();
        if room {
            self.0.send(sim, 0, frame);
        }
        room
    }

    fn receive(&self, sim: &Sim) -> Option<Frame> {
        assert!(!self.0.fifo(sim, 1).int_().read().rxovflif(), "a message is lost at PIC32");
        self.0.receive(sim, 1)
    }

    fn answer_again(&self, sim: &Sim) {
        self.0.queue(sim, 2, &reply_of(3));
    }
}

/// A node without controller, and what it has received and not read.
struct Plain {
    peer: PeerId,
    received: RefCell<VecDeque<Frame>>,
}

impl Driver for Plain {
    fn send(&self, sim: &Sim, frame: &Frame) -> bool {
        sim.peer_send(self.peer, *frame);
        true
    }

    fn receive(&self, sim: &Sim) -> Option<Frame> {
        let mut received = self.received.borrow_mut();
        received.extend(sim.take_peer_received(self.peer).into_iter().map(|(_, frame)| frame));
        received.pop_front()
    }
}

/// Identifiers that are answered, by node; M_CAN has no automatic reply.
const REPLIES: [(usize, u16); 3] = [(1, 0x700), (2, 0x701), (3, 0x702)];

fn reply_of(node: usize) -> Frame {
    let (_, id) = REPLIES[node - 1];
    Frame::data(StandardId::new(id).unwrap(), &[node as u8, 0x55]).unwrap()
}

/// The three low bits of an identifier tell the sender. Identifiers from 0x700 on are those of the replies.
fn random_frame(random: &mut ChaCha8Rng, sender: usize) -> Frame {
    let bits = random.next_u32();
    let id = if bits & 1 == 0 {
        Id::Standard(StandardId::new((((bits >> 3) % 0x700) & 0x7F8) as u16 | sender as u16).unwrap())
    } else {
        Id::Extended(ExtendedId::new(bits >> 3 & 0x1FFF_FFF8 | sender as u32).unwrap())
    };
    let mut data = [0; 8];
    random.fill_bytes(&mut data);
    Frame::from_fields(id, Format::Data, Dlc::from_low_bits((random.next_u32() % 9) as u8), &data)
}

fn is_reply(frame: &Frame) -> bool {
    matches!(frame.id(), Id::Standard(id) if id.as_raw() >= 0x700)
}

fn sender_of(frame: &Frame) -> usize {
    let low = (frame.raw_id() & 7) as usize;
    if is_reply(frame) { REPLIES[low].0 } else { low }
}

fn bus(sim: &Sim) -> [Box<dyn Driver>; NODES] {
    let m_can = m_can::add(sim, "m_can").run(
        sim,
        &m_can::Setup { cccr: Cccr::PXHD, txbc: 5 << 24 | 0x14C0, rxf0c: 8 << 16 | 0x40, rxesc: 0, ..m_can::SETUP },
    );
    let canfd = canfd::add(sim, "dspic33_canfd");
    canfd.configure(sim);
    canfd.tx_fifo(sim, 1, canfd::TX8);
    canfd.rx_fifo(sim, 2, 16, PayloadSize::Bytes8);
    canfd.tx_fifo(sim, 3, canfd::TxFifo { depth: 1, ..canfd::TX8 });
    let con = canfd.regs(sim).fifo(3).con_l();
    con.write(con.read().with_rtren(true));
    // Filter 0 sends remote requests to FIFO 3, filter 1 everything else to FIFO 2.
    canfd.filter(sim, 0, 0x700, 1 << 30 | 0x7FF, 3);
    canfd.filter(sim, 1, 0, 0, 2);
    no_exception(sim, canfd);
    canfd.go(sim, canfd::Mode::NormalCan2_0);
    canfd.load(sim, 3, &reply_of(1));
    let ecan = ecan::add(sim, "dspic33_ecan").set_up(sim);
    ecan.write_fctrl(sim, ecan::FIFO_5_TO_11);
    ecan.add_filter(sim, ecan::exactly(0, MaskSource::Mask0, ecan::standard(0x701), 2));
    ecan.add_filter(sim, ecan::Filter { number: 1, mask: MaskSource::Mask1, ..ecan::everything(FilterTarget::Fifo) });
    ecan.transmit_buffer(sim, 0, TxPriority::Lowest).transmit_buffer(sim, 2, TxPriority::Highest);
    let (control, lane) = ecan.regs(sim).tr_con_of(2);
    control.write(control.read().with_rtren(lane, true));
    ecan.write(sim, 2, &reply_of(2));
    ecan.enter(sim, OperationMode::Normal);
    let pic32 = pic32::add(sim, "pic32_can");
    pic32.set_up(sim, 0x100, &[pic32::Use::Tx(4), pic32::Use::Rx(16), pic32::Use::Tx(1)]);
    pic32.fifo(sim, 2).con().set_bits(pic32_can_pac::registers::FifoCon::RTREN);
    pic32.filter(sim, 0, 0, 2, pic32::standard(0x702), pic32::EXACT);
    pic32.filter(sim, 1, 1, 1, pic32_can_pac::registers::Rxf::RESET, pic32_can_pac::registers::Rxm::RESET);
    pic32.start(sim);
    pic32.queue(sim, 2, &reply_of(3));
    let config =
        NodeConfig { fd: FdSupport::Classic, protocol_exception: ProtocolException::FormError, ..NodeConfig::new() };
    let peer = sim.add_peer(config).unwrap();
    sim.run_for(Time::from_us(100));
    let plain = Plain { peer, received: RefCell::default() };
    [Box::new(MCan(m_can)), Box::new(Canfd(canfd)), Box::new(Ecan(ecan)), Box::new(Pic32(pic32)), Box::new(plain)]
}

/// Every node sends its frames to all others. The plain node also asks for the replies, one at a time.
fn exchange(noise: f64) -> usize {
    let sim = Sim::builder().log_limit(1_000_000).build();
    let nodes = bus(&sim);
    sim.with_wire(|wire| {
        let ids: Vec<_> = wire.nodes().collect();
        for (seed, node) in (21..).zip(ids) {
            wire.set_noise(node, noise, seed);
        }
    });
    let mut random: Vec<_> = (0..NODES as u64).map(ChaCha8Rng::seed_from_u64).collect();
    let mut next: Vec<Frame> = random.iter_mut().enumerate().map(|(node, random)| random_frame(random, node)).collect();
    let mut expected: Vec<Vec<VecDeque<Frame>>> = vec![vec![VecDeque::new(); NODES]; NODES];
    let mut inboxes: Vec<Vec<Inbox>> = (0..NODES).map(|_| (0..NODES).map(|_| Inbox::default()).collect()).collect();
    let mut sent = [0; NODES];
    let mut waiting = 0;
    let (mut asked, mut answered, mut asking) = (0, 0, None);
    let limit = Time::from_ms(60_000);
    while sent != [FRAMES; NODES] || waiting > 0 || asking.is_some() {
        for node in 0..NODES {
            // The plain node's queue has no end; it sends as much as the slowest.
            let slow = node == 4 && sent[4] > *sent[..4].iter().min().unwrap_or(&0);
            if sent[node] == FRAMES || slow || !nodes[node].send(&sim, &next[node]) {
                continue;
            }
            for (_, queues) in expected.iter_mut().enumerate().filter(|(receiver, _)| *receiver != node) {
                queues[node].push_back(next[node]);
                waiting += 1;
            }
            sent[node] += 1;
            next[node] = random_frame(&mut random[node], node);
        }
        if asking.is_none() && sent[4] > asked * 20 && asked < 300 {
            let (node, id) = REPLIES[asked % 3];
            nodes[4].send(&sim, &Frame::remote(StandardId::new(id).unwrap(), Dlc::new(2).unwrap()));
            asking = Some(node);
            asked += 1;
        }
        for (receiver, node) in nodes.iter().enumerate() {
            while let Some(frame) = node.receive(&sim) {
                if frame.is_remote() {
                    continue;
                }
                let sender = sender_of(&frame);
                if !is_reply(&frame) {
                    waiting -= usize::from(inboxes[receiver][sender].take(frame, &mut expected[receiver][sender]));
                    continue;
                }
                assert_eq!(frame, reply_of(sender), "{} from {}", NAMES[receiver], NAMES[sender]);
                if receiver == 4 && asking == Some(sender) {
                    asking = None;
                    nodes[sender].answer_again(&sim);
                    answered += 1;
                }
            }
        }
        sim.run_for(Time::from_us(60));
        assert!(sim.now() < limit, "{waiting} frames wait, {sent:?} sent, {answered} of {asked} answered");
    }
    assert_eq!((asked, answered), (300, 300));
    assert_eq!(sim.diagnostics(), []);
    let twice: usize = inboxes.iter().flatten().map(|inbox| inbox.twice).sum();
    assert!(twice <= errors_after_acceptance(&sim) * (NODES - 1), "{twice} messages came twice");
    let log = sim.bus_log();
    log.iter().filter(|entry| matches!(entry, BusEntry::Error { .. })).count()
}

#[test]
fn nothing_is_lost() {
    assert_eq!(exchange(0.0), 0);
}

#[test]
fn nothing_is_lost_under_bit_errors() {
    let errors = exchange(0.000_02);
    assert!(errors > 200, "{errors} errors");
}

/// What wins arbitration: identifier bits as they come on the bus, a standard one before an extended one of equal start.
fn rank(frame: &Frame) -> (u32, u32) {
    match frame.id() {
        Id::Standard(id) => (u32::from(id.as_raw()) << 1, 0),
        Id::Extended(id) => (id.as_raw() >> 18 << 1 | 1, id.as_raw() & 0x3_FFFF),
    }
}

/// While a frame is on the bus every node gets one to send: they follow in the order of their identifiers.
#[test]
fn the_lowest_identifier_wins_among_all() {
    let sim = Sim::new();
    let nodes = bus(&sim);
    let mut random = ChaCha8Rng::seed_from_u64(9);
    for round in 0..300 {
        let first = Frame::data(StandardId::new(0x000).unwrap(), &[round as u8; 8]).unwrap();
        assert!(nodes[round % NODES].send(&sim, &first));
        sim.run_for(Time::from_us(30));
        // ECAN sends from one buffer here, so that it has room only where another node sends the first frame.
        let ready = (0..NODES).filter(|node| *node != 2 || round % NODES != 2);
        let mut frames = Vec::new();
        for node in ready {
            frames.push(random_frame(&mut random, node));
            assert!(nodes[node].send(&sim, &frames[frames.len() - 1]), "round {round}: {} has room", NAMES[node]);
        }
        frames.sort_by_key(rank);
        sim.run_for(Time::from_ms(1));
        let log = sim.frames_on_bus();
        let order: Vec<Frame> = log[log.len() - frames.len()..].iter().map(|(_, frame)| *frame).collect();
        assert_eq!(order, frames, "round {round}");
        for node in &nodes {
            while node.receive(&sim).is_some() {}
        }
    }
}
