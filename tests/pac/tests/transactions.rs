//! What an operation does on the bus: kind, width, offset and value of every access, with the values worked out from
//! the manuals' register pages.

use std::panic::{AssertUnwindSafe, catch_unwind};

use canpac_pac_tests::{Access, Recorder, read, write};
use dspic33_canfd_pac::Dspic33Canfd;
use dspic33_ecan_pac::Dspic33Ecan;
use m_can_pac::MCan;
use pic32_can_pac::Pic32Can;

/// The accesses of an operation.
fn accesses(recorder: &Recorder, operation: impl FnOnce(&Recorder)) -> Vec<Access> {
    operation(recorder);
    recorder.take()
}

/// What a panic says.
fn panic_of(operation: impl FnOnce()) -> String {
    let payload = catch_unwind(AssertUnwindSafe(operation)).expect_err("the operation panics");
    payload
        .downcast_ref::<&str>()
        .map(ToString::to_string)
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .expect("text")
}

mod m_can {
    use m_can_pac::enums::IdFormat;
    use m_can_pac::messages::{RxBuffer, TxBuffer, TxBufferT0};
    use m_can_pac::registers::{Ie, Ir, Nbtp, Rxf0a, Sidfc, Txbar};

    use super::*;

    #[test]
    fn clearing_flags_is_one_write_of_these_flags() {
        let bus = Recorder::holding(32, 0x50, 0x0000_00FF);
        let log = accesses(&bus, |bus| MCan::new(bus).ir().clear(Ir::RF0N | Ir::RF1N));
        assert_eq!(log, [write(32, 0x50, 0x0000_0011)]);
    }

    #[test]
    fn testing_a_flag_is_one_read() {
        let bus = Recorder::holding(32, 0x50, 0x0000_0001);
        let log = accesses(&bus, |bus| assert!(MCan::new(bus).ir().read().contains(Ir::RF0N)));
        assert_eq!(log, [read(32, 0x50, 1)]);
    }

    #[test]
    fn a_constant_is_written_as_one_word() {
        const TIMING: Nbtp = Nbtp::RESET.with_nsjw(7).with_nbrp(3).with_ntseg1(62).with_ntseg2(15);
        let log = accesses(&Recorder::new(), |bus| MCan::new(bus).nbtp().write(TIMING));
        // NSJW 31:25, NBRP 24:16, NTSEG1 15:8, NTSEG2 6:0.
        assert_eq!(log, [write(32, 0x1C, (7 << 25) | (3 << 16) | (62 << 8) | 15)]);
    }

    #[test]
    fn modify_is_one_read_and_one_write() {
        let bus = Recorder::holding(32, 0x54, 0x0000_0100);
        let log = accesses(&bus, |bus| MCan::new(bus).ie().modify(|r| r | Ie::RF0NE));
        assert_eq!(log, [read(32, 0x54, 0x100), write(32, 0x54, 0x101)]);
    }

    #[test]
    fn a_request_is_one_write() {
        let bus = Recorder::holding(32, 0xD0, 0x0000_0002);
        let log = accesses(&bus, |bus| MCan::new(bus).txbar().request(Txbar::ar_bit(5)));
        assert_eq!(log, [write(32, 0xD0, 0x20)]);
    }

    #[test]
    fn acknowledging_a_fifo_element_writes_its_index() {
        let bus = Recorder::holding(32, 0xA4, (3 << 8) | 1);
        let log = accesses(&bus, |bus| {
            let can = MCan::new(bus);
            let index = can.rxf0s().read().f0gi();
            can.rxf0a().write(Rxf0a::RESET.with_f0ai(index));
        });
        assert_eq!(log, [read(32, 0xA4, 0x301), write(32, 0xA8, 3)]);
    }

