//! Statements of a certificate that no record knows: laboratory, customer, place.
//!
//! A TOML file holds them. A laboratory keeps one with its own address, texts
//! and decision rule, a job may add a second one; what the second states wins.
//! Every item is optional: what is missing is printed as missing.
//!
//! ```toml
//! language = "de"
//! [laboratory]
//! name = "Example Calibration"
//! street = "Hauptstr. 1"
//! postcode = "38116"
//! city = "Braunschweig"
//! country = "DE"
//! [conditions]
//! ambient_temperature_c = 22.8
//! [decision]
//! specification = "api670"
//! rule = "guard_band"
//! ```

use super::words::Language;
use crate::decision;
use crate::kind::{SensorKind, Specified};
use calib_files::{Error, Result, text};
use jiff::civil::Date;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Everything a TOML file can state.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Particulars {
    /// Language of the certificate.
    pub language: Option<Language>,
    /// Who calibrates (ISO/IEC 17025 7.8.2.1 b).
    pub laboratory: Contact,
    /// For whom (7.8.2.1 e).
    pub customer: Contact,
    /// Item under calibration (7.8.2.1 g, h).
    pub item: Item,
    /// When, where and by whom (7.8.2.1 c, i, j, n, o).
    pub calibration: Calibration,
    /// Ambient conditions (ISO 16063-21 clause 7 a, b).
    pub conditions: Conditions,
    /// Mounting technique (clause 7 c).
    pub mounting: Mounting,
    /// Settings of the object's amplifier (clause 7 d).
    pub amplifier: Amplifier,
    /// Calibration of the calibrator itself (clause 7).
    pub calibrator: Calibrator,
    /// Other instruments that were used (clause 7).
    pub equipment: Vec<Equipment>,
    /// Tolerance and decision rule (7.8.6).
    pub decision: Option<decision::Request>,
    /// How a check by reciprocity extends the interval between calibrations of the reference.
    pub reference_interval: Option<IntervalRule>,
    /// Texts of the laboratory.
    pub texts: Texts,
    /// Layout of the printed certificate.
    pub layout: Layout,
    /// Times of the records around the one that is certified; from the logbook.
    #[serde(skip)]
    pub around: Around,
    /// The latest check of the reference by reciprocity until the calibration; from the logbook.
    #[serde(skip)]
    pub reference_check: Option<ReferenceCheck>,
}

/// A laboratory or a customer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Contact {
    /// Name.
    pub name: Option<String>,
    /// Street and number.
    pub street: Option<String>,
    /// Post code.
    pub postcode: Option<String>,
    /// City.
    pub city: Option<String>,
    /// Country, two letters of ISO 3166-1.
    pub country: Option<String>,
    /// Mail address.
    pub email: Option<String>,
    /// Telephone number.
    pub phone: Option<String>,
    /// Accreditation or code of the laboratory.
    pub accreditation: Option<String>,
    /// Where the laboratory answers whether a certificate is true, an address; it stands in the square of the
    /// printed certificate.
    pub verify_at: Option<String>,
}

/// The object of calibration, beside what the record states.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Item {
    /// Description: "accelerometer with IEPE electronics".
    pub description: Option<String>,
    /// Manufacturer and model, if the record does not state them.
    pub model: Option<String>,
    /// Serial number, if the record does not state it.
    pub serial: Option<String>,
    /// Unit its sensitivity is stated in, with the gain or burden before the input: its kind.
    pub unit: Option<SensorKind>,
    /// Identification by the customer.
    pub customer_id: Option<String>,
    /// Mounted resonance by its data sheet, Hz; else that of the logbook.
    pub mounted_resonance_hz: Option<f64>,
    /// Condition on arrival.
    pub condition: Option<String>,
    /// Day of receipt.
    #[serde(deserialize_with = "day")]
    pub received: Option<Date>,
}

