//! Places where effects may act on one row.

use super::exciter::{Body, Nonlinearity};
use super::scatter::Scatter;
use super::waveform::Characteristic;
use num_complex::Complex64;

/// Changes of the exciter, the amplifier, the digitiser and the noise in one row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chain {
    /// Added to the moving mass, in kg.
    pub(crate) mass_kg: f64,
    /// Added to the mechanical damping, in N s/m.
    pub(crate) damping_ns_per_m: f64,
    /// Factor on the stiffness of the suspension.
    pub(crate) stiffness: f64,
    /// Share by which the compliance of the suspension grows per decade.
    pub(crate) creep_per_decade: f64,
    /// Factor on force per current and voltage per velocity.
    pub(crate) force_factor: f64,
    /// Factor on the coil inductance.
    pub(crate) inductance: f64,
    /// Factor on the coil resistance.
    pub(crate) resistance: f64,
    /// Factor on the induced voltage.
    pub(crate) emf: f64,
    /// Exponent of the coil inductance.
    pub(crate) inductance_exponent: f64,
    /// Share of the coil inductance that is shorted above a corner, and that corner in Hz.
    pub(crate) shorted: [f64; 2],
    /// The body of the exciter, if it gives way.
    pub(crate) body: Option<Body>,
    /// Nonlinear exciter and amplifier.
    pub(crate) bend: Nonlinearity,
    /// Motion of the device under test, in m/s2.
    pub(crate) mount: Option<Characteristic>,
    /// Reference channel of the digitiser, in V.
    pub(crate) ref_adc: Option<Characteristic>,
    /// DUT channel of the digitiser, in V.
    pub(crate) dut_adc: Option<Characteristic>,
    /// Relative change of the gain of the device under test per m/s2 (r.m.s.) of the table, as the
    /// responses have it; the device feels what its mount lets through.
    pub(crate) dut_level_per_ms2: f64,
    /// Relative harmonics 2..5 added in the device under test.
    pub(crate) dut_harmonics: [f64; 4],
    /// Noise and leakage.
    pub(crate) scatter: Scatter,
}

impl Default for Chain {
    fn default() -> Self {
        Self {
            mass_kg: 0.0,
            damping_ns_per_m: 0.0,
            stiffness: 1.0,
            creep_per_decade: 0.0,
            force_factor: 1.0,
            inductance: 1.0,
            resistance: 1.0,
            emf: 1.0,
            inductance_exponent: 1.0,
            shorted: [0.0, 1.0],
            body: None,
            bend: Nonlinearity::default(),
            mount: None,
            ref_adc: None,
            dut_adc: None,
            dut_level_per_ms2: 0.0,
            dut_harmonics: [0.0; 4],
            scatter: Scatter::default(),
        }
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
