//! Microchip dsPIC33 CAN FD, on its register crate: what a firmware without HAL does. Sections are of the manual.

use can_frame::{Dlc, ExtendedId, FdFlags, Format, Frame, Id, StandardId};
use can_hal::{
    Counters, ErrorState, Events, LastError, SendError, Status,
    timing::{BitTiming, DsPic33CanFdTiming, Limits},
};
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim,
    dspic33_canfd::{Dspic33CanfdConfig, Dspic33CanfdModel},
};
use can_wire::NodeId;
use dspic33_canfd_pac::{
    Dspic33Canfd,
    enums::{
        DataLengthCode, DataPhaseRate, ErrorState as Esi, FifoConLTxen, FltConFbp, FrameFormat, IdentifierFormat,
        OperationMode, PayloadSize,
    },
    messages::{RxObject, TxObject, TxObjectT0, TxObjectT1, TxObjectT2, TxObjectT3},
    registers as pac,
};
use regbus::meta;

use super::{Driver, MODE_POLLS, Station};
use crate::{Error, play};

/// Bus address of the RAM's first byte, and its words.
const BASE: u32 = 0x1000;
const WORDS: usize = 4096;
/// The FIFOs that send and receive, and the messages in them.
const TX: usize = 1;
const RX: usize = 2;
const DEPTH: u8 = 8;
/// Reads of CiCONH.OPMOD until a mode is reached: on the bus the module waits for 11 recessive bits first (4.1.5).
const POLLS: u32 = 10 * MODE_POLLS;

/// A dsPIC33 CAN FD module with a RAM of its own.
#[derive(Clone, Copy, Debug)]
pub struct DsPic33CanFd {
    id: Handle<Dspic33CanfdModel>,
    ram: MemoryId,
}

/// Its driver.
pub struct CanFd<'a> {
    regs: Dspic33Canfd<RegisterBus<'a>>,
    ram: MemoryBus<'a>,
    /// Frames given to the transmit FIFO so far; it sends them in this order.
    given: u32,
}

impl Station for DsPic33CanFd {
    type Configured<'a> = CanFd<'a>;
    type Driver<'a> = CanFd<'a>;
    const META: &'static meta::Controller = &dspic33_canfd_pac::meta::CONTROLLER;
    const CLOCK: u32 = 40_000_000;
    const FD: bool = true;

    fn add(sim: &Sim, name: &str, ppm: i32) -> Result<Self, Error> {
        let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
        let mut config = Dspic33CanfdConfig::new(ram).with_memory_base(BASE);
        config.place = play::place(Self::CLOCK, ppm);
        let id = sim.add_dspic33_canfd(name, config).map_err(Error::Place)?;
        Ok(Self { id, ram })
    }

    fn timing() -> Result<BitTiming, Error> {
        let solution = Limits::DSPIC33_CANFD.solve(&play::request(Self::CLOCK)).map_err(Error::Timing)?;
        Ok(solution.timing)
    }

    fn node(self, sim: &Sim) -> NodeId {
        sim.node(self.id)
    }

    fn line(self, sim: &Sim) -> bool {
        (0..Self::META.lines.len()).any(|line| sim.line(self.id, line))
    }

