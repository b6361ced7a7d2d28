//! Rig files: reading and writing.

use std::path::Path;

use super::Rig;
use super::error::RigError;

/// The rig of the demo, as text.
pub const STANDARD_RIG_TOML: &str = include_str!("../../rigs/default.toml");

impl Rig {
    /// The rig of the demo.
    pub fn standard() -> Self {
        // Note(unwrap): a text of this crate, held by `the_standard_rig_is_valid`.
        #[expect(clippy::unwrap_used, reason = "a constant of this crate, tested")]
        Self::parse(STANDARD_RIG_TOML, "twin/rigs/default.toml").unwrap()
    }

    /// Reads a rig file.
    ///
    /// # Errors
    /// The file cannot be read, is no TOML of this shape (an unknown, missing or repeated key, with
    /// its line), or a value lies outside of its range.
    pub fn load(path: &Path) -> Result<Self, RigError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|source| RigError::Unreadable {
            file: file.clone(),
            source,
        })?;
        Self::parse(&text, &file)
    }

    /// Reads a rig from `text`; `file` is for messages.
    ///
    /// # Errors
    /// As [`Rig::load`].
    pub fn parse(text: &str, file: &str) -> Result<Self, RigError> {
        let rig: Self = toml::from_str(text).map_err(|source| RigError::Malformed {
            file: file.to_owned(),
            source: Box::new(source),
        })?;
        rig.validate(file)?;
        Ok(rig)
    }

    /// The rig as the text of a rig file.
    ///
    /// # Errors
    /// A value TOML cannot hold, which a validated rig does not have.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_rig_is_valid() {
        assert!(Rig::parse(STANDARD_RIG_TOML, "default.toml").is_ok());
    }

    #[test]
    fn a_rig_survives_its_own_file() {
        let rig = Rig::standard();
        let text = rig.to_toml().expect("plain numbers");
        assert_eq!(Rig::parse(&text, "copy").expect("own text"), rig);
    }

    #[test]
    fn an_unknown_key_is_named_with_its_line() {
        let text = STANDARD_RIG_TOML.replace("payload_kg", "payload_g");
        let message = Rig::parse(&text, "my.toml")
            .expect_err("refused")
            .to_string();
        assert!(
            message.contains("my.toml") && message.contains("payload_g"),
            "{message}"
        );
    }

    #[test]
    fn an_impossible_value_is_named_with_its_range() {
        for (from, to, name) in [
            (
                "moving_mass_kg = 0.050",
                "moving_mass_kg = -0.05",
                "exciter.moving_mass_kg",
            ),
            (
                "moving_mass_kg = 0.050",
                "moving_mass_kg = nan",
                "exciter.moving_mass_kg",
            ),
            ("order = 6", "order = 7", "converter.anti_alias_order"),
            (
                "high_pass_hz = 0.16",
                "high_pass_hz = 2e5",
                "dut.high_pass_hz",
            ),
        ] {
            let text = STANDARD_RIG_TOML.replace(from, to);
            let message = Rig::parse(&text, "my.toml").expect_err(name).to_string();
            assert!(
                message.contains(name) && message.contains("my.toml"),
                "{message}"
            );
        }
    }

    #[test]
    fn effects_and_surroundings_are_read_and_refused_by_name() {
        let effects = "effects = [\"suspension_cubic=k3_n_per_m3:1e7\", \"mains_pickup\"]\n";
        let tilted = "\n[surroundings]\ntilt_deg = 90.0\n";
        let text = format!("{effects}{STANDARD_RIG_TOML}{tilted}");
        let rig = Rig::parse(&text, "my.toml").expect("valid");
        assert_eq!(rig.effects.len(), 2);
        assert_eq!(rig.model().coil.cubic_n_per_m3, 1e7);
        let copy = Rig::parse(&rig.to_toml().expect("plain"), "copy").expect("own text");
        assert_eq!(copy, rig);
        for (from, to, hint) in [
            ("mains_pickup", "mains_pick", "mains_pickup"),
            ("k3_n_per_m3:1e7", "k3_n_per_m3:1e70", "must be from"),
            ("mains_pickup", "crosstalk=quadrature:0.1", "quadrature"),
            ("tilt_deg = 90", "tilt_deg = 900", "surroundings.tilt_deg"),
        ] {
            let message = Rig::parse(&text.replace(from, to), "my.toml")
                .expect_err(to)
                .to_string();
            assert!(
                message.contains(hint) && message.contains("my.toml"),
                "{message}"
            );
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic() {
        for end in 0..STANDARD_RIG_TOML.len() {
            let _ = Rig::parse(&STANDARD_RIG_TOML[..end], "cut");
        }
    }
}
