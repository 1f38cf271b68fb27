//! A bench of M_CANs with a worked configuration, driven through the register crate only.

use can_frame::Frame;
use can_sim::{
    Handle, Memory, MemoryBus, MemoryId, RegisterBus, Sim, Time,
    m_can::{Choices, MCanConfig, MCanModel},
};
use m_can_pac::{
    MCan,
    enums::{DataLengthCode, FrameFormat, FrameKind, IdFormat},
    messages::{RxBuffer, TxBuffer, TxBufferT0, TxBufferT1},
    registers as pac,
};

pub use can_frame::{ExtendedId, FdFlags, Format, Id, StandardId};

/// 1 Mbit/s and 5 Mbit/s at 40 MHz, sample points at 80 and 75 %: the timing of `NodeConfig::new`.
pub const NBTP: pac::Nbtp = pac::Nbtp::RESET.with_nsjw(7).with_nbrp(0).with_ntseg1(30).with_ntseg2(7);
pub const DBTP: pac::Dbtp = pac::Dbtp::RESET.with_dsjw(1).with_dbrp(0).with_dtseg1(4).with_dtseg2(1);

/// One M_CAN with its Message RAM.
#[derive(Clone, Copy)]
pub struct Can {
    pub id: Handle<MCanModel>,
    pub ram: MemoryId,
}

/// What of the configuration differs from test to test. Addresses are bytes.
#[derive(Clone, Copy)]
pub struct Setup {
    pub cccr: pac::Cccr,
    pub test: pac::Test,
    pub gfc: u32,
    pub sidfc: u32,
    pub xidfc: u32,
    pub rxf0c: u32,
    pub rxf1c: u32,
    pub rxbc: u32,
    pub rxesc: u32,
    pub txbc: u32,
    pub txesc: u32,
    pub txefc: u32,
}

/// Eight standard filters at 0x000, four extended at 0x020, Rx FIFO 0 of 3 at 0x040, Rx FIFO 1 of 4 at 0x140, 64 Rx
/// Buffers at 0x280, 8 Tx events at 0x1480, 2 dedicated Tx Buffers and a FIFO of 3 at 0x14C0; all with 64 data bytes.
pub const SETUP: Setup = Setup {
    cccr: pac::Cccr::ZERO,
    test: pac::Test::ZERO,
    gfc: 0,
    sidfc: 0,
    xidfc: 0,
    rxf0c: 3 << 16 | 0x040,
    rxf1c: 4 << 16 | 0x140,
    rxbc: 0x280,
    rxesc: 0x777,
    txbc: 3 << 24 | 2 << 16 | 0x14C0,
    txesc: 7,
    txefc: 8 << 16 | 0x1480,
};

pub const FD: pac::Cccr = pac::Cccr::FDOE.union(pac::Cccr::BRSE);

pub fn add(sim: &Sim, name: &str) -> Can {
    add_with(sim, name, |config| config)
}

pub fn add_with(sim: &Sim, name: &str, change: impl FnOnce(MCanConfig) -> MCanConfig) -> Can {
    let ram = sim.add_memory(Memory::new(4352));
    let id = sim.add_m_can(name, change(MCanConfig::new(ram))).unwrap();
    Can { id, ram }
}

pub fn choices(change: impl FnOnce(&mut Choices)) -> Choices {
    let mut choices = Choices::default();
    change(&mut choices);
    choices
}

