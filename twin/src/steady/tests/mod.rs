//! Steady states against the first-order shapes of each effect, derived by hand.

use std::f64::consts::{PI, SQRT_2, TAU};

mod channels;

use super::*;
use crate::effects::{ActiveEffect, Effect};
use crate::model::CoilModel;

fn coil() -> CoilModel {
    CoilModel {
        mass_kg: 0.07,
        stiffness_n_per_m: 8000.0,
        damping_ns_per_m: 3.0,
        force_factor_n_per_a: 7.0,
        resistance_ohm: 4.0,
        inductance_h: 1.2e-4,
        ..CoilModel::LINEAR
    }
}

/// A flat rig with effects written as on the command line, `payload_kg` 0.02.
fn hold(
    effects: &[&str],
    conditions: &Conditions,
    frequency_hz: f64,
    level_ms2: f64,
) -> SteadyState {
    let mut model = Model::new(coil(), Channel::flat(0.01), Channel::flat(0.01));
    for text in effects {
        text.parse::<ActiveEffect>()
            .expect("known")
            .apply(conditions, &mut model);
    }
    let solver = Solver::default();
    solver
        .hold(&model, conditions, frequency_hz, level_ms2 * 0.01)
        .expect("steady")
}

fn usual() -> Conditions {
    Conditions::usual(0.02)
}

/// Harmonic n of a channel over its fundamental, its phase relative to n times that of the latter.
fn relative(channel: &ChannelState, order: usize) -> Complex<f64> {
    let fundamental = channel.harmonics_v[0];
    let turn = fundamental / fundamental.norm();
    channel.harmonics_v[order - 1] / fundamental.norm() / turn.powu(order as u32)
}

#[test]
fn the_nominal_rig_is_the_formula_of_the_exciter() {
    for frequency_hz in [5.0, 50.0, 1e3, 1e4] {
        let state = hold(&[], &usual(), frequency_hz, 1.0);
        let s = Complex::new(0.0, TAU * frequency_hz);
        let mechanics = s * s * 0.07 + s * 3.0 + 8000.0;
        let denominator = mechanics * (s * 1.2e-4 + 4.0) + s * 49.0;
        let drive = state.reference.harmonics_v[0] / state.coil_v / 0.01;
        let current = state.coil_a / state.coil_v;
        assert!((drive * denominator / (s * s * 7.0) - 1.0).norm() < 1e-12);
        assert!((current * denominator / mechanics - 1.0).norm() < 1e-12);
        assert_eq!(state.reference, state.dut);
        assert!((state.reference.harmonics_v[0].norm() / SQRT_2 / 0.01 - 1.0).abs() < 1e-4);
    }
}

/// A Duffing oscillator to first order in the cubic term: the fundamental of `k3 x^3` is
/// `3/4 k3 X^2 x`, its third harmonic `1/4 k3 X^3`, which drives the motion at three times the
/// frequency against mechanics and induced voltage.
#[test]
fn a_cubic_suspension_is_a_duffing_oscillator() {
    let (frequency_hz, level_ms2) = (20.0, 5.0);
    let omega = TAU * frequency_hz;
    let travel_m = SQRT_2 * level_ms2 / omega.powi(2);
    // Stiffening of 0.01 %, k + 3/4 k3 X^2 = 8000.8 N/m. Second order is 1e-8 of the stiffness; but
    // the third harmonic lies near resonance, where 1.6 N/m more are 1e-3 of what is left.
    let k3 = 0.8 / (0.75 * travel_m * travel_m);
    let state = hold(
        &[&format!("suspension_cubic=k3_n_per_m3:{k3}")],
        &usual(),
        frequency_hz,
        level_ms2,
    );
    let stiffer = CoilModel {
        stiffness_n_per_m: 8000.8,
        ..coil()
    };
    let [_, travel] = stiffer.linear_response(omega, 0.0);
    let got = state.reference.harmonics_v[0] / state.coil_v / 0.01;
    let error = (got / (-travel * omega * omega) - 1.0).norm();
    assert!(error < 5e-8, "{error:e}");
    let s = Complex::new(0.0, 3.0 * omega);
    let admittance = 1.0 / (s * s * 0.07 + s * 3.0 + 8000.0 + s * 49.0 / (s * 1.2e-4 + 4.0));
    // x = X cos: relative to X the third harmonic of x is -k3 X^2/4 G(3w); of the acceleration 9 times.
    let expected = -0.25 * k3 * travel_m * travel_m * admittance * 9.0;
    // The phase reference is the acceleration, -x: an odd harmonic turns three times half a turn as
    // it does itself, so nothing changes.
    let third = relative(&state.reference, 3);
    assert!((third / expected - 1.0).norm() < 2e-3, "{third} {expected}");
    assert!((relative(&state.dut, 3) - third).norm() < 1e-12);
    assert!(relative(&state.reference, 2).norm() < 1e-9);
}

