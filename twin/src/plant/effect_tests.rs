//! The plant with effects, in time, against the steady state, which is solved by other means.

use std::f64::consts::{SQRT_2, TAU};

use nalgebra::Complex;

use super::*;
use crate::effects::ActiveEffect;
use crate::oracle;
use crate::rig::Surroundings;
use crate::steady::{Solver, SteadyState};

const TICK_NS: u64 = 20_000;
const SAMPLE_RATE_HZ: f64 = 50_000.0;

/// Without noise, and with high-passes that forget within tests.
fn quiet_rig() -> Rig {
    let mut rig = Rig::standard();
    for sensing in [&mut rig.reference, &mut rig.dut] {
        sensing.high_pass_hz = 2.0;
        sensing.noise_rms_v = 0.0;
        sensing.offset_v = 0.0;
    }
    rig.surroundings = Surroundings {
        time_s: 1000.0,
        warmer_k: 5.0,
        rotation_deg: 40.0,
        tilt_deg: 23.0,
        mains_hz: 50.0,
    };
    rig
}

/// A tone of whole cycles in whole samples.
#[derive(Clone, Copy)]
struct Tone {
    cycles: usize,
    period: usize,
}

impl Tone {
    fn frequency_hz(self) -> f64 {
        self.cycles as f64 * SAMPLE_RATE_HZ / self.period as f64
    }
}

/// Amplitudes that the plant settles to.
struct Settled {
    coil_v: Complex<f64>,
    current: Complex<f64>,
    /// Harmonics 1 to 3 of reference and device at the connector, V peak.
    channels: [[Complex<f64>; 3]; 2],
}

fn settle(effects: &[ActiveEffect], tone: Tone, drive_v: f64) -> Settled {
    let rig = Rig {
        effects: effects.to_vec(),
        ..quiet_rig()
    };
    let mut plant = Plant::new(&rig);
    // 1.5 s: the slowest time constants are 80 ms (high-passes) and 0.5 s (levels: e^-3 of a small
    // effect, which at a constant level are right after two time constants of averaging).
    let settle = (75_000_usize).div_ceil(tone.period) * tone.period;
    let block = (10_000_usize).div_ceil(tone.period) * tone.period;
    let mut sums = [[Complex::new(0.0, 0.0); 3]; 3];
    for index in 0..settle + block {
        let angle = TAU * ((index * tone.cycles) % tone.period) as f64 / tone.period as f64;
        if index >= settle {
            let [reference_v, dut_v] = plant.converter_v();
            let values = [
                [plant.coil_v(), plant.current_a(), 0.0],
                [reference_v; 3],
                [dut_v; 3],
            ];
            for (row, list) in values.iter().enumerate() {
                for (order, value) in (1..).zip(list) {
                    let turns = if row == 0 { 1.0 } else { f64::from(order) };
                    sums[row][order as usize - 1] +=
                        Complex::from_polar(2.0 * value / block as f64, -angle * turns);
                }
            }
        }
        plant.hold_volt(drive_v * angle.cos(), TICK_NS);
    }
    let channel = |row: usize| {
        std::array::from_fn(|index| {
            let order_hz = tone.frequency_hz() * (index + 1) as f64;
            sums[row][index] / oracle::anti_alias(&rig, order_hz)
        })
    };
    Settled {
        coil_v: sums[0][0],
        current: sums[0][1],
        channels: [channel(1), channel(2)],
    }
}

fn solve(effects: &[ActiveEffect], tone: Tone, reference_v: f64) -> SteadyState {
    let rig = Rig {
        effects: effects.to_vec(),
        ..quiet_rig()
    };
    Solver::default()
        .hold(
            &rig.model(),
            &rig.conditions(),
            tone.frequency_hz(),
            reference_v / SQRT_2,
        )
        .expect("steady")
}

/// Ratio, drive and current, and second and third harmonic of both channels.
fn observed(
    coil_v: Complex<f64>,
    current: Complex<f64>,
    channels: [&[Complex<f64>]; 2],
) -> [Complex<f64>; 7] {
    let [reference, dut] = channels;
    let relative = |channel: &[Complex<f64>], order: usize| {
        let turn = channel[0] / channel[0].norm();
        channel[order - 1] / channel[0].norm() / turn.powu(order as u32)
    };
    [
        dut[0] / reference[0],
        reference[0] / coil_v,
        current / coil_v,
        relative(reference, 2),
        relative(reference, 3),
        relative(dut, 2),
        relative(dut, 3),
    ]
}

fn live(effects: &[ActiveEffect], tone: Tone, drive_v: f64) -> ([Complex<f64>; 7], f64) {
    let settled = settle(effects, tone, drive_v);
    let channels = [&settled.channels[0][..], &settled.channels[1][..]];
    let seen = observed(settled.coil_v, settled.current, channels);
    (seen, settled.channels[0][0].norm())
}

