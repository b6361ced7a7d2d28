//! Dry friction over one step of time.

/// Mean friction force over a step, N.
///
/// The step starts at the velocity `start`, would end at `free` without friction, and a constant
/// force changes the end by `gain` per newton. Where the armature comes to rest and what else acts
/// on it is below the friction, it sticks.
///
/// # Equation
/// The mean of `sign(v)` over a velocity that goes linearly from v0 to v1 is
/// `(|v1| - |v0|)/(v1 - v0)`. With `v1 = free + gain F` and `F = -Fc mean` this is linear in v1 where
/// the sign stays, and where it changes `v1^2 - (free + v0 + g Fc) v1 + v0 (free - g Fc) = 0`.
pub fn friction_n(start: f64, free: f64, gain: f64, coulomb_n: f64) -> f64 {
    let sign = if start == 0.0 {
        free.signum()
    } else {
        start.signum()
    };
    // Mirrored so that the velocity starts positive.
    let (start, free) = (start.abs(), free * sign);
    let slip = gain * coulomb_n;
    if free >= slip {
        return -sign * coulomb_n;
    }
    if (free - start).abs() <= slip {
        return -sign * (free / gain).clamp(-coulomb_n, coulomb_n);
    }
    let half = 0.5 * (free + start + slip);
    let end = half - (half * half - start * (free - slip)).sqrt();
    sign * coulomb_n * (end + start) / (end - start)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moving_armature_meets_the_full_force() {
        assert_eq!(friction_n(1.0, 0.9, 0.1, 0.5), -0.5);
        assert_eq!(friction_n(-1.0, -0.9, 0.1, 0.5), 0.5);
    }

    #[test]
    fn an_armature_that_cannot_break_loose_sticks() {
        // 0.04 would be reached without friction, 0.05 can be held: the end is rest.
        let force = friction_n(0.0, 0.04, 0.1, 0.5);
        assert!((0.04 + 0.1 * force).abs() < 1e-15);
        // Slowing down with nothing pulling: it stops, and does not turn.
        let force = friction_n(0.02, 0.02, 0.1, 0.5);
        assert!((0.02 + 0.1 * force).abs() < 1e-15);
    }

    #[test]
    fn the_force_turns_with_the_velocity() {
        // Fc and the step are such that v goes from 1 to about -1: the mean nearly vanishes, and it
        // is consistent with the end it leads to.
        for (start, free) in [(1.0, -1.0), (0.3, -2.0), (-1.0, 0.7), (2.0, -0.1)] {
            let (gain, coulomb_n) = (0.1, 0.5);
            let force = friction_n(start, free, gain, coulomb_n);
            let end: f64 = free + gain * force;
            let mean = (end.abs() - f64::abs(start)) / (end - start);
            assert!((force + coulomb_n * mean).abs() < 1e-12, "{start} {free}");
        }
    }
}