    #[allow(unsafe_code, reason = "the message memory is a simulated RAM of its own")]
    fn configure<'a>(self, sim: &'a Sim, timing: &BitTiming) -> Result<CanFd<'a>, Error> {
        let registers = DsPic33CanFdTiming::of(timing).map_err(Error::setup)?;
        let can = CanFd { regs: Dspic33Canfd::new(sim.registers(self.id)), ram: sim.memory(self.ram), given: 0 };
        let regs = &can.regs;
        // 4.1.5, 5.0: everything below takes writes only in Configuration mode.
        regs.con_l().write(pac::ConL::RESET.with_con(true));
        can.enter(OperationMode::Configuration)?;
        regs.nbtcfg_h().write(registers.nbtcfgh);
        regs.nbtcfg_l().write(registers.nbtcfgl);
        regs.dbtcfg_h().write(registers.dbtcfgh);
        regs.dbtcfg_l().write(registers.dbtcfgl);
        regs.tdc_h().write(registers.tdch);
        regs.tdc_l().write(registers.tdcl);
        regs.con_h().write(regs.con_h().read().with_txqen(false).with_stef(false));
        // SAFETY: the memory is there, and nothing else uses it.
        unsafe { regs.write_fifoba(BASE) };
        for (number, direction) in [(TX, FifoConLTxen::Transmit), (RX, FifoConLTxen::Receive)] {
            let fifo = regs.fifo(number);
            fifo.con_l().write(pac::FifoConL::from_bits(0).with_txen(direction));
            fifo.con_h().write(fifo.con_h().read().with_plsize(PayloadSize::Bytes64).with_fsize(DEPTH - 1));
        }
        // 8.1: filter 0, whose mask compares nothing, lets everything into the receive FIFO.
        let filter = regs.flt(0);
        filter.mask_l().write(pac::MaskL::from_bits(0));
        filter.mask_h().write(pac::MaskH::from_bits(0));
        let (con, lane) = regs.flt_con_of(0);
        con.write(con.read().with_fbp(lane, FltConFbp::from_bits(RX as u8)));
        con.write(con.read().with_flten(lane, true));
        Ok(can)
    }

    fn start<'a>(can: Self::Configured<'a>) -> Result<Self::Driver<'a>, Error> {
        can.enter(OperationMode::NormalCanFd)?;
        // 12.0: the receive FIFO reports that it is not empty, the transmit FIFO only when it has something to send.
        let receive = can.regs.fifo(RX).con_l();
        receive.write(receive.read().with_tfnrfnie(true));
        can.regs.int_l().clear(pac::IntL::MODIF | pac::IntL::CERRIF | pac::IntL::IVMIF);
        can.regs.int_h().write(pac::IntH::RXIE | pac::IntH::TXIE | pac::IntH::CERRIE | pac::IntH::IVMIE);
        Ok(can)
    }

    fn report_errors(can: &mut CanFd<'_>, on: bool) {
        let enables = can.regs.int_h();
        enables.write(enables.read().with_ivmie(on));
    }
}

impl CanFd<'_> {
    /// 4.1: asks for a mode and waits for it.
    fn enter(&self, mode: OperationMode) -> Result<(), Error> {
        self.regs.con_h().write(self.regs.con_h().read().with_reqop(mode));
        let reached = (0..POLLS).any(|_| self.regs.con_h().read().opmod() == mode);
        if reached { Ok(()) } else { Err(Error::TimedOut("a mode of operation was requested")) }
    }

    /// 7.1, 9.1: the flag that tells so differs with the direction.
    fn is_empty(&self, fifo: usize) -> bool {
        let status = self.regs.fifo(fifo).sta().read();
        if fifo == TX { status.tferffif() } else { !status.tfnrfnif() }
    }
}

