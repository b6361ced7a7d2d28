//! `calib gap effects`: the library.

use super::super::Context;
use super::misuse::refused;
use calib_effects::{Entry, Of, effects};
use calib_gap::check_name;
use calib_host::Result;
use clap::Args;
use std::fmt::Write;

/// `calib gap effects`.
#[derive(Debug, Args)]
pub(crate) struct Effects {
    /// One effect; without it all are listed.
    name: Option<String>,
}

impl Effects {
    /// Prints the list, or one description.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let wanted = |entry: &&Entry| self.name.as_deref().is_none_or(|name| name == entry.id);
        let list: Vec<&Entry> = effects().filter(wanted).collect();
        if let (Some(name), []) = (&self.name, list.as_slice()) {
            check_name(name).map_err(refused)?;
        }
        let one = self.name.is_some();
        context.print(&list, || {
            let mut text = String::new();
            for entry in &list {
                let place = match entry.of {
                    Of::Oscillator => "oscillator",
                    Of::Calibrator | Of::Fault => entry.stage.name(),
                };
                let _ = writeln!(text, "{:<24} {place:<13} {}", entry.id, entry.formula);
                if one {
                    describe(&mut text, entry);
                }
            }
            text.trim_end().to_owned()
        })
    }
}

fn describe(text: &mut String, entry: &Entry) {
    for p in entry.parameters {
        let (name, unit, [lowest, highest]) = (p.name, p.unit, p.simulated);
        let _ = writeln!(text, "  {name:<26} {unit:<10} {lowest:e} .. {highest:e}");
    }
    let list = |names: &[&str]| match names {
        [] => "nothing".to_owned(),
        some => some.join(", "),
    };
    let _ = writeln!(text, "  shows in       {}", list(entry.columns));
    let _ = writeln!(text, "  confused with  {}", list(entry.confused_with));
    let _ = writeln!(text, "  told apart by  {}", entry.separate_by);
    if !entry.identifiable {
        let _ = writeln!(
            text,
            "  never named    it is the measurand, or shared with it"
        );
    }
}
