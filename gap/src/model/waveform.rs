//! Fourier coefficients of a sine through a bent or cut characteristic.
//!
//! Closed forms, because a time grid cannot resolve a dead zone of a
//! thousandth of the amplitude.

use super::saturation::{saturated, saturated_fundamental, unsaturated};

/// Harmonics that are reported one by one: d.c., fundamental and 2..5.
pub(crate) const REPORTED: usize = 6;

/// A static characteristic of one channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Characteristic {
    /// y = v + second v^2 + third v^3.
    Polynomial { second: f64, third: f64 },
    /// No output until the threshold is exceeded.
    DeadZone { threshold: f64 },
    /// Saturation on both sides.
    Clip { threshold: f64 },
    /// y = threshold tanh(v / threshold).
    Soft { threshold: f64 },
    /// Cut below -threshold (or above +threshold).
    OneSided { threshold: f64, upper: bool },
}

/// Spectrum of the output for the input `amplitude * cos`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Spectrum {
    /// Mean, then cosine amplitudes of order 1..5; all phases are 0 or pi.
    pub(crate) order: [f64; REPORTED],
    /// Mean square of all orders above 5.
    pub(crate) remainder_mean_square: f64,
}

impl Characteristic {
    /// Output spectrum for a cosine of the given peak amplitude.
    pub(crate) fn spectrum(self, amplitude: f64) -> Spectrum {
        let mut orders = [0.0; REPORTED];
        orders[1] = amplitude;
        match self {
            Self::Polynomial { second, third } => polynomial(&mut orders, amplitude, second, third),
            Self::DeadZone { threshold } => {
                orders[1] = 0.0;
                both_sides(&mut orders, amplitude, threshold, 1.0);
            }
            Self::Clip { threshold } => both_sides(&mut orders, amplitude, threshold, -1.0),
            Self::Soft { threshold } => return soft(amplitude, threshold),
            Self::OneSided { threshold, upper } => {
                one_side(&mut orders, amplitude, threshold, upper)
            }
        }
        let reported: f64 = orders[1..].iter().map(|c| c * c / 2.0).sum();
        let all = self.mean_square(amplitude);
        Spectrum {
            order: orders,
            remainder_mean_square: (all - orders[0] * orders[0] - reported).max(0.0),
        }
    }

    /// Mean square of the output for a cosine: all orders at once (Parseval).
    fn mean_square(self, amplitude: f64) -> f64 {
        let own = amplitude * amplitude / 2.0;
        match self {
            // Without orders above 5, or with their sum known.
            Self::Polynomial { .. } | Self::Soft { .. } => 0.0,
            Self::DeadZone { threshold } => 2.0 * ramp_squares(amplitude, threshold).0,
            Self::Clip { threshold } => {
                let (square, mixed) = ramp_squares(amplitude, threshold);
                own - 4.0 * mixed + 2.0 * square
            }
            Self::OneSided { threshold, .. } => {
                let (square, mixed) = ramp_squares(amplitude, threshold);
                own - 2.0 * mixed + square
            }
        }
    }

    /// Input amplitude whose output has the given fundamental.
    ///
    /// A saturating characteristic bounds its output: beyond the bound the
    /// largest resolvable input, 50 times the fundamental, is returned.
    pub(crate) fn input_for(self, fundamental: f64) -> f64 {
        match self {
            Self::Clip { .. } => {}
            Self::Soft { threshold } => return threshold * unsaturated(fundamental / threshold),
            _ => return self.divided(fundamental),
        }
        if self.fundamental(fundamental) == fundamental {
            return fundamental;
        }
        let (mut low, mut high) = (fundamental, 50.0 * fundamental);
        if self.fundamental(high) <= fundamental {
            return high;
        }
        // Regula falsi in the reciprocal of the input, in which saturation is nearly straight.
        let (mut left, mut right) = (
            self.fundamental(low) - fundamental,
            self.fundamental(high) - fundamental,
        );
        let mut kept_low = None;
        for _ in 0..60 {
            let inverse = (right / low - left / high) / (right - left);
            let middle = 1.0 / inverse;
            let error = self.fundamental(middle) - fundamental;
            if error.abs() <= 1e-14 * fundamental || (high - low) <= 1e-14 * low {
                return middle;
            }
            if error < 0.0 {
                (low, left) = (middle, error);
                // The same end kept twice: pull it in (Illinois rule).
                right *= if kept_low == Some(false) { 0.5 } else { 1.0 };
                kept_low = Some(false);
            } else {
                (high, right) = (middle, error);
                left *= if kept_low == Some(true) { 0.5 } else { 1.0 };
                kept_low = Some(true);
            }
        }
        0.5 * (low + high)
    }

