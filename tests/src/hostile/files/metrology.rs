//! Tables and TOML files of the verbs of docs/metrology.

use super::read_or_refused;
use calib_core::settings::Example;
use calib_files::Result;
use calib_metrology::input::Source;
use calib_metrology::{budget, identify, linking, phase5347, record, sensitivity, shock};
use std::path::Path;

/// Choices of the input's first byte, by the name its files have.
const KINDS: [&str; 7] = [
    "budget.toml",
    "link.toml",
    "doe.csv",
    "phase.toml",
    "readings.csv",
    "points.csv",
    "record.csv",
];

/// A file of one of the kinds: refused, or evaluated and reported.
pub fn metrology(data: &[u8]) {
    let Some((kind, text)) = data.split_first() else {
        return;
    };
    let Ok(text) = std::str::from_utf8(text) else {
        return;
    };
    let path = Path::new(KINDS[usize::from(*kind) % KINDS.len()]);
    let source = Source::from_text(path, text);
    let reported = source.and_then(|source| evaluate(path, source));
    if let Some(report) = read_or_refused(path, reported) {
        assert!(!report.is_empty());
    }
}

fn evaluate(path: &Path, source: Source) -> Result<String> {
    match path.to_str().unwrap_or_default() {
        "budget.toml" => {
            let budget = budget::parse(&source)?;
            Ok(budget::report(&budget::evaluate(&budget)))
        }
        "link.toml" => {
            let file = linking::parse(&source)?;
            Ok(linking::link_report(&file, &file.link_all(), true))
        }
        "doe.csv" => {
            let table = linking::read_table(source)?;
            Ok(linking::doe_report(&linking::judge(&table.degrees)))
        }
        "phase.toml" => {
            let file = phase5347::parse(&source)?;
            let points = file.points.iter();
            let results: Vec<_> = points
                .map(|point| phase5347::evaluate(point, &file.limits))
                .collect();
            Ok(phase5347::report(&results, &phase5347::remarks(&file)))
        }
        "readings.csv" => {
            let readings = sensitivity::parse(source, sensitivity::Quantity::Acceleration)?;
            let points = sensitivity::evaluate(&readings, Example::Example2);
            Ok(sensitivity::report(&points, "V/(m/s2)", &readings.remarks))
        }
        "points.csv" => {
            let points = identify::read(source)?;
            let weighting = match points.has_uncertainties {
                true => identify::Weighting::Covariance,
                false => identify::Weighting::None,
            };
            let found = identify::identify(&points, weighting, 0.05);
            let found = found.map_err(|error| error.of_file(path))?;
            Ok(identify::report(&found, None))
        }
        _ => identify_shock(path, source),
    }
}

fn identify_shock(path: &Path, source: Source) -> Result<String> {
    let choice = shock::Choice {
        from_hz: None,
        to_hz: None,
        u0: None,
        prewarp: true,
        input_delay_s: 0.0,
    };
    let record = record::read(source)?;
    let found = shock::identify(&record, &choice);
    Ok(shock::report(&found.map_err(|error| error.of_file(path))?))
}
