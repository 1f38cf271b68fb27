//! A bench of dsPIC33 CAN FD modules, driven through the register crate only.

use can_frame::{Dlc, Frame};
use can_sim::{
    Diagnostic, DiagnosticKind, Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    dspic33_canfd::{Choices, Dspic33CanfdConfig, Dspic33CanfdModel},
};
use can_wire::NodeConfig;
use dspic33_canfd_pac::{
    Dspic33Canfd,
    enums::{
        DataLengthCode, DataPhaseRate, ErrorState, FifoConLTxen, FltConFbp, FrameFormat, IdentifierFormat, PayloadSize,
    },
    messages::{RxObject, RxObjectR2, RxObjectTs, TxObject, TxObjectT0, TxObjectT1, TxObjectT2, TxObjectT3},
    registers as pac,
};

pub use can_frame::{ExtendedId, FdFlags, Format, Id, StandardId};
pub use dspic33_canfd_pac::enums::OperationMode as Mode;

/// Bus address of the RAM's first byte.
pub const BASE: u32 = 0x1000;

/// One module with its RAM.
#[derive(Clone, Copy)]
pub struct Can {
    pub id: Handle<Dspic33CanfdModel>,
    pub ram: MemoryId,
}

/// A FIFO that transmits.
#[derive(Clone, Copy)]
pub struct TxFifo {
    pub depth: u8,
    pub size: PayloadSize,
    pub priority: u8,
}

pub const TX8: TxFifo = TxFifo { depth: 4, size: PayloadSize::Bytes8, priority: 0 };
pub const TX64: TxFifo = TxFifo { depth: 4, size: PayloadSize::Bytes64, priority: 0 };

pub fn add(sim: &Sim, name: &str) -> Can {
    add_with(sim, name, |config| config)
}

pub fn add_with(sim: &Sim, name: &str, change: impl FnOnce(Dspic33CanfdConfig) -> Dspic33CanfdConfig) -> Can {
    let ram = sim.add_memory(Memory::new(4096).with_widths(&[8, 16, 32]));
    let id = sim.add_dspic33_canfd(name, change(Dspic33CanfdConfig::new(ram))).unwrap();
    Can { id, ram }
}

pub fn choices(change: impl FnOnce(&mut Choices)) -> Choices {
    let mut choices = Choices::default();
    change(&mut choices);
    choices
}

/// A module in Configuration mode with a peer on the bus.
pub fn pair() -> (Sim, Can, PeerId) {
    pair_with(|config| config)
}

pub fn pair_with(change: impl FnOnce(Dspic33CanfdConfig) -> Dspic33CanfdConfig) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_with(&sim, "can0", change);
    let peer = sim.add_peer(NodeConfig::new()).unwrap();
    can.configure(&sim);
    (sim, can, peer)
}

