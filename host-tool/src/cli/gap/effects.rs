//! `calib gap effects`: the library.

use super::super::Context;
use super::refused;
use calib_gap::{About, NEVER_IDENTIFIABLE, check_name, effects};
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
        if let Some(name) = &self.name {
            check_name(name).map_err(refused)?;
        }
        let wanted = |id: &str| self.name.as_deref().is_none_or(|n| n == id);
        let list: Vec<&About> = effects().into_iter().filter(|a| wanted(a.id)).collect();
        let one = self.name.is_some();
        context.print(&list, || {
            let mut text = String::new();
            for about in &list {
                if one {
                    describe(&mut text, about)
                } else {
                    line(&mut text, about.id, about.stage.name(), about.formula)
                }
            }
            for (id, stage, formula) in NEVER_IDENTIFIABLE.into_iter().filter(|n| wanted(n.0)) {
                line(&mut text, id, stage.name(), formula);
            }
            text.trim_end().to_owned()
        })
    }
}

fn line(text: &mut String, id: &str, stage: &str, formula: &str) {
    let _ = writeln!(text, "{id:<24} {stage:<13} {formula}");
}

fn describe(text: &mut String, about: &About) {
    line(text, about.id, about.stage.name(), about.formula);
    for p in about.parameters {
        let _ = writeln!(
            text,
            "  {:<26} {:<10} {:e} .. {:e}",
            p.name, p.unit, p.lower, p.upper
        );
    }
    let _ = writeln!(text, "  shows in       {}", about.columns.join(", "));
    let _ = writeln!(text, "  confused with  {}", about.confused_with.join(", "));
    let _ = writeln!(text, "  told apart by  {}", about.separate_by);
}
