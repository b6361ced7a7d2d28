//! Hum of the mains near a tone: taken out, stated, or refused, and never valid and wrong.

use calib_core::point_state::{PointState, Reason};
use calib_tests::judge::deviation;
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_twin::rig::Rig;
use std::time::Duration;

const RATE_HZ: f32 = 50_000.0;

/// From mounting to asking for the run: longer than the instrument listens.
const RESTED: Duration = Duration::from_millis(1500);

/// The standard rig with ideal converters.
fn ideal() -> Rig {
    let mut rig = Rig::standard();
    (rig.converter.errors, rig.converter.dither_peak_v) = (0.0, 0.0);
    rig
}

/// An instrument that is told the truth about its reference, with ideal converters: what is off is hum.
fn rigged() -> Result<Rigged, Fault> {
    let rig = ideal();
    let mut rigged = Rigged::with_rig(&rig)?;
    rigged.certify_reference(&true_certificate(&rig))?;
    rigged.adjust(|settings| settings.point_influences.converter_step_v = 0.0)?;
    Ok(rigged)
}

/// A point on a rig with this hum in the device's channel.
struct Outcome {
    state: PointState,
    /// Error over U, magnitude and phase.
    error: [f64; 2],
    /// Expanded uncertainty of the magnitude, relative.
    expanded_rel: f64,
}

fn measure(
    rigged: &mut Rigged,
    hum: &str,
    mains_hz: f64,
    hz: f32,
    ms2: f32,
) -> Result<Outcome, Fault> {
    let mut rig = ideal();
    rig.surroundings.mains_hz = mains_hz;
    if !hum.is_empty() {
        rig.effects.push(hum.parse()?);
    }
    rigged.mount(&rig);
    rigged.client.wait(RESTED)?;
    let result = rigged.run(&[point(hz, ms2)])?.points[0];
    let off = deviation(&result, &rig, RATE_HZ);
    let outcome = Outcome {
        state: result.state,
        error: [
            off.magnitude_rel.abs() / f64::from(result.expanded_uncertainty_rel),
            off.phase_rad.abs() / f64::from(result.expanded_uncertainty_phase_rad),
        ],
        expanded_rel: f64::from(result.expanded_uncertainty_rel),
    };
    println!(
        "{hz} Hz, {ms2} m/s2, mains {mains_hz} Hz: {}; {:+.3} %, {:+.3} deg; U {:.3} %, hum {:.3} %",
        result.state,
        100.0 * off.magnitude_rel,
        off.phase_rad.to_degrees(),
        100.0 * outcome.expanded_rel,
        100.0 * result.hum_rel
    );
    Ok(outcome)
}

/// 0.3 mV r.m.s. of hum beside 10 mV: 3 % of the tone, and more than Table 1 grants. A point as near to a
/// line as this is refused for it.
#[test]
fn hum_on_the_tone_is_refused_at_low_levels() -> Result<(), Fault> {
    let mut rigged = rigged()?;
    let first = "mains_pickup=pickup_v:3e-4,second_v:0,third_v:0";
    let second = "mains_pickup=pickup_v:3e-4,second_v:5e-4,third_v:0";
    for (hum, mains_hz, hz) in [
        (first, 50.01, 50.0),
        (first, 49.98, 50.0),
        (first, 50.0, 50.0),
        (second, 50.0, 100.0),
    ] {
        let outcome = measure(&mut rigged, hum, mains_hz, hz, 1.0)?;
        assert_eq!(
            outcome.state,
            PointState::Refused(Reason::Hum),
            "{mains_hz}"
        );
    }
    Ok(())
}

/// Beside ten times the level it is 0.3 %: stated, and covered.
#[test]
fn hum_on_the_tone_is_stated_at_usual_levels() -> Result<(), Fault> {
    let mut rigged = rigged()?;
    let hum = "mains_pickup=pickup_v:3e-4,second_v:0,third_v:0";
    let clean = measure(&mut rigged, "", 50.0, 50.0, 10.0)?;
    for mains_hz in [50.0, 50.01, 49.98] {
        let outcome = measure(&mut rigged, hum, mains_hz, 50.0, 10.0)?;
        assert_eq!(outcome.state, PointState::Valid);
        assert!(
            outcome.error.iter().all(|error| *error <= 1.0),
            "{:?}",
            outcome.error
        );
        // 0.3 % over sqrt 2, twice, and not more: root of the difference of squares. Of 49.98 Hz, which turn by 7
        // degrees in ten blocks, a tenth is told apart.
        let by_hum = (outcome.expanded_rel.powi(2) - clean.expanded_rel.powi(2)).sqrt();
        assert!((0.0036..0.0044).contains(&by_hum), "{by_hum}");
    }
    Ok(())
}

/// At least 3 Hz from every line the hum's part of U is at most 0.05 % at 10 m/s2 and 0.2 % at 1 m/s2.
#[test]
fn hum_beside_the_tone_is_taken_out() -> Result<(), Fault> {
    let mut rigged = rigged()?;
    let hum = "mains_pickup=pickup_v:3e-4,second_v:1e-4,third_v:1e-4";
    for (mains_hz, hz) in [(50.03, 53.5), (49.95, 105.0), (50.08, 205.0), (60.06, 63.0)] {
        for (ms2, allowed_rel) in [(10.0, 5.0e-4), (1.0, 2.0e-3)] {
            let clean = measure(&mut rigged, "", mains_hz, hz, ms2)?;
            let outcome = measure(&mut rigged, hum, mains_hz, hz, ms2)?;
            assert_eq!(outcome.state, PointState::Valid, "{hz} Hz, {ms2} m/s2");
            let by_hum = (outcome.expanded_rel.powi(2) - clean.expanded_rel.powi(2))
                .max(0.0)
                .sqrt();
            assert!(by_hum < allowed_rel, "{hz} Hz, {ms2} m/s2: {by_hum}");
            // Nothing else is off: the error itself stays within the hum's part.
            let error_rel = outcome.error[0] * outcome.expanded_rel;
            assert!(error_rel < allowed_rel, "{hz} Hz, {ms2} m/s2: {error_rel}");
        }
    }
    Ok(())
}
