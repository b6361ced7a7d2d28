//! Beliefs of a simulation about a rig, read from any file that states them.

use crate::emulated::rig_file;
use crate::{Error, Result};
use calib_files::text;
use calib_twin::dataset::{Nominal, NominalOscillator, Quantity};
use calib_twin::rig::Rig;
use serde::Deserialize;
use std::path::Path;

/// Name that stands for the rig of the format's description.
pub const STANDARD: &str = "standard";
/// Name that stands for an electronic oscillator at 68 Hz.
pub const STANDARD_OSCILLATOR: &str = "oscillator";

/// A rig as a simulation believes it to be.
#[derive(Clone, Debug)]
pub enum Believed {
    /// A calibrator, measured at sine points.
    Calibrator(Box<Nominal>),
    /// An oscillator, recorded over time.
    Oscillator(NominalOscillator),
}

#[derive(Deserialize)]
struct Head {
    kind: Option<String>,
    oscillator: Option<OscillatorTable>,
}

#[derive(Deserialize)]
struct OscillatorTable {
    rho: Option<Quantity>,
    resonance_hz: Option<Quantity>,
    delta: Option<Quantity>,
}

impl Believed {
    /// Reads `rig.toml` of a dataset, the folder of one, a rig file of the
    /// emulated calibrator, or takes one of the two names above.
    ///
    /// # Errors
    /// [`Error::File`] and [`Error::Input`], with key and remedy.
    pub fn load(rig: &Path) -> Result<Self> {
        if rig == Path::new(STANDARD) {
            return Ok(Self::Calibrator(Box::new(Nominal::standard())));
        }
        if rig == Path::new(STANDARD_OSCILLATOR) {
            return Ok(Self::Oscillator(NominalOscillator::standard()));
        }
        let path = if rig.is_dir() {
            rig.join("rig.toml")
        } else {
            rig.to_owned()
        };
        Self::parse(&text::read(&path)?, &path)
    }

    fn parse(text: &str, path: &Path) -> Result<Self> {
        let hint = "docs/gap.md shows a rig.toml; `standard` and `oscillator` are built in";
        let file = &path.display().to_string();
        let unusable = |problem: String| Error::input(file, problem, hint);
        let head: Head = text::parse_toml(path, text, hint)?;
        match head.kind.as_deref() {
            Some("calibrator") => Nominal::parse(text, file)
                .map(|nominal| Self::Calibrator(Box::new(nominal)))
                .map_err(|e| unusable(e.to_string())),
            Some("oscillator") => oscillator(head.oscillator).map_err(unusable),
            Some(other) => Err(unusable(format!(
                "kind = \"{other}\" is neither \"calibrator\" nor \"oscillator\""
            ))),
            None => {
                let rig = rig_file::parse(path, text)?;
                Ok(Self::Calibrator(Box::new(nominal_of(&rig))))
            }
        }
    }
}

fn oscillator(table: Option<OscillatorTable>) -> Result<Believed, String> {
    let need = |name: &str, quantity: Option<Quantity>| {
        let quantity = quantity.ok_or(format!("oscillator.{name} is needed to simulate one"))?;
        if quantity.value > 0.0 && (0.0..0.3 * quantity.value).contains(&quantity.u) {
            Ok(quantity)
        } else {
            Err(format!(
                "oscillator.{name}: {quantity:?} needs a positive value and u below 30 % of it"
            ))
        }
    };
    let table = table.ok_or("the table [oscillator] is needed to simulate one")?;
    Ok(Believed::Oscillator(NominalOscillator {
        rho: need("rho", table.rho)?,
        resonance_hz: need("resonance_hz", table.resonance_hz)?,
        delta: need("delta", table.delta)?,
    }))
}

/// Beliefs about a simulated rig whose file states values without
/// uncertainties: those of the format's description, in proportion. Its effects
/// are no belief and are left out.
pub fn nominal_of(rig: &Rig) -> Nominal {
    let mut nominal = Nominal::standard();
    let set = |quantity: &mut Quantity, value: f64| {
        quantity.u *= value / quantity.value;
        quantity.value = value;
    };
    let exciter = &mut nominal.exciter;
    set(&mut exciter.moving_mass_kg, rig.exciter.moving_mass_kg);
    set(
        &mut exciter.stiffness_n_per_m,
        rig.exciter.stiffness_n_per_m,
    );
    set(&mut exciter.damping_ns_per_m, rig.exciter.damping_ns_per_m);
    set(
        &mut exciter.force_factor_n_per_a,
        rig.exciter.force_factor_n_per_a,
    );
    set(
        &mut exciter.coil_resistance_ohm,
        rig.exciter.coil_resistance_ohm,
    );
    set(
        &mut exciter.coil_inductance_h,
        rig.exciter.coil_inductance_h,
    );
    let gain = |s: &calib_twin::rig::Sensing| (s.sensitivity_v_per_ms2 * s.conditioner_gain).abs();
    set(
        &mut nominal.reference.sensitivity_v_per_ms2,
        gain(&rig.reference),
    );
    set(&mut nominal.dut.sensitivity_v_per_ms2, gain(&rig.dut));
    set(
        &mut nominal.digitiser.noise_v,
        rig.reference.noise_rms_v.max(1e-9),
    );
    nominal.digitiser.sample_rate_hz = rig.converter.sample_rate_hz;
    nominal.digitiser.full_scale_v = rig.converter.input_full_scale_peak_v;
    nominal.environment.mains_hz = rig.surroundings.mains_hz;
    nominal
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_twin::rig::STANDARD_RIG_TOML;

    #[test]
    fn every_form_of_a_rig_is_read() {
        let standard = Nominal::standard().to_toml().expect("plain numbers");
        for (text, mass_kg) in [(standard.as_str(), 0.050), (STANDARD_RIG_TOML, 0.050)] {
            match Believed::parse(text, Path::new("rig.toml")).expect(text) {
                Believed::Calibrator(nominal) => {
                    assert_eq!(nominal.exciter.moving_mass_kg.value, mass_kg);
                    // 1 % in the format's description.
                    assert!((nominal.exciter.moving_mass_kg.u - 0.01 * mass_kg).abs() < 1e-12);
                }
                Believed::Oscillator(_) => panic!("a calibrator"),
            }
        }
        let oscillator = "kind = \"oscillator\"\n[oscillator]\nrho = { value = 1.0, u = 0.1 }\n\
                          resonance_hz = { value = 68.0, u = 5.0 }\ndelta = { value = 0.02, u = 0.002 }\n";
        assert!(matches!(
            Believed::parse(oscillator, Path::new("rig.toml")),
            Ok(Believed::Oscillator(_))
        ));
    }

    #[test]
    fn a_contradictory_rig_is_refused_by_name() {
        let standard = Nominal::standard().to_toml().expect("plain numbers");
        for (text, name) in [
            (
                standard.replace("value = 8000.0", "value = -1.0"),
                "stiffness_n_per_m",
            ),
            (standard.replace("calibrator", "shaker"), "shaker"),
            ("kind = \"oscillator\"".to_owned(), "[oscillator]"),
            ("nonsense".to_owned(), "my.toml"),
            (String::new(), "name"),
        ] {
            let error = Believed::parse(&text, Path::new("my.toml")).expect_err(name);
            assert!(error.to_string().contains(name), "{error}");
            assert!(error.to_string().contains("my.toml"), "{error}");
        }
    }
}