/// When, where, by whom, and how it deviated from the method.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Calibration {
    /// Number of the certificate; else it is made of instrument and record.
    pub number: Option<String>,
    /// Day of calibration, if the record does not state it.
    #[serde(deserialize_with = "day")]
    pub date: Option<Date>,
    /// Day of issue; never assumed.
    #[serde(deserialize_with = "day")]
    pub issued: Option<Date>,
    /// Where it was done.
    pub place: Option<Place>,
    /// The place in words.
    pub place_text: Option<String>,
    /// Who authorises the certificate.
    pub approved_by: Option<String>,
    /// Additions to, deviations and exclusions from the method.
    pub deviations: Option<String>,
    /// Measurand.
    pub measurand: Option<Measurand>,
    /// Why a reference was used although its calibration was overdue.
    pub overdue_reference: Option<String>,
    /// Why the certificate is issued although a check standard was out of control or overdue.
    pub check_override: Option<String>,
    /// Correlation of the reference's calibration between two frequencies, 0 to 1, by its certificate;
    /// 1 where nothing is stated.
    pub reference_correlation: Option<f64>,
    /// Whether the object was adjusted (7.8.4.1 d).
    pub adjustment: Option<Adjustment>,
    /// The certificate that this one takes the place of (7.8.8.3).
    pub replaces: Option<Amendment>,
}

/// A certificate that is replaced as a whole, with the reason (7.8.8).
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Amendment {
    /// Number of the certificate that is replaced.
    pub certificate: String,
    /// Mistake on it.
    pub reason: String,
}

/// Object whose sensitivity is stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measurand {
    /// The transducer and its conditioner as one chain.
    WithConditioner,
    /// The transducer alone: the conditioner's gain is taken out by the settings.
    WithoutConditioner,
}

/// Where a calibration was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// In the laboratory.
    Laboratory,
    /// At the customer.
    Customer,
    /// Elsewhere.
    Other,
}

/// Whether results are from before or after an adjustment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Adjustment {
    /// Before an adjustment that follows.
    AsFound,
    /// After an adjustment.
    AsLeft,
    /// The object has nothing to adjust: reported only.
    ReportedOnly,
    /// It could be adjusted and was not.
    NotAdjusted,
}

/// Ambient conditions.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Conditions {
    /// Ambient air temperature, degrees Celsius.
    pub ambient_temperature_c: Option<f64>,
    /// Estimated difference of the transducer from it, K.
    pub temperature_difference_k: Option<f64>,
    /// Uncertainty of the temperature told, half-width, K; 1 where nobody states one, 3 where only the air's is told.
    pub temperature_uncertainty_k: Option<f64>,
    /// Relative humidity, %.
    pub humidity_percent: Option<f64>,
}

/// Mounting technique.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mounting {
    /// Material of the mounting surface.
    pub surface: Option<String>,
    /// Mounting torque, N m.
    pub torque_n_m: Option<f64>,
    /// Adhesive used.
    pub adhesive: Option<String>,
    /// Mounting components and adapters.
    pub adapters: Option<String>,
    /// Oil, grease or wax.
    pub lubricant: Option<String>,
    /// How the cable was fixed.
    pub cable: Option<String>,
    /// Vertical or horizontal.
    pub orientation: Option<String>,
    /// Relative shift of the mounted resonance by torque, grease and face, %, half-width; 10 where nobody states one.
    pub resonance_spread_percent: Option<f64>,
}

/// Settings of the object's conditioner, if it has any.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Amplifier {
    /// Description.
    pub description: Option<String>,
    /// Gain, with its unit in words.
    pub gain: Option<String>,
    /// Lower cut-off frequency, Hz.
    pub lower_cutoff_hz: Option<f64>,
    /// Upper cut-off frequency, Hz.
    pub upper_cutoff_hz: Option<f64>,
    /// Slope of the filters, dB per octave.
    pub slope_db_per_octave: Option<f64>,
}

/// Calibration of the calibrator's own electronics.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Calibrator {
    /// Its certificate.
    pub certificate: Option<String>,
    /// Day its calibration is due.
    #[serde(deserialize_with = "day")]
    pub due: Option<Date>,
}

/// An instrument that was used beside calibrator and reference.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equipment {
    /// Name: "thermometer".
    pub name: String,
    /// Serial or inventory number.
    pub serial: String,
    /// Its certificate.
    #[serde(default)]
    pub certificate: Option<String>,
    /// Day its calibration is due.
    #[serde(default, deserialize_with = "day")]
    pub due: Option<Date>,
}

/// Texts of the laboratory.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Texts {
    /// Printed above the results, one paragraph each.
    pub introduction: Vec<String>,
    /// Printed at the end, one paragraph each.
    pub closing: Vec<String>,
    /// Statement of traceability.
    pub traceability: Option<String>,
}

