//! Lists kept on the instrument.

use calib_core::point::PointSpec;
use calib_core::stored_list::{Band, Base, ListTerms, Rule, StoredList};
use calib_link::Error;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::Refusal;
use calib_tests::bench::{Bench, Fault, point};
use calib_twin::rig::Rig;
use std::time::Duration;

/// A list of these points whose nominal sensitivity is that of the standard rig's device, V/(m/s2), over
/// `1 + deviation_rel`.
fn list(name: &str, points: &[PointSpec], deviation_rel: f32, tolerance_rel: f32) -> StoredList {
    let band = Band {
        from_hz: 0.0,
        to_hz: f32::MAX,
        base: Base::Nominal,
        lower_rel: -tolerance_rel,
        upper_rel: tolerance_rel,
        reference_point_only: false,
    };
    StoredList {
        terms: ListTerms {
            name: name.try_into().expect("short"),
            nominal_v_per_ms2: 0.01 / (1.0 + deviation_rel),
            unit: "mV/g".try_into().expect("short"),
            rule: Rule::Simple,
            bands: [band].into_iter().collect(),
        },
        points: points.iter().copied().collect(),
    }
}

fn choice(name: &str) -> ListChange {
    let name = name.try_into().expect("short");
    ListChange::Choose { name }
}

fn refusal<T: std::fmt::Debug>(answer: Result<T, Error>) -> Result<Refusal, Fault> {
    match answer {
        Err(Error::Refused(refused)) => Ok(refused.refusal),
        other => Err(format!("{other:?}").into()),
    }
}

#[test]
fn lists_change_under_a_hand_alone_and_are_kept_through_a_power_cut() -> Result<(), Fault> {
    let mut bench = Bench::with_rig(&Rig::standard())?;
    assert_eq!(bench.client.lists()?, []);
    let long: Vec<PointSpec> = (0..40).map(|n| point(20.0 + n as f32, 10.0)).collect();
    let kept = [
        list("long", &long, 0.0, 0.05),
        list("short", &long[..1], 0.0, 0.05),
    ];
    let store = |list: &StoredList| ListChange::Store(list.clone());
    let stored = bench.client.change_lists(&store(&kept[0]));
    assert_eq!(refusal(stored)?, Refusal::ButtonNotHeld);
    bench.under_a_hand(|client| {
        for list in &kept {
            client.change_lists(&store(list))?;
        }
        assert_eq!(
            refusal(client.change_lists(&choice("none")))?,
            Refusal::ListUnknown
        );
        let mut useless = kept[0].clone();
        useless.terms.bands.clear();
        assert_eq!(
            refusal(client.change_lists(&store(&useless)))?,
            Refusal::List
        );
        Ok(client.change_lists(&choice("short"))?)
    })?;
    // What is so already needs no hand.
    bench.client.change_lists(&store(&kept[0]))?;
    bench.client.change_lists(&choice("short"))?;
    assert_eq!(
        refusal(bench.client.change_lists(&choice("long")))?,
        Refusal::ButtonNotHeld
    );
    let [long, short] = kept;
    let expected = [(long, false), (short, true)].map(|(list, chosen)| KeptList { list, chosen });
    assert_eq!(bench.client.lists()?, expected);
    bench.board().power_cycle()?;
    bench.client.wait(Duration::from_secs(1))?;
    assert_eq!(bench.client.lists()?, expected);
    Ok(())
}
