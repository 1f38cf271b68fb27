//! Changes of mode (3.1).

use m_can_pac::registers as pac;
use regbus::Bus;

use super::{Can, Inner};
use crate::{
    Deadline, TimedOut,
    deadline::wait,
    error::Refused,
    mode::{Asleep, Configuration, ListenOnly, LoopBack, OnBus, Restricted, Running},
};

impl<R: Bus, M: Bus> Inner<R, M> {
    /// Writes the mode bits, with INIT and what else is given.
    fn write_cccr(&self, bits: pac::Cccr) {
        self.regs.cccr().write(self.cccr | bits);
    }

    /// 3.1.1: leaves software initialization. CCE falls with INIT.
    fn leave_init(&self, mode: pac::Cccr, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        self.write_cccr(mode);
        let left = wait(deadline, || !self.regs.cccr().read().init());
        if left.is_err() {
            self.write_cccr(mode | pac::Cccr::INIT);
        }
        left
    }

    /// 3.1.1: software initialization, then configuration mode. CCE can be set only while INIT is 1.
    fn configuration(&mut self, mode: pac::Cccr, deadline: &mut impl Deadline) -> Result<(), TimedOut> {
        self.write_cccr(mode | pac::Cccr::INIT);
        wait(deadline, || self.regs.cccr().read().init())?;
        // The test mode ends with CCCR.TEST, monitoring and restriction with their bits (3.1.5, 3.1.6, 2.3.5).
        self.write_cccr(pac::Cccr::INIT | pac::Cccr::CCE);
        self.forget();
        Ok(())
    }

    /// 2.3.14: begins the recovery from Bus_Off, in loop back mode as well: TEST and MON stay as they are.
    pub(super) fn leave_init_in_mode(&mut self, mut deadline: impl Deadline) -> Result<(), TimedOut> {
        let mode = self.regs.cccr().read() & (pac::Cccr::TEST | pac::Cccr::MON);
        self.leave_init(mode, &mut deadline)
    }

    /// 3.1.1: setting CCE has reset FIFOs and requests.
    const fn forget(&mut self) {
        self.cancelled = 0;
        self.unseen = 0;
        self.put = None;
        self.acknowledged = [None; 2];
    }
}

type Changed<T, F> = Result<T, Refused<F>>;

impl<R: Bus, M: Bus> Can<Configuration, R, M> {
    fn leave<T>(self, mode: pac::Cccr, mut deadline: impl Deadline) -> Changed<Can<T, R, M>, Self> {
        let protected = pac::Cccr::INIT | pac::Cccr::CCE;
        if !mode.is_empty() {
            // 3.1.1: TEST, MON and ASM can be set only in configuration mode.
            self.inner.write_cccr(mode | protected);
        }
        if mode.contains(pac::Cccr::TEST) {
            // 3.1.9
            self.inner.regs.test().write(pac::Test::ZERO.with_lbck(true));
        }
        match self.inner.leave_init(mode, &mut deadline) {
            Ok(()) => {
                report!("M_CAN goes on the bus: {:?}", self.inner.cccr | mode);
                Ok(self.into_mode())
            }
            Err(error) => {
                self.inner.write_cccr(protected);
                Err(self.refuse(error))
            }
        }
    }

    /// Normal operation (3.1.2). The controller takes part once it has seen 11 recessive bits.
    ///
    /// # Errors
    /// [`TimedOut`] if CCCR.INIT does not follow; the controller is in configuration mode then.
    pub fn start_normal(self, deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        self.leave(pac::Cccr::ZERO, deadline)
    }

    /// Bus Monitoring Mode (3.1.6): receives, sends nothing, not even an acknowledgement.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_monitoring(self, deadline: impl Deadline) -> Changed<Can<ListenOnly, R, M>, Self> {
        self.leave(pac::Cccr::MON, deadline)
    }

    /// Restricted Operation Mode (3.1.5): receives and acknowledges, sends no frames and no error flags; for finding out
    /// the bit rate of a bus.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_restricted(self, deadline: impl Deadline) -> Changed<Can<Restricted, R, M>, Self> {
        self.leave(pac::Cccr::ASM, deadline)
    }

    /// Internal Loop Back Mode (3.1.9.2): cut off from the bus.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_internal_loop_back(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(pac::Cccr::TEST | pac::Cccr::MON, deadline)
    }

    /// External Loop Back Mode (3.1.9.1): what it sends is seen on the bus; what others send is not heard.
    ///
    /// # Errors
    /// As for [`Can::start_normal`].
    pub fn start_external_loop_back(self, deadline: impl Deadline) -> Changed<Can<LoopBack, R, M>, Self> {
        self.leave(pac::Cccr::TEST, deadline)
    }
}

