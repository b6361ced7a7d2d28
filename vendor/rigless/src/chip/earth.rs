// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Where a spacecraft's chips are on the Earth and when: the WGS-84 ellipsoid, GPS time and the
//! calendar, the sidereal angle that turns the Earth's frame into an inertial one, and the angle
//! functions they need, written out of IEEE 754 arithmetic and the square root alone so every host
//! gives the same bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use crate::time::NANOS_PER_SECOND;

/// The WGS-84 ellipsoid's semi-major axis in meters and its flattening, NIMA TR8350.2 table 3.1.
const SEMI_MAJOR_AXIS: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
/// The Earth's rate of turn in radians a second, NIMA TR8350.2 table 3.1.
pub(crate) const EARTH_RATE: f64 = 7.292_115e-5;
/// GPS time runs ahead of UTC by 18 seconds since 2017-01-01, IERS Bulletin C 52.
// ceiling: one leap second count for every instant; upgrade when a run spans a leap second
pub(crate) const LEAP_SECONDS: u64 = 18;
/// The GPS epoch, 1980-01-06T00:00:00Z, in seconds after 1970-01-01T00:00:00Z.
const GPS_EPOCH_UNIX: u64 = 315_964_800;
pub(crate) const SECONDS_PER_WEEK: u64 = 7 * SECONDS_PER_DAY;
pub(crate) const SECONDS_PER_DAY: u64 = 86_400;
/// The Julian date of 1970-01-01T00:00:00Z, and of J2000.0, and days in a Julian century.
const UNIX_JULIAN_DATE: f64 = 2_440_587.5;
const J2000: f64 = 2_451_545.0;
const DAYS_PER_CENTURY: f64 = 36_525.0;
/// Halvings of an argument before the arctangent's series, which leave it under 0.1.
const HALVINGS: i32 = 4;
/// Terms of each series, past which a term is below an f64's last bit.
const ARCTANGENT_TERMS: u32 = 10;
const SINE_TERMS: u32 = 10;

/// The arctangent of `x`, in radians.
pub(crate) fn atan(x: f64) -> f64 {
    if x.abs() > 1.0 {
        return FRAC_PI_2.copysign(x) - atan(1.0 / x);
    }
    // atan(x) = 2 atan(x / (1 + sqrt(1 + x²))), so four halvings take |x| ≤ 1 under tan(π/64).
    let mut reduced = x;
    for _ in 0..HALVINGS {
        reduced /= 1.0 + (1.0 + reduced * reduced).sqrt();
    }
    let square = reduced * reduced;
    let (mut term, mut sum) = (reduced, 0.0);
    for n in 0..ARCTANGENT_TERMS {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        sum += sign * term / f64::from(2 * n + 1);
        term *= square;
    }
    sum * f64::from(1 << HALVINGS)
}

/// The angle of `(x, y)` from the `x` axis, in radians from −π to π.
pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    if x > 0.0 {
        atan(y / x)
    } else if x < 0.0 {
        atan(y / x) + PI.copysign(y)
    } else if y == 0.0 {
        0.0
    } else {
        FRAC_PI_2.copysign(y)
    }
}

/// The sine and cosine of `angle`, in radians.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    let mut reduced = angle.rem_euclid(TAU);
    let mut quadrant = 0;
    while reduced > FRAC_PI_4 {
        reduced -= FRAC_PI_2;
        quadrant += 1;
    }
    let square = reduced * reduced;
    let (mut sine, mut cosine) = (0.0, 0.0);
    let (mut odd, mut even) = (reduced, 1.0);
    for n in 0..SINE_TERMS {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        sine += sign * odd;
        cosine += sign * even;
        let next = f64::from(2 * n + 2);
        even *= square / (next * (next - 1.0));
        odd *= square / (next * (next + 1.0));
    }
    match quadrant % 4 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// A place on the WGS-84 ellipsoid, and the sines and cosines of its angles that turn the Earth's
/// frame into its own east, north and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Geodetic {
    /// North of the equator, in radians.
    pub(crate) latitude: f64,
    /// East of the prime meridian, in radians.
    pub(crate) longitude: f64,
    /// Above the ellipsoid, in meters.
    pub(crate) height: f64,
    sin_latitude: f64,
    cos_latitude: f64,
    sin_longitude: f64,
    cos_longitude: f64,
}

