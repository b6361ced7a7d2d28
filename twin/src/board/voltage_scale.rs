//! Voltage scale 0: what the emulator's clock controller cannot know.
//!
//! The regulator gives voltage scale 0 when `ODEN` of `SYSCFG_PWRCR` is set at scale 1 (RM0433 Rev 9,
//! section 6.6.2). The emulator's models of PWR and RCC stop at scale 1 because SYSCFG is another
//! instance's matter, so it tells every clock above 400 MHz as too fast. Here a complaint that came
//! while the overdrive was on, at clocks that scale 0 allows, is none.

use rigless::device::Told;
use rigless::soc::stm32h743::generated::{pwr, rcc};

use super::part::Part;

/// Highest clocks of voltage scale 0, Hz: core, AHB, APB (DS12110 Rev 11, table 112).
const LIMITS_HZ: [u64; 3] = [480_000_000, 240_000_000, 120_000_000];
/// `VOS` of scale 1.
const SCALE_1: u64 = 0b11;
/// How the emulator words a clock above the scale.
const COMPLAINT: &str = "for the voltage scale in use";

impl Part {
    /// Whether `told` is a complaint about a clock that voltage scale 0 allows, and that scale was
    /// reached before the clock was.
    pub(crate) fn explains(&self, told: &Told) -> bool {
        let reached = self.overdrive_since().is_some_and(|since| since <= told.at);
        let scale = pwr::d3cr::VOS.get(self.register(pwr::Register::D3cr, "PWR"));
        let clocks_hz = clocks_hz(self);
        let within = clocks_hz.iter().zip(LIMITS_HZ);
        told.instance == "RCC"
            && told.reason.contains(COMPLAINT)
            && reached
            && scale == SCALE_1
            && within.into_iter().all(|(clock, limit)| *clock <= limit)
    }
}

/// Core, AHB and fastest APB clock with PLL1 from the HSE as system clock, Hz.
fn clocks_hz(part: &Part) -> [u64; 3] {
    use rcc::Register;
    let read = |register| part.register(register, "RCC");
    let input_hz =
        part.schematic().clock_hz / rcc::pllckselr::DIVM1.get(read(Register::Pllckselr)).max(1);
    let dividers = read(Register::Pll1divr);
    let vco_hz = input_hz * (rcc::pll1divr::DIVN1.get(dividers) + 1);
    let system_hz = vco_hz / (rcc::pll1divr::DIVP1.get(dividers) + 1);
    let domain1 = read(Register::D1cfgr);
    let core_hz = system_hz >> halvings(rcc::d1cfgr::D1CPRE.get(domain1), 4);
    let bus_hz = core_hz >> halvings(rcc::d1cfgr::HPRE.get(domain1), 4);
    let least = [
        rcc::d1cfgr::D1PPRE.get(domain1),
        rcc::d2cfgr::D2PPRE1.get(read(Register::D2cfgr)),
        rcc::d2cfgr::D2PPRE2.get(read(Register::D2cfgr)),
        rcc::d3cfgr::D3PPRE.get(read(Register::D3cfgr)),
    ]
    .map(|code| halvings(code, 3))
    .into_iter()
    .min();
    [core_hz, bus_hz, bus_hz >> least.unwrap_or(0)]
}

/// By how many powers of two a prescaler's code of `bits` bits divides: without the top bit by none,
/// with it by 2, 4, 8, 16, and for four bits then by 64, 128, 256, 512 (RM0433 Rev 9, section 8.7.6).
fn halvings(code: u64, bits: u32) -> u64 {
    let top = 1 << (bits - 1);
    match code.checked_sub(top) {
        None => 0,
        Some(step) if step < 4 => step + 1,
        Some(step) => step + 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prescalers_divide_as_the_manual_says() {
        let four: Vec<u64> = (7..16).map(|code| 1 << halvings(code, 4)).collect();
        assert_eq!(four, [1, 2, 4, 8, 16, 64, 128, 256, 512]);
        let three: Vec<u64> = (3..8).map(|code| 1 << halvings(code, 3)).collect();
        assert_eq!(three, [1, 2, 4, 8, 16]);
    }
}
