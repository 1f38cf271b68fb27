//! Every address example of the manuals, with the printed numbers.

use can_hal::memory::{
    DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33CanFdPlan, DsPic33EcanMemory, DsPic33EcanPlan, MCanMemory, MCanPlan,
    Pic32CanFifo, Pic32CanMemory, Pic32CanPlan, Placed, Start,
};
use dspic33_canfd_pac::enums::PayloadSize;
use dspic33_ecan_pac::enums::BufferCount;
use m_can_pac::enums::DataFieldSize;

fn addresses(section: &Placed) -> Vec<u32> {
    (0..section.elements).filter_map(|index| section.element(index)).collect()
}

/// M_CAN 2.4: all sections at their largest come to 4352 words, the most that one M_CAN uses.
#[test]
fn m_can_largest_layout() {
    const PLAN: MCanPlan = MCanMemory::new(4352 * 4)
        .standard_filters(128)
        .extended_filters(64)
        .rx_fifo_0(64, DataFieldSize::Bytes64)
        .rx_fifo_1(64, DataFieldSize::Bytes64)
        .rx_buffers(64, DataFieldSize::Bytes64)
        .tx_event_fifo(32)
        .tx_buffers(0, 32, DataFieldSize::Bytes64)
        .fixed();
    assert_eq!(PLAN.end(), 4352 * 4);
    assert_eq!(PLAN.sections().count(), 7);
}

/// M_CAN 2.4.1: the bits 15:2 of a register are the word address, so that the register's low half reads as a byte offset.
#[test]
fn m_can_register_values() {
    let plan = MCanMemory::new(0x14A0)
        .standard_filters(28)
        .extended_filters(8)
        .rx_fifo_0(32, DataFieldSize::Bytes64)
        .rx_fifo_1(4, DataFieldSize::Bytes64)
        .rx_buffers(2, DataFieldSize::Bytes64)
        .tx_event_fifo(8)
        .tx_buffers(12, 20, DataFieldSize::Bytes64)
        .plan()
        .expect("it fits to the byte");
    assert_eq!(plan.sidfc.bits(), 0x001C_0000);
    assert_eq!(plan.xidfc.bits(), 0x0008_0070);
    assert_eq!(plan.rxf0c.bits(), 0x0020_00B0);
    assert_eq!(plan.rxf1c.bits(), 0x0004_09B0);
    assert_eq!(plan.rxbc.bits(), 0x0000_0AD0);
    assert_eq!(plan.rxesc.bits(), 0x0000_0777);
    assert_eq!(plan.txefc.bits(), 0x0008_0B60);
    // 2.3.35: 12 dedicated buffers and a FIFO of 20, as in the note of 2.3.36.
    assert_eq!(plan.txbc.bits(), 0x140C_0BA0);
    assert_eq!(plan.txesc.bits(), 0x0000_0007);
    assert_eq!(plan.end(), 0x14A0);
    // 3.4.2, 2.4.6, 3.4.3, 3.5.8, 3.5.2: start plus index times size.
    assert_eq!(plan.rx_fifo_0().element(5), Some(0x218));
    assert_eq!(plan.extended_filters().element(3), Some(0x088));
    assert_eq!(plan.rx_buffers().element(1), Some(0xB18));
    assert_eq!(plan.tx_event_fifo().element(7), Some(0xB98));
    assert_eq!(plan.tx_buffers().element(15), Some(0xFD8));
    assert_eq!(plan.tx_buffers().element(32), None);
}

/// M_CAN Tables 55 and 59: words of an element for each data field size.
#[test]
fn m_can_element_sizes() {
    let sizes = [
        (DataFieldSize::Bytes8, 4),
        (DataFieldSize::Bytes12, 5),
        (DataFieldSize::Bytes16, 6),
        (DataFieldSize::Bytes20, 7),
        (DataFieldSize::Bytes24, 8),
        (DataFieldSize::Bytes32, 10),
        (DataFieldSize::Bytes48, 14),
        (DataFieldSize::Bytes64, 18),
    ];
    for (size, words) in sizes {
        let plan = MCanMemory::new(0x1_0000)
            .rx_fifo_0(1, size)
            .rx_fifo_1(1, DataFieldSize::Bytes8)
            .rx_buffers(1, size)
            .tx_buffers(1, 0, size)
            .plan()
            .expect("there is room");
        let [first, second, third, last] =
            [plan.rx_fifo_0(), plan.rx_fifo_1(), plan.rx_buffers(), plan.tx_buffers()].map(|s| s.bytes() / 4);
        assert_eq!((first, second, third, last), (words, 4, words, words));
    }
}

