//! The resets that the manuals print for whole registers or bit by bit, against what the fields of the descriptions say.
//!
//! The numbers below were copied from the manuals' register map and bit diagrams, not from the descriptions. Rows that are
//! damaged in a manual's text are left out.

use regbus::meta::{Controller, RegisterInfo};

/// *M_CAN User's Manual* 3.3.1, Table 1 p.5 and p.6: symbol, address, reset. `r` and `d` are digits of the release and its
/// date; the reset of CUST is not given.
const M_CAN: [(&str, u32, &str); 47] = [
    ("CREL", 0x000, "rrrd dddd"),
    ("ENDN", 0x004, "8765 4321"),
    ("CUST", 0x008, "t.b.d."),
    ("DBTP", 0x00C, "0000 0A33"),
    ("TEST", 0x010, "0000 0000"),
    ("RWD", 0x014, "0000 0000"),
    ("CCCR", 0x018, "0000 0001"),
    ("NBTP", 0x01C, "0600 0A03"),
    ("TSCC", 0x020, "0000 0000"),
    ("TSCV", 0x024, "0000 0000"),
    ("TOCC", 0x028, "FFFF 0000"),
    ("TOCV", 0x02C, "0000 FFFF"),
    ("ECR", 0x040, "0000 0000"),
    ("PSR", 0x044, "0000 0707"),
    ("TDCR", 0x048, "0000 0000"),
    ("IR", 0x050, "0000 0000"),
    ("IE", 0x054, "0000 0000"),
    ("ILS", 0x058, "0000 0000"),
    ("ILE", 0x05C, "0000 0000"),
    ("GFC", 0x080, "0000 0000"),
    ("SIDFC", 0x084, "0000 0000"),
    ("XIDFC", 0x088, "0000 0000"),
    ("XIDAM", 0x090, "1FFF FFFF"),
    ("HPMS", 0x094, "0000 0000"),
    ("NDAT1", 0x098, "0000 0000"),
    ("NDAT2", 0x09C, "0000 0000"),
    ("RXF0C", 0x0A0, "0000 0000"),
    ("RXF0S", 0x0A4, "0000 0000"),
    ("RXF0A", 0x0A8, "0000 0000"),
    ("RXBC", 0x0AC, "0000 0000"),
    ("RXF1C", 0x0B0, "0000 0000"),
    ("RXF1S", 0x0B4, "0000 0000"),
    ("RXF1A", 0x0B8, "0000 0000"),
    ("RXESC", 0x0BC, "0000 0000"),
    ("TXBC", 0x0C0, "0000 0000"),
    ("TXFQS", 0x0C4, "0000 0000"),
    ("TXESC", 0x0C8, "0000 0000"),
    ("TXBRP", 0x0CC, "0000 0000"),
    ("TXBAR", 0x0D0, "0000 0000"),
    ("TXBCR", 0x0D4, "0000 0000"),
    ("TXBTO", 0x0D8, "0000 0000"),
    ("TXBCF", 0x0DC, "0000 0000"),
    ("TXBTIE", 0x0E0, "0000 0000"),
    ("TXBCIE", 0x0E4, "0000 0000"),
    ("TXEFC", 0x0F0, "0000 0000"),
    ("TXEFS", 0x0F4, "0000 0000"),
    ("TXEFA", 0x0F8, "0000 0000"),
];

