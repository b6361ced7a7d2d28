//! Parts of a calibrator, effects included: the one description that the plant in time and
//! the steady-state generator of datasets both read.
//!
//! ```text
//! drive -> amplifier -> exciter -> table -+-> reference: motion -> response -> converter
//!                                         +-> device:    motion -> response -> converter
//! ```
//!
//! A model without effects is linear. Effects change its fields and know nothing about how it is
//! solved.

mod channel;
mod exciter;
mod friction;
mod reciprocity;
mod section;

pub use self::channel::{Channel, Characteristic, Pickup, Range, Separation, WarmUp};
pub use self::exciter::{
    BodyModel, COPPER_PER_K, CoilModel, Creep, InductanceLadder, RETARDATIONS,
};
pub use self::friction::friction;
pub use self::reciprocity::{CoilInput, Reciprocity};
pub use self::section::{SecondOrder, Section};

/// Standard acceleration of free fall, m/s2.
///
/// # Source
/// ISO 80000-3:2019.
pub const FREE_FALL_MS2: f64 = 9.806_65;

/// Under which conditions a point is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditions {
    /// Time since the first point, s.
    pub time_s: f64,
    /// Temperature of the transducers above their reference temperature, K.
    pub warmer_k: f64,
    /// Rotation of the device under test about the axis of motion, rad.
    pub rotation_rad: f64,
    /// Angle between the axis of motion and the vertical, rad.
    pub tilt_rad: f64,
    /// Mass mounted on the armature, kg.
    pub payload_kg: f64,
    /// Frequency of the mains, Hz.
    pub mains_hz: f64,
}

impl Conditions {
    /// Vertical, at reference temperature, at the start, with `payload_kg` mounted.
    pub fn usual(payload_kg: f64) -> Self {
        Self {
            time_s: 0.0,
            warmer_k: 0.0,
            rotation_rad: 0.0,
            tilt_rad: 0.0,
            payload_kg,
            mains_hz: 50.0,
        }
    }
}

/// Power amplifier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplifierModel {
    /// Output saturates at this voltage, V peak; infinite if it does not.
    pub threshold_v: f64,
    /// Output bends towards this voltage as a hyperbolic tangent, V peak; infinite if it does not.
    pub knee_v: f64,
    /// `b` of the output `e + b (e^2 - mean e^2)` (the output is a.c. coupled), 1/V.
    pub even_per_v: f64,
    /// Relative change of the gain per second.
    pub drift_per_s: f64,
}

impl AmplifierModel {
    /// The output for `input_v`, before a.c. coupling.
    pub fn output_v(&self, input_v: f64) -> f64 {
        let bent = input_v + self.even_per_v * input_v * input_v;
        let soft = if self.knee_v.is_finite() {
            self.knee_v * (bent / self.knee_v).tanh()
        } else {
            bent
        };
        soft.clamp(-self.threshold_v, self.threshold_v)
    }

    /// Whether the output is the input.
    pub fn is_linear(&self) -> bool {
        self.threshold_v.is_infinite() && self.knee_v.is_infinite() && self.even_per_v == 0.0
    }
}

/// Motion of the base that has nothing to do with the drive and reaches both transducers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AmbientMotion {
    /// Broadband part, m/s2 r.m.s. in the band of the digitiser.
    pub broadband_rms_ms2: f64,
    /// Tone, m/s2 r.m.s.
    pub tone_rms_ms2: f64,
    /// Its frequency, Hz.
    pub tone_hz: f64,
}

/// A calibrator with its effects, at one set of conditions.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Power amplifier.
    pub amplifier: AmplifierModel,
    /// Moving coil with suspension and payload.
    pub coil: CoilModel,
    /// Response of the table (where the transducers are) over the armature (where the force is).
    pub table: Vec<Section>,
    /// Motion from outside.
    pub ambient: AmbientMotion,
    /// Standard deviation of the sampling instants of both channels, s.
    pub jitter_s: f64,
    /// Reference channel.
    pub reference: Channel,
    /// Device under test.
    pub dut: Channel,
    /// Coil sensing and an added mass.
    pub reciprocity: Option<Reciprocity>,
}

impl Model {
    /// A linear calibrator: a moving coil and two channels.
    pub fn new(coil: CoilModel, reference: Channel, dut: Channel) -> Self {
        Self {
            amplifier: AmplifierModel {
                threshold_v: f64::INFINITY,
                knee_v: f64::INFINITY,
                even_per_v: 0.0,
                drift_per_s: 0.0,
            },
            coil,
            table: Vec::new(),
            ambient: AmbientMotion::default(),
            jitter_s: 0.0,
            reference,
            dut,
            reciprocity: None,
        }
    }
}
