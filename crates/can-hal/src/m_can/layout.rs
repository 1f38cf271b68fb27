//! Sections of the Message RAM, as the driver needs them (2.4.1).

use m_can_pac::{
    enums::DataFieldSize,
    messages::{RxBuffer, TxBuffer},
    registers::{Rxesc, Txesc},
};
use regbus::{Bus, Mmio};

use super::ConfigError;
use crate::{
    Region,
    memory::{MCanPlan, Placed},
};

/// A run of equal elements. Start addresses reach 64 KiB (2.4.1), an element has 72 bytes at most (Table 55).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Section {
    /// Where it begins, in 32-bit words of the Message RAM.
    pub(super) word: u16,
    /// The same in bytes of the region.
    offset: u16,
    /// Bytes of an element.
    element: u8,
    pub(super) count: u8,
}

impl Section {
    /// Offset of an element.
    #[inline]
    pub(super) const fn at(&self, index: u8) -> usize {
        self.offset as usize + self.element as usize * index as usize
    }

    #[inline(never)]
    fn new(placed: Placed, address: u32, bytes: u32) -> Result<Self, ConfigError> {
        let element = placed.element_bytes as u8;
        if placed.elements == 0 {
            return Ok(Self { word: 0, offset: 0, element, count: 0 });
        }
        match placed.start.checked_sub(address) {
            Some(offset) if offset <= bytes && placed.bytes() <= bytes - offset => {
                let (word, offset) = ((placed.start / 4) as u16, offset as u16);
                Ok(Self { word, offset, element, count: placed.elements as u8 })
            }
            _ => Err(ConfigError::OutsideRegion(placed)),
        }
    }

    /// Bytes behind the first two words of each element, for data.
    #[inline]
    pub(super) const fn data(&self) -> usize {
        self.element as usize - RxBuffer::<Mmio>::HEADER_BYTES
    }
}

const _: () = assert!(RxBuffer::<Mmio>::HEADER_BYTES == TxBuffer::<Mmio>::HEADER_BYTES, "Section::data serves both");

/// A plan whose sections lie in a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) standard_filters: Section,
    pub(super) extended_filters: Section,
    pub(super) rx_fifos: [Section; 2],
    pub(super) rx_buffers: Section,
    pub(super) tx_events: Section,
    pub(super) tx_buffers: Section,
    /// Tx Buffers that are dedicated; the others are those of the Tx FIFO or Tx Queue.
    pub(super) dedicated: u8,
}

impl Layout {
    pub(super) fn new<M: Bus>(plan: &MCanPlan, region: &Region<M>) -> Result<Self, ConfigError> {
        let section = |placed| Section::new(placed, region.address(), region.bytes());
        let tx_buffers = section(plan.tx_buffers())?;
        Ok(Self {
            standard_filters: section(plan.standard_filters())?,
            extended_filters: section(plan.extended_filters())?,
            rx_fifos: [section(plan.rx_fifo_0())?, section(plan.rx_fifo_1())?],
            rx_buffers: section(plan.rx_buffers())?,
            tx_events: section(plan.tx_event_fifo())?,
            tx_buffers,
            dedicated: plan.txbc.ndtb().min(tx_buffers.count),
        })
    }

    /// Elements of the Tx FIFO or Tx Queue.
    #[inline]
    pub(super) const fn queue(&self) -> u8 {
        self.tx_buffers.count - self.dedicated
    }

    /// 2.3.34
    pub(super) const fn rxesc(&self) -> Rxesc {
        let [fifo_0, fifo_1] = &self.rx_fifos;
        Rxesc::ZERO.with_f0ds(size(fifo_0)).with_f1ds(size(fifo_1)).with_rbds(size(&self.rx_buffers))
    }

    /// 2.3.37
    pub(super) const fn txesc(&self) -> Txesc {
        Txesc::ZERO.with_tbds(size(&self.tx_buffers))
    }
}

/// The code of an element's data field.
const fn size(section: &Section) -> DataFieldSize {
    let sizes = RxBuffer::<Mmio>::PAYLOAD_BYTES;
    let mut code = 0;
    while code < sizes.len() && sizes[code] < section.data() {
        code += 1;
    }
    DataFieldSize::from_bits(code as u8)
}
