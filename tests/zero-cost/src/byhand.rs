//! What one writes without a register crate.

pub(crate) unsafe fn get16(base: usize, offset: usize) -> u16 {
    unsafe { ((base + offset) as *const u16).read_volatile() }
}

pub(crate) unsafe fn put16(base: usize, offset: usize, value: u16) {
    unsafe { ((base + offset) as *mut u16).write_volatile(value) }
}

pub(crate) unsafe fn get32(base: usize, offset: usize) -> u32 {
    unsafe { ((base + offset) as *const u32).read_volatile() }
}

pub(crate) unsafe fn put32(base: usize, offset: usize, value: u32) {
    unsafe { ((base + offset) as *mut u32).write_volatile(value) }
}

/// The check of an index, as far from the hot path as in the runtime.
#[track_caller]
pub(crate) fn check(index: usize, first: usize, count: usize, what: &'static str) -> usize {
    if index < first || index - first >= count {
        refuse(what);
    }
    index - first
}

/// Visible from outside, so that the compiler cannot fold the one message in.
#[cold]
#[inline(never)]
#[track_caller]
#[unsafe(no_mangle)]
pub fn refuse(what: &'static str) -> ! {
    panic!("{}", what)
}