    #[test]
    fn one_byte_of_a_register_with_read_effects() {
        // ECR.CEL is byte 2 and is cleared by a read of that byte; TEC is byte 0.
        let bus = Recorder::holding(32, 0x40, 0x0055_1234);
        let log = accesses(&bus, |bus| assert_eq!(MCan::new(bus).ecr().read_byte(0), 0x34));
        assert_eq!(log, [read(8, 0x40, 0x34)]);
        let log = accesses(&bus, |bus| assert_eq!(MCan::new(bus).ecr().read_byte(2), 0x55));
        assert_eq!(log, [read(8, 0x42, 0x55)]);
        let message = panic_of(|| {
            let _ = MCan::new(&bus).ecr().read_byte(4);
        });
        assert_eq!(message, "the register has no such byte");
        assert_eq!(bus.take(), [], "a refused read reaches no register");
    }

    #[test]
    #[allow(unsafe_code, reason = "the recorder accesses no memory")]
    fn an_address_register_is_one_write() {
        let value = Sidfc::RESET.with_lss(4).with_flssa(0x10);
        // SAFETY: nothing is behind the recorder.
        let log = accesses(&Recorder::new(), |bus| unsafe { MCan::new(bus).sidfc().write_unsafe(value) });
        // LSS 23:16, FLSSA 15:2.
        assert_eq!(log, [write(32, 0x84, (4 << 16) | (0x10 << 2))]);
    }

    #[test]
    fn an_out_of_range_setter_says_what_is_allowed() {
        assert_eq!(
            panic_of(|| {
                let _ = Nbtp::RESET.with_nsjw(200);
            }),
            "NBTP.NSJW takes 0..=127"
        );
        assert_eq!(
            panic_of(|| {
                let _ = Txbar::ar_bit(32);
            }),
            "TXBAR.AR takes 0..=31"
        );
    }

    #[test]
    fn message_elements_are_written_word_by_word() {
        let log = accesses(&Recorder::new(), |bus| {
            let element = TxBuffer::new(bus, 0x100);
            element.t0().write(TxBufferT0::RESET.with_xtd(IdFormat::from_bits(1)).with_id(0x1234_5678));
            assert_eq!(element.payload(0).write(&[1, 2, 3, 4, 5], 0xCC), 5);
        });
        assert_eq!(
            log,
            [write(32, 0x100, 0x4000_0000 | 0x1234_5678), write(32, 0x108, 0x0403_0201), write(32, 0x10C, 0xCCCC_CC05),]
        );
    }

    #[test]
    fn payloads_are_read_word_by_word() {
        let bus = Recorder::holding(32, 0x208, 0x0403_0201);
        bus.put(32, 0x20C, 0x0807_0605);
        let mut data = [0; 6];
        let log = accesses(&bus, |bus| assert_eq!(RxBuffer::new(bus, 0x200).payload(0).read(&mut data), 6));
        assert_eq!(data, [1, 2, 3, 4, 5, 6]);
        assert_eq!(log, [read(32, 0x208, 0x0403_0201), read(32, 0x20C, 0x0807_0605)]);
    }

    #[test]
    fn a_payload_never_leaves_its_element() {
        let bus = Recorder::new();
        // Code 1 is 12 bytes of payload.
        let payload = TxBuffer::new(&bus, 0).payload(1);
        assert_eq!(payload.capacity(), 12);
        assert_eq!(payload.write(&[0xAA; 64], 0), 12);
        let log = bus.take();
        assert_eq!(log.iter().map(|access| access.offset).collect::<Vec<_>>(), [8, 12, 16]);
        assert_eq!(payload.read(&mut [0; 64]), 12);
        assert_eq!(bus.take().len(), 3);
    }
}

mod dspic33_canfd {
    use dspic33_canfd_pac::registers::{FifobaL, FltCon, IntL, TxreqL};

    use super::*;

    #[test]
    fn clearing_flags_is_one_write_of_the_complement() {
        let bus = Recorder::holding(16, 0x38 - 0x1C, 0xFFFF);
        let log = accesses(&bus, |bus| Dspic33Canfd::new(bus).int_l().clear(IntL::WAKIF));
        // IVMIF 15, WAKIF 14, CERRIF 13, SERRIF 12, MODIF 3, TBCIF 2 are cleared by 0; WAKIF alone is.
        assert_eq!(log, [write(16, 0x1C, 0xB00C)]);
    }