/// M_CAN 2.4: any order, and RAM that several controllers share.
#[test]
fn m_can_shared_ram() {
    let first = MCanMemory::new(0x1000).standard_filters(16).rx_fifo_0(8, DataFieldSize::Bytes8).plan().expect("fits");
    let second = MCanMemory::new(0x1000)
        .origin(first.end())
        .standard_filters(16)
        .rx_fifo_0(8, DataFieldSize::Bytes8)
        .standard_filters_at(Start::At(0x800))
        .rx_fifo_0_at(Start::At(first.end()))
        .plan()
        .expect("fits");
    assert_eq!((second.standard_filters().start, second.sidfc.flssa()), (0x800, 0x200));
    assert_eq!(second.rx_fifo_0().start, 16 * 4 + 8 * 16);
}

/// CAN FD 5.4.6: an event FIFO of 4 takes 32 bytes, a queue of one object with 12 data bytes 20, a FIFO of 3 objects with 8
/// data bytes 48; together 100.
#[test]
fn canfd_section_5_4_6() {
    let plan = DsPic33CanFdMemory::new(0x1000, 100)
        .tef(4, false)
        .txq(1, PayloadSize::Bytes12)
        .fifo(1, DsPic33CanFdFifo::Transmit { elements: 3, payload: PayloadSize::Bytes8 })
        .plan()
        .expect("100 bytes are enough");
    assert_eq!(plan.sections().map(|s| s.bytes()).collect::<Vec<_>>(), [32, 20, 48]);
    assert_eq!(plan.end(), 0x1000 + 100);
}

/// CAN FD Table 10-1.
const TABLE_10_1: DsPic33CanFdPlan = DsPic33CanFdMemory::new(0x1400, 0x7F8)
    .tef(12, true)
    .txq(8, PayloadSize::Bytes32)
    .fifo(1, DsPic33CanFdFifo::Transmit { elements: 5, payload: PayloadSize::Bytes64 })
    .fifo(2, DsPic33CanFdFifo::Receive { elements: 16, payload: PayloadSize::Bytes64, timestamps: true })
    .fixed();

#[test]
fn canfd_table_10_1() {
    let starts: Vec<_> = TABLE_10_1.sections().map(|s| (s.name.to_string(), s.start, s.element_bytes)).collect();
    let expected = [("tef", 0x1400, 12), ("txq", 0x1490, 40), ("fifo 1", 0x15D0, 72), ("fifo 2", 0x1738, 76)];
    assert_eq!(starts, expected.map(|(name, start, bytes)| (name.to_owned(), start, bytes)));
    assert_eq!(TABLE_10_1.end(), 0x1BF8);
    assert_eq!((TABLE_10_1.stef, TABLE_10_1.txqen, TABLE_10_1.fifoba), (true, true, 0x1400));
    assert_eq!((TABLE_10_1.tefconl.teftsen(), TABLE_10_1.tefconh.fsize()), (true, 11));
    assert_eq!((TABLE_10_1.txqconh.fsize(), TABLE_10_1.txqconh.plsize()), (7, PayloadSize::Bytes32));
    let fifo = TABLE_10_1.fifo(2).expect("FIFO 2");
    assert_eq!((fifo.conh.fsize(), fifo.conh.plsize(), fifo.conl.rxtsen()), (15, PayloadSize::Bytes64, true));
}

