//! Coverage and detection of the check by reciprocity: `./run bench selfcheck [RIGS [FIRST_SEED [IMAGE_RIGS]]]`.

use calib_tests::rigged::{Fault, Rigged, true_certificate};
use calib_tests::self_check::{
    ANSWERS, BANDS_HZ, CHANGE_REL, DIFFERENCE_REL, FREQUENCIES_HZ, LONGEST, TRUTHS, Tally, UNSOUND,
    by_image, linear, plan, run, spoilt,
};
use calib_twin::oracle;
use calib_twin::reciprocity::{Hold, distributions};
use std::time::Duration;

fn main() -> Result<(), Fault> {
    let mut numbers = std::env::args()
        .skip(1)
        .filter_map(|text| text.parse().ok());
    let rigs: u64 = numbers.next().unwrap_or(3000);
    let first_seed: u64 = numbers.next().unwrap_or(0);
    let image_rigs: u64 = numbers.next().unwrap_or(0);
    for drawn in distributions::TABLE {
        println!("{:<88} {:?}\n    {}", drawn.what, drawn.shape, drawn.basis);
    }
    let (mut documents, mut missed) = (Vec::new(), Vec::new());
    for (name, hold) in [("held", Hold::Current), ("not held", Hold::None)] {
        let tally = run(rigs, first_seed, hold);
        println!(
            "\nposition {name}, {} calibrators, six checks each\n",
            tally.rigs
        );
        print(&tally);
        documents.push(document(name, &tally));
        missed.extend(misses(name, hold, &tally));
    }
    print_unsound(rigs.min(300), first_seed);
    missed.extend(by_the_image(image_rigs, first_seed)?);
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, serde_json::to_string_pretty(&documents)?)?;
    }
    match missed.is_empty() {
        true => Ok(()),
        false => Err(format!("outside of the aims:\n  {}", missed.join("\n  ")).into()),
    }
}

/// Where the tally is outside of what a check is to reach, by three deviations of chance and more.
fn misses(name: &str, hold: Hold, tally: &Tally) -> Vec<String> {
    let mut missed = Vec::new();
    let mut expect = |what: String, holds: bool| {
        if !holds {
            missed.push(format!("position {name}: {what}"));
        }
    };
    let chance = |share: f64, of: u64| 3.0 * (share * (1.0 - share) / of.max(1) as f64).sqrt();
    for band in BANDS_HZ {
        let inside = tally.inside_percent(band) / 100.0;
        let slack = chance(0.95, tally.rigs);
        expect(
            format!("{band:?} Hz inside {inside:.4}"),
            (0.935 - slack..=0.98 + slack).contains(&inside),
        );
    }
    for (index, hz) in FREQUENCIES_HZ.into_iter().enumerate() {
        let most = match hold {
            Hold::Current if hz <= 315.0 => 0.005,
            Hold::Current => 0.01,
            Hold::None if (50.0..=315.0).contains(&hz) => 0.007,
            Hold::None => continue,
        };
        let expanded = tally.expanded_quantile_rel(index, 0.95);
        expect(format!("U at {hz} Hz {expanded:.4}"), expanded <= most);
    }
    for (against, [alarms, found]) in [
        ("baseline", tally.baseline),
        ("certificate", tally.certificate),
    ] {
        let share = |(count, of): (u64, u64)| count as f64 / of.max(1) as f64;
        let [alarmed, seen] = [share(alarms), share(found)];
        expect(
            format!("{alarmed:.4} suspected by the {against}"),
            alarmed <= 0.01 + chance(0.01, alarms.1),
        );
        expect(
            format!("{seen:.4} found by the {against}"),
            seen >= 0.99 - chance(0.01, found.1),
        );
    }
    missed
}

/// Whole checks by the shipping image on the emulated board, and where one takes too long or its U is wrong.
fn by_the_image(rigs: u64, first_seed: u64) -> Result<Vec<String>, Fault> {
    let (mut inside, mut of, mut longest) = (0, 0, Duration::ZERO);
    for rig in 0..rigs {
        let draw = linear(first_seed + rig);
        let mut rigged = Rigged::with_rig(&draw.rig)?;
        rigged.certify_reference(&true_certificate(&draw.rig))?;
        let begun = rigged.board().elapsed();
        let found = by_image(&mut rigged, &draw, &plan(0.050, draw.stated.mass_kg).levels)?;
        longest = longest.max(rigged.board().elapsed() - begun);
        for point in &found.points {
            let truth = oracle::reference_sensitivity(&draw.rig, point.frequency_hz).norm();
            let off = (point.sensitivity_v_per_ms2 / truth - 1.0).abs();
            inside += u64::from(off <= point.expanded_uncertainty_rel);
            of += 1;
        }
    }
    if rigs > 0 {
        println!(
            "\nby the image, {rigs} calibrators: {inside} of {of} points inside; {:.0} s of instrument time at most",
            longest.as_secs_f64()
        );
    }
    let late = longest > LONGEST;
    Ok(late
        .then(|| format!("a check took {longest:?}"))
        .into_iter()
        .collect())
}

