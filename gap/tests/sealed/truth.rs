//! True rig: its values, and any effects.

use super::random::Random;
use num_complex::Complex64 as C;
use std::collections::BTreeMap;

/// Sensitivity of the reference as everybody believes it, V/(m/s2).
pub(crate) const REFERENCE_V_PER_MS2: f64 = 0.0102;
/// Its standard uncertainty.
const U_REFERENCE_V_PER_MS2: f64 = 0.00003;

/// The exciter as everybody believes it: name, value, standard uncertainty.
pub(crate) const NOMINAL: [(&str, f64, f64); 6] = [
    ("moving_mass_kg", 0.05, 0.0005),
    ("stiffness_n_per_m", 8000.0, 400.0),
    ("damping_ns_per_m", 3.0, 0.6),
    ("force_factor_n_per_a", 7.0, 0.2),
    ("coil_resistance_ohm", 4.0, 0.05),
    ("coil_inductance_h", 0.00012, 0.00001),
];

/// Key that gives the effects another form than the library has: a corner of broken order, saturation
/// for a straight line.
pub(crate) const OTHER_FORM: &str = "form.other";
/// Effects with another form.
pub(crate) const FORMS: [&str; 16] = [
    "dut_resonance",
    "dut_frequency_slope",
    "dut_level_nonlinearity",
    "dut_temperature",
    "dut_drift",
    "dut_highpass",
    "dut_lowpass_1",
    "lossy_inductance",
    "shorted_inductance",
    "dut_warm_up",
    "reference_warm_up",
    "amplifier_soft_clipping",
    "suspension_cubic",
    "body_mode",
    "suspension_creep",
    "adc_soft_clipping",
];

/// Values as they really are; effects are absent where nobody added them.
#[derive(Clone)]
pub(crate) struct Truth {
    /// Sensitivity of reference and device, V/(m/s2).
    pub(crate) sensitivity_v_per_ms2: [f64; 2],
    /// The exciter, in the order of [`NOMINAL`].
    pub(crate) exciter: [f64; 6],
    /// Noise of each input, r.m.s., V.
    pub(crate) noise_rms_v: f64,
    /// Parameters of the effects, by `effect.parameter`.
    pub(crate) effects: BTreeMap<&'static str, f64>,
}

impl Truth {
    /// A rig without effects, drawn from the stated uncertainties.
    pub(crate) fn honest(random: &mut Random) -> Self {
        let mut exciter = [0.0; 6];
        for (value, (_, nominal, u)) in exciter.iter_mut().zip(NOMINAL) {
            *value = nominal + u * random.normal().clamp(-2.5, 2.5);
        }
        let reference = REFERENCE_V_PER_MS2 + U_REFERENCE_V_PER_MS2 * random.normal();
        Self {
            sensitivity_v_per_ms2: [reference, 0.01 * random.gain(0.05)],
            exciter,
            noise_rms_v: 4e-5 * random.gain(0.01),
            effects: BTreeMap::new(),
        }
    }

    pub(crate) fn get(&self, key: &str) -> Option<f64> {
        self.effects.get(key).copied()
    }

    /// A parameter, or what it is without the effect.
    pub(crate) fn or(&self, key: &str, without: f64) -> f64 {
        self.get(key).unwrap_or(without)
    }

    /// Whether effects act in another form than the library's.
    pub(crate) fn has_other_form(&self) -> bool {
        self.effects.contains_key(OTHER_FORM)
    }

    /// Factor of an effect on a response; 1 without it.
    pub(crate) fn factor<F: Into<C>>(&self, key: &str, effect: impl FnOnce(f64) -> F) -> C {
        self.get(key).map_or(C::ONE, |value| effect(value).into())
    }
}