fn steady(effects: &[ActiveEffect], tone: Tone, reference_v: f64) -> [Complex<f64>; 7] {
    let state = solve(effects, tone, reference_v);
    let channels = [&state.reference.harmonics_v[..], &state.dut.harmonics_v[..]];
    observed(state.coil_v, state.coil_a, channels)
}

/// Changes by an effect: relative for ratio, drive and current, absolute for harmonics.
fn change(with: [Complex<f64>; 7], without: [Complex<f64>; 7]) -> [Complex<f64>; 7] {
    std::array::from_fn(|index| {
        if index < 3 {
            with[index] / without[index] - 1.0
        } else {
            with[index] - without[index]
        }
    })
}

/// The effects of a text, all at once, in time and in steady state.
fn compare(text: &str, tone: Tone, drive_v: f64, share: f64) {
    let effects = text.split(' ').map(|effect| effect.parse().expect("known"));
    let effects: Vec<ActiveEffect> = effects.collect();
    let (with, reference_v) = live(&effects, tone, drive_v);
    let (without, plain_v) = live(&[], tone, drive_v);
    let got = change(with, without);
    let want = change(
        steady(&effects, tone, reference_v),
        steady(&[], tone, plain_v),
    );
    let size = want
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.norm()));
    for (index, (got, want)) in got.iter().zip(&want).enumerate() {
        let error = (got - want).norm();
        // Images of the tone, which the effect may change, leave 1e-6.
        let bound = share * size + 2e-6;
        assert!(
            error < bound,
            "{text} {} Hz, {index}: {got} {want}",
            tone.frequency_hz()
        );
    }
}

const LOW: Tone = Tone {
    cycles: 1,
    period: 1250,
};
const MIDDLE: Tone = Tone {
    cycles: 2,
    period: 625,
};
const HIGH: Tone = Tone {
    cycles: 2,
    period: 25,
};

/// Held in time and solved in steady state, every linear effect does the same. Approximated delays
/// and differentiators are off by up to 1 % of themselves. (Slope and strain have no causal
/// counterpart of the same phase; their networks are tested beside them.)
#[test]
fn linear_effects_act_alike_in_time_and_in_steady_state() {
    for text in [
        "dut_resonance",
        "reference_resonance",
        "mount_compliance",
        "relative_motion",
        "transverse_motion",
        "gravity_tilt",
        "dut_temperature",
        "reference_temperature",
        "dut_gain",
        "reference_gain",
        "dut_highpass",
        "reference_highpass",
        "dut_lowpass_1",
        "dut_lowpass_2",
        "averaging_window",
        "crosstalk",
        "channel_skew",
        "mechanical_damping",
        "back_emf",
        "payload_mass",
        "lossy_inductance",
        "shorted_inductance",
        "armature_mode",
        "body_mode",
        "body_mode gravity_tilt",
        "suspension_creep",
    ] {
        for tone in [LOW, MIDDLE, HIGH] {
            compare(text, tone, 1.0, 0.02);
        }
    }
}

/// An advance of the device is a delay of the reference: the ratio is the same, the drive is late.
#[test]
fn a_negative_skew_delays_the_other_channel() {
    let effects = ["channel_skew=tau_s:-1e-6"
        .parse::<ActiveEffect>()
        .expect("known")];
    let (with, _) = live(&effects, HIGH, 1.0);
    let (without, _) = live(&[], HIGH, 1.0);
    let turn = Complex::from_polar(1.0, TAU * 4000.0 * 1e-6);
    // Images of the tone, which are delayed by another angle, leave 1e-6.
    assert!((with[0] / without[0] - turn).norm() < 2e-6);
    assert!((with[1] / without[1] * turn - 1.0).norm() < 2e-6);
}

#[test]
fn nonlinear_effects_act_alike_in_time_and_in_steady_state() {
    // Steps of 5 us are exact for a term that changes linearly: at 160 Hz and its third harmonic
    // (pi f T)^2/3 is 2e-5. Dry friction turns within a step: 1 %. Levels follow within e^-3.
    for (text, tone, drive_v, share) in [
        ("suspension_cubic=k3_n_per_m3:3e8", LOW, 4.0, 2e-3),
        ("suspension_asymmetry", LOW, 2.0, 5e-3),
        ("force_factor_droop", LOW, 4.0, 2e-3),
        ("coulomb_friction=friction_n:0.05", LOW, 2.0, 2e-2),
        ("amplifier_clipping=threshold_v:1.8", MIDDLE, 2.0, 5e-3),
        ("amplifier_even_order=even_per_v:0.01", MIDDLE, 2.0, 2e-2),
        ("amplifier_soft_clipping=threshold_v:5", MIDDLE, 2.0, 5e-3),
        (
            "suspension_cubic=k3_n_per_m3:3e8,sag_share:1",
            LOW,
            4.0,
            5e-3,
        ),
        (
            "suspension_cubic=k3_n_per_m3:3e8 body_mode=body_mass_kg:0.5",
            LOW,
            4.0,
            2e-3,
        ),
        (
            "suspension_cubic=k3_n_per_m3:3e8 suspension_creep",
            LOW,
            4.0,
            2e-3,
        ),
        (
            "coulomb_friction=friction_n:0.05 body_mode=body_mass_kg:0.5",
            LOW,
            2.0,
            2e-2,
        ),
        (
            "loose_mount=threshold_ms2:30,impact_noise:0",
            MIDDLE,
            2.0,
            5e-3,
        ),
        (
            "dut_level_nonlinearity=gamma_per_ms2:0,second_harmonic_per_ms2:1e-3",
            MIDDLE,
            2.0,
            6e-2,
        ),
        ("coil_heating", MIDDLE, 1.0, 1e-2),
        ("amplifier_gain_drift=drift_per_s:1e-4", MIDDLE, 1.0, 1e-2),
    ] {
        compare(text, tone, drive_v, share);
    }
}

