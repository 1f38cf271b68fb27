//! Memory that a controller shares with its driver.

use regbus::Bus;

/// A piece of message memory: Message RAM of an M_CAN, system or DMA RAM of the others.
#[derive(Clone, Copy, Debug)]
pub struct Region<M> {
    bus: M,
    address: u32,
    bytes: u32,
}

impl<M: Bus> Region<M> {
    /// `bytes` of memory, whose first byte the host reaches at offset 0 of `bus` and the controller at `address`.
    ///
    /// # Safety
    ///
    /// The memory is there, and nothing but the controller and the driver that gets this region accesses it for as long
    /// as the controller is not in configuration mode: the controller writes what it receives into it.
    #[allow(unsafe_code, reason = "what the controller does with the address cannot be checked")]
    #[must_use]
    pub const unsafe fn new(bus: M, address: u32, bytes: u32) -> Self {
        Self { bus, address, bytes }
    }

    /// The bus; offset 0 is the first byte.
    #[inline]
    #[must_use]
    pub const fn bus(&self) -> M {
        self.bus
    }

    /// Address of the first byte as the controller sees it.
    #[must_use]
    pub const fn address(&self) -> u32 {
        self.address
    }

    /// Number of bytes.
    #[must_use]
    pub const fn bytes(&self) -> u32 {
        self.bytes
    }
}
