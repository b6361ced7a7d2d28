//! Records of an oscillator with one effect, integrated in steps so small that any rule would do.

use super::random::Random;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Samples per second.
pub(crate) const RATE_HZ: f64 = 1000.0;
const RESONANCE_HZ: f64 = 61.0;
const DAMPING: f64 = 0.03;
/// Steps per sample: the midpoint rule errs by (w0 h)^2/24 per radian, 6e-8 of the motion here.
const STEPS: usize = 320;

/// Terms added to the linear oscillator; all zero is none.
#[derive(Default, Clone)]
pub(crate) struct Added {
    pub(crate) cubic: f64,
    pub(crate) quadratic: f64,
    pub(crate) quadratic_damping: f64,
    pub(crate) cubic_damping: f64,
    pub(crate) friction: f64,
    pub(crate) delay_s: f64,
    pub(crate) saturates_at: f64,
    pub(crate) corner_hz: f64,
    pub(crate) second_gain: f64,
    pub(crate) second_hz: f64,
    pub(crate) play: f64,
    pub(crate) alpha: f64,
    pub(crate) yields_at: f64,
    /// Spring force sin(c x)/c, as of a pendulum.
    pub(crate) sine: f64,
    /// Spring force over x^5.
    pub(crate) quintic: f64,
    /// Friction at rest over that of fast sliding, less one (Stribeck); it falls with the speed w0 x 0.01.
    pub(crate) sticking: f64,
    /// Growth of the resonance in a second, relative.
    pub(crate) stiffens_per_s: f64,
    /// Displacement at the first sample of a record that nothing drives; zero is a driven one.
    pub(crate) released_at: f64,
    /// Corner of the output's low-pass.
    pub(crate) lowpass_hz: f64,
    /// Output at which its channel clips.
    pub(crate) clips_at: f64,
    /// Growth of the output's zero in a second.
    pub(crate) drift_per_s: f64,
    /// Zero of the output.
    pub(crate) zero: f64,
    /// Steady part of the input, which no one records.
    pub(crate) steady: f64,
    /// Factor on the input of the last quarter.
    pub(crate) louder: f64,
    /// Whether the input keeps its value until the next sample, as that of a converter does.
    pub(crate) holds: bool,
    /// Time at which the zero is back at its start, if it ever is: a cable was touched.
    pub(crate) snaps_back_s: f64,
}

/// An effect of a usual size by its name; the motion has an r.m.s. value near 0.1.
pub(crate) fn added(name: &str) -> Added {
    let none = Added::default();
    match name {
        "cubic_stiffness" => Added { cubic: 2.0, ..none },
        "quadratic_stiffness" => Added {
            quadratic: 0.5,
            ..none
        },
        "quadratic_damping" => Added {
            quadratic_damping: 0.15,
            ..none
        },
        "cubic_damping" => Added {
            cubic_damping: 1.0,
            ..none
        },
        "coulomb_friction" => Added {
            friction: 0.003,
            ..none
        },
        "input_delay" => Added {
            delay_s: 0.0004,
            ..none
        },
        "input_saturation" => Added {
            saturates_at: 0.08,
            ..none
        },
        "output_highpass" => Added {
            corner_hz: 1.0,
            ..none
        },
        "second_mode" => Added {
            second_gain: 0.1,
            second_hz: 143.0,
            ..none
        },
        "dead_zone" => Added { play: 0.01, ..none },
        "hysteresis" => Added {
            alpha: 0.2,
            yields_at: 0.05,
            ..none
        },
        "output_lowpass" => Added {
            lowpass_hz: 300.0,
            ..none
        },
        "output_clipping" => Added {
            clips_at: 0.2,
            ..none
        },
        "output_trend" => Added {
            drift_per_s: 0.02,
            ..none
        },
        "resonance_drift" => Added {
            stiffens_per_s: 0.01,
            ..none
        },
        other => panic!("no oscillator with {other}"),
    }
}

impl Added {
    /// Sizes that grow with their effect; all zero is none.
    fn sizes(&mut self) -> [&mut f64; 15] {
        [
            &mut self.cubic,
            &mut self.quadratic,
            &mut self.quadratic_damping,
            &mut self.cubic_damping,
            &mut self.friction,
            &mut self.delay_s,
            &mut self.corner_hz,
            &mut self.second_gain,
            &mut self.play,
            &mut self.alpha,
            &mut self.sine,
            &mut self.quintic,
            &mut self.stiffens_per_s,
            &mut self.drift_per_s,
            &mut self.sticking,
        ]
    }

    /// Limits and corners from which on there is an effect; zero is none.
    fn limits(&mut self) -> [&mut f64; 5] {
        [
            &mut self.saturates_at,
            &mut self.clips_at,
            &mut self.lowpass_hz,
            &mut self.second_hz,
            &mut self.yields_at,
        ]
    }

    /// These terms `factor` times as strong; a limit moves by its root, as nothing reaches one that is far.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        for size in self.sizes() {
            *size *= factor;
        }
        let [saturates_at, clips_at, lowpass_hz, ..] = self.limits();
        *saturates_at /= factor.powf(0.3);
        *clips_at /= factor.powf(0.3);
        *lowpass_hz /= factor;
        self
    }

    /// With the effects of another, which are none of its own.
    pub(crate) fn and(mut self, mut other: Self) -> Self {
        for (own, more) in self.sizes().into_iter().zip(other.sizes()) {
            *own += *more;
        }
        for (own, more) in self.limits().into_iter().zip(other.limits()) {
            *own += *more;
        }
        self
    }
}

