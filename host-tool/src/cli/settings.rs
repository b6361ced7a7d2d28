//! `calib settings`: what the calibrator knows before it measures.

use super::Context;
use super::hand::Hand;
use calib_core::settings::Settings as InstrumentSettings;
use calib_files::text;
use calib_host::{Error, Result};
use clap::Args;
use std::path::{Path, PathBuf};

/// `calib settings`.
#[derive(Debug, Args)]
#[command(after_help = "\
Edit what `calib settings > mine.toml` printed (limits of the exciter, scales of the inputs,
influence quantities, the calibration table of the reference) and hand it back with
`calib settings --write mine.toml`. All values are SI; phases are in radians.

Settings change only while the button on the instrument is held: each of them enters a result, its
uncertainty or a limit. calib waits until it is held. Each change is logged as a record, with the time and the
operator. No setting passes the ceilings: 42 V, 1415 m/s2, 1.5 m/s, 12.7 mm peak.")]
pub(crate) struct Settings {
    /// Stores the settings of this TOML file in the calibrator; nothing is changed
    /// unless all of them are accepted.
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
    #[command(flatten)]
    hand: Hand,
}

impl Settings {
    /// Prints the settings in force, after writing new ones if asked to.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let new = self.write.as_deref().map(read).transpose()?;
        let mut client = self.hand.connect(context)?;
        client.info()?;
        if let Some(settings) = new {
            self.hand.store(context, &mut client, settings)?;
            context.remark("stored");
        }
        let settings = client.settings()?;
        let text = toml::to_string(&settings).map_err(|error| {
            Error::input("settings", error.to_string(), "report this as a defect")
        })?;
        context.print(&settings, || text)
    }
}

fn read(path: &Path) -> Result<InstrumentSettings> {
    let text = text::read(path)?;
    let hint = "`calib settings` prints a file of the right form; the factor of a special \
                distribution in files of before is 1 / divisor";
    let settings: InstrumentSettings = text::parse_toml(path, &text, hint)?;
    // The instrument refuses them too, but its answer does not say which.
    settings.validate().map_err(|impossible| {
        let hint = "nothing was changed; mend it, and write the file again";
        Error::input(path.display().to_string(), impossible.to_string(), hint)
    })?;
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files that `calib settings` printed before wrote them with capitals.
    #[test]
    fn values_spelled_as_before_are_read() {
        let settings = InstrumentSettings::field_calibrator();
        let text = toml::to_string(&settings).expect("printed");
        let mut before = text.clone();
        for (now, then) in [
            ("\"rectangular\"", "\"Rectangular\""),
            ("\"calibrator\"", "\"Calibrator\""),
            ("\"example2\"", "\"Example2\""),
        ] {
            assert!(before.contains(now), "{now} in {before}");
            before = before.replace(now, then);
        }
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("before.toml");
        std::fs::write(&file, before).expect("written");
        assert_eq!(read(&file).expect("read"), settings);
    }
}
