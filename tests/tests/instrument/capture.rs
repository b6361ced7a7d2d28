//! Waveforms of both channels, out of the shipping firmware.

use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_link::Error;
use calib_link::capture::{self, Capture, Inputs, Measured, ToneFit};
use calib_link::session;
use calib_protocol::message::{Refusal, RunState};
use calib_protocol::record::RunLabels;
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_twin::board::PartFault;
use calib_twin::oracle;
use calib_twin::rig::Rig;
use std::f64::consts::{SQRT_2, TAU};
use std::time::Duration;

/// Volts per code of the input front end.
const STEP_V: f64 = 10.0 / 65_536.0;
/// Noise of both channels: some steps, so that rounding to codes adds noise of
/// `STEP_V / sqrt(12)` and nothing else.
const NOISE_RMS_V: f64 = 1.0e-3;
/// Bend of the device's converter, 1/V.
const BEND_PER_V: f64 = 0.3;
const PAIRS: u16 = 8192;
const FREQUENCY_HZ: f32 = 160.0;

/// A rig whose second harmonic, d.c. and noise are known.
fn bent_rig() -> Result<Rig, Fault> {
    let mut rig = Rig::standard();
    // Beside which the converters shall have none of their own.
    (rig.converter.errors, rig.converter.dither_peak_v) = (0.0, 0.0);
    for sensing in [&mut rig.reference, &mut rig.dut] {
        sensing.noise_rms_v = NOISE_RMS_V;
    }
    let bend = format!("adc_quadratic=c2_per_v:{BEND_PER_V},channel:1");
    rig.effects.push(bend.parse()?);
    Ok(rig)
}

/// The instrument on a rig, with the truth about its reference.
fn rigged_on(rig: &Rig) -> Result<(Rigged, Inputs), Fault> {
    let mut rigged = Rigged::with_rig(rig)?;
    rigged.certify_reference(&true_certificate(rig))?;
    let inputs = Inputs::of(&mut rigged.client)?;
    Ok((rigged, inputs))
}

fn spec() -> PointSpec {
    point(FREQUENCY_HZ, 10.0)
}

fn measure(rigged: &mut Rigged, inputs: &Inputs, pairs: u16) -> Result<Measured, Fault> {
    let (client, labels) = (&mut rigged.client, RunLabels::default());
    let measured = capture::measure(client, inputs, spec(), pairs, labels, || false)?;
    let capture = measured.capture.as_ref().ok_or("the level was not held")?;
    assert_eq!(capture.reference_v.len(), usize::from(pairs));
    Ok(measured)
}

fn fits(capture: &Capture, frequency_hz: f64) -> Result<[ToneFit; 2], Fault> {
    let of = |volts| capture::fit(volts, capture.sample_rate_hz, frequency_hz);
    Ok([of(&capture.reference_v)?, of(&capture.dut_v)?])
}

#[test]
fn a_capture_during_a_point_shows_what_the_rig_does() -> Result<(), Fault> {
    let rig = bent_rig()?;
    let (mut rigged, inputs) = rigged_on(&rig)?;
    let measured = measure(&mut rigged, &inputs, PAIRS)?;
    assert_eq!(measured.state, RunState::Finished);
    let result = measured.point.ok_or("measured")?;
    let capture = measured.capture.ok_or("the level was held")?;
    assert_eq!(capture.first_index % 500, 0, "it begins with a block");
    assert!(!capture.reference_clipped && !capture.dut_clipped);
    let [reference, dut] = fits(&capture, measured.frequency_hz)?;
    println!("{reference:#?}\n{dut:#?}");

    // The level is held within 0.1 %, and its noise is 1 mV in 102 mV over 8192
    // samples: 1.5e-4 of it.
    let truth = oracle::reference_sensitivity(&rig, measured.frequency_hz);
    let level_rms_ms2 = reference.rms_v / truth.norm();
    assert!(
        (level_rms_ms2 / 10.0 - 1.0).abs() < 1.6e-3,
        "{level_rms_ms2}"
    );
    expect_record(&result, &reference, &dut, &rig)?;
    expect_bend(&dut, &rig);
    // A reference without any bend, but for the drive's own harmonics.
    let second = reference.harmonics[0];
    let margin = 4.0 * second.standard_uncertainty_rel + 1e-3;
    assert!(second.amplitude_rel < margin, "{second:?}");
    Ok(())
}