impl Geodetic {
    /// The place at `ecef`, meters in the Earth's frame, by fixed-point iteration on the tangent of
    /// the latitude, which settles to well under a millimeter in six rounds anywhere above the
    /// Earth's crust.
    pub(crate) fn from_ecef([x, y, z]: [f64; 3]) -> Self {
        const ROUNDS: usize = 6;
        let eccentricity = FLATTENING * (2.0 - FLATTENING);
        let across = (x * x + y * y).sqrt();
        let (sin_longitude, cos_longitude) = if across == 0.0 {
            (0.0, 1.0)
        } else {
            (y / across, x / across)
        };
        let radius = |sine: f64| SEMI_MAJOR_AXIS / (1.0 - eccentricity * sine * sine).sqrt();
        let (sin_latitude, cos_latitude) = if across == 0.0 {
            (1.0_f64.copysign(z), 0.0)
        } else {
            let mut tangent = z / (across * (1.0 - eccentricity));
            for _ in 0..ROUNDS {
                let sine = tangent / (1.0 + tangent * tangent).sqrt();
                tangent = (z + eccentricity * radius(sine) * sine) / across;
            }
            let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
            (tangent * cosine, cosine)
        };
        let normal = radius(sin_latitude);
        Self {
            latitude: atan2(sin_latitude, cos_latitude),
            longitude: atan2(sin_longitude, cos_longitude),
            height: across * cos_latitude + z * sin_latitude
                - SEMI_MAJOR_AXIS * SEMI_MAJOR_AXIS / normal,
            sin_latitude,
            cos_latitude,
            sin_longitude,
            cos_longitude,
        }
    }

    /// `vector` in the Earth's frame as east, north and up here.
    pub(crate) fn east_north_up(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let east = -self.sin_longitude * x + self.cos_longitude * y;
        let outward = self.cos_longitude * x + self.sin_longitude * y;
        [
            east,
            -self.sin_latitude * outward + self.cos_latitude * z,
            self.cos_latitude * outward + self.sin_latitude * z,
        ]
    }
}

/// An instant of GPS time, in nanoseconds since the GPS epoch.
#[derive(
    Debug,
    Clone,
    Copy,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    serde::Serialize,
    serde::Deserialize,
)]
pub(crate) struct GpsTime(pub(crate) u64);

/// A UTC instant as a calendar reads it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Utc {
    pub(crate) year: u64,
    pub(crate) month: u64,
    pub(crate) day: u64,
    pub(crate) hour: u64,
    pub(crate) minute: u64,
    pub(crate) second: u64,
    pub(crate) millisecond: u64,
}

impl GpsTime {
    /// The instant `time_of_week` milliseconds into GPS week `week`.
    pub(crate) fn from_week(week: u16, time_of_week: u32) -> Self {
        let millis = u64::from(week) * SECONDS_PER_WEEK * 1000 + u64::from(time_of_week);
        Self(millis * (NANOS_PER_SECOND / 1000))
    }

    /// The instant `nanos` later.
    pub(crate) fn plus(self, nanos: u64) -> Self {
        Self(self.0.saturating_add(nanos))
    }

    /// The GPS week, which doesn't roll over at 1024, and the milliseconds into it.
    pub(crate) fn week(self) -> (u64, u64) {
        let millis = self.0 / (NANOS_PER_SECOND / 1000);
        let week = SECONDS_PER_WEEK * 1000;
        (millis / week, millis % week)
    }

    /// The UTC instant in seconds after 1970-01-01T00:00:00Z, and the nanoseconds past it.
    pub(crate) fn unix(self) -> (u64, u64) {
        let seconds = self.0 / NANOS_PER_SECOND;
        (
            (seconds + GPS_EPOCH_UNIX).saturating_sub(LEAP_SECONDS),
            self.0 % NANOS_PER_SECOND,
        )
    }

    /// The UTC calendar at this instant.
    pub(crate) fn utc(self) -> Utc {
        let (unix, nanos) = self.unix();
        let (year, month, day) = civil(unix / SECONDS_PER_DAY);
        let in_day = unix % SECONDS_PER_DAY;
        Utc {
            year,
            month,
            day,
            hour: in_day / 3600,
            minute: in_day % 3600 / 60,
            second: in_day % 60,
            millisecond: nanos / (NANOS_PER_SECOND / 1000),
        }
    }