    /// Fundamental of the output, without the other orders.
    fn fundamental(self, amplitude: f64) -> f64 {
        match self {
            Self::Polynomial { third, .. } => {
                amplitude * (1.0 + 0.75 * third * amplitude * amplitude)
            }
            Self::DeadZone { threshold } => 2.0 * ramp(1, amplitude, threshold),
            Self::Clip { threshold } => amplitude - 2.0 * ramp(1, amplitude, threshold),
            Self::Soft { threshold } => threshold * saturated_fundamental(amplitude / threshold)[0],
            Self::OneSided { threshold, .. } => amplitude - ramp(1, amplitude, threshold),
        }
    }
}

impl Characteristic {
    /// Inversion by repeated division, for gains near one (a falling cubic has no other safe bracket).
    fn divided(self, fundamental: f64) -> f64 {
        let mut input = fundamental;
        for _ in 0..40 {
            let output = self.fundamental(input);
            if output <= 0.0 {
                input *= 2.0;
                continue;
            }
            let next = input * (fundamental / output).clamp(0.5, 2.0);
            let done = (next - input).abs() <= 1e-13 * input;
            input = next;
            if done {
                break;
            }
        }
        input
    }
}

fn polynomial(orders: &mut [f64; REPORTED], a: f64, second: f64, third: f64) {
    orders[0] += second * a * a / 2.0;
    orders[1] += 0.75 * third * a * a * a;
    orders[2] += second * a * a / 2.0;
    orders[3] += third * a * a * a / 4.0;
}

fn both_sides(orders: &mut [f64; REPORTED], amplitude: f64, threshold: f64, sign: f64) {
    for (n, order) in orders.iter_mut().enumerate().filter(|(n, _)| n % 2 == 1) {
        *order += sign * 2.0 * ramp(n, amplitude, threshold);
    }
}

fn one_side(orders: &mut [f64; REPORTED], amplitude: f64, threshold: f64, upper: bool) {
    for (n, order) in orders.iter_mut().enumerate() {
        let lower = if n % 2 == 0 { 1.0 } else { -1.0 };
        *order += if upper { -1.0 } else { lower } * ramp(n, amplitude, threshold);
    }
}

/// Orders of a cosine that saturates softly, with the sum of those above the reported ones.
fn soft(amplitude: f64, threshold: f64) -> Spectrum {
    let all = saturated(amplitude / threshold).map(|order| threshold * order);
    let above = all[REPORTED..].iter().map(|order| 0.5 * order * order);
    Spectrum {
        order: std::array::from_fn(|n| all[n]),
        remainder_mean_square: above.sum(),
    }
}

/// Coefficient of an odd order of a cosine that saturates on both sides.
pub(crate) fn clipped_order(n: usize, amplitude: f64, threshold: f64) -> f64 {
    -2.0 * ramp(n, amplitude, threshold)
}

/// Means of r^2 and of A cos(t) r, for r = max(A cos(t) - b, 0).
fn ramp_squares(amplitude: f64, b: f64) -> (f64, f64) {
    if b >= amplitude {
        return (0.0, 0.0);
    }
    let t = (b / amplitude).max(-1.0).acos();
    let own = amplitude * amplitude * (t / 2.0 + (2.0 * t).sin() / 4.0);
    let linear = amplitude * b * t.sin();
    let pi = std::f64::consts::PI;
    ((own - 2.0 * linear + b * b * t) / pi, (own - linear) / pi)
}

