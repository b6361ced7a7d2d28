// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! SGP4, the near-Earth model a two-line element set is fitted to, written out of IEEE 754
//! arithmetic, the square root and [`crate::chip::earth`]'s angle functions so every host gives the
//! same bits.
//!
//! The equations are Hoots and Roehrich's, Spacetrack Report No. 3 (1980), Section 6, "The SGP4
//! Model", with the constants of its Section 12. Vallado, Crawford, Hujsak and Kelso, "Revisiting
//! Spacetrack Report #3", AIAA 2006-6753 Rev 3, sets what's changed since: the WGS-72 constants
//! with `k_e` from μ (Table 2), the drag terms that divide by the eccentricity dropped below 1e-4
//! (Table 1, satellite 28057), the inclination of 180° held off a division by zero (Section VI.A)
//! and Kepler's equation solved with each Newton step held to 0.95 (Section VI.E). Distances
//! inside are Earth radii and times minutes, as in the report.
//!
//! The semi-major axis comes from Kepler's third law for the recovered mean motion, D4 carries two
//! factors of `a″_0` and `1 − η²` is taken by its magnitude. The report's text leaves each of these
//! open, and the verification set's reference ephemerides settle them, as the tests show.
//!
//! The deep-space part, for a period of 225 minutes or more, isn't here, so such a set is refused.

use std::f64::consts::TAU;

use crate::chip::earth::{atan2, sin_cos};

/// WGS-72's μ in km³/s², its equatorial radius in km and its zonal harmonics, AIAA 2006-6753
/// Table 2.
const MU: f64 = 398_600.8;
pub(crate) const RADIUS: f64 = 6378.135;
const J2: f64 = 0.001_082_616;
const J3: f64 = -0.000_002_538_81;
const J4: f64 = -0.000_001_655_97;
/// `k_2 = J_2 / 2`, `k_4 = −3 J_4 / 8` and `A_3,0 = −J_3`, with `a_E` 1, Spacetrack Report No. 3
/// Section 12.
const K2: f64 = 0.5 * J2;
const K4: f64 = -0.375 * J4;
const A30: f64 = -J3;
/// The density function's `q_0` and `s` as heights in km, Section 12's 120 km and 78 km.
const Q0_KM: f64 = 120.0;
const S_KM: f64 = 78.0;
const MINUTES_PER_DAY: f64 = 1440.0;
const DEEP_SPACE_MINUTES: f64 = 225.0;
const KEPLER_ROUNDS: usize = 10;

/// The mean elements of a two-line element set, in its own units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Elements {
    /// Degrees.
    pub(crate) inclination: f64,
    pub(crate) eccentricity: f64,
    /// The right ascension of the ascending node, degrees.
    pub(crate) node: f64,
    /// The argument of perigee, degrees.
    pub(crate) perigee: f64,
    /// The drag term B*, per Earth radius.
    pub(crate) bstar: f64,
    /// Revolutions a day.
    pub(crate) mean_motion: f64,
    /// Degrees.
    pub(crate) mean_anomaly: f64,
}

/// A position in km and a velocity in km/s, in TEME.
pub(crate) type State = ([f64; 3], [f64; 3]);

/// An element set ready to propagate: its angles in radians, and every constant of Section 6 that
/// doesn't change with time.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sgp4 {
    bstar: f64,
    inclination: f64,
    eccentricity: f64,
    perigee: f64,
    node: f64,
    anomaly: f64,
    /// The recovered mean motion and semi-major axis, `n″_0` and `a″_0`.
    mean_motion: f64,
    semi_major_axis: f64,
    eta: f64,
    c1: f64,
    c3: f64,
    c4: f64,
    c5: f64,
    d2: f64,
    d3: f64,
    d4: f64,
    anomaly_rate: f64,
    perigee_rate: f64,
    node_rate: f64,
    node_drag: f64,
    anomaly_drag: f64,
    /// A perigee under 220 km, where the drag terms are cut short.
    simple: bool,
}

/// `k_e = 60 / √(a_E³ / μ)` in Earth radii to the 1.5 a minute, AIAA 2006-6753 Table 2.
fn ke() -> f64 {
    60.0 / (RADIUS * RADIUS * RADIUS / MU).sqrt()
}

