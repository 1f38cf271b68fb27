//! A bench of PIC32MX CAN modules, driven through the register crate only.

use can_sim::{
    DiagnosticKind, Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    pic32_can::{Choices, Pic32CanConfig, Pic32CanModel},
};
use can_wire::NodeConfig;
use pic32_can_pac::{
    Fifo, Pic32Can,
    enums::{
        CfgSam, CfgSeg2phts, DataLength, FifoConDonly, FifoConTxen, FifoConTxpri, FltConFsel, FltConMsel, FrameType,
        IdentifierType, OperationMode, RxfExid, RxmMide,
    },
    messages::{RxBuffer, RxDataBuffer, TxBuffer, TxBufferCmsgeid, TxBufferCmsgsid},
    registers as pac,
};

pub use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};

/// 1 Mbit/s at 80 MHz with the sample point at 70 %: Example 34-17 with the jump width of 2 quanta that its comment says.
pub const CFG: pac::Cfg = pac::Cfg::RESET
    .with_seg2ph(2)
    .with_seg2phts(CfgSeg2phts::Programmable)
    .with_sam(CfgSam::ThreeTimes)
    .with_seg1ph(2)
    .with_prseg(2)
    .with_sjw(1)
    .with_brp(3);

/// Words of RAM.
pub const WORDS: usize = 8192;

/// One module with its RAM.
#[derive(Clone, Copy)]
pub struct Can {
    pub id: Handle<Pic32CanModel>,
    pub ram: MemoryId,
}

pub fn add(sim: &Sim, name: &str) -> Can {
    add_with(sim, name, |config| config)
}

pub fn add_with(sim: &Sim, name: &str, change: impl FnOnce(Pic32CanConfig) -> Pic32CanConfig) -> Can {
    let ram = sim.add_memory(Memory::new(WORDS).with_widths(&[8, 16, 32]));
    let id = sim.add_pic32_can(name, change(Pic32CanConfig::new(ram))).unwrap();
    Can { id, ram }
}

pub fn choices(change: impl FnOnce(&mut Choices)) -> Choices {
    let mut choices = Choices::default();
    change(&mut choices);
    choices
}

/// A FIFO of the configuration of a test.
#[derive(Clone, Copy)]
pub enum Use {
    Tx(u8),
    Rx(u8),
    DataOnly(u8),
}

