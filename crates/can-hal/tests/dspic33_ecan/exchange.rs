//! Two modules under load, driven through the HAL: queue on one side, FIFO on the other, both ways.

use std::collections::VecDeque;

use can_hal::{
    Frame, Receive, SendError, Transmit,
    dspic33_ecan::{Can, Config, Mask},
    mode::Running,
};
use can_sim::{Memory, MemoryBus, RegisterBus, Sim, Time, dspic33_ecan::EcanConfig};

use crate::bench::{BYTES, MODE, PLAN, TIMING, TO_FIFO};

const FRAMES: u32 = 3_000;

/// Every frame is different, and the two sides never use the same identifier.
fn numbered(side: u32, number: u32) -> Frame {
    let scattered = number.wrapping_mul(0x9E37_79B1);
    let data = &[number.to_le_bytes(), scattered.to_le_bytes()].concat()[..4 + scattered as usize % 5];
    if scattered & 1 == 0 {
        let id = (scattered >> 8 & 0x7FE | side) as u16;
        Frame::data(can_hal::StandardId::new(id).unwrap(), data).unwrap()
    } else {
        let id = scattered >> 2 & 0x1FFF_FFFE | side;
        Frame::data(can_hal::ExtendedId::new(id).unwrap(), data).unwrap()
    }
}

struct Side<'a> {
    can: Can<Running, RegisterBus<'a>, MemoryBus<'a>>,
    side: u32,
    sent: u32,
    /// What has to arrive here.
    expected: VecDeque<Frame>,
    last: Option<Frame>,
    twice: u32,
}

impl<'a> Side<'a> {
    #[allow(unsafe_code, reason = "a simulated memory of its own")]
    fn new(sim: &'a Sim, side: u32, noise: f64) -> Self {
        let ram = sim.add_memory(Memory::new(BYTES as usize / 4).with_widths(&[8, 16]));
        let id = sim.add_dspic33_ecan("can", EcanConfig::new(ram)).unwrap();
        let node = sim.node(id);
        sim.with_wire(|wire| wire.set_noise(node, noise, 11));
        // SAFETY: nothing else uses this memory.
        let region = unsafe { can_hal::Region::new(sim.memory(ram), 0, BYTES) };
        let mut can = Can::new(sim.registers(id), region, &PLAN, MODE).unwrap();
        can.configure(&Config::new(TIMING).with_queue(4).with_filters([Mask::ANY; 3], TO_FIFO)).unwrap();
        let can = can.start_normal(MODE).unwrap();
        Self { can, side, sent: 0, expected: VecDeque::new(), last: None, twice: 0 }
    }

    fn fill(&mut self, other: &mut Self) {
        while self.sent < FRAMES {
            let frame = numbered(self.side, self.sent);
            match self.can.send(&frame) {
                Ok(_) => {
                    other.expected.push_back(frame);
                    self.sent += 1;
                }
                Err(SendError::Full) => return,
                Err(error) => panic!("{error}"),
            }
        }
    }

    /// A sender that meets an error in the last bit of EOF sends again what the other side has received (CAN 2.0B).
    fn drain(&mut self) {
        while let Some(message) = self.can.fetch().unwrap() {
            if self.expected.front() != Some(&message.frame) && self.last == Some(message.frame) {
                self.twice += 1;
                continue;
            }
            assert_eq!(Some(message.frame), self.expected.pop_front());
            self.last = Some(message.frame);
        }
    }
}

fn exchange(noise: f64) -> u32 {
    let sim = Sim::new();
    let (mut a, mut b) = (Side::new(&sim, 0, noise), Side::new(&sim, 1, noise));
    let mut rounds = 0;
    while a.sent < FRAMES || b.sent < FRAMES || !a.expected.is_empty() || !b.expected.is_empty() {
        a.fill(&mut b);
        b.fill(&mut a);
        a.drain();
        b.drain();
        sim.run_for(Time::from_us(rounds % 11 * 20));
        rounds += 1;
        assert!(rounds < 200_000, "{}", a.expected.len() + b.expected.len());
    }
    assert_eq!(sim.diagnostics(), []);
    a.twice + b.twice
}

#[test]
fn nothing_is_lost_or_reordered() {
    assert_eq!(exchange(0.0), 0);
}

#[test]
fn nothing_is_lost_under_bit_errors() {
    assert!(exchange(0.000_1) < 10);
}