/// Layout of the printed certificate.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Layout {
    /// Picture printed beside the laboratory (SVG, PNG or JPEG); the path is
    /// relative to the TOML file.
    pub logo: Option<PathBuf>,
    /// Typst template instead of the built-in one, relative likewise.
    pub template: Option<PathBuf>,
    /// Columns of the table over frequency; all when empty.
    pub columns: Vec<String>,
}

impl Particulars {
    /// Reads TOML files; what a later one states wins. `columns` are those a table can have.
    ///
    /// # Errors
    /// [`Error::File`] when one cannot be read, [`Error::Input`] with file and
    /// line when it is not TOML or states something unknown.
    pub(super) fn read_knowing(paths: &[PathBuf], columns: &[&str]) -> Result<Self> {
        let mut merged = toml::Table::new();
        for path in paths {
            let text = text::read(path)?;
            // The types are checked per file, so that an error has a line.
            let own: Self = text::parse_toml(path, &text, HINT)?;
            let mut table: toml::Table = text::parse_toml(path, &text, HINT)?;
            own.layout.check(path, columns)?;
            own.laboratory.check("laboratory", path)?;
            own.customer.check("customer", path)?;
            own.plausible(&path.display().to_string())?;
            // A laboratory may state its rule alone.
            let stated = own.decision.as_ref().filter(|request| !request.is_open());
            if let Some(Err(problem)) = stated.map(decision::Request::check) {
                let place = path.display().to_string();
                return Err(Error::input(place, problem, "correct the [decision] part"));
            }
            anchor(&mut table, path);
            merge(&mut merged, table);
        }
        let hint = "the files together state what none of them states alone";
        merged
            .try_into()
            .map_err(|e: toml::de::Error| Error::input("particulars", e.message(), hint))
    }
}

/// Entries of a logbook about a device under test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Known {
    /// Its kind; none where nobody said.
    pub kind: Option<SensorKind>,
    /// Nominal sensitivity.
    pub nominal: Option<Specified>,
    /// Its tolerance.
    pub tolerance: Option<decision::Tolerance>,
    /// Mounted resonance by its data sheet, Hz.
    pub resonance_hz: Option<f64>,
    /// Sensitivities of its last calibration before this one, as they were measured: Hz and V/(m/s2).
    pub last: Vec<(f64, f64)>,
}

impl Particulars {
    /// Completes the decision for a device under test by what is known of it, and
    /// checks it. The tolerance stated in a file wins; the rule is that of the file,
    /// also for the sensor's own tolerance.
    ///
    /// # Errors
    /// [`Error::Input`] when nobody stated the nominal sensitivity it needs, or sensors of its kind cannot be judged so.
    pub fn for_device(&mut self, known: &Known) -> Result<()> {
        let stated = self.item.mounted_resonance_hz;
        self.item.mounted_resonance_hz = stated.or(known.resonance_hz);
        // A file for the whole laboratory may state the unit its accelerometers are shown in.
        if let (Some(stated), Some(own)) = (self.item.unit, known.kind) {
            let hint = "leave `unit` out of the file, or register the sensor with its own unit";
            let fits = own.shown_in(stated.unit());
            fits.map_err(|problem| Error::input("particulars", problem, hint))?;
        }
        self.item.unit = self.item.unit.or(known.kind);
        let kind = self.kind();
        if let Some(tolerance) = &known.tolerance {
            tolerance.complete(self.decision.get_or_insert_default());
        }
        let Some(request) = self.decision.as_mut().filter(|request| !request.is_open()) else {
            return Ok(());
        };
        if let Some(nominal) = known.nominal {
            request.know_nominal(nominal);
        }
        let of_kind = |&(hz, v_per_ms2)| (hz, kind.of_v_per_ms2(v_per_ms2, hz));
        request.last = known.last.iter().map(of_kind).collect();
        let hint = "state it there, or the sensor's with `calib sensors add`";
        let built = request.fits(kind).and_then(|()| request.build());
        built.map_err(|problem| Error::input("particulars", problem, hint))?;
        Ok(())
    }
}

/// Items by their names in the file, each with what is stated and its range.
macro_rules! ranges {
    ($of:ident: $($part:ident.$item:ident in $least:expr, $most:expr;)+) => {
        [$((concat!(stringify!($part), ".", stringify!($item)), $of.$part.$item, $least, $most)),+]
    };
}

