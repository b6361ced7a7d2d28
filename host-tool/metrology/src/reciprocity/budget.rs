//! The budget of a check: rows over frequency, with what they share from one frequency to another and from one
//! check to the next.

use super::equipment::Equipment;
use super::model::{self, At, Identified};
use super::runs::Certified;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{Continuous, ContinuousCDF, Normal};
use std::f64::consts::SQRT_2;

/// Standard acceleration of free fall, m/s2 (ISO 80000-3).
pub(super) const FREE_FALL_MS2: f64 = 9.806_65;
/// Standard uncertainty of the certified phase, rad: 0.25 degrees; of that of shunt and divider less.
const PHASE_STANDARD_RAD: f64 = 4.4e-3;

/// Rows that dominate the budget where the position is not held: the sag is known, and how the exciter changes with
/// position lies between bounds.
const BOUNDED: [&str; 3] = [INDUCTANCE, STIFFNESS, FORCE_FACTOR];
const INDUCTANCE: &str = "inductance and eddy currents by position";
const STIFFNESS: &str = "stiffness by position";
const FORCE_FACTOR: &str = "Bl by position";

/// Extent to which a row is one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Spread {
    /// Its own at each frequency and in each check.
    Independent,
    /// One quantity at all frequencies, another in each check.
    OfTheCheck,
    /// One quantity at all frequencies, the same in every check with this calibrator and this equipment.
    OfTheEquipment,
}

/// A row of the budget.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// The contribution, in words.
    pub what: String,
    /// Extent to which it is one quantity.
    pub spread: Spread,
    /// Even within bounds, sqrt(3) of its standard uncertainty wide to either side; else normal, or small.
    pub bounded: bool,
    /// Standard uncertainty of S1 at each frequency, relative, with the sign one quantity gives it.
    #[serde(rename = "standard_uncertainty_rel")]
    pub standard_rel: Vec<f64>,
}

/// All rows.
pub(super) fn rows(
    points: &[At],
    certified: &[Certified],
    equipment: &Equipment,
    exciter: &Identified,
) -> Vec<Row> {
    use Spread::{Independent, OfTheCheck, OfTheEquipment};
    let known = |at: &At| {
        points
            .iter()
            .position(|one| one.frequency_hz == at.frequency_hz)
    };
    let ratio = |at: &At| known(at).map_or(0.0, |index| certified[index].ratio_standard_rel);
    let mass_kg = equipment.mass_kg;
    let film = equipment.film_kg / 3.0_f64.sqrt() / mass_kg / 2.0 / 3.0_f64.sqrt();
    let seat = |m_per_n: f64| move |at: &At| at.omega().powi(2) * mass_kg * m_per_n / 2.0;
    let [mean, deviation] = equipment.seat_m_per_n;
    let seat_scatter = mean * equipment.seat_scatter_rel / 3.0_f64.sqrt();
    let at_1_khz = |part: f64| move |at: &At| part * (at.frequency_hz / 1000.0).powi(2);
    let position = Position::new(equipment, exciter);
    let sag = if equipment.held {
        OfTheCheck
    } else {
        OfTheEquipment
    };
    let row = |what: &str, spread, standard: &dyn Fn(&At) -> f64| Row {
        what: what.to_owned(),
        spread,
        bounded: BOUNDED.contains(&what) && !equipment.held,
        standard_rel: points.iter().map(standard).collect(),
    };
    vec![
        row("added mass", OfTheEquipment, &|_| {
            equipment.mass_standard_rel / 2.0
        }),
        row("film under the mass", OfTheCheck, &|_| film),
        row("shunt", OfTheEquipment, &|_| {
            equipment.shunt_standard_rel / 2.0
        }),
        row("divider", OfTheEquipment, &|_| {
            equipment.divider_standard_rel / 2.0
        }),
        row("ratio of the channels", OfTheEquipment, &ratio),
        row(
            "ratio of the channels, from day to day",
            OfTheCheck,
            &|_| equipment.ratio_scatter_standard_rel,
        ),
        row("linearity of the converters", OfTheEquipment, &|at| {
            converters_rel(at, equipment)
        }),
        row("crosstalk of the inputs", OfTheEquipment, &|at| {
            crosstalk_rel(at, equipment)
        }),
        row("noise", Independent, &|at| {
            noise_variance(at, Complex64::new(1.0, 0.0)).sqrt() / 2.0
        }),
        row("warming of the coil", OfTheCheck, &|at| {
            equipment.heating_standard_ohm * (1.0 / at.difference()).re / 2.0
        }),
        row(INDUCTANCE, sag, &|at| position.inductance(at, equipment)),
        row(STIFFNESS, sag, &|at| position.stiffness(at, equipment)),
        row(FORCE_FACTOR, sag, &|at| {
            position.force_factor(at, equipment)
        }),
        row("Bl over travel", OfTheEquipment, &|at| {
            travel_rel(at, equipment)
        }),
        row("seat of the mass", OfTheEquipment, &seat(deviation)),
        row(
            "seat of the mass, from mounting to mounting",
            OfTheCheck,
            &seat(seat_scatter),
        ),
        row(
            "rocking",
            OfTheCheck,
            &at_1_khz(equipment.rocking_at_1_khz_rel),
        ),
        row(
            "table between reference and mass",
            OfTheEquipment,
            &at_1_khz(equipment.table_at_1_khz_rel),
        ),
        row("stray field", OfTheEquipment, &|at| {
            stray(at, Complex64::new(equipment.stray_v_per_a, 0.0))
        }),
        row("stray field, by induction", OfTheEquipment, &|at| {
            stray(
                at,
                Complex64::new(0.0, at.omega() * equipment.stray_vs_per_a),
            )
        }),
        row("temperature of the reference", OfTheCheck, &|_| {
            equipment.temperature_standard_rel
        }),
    ]
}

