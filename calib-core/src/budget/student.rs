//! Quantiles of the normal distribution and of Student's t, in f32.

/// Two-sided quantile of Student's distribution: `|t|` stays below it with
/// probability `1 - tail`.
///
/// # Units
/// `tail` in 0..1 exclusive; `degrees_of_freedom` above 0, infinity allowed.
/// Returns `None` outside.
///
/// # Accuracy
/// 1e-5 relative from one degree of freedom on, at tails of 0.05 and 0.0455:
/// test `the_published_table_comes_out`. Degrees below 1 are taken as 1.
///
/// # Source
/// G. W. Hill, "Student's t-quantiles", Communications of the ACM 13 (1970),
/// algorithm 396.
pub fn student_quantile(tail: f32, degrees_of_freedom: f32) -> Option<f32> {
    if !(tail > 0.0 && tail < 1.0 && degrees_of_freedom > 0.0) {
        return None;
    }
    let n = degrees_of_freedom.max(1.0);
    if n >= 1.0e6 {
        return normal_quantile(1.0 - 0.5 * tail);
    }
    Some(hill(tail, n))
}

/// Hill's expansion.
fn hill(tail: f32, n: f32) -> f32 {
    if n == 1.0 {
        let angle = tail * core::f32::consts::FRAC_PI_2;
        return 1.0 / libm::tanf(angle);
    }
    if n == 2.0 {
        return libm::sqrtf(2.0 / (tail * (2.0 - tail)) - 2.0);
    }
    let a = 1.0 / (n - 0.5);
    let b = (48.0 / a) * (1.0 / a);
    let mut c = ((20_700.0 * a / b - 98.0) * a - 16.0) * a + 96.36;
    let d = ((94.5 / (b + c) - 3.0) / b + 1.0) * libm::sqrtf(a * core::f32::consts::FRAC_PI_2) * n;
    let x = d * tail;
    let mut y = libm::powf(x, 2.0 / n);
    if y > 0.05 + a {
        // Asymptotic inverse expansion about the normal quantile.
        let x = normal_quantile_lower(0.5 * tail);
        y = x * x;
        if n < 5.0 {
            c += 0.3 * (n - 4.5) * (x + 0.6);
        }
        c += (((0.05 * d * x - 5.0) * x - 7.0) * x - 2.0) * x + b;
        y = (((((0.4 * y + 6.3) * y + 36.0) * y + 94.5) / c - y - 3.0) / b + 1.0) * x;
        y = a * y * y;
        y = libm::expm1f(y);
    } else {
        y = ((1.0 / (((n + 6.0) / (n * y) - 0.089 * d - 0.822) * (n + 2.0) * 3.0)
            + 0.5 / (n + 4.0))
            * y
            - 1.0)
            * (n + 1.0)
            / (n + 2.0)
            + 1.0 / y;
    }
    libm::sqrtf(n * y)
}

/// Quantile of the standard normal distribution.
///
/// Returns `None` unless `probability` lies in 0..1 exclusive.
///
/// # Accuracy
/// 1e-6 absolute: test `normal_quantiles_are_the_published_ones`.
///
/// # Source
/// M. J. Wichura, algorithm AS 241 (PPND7), Applied Statistics 37 (1988).
pub fn normal_quantile(probability: f32) -> Option<f32> {
    if !(probability > 0.0 && probability < 1.0) {
        return None;
    }
    Some(if probability < 0.5 {
        normal_quantile_lower(probability)
    } else {
        // Exact for f32 from one half on.
        -normal_quantile_lower(1.0 - probability)
    })
}

/// Quantile for a probability of at most one half: not positive.
fn normal_quantile_lower(probability: f32) -> f32 {
    let q = probability - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180_625 - q * q;
        let numerator = ((5.910_937_4e1 * r + 1.592_911_3e2) * r + 5.043_427e1) * r + 3.387_132_7;
        let denominator = ((6.718_756e1 * r + 7.875_776e1) * r + 1.789_516_9e1) * r + 1.0;
        return q * numerator / denominator;
    }
    let r = libm::sqrtf(-libm::logf(probability));
    let value = if r <= 5.0 {
        let r = r - 1.6;
        let numerator = ((1.702_382_1e-1 * r + 1.306_728_5) * r + 2.756_815_4) * r + 1.423_437_1;
        let denominator = (1.202_113_3e-1 * r + 7.370_016_4e-1) * r + 1.0;
        numerator / denominator
    } else {
        let r = r - 5.0;
        let numerator = ((1.733_720_3e-2 * r + 4.286_829_5e-1) * r + 3.081_226_4) * r + 6.657_905;
        let denominator = (1.225_820_2e-2 * r + 2.419_789_5e-1) * r + 1.0;
        numerator / denominator
    };
    -value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_quantiles_are_the_published_ones() {
        // Tables of the normal distribution, ten digits.
        let table = [
            (0.975, 1.959_963_985),
            (0.95, 1.644_853_627),
            (0.995, 2.575_829_304),
            (0.841_344_8, 1.000_000_0),
            (0.5, 0.0),
        ];
        for (probability, expected) in table {
            let quantile = f64::from(normal_quantile(probability).expect("inside"));
            // The probability itself is rounded to f32: up to 3e-8, divided by
            // the density there (0.0145 at 0.995), 2e-6.
            assert!(
                (quantile - expected).abs() < 3.0e-6,
                "{probability}: {quantile}"
            );
        }
        for probability in [0.0, 1.0, -0.5, f32::NAN] {
            assert_eq!(normal_quantile(probability), None);
        }
    }

    #[test]
    fn the_published_table_comes_out() {
        // Table G.2 of the GUM with more digits, as recomputed by others.
        let at_95 = [
            (1.0, 12.706_2),
            (2.0, 4.302_65),
            (4.0, 2.776_45),
            (5.0, 2.570_58),
            (9.0, 2.262_16),
            (10.0, 2.228_14),
            (18.0, 2.100_92),
            (20.0, 2.085_96),
            (50.0, 2.008_56),
            (100.0, 1.983_97),
            (f32::INFINITY, 1.959_96),
        ];
        let at_95_45 = [
            (2.0, 4.526_55),
            (4.0, 2.869_32),
            (9.0, 2.319_81),
            (20.0, 2.133_03),
            (100.0, 2.025_31),
        ];
        let tail_95_45 = 1.0 - 0.954_499_7;
        let cases = at_95.map(|(n, t)| (0.05, n, t)).into_iter();
        for (tail, n, expected) in cases.chain(at_95_45.map(|(n, t)| (tail_95_45, n, t))) {
            let t = f64::from(student_quantile(tail, n).expect("inside"));
            // Printed to six digits: 5e-6 in the last place of 1.98397 is
            // 2.5e-6 relative; f32 arithmetic adds about as much.
            assert!((t / expected - 1.0).abs() < 1.0e-5, "{n}: {t} {expected}");
        }
    }

    #[test]
    fn impossible_arguments_have_no_quantile() {
        for (tail, n) in [
            (0.0, 5.0),
            (1.0, 5.0),
            (0.05, 0.0),
            (0.05, -1.0),
            (f32::NAN, 5.0),
        ] {
            assert_eq!(student_quantile(tail, n), None);
        }
        assert_eq!(student_quantile(0.05, f32::NAN), None);
    }
}
