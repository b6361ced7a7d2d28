//! A shock record to parameters, test and warnings.

use super::choice::Choice;
use super::solve::{continuous, solve, spread};
use super::spectra::{Range, advance, bins, from_spectrum, range, spectrum};
use crate::discrete::{Discrete, Mapping};
use crate::oscillator::Oscillator;
use crate::record::{TimeRecord, without_offset};
use crate::statistics;
use calib_files::{Error, Result};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of a shock identification.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ShockIdentification {
    /// Continuous-time parameters.
    #[serde(flatten)]
    pub oscillator: Oscillator,
    /// Electromechanical conversion factor.
    pub rho: f64,
    /// Standard uncertainty of S0.
    #[serde(rename = "standard_uncertainty_s0")]
    pub u_s0: f64,
    /// Standard uncertainty of f0, Hz.
    #[serde(rename = "standard_uncertainty_f0_hz")]
    pub u_f0_hz: f64,
    /// Standard uncertainty of delta.
    #[serde(rename = "standard_uncertainty_delta")]
    pub u_delta: f64,
    /// Correlation matrix of (S0, f0, delta).
    pub correlation: [[f64; 3]; 3],
    /// Discrete-time parameters for this sample rate and mapping.
    pub discrete: Discrete,
    /// Standard uncertainties of b, c1, c2.
    #[serde(rename = "standard_uncertainty_discrete")]
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
    /// Root mean square of measured minus simulated output, relative to the
    /// measured peak (8.4.2); `None` when delta is not positive and the
    /// simulation would grow without bound.
    pub simulation_rms_rel: Option<f64>,
    /// Largest deviation, relative to the measured peak.
    pub simulation_max_rel: Option<f64>,
    /// Warnings.
    pub warnings: Vec<String>,
}

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
    let estimate = Estimate::new(&a, &x, &bins, record.sample_rate_hz, choice)?;
    let range = range(&bins, a.len(), record.sample_rate_hz);
    let mut result = ShockIdentification {
        peak_ratio: peak_of(&output) / peak_of(&input),
        ..estimate.interpret(range, record.sample_rate_hz, choice)?
    };
    if result.oscillator.delta > 0.0 {
        let simulated = result.discrete.respond(&from_spectrum(&a));
        compare(&mut result, &output, &simulated);
    }
    advise(&mut result);
    Ok(result)
}

/// The fit of the spectra, before it is an oscillator.
struct Estimate {
    mu: Vector3<f64>,
    covariance: Matrix3<f64>,
    bins: usize,
    u0: f64,
    chi2: f64,
    degrees_of_freedom: usize,
}

impl Estimate {
    fn new(
        a: &[Complex64],
        x: &[Complex64],
        bins: &[usize],
        sample_rate_hz: f64,
        choice: &Choice,
    ) -> Result<Self> {
        let fit = solve(a, x, bins, sample_rate_hz);
        let (mu, covariance_u0, square_sum) = fit.ok_or_else(no_oscillator)?;
        let degrees_of_freedom = 2 * bins.len() - 3;
        let from_residuals = || (square_sum / degrees_of_freedom as f64).sqrt();
        let u0 = choice.u0.unwrap_or_else(from_residuals);
        Ok(Self {
            mu,
            covariance: covariance_u0 * u0 * u0,
            bins: bins.len(),
            u0,
            chi2: square_sum / (u0 * u0),
            degrees_of_freedom,
        })
    }

    /// Chi-squared (39) against its 97.5 % quantile.
    fn is_consistent(&self) -> bool {
        let limit = statistics::chi_squared_quantile(0.975, self.degrees_of_freedom as f64);
        self.chi2 <= limit
    }

    /// Parameters of the oscillator with their uncertainties; nothing of the waveforms yet.
    fn interpret(
        &self,
        range: Range,
        sample_rate_hz: f64,
        choice: &Choice,
    ) -> Result<ShockIdentification> {
        let mapping = match choice.prewarp {
            true => Mapping::BilinearPrewarped,
            false => Mapping::Bilinear,
        };
        let oscillator = continuous(&self.mu, sample_rate_hz, mapping).ok_or_else(no_oscillator)?;
        let all = |mu: &Vector3<f64>| parameters(mu, sample_rate_hz, mapping);
        let (u, correlation) = spread(&self.mu, &self.covariance, all);
        let [u_s0, u_f0_hz, u_delta, b, c1, c2] = u;
        Ok(ShockIdentification {
            oscillator,
            rho: oscillator.rho(),
            u_s0,
            u_f0_hz,
            u_delta,
            correlation,
            discrete: Discrete::new(&oscillator, sample_rate_hz, mapping),
            u_discrete: Discrete { b, c1, c2 },
            sample_rate_hz,
            mapping,
            mapping_formula: mapping.formula(),
            frequencies: self.bins,
            range,
            u0: self.u0,
            chi2: self.chi2,
            degrees_of_freedom: self.degrees_of_freedom,
            consistent: choice.u0.map(|_| self.is_consistent()),
            peak_ratio: f64::NAN,
            simulation_rms_rel: None,
            simulation_max_rel: None,
            warnings: Vec::new(),
        })
    }
}

/// S0, f0, delta, b, c1, c2 of a fit; NaN where it is no oscillator.
fn parameters(mu: &Vector3<f64>, sample_rate_hz: f64, mapping: Mapping) -> [f64; 6] {
    match continuous(mu, sample_rate_hz, mapping) {
        Some(o) => {
            let d = Discrete::new(&o, sample_rate_hz, mapping);
            [o.s0, o.f0_hz, o.delta, d.b, d.c1, d.c2]
        }
        None => [f64::NAN; 6],
    }
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
        .map(|(m, s)| (m - s) / peak)
        .collect();
    let squares: f64 = differences.iter().map(|d| d * d).sum();
    result.simulation_rms_rel = Some((squares / differences.len() as f64).sqrt());
    result.simulation_max_rel = Some(peak_of(&differences));
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
