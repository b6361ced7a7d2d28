//! Static characteristics of the inputs, applied to a waveform.

use super::truth::Truth;
use num_complex::Complex64 as C;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// Highest order that is reported.
pub(crate) const ORDERS: usize = 5;
/// Samples of a period.
const SAMPLES: usize = 4096;
/// Turn of each order at each sample.
static TURNS: LazyLock<Vec<[C; ORDERS + 1]>> = LazyLock::new(|| {
    let angle_rad = |k: usize| TAU * (k as f64 + 0.5) / SAMPLES as f64;
    let turns = |k| std::array::from_fn(|n| C::from_polar(1.0, n as f64 * angle_rad(k)));
    (0..SAMPLES).map(turns).collect()
});

/// Complex amplitudes of orders 0..=5 of a waveform behind a static characteristic.
pub(crate) fn bent(waveform: &[C], characteristic: impl Fn(f64) -> f64) -> Vec<C> {
    let mut orders = vec![C::ZERO; ORDERS + 1];
    assert!(waveform.len() <= ORDERS + 1, "an order too many");
    for turns in TURNS.iter() {
        let turned = waveform.iter().zip(turns).map(|(c, turn)| (c * turn).re);
        let value = characteristic(turned.sum());
        for (n, (order, turn)) in orders.iter_mut().zip(turns).enumerate() {
            let share = if n == 0 { 1.0 } else { 2.0 } / SAMPLES as f64;
            *order += turn.conj() * value * share;
        }
    }
    orders
}

/// Waveform behind the converter of a channel.
pub(crate) fn converted(truth: &Truth, channel: &str, waveform: Vec<C>) -> Vec<C> {
    let parameter = |effect: &str| truth.get(&format!("{effect}.{channel}"));
    let waveform = match parameter("range_step") {
        Some(step) if waveform[1].norm() > truth.or("range_step.v", 0.1) => {
            waveform.iter().map(|c| c * (1.0 + step)).collect()
        }
        _ => waveform,
    };
    if let Some(c3) = parameter("adc_cubic") {
        bent(&waveform, |v| v + c3 * v * v * v)
    } else if let Some(c2) = parameter("adc_quadratic") {
        bent(&waveform, |v| v + c2 * v * v)
    } else if let Some(dead_v) = parameter("adc_dead_zone") {
        bent(&waveform, |v| v.signum() * (v.abs() - dead_v).max(0.0))
    } else if let Some(knee_v) = parameter("adc_soft_clipping") {
        match truth.has_other_form() {
            true => bent(&waveform, |v| v / (1.0 + (v / knee_v).powi(2)).sqrt()),
            false => bent(&waveform, |v| knee_v * (v / knee_v).tanh()),
        }
    } else if let Some(full_v) = parameter("adc_clipping") {
        bent(&waveform, |v| v.clamp(-full_v, full_v))
    } else {
        waveform
    }
}
