//! Round values on an axis, at three levels of fineness.

/// A value to mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where it stands.
    pub value: f64,
    /// 0: always shown; 1 and 2: where a reader zooms in, or there is room.
    pub level: u8,
    /// As short as it can be written, with a point and an ASCII minus.
    pub label: String,
}

/// Steps of a linear axis, at most; about six come out.
const STEPS: f64 = 6.0 / 0.7;
/// Ticks of 1, 2 and 5 on a logarithmic axis, at most: above, powers of ten alone.
const MOST_DECADE_TICKS: usize = 18;

/// The least of 1, 2, 5 times a power of ten that is not below `least`, which is above zero.
#[must_use]
pub fn nice_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    let enough = |factor: &f64| factor * power >= least * (1.0 - 1e-9);
    let factor = [1.0, 2.0, 5.0].into_iter().find(enough);
    factor.unwrap_or(10.0) * power
}

/// Decimals that tell multiples of a nice step apart.
#[must_use]
pub fn decimals(step: f64) -> usize {
    (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize
}

/// A multiple of `step` as text with these decimals: zero without a sign, and an
/// exponent where there would be many noughts.
#[must_use]
pub fn label(value: f64, step: f64, decimals: usize) -> String {
    let value = if value.abs() < step / 2.0 { 0.0 } else { value };
    if value == 0.0 || (value.abs() < 1e6 && step >= 1e-6) {
        return format!("{value:.decimals$}");
    }
    let digits = value.abs().log10().floor() - (step.log10() + 1e-9).floor();
    format!("{value:.*e}", digits.clamp(0.0, 12.0) as usize)
}

/// Multiples of a nice step from `low` to `high`, both finite and `low` below `high`:
/// the step, its fifth, its fiftieth.
#[must_use]
pub fn linear(low: f64, high: f64) -> Vec<Tick> {
    let coarse = nice_step((high - low) / STEPS);
    let finest = coarse / 50.0;
    let tick = |index: i64| {
        let (level, step) = match index {
            i if i % 50 == 0 => (0, coarse),
            i if i % 10 == 0 => (1, coarse / 5.0),
            _ => (2, finest),
        };
        let value = index as f64 * finest;
        // A power of ten as step gets one decimal more, as on every certificate so far.
        let label = label(value, step, decimals(0.999 * step));
        Tick {
            value,
            level,
            label,
        }
    };
    let (first, last) = ((low / finest).ceil(), (high / finest).floor());
    (first as i64..=last as i64).map(tick).collect()
}

/// 1, 2, 5 of every decade from `low` to `high`, both above zero; then every
/// whole multiple of its power of ten, then the tenths. Over many decades the
/// powers of ten stand alone at the first level.
#[must_use]
pub fn logarithmic(low: f64, high: f64) -> Vec<Tick> {
    let crowded = 3.0 * (high / low).log10() > MOST_DECADE_TICKS as f64;
    let decades = low.log10().floor() as i32..=high.log10().floor() as i32;
    let all = decades.flat_map(|decade| (10..100_u32).map(move |tenth| (decade, tenth)));
    let tick = |(decade, tenth): (i32, u32)| {
        let value = f64::from(tenth) * 10.0_f64.powi(decade) / 10.0;
        let level = match tenth {
            10 => 0,
            20 | 50 if !crowded => 0,
            _ if tenth % 10 == 0 => 1,
            _ => 2,
        };
        let label = decade_label(value);
        Tick {
            value,
            level,
            label,
        }
    };
    all.map(tick)
        .filter(|tick| (low..=high).contains(&tick.value))
        .collect()
}

/// Two digits of a decade, thousands as `k`.
fn decade_label(value: f64) -> String {
    let value = of_few_digits(value);
    match value {
        v if !(0.01..1e6).contains(&v) => format!("{v:e}"),
        v if v >= 1000.0 => format!("{}k", v / 1000.0),
        v => format!("{v}"),
    }
}

/// Hides what binary arithmetic adds to a number of few digits.
fn of_few_digits(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &[Tick], level: u8) -> Vec<&str> {
        let of_level = ticks.iter().filter(|tick| tick.level == level);
        of_level.map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn steps_are_of_the_1_2_5_series() {
        for (least, step) in [
            (0.3, 0.5),
            (1.0, 1.0),
            (0.011, 0.02),
            (6.0, 10.0),
            (2e30, 2e30),
        ] {
            assert!((nice_step(least) / step - 1.0).abs() < 1e-12, "{least}");
        }
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        let ticks = linear(9.7, 11.3);
        // 1.6 in about six steps: the nearest step of the series is 0.2.
        let coarse = [
            "9.8", "10.0", "10.2", "10.4", "10.6", "10.8", "11.0", "11.2",
        ];
        assert_eq!(labels(&ticks, 0), coarse);
        assert!(ticks.iter().all(|t| (9.7..=11.3).contains(&t.value)));
        let around_zero = ["-0.04", "-0.02", "0.00", "0.02", "0.04"];
        assert_eq!(labels(&linear(-0.05, 0.05), 0), around_zero);
    }

    /// A span holds between three and nine steps of its nice step, wherever it lies.
    #[test]
    fn ticks_are_neither_few_nor_many() {
        for exponent in -9..9 {
            for span in [1.0, 1.37, 2.2, 4.9, 7.3, 9.99] {
                let span = span * 10.0_f64.powi(exponent);
                for low in [-span / 3.0, 0.0, 7.7 * span] {
                    let ticks = linear(low, low + span);
                    let coarse = ticks.iter().filter(|tick| tick.level == 0).count();
                    assert!((3..=9).contains(&coarse), "{low} {span}: {coarse}");
                }
            }
        }
    }

    #[test]
    fn a_decade_has_one_two_and_five() {
        let ticks = logarithmic(20.0, 10_000.0);
        let first = ["20", "50", "100", "200", "500", "1k", "2k", "5k", "10k"];
        assert_eq!(labels(&ticks, 0), first);
        // 30, 40, 60 ... 90 and the same in every decade up to 9k.
        assert_eq!(labels(&ticks, 1).len(), 3 * 6);
        assert!(labels(&ticks, 2).contains(&"1.5k"));
    }

    #[test]
    fn many_decades_have_their_powers_alone() {
        let ticks = logarithmic(1e-6, 10.0);
        let powers = ["1e-6", "1e-5", "1e-4", "1e-3", "0.01", "0.1", "1", "10"];
        assert_eq!(labels(&ticks, 0), powers);
    }
}