/// The host's fit and the record agree: both know the same sensitivity.
fn expect_record(
    result: &PointResult,
    reference: &ToneFit,
    dut: &ToneFit,
    rig: &Rig,
) -> Result<(), Fault> {
    let truth = oracle::reference_sensitivity(rig, reference.frequency_hz);
    let sensitivity = dut.rms_v / reference.rms_v * truth.norm();
    let phase_rad = dut.phase_after(reference) + truth.arg();
    // Four standard uncertainties of the captures, and two (U) of the record's
    // random part, which is its repeatability.
    let relative = |fit: &ToneFit| fit.standard_uncertainty_rms_v / fit.rms_v;
    let random_rel = relative(reference).hypot(relative(dut));
    let bound = 4.0 * random_rel + 4.0 * f64::from(result.repeatability_rel);
    let off = sensitivity / f64::from(result.sensitivity_v_per_ms2) - 1.0;
    let phase_off = phase_rad - f64::from(result.phase_rad);
    println!("off by {off:.2e}, {phase_off:.2e} rad; bound {bound:.2e}");
    let sound = off.abs() < bound && phase_off.abs() < bound;
    sound
        .then_some(())
        .ok_or_else(|| format!("{off}, {phase_off}").into())
}

/// `w + c w^2` of an offset and a tone of A volts peak makes a second harmonic of
/// `c A / 2` of the fundamental, in phase with the crest, and `c A^2 / 2` of d.c.
fn expect_bend(dut: &ToneFit, rig: &Rig) {
    let second = dut.harmonics[0];
    let peak_v = SQRT_2 * dut.rms_v;
    // The fundamental itself is changed by 2 c times the offset: 0.1 %.
    let wanted = 0.5 * BEND_PER_V * peak_v;
    let margin = 4.0 * second.standard_uncertainty_rel + 2e-3 * wanted;
    assert!((second.amplitude_rel - wanted).abs() < margin, "{second:?}");
    assert!(second.phase_rad.abs() < margin / wanted, "{second:?}");
    // d.c.: also the noise's square, and half a step that the converter's
    // rounding may be off.
    let offset_v = rig.dut.offset_v;
    let squares = offset_v.powi(2) + 0.5 * peak_v.powi(2) + NOISE_RMS_V.powi(2);
    let wanted_v = offset_v + BEND_PER_V * squares;
    let margin_v = 4.0 * dut.standard_uncertainty_dc_v + 0.5 * STEP_V;
    assert!(
        (dut.dc_v - wanted_v).abs() < margin_v,
        "{} {wanted_v}",
        dut.dc_v
    );
    // At least the noise put in; the drive's 12 bits shake the table besides.
    assert!(dut.noise_rms_v > 0.96 * NOISE_RMS_V && dut.noise_rms_v < 1.5 * NOISE_RMS_V);
}

#[test]
fn captures_at_rest_show_offset_and_noise_and_break_by_name() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    (rig.converter.errors, rig.converter.dither_peak_v) = (0.0, 0.0);
    rig.reference.noise_rms_v = NOISE_RMS_V;
    rig.dut.noise_rms_v = NOISE_RMS_V;
    let (mut rigged, inputs) = rigged_on(&rig)?;
    expect_refusal(&mut rigged, Refusal::NotCaptured)?;
    let before = rigged.client.status()?.samples;
    let first = inputs.capture(&mut rigged.client, PAIRS)?;
    let after = rigged.client.status()?.samples;
    let on_the_way = after - first.first_index - u64::from(PAIRS);
    println!("{PAIRS} pairs in {:.2} s", on_the_way as f64 / 5e4);
    assert!(first.first_index >= before);
    assert!(first.first_index + u64::from(PAIRS) <= after);
    let second = inputs.capture(&mut rigged.client, 1)?;
    assert!(second.first_index >= after, "captures do not overlap");
    for (volts, sensing) in [
        (&first.reference_v, &rig.reference),
        (&first.dut_v, &rig.dut),
    ] {
        let count = volts.len() as f64;
        let mean_v = volts.iter().sum::<f64>() / count;
        let squares: f64 = volts.iter().map(|volt| (volt - mean_v).powi(2)).sum();
        let noise_v = (squares / (count - 1.0)).sqrt();
        // Noise of a step's width and more makes rounding noise of its own.
        let wanted_v = NOISE_RMS_V.hypot(STEP_V / 12_f64.sqrt());
        let margin_v = 4.0 * wanted_v / count.sqrt();
        assert!(
            (mean_v - sensing.offset_v).abs() < margin_v + 0.5 * STEP_V,
            "{mean_v}"
        );
        let margin = 4.0 / (2.0 * count).sqrt();
        assert!(
            (noise_v / wanted_v - 1.0).abs() < margin,
            "{noise_v} {wanted_v}"
        );
    }
    let without = instructions_per_pair(&mut rigged)?;
    rigged.client.capture(15_000)?;
    let with = instructions_per_pair(&mut rigged)?;
    // 480 MHz over 50 kHz are 9600 cycles a pair; a word takes a load and a store.
    println!("{without:.1} instructions a pair, {with:.1} while capturing");
    assert!(with - without < 96.0, "more than 1 % of the core");
    expect_broken(&mut rigged, &inputs)
}

