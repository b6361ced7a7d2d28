//! Options of a diagnosis.

/// Options of a diagnosis.
#[derive(Debug, Clone)]
pub struct Options {
    /// Names that must not be used.
    pub without: Vec<String>,
    /// Another dataset to score on.
    pub validate: Option<std::path::PathBuf>,
    /// Largest number of effects at a time.
    pub most_effects: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            without: Vec::new(),
            validate: None,
            most_effects: 2,
        }
    }
}
