//! Defaults of a user: `config.toml` in the folder of settings of this user.
//!
//! Whatever is said otherwise goes before it: on the command line, in the environment, in a file of the job.

use crate::{Error, Result};
use calib_certificate::Language;
use calib_certificate::decision::Tolerance;
use calib_files::{file, text};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Keys that may be set, for messages.
const KEYS: &str = "device, level, tolerance, operator, language and key may be set";

/// Defaults of a user.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Config {
    /// The calibrator, as `--device` takes it.
    pub device: Option<String>,
    /// Set acceleration of points that state none, m/s2 r.m.s.
    #[serde(rename = "level")]
    pub level_rms_ms2: Option<f32>,
    /// Tolerance of sensors that are added, as `--tolerance` takes it.
    pub tolerance: Option<String>,
    /// Who calibrates.
    pub operator: Option<String>,
    /// Language of certificates.
    pub language: Option<Language>,
    /// The laboratory's key, a PKCS#12 file: what is given out is signed.
    pub key: Option<PathBuf>,
}

/// Where it is: `CALIB_CONFIG`, else `calib/config.toml` in the user's folder of settings.
pub fn path() -> PathBuf {
    if let Some(path) = std::env::var_os("CALIB_CONFIG") {
        return PathBuf::from(path);
    }
    let folder = dirs::config_dir().unwrap_or_else(|| PathBuf::from("."));
    folder.join("calib").join("config.toml")
}

impl Config {
    /// Reads the file; without one nothing is set.
    ///
    /// # Errors
    /// The file cannot be read, has a key that is none, or a value that cannot be.
    pub fn load(path: &Path) -> Result<Self> {
        match path.exists() {
            true => Self::parse(path, &text::read(path)?),
            false => Ok(Self::default()),
        }
    }

    fn parse(path: &Path, content: &str) -> Result<Self> {
        let config: Self = text::parse_toml(path, content, KEYS)?;
        let wrong = |problem: String| {
            Error::input(
                path.display().to_string(),
                problem,
                "`calib config` sets it",
            )
        };
        if let Some(level) = config.level_rms_ms2
            && !(level.is_finite() && level > 0.0)
        {
            return Err(wrong(format!(
                "level = {level}: is to be a number above 0 m/s2"
            )));
        }
        let tolerance = config.tolerance.as_ref();
        match tolerance.map(|text| text.parse::<Tolerance>()) {
            Some(Err(problem)) => return Err(wrong(format!("tolerance: {problem}"))),
            Some(Ok(tolerance)) if tolerance.repeats() => {
                return Err(wrong(format!("tolerance: {}", calib_logbook::TWICE)));
            }
            _ => (),
        }
        Ok(config)
    }
}

/// Sets `key` to `value`, or to nothing, in the file, which keeps everything else.
///
/// # Errors
/// The file would not be one that [`Config::load`] reads, or cannot be written.
pub fn set(path: &Path, key: &str, value: Option<&str>) -> Result<()> {
    let mut table = table(path)?;
    match value {
        Some(value) => table.insert(key.to_owned(), typed(key, value)?),
        None => table.remove(key),
    };
    let after = table.to_string();
    Config::parse(path, &after)?;
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    }
    Ok(file::replace(path, after.as_bytes())?)
}

fn table(path: &Path) -> Result<toml::Table> {
    match path.exists() {
        true => Ok(text::parse_toml(path, &text::read(path)?, KEYS)?),
        false => Ok(toml::Table::new()),
    }
}

/// Everything that is set, as text.
///
/// # Errors
/// As [`Config::load`].
pub fn shown(path: &Path) -> Result<BTreeMap<String, String>> {
    Config::load(path)?;
    let as_text = |value: toml::Value| match value {
        toml::Value::String(text) => text,
        other => other.to_string(),
    };
    Ok(table(path)?
        .into_iter()
        .map(|(key, value)| (key, as_text(value)))
        .collect())
}

/// A level is a number, a key a file wherever one works; what is none is left to be complained of as text.
fn typed(key: &str, value: &str) -> Result<toml::Value> {
    Ok(match (key, value.parse()) {
        ("level", Ok(number)) => toml::Value::Float(number),
        ("key", _) => {
            let path = Path::new(value);
            let whole = std::path::absolute(path).map_err(|e| Error::file("find", path, e))?;
            toml::Value::String(whole.to_string_lossy().into_owned())
        }
        _ => toml::Value::String(value.to_owned()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_set_is_read_again_and_what_cannot_be_is_refused_and_changes_nothing() -> Result<()> {
        let folder = tempfile::tempdir().map_err(|e| Error::file("create", Path::new("."), e))?;
        let path = folder.path().join("calib/config.toml");
        assert_eq!(Config::load(&path)?, Config::default());
        for (key, value) in [
            ("device", "tcp:127.0.0.1:5025"),
            ("level", "5"),
            ("tolerance", "-5/+10:nominal"),
            ("operator", "N. \"N.\" N."),
            ("language", "de"),
            ("key", "/keys/seal.p12"),
        ] {
            set(&path, key, Some(value))?;
        }
        let all = Config {
            device: Some("tcp:127.0.0.1:5025".into()),
            level_rms_ms2: Some(5.0),
            tolerance: Some("-5/+10:nominal".into()),
            operator: Some("N. \"N.\" N.".into()),
            language: Some(Language::De),
            key: Some("/keys/seal.p12".into()),
        };
        assert_eq!(Config::load(&path)?, all);
        for (key, value) in [
            ("level", "0"),
            ("level", "nan"),
            ("level", "much"),
            ("tolerance", "some"),
            ("language", "fr"),
            ("levle", "5"),
        ] {
            let error = set(&path, key, Some(value)).expect_err(key);
            assert_eq!(error.exit_code(), 6, "{key} = {value}: {error}");
            assert_eq!(Config::load(&path)?, all, "{key} = {value}");
        }
        set(&path, "level", None)?;
        assert_eq!(Config::load(&path)?.level_rms_ms2, None);
        Ok(())
    }
}