impl Particulars {
    /// Kind of the object; an accelerometer with a voltage where nobody said.
    pub fn kind(&self) -> SensorKind {
        self.item.unit.unwrap_or_default()
    }

    /// Checks that conditions can be: nobody calibrates at -300 degC or 400 % of humidity. `place` names
    /// where they were stated.
    ///
    /// # Errors
    /// [`Error::Input`] with the item, its value and its range.
    pub fn plausible(&self, place: &str) -> Result<()> {
        let ranges = ranges! { self:
            conditions.ambient_temperature_c in -60.0, 125.0;
            conditions.temperature_difference_k in -200.0, 500.0;
            conditions.temperature_uncertainty_k in 0.1, 20.0;
            conditions.humidity_percent in 0.0, 100.0;
            calibration.reference_correlation in 0.0, 1.0;
            mounting.torque_n_m in 0.0, 100.0;
            mounting.resonance_spread_percent in 0.0, 50.0;
            item.mounted_resonance_hz in 500.0, 1.0e6;
            amplifier.lower_cutoff_hz in 0.0, 1.0e6;
            amplifier.upper_cutoff_hz in 0.0, 1.0e9;
            amplifier.slope_db_per_octave in 0.0, 200.0;
        };
        if let Some(problem) = self.reference_interval.and_then(|rule| rule.problem()) {
            return Err(Error::input(
                place,
                problem,
                "docs/certificate.md says what each item means",
            ));
        }
        for (item, stated, least, most) in ranges {
            if let Some(value) = stated
                && !(least..=most).contains(&value)
            {
                let problem = format!("{item}: {value} is not between {least} and {most}");
                let hint = "the unit is in the item's name";
                return Err(Error::input(place, problem, hint));
            }
        }
        Ok(())
    }
}

impl Contact {
    fn check(&self, part: &str, path: &Path) -> Result<()> {
        let code = |text: &str| text.len() == 2 && text.bytes().all(|b| b.is_ascii_uppercase());
        match &self.country {
            Some(country) if !code(country) => Err(Error::input(
                path.display().to_string(),
                format!("{part}.country: '{country}' is no code of ISO 3166-1"),
                "two capital letters, such as DE",
            )),
            _ => Ok(()),
        }
    }
}

impl Layout {
    fn check(&self, path: &Path, known: &[&str]) -> Result<()> {
        let unknown = self
            .columns
            .iter()
            .find(|name| !known.contains(&name.as_str()));
        unknown.map_or(Ok(()), |name| {
            let problem = format!("layout.columns: there is no column '{name}'");
            Err(Error::input(
                path.display().to_string(),
                problem,
                format!("columns are {}", known.join(", ")),
            ))
        })
    }
}

/// A day as TOML date or as text: 2026-11-20 or "2026-11-20".
fn day<'de, D: serde::Deserializer<'de>>(
    deserializer: D,
) -> std::result::Result<Option<Date>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Day {
        Toml(toml::value::Datetime),
        Text(String),
    }
    let text = match Day::deserialize(deserializer)? {
        Day::Toml(date) => date.to_string(),
        Day::Text(text) => text,
    };
    let wrong = |_| serde::de::Error::custom(format!("'{text}' is no day such as 2026-11-20"));
    text.parse().map(Some).map_err(wrong)
}

const HINT: &str = "docs/certificate.md lists every item of this file";

/// Paths of a file are relative to it.
fn anchor(table: &mut toml::Table, path: &Path) {
    let folder = path.parent().unwrap_or(Path::new(""));
    let Some(layout) = table.get_mut("layout").and_then(toml::Value::as_table_mut) else {
        return;
    };
    for key in ["logo", "template"] {
        if let Some(toml::Value::String(name)) = layout.get_mut(key) {
            *name = folder.join(&*name).to_string_lossy().into_owned();
        }
    }
}

fn merge(into: &mut toml::Table, from: toml::Table) {
    for (key, value) in from {
        match (into.get_mut(&key), value) {
            (Some(toml::Value::Table(old)), toml::Value::Table(new)) => merge(old, new),
            (_, value) => {
                into.insert(key, value);
            }
        }
    }
}

