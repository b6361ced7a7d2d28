//! Files to begin with: those of the documents, and short ones of the rest.

use crate::hostile::seeds::Seed;
use calib_core::settings::Settings;

/// Seeds of the targets for files.
pub(in crate::hostile) fn seeds() -> Vec<Seed> {
    let mut all = Vec::new();
    let mut add = |target, name: &str, bytes: Vec<u8>| {
        all.push(Seed {
            target,
            name: name.to_owned(),
            bytes,
        });
    };
    add("points", "csv", led_by(0, POINTS_CSV));
    add("points", "toml", led_by(1, POINTS_TOML));
    let settings = toml::to_string(&Settings::field_calibrator()).unwrap_or_default();
    add("settings", "field", settings.into());
    add("particulars", "laboratory", LABORATORY.into());
    add("teds", "binary", teds());
    let digits = teds()
        .iter()
        .map(|byte| format!("{byte:02x} "))
        .collect::<String>();
    add("teds", "digits", digits.into());
    add("rig", "default", RIG.into());
    add(
        "dataset",
        "points",
        [DATASET_RIG, "\0", DATASET_POINTS].concat().into(),
    );
    add("dataset", "record", dataset_record().into());
    // Damage to three places of a logbook.
    add(
        "logbook",
        "damage",
        vec![0, 0, 16, 1, 0, 32, 0, 0x80, 0, 0x60, 7, 0xFF],
    );
    for (name, bytes) in super::signed::seeds() {
        add("signed", name, bytes);
    }
    for (kind, (name, text)) in METROLOGY.into_iter().enumerate() {
        add("metrology", name, led_by(kind as u8, text));
    }
    add("metrology", "record", led_by(6, &pulse()));
    all
}

fn led_by(first: u8, text: &str) -> Vec<u8> {
    [&[first], text.as_bytes()].concat()
}

const POINTS_CSV: &str = "frequency_hz,acceleration_rms_ms2\n20,\n# a remark\n1000,50\n";
const POINTS_TOML: &str = "acceleration_rms_ms2 = 10\nfrequencies_hz = [20, 40, 80, 160]\n\n\
    [[point]]\nfrequency_hz = 1000\nacceleration_rms_ms2 = 50\n";
const LABORATORY: &str = include_str!("../../../../docs/certificate/laboratory.toml");
const RIG: &str = include_str!("../../../../twin/rigs/default.toml");

/// Files of the documents, in the order of the kinds.
const METROLOGY: [(&str, &str); 6] = [
    (
        "budget",
        include_str!("../../../../docs/metrology/examples/table-d1.toml"),
    ),
    (
        "link",
        include_str!("../../../../docs/metrology/examples/link.toml"),
    ),
    (
        "doe",
        include_str!("../../../../docs/metrology/examples/doe.csv"),
    ),
    (
        "phase",
        include_str!("../../../../docs/metrology/examples/phase.toml"),
    ),
    (
        "readings",
        include_str!("../../../../docs/metrology/examples/consecutive.csv"),
    ),
    (
        "points",
        include_str!("../../../../docs/metrology/examples/accelerometer.csv"),
    ),
];

/// The beginning of a shock with its answer.
fn pulse() -> String {
    let whole = include_str!("../../../../docs/metrology/examples/shock.csv");
    let lines = whole.lines().take(40).map(|line| format!("{line}\n"));
    lines.collect()
}

const DATASET_RIG: &str = "kind = \"calibrator\"\nmeasurand = \"dut_sensitivity\"\n\
    [reference.sensitivity_v_per_ms2]\nvalue = 0.0102\nu = 0.00003\n\
    [dut.sensitivity_v_per_ms2]\nvalue = 0.01\nu = 0.0005\n";
const DATASET_POINTS: &str = "frequency_hz,acceleration_ms2,dut_deg,ratio,u_ratio,u_phase_deg\n\
    20,10,0.1,0.98,0.001,0.1\n80,10,0,0.981,0.001,0.1\n160,10,0,0.98,0.001,0.1\n\
    1000,10,-0.1,0.98,0.001,0.1\n5000,10,-1,0.99,0.001,0.1\n";
const DATASET_OSCILLATOR: &str = "kind = \"oscillator\"\n[digitiser]\nsample_rate_hz = 600\n\
    [oscillator.rho]\nvalue = 180000\nu = 3600\n[oscillator.resonance_hz]\nvalue = 68\nu = 1\n\
    [oscillator.delta]\nvalue = 0.03\nu = 0.005\n";

/// An oscillator and some samples of it.
fn dataset_record() -> String {
    let mut text = format!("{DATASET_OSCILLATOR}\0time_s,input,output\n");
    for n in 0..32 {
        let time_s = f64::from(n) / 600.0;
        let input = (400.0 * time_s).sin();
        text += &format!("{time_s:.6},{input:.4},{:.4}\n", 0.9 * input);
    }
    text
}

/// A TEDS of an accelerometer: fields of template 25 and their widths in bits, lowest bit first.
fn teds() -> Vec<u8> {
    const BASIC: [(u32, u32); 8] = [
        (21, 14),
        (4507, 15),
        (2, 5),
        (3, 6),
        (30_000, 24),
        (0, 2),
        (25, 8),
        (0, 2),
    ];
    const SENSOR: [(u32, u32); 10] = [
        (33_017, 16),
        (80, 8),
        (2, 2),
        (41, 6),
        (1, 1),
        (0, 1),
        (178, 8),
        (16, 5),
        (10_000, 16),
        (0x1041, 15),
    ];
    let fields = BASIC.iter().chain(&SENSOR).chain(&[(365, 12), (7, 11)]);
    let bits = fields.flat_map(|(value, width)| (0..*width).map(move |place| value >> place & 1));
    let bits: Vec<u32> = bits.collect();
    let byte = |bits: &[u32]| {
        let places = bits.iter().enumerate();
        places.map(|(place, bit)| (*bit as u8) << place).sum()
    };
    bits.chunks(8).map(byte).collect()
}
