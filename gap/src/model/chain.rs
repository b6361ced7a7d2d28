//! What effects do to one row: the places where they may act.

use super::balance::Bend;
use super::waveform::Characteristic;
use num_complex::Complex64;

/// Changes of the exciter, the amplifier, the digitiser and the noise in one row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chain {
    /// Gain of the device under test relative to its nominal value (given, not changed).
    pub(crate) dut_gain: f64,
    /// Added to the moving mass, in kg.
    pub(crate) mass_kg: f64,
    /// Added to the mechanical damping, in N s/m.
    pub(crate) damping_ns_per_m: f64,
    /// Factor on the coil resistance.
    pub(crate) resistance: f64,
    /// Factor on the induced voltage.
    pub(crate) emf: f64,
    /// Exponent of the coil inductance.
    pub(crate) inductance_exponent: f64,
    /// Nonlinear exciter and amplifier.
    pub(crate) bend: Bend,
    /// Motion of the device under test, in m/s2.
    pub(crate) mount: Option<Characteristic>,
    /// Reference channel of the digitiser, in V.
    pub(crate) ref_adc: Option<Characteristic>,
    /// DUT channel of the digitiser, in V.
    pub(crate) dut_adc: Option<Characteristic>,
    /// Relative harmonics 2..5 added in the device under test.
    pub(crate) dut_harmonics: [f64; 4],
    /// Mean square noise added in the channels: reference, device under test, in V^2.
    pub(crate) noise_v2: [f64; 2],
    /// Mean square of it that components of the block may have taken: what is computed as a
    /// harmonic or as d.c. is not left as noise.
    pub(crate) taken_v2: [f64; 2],
    /// Standard deviation of the logarithm of the noise that the effect leaves open.
    pub(crate) noise_open: [f64; 2],
    /// Variance, per part, of the relative error of ratio and drive by leakage.
    pub(crate) leakage: [f64; 2],
    /// The same for relative harmonics 2..5 of reference and device under test.
    pub(crate) harmonic_leakage: [[f64; 4]; 2],
    /// Variance of the d.c. values by leakage, in V^2.
    pub(crate) dc_leakage_v2: [f64; 2],
}

impl Default for Chain {
    fn default() -> Self {
        Self {
            dut_gain: 1.0,
            mass_kg: 0.0,
            damping_ns_per_m: 0.0,
            resistance: 1.0,
            emf: 1.0,
            inductance_exponent: 1.0,
            bend: Bend::default(),
            mount: None,
            ref_adc: None,
            dut_adc: None,
            dut_harmonics: [0.0; 4],
            noise_v2: [0.0; 2],
            taken_v2: [0.0; 2],
            noise_open: [0.0; 2],
            leakage: [0.0; 2],
            harmonic_leakage: [[0.0; 4]; 2],
            dc_leakage_v2: [0.0; 2],
        }
    }
}

impl Chain {
    /// Mean square noise of a channel in V^2, and the variance of its logarithm that stays open.
    ///
    /// How a line shares its power with the components depends on where it lies in its bin
    /// and on the window: the size of the reduction is open by itself.
    pub(crate) fn noise(&self, channel: usize, healthy_v2: f64) -> (f64, f64) {
        let all = healthy_v2 + self.noise_v2[channel];
        let own = self.noise_open[channel].powi(2);
        if self.taken_v2[channel] == 0.0 {
            return (all, own);
        }
        let left = (all - self.taken_v2[channel]).max(healthy_v2).min(all);
        let reduction = if left > 0.0 {
            0.5 * (all / left).ln()
        } else {
            0.0
        };
        (left, own + reduction * reduction)
    }
}

/// Linear responses at one frequency, multiplied up over the effects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Transfer {
    /// Reference channel.
    pub(crate) reference: Complex64,
    /// Device under test with mount and channel.
    pub(crate) dut: Complex64,
    /// Table over armature.
    pub(crate) table: Complex64,
    /// Recorded drive only (not in the motion).
    pub(crate) drive: Complex64,
}

impl Default for Transfer {
    fn default() -> Self {
        let one = Complex64::ONE;
        Self {
            reference: one,
            dut: one,
            table: one,
            drive: one,
        }
    }
}
