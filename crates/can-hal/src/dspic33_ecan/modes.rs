//! Changes of mode (7.0, 13.0).

use dspic33_ecan_pac::enums::{Ctrl1Win, OperationMode};
use regbus::Bus;

use super::{Can, Inner, tx::TX_BUFFERS};
use crate::{
    Deadline, TimedOut,
    deadline::wait,
    error::Refused,
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Running},
};

impl<R: Bus, M: Bus> Inner<R, M> {
    fn request(&self, mode: OperationMode) {
        self.regs.ctrl1().modify(|ctrl1| ctrl1.with_reqop(mode));
    }

    /// 7.0: requests a mode and waits until OPMODE shows it. The request is withdrawn if it does not.
    fn enter(&self, mode: OperationMode, from: OperationMode, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        self.request(mode);
        let entered = wait(deadline, || self.regs.ctrl1().read().opmode() == Ok(mode));
        if entered.is_err() {
            self.request(from);
        }
        entered
    }

    /// Configuration mode, whatever mode the module is in; the filter window closed, filters disabled.
    pub(super) fn take_over(&self, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        let ctrl1 = self.regs.ctrl1();
        ctrl1.modify(|value| value.with_win(Ctrl1Win::Buffer).with_reqop(OperationMode::Configuration));
        wait(deadline, || ctrl1.read().opmode() == Ok(OperationMode::Configuration))?;
        self.disable_filters();
        Ok(())
    }

    /// The mode the module is in, or one that it can go back to.
    fn mode_now(&self) -> OperationMode {
        self.regs.ctrl1().read().opmode().unwrap_or(OperationMode::Configuration)
    }
}

type Changed<T, F> = Result<T, Refused<F>>;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    fn leave<T>(self, mode: OperationMode, mut deadline: impl Deadline) -> Changed<Can<T, R, M>, Self> {
        match self.inner.enter(mode, OperationMode::Configuration, &mut deadline) {
            Ok(()) => {
                report!("ECAN goes on the bus: {:?}", mode);
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }

    /// Normal Operation mode (7.2).
    ///
    /// # Errors
    /// [`TimedOut`] if OPMODE does not follow: the module waits for 11 recessive bits.
    pub fn start_normal(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.leave(OperationMode::Normal, deadline)
    }

    /// Listen-Only mode (7.3): receives, sends nothing, not even an acknowledgement; for finding out the bit rate of a bus.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_listening(self, deadline: impl Deadline) -> Changed<Can<ListenOnly, R, M>, Self> {
        self.leave(OperationMode::ListenOnly, deadline)
    }

    /// Listen All Messages mode (7.4): normal operation in which every message is received, whatever its identifier, and
    /// one with an error too. A message that matches no filter goes to the buffer of the first one
    /// (`listen_all_destination`).
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_listen_all(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.leave(OperationMode::ListenAll, deadline)
    }

    /// Loopback mode (7.5): receives what it sends, without acknowledgement by others.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_loopback(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(OperationMode::Loopback, deadline)
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Configuration mode (7.1). A frame on the bus is finished; what waits to be sent is aborted, and messages that were
    /// not fetched are lost.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMODE does not follow.
    pub fn into_configuration(mut self, mut deadline: impl Deadline) -> Changed<Can<Configuration, R, M>, Self> {
        let from = self.inner.mode_now();
        match self.inner.enter(OperationMode::Configuration, from, &mut deadline) {
            Ok(()) => {
                self.inner.write_controls();
                self.inner.forget_requests();
                self.inner.clear_messages();
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<R: Bus, M: Bus> Can<ListenOnly, R, M> {
    /// Normal operation from Listen-Only mode, without leaving the bus (7.0).
    ///
    /// # Errors
    /// [`TimedOut`] if OPMODE does not follow.
    pub fn join(self, mut deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        match self.inner.enter(OperationMode::Normal, OperationMode::ListenOnly, &mut deadline) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<R: Bus, M: Bus> Can<Running, R, M> {
    /// Disable mode (7.6, 13.1): waits until everything is sent and the bus is idle. Then the CPU may go to Sleep, or to
    /// Idle. While the device sleeps, bus activity sets INTF.WAKIF; the message that does is lost.
    ///
    /// # Errors
    /// [`TimedOut`] if that does not happen within the bound; the module goes on then.
    pub fn disable(self, mut deadline: impl Deadline) -> Changed<Can<Asleep, R, M>, Self> {
        let inner = &self.inner;
        let from = inner.mode_now();
        let sent = (0..TX_BUFFERS / 2)
            .filter(|pair| inner.pair_sends(*pair))
            .try_for_each(|pair| wait(&mut deadline, || !inner.pair_is_pending(pair)));
        match sent.and_then(|()| inner.enter(OperationMode::Disable, from, &mut deadline)) {
            Ok(()) => {
                report!("ECAN is disabled");
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<R: Bus, M: Bus> Can<Asleep, R, M> {
    /// Normal operation from Disable mode. The module does not leave it by itself, also when it has woken the CPU (13.3).
    ///
    /// # Errors
    /// [`TimedOut`] if OPMODE does not follow.
    pub fn enable(self, mut deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        match self.inner.enter(OperationMode::Normal, OperationMode::Disable, &mut deadline) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => Err(self.refuse(error)),
        }
    }
}