/// Prints each fault of a check, and the answers to it.
fn print_unsound(rigs: u64, first_seed: u64) {
    println!(
        "\n{rigs} checks each of sound references, %\n\n{:<42} {:>8} {:>8} {:>9} {:>9}",
        "", "refused", "changed", "within U", "beyond U"
    );
    for unsound in &UNSOUND {
        let tally = spoilt(unsound, rigs, first_seed);
        let percent = |count: u64| 100.0 * count as f64 / rigs.max(1) as f64;
        println!(
            "{:<42} {:>8.1} {:>8.1} {:>9.1} {:>9.1}",
            unsound.what,
            percent(tally.refused),
            percent(tally.told_as_change),
            percent(tally.within_u),
            percent(tally.beyond_u)
        );
    }
}

fn print(tally: &Tally) {
    println!(
        "{:>8} {:>10} {:>10} {:>10} {:>14}",
        "f/Hz", "inside/%", "U/%", "U of 95 %", "phase inside/%"
    );
    for (index, hz) in FREQUENCIES_HZ.iter().enumerate() {
        let (inside, of) = tally.inside[index];
        let (turned, of_turned) = tally.phase_inside[index];
        println!(
            "{hz:>8} {:>10.2} {:>10.3} {:>10.3} {:>14.2}",
            100.0 * inside as f64 / of as f64,
            100.0 * tally.expanded_quantile_rel(index, 0.5),
            100.0 * tally.expanded_quantile_rel(index, 0.95),
            100.0 * turned as f64 / of_turned as f64,
        );
    }
    for band in BANDS_HZ {
        println!(
            "{:>4} Hz to {:>4} Hz inside {:.2} %",
            band[0],
            band[1],
            tally.inside_percent(band)
        );
    }
    let percent = |(found, of): (u64, u64)| 100.0 * found as f64 / of as f64;
    for (against, by, [alarms, found]) in [
        ("baseline", CHANGE_REL, tally.baseline),
        ("certificate", DIFFERENCE_REL, tally.certificate),
    ] {
        println!(
            "against the {against}: {:.2} % found of {} changes of {:.2} %, {:.2} % of {} sound ones suspected",
            percent(found),
            found.1,
            100.0 * by,
            percent(alarms),
            alarms.1,
        );
    }
    println!(
        "sound against the baseline: error over u {:.2} r.m.s.",
        spread(tally)
    );
    println!("\nreference {:<36} {ANSWERS:?}", "");
    for (truth, said) in TRUTHS.iter().zip(tally.answers) {
        println!("{truth:<46} {said:?}");
    }
    println!(
        "refused: {} of {} checks",
        tally.refused.len(),
        6 * tally.rigs
    );
    for (seed, why) in tally.refused.iter().take(10) {
        println!("  calibrator {seed}: {why}");
    }
}

fn spread(tally: &Tally) -> f64 {
    (tally.baseline_chi2 / tally.baseline[0].1.max(1) as f64).sqrt()
}

fn document(name: &str, tally: &Tally) -> serde_json::Value {
    let points = FREQUENCIES_HZ.iter().enumerate().map(|(index, hz)| {
        serde_json::json!({
            "frequency_hz": hz,
            "inside": tally.inside[index].0,
            "of": tally.inside[index].1,
            "expanded_uncertainty_median_rel": tally.expanded_quantile_rel(index, 0.5),
            "expanded_uncertainty_of_95_rel": tally.expanded_quantile_rel(index, 0.95),
        })
    });
    serde_json::json!({
        "position": name,
        "rigs": tally.rigs,
        "refused": tally.refused.len(),
        "points": points.collect::<Vec<_>>(),
        "baseline_suspected": tally.baseline[0],
        "baseline_found": tally.baseline[1],
        "certificate_suspected": tally.certificate[0],
        "certificate_found": tally.certificate[1],
        "error_over_standard_rms": spread(tally),
        "truths": TRUTHS,
        "answers": ANSWERS,
        "said": tally.answers,
    })
}
