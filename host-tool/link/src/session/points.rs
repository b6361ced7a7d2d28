//! Point lists from files: TOML or CSV, with errors that name file and line.
//!
//! ```toml
//! acceleration_rms_ms2 = 10          # for every point that states none
//! frequencies_hz = [20, 40, 80, 160]
//!
//! [[point]]
//! frequency_hz = 1000
//! acceleration_rms_ms2 = 50
//! ```
//!
//! The list as CSV; the second column may be empty or missing:
//!
//! ```csv
//! frequency_hz,acceleration_rms_ms2
//! 20,
//! 1000,50
//! ```

use calib_core::point::PointSpec;
use calib_files::{Error, Result, text};
use calib_protocol::record::MAX_POINTS;
use serde::Deserialize;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;

/// The default list (20 Hz to 10 kHz) at another level, m/s2 r.m.s.
pub fn default_points(level_rms_ms2: f32) -> Vec<PointSpec> {
    let list = calib_core::points::default_points();
    let at_level = |point: &PointSpec| PointSpec {
        acceleration_rms_ms2: level_rms_ms2,
        ..*point
    };
    list.iter().map(at_level).collect()
}

/// Reads a point list. `level_rms_ms2` is the set acceleration of points that
/// state none, m/s2 r.m.s.; a level in the file goes before it.
///
/// # Errors
/// [`Error::File`] and [`Error::Input`] with file, line and the way out.
pub fn read_points(path: &Path, level_rms_ms2: f32) -> Result<Vec<PointSpec>> {
    let text = text::read(path)?;
    let source = Source { path, text: &text };
    let extension = path.extension().and_then(|extension| extension.to_str());
    let points = match extension.map(str::to_lowercase).as_deref() {
        Some("csv" | "txt") => from_csv(&source, level_rms_ms2),
        Some("toml") => from_toml(&source, level_rms_ms2),
        _ => Err(Error::input(
            path.display().to_string(),
            "a point list is a .toml or a .csv file",
            "docs/host-tool.md shows both",
        )),
    }?;
    source.expect_room_for(points.len())?;
    match points.is_empty() {
        true => Err(source.error(0, "holds no point", "add at least one frequency")),
        false => Ok(points),
    }
}