/// `k2 x^2` about a sag `x0`: stiffness `k + 2 k2 x0`, second harmonic `k2 X^2/2` against the
/// mechanics at twice the frequency.
#[test]
fn an_asymmetric_suspension_softens_with_the_sag() {
    let (frequency_hz, level_ms2, k2) = (20.0, 2.0, 1e4);
    let omega = TAU * frequency_hz;
    for (tilt_rad, weight) in [(0.0, 1.0), (PI / 2.0, 0.0)] {
        let conditions = Conditions {
            tilt_rad,
            ..usual()
        };
        let state = hold(
            &[&format!("suspension_asymmetry=k2_n_per_m2:{k2}")],
            &conditions,
            frequency_hz,
            level_ms2,
        );
        let sag_m = -0.07 * 9.806_65 * weight / 8000.0;
        let softer = CoilModel {
            stiffness_n_per_m: 8000.0 + 2.0 * k2 * sag_m,
            ..coil()
        };
        let [_, travel] = softer.linear_response(omega, 0.0);
        let got = state.reference.harmonics_v[0] / state.coil_v / 0.01;
        // Second order in k2 x / k = 1e-3.
        assert!(
            (got / (-travel * omega * omega) - 1.0).norm() < 3e-6,
            "{tilt_rad}"
        );
        let travel_m = SQRT_2 * level_ms2 / omega.powi(2);
        let s = Complex::new(0.0, 2.0 * omega);
        let admittance = 1.0 / (s * s * 0.07 + s * 3.0 + 8000.0 + s * 49.0 / (s * 1.2e-4 + 4.0));
        // a = -w^2 x turns the fundamental by half a turn, so the even harmonic changes its sign.
        let expected = 0.5 * k2 * travel_m * admittance * 4.0;
        assert!(
            (relative(&state.dut, 2) / expected - 1.0).norm() < 3e-3,
            "{tilt_rad}"
        );
    }
}

/// Coulomb friction as a describing function: `4 Fc / pi` in phase with the velocity, and odd
/// harmonics `4 Fc / (pi n)` of a square wave.
#[test]
fn friction_has_its_describing_function() {
    let (frequency_hz, level_ms2, friction_n) = (100.0, 10.0, 0.001);
    let omega = TAU * frequency_hz;
    let state = hold(
        &[&format!("coulomb_friction=friction_n:{friction_n}")],
        &usual(),
        frequency_hz,
        level_ms2,
    );
    let velocity = SQRT_2 * level_ms2 / omega;
    let damped = CoilModel {
        damping_ns_per_m: 3.0 + 4.0 * friction_n / (PI * velocity),
        ..coil()
    };
    let [_, travel] = damped.linear_response(omega, 0.0);
    let got = state.reference.harmonics_v[0] / state.coil_v / 0.01;
    let plain = coil().linear_response(omega, 0.0)[1];
    let effect = (travel / plain - 1.0).norm();
    // The corrections to the describing function are of the order of the third harmonic: 1e-3 of it.
    assert!(
        (got / (-travel * omega * omega) - 1.0).norm() < 3e-3 * effect,
        "{effect:e}"
    );
    let s = Complex::new(0.0, 3.0 * omega);
    let admittance = 1.0 / (s * s * 0.07 + s * 3.0 + 8000.0 + s * 49.0 / (s * 1.2e-4 + 4.0));
    // v = V cos: force -4 Fc/pi (cos - cos 3 /3), acceleration s^2 G; v = a/(j w), so a = j w V.
    let third = 4.0 * friction_n / (PI * 3.0) * admittance * s * s / (velocity * omega);
    // Phase of a is 90 degrees ahead of v: three times that is -90 degrees of what is compared.
    let expected = third * Complex::new(0.0, 1.0);
    let got = relative(&state.reference, 3);
    assert!((got / expected - 1.0).norm() < 5e-3, "{got} {expected}");
}

