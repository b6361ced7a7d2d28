//! `calib gap diagnose`: one answer per dataset.

use super::super::Context;
use super::super::context::{Form, defect};
use super::misuse::{refused, unusable};
use super::progress::Count;
use super::text;
use calib_gap::{Answer, GapError, Options, check_name, diagnose};
use calib_gap_challenge::truth::Manifest;
use calib_host::gap::confirm::confirm;
use calib_host::{Error, Result};
use calib_output::json;
use clap::Args;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

/// Most answers in one report.
const MOST_REPORTED: usize = 100;

/// `calib gap diagnose`.
#[derive(Debug, Args)]
pub(crate) struct Diagnose {
    /// Dataset folders (rig.toml with points.csv or record.csv), or sealed sets; --json gives a list for several, --json-lines one line for each.
    #[arg(required = true, value_name = "DATASET")]
    datasets: Vec<PathBuf>,
    /// Effects that must not be named.
    #[arg(long, value_delimiter = ',', value_name = "EFFECT")]
    without: Vec<String>,
    /// Score on this dataset instead of on held-out rows.
    #[arg(long, value_name = "DATASET")]
    validate: Option<PathBuf>,
    /// Largest number of effects at a time [default: 2, and up to 4 where two leave structure].
    #[arg(long, value_parser = clap::value_parser!(u8).range(0..=4))]
    max_effects: Option<u8>,
    /// Write a self-contained HTML report.
    #[arg(long, value_name = "OUT.html")]
    report: Option<PathBuf>,
    /// Add the most probable cause to the emulated rig, run the shipping firmware on it, and
    /// report the gap between its records and the measured ones (one dataset).
    #[arg(long)]
    confirm: bool,
}

/// A dataset to be diagnosed, with what must not be named in it.
struct Job {
    folder: PathBuf,
    without: Vec<String>,
}

impl Diagnose {
    /// Diagnoses and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        for name in &self.without {
            check_name(name).map_err(refused)?;
        }
        let jobs = self.jobs()?;
        match (jobs.as_slice(), self.datasets.as_slice()) {
            // A set of one is still a set.
            ([job], [folder]) if job.folder == *folder => self.one(context, job),
            _ if self.confirm => Err(Error::usage(
                "--confirm is for one dataset",
                "it takes minutes; name the dataset that matters",
            )),
            _ => self.many(context, &jobs),
        }
    }

    fn jobs(&self) -> Result<Vec<Job>> {
        let mut jobs = Vec::new();
        for folder in &self.datasets {
            match Manifest::find(folder)? {
                Some(manifest) => jobs.extend(manifest.cases.into_iter().map(|case| Job {
                    folder: folder.join(case.name),
                    without: [case.without, self.without.clone()].concat(),
                })),
                None => jobs.push(Job {
                    folder: folder.clone(),
                    without: self.without.clone(),
                }),
            }
        }
        Ok(jobs)
    }

    fn answer(&self, job: &Job) -> Result<Answer, GapError> {
        let options = Options {
            without: job.without.clone(),
            validate: self.validate.clone(),
            most_effects: self.max_effects.map(usize::from),
        };
        diagnose(&job.folder, &options)
    }

    fn one(&self, context: &Context, job: &Job) -> Result<()> {
        let mut answer = self.answer(job).map_err(|e| unusable(&job.folder, e))?;
        if self.confirm {
            answer.confirmation = confirm(&job.folder, &answer)?;
        }
        self.report(std::slice::from_ref(&answer))?;
        context.print(&answer, || text::answer(&answer))
    }

    /// Diagnoses on all cores; each answer is printed as soon as those before it are.
    fn many(&self, context: &Context, jobs: &[Job]) -> Result<()> {
        let count = Count::new(context, "datasets");
        let printer = Mutex::new(Printer::new(
            context,
            self.report.as_ref().map_or(0, |_| MOST_REPORTED),
        ));
        jobs.par_iter().enumerate().try_for_each(|(at, job)| {
            let answer = self.answer(job);
            let mut printer = printer.lock().unwrap_or_else(PoisonError::into_inner);
            printer.take(at, job, answer)?;
            count.show(printer.done, jobs.len());
            Ok::<(), Error>(())
        })?;
        drop(count);
        let printer = printer.into_inner().unwrap_or_else(PoisonError::into_inner);
        self.report(&printer.kept)?;
        if context.form == Form::Json {
            context.print(&printer.list, String::new)?;
        }
        match printer.unusable {
            0 => Ok(()),
            n => Err(Error::input(
                format!("{n} of {} datasets", jobs.len()),
                "could not be used; the answers above say why",
                "repair them, or leave them out",
            )),
        }
    }

    fn report(&self, answers: &[Answer]) -> Result<()> {
        let Some(path) = &self.report else {
            return Ok(());
        };
        let page = calib_gap::report(answers)
            .map_err(|e| Error::input("report", e.to_string(), "leave out --report"))?;
        std::fs::write(path, page).map_err(|e| Error::file("write", path, e))
    }
}

/// Answer for one dataset of several.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
pub(in crate::cli) enum Said {
    /// It was diagnosed.
    Answer(Box<Answer>),
    /// It could not be used.
    Unusable {
        /// Which.
        dataset: Unread,
        /// Why.
        error: String,
    },
}

/// A dataset that could not be read.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Unread {
    /// Its folder.
    path: PathBuf,
}

impl Said {
    fn new(job: &Job, answer: Result<Answer, GapError>) -> Self {
        match answer {
            Ok(answer) => Self::Answer(Box::new(answer)),
            Err(error) => Self::Unusable {
                dataset: Unread {
                    path: job.folder.clone(),
                },
                error: error.to_string(),
            },
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Answer(answer) => format!("{}\n\n", text::answer(answer)),
            Self::Unusable { dataset, error } => {
                format!("{}\n  error: {error}\n\n", dataset.path.display())
            }
        }
    }
}

/// Prints answers in the order of the jobs, or keeps them for one document.
struct Printer<'a> {
    context: &'a Context,
    next: usize,
    done: usize,
    waiting: BTreeMap<usize, Said>,
    kept: Vec<Answer>,
    keep: usize,
    list: Vec<Said>,
    unusable: usize,
}

impl<'a> Printer<'a> {
    /// Keeps the first `keep` answers for a report.
    fn new(context: &'a Context, keep: usize) -> Self {
        Self {
            context,
            next: 0,
            done: 0,
            waiting: BTreeMap::new(),
            kept: Vec::new(),
            keep,
            list: Vec::new(),
            unusable: 0,
        }
    }

    fn take(&mut self, at: usize, job: &Job, answer: Result<Answer, GapError>) -> Result<()> {
        self.done += 1;
        self.unusable += usize::from(answer.is_err());
        if let Ok(answer) = &answer
            && self.kept.len() < self.keep
        {
            self.kept.push(answer.clone());
        }
        self.waiting.insert(at, Said::new(job, answer));
        while let Some(said) = self.waiting.remove(&self.next) {
            self.next += 1;
            let text = match self.context.form {
                Form::Text => said.text(),
                Form::JsonLines => json::line(&said).map_err(defect)?,
                Form::Json => {
                    self.list.push(said);
                    continue;
                }
            };
            // `| head` is no failure, and the rest is not worth the work.
            let put = self.context.sink.put(&text);
            put.map_err(|e| Error::file("write", "standard output".as_ref(), e))?;
        }
        Ok(())
    }
}
