//! A calibrator on a site: rig, list and what is wrong with it, from the sizes by seed.

use super::sizes::{Sizes, unit};
use crate::rigged::point;
use calib_core::point::{PointResult, PointSpec};
use calib_core::preferred::PREFERRED_HZ;
use calib_twin::Complex;
use calib_twin::effects::ActiveEffect;
use calib_twin::effects::fault::{ActiveFault, FaultEffect};
use calib_twin::influence::InfluenceDraw;
use calib_twin::oracle::{self, CalibrationPoint, ONE_THIRD_OCTAVES_HZ};
use calib_twin::rig::Rig;
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use std::collections::BTreeMap;
use std::f64::consts::{SQRT_2, TAU};

/// Bands of the tables, Hz: one point of each draw lies in each.
pub const BANDS_HZ: [[f64; 2]; 5] = [
    [20.0, 75.0],
    [75.0, 300.0],
    [300.0, 1150.0],
    [1150.0, 3600.0],
    [3600.0, 10_000.5],
];

/// A rig on a site, and the truth about it.
pub struct Draw {
    /// Rig the plant simulates.
    pub rig: Rig,
    /// Certified values of the reference.
    pub certificate: Vec<CalibrationPoint>,
    /// One point in each band, the level the same as far as the exciter's travel goes.
    pub points: Vec<PointSpec>,
    /// Temperature of the transducers, degrees Celsius: what the operator reads off and tells.
    pub temperature_c: f64,
    /// Mounted resonance by the data sheet of the device, Hz: a typical value of its type.
    pub data_sheet_hz: f64,
    /// Largest transverse motion of the exciter to 1 kHz and above, relative, as its maker would state it.
    pub transverse_motion_rel: [f64; 2],
    /// Standard uncertainty of what every draw has beside the reference's certificate, relative.
    common_rel: f64,
    /// The device and its conditioner alone.
    undisturbed: Rig,
}

/// How far a device's mounted resonance is from that of its type: makers give a typical value or a lower limit, and
/// pieces of a type differ by some percent.
const DATA_SHEET_REL: f64 = 0.1;

/// Transverse motion of an exciter that has none drawn, to 1 kHz and above: nobody states less.
const TRANSVERSE_MOTION_REL: [f64; 2] = [0.05, 0.10];
/// Transverse sensitivity that the sizes of transverse motion are products with.
const TRANSVERSE_SENSITIVITY_REL: f64 = 0.035;
/// Magnification at 1 kHz of the lowest rocking mode of the sizes, at 1.2 kHz.
const ROCKING_AT_1_KHZ: f64 = 3.3;

impl Draw {
    /// Draws a rig with `effects`, by seed: the same seed has the same rig, list and conditions
    /// whatever the effects are.
    ///
    /// # Errors
    /// An effect the library does not have, or a size it does not accept.
    pub fn new(sizes: &Sizes, effects: &[&str], seed: u64) -> Result<Self, crate::rigged::Fault> {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        let mut undisturbed = Rig::draw(seed);
        undisturbed.converter.errors = 1.0;
        let mut drawn = InfluenceDraw::new(&undisturbed, &ONE_THIRD_OCTAVES_HZ, &[], seed);
        let rig = &mut drawn.rig;
        let mut condition = |name| sizes.condition(name, &mut random);
        rig.reference.sensitivity_v_per_ms2 *= 1.0 + condition("reference_gain");
        rig.dut.conditioner_gain *= 1.0 + condition("chain_gain");
        rig.surroundings.mains_hz = condition("mains_nominal_hz") + condition("mains_hz");
        let level_ms2 = condition("level_ms2");
        let travel_m = condition("travel_m");
        let any_frequency = condition("any_frequency") > 0.5;
        let points = BANDS_HZ.map(|band| {
            let frequency_hz = in_band(band, any_frequency, &mut random);
            let highest_ms2 = travel_m * (TAU * f64::from(frequency_hz)).powi(2) / SQRT_2;
            point(frequency_hz, level_ms2.min(highest_ms2) as f32)
        });
        let mut of_effects = ChaCha12Rng::seed_from_u64(!seed);
        for effect in effects {
            add(rig, sizes, effect, &mut of_effects)?;
        }
        // Of a generator of its own: what was drawn before there was a data sheet stays.
        let off = 2.0 * unit(&mut ChaCha12Rng::seed_from_u64(seed ^ 0xDA7A_5EE7)) - 1.0;
        Ok(Self {
            data_sheet_hz: undisturbed.dut.resonance_hz * (1.0 + DATA_SHEET_REL * off),
            common_rel: common_rel(sizes, rig.surroundings.warmer_k),
            temperature_c: 23.0 + rig.surroundings.warmer_k,
            transverse_motion_rel: transverse_motion_rel(rig),
            rig: drawn.rig,
            certificate: drawn.certificate,
            points: points.to_vec(),
            undisturbed,
        })
    }

