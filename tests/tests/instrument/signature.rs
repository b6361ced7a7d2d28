//! The key of the instrument: made once under a hand, it signs every record from then on.

use calib_link::Error;
use calib_logbook::{Kept, Logbook};
use calib_protocol::message::Refusal;
use calib_protocol::record;
use calib_record::sample::mend;
use calib_record::signature::{Signed, signed};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;

fn refusal<T: std::fmt::Debug>(answer: Result<T, Error>) -> Result<Refusal, Fault> {
    match answer {
        Err(Error::Refused(refused)) => Ok(refused.refusal),
        other => Err(format!("{other:?}").into()),
    }
}

/// The record of a run, as the instrument hands it out.
fn measured(rigged: &mut Rigged) -> Result<Vec<u8>, Fault> {
    let id = rigged.run(&[point(160.0, 10.0)])?.record_id;
    rigged.record(id)
}

/// Alters one bit and corrects the checksum.
fn altered(bytes: &[u8], at: usize) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at] ^= 1;
    mend(&mut bytes);
    bytes
}

#[test]
fn a_key_made_under_a_hand_signs_every_record_and_a_forgery_finds_no_place() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    assert_eq!(rigged.client.key()?, None);
    assert_eq!(refusal(rigged.client.make_key())?, Refusal::ButtonNotHeld);
    let unsigned = measured(&mut rigged)?;
    assert_eq!(signed(&unsigned)?, Signed::No);

    let key = rigged.under_a_hand(|client| Ok(client.make_key()?))?;
    let again = rigged.under_a_hand(|client| refusal(client.make_key()))?;
    assert_eq!(again, Refusal::KeyExists);
    assert_eq!(key.since, record::hash_link(&unsigned)?.id + 1);
    assert_eq!(rigged.client.key()?, Some(key));

    let true_one = measured(&mut rigged)?;
    assert_eq!(signed(&true_one)?, Signed::By(key.public));

    let folder = tempfile::tempdir()?;
    let mut logbook = Logbook::open(&folder.path().join("logbook.sqlite"))?;
    logbook.enter_key(&record::hash_link(&true_one)?.instrument_serial, &key)?;
    // Every byte behind the settings, the results among them.
    let (_, settings) = record::inspect(&true_one)?;
    for at in settings.end..true_one.len() - 4 {
        let forged = altered(&true_one, at);
        assert!(logbook.keep(&forged).is_err(), "byte {at}");
    }
    assert!(matches!(logbook.keep(&unsigned)?, Kept::Added(_)));
    assert!(matches!(logbook.keep(&true_one)?, Kept::Added(_)));
    assert!(matches!(logbook.keep(&true_one)?, Kept::Known(_)));
    // The one from before the key, altered: the logbook has the true one.
    let problem = logbook
        .keep(&altered(&unsigned, 200))
        .err()
        .ok_or("taken")?;
    assert!(problem.to_string().contains("there already"), "{problem}");
    assert_eq!(logbook.inspect()?, [""; 0]);
    Ok(())
}