impl Can {
    pub fn regs(self, sim: &Sim) -> Dspic33Canfd<RegisterBus<'_>> {
        Dspic33Canfd::new(sim.registers(self.id))
    }

    pub fn memory(self, sim: &Sim) -> MemoryBus<'_> {
        sim.memory(self.ram)
    }

    /// Enables the module, enters Configuration mode and sets 1 Mbit/s and 5 Mbit/s at 40 MHz, the timing of
    /// `NodeConfig::new`; the message memory begins at the start of the RAM, without queue and event FIFO.
    pub fn configure(self, sim: &Sim) {
        let can = self.regs(sim);
        can.con_l().write(pac::ConL::RESET.with_con(true));
        self.ask(sim, Mode::Configuration);
        self.wait(sim, Mode::Configuration);
        can.nbtcfg_h().write(pac::NbtcfgH::RESET.with_brp(0).with_tseg1(30));
        can.nbtcfg_l().write(pac::NbtcfgL::RESET.with_tseg2(7).with_sjw(7));
        can.dbtcfg_h().write(pac::DbtcfgH::RESET.with_brp(0).with_tseg1(4));
        can.dbtcfg_l().write(pac::DbtcfgL::RESET.with_tseg2(1).with_sjw(1));
        can.tdc_h().write(pac::TdcH::from_bits(0));
        can.con_h().write(can.con_h().read().with_txqen(false).with_stef(false));
        self.set_base(sim, BASE);
    }

    pub fn set_base(self, sim: &Sim, address: u32) {
        use regbus::Bus;
        sim.registers(self.id).write(0x04C, address as u16);
        sim.registers(self.id).write(0x04E, (address >> 16) as u16);
    }

    pub fn con_h(self, sim: &Sim, change: impl FnOnce(pac::ConH) -> pac::ConH) {
        let can = self.regs(sim);
        can.con_h().write(change(can.con_h().read()));
    }

    pub fn ask(self, sim: &Sim, mode: Mode) {
        self.con_h(sim, |con_h| con_h.with_reqop(mode));
    }

    pub fn wait(self, sim: &Sim, mode: Mode) {
        for _ in 0..100_000 {
            if self.mode(sim) == mode {
                return;
            }
        }
        panic!("mode {mode:?} is not reached\n{}", sim.describe(self.id));
    }

    pub fn mode(self, sim: &Sim) -> Mode {
        self.regs(sim).con_h().read().opmod()
    }

    pub fn go(self, sim: &Sim, mode: Mode) {
        self.ask(sim, mode);
        self.wait(sim, mode);
    }

    pub fn start(self, sim: &Sim) {
        self.go(sim, Mode::NormalCanFd);
    }

    /// A FIFO that transmits; in Configuration mode.
    pub fn tx_fifo(self, sim: &Sim, number: usize, fifo: TxFifo) {
        let regs = self.regs(sim).fifo(number);
        regs.con_l().write(pac::FifoConL::from_bits(0).with_txen(FifoConLTxen::Transmit));
        let size = regs.con_h().read().with_plsize(fifo.size).with_fsize(fifo.depth - 1).with_txpri(fifo.priority);
        regs.con_h().write(size);
    }

    /// A FIFO that receives; in Configuration mode.
    pub fn rx_fifo(self, sim: &Sim, number: usize, depth: u8, size: PayloadSize) {
        let regs = self.regs(sim).fifo(number);
        regs.con_l().write(pac::FifoConL::from_bits(0));
        regs.con_h().write(regs.con_h().read().with_plsize(size).with_fsize(depth - 1));
    }

    /// A queue; in Configuration mode.
    pub fn queue(self, sim: &Sim, fifo: TxFifo) {
        let regs = self.regs(sim);
        self.con_h(sim, |con_h| con_h.with_txqen(true));
        let size = regs.txqcon_h().read().with_plsize(fifo.size).with_fsize(fifo.depth - 1).with_txpri(fifo.priority);
        regs.txqcon_h().write(size);
    }

    /// An event FIFO; in Configuration mode.
    pub fn events(self, sim: &Sim, depth: u8, stamped: bool) {
        let regs = self.regs(sim);
        self.con_h(sim, |con_h| con_h.with_stef(true));
        regs.tefcon_h().write(pac::TefconH::RESET.with_fsize(depth - 1));
        regs.tefcon_l().write(pac::TefconL::from_bits(0).with_teftsen(stamped));
    }

    /// A filter as 8.1 asks: disabled, object and mask, target, enabled.
    pub fn filter(self, sim: &Sim, number: usize, object: u32, mask: u32, fifo: u8) {
        let regs = self.regs(sim);
        let (con, lane) = regs.flt_con_of(number);
        con.write(con.read().with_flten(lane, false));
        let flt = regs.flt(number);
        flt.obj_l().write(pac::FltObjL::from_bits(object as u16));
        flt.obj_h().write(pac::FltObjH::from_bits((object >> 16) as u16));
        flt.mask_l().write(pac::MaskL::from_bits(mask as u16));
        flt.mask_h().write(pac::MaskH::from_bits((mask >> 16) as u16));
        con.write(con.read().with_fbp(lane, FltConFbp::from_bits(fifo)));
        con.write(con.read().with_flten(lane, true));
    }

    /// Everything to one FIFO.
    pub fn accept_all(self, sim: &Sim, fifo: u8) {
        self.filter(sim, 0, 0, 0, fifo);
    }

    /// The user address of a FIFO, of the queue for 0.
    pub fn user_address(self, sim: &Sim, number: usize) -> u32 {
        let regs = self.regs(sim);
        if number == 0 { regs.read_txqua() } else { regs.fifo(number).read_ua() }
    }

    /// Writes a message where the user address points.
    pub fn load(self, sim: &Sim, number: usize, frame: &Frame) {
        self.load_with(sim, number, frame, |t2| t2);
    }

    pub fn load_with(self, sim: &Sim, number: usize, frame: &Frame, t2: impl FnOnce(TxObjectT2) -> TxObjectT2) {
        let at = self.user_address(sim, number) - BASE;
        self.write_object(sim, at as usize, frame, t2);
        self.increment(sim, number, false);
    }

    pub fn write_object(self, sim: &Sim, at: usize, frame: &Frame, t2: impl FnOnce(TxObjectT2) -> TxObjectT2) {
        let object = TxObject::new(self.memory(sim), at);
        let (ide, base, extension) = match frame.id() {
            Id::Standard(id) => (IdentifierFormat::Base, id.as_raw(), 0),
            Id::Extended(id) => (IdentifierFormat::Extended, (id.as_raw() >> 18) as u16, id.as_raw() & 0x3_FFFF),
        };
        object.t0().write(TxObjectT0::ZERO.with_sid(base).with_eid((extension & 0x1F) as u8));
        let sid11 = frame.remote_request_substitution();
        object.t1().write(TxObjectT1::ZERO.with_eid((extension >> 5) as u16).with_sid11(sid11));
        let esi = frame.error_state_indicator();
        let control = TxObjectT2::ZERO
            .with_ide(ide)
            .with_rtr(frame.is_remote())
            .with_fdf(if frame.is_fd() { FrameFormat::CanFd } else { FrameFormat::Can2_0 })
            .with_brs(if frame.bit_rate_switch() { DataPhaseRate::Data } else { DataPhaseRate::Nominal })
            .with_esi(if esi { ErrorState::ErrorPassive } else { ErrorState::ErrorActive })
            .with_dlc(DataLengthCode::from_bits(frame.dlc().code()));
        object.t2().write(t2(control));
        object.t3().write(TxObjectT3::ZERO);
        object.payload(7).write(frame.data_bytes(), 0);
    }

    /// UINC, with or without TXREQ in the same write. The enables stay.
    pub fn increment(self, sim: &Sim, number: usize, request: bool) {
        let regs = self.regs(sim);
        if number == 0 {
            let con = regs.txqcon_l();
            let old = con.read();
            con.write(old.with_uinc(true).with_freset(false).with_txreq(request || old.txreq()));
        } else {
            let con = regs.fifo(number).con_l();
            let old = con.read();
            con.write(old.with_uinc(true).with_freset(false).with_txreq(request || old.txreq()));
        }
    }

    /// Releases the event just read.
    pub fn release_event(self, sim: &Sim) {
        self.regs(sim).tefcon_l().modify(|con| con.with_uinc(true));
    }

    /// FRESET of a FIFO.
    pub fn reset(self, sim: &Sim, number: usize) {
        let con = self.regs(sim).fifo(number).con_l();
        con.write(con.read().with_freset(true));
    }

    /// TXREQ through the request registers.
    pub fn request(self, sim: &Sim, numbers: u32) {
        let regs = self.regs(sim);
        regs.txreq_l().write(pac::TxreqL::from_bits(numbers as u16));
        regs.txreq_h().write(pac::TxreqH::from_bits((numbers >> 16) as u16));
    }

    pub fn send(self, sim: &Sim, number: usize, frame: &Frame) {
        self.load(sim, number, frame);
        self.request(sim, 1 << number);
    }

    /// Pending requests.
    pub fn pending(self, sim: &Sim) -> u32 {
        self.regs(sim).read_txreq()
    }

    pub fn status(self, sim: &Sim, number: usize) -> pac::FifoSta {
        self.regs(sim).fifo(number).sta().read()
    }

    pub fn has_message(self, sim: &Sim, number: usize) -> bool {
        self.status(sim, number).tfnrfnif()
    }

    /// Reads the oldest message of a FIFO as a driver does, and releases it.
    pub fn receive(self, sim: &Sim, number: usize) -> Option<Frame> {
        self.receive_object(sim, number).map(|(frame, ..)| frame)
    }

    /// The message, its control word, and its timestamp where there is one.
    pub fn receive_object(self, sim: &Sim, number: usize) -> Option<(Frame, RxObjectR2, u32)> {
        let fifo = self.regs(sim).fifo(number);
        if !fifo.sta().read().tfnrfnif() {
            return None;
        }
        let con = fifo.con_l().read();
        let code = usize::from(fifo.con_h().read().plsize().bits());
        let at = (fifo.read_ua() - BASE) as usize;
        let object = RxObject::new(self.memory(sim), at);
        let (r0, r1, r2) = (object.r0().read(), object.r1().read(), object.r2().read());
        let extension = u32::from(r0.eid()) | u32::from(r1.eid()) << 5;
        let id = match r2.ide() {
            IdentifierFormat::Base => Id::Standard(StandardId::new(r0.sid()).unwrap()),
            IdentifierFormat::Extended => Id::Extended(ExtendedId::new(u32::from(r0.sid()) << 18 | extension).unwrap()),
        };
        let format = match (r2.fdf(), r2.rtr()) {
            (FrameFormat::CanFd, _) => {
                Format::Fd(FdFlags { brs: r2.brs() == DataPhaseRate::Data, esi: r2.esi() == ErrorState::ErrorPassive })
            }
            (_, true) => Format::Remote,
            (_, false) => Format::Data,
        };
        let dlc = Dlc::new(r2.dlc().bits()).unwrap();
        let mut data = [0; 64];
        let len = Frame::from_fields(id, format, dlc, &[]).len();
        let mut time = 0;
        if con.rxtsen() {
            let object = RxObjectTs::new(self.memory(sim), at);
            time = object.read_rxmsgts();
            object.payload(code).read(&mut data[..len]);
        } else {
            object.payload(code).read(&mut data[..len]);
        }
        fifo.con_l().write(con.with_uinc(true).with_freset(false));
        let frame = Frame::from_fields(id, format, dlc, &data).with_remote_request_substitution(r1.sid11());
        Some((frame, r2, time))
    }

    pub fn flags(self, sim: &Sim) -> pac::IntL {
        self.regs(sim).int_l().read()
    }

    /// Clears main flags as a driver does.
    pub fn clear(self, sim: &Sim, flags: pac::IntL) {
        self.regs(sim).int_l().clear(flags);
    }

    pub fn diagnosis(self, sim: &Sim) -> pac::Bdiag1H {
        self.regs(sim).bdiag1_h().read()
    }
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

pub fn fd(id: u16, data: &[u8]) -> Frame {
    Frame::fd(StandardId::new(id).unwrap(), data, FdFlags { brs: true, esi: false }).unwrap()
}

/// The order in which frames with these identifiers were on the bus.
pub fn ids(sim: &Sim, peer: PeerId) -> Vec<u32> {
    sim.peer_received(peer).iter().map(|(_, frame)| frame.raw_id()).collect()
}

pub fn kinds(sim: &Sim) -> Vec<DiagnosticKind> {
    sim.take_diagnostics().into_iter().map(|Diagnostic { kind, .. }| kind).collect()
}

/// Long enough for any frame at 1 Mbit/s.
pub const FRAME: Time = Time::from_us(300);