/// `x^(2/3)` for a positive `x`, by Newton's method on the cube root of `x²`, which settles to the
/// last bit well within its rounds for the semi-major axes an orbit has.
fn two_thirds(x: f64) -> f64 {
    const ROUNDS: usize = 60;
    let square = x * x;
    let mut root = 1.0 + (square - 1.0) / 3.0;
    for _ in 0..ROUNDS {
        root -= (root * root * root - square) / (3.0 * root * root);
    }
    root
}

fn radians(degrees: f64) -> f64 {
    degrees * (std::f64::consts::PI / 180.0)
}

impl Sgp4 {
    /// Recovers the original mean motion and semi-major axis and works out the model's constants,
    /// Section 6 in its order. `None` for a set SGP4 can't carry: a mean motion that isn't
    /// positive, an eccentricity outside `[0, 1)`, or a period of 225 minutes or more.
    #[expect(
        clippy::too_many_lines,
        reason = "one line to an equation of the report, in its order"
    )]
    pub(crate) fn new(elements: &Elements) -> Option<Self> {
        let n0 = elements.mean_motion * TAU / MINUTES_PER_DAY;
        let e0 = elements.eccentricity;
        let i0 = radians(elements.inclination);
        let omega0 = radians(elements.perigee);
        let usable = n0 > 0.0 && (0.0..1.0).contains(&e0) && elements.bstar.is_finite();
        if !usable {
            return None;
        }
        let (sin_i0, theta) = sin_cos(i0);
        let theta2 = theta * theta;
        let beta0_2 = 1.0 - e0 * e0;
        let beta0 = beta0_2.sqrt();
        let a1 = two_thirds(ke() / n0);
        let shape = 1.5 * K2 * (3.0 * theta2 - 1.0) / (beta0_2 * beta0);
        let delta1 = shape / (a1 * a1);
        let a0 =
            a1 * (1.0 - delta1 / 3.0 - delta1 * delta1 - 134.0 / 81.0 * delta1 * delta1 * delta1);
        let delta0 = shape / (a0 * a0);
        let mean_motion = n0 / (1.0 + delta0);
        let a = two_thirds(ke() / mean_motion);
        // Written so a mean motion too small to carry, which leaves `a` not a number, fails it too.
        if !(TAU / mean_motion < DEEP_SPACE_MINUTES && a.is_finite()) {
            return None;
        }

        let perigee_km = (a * (1.0 - e0) - 1.0) * RADIUS;
        let q0 = 1.0 + Q0_KM / RADIUS;
        let s = if perigee_km >= 156.0 {
            1.0 + S_KM / RADIUS
        } else if perigee_km >= 98.0 {
            a * (1.0 - e0) - S_KM / RADIUS
        } else {
            1.0 + 20.0 / RADIUS
        };
        let q0s = q0 - s;
        let q0s4 = q0s * q0s * q0s * q0s;
        let xi = 1.0 / (a - s);
        let xi2 = xi * xi;
        let xi4 = xi2 * xi2;
        let eta = a * e0 * xi;
        let eta2 = eta * eta;
        let eta3 = eta2 * eta;
        let psi2 = (1.0 - eta2).abs();
        let psi7 = 1.0 / (psi2 * psi2 * psi2 * psi2.sqrt());
        let c2 = q0s4
            * xi4
            * mean_motion
            * psi7
            * (a * (1.0 + 1.5 * eta2 + 4.0 * e0 * eta + e0 * eta3)
                + 1.5 * K2 * xi / psi2
                    * (-0.5 + 1.5 * theta2)
                    * (8.0 + 24.0 * eta2 + 3.0 * eta2 * eta2));
        let c1 = elements.bstar * c2;
        let small = e0 <= 1.0e-4;
        let c3 = if small {
            0.0
        } else {
            q0s4 * xi4 * xi * A30 * mean_motion * sin_i0 / (K2 * e0)
        };
        let (_, cos_2omega0) = sin_cos(2.0 * omega0);
        let c4 = 2.0
            * mean_motion
            * q0s4
            * xi4
            * a
            * beta0_2
            * psi7
            * ((2.0 * eta * (1.0 + e0 * eta) + 0.5 * e0 + 0.5 * eta3)
                - 2.0 * K2 * xi / (a * psi2)
                    * (3.0
                        * (1.0 - 3.0 * theta2)
                        * (1.0 + 1.5 * eta2 - 2.0 * e0 * eta - 0.5 * e0 * eta3)
                        + 0.75
                            * (1.0 - theta2)
                            * (2.0 * eta2 - e0 * eta - e0 * eta3)
                            * cos_2omega0));
        let c5 =
            2.0 * q0s4 * xi4 * a * beta0_2 * psi7 * (1.0 + 2.75 * eta * (eta + e0) + e0 * eta3);
        let d2 = 4.0 * a * xi * c1 * c1;
        let d3 = 4.0 / 3.0 * a * xi2 * (17.0 * a + s) * c1 * c1 * c1;
        let d4 = 2.0 / 3.0 * a * a * xi2 * xi * (221.0 * a + 31.0 * s) * c1 * c1 * c1 * c1;

        let a2 = a * a;
        let a4 = a2 * a2;
        let beta0_3 = beta0_2 * beta0;
        let beta0_4 = beta0_2 * beta0_2;
        let beta0_7 = beta0_4 * beta0_3;
        let beta0_8 = beta0_4 * beta0_4;
        let theta4 = theta2 * theta2;
        let anomaly_rate = (1.0
            + 3.0 * K2 * (-1.0 + 3.0 * theta2) / (2.0 * a2 * beta0_3)
            + 3.0 * K2 * K2 * (13.0 - 78.0 * theta2 + 137.0 * theta4) / (16.0 * a4 * beta0_7))
            * mean_motion;
        let perigee_rate = (-3.0 * K2 * (1.0 - 5.0 * theta2) / (2.0 * a2 * beta0_4)
            + 3.0 * K2 * K2 * (7.0 - 114.0 * theta2 + 395.0 * theta4) / (16.0 * a4 * beta0_8)
            + 5.0 * K4 * (3.0 - 36.0 * theta2 + 49.0 * theta4) / (4.0 * a4 * beta0_8))
            * mean_motion;
        let node_rate = (-3.0 * K2 * theta / (a2 * beta0_4)
            + 3.0 * K2 * K2 * (4.0 * theta - 19.0 * theta2 * theta) / (2.0 * a4 * beta0_8)
            + 5.0 * K4 * theta * (3.0 - 7.0 * theta2) / (2.0 * a4 * beta0_8))
            * mean_motion;
        Some(Self {
            bstar: elements.bstar,
            inclination: i0,
            eccentricity: e0,
            perigee: omega0,
            node: radians(elements.node),
            anomaly: radians(elements.mean_anomaly),
            mean_motion,
            semi_major_axis: a,
            eta,
            c1,
            c3,
            c4,
            c5,
            d2,
            d3,
            d4,
            anomaly_rate,
            perigee_rate,
            node_rate,
            node_drag: -10.5 * mean_motion * K2 * theta / (a2 * beta0_2) * c1,
            anomaly_drag: if small {
                0.0
            } else {
                -2.0 / 3.0 * q0s4 * elements.bstar * xi4 / (e0 * eta)
            },
            simple: perigee_km < 220.0,
        })
    }

    /// The state `minutes` after the epoch, Section 6 in its order. `None` once drag takes the
    /// orbit under the surface or its eccentricity out of range.
    #[expect(clippy::many_single_char_names, reason = "the report's symbols")]
    pub(crate) fn propagate(&self, minutes: f64) -> Option<State> {
        let t = minutes;
        let t2 = t * t;
        let e0 = self.eccentricity;
        let (sin_i0, theta) = sin_cos(self.inclination);
        let theta2 = theta * theta;

        let anomaly_df = self.anomaly + self.anomaly_rate * t;
        let perigee_df = self.perigee + self.perigee_rate * t;
        let node = self.node + self.node_rate * t + self.node_drag * t2;
        let (mut mp, mut omega) = (anomaly_df, perigee_df);
        let mut e = e0 - self.bstar * self.c4 * t;
        let mut tempa = 1.0 - self.c1 * t;
        let mut tail = 1.5 * self.c1 * t2;
        if !self.simple {
            let (_, cos_perigee) = sin_cos(self.perigee);
            let delta_omega = self.bstar * self.c3 * cos_perigee * t;
            let cube = |m: f64| {
                let x = 1.0 + self.eta * sin_cos(m).1;
                x * x * x
            };
            let delta_m = self.anomaly_drag * (cube(anomaly_df) - cube(self.anomaly));
            mp = anomaly_df + delta_omega + delta_m;
            omega = perigee_df - delta_omega - delta_m;
            e -= self.bstar * self.c5 * (sin_cos(mp).0 - sin_cos(self.anomaly).0);
            let t3 = t2 * t;
            let t4 = t3 * t;
            let (c1, d2, d3, d4) = (self.c1, self.d2, self.d3, self.d4);
            tempa -= d2 * t2 + d3 * t3 + d4 * t4;
            tail += (d2 + 2.0 * c1 * c1) * t3
                + 0.25 * (3.0 * d3 + 12.0 * c1 * d2 + 10.0 * c1 * c1 * c1) * t4
                + 0.2
                    * (3.0 * d4
                        + 12.0 * c1 * d3
                        + 6.0 * d2 * d2
                        + 30.0 * c1 * c1 * d2
                        + 15.0 * c1 * c1 * c1 * c1)
                    * t4
                    * t;
        }
        // Drag can carry a near-circular orbit's eccentricity a hair under zero, which the
        // verification set's 28350 holds at 1e-6.
        if e >= 1.0 || e < -0.001 || tempa <= 0.0 {
            return None;
        }
        let e = e.max(1e-6);
        let a = self.semi_major_axis * tempa * tempa;
        let longitude = mp + omega + node + self.mean_motion * tail;
        let beta2 = 1.0 - e * e;
        let n = ke() / (a * a.sqrt());

        let (sin_omega, cos_omega) = sin_cos(omega);
        let axn = e * cos_omega;
        let common = A30 * sin_i0 / (K2 * a * beta2);
        let longitude_t =
            longitude + common / 8.0 * axn * (3.0 + 5.0 * theta) / (1.0 + theta).max(1e-12);
        let ayn = e * sin_omega + common / 4.0;

        let u = (longitude_t - node).rem_euclid(TAU);
        let mut ew = u;
        for _ in 0..KEPLER_ROUNDS {
            let (sin_ew, cos_ew) = sin_cos(ew);
            let step = ((u - ayn * cos_ew + axn * sin_ew - ew)
                / (1.0 - ayn * sin_ew - axn * cos_ew))
                .clamp(-0.95, 0.95);
            ew += step;
            if step.abs() < 1e-12 {
                break;
            }
        }
        let (sin_ew, cos_ew) = sin_cos(ew);

        let ecos_e = axn * cos_ew + ayn * sin_ew;
        let esin_e = axn * sin_ew - ayn * cos_ew;
        let el2 = axn * axn + ayn * ayn;
        let pl = a * (1.0 - el2);
        if pl < 0.0 {
            return None;
        }
        let r = a * (1.0 - ecos_e);
        let rdot = ke() * a.sqrt() / r * esin_e;
        let rfdot = ke() * pl.sqrt() / r;
        let root = (1.0 - el2).sqrt();
        let cos_u = a / r * (cos_ew - axn + ayn * esin_e / (1.0 + root));
        let sin_u = a / r * (sin_ew - ayn - axn * esin_e / (1.0 + root));
        let u = atan2(sin_u, cos_u);
        let (sin_2u, cos_2u) = sin_cos(2.0 * u);
        let k2_pl = K2 / pl;
        let k2_pl2 = k2_pl / pl;
        let rk = r * (1.0 - 1.5 * k2_pl2 * root * (3.0 * theta2 - 1.0))
            + 0.5 * k2_pl * (1.0 - theta2) * cos_2u;
        let uk = u - 0.25 * k2_pl2 * (7.0 * theta2 - 1.0) * sin_2u;
        let nodek = node + 1.5 * k2_pl2 * theta * sin_2u;
        let ik = self.inclination + 1.5 * k2_pl2 * theta * sin_i0 * cos_2u;
        let rdotk = rdot - n * k2_pl * (1.0 - theta2) * sin_2u;
        let rfdotk = rfdot + n * k2_pl * ((1.0 - theta2) * cos_2u - 1.5 * (1.0 - 3.0 * theta2));
        if rk < 1.0 {
            return None;
        }

        let (sin_uk, cos_uk) = sin_cos(uk);
        let (sin_ik, cos_ik) = sin_cos(ik);
        let (sin_nodek, cos_nodek) = sin_cos(nodek);
        let m = [-sin_nodek * cos_ik, cos_nodek * cos_ik, sin_ik];
        let nv = [cos_nodek, sin_nodek, 0.0];
        let unit_u: [f64; 3] = std::array::from_fn(|k| m[k] * sin_uk + nv[k] * cos_uk);
        let unit_v: [f64; 3] = std::array::from_fn(|k| m[k] * cos_uk - nv[k] * sin_uk);
        let speed = RADIUS / 60.0;
        Some((
            unit_u.map(|part| rk * part * RADIUS),
            std::array::from_fn(|k| (rdotk * unit_u[k] + rfdotk * unit_v[k]) * speed),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A set of the verification file `SGP4-VER.TLE` that comes with AIAA 2006-6753, and points of
    /// its C++ reference ephemeris: seconds after the epoch, then the position in km and the
    /// velocity in km/s.
    struct Case {
        elements: Elements,
        points: &'static [(f64, [f64; 6])],
    }

    const CASES: [Case; 4] = [
        // 00005: eccentric, light drag.
        Case {
            elements: Elements {
                inclination: 34.2682,
                eccentricity: 0.185_966_7,
                node: 348.7242,
                perigee: 331.7664,
                bstar: 0.280_98e-4,
                mean_motion: 10.824_191_57,
                mean_anomaly: 19.3264,
            },
            points: &[
                (
                    0.0,
                    [
                        7_022.465_292_66,
                        -1_400.082_967_55,
                        0.039_951_55,
                        1.893_841_015,
                        6.405_893_759,
                        4.534_807_250,
                    ],
                ),
                (
                    86_400.0,
                    [
                        -938.559_239_43,
                        -6_268.187_488_31,
                        -4_294.029_247_51,
                        7.536_105_209,
                        -0.427_127_707,
                        0.989_878_080,
                    ],
                ),
                (
                    259_200.0,
                    [
                        -9_060.473_735_69,
                        4_658.709_525_02,
                        813.686_731_53,
                        -2.232_832_783,
                        -4.110_453_490,
                        -3.157_345_433,
                    ],
                ),
            ],
        },
        // 06251: a low orbit under real drag.
        Case {
            elements: Elements {
                inclination: 58.0579,
                eccentricity: 0.003_003_5,
                node: 54.0425,
                perigee: 139.1568,
                bstar: 0.128_08e-3,
                mean_motion: 15.563_872_91,
                mean_anomaly: 221.1854,
            },
            points: &[
                (
                    0.0,
                    [
                        3_988.310_226_99,
                        5_498.966_572_35,
                        0.900_558_79,
                        -3.290_032_738,
                        2.357_652_820,
                        6.496_623_475,
                    ],
                ),
                (
                    86_400.0,
                    [
                        -2_777.146_823_35,
                        -5_663.160_317_08,
                        -2_462.548_891_23,
                        4.915_493_146,
                        0.123_328_992,
                        -5.896_495_091,
                    ],
                ),
                (
                    172_800.0,
                    [
                        1_159.278_028_97,
                        5_056.601_754_95,
                        4_353.494_185_79,
                        -5.968_060_341,
                        -2.314_790_406,
                        4.230_722_669,
                    ],
                ),
            ],
        },
        // 28057: an eccentricity under 1e-4, where the drag terms that divide by it drop out.
        Case {
            elements: Elements {
                inclination: 98.4283,
                eccentricity: 0.000_088_4,
                node: 247.6961,
                perigee: 88.1964,
                bstar: 0.359_40e-4,
                mean_motion: 14.354_780_80,
                mean_anomaly: 271.9322,
            },
            points: &[
                (
                    0.0,
                    [
                        -2_715.282_374_86,
                        -6_619.264_368_89,
                        -0.013_414_43,
                        -1.008_587_273,
                        0.422_782_003,
                        7.385_272_942,
                    ],
                ),
                (
                    86_400.0,
                    [
                        688.160_565_94,
                        4_124.876_189_64,
                        5_794.559_944_49,
                        2.810_973_665,
                        5.479_585_563,
                        -4.224_866_316,
                    ],
                ),
                (
                    172_800.0,
                    [
                        1_788.423_345_80,
                        1_990.505_309_57,
                        -6_640.593_377_25,
                        -2.074_169_091,
                        -6.683_381_288,
                        -2.562_777_776,
                    ],
                ),
            ],
        },
        // 22312: a perigee under 220 km, where the drag terms are cut short.
        Case {
            elements: Elements {
                inclination: 62.1486,
                eccentricity: 0.030_872_3,
                node: 77.4698,
                perigee: 267.9229,
                bstar: 0.499_49e-3,
                mean_motion: 15.957_445_31,
                mean_anomaly: 88.7392,
            },
            points: &[
                (
                    0.0,
                    [
                        1_442.101_329_12,
                        6_510.236_254_49,
                        8.831_458_85,
                        -3.475_714_837,
                        0.997_262_768,
                        6.835_860_345,
                    ],
                ),
                (
                    3_252.172_032,
                    [
                        306.104_784_53,
                        -5_816.456_555_25,
                        -2_979.558_460_68,
                        3.950_663_855,
                        3.415_332_543,
                        -5.879_974_329,
                    ],
                ),
                (
                    28_452.172_032,
                    [
                        -3_181.546_980_42,
                        -3_831.299_765_06,
                        4_096.802_427_87,
                        1.114_159_970,
                        -6.104_773_578,
                        -4.829_967_400,
                    ],
                ),
            ],
        },
    ];

    /// The verification set's reference ephemerides print a hundredth of a millimeter and a
    /// billionth of a km/s, so each point is held to a few of those.
    #[test]
    fn near_earth_sets_match_the_reference_ephemerides() {
        for case in &CASES {
            let model = Sgp4::new(&case.elements).expect("a near-Earth set");
            for (seconds, want) in case.points {
                let (position, velocity) = model.propagate(seconds / 60.0).expect("propagates");
                let off = |got: [f64; 3], want: &[f64]| {
                    (0..3)
                        .map(|k| (got[k] - want[k]) * (got[k] - want[k]))
                        .sum::<f64>()
                        .sqrt()
                };
                let (far, fast) = (off(position, &want[..3]), off(velocity, &want[3..]));
                assert!(
                    far < 1e-7,
                    "{:?} at {seconds} s: {far} km off",
                    case.elements
                );
                assert!(
                    fast < 1e-8,
                    "{:?} at {seconds} s: {fast} km/s off",
                    case.elements
                );
            }
        }
    }

    #[test]
    fn a_deep_space_set_and_a_bad_eccentricity_are_refused() {
        let mut elements = CASES[0].elements;
        elements.mean_motion = 2.0;
        assert_eq!(Sgp4::new(&elements), None);
        let mut elements = CASES[0].elements;
        elements.eccentricity = 1.0;
        assert_eq!(Sgp4::new(&elements), None);
        elements = CASES[0].elements;
        elements.mean_motion = 1e-300;
        assert_eq!(Sgp4::new(&elements), None);
    }

    #[test]
    #[expect(
        clippy::disallowed_methods,
        reason = "the platform's cube root is the oracle of a test, which nothing in a run computes"
    )]
    fn two_thirds_matches_the_platforms_cube_root() {
        for x in [0.3_f64, 0.9, 1.0, 1.13, 2.7, 9.0] {
            let want = (x * x).cbrt();
            assert!(
                (two_thirds(x) - want).abs() <= 4.0 * f64::EPSILON * want,
                "{x}"
            );
        }
    }
}