/// Times of the records of the same instrument that are next to one and have a time, s since 1970-01-01 UTC.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Around {
    /// Of the last one with a lower running number.
    pub before_unix_time_s: Option<u64>,
    /// Of the first one with a higher running number.
    pub behind_unix_time_s: Option<u64>,
}

/// A check of the reference on site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceCheck {
    /// Its day.
    pub day: Date,
    /// By turning it over in gravity; else by reciprocity.
    pub by_gravity: bool,
    /// Compared with a check after the reference's calibration; else with its certificate.
    pub since_baseline: bool,
    /// By how much the reference changed, or differs, relative.
    pub change_rel: f64,
    /// Expanded uncertainty of that, k = 2.
    pub expanded_rel: f64,
    /// It is more than 99 % of sound references show.
    pub significant: bool,
}

/// The laboratory's rule: how a check by reciprocity extends the interval between calibrations of the reference.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct IntervalRule {
    /// Days after the due day that the reference may still be used.
    pub extend_days: u32,
    /// Greatest age of the check on the day of the calibration, days.
    pub checked_within_days: u32,
    /// Greatest change since the baseline, its expanded uncertainty added, %.
    pub largest_change_percent: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(folder: &Path, name: &str, text: &str) -> PathBuf {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("written");
        path
    }

    #[test]
    fn a_job_adds_to_the_laboratory_and_wins() {
        let folder = tempfile::tempdir().expect("folder");
        let house = "[laboratory]\nname = 'Lab'\ncity = 'Town'\n[layout]\nlogo = 'logo.svg'\n";
        let job =
            "language = 'de'\n[laboratory]\ncity = 'Field'\n[item]\nreceived = '2026-11-20'\n";
        let files = [
            file(folder.path(), "lab.toml", house),
            file(folder.path(), "job.toml", job),
        ];
        let read = Particulars::read(&files).expect("valid");
        assert_eq!(read.laboratory.name.as_deref(), Some("Lab"));
        assert_eq!(read.laboratory.city.as_deref(), Some("Field"));
        assert_eq!(read.language, Some(Language::De));
        assert_eq!(read.item.received, Some(jiff::civil::date(2026, 11, 20)));
        assert_eq!(read.layout.logo, Some(folder.path().join("logo.svg")));
    }

    #[test]
    fn a_misspelt_item_is_named_with_its_line() {
        let folder = tempfile::tempdir().expect("folder");
        let path = file(
            folder.path(),
            "lab.toml",
            "[laboratory]\nname = 'Lab'\ncitty = 'Town'\n",
        );
        let error = Particulars::read(&[path]).expect_err("citty");
        assert!(error.to_string().contains("lab.toml:3"), "{error}");
        assert!(error.to_string().contains("citty"), "{error}");
    }

    #[test]
    fn a_country_that_is_no_code_is_named() {
        let folder = tempfile::tempdir().expect("folder");
        for (part, country) in [("laboratory", "Germany"), ("customer", "de")] {
            let text = format!("[{part}]\ncountry = '{country}'\n");
            let path = file(folder.path(), "lab.toml", &text);
            let error = Particulars::read(&[path]).expect_err(country);
            let wanted = format!("{part}.country: '{country}'");
            assert!(error.to_string().contains(&wanted), "{error}");
        }
    }

    #[test]
    fn an_unknown_column_is_named() {
        let folder = tempfile::tempdir().expect("folder");
        let path = file(
            folder.path(),
            "lab.toml",
            "[layout]\ncolumns = ['frequency', 'colour']\n",
        );
        let error = Particulars::read(&[path]).expect_err("colour");
        assert!(error.to_string().contains("colour"), "{error}");
    }

    #[test]
    fn the_documented_file_states_everything_there_is() {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/certificate/laboratory.toml");
        let read = Particulars::read(&[path]).expect("valid");
        let record = calib_record::sample::record(&[160.0]);
        let certificate = crate::Certificate::from_record(&record, &read);
        let keys: Vec<&str> = certificate.remarks.iter().map(|r| r.key).collect();
        assert_eq!(keys, ["temperature_told"]);
        let entries = certificate.sections.iter().flat_map(|s| &s.entries);
        let missing: Vec<_> = entries
            .filter(|e| e.value.is_none())
            .map(|e| e.key)
            .collect();
        assert_eq!(missing, [""; 0]);
        assert!(read.layout.logo.is_some_and(|logo| logo.exists()));
    }
}
