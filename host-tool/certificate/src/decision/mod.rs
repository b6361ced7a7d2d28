//! Statements of conformity: tolerances, decision rules and their risks.
//!
//! | file | idea |
//! |---|---|
//! | `request` | what a file asks for |
//! | [`specification`] | what is tolerated, over frequency |
//! | [`rule`] | how a result with its uncertainty is judged |
//! | `tolerance` | that of a sensor, as text |
//! | `stored` | that of a list kept on an instrument |
//! | [`risk`] | probabilities of false acceptance and rejection |
//!
//! ISO/IEC 17025 7.8.6 wants three things said: which results, which
//! specification, which rule. All three come from a [`Request`].

mod limits;
mod request;
pub mod risk;
pub mod rule;
pub mod specification;
mod stored;
mod tolerance;

use crate::kind::{SensitivityUnit, Specified};
pub use calib_core::conformity::Conformity;
pub use limits::{Band, Base, Limits};
pub use request::{Request, RuleName};
pub use rule::{Assessment, Rule, Stated, assess};
pub use specification::{Place, Specification};
pub use tolerance::Tolerance;

/// Specification and rule, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// Tolerance.
    pub specification: Specification,
    /// How results are judged.
    pub rule: Rule,
}

impl Request {
    /// Checks the request.
    ///
    /// # Errors
    /// A sentence that names what is missing or makes no sense.
    pub fn build(&self) -> Result<Decision, String> {
        Ok(Decision {
            specification: Specification::build(self)?,
            rule: Rule::build(self)?,
        })
    }

    /// Checks what does not depend on the device under test: its nominal
    /// sensitivity may come from another file, or from the logbook.
    ///
    /// # Errors
    /// As [`Self::build`].
    pub fn check(&self) -> Result<(), String> {
        let mut request = self.clone();
        request.know_nominal(Specified::of_si(1.0, SensitivityUnit::default()));
        request.build().map(drop)
    }
}
