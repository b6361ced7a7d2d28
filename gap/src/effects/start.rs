//! Where a fit starts.

/// A start: members whose changes of the prediction span the screening fit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Start {
    /// Parameter vectors, physical values.
    pub(crate) members: Vec<Vec<f64>>,
    /// Parameter that scales the change, if one does.
    pub(crate) amplitude: Option<usize>,
    /// The amplitude may change its sign.
    pub(crate) signed: bool,
}

impl Start {
    /// A shape whose size is not free.
    pub(crate) fn shape(parameters: Vec<f64>) -> Self {
        Self {
            members: vec![parameters],
            amplitude: None,
            signed: false,
        }
    }

    /// A shape with a factor of either sign.
    pub(crate) fn signed(parameters: Vec<f64>, amplitude: usize) -> Self {
        Self {
            members: vec![parameters],
            amplitude: Some(amplitude),
            signed: true,
        }
    }

    /// A shape with a positive factor.
    pub(crate) fn positive(parameters: Vec<f64>, amplitude: usize) -> Self {
        Self {
            members: vec![parameters],
            amplitude: Some(amplitude),
            signed: false,
        }
    }

    /// The first member with its amplitude multiplied.
    pub(crate) fn scaled(&self, factor: f64) -> Vec<f64> {
        let mut parameters = self.members[0].clone();
        if let Some(index) = self.amplitude {
            parameters[index] *= factor;
        }
        parameters
    }
}

/// `count` values from `low` to `high` in equal ratios.
pub(crate) fn ratios(low: f64, high: f64, count: usize) -> Vec<f64> {
    (0..count)
        .map(|i| low * (high / low).powf(i as f64 / (count - 1).max(1) as f64))
        .collect()
}