/// A file and its text, for errors that name a line.
struct Source<'a> {
    path: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    /// An error at a line; line 0 is the file as a whole.
    fn error(&self, line: u64, problem: impl Into<String>, hint: &str) -> Error {
        let path = self.path.display();
        let place = match line {
            0 => path.to_string(),
            line => format!("{path}:{line}"),
        };
        Error::input(place, problem, hint)
    }

    fn line_of(&self, span: Range<usize>) -> u64 {
        text::line_at(self.text.as_bytes(), span.start) as u64
    }

    /// Refuses more points than a run has.
    fn expect_room_for(&self, count: usize) -> Result<()> {
        match count > MAX_POINTS {
            false => Ok(()),
            true => Err(self.error(
                0,
                format!("holds {count} points, a run has {MAX_POINTS} at most"),
                "split the list",
            )),
        }
    }

    /// A positive, finite value that f32 can hold.
    fn positive(&self, line: u64, name: &str, value: f64) -> Result<f32> {
        let narrow = value as f32;
        if narrow.is_finite() && narrow > 0.0 {
            return Ok(narrow);
        }
        Err(self.error(
            line,
            format!("{name} = {value} is no positive number"),
            "frequencies are in Hz, accelerations in m/s2 r.m.s.",
        ))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointFile {
    acceleration_rms_ms2: Option<Spanned<f64>>,
    #[serde(default)]
    frequencies_hz: Vec<Spanned<f64>>,
    #[serde(default)]
    point: Vec<PointEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointEntry {
    frequency_hz: Spanned<f64>,
    acceleration_rms_ms2: Option<Spanned<f64>>,
}

fn from_toml(source: &Source<'_>, level_rms_ms2: f32) -> Result<Vec<PointSpec>> {
    let hint = "docs/host-tool.md shows a point list";
    let file: PointFile = text::parse_toml(source.path, source.text, hint)?;
    // Before the line of each is looked up, which takes time where they are millions.
    source.expect_room_for(file.frequencies_hz.len() + file.point.len())?;
    let value = |name, spanned: &Spanned<f64>| {
        source.positive(source.line_of(spanned.span()), name, *spanned.get_ref())
    };
    let level = |stated: &Option<Spanned<f64>>, otherwise| match stated {
        Some(stated) => value("acceleration_rms_ms2", stated),
        None => Ok(otherwise),
    };
    let common = level(&file.acceleration_rms_ms2, level_rms_ms2)?;
    let mut points = Vec::new();
    for frequency in &file.frequencies_hz {
        points.push(PointSpec {
            frequency_hz: value("frequencies_hz", frequency)?,
            acceleration_rms_ms2: common,
        });
    }
    for entry in &file.point {
        points.push(PointSpec {
            frequency_hz: value("frequency_hz", &entry.frequency_hz)?,
            acceleration_rms_ms2: level(&entry.acceleration_rms_ms2, common)?,
        });
    }
    Ok(points)
}

/// Separated by commas, or, as spreadsheets write it where the comma is the decimal sign, by
/// semicolons.
fn from_csv(source: &Source<'_>, level_rms_ms2: f32) -> Result<Vec<PointSpec>> {
    // The reader counts a line of CR and LF apart where one is skipped.
    let text = source.text.replace("\r\n", "\n");
    let source = &Source {
        text: &text,
        ..*source
    };
    let german = source
        .text
        .lines()
        .next()
        .is_some_and(|line| line.contains(';'));
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(if german { b';' } else { b',' })
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .flexible(true)
        .from_reader(source.text.as_bytes());
    let columns = columns(source, &mut reader)?;
    let width = reader.headers().map_or(0, csv::StringRecord::len);
    let mut points = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|error| csv_error(source, &error))?;
        let line = row.position().map_or(0, csv::Position::line);
        if row.len() > width {
            return Err(source.error(
                line,
                format!("has {} cells, the first line has {width}", row.len()),
                "write 12.5, not 12,5",
            ));
        }
        let cell = |column: Option<usize>, name: &str| -> Result<Option<f32>> {
            let text = column.and_then(|column| row.get(column)).unwrap_or("");
            if text.is_empty() {
                return Ok(None);
            }
            let number = match german {
                true => text.replace(',', "."),
                false => text.to_owned(),
            };
            let value: f64 = number.parse().map_err(|_| {
                source.error(
                    line,
                    format!("{name} = \"{text}\" is no number"),
                    "write 12.5, with a point",
                )
            })?;
            source.positive(line, name, value).map(Some)
        };
        points.push(PointSpec {
            frequency_hz: cell(Some(columns.0), "frequency_hz")?
                .ok_or_else(|| source.error(line, "frequency_hz is missing", ""))?,
            acceleration_rms_ms2: cell(columns.1, "acceleration_rms_ms2")?.unwrap_or(level_rms_ms2),
        });
    }
    Ok(points)
}

/// Positions of the two columns.
fn columns(source: &Source<'_>, reader: &mut csv::Reader<&[u8]>) -> Result<(usize, Option<usize>)> {
    let (mut frequency, mut acceleration) = (None, None);
    let header = reader
        .headers()
        .map_err(|error| csv_error(source, &error))?;
    for (position, name) in header.iter().enumerate() {
        match name {
            "frequency_hz" => frequency = Some(position),
            "acceleration_rms_ms2" => acceleration = Some(position),
            _ => {
                return Err(source.error(
                    1,
                    format!("unknown column \"{name}\""),
                    "the first line is: frequency_hz,acceleration_rms_ms2",
                ));
            }
        }
    }
    let missing = || {
        source.error(
            1,
            "there is no column frequency_hz",
            "the first line is: frequency_hz,acceleration_rms_ms2",
        )
    };
    Ok((frequency.ok_or_else(missing)?, acceleration))
}

