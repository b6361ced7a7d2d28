//! The tables of the bench, each printed and returned as JSON.

use calib_tests::front_end::images::{self, Filters, Scene};
use calib_tests::front_end::ngspice::Run;
use calib_tests::front_end::response::{Line, Value as Path};
use calib_tests::front_end::spread::{self, Spread};
use calib_tests::rigged::Fault;
use calib_twin::oracle;
use calib_twin::rig::Rig;
use serde_json::{Value, json};

/// A number a deck prints: its name there, words, and the factor to the unit of the words.
pub(crate) type Printed = (&'static str, &'static str, f64);

/// At the pin, so over 0.3304 for the connector.
const TO_CONNECTOR_UV: f64 = 1e6 / 0.3304;

pub(crate) const NOISE: [Printed; 4] = [
    (
        "input_band",
        "input, at the connector, 1 Hz to 25 kHz",
        TO_CONNECTOR_UV,
    ),
    (
        "input_all",
        "input, at the connector, with what folds from 10 MHz",
        TO_CONNECTOR_UV,
    ),
    (
        "drive_band",
        "drive, at the power amplifier, 1 Hz to 25 kHz",
        1e6,
    ),
    ("iepe_band", "IEPE, at its output, 1 Hz to 25 kHz", 1e6),
];

pub(crate) const CHARGE: [Printed; 3] = [
    ("kick_v", "the pin falls by, mV", 1e3),
    (
        "charge_error",
        "left after 32.5 cycles, uV (a code is 50 uV)",
        1e6,
    ),
    ("rest_error", "left before the next sample, uV", 1e6),
];

pub(crate) const FAULTS: [Printed; 9] = [
    ("plus_pin_v", "+30 V at an input: converter's pin, V", 1.0),
    ("plus_rail_a", "the same: into the 3.3 V, mA", 1e3),
    ("minus_pin_v", "-30 V at an input: converter's pin, V", 1.0),
    ("rest_v", "drive at mid-scale: power amplifier, mV", 1e3),
    ("sinking_v", "the same with 2.76 V of supply, mV", 1e3),
    (
        "floating_v",
        "PA4 floats with 100 nA, before the relay falls, mV",
        1e3,
    ),
    (
        "full_drive_v",
        "drive at full scale, 10 kohm: power amplifier, V",
        1.0,
    ),
    ("muted_v", "the same with the relay released, mV", 1e3),
    (
        "plus_divider_v",
        "+30 V at an input: behind the divider, V",
        1.0,
    ),
];

/// Prints the numbers of a deck, in words.
pub(crate) fn printed(title: &str, run: &Run, numbers: &[Printed]) -> Result<Value, Fault> {
    println!("\n{title}");
    let mut document = json!({});
    for (name, words, factor) in numbers {
        let value = run.printed(name)? * factor;
        println!("  {words:<56} {value:>10.3}");
        document[*name] = json!(value);
    }
    Ok(document)
}

/// Magnitude against the lowest frequency, phase, delay, and how far both are from the twin.
pub(crate) fn response(lines: &[Line]) -> Result<Value, Fault> {
    const SHOWN_HZ: [f64; 13] = [
        1.0, 10.0, 100.0, 1e3, 2e3, 5e3, 8e3, 10e3, 20e3, 40e3, 63e3, 100e3, 199e3,
    ];
    let first = lines.first().ok_or("no line")?;
    let rig = Rig::standard();
    let converter = &rig.converter;
    let reconstruction = (converter.reconstruction_order, converter.reconstruction_hz);
    println!(
        "gain at low frequencies: input {:.5}, drive {:.4}\n\
         \n{:>9} | {:>9} {:>9} {:>7} {:>9} {:>8} | {:>9} {:>9} {:>7} {:>9} {:>8} | {:>8} {:>8}",
        first.input.magnitude,
        first.drive.magnitude,
        "Hz",
        "input dB",
        "deg",
        "us",
        "twin %",
        "deg",
        "drive dB",
        "deg",
        "us",
        "twin %",
        "deg",
        "IEPE %",
        "deg",
    );
    let mut rows = Vec::new();
    for shown_hz in SHOWN_HZ {
        let off = |line: &&Line| (line.frequency_hz / shown_hz).ln().abs();
        let line = lines
            .iter()
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .ok_or("no line")?;
        let hz = line.frequency_hz;
        let column = |path: Path, at_rest: Path, twin: calib_twin::Complex<f64>| {
            let ratio = path.complex() / at_rest.magnitude / twin;
            [
                20.0 * (path.magnitude / at_rest.magnitude).log10(),
                path.phase_deg,
                path.group_delay_us,
                (ratio.norm() - 1.0) * 100.0,
                ratio.arg().to_degrees(),
            ]
        };
        let input = column(line.input, first.input, oracle::anti_alias(&rig, hz));
        let drive = column(
            line.drive,
            first.drive,
            images::butterworth(reconstruction, hz),
        );
        let iepe = [(line.iepe.magnitude - 1.0) * 100.0, line.iepe.phase_deg];
        let text = |[db, deg, us, percent, degrees]: [f64; 5]| {
            format!("{db:>9.3} {deg:>9.3} {us:>7.2} {percent:>9.4} {degrees:>8.4}")
        };
        println!(
            "{hz:>9.1} | {} | {} | {:>8.3} {:>8.3}",
            text(input),
            text(drive),
            iepe[0],
            iepe[1]
        );
        rows.push(json!({ "frequency_hz": hz, "input": input, "drive": drive, "iepe": iepe }));
    }
    Ok(json!(rows))
}

