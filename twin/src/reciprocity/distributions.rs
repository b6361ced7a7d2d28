//! The one table of what is drawn for a check by reciprocity, with the basis of each line.

use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution as _, StandardNormal};

/// How a quantity is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Evenly between both values.
    Even(f64, f64),
    /// Evenly on a logarithmic scale between both values.
    Logarithmic(f64, f64),
    /// Normal around 0 with this standard deviation.
    Normal(f64),
}

/// A line of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The quantity in words, with its unit.
    pub what: &'static str,
    /// How it is drawn.
    pub shape: Shape,
    /// Why so.
    pub basis: &'static str,
}

const fn line(what: &'static str, shape: Shape, basis: &'static str) -> Drawn {
    Drawn { what, shape, basis }
}

use Shape::{Even, Logarithmic, Normal};

pub(super) const MASS_ERROR: Drawn = line(
    "added mass over what is stated of it, 1",
    Even(-1e-4, 1e-4),
    "5 mg of 50 g: a balance of class II with d = 1 mg, mass and stud together; buoyancy of steel is 2e-6",
);
pub(super) const GREASE_KG: Drawn = line(
    "film under the mass, another at each mounting, kg",
    Even(0.0, 5e-6),
    "20 um on 3 cm2 of 0.9 g/cm3",
);
pub(super) const SHUNT_ERROR: Drawn = line(
    "shunt of 1 ohm over what is stated of it, 1",
    Even(-5e-4, 5e-4),
    "0.05 %, four wires; 15 ppm/K over 5 K are within",
);
pub(super) const SHUNT_INDUCTANCE_H: Drawn = line(
    "inductance of the shunt, H",
    Even(5e-9, 30e-9),
    "open-air or foil four-terminal resistors",
);
pub(super) const DIVIDER_ERROR: Drawn = line(
    "divider over what is stated of it, 1",
    Even(-5e-4, 5e-4),
    "two resistors of 0.025 %",
);
pub(super) const DIVIDER_CORNER_HZ: Drawn = line(
    "corner of the divider with its cable, Hz",
    Logarithmic(3e5, 3e6),
    "1 kohm of source and 50 to 500 pF",
);
pub(super) const RATIO_ERROR: Drawn = line(
    "ratio of the channels over what was measured of it, the same at all frequencies, 1",
    Normal(2.5e-4),
    "U (k = 2) of 0.05 % by `adjust ratio`; 0.017 % by 10 K since then (hardware/README.md)",
);
pub(super) const RATIO_SCATTER: Drawn = line(
    "what two measurements of that ratio differ by, 1",
    Normal(5e-5),
    "scatter of `adjust ratio` at 50 m/s2: below 1e-4 of its U is scatter",
);
pub(super) const READING_ERROR: Drawn = line(
    "error of a reading by the converters' characteristic, its own at each level of a channel, 1",
    Normal(5e-5),
    "`the_converters_disturb_a_ratio_of_levels`: units, shapes and levels of the emulated converters",
);
pub(super) const CROSSTALK: Drawn = line(
    "of the other input's signal in an input, the same both ways, 1",
    Even(-1e-4, 1e-4),
    "-80 dB while both convert (twin/src/converters/sheet.rs)",
);
pub(super) const INPUT_NOISE_RMS_V: Drawn = line(
    "noise of a sample at the connector, V r.m.s.",
    Even(3.0e-4, 4.5e-4),
    "1 mV of a conversion, the mean of eight (twin/src/converters/sheet.rs), and 64 uV of the front end",
);
pub(super) const FLOOR_RMS_MS2: Drawn = line(
    "motion of the floor within 1 Hz at a tone, m/s2 r.m.s.",
    Logarithmic(1e-5, 3e-4),
    "workshop floors: 0.1 to 3 mm/s2 in a third of an octave at 100 Hz",
);
pub(super) const SEAT_N_PER_M: Drawn = line(
    "stiffness of the seat of the mass, N/m",
    Logarithmic(2e8, 6e8),
    "steel on steel with a film, M5 stud, 3 cm2",
);
pub(super) const SEAT_SCATTER: Drawn = line(
    "the same from mounting to mounting, ln",
    Normal(0.15),
    "torque within 10 %, film not the same",
);
pub(super) const ECCENTRICITY_M: Drawn = line(
    "centre of the mass off the axis, x and y, m",
    Even(-5e-5, 5e-5),
    "turned on one chuck, hole and rim within 0.05 mm",
);
pub(super) const ECCENTRICITY_SCATTER_M: Drawn = line(
    "the same from mounting to mounting, m",
    Normal(3e-5),
    "clearance of the stud",
);
pub(super) const ANGLE_ERROR_RAD: Drawn = line(
    "orientation off 0, 120, 240 degrees, rad",
    Normal(0.05),
    "three marks, by eye",
);
pub(super) const REFERENCE_OFF_AXIS_M: Drawn = line(
    "sensitive axis of the reference off the axis, m",
    Even(0.0, 2e-3),
    "an integral element of 10 mm",
);
pub(super) const ROCKING_INERTIA_KG_M2: Drawn = line(
    "moment of inertia of the loaded table, kg m2",
    Logarithmic(1e-5, 3e-5),
    "0.1 kg of 20 to 35 mm diameter",
);
pub(super) const ROCKING_HZ: Drawn = line(
    "rocking mode, Hz",
    Logarithmic(1.3e3, 5e3),
    "below 1 kHz it would break the 10 % of transverse motion of ISO 16063-21, Table 2",
);
pub(super) const ROCKING_QUALITY: Drawn = line(
    "its quality factor, 1",
    Logarithmic(5.0, 30.0),
    "flexures with and without damping",
);
pub(super) const TABLE_SHARE: Drawn = line(
    "table's part of the moving mass, 1",
    Even(0.4, 0.7),
    "the rest is coil and former",
);
pub(super) const TABLE_HZ: Drawn = line(
    "axial mode of coil against table, Hz",
    Logarithmic(8e3, 25e3),
    "data sheets of small exciters and of calibration exciters",
);
pub(super) const STRAY_OHM: Drawn = line(
    "coil's field in the reference's channel, V/A",
    Even(-1e-4, 1e-4),
    "20 (m/s2)/T, 0.5 mT/A and 10 mV/(m/s2), as sheets of accelerometers and exciters have them",
);
pub(super) const STRAY_H: Drawn = line(
    "the same by induction, V s/A",
    Even(-2e-8, 2e-8),
    "1 cm2 of loop in 0.2 mT/A",
);
pub(super) const INDUCTANCE_PER_M: Drawn = line(
    "relative change of the blocked inductance with position, 1/m",
    Even(-80.0, 80.0),
    "-1.4 % of S at 1 kHz by 61 um is 48 per m; loudspeakers have 30 to 100",
);
pub(super) const INDUCTANCE_EXPONENT: Drawn = line(
    "exponent of the inductance (eddy currents), 1",
    Even(0.7, 1.0),
    "loudspeaker coils 0.6 to 0.8, coils with a copper ring near 1",
);
pub(super) const FORCE_FACTOR_PER_M: Drawn = line(
    "relative change of Bl with position, 1/m",
    Even(-10.0, 10.0),
    "a coil off the middle of its gap by a tenth of its height",
);
pub(super) const FORCE_FACTOR_PER_M2: Drawn = line(
    "relative fall of Bl with the square of travel, 1/m2",
    Logarithmic(1e3, 2e4),
    "1 mm loses 0.1 to 2 % of Bl: up to what the library of effects has as usual",
);
pub(super) const STIFFNESS_PER_M: Drawn = line(
    "relative change of the stiffness with position, 1/m",
    Even(-80.0, 80.0),
    "the library of effects has 75 as usual",
);
pub(super) const STIFFNESS_PER_M2: Drawn = line(
    "the same with the square of travel, 1/m2",
    Logarithmic(1e3, 2e4),
    "flexures harden by 2 to 50 % at 5 mm",
);
pub(super) const HOLD_ERROR: Drawn = line(
    "weight that the direct current leaves, of the weight",
    Normal(0.02),
    "current by the shunt 0.1 %, Bl by the bare runs 1 %, balance by eye",
);
pub(super) const CREEP_M: Drawn = line(
    "position beside that, at each mounting, m",
    Normal(1e-6),
    "creep of flexures, warmth of the body",
);
pub(super) const KELVIN_PER_W: Drawn = line(
    "rise of the coil, K/W",
    Logarithmic(8.0, 25.0),
    "coils of 20 to 30 mm in a ventilated gap",
);
pub(super) const WARMING_S: Drawn = line(
    "time constant of that, s",
    Logarithmic(15.0, 60.0),
    "5 to 15 g of copper and aluminium",
);
pub(super) const BODY_K_PER_S: Drawn = line(
    "drift of the exciter's body, K/s",
    Normal(1e-3),
    "1 K in a quarter of an hour after unpacking",
);
pub(super) const PAUSE_S: Drawn = line(
    "time to turn or mount the mass, s",
    Logarithmic(20.0, 90.0),
    "a practised hand, a slow one",
);
pub(super) const SWAP_S: Drawn = line(
    "time from shunt to divider, s",
    Logarithmic(5.0, 20.0),
    "one connector, or a switch",
);
pub(super) const THERMOMETER_K: Drawn = line(
    "temperature of the reference over what is read of it, K",
    Normal(0.5),
    "a thermometer on the body; 0.02 %/K of piezoelectric references remains after correction to 1 K",
);
/// Temperature coefficient of the reference, 1/K.
pub(super) const REFERENCE_PER_K: Drawn = line(
    "temperature coefficient of the reference, 1/K",
    Even(-2e-4, 2e-4),
    "sheets of quartz and PZT references after correction",
);

