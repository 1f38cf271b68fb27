//! A bench of ECAN modules with a worked configuration, driven through the register crate only.

use can_frame::{Dlc, ExtendedId, Format, Frame, Id, StandardId};
use can_sim::{
    DiagnosticKind, Handle, Memory, MemoryBus, MemoryId, PeerId, RegisterBus, Sim, Time,
    dspic33_ecan::{EcanConfig, EcanModel},
};
use can_wire::{BitTiming, FdSupport, NodeConfig, NodeId, Wire};
use dspic33_ecan_pac::{
    Dspic33Ecan,
    enums::{
        Cfg2Sam, Cfg2Seg2phts, FilterTarget, IdentifierFormat, MaskSource, OperationMode, RxmSidMide, TrConTxen,
        TxPriority,
    },
    messages::{RxBuffer, TxBuffer, TxBufferWord0, TxBufferWord1, TxBufferWord2},
    registers as pac,
};
use regbus::Bus;

/// Longer than any frame at 1 Mbit/s with what follows it.
pub const FRAME: Time = Time::from_us(170);

/// Example 6-2: 20 time quanta at FCY 40 MHz make 1 Mbit/s, sample point at 70 %.
pub const CFG1: pac::Cfg1 = pac::Cfg1::RESET.with_sjw(3).with_brp(0);
pub const CFG2: pac::Cfg2 = pac::Cfg2::RESET
    .with_seg1ph(7)
    .with_seg2phts(Cfg2Seg2phts::Programmable)
    .with_seg2ph(5)
    .with_prseg(4)
    .with_sam(Cfg2Sam::ThreeTimes);

/// The same timing as the wire has it.
pub const TIMING: BitTiming = BitTiming { prescaler: 2, prop_seg: 5, phase_seg1: 8, phase_seg2: 6, sjw: 4 };

/// Figure 9-6: 12 buffers, the FIFO from buffer 5 to 11.
pub const FIFO_5_TO_11: u16 = 0x6005;

/// One module with its DMA RAM.
#[derive(Clone, Copy)]
pub struct Can {
    pub id: Handle<EcanModel>,
    pub ram: MemoryId,
}

/// An acceptance filter and the mask that it uses.
#[derive(Clone, Copy)]
pub struct Filter {
    pub number: usize,
    pub mask: MaskSource,
    pub id: Id,
    /// Bits of the identifier that are compared, in the position of a 29-bit identifier for extended ones.
    pub mask_bits: u32,
    pub mide: RxmSidMide,
    pub target: FilterTarget,
}

pub fn standard(id: u16) -> Id {
    Id::Standard(StandardId::new(id).unwrap())
}

pub fn extended(id: u32) -> Id {
    Id::Extended(ExtendedId::new(id).unwrap())
}

pub fn frame(text: &str) -> Frame {
    text.parse().unwrap()
}

/// Filter 0 with mask 0, which lets every message through.
pub fn everything(target: FilterTarget) -> Filter {
    let mide = RxmSidMide::BothFormats;
    Filter { number: 0, mask: MaskSource::Mask0, id: standard(0), mask_bits: 0, mide, target }
}

/// A filter for exactly one identifier of one format.
pub fn exactly(number: usize, mask: MaskSource, id: Id, buffer: u8) -> Filter {
    let mask_bits = if matches!(id, Id::Standard(_)) { 0x7FF } else { 0x1FFF_FFFF };
    Filter { number, mask, id, mask_bits, mide: RxmSidMide::ByExide, target: FilterTarget::Buffer(buffer) }
}

pub fn add(sim: &Sim, name: &str) -> Can {
    add_with(sim, name, |config| config)
}

pub fn add_with(sim: &Sim, name: &str, change: impl FnOnce(EcanConfig) -> EcanConfig) -> Can {
    let ram = sim.add_memory(Memory::new(256).with_widths(&[8, 16]));
    let id = sim.add_dspic33_ecan(name, change(EcanConfig::new(ram))).unwrap();
    Can { id, ram }
}

pub fn add_choosing(sim: &Sim, name: &str, change: impl FnOnce(&mut can_sim::dspic33_ecan::Choices)) -> Can {
    add_with(sim, name, |mut config| {
        change(&mut config.choices);
        config
    })
}

/// A node of the same bit timing without controller.
pub fn peer(sim: &Sim) -> PeerId {
    let config = NodeConfig { nominal: TIMING, data: TIMING, fd: FdSupport::Classic, ..NodeConfig::new() };
    sim.add_peer(config).unwrap()
}

pub fn kinds(sim: &Sim) -> Vec<DiagnosticKind> {
    sim.take_diagnostics().into_iter().map(|diagnostic| diagnostic.kind).collect()
}

