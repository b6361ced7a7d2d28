//! Sealed sets, one table per stratum: `challenge_bench [STRATUM] [CASES] [SEED]`.
#[path = "../tests/sealed/mod.rs"]
#[allow(dead_code)]
mod sealed;

use calib_gap::{Answer, Options, diagnose};
use rayon::prelude::*;
use sealed::{cases, design, random::Random, rig};

/// Processor time of this thread (Linux), in s.
fn cpu_s() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text
        .split_whitespace()
        .next()
        .and_then(|t| t.parse::<f64>().ok());
    nanoseconds.unwrap_or(0.0) * 1e-9
}

fn folder(tag: &str) -> std::path::PathBuf {
    std::env::temp_dir()
        .join("calib-gap-bench")
        .join(format!("{}-{tag}", std::process::id()))
}

fn case(stratum: &str, index: u64, seed: u64) -> (Vec<&'static str>, Answer, f64) {
    let mut r = Random::new(seed.wrapping_mul(1_000_003) + index);
    let all: Vec<&'static str> = cases::NAMES.iter().chain(&cases::EXTRA).copied().collect();
    let ratio_only = stratum == "ratio";
    let rows = if ratio_only {
        design::ratio_only(&mut r)
    } else {
        design::full(&mut r)
    };
    let mut truth = rig::honest(&mut r);
    let mut names: Vec<&'static str> = Vec::new();
    match stratum {
        "null" => {}
        "ratio" => names.push(all[(index as usize) % 24]),
        "pairs" => {
            while names.len() < 2 {
                let n = all[r.below(all.len())];
                let adc = |s: &str| s.starts_with("adc");
                if !names.contains(&n) && !(adc(n) && names.iter().any(|m| adc(m))) {
                    names.push(n);
                }
            }
        }
        _ => names.push(all[(index as usize) % all.len()]),
    }
    for n in &names {
        cases::add(&mut truth, n, &mut r);
    }
    if stratum == "off2u" {
        for (v, (_, n, u)) in truth.coil.iter_mut().zip(rig::NOMINAL) {
            *v = n + 2.0 * u * r.sign();
        }
        truth.e.clear();
        names.clear();
    }
    let out = rig::write(&truth, &rows, &rig::GOOD, !ratio_only, &mut r);
    let dir = folder(&format!("{stratum}-{index}"));
    std::fs::create_dir_all(&dir).unwrap();
    std::fs::write(dir.join("points.csv"), out.points).unwrap();
    std::fs::write(dir.join("rig.toml"), out.rig).unwrap();
    let mut options = Options::default();
    if stratum == "withheld" {
        options.without = names.iter().map(|n| n.to_string()).collect();
    }
    let start = cpu_s();
    let answer = diagnose(&dir, &options).unwrap();
    let s = cpu_s() - start;
    if std::env::var("KEEP").is_err() {
        std::fs::remove_dir_all(&dir).unwrap();
    }
    (names, answer, s)
}

fn main() {
    let a: Vec<String> = std::env::args().collect();
    let stratum = a.get(1).map_or("single", String::as_str).to_owned();
    let count: u64 = a.get(2).and_then(|s| s.parse().ok()).unwrap_or(84);
    let seed: u64 = a.get(3).and_then(|s| s.parse().ok()).unwrap_or(1);
    let only: Option<u64> = a.get(4).and_then(|s| s.parse().ok());
    let indices: Vec<u64> = only.map_or((0..count).collect(), |i| vec![i]);
    let results: Vec<_> = indices
        .par_iter()
        .map(|&i| (i, case(&stratum, i, seed)))
        .collect();
    let sorted = |v: &[&'static str]| {
        let mut v = v.to_vec();
        v.sort_unstable();
        v
    };
    let (mut top, mut covered, mut verdicts) = (0, 0, std::collections::BTreeMap::new());
    let mut times: Vec<f64> = results.iter().map(|r| r.1.2).collect();
    let mut closed: Vec<f64> = Vec::new();
    let (mut detail, mut stage_ok) = (String::new(), 0);
    for (i, (names, answer, time)) in &results {
        *verdicts.entry(format!("{:?}", answer.verdict)).or_insert(0) += 1;
        let truth = sorted(names);
        let first = answer.causes.first().map_or(vec![], |c| sorted(&c.effects));
        let is_top = first == truth;
        top += usize::from(is_top);
        covered += usize::from(
            answer
                .causes
                .iter()
                .any(|c| sorted(&c.effects) == truth && c.probability > 0.05),
        );
        closed.extend(answer.gap.closed);
        if stratum == "withheld" {
            let stage = calib_gap::effects()
                .iter()
                .find(|e| e.id == names[0])
                .unwrap()
                .stage
                .name();
            stage_ok += usize::from(answer.r#where.iter().take(2).any(|w| w.stage == stage));
        }
        let bad = match stratum.as_str() {
            "null" | "off2u" => answer.verdict != calib_gap::Verdict::NoGap,
            "withheld" => {
                answer.verdict != calib_gap::Verdict::Unexplained
                    || !{
                        let stage = calib_gap::effects()
                            .iter()
                            .find(|e| e.id == names[0])
                            .unwrap()
                            .stage
                            .name();
                        answer.r#where.iter().take(2).any(|w| w.stage == stage)
                    }
            }
            "ratio" => !answer
                .causes
                .iter()
                .any(|c| sorted(&c.effects) == truth && c.probability > 0.05),
            _ => !is_top || answer.verdict != calib_gap::Verdict::Explained,
        };
        if bad || only.is_some() {
            let list: Vec<String> = answer
                .causes
                .iter()
                .take(4)
                .map(|c| format!("{} {:.3}", c.effects.join("+"), c.probability))
                .collect();
            detail += &format!(
                "{i:4} {:?} top={is_top} {:?} p={:.2e} chi {:.2}>{:.2} closed {:?} {:.2}s [{}] where {:?} next {}\n",
                names,
                answer.verdict,
                answer.none_of_these_p_value,
                answer.gap.chi_before,
                answer.gap.chi_after,
                answer.gap.closed.map(|c| (c * 1000.0).round() / 1000.0),
                time,
                list.join(", "),
                answer.r#where.iter().map(|w| w.stage).collect::<Vec<_>>(),
                answer.next_measurement
            );
        }
    }
    times.sort_by(f64::total_cmp);
    closed.sort_by(f64::total_cmp);
    print!("{detail}");
    println!(
        "{stratum}: n={} top1={top} covered={covered} {verdicts:?} stage_ok={stage_ok} closed median {:?} time median {:.2} max {:.2}",
        results.len(),
        closed.get(closed.len() / 2),
        times[times.len() / 2],
        times[times.len() - 1]
    );
}
