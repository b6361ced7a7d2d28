//! Weighted least squares on the ratio of the spectra.
//!
//! The vector v of (23) and the coefficients mu of a polynomial in
//! `s_n = i K tan(w_n T / 2)` describe the same discrete model:
//! v1 = mu1 + K mu2 + K^2 mu3, v2 = 2 mu1 - 2 K^2 mu3,
//! v3 = mu1 - K mu2 + K^2 mu3. The fit uses mu, because at high sample rates
//! the columns of (25) are almost equal and lose half of the digits.

use crate::metrology::discrete::{Discrete, Mapping};
use crate::metrology::oscillator::Oscillator;
use crate::metrology::record::{TimeRecord, without_offset};
use crate::metrology::statistics;
use crate::{Error, Result};
use nalgebra::{Complex, Matrix2x3, Matrix3, Vector2, Vector3};
use rustfft::FftPlanner;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Frequencies used, Hz.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Range {
    /// Lowest bin.
    pub from_hz: f64,
    /// Highest bin.
    pub to_hz: f64,
}

/// Result of a shock identification.
#[derive(Clone, Debug, Serialize)]
pub struct ShockIdentification {
    /// Continuous-time parameters.
    #[serde(flatten)]
    pub oscillator: Oscillator,
    /// Electromechanical conversion factor.
    pub rho: f64,
    /// Standard uncertainty of S0.
    pub u_s0: f64,
    /// Standard uncertainty of f0, Hz.
    pub u_f0_hz: f64,
    /// Standard uncertainty of delta.
    pub u_delta: f64,
    /// Correlation matrix of (S0, f0, delta).
    pub correlation: [[f64; 3]; 3],
    /// Discrete-time parameters for this sample rate and mapping.
    pub discrete: Discrete,
    /// Standard uncertainties of b, c1, c2.
    pub u_discrete: Discrete,
    /// Samples per second, Hz.
    pub sample_rate_hz: f64,
    /// Mapping of the s-plane.
    pub mapping: Mapping,
    /// The mapping as a formula.
    pub mapping_formula: &'static str,
    /// Bins used.
    pub frequencies: usize,
    /// Their range.
    pub range: Range,
    /// Uncertainty coefficient u0 of (27), in units of the spectrum of a.
    pub u0: f64,
    /// Chi-squared (39) with a stated u0, else the degrees of freedom.
    pub chi2: f64,
    /// Degrees of freedom, 2 L - 3.
    pub degrees_of_freedom: usize,
    /// Outcome of the test; `None` when u0 came from the residuals (8.5.3).
    pub consistent: Option<bool>,
    /// Peak of the output over peak of the input, for comparison with S0.
    pub peak_ratio: f64,
    /// Root mean square of measured minus simulated output, percent of the
    /// measured peak (8.4.2); `None` when delta is not positive and the
    /// simulation would grow without bound.
    pub simulation_rms_percent: Option<f64>,
    /// Largest deviation, percent of the measured peak.
    pub simulation_max_percent: Option<f64>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// What to fit and how.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// Lowest frequency, Hz; default the first bin.
    pub from_hz: Option<f64>,
    /// Highest frequency, Hz; default where the input's spectrum has fallen
    /// to a tenth.
    pub to_hz: Option<f64>,
    /// Stated u0 of (27); default from the residuals.
    pub u0: Option<f64>,
    /// Pre-warp the mapping.
    pub prewarp: bool,
    /// Delay of the input channel behind the output channel that the
    /// measuring chains are known to have, s (8.2).
    pub input_delay_s: f64,
}

/// Share of its maximum to which the input's spectrum may fall by default.
const USABLE: f64 = 0.1;

