//! Do the expanded uncertainties hold the truth in 95 of 100 cases?
//!
//! Each mode is simulated from its physics: systematic errors drawn once per
//! calibration from their stated distributions, readings with noise; then the
//! calibration is evaluated as a user would, and the truth is looked for.

use calib_metrology::budget::{self, Budget, Component, CoverageRule, Distribution, Model, Unit};
use calib_metrology::monte_carlo::Lanes;
use calib_metrology::statistics::{mean, standard_deviation};

const RUNS: usize = 2000;
const NORMAL_K2: Distribution = Distribution::Normal {
    coverage_factor: 2.0,
};
const STANDARD: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};

/// Random numbers one by one.
struct Draws {
    lanes: Lanes,
}

impl Draws {
    fn normal(&mut self) -> f64 {
        let mut one = [0.0];
        self.lanes.fill_normal(&mut one);
        one[0]
    }

    fn rectangular(&mut self, half: f64) -> f64 {
        let mut one = [0.0];
        self.lanes.fill_uniform(&mut one);
        half * (2.0 * one[0] - 1.0)
    }

    /// The error of a component, in its unit.
    fn error(&mut self, component: &Component) -> f64 {
        match component.distribution {
            Distribution::Rectangular => self.rectangular(component.value),
            _ => component.standard_uncertainty() * self.normal(),
        }
    }
}

fn component(label: &str, value: f64, distribution: Distribution) -> Component {
    Component {
        label: label.into(),
        value,
        distribution,
        sensitivity_coefficient: 1.0,
        degrees_of_freedom: f64::INFINITY,
    }
}

fn residual(readings: &[f64]) -> Component {
    let n = readings.len() as f64;
    Component {
        degrees_of_freedom: n - 1.0,
        ..component(
            "readings",
            standard_deviation(readings) / n.sqrt(),
            STANDARD,
        )
    }
}

fn expanded(unit: Unit, mut components: Vec<Component>, readings: &[f64]) -> f64 {
    components.push(residual(readings));
    let budget = Budget {
        measurand: "simulated".into(),
        unit,
        model: Model::Product,
        coverage: CoverageRule::Probability(0.95),
        truncate_degrees_of_freedom: false,
        components,
        correlations: Vec::new(),
        remarks: Vec::new(),
    };
    budget::evaluate(&budget).expanded_uncertainty
}

/// Error of the mean in percent, and the expanded uncertainty stated for it.
fn relative(components: &[Component], readings: &[f64], truth: f64) -> (f64, f64) {
    let mean = mean(readings);
    let percent: Vec<f64> = readings.iter().map(|s| 100.0 * s / mean).collect();
    let error = 100.0 * (mean / truth - 1.0);
    let stated = expanded(Unit::Percent, components.to_vec(), &percent);
    (error, stated)
}

/// Counts runs in which `calibrate` returns an error within its uncertainty.
fn assert_covers(seed: u64, mut calibrate: impl FnMut(&mut Draws) -> (f64, f64)) {
    let mut draws = Draws {
        lanes: Lanes::new(seed, 0),
    };
    let covered = (0..RUNS)
        .filter(|_| {
            let (error, expanded) = calibrate(&mut draws);
            error.abs() <= expanded
        })
        .count();
    let percent = 100.0 * covered as f64 / RUNS as f64;
    // The binomial deviation of 2000 runs is 0.49 %: 1.5 % are three of them.
    assert!((percent - 95.0).abs() <= 1.5, "{percent} %");
}

#[test]
fn comparison_covers_the_truth() {
    let components = vec![
        component("reference", 0.5, NORMAL_K2),
        component("gain", 0.25, Distribution::Rectangular),
        component("ratio", 0.2, Distribution::Rectangular),
        component("temperature", 0.36, Distribution::Rectangular),
    ];
    assert_covers(1, |draws| {
        let truth = 0.0125;
        let factor: f64 = components
            .iter()
            .map(|c| 1.0 + draws.error(c) / 100.0)
            .product();
        let readings: Vec<f64> = (0..5)
            .map(|_| truth * factor * (1.0 + 0.004 * draws.normal()))
            .collect();
        relative(&components, &readings, truth)
    });
}

#[test]
fn calibrator_covers_the_truth() {
    let components = vec![
        component("level of the calibrator", 1.5, NORMAL_K2),
        component("voltmeter", 0.6, Distribution::Rectangular),
    ];
    assert_covers(2, |draws| {
        let truth = 0.100;
        // S = X / A with the specified A; the true level is off.
        let level = 10.0 * (1.0 + draws.error(&components[0]) / 100.0);
        let scale = 1.0 + draws.error(&components[1]) / 100.0;
        let readings: Vec<f64> = (0..4)
            .map(|_| truth * level * scale * (1.0 + 0.005 * draws.normal()) / 10.0)
            .collect();
        relative(&components, &readings, truth)
    });
}

#[test]
fn consecutive_measurement_covers_the_truth() {
    let components = vec![
        component("reference", 0.8, NORMAL_K2),
        component("linearity of the voltmeter", 0.3, Distribution::Rectangular),
    ];
    assert_covers(3, |draws| {
        let (truth, reference) = (0.010, 0.0125);
        let systematic: f64 = components
            .iter()
            .map(|c| 1.0 + draws.error(c) / 100.0)
            .product();
        // The level drifts linearly: before and after average it out.
        let drift = draws.rectangular(0.003);
        let readings: Vec<f64> = (0..5)
            .map(|_| {
                let noise = |draws: &mut Draws| 1.0 + 0.002 * draws.normal();
                let before = reference * 10.0 * noise(draws);
                let dut = truth * 10.0 * (1.0 + drift) * noise(draws);
                let after = reference * 10.0 * (1.0 + 2.0 * drift) * noise(draws);
                reference * systematic * dut / (0.5 * (before + after))
            })
            .collect();
        relative(&components, &readings, truth)
    });
}

#[test]
fn phase_covers_the_truth() {
    let components = vec![
        component("reference", 0.5, NORMAL_K2),
        component("phase measurement", 0.2, Distribution::Rectangular),
        component("amplifier", 0.3, Distribution::Rectangular),
    ];
    assert_covers(4, |draws| {
        let truth_deg = -3.2;
        let systematic: f64 = components.iter().map(|c| draws.error(c)).sum();
        let readings: Vec<f64> = (0..4)
            .map(|_| truth_deg + systematic + 0.3 * draws.normal())
            .collect();
        let error = mean(&readings) - truth_deg;
        (error, expanded(Unit::Degree, components.clone(), &readings))
    });
}
