//! The instrument and a certificate say the same of the same run: two judgements, written apart, in single and in
//! double precision. Of a response the certificate may say more, and never the contrary. Where it knows of the
//! temperature and the mount what the instrument does not, its U is another, and neither says the contrary of the other.

use calib_certificate::decision::{Request, Stated};
use calib_certificate::{Certificate, Particulars};
use calib_core::closing::Closing;
use calib_core::conformity::{Conformity, judge};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::preferred::{LEVELS_MS2, PREFERRED_HZ};
use calib_core::settings::Settings;
use calib_core::stored_list::{Band, Base, ListTerms, Rule};
use calib_core::tone::Tone;
use calib_protocol::record::{Record, RecordHead, RunLabels};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::BTreeMap;

const RUNS: u64 = 4_000;
/// Single precision moves a limit by some units in its last place of 6e-8: of what lies nearer to one than this,
/// either statement is as good.
const NEAR_REL: f32 = 1.0e-6;

/// Within 1 K as it is told: the 3 K that U of the instrument covers.
const LIKE_THE_INSTRUMENT: Option<i16> = Some(2500);

/// Above some kHz a certificate has in U what a sweep shows of the mount, which the instrument does not know. Here a shift of
/// a resonance of 20 kHz by a tenth is 2e-5, which makes the least U drawn larger by 1e-7.
const WITHOUT_MOUNT_HZ: f32 = 200.0;

struct Draws {
    random: ChaCha12Rng,
    up_to_hz: f32,
}

impl Draws {
    fn of(seed: u64, up_to_hz: f32) -> Self {
        Self {
            random: ChaCha12Rng::seed_from_u64(seed),
            up_to_hz,
        }
    }

    fn unit(&mut self) -> f32 {
        (self.random.next_u32() >> 8) as f32 / (1 << 24) as f32
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.random.next_u32() as usize % choices.len()]
    }

    fn band(&mut self) -> Band {
        let everywhere = self.unit() < 0.5;
        let half_rel = self.between(0.005, 0.2);
        Band {
            from_hz: if everywhere {
                0.0
            } else {
                self.between(20.0, 100.0)
            },
            to_hz: if everywhere {
                f32::MAX
            } else {
                self.between(100.0, self.up_to_hz)
            },
            base: self.one_of(&[Base::Nominal, Base::Reference]),
            lower_rel: -half_rel,
            upper_rel: half_rel * self.between(0.5, 2.0),
            reference_point_only: self.unit() < 0.2,
        }
    }

    fn terms(&mut self) -> ListTerms {
        let bands = 1 + self.random.next_u32() as usize % 3;
        ListTerms {
            name: "drawn".try_into().expect("short"),
            nominal_v_per_ms2: 0.01 * self.between(0.9, 1.1),
            unit: "mV/g".try_into().expect("short"),
            rule: self.one_of(&[Rule::Simple, Rule::GuardBand]),
            bands: (0..bands).map(|_| self.band()).collect(),
        }
    }

    fn point(&mut self, spread_rel: f32, least_rel: f32) -> PointResult {
        let up_to_hz = self.up_to_hz;
        let low: Vec<f32> = PREFERRED_HZ
            .into_iter()
            .filter(|frequency_hz| *frequency_hz <= up_to_hz)
            .collect();
        let spec = PointSpec {
            frequency_hz: self.one_of(&low),
            acceleration_rms_ms2: self.one_of(&LEVELS_MS2),
        };
        let tone = Tone::nearest(spec.frequency_hz, 50_000.0);
        let refused = self.unit() < 0.05;
        PointResult {
            state: match refused {
                true => PointState::Refused(Reason::Clipped),
                false => PointState::Valid,
            },
            acceleration_rms_ms2: spec.acceleration_rms_ms2,
            sensitivity_v_per_ms2: 0.01 * self.between(1.0 - spread_rel, 1.0 + spread_rel),
            expanded_uncertainty_rel: self.between(least_rel, 0.02),
            expanded_uncertainty_phase_rad: 0.01,
            coverage_factor: 2.0,
            effective_degrees_of_freedom: 100.0,
            ..PointResult::refused(spec, tone, Reason::Clipped)
        }
    }

    /// Few of the first points cannot be repeated at the end.
    fn closing(&mut self) -> Closing {
        match self.unit() < 0.05 {
            true => Closing::Refused(Reason::DutOpen),
            false => Closing::None,
        }
    }

    fn run(&mut self) -> (ListTerms, Vec<PointResult>) {
        let (terms, points) = (self.terms(), 1 + self.random.next_u32() % 6);
        let spread_rel = self.between(0.01, 0.2);
        // A certificate takes U of a deviation from the settings' budget, whose U is 1.5 % at most: that of the
        // points is no less.
        let least_rel = if is_of_response(&terms) { 0.016 } else { 0.002 };
        let points = (0..points).map(|_| self.point(spread_rel, least_rel));
        (terms, points.collect())
    }
}