/// Identifies the model from a record with input and output.
///
/// # Errors
/// No input or output, too few usable bins, or no oscillator.
///
/// # Accuracy
/// Test `a_synthetic_shock_returns_the_truth`.
pub fn identify(record: &TimeRecord, choice: &Choice) -> Result<ShockIdentification> {
    let (Some(input), Some(output)) = (&record.input, &record.output) else {
        return Err(Error::input(
            "record",
            "identification needs input and output",
            "give both columns: time_s, input (acceleration), output",
        ));
    };
    let (input, output) = (without_offset(input), without_offset(output));
    let (mut a, x) = (spectrum(&input), spectrum(&output));
    advance(&mut a, choice.input_delay_s * record.sample_rate_hz);
    let bins = bins(&a, record.sample_rate_hz, choice)?;
    let fit = solve(&a, &x, &bins, record.sample_rate_hz);
    let (mu, covariance_u0, square_sum) = fit.ok_or_else(no_oscillator)?;
    let degrees_of_freedom = 2 * bins.len() - 3;
    let u0 = match choice.u0 {
        Some(u0) => u0,
        None => (square_sum / degrees_of_freedom as f64).sqrt(),
    };
    let covariance = covariance_u0 * u0 * u0;
    let mapping = match choice.prewarp {
        true => Mapping::BilinearPrewarped,
        false => Mapping::Bilinear,
    };
    let parameters = |mu: &Vector3<f64>| continuous(mu, record.sample_rate_hz, mapping);
    let oscillator = parameters(&mu).ok_or_else(no_oscillator)?;
    let discrete = Discrete::new(&oscillator, record.sample_rate_hz, mapping);
    let all = |mu: &Vector3<f64>| match parameters(mu) {
        Some(o) => {
            let d = Discrete::new(&o, record.sample_rate_hz, mapping);
            [o.s0, o.f0_hz, o.delta, d.b, d.c1, d.c2]
        }
        None => [f64::NAN; 6],
    };
    let (u, correlation) = spread(&mu, &covariance, all);
    let chi2 = square_sum / (u0 * u0);
    let mut result = ShockIdentification {
        oscillator,
        rho: oscillator.rho(),
        u_s0: u[0],
        u_f0_hz: u[1],
        u_delta: u[2],
        correlation,
        discrete,
        u_discrete: Discrete {
            b: u[3],
            c1: u[4],
            c2: u[5],
        },
        sample_rate_hz: record.sample_rate_hz,
        mapping,
        mapping_formula: mapping.formula(),
        frequencies: bins.len(),
        range: range(&bins, a.len(), record.sample_rate_hz),
        u0,
        chi2,
        degrees_of_freedom,
        consistent: choice
            .u0
            .map(|_| chi2 <= statistics::chi_squared_quantile(0.975, degrees_of_freedom as f64)),
        peak_ratio: peak_of(&output) / peak_of(&input),
        simulation_rms_percent: None,
        simulation_max_percent: None,
        warnings: Vec::new(),
    };
    if oscillator.delta > 0.0 {
        let mut aligned = a.clone();
        rustfft::FftPlanner::new()
            .plan_fft_inverse(aligned.len())
            .process(&mut aligned);
        let scale = 1.0 / aligned.len() as f64;
        let aligned: Vec<f64> = aligned.iter().map(|value| value.re * scale).collect();
        compare(&mut result, &output, &discrete.respond(&aligned));
    }
    advise(&mut result);
    Ok(result)
}

fn spectrum(values: &[f64]) -> Vec<Complex<f64>> {
    let mut buffer: Vec<Complex<f64>> = values.iter().map(|&v| Complex::new(v, 0.0)).collect();
    FftPlanner::new()
        .plan_fft_forward(buffer.len())
        .process(&mut buffer);
    buffer
}

/// Undoes a delay of so many samples.
fn advance(spectrum: &mut [Complex<f64>], samples: f64) {
    let count = spectrum.len();
    for (n, bin) in spectrum.iter_mut().enumerate() {
        // The upper half are negative frequencies; Nyquist stays real.
        let signed = match (2 * n).cmp(&count) {
            std::cmp::Ordering::Less => n as f64,
            std::cmp::Ordering::Equal => 0.0,
            std::cmp::Ordering::Greater => n as f64 - count as f64,
        };
        *bin *= Complex::from_polar(1.0, TAU * signed * samples / count as f64);
    }
}

/// Bins in the range asked for; bin n lies at n/(N T). Bin 0 is left out, as
/// for a.c.-coupled amplifiers (7.3.1).
fn bins(a: &[Complex<f64>], sample_rate_hz: f64, choice: &Choice) -> Result<Vec<usize>> {
    let spacing_hz = sample_rate_hz / a.len() as f64;
    let half = &a[1..a.len() / 2];
    let largest = half.iter().map(|bin| bin.norm()).fold(0.0, f64::max);
    let usable = half
        .iter()
        .rposition(|bin| bin.norm() >= USABLE * largest)
        .map_or(0, |index| index + 1);
    let bin_of = |f: f64| (f / spacing_hz).round().max(1.0) as usize;
    let first = choice.from_hz.map_or(1, bin_of);
    let last = choice.to_hz.map_or(usable, bin_of).min(half.len());
    match last >= first + 2 {
        true => Ok((first..=last).collect()),
        false => Err(Error::input(
            "record",
            format!(
                "only {} usable bins of {spacing_hz:.1} Hz",
                (last + 1).saturating_sub(first)
            ),
            "give a longer record, or a wider range with --from-hz and --to-hz",
        )),
    }
}

fn range(bins: &[usize], count: usize, sample_rate_hz: f64) -> Range {
    let hz = |bin: Option<&usize>| bin.map_or(0.0, |&n| n as f64 * sample_rate_hz / count as f64);
    Range {
        from_hz: hz(bins.first()),
        to_hz: hz(bins.last()),
    }
}

