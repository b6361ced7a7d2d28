//! `calib adjust ratio`: one source at both inputs shows what the channels differ by.

use calib_core::channel_ratio::ChannelRatio;
use calib_core::point::{PointResult, PointSpec};
use calib_metrology::channel_ratio;
use calib_protocol::record::{self, Record};
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_twin::oracle;
use calib_twin::rig::{CommonSource, Rig};

/// Low, where the filters are equal; and where they are not.
const FREQUENCIES_HZ: [f32; 5] = [160.0, 1000.0, 3150.0, 6300.0, 10_000.0];

/// A divider of five to one whose leads end 0.3 % apart.
const SOURCE: CommonSource = CommonSource {
    volt_per_v: 0.2,
    leads_rel: [0.0, 0.003],
};

/// Capacitors of 1 % and a multiplexer that is 1 us later in the device's channel.
fn unequal() -> Rig {
    let mut rig = Rig::standard();
    rig.converter.dut_corner_excess_rel = 0.01;
    rig.converter.dut_delay_s = 1e-6;
    rig
}

fn with(source: CommonSource) -> Rig {
    let mut rig = unequal();
    rig.converter.common_source = Some(source);
    rig
}

fn list(level_ms2: f32) -> Vec<PointSpec> {
    FREQUENCIES_HZ.map(|hz| point(hz, level_ms2)).to_vec()
}

fn record(rigged: &mut Rigged, level_ms2: f32) -> Result<Record, Fault> {
    let id = rigged.run_held(&list(level_ms2))?.record_id;
    Ok(record::decode(&rigged.record(id)?)?)
}

/// Error of magnitude and of phase over what is stated of them, and the phase's error in degrees.
fn errors(rig: &Rig, result: &PointResult) -> [f64; 3] {
    let truth = oracle::dut_sensitivity(rig, f64::from(result.spec.frequency_hz));
    let magnitude = f64::from(result.sensitivity_v_per_ms2) / truth.norm() - 1.0;
    let phase = f64::from(result.phase_rad) - truth.arg();
    [
        magnitude.abs() / f64::from(result.expanded_uncertainty_rel),
        phase.abs() / f64::from(result.expanded_uncertainty_phase_rad),
        phase.to_degrees(),
    ]
}

#[test]
fn a_ratio_brings_the_phase_back_within_its_uncertainty() -> Result<(), Fault> {
    let rig = unequal();
    let mut rigged = Rigged::with_rig(&rig)?;
    rigged.certify_reference(&true_certificate(&rig))?;
    let before = record(&mut rigged, 10.0)?;
    let [_, phase, phase_deg] = errors(&rig, &before.points[4]);
    // 1 us at 10 kHz is 3.6 degrees, of which the filter, 1 % higher, gives a tenth back.
    assert!(phase > 1.0 && phase_deg < -2.5, "{phase_deg}");

    rigged.mount(&with(SOURCE));
    let straight = record(&mut rigged, 50.0)?;
    rigged.mount(&with(SOURCE.exchanged()));
    let exchanged = record(&mut rigged, 50.0)?;
    let found = channel_ratio::evaluate(&straight, &exchanged)?;
    // Ten statements of 95 %: beyond 2 U lies one in 16 000.
    for (row, line) in found.ratio.points.iter().zip(&found.lines) {
        let truth = oracle::channel_ratio(&rig, f64::from(row.frequency_hz));
        let magnitude = f64::from(row.magnitude) / truth.norm() - 1.0;
        let phase = f64::from(row.phase_rad) - truth.arg();
        println!("{line:?}: {magnitude:+.2e}, {phase:+.2e} rad");
        assert!(
            magnitude.abs() <= 2.0 * f64::from(row.expanded_uncertainty_rel),
            "{row:?}"
        );
        assert!(
            phase.abs() <= 2.0 * f64::from(row.expanded_uncertainty_phase_rad),
            "{row:?}"
        );
        // The device's lead ends higher; 1e-4 of scatter.
        assert!((line.leads_rel - 0.003).abs() < 1e-4, "{line:?}");
        // The linearity of the converters, 10 codes over a dither of 7200 in each channel: 2 sqrt(2/3) of it is
        // 0.227 %, and some scatter.
        assert!(line.expanded_uncertainty_rel < 0.0024, "{line:?}");
    }

    rigged.mount(&rig);
    let mut settings = rigged.client.settings()?;
    settings.channel_ratio = found.ratio.clone();
    let refused = rigged.client.write_settings(settings.clone());
    assert!(refused.is_err(), "without a hand");
    rigged.under_a_hand(|client| Ok(client.write_settings(settings)?))?;
    let after = record(&mut rigged, 10.0)?;
    assert_eq!(after.settings.channel_ratio, found.ratio);
    assert_eq!(before.settings.channel_ratio, ChannelRatio::UNKNOWN);
    for result in &after.points {
        let [magnitude, phase, phase_deg] = errors(&rig, result);
        println!(
            "{} Hz: {magnitude:.2}, {phase:.2} U, {phase_deg:+.3} deg",
            result.spec.frequency_hz
        );
        assert!(magnitude <= 1.0 && phase <= 1.0, "{result:?}");
        assert!(phase_deg.abs() < 0.3, "{phase_deg}");
    }
    Ok(())
}