/// Friction that is a large part of the force, against the Fourier sum of its square wave: each order
/// `4 F/(pi n)` moves what yields at n times the frequency, and the armature turns where the orders
/// and the fundamental add up to no velocity. The velocity goes linearly over the step in which it
/// turns, which places the turn to `(2 pi/512)^2 / 8` = 2e-5 rad: 1e-4 of the fifth harmonic.
#[test]
fn strong_friction_turns_where_the_velocity_does() {
    let friction_n = 0.3;
    let text = format!("coulomb_friction=friction_n:{friction_n}");
    for frequency_hz in [25.0, 160.0, 2500.0] {
        let state = hold(&[&text], &usual(), frequency_hz, 10.0);
        let omega = TAU * frequency_hz;
        let yields = |n: usize| {
            let s = Complex::new(0.0, omega * n as f64);
            1.0 / (s * s * 0.07 + s * 3.0 + 8000.0 + s * 49.0 / (s * 1.2e-4 + 4.0))
        };
        let force = 4.0 * friction_n / PI;
        let travel = state.reference.harmonics_v[0].norm() / 0.01 / (omega * omega);
        let orders = (3..200_000).step_by(2).map(|n| yields(n).re).sum::<f64>();
        let turn = (force * orders / travel).asin();
        for n in [3, 5] {
            let moved = Complex::I * force / n as f64 * yields(n);
            let share = moved / -travel * (n * n) as f64;
            let expected = share * Complex::from_polar(1.0, -turn * n as f64);
            let got = relative(&state.reference, n);
            let error = (got / expected - 1.0).norm();
            assert!(error < 1e-4, "{frequency_hz} Hz, {n}: {error:e}");
        }
    }
}

/// On a mass alone the acceleration of friction is a square wave of F/m, whose mean square is
/// (F/m)^2; orders 1, 3 and 5 hold (4/(pi n))^2 / 2 of it. At 1 kHz suspension and coil add 1e-4;
/// the turning points lie within a step of a period, which shifts the orders up to 48 by 1 %.
#[test]
fn friction_beyond_the_fifth_order_is_the_rest_of_a_square_wave() {
    let friction_n = 0.02;
    let text = format!("coulomb_friction=friction_n:{friction_n}");
    let state = hold(&[&text], &usual(), 1000.0, 10.0);
    let order = |n: f64| (4.0 / (PI * n)).powi(2) / 2.0;
    let share = 1.0 - order(1.0) - order(3.0) - order(5.0);
    let expected_v = 0.01 * friction_n / 0.07 * share.sqrt();
    let found_v = state.reference.remainder_rms_v;
    assert!(
        (found_v / expected_v - 1.0).abs() < 0.01,
        "{found_v} {expected_v}"
    );
}

#[test]
fn a_stuck_armature_does_not_move() {
    // 1 N holds against 7/4 N per volt of drive up to 0.57 V: the level cannot be reached gently,
    // and just below the break the motion is nothing.
    let conditions = usual();
    let mut model = Model::new(coil(), Channel::flat(0.01), Channel::flat(0.01));
    "coulomb_friction=friction_n:1"
        .parse::<ActiveEffect>()
        .expect("known")
        .apply(&conditions, &mut model);
    let solver = Solver::default();
    let mut point = Point::new(&solver, &model, &conditions, 20.0).expect("a coil");
    let state = point.at(0.4).expect("at rest");
    let free = hold(&[], &conditions, 20.0, 1.0);
    let per_volt = free.reference.harmonics_v[0].norm() / free.demand_v;
    let share = state.reference.harmonics_v[0].norm() / (0.4 * per_volt);
    // At rest at every grid point; between them the held force moves it by (2 pi/512)^2 at most.
    assert!(share < 1.5e-4, "{share:e}");
}

