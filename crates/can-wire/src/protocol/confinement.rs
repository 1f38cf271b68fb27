//! Fault confinement: the two error counters and the states they lead to (ISO 11898-1:2015, 10.11).

use crate::{ErrorState, EventKind};

use super::Context;

/// A counter above this makes the node error passive.
const PASSIVE_ABOVE: u16 = 127;
/// A transmit error counter above this makes the node bus off.
const BUS_OFF_ABOVE: u16 = 255;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) struct Confinement {
    pub(crate) tec: u16,
    pub(crate) rec: u16,
    pub(crate) state: ErrorState,
}

impl Confinement {
    /// Rules c, d and f: a transmitter's error.
    pub(crate) fn transmit_error(&mut self, cx: &mut Context<'_>) {
        // The counter has eight bits and the bus-off condition; what it would count beyond is not observable.
        self.tec = (self.tec + 8).min(BUS_OFF_ABOVE + 1);
        self.counted(cx);
    }

    /// Rules a (by 1), b, e and f (by 8): a receiver's error.
    pub(crate) fn receive_error(&mut self, by: u16, cx: &mut Context<'_>) {
        let rec = (self.rec + by).min(255);
        if rec != self.rec {
            self.rec = rec;
            self.counted(cx);
        }
    }

    /// Rule g: a frame was transmitted.
    pub(crate) fn transmitted(&mut self, cx: &mut Context<'_>) {
        if self.tec > 0 {
            self.tec -= 1;
            self.counted(cx);
        }
    }

    /// Rule h: a frame was received up to the ACK slot and acknowledged.
    pub(crate) fn received(&mut self, after_passive: u8, cx: &mut Context<'_>) {
        if self.rec > 0 {
            self.rec = if self.rec > PASSIVE_ABOVE {
                u16::from(after_passive)
            } else {
                self.rec - 1
            };
            self.counted(cx);
        }
    }

    /// Rule l: the recovery is complete; also a reset by the controller.
    pub(crate) fn reset(&mut self, tec: u16, rec: u16, cx: &mut Context<'_>) {
        self.tec = tec.min(BUS_OFF_ABOVE);
        self.rec = rec.min(255);
        let from = self.state;
        self.state = ErrorState::Active;
        self.evaluate();
        let to = self.state;
        cx.emit(EventKind::Counters {
            tec: self.tec,
            rec: self.rec,
        });
        if from != to {
            cx.emit(EventKind::ErrorState { from, to });
        }
    }

    /// Rules i, j and k.
    fn evaluate(&mut self) {
        if self.tec > BUS_OFF_ABOVE {
            self.state = ErrorState::BusOff;
        } else if self.state != ErrorState::BusOff {
            let passive = self.tec > PASSIVE_ABOVE || self.rec > PASSIVE_ABOVE;
            self.state = if passive {
                ErrorState::Passive
            } else {
                ErrorState::Active
            };
        }
    }

    fn counted(&mut self, cx: &mut Context<'_>) {
        let from = self.state;
        self.evaluate();
        cx.emit(EventKind::Counters {
            tec: self.tec.min(BUS_OFF_ABOVE),
            rec: self.rec,
        });
        if from != self.state {
            cx.emit(EventKind::ErrorState {
                from,
                to: self.state,
            });
        }
    }
}