    #[test]
    fn a_flag_that_rises_meanwhile_survives() {
        // What a read-modify-write would lose: TBCIF rises after software looked.
        let bus = Recorder::holding(16, 0x1C, 0x4000);
        bus.raise_after_read(0x1C, 0x0004);
        let can = Dspic33Canfd::new(&bus);
        let seen = can.int_l().read();
        assert!(!seen.contains(IntL::TBCIF));
        can.int_l().clear(seen);
        let written = bus.take().last().copied().expect("the write");
        assert_eq!(written, write(16, 0x1C, 0xB00C), "TBCIF is written as 1, which does nothing");
    }

    #[test]
    fn requests_are_one_write() {
        let bus = Recorder::holding(16, 0x30, 0x0001);
        let log =
            accesses(&bus, |bus| Dspic33Canfd::new(bus).txreq_l().request(TxreqL::ZERO | TxreqL::from_bits(0x0008)));
        assert_eq!(log, [write(16, 0x30, 0x0008)]);
    }

    #[test]
    fn halves_are_accessed_low_first() {
        let log = accesses(&Recorder::new(), |bus| Dspic33Canfd::new(bus).write_nbtcfg(0x1234_5678));
        assert_eq!(log, [write(16, 0x04, 0x5678), write(16, 0x06, 0x1234)]);
        let bus = Recorder::holding(16, 0x04, 0x5678);
        bus.put(16, 0x06, 0x1234);
        let log = accesses(&bus, |bus| assert_eq!(Dspic33Canfd::new(bus).read_nbtcfg(), 0x1234_5678));
        assert_eq!(log, [read(16, 0x04, 0x5678), read(16, 0x06, 0x1234)]);
    }

    #[test]
    #[allow(unsafe_code, reason = "the recorder accesses no memory")]
    fn an_address_in_halves() {
        // SAFETY: nothing is behind the recorder.
        let log = accesses(&Recorder::new(), |bus| unsafe { Dspic33Canfd::new(bus).write_fifoba(0x0001_2340) });
        assert_eq!(log, [write(16, 0x4C, 0x2340), write(16, 0x4E, 0x0001)]);
        // SAFETY: as above.
        let log = accesses(&Recorder::new(), |bus| unsafe {
            Dspic33Canfd::new(bus).fifoba_l().write_unsafe(FifobaL::from_bits(0x2340));
        });
        assert_eq!(log, [write(16, 0x4C, 0x2340)]);
    }

    #[test]
    fn a_joined_value_keeps_its_neighbours() {
        // EID[4:0] is FLTOBJL[15:11], EID[17:5] is FLTOBJH[12:0]; SID and EXIDE stay.
        let can_offset = Dspic33Canfd::new(&Recorder::new()).flt(2).obj_l().offset();
        let bus = Recorder::holding(16, can_offset, 0x0123);
        bus.put(16, can_offset + 2, 0x4000);
        let log = accesses(&bus, |bus| Dspic33Canfd::new(bus).flt(2).write_eid(0x3_FFFF));
        assert_eq!(
            log,
            [
                read(16, can_offset, 0x0123),
                write(16, can_offset, 0xF923),
                read(16, can_offset + 2, 0x4000),
                write(16, can_offset + 2, 0x5FFF),
            ]
        );
        assert_eq!(panic_of(|| Dspic33Canfd::new(&bus).flt(2).write_eid(0x4_0000)), "EID has 18 bits");
    }

