//! Sections as causal networks.

use super::network::{Network, Signal};
use crate::model::{SecondOrder, Section};

/// Where differentiators stop, Hz: at 20 kHz what they add is 1 % short and 1 degree late.
const DIFFERENTIATOR_HZ: f64 = 2e6;

/// Grid of the relaxation spectrum of a slope: two to a decade from 0.1 Hz to 1 MHz, so that the
/// ripple in between is below 1e-3 of the slope from 1 Hz to 100 kHz.
const RELAXATIONS: i32 = 15;
const LOWEST_RELAXATION_HZ: f64 = 0.1;
const RELAXATIONS_PER_DECADE: f64 = 2.0;

/// Adds a section to `network`; `travel` is the table's, m.
///
/// An advance (a negative delay) is left out here: the wiring delays the other channel instead.
///
/// # Accuracy
/// Exact for filters and resonances; delay and mean to `(w T)^5 / 720` by a Pade approximation of
/// second order; the others as [`Section`] says. Test
/// `networks_have_the_response_of_their_sections`.
pub(super) fn realise(
    network: &mut Network,
    section: &Section,
    input: &Signal,
    travel: &Signal,
) -> Signal {
    match *section {
        Section::SecondOrder(section) => network.second_order(input, section),
        Section::HighPass(corner_hz) => network.high_pass(input, corner_hz),
        Section::LowPass(corner_hz) => network.low_pass(input, corner_hz),
        Section::Delay(delay_s) => pade(network, input, delay_s, true),
        Section::Average(window_s) => pade(network, input, window_s, false),
        Section::InverseSquare(per_hz2) => {
            let second_derivative = SecondOrder {
                corner_hz: DIFFERENTIATOR_HZ,
                quality_factor: 0.5,
                numerator: [0.0, 0.0, per_hz2 * DIFFERENTIATOR_HZ * DIFFERENTIATOR_HZ],
            };
            let added = network.second_order(input, second_derivative);
            input.clone().plus(1.0, &added)
        }
        // x = -a / (2 pi f)^2.
        Section::Tilt(hz2) => {
            let turn = std::f64::consts::TAU;
            input.clone().plus(-turn * turn * hz2, travel)
        }
        Section::Strain { gain, corner_hz } => {
            let once = network.low_pass(input, corner_hz);
            let twice = network.low_pass(&once, corner_hz);
            input.clone().plus(gain, &twice)
        }
        Section::Slope {
            per_decade,
            reference_hz,
        } => slope(network, input, per_decade, reference_hz),
        Section::Coupling {
            inverse_fx_s,
            in_phase,
            ..
        } => {
            let derivative = network.high_pass(input, DIFFERENTIATOR_HZ);
            let capacitive = inverse_fx_s * DIFFERENTIATOR_HZ;
            input.scaled(1.0 + in_phase).plus(capacitive, &derivative)
        }
    }
}

/// Delay `e^{-sT}` or mean `(1 - e^{-sT})/(sT)`: with `x = sT`, `(1 -+ x/2 + x^2/12)` over
/// `(1 + x/2 + x^2/12)`, and 1 over the same.
fn pade(network: &mut Network, input: &Signal, time_s: f64, delay: bool) -> Signal {
    if time_s <= 0.0 {
        return input.clone();
    }
    let twelve = 12.0_f64.sqrt();
    let quality_factor = 2.0 / twelve;
    let numerator = if delay {
        [1.0, -1.0 / quality_factor, 1.0]
    } else {
        [1.0, 0.0, 0.0]
    };
    let section = SecondOrder {
        corner_hz: twelve / time_s / std::f64::consts::TAU,
        quality_factor,
        numerator,
    };
    network.second_order(input, section)
}

