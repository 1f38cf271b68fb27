//! The two Rx FIFOs (2.3.27 to 2.3.29, 2.3.31 to 2.3.33, 3.4.2, 3.6).

use can_frame::Frame;
use m_can_pac::{
    enums::FifoMode,
    registers::{self as pac, Ir},
};

use super::{MCanModel, filters::Verdict, rx::Stored};
use crate::{diagnostic::DiagnosticKind, model::Context, registers::FieldAt};

/// How a FIFO is configured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FifoConfig {
    pub(super) start: u32,
    /// More than 64 elements count as 64.
    pub(super) size: u32,
    watermark: u32,
    overwrite: bool,
    pub(super) code: u8,
}

/// Status fields and interrupt flags of a FIFO.
pub(super) struct FifoNames {
    pub(super) full: FieldAt,
    pub(super) put: FieldAt,
    pub(super) get: FieldAt,
    pub(super) level: FieldAt,
    new_message: Ir,
    reached: Ir,
    became_full: Ir,
    lost: Ir,
}

impl MCanModel {
    pub(super) fn fifo_names(&self, fifo: usize) -> FifoNames {
        let f = &self.f;
        if fifo == 0 {
            FifoNames {
                full: f.f0f,
                put: f.f0pi,
                get: f.f0gi,
                level: f.f0fl,
                new_message: Ir::RF0N,
                reached: Ir::RF0W,
                became_full: Ir::RF0F,
                lost: Ir::RF0L,
            }
        } else {
            FifoNames {
                full: f.f1f,
                put: f.f1pi,
                get: f.f1gi,
                level: f.f1fl,
                new_message: Ir::RF1N,
                reached: Ir::RF1W,
                became_full: Ir::RF1F,
                lost: Ir::RF1L,
            }
        }
    }

    pub(super) fn fifo_config(&self, fifo: usize) -> FifoConfig {
        let rxesc = pac::Rxesc::from_bits(self.regs.get(self.r.rxesc));
        if fifo == 0 {
            let c = pac::Rxf0c::from_bits(self.regs.get(self.r.rxf0c));
            FifoConfig {
                start: u32::from(c.f0sa()),
                size: u32::from(c.f0s()).min(64),
                watermark: u32::from(c.f0wm()),
                overwrite: c.f0om() == FifoMode::Overwrite,
                code: rxesc.f0ds().bits(),
            }
        } else {
            let c = pac::Rxf1c::from_bits(self.regs.get(self.r.rxf1c));
            FifoConfig {
                start: u32::from(c.f1sa()),
                size: u32::from(c.f1s()).min(64),
                watermark: u32::from(c.f1wm()),
                overwrite: c.f1om() == FifoMode::Overwrite,
                code: rxesc.f1ds().bits(),
            }
        }
    }

    /// Word address and data field code of the element that the next message of a FIFO is written to.
    pub(super) fn next_element(&self, fifo: usize) -> Option<(u32, u8)> {
        let config = self.fifo_config(fifo);
        let names = self.fifo_names(fifo);
        let blocked = config.size == 0 || self.regs.is_set(names.full) && !config.overwrite;
        let words = Self::rx_element_words(config.code);
        (!blocked).then(|| (config.start + self.regs.field(names.put) * words, config.code))
    }

    /// 3.4.2.
    pub(super) fn store_in_fifo(
        &mut self,
        cx: &mut Context<'_>,
        fifo: usize,
        frame: &Frame,
        verdict: &Verdict,
        tsu: Option<u8>,
    ) -> Stored {
        let names = self.fifo_names(fifo);
        let Some((start, code)) = self.next_element(fifo) else {
            // 3.4.2.1, 2.3.16: blocked while full, and with size zero.
            self.raise(cx, names.lost);
            return Stored::Lost;
        };
        let config = self.fifo_config(fifo);
        self.write_element(cx, start, code, frame, verdict, tsu);
        let (put, level) = (self.regs.field(names.put), self.regs.field(names.level));
        let next = |index: u32| if index + 1 >= config.size { 0 } else { index + 1 };
        self.regs.set_field(names.put, next(put));
        let mut flags = names.new_message;
        if self.regs.is_set(names.full) {
            // 3.4.2.2: overwrite mode: both indices move on, the FIFO stays full (overwrite_fill_level).
            let get = next(self.regs.field(names.get));
            self.regs.set_field(names.get, get);
        } else {
            let level = level + 1;
            self.regs.set_field(names.level, level);
            if level >= config.size {
                self.regs.set_field(names.full, 1);
                flags |= names.became_full;
            }
        }
        // 2.3.27: 0 and more than 64 switch the watermark off.
        let (before, after) = (level, self.regs.field(names.level));
        let rises = after > before || self.config.choices.watermark_repeats;
        if (1..=64).contains(&config.watermark) && rises && self.reaches(after, config.watermark) {
            flags |= names.reached;
        }
        self.raise(cx, flags);
        Stored::At(put)
    }

    /// 2.3.29, 3.6: the Get Index becomes the acknowledged one plus one, unchecked.
    pub(super) fn acknowledge_rx(&mut self, cx: &mut Context<'_>, fifo: usize, index: u32) {
        let FifoConfig { size, .. } = self.fifo_config(fifo);
        let names = self.fifo_names(fifo);
        let (get, put, fill) = (self.regs.field(names.get), self.regs.field(names.put), self.regs.field(names.level));
        let register = if fifo == 0 { "RXF0A" } else { "RXF1A" };
        let valid = index < size && (index + size - get % size.max(1)) % size < fill;
        if !valid {
            cx.report("3.6", DiagnosticKind::AcknowledgeInvalid { register, index, get, fill });
        }
        // 3.1.1: while CCE is 1 the Rx Handler is idle, and its status held in reset.
        if self.cccr().cce() || size == 0 {
            return;
        }
        // acknowledge_wrap, acknowledge_invalid.
        let get = if index + 1 >= size { 0 } else { index + 1 };
        self.regs.set_field(names.get, get);
        self.regs.set_field(names.level, (put + size - get) % size);
        self.regs.set_field(names.full, 0);
    }
}