    #[test]
    fn clusters_and_lanes() {
        let bus = Recorder::new();
        let can = Dspic33Canfd::new(&bus);
        // Manual numbers: FIFOs 1 to 31, 12 bytes apart.
        assert_eq!(can.fifo(2).con_l().offset() - can.fifo(1).con_l().offset(), 12);
        assert_eq!(can.fifo(31).sta().offset() - can.fifo(1).sta().offset(), 30 * 12);
        assert_eq!(
            panic_of(|| {
                let _ = can.fifo(0);
            }),
            "fifo takes 1..=31"
        );
        assert_eq!(
            panic_of(|| {
                let _ = can.fifo(32);
            }),
            "fifo takes 1..=31"
        );
        // Two filters to a register.
        let (register, lane) = can.flt_con_of(5);
        assert_eq!((register.offset(), lane), (can.flt_con(2).offset(), 1));
        assert_eq!(FltCon::RESET.with_flten(1, true).bits(), 0x8000);
        assert_eq!(
            panic_of(|| {
                let _ = FltCon::RESET.with_flten(2, true);
            }),
            "FLTCON.FLTEN takes 0..=1"
        );
        assert_eq!(
            panic_of(|| {
                let _ = can.flt_con_of(32);
            }),
            "flt_con_of takes 0..=31"
        );
        assert_eq!(bus.take(), [], "naming a register does not access it");
    }
}

mod dspic33_ecan {
    use dspic33_ecan_pac::messages::TxBuffer;
    use dspic33_ecan_pac::registers::{Ctrl1, Intf, RxfSid, Rxful};

    use super::*;

    #[test]
    fn releasing_a_buffer_is_one_write_of_the_complement() {
        let bus = Recorder::holding(16, 0x20, 0xFFFF);
        let log = accesses(&bus, |bus| Dspic33Ecan::new(bus).rxful(1).clear(Rxful::rxful_bit(3)));
        assert_eq!(log, [write(16, 0x20, 0xFFF7)]);
    }

    #[test]
    fn clearing_an_interrupt_flag_leaves_the_others() {
        let bus = Recorder::holding(16, 0x0A, 0x00FF);
        let log = accesses(&bus, |bus| Dspic33Ecan::new(bus).intf().clear(Intf::RBIF));
        // Flags are IVRIF 7, WAKIF 6, ERRIF 5, FIFOIF 3, RBOVIF 2, RBIF 1, TBIF 0.
        assert_eq!(log, [write(16, 0x0A, 0x00ED)]);
    }

    /// CTRL1 in configuration mode with CSIDL: REQOP and OPMODE are 4.
    const CTRL1: u32 = 0x2480;

    #[test]
    fn the_window_is_two_read_modify_writes_of_ctrl1() {
        let bus = Recorder::holding(16, 0x00, CTRL1);
        let log = accesses(&bus, |bus| {
            Dspic33Ecan::new(bus).filter_window(|w| w.rxf_sid(0).write(RxfSid::RESET.with_sid(0x123)));
        });
        assert_eq!(
            log,
            [
                read(16, 0x00, CTRL1),
                write(16, 0x00, 0x2401),
                write(16, 0x40, 0x123 << 5),
                read(16, 0x00, 0x2401),
                write(16, 0x00, 0x2400),
            ]
        );
    }

    #[test]
    fn the_window_closes_when_the_closure_panics() {
        let bus = Recorder::holding(16, 0x00, CTRL1);
        let message = panic_of(|| {
            Dspic33Ecan::new(&bus).filter_window(|w| w.rxf_sid(16).write(RxfSid::RESET));
        });
        assert_eq!(message, "rxf_sid takes 0..=15");
        let log = bus.take();
        assert_eq!(
            log,
            [read(16, 0x00, CTRL1), write(16, 0x00, 0x2401), read(16, 0x00, 0x2401), write(16, 0x00, 0x2400)]
        );
    }

    #[test]
    fn the_window_returns_what_the_closure_returns() {
        let bus = Recorder::holding(16, 0x42, 0xBEEF);
        assert_eq!(Dspic33Ecan::new(&bus).filter_window(|w| w.rxf_eid(0).read().bits()), 0xBEEF);
    }