    /// Greenwich mean sidereal time in radians, with UT1 taken as UTC: AIAA 2006-6753 Rev 3,
    /// `gstime`.
    // ceiling: UT1 is UTC; upgrade when a model needs the Earth's angle to better than a second
    pub(crate) fn sidereal_angle(self) -> f64 {
        let centuries = self.days_since_j2000() / DAYS_PER_CENTURY;
        let seconds = -6.2e-6 * centuries * centuries * centuries
            + 0.093_104 * centuries * centuries
            + (876_600.0 * 3600.0 + 8_640_184.812_866) * centuries
            + 67_310.548_41;
        (seconds * (PI / 180.0) / 240.0).rem_euclid(TAU)
    }
    /// UTC days since J2000.0, 2000-01-01T12:00:00, as a Julian date less 2451545.
    pub(crate) fn days_since_j2000(self) -> f64 {
        let (unix, nanos) = self.unix();
        let whole = |count: u64| f64::from(u32::try_from(count).unwrap_or(u32::MAX));
        let days = whole(unix / SECONDS_PER_DAY)
            + (whole(unix % SECONDS_PER_DAY) + whole(nanos) / whole(NANOS_PER_SECOND))
                / whole(SECONDS_PER_DAY);
        days + UNIX_JULIAN_DATE - J2000
    }

    /// The unit vector to the Sun in the inertial frame of the equator and equinox of date, by the
    /// U.S. Naval Observatory's "Approximate Solar Coordinates", good to about an arcminute within
    /// two centuries of 2000. The ecliptic latitude is taken as zero, as the page does.
    // ceiling: the Earth's center, not the spacecraft's, sees this Sun, 0.004° apart in low orbit
    pub(crate) fn sun(self) -> [f64; 3] {
        let days = self.days_since_j2000();
        let degrees = PI / 180.0;
        let anomaly = (357.529 + 0.985_600_28 * days) * degrees;
        let longitude = (280.459 + 0.985_647_36 * days) * degrees;
        let (sin_g, cos_g) = sin_cos(anomaly);
        let ecliptic = longitude + (1.915 * sin_g + 0.020 * 2.0 * sin_g * cos_g) * degrees;
        let obliquity = (23.439 - 0.000_000_36 * days) * degrees;
        let (sin_l, cos_l) = sin_cos(ecliptic);
        let (sin_e, cos_e) = sin_cos(obliquity);
        [cos_l, cos_e * sin_l, sin_e * sin_l]
    }
}

/// The days from 1970-01-01 to the first of January of `year`, 1970 or later.
pub(crate) fn days_to_year(year: u64) -> u64 {
    let leaps = |before: u64| before / 4 - before / 100 + before / 400;
    365 * (year - 1970) + leaps(year - 1) - leaps(1969)
}

/// The proleptic Gregorian year, month and day `days` after 1970-01-01, by Howard Hinnant's
/// `civil_from_days`.
fn civil(days: u64) -> (u64, u64, u64) {
    let shifted = days + 719_468;
    let era = shifted / 146_097;
    let of_era = shifted % 146_097;
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted_month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * shifted_month + 2) / 5 + 1;
    let month = if shifted_month < 10 {
        shifted_month + 3
    } else {
        shifted_month - 9
    };
    (year_of_era + era * 400 + u64::from(month <= 2), month, day)
}

/// `vector` in the Earth's frame turned into the inertial frame at sidereal angle `angle`, a turn
/// about the pole alone.
// ceiling: no precession, nutation or polar motion, the frame SGP4 calls TEME; upgrade when a model
// needs an inertial frame to better than a few arcminutes
pub(crate) fn inertial(vector: [f64; 3], angle: f64) -> [f64; 3] {
    let (sine, cosine) = sin_cos(angle);
    [
        cosine * vector[0] - sine * vector[1],
        sine * vector[0] + cosine * vector[1],
        vector[2],
    ]
}

/// `value` to the nearest integer, halves away from zero, held at the ends of an `i64`.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a float cast saturates, which is the hold asked for"
)]
pub(crate) fn nearest(value: f64) -> i64 {
    value.round() as i64
}