/// Coefficient n of max(A cos(t) - b, 0).
///
/// # Equation
/// With cos(tb) = b/A: c0 = (A sin tb - b tb)/pi,
/// cn = (2/pi) Integral_0^tb (A cos t - b) cos(n t) dt.
fn ramp(n: usize, amplitude: f64, b: f64) -> f64 {
    use std::f64::consts::PI;
    if b >= amplitude {
        return 0.0;
    }
    let t = (b / amplitude).max(-1.0).acos();
    let k = n as f64;
    match n {
        0 => (amplitude * t.sin() - b * t) / PI,
        1 => (amplitude * (t + t.sin() * t.cos()) - 2.0 * b * t.sin()) / PI,
        _ => {
            let product = ((k - 1.0) * t).sin() / (k - 1.0) + ((k + 1.0) * t).sin() / (k + 1.0);
            (amplitude * product - 2.0 * b * (k * t).sin() / k) / PI
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients by summation over a fine grid. Its error for a kinked
    /// function is of the order (pi/N)^2, 2.5e-8 with N = 20 000.
    fn by_sampling(f: impl Fn(f64) -> f64, n: usize) -> f64 {
        const N: usize = 20_000;
        let sum: f64 = (0..N)
            .map(|i| {
                let t = std::f64::consts::TAU * (i as f64 + 0.5) / N as f64;
                f(t.cos()) * (n as f64 * t).cos()
            })
            .sum();
        sum / N as f64 * if n == 0 { 1.0 } else { 2.0 }
    }

    #[test]
    fn closed_forms_agree_with_sampled_waveforms() {
        let amplitude = 1.7;
        type Case = (Characteristic, fn(f64) -> f64);
        let cases: [Case; 6] = [
            (Characteristic::Soft { threshold: 2.0 }, |v| {
                2.0 * (v / 2.0).tanh()
            }),
            (Characteristic::DeadZone { threshold: 0.2 }, |v| {
                v.signum() * (v.abs() - 0.2).max(0.0)
            }),
            (Characteristic::Clip { threshold: 1.1 }, |v| {
                v.clamp(-1.1, 1.1)
            }),
            (
                Characteristic::OneSided {
                    threshold: 0.9,
                    upper: false,
                },
                |v| v.max(-0.9),
            ),
            (
                Characteristic::OneSided {
                    threshold: 0.9,
                    upper: true,
                },
                |v| v.min(0.9),
            ),
            (
                Characteristic::Polynomial {
                    second: 0.02,
                    third: -0.03,
                },
                |v| v + 0.02 * v * v - 0.03 * v * v * v,
            ),
        ];
        for (characteristic, function) in cases {
            let spectrum = characteristic.spectrum(amplitude);
            let mean = |k: usize| {
                let c = (std::f64::consts::TAU * (k as f64 + 0.5) / 20_000.0).cos();
                function(amplitude * c).powi(2) / 20_000.0
            };
            let all: f64 = (0..20_000).map(mean).sum();
            let orders: f64 = spectrum.order[1..].iter().map(|c| c * c / 2.0).sum();
            let left = all - spectrum.order[0].powi(2) - orders;
            assert!(
                (spectrum.remainder_mean_square - left).abs() < 1e-6,
                "{characteristic:?}"
            );
            for (n, &order) in spectrum.order.iter().enumerate() {
                let expected = by_sampling(|c| function(amplitude * c), n);
                assert!(
                    (order - expected).abs() < 1e-6,
                    "{characteristic:?} order {n}: {order} {expected}"
                );
            }
        }
    }

    #[test]
    fn the_input_of_a_clipped_output_is_found() {
        let clip = Characteristic::Clip { threshold: 1.0 };
        let soft = Characteristic::Soft { threshold: 1.0 };
        for characteristic in [clip, soft] {
            let output = characteristic.spectrum(1.4).order[1];
            assert!((characteristic.input_for(output) - 1.4).abs() < 1e-9);
        }
    }
}