const SCENES: [Scene; 4] = [
    Scene {
        name: "standard rig",
        flat_exciter: false,
        on_resonance: false,
    },
    Scene {
        name: "device on image",
        flat_exciter: false,
        on_resonance: true,
    },
    Scene {
        name: "flat exciter",
        flat_exciter: true,
        on_resonance: false,
    },
    Scene {
        name: "both",
        flat_exciter: true,
        on_resonance: true,
    },
];

/// Error of the sensitivity by images, for several filters and tones.
pub(crate) fn images(run: &Run) -> Result<Value, Fault> {
    let rows = run.rows("images.txt")?;
    let filters = [
        Filters::butterworth("4th 15 kHz + 4th 20 kHz", (4, 15e3), (4, 20e3)),
        Filters::butterworth("6th 15 kHz + 4th 20 kHz", (6, 15e3), (4, 20e3)),
        Filters::butterworth("6th 18 kHz + 6th 22 kHz", (6, 18e3), (6, 22e3)),
        Filters::butterworth("8th 18 kHz + 6th 22 kHz, the twin", (8, 18e3), (6, 22e3)),
        Filters::circuit(&rows),
    ];
    println!(
        "\nerror of S at 10 kHz by images, % and degrees; attenuation of 40 kHz against 10 kHz, dB"
    );
    let names = SCENES.map(|scene| format!("{:>17}", scene.name)).join(" ");
    println!(
        "  {:<34} {names} {:>8} {:>8}",
        "reconstruction + anti-alias", "reconstr.", "anti-al."
    );
    let mut document = Vec::new();
    for filters in &filters {
        let errors = SCENES.map(|scene| figures(filters, &scene, 10e3));
        let [reconstruction, anti_alias] = filters.attenuation_db(10e3, 40e3);
        let text = errors.map(|[percent, degrees]| format!("{percent:>8.4} {degrees:>8.4}"));
        println!(
            "  {:<34} {} {reconstruction:>8.1} {anti_alias:>8.1}",
            filters.name,
            text.join(" ")
        );
        document.push(json!({
            "filters": filters.name, "errors": errors,
            "attenuation_40_khz_db": [reconstruction, anti_alias],
        }));
    }
    let circuit = Filters::circuit(&rows);
    let tones = tones(&circuit);
    Ok(json!({ "at_10_khz": document, "tones": tones }))
}

/// The circuit with the worst exciter and device, tone by tone.
fn tones(circuit: &Filters<'_>) -> Value {
    println!("\nthis circuit, flat exciter, device with a quality of 30 on the image");
    let tones = [1250.0, 2500.0, 5000.0, 6250.0, 7500.0, 8750.0, 10_000.0];
    let rows = tones.map(|tone_hz| {
        let image_hz = images::SAMPLE_RATE_HZ - tone_hz;
        let [percent, degrees] = figures(circuit, &SCENES[3], tone_hz);
        let [reconstruction, anti_alias] = circuit.attenuation_db(tone_hz, image_hz);
        println!(
            "  {tone_hz:>7.0} Hz, image at {image_hz:>6.0} Hz: {percent:>9.5} % {degrees:>9.5} deg; \
             reconstruction {reconstruction:>5.1} dB, anti-alias {anti_alias:>5.1} dB"
        );
        json!({ "tone_hz": tone_hz, "error_percent": percent, "error_deg": degrees })
    });
    json!(rows)
}

/// Percent of the magnitude and degrees of the phase, both without sign.
fn figures(filters: &Filters<'_>, scene: &Scene, tone_hz: f64) -> [f64; 2] {
    let measured = images::error(filters, scene, tone_hz) + 1.0;
    [
        (measured.norm() - 1.0).abs() * 100.0,
        measured.arg().to_degrees().abs(),
    ]
}

/// Standard uncertainties of the ratio of two channels, for the four ways of `spread.cir`.
pub(crate) fn spreads(run: &Run) -> Result<Value, Fault> {
    const WAYS: [(&str, &str); 4] = [
        ("0", "10 K alone"),
        ("0.1", "C paired to 0.1 %"),
        ("1", "C of 1 %"),
        ("5", "C of 5 %"),
    ];
    println!(
        "\nratio of two channels, u over {} pairs: magnitude %, the same against 160 Hz, phase deg",
        spread::PAIRS
    );
    let mut document = json!({
        "columns": ["frequency_hz", "magnitude_rel", "shape_rel", "phase_deg"],
    });
    for (percent, words) in WAYS {
        let [input, iepe] = spread::of(run, percent)?;
        document[percent] = json!({ "input": list(&input), "iepe": list(&iepe) });
        println!("  {words:<20} {:^24} | IEPE coupling, film of 5 %", "input");
        for (input, iepe) in input.iter().zip(&iepe).filter(|(input, _)| shown(input)) {
            println!(
                "  {:>12.1} Hz    {} | {}",
                input.frequency_hz,
                text(input),
                text(iepe)
            );
        }
    }
    Ok(document)
}

fn shown(spread: &Spread) -> bool {
    const SHOWN_HZ: [f64; 8] = [1.0, 20.0, 160.0, 1e3, 2e3, 5e3, 8e3, 10e3];
    // Ten points in a decade: 12 % from the next.
    let near = |hz: &f64| (spread.frequency_hz / hz - 1.0).abs() < 0.02;
    SHOWN_HZ.iter().any(near)
}

fn text(spread: &Spread) -> String {
    let Spread {
        magnitude_rel,
        shape_rel,
        phase_deg,
        ..
    } = spread;
    let (magnitude, shape) = (magnitude_rel * 100.0, shape_rel * 100.0);
    format!("{magnitude:>7.4} {shape:>7.4} {phase_deg:>8.4}")
}

fn list(spreads: &[Spread]) -> Vec<[f64; 4]> {
    let row = |s: &Spread| [s.frequency_hz, s.magnitude_rel, s.shape_rel, s.phase_deg];
    spreads.iter().map(row).collect()
}