/// `value` to the nearest integer, held at the ends of an `i16`, as a register of that width takes
/// a reading.
pub(crate) fn nearest_i16(value: f64) -> i16 {
    crate::chip::saturate(nearest(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How far the hand-written functions may sit from the platform's: a few units in the last
    /// place of the angles they work on.
    const TOLERANCE: f64 = 1e-14;
    const STEPS: i32 = 100_000;

    #[test]
    #[cfg_attr(miri, ignore = "two hundred thousand points is beyond Miri")]
    #[expect(
        clippy::disallowed_methods,
        reason = "the platform's functions are the oracle of a test, which nothing in a run computes"
    )]
    fn the_arctangent_matches_the_platforms_over_every_quadrant() {
        for step in -STEPS..=STEPS {
            let x = f64::from(step) / f64::from(STEPS) * 50.0;
            assert!((atan(x) - x.atan()).abs() <= TOLERANCE, "atan({x})");
            let (sine, cosine) = f64::from(step).sin_cos();
            let (y, x) = (sine * 7e6, cosine * 7e6);
            assert!(
                (atan2(y, x) - y.atan2(x)).abs() <= TOLERANCE,
                "atan2({y}, {x})"
            );
        }
        for (y, x, angle) in [
            (0.0, 0.0, 0.0),
            (1.0, 0.0, FRAC_PI_2),
            (-1.0, 0.0, -FRAC_PI_2),
        ] {
            assert!((atan2(y, x) - angle).abs() <= TOLERANCE, "atan2({y}, {x})");
        }
        assert!((atan(f64::INFINITY) - FRAC_PI_2).abs() <= TOLERANCE);
    }

    /// The instant `day` days into `year`, counting from 0, at `hour` and `minute` UTC.
    fn utc(year: u64, day: u64, hour: u64, minute: u64) -> GpsTime {
        let unix = (days_to_year(year) + day) * SECONDS_PER_DAY + hour * 3600 + minute * 60;
        GpsTime((unix + LEAP_SECONDS - GPS_EPOCH_UNIX) * NANOS_PER_SECOND)
    }

    /// The Sun crosses the equator northward at the March equinox, 2026-03-20T14:46Z, and stands
    /// at the obliquity, 23.436°, and a right ascension of 90° at the June solstice,
    /// 2026-06-21T08:24Z, both by the U.S. Naval Observatory's seasons for 2026.
    #[test]
    fn the_sun_crosses_the_equator_at_the_equinox_and_tops_out_at_the_solstice() {
        let equinox = utc(2026, 78, 14, 46);
        assert_eq!(equinox.utc().month, 3);
        let [x, _, z] = equinox.sun();
        assert!(x > 0.999 && z.abs() < 3e-4, "{:?}", equinox.sun());
        let solstice = utc(2026, 171, 8, 24);
        assert_eq!((solstice.utc().month, solstice.utc().day), (6, 21));
        let [x, y, z] = solstice.sun();
        let declination = atan2(z, (x * x + y * y).sqrt()) * 180.0 / PI;
        assert!((declination - 23.436).abs() < 0.01, "{declination}°");
        assert!(x.abs() < 1e-3 && y > 0.9, "{:?}", solstice.sun());
    }

    #[test]
    fn the_days_to_a_year_count_its_leap_days() {
        for year in [1981, 1984, 1985, 2000, 2001, 2026, 2100, 2101] {
            let start = GpsTime(
                (days_to_year(year) * SECONDS_PER_DAY + LEAP_SECONDS - GPS_EPOCH_UNIX)
                    * NANOS_PER_SECOND,
            );
            let calendar = start.utc();
            assert_eq!((calendar.year, calendar.month, calendar.day), (year, 1, 1));
        }
    }

    #[test]
    #[cfg_attr(miri, ignore = "two hundred thousand points is beyond Miri")]
    #[expect(
        clippy::disallowed_methods,
        reason = "the platform's functions are the oracle of a test, which nothing in a run computes"
    )]
    fn the_sine_and_cosine_match_the_platforms_over_several_turns() {
        for step in -STEPS..=STEPS {
            let angle = f64::from(step) / f64::from(STEPS) * 4.0 * TAU;
            let (sine, cosine) = sin_cos(angle);
            assert!((sine - angle.sin()).abs() <= TOLERANCE, "sin({angle})");
            assert!((cosine - angle.cos()).abs() <= TOLERANCE, "cos({angle})");
        }
    }
}
