//! Settings change only under a hand on the instrument, and every change is a record in the chain.

use calib_core::point::ExcitationKind;
use calib_core::settings::Settings;
use calib_link::Error;
use calib_protocol::message::{Refusal, RunSpec, SettingsChange};
use calib_protocol::provenance::settings_digest;
use calib_protocol::record::{self, HashLink, RecordKind, RunLabels};
use calib_protocol::{change, frame};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use std::time::Duration;

/// From a restart until requests are heard.
const BOOT: Duration = Duration::from_millis(300);
/// 2026-11-21, 12:00 UTC.
const NOW_S: u64 = 1_795_262_400;

/// The calibration of a reference that came back 0.4 % more sensitive.
fn recalibrated(before: &Settings) -> Result<SettingsChange, Fault> {
    let mut settings = before.clone();
    settings.reference.certificate = "R-2026-11".try_into().map_err(|_| "too long")?;
    for row in &mut settings.reference.points {
        row.sensitivity_v_per_ms2 *= 1.004;
    }
    Ok(SettingsChange {
        settings,
        unix_time_s: NOW_S,
        operator: "M. Beispiel".try_into().map_err(|_| "too long")?,
    })
}

fn expect_refusal(result: calib_link::Result<()>) {
    match result {
        Err(Error::Refused(refused)) => assert_eq!(refused.refusal, Refusal::ButtonNotHeld),
        other => panic!("{other:?}"),
    }
}

fn links(rigged: &mut Rigged) -> Result<Vec<HashLink>, Fault> {
    let listed = rigged.client.records()?;
    let link = |id| Ok(record::hash_link(&rigged.record(id)?)?);
    listed.iter().map(|line| line.id).map(link).collect()
}

#[test]
fn settings_change_under_a_hand_alone_and_each_change_is_a_record() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let before = rigged.client.settings()?;
    let wanted = recalibrated(&before)?;

    // A host alone changes nothing.
    expect_refusal(rigged.client.write_settings(wanted.clone()));
    let mut input = before.clone();
    input.reference_input.volt_per_code *= 2.0;
    expect_refusal(rigged.client.write_settings(input));
    assert_eq!(rigged.client.settings()?, before);
    assert_eq!(rigged.client.records()?, []);
    rigged.run(&[point(160.0, 10.0)])?;

    // Under a hand it does, the reference and others.
    rigged.under_a_hand(|client| Ok(client.write_settings(wanted.clone())?))?;
    assert_eq!(rigged.client.settings()?, wanted.settings);
    // The hand has gone. The same once more is no change, and another one is refused.
    rigged.client.write_settings(wanted.clone())?;
    expect_refusal(rigged.client.write_settings(before.clone()));
    // A short press for it is no tap either: it starts nothing.
    rigged.under_a_hand(|client| Ok(client.write_settings(wanted.clone())?))?;
    assert!(!rigged.client.status()?.state.is_running());
    rigged.run(&[point(160.0, 10.0)])?;

    // What is left of it survives the supply.
    let logged = rigged.record(2)?;
    let chain = links(&mut rigged)?;
    rigged.board().power_cycle()?;
    rigged.client.wait(BOOT)?;
    assert_eq!(rigged.client.settings()?, wanted.settings);
    assert_eq!(rigged.record(2)?, logged);
    assert_eq!(links(&mut rigged)?, chain);

    let change = change::decode(&logged)?;
    assert_eq!(change.settings, wanted.settings);
    assert_eq!(change.before, before.reference_channel());
    assert_eq!(change.all_before, Some(before));
    assert_eq!(change.head.labels.unix_time_s, NOW_S);
    assert_eq!(change.head.labels.operator, wanted.operator);
    let kinds: Vec<RecordKind> = chain.iter().map(|link| link.kind).collect();
    let (run, log) = (RecordKind::Calibration, RecordKind::ReferenceChange);
    assert_eq!(kinds, [run, log, run]);
    assert_eq!(chain[0].previous_sha256, [0; 32]);
    for pair in chain.windows(2) {
        assert_eq!(pair[1].previous_sha256, pair[0].sha256);
    }
    // The runs carry what was in force for each.
    let run = record::decode(&rigged.record(3)?)?;
    assert_eq!(run.settings, wanted.settings);
    let provenance = run.provenance;
    assert_eq!(provenance.sha256, settings_digest(&wanted.settings));
    assert_eq!(provenance.changed.record_id, 2);
    assert_eq!(provenance.reference_changed, provenance.changed);
    Ok(())
}

/// A limit that was doubled under a hand is told by every record since, beside the reference's change,
/// also by those behind a restart.
#[test]
fn a_record_tells_that_settings_changed_since_the_reference_was_calibrated() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let before = rigged.client.settings()?;
    let recalibrated = recalibrated(&before)?;
    rigged.under_a_hand(|client| Ok(client.write_settings(recalibrated.clone())?))?;
    rigged.adjust(|settings| settings.limits.acceleration_peak_ms2 *= 2.0)?;
    rigged.board().power_cycle()?;
    rigged.client.wait(BOOT)?;
    rigged.run(&[point(160.0, 10.0)])?;
    let record = record::decode(&rigged.record(3)?)?;
    let provenance = record.provenance;
    assert!(provenance.differs_from_reference());
    let calibrated = settings_digest(&recalibrated.settings);
    assert_eq!(provenance.sha256_at_reference, calibrated);
    assert_eq!(provenance.sha256, settings_digest(&record.settings));
    let changes = [provenance.reference_changed, provenance.changed];
    assert_eq!(changes.map(|change| change.record_id), [1, 2]);
    assert_eq!(changes.map(|change| change.unix_time_s), [NOW_S, 0]);
    Ok(())
}

/// A temperature no transducer has is no condition of a run.
#[test]
fn a_condition_that_cannot_be_true_is_refused() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    for (centi_c, accepted) in [(-5_501, false), (20_001, false), (20_000, true)] {
        let spec = RunSpec {
            points: [point(160.0, 10.0)].into_iter().collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels {
                temperature_centi_c: Some(centi_c),
                ..RunLabels::default()
            },
        };
        match rigged.client.start(spec) {
            Err(Error::Refused(refused)) => assert_eq!(refused.refusal, Refusal::Conditions),
            started => assert!(accepted, "{centi_c}: {started:?}"),
        }
    }
    Ok(())
}

#[test]
fn no_line_of_text_reaches_the_settings_even_under_a_hand() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let before = rigged.client.settings()?;
    let wanted = recalibrated(&before)?;
    // A frame among lines, without the zero that tells it from them, and with a line's end.
    let request = calib_protocol::message::Request::SettingsWrite(wanted);
    let mut frame = vec![0; frame::MAX_FRAME];
    let length = frame::encode(9, &request, &mut frame)?;
    let lines = b"SYST:REF 1\nCONF:REF 0.01\nCAL:REF 0.01\nSENS:CORR 2\n*RST\n";
    rigged.under_a_hand(|client| Ok(client.wait(Duration::from_millis(10))?))?;
    rigged.board().write_serial(lines);
    rigged.client.wait(Duration::from_millis(200))?;
    rigged.board().write_serial(&frame[..length - 1]);
    rigged.board().write_serial(b"\n");
    rigged.client.wait(Duration::from_millis(500))?;
    rigged.client.stop()?;
    assert_eq!(rigged.client.settings()?, before);
    Ok(())
}
