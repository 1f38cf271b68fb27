//! Operating modes (34.5, 34.14).

use pic32_can_pac::{enums::OperationMode, registers as pac};
use regbus::Bus;

use super::{Can, Inner};
use crate::{
    Deadline, TimedOut,
    deadline::wait,
    error::Refused,
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Running},
};

impl<R: Bus, M: Bus> Inner<R, M> {
    /// 34.5: a mode is requested, and in force when OPMOD shows it. Through a read-modify-write of CiCON, whose bits only
    /// software changes, but for ABAT, which is written neutrally.
    fn request_mode(&self, mode: OperationMode) {
        self.regs.con().modify(|con| con.with_reqop(mode));
    }

    fn mode(&self) -> Result<OperationMode, u8> {
        self.regs.con().read().opmod()
    }

    /// Requests a mode and waits for it; goes back to the one before if it does not come.
    fn change_mode(&self, mode: OperationMode, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        let before = self.mode();
        self.request_mode(mode);
        let reached = wait(deadline, || self.mode() == Ok(mode));
        if let (Err(_), Ok(before)) = (reached, before) {
            self.request_mode(before);
        }
        reached
    }

    /// 34.6.4: entering Configuration mode has reset all FIFOs.
    fn forget(&mut self) {
        self.fifos.iter_mut().for_each(super::fifo::Fifo::forget);
        self.requested = 0;
        self.aborting = 0;
        self.errors = 0;
        self.lost_arbitration = 0;
    }
}

type Changed<T, F> = Result<T, Refused<F>>;

impl<S, R: Bus, M: Bus> Can<S, R, M> {
    fn change<T>(self, mode: OperationMode, mut deadline: impl Deadline) -> Changed<Can<T, R, M>, Self> {
        match self.inner.change_mode(mode, &mut deadline) {
            Ok(()) => {
                report!("PIC32 CAN is in {mode:?} mode");
                Ok(self.into_mode())
            }
            Err(error) => Err(self.refuse(error)),
        }
    }
}

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    fn leave<T>(self, mode: OperationMode, deadline: impl Deadline) -> Changed<Can<T, R, M>, Self> {
        let mut can = self.change(mode, deadline)?;
        can.inner.put_preloaded();
        Ok(can)
    }

    /// Normal Operation mode (34.5.2). It is reached when the bus has been recessive for 11 bits.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow; the module is in Configuration mode then.
    pub fn start_normal(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.leave(OperationMode::Normal, deadline)
    }

    /// Listen All Messages mode (34.5.4): as Normal mode, and messages with an error are stored too, with the data up to
    /// the error. Nothing in a message tells that it had one.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_listen_all(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.leave(OperationMode::ListenAll, deadline)
    }

    /// Listen Only mode (34.5.3): receives, sends nothing, not even an acknowledgement.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_monitoring(self, deadline: impl Deadline) -> Changed<Can<ListenOnly, R, M>, Self> {
        self.leave(OperationMode::ListenOnly, deadline)
    }

    /// Loopback mode (34.5.5): cut off from the bus.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_internal_loop_back(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(OperationMode::Loopback, deadline)
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Configuration mode (34.5.1), once the message in progress is over. All FIFOs are emptied and the error counters
    /// cleared.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow; the module goes on.
    pub fn into_configuration(self, deadline: impl Deadline) -> Changed<Can<Configuration, R, M>, Self> {
        let mut can = self.change(OperationMode::Configuration, deadline)?;
        can.inner.forget();
        Ok(can)
    }
}

impl<R: Bus, M: Bus> Can<ListenOnly, R, M> {
    /// Normal operation from Listen Only mode; the FIFOs keep their messages (34.5).
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow.
    pub fn leave_monitoring(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.change(OperationMode::Normal, deadline)
    }
}

impl<R: Bus, M: Bus> Can<Running, R, M> {
    /// Disable mode (34.5.6, 34.14.1), once what was requested is sent. Then the device may go to sleep. Error counters
    /// and FIFOs stay as they are. Traffic on the bus raises WAKIF while the device sleeps, not while only the module is
    /// disabled (34.14.3).
    ///
    /// # Errors
    /// [`TimedOut`] if that does not happen within the bound; the module goes on.
    pub fn disable(self, mut deadline: impl Deadline) -> Changed<Can<Asleep, R, M>, Self> {
        if let Err(error) = wait(&mut deadline, || self.inner.waiting() == 0) {
            return Err(self.refuse(error));
        }
        self.change(OperationMode::Disable, deadline)
    }
}

impl<R: Bus, M: Bus> Can<Asleep, R, M> {
    /// Normal operation from Disable mode (34.14.3): waking up does not change the mode by itself.
    ///
    /// # Errors
    /// [`TimedOut`] if OPMOD does not follow; the module is in Disable mode then.
    pub fn enable(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.change(OperationMode::Normal, deadline)
    }

    /// Traffic on the bus has been seen while the device slept (WAKIF).
    #[must_use]
    pub fn was_woken(&self) -> bool {
        self.inner.regs.int_().read().wakif()
    }

    /// Clears WAKIF.
    pub fn clear_wake_up(&mut self) {
        self.inner.regs.int_().clear_bits(pac::Int::WAKIF);
    }
}
