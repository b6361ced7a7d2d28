//! The truth: what the linear rig does at one frequency, by closed formulas in f64.
//!
//! Nothing here uses the plant, which works in the time domain: the two are checked against each
//! other. Results are complex; the phase is `arg()` in radians, of `A cos(2 pi f t + phase)`.

mod calibration;

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

pub use self::calibration::{
    CalibrationPoint, ONE_THIRD_OCTAVES_HZ, calibration_at, reference_calibration,
};
use crate::rig::{Rig, Sensing};

/// Complex sensitivity of transducer and conditioner at the input connector, V/(m/s2).
///
/// # Equation
/// `S0 G / (1 - q^2 + j q/Q) * p/(1 + p) / (1 - r^2 + j sqrt(2) r)` with `q = f/f0`, `p = j f/fh`,
/// `r = f/fl`.
///
/// # Accuracy
/// Rounding only; the time-domain plant agrees with it: test
/// `the_plant_in_time_agrees_with_the_formulas`.
///
/// # Source
/// ISO 16063-43:2015 formula (2) for the transducer; own derivation for the conditioner.
pub fn sensitivity(sensing: &Sensing, frequency_hz: f64) -> Complex<f64> {
    let q = frequency_hz / sensing.resonance_hz;
    let p = Complex::new(0.0, frequency_hz / sensing.high_pass_hz);
    let r = frequency_hz / sensing.low_pass_hz;
    let transducer = 1.0 / Complex::new(1.0 - q * q, q / sensing.quality_factor);
    let low_pass = 1.0 / Complex::new(1.0 - r * r, 2.0_f64.sqrt() * r);
    let gain = sensing.sensitivity_v_per_ms2 * sensing.conditioner_gain;
    gain * transducer * low_pass * p / (1.0 + p)
}

/// True sensitivity of the device under test with its conditioner, V/(m/s2).
pub fn dut_sensitivity(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    sensitivity(&rig.dut, frequency_hz)
}

/// True sensitivity of the reference with its conditioner, V/(m/s2).
pub fn reference_sensitivity(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    sensitivity(&rig.reference, frequency_hz)
}

/// Acceleration of the table per volt at the coil, (m/s2)/V.
///
/// # Equation
/// `Bl s^2 / ((M s^2 + c s + k)(R + s L) + Bl^2 s)`, `s = j 2 pi f`.
pub fn exciter_transfer(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    let exciter = &rig.exciter;
    let s = Complex::new(0.0, TAU * frequency_hz);
    let mechanics =
        s * s * exciter.mass_kg() + s * exciter.damping_ns_per_m + exciter.stiffness_n_per_m;
    let coil = s * exciter.coil_inductance_h + exciter.coil_resistance_ohm;
    let force_factor = exciter.force_factor_n_per_a;
    s * s * force_factor / (mechanics * coil + s * force_factor * force_factor)
}

/// Voltage at the coil over the commanded one: the hold of the converter and the reconstruction filter.
///
/// # Equation
/// `sinc(f/fs) e^{-j pi f/fs} * B_n(f/fr)`, the first two being the zero-order hold.
pub fn output_transfer(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    let converter = &rig.converter;
    let angle = PI * frequency_hz / converter.sample_rate_hz;
    let hold = Complex::from_polar(angle.sin() / angle, -angle);
    let filter = butterworth(
        converter.reconstruction_order,
        frequency_hz / converter.reconstruction_hz,
    );
    hold * filter
}

/// Acceleration of the table per drive code, (m/s2)/code, including [`output_transfer`].
///
/// # Equation
/// `V / 2048 * output_transfer * exciter_transfer`.
pub fn drive_transfer(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    rig.amplifier.full_scale_peak_v / 2048.0
        * output_transfer(rig, frequency_hz)
        * exciter_transfer(rig, frequency_hz)
}

/// Response of an anti-alias filter, from input connector to converter.
pub fn anti_alias(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    let converter = &rig.converter;
    butterworth(
        converter.anti_alias_order,
        frequency_hz / converter.anti_alias_hz,
    )
}

