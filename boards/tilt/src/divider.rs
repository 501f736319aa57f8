//! Divisions by the chip's divider.
//!
//! A Cortex-M0+ has no instruction for division. Compilers call these routines, and their own versions take hundreds of cycles. (The HAL has such routines, too, but
//! together with others that call the boot ROM, which an emulator lacks.)
#![allow(
    unsafe_code,
    reason = "compilers know these routines by their names, and the divider's registers belong to no one else"
)]

use rp2040_hal::pac::SIO;

/// `dividend / divisor`, towards zero; −1 or 1 for a divisor of zero, which Rust never asks for.
#[unsafe(no_mangle)]
extern "C" fn __aeabi_idiv(dividend: i32, divisor: i32) -> i32 {
    // an interrupt that divides would overwrite the divider's registers
    cortex_m::interrupt::free(|_| {
        let sio = unsafe { SIO::steal() };
        sio.div_sdividend().write(|w| unsafe { w.bits(dividend as u32) });
        sio.div_sdivisor().write(|w| unsafe { w.bits(divisor as u32) });
        while sio.div_csr().read().ready().bit_is_clear() {}
        sio.div_quotient().read().bits() as i32
    })
}

/// The same without signs; all ones for a divisor of zero.
#[unsafe(no_mangle)]
extern "C" fn __aeabi_uidiv(dividend: u32, divisor: u32) -> u32 {
    cortex_m::interrupt::free(|_| {
        let sio = unsafe { SIO::steal() };
        sio.div_udividend().write(|w| unsafe { w.bits(dividend) });
        sio.div_udivisor().write(|w| unsafe { w.bits(divisor) });
        while sio.div_csr().read().ready().bit_is_clear() {}
        sio.div_quotient().read().bits()
    })
}
