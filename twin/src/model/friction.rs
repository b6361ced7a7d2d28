//! Dry friction over one step of time.

/// Friction over a step, N: the force that is linear in time with its mean and its first moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Mean over the step.
    pub mean_n: f64,
    /// Change from the start of the step to its end.
    pub change_n: f64,
}

/// Friction over a step.
///
/// The step starts at the velocity `start`, would end at `free` without friction, and a constant
/// force changes the end by `gain` per newton. Where the armature comes to rest and what else acts
/// on it is below the friction, it sticks.
///
/// # Equation
/// Under the full force the velocity goes linearly to rest in the share `t = v0/(v0 - free + g Fc)`
/// of the step; there the force jumps from -Fc to Fc. Its mean is `Fc (1 - 2 t)`, and the line with
/// the same first moment rises by `12 Fc t (1 - t)`.
pub fn friction(start: f64, free: f64, gain: f64, coulomb_n: f64) -> Friction {
    let sign = if start == 0.0 {
        free.signum()
    } else {
        start.signum()
    };
    // Mirrored so that the velocity starts positive.
    let (start, free) = (start.abs(), free * sign);
    let slip = gain * coulomb_n;
    let held = |mean_n| Friction {
        mean_n,
        change_n: 0.0,
    };
    if free >= slip {
        return held(-sign * coulomb_n);
    }
    if (free - start).abs() <= slip {
        return held(-sign * (free / gain).clamp(-coulomb_n, coulomb_n));
    }
    let turn = start / (start - free + slip);
    Friction {
        mean_n: sign * coulomb_n * (1.0 - 2.0 * turn),
        change_n: sign * coulomb_n * 12.0 * turn * (1.0 - turn),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moving_armature_meets_the_full_force() {
        assert_eq!(friction(1.0, 0.9, 0.1, 0.5).mean_n, -0.5);
        assert_eq!(friction(-1.0, -0.9, 0.1, 0.5).mean_n, 0.5);
    }

    #[test]
    fn an_armature_that_cannot_break_loose_sticks() {
        // 0.04 would be reached without friction, 0.05 can be held: the end is rest.
        let force = friction(0.0, 0.04, 0.1, 0.5).mean_n;
        assert!((0.04 + 0.1 * force).abs() < 1e-15);
        // Slowing down with nothing pulling: it stops, and does not turn.
        let force = friction(0.02, 0.02, 0.1, 0.5).mean_n;
        assert!((0.02 + 0.1 * force).abs() < 1e-15);
    }

    /// The step is cut in a thousand pieces, each with the sign of the velocity it begins with: mean
    /// and first moment are those of the pieces, but for the one in which it turns (1e-3 of 2 Fc).
    #[test]
    fn the_force_turns_with_the_velocity() {
        const PIECES: usize = 1000;
        let (gain, coulomb_n) = (0.1, 0.5);
        for (start, free) in [(1.0, -1.0), (0.3, -2.0), (-1.0, 0.7), (2.0, -0.1)] {
            let (mut velocity, mut mean_n, mut moment_n) = (start, 0.0, 0.0);
            for piece in 0..PIECES {
                let force_n = -coulomb_n * f64::signum(velocity);
                velocity += (free - start + gain * force_n) / PIECES as f64;
                mean_n += force_n / PIECES as f64;
                let from_middle = (piece as f64 + 0.5) / PIECES as f64 - 0.5;
                moment_n += force_n * from_middle / PIECES as f64;
            }
            let found = friction(start, free, gain, coulomb_n);
            assert!((found.mean_n - mean_n).abs() < 1e-3, "{start} {free}");
            let moment_found_n = found.change_n / 12.0;
            assert!((moment_found_n - moment_n).abs() < 1e-3, "{start} {free}");
        }
    }
}
