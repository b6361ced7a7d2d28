//! Linear responses of both channels and of the table.

use super::design::Condition;
use super::truth::Truth;
use num_complex::Complex64 as C;
use std::f64::consts::{PI, TAU};

/// Factors on a motion, and on what the channels see of it.
pub(crate) struct Responses {
    /// Of the motion of the table to that of the coil.
    pub(crate) table: C,
    pub(crate) reference: C,
    pub(crate) dut: C,
}

/// All responses at a frequency, which may be a multiple of that of the row.
pub(crate) fn responses(truth: &Truth, row: &Condition, frequency_hz: f64) -> Responses {
    let jitter = truth.factor("sampling_jitter.s", |s| {
        (-(TAU * frequency_hz * s).powi(2) / 2.0).exp()
    });
    let dut = mounting(truth, row, frequency_hz)
        * device(truth, row, frequency_hz)
        * conditioner(truth, frequency_hz)
        * timing(truth, row, frequency_hz);
    Responses {
        table: table(truth, frequency_hz),
        reference: reference(truth, row, frequency_hz) * jitter,
        dut: dut * jitter,
    }
}

/// A resonance, or a low-pass of second order.
fn second_order(frequency_hz: f64, resonance_hz: f64, quality: f64) -> C {
    let w = frequency_hz / resonance_hz;
    (C::ONE - w * w + C::new(0.0, w / quality)).inv()
}

fn high_pass(frequency_hz: f64, corner_hz: f64) -> C {
    let w = frequency_hz / corner_hz;
    C::new(0.0, w) / C::new(1.0, w)
}

/// A mass on a spring that is moved at its base: what the spring stretches.
fn seismic(frequency_hz: f64, natural_hz: f64, quality: f64) -> C {
    let w = natural_hz / frequency_hz;
    C::new(1.0 - w * w, -w / quality).inv()
}

/// Low-pass of fourth order from its poles in the left half-plane, 3 dB down at the corner.
fn fourth_order(frequency_hz: f64, corner_hz: f64, bessel: bool) -> C {
    let s = C::new(0.0, frequency_hz / corner_hz);
    // Of Bessel's filter from a table of filters, for 1 rad/s.
    let upper = if bessel {
        [
            C::new(-1.370_067_8, 0.410_249_7),
            C::new(-0.995_208_8, 1.257_105_7),
        ]
    } else {
        [5.0, 7.0].map(|eighths| C::from_polar(1.0, PI * eighths / 8.0))
    };
    let factor = |pole: C| pole.norm_sqr() / ((s - pole) * (s - pole.conj()));
    factor(upper[0]) * factor(upper[1])
}

fn table(truth: &Truth, frequency_hz: f64) -> C {
    truth.factor("armature_mode.k", |k| {
        let w = frequency_hz / truth.or("armature_mode.f", 5000.0);
        let damping = truth.or("armature_mode.z", 0.02);
        C::ONE + k * w * w / C::new(1.0 - w * w, 2.0 * damping * w)
    })
}

fn reference(truth: &Truth, row: &Condition, frequency_hz: f64) -> C {
    let resonance = truth.factor("reference_resonance.f", |resonance_hz| {
        let quality = truth.or("reference_resonance.q", 30.0);
        second_order(frequency_hz, resonance_hz, quality)
    });
    let warmer_k = row.temperature_c - 23.0;
    let warm = 1.0 + truth.or("reference_temperature.a", 0.0) * warmer_k;
    let drift = 1.0 / (1.0 + truth.or("reference_drift.b", 0.0) * row.time_s);
    let settled = warm_up(truth, row, ["reference_warm_up.g", "reference_warm_up.tau"]);
    let drift = drift / settled;
    let corner = truth.factor("reference_highpass.f", |hz| high_pass(frequency_hz, hz));
    let second = truth.factor("reference_highpass_2.f", |hz| {
        seismic(frequency_hz, hz, truth.or("reference_highpass_2.q", 0.7))
    });
    resonance * warm * drift * corner * second
}

/// Motion of the table as the device feels it.
fn mounting(truth: &Truth, row: &Condition, frequency_hz: f64) -> C {
    let rotation_rad = row.rotation_deg.to_radians();
    let compliance = truth.factor("mount_compliance.k", |stiffness| {
        let resonance_hz = (stiffness / row.payload_kg).sqrt() / TAU;
        let quality = truth.or("mount_compliance.q", 20.0);
        second_order(frequency_hz, resonance_hz, quality)
    });
    let relative = truth.factor("relative_motion.k", |k| {
        1.0 - k * row.payload_kg * frequency_hz * frequency_hz
    });
    let strain = truth.factor("base_strain.s", |s| {
        let f = frequency_hz / truth.or("base_strain.f1", 30.0);
        1.0 + s * row.payload_kg / 0.04 / (1.0 + f * f)
    });
    let tilt = truth.factor("gravity_tilt.g", |g| {
        1.0 + g * rotation_rad.cos() / (frequency_hz * frequency_hz)
    });
    let transverse = truth.factor("transverse_motion.t0", |t0| {
        let resonance_hz = truth.or("transverse_motion.f", 1000.0);
        let quality = truth.or("transverse_motion.q", 10.0);
        let rocking = second_order(frequency_hz, resonance_hz, quality);
        let across = rocking * truth.or("transverse_motion.t1", 0.0) + t0;
        C::ONE + across * (rotation_rad - truth.or("transverse_motion.beta", 0.0)).cos()
    });
    let twice = truth.factor("rotation_twice.s", |s| {
        1.0 + s * (2.0 * (rotation_rad - truth.or("rotation_twice.beta", 0.0))).cos()
    });
    compliance * relative * transverse * strain * tilt * twice
}

