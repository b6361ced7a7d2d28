//! Dither: the front end shapes the square wave on the dither's pin, and adds it to both inputs.
//!
//! Resistors and capacitors turn it into something near a triangle
//! ([hardware/dither.cir](../../../hardware/dither.cir)): every code within its reach is taken about equally
//! often. The second half of a period is the first one turned over, so that conversions spread evenly over
//! whole periods have a mean without it.

use std::f64::consts::TAU;

use crate::rig_port::{Conversions, Dither};

/// The wave at the pin by its harmonics: order, amplitude over the fundamental's, phase against the rising edge,
/// rad. As ngspice computes it with edges of 10 ns and the high half 10 ns too long
/// ([hardware/play.cir](../../../hardware/play.cir)), which is where the even ones come from; of these only
/// the ones that eight conversions of a period cannot tell from a constant.
const HARMONICS: [(f64, f64, f64); 9] = [
    (1.0, 1.0, -1.2879),
    (3.0, 0.108_632, -1.7178),
    (5.0, 0.038_155, -1.9455),
    (7.0, 0.018_805, -2.1394),
    (9.0, 0.010_894, -2.3172),
    (11.0, 0.006_935, -2.4834),
    (8.0, 0.000_324, -0.659),
    (16.0, 0.000_130, -1.2869),
    (24.0, 0.000_067, -1.7925),
];
/// Points of a period that are computed; between them the wave is straight.
const POINTS: usize = 4096;

/// The dither at both converters.
#[derive(Debug, Clone)]
pub(crate) struct Dithering {
    /// Volts over a period.
    wave_v: Vec<f64>,
    dither: Option<Dither>,
    /// Volts beside the signal at each conversion of a trigger; empty without dither.
    at_conversions_v: Vec<f64>,
}

impl Dithering {
    /// A front end that makes `peak_v` of it, as volts at the connector; 0 for one that leaves it out.
    pub(crate) fn new(peak_v: f64) -> Self {
        let wave_v = match peak_v > 0.0 {
            true => wave().into_iter().map(|point| point * peak_v).collect(),
            false => Vec::new(),
        };
        Self {
            wave_v,
            dither: None,
            at_conversions_v: Vec::new(),
        }
    }

    /// The pin plays this from now on.
    pub(crate) fn set(&mut self, dither: Option<Dither>) {
        self.dither = dither.filter(|_| !self.wave_v.is_empty());
    }

    /// Dither the pin plays now.
    pub(crate) fn played(&self) -> Option<Dither> {
        self.dither
    }

    /// Time goes on.
    pub(crate) fn advance(&mut self, duration_ns: u64) {
        if let Some(dither) = &mut self.dither {
            let periods = duration_ns as f64 * 1e-9 * dither.frequency_hz;
            dither.phase = fraction(dither.phase + periods);
        }
    }

    /// Volts at the conversions of a trigger at this instant.
    pub(crate) fn at(&mut self, conversions: Conversions) -> &[f64] {
        self.at_conversions_v.clear();
        if let Some(dither) = self.dither {
            let apart = conversions.apart_ps as f64 * 1e-12 * dither.frequency_hz;
            let volts = (0..conversions.count).map(|nth| {
                at(
                    &self.wave_v,
                    fraction(dither.phase + f64::from(nth) * apart),
                )
            });
            self.at_conversions_v.extend(volts);
        }
        &self.at_conversions_v
    }
}

/// The wave over a period and one point more, with a peak of 1.
fn wave() -> Vec<f64> {
    let at = |point: usize| -> f64 {
        let angle = TAU * point as f64 / POINTS as f64;
        let parts = HARMONICS.iter();
        parts
            .map(|(order, amplitude, phase)| amplitude * (order * angle + phase).sin())
            .sum()
    };
    let points: Vec<f64> = (0..=POINTS).map(at).collect();
    let peak = points
        .iter()
        .fold(0.0_f64, |peak, point| peak.max(point.abs()));
    points.into_iter().map(|point| point / peak).collect()
}

/// Fraction of a number that is not negative: `f64::fract`, which asks a library here.
fn fraction(value: f64) -> f64 {
    value - (value as i64) as f64
}

/// The wave at a phase of 0 to 1.
fn at(wave: &[f64], phase: f64) -> f64 {
    let place = phase * POINTS as f64;
    let point = (place as usize).min(POINTS - 1);
    wave[point] + (wave[point + 1] - wave[point]) * (place - point as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 41 cycles of 30 MHz, and 8 of them a period of the dither.
    const CONVERSIONS: Conversions = Conversions {
        count: 8,
        apart_ps: 1_366_667,
        sampling_ns: 1_084,
    };
    const PLAYED: Dither = Dither {
        frequency_hz: 30.0e6 / (8.0 * 41.0),
        phase: 0.3,
    };

    #[test]
    fn eight_conversions_of_a_period_have_hardly_a_mean_at_any_phase() {
        let mut dithering = Dithering::new(1.3);
        dithering.set(Some(PLAYED));
        let mut phases = Vec::new();
        for _ in 0..100 {
            let volts = dithering.at(CONVERSIONS);
            assert_eq!(volts.len(), 8);
            let mean_v = volts.iter().sum::<f64>() / 8.0;
            // 5.2e-4 of a fundamental of 0.89 times the peak.
            assert!(mean_v.abs() < 6.2e-4, "{mean_v:e}");
            phases.push((dithering.played().unwrap().phase * 1e6).round() as u64);
            dithering.advance(20_000);
        }
        // 20 us are 75/41 of a period: 41 triggers go by before a phase comes again.
        phases.truncate(41);
        phases.sort_unstable();
        phases.dedup();
        assert_eq!(phases.len(), 41);
    }

    /// By ngspice: 0.4382 V peak and 0.2726 V r.m.s.
    #[test]
    fn the_wave_is_that_of_the_circuit() {
        let wave = wave();
        let mean_square = wave[1..].iter().map(|point| point * point).sum::<f64>() / POINTS as f64;
        assert!((mean_square.sqrt() - 0.2726 / 0.4382).abs() < 0.01);
        assert!((at(&wave, 0.75) + at(&wave, 0.25)).abs() < 2e-3);
        // It falls as long as the pin is low.
        assert!(at(&wave, 0.9) > at(&wave, 0.99) && at(&wave, 0.1) < at(&wave, 0.4));
    }

    #[test]
    fn without_a_network_or_a_wave_nothing_is_added() {
        let mut none = Dithering::new(0.0);
        none.set(Some(PLAYED));
        assert!(none.at(CONVERSIONS).is_empty());
        let mut silent = Dithering::new(1.3);
        assert!(silent.at(CONVERSIONS).is_empty());
        silent.set(Some(PLAYED));
        silent.set(None);
        assert!(silent.at(CONVERSIONS).is_empty());
    }
}