/// CAN FD Figures 10-1 to 10-26: the addresses of message objects.
#[test]
fn canfd_object_addresses() {
    let object = |section: Placed, index| section.element(index).expect("there is such an object");
    let [fifo1, fifo2] = [1, 2].map(|number| TABLE_10_1.fifo(number).expect("set up").placed);
    assert_eq!([0, 1, 4].map(|i| object(fifo1, i)), [0x15D0, 0x1618, 0x16F0]);
    assert_eq!([0, 1].map(|i| object(fifo2, i)), [0x1738, 0x1784]);
    let queue = TABLE_10_1.txq.expect("set up");
    assert_eq!([0, 1, 7].map(|i| object(queue, i)), [0x1490, 0x14B8, 0x15A8]);
    let events = TABLE_10_1.tef.expect("set up");
    assert_eq!([0, 1].map(|i| object(events, i)), [0x1400, 0x140C]);
}

/// CAN FD Examples 6-1, 7-1 and 9-1. Example 7-1 sets up 420 bytes in a buffer of 200.
#[test]
fn canfd_code_examples() {
    let transmit = |elements, payload| DsPic33CanFdFifo::Transmit { elements, payload };
    let bytes = |memory: DsPic33CanFdMemory| memory.plan().map(|plan| plan.end());
    let example_6_1 =
        |ram| DsPic33CanFdMemory::new(0, ram).txq(1, PayloadSize::Bytes64).fifo(1, transmit(2, PayloadSize::Bytes16));
    assert_eq!(bytes(example_6_1(200)), Ok(120));
    let example_7_1 = |ram| DsPic33CanFdMemory::new(0, ram).tef(5, true).fifo(1, transmit(5, PayloadSize::Bytes64));
    assert_eq!(bytes(example_7_1(420)), Ok(420));
    assert_eq!(
        bytes(example_7_1(200)).map_err(|error| error.to_string()),
        Err("fifo 1 ends at 0x1a3, but the RAM at 0xc7: 220 bytes are missing".to_owned())
    );
    let receive = DsPic33CanFdFifo::Receive { elements: 2, payload: PayloadSize::Bytes64, timestamps: true };
    assert_eq!(bytes(DsPic33CanFdMemory::new(0, 200).fifo(1, receive)), Ok(152));
}

/// CAN FD Equation 5-24: a FIFO that nobody set up takes one object of 16 bytes in front of one with a higher number.
#[test]
fn canfd_skipped_fifo() {
    let plan = DsPic33CanFdMemory::new(0x2000, 0x1000)
        .fifo(3, DsPic33CanFdFifo::Transmit { elements: 1, payload: PayloadSize::Bytes8 })
        .plan()
        .expect("fits");
    assert_eq!(plan.fifo(3).expect("set up").placed.start, 0x2020);
    assert_eq!(plan.sections().map(|s| s.used).collect::<Vec<_>>(), [false, false, true]);
    assert_eq!(plan.fifo(4), None);
}

/// PIC32 Figure 34-9: base 0x1000; a transmit FIFO of 4, a data-only FIFO of 2, a receive FIFO of 4. The figure calls the
/// last one FIFO3; its addresses are those of FIFO2.
#[test]
fn pic32_figure_34_9() {
    const PLAN: Pic32CanPlan = Pic32CanMemory::new(0x1000, 36 * 4)
        .fifo(0, Pic32CanFifo::Transmit { elements: 4 })
        .fifo(1, Pic32CanFifo::ReceiveData { elements: 2 })
        .fifo(2, Pic32CanFifo::Receive { elements: 4 })
        .fixed();
    let all: Vec<_> = PLAN.sections().map(|section| addresses(&section)).collect();
    assert_eq!(all[0], [0x1000, 0x1010, 0x1020, 0x1030]);
    assert_eq!(all[1], [0x1040, 0x1048]);
    assert_eq!(all[2], [0x1050, 0x1060, 0x1070, 0x1080]);
    assert_eq!(PLAN.end(), 0x1000 + 36 * 4);
    assert_eq!(PLAN.fifoba, 0x1000);
    assert_eq!(PLAN.fifo(1).expect("set up").con.bits(), 0x0001_1000);
}