impl Can {
    pub fn regs(self, sim: &Sim) -> Dspic33Ecan<RegisterBus<'_>> {
        Dspic33Ecan::new(sim.registers(self.id))
    }

    /// CxFCTRL, whose typed write is unsafe because it hands memory to the DMA controller.
    pub fn write_fctrl(self, sim: &Sim, value: u16) {
        sim.registers(self.id).write(self.regs(sim).fctrl().offset(), value);
    }

    /// Bit timing of Example 6-2 and no filter; the module is in Configuration mode.
    pub fn set_up(self, sim: &Sim) -> Self {
        let can = self.regs(sim);
        can.cfg1().write(CFG1);
        can.cfg2().write(CFG2);
        can.fen1().write(pac::Fen1::from_bits(0));
        self.write_fctrl(sim, 0xC000);
        self
    }

    pub fn add_filter(self, sim: &Sim, filter: Filter) -> Self {
        let mut can = self.regs(sim);
        let (sources, lane) = can.fmsk_sel_of(filter.number);
        sources.modify(|sources| sources.with_fmsk(lane, filter.mask));
        can.filter_window(|window| {
            let m = usize::from(filter.mask.bits());
            let (exide, sid, eid, mask_sid, mask_eid) = match filter.id {
                Id::Standard(id) => (IdentifierFormat::Standard, id.as_raw(), 0, filter.mask_bits as u16, 0),
                Id::Extended(id) => {
                    let (id, mask) = (id.as_raw(), filter.mask_bits);
                    let eid = 0x3_FFFF;
                    (IdentifierFormat::Extended, (id >> 18) as u16, id & eid, (mask >> 18) as u16, mask & eid)
                }
            };
            let sid_word = pac::RxfSid::RESET.with_sid(sid).with_exide(exide).with_eid((eid >> 16) as u8);
            window.rxf_sid(filter.number).write(sid_word);
            window.rxf_eid(filter.number).write(pac::RxfEid::RESET.with_eid(eid as u16));
            let mask_word = pac::RxmSid::RESET.with_sid(mask_sid).with_mide(filter.mide);
            window.rxm_sid(m).write(mask_word.with_eid((mask_eid >> 16) as u8));
            window.rxm_eid(m).write(pac::RxmEid::RESET.with_eid(mask_eid as u16));
            let (pointers, lane) = window.buf_pnt_of(filter.number);
            pointers.modify(|pointers| pointers.with_fbp(lane, filter.target));
        });
        can.fen1().modify(|enabled| enabled.with_flten(filter.number, true));
        self
    }

    /// Requests a mode and polls OPMODE (7.0).
    pub fn enter(self, sim: &Sim, mode: OperationMode) -> Self {
        let ctrl1 = self.regs(sim).ctrl1();
        ctrl1.modify(|value| value.with_reqop(mode));
        while ctrl1.read().opmode() != Ok(mode) {}
        self
    }

    pub fn mode(self, sim: &Sim) -> OperationMode {
        sim.inspect(self.id, |model| model.mode().0)
    }

    /// Timing, a filter, Normal mode.
    pub fn run(self, sim: &Sim, filter: Filter) -> Self {
        self.set_up(sim).add_filter(sim, filter).enter(sim, OperationMode::Normal)
    }

    pub fn on_wire<R>(self, sim: &Sim, look: impl FnOnce(&mut Wire, NodeId) -> R) -> R {
        let node = sim.node(self.id);
        sim.with_wire(|wire| look(wire, node))
    }

    pub fn memory(self, sim: &Sim) -> MemoryBus<'_> {
        sim.memory(self.ram)
    }

    /// The words of a buffer, looked at without an access.
    pub fn words(self, sim: &Sim, buffer: u8) -> [u16; 8] {
        let memory = sim.with_memory(self.ram, |memory| memory.clone());
        sim.inspect(self.id, |model| model.buffer(&memory, buffer).words)
    }

    pub fn set_words(self, sim: &Sim, buffer: u8, words: &[u16]) {
        for (n, word) in words.iter().enumerate() {
            self.memory(sim).write(usize::from(buffer) * 16 + 2 * n, *word);
        }
    }

    /// Makes a buffer a transmit buffer.
    pub fn transmit_buffer(self, sim: &Sim, buffer: usize, priority: TxPriority) -> Self {
        let (control, lane) = self.regs(sim).tr_con_of(buffer);
        control.write(control.read().with_txen(lane, TrConTxen::Transmit).with_txpri(lane, priority));
        self
    }

    /// Writes a message as 5.0 has it.
    pub fn write(self, sim: &Sim, buffer: usize, frame: &Frame) {
        let element = TxBuffer::new(self.memory(sim), buffer * 16);
        let dlc = TxBufferWord2::from_bits(u16::from(frame.dlc().code()));
        match frame.id() {
            Id::Standard(id) => {
                let word0 = TxBufferWord0::from_bits(0).with_sid(id.as_raw()).with_srr(frame.is_remote());
                element.word0().write(word0);
                element.word1().write(TxBufferWord1::from_bits(0));
                element.word2().write(dlc);
            }
            Id::Extended(id) => {
                element.word0().write(TxBufferWord0::IDE | TxBufferWord0::SRR);
                element.word1().write(TxBufferWord1::from_bits(0));
                element.word2().write(dlc.with_rtr(frame.is_remote()));
                element.write_extended_id(id.as_raw());
            }
        }
        element.payload().write(frame.data_bytes(), 0);
    }

    pub fn request(self, sim: &Sim, buffer: usize) {
        let (control, lane) = self.regs(sim).tr_con_of(buffer);
        control.write(control.read().with_txreq(lane, true));
    }

    pub fn abort(self, sim: &Sim, buffer: usize) {
        let (control, lane) = self.regs(sim).tr_con_of(buffer);
        control.write(control.read().with_txreq(lane, false));
    }

    pub fn send(self, sim: &Sim, buffer: usize, frame: &Frame) {
        self.write(sim, buffer, frame);
        self.request(sim, buffer);
    }

    /// TXREQ, TXABT, TXLARB and TXERR of a buffer, looked at without an access.
    pub fn outcome(self, sim: &Sim, buffer: usize) -> (bool, bool, bool, bool) {
        let control = self.regs(sim).tr_con_of(buffer);
        let (value, lane) = (control.0.read(), control.1);
        (value.txreq(lane), value.txabt(lane), value.txlarb(lane), value.txerr(lane))
    }

    pub fn is_full(self, sim: &Sim, buffer: usize) -> bool {
        let (full, lane) = self.regs(sim).rxful_of(buffer);
        full.read().rxful(lane)
    }

    pub fn has_overflown(self, sim: &Sim, buffer: usize) -> bool {
        let (lost, lane) = self.regs(sim).rxovf_of(buffer);
        lost.read().rxovf(lane)
    }

    /// Clears RXFUL with one store of the complement.
    pub fn release(self, sim: &Sim, buffer: usize) {
        let (full, lane) = self.regs(sim).rxful_of(buffer);
        full.clear(pac::Rxful::rxful_bit(lane));
    }

    /// Reads a message from a buffer.
    pub fn read(self, sim: &Sim, buffer: usize) -> Frame {
        let element = RxBuffer::new(self.memory(sim), buffer * 16);
        let (word0, word2) = (element.word0().read(), element.word2().read());
        let (id, remote) = match word0.ide() {
            IdentifierFormat::Standard => (standard(word0.sid()), word0.srr()),
            IdentifierFormat::Extended => (extended(element.read_extended_id()), word2.rtr()),
        };
        let format = if remote { Format::Remote } else { Format::Data };
        let mut data = [0; 8];
        element.payload().read(&mut data);
        Frame::from_fields(id, format, Dlc::from_low_bits(word2.dlc()), &data)
    }

    /// Reads a full buffer and releases it (9.3.1).
    pub fn take(self, sim: &Sim, buffer: usize) -> Option<Frame> {
        if !self.is_full(sim, buffer) {
            return None;
        }
        let frame = self.read(sim, buffer);
        self.release(sim, buffer);
        Some(frame)
    }

    /// The next message of the FIFO, by FNRB (9.3.1).
    pub fn take_from_fifo(self, sim: &Sim) -> Option<Frame> {
        let next = self.regs(sim).fifo().read().fnrb().unwrap();
        self.take(sim, usize::from(next.bits()))
    }

    pub fn intf(self, sim: &Sim) -> pac::Intf {
        self.regs(sim).intf().read()
    }

    /// Reads the flags and clears those that are set.
    pub fn take_flags(self, sim: &Sim) -> pac::Intf {
        let flags = self.intf(sim);
        self.regs(sim).intf().clear(flags & ALL_FLAGS);
        flags
    }
}

/// Flags without some of them.
pub fn without(flags: pac::Intf, some: pac::Intf) -> pac::Intf {
    pac::Intf::from_bits(flags.bits() & !some.bits())
}

/// The flags that software clears.
pub const ALL_FLAGS: pac::Intf = pac::Intf::from_bits(0x00EF);

/// A module that takes every message into buffer 8 and sends from buffer 0, and a node without controller.
pub fn pair() -> (Sim, Can, PeerId) {
    pair_with(|config| config)
}

pub fn pair_with(change: impl FnOnce(EcanConfig) -> EcanConfig) -> (Sim, Can, PeerId) {
    let sim = Sim::new();
    let can = add_with(&sim, "can1", change);
    let other = peer(&sim);
    can.set_up(&sim).add_filter(&sim, everything(FilterTarget::Buffer(8)));
    can.transmit_buffer(&sim, 0, TxPriority::Lowest).enter(&sim, OperationMode::Normal);
    (sim, can, other)
}

/// What a node without controller has received.
pub fn received(sim: &Sim, peer: PeerId) -> Vec<String> {
    sim.peer_received(peer).iter().map(|(_, frame)| frame.to_string()).collect()
}