fn is_of_response(terms: &ListTerms) -> bool {
    terms.bands.iter().any(|band| band.base == Base::Reference)
}

/// Statement of a certificate about the record of such a run, told this temperature.
fn certified(
    terms: &ListTerms,
    points: &[PointResult],
    closing: Closing,
    temperature_centi_c: Option<i16>,
) -> Stated {
    let record = Record {
        head: RecordHead {
            id: 1,
            sample_rate_hz: 50_000.0,
            labels: RunLabels {
                temperature_centi_c,
                ..RunLabels::BLANK
            },
            ..RecordHead::BLANK
        },
        settings: Settings::field_calibrator(),
        complete: true,
        closing,
        points: points.iter().copied().collect(),
        ..Record::BLANK
    };
    let particulars = Particulars {
        decision: Some(Request::of_terms(terms)),
        ..Particulars::default()
    };
    Certificate::from_record(&record, &particulars).stated_conformity()
}

/// Statements of the lamps about it, on either side of a limit that a value is next to.
fn judgements(terms: &ListTerms, points: &[PointResult], closing: Closing) -> [Stated; 3] {
    [1.0, 1.0 - NEAR_REL, 1.0 + NEAR_REL].map(|factor| {
        let mut points = points.to_vec();
        for point in &mut points {
            point.sensitivity_v_per_ms2 *= factor;
        }
        match judge(terms, &points, true, &closing) {
            Conformity::Pass => Stated::Pass,
            Conformity::ConditionalPass => Stated::ConditionalPass,
            Conformity::ConditionalFail => Stated::ConditionalFail,
            Conformity::NotJudgeable => Stated::NotJudgeable,
            Conformity::Fail => Stated::Fail,
        }
    })
}

#[test]
fn the_lamps_and_a_certificate_say_the_same_of_every_run() {
    let mut draws = Draws::of(19, WITHOUT_MOUNT_HZ);
    let mut said: BTreeMap<String, u32> = BTreeMap::new();
    let mut near = 0;
    for number in 0..RUNS {
        let (terms, points) = draws.run();
        let closing = draws.closing();
        let certified = certified(&terms, &points, closing, LIKE_THE_INSTRUMENT);
        let judged = judgements(&terms, &points, closing);
        let is_decided = |stated: &Stated| matches!(stated, Stated::Pass | Stated::Fail);
        let undecided = is_of_response(&terms) && !judged.iter().any(is_decided);
        assert!(
            undecided || judged.contains(&certified),
            "{number}: {judged:?}, certified {certified:?}"
        );
        near += u32::from(!undecided && judged[0] != certified);
        *said.entry(format!("{certified:?}")).or_default() += 1;
    }
    println!("{said:?}, {near} next to a limit");
    // Each statement was met often enough to be compared.
    assert_eq!(said.len(), 5, "{said:?}");
    assert!(said.values().all(|times| *times >= 40), "{said:?}");
    assert!(near <= 2, "{near}");
}

/// At every frequency, where a certificate covers the mount and the temperature that was told, or that nobody told:
/// what the lamps passed it does not fail, and what they failed it does not pass.
#[test]
fn no_certificate_says_the_contrary_of_the_lamps() {
    let mut draws = Draws::of(20, f32::MAX);
    let mut met: BTreeMap<String, u32> = BTreeMap::new();
    for number in 0..RUNS {
        let (terms, points) = draws.run();
        let closing = draws.closing();
        let told = draws.one_of(&[
            None,
            Some(1500),
            Some(2300),
            LIKE_THE_INSTRUMENT,
            Some(3300),
        ]);
        let certified = certified(&terms, &points, closing, told);
        let lamps = &judgements(&terms, &points, closing)[0];
        let contrary: &[Stated] = match lamps {
            Stated::Pass => &[Stated::Fail, Stated::ConditionalFail],
            Stated::Fail => &[Stated::Pass, Stated::ConditionalPass],
            _ => &[],
        };
        assert!(
            !contrary.contains(&certified),
            "{number}, {told:?}: the lamps {lamps:?}, certified {certified:?}"
        );
        let pair = format!("{lamps:?}, certified {certified:?}");
        *met.entry(pair).or_default() += 1;
    }
    println!("{met:?}");
    // A U that covers more takes a PASS back, one that knows the temperature gives it; a few are not judgeable then.
    for pair in [
        "Pass, certified Pass",
        "Fail, certified Fail",
        "Pass, certified ConditionalPass",
        "ConditionalPass, certified Pass",
    ] {
        assert!(
            met.get(pair).is_some_and(|times| *times >= 10),
            "{pair}: {met:?}"
        );
    }
    assert!(met.contains_key("Pass, certified NotJudgeable"), "{met:?}");
}
