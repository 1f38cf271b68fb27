//! Changes of mode (4.0).
#![allow(clippy::result_large_err, reason = "a driver that is refused comes back by value: nothing is allocated")]

use dspic33_canfd_pac::enums::OperationMode;
use regbus::Bus;

use super::{Can, FdMode, Inner, SETTLE, layout::numbers};
use crate::{
    Deadline, TimedOut,
    deadline::{Polls, wait},
    error::Refused,
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Restricted, Running},
};

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Writes REQOP with the options of the configuration.
    pub(super) fn request_mode(&self, mode: OperationMode) {
        self.regs.con_h().write(self.con_h.with_reqop(mode));
    }

    pub(super) fn mode(&self) -> OperationMode {
        self.regs.con_h().read().opmod()
    }

    /// 4.1: requests a mode and waits for OPMOD. If it does not follow, the mode it was in is requested again.
    fn enter(&self, mode: OperationMode, back: OperationMode, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        self.request_mode(mode);
        let entered = wait(deadline, || self.mode() == mode);
        if entered.is_err() {
            self.request_mode(back);
            let _settles = wait(&mut Polls(SETTLE), || self.mode() == back);
        }
        entered
    }

    /// Normal operation with the formats of the configuration (4.3).
    const fn normal(&self) -> OperationMode {
        match self.fd {
            FdMode::Classic => OperationMode::NormalCan2_0,
            FdMode::Fd { .. } => OperationMode::NormalCanFd,
        }
    }

    /// 4.2: Configuration mode has reset all FIFOs. 6.11: the replies are armed.
    fn start_fifos(&mut self) {
        self.tracks = Default::default();
        for number in numbers(self.replies) {
            self.arm(number);
        }
    }
}

/// The driver comes back by value: there is no allocation to put it in.
type Changed<T, F> = Result<T, Refused<F>>;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    fn leave<T>(mut self, mode: OperationMode, mut deadline: impl Deadline) -> Changed<Can<T, R, M>, Self> {
        match self.inner.enter(mode, OperationMode::Configuration, &mut deadline) {
            Ok(()) => {
                report!("CAN FD module goes to mode {:?}", mode);
                self.inner.start_fifos();
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }

    /// Normal CAN FD mode, or Normal CAN 2.0 mode if the configuration has classic frames only (4.3). It is reached when
    /// the module has seen eleven recessive bits (4.1.5).
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow; the module is in Configuration mode then.
    pub fn start_normal(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        let mode = self.inner.normal();
        self.leave(mode, deadline)
    }

    /// Listen Only mode (4.5.1): receives, sends not a single dominant bit.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_monitoring(self, deadline: impl Deadline) -> Changed<Can<ListenOnly, R, M>, Self> {
        self.leave(OperationMode::ListenOnly, deadline)
    }

    /// Restricted Operation mode (4.5.2): receives and acknowledges, sends no frames and no error flags.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_restricted(self, deadline: impl Deadline) -> Changed<Can<Restricted, R, M>, Self> {
        self.leave(OperationMode::RestrictedOperation, deadline)
    }

    /// Internal Loopback mode (4.5.3.1): cut off from the bus.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_internal_loop_back(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(OperationMode::InternalLoopback, deadline)
    }

    /// External Loopback mode (4.5.3.2): what it sends is seen on the bus; what others send is not heard.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_external_loop_back(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(OperationMode::ExternalLoopback, deadline)
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Configuration mode (4.2), when the message on the bus is over. Pending requests and the contents of FIFOs are lost.
    /// From a mode that a system error has brought about this is the only way back.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow.
    pub fn into_configuration(self, mut deadline: impl Deadline) -> Changed<Can<Configuration, R, M>, Self> {
        let back = self.inner.mode();
        match self.inner.enter(OperationMode::Configuration, back, &mut deadline) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => Err(self.refuse(error)),
        }
    }

    /// The mode that the module is in: after a system error another than the type says (12.3.6).
    #[must_use]
    pub fn operation_mode(&self) -> OperationMode {
        self.inner.mode()
    }
}

impl<R: Bus, M: Bus> Can<Running, R, M> {
    /// Disable mode (4.4, 4.6.1), when all requested messages are sent: the first two of the three steps before the
    /// device's Sleep mode. The wake-up interrupt is enabled; activity on the bus sets it while the device sleeps.
    ///
    /// # Errors
    /// [`TimedOut`] if that does not happen within the bound; the module goes on then.
    pub fn power_down(self, mut deadline: impl Deadline) -> Changed<Can<Asleep, R, M>, Self> {
        let (inner, back) = (&self.inner, self.inner.mode());
        let done = wait(&mut deadline, || inner.pending() & !inner.replies == 0);
        match done.and_then(|()| inner.enter(OperationMode::Disable, back, &mut deadline)) {
            Ok(()) => {
                inner.regs.int_h().modify(|enables| enables.with_wakie(true));
                report!("CAN FD module sleeps");
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<R: Bus, M: Bus> Can<Asleep, R, M> {
    /// Normal operation again (4.6.3). Messages are received after eleven recessive bits; the one that has woken the
    /// device up is lost. INTL.WAKIF stays set if it was.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow; the module is in Disable mode then.
    pub fn power_up(self, mut deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        let mode = self.inner.normal();
        match self.inner.enter(mode, OperationMode::Disable, &mut deadline) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => Err(self.refuse(error)),
        }
    }
}