/// `Bl (1 - b2 x^2)` to first order: with x = X cos the force loses `b2 X^2/4 (3 i_x + i_y)`-like
/// shares; far below resonance the current is in phase with x, so the fundamental loses 3/4 b2 X^2.
#[test]
fn a_drooping_force_factor_loses_three_quarters_of_its_droop() {
    let (frequency_hz, level_ms2) = (5.0, 0.3);
    let omega = TAU * frequency_hz;
    let travel_m = SQRT_2 * level_ms2 / omega.powi(2);
    let b2 = 1e-3 / (travel_m * travel_m);
    let state = hold(
        &[&format!("force_factor_droop=b2_per_m2:{b2}")],
        &usual(),
        frequency_hz,
        level_ms2,
    );
    let plain = hold(&[], &usual(), frequency_hz, level_ms2);
    let loss = 1.0
        - (state.reference.harmonics_v[0] / state.coil_v).norm()
            / (plain.reference.harmonics_v[0] / plain.coil_v).norm();
    // Induced voltage and inertia share the drive by w c'/k and (f/f0)^2: 6 % and 1 %.
    assert!((loss / 0.75e-3 - 1.0).abs() < 0.02, "{loss:e}");
}

/// Linear coil effects against the linear formula with changed coefficients.
#[test]
fn linear_exciter_effects_change_their_coefficient() {
    let conditions = Conditions {
        time_s: 900.0,
        ..usual()
    };
    for (text, changed) in [
        (
            "mechanical_damping=added_damping_ns_per_m:2",
            CoilModel {
                damping_ns_per_m: 5.0,
                ..coil()
            },
        ),
        (
            "payload_mass=added_mass_kg:0.01",
            CoilModel {
                mass_kg: 0.08,
                ..coil()
            },
        ),
        (
            "nominal_stiffness=offset_rel:-0.3",
            CoilModel {
                stiffness_n_per_m: 5600.0,
                ..coil()
            },
        ),
        (
            "nominal_force_factor=offset_rel:0.2",
            CoilModel {
                force_factor_n_per_a: 8.4,
                ..coil()
            },
        ),
        (
            "nominal_resistance=offset_rel:0.5",
            CoilModel {
                resistance_ohm: 6.0,
                ..coil()
            },
        ),
        (
            "nominal_inductance=offset_rel:0.5",
            CoilModel {
                inductance_h: 1.8e-4,
                ..coil()
            },
        ),
        (
            "coil_heating=rise_k:10,time_constant_s:900",
            CoilModel {
                resistance_ohm: 4.0 * (1.0 + 0.039 * (1.0 - (-1.0_f64).exp())),
                ..coil()
            },
        ),
    ] {
        for frequency_hz in [10.0, 54.0, 5e3] {
            let omega = TAU * frequency_hz;
            let state = hold(&[text], &conditions, frequency_hz, 1.0);
            let [current, travel] = changed.linear_response(omega, 0.0);
            let drive = state.reference.harmonics_v[0] / state.coil_v / 0.01;
            assert!(
                (drive / (-travel * omega * omega) - 1.0).norm() < 1e-12,
                "{text}"
            );
            assert!(
                (state.coil_a / state.coil_v / current - 1.0).norm() < 1e-12,
                "{text}"
            );
        }
    }
}