/// A gain that comes to rest; in its other form two parts warm up, a large one five times as slowly.
fn warm_up(truth: &Truth, row: &Condition, [change, time_constant_s]: [&str; 2]) -> f64 {
    let tau_s = truth.or(time_constant_s, 600.0);
    let cold = |tau_s: f64| (-row.time_s / tau_s).exp();
    let course = match truth.has_other_form() {
        true => 0.7 * cold(tau_s) + 0.3 * cold(5.0 * tau_s),
        false => cold(tau_s),
    };
    1.0 + truth.or(change, 0.0) * course
}

/// The device itself.
fn device(truth: &Truth, row: &Condition, frequency_hz: f64) -> C {
    let other = truth.has_other_form();
    let resonance = truth.factor("dut_resonance.f", |resonance_hz| {
        let quality = truth.or("dut_resonance.q", 30.0);
        let one = second_order(frequency_hz, resonance_hz, quality);
        let above = second_order(frequency_hz, 1.9 * resonance_hz, quality);
        if other { 0.9 * one + 0.1 * above } else { one }
    });
    let slope = truth.factor("dut_frequency_slope.s", |s| {
        let decades = (frequency_hz / 159.155).log10();
        // A spread of time constants that ends somewhere.
        1.0 - s * if other {
            2.0 * (0.5 * decades).tanh()
        } else {
            decades
        }
    });
    let level_ms2 = row.acceleration_rms_ms2;
    let level_ms2 = if other {
        level_ms2.powf(1.5) / 60.0_f64.sqrt()
    } else {
        level_ms2
    };
    let level = 1.0 + truth.or("dut_level_nonlinearity.g", 0.0) * level_ms2;
    let warmer_k = row.temperature_c - 23.0;
    let warmer_k = if other {
        warmer_k + warmer_k * warmer_k / 30.0
    } else {
        warmer_k
    };
    let warm = 1.0 + truth.or("dut_temperature.a", 0.0) * warmer_k;
    // Faster and faster.
    let time_s = if other {
        row.time_s * (1.0 + row.time_s / 9000.0)
    } else {
        row.time_s
    };
    let drift = 1.0 + truth.or("dut_drift.b", 0.0) * time_s;
    let drift = drift * warm_up(truth, row, ["dut_warm_up.g", "dut_warm_up.tau"]);
    let power = truth.factor("dut_power_law.n", |n| {
        C::new(0.0, frequency_hz / 159.155).powf(-n)
    });
    resonance * slope * level * warm * drift * power
}

/// The amplifier behind the device.
fn conditioner(truth: &Truth, frequency_hz: f64) -> C {
    let other = truth.has_other_form();
    // A coupling or a cable whose capacitor is no pure one.
    let corner = truth.factor("dut_highpass.f", |hz| {
        let one = high_pass(frequency_hz, hz);
        if other { one.powf(0.85) } else { one }
    });
    let first = truth.factor("dut_lowpass_1.f", |hz| {
        let one = C::new(1.0, frequency_hz / hz).inv();
        if other { one.powf(0.85) } else { one }
    });
    let second = truth.factor("dut_lowpass_2.f", |corner_hz| {
        second_order(frequency_hz, corner_hz, truth.or("dut_lowpass_2.q", 0.707))
    });
    let crosstalk = truth.factor("crosstalk.c", |c| C::new(1.0, frequency_hz * c));
    let seismic = truth.factor("dut_highpass_2.f", |hz| {
        seismic(frequency_hz, hz, truth.or("dut_highpass_2.q", 0.7))
    });
    let steep = truth.factor("dut_lowpass_4.f", |hz| {
        fourth_order(
            frequency_hz,
            hz,
            truth.or("dut_lowpass_4.bessel", -1.0) > 0.0,
        )
    });
    corner * first * second * crosstalk * seismic * steep
}

/// When the channel of the device is sampled.
fn timing(truth: &Truth, row: &Condition, frequency_hz: f64) -> C {
    let averaged = truth.factor("averaging_window.t", |window_s| {
        let half_rad = PI * frequency_hz * window_s;
        C::from_polar(half_rad.sin() / half_rad, -half_rad)
    });
    let skew_s = truth.or("channel_skew.t", 0.0) - truth.or("clock_offset.d", 0.0) * row.time_s;
    let twice = truth.factor("sinc2_filter.t", |window_s| {
        let half_rad = PI * frequency_hz * window_s;
        (C::from_polar(half_rad.sin() / half_rad, -half_rad)).powi(2)
    });
    averaged * twice * C::from_polar(1.0, -TAU * frequency_hz * skew_s)
}
