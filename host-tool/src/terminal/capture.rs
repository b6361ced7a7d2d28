//! A capture on one screen: both channels in numbers, and their spectra.

use calib_link::capture::{Capture, Channel, Report, ToneFit, Window, spectrum};
use calib_plot::{Plot, Point, Scale};
use std::fmt::Write;

/// Rows of a spectrum.
const ROWS: usize = 8;
/// Columns of the values of one channel.
const COLUMN: usize = 27;

/// The capture in words, as a table and as spectra, `width` columns wide.
pub fn show(capture: &Capture, report: &Report, width: usize) -> String {
    let mut text = format!(
        "{} samples of both channels, {:.1} ms from sample {} on\n\n",
        report.pairs,
        1000.0 * report.duration_s,
        report.first_index
    );
    text += &table(report);
    for (name, volts) in [
        ("reference", &capture.reference_v),
        ("device under test", &capture.dut_v),
    ] {
        text += &drawn(name, volts, capture.sample_rate_hz, width);
    }
    text
}

/// One row per quantity, one column per channel.
fn table(report: &Report) -> String {
    let channels = [&report.reference, &report.dut];
    let mut text = row("", ["reference", "device under test"].map(str::to_owned));
    let dc = channels.map(|channel| millivolt(channel.dc_v, "mV"));
    text += &row("d.c.", dc);
    match [&report.reference.tone, &report.dut.tone] {
        [Some(reference), Some(dut)] => text += &tones([reference, dut]),
        _ => text += &unknown(channels),
    }
    if report.reference.clipped || report.dut.clipped {
        let word = |channel: &Channel| if channel.clipped { "CLIPPED" } else { "" };
        text += &row("range", channels.map(word).map(str::to_owned));
    }
    if let (Some(ratio), Some(phase_rad)) = (report.ratio, report.phase_rad) {
        let phase_deg = phase_rad.to_degrees();
        let _ = writeln!(
            text,
            "\ndevice under test over reference: {ratio:.6}, {phase_deg:+.3} deg"
        );
    }
    text
}

fn tones(tones: [&ToneFit; 2]) -> String {
    let name = format!("{:.7} Hz", tones[0].frequency_hz);
    let mut text = row(&name, tones.map(|tone| millivolt(tone.rms_v, "mV r.m.s.")));
    // Both channels have the same frequency, so the same harmonics.
    let harmonics = tones[0].harmonics.iter().zip(&tones[1].harmonics);
    for (reference, dut) in harmonics {
        let cells = [reference, dut].map(|harmonic| {
            let percent = 100.0 * harmonic.amplitude_rel;
            // Below twice its uncertainty a harmonic is not told from noise, and
            // its phase is none.
            match harmonic.amplitude_rel > 2.0 * harmonic.standard_uncertainty_rel {
                true => format!(
                    "{percent:.4} % {:+8.2} deg",
                    harmonic.phase_rad.to_degrees()
                ),
                false => format!("{percent:.4} %      (noise)"),
            }
        });
        text += &row(&format!("harmonic {}", reference.order), cells);
    }
    let distortion =
        tones.map(|tone| format!("{:.4} %             ", 100.0 * tone.distortion_rel()));
    text += &row("distortion", distortion);
    let noise = tones.map(|tone| millivolt(tone.noise_rms_v, "mV r.m.s."));
    text += &row("noise", noise);
    let ratio = tones.map(|tone| format!("{:.1} dB       ", tone.signal_to_noise_db()));
    text + &row("signal to noise", ratio)
}

/// Where no frequency is known: the rest as a whole, and where it lies.
fn unknown(channels: [&Channel; 2]) -> String {
    let mut text = row(
        "all but d.c.",
        channels.map(|c| millivolt(c.ac_rms_v, "mV r.m.s.")),
    );
    let count = channels.map(|c| c.peaks.len()).into_iter().max();
    for index in 0..count.unwrap_or(0) {
        let cells = channels.map(|channel| {
            channel.peaks.get(index).map_or_else(String::new, |peak| {
                format!(
                    "{:.0} Hz  {}",
                    peak.frequency_hz,
                    millivolt(peak.rms_v, "mV r.m.s.")
                )
            })
        });
        text += &row(if index == 0 { "highest lines" } else { "" }, cells);
    }
    text
}