/// Ratios where they are known: filters of fourth order are 3 dB down at the corner, Butterworth's half a
/// turn late; a window and its double lose 2/pi each at half their zero; a seismic mass leads by 90
/// degrees at its resonance, quality times as large; a base of two axes shows its share along one.
#[test]
fn effects_on_the_ratio_are_those_of_their_names() {
    let half_power = 0.5_f64.sqrt();
    for (text, frequency_hz, size, degrees) in [
        (
            "dut_lowpass_4=corner_hz:3000",
            3000.0,
            half_power,
            Some(180.0),
        ),
        (
            "dut_lowpass_4=corner_hz:3000,bessel:1",
            3000.0,
            half_power,
            None,
        ),
        (
            "sinc2_filter=duration_s:1e-4",
            5000.0,
            4.0 / (PI * PI),
            Some(180.0),
        ),
        (
            "dut_highpass_2=corner_hz:20,quality:3",
            20.0,
            3.0,
            Some(90.0),
        ),
        (
            "reference_highpass_2=corner_hz:20,quality:2",
            20.0,
            0.5,
            Some(-90.0),
        ),
        (
            "rotation_twice=share:0.01,beta_rad:0",
            80.0,
            1.01,
            Some(0.0),
        ),
    ] {
        let state = hold(&[text], &usual(), frequency_hz, 1.0);
        let ratio = state.dut.harmonics_v[0] / state.reference.harmonics_v[0];
        assert!((ratio.norm() / size - 1.0).abs() < 1e-6, "{text}: {ratio}");
        if let Some(degrees) = degrees {
            let turn = ratio / Complex::from_polar(1.0, f64::to_radians(degrees));
            assert!(turn.arg().abs() < 1e-6, "{text}: {ratio}");
        }
    }
}

/// Coil, spring and damper between two masses, one on its feet: positions `x` and `y` for a force between
/// them, by the rule of Cramer.
fn two_masses(s: Complex<f64>, force_n: Complex<f64>) -> [Complex<f64>; 2] {
    let (table, body) = (
        s * s * 0.07,
        (s * s + s * (TAU * 30.0 / 4.0) + (TAU * 30.0).powi(2)) * 2.0,
    );
    let spring = s * 3.0 + 8000.0;
    let determinant = (table + spring) * (body + spring) - spring * spring;
    [force_n * body / determinant, -force_n * table / determinant]
}

const BODY: &str = "body_mode=body_mass_kg:2,isolator_hz:30,quality:4";

/// One ampere pushes 7 N between them and takes the voltage of the impedance and of their relative motion.
#[test]
fn a_body_on_its_feet_gives_way() {
    for frequency_hz in [5.0, 29.0, 60.0, 1e3, 1e4] {
        let state = hold(&[BODY], &usual(), frequency_hz, 1.0);
        let s = Complex::new(0.0, TAU * frequency_hz);
        let [x, y] = two_masses(s, Complex::new(7.0, 0.0));
        let volt = s * 1.2e-4 + 4.0 + s * (x - y) * 7.0;
        let drive = state.reference.harmonics_v[0] / state.coil_v / 0.01;
        assert!(
            (drive * volt / (s * s * x) - 1.0).norm() < 1e-12,
            "{frequency_hz}"
        );
        assert!((state.coil_a / state.coil_v * volt - 1.0).norm() < 1e-12);
    }
}

/// To first order the third harmonic of a cubic spring is a force `k3 U^3/4` between the two, U being their
/// relative travel; what it moves induces a current that pushes back.
#[test]
fn a_spring_that_bends_pushes_the_body_too() {
    let (frequency_hz, level_ms2) = (12.0, 2.0);
    let s = Complex::new(0.0, TAU * frequency_hz);
    let one = Complex::new(1.0, 0.0);
    let [x, y] = two_masses(s, one);
    let position_m = -SQRT_2 * level_ms2 / s.norm_sqr();
    let travel_m = position_m * (x - y) / x;
    let k3 = 1e-4 * 8000.0 / travel_m.norm_sqr();
    let bent = format!("suspension_cubic=k3_n_per_m3:{k3}");
    let state = hold(&[BODY, &bent], &usual(), frequency_hz, level_ms2);
    let [x, y] = two_masses(3.0 * s, one);
    let back = 3.0 * s * 49.0 / (3.0 * s * 1.2e-4 + 4.0);
    let moved_m = -0.25 * k3 * travel_m.powu(3) * x / ((x - y) * back + 1.0);
    let expected = moved_m * 9.0 / position_m;
    let third = relative(&state.reference, 3);
    // Second order: 1e-4, which the resonance of the third harmonic near 36 Hz makes larger.
    assert!((third / expected - 1.0).norm() < 2e-3, "{third} {expected}");
}

