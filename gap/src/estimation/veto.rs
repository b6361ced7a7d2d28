//! What data that took no part say against a set of effects.

use crate::thresholds;

/// Whether a set stands: it makes the unseen data no worse, and each of its effects helps there.
///
/// All are -2 ln likelihood of the unseen data: `here` with the set, `plain` without any effect, and
/// `without` one of its effects at a time. Where the set leaves noise on what it was fitted to, `clean`,
/// noise may have made it worse.
pub(crate) fn stands(
    here: f64,
    plain: f64,
    without: impl IntoIterator<Item = f64>,
    clean: bool,
) -> bool {
    let (worse, helps) = if clean {
        (thresholds::WORSE_BY_NOISE, -thresholds::WORSE_BY_NOISE)
    } else {
        (0.0, thresholds::PARTNER_HELPS)
    };
    here < plain + worse && without.into_iter().all(|less| here + helps < less)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 100 deviates squared, an effect that is there takes 40. One that is not may add what noise adds
    /// in a sum, 4 here; where more than noise is left it has to take some out.
    #[test]
    fn a_set_stands_that_helps_with_each_of_its_effects() {
        let alone = |here, clean| stands(here, 100.0, [], clean);
        assert!(alone(60.0, true) && alone(60.0, false));
        assert!(alone(104.0, true) && !alone(104.0, false));
        assert!(!alone(140.0, true) && !alone(f64::INFINITY, true));
        let beside = |here, clean| stands(here, 100.0, [60.0, 90.0], clean);
        assert!(beside(64.0, true) && !beside(64.0, false));
        assert!(!beside(57.0, false) && beside(50.0, false));
        assert!(!beside(80.0, true));
    }
}