/// Amplitude of the tone in the codes of the device over that of the reference, and the noise.
fn sampled(text: &str, tone: Tone) -> (Complex<f64>, [f64; 2]) {
    let effects: Vec<ActiveEffect> = text
        .split(' ')
        .filter_map(|part| part.parse().ok())
        .collect();
    let mut rig = quiet_rig();
    // Fine codes: 1/32 of the standard step; converters do nothing beside their effect.
    rig.converter.errors = 0.0;
    rig.converter.input_full_scale_peak_v = 5.0 / 32.0;
    rig.effects = effects;
    let mut plant = Plant::new(&rig);
    let settle = (75_000_usize).div_ceil(tone.period) * tone.period;
    let block = (50_000_usize).div_ceil(tone.period) * tone.period;
    let mut sums = [Complex::new(0.0, 0.0); 2];
    let mut squares = [0.0; 2];
    for index in 0..settle + block {
        let angle = TAU * ((index * tone.cycles) % tone.period) as f64 / tone.period as f64;
        let codes = plant.sample();
        if index >= settle {
            for (channel, code) in codes.into_iter().enumerate() {
                let volt = (f64::from(code) - 32_768.0) / 32_768.0 * 5.0 / 32.0;
                sums[channel] += Complex::from_polar(2.0 * volt / block as f64, -angle);
                squares[channel] += volt * volt / block as f64;
            }
        }
        plant.hold_volt(0.2 * angle.cos(), TICK_NS);
    }
    let noise = [0, 1].map(|channel: usize| {
        (squares[channel] - sums[channel].norm_sqr() / 2.0)
            .max(0.0)
            .sqrt()
    });
    (sums[1] / sums[0], noise)
}

#[test]
fn sampling_effects_show_in_the_codes() {
    let (plain, quiet) = sampled("", HIGH);
    let step_v = 5.0 / 32.0 / 32_768.0;
    assert!(quiet.iter().all(|noise| *noise < step_v), "{quiet:?}");
    // Time and temperature of the conditions: 1000 s to 1002.5 s, 5 K.
    for (text, expected, bound) in [
        ("dut_drift", Complex::new(1.002, 0.0), 2e-5),
        ("reference_drift", Complex::new(1.0 / 0.998, 0.0), 2e-5),
        // After one time constant.
        (
            "dut_warm_up=cold_rel:0.01,time_constant_s:1000",
            Complex::new(1.0 + 0.01 / std::f64::consts::E, 0.0),
            2e-5,
        ),
        (
            "range_step=step_rel:0.01,threshold_v:1e-3,channel:1",
            Complex::new(1.01, 0.0),
            2e-5,
        ),
        (
            "range_step=step_rel:0.01,threshold_v:1,channel:1",
            Complex::new(1.0, 0.0),
            2e-5,
        ),
        (
            "clock_offset=delta:1e-10",
            Complex::from_polar(1.0, -TAU * 4000.0 * 1e-7),
            2e-5,
        ),
    ] {
        let (ratio, _) = sampled(text, HIGH);
        assert!(
            (ratio / plain - expected).norm() < bound,
            "{text} {}",
            ratio / plain
        );
    }
    let (_, picked) = sampled("mains_pickup=pickup_v:0.001,second_v:0,third_v:0", HIGH);
    assert!(
        (picked[1] / 1e-3 - 1.0).abs() < 0.01 && picked[0] < step_v,
        "{picked:?}"
    );
    // 5 mm/s2 up to 25 kHz, of which the anti-alias filter (22 kHz) leaves nearly all and the
    // resonance of the device makes more.
    let (_, shaken) = sampled("ambient_vibration=broadband_ms2:0.05", HIGH);
    assert!(
        shaken[0] > 0.7 * 0.05 * 0.0102 && shaken[0] < 1.05 * 0.05 * 0.0102,
        "{shaken:?}"
    );
    assert!(shaken[1] > shaken[0]);
    let (_, jitter) = sampled("sampling_jitter=sigma_s:1e-7", HIGH);
    let (_, amplitude) = live(&[], HIGH, 0.2);
    let expected = TAU * 4000.0 * 1e-7 * amplitude / SQRT_2;
    assert!(
        (jitter[0] / expected - 1.0).abs() < 0.05,
        "{} {expected}",
        jitter[0]
    );
}