/// Samples that are lost break a capture, by name, and only that one.
fn expect_broken(rigged: &mut Rigged, inputs: &Inputs) -> Result<(), Fault> {
    rigged.client.capture(16_384)?;
    rigged.client.wait(Duration::from_millis(100))?;
    rigged.board().fail(PartFault::AdcOverrun)?;
    rigged.client.wait(Duration::from_millis(300))?;
    expect_refusal(rigged, Refusal::CaptureBroken)?;
    assert!(rigged.client.status()?.overruns > 0);
    inputs.capture(&mut rigged.client, 1)?;
    Ok(())
}

fn expect_refusal(rigged: &mut Rigged, refusal: Refusal) -> Result<(), Fault> {
    match rigged.client.read_capture(0) {
        Err(Error::Refused(refused)) if refused.refusal == refusal => Ok(()),
        Err(error) => Err(error.into()),
        Ok(part) => Err(format!("{} pairs, not {refusal:?}", part.taken).into()),
    }
}

#[test]
fn measuring_does_not_notice_a_capture() -> Result<(), Fault> {
    let rig = Rig::standard();
    let mut results = Vec::new();
    for pairs in [None, Some(4096)] {
        let (mut rigged, inputs) = rigged_on(&rig)?;
        let result = match pairs {
            None => rigged.run_held(&[spec()])?.points.first().copied(),
            Some(pairs) => measure(&mut rigged, &inputs, pairs)?.point,
        };
        assert_eq!(rigged.client.status()?.overruns, 0);
        results.push(result.ok_or("a point")?);
    }
    // The same samples, so the same bits.
    assert_eq!(results[0], results[1]);
    Ok(())
}

/// Instructions per sample pair while nothing is asked for 0.3 s.
fn instructions_per_pair(rigged: &mut Rigged) -> Result<f64, Fault> {
    let counters = |rigged: &Rigged| {
        let board = rigged.board();
        (board.instructions(), board.sample_pairs())
    };
    let (instructions, pairs) = counters(rigged);
    rigged.client.wait(Duration::from_millis(300))?;
    let (instructions_after, pairs_after) = counters(rigged);
    Ok((instructions_after - instructions) as f64 / (pairs_after - pairs) as f64)
}

#[test]
fn time_goes_on_from_one_capture_to_the_next() -> Result<(), Fault> {
    let rig = Rig::standard();
    let (mut rigged, inputs) = rigged_on(&rig)?;
    let client = &mut rigged.client;
    let labels = RunLabels::default();
    session::begin(client, &[spec()], ExcitationKind::HeldSine, labels)?;
    while client.status()?.state != RunState::Measuring {
        client.wait(Duration::from_millis(50))?;
    }
    let frequency_hz =
        capture::tone_frequency_hz(FREQUENCY_HZ, inputs.sample_rate_hz).ok_or("a tone")?;
    let mut captures = Vec::new();
    for _ in 0..2 {
        captures.push(inputs.capture(client, 1000)?);
    }
    assert_eq!(client.status()?.state, RunState::Measuring);
    client.stop()?;
    let [early, late] = [&captures[0], &captures[1]];
    let apart = (late.first_index - early.first_index) as f64 / early.sample_rate_hz;
    let [early, _] = fits(early, frequency_hz)?;
    let [late, _] = fits(late, frequency_hz)?;
    let turned = late.phase_rad - early.phase_rad - TAU * frequency_hz * apart;
    let turned = turned.sin().atan2(turned.cos());
    let margin = 4.0 * (early.standard_uncertainty_phase_rad + late.standard_uncertainty_phase_rad);
    // One sample would be 0.02 rad.
    assert!(turned.abs() < margin && margin < 0.005, "{turned} {margin}");
    Ok(())
}
