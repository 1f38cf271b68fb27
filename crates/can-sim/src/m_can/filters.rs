//! Acceptance filtering (2.3.20 to 2.3.23, 2.4.5, 2.4.6, 3.4.1).

use can_frame::{Frame, Id};
use m_can_pac::{
    enums::{ExtendedFilterType, FilterAction, NonMatching, RemoteFrames, RxBufferUse, StandardFilterType},
    messages::{
        ExtendedFilterF0, ExtendedFilterF1, ExtendedFilterF1RxBuffer, StandardFilterS0, StandardFilterS0RxBuffer,
    },
    registers as pac,
};

use super::MCanModel;
use crate::model::Context;

/// Where a message goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Destination {
    /// Discarded.
    Nowhere,
    /// Rx FIFO 0 or 1.
    Fifo(usize),
    /// A dedicated Rx Buffer, or one of the debug messages A, B, C.
    Buffer { number: u8, purpose: RxBufferUse },
}

/// The outcome of acceptance filtering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Verdict {
    pub(super) destination: Destination,
    /// Index of the matching element; `None` if none matched.
    pub(super) element: Option<u8>,
    /// The element sets IR.HPM and HPMS.
    pub(super) priority: bool,
    /// SSYNC or ESYNC of the element.
    pub(super) sync: bool,
    /// Filter event pins that the match pulses.
    pub(super) pins: u8,
}

const NOWHERE: Verdict =
    Verdict { destination: Destination::Nowhere, element: None, priority: false, sync: false, pins: 0 };

/// One element, whichever list it is in.
struct Element {
    action: FilterAction,
    matches: bool,
    sync: bool,
    number: u8,
    purpose: RxBufferUse,
    pins: u8,
}

impl MCanModel {
    /// Numbers of elements in the two lists; more than 128 and 64 count as these (2.3.21, 2.3.22).
    pub(super) fn filter_counts(&self) -> (u32, u32) {
        let standard = u32::from(pac::Sidfc::from_bits(self.regs.get(self.r.sidfc)).lss()).min(128);
        let extended = u32::from(pac::Xidfc::from_bits(self.regs.get(self.r.xidfc)).lse()).min(64);
        (standard, extended)
    }

    /// 3.4.1: the list for the identifier's length from element 0 to the first match.
    pub(super) fn filter(&mut self, cx: &mut Context<'_>, frame: &Frame) -> Verdict {
        let gfc = pac::Gfc::from_bits(self.regs.get(self.r.gfc));
        let extended = frame.is_extended();
        let (standard_count, extended_count) = self.filter_counts();
        let (remote, others, count) = match extended {
            false => (gfc.rrfs(), gfc.anfs(), standard_count),
            true => (gfc.rrfe(), gfc.anfe(), extended_count),
        };
        // non_matching_remote_frames: rejected before the list.
        if frame.is_remote() && remote == RemoteFrames::Reject {
            return NOWHERE;
        }
        for index in 0..count {
            let element = match frame.id() {
                Id::Standard(id) => self.standard_element(cx, index, id.as_raw()),
                Id::Extended(id) => self.extended_element(cx, index, id.as_raw()),
            };
            if let Some(verdict) = element.and_then(|element| self.decide(&element, index as u8)) {
                return verdict;
            }
        }
        let destination = match others {
            NonMatching::RxFifo0 => Destination::Fifo(0),
            NonMatching::RxFifo1 => Destination::Fifo(1),
            NonMatching::Reject | NonMatching::RejectAlt => Destination::Nowhere,
        };
        Verdict { destination, ..NOWHERE }
    }