/// The reference's temperature away from that of its certificate: where it was told, one coefficient in every check.
pub(super) fn by_temperature(
    equipment: &Equipment,
    temperature_c: Option<f64>,
    points: usize,
) -> Row {
    let [_, standard_rel] = equipment.by_temperature_rel(temperature_c);
    Row {
        what: "temperature coefficient of the reference".to_owned(),
        spread: match temperature_c {
            Some(_) => Spread::OfTheEquipment,
            None => Spread::OfTheCheck,
        },
        bounded: false,
        standard_rel: vec![standard_rel; points],
    }
}

/// Errors of the four mean ratios as factors on `S1^2`: shunt and divider bare, shunt and divider with the mass.
///
/// # Equation
/// `-e0 - e1 - (Z1 (d1 - e1) - Z0 (d0 - e0)) / (Z1 - Z0)` with relative errors e of a shunt's ratio, d of a
/// divider's.
fn factors(at: &At) -> [Complex64; 4] {
    let one = Complex64::new(1.0, 0.0);
    let difference = at.difference();
    let [bare, loaded] = [at.bare.z / difference, at.loaded.z / difference];
    [-one - bare, bare, -one + loaded, -loaded]
}

/// Variance of a part of `S1^2` by noise, relative; `part` is 1 for the part in phase, j for the other. Noise of
/// a ratio has no phase: both parts are alike.
pub(super) fn noise_variance(at: &At, part: Complex64) -> f64 {
    let parts = factors(at).into_iter().zip(at.noise);
    parts
        .map(|(factor, variance)| (factor * part).norm_sqr() * variance)
        .sum()
}

/// Of a reading by its level: two levels an octave apart have errors of their own, equal ones the same.
///
/// With the same current in both loads the device's errors are the same and cancel in `Z1 - Z0`.
fn converters_rel(at: &At, equipment: &Equipment) -> f64 {
    let factors = factors(at).map(|factor| factor.re);
    let [bare, loaded] = at.levels_rms_ms2;
    let levels = [bare, bare, loaded, loaded];
    let volts: [f64; 4] = std::array::from_fn(|place| at.ratios[place].norm() * levels[place]);
    let shared = |one: f64, other: f64| (1.0 - (one / other).log2().abs()).max(0.0);
    let mut square = 0.0;
    for (one, factor) in factors.into_iter().enumerate() {
        for (other, another) in factors.into_iter().enumerate() {
            let device = shared(volts[one], volts[other]);
            let reference = shared(levels[one], levels[other]);
            square += factor * another * (device + reference);
        }
    }
    equipment.reading_standard_rel * square.max(0.0).sqrt() / 2.0
}

