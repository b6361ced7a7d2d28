//! How the emulator works: fast, or plainly.

/// Variable of the environment that chooses, for programs that do not say: `plain`.
const CHOICE: &str = "CALIB_EMULATOR";

/// How an emulated board is executed. The firmware and the rig see the same either way, to the bit and
/// to the instruction: test `a_fast_run_is_the_plain_one`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Execution {
    /// Samples are taken at once, the computer's own unit calculates where it gives what the emulated
    /// one does, and translated code checks its budget once.
    Fast,
    /// One event after another, with as much of it as the published emulator does in software.
    Plain,
}

impl Execution {
    /// Execution `CALIB_EMULATOR` asks for: [`Execution::Plain`] where it says `plain`.
    #[must_use]
    pub fn asked() -> Self {
        match std::env::var(CHOICE) {
            Ok(choice) if choice == "plain" => Self::Plain,
            _ => Self::Fast,
        }
    }
}