#[test]
fn the_induced_voltage_scales_without_the_force() {
    let state = hold(&["back_emf=beta:0.2"], &usual(), 54.0, 1.0);
    let s = Complex::new(0.0, TAU * 54.0);
    let mechanics = s * s * 0.07 + s * 3.0 + 8000.0;
    let denominator = mechanics * (s * 1.2e-4 + 4.0) + s * 49.0 * 1.2;
    assert!((state.coil_a / state.coil_v * denominator / mechanics - 1.0).norm() < 1e-12);
}

/// A nonlinear coil with a lossy inductance is integrated with the ladder, a linear one has the
/// power law itself: a vanishing nonlinear term must make no difference beyond the ladder's error.
#[test]
fn ladder_and_power_law_agree() {
    for frequency_hz in [5.0, 60.0, 5e3] {
        let lossy = "lossy_inductance=exponent:0.6";
        let linear = hold(&[lossy], &usual(), frequency_hz, 1.0);
        let bent = hold(
            &[lossy, "suspension_cubic=k3_n_per_m3:1e8"],
            &usual(),
            frequency_hz,
            1.0,
        );
        let plain = hold(
            &["suspension_cubic=k3_n_per_m3:1e8"],
            &usual(),
            frequency_hz,
            1.0,
        );
        let none = hold(&[], &usual(), frequency_hz, 1.0);
        let drive = |state: &SteadyState| state.reference.harmonics_v[0] / state.coil_v;
        let effect = drive(&bent) / drive(&linear);
        let expected = drive(&plain) / drive(&none);
        // The inductance is small at low frequency, where the cubic term acts.
        assert!(
            (effect / expected - 1.0).norm() < 0.05 * (expected - 1.0).norm() + 1e-9,
            "{frequency_hz}"
        );
    }
}

#[test]
fn amplifier_distortion_reaches_both_channels_through_the_coil() {
    let (frequency_hz, level_ms2) = (1000.0, 10.0);
    let state = hold(
        &["amplifier_even_order=even_per_v:0.01"],
        &usual(),
        frequency_hz,
        level_ms2,
    );
    let omega = TAU * frequency_hz;
    let [_, one] = coil().linear_response(omega, 0.0);
    let [_, two] = coil().linear_response(2.0 * omega, 0.0);
    // b e^2 = b V/2 of the fundamental at twice the frequency, turned by the coil's response.
    let expected = 0.005 * state.demand_v * (4.0 * two).norm() / one.norm();
    for channel in [&state.reference, &state.dut] {
        assert!((relative(channel, 2).norm() / expected - 1.0).abs() < 1e-9);
    }
    // Clipped at 90 % of the demand: fundamental of a clipped sine.
    let free = hold(&[], &usual(), frequency_hz, level_ms2);
    let threshold_v = 0.95 * free.demand_v;
    let clipped = hold(
        &[&format!("amplifier_clipping=threshold_v:{threshold_v}")],
        &usual(),
        frequency_hz,
        level_ms2,
    );
    let b = (threshold_v / clipped.demand_v).acos();
    let gain = 1.0 - (2.0 * b - (2.0 * b).sin()) / PI;
    assert!((clipped.coil_v.norm() / clipped.demand_v / gain - 1.0).abs() < 1e-6);
    assert!(relative(&clipped.dut, 3).norm() > 1e-3);
}

