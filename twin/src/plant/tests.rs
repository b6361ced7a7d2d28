//! The plant against closed formulas.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::*;
use crate::oracle;

const TICK_NS: u64 = 20_000;
const SAMPLE_RATE_HZ: f64 = 50_000.0;

/// A rig whose high-passes forget within tests: 2 Hz has a time constant of 80 ms.
fn quick_rig() -> Rig {
    let mut rig = Rig::standard();
    rig.reference.high_pass_hz = 2.0;
    rig.dut.high_pass_hz = 3.0;
    rig
}

/// Steady amplitudes of acceleration and both converter voltages per volt of drive, by a DFT over
/// whole cycles of a tone of `cycles` per `period` samples.
fn steady_response(rig: &Rig, cycles: usize, period: usize) -> [Complex<f64>; 3] {
    // After 4 s the slowest time constant, 80 ms, has left e^-50.
    let settle = (200_000_usize).div_ceil(period) * period;
    let block = (50_000_usize).div_ceil(period) * period;
    let mut plant = Plant::new(rig);
    let mut sums = [Complex::new(0.0, 0.0); 3];
    for index in 0..settle + block {
        let angle = TAU * ((index * cycles) % period) as f64 / period as f64;
        if index >= settle {
            let [reference_v, dut_v] = plant.converter_v();
            let turn = Complex::from_polar(2.0 / block as f64, -angle);
            let values = [plant.acceleration_ms2(), reference_v, dut_v];
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += turn * value;
            }
        }
        plant.hold_volt(angle.cos(), TICK_NS);
    }
    sums
}

/// Sampled continuous response: the tone and all its images, folded.
///
/// The image at `f + k fs` has the amplitude the hold gives it, and `oracle::drive_transfer` holds
/// for images as well since it is a formula of the continuous frequency.
fn folded(frequency_hz: f64, response: impl Fn(f64) -> Complex<f64>) -> Complex<f64> {
    let image = |order: i32| {
        let image_hz = frequency_hz + f64::from(order) * SAMPLE_RATE_HZ;
        if image_hz < 0.0 {
            // A real system: H(-f) is the conjugate of H(f).
            response(-image_hz).conj()
        } else {
            response(image_hz)
        }
    };
    (-40..=40).map(image).sum()
}

/// (cycles, period) of 20 Hz, 160 Hz, 1 kHz, 3.125 kHz, 10 kHz and the mechanical resonance, 53.8 Hz.
const TONES: [(usize, usize); 6] = [(1, 2500), (2, 625), (1, 50), (1, 16), (1, 5), (1, 929)];

#[test]
fn the_plant_in_time_agrees_with_the_formulas() {
    let rig = quick_rig();
    let volt_per_code = rig.amplifier.full_scale_peak_v / 2048.0;
    for (cycles, period) in TONES {
        let frequency_hz = cycles as f64 * SAMPLE_RATE_HZ / period as f64;
        let drive = |f: f64| oracle::drive_transfer(&rig, f) / volt_per_code;
        let chain = |f: f64| drive(f) * oracle::anti_alias(&rig, f);
        let expected = [
            folded(frequency_hz, drive),
            folded(frequency_hz, |f| {
                chain(f) * oracle::reference_sensitivity(&rig, f)
            }),
            folded(frequency_hz, |f| {
                chain(f) * oracle::dut_sensitivity(&rig, f)
            }),
        ];
        let measured = steady_response(&rig, cycles, period);
        for (got, want) in measured.iter().zip(&expected) {
            let error = (got - want).norm() / want.norm();
            // Both sides are exact; images beyond the 40th fall below 1e-14, rounding over 250 000
            // steps and a 1e5 ratio of time constants stays below 1e-9.
            assert!(error < 1e-9, "{frequency_hz} Hz: {error:e}");
        }
    }
}

#[test]
fn images_of_the_tone_do_not_reach_the_ratio() {
    // The worst device: its resonance on the first image of 10 kHz, at 40 kHz, with Q 30.
    let mut rig = quick_rig();
    rig.dut.resonance_hz = 40e3;
    rig.dut.quality_factor = 30.0;
    for (cycles, period) in TONES {
        let frequency_hz = cycles as f64 * SAMPLE_RATE_HZ / period as f64;
        let [_, reference_v, dut_v] = steady_response(&rig, cycles, period);
        let truth = oracle::dut_sensitivity(&rig, frequency_hz)
            / oracle::reference_sensitivity(&rig, frequency_hz);
        let error = (dut_v / reference_v / truth - 1.0).norm();
        // A tenth of the 0.1 % and 0.1 degree a calibration may be off on a quiet plant.
        assert!(error < 1e-4, "{frequency_hz} Hz: {error:e}");
    }
}

