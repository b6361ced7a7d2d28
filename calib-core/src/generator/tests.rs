//! The generator's codes against the ideal sine, in f64.

use super::*;
use crate::preferred::PREFERRED_HZ;

const RATE_HZ: f32 = 50_000.0;
const TWELVE_BITS: Width = Width::of_bits(12);
const TAU: f64 = std::f64::consts::TAU;

fn tone(hz: f32) -> Tone {
    Tone::nearest(hz, RATE_HZ).expect("a tone")
}

/// A generator playing `peak_codes`, its ramp over, at a known sample.
fn playing(tone: Tone, peak_codes: f32) -> (Generator, u64) {
    let mut generator = Generator::new(TWELVE_BITS, 2048.0, 7);
    generator.set(Drive {
        tone,
        peak_v: peak_codes,
    });
    let ramp = ramp_samples(tone);
    let mut codes = vec![0; usize::from(ramp)];
    generator.fill(&mut codes);
    (generator, u64::from(ramp))
}

/// Complex peak amplitude of the codes by correlation over whole periods.
fn fundamental(tone: Tone, first: u64, codes: &[u16]) -> (f64, f64) {
    let (mut re, mut im) = (0.0, 0.0);
    for (n, code) in (first..).zip(codes) {
        let place = (u64::from(tone.cycles) * n) % u64::from(tone.period_samples);
        let angle = TAU * place as f64 / f64::from(tone.period_samples);
        let value = f64::from(*code) - 2048.0;
        re += value * angle.cos();
        im += value * angle.sin();
    }
    let scale = 2.0 / codes.len() as f64;
    (re * scale, im * scale)
}

#[test]
fn amplitude_is_finer_than_a_code() {
    for hz in PREFERRED_HZ {
        let tone = tone(hz);
        for peak in [1.03, 3.37, 20.6, 400.123, 2_000.7] {
            let (mut generator, first) = playing(tone, peak);
            // About 1 s, whole periods.
            let samples = (50_000_usize).next_multiple_of(tone.period_samples.into());
            let mut codes = vec![0; samples];
            generator.fill(&mut codes);
            let (re, im) = fundamental(tone, first, &codes);
            // Where the shaper is a plain difference the error at the tone is
            // below 2 sin(pi / 50) = 0.126 of white noise with a variance of
            // 1/12 (rounding) and 1/12 (dither): 0.126 sqrt(2/6) sqrt(2/50 000)
            // = 4.6e-4 codes; 4 sigma, 0.0019 codes. With its zero on the tone
            // the error of N samples is a telescoping sum: at most two errors
            // of a code, 4 / 50 000.
            let tolerance = 0.002;
            assert!(
                (im - f64::from(peak)).abs() < tolerance,
                "{hz} Hz {peak}: {im}"
            );
            assert!(re.abs() < tolerance, "{hz} Hz {peak}: {re}");
        }
    }
}

#[test]
fn silence_is_mid_scale() {
    let mut generator = Generator::new(TWELVE_BITS, 10.0, 0);
    let mut codes = [0; 1000];
    generator.fill(&mut codes);
    assert!(generator.is_silent() && codes.iter().all(|code| *code == TWELVE_BITS.mid_code()));
    let drive = Drive {
        tone: tone(160.0),
        peak_v: 5.0,
    };
    generator.set(drive);
    generator.fill(&mut codes);
    assert!(!generator.is_silent());
    generator.mute();
    generator.fill(&mut codes);
    assert!(generator.is_silent() && codes.iter().all(|code| *code == TWELVE_BITS.mid_code()));
}