impl Can {
    pub fn regs(self, sim: &Sim) -> MCan<RegisterBus<'_>> {
        MCan::new(sim.registers(self.id))
    }

    pub fn memory(self, sim: &Sim) -> MemoryBus<'_> {
        sim.memory(self.ram)
    }

    /// Enters configuration mode as 3.1.1 says.
    pub fn configure(self, sim: &Sim) {
        let can = self.regs(sim);
        can.cccr().write(can.cccr().read().with_init(true));
        while !can.cccr().read().init() {}
        can.cccr().write(can.cccr().read().with_cce(true));
        assert!(can.cccr().read().cce());
    }

    /// Writes a configuration; the controller is in configuration mode afterwards.
    pub fn set_up(self, sim: &Sim, setup: &Setup) {
        self.configure(sim);
        let can = self.regs(sim);
        can.nbtp().write(NBTP);
        can.dbtp().write(DBTP);
        can.gfc().write(pac::Gfc::from_bits(setup.gfc));
        use regbus::Bus;
        let bus = sim.registers(self.id);
        for (offset, value) in [
            (0x084, setup.sidfc),
            (0x088, setup.xidfc),
            (0x0A0, setup.rxf0c),
            (0x0B0, setup.rxf1c),
            (0x0AC, setup.rxbc),
            (0x0BC, setup.rxesc),
            (0x0C0, setup.txbc),
            (0x0C8, setup.txesc),
            (0x0F0, setup.txefc),
        ] {
            bus.write(offset, value);
        }
        let cccr = can.cccr().read();
        can.cccr().write(cccr | setup.cccr);
        if setup.cccr.contains(pac::Cccr::TEST) {
            can.test().write(setup.test);
        }
    }

    /// Leaves software initialization and waits until the bus is idle.
    pub fn start(self, sim: &Sim) {
        let can = self.regs(sim);
        can.cccr().write(can.cccr().read().with_init(false));
        while can.cccr().read().init() {}
        sim.run_for(Time::from_us(13));
    }

    pub fn run(self, sim: &Sim, setup: &Setup) -> Self {
        self.set_up(sim, setup);
        self.start(sim);
        self
    }

    /// Writes a message into a Tx Buffer.
    pub fn write(self, sim: &Sim, buffer: u32, frame: &Frame) {
        self.write_with(sim, buffer, frame, |t1| t1);
    }

    pub fn write_with(self, sim: &Sim, buffer: u32, frame: &Frame, t1: impl FnOnce(TxBufferT1) -> TxBufferT1) {
        let can = self.regs(sim);
        let code = usize::from(can.txesc().read().tbds().bits());
        let start = usize::from(can.txbc().read().tbsa()) * 4;
        let element = TxBuffer::new(self.memory(sim), start + buffer as usize * TxBuffer::<MemoryBus<'_>>::bytes(code));
        let (xtd, id) = match frame.id() {
            Id::Standard(id) => (IdFormat::Standard, u32::from(id.as_raw()) << 18),
            Id::Extended(id) => (IdFormat::Extended, id.as_raw()),
        };
        let kind = if frame.is_remote() { FrameKind::Remote } else { FrameKind::Data };
        element.t0().write(TxBufferT0::ZERO.with_xtd(xtd).with_id(id).with_rtr(kind));
        let format = if frame.is_fd() { FrameFormat::Fd } else { FrameFormat::Classic };
        let header = TxBufferT1::ZERO
            .with_fdf(format)
            .with_brs(frame.bit_rate_switch())
            .with_dlc(DataLengthCode::from_bits(frame.dlc().code()));
        element.t1().write(t1(header));
        element.payload(code).write(frame.data_bytes(), 0);
    }

    /// Requests Tx Buffers.
    pub fn request(self, sim: &Sim, buffers: u32) {
        self.regs(sim).txbar().write(pac::Txbar::from_bits(buffers));
    }

    pub fn cancel(self, sim: &Sim, buffers: u32) {
        self.regs(sim).txbcr().write(pac::Txbcr::from_bits(buffers));
    }

    pub fn send(self, sim: &Sim, buffer: u32, frame: &Frame) {
        self.write(sim, buffer, frame);
        self.request(sim, 1 << buffer);
    }

    /// Reads the oldest message of an Rx FIFO as a driver does, and acknowledges it.
    pub fn receive(self, sim: &Sim, fifo: usize) -> Option<Frame> {
        let can = self.regs(sim);
        let (level, get, start, code) = if fifo == 0 {
            let status = can.rxf0s().read();
            (status.f0fl(), status.f0gi(), can.rxf0c().read().f0sa(), can.rxesc().read().f0ds().bits())
        } else {
            let status = can.rxf1s().read();
            (status.f1fl(), status.f1gi(), can.rxf1c().read().f1sa(), can.rxesc().read().f1ds().bits())
        };
        if level == 0 {
            return None;
        }
        let frame = self.read_element(sim, usize::from(start) * 4, usize::from(get), usize::from(code));
        if fifo == 0 {
            can.rxf0a().write(pac::Rxf0a::RESET.with_f0ai(get));
        } else {
            can.rxf1a().write(pac::Rxf1a::RESET.with_f1ai(get));
        }
        Some(frame)
    }

    pub fn read_element(self, sim: &Sim, start: usize, index: usize, code: usize) -> Frame {
        let bytes = RxBuffer::<MemoryBus<'_>>::bytes(code);
        let element = RxBuffer::new(self.memory(sim), start + index * bytes);
        let (r0, r1) = (element.r0().read(), element.r1a().read());
        let id = match r0.xtd() {
            IdFormat::Standard => Id::Standard(StandardId::new((r0.id() >> 18) as u16).unwrap()),
            IdFormat::Extended => Id::Extended(ExtendedId::new(r0.id()).unwrap()),
        };
        let format = match (r1.fdf(), r0.rtr()) {
            (FrameFormat::Fd, _) => Format::Fd(FdFlags { brs: r1.brs(), esi: r0.esi().bits() == 1 }),
            (_, FrameKind::Remote) => Format::Remote,
            (_, FrameKind::Data) => Format::Data,
        };
        let dlc = can_frame::Dlc::new(r1.dlc().bits()).unwrap();
        let mut data = [0; 64];
        let len = Frame::from_fields(id, format, dlc, &[]).len();
        element.payload(code).read(&mut data[..len]);
        Frame::from_fields(id, format, dlc, &data)
    }

    pub fn ir(self, sim: &Sim) -> pac::Ir {
        self.regs(sim).ir().read()
    }

    pub fn clear(self, sim: &Sim) {
        self.regs(sim).ir().clear(pac::Ir::from_bits(u32::MAX));
    }
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

/// Long enough for any frame at 1 Mbit/s.
pub const FRAME: Time = Time::from_us(200);