/// Of the other input in each: a ratio q becomes `q + k (1 - q^2)`.
///
/// Above the resonance most of it is in quadrature, like a resistance, and goes with the warmth of the coil.
fn crosstalk_rel(at: &At, equipment: &Equipment) -> f64 {
    let terms = factors(at).into_iter().zip(at.ratios);
    let sum: Complex64 = terms
        .map(|(factor, ratio)| factor * (ratio.inv() - ratio))
        .sum();
    equipment.crosstalk_standard * sum.re / 2.0
}

/// Contribution of the coil's field in the reference's channel, by a voltage over current.
fn stray(at: &At, volt_per_a: Complex64) -> f64 {
    (volt_per_a / at.bare.r + volt_per_a / at.loaded.r).re / 2.0
}

/// Fall of Bl over travel: the force meets it where the travel is largest, the e.m.f. where it is least.
///
/// # Equation
/// Current and travel in phase, as away from the resonance: `1 - 3/4 b x^2` and `1 - 1/4 b x^2`; `S1^2` has the
/// first over the second.
fn travel_rel(at: &At, equipment: &Equipment) -> f64 {
    let travel = |level: f64| SQRT_2 * level / at.omega().powi(2);
    let [bare, loaded] = at.levels_rms_ms2.map(travel);
    let [mean, deviation] = equipment.force_factor_per_m2;
    mean.hypot(deviation) * (bare * bare + loaded * loaded) / 2.0 / 4.0
}

/// Effect of a coil at another position than without the mass.
struct Position {
    standard_m: f64,
    moved: Identified,
}

impl Position {
    fn new(equipment: &Equipment, exciter: &Identified) -> Self {
        let sag_m = equipment.mass_kg * FREE_FALL_MS2 / exciter.stiffness_n_per_m;
        let left_m = match equipment.held {
            true => equipment.hold_standard_rel * sag_m,
            false => sag_m,
        };
        Self {
            // Three mountings, each with its own.
            standard_m: left_m.hypot(equipment.creep_standard_m)
                / if equipment.held { 3.0_f64.sqrt() } else { 1.0 },
            moved: *exciter,
        }
    }

    /// `Zb` less its resistance grows by a part; `Z1 - Z0` by as much of it.
    fn inductance(&self, at: &At, equipment: &Equipment) -> f64 {
        let mechanical = model::mechanical(at, equipment);
        let motional = self.moved.force_factor_n_per_a.powi(2) / mechanical;
        let blocked = Complex64::new(0.0, (at.bare.z - motional).im);
        let changed = blocked * equipment.inductance_per_m * self.standard_m;
        (changed / at.difference()).re / 2.0
    }

    /// `S1^2 jw dm / (jw dm + dk/jw)`.
    fn stiffness(&self, at: &At, equipment: &Equipment) -> f64 {
        let changed = self.moved.stiffness_n_per_m * equipment.stiffness_per_m * self.standard_m;
        changed / (at.omega().powi(2) * equipment.mass_kg) / 2.0
    }

    /// `S1^2 (1 + b + 2 b Zm0/(jw dm))` for a Bl that is larger by b.
    fn force_factor(&self, at: &At, equipment: &Equipment) -> f64 {
        let added = Complex64::new(0.0, at.omega() * equipment.mass_kg);
        let share = 1.0 + 2.0 * (model::mechanical(at, equipment) / added).re;
        equipment.force_factor_per_m * self.standard_m * share / 2.0
    }
}

/// Probability of the intervals of k = 2.
const PROBABILITY: f64 = 0.9545;