#[test]
fn the_pass_band_is_flat_to_ten_kilohertz() {
    let rig = Rig::standard();
    for frequency_hz in [5.0, 1e3, 5e3, 8e3, 10e3] {
        let drop = 1.0 - oracle::anti_alias(&rig, frequency_hz).norm();
        // 1 - 1/sqrt(1 + (10/22)^12) = 3.9e-5.
        assert!(drop.abs() < 4e-5, "{frequency_hz} Hz: {drop:e}");
    }
}

#[test]
fn noise_and_offset_are_those_of_the_rig() {
    let mut rig = Rig::standard();
    rig.reference.noise_rms_v = 0.003;
    // The expectation is of ideal converters.
    rig.converter.errors = 0.0;
    let mut plant = Plant::new(&rig);
    let count = 100_000;
    let mut sums = [[0.0; 2]; 2];
    for _ in 0..count {
        for (sum, code) in sums.iter_mut().zip(plant.sample()) {
            let volt = (f64::from(code) - 32_768.0) * 10.0 / 65_536.0;
            sum[0] += volt / f64::from(count);
            sum[1] += volt * volt / f64::from(count);
        }
        plant.hold(2048, TICK_NS);
    }
    let step_v: f64 = 10.0 / 65_536.0;
    // Rounding adds step^2/12 of variance where the noise spans several codes (20 here).
    let rms_v = (sums[0][1] - sums[0][0].powi(2)).sqrt();
    let expected_v = (0.003_f64.powi(2) + step_v * step_v / 12.0).sqrt();
    // Relative standard error of a deviation: 1/sqrt(2 n) = 0.22 %; five of them.
    assert!((rms_v / expected_v - 1.0).abs() < 0.011, "{rms_v}");
    assert!((sums[0][0] - rig.reference.offset_v).abs() < 5.0 * expected_v / 316.0);
    // The other channel's 40 uV are a quarter of a code: the mean stays within a code.
    assert!((sums[1][0] - rig.dut.offset_v).abs() < step_v);
}

#[test]
fn the_same_calls_give_the_same_codes() {
    let run = |seed| {
        let mut rig = Rig::standard();
        rig.noise_seed = seed;
        let mut plant = Plant::new(&rig);
        (0..2000_u16)
            .map(|index| {
                plant.hold(2048 + index % 7, TICK_NS);
                plant.sample()
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(run(3), run(3));
    assert_ne!(run(3), run(4));
}

#[test]
fn overload_saturates_the_code() {
    let mut rig = Rig::standard();
    rig.dut.conditioner_gain = 1000.0;
    let mut plant = Plant::new(&rig);
    let codes: Vec<_> = (0..5000)
        .map(|index| {
            plant.hold(if index / 100 % 2 == 0 { 4095 } else { 0 }, TICK_NS);
            plant.sample()[1]
        })
        .collect();
    assert!(codes.contains(&0) && codes.contains(&65_535));
}

/// A mass on its seat on a table that is no rigid part of the coil, and the coil's field in the reference:
/// the network in time against the impedances, bare and loaded, shunt and divider.
#[test]
fn the_plant_with_a_mass_agrees_with_its_impedances() {
    use crate::model::CoilInput;
    use crate::reciprocity::{Hold, SelfCheckDraw, response};
    let mut draw = SelfCheckDraw::new(3, Hold::None);
    assert_eq!(draw.rig.effects.len(), 3);
    // What bends is the steady state's alone: the plant has it by its own effects.
    draw.rig.effects.truncate(1);
    draw.rig.reference.high_pass_hz = 2.0;
    draw.rig.converter.dut_corner_excess_rel = 0.0;
    for (mounting, input) in [
        (None, CoilInput::Shunt),
        (Some(1), CoilInput::Shunt),
        (Some(1), CoilInput::Divider),
    ] {
        let rig = draw.loaded(mounting, input, 3.0);
        for (cycles, period) in [(1, 929), (2, 625), (1, 50)] {
            let frequency_hz = cycles as f64 * SAMPLE_RATE_HZ / period as f64;
            let [_, reference_v, device_v] = steady_response(&rig, cycles, period);
            let expected = response::motion(&rig, frequency_hz, 1.0).expect("senses the coil");
            let [reference, device] = expected.inputs_v;
            let error = device_v / reference_v / (device / reference) - 1.0;
            // The ladder of eddy currents is good to 1e-4, and images of the tone to 1e-5.
            assert!(
                error.norm() < 2e-4,
                "{mounting:?} {input:?} {frequency_hz}: {error}"
            );
        }
    }
}
