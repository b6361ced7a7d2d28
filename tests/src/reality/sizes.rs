//! The sizes of what goes wrong on a site, and drawing from them: `reality/sizes.toml`.

use calib_effects::{Entry, Of, Parameter, Scale};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::Rng as _;
use serde::Deserialize;
use serde::de::Error as _;

/// The file; what it says is fixed with the program.
const FILE: &str = include_str!("../../reality/sizes.toml");

/// Everything that is drawn.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, bound(deserialize = "L: Deserialize<'de>"))]
pub struct Sizes<L = Law> {
    /// Conditions of every draw.
    pub condition: Vec<Condition>,
    /// Parameters of the effects and faults.
    pub size: Vec<Size<L>>,
    /// Effects that are not drawn.
    pub left_out: Vec<LeftOut>,
}

/// A quantity every draw has.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Condition {
    /// Its name.
    pub name: String,
    /// How large it is.
    pub law: Law,
    /// Source or reason.
    pub why: String,
}

/// A parameter of an effect or a fault, or `warmer_k` of the surroundings.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Size<L = Law> {
    /// Name of the effect.
    pub effect: String,
    /// Name of its parameter.
    pub parameter: String,
    /// How large it is.
    pub law: L,
    /// Source or reason.
    pub why: String,
}

/// Effects of the library that are no errors of a measurement.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LeftOut {
    /// Their names.
    pub effects: Vec<String>,
    /// Why they are left out.
    pub why: String,
}

/// Law a size follows.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Law {
    /// Evenly between two values.
    Even([f64; 2]),
    /// Evenly in the logarithm.
    Log([f64; 2]),
    /// As `Log`, of either sign.
    SignedLog([f64; 2]),
    /// One of these.
    OneOf(Vec<f64>),
}

/// Law of a size as the file states it.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum Stated {
    /// Over the site size of the parameter.
    OnSite(OnSite),
    /// With values of its own: of a time, a choice, or what is no parameter.
    Own(Law),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum OnSite {
    Even,
    Log,
}

/// A number from 0 to 1, 1 excluded.
pub(super) fn unit(random: &mut ChaCha12Rng) -> f64 {
    // 53 bits, as many as an f64 holds.
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

impl Law {
    /// A value.
    pub fn draw(&self, random: &mut ChaCha12Rng) -> f64 {
        let share = unit(random);
        match self {
            Self::Even([from, to]) => from + share * (to - from),
            Self::Log([from, to]) => from * (to / from).powf(share),
            Self::SignedLog([from, to]) => {
                let sign = if unit(random) < 0.5 { -1.0 } else { 1.0 };
                sign * from * (to / from).powf(share)
            }
            Self::OneOf(values) => values[(share * values.len() as f64) as usize],
        }
    }
}

impl Law {
    /// Standard deviation about 0, what a budget takes of a quantity that it does not correct.
    pub fn deviation(&self) -> f64 {
        let squares = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>();
        match self {
            Self::Even([from, to]) => ((from * from + from * to + to * to) / 3.0).sqrt(),
            Self::Log([from, to]) | Self::SignedLog([from, to]) => {
                ((to * to - from * from) / (2.0 * (to / from).ln())).sqrt()
            }
            Self::OneOf(values) => (squares(values) / values.len() as f64).sqrt(),
        }
    }
}

/// Effect or fault of a calibrator.
fn entry(effect: &str) -> Option<&'static Entry> {
    let kinds = [Of::Calibrator, Of::Fault].into_iter();
    kinds
        .filter_map(|of| calib_effects::named(of, effect))
        .next()
}

impl Stated {
    fn of(self, effect: &str, parameter: &str) -> Result<Law, toml::de::Error> {
        let shape = match self {
            Self::Own(law) => return Ok(law),
            Self::OnSite(shape) => shape,
        };
        let known = entry(effect).and_then(|entry| entry.parameter(parameter));
        let Some(Parameter { site, .. }) = known else {
            let unknown = format!("{effect} has no parameter {parameter}");
            return Err(toml::de::Error::custom(unknown));
        };
        Ok(match shape {
            OnSite::Even => Law::Even(*site),
            OnSite::Log => Law::Log(*site),
        })
    }
}

/// Sizes of effects and faults that the file does not name: each parameter with a site size over all of it,
/// in the way that a fit moves it. A new effect is drawn from the day it is there.
fn unsaid(stated: &Sizes<Stated>) -> impl Iterator<Item = Size> + use<> {
    let drawn = stated.size.iter().map(|size| &size.effect);
    let left_out = stated.left_out.iter().flat_map(|out| &out.effects);
    let said: Vec<String> = drawn.chain(left_out).cloned().collect();
    let kinds = [Of::Calibrator, Of::Fault].into_iter();
    let entries = kinds.flat_map(calib_effects::entries);
    let unsaid = entries.filter(move |entry| said.iter().all(|name| name != entry.id));
    unsaid.flat_map(|entry| entry.parameters.iter().map(|one| usual(entry, one)))
}

fn usual(entry: &Entry, parameter: &Parameter) -> Size {
    let law = match parameter.scale {
        _ if parameter.is_switch => Law::OneOf(parameter.site.to_vec()),
        Scale::Linear => Law::Even(parameter.site),
        Scale::Log => Law::Log(parameter.site),
    };
    Size {
        effect: entry.id.to_owned(),
        parameter: parameter.name.to_owned(),
        law,
        why: "site size of the vocabulary".to_owned(),
    }
}

impl Sizes {
    /// The sizes of the file.
    ///
    /// # Errors
    /// An error that says what is wrong with the file, and where.
    pub fn read() -> Result<Self, toml::de::Error> {
        Self::of(FILE)
    }