#[test]
fn converter_effects_have_their_first_order_shape() {
    let level_ms2 = 50.0;
    let peak_v = 0.01 * level_ms2 * SQRT_2;
    let at = |text: &str| hold(&[text], &usual(), 160.0, level_ms2);
    let near = |got: f64, want: f64, tolerance: f64| {
        assert!((got / want - 1.0).abs() < tolerance, "{got} {want}")
    };
    let ratio =
        |state: &SteadyState| (state.dut.harmonics_v[0] / state.reference.harmonics_v[0]).re;
    let cubic = at("adc_cubic=c3_per_v2:0.01");
    near(ratio(&cubic) - 1.0, 0.75 * 0.01 * peak_v * peak_v, 1e-3);
    near(
        relative(&cubic.dut, 3).re,
        0.25 * 0.01 * peak_v * peak_v,
        1e-2,
    );
    let quadratic = at("adc_quadratic=c2_per_v:0.01");
    near(quadratic.dut.mean_v, 0.005 * peak_v * peak_v, 1e-3);
    near(relative(&quadratic.dut, 2).re, 0.005 * peak_v, 1e-3);
    let dead = at("adc_dead_zone=delta_v:0.0005");
    near(1.0 - ratio(&dead), 4.0 * 0.0005 / (PI * peak_v), 1e-3);
    near(
        relative(&dead.dut, 3).re,
        4.0 * 0.0005 / (3.0 * PI * peak_v),
        5e-3,
    );
    let clipped = at(&format!("adc_clipping=threshold_v:{}", 0.9 * peak_v));
    let b = 0.9_f64.acos();
    near(
        ratio(&clipped),
        1.0 - (2.0 * b - (2.0 * b).sin()) / PI,
        1e-4,
    );
    // To first order -v^3/(3 c^2), a cubic; the next order is 2/5 of (A/c)^2 of that or less: 4e-3.
    let soft = at(&format!("adc_soft_clipping=threshold_v:{}", 10.0 * peak_v));
    near(1.0 - ratio(&soft), 0.25e-2, 1e-2);
    near(relative(&soft.dut, 3).re, -1e-2 / 12.0, 2e-2);
    // In the reference channel the level is held, and the truth of the motion goes up.
    let reference = at("adc_cubic=c3_per_v2:0.01,channel:0");
    // Second order: three times the effect of 0.4 %.
    near(
        1.0 - ratio(&reference),
        0.75 * 0.01 * peak_v * peak_v,
        1.5e-2,
    );
    assert!(relative(&reference.dut, 3).norm() < 1e-12);
}

#[test]
fn a_loose_device_is_cut_on_one_side() {
    // Peak 14.1 m/s2, cut at -10: the ramp max(A cos - b, 0) has the mean (A sin t - b t)/pi.
    let state = hold(
        &["loose_mount=threshold_ms2:10,impact_noise:0.1"],
        &usual(),
        160.0,
        10.0,
    );
    let peak_ms2 = state.reference.harmonics_v[0].norm() / 0.01;
    let t = (10.0 / peak_ms2).acos();
    let lost = (t - t.sin() * t.cos()) / PI;
    let ratio = state.dut.harmonics_v[0] / state.reference.harmonics_v[0];
    assert!((ratio.re - (1.0 - lost)).abs() < 1e-4, "{ratio} {lost}");
    assert!((state.dut.noise_rms_v / (0.1 * (peak_ms2 - 10.0) * 0.01) - 1.0).abs() < 1e-9);
    assert!(relative(&state.dut, 2).norm() > 0.01 && state.reference.noise_rms_v == 0.0);
}

#[test]
fn every_effect_changes_something() {
    let solver = Solver::default();
    let conditions = Conditions {
        time_s: 3600.0,
        warmer_k: 7.0,
        tilt_rad: 0.5,
        ..usual()
    };
    for effect in Effect::all() {
        let plain = Model::new(coil(), Channel::flat(0.01), Channel::flat(0.01));
        let mut model = plain.clone();
        effect.usual().apply(&conditions, &mut model);
        assert_ne!(model, plain, "{}", effect.entry.id);
        for frequency_hz in [8.0, 60.0, 1e3, 1e4] {
            let level_v = 0.01 * f64::min(10.0, 0.01 * f64::powi(frequency_hz, 2));
            let held = solver.hold(&model, &conditions, frequency_hz, level_v);
            assert!(held.is_ok(), "{} {frequency_hz} {held:?}", effect.entry.id);
        }
    }
}