impl Can {
    pub fn regs(self, sim: &Sim) -> Pic32Can<RegisterBus<'_>> {
        Pic32Can::new(sim.registers(self.id))
    }

    pub fn fifo(self, sim: &Sim, fifo: usize) -> Fifo<RegisterBus<'_>> {
        self.regs(sim).fifo(fifo)
    }

    pub fn memory(self, sim: &Sim) -> MemoryBus<'_> {
        sim.memory(self.ram)
    }

    /// Requests a mode and waits for it as 34.5 says.
    pub fn mode(self, sim: &Sim, mode: OperationMode) {
        let con = self.regs(sim).con();
        con.modify(|con| con.with_reqop(mode));
        for _ in 0..10_000 {
            if con.read().opmod() == Ok(mode) {
                return;
            }
        }
        panic!("{mode:?} mode is not reached:\n{}", sim.describe(self.id));
    }

    pub fn opmod(self, sim: &Sim) -> OperationMode {
        self.regs(sim).con().read().opmod().unwrap()
    }

    /// Switches the module on in Configuration mode, with bit timing, base address and FIFOs.
    pub fn set_up(self, sim: &Sim, base: u32, fifos: &[Use]) {
        let can = self.regs(sim);
        can.con().set_bits(pac::Con::ON);
        self.mode(sim, OperationMode::Configuration);
        can.cfg().write(CFG);
        self.base(sim, base);
        for (n, fifo) in fifos.iter().enumerate() {
            let con = match *fifo {
                Use::Tx(depth) => pac::FifoCon::RESET.with_txen(FifoConTxen::Transmit).with_fsize(depth - 1),
                Use::Rx(depth) => pac::FifoCon::RESET.with_fsize(depth - 1),
                Use::DataOnly(depth) => pac::FifoCon::RESET.with_donly(FifoConDonly::DataOnly).with_fsize(depth - 1),
            };
            can.fifo(n).con().write(con);
        }
    }

    /// CiFIFOBA.
    pub fn base(self, sim: &Sim, address: u32) {
        use regbus::Bus;
        sim.registers(self.id).write(self.regs(sim).fifo_ba().offset(), address);
    }

    pub fn run(self, sim: &Sim, base: u32, fifos: &[Use]) -> Self {
        self.set_up(sim, base, fifos);
        self.start(sim);
        self
    }

    pub fn start(self, sim: &Sim) {
        self.mode(sim, OperationMode::Normal);
    }

    /// Mask `mask` and filter `filter` in Configuration mode, enabled: messages go to `fifo`.
    pub fn filter(self, sim: &Sim, filter: usize, mask: usize, fifo: u8, value: pac::Rxf, bits: pac::Rxm) {
        self.regs(sim).rxm(mask).write(bits);
        self.select(sim, filter, mask, fifo, value);
    }

    /// A filter that uses a mask as it is.
    pub fn select(self, sim: &Sim, filter: usize, mask: usize, fifo: u8, value: pac::Rxf) {
        let can = self.regs(sim);
        can.rxf(filter).write(value);
        let (register, lane) = can.flt_con_of(filter);
        register.modify(|control| {
            control
                .with_flten(lane, false)
                .with_msel(lane, FltConMsel::from_bits(mask as u8))
                .with_fsel(lane, FltConFsel::from_bits(fifo))
        });
        register.set_bits(pac::FltCon::flten_bit(lane));
    }

    /// Everything goes to one FIFO.
    pub fn accept_all(self, sim: &Sim, fifo: u8) {
        self.filter(sim, 0, 0, fifo, pac::Rxf::RESET, pac::Rxm::RESET);
    }

    /// Writes a message to the buffer that CiFIFOUAn gives.
    pub fn load(self, sim: &Sim, fifo: usize, frame: &Frame) {
        let address = self.fifo(sim, fifo).ua().read().bits();
        self.store(sim, address, frame);
    }

    pub fn store(self, sim: &Sim, address: u32, frame: &Frame) {
        let buffer = TxBuffer::new(self.memory(sim), address as usize);
        let (sid, eid) = words_of(frame);
        buffer.cmsgsid().write(sid);
        buffer.cmsgeid().write(eid);
        let mut data = [0; 8];
        data[..frame.len()].copy_from_slice(frame.data_bytes());
        buffer.payload().write(&data, 0);
    }

    /// Loads a message, advances the FIFO and requests it in one write, as Example 34-3 does.
    pub fn send(self, sim: &Sim, fifo: usize, frame: &Frame) {
        self.load(sim, fifo, frame);
        self.fifo(sim, fifo).con().set_bits(pac::FifoCon::UINC | pac::FifoCon::TXREQ);
    }

    /// Loads a message and advances the FIFO.
    pub fn queue(self, sim: &Sim, fifo: usize, frame: &Frame) {
        self.load(sim, fifo, frame);
        self.advance(sim, fifo);
    }

    pub fn advance(self, sim: &Sim, fifo: usize) {
        self.fifo(sim, fifo).con().set_bits(pac::FifoCon::UINC);
    }

    pub fn request(self, sim: &Sim, fifo: usize) {
        self.fifo(sim, fifo).con().set_bits(pac::FifoCon::TXREQ);
    }

    /// Takes the oldest message of a receive FIFO as 34.6.3 says.
    pub fn receive(self, sim: &Sim, fifo: usize) -> Option<Frame> {
        if !self.fifo(sim, fifo).int_().read().rxnemptyif() {
            return None;
        }
        let frame = self.look(sim, self.fifo(sim, fifo).ua().read().bits());
        self.advance(sim, fifo);
        Some(frame)
    }

    /// A full message at an address.
    pub fn look(self, sim: &Sim, address: u32) -> Frame {
        let buffer = RxBuffer::new(self.memory(sim), address as usize);
        let (sid, eid) = (buffer.cmsgsid().read(), buffer.cmsgeid().read());
        let id = match eid.ide() {
            IdentifierType::Standard => Id::Standard(StandardId::new(sid.sid()).unwrap()),
            IdentifierType::Extended => Id::Extended(ExtendedId::new(u32::from(sid.sid()) << 18 | eid.eid()).unwrap()),
        };
        let format = if eid.rtr() == FrameType::RemoteFrame { Format::Remote } else { Format::Data };
        let mut data = [0; 8];
        buffer.payload().read(&mut data);
        Frame::from_fields(id, format, Dlc::new(eid.dlc().bits()).unwrap(), &data)
    }

    pub fn look_at_data(self, sim: &Sim, address: u32) -> [u8; 8] {
        let mut data = [0; 8];
        RxDataBuffer::new(self.memory(sim), address as usize).payload().read(&mut data);
        data
    }

    pub fn word(self, sim: &Sim, address: u32) -> u32 {
        sim.with_memory(self.ram, |memory| memory.word(address as usize / 4).unwrap())
    }

    pub fn icod(self, sim: &Sim) -> u32 {
        self.regs(sim).vec().read().bits() & 0x7F
    }

    pub fn filhit(self, sim: &Sim) -> u8 {
        self.regs(sim).vec().read().filhit().bits()
    }

    pub fn flags(self, sim: &Sim) -> pac::Int {
        self.regs(sim).int_().read()
    }

    pub fn clear(self, sim: &Sim, flags: pac::Int) {
        self.regs(sim).int_().clear_bits(flags);
    }

    pub fn priority(self, sim: &Sim, fifo: usize, priority: FifoConTxpri) {
        self.fifo(sim, fifo).con().clear_bits(pac::FifoCon::RESET.with_txpri(FifoConTxpri::Highest));
        self.fifo(sim, fifo).con().set_bits(pac::FifoCon::RESET.with_txpri(priority));
    }
}

