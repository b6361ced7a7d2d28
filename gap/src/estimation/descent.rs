//! Least squares by Levenberg and Marquardt: one loop for whatever can be fitted.

use super::tangent::Equations;
use crate::thresholds;
use nalgebra::DVector;

/// Free values of a fit: parameters with their bounds, and the data they are to describe.
pub(crate) trait LeastSquares {
    /// Values of the parameters, and what is known of the model there.
    type State;

    /// -2 ln of the posterior density, up to a constant.
    fn objective(&self, at: &Self::State) -> f64;

    /// Part of it that noise does not leave.
    fn beyond_noise(&self, at: &Self::State) -> f64 {
        self.objective(at)
    }

    /// Gain of the objective where so much is taken of the sum of squares.
    fn gain(&self, _at: &Self::State, square: f64) -> f64 {
        square
    }

    /// Normal equations of the next step; none where the model has no slopes.
    fn equations(&mut self, at: &Self::State) -> Option<Equations>;

    /// The state a step further, within the bounds of the parameters; none where the model
    /// diverges.
    fn moved(&mut self, from: &Self::State, step: &DVector<f64>) -> Option<Self::State>;
}

/// How far a fit goes, and how boldly.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    pub(crate) most_steps: usize,
    /// Objective that has to be reached in the first [`thresholds::GLANCE`] steps.
    pub(crate) within: f64,
    /// Gain of the objective below which a step is small.
    pub(crate) enough: f64,
    /// That gain as a share of what noise does not leave: nothing shows it beside that.
    pub(crate) share: f64,
    /// Small steps in a row that end the fit.
    pub(crate) small_steps: usize,
    /// Damping of the first step.
    pub(crate) damping: f64,
    /// Factor on a damping below [`DAMPED`] after a step that did not help.
    pub(crate) leap: f64,
}

/// Damping from which the factor after a step that did not help is ten.
const DAMPED: f64 = 1e-2;
/// Least damping.
const LEAST: f64 = 1e-9;

/// Damped steps until the objective stands still: the last state, and the last equations on
/// the way. None where the start has no slopes.
pub(crate) fn descend<M: LeastSquares>(
    model: &mut M,
    start: M::State,
    effort: Effort,
) -> Option<(M::State, Equations)> {
    let (mut here, mut damping) = (start, effort.damping);
    let mut equations = model.equations(&here)?;
    let mut small = 0;
    for taken in 0..effort.most_steps {
        if taken == thresholds::GLANCE && model.objective(&here) >= effort.within {
            break;
        }
        let Some(step) = equations.step(damping) else {
            damping *= 10.0;
            continue;
        };
        let before = model.objective(&here);
        let worth = effort.enough.max(effort.share * model.beyond_noise(&here));
        let predicted = model.gain(&here, equations.predicted(&step));
        let there = model.moved(&here, &step);
        match there.filter(|there| model.objective(there) < before) {
            Some(there) => {
                let gain = before - model.objective(&there);
                here = there;
                damping = (damping * 0.1).max(LEAST);
                small = if gain < worth { small + 1 } else { 0 };
                if small == effort.small_steps {
                    break;
                }
                equations = model.equations(&here)?;
            }
            // A step damped more is predicted to gain less still.
            None if predicted < worth => break,
            None if damping < DAMPED => damping *= effort.leap,
            None => damping *= 10.0,
        }
    }
    Some((here, equations))
}

#[cfg(test)]
mod tests {
    use super::super::column::{Column, OneBlock};
    use super::*;

    /// exp(-rate t) at some times.
    struct Decay {
        times: Vec<f64>,
        measured: Vec<f64>,
        steps_tried: usize,
    }

    impl Decay {
        fn residual(&self, rate: f64) -> Vec<f64> {
            let data = self.times.iter().zip(&self.measured);
            data.map(|(t, m)| m - (-rate * t).exp()).collect()
        }
    }

    impl LeastSquares for Decay {
        type State = f64;

        fn objective(&self, rate: &f64) -> f64 {
            self.residual(*rate).iter().map(|r| r * r).sum()
        }

        fn equations(&mut self, rate: &f64) -> Option<Equations> {
            let slope = self.times.iter().map(|t| -t * (-rate * t).exp());
            let columns = [Column::of_one_block(slope.collect())];
            let (block, residual) = (OneBlock(self.times.len()), self.residual(*rate));
            Some(Equations::new(&block, &columns, &[], &residual, &[]))
        }

        fn moved(&mut self, rate: &f64, step: &DVector<f64>) -> Option<f64> {
            self.steps_tried += 1;
            Some((rate + step[0]).clamp(0.0, 4.0))
        }
    }

    fn decay(rate: f64) -> Decay {
        let times: Vec<f64> = (0..20).map(|n| 0.1 * f64::from(n)).collect();
        Decay {
            measured: times.iter().map(|t| (-rate * t).exp()).collect(),
            times,
            steps_tried: 0,
        }
    }

    const EFFORT: Effort = Effort {
        most_steps: 40,
        within: f64::INFINITY,
        enough: 1e-20,
        share: 0.0,
        small_steps: 2,
        damping: 1e-4,
        leap: 100.0,
    };

    /// Data without noise have the rate they were made with; outside of its bounds the nearest one
    /// describes them best.
    #[test]
    fn a_rate_is_found_within_its_bounds() {
        for (rate, expected) in [(1.5, 1.5), (5.0, 4.0)] {
            let found = descend(&mut decay(rate), 0.1, EFFORT).expect("it has slopes");
            assert!((found.0 - expected).abs() < 1e-8, "{rate}: {}", found.0);
        }
    }

    /// Where the best rate is known to its last digit no step helps, and none promises anything: eleven were tried
    /// with ever more damping.
    #[test]
    fn where_no_gain_is_predicted_no_step_is_damped() {
        let mut decay = decay(1.5);
        let disturbed = decay.measured.iter_mut().enumerate();
        disturbed.for_each(|(n, m)| *m += 0.1 * ((n % 3) as f64).sin());
        let mut rate = 1.5;
        for _ in 0..5 {
            (rate, _) = descend(&mut decay, rate, EFFORT).expect("it has slopes");
        }
        decay.steps_tried = 0;
        let enough = Effort {
            enough: 1e-9,
            ..EFFORT
        };
        descend(&mut decay, rate, enough).expect("it has slopes");
        assert!(decay.steps_tried <= 2, "{}", decay.steps_tried);
    }

    /// A fit out of reach gets a few steps, one within reach as many as it needs, without a second start.
    #[test]
    fn a_fit_out_of_reach_ends_at_a_glance() {
        for (within, goes_on) in [(0.0, false), (1e9, true)] {
            let mut decay = decay(3.9);
            // From afar, by small steps.
            let effort = Effort {
                damping: 30.0,
                within,
                ..EFFORT
            };
            descend(&mut decay, 0.0, effort).expect("it has slopes");
            assert_eq!(
                decay.steps_tried > thresholds::GLANCE,
                goes_on,
                "{}",
                decay.steps_tried
            );
            assert!(decay.steps_tried >= thresholds::GLANCE);
        }
    }
}