/// Every line.
pub const TABLE: [Drawn; 43] = [
    MASS_ERROR,
    GREASE_KG,
    SHUNT_ERROR,
    SHUNT_INDUCTANCE_H,
    DIVIDER_ERROR,
    DIVIDER_CORNER_HZ,
    RATIO_ERROR,
    RATIO_SCATTER,
    READING_ERROR,
    CROSSTALK,
    INPUT_NOISE_RMS_V,
    FLOOR_RMS_MS2,
    SEAT_N_PER_M,
    SEAT_SCATTER,
    ECCENTRICITY_M,
    ECCENTRICITY_SCATTER_M,
    ANGLE_ERROR_RAD,
    REFERENCE_OFF_AXIS_M,
    ROCKING_INERTIA_KG_M2,
    ROCKING_HZ,
    ROCKING_QUALITY,
    TABLE_SHARE,
    TABLE_HZ,
    STRAY_OHM,
    STRAY_H,
    INDUCTANCE_PER_M,
    INDUCTANCE_EXPONENT,
    FORCE_FACTOR_PER_M,
    FORCE_FACTOR_PER_M2,
    STIFFNESS_PER_M,
    STIFFNESS_PER_M2,
    HOLD_ERROR,
    CREEP_M,
    KELVIN_PER_W,
    WARMING_S,
    BODY_K_PER_S,
    PAUSE_S,
    SWAP_S,
    THERMOMETER_K,
    REFERENCE_PER_K,
    EXCITER,
    CERTIFICATE,
    CERTIFICATE_RAD,
];

const EXCITER: Drawn = line(
    "exciter and its converters: `Rig::draw`, without a device",
    Even(0.0, 0.0),
    "moving mass within 5 %, stiffness 20 %, damping 50 %, Bl, R and L 10 % of the standard rig",
);
pub(super) const CERTIFICATE: Drawn = line(
    "error of the reference's certificate, the same at all frequencies, 1",
    Normal(2.5e-3),
    "U (k = 2) of 0.5 % of the standard rig, as the calibration of one day is",
);

pub(super) const CERTIFICATE_RAD: Drawn = line(
    "error of its phase, the same at all frequencies, rad",
    Normal(4.35e-3),
    "U (k = 2) of 0.5 degrees of the standard rig",
);

impl Drawn {
    /// A value.
    pub fn draw(&self, random: &mut ChaCha12Rng) -> f64 {
        match self.shape {
            Even(lowest, highest) => lowest + (highest - lowest) * random.random::<f64>(),
            Logarithmic(lowest, highest) => {
                lowest * (highest / lowest).powf(random.random::<f64>())
            }
            Normal(deviation) => {
                let unit: f64 = StandardNormal.sample(random);
                unit * deviation
            }
        }
    }
}