/// *CAN Flexible Data-Rate (FD) Protocol Module*, bit diagrams of Registers 3-1 to 3-55: register, its number, resets from
/// the most significant bit on; `-` is unimplemented and reads 0, `x` is unknown.
const DSPIC33_CANFD: &[(&str, &str, &str)] = &[
    ("CONL", "3-1", "0-000111 01100000"),
    ("CONH", "3-2", "00000100 10011000"),
    ("NBTCFGL", "3-3", "-0001111 -0001111"),
    ("NBTCFGH", "3-4", "00000000 00111100"),
    ("DBTCFGL", "3-5", "----0011 ----0011"),
    ("TDCL", "3-7", "-0010000 --000000"),
    ("TDCH", "3-8", "------00 ------10"),
    ("TBCL", "3-9", "00000000 00000000"),
    ("TBCH", "3-10", "00000000 00000000"),
    ("TSCONL", "3-11", "------00 00000000"),
    ("TSCONH", "3-12", "-------- -----000"),
    ("VECL", "3-13", "---00000 -1000000"),
    ("VECH", "3-14", "-1000000 -1000000"),
    ("INTL", "3-15", "000000-- ---00000"),
    ("INTH", "3-16", "000000-- ---00000"),
    ("RXIFL", "3-17", "00000000 0000000-"),
    ("RXIFH", "3-18", "00000000 00000000"),
    ("RXOVIFL", "3-19", "00000000 0000000-"),
    ("RXOVIFH", "3-20", "00000000 00000000"),
    ("TXIFL", "3-21", "00000000 00000000"),
    ("TXIFH", "3-22", "00000000 00000000"),
    ("TXATIFL", "3-23", "00000000 00000000"),
    ("TXATIFH", "3-24", "00000000 00000000"),
    ("TXREQL", "3-25", "00000000 00000000"),
    ("TXREQH", "3-26", "00000000 00000000"),
    ("FIFOBAL", "3-27", "00000000 000000--"),
    ("FIFOBAH", "3-28", "00000000 00000000"),
    ("TXQCONL", "3-29", "-----100 1--0-0-0"),
    ("TXQCONH", "3-30", "00000000 -1100000"),
    ("TXQSTA", "3-31", "---00000 0000-1-1"),
    ("FIFOCONL", "3-32", "-----100 00000000"),
    ("FIFOCONH", "3-33", "00000000 -1100000"),
    ("FIFOSTA", "3-34", "---00000 00000000"),
    ("TEFCONL", "3-35", "-----1-0 --0-0000"),
    ("TEFCONH", "3-36", "---00000 --------"),
    ("FIFOUAL", "3-38", "xxxxxxxx xxxxxxxx"),
    ("FIFOUAH", "3-39", "xxxxxxxx xxxxxxxx"),
    ("TEFUAL", "3-40", "xxxxxxxx xxxxxxxx"),
    ("TEFUAH", "3-41", "xxxxxxxx xxxxxxxx"),
    ("TXQUAL", "3-42", "xxxxxxxx xxxxxxxx"),
    ("TXQUAH", "3-43", "xxxxxxxx xxxxxxxx"),
    ("TRECL", "3-44", "00000000 00000000"),
    ("TRECH", "3-45", "-------- --100000"),
    ("BDIAG0L", "3-46", "00000000 00000000"),
    ("BDIAG0H", "3-47", "00000000 00000000"),
    ("BDIAG1L", "3-48", "00000000 00000000"),
    ("BDIAG1H", "3-49", "00000-00 0-000000"),
    ("FLTCON", "3-50", "0--00000 0--00000"),
    ("FLTCON", "3-51", "0--00000 0--00000"),
    ("MASKH", "3-55", "-0000000 00000000"),
];

/// *Enhanced Controller Area Network (CAN)*, bit diagrams of Registers 4-1 to 4-28.
const DSPIC33_ECAN: &[(&str, &str, &str)] = &[
    ("CFG2", "4-2", "-x---xxx xxxxxxxx"),
    ("FEN1", "4-3", "11111111 11111111"),
    ("RXFnSID", "4-4", "xxxxxxxx xxx-x-xx"),
    ("RXFnEID", "4-5", "xxxxxxxx xxxxxxxx"),
    ("RXMnSID", "4-6", "xxxxxxxx xxx-x-xx"),
    ("RXMnEID", "4-7", "xxxxxxxx xxxxxxxx"),
    ("FMSKSEL", "4-8", "00000000 00000000"),
    ("FMSKSEL", "4-9", "00000000 00000000"),
    ("BUFPNT", "4-10", "00000000 00000000"),
    ("BUFPNT", "4-11", "00000000 00000000"),
    ("BUFPNT", "4-12", "00000000 00000000"),
    ("BUFPNT", "4-13", "00000000 00000000"),
    ("RXFUL", "4-14", "00000000 00000000"),
    ("RXFUL", "4-15", "00000000 00000000"),
    ("RXOVF", "4-16", "00000000 00000000"),
    ("RXOVF", "4-17", "00000000 00000000"),
    ("FIFO", "4-19", "--000000 --000000"),
    ("INTE", "4-21", "-------- 000-0000"),
    ("CTRL1", "4-23", "--00-100 100-0--0"),
    ("CTRL2", "4-24", "-------- ---00000"),
    ("EC", "4-26", "00000000 00000000"),
    ("RXD", "4-27", "00000000 00000000"),
    ("TXD", "4-28", "00000000 00000000"),
];

