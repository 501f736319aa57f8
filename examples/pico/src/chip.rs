//! The chip at 200 MHz, which the Pico's SDK supports since its version 2.1.1, at a core voltage of 1.15 V.

use rp2040_hal::Watchdog;
use rp2040_hal::clocks::{ClocksManager, InitError};
use rp2040_hal::fugit::{HertzU32, RateExtU32};
use rp2040_hal::pac::vreg_and_chip_reset::vreg::VSEL_A;
use rp2040_hal::pac::{CLOCKS, PLL_SYS, PLL_USB, RESETS, VREG_AND_CHIP_RESET, XOSC};
use rp2040_hal::pll::common_configs::PLL_USB_48MHZ;
use rp2040_hal::pll::{PLLConfig, setup_pll_blocking};
use rp2040_hal::vreg::set_voltage;
use rp2040_hal::xosc::setup_xosc_blocking;

/// The crystal of a Pico, Hz.
const CRYSTAL: u32 = 12_000_000;

/// 12 MHz · 100 / 6.
const FAST: PLLConfig = PLLConfig { vco_freq: HertzU32::MHz(1200), refdiv: 1, post_div1: 6, post_div2: 1 };

/// The time in which the voltage rises: a millisecond, in cycles of the crystal.
const RISE: u32 = CRYSTAL / 1000;

/// Raises the voltage and starts the clocks.
pub(crate) fn start(
    mut voltage: VREG_AND_CHIP_RESET,
    crystal: XOSC,
    clocks: CLOCKS,
    (system, usb): (PLL_SYS, PLL_USB),
    resets: &mut RESETS,
    watchdog: &mut Watchdog,
) -> Result<ClocksManager, InitError> {
    set_voltage(&mut voltage, VSEL_A::VOLTAGE1_15);
    cortex_m::asm::delay(RISE);
    let crystal = setup_xosc_blocking(crystal, CRYSTAL.Hz()).map_err(InitError::XoscErr)?;
    watchdog.enable_tick_generation((CRYSTAL / 1_000_000) as u8);
    let mut clocks = ClocksManager::new(clocks);
    let frequency = crystal.operating_frequency();
    let system = setup_pll_blocking(system, frequency, FAST, &mut clocks, resets).map_err(InitError::PllError)?;
    let usb = setup_pll_blocking(usb, frequency, PLL_USB_48MHZ, &mut clocks, resets).map_err(InitError::PllError)?;
    clocks.init_default(&crystal, &system, &usb).map_err(InitError::ClockError)?;
    Ok(clocks)
}