impl<S: OnBus, R: Bus, M: Bus> Can<S, R, M> {
    /// Configuration mode (3.1.1). A transfer on the bus is broken off at once; pending requests and the contents of
    /// FIFOs are lost.
    ///
    /// # Errors
    /// [`TimedOut`] if CCCR.INIT does not follow.
    pub fn into_configuration(mut self, mut deadline: impl Deadline) -> Changed<Can<Configuration, R, M>, Self> {
        let mode = self.inner.regs.cccr().read() & (pac::Cccr::MON | pac::Cccr::TEST | pac::Cccr::ASM);
        match self.inner.configuration(mode, &mut deadline) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => Err(self.refuse(error)),
        }
    }

    /// True if the controller is in Restricted Operation Mode: because it was started so, or because the Message RAM has
    /// failed it (3.1.5, IR.MRAF).
    #[must_use]
    pub fn is_restricted(&self) -> bool {
        self.inner.regs.cccr().read().asm_()
    }
}

impl<R: Bus, M: Bus> Can<Restricted, R, M> {
    /// Normal operation from Restricted Operation Mode, without leaving the bus (3.1.5).
    pub fn leave_restricted(self) -> Can<Running, R, M> {
        self.inner.write_cccr(pac::Cccr::ZERO);
        self.into_mode()
    }
}

impl<R: Bus, M: Bus> Can<ListenOnly, R, M> {
    /// Normal operation from Bus Monitoring Mode, without leaving the bus (3.1.6, 3.1.1: MON may be reset any time).
    pub fn leave_monitoring(self) -> Can<Running, R, M> {
        self.inner.write_cccr(pac::Cccr::ZERO);
        self.into_mode()
    }
}

impl<R: Bus, M: Bus> Can<Running, R, M> {
    /// Ends the Restricted Operation Mode that a failure of the Message RAM has begun (3.1.5).
    pub fn end_restriction(&mut self) {
        self.inner.write_cccr(pac::Cccr::ZERO);
    }

    /// Begins the recovery from Bus_Off, which hardware has begun with CCCR.INIT (2.3.14). It ends after 129 sequences of
    /// 11 recessive bits; starting it again makes it longer, not shorter.
    ///
    /// # Errors
    /// [`TimedOut`] if CCCR.INIT does not follow; it is 1 then.
    pub fn leave_bus_off(&mut self, deadline: impl Deadline) -> Result<(), TimedOut> {
        self.inner.leave_init_in_mode(deadline)
    }

    /// Power Down (3.1.8): waits until pending requests are done and the bus is idle. Then the clocks may be stopped.
    ///
    /// # Errors
    /// [`TimedOut`] if that does not happen within the bound, for example on a disturbed bus; the request is withdrawn
    /// and the controller goes on.
    pub fn power_down(self, mut deadline: impl Deadline) -> Changed<Can<Asleep, R, M>, Self> {
        self.inner.write_cccr(pac::Cccr::CSR);
        match wait(&mut deadline, || self.inner.regs.cccr().read().csa()) {
            Ok(()) => {
                report!("M_CAN sleeps");
                Ok(self.into_mode())
            }
            Err(error) => {
                self.inner.write_cccr(pac::Cccr::ZERO);
                Err(self.refuse(error))
            }
        }
    }
}

impl<R: Bus, M: Bus> Can<Asleep, R, M> {
    /// Ends Power Down (3.1.8). The clocks run again before this is called.
    ///
    /// # Errors
    /// [`TimedOut`] if CCCR.CSA or CCCR.INIT do not follow; the clock stop is requested again then.
    pub fn power_up(self, mut deadline: impl Deadline) -> Changed<Can<Running, R, M>, Self> {
        // INIT is held at 1 until the acknowledge has gone.
        self.inner.write_cccr(pac::Cccr::INIT);
        let acknowledged = wait(&mut deadline, || !self.inner.regs.cccr().read().csa());
        match acknowledged.and_then(|()| self.inner.leave_init(pac::Cccr::ZERO, &mut deadline)) {
            Ok(()) => Ok(self.into_mode()),
            Err(error) => {
                self.inner.write_cccr(pac::Cccr::CSR | pac::Cccr::INIT);
                Err(self.refuse(error))
            }
        }
    }
}