/// *PIC32MX Family Reference Manual*, Section 34, bit diagrams of Registers 34-1 to 34-23.
const PIC32_CAN: &[(&str, &str, &str)] = &[
    ("CON", "34-1", "----0100 1000---- 0-0-0--- ---00000"),
    ("CFG", "34-2", "-------- -0---000 00000000 00000000"),
    ("INT", "34-3", "00000--- ----0000 00000--- ----0000"),
    ("VEC", "34-4", "-------- -------- ---00000 -1000000"),
    ("TREC", "34-5", "-------- --000000 00000000 00000000"),
    ("FSTAT", "34-6", "00000000 00000000 00000000 00000000"),
    ("RXOVF", "34-7", "00000000 00000000 00000000 00000000"),
    ("TMR", "34-8", "00000000 00000000 00000000 00000000"),
    ("RXM", "34-9", "00000000 000-0-00 00000000 00000000"),
    ("FLTCON", "34-10", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-11", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-12", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-13", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-14", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-15", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-16", "00000000 00000000 00000000 00000000"),
    ("FLTCON", "34-17", "00000000 00000000 00000000 00000000"),
    ("RXF", "34-18", "xxxxxxxx xxx-0-xx xxxxxxxx xxxxxxxx"),
    ("FIFOBA", "34-19", "00000000 00000000 00000000 00000000"),
    ("FIFOCON", "34-20", "-------- ---00000 -000---- 00000000"),
    ("FIFOINT", "34-21", "-----000 ----0000 -----000 ----0000"),
    ("FIFOUA", "34-22", "xxxxxxxx xxxxxxxx xxxxxxxx xxxxxx00"),
    ("FIFOCI", "34-23", "-------- -------- -------- ---00000"),
];

/// Where a description deliberately differs from a bit diagram: controller, register, and the mask of the bits. Each is a
/// contradiction that the description records.
const TAKEN_OTHERWISE: &[(&str, &str, u32)] = &[];

/// Value and unknown bits, made of the fields. Of a field that is known in part, the register knows which part.
fn from_fields(register: &RegisterInfo) -> (u32, u32) {
    let (mut value, mut unknown) = (0, 0);
    for field in register.fields {
        for lane in 0..field.lanes {
            match field.reset {
                Some(reset) => value |= reset << field.lsb_of(lane),
                None => unknown |= field.mask(lane) & register.reset_unknown,
            }
        }
    }
    (value, unknown)
}

fn register(controller: &Controller, name: &str) -> &'static RegisterInfo {
    match controller
        .registers
        .iter()
        .find(|register| register.name == name || register.label.replace("{n}", "n") == name)
    {
        Some(register) => register,
        None => panic!("{} has no register {name}", controller.name),
    }
}

#[test]
fn m_can_table_1() {
    let controller = &m_can_pac::meta::CONTROLLER;
    assert_eq!(controller.registers.len(), M_CAN.len());
    for (name, offset, printed) in M_CAN {
        let register = register(controller, name);
        assert_eq!(register.offset, Some(offset), "{name}");
        let (value, unknown) = from_fields(register);
        // TEST.RX is the level of a pin; Table 1 prints 0.
        let pin = if name == "TEST" { 1 << 7 } else { 0 };
        assert_eq!(unknown & pin, pin, "{name}");
        match u32::from_str_radix(&printed.replace(' ', ""), 16) {
            Ok(printed) => {
                assert_eq!((value, unknown & !pin), (printed, 0), "{name}: {value:#010x} is not {printed:#010x}")
            }
            Err(_) => assert_eq!(unknown, u32::MAX, "{name} has no printed reset ({printed})"),
        }
    }
}

fn bit_diagrams(controller: &Controller, printed: &[(&str, &str, &str)]) {
    let mut wrong = Vec::new();
    for (name, number, bits) in printed {
        let (value, unknown) = from_fields(register(controller, name));
        let bits: Vec<char> = bits.chars().filter(|bit| *bit != ' ').collect();
        let otherwise = TAKEN_OTHERWISE.iter().filter(|(c, r, _)| c == &controller.name && r == name);
        let otherwise = otherwise.fold(0, |mask, (_, _, bits)| mask | bits);
        for (index, printed) in bits.iter().rev().enumerate() {
            let of = |mask: u32| mask >> index & 1 == 1;
            let described = match (of(unknown), of(value)) {
                (true, _) => 'x',
                (false, true) => '1',
                (false, false) => '0',
            };
            let printed = if *printed == '-' { '0' } else { *printed };
            if described != printed && !of(otherwise) {
                wrong.push(format!("{name} (Register {number}) bit {index}: described {described}, printed {printed}"));
            }
            if described == printed && of(otherwise) {
                wrong.push(format!("{name} bit {index} is listed as taken otherwise, but is what the manual prints"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}:\n{}", controller.name, wrong.join("\n"));
}

#[test]
fn dspic33_canfd_bit_diagrams() {
    bit_diagrams(&dspic33_canfd_pac::meta::CONTROLLER, DSPIC33_CANFD);
}

#[test]
fn dspic33_ecan_bit_diagrams() {
    bit_diagrams(&dspic33_ecan_pac::meta::CONTROLLER, DSPIC33_ECAN);
}

#[test]
fn pic32_can_bit_diagrams() {
    bit_diagrams(&pic32_can_pac::meta::CONTROLLER, PIC32_CAN);
}