/// Expanded uncertainty at each frequency, relative: of the widest bounded row and the rest, taken as normal.
pub(super) fn expanded_rel(rows: &[Row], count: usize) -> Vec<f64> {
    let at = |index: usize| {
        let square = |row: &Row| row.standard_rel[index].powi(2);
        let bounded = rows.iter().filter(|row| row.bounded).map(square);
        let widest = bounded.fold(0.0, f64::max);
        let all: f64 = rows.iter().map(square).sum();
        expanded((all - widest).max(0.0).sqrt(), (3.0 * widest).sqrt())
    };
    (0..count).map(at).collect()
}

/// Half-width of the interval of 95.45 % of the sum of a normal quantity and one that is even within `bound`.
///
/// # Equation
/// `P(|x| <= K) = s/b (G((K + b)/s) - G((K - b)/s)) - 1` with `G(z) = z F(z) + f(z)` of the standard normal law.
fn expanded(standard: f64, bound: f64) -> f64 {
    // Far below the rest it only adds its variance.
    if bound < 0.1 * standard || standard <= 0.0 {
        return 2.0 * standard.hypot(bound / 3.0_f64.sqrt());
    }
    let normal = Normal::standard();
    let integral = |z: f64| z * normal.cdf(z) + normal.pdf(z);
    let probability = |half: f64| {
        let sides = integral((half + bound) / standard) - integral((half - bound) / standard);
        standard / bound * sides - 1.0
    };
    let (mut low, mut high) = (0.0, 3.0 * standard + bound);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        match probability(middle) < PROBABILITY {
            true => low = middle,
            false => high = middle,
        }
    }
    high
}

/// Mean of each row over some frequencies, with its signs; of an independent one its standard uncertainty.
pub(super) fn means(rows: &[Row], indices: &[usize]) -> Vec<f64> {
    let count = indices.len().max(1) as f64;
    let mean = |row: &Row| {
        let values = indices.iter().map(|index| row.standard_rel[*index]);
        match row.spread {
            Spread::Independent => values.map(|value| value * value).sum::<f64>().sqrt() / count,
            _ => values.sum::<f64>() / count,
        }
    };
    rows.iter().map(mean).collect()
}

/// Standard uncertainty of the difference of one frequency from the mean of some it is one of.
pub(super) fn from_mean_standard_rel(
    rows: &[Row],
    means: &[f64],
    indices: &[usize],
    index: usize,
) -> f64 {
    let count = indices.len().max(1) as f64;
    let squares = rows.iter().zip(means).map(|(row, mean)| {
        let own = row.standard_rel[index];
        match row.spread {
            Spread::Independent => own * own * (1.0 - 2.0 / count) + mean * mean,
            _ => (own - mean).powi(2),
        }
    });
    squares.sum::<f64>().sqrt()
}

/// Standard uncertainty of the phase of S1, rad.
pub(super) fn phase_standard_rad(at: &At, equipment: &Equipment) -> f64 {
    let noise = noise_variance(at, Complex64::new(0.0, 1.0)).sqrt() / 2.0;
    let warming = equipment.heating_standard_ohm * (1.0 / at.difference()).im / 2.0;
    let stray = stray(at, Complex64::new(0.0, -equipment.stray_v_per_a));
    noise.hypot(warming).hypot(stray).hypot(PHASE_STANDARD_RAD)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rectangle alone ends at 95.45 % of its bound, a normal quantity alone at two deviations; both together by
    /// a sum over the rectangle.
    #[test]
    fn an_interval_holds_its_probability() {
        assert!((expanded(1e-6, 1.0) - 0.9545).abs() < 1e-4);
        assert!((expanded(1.0, 1e-3) - 2.0).abs() < 1e-5);
        let normal = Normal::standard();
        for (standard, bound) in [(1.0, 0.5), (1.0, 2.0), (0.2, 1.0)] {
            let half = expanded(standard, bound);
            const PIECES: u32 = 2000;
            let inside = (0..PIECES).map(|piece| {
                let at = bound * (2.0 * (f64::from(piece) + 0.5) / f64::from(PIECES) - 1.0);
                normal.cdf((half - at) / standard) - normal.cdf((-half - at) / standard)
            });
            let share = inside.sum::<f64>() / f64::from(PIECES);
            assert!(
                (share - PROBABILITY).abs() < 1e-5,
                "{standard} {bound} {share}"
            );
        }
    }
}