/// CMSGSID and CMSGEID of a message to send.
pub fn words_of(frame: &Frame) -> (TxBufferCmsgsid, TxBufferCmsgeid) {
    let rtr = if frame.is_remote() { FrameType::RemoteFrame } else { FrameType::DataFrame };
    let eid = TxBufferCmsgeid::ZERO.with_rtr(rtr).with_dlc(DataLength::from_bits(frame.dlc().code()));
    match frame.id() {
        Id::Standard(id) => (TxBufferCmsgsid::ZERO.with_sid(id.as_raw()), eid),
        Id::Extended(id) => {
            let sid = TxBufferCmsgsid::ZERO.with_sid((id.as_raw() >> 18) as u16);
            let eid = eid.with_ide(IdentifierType::Extended).with_srr(true).with_eid(id.as_raw() & 0x3_FFFF);
            (sid, eid)
        }
    }
}

/// A filter for a standard identifier.
pub const fn standard(sid: u16) -> pac::Rxf {
    pac::Rxf::RESET.with_sid(sid)
}

/// A filter for an extended identifier.
pub const fn extended(id: u32) -> pac::Rxf {
    pac::Rxf::RESET.with_sid((id >> 18) as u16).with_eid(id & 0x3_FFFF).with_exid(RxfExid::Extended)
}

/// Every bit and the type.
pub const EXACT: pac::Rxm = pac::Rxm::RESET.with_sid(0x7FF).with_eid(0x3_FFFF).with_mide(RxmMide::TypeOfFilter);

/// One module in Normal mode, accepting everything into FIFO `n` (the first receive FIFO), and a plain node.
pub fn bench(fifos: &[Use]) -> (Sim, Can, PeerId) {
    bench_with(fifos, |config| config)
}

pub fn bench_with(fifos: &[Use], change: impl FnOnce(Pic32CanConfig) -> Pic32CanConfig) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_with(&sim, "can1", change);
    can.set_up(&sim, 0x100, fifos);
    if let Some(rx) = fifos.iter().position(|fifo| !matches!(fifo, Use::Tx(_))) {
        can.accept_all(&sim, rx as u8);
    }
    can.start(&sim);
    let peer = add_peer(&sim);
    (sim, can, peer)
}

/// A plain node with the bit timing of the module.
pub fn add_peer(sim: &Sim) -> PeerId {
    let peer = sim.add_peer(peer_config()).unwrap();
    sim.run_for(Time::from_us(20));
    peer
}

pub fn peer_config() -> NodeConfig {
    let mut config = NodeConfig::new();
    config.clock_hz = 80_000_000;
    config.nominal = can_wire::BitTiming { prescaler: 8, prop_seg: 3, phase_seg1: 3, phase_seg2: 3, sjw: 2 };
    config
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

pub fn kinds(sim: &Sim) -> Vec<DiagnosticKind> {
    sim.take_diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect()
}

/// What the plain node has received, as text.
pub fn heard(sim: &Sim, peer: PeerId) -> Vec<String> {
    sim.peer_received(peer).iter().map(|(_, frame)| frame.to_string()).collect()
}

/// Long enough for any frame at 1 Mbit/s.
pub const FRAME: Time = Time::from_us(200);