    fn of(file: &str) -> Result<Self, toml::de::Error> {
        let stated: Sizes<Stated> = toml::from_str(file)?;
        let unsaid = unsaid(&stated);
        let sizes = stated.size.into_iter().map(|size| {
            let law = size.law.of(&size.effect, &size.parameter)?;
            let Size {
                effect,
                parameter,
                why,
                ..
            } = size;
            Ok(Size {
                effect,
                parameter,
                law,
                why,
            })
        });
        Ok(Self {
            condition: stated.condition,
            size: sizes.chain(unsaid.map(Ok)).collect::<Result<_, _>>()?,
            left_out: stated.left_out,
        })
    }

    /// Names of the effects that are drawn, in the order of the file.
    pub fn effects(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for size in &self.size {
            if names.last() != Some(&size.effect.as_str()) {
                names.push(&size.effect);
            }
        }
        names
    }

    /// Standard deviation of what every draw has; 0 for a name the file does not have.
    pub fn deviation(&self, name: &str) -> f64 {
        let condition = self.condition.iter().find(|known| known.name == name);
        condition.map_or(0.0, |condition| condition.law.deviation())
    }

    /// Standard deviation of a parameter of an effect; 0 for one the file does not have.
    pub fn deviation_of(&self, effect: &str, parameter: &str) -> f64 {
        let mut sizes = self.size.iter();
        let size = sizes.find(|size| size.effect == effect && size.parameter == parameter);
        size.map_or(0.0, |size| size.law.deviation())
    }

    /// A value of what every draw has; 0 for a name the file does not have.
    pub fn condition(&self, name: &str, random: &mut ChaCha12Rng) -> f64 {
        let condition = self.condition.iter().find(|known| known.name == name);
        condition.map_or(0.0, |condition| condition.law.draw(random))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 100 000 draws; their mean square is known to 0.4 %, of the widest law to 1 %.
    #[test]
    fn the_deviation_of_a_law_is_that_of_its_draws() {
        use rand_chacha::rand_core::SeedableRng as _;
        let mut random = ChaCha12Rng::seed_from_u64(1);
        for law in [
            Law::Even([-0.0015, 0.0015]),
            Law::Even([1.0, 4.0]),
            Law::Log([0.01, 1.0]),
            Law::SignedLog([0.5, 2.0]),
            Law::OneOf(vec![50.0, 60.0]),
        ] {
            let squares: f64 = (0..100_000).map(|_| law.draw(&mut random).powi(2)).sum();
            let drawn = (squares / 1e5).sqrt();
            assert!((law.deviation() / drawn - 1.0).abs() < 0.02, "{law:?}");
        }
    }

    #[test]
    fn every_effect_and_fault_has_sizes_or_a_reason_why_not() {
        let sizes = Sizes::read().expect("reads");
        let mut said = sizes.effects();
        said.extend(
            sizes
                .left_out
                .iter()
                .flat_map(|out| out.effects.iter().map(String::as_str)),
        );
        said.sort_unstable();
        let kinds = [Of::Calibrator, Of::Fault].into_iter();
        let mut known: Vec<&str> = kinds
            .flat_map(calib_effects::entries)
            .map(|entry| entry.id)
            .collect();
        known.sort_unstable();
        assert_eq!(said, known);
        let reasons = sizes.size.iter().map(|size| &size.why);
        let reasons = reasons.chain(sizes.condition.iter().map(|c| &c.why));
        assert!(reasons.into_iter().all(|why| !why.is_empty()));
    }

    #[test]
    fn an_effect_that_the_file_does_not_name_is_drawn_over_its_site_size() {
        let file = FILE.replace("\"back_emf\"", "\"payload_mass\"");
        assert_ne!(file, FILE);
        let sizes = Sizes::of(&file).map(|sizes| sizes.size);
        // Another effect has no such parameter, and is named.
        let problem = sizes.expect_err("payload_mass has no beta").to_string();
        assert!(
            problem.contains("payload_mass has no parameter beta"),
            "{problem}"
        );
        let entries = FILE
            .split("\n\n")
            .filter(|part| !part.contains("\"back_emf\""));
        let file = entries.collect::<Vec<_>>().join("\n\n");
        let sizes = Sizes::of(&file).expect("reads").size;
        let own: Vec<&Size> = sizes.iter().filter(|s| s.effect == "back_emf").collect();
        let [size] = own[..] else { panic!("{own:?}") };
        let site = entry("back_emf").and_then(|entry| entry.parameter("beta"));
        let site = site.expect("an entry").site;
        assert!(
            matches!(size.law, Law::Even(ends) if ends == site),
            "{size:?}"
        );
    }

    #[test]
    fn every_size_is_of_a_parameter_and_within_its_site_size() {
        for size in Sizes::read().expect("reads").size {
            let entry = entry(&size.effect).unwrap_or_else(|| panic!("{}", size.effect));
            if size.parameter == "warmer_k" {
                continue;
            }
            let parameter = entry.parameter(&size.parameter);
            let parameter = parameter.unwrap_or_else(|| panic!("{size:?}"));
            let ends = match &size.law {
                Law::Even(ends) | Law::Log(ends) => ends.to_vec(),
                Law::SignedLog([from, to]) => vec![-to, -from, *from, *to],
                Law::OneOf(values) => values.clone(),
            };
            // A size of its own may be wider only where the vocabulary has all there is.
            let [lowest, highest] = parameter.site;
            assert!(
                ends.iter().all(|end| (lowest..=highest).contains(end)),
                "{size:?}"
            );
        }
    }
}
