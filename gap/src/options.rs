//! Options of a diagnosis.

/// Effects at a time, where nothing is stated.
const USUAL_EFFECTS: usize = 2;

/// Options of a diagnosis.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Names that must not be used.
    pub without: Vec<String>,
    /// Another dataset to score on.
    pub validate: Option<std::path::PathBuf>,
    /// Largest number of effects at a time; if none is stated, two, and for points more where two
    /// show lack of fit.
    pub most_effects: Option<usize>,
}

impl Options {
    /// Effects that are tried whatever they leave.
    pub(crate) fn usual_effects(&self) -> usize {
        self.most_effects.unwrap_or(USUAL_EFFECTS)
    }
}