/// `1 - s lg(f/fr)`: relaxations evenly spaced in lg f, each of which takes its share of the slope.
fn slope(network: &mut Network, input: &Signal, per_decade: f64, reference_hz: f64) -> Signal {
    let share = per_decade / RELAXATIONS_PER_DECADE;
    let corner = |index: i32| {
        LOWEST_RELAXATION_HZ * 10.0_f64.powf(f64::from(index) / RELAXATIONS_PER_DECADE)
    };
    let passed = |index: i32| 1.0 / (1.0 + (reference_hz / corner(index)).powi(2));
    let at_reference: f64 = (0..RELAXATIONS).map(passed).sum::<f64>() * share;
    (0..RELAXATIONS).fold(input.scaled(1.0 - at_reference), |sum, index| {
        let relaxed = network.low_pass(input, corner(index));
        sum.plus(share, &relaxed)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(section: Section, frequency_hz: f64) -> f64 {
        let mut network = Network::default();
        let input = network.input();
        // Travel of a sine of unit acceleration, as a second input.
        let travel = network.input();
        let output = realise(&mut network, &section, &input, &travel);
        let got = network.response(&output, 0, frequency_hz).expect("stable");
        let through_travel = network.response(&output, 1, frequency_hz).expect("stable");
        let omega = std::f64::consts::TAU * frequency_hz;
        let total = got - through_travel / (omega * omega);
        (total - section.response(frequency_hz)).norm()
    }

    #[test]
    fn networks_have_the_response_of_their_sections() {
        let resonance = SecondOrder::low_pass(30e3, 20.0);
        for frequency_hz in [5.0, 160.0, 1e3, 1e4] {
            let x = std::f64::consts::TAU * frequency_hz * 1e-5;
            for (section, bound) in [
                (Section::SecondOrder(resonance), 1e-10),
                (Section::HighPass(3.0), 1e-10),
                (Section::LowPass(2e4), 1e-10),
                // First term of the error of the approximation.
                (Section::Delay(1e-5), x.powi(5) / 700.0 + 1e-10),
                (Section::Average(1e-5), x.powi(4) / 700.0 + 1e-10),
                // 2 f / 2 MHz of what is added: 1 % of 1 %.
                (Section::InverseSquare(1e-10), 1.1e-4),
                (Section::Tilt(0.5), 1e-10),
                (
                    Section::Coupling {
                        inverse_fx_s: 1e-6,
                        in_phase: 0.01,
                        quadrature: 0.0,
                    },
                    6e-5,
                ),
            ] {
                let error = error(section, frequency_hz);
                assert!(error < bound, "{section:?} {frequency_hz}: {error:e}");
            }
        }
    }

    #[test]
    fn a_slope_has_its_magnitude_and_the_loss_angle_of_causality() {
        let section = Section::Slope {
            per_decade: 0.02,
            reference_hz: 160.0,
        };
        let mut network = Network::default();
        let input = network.input();
        let output = realise(&mut network, &section, &input, &Signal::default());
        for frequency_hz in [5.0, 160.0, 1e3, 1e4] {
            let got = network.response(&output, 0, frequency_hz).expect("stable");
            let want = section.response(frequency_hz);
            // Second order in the slope and its phase: 1e-4 of magnitude, plus the ripple.
            assert!((got.norm() - want.norm()).abs() < 2e-4, "{frequency_hz}");
            let angle = -std::f64::consts::FRAC_PI_2 * 0.02 / std::f64::consts::LN_10;
            assert!(
                (got.arg() - angle).abs() < 0.05 * angle.abs(),
                "{frequency_hz} {}",
                got.arg()
            );
        }
    }

    #[test]
    fn strain_has_the_magnitude_of_its_formula() {
        let section = Section::Strain {
            gain: 1.0,
            corner_hz: 30.0,
        };
        let mut network = Network::default();
        let input = network.input();
        let output = realise(&mut network, &section, &input, &Signal::default());
        for frequency_hz in [5.0, 30.0, 300.0] {
            let added = network.response(&output, 0, frequency_hz).expect("stable") - 1.0;
            let want = section.response(frequency_hz).re - 1.0;
            assert!((added.norm() - want).abs() < 1e-12, "{frequency_hz}");
        }
    }
}