    #[test]
    fn modify_writes_requests_as_neutral() {
        // A modify of CTRL1 must not repeat a pending ABAT.
        let bus = Recorder::holding(16, 0x00, CTRL1 | 0x1000);
        let log = accesses(&bus, |bus| Dspic33Ecan::new(bus).ctrl1().modify(|r| r.with_cancap(true)));
        assert_eq!(log, [read(16, 0x00, 0x3480), write(16, 0x00, 0x2408)]);
        // Asked for, it is made.
        bus.put(16, 0x00, CTRL1);
        let log = accesses(&bus, |bus| Dspic33Ecan::new(bus).ctrl1().modify(|r| r | Ctrl1::ABAT));
        assert_eq!(log, [read(16, 0x00, CTRL1), write(16, 0x00, 0x3400)]);
    }

    #[test]
    fn an_identifier_over_two_filter_registers() {
        let bus = Recorder::holding(16, 0x00, CTRL1);
        Dspic33Ecan::new(&bus).filter_window(|w| w.write_rxf_id(1, 0x1ABD_DEF0));
        // EID[15:0] in RXFnEID; EID[17:16] in RXFnSID[1:0]; SID in RXFnSID[15:5].
        assert_eq!(bus.peek(16, 0x46), 0xDEF0);
        assert_eq!(bus.peek(16, 0x44), ((0x1ABD_DEF0 >> 18) << 5) | ((0x1ABD_DEF0 >> 16) & 3));
        assert!(bus.take().iter().all(|access| access.bits == 16));
    }

    #[test]
    fn message_memory_is_16_bit_wide() {
        let bus = Recorder::new();
        assert_eq!(TxBuffer::new(&bus, 0x20).payload().write(&[1, 2, 3], 0), 3);
        assert_eq!(bus.take(), [write(16, 0x26, 0x0201), write(16, 0x28, 0x0003)]);
    }
}

mod pic32_can {
    use pic32_can_pac::registers::{FifoCon, FifoInt};

    use super::*;

    #[test]
    fn bits_are_set_cleared_and_inverted_through_the_aliases() {
        let bus = Recorder::holding(32, 0x350 + 0x40 * 2, 0x0000_0080);
        let fifo_con = 0x350 + 0x40 * 2;
        let bits = FifoCon::TXREQ | FifoCon::UINC;
        let log = accesses(&bus, |bus| Pic32Can::new(bus).fifo(2).con().set_bits(bits));
        assert_eq!(log, [write(32, fifo_con + 8, 0x2008)]);
        let log = accesses(&bus, |bus| Pic32Can::new(bus).fifo(2).con().clear_bits(FifoCon::TXREQ));
        assert_eq!(log, [write(32, fifo_con + 4, 0x0008)]);
        let log = accesses(&bus, |bus| Pic32Can::new(bus).fifo(2).con().invert_bits(FifoCon::FRESET));
        assert_eq!(log, [write(32, fifo_con + 12, 0x4000)]);
    }

    #[test]
    fn the_interrupt_register_of_a_fifo_stands_beside_its_control() {
        let bus = Recorder::holding(32, 0x350 + 0x10, 0x0000_0001);
        let log = accesses(&bus, |bus| {
            assert!(Pic32Can::new(bus).fifo(0).int_().read().contains(FifoInt::RXNEMPTYIF));
        });
        assert_eq!(log, [read(32, 0x360, 1)]);
    }
}

/// Every access of the 16-bit controllers is 16 bits wide, whatever the operation.
#[test]
fn the_dspic_controllers_are_accessed_in_16_bits() {
    let bus = Recorder::new();
    let can = Dspic33Canfd::new(&bus);
    let _ = (can.read_tbc(), can.read_vec(), can.read_trec(), can.con_h().read());
    can.write_dbtcfg(0x0102_0304);
    can.con_l().modify(|r| r);
    can.flt(7).write_obj(0x1FFF_FFFF);
    can.flt(7).write_sid12(0xFFF);
    let _ = can.fifo(3).read_ua();
    let mut ecan = Dspic33Ecan::new(&bus);
    ecan.filter_window(|w| {
        let _ = w.read_rxf_id(3);
        w.write_rxm_eid18(1, 0x3_FFFF);
    });
    let log = bus.take();
    assert!(log.len() > 20, "{log:?}");
    assert!(log.iter().all(|access| access.bits == 16), "{log:?}");
}
