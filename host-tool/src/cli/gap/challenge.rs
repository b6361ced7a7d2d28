//! `calib gap challenge` and `calib gap score`: sealed sets.

use super::super::Context;
use super::progress::Count;
use calib_gap_challenge::draw::nameable;
use calib_gap_challenge::score::{Rates, Score, Share, left_by_substitutes, read_answers, score};
use calib_gap_challenge::strata::Stratum;
use calib_gap_challenge::truth::{MANIFEST, Manifest, Truth};
use calib_gap_challenge::{Design, challenge};
use calib_host::{Error, Result};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// `calib gap challenge`.
#[derive(Debug, Args)]
pub(crate) struct Challenge {
    /// Folder of the set; the truth goes beside it, into OUT-truth.json.
    #[arg(value_name = "OUT")]
    out: PathBuf,
    /// Cases of each kind.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    cases: u32,
    /// Seed the whole set follows from: whoever knows it knows the truth.
    #[arg(long, value_name = "S")]
    seed: u64,
    /// Kinds of cases; all of them where none is given.
    #[arg(long, value_parser = strata_parser(), value_delimiter = ',')]
    strata: Vec<Stratum>,
}

impl Challenge {
    /// Makes and seals the set.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let strata = match self.strata.as_slice() {
            [] => &Stratum::ALL,
            some => some,
        };
        let count = Count::new(context, "datasets");
        let sealed = challenge(
            &self.out,
            &Design {
                strata,
                per_stratum: self.cases as usize,
                effects: nameable(),
                seed: self.seed,
            },
            |done, all| {
                count.show(done, all);
            },
        )?;
        drop(count);
        context.print(&sealed, || {
            format!(
                "{} datasets in {}\ntruth in {}: keep it away from whoever answers\n\
                 SHA-256 of the truth, to be published now: {}\n\
                 answer with  calib gap diagnose {} --json-lines > answers.jsonl\n\
                 open with    calib gap score answers.jsonl {}",
                sealed.cases,
                sealed.folder.display(),
                sealed.truth.display(),
                sealed.truth_sha256,
                sealed.folder.display(),
                sealed.truth.display()
            )
        })
    }
}

/// Kinds of cases by name.
fn strata_parser() -> impl TypedValueParser<Value = Stratum> {
    let values = Stratum::ALL.map(|kind| PossibleValue::new(kind.name()).help(kind.about()));
    PossibleValuesParser::new(values).try_map(|name| {
        let kind = Stratum::ALL.into_iter().find(|kind| kind.name() == name);
        kind.ok_or("no such kind")
    })
}

/// `calib gap score`.
#[derive(Debug, Args)]
pub(crate) struct ScoreVerb {
    /// Answers: what `calib gap diagnose --json-lines` printed.
    answers: PathBuf,
    /// The truth of the set.
    truth: PathBuf,
    /// SHA-256 of the truth as it was published; default: that in the manifest of the set beside it.
    #[arg(long, value_name = "HEX")]
    sha256: Option<String>,
}

impl ScoreVerb {
    /// Opens the truth and prints what the answers are worth.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        if !self.truth.exists() {
            return Err(Error::usage(
                format!("there is no truth {}", self.truth.display()),
                "`calib gap challenge OUT` writes it as OUT-truth.json; it comes second, after the answers",
            ));
        }
        let published = match self.sha256.clone() {
            Some(sum) => sum,
            None => published_beside(&self.truth)?,
        };
        let answers = read_answers(&self.answers)?;
        let truth = Truth::open(&self.truth, &published)?;
        let left_sigma = match Truth::set_of(&self.truth).filter(|folder| folder.is_dir()) {
            Some(folder) => {
                let count = Count::new(context, "substitutes");
                left_by_substitutes(&folder, &answers, &truth, |done, all| count.show(done, all))?
            }
            None => BTreeMap::new(),
        };
        let score = score(&answers, &truth, &left_sigma)?;
        context.print(&score, || table(&score))
    }
}

fn published_beside(truth: &Path) -> Result<String> {
    let missing = || {
        Error::usage(
            format!(
                "{} is not the truth of a set whose {MANIFEST} is beside it",
                truth.display()
            ),
            "answers come first, the truth second; if the set is elsewhere, give the SHA-256 that was published with --sha256",
        )
    };
    let folder = Truth::set_of(truth).ok_or_else(missing)?;
    let manifest = Manifest::find(&folder)?.ok_or_else(missing)?;
    Ok(manifest.truth_sha256)
}

fn percent(share: Option<Share>) -> String {
    share.map_or("-".to_owned(), |s| format!("{:.1}", 100.0 * s.share))
}

/// Meaning of the columns.
const LEGEND: &str = "\
first: the truth leads; covered: it is listed with more than 5 %; alarms: a gap where there is none;
detected: any gap where there is one; wrong: `explained`, by something else; stage: that of the truth is
among the first two of `where`; closed: median share of the gap on held-out rows. Visible: each effect of a
case alone is larger than 6 sigma of the dataset, nominal values, mounting and the measurand fitted; and
where the set is beside the truth, what replaces a withheld effect leaves more than 3 sigma of it.
";

fn table(score: &Score) -> String {
    let mut text = rates("all", &score.all);
    if !score.visible.strata.is_empty() {
        text += &rates("visible", &score.visible);
    }
    text + &sizes(score) + LEGEND.trim_end()
}

/// A row a stratum, and how true the probabilities are.
fn rates(title: &str, rates: &Rates) -> String {
    let number = |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.3}"));
    format!(
        "{}{:<12} calibration error of probability {}, AUROC of none_of_these_p_value {}\n",
        strata(title, rates),
        "",
        number(rates.calibration_error),
        number(rates.auroc)
    )
}

fn strata(title: &str, rates: &Rates) -> String {
    let mut text = format!(
        "{:<12} {:>5} {:>6} {:>8} {:>8} {:>8} {:>6} {:>8} {:>9} {:>6} {:>6}\n",
        format!("{title}, %"),
        "cases",
        "first",
        "covered",
        "alarms",
        "detected",
        "wrong",
        "unexpl.",
        "ambiguous",
        "stage",
        "closed"
    );
    for (name, s) in &rates.strata {
        let closed = s
            .median_closed
            .map_or("-".to_owned(), |c| format!("{:.1}", 100.0 * c));
        let _ = writeln!(
            text,
            "{name:<12} {:>5} {:>6} {:>8} {:>8} {:>8} {:>6} {:>8} {:>9} {:>6} {closed:>6}",
            s.cases,
            percent(s.top_1),
            percent(s.truth_covered),
            percent(s.false_alarm),
            percent(s.detected),
            percent(Some(s.confidently_wrong)),
            percent(Some(s.unexplained)),
            percent(Some(s.ambiguous)),
            percent(s.stage_among_two),
        );
        if s.unanswered > 0 {
            let _ = writeln!(text, "{:<12} {} without an answer", "", s.unanswered);
        }
    }
    text
}

/// A line a size of the gap.
fn sizes(score: &Score) -> String {
    let mut text = String::new();
    for s in &score.sizes {
        let _ = writeln!(
            text,
            "size {:>4.0} .. {:>4.0} sigma: {:>3} cases, detected {:>5} %, named {:>5} %, best possible detection {:.1} %",
            s.from_sigma,
            s.to_sigma,
            s.named.of,
            percent(Some(s.detected)),
            percent(Some(s.named)),
            100.0 * s.best_possible
        );
    }
    text
}