/// mu, its covariance for u0 = 1, and the weighted sum of squares for u0 = 1.
///
/// With (27), dividing the residual of G = A/X by u(G) = u0/|X| leaves
/// |A - X (mu1 + mu2 s + mu3 s^2)|^2 / u0^2.
fn solve(
    a: &[Complex<f64>],
    x: &[Complex<f64>],
    bins: &[usize],
    sample_rate_hz: f64,
) -> Option<(Vector3<f64>, Matrix3<f64>, f64)> {
    let s = |n: usize| 2.0 * sample_rate_hz * (PI * n as f64 / a.len() as f64).tan();
    let scale = bins.iter().map(|&n| s(n)).sum::<f64>() / bins.len() as f64;
    let rows: Vec<(Matrix2x3<f64>, Vector2<f64>)> = bins
        .iter()
        .map(|&n| {
            let w = s(n) / scale;
            let columns = [x[n], x[n] * Complex::new(0.0, w), x[n] * -(w * w)];
            (
                Matrix2x3::from_fn(|row, column| match row {
                    0 => columns[column].re,
                    _ => columns[column].im,
                }),
                Vector2::new(a[n].re, a[n].im),
            )
        })
        .collect();
    let normal: Matrix3<f64> = rows.iter().map(|(d, _)| d.transpose() * d).sum();
    let right: Vector3<f64> = rows.iter().map(|(d, y)| d.transpose() * y).sum();
    let inverse = normal.try_inverse()?;
    let scaled = inverse * right;
    let squares = rows
        .iter()
        .map(|(d, y)| (y - d * scaled).norm_squared())
        .sum();
    let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0 / scale, 1.0 / (scale * scale)));
    Some((unit * scaled, unit * inverse * unit, squares))
}

/// Continuous-time parameters of mu found with K = 2/T. Pre-warping maps the
/// same filter to another resonance: `w0 = (2/T) atan(w0' T/2)`.
fn continuous(mu: &Vector3<f64>, sample_rate_hz: f64, mapping: Mapping) -> Option<Oscillator> {
    let plain = Oscillator::from_inverse(mu)?;
    let f0_hz = match mapping {
        Mapping::Bilinear => plain.f0_hz,
        Mapping::BilinearPrewarped => {
            let half = TAU * plain.f0_hz / (2.0 * sample_rate_hz);
            2.0 * sample_rate_hz * half.atan() / TAU
        }
    };
    Some(Oscillator { f0_hz, ..plain })
}

/// Standard uncertainties of all parameters and the correlation of the first
/// three, to first order with central differences.
fn spread(
    mu: &Vector3<f64>,
    covariance: &Matrix3<f64>,
    all: impl Fn(&Vector3<f64>) -> [f64; 6],
) -> ([f64; 6], [[f64; 3]; 3]) {
    let mut gradient = [[0.0; 3]; 6];
    for column in 0..3 {
        let step = (0.01 * covariance[(column, column)].sqrt()).max(1e-9 * mu[column].abs());
        let (mut above, mut below) = (*mu, *mu);
        above[column] += step;
        below[column] -= step;
        for (row, (high, low)) in gradient.iter_mut().zip(all(&above).iter().zip(all(&below))) {
            row[column] = (high - low) / (2.0 * step);
        }
    }
    let g = |row: usize| Vector3::from(gradient[row]);
    let covariance_of = |a: usize, b: usize| g(a).dot(&(covariance * g(b)));
    let u: [f64; 6] = std::array::from_fn(|row| covariance_of(row, row).max(0.0).sqrt());
    let correlation =
        std::array::from_fn(|a| std::array::from_fn(|b| covariance_of(a, b) / (u[a] * u[b])));
    (u, correlation)
}

fn peak_of(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()))
}

fn compare(result: &mut ShockIdentification, measured: &[f64], simulated: &[f64]) {
    let peak = peak_of(measured);
    let differences: Vec<f64> = measured
        .iter()
        .zip(simulated)
        .map(|(m, s)| 100.0 * (m - s) / peak)
        .collect();
    let squares: f64 = differences.iter().map(|d| d * d).sum();
    result.simulation_rms_percent = Some((squares / differences.len() as f64).sqrt());
    result.simulation_max_percent = Some(peak_of(&differences));
}

fn advise(result: &mut ShockIdentification) {
    let oscillator = result.oscillator;
    let rise = oscillator.response(result.range.to_hz).norm() / oscillator.s0;
    if rise < 1.1 && result.range.to_hz < oscillator.f0_hz {
        result.warnings.push(
            "the spectrum used ends below a rise of 10 % over S0 (8.3 b): f0 and delta are \
             poorly determined; use a shorter shock"
                .into(),
        );
    }
    let ratio = result.sample_rate_hz / oscillator.f0_hz;
    if ratio < 10.0 {
        result.warnings.push(format!(
            "the sample rate is only {ratio:.1} times the resonance; 7.3.1 asks for 5, better 10"
        ));
    }
    if result.u_f0_hz > 0.05 * oscillator.f0_hz {
        result.warnings.push(
            "the relative uncertainty of f0 exceeds 5 %: first-order propagation (35), (36) is \
             outside its range"
                .into(),
        );
    }
    if oscillator.delta <= 0.0 {
        result.warnings.push(
            "delta is not positive, which no transducer has: input and output are not \
             synchronous (8.2), or the record does not reach the resonance; a known delay of \
             the input channel is compensated with --input-delay-s"
                .into(),
        );
    }
}

fn no_oscillator() -> Error {
    Error::input(
        "record",
        "no mass-spring-damper model fits the ratio of the spectra",
        "check which column is the input, the synchronicity of the channels (8.2), and the \
         range (--from-hz, --to-hz)",
    )
}