#[test]
fn amplitudes_and_tones_change_without_a_step() {
    let mut generator = Generator::new(TWELVE_BITS, 10.0, 3);
    let mut last = f64::from(TWELVE_BITS.mid_code());
    let mut before_hz = 0.0;
    let schedule = [
        (160.0, 1.0),
        (160.0, 6.0),
        (160.0, 0.5),
        (1000.0, 4.0),
        (20.0, 8.0),
        (20.0, 0.0),
    ];
    for (hz, peak_v) in schedule {
        let tone = tone(hz);
        generator.set(Drive { tone, peak_v });
        let mut codes = vec![0; 6_000];
        generator.fill(&mut codes);
        // Fastest sine in play is 1000 Hz at 4 V: 820 codes * 2 pi / 50 = 103
        // codes a sample; 160 Hz at 6 V 25; ramps of up to 8 V in 500 samples
        // add 1.5 * 1640 / 500 = 5, shaped rounding and dither 4.
        // A tone before this one ramps down first.
        let steepest = if hz == 1000.0 || before_hz == 1000.0 {
            112.0
        } else {
            34.0
        };
        before_hz = hz;
        for code in codes {
            let step = (f64::from(code) - last).abs();
            assert!(step < steepest, "{hz} Hz: {step}");
            last = f64::from(code);
        }
    }
    assert!(generator.is_silent());
}

#[test]
fn a_new_tone_waits_for_silence() {
    let mut generator = Generator::new(TWELVE_BITS, 10.0, 3);
    generator.set(Drive {
        tone: tone(160.0),
        peak_v: 5.0,
    });
    let mut codes = vec![0; 2_000];
    generator.fill(&mut codes);
    let other = tone(1000.0);
    generator.set(Drive {
        tone: other,
        peak_v: 5.0,
    });
    // 500 samples down, then up again: at the border only the shaped rounding.
    let mut codes = vec![0; 500];
    generator.fill(&mut codes);
    let mut border = [0; 4];
    generator.fill(&mut border);
    assert!(
        border
            .iter()
            .all(|code| code.abs_diff(TWELVE_BITS.mid_code()) < 8),
        "{border:?}"
    );
    let mut codes = vec![0; 500 * 20];
    generator.fill(&mut codes);
    // From sample 504 of the new tone on: past its ramp.
    let steady = &codes[1_000..6_000];
    let (re, im) = fundamental(other, 1_004, steady);
    assert!((re.hypot(im) / 1024.0 - 1.0).abs() < 1.0e-4);
}

#[test]
fn impossible_amplitudes_are_bounded() {
    for peak_v in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let mut generator = Generator::new(TWELVE_BITS, 10.0, 3);
        generator.set(Drive {
            tone: tone(160.0),
            peak_v,
        });
        assert!(generator.is_silent());
    }
    let mut generator = Generator::new(TWELVE_BITS, 10.0, 3);
    generator.set(Drive {
        tone: tone(160.0),
        peak_v: 1.0e9,
    });
    let mut codes = vec![0; 10_000];
    generator.fill(&mut codes);
    assert!(codes.iter().all(|code| *code <= 4095));
    assert!(codes.iter().any(|code| *code > 4085));
}

#[test]
fn another_width_has_its_own_middle_and_ends() {
    // 10 bits: codes 0 to 1023 about 512; 5 V of 10 V are 256 codes.
    let mut generator = Generator::new(Width::of_bits(10), 10.0, 3);
    let mut codes = vec![0; 10_000];
    generator.fill(&mut codes);
    assert!(codes.iter().all(|code| *code == 512));
    let tone = tone(160.0);
    for (peak_v, peak_codes) in [(5.0, 256), (1.0e9, 510)] {
        generator.set(Drive { tone, peak_v });
        generator.fill(&mut codes);
        let steady = &codes[codes.len() / 2..];
        let peak = steady.iter().map(|code| code.abs_diff(512)).max();
        // Dither and shaped error add a code or two.
        assert!(
            peak.is_some_and(|peak| peak.abs_diff(peak_codes) <= 3),
            "{peak:?}"
        );
        assert!(codes.iter().all(|code| *code <= 1023));
    }
}

#[test]
fn the_phase_never_drifts() {
    // 95 s of 31.5 Hz; an accumulated f32 phase would be off by 1e-3.
    let tone = tone(31.5);
    let (mut generator, mut n) = playing(tone, 1_000.0);
    let mut codes = vec![0; tone.period_samples.into()];
    for _ in 0..1_000 {
        generator.fill(&mut codes);
        n += codes.len() as u64;
    }
    let (re, im) = fundamental(tone, n - codes.len() as u64, &codes);
    // 4762 samples: shaped noise as above, 4 sigma 0.006 codes of 1000.
    assert!((re / im).abs() < 1.0e-5, "{re} {im}");
}
