//! What is impossible, and what is said about it.

use can_hal::memory::{
    DsPic33CanFdFifo, DsPic33CanFdMemory, DsPic33EcanMemory, MCanMemory, Pic32CanFifo, Pic32CanMemory, Start,
};
use dspic33_canfd_pac::enums::PayloadSize;
use dspic33_ecan_pac::enums::BufferCount;
use m_can_pac::enums::DataFieldSize;

fn m_can(memory: MCanMemory) -> String {
    memory.plan().expect_err("this is impossible").to_string()
}

#[test]
fn m_can_overlap_names_both() {
    let memory = MCanMemory::new(0x1000).standard_filters(28).rx_fifo_0(4, DataFieldSize::Bytes8);
    assert_eq!(
        m_can(memory.rx_fifo_0_at(Start::At(0x60))),
        "standard filters (0x0 to 0x6f) and rx fifo 0 (0x60 to 0x9f) overlap"
    );
    // The order of the list is not that of the addresses.
    let memory = MCanMemory::new(0x1000).standard_filters(28).tx_event_fifo(4).standard_filters_at(Start::At(0x110));
    assert_eq!(
        m_can(memory.tx_event_fifo_at(Start::At(0x100))),
        "tx event fifo (0x100 to 0x11f) and standard filters (0x110 to 0x17f) overlap"
    );
    assert!(memory.tx_event_fifo_at(Start::At(0xF0)).plan().is_ok(), "side by side");
}

#[test]
fn m_can_ram_and_window() {
    let memory = MCanMemory::new(0x100).rx_fifo_0(4, DataFieldSize::Bytes64);
    assert_eq!(m_can(memory), "rx fifo 0 ends at 0x11f, but the RAM at 0xff: 32 bytes are missing");
    let far = MCanMemory::new(0x2_0000).standard_filters(1).standard_filters_at(Start::At(0x1_0000));
    assert_eq!(
        m_can(far),
        "standard filters ends at 0x10003, behind 0xffff, the last byte that a start address can reach"
    );
    let last = MCanMemory::new(0x1_0000)
        .standard_filters(1)
        .standard_filters_at(Start::At(0xFFFC))
        .plan()
        .expect("the last word");
    assert_eq!(last.sidfc.bits(), 0x0001_FFFC);
    let huge = MCanMemory::new(u32::MAX).standard_filters(128).standard_filters_at(Start::At(u32::MAX - 3));
    assert!(m_can(huge).contains("behind 0xffff"));
}

#[test]
fn m_can_numbers_and_alignment() {
    assert_eq!(
        m_can(MCanMemory::new(0x1000).standard_filters(129)),
        "standard filters: 129 elements, but it takes 0 to 128"
    );
    let buffers = MCanMemory::new(0x1_0000).tx_buffers(20, 13, DataFieldSize::Bytes8);
    assert_eq!(m_can(buffers), "tx buffers: 33 elements, but it takes 0 to 32");
    assert!(m_can(MCanMemory::new(0x1_0000).tx_buffers(u32::MAX, 1, DataFieldSize::Bytes8)).contains("elements"));
    let odd = MCanMemory::new(0x1000).extended_filters(1).extended_filters_at(Start::At(0x22));
    assert_eq!(m_can(odd), "extended filters: starts at 0x22, which is no multiple of 4");
}

#[test]
fn canfd() {
    let fifo = |elements| DsPic33CanFdFifo::Transmit { elements, payload: PayloadSize::Bytes8 };
    let error = |memory: DsPic33CanFdMemory| memory.plan().expect_err("this is impossible").to_string();
    let memory = DsPic33CanFdMemory::new(0x1000, 0x100);
    assert_eq!(error(memory.fifo(32, fifo(1))), "there is no FIFO 32: the numbers are 1 to 31");
    assert_eq!(error(memory.fifo(0, fifo(1))), "there is no FIFO 0: the numbers are 1 to 31");
    assert_eq!(error(memory.fifo(1, fifo(0))), "fifo 1: 0 elements, but it takes 1 to 32");
    assert_eq!(error(memory.txq(33, PayloadSize::Bytes8)), "txq: 33 elements, but it takes 1 to 32");
    assert_eq!(error(DsPic33CanFdMemory::new(0x1002, 0x100)), "tef: starts at 0x1002, which is no multiple of 4");
    assert_eq!(error(memory.fifo(1, fifo(17))), "fifo 1 ends at 0x110f, but the RAM at 0x10ff: 16 bytes are missing");
    assert!(error(DsPic33CanFdMemory::new(0xFFFF_FFF0, u32::MAX).fifo(1, fifo(2))).contains("can reach"));
}

#[test]
fn pic32() {
    let error = |memory: Pic32CanMemory| memory.plan().expect_err("this is impossible").to_string();
    let memory = Pic32CanMemory::new(0x1000, 0x100);
    assert_eq!(
        error(memory.fifo(32, Pic32CanFifo::Transmit { elements: 1 })),
        "there is no FIFO 32: the numbers are 0 to 31"
    );
    assert_eq!(
        error(memory.fifo(0, Pic32CanFifo::Receive { elements: 33 })),
        "fifo 0: 33 elements, but it takes 1 to 32"
    );
    assert_eq!(
        error(memory.fifo(1, Pic32CanFifo::ReceiveData { elements: 31 })),
        "fifo 1 ends at 0x1107, but the RAM at 0x10ff: 8 bytes are missing"
    );
    assert_eq!(error(Pic32CanMemory::new(0x1001, 0x100)), "fifo 0: starts at 0x1001, which is no multiple of 4");
}

#[test]
fn ecan() {
    let plan = |start, ram, fifo| DsPic33EcanMemory::new(start, ram, BufferCount::Buffers12, fifo);
    let error = |memory: DsPic33EcanMemory| memory.plan().expect_err("this is impossible").to_string();
    assert_eq!(error(plan(0, 0xB0, 0)), "buffers ends at 0xbf, but the RAM at 0xaf: 16 bytes are missing");
    assert_eq!(error(plan(0, 0x800, 12)), "the FIFO cannot start at buffer 12 of 12");
    assert_eq!(error(plan(0x80, 0x800, 0)), "buffers: starts at 0x80, which is no multiple of 256");
    assert!(plan(0x80, 0x800, 0).unaligned().plan().is_ok());
    assert!(plan(0x81, 0x800, 0).unaligned().plan().is_err(), "words have even addresses");
}