impl Driver for CanFd<'_> {
    /// Frames given to the FIFO up to this one.
    type Ticket = u32;

    fn take_events(&mut self) -> Events {
        let flags = self.regs.int_l().read();
        // 12.1: the FIFOs' flags end with the state of the FIFO, not by a write.
        let clearable = [(pac::IntL::CERRIF, flags.cerrif()), (pac::IntL::IVMIF, flags.ivmif())];
        for flag in clearable.into_iter().filter_map(|(flag, set)| set.then_some(flag)) {
            self.regs.int_l().clear(flag);
        }
        if flags.txif() {
            let con = self.regs.fifo(TX).con_l();
            con.write(con.read().with_tferffie(false));
        }
        // 13.0: CERRIF tells that some error state has changed.
        let states = Events::WARNING | Events::PASSIVE | Events::BUS_OFF;
        Events::NONE
            .with(Events::RECEIVED, flags.rxif())
            .with(Events::TRANSMITTED, flags.txif())
            .with(states, flags.cerrif())
            .with(Events::PROTOCOL_ERROR, flags.ivmif())
    }

    fn fetch(&mut self) -> Result<Option<Frame>, Error> {
        if self.is_empty(RX) {
            return Ok(None);
        }
        let fifo = self.regs.fifo(RX);
        let object = RxObject::new(self.ram, (fifo.read_ua() - BASE) as usize);
        let (r0, r1, r2) = (object.r0().read(), object.r1().read(), object.r2().read());
        let extension = u32::from(r0.eid()) | u32::from(r1.eid()) << 5;
        let id = match r2.ide() {
            IdentifierFormat::Base => StandardId::new(r0.sid()).map(Id::Standard),
            IdentifierFormat::Extended => ExtendedId::new(u32::from(r0.sid()) << 18 | extension).map(Id::Extended),
        };
        let format = match (r2.fdf(), r2.rtr()) {
            (FrameFormat::CanFd, _) => {
                Format::Fd(FdFlags { brs: r2.brs() == DataPhaseRate::Data, esi: r2.esi() == Esi::ErrorPassive })
            }
            (_, true) => Format::Remote,
            (_, false) => Format::Data,
        };
        let (Some(id), Some(dlc)) = (id, Dlc::new(r2.dlc().bits())) else {
            return Err(Error::Frame(String::from("what a receive FIFO holds")));
        };
        let mut data = [0; 64];
        let len = Frame::from_fields(id, format, dlc, &[]).len();
        object.payload(usize::from(PayloadSize::Bytes64.bits())).read(&mut data[..len]);
        // 9.1.1: the message is done with.
        fifo.con_l().write(fifo.con_l().read().with_uinc(true).with_freset(false));
        Ok(Some(Frame::from_fields(id, format, dlc, &data)))
    }

    fn status(&mut self) -> Status {
        let (counts, states) = (self.regs.trec_l().read(), self.regs.trec_h().read());
        let diagnosis = self.regs.bdiag1_h().read();
        // 13.2: the flags stay until they are cleared.
        self.regs.bdiag1_h().write(pac::Bdiag1H::from_bits(0));
        let error_state = match (states.txbo(), states.txbp() || states.rxbp()) {
            (true, _) => ErrorState::BusOff,
            (false, true) => ErrorState::Passive,
            (false, false) => ErrorState::Active,
        };
        let kinds = [
            (diagnosis.nstuferr(), LastError::Stuff),
            (diagnosis.nformerr(), LastError::Form),
            (diagnosis.nackerr(), LastError::Ack),
            (diagnosis.nbit1err(), LastError::Bit1),
            (diagnosis.nbit0err(), LastError::Bit0),
            (diagnosis.ncrcerr(), LastError::Crc),
        ];
        Status {
            error_state,
            warning: states.txwarn() || states.rxwarn(),
            counters: Counters { transmit: u16::from(counts.terrcnt()), receive: u16::from(counts.rerrcnt()) },
            last_error: kinds.into_iter().find_map(|(set, kind)| set.then_some(kind)),
            last_data_error: None,
        }
    }

    fn send(&mut self, frame: &Frame) -> Result<u32, Error> {
        let fifo = self.regs.fifo(TX);
        if !fifo.sta().read().tfnrfnif() {
            return Err(Error::Send(SendError::Full));
        }
        let object = TxObject::new(self.ram, (fifo.read_ua() - BASE) as usize);
        let (ide, base, extension) = match frame.id() {
            Id::Standard(id) => (IdentifierFormat::Base, id.as_raw(), 0),
            Id::Extended(id) => (IdentifierFormat::Extended, (id.as_raw() >> 18) as u16, id.as_raw() & 0x3_FFFF),
        };
        object.t0().write(TxObjectT0::ZERO.with_sid(base).with_eid((extension & 0x1F) as u8));
        object.t1().write(TxObjectT1::ZERO.with_eid((extension >> 5) as u16));
        let control = TxObjectT2::ZERO
            .with_ide(ide)
            .with_rtr(frame.is_remote())
            .with_fdf(if frame.is_fd() { FrameFormat::CanFd } else { FrameFormat::Can2_0 })
            .with_brs(if frame.bit_rate_switch() { DataPhaseRate::Data } else { DataPhaseRate::Nominal })
            .with_dlc(DataLengthCode::from_bits(frame.dlc().code()));
        object.t2().write(control);
        object.t3().write(TxObjectT3::ZERO);
        object.payload(usize::from(PayloadSize::Bytes64.bits())).write(frame.data_bytes(), 0);
        // 6.2: UINC and TXREQ together; the interrupt comes when the FIFO is empty again.
        let con = fifo.con_l();
        con.write(con.read().with_uinc(true).with_txreq(true).with_freset(false).with_tferffie(true));
        self.given += 1;
        Ok(self.given)
    }

    /// The interrupt comes when all are sent.
    fn is_pending(&mut self, _: u32) -> bool {
        !self.is_empty(TX)
    }

    /// 13.1: the module comes back by itself.
    fn restart(&mut self) -> Result<(), Error> {
        Ok(())
    }
}