/// PIC32 Figure 34-10 and Example 34-2: base 0x2000, two transmit FIFOs of 2 and two receive FIFOs of 3; 40 words.
#[test]
fn pic32_figure_34_10() {
    let plan = Pic32CanMemory::new(0x2000, 40 * 4)
        .fifo(0, Pic32CanFifo::Transmit { elements: 2 })
        .fifo(1, Pic32CanFifo::Transmit { elements: 2 })
        .fifo(2, Pic32CanFifo::Receive { elements: 3 })
        .fifo(3, Pic32CanFifo::Receive { elements: 3 })
        .plan()
        .expect("40 words are enough");
    let all: Vec<_> = plan.sections().map(|section| addresses(&section)).collect();
    assert_eq!(all[0], [0x2000, 0x2010]);
    assert_eq!(all[1], [0x2020, 0x2030]);
    assert_eq!(all[2], [0x2040, 0x2050, 0x2060]);
    assert_eq!(all[3], [0x2070, 0x2080, 0x2090]);
    // Example 34-2: FSIZE = 1 with TXEN, and FSIZE = 2 without.
    let con = |number: u8| plan.fifo(number).expect("set up").con.bits();
    assert_eq!((con(0), con(2)), (0x0001_0080, 0x0002_0000));
}

/// PIC32 Figure 34-16: FIFO0 of 4, FIFO1 of 7, all others as after reset.
#[test]
fn pic32_figure_34_16() {
    let plan = Pic32CanMemory::new(0x100, 164 * 4)
        .fifo(0, Pic32CanFifo::Receive { elements: 4 })
        .fifo(1, Pic32CanFifo::Transmit { elements: 7 })
        .fifo(31, Pic32CanFifo::Receive { elements: 1 })
        .plan()
        .expect("164 words are enough");
    let fifo = |number: u8| addresses(&plan.fifo(number).expect("takes room").placed);
    assert_eq!(fifo(0), [0x100, 0x110, 0x120, 0x130]);
    assert_eq!(fifo(1), [0x140, 0x150, 0x160, 0x170, 0x180, 0x190, 0x1A0]);
    assert_eq!((fifo(2), fifo(3), fifo(31)), (vec![0x1B0], vec![0x1C0], vec![0x380]));
    assert_eq!(plan.end(), 0x390);
}

/// PIC32 34.6.1: 29 FIFOs, of which three are 0, 1 and 5, need room for all up to the highest.
#[test]
fn pic32_gaps_cost_memory() {
    let one = Pic32CanFifo::Transmit { elements: 1 };
    let bytes = |numbers: &mut dyn Iterator<Item = u8>| {
        let memory = numbers.fold(Pic32CanMemory::new(0, 0x1000), |memory, number| memory.fifo(number, one));
        memory.plan().expect("fits").end()
    };
    assert_eq!(bytes(&mut (0..2).chain(5..32)), 32 * 16);
    assert_eq!(bytes(&mut (0..29)), 29 * 16);
}

/// ECAN 9.3 and Figure 9-6: 12 buffers, FIFO from buffer 5 to 11. Figures 9-4 and 10-1: buffer n at start + 16 n.
#[test]
fn ecan_figure_9_6() {
    const PLAN: DsPic33EcanPlan = DsPic33EcanMemory::new(0x100, 0x800, BufferCount::Buffers12, 5).fixed();
    assert_eq!(PLAN.fctrl.bits(), 0x6005);
    assert_eq!((PLAN.buffer(0), PLAN.buffer(11), PLAN.buffer(12)), (Some(0x100), Some(0x100 + 16 * 11), None));
    let sections: Vec<_> = PLAN.sections().map(|s| (s.name.to_string(), s.start, s.elements)).collect();
    assert_eq!(sections, [("buffers".to_owned(), 0x100, 5), ("fifo".to_owned(), 0x150, 7)]);
    assert_eq!(PLAN.end(), 0x1C0);
    assert_eq!(DsPic33EcanPlan::TRANSMIT_BUFFERS, 8);
}

/// ECAN 9.3: the seven sizes.
#[test]
fn ecan_sizes() {
    let sizes = [
        (BufferCount::Buffers4, 4),
        (BufferCount::Buffers6, 6),
        (BufferCount::Buffers8, 8),
        (BufferCount::Buffers12, 12),
        (BufferCount::Buffers16, 16),
        (BufferCount::Buffers24, 24),
        (BufferCount::Buffers32, 32),
    ];
    for (size, count) in sizes {
        let plan = DsPic33EcanMemory::new(0, 16 * count, size, 0).plan().expect("fits");
        assert_eq!(plan.end(), 16 * count);
    }
}
