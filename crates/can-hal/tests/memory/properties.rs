//! Laws of every layout.

use can_hal::memory::{DsPic33CanFdFifo, DsPic33CanFdMemory, LayoutError, MCanMemory, Placed, Start};
use dspic33_canfd_pac::enums::PayloadSize;
use m_can_pac::enums::DataFieldSize;
use proptest::prelude::*;

fn share_bytes(a: &Placed, b: &Placed) -> bool {
    u64::from(a.start) < b.end() && u64::from(b.start) < a.end()
}

proptest! {
    /// A plan has no overlap, ends within the RAM, and is refused only with a reason that is true.
    #[test]
    fn m_can(
        ram in 0u32..70_000, counts in prop::array::uniform7(0u32..80), codes in prop::array::uniform4(0u8..8),
        starts in prop::array::uniform7(prop::option::weighted(0.3, 0u32..70_000)), fifo in 0u32..40,
    ) {
        let size = DataFieldSize::from_bits;
        let at = |start: Option<u32>| start.map_or(Start::Packed, Start::At);
        let memory = MCanMemory::new(ram)
            .standard_filters(counts[0]).standard_filters_at(at(starts[0]))
            .extended_filters(counts[1]).extended_filters_at(at(starts[1]))
            .rx_fifo_0(counts[2], size(codes[0])).rx_fifo_0_at(at(starts[2]))
            .rx_fifo_1(counts[3], size(codes[1])).rx_fifo_1_at(at(starts[3]))
            .rx_buffers(counts[4], size(codes[2])).rx_buffers_at(at(starts[4]))
            .tx_event_fifo(counts[5]).tx_event_fifo_at(at(starts[5]))
            .tx_buffers(counts[6], fifo, size(codes[3])).tx_buffers_at(at(starts[6]));
        match memory.plan() {
            Ok(plan) => {
                let sections: Vec<_> = plan.sections().collect();
                for (i, a) in sections.iter().enumerate() {
                    prop_assert!(a.end() <= u64::from(ram).min(0x1_0000));
                    prop_assert!(a.start.is_multiple_of(4));
                    prop_assert!(sections[..i].iter().all(|b| !share_bytes(a, b)));
                }
                // 2.4.1: the register's bits 15:2 are the word address.
                if counts[0] > 0 {
                    prop_assert_eq!(plan.sidfc.bits() & 0xFFFF, plan.standard_filters().start);
                }
                prop_assert_eq!(u32::from(plan.txbc.ndtb()) + u32::from(plan.txbc.tfqs()), plan.tx_buffers().elements);
            }
            Err(LayoutError::Overlap { first, second }) => {
                prop_assert!(share_bytes(&first, &second) && first.start <= second.start);
            }
            Err(LayoutError::TooLarge { section, end }) => prop_assert!(section.end() > end && end == u64::from(ram)),
            Err(LayoutError::Unreachable { section, end }) => prop_assert!(section.end() > end && end == 0x1_0000),
            Err(LayoutError::Elements { requested, min, max, .. }) => prop_assert!(!(min..=max).contains(&requested)),
            Err(LayoutError::Unaligned { start, alignment, .. }) => prop_assert!(!start.is_multiple_of(alignment)),
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        }
    }

    /// CAN FD Equations 5-17 to 5-24, computed here once more.
    #[test]
    fn canfd_follows_the_equations(
        base in 0u32..0x1000, tef in prop::option::of((1u32..=32, any::<bool>())), txq in prop::option::of((1u32..=32, 0u8..8)),
        fifos in prop::collection::btree_map(1u8..=31, (1u32..=32, 0u8..8, 0u8..3), 0..8),
    ) {
        const BYTES: [u32; 8] = [8, 12, 16, 20, 24, 32, 48, 64];
        let base = base * 4;
        let mut memory = DsPic33CanFdMemory::new(base, 0x2_0000);
        let mut next = base;
        if let Some((elements, timestamps)) = tef {
            memory = memory.tef(elements, timestamps);
            next += elements * if timestamps { 12 } else { 8 };
        }
        if let Some((elements, code)) = txq {
            memory = memory.txq(elements, PayloadSize::from_bits(code));
            next += elements * (8 + BYTES[usize::from(code)]);
        }
        for (&number, &(elements, code, kind)) in &fifos {
            let payload = PayloadSize::from_bits(code);
            memory = memory.fifo(number, match kind {
                0 => DsPic33CanFdFifo::Transmit { elements, payload },
                kind => DsPic33CanFdFifo::Receive { elements, payload, timestamps: kind == 2 },
            });
        }
        let plan = memory.plan().map_err(|error| TestCaseError::fail(error.to_string()))?;
        for number in 1..=fifos.keys().last().copied().unwrap_or(0) {
            let placed = plan.fifo(number).expect("it takes room").placed;
            prop_assert_eq!(placed.start, next);
            let (elements, code, kind) = fifos.get(&number).copied().unwrap_or((1, 0, 1));
            next += elements * (8 + BYTES[usize::from(code)] + if kind == 2 { 4 } else { 0 });
        }
        prop_assert_eq!(plan.end(), next);
    }
}