fn row(name: &str, cells: [String; 2]) -> String {
    let [reference, dut] = cells;
    let line = format!("{name:<16}{reference:>COLUMN$}  {dut:>COLUMN$}");
    format!("{}\n", line.trim_end())
}

fn millivolt(volt: f64, unit: &str) -> String {
    format!("{:.4} {unit:<9}", 1000.0 * volt)
}

/// The spectrum in dB over 1 V r.m.s.: in each column its highest line.
fn drawn(name: &str, volts: &[f64], sample_rate_hz: f64, width: usize) -> String {
    let spectrum = spectrum(volts, sample_rate_hz, Window::Hann);
    let lines = spectrum.rms_v.len();
    let mut points: Vec<Point> = Vec::new();
    let columns = width.saturating_sub(11).max(1);
    let decades = (lines as f64).log10().max(f64::MIN_POSITIVE);
    let mut last = None;
    for line in 1..lines {
        let column = ((line as f64).log10() / decades * columns as f64) as usize;
        let db = 20.0 * spectrum.rms_v[line].max(1e-9).log10();
        let point = Point::new(spectrum.frequency_hz(line), db);
        match points.last_mut() {
            Some(highest) if last == Some(column) => {
                if point.y > highest.y {
                    *highest = point;
                }
            }
            _ => points.push(point),
        }
        last = Some(column);
    }
    // A handful of samples has no spectrum worth drawing: then this is empty.
    let caption = format!("\n{name}, dB over 1 V r.m.s.");
    Plot::spanning(caption, Scale::Logarithmic, "Hz", points).terminal(width, ROWS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    /// 500 Hz in 10 ms: whole cycles, so every number is exact.
    fn capture() -> Capture {
        let wave = |second: f64, phase_rad: f64, dc_v: f64| {
            let at = |index: i32| {
                let turn_rad = TAU * f64::from(index) / 100.0 + phase_rad;
                let tone = turn_rad.cos() + second * (2.0 * turn_rad + 0.5 * PI).cos();
                dc_v + 2_f64.sqrt() * 0.1 * tone
            };
            (0..500).map(at).collect()
        };
        Capture {
            first_index: 12_500,
            sample_rate_hz: 50_000.0,
            reference_v: wave(0.0, 0.0, 0.001),
            dut_v: wave(0.02, PI / 180.0, -0.002),
            reference_clipped: false,
            dut_clipped: true,
        }
    }

    #[test]
    fn both_channels_stand_side_by_side() {
        let capture = capture();
        let report = Report::new(&capture, Some(500.0)).expect("fits");
        let shown = show(&capture, &report, 80);
        let lines: Vec<&str> = shown.lines().take(7).collect();
        assert_eq!(
            lines[..5],
            [
                "500 samples of both channels, 10.0 ms from sample 12500 on",
                "",
                "                                  reference            device under test",
                "d.c.                       1.0000 mV                   -2.0000 mV",
                "500.0000000 Hz           100.0000 mV r.m.s.           100.0000 mV r.m.s.",
            ],
            "{shown}"
        );
        // The reference's harmonic is rounding alone.
        assert!(lines[5].ends_with("2.0000 %   +90.00 deg"), "{shown}");
        assert!(shown.contains("CLIPPED"), "{shown}");
        let ratio = "device under test over reference: 1.000000, +1.000 deg";
        assert!(shown.contains(ratio), "{shown}");
        assert!(
            shown.lines().all(|line| line.chars().count() <= 80),
            "{shown}"
        );
        assert_eq!(shown.matches("dB over 1 V r.m.s.").count(), 2);
    }

    #[test]
    fn without_a_frequency_the_highest_lines_are_named() {
        let capture = capture();
        let report = Report::new(&capture, None).expect("no fit");
        let shown = show(&capture, &report, 80);
        let line = shown.lines().find(|line| line.starts_with("highest lines"));
        let named = line.expect("lines");
        assert!(named.contains("500 Hz  100.0000 mV r.m.s."), "{shown}");
        assert!(
            shown.lines().all(|line| line.chars().count() <= 80),
            "{shown}"
        );
    }

    #[test]
    fn one_sample_is_shown_without_spectra() {
        let mut capture = capture();
        capture.reference_v.truncate(1);
        capture.dut_v.truncate(1);
        let report = Report::new(&capture, None).expect("no fit");
        let shown = show(&capture, &report, 80);
        assert!(
            shown.starts_with("1 samples") && !shown.contains("dB over"),
            "{shown}"
        );
    }
}