    /// What a matching element does with the message; `None` if filtering goes on.
    fn decide(&self, element: &Element, index: u8) -> Option<Verdict> {
        if !element.matches {
            return None;
        }
        let (destination, priority) = match element.action {
            FilterAction::Disabled => return None,
            FilterAction::Fifo0 => (Destination::Fifo(0), false),
            FilterAction::Fifo1 => (Destination::Fifo(1), false),
            FilterAction::Reject => (Destination::Nowhere, false),
            FilterAction::Priority => (Destination::Nowhere, true),
            FilterAction::PriorityFifo0 => (Destination::Fifo(0), true),
            FilterAction::PriorityFifo1 => (Destination::Fifo(1), true),
            FilterAction::RxBuffer => {
                // 3.4.3: while its New Data flag is set, an Rx Buffer's element does not match.
                if element.purpose == RxBufferUse::RxBuffer && self.has_new_data(element.number) {
                    return None;
                }
                (Destination::Buffer { number: element.number, purpose: element.purpose }, false)
            }
        };
        Some(Verdict { destination, element: Some(index), priority, sync: element.sync, pins: element.pins })
    }

    /// 2.4.5.
    fn standard_element(&mut self, cx: &mut Context<'_>, index: u32, id: u16) -> Option<Element> {
        let start = u32::from(pac::Sidfc::from_bits(self.regs.get(self.r.sidfc)).flssa());
        let word = self.ram_read(cx, start + index);
        let element = StandardFilterS0::from_bits(word);
        let (id1, id2) = (element.sfid1(), element.sfid2());
        let action = element.sfec();
        let buffer = StandardFilterS0RxBuffer::from_bits(word);
        // SFT is ignored with SFEC = 7: the identifier equals SFID1 (2.4.5).
        let matches = if action == FilterAction::RxBuffer {
            id == id1
        } else {
            match element.sft() {
                StandardFilterType::Range => (id1..=id2).contains(&id),
                StandardFilterType::Dual => id == id1 || id == id2,
                StandardFilterType::Classic => (id ^ id1) & id2 == 0,
                StandardFilterType::Disabled => return None,
            }
        };
        let buffers = action == FilterAction::RxBuffer;
        Some(Element {
            action,
            matches,
            sync: element.ssync(),
            number: buffer.buffer(),
            purpose: buffer.destination(),
            pins: if buffers { buffer.event_pins() } else { 0 },
        })
    }

    /// 2.4.6, 3.4.1.5: XIDAM masks the received identifier, except for EFT = 3.
    fn extended_element(&mut self, cx: &mut Context<'_>, index: u32, id: u32) -> Option<Element> {
        let start = u32::from(pac::Xidfc::from_bits(self.regs.get(self.r.xidfc)).flesa());
        let words = [0, 1].map(|word| self.ram_read(cx, start + index * 2 + word));
        let (f0, f1) = (ExtendedFilterF0::from_bits(words[0]), ExtendedFilterF1::from_bits(words[1]));
        let (id1, id2) = (f0.efid1(), f1.efid2());
        let masked = id & pac::Xidam::from_bits(self.regs.get(self.r.xidam)).eidm();
        let action = f0.efec();
        let buffer = ExtendedFilterF1RxBuffer::from_bits(words[1]);
        let matches = if action == FilterAction::RxBuffer {
            masked == id1
        } else {
            match f1.eft() {
                ExtendedFilterType::Range => (id1..=id2).contains(&masked),
                ExtendedFilterType::Dual => masked == id1 || masked == id2,
                ExtendedFilterType::Classic => (masked ^ id1) & id2 == 0,
                ExtendedFilterType::RangeUnmasked => (id1..=id2).contains(&id),
            }
        };
        let buffers = action == FilterAction::RxBuffer;
        Some(Element {
            action,
            matches,
            sync: f1.esync(),
            number: buffer.buffer(),
            purpose: buffer.destination(),
            pins: if buffers { buffer.event_pins() } else { 0 },
        })
    }

    /// How many Rx Buffers the filter elements refer to: one more than the highest number.
    pub(super) fn referenced_rx_buffers(&mut self, cx: &mut Context<'_>) -> u32 {
        let (standard, extended) = self.filter_counts();
        let mut count = 0;
        for index in 0..standard {
            if let Some(element) = self.standard_element(cx, index, 0) {
                count = count.max(used(&element));
            }
        }
        for index in 0..extended {
            if let Some(element) = self.extended_element(cx, index, 0) {
                count = count.max(used(&element));
            }
        }
        count
    }
}

fn used(element: &Element) -> u32 {
    if element.action == FilterAction::RxBuffer { u32::from(element.number) + 1 } else { 0 }
}