/// The device's input over the reference's, from connector to converter.
pub fn channel_ratio(rig: &Rig, frequency_hz: f64) -> Complex<f64> {
    let converter = &rig.converter;
    let corner_hz = converter.anti_alias_hz * (1.0 + converter.dut_corner_excess_rel);
    let filter = butterworth(converter.anti_alias_order, frequency_hz / corner_hz);
    let late_rad = std::f64::consts::TAU * frequency_hz * converter.dut_delay_s;
    Complex::from_polar(1.0, -late_rad) * filter / anti_alias(rig, frequency_hz)
}

/// Butterworth low-pass of `order` at `ratio` of its corner, from its poles.
fn butterworth(order: u32, ratio: f64) -> Complex<f64> {
    (0..order)
        .map(|index| {
            let angle = PI / 2.0 + PI * f64::from(2 * index + 1) / f64::from(2 * order);
            let pole = Complex::from_polar(1.0, angle);
            -pole / (Complex::new(0.0, ratio) - pole)
        })
        .product()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sensitivity_at_its_landmarks() {
        let rig = Rig::standard();
        let dut = &rig.dut;
        // Far from every corner: the product of sensitivity and gain, within (f/f0)^2 and (fh/f)^2.
        let middle = dut_sensitivity(&rig, 100.0);
        assert!((middle.norm() / dut.sensitivity_v_per_ms2 - 1.0).abs() < 1e-5);
        // At the high-pass corner: 1/sqrt(2) and 45 degrees ahead.
        let low = dut_sensitivity(&rig, dut.high_pass_hz);
        assert!((low.norm() / dut.sensitivity_v_per_ms2 - 0.5_f64.sqrt()).abs() < 1e-6);
        assert!((low.arg() - PI / 4.0).abs() < 1e-4);
        // At resonance: Q times the low-pass, 90 degrees behind it.
        let r = dut.resonance_hz / dut.low_pass_hz;
        let low_pass = 1.0 / Complex::new(1.0 - r * r, 2.0_f64.sqrt() * r);
        let peak = dut_sensitivity(&rig, dut.resonance_hz) / low_pass;
        assert!((peak.norm() / dut.sensitivity_v_per_ms2 / dut.quality_factor - 1.0).abs() < 1e-6);
        assert!((peak.arg() + PI / 2.0).abs() < 1e-4);
    }

    /// An instrument whose reference table was never set holds 0.0102 V/(m/s2) and 0 degrees with
    /// U = 0.5 % and 0.3 degrees, above 1 kHz 1 % and 0.7 degrees per decade more.
    #[test]
    fn the_reference_is_what_an_instrument_out_of_the_box_believes() {
        let rig = Rig::standard();
        for frequency_hz in ONE_THIRD_OCTAVES_HZ {
            let decades = (frequency_hz / 1000.0).log10().max(0.0);
            let truth = reference_sensitivity(&rig, frequency_hz);
            let magnitude_rel = (truth.norm() / 0.0102 - 1.0).abs();
            assert!(magnitude_rel < 0.005 + 0.010 * decades, "{frequency_hz} Hz");
            let phase_deg = truth.arg().to_degrees().abs();
            assert!(phase_deg < 0.3 + 0.7 * decades, "{frequency_hz} Hz");
        }
    }

    #[test]
    fn exciter_at_its_landmarks() {
        let rig = Rig::standard();
        let exciter = &rig.exciter;
        // Quasi-static: force over stiffness, twice differentiated.
        let omega = TAU * 0.1;
        let static_travel =
            exciter.force_factor_n_per_a / exciter.coil_resistance_ohm / exciter.stiffness_n_per_m;
        let low = exciter_transfer(&rig, 0.1).norm();
        assert!((low / (static_travel * omega * omega) - 1.0).abs() < 1e-4);
        // Far above everything: Bl / (M L w).
        let omega = TAU * 1e6;
        let high = exciter_transfer(&rig, 1e6).norm();
        let expected =
            exciter.force_factor_n_per_a / (exciter.mass_kg() * exciter.coil_inductance_h * omega);
        assert!((high / expected - 1.0).abs() < 1e-4);
    }
}