    /// Standard uncertainty of the magnitude by what every draw has and by what the result shows, relative.
    pub fn known_rel(&self, result: &PointResult, frequency_hz: f64) -> f64 {
        let nearest = |a: &&CalibrationPoint, b: &&CalibrationPoint| {
            let far = |row: &CalibrationPoint| (row.frequency_hz / frequency_hz).ln().abs();
            far(a).total_cmp(&far(b))
        };
        let row = self.certificate.iter().min_by(nearest);
        let of_reference = row.map_or(0.0, |row| row.expanded_uncertainty_rel / 2.0);
        let seen = f64::from(result.repeatability_rel).hypot(f64::from(result.hum_rel) / SQRT_2);
        of_reference.hypot(self.common_rel).hypot(seen)
    }

    /// The true sensitivity of the device under test with its conditioner, V/(m/s2).
    pub fn truth(&self, frequency_hz: f64) -> Complex<f64> {
        oracle::dut_sensitivity(&self.undisturbed, frequency_hz)
    }
}

/// Standard uncertainty of what is in every draw, and of what a told temperature may do to either transducer, relative.
fn common_rel(sizes: &Sizes, warmer_k: f64) -> f64 {
    let of_kelvin = ["reference_temperature", "dut_temperature"];
    let warmer = of_kelvin.map(|effect| warmer_k * sizes.deviation_of(effect, "alpha_per_k"));
    let gains = ["reference_gain", "chain_gain"].map(|name| sizes.deviation(name));
    let all = warmer.iter().chain(&gains);
    all.map(|u| u * u).sum::<f64>().sqrt()
}

/// Transverse motion as the maker of a rig's exciter would state it.
fn transverse_motion_rel(rig: &Rig) -> [f64; 2] {
    let mut effects = rig.effects.iter();
    let Some(across) = effects.find(|e| e.effect().entry.id == "transverse_motion") else {
        return TRANSVERSE_MOTION_REL;
    };
    let named = across.effect().entry.parameters.iter().map(|p| p.name);
    let values: BTreeMap<_, _> = named.zip(across.values()).collect();
    std::array::from_fn(|range| {
        let magnification = [ROCKING_AT_1_KHZ, *values["quality"]][range];
        let product = values["t0"].abs() + magnification * values["t1"].abs();
        TRANSVERSE_MOTION_REL[range].max(product / TRANSVERSE_SENSITIVITY_REL)
    })
}

/// A preferred frequency of the band, or any.
fn in_band([from, to]: [f64; 2], any: bool, random: &mut ChaCha12Rng) -> f32 {
    let share = unit(random);
    if any {
        return (from * (to / from).powf(share)).min(10_000.0) as f32;
    }
    let within = |hz: &f32| (from..to).contains(&f64::from(*hz));
    let preferred: Vec<f32> = PREFERRED_HZ.into_iter().filter(within).collect();
    preferred[(share * preferred.len() as f64) as usize]
}

/// Puts an effect or a fault of a drawn size on the rig.
fn add(
    rig: &mut Rig,
    sizes: &Sizes,
    name: &str,
    random: &mut ChaCha12Rng,
) -> Result<(), crate::rigged::Fault> {
    let mut parameters = Vec::new();
    for size in sizes.size.iter().filter(|size| size.effect == name) {
        let value = size.law.draw(random);
        if size.parameter == "warmer_k" {
            rig.surroundings.warmer_k = value;
        } else {
            parameters.push(format!("{}:{value}", size.parameter));
        }
    }
    let text = format!("{name}={}", parameters.join(","));
    if FaultEffect::named(name).is_some() {
        rig.faults.push(text.parse::<ActiveFault>()?);
    } else {
        rig.effects.push(text.parse::<ActiveEffect>()?);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_can_be_drawn_and_draws_repeat() {
        let sizes = Sizes::read().expect("reads");
        for name in sizes.effects() {
            for seed in 1..20 {
                let draw = Draw::new(&sizes, &[name], seed).expect("draws");
                let again = Draw::new(&sizes, &[name], seed).expect("draws");
                assert_eq!(draw.rig, again.rig, "{name}");
                let text = draw.rig.to_toml().expect("plain numbers");
                assert_eq!(Rig::parse(&text, "draw").expect("valid"), draw.rig);
                for (spec, [from, to]) in draw.points.iter().zip(BANDS_HZ) {
                    assert!((from..to).contains(&f64::from(spec.frequency_hz)));
                }
            }
        }
    }
}