/// Lines of the input: frequency, amplitude, phase.
fn lines(random: &mut Random) -> Vec<(f64, f64)> {
    (0..90)
        .map(|k| (15.0 + 2.0 * f64::from(k), TAU * random.uniform()))
        .collect()
}

/// x, v, x2, v2, z, what the high-pass of the output holds back, and what its low-pass lets through.
type State = [f64; 7];

/// The motion behind the high-pass.
fn high_passed(a: &Added, s: &State) -> f64 {
    s[0] + s[2] - if a.corner_hz > 0.0 { s[5] } else { 0.0 }
}

/// The recorded value of a state, some time into the record.
fn seen(a: &Added, s: &State, time_s: f64) -> f64 {
    let mut seen = high_passed(a, s);
    if a.lowpass_hz > 0.0 {
        seen = s[6];
    }
    let snapped = a.snaps_back_s > 0.0 && time_s > a.snaps_back_s;
    seen += a.zero + if snapped { 0.0 } else { a.drift_per_s * time_s };
    if a.clips_at > 0.0 {
        seen = seen.clamp(-a.clips_at, a.clips_at);
    }
    seen
}

fn rate(a: &Added, s: &State, input: f64, time_s: f64) -> State {
    let w0 = TAU * RESONANCE_HZ;
    let [x, v, x2, v2, z, low, late] = *s;
    let input = if a.saturates_at > 0.0 {
        input.clamp(-a.saturates_at, a.saturates_at)
    } else {
        input
    };
    let input = input + a.steady;
    let bar = if a.sine > 0.0 {
        (a.sine * x).sin() / a.sine
    } else {
        x
    };
    let spring = bar - x.clamp(-a.play, a.play)
        + a.quadratic * x * x
        + a.cubic * x.powi(3)
        + a.alpha * z
        + a.quintic * x.powi(5)
        + ((1.0 + a.stiffens_per_s * time_s).powi(2) - 1.0) * x;
    let u = v / w0;
    let loss = 2.0 * DAMPING * u
        + a.quadratic_damping * u * u.abs()
        + a.cubic_damping * u.powi(3)
        + a.friction
            * (1.0 + a.sticking * (-(u / 0.01).powi(2)).exp())
            * (u / 1e-5).clamp(-1.0, 1.0);
    let slip = if a.yields_at > 0.0 {
        (v.abs() * z + v * z.abs()) / (2.0 * a.yields_at)
    } else {
        v
    };
    let w2 = TAU * a.second_hz;
    [
        v,
        w0 * w0 * (input - spring - loss),
        v2,
        w0 * w0 * a.second_gain * input - 0.04 * w2 * v2 - w2 * w2 * x2,
        v - slip,
        TAU * a.corner_hz * (x + x2 - low),
        TAU * a.lowpass_hz * (high_passed(a, s) - late),
    ]
}

/// `record.csv` of a settled motion.
pub(crate) fn record(a: &Added, samples: usize, random: &mut Random) -> String {
    record_with(a, samples, 1e-5, random)
}

/// `record.csv` with another noise of the output.
pub(crate) fn record_with(a: &Added, samples: usize, noise: f64, random: &mut Random) -> String {
    let lines = lines(random);
    let input = |t: f64| -> f64 {
        lines
            .iter()
            .map(|(f, p)| 0.006 * (TAU * f * t + p).cos())
            .sum()
    };
    let settle = if a.released_at == 0.0 { 600 } else { 0 };
    let h = 1.0 / RATE_HZ / STEPS as f64;
    let last_quarter_s = (settle + samples * 3 / 4) as f64 / RATE_HZ;
    let input = |t: f64| match (a.released_at != 0.0, a.louder > 0.0 && t > last_quarter_s) {
        (true, _) => 0.0,
        (_, true) => a.louder * input(t),
        (_, false) => input(t),
    };
    let mut s = State::default();
    s[0] = a.released_at;
    let mut text = String::from("time_s,input,output\n");
    for n in 0..settle + samples {
        let t = n as f64 / RATE_HZ;
        if n >= settle {
            let time_s = (n - settle) as f64 / RATE_HZ;
            let noisy = seen(a, &s, time_s) + noise * random.normal();
            let _ = writeln!(text, "{time_s:.6},{:.9e},{noisy:.9e}", input(t));
        }
        // Between the samples the input is followed on a parabola through three points: 2e-7 of it.
        let grid: [f64; 9] = std::array::from_fn(|i| {
            let later_s = if a.holds {
                0.0
            } else {
                i as f64 / 8.0 / RATE_HZ
            };
            input(t + later_s - a.delay_s)
        });
        for step in 0..STEPS {
            let place = 8.0 * (step as f64 + 0.5) / STEPS as f64;
            let at = (place.round() as usize).clamp(1, 7);
            let d = place - at as f64;
            let (l, m, r) = (grid[at - 1], grid[at], grid[at + 1]);
            let u = m + 0.5 * d * (r - l) + 0.5 * d * d * (l - 2.0 * m + r);
            let time_s = (n - settle.min(n)) as f64 / RATE_HZ + (step as f64 + 0.5) * h;
            let k = rate(a, &s, u, time_s);
            let half: State = std::array::from_fn(|i| s[i] + 0.5 * h * k[i]);
            let k = rate(a, &half, u, time_s);
            s = std::array::from_fn(|i| s[i] + h * k[i]);
        }
    }
    text
}

/// `rig.toml` of it.
pub(crate) const RIG: &str = "kind = \"oscillator\"\n[oscillator]\nresonance_hz = { value = 63.0, u = 3.0 }\ndelta = { value = 0.025, u = 0.01 }\n";