fn csv_error(source: &Source<'_>, error: &csv::Error) -> Error {
    let line = error.position().map_or(0, csv::Position::line);
    source.error(line, error.to_string(), "")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(name: &str, text: &str) -> Result<Vec<PointSpec>> {
        let directory = tempfile::tempdir().expect("directory");
        let path = directory.path().join(name);
        std::fs::write(&path, text).expect("written");
        read_points(&path, 10.0)
    }

    fn pairs(points: Vec<PointSpec>) -> Vec<(f32, f32)> {
        points
            .iter()
            .map(|point| (point.frequency_hz, point.acceleration_rms_ms2))
            .collect()
    }

    #[test]
    fn both_forms_say_the_same() {
        let toml = "acceleration_rms_ms2 = 5\nfrequencies_hz = [20, 31.5]\n\
                    [[point]]\nfrequency_hz = 1e3\nacceleration_rms_ms2 = 50\n";
        let csv =
            "\u{feff}frequency_hz, acceleration_rms_ms2\r\n# low\r\n20,5\r\n31.5,5\r\n1e3,50\r\n";
        let wanted = vec![(20.0, 5.0), (31.5, 5.0), (1000.0, 50.0)];
        assert_eq!(pairs(read("a.toml", toml).expect("toml")), wanted);
        assert_eq!(pairs(read("a.CSV", csv).expect("csv")), wanted);
    }

    #[test]
    fn a_list_of_a_german_spreadsheet_is_read() {
        let csv = "frequency_hz;acceleration_rms_ms2\r\n160,5;10\r\n1000;2,5\r\n";
        let wanted = [(160.5, 10.0), (1000.0, 2.5)];
        assert_eq!(pairs(read("a.csv", csv).expect("csv")), wanted);
    }

    #[test]
    fn lines_are_counted_alike_whatever_ends_them() {
        let csv = "frequency_hz\n# low\n\n20\nx\n";
        for text in [csv.to_owned(), csv.replace('\n', "\r\n")] {
            let error = read("a.csv", &text).expect_err("x").to_string();
            assert!(error.contains("a.csv:5"), "{error}");
        }
    }

    #[test]
    fn a_missing_level_is_the_given_one() {
        assert_eq!(
            pairs(read("a.csv", "frequency_hz\n160\n").expect("one column")),
            [(160.0, 10.0)]
        );
        assert_eq!(
            pairs(read("a.toml", "frequencies_hz = [160]").expect("no level")),
            [(160.0, 10.0)]
        );
    }

    #[test]
    fn every_mistake_names_its_line() {
        for (name, text, place, problem) in [
            (
                "a.toml",
                "\nfrequencies_hz = [20,\n -4]",
                "a.toml:3",
                "-4 is no positive",
            ),
            ("a.toml", "frequencies_hz = [20", "a.toml:1", ""),
            (
                "a.toml",
                "frequencies_hz = []\nlevel = 3",
                "a.toml:2",
                "unknown field `level`",
            ),
            (
                "a.toml",
                "[[point]]\nfrequency_hz = \"x\"",
                "a.toml:2",
                "invalid type",
            ),
            ("a.toml", "frequencies_hz = [nan]", "a.toml:1", "NaN"),
            (
                "a.toml",
                "frequencies_hz = [1e60]",
                "a.toml:1",
                "is no positive",
            ),
            ("a.toml", "", "a.toml", "no point"),
            ("a.csv", "frequency_hz\n20\n12,5\n", "a.csv:3", "2 cells"),
            (
                "a.csv",
                "frequency_hz\n20\nabc\n",
                "a.csv:3",
                "\"abc\" is no number",
            ),
            (
                "a.csv",
                "frequency_hz,acceleration_rms_ms2\n20,0\n",
                "a.csv:2",
                "= 0 is no",
            ),
            (
                "a.csv",
                "frequency_hz,acceleration_rms_ms2\n,5\n",
                "a.csv:2",
                "missing",
            ),
            (
                "a.csv",
                "hertz\n20\n",
                "a.csv:1",
                "unknown column \"hertz\"",
            ),
            ("a.csv", "", "a.csv:1", "no column"),
            ("a.ods", "", "a.ods", "a .toml or a .csv"),
        ] {
            let error = read(name, text).expect_err(text);
            let message = error.to_string();
            let wanted = format!("{place}: ");
            assert!(
                message.contains(&wanted) && message.contains(problem),
                "{message}"
            );
            assert_eq!(error.exit_code(), 6);
        }
    }

    #[test]
    fn more_points_than_a_run_holds_are_refused() {
        let text = format!("frequency_hz\n{}", "20\n".repeat(MAX_POINTS + 1));
        assert!(
            read("a.csv", &text)
                .expect_err("too many")
                .to_string()
                .contains("201")
        );
        let text = format!("frequency_hz\n{}", "20\n".repeat(MAX_POINTS));
        assert_eq!(read("a.csv", &text).expect("just fits").len(), MAX_POINTS);
    }

    #[test]
    fn a_list_of_a_million_points_is_refused_at_once() {
        // A million times the position of a line in five megabytes took hours.
        let text = format!("frequencies_hz = [{}]", "100,\n".repeat(1_000_000));
        let error = read("a.toml", &text).expect_err("too many");
        assert!(
            error.to_string().contains("holds 1000000 points"),
            "{error}"
        );
    }

    proptest! {
        #[test]
        fn any_text_is_survived(text in "\\PC{0,200}", toml: bool) {
            let _ = read(if toml { "a.toml" } else { "a.csv" }, &text);
        }
    }
}
